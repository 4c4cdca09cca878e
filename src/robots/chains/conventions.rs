//! `model = "serial"`: an arm described by a table of its joints in one of three conventions.
//!
//! The conventions are modified Denavit-Hartenberg parameters (Craig 1986), standard
//! Denavit-Hartenberg parameters (Denavit & Hartenberg 1955), and screw axes (product of
//! exponentials: Brockett 1984). Both tables use Hayati's angle for near-parallel axes (Hayati &
//! Mirmirani 1985).

use crate::chain::Motion;
use crate::keys::{Description, Reader, Stated};
use crate::published::PUBLISHED;
use crate::serial::{ArmBuilder, Body, Drive, Effects, drawn_link};
use crate::tables::{AxisLine, NEAR_PARALLEL_RAD, TableConvention};
use crate::{
    At, Fault, FaultKind, Faults, Joint, JointFault, JointRef, Key, Model, Parameter, Quantity, Robot, Role, Serial,
    meaning, wrong_targets,
};
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, minus, unit};
use std::cmp::Ordering;
use std::f64::consts::{FRAC_PI_2, PI};

/// Serial arm.
pub(crate) const MODEL: Model = Model::new::<Keys>("serial");

/// Convention of the description of an arm.
#[derive(Clone, Copy, Debug)]
enum Convention {
    /// Denavit-Hartenberg parameters.
    Table(TableConvention),
    /// Screw axes in the base frame at joint values zero (product of exponentials).
    Poe,
}

const CONVENTION: &str = "Parameters of the joints of a serial arm: modified (`mdh`) or standard (`dh`) Denavit-Hartenberg parameters, or screw axes (`poe`).";
const MDH: &str = "Modified Denavit-Hartenberg parameters (Craig): Rx(alpha) Tx(a) Rz(theta + q) Tz(d).";
const DH: &str = "Standard Denavit-Hartenberg parameters: Rz(theta + q) Tz(d) Tx(a) Rx(alpha).";
const POE: &str = "Screw axes in the base at zero joints (product of exponentials).";
const JOINT: &str = "A joint of a serial arm, from the base. Denavit-Hartenberg parameters need alpha, a, theta and d, each in one of its two units. A screw axis needs its direction and, if it is revolute, a point on it.";

/// Description of a serial arm.
struct Keys {
    convention: Convention,
    joints: Vec<JointKeys>,
    effects: EffectKeys,
    flange_xyz_mm: Option<Vector>,
    flange_rpy_rad: Option<Vector>,
}

/// Description of the non-geometric effects of an arm.
pub(crate) struct EffectKeys {
    pub gravity: Vector,
    pub bending: Vec<JointRef>,
    pub coupling: Vec<(JointRef, JointRef)>,
    pub harmonics: Vec<JointRef>,
    pub backlash: Vec<JointRef>,
    pub payload: Vec<JointRef>,
    pub torque: Vec<JointRef>,
    pub drift: Vec<JointRef>,
    pub expansion: bool,
    pub reference_c: f64,
    pub lateral: Vec<JointRef>,
    pub pedestal: bool,
}

impl EffectKeys {
    pub fn read(keys: &mut Reader) -> Self {
        Self {
            gravity: keys.or(Key::plain("gravity", "Direction of gravity in the base of an arm."), [0.0, 0.0, -1.0]),
            bending: keys.or(
                Key::plain("bending", "Joints of an arm that bend under gravity: their numbers, from 1, or names."),
                Vec::new(),
            ),
            coupling: keys.or(
                Key::plain(
                    "coupling",
                    "Coupled joints of an arm: pairs of a joint and the joint that moves it, by their numbers, from 1, or names.",
                ),
                Vec::new(),
            ),
            harmonics: keys.or(
                Key::plain(
                    "harmonics",
                    "Joints of an arm whose transmission deviates once and twice a turn: their numbers, from 1, or names.",
                ),
                Vec::new(),
            ),
            backlash: keys.or(
                Key::plain(
                    "backlash",
                    "Joints of an arm with backlash: their numbers, from 1, or names. The direction of approach of each is needed: `NAME_direction`.",
                ),
                Vec::new(),
            ),
            payload: keys.or(
                Key::plain(
                    "payload",
                    "Joints of an arm that bend under a payload that differs from reading to reading: their numbers, from 1, or names. Each reading states it: `load_kg`, `load_x_mm`, `load_y_mm`, `load_z_mm`.",
                ),
                Vec::new(),
            ),
            torque: keys.or(
                Key::plain(
                    "torque",
                    "Joints of an arm that bend in proportion to their torques: their numbers, from 1, or names. Each reading states the torques: `tau1_nm`, or `NAME_nm`.",
                ),
                Vec::new(),
            ),
            drift: keys.or(
                Key::plain(
                    "drift",
                    "Joints of an arm whose zeros drift with the temperature of the robot: their numbers, from 1, or names. Each reading states it: `temperature_c`.",
                ),
                Vec::new(),
            ),
            expansion: keys.or(
                Key::plain(
                    "expansion",
                    "All lengths of the arm expand with the temperature of the robot, by a common coefficient. Each reading states it: `temperature_c`.",
                ),
                false,
            ),
            reference_c: keys.or(
                Key::plain(
                    "reference_temperature_c",
                    "Temperature (°C) to which lengths and zeros refer, for `drift` and `expansion`.",
                ),
                20.0,
            ),
            lateral: keys.or(
                Key::plain(
                    "lateral",
                    "Revolute joints of an arm that tilt across their axes: their numbers, from 1, or names. The moment comes from the masses (`mass_kg` of `[[joint]]`, or the URDF) and the payload. Without masses each reading states the payload.",
                ),
                Vec::new(),
            ),
            pedestal: keys.or(
                Key::plain(
                    "pedestal",
                    "The base of an arm tilts under the moment of masses and payload. Without masses each reading states the payload.",
                ),
                false,
            ),
        }
    }

