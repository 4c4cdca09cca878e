//! Test of given parameters on new observations, and the change that explains a rejection.
//!
//! Residuals of the given parameters have the covariance S of the measurement and of the parameters
//! themselves. In the space of the changes that are looked for (the base, and the zero of each
//! joint) and outside of it, rᵀ S⁻¹ r is of chi-square, or of F where the variance is estimated:
//! two independent tests that have the significance level together (Šidák 1967). A change adds a
//! noncentrality δᵀ Aᵀ S⁻¹ A δ, from which follow the power of the test and the least change that
//! it detects (Baarda 1968, reliability).

use crate::Result;
use crate::judgement::misfit::{Misfit, Whitening};
use crate::judgement::significance::{Variance, bisect};
use crate::model::residuals::Residuals;
use crate::{Observation, Settings};
use etalon_base::error;
use etalon_base::pose::{Pose, Vector, cross, minus};
use etalon_math::Problem;
use etalon_robots::Robot;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn, SymmetricEigen};
use statrs::function::erf::erfc;

/// Significance level: share of unchanged robots that are called changed.
pub const SIGNIFICANCE: f64 = 0.05;
/// Power for which the smallest detectable change is given.
pub const POWER: f64 = 0.95;
/// Probability of naming the right joint for which the smallest change is given.
pub const NAMING: f64 = 0.9;
/// Minimum probability of the remaining residuals with which a change explains them.
pub const EXPLAINED: f64 = 0.01;
/// Convergence tolerance: step length in standard uncertainties.
const SETTLED: f64 = 1e-10;
/// Maximum number of steps towards a large motion.
const ITERATIONS: usize = 20;
/// Convergence tolerance: explained share of the sum of squares.
const CONVERGED: f64 = 1e-3;
/// Directions of changes whose information, relative to the largest, is below this are
/// unobservable.
const RANK: f64 = 1e-10;

/// Parameters as they were identified.
#[derive(Clone, Debug, PartialEq)]
pub struct IdentifiedParameters {
    /// All parameters of the robot in its order (mm, rad, 1).
    pub values: Vec<f64>,
    /// Indices of the parameters with an uncertainty, in the order of `covariance`.
    pub free: Vec<usize>,
    /// Covariance of these, row by row (mm, rad, 1).
    pub covariance: Vec<f64>,
}

/// Candidate for a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moved {
    /// The base, or the origin of the world frame: a shift and a rotation.
    Base,
    /// The zero of a joint, by its index.
    Joint(usize),
    /// A target on the moving part, by its index.
    Target(usize),
}

/// Size of a change if it is the only one.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// Changed part.
    pub moved: Moved,
    /// Change: of the base a shift (mm) at its origin and a rotation vector (rad) in the world, x y
    /// and z of both, or x, y and the angle in the plane; of a joint its value (mm or rad); of a
    /// target x y z on the part (mm).
    pub change: Vec<f64>,
    /// Standard uncertainties of the change; infinite for unobservable values.
    pub standard_uncertainty: Vec<f64>,
    /// Probability of residuals as large as the remaining ones.
    pub p_left: f64,
    /// Part of the sum of squares that the change explains.
    pub explained: f64,
    /// Probability that any of the candidates explains as much if nothing has changed (Šidák 1967).
    pub p_change: f64,
}

impl Explanation {
    /// `true` if the change is significant, and the remaining residuals agree with the parameters.
    /// Remaining residuals that are only noise do not prove that a part changed.
    pub fn suffices(&self) -> bool {
        self.p_left > EXPLAINED && self.is_significant()
    }

    /// `true` if noise explains so large a change with a probability below [`SIGNIFICANCE`].
    pub fn is_significant(&self) -> bool {
        self.p_change < SIGNIFICANCE
    }
}

/// The smallest change that is detected with the probability [`POWER`], if it is the only one;
/// infinite if the observations do not show it.
#[derive(Clone, Debug, PartialEq)]
pub struct Detectable {
    /// Changed part.
    pub moved: Moved,
    /// Detectable change: of the base the smallest visible shift (mm) and a rotation about its axis
    /// (rad); of a joint its value (mm or rad).
    pub change: Vec<f64>,
    /// The smallest change of a joint that is detected and attributed to no other joint with the
    /// probability [`NAMING`] (separability, Förstner 1983); infinite if another joint moves all
    /// targets alike.
    pub named: Option<f64>,
}

