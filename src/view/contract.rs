//! Documents that page and program exchange, as JSON. Lengths are in mm, angles in degrees, errors
//! in µm, times in s, unless the key gives another unit.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use etalon_base::catalogue::Argument;
use etalon_base::message;
use etalon_base::pose::Vector;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Severity of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// Nothing can be computed before it is mended.
    Error,
    /// Effect on the result.
    Warning,
    /// Given for completeness.
    Info,
}

/// A message in the language of the page.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShownMessage {
    /// Id in the catalogue of messages.
    pub id: String,
    /// Severity.
    pub severity: Severity,
    /// Sentence, with the expected value.
    pub text: String,
    /// Next action.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
    /// Place of the problem.
    #[serde(rename = "where", skip_serializing_if = "Option::is_none")]
    pub place: Option<Place>,
}

/// Place of a problem.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// File, as in the campaign.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Pose.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pose: Option<String>,
}

impl ShownMessage {
    /// A message of the catalogue in a language.
    pub fn new(message: &message::Message, language: &str) -> Self {
        let texts = message.texts(language);
        let severity = match message.severity {
            message::Severity::Error => Severity::Error,
            message::Severity::Warning if message.rank == message::Rank::Routine => Severity::Info,
            message::Severity::Warning => Severity::Warning,
        };
        let text = texts.expected.map_or_else(|| texts.what.clone(), |expected| format!("{}: {expected}", texts.what));
        let argument = message.arguments.get("pose").and_then(|pose| match pose {
            Argument::Text(name) => Some(name.clone()),
            Argument::Whole(number) => Some(number.to_string()),
            _ => None,
        });
        let place = message.place.as_deref();
        let place = (place.is_some() || argument.is_some()).then(|| Place {
            file: place.map(|p| p.file.clone()).filter(|file| !file.is_empty()),
            line: place.and_then(|p| p.line),
            pose: argument,
        });
        Self { id: message.id.clone().into_owned(), severity, text, hint: texts.hint, place }
    }
}

/// All that the page shows.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct State {
    /// Number that grows with each change.
    pub version: u64,
    /// Version of the program.
    pub etalon: String,
    /// Language: `en`, `de` or `fr`.
    pub language: String,
    /// `empty`, `proposed` or `campaign`.
    pub mode: &'static str,
    /// Folder of the page.
    pub folder: String,
    /// Name of the campaign, and the explanation of synthetic data.
    #[serde(flatten)]
    pub titles: Titles,
    /// Files of the folder that the campaign names, or that were dropped on the page.
    pub files: Vec<DroppedFile>,
    /// Messages of a check or of a run, in the order of the report.
    pub messages: Vec<ShownMessage>,
    /// Verdict of the last run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verdict: Option<Verdict>,
    /// Files of the output folder.
    pub downloads: Vec<Download>,
    /// Meshes of the robot, in an exported page; a served page asks for them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub meshes: Vec<Mesh>,
    /// The robot and its measured points.
    #[serde(flatten)]
    pub found: Found,
}

/// Name of a campaign.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Titles {
    /// Name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// `true` for simulated data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub synthetic: Option<bool>,
    /// `true` while the files are followed.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub watching: bool,
    /// Names of known robots, for a page without a campaign.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub robots: Vec<String>,
}

/// Result of an identification.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Found {
    /// The robot and its measured points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<Scene>,
    /// Parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parameters: Option<Vec<Parameter>>,
    /// Largest position error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub maximum: Option<LargestError>,
    /// Selections of poses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub split: Option<Split>,
}

/// Largest position error at the deciding poses.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LargestError {
    /// `calibration` or `validation`.
    pub set: String,
    /// Pose.
    pub pose: String,
    /// Target.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<String>,
    /// Error after calibration.
    pub value_um: f64,
    /// Expanded uncertainty (k = 2).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty_um: Option<f64>,
    /// Limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_um: Option<f64>,
    /// Largest error before calibration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub before_um: Option<f64>,
}

/// Selections of poses as the campaign gives them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Split {
    /// Poses that identify.
    pub calibration: String,
    /// Poses that validate; empty if there are none.
    pub validation: String,
}

/// A file of the folder.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DroppedFile {
    /// Name.
    pub name: String,
    /// Size.
    pub bytes: u64,
    /// Use of the file by the campaign.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub role: Option<String>,
}

/// Verdict with its reasons and next steps.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// `pass`, `fail`, `conditional`, `undecided` or `none`.
    pub status: &'static str,
    /// Reasons.
    pub lines: Vec<String>,
    /// Next steps.
    pub next: Vec<String>,
}

/// A file that the page offers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Download {
    /// Name in the output folder.
    pub name: String,
    /// Text of the link.
    pub label: String,
    /// Size.
    pub bytes: u64,
}