    /// Looks up the joints among `joints`, by their numbers or names.
    pub fn among(&self, joints: &[Joint]) -> Result<Effects, Faults> {
        let names: Vec<&str> = joints.iter().map(|joint| joint.name.as_str()).collect();
        let mut faults = Faults::default();
        let mut wrong = |key, i, what| {
            let joints = names.iter().map(|&name| name.to_owned()).collect();
            faults.add(At::Item(key, i), FaultKind::Joint { what, joints });
        };
        let find = |joint: &JointRef| {
            let known = match joint {
                JointRef::Number(number) => number.checked_sub(1).filter(|j| *j < joints.len()),
                JointRef::Name(name) => names.iter().position(|known| known == name),
            };
            known.ok_or_else(|| JointFault::Unknown(joint.clone()))
        };
        let mut effects = Effects::default();
        let lists = [
            ("bending", &self.bending, &mut effects.bending),
            ("harmonics", &self.harmonics, &mut effects.harmonics),
            ("backlash", &self.backlash, &mut effects.backlash),
            ("payload", &self.payload, &mut effects.payload),
            ("torque", &self.torque, &mut effects.torque),
            ("drift", &self.drift, &mut effects.thermal.drift),
            ("lateral", &self.lateral, &mut effects.lateral),
        ];
        for (key, stated, list) in lists {
            for (i, joint) in stated.iter().enumerate() {
                match find(joint) {
                    Err(unknown) => wrong(key, i, unknown),
                    Ok(j)
                        if ["harmonics", "payload", "torque", "lateral"].contains(&key)
                            && joints[j].quantity == Quantity::Length =>
                    {
                        wrong(key, i, JointFault::Slides(j));
                    }
                    Ok(j) if list.contains(&j) => wrong(key, i, JointFault::Twice(j)),
                    Ok(j) => list.push(j),
                }
            }
        }
        for (i, (joint, by)) in self.coupling.iter().enumerate() {
            match (find(joint), find(by)) {
                (Err(unknown), _) | (_, Err(unknown)) => wrong("coupling", i, unknown),
                (Ok(j), Ok(by)) if j == by => wrong("coupling", i, JointFault::WithItself(j)),
                (Ok(j), Ok(by)) if effects.coupling.contains(&(j, by)) => {
                    wrong("coupling", i, JointFault::PairTwice(j, by));
                }
                (Ok(j), Ok(by)) => effects.coupling.push((j, by)),
            }
        }
        (effects.thermal.expansion, effects.thermal.reference_c) = (self.expansion, self.reference_c);
        effects.pedestal = self.pedestal;
        match unit(self.gravity) {
            Some(direction) => effects.gravity = direction,
            None => faults.add(At::Key("gravity"), FaultKind::GravityWithoutDirection),
        }
        faults.or(effects)
    }
}

/// Largest twist or offset of a joint (rad): two turns.
const MOST_RAD: f64 = 4.0 * PI;
/// Maximum deviation of a number from a multiple of π/2 that is written with five digits.
const QUARTER: f64 = 5e-5;

/// `true` for degrees that were read as radians, and for one to four quarter turns in radians that
/// were read as degrees: 1.5708 deg is no twist of a robot.
fn is_in_other_unit(angle_rad: f64) -> bool {
    let written = angle_rad.to_degrees();
    let quarters = (written / FRAC_PI_2).round();
    let is_quarter = (1.0..=4.0).contains(&quarters.abs()) && (written - quarters * FRAC_PI_2).abs() < QUARTER;
    is_quarter || angle_rad.abs() > MOST_RAD
}

/// Description of a joint of a serial arm.
struct JointKeys {
    alpha_rad: Stated<f64>,
    a_mm: Stated<f64>,
    theta_rad: Stated<f64>,
    d_mm: Stated<f64>,
    direction: Option<Vector>,
    point_mm: Stated<Vector>,
    prismatic: bool,
    parallel: Option<bool>,
    limits_rad: Option<[f64; 2]>,
    travel_mm: Option<[f64; 2]>,
    mass_kg: f64,
    center_mm: Vector,
}

