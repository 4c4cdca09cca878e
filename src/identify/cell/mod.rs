//! Frames of a robot cell from poses of a robot and measured points or poses: tool, work object,
//! external axes, hand and eye.
//!
//! Each kind is a weighted least-squares problem of a few frames. Its noise has one standard
//! deviation for positions and one for orientations, each given or from the residuals.

mod chain;
mod external;
mod object;
mod refuted;
mod slips;
mod solve;
#[cfg(test)]
mod tests;
mod three_points;
mod tool_axes;
mod tool_point;

pub use chain::{HandEye, MeasuredPose, Mounting, Reflector, hand_eye, reflector};
pub use external::{AxisReading, LinearAxis, RotaryAxis, linear_axis, rotary_axis};
pub use object::{ObjectFrame, ObjectSlip, object_frame, object_slips};
pub use refuted::Size;
pub use slips::{AlternativeFit, explained};
pub use three_points::{ThreePointRole, ThreePoints, three_points};
pub use tool_axes::{AxisRole, ToolAxes, tool_axes};
pub use tool_point::{ToolTip, tool_point};

use etalon_base::pose::{Pose, Vector, cross};
use etalon_math::symmetric_eigen;
use nalgebra::{DMatrix, Matrix3, Matrix6};

/// Quantity of an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Position (mm).
    Position,
    /// Orientation (rad).
    Orientation,
}

/// Index of a measure: positions, then orientations.
fn measure_index(measure: Measure) -> usize {
    usize::from(measure == Measure::Orientation)
}

/// Given uncertainties.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stated {
    /// Standard uncertainty of a coordinate of a reading (mm), robot and measurement together.
    pub position_mm: Option<f64>,
    /// Standard uncertainty of an orientation about any axis (rad).
    pub rotation_rad: Option<f64>,
    /// Standard uncertainties of the measured coordinates of each reading (mm), in addition to
    /// [`Self::position_mm`]; empty if they are not given.
    pub measured_mm: Vec<Vector>,
}

impl Stated {
    /// `true` if the uncertainty of positions (0) or orientations (1) is given.
    fn is_stated(&self, k: usize) -> bool {
        if k == 0 { self.position_mm.is_some() || !self.measured_mm.is_empty() } else { self.rotation_rad.is_some() }
    }

    /// Largest given standard uncertainty of positions (0, mm) or orientations (1, rad).
    fn largest(&self, k: usize) -> f64 {
        let own = self.measured_mm.iter().flatten().fold(0.0, |largest: f64, u| largest.max(*u));
        if k == 0 { self.position_mm.unwrap_or_default().hypot(own) } else { self.rotation_rad.unwrap_or_default() }
    }

    /// Covariance of the position of a reading (mm²), the identity if it is not given.
    fn position(&self, reading: usize) -> [[f64; 3]; 3] {
        let common = self.position_mm.map_or(0.0, |u| u * u);
        let own = self.measured_mm.get(reading).copied().unwrap_or_default();
        let variance = |i: usize| if self.is_stated(0) { common + own[i] * own[i] } else { 1.0 };
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { variance(i) } else { 0.0 }))
    }

    /// Covariance of an orientation (rad²), the identity if it is not given.
    fn rotation(&self) -> [[f64; 3]; 3] {
        let variance = self.rotation_rad.map_or(1.0, |u| u * u);
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { variance } else { 0.0 }))
    }
}

/// Standard deviation of positions or orientations.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// Quantity.
    pub measure: Measure,
    /// Number of equations.
    pub equations: usize,
    /// Equations minus the parameters that they determine.
    pub redundancy: f64,
    /// Standard deviation of the residuals (mm or rad); 0 without redundancy.
    pub deviation: f64,
    /// `true` if the given uncertainty agrees with the residuals, and is used.
    pub agrees: bool,
}

/// Residual of a reading.
#[derive(Clone, Debug, PartialEq)]
pub struct CellResidual {
    /// Index of the reading.
    pub reading: usize,
    /// Quantity.
    pub measure: Measure,
    /// Measured minus predicted (mm, or rotation vector in rad).
    pub value: Vector,
    /// Probability of a residual at least as large by noise; `None` without redundancy.
    pub probability: Option<f64>,
}

/// Residuals of a solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Quality {
    /// Standard deviations: positions, then orientations.
    pub components: Vec<Component>,
    /// Residuals in the order of the readings.
    pub residuals: Vec<CellResidual>,
}