/// One of the two tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// Sum of squares over their variance.
    pub sum: f64,
    /// Degrees of freedom of this sum.
    pub degrees_of_freedom: usize,
    /// Probability of a larger sum if nothing has changed.
    pub p_value: f64,
}

/// Result of testing given parameters on new observations.
#[derive(Clone, Debug, PartialEq)]
pub struct Verification {
    /// Residuals that changes of base and joints could make.
    pub of_changes: Test,
    /// All other residuals.
    pub of_rest: Test,
    /// Probability of both, if nothing has changed.
    pub p_value: f64,
    /// Root mean square (mm) of the residual of a coordinate; zero without positions.
    pub rms_mm: f64,
    /// Expected root mean square (mm) if nothing has changed; zero without positions.
    pub expected_rms_mm: f64,
    /// Possible changes, the best explanation first: sufficient ones, ordered by their number of
    /// values.
    pub explanations: Vec<Explanation>,
    /// Changes that these observations can detect.
    pub detectable: Vec<Detectable>,
}

impl Verification {
    /// `true` if the observations contradict the parameters.
    pub fn is_changed(&self) -> bool {
        self.p_value.is_nan() || self.p_value < SIGNIFICANCE
    }

    /// Changed part, if the parameters are contradicted and one change explains it.
    pub fn cause(&self) -> Option<&Explanation> {
        self.explanations.first().filter(|e| self.is_changed() && e.suffices())
    }
}

/// Observations, and the parameters with which they are compared.
#[derive(Clone, Copy)]
pub struct Comparison<'a> {
    /// The robot.
    pub robot: &'a dyn Robot,
    /// Observations of positions; empty if all observations are conditions of the settings.
    pub observations: &'a [Observation],
    /// Settings with conditions, which must give the standard uncertainty of a coordinate.
    pub settings: &'a Settings,
    /// The parameters.
    pub given: &'a IdentifiedParameters,
    /// Errors of the model beyond the errors of the parameters.
    pub misfit: &'a Misfit,
}

