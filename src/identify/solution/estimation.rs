//! Input of a solution.

use crate::{Observation, Settings};
use etalon_robots::Robot;

/// Wanted parameters of a robot, and what they are estimated from.
#[derive(Clone, Copy)]
pub(crate) struct Estimation<'a> {
    pub robot: &'a dyn Robot,
    pub observations: &'a [Observation],
    pub settings: &'a Settings,
    /// Indices of the wanted parameters.
    pub wanted: &'a [usize],
}