impl JointKeys {
    fn read(keys: &mut Reader) -> Self {
        Self {
            alpha_rad: keys.in_two_units(
                Key::angle("alpha", "Twist of the link: of the previous one in modified parameters.").essential(),
            ),
            a_mm: keys.in_two_units(
                Key::length("a", "Length of the link: of the previous one in modified parameters.").essential(),
            ),
            theta_rad: keys.in_two_units(Key::angle("theta", "Joint offset.").essential()),
            d_mm: keys.in_two_units(Key::length("d", "Link offset.").essential()),
            direction: keys.optional(
                Key::plain("direction", "Direction of a screw axis in the base at zero joints, of any length.")
                    .essential(),
            ),
            point_mm: keys.in_two_units(Key::length("point", "A point on the screw axis.").essential()),
            prismatic: keys.or(Key::plain("prismatic", "The joint is prismatic."), false),
            parallel: keys.optional(Key::plain(
                "parallel",
                "Near-parallel or antiparallel to the previous axis (`mdh`) or to the next one (`dh`): Hayati's beta replaces d. The default is `true` within 3 degrees, also for prismatic joints.",
            )),
            limits_rad: keys.optional(Key::angle(
                "limits",
                "Smallest and largest value of a revolute joint. Without limits, joint values beyond two turns are refused.",
            )),
            travel_mm: keys.optional(Key::length("travel", "Smallest and largest value of a prismatic joint.")),
            mass_kg: keys.or(
                Key::plain("mass_kg", "Mass (kg) of the links between this joint and the next, for `lateral` and `pedestal`."),
                0.0,
            ),
            center_mm: keys.or(
                Key::length(
                    "center",
                    "Centre of this mass: in the frame behind the joint (`mdh`, `dh`), or in the base at zero joints (`poe`).",
                ),
                [0.0; 3],
            ),
        }
    }

    /// Limits of joint `i` (mm or rad).
    fn limits(&self, i: usize) -> Result<Option<[f64; 2]>, Faults> {
        let (own, stated) = if self.prismatic { ("travel", self.travel_mm) } else { ("limits", self.limits_rad) };
        let foreign = if self.prismatic { self.limits_rad.map(|_| "limits") } else { self.travel_mm.map(|_| "travel") };
        let kind = match (foreign, stated) {
            (Some(key), _) => FaultKind::RangeOfOtherMotion { key, own },
            (_, Some([lower, upper])) if lower.partial_cmp(&upper) != Some(Ordering::Less) => {
                FaultKind::NoRange { key: own, ends: [lower, upper] }
            }
            _ => return Ok(stated),
        };
        Err(Fault::new(At::Item("joint", i), kind).into())
    }

    /// Joint `i` of a table; `alone` if there is no other axis on the side of its link.
    fn table_joint(&self, i: usize, alone: bool) -> Result<SerialJoint, Faults> {
        let (mut faults, at) = (Faults::default(), || At::Item("joint", i));
        let mut once = |key, stated| match stated {
            Stated::Once(value) => value,
            Stated::Twice => {
                faults.add(at(), FaultKind::StatedTwice(key));
                0.0
            }
            Stated::Missing => {
                faults.add(at(), FaultKind::Missing(key));
                0.0
            }
        };
        let alpha_rad = once("alpha", self.alpha_rad);
        let a_mm = once("a", self.a_mm);
        let theta_rad = once("theta", self.theta_rad);
        let d_mm = once("d", self.d_mm);
        for (key, angle_rad) in [("alpha", alpha_rad), ("theta", theta_rad)] {
            if is_in_other_unit(angle_rad) {
                faults.add(at(), FaultKind::AngleUnit { key, angle_rad });
            }
        }
        if self.direction.is_some() {
            faults.add(at(), FaultKind::NotDenavitHartenberg("direction"));
        }
        if !self.point_mm.is_missing() {
            faults.add(at(), FaultKind::NotDenavitHartenberg("point"));
        }
        let near = !alone && alpha_rad.sin().abs() < NEAR_PARALLEL_RAD.sin();
        let parallel = self.parallel.unwrap_or(near);
        faults.or(SerialJoint { alpha_rad, a_mm, theta_rad, d_mm, prismatic: self.prismatic, parallel })
    }

    /// Joint `i` as a screw axis.
    fn screw(&self, i: usize) -> Result<AxisLine, Faults> {
        let (mut faults, at) = (Faults::default(), || At::Item("joint", i));
        let table = [self.alpha_rad, self.a_mm, self.theta_rad, self.d_mm];
        if table.iter().any(|stated| !stated.is_missing()) || self.parallel.is_some() {
            faults.add(at(), FaultKind::NotScrew);
        }
        let direction = self.direction.and_then(unit);
        if direction.is_none() {
            let missing = FaultKind::Missing("direction");
            faults.add(at(), self.direction.map_or(missing, |_| FaultKind::AxisWithoutDirection));
        }
        let point_mm = match self.point_mm {
            Stated::Once(point_mm) => point_mm,
            Stated::Twice => {
                faults.add(at(), FaultKind::StatedTwice("point"));
                Vector::default()
            }
            Stated::Missing => {
                if !self.prismatic {
                    faults.add(at(), FaultKind::Missing("point"));
                }
                Vector::default()
            }
        };
        faults.or(AxisLine { direction: direction.unwrap_or_default(), point_mm, prismatic: self.prismatic })
    }
}