impl Comparison<'_> {
    /// Compares the observations with the given parameters; `variance` is the source of the
    /// standard uncertainty of a coordinate.
    ///
    /// # Errors
    /// Fails without a standard uncertainty, at joint values at which the robot has no pose, and
    /// with a covariance that is not positive definite.
    pub fn verify(self, variance: Variance) -> Result<Verification> {
        let space = Space::new(self)?;
        let all = space.columns();
        let (whole, n) = (space.sum(), space.r.len());
        let [of_changes, of_rest] = space.tests(&all, variance);
        let explain = |(moved, columns): (Moved, DMatrix<f64>)| {
            let fit = space.fit(&columns);
            let left = (whole - fit.explained).max(0.0);
            Explanation {
                moved,
                change: fit.change.iter().copied().collect(),
                standard_uncertainty: fit.standard_uncertainty,
                p_left: variance.exceedance_of_residuals(left, n - fit.rank),
                explained: fit.explained,
                p_change: variance.exceedance(fit.explained, fit.rank),
            }
        };
        let parts =
            all.parts.iter().map(|&(moved, first, count)| (moved, all.columns.columns(first, count).into_owned()));
        let targets = space.targets().into_iter().map(|(target, columns)| (Moved::Target(target), columns));
        let mut explanations: Vec<Explanation> = parts.chain(targets).map(explain).collect();
        let limits = Limits::new(variance, of_changes.degrees_of_freedom, of_rest.degrees_of_freedom);
        let p_value = Test::together(&of_changes, &of_rest);
        let agrees = |e: &Explanation| e.p_left > EXPLAINED;
        if p_value < SIGNIFICANCE && !explanations.iter().any(agrees) {
            // a large motion is not linear
            for explanation in &mut explanations {
                let refined = self.refine(explanation.moved, variance, whole);
                *explanation = refined.unwrap_or_else(|| explanation.clone());
            }
        }
        let candidates = explanations.len() as f64;
        explanations.iter_mut().for_each(|e| e.p_change = 1.0 - (1.0 - e.p_change).powf(candidates));
        explanations.sort_by(|a, b| {
            let needs = |e: &Explanation| (!e.suffices(), if agrees(e) { e.change.len() } else { usize::MAX });
            needs(a).cmp(&needs(b)).then(b.explained.total_cmp(&a.explained))
        });
        let [rms_mm, expected_rms_mm] = space.rms_mm();
        Ok(Verification {
            p_value,
            of_changes,
            of_rest,
            rms_mm,
            expected_rms_mm,
            detectable: space.detectable(&all, &limits),
            explanations,
        })
    }

    /// Returns the p value of [`Self::verify`] alone.
    ///
    /// # Errors
    /// Fails like [`Self::verify`].
    pub fn p_value(self, variance: Variance) -> Result<f64> {
        let space = Space::new(self)?;
        let [of_changes, of_rest] = space.tests(&space.columns(), variance);
        Ok(Test::together(&of_changes, &of_rest))
    }

    /// Returns the smallest changes that observations at these poses can detect, wherever their
    /// targets are measured, as in [`Self::verify`].
    ///
    /// # Errors
    /// Fails like [`Self::verify`].
    pub fn detectable(self, variance: Variance) -> Result<Vec<Detectable>> {
        let space = Space::new(self)?;
        let all = space.columns();
        let [of_changes, of_rest] = space.tests(&all, variance);
        Ok(space.detectable(&all, &Limits::new(variance, of_changes.degrees_of_freedom, of_rest.degrees_of_freedom)))
    }

    /// Most probable values of all parameters for the observations and the covariance of the given
    /// parameters: x = x₀ + L z with z = (I + Bᵀ B)⁻¹ Bᵀ (r + B z), by the Gauss-Newton
    /// method.
    ///
    /// # Errors
    /// Fails like [`Self::verify`].
    pub fn most_probable(self) -> Result<Vec<f64>> {
        let given = self.given;
        let mut place = given.clone();
        let mut z = DVector::zeros(given.free.len());
        for _ in 0..ITERATIONS {
            let space = Space::new(Comparison { given: &place, ..self })?;
            let Some(inner) = &space.inner else { break };
            let next = inner.solve(&space.b.tr_mul(&(&space.r + &space.b * &z)));
            let step = (&next - &z).norm();
            z = next;
            let moved = &space.root * &z;
            given.free.iter().zip(moved.iter()).for_each(|(&i, by)| place.values[i] = given.values[i] + by);
            if step < SETTLED {
                break;
            }
        }
        Ok(place.values)
    }

    /// The motion with the largest explained share, if it is too large to be linear, by the
    /// Gauss-Newton method; `None` if this does not converge.
    fn refine(self, moved: Moved, variance: Variance, whole: f64) -> Option<Explanation> {
        if self.observations.is_empty() {
            return None;
        }
        let mut change = vec![0.0; 3];
        let mut motion = Pose::identity();
        // positions determine a large motion
        let positions = Settings { conditions: Vec::new(), known: Vec::new(), ..self.settings.clone() };
        for _ in 0..ITERATIONS {
            let (mut back, mut place) = (self.observations.to_vec(), self.given.clone());
            let origin = self.robot.base_origin(&self.given.values);
            match moved {
                Moved::Joint(j) => back.iter_mut().for_each(|o| o.joints[j] += change[0]),
                Moved::Target(k) => {
                    let first = self.robot.free_base()?.target_place(k);
                    place.values[first..first + 3].iter_mut().zip(&change).for_each(|(v, c)| *v += c);
                }
                Moved::Base => back.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(|p| {
                    let placed = motion.inverse().apply(minus(*p, origin));
                    *p = std::array::from_fn(|i| origin[i] + placed[i]);
                }),
            }
            let positions = Comparison { observations: &back, settings: &positions, given: &place, ..self };
            let space = Space::new(positions).ok()?;
            let fit = space.fit(&space.derivatives_by(moved)?);
            let left = space.sum() - fit.explained;
            change.iter_mut().zip(fit.change.iter()).for_each(|(sum, step)| *sum += step);
            if moved == Moved::Base {
                let small = |i: usize| fit.change[i];
                let (shift, turn) = match fit.change.len() {
                    3 => ([small(0), small(1), 0.0], [0.0, 0.0, small(2)]),
                    _ => ([small(0), small(1), small(2)], [small(3), small(4), small(5)]),
                };
                motion = motion.then(&Pose { translation_mm: shift, ..Pose::from_rotation_vector(turn) });
            }
            if fit.explained < CONVERGED {
                let ([x, y, z], [rx, ry, rz]) = (motion.translation_mm, motion.rotation_vector_rad());
                let change = match (moved, self.robot.dimension()) {
                    (Moved::Base, 2) => vec![x, y, rz],
                    (Moved::Base, _) => vec![x, y, z, rx, ry, rz],
                    (Moved::Joint(_), _) => vec![change[0]],
                    (Moved::Target(_), _) => change,
                };
                let p_left = variance.exceedance_of_residuals(left.max(0.0), space.r.len() - fit.rank);
                let explained = whole - left;
                return Some(Explanation {
                    moved,
                    change,
                    standard_uncertainty: fit.standard_uncertainty,
                    p_left,
                    explained,
                    p_change: variance.exceedance(explained, fit.rank),
                });
            }
        }
        None
    }
}

