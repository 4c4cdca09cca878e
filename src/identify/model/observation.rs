//! Observations: positions of targets, joint values, and the choice between two assembly modes.

use crate::model::weights::Covariance;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// One pose of one cycle: joint values and the targets that were measured.
///
/// # Examples
///
/// ```
/// use etalon_identify::Observation;
/// use etalon_robots::{Prexyt, Robot};
///
/// // ball K alone was measured at pose 3, 0.02 mm in x from its nominal place
/// let (robot, joints) = (Prexyt::default(), vec![100.0, 200.0, 200.0]); // mm
/// let [x, y, z] = robot.position(&robot.nominal(), &joints, 0);
/// let targets = vec![Some([x + 0.02, y, z]), None];
/// let observation = Observation { pose: 3.into(), joints, targets, ..Observation::default() };
///
/// let misses: Vec<_> = observation.misses(&robot, &robot.nominal()).collect();
/// let [(0, [dx_mm, dy_mm, _])] = misses[..] else { panic!("one target was measured") };
/// assert!((dx_mm - 0.02).abs() < 1e-12 && dy_mm == 0.0);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observation {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Joint values in mm or rad, in the robot's order, followed by the assembly mode for robots
    /// with several.
    pub joints: Vec<f64>,
    /// Measured positions in the world in mm, in the order of the robot's targets; `None` if not
    /// measured.
    pub targets: Vec<Option<Vector>>,
    /// Covariances of these positions in the world, if the measurement gives them; otherwise
    /// empty.
    pub covariances_mm2: Vec<Option<Covariance>>,
}

/// Position of a target, measured at known joint values.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Index of the target.
    pub target: usize,
    /// Position in the world (mm); z is 0 for planar robots.
    pub at_mm: Vector,
    /// Covariance of the position, if the measurement gives one.
    pub covariance_mm2: Option<Covariance>,
    /// Joint values (mm or rad) in the robot's order, then the directions of [`Robot::approached`]
    /// joints.
    pub joints: Vec<f64>,
    /// Assembly mode, if given.
    pub assembly: Option<f64>,
    /// Time of the measurement (s).
    pub time_s: Option<f64>,
}

/// Contradiction between a measured position and previous positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contradiction {
    /// A coordinate or a joint value is not finite.
    NotFinite,
    /// Other joint values at the same pose and cycle.
    OtherJoints,
    /// The target is measured twice at the same pose and cycle.
    MeasuredTwice,
}

/// Reason why measured positions do not form observations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObservationError {
    /// Nothing was measured.
    Empty,
    /// A position contradicts previous positions.
    Contradiction(usize, Contradiction),
    /// With nominal parameters the arms do not meet at the joint values of this pose and cycle.
    ArmsApart(PoseName, i64),
    /// Both assembly modes fit a pose and cycle equally well.
    BothModes(PoseName, i64, Distances),
}

/// Distances (mm) of the measured position from the positions of the two assembly modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distances {
    /// Distance from the position of the mode that fits better.
    pub near_mm: f64,
    /// Distance from the position of the other mode.
    pub far_mm: f64,
}

/// Assembly modes derived from the measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AssumedModes {
    /// Number of observations in mode +1.
    pub positive: usize,
    /// Number of observations in mode -1.
    pub negative: usize,
    /// Pose with the least clear choice.
    pub least_clear: (PoseName, Distances),
}

impl Observation {
    /// Groups measured positions by pose and cycle, in their order, and determines assembly modes
    /// that are not given.
    ///
    /// Robots with assembly modes may bring several working modes to one pose and cycle: each set
    /// of joint values is then an observation.
    pub fn group(
        robot: &dyn Robot,
        measured: &[Measured],
    ) -> Result<(Vec<Self>, Option<AssumedModes>), ObservationError> {
        let count = robot.targets().len();
        let weighted = measured.iter().any(|m| m.covariance_mm2.is_some());
        let mut observations: Vec<Self> = Vec::new();
        let mut modes = Vec::new();
        let mut place = BTreeMap::new();
        for (row, m) in measured.iter().enumerate() {
            let contradiction = |what| Err(ObservationError::Contradiction(row, what));
            if m.joints.iter().chain(&m.at_mm).any(|v| !v.is_finite()) {
                return contradiction(Contradiction::NotFinite);
            }
            let mode =
                if robot.has_assembly_modes() { m.joints.iter().map(|q| q.to_bits()).collect() } else { Vec::new() };
            let k = *place.entry((m.pose, m.cycle, mode)).or_insert_with(|| {
                modes.push(m.assembly);
                observations.push(Self {
                    pose: m.pose,
                    cycle: m.cycle,
                    joints: m.joints.clone(),
                    targets: vec![None; count],
                    covariances_mm2: vec![None; if weighted { count } else { 0 }],
                });
                observations.len() - 1
            });
            if observations[k].joints != m.joints {
                return contradiction(Contradiction::OtherJoints);
            }
            if weighted {
                observations[k].covariances_mm2[m.target] = m.covariance_mm2;
            }
            if observations[k].targets[m.target].replace(m.at_mm).is_some() {
                return contradiction(Contradiction::MeasuredTwice);
            }
        }
        if observations.is_empty() {
            return Err(ObservationError::Empty);
        }
        let assumed = match robot.has_assembly_modes() {
            true => assign_modes(robot, &mut observations, &modes)?,
            false => None,
        };
        Ok((observations, assumed))
    }
}

