//! `parameters.json`: identified parameters with all that is needed to judge them.

use super::{Provenance, Replicates, ResidualKind, Role, Termination, UncertaintyFrom, UncertaintySource};
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::sketch::Sketch;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Identified parameters with all that is needed to trust them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParametersDocument {
    /// `etalon/parameters/2`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// All parameters of the model.
    pub parameters: Vec<ParameterEntry>,
    /// Drawings of the model with its parameters; absent where the model has none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sketches: Vec<Sketch>,
    /// Covariance of the identified parameters, in their order and units; empty where there is none.
    pub covariance: Vec<Vec<f64>>,
    /// Identified parameters of points (targets, sockets, planes) of which the covariance is left out, because they are many: 24 points
    /// and more. Each has its standard uncertainty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub covariance_without: Vec<String>,
    /// What the standard uncertainties of these parameters are made of, source by source (GUM 5.1.2).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub budget: Vec<BudgetSource>,
    /// How well they fit.
    pub residuals: ResidualSummary,
    /// How well readings control each other, and which poses decide; absent where readings are weighted by covariances of their own, have errors in
    /// common, are poses instead of positions, or unknown points are many.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reliability: Option<ReliabilitySummary>,
    /// A robust fit beside the plain one; absent where readings have errors in common, are poses instead of positions, unknown points are
    /// many, or nothing is left over.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robust: Option<RobustSummary>,
    /// Observability; absent where it is not a number.
    pub observability: Option<ObservabilitySummary>,
    /// How the solver ended.
    pub solver: SolverSummary,
    /// Rules and remarks that a reader must know: which parameters were held and why, warnings with remedies.
    pub messages: Vec<Message>,
    /// Where the numbers come from.
    pub provenance: Provenance,
}

impl ParametersDocument {
    /// What `schema` states. In `/1` the angles of the base of an arm in modified Denavit-Hartenberg parameters were successive turns; since
    /// `/2` they are a rotation vector, as those of the other arms.
    pub const SCHEMA: &str = "etalon/parameters/2";

    /// The identified parameters that the covariance has, in its order.
    pub fn identified(&self) -> impl Iterator<Item = &ParameterEntry> {
        let without: BTreeSet<&str> = self.covariance_without.iter().map(String::as_str).collect();
        let identified = self.parameters.iter().filter(|p| p.status == ParameterStatus::Identified);
        identified.filter(move |p| !without.contains(p.name.as_str()))
    }

    /// Whether names, uncertainties and covariance belong together, as every run writes them.
    ///
    /// # Errors
    /// What does not.
    ///
    /// # Examples
    ///
    /// ```
    /// use etalon_documents::ParametersDocument;
    ///
    /// # let json = r#"{
    /// #     "schema": "etalon/parameters/2", "robot": "five_bar",
    /// #     "parameters": [{
    /// #         "name": "d", "unit": "mm", "nominal": 275.0, "before": 275.0, "value": 274.8051,
    /// #         "standard_uncertainty": 0.001, "status": "identified", "confounded_with": []
    /// #     }],
    /// #     "residuals": {
    /// #         "kind": "targets", "count": 9, "degrees_of_freedom": 8, "rms": 1e-3, "max": 2e-3,
    /// #         "uncertainties_from": "instrument", "uncertainties_enlarged_by": 1.0
    /// #     },
    /// #     "solver": {
    /// #         "method": "", "iterations": 3, "termination": "step_vanished", "meaning": ""
    /// #     },
    /// #     "covariance": [[1e-6]], "messages": [],
    /// #     "provenance": { "version": "0.1.0", "inputs": {} }
    /// # }"#;
    /// // text of a parameters.json: the distance `d` of two motors is 274.8051 mm, u = 1 µm
    /// let document: ParametersDocument = serde_json::from_str(json)?;
    /// document.check()?;
    ///
    /// let d = document.identified().next().expect("one parameter was identified");
    /// assert_eq!((d.name.as_str(), d.unit.as_str()), ("d", "mm"));
    /// let correction_mm = d.value - d.nominal;
    /// assert!((correction_mm + 0.1949).abs() < 1e-12);
    ///
    /// // the covariance is in the units of the parameters: mm²
    /// assert!((document.covariance[0][0].sqrt() - 0.001).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check(&self) -> Result<(), String> {
        let identified = self.identified().count();
        let rows = self.covariance.len();
        if rows != 0 && (rows != identified || self.covariance.iter().any(|row| row.len() != rows)) {
            return Err(format!("its covariance is not square with {identified} rows, one an identified parameter"));
        }
        let variances = self.covariance.iter().enumerate().map(|(i, row)| row[i]);
        if !variances.chain(self.parameters.iter().filter_map(|p| p.standard_uncertainty)).all(|u| u >= 0.0) {
            return Err("a standard uncertainty or variance is negative or not a number".to_owned());
        }
        let mut names: Vec<&str> = self.parameters.iter().map(|p| p.name.as_str()).collect();
        names.sort_unstable();
        match names.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(format!("it holds the parameter `{}` twice", pair[0])),
            None => Ok(()),
        }
    }
}

