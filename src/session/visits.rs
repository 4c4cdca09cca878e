//! Visits of poses, and their use by an identification.

use crate::stages::calibrate::identification::Unjudged;
use crate::stages::join::ObservationTime;
use etalon_base::pose_name::PoseName;
use etalon_campaign::Campaign;
use etalon_documents::{ErrorQuantity, FramesDocument, PointError, PoseSet as StoredSet};
use etalon_identify::Observation;
use etalon_robots::Robot;
use etalon_view::PoseSet;
use std::collections::BTreeSet;

/// A visit of a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Visit {
    pub pose: PoseName,
    pub cycle: i64,
}

impl Visit {
    /// `true` if a pose was visited in several cycles; the visits are in order.
    pub fn have_cycles(visits: &[Self]) -> bool {
        visits.windows(2).any(|pair| pair[0].pose == pair[1].pose)
    }

    /// Name of the visit: its pose, with the cycle if poses were visited several times.
    pub fn id(self, several: bool) -> String {
        if several { format!("{}/{}", self.pose, self.cycle) } else { self.pose.to_string() }
    }
}

/// Input of a scene.
#[derive(Clone, Copy)]
pub(super) struct Base<'a> {
    pub campaign: &'a Campaign,
    pub robot: &'a dyn Robot,
    pub found: &'a Unjudged,
    pub frames: &'a FramesDocument,
    pub visits: &'a [Visit],
    pub observations: &'a [Observation],
    pub times: &'a [ObservationTime],
}

impl Base<'_> {
    fn is_in(&self, set: StoredSet, visit: Visit) -> bool {
        let (observations, conditions) = self.found.all.observations_and_conditions(set);
        observations.iter().any(|o| o.pose == visit.pose && o.cycle == visit.cycle)
            || conditions.iter().any(|c| c.pose == visit.pose && c.cycle == visit.cycle)
    }

    /// Use of a visit.
    pub fn set(&self, visit: Visit) -> PoseSet {
        let set = StoredSet::ALL.into_iter().find(|set| self.is_in(*set, visit));
        set.map_or(PoseSet::LeftOut, |set| match set {
            StoredSet::Calibration => PoseSet::Calibration,
            StoredSet::Validation => PoseSet::Validation,
        })
    }

    /// `true` if a target of a visit identifies or validates.
    pub fn uses(&self, visit: Visit, target: usize) -> bool {
        let sets = [&self.found.all.calibration, &self.found.all.validation];
        let of_visit = |o: &&Observation| o.pose == visit.pose && o.cycle == visit.cycle;
        sets.into_iter().flatten().filter(of_visit).any(|o| o.targets.get(target).is_some_and(Option::is_some))
    }

    /// Errors of quantities other than positions, and of positions from further stations.
    pub fn conditions(&self) -> impl Iterator<Item = &PointError> {
        let conditions = self.found.all.calibration_conditions.iter().chain(&self.found.all.validation_conditions);
        let kinds = conditions.filter(|condition| condition.kind.error_kind().is_some());
        let named: BTreeSet<(PoseName, i64, usize)> = kinds.map(|c| (c.pose, c.cycle, c.target)).collect();
        let target = |name: &str| self.robot.targets().iter().position(|target| target == name);
        let is_condition = move |error: &&PointError| {
            ErrorQuantity::OTHERS.contains(&error.quantity)
                || target(&error.target).is_some_and(|target| named.contains(&(error.pose, error.cycle, target)))
        };
        self.found.errors.iter().filter(is_condition)
    }
}
