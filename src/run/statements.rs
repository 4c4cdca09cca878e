//! Data of a campaign that contradict each other or have no effect, independent of its files.

use etalon_base::date::{date, date_text};
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};
use etalon_campaign::{Campaign, ClockOffset, ClockRate, Join, JoinBy, PLAUSIBLE_EXPANDED_UM};
use etalon_documents::{LimitQuantity, ResidualKind};
use etalon_formats::Export;
use etalon_formats::dialect::ColumnRole;
use etalon_formats::table::LABEL;
use etalon_robots::Quantity;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Plausible temperatures of a part in a workshop or a climatic chamber (°C).
const TEMPERATURES_C: std::ops::RangeInclusive<f64> = -50.0..=100.0;

/// Checks all statements except features and frames.
pub(super) fn check(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    let unread = &campaign.unread;
    if let Some(identify) = file.identify.as_ref().filter(|_| !unread.affects(&["identify"])) {
        problems.0.extend(campaign.selections(identify).err().unwrap_or_default().0);
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
            problems.0.push(error!("contact-without-targets").at(campaign.key_place(&["contact"])));
        }
    }
    if let Some(tool) = &file.tool {
        stated.push(("tool", "expanded_uncertainty_um", tool.expanded_uncertainty_um));
        stated.push(("tool", "coverage_factor", tool.coverage_factor));
    }
    for (section, key, value) in stated {
        let place = || campaign.key_place(&[section, key]);
        if value <= 0.0 {
            let message = error!("key-not-positive", key).at(place());
            problems.0.push(message.hint(phrase!("uncertainty-source", section)));
        } else if key.ends_with("_um") && !PLAUSIBLE_EXPANDED_UM.contains(&value) {
            let (least, most) = (*PLAUSIBLE_EXPANDED_UM.start(), *PLAUSIBLE_EXPANDED_UM.end());
            problems.0.push(error!("key-uncertainty-implausible", key, value, least, most).at(place()));
        }
    }
    valid_until(campaign, problems);
    common_errors(campaign, problems);
    without_use(campaign, problems);
    limits(campaign, problems);
    output(campaign, problems);
    problems.keep(campaign.uncertainty_bound());
    observations(campaign, problems);
    if let Some(definition) = file.join.as_ref().filter(|_| !unread.affects(&["join"])) {
        join(campaign, definition, problems);
    }
    let targets: Vec<_> = file.join_targets().collect();
    let mut known = BTreeSet::new();
    for target in &targets {
        if !known.insert(target.get_ref()) {
            problems.0.push(error!("target-named-twice", target = target.get_ref()).at(campaign.place(target)));
        }
    }
    if let (Some((message, at)), false) =
        (file.joints_stated_twice(), unread.affects(&["log"]) || unread.affects(&["join"]))
    {
        problems.0.push(message.at(campaign.place(at)));
    }
    // files of one form are one export of the text
    let tables = file.exports.chunk_by(|a, b| a.file.span() == b.file.span()).filter_map(<[Export]>::first);
    tables.for_each(|export| stated_twice(campaign, export, problems));
}

/// Maximum number of months of validity.
const MOST_MONTHS: u32 = 120;

/// Checks that the last day of validity is a date, and not before the measurements, and that a
/// number of months has a date from which it counts.
fn valid_until(campaign: &Campaign, problems: &mut Problems) {
    if let Some(months) = campaign.file.valid_for_months {
        let error = match () {
            () if campaign.file.valid_until.is_some() => Some(error!("valid-stated-twice")),
            () if campaign.file.date.as_deref().and_then(date).is_none() => Some(error!("valid-months-without-date")),
            () if !(1..=MOST_MONTHS).contains(&months) => {
                Some(error!("valid-months-implausible", months, most = MOST_MONTHS))
            }
            () => None,
        };
        problems.0.extend(error.map(|error| error.at(campaign.key_place(&["valid_for_months"]))));
    }
    let Some(stated) = &campaign.file.valid_until else { return };
    let place = || campaign.key_place(&["valid_until"]);
    let Some(last) = date(stated).filter(|_| stated.len() == 10) else {
        problems.0.push(error!("valid-until-no-date", date = stated).at(place()));
        return;
    };
    let measured = campaign.file.date.as_deref().and_then(date);
    if let Some(first) = measured.filter(|first| last < *first) {
        let measured = date_text(first);
        problems.0.push(error!("valid-until-before-measurements", date = stated, measured).at(place()));
    }
}

