//! Tables of attained and commanded poses, checked and grouped by pose.

use crate::table::Table;
use crate::tables::coordinates::{Coordinates, CoordinatesOf, like};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_standards::iso9283::pose::approach::{CameFrom, came_from};
use etalon_standards::iso9283::pose::rotations::RotationOrder;
use etalon_standards::iso9283::pose::test::{AttainedPose, PoseTest, TestedPose, from_pose};
use std::collections::{BTreeMap, BTreeSet};

/// Poses and coordinates of one table.
struct Rows {
    poses: Vec<PoseName>,
    positions_mm: Vec<Vector>,
    angles_rad: Vec<Vec<f64>>,
    spatial: bool,
    angles: Vec<usize>,
}

/// Builds a test of poses from a table of attained poses and a table of commanded poses.
///
/// Columns of attained poses: `pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`, optionally
/// `approach`, `robot` and `reading`; commanded poses have no cycle. Rows of one visit with a
/// `reading` are averaged. Without commanded poses only repeatability is evaluated. The order of
/// the rotations a, b, c is `None` if it is not given.
pub fn pose_test(
    attained: &Table,
    commanded: Option<&Table>,
    rotation_order: Option<RotationOrder>,
) -> Result<PoseTest> {
    let mut problems = Problems::default();
    let mut read = |table: &Table, needed: &'static [&'static str]| {
        let needed = needed.iter().copied().chain(table.coordinate_columns());
        problems.keep(table.require(needed).map_err(|p| table.in_file(p)).and_then(|()| rows(table)))
    };
    let a = read(attained, &["pose", "cycle"]);
    let c = commanded.map(|table| (table, read(table, &["pose"])));
    let (Some(a), Some(c)) = (a, c.map_or(Some(None), |(table, c)| Some(Some((table, c?))))) else {
        return Err(problems);
    };
    let Attained { visits, unknown } = attained_poses(attained, &a)?;
    let mut poses: Vec<TestedPose> = Vec::new();
    if let Some((commanded, c)) = &c {
        like(
            CoordinatesOf { file: commanded.file(), spatial: c.spatial, angles: &c.angles },
            CoordinatesOf { file: attained.file(), spatial: a.spatial, angles: &a.angles },
        )?;
        poses = commanded_poses(commanded, c, &mut problems);
    } else {
        let names: BTreeSet<PoseName> = a.poses.iter().copied().collect();
        let pose = |pose| TestedPose { pose, commanded_mm: None, commanded_rad: Vec::new(), attained: Vec::new() };
        poses.extend(names.into_iter().map(pose));
    }
    let mut seen = BTreeSet::new();
    let cycles: Vec<i64> = visits.iter().map(|visit| visit.cycle).collect();
    let is_repeat = |i: usize, j: &usize| {
        let same = |k: usize| (a.poses[k], cycles[k], a.positions_mm[k], &a.angles_rad[k]);
        same(i) == same(*j)
    };
    let several = attained.has("reading");
    for (i, (visit, pose)) in visits.into_iter().zip(&a.poses).enumerate() {
        let approach = attained.has("approach").then(|| visit.approach.clone());
        let first = seen.insert((*pose, visit.cycle, visit.robot.clone(), approach.clone()));
        let Some(place) = poses.iter_mut().find(|p| p.pose == *pose) else {
            let file = commanded.map_or("", Table::file);
            let message = error!("pose-not-commanded", pose = pose.to_string(), file);
            problems.0.push(message.at(attained.place(i)));
            continue;
        };
        let same = |v: &&mut AttainedPose| {
            (v.cycle, &v.robot) == (visit.cycle, &visit.robot) && approach.as_ref().is_none_or(|a| v.approach == *a)
        };
        match place.attained.iter_mut().find(same) {
            Some(before) if several => before.read_again(&visit),
            _ if !first => {
                let message = error!("pose-attained-twice", pose = pose.to_string(), cycle = visit.cycle);
                let line = (0..i).find(|j| is_repeat(i, j)).and_then(|first| attained.line(first));
                let message = match line {
                    Some(line) => message.hint(phrase!("row-repeats", line)),
                    None => message,
                };
                problems.0.push(message.at(attained.place(i)));
            }
            _ => place.attained.push(visit),
        }
    }
    // further messages would repeat the first ones
    problems.0.truncate(20);
    let mut warnings = problems.check()?;
    warnings.extend(attained.unread(&["pose", "cycle", "approach", "robot", "reading"]));
    warnings.extend(commanded.and_then(|commanded| commanded.unread(&["pose", "cycle"])));
    warnings.extend(unknown);
    for p in poses.iter().filter(|p| p.attained.is_empty()) {
        warnings.push(warning!("commanded-pose-not-measured", pose = p.pose.to_string()));
    }
    poses.retain(|p| !p.attained.is_empty());
    if poses.is_empty() {
        return Err(error!("no-pose-measured").at(Place::file(attained.file())).into());
    }
    Ok(PoseTest { poses, spatial: a.spatial, angles: a.angles, rotation_order, warnings })
}

