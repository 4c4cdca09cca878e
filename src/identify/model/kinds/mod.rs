//! Conditions: observations of a target at a pose other than its position, one kind a module.
//!
//! A condition is an equation between the place of a target, which the robot gives, and things that
//! are fixed in the world: the orientation of a body, a socket, a point from which a distance is
//! measured, a plane, a line, a sphere. Of these the robot's list of parameters has the unknowns
//! behind its own ([`Fixture`](crate::Fixture)). To add a kind: its module with an [`Equation`],
//! and its line in [`Kind`].

mod between;
mod contact;
mod coordinate;
mod distance;
mod joint;
mod known;
mod orientation;
mod seen;
mod surface;

pub use between::{Between, Separation};
pub use contact::Contact;
pub use coordinate::Coordinate;
pub use distance::Distance;
pub use joint::JointValue;
pub use known::{Known, KnownResidual};
pub use orientation::{Orientation, mounted_misfit_rad, mounted_misfits_rad};
pub use seen::Seen;
pub use surface::{On, Surface};

pub(crate) use between::span;
pub(crate) use contact::locate_contacts;
pub(crate) use distance::trilaterate_points;
pub(crate) use known::places;
pub(crate) use orientation::mount;
pub(crate) use seen::{less_station, locate_stations, station_pose};
pub(crate) use surface::fit_surfaces;

use crate::{Error, Result};
use crate::{Observation, ResidualKind, Settings, Status};
use etalon_base::catalogue::IntoArgument;
use etalon_base::message::Message;
use etalon_base::pose::{Pose, Vector, centroid, minus};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, warning};
use etalon_fit::rotation_onto;
use etalon_robots::{FreeBase, Quantity, Robot, Role};

/// Observation of a target at a pose.
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
    /// Observed quantity.
    pub kind: Kind,
    /// Standard uncertainty of each of its residuals, mm or rad.
    pub standard_uncertainty: f64,
}

/// State at which a condition is evaluated.
pub(crate) struct At<'a> {
    /// The robot; some kinds need more than the position of the target.
    pub arm: Option<&'a dyn FreeBase>,
    /// Values of all parameters.
    pub values: &'a [f64],
    /// Joint values in mm or rad.
    pub joints: &'a [f64],
    /// Index of the target.
    pub target: usize,
    /// Position of the target at these joint values (mm).
    pub position: Vector,
    /// Standard uncertainty of each residual, mm or rad.
    pub standard_uncertainty: f64,
}

/// Equation of a kind of condition: its residuals and their derivatives.
pub(crate) trait Equation {
    /// Number of residuals.
    fn rows(&self) -> usize {
        1
    }

    /// Parameters to which the condition refers.
    fn unknowns(&self) -> Vec<usize> {
        Vec::new()
    }

    /// Writes the residuals, mm or rad.
    fn residuals(&self, at: &At, out: &mut [f64]);

    /// Writes the derivatives of the residuals with respect to all parameters into zeros, row by
    /// row; `moved` has the derivatives of the target's position, three rows.
    fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]);

    /// The residuals as a vector in the world.
    fn in_world(&self, _: &At, residuals: Vector) -> Vector {
        residuals
    }

    /// `true` if the residuals are angles.
    fn is_angle(&self) -> bool {
        false
    }

    /// Derivatives of the residuals by a common relative error of all measured lengths.
    fn by_scale(&self, _values: &[f64]) -> Vector {
        [0.0; 3]
    }

    /// `true` if the observation contains a length, which determines the scale of the robot.
    fn has_length(&self) -> bool {
        false
    }

    /// `true` if the observation is made in a world that is not the robot's own base frame.
    fn is_in_world(&self) -> bool {
        false
    }

    /// `true` if the residuals depend on the position of the target.
    fn depends_on_target(&self) -> bool {
        true
    }

    /// Other target on whose position the residuals depend, if any.
    fn other_target(&self) -> Option<usize> {
        None
    }

    /// Gaps between a target at `p` and its position by the condition, with their directions; empty
    /// if the condition does not give a position. `left` is the error of the contact.
    fn gaps(&self, _values: &[f64], _p: Vector, _left: Vector) -> Vec<(Vector, f64)> {
        Vec::new()
    }

    /// First unknown of the moving part on which the condition depends; `target` is that of the
    /// target.
    fn moving(&self, target: usize) -> Option<usize> {
        Some(target)
    }
}

/// Kind of a condition, with the indices of the first parameters to which it refers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Orientation of the body that carries the target.
    Orientation(Orientation),
    /// One coordinate of the target.
    Coordinate(Coordinate),
    /// Distance of the target from a fixed point.
    Distance(Distance),
    /// Contact of the target with a socket.
    Contact(Contact),
    /// Position of the target measured by another station.
    Seen(Seen),
    /// Position of the target on a surface or line.
    On(On),
    /// The value of a joint.
    Joint(JointValue),
    /// Place of the target relative to a target of another branch.
    Between(Between),
}

