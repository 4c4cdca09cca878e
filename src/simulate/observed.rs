//! What the truth has observed: rows of a table of observations, by kind, and the fixed things that they refer to.

use super::Truth;
use etalon_base::message::{Message, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_campaign::{Selection, StatedPoses};
use etalon_identify::{Fixture, Surface};
use etalon_robots::Robot;
use schemars::JsonSchema;
use serde::Deserialize;

/// Axes of the world.
const AXES: [&str; 3] = ["x", "y", "z"];

/// An `[[observe]]` of a truth: one row at each of its poses and in each round. Keys are the columns of the table.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Observe {
    /// `point`, `pose`, `distance`, `contact`, `plane`, `line`, `sphere` or `joints`.
    pub kind: String,
    /// The target; `joints` need none.
    #[serde(default)]
    pub target: String,
    /// The poses, e.g. `"1-20"`; all of them if absent.
    pub poses: Option<StatedPoses>,
    /// What the kind refers to, or what a row without a pose is about.
    #[serde(flatten)]
    pub to: To,
    /// Of a `point`: the coordinates that are measured, e.g. `"z"` for a dial gauge; all if absent.
    pub coordinates: Option<String>,
    /// Standard uncertainty of a length, written into the row; that of the instrument if absent.
    pub u_um: Option<f64>,
    /// Standard uncertainty of an angle, written into the row; that of the instrument if absent.
    pub urot_deg: Option<f64>,
}

/// A `[[known]]` of a truth: one row without a pose, about fixed things alone.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stated {
    /// `point`, `distance`, `plane`, `line` or `sphere`.
    pub kind: String,
    /// Name of the fixed point, or of the place on a surface.
    pub target: String,
    /// What it refers to.
    #[serde(flatten)]
    pub to: To,
    /// About where the place on a surface is; the truth brings it there.
    pub near_mm: Option<Vector>,
    /// Standard uncertainty, written into the row.
    pub u_um: f64,
}

/// Names of what a row refers to.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
pub struct To {
    /// The point that a distance leads to.
    pub other: Option<String>,
    /// The socket of a contact.
    pub socket: Option<String>,
    /// A plane.
    pub plane: Option<String>,
    /// A line.
    pub line_name: Option<String>,
    /// A sphere.
    pub sphere: Option<String>,
    /// The station that measures a point.
    pub station: Option<String>,
    /// A joint.
    pub joint: Option<String>,
    /// The axis of the world nearest to the normal of a plane, or to a line.
    pub axis: Option<String>,
    /// How far the target is from a plane or sphere.
    pub offset_mm: Option<f64>,
}

/// What a row is about, with the first parameters of what it refers to.
#[derive(Clone, Copy, Debug)]
pub(super) enum What {
    /// Those coordinates of the target.
    Point([bool; 3]),
    /// The same in the frame of a station.
    Station(usize),
    /// Position and orientation of the body, whose mounting this is.
    Body(usize),
    /// Distance to a point.
    Distance(usize),
    /// The target is in a socket.
    Contact(usize),
    /// The target is on a surface, that far from it.
    On(Surface, [usize; 4], f64),
    /// The value of a joint.
    Joint(usize),
    /// The radius of a sphere.
    Radius(usize),
}

impl What {
    /// Whether it says where the target is, so that joints follow from it.
    pub(super) fn constrains(&self) -> bool {
        matches!(self, Self::Contact(_) | Self::On(..))
    }
}

/// An `[[observe]]` as it is simulated.
#[derive(Debug)]
pub(super) struct Item<'a> {
    pub stated: &'a Observe,
    pub what: What,
    /// Index of the target.
    pub target: usize,
    poses: Option<Selection>,
}

impl Item<'_> {
    /// Whether it is observed at a pose.
    pub(super) fn is_at(&self, pose: i64) -> bool {
        self.poses.as_ref().is_none_or(|poses| poses.contains(PoseName::from(pose), pose as usize - 1, false))
    }
}

