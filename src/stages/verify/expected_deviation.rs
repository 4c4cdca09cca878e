//! Expected deviation of new observations from an earlier calibration.

use etalon_base::error;
use etalon_base::message::{Message, Result};
use etalon_documents::{
    ErrorQuantity, ParametersDocument, QuantityResiduals, ResidualSummary, VerifiedQuantity, quantity_residuals,
};
use etalon_identify::{Condition, ConditionResiduals, Kind, Misfit, Settings, Variance};
use etalon_robots::{Quantity, Robot};

/// Expected deviation of a measured coordinate from the given parameters, if nothing has changed.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedDeviation {
    /// Standard uncertainty of a measured coordinate, mm.
    pub measured_mm: f64,
    /// Model error of the calibration (standard deviation, mm).
    pub model_mm: f64,
    /// Part of it that differs between targets of one pose, if the calibration shows it.
    between_targets_mm: Option<f64>,
    /// Source of both variances.
    pub variance: Variance,
    /// Model error of each quantity other than positions of targets (standard deviation, mm or
    /// rad).
    conditions: Vec<(ErrorQuantity, f64)>,
}

impl ExpectedDeviation {
    /// Deviation of a calibration; `stated_mm` is the standard uncertainty of a coordinate if it is
    /// measured with another instrument.
    ///
    /// # Errors
    /// Fails if the residuals of the calibration yield no standard deviation.
    pub fn from_document(robot: &dyn Robot, document: &ParametersDocument, stated_mm: Option<f64>) -> Result<Self> {
        Self::from_residuals(&document.residuals, robot.dimension(), stated_mm)
    }

    /// [`Self::from_document`] of the residuals of a robot in a plane or in space.
    fn from_residuals(residuals: &ResidualSummary, dimension: usize, stated_mm: Option<f64>) -> Result<Self> {
        let dof = residuals.degrees_of_freedom as f64;
        let conditions = model_errors(residuals);
        let rms_mm =
            residuals.position.position_rms_mm.map_or(residuals.rms, |rms_mm| rms_mm / (dimension as f64).sqrt());
        let shown_mm = rms_mm * (residuals.count as f64 / dof).sqrt();
        let excess = |shown_mm: f64, u: f64| (shown_mm.powi(2) - u.powi(2)).max(0.0).sqrt();
        let within_mm = residuals.position.within_poses_rms_mm;
        let Some(u) = residuals.test.stated_standard_uncertainty_mm else {
            if dof == 0.0 || !shown_mm.is_finite() {
                return Err(error!("calibration-without-residuals").into());
            }
            let measured_mm = stated_mm.unwrap_or(shown_mm);
            return Ok(Self {
                measured_mm,
                model_mm: excess(shown_mm, measured_mm),
                between_targets_mm: within_mm.map(|within_mm| excess(within_mm, measured_mm)),
                variance: estimated(residuals),
                conditions,
            });
        };
        let u = u.hypot(residuals.test.common_standard_uncertainty_mm.unwrap_or(0.0));
        // readings may have uncertainties of their own, and other quantities their model errors
        let model_mm = excess(shown_mm, u).min(shown_mm * model_share(residuals).sqrt());
        let between_targets_mm = within_mm.map(|within_mm| excess(within_mm, u).min(model_mm));
        let is_estimated = model_mm > 0.0 || conditions.iter().any(|(_, model)| *model > 0.0);
        let variance = if is_estimated { estimated(residuals) } else { Variance::Stated };
        Ok(Self { measured_mm: stated_mm.unwrap_or(u), model_mm, between_targets_mm, variance, conditions })
    }

    /// Root sum of squares of both (mm).
    pub fn total_mm(&self) -> f64 {
        self.measured_mm.hypot(self.model_mm)
    }

    /// Returns settings with the standard uncertainty of a measured coordinate.
    pub fn applied(&self, settings: Settings) -> Settings {
        Settings { standard_uncertainty_mm: Some(self.measured_mm), ..settings }
    }

    /// Returns the model error of coordinates and of each of these conditions.
    pub fn misfit(&self, conditions: &[Condition]) -> Misfit {
        let of = |c: &Condition| if matches!(c.kind, Kind::Joint(_)) { 0.0 } else { self.model(quantity(c)) };
        Misfit {
            coordinate_mm: self.model_mm,
            between_targets_mm: self.between_targets_mm,
            conditions: conditions.iter().map(of).collect(),
        }
    }

    /// Residuals of each quantity of the conditions, and their expected size.
    pub fn conditions(&self, robot: &dyn Robot, values: &[f64], conditions: &[Condition]) -> Vec<VerifiedQuantity> {
        let one = |found: ConditionResiduals| {
            let found = quantity_residuals(&found);
            let unit = physical_quantity(found.quantity);
            let model = unit.outward(self.model(found.quantity));
            VerifiedQuantity {
                quantity: found.quantity,
                unit: found.unit,
                count: found.count,
                rms: found.rms,
                expected_rms: found.standard_uncertainty.hypot(model),
            }
        };
        let all = ConditionResiduals::all(robot, values, conditions).into_iter();
        // values of joints are inputs of the model, and are compared before
        all.filter(|found| !found.kind.is_joint()).map(one).collect()
    }

    /// Model error of a quantity (mm or rad).
    fn model(&self, quantity: ErrorQuantity) -> f64 {
        self.conditions.iter().find(|(of, _)| *of == quantity).map_or(0.0, |(_, model)| *model)
    }
}