impl Keys {
    fn screws(&self, targets: &[String], effects: &Effects) -> Result<Serial, Faults> {
        let mut faults = Faults::default();
        let mut screws = Vec::new();
        for (i, keys) in self.joints.iter().enumerate() {
            screws.extend(faults.keep(keys.screw(i)));
        }
        let [xyz_mm, rpy_rad] = [self.flange_xyz_mm, self.flange_rpy_rad];
        if xyz_mm.is_none() || rpy_rad.is_none() {
            let key = if xyz_mm.is_none() { "flange_xyz" } else { "flange_rpy" };
            faults.add(At::Key("convention"), FaultKind::NoFlange(key));
        }
        let home = Pose::from_xyz_rpy(xyz_mm.unwrap_or_default(), rpy_rad.unwrap_or_default());
        faults.or(())?;
        Ok(Serial::from_screws(&screws, &home, targets, effects))
    }

    fn table(&self, convention: TableConvention, targets: &[String], effects: &Effects) -> Result<Serial, Faults> {
        let mut faults = Faults::default();
        let mut joints = Vec::new();
        for (i, keys) in self.joints.iter().enumerate() {
            let alone = i == if convention == TableConvention::Modified { 0 } else { self.joints.len() - 1 };
            joints.extend(faults.keep(keys.table_joint(i, alone)));
        }
        for (key, stated) in [("flange_xyz", self.flange_xyz_mm), ("flange_rpy", self.flange_rpy_rad)] {
            if stated.is_some() {
                faults.add(At::Key(key), FaultKind::FlangeOfTable(key));
            }
        }
        faults.or(())?;
        Ok(Serial::from_table(convention, &joints, targets, effects))
    }
}

impl Description for Keys {
    fn read(keys: &mut Reader) -> Self {
        let table = Convention::Table;
        Self {
            joints: keys.tables(Key::plain("joint", "Joints of a serial arm, from the base."), JOINT, JointKeys::read),
            convention: keys.choice(
                Key::plain("convention", CONVENTION),
                [
                    ("mdh", MDH, table(TableConvention::Modified)),
                    ("dh", DH, table(TableConvention::Standard)),
                    ("poe", POE, Convention::Poe),
                ],
            ),
            effects: EffectKeys::read(keys),
            flange_xyz_mm: keys.optional(Key::length(
                "flange_xyz",
                "Position of the flange in the base at zero joints, for screw axes.",
            )),
            flange_rpy_rad: keys.optional(Key::angle(
                "flange_rpy",
                "Orientation of the flange at zero joints: rx, ry, rz of Rz Ry Rx.",
            )),
        }
    }

    fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        if self.joints.is_empty() {
            return Err(Fault::new(At::Key("joint"), FaultKind::NoJoints).into());
        }
        let mut faults = wrong_targets(targets);
        let joints: Vec<Joint> = (1..).zip(&self.joints).map(|(i, keys)| Joint::numbered(i, keys.prismatic)).collect();
        // geometry is checked despite other faults
        let mut effects = faults.keep(self.effects.among(&joints)).unwrap_or_default();
        for (i, _) in self.joints.iter().enumerate().filter(|(_, keys)| keys.mass_kg < 0.0 || keys.mass_kg.is_nan()) {
            faults.add(At::Item("joint", i), FaultKind::NotPositive("mass_kg"));
        }
        effects.bodies =
            self.joints.iter().map(|keys| Body { mass_kg: keys.mass_kg, center_mm: keys.center_mm }).collect();
        let limits = self.joints.iter().enumerate().map(|(i, keys)| faults.keep(keys.limits(i)).flatten()).collect();
        let arm = faults.keep(match self.convention {
            Convention::Table(convention) => self.table(convention, targets, &effects),
            Convention::Poe => self.screws(targets, &effects),
        });
        arm.filter(|_| faults.0.is_empty()).map(|arm| Box::new(arm.with_limits(limits)) as _).ok_or(faults)
    }
}

/// Twist and length of the link before a joint.
const BEFORE: [&str; 2] = [meaning("meaning-link-twist-before"), meaning("meaning-link-length-before")];
/// Twist and length of the link after a joint.
const BEHIND: [&str; 2] = [meaning("meaning-link-twist-behind"), meaning("meaning-link-length-behind")];
const THETA: &str = meaning("meaning-joint-offset");
const D: &str = meaning("meaning-link-offset");
const BETA: &str = meaning("meaning-hayati-angle");

/// Nominal Denavit-Hartenberg parameters of one joint, in either convention.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SerialJoint {
    /// Twist of the link (rad).
    pub alpha_rad: f64,
    /// Length of the link (mm).
    pub a_mm: f64,
    /// Joint offset (rad).
    pub theta_rad: f64,
    /// Link offset (mm).
    pub d_mm: f64,
    /// `true` if the joint slides along its axis, `false` if it rotates about it.
    pub prismatic: bool,
    /// `true` if the lines of the axes at both ends of the link are nearly parallel, in the same or
    /// the opposite direction, so that Hayati's beta replaces d. The direction of a prismatic joint
    /// needs it as well.
    pub parallel: bool,
}

impl Serial {
    /// Creates an arm of `joints` in modified Denavit-Hartenberg parameters, with `targets` on its
    /// last link. `bending` lists the joints (from 1) that bend under gravity; `gravity` is its
    /// direction in the base frame. `coupling` lists pairs of a joint and the joint that moves it
    /// (from 1).
    pub fn new(
        joints: &[SerialJoint],
        targets: &[String],
        gravity: Vector,
        bending: &[usize],
        coupling: &[(usize, usize)],
    ) -> Self {
        let effects = Effects {
            gravity,
            bending: bending.iter().map(|j| j - 1).collect(),
            coupling: coupling.iter().map(|&(j, by)| (j - 1, by - 1)).collect(),
            ..Effects::default()
        };
        Self::from_table(TableConvention::Modified, joints, targets, &effects)
    }

