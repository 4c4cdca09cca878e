//! Command `etalon init`.

mod branches;
mod from;
mod robot_toml;
mod tool_link;
mod trial;

pub(super) use trial::refusal_of_lines;

use super::{Output, Verdict, shell_word};
use crate::tasks::known_robots::known_robot;
use crate::tasks::urdf_text;
use etalon_base::files;
use etalon_base::message::Problems;
use etalon_base::{error, phrase};
use etalon_campaign::read_urdf;
use etalon_robots::{Joint, Quantity, TreeChain};
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
const TRUTH: &str = include_str!("init/truth.toml");

/// Line of the template, a comment, that states synthetic data.
const SYNTHETIC: &str = "# synthetic = \"how the data were made\"";
const MADE: &str = "synthetic = \"made by `etalon simulate` from truth.toml; nobody measured them\"";

impl Init {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        if !self.from.is_empty() {
            let files = self.described_by(from::campaign(&self.from, self.robot_files()?)?);
            out.print_written(files::write_new(&self.folder, &files)?, self.json)?;
            let (_, text) = &files[0];
            if !self.json {
                let robot =
                    files.iter().find(|(name, _)| name == "robot.toml").map_or(&[][..], |(_, text)| text.as_slice());
                let [text, robot] = [text.as_slice(), robot].map(String::from_utf8_lossy);
                out.next_step(self.json, trial::next(&self.folder, &text, &robot));
            }
            return Ok(Verdict::Met);
        }
        if let Some(path) = &self.urdf {
            return self.describe(path, out);
        }
        if let Some(name) = &self.robot {
            return self.known(name, out);
        }
        let mut texts = vec![("campaign.toml", CAMPAIGN.into()), ("robot.toml", ROBOT.into())];
        if self.synthetic {
            texts[0].1 = CAMPAIGN.replace(SYNTHETIC, MADE).into_bytes();
            texts.push(("truth.toml", TRUTH.into()));
        }
        self.write(&texts, out)
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
    fn write(&self, texts: &[(&str, Vec<u8>)], out: &Output) -> anyhow::Result<Verdict> {
        let texts = texts.iter().map(|(name, text)| ((*name).to_owned(), text.clone())).collect();
        let all = self.described_by(texts);
        out.print_written(files::write_new(&self.folder, &all)?, self.json)?;
        let folder = shell_word(&self.folder);
        match self.synthetic {
            true => out.next_step(self.json, phrase!("next-simulate", command = format!("`etalon simulate {folder}`"))),
            false => {
                let command = format!("`etalon check {folder}`");
                out.next_step(self.json, phrase!("next-copy", folder, command));
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
    fn describe(&self, path: &Path, out: &Output) -> anyhow::Result<Verdict> {
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
        self.write(&texts, out)
    }

    /// A campaign for a robot of the user's robot.toml.
    fn with_robot_file(&self, robot: from::RobotFiles, out: &Output) -> anyhow::Result<Verdict> {
        let column = |key: &String| {
            let joint = key.rsplit_once('_').map_or(key.as_str(), |(joint, _)| joint);
            format!("{} = {}\n", toml::Value::from(key.as_str()), toml::Value::from(joint))
        };
        let columns: String = robot.joints.iter().map(column).collect();
        let targets: Vec<&str> = robot.targets.iter().map(String::as_str).collect();
        let targets = if targets.is_empty() { &SMRS[..] } else { &targets };
        let campaign = ("campaign.toml", campaign(robot.controllers, &columns, targets));
        let files = robot.files.iter().map(|(name, text)| (name.as_str(), text.clone()));
        self.write(&std::iter::once(campaign).chain(files).collect::<Vec<_>>(), out)
    }

    /// Creates a campaign for a robot of the built-in table.
    fn known(&self, name: &str, out: &Output) -> anyhow::Result<Verdict> {
        if let Some(path) = robot_toml::path(name) {
            return self.with_robot_file(robot_toml::robot_files(&path)?, out);
        }
        let robot = known_robot(name)?;
        let column = |joint: &String| format!("{joint} = \"{}\"\n", joint.split('_').next().unwrap_or(joint));
        let columns: String = robot.joints().iter().map(column).collect();
        let targets: Vec<&str> = robot.targets.iter().map(String::as_str).collect();
        let targets = if targets.is_empty() { &SMRS[..] } else { &targets };
        let texts =
            [("campaign.toml", campaign("[\"json\"]", &columns, targets)), ("robot.toml", robot.text().into_bytes())];
        self.write(&texts, out)
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

const SMRS: [&str; 3] = ["SMR_1", "SMR_2", "SMR_3"];

/// Campaign of a robot with these joint columns.
fn campaign(controllers: &str, columns: &str, targets: &[&str]) -> Vec<u8> {
    let text = ROBOT_CAMPAIGN.replace("CONTROLLERS", &format!("controllers = {controllers}"));
    text.replace("COLUMNS\n", &format!("{columns}\n")).replace("TARGETS", &format!("{targets:?}")).into_bytes()
}
