//! Identification: parameters from observations, the parameters that the data determine, and their
//! uncertainty.
#![allow(non_snake_case)] // world_T_base: frames in names

pub mod axes;
pub mod cell;
mod error;
mod field;
pub mod geometric;
mod judge;
mod judgement;
mod model;
pub mod plan;
mod solution;
mod warning;

pub use error::{Cause, Error};
pub use field::{Component, Corrected, FieldInput, FieldRefusal, FieldTrial, HeldOut, JointField, search_field};
pub use judge::{
    Judgement, OrientationReading, ReadingSlips, Untested, WrongCoordinate, allowed_mm, far_problem, judge,
    moved_between, nominal_reading_slips, reading_slips, set_up_contradicted, set_up_error, set_up_far, set_up_problem,
    tolerance_effect_mm, untested_changes,
};
pub use judgement::beyond::Extrapolation;
pub use judgement::bound::{ASSUMED_MM, COVERAGE, Excess, Extent, OpenMotion, OpenSetUp, UncertaintyBound};
pub use judgement::budget::{Budget, Contributions, Figure, Replicates, Systematic, UncertaintySource};
pub use judgement::chi_square::agrees as chi_square_agrees;
pub use judgement::chi_square::exceeds as chi_square_exceeds;
pub use judgement::chi_square::{REJECT as CHI_SQUARE_SIGNIFICANCE, probability as chi_square_probability};
pub use judgement::diagnosis::{GROSS, LEAST_RESIDUAL, OUTLIER, Reading, ReadingSource, RobustFit};
pub use judgement::excitation::{Unmoved, left_to_tolerances, unmoved};
pub use judgement::figures::{ConditionResiduals, ErrorKind, FigureUncertainty, JudgedErrors, ReadingKind};
pub use judgement::loads::{LoadContradiction, LoadSlip, load_slips};
pub use judgement::logs::{LogComparison, compare_logs};
pub use judgement::misfit::Misfit;
pub use judgement::predict::{Prediction, Sensitivity, predict, sensitivity};
pub use judgement::ratio::MeasuredRatio;
pub use judgement::regional::BetweenSeries;
pub use judgement::relative::{DistanceErrors, RelativeErrors};
pub use judgement::reliability::{
    ALPHA_0, BETA_0, CRITICAL_W, PoseInfluence, ReadingReliability, Reliability, reliability,
};
pub use judgement::robust::{PoseWeight, RobustChange, RobustComparison, robust_comparison};
pub use judgement::significance::{Variance, exceeds_zero, holm};
pub use judgement::stability::{Stability, StabilityTest, halves, stability};
pub use judgement::tool::{Held, ToolError, ToolFrame, ToolPoint, ToolPrediction, held};
pub use judgement::uncertainty::UncertaintyFrom;
pub use judgement::verification::{
    Comparison, Detectable, EXPLAINED, Explanation, IdentifiedParameters, Moved, NAMING, POWER, SIGNIFICANCE, Test,
    Verification,
};
pub use model::effects::{Effects, effects};
pub use model::fixture::Fixture;
pub use model::frame_error::FrameError;
use model::kinds::tied_to_world;
pub use model::kinds::{
    Between, Condition, Contact, Coordinate, Distance, JointValue, Kind, Known, KnownResidual, On, Orientation, Seen,
    Separation, Surface, mounted_misfit_rad, mounted_misfits_rad,
};
pub use model::observation::{
    AssumedModes, Contradiction, Distances, Measured, Observation, ObservationError, directions,
};
pub use model::prior::Prior;
pub use model::residuals::{OF_MEDIAN, ResidualKind};
pub use model::rigid_part::{Contradicted, RigidPart, TargetPair};
pub use model::weights::{Covariance, is_positive_definite, turned, weigh};
pub use solution::identifiability::{Group, RANK_TOLERANCE};
pub use solution::locate::{Placement, locate_points};
pub use solution::observability::{Observability, SingularValue, WeakGroup};
pub use solution::scatter::observed_noise_mm;
pub use solution::start::NOISE_DISTANCE;
pub use warning::{Origin, SetUpError, Subject, Warning};

