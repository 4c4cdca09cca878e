//! Hypotheses about a set-up: residuals of the observations after all parameters of a robot have
//! been fitted, with their tolerances.
//!
//! Hypotheses compete by the sum of squares of residuals and of deviations from nominal at one and
//! the same standard deviation of a coordinate. Lengths are those of the robot: a change of the
//! unit of points cannot shrink what is left.

use crate::Observation;
use crate::model::prior::DIFFUSE;
use crate::model::residuals::Residuals;
use crate::solution::placing::{PLAIN, measured_parameters, spread_mm};
use etalon_base::angle::Turn;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_math::statistics::rms;
use etalon_math::{Options, ParameterPrior as Prior, Problem, WithPriors};
use etalon_robots::{Quantity, Robot};

/// Smallest standard deviation (mm) of a coordinate: no instrument measures robots more accurately.
pub(crate) const LEAST_MM: f64 = 1e-3;
/// Ratio of a sum of squares to its expected value at which a hypothesis is contradicted.
const CONTRADICTED: f64 = 4.0;
/// Deviation of a parameter from nominal, in standard uncertainties of its tolerance, at which a
/// hypothesis is contradicted: 2.3 tolerances.
const OFF: f64 = 4.0;
/// Maximum residual of a hypothesis, as a share of the spread of the measured or of the predicted
/// positions, whichever is smaller.
const LEFT: f64 = 0.05;
/// Minimum decrease of a sum of squares if parameters alone contradict a hypothesis.
const FALLS_BY: f64 = 16.0;
/// Iterations of one fit.
const ITERATIONS: usize = 60;

/// Observations, and a robot as their explanation.
pub(crate) struct Hypothesis<'a> {
    /// The robot.
    pub robot: &'a dyn Robot,
    /// The observations.
    pub observations: &'a [Observation],
    /// Values of all parameters with base and targets located.
    pub placed: Vec<f64>,
    /// Starting values of the fit, if others are nearer.
    pub start: Option<&'a [f64]>,
    /// Parameter without a nominal value.
    pub loose: Option<usize>,
}

/// Residuals of observations after a fit.
pub(crate) struct Fitted {
    /// All parameters.
    pub values: Vec<f64>,
    /// Root mean square distance, mm.
    pub left_mm: f64,
    /// Standard deviation (mm) of a coordinate from the residuals.
    pub noise_mm: f64,
    /// Sum of squares of residuals over the standard deviation, and of deviations from nominal over
    /// that of the tolerance.
    pub cost: f64,
    /// Number of residuals.
    rows: usize,
    /// Largest deviation from nominal, in standard uncertainties of the tolerance.
    off: f64,
    /// Share of the spread that remains.
    share: f64,
}

