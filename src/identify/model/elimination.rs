//! Unknowns that are eliminated block by block: targets, or fixed points and planes, each of which
//! occurs only in its own observations.

use crate::model::kinds::Condition;
use crate::model::prior::Prior;
use crate::{Observation, Settings};
use etalon_math::{Blocks, OWN, Rows, Solution};
use etalon_robots::{FreeBase, Robot};
use nalgebra::{DMatrix, DMatrixView, DVector, SymmetricEigen};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Minimum number of unknown points for elimination.
const MANY: usize = 24;

/// Positions of the derivatives by each parameter in a row.
#[derive(Debug)]
pub(crate) struct Layout {
    /// Columns and rows of the blocks.
    pub blocks: Blocks,
    /// Block and position in the row of each parameter, if it has a block; `None` if it is not
    /// free.
    pub places: Vec<Option<(Option<usize>, usize)>>,
}

impl Layout {
    /// Layout of the residuals of an arm for its parameters `free`; `None` if there are few such
    /// unknowns, or if other residuals depend on them.
    pub fn new(robot: &dyn Robot, free: &[usize], observations: &[Observation], settings: &Settings) -> Option<Self> {
        let arm = robot.free_base()?;
        if 3 * MANY > free.len() || settings.common_uncertainty_mm.is_some() || !settings.rigid.is_empty() {
            return None;
        }
        let mut column = vec![None; robot.parameters().len()];
        free.iter().enumerate().for_each(|(j, &i)| column[i] = Some(j));
        let columns = |of: &Range<usize>| -> Vec<usize> { of.clone().filter_map(|i| column[i]).collect() };
        let owners = Owners::new(robot, arm, settings);
        let unknown: Vec<Range<usize>> = owners.all().filter(|of| !columns(of).is_empty()).collect();
        if unknown.len() < MANY {
            return None;
        }
        let mut blocks = Blocks { own: unknown.iter().map(columns).collect(), ..Blocks::default() };
        let mut block = vec![None; robot.parameters().len()];
        unknown.iter().enumerate().for_each(|(k, of)| block[of.start] = Some(k));
        let is_own: BTreeSet<usize> = blocks.own.iter().flatten().copied().collect();
        blocks.common = (0..free.len()).filter(|j| !is_own.contains(j)).collect();
        let mut add = |of: Option<usize>, rows: usize| {
            blocks.of_row.extend(std::iter::repeat_n(of.and_then(|first| block[first]), rows));
        };
        for o in observations {
            let measured = (0..o.targets.len()).filter(|&k| o.targets[k].is_some());
            measured.for_each(|k| add(Some(arm.target_place(k)), robot.dimension()));
        }
        settings.conditions.iter().for_each(|c| add(owners.first_unknown(arm, c), c.kind.rows()));
        for known in &settings.known {
            add(Some(known.points()[0]).filter(|_| known.points().len() == 1), known.rows());
        }
        if settings.prior != Prior::None {
            let owner = |i: usize| unknown.iter().find(|of| of.contains(&i)).map(|of| of.start);
            free.iter().for_each(|&i| add(owner(i), 1));
        }
        let mut places = vec![None; robot.parameters().len()];
        blocks.common.iter().enumerate().for_each(|(k, &j)| places[free[j]] = Some((None, OWN + k)));
        for (b, own) in blocks.own.iter().enumerate() {
            own.iter().enumerate().for_each(|(k, &j)| places[free[j]] = Some((Some(b), k)));
        }
        Some(Self { blocks, places })
    }

    /// Adds derivatives by one parameter to a row of `block`.
    pub fn add(&self, block: Option<usize>, parameter: usize, derivative: f64, row: &mut [f64]) {
        if let Some((of, place)) = self.places[parameter]
            && (of.is_none() || of == block)
        {
            row[place] += derivative;
        }
    }
}

/// A linear problem in the common parameters, after elimination of the blocks: rows with block
/// unknowns contribute their remaining part.
pub(crate) struct Remaining {
    /// Rows of the Jacobian of the common parameters.
    pub jacobian: Vec<f64>,
    /// Residuals, enlarged to the size of errors: residuals of one cluster and block by the share
    /// that the block absorbs.
    pub residuals: Vec<f64>,
    /// F with F Fᵀ = (JᵀJ)⁻¹. A covariance is formed with it from both sides: products with the
    /// inverse would lose twice as many digits, symmetry and positive variances.
    pub root: DMatrix<f64>,
}

