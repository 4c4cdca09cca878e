//! Input of a solution.

use crate::{Observation, ResidualKind, Settings};
use etalon_base::noise::Noise;
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Seed of the combinations, which are the same for the same number of poses.
const SEED: u64 = 1;

/// Free parameters of a robot, and the data from which they are estimated.
#[derive(Clone, Copy)]
pub(crate) struct Estimation<'a> {
    pub robot: &'a dyn Robot,
    pub observations: &'a [Observation],
    pub settings: &'a Settings,
    /// Indices of the free parameters.
    pub wanted: &'a [usize],
}

impl Estimation<'_> {
    /// The observations, and as many with recombined joint values as there are parameters: these
    /// have three times as many coordinates. They show which parameters no pose separates, where
    /// the measured poses are too few to show it. `None` if the measured coordinates are no fewer
    /// than the parameters, and for data other than positions of targets of an arm.
    pub(crate) fn recombined(&self) -> Option<Vec<Observation>> {
        let Self { robot, observations, settings, wanted } = *self;
        let is_plain =
            settings.kind == ResidualKind::Targets && settings.conditions.is_empty() && settings.rigid.is_empty();
        if !is_plain || robot.free_base().is_none() || observations.len() < 2 {
            return None;
        }
        let bits = |o: &Observation| -> Vec<u64> { o.joints.iter().map(|q| q.to_bits()).collect() };
        let read =
            |o: &Observation| (0..o.targets.len()).filter(|&k| o.targets[k].is_some()).map(|k| (bits(o), k)).collect();
        let distinct: BTreeSet<(Vec<u64>, usize)> = observations.iter().flat_map(|o| -> Vec<_> { read(o) }).collect();
        if robot.dimension() * distinct.len() >= wanted.len() {
            return None;
        }
        let mut noise = Noise::new(SEED, observations.len() as u64);
        let mut all = observations.to_vec();
        let mut order: Vec<usize> = (0..observations.len()).collect();
        while all.len() < observations.len() + wanted.len() {
            let mut more = observations.to_vec();
            for k in 0..robot.joints().len() {
                noise.shuffle(&mut order);
                more.iter_mut().zip(&order).for_each(|(o, &from)| o.joints[k] = observations[from].joints[k]);
            }
            // poses of their own
            let name = |at: usize| (1_000_000_000 + at as i64).into();
            more.iter_mut().zip(all.len()..).for_each(|(o, at)| o.pose = name(at));
            all.extend(more);
        }
        Some(all)
    }
}
