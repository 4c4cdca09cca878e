//! Fit of a hypothesis about a set-up: its residuals, with its own misfit.
//!
//! Models of real robots are incomplete, so that residuals exceed the instrument's uncertainty.
//! Each hypothesis is fitted with the standard deviations of its own residuals, one for lengths and
//! one for angles. Its score is the residuals at poses that are excluded from the fit. Lengths are
//! in units of the robot: a change of unit cannot win merely by making numbers small.

use super::data::Data;
use crate::judgement::regional::SHOWN;
use crate::judgement::robust::CAUCHY;
use crate::model::prior::DIFFUSE;
use crate::model::residuals::Residuals;
use crate::solution::placing::{measured_parameters, rms_of_most};
use crate::{Known, wanted_parameters};
use etalon_base::angle::Turn;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_math::statistics::rms;
use etalon_math::{Loss, Options, ParameterPrior, Problem, WithPriors};
use etalon_robots::{Parameter, Quantity, Robot, Role};
use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};
use std::collections::BTreeSet;

/// Minimum standard deviations (mm, rad) of a residual: no instrument measures robots more
/// accurately.
const LEAST: [f64; 2] = [1e-3, 1e-6];
/// Root mean square of the smallest 80 % of normal numbers over their standard deviation.
const OF_MOST: f64 = 0.6616;
/// Fits, each with the standard deviations of the one before.
const ROUNDS: usize = 3;
/// Iterations of one fit.
const ITERATIONS: usize = 40;
/// Iterations that show whether a fit comes near the data at all.
const FIRST_LOOK: usize = 2;
/// Maximum number of parameters of a fit.
pub(crate) const MOST_PARAMETERS: usize = 150;
/// Number of blocks of consecutive poses that are excluded in turn.
const BLOCKS: usize = 5;

/// Standard deviation of residuals: of lengths (mm) and of angles (rad).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales(pub [f64; 2]);

/// Residuals by quantity.
#[derive(Clone, Debug, Default)]
pub(crate) struct Left {
    lengths_mm: Vec<f64>,
    angles_rad: Vec<f64>,
}

impl Left {
    pub fn scales(&self) -> Scales {
        let of = |all: &[f64], least: f64| (rms_of_most(all.to_vec()) / OF_MOST).max(least);
        Scales([of(&self.lengths_mm, LEAST[0]), of(&self.angles_rad, LEAST[1])])
    }

    /// Number of residuals of each quantity.
    pub fn counts(&self) -> [f64; 2] {
        [self.lengths_mm.len() as f64, self.angles_rad.len() as f64]
    }

    fn add(&mut self, is_angle: bool, value: f64) {
        if is_angle { self.angles_rad.push(value.abs()) } else { self.lengths_mm.push(value.abs()) }
    }
}

/// A robot as the explanation of some data.
pub(crate) struct Hypothesis<'a> {
    /// The robot.
    pub robot: &'a dyn Robot,
    /// The data.
    pub data: &'a Data,
    /// Values of all parameters with base, targets and fixtures located.
    pub placed: &'a [f64],
    /// Parameter without a nominal value.
    pub loose: Option<usize>,
    /// Cost for each residual beyond which the hypothesis is given up, unless the first iterations
    /// halve its residuals: see [`HOPELESS`](super::HOPELESS).
    pub limit: Option<f64>,
}

/// Result of the fit of a hypothesis.
#[derive(Clone, Debug)]
pub(crate) struct Fitted {
    /// All parameters.
    pub values: Vec<f64>,
    /// Standard deviation of the residuals of poses that are excluded from the fit.
    pub scales: Scales,
    /// Number of residuals.
    pub rows: f64,
    /// Number of residuals, without the residuals that parameters without a nominal value can make
    /// zero.
    pub redundant: f64,
    /// Sum over all residuals of the logarithm of their standard deviation, in units as measured,
    /// and half the squares of deviations from nominal: the negative logarithm of the likelihood.
    pub cost: f64,
    /// Cost without the tails: by the standard deviation of most residuals alone.
    pub cost_of_most: f64,
    /// Largest deviation from nominal, in standard uncertainties of the tolerance.
    pub off: f64,
    /// Standard deviation of a length relative to the spread of the positions.
    pub share: f64,
    has_angles: bool,
}