/// Maximum share of a block that a cluster may determine alone to have residuals there.
const ALONE: f64 = 0.99;

impl Remaining {
    /// Remaining equations of a solution whose residuals belong to `clusters` and whose Jacobian is
    /// `rows`; `None` without a factor of full rank.
    pub fn new<C: Copy + Ord>(clusters: &[C], solution: &Solution, rows: Rows) -> Option<Self> {
        let Some(blocks) = rows.blocks else {
            let (jacobian, residuals) = (rows.numbers.to_vec(), solution.residuals.clone());
            return Some(Self { jacobian, residuals, root: root(solution)? });
        };
        let (factor, scale) = (solution.factor.as_ref()?, &solution.scale);
        let (common, width) = (&blocks.common, rows.width());
        let p = common.len();
        let mut follows = vec![vec![0.0; p]; rows.n];
        for k in 0..p {
            let mut unit = vec![0.0; p];
            unit[k] = 1.0;
            factor.follow(&unit)?.into_iter().for_each(|(j, v)| follows[j][k] = v * scale[common[k]] / scale[j]);
        }
        let mut jacobian = Vec::with_capacity(blocks.of_row.len() * p);
        for (row, block) in rows.numbers.chunks_exact(width).zip(&blocks.of_row) {
            let own = block.map_or(&[][..], |b| &blocks.own[b]);
            let left = |k: usize| row[OWN + k] + own.iter().zip(row).map(|(&j, v)| v * follows[j][k]).sum::<f64>();
            jacobian.extend((0..p).map(left));
        }
        let mut residuals = solution.residuals.clone();
        let triangles: Vec<_> = factor.blocks().collect();
        let mut shared: BTreeMap<(usize, C), Vec<usize>> = BTreeMap::new();
        for (row, (block, cluster)) in blocks.of_row.iter().zip(clusters).enumerate() {
            block.iter().for_each(|&b| shared.entry((b, *cluster)).or_default().push(row));
        }
        for ((block, _), taken) in shared {
            let (own, r) = &triangles[block];
            let w = own.len();
            let scaled = DMatrix::from_fn(taken.len(), w, |i, k| rows.numbers[taken[i] * width + k] / scale[own[k]]);
            let share = scaled * DMatrix::from_fn(w, w, |i, k| r[k][i]).try_inverse()?;
            let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(share.tr_mul(&share));
            // of (I − Y Yᵀ)^-½ with the share Y what is beyond the identity, as Y f(YᵀY) Yᵀ
            let f = |g: f64| if !(1e-12..ALONE).contains(&g) { 0.0 } else { (1.0 / (1.0 - g).sqrt() - 1.0) / g };
            let along = eigenvectors.tr_mul(&share.tr_mul(&DVector::from_fn(taken.len(), |i, _| residuals[taken[i]])));
            let more = share * &eigenvectors * along.zip_map(&eigenvalues, |a, g| a * f(g));
            taken.iter().zip(more.iter()).for_each(|(&row, more)| residuals[row] += more);
        }
        Some(Self { jacobian, residuals, root: root(solution)? })
    }
}

/// F with F Fᵀ = (JᵀJ)⁻¹ for the common parameters of a solution; `None` without a factor of full
/// rank.
pub(crate) fn root(solution: &Solution) -> Option<DMatrix<f64>> {
    let factor = solution.factor.as_ref()?;
    let common = factor.common();
    let mut root = DMatrix::from_vec(common.len(), common.len(), factor.common_root()?);
    root.row_iter_mut().zip(&common).for_each(|(mut row, &k)| row /= solution.scale[k]);
    Some(root)
}

/// Returns F M Fᵀ, row by row and symmetric to the last digit: the covariance of the parameters,
/// from the covariance M of scaled parameters for which JᵀJ is the identity.
pub(crate) fn carried(root: &DMatrix<f64>, middle: &DMatrix<f64>) -> DMatrix<f64> {
    let mut all = root * middle * root.transpose();
    all.fill_lower_triangle_with_upper_triangle();
    all
}

