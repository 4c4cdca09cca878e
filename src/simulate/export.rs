//! An export in the format that the campaign states.

use super::{Scene, Truth, Turn, geometric, repeatability, text};
use crate::campaign::{Dialect, Export, Format, Role};
use crate::import;
use crate::message::{Message, Result};
use crate::noise::Noise;
use crate::pose::Vector;

/// One row, in the unit of the export.
struct Row {
    label: String,
    target: String,
    /// The measurement; of a point that does not move, the one with the number of the repeat.
    turn: Turn,
    /// A target of the robot, and no fixed point.
    moves: bool,
    xyz: Vector,
}

/// The text of an export; an error where import would not read back what is meant.
pub(super) fn write(scene: &Scene, export: &Export, stream: u64) -> Result<String> {
    let rows = rows(scene, export, stream)?;
    let file = export.file.get_ref();
    let place = || scene.campaign.place(&export.file);
    if rows.is_empty() {
        return Err(Message::error(format!("nothing in the truth goes to the export `{file}`"))
            .at(place())
            .hint("add a [[point]] with this `export`, or `label` or `target` to the export in the campaign")
            .into());
    }
    let decimals = scene.truth.decimals;
    let written = match &export.format {
        Format::Polyworks => rows.iter().map(|row| polyworks_line(row, decimals)).collect(),
        other @ (Format::Qif | Format::Own(..)) => {
            let message = Message::error(format!("simulate writes no {other}")).at(place());
            return Err(message.hint("state `polyworks` or a delimited format for this export").into());
        }
        Format::Delimited(dialect) => {
            let offset_s = scene.campaign.file.join.stated_offset_s().unwrap_or(0.0);
            delimited(&rows, export, dialect, scene.truth, offset_s).map_err(|m| m.at(place()))?
        }
    };
    let read = import::points_of(scene.campaign, export, &written)?;
    let wrong = |what: String| {
        Message::error(format!("`{file}` would not be read as it is meant: {what}")).at(place()).hint(
            "name target, pose and cycle in `label` or `columns`; `pose = \"row\"` is for one target a file; without a \
             cycle, `cycles = 1` in the truth",
        )
    };
    if read.len() != rows.len() {
        return Err(wrong(format!("{} of {} rows", read.len(), rows.len())).into());
    }
    for (row, point) in rows.iter().zip(&read) {
        if !is_meant(row, point) {
            let Turn { pose, cycle, .. } = row.turn;
            let named = format!("target {:?}, pose {:?}, cycle {:?}", point.target, point.pose, point.cycle);
            let meant = format!("`{}`, pose {pose}, cycle {cycle}", row.target);
            return Err(wrong(format!("line {} is {meant}, and says {named}", point.line)).into());
        }
    }
    Ok(written)
}

/// What was measured: fixed points first, then the targets at every pose.
fn rows(scene: &Scene, export: &Export, stream: u64) -> Result<Vec<Row>> {
    let (truth, instrument) = (scene.truth, &scene.campaign.file.instrument);
    let sigma_mm = truth.noise_um.map_or(instrument.standard_uncertainty_mm(), |um| um / 1000.0);
    let mut noise = Noise::new(truth.seed, stream);
    let mut measure =
        |p: Vector| scene.export_T_world.apply(p).map(|v| (v + noise.gaussian(sigma_mm)) / export.unit.in_mm());
    let mut rows = Vec::new();
    for point in truth.points.iter().filter(|p| p.export == *export.file.get_ref()) {
        for repeat in 1..=point.repeats {
            rows.push(Row {
                label: point.label.clone(),
                target: point.label.clone(),
                turn: scene.turn(repeat as i64),
                moves: false,
                xyz: measure(point.at_mm),
            });
        }
    }
    let labelled = geometric::points(scene, export, &mut measure).into_iter();
    for (label, xyz) in labelled.chain(repeatability::points(scene, export, &mut measure)?) {
        rows.push(Row { target: label.clone(), label, turn: scene.turn(1), moves: false, xyz });
    }
    let names_target = matches!(&export.format, Format::Delimited(d) if d.columns.contains(&Role::Target));
    if export.label.is_none() && export.target.is_none() && !names_target {
        return Ok(rows);
    }
    let pattern = export.label.as_ref().map_or("{target}_{pose}_{cycle}", |label| label.get_ref());
    for turn in scene.turns(truth.cycles) {
        for (k, target) in scene.robot.targets().iter().enumerate() {
            if export.target.as_ref().is_some_and(|only| only != target) {
                continue;
            }
            let label = pattern.replace("{pose}", &turn.pose.to_string()).replace("{cycle}", &turn.cycle.to_string());
            rows.push(Row {
                label: label.replace("{target}", target),
                target: target.clone(),
                turn,
                moves: true,
                xyz: measure(scene.target(turn, k)),
            });
        }
    }
    Ok(rows)
}