/// Residuals of the data with all parameters `values`.
pub(crate) fn left(robot: &dyn Robot, data: &Data, values: &[f64]) -> Left {
    let mut left = Left::default();
    for o in &data.observations {
        for (_, miss) in o.misses(robot, values) {
            miss[..robot.dimension()].iter().for_each(|v| left.add(false, *v));
        }
    }
    for c in &data.settings.conditions {
        let (residuals, rows) = c.residuals_at(robot, values);
        residuals[..rows].iter().for_each(|v| left.add(c.kind.is_angle(), *v));
    }
    left
}

/// Cost of the data for each residual with all parameters `values`.
pub(crate) fn cost_for_each(robot: &dyn Robot, data: &Data, values: &[f64]) -> f64 {
    let left = left(robot, data, values);
    let counts = left.counts();
    cost(&left, left.scales(), data) / (counts[0] + counts[1])
}

/// Spread (mm) of the measured or of the predicted positions, whichever is smaller.
pub(crate) fn spread_mm(robot: &dyn Robot, data: &Data, values: &[f64]) -> f64 {
    let (mut measured, mut predicted): (Vec<Vector>, Vec<Vector>) = (Vec::new(), Vec::new());
    for o in &data.observations {
        for (k, at) in o.targets.iter().enumerate() {
            if let Some(at) = at {
                measured.push(*at);
                predicted.push(robot.position(values, &o.joints, k));
            }
        }
    }
    let by_conditions = measured.is_empty();
    if by_conditions {
        predicted.extend(data.settings.conditions.iter().map(|c| robot.position(values, &c.joints, c.target)));
    }
    let spread = |points: &[Vector]| {
        let middle = centroid(points).unwrap_or_default();
        rms(points.iter().map(|p| norm(minus(*p, middle))))
    };
    let predicted_mm = spread(&predicted);
    if by_conditions { predicted_mm } else { predicted_mm.min(spread(&measured)) }
}

/// Returns the negative logarithm of the likelihood of the data as measured, for residuals with
/// these standard deviations and the tails of the Cauchy loss.
pub(crate) fn cost(left: &Left, Scales(scales): Scales, data: &Data) -> f64 {
    let each = |r: f64, scale: f64| scale.ln() + 0.5 * CAUCHY.powi(2) * (r / (CAUCHY * scale)).powi(2).ln_1p();
    let lengths: f64 = left.lengths_mm.iter().map(|r| each(*r, scales[0])).sum();
    let angles: f64 = left.angles_rad.iter().map(|r| each(*r, scales[1])).sum();
    lengths + angles - data.log_factors
}

/// Logarithm of the standard deviations, summed over the residuals.
fn sum_of_logarithms(counts: [f64; 2], Scales(scales): Scales) -> f64 {
    (0..2).filter(|&k| counts[k] > 0.0).map(|k| counts[k] * scales[k].ln()).sum()
}

/// Parameters of the model that the data depend on; `None` if they are too many for a comparison.
pub(super) fn free_parameters(robot: &dyn Robot, data: &Data) -> Option<Vec<usize>> {
    let wanted = wanted_parameters(robot, &data.observations, &data.settings).ok()?;
    let measured: BTreeSet<usize> = measured_parameters(robot, &data.observations).into_iter().collect();
    let unknowns = data.settings.conditions.iter().flat_map(|c| c.kind.equation().unknowns());
    // six for a station, three for a point: those that follow belong to neighbours, which are few
    let known = data.settings.known.iter().flat_map(Known::points).flat_map(|first| first..first + 6);
    let seen: BTreeSet<usize> = unknowns.chain(known).collect();
    let shown = |i: &usize| match robot.parameters()[*i].role {
        Role::Fixture => seen.contains(i),
        _ => data.observations.is_empty() || measured.contains(i) || seen.contains(i),
    };
    let free: Vec<usize> = wanted.into_iter().filter(shown).collect();
    (free.len() <= MOST_PARAMETERS).then_some(free)
}