use etalon_base::error;
use etalon_base::pattern::matches_pattern;
use etalon_base::pose_name::PoseName;
use etalon_math::{Factor, Linearised, Options, Problem, Quadratic, Termination, solve, solve_near, svd};
use etalon_robots::{Robot, Role};
use model::residuals::{Common, Residuals};
use model::solved::Solved;
use solution::estimation::Estimation;
use solution::solver::{Identifiable, solve_identifiable};

/// Result of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Parameters and residuals of an identification.
///
/// # Examples
///
/// ```
/// use etalon_identify::Settings;
///
/// // a ball measured to 4 µm once, and touched to 3 µm at every pose; all gains held
/// let settings = Settings {
///     standard_uncertainty_mm: Some(0.003),
///     common_uncertainty_mm: Some(0.004),
///     hold: vec!["delta*".to_owned()],
///     ..Settings::default()
/// };
/// assert!((settings.coordinate_uncertainty_mm() - 0.005).abs() < 1e-12);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// Residuals of single targets, or of the pose (eq. 3.26).
    pub kind: ResidualKind,
    /// Standard uncertainty of one measured coordinate (mm); `None` estimates it from the
    /// residuals.
    pub standard_uncertainty_mm: Option<f64>,
    /// Standard uncertainty (mm) common to all observations with the very same coordinates, in
    /// addition to [`Self::standard_uncertainty_mm`], which is then independent for each
    /// observation: a ball measured once and touched in several working modes. Targets only.
    pub common_uncertainty_mm: Option<f64>,
    /// Names of parameters held at their nominal value; `*` stands for any text.
    pub hold: Vec<String>,
    /// Rigid parts that carry targets, with their given shapes. Residuals of targets only.
    pub rigid: Vec<RigidPart>,
    /// Further observations of targets; only for residuals of targets of a robot with a free base.
    pub conditions: Vec<Condition>,
    /// Knowledge of the points to which the conditions refer.
    pub known: Vec<Known>,
    /// Weight of nominal values with tolerances.
    pub prior: Prior,
    /// Effects of the robot itself that are identified.
    pub effects: Effects,
    /// Poses of each series (set-up, day, file); poses of none are a series of their own. Empty for
    /// one series.
    pub series: Vec<Vec<PoseName>>,
}

impl Settings {
    /// Standard uncertainty (mm) of one measured coordinate, including its common part; 0 if none
    /// is given.
    pub fn coordinate_uncertainty_mm(&self) -> f64 {
        self.standard_uncertainty_mm.unwrap_or(0.0).hypot(self.common_uncertainty_mm.unwrap_or(0.0))
    }

    /// The settings of what was found.
    fn as_found(&self, found: &Identification) -> Self {
        Self { prior: found.prior, ..self.with_weight(found.weight) }
    }

    /// Returns these settings without nominal values.
    fn without_prior(&self) -> Self {
        Self { prior: Prior::None, ..self.clone() }
    }

    /// Returns these settings with given shapes and nominal values weighted relative to residuals
    /// of this standard deviation.
    fn with_weight(&self, weight: f64) -> Self {
        let mut settings = self.clone();
        settings.prior = settings.prior.with_weight(weight);
        settings.rigid.iter_mut().for_each(|part| part.weight = weight);
        settings
    }
}

/// Reason for the value of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// Found by least squares.
    Identified,
    /// Held by the settings, or independent of these residuals.
    Fixed,
    /// Held because the data do not determine it, or only together with others.
    NotIdentifiable,
}

