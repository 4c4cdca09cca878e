//! From the passes of a commanded path to its characteristics.

pub mod accuracy;
pub mod bootstrap;
pub mod commanded;
pub mod cornering;
pub mod passes;
pub mod repeatability;
pub mod velocity;
pub mod weaving;

use crate::iso9283::motion::stream::Recording;
use crate::iso9283::path::accuracy::{path_accuracy, path_accuracy_on_reorientation, path_angle_accuracy_rad};
use crate::iso9283::path::bootstrap::PathBootstrap;
use crate::iso9283::path::commanded::{CommandPoint, CommandedPath, Corner};
use crate::iso9283::path::cornering::cornering;
use crate::iso9283::path::passes::{Pass, Passes, passes};
use crate::iso9283::path::repeatability::{path_angle_repeatability_rad, path_repeatability};
use crate::iso9283::path::velocity::{central, path_velocity};
use crate::iso9283::path::weaving::{Weave, Weaving, weaving};
use etalon_base::message::{Message, Result, count};
use etalon_base::pose::{Vector, minus};
use etalon_documents::{Iso9283Corner, Iso9283Path, Iso9283PathPoint, Iso9283Velocity, Iso9283Weaving};
use etalon_math::statistics::mean;

/// A commanded path and how it is compared.
#[derive(Clone, Debug)]
pub struct PathSettings {
    /// The path.
    pub path: CommandedPath,
    /// Number of command points.
    pub points: usize,
    /// Commanded velocity, and the central share of the path over which it is compared.
    pub velocity_mm_s: Option<f64>,
    /// That share, 0 to 1.
    pub central: f64,
    /// The weave about the path.
    pub weave: Option<Weave>,
}

/// Turns of the commanded path from this angle on are corners.
pub(crate) const CORNER_RAD: f64 = 30.0 * std::f64::consts::PI / 180.0;
/// Simulated tests behind an interval.
const DRAWS: usize = 1000;

/// The passes of a path, at least one, at its command points.
pub(crate) struct Driven<'a> {
    recording: &'a Recording,
    settings: &'a PathSettings,
    points: Vec<CommandPoint>,
    found: Passes,
}

impl<'a> Driven<'a> {
    /// Finds the passes, each point within `near_mm` of the path.
    pub fn new(recording: &'a Recording, settings: &'a PathSettings, near_mm: f64) -> Result<Self> {
        let points = settings.path.command_points_beside(settings.points, CORNER_RAD, near_mm);
        let found = passes(&recording.stream, &points, near_mm)?;
        if found.complete.is_empty() {
            let message = Message::error("no pass of the commanded path was found");
            let through = format!("a motion through {} planes, each within {near_mm} mm of the path", points.len());
            let hint = "are recording and path in the same frame, and driven the same way? --near-mm allows more";
            return Err(message.expected(through).hint(hint).into());
        }
        Ok(Self { recording, settings, points, found })
    }

    /// Warnings of what was found: passes that were not ended, and a corner where the velocity should be constant.
    pub fn warnings(&self) -> Vec<Message> {
        let mut warnings = Vec::new();
        if self.found.incomplete > 0 {
            let what = format!("{} begun and not ended: left out", count(self.found.incomplete, "pass"));
            let hint = "was the motion cut off? where the robot rounds off a corner widely, --near-mm (near_mm) leaves out more of it";
            warnings.push(Message::warning(what).hint(hint));
        }
        if self.settings.velocity_mm_s.is_some() && self.settings.weave.is_none() {
            let (from, to) = central(&self.points, self.settings.central);
            let (from, to) = (self.points[from].along_mm, self.points[to].along_mm);
            let inside = |c: &&Corner| (from..=to).contains(&c.along_mm[1]);
            if let Some(corner) = self.settings.path.corners(CORNER_RAD).iter().find(inside) {
                let what = format!("the central part of the path holds a corner, at {:.3} mm", corner.along_mm[1]);
                let hint = "where a robot slows down for it, that is in AV, RV and FV: state a path without it, or a smaller central part";
                warnings.push(Message::warning(what).hint(hint));
            }
        }
        warnings
    }