    /// Creates an arm of `joints` in Denavit-Hartenberg parameters, with `targets` on its last
    /// link.
    pub fn from_axis_table(convention: TableConvention, joints: &[SerialJoint], targets: &[String]) -> Self {
        Self::from_table(convention, joints, targets, &Effects { gravity: [0.0, 0.0, -1.0], ..Effects::default() })
    }

    /// Creates an arm of screw axes in the base frame at joint values zero, with `targets` on its
    /// flange, whose pose there is `home` (product of exponentials: Brockett 1984).
    pub fn from_axes(axes: &[AxisLine], home: &Pose, targets: &[String]) -> Self {
        Self::from_screws(axes, home, targets, &Effects { gravity: [0.0, 0.0, -1.0], ..Effects::default() })
    }

    /// Arm described by a table of joints, with `targets` on its last link.
    fn from_table(convention: TableConvention, joints: &[SerialJoint], targets: &[String], effects: &Effects) -> Self {
        let other = convention.other();
        let rigid = Effects { gravity: effects.gravity, ..Effects::default() };
        let what = phrase!("table-read-as", convention = other.name());
        let mut others = vec![(what, Self::from_table_alone(other, joints, targets, &rigid))];
        for arm in PUBLISHED {
            let joints = arm.instead(convention, joints);
            let other = joints.map(|joints| Self::from_table_alone(convention, &joints, targets, effects));
            others.extend(other.map(|other| (phrase!("published-arm", title = arm.title), other)));
        }
        Self::from_table_alone(convention, joints, targets, effects).with_alternatives(others)
    }

    fn from_table_alone(
        convention: TableConvention,
        joints: &[SerialJoint],
        targets: &[String],
        effects: &Effects,
    ) -> Self {
        let modified = convention == TableConvention::Modified;
        let mut arm = ArmBuilder::new(targets);
        arm.elastic(effects);
        for (i, j) in joints.iter().enumerate() {
            let n = i + 1;
            let [alpha_means, a_means] = if modified { BEFORE } else { BEHIND };
            let own = |name: &str, quantity, nominal, meaning| {
                Parameter::new(format!("{name}_{n}"), quantity, Role::Robot, nominal).meaning(meaning).with_joint(i)
            };
            let alpha = arm.add(own("alpha", Quantity::Angle, j.alpha_rad, alpha_means));
            let a = arm.add(own("a", Quantity::Length, j.a_mm, a_means));
            let theta = arm.add(own("theta", Quantity::Angle, j.theta_rad, THETA));
            let beta_or_d = match j.parallel {
                true => arm.add(own("beta", Quantity::Angle, 0.0, BETA)),
                false => arm.add(own("d", Quantity::Length, j.d_mm, D)),
            };
            let link = |arm: &mut ArmBuilder| {
                arm.push(Motion::Turn(0), 0.0, &[alpha]);
                arm.push(Motion::Shift(0), 0.0, &[a]);
                if j.parallel {
                    arm.push(Motion::Turn(1), 0.0, &[beta_or_d]);
                }
            };
            if modified {
                link(&mut arm);
            }
            let drive = Drive::from_number(n, j.prismatic);
            let (fixed, offset): (f64, &[usize]) = if j.parallel { (j.d_mm, &[]) } else { (0.0, &[beta_or_d]) };
            arm.push(Motion::Turn(2), 0.0, &[theta]);
            if j.prismatic {
                arm.push(Motion::Shift(2), fixed, offset);
                arm.drive(drive, true);
            } else {
                arm.drive(drive, false);
                arm.push(Motion::Shift(2), fixed, offset);
                arm.frame();
                arm.tilt();
            }
            arm.carry(effects.bodies.get(i).copied().unwrap_or_default());
            if !modified {
                link(&mut arm);
            }
        }
        let link = drawn_link(convention, joints.iter().any(|j| j.parallel));
        let arm = arm.finish(joints.iter().map(|j| j.prismatic), effects);
        // no link exists without joints
        if joints.is_empty() { arm } else { arm.with_link(link) }
    }

    /// Arm described by screw axes, with `targets` on its flange; `home` is the pose of the flange
    /// in the base frame at joint values zero. Each axis has small errors in the base frame: two
    /// rotations and, for a revolute joint, two translations, at the point that describes the axis.
    fn from_screws(screws: &[AxisLine], home: &Pose, targets: &[String], effects: &Effects) -> Self {
        let mut arm = ArmBuilder::new(targets);
        arm.elastic(effects);
        for (i, screw) in screws.iter().enumerate() {
            let at = Pose { translation_mm: screw.point_mm, ..Pose::identity() };
            arm.place(at);
            let errors = arm.screw(screw.direction, Drive::from_number(i + 1, screw.prismatic), false);
            errors.iter().rev().for_each(|error| arm.push_back(error));
            arm.place(at.inverse());
            let Body { mass_kg, center_mm } = effects.bodies.get(i).copied().unwrap_or_default();
            arm.carry(Body { mass_kg, center_mm: minus(center_mm, screw.point_mm) });
        }
        arm.place(*home);
        arm.finish(screws.iter().map(|s| s.prismatic), effects)
    }
}

