//! Passes of a commanded path, and its characteristics.

pub mod accuracy;
pub mod bootstrap;
pub mod commanded;
pub mod cornering;
pub mod passes;
pub mod repeatability;
pub mod velocity;
pub mod weaving;

use crate::iso9283::motion::stream::Recording;
use crate::iso9283::path::accuracy::{
    PathAccuracy, path_accuracy, path_accuracy_on_reorientation, path_angle_accuracy_rad,
};
use crate::iso9283::path::bootstrap::PathBootstrap;
use crate::iso9283::path::commanded::{CommandPoint, CommandedPath, Corner};
use crate::iso9283::path::cornering::{Cornering, cornering};
use crate::iso9283::path::passes::{Pass, Passes, angles_at, passes};
use crate::iso9283::path::repeatability::{PathRepeatability, path_angle_repeatability_rad, path_repeatability};
use crate::iso9283::path::velocity::{PathVelocity, central, path_velocity};
use crate::iso9283::path::weaving::{Weave, WeaveCharacteristics, weaving};
use crate::iso9283::pose::orientation::seen_together;
use crate::iso9283::statistics::interval::Interval;
use crate::iso9283::statistics::sample::coordinates;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Vector, minus};

/// A commanded path, and settings of its evaluation.
#[derive(Clone, Debug)]
pub struct PathSettings {
    /// Commanded path.
    pub path: CommandedPath,
    /// Number of command points.
    pub points: usize,
    /// Commanded velocity.
    pub velocity_mm_s: Option<f64>,
    /// Central share of the path in which velocities are evaluated (0 to 1).
    pub central: f64,
    /// Weave about the path.
    pub weave: Option<Weave>,
}

/// Minimum turn of the commanded path that counts as a corner.
pub const CORNER_RAD: f64 = 30.0 * std::f64::consts::PI / 180.0;
/// Number of passes that the standard requires for AT and RT (unverified).
pub const PASSES: usize = 10;
/// Number of simulated tests for an interval.
const DRAWS: usize = 1000;

/// Characteristics of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct PathCharacteristics {
    /// Number of passes through all command points.
    pub passes: usize,
    /// Number of unfinished passes.
    pub incomplete: usize,
    /// Length of the commanded path.
    pub length_mm: f64,
    /// `true` if commanded angles change along the path.
    pub reorientation: bool,
    /// AT of the position and of the angles.
    pub at: AssessedAccuracy,
    /// RT of the position and of the angles.
    pub rt: AssessedRepeatability,
    /// Angles that are seen to vary together at a command point: two of 0, 1, 2 for a, b, c.
    pub inseparable: Option<[usize; 2]>,
    /// Velocity, if commanded.
    pub velocity: Option<PathVelocity>,
    /// Corners of the commanded path.
    pub corners: Vec<PathCorner>,
    /// Command points.
    pub points: Vec<PathPoint>,
}

/// AT with its interval.
#[derive(Clone, Debug, PartialEq)]
pub struct AssessedAccuracy {
    /// AT; by 8.4 if commanded angles change along the path.
    pub position: PathAccuracy,
    /// AT of each angle; empty if two angles are not separable.
    pub angles_rad: Vec<f64>,
    /// Interval of AT of the position; absent with fewer than three passes.
    pub interval: Option<Interval>,
}

/// RT with its interval.
#[derive(Clone, Debug, PartialEq)]
pub struct AssessedRepeatability {
    /// RT; absent with a single pass.
    pub position: Option<PathRepeatability>,
    /// RT of each angle; empty with a single pass, and if two angles are not separable.
    pub angles_rad: Vec<f64>,
    /// Interval of RT of the position; absent with fewer than three passes.
    pub interval: Option<Interval>,
}

/// A corner of the commanded path.
#[derive(Clone, Debug, PartialEq)]
pub struct PathCorner {
    /// Commanded corner: x, y and, if spatial, z.
    pub position_mm: Vec<f64>,
    /// Cornering deviations.
    pub driven: Cornering,
}

/// A command point and the attained positions there.
#[derive(Clone, Debug, PartialEq)]
pub struct PathPoint {
    /// Length of the path up to this point.
    pub along_mm: f64,
    /// Commanded position: x, y and, if spatial, z.
    pub commanded_mm: Vec<f64>,
    /// Mean attained position in the normal plane of the point.
    pub mean_mm: Vec<f64>,
    /// Distance between mean attained and commanded position.
    pub deviation_mm: f64,
    /// Mean radius plus three standard deviations of the passes; absent with a single pass.
    pub rt_mm: Option<f64>,
}

/// Reason why a motion has no passes to evaluate.
#[derive(Clone, Debug)]
pub enum PassError {
    /// No motion passes through the planes of all command points.
    NoPass {
        /// Number of the planes.
        planes: usize,
    },
    /// The path cannot be evaluated.
    Other(Problems),
}

impl From<Problems> for PassError {
    fn from(problems: Problems) -> Self {
        Self::Other(problems)
    }
}

