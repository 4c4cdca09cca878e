//! The keys of `campaign.toml`.

use super::{Join, JoinBy, StatedPoses};
use etalon_base::country::Country;
use etalon_base::pose::{Vector, minus, norm, unit};
use etalon_documents::{Conditions, DecisionRule, Effect, Language, LimitQuantity};
use etalon_documents::{ResidualKind, ToolFrame};
use etalon_formats::dialect::{
    Cells, ColumnSource, Constant, Decimal, Delimiter, Encoding, FromRow, Header, Missing, Thousands,
};
use etalon_formats::{Export, Log, TableLayout};
use etalon_identify::{Effects, Prior, RigidPart, ToolPoint};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;
use toml::Spanned;

/// `campaign.toml`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CampaignFile {
    /// Name of the campaign.
    pub name: String,
    /// File of the robot, see robot.toml.
    #[schemars(with = "String")]
    pub robot: Spanned<String>,
    /// Folder for the documents; it is replaced as a whole.
    #[serde(default = "default_output")]
    #[schemars(with = "String")]
    pub output: Spanned<String>,
    /// How synthetic data were made; only for data that nobody measured. Every report repeats it.
    pub synthetic: Option<String>,
    /// Remarks for the report.
    pub notes: Option<String>,
    /// Date of the measurements (ISO 8601), as the report prints it.
    pub date: Option<String>,
    /// Name of the operator.
    pub operator: Option<String>,
    /// Temperature during the measurements.
    pub temperature_c: Option<f64>,
    /// Conditions of a test, for the report.
    #[serde(default)]
    pub conditions: Conditions,
    /// The measuring instrument.
    pub instrument: Instrument,
    /// How well the robot finds a measured point again, where points are measured once and touched often: the
    /// instrument's error of a point is then common to all its observations.
    pub contact: Option<Contact>,
    /// Thermal expansion, for the uncertainty of lengths.
    pub expansion: Option<Expansion>,
    /// How well homing repeats.
    pub homing: Option<Homing>,
    /// Files of the measuring system.
    #[serde(default, rename = "export")]
    pub exports: Vec<Export>,
    /// Targets on one rigid part.
    #[serde(default, rename = "rigid")]
    pub rigid: Vec<Rigid>,
    /// Targets that do not move and are measured repeatedly.
    #[serde(default)]
    pub fixed: Vec<Fixed>,
    /// Logs of the controller. The first is used to identify; others are compared with it.
    #[serde(default, rename = "log", deserialize_with = "one_or_many")]
    #[schemars(schema_with = "one_or_many_logs")]
    pub logs: Vec<Log>,
    /// How points are joined with joint values.
    pub join: Option<Join>,
    /// Tables of observations, in place of exports, log and join.
    #[serde(default, deserialize_with = "one_or_many")]
    #[schemars(schema_with = "one_or_many_observations")]
    pub observations: Vec<ObservationsDefinition>,
    /// Elements to fit, by name.
    #[serde(default, rename = "feature")]
    pub features: BTreeMap<String, FeatureDefinition>,
    /// Frames; without them the coordinates of the exports are those of the world.
    pub frame: Option<Frames>,
    /// The point that programs move: the error to expect there is reported beside those of the targets.
    pub tool: Option<ToolDefinition>,
    /// What is identified; nothing where the campaign is a test by ISO 9283 alone.
    pub identify: Option<Identify>,
    /// Geometric calibration of a PreXYT (thesis, chapter 2).
    pub geometric: Option<super::GeometricDefinition>,
    /// Test of repeatability from labelled points (thesis 2.4).
    pub repeatability: Option<super::RepeatabilityDefinition>,
    /// Test by ISO 9283 from tables of poses.
    pub poses: Option<super::PosesDefinition>,
    /// Test of static compliance.
    pub compliance: Option<super::ComplianceDefinition>,
    /// Recorded motions.
    #[serde(default, rename = "stream")]
    pub streams: Vec<super::StreamDefinition>,
    /// Limits that the result must meet; otherwise the exit code is 1.
    #[serde(default)]
    pub limits: Limits,
    /// Language, logo and templates of the report.
    #[serde(default)]
    pub report: ReportDefinition,
    /// Formats of the controller files to write.
    #[schemars(with = "Option<Vec<String>>", extend("default" = ["json", "csv", "c-header"]))]
    pub controllers: Option<Vec<Spanned<String>>>,
}

