//! Separately identifiable parameters: rank of the scaled Jacobian, column by column in the model's
//! order.

use crate::model::prior::Prior;
use crate::model::residuals::Residuals;
use etalon_math::{Factor, factor_at};

/// Maximum distance of a column of the scaled Jacobian from the span of the previous columns at
/// which it is dependent: far above rounding (1e-15), far below the ratio of any useful set of
/// poses (1/condition, about 1/100: Schröer, cited in Nahvi & Hollerbach 1996).
pub const RANK_TOLERANCE: f64 = 1e-9;
/// Fraction of the largest column below which a column is unobservable.
const UNSEEN: f64 = 1e-12;
/// Share of a dependence above which a parameter belongs to the group.
const MEMBER: f64 = 1e-4;
/// Absolute correlation above which a parameter is named together with a parameter with a uselessly
/// large uncertainty.
const CORRELATED: f64 = 0.5;

/// Parameters that are not separately identifiable; the last of them is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Index of the parameter that is held at its nominal value.
    pub held: usize,
    /// Indices of the parameters from which it is not separable; empty if the data do not depend on
    /// `held`.
    pub with: Vec<usize>,
    /// Standard uncertainty (mm, rad, 1) that `held` would have if it were identified, if this is
    /// merely useless: the parameters would be separable with less noise.
    pub useless_uncertainty: Option<f64>,
}

/// Minimum change of the size of the robot, relative to the changes by its single parameters, of a
/// direction that changes the size: far above the rounding of a direction (1e-9).
const RESIZES: f64 = 1e-5;
/// Minimum motion of targets, relative to the motions by the single parameters, of a direction that
/// moves targets.
const MOVES: f64 = 1e-6;
/// Number of poses that is sufficient to find the directions that move targets.
const POSES: usize = 24;

/// Rank and groups at one set of parameter values.
pub(crate) struct Analysis {
    pub groups: Vec<Group>,
    /// Indices of redundant parameters that nominal values determine: with others they change the
    /// size of the robot, or move several branches together, and these data show neither.
    pub by_nominal: Vec<usize>,
}

/// A redundant parameter.
struct Redundant {
    group: Group,
    /// Changes of free parameters, by their column, that the data do not show together; empty if
    /// the data do not depend on the parameter.
    direction: Vec<(usize, f64)>,
}

impl Redundant {
    /// Creates a redundant parameter by its column, with the changes of other columns, divided by
    /// their norms, that leave the residuals as they are if the column changes by 1.
    fn new(problem: &Residuals, norms: &[f64], held: usize, changes: Vec<(usize, f64)>) -> Self {
        let with = changes.iter().filter(|(_, change)| change.abs() > MEMBER).map(|&(j, _)| problem.free[j]).collect();
        let own = Some((held, 1.0)).filter(|_| !changes.is_empty());
        let direction = own.into_iter().chain(changes).map(|(j, change)| (j, change / norms[j])).collect();
        Self { group: Group { held: problem.free[held], with, useless_uncertainty: None }, direction }
    }

    /// `true` if the direction changes the size of the robot. One held length would claim that the
    /// size is known: the nominal values of all lengths state it better, and with its uncertainty.
    fn resizes(&self, problem: &Residuals, values: &[f64]) -> bool {
        let Some(size) = problem.size(values) else { return false };
        let changes: Vec<f64> =
            self.direction.iter().map(|&(column, step)| size.relative[problem.free[column]] * step).collect();
        changes.iter().sum::<f64>().abs() > RESIZES * changes.iter().map(|v| v.abs()).sum::<f64>()
    }
}

