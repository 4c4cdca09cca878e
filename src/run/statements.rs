//! Statements of a campaign that contradict each other or mean nothing, whatever the files hold.

use etalon_base::date::date;
use etalon_base::message::{Message, Problems};
use etalon_campaign::{Campaign, ClockOffset, Join, JoinBy};
use etalon_documents::{LimitQuantity, ResidualKind};
use etalon_formats::Export;
use etalon_formats::dialect::ColumnRole;
use etalon_formats::table::LABEL;
use etalon_robots::Quantity;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Expanded uncertainties of a coordinate, from an interferometer's to a camera's; beyond them the unit is another.
const PLAUSIBLE_UM: std::ops::RangeInclusive<f64> = 0.05..=1e5;

/// Temperatures of a part in a workshop or a climatic chamber, degC.
const TEMPERATURES_C: std::ops::RangeInclusive<f64> = -50.0..=100.0;

/// All statements but those on features and frames.
pub(super) fn check(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    let unread = &campaign.unread;
    if let Some(identify) = file.identify.as_ref().filter(|_| !unread.affects(&["identify"])) {
        problems.0.extend(campaign.selections(identify).err().unwrap_or_default().0);
    }
    for name in file.controllers.iter().flatten() {
        if etalon_controllers::by_name(name.get_ref()).is_none() {
            let what = format!("`{}` is not a controller format", name.get_ref());
            problems.0.push(
                Message::error(what).at(campaign.place(name)).hint_names(name.get_ref(), etalon_controllers::names()),
            );
        }
    }
    let instrument = &file.instrument;
    let mut stated = vec![
        ("instrument", "expanded_uncertainty_um", instrument.expanded_uncertainty_um),
        ("instrument", "coverage_factor", instrument.coverage_factor),
    ];
    if let Some(contact) = &file.contact {
        stated.push(("contact", "repeatability_um", contact.repeatability_um));
        stated.push(("contact", "coverage_factor", contact.coverage_factor));
        if file.identify.as_ref().is_some_and(|identify| identify.residuals == ResidualKind::Pose) {
            let message = Message::error("[contact] is for residuals of targets").at(campaign.place_of(&["contact"]));
            problems.0.push(message.hint("state `residuals = \"targets\"`, or leave [contact] out"));
        }
    }
    if let Some(tool) = &file.tool {
        stated.push(("tool", "expanded_uncertainty_um", tool.expanded_uncertainty_um));
        stated.push(("tool", "coverage_factor", tool.coverage_factor));
    }
    for (table, key, value) in stated {
        if value <= 0.0 {
            let message = Message::error(format!("`{key}` must be positive")).at(campaign.place_of(&[table, key]));
            let hint = match table {
                "instrument" => "take it from the instrument's calibration certificate",
                "tool" => "state how well the place of the point on the tool is known",
                _ => "touch one point often and take the scatter of the encoder readings",
            };
            problems.0.push(message.hint(hint));
        } else if key.ends_with("_um") && !PLAUSIBLE_UM.contains(&value) {
            let what = format!("`{key}` = {value:?} is not an uncertainty of a measured coordinate in micrometres");
            let message = Message::error(what).at(campaign.place_of(&[table, key]));
            problems.0.push(message.hint("check its unit: 0.0027 mm is 2.7 um"));
        }
    }
    common_errors(campaign, problems);
    without_use(campaign, problems);
    limits(campaign, problems);
    output(campaign, problems);
    observations(campaign, problems);
    if let Some(definition) = file.join.as_ref().filter(|_| !unread.affects(&["join"])) {
        join(campaign, definition, problems);
    }
    let targets: Vec<_> = file.join_targets().collect();
    for (i, target) in targets.iter().enumerate() {
        if targets[..i].iter().any(|t| t.get_ref() == target.get_ref()) {
            let message = Message::error(format!("target `{}` is there twice", target.get_ref()));
            problems.0.push(message.at(campaign.place(target)));
        }
    }
    if let (Some((message, at)), false) =
        (file.joints_stated_twice(), unread.affects(&["log"]) || unread.affects(&["join"]))
    {
        problems.0.push(message.at(campaign.place(at)));
    }
    file.exports.iter().for_each(|export| stated_twice(campaign, export, problems));
}

