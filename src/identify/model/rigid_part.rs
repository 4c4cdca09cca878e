//! Rigid parts that carry targets: a given shape is one more reading of all its targets, from an
//! unknown position. Six unknowns are eliminated, and the remaining rows constrain the relative
//! positions of the targets.

use crate::judgement::chi_square::exceeds;
use etalon_base::catalogue::IntoArgument;
use etalon_base::error;
use etalon_base::message::{Message, Rank, Severity};
use etalon_base::pose::{Pose, Vector, centroid, cross, minus, norm};
use etalon_fit::rotation_onto;
use etalon_math::symmetric_eigen;
use etalon_robots::{Robot, Role};
use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen, Vector3};

/// Targets on one rigid part, and their positions on it.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPart {
    /// Names of the targets.
    pub targets: Vec<String>,
    /// Positions in any frame of the part (mm).
    pub places_mm: Vec<Vector>,
    /// Standard uncertainty of one of these coordinates, mm.
    pub standard_uncertainty_mm: f64,
    /// Maximum difference (mm) of a distance from the given one; beyond it, the distance
    /// belongs to another part.
    pub tolerance_mm: f64,
    /// Factor of the rows: the standard deviation of a residual, so that the rigidity of a part
    /// relative to the errors of the robot follows its given uncertainty; 1 if unknown.
    pub weight: f64,
}

/// The given shape of a part of a robot.
///
/// With e the places of the model minus the given ones after the best fit of one onto the other,
/// the rows are Q e / u, Q an orthonormal basis of the deformations, without rigid motions: 3 n − 6
/// rows for n targets in space. At the best fit e has no other component (variable projection,
/// Golub & Pereyra 1973).
#[derive(Debug)]
pub(crate) struct Shape {
    part: RigidPart,
    targets: Vec<usize>,
    /// Positions relative to their centre.
    centred: Vec<Vector>,
    /// Matrix Q.
    deforming: DMatrix<f64>,
}

/// Parameters of a robot, some of them free; the position of the robot does not matter.
pub(crate) struct At<'a> {
    pub robot: &'a dyn Robot,
    pub values: &'a [f64],
    pub free: &'a [usize],
    pub joints: &'a [f64],
}

/// Eigenvalues of a projection are 0 or 1 up to rounding.
const HALF: f64 = 0.5;
/// Maximum share of a direction that counts as zero: a rotation of collinear targets about their
/// line, a number of the shape that the measurements leave undetermined.
const UNDECIDED: f64 = 1e-6;

impl Shape {
    /// The shape of `part`; `None` if `robot` does not carry all its targets, or no shape remains.
    pub fn new(robot: &dyn Robot, part: &RigidPart) -> Option<Self> {
        let index = |name: &String| robot.targets().iter().position(|t| t == name);
        let targets: Vec<usize> = part.targets.iter().map(index).collect::<Option<_>>()?;
        let centre = centroid(&part.places_mm)?;
        let (n, d) = (targets.len(), robot.dimension());
        let in_space = |p: &Vector| minus(*p, centre);
        let flat = |[x, y, z]: Vector| [x, y, if d == 2 { 0.0 } else { z }];
        let centred: Vec<Vector> = part.places_mm.iter().map(in_space).map(flat).collect();
        let size = centred.iter().map(|p| norm(*p)).fold(f64::MIN_POSITIVE, f64::max);
        let unit = |axis: usize| -> Vector { std::array::from_fn(|i| f64::from(u8::from(i == axis))) };
        let turns = if d == 2 { 2..3 } else { 0..3 };
        let mut motions: Vec<Vec<Vector>> = (0..d).map(|axis| vec![unit(axis); n]).collect();
        motions.extend(turns.map(|axis| centred.iter().map(|p| cross(unit(axis), *p).map(|v| v / size)).collect()));
        // what is left of the space beside the motions
        let mut rest: DMatrix<f64> = DMatrix::identity(n * d, n * d);
        for motion in motions {
            let motion = DVector::from_fn(n * d, |row, _| motion[row / d][row % d]);
            let own: DVector<f64> = &rest * (&rest * motion);
            if own.norm() > UNDECIDED {
                rest -= &own * own.transpose() / own.norm_squared();
            }
        }
        let eigen = SymmetricEigen::new(rest);
        let kept: Vec<usize> = (0..n * d).filter(|&k| eigen.eigenvalues[k] > HALF).collect();
        let deforming = DMatrix::from_fn(kept.len(), n * d, |row, column| eigen.eigenvectors[(column, kept[row])]);
        (!kept.is_empty()).then(|| Self { part: part.clone(), targets, centred, deforming })
    }

