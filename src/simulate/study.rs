//! Studies: how near parameters and tool of a robot with a known truth come to it, by what is measured (thesis 3.7 and 4.6).

use crate::base::message::{Message, Result};
use crate::base::noise::Noise;
use crate::base::pose::{Pose, Vector, minus};
use crate::math::identify::{Observation, Settings, identify_from};
use crate::math::robots::{Kinematics, Quantity, Robot};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Simulated calibrations of one robot.
pub struct Study<'a> {
    /// The robot, with its nominal parameters.
    pub robot: &'a dyn Robot,
    /// Its true parameters (mm, rad, 1).
    pub truth: &'a [f64],
    /// What is identified, and how.
    pub settings: Settings,
    /// Calibrations whose mean is evaluated.
    pub runs: u64,
    /// Seed of the noise.
    pub seed: u64,
}

/// Several calibrations with noise of their own.
#[derive(Clone, Debug)]
pub struct Draw {
    /// Mean of the identified parameters (mm, rad, 1).
    pub mean: Vec<f64>,
    /// Their standard deviation; zero for a single calibration.
    pub standard_deviation: Vec<f64>,
}

impl Study<'_> {
    /// Calibrations from the targets that `observations` name, with Gaussian noise of this standard deviation on each coordinate.
    ///
    /// # Errors
    /// What the identification refuses, and parameters that these poses do not determine.
    pub fn draw(&self, observations: &[Observation], noise_mm: f64, draw: u64) -> Result<Draw> {
        let n = self.truth.len();
        let (mut mean, mut squares) = (vec![0.0; n], vec![0.0; n]);
        for run in 0..self.runs {
            let mut noise = Noise::new(self.seed, draw * self.runs + run);
            let measured: Vec<Observation> =
                observations.iter().map(|o| self.measured(o, noise_mm, &mut noise)).collect();
            let found = identify_from(self.robot, &measured, &self.settings, &self.robot.nominal())?;
            if found.groups.iter().any(|g| g.useless_uncertainty.is_some()) {
                return Err(Message::error("too few poses to identify all parameters").into());
            }
            for ((mean, square), value) in mean.iter_mut().zip(&mut squares).zip(&found.values) {
                let before = value - *mean;
                *mean += before / (run + 1) as f64;
                *square += before * (value - *mean);
            }
        }
        let standard_deviation = squares.iter().map(|s| (s / self.runs.saturating_sub(1).max(1) as f64).sqrt());
        Ok(Draw { standard_deviation: standard_deviation.collect(), mean })
    }

    /// Several draws, on all threads.
    ///
    /// # Errors
    /// As [`Self::draw`].
    pub fn draws(&self, observations: &[Observation], noise_mm: f64, draws: u64) -> Result<Vec<Draw>> {
        (0..draws).into_par_iter().map(|draw| self.draw(observations, noise_mm, draw)).collect()
    }

    fn measured(&self, o: &Observation, noise_mm: f64, noise: &mut Noise) -> Observation {
        let mut seen = |(target, at): (usize, &Option<Vector>)| {
            at.as_ref()?;
            let mut p = self.robot.position(self.truth, &o.joints, target);
            p[..self.robot.dimension()].iter_mut().for_each(|v| *v += noise.gaussian(noise_mm));
            Some(p)
        };
        Observation { targets: o.targets.iter().enumerate().map(&mut seen).collect(), ..o.clone() }
    }
}

/// Where poses are commanded and errors counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The robot's own base: the base in the world and the targets cancel.
    Base,
    /// The world: an error of the base in the world is one of the tool.
    World,
}

/// A commanded pose of the tool, and how far from it the robot is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// The command.
    pub commanded: Pose,
    /// True position minus commanded one, mm.
    pub error_mm: Vector,
    /// Rotation from the commanded to the true orientation, rad.
    pub rotation_rad: Vector,
}

impl Landing {
    /// Where a robot with the parameters `truth` is when its controller, which computes with `identified`, is commanded the pose of the
    /// nominal robot at `joints`; the working mode is kept. `None` where one of them cannot be there.
    pub fn of(robot: &dyn Kinematics, truth: &[f64], identified: &[f64], frame: Frame, joints: &[f64]) -> Option<Self> {
        let base = |p: &[f64]| match frame {
            Frame::Base => Some(Pose::identity()),
            Frame::World => robot.base_in_world(p),
        };
        let nominal = robot.nominal();
        let commanded = base(&nominal)?.then(&robot.tool_pose(&nominal, joints)?);
        let ways = robot.all_joints(identified, &base(identified)?.inverse().then(&commanded));
        let turned = |(a, b): (&f64, &f64)| (a - b + PI).rem_euclid(TAU) - PI;
        let off = |q: &Vec<f64>| {
            let joints = q.iter().zip(joints).zip(robot.joints());
            joints
                .map(
                    |(pair, joint)| {
                        if joint.quantity == Quantity::Angle { turned(pair).abs() } else { (pair.0 - pair.1).abs() }
                    },
                )
                .sum::<f64>()
        };
        let driven = ways.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let attained = base(truth)?.then(&robot.tool_pose(truth, &driven)?);
        let rotation_rad = commanded.rotate(commanded.inverse().then(&attained).rotation_vector_rad());
        Some(Self { commanded, error_mm: minus(attained.translation_mm, commanded.translation_mm), rotation_rad })
    }
}
