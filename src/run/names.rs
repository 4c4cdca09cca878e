//! Names that do not exist: labels, features, targets, parameters, columns.

use crate::stages::gather::Gathered;
use etalon_base::message::{Message, Problems};
use etalon_base::pattern::matches_pattern;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, JoinBy, Unbuilt};
use etalon_documents::ResidualKind;
use etalon_formats::Export;
use etalon_formats::dialect::ColumnRole;
use etalon_formats::tables::joints::stated_columns;
use etalon_robots::Robot;
use std::collections::BTreeSet;
use toml::Spanned;

/// Maximum number of targets that a hint gives.
const MOST_TARGETS: usize = 12;

/// Kind of a name in the campaign.
#[derive(Clone, Copy, PartialEq)]
enum Sought {
    Label,
    Feature,
    LabelOrFeature,
    Target,
}

impl Sought {
    /// Error if nothing has the name.
    fn unknown(self, name: &str) -> Message {
        match self {
            Self::Label => error!("label-unknown", label = name),
            Self::Feature => error!("feature-unknown", feature = name),
            Self::LabelOrFeature => error!("point-or-feature-unknown", name),
            Self::Target => error!("target-not-exported", target = name),
        }
    }
}

/// Targets that no export has, and the error of each.
#[derive(Default)]
pub(super) struct NotExported(Vec<(String, Message)>);

impl NotExported {
    /// Removes the errors of targets whose absence has another reason, by target and error.
    pub fn withdraw(&self, problems: &mut Problems, is_explained: impl Fn(&str, &Message) -> bool) {
        let explained = self.0.iter().filter(|(target, error)| is_explained(target, error));
        let errors: Vec<&Message> = explained.map(|(_, error)| error).collect();
        problems.0.retain(|problem| !errors.contains(&problem));
    }
}

/// Reports labels and features that do not exist: as a warning if an unread export may have them.
/// Returns the targets that no export has.
pub(super) fn labels(campaign: &Campaign, imported: &Gathered, complete: bool, problems: &mut Problems) -> NotExported {
    let points = imported.all_points();
    // labels that name a target at a pose are not proposed
    let (mut plain, mut labels, mut targets) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    // one by one: building the sets from iterators would first collect all points
    for point in points {
        labels.insert(&*point.label);
        targets.insert(point.target.as_deref().unwrap_or_default());
        if point.target.is_none() {
            plain.insert(&*point.label);
        }
    }
    let file = &campaign.file;
    let (mut open, mut not_exported) = (Vec::<String>::new(), NotExported::default());
    let mut want = |name: &Spanned<String>, among: &[&BTreeSet<&str>], sought: Sought| {
        let text = name.get_ref();
        let borne = |set: &&BTreeSet<&str>| set.contains(text.as_str()) || set.iter().any(|l| matches_pattern(text, l));
        if !among.iter().any(borne) {
            // the campaign contains its features, the exports all else
            if !complete && sought != Sought::Feature {
                return open.push(text.clone());
            }
            let meant = |label: &&str| !label.is_empty() && (!labels.contains(*label) || plain.contains(label));
            let known = among.iter().flat_map(|set| set.iter().copied()).filter(meant);
            let message = sought.unknown(text).at(campaign.place(name)).hint_names(text, known.collect::<Vec<_>>());
            if sought == Sought::Target {
                not_exported.0.push((text.clone(), message.clone()));
            }
            problems.0.push(message);
        }
    };
    for feature in file.features.values() {
        for label in feature.element().map_or(&[][..], |(_, labels)| labels) {
            want(label, &[&labels], Sought::Label);
        }
    }
    let features: BTreeSet<&str> = file.features.keys().map(String::as_str).collect();
    if let Some(world) = file.world() {
        if let (Some(name), false) = (&world.plane, campaign.unread.affects(&["feature"])) {
            want(name, &[&features], Sought::Feature);
        }
        for name in world.names() {
            want(name, &[&labels, &features], Sought::LabelOrFeature);
        }
        for name in world.targets.iter().flatten() {
            let among: &[&BTreeSet<&str>] = if world.each.is_some() { &[&targets] } else { &[&targets, &labels] };
            want(name, among, Sought::Target);
        }
    }
    let rigid = file.rigid.iter().flat_map(|r| &r.targets).chain(file.fixed.iter().flat_map(|f| &f.targets));
    for name in rigid {
        want(name, &[&targets], Sought::Target);
    }
    // points that a log touches need not have the name of the robot's target
    let joined = || file.join_targets().filter(|_| file.join_by() != Some(JoinBy::Label));
    let is_measured = |name: &Spanned<String>| targets.contains(name.get_ref().as_str());
    let odd: Vec<Message> = file.exports.iter().filter_map(|e| other_form(campaign, e, imported)).collect();
    // where no label has the form that is given, no target is named
    let is_odd = complete && !odd.is_empty() && !joined().all(is_measured);
    for name in joined().filter(|_| !is_odd) {
        want(name, &[&targets], Sought::Target);
    }
    problems.0.extend(odd.into_iter().filter(|_| is_odd));
    if !open.is_empty() {
        open.sort_unstable();
        open.dedup();
        let names: Vec<String> = open.iter().map(|name| format!("`{name}`")).collect();
        problems.0.push(warning!("names-unchecked", names));
    }
    not_exported
}