impl CampaignFile {
    /// The definition of the world frame.
    pub fn world(&self) -> Option<&WorldDefinition> {
        Some(&self.frame.as_ref()?.world)
    }

    /// The key of the join.
    pub fn join_by(&self) -> Option<JoinBy> {
        Some(self.join.as_ref()?.by)
    }

    /// Targets that `[join]` names; none where it names none.
    pub fn join_targets(&self) -> impl Iterator<Item = &Spanned<String>> + Clone {
        self.join.iter().flat_map(|join| join.targets.iter().flatten())
    }

    /// Every file of measurements, and of what they are compared with, that the campaign names.
    pub fn inputs(&self) -> impl Iterator<Item = &Spanned<String>> {
        let measured = self.exports.iter().map(|e| &e.file).chain(self.logs.iter().map(|l| &l.file));
        let measured = measured.chain(self.observations.iter().map(|o| &o.file));
        let streams = self.streams.iter().flat_map(|s| [Some(&s.file), s.commanded.as_ref(), s.path.as_ref()]);
        let poses = self.poses.iter().flat_map(|p| [Some(&p.attained), Some(&p.commanded), p.reference.as_ref()]);
        let others =
            [self.repeatability.as_ref().and_then(|r| r.commanded.as_ref()), self.compliance.as_ref().map(|c| &c.file)];
        measured.chain(streams.chain(poses).chain(others).flatten())
    }
}

fn default_output() -> Spanned<String> {
    Spanned::new(0..0, "out".to_owned())
}

/// The measuring instrument.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Instrument {
    /// Name of the instrument, for the report.
    pub name: String,
    /// Expanded uncertainty of one coordinate.
    pub expanded_uncertainty_um: f64,
    /// Its coverage factor.
    pub coverage_factor: f64,
    /// Expanded uncertainty of a measured position, with the same coverage factor; without it √3 times that of a coordinate (planar robots: √2).
    pub expanded_position_uncertainty_um: Option<f64>,
    /// Expanded uncertainty of a measured orientation about any axis, with the same coverage factor.
    pub expanded_rotation_uncertainty_deg: Option<f64>,
    /// Expanded uncertainty of the scale, with the same coverage factor: an error common to all measured lengths, which no residual shows.
    pub expanded_scale_uncertainty_um_per_m: Option<f64>,
    /// What range and angles of a laser tracker, total station or scanner add to the uncertainty of a coordinate.
    pub polar: Option<Polar>,
}

/// An instrument that measures range and two angles; expanded uncertainties have its coverage factor.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Polar {
    /// Its centre in the coordinates of the exports.
    pub station_mm: Vector,
    /// Expanded uncertainty of the range.
    #[serde(default)]
    pub expanded_range_uncertainty_um: f64,
    /// What it grows by with the range.
    #[serde(default)]
    pub expanded_range_uncertainty_um_per_m: f64,
    /// Expanded uncertainty of either angle, across the line of sight.
    #[serde(default)]
    pub expanded_angle_uncertainty_um_per_m: f64,
}

/// Thermal expansion of robot and part, which have the same temperature: `temperature_c`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Expansion {
    /// Expanded uncertainty of the temperature.
    pub expanded_temperature_uncertainty_c: f64,
    /// Its coverage factor.
    pub coverage_factor: f64,
    /// Coefficient of expansion of the robot.
    pub robot_per_c: f64,
    /// Coefficient of expansion of what the coordinates refer to: a plate, the scale of a machine that does not correct for it.
    #[serde(default)]
    pub part_per_c: f64,
}

impl Expansion {
    /// Standard uncertainty of the robot's lengths against those of the part, relative.
    pub fn relative_uncertainty(&self) -> f64 {
        let temperature = self.expanded_temperature_uncertainty_c / self.coverage_factor;
        (self.robot_per_c - self.part_per_c).abs() * temperature
    }
}

/// How well the joint values of a homing repeat those of another: common to a campaign, which is homed once.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Homing {
    /// Expanded uncertainty of joints that slide.
    pub expanded_uncertainty_um: Option<f64>,
    /// Expanded uncertainty of joints that turn.
    pub expanded_uncertainty_deg: Option<f64>,
    /// Coverage factor of both.
    pub coverage_factor: f64,
}

