//! Conditions: what else than its position was observed of a target, at a pose or of fixed points alone.
//!
//! A condition is an equation between the place of a target, which the robot gives, and things that are fixed in the world: the
//! orientation of a body, a socket, a point from which a distance is measured, a plane. Of these the robot's list of parameters
//! has the unknowns behind its own ([`Fixture`]).

use super::{Observation, ResidualKind, Settings, Status};
use crate::base::message::{Message, Result};
use crate::base::pose::{Pose, Vector, dot, minus, norm, turning_axes, unit};
use crate::base::pose_name::PoseName;
use crate::math::robots::{FreeBase, Parameter, Quantity, Robot, Role};
use nalgebra::{Matrix3, Vector3};
use std::ops::Range;

/// What was observed of a target at a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Joint values in mm or rad, in the robot's order.
    pub joints: Vec<f64>,
    /// Index of the target.
    pub target: usize,
    /// What was observed.
    pub kind: Kind,
    /// Standard uncertainty of each of its residuals, mm or rad.
    pub standard_uncertainty: f64,
}

/// Kinds of conditions, with the indices of the first of the parameters of what they refer to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The body that carries the target is oriented so in the world; three parameters are the rotation vector that turns the flange
    /// to the body. Residuals: the rotation vector from the observed orientation to the model's, rad.
    Orientation {
        /// The body in the world, by its rotation alone.
        world_T_body: Pose,
        /// First parameter of the rotation vector.
        mounting: usize,
    },
    /// One coordinate of the target in the world, as a dial gauge gives it. Residual: mm.
    Coordinate {
        /// 0, 1 or 2 for x, y or z.
        axis: usize,
        /// The coordinate.
        at_mm: f64,
    },
    /// Distance to a fixed point. Residual: mm.
    Distance {
        /// First of the three coordinates of the point.
        to: usize,
        /// The distance.
        distance_mm: f64,
    },
    /// The target lies in a socket. Residuals: the three coordinates of the target less those of the socket, mm.
    Contact {
        /// First of the three coordinates of the socket.
        socket: usize,
    },
    /// The target touches a plane, its centre `offset_mm` along the normal from it: the radius of a ball. Residual: mm.
    Plane {
        /// First of the three parameters of the plane: two slopes, and where it meets its axis.
        plane: usize,
        /// The axis of the world, 0, 1 or 2, that is nearest to its normal.
        axis: usize,
        /// Distance of the target from the plane, positive along the axis.
        offset_mm: f64,
    },
}

/// What is known of fixed points beside the observations of targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// Their place in the world.
    Place {
        /// First of the three coordinates of the point.
        point: usize,
        /// The place, mm.
        place_mm: Vector,
        /// Standard uncertainty of a coordinate, mm.
        standard_uncertainty_mm: f64,
    },
    /// Their distance from each other.
    Distance {
        /// First coordinate of one point.
        from: usize,
        /// First coordinate of the other.
        to: usize,
        /// The distance.
        distance_mm: f64,
        /// Its standard uncertainty.
        standard_uncertainty_mm: f64,
    },
}

impl Kind {
    /// Number of residuals.
    pub fn rows(&self) -> usize {
        match self {
            Self::Orientation { .. } | Self::Contact { .. } => 3,
            Self::Coordinate { .. } | Self::Distance { .. } | Self::Plane { .. } => 1,
        }
    }

    /// Parameters of what it refers to.
    pub(super) fn unknowns(&self) -> Option<Range<usize>> {
        let first = match *self {
            Self::Orientation { mounting: first, .. }
            | Self::Distance { to: first, .. }
            | Self::Contact { socket: first }
            | Self::Plane { plane: first, .. } => first,
            Self::Coordinate { .. } => return None,
        };
        Some(first..first + 3)
    }

    /// Whether residuals are angles.
    pub fn is_angle(&self) -> bool {
        matches!(self, Self::Orientation { .. })
    }
}

/// Coordinates of the point whose first parameter is `first`.
pub(super) fn point(values: &[f64], first: usize) -> Vector {
    [values[first], values[first + 1], values[first + 2]]
}