/// Checks that limits are positive and that the campaign determines their quantities.
fn limits(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    for (quantity, limit) in file.limits.stated() {
        let place = || campaign.key_place(&["limits", quantity.into()]);
        if limit <= 0.0 {
            problems.0.push(error!("key-not-positive", key = quantity.to_string()).at(place()));
        }
        let labelled = file.repeatability.as_ref();
        let (needs, stated) = match quantity {
            LimitQuantity::RepeatabilityMaxMm => ("repeatability", labelled.is_some() || file.poses.is_some()),
            LimitQuantity::AccuracyMaxMm => {
                let commanded = labelled.is_some_and(|r| r.commanded.is_some()) || file.poses.is_some();
                ("commanded", commanded)
            }
            _ => ("identify", campaign.identifies()),
        };
        if !stated {
            problems.0.push(error!("limit-without-result", limit = quantity.to_string(), needs).at(place()));
        }
    }
}

/// Checks that no section contradicts a table of observations.
fn observations(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    if file.instrument.expanded_rotation_uncertainty_deg.is_some_and(|u| u <= 0.0) {
        let key = "expanded_rotation_uncertainty_deg";
        problems.0.push(error!("key-not-positive", key).at(campaign.key_place(&["instrument", key])));
    }
    if file.observations.is_empty() {
        return;
    }
    let beside = [("export", !file.exports.is_empty()), ("log", !file.logs.is_empty()), ("join", file.join.is_some())];
    for (section, _) in beside.iter().filter(|(_, stated)| *stated) {
        problems.0.push(error!("section-beside-observations", section).at(campaign.key_place(&[section])));
    }
}

/// Line that describes standstills of the joints of the logs, as a hint proposes it.
fn standstill_line(campaign: &Campaign) -> String {
    let keys = || campaign.file.logs.iter().flat_map(|log| log.keys());
    let has = |units: &[&str]| keys().any(|key| units.iter().any(|unit| key.get_ref().ends_with(unit)));
    let turns = if has(&["_deg", "_rad"]) { ", within_deg = 0.02" } else { "" };
    let slides = if has(&["_mm", "_m", "_um"]) { ", within_mm = 0.01" } else { "" };
    format!("standstill = {{ at_least_s = 1.0{turns}{slides} }}")
}

/// `true` if the clock offset is estimated from standstills, and a log has none: an error of its
/// own, and a join without an offset only repeats it.
pub(super) fn lacks_standstills(campaign: &Campaign) -> bool {
    let join = campaign.file.join.as_ref().filter(|join| join.by == JoinBy::Time);
    join.is_some_and(|join| join.clock_offset_s == Some(ClockOffset::Standstills))
        && campaign.file.logs.iter().any(|log| log.standstill.is_none())
}