/// A table of observations: what was measured and the joint values, row by row.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObservationsDefinition {
    /// The table: delimited text with a header, or a workbook (.xlsx).
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// What separates the columns.
    #[schemars(extend("default" = ","))]
    pub delimiter: Option<Delimiter>,
    /// Decimal mark.
    #[schemars(extend("default" = "."))]
    pub decimal: Option<Decimal>,
    /// Encoding of its characters, where no byte-order mark states it.
    #[schemars(extend("default" = "utf-8"))]
    pub encoding: Option<Encoding>,
    /// Sheet of a workbook that holds the table: its cells need neither delimiter, decimal mark nor encoding.
    pub sheet: Option<String>,
    /// Mark between groups of three digits.
    pub thousands: Option<Thousands>,
    /// Rows before the data, the last of which names the columns: a number, `false` for none, or words of the row.
    #[serde(default = "one_row")]
    #[schemars(extend("default" = 1))]
    pub header: Header,
    /// Beginning of lines that are skipped.
    pub comment: Option<String>,
    /// Cells that mean "not measured", beside empty ones.
    #[serde(default)]
    pub missing: Missing,
    /// Where each column comes from that is called otherwise in the file: a heading, a number from 1, or an expression (`x_t - x_dif`).
    #[serde(default)]
    pub columns: BTreeMap<String, ColumnSource>,
    /// Columns with the same value in all rows, e.g. `kind = "distance"`.
    #[serde(default)]
    pub constants: BTreeMap<String, Constant>,
    /// Rows that are read: those with one of these cells in each of these columns.
    #[serde(default)]
    pub only: BTreeMap<String, Cells>,
    /// Rows that are left out: those with one of these cells in one of these columns.
    #[serde(default)]
    pub without: BTreeMap<String, Cells>,
    /// Coverage factor of the columns of uncertainties, where they are expanded.
    pub coverage_factor: Option<f64>,
    /// Kind of all observations, of a table without such a column.
    pub kind: Option<String>,
    /// The target of all rows, of a table without such a column.
    pub target: Option<String>,
    /// `row`: the number of the data row is the number of the pose, of a table without such a column; `row + 100`: so many more.
    pub pose: Option<FromRow>,
    /// Order in which the three angles of an orientation (columns `a_deg`, `b_deg`, `c_deg`) turn: about the axes of the body, one after the other,
    /// or `fixed`, about those of the world.
    #[schemars(with = "Option<String>")]
    pub orientation: Option<Spanned<String>>,
}

impl ObservationsDefinition {
    /// The key beside `sheet` that means nothing for a workbook.
    pub fn meaningless_beside_sheet(&self) -> Option<&'static str> {
        let text = [
            ("delimiter", self.delimiter.is_some()),
            ("decimal", self.decimal.is_some()),
            ("encoding", self.encoding.is_some()),
        ];
        text.into_iter().find(|(_, stated)| self.sheet.is_some() && *stated).map(|(key, _)| key)
    }

    /// How the table is laid out.
    pub fn layout(&self) -> TableLayout {
        let kind = self.kind.clone().map(|kind| ("kind".to_owned(), Constant::Text(kind)));
        TableLayout {
            delimiter: self.delimiter.unwrap_or(Delimiter::Comma),
            decimal: self.decimal.unwrap_or_default(),
            thousands: self.thousands,
            header: self.header.clone(),
            comment: self.comment.clone(),
            missing: self.missing.clone(),
            columns: self.columns.clone(),
            lenient: false,
            constants: self.constants.clone().into_iter().chain(kind).collect(),
            only: self.only.clone(),
            without: self.without.clone(),
            coverage_factor: self.coverage_factor,
            target: self.target.clone(),
            pose: self.pose,
        }
    }
}

fn one_row() -> Header {
    Header::Rows(1)
}

impl Instrument {
    /// Standard uncertainty of one coordinate in millimetres.
    pub fn standard_uncertainty_mm(&self) -> f64 {
        self.expanded_uncertainty_um / self.coverage_factor / 1000.0
    }

