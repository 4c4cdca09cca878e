//! Keys of `campaign.toml`.

use super::{Join, JoinBy, StatedPoses, TableDefinition};
use etalon_base::country::Country;
use etalon_base::date::{date, date_text, months_after};
use etalon_base::pose::{Vector, minus, norm, unit};
use etalon_documents::{Conditions, DecisionRule, Effect, Language, LimitQuantity};
use etalon_documents::{ResidualKind, ToolFrame};
use etalon_formats::{Export, Log, TableReading};
use etalon_identify::{Effects, Prior, RigidPart, ToolPoint};
use etalon_tables::{Constant, TableLayout};
use schemars::JsonSchema;
use serde::de::{self, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;
use toml::Spanned;

/// Contents of `campaign.toml`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CampaignFile {
    /// Name of the campaign, the title of its report. By default composed of the kind of campaign,
    /// the robot and the date.
    #[serde(default)]
    pub name: String,
    /// File of the robot (robot.toml). Only tests of commanded poses, recorded motions and static
    /// compliance need none.
    #[serde(default = "unstated")]
    #[schemars(with = "String")]
    pub robot: Spanned<String>,
    /// Folder for the documents, which is replaced as a whole.
    #[serde(default = "default_output")]
    #[schemars(with = "String")]
    pub output: Spanned<String>,
    /// Explanation of synthetic data; only for data that were not measured. Every report repeats
    /// it.
    pub synthetic: Option<String>,
    /// Remarks for the report.
    pub notes: Option<String>,
    /// Date of the measurements (ISO 8601), as the report prints it.
    pub date: Option<String>,
    /// Last day on which the calibration is valid, as the laboratory gives it: year-month-day.
    pub valid_until: Option<String>,
    /// Number of months for which the calibration is valid, from the `date` of the measurements; in
    /// place of `valid_until`.
    pub valid_for_months: Option<u32>,
    /// Upper limit for the expanded uncertainty (k = 2) of parameters to load: a length, an angle,
    /// or both ("0.5 mm, 0.1 deg"). It applies to base and targets, and to parameters without
    /// tolerance. By default ten times the uncertainty of a coordinate, at least 2 % and at most
    /// 5 % of the measured extent. For angles it is this share in radians, at least 0.5 %.
    #[schemars(with = "Option<String>")]
    pub uncertainty_bound: Option<Spanned<String>>,
    /// Name of the operator.
    pub operator: Option<String>,
    /// Temperature during the measurements.
    pub temperature_c: Option<f64>,
    /// Conditions of a test, for the report.
    #[serde(default)]
    pub conditions: Conditions,
    /// Measuring instrument.
    pub instrument: Instrument,
    /// Repeatability of the robot in returning to a measured point, if points are measured once and
    /// touched repeatedly. The instrument's error of a point is then common to all its
    /// observations.
    pub contact: Option<Contact>,
    /// Thermal expansion, for the uncertainty of lengths.
    pub expansion: Option<Expansion>,
    /// Repeatability of homing.
    pub homing: Option<Homing>,
    /// Files of the measuring system.
    #[serde(default, rename = "export")]
    pub exports: Vec<Export>,
    /// Targets on one rigid part.
    #[serde(default, rename = "rigid")]
    pub rigid: Vec<Rigid>,
    /// Stationary targets that are measured repeatedly.
    #[serde(default)]
    pub fixed: Vec<Fixed>,
    /// Logs of the controller. The first log is used for identification; others are compared with
    /// it.
    #[serde(default, rename = "log", deserialize_with = "one_or_many")]
    #[schemars(schema_with = "one_or_many_logs")]
    pub logs: Vec<Log>,
    /// Assignment of points to joint values.
    pub join: Option<Join>,
    /// Tables of observations, instead of exports, log and join.
    #[serde(default, deserialize_with = "one_or_many")]
    #[schemars(schema_with = "one_or_many_observations")]
    pub observations: Vec<ObservationsDefinition>,
    /// Elements to fit, by name.
    #[serde(default, rename = "feature")]
    pub features: BTreeMap<String, FeatureDefinition>,
    /// Frames; without this section, the coordinates of the exports are world coordinates.
    pub frame: Option<Frames>,
    /// Tool point, which programs move to their targets; its expected error is reported in addition
    /// to the errors of the measured targets.
    pub tool: Option<ToolDefinition>,
    /// Identification; absent in a test to ISO 9283 alone.
    pub identify: Option<Identify>,
    /// Geometric calibration of a PreXYT (thesis, chapter 2).
    pub geometric: Option<super::GeometricDefinition>,
    /// Test of repeatability from labelled points (thesis, 2.4).
    pub repeatability: Option<super::RepeatabilityDefinition>,
    /// Test to ISO 9283 from tables of poses.
    pub poses: Option<super::PosesDefinition>,
    /// Test of static compliance: a table `direction,cycle,force_n,x_mm,y_mm[,z_mm]`, with a row of
    /// force 0 in each direction and cycle.
    #[schemars(with = "Option<super::TableKeys>")]
    pub compliance: Option<TableDefinition>,
    /// Recorded motions.
    #[serde(default, rename = "stream")]
    pub streams: Vec<super::StreamDefinition>,
    /// Limits for the result; the exit code is 1 if a limit is not met.
    #[serde(default)]
    pub limits: Limits,
    /// Language, logo and templates of the report.
    #[serde(default)]
    pub report: ReportDefinition,
    /// Formats of the controller files to write, and templates `NAME.j2` of formats of your own.
    #[schemars(with = "Option<Vec<String>>", extend("default" = ["json", "csv", "c-header"]))]
    pub controllers: Option<Vec<Spanned<String>>>,
}