/// Passes of a path, at least one, with its command points.
#[derive(Clone, Debug)]
pub struct Driven<'a> {
    recording: &'a Recording,
    settings: &'a PathSettings,
    /// Command points.
    pub points: Vec<CommandPoint>,
    /// Passes of the recording.
    pub passes: Passes,
}

impl<'a> Driven<'a> {
    /// Finds passes within `near_mm` of the path.
    pub fn new(
        recording: &'a Recording,
        settings: &'a PathSettings,
        near_mm: f64,
    ) -> std::result::Result<Self, PassError> {
        let points = settings.path.command_points_beside(settings.points, CORNER_RAD, near_mm);
        let passes = passes(&recording.stream, &points, near_mm)?;
        if passes.complete.is_empty() {
            return Err(PassError::NoPass { planes: points.len() });
        }
        Ok(Self { recording, settings, points, passes })
    }

    /// `true` if commanded angles change along the path.
    pub fn reorients(&self) -> bool {
        self.settings.path.turned_rad().iter().any(|turned| *turned > 0.0)
    }

    /// First corner in the central part of the path, where the velocity should be constant.
    pub fn central_corner(&self) -> Option<Corner> {
        let (from, to) = central(&self.points, self.settings.central);
        let (from, to) = (self.points[from].along_mm, self.points[to].along_mm);
        self.settings.path.corners(CORNER_RAD).into_iter().find(|c| (from..=to).contains(&c.along_mm[1]))
    }

    /// Evaluates AT, RT, velocities and corners.
    pub fn characteristics(&self, band_mm: Option<f64>, seed: u64) -> Result<PathCharacteristics> {
        let (passes, points, path) = (&self.passes.complete[..], &self.points[..], &self.settings.path);
        let accuracy = match self.reorients() {
            true => path_accuracy_on_reorientation(passes, points, path)?,
            false => path_accuracy(passes, points)?,
        };
        let repeatability = (passes.len() > 1).then(|| path_repeatability(passes, points)).transpose()?;
        let (at_interval, rt_interval) = match repeatability.as_ref().filter(|_| passes.len() > 2) {
            Some(repeated) => {
                let bootstrap = PathBootstrap { draws: DRAWS, seed };
                let at = bootstrap.accuracy(passes, points, &accuracy)?;
                (Some(at), Some(bootstrap.repeatability(passes, points, repeated)?))
            }
            None => (None, None),
        };
        let inseparable = points.iter().enumerate().find_map(|(i, point)| {
            let attained: Vec<Vec<f64>> = (0..self.recording.angles.len()).map(|k| angles_at(passes, i, k)).collect();
            seen_together(&attained, &point.angles_rad)
        });
        let angles = if inseparable.is_some() { 0 } else { self.recording.angles.len() };
        let rt = |k: usize| path_angle_repeatability_rad(passes, points, k);
        let velocity = |commanded| path_velocity(passes, points, commanded, self.settings.central);
        let there = |p: Vector| coordinates(p, self.recording.spatial);
        let cornered = |c: Corner| {
            let driven = cornering(&self.recording.stream, passes, points, &c, band_mm)?;
            Ok(PathCorner { position_mm: there(c.position_mm), driven })
        };
        let point = |(i, p): (usize, &CommandPoint)| PathPoint {
            along_mm: p.along_mm,
            commanded_mm: there(p.position_mm),
            mean_mm: there(accuracy.means_mm[i]),
            deviation_mm: accuracy.deviations_mm[i],
            rt_mm: repeatability.as_ref().map(|r| r.points_mm[i]),
        };
        Ok(PathCharacteristics {
            passes: passes.len(),
            incomplete: self.passes.incomplete,
            length_mm: path.length_mm(),
            reorientation: self.reorients(),
            points: points.iter().enumerate().map(point).collect(),
            at: AssessedAccuracy {
                angles_rad: (0..angles).map(|k| path_angle_accuracy_rad(passes, points, k)).collect(),
                position: accuracy,
                interval: at_interval,
            },
            rt: AssessedRepeatability {
                angles_rad: repeatability.iter().flat_map(|_| (0..angles).map(rt)).collect(),
                position: repeatability,
                interval: rt_interval,
            },
            inseparable,
            velocity: self.settings.velocity_mm_s.map(velocity).transpose()?,
            corners: path.corners(CORNER_RAD).into_iter().map(cornered).collect::<Result<_>>()?,
        })
    }

    /// Evaluates the weave about the path, which is the centre line.
    pub fn weaving(&self, weave: &Weave) -> Result<WeaveCharacteristics> {
        let last = self.points.len() - 1;
        let along = minus(self.points[last].position_mm, self.points[0].position_mm);
        let swung = |pass: &Pass| weaving(&self.recording.stream, pass.samples(0, last), along, weave);
        let passes = self.passes.complete.iter().map(swung).collect::<Result<Vec<_>>>()?;
        Ok(WeaveCharacteristics::new(weave, &passes))
    }
}
