//! Tool centre point from orientations of the robot about one fixed point.

use super::solve::{CellModel, Equation, UNIT, columns, solve};
use super::{CellFault, CellPoint, Measure, Quality, Stated, check_orientations, part};
use etalon_base::pose::{Pose, Vector, minus};

/// Tool centre point, and the fixed point that it touched.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolTip {
    /// Tool centre point in the flange.
    pub tool: CellPoint,
    /// Fixed point in the base of the robot.
    pub fixed: CellPoint,
    /// Residuals in the base.
    pub quality: Quality,
}

#[derive(Clone)]
struct FixedPoint<'a> {
    poses: &'a [Pose],
    stated: &'a Stated,
    tool: Vector,
    fixed: Vector,
}

impl CellModel for FixedPoint<'_> {
    fn parameters(&self) -> usize {
        6
    }

    fn equations(&self) -> Vec<Equation> {
        let equation = |(reading, pose): (usize, &Pose)| Equation {
            reading,
            measure: Measure::Position,
            residual: minus(self.fixed, pose.apply(self.tool)),
            columns: columns(0, |k| pose.axis(k)).chain(columns(3, |k| UNIT[k].map(|v| -v))).collect(),
            covariance: self.stated.position(reading),
        };
        self.poses.iter().enumerate().map(equation).collect()
    }

    fn moved(&self, step: &[f64]) -> Self {
        let add = |v: Vector, first: usize| [0, 1, 2].map(|k| v[k] + step[first + k]);
        Self { tool: add(self.tool, 0), fixed: add(self.fixed, 3), ..*self }
    }
}

/// Tool centre point from poses of the flange (in the base) in which the tool touches one fixed,
/// unknown point: R t + p = c.
///
/// # Errors
/// Fails if orientations differ about one axis only: the point along this axis is then open.
pub fn tool_point(poses: &[Pose], stated: &Stated) -> Result<ToolTip, CellFault> {
    if poses.len() < 3 {
        return Err(CellFault::TooFew { needed: 3, readings: poses.len() });
    }
    check_orientations(poses)?;
    let start = FixedPoint { poses, stated, tool: [0.0; 3], fixed: [0.0; 3] };
    let solved = solve(start, stated).ok_or(CellFault::Undetermined)?;
    let point = |at_mm: Vector, at: [usize; 3]| CellPoint { at_mm, covariance_mm2: part(&solved.covariance, at) };
    Ok(ToolTip {
        tool: point(solved.model.tool, [0, 1, 2]),
        fixed: point(solved.model.fixed, [3, 4, 5]),
        quality: solved.quality,
    })
}