    /// Variance of one of its rows.
    pub fn variance(&self) -> f64 {
        self.part.weight.powi(2)
    }

    /// Number of values of a shape: three distances for three targets.
    pub fn rows(&self) -> usize {
        self.deforming.nrows()
    }

    /// Positions by the model about their centre, rotated onto the given ones, and this rotation.
    fn turned(&self, at: &At) -> (Vec<Vector>, Pose) {
        let places: Vec<Vector> = self.targets.iter().map(|&k| at.robot.position(at.values, at.joints, k)).collect();
        let centre = centroid(&places).unwrap_or_default();
        let about: Vec<Vector> = places.iter().map(|p| minus(*p, centre)).collect();
        let rotation = rotation_onto(about.iter().copied().zip(self.centred.iter().copied()));
        let turn = Pose { rotation, translation_mm: [0.0; 3] };
        (about.into_iter().map(|p| turn.rotate(p)).collect(), turn)
    }

    /// Residual per millimetre of deformation.
    fn weight(&self) -> f64 {
        self.part.weight / self.part.standard_uncertainty_mm
    }

    /// Writes Q e / u.
    pub fn residuals(&self, at: &At, out: &mut [f64]) {
        let (places, _) = self.turned(at);
        let d = at.robot.dimension();
        let e = places.iter().zip(&self.centred).flat_map(|(p, s)| minus(*p, *s)[..d].to_vec());
        let rows = &self.deforming * DVector::from_iterator(self.deforming.ncols(), e) * self.weight();
        out.copy_from_slice(rows.as_slice());
    }

    /// Writes the derivatives with respect to the free parameters; only positions of targets
    /// contribute.
    pub fn jacobian(&self, at: &At, out: &mut [f64]) {
        let (places, turn) = self.turned(at);
        let (robot, n) = (at.robot, at.robot.parameters().len());
        let d = robot.dimension();
        let mut full = vec![0.0; d * robot.targets().len() * n];
        robot.jacobian(at.values, at.joints, &mut full);
        let free = at.free.len();
        let mut moved = DMatrix::zeros(self.deforming.ncols(), free);
        for (column, &parameter) in at.free.iter().enumerate() {
            if robot.parameters()[parameter].role != Role::Target {
                continue;
            }
            let by_target = self.targets.iter().map(|&target| {
                let by = |i: usize| if i < d { full[(target * d + i) * n + parameter] } else { 0.0 };
                turn.rotate(std::array::from_fn(by))
            });
            let by_target: Vec<Vector> = by_target.collect();
            // the best fit turns back with them
            let back = best_rotation(&self.centred, &places, &by_target);
            for (k, (by, place)) in by_target.iter().zip(&places).enumerate() {
                let turned = cross(back, *place);
                (0..d).for_each(|i| moved[(k * d + i, column)] = by[i] - turned[i]);
            }
        }
        let rows = &self.deforming * moved * self.weight();
        for (row, out) in rows.row_iter().zip(out.chunks_exact_mut(free)) {
            out.iter_mut().zip(row.iter()).for_each(|(out, v)| *out = *v);
        }
    }

    /// Returns a message if the measurements alone contradict the given shape beyond the
    /// uncertainty of both: a test of the rows as one group of observations (Baarda 1968), at the
    /// solution with `covariance` of the free parameters and `inverse` of the residuals, (JᵀJ)⁻¹.
    pub fn contradiction(&self, at: &At, inverse: &[f64], covariance: &[f64]) -> Option<Contradicted> {
        let (m, n) = (self.rows(), at.free.len());
        let mut rows = vec![0.0; m * n];
        self.jacobian(at, &mut rows);
        let mut left = vec![0.0; m];
        self.residuals(at, &mut left);
        let rows = DMatrix::from_row_slice(m, n, &rows);
        let square = |c: &[f64]| &rows * DMatrix::from_row_slice(n, n, c) * rows.transpose();
        // share that the given shape has in itself; residuals are that much too small
        let own = square(inverse);
        let inflation = (square(covariance).trace() / (own.trace() * self.variance())).max(1.0);
        let eigen = SymmetricEigen::new(DMatrix::identity(m, m) - own);
        let left = eigen.eigenvectors.transpose() * DVector::from_vec(left);
        let (mut chi_square, mut decided, mut alone) = (0.0, 0, DVector::zeros(m));
        for k in (0..m).filter(|&k| eigen.eigenvalues[k] > UNDECIDED) {
            let share = eigen.eigenvalues[k];
            alone[k] = left[k] / share;
            // variance of the given shape, and of the one that the measurements give without it
            let variance = self.variance() * (1.0 + inflation * (1.0 - share) / share);
            chi_square += alone[k] * alone[k] / variance;
            decided += 1;
        }
        if decided == 0 || !exceeds(chi_square, decided) {
            return None;
        }
        let e = self.deforming.transpose() * (&eigen.eigenvectors * alone) / self.weight();
        let d = at.robot.dimension();
        let found = |k: usize| -> Vector {
            std::array::from_fn(|i| self.centred[k][i] + if i < d { e[k * d + i] } else { 0.0 })
        };
        let places: Vec<Vector> = (0..self.targets.len()).map(found).collect();
        let off = |pair: &TargetPair| (pair.distance_mm(&places) - pair.distance_mm(&self.centred)).abs();
        let worst = self.part.pairs().max_by(|a, b| off(a).total_cmp(&off(b)))?;
        Some(self.part.contradicted(worst, worst.distance_mm(&places), "identification"))
    }
}

