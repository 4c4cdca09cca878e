//! Command `etalon plan`.

mod generation;
mod program;

use super::inputs::Inputs;
use super::report::Reports;
use super::table_file::TableFile;
use super::text_format::TableFormat;
use super::{Verdict, answer, check_positive, pose_table, progress, remark};
use crate::simulate::true_values;
use crate::stages::candidates::configurations;
use crate::stages::observe::joint_range::{self, Joints};
use crate::stages::remedies::remedied;
use etalon_base::bounds::option_at_most;
use etalon_base::files;
use etalon_base::message::{Place, Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_campaign::{RobotFile, read_robot, read_true_parameters};
use etalon_documents::observability_summary;
use etalon_documents::*;
use etalon_formats::table::ASSEMBLY;
use etalon_identify::plan::candidates::Candidates;
use etalon_identify::plan::order::{length_as_listed, order};
use etalon_identify::plan::{
    Criterion, PlaceError, Plan, Request, Setting, SizeStudy, index_of_poses, plan, reference_point, study,
};
use etalon_identify::{Effects, Observation, Settings};
use etalon_report::Renderer;
use etalon_robots::{Parameter, Robot};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Number of identifications of a simulated calibration whose mean is evaluated (thesis, section
/// 4.6).
const STUDY_RUNS: u64 = 5;
/// Number of such means, the median of whose errors is reported; a single mean scatters by a third.
const STUDY_DRAWS: u64 = 20;

/// A criterion as a value on the command line.
#[derive(Clone, Copy, Debug)]
struct Index(Criterion);

impl clap::ValueEnum for Index {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [Index; Criterion::ALL.len()] = {
            let mut all = [Index(Criterion::O1); Criterion::ALL.len()];
            let mut i = 0;
            while i < all.len() {
                all[i] = Index(Criterion::ALL[i]);
                i += 1;
            }
            all
        };
        &ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(clap::builder::PossibleValue::new(self.0.name()).help(self.0.definition().to_string()))
    }
}

/// Choose the poses to measure among candidates, and prove their distance from the optimum.
#[derive(Debug, clap::Args)]
pub struct PlanCommand {
    /// Robot file.
    #[arg(long)]
    robot: PathBuf,
    /// Candidates: CSV with pose and one column per joint with its unit [and target, assembly]; or
    /// pose,x_mm,y_mm for robots that find their own working modes. Rows of one pose are measured
    /// together.
    #[arg(long, required_unless_present = "generate", conflicts_with = "generate")]
    candidates: Option<PathBuf>,
    #[command(flatten)]
    format: TableFormat,
    #[command(flatten)]
    search: SearchOptions,
    #[command(flatten)]
    model: ModelOptions,
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

/// Options of the planned identification.
#[derive(Clone, Debug, clap::Args)]
struct ModelOptions {
    /// Standard uncertainty (k = 1) of one coordinate in micrometres, for predicted uncertainties.
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Hold a parameter at its nominal value; `*` stands for any text; may be repeated.
    #[arg(long, value_name = "NAME")]
    hold: Vec<String>,
    /// Effects to identify: `all`, or a list of zeros, geometry, gains, harmonics, backlash,
    /// coupling, bending, payload, torque, expansion, drift, lateral, pedestal; by default all
    /// effects in the robot file except gains of revolute joints of arms and payload to
    /// pedestal.
    #[arg(long, value_parser = super::identify::effects, value_name = "EFFECTS", default_value = "usual")]
    effects: Effects,
    /// Use of nominal values: as observations with their tolerances, or as starting values of plain
    /// least squares.
    #[arg(long, value_enum, default_value_t)]
    prior: super::identify::PriorOption,
}

/// Options of the choice of poses.
#[derive(Clone, Debug, clap::Args)]
struct SearchOptions {
    /// Number of poses to choose.
    #[arg(long, value_name = "N")]
    positions: usize,
    /// Criterion to maximise: an observability index, or D-, A-, E- or I-optimality.
    #[arg(long, value_enum, default_value = "O1", ignore_case = true)]
    index: Index,
    /// Choose configuration by configuration instead of pose by pose.
    #[arg(long)]
    single: bool,
    /// Choose all rows of a pose together (the default).
    #[arg(long, conflicts_with = "single")]
    grouped: bool,
    /// Poses from which the one-by-one choice starts; by default two distant poses.
    #[arg(long, value_name = "POSES", value_delimiter = ',', value_parser = pose)]
    start: Vec<PoseName>,
    /// Poses with which the plan is compared.
    #[arg(long, value_name = "POSES", value_delimiter = ',', value_parser = pose)]
    compare: Vec<PoseName>,
    /// Number of random starts of the exchange; by default 10, or none if a large problem is within
    /// 1 % of the bound.
    #[arg(long, value_name = "N", value_parser = option_at_most::<100_000>)]
    starts: Option<usize>,
    /// Maximum number of nodes of branch and bound; by default 4000, fewer for a large problem, and
    /// none as soon as it is within 1 % of the bound.
    #[arg(long, value_name = "N", value_parser = option_at_most::<10_000_000>)]
    nodes: Option<usize>,
    /// Seed of the random starts, and of generated candidates.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

impl PlanCommand {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        check_positive("--standard-uncertainty-um", self.model.standard_uncertainty_um)?;
        let written =
            [self.written.poses.as_ref(), self.written.targets.as_ref(), self.program.file()].into_iter().flatten();
        files::refuse_overwriting(written, self.inputs())?;
        self.reports.check(self.inputs())?;
        let robot_file = read_robot(&self.robot)?;
        let (robot, candidates, generated) = self.candidates(&robot_file)?;
        self.program.check(robot.as_ref())?;
        let elsewhere = |path: &PathBuf| read_candidates(&robot_file, &self.format.read_poses(path)?);
        let elsewhere = self.simulation.workspace.as_ref().map(elsewhere).transpose()?;
        let everywhere = elsewhere.map(|(_, all)| all.observations);
        let inputs = files::sha256_by_name(self.inputs())?;
        let mut document = self.planned(robot.as_ref(), candidates, everywhere, inputs)?;
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
            remark(&document.messages);
        }
        answer(&renderer, self.json.then(|| to_json(&document)).transpose()?)
    }

    /// The robot with its candidates: those of a table, or generated ones.
    fn candidates(&self, file: &RobotFile) -> Result<generation::Drawn> {
        if let Some(drawn) = self.generation.candidates(file, self.search.seed)? {
            return Ok(drawn);
        }
        // clap demands one of both
        let path = self.candidates.clone().unwrap_or_default();
        let (robot, candidates) = read_candidates(file, &self.format.read_poses(&path)?)?;
        Ok((robot, candidates, None))
    }

    /// The answer from candidates in memory. Nothing is written.
    pub(super) fn in_memory(&self, given: &Inputs) -> anyhow::Result<PlanDocument> {
        check_positive("--standard-uncertainty-um", self.model.standard_uncertainty_um)?;
        let file = self.format.parse_poses(given.table.name, given.table.text)?;
        let (robot, candidates) = read_candidates(given.robot, &file)?;
        self.planned(robot.as_ref(), candidates, None, given.inputs())
    }

    fn planned(
        &self,
        robot: &dyn Robot,
        candidates: Candidates,
        everywhere: Option<Vec<Observation>>,
        inputs: BTreeMap<String, String>,
    ) -> anyhow::Result<PlanDocument> {
        let Candidates { observations, limit_violations } = candidates;
        let settings = self.settings();
        let request = Request {
            positions: self.search.positions,
            criterion: self.search.index.0,
            single: self.search.single,
            start: self.search.start.clone(),
            starts: self.search.starts.map(|starts| starts as u64),
            seed: self.search.seed,
            nodes: self.search.nodes,
        };
        let planned = plan(robot, &observations, &settings, &request, &progress)
            .map_err(|error| Problems(limit_violations.iter().cloned().chain(remedied(error).0).collect()))?;
        let everywhere = everywhere.as_ref().unwrap_or(&observations);
        let study = self.study(robot, [&observations, everywhere], &planned)?;
        let mut document = self.document(robot, &observations, &planned, inputs)?;
        document.study = study;
        document.messages.splice(0..0, limit_violations);
        Ok(document)
    }

    /// Input files.
    fn inputs(&self) -> impl Iterator<Item = &PathBuf> + Clone {
        std::iter::once(&self.robot)
            .chain(&self.candidates)
            .chain(&self.simulation.truth)
            .chain(&self.simulation.workspace)
    }

    /// Settings of the planned identification.
    fn settings(&self) -> Settings {
        Settings {
            standard_uncertainty_mm: self.model.standard_uncertainty_um.map(|u| u / 1000.0),
            hold: self.model.hold.clone(),
            prior: self.model.prior.into(),
            effects: self.model.effects.clone(),
            ..Settings::default()
        }
    }

    /// Simulates a calibration if a truth is stated.
    fn study(
        &self,
        robot: &dyn Robot,
        [observations, everywhere]: [&[Observation]; 2],
        planned: &Plan,
    ) -> anyhow::Result<Option<StudyDocument>> {
        let (Some(path), Some(noise_um)) = (&self.simulation.truth, self.model.standard_uncertainty_um) else {
            return Ok(None);
        };
        let truth = true_values(robot, &read_true_parameters(path)?)?;
        let setting = Setting { truth, everywhere, runs: STUDY_RUNS, draws: STUDY_DRAWS, seed: self.search.seed };
        let studies = study(robot, planned, observations, &self.settings(), &setting).map_err(remedied)?;
        Ok(study_document(robot, &studies, &setting.truth, noise_um, everywhere.len()))
    }
}

/// Reads a table of candidates: its robot with the named targets, and its configurations.
pub(super) fn read_candidates(robot_file: &RobotFile, file: &TableFile) -> Result<(Box<dyn Robot>, Candidates)> {
    let here = |problems: Problems| file.place(problems);
    let targets = if file.table.has("target") { file.targets()? } else { Vec::new() };
    let robot = robot_file.build(&targets).map_err(here)?;
    joint_range::check_table(robot.as_ref(), &file.table, &[], Joints::Proposed).map_err(here)?;
    let mut found = configurations(robot.as_ref(), &file.table).map_err(here)?;
    found.limit_violations = found.limit_violations.map(|message| message.at(Place::file(file.name.as_str())));
    Ok((robot, found))
}

impl PlanCommand {
    fn document(
        &self,
        robot: &dyn Robot,
        observations: &[Observation],
        planned: &Plan,
        inputs: BTreeMap<String, String>,
    ) -> Result<PlanDocument> {
        let pose = |c: usize| observations[planned.members[c][0]].pose;
        let configuration = |k: &usize| joint_values(robot, &observations[*k]);
        let chosen = planned.chosen.iter().map(|&c| PlannedPose {
            pose: pose(c),
            configurations: planned.members[c].iter().map(configuration).collect(),
        });
        let compared = (!self.search.compare.is_empty()).then(|| {
            let value = index_of_poses(planned, observations, self.search.index.0, &self.search.compare);
            let better_by_percent = 100.0 * (planned.index / value - 1.0);
            ComparedPoses { poses: self.search.compare.clone(), value, better_by_percent }
        });
        let percent = |bound: Option<f64>| bound.map(|b| (100.0 * (1.0 - planned.index / b)).max(0.0));
        let below = planned.at_most_below_percent();
        let curve = planned.curve.iter().map(|s| CurvePoint {
            positions: s.positions,
            configurations: s.configurations,
            value: s.index,
            condition: s.condition,
        });
        let mut messages = etalon_documents::warning_messages(&planned.sensitivity.messages);
        messages.extend(planned.prediction.messages.clone());
        let definition = self.search.index.0.definition();
        Ok(PlanDocument {
            schema: "etalon/plan/1".to_owned(),
            robot: robot.model().to_owned(),
            index: self.search.index.0.name().to_owned(),
            definition: definition.into(),
            grouped: !self.search.single,
            choice: PlanChoice {
                candidates: planned.members.len(),
                configurations: observations.len(),
                chosen: chosen.collect(),
                order: Some(measuring_order(robot, observations, planned)),
                generated: None,
                program: None,
            },
            optimality: PlanOptimality {
                value: planned.index,
                bound: planned.bound,
                at_most_below_percent: below,
                // up to rounding
                proven_optimal: below.is_some_and(|b| b < 1e-6),
                at_most_below_percent_by_relaxation: percent(planned.relaxation_bound),
                nodes: planned.nodes,
                greedy: GreedySummary {
                    poses: planned.greedy.iter().map(|&c| pose(c)).collect(),
                    value: planned.greedy_index,
                    curve: curve.collect(),
                    knee_configurations: planned.knee().map(|k| k.configurations),
                },
                compared,
            },
            prediction: PlanPrediction {
                observability: planned.prediction.observability.as_ref().map(|o| observability_summary(robot, o)),
                parameters: parameters(robot, planned, self.model.standard_uncertainty_um.is_some()),
                workspace: self
                    .model
                    .standard_uncertainty_um
                    .map(|_| WorkspaceUncertainty { rms_mm: planned.workspace.0, max_mm: planned.workspace.1 }),
            },
            places: places(robot, observations, planned),
            study: None,
            messages,
            provenance: Provenance {
                version: env!("CARGO_PKG_VERSION").to_owned(),
                inputs,
                seed: Some(self.search.seed),
            },
        })
    }
}

/// Order of the chosen poses that shortens the motion of the joints.
fn measuring_order(robot: &dyn Robot, observations: &[Observation], planned: &Plan) -> MeasuringOrder {
    let n = robot.joints().len();
    let values = |k: &usize| observations[*k].joints[..n].to_vec();
    let ends = |members: &Vec<usize>| [members.first(), members.last()].map(|k| k.map(values).unwrap_or_default());
    let points: Vec<[Vec<f64>; 2]> = planned.chosen.iter().map(|&c| ends(&planned.members[c])).collect();
    let span = |j: usize| {
        let column = observations.iter().map(|o| o.joints[j]);
        column.clone().fold(f64::NEG_INFINITY, f64::max) - column.fold(f64::INFINITY, f64::min)
    };
    let spans: Vec<f64> = (0..n).map(span).collect();
    let best = order(&points, &spans);
    MeasuringOrder { indices: best.points, motion: best.length, motion_as_listed: length_as_listed(&points, &spans) }
}

/// Positions of the candidates.
fn places(robot: &dyn Robot, observations: &[Observation], planned: &Plan) -> Vec<CandidatePlace> {
    let nominal = robot.nominal();
    let place = |(c, members): (usize, &Vec<usize>)| {
        let first = &observations[members[0]];
        CandidatePlace {
            pose: first.pose,
            at_mm: robot.position(&nominal, &first.joints, 0),
            configurations: members.len(),
            chosen: planned.chosen.contains(&c),
        }
    };
    planned.members.iter().enumerate().map(place).collect()
}

/// Document of studies for increasing numbers of positions; the last has all positions.
fn study_document(
    robot: &dyn Robot,
    studies: &[SizeStudy],
    truth: &[f64],
    noise_um: f64,
    configurations: usize,
) -> Option<StudyDocument> {
    let last = studies.last()?;
    let parameter = |(i, p): (usize, &Parameter)| StudiedParameter {
        name: p.name.clone(),
        unit: p.quantity.unit().to_owned(),
        nominal: p.quantity.outward(p.nominal),
        actual: p.quantity.outward(truth[i]),
        identified: p.quantity.outward(last.identified[i]),
    };
    let step = |s: &SizeStudy| StudyStep {
        positions: s.positions,
        configurations: s.configurations,
        rms_before_mm: s.rms_mm.0,
        max_before_mm: s.max_mm.0,
        rms_mm: s.rms_mm.1,
        max_mm: s.max_mm.1,
    };
    let place =
        |p: &PlaceError| StudiedPlace { pose: p.pose, at_mm: p.at_mm, max_before_mm: p.before_mm, max_mm: p.after_mm };
    Some(StudyDocument {
        runs: STUDY_RUNS,
        draws: STUDY_DRAWS,
        noise_um,
        configurations,
        point: reference_point(robot).into(),
        parameters: robot.parameters().iter().enumerate().map(parameter).collect(),
        steps: studies.iter().map(step).collect(),
        places: last.places.iter().map(place).collect(),
    })
}

fn parameters(robot: &dyn Robot, planned: &Plan, stated: bool) -> Vec<PlannedParameter> {
    let (free, n) = (&planned.sensitivity.free, planned.sensitivity.free.len());
    let held = planned.sensitivity.groups.iter().map(|g| g.with.iter().chain([&g.held]).copied().collect::<Vec<_>>());
    let sets: Vec<Vec<usize>> = held.chain(planned.prediction.weak.iter().map(|w| w.parameters.clone())).collect();
    let parameter = |(i, p): (usize, &Parameter)| {
        let place = free.iter().position(|&f| f == i);
        let uncertainty = place.filter(|_| stated).map(|k| planned.prediction.covariance[k * n + k].sqrt());
        let mut others: Vec<usize> =
            sets.iter().filter(|s| s.contains(&i)).flatten().copied().filter(|&j| j != i).collect();
        others.sort_unstable();
        others.dedup();
        PlannedParameter {
            name: p.name.clone(),
            unit: p.quantity.unit().to_owned(),
            identifiable: place.is_some(),
            standard_uncertainty: uncertainty.map(|u| p.quantity.outward(u)),
            confounded_with: others.into_iter().map(|j| robot.parameters()[j].name.clone()).collect(),
        }
    };
    robot.parameters().iter().enumerate().map(parameter).collect()
}

/// Joint values, directions of approach and assembly mode of a configuration, by column.
fn joint_values(robot: &dyn Robot, o: &Observation) -> BTreeMap<String, f64> {
    let joints = robot.joints().iter().zip(&o.joints).map(|(j, q)| (j.column(), j.quantity.outward(*q)));
    let directions = o.joints[robot.joints().len()..].iter();
    let directions =
        robot.approached().iter().zip(directions).map(|(&k, d)| (robot.joints()[k].direction_column(), *d));
    let mode = robot.has_assembly_modes().then(|| o.joints.last().map(|m| (ASSEMBLY.to_owned(), *m))).flatten();
    joints.chain(directions).chain(mode).collect()
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

/// Parses a pose of an option.
fn pose(name: &str) -> std::result::Result<PoseName, String> {
    PoseName::new(name).map_err(|message| message.what)
}
