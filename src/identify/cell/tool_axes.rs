//! Tool frame from contacts of one fixed point: with the tool centre point, with a point of the
//! tool's z axis, and with a point of its x-z plane.

use super::solve::{CellModel, Equation, UNIT, columns, moved, solve};
use super::{CellFault, CellFrame, CellPoint, Measure, Quality, Stated, part, tool_point};
use etalon_base::pose::{Pose, Vector, cross, dot, minus, unit};

/// Place on the tool that touches the fixed point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisRole {
    /// Tool centre point.
    Tip,
    /// Point of the positive z axis.
    Z,
    /// Point of the x-z plane with positive x.
    X,
}

/// Tool frame with the fixed point.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolAxes {
    /// Tool in the flange.
    pub tool: CellFrame,
    /// Fixed point in the base of the robot.
    pub fixed: CellPoint,
    /// Residuals in the base.
    pub quality: Quality,
}

#[derive(Clone)]
struct Axes<'a> {
    readings: &'a [(AxisRole, Pose)],
    stated: &'a Stated,
    tool: Pose,
    fixed: Vector,
    /// Places on the tool, x and z (mm), of each reading; the tool centre point has none.
    places: Vec<[f64; 2]>,
}

impl Axes<'_> {
    /// Index of the first parameter of the place of each reading, and the number of all parameters.
    fn first_place_parameters(&self) -> (Vec<usize>, usize) {
        let mut next = 9;
        let mut first = Vec::new();
        for (role, _) in self.readings {
            first.push(next);
            next += match role {
                AxisRole::Tip => 0,
                AxisRole::Z => 1,
                AxisRole::X => 2,
            };
        }
        (first, next)
    }
}

impl CellModel for Axes<'_> {
    fn parameters(&self) -> usize {
        self.first_place_parameters().1
    }

    fn equations(&self) -> Vec<Equation> {
        let (first, _) = self.first_place_parameters();
        let mut equations = Vec::new();
        for (reading, (role, pose)) in self.readings.iter().enumerate() {
            let [x, z] = self.places[reading];
            let place = self.tool.apply([x, 0.0, z]);
            let lever = pose.rotate(minus(place, self.tool.translation_mm));
            let turned = |k: usize| cross(pose.axis(k), lever);
            let mut all: Vec<(usize, Vector)> = columns(0, |k| pose.axis(k)).chain(columns(3, turned)).collect();
            all.extend(columns(6, |k| UNIT[k].map(|v| -v)));
            let along = |axis: usize| pose.rotate(self.tool.axis(axis));
            match role {
                AxisRole::Tip => {}
                AxisRole::Z => all.push((first[reading], along(2))),
                AxisRole::X => all.extend([(first[reading], along(0)), (first[reading] + 1, along(2))]),
            }
            equations.push(Equation {
                reading,
                measure: Measure::Position,
                residual: minus(self.fixed, pose.apply(place)),
                columns: all,
                covariance: self.stated.position(reading),
            });
        }
        equations
    }

    fn moved(&self, step: &[f64]) -> Self {
        let (first, _) = self.first_place_parameters();
        let mut places = self.places.clone();
        for ((place, at), (role, _)) in places.iter_mut().zip(first).zip(self.readings) {
            match role {
                AxisRole::Tip => {}
                AxisRole::Z => place[1] += step[at],
                AxisRole::X => *place = [place[0] + step[at], place[1] + step[at + 1]],
            }
        }
        Self {
            tool: moved(&self.tool, &step[..3], &step[3..6]),
            fixed: [0, 1, 2].map(|k| self.fixed[k] + step[6 + k]),
            places,
            ..*self
        }
    }
}

/// Tool frame from poses of the flange in which places on the tool touch one fixed point. Needs
/// three readings of the tool centre point, and one of each axis.
///
/// # Errors
/// Fails if the tool centre point is not determined, and if the places do not span a plane.
pub fn tool_axes(readings: &[(AxisRole, Pose)], stated: &Stated) -> Result<ToolAxes, CellFault> {
    let tips: Vec<usize> = (0..readings.len()).filter(|&i| readings[i].0 == AxisRole::Tip).collect();
    let missing = [AxisRole::Z, AxisRole::X].iter().any(|role| !readings.iter().any(|r| r.0 == *role));
    if missing || tips.len() < 3 {
        return Err(CellFault::TooFew { needed: 5, readings: readings.len() });
    }
    let own: Vec<Pose> = tips.iter().map(|&i| readings[i].1).collect();
    let of_tips = Stated {
        measured_mm: tips.iter().filter_map(|&i| stated.measured_mm.get(i).copied()).collect(),
        ..stated.clone()
    };
    let tip = tool_point(&own, &of_tips)?;
    let (t, c) = (tip.tool.at_mm, tip.fixed.at_mm);
    let from_tip = |i: usize| minus(readings[i].1.inverse().apply(c), t);
    let sum = |role: AxisRole| {
        let own = (0..readings.len()).filter(|&i| readings[i].0 == role).map(from_tip);
        own.fold([0.0; 3], |s, v| [0, 1, 2].map(|k| s[k] + v[k]))
    };
    let z = unit(sum(AxisRole::Z)).ok_or(CellFault::Coincident)?;
    let x = sum(AxisRole::X);
    let y = cross(z, x);
    if dot(y, y) < 1e-6 * dot(x, x) {
        return Err(CellFault::Collinear { direction: z });
    }
    let y = unit(y).ok_or(CellFault::Coincident)?;
    let x = cross(y, z);
    let tool = Pose { rotation: [0, 1, 2].map(|i| [x[i], y[i], z[i]]), translation_mm: t };
    let places = (0..readings.len()).map(|i| match readings[i].0 {
        AxisRole::Tip => [0.0; 2],
        AxisRole::Z => [0.0, dot(from_tip(i), z)],
        AxisRole::X => [dot(from_tip(i), x), dot(from_tip(i), z)],
    });
    let start = Axes { readings, stated, tool, fixed: c, places: places.collect() };
    let solved = solve(start, stated).ok_or(CellFault::Undetermined)?;
    Ok(ToolAxes {
        tool: CellFrame { pose: solved.model.tool, covariance: part(&solved.covariance, [0, 1, 2, 3, 4, 5]) },
        fixed: CellPoint { at_mm: solved.model.fixed, covariance_mm2: part(&solved.covariance, [6, 7, 8]) },
        quality: solved.quality,
    })
}