    /// Standard uncertainty of a position in millimetres, where it is stated.
    pub fn position_uncertainty_mm(&self) -> Option<f64> {
        Some(self.expanded_position_uncertainty_um? / self.coverage_factor / 1000.0)
    }

    /// Covariance of a point by range and angles beside the uncertainty of a coordinate, along the axes of the export; `None` for
    /// instruments that measure coordinates.
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

    /// Standard uncertainties of the coordinates of a point, mm.
    pub fn standard_uncertainties_mm(&self, xyz_mm: Vector) -> Vector {
        match self.covariance_mm2(xyz_mm) {
            Some(covariance) => [0, 1, 2].map(|i| covariance[i][i].sqrt()),
            None => [self.standard_uncertainty_mm(); 3],
        }
    }

    /// Standard uncertainty of a coordinate of a point, in the mean over its axes, mm.
    pub fn standard_uncertainty_at_mm(&self, xyz_mm: Vector) -> f64 {
        norm(self.standard_uncertainties_mm(xyz_mm)) / 3f64.sqrt()
    }

    /// Standard uncertainty of the scale, relative; 0 where none is stated.
    pub fn scale_uncertainty(&self) -> f64 {
        self.expanded_scale_uncertainty_um_per_m.unwrap_or(0.0) / self.coverage_factor * 1e-6
    }

    /// Standard uncertainty of an orientation about any axis in radians.
    pub fn rotation_uncertainty_rad(&self) -> Option<f64> {
        Some((self.expanded_rotation_uncertainty_deg? / self.coverage_factor).to_radians())
    }
}

/// How well the robot finds a measured point again.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Half width of the interval within which one coordinate repeats.
    pub repeatability_um: f64,
    /// The half width in standard deviations.
    pub coverage_factor: f64,
}

impl Contact {
    /// Standard uncertainty of one coordinate in millimetres, of every observation its own.
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
    /// Largest difference of a distance from its median; a row beyond is refused. A shape that differs as much from `places_mm` is an
    /// error.
    pub tolerance_mm: f64,
    /// Places of all its targets in any frame of the part (planar robots: with z across the plane of motion), by certificate or measured
    /// beforehand: the identification then finds six unknowns of the part and its shape within its uncertainty, instead of three unknowns
    /// of each target.
    #[serde(default)]
    pub places_mm: BTreeMap<String, [f64; 3]>,
    /// Expanded uncertainty of one coordinate of `places_mm`.
    pub expanded_uncertainty_um: Option<f64>,
    /// Its coverage factor.
    pub coverage_factor: Option<f64>,
}

impl Rigid {
    /// The stated shape of the part; `None` where none is stated, or not with its uncertainty.
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

/// The point that programs move.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolDefinition {
    /// Its place in `frame`.
    pub point_mm: [f64; 3],
    /// The part in whose frame that is: `targets` have their origin at the first, the x axis to the second, the third in the xy plane.
    pub frame: ToolFrame,
    /// Expanded uncertainty of one coordinate of its place.
    pub expanded_uncertainty_um: f64,
    /// Its coverage factor.
    pub coverage_factor: f64,
}

impl ToolDefinition {
    /// The point with its standard uncertainty.
    pub fn point(&self) -> ToolPoint {
        let standard_uncertainty_mm = self.expanded_uncertainty_um / self.coverage_factor / 1000.0;
        ToolPoint { point_mm: self.point_mm, frame: self.frame.into(), standard_uncertainty_mm }
    }
}

/// Targets that do not move.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fixed {
    /// Names of the targets.
    #[schemars(with = "Vec<String>")]
    pub targets: Vec<Spanned<String>>,
    /// Permitted drift during the campaign; more is a warning.
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

impl FeatureDefinition {
    /// The element and its labels, if exactly one is given.
    pub fn element(&self) -> Option<(&'static str, &[Spanned<String>])> {
        let all =
            [("plane", &self.plane), ("line", &self.line), ("circle", &self.circle), ("cylinder", &self.cylinder)];
        let mut given = all.iter().filter_map(|(name, labels)| labels.as_ref().map(|l| (*name, l.as_slice())));
        given.next().filter(|_| given.next().is_none())
    }
}

/// Frames of a campaign.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frames {
    /// The frame in which observations are expressed.
    pub world: WorldDefinition,
}

