//! Answer of `etalon axes`.

use crate::Provenance;
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Axes of joints from sweeps of one joint at a time (circle-point analysis).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxesDocument {
    /// Schema and version: `etalon/axes/1`.
    pub schema: String,
    /// Version and inputs.
    pub provenance: Provenance,
    /// `true` if joint values are known; otherwise joint values zero are the start of the sweeps.
    pub joint_values: bool,
    /// One axis for each joint, in the order of the joints.
    pub axes: Vec<AxisEntry>,
    /// Robot that follows from the axes; absent if joints have no sweep, or if
    /// a message of severity error says that it must not be used.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub robot: Option<AxesRobot>,
    /// Readings that belong to no sweep, compared with the robot.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<AxesCheck>,
    /// Warnings.
    pub messages: Vec<Message>,
}

/// Axis of one joint in the frame of the measurements, at the pose of its sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisEntry {
    /// Name of the joint.
    pub joint: String,
    /// `true` if the joint slides.
    pub prismatic: bool,
    /// Number of readings.
    pub readings: usize,
    /// Lines of readings that are excluded.
    pub set_aside: Vec<usize>,
    /// Position and direction of the axis.
    #[serde(flatten)]
    pub line: AxisLine,
    /// Standard uncertainty of a coordinate: as given, or from the residuals.
    pub coordinate_standard_uncertainty_mm: f64,
    /// Degrees of freedom of that uncertainty, effective ones where deviations are smooth; absent
    /// if it is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees_of_freedom: Option<usize>,
    /// Paths of the targets.
    pub paths: Vec<AxisPath>,
    /// Error motion along and about the axis.
    #[serde(flatten)]
    pub error_motion: AxisErrorMotion,
    /// Motion compared with the joint values.
    #[serde(flatten)]
    pub motion: AxisMotion,
}

/// Position and direction of an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AxisLine {
    /// Unit direction of positive motion.
    pub direction: Vector,
    /// Point of the axis nearest to the centroid of the readings; for a prismatic joint the
    /// centroid.
    pub point_mm: Vector,
    /// Covariance of point (mm) and direction, 6 × 6, in this order.
    pub covariance: [[f64; 6]; 6],
    /// Standard uncertainty of the direction: the larger of those about two perpendicular axes.
    pub direction_standard_uncertainty_deg: f64,
    /// Standard uncertainty of the point across the axis: the larger of two perpendicular
    /// directions; absent for a prismatic joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point_standard_uncertainty_mm: Option<f64>,
}

/// Error motion along and about an axis (ISO 230-7), with the part that noise alone gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AxisErrorMotion {
    /// Axial error motion (ISO 230-7), peak to valley; from three targets.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_error_motion_mm: Option<f64>,
    /// Tilt error motion (ISO 230-7), largest angle from the mean axis; from three targets.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt_error_motion_deg: Option<f64>,
    /// Axial error motion (mm) that noise alone gives.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_by_noise: Option<MotionByNoise>,
    /// Tilt error motion (deg) that noise alone gives.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt_by_noise: Option<MotionByNoise>,
}

/// Motion of a joint compared with its joint values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AxisMotion {
    /// Motion per unit of the joint value; absent without joint values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// Standard uncertainty of the ratio; absent without joint values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ratio_standard_uncertainty: Option<f64>,
    /// Root mean square of motion minus joint value (deg or mm); absent without joint values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion_rms: Option<f64>,
}

/// Path of a target about or along an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisPath {
    /// Name of the target.
    pub target: String,
    /// Number of readings used.
    pub readings: usize,
    /// Radius; absent for a sliding joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_mm: Option<f64>,
    /// Standard uncertainty of the radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_standard_uncertainty_mm: Option<f64>,
    /// Height relative to the point of the axis; absent for a prismatic joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height_mm: Option<f64>,
    /// Arc that the readings cover; absent for a prismatic joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arc_deg: Option<f64>,
    /// Length that the readings cover; absent for a revolute joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_mm: Option<f64>,
    /// Radial error motion (ISO 230-7) at this target, peak to valley, including the noise of the
    /// measuring system. For a prismatic joint: straightness in one transverse direction.
    pub radial_error_motion_mm: f64,
    /// Face error motion (ISO 230-7) at this radius, peak to valley, including the noise of the
    /// measuring system. For a prismatic joint: straightness in the other transverse direction.
    pub face_error_motion_mm: f64,
    /// Radial and face error motion (mm) that noise alone gives.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub by_noise: Option<MotionByNoise>,
}

/// Error motion of a perfect axis, by the noise of the measuring system.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotionByNoise {
    /// Expected value.
    pub expected: f64,
    /// Standard uncertainty of the measured value by noise.
    pub standard_uncertainty: f64,
}

/// Robot from its axes alone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxesRobot {
    /// Rule of the base: `common-normal`, `meeting`, `parallel`, `sliding` or `target`.
    pub base_rule: String,
    /// Position of the base in the frame of the measurements.
    pub base_xyz_mm: Vector,
    /// Orientation of the base in the frame of the measurements: unit quaternion w, x, y, z.
    pub base_quaternion: [f64; 4],
    /// Axes at joint values zero in the base.
    pub axes: Vec<ZeroAxis>,
    /// Position of the flange at joint values zero in the base.
    pub flange_xyz_mm: Vector,
    /// Orientation of the flange at joint values zero in the base: unit quaternion w, x, y, z.
    pub flange_quaternion: [f64; 4],
    /// Targets in the frame of the flange.
    pub targets: Vec<AxesTarget>,
    /// Convention of the robot file: `poe`, `dh` or `mdh`.
    pub convention: String,
    /// Parameters that the axes determine, then parameters that a convention fixes: base on the
    /// first axes, flange of `dh` and `mdh` on the last.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<AxesParameter>,
    /// Covariance of the parameters that the axes determine, in their order and units.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub covariance: Vec<Vec<f64>>,
    /// Text of robot.toml.
    pub robot_toml: String,
}

/// Parameter of the robot with its uncertainty by the sweeps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxesParameter {
    /// Name in the robot's model.
    pub name: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// Value.
    pub value: f64,
    /// Standard uncertainty (k = 1); 0 for a parameter that a convention fixes.
    pub standard_uncertainty: f64,
    /// Tolerance in `robot.toml`: the half-width of a rectangular distribution whose standard
    /// deviation covers the correlations, at least 4.3 standard uncertainties. Absent where the
    /// default tolerance of the model is smaller.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
}

/// Axis in the base at joint values zero.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZeroAxis {
    /// Name of the joint.
    pub joint: String,
    /// Unit direction of positive motion.
    pub direction: Vector,
    /// Point of the axis nearest to the origin of the base; absent for a prismatic joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point_mm: Option<Vector>,
    /// Standard uncertainty of the direction: root of the sum of squares of its components.
    pub direction_standard_uncertainty_deg: f64,
    /// Standard uncertainty of the point: root of the sum of squares of its components.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point_standard_uncertainty_mm: Option<f64>,
}

/// Target on the flange.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxesTarget {
    /// Name of the target.
    pub target: String,
    /// Position in the frame of the flange.
    pub xyz_mm: Vector,
    /// Standard uncertainties of the components.
    pub standard_uncertainty_mm: Vector,
}

/// Comparison of a reading with the position of the robot at its joint values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxesCheck {
    /// Line of the reading.
    pub line: usize,
    /// Name of the target.
    pub target: String,
    /// Distance of the reading from the predicted position.
    pub distance_mm: f64,
    /// Standard uncertainty of a component of the difference.
    pub standard_uncertainty_mm: f64,
}
