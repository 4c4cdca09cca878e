//! Robots whose geometry is published, and robots of URDF files, as robot.toml.

use etalon_base::message::{Message, Result, nearest};
use etalon_base::{error, phrase, warning};
use etalon_campaign::{parse, read_urdf, read_urdf_chains};
use etalon_robots::{PUBLISHED, PublishedArm, TreeChain};
use serde::Deserialize;
use std::fmt::Write;
use std::path::Path;

const ROBOTS: &str = include_str!("known_robots.toml");

/// Reads the table of robots.
fn table() -> Result<Known> {
    parse("robots.toml", ROBOTS, &true.into())
}

/// Names of the robots of the table.
///
/// # Errors
/// Fails if the table is invalid.
pub fn known_names() -> Result<Vec<String>> {
    let Known { robots } = table()?;
    Ok(robots.into_iter().map(|robot| robot.name).collect())
}

/// The robot.toml of a robot of the table.
///
/// # Errors
/// Fails for an unknown name.
pub fn known_text(name: &str) -> Result<String> {
    Ok(known_robot(name)?.text())
}

/// The chain of a URDF file with the most moving joints, and a warning if it ends at one of several
/// links that move on their own, such as the fingers of a gripper.
///
/// # Errors
/// Fails for a file that cannot be read, and without a moving joint.
pub fn default_chain(path: &Path) -> Result<(TreeChain, Option<Message>)> {
    let (chain, _) = read_urdf(path)?;
    let (chains, _) = read_urdf_chains(path)?;
    let is_part = |other: &&TreeChain| {
        other.joints.len() < chain.joints.len() && other.joints.iter().zip(&chain.joints).all(|(a, b)| a.name == b.name)
    };
    let rivals: Vec<&TreeChain> =
        chains.iter().filter(|other| other.is_end && other.tool_link != chain.tool_link && !is_part(other)).collect();
    // the link that carries all of them
    let common = chains.iter().filter(is_part).max_by_key(|part| part.joints.len());
    let message = rivals.first().map(|rival| {
        let (base, tool, count) = (chain.base_link.as_str(), chain.tool_link.as_str(), chain.joints.len());
        let others: Vec<String> = rivals.iter().map(|rival| format!("`{}`", rival.tool_link)).collect();
        let other = common.unwrap_or(rival).tool_link.as_str();
        warning!("urdf-chain-chosen", base, tool, count, others, other)
    });
    Ok((chain, message))
}

/// The robot.toml of a chain of a URDF file.
pub fn urdf_text(file: &str, chain: &TreeChain) -> String {
    let quoted = |text: &str| toml::Value::from(text).to_string();
    format!(
        "model = \"urdf\"\nfile = {}\nbase_link = {}\ntool_link = {:<30} # its frame carries the targets\n\
         # bending = [{}]    # joints that bend under the masses of the URDF\n",
        quoted(file),
        quoted(&chain.base_link),
        quoted(&chain.tool_link),
        quoted(&chain.joints[0].name),
    )
}

/// Returns the robot of this name in the table, in capitals or small letters, with or without
/// hyphens.
pub(crate) fn known_robot(name: &str) -> Result<KnownRobot> {
    let Known { mut robots } = table()?;
    let is_meant = |robot: &KnownRobot| letters(&robot.name) == letters(name);
    let Some(at) = robots.iter().position(is_meant) else {
        let names: Vec<&str> = robots.iter().map(|robot| robot.name.as_str()).collect();
        let message = error!("robot-not-in-table", name, names);
        return Err(match nearest(&name.to_lowercase(), names.iter().copied()) {
            Some(name) => message.hint(phrase!("did-you-mean", name)),
            None => message,
        }
        .into());
    };
    Ok(robots.swap_remove(at))
}