impl Observation {
    /// The measured targets that state an uncertainty, by index: root mean square of the standard
    /// uncertainties of its coordinates, mm.
    pub(crate) fn uncertainties_mm(&self, dimension: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let stated = self.covariances_mm2.iter().zip(&self.targets).enumerate();
        let measured = stated.filter_map(|(k, (covariance, at))| Some((k, (*covariance)?, (*at)?)));
        let mean = move |c: Covariance| ((0..dimension).map(|i| c[i][i]).sum::<f64>() / dimension as f64).sqrt();
        measured.map(move |(k, covariance, _)| (k, mean(covariance)))
    }

    /// For each measured target its index, and its measured position minus that predicted with
    /// `values` (mm).
    pub fn misses<'o>(&'o self, robot: &'o dyn Robot, values: &'o [f64]) -> impl Iterator<Item = (usize, Vector)> + 'o {
        let measured = self.targets.iter().enumerate().filter_map(|(k, target)| Some((k, (*target)?)));
        measured.map(move |(k, target)| (k, minus(target, robot.position(values, &self.joints, k))))
    }
}

/// Directions of approach of a joint at consecutive `values`: the directions of its last motions by
/// more than `still`; `None` before the first motion.
pub fn directions(values: impl Iterator<Item = f64>, still: f64) -> Vec<Option<f64>> {
    let (mut last, mut direction) = (None, None);
    let next = |value: f64| {
        let from = *last.get_or_insert(value);
        if (value - from).abs() > still {
            direction = Some((value - from).signum());
            last = Some(value);
        }
        direction
    };
    values.map(next).collect()
}

/// Minimum ratio of the deviations of the farther and the nearer position at which they can be
/// distinguished.
const CLEAR: f64 = 2.0;

/// Appends the assembly mode to the joint values of every observation: as `stated`, or the mode
/// whose position at nominal parameters is nearer to the measured one.
fn assign_modes(
    robot: &dyn Robot,
    observations: &mut [Observation],
    stated: &[Option<f64>],
) -> Result<Option<AssumedModes>, ObservationError> {
    let nominal = robot.nominal();
    let mut assumed: Option<AssumedModes> = None;
    for (o, stated) in observations.iter_mut().zip(stated) {
        let mode = match stated {
            Some(mode) => *mode,
            None => {
                let (mode, here) = nearer(robot, &nominal, o)?;
                let first = AssumedModes { positive: 0, negative: 0, least_clear: (o.pose, here) };
                let all = assumed.get_or_insert(first);
                *if mode < 0.0 { &mut all.negative } else { &mut all.positive } += 1;
                if here.near_mm / here.far_mm > all.least_clear.1.near_mm / all.least_clear.1.far_mm {
                    all.least_clear = (o.pose, here);
                }
                mode
            }
        };
        o.joints.push(mode);
    }
    Ok(assumed)
}

/// Observations that are far from their measured positions in the given assembly mode and near in
/// the other, with the parameters `values`; the distances in both (mm). Empty if this holds for
/// most observations: the base is then elsewhere.
pub(crate) fn misplaced<'o>(
    robot: &dyn Robot,
    observations: &'o [Observation],
    values: &[f64],
) -> Vec<(&'o Observation, (f64, f64))> {
    if !robot.has_assembly_modes() {
        return Vec::new();
    }
    let both = |o: &'o Observation| {
        let mode = *o.joints.last()?;
        let (stated, other) = (off(robot, values, o, mode), off(robot, values, o, -mode));
        (CLEAR * other < stated).then_some((o, (stated, other)))
    };
    let wrong: Vec<_> = observations.iter().filter_map(both).collect();
    if 2 * wrong.len() < observations.len() { wrong } else { Vec::new() }
}

/// Distance (mm) of the farthest target from its position by `values` in an assembly mode.
fn off(robot: &dyn Robot, values: &[f64], o: &Observation, mode: f64) -> f64 {
    let mut joints = o.joints[..robot.joints().len()].to_vec();
    joints.push(mode);
    let miss =
        |(k, measured): (usize, &Option<Vector>)| Some(norm(minus((*measured)?, robot.position(values, &joints, k))));
    let larger = |worst: f64, d: f64| if d > worst || d.is_nan() { d } else { worst };
    o.targets.iter().enumerate().filter_map(miss).fold(0.0, larger)
}

/// The mode that fits better, and the distances of the position from both.
fn nearer(robot: &dyn Robot, nominal: &[f64], o: &Observation) -> Result<(f64, Distances), ObservationError> {
    let (plus, minus) = (off(robot, nominal, o, 1.0), off(robot, nominal, o, -1.0));
    let (mode, near_mm, far_mm) = if minus < plus { (-1.0, minus, plus) } else { (1.0, plus, minus) };
    let distances = Distances { near_mm, far_mm };
    if !near_mm.is_finite() || !far_mm.is_finite() {
        return Err(ObservationError::ArmsApart(o.pose, o.cycle));
    }
    match CLEAR * near_mm >= far_mm {
        true => Err(ObservationError::BothModes(o.pose, o.cycle, distances)),
        false => Ok((mode, distances)),
    }
}