impl CampaignFile {
    /// Last day on which the calibration is valid, as given or by the given number of months:
    /// year-month-day.
    pub fn valid_until(&self) -> Option<String> {
        let by_months = || Some(date_text(months_after(date(self.date.as_deref()?)?, self.valid_for_months?)));
        self.valid_until.clone().or_else(by_months)
    }

    /// Given dates of past events, with their keys.
    pub fn dates(&self) -> impl Iterator<Item = (&'static [&'static str], &String)> {
        let all: [(&'static [&'static str], &Option<String>); 3] = [
            (&["date"], &self.date),
            (&["report", "issued"], &self.report.issued),
            (&["conditions", "robot_received"], &self.conditions.robot.received),
        ];
        all.into_iter().filter_map(|(key, date)| Some((key, date.as_ref()?)))
    }

    /// `true` if the campaign names the file of its robot.
    pub fn states_robot(&self) -> bool {
        !self.robot.get_ref().is_empty() || !self.robot.span().is_empty()
    }

    /// Definition of the world frame.
    pub fn world(&self) -> Option<&WorldDefinition> {
        Some(&self.frame.as_ref()?.world)
    }

    /// Key of the join.
    pub fn join_by(&self) -> Option<JoinBy> {
        Some(self.join.as_ref()?.by)
    }

    /// Targets named in `[join]`; empty if none are named.
    pub fn join_targets(&self) -> impl Iterator<Item = &Spanned<String>> + Clone {
        self.join.iter().flat_map(|join| join.targets.iter().flatten())
    }

    /// All files of measurements, and of data for comparison, that the campaign names.
    pub fn inputs(&self) -> impl Iterator<Item = &Spanned<String>> {
        let measured = self.exports.iter().map(|e| &e.file).chain(self.logs.iter().map(|l| &l.file));
        let measured = measured.chain(self.observations.iter().map(|o| &o.file));
        let streams = self.streams.iter().flat_map(|s| [s.commanded.as_ref(), s.path.as_ref()]);
        let poses = self.poses.iter().flat_map(|p| [Some(&p.attained), Some(&p.commanded), p.reference.as_ref()]);
        let others = [self.repeatability.as_ref().and_then(|r| r.commanded.as_ref()), self.compliance.as_ref()];
        let tables = streams.chain(poses).chain(others).flatten().flat_map(TableDefinition::files);
        measured.chain(self.streams.iter().map(|s| &s.file)).chain(tables)
    }
}

