//! Everything that is wrong with a campaign, found at once and without computing.

use super::{Campaign, Format, JoinBy, Role};
use crate::import::Imported;
use crate::message::{Message, Problems};
use crate::robots::Robot;
use crate::{export, identify, import, table};
use std::collections::BTreeSet;
use toml::Spanned;

/// Checks a campaign that could be read: its files, labels, targets, poses and names.
///
/// Gives what was imported, with warnings, or every error.
pub fn check(campaign: &Campaign) -> Result<Imported, Problems> {
    let mut problems = Problems::default();
    check_statements(campaign, &mut problems);
    let imported = match import::import(campaign) {
        Ok(imported) => imported,
        Err(more) => {
            problems.0.extend(more.0);
            return Err(problems);
        }
    };
    check_labels(campaign, &imported, &mut problems);
    match campaign.robot.build(&campaign.targets()) {
        Ok(robot) => check_robot(campaign, robot.as_ref(), &imported, &mut problems),
        Err(more) => problems.0.extend(more.0),
    }
    problems.check()?;
    Ok(imported)
}

/// Statements that contradict each other, whatever the files hold.
fn check_statements(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    if let Err(more) = campaign.selections() {
        problems.0.extend(more.0);
    }
    for name in &file.controllers {
        if export::by_name(name.get_ref()).is_none() {
            let what = format!("`{}` is no controller format", name.get_ref());
            problems.0.push(Message::error(what).at(campaign.place(name)).hint_names(name.get_ref(), export::names()));
        }
    }
    let instrument = &file.instrument;
    let uncertainty_mm = instrument.standard_uncertainty_mm();
    if !(instrument.coverage_factor > 0.0 && uncertainty_mm > 0.0 && uncertainty_mm.is_finite()) {
        problems.0.push(
            Message::error("the instrument's uncertainty and coverage factor must be positive")
                .hint("take both from its calibration certificate"),
        );
    }
    if file.join.by == JoinBy::Time && (file.join.clock_offset_s.is_none() || file.join.tolerance_s.is_none()) {
        problems.0.push(
            Message::error("a join by time needs the offset of the clocks and a tolerance").hint(
                "add `clock_offset_s` (time of the measurement minus time of the log) and `tolerance_s` to [join]",
            ),
        );
    }
    let odd = |v: Option<f64>| v.is_some_and(|v| !v.is_finite());
    if odd(file.join.clock_offset_s) || odd(file.join.tolerance_s) || file.join.tolerance_s.is_some_and(|t| t < 0.0) {
        problems
            .0
            .push(Message::error("`clock_offset_s` and `tolerance_s` must be numbers, the tolerance not negative"));
    }
    for (name, feature) in &file.features {
        if feature.element().is_none() {
            problems.0.push(
                Message::error(format!("feature `{name}` must be exactly one element"))
                    .expected("one of `plane`, `line`, `circle`, `cylinder` with the labels of its points"),
            );
        }
    }
    let world = file.frame.world.get_ref();
    let ways = [world.plane.is_some(), world.targets.is_some(), world.as_exported];
    if ways.iter().filter(|w| **w).count() != 1 {
        problems.0.push(
            Message::error("the world frame must be defined in exactly one way")
                .at(campaign.place(&file.frame.world))
                .expected("`plane` with `origin` and an axis, or `targets`, or `as_exported = true`"),
        );
    } else if world.plane.is_some() {
        let axes = usize::from(world.x_axis.is_some()) + usize::from(world.y_axis.is_some());
        if axes != 1 || world.origin.is_none() || world.towards.is_none() {
            problems.0.push(
                Message::error(
                    "a world frame from a plane needs `origin`, one of `x_axis` and `y_axis`, and `towards`",
                )
                .at(campaign.place(&file.frame.world))
                .hint("`towards` names a label on the positive side of the other axis: it decides which way z points"),
            );
        }
    }
}

