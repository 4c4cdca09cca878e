//! Tools, work objects, base frames and rotary axes as data of controllers, one format a file.

mod abb;
mod abb_moc;
mod fanuc;
mod grblhal;
mod kuka;
mod linuxcnc_pivot;
mod linuxcnc_trt;
mod machine;
#[cfg(test)]
mod tests;
mod universal_robots;
mod yaskawa;

use crate::comment;
use etalon_base::error;
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, Vector, norm};
use etalon_documents::{CellDocument, CellFrameEntry};
use linuxcnc_pivot::Pivot;
use linuxcnc_trt::TiltingTable;
use machine::MachineAxis;

/// Place of the frame in the data of a controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellPart {
    /// Tool in the flange.
    Tool,
    /// Work object or base in the base of the robot.
    Object,
    /// Base of the robot in the frame of the measured points.
    Base,
    /// External rotary axis in the frame of the measured points: z along the axis.
    Axis,
}

/// Data of the user beside the answer.
#[derive(Clone, Debug, Default)]
pub struct CellOptions {
    /// Name of the tool, object or mechanical unit.
    pub name: String,
    /// Number of the tool, base or machine.
    pub number: u32,
    /// Answer of the second rotary axis of the same machine.
    pub second: Option<CellDocument>,
    /// Length (mm) of the tool at whose end the first target is.
    pub tool_length_mm: Option<f64>,
}

/// Frame with its name and number.
#[derive(Clone, Debug)]
pub struct CellData {
    /// Place in the data.
    pub part: CellPart,
    /// Pose of tool, object, base or axis.
    pub pose: Pose,
    /// Name.
    pub name: String,
    /// Number of the tool, base or machine.
    pub number: u32,
    /// Header: version, source, standard uncertainties.
    pub header: Vec<String>,
    /// Rotary axes: first the axis of the answer, then the second one.
    axes: Vec<MachineAxis>,
    /// Length (mm) of the tool at whose end the first target is.
    tool_length_mm: Option<f64>,
}

/// Data of a controller, and warnings about them.
#[derive(Clone, Debug, PartialEq)]
pub struct CellText {
    /// Text that the controller reads, or that is copied into its data.
    pub text: String,
    /// Warnings.
    pub messages: Vec<Message>,
}

impl From<String> for CellText {
    fn from(text: String) -> Self {
        Self { text, messages: Vec::new() }
    }
}

/// Data of one controller.
pub trait CellFormat: Sync {
    /// Name on the command line.
    fn name(&self) -> &'static str;

    /// Parts that the format holds; of an answer with several, the first one is written.
    fn parts(&self) -> &'static [CellPart];

    /// Data of the controller.
    ///
    /// # Errors
    /// Rejects answers that the controller cannot hold.
    fn text(&self, data: &CellData) -> Result<CellText>;
}

/// All formats.
const FORMATS: [&dyn CellFormat; 11] = [
    &abb::Abb,
    &abb_moc::AbbMoc,
    &kuka::Kuka,
    &fanuc::Fanuc,
    &universal_robots::UniversalRobots,
    &yaskawa::Yaskawa,
    &TiltingTable::XYZAC,
    &TiltingTable::XYZBC,
    &Pivot::MAX,
    &Pivot::FIVE_AXIS,
    &grblhal::GrblHal,
];

/// Writes the data of a controller.
///
/// # Errors
/// Rejects answers that the controller cannot hold.
pub fn write(format: &dyn CellFormat, document: &CellDocument, options: &CellOptions) -> Result<CellText> {
    let data = format.parts().iter().find_map(|part| CellData::new(document, *part, options));
    let maker = format.name();
    match data {
        Some(data) => format.text(&data),
        None => Err(error!("cell-no-controller-data", solve = document.solve, maker).into()),
    }
}

/// Names of all makers.
pub fn names() -> impl Iterator<Item = &'static str> {
    FORMATS.iter().map(|format| format.name())
}

/// Format of a maker.
pub fn by_name(name: &str) -> Option<&'static dyn CellFormat> {
    FORMATS.into_iter().find(|format| format.name() == name)
}

