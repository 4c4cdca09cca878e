//! The keys of `robot.toml`, and the robot they describe.

use super::toml_file::{self, Recovered, UnreadKeys};
use crate::base::message::{Message, Place, Problems, Result};
use crate::math::robots::{FiveBar, Limits, Parameter, Prexyt, Quantity, Robot, Role, Serial, SerialJoint};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Axes whose twist is below this are near-parallel: d is replaced by Hayati's beta (3 degrees).
const NEAR_PARALLEL_RAD: f64 = 0.052;

/// `robot.toml`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobotFile {
    /// Name of the robot, for the report and for `etalon compare`.
    pub name: Option<String>,
    /// The kinematic model.
    pub model: Model,
    /// Nominal parameters by name, in mm, deg or without unit. The geometry of the robot must be stated; other parameters
    /// have the values of the model.
    #[serde(default)]
    pub nominal: BTreeMap<String, f64>,
    /// Joints of a serial arm, from the base.
    #[serde(default, rename = "joint")]
    pub joints: Vec<JointDefinition>,
    /// Direction of gravity in the base of a serial arm.
    #[serde(default = "down")]
    pub gravity: [f64; 3],
    /// Numbers of the joints of a serial arm that bend under gravity, from 1.
    #[serde(default)]
    pub bending: Vec<usize>,
    /// Coupled joints of a serial arm: pairs of a joint and the joint that moves it, from 1.
    #[serde(default)]
    pub coupling: Vec<(usize, usize)>,
    /// Limits of a PreXYT or a five-bar.
    #[serde(default)]
    pub reach: ReachDefinition,
    /// Rotation about the y axis of the world before base_rx, base_ry and base_rz of a serial arm.
    #[serde(default)]
    pub base_turn_y_deg: f64,
    /// The file as the user named it, and its text.
    #[serde(skip)]
    source: (String, String),
    /// What of the file did not read.
    #[serde(skip)]
    unread: UnreadKeys,
    /// It only stands for a file that does not read.
    #[serde(skip)]
    unreadable: bool,
}

fn down() -> [f64; 3] {
    [0.0, 0.0, -1.0]
}

/// A kinematic model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Model {
    /// PreXYT with 13 parameters.
    Prexyt,
    /// PreXYT before the reduction of section 3.4.
    PrexytFull,
    /// Five-bar with 12 parameters.
    FiveBar,
    /// Serial arm.
    Serial,
}

/// Limits of a robot: `travel_mm` of a PreXYT, the others of a five-bar. A limit that is not stated does not apply.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReachDefinition {
    /// Smallest and largest encoder angle of joint 1.
    pub theta1_deg: Option<[f64; 2]>,
    /// Smallest and largest encoder angle of joint 2.
    pub theta2_deg: Option<[f64; 2]>,
    /// Smallest distance between the proximal link of one arm and the distal link of the other; 0 excludes that they cross.
    pub clearance_mm: Option<f64>,
    /// Smallest angle of an arm from being stretched or folded (type 1 singularity).
    pub type1_margin_deg: Option<f64>,
    /// Smallest angle of the distal links from being in line (type 2 singularity).
    pub type2_margin_deg: Option<f64>,
    /// Travel of each actuator from zero.
    pub travel_mm: Option<[f64; 3]>,
}

impl ReachDefinition {
    fn build(&self) -> Limits {
        let none = Limits::default();
        let limits = |given: Option<[f64; 2]>, none: [f64; 2]| given.map_or(none, |l| l.map(f64::to_radians));
        Limits {
            limits_rad: [limits(self.theta1_deg, none.limits_rad[0]), limits(self.theta2_deg, none.limits_rad[1])],
            clearance_mm: self.clearance_mm,
            type1_margin_rad: self.type1_margin_deg.map_or(none.type1_margin_rad, f64::to_radians),
            type2_margin_rad: self.type2_margin_deg.map_or(none.type2_margin_rad, f64::to_radians),
        }
    }
}

/// A joint of a serial arm by its nominal modified Denavit-Hartenberg parameters (Craig), from the base.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointDefinition {
    /// Twist of the previous link.
    pub alpha_deg: f64,
    /// Length of the previous link.
    pub a_mm: f64,
    /// Joint offset.
    pub theta_deg: f64,
    /// Link offset.
    pub d_mm: f64,
    /// The joint is prismatic.
    #[serde(default)]
    pub prismatic: bool,
    /// Near-parallel to the previous axis: Hayati's beta replaces d. By default so below 3 degrees of twist.
    pub parallel: Option<bool>,
}

