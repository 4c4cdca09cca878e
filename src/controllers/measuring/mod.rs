//! Measuring programs: a controller moves the joints to each pose of a plan and waits. Each file
//! contains one language.

mod fanuc;
mod gcode;
mod inform;
mod karel;
mod krl;
mod rapid;
mod urscript;

use crate::commands::{identifier, number_text};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_robots::{Joint, Quantity};

/// Number of decimals of joint values in mm, deg or rad.
const DECIMALS: usize = 6;
/// Number of revolute joints of an arm: all languages here move arms with six joints.
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
    /// Name of the program and of its file.
    pub name: &'a str,
    /// Lines of the header.
    pub header: Vec<String>,
    /// Joints of the robot: external axes, then the joints of the arm.
    pub joints: &'a [Joint],
    /// Poses in the order of measurement.
    pub stops: Vec<Stop>,
    /// Waiting time (s) at each pose.
    pub dwell_s: f64,
    /// Settings of the controller.
    pub stated: Stated<'a>,
}

/// Settings of a controller, as given.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stated<'a> {
    /// Digital output that is on during the second half of the waiting time.
    pub trigger: Option<&'a str>,
    /// Letters of the axes, one for each joint.
    pub axes: &'a str,
    /// Pulses per deg or mm of each joint.
    pub pulses: &'a [f64],
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

    /// Commands at a pose, of the waiting times and of the output.
    fn waits(&self, wait: impl Fn(f64) -> String, set: impl Fn(&str, bool) -> String) -> Vec<String> {
        match self.stated.trigger {
            Some(output) => {
                let half = 0.5 * self.dwell_s;
                vec![wait(half), set(output, true), wait(half), set(output, false)]
            }
            None => vec![wait(self.dwell_s)],
        }
    }
}

/// Joints that a language moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moves {
    /// Six revolute joints, after prismatic external axes.
    Arm {
        /// Largest number of external axes.
        external: usize,
    },
    /// Any joints, each by the letter of its axis.
    Axes,
}

/// Digital outputs of a language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// Name of a signal.
    Signal,
    /// Number within limits.
    Number([u32; 2]),
}

impl Output {
    fn has(self, name: &str) -> bool {
        match self {
            Self::Signal => {
                let is_letter = |c: char| c.is_ascii_alphabetic();
                let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
                name.starts_with(is_letter) && name.chars().all(is_part) && name.len() <= 32
            }
            Self::Number([first, last]) => {
                let is_plain = name.chars().all(|c| c.is_ascii_digit());
                is_plain && name.parse().is_ok_and(|number: u32| (first..=last).contains(&number))
            }
        }
    }
}

/// A language of measuring programs.
pub trait MeasuringLanguage: Sync {
    /// Joints that it moves.
    fn moves(&self) -> Moves {
        Moves::Arm { external: 0 }
    }

    /// Its digital outputs.
    fn outputs(&self) -> Output;

    /// `true` if it commands pulses of the motors.
    fn needs_pulses(&self) -> bool {
        false
    }

    /// Value (deg or mm) that it commands for a joint value, with the pulses per unit of the joint.
    fn attained(&self, value: f64, _pulses: f64) -> f64 {
        value
    }

    /// Text of the program.
    fn text(&self, program: &MeasuringProgram) -> String;
}

/// Languages by name, with file extensions.
const LANGUAGES: [(&str, &dyn MeasuringLanguage, &[&str]); 7] = [
    ("rapid", &rapid::Rapid, &["mod", "modx"]),
    ("krl", &krl::Krl, &["src"]),
    ("urscript", &urscript::UrScript, &["script", "urscript"]),
    ("fanuc", &fanuc::Fanuc, &["ls"]),
    ("karel", &karel::Karel, &["kl"]),
    ("inform", &inform::Inform, &["jbi"]),
    ("gcode", &gcode::Gcode, &["ngc", "nc", "gcode"]),
];

/// Names of the languages.
pub fn names() -> impl Iterator<Item = &'static str> {
    LANGUAGES.iter().map(|(name, ..)| *name)
}

/// Returns the language with this name, or else of files with this extension.
pub fn language(name: Option<&str>, ending: &str) -> Option<(&'static str, &'static dyn MeasuringLanguage)> {
    let ending = ending.to_ascii_lowercase();
    let is_meant = |(known, _, endings): &&(&str, _, &[&str])| match name {
        Some(name) => *known == name,
        None => endings.contains(&ending.as_str()),
    };
    LANGUAGES.iter().find(is_meant).map(|(name, language, _)| (*name, *language))
}

/// Checks that a language moves these joints, and that the settings which it needs are given.
///
/// # Errors
///
/// Reports other joints, a joint whose motor is logged (its value is not the joint value), and
/// missing or unsuited settings.
pub fn check(
    name: &str,
    language: &dyn MeasuringLanguage,
    joints: &[Joint],
    gain: impl Fn(usize) -> f64,
    stated: &Stated,
) -> Result<()> {
    const AS_JOINT: f64 = 0.1;
    if let Moves::Arm { external: most } = language.moves() {
        check_arm(name, joints, most)?;
    }
    if let Some(k) = (0..joints.len()).find(|&k| (gain(k) - 1.0).abs() > AS_JOINT) {
        return Err(error!("measuring-motor-values", joint = &joints[k].name, gain = gain(k)).into());
    }
    if language.moves() == Moves::Axes && stated.axes.len() != joints.len() {
        return Err(error!("measuring-axes-missing", language = name, joints = joints.len()).into());
    }
    if language.needs_pulses() && stated.pulses.len() != joints.len() {
        return Err(error!("measuring-pulses-missing", language = name, joints = joints.len()).into());
    }
    match stated.trigger.filter(|output| !language.outputs().has(output)) {
        Some(output) => {
            let Output::Number([first, last]) = language.outputs() else {
                return Err(error!("measuring-output-unsuited", language = name, output, first = 0, last = 0).into());
            };
            Err(error!("measuring-output-unsuited", language = name, output, first, last).into())
        }
        None => Ok(()),
    }
}

/// Checks for six revolute joints, after at most `most` prismatic external axes.
fn check_arm(language: &str, joints: &[Joint], most: usize) -> Result<()> {
    let (external, arm) = joints.split_at(joints.len().saturating_sub(ARM));
    let suited = arm.len() == ARM
        && arm.iter().all(|joint| joint.quantity == Quantity::Angle)
        && external.iter().all(|joint| joint.quantity != Quantity::Angle)
        && external.len() <= most;
    if suited {
        return Ok(());
    }
    let revolute = joints.iter().filter(|joint| joint.quantity == Quantity::Angle).count();
    let prismatic = joints.len() - revolute;
    Err(error!("measuring-joints-unsuited", language, revolute, prismatic, external = most).into())
}

/// Header in lines of at most `most` characters, broken between words.
fn lines(header: &[String], most: usize) -> impl Iterator<Item = String> {
    let mut all: Vec<String> = Vec::new();
    for line in header {
        let mut now = String::new();
        for word in plain(line).split_whitespace() {
            let word: String = word.chars().take(most).collect();
            if !now.is_empty() && now.len() + 1 + word.len() > most {
                all.push(std::mem::take(&mut now));
            }
            now = if now.is_empty() { word } else { format!("{now} {word}") };
        }
        all.push(now);
    }
    all.into_iter()
}

/// Returns the nearest value with this number of decimals.
fn rounded(value: f64, decimals: usize) -> f64 {
    let unit = 10f64.powi(decimals as i32);
    (value * unit).round() / unit
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
