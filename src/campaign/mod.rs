//! A campaign: one measurement session of one robot, as `campaign.toml` and `robot.toml` state it.

mod geometric;
mod join;
mod lost;
mod paths;
mod poses;
mod repeatability;
mod report;
mod robot_file;
mod selection;
mod stream;
mod toml_problems;
mod types;
mod unknown;

pub use geometric::*;
pub use join::{ClockOffset, Join, JoinBy};
pub use lost::Lost;
pub use poses::{ComplianceDefinition, PosesDefinition};
pub use repeatability::RepeatabilityDefinition;
pub use report::ReportDefinition;
pub use robot_file::RobotFile;
pub use selection::Selection;
pub use stream::StreamDefinition;
pub use types::*;

use crate::base::files;
use crate::base::message::{Message, Place, Problems, Result, Stated};
use crate::math::identify::Settings;
use crate::math::robots::Robot;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml_problems::Recovered;
pub(crate) use toml_problems::parse;

/// A campaign with the folder it lives in and the text it was read from.
#[derive(Clone, Debug)]
pub struct Campaign {
    /// What `campaign.toml` says.
    pub file: CampaignFile,
    /// What `robot.toml` says.
    pub robot: RobotFile,
    /// The folder of `campaign.toml`.
    pub folder: PathBuf,
    /// `campaign.toml` as the user named it.
    pub path: String,
    /// Its text.
    pub text: String,
    /// Text of the robot file.
    pub robot_text: String,
    /// What of `campaign.toml` did not read; nothing is, where it was read as a whole.
    pub lost: Lost,
}

impl Campaign {
    /// Reads a campaign: the path of a `campaign.toml`, or of the folder that holds it.
    ///
    /// Every wrong key and value of both files is reported, not only the first.
    pub fn read(path: &Path) -> Result<Self> {
        let (campaign, problems) = Self::recover(path)?;
        campaign.filter(|_| problems.0.is_empty()).ok_or(problems)
    }

    /// The campaign that is left when everything that does not fit is taken away, and what that is.
    pub fn recover(path: &Path) -> Result<(Option<Self>, Problems)> {
        let path = if path.is_dir() { path.join("campaign.toml") } else { path.to_owned() };
        if !path.is_file() {
            let what = format!("there is no campaign `{}`", path.display());
            return Err(Message::error(what).hint("`etalon init FOLDER` writes one to start from").into());
        }
        let text = files::read_text(&path)?;
        let name = path.display().to_string();
        let folder = path.parent().map_or_else(PathBuf::new, Path::to_owned);
        let Recovered { value, mut problems, lost } =
            toml_problems::recover::<CampaignFile>(&name, &text, types::defaults(&text));
        let Some(file) = value else { return Ok((None, problems)) };
        let here = Place::span(name.as_str(), &text, file.robot.span());
        let read = paths::resolve(&folder, file.robot.get_ref())
            .map_err(Problems::from)
            .and_then(|path| Ok((path.display().to_string(), files::read_text(&path)?)));
        let (robot, more, robot_text) = match read {
            // told with the campaign
            _ if lost.touches(&["robot"]) => (None, Problems::default(), String::new()),
            Ok((robot_name, robot_text)) => {
                let (robot, more) = RobotFile::recover(&robot_name, &robot_text);
                (robot, more, robot_text)
            }
            Err(more) => (None, more.at(&here), String::new()),
        };
        problems.0.extend(more.0);
        let robot = robot.unwrap_or_else(RobotFile::unreadable);
        Ok((Some(Self { file, robot, folder, path: name, text, robot_text, lost }), problems))
    }

    /// The path of a file that the campaign names: inside its folder, or below `$NAME/` of the environment.
    pub fn resolve(&self, file: &Spanned<String>) -> Result<PathBuf> {
        paths::resolve(&self.folder, file.get_ref()).map_err(|m| m.at(self.place(file)).into())
    }

    /// Folder for the documents.
    pub fn output(&self) -> Result<PathBuf> {
        self.resolve(&self.file.output)
    }

