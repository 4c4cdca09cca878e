//! `model = "serial"`: an arm by a table of its joints, in one of three conventions.
//!
//! Modified Denavit-Hartenberg parameters (Craig 1986) and standard ones (Denavit & Hartenberg 1955), with Hayati's angle for
//! near-parallel axes (Hayati & Mirmirani 1985), or screw axes (product of exponentials: Brockett 1984).

use super::chain::Motion;
use super::serial::{ArmBuilder, Drive, Effects};
use super::{Description, Joint, Model, Quantity, Robot, Serial, Source, meaning, wrong_targets};
use crate::base::message::{Message, Place, Problems, Result};
use crate::base::pose::{Pose, Vector, unit};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;

/// Serial arm.
pub(super) const MODEL: Model = Model::new::<Keys>(
    "serial",
    &[
        &["joint"],
        &["convention"],
        &["gravity"],
        &["bending"],
        &["coupling"],
        &["harmonics"],
        &["backlash"],
        &["flange_xyz_mm"],
        &["flange_rpy_deg"],
    ],
    &[
        "joint",
        "alpha_deg",
        "alpha_rad",
        "a_mm",
        "a_m",
        "theta_deg",
        "theta_rad",
        "d_mm",
        "d_m",
        "direction",
        "point_mm",
    ],
);

/// Axes whose twist is below this are near-parallel: d is replaced by Hayati's beta (3 degrees).
const NEAR_PARALLEL_RAD: f64 = 0.052;

/// How the joints of an arm are stated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Convention {
    /// Modified Denavit-Hartenberg parameters (Craig): Rx(alpha) Tx(a) Rz(theta + q) Tz(d).
    #[default]
    Mdh,
    /// Standard Denavit-Hartenberg parameters: Rz(theta + q) Tz(d) Tx(a) Rx(alpha).
    Dh,
    /// Screw axes in the base at zero joints (product of exponentials).
    Poe,
}

/// Keys of a serial arm in robot.toml.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Keys {
    /// What the joints of a serial arm state: modified (`mdh`) or standard (`dh`) Denavit-Hartenberg parameters, or screw axes (`poe`).
    #[serde(default)]
    convention: Convention,
    /// Joints of a serial arm, from the base.
    #[serde(default, rename = "joint")]
    joints: Vec<JointKeys>,
    /// Direction of gravity in the base of an arm.
    #[serde(default = "down")]
    gravity: Vector,
    /// Joints of an arm that bend under gravity: their numbers, from 1, or names.
    #[serde(default)]
    bending: Vec<JointRef>,
    /// Coupled joints of an arm: pairs of a joint and the joint that moves it, by their numbers, from 1, or names.
    #[serde(default)]
    coupling: Vec<(JointRef, JointRef)>,
    /// Joints of an arm whose transmission deviates once and twice a turn: their numbers, from 1, or names.
    #[serde(default)]
    harmonics: Vec<JointRef>,
    /// Joints of an arm with backlash: their numbers, from 1, or names. The direction from which each came is needed: `NAME_direction`.
    #[serde(default)]
    backlash: Vec<JointRef>,
    /// Place of the flange in the base at zero joints, where the joints are screw axes.
    flange_xyz_mm: Option<Vector>,
    /// Orientation of the flange there: rx, ry, rz of Rz Ry Rx.
    flange_rpy_deg: Option<Vector>,
}

pub(super) fn down() -> Vector {
    [0.0, 0.0, -1.0]
}

/// A joint by its number, from 1, or its name.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected the number of a joint, from 1, or its name")]
pub(super) enum JointRef {
    /// From 1.
    Number(usize),
    /// As its column begins.
    Name(String),
}

