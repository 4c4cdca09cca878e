//! Sets of observations: calibration and validation.

use crate::stages::kinds::Observed;
use etalon_base::pose_name::PoseName;
use etalon_campaign::Selections;
use etalon_documents::PoseSet;
use etalon_identify::{Condition, Observation};
use std::collections::{BTreeMap, BTreeSet};

/// Observations divided into calibration and validation.
#[derive(Clone, Debug, Default)]
pub struct Sets {
    /// For calibration.
    pub calibration: Vec<Observation>,
    /// For validation; may be empty.
    pub validation: Vec<Observation>,
    /// Conditions in addition to the positions, for calibration.
    pub calibration_conditions: Vec<Condition>,
    /// Conditions in addition to the positions, for validation.
    pub validation_conditions: Vec<Condition>,
}

impl Sets {
    /// Observations and conditions of a set.
    pub fn observations_and_conditions(&self, set: PoseSet) -> (&[Observation], &[Condition]) {
        match set {
            PoseSet::Calibration => (&self.calibration, &self.calibration_conditions),
            PoseSet::Validation => (&self.validation, &self.validation_conditions),
        }
    }
}

/// Divides observations; indices of poses count from 0 over the `measured` poses of the identified
/// log, so that an exclusion moves no other pose to another set.
pub fn split(observed: &Observed, measured: &BTreeSet<PoseName>, selections: &Selections) -> Sets {
    let indices: BTreeMap<PoseName, usize> = measured.iter().enumerate().map(|(i, pose)| (*pose, i)).collect();
    let index = |pose: PoseName| indices.get(&pose).copied().unwrap_or_else(|| measured.range(..pose).count());
    let calibrates = |pose: PoseName| selections.calibrates(pose, index(pose));
    let validates = |pose: PoseName| selections.validates(pose, index(pose));
    let (observations, conditions) = (observed.observations.iter(), observed.settings.conditions.iter());
    Sets {
        calibration: observations.clone().filter(|o| calibrates(o.pose)).cloned().collect(),
        validation: observations.filter(|o| validates(o.pose)).cloned().collect(),
        calibration_conditions: conditions.clone().filter(|c| calibrates(c.pose)).cloned().collect(),
        validation_conditions: conditions.filter(|c| validates(c.pose)).cloned().collect(),
    }
}
