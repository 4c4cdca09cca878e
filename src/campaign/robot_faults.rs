//! Messages for faults in the description of a robot.

use etalon_base::message::Message;
use etalon_robots::{FaultKind, JointFault, JointRef, TreeFault};

/// Message for a fault. `spellings` spells a key with its units, the spelling of the file first;
/// `file` is the file with links and joints.
pub(super) fn message(fault: &FaultKind, spellings: &dyn Fn(&str) -> Vec<String>, file: &str) -> Message {
    use FaultKind as Kind;
    let spelled = |key: &str| spellings(key).swap_remove(0);
    match fault {
        Kind::NoTarget => Message::error("a robot in space needs at least one target")
            .hint("name them in `targets` of the campaign, or in a column `target` of the table"),
        Kind::TargetCalledBase => {
            Message::error("no target can be called `base`: its parameters would be those of the robot's base")
                .hint("give the target another name in label or columns")
        }
        Kind::NotPositive(key) => Message::error(format!("`{}` must be positive", spelled(key))),
        Kind::Missing(key) => {
            let message = Message::error(format!("the key `{}` is missing in `joint`", spelled(key)));
            if *key == "direction" { message.expected("a direction in the base, e.g. [0, 0, 1]") } else { message }
        }
        Kind::StatedTwice(key) => {
            let both = spellings(key).join("` and `");
            Message::error(format!("`{both}` state the same: leave one of them out"))
        }
        Kind::LegCount(count) => Message::error(format!("a hexapod has six legs, the file states {count}"))
            .hint("add one [[leg]] with base_mm and platform_mm per leg"),
        Kind::SingularHome => {
            Message::error("the hexapod is singular at its home pose: six leg lengths do not hold it there")
                .hint("check `base_mm` and `platform_mm`, or state another home pose")
        }
        Kind::NoJoints => Message::error("a serial arm needs its joints")
            .hint("add one [[joint]] with alpha_deg, a_mm, theta_deg, d_mm per joint, from the base"),
        Kind::GravityWithoutDirection => {
            Message::error("`gravity` has no direction").expected("a direction in the base, e.g. [0, 0, -1]")
        }
        Kind::Joint { what, joints } => joint(what, joints),
        Kind::NotDenavitHartenberg(key) => {
            Message::error(format!("`{}` is not a Denavit-Hartenberg parameter", spelled(key)))
                .hint("it belongs to `convention = \"poe\"`")
        }
        Kind::NotScrew => Message::error("a screw axis has neither Denavit-Hartenberg parameters nor `parallel`")
            .hint("state `direction` and `point_mm`"),
        Kind::AxisWithoutDirection => {
            Message::error("the axis of the joint has no direction").expected("a direction in the base, e.g. [0, 0, 1]")
        }
        Kind::NoFlange(key) => Message::error(format!(
            "screw axes need the pose of the flange at zero joints: the key `{}` is missing",
            spelled(key)
        )),
        Kind::FlangeOfTable(key) => {
            Message::error(format!("`{}` means nothing for Denavit-Hartenberg parameters", spelled(key)))
                .hint("it belongs to `convention = \"poe\"`")
        }
        Kind::RangeOfOtherMotion { key, own } => {
            let motion = if *own == "travel" { "slides" } else { "turns" };
            Message::error(format!("`{}` is not a key of a joint that {motion}", spelled(key)))
                .hint(format!("state `{}`", spelled(own)))
        }
        Kind::NoRange { key, ends: [lower, upper] } => {
            let outward = |v: &f64| if *key == "limits" { v.to_degrees() } else { *v };
            let what = format!("`{}` is not a range: {} to {}", spelled(key), outward(lower), outward(upper));
            Message::error(what).expected("the smaller limit, then the larger one")
        }
        Kind::Tree(fault) => tree(fault, file),
    }
}

fn joint(fault: &JointFault, joints: &[String]) -> Message {
    let what = match fault {
        JointFault::Unknown(JointRef::Number(number)) => format!("there is no joint {number}"),
        JointFault::Unknown(JointRef::Name(name)) => format!("there is no joint `{name}`"),
        JointFault::Slides(j) => format!("joint {} slides: it has no turn", joints[*j]),
        JointFault::Twice(j) => format!("joint {} is there twice", j + 1),
        JointFault::WithItself(j) => format!("joint {} is coupled with itself: that is its gain", j + 1),
        JointFault::PairTwice(j, by) => format!("the pair {}, {} is there twice", j + 1, by + 1),
    };
    Message::error(what)
        .expected(format!("joints from 1 to {}, each once", joints.len()))
        .hint(format!("the joints are {}", joints.join(", ")))
}

fn tree(fault: &TreeFault, file: &str) -> Message {
    use TreeFault as Tree;
    match fault {
        Tree::Kind { joint, kind } => {
            Message::error(format!("joint `{joint}` is {kind}, which is not a joint of a chain"))
                .expected("fixed, revolute, continuous or prismatic")
        }
        Tree::NoDirection(joint) => Message::error(format!("the axis of joint `{joint}` has no direction"))
            .expected("<axis xyz=\"0 0 1\"/> or another direction"),
        Tree::FarOrigin { joint, away_mm } => {
            Message::error(format!("the origin of joint `{joint}` is {:.0} m from its parent", away_mm / 1000.0))
                .hint("lengths of a URDF are metres: divide those of this file by 1000")
        }
        Tree::TwoParents { link, parents: [first, second] } => {
            Message::error(format!("link `{link}` has two parents: `{first}` and `{second}`"))
                .hint("a URDF is a tree: loops are closed by `mimic`")
        }
        Tree::Loop(link) => Message::error(format!("the joints from `{link}` on form a loop"))
            .hint("a URDF is a tree: loops are closed by `mimic`"),
        Tree::NoLink { link, links } => {
            Message::error(format!("`{file}` has no link `{link}`")).hint_names(link, links.iter().map(String::as_str))
        }
        Tree::NoPath { from, to, root } => {
            Message::error(format!("no joints lead from `{from}` to `{to}`")).hint(format!("no joint carries `{root}`"))
        }
        Tree::MimicsUnknown { joint, mimics, joints } => {
            Message::error(format!("joint `{joint}` mimics `{mimics}`, which the file does not have"))
                .hint_names(mimics, joints.iter().map(String::as_str))
        }
        Tree::MimicsItself(joint) => {
            Message::error(format!("joint `{joint}` mimics itself")).hint("name another joint in <mimic>")
        }
        Tree::NothingMoves { from, to } => Message::error(format!("no joint moves between `{from}` and `{to}`")),
        Tree::NoMovingJoint => Message::error("no joint of the file moves"),
        Tree::BendsOnMovingBase(link) => {
            Message::error(format!("`bending` needs a fixed direction of gravity, and joints move `{link}`"))
                .hint("remove it, or let `base_link` be a link that does not move")
        }
        Tree::NoMass(joint) => Message::error(format!("no mass is stated beyond joint `{joint}`: nothing bends it"))
            .hint("add <inertial> to its links"),
        Tree::DoubledName(name) => Message::error(format!("two parameters would be called `{name}`"))
            .hint("no target can bear the name of a joint: rename the target"),
    }
}