/// The world frame: from plane, origin and axis; or from targets; or that of the export.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldDefinition {
    /// Name of the feature that is the xy plane.
    #[schemars(with = "Option<String>")]
    pub plane: Option<Spanned<String>>,
    /// Label or feature whose point, projected into the plane, is the origin.
    #[schemars(with = "Option<String>")]
    pub origin: Option<Spanned<String>>,
    /// Two labels (from, to), or one feature with a direction.
    #[schemars(with = "Option<Vec<String>>")]
    pub x_axis: Option<Vec<Spanned<String>>>,
    /// Two labels (from, to), or one feature with a direction.
    #[schemars(with = "Option<Vec<String>>")]
    pub y_axis: Option<Vec<Spanned<String>>>,
    /// Label of a point on the positive side of the other axis; it decides the direction of z.
    #[schemars(with = "Option<String>")]
    pub towards: Option<Spanned<String>>,
    /// Targets that define the frame: origin at the first, x axis to the second, third in the xy plane.
    #[schemars(with = "Option<Vec<String>>")]
    pub targets: Option<Vec<Spanned<String>>>,
    /// `"pose"`: the targets were measured again at every pose.
    pub each: Option<EachPose>,
    /// The coordinates of the export are those of the world.
    #[serde(default)]
    pub as_exported: bool,
    /// Nominal places of labels or targets, of the frame or of the plate that carries them, in any one frame: three or more. A point that is
    /// off by more than `tolerance_mm` and its expanded uncertainty is an error.
    #[serde(default)]
    pub nominal_mm: BTreeMap<String, [f64; 3]>,
    /// How far a point may be from its place in `nominal_mm`.
    pub tolerance_mm: Option<f64>,
}

impl WorldDefinition {
    /// Labels and features that give the origin and the axes.
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
    /// Residuals of `targets`, or of the `pose` (planar robots, thesis eq. 3.26).
    #[serde(default)]
    pub residuals: ResidualKind,
    /// Poses to identify with: names and ranges (`"1-8, 12, home"` or `["home", "P3", "5-9"]`), `all`, or `index mod 10 < 7` (index
    /// from 0).
    #[schemars(with = "StatedPoses")]
    pub calibration: Spanned<StatedPoses>,
    /// Poses to validate with, likewise; `rest` is all poses that the calibration does not use.
    #[schemars(with = "Option<StatedPoses>")]
    pub validation: Option<Spanned<StatedPoses>>,
    /// Parameters held at their nominal values; `*` replaces any text.
    #[serde(default)]
    #[schemars(with = "Vec<String>")]
    pub hold: Vec<Spanned<String>>,
    /// Nominal values with their tolerances as readings beside the measurements (`tolerances`, the default), or plain least squares
    /// (`none`), as in the thesis.
    #[serde(default)]
    pub prior: PriorRule,
    /// Effects of the robot itself that are identified: a list of `zeros`, `geometry`, `gains`, `harmonics`, `backlash`, `coupling`,
    /// `bending`; `usual`, which is the default: all that the robot file states, without the gains of turning joints of arms; `all`; or `proven`:
    /// those that make calibration poses better which are left out of the identification, as `etalon recommend` chooses them.
    #[serde(default)]
    pub effects: EffectRule,
    /// Readings that are left out, each with its reason, which the report shows.
    #[serde(default)]
    #[schemars(with = "Vec<Exclude>")]
    pub exclude: Vec<Spanned<Exclude>>,
    /// What becomes of outliers, readings more than 6 robust standard deviations from a robust fit: they are named and used
    /// (`keep`, without it), or named and left out (`exclude`).
    #[serde(default)]
    pub outliers: OutlierRule,
}

/// Effects that are identified.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum EffectRule {
    /// A choice by its name.
    Named(NamedEffects),
    /// These effects.
    These(Vec<Effect>),
}

/// Choices of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NamedEffects {
    /// All that the robot file states, without the gains of turning joints of arms.
    Usual,
    /// All that the model has.
    All,
    /// Those that the data prove by poses that are left out.
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
            // which are proven follows from the data
            EffectRule::Named(NamedEffects::All | NamedEffects::Proven) => Self::All,
            EffectRule::These(chosen) => Self::These(chosen.iter().map(|&effect| effect.into()).collect()),
        }
    }
}