/// A robot at its measured poses.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scene {
    /// `mm`.
    pub unit: &'static str,
    /// Joints.
    pub joints: Vec<JointScale>,
    /// Moving parts.
    pub bodies: Vec<Named>,
    /// Fixed frames.
    pub frames: Vec<NamedPose>,
    /// The measuring system, if its place is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub instrument: Option<Instrument>,
    /// Poses.
    pub poses: Vec<Pose>,
    /// Measured points.
    pub points: Vec<Point>,
    /// Proposed magnification of arrows.
    pub magnification: f64,
    /// Moving parts that have meshes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<String>,
}

/// Mesh of a moving part, in its frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mesh {
    /// Name of the part.
    pub part: String,
    /// Lowest coordinates.
    pub low: Vector,
    /// Length for which the coordinate 65,535 stands.
    pub size: f64,
    /// Coordinates of the points: three numbers of 16 bits each (little-endian, base64).
    pub points: String,
    /// Indices of the corners of the triangles, like `points`.
    pub triangles: String,
}

impl Mesh {
    /// Returns a mesh of these points and triangles.
    pub fn new(part: String, low: Vector, size: f64, points: &[[u16; 3]], triangles: &[[u16; 3]]) -> Self {
        let packed = |all: &[[u16; 3]]| {
            let bytes: Vec<u8> = all.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
            STANDARD.encode(bytes)
        };
        Self { part, low, size, points: packed(points), triangles: packed(triangles) }
    }
}

/// A name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Named {
    /// Name.
    pub name: String,
}

/// A joint with its limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JointScale {
    /// Name.
    pub name: String,
    /// `deg` or `mm`.
    pub unit: &'static str,
    /// Lower limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
}

/// A frame: 16 numbers, row by row, in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedPose {
    /// Name.
    pub name: String,
    /// Matrix.
    pub pose: Vec<f64>,
}

/// The measuring system.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Instrument {
    /// Name.
    pub name: String,
    /// Place.
    pub at: Vector,
}

/// Use of a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PoseSet {
    /// Identification of the parameters.
    Calibration,
    /// Validation of the parameters.
    Validation,
    /// Excluded, or in no set.
    LeftOut,
}

/// The robot at one pose.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pose {
    /// Name, with the cycle behind a slash if it was visited several times.
    pub id: String,
    /// Use.
    pub set: PoseSet,
    /// Joint values.
    pub joints: Vec<f64>,
    /// Time of the measurement, from the first one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_s: Option<f64>,
    /// The robot as lines.
    pub strokes: Vec<Stroke>,
    /// Pose of the flange or platform.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<Vec<f64>>,
    /// Frames of the parts with meshes, in the order of the scene: 12 numbers each, row by row.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<Vec<f64>>,
}

/// A line of the robot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stroke {
    /// Index of the body.
    pub body: usize,
    /// `link`, `axis` or `target`.
    pub kind: &'static str,
    /// Points of the line.
    pub points: Vec<Vector>,
}

/// A measured point with its errors (µm).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// Index of the pose.
    pub pose: usize,
    /// Target.
    pub target: String,
    /// Measured quantity.
    pub kind: String,
    /// Measured place.
    pub measured: Vector,
    /// Errors.
    #[serde(flatten)]
    pub errors: PointErrors,
    /// `true` if a robust fit finds an outlier.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outlier: Option<bool>,
    /// `true` if the point identifies or validates.
    pub used: bool,
}

/// Errors of a point (µm): measured minus computed.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct PointErrors {
    /// With nominal parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub before: Option<Vector>,
    /// With identified parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub after: Option<Vector>,
    /// Length of `before`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub magnitude_before_um: Option<f64>,
    /// Length of `after`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub magnitude_after_um: Option<f64>,
    /// Expanded uncertainty of the predicted place (k = 2), along its longest axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty_um: Option<f64>,
    /// Covariance (µm²) of the predicted place: xx, xy, xz, yy, yz, zz.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub covariance_um2: Option<[f64; 6]>,
}

/// A parameter of the robot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Nominal value.
    pub nominal: f64,
    /// Identified value.
    pub identified: f64,
    /// Standard uncertainty.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<f64>,
    /// `true` if the parameter is held.
    pub held: bool,
    /// `robot`, `base`, `target` or `fixture`.
    pub role: &'static str,
    /// Meaning in the language of the page.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub meaning: Option<String>,
}

/// A question of the page: the same identification with other data or parameters.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct WhatIfAsked {
    /// Poses to leave out.
    pub leave_out_poses: Vec<String>,
    /// Targets to leave out.
    pub leave_out_targets: Vec<String>,
    /// Parameters to hold.
    pub hold: Vec<String>,
    /// Held parameters to identify.
    pub free: Vec<String>,
    /// Limit of the largest position error.
    pub limit_um: Option<f64>,
    /// Other selection of the calibration poses.
    pub calibration: Option<String>,
    /// Other selection of the validation poses.
    pub validation: Option<String>,
}

