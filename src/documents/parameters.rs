//! `parameters.json`: identified parameters with the evidence for them.

use super::{
    ErrorQuantity, Provenance, ReferencePose, Replicates, ResidualKind, Role, Termination, UncertaintyFrom,
    UncertaintySource,
};
use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::sketch::Sketch;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Identified parameters with the evidence for them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParametersDocument {
    /// Schema and version: `etalon/parameters/2`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Last day on which the parameters are valid, as the campaign gives it: year-month-day.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub valid_until: Option<String>,
    /// Explanation of synthetic data, as the campaign gives it; absent for measured data.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub synthetic: Option<String>,
    /// Links at base and ends of the kinematic chain; absent for a robot without a URDF, and in
    /// documents of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub links: Option<RobotLinks>,
    /// All parameters of the model.
    pub parameters: Vec<ParameterEntry>,
    /// Temperature (°C) to which lengths and zeros refer; absent if the model has no effects of the
    /// temperature.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference_temperature_c: Option<f64>,
    /// Positions of the flange by the nominal geometry, which are compared with a robot file that
    /// is given together with these parameters; absent in documents of earlier versions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reference_poses: Vec<ReferencePose>,
    /// Drawings of the model with its parameters; absent if the model provides none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sketches: Vec<Sketch>,
    /// Covariance of the identified parameters, in their order and units; empty if unknown.
    pub covariance: Vec<Vec<f64>>,
    /// Identified parameters of points (targets, sockets, planes) that `covariance` omits because
    /// there are 24 points or more. Each has its standard uncertainty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub covariance_without: Vec<String>,
    /// Contributions of each source to the standard uncertainties of these parameters (GUM 5.1.2).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub budget: Vec<BudgetSource>,
    /// Goodness of fit.
    pub residuals: ResidualSummary,
    /// Known lengths and positions of fixed points and rigid parts, with their residuals. Absent in
    /// documents of earlier versions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub known: Vec<KnownValue>,
    /// Reliability of readings, and influence of poses. Absent if readings have covariances of
    /// their own or common errors, if readings are poses instead of positions, or if there are many
    /// unknown points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reliability: Option<ReliabilitySummary>,
    /// Robust fit in addition to the least-squares fit. Absent if readings have common errors, if
    /// readings are poses instead of positions, if there are many unknown points, or without
    /// redundancy.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robust: Option<RobustSummary>,
    /// Observability; absent if not finite.
    pub observability: Option<ObservabilitySummary>,
    /// Solver and its termination.
    pub solver: SolverSummary,
    /// Mistakes of the set-up that the measurements do not show.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub untested: Vec<UntestedMistake>,
    /// Messages for the reader: held parameters with the reasons, warnings with remedies.
    pub messages: Vec<Message>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

/// Links of a URDF between which the parameters describe a kinematic chain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobotLinks {
    /// Link of the base frame.
    pub base: String,
    /// Link at the end of the chain, or of each branch.
    pub ends: Vec<String>,
    /// `true` if joints move the link of the base frame: a hand of a robot with two arms, for
    /// example.
    pub base_moves: bool,
}

impl ParametersDocument {
    /// Value of `schema`. In version 1, the angles of the base of an arm in modified
    /// Denavit-Hartenberg parameters were successive rotations; since version 2 they are a rotation
    /// vector, as for the other arms.
    pub const SCHEMA: &str = "etalon/parameters/2";

    /// Identified parameters in the covariance, in its order.
    pub fn identified(&self) -> impl Iterator<Item = &ParameterEntry> {
        let without: BTreeSet<&str> = self.covariance_without.iter().map(String::as_str).collect();
        let identified = self.parameters.iter().filter(|p| p.status == ParameterStatus::Identified);
        identified.filter(move |p| !without.contains(p.name.as_str()))
    }

    /// `true` if residuals exceed the given uncertainty of the instrument. Parameters then absorb
    /// unmodelled errors at the measured poses.
    pub fn misfits(&self) -> bool {
        use UncertaintyFrom::{Residuals, ResidualsByPose, ResidualsByRegion};
        let from_residuals =
            matches!(self.residuals.uncertainties_from, Residuals | ResidualsByPose | ResidualsByRegion);
        self.residuals.test.stated_standard_uncertainty_mm.is_some() && from_residuals
    }

