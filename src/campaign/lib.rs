//! A campaign: one measurement session of one robot, as given in `campaign.toml` and `robot.toml`.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

#[cfg(not(feature = "schemas"))]
extern crate etalon_schemaless as schemars;

mod edit;
mod named_files;
mod open;
mod paths;
mod robot;
mod sections;
mod toml_file;
mod types;

use robot::{robot_faults, robot_file, robot_keys, robot_text, urdf};
use sections::{geometric, iso9283, join, selection, table, title};

pub use edit::Changes;
pub use geometric::*;
pub use iso9283::*;
pub use join::{ClockOffset, ClockRate, Join, JoinBy};
pub use open::{OpenPart, open_parts};
pub use robot_file::{PartMesh, RobotFile, Unbuilt};
pub use robot_text::{RobotHead, UrdfJoint, nominal_text, screws_text, table_text, urdf_text};
pub use selection::{Selection, Selections, StatedPoses};
pub use table::{TableDefinition, TableFiles, TableKeys};
pub use toml_file::UnreadKeys;
pub use types::*;

use etalon_base::error;
use etalon_base::files::{self, Stamp};
use etalon_base::message::{Place, Problems, Result, SourceText};
use etalon_documents::{Source, SourceKind};
use etalon_identify::{FrameError, Settings, Systematic, UncertaintyBound};
use etalon_robots::{Joint, Quantity, Robot, TreeChain};
use open::open_questions;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml_file::Recovered;
pub use toml_file::{parse, schema};

/// A campaign with its folder and text.
///
/// # Examples
///
/// ```
/// use etalon_campaign::Campaign;
/// use std::path::Path;
///
/// let campaign = Campaign::read(Path::new("../../samples/prexyt-cmm"))?;
/// assert_eq!(campaign.file.exports.len(), 2);
/// assert_eq!(campaign.build_robot()?.targets(), ["K", "L"]);
///
/// // expanded uncertainty of the machine 2.7 µm, k = 2
/// assert!((campaign.file.instrument.standard_uncertainty_mm() - 0.00135).abs() < 1e-12);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
#[derive(Clone, Debug)]
pub struct Campaign {
    /// Contents of `campaign.toml`.
    pub file: CampaignFile,
    /// Contents of `robot.toml`.
    pub robot: RobotFile,
    /// Folder of `campaign.toml`.
    pub folder: PathBuf,
    /// Path of `campaign.toml`.
    pub location: PathBuf,
    /// Path of `campaign.toml` in messages, with replacement characters if it is not UTF-8.
    pub path: String,
    /// Text of `campaign.toml`.
    pub text: String,
    /// Stamps of both files.
    pub stamps: [Stamp; 2],
    /// Entries of `campaign.toml` that could not be read.
    pub unread: UnreadKeys,
    /// Forms of the names of exports that stand for a file for each pose.
    forms: Vec<String>,
}

impl Campaign {
    /// Reads a campaign from the path of a `campaign.toml`, or of its folder.
    ///
    /// All wrong keys and values of both files are reported, not only the first.
    pub fn read(path: &Path) -> Result<Self> {
        let (campaign, problems) = Self::recover(path)?;
        campaign.filter(|_| problems.0.is_empty()).ok_or(problems)
    }

    /// Reads a campaign without the entries that do not fit, and returns the problems.
    pub fn recover(path: &Path) -> Result<(Option<Self>, Problems)> {
        let path = if path.is_dir() { path.join("campaign.toml") } else { path.to_owned() };
        if !path.is_file() {
            return Err(error!("campaign-missing", file = path.display().to_string()).into());
        }
        let (text, stamp) = files::read_statement(&path)?;
        Self::recover_text(path, text, stamp)
    }