/// The plane of its three parameters: a normal (towards its axis, not of length one), and where it meets the axis.
fn plane(values: &[f64], first: usize, axis: usize) -> (Vector, Vector) {
    let mut normal = [0.0; 3];
    normal[axis] = 1.0;
    normal[(axis + 1) % 3] = -values[first].tan();
    normal[(axis + 2) % 3] = -values[first + 1].tan();
    let mut foot = [0.0; 3];
    foot[axis] = values[first + 2];
    (normal, foot)
}

impl Condition {
    /// Writes its residuals over their standard uncertainties; `position` is that of the target at `values`.
    pub(super) fn residuals(&self, arm: Option<&dyn FreeBase>, values: &[f64], position: Vector, out: &mut [f64]) {
        match self.kind {
            Kind::Orientation { world_T_body, mounting } => {
                let turned = arm.map(|arm| {
                    let body =
                        arm.flange(values, &self.joints).then(&Pose::from_rotation_vector(point(values, mounting)));
                    body.then(&world_T_body.inverse()).rotation_vector_rad()
                });
                out.copy_from_slice(&turned.unwrap_or_default());
            }
            Kind::Coordinate { axis, at_mm } => out[0] = position[axis] - at_mm,
            Kind::Distance { to, distance_mm } => out[0] = norm(minus(position, point(values, to))) - distance_mm,
            Kind::Contact { socket } => out.copy_from_slice(&minus(position, point(values, socket))),
            Kind::Plane { plane: first, axis, offset_mm } => {
                let (normal, foot) = plane(values, first, axis);
                out[0] = dot(normal, minus(position, foot)) / norm(normal) - offset_mm;
            }
        }
        out.iter_mut().for_each(|r| *r /= self.standard_uncertainty);
    }

    /// What was observed minus what the model with `values` predicts, in the world: mm, of an orientation rad as a rotation vector. Of
    /// a distance it lies along it, of a plane along its normal.
    pub fn error(&self, robot: &dyn Robot, values: &[f64]) -> Vector {
        let position = robot.position(values, &self.joints, self.target);
        let mut left = [0.0; 3];
        self.residuals(robot.free_base(), values, position, &mut left[..self.kind.rows()]);
        let left = left.map(|r| -r * self.standard_uncertainty);
        let along = |direction: Vector| unit(direction).unwrap_or_default().map(|v| v * left[0]);
        match self.kind {
            Kind::Orientation { .. } | Kind::Contact { .. } => left,
            Kind::Coordinate { axis, .. } => [0, 1, 2].map(|i| if i == axis { left[0] } else { 0.0 }),
            Kind::Distance { to, .. } => along(minus(position, point(values, to))),
            Kind::Plane { plane: first, axis, .. } => along(plane(values, first, axis).0),
        }
    }

