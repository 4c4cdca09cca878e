//! Recorded motions and commanded paths from tables.

use crate::table::{TIME, Table};
use crate::tables::coordinates::{Coordinates, CoordinatesOf, like};
use etalon_base::message::{Message, Place, Result};
use etalon_base::{error, phrase};
use etalon_standards::iso9283::motion::stream::{Recording, Stream, Unusable};
use etalon_standards::iso9283::path::commanded::CommandedPath;
use etalon_standards::iso9283::pose::test::CommandedPose;

/// Upper limit for the share of implausible samples; a larger share means that rate, unit or time
/// stamps are wrong.
const MOST_LEFT_OUT: f64 = 0.01;

/// Upper limit for the difference between the durations from the rate and from the time stamps, as
/// a share.
const RATE: f64 = 0.05;

/// Returns an error if the duration from the time stamps differs from the number of samples divided
/// by the given rate. The resolution of the stamps is their smallest step.
fn rate_contradicts(table: &Table, rate_hz: f64) -> Option<Message> {
    let stamps: Vec<f64> = table.numbers(TIME).ok()?.into_iter().filter(|time| time.is_finite()).collect();
    let samples = stamps.len();
    let stamped_s = stamps.last()? - stamps.first()?;
    let steps = stamps.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0);
    let resolution = steps.fold(f64::INFINITY, f64::min);
    let by_rate_s = (samples - 1) as f64 / rate_hz;
    let differs = (stamped_s - by_rate_s).abs() > 2.0 * resolution + RATE * by_rate_s;
    (stamped_s > 0.0 && differs).then(|| {
        error!("rate-contradicts-stamps", samples, rate_hz, by_rate_s, stamped_s).at(Place::file(table.file()))
    })
}

/// Checks that time stamps, if there are any, do not decrease: a sampling rate gives the times of
/// rows in the order of recording.
fn in_order(table: &Table) -> Result<()> {
    let stamps = table.numbers(TIME).unwrap_or_default();
    match stamps.windows(2).position(|pair| pair[1] < pair[0]) {
        Some(i) => {
            let message = error!("time-not-increasing", later_s = stamps[i + 1], earlier_s = stamps[i]);
            Err(message.at(table.place(i + 1)).into())
        }
        None => Ok(()),
    }
}

/// Builds a recording from a table `time_s,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`. With a given
/// rate, times follow from the sample numbers; `time_s` may not contradict them.
pub fn recording(table: &Table, rate_hz: Option<f64>) -> Result<Recording> {
    let Coordinates { positions_mm, angles_rad, spatial, angles } = table.coordinates()?;
    let n = positions_mm.len();
    let time_s = match rate_hz {
        Some(rate) if rate > 0.0 && rate.is_finite() => {
            in_order(table)?;
            (0..n).map(|i| i as f64 / rate).collect()
        }
        Some(_) => return Err(error!("key-not-positive", key = "rate_hz").into()),
        None => table.numbers(TIME).unwrap_or_default(),
    };
    if time_s.iter().all(|t| t.is_nan()) {
        return Err(error!("recording-time-missing").at(Place::file(table.file())).into());
    }
    let unusable = |Unusable { sample, message, is_coarse }| {
        let message = message.at(table.place(sample));
        if is_coarse { message.hint(phrase!("state-sampling-rate")) } else { message }
    };
    let stream = Stream::new(time_s, positions_mm, &angles_rad).map_err(unusable)?;
    let (stream, jumps) = stream.without_jumps();
    if jumps.len() as f64 > MOST_LEFT_OUT * n as f64 {
        let message = error!("recording-implausible", count = jumps.len(), samples = n);
        return Err(message.at(table.place(jumps[0])).into());
    }
    if let Some(message) = rate_hz.and_then(|rate| rate_contradicts(table, rate)) {
        return Err(message.into());
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Recording of a motion along x with these time stamps.
    fn read(times_s: [f64; 4], rate_hz: Option<f64>) -> Result<Recording> {
        let rows = times_s.iter().enumerate().map(|(i, time)| format!("{time},{i},0\n")).collect::<String>();
        let table = crate::observations("motion.csv", &format!("time_s,x_mm,y_mm\n{rows}")).unwrap();
        recording(&table, rate_hz)
    }

    #[test]
    fn a_sampling_rate_is_the_remedy_for_coarse_stamps_and_hides_no_order() {
        let full_seconds = [0.0, 0.0, 1.0, 1.0];
        let refused = |times_s, rate_hz| read(times_s, rate_hz).unwrap_err().0.remove(0);
        let coarse = refused(full_seconds, None);
        assert!(coarse.is("time-not-increasing", &[("hint", &phrase!("state-sampling-rate"))]), "{coarse:?}");
        assert_eq!(read(full_seconds, Some(2.0)).unwrap().stream.len(), 4);
        // two blocks of rows exchanged: the rate would make a motion of them
        let exchanged = [0.002, 0.003, 0.0, 0.001];
        for rate_hz in [None, Some(1000.0)] {
            let message = refused(exchanged, rate_hz);
            assert!(message.is("time-not-increasing", &[("later_s", &0.0), ("earlier_s", &0.003)]), "{message:?}");
            assert!(!message.is("time-not-increasing", &[("hint", &phrase!("state-sampling-rate"))]));
            assert_eq!(message.place.unwrap().line, Some(4));
        }
    }
}