    /// Unit as texts print it of the parameter with this name; `unit` if the document does not
    /// contain the parameter.
    pub fn printed_unit<'a>(&'a self, name: &str, unit: &'a str) -> &'a str {
        let entry = self.parameters.iter().find(|entry| entry.name == name);
        entry.map_or(unit, ParameterEntry::printed_unit)
    }

    /// Names of the robot's parameters that are effective rather than physical, because more than
    /// half of their variance is due to unmodelled errors. Without a budget all identified
    /// parameters are listed.
    pub fn effective(&self) -> Vec<&str> {
        if !self.misfits() {
            return Vec::new();
        }
        let of_model = self.budget.iter().find(|source| source.source == UncertaintySource::Model);
        let mostly = |k: usize, p: &ParameterEntry| match (of_model, p.standard_uncertainty) {
            (Some(of_model), Some(u)) => of_model.standard_uncertainties.get(k).is_some_and(|m| 2.0 * m * m > u * u),
            _ => self.budget.is_empty(),
        };
        let effective = self.identified().enumerate().filter(|(k, p)| p.role == Role::Robot && mostly(*k, p));
        effective.map(|(_, p)| p.name.as_str()).collect()
    }

    /// Checks that names, uncertainties and covariance are consistent.
    ///
    /// # Errors
    ///
    /// Returns a description of the first inconsistency.
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
    /// document.check().map_err(|inconsistency| inconsistency.to_string())?;
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
    pub fn check(&self) -> Result<(), Phrase> {
        let identified = self.identified().count();
        let rows = self.covariance.len();
        if rows != 0 && (rows != identified || self.covariance.iter().any(|row| row.len() != rows)) {
            return Err(phrase!("covariance-not-square", identified));
        }
        let variances = self.covariance.iter().enumerate().map(|(i, row)| row[i]);
        if !variances.chain(self.parameters.iter().filter_map(|p| p.standard_uncertainty)).all(|u| u >= 0.0) {
            return Err(phrase!("uncertainty-negative"));
        }
        let mut names: Vec<&str> = self.parameters.iter().map(|p| p.name.as_str()).collect();
        names.sort_unstable();
        match names.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(phrase!("parameter-listed-twice", parameter = pair[0])),
            None => Ok(()),
        }
    }
}

/// Mistake of the set-up that the measurements do not show: a robot within its tolerances explains
/// them with this change too.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UntestedMistake {
    /// Change of the set-up, in English.
    #[serde(flatten, with = "UntestedMistakeChange")]
    pub change: Worded,
    /// Standard deviation of a residual with the set-up as given (mm).
    pub stated_mm: f64,
    /// Standard deviation of a residual with the change (mm).
    pub changed_mm: f64,
    /// Largest change of the position of the flange at poses around the measured ones (mm).
    pub flange_mm: f64,
    /// Largest change of the orientation of the flange at these poses (deg).
    pub flange_deg: f64,
}

worded! {
    /// Change of the set-up, in English.
    text UntestedMistakeChange: change, change_phrase
}

/// Contribution of one source to the standard uncertainties.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BudgetSource {
    /// Source.
    pub source: UncertaintySource,
    /// Contributions to the standard uncertainty of each parameter, in the order and units of the
    /// covariance; the squares add up over all sources.
    pub standard_uncertainties: Vec<f64>,
    /// Basis of the contributions, for the source `nominal_values`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nominal: Option<NominalUncertainties>,
}

/// Standard uncertainties of nominal values before the measurements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NominalUncertainties {
    /// Standard uncertainty of the nominal value of each parameter: its tolerance / √3 (rectangular
    /// distribution, GUM 4.3.7), with a default tolerance multiplied by `tolerance_factor`. `null`
    /// for parameters without a nominal value.
    pub standard_uncertainties: Vec<Option<f64>>,
    /// Factor of default tolerances, at most 1: the data may show a more accurately built robot.
    pub tolerance_factor: f64,
}