impl Effects {
    /// Looks up joints among `joints`, by their numbers or names.
    pub(super) fn new(
        gravity: Vector,
        [bending, harmonics, backlash]: [&[JointRef]; 3],
        coupling: &[(JointRef, JointRef)],
        joints: &[Joint],
        place: &dyn Fn(&[&str]) -> Place,
    ) -> Result<Self> {
        let n = joints.len();
        let mut problems = Problems::default();
        let names: Vec<&str> = joints.iter().map(|joint| joint.name.as_str()).collect();
        let mut wrong = |key: &str, i: usize, what: String| {
            let message = Message::error(what).at(place(&[key, &i.to_string()]));
            let message = message.expected(format!("joints from 1 to {n}, each once"));
            problems.0.push(message.hint(format!("the joints are {}", names.join(", "))));
        };
        let find = |joint: &JointRef| match joint {
            JointRef::Number(number) => {
                Some(*number).filter(|j| (1..=n).contains(j)).map(|j| j - 1).ok_or_else(|| number.to_string())
            }
            JointRef::Name(name) => names.iter().position(|known| known == name).ok_or_else(|| format!("`{name}`")),
        };
        let mut effects = Self::default();
        let lists = [
            ("bending", bending, &mut effects.bending),
            ("harmonics", harmonics, &mut effects.harmonics),
            ("backlash", backlash, &mut effects.backlash),
        ];
        for (key, stated, list) in lists {
            for (i, joint) in stated.iter().enumerate() {
                match find(joint) {
                    Err(name) => wrong(key, i, format!("there is no joint {name}")),
                    Ok(j) if key == "harmonics" && joints[j].quantity == Quantity::Length => {
                        wrong(key, i, format!("joint {} slides: it has no turn", names[j]));
                    }
                    Ok(j) if list.contains(&j) => wrong(key, i, format!("joint {} is there twice", j + 1)),
                    Ok(j) => list.push(j),
                }
            }
        }
        for (i, (joint, by)) in coupling.iter().enumerate() {
            match (find(joint), find(by)) {
                (Err(name), _) | (_, Err(name)) => wrong("coupling", i, format!("there is no joint {name}")),
                (Ok(j), Ok(by)) if j == by => {
                    wrong("coupling", i, format!("joint {} is coupled with itself: that is its gain", j + 1));
                }
                (Ok(j), Ok(by)) if effects.coupling.contains(&(j, by)) => {
                    wrong("coupling", i, format!("the pair {}, {} is there twice", j + 1, by + 1));
                }
                (Ok(j), Ok(by)) => effects.coupling.push((j, by)),
            }
        }
        match unit(gravity) {
            Some(direction) => effects.gravity = direction,
            None => problems.0.push(
                Message::error("`gravity` has no direction")
                    .at(place(&["gravity"]))
                    .expected("a direction in the base, e.g. [0, 0, -1]"),
            ),
        }
        problems.check().map(|_| effects)
    }
}

/// A joint of a serial arm, from the base. In Denavit-Hartenberg parameters alpha, a, theta and d must be stated, each in one of its two
/// units; of a screw axis its direction, and a point on it where it turns.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct JointKeys {
    /// Twist of the link: of the previous one in modified parameters.
    alpha_deg: Option<f64>,
    /// The same in radians.
    alpha_rad: Option<f64>,
    /// Length of the link: of the previous one in modified parameters.
    a_mm: Option<f64>,
    /// The same in metres.
    a_m: Option<f64>,
    /// Joint offset.
    theta_deg: Option<f64>,
    /// The same in radians.
    theta_rad: Option<f64>,
    /// Link offset.
    d_mm: Option<f64>,
    /// The same in metres.
    d_m: Option<f64>,
    /// Direction of a screw axis in the base at zero joints, of any length.
    direction: Option<Vector>,
    /// A point on it.
    point_mm: Option<Vector>,
    /// The same in metres.
    point_m: Option<Vector>,
    /// The joint is prismatic.
    #[serde(default)]
    prismatic: bool,
    /// Near-parallel to the previous axis (`mdh`) or to the next one (`dh`): Hayati's beta replaces d. By default so below 3 degrees of
    /// twist.
    parallel: Option<bool>,
    /// Smallest and largest value of a joint that turns. Where they are not stated, joint values beyond two turns are refused.
    limits_deg: Option<[f64; 2]>,
    /// Smallest and largest value of a prismatic joint.
    limits_mm: Option<[f64; 2]>,
}

impl JointKeys {
    /// Limits of the joint, rad or mm; `place` is that of a key of its table.
    fn limits(&self, place: &dyn Fn(&str) -> Place) -> Result<Option<[f64; 2]>> {
        let (key, other) = if self.prismatic { ("limits_mm", "limits_deg") } else { ("limits_deg", "limits_mm") };
        let (own, foreign) =
            if self.prismatic { (self.limits_mm, self.limits_deg) } else { (self.limits_deg, self.limits_mm) };
        if foreign.is_some() {
            let what =
                format!("`{other}` is not a key of a joint that {}", if self.prismatic { "slides" } else { "turns" });
            return Err(Message::error(what).at(place(other)).hint(format!("state `{key}`")).into());
        }
        if let Some([lower, upper]) = own.filter(|[lower, upper]| lower.partial_cmp(upper) != Some(Ordering::Less)) {
            let message = Message::error(format!("`{key}` is not a range: {lower} to {upper}")).at(place(key));
            return Err(message.expected("the smaller limit, then the larger one").into());
        }
        Ok(if self.prismatic { own } else { own.map(|ends| ends.map(f64::to_radians)) })
    }