impl Redundant {
    /// `true` if the direction moves the targets of two branches by the same amount, and these
    /// targets are observed relative to each other. If one parameter were held, its deviation would
    /// move the other parameters beyond their tolerances.
    fn moves_branches(&self, problem: &Residuals, values: &[f64]) -> bool {
        let (robot, targets) = (problem.robot, problem.related_targets());
        let (n, dimension) = (robot.parameters().len(), robot.dimension());
        let poses: Vec<&[f64]> = problem.joints().filter(|_| !targets.is_empty()).collect();
        let mut jacobian = vec![0.0; dimension * robot.targets().len() * n];
        let (mut moved, mut single) = (0.0, 0.0);
        for joints in poses.iter().step_by(poses.len().div_ceil(POSES).max(1)) {
            robot.jacobian(values, joints, &mut jacobian);
            for row in targets.iter().flat_map(|k| k * dimension..(k + 1) * dimension) {
                let by = |&(column, step): &(usize, f64)| jacobian[row * n + problem.free[column]] * step;
                moved += self.direction.iter().map(by).sum::<f64>().powi(2);
                single += self.direction.iter().map(|change| by(change).powi(2)).sum::<f64>();
            }
        }
        moved > MOVES.powi(2) * single
    }
}

/// Rule for choosing the held one of linearly dependent columns.
#[derive(Clone, Copy)]
enum Choice<'a> {
    /// The last.
    Last,
    /// The one whose nominal value is most accurate relative to its effect: by the standard
    /// uncertainty of each column, infinite without a nominal value.
    BestKnown(&'a [f64]),
}

impl Analysis {
    /// Analyses the Jacobian of `problem`, without nominal values, at `values`. Among dependent
    /// parameters, the one whose tolerance moves the targets least is held, so that the others
    /// hardly change; the last one if tolerances are alike. None is held where the dependent
    /// parameters have nominal values and change the size of the robot, or move branches together.
    pub fn by_prior(problem: &Residuals, values: &[f64]) -> Self {
        let s = |&i: &usize| Prior::TOLERANCES.uncertainty(problem.robot, i).unwrap_or(f64::INFINITY);
        let known: Vec<f64> = problem.free.iter().map(s).collect();
        let redundant = redundant(problem, values, 0.0, Choice::BestKnown(&known));
        let has_nominal = |r: &Redundant| s(&r.group.held).is_finite();
        let is_nominal =
            |r: &Redundant| has_nominal(r) && (r.resizes(problem, values) || r.moves_branches(problem, values));
        let (nominal, held): (Vec<Redundant>, Vec<Redundant>) = redundant.into_iter().partition(is_nominal);
        Self { groups: groups(held), by_nominal: nominal.into_iter().map(|r| r.group.held).collect() }
    }

    /// Analyses the Jacobian of `problem` at `values` (all parameters of the robot), for residuals
    /// of the standard deviation `noise` (in the unit of the residuals; 0 if unknown).
    pub fn at(problem: &Residuals, values: &[f64], noise: f64) -> Self {
        Self { groups: groups(redundant(problem, values, noise, Choice::Last)), by_nominal: Vec::new() }
    }

    /// This analysis of the parameters that no pose separates, with those that are redundant in the
    /// `measured` poses alone: nominal values determine these.
    pub fn with_nominal(self, measured: Self) -> Self {
        let redundant = measured.groups.iter().map(|group| group.held).chain(measured.by_nominal);
        Self { by_nominal: redundant.collect(), ..self }
    }

    /// Indices of the parameters that are held.
    pub fn held(&self) -> Vec<usize> {
        self.groups.iter().map(|g| g.held).collect()
    }
}