/// One parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterEntry {
    /// Name as in the thesis.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Unit with the load or temperature to which the value refers: `deg/(100 N·m)`; absent if the
    /// value refers to neither.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub full_unit: Option<String>,
    /// Owner of the parameter: robot, base, target or fixture.
    #[serde(default)]
    pub role: Role,
    /// Meaning and sign of the parameter, in words.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub meaning: String,
    /// Id of the meaning in the catalogue of texts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub meaning_id: Option<String>,
    /// Nominal value.
    pub nominal: f64,
    /// Tolerance about the nominal value, if the robot's file contains one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Value before calibration, with only base and targets fitted.
    pub before: f64,
    /// Identified value, or value at which the parameter is held.
    pub value: f64,
    /// Standard uncertainty (k = 1); absent if not identified.
    pub standard_uncertainty: Option<f64>,
    /// Effective degrees of freedom of the standard uncertainty (GUM G.4.1), if it is estimated
    /// from residuals.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub degrees_of_freedom: Option<f64>,
    /// Share of the value that the data determined: 1 − (u/s)², where s is the standard uncertainty
    /// of the nominal value from its tolerance. Absent if nominal values are not used as
    /// observations.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub determined: Option<f64>,
    /// Identified, fixed or not identifiable.
    pub status: ParameterStatus,
    /// Parameters that cannot be separated from this parameter; if there are more than 99, the held
    /// one alone.
    pub confounded_with: Vec<String>,
}

impl ParameterEntry {
    /// Share of a value below which it comes mostly from the nominal value.
    pub const DETERMINED: f64 = 0.5;

    /// Unit as texts print it: with the load or temperature to which the value refers.
    pub fn printed_unit(&self) -> &str {
        self.full_unit.as_deref().unwrap_or(&self.unit)
    }

    /// `true` for an identified value that comes mostly from its nominal value.
    pub fn is_from_nominal(&self) -> bool {
        self.status == ParameterStatus::Identified && self.determined.is_some_and(|share| share < Self::DETERMINED)
    }
}

/// Origin of a parameter's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ParameterStatus {
    /// Identified by least squares.
    Identified,
    /// Held by the campaign, or not part of the model.
    Fixed,
    /// Held because it is not separately identifiable.
    NotIdentifiable,
    /// Target or fixture that no calibration pose shows: placed by readings of validation poses,
    /// with all identified parameters held.
    PlacedByValidation,
}

/// Residuals of the identification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResidualSummary {
    /// Residuals of targets or of the pose.
    pub kind: ResidualKind,
    /// Number of residuals: of measured values, one for each coordinate, distance or angle.
    pub count: usize,
    /// Root mean square (mm). Pose residuals mix mm and rad (thesis, eq. 3.26).
    pub rms: f64,
    /// Position residuals of targets.
    #[serde(flatten)]
    pub position: PositionResiduals,
    /// Largest absolute residual.
    pub max: f64,
    /// Degrees of freedom: `count` plus `stated_values` minus `determined_parameters`, rounded.
    pub degrees_of_freedom: usize,
    /// Effective degrees of freedom of the residual variance, by the scatter of the squares from
    /// pose to pose. Squares of a smooth misfit scatter more than squares of noise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub effective_degrees_of_freedom: Option<f64>,
    /// Test of the residuals against the given uncertainty and against repeats.
    #[serde(flatten)]
    pub test: ResidualTest,
    /// Basis of the standard uncertainties.
    pub uncertainties_from: UncertaintyFrom,
    /// Median ratio of the standard uncertainties to the uncertainties from the instrument alone.
    /// Without a given uncertainty of the instrument, to the uncertainties from independent
    /// residuals.
    pub uncertainties_enlarged_by: f64,
    /// Residuals of each quantity other than coordinates of targets.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub conditions: Vec<QuantityResiduals>,
    /// Scatter of the parameters between the series of the campaign (`series` in campaign.toml),
    /// beyond the scatter between regions of the workspace. Absent for one series.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub between_series: Option<SeriesScatter>,
}