    /// The joint; `alone` where no other axis is on the side of its link, `place` that of its table.
    fn of_table(&self, alone: bool, place: &Place) -> Result<SerialJoint> {
        let mut problems = Problems::default();
        let mut either = |keys: [&str; 2], stated: [Option<f64>; 2]| match stated {
            [Some(value), None] | [None, Some(value)] => value,
            [one, _] => {
                let [key, other] = keys;
                let what = match one {
                    Some(_) => format!("`{key}` and `{other}` state the same: leave one of them out"),
                    None => format!("the key `{key}` is missing in `joint`"),
                };
                problems.0.push(Message::error(what).at(place.clone()));
                0.0
            }
        };
        let alpha_rad = either(["alpha_deg", "alpha_rad"], [self.alpha_deg.map(f64::to_radians), self.alpha_rad]);
        let a_mm = either(["a_mm", "a_m"], [self.a_mm, self.a_m.map(|m| 1000.0 * m)]);
        let theta_rad = either(["theta_deg", "theta_rad"], [self.theta_deg.map(f64::to_radians), self.theta_rad]);
        let d_mm = either(["d_mm", "d_m"], [self.d_mm, self.d_m.map(|m| 1000.0 * m)]);
        let screw = [("direction", self.direction), ("point_mm", self.point_mm), ("point_m", self.point_m)];
        for (key, _) in screw.iter().filter(|(_, value)| value.is_some()) {
            let message = Message::error(format!("`{key}` is not a Denavit-Hartenberg parameter")).at(place.clone());
            problems.0.push(message.hint("it belongs to `convention = \"poe\"`"));
        }
        let near = !alone && alpha_rad.sin().abs() < NEAR_PARALLEL_RAD && !self.prismatic;
        let parallel = self.parallel.unwrap_or(near);
        problems.check()?;
        Ok(SerialJoint { alpha_rad, a_mm, theta_rad, d_mm, prismatic: self.prismatic, parallel })
    }

    /// The joint as a screw axis; `place` is that of its table.
    fn screw(&self, place: &Place) -> Result<Screw> {
        let mut problems = Problems::default();
        let table =
            [self.alpha_deg, self.alpha_rad, self.a_mm, self.a_m, self.theta_deg, self.theta_rad, self.d_mm, self.d_m];
        if table.iter().any(Option::is_some) || self.parallel.is_some() {
            let what = "a screw axis has neither Denavit-Hartenberg parameters nor `parallel`";
            problems.0.push(Message::error(what).at(place.clone()).hint("state `direction` and `point_mm`"));
        }
        let direction = self.direction.and_then(unit);
        if direction.is_none() {
            let what = match self.direction {
                Some(_) => "the axis of the joint has no direction",
                None => "the key `direction` is missing in `joint`",
            };
            let message = Message::error(what).at(place.clone());
            problems.0.push(message.expected("a direction in the base, e.g. [0, 0, 1]"));
        }
        let point_mm = match (self.point_mm, self.point_m.map(|p| p.map(|m| 1000.0 * m))) {
            (Some(_), Some(_)) => {
                let what = "`point_mm` and `point_m` state the same: leave one of them out";
                problems.0.push(Message::error(what).at(place.clone()));
                None
            }
            (mm, m) => mm.or(m),
        };
        if point_mm.is_none() && self.point_m.is_none() && !self.prismatic {
            problems.0.push(Message::error("the key `point_mm` is missing in `joint`").at(place.clone()));
        }
        problems.check()?;
        Ok(Screw {
            direction: direction.unwrap_or_default(),
            point_mm: point_mm.unwrap_or_default(),
            prismatic: self.prismatic,
        })
    }
}

impl Keys {
    fn screws(&self, targets: &[String], effects: &Effects, place: &dyn Fn(&[&str]) -> Place) -> Result<Serial> {
        let mut problems = Problems::default();
        let (mut screws, mut home) = (Vec::new(), Pose::identity());
        for (i, keys) in self.joints.iter().enumerate() {
            screws.extend(problems.keep(keys.screw(&place(&["joint", &i.to_string()]))));
        }
        match (self.flange_xyz_mm, self.flange_rpy_deg) {
            (Some(xyz_mm), Some(rpy_deg)) => home = Pose::from_xyz_rpy(xyz_mm, rpy_deg.map(f64::to_radians)),
            (xyz_mm, _) => {
                let key = if xyz_mm.is_none() { "flange_xyz_mm" } else { "flange_rpy_deg" };
                let what = format!("screw axes need the pose of the flange at zero joints: the key `{key}` is missing");
                problems.0.push(Message::error(what).at(place(&["convention"])));
            }
        }
        problems.check()?;
        Ok(Serial::of_screws(&screws, &home, targets, effects))
    }