/// Checks that a join has its keys, and no keys of other joins.
fn join(campaign: &Campaign, join: &Join, problems: &mut Problems) {
    let file = &campaign.file;
    let by_time = join.by == JoinBy::Time;
    let clocks = [("clock_offset_s", join.clock_offset_s.is_some()), ("tolerance_s", join.tolerance_s.is_some())];
    let keys: Vec<String> = clocks.iter().filter(|(_, stated)| !stated).map(|(key, _)| format!("`{key}`")).collect();
    if by_time && !keys.is_empty() {
        let line = |key: &str| if key == "tolerance_s" { "`tolerance_s = 0.05`" } else { "`clock_offset_s = 0.0`" };
        let lines: Vec<&str> = clocks.iter().filter(|(_, stated)| !stated).map(|(key, _)| line(key)).collect();
        let message = error!("join-clock-missing", keys, lines, standstill = standstill_line(campaign));
        problems.0.push(message.at(campaign.key_place(&["join", "by"])));
    }
    let estimated = join.clock_offset_s == Some(ClockOffset::Standstills);
    for log in file.logs.iter().filter(|_| !campaign.unread.affects(&["log"]) && by_time) {
        let message = match (estimated, join.interpolate, log.standstill.is_some()) {
            (true, _, false) => error!("standstills-missing", log = log.name, standstill = standstill_line(campaign)),
            (_, true, true) => error!("interpolate-with-standstills", log = log.name),
            _ => continue,
        };
        problems.0.push(message.at(campaign.key_place(&["join", "by"])));
    }
    let agrees = match join.clock_rate {
        None => true,
        Some(ClockRate::Standstills) => estimated,
        Some(ClockRate::Motion) => join.clock_offset_s == Some(ClockOffset::Motion),
    };
    if by_time && !agrees {
        problems.0.push(error!("clock-rate-without-offset").at(campaign.key_place(&["join", "clock_rate"])));
    }
    let rate = ("clock_rate", join.clock_rate.is_some());
    let beside = [clocks[0], clocks[1], rate, ("interpolate", join.interpolate)];
    for (key, _) in beside.iter().filter(|(_, stated)| *stated && !by_time) {
        problems.0.push(error!("key-of-other-join", key, by = "time").at(campaign.key_place(&["join", key])));
    }
    if join.tolerance_s.is_some_and(|t| t < 0.0) {
        problems.0.push(error!("key-negative", key = "tolerance_s").at(campaign.key_place(&["join", "tolerance_s"])));
    }
    for station in file.exports.iter().filter_map(|export| export.station.as_ref()).filter(|_| join.by == JoinBy::Label)
    {
        problems.0.push(error!("station-join-by-label", station = station.get_ref()).at(campaign.place(station)));
    }
    for log in file.logs.iter().filter(|_| !campaign.unread.affects(&["log"])) {
        let column = log.keys().find(|key| key.get_ref() == LABEL);
        match (column, join.by == JoinBy::Label) {
            (None, true) => {
                problems.0.push(error!("join-label-missing", log = log.name).at(campaign.key_place(&["join", "by"])));
            }
            (Some(key), false) => {
                problems.0.push(error!("key-of-other-join", key = LABEL, by = "label").at(campaign.place(key)));
            }
            _ => {}
        }
    }
}

/// Reports a pose or target that is given by a key and by a column of one export.
fn stated_twice(campaign: &Campaign, export: &Export, problems: &mut Problems) {
    let stated =
        [("pose", export.pose.is_some(), ColumnRole::Pose), ("target", export.target.is_some(), ColumnRole::Target)];
    for (key, _, _) in
        stated.into_iter().filter(|(_, stated, role)| *stated && export.format.dialect.columns.contains(*role))
    {
        problems.0.push(error!("key-and-column", key).at(campaign.place(&export.file)));
    }
    let in_label = |part: &str| export.label.as_ref().is_some_and(|label| label.get_ref().contains(part));
    let named = [
        ("pose", export.from_name.pose.is_some(), export.pose.is_some(), ColumnRole::Pose),
        ("target", export.from_name.target.is_some(), export.target.is_some(), ColumnRole::Target),
        ("cycle", export.from_name.cycle.is_some(), false, ColumnRole::Cycle),
    ];
    for (key, _, is_key, role) in named.into_iter().filter(|(_, is_named, ..)| *is_named) {
        if is_key || export.format.dialect.columns.contains(role) || in_label(&format!("{{{key}}}")) {
            problems.0.push(error!("key-and-file-name", key).at(campaign.place(&export.file)));
        }
    }
}