/// Both tests together.
struct Limits {
    variance: Variance,
    dof: usize,
    bound: f64,
    /// Probability that the rest, which no change affects, is within its limit.
    quiet: f64,
    /// Noncentrality that is detected with [`POWER`]; infinite if the observations do not show the
    /// change.
    detected: f64,
}

impl Limits {
    fn new(variance: Variance, dof: usize, rest: usize) -> Self {
        let two = rest > 0 && dof > 0;
        let level = if two { 1.0 - (1.0 - SIGNIFICANCE).sqrt() } else { SIGNIFICANCE };
        let quiet = if two { 1.0 - level } else { 1.0 };
        let bound = variance.bound(level, dof.max(1));
        let mut limits = Self { variance, dof, bound, quiet, detected: f64::INFINITY };
        if dof > 0 {
            limits.detected = bisect(|noncentrality| limits.power(noncentrality) >= POWER);
        }
        limits
    }

    /// Probability of calling a robot changed whose change adds this noncentrality.
    fn power(&self, noncentrality: f64) -> f64 {
        1.0 - self.quiet * (1.0 - self.variance.power(self.bound, self.dof, noncentrality))
    }

    /// Returns the smallest detectable change along the least visible direction of these columns.
    fn detectable(&self, information: &DMatrix<f64>, first: usize, count: usize) -> f64 {
        let own = information.view((first, first), (count, count)).into_owned();
        let (shown, least) = (own.trace(), SymmetricEigen::new(own).eigenvalues.min());
        if least <= RANK * shown {
            return f64::INFINITY;
        }
        (self.detected / least).sqrt()
    }

    /// The smallest change of one column that is detected and that no other column explains better.
    fn named(&self, information: &DMatrix<f64>, column: usize, others: &[usize]) -> f64 {
        let own = information[(column, column)];
        // two estimates that are correlated by ρ change places with the probability Φ(−√(λ (1 −
        // |ρ|) / 2))
        let apart = |&other: &usize| {
            let alike = information[(column, other)].abs() / (own * information[(other, other)]).sqrt();
            if alike.is_finite() { (0.5 * (1.0 - alike)).max(0.0) } else { 0.5 }
        };
        let apart: Vec<f64> = others.iter().map(apart).collect();
        let mistaken = |noncentrality: f64| {
            let one = |apart: &f64| 0.5 * erfc((0.5 * apart * noncentrality).sqrt());
            EXPLAINED + apart.iter().map(one).sum::<f64>()
        };
        if own <= 0.0 || self.dof == 0 || apart.iter().any(|apart| *apart < RANK) {
            return f64::INFINITY;
        }
        let suffices = |noncentrality: f64| {
            let power = self.power(noncentrality);
            power >= POWER && power - mistaken(noncentrality) >= NAMING
        };
        (bisect(suffices) / own).sqrt()
    }
}