impl Drive {
    /// Drive of joint q`number`.
    fn from_number(number: usize, prismatic: bool) -> Self {
        Self {
            label: number.to_string(),
            name: format!("q{number}"),
            joint: number - 1,
            factor: 1.0,
            offset: 0.0,
            prismatic,
            mimics: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::serial::ThermalEffects;
    use etalon_base::noise::Noise;

    const TABLE: [(f64, f64, f64); 6] = [
        (0.0, 0.0, 290.0),
        (-1.57, 30.0, 0.0),
        (0.0, 270.0, 0.0),
        (-1.57, 70.0, 302.0),
        (1.57, 0.0, 0.0),
        (-1.57, 0.0, 72.0),
    ];

    fn all_effects() -> Effects {
        Effects {
            gravity: [0.0, 0.0, -1.0],
            backlash: vec![1],
            payload: vec![1, 2],
            torque: vec![0, 1, 4],
            thermal: ThermalEffects { drift: (0..6).collect(), expansion: true, reference_c: 20.0 },
            lateral: vec![0, 1, 4],
            pedestal: true,
            bodies: (0..6).map(|k| Body { mass_kg: 3.0, center_mm: [20.0 * f64::from(k), 10.0, -30.0] }).collect(),
            ..Effects::default()
        }
    }

    /// Arms of each convention with all effects of what a reading gives.
    fn arms(effects: &Effects) -> Vec<Serial> {
        let joint = |(alpha_rad, a_mm, d_mm): (f64, f64, f64)| SerialJoint {
            alpha_rad,
            a_mm,
            theta_rad: 0.0,
            d_mm,
            prismatic: false,
            parallel: alpha_rad == 0.0 && a_mm > 0.0,
        };
        let joints = TABLE.map(joint);
        let axis = |direction, point_mm| AxisLine { direction, point_mm, prismatic: false };
        let screws = [
            axis([0.0, 0.0, 1.0], [0.0; 3]),
            axis([0.0, 1.0, 0.0], [0.0, 0.0, 290.0]),
            axis([0.0, 1.0, 0.0], [0.0, 0.0, 560.0]),
            axis([1.0, 0.0, 0.0], [0.0, 0.0, 630.0]),
            axis([0.0, 0.6, 0.8], [302.0, 0.0, 630.0]),
            axis([1.0, 0.0, 0.0], [302.0, 0.0, 630.0]),
        ];
        let home = Pose::from_xyz_rpy([374.0, 0.0, 630.0], [0.0, 1.57, 0.0]);
        let targets = ["T".to_owned()];
        vec![
            Serial::from_table(TableConvention::Modified, &joints, &targets, effects),
            Serial::from_table(TableConvention::Standard, &joints, &targets, effects),
            Serial::from_screws(&screws, &home, &targets, effects),
        ]
    }

    /// Joint values, a direction, a payload, torques and a temperature.
    fn state(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
        let mut all: Vec<f64> = (0..robot.joints().len()).map(|_| noise.uniform(1.5)).collect();
        all.extend(robot.approached().iter().map(|_| 1.0));
        all.extend(robot.circumstances().iter().map(|stated| match stated {
            crate::Circumstance::PayloadMass => 3.0,
            crate::Circumstance::Temperature => 31.0,
            _ => noise.uniform(60.0),
        }));
        all
    }

    fn positions(robot: &dyn Robot, values: &[f64], state: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; 3];
        robot.positions(values, state, &mut out);
        out
    }

    #[test]
    fn derivatives_by_what_a_reading_states_are_those_of_differences() {
        let mut noise = Noise::new(45, 6);
        for robot in arms(&all_effects()) {
            let state = state(&robot, &mut noise);
            let scatter = |p: &Parameter| p.nominal + if p.quantity == Quantity::Length { 0.3 } else { 0.004 };
            let values: Vec<f64> = robot.parameters().iter().map(scatter).collect();
            let n = values.len();
            let mut jacobian = vec![0.0; 3 * n];
            robot.jacobian(&values, &state, &mut jacobian);
            for (j, p) in robot.parameters().iter().enumerate() {
                let h = if p.quantity == Quantity::Length { 1e-3 } else { 1e-6 };
                let at = |by: f64| {
                    let mut values = values.clone();
                    values[j] += by;
                    positions(&robot, &values, &state)
                };
                let (above, below) = (at(h), at(-h));
                for i in 0..3 {
                    let numeric = (above[i] - below[i]) / (2.0 * h);
                    let off = (jacobian[i * n + j] - numeric).abs();
                    assert!(off < 1e-5 * numeric.abs().max(1.0), "{} {i}: {numeric}, off by {off}", p.name);
                }
            }
            // bound parameters give the same positions
            let loads = robot.loads().map(|loads| loads(&state)).unwrap_or_default();
            let mut bound = vec![0.0; 3];
            robot.parametrised(&values).positions(State { joints: &state, loads: &loads }, &mut bound);
            let apart = bound.iter().zip(positions(&robot, &values, &state)).map(|(a, b)| (a - b).abs());
            assert!(apart.fold(0.0, f64::max) < 1e-9);
        }
    }

    /// An arm that expands is a larger arm: all lengths by hand, and the same in each convention.
    #[test]
    fn an_arm_that_expands_is_larger() {
        let thermal = ThermalEffects { expansion: true, reference_c: 20.0, ..ThermalEffects::default() };
        let effects = Effects { thermal, gravity: [0.0, 0.0, -1.0], ..Effects::default() };
        let mut noise = Noise::new(45, 7);
        for robot in arms(&effects) {
            let mut values = robot.nominal();
            values[robot.index("expansion").unwrap()] = 0.0115;
            let mut state: Vec<f64> = (0..6).map(|_| noise.uniform(1.5)).collect();
            let cold = positions(&robot, &values, &state);
            state.push(30.0);
            let warm = positions(&robot, &values, &state);
            for (cold, warm) in cold.iter().zip(warm) {
                assert!((warm - cold * (1.0 + 11.5e-6 * 10.0)).abs() < 1e-9, "{cold} {warm}");
            }
        }
    }

    /// Δq = c τ / 100 N·m and Δq = c (T − T₀) / 10 K: the same as another value of the joint.
    #[test]
    fn torques_and_temperatures_move_joints() {
        let torque = Effects { torque: vec![1], gravity: [0.0, 0.0, -1.0], ..Effects::default() };
        let thermal = ThermalEffects { drift: vec![1], reference_c: 20.0, ..ThermalEffects::default() };
        let drift = Effects { thermal, gravity: [0.0, 0.0, -1.0], ..Effects::default() };
        for (effects, name, stated, moved_rad) in
            [(torque, "compliance_2_torque", -40.0, -0.4e-3), (drift, "drift_2", 26.0, 0.6e-3)]
        {
            for robot in arms(&effects) {
                // the unit says by what the value is multiplied: −40 N·m, and 26 °C − 20 °C
                let unit = robot.parameters()[robot.index(name).unwrap()].full_unit().unwrap();
                match robot.reference_temperature_c() {
                    Some(reference_c) => assert_eq!((unit.as_str(), reference_c), ("deg/(10 K)", 20.0)),
                    None => assert_eq!(unit, "deg/(100 N·m)"),
                }
                let mut values = robot.nominal();
                let q = [0.3, -0.4, 0.5, 0.2, 0.9, 0.1];
                let mut moved = q;
                moved[1] += moved_rad;
                let expected = positions(&robot, &values, &moved);
                values[robot.index(name).unwrap()] = 1e-3;
                let found = positions(&robot, &values, &[&q[..], &[stated]].concat());
                assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} {expected:?}");
            }
        }
    }

