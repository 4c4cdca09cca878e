//! Delta robots (Clavel 1988): a platform on three pairs of parallel rods, which allow translation
//! but no rotation. The rods hang on rotating arms (`delta`) or on carriages that slide along
//! towers (`delta_linear`); the platform is below.
//!
//! Each pair of rods is modelled as one rod between the midpoints of its joints. The upper end of a
//! rod moves on a circle or a line in space, with seven or five parameters; with the length of the
//! rod, a leg has eight (24 parameters in total: Vischer & Clavel 1998) or six. The radius of the
//! platform adds one parameter; it is unobservable beside the radius of the base, as only their
//! difference has an effect.

use super::keys::{Description, Reader};
use super::parallel::{LegParameter, Legs, Parallel, Rod};
use super::prexyt::travel_mm;
use super::{At, FaultKind, Faults, Key, Model, Quantity, REACH, Robot, meaning, root, wrong_targets};
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm};
use etalon_base::scalar::Scalar;
use etalon_base::sketch::{Sketch, StrokeKind};
use std::f64::consts::FRAC_PI_2;

/// Delta with rotating arms.
pub(super) const ROTARY: Model = Model::new::<RotaryKeys>("delta");
/// Delta with carriages on towers.
pub(super) const LINEAR: Model = Model::new::<LinearKeys>("delta_linear");

const LEGS: usize = 3;
const RADIUS: &str = meaning("meaning-foot-outwards");
const SIDE: &str = meaning("meaning-foot-aside");
const ROD: &str = meaning("meaning-rod-length");
const PLATFORM: &str = meaning("meaning-rod-joint");

/// Description common to all deltas.
struct Common {
    base_radius_mm: f64,
    platform_radius_mm: f64,
    rod_mm: f64,
    azimuths: Azimuths,
}

impl Common {
    fn read(keys: &mut Reader) -> Self {
        Self {
            base_radius_mm: keys.required(Key::length(
                "base_radius",
                "Distance of the motor axes or towers of a delta from the z axis of its base.",
            )),
            platform_radius_mm: keys.required(Key::length(
                "platform_radius",
                "Distance of the rods' joints on the platform of a delta from the z axis of the platform.",
            )),
            rod_mm: keys.required(Key::length("rod", "Length of the rods of a delta (its forearms).")),
            azimuths: Azimuths(
                keys.or(
                    Key::angle(
                        "azimuth",
                        "Directions of the three arms or towers of a delta in its base, about z from x.",
                    )
                    .essential(),
                    [0.0, 120.0, 240.0],
                ),
            ),
        }
    }
}

/// Description of a delta with arms.
struct RotaryKeys {
    common: Common,
    upper_arm_mm: f64,
    limits_rad: [Option<[f64; 2]>; LEGS],
}

/// Description of a delta with towers.
struct LinearKeys {
    common: Common,
    travel_mm: Option<[f64; 3]>,
}

/// Creates a robot of three equal legs; `lengths` must be positive.
fn build<L: Legs + 'static>(
    legs: L,
    nominal: &[f64],
    limits: [Option<[f64; 2]>; 3],
    lengths: &[(&'static str, f64)],
    targets: &[String],
) -> Result<Box<dyn Robot>, Faults> {
    let mut faults = wrong_targets(targets);
    for (key, _) in lengths.iter().filter(|(_, length)| !(*length > 0.0 && length.is_finite())) {
        faults.add(At::Key(key), FaultKind::NotPositive(key));
    }
    faults.or(Box::new(Parallel::new(legs, &nominal.repeat(LEGS), limits.to_vec(), targets)) as _)
}

impl Description for RotaryKeys {
    fn read(keys: &mut Reader) -> Self {
        Self {
            common: Common::read(keys),
            upper_arm_mm: keys.required(Key::length(
                "upper_arm",
                "Length of the upper arms of a delta. At joint value zero the arms are level and point outwards; they sink with growing joint values.",
            )),
            limits_rad: keys.table(Key::plain("reach", REACH), |keys| {
                [
                    ("theta1", "Smallest and largest encoder angle of joint 1."),
                    ("theta2", "Smallest and largest encoder angle of joint 2."),
                    ("theta3", "Smallest and largest encoder angle of joint 3."),
                ]
                .map(|(name, meaning)| keys.optional(Key::angle(name, meaning)))
            }),
        }
    }

    fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        let Self { common: Common { base_radius_mm, platform_radius_mm, rod_mm, azimuths }, upper_arm_mm, limits_rad } =
            *self;
        let nominal = [base_radius_mm, 0.0, 0.0, 0.0, 0.0, upper_arm_mm, 0.0, rod_mm, platform_radius_mm];
        build(Rotary(azimuths), &nominal, limits_rad, &[("rod", rod_mm), ("upper_arm", upper_arm_mm)], targets)
    }
}