/// Quantity, angle or length, of the values of an error quantity.
fn physical_quantity(quantity: ErrorQuantity) -> Quantity {
    if quantity == ErrorQuantity::Orientation { Quantity::Angle } else { Quantity::Length }
}

/// Returns an error if the calibration has no residuals of the quantity of a condition.
pub fn unknown_quantity(document: &ParametersDocument, conditions: &[Condition]) -> Option<Message> {
    let is_known = |c: &&Condition| document.residuals.conditions.iter().any(|found| found.quantity == quantity(c));
    let unknown = conditions.iter().filter(|c| !matches!(c.kind, Kind::Joint(_))).find(|c| !is_known(c))?;
    Some(error!("verify-quantity-without-residuals", quantity = quantity(unknown).phrase()))
}

/// Standard uncertainty (rad) of the angles of a calibration, if it observed any: of orientations,
/// otherwise of joint values.
pub fn angle_uncertainty_rad(document: &ParametersDocument) -> Option<f64> {
    let residuals = &document.residuals;
    let orientation = residuals.conditions.iter().find(|found| found.quantity == ErrorQuantity::Orientation);
    let stated = orientation.map(|found| found.standard_uncertainty);
    stated.or(residuals.test.joint_value_standard_uncertainty_deg).map(|deg| Quantity::Angle.inward(deg))
}

/// Quantity that a condition observes.
fn quantity(condition: &Condition) -> ErrorQuantity {
    condition.kind.error_kind().map_or(ErrorQuantity::Orientation, Into::into)
}

/// Variance of residuals that their scatter estimates.
fn estimated(residuals: &ResidualSummary) -> Variance {
    let all = residuals.degrees_of_freedom as f64;
    let degrees = residuals.effective_degrees_of_freedom.unwrap_or(all);
    Variance::Misfit { degrees, share: degrees / all }
}

/// Share of the variance of the residuals that the stated uncertainties do not explain: 1 − ν/χ²,
/// zero if chi-square is at most its degrees of freedom ν. The calibration estimates it, whether or
/// not it is significant: a test that took a smaller variance than the calibration found would
/// reject unchanged robots more often than stated.
fn model_share(residuals: &ResidualSummary) -> f64 {
    let dof = residuals.degrees_of_freedom as f64;
    let share = |chi_square: f64| if dof > 0.0 && chi_square > dof { 1.0 - dof / chi_square } else { 0.0 };
    residuals.test.chi_square.map_or(0.0, share)
}

/// Model error of each quantity (standard deviation, mm or rad): residual variance minus the
/// variance of the observed values.
fn model_errors(residuals: &ResidualSummary) -> Vec<(ErrorQuantity, f64)> {
    let rows = residuals.count as f64 / residuals.degrees_of_freedom.max(1) as f64;
    let of_quantity = |found: &QuantityResiduals| {
        let unit = if found.unit == "deg" { Quantity::Angle } else { Quantity::Length };
        let excess = found.rms.powi(2) * rows - found.standard_uncertainty.powi(2);
        let model = if model_share(residuals) > 0.0 { excess.max(0.0).sqrt() } else { 0.0 };
        (found.quantity, unit.inward(model))
    };
    residuals.conditions.iter().map(of_quantity).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_documents::{PositionResiduals, ResidualKind, ResidualTest, UncertaintyFrom};

    const U_MM: f64 = 0.015;

    /// A calibration of coordinates with this chi-square; chi-square does not reject it.
    fn calibrated(chi_square: f64, degrees_of_freedom: usize) -> ExpectedDeviation {
        let count = degrees_of_freedom + 46;
        let rms = U_MM * (chi_square / count as f64).sqrt();
        let residuals = ResidualSummary {
            kind: ResidualKind::Targets,
            count,
            rms,
            position: PositionResiduals { position_rms_mm: Some(3f64.sqrt() * rms), ..PositionResiduals::default() },
            max: 3.0 * rms,
            degrees_of_freedom,
            effective_degrees_of_freedom: None,
            test: ResidualTest {
                stated_standard_uncertainty_mm: Some(U_MM),
                chi_square: Some(chi_square),
                ..ResidualTest::default()
            },
            uncertainties_from: UncertaintyFrom::Instrument,
            uncertainties_enlarged_by: 1.0,
            conditions: Vec::new(),
            between_series: None,
        };
        ExpectedDeviation::from_residuals(&residuals, 3, None).expect("a deviation")
    }

    /// Readings of an unchanged robot are as large as those of its calibration, whether or not
    /// chi-square rejected the stated uncertainty there.
    #[test]
    fn readings_that_scatter_as_in_the_calibration_are_seldom_rejected() {
        const LEVEL: f64 = 0.0253;
        let (degrees, rows, trials) = (494, 707, 400);
        let mut noise = Noise::new(24, 1);
        let mut square = |count: usize| (0..count).map(|_| noise.gaussian(1.0).powi(2)).sum::<f64>();
        let mut rejected = |factor: f64, later: f64| {
            let mut trial = || {
                let expected = calibrated(factor.powi(2) * square(degrees), degrees);
                let sum = (later * U_MM / expected.total_mm()).powi(2) * square(rows);
                expected.variance.exceedance_of_residuals(sum, rows) < LEVEL
            };
            (0..trials).filter(|_| trial()).count() as f64 / f64::from(trials)
        };
        for factor in [1.0, 1.07] {
            let alarms = rejected(factor, factor);
            assert!(alarms < 0.05, "{factor}: {alarms}");
            let found = rejected(factor, 1.3 * factor);
            assert!(found > 0.95, "{factor}: {found}");
        }
    }
}
