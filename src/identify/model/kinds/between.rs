//! Two targets of different branches at one pose: their distance, a bar that both hold, or their
//! contact.

use super::{At, Condition, Equation, Kind, place};
use etalon_base::pose::{Vector, minus, norm, unit};
use etalon_math::statistics::mean;
use etalon_robots::{FreeBase, State};
use std::collections::BTreeMap;

/// Place of a target relative to a target of another branch. Residuals: |p − q| − d, or p − q of
/// targets that touch (mm).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Between {
    /// Index of the other target.
    pub other: usize,
    /// Observed quantity.
    pub apart: Separation,
}

/// Observed quantity of two targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Separation {
    /// Their distance (mm).
    Distance(f64),
    /// Their distance is the length of a bar, which is a parameter.
    Bar(usize),
    /// Their positions coincide.
    Touching,
}

impl Between {
    /// From the other target to the target (mm).
    fn offset(&self, at: &At) -> Vector {
        at.arm.map(|arm| minus(at.position, arm.position(at.values, at.joints, self.other))).unwrap_or_default()
    }

    /// Derivatives of the vector from the other target, three rows; `moved` has the derivatives of
    /// the position of the target.
    fn moved(&self, at: &At, moved: &[f64]) -> Vec<f64> {
        let (n, mut apart) = (at.values.len(), moved.to_vec());
        let Some(arm) = at.arm else { return apart };
        let loads = arm.loads().map_or_else(Vec::new, |of| of(at.joints));
        let state = State { joints: at.joints, loads: &loads };
        arm.parametrised(at.values).target_derivatives(state, &[self.other], &mut |_, j, by| {
            (0..3).for_each(|i| apart[i * n + j] -= by[i]);
        });
        apart
    }
}

impl Equation for Between {
    fn rows(&self) -> usize {
        if self.apart == Separation::Touching { 3 } else { 1 }
    }

    fn unknowns(&self) -> Vec<usize> {
        if let Separation::Bar(length) = self.apart { vec![length] } else { Vec::new() }
    }

    fn residuals(&self, at: &At, out: &mut [f64]) {
        let apart = self.offset(at);
        match self.apart {
            Separation::Distance(distance_mm) => out[0] = norm(apart) - distance_mm,
            Separation::Bar(length) => out[0] = norm(apart) - at.values[length],
            Separation::Touching => out.copy_from_slice(&apart),
        }
    }

    fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]) {
        let (n, moved) = (at.values.len(), self.moved(at, moved));
        if self.apart == Separation::Touching {
            return out.copy_from_slice(&moved);
        }
        let along = unit(self.offset(at)).unwrap_or_default();
        (0..n).for_each(|j| out[j] = (0..3).map(|i| along[i] * moved[i * n + j]).sum());
        if let Separation::Bar(length) = self.apart {
            out[length] -= 1.0;
        }
    }

    fn in_world(&self, at: &At, residuals: Vector) -> Vector {
        match self.apart {
            Separation::Touching => residuals,
            _ => unit(self.offset(at)).unwrap_or_default().map(|v| v * residuals[0]),
        }
    }

    fn by_scale(&self, _: &[f64]) -> Vector {
        let Separation::Distance(distance_mm) = self.apart else { return [0.0; 3] };
        [-distance_mm, 0.0, 0.0]
    }

    fn has_length(&self) -> bool {
        matches!(self.apart, Separation::Distance(_))
    }

    fn other_target(&self) -> Option<usize> {
        Some(self.other)
    }

    /// `p` is the vector from the other target.
    fn gaps(&self, values: &[f64], p: Vector, left: Vector) -> Vec<(Vector, f64)> {
        let axis = |k: usize| [0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 });
        match self.apart {
            Separation::Distance(_) => Vec::new(),
            Separation::Bar(length) => vec![(unit(p).unwrap_or(axis(0)), norm(p) - values[length] - left[0])],
            Separation::Touching => (0..3).map(|k| (axis(k), p[k] - left[k])).collect(),
        }
    }
}

/// Lengths of bars: the mean distance of the targets that hold each.
pub(crate) fn span(
    arm: &dyn FreeBase,
    conditions: &[Condition],
    is_unknown: impl Fn(usize) -> bool,
    values: &mut [f64],
) {
    let mut bars: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for c in conditions {
        if let Kind::Between(Between { other, apart: Separation::Bar(length) }) = c.kind {
            let there = Condition { target: other, ..c.clone() };
            let distance = norm(minus(place(arm, c, values), place(arm, &there, values)));
            bars.entry(length).or_default().push(distance);
        }
    }
    for (length, distances) in bars.into_iter().filter(|bar| is_unknown(bar.0)) {
        values[length] = mean(distances);
    }
}
