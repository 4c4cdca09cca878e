//! Command `etalon plan`.

mod generation;
mod program;

use super::report::Reports;
use super::{Output, Verdict, pose_table, progress};
use crate::simulate::true_values;
use crate::tasks::{PlanOptions, Simulation, Table, choose, read_candidates};
use etalon_base::files;
use etalon_base::message::Result;
use etalon_campaign::{RobotFile, read_robot, read_true_parameters};
use etalon_documents::{PlanDocument, Presentation, to_json};
use etalon_formats::table::ASSEMBLY;
use etalon_report::Renderer;
use etalon_robots::Robot;
use std::path::PathBuf;

/// Choose the poses to measure among candidates, with a bound of the distance from the optimum.
#[derive(Debug, clap::Args)]
pub struct PlanCommand {
    /// Robot file.
    #[arg(long)]
    robot: PathBuf,
    /// Candidates: CSV with pose and one column per joint with its unit [and target, assembly]; or
    /// pose,x_mm,y_mm for robots whose working modes are computed. Rows of one pose are measured
    /// together.
    #[arg(long, required_unless_present = "generate", conflicts_with = "generate")]
    candidates: Option<PathBuf>,
    #[command(flatten)]
    options: PlanOptions,
    #[command(flatten)]
    written: WrittenFiles,
    #[command(flatten)]
    generation: generation::Generation,
    #[command(flatten)]
    program: program::Program,
    #[command(flatten)]
    reports: Reports,
    #[command(flatten)]
    simulation: SimulationOptions,
    /// Print plan.json instead of a table.
    #[arg(long)]
    json: bool,
}

/// Options of a simulated calibration.
#[derive(Clone, Debug, clap::Args)]
struct SimulationOptions {
    /// Simulate a calibration with the chosen poses, for a robot with the [parameters] of this TOML
    /// file.
    #[arg(long, value_name = "FILE", requires = "standard_uncertainty_um")]
    truth: Option<PathBuf>,
    /// Positions at which the errors of the simulation are evaluated, in the form of the
    /// candidates; by default the candidates.
    #[arg(long, value_name = "FILE", requires = "truth")]
    workspace: Option<PathBuf>,
}

/// Files with the chosen configurations.
#[derive(Clone, Debug, clap::Args)]
struct WrittenFiles {
    /// Write the chosen configurations to a CSV file, in the order of measurement.
    #[arg(long, value_name = "FILE")]
    poses: Option<PathBuf>,
    /// Write the chosen configurations as targets of a controller: `.json` or `.h` (C header).
    #[arg(long, value_name = "FILE")]
    targets: Option<PathBuf>,
}

impl PlanCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        self.options.check()?;
        let written =
            [self.written.poses.as_ref(), self.written.targets.as_ref(), self.program.file()].into_iter().flatten();
        files::refuse_overwriting(written, self.inputs())?;
        self.reports.check(self.inputs())?;
        let robot_file = read_robot(&self.robot)?;
        let (robot, candidates, generated) = self.candidates(&robot_file)?;
        self.program.check(robot.as_ref())?;
        let simulation = self.simulation(&robot_file, robot.as_ref())?;
        let mut document = choose(robot.as_ref(), candidates, &self.options, simulation, &progress)?;
        document.provenance.inputs = files::sha256_by_name(self.inputs())?;
        document.choice.generated = generated;
        self.program.complete(robot.as_ref(), &mut document)?;
        if let Some(path) = &self.written.poses {
            files::write(path, csv(robot.as_ref(), &document).as_bytes())?;
        }
        let name = robot_file.name.as_deref().unwrap_or(robot.model());
        self.program.write(robot.as_ref(), name, &document)?;
        if let Some(path) = &self.written.targets {
            files::write(path, &etalon_controllers::targets(&document, &path.display().to_string())?)?;
        }
        let renderer = Renderer::plan(&document, self.reports.over(Presentation::default())?)?;
        self.reports.write(&renderer)?;
        if !self.json {
            out.remark(&document.messages);
        }
        out.answer(&renderer, self.json.then(|| to_json(&document)).transpose()?)
    }

    /// The robot with its candidates, which come from a table or are generated.
    fn candidates(&self, file: &RobotFile) -> Result<generation::Drawn> {
        if let Some(drawn) = self.generation.candidates(file, self.options.search.seed)? {
            return Ok(drawn);
        }
        // clap demands one of both
        let path = self.candidates.clone().unwrap_or_default();
        let (robot, candidates) = read_candidates(file, &self.options.format.read_poses(Table::File(&path))?)?;
        Ok((robot, candidates, None))
    }

    /// The simulated calibration, if a truth is given.
    fn simulation(&self, file: &RobotFile, robot: &dyn Robot) -> Result<Option<Simulation>> {
        let SimulationOptions { truth: Some(truth), workspace } = &self.simulation else { return Ok(None) };
        let truth = true_values(robot, &read_true_parameters(truth)?)?;
        let read = |path: &PathBuf| read_candidates(file, &self.options.format.read_poses(Table::File(path))?);
        let everywhere = workspace.as_ref().map(read).transpose()?.map(|(_, all)| all.observations);
        Ok(Some(Simulation { truth, everywhere }))
    }

    /// Input files.
    fn inputs(&self) -> impl Iterator<Item = &PathBuf> + Clone {
        std::iter::once(&self.robot)
            .chain(&self.candidates)
            .chain(&self.simulation.truth)
            .chain(&self.simulation.workspace)
    }
}

/// Chosen configurations as a table in the order of measurement, usable as candidates or as targets
/// of a controller.
fn csv(robot: &dyn Robot, document: &PlanDocument) -> String {
    let joints = robot.joints().iter().map(|j| j.column());
    let directions = robot.approached().iter().map(|&k| robot.joints()[k].direction_column());
    let modes = robot.has_assembly_modes().then(|| ASSEMBLY.to_owned());
    let columns: Vec<String> = joints.chain(directions).chain(modes).collect();
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let poses = document.in_order().into_iter();
    pose_table(&columns, poses.flat_map(|p| p.configurations.iter().map(|c| (&p.pose, c))))
}