/// Limits that are positive, and that something judges.
fn limits(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    for (quantity, limit) in file.limits.stated() {
        let place = || campaign.place_of(&["limits", quantity.into()]);
        if limit <= 0.0 {
            let message = Message::error(format!("the limit `{quantity}` must be positive"));
            problems.0.push(message.at(place()));
        }
        let labelled = file.repeatability.as_ref();
        let (needs, stated) = match quantity {
            LimitQuantity::RepeatabilityMaxMm => {
                ("[repeatability] or [poses]", labelled.is_some() || file.poses.is_some())
            }
            LimitQuantity::AccuracyMaxMm => {
                let commanded = labelled.is_some_and(|r| r.commanded.is_some()) || file.poses.is_some();
                ("[repeatability] with `commanded`, or [poses]", commanded)
            }
            _ => ("[identify]", campaign.identifies()),
        };
        if !stated {
            let message = Message::error(format!("the limit `{quantity}` needs {needs}"));
            problems.0.push(message.at(place()).hint("remove it, or state what it judges"));
        }
    }
}

/// What a table of observations excludes.
fn observations(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    if file.instrument.expanded_rotation_uncertainty_deg.is_some_and(|u| u <= 0.0) {
        let key = "expanded_rotation_uncertainty_deg";
        let message = Message::error(format!("`{key}` must be positive"));
        problems.0.push(message.at(campaign.place_of(&["instrument", key])));
    }
    if file.observations.is_empty() {
        return;
    }
    let beside = [("export", !file.exports.is_empty()), ("log", !file.logs.is_empty()), ("join", file.join.is_some())];
    for (key, _) in beside.iter().filter(|(_, stated)| *stated) {
        let message = Message::error(format!("`{key}` is stated beside [observations]"));
        let hint =
            "a table of observations holds what was measured and the joint values: state it, or exports, log and join";
        problems.0.push(message.at(campaign.place_of(&[key])).hint(hint));
    }
}

/// What a join by time needs, and what means nothing for another.
fn join(campaign: &Campaign, join: &Join, problems: &mut Problems) {
    let file = &campaign.file;
    let by_time = join.by == JoinBy::Time;
    let clocks = [("clock_offset_s", join.clock_offset_s.is_some()), ("tolerance_s", join.tolerance_s.is_some())];
    if by_time && clocks.iter().any(|(_, stated)| !stated) {
        problems.0.push(
            Message::error("a join by time needs the offset of the clocks and a tolerance")
                .at(campaign.place_of(&["join", "by"]))
                .hint(
                    "add `clock_offset_s` (time of the measurement minus time of the log) and `tolerance_s` to [join]",
                ),
        );
    }
    let estimated = join.clock_offset_s == Some(ClockOffset::Standstills);
    for log in file.logs.iter().filter(|_| !campaign.unread.affects(&["log"]) && by_time) {
        let what = match (estimated, join.interpolate, log.standstill.is_some()) {
            (true, _, false) => "the offset of the clocks cannot come from standstills of a log that states none",
            (_, true, true) => "between standstills there is nothing to interpolate",
            _ => continue,
        };
        let message = Message::error(format!("{what}: `{}`", log.name)).at(campaign.place_of(&["join", "by"]));
        let hint = if log.standstill.is_some() {
            "leave `interpolate` out: a point meets the standstill that it falls into"
        } else {
            "add [log.standstill] with `at_least_s` and `within_deg` or `within_mm`, or state `clock_offset_s` as a number"
        };
        problems.0.push(message.hint(hint));
    }
    let beside = [clocks[0], clocks[1], ("interpolate", join.interpolate)];
    for (key, _) in beside.iter().filter(|(_, stated)| *stated && !by_time) {
        let message = Message::error(format!("`{key}` means nothing for this join"));
        problems.0.push(message.at(campaign.place_of(&["join", key])).hint("it belongs to `by = \"time\"`"));
    }
    if join.tolerance_s.is_some_and(|t| t < 0.0) {
        let message = Message::error("`tolerance_s` must not be negative");
        problems.0.push(message.at(campaign.place_of(&["join", "tolerance_s"])));
    }
    for log in file.logs.iter().filter(|_| !campaign.unread.affects(&["log"])) {
        let column = log.columns.keys().find(|key| key.get_ref() == LABEL);
        match (column, join.by == JoinBy::Label) {
            (None, true) => problems.0.push(
                Message::error(format!("a join by label needs the label of the point in log `{}`", log.name))
                    .at(campaign.place_of(&["join", "by"]))
                    .hint("add `label = \"name or number of the column\"` to its `columns`"),
            ),
            (Some(key), false) => problems.0.push(
                Message::error("`label` means nothing for this join")
                    .at(campaign.place(key))
                    .hint("it belongs to `by = \"label\"`"),
            ),
            _ => {}
        }
    }
}

