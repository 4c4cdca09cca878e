//! Names that do not exist: labels, features, targets, parameters, columns.

use crate::stages::gather::Gathered;
use etalon_base::message::{Message, Problems};
use etalon_base::pattern::matches_pattern;
use etalon_campaign::{Campaign, JoinBy};
use etalon_formats::Export;
use etalon_formats::dialect::ColumnRole;
use etalon_robots::Robot;
use std::collections::BTreeSet;
use toml::Spanned;

/// Labels and features that do not exist. Where some exports are not read, they may be there: then it is a warning.
pub(super) fn labels(campaign: &Campaign, imported: &Gathered, complete: bool, problems: &mut Problems) {
    let points = &imported.points;
    // a label that names a target at a pose is never meant
    let (mut plain, mut labels, mut targets) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    // one by one: a set collects all points before it drops those that are equal
    for point in points {
        labels.insert(&*point.label);
        targets.insert(point.target.as_deref().unwrap_or_default());
        if point.target.is_none() {
            plain.insert(&*point.label);
        }
    }
    let file = &campaign.file;
    let mut open: Vec<String> = Vec::new();
    let mut want = |name: &Spanned<String>, among: &[&BTreeSet<&str>], what: &str| {
        let text = name.get_ref();
        let borne = |set: &&BTreeSet<&str>| set.iter().any(|l| matches_pattern(text, l));
        if !among.iter().any(borne) {
            if !complete && what != "feature is called" {
                return open.push(text.clone());
            }
            let meant = |label: &&str| !label.is_empty() && (!labels.contains(*label) || plain.contains(label));
            let known = among.iter().flat_map(|set| set.iter().copied()).filter(meant);
            let message = Message::error(format!("no {what} `{text}`")).at(campaign.place(name));
            problems.0.push(message.hint_names(text, known.collect::<Vec<_>>()));
        }
    };
    for feature in file.features.values() {
        for label in feature.element().map_or(&[][..], |(_, labels)| labels) {
            want(label, &[&labels], "point has the label");
        }
    }
    let features: BTreeSet<&str> = file.features.keys().map(String::as_str).collect();
    if let Some(world) = file.world() {
        if let (Some(name), false) = (&world.plane, campaign.unread.affects(&["feature"])) {
            want(name, &[&features], "feature is called");
        }
        for name in world.names() {
            want(name, &[&labels, &features], "point or feature is called");
        }
        for name in world.targets.iter().flatten() {
            let among: &[&BTreeSet<&str>] = if world.each.is_some() { &[&targets] } else { &[&targets, &labels] };
            want(name, among, "export brings the target");
        }
    }
    let rigid = file.rigid.iter().flat_map(|r| &r.targets).chain(file.fixed.iter().flat_map(|f| &f.targets));
    // points that a log touches need not have the name of the robot's target
    let joined = file.join_targets().filter(|_| file.join_by() != Some(JoinBy::Label));
    for name in rigid.chain(joined) {
        want(name, &[&targets], "export brings the target");
    }
    if !open.is_empty() {
        open.sort_unstable();
        open.dedup();
        let names: Vec<String> = open.iter().map(|name| format!("`{name}`")).collect();
        let message = Message::warning(format!("no export that reads brings {}", names.join(", ")));
        problems.0.push(message.hint("check these names when all exports read"));
    }
}

/// What the robot needs of the campaign.
pub(super) fn robot(campaign: &Campaign, robot: &dyn Robot, problems: &mut Problems) {
    let names = || robot.parameters().iter().map(|p| p.name.as_str());
    for pattern in campaign.file.identify.iter().flat_map(|identify| &identify.hold) {
        if !names().any(|name| matches_pattern(pattern.get_ref(), name)) {
            let message = Message::error(format!("`{}` is not a parameter of this robot", pattern.get_ref()));
            problems.0.push(message.at(campaign.place(pattern)).hint_names(pattern.get_ref(), names()));
        }
    }
    for target in campaign.file.join_targets() {
        if !robot.targets().contains(target.get_ref()) {
            let what = format!("`{}` is not a target of this robot", target.get_ref());
            let message = Message::error(what).at(campaign.place(target));
            problems.0.push(message.hint_names(target.get_ref(), robot.targets().iter().map(String::as_str)));
        }
    }
    if let Some(targets) = campaign.file.join.as_ref().and_then(|join| join.targets.as_ref()) {
        let named = |name: &&String| targets.iter().any(|t| t.get_ref() == *name);
        for target in robot.targets().iter().filter(|t| !named(t)) {
            let message = Message::error(format!("`targets` leaves out `{target}`"));
            let message = message.at(campaign.place_of(&["join", "targets"]));
            problems.0.push(message.expected("nothing: of this robot all its targets count"));
        }
    }
    let drawn = campaign.file.geometric.as_ref().is_some_and(|g| g.workspace.is_some());
    if drawn && robot.rail_table().is_some_and(|table| table.travel_mm().is_none()) {
        let message = Message::error("the workspace needs the travel of the actuators");
        let message = message.at(campaign.place_of(&["geometric", "workspace"]));
        problems.0.push(message.hint("state [reach] with `travel_mm = [..., ..., ...]` in robot.toml"));
    }
    for (i, export) in campaign.file.exports.iter().enumerate() {
        if !campaign.export_reads(i) {
            continue;
        }
        let holds = |role| export.format.dialect.columns.contains(role);
        if robot.dimension() == 3 && (holds(ColumnRole::X) || holds(ColumnRole::Radius)) && !holds(ColumnRole::Z) {
            let what = "`columns` has no z, which a robot in space needs";
            problems.0.push(Message::error(what).at(campaign.place(&export.file)));
        }
    }
}