    /// The moment of a stretched level arm by hand: 2 kg at 500 mm tilt the base by
    /// c · 9.80665 N·m / 100 N·m.
    #[test]
    fn bases_tilt_by_the_moment_of_the_masses() {
        let axis = AxisLine { direction: [0.0, 0.0, 1.0], point_mm: [0.0; 3], prismatic: false };
        let body = Body { mass_kg: 2.0, center_mm: [500.0, 0.0, 0.0] };
        let effects = Effects {
            gravity: [0.0, 0.0, -1.0],
            lateral: vec![0],
            pedestal: true,
            bodies: vec![body],
            ..Effects::default()
        };
        let home = Pose { translation_mm: [800.0, 0.0, 0.0], ..Pose::identity() };
        let robot = Serial::from_screws(&[axis], &home, &["T".to_owned()], &effects);
        // gravity has no moment about itself
        assert!(robot.index("pedestal_z").is_none() && robot.circumstances().is_empty());
        for name in ["pedestal_y", "lateral_1_y"] {
            let mut values = robot.nominal();
            values[robot.index(name).unwrap()] = 1e-3;
            // the arm sinks: a moment about +y
            let sunk = positions(&robot, &values, &[0.0])[2];
            assert!((sunk + 800.0 * 0.0980665e-3).abs() < 1e-6, "{name} {sunk}");
        }
        let across = |name: &str| {
            let mut values = robot.nominal();
            values[robot.index(name).unwrap()] = 1e-3;
            positions(&robot, &values, &[std::f64::consts::FRAC_PI_2])[2]
        };
        // the base bends about its own axes, the joint about those that turn with the arm
        assert!((across("pedestal_x") + 800.0 * 0.0980665e-3).abs() < 1e-6 && across("pedestal_y").abs() < 1e-9);
        assert!((across("lateral_1_y") + 800.0 * 0.0980665e-3).abs() < 1e-6 && across("lateral_1_x").abs() < 1e-9);
    }

    /// Drawn axes: the first is z of the base, and the last z of the flange.
    fn drawn_axes(noise: &mut Noise) -> (Vec<AxisLine>, Pose) {
        let (mut pose, mut axes) = (Pose::identity(), Vec::new());
        for twist in [0.0, 1.57, noise.uniform(1e-3), 0.0, -1.2, 1.57] {
            if !axes.is_empty() {
                let a_mm = if twist == -1.2 { 0.0 } else { 250.0 + noise.uniform(200.0) };
                pose = pose.turn_x(twist).shift(0, a_mm);
            }
            let (direction, point_mm) = (pose.axis(2), pose.translation_mm);
            axes.push(AxisLine { direction, point_mm, prismatic: false });
            pose = pose.turn_z(noise.uniform(3.0)).shift(2, 150.0 + noise.uniform(150.0));
        }
        (axes, pose)
    }