/// A pose or a target that both the file and a column of it state.
fn stated_twice(campaign: &Campaign, export: &Export, problems: &mut Problems) {
    let stated =
        [("pose", export.pose.is_some(), ColumnRole::Pose), ("target", export.target.is_some(), ColumnRole::Target)];
    for (key, _, _) in
        stated.into_iter().filter(|(_, stated, role)| *stated && export.format.dialect.columns.contains(*role))
    {
        let message = Message::error(format!("`{key}` is stated twice: by this export, and by a column of it"));
        problems.0.push(message.at(campaign.place(&export.file)).hint("leave one of them out"));
    }
}

/// The output folder must not be one that holds inputs, nor one of them.
fn output(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    let output = match campaign.output() {
        Ok(output) => output,
        Err(more) => return problems.0.extend(more.0),
    };
    let stated = |file: &&Spanned<String>| !file.get_ref().is_empty();
    let named =
        file.inputs().chain([&file.robot]).chain(&file.report.logo).chain(&file.report.templates).filter(stated);
    let inputs = named.filter_map(|f| campaign.resolve(f).ok()).chain([campaign.location.clone()]);
    // the folders that links lead to; one that is not there yet is below one that is
    let place = |path: &Path| {
        let there = path.ancestors().find_map(|above| Some((above, canonical(above)?)));
        there.map(|(above, place)| place.join(path.strip_prefix(above).unwrap_or(path)))
    };
    let folder = place(&output);
    let within =
        |input: &PathBuf| matches!((place(input), &folder), (Some(input), Some(folder)) if input.starts_with(folder));
    if let Some(input) = inputs.into_iter().find(within) {
        let what = format!("the output folder holds the input `{}`, and is replaced whole", input.display());
        let message = Message::error(what).at(campaign.place_of(&["output"]));
        problems.0.push(message.hint("name another folder, or none: it is `out` by default"));
    }
}

/// Where a path leads, if it is there; an empty one is the present folder.
fn canonical(path: &Path) -> Option<PathBuf> {
    if path.as_os_str().is_empty() { Path::new(".").canonicalize().ok() } else { path.canonicalize().ok() }
}

/// Features and the world frame: whether each is stated in one way.
pub(super) fn frames(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    for (name, feature) in &file.features {
        let Some((_, labels)) = feature.element() else {
            if campaign.unread.affects(&["feature", name]) {
                continue;
            }
            problems.0.push(
                Message::error(format!("feature `{name}` must be exactly one element"))
                    .at(campaign.place_of(&["feature", name]))
                    .expected("one of `plane`, `line`, `circle`, `cylinder` with the labels of its points"),
            );
            continue;
        };
        for (i, label) in labels.iter().enumerate() {
            if labels[..i].iter().any(|l| l.get_ref() == label.get_ref()) {
                let what = format!("feature `{name}` names `{}` twice", label.get_ref());
                problems.0.push(Message::error(what).at(campaign.place(label)));
            }
        }
    }
    if campaign.unread.affects(&["frame"]) {
        return;
    }
    let Some(world) = file.world() else { return };
    if world.nominal_mm.is_empty() == world.tolerance_mm.is_some() {
        let message = Message::error("`nominal_mm` and `tolerance_mm` of the world frame belong together");
        let hint = "state the places of the drawing, and how far a point may be from its own";
        problems.0.push(message.at(campaign.world_place()).hint(hint));
    }
    if world.tolerance_mm.is_some_and(|t| t < 0.0) {
        problems.0.push(Message::error("`tolerance_mm` must not be negative").at(campaign.world_place()));
    }
    let ways = [world.plane.is_some(), world.targets.is_some(), world.as_exported];
    if ways.iter().filter(|w| **w).count() != 1 {
        problems.0.push(
            Message::error("the world frame must be defined in exactly one way")
                .at(campaign.world_place())
                .expected("`plane` with `origin` and an axis, or `targets`, or `as_exported = true`"),
        );
    } else if world.plane.is_some() {
        if world.each.is_some() {
            let message = Message::error("`each` means nothing for a world frame from a plane");
            problems.0.push(message.at(campaign.world_place()).hint("it belongs to `targets`"));
        }
        for ends in world.x_axis.iter().chain(&world.y_axis) {
            let directed = match &ends[..] {
                [one] => file.features.contains_key(one.get_ref()),
                ends => ends.len() == 2,
            };
            if !directed {
                let place = ends.first().map_or_else(|| campaign.world_place(), |end| campaign.place(end));
                let message = Message::error("the axis of the world frame has no direction").at(place);
                problems.0.push(message.expected("two labels, from and to, or one feature with a direction"));
            }
        }
        let axes = usize::from(world.x_axis.is_some()) + usize::from(world.y_axis.is_some());
        if axes != 1 || world.origin.is_none() || world.towards.is_none() {
            problems.0.push(
                Message::error(
                    "a world frame from a plane needs `origin`, one of `x_axis` and `y_axis`, and `towards`",
                )
                .at(campaign.world_place())
                .hint("`towards` names a label on the positive side of the other axis: it decides which way z points"),
            );
        }
    } else {
        let idle = [("origin", world.origin.is_some()), ("x_axis", world.x_axis.is_some())];
        let idle = idle.into_iter().chain([("y_axis", world.y_axis.is_some()), ("towards", world.towards.is_some())]);
        let idle = idle.chain([("each", world.each.is_some() && world.as_exported)]);
        for (key, _) in idle.filter(|(_, stated)| *stated) {
            let message = Message::error(format!("`{key}` means nothing for this world frame"));
            problems.0.push(message.at(campaign.world_place()));
        }
    }
}

