//! Simulated export in the format that the campaign contains.

use super::{Scene, Turn, geometric, repeatability};
use crate::stages::gather;
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_formats::Export;
use etalon_formats::dialect::ColumnRole;
use etalon_formats::exports::ExportRow;
use etalon_tables::Encoding;

/// One row, in the unit of the export.
struct SimulatedRow {
    label: String,
    target: String,
    /// Measurement; for a stationary point, the measurement with the number of the repeat.
    turn: Turn,
    /// `true` for a target of the robot, `false` for a fixed point.
    moves: bool,
    xyz: Vector,
}

impl SimulatedRow {
    fn written(&self, scene: &Scene) -> ExportRow {
        let offset_s = scene.campaign.file.join.as_ref().and_then(|join| join.stated_offset_s()).unwrap_or(0.0);
        let Turn { pose, cycle, .. } = self.turn;
        let time_s = self.turn.time_s() + offset_s;
        ExportRow {
            label: self.label.clone(),
            target: self.target.clone(),
            pose: pose.into(),
            cycle,
            time_s,
            xyz: self.xyz,
        }
    }
}

/// Text of an export; an error if its import does not give the simulated points.
pub(super) fn write(scene: &Scene, export: &Export, stream: u64) -> Result<String> {
    let rows = rows(scene, export, stream)?;
    let file = export.file.get_ref();
    let place = || scene.campaign.place(&export.file);
    if rows.is_empty() {
        return Err(error!("export-without-points", file).at(place()).into());
    }
    let decimals = scene.truth.decimals;
    if export.encoding.is_some_and(|encoding| encoding != Encoding::Utf8) {
        return Err(error!("simulate-utf8").at(place()).into());
    }
    let written: Vec<ExportRow> = rows.iter().map(|row| row.written(scene)).collect();
    let skipped = &scene.truth.skipped;
    let written = export.format.write(&written, export.unit, decimals, skipped);
    let written = written.map_err(|reason| reason.into_message().at(place()))?;
    let read = gather::parse_points(scene.campaign, export, &written)?;
    if read.len() != rows.len() {
        let message = error!("simulated-rows-lost", file, read = read.len(), rows = rows.len());
        return Err(message.at(place()).into());
    }
    for (row, point) in rows.iter().zip(&read) {
        if !is_meant(row, point) {
            let Turn { pose, cycle, .. } = row.turn;
            let meant = phrase!("measurement-name", target = row.target, pose, cycle);
            let shown = |value: Option<String>| value.unwrap_or_else(|| "-".to_owned());
            let target = shown(point.target.as_ref().map(ToString::to_string));
            let found = [shown(point.pose.map(|p| p.to_string())), shown(point.cycle.map(|c| c.to_string()))];
            let read = phrase!("measurement-name", target, pose = found[0], cycle = found[1]);
            return Err(error!("simulated-row-misread", file, line = point.line, meant, read).at(place()).into());
        }
    }
    Ok(written)
}

/// Measured points: fixed points first, then the targets at every pose.
fn rows(scene: &Scene, export: &Export, stream: u64) -> Result<Vec<SimulatedRow>> {
    let (truth, instrument) = (scene.truth, &scene.campaign.file.instrument);
    let sigma_mm = truth.noise_um.map_or(instrument.standard_uncertainty_mm(), |um| um / 1000.0);
    let mut noise = Noise::new(truth.seed, stream);
    let mut measure =
        |p: Vector| scene.export_T_world.apply(p).map(|v| (v + noise.gaussian(sigma_mm)) / export.unit.in_mm());
    let mut rows = Vec::new();
    for point in truth.points.iter().filter(|p| p.export == *export.file.get_ref()) {
        for repeat in 1..=point.repeats {
            rows.push(SimulatedRow {
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
        rows.push(SimulatedRow { target: label.clone(), label, turn: scene.turn(1), moves: false, xyz });
    }
    let names_target = export.format.dialect.columns.contains(ColumnRole::Target);
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
            rows.push(SimulatedRow {
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

/// `true` if `point` agrees with the row in everything that a join or a feature needs.
fn is_meant(row: &SimulatedRow, point: &etalon_formats::Point) -> bool {
    let target = point.target.as_deref() == Some(row.target.as_str());
    let label = *point.label == *row.label;
    if !row.moves {
        return target || label && point.target.is_none();
    }
    // without a cycle, numbers of rows and times continue from one round to the next
    let told = match point.pose {
        Some(pose) if pose == row.turn.pose && point.cycle == Some(row.turn.cycle) => true,
        Some(pose) => pose == row.turn.number && pose == i64::from(point.row),
        None => point.time_s.is_some(),
    };
    target && told
}