/// Weight of nominal values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PriorRule {
    /// Each nominal value is a reading with the standard uncertainty t/√3 of its tolerance t (GUM 4.3.7).
    #[default]
    Tolerances,
    /// Nominal values are starting values alone.
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

/// What becomes of outliers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OutlierRule {
    /// They are named, and used.
    #[default]
    Keep,
    /// They are named, and left out; at most a tenth of all readings.
    Exclude,
}

/// Readings that are left out of identification and validation.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exclude {
    /// Poses: names and ranges.
    pub poses: Option<StatedPoses>,
    /// Instead of poses, data rows of `file`, counted from 1, refused ones included: numbers and ranges.
    pub rows: Option<StatedPoses>,
    /// The export whose `rows` are left out.
    pub file: Option<String>,
    /// Repeat; without it all repeats.
    pub cycle: Option<i64>,
    /// Target; without it all targets.
    pub target: Option<String>,
    /// Why, for the report.
    pub reason: String,
}

/// What the result must meet, on the validation poses if there are any.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// Largest position error.
    pub position_max_mm: Option<f64>,
    /// Mean position error.
    pub position_mean_mm: Option<f64>,
    /// Root mean square position error.
    pub position_rms_mm: Option<f64>,
    /// Largest orientation error.
    pub orientation_max_deg: Option<f64>,
    /// Largest repeatability RP of all poses.
    pub repeatability_max_mm: Option<f64>,
    /// Largest accuracy AP of all poses.
    pub accuracy_max_mm: Option<f64>,
    /// How uncertainty counts when these are judged; guarded where none is stated.
    pub decision_rule: Option<DecisionRule>,
}

impl Limits {
    /// The limit of a quantity.
    pub fn of(&self, quantity: LimitQuantity) -> Option<f64> {
        match quantity {
            LimitQuantity::PositionMaxMm => self.position_max_mm,
            LimitQuantity::PositionMeanMm => self.position_mean_mm,
            LimitQuantity::PositionRmsMm => self.position_rms_mm,
            LimitQuantity::OrientationMaxDeg => self.orientation_max_deg,
            LimitQuantity::RepeatabilityMaxMm => self.repeatability_max_mm,
            LimitQuantity::AccuracyMaxMm => self.accuracy_max_mm,
        }
    }

    /// The limits that are stated.
    pub fn stated(&self) -> impl Iterator<Item = (LimitQuantity, f64)> {
        LimitQuantity::ALL.iter().filter_map(|&quantity| Some((quantity, self.of(quantity)?)))
    }
}

/// Language, logo and templates of the report, and what identifies it.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ReportDefinition {
    /// Language of the report.
    pub language: Language,
    /// The laboratory's logo, SVG or PNG.
    #[schemars(with = "Option<String>")]
    pub logo: Option<Spanned<String>>,
    /// Folder of templates that replace the built-in ones of the same name.
    #[schemars(with = "Option<String>")]
    pub templates: Option<Spanned<String>>,
    /// Number of the report, unique in the laboratory.
    pub number: Option<String>,
    /// Number and date of the report that this one amends or replaces, and the reason.
    pub amends: Option<String>,
    /// Name and contact of the customer.
    pub customer: Option<String>,
    /// Country in which the calibration was made, for the certificate: two letters of ISO 3166-1.
    #[schemars(with = "Option<String>")]
    pub country: Option<Country>,
    /// Date of issue.
    pub issued: Option<String>,
    /// Who authorises the report: name and function.
    pub authorised_by: Option<String>,
    /// Results that an external provider obtained, and which.
    pub external_results: Option<String>,
}

fn one_or_many_observations(generator: &mut SchemaGenerator) -> Schema {
    let one = generator.subschema_for::<ObservationsDefinition>();
    let many = generator.subschema_for::<Vec<ObservationsDefinition>>();
    json_schema!({ "anyOf": [one, many] })
}

fn one_or_many_logs(generator: &mut SchemaGenerator) -> Schema {
    let (one, many) = (generator.subschema_for::<Log>(), generator.subschema_for::<Vec<Log>>());
    json_schema!({ "anyOf": [one, many] })
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
