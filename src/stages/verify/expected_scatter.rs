//! Expected scatter of new measurements about the predictions of a calibration.

use etalon_base::error;
use etalon_base::message::Result;
use etalon_documents::{ErrorQuantity, JointExtrapolation, ParametersDocument, ResidualSummary, UncertaintyFrom};
use etalon_identify::{Extrapolation, chi_square_agrees, chi_square_exceeds};
use etalon_robots::{Quantity, Robot};

/// Expected scatter of new measurements of the same instrument, without the uncertainty of the
/// parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedScatter {
    /// Standard deviation (mm) of a coordinate within the measured values of the joints.
    pub coordinate_mm: f64,
    /// Standard deviation (rad) of an orientation about any axis; absent without observed
    /// orientations.
    pub orientation_rad: Option<f64>,
    /// Growth beyond the measured values of joints.
    extrapolations: Vec<Extrapolation>,
}

impl ExpectedScatter {
    /// Scatter from the residuals of a calibration. The given uncertainty of a quantity counts if
    /// its residuals agree with it, otherwise the residuals count: a model error enlarges them, and
    /// an uncertainty may be given too large.
    ///
    /// # Errors
    /// Fails if the calibration has neither residuals nor a given uncertainty.
    pub fn from_document(robot: &dyn Robot, document: &ParametersDocument) -> Result<Self> {
        let residuals = &document.residuals;
        let position_rms_mm = residuals.position.position_rms_mm.map(|rms| rms / (robot.dimension() as f64).sqrt());
        let rows = residuals.conditions.iter().map(|found| found.count).sum::<usize>();
        let test = &residuals.test;
        let common = test.common_standard_uncertainty_mm.unwrap_or(0.0);
        let coordinate = Shown {
            rms: position_rms_mm.unwrap_or(residuals.rms),
            count: residuals.count.saturating_sub(rows),
            stated: test.stated_standard_uncertainty_mm.map(|u| u.hypot(common)),
        };
        let orientation = residuals.conditions.iter().find(|found| found.quantity == ErrorQuantity::Orientation);
        let inward = |value: f64| Quantity::Angle.inward(value);
        let orientation_rad = orientation.and_then(|found| {
            let stated = Some(inward(found.standard_uncertainty));
            Shown { rms: inward(found.rms), count: found.count, stated }.scatter(residuals)
        });
        let none = || error!("calibration-without-residuals");
        Ok(Self {
            coordinate_mm: coordinate.scatter(residuals).ok_or_else(none)?,
            orientation_rad,
            extrapolations: extrapolations(robot, residuals),
        })
    }

    /// Factors by which the variances of a coordinate and of an orientation grow at joint values
    /// (rad, mm) beyond the measured values: 1 within them.
    pub fn growth(&self, robot: &dyn Robot, joints: &[f64]) -> [f64; 2] {
        let excess = |e: &Extrapolation| e.excess(robot.joints()[e.joint].quantity, joints[e.joint]);
        let add = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a + c, b + d];
        self.extrapolations.iter().map(excess).fold([1.0; 2], add)
    }
}

/// Variance of the readings over the stated one: less than 1 if all residuals together are too
/// small for the stated uncertainty, otherwise 1. An error that is common to all readings, which
/// residuals do not show, moves the parameters and new readings of the instrument alike.
pub fn variance_factor(residuals: &ResidualSummary) -> f64 {
    let dof = residuals.degrees_of_freedom;
    let is_short = |c: &f64| !chi_square_agrees(*c, dof) && !chi_square_exceeds(*c, dof);
    let stated = residuals.test.chi_square.filter(|_| residuals.uncertainties_from == UncertaintyFrom::Instrument);
    stated.filter(is_short).map_or(1.0, |chi_square| chi_square / dof as f64)
}

/// Residuals of a quantity.
struct Shown {
    rms: f64,
    count: usize,
    /// Given standard uncertainty.
    stated: Option<f64>,
}

impl Shown {
    /// Standard deviation of a new value; `None` without degrees of freedom and a given
    /// uncertainty.
    fn scatter(&self, all: &ResidualSummary) -> Option<f64> {
        let share = all.degrees_of_freedom as f64 / all.count.max(1) as f64;
        let shown = Some(self.rms / share.sqrt()).filter(|shown| shown.is_finite());
        let degrees = (share * self.count as f64).round();
        let agrees = |u: f64, shown: f64| chi_square_agrees((shown / u).powi(2) * degrees, degrees as usize);
        match (self.stated, shown) {
            (Some(u), Some(shown)) if !agrees(u, shown) => Some(shown),
            (stated, shown) => stated.or(shown),
        }
    }
}

/// Growth of the errors beyond the measured values of the joints of a robot.
fn extrapolations(robot: &dyn Robot, residuals: &ResidualSummary) -> Vec<Extrapolation> {
    let one = |found: &JointExtrapolation| {
        let joint = robot.joints().iter().position(|joint| joint.column() == found.joint)?;
        let inward = |value: f64| robot.joints()[joint].quantity.inward(value);
        Some(Extrapolation {
            joint,
            range: [inward(found.low), inward(found.high)],
            distance: inward(found.distance),
            position: found.position,
            orientation: found.orientation,
        })
    };
    residuals.position.extrapolation.iter().filter_map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 100 residuals with 90 degrees of freedom: chi-square of 90 degrees is within 54.2 and 137.2
    /// in all but two of a thousand (scipy.stats.chi2.ppf), so that the ratio of the standard
    /// deviations is within 0.776 and 1.235.
    #[test]
    fn a_stated_uncertainty_counts_if_the_residuals_agree_with_it() {
        let all = ResidualSummary { count: 100, degrees_of_freedom: 90, ..summary() };
        let scatter = |ratio: f64, stated: Option<f64>| {
            Shown { rms: 0.9f64.sqrt() * ratio, count: 100, stated }.scatter(&all).unwrap()
        };
        assert_eq!([scatter(0.79, Some(1.0)), scatter(1.22, Some(1.0))], [1.0, 1.0]);
        for ratio in [0.2, 0.76, 1.25, 8.0] {
            assert!((scatter(ratio, Some(1.0)) - ratio).abs() < 1e-12 && (scatter(ratio, None) - ratio).abs() < 1e-12);
        }
        let none = ResidualSummary { count: 10, degrees_of_freedom: 0, ..summary() };
        assert_eq!(Shown { rms: 0.1, count: 10, stated: Some(0.3) }.scatter(&none), Some(0.3));
        assert_eq!(Shown { rms: 0.1, count: 10, stated: None }.scatter(&none), None);
    }

    fn summary() -> ResidualSummary {
        ResidualSummary {
            kind: etalon_documents::ResidualKind::Targets,
            count: 0,
            rms: 0.0,
            position: etalon_documents::PositionResiduals::default(),
            max: 0.0,
            degrees_of_freedom: 0,
            effective_degrees_of_freedom: None,
            test: etalon_documents::ResidualTest::default(),
            uncertainties_from: etalon_documents::UncertaintyFrom::Instrument,
            uncertainties_enlarged_by: 1.0,
            conditions: Vec::new(),
            between_series: None,
        }
    }
}