/// A file that is not stated.
fn unstated() -> Spanned<String> {
    Spanned::new(0..0, String::new())
}

fn default_output() -> Spanned<String> {
    Spanned::new(0..0, "out".to_owned())
}

/// Measuring instrument.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Instrument {
    /// Name of the instrument, for the report.
    pub name: String,
    /// Expanded uncertainty of one coordinate.
    pub expanded_uncertainty_um: f64,
    /// Coverage factor of the instrument's expanded uncertainties.
    pub coverage_factor: f64,
    /// Expanded uncertainty of a measured position, with the same coverage factor; by default √3
    /// times the uncertainty of a coordinate (planar robots: √2).
    pub expanded_position_uncertainty_um: Option<f64>,
    /// Expanded uncertainty of a measured orientation about any axis, with the same coverage
    /// factor.
    pub expanded_rotation_uncertainty_deg: Option<f64>,
    /// Expanded uncertainty of the scale, with the same coverage factor: an error common to all
    /// measured lengths, which residuals cannot show.
    pub expanded_scale_uncertainty_um_per_m: Option<f64>,
    /// Contribution of range and angles of a laser tracker, total station or scanner to the
    /// uncertainty of a coordinate.
    pub polar: Option<Polar>,
}

/// An instrument that measures range and two angles; its expanded uncertainties have the coverage
/// factor of the instrument.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Polar {
    /// Position of the instrument's centre in the coordinates of the exports.
    pub station_mm: Vector,
    /// Expanded uncertainty of the range.
    #[serde(default)]
    pub expanded_range_uncertainty_um: f64,
    /// Increase of the range's expanded uncertainty with the range.
    #[serde(default)]
    pub expanded_range_uncertainty_um_per_m: f64,
    /// Expanded uncertainty of either angle, as a displacement across the line of sight.
    #[serde(default)]
    pub expanded_angle_uncertainty_um_per_m: f64,
}

/// Thermal expansion of robot and part at a common temperature, `temperature_c`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Expansion {
    /// Expanded uncertainty of the temperature.
    pub expanded_temperature_uncertainty_c: f64,
    /// Coverage factor of the temperature's uncertainty.
    pub coverage_factor: f64,
    /// Coefficient of expansion of the robot.
    pub robot_per_c: f64,
    /// Coefficient of expansion of the reference of the coordinates: a plate, or the scale of a
    /// machine without correction.
    #[serde(default)]
    pub part_per_c: f64,
}

impl Expansion {
    /// Relative standard uncertainty of the robot's lengths compared with the lengths of the part.
    pub fn relative_uncertainty(&self) -> f64 {
        let temperature = self.expanded_temperature_uncertainty_c / self.coverage_factor;
        (self.robot_per_c - self.part_per_c).abs() * temperature
    }
}

/// Repeatability of the joint values set by homing, which are common to a campaign with a single
/// homing.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Homing {
    /// Expanded uncertainty of prismatic joints.
    pub expanded_uncertainty_um: Option<f64>,
    /// Expanded uncertainty of revolute joints.
    pub expanded_uncertainty_deg: Option<f64>,
    /// Coverage factor of both expanded uncertainties.
    pub coverage_factor: f64,
}

/// A table of observations: measured quantities and joint values, row by row.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields, transform = etalon_tables::schema::accept_topic)]
pub struct ObservationsDefinition {
    /// File of the table: delimited text with a header, or a workbook (.xlsx).
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Form and columns.
    #[serde(flatten)]
    pub layout: TableLayout,
    /// Coverage factor of the columns of uncertainties, if they are expanded.
    pub coverage_factor: Option<f64>,
    /// Kind of all observations, for a table without the column.
    pub kind: Option<String>,
    /// Target of all rows, for a table without the column.
    pub target: Option<String>,
    /// Order of the rotations by the three angles of an orientation (columns `a_deg`, `b_deg`,
    /// `c_deg`). They follow each other about the axes of the body or, with `fixed`, of the world.
    #[schemars(with = "Option<String>")]
    pub orientation: Option<Spanned<String>>,
}

