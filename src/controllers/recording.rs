//! A recording (MCAP) of the measured poses for Foxglove, Rerun and RViz: joint states, measured
//! and predicted positions, errors as markers, and transforms.
//!
//! Sources: definitions of `sensor_msgs`, `geometry_msgs`, `tf2_msgs` and `visualization_msgs`
//! (ROS 2 Humble); REP 103 (m, rad).

use super::{About, ExportInput, Exporter};
use etalon_base::error;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_documents::{ErrorQuantity, PointError};
use etalon_formats::cdr::CdrWriter;
use etalon_formats::mcap::{MessageType, RecordingWriter};
use etalon_robots::{Joint, MODELS, Quantity};

/// Recording of a run.
pub(super) struct Recording;

/// Length of the largest drawn error (m).
const LARGEST_DRAWN_M: f64 = 0.1;
/// Width of the line of a drawn error (m).
const LINE_WIDTH_M: f64 = 0.002;
/// Colours of errors before and after calibration: red, green, blue, opacity. The pair is safe for
/// colour-blind readers (Okabe and Ito 2008).
const COLOURS: [(&str, [f32; 4]); 2] = [("before", [0.84, 0.37, 0.0, 1.0]), ("after", [0.0, 0.45, 0.7, 1.0])];

impl Exporter for Recording {
    fn about(&self) -> About<'_> {
        About { shows_errors: true, ..About::laboratory("mcap", "measured.mcap") }
    }

    fn unsuited(&self, given: &ExportInput) -> Option<Message> {
        let has_positions = given.errors.is_some_and(|errors| errors.iter().any(is_position));
        (!has_positions).then(|| error!("positions-not-measured", format = self.name()))
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let errors: Vec<&PointError> = given.errors.into_iter().flatten().filter(|e| is_position(e)).collect();
        let mut file = File::new(given)?;
        let largest = errors.iter().map(|e| norm(e.before_mm)).fold(0.0, f64::max);
        // a power of ten, so that the scale is read at once
        let magnification =
            if largest > 0.0 { 10_f64.powf((LARGEST_DRAWN_M * 1e3 / largest).log10().floor()) } else { 1.0 };
        file.write("/points", &CLOUD, 0.0, cloud(given, &errors))?;
        let visits = errors.chunk_by(|a, b| (a.pose, a.cycle) == (b.pose, b.cycle));
        for (number, visit) in visits.enumerate() {
            file.write_visit(given, number, visit, magnification.max(1.0))?;
        }
        file.0.finish().map_err(failed)
    }
}

fn is_position(error: &PointError) -> bool {
    error.quantity == ErrorQuantity::Position
}

/// Name of the frame in which a position is given: the centre `C` of a platform is in the base.
fn frame(given: &ExportInput, target: &str) -> &'static str {
    let model = MODELS.into_iter().find(|model| model.name == given.parameters.robot);
    let is_centre = target == "C" && model.is_some_and(|model| model.has_platform);
    if is_centre { "base" } else { "world" }
}

fn failed(error: impl std::fmt::Display) -> Problems {
    error!("recording-failed", reason = error.to_string()).into()
}

/// A recording that is being written.
struct File(RecordingWriter);

impl File {
    fn new(given: &ExportInput) -> Result<Self> {
        let header = given.header("m, rad")?;
        let about = header.iter().enumerate().map(|(i, line)| (format!("{i:02}"), line.clone())).collect();
        RecordingWriter::new(about).map(Self).map_err(failed)
    }

    /// Writes one visit of a pose: all targets that were measured at it.
    fn write_visit(
        &mut self,
        given: &ExportInput,
        number: usize,
        visit: &[&PointError],
        magnification: f64,
    ) -> Result<()> {
        let Some(first) = visit.first() else { return Ok(()) };
        let joints = given.robot.map_or(&[][..], |robot| robot.joints());
        // without measured times a visit takes a second
        let time_s = first.joints.get(joints.len()).copied().filter(|t| *t >= 0.0).unwrap_or(number as f64);
        if first.joints.len() >= joints.len() && !joints.is_empty() {
            self.write("/joint_states", &JOINT_STATE, time_s, joint_state(time_s, joints, &first.joints))?;
            let transforms = transforms(given, joints, &first.joints);
            if !transforms.is_empty() {
                self.write("/tf", &TRANSFORMS, time_s, tf_message(time_s, &transforms))?;
            }
        }
        for error in visit {
            let predicted = minus(error.at_mm, error.after_mm);
            for (topic, position) in [("measured", error.at_mm), ("predicted", predicted)] {
                let topic = format!("/{topic}/{}", topic_name(&error.target));
                self.write(&topic, &POINT, time_s, point(time_s, frame(given, &error.target), position))?;
            }
        }
        self.write("/errors", &MARKERS, time_s, markers(given, time_s, number, visit, magnification))
    }