    /// Reads this text like [`Campaign::recover`] in the place of the file: a trial of answers to
    /// its open questions.
    ///
    /// # Errors
    /// Fails like [`Campaign::recover`].
    pub fn recover_text(path: PathBuf, text: String, stamp: Stamp) -> Result<(Option<Self>, Problems)> {
        let name = path.display().to_string();
        let folder = path.parent().map_or_else(PathBuf::new, Path::to_owned);
        let questions = open_questions(&name, &text);
        if !questions.0.is_empty() {
            return Ok((None, questions));
        }
        let Recovered { value, mut problems, mut unread } =
            toml_file::recover::<CampaignFile>(&name, &text, &schema("campaign.toml", SCHEMAS));
        let Some(mut file) = value else { return Ok((None, problems)) };
        let (forms, wrong) = file.name_files(&folder, SourceText { name: &name, text: &text });
        if !wrong.is_empty() {
            problems.0.extend(wrong);
            unread.add(vec!["export".to_owned()]);
        }
        let joints = file.exports.iter().any(|export| !export.joints.is_empty());
        problems.0.extend(file.add_joints_of_exports(SourceText { name: &name, text: &text }));
        for key in missing_keys(&text).into_iter().filter(|key| !joints || !["log", "join"].contains(key)) {
            problems.0.push(toml_file::missing(&name, &text, &(0..0), key, &[]));
            unread.add(vec![key.to_owned()]);
        }
        problems.0.sort_by_key(|m| m.place.as_ref().and_then(|p| p.line));
        let here = Place::span(name.as_str(), &text, file.robot.span());
        let read = paths::resolve(&folder, file.robot.get_ref())
            .map_err(Problems::from)
            .and_then(|path| Ok((files::read_statement(&path)?, path)));
        let (robot, more, robot_stamp) = match read {
            // reported with the campaign
            _ if unread.affects(&["robot"]) || !file.states_robot() => (None, Problems::default(), Stamp::default()),
            Ok(((text, stamp), path)) => {
                let questions = open_questions(&path.display().to_string(), &text);
                let (robot, more) = match questions.0.is_empty() {
                    true => RobotFile::recover(&path, &text),
                    false => (None, questions),
                };
                (robot, more, stamp)
            }
            Err(more) => (None, more.at(&here), Default::default()),
        };
        problems.0.extend(more.0);
        let robot = robot.unwrap_or_else(RobotFile::unreadable);
        if file.name.trim().is_empty() && !unread.affects(&["name"]) {
            file.name = title::composed(&file, robot.name.as_deref(), &folder);
        }
        let stamps = [stamp, robot_stamp];
        let campaign = Self { file, robot, folder, location: path, path: name, text, stamps, unread, forms };
        Ok((Some(campaign), problems))
    }

    /// Path of a file that the campaign names: inside its folder, or below `$NAME/` of the
    /// environment.
    pub fn resolve(&self, file: &Spanned<String>) -> Result<PathBuf> {
        paths::resolve(&self.folder, file.get_ref()).map_err(|m| m.at(self.place(file)).into())
    }

    /// Path of a file or folder that is to be written, like [`Campaign::resolve`].
    ///
    /// # Errors
    /// Fails if a symbolic link below the root of the path leads elsewhere.
    pub fn written(&self, file: &Spanned<String>) -> Result<PathBuf> {
        let (root, path) = paths::rooted(&self.folder, file.get_ref()).map_err(|m| m.at(self.place(file)))?;
        files::refuse_links(&root, &path).map_err(|more| more.at(&self.place(file)))?;
        Ok(path)
    }

    /// Path of the controller's file before loading, if the campaign names one.
    pub fn controller_backup(&self) -> Option<Result<PathBuf>> {
        let file = self.file.conditions.robot.controller_backup.as_deref()?;
        let place = || self.key_place(&["conditions", "controller_backup"]);
        Some(paths::resolve(&self.folder, file).map_err(|message| message.at(place()).into()))
    }

    /// SHA-256 of `campaign.toml` without its line `controller_backup`; `None` without this line.
    pub fn sha256_without_backup(&self) -> Option<String> {
        let key = toml_file::find(&self.text, &["conditions", "controller_backup"])?;
        Some(files::sha256(edit::without_line(&self.text, key)?.as_bytes()))
    }

    /// Path of a source file.
    pub fn source(&self, source: &Source) -> Result<PathBuf> {
        match source.kind {
            SourceKind::Campaign => Ok(self.location.clone()),
            _ => Ok(paths::resolve(&self.folder, &source.file)?),
        }
    }