    /// Writes their derivatives by all parameters, row by row; `moved` has those of the target's position, three rows.
    pub(super) fn jacobian(
        &self,
        arm: Option<&dyn FreeBase>,
        values: &[f64],
        position: Vector,
        moved: &[f64],
        out: &mut [f64],
    ) {
        let n = values.len();
        out.fill(0.0);
        match self.kind {
            Kind::Orientation { mounting, .. } => {
                let Some(arm) = arm else { return };
                let mut left = [0.0; 3];
                self.residuals(Some(arm), values, position, &mut left);
                let axes = turning_axes(left.map(|v| v * self.standard_uncertainty));
                let back = Matrix3::from_fn(|i, k| axes[k][i]).try_inverse().unwrap_or_else(Matrix3::identity);
                let mut turns = vec![0.0; 3 * n];
                arm.flange_turns(values, &self.joints, &mut turns);
                let flange = arm.flange(values, &self.joints);
                for (k, axis) in turning_axes(point(values, mounting)).into_iter().enumerate() {
                    let axis = flange.rotate(axis);
                    (0..3).for_each(|i| turns[i * n + mounting + k] += axis[i]);
                }
                for j in 0..n {
                    let turn = back * Vector3::new(turns[j], turns[n + j], turns[2 * n + j]);
                    (0..3).for_each(|i| out[i * n + j] = turn[i]);
                }
            }
            Kind::Coordinate { axis, .. } => out.copy_from_slice(&moved[axis * n..][..n]),
            Kind::Distance { to, .. } => {
                let along = unit(minus(position, point(values, to))).unwrap_or_default();
                (0..n).for_each(|j| out[j] = (0..3).map(|i| along[i] * moved[i * n + j]).sum());
                (0..3).for_each(|i| out[to + i] -= along[i]);
            }
            Kind::Contact { socket } => {
                out.copy_from_slice(moved);
                (0..3).for_each(|i| out[i * n + socket + i] -= 1.0);
            }
            Kind::Plane { plane: first, axis, .. } => {
                let (normal, foot) = plane(values, first, axis);
                let (length, lever) = (norm(normal), minus(position, foot));
                (0..n).for_each(|j| out[j] = (0..3).map(|i| normal[i] * moved[i * n + j]).sum::<f64>() / length);
                for k in 0..2 {
                    let i = (axis + 1 + k) % 3;
                    // of dot(normal, lever) / length by the component i of the normal, and of that by the slope
                    let by_component = lever[i] / length - dot(normal, lever) * normal[i] / length.powi(3);
                    out[first + k] -= by_component * (1.0 + values[first + k].tan().powi(2));
                }
                out[first + 2] -= normal[axis] / length;
            }
        }
        out.iter_mut().for_each(|d| *d /= self.standard_uncertainty);
    }
}

impl Known {
    /// First coordinates of the points.
    pub(super) fn points(&self) -> Vec<usize> {
        match *self {
            Self::Place { point, .. } => vec![point],
            Self::Distance { from, to, .. } => vec![from, to],
        }
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        match self {
            Self::Place { .. } => 3,
            Self::Distance { .. } => 1,
        }
    }

    /// Writes its residuals at all parameters.
    pub(super) fn residuals(&self, values: &[f64], out: &mut [f64]) {
        match *self {
            Self::Place { point: at, place_mm, standard_uncertainty_mm } => {
                out.copy_from_slice(&minus(point(values, at), place_mm).map(|v| v / standard_uncertainty_mm));
            }
            Self::Distance { from, to, distance_mm, standard_uncertainty_mm } => {
                out[0] = (norm(minus(point(values, to), point(values, from))) - distance_mm) / standard_uncertainty_mm;
            }
        }
    }

    /// Writes their derivatives by all parameters, row by row.
    pub(super) fn jacobian(&self, values: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        let n = values.len();
        match *self {
            Self::Place { point: at, standard_uncertainty_mm, .. } => {
                (0..3).for_each(|i| out[i * n + at + i] = 1.0 / standard_uncertainty_mm);
            }
            Self::Distance { from, to, standard_uncertainty_mm, .. } => {
                let along = unit(minus(point(values, to), point(values, from))).unwrap_or_default();
                for (i, along) in along.into_iter().enumerate() {
                    out[to + i] += along / standard_uncertainty_mm;
                    out[from + i] -= along / standard_uncertainty_mm;
                }
            }
        }
    }
}