impl Kind {
    pub(crate) fn equation(&self) -> &dyn Equation {
        match self {
            Self::Orientation(kind) => kind,
            Self::Coordinate(kind) => kind,
            Self::Distance(kind) => kind,
            Self::Contact(kind) => kind,
            Self::Seen(kind) => kind,
            Self::On(kind) => kind,
            Self::Joint(kind) => kind,
            Self::Between(kind) => kind,
        }
    }

    /// Number of residuals.
    pub fn rows(&self) -> usize {
        self.equation().rows()
    }

    /// `true` if the residuals are angles.
    pub fn is_angle(&self) -> bool {
        self.equation().is_angle()
    }

    /// Gaps (mm) between a target at `p` and the point or surface that it touches up to an error
    /// `left`, each with its gradient with respect to `p`; empty if the target touches nothing.
    /// With another target, `p` is the vector from that target.
    pub fn gaps(&self, values: &[f64], p: Vector, left: Vector) -> Vec<(Vector, f64)> {
        self.equation().gaps(values, p, left)
    }

    /// Other target on whose position the residuals depend, if any.
    pub fn other_target(&self) -> Option<usize> {
        self.equation().other_target()
    }

    /// First parameter of the point or surface that the target touches, or from which its distance
    /// is measured.
    pub(crate) fn touched(&self) -> Option<usize> {
        match self {
            Self::Contact(kind) => Some(kind.socket),
            Self::Distance(kind) => Some(kind.to),
            Self::On(kind) => Some(kind.unknowns[0]),
            Self::Orientation(_) | Self::Coordinate(_) | Self::Seen(_) | Self::Joint(_) | Self::Between(_) => None,
        }
    }

    /// Replaces the point or surface that the target touches by the point or surface of another
    /// condition.
    pub(crate) fn touch(&mut self, other: &Self) {
        match (self, other) {
            (Self::On(kind), Self::On(other)) => (kind.surface, kind.unknowns) = (other.surface, other.unknowns),
            (Self::Contact(Contact { socket: point }) | Self::Distance(Distance { to: point, .. }), other) => {
                *point = other.touched().unwrap_or(*point);
            }
            _ => {}
        }
    }

    /// Measured point, if the condition has one.
    pub(crate) fn point_mm(&mut self) -> Option<&mut Vector> {
        match self {
            Self::Seen(seen) => Some(&mut seen.at_mm),
            _ => None,
        }
    }

    /// Measured lengths.
    pub(crate) fn lengths_mm(&mut self) -> impl Iterator<Item = &mut f64> {
        let all: Vec<&mut f64> = match self {
            Self::Coordinate(kind) => vec![&mut kind.at_mm],
            Self::Distance(kind) => vec![&mut kind.distance_mm],
            Self::Seen(kind) => kind.at_mm.iter_mut().collect(),
            Self::Between(Between { apart: Separation::Distance(distance_mm), .. }) => vec![distance_mm],
            Self::Joint(_) | Self::Orientation(_) | Self::Contact(_) | Self::On(_) | Self::Between(_) => Vec::new(),
        };
        all.into_iter()
    }

    /// `true` for the orientation of a body.
    pub fn is_orientation(&self) -> bool {
        matches!(self, Self::Orientation(_))
    }

    /// `true` for the orientation of a body in the world, which needs no pose of a station.
    pub fn is_world_orientation(&self) -> bool {
        matches!(self, Self::Orientation(Orientation { station: None, .. }))
    }
}

/// Weight that selects the shortest solution among equally good ones, for rows of size one.
const SHORTEST: f64 = 1e-6;

/// Coordinates of the point whose first parameter is `first`.
pub(crate) fn point(values: &[f64], first: usize) -> Vector {
    [values[first], values[first + 1], values[first + 2]]
}

/// Place of the target of a condition in the world.
fn place(arm: &dyn FreeBase, c: &Condition, values: &[f64]) -> Vector {
    arm.flange(values, &c.joints, c.target).apply(point(values, arm.target_place(c.target)))
}

/// The rigid motion from the first to the second point of each pair, by least squares.
pub(crate) fn onto(pairs: &[(Vector, Vector)]) -> Option<Pose> {
    let (from, to): (Vec<Vector>, Vec<Vector>) = pairs.iter().copied().unzip();
    let (here, there) = (centroid(&from)?, centroid(&to)?);
    let rotation = rotation_onto(pairs.iter().map(|(p, q)| (minus(*p, here), minus(*q, there))));
    let turn = Pose { rotation, translation_mm: [0.0; 3] };
    Some(Pose { translation_mm: minus(there, turn.rotate(here)), ..turn })
}