/// Whitened residuals of the given parameters, and their covariance S = I + B Bᵀ with B = J L, L Lᵀ
/// the covariance of the parameters.
struct Space<'a> {
    of: Comparison<'a>,
    problem: Residuals<'a>,
    shared: Whitening,
    x: Vec<f64>,
    /// Measured minus predicted values.
    r: DVector<f64>,
    /// Root L of the covariance, a row for each element of `x`.
    root: DMatrix<f64>,
    b: DMatrix<f64>,
    inner: Option<Cholesky<f64, Dyn>>,
}

/// Columns of all changes, with the first column and the number of columns of each.
struct Columns {
    columns: DMatrix<f64>,
    parts: Vec<(Moved, usize, usize)>,
}

/// The change with the largest explained share, by generalised least squares.
struct Fit {
    change: DVector<f64>,
    standard_uncertainty: Vec<f64>,
    explained: f64,
    rank: usize,
}

impl Test {
    /// Mean square over its expected value; NaN without degrees of freedom.
    pub fn mean_square(&self) -> f64 {
        self.sum / self.degrees_of_freedom as f64
    }

    /// Probability of two tests, of which one may have no degrees of freedom.
    fn together(changes: &Self, rest: &Self) -> f64 {
        let least = changes.p_value.min(rest.p_value);
        let two = changes.degrees_of_freedom > 0 && rest.degrees_of_freedom > 0;
        if two { 1.0 - (1.0 - least).powi(2) } else { least }
    }
}

impl<'a> Space<'a> {
    fn new(of: Comparison<'a>) -> Result<Self> {
        let Comparison { robot, observations, settings, given, misfit } = of;
        if settings.standard_uncertainty_mm.is_none() {
            return Err(error!("comparison-without-uncertainty").into());
        }
        // all that has an uncertainty; of parameters that have none, one to stand for the columns
        let free = if given.free.is_empty() { vec![0] } else { given.free.clone() };
        let mut problem = Residuals::new(robot, observations, settings, &free, &given.values)?;
        // the covariance has a column for each parameter
        problem.layout = None;
        let x: Vec<f64> = free.iter().map(|&i| given.values[i]).collect();
        let (m, n) = (problem.residual_count(), free.len());
        let (mut r, mut jacobian) = (vec![0.0; m], vec![0.0; m * n]);
        problem.residuals(&x, &mut r);
        problem.jacobian(&x, &mut jacobian);
        if r.iter().chain(&jacobian).any(|v| !v.is_finite()) {
            return Err(error!("robot-not-at-joints", parameters = "given").into());
        }
        let shared = Whitening::new(misfit, &problem, robot, observations, settings);
        shared.whiten(&mut r, 1);
        shared.whiten(&mut jacobian, n);
        let count = given.free.len();
        let root = match count {
            0 => DMatrix::zeros(n, 0),
            _ => root(DMatrix::from_row_slice(count, count, &given.covariance))?,
        };
        let b = DMatrix::from_row_slice(m, n, &jacobian) * &root;
        let inner = Cholesky::new(DMatrix::identity(b.ncols(), b.ncols()) + b.transpose() * &b);
        Ok(Self { of, problem, shared, x, r: -DVector::from_vec(r), root, b, inner })
    }

    /// S⁻¹ X (Woodbury).
    fn solve(&self, columns: &DMatrix<f64>) -> DMatrix<f64> {
        match &self.inner {
            Some(inner) => columns - &self.b * inner.solve(&(self.b.transpose() * columns)),
            None => columns.clone(),
        }
    }

    /// Returns the smallest detectable change of each of these.
    fn detectable(&self, all: &Columns, limits: &Limits) -> Vec<Detectable> {
        let information = all.columns.transpose() * self.solve(&all.columns);
        let of = |&(moved, first, count): &(Moved, usize, usize)| {
            let shifts = if moved == Moved::Base { count - count / 2 } else { 0 };
            let halves = [(first, shifts), (first + shifts, count - shifts)].into_iter().filter(|half| half.1 > 0);
            let change = halves.map(|(first, count)| limits.detectable(&information, first, count)).collect();
            let others = all.parts.iter().filter(|(other, ..)| matches!(other, Moved::Joint(_)) && *other != moved);
            let others: Vec<usize> = others.map(|other| other.1).collect();
            let named = matches!(moved, Moved::Joint(_)).then(|| limits.named(&information, first, &others));
            Detectable { moved, change, named }
        };
        all.parts.iter().map(of).collect()
    }