/// What conditions add to the parameters of a robot, by name.
#[derive(Clone, Copy, Debug)]
pub enum Fixture<'a> {
    /// A point that is fixed in the world: a socket, the end of a ball bar. Parameters `NAME_x`, `NAME_y`, `NAME_z`.
    Point(&'a str),
    /// The orientation on the flange of the body that carries a target: `TARGET_rx`, `TARGET_ry`, `TARGET_rz`, a rotation vector.
    Mounting(&'a str),
    /// A plane with its normal near axis 0, 1 or 2 of the world: for the z axis `NAME_slope_x`, `NAME_slope_y`, `NAME_z`: angles of its
    /// traces in the planes through z, and where it meets z. Cyclic for the others.
    Plane(&'a str, usize),
}

impl Fixture<'_> {
    /// Adds the three parameters to those of `robot`, where it does not have them yet, and gives the index of the first.
    pub fn add_to(self, robot: &mut dyn Robot) -> usize {
        const AXES: [&str; 3] = ["x", "y", "z"];
        use Quantity::{Angle, Length};
        let names = match self {
            Self::Point(name) => AXES.map(|axis| (format!("{name}_{axis}"), Length, Role::Fixture)),
            Self::Mounting(target) => AXES.map(|axis| (format!("{target}_r{axis}"), Angle, Role::Target)),
            Self::Plane(name, axis) => {
                let slope = |k: usize| (format!("{name}_slope_{}", AXES[(axis + k) % 3]), Angle, Role::Fixture);
                [slope(1), slope(2), (format!("{name}_{}", AXES[axis]), Length, Role::Fixture)]
            }
        };
        if let Some(first) = robot.index(&names[0].0) {
            return first;
        }
        let all = &mut robot.definition_mut().parameters;
        all.extend(names.into_iter().map(|(name, quantity, role)| Parameter {
            tolerance: f64::INFINITY,
            ..Parameter::new(name, quantity, role, 0.0)
        }));
        all.len() - 3
    }
}

/// Whether anything is measured in a world that is not the robot's own base frame.
pub(super) fn tied_to_world(observations: &[Observation], settings: &Settings) -> bool {
    observations.iter().any(|o| o.targets.iter().any(Option::is_some))
        || settings.conditions.iter().any(|c| matches!(c.kind, Kind::Orientation { .. } | Kind::Coordinate { .. }))
        || settings.known.iter().any(|k| matches!(k, Known::Place { .. }))
}

/// A warning where nothing that was observed contains a length: a robot of twice the size fits as well.
pub(super) fn without_length(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    status: &[Status],
) -> Option<Message> {
    let contains = |c: &Condition| match c.kind {
        Kind::Distance { .. } | Kind::Coordinate { .. } => true,
        Kind::Plane { offset_mm, .. } => offset_mm != 0.0,
        Kind::Orientation { .. } | Kind::Contact { .. } => false,
    };
    // one place alone is an origin, not a length
    let places = settings.known.iter().filter(|k| matches!(k, Known::Place { .. })).count();
    let has_length = observations.iter().any(|o| o.targets.iter().any(Option::is_some))
        || settings.conditions.iter().any(contains)
        || places > 1
        || settings.known.iter().any(|k| matches!(k, Known::Distance { .. }));
    if has_length {
        return None;
    }
    let held = robot.parameters().iter().zip(status).filter(|(p, s)| {
        p.quantity == Quantity::Length && p.role == Role::Robot && **s != Status::Identified && p.nominal != 0.0
    });
    let lengths: Vec<String> = held.map(|(p, _)| format!("`{}` = {} mm", p.name, p.nominal)).collect();
    let what = "nothing that was observed contains a length: the scale of the robot is that of its nominal lengths";
    let message = Message::warning(match lengths.is_empty() {
        true => what.to_owned(),
        false => format!("{what} that are held, {}", lengths.join(", ")),
    });
    Some(message.hint("measure a distance: between two sockets, to a fixed point, or the position of a target"))
}

/// An error where conditions are for another robot or other residuals.
pub(super) fn check(robot: &dyn Robot, settings: &Settings) -> Result<()> {
    if settings.conditions.is_empty() && settings.known.is_empty() {
        return Ok(());
    }
    let coordinates = settings.conditions.iter().all(|c| matches!(c.kind, Kind::Coordinate { .. }));
    if robot.free_base().is_none() && !(coordinates && settings.known.is_empty() && !robot.has_assembly_modes()) {
        let what =
            format!("orientations, distances, contacts and planes are for arms in space, not for `{}`", robot.model());
        return Err(Message::error(what).hint("give positions of its targets: rows of kind `point`").into());
    }
    if settings.kind == ResidualKind::Pose || settings.common_uncertainty_mm.is_some() {
        let what =
            "orientations, distances, contacts and planes go with residuals of targets, without a common uncertainty";
        return Err(Message::error(what).into());
    }
    if settings.standard_uncertainty_mm.is_none() {
        return Err(Message::error("observations of several kinds need the standard uncertainty of a coordinate")
            .hint("state it (--standard-uncertainty-um)")
            .into());
    }
    Ok(())
}
