//! Visits of a repeatability test: tables of attained and commanded poses, checked and grouped by pose.

use crate::base::message::{Message, Place, Problems, Result};
use crate::base::pose::{Vector, centroid};
use crate::base::table;
use crate::import::tables::coordinates::{Coordinates, at_row, coordinates, in_file, like, unread};
use crate::iso9283::wrapped;
use polars::prelude::DataFrame;
use std::collections::{BTreeMap, BTreeSet};

/// One visit of one pose, in the order of recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Visit {
    /// Number of the cycle.
    pub cycle: i64,
    /// Attained position; z is zero for planar robots.
    pub position_mm: Vector,
    /// Attained angles, in the order of [`Visits::angles`].
    pub angles_rad: Vec<f64>,
    /// How it was approached: what the column `approach` says, or the pose visited before; `None` for the first row.
    pub approach: Option<String>,
    /// What the column `robot` says.
    pub robot: String,
    /// Readings whose mean the position is; one where it was read once.
    pub readings_mm: Vec<Vector>,
}

/// A commanded pose with its visits.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseVisits {
    /// Number of the pose.
    pub pose: i64,
    /// Commanded position; where there is none, accuracy and distances are not told.
    pub commanded_mm: Option<Vector>,
    /// Commanded angles.
    pub commanded_rad: Vec<f64>,
    /// Its visits, at least one.
    pub visits: Vec<Visit>,
}

/// A whole test.
#[derive(Clone, Debug, PartialEq)]
pub struct Visits {
    /// Commanded poses that were visited, in their order.
    pub poses: Vec<PoseVisits>,
    /// Whether there is a z.
    pub spatial: bool,
    /// Which angles there are: of 0, 1, 2 for a, b, c.
    pub angles: Vec<usize>,
    /// What is odd, but no error.
    pub warnings: Vec<Message>,
}

/// Numbers of one table.
struct Rows {
    poses: Vec<i64>,
    positions_mm: Vec<Vector>,
    angles_rad: Vec<Vec<f64>>,
    spatial: bool,
    angles: Vec<usize>,
}

impl Visits {
    /// From tables `pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg][,approach][,robot][,reading]` and the same without
    /// `cycle`; rows of one visit with a `reading` are averaged. Each with the file's name and, for messages, a column `line`.
    pub fn from_tables(attained: (&str, &DataFrame), commanded: (&str, &DataFrame)) -> Result<Self> {
        let mut problems = Problems::default();
        let mut read = |(file, frame)| rows(file, frame).map_err(|p| problems.0.extend(p.0)).ok();
        let (Some(a), Some(c)) = (read(attained), read(commanded)) else { return Err(problems) };
        like((c.spatial, &c.angles[..]), (a.spatial, &a.angles[..]), (commanded.0, attained.0))?;
        let visits = visits(attained, &a)?;
        let mut poses: Vec<PoseVisits> = Vec::new();
        for (i, &pose) in c.poses.iter().enumerate() {
            if poses.iter().any(|p| p.pose == pose) {
                problems.0.push(at_row(Message::error(format!("pose {pose} is commanded twice")), commanded, i));
            }
            let (commanded_mm, commanded_rad) = (Some(c.positions_mm[i]), c.angles_rad[i].clone());
            poses.push(PoseVisits { pose, commanded_mm, commanded_rad, visits: Vec::new() });
        }
        let mut seen = BTreeSet::new();
        let several = attained.1.column("reading").is_ok();
        for (i, (visit, pose)) in visits.into_iter().zip(&a.poses).enumerate() {
            let approach = explicit(attained.1).then(|| visit.approach.clone());
            let first = seen.insert((*pose, visit.cycle, visit.robot.clone(), approach.clone()));
            let Some(place) = poses.iter_mut().find(|p| p.pose == *pose) else {
                let message = Message::error(format!("pose {pose} is not among the commanded poses"));
                problems.0.push(at_row(message, attained, i).hint(format!("add it to `{}`", commanded.0)));
                continue;
            };
            let same = |v: &&mut Visit| {
                (v.cycle, &v.robot) == (visit.cycle, &visit.robot) && approach.as_ref().is_none_or(|a| v.approach == *a)
            };
            match place.visits.iter_mut().find(same) {
                Some(before) if several => before.read_again(&visit),
                _ if !first => {
                    let message = Message::error(format!("pose {pose} is there twice in cycle {}", visit.cycle));
                    let hint =
                        "number the cycles, or name them in `approach`, or number readings of one visit in `reading`";
                    problems.0.push(at_row(message, attained, i).hint(hint));
                }
                _ => place.visits.push(visit),
            }
        }
        // one message a kind of mistake is enough of the same
        problems.0.truncate(20);
        let mut warnings = problems.check()?;
        warnings.extend(unread(attained, &["pose", "cycle", "approach", "robot", "reading"]));
        warnings.extend(unread(commanded, &["pose", "cycle"]));
        for p in poses.iter().filter(|p| p.visits.is_empty()) {
            warnings.push(Message::warning(format!("pose {} is commanded, but nothing was measured there", p.pose)));
        }
        poses.retain(|p| !p.visits.is_empty());
        if poses.is_empty() {
            return Err(Message::error("no pose was measured").at(Place::file(attained.0)).into());
        }
        Ok(Self { poses, spatial: a.spatial, angles: a.angles, warnings })
    }
}