    fn write(&mut self, topic: &str, kind: &MessageKind, time_s: f64, data: Vec<u8>) -> Result<()> {
        let kind = || MessageType { name: kind.name, definition: kind.definition() };
        self.0.write(topic, kind, time_s, &data).map_err(failed)
    }
}

/// Returns a name of a topic: letters, digits and `_` (ROS 2 names of topics).
fn topic_name(target: &str) -> String {
    let name: String = target.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("target_{name}") } else { name }
}

/// Poses of the base in the world and of the tool in the base, with the identified parameters.
fn transforms(given: &ExportInput, joints: &[Joint], logged: &[f64]) -> Vec<(&'static str, &'static str, Pose)> {
    let inside: Vec<f64> = joints.iter().zip(logged).map(|(joint, value)| joint.quantity.inward(*value)).collect();
    let Ok((robot, values)) = given.robot() else { return Vec::new() };
    let Some(kinematics) = robot.kinematics() else { return Vec::new() };
    let base = kinematics.base_in_world(&values).map(|pose| ("world", "base", pose));
    let tool = kinematics.tool_pose(&values, &inside).map(|pose| ("base", "tool", pose));
    base.into_iter().chain(tool).collect()
}

/// Type of a message.
struct MessageKind {
    name: &'static str,
    fields: &'static str,
    /// Types of the fields.
    parts: &'static [&'static str],
}

impl MessageKind {
    /// Returns the definition of the type, followed by the definitions of the types of its fields,
    /// as rosbag2 stores them.
    fn definition(&self) -> String {
        let line = "=".repeat(80);
        let part = |name: &&str| {
            let fields = PARTS.iter().find(|(known, _)| known == name).map_or("", |(_, fields)| fields);
            format!("{line}\nMSG: {name}\n{fields}")
        };
        [self.fields.to_owned()].into_iter().chain(self.parts.iter().map(part)).collect()
    }
}

const JOINT_STATE: MessageKind = MessageKind {
    name: "sensor_msgs/msg/JointState",
    fields: "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n",
    parts: &["std_msgs/Header", "builtin_interfaces/Time"],
};
const POINT: MessageKind = MessageKind {
    name: "geometry_msgs/msg/PointStamped",
    fields: "std_msgs/Header header\ngeometry_msgs/Point point\n",
    parts: &["std_msgs/Header", "builtin_interfaces/Time", "geometry_msgs/Point"],
};
const CLOUD: MessageKind = MessageKind {
    name: "sensor_msgs/msg/PointCloud2",
    fields: "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\nbool is_bigendian\n\
             uint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n",
    parts: &["std_msgs/Header", "builtin_interfaces/Time", "sensor_msgs/PointField"],
};
const TRANSFORMS: MessageKind = MessageKind {
    name: "tf2_msgs/msg/TFMessage",
    fields: "geometry_msgs/TransformStamped[] transforms\n",
    parts: &[
        "geometry_msgs/TransformStamped",
        "std_msgs/Header",
        "builtin_interfaces/Time",
        "geometry_msgs/Transform",
        "geometry_msgs/Vector3",
        "geometry_msgs/Quaternion",
    ],
};
const MARKERS: MessageKind = MessageKind {
    name: "visualization_msgs/msg/MarkerArray",
    fields: "visualization_msgs/Marker[] markers\n",
    parts: &[
        "visualization_msgs/Marker",
        "std_msgs/Header",
        "builtin_interfaces/Time",
        "builtin_interfaces/Duration",
        "geometry_msgs/Pose",
        "geometry_msgs/Point",
        "geometry_msgs/Quaternion",
        "geometry_msgs/Vector3",
        "std_msgs/ColorRGBA",
        "sensor_msgs/CompressedImage",
        "visualization_msgs/UVCoordinate",
        "visualization_msgs/MeshFile",
    ],
};
/// Definitions of the types of fields (ROS 2 Humble).
const PARTS: [(&str, &str); 15] = [
    ("std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"),
    ("builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"),
    ("builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"),
    ("geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"),
    ("geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"),
    ("geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"),
    ("geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"),
    ("geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"),
    (
        "geometry_msgs/TransformStamped",
        "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n",
    ),
    ("std_msgs/ColorRGBA", "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n"),
    ("sensor_msgs/PointField", "string name\nuint32 offset\nuint8 datatype\nuint32 count\n"),
    ("sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"),
    ("visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"),
    ("visualization_msgs/MeshFile", "string filename\nuint8[] data\n"),
    (
        "visualization_msgs/Marker",
        "std_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\ngeometry_msgs/Pose pose\n\
         geometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\nbuiltin_interfaces/Duration lifetime\n\
         bool frame_locked\ngeometry_msgs/Point[] points\nstd_msgs/ColorRGBA[] colors\nstring texture_resource\n\
         sensor_msgs/CompressedImage texture\nvisualization_msgs/UVCoordinate[] uv_coordinates\nstring text\n\
         string mesh_resource\nvisualization_msgs/MeshFile mesh_file\nbool mesh_use_embedded_materials\n",
    ),
];
/// `Marker::LINE_LIST`: pairs of points.
const LINE_LIST: u32 = 5;