    /// Effects are functions of the lines of the axes: the same whichever point describes a line,
    /// and in every convention.
    #[test]
    fn effects_depend_on_the_lines_of_the_axes_alone() {
        let targets = ["T".to_owned()];
        for seed in 0..100 {
            let mut noise = Noise::new(59, seed);
            let (axes, home) = drawn_axes(&mut noise);
            let centre = |noise: &mut Noise| [0; 3].map(|_| noise.uniform(300.0));
            let centres: Vec<Vector> = (0..6).map(|_| centre(&mut noise)).collect();
            let with = |bodies: &dyn Fn(usize) -> Vector| Effects {
                bending: vec![0, 1, 2, 4],
                bodies: (0..6).map(|k| Body { mass_kg: 3.0, center_mm: bodies(k) }).collect(),
                gravity: [0.1, -0.2, -0.97],
                ..all_effects()
            };
            let in_base = with(&|k| centres[k]);
            let moved = |axis: &AxisLine, by: f64| AxisLine {
                point_mm: [0, 1, 2].map(|i| axis.point_mm[i] + by * axis.direction[i]),
                ..*axis
            };
            let elsewhere: Vec<AxisLine> = axes.iter().map(|axis| moved(axis, noise.uniform(1500.0))).collect();
            let mut all = vec![(Pose::identity(), Serial::from_screws(&axes, &home, &targets, &in_base))];
            all.push((Pose::identity(), Serial::from_screws(&elsewhere, &home, &targets, &in_base)));
            let tables = [
                (TableConvention::Modified, crate::modified_table(&elsewhere, &home)),
                (TableConvention::Standard, crate::standard_table(&elsewhere, &home)),
            ];
            for (convention, table) in tables {
                assert_eq!(table.base, Pose::identity());
                let built = |effects: &Effects| {
                    let mut arm = Serial::from_table(convention, &table.joints, &targets, effects);
                    let mut nominal = arm.nominal();
                    for tilt in &table.tilts {
                        nominal[arm.index(&format!("beta_{}", tilt.row + 1)).unwrap()] = tilt.angle_rad;
                    }
                    arm.definition_mut().set_nominal(&nominal);
                    arm.settle();
                    arm
                };
                let rigid = built(&Effects::default());
                let frames = rigid.joint_chain(&rigid.nominal()).unwrap().frames(&[0.0; 6]);
                all.push((table.flange, built(&with(&|k| frames[k].inverse().apply(centres[k])))));
            }
            let q = state(&all[0].1, &mut noise);
            let place = |(flange, robot): &(Pose, Serial)| {
                let mut values = robot.nominal();
                for (p, value) in robot.parameters().iter().zip(&mut values) {
                    if !p.effect.is_rigid() {
                        // by the name, in any order
                        *value += 1e-4 * p.name.bytes().map(f64::from).sum::<f64>() / 100.0;
                    }
                }
                let first = robot.index("T_x").unwrap();
                values[first..first + 3].copy_from_slice(&flange.apply([40.0, -30.0, 90.0]));
                let mut q = q.clone();
                let load = robot.stated.payload.unwrap();
                let at = flange.apply([q[load + 1], q[load + 2], q[load + 3]]);
                q[load + 1..load + 4].copy_from_slice(&at);
                positions(robot, &values, &q)
            };
            let expected = place(&all[0]);
            for (k, other) in all.iter().enumerate().skip(1) {
                let off = place(other).iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(off < 1e-8, "{seed}, {k}: {off}");
            }
        }
    }

    /// Hayati's angle by default: lines within 3 degrees of each other, in either direction,
    /// whether the joint turns or slides.
    #[test]
    fn parallel_and_antiparallel_axes_have_an_angle_more() {
        let of = |alpha_deg: f64, prismatic: bool, alone: bool, parallel: Option<bool>| {
            let keys = JointKeys {
                alpha_rad: Stated::Once(alpha_deg.to_radians()),
                a_mm: Stated::Once(300.0),
                theta_rad: Stated::Once(0.0),
                d_mm: Stated::Once(0.0),
                direction: None,
                point_mm: Stated::Missing,
                prismatic,
                parallel,
                limits_rad: None,
                travel_mm: None,
                mass_kg: 0.0,
                center_mm: [0.0; 3],
            };
            keys.table_joint(1, alone).unwrap().parallel
        };
        for prismatic in [false, true] {
            for alpha_deg in [0.0, 2.9, -2.9, 180.0, -180.0, 177.1, 182.9] {
                assert!(of(alpha_deg, prismatic, false, None), "{alpha_deg}");
                assert!(!of(alpha_deg, prismatic, true, None) && !of(alpha_deg, prismatic, false, Some(false)));
            }
            for alpha_deg in [3.1, 90.0, -90.0, 176.9] {
                assert!(!of(alpha_deg, prismatic, false, None), "{alpha_deg}");
                assert!(of(alpha_deg, prismatic, false, Some(true)));
            }
        }
    }
}
