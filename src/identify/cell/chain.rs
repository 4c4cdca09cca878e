//! Chains `world_T_base · base_T_flange · flange_T_tool` with both ends unknown: a reflector on the
//! tool, and hand-eye calibration (AX = XB and AX = YB).
//!
//! AX = XB between two readings is AX = YB of both with Y eliminated. Here Y stays: each reading
//! counts once, with its own weight (Dornaika & Horaud 1998, IEEE Trans. Robotics Automat. 14,
//! 617).
#![allow(non_snake_case)] // frames in names

use super::solve::{CellModel, Equation, UNIT, columns, inverse_right_jacobian, moved, rough, solve};
use super::{
    CellFault, CellFrame, CellPoint, Measure, Quality, Stated, check_orientations, check_points, cube_rotations, part,
};
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm};
use etalon_fit::rotation_onto;
use etalon_math::{Factor, column_norms};

/// Pose of the measuring system's target, or its position alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeasuredPose {
    /// Position (mm).
    Position(Vector),
    /// Position and orientation.
    Pose(Pose),
}

impl MeasuredPose {
    fn position(&self) -> Vector {
        match self {
            Self::Position(p) => *p,
            Self::Pose(pose) => pose.translation_mm,
        }
    }
}

/// Place of the measuring system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mounting {
    /// The measuring system stands, its target is on the robot.
    Target,
    /// The sensor is on the robot, its target stands.
    Sensor,
}

/// Point of a reflector on the tool, and the pose of the base in the measuring system.
#[derive(Clone, Debug, PartialEq)]
pub struct Reflector {
    /// Reflector in the flange.
    pub tool: CellPoint,
    /// Base of the robot in the measuring system.
    pub world_T_base: CellFrame,
    /// `true` if another frame fits equally well.
    pub ambiguous: bool,
    /// Residuals in the measuring system.
    pub quality: Quality,
}

/// Solution of AX = YB.
#[derive(Clone, Debug, PartialEq)]
pub struct HandEye {
    /// X: target or sensor in the flange.
    pub flange_T_hand: CellFrame,
    /// Y: measuring system or standing target in the base of the robot.
    pub base_T_world: CellFrame,
    /// `true` if other frames fit equally well.
    pub ambiguous: bool,
    /// Residuals in the frame in which poses are measured.
    pub quality: Quality,
}

/// Measured = world_T_base · pose · tool.
#[derive(Clone)]
struct Chain<'a> {
    poses: &'a [Pose],
    measured: &'a [MeasuredPose],
    stated: &'a Stated,
    tool: Pose,
    world_T_base: Pose,
}

impl Chain<'_> {
    /// Number of parameters of the tool: its rotation counts if orientations are measured.
    fn tool_parameter_count(&self) -> usize {
        if matches!(self.measured.first(), Some(MeasuredPose::Pose(_))) { 6 } else { 3 }
    }
}

impl CellModel for Chain<'_> {
    fn parameters(&self) -> usize {
        self.tool_parameter_count() + 6
    }

    fn equations(&self) -> Vec<Equation> {
        let n = self.tool_parameter_count();
        let mut equations = Vec::new();
        for (reading, (pose, measured)) in self.poses.iter().zip(self.measured).enumerate() {
            let world_T_flange = self.world_T_base.then(pose);
            let in_base = pose.apply(self.tool.translation_mm);
            let lever = self.world_T_base.rotate(in_base);
            let of_tool = columns(0, |k| world_T_flange.axis(k));
            let of_world = columns(n, |k| UNIT[k]).chain(columns(n + 3, |k| cross(UNIT[k], lever)));
            equations.push(Equation {
                reading,
                measure: Measure::Position,
                residual: minus(measured.position(), self.world_T_base.apply(in_base)),
                columns: of_tool.chain(of_world).collect(),
                covariance: self.stated.position(reading),
            });
            if let MeasuredPose::Pose(measured) = measured {
                let predicted = world_T_flange.then(&self.tool);
                let epsilon = measured.then(&predicted.inverse()).rotation_vector_rad();
                let of_tool = columns(3, |k| inverse_right_jacobian(epsilon, world_T_flange.axis(k)));
                let of_world = columns(n + 3, |k| inverse_right_jacobian(epsilon, UNIT[k]));
                equations.push(Equation {
                    reading,
                    measure: Measure::Orientation,
                    residual: epsilon,
                    columns: of_tool.chain(of_world).collect(),
                    covariance: self.stated.rotation(),
                });
            }
        }
        equations
    }

    fn moved(&self, step: &[f64]) -> Self {
        let n = self.tool_parameter_count();
        let turn = if n == 6 { &step[3..6] } else { &[0.0; 3] };
        Self {
            tool: moved(&self.tool, &step[..3], turn),
            world_T_base: moved(&self.world_T_base, &step[n..n + 3], &step[n + 3..n + 6]),
            ..*self
        }
    }
}

