//! Options of the measuring program of a plan.

use super::super::check_positive;
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::Result;
use etalon_controllers::measuring::{MeasuringLanguage, MeasuringProgram, Stop, check, language, names};
use etalon_documents::PlanDocument;
use etalon_identify::plan::generate::approach;
use etalon_robots::Robot;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Options of the measuring program.
#[derive(Debug, clap::Args)]
pub(super) struct Program {
    /// Write a program that moves the joints to the chosen poses in the order of measurement and
    /// waits: RAPID (.mod), KRL (.src) or URScript (.script).
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
    /// Language of the program, if not by its ending.
    #[arg(long, value_name = "LANGUAGE", requires = "program", value_parser = clap::builder::PossibleValuesParser::new(names()))]
    language: Option<String>,
    /// Waiting time at each pose in seconds.
    #[arg(long, value_name = "SECONDS", default_value_t = 3.0)]
    dwell: f64,
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
        check(self.language_of(path)?, robot.joints(), |k| robot.nominal_gain(k))
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
            header: header(robot, name, document),
            joints,
            stops: stops(robot, document),
            dwell_s: self.dwell,
        };
        let (_, language) = self.language_of(path)?;
        files::write(path, language.text(&program).as_bytes())
    }

    fn language_of(&self, path: &Path) -> Result<(&'static str, &'static dyn MeasuringLanguage)> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let unknown = || error!("measuring-language-unknown", file = path.display().to_string()).into();
        language(self.language.as_deref(), ending).ok_or_else(unknown)
    }
}

/// Lines of the header.
fn header(robot: &dyn Robot, name: &str, document: &PlanDocument) -> Vec<String> {
    let (joints, arm) = (robot.joints(), robot.joints().len().saturating_sub(6));
    let list = |part: &[etalon_robots::Joint]| part.iter().map(|j| j.name.as_str()).collect::<Vec<_>>().join(" ");
    let mut lines = vec![
        format!("Measuring program of etalon {}, {} poses", document.provenance.version, document.chosen.len()),
        format!("Robot: {name}"),
        "Check for collisions and reach at low speed first.".to_owned(),
        "Joint values are those of the controller: zeros and directions as in".to_owned(),
        "the nominal model are assumed.".to_owned(),
        format!("Axes 1 to 6: {}", list(&joints[arm..])),
    ];
    lines.extend((arm > 0).then(|| format!("External axes (mm): {}", list(&joints[..arm]))));
    lines
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