/// Redundant parameters, and parameters whose uncertainty would be useless for residuals of the
/// standard deviation `noise`.
fn redundant(problem: &Residuals, values: &[f64], noise: f64, choice: Choice) -> Vec<Redundant> {
    let free = &problem.free;
    let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
    let (mut factor, norms) = factor_at(problem, &x);
    // a column of zeros has the norm 1 and a factor of zeros
    let sizes: Vec<f64> = factor.column_norms().iter().zip(&norms).map(|(size, norm)| size * norm).collect();
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let unseen = |j: usize| sizes[j] <= UNSEEN * largest;
    // columns of the factor: the columns of a block are independent by themselves, the common
    // columns together with all blocks
    let mut columns: Vec<usize> = (0..free.len()).collect();
    let mut all: Vec<Redundant> = Vec::new();
    let new = |held: usize, changes: Vec<(usize, f64)>| Redundant::new(problem, &norms, held, changes);
    for (own, r) in factor.blocks() {
        let found = independent(&r, |j| unseen(own[j]), |_| f64::INFINITY);
        let of_columns = |weights: Vec<(usize, f64)>| weights.into_iter().map(|(k, w)| (own[k], -w)).collect();
        all.extend(found.dependent.into_iter().map(|(j, weights)| new(own[j], of_columns(weights))));
    }
    if !all.is_empty() {
        columns.retain(|&j| all.iter().all(|r| r.group.held != free[j]));
        factor = factor.keeping(&columns);
    }
    let common = factor.common();
    let size = common.len();
    let r: Vec<Vec<f64>> = (0..size).map(|j| (0..size).map(|i| factor.r(i, j)).collect()).collect();
    // effect of a column within its tolerance
    let effect = |k: usize| match choice {
        Choice::Last => f64::INFINITY,
        Choice::BestKnown(known) => norms[columns[common[k]]] * known[columns[common[k]]],
    };
    let found = independent(&r, |k| unseen(columns[common[k]]), effect);
    for (j, weights) in &found.dependent {
        let mut changes: Vec<(usize, f64)> = weights.iter().map(|&(k, weight)| (columns[common[k]], -weight)).collect();
        let mut moved = vec![0.0; size];
        weights.iter().for_each(|&(k, weight)| moved[k] = -weight);
        moved[*j] = 1.0;
        let own = factor.follow(&moved).filter(|_| !unseen(columns[common[*j]])).unwrap_or_default();
        changes.extend(own.into_iter().map(|(k, weight)| (columns[k], weight)));
        all.push(new(columns[common[*j]], changes));
    }
    let mut kept = factor.block_columns();
    kept.extend(found.basis.iter().map(|b| common[b.0]));
    if noise > 0.0 {
        let useless = useless(problem, Selected { factor: &factor, columns: &columns }, &norms, kept, noise);
        all.extend(useless.into_iter().map(|group| Redundant { group, direction: Vec::new() }));
    }
    all
}

fn groups(all: Vec<Redundant>) -> Vec<Group> {
    all.into_iter().map(|redundant| redundant.group).collect()
}

/// Columns that are independent of the previous ones, by their orthonormal basis, and dependent
/// ones, each with its share of the independent ones.
struct Independent {
    basis: Vec<(usize, Vec<f64>)>,
    dependent: Vec<(usize, Vec<(usize, f64)>)>,
}

/// Relative difference below which effects are alike.
const ALIKE: f64 = 1e-6;
/// Distance above which one pass of Gram-Schmidt keeps enough digits to compare effects.
const CLEAR: f64 = 1e-4;

/// Takes columns by their `effect` relative to the previous ones, the largest first, and in their
/// order if the effect is infinite or alike.
fn independent(columns: &[Vec<f64>], unseen: impl Fn(usize) -> bool, effect: impl Fn(usize) -> f64) -> Independent {
    let mut found = Independent { basis: Vec::new(), dependent: Vec::new() };
    let mut left: Vec<usize> = (0..columns.len()).collect();
    let mut rests = columns.to_vec();
    while !left.is_empty() {
        let size = |&j: &usize| match (effect(j), norm(&rests[j])) {
            (effect, _) if effect.is_infinite() => effect,
            (effect, distance) if distance > CLEAR => effect * distance,
            (effect, _) => effect * norm(&split(&columns[j], &found.basis).1),
        };
        let first = left.iter().enumerate().map(|(k, j)| (k, size(j)));
        let first = first.reduce(|a, b| if b.1 > a.1 * (1.0 + ALIKE) { b } else { a }).map_or(0, |first| first.0);
        let j = left.remove(first);
        let column = &columns[j];
        if unseen(j) {
            found.dependent.push((j, Vec::new()));
            continue;
        }
        let (shares, rest) = split(column, &found.basis);
        let distance = norm(&rest);
        if distance > RANK_TOLERANCE {
            let along: Vec<f64> = rest.into_iter().map(|v| v / distance).collect();
            left.iter().filter(|&&k| effect(k).is_finite()).for_each(|&k| _ = remove(&along, &mut rests[k]));
            found.basis.push((j, along));
            continue;
        }
        let weights = weights(&shares, &found.basis, columns);
        let members: Vec<(usize, f64)> = found.basis.iter().map(|b| b.0).zip(weights).collect();
        found.dependent.push((j, members));
    }
    found
}