impl Hypothesis<'_> {
    /// Fits all parameters of the model; `None` if a pose is out of reach, or if the hypothesis is
    /// given up.
    pub fn fit(&self) -> Option<Fitted> {
        let Self { robot, data, placed, loose, .. } = *self;
        let parameters = robot.parameters();
        let mut free = free_parameters(robot, data)?;
        if let Some(i) = loose.filter(|i| !free.contains(i)) {
            free.push(i);
            free.sort_unstable();
        }
        let prior = |(parameter, &i): (usize, &usize)| {
            let p = &parameters[i];
            let (value, u) = match p.tolerance.is_finite() && loose != Some(i) {
                true => (p.nominal, uncertainty(p.tolerance)),
                false => (placed[i], DIFFUSE * p.known_within()),
            };
            ParameterPrior { parameter, value, weight: 1.0 / u.max(1e-9) }
        };
        let priors: Vec<ParameterPrior> = free.iter().enumerate().map(prior).collect();
        let mut values = placed.to_vec();
        let mut scales = left(robot, data, placed).scales();
        let solved = |values: &[f64], scales: Scales, iterations: usize| {
            let settings = weighted(data, scales);
            let mut problem = Residuals::new(robot, &data.observations, &settings, &free, values).ok()?;
            problem.layout = None;
            let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
            let options = Options { iterations, step: 1e-6, loss: Loss::Cauchy(CAUCHY), ..Options::default() };
            Some(problem.all(&etalon_math::solve(&WithPriors::new(&problem, &priors), &x, options).x))
        };
        let cost = |values: &[f64]| cost_for_each(robot, data, values);
        if let Some((limit, placed_cost)) = self.limit.map(|limit| (limit, cost(placed))).filter(|(l, c)| c > l) {
            let looked = cost(&solved(placed, scales, FIRST_LOOK)?);
            if looked > limit.max(placed_cost - 2f64.ln()) {
                return None;
            }
        }
        for _ in 0..ROUNDS {
            values = solved(&values, scales, ITERATIONS)?;
            let next = left(robot, data, &values).scales();
            if next.0.iter().any(|scale| !scale.is_finite()) {
                return None;
            }
            let settled = (0..2).all(|k| (next.0[k] / scales.0[k] - 1.0).abs() < 0.1);
            scales = next;
            if settled {
                break;
            }
        }
        self.judged(&free, &priors, values, scales)
    }

    fn judged(
        &self,
        free: &[usize],
        priors: &[ParameterPrior],
        mut values: Vec<f64>,
        scales: Scales,
    ) -> Option<Fitted> {
        let Self { robot, data, loose, .. } = *self;
        let parameters = robot.parameters();
        let left_out = self.left_out(free, priors, &values, scales)?;
        let (counts, scales) = (left_out.counts(), left_out.scales());
        for (value, p) in values.iter_mut().zip(parameters).filter(|(_, p)| p.tolerance.is_finite()) {
            if p.quantity == Quantity::Angle {
                *value = Turn::RADIANS.near(*value, p.nominal);
            }
        }
        let counted = |i: &&usize| parameters[**i].tolerance.is_finite() && loose != Some(**i);
        let off = |&i: &usize| deviation(&parameters[i], values[i]);
        let spread_mm = spread_mm(robot, data, &values);
        let deviations: f64 = free.iter().filter(counted).map(|i| off(i).powi(2)).sum();
        let rows = counts[0] + counts[1];
        let unknowns = free.len() - free.iter().filter(counted).count();
        let redundant = (rows - unknowns as f64).max(0.0);
        let fitted = Fitted {
            rows,
            redundant,
            cost: cost(&left_out, scales, data) + 0.5 * deviations,
            cost_of_most: sum_of_logarithms(counts, scales) - data.log_factors + 0.5 * deviations,
            off: free.iter().filter(counted).map(off).fold(0.0, f64::max),
            share: if counts[0] > 0.0 { scales.0[0] / spread_mm } else { 0.0 },
            has_angles: counts[1] > 0.0,
            scales,
            values,
        };
        fitted.cost.is_finite().then_some(fitted)
    }

    /// Residuals of each block of poses about a fit to the other blocks, to first order.
    fn left_out(&self, free: &[usize], priors: &[ParameterPrior], values: &[f64], scales: Scales) -> Option<Left> {
        let Self { robot, data, .. } = *self;
        let settings = weighted(data, scales);
        let mut problem = Residuals::new(robot, &data.observations, &settings, free, values).ok()?;
        problem.layout = None;
        let (n, m) = (free.len(), problem.measured_count());
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let mut residuals = vec![0.0; problem.residual_count()];
        problem.residuals(&x, &mut residuals);
        let jacobian = problem.jacobian_at(&x);
        let units: Vec<(bool, f64)> = row_units(data, &settings, robot.dimension());
        let weights: Vec<f64> = residuals.iter().map(|r| 1.0 / (1.0 + (r / CAUCHY).powi(2)).sqrt()).collect();
        let column = |j: usize| {
            let squares: f64 = (0..residuals.len()).map(|i| (weights[i] * jacobian[i * n + j]).powi(2)).sum();
            (squares + priors[j].weight.powi(2)).sqrt().max(f64::MIN_POSITIVE)
        };
        let norms: Vec<f64> = (0..n).map(column).collect();
        let rows = DMatrix::from_fn(residuals.len(), n, |i, j| weights[i] * jacobian[i * n + j] / norms[j]);
        let mut normal = rows.tr_mul(&rows);
        (0..n).for_each(|j| normal[(j, j)] += (priors[j].weight / norms[j]).powi(2) + 1e-12);
        let inverse = Cholesky::new(normal)?.inverse();
        let poses = problem.poses();
        let mut starts: Vec<usize> = (0..m).filter(|&i| i == 0 || poses[i] != poses[i - 1]).collect();
        starts.push(m);
        let count = starts.len() - 1;
        let mut left = Left::default();
        for block in 0..BLOCKS.min(count) {
            let at = |k: usize| starts[k * count / BLOCKS.min(count)];
            let range = at(block)..at(block + 1);
            let part = rows.rows(range.start, range.len());
            let kept = DMatrix::identity(range.len(), range.len()) - part * &inverse * part.transpose();
            let weighted = DVector::from_fn(range.len(), |i, _| weights[range.start + i] * residuals[range.start + i]);
            // what the block determines almost alone cannot be predicted from the others
            let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(kept);
            let along = eigenvectors.tr_mul(&weighted).zip_map(&eigenvalues, |a, shown| a / shown.max(SHOWN));
            let out = eigenvectors * along;
            for (i, out) in range.zip(out.iter()) {
                let (is_angle, unit) = units[i];
                left.add(is_angle, out / weights[i] * unit);
            }
        }
        Some(left)
    }
}

