//! Conditions: what else than its position was observed of a target, at a pose or of fixed points alone.
//!
//! A condition is an equation between the place of a target, which the robot gives, and things that are fixed in the world: the
//! orientation of a body, a socket, a point from which a distance is measured, a plane, a line, a sphere. Of these the robot's list of parameters
//! has the unknowns behind its own ([`Fixture`]).

use super::surface::Surface;
use super::{Observation, ResidualKind, Settings, Status};
use crate::{Error, Result};
use etalon_base::message::Message;
use etalon_base::pose::{Pose, Vector, cross, minus, norm, turning_axes, unit};
use etalon_base::pose_name::PoseName;
use etalon_robots::{FreeBase, Parameter, Quantity, Robot, Role, meaning};
use nalgebra::{Matrix3, Vector3};

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
    /// The target as another station of the instrument measures it. Residuals: its three coordinates less those of what is seen, mm.
    Seen {
        /// First of the six parameters of the station: its pose in the world.
        station: usize,
        /// Where the station has it, mm.
        at_mm: Vector,
    },
    /// The target is on a surface or line, or, of a plane or sphere, its centre `offset_mm` outside of it: the radius of a ball. Residuals: mm.
    On {
        /// What it touches.
        surface: Surface,
        /// The parameters of that.
        unknowns: [usize; 4],
        /// Distance of the target from it, positive along the axis of a plane, and outside of a sphere.
        offset_mm: f64,
    },
    /// The value of a joint as it is: of a home switch, or a second encoder. Residual: the joint's value by the model, with what its gain,
    /// offset and other errors add to the logged one, less this, mm or rad.
    Joint {
        /// Index of the joint.
        joint: usize,
        /// The value.
        value: f64,
        /// Whether it is an angle.
        is_angle: bool,
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
    /// A point as another station of the instrument measures it.
    Seen {
        /// First of the six parameters of the station: its pose in the world.
        station: usize,
        /// First of the three coordinates of the point.
        point: usize,
        /// Where the station has it, mm.
        at_mm: Vector,
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
    /// A place on a surface or line.
    On {
        /// What it is on.
        surface: Surface,
        /// The parameters of that.
        unknowns: [usize; 4],
        /// The place, mm.
        place_mm: Vector,
        /// Standard uncertainty of its distance from it, mm.
        standard_uncertainty_mm: f64,
    },
    /// The radius of a sphere.
    Length {
        /// Its parameter.
        parameter: usize,
        /// The length.
        length_mm: f64,
        /// Its standard uncertainty.
        standard_uncertainty_mm: f64,
    },
}

impl Kind {
    /// Number of residuals.
    pub fn rows(&self) -> usize {
        match self {
            Self::Orientation { .. } | Self::Contact { .. } | Self::Seen { .. } => 3,
            Self::Coordinate { .. } | Self::Distance { .. } | Self::Joint { .. } => 1,
            Self::On { surface, .. } => surface.rows(),
        }
    }

    /// Parameters of what it refers to.
    pub(super) fn unknowns(&self) -> Vec<usize> {
        match *self {
            Self::Orientation { mounting: first, .. }
            | Self::Distance { to: first, .. }
            | Self::Contact { socket: first } => (first..first + 3).collect(),
            Self::Seen { station, .. } => (station..station + 6).collect(),
            Self::On { surface, unknowns, .. } => unknowns[..surface.unknowns()].to_vec(),
            Self::Coordinate { .. } | Self::Joint { .. } => Vec::new(),
        }
    }

    /// Whether residuals are angles.
    pub fn is_angle(&self) -> bool {
        matches!(self, Self::Orientation { .. } | Self::Joint { is_angle: true, .. })
    }

    /// Whether it is about the orientation of a body.
    pub fn is_orientation(&self) -> bool {
        matches!(self, Self::Orientation { .. })
    }
}

/// Coordinates of the point whose first parameter is `first`.
pub(super) fn point(values: &[f64], first: usize) -> Vector {
    [values[first], values[first + 1], values[first + 2]]
}

/// Values of the parameters of a surface.
fn of(values: &[f64], unknowns: [usize; 4]) -> [f64; 4] {
    unknowns.map(|i| values[i])
}

/// Pose in the world of the station whose first parameter is `first`.
pub(super) fn station_pose(values: &[f64], first: usize) -> Pose {
    Pose { translation_mm: point(values, first), ..Pose::from_rotation_vector(point(values, first + 3)) }
}

/// Takes from three rows of derivatives those of where a station puts `at_mm`.
fn less_station(values: &[f64], station: usize, at_mm: Vector, rows: &mut [f64]) {
    let n = values.len();
    let lever = station_pose(values, station).rotate(at_mm);
    for (k, axis) in turning_axes(point(values, station + 3)).into_iter().enumerate() {
        rows[k * n + station + k] -= 1.0;
        let turned = cross(axis, lever);
        (0..3).for_each(|i| rows[i * n + station + 3 + k] -= turned[i]);
    }
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
            Kind::Seen { station, at_mm } => {
                out.copy_from_slice(&minus(position, station_pose(values, station).apply(at_mm)));
            }
            Kind::On { surface, unknowns, offset_mm } => {
                let distances = surface.residuals(position, of(values, unknowns));
                out.iter_mut().zip(distances).for_each(|(out, distance)| *out = distance - offset_mm);
            }
            Kind::Joint { joint, value, .. } => {
                let model = arm.and_then(|arm| arm.joint_value(values, &self.joints, joint, &mut |_, _| ()));
                out[0] = model.unwrap_or(f64::NAN) - value;
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
        match self.kind {
            Kind::Orientation { .. } | Kind::Contact { .. } | Kind::Seen { .. } | Kind::Joint { .. } => left,
            Kind::Coordinate { axis, .. } => [0, 1, 2].map(|i| if i == axis { left[0] } else { 0.0 }),
            Kind::Distance { to, .. } => {
                unit(minus(position, point(values, to))).unwrap_or_default().map(|v| v * left[0])
            }
            Kind::On { surface, unknowns, .. } => {
                let [first, second] = surface.gradients(position, of(values, unknowns));
                std::array::from_fn(|i| first[i] * left[0] + second[i] * left[1])
            }
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
            Kind::Seen { station, at_mm } => {
                out.copy_from_slice(moved);
                less_station(values, station, at_mm, out);
            }
            Kind::On { surface, unknowns, .. } => {
                let gradients = surface.gradients(position, of(values, unknowns));
                for (row, by) in out.chunks_exact_mut(n).zip(gradients) {
                    (0..n).for_each(|j| row[j] = (0..3).map(|i| by[i] * moved[i * n + j]).sum());
                    unknowns.iter().zip(&by[3..]).take(surface.unknowns()).for_each(|(&j, by)| row[j] += by);
                }
            }
            Kind::Joint { joint, .. } => {
                let Some(arm) = arm else { return };
                arm.joint_value(values, &self.joints, joint, &mut |parameter, by| out[parameter] += by);
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
            Self::Seen { station, point, .. } => vec![station, point],
            Self::On { unknowns, .. } => vec![unknowns[0]],
            Self::Length { parameter, .. } => vec![parameter],
        }
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        match self {
            Self::Place { .. } | Self::Seen { .. } => 3,
            Self::Distance { .. } | Self::Length { .. } => 1,
            Self::On { surface, .. } => surface.rows(),
        }
    }

    /// Writes its residuals at all parameters.
    pub(super) fn residuals(&self, values: &[f64], out: &mut [f64]) {
        match *self {
            Self::Place { point: at, place_mm, standard_uncertainty_mm } => {
                out.copy_from_slice(&minus(point(values, at), place_mm).map(|v| v / standard_uncertainty_mm));
            }
            Self::Seen { station, point: seen, at_mm, standard_uncertainty_mm } => {
                let off = minus(point(values, seen), station_pose(values, station).apply(at_mm));
                out.copy_from_slice(&off.map(|v| v / standard_uncertainty_mm));
            }
            Self::Distance { from, to, distance_mm, standard_uncertainty_mm } => {
                out[0] = (norm(minus(point(values, to), point(values, from))) - distance_mm) / standard_uncertainty_mm;
            }
            Self::On { surface, unknowns, place_mm, standard_uncertainty_mm } => {
                let distances = surface.residuals(place_mm, of(values, unknowns));
                out.iter_mut().zip(distances).for_each(|(out, d)| *out = d / standard_uncertainty_mm);
            }
            Self::Length { parameter, length_mm, standard_uncertainty_mm } => {
                out[0] = (values[parameter] - length_mm) / standard_uncertainty_mm;
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
            Self::Seen { station, point, at_mm, standard_uncertainty_mm } => {
                (0..3).for_each(|i| out[i * n + point + i] = 1.0);
                less_station(values, station, at_mm, out);
                out.iter_mut().for_each(|d| *d /= standard_uncertainty_mm);
            }
            Self::Distance { from, to, standard_uncertainty_mm, .. } => {
                let along = unit(minus(point(values, to), point(values, from))).unwrap_or_default();
                for (i, along) in along.into_iter().enumerate() {
                    out[to + i] += along / standard_uncertainty_mm;
                    out[from + i] -= along / standard_uncertainty_mm;
                }
            }
            Self::On { surface, unknowns, place_mm, standard_uncertainty_mm } => {
                let gradients = surface.gradients(place_mm, of(values, unknowns));
                for (row, by) in out.chunks_exact_mut(n).zip(gradients) {
                    let by = unknowns.iter().zip(&by[3..]).take(surface.unknowns());
                    by.for_each(|(&j, by)| row[j] += by / standard_uncertainty_mm);
                }
            }
            Self::Length { parameter, standard_uncertainty_mm, .. } => out[parameter] = 1.0 / standard_uncertainty_mm,
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
    /// A plane, with its axis: for the z axis `NAME_slope_x`, `NAME_slope_y`, `NAME_z`: angles of its traces in the planes through z, and
    /// where it meets z. Cyclic for the others.
    Plane(&'a str, usize),
    /// A line, with its axis: for the z axis `NAME_slope_x`, `NAME_slope_y`: its angles against z in the planes through z; `NAME_x`, `NAME_y`:
    /// where it meets z = 0.
    Line(&'a str, usize),
    /// The pose in the world of another station of the instrument: `NAME_x`, `NAME_y`, `NAME_z`, and a rotation vector `NAME_rx`, `NAME_ry`,
    /// `NAME_rz`.
    Station(&'a str),
    /// The radius of a sphere: `NAME_radius`. Its centre is a point.
    Radius(&'a str),
}

const STATION: &str = meaning(
    "Pose in the world of another station of the instrument: its origin, and its orientation as a rotation vector.",
);

impl Fixture<'_> {
    /// Adds its parameters to those of `robot`, where it does not have them yet, and gives the index of the first.
    pub fn add_to(self, robot: &mut dyn Robot) -> usize {
        const AXES: [&str; 3] = ["x", "y", "z"];
        use Quantity::{Angle, Length};
        let slope = |name, axis, k: usize| (format!("{name}_slope_{}", AXES[(axis + k) % 3]), Angle, Role::Fixture);
        let along = |name, axis: usize| (format!("{name}_{}", AXES[axis % 3]), Length, Role::Fixture);
        let names = match self {
            Self::Point(name) => (0..3).map(|axis| along(name, axis)).collect(),
            Self::Mounting(target) => AXES.map(|axis| (format!("{target}_r{axis}"), Angle, Role::Target)).to_vec(),
            Self::Plane(name, axis) => vec![slope(name, axis, 1), slope(name, axis, 2), along(name, axis)],
            Self::Line(name, axis) => {
                vec![slope(name, axis, 1), slope(name, axis, 2), along(name, axis + 1), along(name, axis + 2)]
            }
            Self::Station(name) => {
                let turns = AXES.map(|axis| (format!("{name}_r{axis}"), Angle, Role::Fixture));
                (0..3).map(|axis| along(name, axis)).chain(turns).collect()
            }
            Self::Radius(name) => vec![(format!("{name}_radius"), Length, Role::Fixture)],
        };
        if let Some(first) = robot.index(&names[0].0) {
            return first;
        }
        let all = &mut robot.definition_mut().parameters;
        let first = all.len();
        all.extend(names.into_iter().map(|(name, quantity, role)| Parameter {
            tolerance: f64::INFINITY,
            ..Parameter::new(name, quantity, role, 0.0)
        }));
        if let Self::Station(_) = self {
            all[first..].iter_mut().for_each(|p| p.meaning = STATION);
        }
        first
    }
}

/// Whether anything is measured in a world that is not the robot's own base frame.
pub(super) fn tied_to_world(observations: &[Observation], settings: &Settings) -> bool {
    observations.iter().any(|o| o.targets.iter().any(Option::is_some))
        || settings.conditions.iter().any(|c| matches!(c.kind, Kind::Orientation { .. } | Kind::Coordinate { .. }))
        || settings.known.iter().any(|k| matches!(k, Known::Place { .. } | Known::On { .. }))
}

/// A warning where nothing that was observed contains a length: a robot of twice the size fits as well.
pub(super) fn without_length(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    status: &[Status],
) -> Option<Message> {
    let contains = |c: &Condition| match c.kind {
        Kind::Distance { .. } | Kind::Coordinate { .. } | Kind::Seen { .. } => true,
        Kind::On { surface: Surface::Plane { .. }, offset_mm, .. } => offset_mm != 0.0,
        Kind::Joint { is_angle, .. } => !is_angle,
        Kind::Orientation { .. } | Kind::Contact { .. } | Kind::On { .. } => false,
    };
    // one place alone is an origin, not a length
    let places = settings.known.iter().filter(|k| matches!(k, Known::Place { .. } | Known::On { .. })).count();
    let has_length = observations.iter().any(|o| o.targets.iter().any(Option::is_some))
        || settings.conditions.iter().any(contains)
        || places > 1
        || settings.known.iter().any(|k| matches!(k, Known::Distance { .. } | Known::Length { .. }));
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
        return Err(Error::NotAnArm { model: robot.model().to_owned() });
    }
    if settings.kind == ResidualKind::Pose || settings.common_uncertainty_mm.is_some() {
        let what = "orientations, distances, contacts, surfaces and joints go with residuals of targets, without a common uncertainty";
        return Err(Message::error(what).into());
    }
    if settings.standard_uncertainty_mm.is_none() {
        return Err(Error::KindsWithoutUncertainty);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_robots::{Serial, SerialJoint};

    #[test]
    fn the_jacobian_of_every_kind_is_the_numeric_derivative() {
        let joint = |&[alpha_rad, a_mm, theta_rad, d_mm]: &[f64; 4]| SerialJoint {
            alpha_rad,
            a_mm,
            theta_rad,
            d_mm,
            prismatic: false,
            parallel: alpha_rad == 0.0 && a_mm > 0.0,
        };
        let table = [[0.0, 0.0, 0.0, 290.0], [-1.5, 0.0, -1.5, 0.0], [0.0, 270.0, 0.0, 0.0], [-1.5, 70.0, 0.0, 302.0]];
        let joints: Vec<SerialJoint> = table.iter().map(joint).collect();
        let mut robot = Serial::new(&joints, &["ball".to_owned()], [0.0, 0.0, -1.0], &[2, 3], &[(4, 3)]);
        let mut noise = Noise::new(18, 3);
        let socket = Fixture::Point("s").add_to(&mut robot);
        let (plane, line) = (Fixture::Plane("p", 1).add_to(&mut robot), Fixture::Line("l", 2).add_to(&mut robot));
        let radius = Fixture::Radius("s").add_to(&mut robot);
        let mounting = Fixture::Mounting("ball").add_to(&mut robot);
        let station = Fixture::Station("t").add_to(&mut robot);
        let from = |first: usize, last: usize| [first, first + 1, first + 2, last];
        let kinds = [
            Kind::Orientation { world_T_body: Pose::from_rotation_vector([0.3, -0.8, 1.1]), mounting },
            Kind::Coordinate { axis: 1, at_mm: 12.0 },
            Kind::Distance { to: socket, distance_mm: 300.0 },
            Kind::Contact { socket },
            Kind::Seen { station, at_mm: [800.0, -300.0, 500.0] },
            Kind::On { surface: Surface::Plane { axis: 1 }, unknowns: from(plane, plane + 2), offset_mm: 3.0 },
            Kind::On { surface: Surface::Line { axis: 2 }, unknowns: from(line, line + 3), offset_mm: 0.0 },
            Kind::On { surface: Surface::Sphere, unknowns: from(socket, radius), offset_mm: 3.0 },
            Kind::Joint { joint: 2, value: 0.7, is_angle: true },
            Kind::Joint { joint: 3, value: -0.2, is_angle: true },
        ];
        let n = robot.parameters().len();
        let random =
            |p: &Parameter| p.nominal + if p.quantity == Quantity::Length { 40.0 } else { 0.2 } * noise.uniform(1.0);
        let values: Vec<f64> = robot.parameters().iter().map(random).collect();
        for kind in kinds {
            let joints = vec![0.3, -0.7, 0.5, 1.2];
            let c = Condition { pose: 1.into(), cycle: 1, joints, target: 0, kind, standard_uncertainty: 0.5 };
            let left = |values: &[f64]| {
                let mut out = [0.0; 3];
                let at = robot.position(values, &c.joints, 0);
                c.residuals(robot.free_base(), values, at, &mut out[..kind.rows()]);
                out
            };
            let (mut moved, mut exact) = (vec![0.0; 3 * n], vec![0.0; kind.rows() * n]);
            robot.jacobian(&values, &c.joints, &mut moved);
            c.jacobian(robot.free_base(), &values, robot.position(&values, &c.joints, 0), &moved, &mut exact);
            assert!(exact.iter().any(|d| *d != 0.0), "{kind:?}");
            for j in 0..n {
                let h = if robot.parameters()[j].quantity == Quantity::Length { 1e-3 } else { 1e-5 };
                let moved = |by: f64| {
                    let mut values = values.clone();
                    values[j] += by;
                    left(&values)
                };
                let (plus, minus) = (moved(h), moved(-h));
                for i in 0..kind.rows() {
                    let numeric = (plus[i] - minus[i]) / (2.0 * h);
                    let off = (exact[i * n + j] - numeric).abs();
                    assert!(off < 1e-6 * (1.0 + numeric.abs()), "{kind:?} {}: {numeric}", robot.parameters()[j].name);
                }
            }
        }
    }
}
