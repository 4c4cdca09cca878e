//! The error that the controller will make at a tool point: its true place in the base frame minus
//! the one that the identified parameters predict. What the targets measure is another error: in
//! it, parameters cancel that shift tool and targets alike (of a PreXYT d and x_c), and base and
//! targets are as they were fitted.

use crate::model::frame_error::response;
use crate::model::residuals::Residuals;
use crate::model::rigid_part::best_rotation;
use crate::{Error, Result};
use crate::{Group, Identification, Observation, Settings};
use etalon_base::error;
use etalon_base::pose::{Pose, Vector, centroid, cross, minus, unit};
use etalon_math::{covariance, factor_at};
use etalon_robots::{Robot, Role};
use nalgebra::{Matrix3, Vector3};

/// The part in whose frame a tool point is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolFrame {
    /// The flange of an arm.
    Flange,
    /// A platform, at its centre C.
    Platform,
    /// The targets as identified: origin at the first, x axis to the second, the third in the xy
    /// plane.
    Targets,
}

/// A point that moves with the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolPoint {
    /// Position (mm) in `frame`.
    pub point_mm: Vector,
    /// Part in whose frame the point is given.
    pub frame: ToolFrame,
    /// Standard uncertainty of one of its coordinates, mm.
    pub standard_uncertainty_mm: f64,
}

/// The expected error at one pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolError {
    /// Position predicted with the parameters before minus that with the identified ones, in the
    /// base frame (mm).
    pub before_mm: Vector,
    /// Standard uncertainty (mm) of the position from the parameters: root of the trace of its
    /// covariance.
    pub parameters_mm: f64,
    /// Standard uncertainty (mm) from held parameters, each with its tolerance as half the width of
    /// an interval (GUM 4.3.7).
    pub held_mm: f64,
    /// Covariance of the position by both, mm².
    pub covariance_mm2: Matrix3<f64>,
}

impl ToolPoint {
    /// The first target.
    pub const FIRST_TARGET: Self = Self { point_mm: [0.0; 3], frame: ToolFrame::Targets, standard_uncertainty_mm: 0.0 };

    /// The centre C of a platform; `None` for robots without one.
    pub fn centre(robot: &dyn Robot) -> Option<Self> {
        robot.platform()?;
        Some(Self { point_mm: [0.0; 3], frame: ToolFrame::Platform, standard_uncertainty_mm: 0.0 })
    }

    /// Position (mm) in the base frame of `robot`.
    pub fn in_base(&self, robot: &dyn Robot, values: &[f64], joints: &[f64]) -> Result<Vector> {
        let values = without_base(robot, values);
        let lacks = |part| Error::NoSuchPart { model: robot.model().to_owned(), part };
        match self.frame {
            ToolFrame::Platform => {
                let pose = robot.platform().ok_or_else(|| lacks("platform"))?.pose(&values, joints);
                let turned = Pose::identity().turn_z(pose.theta_rad).rotate(self.point_mm);
                Ok([pose.x_mm + turned[0], pose.y_mm + turned[1], turned[2]])
            }
            ToolFrame::Flange => {
                let arm = robot.free_base().filter(|arm| arm.branches().is_empty()).ok_or_else(|| lacks("flange"))?;
                Ok(arm.flange(&values, joints, 0).apply(self.point_mm))
            }
            ToolFrame::Targets => self.on_targets(&places(robot, &values, joints)),
        }
    }

    /// Returns the position of the point that targets at these positions carry.
    fn on_targets(&self, places: &[Vector]) -> Result<Vector> {
        let few = || error!("tool-targets-collinear");
        let Some(&origin) = places.first() else { return Err(few().into()) };
        if self.point_mm == [0.0; 3] {
            return Ok(origin);
        }
        let to = |k: usize| places.get(k).map(|p| minus(*p, origin));
        let x = to(1).and_then(unit).ok_or_else(few)?;
        let z = match to(2) {
            Some(third) => unit(cross(x, third)).ok_or_else(few)?,
            None if x[2] == 0.0 => [0.0, 0.0, 1.0],
            None => return Err(few().into()),
        };
        let y = cross(z, x);
        Ok(std::array::from_fn(|i| {
            origin[i] + x[i] * self.point_mm[0] + y[i] * self.point_mm[1] + z[i] * self.point_mm[2]
        }))
    }