/// Result of an identification.
///
/// # Examples
///
/// ```
/// use etalon_identify::{Observation, Settings, identify};
/// use etalon_robots::{Prexyt, Robot};
///
/// // one ball at sixteen poses, to 2 µm in each coordinate; the origin of the base alone is free
/// let robot = Prexyt::default();
/// let observation = |pose: i64| {
///     let joints = vec![10.0 * pose as f64, 150.0, 150.0];
///     let targets = vec![Some(robot.position(&robot.nominal(), &joints, 0)), None];
///     Observation { pose: pose.into(), joints, targets, ..Observation::default() }
/// };
/// let names = robot.parameters().iter().map(|p| p.name.clone());
/// let hold = names.filter(|name| !["x_o", "y_o"].contains(&name.as_str())).collect();
/// let settings = Settings { standard_uncertainty_mm: Some(0.002), hold, ..Settings::default() };
/// let found = identify(&robot, &(1..=16).map(observation).collect::<Vec<_>>(), &settings)?;
///
/// // 2 µm / √16
/// let u_mm = found.standard_uncertainty(robot.index("x_o").expect("the origin of the base"));
/// assert!((u_mm.expect("an identified parameter") - 0.0005).abs() < 1e-12);
/// # Ok::<(), etalon_identify::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Identification {
    /// All parameters of the robot, in its order (mm, rad, 1).
    pub values: Vec<f64>,
    /// Status of each parameter.
    pub status: Vec<Status>,
    /// Indices of the identified parameters: the order of `covariance`.
    pub free: Vec<usize>,
    /// Uncertainty of the identified parameters.
    pub uncertainty: ParameterUncertainty,
    /// Parameters that the data determine, and those that they do not.
    pub identifiability: Identifiability,
    /// Residuals at the solution.
    pub residuals: ResidualStatistics,
    /// Standard deviation of a residual, by which the rows of given shapes and nominal values were
    /// multiplied.
    pub weight: f64,
    /// Weight of nominal values.
    pub prior: Prior,
    /// Steps taken.
    pub iterations: usize,
    /// Termination of the solver.
    pub termination: Termination,
    /// Warnings, with remedies.
    pub warnings: Vec<Warning>,
}

/// Uncertainty of the identified parameters.
#[derive(Clone, Debug)]
pub struct ParameterUncertainty {
    /// Covariance of the identified parameters, row by row (mm, rad, 1); `None` where it cannot be
    /// determined.
    pub covariance: Option<Vec<f64>>,
    /// Source of the covariance.
    pub from: UncertaintyFrom,
    /// Effective degrees of freedom of each identified parameter's standard uncertainty; empty if
    /// these follow from given uncertainties.
    pub effective_degrees: Vec<f64>,
    /// Ratio (median) of the standard uncertainties to the uncertainties from the instrument's
    /// uncertainty alone.
    pub inflation_factor: f64,
    /// Contributions to the covariance.
    pub budget: Budget,
}

/// Parameters that the data determine, and those that they do not.
#[derive(Clone, Debug)]
pub struct Identifiability {
    /// Sets of parameters that are not separately identifiable.
    pub groups: Vec<Group>,
    /// Sets of parameters that are weakly identifiable.
    pub weak: Vec<WeakGroup>,
    /// Singular values of the Jacobian and indices computed from them; `None` if they are not
    /// numbers.
    pub observability: Option<Observability>,
    /// Identified parameters that were eliminated because of their large number: coordinates of
    /// targets, or of sockets and planes.
    pub eliminated: Vec<usize>,
    /// Number of parameters that the data determine: all identified ones if nominal values do not
    /// count as readings.
    pub determined: f64,
}

/// Statistics of the residuals.
#[derive(Clone, Debug)]
pub struct ResidualStatistics {
    /// Root mean square of the residuals, in mm (mm and rad mixed for pose residuals, as in eq.
    /// 3.26).
    pub rms: f64,
    /// Largest residual, likewise.
    pub max: f64,
    /// Number of residuals of measured values.
    pub count: usize,
    /// Number of equations of stated shapes and fixed points, which count like measured values.
    pub stated: usize,
    /// Equations minus identified parameters, without parameters that only nominal values
    /// determine.
    pub degrees_of_freedom: usize,
    /// Effective degrees of freedom of the residual variance, from the scatter of the squared
    /// residuals between poses: a smooth misfit lowers them.
    pub effective_degrees: f64,
    /// Sum of squares of residuals over their uncertainties; `None` if no uncertainty is given or
    /// no degrees of freedom are left.
    pub chi_square: Option<f64>,
    /// Residuals of the coordinates of targets; `None` without coordinates or without a stated
    /// uncertainty, and for residuals of a pose.
    pub coordinates: Option<ConditionResiduals>,
    /// Residuals of each quantity other than positions of targets.
    pub conditions: Vec<ConditionResiduals>,
    /// Scatter of repeats compared with the rest; `None` if no pose was repeated.
    pub replicates: Option<Replicates>,
    /// Scatter between the given series; `None` for one series, and where the instrument explains
    /// all residuals.
    pub between_series: Option<BetweenSeries>,
    /// Growth of the errors of predictions beyond the measured values of joints; empty where the
    /// instrument explains all residuals, and with few poses.
    pub extrapolations: Vec<Extrapolation>,
}