/// What one source contributes to the standard uncertainties.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BudgetSource {
    /// The source.
    pub source: UncertaintySource,
    /// Its contribution to the standard uncertainty of each parameter, in the order and units of the covariance: their squares add up.
    pub standard_uncertainties: Vec<f64>,
}

/// One parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterEntry {
    /// Name as in the thesis.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Whether it belongs to the robot, its base, a target or a fixture.
    #[serde(default)]
    pub role: Role,
    /// What it is and which sign it has, in words.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub meaning: String,
    /// Nominal value.
    pub nominal: f64,
    /// How far from nominal it may be by the robot's file, where that states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Value with only base and targets fitted: the robot before its calibration.
    pub before: f64,
    /// Identified value, or the value at which it is held.
    pub value: f64,
    /// Standard uncertainty (k = 1); absent where not identified.
    pub standard_uncertainty: Option<f64>,
    /// Effective degrees of freedom of that (GUM G.4.1), where it is estimated from residuals.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub degrees_of_freedom: Option<f64>,
    /// Share of the value that the data determined: 1 − (u/s)², s the standard uncertainty of the nominal value by its tolerance; absent
    /// where nominal values were no readings.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub determined: Option<f64>,
    /// Identified, fixed or not identifiable.
    pub status: ParameterStatus,
    /// Parameters that are not separately identifiable from this one; where they are more than 99, the one that is held.
    pub confounded_with: Vec<String>,
}

/// Why a parameter has its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ParameterStatus {
    /// Found by least squares.
    Identified,
    /// Held by the campaign, or not part of the model.
    Fixed,
    /// Held because it is not separately identifiable.
    NotIdentifiable,
    /// Of a target or fixture that no calibration pose shows: placed by readings of validation poses, with all identified parameters held.
    PlacedByValidation,
}

/// Residuals of the identification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResidualSummary {
    /// Residuals of targets or of the pose.
    pub kind: ResidualKind,
    /// Number of residuals.
    pub count: usize,
    /// Root mean square in mm (pose residuals: mm and rad mixed, eq. 3.26).
    pub rms: f64,
    /// Largest.
    pub max: f64,
    /// Residuals minus identified parameters.
    pub degrees_of_freedom: usize,
    /// Standard uncertainty of one coordinate that is stated, in mm: the instrument's, or the contact's where that is
    /// stated apart.
    pub stated_standard_uncertainty_mm: Option<f64>,
    /// Standard uncertainty in mm that observations of the very same coordinates have in common beside that: the
    /// instrument's, where the contact's is stated apart.
    pub common_standard_uncertainty_mm: Option<f64>,
    /// Chi-square against both.
    pub chi_square: Option<f64>,
    /// Whether chi-square rejects that the measurement explains the residuals: a right model is rejected once in a thousand times.
    #[serde(default)]
    pub chi_square_rejected: bool,
    /// Scatter of repeats against the rest; absent where no pose was repeated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeats: Option<Replicates>,
    /// What standard uncertainties rest on.
    pub uncertainties_from: UncertaintyFrom,
    /// By how much standard uncertainties are larger than the instrument's alone makes them (median); 1 where chi-square
    /// does not reject the model, or no uncertainty is stated.
    pub uncertainties_enlarged_by: f64,
}

/// How well the readings control each other (Baarda 1968), and which poses decide (Cook 1977).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReliabilitySummary {
    /// Significance level α0 of the test of one residual.
    pub significance: f64,
    /// Power β0 with which an error is detected that is called detectable.
    pub power: f64,
    /// Standard deviation σ of a coordinate: the stated one where that explains the residuals, or theirs, mm.
    pub sigma_mm: f64,
    /// Measured positions.
    pub readings: usize,
    /// Least redundancy number r of a coordinate: the share of its error that its residual shows, from 0 to 1.
    pub least_redundancy: f64,
    /// Least error of a coordinate that is detected, 4.13 σ / √r: median over the readings, mm.
    pub median_detectable_mm: Option<f64>,
    /// The largest; absent where nothing controls a reading, mm.
    pub largest_detectable_mm: Option<f64>,
    /// Residual over its standard deviation σ √r beyond which a reading is an outlier.
    pub critical_w: f64,
    /// Readings beyond it.
    pub beyond: usize,
    /// Cook's distance beyond which a pose is influential: the median of F.
    pub influential: f64,
    /// The poses without which the parameters would change most.
    pub poses: Vec<InfluenceEntry>,
}

