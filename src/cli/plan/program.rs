//! Options of the measuring program of a plan.

use crate::tasks::checks::check_positive;
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::Result;
use etalon_controllers::measuring::{MeasuringLanguage, MeasuringProgram, Stated, Stop, check, language, names};
use etalon_documents::{PlanDocument, PlannedProgram};
use etalon_identify::plan::generate::approach;
use etalon_robots::Robot;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Options of the measuring program.
#[derive(Debug, clap::Args)]
pub(super) struct Program {
    /// Write a program that moves the joints to the chosen poses in the order of measurement and
    /// waits: RAPID (.mod), KRL (.src), URScript (.script), FANUC TP (.ls), Karel (.kl), INFORM
    /// (.jbi) or G-code (.ngc).
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
    /// Language of the program; by default from the file extension.
    #[arg(long, value_name = "LANGUAGE", requires = "program", value_parser = clap::builder::PossibleValuesParser::new(names()))]
    program_language: Option<String>,
    /// Waiting time at each pose in seconds.
    #[arg(long, value_name = "SECONDS", default_value_t = 3.0)]
    dwell: f64,
    /// Digital output that is on during the second half of the waiting time, to trigger the
    /// instrument: its number, or its signal in RAPID.
    #[arg(long, value_name = "OUTPUT", requires = "program")]
    trigger: Option<String>,
    /// Letters of the controller's axes in the order of the joints, for G-code: of XYZABCUVW.
    #[arg(long, value_name = "LETTERS", requires = "program", value_parser = letters)]
    axes: Option<String>,
    /// Pulses per deg or mm of each joint in their order, with sign, for INFORM.
    #[arg(long, value_name = "P1,P2,...", requires = "program", value_delimiter = ',', value_parser = pulses, allow_hyphen_values = true)]
    pulses: Vec<f64>,
}

impl Program {
    /// File to write, if any.
    pub(super) fn file(&self) -> Option<&PathBuf> {
        self.program.as_ref()
    }

    /// Checks the options before anything is computed.
    ///
    /// # Errors
    /// Reports a file of an unknown language, and joints that the language does not move.
    pub(super) fn check(&self, robot: &dyn Robot) -> Result<()> {
        let Some(path) = &self.program else { return Ok(()) };
        check_positive("--dwell", Some(self.dwell))?;
        let (name, language) = self.measuring_language(path)?;
        check(name, language, robot.joints(), |k| robot.nominal_gain(k), &self.stated())
    }

    fn stated(&self) -> Stated<'_> {
        let axes = self.axes.as_deref().unwrap_or_default();
        Stated { trigger: self.trigger.as_deref(), axes, pulses: &self.pulses }
    }

    /// Changes the joint values of the document to the values that the program commands, and adds
    /// the program to it, if one is written.
    ///
    /// # Errors
    /// Reports a file of an unknown language.
    pub(super) fn complete(&self, robot: &dyn Robot, document: &mut PlanDocument) -> Result<()> {
        let Some(path) = &self.program else { return Ok(()) };
        let (name, language) = self.measuring_language(path)?;
        for values in document.choice.chosen.iter_mut().flat_map(|pose| &mut pose.configurations) {
            for (k, joint) in robot.joints().iter().enumerate() {
                if let Some(value) = values.get_mut(&joint.column()) {
                    *value = language.attained(*value, self.pulses.get(k).copied().unwrap_or(1.0));
                }
            }
        }
        let file = path.file_name().map(|file| file.to_string_lossy().into_owned());
        document.choice.program = Some(PlannedProgram {
            file: file.unwrap_or_default(),
            language: name.to_owned(),
            dwell_s: self.dwell,
            trigger: self.trigger.clone(),
        });
        Ok(())
    }

    /// Writes the program, if this is asked for.
    ///
    /// # Errors
    /// Fails if the file cannot be written.
    pub(super) fn write(&self, robot: &dyn Robot, name: &str, document: &PlanDocument) -> Result<()> {
        let Some(path) = &self.program else { return Ok(()) };
        let joints = robot.joints();
        let program = MeasuringProgram {
            name: path.file_stem().and_then(|stem| stem.to_str()).unwrap_or("etalon"),
            header: header(robot, name, document, self.axes.as_deref()),
            joints,
            stops: stops(robot, document),
            dwell_s: self.dwell,
            stated: self.stated(),
        };
        let (_, language) = self.measuring_language(path)?;
        files::write(path, language.text(&program).as_bytes())
    }

    fn measuring_language(&self, path: &Path) -> Result<(&'static str, &'static dyn MeasuringLanguage)> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let unknown = || error!("measuring-language-unknown", file = path.display().to_string()).into();
        language(self.program_language.as_deref(), ending).ok_or_else(unknown)
    }
}