impl Description for LinearKeys {
    fn read(keys: &mut Reader) -> Self {
        Self { common: Common::read(keys), travel_mm: travel_mm(keys) }
    }

    fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        let Common { base_radius_mm, platform_radius_mm, rod_mm, azimuths } = self.common;
        let nominal = [0.0, 0.0, 0.0, base_radius_mm, 0.0, rod_mm, platform_radius_mm];
        let limits = [0, 1, 2].map(|i| self.travel_mm.map(|travel| [0.0, travel[i]]));
        build(Linear(azimuths), &nominal, limits, &[("rod", rod_mm)], targets)
    }
}

/// Directions of the legs in the base frame (rad).
#[derive(Clone, Copy, Debug)]
struct Azimuths([f64; LEGS]);

impl Azimuths {
    /// Frame of a leg in base or platform, with its x axis pointing outwards.
    fn frame<T: Scalar>(&self, leg: usize) -> Pose<T> {
        Pose::identity().turn_z(T::from(self.0[leg]))
    }
}

/// Rotating arms.
#[derive(Clone, Copy, Debug)]
struct Rotary(Azimuths);

impl Rotary {
    /// Frame of a motor; the arm rotates about its y axis.
    fn motor<T: Scalar>(&self, leg: usize, p: &[T]) -> Pose<T> {
        let foot = self.0.frame(leg).shift(0, p[0]).shift(1, p[1]).shift(2, p[2]);
        foot.turn_z(p[3]).turn_x(p[4])
    }
}