/// Names of files, dates, temperatures and nominal lengths that mean nothing.
pub(super) fn values(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    // what is not stated at all is reported already
    for name in file.inputs().chain([&file.robot]).filter(|f| f.get_ref().is_empty() && !f.span().is_empty()) {
        problems.0.push(Message::error("the name of a file is empty").at(campaign.place(name)));
    }
    if file.date.as_deref().is_some_and(|text| date(text).is_none()) {
        let message = Message::error("`date` does not begin with a date of the calendar");
        problems.0.push(message.at(campaign.place_of(&["date"])).expected("year-month-day (ISO 8601), as 2026-01-31"));
    }
    if file.temperature_c.is_some_and(|t| !TEMPERATURES_C.contains(&t)) {
        let message = Message::error("`temperature_c` is not a temperature at which robots are measured, in degC");
        problems.0.push(message.at(campaign.place_of(&["temperature_c"])));
    }
    let Some(geometric) = &file.geometric else { return };
    if let Some((missing, by)) = geometric.missing().first() {
        let message = Message::error(format!("[geometric] lacks `{missing}`, which `{by}` needs"));
        let hint = "s needs `shaft` and `arc`; d1 and d3 need `offsets`, `mid_travel_mm`, `arc`, `turn` and `shaft`; O needs `arc` and C `turn` alone";
        problems.0.push(message.at(campaign.place_of(&["geometric"])).hint(hint));
    }
    if let Some(table) = geometric.table.first().filter(|_| !geometric.is_whole() || !campaign.identifies()) {
        let message = Message::error("a table of errors needs the whole geometric calibration and [identify]");
        problems.0.push(message.at(campaign.place(&table.poses)));
    }
    let leads = geometric.lead.iter().map(|lead| (&lead.label, "lead_mm", lead.lead_mm));
    let bars = geometric.scale_bar.iter().map(|bar| (&bar.label, "length_mm", bar.length_mm));
    for (label, key, value) in leads.chain(bars).filter(|(_, _, value)| *value <= 0.0) {
        let what = format!("`{key}` = {value:?} must be positive");
        problems.0.push(Message::error(what).at(campaign.place(label)));
    }
}

/// Coefficients of thermal expansion: beyond them the unit is another.
const PER_C: std::ops::RangeInclusive<f64> = 0.0..=2e-4;

