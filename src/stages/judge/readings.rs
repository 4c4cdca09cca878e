//! Readings that most others contradict: their mistakes, and whether they decide the result.

use crate::stages::calibrate::solution::{MOST_OUTLIERS, Solution};
use crate::stages::remedies::readings_to_check;
use crate::stages::truncated;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_identify::{
    GROSS, Observation, ReadingSlips, RobustFit, Settings, WrongCoordinate, moved_between, nominal_reading_slips,
    reading_slips,
};
use etalon_robots::{Robot, Role};
use std::collections::BTreeSet;

/// Maximum number of pairs of poses, coordinates or poses in a message.
const NAMED: usize = 8;
/// Ratio of the smallest outlier to the largest other reading, both in standard deviations, from
/// which outliers are no tail of the misfit of the model.
const APART: f64 = 1.5;
/// Change of a parameter, in its standard uncertainties, beyond which excluded readings decide it.
const DECISIVE: f64 = 1.0;

/// Readings of a solution in a robust fit.
pub(crate) struct RobustReadings {
    /// Readings of the calibration.
    pub fit: RobustFit,
    /// Mistakes in readings of calibration and validation.
    slips: ReadingSlips,
}

/// A solution without the readings that decide it.
pub(crate) struct Settled {
    pub solution: Solution,
    /// Error about the readings.
    pub message: Message,
}

impl RobustReadings {
    /// Robust fit of a solution; `None` if the fit fails.
    pub fn new(robot: &dyn Robot, solution: &Solution) -> Option<Self> {
        let sets = &solution.basis.sets;
        let (observations, settings) = (&sets.calibration, &solution.basis.settings);
        let fit = RobustFit::new(robot, observations, settings, &solution.found)?;
        let all = [&observations[..], &sets.validation].concat();
        let conditions = [&settings.conditions[..], &sets.validation_conditions].concat();
        let of_all = fit.clone().with_others(robot, &all, &conditions);
        let slips = reading_slips(robot, &all, &conditions, &of_all);
        Some(Self { fit, slips })
    }

    /// The solution without the outliers, if they decide it: a few readings, one of them far beyond
    /// all others, without which a parameter of the robot changes by more than its standard
    /// uncertainty. The poses of one side of a change of the set-up are not such readings.
    pub fn settled(&self, robot: &dyn Robot, solution: &Solution) -> Option<Settled> {
        let sets = &solution.basis.sets;
        let outliers = self.fit.outliers();
        let is_few = outliers.len() as f64 <= (MOST_OUTLIERS * self.fit.readings.len() as f64).max(1.0);
        let is_gross = outliers.iter().any(|reading| reading.over_deviation() > GROSS);
        if !is_gross
            || !is_few
            || !self.fit.is_separated(APART)
            || !self.fit.is_possible(robot, &sets.calibration, &solution.basis.settings)
        {
            return None;
        }
        let Solution { basis, found, .. } = solution;
        if moved_between(robot, &sets.calibration, &basis.settings, found, &self.fit.values).is_some() {
            return None;
        }
        let mut basis = basis.clone();
        basis.exclude(outliers);
        // the same parameters are free: those that the frames absorb depend on the choice
        let held = robot.parameters().iter().enumerate();
        let held = held.filter(|(i, p)| p.role == Role::Robot && !solution.found.free.contains(i));
        basis.settings.hold.extend(held.map(|(_, p)| p.name.clone()));
        let without = Solution::new(robot, basis).ok()?;
        let change = |&i: &usize| {
            let u = without.found.standard_uncertainty(i).filter(|u| *u > 0.0)?;
            Some((i, (solution.found.values[i] - without.found.values[i]).abs() / u))
        };
        let of_robot = without.found.free.iter().filter(|&&i| robot.parameters()[i].role == Role::Robot);
        let (i, times) = of_robot.filter_map(change).max_by(|a, b| a.1.total_cmp(&b.1))?;
        let poses: BTreeSet<PoseName> = outliers.iter().map(|reading| reading.pose).collect();
        let numbered = poses.len();
        let poses = truncated(poses.iter().map(PoseName::to_string), NAMED);
        let (count, parameter) = (outliers.len(), &robot.parameters()[i].name);
        let message = error!("readings-decide", count, poses = poses.clone(), parameter, times);
        let message = message.hint(phrase!("settle-readings", number = numbered, poses));
        (times > DECISIVE).then_some(Settled { solution: without, message })
    }

    /// Adds messages about the readings: mistakes that explain them and outliers first, because a
    /// few wrong readings explain what follows; the largest residuals of a wrong model last.
    pub fn add_to(&self, messages: &mut Vec<Message>, robot: &dyn Robot) {
        let to_check = readings_to_check(&self.fit, robot);
        match self.fit.outliers().is_empty() {
            true => messages.push(to_check),
            false => messages.insert(0, to_check),
        }
        messages.splice(0..0, slip_messages(&self.slips)).for_each(drop);
    }
}

/// Warnings about mistakes in single readings that the nominal robot shows, located by most of
/// them.
pub(crate) fn check_readings(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Vec<Message> {
    slip_messages(&nominal_reading_slips(robot, observations, settings))
}

/// Warnings about poses whose joint values are swapped, and about coordinates with another decimal
/// mark or sign.
fn slip_messages(slips: &ReadingSlips) -> Vec<Message> {
    let ReadingSlips { exchanged, coordinates } = slips;
    let mut all = Vec::new();
    if !exchanged.is_empty() {
        let pair = |[first, second]: &[PoseName; 2]| phrase!("pair-of-poses", first, second);
        let pairs = truncated(exchanged.iter().map(pair), NAMED);
        all.push(warning!("poses-exchanged", count = exchanged.len(), pairs).to_decide());
    }
    if !coordinates.is_empty() {
        let named = truncated(coordinates.iter().map(WrongCoordinate::phrase), NAMED);
        all.push(warning!("coordinates-wrong", count = coordinates.len(), coordinates = named).to_decide());
    }
    all
}