/// Keys that only a serial arm has.
const SERIAL_ONLY: [&str; 5] = ["joint", "gravity", "bending", "coupling", "base_turn_y_deg"];
/// Keys of [reach] that only a five-bar has.
const FIVE_BAR_ONLY: [&str; 5] = ["theta1_deg", "theta2_deg", "clearance_mm", "type1_margin_deg", "type2_margin_deg"];

impl RobotFile {
    /// The robot file that is left when everything that does not fit is taken away, and what that is.
    pub(super) fn recover(name: &str, text: &str) -> (Option<Self>, Problems) {
        let Recovered { value, problems, unread } = toml_file::recover::<Self>(name, text);
        (value.map(|robot| Self { source: (name.to_owned(), text.to_owned()), unread, ..robot }), problems)
    }

    /// Stands for a file that does not read, which is told already: no robot can be built of it.
    pub(super) fn unreadable() -> Self {
        Self {
            name: None,
            model: Model::Prexyt,
            nominal: BTreeMap::new(),
            joints: Vec::new(),
            gravity: down(),
            bending: Vec::new(),
            coupling: Vec::new(),
            reach: ReachDefinition::default(),
            base_turn_y_deg: 0.0,
            source: Default::default(),
            unread: UnreadKeys::default(),
            unreadable: true,
        }
    }

    /// Where the value of a key stands, if it does.
    fn stated(&self, path: &[&str]) -> Option<Place> {
        let (name, text) = &self.source;
        Some(Place::span(name.as_str(), text, toml_file::find(text, path)?))
    }

    /// The place of a key; the file where the key is not there.
    fn place(&self, path: &[&str]) -> Place {
        self.stated(path).unwrap_or_else(|| Place::file(self.source.0.as_str()))
    }

    /// The robot with these targets (serial arms; others have their own).
    pub fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>> {
        // what did not read is told already
        let stray = ["alpha_deg", "a_mm", "theta_deg", "d_mm"].iter().any(|key| self.unread.affects(&[key]));
        if self.unreadable || self.unread.affects_entry("model") || self.unread.affects_entry("joint") || stray {
            return Err(Problems::default());
        }
        let mut problems = self.odd_keys();
        let robot = match self.model {
            Model::Prexyt | Model::PrexytFull => {
                let robot = Prexyt::new(self.model == Model::PrexytFull);
                let robot = match self.reach.travel_mm {
                    Some(travel_mm) => robot.with_travel(travel_mm),
                    None => robot,
                };
                self.nominal_of(&robot).map(|nominal| Box::new(robot.with_nominal(&nominal)) as Box<dyn Robot>)
            }
            Model::FiveBar => {
                let robot = FiveBar::default().with_limits(self.reach.build());
                self.nominal_of(&robot).map(|nominal| Box::new(robot.with_nominal(&nominal)) as Box<dyn Robot>)
            }
            Model::Serial => self.serial(targets).and_then(|robot| {
                let nominal = self.nominal_of(&robot)?;
                Ok(Box::new(robot.with_nominal(&nominal)) as Box<dyn Robot>)
            }),
        };
        robot.map_err(|more| problems.0.extend(more.0)).ok().filter(|_| problems.0.is_empty()).ok_or(problems)
    }

    /// Errors about keys that only another model has.
    fn odd_keys(&self) -> Problems {
        let own = match self.model {
            Model::Serial => "serial",
            Model::FiveBar => "five_bar",
            Model::Prexyt | Model::PrexytFull => "prexyt",
        };
        let serial = SERIAL_ONLY.iter().map(|key| (vec![*key], "serial"));
        let five_bar = FIVE_BAR_ONLY.iter().map(|key| (vec!["reach", *key], "five_bar"));
        let keys = serial.chain(five_bar).chain([(vec!["reach", "travel_mm"], "prexyt")]);
        let odd = |(path, model): (Vec<&str>, &str)| {
            let message = Message::error(format!("`{}` means nothing for this model", path.last()?));
            Some(message.at(self.stated(&path)?).hint(format!("it belongs to `model = \"{model}\"`")))
        };
        Problems(keys.filter(|(_, model)| *model != own).filter_map(odd).collect())
    }