/// Known length or position that counts like a measured value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KnownValue {
    /// Two points, the parameter, or the surface.
    pub name: String,
    /// Position (mm) of a point of a surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place_mm: Option<Vector>,
    /// `distance`, `coordinate` or `surface`.
    #[schemars(with = "String")]
    pub quantity: ErrorQuantity,
    /// Stated value (mm); absent for a point of a surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stated_mm: Option<f64>,
    /// Standard uncertainty (mm).
    pub standard_uncertainty_mm: f64,
    /// Identified minus stated value (mm).
    pub residual_mm: f64,
}

/// Position residuals of targets.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PositionResiduals {
    /// Root mean square of the position residuals of targets (mm); absent without positions of
    /// targets, and for pose residuals.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position_rms_mm: Option<f64>,
    /// Root mean square of the position residuals before identification (mm): nominal parameters,
    /// with only base and targets fitted. Absent like `position_rms_mm`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position_rms_before_mm: Option<f64>,
    /// Residuals of the coordinates of targets with their stated uncertainty; absent without
    /// coordinates or a stated uncertainty, and in documents of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coordinates: Option<QuantityResiduals>,
    /// Root mean square (mm) of a coordinate's residual from the mean over the targets of its pose,
    /// n − 1 for n targets. Absent where no pose shows several targets.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within_poses_rms_mm: Option<f64>,
    /// Growth of the errors of predictions beyond the measured values of joints. Empty if the
    /// instrument explains the residuals, and with fewer than 16 poses.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub extrapolation: Vec<JointExtrapolation>,
}

/// Test of residuals against the given uncertainty and against repeats.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ResidualTest {
    /// Given standard uncertainty of one coordinate (mm): of the contact if given separately,
    /// otherwise of the instrument.
    pub stated_standard_uncertainty_mm: Option<f64>,
    /// Standard uncertainty common to all observations of the same coordinates (mm): of the
    /// instrument, if the uncertainty of the contact is given separately.
    pub common_standard_uncertainty_mm: Option<f64>,
    /// Given standard uncertainty (deg) of observed values of revolute joints, such as values of
    /// second encoders; absent without such observations.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint_value_standard_uncertainty_deg: Option<f64>,
    /// Number of stated values that count like measured values: shapes of rigid parts, and
    /// positions and lengths of fixed points.
    #[serde(default)]
    pub stated_values: usize,
    /// Number of identified parameters that the data determine: each counts by the share that its
    /// tolerance leaves to the data. Absent in documents of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub determined_parameters: Option<f64>,
    /// Chi-square with both stated uncertainties.
    pub chi_square: Option<f64>,
    /// `true` if chi-square rejects the hypothesis that measurement noise explains the residuals,
    /// at a significance level of 0.1 %.
    #[serde(default)]
    pub chi_square_rejected: bool,
    /// Scatter of repeats against the other residuals; absent without repeated poses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeats: Option<Replicates>,
}

/// Scatter between series.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SeriesScatter {
    /// Number of series.
    pub series: usize,
    /// Share of the variances of the parameters, in the mean.
    pub share: f64,
}

/// Growth of the errors of predictions beyond the measured values of a joint. It is estimated by
/// predicting one half of the joint's values from the other half.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointExtrapolation {
    /// Joint, named as a column with its unit: `q2_deg`.
    pub joint: String,
    /// Smallest measured value (unit of the joint).
    pub low: f64,
    /// Largest measured value.
    pub high: f64,
    /// Distance beyond these values at which the excess variances apply. Their square roots grow
    /// with the distance.
    pub distance: f64,
    /// Excess variance of a coordinate, relative to the residual variance of a coordinate.
    pub position: f64,
    /// Excess variance of an orientation, relative to the residual variance of an orientation.
    pub orientation: f64,
}

/// Residuals of the observations of one quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuantityResiduals {
    /// `position`, `orientation`, `distance`, `surface`, `contact`, `coordinate` or `joint`.
    #[schemars(with = "String")]
    pub quantity: ErrorQuantity,
    /// Unit of the residuals: `mm` or `deg`.
    pub unit: String,
    /// Number of residuals.
    pub count: usize,
    /// Root mean square of the residuals.
    pub rms: f64,
    /// Root mean square of the standard uncertainties of the observed values.
    pub standard_uncertainty: f64,
}