impl<'a> Chain<'a> {
    /// Returns the chain with these rotations; the translations by linear least squares.
    fn placed(&self, tool: Pose, world: Pose) -> Option<Self> {
        let (mut rows, mut right) = (Vec::new(), Vec::new());
        for (pose, measured) in self.poses.iter().zip(self.measured) {
            let turn = world.then(pose);
            let rest = minus(measured.position(), world.rotate(pose.translation_mm));
            for i in 0..3 {
                rows.extend(turn.rotation[i]);
                rows.extend(UNIT[i]);
                right.push(rest[i]);
            }
        }
        let norms = column_norms(&rows, 6);
        let x = Factor::new(&rows, &right, &norms).solve()?;
        let at = |first: usize| [0, 1, 2].map(|k| x[first + k] / norms[first + k]);
        Some(Self {
            tool: Pose { translation_mm: at(0), ..tool },
            world_T_base: Pose { translation_mm: at(3), ..world },
            ..self.clone()
        })
    }

    /// Sum of squares of the residuals, orientations multiplied by the largest residual of a
    /// position.
    fn misfit(&self) -> f64 {
        let equations = self.equations();
        let lever = equations.iter().map(|e| norm(e.residual)).fold(1.0, f64::max);
        let weight = |e: &Equation| if e.measure == Measure::Position { 1.0 } else { lever * lever };
        equations.iter().map(|e| weight(e) * dot(e.residual, e.residual)).sum()
    }

    /// Minima from the best starts, best first.
    fn minima(&self) -> Vec<(Self, f64)> {
        let starts = cube_rotations().into_iter().filter_map(|start| {
            let (tool, world) =
                if self.tool_parameter_count() == 6 { self.turned(start) } else { (Pose::identity(), start) };
            let placed = self.placed(tool, world)?;
            let misfit = placed.misfit();
            Some((placed, misfit))
        });
        let mut starts: Vec<(Self, f64)> = starts.collect();
        starts.sort_by(|a, b| a.1.total_cmp(&b.1));
        let mut all: Vec<(Self, f64)> =
            starts.into_iter().take(STARTS).filter_map(|(start, _)| rough(start, self.stated)).collect();
        all.sort_by(|a, b| a.1.total_cmp(&b.1));
        all
    }

    /// Rotations of tool and world from a start, each in turn the best for the other.
    fn turned(&self, start: Pose) -> (Pose, Pose) {
        let (mut tool, mut world) = (start, Pose::identity());
        let turned = |pairs: Vec<(Vector, Vector)>| Pose {
            rotation: rotation_onto(pairs.into_iter()),
            translation_mm: [0.0; 3],
        };
        for _ in 0..ALTERNATIONS {
            let pairs = |of: &dyn Fn(&Pose, &Pose, usize) -> (Vector, Vector)| {
                let both = self.poses.iter().zip(self.measured);
                let rows =
                    both.filter_map(|(pose, m)| if let MeasuredPose::Pose(m) = m { Some((pose, m)) } else { None });
                rows.flat_map(|(pose, m)| [0, 1, 2].map(|k| of(pose, m, k))).collect::<Vec<_>>()
            };
            world = turned(pairs(&|pose, m, k| (pose.then(&tool).axis(k), m.axis(k))));
            tool = turned(pairs(&|pose, m, k| (UNIT[k], world.then(pose).inverse().then(m).axis(k))));
        }
        (tool, world)
    }
}

