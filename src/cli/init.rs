//! `etalon init`

use super::{Verdict, print_written};
use crate::base::files;
use crate::campaign::read_urdf;
use crate::math::robots::{Joint, Quantity};
use std::path::{Path, PathBuf};

/// Write a commented campaign to start from
#[derive(Debug, clap::Args)]
pub struct Init {
    /// New folder of the campaign
    folder: PathBuf,
    /// Add a truth, from which `etalon simulate` writes the exports and logs
    #[arg(long)]
    synthetic: bool,
    /// Describe the robot by this URDF, which is copied beside robot.toml: its chain with the most moving joints
    #[arg(long, value_name = "FILE", conflicts_with = "synthetic")]
    urdf: Option<PathBuf>,
    /// Print the names of the files written as JSON
    #[arg(long)]
    json: bool,
}

const CAMPAIGN: &str = include_str!("init/campaign.toml");
const ROBOT: &str = include_str!("init/robot.toml");
const URDF_CAMPAIGN: &str = include_str!("init/campaign-urdf.toml");
const TRUTH: &str = include_str!("init/truth.toml");

/// In the template, a comment.
const SYNTHETIC: &str = "# synthetic = \"how the data were made\"";
const MADE: &str = "synthetic = \"made by `etalon simulate` from truth.toml; nobody measured them\"";

impl Init {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        if let Some(path) = &self.urdf {
            return self.describe(path);
        }
        let mut texts = vec![("campaign.toml", CAMPAIGN.into()), ("robot.toml", ROBOT.into())];
        if self.synthetic {
            texts[0].1 = CAMPAIGN.replace(SYNTHETIC, MADE).into_bytes();
            texts.push(("truth.toml", TRUTH.into()));
        }
        print_written(files::write_new(&self.folder, &texts)?, self.json)?;
        Ok(Verdict::Met)
    }

    /// A campaign of the robot of a URDF file.
    fn describe(&self, path: &Path) -> anyhow::Result<Verdict> {
        let (chain, text) = read_urdf(path)?;
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let quoted = |text: &str| toml::Value::from(text).to_string();
        let robot = format!(
            "model = \"urdf\"\nfile = {}\nbase_link = {}\ntool_link = {:<30} # its frame carries the targets\n\
             # bending = [{}]    # joints that bend under the masses of the URDF\n",
            quoted(&name),
            quoted(&chain.base_link),
            quoted(&chain.tool_link),
            quoted(&chain.joints[0].name),
        );
        let unit = |quantity: Quantity| if quantity == Quantity::Length { "m" } else { "rad" };
        let column = |joint: &Joint| {
            let key = format!("{}_{}", joint.name, unit(joint.quantity));
            format!("{} = {}\n", quoted(&key), quoted(&joint.name))
        };
        let columns: String = chain.joints.iter().map(column).collect();
        let texts = [
            ("campaign.toml", URDF_CAMPAIGN.replace("COLUMNS\n", &(columns + "\n")).into_bytes()),
            ("robot.toml", robot.into_bytes()),
            (name.as_str(), text.into_bytes()),
        ];
        print_written(files::write_new(&self.folder, &texts)?, self.json)?;
        Ok(Verdict::Met)
    }
}