impl Legs for Rotary {
    const MODEL: &'static str = "delta";
    const PARAMETERS: &'static [LegParameter] = &[
        LegParameter { name: "base_radius_#", quantity: Quantity::Length, meaning: RADIUS },
        LegParameter { name: "base_side_#", quantity: Quantity::Length, meaning: SIDE },
        LegParameter { name: "base_height_#", quantity: Quantity::Length, meaning: meaning("meaning-motor-height") },
        LegParameter { name: "axis_rz_#", quantity: Quantity::Angle, meaning: meaning("meaning-motor-axis-turn-z") },
        LegParameter { name: "axis_rx_#", quantity: Quantity::Angle, meaning: meaning("meaning-motor-axis-turn-x") },
        LegParameter { name: "upper_arm_#", quantity: Quantity::Length, meaning: meaning("meaning-upper-arm-length") },
        LegParameter { name: "delta_#", quantity: Quantity::Angle, meaning: meaning("meaning-encoder-offset") },
        LegParameter { name: "rod_#", quantity: Quantity::Length, meaning: ROD },
        LegParameter { name: "platform_radius_#", quantity: Quantity::Length, meaning: PLATFORM },
    ];
    const JOINT: LegParameter = LegParameter { name: "theta#", quantity: Quantity::Angle, meaning: "" };
    const COUNT: usize = LEGS;
    const BRANCHES: &'static [f64] = &[1.0, -1.0];

    fn rod<T: Scalar>(&self, leg: usize, p: &[T], q: T) -> Rod<T> {
        let elbow = self.motor(leg, p).turn_y(q + p[6]).shift(0, p[5]);
        let platform = self.0.frame(leg).shift(0, p[8]);
        Rod { base_mm: elbow.translation_mm, platform_mm: platform.translation_mm, length_mm: p[7] }
    }

    fn direct<T: Scalar>(&self, rods: &[Rod<T>]) -> Option<Pose<T>> {
        hang(rods)
    }

    fn sketch(&self, p: &[f64], q: f64, platform: &Pose, sketch: &mut Sketch) {
        use StrokeKind::{Axis, Direction, Length, Part};
        let (motor, rod) = (self.motor(0, p), self.rod(0, p, q));
        let size = p[0] + p[5];
        let tip = |frame: &Pose, axis: usize, share: f64| frame.shift(axis, share * size).translation_mm;
        sketch.add(Part, "", &[motor.translation_mm, rod.base_mm]);
        sketch.add(Axis, "", &[tip(&motor, 1, -0.3), tip(&motor, 1, 0.3)]);
        sketch.add(Length, "base_radius_1", &[[0.0; 3], motor.translation_mm]);
        sketch.add(Length, "upper_arm_1", &[motor.translation_mm, rod.base_mm]);
        sketch.add(Direction, "base_side_1", &[motor.translation_mm, tip(&motor, 1, 0.2)]);
        sketch.add(Direction, "base_height_1", &[motor.translation_mm, tip(&motor, 2, 0.2)]);
        // about y, downwards from x; about z and x, from y
        sketch.add(Axis, "", &[motor.translation_mm, tip(&motor, 0, 0.4)]);
        sketch.angle("theta1 + delta_1", &motor.turn_x(-FRAC_PI_2), 0.3 * size, q + p[6]);
        sketch.angle("axis_rz_1", &motor.turn_z(FRAC_PI_2), 0.28 * size, 0.4);
        sketch.angle("axis_rx_1", &motor.turn_z(FRAC_PI_2).turn_x(FRAC_PI_2), 0.28 * size, 0.4);
        on_platform(&rod, platform, sketch);
    }

    fn limb(&self, leg: usize, p: &[f64], _q: f64) -> Vec<Vector> {
        vec![self.motor(leg, p).translation_mm]
    }

    /// Joint value at which the elbow, one of two, is a rod's length away from the joint on the
    /// platform.
    fn joint_at<T: Scalar>(&self, leg: usize, p: &[T], platform: &Pose<T>, branch: T) -> T {
        let [x, y, z] = self.motor(leg, p).inverse().apply(self.rod(leg, p, T::from(0.0)).shifted(platform));
        // x cos θ − z sin θ = c, for an elbow at (l cos θ, 0, −l sin θ)
        let c = (x * x + y * y + z * z + p[5] * p[5] - p[7] * p[7]) / (p[5] * 2.0);
        let half = root(x * x + z * z - c * c, p[5].value().powi(2)).atan2(c);
        ((-z).atan2(x) - branch * half - p[6]).wrapped()
    }
}

/// Carriages on towers.
#[derive(Clone, Copy, Debug)]
struct Linear(Azimuths);

impl Linear {
    /// Frame of a tower at the height of the base; the tower is its z axis.
    fn tower<T: Scalar>(&self, leg: usize, p: &[T]) -> Pose<T> {
        self.0.frame(leg).shift(0, p[3]).shift(1, p[4]).turn_y(p[1]).turn_x(p[2])
    }
}