    /// Whether parameters are identified; a campaign may be a test by ISO 9283 alone.
    pub fn identifies(&self) -> bool {
        types::identifies(&self.text)
    }

    /// The environment variable that the campaign's data hang on, if it is not set: such a campaign is skipped.
    pub fn missing_variable(&self) -> Option<String> {
        self.file.inputs().find_map(|f| paths::missing_variable(f.get_ref()))
    }

    /// Where a value stands in `campaign.toml`.
    pub fn place<T>(&self, value: &Spanned<T>) -> Place {
        self.stated().place(value)
    }

    /// `campaign.toml` as the text that states values.
    pub fn stated(&self) -> Stated<'_> {
        Stated { name: &self.path, text: &self.text }
    }

    /// Where the value of a key stands in `campaign.toml`, given by the keys that lead to it; the file where it does not.
    pub fn place_of(&self, path: &[&str]) -> Place {
        let span = toml_problems::find(&self.text, path);
        span.map_or_else(|| Place::file(self.path.as_str()), |span| Place::span(self.path.as_str(), &self.text, span))
    }

    /// `campaign.toml`, without the folder: documents are the same wherever the folder stands.
    pub fn file_name(&self) -> &str {
        self.path.rsplit(['/', '\\']).next().unwrap_or(&self.path)
    }

    /// Whether all that an export states reads; a unit that does not is no matter for labels.
    pub fn export_reads(&self, index: usize) -> bool {
        !self.lost.touches_beside(&["export", &index.to_string()], "unit")
    }

    /// What the campaign identifies from which residuals.
    pub fn settings(&self) -> Settings {
        let identify = &self.file.identify;
        let instrument = self.file.instrument.standard_uncertainty_mm();
        let contact = self.file.contact.as_ref().map(Contact::standard_uncertainty_mm);
        Settings {
            kind: identify.residuals,
            standard_uncertainty_mm: Some(contact.unwrap_or(instrument)),
            common_uncertainty_mm: contact.map(|_| instrument),
            hold: identify.hold.iter().map(|h| h.get_ref().clone()).collect(),
        }
    }

    /// Targets that become observations: those that `[join]` names, or all that the robot has.
    pub fn targets(&self) -> Vec<String> {
        self.file.join.targets.iter().flatten().map(|t| t.get_ref().clone()).collect()
    }

    /// The robot that the campaign measured.
    pub fn build_robot(&self) -> Result<Box<dyn Robot>> {
        // an arm whose targets did not read has some, and a test needs none
        let unread = self.lost.touches(&["join", "targets"]) || !self.identifies();
        let targets = if unread { vec!["target".to_owned()] } else { self.targets() };
        self.robot.build(&targets).map_err(|problems| problems.at(&self.place_of(&["join", "targets"])))
    }

    /// Which poses are for what: `calibration` and `validation`.
    pub fn selections(&self) -> Result<(Selection, Option<Selection>)> {
        let parse = |text: &Spanned<String>| {
            Selection::parse(text.get_ref()).map_err(|m| Problems::from(m.at(self.place(text))))
        };
        let identify = &self.file.identify;
        Ok((parse(&identify.calibration)?, identify.validation.as_ref().map(parse).transpose()?))
    }
}

/// Reads a robot file on its own.
pub fn read_robot(path: &Path) -> Result<RobotFile> {
    let (robot, problems) = RobotFile::recover(&path.display().to_string(), &files::read_text(path)?);
    robot.filter(|_| problems.0.is_empty()).ok_or(problems)
}

/// Reads the true parameters of a simulation alone, by name in mm, deg and 1: of a truth, or of a file that has nothing else.
pub fn read_true_parameters(path: &Path) -> Result<BTreeMap<String, f64>> {
    #[derive(serde::Deserialize)]
    struct Parameters {
        parameters: BTreeMap<String, f64>,
    }
    let text = files::read_text(path)?;
    Ok(toml_problems::parse::<Parameters>(&path.display().to_string(), &text)?.parameters)
}
