//! Tables of attained and commanded poses, checked and grouped by pose.

use crate::tables::coordinates::{Coordinates, CoordinatesOf, NamedTable, like};
use etalon_base::message::{Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, warning};
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
/// `reading` are averaged. Without commanded poses only repeatability is evaluated.
pub fn pose_test(attained: NamedTable, commanded: Option<NamedTable>) -> Result<PoseTest> {
    let mut problems = Problems::default();
    let mut read = |table: NamedTable| problems.keep(rows(table));
    let a = read(attained);
    let c = commanded.map(|table| (table, read(table)));
    let (Some(a), Some(c)) = (a, c.map_or(Some(None), |(table, c)| Some(Some((table, c?))))) else {
        return Err(problems);
    };
    let visits = attained_poses(attained, &a)?;
    let mut poses: Vec<TestedPose> = Vec::new();
    if let Some((commanded, c)) = &c {
        like(
            CoordinatesOf { file: commanded.file, spatial: c.spatial, angles: &c.angles },
            CoordinatesOf { file: attained.file, spatial: a.spatial, angles: &a.angles },
        )?;
        for (i, &pose) in c.poses.iter().enumerate() {
            if poses.iter().any(|p| p.pose == pose) {
                problems.0.push(commanded.at_row(error!("pose-commanded-twice", pose = pose.to_string()), i));
            }
            let (commanded_mm, commanded_rad) = (Some(c.positions_mm[i]), c.angles_rad[i].clone());
            poses.push(TestedPose { pose, commanded_mm, commanded_rad, attained: Vec::new() });
        }
    } else {
        let names: BTreeSet<PoseName> = a.poses.iter().copied().collect();
        let pose = |pose| TestedPose { pose, commanded_mm: None, commanded_rad: Vec::new(), attained: Vec::new() };
        poses.extend(names.into_iter().map(pose));
    }
    let mut seen = BTreeSet::new();
    let several = attained.has("reading");
    for (i, (visit, pose)) in visits.into_iter().zip(&a.poses).enumerate() {
        let approach = attained.has("approach").then(|| visit.approach.clone());
        let first = seen.insert((*pose, visit.cycle, visit.robot.clone(), approach.clone()));
        let Some(place) = poses.iter_mut().find(|p| p.pose == *pose) else {
            let file = commanded.map_or("", |commanded| commanded.file);
            problems.0.push(attained.at_row(error!("pose-not-commanded", pose = pose.to_string(), file), i));
            continue;
        };
        let same = |v: &&mut AttainedPose| {
            (v.cycle, &v.robot) == (visit.cycle, &visit.robot) && approach.as_ref().is_none_or(|a| v.approach == *a)
        };
        match place.attained.iter_mut().find(same) {
            Some(before) if several => before.read_again(&visit),
            _ if !first => {
                let message = error!("pose-attained-twice", pose = pose.to_string(), cycle = visit.cycle);
                problems.0.push(attained.at_row(message, i));
            }
            _ => place.attained.push(visit),
        }
    }
    // further messages would repeat the first ones
    problems.0.truncate(20);
    let mut warnings = problems.check()?;
    warnings.extend(attained.unread(&["pose", "cycle", "approach", "robot", "reading"]));
    warnings.extend(commanded.and_then(|commanded| commanded.unread(&["pose", "cycle"])));
    for p in poses.iter().filter(|p| p.attained.is_empty()) {
        warnings.push(warning!("commanded-pose-not-measured", pose = p.pose.to_string()));
    }
    poses.retain(|p| !p.attained.is_empty());
    if poses.is_empty() {
        return Err(error!("no-pose-measured").at(Place::file(attained.file)).into());
    }
    Ok(PoseTest { poses, spatial: a.spatial, angles: a.angles, warnings })
}

/// Returns the attained pose of each row.
fn attained_poses(table: NamedTable, rows: &Rows) -> Result<Vec<AttainedPose>> {
    let cycles = table.integers("cycle")?;
    let approaches = table.has("approach").then(|| table.texts("approach")).transpose()?;
    let robots = table.has("robot").then(|| table.texts("robot")).transpose()?;
    // previous row of the same robot
    let mut last: BTreeMap<&str, usize> = BTreeMap::new();
    let robot = |i: usize| robots.as_ref().map_or("", |names| names[i].as_str());
    let before: Vec<Option<usize>> = (0..rows.poses.len()).map(|i| last.insert(robot(i), i)).collect();
    let visit = |i: usize| AttainedPose {
        cycle: cycles[i],
        position_mm: rows.positions_mm[i],
        angles_rad: rows.angles_rad[i].clone(),
        approach: match &approaches {
            Some(names) => Some(names[i].clone()),
            None => before[i].map(|before| from_pose(rows.poses[before])),
        },
        robot: robot(i).to_owned(),
        readings_mm: vec![rows.positions_mm[i]],
    };
    Ok((0..rows.poses.len()).map(visit).collect())
}

fn rows(table: NamedTable) -> Result<Rows> {
    let poses = table.poses()?;
    let Coordinates { positions_mm, angles_rad, spatial, angles } = table.coordinates()?;
    let angles_rad = (0..poses.len()).map(|i| angles_rad.iter().map(|column| column[i]).collect()).collect();
    Ok(Rows { poses, positions_mm, angles_rad, spatial, angles })
}