/// The targets that the truth observes, each once.
pub(super) fn targets(truth: &Truth) -> Vec<String> {
    let mut targets: Vec<String> = Vec::new();
    for observe in &truth.observe {
        if !observe.target.is_empty() && !targets.contains(&observe.target) {
            targets.push(observe.target.clone());
        }
    }
    targets
}

/// What `truth` observes at poses; what that refers to is added to the parameters of `robot`.
///
/// # Errors
/// Kinds, targets and joints that there are not, and kinds that lack what they refer to.
pub(super) fn items<'a>(truth: &'a Truth, robot: &mut dyn Robot) -> Result<Vec<Item<'a>>> {
    let world = world_station(truth)?;
    let mut items = Vec::new();
    for (number, stated) in (1..).zip(&truth.observe) {
        let item = (|| {
            let what = stated.to.what(&stated.kind, &stated.target, stated.coordinates.as_deref(), &world, robot)?;
            let target = match (robot.targets().iter().position(|t| *t == stated.target), what) {
                (Some(target), _) => target,
                (None, What::Joint(_)) if stated.target.is_empty() => 0,
                _ => return Err(Message::error(format!("`{}` is not a target of this robot", stated.target))),
            };
            let poses = stated.poses.as_ref().map(Selection::parse).transpose()?;
            Ok(Item { stated, what, target, poses })
        })();
        items.push(item.map_err(|m| within("observe", number, m))?);
    }
    Ok(items)
}

/// What `truth` states of fixed things, and the first parameter of the point that each is about.
pub(super) fn known<'a>(truth: &'a Truth, robot: &mut dyn Robot) -> Result<Vec<(&'a Stated, What, usize)>> {
    let world = world_station(truth)?;
    let mut known = Vec::new();
    for (number, stated) in (1..).zip(&truth.known) {
        let of = (|| match (stated.kind.as_str(), stated.near_mm) {
            ("sphere", None) => Ok((What::Radius(Fixture::Radius(&stated.target).add_to(robot)), 0)),
            ("plane" | "line" | "sphere", Some(_)) => {
                Ok((stated.to.what(&stated.kind, &stated.target, None, &world, robot)?, 0))
            }
            ("plane" | "line", None) => Err(Message::error(format!("a place on a {} needs `near_mm`", stated.kind))),
            ("point" | "distance", None) => {
                let point = Fixture::Point(&stated.target).add_to(robot);
                Ok((stated.to.what(&stated.kind, &stated.target, None, &world, robot)?, point))
            }
            ("point" | "distance", Some(_)) => Err(Message::error("`near_mm` is for places on surfaces")),
            (kind, _) => Err(Message::error(format!("a row of kind `{kind}` has no [[known]]"))
                .expected("`point`, `distance`, `plane`, `line` or `sphere`")),
        })();
        let (what, point) = of.map_err(|m| within("known", number, m))?;
        known.push((stated, what, point));
    }
    Ok(known)
}

/// The station whose frame is the world, as the table will be read: none where something is measured without a station, or else the first.
fn world_station(truth: &Truth) -> Result<String> {
    let measured = truth.observe.iter().filter(|o| matches!(o.kind.as_str(), "point" | "pose"));
    let fixed = truth.known.iter().filter(|k| k.kind == "point" || k.near_mm.is_some());
    let without = measured.clone().any(|o| o.to.station.is_none()) || fixed.clone().any(|k| k.to.station.is_none());
    let mut first: Option<(usize, &Observe)> = None;
    for observe in measured {
        let poses = observe.poses.as_ref().map(Selection::parse).transpose()?;
        let holds = |pose: &usize| {
            poses.as_ref().is_none_or(|poses| poses.contains(PoseName::from(*pose as i64 + 1), *pose, false))
        };
        let pose = (0..truth.pose_count()).find(holds).unwrap_or(usize::MAX);
        if first.is_none_or(|(earlier, _)| pose < earlier) {
            first = Some((pose, observe));
        }
    }
    let station = first.map(|(_, observe)| &observe.to.station).or_else(|| fixed.map(|k| &k.to.station).next());
    Ok(station.cloned().flatten().filter(|_| !without).unwrap_or_default())
}