    fn table(
        &self,
        convention: TableConvention,
        targets: &[String],
        effects: &Effects,
        place: &dyn Fn(&[&str]) -> Place,
    ) -> Result<Serial> {
        let mut problems = Problems::default();
        let mut joints = Vec::new();
        for (i, keys) in self.joints.iter().enumerate() {
            let alone = i == if convention == TableConvention::Modified { 0 } else { self.joints.len() - 1 };
            joints.extend(problems.keep(keys.of_table(alone, &place(&["joint", &i.to_string()]))));
        }
        for (key, stated) in [("flange_xyz_mm", self.flange_xyz_mm), ("flange_rpy_deg", self.flange_rpy_deg)] {
            if stated.is_some() {
                let message = Message::error(format!("`{key}` means nothing for Denavit-Hartenberg parameters"));
                problems.0.push(message.at(place(&[key])).hint("it belongs to `convention = \"poe\"`"));
            }
        }
        problems.check()?;
        Ok(Serial::of_table(convention, &joints, targets, effects))
    }
}

impl Description for Keys {
    fn states_geometry(&self) -> bool {
        true
    }

    fn build(&self, targets: &[String], source: &dyn Source) -> Result<Box<dyn Robot>> {
        let place = &|path: &[&str]| source.place(path);
        if self.joints.is_empty() {
            return Err(Message::error("a serial arm needs its joints")
                .at(place(&["joint"]))
                .hint("add one [[joint]] with alpha_deg, a_mm, theta_deg, d_mm per joint, from the base")
                .into());
        }
        let mut problems = wrong_targets(targets);
        let joints: Vec<Joint> = (1..).zip(&self.joints).map(|(i, keys)| Joint::numbered(i, keys.prismatic)).collect();
        let effects = problems.keep(Effects::new(
            self.gravity,
            [&self.bending, &self.harmonics, &self.backlash],
            &self.coupling,
            &joints,
            place,
        ));
        let of_joint = |(i, keys): (usize, &JointKeys)| {
            let i = i.to_string();
            problems.keep(keys.limits(&|key| place(&["joint", &i, key]))).flatten()
        };
        let limits = self.joints.iter().enumerate().map(of_joint).collect();
        // geometry is checked whatever is wrong with the rest
        let effects = effects.unwrap_or_default();
        let arm = problems.keep(match self.convention {
            Convention::Mdh => self.table(TableConvention::Modified, targets, &effects, place),
            Convention::Dh => self.table(TableConvention::Standard, targets, &effects, place),
            Convention::Poe => self.screws(targets, &effects, place),
        });
        arm.filter(|_| problems.0.is_empty()).map(|arm| Box::new(arm.with_limits(limits)) as _).ok_or(problems)
    }
}

/// Twist and length of the link before a joint.
const BEFORE: [&str; 2] = [
    meaning(
        "Twist of the link before the joint: angle from the z axis before to that of the joint, about the x axis before; counterclockwise positive.",
    ),
    meaning("Length of the link before the joint: distance of its two axes, along the x axis before."),
];
/// Those of the link behind it.
const BEHIND: [&str; 2] = [
    meaning(
        "Twist of the link behind the joint: angle from the z axis of the joint to the next, about the new x axis; counterclockwise positive.",
    ),
    meaning("Length of the link behind the joint: distance of its two axes, along the new x axis."),
];
const THETA: &str =
    meaning("Joint offset: added to the logged joint value, about the z axis; counterclockwise positive.");
const D: &str = meaning("Link offset along the z axis of the joint.");
const BETA: &str = meaning(
    "Hayati's angle between near-parallel axes, about the y axis, in place of the link offset; counterclockwise positive.",
);

/// Where the link of a joint comes in a table of Denavit-Hartenberg parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum TableConvention {
    /// Before the joint: Rx(alpha) Tx(a) [Ry(beta)] Rz(theta + q) Tz(d) (Craig).
    Modified,
    /// Behind it: Rz(theta + q) Tz(d) Tx(a) Rx(alpha) [Ry(beta)].
    Standard,
}

impl TableConvention {
    /// The other one.
    fn other(self) -> Self {
        if self == Self::Modified { Self::Standard } else { Self::Modified }
    }

    /// As it is called.
    fn name(self) -> &'static str {
        if self == Self::Modified { "modified" } else { "standard" }
    }
}