/// Labels and features that nothing bears.
fn check_labels(campaign: &Campaign, imported: &Imported, problems: &mut Problems) {
    let labels: BTreeSet<String> = table::texts(&imported.points, "label").unwrap_or_default().into_iter().collect();
    let targets: BTreeSet<String> = table::texts(&imported.points, "target").unwrap_or_default().into_iter().collect();
    let file = &campaign.file;
    let mut want = |name: &Spanned<String>, among: &[&BTreeSet<String>], what: &str| {
        let text = name.get_ref();
        let borne = |set: &&BTreeSet<String>| set.iter().any(|l| identify::matches_pattern(text, l));
        if !among.iter().any(borne) {
            let known = among.iter().flat_map(|set| set.iter().map(String::as_str)).filter(|l| !l.is_empty());
            let message = Message::error(format!("no {what} `{text}`")).at(campaign.place(name));
            problems.0.push(message.hint_names(text, known.collect::<Vec<_>>()));
        }
    };
    for feature in file.features.values() {
        for label in feature.element().map_or(&[][..], |(_, labels)| labels) {
            want(label, &[&labels], "point bears the label");
        }
    }
    let features: BTreeSet<String> = file.features.keys().cloned().collect();
    let world = file.frame.world.get_ref();
    if let Some(name) = &world.plane {
        want(name, &[&features], "feature is called");
    }
    for name in world
        .origin
        .iter()
        .chain(&world.towards)
        .chain(world.x_axis.iter().flatten())
        .chain(world.y_axis.iter().flatten())
    {
        want(name, &[&labels, &features], "point or feature is called");
    }
    for name in world.targets.iter().flatten() {
        let among: &[&BTreeSet<String>] = if world.each.is_some() { &[&targets] } else { &[&targets, &labels] };
        want(name, among, "export brings the target");
    }
    let rigid = file.rigid.iter().flat_map(|r| &r.targets);
    for name in rigid.chain(file.join.targets.iter().flatten()) {
        want(name, &[&targets], "export brings the target");
    }
}

/// What the robot needs of the campaign.
fn check_robot(campaign: &Campaign, robot: &dyn Robot, imported: &Imported, problems: &mut Problems) {
    let names = || robot.parameters().iter().map(|p| p.name.as_str());
    for pattern in &campaign.file.identify.hold {
        if !names().any(|name| identify::matches_pattern(pattern.get_ref(), name)) {
            let message = Message::error(format!("`{}` is no parameter of this robot", pattern.get_ref()));
            problems.0.push(message.at(campaign.place(pattern)).hint_names(pattern.get_ref(), names()));
        }
    }
    let mut measured: BTreeSet<String> =
        table::texts(&imported.points, "target").unwrap_or_default().into_iter().collect();
    measured.remove("");
    for target in robot.targets() {
        if !measured.contains(target) {
            let what = format!("no export brings the target `{target}` of this robot");
            problems.0.push(Message::error(what).hint_names(target, measured.iter().map(String::as_str)));
        }
    }
    for export in &campaign.file.exports {
        let Format::Delimited(dialect) = &export.format else { continue };
        for role in [Role::Label, Role::Target, Role::Pose, Role::Cycle, Role::X, Role::Y, Role::Z, Role::TimeS] {
            if dialect.columns.iter().filter(|r| **r == role).count() > 1 {
                let what = format!("`columns` names {role:?} twice");
                problems.0.push(Message::error(what).at(campaign.place(&export.file)));
            }
        }
        if robot.dimension() == 3 && !dialect.columns.contains(&Role::Z) {
            let what = "`columns` has no z, which a robot in space needs";
            problems.0.push(Message::error(what).at(campaign.place(&export.file)));
        }
    }
    for log in &campaign.file.logs {
        let named = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        let same = campaign.file.logs.iter().filter(|l| l.name == log.name).count();
        if log.name.is_empty() || !log.name.chars().all(named) || same > 1 {
            let what = format!("`{}` cannot be the name of a log", log.name);
            let message = Message::error(what).at(campaign.place(&log.file));
            problems.0.push(message.expected("letters, digits, `_` and `-`, another name for each log"));
        }
        for joint in robot.joints() {
            let column = joint.column();
            if !log.columns.keys().any(|k| import::is_joint_column(k.get_ref(), joint)) {
                problems.0.push(
                    Message::error(format!("log `{}` has no column for joint `{}`", log.name, joint.name))
                        .at(campaign.place(&log.file))
                        .hint(format!("add `{column} = \"name or number of the column\"` to its `columns`")),
                );
            }
        }
    }
}

impl Campaign {
    /// Targets that become observations: those that `[join]` names, or all that the robot has.
    pub fn targets(&self) -> Vec<String> {
        self.file.join.targets.iter().flatten().map(|t| t.get_ref().clone()).collect()
    }
}
