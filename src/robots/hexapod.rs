//! Hexapod (Gough & Whitehall 1962, Stewart 1965): a platform on six legs of variable length.
//!
//! The model has 42 parameters (Masory, Wang & Zhuang 1993): for each leg, the centres of its
//! joints on base and platform, and its length at joint value zero. The frames of base and platform
//! are arbitrary, so that twelve parameters cannot be separated from base and targets.

use super::keys::{Description, Reader};
use super::parallel::{LegParameter, LegValues, Legs, Parallel, Rod, gaps, lengthening};
use super::{At, FaultKind, Faults, Key, Model, Quantity, Robot, meaning, wrong_targets};
use etalon_base::pose::{Pose, Vector, norm};
use etalon_base::scalar::Scalar;
use etalon_base::sketch::{Sketch, StrokeKind};

/// Platform on six legs.
pub(super) const MODEL: Model = Model::new::<Keys>("hexapod");

const LEGS: usize = 6;
const ON_BASE: &str = meaning("meaning-leg-joint-on-base");
const ON_PLATFORM: &str = meaning("meaning-leg-joint-on-platform");

/// Description of a hexapod.
struct Keys {
    legs: Vec<LegKeys>,
    home_xyz_mm: Vector,
    home_rpy_rad: Vector,
}

/// Description of one leg of a hexapod.
struct LegKeys {
    base_mm: Vector,
    platform_mm: Vector,
    length_mm: f64,
    limits_mm: Option<[f64; 2]>,
}

impl LegKeys {
    fn read(keys: &mut Reader) -> Self {
        Self {
            base_mm: keys.required(Key::length("base", "Centre of the leg's joint on the base, in the base frame.")),
            platform_mm: keys.required(Key::length(
                "platform",
                "Centre of the leg's joint on the platform, in the frame of the platform.",
            )),
            length_mm: keys.or(
                Key::length("length", "Length of the leg, between these centres, at joint value zero.").essential(),
                0.0,
            ),
            limits_mm: keys.optional(Key::length("limits", "Smallest and largest joint value of the leg.")),
        }
    }
}

impl Description for Keys {
    fn read(keys: &mut Reader) -> Self {
        Self {
            legs: keys.tables(Key::plain("leg", "The six legs of a hexapod."), "A leg of a hexapod.", LegKeys::read),
            home_xyz_mm: keys.required(Key::length(
                "home_xyz",
                "Position of a hexapod's platform in the base at a home pose inside its workspace. Six lengths permit up to 40 poses. The platform is in the pose that it reaches from the home pose without a singularity (its assembly mode).",
            )),
            home_rpy_rad: keys.or(
                Key::angle("home_rpy", "Orientation of the platform at the home pose: rx, ry, rz of Rz Ry Rx.").essential(),
                [0.0; 3],
            ),
        }
    }

    fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        let mut faults = wrong_targets(targets);
        if self.legs.len() != LEGS {
            faults.add(At::Key("leg"), FaultKind::LegCount(self.legs.len()));
            return Err(faults);
        }
        let legs = Hexapod { home: Pose::from_xyz_rpy(self.home_xyz_mm, self.home_rpy_rad) };
        let nominal: Vec<f64> =
            self.legs.iter().flat_map(|l| [&l.base_mm[..], &l.platform_mm, &[l.length_mm]].concat()).collect();
        let rods = LegValues { legs: &legs, parameters: &nominal }.rods(&[0.0; LEGS]);
        if lengthening(&rods, &legs.home).try_inverse().is_none_or(|m| m.amax() > SINGULAR) {
            faults.add(At::Key("home_xyz"), FaultKind::SingularHome);
        }
        let limits = self.legs.iter().map(|leg| leg.limits_mm).collect();
        faults.or(Box::new(Parallel::new(legs, &nominal, limits, targets)) as _)
    }
}

/// Platform motion per leg motion (mm/mm or rad/mm) beyond which a configuration is singular.
const SINGULAR: f64 = 1e6;
/// Minimum part of the way from home to the joint values, and Newton steps in each part.
const SHORTEST: f64 = 1e-3;
const STEPS: usize = 12;
/// Maximum ratio of successive Newton steps; ensures that the iteration stays on its branch.
const CONTRACTION: f64 = 0.5;
/// Maximum rotation of a first step (rad).
const TURN: f64 = 0.5;
/// Convergence tolerance: largest motion of a platform joint in a step (mm).
const FOUND_MM: f64 = 1e-10;

/// Legs of a hexapod, and the pose that selects its assembly mode.
#[derive(Clone, Debug)]
struct Hexapod {
    home: Pose,
}

