//! Poses, readings and degrees of freedom of residuals.

use super::{OF_MEDIAN, Residuals};
use crate::Observation;
use crate::model::kinds::Condition;
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::median;
use etalon_math::{Problem, Solution};
use std::collections::BTreeSet;

impl<'a> Residuals<'a> {
    /// Pose, cycle and joints of every observation, with the number of its residuals.
    fn seen(&self) -> impl Iterator<Item = Seen<'_>> {
        let of = |(o, &rows): (&'a Observation, &usize)| Seen { pose: o.pose, cycle: o.cycle, joints: &o.joints, rows };
        let conditions = self.conditions.items.iter().map(|c| Seen {
            pose: c.pose,
            cycle: c.cycle,
            joints: &c.joints,
            rows: c.kind.rows(),
        });
        self.coordinates.observations.iter().zip(&self.coordinates.rows).map(of).chain(conditions)
    }

    /// Joint values of every observation and condition.
    pub fn joints(&self) -> impl Iterator<Item = &[f64]> {
        self.seen().map(|s| s.joints)
    }

    /// Targets that are observed relative to targets of another branch, together with these other
    /// targets.
    pub fn related_targets(&self) -> BTreeSet<usize> {
        let related = |c: &Condition| c.kind.other_target().map(|other| [c.target, other]);
        self.conditions.items.iter().filter_map(related).flatten().collect()
    }

    /// Pose and joints of every observation and condition, with the number of its residuals.
    pub fn pose_rows(&self) -> impl Iterator<Item = (PoseName, &[f64], usize)> {
        self.seen().map(|s| (s.pose, s.joints, s.rows))
    }

    /// The pose of each residual.
    pub fn poses(&self) -> Vec<PoseName> {
        self.seen().flat_map(|s| std::iter::repeat_n(s.pose, s.rows)).collect()
    }

    /// Cluster to which the error of each residual belongs: a reading common to several residuals,
    /// or the pose.
    pub fn clusters(&self) -> Vec<PoseName> {
        match &self.whitening.common {
            Some(common) => common.numbers(self.measured_count()),
            None => self.poses(),
        }
    }

    /// Pose and cycle of each observation and condition, with the number of its residuals.
    pub fn counts(&self) -> impl Iterator<Item = ((PoseName, i64), usize)> {
        self.seen().map(|s| ((s.pose, s.cycle), s.rows)).filter(|count| count.1 > 0)
    }

    /// Poses with at least one residual, each as often as it was repeated.
    pub fn observation_count(&self) -> usize {
        let coordinates = self.coordinates.rows.iter().filter(|&&rows| rows > 0).count();
        if self.conditions.items.is_empty() {
            return coordinates;
        }
        self.counts().map(|count| count.0).collect::<BTreeSet<_>>().len()
    }

    /// Standard deviation of a residual: the given one, or the one of most residuals of `solution`
    /// if it is larger (from their median size, which a few wrong readings do not affect); 0 if
    /// neither is known.
    pub fn noise(&self, solution: Option<&Solution>) -> f64 {
        let shown = |s: &Solution| {
            let (dof, equations) = (self.degrees_of_freedom(s), self.nominal_rows().start as f64);
            let median = median(s.residuals.iter().take(self.measured_count()).map(|r| r.abs())).unwrap_or(0.0);
            if dof >= 1.0 { OF_MEDIAN * median * (equations / dof).sqrt() } else { 0.0 }
        };
        self.stated_noise.unwrap_or(0.0).max(solution.map_or(0.0, shown))
    }

    /// Number of parameters that the data leave undetermined, from zero to all with a nominal
    /// value: Σ (u/s)² with u from data and nominal values, s from nominal values alone. `solution`
    /// is a solution of these residuals.
    pub fn undetermined(&self, solution: &Solution) -> f64 {
        let factor = solution.factor.as_ref().filter(|_| !self.priors.nominals.is_empty());
        let Some((common, inverse)) = factor.and_then(|f| Some((f.common(), f.common_inverse()?))) else { return 0.0 };
        // eliminated unknowns are measured directly: the rows of `nominals` are in the order of the
        // columns
        let open = |(k, &j): (usize, &usize)| {
            let derivative = self.priors.nominals[j].derivative() / solution.scale[j];
            (derivative.powi(2) * inverse[k * common.len() + k]).clamp(0.0, 1.0)
        };
        common.iter().enumerate().map(open).sum()
    }

    /// Degrees of freedom without nominal values: equations minus parameters, where undetermined
    /// parameters do not count.
    pub fn degrees_of_freedom(&self, solution: &Solution) -> f64 {
        let equations = self.residual_count() - self.priors.nominals.len();
        (equations as f64 - solution.x.len() as f64 + self.undetermined(solution)).max(0.0)
    }

    /// Sum of squares without nominal values.
    pub fn squares(&self, solution: &Solution) -> f64 {
        solution.residuals[..self.nominal_rows().start].iter().map(|r| r * r).sum()
    }
}

/// Measurements at a pose.
struct Seen<'a> {
    pose: PoseName,
    cycle: i64,
    joints: &'a [f64],
    rows: usize,
}