/// Checks that the output folder contains no input, and that no link leads to it.
fn output(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    let output = match campaign.written_output() {
        Ok(output) => output,
        Err(more) => return problems.0.extend(more.0),
    };
    let stated = |file: &&Spanned<String>| !file.get_ref().is_empty();
    let named =
        file.inputs().chain([&file.robot]).chain(&file.report.logo).chain(&file.report.templates).filter(stated);
    let backup = campaign.controller_backup().and_then(Result::ok);
    let inputs = named.filter_map(|f| campaign.resolve(f).ok()).chain(backup).chain([campaign.location.clone()]);
    // links are followed; a missing folder is placed below its first existing ancestor
    let place = |path: &Path| {
        let there = path.ancestors().find_map(|above| Some((above, canonical(above)?)));
        there.map(|(above, place)| place.join(path.strip_prefix(above).unwrap_or(path)))
    };
    let folder = place(&output);
    let within =
        |input: &PathBuf| matches!((place(input), &folder), (Some(input), Some(folder)) if input.starts_with(folder));
    if let Some(input) = inputs.into_iter().find(within) {
        let input = input.display().to_string();
        problems.0.push(error!("input-in-output-folder", input).at(campaign.key_place(&["output"])));
    }
}

/// Canonical path of an existing file; the empty path is the current folder.
fn canonical(path: &Path) -> Option<PathBuf> {
    if path.as_os_str().is_empty() { Path::new(".").canonicalize().ok() } else { path.canonicalize().ok() }
}

/// Checks that each feature and the world frame are defined in exactly one way.
pub(super) fn frames(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    for (name, feature) in &file.features {
        let Some((_, labels)) = feature.element() else {
            if campaign.unread.affects(&["feature", name]) {
                continue;
            }
            problems.0.push(error!("feature-element", feature = name).at(campaign.key_place(&["feature", name])));
            continue;
        };
        for (i, label) in labels.iter().enumerate() {
            if labels[..i].iter().any(|l| l.get_ref() == label.get_ref()) {
                let message = error!("feature-label-twice", feature = name, label = label.get_ref());
                problems.0.push(message.at(campaign.place(label)));
            }
        }
    }
    if campaign.unread.affects(&["frame"]) {
        return;
    }
    let Some(world) = file.world() else { return };
    if world.nominal_mm.is_empty() == world.tolerance_mm.is_some() {
        problems.0.push(error!("nominal-without-tolerance").at(campaign.world_place()));
    }
    if world.tolerance_mm.is_some_and(|t| t < 0.0) {
        problems.0.push(error!("key-negative", key = "tolerance_mm").at(campaign.world_place()));
    }
    let ways = [world.plane.is_some(), world.targets.is_some(), world.as_exported];
    if ways.iter().filter(|w| **w).count() != 1 {
        problems.0.push(error!("world-frame-definition").at(campaign.world_place()));
    } else if world.plane.is_some() {
        if world.each.is_some() {
            let message = error!("key-of-other-frame", key = "each", definition = "targets");
            problems.0.push(message.at(campaign.world_place()));
        }
        for ends in world.x_axis.iter().chain(&world.y_axis) {
            let directed = match &ends[..] {
                [one] => file.features.contains_key(one.get_ref()),
                ends => ends.len() == 2,
            };
            if !directed {
                let place = ends.first().map_or_else(|| campaign.world_place(), |end| campaign.place(end));
                problems.0.push(error!("frame-axis-without-direction").at(place));
            }
        }
        let axes = usize::from(world.x_axis.is_some()) + usize::from(world.y_axis.is_some());
        if axes != 1 || world.origin.is_none() || world.towards.is_none() {
            problems.0.push(error!("plane-frame-incomplete").at(campaign.world_place()));
        }
    } else {
        let idle = [("origin", world.origin.is_some()), ("x_axis", world.x_axis.is_some())];
        let idle = idle.into_iter().chain([("y_axis", world.y_axis.is_some()), ("towards", world.towards.is_some())]);
        let idle = idle.chain([("each", world.each.is_some() && world.as_exported)]);
        for (key, _) in idle.filter(|(_, stated)| *stated) {
            let definition = if key == "each" { "targets" } else { "plane" };
            problems.0.push(error!("key-of-other-frame", key, definition).at(campaign.world_place()));
        }
    }
}

