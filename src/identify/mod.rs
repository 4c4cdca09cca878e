//! Identification: parameters from observations, with what the data can and cannot tell, and how well.

mod identifiability;
mod logs;
mod observation;
mod residuals;
mod start;
mod uncertainty;

pub use identifiability::{Group, RANK_TOLERANCE};
pub use logs::{LogComparison, compare_logs};
pub use observation::Observation;
pub use residuals::ResidualKind;
pub use uncertainty::{Observability, WeakGroup};

use crate::message::{Message, Result};
use crate::robots::{Robot, Role};
use crate::solve::{self, Options, Solution, Termination};
use identifiability::Analysis;
use residuals::Residuals;

/// What is identified from which residuals.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Residuals of single targets, or of the pose (eq. 3.26).
    pub kind: ResidualKind,
    /// Standard uncertainty of one measured coordinate in mm; `None` takes it from the residuals.
    pub standard_uncertainty_mm: Option<f64>,
    /// Names of parameters held at their nominal value; `*` stands for any text.
    pub hold: Vec<String>,
}

/// Why a parameter has the value that it has.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// Found by least squares.
    Identified,
    /// Held by the settings, or not part of these residuals.
    Fixed,
    /// Held because the data cannot tell it apart from others, or do not see it at all.
    NotIdentifiable,
}

/// What an identification found.
#[derive(Clone, Debug)]
pub struct Identification {
    /// All parameters of the robot, in its order (mm, rad, 1).
    pub values: Vec<f64>,
    /// Status of each parameter.
    pub status: Vec<Status>,
    /// Indices of the identified parameters: the order of `covariance`.
    pub free: Vec<usize>,
    /// Covariance of the identified parameters, row by row (mm, rad, 1).
    pub covariance: Vec<f64>,
    /// Factor by which residuals exceed the instrument's uncertainty; the covariance is scaled by its square.
    pub model_factor: f64,
    /// Sets of parameters that the data cannot tell apart.
    pub groups: Vec<Group>,
    /// Sets of parameters that the data hardly tell apart.
    pub weak: Vec<WeakGroup>,
    /// Singular values of the scaled Jacobian and what follows from them.
    pub observability: Observability,
    /// Root mean square of the residuals, in mm (mm and rad mixed for pose residuals, as in eq. 3.26).
    pub rms: f64,
    /// Largest residual, likewise.
    pub max: f64,
    /// Equations minus identified parameters.
    pub degrees_of_freedom: usize,
    /// Sum of squares of residuals over their uncertainties; `None` where no uncertainty is stated.
    pub chi_square: Option<f64>,
    /// Steps taken.
    pub iterations: usize,
    /// How the solver ended.
    pub termination: Termination,
    /// What the user should know, with remedies.
    pub warnings: Vec<Message>,
}

impl Identification {
    /// Standard uncertainty of a parameter, by its index; `None` if it was not identified.
    pub fn standard_uncertainty(&self, index: usize) -> Option<f64> {
        let k = self.free.iter().position(|&i| i == index)?;
        Some(self.covariance[k * self.free.len() + k].sqrt())
    }
}

