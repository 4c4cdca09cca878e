//! Candidates drawn within limits of the joints, a box, and the line of sight to an instrument.
//!
//! Draws are points of an additive recurrence with the generalised golden ratio (Roberts 2018, "The
//! unreasonable effectiveness of quasirandom sequences"), shifted by a seed: they fill the ranges
//! more evenly than random numbers.

use super::obstacles::Obstacle;
use crate::Observation;
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector, dot, minus, norm};
use etalon_robots::{Joint, JointChain, Quantity, Robot, base_pose};

/// Maximum number of draws for each wanted candidate.
pub const DRAWS_PER_CANDIDATE: usize = 200;
/// Minimum number of draws before the search ends without enough candidates.
pub const FEWEST_DRAWS: usize = 20_000;
/// Travel (mm) of a prismatic joint with backlash from its approach point to a pose.
pub const APPROACH_MM: f64 = 2.0;
/// Travel (rad) of a revolute joint with backlash from its approach point to a pose: two degrees.
pub const APPROACH_RAD: f64 = 0.034_906_585_039_886_59;

/// Travel (mm or rad) of a joint with backlash from its approach point to a pose.
pub fn approach(joint: &Joint) -> f64 {
    if joint.quantity == Quantity::Angle { APPROACH_RAD } else { APPROACH_MM }
}

/// A reflector that an instrument sees only from its front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflector {
    /// Index of the target.
    pub target: usize,
    /// Outward axis of the reflector in the frame of the flange, of any length.
    pub axis: Vector,
    /// Largest angle (rad) between the axis and the direction to the instrument.
    pub acceptance_rad: f64,
}

/// Position of an instrument, the reflectors that face it, and the bodies in its way.
#[derive(Clone, Debug, PartialEq)]
pub struct Sight {
    /// Position in the base of the robot.
    pub instrument_mm: Vector,
    /// Reflectors with an axis.
    pub reflectors: Vec<Reflector>,
    /// Bodies that block the view of any target.
    pub obstacles: Vec<Obstacle>,
}

/// Constraints of candidates.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// Smallest and largest value of each joint (mm or rad); infinite for joints that follow from
    /// the position.
    pub ranges: Vec<[f64; 2]>,
    /// Smallest and largest x, y and z of every target in the base of the robot.
    pub region_mm: Option<[[f64; 2]; 3]>,
    /// Instrument that sees the reflectors.
    pub sight: Option<Sight>,
}

/// Numbers of draws that are no candidates, by the first constraint that they violate.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Losses {
    /// Beyond limits of joints or links, or without a pose.
    pub limits: usize,
    /// A target is outside the region.
    pub region: usize,
    /// A reflector faces away from the instrument.
    pub sight: usize,
    /// Part of `sight`: with opposite axes all reflectors face the instrument.
    pub reversed: usize,
    /// A target is hidden, by the first obstacle that hides it.
    pub hidden: Vec<usize>,
}

/// Candidates that obey all constraints.
#[derive(Clone, Debug)]
pub struct Generated {
    /// Configurations; poses have numbers from 1.
    pub observations: Vec<Observation>,
    /// Number of poses.
    pub poses: usize,
    /// Number of draws.
    pub draws: usize,
    /// Draws that are no candidates.
    pub losses: Losses,
    /// Smallest and largest x, y and z (mm) of the targets in the base, over all draws within the
    /// limits; infinite without such a draw.
    pub reached_mm: [[f64; 2]; 3],
}