impl Condition {
    /// The condition evaluated at `values`, for the position `position` of the target.
    pub(crate) fn at<'a>(&'a self, arm: Option<&'a dyn FreeBase>, values: &'a [f64], position: Vector) -> At<'a> {
        let (joints, target) = (&self.joints[..], self.target);
        At { arm, values, joints, target, position, standard_uncertainty: self.standard_uncertainty }
    }

    /// Writes the residuals over their standard uncertainties.
    pub(crate) fn residuals(&self, at: &At, out: &mut [f64]) {
        self.kind.equation().residuals(at, out);
        out.iter_mut().for_each(|r| *r /= self.standard_uncertainty);
    }

    /// Predicted minus observed values (mm, rad) with all parameters `values`, and their number.
    pub(crate) fn residuals_at(&self, robot: &dyn Robot, values: &[f64]) -> (Vector, usize) {
        let at = self.at(robot.free_base(), values, robot.position(values, &self.joints, self.target));
        let (mut left, rows) = ([0.0; 3], self.kind.rows());
        self.kind.equation().residuals(&at, &mut left[..rows]);
        (left, rows)
    }

    /// Observed minus predicted values in the world (mm; for an orientation a rotation vector in
    /// rad). A distance deviates along its line, a plane along its normal.
    pub fn error(&self, robot: &dyn Robot, values: &[f64]) -> Vector {
        let at = self.at(robot.free_base(), values, robot.position(values, &self.joints, self.target));
        let mut left = [0.0; 3];
        self.kind.equation().residuals(&at, &mut left[..self.kind.rows()]);
        self.kind.equation().in_world(&at, left.map(|r| -r))
    }

    /// Writes the derivatives of the residuals with respect to all parameters, row by row; `moved`
    /// has the derivatives of the target's position, three rows.
    pub(crate) fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.kind.equation().jacobian(at, moved, out);
        out.iter_mut().for_each(|d| *d /= self.standard_uncertainty);
    }
}

/// `true` if a measurement refers to a world frame other than the robot's own base.
pub(crate) fn tied_to_world(observations: &[Observation], settings: &Settings) -> bool {
    observations.iter().any(|o| o.targets.iter().any(Option::is_some))
        || settings.conditions.iter().any(|c| c.kind.equation().is_in_world())
        || settings.known.iter().any(|k| matches!(k, Known::Place { .. } | Known::On { .. }))
}

/// `true` if an observation or a known point contains a length.
pub(crate) fn has_length(observations: &[Observation], settings: &Settings) -> bool {
    // one place alone is an origin, not a length
    let places = settings.known.iter().filter(|k| matches!(k, Known::Place { .. } | Known::On { .. })).count();
    observations.iter().any(|o| o.targets.iter().any(Option::is_some))
        || settings.conditions.iter().any(|c| c.kind.equation().has_length())
        || places > 1
        || settings.known.iter().any(|k| matches!(k, Known::Distance { .. } | Known::Length { .. }))
}

/// Returns a warning if no observation contains a length: a robot of twice the size fits equally
/// well.
pub(crate) fn without_length(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    status: &[Status],
) -> Option<Message> {
    if has_length(observations, settings) {
        return None;
    }
    let held = robot.parameters().iter().zip(status).filter(|(p, s)| {
        p.quantity == Quantity::Length && p.role == Role::Robot && **s != Status::Identified && p.nominal != 0.0
    });
    let lengths: Vec<String> = held.map(|(p, _)| format!("`{}` = {} mm", p.name, p.nominal)).collect();
    let lengths = if lengths.is_empty() { "none".argument() } else { lengths.argument() };
    Some(warning!("scale-unobserved", lengths))
}

