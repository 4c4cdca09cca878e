//! `[repeatability]`: which labels are which visits of a test of repeatability (thesis 2.4).

use serde::Deserialize;
use toml::Spanned;

/// Poses that are visited again and again along one trajectory.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RepeatabilityDefinition {
    /// Labels of the visits, e.g. `P{pose}-{cycle}`. Visits of one pose in one cycle bear the same label, in their order.
    pub label: Spanned<String>,
    /// Poses in the order of one cycle; the pose before says how one was approached.
    pub trajectory: Spanned<Vec<i64>>,
    /// Four poses whose mean positions should lie in a plane.
    pub coplanar: Option<Spanned<[i64; 4]>>,
    /// Labels of the measurements at the home position, each after homing, e.g. `home-{cycle}`.
    pub homing: Option<Spanned<String>>,
    /// Commanded poses in the world frame: `pose,x_mm,y_mm[,z_mm]`; without z all is in the plane. Without the file there is
    /// no accuracy, distance or drift.
    pub commanded: Option<Spanned<String>>,
    /// Cycles of one set of a drift test.
    pub drift_set: Option<Spanned<usize>>,
}

impl RepeatabilityDefinition {
    /// Every pattern of labels.
    pub fn patterns(&self) -> impl Iterator<Item = &Spanned<String>> {
        std::iter::once(&self.label).chain(&self.homing)
    }
}
