//! Residual field: joint errors that the parameters do not describe, as functions of the joints.
//!
//! A component is the error of one joint as a function of one or two joints. It is a Gaussian
//! process with a compactly supported covariance (Wendland 1995, Adv. Comput. Math. 4, 389, φ₃,₁),
//! in weight space on a few inducing points among the poses (Quiñonero-Candela & Rasmussen 2005, J.
//! Mach. Learn. Res. 6, 1939; FITC). Components are added while the restricted likelihood, in which
//! the parameters are integrated out, rises significantly. The parameters follow the field:
//! universal kriging (Rasmussen & Williams 2006, 2.7). Held-out poses decide whether the field is
//! accepted.

mod basis;
mod choose;
mod corrected;
mod held_out;
mod rows;
mod solve;

pub use corrected::Corrected;
pub use held_out::HeldOut;

use crate::{Identification, Observation, Settings};
use basis::Basis;
use choose::{Chosen, choose};
use etalon_base::pose_name::PoseName;
use etalon_robots::{Correction, Robot};
use held_out::hold_out;
use nalgebra::DMatrix;
use rows::{Fit, Rows};
use solve::Solved;

/// Minimum number of poses for a field.
const FEWEST_POSES: usize = 20;
/// Minimum number of equations in excess of the parameters for a field.
const FEWEST_DEGREES: usize = 40;
/// Width of the border beyond the measured range of a joint in which a field fades out (rad; for
/// prismatic joints, share of half the range).
const FADE: f64 = 0.3;

/// Joint on which a component depends.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldInput {
    /// Index of the joint.
    pub joint: usize,
    /// Length (rad or mm) of one unit of distance.
    pub scale: f64,
    /// Range of the measured poses (rad or mm).
    pub range: [f64; 2],
    /// Width beyond the range in which the field fades out (rad or mm).
    pub fade: f64,
}

/// Error of one joint as a function of joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// Index of the joint that is off.
    pub joint: usize,
    /// Joints on which the error depends.
    pub inputs: Vec<FieldInput>,
    /// Radius of the covariance, in units of distance.
    pub radius: f64,
    /// Standard deviation of the error without knowledge (rad or mm).
    pub prior: f64,
    /// Joint values of the inducing points (rad or mm), in the order of the inputs.
    pub centres: Vec<Vec<f64>>,
    /// Weight (rad or mm) of the covariance function about each centre.
    pub weights: Vec<f64>,
}

/// Field of joint errors with the parameters that belong to it.
#[derive(Clone, Debug, PartialEq)]
pub struct JointField {
    /// Components; several may concern one joint.
    pub components: Vec<Component>,
    /// Change of every parameter of the robot (mm, rad, 1) that belongs to the components.
    pub shift: Vec<f64>,
    /// Indices of the parameters in the covariance.
    pub free: Vec<usize>,
    /// Covariance of these parameters and of the weights, row by row.
    pub covariance: Vec<f64>,
    /// Factor of standard uncertainties, with which they agree with the errors at held-out poses;
    /// beyond the poses at least 1.
    pub factor: f64,
    /// Standard deviation (mm) of a coordinate without the field's error.
    pub noise_mm: f64,
}

/// Reason for a field not being accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldRefusal {
    /// Readings are not positions of targets alone.
    NotPositions,
    /// Number of poses, and number that is needed.
    TooFewPoses(usize, usize),
    /// The parameters are not determined by the positions.
    Undetermined,
    /// Residuals show no dependence on joints: largest rise of −2 ln L, and its threshold.
    NothingShown(f64, f64),
    /// Held-out error (mm) of a pose that is far above the errors of the others: a wrong reading.
    Suspect(PoseName, f64),
    /// A field was found, but does not improve the held-out poses significantly.
    NotProven,
}

/// Result of the search for a field.
#[derive(Clone, Debug)]
pub struct FieldTrial {
    /// The field; `None` if rejected.
    pub field: Option<JointField>,
    /// Errors at held-out poses; `None` if no field was tried there.
    pub held_out: Option<HeldOut>,
    /// Reason for the refusal.
    pub refusal: Option<FieldRefusal>,
}

impl FieldTrial {
    fn refused(refusal: FieldRefusal) -> Self {
        Self { field: None, held_out: None, refusal: Some(refusal) }
    }
}

