//! Recorded motions and commanded paths from tables.

use crate::table::{TIME, Table};
use crate::tables::coordinates::{Coordinates, CoordinatesOf, like};
use etalon_base::message::{Place, Result};
use etalon_base::{error, phrase};
use etalon_standards::iso9283::motion::stream::{Recording, Stream, Unusable};
use etalon_standards::iso9283::path::commanded::CommandedPath;
use etalon_standards::iso9283::pose::test::CommandedPose;

/// Largest share of implausible samples; above it the rate, the unit or the time stamps are wrong.
const MOST_LEFT_OUT: f64 = 0.01;

/// Builds a recording from a table `time_s,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`. With a stated
/// rate, times follow from the sample numbers; `time_s` is not read.
pub fn recording(table: &Table, rate_hz: Option<f64>) -> Result<Recording> {
    let Coordinates { positions_mm, angles_rad, spatial, angles } = table.coordinates()?;
    let n = positions_mm.len();
    let time_s = match rate_hz {
        Some(rate) if rate > 0.0 && rate.is_finite() => (0..n).map(|i| i as f64 / rate).collect(),
        Some(_) => return Err(error!("key-not-positive", key = "rate_hz").into()),
        None => table.numbers(TIME).unwrap_or_default(),
    };
    if time_s.iter().all(|t| t.is_nan()) {
        return Err(error!("recording-time-missing").at(Place::file(table.file())).into());
    }
    let unusable = |Unusable { sample, message, is_late }| {
        let message = message.at(table.place(sample));
        if is_late { message.hint(phrase!("state-sampling-rate")) } else { message }
    };
    let stream = Stream::new(time_s, positions_mm, &angles_rad).map_err(unusable)?;
    let (stream, jumps) = stream.without_jumps();
    if jumps.len() as f64 > MOST_LEFT_OUT * n as f64 {
        let message = error!("recording-implausible", count = jumps.len(), samples = n);
        return Err(message.at(table.place(jumps[0])).into());
    }
    let left_out = jumps.iter().filter_map(|&i| table.line(i)).collect();
    Ok(Recording { stream, spatial, angles, left_out })
}

/// Builds a commanded path from a table with the coordinates of a recording, one point per row.
pub fn commanded_path(table: &Table, recorded: &str, recording: &Recording) -> Result<CommandedPath> {
    let all = table.coordinates()?;
    like(
        CoordinatesOf { file: table.file(), spatial: all.spatial, angles: &all.angles },
        CoordinatesOf { file: recorded, spatial: recording.spatial, angles: &recording.angles },
    )?;
    CommandedPath::new(all.positions_mm, &all.angles_rad).map_err(|p| table.in_file(p))
}

/// Returns names and positions of commanded poses.
pub fn commanded_poses(table: &Table) -> Result<Vec<CommandedPose>> {
    let poses = table.pose_names()?;
    let positions_mm = table.coordinates()?.positions_mm;
    if let Some(i) = (0..poses.len()).find(|&i| poses[..i].contains(&poses[i])) {
        return Err(error!("pose-commanded-twice", pose = poses[i].to_string()).at(table.place(i)).into());
    }
    Ok(poses.into_iter().zip(positions_mm).map(|(pose, position_mm)| CommandedPose { pose, position_mm }).collect())
}