/// Identifies the parameters of `robot` from `observations`.
///
/// Redundant parameters are found by the rank of the scaled Jacobian, at the start and again at the solution; of each
/// group the one that stands last in the model's list is held at its nominal value, so that base and targets, which
/// come first, take up what cannot be told apart from them.
pub fn identify(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Identification> {
    let wanted = wanted_parameters(robot, observations, settings)?;
    let start = start::start(robot, observations, &wanted)?;
    identify_from(robot, observations, settings, &wanted, start)
}

/// Parameters of the nominal robot with only base and targets fitted: what accuracy is before a calibration.
pub fn fit_frames(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Vec<f64>> {
    let wanted = wanted_parameters(robot, observations, settings)?;
    let frames: Vec<usize> = wanted.into_iter().filter(|&i| robot.parameters()[i].role != Role::Robot).collect();
    if frames.is_empty() {
        return Ok(robot.nominal());
    }
    let start = start::start(robot, observations, &frames)?;
    Ok(identify_from(robot, observations, settings, &frames, start)?.values)
}

fn wanted_parameters(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Vec<usize>> {
    if observations.is_empty() {
        return Err(Message::error("there are no observations to identify from").into());
    }
    if settings.kind == ResidualKind::Pose && settings.standard_uncertainty_mm.is_none() {
        return Err(Message::error(
            "pose residuals mix mm and rad: they need the standard uncertainty of a coordinate",
        )
        .hint("state it (--standard-uncertainty-um), or compare targets")
        .into());
    }
    let names = || robot.parameters().iter().map(|p| p.name.as_str());
    for pattern in &settings.hold {
        if !names().any(|name| matches_pattern(pattern, name)) {
            let what = format!("`hold` names `{pattern}`, which is no parameter of this robot");
            return Err(Message::error(what).hint_names(pattern, names()).into());
        }
    }
    let held = |name: &str| settings.hold.iter().any(|pattern| matches_pattern(pattern, name));
    let unseen = |name: &str| settings.kind == ResidualKind::Pose && name == "l_kl";
    Ok((0..robot.parameters().len())
        .filter(|&i| !held(&robot.parameters()[i].name) && !unseen(&robot.parameters()[i].name))
        .collect())
}

/// Whether `name` is `pattern`, in which one `*` stands for any text.
pub fn matches_pattern(pattern: &str, name: &str) -> bool {
    match pattern.split_once('*') {
        Some((head, tail)) => name.len() >= head.len() + tail.len() && name.starts_with(head) && name.ends_with(tail),
        None => pattern == name,
    }
}

fn identify_from(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    start: Vec<f64>,
) -> Result<Identification> {
    // a subset of many poses brings the parameters near, all poses then take few steps
    let (mut values, mut held) = (start, None);
    if observations.len() > 2 * SUBSET {
        let step = observations.len().div_ceil(SUBSET);
        let subset: Vec<Observation> = observations.iter().step_by(step).cloned().collect();
        if let Ok(near) = settle(robot, &subset, settings, wanted, values.clone(), None) {
            (values, held) = (near.values, Some(near.groups.iter().map(|g| g.held).collect()));
        }
    }
    let settled = settle(robot, observations, settings, wanted, values, held)?;
    let problem = Residuals::new(robot, observations, settings, &settled.free, &settled.values)?;
    Ok(uncertainty::conclude(robot, settings, &problem, wanted, settled))
}

/// Observations that suffice to come near, if they are spread over all.
const SUBSET: usize = 96;

/// A solution at which the same parameters are held as those it was found with.
struct Settled {
    values: Vec<f64>,
    free: Vec<usize>,
    groups: Vec<Group>,
    solution: Solution,
    iterations: usize,
}

/// Solves with redundant parameters held, until the same are redundant at the solution; `held` is a first guess of them.
fn settle(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    start: Vec<f64>,
    held: Option<Vec<usize>>,
) -> Result<Settled> {
    let mut values = start;
    let mut iterations = 0;
    let all = Residuals::new(robot, observations, settings, wanted, &values)?;
    let mut held = held.unwrap_or_else(|| Analysis::at(&all, &values).held());
    for _round in 0..5 {
        let free: Vec<usize> = wanted.iter().copied().filter(|i| !held.contains(i)).collect();
        for &i in &held {
            values[i] = robot.parameters()[i].nominal;
        }
        let problem = Residuals::new(robot, observations, settings, &free, &values)?;
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let solution = solve::solve(&problem, &x, Options::default());
        iterations += solution.iterations;
        values = problem.all(&solution.x);
        if !solution.termination.is_success() {
            return Err(Message::error(format!("the identification ended without a result: {}", solution.termination))
                .hint("`etalon check` lists what each pose and target brings; `hold` in [identify] holds parameters")
                .into());
        }
        let analysis = Analysis::at(&all, &values);
        if analysis.held() == held {
            return Ok(Settled { values, free, groups: analysis.groups, solution, iterations });
        }
        held = analysis.held();
    }
    Err(Message::error("which parameters can be told apart changes from step to step")
        .hint("hold parameters in [identify], or measure more poses")
        .into())
}

#[cfg(test)]
mod tests {
    use super::matches_pattern;

    #[test]
    fn patterns() {
        assert!(matches_pattern("gain_*", "gain_3") && matches_pattern("d", "d") && matches_pattern("*_x", "SMR_1_x"));
        assert!(
            !matches_pattern("gain_*", "again_3") && !matches_pattern("d", "d3") && !matches_pattern("ab*ba", "aba")
        );
    }
}