/// Nominal Denavit-Hartenberg parameters of one joint, in either convention.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SerialJoint {
    /// Twist of the link, rad.
    pub alpha_rad: f64,
    /// Length of the link, mm.
    pub a_mm: f64,
    /// Joint offset, rad.
    pub theta_rad: f64,
    /// Link offset, mm.
    pub d_mm: f64,
    /// The joint moves along its axis instead of turning about it.
    pub prismatic: bool,
    /// The axes at both ends of the link are nearly parallel: Hayati's beta replaces d.
    pub parallel: bool,
}

/// Axis of a joint in the base at zero joints.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Screw {
    /// Direction, of length one.
    direction: Vector,
    /// A point on it, mm.
    point_mm: Vector,
    /// The joint moves along its axis instead of turning about it.
    prismatic: bool,
}

impl Serial {
    /// An arm of `joints` in modified Denavit-Hartenberg parameters, with `targets` on its last link. `bending` lists the joints (from
    /// 1) that bend under gravity, whose direction in the base is `gravity`; `coupling` lists pairs (joint, by which joint), from 1.
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
            harmonics: Vec::new(),
            backlash: Vec::new(),
        };
        Self::of_table(TableConvention::Modified, joints, targets, &effects)
    }

    /// An arm of a table of joints with `targets` on its last link.
    fn of_table(convention: TableConvention, joints: &[SerialJoint], targets: &[String], effects: &Effects) -> Self {
        let other = convention.other();
        let rigid = Effects { gravity: effects.gravity, ..Effects::default() };
        let what = format!("the table of joints read as {} Denavit-Hartenberg parameters", other.name());
        let as_other = Self::of_one_table(other, joints, targets, &rigid);
        Self::of_one_table(convention, joints, targets, effects).with_other(what, as_other)
    }

    fn of_one_table(
        convention: TableConvention,
        joints: &[SerialJoint],
        targets: &[String],
        effects: &Effects,
    ) -> Self {
        let modified = convention == TableConvention::Modified;
        let mut arm = ArmBuilder::new(targets);
        for (i, j) in joints.iter().enumerate() {
            let n = i + 1;
            let [alpha_means, a_means] = if modified { BEFORE } else { BEHIND };
            let alpha = arm.parameter(format!("alpha_{n}"), Quantity::Angle, j.alpha_rad, alpha_means);
            let a = arm.parameter(format!("a_{n}"), Quantity::Length, j.a_mm, a_means);
            let theta = arm.parameter(format!("theta_{n}"), Quantity::Angle, j.theta_rad, THETA);
            let beta_or_d = match j.parallel {
                true => arm.parameter(format!("beta_{n}"), Quantity::Angle, 0.0, BETA),
                false => arm.parameter(format!("d_{n}"), Quantity::Length, j.d_mm, D),
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
            let drive = Drive::of_number(n, j.prismatic);
            let (fixed, offset): (f64, &[usize]) = if j.parallel { (j.d_mm, &[]) } else { (0.0, &[beta_or_d]) };
            arm.push(Motion::Turn(2), 0.0, &[theta]);
            if j.prismatic {
                arm.push(Motion::Shift(2), fixed, offset);
                arm.drive(drive, true);
            } else {
                arm.drive(drive, false);
                arm.push(Motion::Shift(2), fixed, offset);
                arm.frame();
            }
            if !modified {
                link(&mut arm);
            }
        }
        arm.finish(joints.iter().map(|j| j.prismatic), effects)
    }

    /// An arm of screw axes with `targets` on its flange, whose pose in the base at zero joints is `home`. Each axis has its own small
    /// errors in the base, two rotations and, where it turns, two translations.
    fn of_screws(screws: &[Screw], home: &Pose, targets: &[String], effects: &Effects) -> Self {
        let mut arm = ArmBuilder::new(targets);
        for (i, screw) in screws.iter().enumerate() {
            let at = Pose { translation_mm: screw.point_mm, ..Pose::identity() };
            arm.place(at);
            let errors = arm.screw(screw.direction, Drive::of_number(i + 1, screw.prismatic), false);
            errors.iter().rev().for_each(|error| arm.push_back(error));
            arm.place(at.inverse());
        }
        arm.place(*home);
        arm.finish(screws.iter().map(|s| s.prismatic), effects)
    }
}

impl Drive {
    /// Of joint q`number`.
    fn of_number(number: usize, prismatic: bool) -> Self {
        Self {
            label: number.to_string(),
            name: format!("q{number}"),
            joint: number - 1,
            factor: 1.0,
            offset: 0.0,
            prismatic,
        }
    }
}
