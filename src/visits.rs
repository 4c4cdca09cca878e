//! Visits of a repeatability test: tables of attained and commanded poses, checked and grouped by pose.

use crate::message::{Message, Place, Problems, Result};
use crate::pose::Vector;
use crate::table;
use polars::prelude::DataFrame;
use std::collections::{BTreeMap, BTreeSet};

/// Columns of the angles, in degrees: rotations about the axes named in the rotation order that the user states.
const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];

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
    /// From tables `pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg][,approach][,robot]` and the same without
    /// `cycle`, each with the file's name and, for messages, a column `line`.
    pub fn from_tables(attained: (&str, &DataFrame), commanded: (&str, &DataFrame)) -> Result<Self> {
        let mut problems = Problems::default();
        let mut read = |(file, frame)| rows(file, frame).map_err(|p| problems.0.extend(p.0)).ok();
        let (Some(a), Some(c)) = (read(attained), read(commanded)) else { return Err(problems) };
        if (a.spatial, &a.angles) != (c.spatial, &c.angles) {
            let message = Message::error("attained and commanded poses have different coordinates");
            let message = message.at(Place::file(commanded.0)).expected(format!("those of `{}`", attained.0));
            return Err(message.hint("planar robots leave out z_mm in both tables").into());
        }
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
        for (i, (visit, pose)) in visits.into_iter().zip(&a.poses).enumerate() {
            if !seen.insert((
                *pose,
                visit.cycle,
                visit.robot.clone(),
                explicit(attained.1).then(|| visit.approach.clone()),
            )) {
                let message = Message::error(format!("pose {pose} is there twice in cycle {}", visit.cycle));
                problems.0.push(at_row(message, attained, i).hint("number the cycles, or name them in `approach`"));
            }
            match poses.iter_mut().find(|p| p.pose == *pose) {
                Some(place) => place.visits.push(visit),
                None => {
                    let message = Message::error(format!("pose {pose} is not among the commanded poses"));
                    problems.0.push(at_row(message, attained, i).hint(format!("add it to `{}`", commanded.0)));
                }
            }
        }
        // one message a kind of mistake is enough of the same
        problems.0.truncate(20);
        let mut warnings = problems.check()?;
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
    let visit = |i: usize| Visit {
        cycle: cycles[i],
        position_mm: rows.positions_mm[i],
        angles_rad: rows.angles_rad[i].clone(),
        approach: match &approaches {
            Some(names) => Some(names[i].clone()),
            None => i.checked_sub(1).map(|before| from_pose(rows.poses[before])),
        },
        robot: robots.as_ref().map_or_else(String::new, |names| names[i].clone()),
    };
    Ok((0..rows.poses.len()).map(visit).collect())
}

fn rows(file: &str, frame: &DataFrame) -> Result<Rows> {
    let read = || -> Result<Rows> {
        let has = |name: &str| frame.column(name).is_ok();
        let angles: Vec<usize> = (0..3).filter(|&k| has(ANGLES[k])).collect();
        let columns = angles.iter().map(|&k| table::numbers(frame, ANGLES[k])).collect::<Result<Vec<Vec<f64>>>>()?;
        let poses = table::integers(frame, "pose")?;
        let turned = |i: usize| columns.iter().map(|column| column[i].to_radians()).collect();
        Ok(Rows {
            positions_mm: table::coordinates(frame)?,
            angles_rad: (0..poses.len()).map(turned).collect(),
            spatial: has(table::XYZ[2]) && table::numbers(frame, table::XYZ[2])?.iter().any(|z| !z.is_nan()),
            poses,
            angles,
        })
    };
    let rows = read().map_err(|p| in_file(p, file))?;
    // beyond this squares of millimetres are no numbers
    let usable = |v: &f64| v.abs() < 1e100;
    let bad = (0..rows.poses.len())
        .filter(|&i| !rows.positions_mm[i].iter().chain(&rows.angles_rad[i]).all(usable))
        .map(|i| at_row(Message::error("a coordinate is missing or is not a finite number"), (file, frame), i));
    Problems(bad.take(20).collect()).check()?;
    Ok(rows)
}

fn in_file(problems: Problems, file: &str) -> Problems {
    Problems(problems.0.into_iter().map(|m| if m.place.is_none() { m.at(Place::file(file)) } else { m }).collect())
}

fn at_row(message: Message, (file, frame): (&str, &DataFrame), row: usize) -> Message {
    let line = table::integers(frame, "line").ok().and_then(|lines| usize::try_from(*lines.get(row)?).ok());
    message.at(Place { file: file.to_owned(), line, ..Place::default() })
}
