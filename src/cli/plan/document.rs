//! `plan.json`: what was chosen, as a document.

use super::{Plan, STUDY_DRAWS, STUDY_RUNS};
use crate::base::files;
use crate::base::table::ASSEMBLY;
use crate::document::*;
use crate::math::identify::Observation;
use crate::math::plan::{Plan as Planned, Study, index_of};
use crate::math::robots::Robot;
use crate::stages::parameters::observability_summary;
use std::collections::BTreeMap;

impl Plan {
    pub(super) fn document(
        &self,
        robot: &dyn Robot,
        observations: &[Observation],
        planned: &Planned,
        study: Option<StudyDocument>,
    ) -> anyhow::Result<PlanDocument> {
        let pose = |c: usize| observations[planned.members[c][0]].pose;
        let configuration = |k: &usize| joint_values(robot, &observations[*k]);
        let chosen = planned.chosen.iter().map(|&c| PlannedPose {
            pose: pose(c),
            configurations: planned.members[c].iter().map(configuration).collect(),
        });
        let paths = [&self.robot, &self.candidates].into_iter().chain(&self.truth).chain(&self.workspace);
        let inputs = files::sha256_of(paths)?;
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
            observability: planned.prediction.observability.as_ref().map(|o| observability_summary(robot, o)),
            parameters: parameters(robot, planned, self.standard_uncertainty_um.is_some()),
            workspace: self
                .standard_uncertainty_um
                .map(|_| WorkspaceUncertainty { rms_mm: planned.workspace.0, max_mm: planned.workspace.1 }),
            places: places(robot, observations, planned),
            study,
            messages,
            provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs, seed: Some(self.seed) },
        })
    }
}

/// Where the candidates are.
fn places(robot: &dyn Robot, observations: &[Observation], planned: &Planned) -> Vec<CandidatePlace> {
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

/// Studies for increasing numbers of positions as one document; the last has all of them.
pub(super) fn study_document(
    robot: &dyn Robot,
    studies: &[Study],
    truth: &[f64],
    noise_um: f64,
    configurations: usize,
) -> Option<StudyDocument> {
    let last = studies.last()?;
    let parameter = |(i, p): (usize, &crate::math::robots::Parameter)| StudiedParameter {
        name: p.name.clone(),
        unit: p.quantity.unit().to_owned(),
        nominal: p.quantity.outward(p.nominal),
        actual: p.quantity.outward(truth[i]),
        identified: p.quantity.outward(last.identified[i]),
    };
    let step = |s: &Study| StudyStep {
        positions: s.positions,
        configurations: s.configurations,
        rms_before_mm: s.rms_mm.0,
        max_before_mm: s.max_mm.0,
        rms_mm: s.rms_mm.1,
        max_mm: s.max_mm.1,
    };
    let place = |p: &crate::math::plan::PlaceError| StudiedPlace {
        pose: p.pose,
        at_mm: p.at_mm,
        max_before_mm: p.before_mm,
        max_mm: p.after_mm,
    };
    Some(StudyDocument {
        runs: STUDY_RUNS,
        draws: STUDY_DRAWS,
        noise_um,
        configurations,
        parameters: robot.parameters().iter().enumerate().map(parameter).collect(),
        steps: studies.iter().map(step).collect(),
        places: last.places.iter().map(place).collect(),
    })
}

fn parameters(robot: &dyn Robot, planned: &Planned, stated: bool) -> Vec<PlannedParameter> {
    let (free, n) = (&planned.sensitivity.free, planned.sensitivity.free.len());
    let held = planned.sensitivity.groups.iter().map(|g| g.with.iter().chain([&g.held]).copied().collect::<Vec<_>>());
    let sets: Vec<Vec<usize>> = held.chain(planned.prediction.weak.iter().map(|w| w.parameters.clone())).collect();
    let parameter = |(i, p): (usize, &crate::math::robots::Parameter)| {
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