/// `true` for a text that begins like a date in ISO 8601: four digits and a hyphen.
fn is_like_date(text: &str) -> bool {
    text.split_once('-').is_some_and(|(year, _)| year.len() == 4 && year.bytes().all(|b| b.is_ascii_digit()))
}

/// Reports dates that the calendar does not have, a robot that was received after its measurements,
/// and a report that was issued before them.
fn dates(campaign: &Campaign, problems: &mut Problems) {
    let mut known = BTreeMap::new();
    for (path, text) in campaign.file.dates() {
        let Some(key) = path.last() else { continue };
        match date(text) {
            Some(date) => drop(known.insert(*key, (date, path))),
            // issue and receipt may be in words
            None if *key == "date" || is_like_date(text) => {
                problems.0.push(error!("date-invalid", key).at(campaign.key_place(path)));
            }
            None => {}
        }
    }
    for [earlier, later] in [["date", "issued"], ["robot_received", "date"]] {
        let (Some((first, _)), Some((second, path))) = (known.get(earlier), known.get(later)) else { continue };
        if second < first {
            let [first, second] = [*first, *second].map(date_text);
            let message = error!("dates-out-of-order", earlier, later, first, second);
            problems.0.push(message.at(campaign.key_place(path)));
        }
    }
}

/// Reports implausible names of files, dates, temperatures and nominal lengths.
pub(super) fn values(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    // a missing key is reported elsewhere
    for name in file.inputs().chain([&file.robot]).filter(|f| f.get_ref().is_empty() && !f.span().is_empty()) {
        problems.0.push(error!("file-name-empty").at(campaign.place(name)));
    }
    dates(campaign, problems);
    if let Some(value) = file.temperature_c.filter(|t| !TEMPERATURES_C.contains(t)) {
        let (least, most) = (*TEMPERATURES_C.start(), *TEMPERATURES_C.end());
        let message = error!("temperature-implausible", value, least, most);
        problems.0.push(message.at(campaign.key_place(&["temperature_c"])));
    }
    let Some(geometric) = &file.geometric else { return };
    if let Some((missing, step)) = geometric.missing().first() {
        problems.0.push(error!("geometric-step-missing", missing, step).at(campaign.key_place(&["geometric"])));
    }
    if let Some(table) = geometric.table.first().filter(|_| !geometric.is_whole() || !campaign.identifies()) {
        problems.0.push(error!("errors-table-incomplete").at(campaign.place(&table.poses)));
    }
    let leads = geometric.lead.iter().map(|lead| (&lead.label, "lead_mm", lead.lead_mm));
    let bars = geometric.scale_bar.iter().map(|bar| (&bar.label, "length_mm", bar.length_mm));
    for (label, key, _) in leads.chain(bars).filter(|(_, _, value)| *value <= 0.0) {
        problems.0.push(error!("key-not-positive", key).at(campaign.place(label)));
    }
}

/// Plausible coefficients of thermal expansion (1/°C); a value outside is in another unit.
const PER_C: std::ops::RangeInclusive<f64> = 0.0..=2e-4;

