//! Solution of an identification: parameters before and after.

use crate::stages::evaluate::sets::Sets;
use crate::stages::judge::excitation::unmoved;
use crate::stages::remedies::{outliers_excluded, remedied};
use etalon_base::error;
use etalon_base::message::{Message, Result};
use etalon_identify::{Identification, Observation, RobustFit, Settings, Systematic};
use etalon_robots::Robot;

/// Maximum share of readings excluded as outliers: beyond it the model or the set-up is wrong.
const MOST_OUTLIERS: f64 = 0.1;

/// Basis of an identification.
#[derive(Clone, Debug, Default)]
pub struct Basis {
    /// Observations by set.
    pub sets: Sets,
    /// Settings and weights of an identification on the calibration poses.
    pub settings: Settings,
    /// Errors common to all readings, or to the readings of a pose.
    pub systematic: Systematic,
}

/// Parameters of the nominal robot with base and targets fitted, and the identification from there.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Observations and settings that the solution is of.
    pub basis: Basis,
    /// All parameters before.
    pub before: Vec<f64>,
    /// The identification.
    pub found: Identification,
}

impl Solution {
    /// Identifies from the calibration observations.
    ///
    /// # Errors
    /// Fails if no joint moves, or if the solver fails.
    pub fn new(robot: &dyn Robot, basis: Basis) -> Result<Self> {
        let Basis { sets, settings, systematic } = &basis;
        unmoved(robot, &sets.calibration, settings, None)?;
        let before = etalon_identify::fit_frames(robot, &sets.calibration, settings).map_err(remedied)?;
        unmoved(robot, &sets.calibration, settings, Some(&before))?;
        let found = etalon_identify::identify_with(robot, &sets.calibration, settings, &before, systematic);
        let found = found.map_err(remedied)?;
        Ok(Self { basis, before, found })
    }

    /// Excludes outliers from the calibration until none is left, and names them.
    ///
    /// # Errors
    /// Fails with too many outliers, or if the solver fails.
    pub fn without_outliers(mut self, robot: &dyn Robot) -> Result<(Self, Vec<Message>)> {
        let readings = self.basis.sets.calibration.iter().map(|o| o.targets.iter().flatten().count());
        let fewest = (readings.sum::<usize>() as f64 * (1.0 - MOST_OUTLIERS)).ceil() as usize;
        let mut messages = Vec::new();
        while let Some((calibration, excluded)) = self.calibration_without_outliers(robot, fewest)? {
            messages.push(excluded);
            self.basis.sets.calibration = calibration;
            self = Self::new(robot, self.basis)?;
        }
        Ok((self, messages))
    }

    /// Calibration observations without the outliers of a robust fit, of which at least `fewest`
    /// readings must remain, and a message that names the outliers; `None` without outliers.
    fn calibration_without_outliers(
        &self,
        robot: &dyn Robot,
        fewest: usize,
    ) -> Result<Option<(Vec<Observation>, Message)>> {
        let mut observations = self.basis.sets.calibration.clone();
        let Some(robust) = RobustFit::new(robot, &observations, &self.basis.settings, &self.found) else {
            return Ok(None);
        };
        let outliers = robust.outliers();
        if outliers.is_empty() {
            return Ok(None);
        }
        if robust.readings.len() - outliers.len() < fewest {
            return Err(error!("outliers-too-many", share_percent = 100.0 * MOST_OUTLIERS).into());
        }
        for outlier in outliers {
            observations[outlier.observation].targets[outlier.target] = None;
        }
        observations.retain(|o| o.targets.iter().any(Option::is_some));
        Ok(Some((observations, outliers_excluded(&robust, robot))))
    }
}
