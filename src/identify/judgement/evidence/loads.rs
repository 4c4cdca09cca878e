//! Mistakes of given loads: swapped coordinates of the centre of mass, a sign, a unit.
//!
//! A change c of the given loads makes a family of models, whose loads are the given ones plus λ
//! times the change: λ = 0 as given, λ = 1 changed. To first order λ has the least-squares
//! estimate of one more parameter. A change is named if the data reject λ = 0 and agree with λ = 1,
//! and if the changed model leaves no more than the uncertainty of the readings.
//!
//! A common factor of all masses is no such change: the compliance takes it up.

use crate::judgement::chi_square::exceeds;
use crate::model::residuals::Residuals;
use crate::{Identification, Observation, Result, Settings};
use etalon_base::pose::Vector;
use etalon_math::{Problem, linearised_at};
use etalon_robots::{Circumstance, Effect, Robot};

/// Estimate of λ in its standard uncertainties beyond which the given loads are rejected: two in
/// 30,000 correct campaigns for one change.
const REJECTED: f64 = 4.0;
/// Distance of the estimate of λ from one, in its standard uncertainties, up to which a change
/// explains the data.
const EXPLAINED: f64 = 2.5;
/// Sum of squares, in variances of a reading, by which a further change may be worse than the best
/// one.
const WORSE: f64 = 9.0;
/// Minimum influence of a change on the readings, in standard deviations of a reading; a smaller
/// influence rejects no given load.
const LEAST: f64 = 3.0;
/// Upper limit for a residual after a change, in standard deviations of the residuals.
const OUTLIER: f64 = 5.0;
/// Factors from other units to millimetres.
const UNITS: [f64; 2] = [1000.0, 25.4];
/// Steps of the fit of a changed model.
const STEPS: usize = 2;

/// Change of the given centres of mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoadSlip {
    /// Two coordinates are swapped.
    Exchanged([usize; 2]),
    /// A coordinate has the other sign.
    Sign(usize),
    /// Coordinates are in a unit of this many millimetres.
    Unit(f64),
}

impl LoadSlip {
    fn all() -> impl Iterator<Item = Self> {
        let exchanged = [[0, 1], [0, 2], [1, 2]].map(Self::Exchanged);
        exchanged.into_iter().chain([0, 1, 2].map(Self::Sign)).chain(UNITS.map(Self::Unit))
    }

    /// Centre of mass with the change.
    fn changed_centre(self, mut at_mm: Vector) -> Vector {
        match self {
            Self::Exchanged([a, b]) => at_mm.swap(a, b),
            Self::Sign(k) => at_mm[k] = -at_mm[k],
            Self::Unit(factor) => at_mm = at_mm.map(|v| v * factor),
        }
        at_mm
    }

    /// Joint values with the changed centre of mass, whose coordinates follow the mass at `mass`.
    fn changed(self, joints: &[f64], mass: usize) -> Vec<f64> {
        let mut joints = joints.to_vec();
        if let Some(&[x, y, z]) = joints.get(mass + 1..mass + 4) {
            joints[mass + 1..mass + 4].copy_from_slice(&self.changed_centre([x, y, z]));
        }
        joints
    }
}

/// Given centres of mass that the data reject, with the changes that explain the data.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadContradiction {
    /// Deviation of the given loads from the best ones, in standard uncertainties.
    pub over_u: f64,
    /// Changes, the best one first.
    pub slips: Vec<LoadSlip>,
}