/// The small rotation ω in `moved` (displacements of points at `places`), for the best fit onto
/// points at `fixed`: both are about their centres, and Σ fixed × (moved − ω × places) = 0; zero
/// about a line that contains all points.
pub(crate) fn best_rotation(fixed: &[Vector], places: &[Vector], moved: &[Vector]) -> Vector {
    let (mut inertia, mut moment) = (Matrix3::zeros(), Vector3::zeros());
    for ((s, y), d) in fixed.iter().zip(places).zip(moved) {
        let [s, y, d] = [*s, *y, *d].map(Vector3::from);
        inertia += Matrix3::identity() * s.dot(&y) - y * s.transpose();
        moment += s.cross(&d);
    }
    let moment = inertia.transpose() * moment;
    let (values, vectors) = symmetric_eigen((inertia.transpose() * inertia).into());
    let along = |k: usize| Vector3::from(vectors[k]) * (moment.dot(&Vector3::from(vectors[k])) / values[k]);
    let turn: Vector3<f64> = (0..3).filter(|&k| values[k] > 1e-12 * values[2]).map(along).sum();
    turn.into()
}

/// Indices of two targets of a part.
#[derive(Clone, Copy, Debug)]
pub struct TargetPair {
    /// The first.
    pub first: usize,
    /// The second.
    pub second: usize,
}

impl TargetPair {
    /// Distance of the two (mm).
    pub fn distance_mm(self, places_mm: &[Vector]) -> f64 {
        norm(minus(places_mm[self.first], places_mm[self.second]))
    }
}

impl RigidPart {
    /// All pairs of targets.
    pub fn pairs(&self) -> impl Iterator<Item = TargetPair> {
        (0..self.targets.len()).flat_map(|second| (0..second).map(move |first| TargetPair { first, second }))
    }

    /// Compares the distance of two targets, as found `by` a measurement, with the given
    /// positions.
    pub fn contradicted(&self, pair: TargetPair, found_mm: f64, by: &'static str) -> Contradicted {
        let stated_mm = pair.distance_mm(&self.places_mm);
        Contradicted {
            targets: self.targets.clone(),
            pair: [pair.first, pair.second].map(|i| self.targets[i].clone()),
            by,
            found_mm,
            stated_mm,
            is_near: (found_mm - stated_mm).abs() <= self.tolerance_mm,
        }
    }
}

/// A distance of two targets that contradicts the given positions of their part.
#[derive(Clone, Debug, PartialEq)]
pub struct Contradicted {
    /// Targets of the part.
    pub targets: Vec<String>,
    /// The two targets.
    pub pair: [String; 2],
    /// Source of the distance: `identification` or `measurement`.
    pub by: &'static str,
    /// The distance, mm.
    pub found_mm: f64,
    /// Distance of the given positions (mm).
    pub stated_mm: f64,
    /// `false` if the distance belongs to another part.
    pub is_near: bool,
}

impl Contradicted {
    /// Message with a name for the given positions; an error if the distance belongs to another
    /// part.
    pub fn message(&self, places: &(impl IntoArgument + ?Sized)) -> Message {
        let Self { targets, by, found_mm, stated_mm, pair: [first, second], is_near } = self;
        let severity = if *is_near { Severity::Warning } else { Severity::Error };
        let message = error!("rigid-part-contradicted", places, targets, first, second, found_mm, by, stated_mm);
        if *is_near { Message { severity, rank: Rank::Know, ..message } } else { message }
    }
}