impl ObservationsDefinition {
    /// Table to read.
    pub fn reading(&self) -> TableReading {
        let kind = self.kind.clone().map(|kind| ("kind".to_owned(), Constant::Text(kind)));
        let mut layout = self.layout.clone();
        layout.constants.extend(kind);
        let (coverage_factor, target) = (self.coverage_factor, self.target.clone());
        TableReading { layout, coverage_factor, target, ..TableReading::default() }
    }
}

impl Instrument {
    /// Standard uncertainty of one coordinate (mm).
    pub fn standard_uncertainty_mm(&self) -> f64 {
        self.expanded_uncertainty_um / self.coverage_factor / 1000.0
    }

    /// Standard uncertainty of a position (mm), if given.
    pub fn position_uncertainty_mm(&self) -> Option<f64> {
        Some(self.expanded_position_uncertainty_um? / self.coverage_factor / 1000.0)
    }

    /// Covariance of a point by range and angles, including the uncertainty of a coordinate, along
    /// the axes of the export; `None` for instruments that measure coordinates.
    pub fn covariance_mm2(&self, xyz_mm: Vector) -> Option<[Vector; 3]> {
        let polar = self.polar?;
        let sight = minus(xyz_mm, polar.station_mm);
        let range_m = norm(sight) / 1000.0;
        let standard = |um: f64| um / self.coverage_factor / 1000.0;
        let along = standard(polar.expanded_range_uncertainty_um)
            + standard(polar.expanded_range_uncertainty_um_per_m * range_m);
        let across = standard(polar.expanded_angle_uncertainty_um_per_m * range_m);
        let direction = unit(sight).unwrap_or_default();
        let round = self.standard_uncertainty_mm().powi(2) + across * across;
        let covariance = |i: usize, j: usize| {
            let own = if i == j { round } else { 0.0 };
            own + (along * along - across * across) * direction[i] * direction[j]
        };
        Some(std::array::from_fn(|i| std::array::from_fn(|j| covariance(i, j))))
    }

    /// Standard uncertainties of the coordinates of a point (mm).
    pub fn standard_uncertainties_mm(&self, xyz_mm: Vector) -> Vector {
        match self.covariance_mm2(xyz_mm) {
            Some(covariance) => [0, 1, 2].map(|i| covariance[i][i].sqrt()),
            None => [self.standard_uncertainty_mm(); 3],
        }
    }

    /// Standard uncertainty of a point's coordinate (mm), averaged over the axes.
    pub fn standard_uncertainty_at_mm(&self, xyz_mm: Vector) -> f64 {
        norm(self.standard_uncertainties_mm(xyz_mm)) / 3f64.sqrt()
    }

    /// Relative standard uncertainty of the scale; 0 if not given.
    pub fn scale_uncertainty(&self) -> f64 {
        self.expanded_scale_uncertainty_um_per_m.unwrap_or(0.0) / self.coverage_factor * 1e-6
    }

    /// Standard uncertainty of an orientation about any axis (rad).
    pub fn rotation_uncertainty_rad(&self) -> Option<f64> {
        Some((self.expanded_rotation_uncertainty_deg? / self.coverage_factor).to_radians())
    }
}

/// Repeatability of the robot in returning to a measured point.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Half-width of the interval within which one coordinate repeats.
    pub repeatability_um: f64,
    /// Half-width in standard deviations.
    pub coverage_factor: f64,
}

impl Contact {
    /// Standard uncertainty of one coordinate (mm), independent for every observation.
    pub fn standard_uncertainty_mm(&self) -> f64 {
        self.repeatability_um / self.coverage_factor / 1000.0
    }
}