/// Draws up to `count` poses that obey the constraints. A robot with assembly modes is drawn by the
/// position of its target, in all configurations that reach it; other robots by joint values, with
/// a random direction of approach of joints with backlash.
///
/// # Examples
///
/// ```
/// use etalon_identify::plan::generate::{Domain, generate};
/// use etalon_robots::Prexyt;
///
/// // 20 poses of the table with carriage 1 between 50 and 60 mm
/// let ranges = vec![[50.0, 60.0], [100.0, 200.0], [100.0, 200.0]];
/// let domain = Domain { ranges, region_mm: None, sight: None };
/// let found = generate(&Prexyt::default(), &domain, 20, 1);
/// assert_eq!((found.poses, found.draws), (20, 20));
/// assert!(found.observations.iter().all(|o| (50.0..=60.0).contains(&o.joints[0])));
/// ```
pub fn generate(robot: &dyn Robot, domain: &Domain, count: usize, seed: u64) -> Generated {
    let judge = Judge::new(robot, domain);
    let ranges = if robot.has_assembly_modes() { judge.plane() } else { domain.ranges.clone() };
    let mut draws = Draws::new(&ranges, seed);
    let most = count.saturating_mul(DRAWS_PER_CANDIDATE).max(FEWEST_DRAWS);
    let obstacles = domain.sight.as_ref().map_or(0, |sight| sight.obstacles.len());
    let losses = Losses { hidden: vec![0; obstacles], ..Losses::default() };
    let (observations, reached_mm) = (Vec::new(), [[f64::INFINITY, f64::NEG_INFINITY]; 3]);
    let mut found = Generated { observations, poses: 0, draws: 0, losses, reached_mm };
    while found.poses < count && found.draws < most {
        found.draws += 1;
        let drawn = draws.draw();
        let configurations = match robot.has_assembly_modes() {
            true => judge.solutions(&drawn),
            false => vec![draws.with_directions(drawn, robot.approached().len())],
        };
        match judge.accepted(configurations, &mut found.reached_mm) {
            Ok(accepted) => {
                found.poses += 1;
                let pose = (found.poses as i64).into();
                let numbered = accepted.into_iter().zip(1..).map(|(joints, cycle)| Observation {
                    pose,
                    cycle,
                    joints,
                    targets: vec![Some([0.0; 3]); robot.targets().len()],
                    ..Observation::default()
                });
                found.observations.extend(numbered);
            }
            Err(Loss::Limits) => found.losses.limits += 1,
            Err(Loss::Region) => found.losses.region += 1,
            Err(Loss::Hidden { obstacle }) => found.losses.hidden[obstacle] += 1,
            Err(Loss::Sight { reversed }) => {
                found.losses.sight += 1;
                found.losses.reversed += usize::from(reversed);
            }
        }
    }
    found
}

/// The base of the robot in the world by its nominal parameters.
pub fn base_in_world(robot: &dyn Robot) -> Pose {
    let nominal = robot.nominal();
    if robot.free_base().is_some() {
        return base_pose(&nominal);
    }
    robot.kinematics().and_then(|k| k.base_in_world(&nominal)).unwrap_or_else(Pose::identity)
}

/// Constraint that a draw violates first.
enum Loss {
    Limits,
    Region,
    /// `reversed` if opposite axes face the instrument.
    Sight {
        reversed: bool,
    },
    /// Index of the first obstacle that hides a target.
    Hidden {
        obstacle: usize,
    },
}

/// Judges draws by the nominal robot.
struct Judge<'a> {
    robot: &'a dyn Robot,
    domain: &'a Domain,
    nominal: Vec<f64>,
    gains: Vec<f64>,
    world_t_base: Pose,
    base_t_world: Pose,
    /// Joints of the robot, if an obstacle moves with one.
    chain: Option<JointChain>,
}

impl<'a> Judge<'a> {
    fn new(robot: &'a dyn Robot, domain: &'a Domain) -> Self {
        let world_t_base = base_in_world(robot);
        let nominal = robot.nominal();
        let moves = domain.sight.as_ref().is_some_and(|s| s.obstacles.iter().any(|o| o.joint.is_some()));
        Self {
            robot,
            domain,
            chain: moves.then(|| robot.joint_chain(&nominal)).flatten(),
            nominal,
            gains: (0..robot.joints().len()).map(|k| robot.nominal_gain(k)).collect(),
            base_t_world: world_t_base.inverse(),
            world_t_base,
        }
    }

    /// Ranges of x and y in the base.
    fn plane(&self) -> Vec<[f64; 2]> {
        self.domain.region_mm.map_or_else(Vec::new, |[x, y, _]| vec![x, y])
    }

