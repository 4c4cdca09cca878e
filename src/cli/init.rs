//! Command `etalon init`.

mod branches;
mod from;
mod robot_toml;
mod tool_link;
mod trial;

pub(super) use trial::refusal_of_lines;

use super::{Verdict, next_step, print_written, shell_word};
use etalon_base::files;
use etalon_base::message::Problems;
use etalon_base::{error, phrase};
use etalon_campaign::{parse, read_urdf};
use etalon_robots::{Joint, Quantity, TreeChain};
use schemars::JsonSchema;
use serde::Deserialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Write a commented campaign to start from.
#[derive(Debug, clap::Args)]
pub struct Init {
    /// New folder of the campaign.
    folder: PathBuf,
    /// Add a truth, from which `etalon simulate` writes the exports and logs.
    #[arg(long)]
    synthetic: bool,
    /// Describe the robot by this URDF file: its chain with the most moving joints. The file is
    /// copied beside robot.toml.
    #[arg(long, value_name = "FILE", conflicts_with = "synthetic")]
    urdf: Option<PathBuf>,
    /// Use the published geometry of this robot (ur5e, irb120 ...), an example of a model
    /// (five-bar, xy-theta, hexapod, delta ...), or your own robot.toml.
    ///
    /// A robot.toml is copied into the folder, with the URDF that it names.
    #[arg(long, value_name = "NAME|FILE", conflicts_with_all = ["synthetic", "urdf"])]
    robot: Option<String>,
    /// Propose the whole campaign from these files: exports, logs, tables with both, observations.
    ///
    /// The files are copied into the folder, and `etalon check` asks for what they do not state.
    /// Needs --robot or --urdf.
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with = "synthetic")]
    from: Vec<PathBuf>,
    /// Print the names of the files written as JSON.
    #[arg(long)]
    json: bool,
}

const CAMPAIGN: &str = include_str!("init/campaign.toml");
const ROBOT: &str = include_str!("init/robot.toml");
/// Line of a proposed campaign that its folder names.
const UNTITLED: &str = "name = \"First campaign\"";
const ROBOT_CAMPAIGN: &str = include_str!("init/campaign-robot.toml");
const ROBOTS: &str = include_str!("init/robots.toml");
const TRUTH: &str = include_str!("init/truth.toml");

/// Line of the template, a comment, that states synthetic data.
const SYNTHETIC: &str = "# synthetic = \"how the data were made\"";
const MADE: &str = "synthetic = \"made by `etalon simulate` from truth.toml; nobody measured them\"";