impl ResidualSummary {
    /// Residuals over the given uncertainty, √(χ²/ν); `None` without a given uncertainty or without
    /// redundancy.
    pub fn times_uncertainty(&self) -> Option<f64> {
        let times = (self.test.chi_square? / self.degrees_of_freedom as f64).sqrt();
        times.is_finite().then_some(times)
    }

    /// Significance level at which chi-square rejects the model.
    pub const SIGNIFICANCE: f64 = etalon_identify::CHI_SQUARE_SIGNIFICANCE;

    /// Probability of a chi-square at least this large if noise alone causes the residuals; `None`
    /// without a given uncertainty or without redundancy.
    pub fn p_value(&self) -> Option<f64> {
        etalon_identify::chi_square_probability(self.test.chi_square?, self.degrees_of_freedom)
    }

    /// Agreement of the model with the residuals; `None` without a given uncertainty or without
    /// redundancy.
    pub fn model_fit(&self) -> Option<ModelFit> {
        let p = self.p_value()?;
        Some(match self.uncertainties_from {
            _ if self.test.chi_square_rejected => ModelFit::Incomplete,
            UncertaintyFrom::ResidualsByPose | UncertaintyFrom::ResidualsByRegion => ModelFit::Correlated,
            _ if p < DOUBTFUL => ModelFit::Doubtful,
            _ => ModelFit::Fits,
        })
    }
}

/// Probability of chi-square below which the model is doubtful, although not rejected.
const DOUBTFUL: f64 = 0.05;

/// Agreement of a model with the residuals of its calibration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelFit {
    /// Noise explains the residuals.
    Fits,
    /// Noise explains the residuals in less than one of twenty campaigns; chi-square does not
    /// reject the model.
    Doubtful,
    /// Chi-square does not reject the model, but residuals of one pose are correlated.
    Correlated,
    /// Chi-square rejects the model.
    Incomplete,
}

/// Reliability of the readings (Baarda 1968), and influence of the poses (Cook 1977).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReliabilitySummary {
    /// Significance level α0 of the test of one residual.
    pub significance: f64,
    /// Power β0 with which an error of detectable size is detected.
    pub power: f64,
    /// Standard deviation σ of a coordinate (mm): the given one if it explains the residuals,
    /// otherwise estimated from the residuals.
    pub sigma_mm: f64,
    /// Number of measured positions.
    pub readings: usize,
    /// Smallest redundancy number r of a coordinate: share of an error of the coordinate that its
    /// residual shows (0 to 1).
    pub least_redundancy: f64,
    /// Smallest detectable error of a coordinate, 4.13 σ / √r (mm): median over the readings.
    pub median_detectable_mm: Option<f64>,
    /// Largest of the smallest detectable errors (mm); absent if a reading is uncontrolled.
    pub largest_detectable_mm: Option<f64>,
    /// Normalised residual (residual over its standard deviation σ √r) beyond which a reading is an
    /// outlier.
    pub critical_w: f64,
    /// Number of readings beyond `critical_w`.
    pub beyond: usize,
    /// Cook's distance beyond which a pose is influential: the median of the F distribution.
    pub influential: f64,
    /// Poses whose omission changes the parameters most.
    pub poses: Vec<InfluenceEntry>,
}

/// Change of the identification if a pose is omitted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InfluenceEntry {
    /// Pose.
    pub pose: PoseName,
    /// Cook's distance of all readings of the pose; absent if the other poses do not determine all
    /// parameters.
    pub cooks_distance: Option<f64>,
    /// Parameter with the largest change relative to its standard uncertainty from the residuals.
    pub parameter: String,
    /// Change of the parameter over its standard uncertainty.
    pub change_over_u: f64,
}