/// Returns an error if conditions are for another robot or other residuals.
pub(crate) fn check(robot: &dyn Robot, settings: &Settings) -> Result<()> {
    if settings.conditions.is_empty() && settings.known.is_empty() {
        return Ok(());
    }
    let coordinates = settings.conditions.iter().all(|c| matches!(c.kind, Kind::Coordinate(_)));
    if robot.free_base().is_none() && !(coordinates && settings.known.is_empty() && !robot.has_assembly_modes()) {
        return Err(Error::NotAnArm { model: robot.model().to_owned() });
    }
    if settings.kind == ResidualKind::Pose || settings.common_uncertainty_mm.is_some() {
        return Err(error!("kinds-need-target-residuals").into());
    }
    if settings.standard_uncertainty_mm.is_none() {
        return Err(Error::KindsWithoutUncertainty);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixture;
    use etalon_base::noise::Noise;
    use etalon_robots::{Parameter, Serial, SerialJoint};

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
        let targets = ["ball", "end"].map(str::to_owned);
        let mut robot = Serial::new(&joints, &targets, [0.0, 0.0, -1.0], &[2, 3], &[(4, 3)]);
        let mut noise = Noise::new(18, 3);
        let socket = Fixture::Point("s").add_to(&mut robot);
        let (plane, line) = (Fixture::Plane("p", 1).add_to(&mut robot), Fixture::Line("l", 2).add_to(&mut robot));
        let radius = Fixture::Radius("s").add_to(&mut robot);
        let mounting = Fixture::Mounting("ball").add_to(&mut robot);
        let station = Fixture::Station("t").add_to(&mut robot);
        let length = Fixture::Bar(["ball", "end"]).add_to(&mut robot);
        let body = Pose::from_rotation_vector([0.3, -0.8, 1.1]);
        let from = |first: usize, last: usize| [first, first + 1, first + 2, last];
        let kinds = [
            Kind::Orientation(Orientation { frame_T_body: body, station: None, mounting }),
            Kind::Orientation(Orientation { frame_T_body: body, station: Some(station), mounting }),
            Kind::Coordinate(Coordinate { axis: 1, at_mm: 12.0 }),
            Kind::Distance(Distance { to: socket, distance_mm: 300.0 }),
            Kind::Contact(Contact { socket }),
            Kind::Seen(Seen { station, at_mm: [800.0, -300.0, 500.0] }),
            Kind::On(On { surface: Surface::Plane { axis: 1 }, unknowns: from(plane, plane + 2), offset_mm: 3.0 }),
            Kind::On(On { surface: Surface::Line { axis: 2 }, unknowns: from(line, line + 3), offset_mm: 0.0 }),
            Kind::On(On { surface: Surface::Sphere, unknowns: from(socket, radius), offset_mm: 3.0 }),
            Kind::Joint(JointValue { joint: 2, value: 0.7, is_angle: true }),
            Kind::Joint(JointValue { joint: 3, value: -0.2, is_angle: true }),
            Kind::Between(Between { other: 1, apart: Separation::Distance(300.0) }),
            Kind::Between(Between { other: 1, apart: Separation::Bar(length) }),
            Kind::Between(Between { other: 1, apart: Separation::Touching }),
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
                let at = c.at(robot.free_base(), values, robot.position(values, &c.joints, 0));
                c.residuals(&at, &mut out[..kind.rows()]);
                out
            };
            let (mut moved, mut exact) = (vec![0.0; 6 * n], vec![0.0; kind.rows() * n]);
            robot.jacobian(&values, &c.joints, &mut moved);
            moved.truncate(3 * n);
            let at = c.at(robot.free_base(), &values, robot.position(&values, &c.joints, 0));
            c.jacobian(&at, &moved, &mut exact);
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

    /// Measured lengths that are all longer by one part change the residuals as given.
    #[test]
    fn a_common_scale_of_measured_lengths_changes_the_residuals() {
        let joint =
            SerialJoint { alpha_rad: 0.0, a_mm: 0.0, theta_rad: 0.0, d_mm: 290.0, prismatic: false, parallel: false };
        let mut robot = Serial::new(&[joint], &["ball".to_owned()], [0.0, 0.0, -1.0], &[], &[]);
        let socket = Fixture::Point("s").add_to(&mut robot);
        let station = Fixture::Station("t").add_to(&mut robot);
        let mut noise = Noise::new(18, 3);
        let values: Vec<f64> = robot.parameters().iter().map(|p| p.nominal + noise.uniform(1.0)).collect();
        let longer = |by: f64| {
            let f = 1.0 + by;
            [
                Kind::Coordinate(Coordinate { axis: 1, at_mm: 12.0 * f }),
                Kind::Distance(Distance { to: socket, distance_mm: 300.0 * f }),
                Kind::Seen(Seen { station, at_mm: [800.0 * f, -300.0 * f, 500.0 * f] }),
                Kind::Contact(Contact { socket }),
            ]
        };
        let left = |kind: Kind| {
            let joints = vec![0.3];
            let c = Condition { pose: 1.into(), cycle: 1, joints, target: 0, kind, standard_uncertainty: 0.5 };
            let mut out = [0.0; 3];
            let at = c.at(robot.free_base(), &values, robot.position(&values, &c.joints, 0));
            kind.equation().residuals(&at, &mut out[..kind.rows()]);
            out
        };
        for (long, kind) in longer(1e-6).into_iter().zip(longer(0.0)) {
            let (moved, before, exact) = (left(long), left(kind), kind.equation().by_scale(&values));
            for i in 0..kind.rows() {
                let numeric = (moved[i] - before[i]) / 1e-6;
                assert!((numeric - exact[i]).abs() < 1e-3, "{kind:?}: {numeric} {}", exact[i]);
            }
        }
    }
}
