//! Robot of a campaign from the user's own robot.toml.

use super::from::RobotFiles;
use etalon_base::files;
use etalon_campaign::parse_robot;
use std::path::{Path, PathBuf};

/// Name of the file in the folder of a campaign.
const ROBOT: &str = "robot.toml";
/// Target that stands for the targets of a campaign.
const TARGET: &str = "target";

/// Returns the robot file that an option names: a path to a file or to a folder with a robot.toml.
/// A name without a path is the name of a known robot.
pub(crate) fn path(name: &str) -> Option<PathBuf> {
    let path = Path::new(name);
    let is_toml = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("toml"));
    match path.is_dir() {
        true => Some(path.join(ROBOT)).filter(|file| file.is_file()),
        false => (is_toml || path.is_file()).then(|| path.to_owned()),
    }
}

/// Returns the robot file, the file that it names, and the columns of the joints.
pub(crate) fn robot_files(path: &Path) -> anyhow::Result<RobotFiles> {
    let text = files::read_text(path)?;
    let robot = parse_robot(path, &text)?;
    // targets of a platform belong to its model
    let built = robot.build(&[TARGET.to_owned()]);
    let built = built.or_else(|problems| robot.build(&[]).map_err(|_| problems))?;
    let joints = built.joints().iter().map(|joint| joint.column()).collect();
    let targets = built.targets().iter().filter(|target| *target != TARGET).cloned().collect();
    let (mut text, mut all) = (text, Vec::new());
    let mut controllers = "[\"json\"]";
    if let Some((name, description)) = robot.description() {
        let beside = Path::new(name).file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        // the file is copied into the folder of robot.toml
        text = robot.text_beside(&beside);
        controllers = "[\"json\", \"urdf\"]";
        all.push((beside, description.as_bytes().to_vec()));
    }
    // init writes its own line for editors
    let text: String = text.split_inclusive('\n').filter(|line| !line.starts_with("#:schema")).collect();
    all.insert(0, (ROBOT.to_owned(), text.into_bytes()));
    Ok(RobotFiles { files: all, path: path.to_owned(), joints, targets, controllers, own: Some(robot) })
}
