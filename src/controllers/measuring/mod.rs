//! Measuring programs: a controller moves the joints to each pose of a plan and waits. One language
//! a file.

mod krl;
mod rapid;
mod urscript;

use crate::commands::number_text;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_robots::{Joint, Quantity};

/// Number of decimals of joint values in mm, deg or rad.
const DECIMALS: usize = 6;
/// Number of revolute joints of the arms that the languages move.
const ARM: usize = 6;

/// A pose at which the program waits.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// Name of the pose, with the number of its configuration if it has several.
    pub label: String,
    /// Joint values (mm or deg) in the robot's order.
    pub joints: Vec<f64>,
    /// Joint values before, from which joints with backlash arrive in the planned direction.
    pub approach: Option<Vec<f64>>,
}

/// Contents of a measuring program.
#[derive(Clone, Debug)]
pub struct MeasuringProgram<'a> {
    /// Name of the program: that of its file.
    pub name: &'a str,
    /// Lines of the header.
    pub header: Vec<String>,
    /// Joints of the robot: external axes, then those of the arm.
    pub joints: &'a [Joint],
    /// Poses in the order of measurement.
    pub stops: Vec<Stop>,
    /// Waiting time (s) at each pose.
    pub dwell_s: f64,
}

impl MeasuringProgram<'_> {
    /// Number of external axes.
    fn external(&self) -> usize {
        self.joints.len().saturating_sub(ARM)
    }

    /// Header as comments of ASCII text.
    fn comments(&self, mark: &str) -> String {
        self.header.iter().map(|line| format!("{mark} {}\n", plain(line))).collect()
    }
}

/// A language of measuring programs.
pub trait MeasuringLanguage: Sync {
    /// Largest number of external axes.
    fn most_external(&self) -> usize;

    /// Text of the program.
    fn text(&self, program: &MeasuringProgram) -> String;
}

/// Languages by name, with file extensions.
const LANGUAGES: [(&str, &dyn MeasuringLanguage, &[&str]); 3] = [
    ("rapid", &rapid::Rapid, &["mod", "modx"]),
    ("krl", &krl::Krl, &["src"]),
    ("urscript", &urscript::UrScript, &["script", "urscript"]),
];

/// Names of the languages.
pub fn names() -> impl Iterator<Item = &'static str> {
    LANGUAGES.iter().map(|(name, ..)| *name)
}

/// Language with this name, or else of files with this extension.
pub fn language(name: Option<&str>, ending: &str) -> Option<(&'static str, &'static dyn MeasuringLanguage)> {
    let ending = ending.to_ascii_lowercase();
    let is_meant = |(known, _, endings): &&(&str, _, &[&str])| match name {
        Some(name) => *known == name,
        None => endings.contains(&ending.as_str()),
    };
    LANGUAGES.iter().find(is_meant).map(|(name, language, _)| (*name, *language))
}

/// Checks that a language moves these joints: six revolute ones, after prismatic external axes.
///
/// # Errors
///
/// Reports other joints, and a joint whose motor is logged: its value is not that of the joint.
pub fn check(
    (name, language): (&str, &dyn MeasuringLanguage),
    joints: &[Joint],
    gain: impl Fn(usize) -> f64,
) -> Result<()> {
    const AS_JOINT: f64 = 0.1;
    let (external, arm) = joints.split_at(joints.len().saturating_sub(ARM));
    let suited = arm.len() == ARM
        && arm.iter().all(|joint| joint.quantity == Quantity::Angle)
        && external.iter().all(|joint| joint.quantity != Quantity::Angle)
        && external.len() <= language.most_external();
    if !suited {
        let revolute = joints.iter().filter(|joint| joint.quantity == Quantity::Angle).count();
        let (prismatic, external) = (joints.len() - revolute, language.most_external());
        return Err(error!("measuring-joints-unsuited", language = name, revolute, prismatic, external).into());
    }
    let motor = (0..joints.len()).find(|&k| (gain(k) - 1.0).abs() > AS_JOINT);
    motor.map_or(Ok(()), |k| Err(error!("measuring-motor-values", joint = &joints[k].name, gain = gain(k)).into()))
}

/// Decimal text of a joint value.
fn decimal(value: f64) -> String {
    number_text(value, DECIMALS)
}

/// Printable ASCII text without quotation marks and backslashes, which end or change texts of
/// programs.
fn plain(text: &str) -> String {
    let safe = |c: char| if (c.is_ascii_graphic() || c == ' ') && !"\"\\".contains(c) { c } else { '?' };
    text.chars().map(safe).take(70).collect()
}
