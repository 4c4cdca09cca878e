//! Commands on robots and tables in memory, for programs that call etalon as a library.
//!
//! Options are words of the command line (`["--hold", "q1"]`); the answer is the document that
//! `--json` prints. Nothing is printed and nothing is written.

use crate::run::documents::parse_parameters;
use crate::run::walk::{Checked, checked};
use anyhow::Result;
use clap::Args;
use etalon_base::error;
use etalon_base::message::Problems;
use etalon_campaign::Campaign;
use etalon_documents::{
    AxesDocument, AxisDocument, CellDocument, CheckDocument, Iso9283Document, Iso9283StreamDocument,
    ParametersDocument, PlanDocument, VerificationDocument,
};
use etalon_robots::{Kinematics, Robot};
use std::path::Path;

pub use super::capture::{Answer, answer, has_json};
pub use super::init::{known_names, known_text, urdf_text};
pub use super::inputs::{Inputs, Table};
pub use crate::stages::verify::predicted::{PredictedPosition, Prediction};

/// Stands for a file in options that a table in memory replaces.
const PLACEHOLDER: &str = "table";

/// The kinematics of a robot, of a model that has them.
///
/// # Errors
/// Fails for a model without kinematics of a whole pose.
pub fn whole_pose(robot: &dyn Robot) -> std::result::Result<&dyn Kinematics, Problems> {
    super::kinematics::whole_pose(robot)
}

/// Uses the parameters of a `parameters.json`, if given, as the nominal ones.
///
/// # Errors
/// Fails with parameters of another robot.
pub fn set_parameters(robot: &mut dyn Robot, json: Option<&str>) -> std::result::Result<(), Problems> {
    let Some(json) = json else { return Ok(()) };
    let document = parse_parameters("parameters", json)?;
    let values = super::kinematics::identified(robot, &document, Path::new("parameters"))?;
    robot.definition_mut().set_nominal(&values);
    Ok(())
}

/// Identifies parameters, as `etalon identify`.
///
/// # Errors
/// Fails like the command.
pub fn identify(given: &Inputs, options: &[String]) -> Result<ParametersDocument> {
    let files = ["--robot", PLACEHOLDER, "--observations", PLACEHOLDER];
    parse_options::<super::identify::IdentifyCommand>(&files, options)?.in_memory(given)
}

/// Chooses poses to measure, as `etalon plan`.
///
/// # Errors
/// Fails like the command.
pub fn plan(given: &Inputs, options: &[String]) -> Result<PlanDocument> {
    let files = ["--robot", PLACEHOLDER, "--candidates", PLACEHOLDER];
    parse_options::<super::plan::PlanCommand>(&files, options)?.in_memory(given)
}

/// Judges whether parameters still hold, as `etalon verify`.
///
/// # Errors
/// Fails like the command.
pub fn verify(given: &Inputs, parameters: &ParametersDocument, options: &[String]) -> Result<VerificationDocument> {
    let files = ["--robot", PLACEHOLDER, "--parameters", PLACEHOLDER, PLACEHOLDER];
    parse_options::<super::verify::Verify>(&files, options)?.in_memory(given, parameters)
}

/// Finds the axes of joints from sweeps, as `etalon axes`.
///
/// # Errors
/// Fails like the command.
pub fn axes(table: &Table, options: &[String]) -> Result<AxesDocument> {
    Ok(parse_options::<super::axes::AxesCommand>(&[PLACEHOLDER], options)?.in_memory(table)?)
}

/// Finds tool, object, hand and eye, or an external axis, as `etalon cell`.
///
/// # Errors
/// Fails like the command.
pub fn cell(table: &Table, options: &[String]) -> Result<CellDocument> {
    Ok(parse_options::<super::cell::CellCommand>(&[PLACEHOLDER], options)?.in_memory(table)?)
}

/// Evaluates attained poses, as `etalon iso9283 pose`; the second table has the commanded poses,
/// the third reference targets.
///
/// # Errors
/// Fails like the command.
pub fn iso9283([attained, commanded, reference]: [Option<&Table>; 3], options: &[String]) -> Result<Iso9283Document> {
    let attained = needed(attained)?;
    let files = [PLACEHOLDER, "--commanded", PLACEHOLDER];
    let files = if commanded.is_some() { &files[..] } else { &files[..1] };
    Ok(parse_options::<super::iso9283::Iso9283>(files, options)?.poses_in_memory(attained, commanded, reference)?)
}

/// Evaluates a recorded motion, as `etalon iso9283 path`; the second table has the commanded poses,
/// the third the commanded path.
///
/// # Errors
/// Fails like the command.
pub fn iso9283_path(
    [recording, commanded, path]: [Option<&Table>; 3],
    options: &[String],
) -> Result<Iso9283StreamDocument> {
    let recording = needed(recording)?;
    let files = ["--stream", PLACEHOLDER, "--path", PLACEHOLDER];
    let files = if path.is_some() { &files[..] } else { &files[..2] };
    Ok(parse_options::<super::iso9283::Iso9283>(files, options)?.path_in_memory(recording, commanded, path)?)
}

/// Evaluates the positioning of an axis, as `etalon iso230`.
///
/// # Errors
/// Fails like the command.
pub fn iso230(table: &Table) -> Result<AxisDocument> {
    Ok(super::iso230::evaluate(&table.parse()?)?.0)
}

/// Finds all errors of a campaign, like `etalon check`.
pub fn check(campaign: &Path) -> CheckDocument {
    let (checked, problems) = find(campaign);
    let (imported, joints) = checked.map(|checked| (checked.inputs, checked.joints)).unzip();
    let joints = joints.unwrap_or_default();
    let (messages, sources) = imported.map(|i| (i.messages, i.sources)).unwrap_or_default();
    let messages = Problems(problems.0.into_iter().chain(messages).collect()).grouped();
    CheckDocument::new(campaign.display().to_string(), &messages.0, sources, joints)
}

/// Contents of the campaign's files, and all errors.
pub(super) fn find(path: &Path) -> (Option<Checked>, Problems) {
    let (campaign, mut problems) = match Campaign::recover(path) {
        Ok(found) => found,
        Err(problems) => return (None, problems),
    };
    let Some(campaign) = campaign else { return (None, problems) };
    let mut checked = checked(&campaign);
    problems.0.append(&mut checked.problems.0);
    (Some(checked), problems)
}

fn needed<'t, 'a>(table: Option<&'t Table<'a>>) -> std::result::Result<&'t Table<'a>, Problems> {
    table.ok_or_else(|| error!("table-to-evaluate-missing").into())
}

/// Options of a command, which are checked as on the command line.
fn parse_options<T: Args>(files: &[&str], options: &[String]) -> Result<T> {
    let words = ["etalon"].into_iter().chain(files.iter().copied()).chain(options.iter().map(String::as_str));
    let read = T::augment_args(clap::Command::new("etalon")).try_get_matches_from(words);
    let found = read.and_then(|matches| T::from_arg_matches(&matches));
    found.map_err(|error| {
        let text = error.render().to_string();
        let reason = text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned();
        Problems::from(error!("option-of-call-refused", reason)).into()
    })
}