/// Targets on a rigid part.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rigid {
    /// Names of the targets.
    #[schemars(with = "Vec<String>")]
    pub targets: Vec<Spanned<String>>,
    /// Upper limit for the deviation of a distance from its median. Rows with a larger deviation
    /// are rejected; a shape with a larger deviation from `places_mm` causes an error.
    pub tolerance_mm: f64,
    /// Positions of all targets of the part in any frame of the part, from a certificate or a
    /// previous measurement. For planar robots, z is across the plane of motion. The identification
    /// then determines six unknowns of the part, and its shape within its uncertainty, instead of
    /// three unknowns of each target.
    #[serde(default)]
    pub places_mm: BTreeMap<String, [f64; 3]>,
    /// Expanded uncertainty of one coordinate of `places_mm`.
    pub expanded_uncertainty_um: Option<f64>,
    /// Coverage factor of `expanded_uncertainty_um`.
    pub coverage_factor: Option<f64>,
}

impl Rigid {
    /// Given shape of the part; `None` if shape or uncertainty are not given.
    pub fn shape(&self) -> Option<RigidPart> {
        let targets: Vec<String> = self.targets.iter().map(|t| t.get_ref().clone()).collect();
        let places = targets.iter().map(|t| self.places_mm.get(t).copied());
        Some(RigidPart {
            places_mm: places.collect::<Option<_>>()?,
            targets,
            standard_uncertainty_mm: self.expanded_uncertainty_um? / self.coverage_factor? / 1000.0,
            tolerance_mm: self.tolerance_mm,
            weight: 1.0,
        })
    }
}

/// Tool point, which programs move to their targets.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolDefinition {
    /// Position of the point in `frame`.
    pub point_mm: [f64; 3],
    /// Part to which the point is attached. The frame of `targets` has its origin at the first
    /// target, the x axis towards the second, and the third in the xy plane.
    pub frame: ToolFrame,
    /// Expanded uncertainty of one coordinate of the point.
    pub expanded_uncertainty_um: f64,
    /// Coverage factor of `expanded_uncertainty_um`.
    pub coverage_factor: f64,
}

impl ToolDefinition {
    /// Point with its standard uncertainty.
    pub fn point(&self) -> ToolPoint {
        let standard_uncertainty_mm = self.expanded_uncertainty_um / self.coverage_factor / 1000.0;
        ToolPoint { point_mm: self.point_mm, frame: self.frame.into(), standard_uncertainty_mm }
    }
}

/// Stationary targets.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fixed {
    /// Names of the targets.
    #[schemars(with = "Vec<String>")]
    pub targets: Vec<Spanned<String>>,
    /// Permissible drift during the campaign; a larger drift causes a warning.
    pub drift_mm: f64,
}

/// An element to fit: exactly one of the four keys, with the labels of its points.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FeatureDefinition {
    /// Points of a plane.
    #[schemars(with = "Option<Vec<String>>")]
    pub plane: Option<Vec<Spanned<String>>>,
    /// Points of a line.
    #[schemars(with = "Option<Vec<String>>")]
    pub line: Option<Vec<Spanned<String>>>,
    /// Points of a circle in space.
    #[schemars(with = "Option<Vec<String>>")]
    pub circle: Option<Vec<Spanned<String>>>,
    /// Points of a cylinder.
    #[schemars(with = "Option<Vec<String>>")]
    pub cylinder: Option<Vec<Spanned<String>>>,
}

/// Plausible expanded uncertainties (k = 2) of a coordinate (µm), from an interferometer to a
/// camera; a value outside is usually in another unit.
pub const PLAUSIBLE_EXPANDED_UM: std::ops::RangeInclusive<f64> = 0.05..=1e5;

/// Kind of a fitted element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeatureElement {
    /// Plane.
    Plane,
    /// Straight line.
    Line,
    /// Circle in space.
    Circle,
    /// Cylinder.
    Cylinder,
}

impl FeatureElement {
    /// Its key in campaign.toml.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Line => "line",
            Self::Circle => "circle",
            Self::Cylinder => "cylinder",
        }
    }
}

impl FeatureDefinition {
    /// Element and its labels, if exactly one is given.
    pub fn element(&self) -> Option<(FeatureElement, &[Spanned<String>])> {
        use FeatureElement::{Circle, Cylinder, Line, Plane};
        let all = [(Plane, &self.plane), (Line, &self.line), (Circle, &self.circle), (Cylinder, &self.cylinder)];
        let mut given = all.iter().filter_map(|(element, labels)| labels.as_ref().map(|l| (*element, l.as_slice())));
        given.next().filter(|_| given.next().is_none())
    }
}

