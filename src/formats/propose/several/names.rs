//! Names of the targets and of the stationary points in exports.

use super::keys::{Join, Keys};
use super::part::Part;
use crate::propose::labels::{ALONE, FEWER, MOST_TARGETS, NUMBER};
use crate::propose::meaning::Meaning;
use crate::propose::statements::{Label, Line, Target};
use etalon_base::message::Result;
use etalon_base::phrase;
use std::collections::BTreeSet;

/// Remark on an export of points that do not move with the robot.
const STATIONARY: &str = "stationary points: the labels name no pose, and no row of the log belongs to them";

/// Names of the targets and of the stationary points, and the joins of the exports.
#[derive(Default)]
pub(super) struct Named {
    pub targets: Vec<String>,
    pub stationary: Vec<String>,
    pub joined: Vec<(usize, Join)>,
}

impl Named {
    /// Names the targets of all exports, each with its keys and its join with the log.
    pub fn new(parts: &mut [Part], found: Vec<(usize, Keys, Option<Join>)>) -> Self {
        let mut named = Self::default();
        let is_joined = found.iter().any(|(.., join)| join.is_some());
        for (at, keys, join) in found {
            match (&join, keys.stationary()) {
                (None, Some(names)) if is_joined => {
                    let remark = Line::Remark(STATIONARY.to_owned());
                    parts[at].lines.replace(&Line::Label(Label::Open), &[remark]);
                    named.stationary.extend(names.iter().cloned());
                }
                _ => {
                    named.stationary.extend(keys.still.iter().cloned());
                    name_targets(&mut parts[at], &keys, join.as_ref(), &mut named.targets);
                }
            }
            named.joined.extend(join.map(|join| (at, join)));
        }
        for part in parts.iter_mut().filter(|part| part.document.kind == "export with joints") {
            let keys = Keys::new(part);
            name_targets(part, &keys, None, &mut named.targets);
        }
        named
    }
}

/// Removes the join of exports with a few points whose names look like poses, if another export has
/// many more poses of other targets: balls on the floor, or on the base of a parallel robot.
pub(super) fn leave_stationary(parts: &mut [Part], found: &mut [(usize, Keys, Option<Join>)]) -> Result<()> {
    let by_pose = |join: &Option<Join>| join.as_ref().is_some_and(|join| join.by != "time");
    let joined = found.iter().filter(|(.., join)| by_pose(join));
    let Some((at_most, most, moving)) = joined
        .map(|(at, keys, _)| (*at, keys.pose_count(), keys.targets().to_vec()))
        .max_by_key(|(_, count, _)| *count)
    else {
        return Ok(());
    };
    for (at, keys, join) in found.iter_mut().filter(|(at, _, join)| *at != at_most && by_pose(join)) {
        let few = keys.pose_count() * FEWER <= most && keys.rows <= 3 * MOST_TARGETS && !moving.is_empty();
        let own = keys.targets().iter().all(|target| !moving.contains(target));
        if !few || !own || keys.labels.is_none() && !parts[*at].name_by_count()? {
            continue;
        }
        (*keys, *join) = (Keys::new(&parts[*at]), None);
        let names: BTreeSet<String> = keys.labels.iter().flatten().cloned().collect();
        parts[*at].doubt(phrase!("doubt-stationary-points", count = names.len(), poses = most));
        keys.form = Some((ALONE.to_owned(), names.into_iter().collect()));
    }
    Ok(())
}

/// Writes the targets of an export, and the form of its labels.
fn name_targets(part: &mut Part, keys: &Keys, join: Option<&Join>, targets: &mut Vec<String>) {
    let mut add = |name: &str| {
        if !targets.iter().any(|known| known == name) {
            targets.push(name.to_owned());
        }
    };
    let stem = part.stem();
    let stem = if stem.is_empty() || stem == "base" { "reflector".to_owned() } else { stem };
    // each point of a row is another target
    let open = part.lines.targets().filter(|target| **target == Target::Open).count();
    for (number, target) in (1..).zip(part.lines.targets_mut().filter(|target| **target == Target::Open)) {
        let name = if open == 1 { stem.clone() } else { format!("{stem}_{number}") };
        add(&name);
        *target = Target::Named(name, "named after the file: the file names no target");
    }
    // a format of its own gives no form of its labels
    if part.document.format.is_some() && keys.labels.is_some() && join.is_some() {
        part.lines.push(Line::Label(Label::Open));
    }
    if let Some(form) = join.and_then(|join| join.form.clone()) {
        let known = Label::Known { form, labels: keys.rows, stationary: 0 };
        part.lines.replace(&Line::Label(Label::Pose), &[Line::Label(known)]);
    }
    if part.lines.0.contains(&Line::Label(Label::Open)) {
        let (mut lines, named) = lines_of_labels(keys, join);
        named.iter().for_each(|name| add(name));
        let has_column = part.read.as_ref().is_some_and(|(_, found)| found.first(Meaning::Target).is_some());
        if named.is_empty() && !has_column {
            add(&stem);
            lines.push(Line::Target(Target::Named(stem, "the labels name no target")));
        }
        part.lines.replace(&Line::Label(Label::Open), &lines);
    }
    let stated = part.lines.targets().filter_map(|of| if let Target::Named(name, _) = of { Some(name) } else { None });
    stated.for_each(|name| add(name));
    if part.read.as_ref().is_some_and(|(_, found)| found.first(Meaning::Target).is_some()) {
        part.targets().unwrap_or_default().iter().for_each(|name| add(name));
    }
}

/// Returns the lines for labels whose form is a question, and the targets that the labels name.
fn lines_of_labels<'a>(keys: &'a Keys, join: Option<&Join>) -> (Vec<Line>, &'a [String]) {
    let by_row = join.is_some_and(|join| join.by == "row");
    let of_join = join.and_then(|join| join.form.as_deref());
    // numbers that name no row of the log are names of points
    let form = keys.form.as_ref().filter(|(form, _)| !(by_row && form == NUMBER));
    let form = form.filter(|_| of_join.is_none());
    let stated = of_join.or(form.map(|(form, _)| form.as_str()));
    let known = |form: &str| Label::Known { form: form.to_owned(), labels: keys.rows, stationary: keys.still.len() };
    let mut lines: Vec<Line> = stated.map(|form| Line::Label(known(form))).into_iter().collect();
    if by_row && stated.is_none_or(|form| !form.contains("{pose}")) {
        lines.push(Line::PoseByRow);
    }
    (lines, form.map_or_else(Default::default, |(_, targets)| targets.as_slice()))
}