    /// Sum rᵀ S⁻¹ r.
    fn sum(&self) -> f64 {
        let r = DMatrix::from_column_slice(self.r.len(), 1, self.r.as_slice());
        r.dot(&self.solve(&r))
    }

    /// The tests of the residuals that these changes can cause, and of the rest.
    fn tests(&self, all: &Columns, variance: Variance) -> [Test; 2] {
        let fit = self.fit(&all.columns);
        let rest = (self.sum() - fit.explained).max(0.0);
        let left = self.r.len() - fit.rank;
        let (p_changes, p_rest) =
            (variance.exceedance(fit.explained, fit.rank), variance.exceedance_of_residuals(rest, left));
        [(fit.explained, fit.rank, p_changes), (rest, left, p_rest)].map(|(sum, degrees_of_freedom, p_value)| Test {
            sum,
            degrees_of_freedom,
            p_value,
        })
    }

    /// Root mean square (mm) of the residual of a coordinate, and its expected value.
    fn rms_mm(&self) -> [f64; 2] {
        let (all, d) = (self.r.len(), self.of.robot.dimension());
        let mut r = vec![0.0; all];
        self.problem.plain_residuals(&self.x, &mut r);
        let mut jacobian = vec![0.0; all * self.x.len()];
        self.problem.plain_jacobian(&self.x, &mut jacobian);
        // the first rows are coordinates of targets
        let n = self.problem.coordinate_count();
        if n == 0 {
            return [0.0; 2];
        }
        r.truncate(n);
        let ours = DMatrix::from_row_slice(n, self.x.len(), &jacobian[..n * self.x.len()]) * &self.root;
        let unit2 = self.problem.unit.powi(2);
        let stated2 = self.of.settings.standard_uncertainty_mm.unwrap_or(0.0).powi(2);
        let of_reading = |o: &Observation, k: usize| match o.covariances_mm2.get(k).copied().flatten() {
            Some(covariance) => (0..d).map(|i| covariance[i][i]).sum::<f64>(),
            None => d as f64 * stated2,
        };
        let seen = self.of.observations.iter().flat_map(|o| (0..o.targets.len()).map(move |k| (o, k)));
        let measured: f64 = seen.filter(|(o, k)| o.targets[*k].is_some()).map(|(o, k)| of_reading(o, k)).sum();
        let misfit = n as f64 * self.of.misfit.coordinate_mm.powi(2);
        let squares: f64 = r.iter().map(|r| r * r).sum();
        [unit2 * squares, measured + misfit + unit2 * ours.norm_squared()].map(|sum| (sum / n as f64).sqrt())
    }

    /// Rows of `width` numbers, which are whitened but for the errors that readings share. Rows of
    /// given values, which no motion changes, may be missing at the end.
    fn whitened(&self, mut rows: Vec<f64>, width: usize) -> DMatrix<f64> {
        rows.resize(self.r.len() * width, 0.0);
        self.shared.whiten(&mut rows, width);
        DMatrix::from_row_slice(self.r.len(), width, &rows)
    }

    /// Derivatives of measured minus predicted values with respect to base and joints.
    fn columns(&self) -> Columns {
        let m = self.r.len();
        let frame = self.whitened(self.problem.base_jacobian(&self.x), 6);
        let planar = self.of.robot.dimension() == 2;
        let axes: &[usize] = if planar { &[0, 1, 5] } else { &[0, 1, 2, 3, 4, 5] };
        let mut columns = DMatrix::zeros(m, axes.len());
        // a rotation about the origin of the base: p moves by ω × (p − o)
        let origin = self.of.robot.base_origin(&self.of.given.values);
        for (k, &axis) in axes.iter().enumerate() {
            let mut column = frame.column(axis).into_owned();
            if axis > 2 {
                let turn: Vector = std::array::from_fn(|i| f64::from(u8::from(i == axis - 3)));
                let lever = cross(turn, origin);
                (0..3).for_each(|i| column -= frame.column(i) * lever[i]);
            }
            columns.set_column(k, &column);
        }
        let joints = self.of.robot.joints().len();
        let rows = self.whitened(self.problem.joint_jacobian(&self.x), joints);
        let base = (Moved::Base, 0, axes.len());
        let parts = std::iter::once(base).chain((0..joints).map(|j| (Moved::Joint(j), axes.len() + j, 1)));
        let mut all = DMatrix::zeros(m, axes.len() + joints);
        all.columns_mut(0, axes.len()).copy_from(&columns);
        all.columns_mut(axes.len(), joints).copy_from(&rows);
        Columns { columns: all, parts: parts.collect() }
    }