    /// Derivatives of [`Self::in_base`] with respect to all parameters: three rows.
    fn jacobian(&self, robot: &dyn Robot, values: &[f64], joints: &[f64]) -> Result<Vec<Vector>> {
        let mut values = without_base(robot, values);
        let (n, d) = (values.len(), robot.dimension());
        let mut columns = vec![[0.0; 3]; n];
        if let (ToolFrame::Platform, Some(platform)) = (self.frame, robot.platform()) {
            let balls = places(robot, &values, joints);
            let [k, l] = [0, 1].map(|i| [balls[i][0], balls[i][1]]);
            let rows = platform.pose_error_jacobian(&values, joints, [k, l]);
            let turn = Pose::identity().turn_z(platform.pose(&values, joints).theta_rad);
            let lever = cross([0.0, 0.0, 1.0], turn.rotate(self.point_mm));
            for (i, column) in columns.iter_mut().enumerate() {
                let theta = rows[2 * n + i];
                *column = [rows[i] + lever[0] * theta, rows[n + i] + lever[1] * theta, 0.0];
            }
            return Ok(columns_with_roles(robot, columns, &[Role::Robot]));
        }
        let mut full = vec![0.0; d * robot.targets().len() * n];
        let of_target = |full: &[f64], target: usize, parameter: usize| -> Vector {
            std::array::from_fn(|i| if i < d { full[(target * d + i) * n + parameter] } else { 0.0 })
        };
        if let (ToolFrame::Flange, Some(arm)) = (self.frame, robot.free_base()) {
            // the point instead of the first target
            values[arm.target_place(0)..][..3].copy_from_slice(&self.point_mm);
            robot.jacobian(&values, joints, &mut full);
            columns.iter_mut().enumerate().for_each(|(i, column)| *column = of_target(&full, 0, i));
            return Ok(columns_with_roles(robot, columns, &[Role::Robot]));
        }
        robot.jacobian(&values, joints, &mut full);
        let places = places(robot, &values, joints);
        let at = self.on_targets(&places)?;
        for (i, column) in columns.iter_mut().enumerate() {
            let moved: Vec<Vector> = carriers(robot).map(|k| of_target(&full, k, i)).collect();
            *column = carried(&places, &moved, at, self.point_mm == [0.0; 3]);
        }
        Ok(columns_with_roles(robot, columns, &[Role::Robot, Role::Target]))
    }
}

/// Prediction of the error at a tool point, from parameters that were identified.
#[derive(Clone)]
pub struct ToolPrediction<'a> {
    /// The robot.
    pub robot: &'a dyn Robot,
    /// The tool point.
    pub point: ToolPoint,
    /// All parameters before the identification.
    pub before: &'a [f64],
    /// The identification.
    pub found: &'a Identification,
    /// Parameters that the data do not determine, see [`held`].
    pub held: Vec<Held>,
}

impl ToolPrediction<'_> {
    /// The expected error at joint values; `None` without a covariance.
    pub fn error(&self, joints: &[f64]) -> Result<Option<ToolError>> {
        let Self { robot, point, before, found, held } = self;
        let Some(covariance) = &found.uncertainty.covariance else { return Ok(None) };
        let nominal = point.in_base(*robot, before, joints)?;
        let identified = point.in_base(*robot, &found.values, joints)?;
        let columns: Vec<Vector3<f64>> =
            point.jacobian(*robot, &found.values, joints)?.into_iter().map(Vector3::from).collect();
        let n = found.free.len();
        let mut by_parameters = Matrix3::zeros();
        for (&a, row) in found.free.iter().zip(covariance.chunks_exact(n.max(1))) {
            let by_others: Vector3<f64> = found.free.iter().zip(row).map(|(&b, c)| columns[b] * *c).sum();
            by_parameters += columns[a] * by_others.transpose();
        }
        let of_held = |held: &Held| {
            let mut by = columns[held.parameter];
            for (&i, compensation) in found.free.iter().zip(&held.compensation) {
                by += columns[i] * *compensation;
            }
            by *= robot.parameters()[held.parameter].tolerance / 3f64.sqrt();
            by * by.transpose()
        };
        let by_held: Matrix3<f64> = held.iter().map(of_held).sum();
        Ok(Some(ToolError {
            before_mm: minus(nominal, identified),
            parameters_mm: by_parameters.trace().max(0.0).sqrt(),
            held_mm: by_held.trace().sqrt(),
            covariance_mm2: by_parameters + by_held,
        }))
    }
}