/// Robust fit in addition to the least-squares fit: an M-estimator with Cauchy loss that starts at
/// the least-squares optimum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobustSummary {
    /// Constant c of the loss c² ln(1 + (r / c σ)²). With c = 2.385 the variance of parameters is 5
    /// % larger than by least squares if residuals are normal.
    pub constant: f64,
    /// Standard deviation σ of a coordinate (mm): from the median residual, but at least the given
    /// one.
    pub sigma_mm: f64,
    /// Identified parameters in both fits.
    pub parameters: Vec<RobustParameter>,
    /// Critical value of `difference_over_u`: with a probability of 99 % no parameter exceeds this
    /// value if all readings are correct.
    pub critical: f64,
    /// Poses of smallest weight, ascending.
    pub poses: Vec<RobustPose>,
    /// Critical value of a residual over σ: with a probability of 99 % no residual exceeds this
    /// value if all readings are correct.
    pub critical_residual: f64,
    /// Number of poses with a residual beyond the critical value.
    pub disagreeing: usize,
}

/// A parameter in the least-squares fit and in the robust fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobustParameter {
    /// Name of the parameter.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Value of the robust fit.
    pub value: f64,
    /// Robust minus least-squares value.
    pub difference: f64,
    /// Difference over its standard uncertainty if all readings are correct. For normal residuals
    /// that is √(1/0.95 − 1) = 0.23 of the standard uncertainty of the parameter.
    pub difference_over_u: f64,
}

/// Weight of a pose in the robust fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobustPose {
    /// Pose.
    pub pose: PoseName,
    /// Smallest weight of the pose's residuals, 1 / (1 + (r / c σ)²) (0 to 1).
    pub weight: f64,
    /// Residual of smallest weight, over σ.
    pub residual_over_sigma: f64,
}

/// Observability of the parameters from the poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObservabilitySummary {
    /// O1 = (σ1…σm)^(1/m) / √n for m parameters and n poses (Sun & Hollerbach 2008).
    pub o1: f64,
    /// O2 = σmin / σmax (thesis, eq. 1.20).
    pub o2: f64,
    /// O3 = σmin (thesis, eq. 1.22).
    pub o3: f64,
    /// O4 = σmin² / σmax (thesis, eq. 1.23).
    pub o4: f64,
    /// O5 = 1 / Σ 1/σ (thesis, eq. 1.25).
    pub o5: f64,
    /// Condition number with columns scaled to unit length.
    pub condition: f64,
    /// Number of separately identifiable parameters.
    pub rank: usize,
    /// Scaling of the indices.
    #[serde(flatten, with = "ObservabilitySummaryScaling")]
    pub scaling: Worded,
    /// Singular values of the Jacobian at the solution, descending, with columns scaled to unit
    /// length. The ratio of the largest to the smallest is the condition number; the squares add up
    /// to the number of parameters.
    #[serde(default)]
    pub singular_values: Vec<SingularValueEntry>,
    /// Smallest singular values of the Jacobian with all parameters that were to be identified.
    /// There is one for each parameter that is held because the data determine it poorly or not at
    /// all; empty in a plan.
    #[serde(default)]
    pub held_singular_values: Vec<SingularValueEntry>,
    /// Rank tolerance: a parameter is held if its column, scaled to unit length, is closer than
    /// this to the span of the columns before it.
    #[serde(default)]
    pub rank_cut: f64,
}

worded! {
    /// Scaling of the indices.
    text ObservabilitySummaryScaling: scaling, scaling_phrase
}

/// Sensitivity of the residuals to one direction of the parameters; small if the direction is
/// poorly observable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SingularValueEntry {
    /// Singular value (dimensionless).
    pub value: f64,
    /// Parameters with a component above 0.3 in the right singular vector, the largest first; empty
    /// if the direction is spread over many parameters.
    pub parameters: Vec<String>,
}

/// Solver and its termination.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolverSummary {
    /// Algorithm.
    #[serde(flatten, with = "SolverSummaryMethod")]
    pub method: Worded,
    /// Number of steps.
    pub iterations: usize,
    /// Reason of the termination.
    pub termination: Termination,
    /// Reason of the termination in words.
    pub meaning: String,
}

worded! {
    /// Algorithm.
    text SolverSummaryMethod: method, method_phrase
}