impl Hypothesis<'_> {
    /// Fits all parameters for the standard deviation `sigma_mm` of a coordinate; `None` if a pose
    /// is out of reach.
    pub fn fit(&self, sigma_mm: f64) -> Option<Fitted> {
        let parameters = self.robot.parameters();
        let free = measured_parameters(self.robot, self.observations);
        let problem = Residuals::new(self.robot, self.observations, &PLAIN, &free, &self.placed).ok()?;
        let prior = |(parameter, &i): (usize, &usize)| {
            let p = &parameters[i];
            let (value, u) = match p.tolerance.is_finite() && self.loose != Some(i) {
                true => (p.nominal, uncertainty(p.tolerance)),
                false => (self.placed[i], DIFFUSE * p.known_within()),
            };
            Prior { parameter, value, weight: sigma_mm / u.max(1e-9) }
        };
        let priors: Vec<Prior> = free.iter().enumerate().map(prior).collect();
        let start: Vec<f64> = free.iter().map(|&i| self.start.unwrap_or(&self.placed)[i]).collect();
        let options = Options { iterations: ITERATIONS, step: 1e-9, ..Options::default() };
        let solution = etalon_math::solve(&WithPriors::new(&problem, &priors), &start, options);
        let rows = problem.residual_count();
        let counts = |i: &usize| parameters[*i].tolerance.is_finite() && self.loose != Some(*i);
        let mut values = problem.all(&solution.x);
        for (value, p) in values.iter_mut().zip(parameters).filter(|(_, p)| p.tolerance.is_finite()) {
            if p.quantity == Quantity::Angle {
                *value = Turn::RADIANS.near(*value, p.nominal);
            }
        }
        let off = |i: usize| (values[i] - parameters[i].nominal).abs() / uncertainty(parameters[i].tolerance).max(1e-9);
        let misses: Vec<Vector> = self
            .observations
            .iter()
            .flat_map(|o| o.misses(self.robot, &values).map(|m| m.1).collect::<Vec<_>>())
            .collect();
        let squares: f64 = misses.iter().map(|m| norm(*m).powi(2)).sum();
        let deviations: f64 = free.iter().filter(|i| counts(i)).map(|&i| off(i).powi(2)).sum();
        // the data determine this many parameters
        let covariance = solution.covariance().unwrap_or_default();
        let share = |k: usize| covariance.get(k * free.len() + k).map_or(0.0, |v| 1.0 - v * priors[k].weight.powi(2));
        let determined: f64 = (0..free.len()).map(|k| share(k).clamp(0.0, 1.0)).sum();
        let dof = (rows as f64 - determined).max(1.0);
        let fitted = Fitted {
            left_mm: rms(misses.iter().map(|m| norm(*m))),
            noise_mm: (squares / dof).sqrt(),
            cost: squares / sigma_mm.powi(2) + deviations,
            rows,
            off: free.iter().filter(|i| counts(i)).map(|&i| off(i)).fold(0.0, f64::max),
            share: rms(misses.iter().map(|m| norm(*m))) / self.spread_mm(&values),
            values,
        };
        fitted.cost.is_finite().then_some(fitted)
    }

    /// Spread of the measured or of the predicted positions, whichever is smaller, mm.
    fn spread_mm(&self, values: &[f64]) -> f64 {
        let mut predicted = Vec::new();
        for o in self.observations {
            let seen = (0..o.targets.len()).filter(|&k| o.targets[k].is_some());
            predicted.extend(seen.map(|k| self.robot.position(values, &o.joints, k)));
        }
        let middle = centroid(&predicted).unwrap_or_default();
        rms(predicted.iter().map(|p| norm(minus(*p, middle)))).min(spread_mm(self.observations))
    }
}

impl Fitted {
    /// `true` if residuals or parameters contradict the hypothesis.
    pub fn is_contradicted(&self) -> bool {
        self.cost > CONTRADICTED * self.rows as f64 || self.off > OFF
    }

    /// `true` if the hypothesis explains the observations.
    pub fn explains(&self) -> bool {
        !self.is_contradicted() && self.is_near()
    }

    /// `true` if the hypothesis explains the observations, and `stated`, the one without a change,
    /// cannot. Residuals must fall relative to the spread of the positions as well: a smaller unit
    /// makes all lengths small, and explains nothing.
    pub fn explains_what(&self, stated: &Fitted) -> bool {
        let (per_row, stated_per_row) = (self.cost / self.rows as f64, stated.cost / stated.rows as f64);
        let falls = stated.cost - self.cost > FALLS_BY && stated_per_row > per_row;
        let nearer = self.share < stated.share / CONTRADICTED.sqrt();
        let residuals = nearer && stated_per_row > CONTRADICTED * per_row.max(1.0);
        self.explains() && falls && (residuals || stated.off > OFF)
    }

    /// `true` if a small share of the spread of the positions remains.
    fn is_near(&self) -> bool {
        self.share < LEFT
    }

    /// `true` if the residuals show the noise, which parameters far from nominal would reduce.
    pub fn shows_noise(&self) -> bool {
        self.is_near() && self.off <= OFF
    }

    /// Sum of squares per residual.
    pub fn per_row(&self) -> f64 {
        self.cost / self.rows as f64
    }
}

/// Standard uncertainty from a tolerance, the half-width of a rectangular distribution (GUM 4.3.7).
fn uncertainty(tolerance: f64) -> f64 {
    tolerance / 3f64.sqrt()
}