/// Returns the changes of the given loads that the data demand; `None` if the data agree with the
/// given loads, if no single change explains them, or if joints do not bend.
///
/// # Errors
/// Fails if settings and observations do not match.
pub fn load_slips(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Result<Option<LoadContradiction>> {
    let bends = |&i: &usize| robot.parameters()[i].effect == Effect::Payload;
    let Some(mass) = mass_of_payload(robot).filter(|_| found.free.iter().any(bends)) else { return Ok(None) };
    let settings = settings.as_found(found);
    let fit = Fit { robot, observations, settings: &settings, found };
    let stated = fit.residuals(observations, &settings)?;
    let x: Vec<f64> = found.free.iter().map(|&i| found.values[i]).collect();
    let mut before = vec![0.0; stated.residual_count()];
    stated.residuals(&x, &mut before);
    let mut explaining: Vec<(LoadSlip, Judged)> = Vec::new();
    for slip in LoadSlip::all() {
        let after = fit.changed(slip, mass, &x)?;
        explaining.extend(after.and_then(|after| fit.judged(&before, &after)).map(|judged| (slip, judged)));
    }
    explaining.sort_by(|a, b| a.1.left.total_cmp(&b.1.left));
    let Some((_, best)) = explaining.first().copied() else { return Ok(None) };
    let near = explaining.iter().take_while(|(_, judged)| judged.left - best.left < WORSE * best.variance);
    Ok(Some(LoadContradiction { over_u: best.over_u, slips: near.map(|(slip, _)| *slip).collect() }))
}

/// Position of the payload's mass behind the joint values of a reading.
fn mass_of_payload(robot: &dyn Robot) -> Option<usize> {
    let at = robot.circumstances().iter().position(|value| *value == Circumstance::PayloadMass)?;
    Some(robot.joints().len() + robot.approached().len() + at)
}

/// Change that explains the data.
#[derive(Clone, Copy)]
struct Judged {
    /// Estimate of λ over its standard uncertainty.
    over_u: f64,
    /// Remaining sum of squares.
    left: f64,
    /// Variance of a row.
    variance: f64,
}

/// Identification whose loads are changed.
struct Fit<'a> {
    robot: &'a dyn Robot,
    observations: &'a [Observation],
    settings: &'a Settings,
    found: &'a Identification,
}

impl Fit<'_> {
    fn residuals<'b>(&'b self, observations: &'b [Observation], settings: &'b Settings) -> Result<Residuals<'b>> {
        Residuals::new(self.robot, observations, settings, &self.found.free, &self.found.values)
    }

    /// Residuals of the changed loads after all parameters are fitted again from `x`; `None` if the
    /// change leaves all rows as they are, or the fit fails.
    fn changed(&self, slip: LoadSlip, mass: usize, x: &[f64]) -> Result<Option<Vec<f64>>> {
        let mut observations = self.observations.to_vec();
        observations.iter_mut().for_each(|o| o.joints = slip.changed(&o.joints, mass));
        let mut settings = self.settings.clone();
        settings.conditions.iter_mut().for_each(|c| c.joints = slip.changed(&c.joints, mass));
        if observations == self.observations && settings == *self.settings {
            return Ok(None);
        }
        let problem = self.residuals(&observations, &settings)?;
        let mut x = x.to_vec();
        let mut left = vec![0.0; problem.residual_count()];
        problem.residuals(&x, &mut left);
        for _ in 0..STEPS {
            let right: Vec<f64> = left.iter().map(|r| -r).collect();
            let (factor, norms) = linearised_at(&problem, &x, &right);
            let Some(step) = factor.solve() else { return Ok(None) };
            x.iter_mut().zip(step.iter().zip(&norms)).for_each(|(x, (step, norm))| *x += step / norm);
            problem.residuals(&x, &mut left);
        }
        Ok(Some(left).filter(|left| left.iter().all(|r| r.is_finite())))
    }

    /// Returns the judgement of a change if it explains residuals that the given loads do not
    /// explain.
    fn judged(&self, before: &[f64], after: &[f64]) -> Option<Judged> {
        let effect: Vec<f64> = before.iter().zip(after).map(|(before, after)| after - before).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let (size, left) = (dot(&effect, &effect), dot(after, after));
        let lambda = -dot(before, &effect) / size;
        let dof = (self.found.residuals.degrees_of_freedom as f64 - 1.0).max(1.0);
        let estimated = (dot(before, before) - lambda.powi(2) * size) / dof;
        // rows have the standard deviation 1 if the uncertainty of the readings is given
        let is_stated = self.settings.standard_uncertainty_mm.is_some();
        let variance = if is_stated { estimated.max(1.0) } else { estimated };
        if is_stated && exceeds(left, self.found.residuals.degrees_of_freedom) {
            return None;
        }
        // a wrong reading can look like a change
        if after.iter().any(|r| r.powi(2) > OUTLIER.powi(2) * left / dof) {
            return None;
        }
        let u = (variance / size).sqrt();
        let is_slip = size > LEAST.powi(2) * variance && lambda > REJECTED * u && (lambda - 1.0).abs() < EXPLAINED * u;
        is_slip.then_some(Judged { over_u: lambda / u, left, variance })
    }
}