/// A position (m).
fn metres(position_mm: Vector) -> Vector {
    position_mm.map(|v| v / 1e3)
}

fn point(time_s: f64, frame: &str, position_mm: Vector) -> Vec<u8> {
    CdrWriter::default().header(time_s, frame).numbers(metres(position_mm)).finish()
}

/// All measured points (m) with their errors (mm) before and after calibration.
fn cloud(given: &ExportInput, errors: &[&PointError]) -> Vec<u8> {
    const FIELDS: [&str; 5] = ["x", "y", "z", "before_mm", "after_mm"];
    const FLOAT32: u8 = 7;
    let frame = errors.first().map_or("world", |error| frame(given, &error.target));
    let out = CdrWriter::default().header(0.0, frame).count(1).count(errors.len()).count(FIELDS.len());
    let field = |out: CdrWriter, (i, name): (usize, &&str)| out.text(name).count(4 * i).value([FLOAT32]).count(1);
    let step = 4 * FIELDS.len();
    let out = FIELDS.iter().enumerate().fold(out, field).value([0]).count(step).count(step * errors.len());
    let point = |error: &&PointError| {
        let [x, y, z] = metres(error.at_mm);
        [x, y, z, norm(error.before_mm), norm(error.after_mm)].map(|value| (value as f32).to_le_bytes())
    };
    let data = errors.iter().flat_map(point).flatten();
    out.count(step * errors.len()).bytes(data).value([1]).finish()
}

fn joint_state(time_s: f64, joints: &[Joint], logged: &[f64]) -> Vec<u8> {
    let out = CdrWriter::default().header(time_s, "").count(joints.len());
    let out = joints.iter().fold(out, |out, joint| out.text(&joint.name)).count(joints.len());
    let values = joints.iter().zip(logged).map(|(joint, value)| match joint.quantity {
        Quantity::Length => value / 1e3,
        _ => joint.quantity.inward(*value),
    });
    out.numbers(values).count(0).count(0).finish()
}

fn tf_message(time_s: f64, transforms: &[(&str, &str, Pose)]) -> Vec<u8> {
    let out = CdrWriter::default().count(transforms.len());
    let write = |out: CdrWriter, (parent, child, pose): &(&str, &str, Pose)| {
        let [w, x, y, z] = pose.quaternion();
        out.header(time_s, parent).text(child).numbers(metres(pose.translation_mm)).numbers([x, y, z, w])
    };
    transforms.iter().fold(out, write).finish()
}

/// Errors as lines that begin at the measured position, magnified.
fn markers(given: &ExportInput, time_s: f64, number: usize, visit: &[&PointError], magnification: f64) -> Vec<u8> {
    let frame = visit.first().map_or("world", |error| frame(given, &error.target));
    COLOURS
        .into_iter()
        .enumerate()
        .fold(CdrWriter::default().count(COLOURS.len()), |out, (which, (name, colour))| {
            let ends = visit.iter().flat_map(|error| {
                let vector = if which == 0 { error.before_mm } else { error.after_mm };
                [error.at_mm, minus(error.at_mm, vector.map(|v| v * magnification))]
            });
            let out =
                out.header(time_s, frame).text(&format!("{name}, {magnification} x")).count(number).whole(LINE_LIST);
            // added at the origin of the frame, kept for good
            let out = out.whole(0).numbers([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]).numbers([LINE_WIDTH_M, 0.0, 0.0]);
            let out = colour
                .into_iter()
                .fold(out, |out, value| out.value(value.to_le_bytes()))
                .whole(0)
                .whole(0)
                .value([0])
                .count(2 * visit.len());
            let out = ends.fold(out, |out, end| out.numbers(metres(end))).count(0).text("");
            // no texture, text or mesh
            out.header(0.0, "").text("").count(0).count(0).text("").text("").text("").count(0).value([0])
        })
        .finish()
}