/// Position, orientation and standard uncertainties of an answer.
struct Answer {
    pose: Pose,
    u_mm: Option<Vector>,
    /// `None` without an identified orientation.
    u_deg: Option<Option<Vector>>,
}

impl Answer {
    fn from_frame(frame: &CellFrameEntry) -> Self {
        let pose = Pose { translation_mm: frame.xyz_mm, ..Pose::from_quaternion(frame.quaternion) };
        Self { pose, u_mm: frame.standard_uncertainty_mm, u_deg: Some(frame.standard_uncertainty_deg) }
    }

    /// Answer of a document for a part of the data.
    fn from_document(document: &CellDocument, part: CellPart) -> Option<Self> {
        let solve = document.solve.as_str();
        let of_plane = matches!(solve, "object" | "three-points");
        let of_axis = matches!(solve, "linear-axis" | "rotary-axis");
        let frame = match part {
            CellPart::Tool if matches!(solve, "tool-point" | "tool-reflector") => {
                let point = document.points.first()?;
                let pose = Pose { translation_mm: point.xyz_mm, ..Pose::identity() };
                return Some(Self { pose, u_mm: point.standard_uncertainty_mm, u_deg: None });
            }
            CellPart::Tool if !of_plane && !of_axis => document.frames.first(),
            CellPart::Object if of_plane => document.frames.first(),
            CellPart::Base if of_plane => document.frames.first(),
            CellPart::Base => document.frames.iter().find(|f| f.name == "base" && f.reference == "world"),
            CellPart::Axis if solve == "rotary-axis" => document.frames.first(),
            _ => None,
        };
        frame.map(Self::from_frame)
    }
}

impl CellData {
    /// Part of a document; `None` if the document lacks it.
    fn new(document: &CellDocument, part: CellPart, options: &CellOptions) -> Option<Self> {
        let answer = Answer::from_document(document, part)?;
        let mut header = vec![
            format!("Written by etalon {}", document.provenance.version),
            format!("solved: {}, {} readings", document.solve, document.readings),
        ];
        let documents: Vec<&CellDocument> = [document].into_iter().chain(&options.second).collect();
        let failed: Vec<&str> = documents.iter().flat_map(|d| d.errors()).map(|m| m.what.as_str()).collect();
        if !failed.is_empty() {
            header.push(format!("NOT FIT FOR A CONTROLLER, written by force: {}", failed.join("; ")));
        }
        let inputs = documents.iter().flat_map(|d| &d.provenance.inputs);
        header.extend(inputs.map(|(file, hash)| format!("table {file}, sha256 {hash}")));
        if answer.u_deg.is_none() {
            header.push("orientation: not identified, that of the flange".to_owned());
        }
        header.push(uncertainty("position", answer.u_mm, "mm"));
        header.extend(answer.u_deg.map(|u_deg| uncertainty("orientation about x, y, z", u_deg, "deg")));
        Some(Self {
            part,
            pose: answer.pose,
            name: options.name.clone(),
            number: options.number,
            header: header.iter().map(|line| comment(line)).collect(),
            axes: documents.into_iter().filter_map(MachineAxis::new).collect(),
            tool_length_mm: options.tool_length_mm,
        })
    }
}

/// Line of the header with standard uncertainties.
fn uncertainty(what: &str, u: Option<Vector>, unit: &str) -> String {
    match u.filter(|u| norm(*u).is_finite()) {
        Some([x, y, z]) => format!("standard uncertainty of the {what}: {x:.6}, {y:.6}, {z:.6} {unit} (k = 1)"),
        None => format!("standard uncertainty of the {what}: unknown"),
    }
}

/// Name that all controllers accept: letters, digits and underscores, with a letter first.
fn identifier(name: &str, longest: usize) -> String {
    super::commands::identifier(name, longest)
}

/// Roll, pitch and yaw (deg) of Rz(yaw) Ry(pitch) Rx(roll).
fn roll_pitch_yaw_deg(pose: &Pose) -> Vector {
    pose.rpy_rad().map(f64::to_degrees)
}