/// Number of starts that are followed to their minimum.
const STARTS: usize = 10;
/// Number of alternating rotations for a start.
const ALTERNATIONS: usize = 30;
/// Difference of rotations (rad) of two distinct solutions.
const DISTINCT: f64 = 0.02;
/// Sum of squares of a reading (in standard uncertainties) below which data are exact.
const EXACT: f64 = 1e-12;
/// Ratio of sums of squares of solutions that fit equally well.
const AS_GOOD: f64 = 1.5;

/// Best minimum, and `true` if another one fits as well.
fn best<'a>(chain: &Chain<'a>) -> Result<(Chain<'a>, bool), CellFault> {
    let minima = chain.minima();
    let Some((first, cost)) = minima.first() else { return Err(CellFault::Undetermined) };
    // sums of squares of exact data are rounding errors
    let floor = 1e-12 * minima.last().map_or(0.0, |m| m.1) + EXACT * chain.poses.len() as f64;
    let differs = |other: &Chain| {
        let angle = |a: &Pose, b: &Pose| a.inverse().then(b).angle_rad();
        angle(&first.world_T_base, &other.world_T_base) > DISTINCT
            || chain.tool_parameter_count() == 6 && angle(&first.tool, &other.tool) > DISTINCT
    };
    let ambiguous = minima[1..].iter().any(|(other, c)| *c <= AS_GOOD * cost + floor && differs(other));
    Ok((first.clone(), ambiguous))
}

/// Point of a reflector in the flange from its measured positions; the pose of the robot in the
/// measuring system is unknown too: m = W (R t + p).
///
/// # Errors
/// Fails if orientations differ about one axis only, and if the points are on a line.
pub fn reflector(poses: &[Pose], points: &[Vector], stated: &Stated) -> Result<Reflector, CellFault> {
    let needed = 4;
    if poses.len() < needed {
        return Err(CellFault::TooFew { needed, readings: poses.len() });
    }
    check_orientations(poses)?;
    check_points(points)?;
    let measured: Vec<MeasuredPose> = points.iter().map(|p| MeasuredPose::Position(*p)).collect();
    let (tool, world_T_base) = (Pose::identity(), Pose::identity());
    let (start, ambiguous) = best(&Chain { poses, measured: &measured, stated, tool, world_T_base })?;
    let solved = solve(start, stated).ok_or(CellFault::Undetermined)?;
    let at = [3, 4, 5, 6, 7, 8];
    Ok(Reflector {
        tool: CellPoint {
            at_mm: solved.model.tool.translation_mm,
            covariance_mm2: part(&solved.covariance, [0, 1, 2]),
        },
        world_T_base: CellFrame { pose: solved.model.world_T_base, covariance: part(&solved.covariance, at) },
        ambiguous,
        quality: solved.quality,
    })
}

/// Hand-eye calibration from poses of the flange in the base and measured poses: of the target on
/// the robot in the measuring system, or of the standing target in the sensor on the robot.
///
/// # Errors
/// Fails if orientations differ about one axis only: the translation along it is then open.
pub fn hand_eye(poses: &[Pose], measured: &[Pose], mounting: Mounting, stated: &Stated) -> Result<HandEye, CellFault> {
    let needed = 3;
    if poses.len() < needed {
        return Err(CellFault::TooFew { needed, readings: poses.len() });
    }
    check_orientations(poses)?;
    let sensor = mounting == Mounting::Sensor;
    let poses: Vec<Pose> = poses.iter().map(|p| if sensor { p.inverse() } else { *p }).collect();
    let measured: Vec<MeasuredPose> = measured.iter().map(|m| MeasuredPose::Pose(*m)).collect();
    let (tool, world_T_base) = (Pose::identity(), Pose::identity());
    let (start, ambiguous) = best(&Chain { poses: &poses, measured: &measured, stated, tool, world_T_base })?;
    let solved = solve(start, stated).ok_or(CellFault::Undetermined)?;
    let frame = |pose: Pose, first: usize| CellFrame {
        pose,
        covariance: part(&solved.covariance, std::array::from_fn(|k| first + k)),
    };
    let (tool, world) = (frame(solved.model.tool, 0), frame(solved.model.world_T_base, 6));
    // with the sensor on the robot the chain is hand_T_flange · flange_T_base · base_T_target
    let (hand, other) = if sensor { (world.inverse(), tool) } else { (tool, world.inverse()) };
    Ok(HandEye { flange_T_hand: hand, base_T_world: other, ambiguous, quality: solved.quality })
}