/// Checks uncertainties common to all readings, and uncertainties of range and angle.
fn common_errors(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    let mut wrong = |path: &[&str], value: f64, range: std::ops::RangeInclusive<f64>, quantity: &str| {
        if !range.contains(&value) {
            let (key, least, most) = (path[path.len() - 1], *range.start(), *range.end());
            let message = error!("key-out-of-range", key, value, least, most).at(campaign.key_place(path));
            problems.0.push(message.hint(phrase!("plausible-value", quantity)));
        }
    };
    let um = || 0.0..=*PLAUSIBLE_EXPANDED_UM.end();
    let factor = 0.1..=10.0;
    if let Some(scale) = file.instrument.expanded_scale_uncertainty_um_per_m {
        wrong(&["instrument", "expanded_scale_uncertainty_um_per_m"], scale, 0.0..=1e3, "scale");
    }
    if let Some(polar) = &file.instrument.polar {
        let path = |key| ["instrument", "polar", key];
        wrong(&path("expanded_range_uncertainty_um"), polar.expanded_range_uncertainty_um, um(), "polar");
        let by_m = |value, key| (path(key), value, 0.0..=1e4);
        for (path, value, range) in [
            by_m(polar.expanded_range_uncertainty_um_per_m, "expanded_range_uncertainty_um_per_m"),
            by_m(polar.expanded_angle_uncertainty_um_per_m, "expanded_angle_uncertainty_um_per_m"),
        ] {
            wrong(&path, value, range, "polar");
        }
    }
    if let Some(expansion) = &file.expansion {
        let path = |key| ["expansion", key];
        wrong(&path("robot_per_c"), expansion.robot_per_c, PER_C, "expansion");
        wrong(&path("part_per_c"), expansion.part_per_c, PER_C, "expansion");
        let key = "expanded_temperature_uncertainty_c";
        wrong(&path(key), expansion.expanded_temperature_uncertainty_c, 0.0..=50.0, "temperature");
        wrong(&path("coverage_factor"), expansion.coverage_factor, factor.clone(), "coverage");
    }
    if let Some(homing) = &file.homing {
        let path = |key| ["homing", key];
        wrong(&path("coverage_factor"), homing.coverage_factor, factor, "coverage");
        wrong(&path("expanded_uncertainty_um"), homing.expanded_uncertainty_um.unwrap_or(0.0), um(), "homing");
        wrong(&path("expanded_uncertainty_deg"), homing.expanded_uncertainty_deg.unwrap_or(0.0), 0.0..=5.0, "homing");
        let Ok(robot) = campaign.build_robot() else { return };
        for joint in robot.joints() {
            let (key, stated) = match joint.quantity {
                Quantity::Angle => ("expanded_uncertainty_deg", homing.expanded_uncertainty_deg),
                _ => ("expanded_uncertainty_um", homing.expanded_uncertainty_um),
            };
            if stated.is_none() {
                let message = error!("homing-incomplete", key, joint = joint.name, unit = joint.quantity.unit());
                return problems.0.push(message.at(campaign.key_place(&["homing"])));
            }
        }
    }
}

/// Reports uncertainties that the campaign does not use.
fn without_use(campaign: &Campaign, problems: &mut Problems) {
    let file = &campaign.file;
    if file.instrument.polar.is_some() && !file.observations.is_empty() {
        problems.0.push(error!("polar-with-observations").at(campaign.key_place(&["instrument", "polar"])));
    }
    for (section, stated) in [("expansion", file.expansion.is_some()), ("homing", file.homing.is_some())] {
        if stated && !campaign.identifies() {
            problems.0.push(error!("section-without-identify", section).at(campaign.key_place(&[section])));
        }
    }
}

/// Checks the numbers of `[conditions]`.
pub(super) fn conditions(campaign: &Campaign, problems: &mut Problems) {
    let conditions = &campaign.file.conditions;
    let mut wrong = |key: &str, message: Message| problems.0.push(message.at(campaign.key_place(&["conditions", key])));
    for (key, value) in conditions.positive() {
        if value <= 0.0 {
            wrong(key, error!("key-not-positive", key));
        } else if key == "humidity_percent" && value > 100.0 {
            wrong(key, error!("key-above-maximum", key, most = 100));
        }
    }
    for (key, value) in conditions.not_negative() {
        if value < 0.0 {
            wrong(key, error!("key-negative", key));
        }
    }
}
