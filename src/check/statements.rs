//! Statements of a campaign that contradict each other or mean nothing, whatever the files hold.

use crate::campaign::{Campaign, JoinBy, Selection};
use crate::export;
use crate::message::{Message, Problems, Result};
use std::collections::BTreeSet;

/// All statements but those on features and frames.
pub(super) fn check(campaign: &Campaign, problems: &mut Problems) {
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
    for (key, value) in [
        ("expanded_uncertainty_um", instrument.expanded_uncertainty_um),
        ("coverage_factor", instrument.coverage_factor),
    ] {
        if value <= 0.0 {
            let message = Message::error(format!("`{key}` must be positive"));
            let message = message.at(campaign.place_of(&["instrument", key]));
            problems.0.push(message.hint("take it from the instrument's calibration certificate"));
        }
    }
    for (key, limit) in file.limits.stated() {
        if limit.is_some_and(|limit| limit <= 0.0) {
            let message = Message::error(format!("the limit `{key}` must be positive"));
            problems.0.push(message.at(campaign.place_of(&["limits", key])));
        }
    }
    output(campaign, problems);
    if file.join.by == JoinBy::Time && (file.join.clock_offset_s.is_none() || file.join.tolerance_s.is_none()) {
        problems.0.push(
            Message::error("a join by time needs the offset of the clocks and a tolerance").hint(
                "add `clock_offset_s` (time of the measurement minus time of the log) and `tolerance_s` to [join]",
            ),
        );
    }
    if file.join.tolerance_s.is_some_and(|t| t < 0.0) {
        let message = Message::error("`tolerance_s` must not be negative");
        problems.0.push(message.at(campaign.place_of(&["join", "tolerance_s"])));
    }
    let targets: Vec<_> = file.join.targets.iter().flatten().collect();
    for (i, target) in targets.iter().enumerate() {
        let wrong = |what: String| Message::error(what).at(campaign.place(target));
        if targets[..i].iter().any(|t| t.get_ref() == target.get_ref()) {
            problems.0.push(wrong(format!("target `{}` is there twice", target.get_ref())));
        }
        if target.get_ref() == "base" {
            let message =
                wrong("no target can be called `base`: its parameters would be those of the robot's base".into());
            problems.0.push(message.hint("give the target another name in label or columns"));
        }
    }
}

/// The output folder must not be one that holds inputs.
fn output(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    let output = match campaign.output() {
        Ok(output) => output,
        Err(more) => return problems.0.extend(more.0),
    };
    let inputs = file.exports.iter().map(|e| &e.file).chain(file.logs.iter().map(|l| &l.file));
    let beside = |f: &&toml::Spanned<String>| {
        campaign.resolve(f).is_ok_and(|path| path.parent().is_some_and(|p| p.components().eq(output.components())))
    };
    if let Some(input) = inputs.into_iter().find(beside) {
        let what = format!("the output folder holds an input of this campaign, `{}`", input.get_ref());
        let message = Message::error(what).at(campaign.place_of(&["output"]));
        problems.0.push(message.hint("name another folder, or none: it is `out` by default"));
    }
}

/// Errors where a selection takes none of these poses, or calibration and validation share some.
pub fn selections(campaign: &Campaign, poses: &BTreeSet<i64>) -> Result<()> {
    // what does not read is told with the statements
    let Ok((calibration, validation)) = campaign.selections() else { return Ok(()) };
    let identify = &campaign.file.identify;
    let mut problems = Problems::default();
    let taken = |i: usize, pose: i64| calibration.contains(pose, i, false);
    let numbered = || poses.iter().copied().enumerate();
    if !numbered().any(|(i, pose)| taken(i, pose)) {
        let message = Message::error("`calibration` selects no pose that was measured");
        problems.0.push(message.at(campaign.place(&identify.calibration)));
    }
    if let (Some(validation), Some(text)) = (&validation, &identify.validation) {
        let tests = |i: usize, pose: i64| validation.contains(pose, i, taken(i, pose));
        if !numbered().any(|(i, pose)| tests(i, pose)) {
            let message = Message::error("`validation` selects no pose that was measured");
            problems.0.push(message.at(campaign.place(text)));
        }
        let shared: Vec<String> = numbered()
            .filter(|&(i, pose)| taken(i, pose) && tests(i, pose) && *validation != Selection::Rest)
            .map(|(_, pose)| pose.to_string())
            .collect();
        if let Some((first, last)) = shared.first().zip(shared.last()) {
            let what = format!("{} poses are in both calibration and validation, from {first} to {last}", shared.len());
            let message = Message::error(what).at(campaign.place(text));
            problems.0.push(message.hint("`validation = \"rest\"` takes all that calibration does not"));
        }
    }
    problems.check().map(|_| ())
}

/// Features and the world frame: whether each is stated in one way.
pub(super) fn frames(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
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
        if world.each.is_some() {
            let message = Message::error("`each` means nothing for a world frame from a plane");
            problems.0.push(message.at(campaign.place(&file.frame.world)).hint("it belongs to `targets`"));
        }
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
    } else {
        let idle = [("origin", world.origin.is_some()), ("x_axis", world.x_axis.is_some())];
        let idle = idle.into_iter().chain([("y_axis", world.y_axis.is_some()), ("towards", world.towards.is_some())]);
        let idle = idle.chain([("each", world.each.is_some() && world.as_exported)]);
        for (key, _) in idle.filter(|(_, stated)| *stated) {
            let message = Message::error(format!("`{key}` means nothing for this world frame"));
            problems.0.push(message.at(campaign.place(&file.frame.world)));
        }
    }
}