/// Letters and digits of a name, in small letters.
fn letters(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// Robots with known geometry.
#[derive(Deserialize)]
struct Known {
    #[serde(rename = "robot")]
    robots: Vec<KnownRobot>,
}

/// A robot described by a published table of Denavit-Hartenberg parameters, by screw axes, or by
/// the text of its robot.toml.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct KnownRobot {
    pub name: String,
    /// Title; empty for a published table, which has its own.
    #[serde(default)]
    title: String,
    /// Source of the geometry.
    source: String,
    note: Option<String>,
    /// Source of the limits.
    limits_source: Option<String>,
    /// Lower and upper limit of each joint (deg); empty if no source gives it.
    #[serde(default)]
    limits_deg: Vec<Vec<f64>>,
    #[serde(default)]
    poe: Vec<Axis>,
    flange_xyz_mm: Option<[f64; 3]>,
    flange_rpy_deg: Option<[f64; 3]>,
    #[serde(default)]
    joints: Vec<String>,
    #[serde(default)]
    pub targets: Vec<String>,
    #[serde(default)]
    toml: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Axis {
    direction: [f64; 3],
    point_mm: [f64; 3],
}

impl KnownRobot {
    /// Returns the published table of this name.
    fn published(&self) -> Option<PublishedArm> {
        PUBLISHED.into_iter().find(|arm| arm.name == self.name)
    }

    /// Names of the joints' columns.
    pub fn joints(&self) -> Vec<String> {
        let count = self.published().map_or(0, |arm| arm.rows.len()) + self.poe.len();
        if count == 0 { self.joints.clone() } else { (1..=count).map(|i| format!("q{i}_deg")).collect() }
    }

    /// Limits of joint `i` in the text of robot.toml; empty if no source gives them.
    fn limits(&self, i: usize) -> String {
        let stated = self.limits_deg.get(i).filter(|ends| !ends.is_empty());
        stated.map_or_else(String::new, |ends| format!(", limits_deg = {ends:?}"))
    }

    /// Text of robot.toml.
    pub fn text(&self) -> String {
        let published = self.published();
        let title = published.map_or(self.title.as_str(), |arm| arm.title);
        let mut text = format!("# {title}: nominal geometry.\n# Source: {}.\n", self.source);
        text.extend(self.limits_source.iter().map(|source| format!("# Limits: {source}.\n")));
        text.extend(self.note.iter().map(|note| format!("# {note}\n")));
        let _ = writeln!(text, "name = {title:?}");
        if let Some(arm) = published {
            let convention = arm.convention.key();
            let _ = writeln!(text, "model = \"serial\"\nconvention = \"{convention}\"\njoint = [");
            for (i, [alpha, a, theta, d]) in arm.rows.iter().enumerate() {
                let _ = writeln!(
                    text,
                    "    {{ alpha_deg = {alpha:?}, a_mm = {a:?}, theta_deg = {theta:?}, d_mm = {d:?}{} }},",
                    self.limits(i)
                );
            }
        }
        if let (Some(xyz), Some(rpy)) = (self.flange_xyz_mm, self.flange_rpy_deg) {
            let _ = writeln!(
                text,
                "model = \"serial\"\nconvention = \"poe\"                           # axes at zero joints, in the base\n\
                 flange_xyz_mm = {xyz:?}\nflange_rpy_deg = {rpy:?}\njoint = ["
            );
            for (i, Axis { direction, point_mm }) in self.poe.iter().enumerate() {
                let limits = self.limits(i);
                let _ = writeln!(text, "    {{ direction = {direction:?}, point_mm = {point_mm:?}{limits} }},");
            }
        }
        let end = "]\n# bending = [2, 3]                          # joints that bend under gravity\n\
                   # tolerance = { length_mm = 5.0 }           # how far from nominal the arm may be\n";
        text + if self.toml.is_empty() { end } else { self.toml.trim_start() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_as_makers_write_them() {
        for (stated, name) in [("UR5e", "ur5e"), ("IRB 120", "irb120"), ("KR6_R900_sixx", "kr6-r900-sixx")] {
            assert_eq!(known_robot(stated).unwrap().name, name);
        }
    }

    /// The table of docs/robot.md has the limits and their sources.
    #[test]
    fn limits_and_their_sources_are_documented() {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/robot.md");
        let page = std::fs::read_to_string(page).unwrap();
        let ends = |ends: &Vec<f64>| match ends[..] {
            [low, high] if low == -high => format!("±{high}"),
            [low, high] => format!("{low} to {high}"),
            _ => "none".to_owned(),
        };
        let Known { robots } = table().unwrap();
        for robot in robots.iter().filter(|robot| robot.toml.is_empty()) {
            let limits: Vec<String> = robot.limits_deg.iter().map(ends).collect();
            assert_eq!(limits.len(), robot.joints().len(), "{}", robot.name);
            let source = robot.limits_source.as_deref().unwrap_or_default();
            let title = robot.published().map_or(robot.title.as_str(), |arm| arm.title);
            let row = format!("| `{}` | {title} | {} | {source} |\n", robot.name, limits.join(", "));
            assert!(page.contains(&row), "docs/robot.md lacks\n{row}");
        }
    }

    /// Wrist 3 of the smallest arms of Universal Robots turns without end; the others stop after a
    /// turn.
    #[test]
    fn the_wrist_of_the_smallest_arms_has_no_limit() {
        for (name, limited) in [("ur3", 5), ("ur3e", 5), ("ur5", 6), ("ur5e", 6)] {
            assert_eq!(known_text(name).unwrap().matches("limits_deg").count(), limited, "{name}");
        }
    }

    #[test]
    fn the_name_that_is_meant_is_the_hint() {
        let refused = |name: &str| known_robot(name).err().unwrap().0.remove(0);
        assert!(refused("UR5f").hint.is_some_and(|hint| hint.contains("ur5")));
        assert!(refused("UR5f").is("robot-not-in-table", &[("name", &"UR5f")]));
    }
}
