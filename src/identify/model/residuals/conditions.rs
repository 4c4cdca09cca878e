//! Residuals of conditions. Where the observations contain no length, gaps refer to the size of the
//! robot.

use super::columns::Columns;
use crate::model::kinds::Condition;
use crate::model::size::Size;
use etalon_base::pose::Vector;
use etalon_robots::{FreeBase, Robot, State};
use rayon::prelude::*;

/// Conditions that are evaluated by one thread.
const CHUNK: usize = 32;

/// Conditions of a robot; their rows follow the coordinates.
pub(super) struct Conditions<'a> {
    pub robot: &'a dyn Robot,
    pub items: &'a [Condition],
    /// Size (mm) of the robot to which gaps refer, where the observations contain no length.
    pub reference_mm: Option<f64>,
}

/// A condition evaluated with the robot's arm at the current position of the target.
struct EvaluatedCondition<'a> {
    condition: &'a Condition,
    arm: Option<&'a dyn FreeBase>,
    position: Vector,
    /// First row, from the first row of all conditions.
    row: usize,
}

impl Conditions<'_> {
    /// Number of rows.
    pub fn count(&self) -> usize {
        self.items.iter().map(|c| c.kind.rows()).sum()
    }

    /// Size of the robot at `values`, where the observations contain no length.
    pub fn size(&self, values: &[f64]) -> Option<Size> {
        self.reference_mm.and_then(|_| Size::new(self.robot, self.items, values))
    }

    /// Residuals with all parameters; `out` begins at the first row.
    pub fn residuals(&self, all: &[f64], out: &mut [f64]) {
        self.fill(all, out, 1, |met, out| {
            met.condition.residuals(&met.condition.at(met.arm, all, met.position), out);
        });
        if let (Some(size), Some(reference_mm)) = (self.size(all), self.reference_mm) {
            self.gaps(out, 1).for_each(|gap| gap[0] *= reference_mm / size.mm);
        }
    }

    /// Derivatives with respect to the free parameters; `out` begins at the row `first` of the
    /// Jacobian.
    pub fn jacobian(&self, all: &[f64], columns: Columns, first: usize, out: &mut [f64]) {
        let (n, width) = (all.len(), columns.width());
        let (robot, loads) = (self.robot.parametrised(all), self.robot.loads());
        self.fill(all, out, width, |met, out| {
            let (condition, dimension) = (met.condition, self.robot.dimension());
            let mut moved = vec![0.0; dimension * n];
            if condition.kind.equation().depends_on_target() {
                let state = State {
                    joints: &condition.joints,
                    loads: &loads.as_ref().map_or_else(Vec::new, |at| at(&condition.joints)),
                };
                robot.target_derivatives(state, &[condition.target], &mut |_, j, by| {
                    (0..dimension).for_each(|i| moved[i * n + j] += by[i]);
                });
            }
            let mut full = vec![0.0; condition.kind.rows() * n];
            condition.jacobian(&condition.at(met.arm, all, met.position), &moved, &mut full);
            for (i, (row, out)) in full.chunks_exact(n).zip(out.chunks_exact_mut(width)).enumerate() {
                columns.write(first + met.row + i, |parameter| row[parameter], out);
            }
        });
        self.relate(all, columns, out);
    }

    /// Divides gaps by the size of the robot, in their derivatives.
    fn relate(&self, all: &[f64], columns: Columns, jacobian: &mut [f64]) {
        let (Some(size), Some(reference_mm)) = (self.size(all), self.reference_mm) else { return };
        let mut left = vec![0.0; self.count()];
        self.residuals(all, &mut left);
        let gaps = self.gaps(jacobian, columns.width());
        for (row, left) in gaps.zip(self.gaps(&mut left, 1)) {
            for (derivative, &i) in row.iter_mut().zip(columns.free) {
                *derivative = *derivative * reference_mm / size.mm - left[0] * size.relative[i];
            }
        }
    }

    /// Rows of the conditions that are lengths, of `width` numbers each.
    fn gaps<'r>(&self, rows: &'r mut [f64], width: usize) -> impl Iterator<Item = &'r mut [f64]> {
        let is_length: Vec<bool> =
            self.items.iter().flat_map(|c| std::iter::repeat_n(!c.kind.is_angle(), c.kind.rows())).collect();
        rows.chunks_exact_mut(width).zip(is_length).filter(|(_, is_length)| *is_length).map(|(row, _)| row)
    }

    /// Writes rows of `width` numbers for each condition, over chunks of conditions.
    fn fill(&self, all: &[f64], out: &mut [f64], width: usize, write: impl Fn(&EvaluatedCondition, &mut [f64]) + Sync) {
        let mut parts = Vec::new();
        let (mut out, mut row) = (out, 0);
        for conditions in self.items.chunks(CHUNK) {
            let rows: usize = conditions.iter().map(|c| c.kind.rows()).sum();
            let (part, rest) = out.split_at_mut(rows * width);
            parts.push((conditions, row, part));
            (out, row) = (rest, row + rows);
        }
        let arm = self.robot.free_base();
        parts.into_par_iter().for_each(|(conditions, mut row, mut out)| {
            for condition in conditions {
                let position = self.robot.position(all, &condition.joints, condition.target);
                let (here, rest) = out.split_at_mut(condition.kind.rows() * width);
                write(&EvaluatedCondition { condition, arm, position, row }, here);
                (out, row) = (rest, row + condition.kind.rows());
            }
        });
    }
}