/// Probability (over all readings) below which a reading does not fit the others.
const OUTLYING: f64 = 1e-3;

impl Quality {
    /// Reading that fits the others least, if noise leaves a residual like this once in a thousand
    /// data sets or less.
    pub fn outlier(&self) -> Option<&CellResidual> {
        let count = self.residuals.len() as f64;
        let tested = self.residuals.iter().filter_map(|r| Some((r.probability?, r)));
        let (probability, least) = tested.min_by(|a, b| a.0.total_cmp(&b.0))?;
        (probability * count < OUTLYING).then_some(least)
    }

    /// These residuals of coordinates that were multiplied by a factor, in their first unit.
    #[must_use]
    pub fn in_unit(mut self, factor: f64) -> Self {
        self.components.iter_mut().filter(|c| c.measure == Measure::Position).for_each(|c| c.deviation /= factor);
        self
    }

    /// Standard uncertainty of a measured coordinate (mm) or orientation (rad): the given one
    /// where it agrees with the residuals, otherwise theirs; `None` without equations or
    /// redundancy.
    pub fn standard_uncertainty(&self, measure: Measure, stated: &Stated) -> Option<f64> {
        let component = self.components.iter().find(|c| c.measure == measure)?;
        match component.agrees {
            true => Some(stated.largest(measure_index(measure))),
            false => (component.redundancy > 0.5).then_some(component.deviation),
        }
    }

    /// `true` if uncertainties are known: each measure has redundancy, or a given uncertainty that
    /// agrees with the residuals.
    pub fn has_uncertainty(&self) -> bool {
        self.components.iter().all(|c| c.agrees || c.redundancy > 0.5)
    }
}

/// A point with its covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct CellPoint {
    /// Coordinates (mm).
    pub at_mm: Vector,
    /// Covariance (mm²).
    pub covariance_mm2: [[f64; 3]; 3],
}

/// A pose with its covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct CellFrame {
    /// Pose in its reference frame.
    pub pose: Pose,
    /// Covariance of the translation (mm) and of a small rotation (rad) about the axes of the
    /// reference frame, in this order.
    pub covariance: [[f64; 6]; 6],
}

impl CellFrame {
    /// Returns the covariance of the frame at another point of its reference frame (mm): the
    /// displacement of this point if the frame moves, and the rotation.
    pub fn covariance_at(&self, point_mm: Vector) -> [[f64; 6]; 6] {
        let [x, y, z] = etalon_base::pose::minus(point_mm, self.pose.translation_mm);
        // dp = dt + δ × r = dt − [r]× δ
        let skew = Matrix3::new(0.0, -z, y, z, 0.0, -x, -y, x, 0.0);
        let mut jacobian = Matrix6::identity();
        jacobian.fixed_view_mut::<3, 3>(0, 3).copy_from(&-skew);
        let all = jacobian * Matrix6::from_fn(|i, j| self.covariance[i][j]) * jacobian.transpose();
        std::array::from_fn(|i| std::array::from_fn(|j| all[(i, j)]))
    }

    /// Returns the pose of the reference frame in this frame.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let back = self.pose.inverse();
        let t = self.pose.translation_mm;
        let rotation = Matrix3::from_fn(|i, j| back.rotation[i][j]);
        // dt' = −Rᵀ (dt − δ × t), δ' = −Rᵀ δ
        let skew = Matrix3::new(0.0, -t[2], t[1], t[2], 0.0, -t[0], -t[1], t[0], 0.0);
        let mut jacobian = Matrix6::zeros();
        jacobian.fixed_view_mut::<3, 3>(0, 0).copy_from(&-rotation);
        jacobian.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-rotation * skew));
        jacobian.fixed_view_mut::<3, 3>(3, 3).copy_from(&-rotation);
        let all = jacobian * Matrix6::from_fn(|i, j| self.covariance[i][j]) * jacobian.transpose();
        Self { pose: back, covariance: std::array::from_fn(|i| std::array::from_fn(|j| all[(i, j)])) }
    }

    /// Standard uncertainties of the translation (mm) and of the rotation (rad).
    pub fn standard_uncertainties(&self) -> (Vector, Vector) {
        let u = |i: usize| self.covariance[i][i].max(0.0).sqrt();
        ([u(0), u(1), u(2)], [u(3), u(4), u(5)])
    }
}