fn norm(column: &[f64]) -> f64 {
    column.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// Factor of some columns of a Jacobian.
struct Selected<'a> {
    factor: &'a Factor,
    /// Column of the Jacobian of each column of the factor.
    columns: &'a [usize],
}

/// Removes from the columns `kept` of a factor those whose parameters would be less accurate than
/// before, the worst first.
fn useless(problem: &Residuals, selected: Selected, norms: &[f64], mut kept: Vec<usize>, noise: f64) -> Vec<Group> {
    let Selected { factor, columns } = selected;
    let mut groups = Vec::new();
    let parameter = |column: usize| problem.free[columns[column]];
    loop {
        let Some(inverse) = factor.keeping(&kept).inverse_normal() else { return groups };
        let n = kept.len();
        let u = |k: usize| noise * inverse[k * n + k].sqrt() / norms[columns[kept[k]]];
        let excess = |k: usize| u(k) / problem.robot.parameters()[parameter(kept[k])].known_within();
        let worst = (0..n).filter(|&k| excess(k) > 1.0).max_by(|&a, &b| excess(a).total_cmp(&excess(b)));
        let Some(worst) = worst else { return groups };
        let correlation = |k: usize| inverse[worst * n + k] / (inverse[worst * n + worst] * inverse[k * n + k]).sqrt();
        groups.push(Group {
            held: parameter(kept[worst]),
            with: (0..n)
                .filter(|&k| k != worst && correlation(k).abs() > CORRELATED)
                .map(|k| parameter(kept[k]))
                .collect(),
            useless_uncertainty: Some(u(worst)),
        });
        kept.remove(worst);
    }
}

/// Components of `column` along the orthonormal `basis`, and the remainder (Gram-Schmidt, done
/// twice: Giraud et al. 2005).
fn split(column: &[f64], basis: &[(usize, Vec<f64>)]) -> (Vec<f64>, Vec<f64>) {
    let mut rest = column.to_vec();
    let mut shares = vec![0.0; basis.len()];
    for _ in 0..2 {
        basis.iter().zip(&mut shares).for_each(|((_, q), share)| *share += remove(q, &mut rest));
    }
    (shares, rest)
}

/// Removes the component along the unit vector `q` from `rest`, and returns it.
fn remove(q: &[f64], rest: &mut [f64]) -> f64 {
    let along: f64 = q.iter().zip(&*rest).map(|(q, r)| q * r).sum();
    rest.iter_mut().zip(q).for_each(|(r, q)| *r -= along * q);
    along
}

/// This column as a sum of the columns of the basis: back substitution in their triangular matrix.
fn weights(shares: &[f64], basis: &[(usize, Vec<f64>)], columns: &[Vec<f64>]) -> Vec<f64> {
    let element = |i: usize, k: usize| -> f64 { basis[i].1.iter().zip(&columns[basis[k].0]).map(|(q, r)| q * r).sum() };
    let mut weights = shares.to_vec();
    for k in (0..basis.len()).rev() {
        weights[k] /= element(k, k);
        for i in 0..k {
            weights[i] -= element(i, k) * weights[k];
        }
    }
    weights
}
