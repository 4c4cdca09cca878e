//! Task of `etalon plan`.

use super::call::at_most;
use super::checks::check_positive;
use super::inputs::Inputs;
use super::model::ModelOptions;
use super::text_format::TableFormat;
use crate::stages::candidates::configurations;
use crate::stages::observe::joint_range::{self, Joints};
use crate::stages::remedies::remedied;
use crate::stages::table_file::TableFile;
use etalon_base::bounds::option_at_most;
use etalon_base::message::{Place, Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_campaign::RobotFile;
use etalon_documents::observability_summary;
use etalon_documents::*;
use etalon_formats::table::ASSEMBLY;
use etalon_identify::Observation;
use etalon_identify::plan::candidates::Candidates;
use etalon_identify::plan::order::{length_as_listed, order};
use etalon_identify::plan::{
    self, Criterion, PlaceError, Plan, Request, Setting, SizeStudy, index_of_poses, reference_point,
};
use etalon_robots::{Parameter, Robot};
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::collections::BTreeMap;

/// Number of identifications of a simulated calibration whose mean is evaluated (thesis, section
/// 4.6).
const STUDY_RUNS: u64 = 5;
/// Number of such means, the median of whose errors is reported; a single mean scatters by a third.
const STUDY_DRAWS: u64 = 20;

/// Criterion of a choice of poses, as an option gives it.
#[derive(Clone, Copy, Debug)]
pub struct Index(pub Criterion);

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

impl<'de> Deserialize<'de> for Index {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        clap::ValueEnum::from_str(&text, true).map_err(|_| {
            let names = Criterion::ALL.map(Criterion::name).join(", ");
            D::Error::custom(format!("unknown criterion `{text}`, expected one of {names}"))
        })
    }
}

/// Options of a plan.
#[derive(Clone, Debug, Default, clap::Args, Deserialize)]
#[serde(default)]
pub struct PlanOptions {
    /// Options for reading the table of candidates.
    #[command(flatten)]
    #[serde(flatten)]
    pub format: TableFormat,
    /// Choice of the poses.
    #[command(flatten)]
    #[serde(flatten)]
    pub search: SearchOptions,
    /// Standard uncertainty (k = 1) of one coordinate in micrometres, for predicted uncertainties.
    #[arg(long, value_name = "UM")]
    pub standard_uncertainty_um: Option<f64>,
    /// Planned identification.
    #[command(flatten)]
    #[serde(flatten)]
    pub model: ModelOptions,
}

/// Options of the choice of poses.
#[derive(Clone, Debug, clap::Args, Deserialize)]
#[serde(default)]
pub struct SearchOptions {
    /// Number of poses to choose.
    #[arg(long, value_name = "N")]
    pub positions: usize,
    /// Criterion to maximise: an observability index, or D-, A-, E- or I-optimality.
    #[arg(long, value_enum, default_value_t = Self::default().index, ignore_case = true)]
    pub index: Index,
    /// Choose configuration by configuration instead of pose by pose.
    #[arg(long)]
    pub single: bool,
    /// Choose all rows of a pose together (the default).
    #[arg(long, conflicts_with = "single")]
    pub grouped: bool,
    /// Poses from which the one-by-one choice starts; by default two distant poses.
    #[arg(long, value_name = "POSES", value_delimiter = ',', value_parser = pose)]
    pub start: Vec<PoseName>,
    /// Poses with which the plan is compared.
    #[arg(long, value_name = "POSES", value_delimiter = ',', value_parser = pose)]
    pub compare: Vec<PoseName>,
    /// Number of random starts of the exchange; by default 10, or none if a large problem is within
    /// 1 % of the bound.
    #[arg(long, value_name = "N", value_parser = option_at_most::<100_000>)]
    #[serde(deserialize_with = "at_most::<100_000, _>")]
    pub starts: Option<usize>,
    /// Maximum number of nodes of branch and bound; by default 4000, fewer for a large problem. The
    /// search ends when the choice is within 1 % of the bound.
    #[arg(long, value_name = "N", value_parser = option_at_most::<10_000_000>)]
    #[serde(deserialize_with = "at_most::<10_000_000, _>")]
    pub nodes: Option<usize>,
    /// Seed of the random starts, and of generated candidates.
    #[arg(long, default_value_t = Self::default().seed)]
    pub seed: u64,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self {
            positions: 0,
            index: Index(Criterion::O1),
            single: false,
            grouped: false,
            start: Vec::new(),
            compare: Vec::new(),
            starts: None,
            nodes: None,
            seed: 1,
        }
    }
}

impl PlanOptions {
    /// Checks the options before anything is read.
    pub(crate) fn check(&self) -> Result<()> {
        check_positive("--standard-uncertainty-um", self.standard_uncertainty_um)
    }