impl Visit {
    /// Takes one more reading of the same visit into its means.
    fn read_again(&mut self, reading: &Self) {
        self.readings_mm.push(reading.position_mm);
        let n = self.readings_mm.len() as f64;
        self.position_mm = centroid(&self.readings_mm).unwrap_or(self.position_mm);
        for (mean, angle) in self.angles_rad.iter_mut().zip(&reading.angles_rad) {
            *mean += wrapped(angle - *mean) / n;
        }
    }
}

impl PoseVisits {
    /// Attained positions of visits that `wanted` takes.
    pub fn positions_mm(&self, wanted: impl Fn(&Visit) -> bool) -> Vec<Vector> {
        self.visits.iter().filter(|v| wanted(v)).map(|v| v.position_mm).collect()
    }

    /// Attained angles number `k` of visits that `wanted` takes.
    pub fn angles_rad(&self, k: usize, wanted: impl Fn(&Visit) -> bool) -> Vec<f64> {
        self.visits.iter().filter(|v| wanted(v)).filter_map(|v| v.angles_rad.get(k).copied()).collect()
    }

    /// Numbers of visits by approach, in alphabetical order.
    pub fn approaches(&self) -> BTreeMap<&str, usize> {
        let mut counts = BTreeMap::new();
        for name in self.visits.iter().filter_map(|v| v.approach.as_deref()) {
            *counts.entry(name).or_default() += 1;
        }
        counts
    }
}

/// What an approach is called by the pose before.
pub fn from_pose(pose: i64) -> String {
    format!("from pose {pose}")
}

fn explicit(frame: &DataFrame) -> bool {
    frame.column("approach").is_ok()
}

fn visits(attained: (&str, &DataFrame), rows: &Rows) -> Result<Vec<Visit>> {
    let (file, frame) = attained;
    let cycles = table::integers(frame, "cycle").map_err(|p| in_file(p, file))?;
    let approaches = explicit(frame).then(|| table::texts(frame, "approach")).transpose()?;
    let robots = frame.column("robot").is_ok().then(|| table::texts(frame, "robot")).transpose()?;
    // the row before of the same robot
    let mut last: BTreeMap<&str, usize> = BTreeMap::new();
    let robot = |i: usize| robots.as_ref().map_or("", |names| names[i].as_str());
    let before: Vec<Option<usize>> = (0..rows.poses.len()).map(|i| last.insert(robot(i), i)).collect();
    let visit = |i: usize| Visit {
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

fn rows(file: &str, frame: &DataFrame) -> Result<Rows> {
    let poses = table::integers(frame, "pose").map_err(|p| in_file(p, file))?;
    let Coordinates { positions_mm, angles_rad, spatial, angles } = coordinates((file, frame))?;
    let angles_rad = (0..poses.len()).map(|i| angles_rad.iter().map(|column| column[i]).collect()).collect();
    Ok(Rows { poses, positions_mm, angles_rad, spatial, angles })
}