    /// Derivatives of measured minus predicted values with respect to one of these.
    fn derivatives_by(&self, moved: Moved) -> Option<DMatrix<f64>> {
        if let Moved::Target(k) = moved {
            return self.targets().into_iter().find(|(target, _)| *target == k).map(|(_, columns)| columns);
        }
        let all = self.columns();
        let (_, first, count) = *all.parts.iter().find(|part| part.0 == moved)?;
        Some(all.columns.columns(first, count).into_owned())
    }

    /// Derivatives of measured minus predicted values with respect to the position of each target
    /// on the part, if the model has these parameters.
    fn targets(&self) -> Vec<(usize, DMatrix<f64>)> {
        let Some(arm) = self.of.robot.free_base() else { return Vec::new() };
        let of = |target: usize| {
            let first = arm.target_place(target);
            let free: Vec<usize> = (first..first + 3).collect();
            let x: Vec<f64> = free.iter().map(|&i| self.of.given.values[i]).collect();
            let problem =
                Residuals::new(self.of.robot, self.of.observations, self.of.settings, &free, &self.of.given.values)
                    .ok()?;
            let mut jacobian = vec![0.0; self.r.len() * 3];
            problem.jacobian(&x, &mut jacobian);
            Some((target, self.whitened(jacobian, 3)))
        };
        (0..self.of.robot.targets().len()).filter_map(of).collect()
    }

    fn fit(&self, columns: &DMatrix<f64>) -> Fit {
        let solved = self.solve(columns);
        let (information, right) = (columns.transpose() * &solved, solved.transpose() * &self.r);
        // columns of one length: mm and rad alike
        let scale = information.diagonal().map(|d| if d > 0.0 { 1.0 / d.sqrt() } else { 0.0 });
        let scaled = DMatrix::from_fn(scale.len(), scale.len(), |i, j| scale[i] * information[(i, j)] * scale[j]);
        let eigen = SymmetricEigen::new(scaled);
        let most = eigen.eigenvalues.max();
        let mut covariance = DMatrix::zeros(scale.len(), scale.len());
        let (mut rank, mut unseen) = (0, DVector::zeros(scale.len()));
        for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
            if *value > RANK * most && most > 0.0 {
                covariance += vector * vector.transpose() / *value;
                rank += 1;
            } else {
                unseen += vector.map(|v| v * v);
            }
        }
        let covariance = DMatrix::from_fn(scale.len(), scale.len(), |i, j| scale[i] * covariance[(i, j)] * scale[j]);
        let change = &covariance * &right;
        let u = |i: usize| if unseen[i] > 1e-6 || scale[i] == 0.0 { f64::INFINITY } else { covariance[(i, i)].sqrt() };
        Fit { explained: change.dot(&right), standard_uncertainty: (0..scale.len()).map(u).collect(), change, rank }
    }
}