impl Legs for Linear {
    const MODEL: &'static str = "delta_linear";
    const PARAMETERS: &'static [LegParameter] = &[
        // a rotation about the last tower moves the foot of another tower most, whose last
        // parameter is held
        LegParameter { name: "offset_#", quantity: Quantity::Length, meaning: meaning("meaning-carriage-offset") },
        LegParameter { name: "tower_ry_#", quantity: Quantity::Angle, meaning: meaning("meaning-tower-turn-y") },
        LegParameter { name: "tower_rx_#", quantity: Quantity::Angle, meaning: meaning("meaning-tower-turn-x") },
        LegParameter { name: "base_radius_#", quantity: Quantity::Length, meaning: RADIUS },
        LegParameter { name: "base_side_#", quantity: Quantity::Length, meaning: SIDE },
        LegParameter { name: "rod_#", quantity: Quantity::Length, meaning: ROD },
        LegParameter { name: "platform_radius_#", quantity: Quantity::Length, meaning: PLATFORM },
    ];
    const JOINT: LegParameter = LegParameter { name: "rho#", quantity: Quantity::Length, meaning: "" };
    const COUNT: usize = LEGS;

    fn rod<T: Scalar>(&self, leg: usize, p: &[T], q: T) -> Rod<T> {
        let carriage = self.tower(leg, p).shift(2, q + p[0]);
        let platform = self.0.frame(leg).shift(0, p[6]);
        Rod { base_mm: carriage.translation_mm, platform_mm: platform.translation_mm, length_mm: p[5] }
    }

    fn direct<T: Scalar>(&self, rods: &[Rod<T>]) -> Option<Pose<T>> {
        hang(rods)
    }

    fn sketch(&self, p: &[f64], q: f64, platform: &Pose, sketch: &mut Sketch) {
        use StrokeKind::{Direction, Length, Part};
        let (tower, rod) = (self.tower(0, p), self.rod(0, p, q));
        let size = norm(minus(rod.base_mm, tower.translation_mm)).max(p[3]);
        let tip = |frame: &Pose, axis: usize, share: f64| frame.shift(axis, share * size).translation_mm;
        sketch.add(Part, "", &[tower.translation_mm, tip(&tower, 2, 1.2)]);
        sketch.add(Length, "base_radius_1", &[[0.0; 3], tower.translation_mm]);
        sketch.add(Direction, "base_side_1", &[tower.translation_mm, tip(&tower, 1, 0.2)]);
        sketch.add(Direction, "rho1 + offset_1", &[tower.translation_mm, rod.base_mm]);
        sketch.angle("tower_rx_1", &tower.turn_y(-FRAC_PI_2), 1.1 * size, -0.3);
        sketch.angle("tower_ry_1", &tower.turn_z(-FRAC_PI_2).turn_y(-FRAC_PI_2), 1.1 * size, -0.3);
        on_platform(&rod, platform, sketch);
    }

    fn limb(&self, leg: usize, p: &[f64], _q: f64) -> Vec<Vector> {
        vec![self.tower(leg, p).translation_mm]
    }

    /// Joint value at which the carriage, above the platform, is a rod's length away from the joint
    /// on the platform.
    fn joint_at<T: Scalar>(&self, leg: usize, p: &[T], platform: &Pose<T>, _branch: T) -> T {
        let [x, y, z] = self.tower(leg, p).inverse().apply(self.rod(leg, p, T::from(0.0)).shifted(platform));
        z + root(p[5] * p[5] - x * x - y * y, p[5].value().powi(2)) - p[0]
    }
}

/// Draws the rod of the first leg and its joint on the platform.
fn on_platform(rod: &Rod, platform: &Pose, sketch: &mut Sketch) {
    let end = platform.apply(rod.platform_mm);
    sketch.add(StrokeKind::Length, "rod_1", &[rod.base_mm, end]);
    sketch.add(StrokeKind::Length, "platform_radius_1", &[platform.translation_mm, end]);
}

/// Pose of the platform on three rods: the lower intersection of three spheres about the upper ends
/// of the rods minus their ends on the platform.
fn hang<T: Scalar>(rods: &[Rod<T>]) -> Option<Pose<T>> {
    let &[one, two, three] = rods else { return None };
    let centre = |rod: Rod<T>| minus(rod.base_mm, rod.platform_mm);
    let (origin, r) = (centre(one), [one, two, three].map(|rod| rod.length_mm * rod.length_mm));
    let (to_two, to_three) = (minus(centre(two), origin), minus(centre(three), origin));
    let d = dot(to_two, to_two).sqrt();
    let x = to_two.map(|v| v / d);
    let along = dot(x, to_three);
    let beside = [0, 1, 2].map(|i| to_three[i] - along * x[i]);
    let across = dot(beside, beside).sqrt();
    let y = beside.map(|v| v / across);
    let z = cross(x, y);
    let u = (r[0] - r[1] + d * d) / (d * 2.0);
    let v = (r[0] - r[2] + along * along + across * across - along * u * 2.0) / (across * 2.0);
    let upwards = z[2] / (z[2] * z[2]).sqrt();
    let down = -(root(r[0] - u * u - v * v, r[0].value()) * upwards);
    let translation_mm = [0, 1, 2].map(|i| origin[i] + u * x[i] + v * y[i] + down * z[i]);
    Some(Pose { translation_mm, ..Pose::identity() })
}