    /// Folder of the documents, for reading.
    pub fn output(&self) -> Result<PathBuf> {
        self.resolve(&self.file.output)
    }

    /// Folder of the documents, for writing.
    ///
    /// # Errors
    /// Fails like [`Campaign::written`].
    pub fn written_output(&self) -> Result<PathBuf> {
        self.written(&self.file.output)
    }

    /// File that describes the robot in the folder of robot.toml, as a path from the campaign's
    /// folder, with its stamp.
    pub fn robot_description(&self) -> Option<(String, &Stamp)> {
        let (file, stamp) = self.robot.description_file()?;
        let robot = self.file.robot.get_ref();
        let folder = robot.rsplit_once('/').map(|(folder, _)| format!("{folder}/")).unwrap_or_default();
        Some((if file.starts_with('$') { file.to_owned() } else { folder + file }, stamp))
    }

    /// `true` if parameters are identified, even if `[identify]` itself could not be read; `false`
    /// for a test to ISO 9283 alone.
    pub fn identifies(&self) -> bool {
        self.file.identify.is_some() || self.unread.affects(&["identify"])
    }

    /// Environment variable that the campaign's data need, if it is unset.
    pub fn missing_variable(&self) -> Option<String> {
        self.file.inputs().find_map(|f| paths::missing_variable(f.get_ref()))
    }

    /// Place of a value in `campaign.toml`.
    pub fn place<T>(&self, value: &Spanned<T>) -> Place {
        self.stated().place(value)
    }

