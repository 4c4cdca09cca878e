//! An export in the format that the campaign states.

use super::{Scene, Truth, Turn, geometric, own, repeatability, text};
use crate::base::message::{Message, Result};
use crate::base::noise::Noise;
use crate::base::pose::Vector;
use crate::import;
use crate::import::format::ColumnAt;
use crate::import::format::Columns;
use crate::import::format::Dialect;
use crate::import::format::Encoding;
use crate::import::format::Export;
use crate::import::format::Format;
use crate::import::format::Header;
use crate::import::format::Role;
use crate::stages::gather;

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
    if export.encoding.is_some_and(|encoding| encoding != Encoding::Utf8) {
        let message = Message::error("simulate writes UTF-8").at(place());
        return Err(message.hint("leave out `encoding` of this export").into());
    }
    let written = match &export.format {
        Format::Polyworks => rows.iter().map(|row| polyworks_line(row, decimals)).collect(),
        Format::Own(reader, decimal) => {
            let labelled: Vec<(&str, Vector)> = rows.iter().map(|row| (row.label.as_str(), row.xyz)).collect();
            own::write(*reader, *decimal, export.unit, decimals, &labelled).map_err(|m| m.at(place()))?
        }
        Format::Qif => {
            let message = Message::error("simulate writes no QIF").at(place());
            return Err(message.hint("state `polyworks` or a delimited format for this export").into());
        }
        Format::SpatialAnalyzer => spatialanalyzer(&rows, export.unit.name(), decimals),
        Format::Delimited(dialect) => {
            let offset_s = scene.campaign.file.join.as_ref().and_then(|join| join.stated_offset_s()).unwrap_or(0.0);
            delimited(&rows, export, dialect, scene.truth, offset_s).map_err(|m| m.at(place()))?
        }
    };
    let read = gather::points_of(scene.campaign, export, &written)?;
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
    let names_target = matches!(&export.format, Format::Delimited(d) if d.columns.contains(Role::Target));
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

/// As SpatialAnalyzer writes it; label parts between `::` are collection and group.
fn spatialanalyzer(rows: &[Row], unit: &str, decimals: usize) -> String {
    let head = format!("// AXES = CARTESIAN: X,  Y,  Z ({unit})\n");
    let line = |row: &Row| {
        let [x, y, z] = row.xyz;
        format!("{},  {x:.decimals$},  {y:.decimals$},  {z:.decimals$}\n", row.label.replace("::", ",  "))
    };
    head + &rows.iter().map(line).collect::<String>()
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
    let columns = columns(&dialect.columns)?;
    let delimiter = dialect.delimiter.ok_or_else(|| {
        Message::error("simulate writes neither fixed widths nor workbooks").hint("state a `delimiter` for this export")
    })?;
    if !dialect.types.is_empty() {
        return Err(Message::error("simulate writes no coordinates whose kind each row says"));
    }
    let line = |field: &mut dyn FnMut(&Role, &str) -> String| {
        let fields: Vec<String> = columns.iter().map(|(role, name)| field(role, name)).collect();
        text::line(&fields, delimiter, dialect.comment.as_deref())
    };
    let mut all = String::new();
    if let Some(mark) = &dialect.comment {
        // as SpatialAnalyzer heads its ASCII points
        let headings: Vec<&str> = columns.iter().map(|(_, name)| name.as_str()).collect();
        all += &format!("{mark} AXES = CARTESIAN: X,  Y,  Z ({})\n", export.unit.name());
        all += &format!("{mark} {}\n\n", headings.join(",  "));
    }
    let header = if let Header::Rows(rows) = dialect.header { rows } else { 1 };
    for remaining in (0..header).rev() {
        all += &line(&mut |_, name| if remaining == 0 { name.to_owned() } else { "simulated".to_owned() })?;
    }
    let number = |value, digits| text::number(value, digits, dialect.decimal);
    let in_unit = |rad: f64| rad / dialect.angle_unit.map_or(1.0, |unit| unit.in_rad());
    for row in rows {
        let mut skipped = truth.skipped.iter();
        let mut skip = || skipped.next().map_or("-", String::as_str).to_owned();
        let [x, y, z] = row.xyz;
        // an angle needs more digits than a length
        let angle = |rad: f64| number(in_unit(rad), decimals + 6);
        all += &line(&mut |role, _| match role {
            Role::Label => row.label.clone(),
            Role::Target => row.target.clone(),
            Role::Pose => row.turn.pose.to_string(),
            Role::Cycle => row.turn.cycle.to_string(),
            Role::X => number(x, decimals),
            Role::Y => number(y, decimals),
            Role::Z => number(z, decimals),
            Role::Radius => number(x.hypot(y), decimals),
            Role::Distance => number(x.hypot(y).hypot(z), decimals),
            Role::Azimuth => angle(y.atan2(x)),
            Role::AzimuthClockwise => angle(-y.atan2(x)),
            Role::Zenith => angle(x.hypot(y).atan2(z)),
            Role::Elevation => angle(z.atan2(x.hypot(y))),
            Role::I | Role::J => number(0.0, decimals),
            Role::K => number(1.0, decimals),
            Role::TimeS => number(row.turn.time_s() + offset_s, 6),
            _ => skip(),
        })?;
    }
    all += &dialect.end.iter().map(|end| format!("{end}\n")).collect::<String>();
    Ok(all)
}

/// What each column holds, and what the header calls it.
fn columns(stated: &Columns) -> std::result::Result<Vec<(Role, String)>, Message> {
    match stated {
        Columns::InOrder(roles) => Ok(roles.iter().map(|role| (*role, role.name().to_owned())).collect()),
        Columns::Named(named) => {
            let name = |(role, column): &(Role, ColumnAt)| match column {
                ColumnAt::Name(name) => Ok((*role, name.clone())),
                ColumnAt::Number(_) => Err(Message::error("simulate writes no columns that only a number names")),
            };
            named.iter().map(name).collect()
        }
    }
}