/// Lines of the header.
fn header(robot: &dyn Robot, name: &str, document: &PlanDocument, letters: Option<&str>) -> Vec<String> {
    let (joints, arm) = (robot.joints(), robot.joints().len().saturating_sub(6));
    let list = |part: &[etalon_robots::Joint]| part.iter().map(|j| j.name.as_str()).collect::<Vec<_>>().join(" ");
    let mut lines = vec![
        format!("Measuring program of etalon {}, {} poses", document.provenance.version, document.choice.chosen.len()),
        format!("Robot: {name}"),
        "Check for collisions and reach at low speed first.".to_owned(),
        "Joint values are values of the controller: zeros and directions as in".to_owned(),
        "the nominal model are assumed.".to_owned(),
    ];
    if let Some(letters) = letters {
        let axes = letters.chars().zip(joints).map(|(letter, joint)| format!("{letter} = {}", joint.name));
        lines.push(format!("Axes (deg, mm): {}", axes.collect::<Vec<_>>().join(", ")));
        lines.push("They have to be the joints: trivial or identity kinematics.".to_owned());
        return lines;
    }
    lines.push(format!("Axes 1 to 6: {}", list(&joints[arm..])));
    lines.extend((arm > 0).then(|| format!("External axes (mm): {}", list(&joints[..arm]))));
    lines
}

/// Parses letters of axes.
fn letters(text: &str) -> std::result::Result<String, String> {
    let letters = text.to_ascii_uppercase();
    let is_new = |(i, letter): (usize, char)| "XYZABCUVW".contains(letter) && letters.find(letter) == Some(i);
    let suited = !letters.is_empty() && letters.char_indices().all(is_new);
    if suited { Ok(letters) } else { Err("expected different letters of XYZABCUVW".to_owned()) }
}

/// Parses pulses per deg or mm.
fn pulses(text: &str) -> std::result::Result<f64, String> {
    let number = text.trim().parse().ok().filter(|value: &f64| value.is_normal());
    number.ok_or_else(|| "expected numbers other than 0".to_owned())
}

/// Poses in the order of measurement, with their approach points.
fn stops(robot: &dyn Robot, document: &PlanDocument) -> Vec<Stop> {
    let value = |values: &BTreeMap<String, f64>, column: &str| values.get(column).copied().unwrap_or(f64::NAN);
    let stop = |label: String, values: &BTreeMap<String, f64>| {
        let joints: Vec<f64> = robot.joints().iter().map(|joint| value(values, &joint.column())).collect();
        let mut before = joints.clone();
        for &k in robot.approached() {
            let joint = &robot.joints()[k];
            before[k] -= value(values, &joint.direction_column()) * joint.quantity.outward(approach(joint));
        }
        Stop { label, approach: (before != joints).then_some(before), joints }
    };
    let of_pose = |pose: &etalon_documents::PlannedPose| {
        let several = pose.configurations.len() > 1;
        let label =
            |k: usize| if several { format!("{} configuration {}", pose.pose, k + 1) } else { pose.pose.to_string() };
        pose.configurations.iter().enumerate().map(|(k, values)| stop(label(k), values)).collect::<Vec<_>>()
    };
    document.in_order().into_iter().flat_map(of_pose).collect()
}