/// Frames of a campaign.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frames {
    /// Frame in which observations are expressed.
    pub world: WorldDefinition,
}

/// World frame: from plane, origin and axis; from targets; or the frame of the export.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldDefinition {
    /// Name of the feature that defines the xy plane.
    #[schemars(with = "Option<String>")]
    pub plane: Option<Spanned<String>>,
    /// Label or feature whose point, projected onto the plane, is the origin.
    #[schemars(with = "Option<String>")]
    pub origin: Option<Spanned<String>>,
    /// Two labels (from, to), or one feature with a direction.
    #[schemars(with = "Option<Vec<String>>")]
    pub x_axis: Option<Vec<Spanned<String>>>,
    /// Two labels (from, to), or one feature with a direction.
    #[schemars(with = "Option<Vec<String>>")]
    pub y_axis: Option<Vec<Spanned<String>>>,
    /// Label of a point whose coordinate along the other axis is positive: x with `y_axis`, y with
    /// `x_axis`. It determines the direction of z.
    #[schemars(with = "Option<String>")]
    pub towards: Option<Spanned<String>>,
    /// Targets that define the frame: origin at the first, x axis to the second, third in the xy
    /// plane.
    #[schemars(with = "Option<Vec<String>>")]
    pub targets: Option<Vec<Spanned<String>>>,
    /// `"pose"` if the targets were measured again at every pose.
    pub each: Option<EachPose>,
    /// `true` if the coordinates of the export are world coordinates.
    #[serde(default)]
    pub as_exported: bool,
    /// Nominal positions of at least three labels or targets of the frame, or of the plate that
    /// carries them, in any common frame. If the deviation of a point exceeds `tolerance_mm` and
    /// the expanded uncertainty of the point, an error is reported.
    #[serde(default)]
    pub nominal_mm: BTreeMap<String, [f64; 3]>,
    /// Upper limit for the deviation of a point from its position in `nominal_mm`.
    pub tolerance_mm: Option<f64>,
}

impl WorldDefinition {
    /// Labels and features that define the origin and the axes.
    pub fn names(&self) -> impl Iterator<Item = &Spanned<String>> {
        let axes = self.x_axis.iter().flatten().chain(self.y_axis.iter().flatten());
        self.origin.iter().chain(&self.towards).chain(axes)
    }
}

/// A frame that is measured again at every pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum EachPose {
    /// At every pose.
    Pose,
}

/// Identification of parameters.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Identify {
    /// Residuals of `targets`, or of the `pose` (planar robots; thesis, eq. 3.26).
    #[serde(default)]
    pub residuals: ResidualKind,
    /// Poses for identification: names and ranges (`"1-8, 12, home"` or `["home", "P3", "5-9"]`),
    /// `all`, or `index mod 10 < 7` (index among
    /// the measured poses, from 0).
    #[schemars(with = "StatedPoses")]
    pub calibration: Spanned<StatedPoses>,
    /// Poses for validation, in the notation of `calibration`; `rest` selects all poses that the
    /// calibration does not use.
    #[schemars(with = "Option<StatedPoses>")]
    pub validation: Option<Spanned<StatedPoses>>,
    /// Series of the campaign: the poses of each set-up, day or file, in the notation of
    /// `calibration`. `rest` selects all poses that earlier series do not contain. The
    /// uncertainties of the parameters then include their scatter between series.
    #[serde(default)]
    #[schemars(with = "Vec<StatedPoses>")]
    pub series: Vec<Spanned<StatedPoses>>,
    /// Parameters held at their nominal values, base and targets of an arm without `[nominal]` at
    /// zero; `*` stands for any text.
    #[serde(default)]
    #[schemars(with = "Vec<String>")]
    pub hold: Vec<Spanned<String>>,
    /// Use of nominal values: as observations with their tolerances (`tolerances`, the default), or
    /// only as starting values (`none`: plain least squares, as in the thesis).
    #[serde(default)]
    pub prior: PriorRule,
    /// Identified effects of the robot itself, as a list of names. `usual`, the default, means all
    /// effects in the robot file except gains of revolute joints of arms and `payload` to
    /// `pedestal`; `all` means every effect. `proven` means the effects that reduce the errors of
    /// held-out calibration poses, as `etalon recommend` selects them.
    #[serde(default)]
    pub effects: EffectRule,
    /// Readings to be omitted, each with a reason that the report shows.
    #[serde(default)]
    #[schemars(with = "Vec<Exclude>")]
    pub exclude: Vec<Spanned<Exclude>>,
    /// Treatment of outliers: reported and used (`keep`, the default), or reported and omitted
    /// (`exclude`). An outlier is more than 6 robust standard deviations from a robust fit.
    #[serde(default)]
    pub outliers: OutlierRule,
    /// Residual field: errors of joints that the parameters do not describe, as functions of the
    /// joints. `true` searches for one; it is used only if held-out poses support it.
    #[serde(default)]
    pub field: bool,
}

