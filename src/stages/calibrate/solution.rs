//! Solution of an identification: parameters before and after.

use crate::stages::evaluate::sets::Sets;
use crate::stages::judge::excitation::unmoved;
use crate::stages::remedies::{outliers_excluded, remedied};
use etalon_base::error;
use etalon_base::message::{Message, Result};
use etalon_identify::{Identification, Reading, ReadingSource, RobustFit, Settings, Systematic};
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Maximum share of readings excluded as outliers: beyond it the model or the set-up is wrong.
pub(crate) const MOST_OUTLIERS: f64 = 0.1;

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

impl Basis {
    /// Excludes readings from the calibration.
    pub(crate) fn exclude(&mut self, readings: &[Reading]) {
        let Self { sets, settings, .. } = self;
        let mut excluded = BTreeSet::new();
        for reading in readings {
            match reading.source {
                ReadingSource::Position(observation) => {
                    sets.calibration[observation].targets[reading.target] = None;
                }
                ReadingSource::Condition(condition) => drop(excluded.insert(condition)),
            }
        }
        sets.calibration.retain(|o| o.targets.iter().any(Option::is_some));
        for conditions in [&mut sets.calibration_conditions, &mut settings.conditions] {
            let mut index = 0..;
            conditions.retain(|_| index.next().is_some_and(|i| !excluded.contains(&i)));
        }
    }
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
        let (mut messages, mut fewest) = (Vec::new(), None);
        loop {
            let Basis { sets, settings, .. } = &self.basis;
            let Some(robust) = RobustFit::new(robot, &sets.calibration, settings, &self.found) else { break };
            let (outliers, readings) = (robust.outliers(), robust.readings.len());
            if outliers.is_empty() {
                break;
            }
            let fewest = *fewest.get_or_insert((readings as f64 * (1.0 - MOST_OUTLIERS)).ceil() as usize);
            if readings - outliers.len() < fewest {
                return Err(error!("outliers-too-many", share_percent = 100.0 * MOST_OUTLIERS).into());
            }
            messages.push(outliers_excluded(&robust, robot));
            self.basis.exclude(outliers);
            self = Self::new(robot, self.basis)?;
        }
        Ok((self, messages))
    }
}