/// Checks the campaign against the robot.
pub(super) fn robot(campaign: &Campaign, robot: &dyn Robot, not_exported: &NotExported, problems: &mut Problems) {
    let names = || robot.parameters().iter().map(|p| p.name.as_str());
    for pattern in campaign.file.identify.iter().flat_map(|identify| &identify.hold) {
        if !names().any(|name| matches_pattern(pattern.get_ref(), name)) {
            let message = error!("parameter-unknown", pattern = pattern.get_ref()).at(campaign.place(pattern));
            problems.0.push(message.hint_names(pattern.get_ref(), names()));
        }
    }
    let of_pose = campaign.file.identify.as_ref().is_some_and(|identify| identify.residuals == ResidualKind::Pose);
    if of_pose && robot.platform().is_none() {
        let message = error!("pose-residuals-not-planar", model = robot.model());
        let place = campaign.key_place(&["identify", "residuals"]);
        problems.0.push(message.hint(phrase!("remedy", remedy = "compare-targets")).at(place));
    }
    let foreign: Vec<_> =
        campaign.file.join_targets().filter(|target| !robot.targets().contains(target.get_ref())).collect();
    for target in &foreign {
        let message = error!("target-not-of-robot", target = target.get_ref()).at(campaign.place(target));
        // a target that this robot cannot have need not be measured
        not_exported.withdraw(problems, |_, other| other.place == message.place);
        problems.0.push(message.hint_names(target.get_ref(), robot.targets().iter().map(String::as_str)));
    }
    // a wrong name stands where the missing one belongs
    if let (Some(targets), true) =
        (campaign.file.join.as_ref().and_then(|join| join.targets.as_ref()), foreign.is_empty())
    {
        let named = |name: &&String| targets.iter().any(|t| t.get_ref() == *name);
        for target in robot.targets().iter().filter(|t| !named(t)) {
            problems.0.push(error!("targets-incomplete", target).at(campaign.key_place(&["join", "targets"])));
        }
    }
    let drawn = campaign.file.geometric.as_ref().is_some_and(|g| g.workspace.is_some());
    if drawn && robot.rail_table().is_some_and(|table| table.travel_mm().is_none()) {
        problems.0.push(error!("travel-missing").at(campaign.key_place(&["geometric", "workspace"])));
    }
    for (i, export) in campaign.file.exports.iter().enumerate() {
        if !campaign.export_reads(i) {
            continue;
        }
        let holds = |role| export.format.dialect.columns.contains(role);
        if robot.dimension() == 3 && (holds(ColumnRole::X) || holds(ColumnRole::Radius)) && !holds(ColumnRole::Z) {
            problems.0.push(error!("z-column-missing").at(campaign.place(&export.file)));
        }
    }
}

/// Errors of a robot without targets, with the line that defines the targets in the labels; no
/// error if the table with the labels cannot be read.
pub(super) fn targets_to_state(unbuilt: Unbuilt, imported: &Gathered, unread: bool) -> Problems {
    let Unbuilt { mut problems, without_target } = unbuilt;
    if unread {
        let mut index = 0..;
        problems.0.retain(|_| !index.next().is_some_and(|i| without_target.contains(&i)));
        return problems;
    }
    let at_poses = imported.all_points().filter(|point| point.pose.is_some());
    let targets: BTreeSet<&str> = at_poses.filter_map(|point| point.target.as_deref()).collect();
    for i in without_target.into_iter().filter(|_| !targets.is_empty()) {
        let targets = format!("{:?}", targets.iter().take(MOST_TARGETS).collect::<Vec<_>>());
        problems.0[i] = problems.0[i].clone().hint(phrase!("state-targets", targets));
    }
    problems
}

