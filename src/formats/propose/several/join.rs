//! Lines of the join of points and log, and of the world frame.

use super::keys::{Join, Keys};
use super::part::Part;
use crate::propose::labels::MOST_TARGETS;
use crate::propose::meaning::Meaning;
use crate::propose::motion::Meeting;
use crate::propose::statements::{Line, Lines};
use etalon_base::phrase;
use etalon_documents::FormatsJoin;
use etalon_robots::Robot;
use std::fmt::Write;

/// Minimum number of rows of a recorded motion per measured point.
const MORE: usize = 5;

/// Returns the relation of the times of the points to the recording; `None` without times.
pub(super) fn meeting(parts: &[Part], exports: &[usize], log: usize, targets: usize) -> Option<Meeting> {
    let motion = parts[log].motion();
    let motion = match motion {
        Some(motion) => motion,
        // rows without some joints, of a recording that is long enough
        None if !exports.is_empty() && exports.iter().all(|at| stands(&parts[*at], &parts[log])) => {
            return Some(Meeting::Standstills { count: 0, at_least_s: 1.0 });
        }
        None => return None,
    };
    let times: Vec<Vec<f64>> = exports.iter().map(|at| parts[*at].times_s()).collect::<Option<_>>()?;
    let mut times = times.concat();
    times.sort_by(f64::total_cmp);
    let long = || exports.iter().all(|at| stands(&parts[*at], &parts[log]));
    match motion.meeting(&times, targets) {
        _ if times.is_empty() => None,
        // the campaign shows how many standstills are missing
        Meeting::Open { standstills } if long() => Some(Meeting::Standstills { count: standstills, at_least_s: 1.0 }),
        found => Some(found),
    }
}

/// `true` if the points have times and the log is a recording of a motion with many more rows.
fn stands(export: &Part, log: &Part) -> bool {
    let timed = export.read.as_ref().is_some_and(|(_, found)| {
        [Meaning::Time, Meaning::Clock, Meaning::TimeOfDay].iter().any(|time| found.first(*time).is_some())
    });
    let recorded = log.is_recording_of_messages() || Keys::new(log).times.is_some();
    timed && recorded && log.document.rows > MORE * export.document.rows
}

/// Lines of a join of points and log by the relation of their times; `None` if the times show none.
pub(super) fn join_by_clock(meeting: &Meeting, parts: &mut [Part], log: usize, targets: &[String]) -> Option<Lines> {
    let clock = match *meeting {
        Meeting::Open { .. } => return None,
        Meeting::Rows { offset_s, spread_s } => format!(
            "clock_offset_s = {offset_s:.4}   # each point has one row at this offset, within {spread_s:.4} s\n\
             tolerance_s = {:.3}\n",
            (2.0 * spread_s).max(0.01)
        ),
        Meeting::Moving { step_s } => format!(
            "clock_offset_s = \"motion\"   # the offset at which measured and computed speeds agree; 0 if both have one clock\n\
             interpolate = true          # the robot does not stand still\n\
             tolerance_s = {:.3}\n",
            (2.0 * step_s).max(0.01)
        ),
        Meeting::Standstills { at_least_s, .. } => {
            parts[log].lines.push(Line::Text(format!(
                "# the robot stands still at each point for so long, and no joint moves by more; within_mm for prismatic joints\n\
                 standstill = {{ at_least_s = {at_least_s:?}, within_deg = 0.02 }}\n"
            )));
            "clock_offset_s = \"standstills\"   # the offset at which every point falls into a standstill\n\
             tolerance_s = 0.05          # a point may be so far outside of its standstill\n"
                .to_owned()
        }
    };
    if !matches!(meeting, Meeting::Rows { .. }) {
        // a point belongs to the row at its time: several targets share one pose
        for part in parts.iter_mut().filter(|part| part.document.kind == "export") {
            part.lines.remove(&Line::PoseByRow);
        }
    }
    Some(Lines::section("join").with_text(format!("by = \"time\"\n{clock}targets = {targets:?}\n")))
}

