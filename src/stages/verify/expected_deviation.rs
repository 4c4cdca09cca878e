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
        let residuals = &document.residuals;
        let dof = residuals.degrees_of_freedom as f64;
        let conditions = model_errors(residuals);
        let rms_mm = residuals
            .position
            .position_rms_mm
            .map_or(residuals.rms, |rms_mm| rms_mm / (robot.dimension() as f64).sqrt());
        let shown_mm = rms_mm * (residuals.count as f64 / dof).sqrt();
        let excess = |shown_mm: f64, u: f64| (shown_mm.powi(2) - u.powi(2)).max(0.0).sqrt();
        let between = |u: f64| residuals.position.within_poses_rms_mm.map(|within_mm| excess(within_mm, u));
        let Some(u) = residuals.test.stated_standard_uncertainty_mm else {
            if dof == 0.0 || !shown_mm.is_finite() {
                return Err(error!("calibration-without-residuals").into());
            }
            let measured_mm = stated_mm.unwrap_or(shown_mm);
            return Ok(Self {
                measured_mm,
                model_mm: excess(shown_mm, measured_mm),
                between_targets_mm: between(measured_mm),
                variance: estimated(residuals),
                conditions,
            });
        };
        let u = u.hypot(residuals.test.common_standard_uncertainty_mm.unwrap_or(0.0));
        // only where chi-square rejects that the instrument explains all; other quantities have a
        // model error of their own
        let rejected = residuals.test.chi_square_rejected && dof > 0.0;
        let model_mm = if rejected { excess(shown_mm, u) } else { 0.0 };
        let variance = if model_mm > 0.0 { estimated(residuals) } else { Variance::Stated };
        let measured_mm = stated_mm.unwrap_or(u);
        Ok(Self { measured_mm, model_mm, between_targets_mm: between(u), variance, conditions })
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
        ConditionResiduals::all(robot, values, conditions).into_iter().map(one).collect()
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

/// Standard uncertainty (rad) of the orientations of a calibration, if it observed orientations.
pub fn orientation_uncertainty_rad(document: &ParametersDocument) -> Option<f64> {
    let found = document.residuals.conditions.iter().find(|found| found.quantity == ErrorQuantity::Orientation)?;
    Some(Quantity::Angle.inward(found.standard_uncertainty))
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

/// Model error of each quantity (standard deviation, mm or rad): residual variance minus the
/// variance of the observed values.
fn model_errors(residuals: &ResidualSummary) -> Vec<(ErrorQuantity, f64)> {
    let rows = residuals.count as f64 / residuals.degrees_of_freedom.max(1) as f64;
    let of_quantity = |found: &QuantityResiduals| {
        let unit = physical_quantity(found.quantity);
        let excess = found.rms.powi(2) * rows - found.standard_uncertainty.powi(2);
        let model = if residuals.test.chi_square_rejected { excess.max(0.0).sqrt() } else { 0.0 };
        (found.quantity, unit.inward(model))
    };
    residuals.conditions.iter().map(of_quantity).collect()
}