/// Searches the residuals of an identification for a field.
///
/// # Examples
///
/// ```
/// use etalon_identify::{Observation, Settings, search_field, FieldRefusal, identify};
/// use etalon_robots::{Prexyt, Robot};
///
/// // exact positions of both balls at eight poses: too few for a field
/// let robot = Prexyt::default();
/// let corner = |pose: i64| {
///     let joints = [1, 2, 4].map(|bit| if pose & bit == 0 { 0.0 } else { 150.0 }); // mm
///     let balls = robot.balls(&robot.nominal(), &joints);
///     let targets = balls.map(|[x, y]| Some([x, y, 0.0])).to_vec();
///     Observation { pose: pose.into(), joints: joints.into(), targets, ..Observation::default() }
/// };
/// let observations: Vec<_> = (0..8).map(corner).collect();
/// let settings = Settings::default();
/// let found = identify(&robot, &observations, &settings)?;
/// let trial = search_field(&robot, &observations, &settings, &found);
/// assert!(matches!(trial.refusal, Some(FieldRefusal::TooFewPoses(8, needed)) if needed >= 20));
/// # Ok::<(), etalon_identify::Error>(())
/// ```
pub fn search_field(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> FieldTrial {
    let positions = settings.conditions.is_empty() && settings.rigid.is_empty() && settings.known.is_empty();
    if !positions || observations.iter().any(|o| o.covariances_mm2.iter().any(Option::is_some)) {
        return FieldTrial::refused(FieldRefusal::NotPositions);
    }
    let rows = Rows::new(robot, observations, found);
    let needed = rows.poses_needed();
    if rows.poses.len() < needed {
        return FieldTrial::refused(FieldRefusal::TooFewPoses(rows.poses.len(), needed));
    }
    let all: Vec<usize> = (0..rows.count()).collect();
    let Some(fit) = rows.fit(&all, rows.deviation_mm) else { return FieldTrial::refused(FieldRefusal::Undetermined) };
    let chosen = match choose(&rows, &fit, &all) {
        Ok(chosen) => chosen,
        Err((rise, threshold)) => return FieldTrial::refused(FieldRefusal::NothingShown(rise, threshold)),
    };
    let Some(held_out) = hold_out(&rows) else { return FieldTrial::refused(FieldRefusal::Undetermined) };
    let suspect = held_out.suspect().map(|(pose, error_mm)| FieldRefusal::Suspect(pose, error_mm));
    if suspect.is_some() || !held_out.is_proven() {
        let refusal = suspect.or(Some(FieldRefusal::NotProven));
        return FieldTrial { field: None, held_out: Some(held_out), refusal };
    }
    let mut field = field(&rows, &chosen);
    field.factor = held_out.factor;
    FieldTrial { field: Some(field), held_out: Some(held_out), refusal: None }
}

/// The field of chosen components.
fn field(rows: &Rows, chosen: &Chosen) -> JointField {
    let Chosen { bases, solved, fit, follow } = chosen;
    let shift = &fit.change - follow * &solved.weights;
    let mut all = vec![0.0; rows.parameters];
    fit.columns.iter().zip(shift.iter()).for_each(|(&k, s)| all[rows.free[k]] = *s);
    let mut first = 0;
    let mut components = Vec::new();
    let (n, m) = (fit.columns.len(), solved.weights.len());
    // from independent weights to weights of the covariance function
    let mut turn = DMatrix::<f64>::zeros(n + m, n + m);
    turn.view_mut((0, 0), (n, n)).fill_with_identity();
    for (basis, prior) in bases.iter().zip(&solved.priors) {
        let own = basis.to_weights();
        let weights = &own * solved.weights.rows(first, basis.len());
        turn.view_mut((n + first, n + first), (basis.len(), basis.len())).copy_from(&own);
        components.push(basis.component(rows, weights.as_slice(), *prior));
        first += basis.len();
    }
    let covariance = &turn * joint_covariance(fit, solved, follow) * turn.transpose();
    JointField {
        components,
        shift: all,
        free: fit.columns.iter().map(|&k| rows.free[k]).collect(),
        covariance: covariance.as_slice().to_vec(),
        factor: 1.0,
        noise_mm: solved.white.sqrt(),
    }
}

/// Covariance of parameters and independent weights.
fn joint_covariance(fit: &Fit, solved: &Solved, follow: &DMatrix<f64>) -> DMatrix<f64> {
    let (n, m) = (follow.nrows(), follow.ncols());
    let mut all = DMatrix::zeros(n + m, n + m);
    let across = -(follow * &solved.covariance);
    let of_parameters = follow * &solved.covariance * follow.transpose() + &fit.inverse * solved.white;
    all.view_mut((0, 0), (n, n)).copy_from(&of_parameters);
    all.view_mut((0, n), (n, m)).copy_from(&across);
    all.view_mut((n, 0), (m, n)).copy_from(&across.transpose());
    all.view_mut((n, n), (m, m)).copy_from(&solved.covariance);
    all
}

impl Component {
    /// Values of the covariance function about each centre, and the part of the prior variance that
    /// the inducing points do not represent (0 to 1).
    fn functions(&self, joints: &[f64]) -> (Vec<f64>, f64) {
        let scaled = |values: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
            values.zip(&self.inputs).map(|(q, input)| q / input.scale).collect()
        };
        let centres = self.centres.iter().map(|c| scaled(&mut c.iter().copied())).collect();
        let basis = Basis::new(self.joint, Vec::new(), self.radius, centres);
        let at = scaled(&mut self.inputs.iter().map(|input| joints[input.joint]));
        let values = basis.covariances(&at);
        let shown = basis.independent(&values).norm_squared();
        (values, (1.0 - shown).max(0.0))
    }

    /// Error of the joint (rad or mm), before the field fades out.
    fn error(&self, joints: &[f64]) -> f64 {
        let about = |centre: &Vec<f64>| {
            let squares = centre.iter().zip(&self.inputs).map(|(c, i)| ((joints[i.joint] - c) / i.scale).powi(2));
            basis::wendland(squares.sum::<f64>().sqrt() / self.radius)
        };
        self.centres.iter().zip(&self.weights).map(|(centre, weight)| weight * about(centre)).sum()
    }
}