/// Aᵀ B with the vector instructions of the machine, which `tr_mul` does not use.
pub(crate) fn transposed_times(a: DMatrixView<f64>, b: DMatrixView<f64>) -> DMatrix<f64> {
    a.transpose() * b
}

/// The unknowns to eliminate: of targets, or fixed in the world, whichever are more.
struct Owners {
    targets: Vec<Range<usize>>,
    fixtures: BTreeSet<usize>,
    of_targets: bool,
}

impl Owners {
    fn new(robot: &dyn Robot, arm: &dyn FreeBase, settings: &Settings) -> Self {
        let place = |k: usize| arm.target_place(k)..arm.target_place(k) + 3;
        let mut targets: Vec<Range<usize>> = (0..robot.targets().len()).map(place).collect();
        // one of four unknowns may belong to a point
        let (mut mountings, mut fixtures, mut shared) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for c in &settings.conditions {
            let of = c.kind.equation().unknowns();
            if c.kind.is_orientation() {
                mountings.extend(of.first());
            } else if of.len() == OWN {
                fixtures.extend(of.first());
            } else {
                shared.extend(of);
            }
        }
        fixtures.retain(|first| !shared.contains(first));
        // an observation of two targets is in no block
        for c in settings.conditions.iter().filter(|c| c.kind.other_target().is_some()) {
            let both = c.kind.other_target().into_iter().chain([c.target]).map(|k| arm.target_place(k));
            both.for_each(|first| targets.retain(|of| of.start != first));
        }
        // what ties two of them together is in no block
        for known in settings.known.iter().filter(|known| known.points().len() > 1) {
            fixtures.retain(|first| !known.points().contains(first));
        }
        targets.extend(mountings.into_iter().map(|first| first..first + 3));
        Self { of_targets: targets.len() >= fixtures.len(), targets, fixtures }
    }