impl Fitted {
    /// Cost of most residuals for each residual.
    pub fn per_row(&self) -> f64 {
        self.cost_of_most / self.rows
    }

    /// Logarithm of the ratio by which another fit leaves more: by most residuals, and by all with
    /// their tails. By most residuals, a change of the unit of a few readings wins; by the tails, a
    /// few poses that others do not determine.
    pub fn gain_over(&self, other: &Self) -> f64 {
        let tails = other.cost / other.rows - self.cost / self.rows;
        tails.min(other.per_row() - self.per_row())
    }

    /// Standard deviation (mm) of a length.
    pub fn length_mm(&self) -> f64 {
        self.scales.0[0]
    }

    /// Standard deviation (rad) of an angle; 0 if none is measured.
    pub fn angle_rad(&self) -> f64 {
        if self.has_angles { self.scales.0[1] } else { 0.0 }
    }
}

/// Settings in which each residual has the standard deviation of its quantity.
fn weighted(data: &Data, Scales([length_mm, angle_rad]): Scales) -> crate::Settings {
    let mut settings = data.settings.clone();
    settings.prior = crate::Prior::None;
    settings.standard_uncertainty_mm = Some(length_mm);
    for c in &mut settings.conditions {
        c.standard_uncertainty = if c.kind.is_angle() { angle_rad } else { length_mm };
    }
    settings
}

/// For each residual of the data, whether it is an angle, and its unit (mm, rad).
fn row_units(data: &Data, settings: &crate::Settings, dimension: usize) -> Vec<(bool, f64)> {
    let unit_mm = settings.standard_uncertainty_mm.unwrap_or(1.0);
    let points = data.observations.iter().flat_map(|o| o.targets.iter().flatten()).count() * dimension;
    let conditions = settings
        .conditions
        .iter()
        .flat_map(|c| std::iter::repeat_n((c.kind.is_angle(), c.standard_uncertainty), c.kind.rows()));
    std::iter::repeat_n((false, unit_mm), points).chain(conditions).collect()
}

/// Deviation of a parameter from nominal, in standard uncertainties of its tolerance.
pub(super) fn deviation(parameter: &Parameter, value: f64) -> f64 {
    (value - parameter.nominal).abs() / uncertainty(parameter.tolerance).max(1e-9)
}

/// Standard uncertainty from a tolerance, the half-width of a rectangular distribution (GUM 4.3.7).
fn uncertainty(tolerance: f64) -> f64 {
    tolerance / 3f64.sqrt()
}
