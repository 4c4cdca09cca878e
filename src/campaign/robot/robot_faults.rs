//! Messages for faults in the description of a robot.

use etalon_base::message::Message;
use etalon_base::{error, phrase};
use etalon_robots::{FaultKind, JointFault, JointRef, TreeFault};

/// Message for a fault. `spellings` spells a key with its units, the spelling of the file first;
/// `file` is the file with links and joints.
pub(crate) fn message(fault: &FaultKind, spellings: &dyn Fn(&str) -> Vec<String>, file: &str) -> Message {
    use FaultKind as Kind;
    let spelled = |key: &str| spellings(key).swap_remove(0);
    match fault {
        Kind::NoTarget => error!("no-target"),
        Kind::TargetCalledBase => error!("target-called-base"),
        Kind::NotPositive(key) => error!("key-not-positive", key = spelled(key)),
        Kind::Missing(key) => {
            let message = error!("joint-key-missing", key = spelled(key));
            let example = "[0, 0, 1]";
            if *key == "direction" { message.expected(phrase!("direction-in-base", example)) } else { message }
        }
        Kind::StatedTwice(key) => {
            let keys: Vec<String> = spellings(key).iter().map(|key| format!("`{key}`")).collect();
            error!("keys-state-the-same", keys)
        }
        Kind::AngleUnit { key, angle_rad } => {
            let mut keys = spellings(key);
            let key = keys.remove(0);
            let other = keys.pop().unwrap_or_default();
            let is_rad = key.ends_with("_rad");
            let value = if is_rad { *angle_rad } else { angle_rad.to_degrees() };
            error!("joint-angle-unit", key, value, other, unit = if is_rad { "rad" } else { "deg" })
        }
        Kind::LegCount(count) => error!("leg-count", count),
        Kind::SingularHome => error!("hexapod-singular"),
        Kind::NoJoints => error!("no-joints"),
        Kind::GravityWithoutDirection => error!("gravity-without-direction"),
        Kind::Joint { what, joints } => joint(what, joints),
        Kind::NotDenavitHartenberg(key) => error!("not-denavit-hartenberg", key = spelled(key)),
        Kind::NotScrew => error!("not-screw-axis"),
        Kind::AxisWithoutDirection => error!("joint-axis-without-direction"),
        Kind::NoFlange(key) => error!("flange-missing", key = spelled(key)),
        Kind::FlangeOfTable(key) => error!("flange-of-table", key = spelled(key)),
        Kind::RangeOfOtherMotion { key, own } => {
            let motion = if *own == "travel" { "slides" } else { "turns" };
            error!("range-of-other-motion", key = spelled(key), motion, own = spelled(own))
        }
        Kind::NoRange { key, ends: [lower, upper] } => {
            let outward = |v: &f64| if *key == "limits" { v.to_degrees() } else { *v };
            error!("range-exchanged", key = spelled(key), lower = outward(lower), upper = outward(upper))
        }
        Kind::Tree(fault) => tree(fault, file),
    }
}

fn joint(fault: &JointFault, joints: &[String]) -> Message {
    let (fault, joint) = match fault {
        JointFault::Unknown(JointRef::Number(number)) => ("unknown-number", number.to_string()),
        JointFault::Unknown(JointRef::Name(name)) => ("unknown-name", name.clone()),
        JointFault::Slides(j) => ("slides", joints[*j].clone()),
        JointFault::Twice(j) => ("twice", (j + 1).to_string()),
        JointFault::WithItself(j) => ("itself", (j + 1).to_string()),
        JointFault::PairTwice(j, by) => ("pair", format!("{}, {}", j + 1, by + 1)),
    };
    error!("joint-reference-wrong", fault, joint, count = joints.len(), joints)
}

fn tree(fault: &TreeFault, file: &str) -> Message {
    use TreeFault as Tree;
    match fault {
        Tree::Kind { joint, kind } => error!("urdf-joint-kind", joint, kind),
        Tree::NoDirection(joint) => error!("urdf-axis-without-direction", joint),
        Tree::FarOrigin { joint, away_mm } => error!("urdf-origin-far", joint, away_m = away_mm / 1000.0),
        Tree::TwoParents { link, parents: [first, second] } => error!("urdf-two-parents", link, first, second),
        Tree::Loop(link) => error!("urdf-loop", link),
        Tree::NoLink { link, links } => {
            error!("urdf-link-unknown", file, link).hint_names(link, links.iter().map(String::as_str))
        }
        Tree::NoPath { from, to, root } => error!("urdf-no-path", from, to, root),
        Tree::MimicsUnknown { joint, mimics, joints } => {
            error!("urdf-mimic-unknown", joint, mimics).hint_names(mimics, joints.iter().map(String::as_str))
        }
        Tree::MimicsItself(joint) => error!("urdf-mimics-itself", joint),
        Tree::NothingMoves { from, to } => error!("urdf-nothing-moves", from, to),
        Tree::NoMovingJoint => error!("urdf-no-moving-joint"),
        Tree::BendsOnMovingBase(link) => error!("bending-on-moving-base", link),
        Tree::NoMass(joint) => error!("bending-without-mass", joint),
        Tree::DoubledName(name) => error!("parameter-name-doubled", name),
        Tree::NoToolLink => error!("tool-link-missing"),
        Tree::ToolLinkBesideBranches => error!("tool-link-beside-branches"),
        Tree::TargetOnTwoBranches { target, links: [first, second] } => {
            error!("target-on-two-branches", target, first, second)
        }
        Tree::TargetOnNoBranch { target, known } => {
            error!("target-on-no-branch", target).hint_names(target, known.iter().map(String::as_str))
        }
        Tree::BendsInBranches(joint) => error!("bending-in-branches", joint),
        Tree::PayloadInBranches(joint) => error!("payload-in-branches", joint),
        Tree::ElasticInBranches(key) => error!("elastic-in-branches", key),
        Tree::CoupledAcrossBranches { joint, by, link } => error!("coupling-across-branches", joint, by, link),
    }
}
