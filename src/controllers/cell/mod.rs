//! Tools and work objects as data of controllers, one maker a file.

mod abb;
mod fanuc;
mod kuka;
#[cfg(test)]
mod tests;
mod universal_robots;

use crate::comment;
use etalon_base::pose::{Pose, Vector, norm};
use etalon_documents::CellDocument;

/// Place of the frame in the data of a controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellPart {
    /// Tool in the flange.
    Tool,
    /// Work object or base in the base of the robot.
    Object,
}

/// Frame with its name and number.
#[derive(Clone, Debug)]
pub struct CellData {
    /// Place in the data.
    pub part: CellPart,
    /// Pose of tool or object.
    pub pose: Pose,
    /// Name.
    pub name: String,
    /// Number of the tool or base.
    pub number: u32,
    /// Header: version, source, standard uncertainties.
    pub header: Vec<String>,
}

/// Data of one maker.
pub trait CellFormat: Sync {
    /// Name on the command line.
    fn name(&self) -> &'static str;

    /// Text that the controller reads, or that is copied into its data.
    fn text(&self, data: &CellData) -> String;
}

/// All makers.
const FORMATS: [&dyn CellFormat; 4] = [&abb::Abb, &kuka::Kuka, &fanuc::Fanuc, &universal_robots::UniversalRobots];

/// Names of all makers.
pub fn names() -> impl Iterator<Item = &'static str> {
    FORMATS.iter().map(|format| format.name())
}

/// Format of a maker.
pub fn by_name(name: &str) -> Option<&'static dyn CellFormat> {
    FORMATS.into_iter().find(|format| format.name() == name)
}

impl CellData {
    /// Tool or object of a document; `None` for external axes.
    pub fn new(document: &CellDocument, name: &str, number: u32) -> Option<Self> {
        let frame = document.frames.first();
        let point = document.points.first();
        let part = match document.solve.as_str() {
            "object" | "three-points" => CellPart::Object,
            "linear-axis" | "rotary-axis" => return None,
            _ => CellPart::Tool,
        };
        let mut header = vec![
            format!("Written by etalon {}", document.provenance.version),
            format!("solved: {}, {} readings", document.solve, document.readings),
        ];
        header.extend(document.provenance.inputs.iter().map(|(file, hash)| format!("table {file}, sha256 {hash}")));
        let of_point = matches!(document.solve.as_str(), "tool-point" | "tool-reflector");
        let (pose, u_mm, u_deg) = match (point, frame) {
            (Some(point), _) if of_point => {
                header.push("orientation: not identified, that of the flange".to_owned());
                (Pose { translation_mm: point.xyz_mm, ..Pose::identity() }, point.standard_uncertainty_mm, None)
            }
            (_, Some(frame)) => {
                let pose = Pose { translation_mm: frame.xyz_mm, ..Pose::from_quaternion(frame.quaternion) };
                (pose, frame.standard_uncertainty_mm, frame.standard_uncertainty_deg)
            }
            _ => return None,
        };
        header.push(uncertainty("position", u_mm, "mm"));
        if !of_point {
            header.push(uncertainty("orientation about x, y, z", u_deg, "deg"));
        }
        let header = header.iter().map(|line| comment(line)).collect();
        Some(Self { part, pose, name: name.to_owned(), number, header })
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
    super::roll_pitch_yaw(pose).map(f64::to_degrees)
}