    /// Name and text of `campaign.toml` for messages.
    pub fn stated(&self) -> SourceText<'_> {
        SourceText { name: &self.path, text: &self.text }
    }

    /// Place of a key's value in `campaign.toml`, given by the keys that lead to it; the file if
    /// the key is missing.
    pub fn key_place(&self, path: &[&str]) -> Place {
        let span = toml_file::find(&self.text, path);
        span.map_or_else(|| Place::file(self.path.as_str()), |span| Place::span(self.path.as_str(), &self.text, span))
    }

    /// Name of `campaign.toml` without its folder, so that documents do not depend on the folder.
    pub fn file_name(&self) -> &str {
        self.path.rsplit(['/', '\\']).next().unwrap_or(&self.path)
    }

    /// `true` if all keys of an export could be read, except for its unit, which labels do not
    /// need.
    pub fn export_reads(&self, index: usize) -> bool {
        // files of one form are one table of the text
        let mut tables: Vec<_> = self.file.exports.iter().take(index + 1).map(|export| export.file.span()).collect();
        tables.dedup();
        let table = tables.len().saturating_sub(1).to_string();
        !self.unread.affects_except(&["export", &table], "unit")
    }

    /// Paths of all files of measurements, including files that appeared after the campaign was
    /// read.
    pub fn present_inputs(&self) -> Vec<PathBuf> {
        let named = self.file.inputs().filter_map(|file| self.resolve(file).ok());
        let mut all: Vec<PathBuf> =
            named.chain(self.forms.iter().flat_map(|form| named_files::present_paths(&self.folder, form))).collect();
        all.sort();
        all.dedup();
        all
    }

    /// Given bound of uncertainties.
    ///
    /// # Errors
    /// Fails if the text is not a bound.
    pub fn uncertainty_bound(&self) -> Result<UncertaintyBound> {
        let Some(text) = &self.file.uncertainty_bound else { return Ok(UncertaintyBound::default()) };
        text.get_ref().parse().map_err(|problems: Problems| problems.at(&self.place(text)))
    }

    /// Standard uncertainty (mm) of a measured coordinate: of the instrument, and of the contact if
    /// it is given.
    pub fn coordinate_uncertainty_mm(&self) -> f64 {
        let contact = self.file.contact.as_ref().map_or(0.0, Contact::standard_uncertainty_mm);
        self.file.instrument.standard_uncertainty_mm().hypot(contact)
    }

    /// Settings of the identification.
    pub fn settings(&self, identify: &Identify) -> Settings {
        let instrument = self.file.instrument.standard_uncertainty_mm();
        let contact = self.file.contact.as_ref().map(Contact::standard_uncertainty_mm);
        Settings {
            kind: identify.residuals.into(),
            standard_uncertainty_mm: Some(contact.unwrap_or(instrument)),
            common_uncertainty_mm: contact.map(|_| instrument),
            hold: identify.hold.iter().map(|h| h.get_ref().clone()).collect(),
            rigid: self.file.rigid.iter().filter_map(Rigid::shape).collect(),
            prior: identify.prior.into(),
            effects: (&identify.effects).into(),
            ..Settings::default()
        }
    }

    /// Errors common to all observations of `robot`, including `frames`.
    pub fn systematic(&self, robot: &dyn Robot, frames: Vec<FrameError>) -> Systematic {
        let of_joint = |homing: &Homing, joint: &Joint| {
            let expanded = match joint.quantity {
                Quantity::Angle => homing.expanded_uncertainty_deg.map(f64::to_radians),
                _ => homing.expanded_uncertainty_um.map(|um| um / 1000.0),
            };
            expanded.unwrap_or(0.0) / homing.coverage_factor
        };
        let of_all = |homing: &Homing| robot.joints().iter().map(|joint| of_joint(homing, joint)).collect();
        Systematic {
            frames,
            scale: self.file.instrument.scale_uncertainty(),
            expansion: self.file.expansion.map_or(0.0, |expansion| expansion.relative_uncertainty()),
            homing: self.file.homing.as_ref().map(of_all).unwrap_or_default(),
        }
    }

    /// Place of the definition of the world frame.
    pub fn world_place(&self) -> Place {
        self.key_place(&["frame", "world"])
    }

    /// Builds the robot of the campaign, with the targets of `[join]`.
    pub fn build_robot(&self) -> Result<Box<dyn Robot>> {
        self.build_robot_with(&[])
    }

    /// Builds the robot like [`Self::build_robot`], with additional targets.
    pub fn build_robot_with(&self, more: &[String]) -> Result<Box<dyn Robot>> {
        self.try_robot_with(more).map_err(|unbuilt| unbuilt.problems)
    }

    /// Builds the robot like [`Self::build_robot_with`]; the error shows whether targets are
    /// missing.
    pub fn try_robot_with(&self, more: &[String]) -> std::result::Result<Box<dyn Robot>, Unbuilt> {
        // an arm whose targets could not be read has some, and a test needs none
        let unread = self.unread.affects(&["join", "targets"]) || !self.identifies();
        let targets: Vec<String> = match unread && more.is_empty() {
            true => self.robot.targets_or("target"),
            false => self.file.join_targets().map(|t| t.get_ref()).chain(more).cloned().collect(),
        };
        let built = match self.robot.try_build(&targets) {
            // a robot without targets of its own
            Err(_) if targets.is_empty() && !self.file.stated_targets().is_empty() => {
                self.robot.try_build(&self.file.stated_targets())
            }
            built => built,
        };
        built.map_err(|unbuilt| Unbuilt {
            problems: unbuilt.problems.at(&self.key_place(&["join", "targets"])),
            ..unbuilt
        })
    }

    /// Poses of `calibration` and `validation`.
    pub fn selections(&self, identify: &Identify) -> Result<Selections> {
        let parse = |text: &Spanned<StatedPoses>| {
            Selection::parse(text.get_ref()).map_err(|m| Problems::from(m.at(self.place(text))))
        };
        let calibration = parse(&identify.calibration)?;
        let series = identify.series.iter().map(parse).collect::<Result<_>>()?;
        Ok(Selections { calibration, validation: identify.validation.as_ref().map(parse).transpose()?, series })
    }
}

