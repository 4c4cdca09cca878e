//! Identify: observations become parameters, and errors before and after.

use crate::base::message::{Message, Problems, Result, count};
use crate::campaign::{Campaign, Identify, Selection};
use crate::document::{AccuracyDocument, ParametersDocument, PointError};
use crate::math::identify::{self, Identification, Observation};
use crate::math::robots::Robot;
use crate::stages::evaluate::{self, Sets};
use crate::stages::join::Joined;
use crate::stages::parameters::parameters_document;
use crate::stages::plausible::doubts;
use std::collections::{BTreeMap, BTreeSet};

/// What a campaign identifies.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Identified parameters.
    pub parameters: ParametersDocument,
    /// Errors before and after, summarised.
    pub accuracy: AccuracyDocument,
    /// Errors of every observation.
    pub errors: Vec<PointError>,
    /// The observations that were used.
    pub sets: Sets,
    /// What the solver found.
    pub found: Identification,
}

/// Identifies the robot from the observations of the first log; other logs are compared with it. `inputs` are the files and
/// their SHA-256.
pub fn identify(
    campaign: &Campaign,
    stated: &Identify,
    robot: &dyn Robot,
    joined: &Joined,
    inputs: &BTreeMap<String, String>,
) -> Result<Identified> {
    let mut messages = Vec::new();
    let observations = Observation::from_table(robot, &joined.observations[0].1, &mut messages)?;
    let poses = evaluate::poses(&observations);
    check_selections(campaign, &poses)?;
    let selections = campaign.selections(stated)?;
    let sets = evaluate::split(&observations, &poses, &selections);
    let settings = campaign.settings(stated);
    let before = identify::fit_frames(robot, &sets.calibration, &settings)?;
    let mut found = identify::identify_from(robot, &sets.calibration, &settings, &before)?;
    for (name, table) in joined.observations.iter().skip(1) {
        let observations = Observation::from_table(robot, table, &mut messages)?;
        let others = evaluate::split(&observations, &poses, &selections);
        let theirs = identify::identify(robot, &others.calibration, &settings)?;
        let first = LogFit { name: &campaign.file.logs[0].name, sets: &sets, found: &found };
        let other = LogFit { name, sets: &others, found: &theirs };
        let warnings =
            [compare_logs(robot, &first, &other, first.name), compare_logs(robot, &other, &first, first.name)];
        found.warnings.extend(warnings.into_iter().flatten());
    }
    found.warnings.splice(0..0, messages);
    let errors = evaluate::errors(robot, &sets, &before, &found.values);
    let doubts = doubts(robot, &sets.calibration, &settings, &found, &errors);
    found.warnings.splice(0..0, doubts);
    Ok(Identified {
        parameters: parameters_document(robot, &settings, &before, &found, inputs),
        accuracy: evaluate::evaluate(robot, &errors, &campaign.file.limits)?,
        errors,
        sets,
        found,
    })
}

/// A log, its observations and what they identify.
struct LogFit<'a> {
    name: &'a str,
    sets: &'a Sets,
    found: &'a Identification,
}

/// A warning where the residuals with one log correlate with its difference from another; `used` is the campaign's choice.
fn compare_logs(robot: &dyn Robot, this: &LogFit, that: &LogFit, used: &str) -> Option<Message> {
    let compared = identify::compare_logs(robot, &this.found.values, &this.sets.calibration, &that.sets.calibration)?;
    if compared.correlation <= 0.3 {
        return None;
    }
    let what = format!(
        "with log `{}`, residuals correlate with the difference of the two logs, r = {:.2}: their root mean square is {:.3} mm, \
         with log `{}` {:.3} mm",
        this.name, compared.correlation, this.found.rms, that.name, that.found.rms
    );
    let hint = match this.name == used {
        true => format!("identify with log `{}`: name it first", that.name),
        false => format!("log `{}` is the one to use, as this campaign does", that.name),
    };
    Some(Message::warning(what).hint(hint))
}

/// Errors where a selection or a table takes none of these poses, or calibration and validation share some.
pub fn check_selections(campaign: &Campaign, poses: &BTreeSet<i64>) -> Result<()> {
    let Some(identify) = &campaign.file.identify else { return Ok(()) };
    // what does not read is reported with the statements
    let Ok(selections) = campaign.selections(identify) else { return Ok(()) };
    let mut problems = Problems::default();
    let numbered = || poses.iter().copied().enumerate();
    if !numbered().any(|(i, pose)| selections.calibrates(pose, i)) {
        let message = Message::error("`calibration` selects no pose that was measured");
        problems.0.push(message.at(campaign.place(&identify.calibration)).hint(measured(poses)));
    }
    if let Some(text) = &identify.validation {
        if !numbered().any(|(i, pose)| selections.validates(pose, i)) {
            let message = Message::error("`validation` selects no pose that was measured");
            problems.0.push(message.at(campaign.place(text)).hint(measured(poses)));
        }
        let shared: Vec<String> = numbered()
            .filter(|&(i, pose)| selections.calibrates(pose, i) && selections.validates(pose, i))
            .map(|(_, pose)| pose.to_string())
            .collect();
        if !shared.is_empty() {
            let shown = shared.iter().take(20).cloned().collect::<Vec<_>>().join(", ");
            let more = if shared.len() > 20 { ", ..." } else { "" };
            let what = format!("poses in both calibration and validation: {shown}{more}");
            let message = Message::error(what).at(campaign.place(text));
            problems.0.push(message.hint("`validation = \"rest\"` takes all that calibration does not"));
        }
    }
    let in_use = |&(i, pose): &(usize, i64)| selections.calibrates(pose, i) || selections.validates(pose, i);
    let used: Vec<i64> = numbered().filter(in_use).map(|(_, pose)| pose).collect();
    for table in campaign.file.geometric.iter().flat_map(|g| &g.table) {
        let found = match Selection::parse(table.poses.get_ref()) {
            Ok(selection) if used.iter().enumerate().any(|(i, &pose)| selection.contains(pose, i, false)) => continue,
            Ok(_) => Message::error(format!("the table `{}` has no pose that was measured", table.title))
                .hint("a table shows poses of `calibration` and `validation`"),
            Err(message) => message,
        };
        problems.0.push(found.at(campaign.place(&table.poses)));
    }
    problems.check().map(|_| ())
}

/// Which poses there are to select from.
fn measured(poses: &BTreeSet<i64>) -> String {
    match (poses.first(), poses.last()) {
        (Some(first), Some(last)) => {
            format!("{} are measured and joined, from {first} to {last}", count(poses.len(), "pose"))
        }
        _ => "no pose is measured and joined".to_owned(),
    }
}