/// Checks the logs against the joints of the robot.
pub(super) fn logs(campaign: &Campaign, robot: &dyn Robot, problems: &mut Problems) {
    let stated = stated_columns(robot);
    for (i, log) in campaign.file.logs.iter().enumerate() {
        let named = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        let same = campaign.file.logs.iter().filter(|l| l.name == log.name).count();
        if log.name.is_empty() || !log.name.chars().all(named) || same > 1 {
            let stated = |path: &[&str]| Some(campaign.key_place(path)).filter(|place| place.line.is_some());
            let place = stated(&["log", "name"]).or_else(|| stated(&["log", &i.to_string(), "name"]));
            let place =
                place.filter(|_| !campaign.unread.affects(&["log"])).unwrap_or_else(|| campaign.place(&log.file));
            problems.0.push(error!("log-name-invalid", name = log.name).at(place));
        }
        let known = |key: &str| {
            etalon_formats::is_common_column(key)
                || stated.iter().any(|own| own == key)
                || robot.joints().iter().any(|j| etalon_formats::is_joint_column(key, j) || key == j.direction_column())
        };
        for key in log.keys().filter(|key| !known(key.get_ref()) && etalon_formats::log_column(key.get_ref()).is_some())
        {
            let joints: Vec<String> = robot.joints().iter().map(|joint| joint.column()).collect();
            problems.0.push(error!("log-joint-unknown", key = key.get_ref(), joints).at(campaign.place(key)));
        }
        if campaign.unread.affects(&["log"]) {
            continue;
        }
        for joint in robot.joints() {
            let column = joint.column();
            // a key of the joint in another unit is reported by itself
            let is_meant = |key: &str| key.rsplit_once('_').is_some_and(|(name, _)| name == joint.name);
            let keys = || log.keys().map(|key| key.get_ref().as_str());
            if !keys().any(|key| etalon_formats::is_joint_column(key, joint) || is_meant(key)) {
                let message = error!("log-joint-missing", log = log.name, joint = joint.name, column);
                problems.0.push(message.at(campaign.place(&log.file)));
            }
        }
    }
}

/// Reports targets of the robot that were not measured.
pub(super) fn targets(campaign: &Campaign, robot: &dyn Robot, imported: &Gathered, problems: &mut Problems) {
    // points that a log touches need not have the name of the robot's target
    if campaign.file.join_by() == Some(JoinBy::Label) {
        return;
    }
    let mut measured: BTreeSet<&str> = imported.all_points().filter_map(|p| p.target.as_deref()).collect();
    measured.remove("");
    // targets in [join] are reported with the labels
    let reported = |target: &String| campaign.file.join_targets().any(|t| t.get_ref() == target);
    let mut missing = robot.targets().iter().filter(|t| !measured.contains(t.as_str()) && !reported(t)).peekable();
    let odd: Vec<Message> = campaign.file.exports.iter().filter_map(|e| other_form(campaign, e, imported)).collect();
    if missing.peek().is_some() && !odd.is_empty() {
        return problems.0.extend(odd);
    }
    let unnamed: Vec<Message> =
        campaign.file.exports.iter().filter_map(|e| unstated_form(campaign, e, imported, robot)).collect();
    if missing.peek().is_some() && !unnamed.is_empty() {
        return problems.0.extend(unnamed);
    }
    for target in missing {
        let message = error!("target-not-exported", target).at(campaign.key_place(&["join"]));
        problems.0.push(message.hint_names(target, measured.iter().copied()));
    }
}

/// Error if the labels of an export name targets of the robot, and the campaign contains no form.
fn unstated_form(campaign: &Campaign, export: &Export, imported: &Gathered, robot: &dyn Robot) -> Option<Message> {
    if export.label.is_some() || export.target.is_some() || export.from_name.target.is_some() {
        return None;
    }
    let own = imported.all_points().filter(|p| *p.export == **export.file.get_ref());
    let labels: Vec<&str> = own.filter(|p| p.target.is_none()).map(|p| &*p.label).collect();
    let (form, targets) = etalon_formats::label_form(&labels)?;
    let file = export.file.get_ref();
    let is_named = targets.iter().any(|target| robot.targets().contains(target));
    is_named.then(|| error!("label-form-missing", file, form).at(campaign.place(&export.file)))
}

/// Error if no label of an export has the form that the campaign contains.
fn other_form(campaign: &Campaign, export: &Export, imported: &Gathered) -> Option<Message> {
    let form = export.label.as_ref()?;
    let pattern = etalon_formats::LabelPattern::parse(form.get_ref()).ok()?;
    let own = || imported.all_points().filter(|p| *p.export == **export.file.get_ref());
    let first = &own().next()?.label;
    if own().any(|p| p.pose.is_some() || pattern.read(&p.label, |_| false).is_some()) {
        return None;
    }
    let message = error!("label-form-differs", file = export.file.get_ref(), form = form.get_ref(), first = **first);
    Some(message.at(campaign.place(form)))
}