/// Keys of `campaign.toml` that this campaign needs and does not give. A test to ISO 9283 needs
/// fewer keys than an identification.
fn missing_keys(text: &str) -> Vec<&'static str> {
    let all = toml_file::Stated::parse(text);
    let stated = |key: &&str| all.find(&[key]).is_some();
    let tests = ["repeatability", "poses", "stream", "compliance"].iter().any(stated);
    let geometric = stated(&"geometric");
    // leads, bars, balls and a complete geometric calibration need no log
    let identifies = !(tests || geometric) || ["log", "join", "identify", "observations"].iter().any(stated);
    let needed: &[&str] = match identifies {
        true if stated(&"observations") => &["robot", "identify"],
        true => &["robot", "export", "log", "join", "identify"],
        false if geometric || stated(&"repeatability") => &["robot", "export"],
        // a feature or a frame is of points of exports
        false if stated(&"export") => &["robot"],
        false => &[],
    };
    needed.iter().copied().filter(|key| !stated(key)).collect()
}

/// Reads a robot file on its own.
///
/// # Examples
///
/// ```
/// use etalon_campaign::read_robot;
/// use std::path::Path;
///
/// let file = read_robot(Path::new("../../samples/abb-irb120/robot.toml"))?;
/// let robot = file.build(&["SMR".to_owned()])?;
///
/// // joints at zero: by its drawing the flange is at x = 302 + 72 mm and z = 290 + 270 + 70 mm
/// let arm = robot.kinematics().expect("an arm has kinematics");
/// let flange = arm.tool_pose(&robot.nominal(), &[0.0; 6]).expect("a pose");
/// let [x_mm, _, z_mm] = flange.translation_mm;
/// assert!((x_mm - 374.0).abs() < 1e-9 && (z_mm - 630.0).abs() < 1e-9);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
pub fn read_robot(path: &Path) -> Result<RobotFile> {
    parse_robot(path, &files::read_text(path)?)
}

/// Reads the text of a robot.toml. `path` stands for its file: messages name it, and a URDF is
/// expected in the same folder.
///
/// # Errors
/// Fails like [`read_robot`].
pub fn parse_robot(path: &Path, text: &str) -> Result<RobotFile> {
    let questions = open_questions(&path.display().to_string(), text);
    if !questions.0.is_empty() {
        return Err(questions);
    }
    let (robot, problems) = RobotFile::recover(path, text);
    robot.filter(|_| problems.0.is_empty()).ok_or(problems)
}

/// Reads the text of a robot.toml and the text of the file that describes its robot.
///
/// # Errors
/// Fails like [`read_robot`].
pub fn parse_robot_with(path: &Path, text: &str, description: &str) -> Result<RobotFile> {
    RobotFile::with_description(path, text, description)
}

/// Reads the text of a URDF as the file of a robot.toml with this base link and this tool link.
///
/// # Errors
/// Fails like [`read_robot`].
pub fn parse_urdf_robot(text: &str, [base_link, tool_link]: [&str; 2]) -> Result<RobotFile> {
    RobotFile::from_urdf(text, [base_link, tool_link])
}

/// Reads a URDF file: its chain with the most moving joints, and its text.
pub fn read_urdf(path: &Path) -> Result<(TreeChain, String)> {
    let text = files::read_text(path)?;
    Ok((urdf::read(&path.display().to_string(), &text)?.longest_chain()?, text))
}

/// Reads a URDF file like [`read_urdf`]: a chain from the root for each list of moving joints.
pub fn read_urdf_chains(path: &Path) -> Result<(Vec<TreeChain>, String)> {
    let text = files::read_text(path)?;
    Ok((urdf::read(&path.display().to_string(), &text)?.tree.chains(), text))
}

/// Reads only the true parameters of a simulation, by name (mm, deg or 1), from a truth or from a
/// file without other keys.
pub fn read_true_parameters(path: &Path) -> Result<BTreeMap<String, f64>> {
    #[derive(serde::Deserialize)]
    struct Parameters {
        parameters: BTreeMap<String, f64>,
    }
    let numbers = json!({ "type": "object", "additionalProperties": { "type": "number" } });
    let schema = json!({ "type": "object", "properties": { "parameters": numbers }, "required": ["parameters"] });
    let text = files::read_text(path)?;
    Ok(toml_file::parse::<Parameters>(&path.display().to_string(), &text, &schema)?.parameters)
}

etalon_documents::schemas! {
    /// Name and JSON Schema of the files of a campaign.
    SCHEMAS in "../../schemas":
    "campaign.toml" CampaignFile,
    "robot.toml" RobotFile,
}
