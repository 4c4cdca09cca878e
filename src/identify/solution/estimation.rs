//! Input of a solution.

use crate::{Observation, Settings};
use etalon_robots::Robot;

/// Free parameters of a robot, and the data from which they are estimated.
#[derive(Clone, Copy)]
pub(crate) struct Estimation<'a> {
    pub robot: &'a dyn Robot,
    pub observations: &'a [Observation],
    pub settings: &'a Settings,
    /// Indices of the free parameters.
    pub wanted: &'a [usize],
}