    fn request(&self) -> Request {
        let search = &self.search;
        Request {
            positions: search.positions,
            criterion: search.index.0,
            single: search.single,
            start: search.start.clone(),
            starts: search.starts.map(|starts| starts as u64),
            seed: search.seed,
            nodes: search.nodes,
        }
    }
}

/// A simulated calibration with the chosen poses.
pub(crate) struct Simulation {
    /// True values of the parameters.
    pub truth: Vec<f64>,
    /// Configurations at which errors are evaluated; by default the candidates.
    pub everywhere: Option<Vec<Observation>>,
}

/// Chooses the poses to measure among candidates.
///
/// # Errors
/// Fails for a table that does not belong to the robot, or with too few candidates.
pub fn plan(
    inputs: &Inputs,
    options: &PlanOptions,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> anyhow::Result<PlanDocument> {
    options.check()?;
    let (robot, candidates) = read_candidates(inputs.robot, &options.format.read_poses(inputs.table)?)?;
    let mut document = choose(robot.as_ref(), candidates, options, None, progress)?;
    document.provenance.inputs = inputs.sha256_by_name()?;
    Ok(document)
}

/// Chooses among candidates that are read; the document names no inputs.
pub(crate) fn choose(
    robot: &dyn Robot,
    candidates: Candidates,
    options: &PlanOptions,
    simulation: Option<Simulation>,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<PlanDocument> {
    let Candidates { observations, limit_violations } = candidates;
    let settings = options.model.settings(options.standard_uncertainty_um);
    let planned = plan::plan(robot, &observations, &settings, &options.request(), progress)
        .map_err(|error| Problems(limit_violations.iter().cloned().chain(remedied(error).0).collect()))?;
    let mut document = document(robot, &observations, &planned, options);
    if let (Some(Simulation { truth, everywhere }), Some(noise_um)) = (simulation, options.standard_uncertainty_um) {
        let everywhere = everywhere.as_ref().unwrap_or(&observations);
        let setting = Setting { truth, everywhere, runs: STUDY_RUNS, draws: STUDY_DRAWS, seed: options.search.seed };
        let studies = plan::study(robot, &planned, &observations, &settings, &setting).map_err(remedied)?;
        document.study = study_document(robot, &studies, &setting.truth, noise_um, everywhere.len());
    }
    document.messages.splice(0..0, limit_violations);
    Ok(document)
}

/// Reads a table of candidates: its robot with the named targets, and its configurations.
pub(crate) fn read_candidates(robot_file: &RobotFile, file: &TableFile) -> Result<(Box<dyn Robot>, Candidates)> {
    let here = |problems: Problems| file.place(problems);
    let targets = if file.table.has("target") { file.targets()? } else { Vec::new() };
    let robot = robot_file.build(&targets).map_err(here)?;
    joint_range::check_table(robot.as_ref(), &file.table, &[], Joints::Proposed).map_err(here)?;
    let mut found = configurations(robot.as_ref(), &file.table).map_err(here)?;
    found.limit_violations = found.limit_violations.map(|message| message.at(Place::file(file.name.as_str())));
    Ok((robot, found))
}

/// Document of a plan, without its inputs.
fn document(robot: &dyn Robot, observations: &[Observation], planned: &Plan, options: &PlanOptions) -> PlanDocument {
    let PlanOptions { search, standard_uncertainty_um, .. } = options;
    let pose = |c: usize| observations[planned.members[c][0]].pose;
    let configuration = |k: &usize| joint_values(robot, &observations[*k]);
    let chosen = planned.chosen.iter().map(|&c| PlannedPose {
        pose: pose(c),
        configurations: planned.members[c].iter().map(configuration).collect(),
    });
    let compared = (!search.compare.is_empty()).then(|| {
        let value = index_of_poses(planned, observations, search.index.0, &search.compare);
        let better_by_percent = 100.0 * (planned.index / value - 1.0);
        ComparedPoses { poses: search.compare.clone(), value, better_by_percent }
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
    let definition = search.index.0.definition();
    PlanDocument {
        schema: "etalon/plan/1".to_owned(),
        robot: robot.model().to_owned(),
        index: search.index.0.name().to_owned(),
        definition: definition.into(),
        grouped: !search.single,
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
            parameters: parameters(robot, planned, standard_uncertainty_um.is_some()),
            workspace: standard_uncertainty_um
                .map(|_| WorkspaceUncertainty { rms_mm: planned.workspace.0, max_mm: planned.workspace.1 }),
        },
        places: places(robot, observations, planned),
        study: None,
        messages,
        provenance: Provenance {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            inputs: BTreeMap::new(),
            seed: Some(search.seed),
        },
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

/// Parses a pose of an option.
fn pose(name: &str) -> std::result::Result<PoseName, String> {
    PoseName::new(name).map_err(|message| message.what)
}