/// Whether `point` says of the row what a join or a feature needs.
fn is_meant(row: &Row, point: &import::Point) -> bool {
    let target = point.target.as_deref() == Some(row.target.as_str());
    let label = point.label == row.label;
    if !row.moves {
        return target || label && point.target.is_none();
    }
    // without a cycle, numbers of rows and times go on from one round to the next
    let told = match point.pose {
        Some(pose) if pose == row.turn.pose && point.cycle == Some(row.turn.cycle) => true,
        Some(pose) => pose == row.turn.number && point.row == pose,
        None => point.time_s.is_some(),
    };
    target && told
}

fn polyworks_line(row: &Row, decimals: usize) -> String {
    let [x, y, z] = row.xyz;
    format!("{} {x:.decimals$} {y:.decimals$} {z:.decimals$}\n", text::blank(&row.label, false))
}

/// Header rows, the last of which names the columns, and the data.
fn delimited(
    rows: &[Row],
    export: &Export,
    dialect: &Dialect,
    truth: &Truth,
    offset_s: f64,
) -> std::result::Result<String, Message> {
    let decimals = truth.decimals;
    let line = |field: &mut dyn FnMut(&Role) -> String| {
        let fields: Vec<String> = dialect.columns.iter().map(field).collect();
        text::line(&fields, dialect.delimiter, dialect.comment.as_deref())
    };
    let mut all = String::new();
    if let Some(mark) = &dialect.comment {
        // as SpatialAnalyzer heads its ASCII points
        let headings: Vec<&str> = dialect.columns.iter().map(|role| heading(*role)).collect();
        all += &format!("{mark} AXES = CARTESIAN: X,  Y,  Z ({})\n", export.unit.name());
        all += &format!("{mark} {}\n\n", headings.join(",  "));
    }
    for remaining in (0..dialect.header).rev() {
        all += &line(&mut |role| if remaining == 0 { heading(*role).to_owned() } else { "simulated".to_owned() })?;
    }
    let number = |value, digits| text::number(value, digits, dialect.decimal);
    for row in rows {
        let mut skipped = truth.skipped.iter();
        let mut skip = || skipped.next().map_or("-", String::as_str).to_owned();
        all += &line(&mut |role| match role {
            Role::Label => row.label.clone(),
            Role::Target => row.target.clone(),
            Role::Pose => row.turn.pose.to_string(),
            Role::Cycle => row.turn.cycle.to_string(),
            Role::X => number(row.xyz[0], decimals),
            Role::Y => number(row.xyz[1], decimals),
            Role::Z => number(row.xyz[2], decimals),
            Role::TimeS => number(row.turn.time_s() + offset_s, 6),
            Role::Skip => skip(),
        })?;
    }
    Ok(all)
}

/// What the header calls a column.
fn heading(role: Role) -> &'static str {
    match role {
        Role::Label => "label",
        Role::Target => "target",
        Role::Pose => "pose",
        Role::Cycle => "cycle",
        Role::X => "x",
        Role::Y => "y",
        Role::Z => "z",
        Role::TimeS => "time_s",
        Role::Skip => "-",
    }
}
