//! Names that nothing bears: labels, features, targets, parameters, columns.

use crate::campaign::{Campaign, Format, JoinBy, Role};
use crate::import::Imported;
use crate::message::{Message, Problems};
use crate::robots::Robot;
use crate::{identify, import, table};
use std::collections::BTreeSet;
use toml::Spanned;

/// Labels and features that nothing bears.
pub(super) fn labels(campaign: &Campaign, imported: &Imported, problems: &mut Problems) {
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
pub(super) fn robot(campaign: &Campaign, robot: &dyn Robot, problems: &mut Problems) {
    let names = || robot.parameters().iter().map(|p| p.name.as_str());
    for pattern in &campaign.file.identify.hold {
        if !names().any(|name| identify::matches_pattern(pattern.get_ref(), name)) {
            let message = Message::error(format!("`{}` is no parameter of this robot", pattern.get_ref()));
            problems.0.push(message.at(campaign.place(pattern)).hint_names(pattern.get_ref(), names()));
        }
    }
    for target in campaign.file.join.targets.iter().flatten() {
        if !robot.targets().contains(target.get_ref()) {
            let what = format!("`{}` is no target of this robot", target.get_ref());
            let message = Message::error(what).at(campaign.place(target));
            problems.0.push(message.hint_names(target.get_ref(), robot.targets().iter().map(String::as_str)));
        }
    }
    if let Some(targets) = &campaign.file.join.targets {
        let named = |name: &&String| targets.iter().any(|t| t.get_ref() == *name);
        for target in robot.targets().iter().filter(|t| !named(t)) {
            let message = Message::error(format!("`targets` leaves out `{target}`"));
            let message = message.at(campaign.place_of(&["join", "targets"]));
            problems.0.push(message.expected("nothing: of this robot all its targets count"));
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

/// Targets of the robot that nobody measured.
pub(super) fn targets(campaign: &Campaign, robot: &dyn Robot, imported: &Imported, problems: &mut Problems) {
    // what the log says it touches need not be called as the robot's target
    if campaign.file.join.by == JoinBy::Label {
        return;
    }
    let mut measured: BTreeSet<String> =
        table::texts(&imported.points, "target").unwrap_or_default().into_iter().collect();
    measured.remove("");
    // those that [join] names are told with the labels
    let stated = campaign.file.join.targets.as_ref();
    let told = |target: &String| stated.is_some_and(|all| all.iter().any(|t| t.get_ref() == target));
    for target in robot.targets().iter().filter(|t| !measured.contains(*t) && !told(t)) {
        let what = format!("no export brings the target `{target}` of this robot");
        let message = Message::error(what).at(campaign.place_of(&["join"]));
        problems.0.push(message.hint_names(target, measured.iter().map(String::as_str)));
    }
}