/// Minimum share of a parameter that the data must determine for a value from the data.
const LEAST_SHARE: f64 = 1e-3;

impl Identification {
    /// Indices of the identified parameters of base, targets and fixtures.
    pub fn set_up_parameters(&self, robot: &dyn Robot) -> Vec<usize> {
        self.free.iter().copied().filter(|&i| robot.parameters()[i].role != Role::Robot).collect()
    }

    /// Values of the free parameters, in their order.
    fn free_values(&self) -> Vec<f64> {
        self.free.iter().map(|&i| self.values[i]).collect()
    }

    /// Standard uncertainty of a parameter, by its index; `None` if it was not identified.
    pub fn standard_uncertainty(&self, index: usize) -> Option<f64> {
        let k = self.free.iter().position(|&i| i == index)?;
        Some(self.uncertainty.covariance.as_ref()?[k * self.free.len() + k].sqrt())
    }

    /// Value and standard uncertainty of an identified parameter from everything except its own
    /// nominal value; `None` if there is nothing else.
    pub fn without_nominal(&self, robot: &dyn Robot, index: usize) -> Option<(f64, f64)> {
        let (value, u) = (self.values[index], self.standard_uncertainty(index)?);
        let nominal = robot.parameters()[index].nominal;
        match self.prior.uncertainty(robot, index) {
            None => Some((value, u)),
            // weights add: 1/u² = 1/u_data² + 1/s², with u as the solution weighted the readings;
            // misfit enlarges u afterwards
            Some(s) => {
                let share = 1.0 - (u / self.uncertainty.inflation_factor.max(1.0) / s).powi(2);
                (share > LEAST_SHARE).then(|| (nominal + (value - nominal) / share, u / share.sqrt()))
            }
        }
    }

    /// Share of the value that the data determine, 1 − (u/s)² with u after the identification and s
    /// from its tolerance alone: 0 if the data contribute nothing, 1 if the nominal value has no
    /// influence. `None` if nominal values do not count as readings, or the parameter has none.
    pub fn determined(&self, robot: &dyn Robot, index: usize) -> Option<f64> {
        let (u, s) = (self.standard_uncertainty(index)?, self.prior.uncertainty(robot, index)?);
        Some((1.0 - (u / s).powi(2)).clamp(0.0, 1.0))
    }

    /// Effective degrees of freedom of a parameter; `None` if its uncertainty follows from given
    /// ones.
    pub fn degrees_of_freedom(&self, index: usize) -> Option<f64> {
        self.uncertainty.effective_degrees.get(self.free.iter().position(|&i| i == index)?).copied()
    }
}