fn within(table: &str, number: usize, message: Message) -> Message {
    Message { what: format!("[[{table}]] {number}: {}", message.what), ..message }
}

impl To {
    /// What a row of this kind is about.
    fn what(
        &self,
        kind: &str,
        target: &str,
        coordinates: Option<&str>,
        world: &str,
        robot: &mut dyn Robot,
    ) -> std::result::Result<What, Message> {
        let named = |key: &str, name: &'_ Option<String>| {
            name.clone().ok_or_else(|| Message::error(format!("a `{kind}` needs `{key}`")))
        };
        if coordinates.is_some() && (kind != "point" || self.station.is_some()) {
            return Err(Message::error("`coordinates` is for kind `point` without a station"));
        }
        Ok(match kind {
            "point" => match &self.station {
                Some(name) if name != world => What::Station(Fixture::Station(name).add_to(robot)),
                _ => What::Point(which(coordinates.unwrap_or("xyz"))?),
            },
            "pose" => What::Body(Fixture::Mounting(target).add_to(robot)),
            "distance" => What::Distance(Fixture::Point(&named("other", &self.other)?).add_to(robot)),
            "contact" => What::Contact(Fixture::Point(&named("socket", &self.socket)?).add_to(robot)),
            "sphere" => {
                let name = named("sphere", &self.sphere)?;
                let first = Fixture::Point(&name).add_to(robot);
                let radius = Fixture::Radius(&name).add_to(robot);
                What::On(Surface::Sphere, [first, first + 1, first + 2, radius], self.offset_mm.unwrap_or(0.0))
            }
            "plane" => {
                let (name, axis) = (named("plane", &self.plane)?, self.axis(kind)?);
                let first = Fixture::Plane(&name, axis).add_to(robot);
                let unknowns = [first, first + 1, first + 2, first + 2];
                What::On(Surface::Plane { axis }, unknowns, self.offset_mm.unwrap_or(0.0))
            }
            "line" => {
                let (name, axis) = (named("line_name", &self.line_name)?, self.axis(kind)?);
                let first = Fixture::Line(&name, axis).add_to(robot);
                What::On(Surface::Line { axis }, [first, first + 1, first + 2, first + 3], 0.0)
            }
            "joints" => {
                let name = named("joint", &self.joint)?;
                let joints = || robot.joints().iter().map(|joint| joint.name.as_str());
                let unknown = || Message::error(format!("`{name}` is not a joint of this robot"));
                let joint = joints().position(|joint| joint == name);
                What::Joint(joint.ok_or_else(|| unknown().hint_names(&name, joints()))?)
            }
            _ => {
                let kinds = ["point", "pose", "distance", "contact", "plane", "line", "sphere", "joints"];
                let message = Message::error(format!("`{kind}` is not a kind of observation"));
                return Err(message.hint_names(kind, kinds));
            }
        })
    }

    fn axis(&self, kind: &str) -> std::result::Result<usize, Message> {
        let stated = AXES.iter().position(|axis| self.axis.as_deref() == Some(axis));
        stated.ok_or_else(|| Message::error(format!("a `{kind}` needs `axis`")).expected("\"x\", \"y\" or \"z\""))
    }
}

/// The coordinates that a text names.
fn which(text: &str) -> std::result::Result<[bool; 3], Message> {
    let known = text.chars().all(|c| "xyz".contains(c)) && !text.is_empty();
    let wrong = || Message::error(format!("`{text}` does not name coordinates")).expected("\"z\", \"xy\" ..");
    if known { Ok(["x", "y", "z"].map(|axis| text.contains(axis))) } else { Err(wrong()) }
}
