//! `etalon plan`

use super::{Verdict, print, say};
use crate::campaign::read_robot;
use crate::document::*;
use crate::identify::{Observation, ResidualKind, Settings};
use crate::message::{Message, Problems};
use crate::parameters::observability_summary;
use crate::plan::{Criterion, Plan as Planned, Request, candidates, index_of, plan};
use crate::robots::Robot;
use crate::table::ASSEMBLY;
use crate::{files, import, output, table};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

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
    #[arg(long, value_name = "N", default_value_t = 500)]
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
        let (file, text) = (self.candidates.display().to_string(), files::read_text(&self.candidates)?);
        let read = import::observations(&file, &text)?;
        let here = |problems: Problems| problems.in_text(&file, &text);
        let mut targets: Vec<String> = Vec::new();
        if read.column("target").is_ok() {
            for name in table::texts(&read, "target")? {
                if !targets.contains(&name) {
                    targets.push(name);
                }
            }
        }
        let robot = robot_file.build(&targets).map_err(here)?;
        let observations = candidates::configurations(robot.as_ref(), &read).map_err(here)?;
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
        let planned = plan(robot.as_ref(), &observations, &settings, &request)?;
        let document = self.document(robot.as_ref(), &observations, &planned)?;
        if let Some(path) = &self.poses {
            files::write(path, csv(robot.as_ref(), &document).as_bytes())?;
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

    fn document(
        &self,
        robot: &dyn Robot,
        observations: &[Observation],
        planned: &Planned,
    ) -> anyhow::Result<PlanDocument> {
        let pose = |c: usize| observations[planned.members[c][0]].pose;
        let configuration = |k: &usize| joint_values(robot, &observations[*k]);
        let chosen = planned.chosen.iter().map(|&c| PlannedPose {
            pose: pose(c),
            configurations: planned.members[c].iter().map(configuration).collect(),
        });
        let mut inputs = BTreeMap::new();
        for path in [&self.robot, &self.candidates] {
            inputs.insert(path.display().to_string(), files::sha256(&files::read(path)?));
        }
        let compared = (!self.compare.is_empty()).then(|| {
            let value = index_of(planned, observations, self.index, &self.compare);
            let better_by_percent = 100.0 * (planned.index / value - 1.0);
            ComparedPoses { poses: self.compare.clone(), value, better_by_percent }
        });
        let percent = |bound: Option<f64>| bound.map(|b| (100.0 * (1.0 - planned.index / b)).max(0.0));
        let below = planned.at_most_below_percent();
        let curve = planned.curve.iter().map(|s| CurvePoint {
            positions: s.positions,
            configurations: s.configurations,
            value: s.index,
            condition: s.condition,
        });
        let mut messages = planned.sensitivity.messages.clone();
        messages.extend(planned.prediction.messages.clone());
        Ok(PlanDocument {
            schema: "etalon/plan/1".to_owned(),
            robot: robot.model().to_owned(),
            index: format!("{:?}", self.index),
            definition: self.index.definition().to_owned(),
            grouped: !self.single,
            candidates: planned.members.len(),
            configurations: observations.len(),
            chosen: chosen.collect(),
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
            observability: planned.prediction.observability.as_ref().map(observability_summary),
            parameters: parameters(robot, planned, self.standard_uncertainty_um.is_some()),
            workspace: self
                .standard_uncertainty_um
                .map(|_| WorkspaceUncertainty { rms_mm: planned.workspace.0, max_mm: planned.workspace.1 }),
            messages,
            provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs, seed: Some(self.seed) },
        })
    }
}

fn parameters(robot: &dyn Robot, planned: &Planned, stated: bool) -> Vec<PlannedParameter> {
    let (free, n) = (&planned.sensitivity.free, planned.sensitivity.free.len());
    let held = planned.sensitivity.groups.iter().map(|g| g.with.iter().chain([&g.held]).copied().collect::<Vec<_>>());
    let sets: Vec<Vec<usize>> = held.chain(planned.prediction.weak.iter().map(|w| w.parameters.clone())).collect();
    let parameter = |(i, p): (usize, &crate::robots::Parameter)| {
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

fn joint_values(robot: &dyn Robot, o: &Observation) -> BTreeMap<String, f64> {
    let joints = robot.joints().iter().zip(&o.joints).map(|(j, q)| (j.column(), j.quantity.outward(*q)));
    let mode = robot.has_assembly_modes().then(|| o.joints.last().map(|m| (ASSEMBLY.to_owned(), *m))).flatten();
    joints.chain(mode).collect()
}

/// The chosen configurations as a table: candidates again, or targets of a controller.
fn csv(robot: &dyn Robot, document: &PlanDocument) -> String {
    let mut columns: Vec<String> = robot.joints().iter().map(|j| j.column()).collect();
    columns.extend(robot.has_assembly_modes().then(|| ASSEMBLY.to_owned()));
    let mut text = format!("pose,{}\n", columns.join(","));
    for planned in &document.chosen {
        for configuration in &planned.configurations {
            let cells: Vec<String> = columns.iter().filter_map(|c| Some(configuration.get(c)?.to_string())).collect();
            let _ = writeln!(text, "{},{}", planned.pose, cells.join(","));
        }
    }
    text
}

fn as_text(document: &PlanDocument) -> String {
    let list = |poses: &[i64]| poses.iter().map(i64::to_string).collect::<Vec<_>>().join(", ");
    let chosen: Vec<i64> = document.chosen.iter().map(|p| p.pose).collect();
    let count: usize = document.chosen.iter().map(|p| p.configurations.len()).sum();
    let mut text = format!("poses: {} ({count} configurations)\n", list(&chosen));
    let _ = writeln!(text, "{} = {:.6} ({})", document.index, document.value, document.definition);
    let _ = match document.at_most_below_percent {
        _ if document.proven_optimal => {
            writeln!(
                text,
                "proven: no other choice of {} of {} candidates is better",
                chosen.len(),
                document.candidates
            )
        }
        Some(below) => writeln!(
            text,
            "at most {below:.2} % below the best possible choice of {} of {} candidates",
            chosen.len(),
            document.candidates
        ),
        None => writeln!(text, "no bound is known for this index: another choice may be better"),
    };
    let greedy = &document.greedy;
    let _ =
        writeln!(text, "one after the other: {} = {:.6}, poses {}", document.index, greedy.value, list(&greedy.poses));
    if let Some(c) = &document.compared {
        let _ = writeln!(
            text,
            "poses {}: {} = {:.6}; the plan is {:.1} % better",
            list(&c.poses),
            document.index,
            c.value,
            c.better_by_percent
        );
    }
    if let Some(o) = &document.observability {
        let _ = writeln!(text, "condition {:.1}", o.condition);
    }
    if let Some(w) = &document.workspace {
        let _ = writeln!(text, "predicted uncertainty of position: rms {:.4} mm, max {:.4} mm", w.rms_mm, w.max_mm);
        for p in &document.parameters {
            let u = p.standard_uncertainty.map_or("not told".to_owned(), |u| format!("{u:.2e}"));
            let _ = writeln!(text, "  {:<16} {u:>10} {}", p.name, p.unit);
        }
    }
    text
}