    /// Joint values, with the assembly mode, of all configurations at a position in the base.
    fn solutions(&self, position: &[f64]) -> Vec<Vec<f64>> {
        let at = self.world_t_base.apply([position[0], position[1], 0.0]);
        self.robot.inverse_all(&self.nominal, at).unwrap_or_default()
    }

    /// The configurations that obey all constraints, or the reason why none does.
    fn accepted(&self, configurations: Vec<Vec<f64>>, reached: &mut [[f64; 2]; 3]) -> Result<Vec<Vec<f64>>, Loss> {
        let mut loss = Loss::Limits;
        let mut accepted = Vec::with_capacity(configurations.len());
        for joints in configurations {
            match self.judged(&joints, reached) {
                None => accepted.push(joints),
                Some(reason) => loss = reason,
            }
        }
        if accepted.is_empty() { Err(loss) } else { Ok(accepted) }
    }

    /// Constraint that a configuration violates, if any; widens `reached` by the targets.
    fn judged(&self, joints: &[f64], reached: &mut [[f64; 2]; 3]) -> Option<Loss> {
        if !self.is_within_limits(joints) {
            return Some(Loss::Limits);
        }
        let (dimension, targets) = (self.robot.dimension(), self.robot.targets().len());
        let mut all = vec![0.0; dimension * targets];
        self.robot.positions(&self.nominal, joints, &mut all);
        if all.iter().any(|x| !x.is_finite()) {
            return Some(Loss::Limits);
        }
        let in_base = |p: &[f64]| {
            let at = std::array::from_fn(|i| p.get(i).copied().unwrap_or(0.0));
            self.base_t_world.apply(at)
        };
        let places: Vec<Vector> = all.chunks_exact(dimension).map(in_base).collect();
        for place in &places {
            let widen = |(ends, value): (&mut [f64; 2], &f64)| *ends = [ends[0].min(*value), ends[1].max(*value)];
            reached.iter_mut().zip(place).for_each(widen);
        }
        let is_inside = |p: &Vector, region: &[[f64; 2]; 3]| {
            p.iter().zip(region).take(dimension).all(|(v, [lower, upper])| (*lower..=*upper).contains(v))
        };
        if self.domain.region_mm.as_ref().is_some_and(|region| !places.iter().all(|p| is_inside(p, region))) {
            return Some(Loss::Region);
        }
        let seen = |sign| self.is_seen(joints, &places, sign);
        if !seen(1.0) {
            return Some(Loss::Sight { reversed: seen(-1.0) });
        }
        self.hiding(joints, &places).map(|obstacle| Loss::Hidden { obstacle })
    }

    /// Returns the index of the first obstacle between the instrument and any of the targets at
    /// these positions in the base.
    fn hiding(&self, joints: &[f64], places: &[Vector]) -> Option<usize> {
        let sight = self.domain.sight.as_ref()?;
        let frames = self.chain.as_ref().map_or_else(Vec::new, |chain| chain.frames(joints));
        sight.obstacles.iter().position(|obstacle| {
            let back = obstacle.joint.and_then(|k| frames.get(k)).map_or_else(Pose::identity, Pose::inverse);
            let from = back.apply(sight.instrument_mm);
            places.iter().any(|place| obstacle.shape.blocks(from, back.apply(*place)))
        })
    }

    fn is_within_limits(&self, joints: &[f64]) -> bool {
        let approached = self.robot.approached();
        let directions = joints.get(self.robot.joints().len()..).unwrap_or_default();
        // limits refer to the joint, logged values perhaps to its motor
        let mut moved = joints.to_vec();
        moved.iter_mut().zip(&self.gains).for_each(|(q, gain)| *q *= gain);
        let within =
            |k: usize, q: f64| self.domain.ranges.get(k).is_none_or(|[lower, upper]| (*lower..=*upper).contains(&q));
        let reaches_approach = |(&k, direction): (&usize, &f64)| {
            within(k, joints[k] - direction * approach(&self.robot.joints()[k]) / self.gains[k])
        };
        (0..self.robot.joints().len()).all(|k| within(k, joints[k]))
            && (self.robot.has_assembly_modes() || approached.iter().zip(directions).all(reaches_approach))
            && self.robot.limit_violation(&self.nominal, &moved).is_none()
    }