impl Init {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        if !self.from.is_empty() {
            let files = self.described_by(from::campaign(&self.from, self.robot_files()?)?);
            print_written(files::write_new(&self.folder, &files)?, self.json)?;
            let (_, text) = &files[0];
            if !self.json {
                let robot =
                    files.iter().find(|(name, _)| name == "robot.toml").map_or(&[][..], |(_, text)| text.as_slice());
                let [text, robot] = [text.as_slice(), robot].map(String::from_utf8_lossy);
                next_step(self.json, trial::next(&self.folder, &text, &robot));
            }
            return Ok(Verdict::Met);
        }
        if let Some(path) = &self.urdf {
            return self.describe(path);
        }
        if let Some(name) = &self.robot {
            return self.known(name);
        }
        let mut texts = vec![("campaign.toml", CAMPAIGN.into()), ("robot.toml", ROBOT.into())];
        if self.synthetic {
            texts[0].1 = CAMPAIGN.replace(SYNTHETIC, MADE).into_bytes();
            texts.push(("truth.toml", TRUTH.into()));
        }
        self.write(&texts)
    }

    /// Adds the schemas that the first lines name; a campaign is named after its folder.
    fn described_by(&self, mut files: Vec<(String, Vec<u8>)>) -> Vec<(String, Vec<u8>)> {
        let schemas = etalon_campaign::schemas();
        let folder = std::path::absolute(&self.folder).unwrap_or_default();
        let folder = folder.file_name().map(|name| toml::Value::from(&*name.to_string_lossy()).to_string());
        for (name, text) in &mut files {
            if !schemas.iter().any(|(of, _)| of == name) {
                continue;
            }
            let own = String::from_utf8_lossy(text);
            let titled = match &folder {
                Some(folder) if name == "campaign.toml" => own.replacen(UNTITLED, &format!("name = {folder}"), 1),
                _ => own.into_owned(),
            };
            *text = format!("#:schema ./{}\n{titled}", schema_file(name)).into_bytes();
        }
        files.extend(schemas.iter().map(|(name, text)| (schema_file(name), text.clone().into_bytes())));
        files
    }

    /// Writes the files, and says what comes next.
    fn write(&self, texts: &[(&str, Vec<u8>)]) -> anyhow::Result<Verdict> {
        let texts = texts.iter().map(|(name, text)| ((*name).to_owned(), text.clone())).collect();
        let all = self.described_by(texts);
        print_written(files::write_new(&self.folder, &all)?, self.json)?;
        let folder = shell_word(&self.folder);
        match self.synthetic {
            true => next_step(self.json, phrase!("next-simulate", command = format!("`etalon simulate {folder}`"))),
            false => {
                let command = format!("`etalon check {folder}`");
                next_step(self.json, phrase!("next-copy", folder, command));
            }
        }
        Ok(Verdict::Met)
    }

    /// The robot of a campaign from files.
    fn robot_files(&self) -> anyhow::Result<from::RobotFiles> {
        if let Some(path) = &self.urdf {
            let described = tool_link::described(path, &self.from)?;
            let Described { name, robot, text, joints, targets } = described;
            let files = vec![("robot.toml".to_owned(), robot), (name, text)];
            let controllers = "[\"json\", \"urdf\"]";
            let path = path.with_file_name("robot.toml");
            return Ok(from::RobotFiles { files, path, joints, targets, controllers, own: None });
        }
        let Some(name) = &self.robot else {
            return Err(Problems::from(error!("from-needs-robot")).into());
        };
        if let Some(path) = robot_toml::path(name) {
            return robot_toml::robot_files(&path);
        }
        let robot = known_robot(name)?;
        let files = vec![("robot.toml".to_owned(), robot.text().into_bytes())];
        let (joints, targets) = (robot.joints(), robot.targets.clone());
        // the format of its calibration for ROS
        let controllers = if name.starts_with("ur") { "[\"json\", \"universal-robots\"]" } else { "[\"json\"]" };
        let path = "robot.toml".into();
        Ok(from::RobotFiles { files, path, joints, targets, controllers, own: None })
    }

    /// A campaign of the robot of a URDF file.
    fn describe(&self, path: &Path) -> anyhow::Result<Verdict> {
        let Described { name, robot, text, joints, .. } = described(path)?;
        let quoted = |text: &str| toml::Value::from(text).to_string();
        let column = |key: &String| {
            let joint = key.rsplit_once('_').map_or(key.as_str(), |(joint, _)| joint);
            format!("{} = {}\n", quoted(key), quoted(joint))
        };
        let columns: String = joints.iter().map(column).collect();
        let texts = [
            ("campaign.toml", campaign("[\"json\", \"urdf\"]", &columns, &SMRS)),
            ("robot.toml", robot),
            (name.as_str(), text),
        ];
        self.write(&texts)
    }

    /// A campaign for a robot of the user's robot.toml.
    fn with_robot_file(&self, robot: from::RobotFiles) -> anyhow::Result<Verdict> {
        let column = |key: &String| {
            let joint = key.rsplit_once('_').map_or(key.as_str(), |(joint, _)| joint);
            format!("{} = {}\n", toml::Value::from(key.as_str()), toml::Value::from(joint))
        };
        let columns: String = robot.joints.iter().map(column).collect();
        let targets: Vec<&str> = robot.targets.iter().map(String::as_str).collect();
        let targets = if targets.is_empty() { &SMRS[..] } else { &targets };
        let campaign = ("campaign.toml", campaign(robot.controllers, &columns, targets));
        let files = robot.files.iter().map(|(name, text)| (name.as_str(), text.clone()));
        self.write(&std::iter::once(campaign).chain(files).collect::<Vec<_>>())
    }

    /// Creates a campaign for a robot of the built-in table.
    fn known(&self, name: &str) -> anyhow::Result<Verdict> {
        if let Some(path) = robot_toml::path(name) {
            return self.with_robot_file(robot_toml::robot_files(&path)?);
        }
        let robot = known_robot(name)?;
        let column = |joint: &String| format!("{joint} = \"{}\"\n", joint.split('_').next().unwrap_or(joint));
        let columns: String = robot.joints().iter().map(column).collect();
        let targets: Vec<&str> = robot.targets.iter().map(String::as_str).collect();
        let targets = if targets.is_empty() { &SMRS[..] } else { &targets };
        let texts =
            [("campaign.toml", campaign("[\"json\"]", &columns, targets)), ("robot.toml", robot.text().into_bytes())];
        self.write(&texts)
    }
}

/// A robot that a URDF describes.
struct Described {
    /// Name of the file.
    name: String,
    /// robot.toml.
    robot: Vec<u8>,
    /// The file.
    text: Vec<u8>,
    /// Keys of its joints, with their units.
    joints: Vec<String>,
    /// Targets of its branches.
    targets: Vec<String>,
}