/// A parameter that is held because the data do not determine it, and the response of the
/// identified parameters to this parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Index of the parameter.
    pub parameter: usize,
    /// Derivatives of the identified parameters, in their order, with respect to the held
    /// parameter.
    pub compensation: Vec<f64>,
}

/// The parameters with a nominal value that `found` holds because `observations` do not determine
/// them. Parameters of an arm that are redundant with its base or its targets are excluded: held,
/// they define the frames of base and flange.
pub fn held(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Result<Vec<Held>> {
    let parameters = robot.parameters();
    let places_frame = |g: &Group| {
        let elsewhere = g.with.iter().any(|&i| parameters[i].role != Role::Robot);
        robot.free_base().is_some() && g.useless_uncertainty.is_none() && elsewhere
    };
    let counts = |g: &&Group| parameters[g.held].tolerance.is_finite() && !g.with.is_empty() && !places_frame(g);
    let groups: Vec<&Group> = found.identifiability.groups.iter().filter(counts).collect();
    if groups.is_empty() {
        return Ok(Vec::new());
    }
    let settings = settings.as_found(found);
    let problem = |free: &[usize]| Residuals::new(robot, observations, &settings, free, &found.values);
    let at = |free: &[usize]| free.iter().map(|&i| found.values[i]).collect::<Vec<f64>>();
    let (all, x) = (problem(&found.free)?, at(&found.free));
    let (factor, norms) = factor_at(&all, &x);
    let of_free = all.jacobian_at(&x);
    let Some(inverse) = covariance(&factor, &norms) else { return Ok(Vec::new()) };
    let of = |group: &&Group| {
        let held = [group.held];
        let by = problem(&held)?.jacobian_at(&at(&held));
        let follow = response::<1>(&inverse, all.jacobian_rows(&of_free), &by);
        Ok(Held { parameter: group.held, compensation: follow.iter().map(|[c]| -c).collect() })
    };
    groups.iter().map(of).collect()
}

/// These parameters with the base at the world frame.
fn without_base(robot: &dyn Robot, values: &[f64]) -> Vec<f64> {
    let of = |(p, &value): (&etalon_robots::Parameter, &f64)| if p.role == Role::Base { 0.0 } else { value };
    robot.parameters().iter().zip(values).map(of).collect()
}

fn places(robot: &dyn Robot, values: &[f64], joints: &[f64]) -> Vec<Vector> {
    carriers(robot).map(|k| robot.position(values, joints, k)).collect()
}

/// Targets of the rigid body that carries the first target.
fn carriers(robot: &dyn Robot) -> impl Iterator<Item = usize> + '_ {
    (0..robot.targets().len()).filter(|&k| robot.target_branch(k) == robot.target_branch(0))
}

/// Returns the columns of parameters with one of these roles; the others are zero.
fn columns_with_roles(robot: &dyn Robot, mut columns: Vec<Vector>, roles: &[Role]) -> Vec<Vector> {
    let others = robot.parameters().iter().zip(&mut columns).filter(|(p, _)| !roles.contains(&p.role));
    others.for_each(|(_, column)| *column = [0.0; 3]);
    columns
}

/// Displacement of the point `at` with the body, from points at `places` that are `moved`: shift of
/// their centre and best rotation. The first of the points has its own displacement.
fn carried(places: &[Vector], moved: &[Vector], at: Vector, at_first: bool) -> Vector {
    if at_first {
        return moved[0];
    }
    let (centre, shift) = (centroid(places).unwrap_or_default(), centroid(moved).unwrap_or_default());
    let about: Vec<Vector> = places.iter().map(|p| minus(*p, centre)).collect();
    let lever = cross(best_rotation(&about, &about, moved), minus(at, centre));
    std::array::from_fn(|i| shift[i] + lever[i])
}