impl Legs for Hexapod {
    const MODEL: &'static str = "hexapod";
    const PARAMETERS: &'static [LegParameter] = &[
        LegParameter { name: "leg#_bx", quantity: Quantity::Length, meaning: ON_BASE },
        LegParameter { name: "leg#_by", quantity: Quantity::Length, meaning: ON_BASE },
        LegParameter { name: "leg#_bz", quantity: Quantity::Length, meaning: ON_BASE },
        LegParameter { name: "leg#_ax", quantity: Quantity::Length, meaning: ON_PLATFORM },
        LegParameter { name: "leg#_ay", quantity: Quantity::Length, meaning: ON_PLATFORM },
        LegParameter { name: "leg#_az", quantity: Quantity::Length, meaning: ON_PLATFORM },
        LegParameter { name: "leg#_l0", quantity: Quantity::Length, meaning: meaning("meaning-leg-length") },
    ];
    const JOINT: LegParameter = LegParameter { name: "leg#", quantity: Quantity::Length, meaning: "" };
    const COUNT: usize = LEGS;

    fn rod<T: Scalar>(&self, _leg: usize, p: &[T], q: T) -> Rod<T> {
        Rod { base_mm: [p[0], p[1], p[2]], platform_mm: [p[3], p[4], p[5]], length_mm: p[6] + q }
    }

    fn sketch(&self, p: &[f64], q: f64, platform: &Pose, sketch: &mut Sketch) {
        let rod = self.rod(0, p, q);
        let end = platform.apply(rod.platform_mm);
        sketch.add(StrokeKind::Length, "leg1_l0 + leg1", &[rod.base_mm, end]);
        let to_base = [[0.0; 3], [p[0], 0.0, 0.0], [p[0], p[1], 0.0], rod.base_mm];
        for (axis, ends) in ["x", "y", "z"].into_iter().zip(to_base.windows(2)) {
            sketch.add(StrokeKind::Direction, format!("leg1_b{axis}"), ends);
        }
        let to_platform = [[0.0; 3], [p[3], 0.0, 0.0], [p[3], p[4], 0.0], rod.platform_mm].map(|at| platform.apply(at));
        for (axis, ends) in ["x", "y", "z"].into_iter().zip(to_platform.windows(2)) {
            sketch.add(StrokeKind::Direction, format!("leg1_a{axis}"), ends);
        }
    }

    /// Newton's method from home, in parts of the way if it does not converge at once.
    fn place(&self, legs: &LegValues<'_, Self>, joints: &[f64]) -> Option<Pose> {
        let mut rods = legs.rods(joints);
        let (lengths, from_home) = (rods.iter().map(|rod| rod.length_mm).collect::<Vec<_>>(), gaps(&rods, &self.home));
        let (mut pose, mut done, mut part) = (self.home, 0.0, 1.0f64);
        while done < 1.0 {
            let next = (done + part).min(1.0);
            let ahead = |(i, rod): (usize, &mut Rod)| rod.length_mm = lengths[i] + (1.0 - next) * from_home[i];
            rods.iter_mut().enumerate().for_each(ahead);
            match newton(&rods, pose) {
                Some(there) => (pose, done) = (there, next),
                None if part > SHORTEST => part *= 0.5,
                None => return None,
            }
        }
        Some(pose)
    }

    fn joint_at<T: Scalar>(&self, leg: usize, p: &[T], platform: &Pose<T>, _branch: T) -> T {
        self.rod(leg, p, T::from(0.0)).gap(platform)
    }
}

/// Pose of the platform to which Newton's method converges without leaving its branch.
fn newton(rods: &[Rod], mut pose: Pose) -> Option<Pose> {
    let lever = rods.iter().map(|rod| norm(rod.platform_mm)).fold(0.0, f64::max);
    let mut before = f64::INFINITY;
    for step in 0..STEPS {
        let by = -(lengthening(rods, &pose).lu().solve(&gaps(rods, &pose))?);
        let turn = [by[3], by[4], by[5]];
        let size = norm([by[0], by[1], by[2]]) + lever * norm(turn);
        let too_far = if step == 0 { norm(turn) > TURN } else { size > CONTRACTION * before };
        if size.is_nan() || too_far && size > FOUND_MM {
            return None;
        }
        let at = [0, 1, 2].map(|i| pose.translation_mm[i] + by[i]);
        pose = Pose { translation_mm: at, ..Pose::from_rotation_vector(turn).then(&pose) };
        if size < FOUND_MM {
            return Some(pose);
        }
        before = size;
    }
    None
}