    fn serial(&self, targets: &[String]) -> Result<Serial> {
        let n = self.joints.len();
        if n == 0 {
            return Err(Message::error("a serial arm needs its joints")
                .at(self.place(&["joint"]))
                .hint("add one [[joint]] with alpha_deg, a_mm, theta_deg, d_mm per joint, from the base")
                .into());
        }
        let mut problems = Problems::default();
        let mut wrong = |key: &str, i: usize, what: String| {
            let message = Message::error(what).at(self.place(&[key, &i.to_string()]));
            problems.0.push(message.expected(format!("joints from 1 to {n}, each once")));
        };
        for (i, &j) in self.bending.iter().enumerate() {
            if j == 0 || j > n {
                wrong("bending", i, format!("there is no joint {j}"));
            } else if self.bending[..i].contains(&j) {
                wrong("bending", i, format!("joint {j} is there twice"));
            }
        }
        for (i, pair) in self.coupling.iter().enumerate() {
            if let Some(j) = [pair.0, pair.1].into_iter().find(|&j| j == 0 || j > n) {
                wrong("coupling", i, format!("there is no joint {j}"));
            } else if pair.0 == pair.1 {
                wrong("coupling", i, format!("joint {} is coupled with itself: that is its gain", pair.0));
            } else if self.coupling[..i].contains(pair) {
                wrong("coupling", i, format!("the pair {}, {} is there twice", pair.0, pair.1));
            }
        }
        if targets.is_empty() {
            problems.0.push(Message::error("a serial arm needs at least one target").hint("name them in `targets`"));
        }
        if targets.iter().any(|target| target == "base") {
            let what = "no target can be called `base`: its parameters would be those of the robot's base";
            problems.0.push(Message::error(what).hint("give the target another name in label or columns"));
        }
        problems.check()?;
        let joints: Vec<SerialJoint> = self
            .joints
            .iter()
            .enumerate()
            .map(|(i, j)| {
                let alpha_rad = j.alpha_deg.to_radians();
                let near = i > 0 && alpha_rad.sin().abs() < NEAR_PARALLEL_RAD && !j.prismatic;
                SerialJoint {
                    alpha_rad,
                    a_mm: j.a_mm,
                    theta_rad: j.theta_deg.to_radians(),
                    d_mm: j.d_mm,
                    prismatic: j.prismatic,
                    parallel: j.parallel.unwrap_or(near),
                }
            })
            .collect();
        let gravity = crate::base::pose::unit(self.gravity).ok_or_else(|| {
            Message::error("`gravity` has no direction")
                .at(self.place(&["gravity"]))
                .expected("a direction in the base, e.g. [0, 0, -1]")
        })?;
        let serial = Serial::new(&joints, targets, gravity, &self.bending, &self.coupling);
        Ok(serial.with_base_turn_y(self.base_turn_y_deg.to_radians()))
    }

    /// Nominal values of `robot` with those of the file in their places.
    fn nominal_of(&self, robot: &dyn Robot) -> Result<Vec<f64>> {
        let mut values = robot.nominal();
        let mut problems = Problems::default();
        for (name, value) in &self.nominal {
            let Some(i) = robot.index(name) else {
                let names = robot.parameters().iter().map(|p| p.name.as_str());
                let what = format!("[nominal] names `{name}`, which is not a parameter of this robot");
                problems.0.push(Message::error(what).at(self.place(&["nominal", name])).hint_names(name, names));
                continue;
            };
            values[i] = robot.parameters()[i].quantity.inward(*value);
        }
        problems.0.extend(self.unstated(robot));
        problems.check()?;
        Ok(values)
    }

    /// An error about geometry that the file does not state: the model's own is that of one machine, not of this one.
    fn unstated(&self, robot: &dyn Robot) -> Option<Message> {
        // an arm states its geometry joint by joint
        if self.model == Model::Serial || self.unread.contains(&["nominal".to_owned()]) {
            return None;
        }
        let own = |p: &&Parameter| p.role == Role::Robot && p.quantity != Quantity::Ratio && p.nominal != 0.0;
        let names: Vec<&str> = robot.parameters().iter().filter(own).map(|p| p.name.as_str()).collect();
        let names =
            names.into_iter().filter(|n| !self.nominal.contains_key(*n) && !self.unread.affects(&["nominal", n]));
        let names: Vec<String> = names.map(|n| format!("`{n}`")).collect();
        if names.is_empty() {
            return None;
        }
        let what = format!("[nominal] does not state {}", names.join(", "));
        let message = Message::error(what).at(self.place(&["nominal"]));
        Some(message.hint("state the geometry of your machine as it is drawn, in mm: it is never guessed"))
    }
}