/// What is stated of errors that all readings have in common, and of an instrument that measures range and angles.
fn common_errors(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    let mut wrong = |path: &[&str], value: f64, range: std::ops::RangeInclusive<f64>, hint: &str| {
        if !range.contains(&value) {
            let what = format!(
                "`{}` = {value:?} is not between {:?} and {:?}",
                path[path.len() - 1],
                range.start(),
                range.end()
            );
            problems.0.push(Message::error(what).at(campaign.place_of(path)).hint(hint));
        }
    };
    let um = || 0.0..=*PLAUSIBLE_UM.end();
    let factor = 0.1..=10.0;
    if let Some(scale) = file.instrument.expanded_scale_uncertainty_um_per_m {
        wrong(&["instrument", "expanded_scale_uncertainty_um_per_m"], scale, 0.0..=1e3, "1 um/m is 1 ppm");
    }
    if let Some(polar) = &file.instrument.polar {
        let path = |key| ["instrument", "polar", key];
        let hint = "check its unit: 10 ppm are 10 um/m, 1 arc second is 4.85 um/m";
        wrong(&path("expanded_range_uncertainty_um"), polar.expanded_range_uncertainty_um, um(), hint);
        let by_m = |value, key| (path(key), value, 0.0..=1e4);
        for (path, value, range) in [
            by_m(polar.expanded_range_uncertainty_um_per_m, "expanded_range_uncertainty_um_per_m"),
            by_m(polar.expanded_angle_uncertainty_um_per_m, "expanded_angle_uncertainty_um_per_m"),
        ] {
            wrong(&path, value, range, hint);
        }
    }
    if let Some(expansion) = &file.expansion {
        let path = |key| ["expansion", key];
        let hint = "check its unit: steel expands by 11.5e-6 per degree, aluminium by 23.5e-6";
        wrong(&path("robot_per_c"), expansion.robot_per_c, PER_C, hint);
        wrong(&path("part_per_c"), expansion.part_per_c, PER_C, hint);
        let key = "expanded_temperature_uncertainty_c";
        wrong(&path(key), expansion.expanded_temperature_uncertainty_c, 0.0..=50.0, "state it in degrees");
        wrong(
            &path("coverage_factor"),
            expansion.coverage_factor,
            factor.clone(),
            "a coverage factor of 2 is a level of confidence of about 95 %",
        );
    }
    if let Some(homing) = &file.homing {
        let path = |key| ["homing", key];
        let hint = "home the robot often and take the scatter of a joint at its switch";
        wrong(
            &path("coverage_factor"),
            homing.coverage_factor,
            factor,
            "a coverage factor of 2 is a level of confidence of about 95 %",
        );
        wrong(&path("expanded_uncertainty_um"), homing.expanded_uncertainty_um.unwrap_or(0.0), um(), hint);
        wrong(&path("expanded_uncertainty_deg"), homing.expanded_uncertainty_deg.unwrap_or(0.0), 0.0..=5.0, hint);
        let Ok(robot) = campaign.build_robot() else { return };
        for joint in robot.joints() {
            let (key, stated) = match joint.quantity {
                Quantity::Angle => ("expanded_uncertainty_deg", homing.expanded_uncertainty_deg),
                _ => ("expanded_uncertainty_um", homing.expanded_uncertainty_um),
            };
            if stated.is_none() {
                let what = format!(
                    "[homing] lacks `{key}`, and the joint `{}` has values in {}",
                    joint.name,
                    joint.quantity.unit()
                );
                let hint = "state it, 0 where homing adds nothing";
                return problems.0.push(Message::error(what).at(campaign.place_of(&["homing"])).hint(hint));
            }
        }
    }
}

/// Uncertainties that are stated and that nothing of the campaign would use.
fn without_use(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    if file.instrument.polar.is_some() && !file.observations.is_empty() {
        let what = "`polar` is for exports: a table of observations does not show where the instrument is";
        let message = Message::error(what).at(campaign.place_of(&["instrument", "polar"]));
        problems.0.push(message.hint("state the covariance of each row (`cxx_mm2` to `czz_mm2`) in the table"));
    }
    for (key, stated) in [("expansion", file.expansion.is_some()), ("homing", file.homing.is_some())] {
        if stated && !campaign.identifies() {
            let message = Message::error(format!("[{key}] is for identified parameters, and there is no [identify]"));
            problems.0.push(message.at(campaign.place_of(&[key])).hint("remove it, or state [identify]"));
        }
    }
}

/// Numbers of `[conditions]` that mean nothing.
pub(super) fn conditions(campaign: &Campaign, problems: &mut Problems) {
    let conditions = &campaign.file.conditions;
    let mut wrong = |key: &str, must: &str| {
        let message = Message::error(format!("`{key}` must {must}"));
        problems.0.push(message.at(campaign.place_of(&["conditions", key])));
    };
    for (key, value) in conditions.positive() {
        if value <= 0.0 {
            wrong(key, "be positive");
        } else if key == "humidity_percent" && value > 100.0 {
            wrong(key, "be at most 100");
        }
    }
    for (key, value) in conditions.not_negative() {
        if value < 0.0 {
            wrong(key, "not be negative");
        }
    }
}