/// Effects that are identified.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum EffectRule {
    /// Predefined choice.
    Named(NamedEffects),
    /// List of effects.
    These(Vec<Effect>),
}

/// Predefined choices of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NamedEffects {
    /// All effects in the robot file, except gains of revolute joints of arms.
    Usual,
    /// All effects of the model.
    All,
    /// Effects that the data prove by poses excluded from the identification.
    Proven,
}

impl Default for EffectRule {
    fn default() -> Self {
        Self::Named(NamedEffects::Usual)
    }
}

impl From<&EffectRule> for Effects {
    fn from(rule: &EffectRule) -> Self {
        match rule {
            EffectRule::Named(NamedEffects::Usual) => Self::Usual,
            // which effects are chosen depends on the data
            EffectRule::Named(NamedEffects::All | NamedEffects::Proven) => Self::All,
            EffectRule::These(chosen) => Self::These(chosen.iter().map(|&effect| effect.into()).collect()),
        }
    }
}

/// Use of nominal values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PriorRule {
    /// Each nominal value is an observation with the standard uncertainty t/√3 of its tolerance t
    /// (GUM 4.3.7).
    #[default]
    Tolerances,
    /// Nominal values are starting values only.
    None,
}

impl From<PriorRule> for Prior {
    fn from(rule: PriorRule) -> Self {
        match rule {
            PriorRule::Tolerances => Self::TOLERANCES,
            PriorRule::None => Self::None,
        }
    }
}

/// Treatment of outliers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OutlierRule {
    /// Outliers are reported and used.
    #[default]
    Keep,
    /// Outliers are reported and omitted, at most a tenth of all readings.
    Exclude,
}

/// Readings omitted from identification and validation.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exclude {
    /// Poses: names and ranges.
    pub poses: Option<StatedPoses>,
    /// Data rows of `file` instead of poses: numbers and ranges, counted from 1 and including
    /// rejected rows.
    pub rows: Option<StatedPoses>,
    /// Export whose `rows` are omitted.
    pub file: Option<String>,
    /// Repeat; all repeats by default.
    pub cycle: Option<i64>,
    /// Target; all targets by default.
    pub target: Option<String>,
    /// Reason, for the report.
    pub reason: String,
}

/// Limits for the result, at the validation poses if there are any.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// Upper limit for the largest position error.
    pub position_max_mm: Option<f64>,
    /// Upper limit for the mean position error.
    pub position_mean_mm: Option<f64>,
    /// Upper limit for the root-mean-square position error.
    pub position_rms_mm: Option<f64>,
    /// Upper limit for the largest orientation error.
    pub orientation_max_deg: Option<f64>,
    /// Upper limit for the error of a distance between a target and a fixed point.
    pub distance_max_mm: Option<f64>,
    /// Upper limit for the distance of a target from the plane, line or sphere that it touches.
    pub surface_max_mm: Option<f64>,
    /// Upper limit for the distance of a target from the socket that it touches.
    pub contact_max_mm: Option<f64>,
    /// Upper limit for the error of a coordinate in rows that contain only some of x, y and z.
    pub coordinate_max_mm: Option<f64>,
    /// Upper limit of pose repeatability RP, for every pose.
    pub repeatability_max_mm: Option<f64>,
    /// Upper limit of pose accuracy AP, for every pose.
    pub accuracy_max_mm: Option<f64>,
    /// Decision rule for these limits; guarded by default.
    pub decision_rule: Option<DecisionRule>,
    /// Specification, drawing or agreement that the limits come from, with its date.
    pub specification: Option<String>,
}