/// Names of the robots of the table.
pub fn known_names() -> Result<Vec<String>, Problems> {
    let Known { robots } = parse("robots.toml", ROBOTS)?;
    Ok(robots.into_iter().map(|robot| robot.name).collect())
}

/// The robot.toml of a robot of the table.
pub fn known_text(name: &str) -> Result<String, Problems> {
    Ok(known_robot(name)?.text())
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

/// Path of the schema of an input file in the folder of a campaign, for editors.
fn schema_file(name: &str) -> String {
    format!("schemas/{name}.schema.json")
}

/// The chain of a URDF file with the most moving joints.
fn described(path: &Path) -> anyhow::Result<Described> {
    let (chain, text) = read_urdf(path)?;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let robot = urdf_text(&name, &chain);
    let (robot, text) = (robot.into_bytes(), text.into_bytes());
    Ok(Described { name, robot, text, joints: joint_keys(&chain), targets: Vec::new() })
}

/// Keys of the joints of a chain, with the units of a URDF.
fn joint_keys(chain: &TreeChain) -> Vec<String> {
    let unit = |quantity: Quantity| if quantity == Quantity::Length { "m" } else { "rad" };
    let key = |joint: &Joint| format!("{}_{}", joint.name, unit(joint.quantity));
    chain.joints.iter().map(key).collect()
}

/// The robot of this name in the table.
fn known_robot(name: &str) -> Result<KnownRobot, Problems> {
    let Known { mut robots } = parse("robots.toml", ROBOTS)?;
    let Some(at) = robots.iter().position(|robot| robot.name == name) else {
        let names: Vec<&str> = robots.iter().map(|robot| robot.name.as_str()).collect();
        return Err(error!("robot-not-in-table", name, names).into());
    };
    Ok(robots.swap_remove(at))
}

const SMRS: [&str; 3] = ["SMR_1", "SMR_2", "SMR_3"];

/// Campaign of a robot with these joint columns.
fn campaign(controllers: &str, columns: &str, targets: &[&str]) -> Vec<u8> {
    let text = ROBOT_CAMPAIGN.replace("CONTROLLERS", &format!("controllers = {controllers}"));
    text.replace("COLUMNS\n", &format!("{columns}\n")).replace("TARGETS", &format!("{targets:?}")).into_bytes()
}

/// Robots with known geometry.
#[derive(Deserialize, JsonSchema)]
struct Known {
    #[serde(rename = "robot")]
    robots: Vec<KnownRobot>,
}

/// A robot described by Denavit-Hartenberg parameters (alpha, a, theta and d of each joint), by
/// screw axes, or by the text of its robot.toml.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct KnownRobot {
    name: String,
    title: String,
    /// Source of the geometry.
    source: String,
    note: Option<String>,
    /// Source of the limits.
    limits_source: Option<String>,
    /// Lower and upper limit of each joint (deg); empty if no source states it.
    #[serde(default)]
    limits_deg: Vec<Vec<f64>>,
    #[serde(default)]
    dh: Vec<[f64; 4]>,
    #[serde(default)]
    mdh: Vec<[f64; 4]>,
    #[serde(default)]
    poe: Vec<Axis>,
    flange_xyz_mm: Option<[f64; 3]>,
    flange_rpy_deg: Option<[f64; 3]>,
    #[serde(default)]
    joints: Vec<String>,
    #[serde(default)]
    targets: Vec<String>,
    #[serde(default)]
    toml: String,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Axis {
    direction: [f64; 3],
    point_mm: [f64; 3],
}

impl KnownRobot {
    /// Names of the joints' columns.
    fn joints(&self) -> Vec<String> {
        let count = self.dh.len() + self.mdh.len() + self.poe.len();
        if count == 0 { self.joints.clone() } else { (1..=count).map(|i| format!("q{i}_deg")).collect() }
    }

    /// Limits of joint `i` in the text of robot.toml; empty if no source states them.
    fn limits(&self, i: usize) -> String {
        let stated = self.limits_deg.get(i).filter(|ends| !ends.is_empty());
        stated.map_or_else(String::new, |ends| format!(", limits_deg = {ends:?}"))
    }

    /// Text of robot.toml.
    fn text(&self) -> String {
        let mut text = format!("# {}: nominal geometry.\n# Source: {}.\n", self.title, self.source);
        text.extend(self.limits_source.iter().map(|source| format!("# Limits: {source}.\n")));
        text.extend(self.note.iter().map(|note| format!("# {note}\n")));
        let _ = writeln!(text, "name = {:?}", self.title);
        for (convention, rows) in [("dh", &self.dh), ("mdh", &self.mdh)] {
            if !rows.is_empty() {
                let _ = writeln!(text, "model = \"serial\"\nconvention = \"{convention}\"\njoint = [");
            }
            for (i, [alpha, a, theta, d]) in rows.iter().enumerate() {
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