/// Answer to [`WhatIfAsked`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WhatIf {
    /// Time of the computation.
    pub seconds: f64,
    /// Verdict on the limits of errors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verdict: Option<Verdict>,
    /// Parameters.
    pub parameters: Vec<Parameter>,
    /// Errors of all points, in the poses of the scene.
    pub points: Vec<PointNow>,
    /// Largest error.
    pub maximum_um: Maximum,
    /// Parameters that changed by more than twice the uncertainty of the change.
    pub changed: Vec<Changed>,
    /// Messages.
    pub messages: Vec<ShownMessage>,
}

/// Error of a point in another identification.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PointNow {
    /// Index of the pose.
    pub pose: usize,
    /// Target.
    pub target: String,
    /// Error.
    pub after: Vector,
    /// Its length.
    pub magnitude_after_um: f64,
}

/// Largest error at the deciding poses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Maximum {
    /// In the first result.
    pub first: f64,
    /// In this result.
    pub now: f64,
    /// Expanded uncertainty (k = 2).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<f64>,
}

/// Change of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Changed {
    /// Parameter.
    pub name: String,
    /// Change in its unit.
    pub by: f64,
    /// Change in standard uncertainties of the change.
    pub in_u: f64,
}

/// Request to write [`WhatIfAsked`] into the campaign.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Keep {
    /// Changes to write.
    pub asked: WhatIfAsked,
    /// Reason, which the report repeats.
    #[serde(default)]
    pub reason: String,
}

/// State of a measurement in progress.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Watch {
    /// Poses received.
    pub received: usize,
    /// Poses of the plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planned: Option<usize>,
    /// One line, readable from afar.
    pub line: String,
    /// Its colour.
    pub tone: Tone,
    /// Newest pose.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub latest: Option<Latest>,
    /// Parameters so far.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parameters: Option<Vec<ParameterNow>>,
    /// Pose to measure next.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next: Option<Next>,
    /// State of the stop rule.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stop: Option<Stop>,
    /// The robot and its measured points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<Scene>,
}

/// Colour of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Tone {
    /// As expected.
    Good,
    /// Nothing is known yet.
    #[default]
    Wait,
    /// Act before the next pose.
    Bad,
}

/// The newest pose.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Latest {
    /// Pose.
    pub pose: String,
    /// Target with the largest error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<String>,
    /// Measured minus predicted by the earlier poses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_um: Option<f64>,
    /// Error that the earlier poses and the instrument permit (95 %).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected_um: Option<f64>,
    /// `true` if the error is no larger than expected.
    pub agrees: bool,
    /// Description of the disagreement.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<ShownMessage>,
}

/// A parameter during a measurement.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ParameterNow {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Value.
    pub value: f64,
    /// Standard uncertainty now.
    pub u_now: f64,
    /// Standard uncertainty after the remaining poses of the plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub u_end: Option<f64>,
}

/// Pose to measure next.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Next {
    /// Pose.
    pub pose: String,
    /// Joint values.
    pub joints: Vec<f64>,
    /// Reason for this pose.
    pub reason: String,
}

/// State of the stop rule.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stop {
    /// `true` if the measurement may end.
    pub met: bool,
    /// Text of the state.
    pub text: String,
}

/// Answers to the questions of a proposal.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Asked {
    /// Name of a known robot, or of a dropped robot.toml or URDF.
    pub robot: Option<String>,
    /// Answers by the id of the question.
    pub answers: BTreeMap<String, String>,
}

/// A campaign proposed from the dropped files.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Proposal {
    /// Text of campaign.toml.
    pub campaign: String,
    /// Robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub robot: Option<String>,
    /// Changes of campaign.toml by the answers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference: Option<String>,
    /// Interpretation of each file.
    pub files: Vec<FileProposal>,
    /// Questions to which the files have no answer.
    pub questions: Vec<Question>,
    /// Messages.
    pub messages: Vec<ShownMessage>,
}

/// Interpretation of a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct FileProposal {
    /// Name.
    pub name: String,
    /// Columns.
    pub columns: Vec<ColumnRead>,
    /// First rows.
    pub rows: Vec<Vec<String>>,
    /// First lines, of a file without a table.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lines: Vec<String>,
}

/// Interpretation of a column.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ColumnRead {
    /// Heading in the file.
    pub heading: String,
    /// Contents.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub taken_for: Option<String>,
    /// Reason.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
}

/// A question to the user.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Question {
    /// Id, by which it is answered.
    pub id: String,
    /// Text.
    pub text: String,
    /// Possible answers; without them any text.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub options: Vec<QuestionOption>,
    /// Reason for the question.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub doubt: Option<String>,
}

/// A possible answer.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct QuestionOption {
    /// Value.
    pub value: String,
    /// Text of the button.
    pub label: String,
}