    /// `true` if all reflectors at these positions in the base face the instrument with their axes
    /// times `sign`.
    fn is_seen(&self, joints: &[f64], places: &[Vector], sign: f64) -> bool {
        let (Some(sight), Some(arm)) = (&self.domain.sight, self.robot.free_base()) else { return true };
        sight.reflectors.iter().all(|reflector| {
            let flange = arm.flange(&self.nominal, joints, reflector.target);
            let base_t_flange = self.base_t_world.then(&flange);
            let axis = base_t_flange.rotate(reflector.axis);
            let to_instrument = minus(sight.instrument_mm, places[reflector.target]);
            let lengths = norm(axis) * norm(to_instrument);
            lengths > 0.0 && sign * dot(axis, to_instrument) >= lengths * reflector.acceptance_rad.cos()
        })
    }
}

/// Sequence of draws within ranges.
struct Draws {
    ranges: Vec<[f64; 2]>,
    steps: Vec<f64>,
    at: Vec<f64>,
    noise: Noise,
}

impl Draws {
    fn new(ranges: &[[f64; 2]], seed: u64) -> Self {
        let mut noise = Noise::new(seed, 0);
        // the only positive root of x^(d + 1) = x + 1
        let exponent = 1.0 / (ranges.len() + 1) as f64;
        let ratio = (0..64).fold(2.0f64, |x, _| (1.0 + x).powf(exponent));
        let steps = (1..=ranges.len()).map(|j| ratio.powi(-(j as i32)).fract()).collect();
        let at = ranges.iter().map(|_| noise.uniform(0.5) + 0.5).collect();
        Self { ranges: ranges.to_vec(), steps, at, noise }
    }

    fn draw(&mut self) -> Vec<f64> {
        self.at.iter_mut().zip(&self.steps).for_each(|(at, step)| *at = (*at + step).fract());
        self.ranges.iter().zip(&self.at).map(|([lower, upper], at)| lower + at * (upper - lower)).collect()
    }

    /// Joint values followed by random directions of approach.
    fn with_directions(&mut self, mut joints: Vec<f64>, count: usize) -> Vec<f64> {
        let noise = &mut self.noise;
        joints.extend((0..count).map(|_| if noise.uniform(1.0) < 0.0 { -1.0 } else { 1.0 }));
        joints
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_robots::Prexyt;

    #[test]
    fn draws_fill_the_ranges_evenly() {
        // each of 32 equal parts of both axes has 1000 / 32 of 1000 draws, within one third
        let mut draws = Draws::new(&[[0.0, 32.0], [-16.0, 16.0]], 7);
        let mut counts = [[0usize; 32]; 2];
        for _ in 0..1000 {
            let q = draws.draw();
            counts[0][q[0] as usize] += 1;
            counts[1][(q[1] + 16.0) as usize] += 1;
        }
        assert!(counts.iter().flatten().all(|n| (21..=42).contains(n)), "{counts:?}");
    }

    #[test]
    fn the_same_seed_draws_the_same_candidates_and_impossible_constraints_end() {
        let ranges = vec![[0.0, 170.0], [100.0, 200.0], [100.0, 200.0]];
        let domain = Domain { ranges, region_mm: None, sight: None };
        let joints = |seed| {
            let found = generate(&Prexyt::default(), &domain, 30, seed).observations;
            found.into_iter().map(|o| o.joints).collect::<Vec<_>>()
        };
        assert_eq!(joints(3), joints(3));
        assert_ne!(joints(3), joints(4));
        let nowhere = Domain { region_mm: Some([[9e3, 9e4]; 3]), ..domain };
        let found = generate(&Prexyt::default(), &nowhere, 30, 1);
        assert_eq!((found.poses, found.draws, found.losses.region), (0, FEWEST_DRAWS, FEWEST_DRAWS));
    }
}
