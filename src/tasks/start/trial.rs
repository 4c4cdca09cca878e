//! Trial of a proposed campaign: its open questions, and the errors that `check` would report once
//! they are answered.

use crate::run::walk::checked;
use etalon_base::catalogue::{Argument, IntoArgument, Phrase};
use etalon_base::files::{Stamp, shell_word};
use etalon_base::message::{Message, Problems, printable};
use etalon_base::phrase;
use etalon_campaign::{Campaign, OpenPart, open_parts};
use std::path::{Component, Path, PathBuf};

/// Answers of a trial, by key: errors of a proposal do not depend on them.
const ANSWERS: [(&str, &str); 5] = [
    ("name", "\"instrument\""),
    ("expanded_uncertainty_um", "20"),
    ("expanded_rotation_uncertainty_deg", "0.01"),
    ("rotation", "\"vector\""),
    ("per_count", "-1"),
];
/// Units to try if the unit is an open question.
const UNITS: [&str; 5] = ["mm", "m", "cm", "inch", "um"];
/// Maximum number of errors that are repeated.
const SHOWN: usize = 3;

/// Returns the next step for a folder with this campaign.toml and robot.toml.
pub(crate) fn next(folder: &Path, text: &str, robot: &str) -> Phrase {
    let mut parts: Vec<OpenPart> = text.lines().chain(robot.lines()).flat_map(open_parts).collect();
    let is_robot_open = robot.lines().any(|line| !open_parts(line).is_empty());
    parts.dedup();
    let named = |part: OpenPart| match part {
        OpenPart::Value(key) => key.argument(),
        OpenPart::JointUnit => phrase!("units-of-joints").argument(),
        OpenPart::TimeUnit => phrase!("unit-of-times").argument(),
        OpenPart::AngleUnit => phrase!("unit-of-rotations").argument(),
    };
    let keys: Vec<Argument> = parts.into_iter().map(named).collect();
    let command = format!("`etalon check {}`", shell_word(folder));
    let next = match keys.is_empty() {
        true => phrase!("next-command", command),
        false => phrase!("next-check-asks", command, keys),
    };
    match refusal(folder, text).filter(|_| !is_robot_open) {
        Some(reasons) => phrase!("next-check-refused", next, reasons),
        None => next,
    }
}

/// Returns why `check` would reject lines for campaign.toml with this robot, once their questions
/// are answered. Files are relative to the current folder; others are not tried.
pub(crate) fn refusal_of_lines(robot: &Path, files: &[PathBuf], lines: &str) -> Option<String> {
    let below = |path: &Path| path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    if !below(robot) || !files.iter().all(|file| below(file)) || !lines.contains("\n[join]\n") {
        return None;
    }
    let robot = toml::Value::from(robot.display().to_string());
    let text = format!(
        "name = \"trial\"\nrobot = {robot}\n[instrument]\nname = \"?\"\nexpanded_uncertainty_um = \"?\"\n\
         expanded_rotation_uncertainty_deg = \"?\"\ncoverage_factor = 2\n{lines}\n[identify]\ncalibration = \"all\"\n"
    );
    refusal(Path::new(""), &text)
}

/// Returns the first errors of a trial.
fn refusal(folder: &Path, text: &str) -> Option<String> {
    let wrong = errors(folder, text);
    // the hint of an error about the set-up is its cause
    let text = |message: &Message| {
        let hint = message.hint.as_ref().map_or_else(String::new, |hint| format!(" ({hint})"));
        format!("{}: {}{hint}", message.id, message.phrase())
    };
    let shown: Vec<String> = wrong.iter().take(SHOWN).map(text).collect();
    (!shown.is_empty()).then(|| printable(&shown.join("; ")))
}

/// Errors of the campaign with its questions answered, an open unit by every unit; none if a
/// question cannot be answered by a trial.
fn errors(folder: &Path, text: &str) -> Vec<Message> {
    let mut first: Option<Vec<Message>> = None;
    let asks = text.lines().flat_map(open_parts).any(|part| part == OpenPart::Value("unit"));
    for unit in UNITS.into_iter().take(if asks { UNITS.len() } else { 1 }) {
        let Some(text) = answered(text, unit) else { return Vec::new() };
        let stamp = Stamp::new(text.as_bytes());
        let found = match Campaign::recover_text(folder.join("campaign.toml"), text, stamp) {
            Ok((Some(campaign), problems)) => [problems.0, checked(&campaign).problems.0].concat(),
            Ok((None, problems)) | Err(problems) => problems.0,
        };
        if found.is_empty() {
            return found;
        }
        first.get_or_insert_with(|| Problems(found).grouped().0);
    }
    first.unwrap_or_default()
}

/// Returns the text with its questions answered; `None` if a question has no answer for a trial.
fn answered(text: &str, unit: &str) -> Option<String> {
    let unit = format!("\"{unit}\"");
    let answer = |line: &str| {
        let mut line = line.to_owned();
        for part in open_parts(&line.clone()) {
            let value = match part {
                OpenPart::Value("unit") => unit.as_str(),
                OpenPart::Value(key) => ANSWERS.iter().find(|(of, _)| *of == key)?.1,
                OpenPart::AngleUnit => "deg",
                OpenPart::JointUnit | OpenPart::TimeUnit => return None,
            };
            line = part.answered(&line, value);
        }
        Some(line + "\n")
    };
    text.lines().map(answer).collect()
}