    /// AT, RT, velocities and corners.
    pub fn path(&self, band_mm: Option<f64>, seed: u64) -> Result<Iso9283Path> {
        let (passes, points, path) = (&self.found.complete[..], &self.points[..], &self.settings.path);
        let reorientation = path.turned_rad().iter().any(|turned| *turned > 0.0);
        let accuracy = match reorientation {
            true => path_accuracy_on_reorientation(passes, points, path)?,
            false => path_accuracy(passes, points)?,
        };
        let repeated = (passes.len() > 1).then(|| path_repeatability(passes, points)).transpose()?;
        let (at_interval, rt_interval) = match repeated.as_ref().filter(|_| passes.len() > 2) {
            Some(repeated) => {
                let bootstrap = PathBootstrap { draws: DRAWS, seed };
                let at = bootstrap.accuracy(passes, points, &accuracy)?;
                (Some(at), Some(bootstrap.repeatability(passes, points, repeated)?))
            }
            None => (None, None),
        };
        let at = |k: usize| path_angle_accuracy_rad(passes, points, k).to_degrees();
        let rt = |k: usize| path_angle_repeatability_rad(passes, points, k).to_degrees();
        let angles = self.recording.angles.len();
        let point = |(i, p): (usize, &CommandPoint)| Iso9283PathPoint {
            along_mm: p.along_mm,
            commanded_mm: self.there(p.position_mm),
            mean_mm: self.there(accuracy.means_mm[i]),
            deviation_mm: accuracy.deviations_mm[i],
            rt_mm: repeated.as_ref().map(|r| r.points_mm[i]),
        };
        Ok(Iso9283Path {
            passes: passes.len(),
            incomplete: self.found.incomplete,
            length_mm: path.length_mm(),
            reorientation,
            at_mm: accuracy.at_mm,
            at_interval,
            at_along_mm: points[accuracy.worst].along_mm,
            at_angles_deg: (0..angles).map(at).collect(),
            rt_mm: repeated.as_ref().map(|r| r.rt_mm),
            rt_interval,
            rt_along_mm: repeated.as_ref().map(|r| points[r.worst].along_mm),
            rt_angles_deg: if repeated.is_some() { (0..angles).map(rt).collect() } else { Vec::new() },
            velocity: self.velocity(passes)?,
            corners: path.corners(CORNER_RAD).iter().map(|c| self.corner(c, band_mm)).collect::<Result<_>>()?,
            points: points.iter().enumerate().map(point).collect(),
        })
    }

    /// The coordinates that exist.
    fn there(&self, p: Vector) -> Vec<f64> {
        p[..if self.recording.spatial { 3 } else { 2 }].to_vec()
    }

    fn velocity(&self, passes: &[Pass]) -> Result<Option<Iso9283Velocity>> {
        let Some(commanded_mm_s) = self.settings.velocity_mm_s else { return Ok(None) };
        let found = path_velocity(passes, &self.points, commanded_mm_s, self.settings.central)?;
        Ok(Some(Iso9283Velocity {
            commanded_mm_s,
            mean_mm_s: found.mean_mm_s,
            av_percent: found.av_percent,
            rv_percent: Some(found.rv_percent).filter(|rv| rv.is_finite()),
            fv_mm_s: found.fv_mm_s,
        }))
    }

    fn corner(&self, corner: &Corner, band_mm: Option<f64>) -> Result<Iso9283Corner> {
        let found = cornering(&self.recording.stream, &self.found.complete, &self.points, corner, band_mm)?;
        Ok(Iso9283Corner {
            position_mm: self.there(corner.position_mm),
            cr_mm: found.round_off_mm,
            co_mm: found.overshoot_mm,
            stabilisation_mm: found.stabilisation_mm,
        })
    }

    /// The weave about the path, which is its centre line.
    pub fn weaving(&self, weave: &Weave) -> Result<Iso9283Weaving> {
        let last = self.points.len() - 1;
        let along = minus(self.points[last].position_mm, self.points[0].position_mm);
        let swung = |pass: &Pass| weaving(&self.recording.stream, pass.samples(0, last), along, weave);
        let all = self.found.complete.iter().map(swung).collect::<Result<Vec<_>>>()?;
        let mean = |of: fn(&Weaving) -> f64| mean(all.iter().map(of));
        Ok(Iso9283Weaving {
            passes: all.len(),
            turns: all.iter().map(|w| w.turns).sum(),
            commanded_stroke_mm: weave.stroke_mm,
            stroke_mm: mean(|w| w.stroke_mm),
            commanded_frequency_hz: weave.frequency_hz,
            frequency_hz: mean(|w| w.frequency_hz),
            ws_percent: mean(|w| w.ws_percent),
            wf_percent: mean(|w| w.wf_percent),
        })
    }
}