impl JointField {
    /// Joint errors (rad or mm) at joint values, before the field fades out.
    pub fn errors(&self, joints: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; joints.len()];
        self.components.iter().for_each(|c| all[c.joint] += c.error(joints));
        all
    }

    /// Covariance (mm²) of the position of a target with the field, without the measurement's own
    /// noise. Beyond the measured range it grows to the value of an unknown field.
    pub fn covariance_mm2(&self, robot: &dyn Robot, values: &[f64], joints: &[f64], target: usize) -> DMatrix<f64> {
        let (d, n) = (robot.dimension(), self.free.len());
        let (all, axes) = (robot.parameters().len(), robot.joints().len());
        let count = d * robot.targets().len();
        let (mut by_parameter, mut by_joint) = (vec![0.0; count * all], vec![0.0; count * axes]);
        robot.jacobian(values, joints, &mut by_parameter);
        robot.joint_jacobian(values, joints, &mut by_joint);
        let size = self.covariance.len().isqrt();
        let mut rows = DMatrix::zeros(d, size);
        let outside = (1.0 - self.share(joints)).powi(2);
        let mut more = DMatrix::zeros(d, d);
        let mut first = n;
        for axis in 0..d {
            let row = target * d + axis;
            self.free.iter().enumerate().for_each(|(k, &i)| rows[(axis, k)] = by_parameter[row * all + i]);
        }
        for component in &self.components {
            let column = |axis: usize| by_joint[(target * d + axis) * axes + component.joint];
            let (functions, unknown) = component.functions(joints);
            for axis in 0..d {
                functions.iter().enumerate().for_each(|(k, f)| rows[(axis, first + k)] = column(axis) * f);
                for other in 0..d {
                    let variance = component.prior.powi(2) * (unknown + outside);
                    more[(axis, other)] += variance * column(axis) * column(other);
                }
            }
            first += functions.len();
        }
        let covariance = DMatrix::from_column_slice(size, size, &self.covariance);
        let share = self.share(joints);
        let factor = share * self.factor + (1.0 - share) * self.factor.max(1.0);
        (&rows * covariance * rows.transpose() + more) * factor.powi(2)
    }
}

impl Correction for JointField {
    fn share(&self, joints: &[f64]) -> f64 {
        let inputs = self.components.iter().flat_map(|c| &c.inputs);
        let beyond = |i: &FieldInput| {
            let d = (i.range[0] - joints[i.joint]).max(joints[i.joint] - i.range[1]).max(0.0) / i.fade;
            basis::faded(d)
        };
        inputs.map(beyond).fold(1.0, f64::min)
    }

    fn applied(&self, parameters: &[f64], joints: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let share = self.share(joints);
        if share == 0.0 {
            return (parameters.to_vec(), joints.to_vec());
        }
        let parameters = parameters.iter().zip(&self.shift).map(|(p, shift)| p + share * shift).collect();
        let errors = self.errors(joints);
        (parameters, joints.iter().zip(errors).map(|(q, error)| q + share * error).collect())
    }
}