    fn all(&self) -> Box<dyn Iterator<Item = Range<usize>> + '_> {
        match self.of_targets {
            true => Box::new(self.targets.iter().cloned()),
            false => Box::new(self.fixtures.iter().map(|&first| first..first + 3)),
        }
    }

    /// First unknown on which a condition depends.
    fn first_unknown(&self, arm: &dyn FreeBase, c: &Condition) -> Option<usize> {
        let equation = c.kind.equation();
        match self.of_targets {
            true => equation.moving(arm.target_place(c.target)),
            false => equation.unknowns().first().copied().filter(|first| self.fixtures.contains(first)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judgement::uncertainty::by_cluster;
    use crate::model::residuals::Residuals;
    use crate::model::solved::Solved;
    use crate::solution::identifiability::Analysis;
    use crate::{fit_frames, identify};
    use etalon_base::noise::Noise;
    use etalon_math::{Options, solve};
    use etalon_robots::{Serial, SerialJoint};

    /// An arm with targets, each seen at all poses but for a few, and poses that see it (mm, rad),
    /// with a noise of 0.01 mm.
    fn many(targets: usize, poses: i64) -> (Serial, Vec<Observation>) {
        let mut noise = Noise::new(17, 6);
        let joint = |&[alpha, a_mm, theta, d_mm]: &[f64; 4]| SerialJoint {
            alpha_rad: alpha.to_radians(),
            a_mm,
            theta_rad: theta.to_radians(),
            d_mm,
            prismatic: false,
            parallel: alpha == 0.0 && a_mm != 0.0,
        };
        let table =
            [[0.0, 0.0, 0.0, 290.0], [-90.0, 0.0, -90.0, 0.0], [0.0, 270.0, 0.0, 0.0], [-90.0, 70.0, 0.0, 302.0]];
        let names: Vec<String> = (1..=targets).map(|k| format!("T{k}")).collect();
        let robot = Serial::new(&table.iter().map(joint).collect::<Vec<_>>(), &names, [0.0, 0.0, -1.0], &[], &[]);
        let value = |(i, p): (usize, &etalon_robots::Parameter)| match i {
            0..3 => 200.0,
            3..6 => 0.4,
            _ if i < 6 + 3 * targets => noise.uniform(100.0),
            _ => p.nominal + noise.uniform(0.02 * p.known_within()),
        };
        let truth: Vec<f64> = robot.parameters().iter().enumerate().map(value).collect();
        let pose = |i: i64| {
            let joints: Vec<f64> = (0..4).map(|_| noise.uniform(1.4)).collect();
            let mut seen = |k: usize| {
                let at = robot.position(&truth, &joints, k).map(|v| v + noise.gaussian(0.01));
                (!(i as usize + k).is_multiple_of(7)).then_some(at)
            };
            let targets = (0..targets).map(&mut seen).collect();
            Observation { pose: i.into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        let observations = (1..=poses).map(pose).collect();
        (robot, observations)
    }

    fn near(a: &[f64], b: &[f64], scale: impl Fn(usize) -> f64) {
        assert_eq!(a.len(), b.len());
        a.iter().zip(b).enumerate().for_each(|(k, (a, b))| assert!((a - b).abs() < 1e-9 * scale(k), "{k}: {a} {b}"));
    }

    /// This problem with all columns in one matrix.
    #[test]
    fn elimination_changes_no_number() {
        let (robot, observations) = many(MANY, 16);
        let settings = Settings { standard_uncertainty_mm: Some(0.01), ..Settings::default() };
        let values = fit_frames(&robot, &observations, &settings).expect("placed");
        let wanted: Vec<usize> = (0..values.len()).collect();
        let all = Residuals::new(&robot, &observations, &settings, &wanted, &values).expect("problem");
        let held = |problem: &Residuals| {
            let mut held = Analysis::at(problem, &values, 1.0).held();
            held.sort_unstable();
            held
        };
        let mut whole = Residuals::new(&robot, &observations, &settings, &wanted, &values).expect("problem");
        whole.layout = None;
        assert!(all.layout.is_some() && !held(&all).is_empty());
        assert_eq!(held(&all), held(&whole));
        let free: Vec<usize> = wanted.into_iter().filter(|i| !held(&all).contains(i)).collect();
        let blocks = Residuals::new(&robot, &observations, &settings, &free, &values).expect("problem");
        let mut dense = Residuals::new(&robot, &observations, &settings, &free, &values).expect("problem");
        dense.layout = None;
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let (a, b) = (solve(&blocks, &x, Options::default()), solve(&dense, &x, Options::default()));
        assert!(a.termination.is_success());
        let (ca, cb) = (a.covariance().unwrap(), b.covariance().unwrap());
        let n = free.len();
        let u = |k: usize| cb[k * n + k].sqrt();
        near(&a.x, &b.x, u);
        near(&ca, &cb, |k| u(k / n) * u(k % n));
        // clusters: the blocks' part of each pose's residuals is taken apart from that of the
        // common parameters, another unbiased estimate
        let (ja, jb) = (blocks.jacobian_at(&a.x), dense.jacobian_at(&b.x));
        let (ca, cb) = (
            by_cluster(Solved { problem: &blocks, solution: &a, jacobian: &ja }).unwrap().0,
            by_cluster(Solved { problem: &dense, solution: &b, jacobian: &jb }).unwrap().0,
        );
        let ratio = |i: usize| (ca.variance(i) / cb.variance(i)).sqrt();
        let mean = |all: &[usize]| all.iter().map(|&j| ratio(j)).sum::<f64>() / all.len() as f64;
        let blocks = &blocks.layout.as_ref().expect("blocks").blocks;
        let (common, own) = (mean(&blocks.common), mean(&blocks.own.concat()));
        assert!((common - 1.0).abs() < 0.05 && (own - 1.0).abs() < 0.1, "{common} {own}");
    }

    /// With one matrix of all columns this takes minutes, and 500 MB.
    #[test]
    fn hundreds_of_targets_are_identified_with_the_robot() {
        let (robot, observations) = many(150, 20);
        let settings = Settings { standard_uncertainty_mm: Some(0.01), ..Settings::default() };
        let found = identify(&robot, &observations, &settings).expect("identified");
        let chi_square = found.residuals.chi_square.expect("chi-square") / found.residuals.degrees_of_freedom as f64;
        assert!((chi_square - 1.0).abs() < 0.05, "{chi_square}");
        assert_eq!(found.identifiability.eliminated.len(), 450);
        let u = |name: &str| found.standard_uncertainty(robot.index(name).unwrap()).unwrap();
        assert!((0.001..0.01).contains(&u("T7_x")), "{}", u("T7_x"));
        assert!(found.identifiability.observability.is_some_and(|o| o.rank == found.free.len() && o.eliminated == 450));
    }
}