/// Lines of a join by keys; `standstills` is the number of standstills of a recording whose times
/// show no relation.
pub(super) fn join_by_keys(
    parts: &mut [Part],
    log: usize,
    joined: &[(usize, Join)],
    targets: &[String],
    standstills: Option<usize>,
) -> Lines {
    let log_file = parts[log].document.file.clone();
    let log_rows = parts[log].document.rows;
    let mut lines = Lines::section("join");
    let by = joined.first().map(|(_, join)| join.by);
    for (at, join) in joined {
        let stated =
            FormatsJoin { log: log_file.clone(), by: join.by.to_owned(), keys: join.keys, matching: join.matching };
        let file = parts[*at].document.file.clone();
        let text =
            phrase!("files-join", file, log = &*log_file, by = join.by, keys = join.keys, matching = join.matching);
        lines.push(Line::Remark(text.to_string()));
        parts[*at].document.join = Some(stated);
    }
    match by {
        Some(by) if joined.iter().all(|(_, join)| join.by == by) => {
            let value = match by {
                "pose" => "[\"pose\"]".to_owned(),
                "pose, cycle" => "[\"pose\", \"cycle\"]".to_owned(),
                other => format!("\"{other}\""),
            };
            lines.push(Line::Text(format!("by = {value}\n")));
            if by == "time" {
                lines = lines.with_text(
                    "clock_offset_s = \"?\"      # time of the measurement minus time of the log, a number without quotes; \
                        or \"motion\", if both recorded one motion\n\
                        tolerance_s = \"?\"         # a number without quotes\n",
                );
            }
        }
        _ => {
            lines.push(Line::doubt(&phrase!("files-not-joined", log = &*log_file, rows = log_rows)));
            for part in parts.iter().filter(|part| part.document.kind == "export") {
                let (file, rows) = (part.document.file.clone(), part.document.rows);
                let count = rows / log_rows.max(1);
                if rows == count * log_rows && (2..=MOST_TARGETS).contains(&count) {
                    let doubt = phrase!("rows-of-several-targets", file, rows, count, poses = log_rows);
                    lines.push(Line::doubt(&doubt));
                }
            }
            if let Some(standstills) = standstills {
                lines.push(Line::doubt(&phrase!("recording-not-joined", log = &*log_file, standstills)));
            }
            lines = lines.with_text(
                "by = \"?\"                 # [\"pose\"], [\"pose\", \"cycle\"], \"label\", \"time\" or \"row\"\n",
            );
        }
    }
    lines.with_text(format!("targets = {targets:?}\n"))
}

/// World frame of a robot whose base is identified.
const AS_EXPORTED: &str =
    "as_exported = true          # the base is found in the frame of the instrument; or targets that stay\n";

/// World frame of a robot whose model has the frame of the base.
const OWN_FRAME: &str = "as_exported = \"?\"           # true if the instrument measured in the frame of this robot model; \
     otherwise define that frame from points: plane, origin, x_axis or y_axis\n";

/// Lines of the world frame: a question if the model of the robot has no place of its base.
/// `stationary` are the names of points that do not move.
pub fn world_lines(robot: Option<&dyn Robot>, stationary: &[String]) -> String {
    let is_free = robot.is_none_or(|robot| robot.free_base().is_some() || !robot.branches().is_empty());
    let mut lines = format!("\n[frame.world]\n{}", if is_free { AS_EXPORTED } else { OWN_FRAME });
    if stationary.len() > 2 {
        // three points define a frame, and nobody but the user knows in which order
        let _ = match is_free {
            true => {
                writeln!(lines, "# targets = {stationary:?}   # in place of as_exported: a world from these points")
            }
            false => writeln!(lines, "# points for such a frame: {stationary:?}"),
        };
    }
    lines
}