/// Identifies the parameters of `robot` from `observations`.
///
/// Redundant parameters are found by the rank of the scaled Jacobian, at the start and again at the
/// solution; of each group the one that is last in the model's list is held at its nominal value,
/// so that base and targets, which come first, take up what is not separately identifiable from
/// them.
///
/// # Examples
///
/// ```
/// use etalon_identify::{Observation, Settings, identify};
/// use etalon_robots::{Prexyt, Robot};
///
/// let robot = Prexyt::default();
/// let rails = robot.index("s").expect("the distance of two rails");
/// let mut truth = robot.nominal();
/// truth[rails] -= 0.07; // mm
///
/// // exact places of both balls in eight corners of the workspace
/// let corner = |pose: i64| {
///     let joints = [1, 2, 4].map(|bit| if pose & bit == 0 { 0.0 } else { 150.0 }); // mm
///     let targets = robot.balls(&truth, &joints).map(|[x, y]| Some([x, y, 0.0])).to_vec();
///     Observation { pose: pose.into(), joints: joints.into(), targets, ..Observation::default() }
/// };
/// let found = identify(&robot, &(0..8).map(corner).collect::<Vec<_>>(), &Settings::default())?;
/// assert!((found.values[rails] - (394.0 - 0.07)).abs() < 1e-9);
/// # Ok::<(), etalon_identify::Error>(())
/// ```
pub fn identify(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Identification> {
    identify_from(robot, observations, settings, &start(robot, observations, settings)?)
}

/// Starting values of all parameters.
fn start(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Vec<f64>> {
    match settings.conditions[..] {
        [] => solution::start::start(robot, observations, settings, &wanted_parameters(robot, observations, settings)?),
        // what conditions refer to is found in closed form one by one: together it comes near
        // enough
        _ => fit_frames(robot, observations, settings),
    }
}

/// Parameters of an identification without their uncertainty.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// All parameters of the robot (mm, rad, 1).
    pub values: Vec<f64>,
    /// Root mean square of the residuals that are lengths (mm).
    pub rms: f64,
}

impl Fitted {
    /// The solution of [`identify`], whose uncertainty takes half of its time.
    ///
    /// # Errors
    /// Fails if settings and observations do not match, or if the solver fails.
    pub fn new(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Self> {
        Self::from_start(robot, observations, settings, &start(robot, observations, settings)?)
    }

    /// The solution of [`identify_from`], without its uncertainty.
    ///
    /// # Errors
    /// Fails like [`Fitted::new`].
    pub fn from_start(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        start: &[f64],
    ) -> Result<Self> {
        let wanted = wanted_parameters(robot, observations, settings)?;
        let found = solve_identifiable(robot, observations, settings, &wanted, start)?;
        Self::evaluated(robot, observations, settings, found)
    }

    fn evaluated(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        found: Identifiable,
    ) -> Result<Self> {
        let settings = Settings { prior: found.prior, ..settings.with_weight(found.weight) };
        let problem = Residuals::new(robot, observations, &settings, &found.free, &found.values)?;
        let rms = judgement::uncertainty::rms_mm(&problem, &found.solution);
        Ok(Self { values: found.values, rms })
    }
}

/// [`identify`] with starting values of all parameters, for instance from [`fit_frames`].
pub fn identify_from(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    start: &[f64],
) -> Result<Identification> {
    identify_with(robot, observations, settings, start, &Systematic::default())
}

/// [`identify_from`] for observations with these common errors.
pub fn identify_with(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    start: &[f64],
    systematic: &Systematic,
) -> Result<Identification> {
    let wanted = wanted_parameters(robot, observations, settings)?;
    let found = solve_identifiable(robot, observations, settings, &wanted, start)?;
    let estimation = Estimation { robot, observations, settings, wanted: &wanted };
    let mut found = judgement::uncertainty::with_uncertainty(estimation, systematic, found)?;
    let without = model::kinds::without_length(robot, observations, settings, &found.status);
    found.warnings.extend(without.map(Into::into));
    Ok(found)
}

/// Identifies all parameters again from other observations of the same poses or some of them, with
/// the same parameters held and starting from the solution; `None` if the solver fails or the
/// observations do not determine the parameters.
pub fn identify_again(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Option<Vec<f64>> {
    let settings = settings.as_found(found);
    let problem = Residuals::new(robot, observations, &settings, &found.free, &found.values).ok()?;
    solved_from(&problem, &found.free_values())
}

/// All parameters of the solution of `problem` near `x`; `None` if the solver fails or the problem
/// does not determine them.
fn solved_from(problem: &Residuals, x: &[f64]) -> Option<Vec<f64>> {
    let regular = |factor: &Factor| svd(factor).rank(RANK_TOLERANCE) == x.len();
    let linearised = Linearised::new(problem, x);
    if regular(&linearised.factor)
        && let Some(x) = solve_near(problem, x, &linearised, true, LAST_STEP)
    {
        return Some(problem.all(&x));
    }
    solved_by_damped_steps(problem, x)
}

/// [`solved_from`] for a problem that steps by the linear part at `x` do not solve.
fn solved_by_damped_steps(problem: &Residuals, x: &[f64]) -> Option<Vec<f64>> {
    let solution = solve(problem, x, Options::default());
    let regular = solution.factor.as_ref().is_some_and(|factor| svd(factor).rank(RANK_TOLERANCE) == x.len());
    (solution.termination.is_success() && regular).then(|| problem.all(&solution.x))
}

/// A fit that starts near its solution, without uncertainties, for comparison with a fit of fewer
/// parameters.
#[derive(Clone, Debug)]
pub struct NestedFit {
    /// All parameters (mm, rad, 1).
    pub values: Vec<f64>,
    /// Sum of squares of the measurements, over the given variances.
    pub squares: f64,
    /// Equations minus parameters that the data determine.
    pub degrees_of_freedom: f64,
    /// Number of parameters that the data determine.
    pub determined: f64,
    free: Vec<usize>,
    prior: Prior,
    weight: f64,
}

/// Residuals of a fit, as [`ResidualStatistics`] states them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitResiduals {
    /// Root mean square (mm) of the measured residuals that are lengths.
    pub rms: f64,
    /// Equations minus parameters that the data determine.
    pub degrees_of_freedom: usize,
    /// Sum of the squares over the given variances; `None` without a given uncertainty.
    pub chi_square: Option<f64>,
}

impl NestedFit {
    /// Fits the parameters that `settings` select, from `start`.
    ///
    /// # Errors
    /// Fails if settings and observations do not match, or if the solver fails.
    pub fn new(robot: &dyn Robot, observations: &[Observation], settings: &Settings, start: &[f64]) -> Result<Self> {
        Ok(Self::judged(robot, observations, settings, start, |_, _| ())?.0)
    }

    /// [`NestedFit::new`], and the residuals that [`identify_from`] states for the same input.
    ///
    /// # Errors
    /// Fails like [`NestedFit::new`].
    pub fn with_residuals(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        start: &[f64],
    ) -> Result<(Self, FitResiduals)> {
        Self::judged(robot, observations, settings, start, |solved, settings| {
            let Solved { problem, solution, .. } = solved;
            FitResiduals {
                rms: judgement::uncertainty::rms_mm(problem, solution),
                degrees_of_freedom: problem.degrees_of_freedom(solution).round() as usize,
                chi_square: judgement::uncertainty::chi_square(solved, settings),
            }
        })
    }

    /// Fits, and judges the solution by the settings with its weights.
    fn judged<T>(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        start: &[f64],
        judge: impl FnOnce(Solved, &Settings) -> T,
    ) -> Result<(Self, T)> {
        let wanted = wanted_parameters(robot, observations, settings)?;
        let found = solve_identifiable(robot, observations, settings, &wanted, start)?;
        let as_found = Settings { prior: found.prior, ..settings.with_weight(found.weight) };
        let problem = &Residuals::new(robot, observations, &as_found, &found.free, &found.values)?;
        let solution = &found.solution;
        let judged = judge(Solved { problem, solution, jacobian: &solution.jacobian }, &as_found);
        let fit = Self {
            squares: problem.squares(solution),
            determined: found.free.len() as f64 - problem.undetermined(solution),
            degrees_of_freedom: problem.degrees_of_freedom(solution),
            values: found.values,
            free: found.free,
            prior: found.prior,
            weight: found.weight,
        };
        Ok((fit, judged))
    }

    /// Number of fitted parameters.
    pub fn count(&self) -> usize {
        self.free.len()
    }

    /// All parameters from part of the observations, with the same parameters held; `None` if the
    /// solver fails or the observations do not determine the parameters.
    pub fn again(&self, robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Option<Vec<f64>> {
        let settings = Settings { prior: self.prior, ..settings.with_weight(self.weight) };
        let problem = Residuals::new(robot, observations, &settings, &self.free, &self.values).ok()?;
        let x: Vec<f64> = self.free.iter().map(|&i| self.values[i]).collect();
        solved_from(&problem, &x)
    }
}

/// [`identify_again`] for many measurements that differ only by their errors.
pub struct Repeated<'a> {
    robot: &'a dyn Robot,
    settings: Settings,
    found: &'a Identification,
    /// Readings that are common to several of these observations.
    common: Option<Common>,
    /// Standard deviations of the rows that are not coordinates of targets.
    stated: Vec<f64>,
    /// Linear part at the solution.
    linearised: Option<Linearised>,
    /// Second-order part there, if all readings are coordinates without covariances of their own.
    quadratic: Option<Quadratic>,
    /// Residuals at the solution.
    residuals: Vec<f64>,
    /// Joint values and measured coordinates of these residuals.
    joints: Vec<f64>,
    coordinates: Vec<f64>,
}

/// Convergence tolerance: step length relative to the first step. The next step, at most a tenth of
/// it, would be less than a ten-thousandth of the change by drawn errors or omitted poses.
const LAST_STEP: f64 = 1e-3;

impl<'a> Repeated<'a> {
    /// Creates the repetition of an identification from these observations.
    pub fn new(
        robot: &'a dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        found: &'a Identification,
    ) -> Self {
        let mut settings = settings.as_found(found);
        let problem = Residuals::new(robot, observations, &settings, &found.free, &found.values).ok();
        let linearised = problem.as_ref().map(|problem| Linearised::new(problem, &found.free_values()));
        let regular = |f: &Factor| svd(f).rank(RANK_TOLERANCE) == found.free.len();
        let stated = problem.as_ref().map_or_else(Vec::new, Residuals::stated);
        let linearised = linearised.filter(|linearised| regular(&linearised.factor));
        let plain = problem.as_ref().filter(|p| p.is_coordinates() && !p.is_weighted()).zip(linearised.as_ref());
        let quadratic = plain.and_then(|(problem, at)| Quadratic::new(problem, &found.free_values(), at));
        let mut residuals = vec![0.0; problem.as_ref().map_or(0, Problem::residual_count)];
        problem.iter().for_each(|problem| problem.residuals(&found.free_values(), &mut residuals));
        let common = problem.and_then(|problem| problem.whitening.common);
        settings.common_uncertainty_mm = None;
        let joints = observations.iter().flat_map(|o| o.joints.iter().copied()).collect();
        let coordinates = coordinates(robot, observations);
        Self { robot, settings, found, common, stated, linearised, quadratic, residuals, joints, coordinates }
    }

    /// Standard deviations of the rows other than coordinates of targets: conditions, shapes and
    /// known points.
    pub fn stated(&self) -> &[f64] {
        &self.stated
    }

    /// All parameters from another measurement of the same targets at the same poses. `drawn` are
    /// the errors of the rows other than coordinates.
    pub fn identify(&self, observations: &[Observation], drawn: Vec<f64>) -> Option<Vec<f64>> {
        let (found, x) = (self.found, self.found.free_values());
        let is_same = observations.iter().flat_map(|o| &o.joints).eq(&self.joints);
        if let (true, Some(linearised), Some(quadratic)) = (is_same, &self.linearised, &self.quadratic)
            && let Some(residuals) = self.remeasured_residuals(observations, &drawn)
            && let Some(step) = quadratic.solve(linearised, &residuals, LAST_STEP)
        {
            let mut values = found.values.clone();
            found.free.iter().zip(step).for_each(|(&i, step)| values[i] += step);
            return Some(values);
        }
        let mut problem = Residuals::new(self.robot, observations, &self.settings, &found.free, &found.values).ok()?;
        problem.whitening.common.clone_from(&self.common);
        problem.drawn = drawn;
        match solve_near(&problem, &x, self.linearised.as_ref()?, is_same, LAST_STEP) {
            Some(x) => Some(problem.all(&x)),
            // the linear part of coordinates hangs on the joint values alone: it was tried
            None if is_same && problem.is_coordinates() => solved_by_damped_steps(&problem, &x),
            None => solved_from(&problem, &x),
        }
    }

    /// Residuals of another measurement at the solution, with the joint values of the first one;
    /// `None` if other targets were measured.
    fn remeasured_residuals(&self, observations: &[Observation], drawn: &[f64]) -> Option<Vec<f64>> {
        let mut moved = coordinates(self.robot, observations);
        if moved.len() != self.coordinates.len() {
            return None;
        }
        let unit_mm = self.settings.standard_uncertainty_mm.unwrap_or(1.0);
        moved.iter_mut().zip(&self.coordinates).for_each(|(new, before)| *new = (*new - before) / unit_mm);
        self.common.iter().for_each(|common| common.whiten(&mut moved, 1));
        moved.extend(drawn);
        moved.resize(self.residuals.len(), 0.0);
        moved.iter_mut().zip(&self.residuals).for_each(|(moved, before)| *moved = before - *moved);
        Some(moved)
    }
}

/// Measured coordinates of all targets, one after the other.
fn coordinates(robot: &dyn Robot, observations: &[Observation]) -> Vec<f64> {
    let dimension = robot.dimension();
    let mut all = Vec::with_capacity(observations.len() * dimension * robot.targets().len());
    let measured = observations.iter().flat_map(|o| o.targets.iter().flatten());
    measured.for_each(|at| all.extend_from_slice(&at[..dimension]));
    all
}

/// Parameters of the nominal robot with only base and targets fitted, wherever they are: the state
/// before calibration, and the start of the identification.
pub fn fit_frames(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Vec<f64>> {
    let frames = wanted_frames(robot, observations, settings)?;
    if frames.is_empty() {
        return Ok(robot.nominal());
    }
    let start = solution::start::start(robot, observations, settings, &frames)?;
    let found = solve_identifiable(robot, observations, settings, &frames, &start)?;
    let (Some(arm), false) = (robot.free_base(), settings.conditions.is_empty()) else { return Ok(found.values) };
    // fixtures once more, from targets that are now near: few distances of a target that is far off
    // lead to a wrong minimum
    let mut again = found.values.clone();
    let of_fixtures: Vec<usize> =
        frames.iter().copied().filter(|&i| robot.parameters()[i].role == Role::Fixture).collect();
    solution::fixtures::place_fixtures(arm, observations, settings, &of_fixtures, &mut again);
    match solve_identifiable(robot, observations, settings, &frames, &again) {
        Ok(again) if again.solution.cost < found.solution.cost => Ok(again.values),
        _ => Ok(found.values),
    }
}

/// These parameters with only base and targets fitted, starting from their values.
pub fn refit_frames(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    values: &[f64],
) -> Result<Vec<f64>> {
    let frames = wanted_frames(robot, observations, settings)?;
    if frames.is_empty() {
        return Ok(values.to_vec());
    }
    Ok(solve_identifiable(robot, observations, settings, &frames, values)?.values)
}

/// Indices of the free parameters of base, targets and fixtures.
pub fn wanted_frames(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Vec<usize>> {
    let wanted = wanted_parameters(robot, observations, settings)?;
    Ok(wanted.into_iter().filter(|&i| robot.parameters()[i].role != Role::Robot).collect())
}

fn wanted_parameters(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Vec<usize>> {
    if observations.is_empty() && settings.conditions.is_empty() {
        return Err(error!("no-observations").into());
    }
    if settings.kind == ResidualKind::Pose && settings.standard_uncertainty_mm.is_none() {
        return Err(Error::PoseWithoutUncertainty);
    }
    let whole = settings.kind == ResidualKind::Targets && settings.standard_uncertainty_mm.is_some();
    if settings.common_uncertainty_mm.is_some() && !whole {
        return Err(Error::CommonUncertaintyAlone);
    }
    model::kinds::check(robot, settings)?;
    let names = || robot.parameters().iter().map(|p| p.name.as_str());
    for pattern in &settings.hold {
        if !names().any(|name| matches_pattern(pattern, name)) {
            let names = names().map(str::to_owned).collect();
            return Err(Error::UnknownParameter { pattern: pattern.clone(), names });
        }
    }
    let held = |name: &str| settings.hold.iter().any(|pattern| matches_pattern(pattern, name));
    let unseen = unseen_by(robot, settings.kind);
    // nothing is measured in a world: the frame of the robot's base is the only one
    let bases = robot.free_base().is_none() || tied_to_world(observations, settings);
    let joints = observations.iter().map(|o| &o.joints).chain(settings.conditions.iter().map(|c| &c.joints));
    let included = settings.effects.include(robot, joints.map(Vec::as_slice));
    let fixed = |i: usize| {
        let p = &robot.parameters()[i];
        held(&p.name) || !included[i] || unseen == Some(i) || !bases && p.role == Role::Base
    };
    Ok((0..robot.parameters().len()).filter(|&i| !fixed(i)).collect())
}

/// Returns the parameter that residuals of this kind do not contain: for a pose, the distance of
/// its two targets.
fn unseen_by(robot: &dyn Robot, kind: ResidualKind) -> Option<usize> {
    (kind == ResidualKind::Pose).then(|| robot.platform().map(|platform| platform.target_distance()))?
}