impl Limits {
    /// Limit of a quantity.
    pub fn limit(&self, quantity: LimitQuantity) -> Option<f64> {
        match quantity {
            LimitQuantity::PositionMaxMm => self.position_max_mm,
            LimitQuantity::PositionMeanMm => self.position_mean_mm,
            LimitQuantity::PositionRmsMm => self.position_rms_mm,
            LimitQuantity::OrientationMaxDeg => self.orientation_max_deg,
            LimitQuantity::DistanceMaxMm => self.distance_max_mm,
            LimitQuantity::SurfaceMaxMm => self.surface_max_mm,
            LimitQuantity::ContactMaxMm => self.contact_max_mm,
            LimitQuantity::CoordinateMaxMm => self.coordinate_max_mm,
            LimitQuantity::RepeatabilityMaxMm => self.repeatability_max_mm,
            LimitQuantity::AccuracyMaxMm => self.accuracy_max_mm,
        }
    }

    /// Given limits.
    pub fn stated(&self) -> impl Iterator<Item = (LimitQuantity, f64)> {
        LimitQuantity::ALL.iter().filter_map(|&quantity| Some((quantity, self.limit(quantity)?)))
    }
}

/// Language, logo and templates of the report, and its identification.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ReportDefinition {
    /// Language of the report.
    pub language: Language,
    /// Logo of the laboratory (SVG or PNG).
    #[schemars(with = "Option<String>")]
    pub logo: Option<Spanned<String>>,
    /// Folder of templates that replace the built-in ones of the same name.
    #[schemars(with = "Option<String>")]
    pub templates: Option<Spanned<String>>,
    /// Number of the report, unique in the laboratory.
    pub number: Option<String>,
    /// Number and date of the report that this report amends or replaces, and the reason.
    pub amends: Option<String>,
    /// Name and contact of the customer.
    pub customer: Option<String>,
    /// Country of the calibration, for the certificate: two letters of ISO 3166-1.
    #[schemars(with = "Option<String>")]
    pub country: Option<Country>,
    /// Date of issue.
    pub issued: Option<String>,
    /// Person who authorises the report: name and function.
    pub authorised_by: Option<String>,
    /// Results that an external provider obtained.
    pub external_results: Option<String>,
}

#[cfg(feature = "schemas")]
fn one_or_many_observations(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let one = generator.subschema_for::<ObservationsDefinition>();
    let many = generator.subschema_for::<Vec<ObservationsDefinition>>();
    schemars::json_schema!({ "anyOf": [one, many] })
}

#[cfg(feature = "schemas")]
fn one_or_many_logs(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let (one, many) = (generator.subschema_for::<Log>(), generator.subschema_for::<Vec<Log>>());
    schemars::json_schema!({ "anyOf": [one, many] })
}

/// A table, or an array of tables.
fn one_or_many<'de, D: Deserializer<'de>, T: Deserialize<'de>>(deserializer: D) -> Result<Vec<T>, D::Error> {
    struct OneOrMany<T>(PhantomData<T>);
    impl<'de, T: Deserialize<'de>> Visitor<'de> for OneOrMany<T> {
        type Value = Vec<T>;
        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str("a table in [ ] or tables in [[ ]]")
        }
        fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Vec<T>, A::Error> {
            Ok(vec![T::deserialize(de::value::MapAccessDeserializer::new(map))?])
        }
        fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Vec<T>, A::Error> {
            Vec::deserialize(de::value::SeqAccessDeserializer::new(seq))
        }
    }
    deserializer.deserialize_any(OneOrMany(PhantomData))
}