/// Part of a covariance.
fn part<const N: usize>(covariance: &DMatrix<f64>, at: [usize; N]) -> [[f64; N]; N] {
    at.map(|i| at.map(|j| covariance[(i, j)]))
}

/// Reason why data do not determine a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CellFault {
    /// Fewer readings than needed.
    TooFew {
        /// Minimum number of readings.
        needed: usize,
        /// Number of readings.
        readings: usize,
    },
    /// All readings of each target are at one value of the axis.
    AtRest {
        /// Number of readings.
        readings: usize,
    },
    /// The robot has the same orientation at all readings.
    SameOrientation,
    /// All orientations differ by rotations about one axis: the translation along it is open.
    OneAxis {
        /// Direction in the moving frame (the flange).
        direction: Vector,
    },
    /// All points coincide.
    Coincident,
    /// All points are on one line: the rotation about it is open.
    Collinear {
        /// Direction of the line in the frame of the points.
        direction: Vector,
    },
    /// The equations do not determine all parameters.
    Undetermined,
}

/// Spread of directions (rad, root mean square) below which orientations are equal but for
/// rounding. Whether larger spreads suffice is decided by the uncertainty of the answer
/// ([`crate::UncertaintyBound`]).
const LEAST_SPREAD: f64 = 1e-7;
/// Distance from a line, relative to its length, below which points are collinear but for rounding.
const LEAST_WIDTH: f64 = 1e-7;
/// Distance between points (mm) below which they count as one.
const LEAST_LENGTH_MM: f64 = 1e-6;

/// Checks that orientations differ by rotations about more than one axis.
fn check_orientations(poses: &[Pose]) -> Result<(), CellFault> {
    let n = poses.len() as f64;
    let mean: [[f64; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| poses.iter().map(|p| p.rotation[i][j]).sum::<f64>() / n));
    let off = |p: &Pose| Matrix3::from_fn(|i, j| p.rotation[i][j] - mean[i][j]);
    let spread = poses.iter().fold(Matrix3::zeros(), |sum, p| sum + off(p).transpose() * off(p)) / n;
    let (values, vectors) = symmetric_eigen(std::array::from_fn(|i| std::array::from_fn(|j| spread[(i, j)])));
    match values.map(|v| v < LEAST_SPREAD * LEAST_SPREAD) {
        [_, _, true] => Err(CellFault::SameOrientation),
        [true, ..] => Err(CellFault::OneAxis { direction: upright(vectors[0]) }),
        _ => Ok(()),
    }
}

/// The direction or its opposite, so that its largest component is positive.
pub(crate) fn upright(direction: Vector) -> Vector {
    let largest = direction.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(1.0);
    if largest < 0.0 { direction.map(|v| -v) } else { direction }
}

/// Checks that points span a plane.
fn check_points(points: &[Vector]) -> Result<(), CellFault> {
    let Some(centre) = etalon_base::pose::centroid(points) else { return Err(CellFault::Coincident) };
    let mut scatter = [[0.0; 3]; 3];
    for p in points {
        let d = etalon_base::pose::minus(*p, centre);
        (0..9).for_each(|k| scatter[k / 3][k % 3] += d[k / 3] * d[k % 3] / points.len() as f64);
    }
    let (values, vectors) = symmetric_eigen(scatter);
    let length = values[2].max(0.0).sqrt();
    if length < LEAST_LENGTH_MM {
        return Err(CellFault::Coincident);
    }
    if values[1].max(0.0).sqrt() < LEAST_WIDTH * length {
        return Err(CellFault::Collinear { direction: upright(vectors[2]) });
    }
    Ok(())
}

/// The 24 rotations that map coordinate axes onto coordinate axes.
fn cube_rotations() -> Vec<Pose> {
    let signed = |k: usize| solve::UNIT[k % 3].map(|v| if k < 3 { v } else { -v });
    let pairs = (0..36).map(|k| (k / 6, k % 6)).filter(|(a, b)| a % 3 != b % 3);
    let frame = |(a, b): (usize, usize)| {
        let (x, y) = (signed(a), signed(b));
        let z = cross(x, y);
        Pose { rotation: [0, 1, 2].map(|i| [x[i], y[i], z[i]]), translation_mm: [0.0; 3] }
    };
    pairs.map(frame).collect()
}
