//! Command `etalon init`.

use super::{Output, Verdict, shell_word};
use crate::tasks::default_chain;
use crate::tasks::start::{NamedRobot, RobotFiles, described, described_by, next_step, start};
use etalon_base::files;
use etalon_base::phrase;
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
    /// copied into the folder of robot.toml.
    #[arg(long, value_name = "FILE", conflicts_with = "synthetic")]
    urdf: Option<PathBuf>,
    /// Use the published geometry of this robot (ur5e, irb120 ...), an example of a model
    /// (five-bar, xy-theta, hexapod, delta ...), or your own robot.toml.
    ///
    /// A robot.toml is copied into the folder, together with its URDF file.
    #[arg(long, value_name = "NAME|FILE", conflicts_with_all = ["synthetic", "urdf"])]
    robot: Option<String>,
    /// Propose the whole campaign from these files: exports, logs, tables with both, observations.
    ///
    /// The files are copied into the folder, and `etalon check` lists the data that they do not
    /// contain. Needs --robot or --urdf, except for tests of poses.
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with = "synthetic")]
    from: Vec<PathBuf>,
    /// Print the names of the files written as JSON.
    #[arg(long)]
    json: bool,
}

const CAMPAIGN: &str = include_str!("init/campaign.toml");
const ROBOT: &str = include_str!("init/robot.toml");
const ROBOT_CAMPAIGN: &str = include_str!("init/campaign-robot.toml");
const TRUTH: &str = include_str!("init/truth.toml");

/// Commented line of the template for synthetic data.
const SYNTHETIC: &str = "# synthetic = \"how the data were made\"";
const MADE: &str = "synthetic = \"made by `etalon simulate` from truth.toml; nobody measured them\"";

impl Init {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        if !self.from.is_empty() {
            let robot = NamedRobot { urdf: self.urdf.as_deref(), name: self.robot.as_deref() };
            let started = start(&self.from, robot)?;
            let files = described_by([started.written, started.copied].concat());
            out.print_written(files::write_new(&self.folder, &files)?, self.json)?;
            let (_, text) = &files[0];
            if !self.json {
                let robot =
                    files.iter().find(|(name, _)| name == "robot.toml").map_or(&[][..], |(_, text)| text.as_slice());
                let [text, robot] = [text.as_slice(), robot].map(String::from_utf8_lossy);
                out.next_step(self.json, next_step(&self.folder, &text, &robot));
            }
            return Ok(Verdict::Met);
        }
        if let Some(path) = &self.urdf {
            return self.describe(path, out);
        }
        if let Some(name) = &self.robot {
            return self.with_robot(NamedRobot { urdf: None, name: Some(name) }.files(&[])?, out);
        }
        let mut texts = vec![("campaign.toml", CAMPAIGN.into()), ("robot.toml", ROBOT.into())];
        if self.synthetic {
            texts[0].1 = CAMPAIGN.replace(SYNTHETIC, MADE).into_bytes();
            texts.push(("truth.toml", TRUTH.into()));
        }
        self.write(&texts, out)
    }

    /// Writes the files, and says what comes next.
    fn write(&self, texts: &[(&str, Vec<u8>)], out: &Output) -> anyhow::Result<Verdict> {
        let texts = texts.iter().map(|(name, text)| ((*name).to_owned(), text.clone())).collect();
        let all = described_by(texts);
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

    /// A campaign of the robot of a URDF file.
    fn describe(&self, path: &Path, out: &Output) -> anyhow::Result<Verdict> {
        let robot = RobotFiles::from_urdf(path, described(path)?);
        if let (_, Some(message)) = default_chain(path)? {
            out.say_message(&message);
        }
        self.with_robot(robot, out)
    }

    /// A campaign for a robot with its files.
    fn with_robot(&self, robot: RobotFiles, out: &Output) -> anyhow::Result<Verdict> {
        let quoted = |text: &str| toml::Value::from(text).to_string();
        let is_bare = |key: &str| key.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
        let column = |key: &String| {
            let joint = key.rsplit_once('_').map_or(key.as_str(), |(joint, _)| joint);
            let key = if is_bare(key) { key.clone() } else { quoted(key) };
            format!("{key} = {}\n", quoted(joint))
        };
        let columns: String = robot.joints.iter().map(column).collect();
        let targets: Vec<&str> = robot.targets.iter().map(String::as_str).collect();
        let targets = if targets.is_empty() { &SMRS[..] } else { &targets };
        let controllers = robot.controllers_lines(robot.built().as_deref());
        let campaign = ("campaign.toml", campaign(&controllers, &columns, targets));
        let files = robot.files.iter().map(|(name, text)| (name.as_str(), text.clone()));
        self.write(&std::iter::once(campaign).chain(files).collect::<Vec<_>>(), out)
    }
}

const SMRS: [&str; 3] = ["SMR_1", "SMR_2", "SMR_3"];

/// Returns the campaign of a robot with these joint columns.
fn campaign(controllers: &str, columns: &str, targets: &[&str]) -> Vec<u8> {
    let text = ROBOT_CAMPAIGN.replace("CONTROLLERS", controllers);
    text.replace("COLUMNS\n", &format!("{columns}\n")).replace("TARGETS", &format!("{targets:?}")).into_bytes()
}