/// Commanded poses of a table, each once, in the order of their rows.
fn commanded_poses(table: &Table, rows: &Rows, problems: &mut Problems) -> Vec<TestedPose> {
    let mut poses: Vec<TestedPose> = Vec::new();
    for (i, &pose) in rows.poses.iter().enumerate() {
        let (commanded_mm, commanded_rad) = (Some(rows.positions_mm[i]), rows.angles_rad[i].clone());
        // a table of attained poses repeats the commanded pose in each cycle
        match poses.iter().find(|p| p.pose == pose) {
            Some(before) if before.commanded_mm == commanded_mm && before.commanded_rad == commanded_rad => {
                continue;
            }
            Some(_) => {
                let message = error!("pose-commanded-twice", pose = pose.to_string());
                problems.0.push(message.at(table.place(i)));
            }
            None => {}
        }
        poses.push(TestedPose { pose, commanded_mm, commanded_rad, attained: Vec::new() });
    }
    poses
}

/// Attained poses of all rows, and a warning of visits with unknown approach.
struct Attained {
    visits: Vec<AttainedPose>,
    unknown: Option<Message>,
}

/// Returns the attained pose of each row.
fn attained_poses(table: &Table, rows: &Rows) -> Result<Attained> {
    let cycles = table.integers("cycle").map_err(|p| table.in_file(p))?;
    let approaches = table.has("approach").then(|| table.texts("approach")).transpose()?;
    let robots = table.has("robot").then(|| table.texts("robot")).transpose()?;
    let robot = |i: usize| robots.as_ref().map_or("", |names| names[i].as_ref());
    let before = match approaches {
        Some(_) => Vec::new(),
        None => previous(rows.poses.len(), robot, |i| (cycles[i], rows.poses[i])),
    };
    let unread = before.iter().enumerate().filter(|(_, from)| **from == CameFrom::Unread).map(|(i, _)| i);
    let unknown = unknown(&unread.map(|i| (cycles[i], rows.poses[i])).collect::<Vec<_>>());
    let visit = |i: usize| AttainedPose {
        cycle: cycles[i],
        position_mm: rows.positions_mm[i],
        angles_rad: rows.angles_rad[i].clone(),
        approach: match &approaches {
            Some(names) => Some(names[i].to_string()),
            None => match before[i] {
                CameFrom::Pose(pose) => Some(from_pose(pose)),
                CameFrom::Start | CameFrom::Unread => None,
            },
        },
        robot: robot(i).to_owned(),
        readings_mm: vec![rows.positions_mm[i]],
        readings_rad: vec![rows.angles_rad[i].clone()],
    };
    Ok(Attained { visits: (0..rows.poses.len()).map(visit).collect(), unknown })
}

/// Previous row of each row of a robot.
fn previous<'a>(
    count: usize,
    robot: impl Fn(usize) -> &'a str,
    row: impl Fn(usize) -> (i64, PoseName),
) -> Vec<CameFrom> {
    let mut of_robot: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    (0..count).for_each(|i| of_robot.entry(robot(i)).or_default().push(i));
    let mut before = vec![CameFrom::Start; count];
    for rows in of_robot.values() {
        let visits: Vec<(i64, PoseName)> = rows.iter().map(|&i| row(i)).collect();
        for (&i, from) in rows.iter().zip(came_from(&visits)) {
            before[i] = from;
        }
    }
    before
}

/// Maximum number of visits that a warning names.
const NAMED: usize = 10;

/// Warning of visits whose approach is unknown.
fn unknown(visits: &[(i64, PoseName)]) -> Option<Message> {
    let named = |(cycle, pose): &(i64, PoseName)| phrase!("visit-of-cycle", pose, cycle);
    let shown: Vec<_> = visits.iter().take(NAMED).map(named).collect();
    (!visits.is_empty()).then(|| warning!("approach-unknown", count = visits.len(), visits = shown))
}

fn rows(table: &Table) -> Result<Rows> {
    let poses = table.pose_names()?;
    let Coordinates { positions_mm, angles_rad, spatial, angles } = table.coordinates()?;
    let angles_rad = (0..poses.len()).map(|i| angles_rad.iter().map(|column| column[i]).collect()).collect();
    Ok(Rows { poses, positions_mm, angles_rad, spatial, angles })
}