/// What the robot needs of the logs.
pub(super) fn logs(campaign: &Campaign, robot: &dyn Robot, problems: &mut Problems) {
    for log in &campaign.file.logs {
        let named = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        let same = campaign.file.logs.iter().filter(|l| l.name == log.name).count();
        if log.name.is_empty() || !log.name.chars().all(named) || same > 1 {
            let what = format!("`{}` cannot be the name of a log", log.name);
            let message = Message::error(what).at(campaign.place(&log.file));
            problems.0.push(message.expected("letters, digits, `_` and `-`, another name for each log"));
        }
        let known = |key: &str| {
            etalon_formats::is_common_column(key)
                || robot.joints().iter().any(|j| etalon_formats::is_joint_column(key, j) || key == j.direction_column())
        };
        for key in log
            .columns
            .keys()
            .filter(|key| !known(key.get_ref()) && etalon_formats::log_column(key.get_ref()).is_some())
        {
            let columns: Vec<String> = robot.joints().iter().map(|joint| joint.column()).collect();
            let message = Message::error(format!("`{}` is not a joint of this robot", key.get_ref()));
            let hint = format!("its joints are {}, in these units or others", columns.join(", "));
            problems.0.push(message.at(campaign.place(key)).hint(hint));
        }
        if campaign.unread.affects(&["log"]) {
            continue;
        }
        for joint in robot.joints() {
            let column = joint.column();
            if !log.columns.keys().any(|k| etalon_formats::is_joint_column(k.get_ref(), joint)) {
                problems.0.push(
                    Message::error(format!("log `{}` has no column for joint `{}`", log.name, joint.name))
                        .at(campaign.place(&log.file))
                        .hint(format!("add `{column} = \"name or number of the column\"` to its `columns`")),
                );
            }
        }
    }
}

/// Targets of the robot that were not measured.
pub(super) fn targets(campaign: &Campaign, robot: &dyn Robot, imported: &Gathered, problems: &mut Problems) {
    // points that a log touches need not have the name of the robot's target
    if campaign.file.join_by() == Some(JoinBy::Label) {
        return;
    }
    let mut measured: BTreeSet<&str> = imported.points.iter().filter_map(|p| p.target.as_deref()).collect();
    measured.remove("");
    // those that [join] names are reported with the labels
    let reported = |target: &String| campaign.file.join_targets().any(|t| t.get_ref() == target);
    let mut missing = robot.targets().iter().filter(|t| !measured.contains(t.as_str()) && !reported(t)).peekable();
    let odd: Vec<Message> = campaign.file.exports.iter().filter_map(|e| other_form(campaign, e, imported)).collect();
    if missing.peek().is_some() && !odd.is_empty() {
        return problems.0.extend(odd);
    }
    for target in missing {
        let what = format!("no export brings the target `{target}` of this robot");
        let message = Message::error(what).at(campaign.place_of(&["join"]));
        problems.0.push(message.hint_names(target, measured.iter().copied()));
    }
}

/// An error where no label of an export has the form that the campaign states.
fn other_form(campaign: &Campaign, export: &Export, imported: &Gathered) -> Option<Message> {
    let form = export.label.as_ref()?;
    let pattern = etalon_formats::LabelPattern::parse(form.get_ref()).ok()?;
    let own = || imported.points.iter().filter(|p| *p.export == **export.file.get_ref());
    let first = &own().next()?.label;
    if own().any(|p| p.pose.is_some() || pattern.read(&p.label, |_| false).is_some()) {
        return None;
    }
    let what = format!("no label of `{}` has the form `{}`", export.file.get_ref(), form.get_ref());
    let message = Message::error(what).at(campaign.place(form));
    Some(message.hint(format!("its first label is `{first}`: state its form, with {{target}}, {{pose}} and {{cycle}}")))
}