/// What the identification would change by without a pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InfluenceEntry {
    /// The pose.
    pub pose: PoseName,
    /// Cook's distance of all its readings; absent where the other poses do not determine all parameters.
    pub cooks_distance: Option<f64>,
    /// The parameter that changes most over its standard uncertainty by the residuals.
    pub parameter: String,
    /// Its change, over that.
    pub change_over_u: f64,
}

/// A fit in which readings far from the others weigh little (M-estimator with the Cauchy loss, from the plain optimum), beside the plain one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobustSummary {
    /// Constant c of the loss c² ln(1 + (r / c σ)²): with 2.385 the variance of parameters is 5 % more where residuals are normal.
    pub constant: f64,
    /// Standard deviation σ of a coordinate by the median residual, or the stated one where that is more, mm.
    pub sigma_mm: f64,
    /// The identified parameters in both fits.
    pub parameters: Vec<RobustParameter>,
    /// A difference over its standard uncertainty that none of them exceeds with a probability of 99 %, where no reading is wrong.
    pub critical: f64,
    /// The poses of the least weight, the least first.
    pub poses: Vec<RobustPose>,
    /// A residual over σ that none of them all exceeds with a probability of 99 %, where no reading is wrong.
    pub critical_residual: f64,
    /// Poses with a residual beyond it.
    pub disagreeing: usize,
}

/// A parameter by the plain fit and by the robust one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobustParameter {
    /// Its name.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Value by the robust fit.
    pub value: f64,
    /// Robust minus plain value.
    pub difference: f64,
    /// The difference over its standard uncertainty where no reading is wrong: of normal residuals √(1/0.95 − 1) = 0.23 of that of the parameter.
    pub difference_over_u: f64,
}

/// What the robust fit makes of a pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobustPose {
    /// The pose.
    pub pose: PoseName,
    /// Least weight of its residuals, 1 / (1 + (r / c σ)²), from 0 to 1.
    pub weight: f64,
    /// The residual that has it, over σ.
    pub residual_over_sigma: f64,
}

/// Observability of the parameters from the poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObservabilitySummary {
    /// O1 = (σ1…σm)^(1/m) / √n, m parameters and n poses (Sun & Hollerbach 2008).
    pub o1: f64,
    /// O2 = σmin / σmax (eq. 1.20).
    pub o2: f64,
    /// O3 = σmin (eq. 1.22).
    pub o3: f64,
    /// O4 = σmin² / σmax (eq. 1.23).
    pub o4: f64,
    /// O5 = 1 / Σ 1/σ (eq. 1.25).
    pub o5: f64,
    /// Condition number with columns divided by their norms.
    pub condition: f64,
    /// Number of separately identifiable parameters.
    pub rank: usize,
    /// Which scaling the indices have.
    pub scaling: String,
    /// Singular values behind the condition number, descending: of the Jacobian at the solution, its columns divided by
    /// their norms, as the identification uses it. Their squares add up to the number of parameters.
    #[serde(default)]
    pub singular_values: Vec<SingularValueEntry>,
    /// Of the same Jacobian with all parameters that were to be identified the smallest, as many as are held because the
    /// data do not determine them, or hardly; empty in a plan.
    #[serde(default)]
    pub held_singular_values: Vec<SingularValueEntry>,
    /// A column that lies this near to the span of those before it, for a norm of 1, is cut: its parameter is held.
    #[serde(default)]
    pub rank_cut: f64,
}

/// How strongly the residuals answer to one direction of the parameters: small where it is badly observable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SingularValueEntry {
    /// The singular value, without unit.
    pub value: f64,
    /// Parameters with a share of more than 0.3 in its right singular vector, the largest first; empty where the direction
    /// is spread over many.
    pub parameters: Vec<String>,
}

/// How the solver ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolverSummary {
    /// Algorithm.
    pub method: String,
    /// Steps taken.
    pub iterations: usize,
    /// Why it stopped.
    pub termination: Termination,
    /// The same in words.
    pub meaning: String,
}
