//! Start of a campaign from files of measurements: campaign.toml and robot.toml as a proposal, with
//! questions for what the files do not contain.

mod branches;
mod from;
mod questions;
mod robot_toml;
mod tool_link;
mod trial;

pub(crate) use from::{RobotFiles, Started};
pub(crate) use questions::{Question, answered, open_questions};
pub(crate) use trial::{next as next_step, refusal_of_lines};

use crate::tasks::known_robots::known_robot;
use crate::tasks::urdf_text;
use etalon_campaign::read_urdf;
use etalon_robots::{Joint, Quantity, TreeChain};
use robot_toml::{path as robot_path, robot_files as own_robot_files};
use std::path::{Path, PathBuf};

/// Robot of a new campaign, as its user names it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct NamedRobot<'a> {
    /// URDF file.
    pub urdf: Option<&'a Path>,
    /// Name of a known robot, or path of a robot.toml.
    pub name: Option<&'a str>,
}

/// Line of a proposed campaign that its folder names.
const UNTITLED: &str = "name = \"First campaign\"";
/// Line in its place.
const TITLED_BY_DEFAULT: &str =
    "# name = \"...\"                              # title; by default kind, robot and date";

/// Proposes a campaign from files of measurements and logs. Tests of poses need no robot.
///
/// # Errors
/// Fails for files without measurements, and without a robot that the files need.
pub(crate) fn start(files: &[PathBuf], robot: NamedRobot) -> anyhow::Result<Started> {
    from::campaign(files, robot.files(files)?)
}

impl NamedRobot<'_> {
    /// Files of the robot, and its joints.
    pub fn files(self, measured: &[PathBuf]) -> anyhow::Result<RobotFiles> {
        if let Some(path) = self.urdf {
            return Ok(RobotFiles::from_urdf(path, tool_link::described(path, measured)?));
        }
        let Some(name) = self.name else { return Ok(RobotFiles::none()) };
        if let Some(path) = robot_path(name) {
            return own_robot_files(&path);
        }
        let robot = known_robot(name)?;
        let files = vec![("robot.toml".to_owned(), robot.text().into_bytes())];
        let (joints, targets) = (robot.joints(), robot.targets.clone());
        // the format of its calibration for ROS
        let controllers = if robot.name.starts_with("ur") { "[\"json\", \"universal-robots\"]" } else { "[\"json\"]" };
        let path = "robot.toml".into();
        Ok(RobotFiles { files, path, joints, targets, controllers, own: None })
    }
}

/// Adds the schemas that the first lines name; the title of a campaign follows from its robot and
/// its date.
pub(crate) fn described_by(mut files: Vec<(String, Vec<u8>)>) -> Vec<(String, Vec<u8>)> {
    let schemas = etalon_campaign::SCHEMAS;
    for (name, text) in &mut files {
        if !schemas.iter().any(|(of, _)| of == name) {
            continue;
        }
        let own = String::from_utf8_lossy(text);
        let titled = match name == "campaign.toml" {
            true => own.replacen(UNTITLED, TITLED_BY_DEFAULT, 1),
            false => own.into_owned(),
        };
        *text = format!("#:schema ./{}\n{titled}", schema_file(name)).into_bytes();
    }
    files.extend(schemas.iter().map(|(name, text)| (schema_file(name), text.as_bytes().to_vec())));
    files
}

/// Path of the schema of an input file in the folder of a campaign, for editors.
fn schema_file(name: &str) -> String {
    format!("schemas/{name}.schema.json")
}

/// A robot that a URDF describes.
pub(crate) struct DescribedRobot {
    /// Name of the file.
    pub name: String,
    /// robot.toml.
    pub robot: Vec<u8>,
    /// The file.
    pub text: Vec<u8>,
    /// Keys of its joints, with their units.
    pub joints: Vec<String>,
    /// Targets of its branches.
    pub targets: Vec<String>,
}

/// The chain of a URDF file with the most moving joints.
pub(crate) fn described(path: &Path) -> anyhow::Result<DescribedRobot> {
    let (chain, text) = read_urdf(path)?;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let robot = urdf_text(&name, &chain);
    let (robot, text) = (robot.into_bytes(), text.into_bytes());
    Ok(DescribedRobot { name, robot, text, joints: joint_keys(&chain), targets: Vec::new() })
}

/// Keys of the joints of a chain, with the units of a URDF.
fn joint_keys(chain: &TreeChain) -> Vec<String> {
    let unit = |quantity: Quantity| if quantity == Quantity::Length { "m" } else { "rad" };
    let key = |joint: &Joint| format!("{}_{}", joint.name, unit(joint.quantity));
    chain.joints.iter().map(key).collect()
}
