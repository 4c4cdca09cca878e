//! `etalon plan`

mod document;
mod text;

use super::report::Dressed;
use super::table_file::TableFile;
use super::{Verdict, print, say};
use crate::base::files;
use crate::base::message::{Message, Place, Problems, Result};
use crate::campaign::{RobotFile, read_robot, read_true_parameters};
use crate::document::{Presentation, StudyDocument};
use crate::export;
use crate::math::identify::{Observation, ResidualKind, Settings};
use crate::math::plan::candidates::{self, Candidates};
use crate::math::plan::{Criterion, Plan as Planned, Request, Setting, plan, study};
use crate::math::robots::Robot;
use crate::report;
use crate::run::output;
use crate::simulate::true_values;
use std::path::{Path, PathBuf};
use text::{as_text, csv};

/// Identifications of a simulated calibration, whose mean counts (section 4.6).
const STUDY_RUNS: u64 = 5;
/// Such means, whose errors' medians are told: one alone scatters by a third.
const STUDY_DRAWS: u64 = 20;

/// Choose the poses to measure among candidates, and prove how far they are from the best
#[derive(Debug, clap::Args)]
pub struct Plan {
    /// Robot file
    #[arg(long)]
    robot: PathBuf,
    /// Candidates: CSV with pose and one column per joint with its unit [and target, assembly]; or pose,x_mm,y_mm for
    /// robots that find their own working modes. Rows of one pose are measured together
    #[arg(long)]
    candidates: PathBuf,
    /// How many poses to choose
    #[arg(long, value_name = "N")]
    positions: usize,
    /// What to maximise: an observability index, or D-, A-, E- or I-optimality
    #[arg(long, value_enum, default_value = "O1", ignore_case = true)]
    index: Criterion,
    /// Choose configuration by configuration instead of pose by pose
    #[arg(long)]
    single: bool,
    /// All rows of a pose come together (the default)
    #[arg(long, conflicts_with = "single")]
    grouped: bool,
    /// Poses from which the thesis' way starts; by default two that are far apart
    #[arg(long, value_name = "POSES", value_delimiter = ',')]
    start: Vec<i64>,
    /// Poses to compare the plan with
    #[arg(long, value_name = "POSES", value_delimiter = ',')]
    compare: Vec<i64>,
    /// Random starts of the exchange
    #[arg(long, value_name = "N", default_value_t = 10)]
    starts: u64,
    /// Nodes that branch and bound may look at to close the gap
    #[arg(long, value_name = "N", default_value_t = 2000)]
    nodes: usize,
    /// Seed of the random starts
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Standard uncertainty (k = 1) of one coordinate in micrometres, for predicted uncertainties
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Hold a parameter at its nominal value; `*` stands for any text; may be repeated
    #[arg(long, value_name = "NAME")]
    hold: Vec<String>,
    /// Write the chosen configurations to a CSV file
    #[arg(long, value_name = "FILE")]
    poses: Option<PathBuf>,
    /// Write the chosen configurations as targets of a controller: `.json` or `.h` (C header)
    #[arg(long, value_name = "FILE")]
    targets: Option<PathBuf>,
    /// Write a report with pictures
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    #[command(flatten)]
    dressed: Dressed,
    /// Simulate a calibration with the chosen poses, of a robot with the [parameters] of this TOML file
    #[arg(long, value_name = "FILE", requires = "standard_uncertainty_um")]
    truth: Option<PathBuf>,
    /// Positions over which errors of that simulation are told, in the form of the candidates; by default the candidates
    #[arg(long, value_name = "FILE", requires = "truth")]
    workspace: Option<PathBuf>,
    /// Print plan.json instead of a table
    #[arg(long)]
    json: bool,
}

impl Plan {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        if self.standard_uncertainty_um.is_some_and(|u| !(u > 0.0 && u.is_finite())) {
            return Err(Problems::from(Message::error("--standard-uncertainty-um must be positive")).into());
        }
        let robot_file = read_robot(&self.robot)?;
        let (robot, Candidates { observations, beyond }) = read(&robot_file, &self.candidates)?;
        let settings = Settings {
            kind: ResidualKind::Targets,
            standard_uncertainty_mm: self.standard_uncertainty_um.map(|u| u / 1000.0),
            common_uncertainty_mm: None,
            hold: self.hold.clone(),
        };
        let request = Request {
            positions: self.positions,
            criterion: self.index,
            single: self.single,
            start: self.start.clone(),
            starts: self.starts,
            seed: self.seed,
            nodes: self.nodes,
        };
        let planned = plan(robot.as_ref(), &observations, &settings, &request)
            .map_err(|more| Problems(beyond.iter().cloned().chain(more.0).collect()))?;
        let study = self.study(robot.as_ref(), &robot_file, (&observations, &planned), &settings)?;
        let mut document = self.document(robot.as_ref(), &observations, &planned, study)?;
        document.messages.splice(0..0, beyond);
        if let Some(path) = &self.poses {
            files::write(path, csv(robot.as_ref(), &document).as_bytes())?;
        }
        if let Some(path) = &self.targets {
            files::write(path, &export::targets(&document, &path.display().to_string())?)?;
        }
        if let Some(path) = &self.report {
            files::write(path, report::plan_html(&document, &self.dressed.over(Presentation::default())?)?.as_bytes())?;
        }
        if self.json {
            print(output::to_json(&document)?)?;
        } else {
            for message in &document.messages {
                say(format_args!("{message}\n"));
            }
            print(as_text(&document))?;
        }
        Ok(Verdict::Met)
    }

    /// A simulated calibration, where a truth is stated.
    fn study(
        &self,
        robot: &dyn Robot,
        robot_file: &RobotFile,
        (observations, planned): (&[Observation], &Planned),
        settings: &Settings,
    ) -> anyhow::Result<Option<StudyDocument>> {
        let (Some(path), Some(noise_um)) = (&self.truth, self.standard_uncertainty_um) else { return Ok(None) };
        let truth = true_values(robot, &read_true_parameters(path)?)?;
        let elsewhere = self.workspace.as_ref().map(|path| read(robot_file, path)).transpose()?;
        let everywhere = elsewhere.as_ref().map_or(observations, |(_, all)| &all.observations);
        let setting = Setting { truth, runs: STUDY_RUNS, draws: STUDY_DRAWS, seed: self.seed };
        let studies = study(robot, planned, observations, everywhere, settings, &setting)?;
        Ok(document::study_document(robot, &studies, &setting.truth, noise_um, everywhere.len()))
    }
}

/// The robot with the targets that a table of candidates names, and its configurations.
fn read(robot_file: &RobotFile, path: &Path) -> Result<(Box<dyn Robot>, Candidates)> {
    let file = TableFile::read(path)?;
    let here = |problems: Problems| file.place(problems);
    let targets = if file.table.column("target").is_ok() { file.targets()? } else { Vec::new() };
    let robot = robot_file.build(&targets).map_err(here)?;
    let mut found = candidates::configurations(robot.as_ref(), &file.table).map_err(here)?;
    found.beyond = found.beyond.map(|message| message.at(Place::file(file.name.as_str())));
    Ok((robot, found))
}