/// L with L Lᵀ equal to the covariance, also if rounding makes it singular.
fn root(covariance: DMatrix<f64>) -> Result<DMatrix<f64>> {
    let scale = covariance.diagonal().map(|v| v.sqrt());
    let divided = DMatrix::from_fn(scale.len(), scale.len(), |i, j| match scale[i] * scale[j] {
        0.0 => 0.0,
        s => covariance[(i, j)] / s,
    });
    let eigen = SymmetricEigen::new(divided);
    if eigen.eigenvalues.min() <= -1e-6 {
        return Err(error!("covariance-not-positive-definite").into());
    }
    let mut root = eigen.eigenvectors;
    for (mut column, value) in root.column_iter_mut().zip(eigen.eigenvalues.iter()) {
        column *= value.max(0.0).sqrt();
    }
    for (mut row, s) in root.row_iter_mut().zip(scale.iter()) {
        row *= *s;
    }
    Ok(root)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixture;
    use crate::model::kinds::{Condition, Contact, Kind, Known};
    use etalon_base::noise::Noise;
    use etalon_robots::{Serial, SerialJoint};

    /// Standard uncertainty (mm) of a contact.
    const U_MM: f64 = 0.01;

    /// An arm whose ball touches a socket of its own at each of 14 poses, after its base has moved
    /// along x (mm) and a zero by `joint` (rad). A table states the place of the first socket.
    fn touching(trial: u64, base_x_mm: f64, joint: (usize, f64)) -> (Serial, Settings, IdentifiedParameters) {
        let link = |&[alpha_rad, a_mm, theta_rad, d_mm]: &[f64; 4]| SerialJoint {
            alpha_rad,
            a_mm,
            theta_rad,
            d_mm,
            prismatic: false,
            parallel: false,
        };
        let table = [[0.0, 0.0, 0.0, 290.0], [-1.5, 0.0, -1.5, 0.0], [0.1, 270.0, 0.0, 0.0], [-1.5, 70.0, 0.0, 302.0]];
        let links: Vec<SerialJoint> = table.iter().map(link).collect();
        let mut robot = Serial::new(&links, &["ball".to_owned()], [0.0, 0.0, -1.0], &[], &[]);
        let sockets: Vec<usize> = (0..14).map(|k| Fixture::Point(&format!("s{k}")).add_to(&mut robot)).collect();
        let mut values = robot.nominal();
        values[6..9].copy_from_slice(&[60.0, 20.0, 80.0]);
        let mut noise = Noise::new(23, trial);
        let mut conditions = Vec::new();
        for (k, &socket) in sockets.iter().enumerate() {
            let logged: Vec<f64> = (0..4).map(|_| noise.uniform(1.2)).collect();
            let mut real = logged.clone();
            real[joint.0] += joint.1;
            let at = robot.position(&values, &real, 0).map(|v| v + noise.gaussian(U_MM));
            values[socket..socket + 3].copy_from_slice(&[at[0] + base_x_mm, at[1], at[2]]);
            conditions.push(Condition {
                pose: (k as i64).into(),
                cycle: 1,
                joints: logged,
                target: 0,
                kind: Kind::Contact(Contact { socket }),
                standard_uncertainty: U_MM,
            });
        }
        let place_mm = std::array::from_fn(|i| values[sockets[0] + i]);
        let known = Known::Place { point: sockets[0], place_mm, standard_uncertainty_mm: U_MM };
        let settings =
            Settings { standard_uncertainty_mm: Some(U_MM), conditions, known: vec![known], ..Settings::default() };
        (robot, settings, IdentifiedParameters { values, free: Vec::new(), covariance: Vec::new() })
    }

    fn verified(trial: u64, base_x_mm: f64, joint: (usize, f64)) -> Verification {
        let (robot, settings, given) = touching(trial, base_x_mm, joint);
        let misfit = Misfit { conditions: vec![0.0; settings.conditions.len()], ..Misfit::default() };
        let comparison =
            Comparison { robot: &robot, observations: &[], settings: &settings, given: &given, misfit: &misfit };
        comparison.verify(Variance::Stated).expect("verified")
    }

    /// Contacts without a single position, and stated values beside them.
    #[test]
    fn contacts_alone_are_verified() {
        let unchanged = |trial: u64| verified(trial, 0.0, (0, 0.0));
        // two of forty are expected; more than six have a probability of 0.3 %
        let alarms = (0..40).filter(|trial| unchanged(*trial).is_changed()).count();
        assert!(alarms <= 6, "{alarms}");
        let one = unchanged(0);
        assert!(one.of_rest.degrees_of_freedom > 30, "{one:?}");
        assert_eq!([one.rms_mm, one.expected_rms_mm], [0.0; 2]);
        let moved = verified(0, 0.0, (1, 0.002));
        let cause = moved.cause().expect("a cause");
        assert!(cause.moved == Moved::Joint(1) && (cause.change[0] - 0.002).abs() < 1e-4, "{cause:?}");
        let moved = verified(0, 0.3, (0, 0.0));
        let cause = moved.cause().expect("a cause");
        assert!(cause.moved == Moved::Base && (cause.change[0] - 0.3).abs() < 0.05, "{cause:?}");
    }
}
