//! Conversion between labelled points and measurements of the geometric calibration.

use crate::stages::observe::labelled_points::{LabelledPoints, PointGroup};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Vector, centroid};
use etalon_base::pose_name::PoseName;
use etalon_campaign::{Campaign, GeometricDefinition, WorldDefinition};
use etalon_formats::Point;
use etalon_identify::geometric::{
    BaseMeasurements, LeadMeasurements, Measurements, OffsetMeasurements, ShaftMeasurements, Turned,
};
use std::collections::BTreeSet;
use toml::Spanned;

/// All measurements.
#[derive(Clone, Debug)]
pub struct Gathered {
    /// The robot.
    pub robot: Measurements,
    /// Pairs of balls of each scale bar.
    pub bars: Vec<Vec<[Vector; 2]>>,
    /// Readings of each single ball.
    pub balls: Vec<Vec<Vector>>,
}

/// Finds the points of every step by their labels; everything that is missing is reported at once.
pub fn gather(campaign: &Campaign, definition: &GeometricDefinition, points: &[Point]) -> Result<Gathered> {
    let all = LabelledPoints::new(campaign, points);
    let mut problems = Problems::default();
    let mut step = |pattern: &Spanned<String>| {
        all.matching(pattern).unwrap_or_else(|more| {
            problems.0.extend(more.0);
            PointGroup::new()
        })
    };
    let robot = [&definition.arc, &definition.turn, &definition.shaft, &definition.offsets];
    let robot = robot.map(|pattern| pattern.as_ref().map(|pattern| (pattern, step(pattern))));
    let leads: Vec<PointGroup> = definition.lead.iter().map(|l| step(&l.label)).collect();
    let bars: Vec<PointGroup> = definition.scale_bar.iter().map(|b| step(&b.label)).collect();
    let balls = definition.ball.iter().map(|b| step(&b.label).into_values().flatten().collect()).collect();
    let mut found = Measurements::default();
    if robot.iter().any(Option::is_some) {
        match all.base() {
            Ok(base) => found.base = base,
            Err(more) => problems.0.extend(more.0),
        }
    }
    gather_leads(campaign, definition, leads, &mut found, &mut problems);

    let one = |step: &PointGroup, cycle: i64, pose: PoseName, target: &str| {
        centroid(step.get(&(cycle, pose, target.to_owned())).map_or(&[][..], Vec::as_slice))
    };
    let mut want = |point: Option<Vector>, pattern: &Spanned<String>, (cycle, pose): (i64, PoseName), target: &str| {
        if point.is_none() {
            problems.0.push(error!("ball-missing", target, pose, cycle).at(campaign.place(pattern)));
        }
        point.unwrap_or_default()
    };
    let [arc, turn, shaft, offsets] = robot;
    found.base.arc = arc.into_iter().flat_map(|(_, arc)| arc.into_values().flatten()).collect();
    if let Some((pattern, turn)) = turn {
        for (cycle, pose) in turn.keys().map(|k| (k.0, k.1)).collect::<BTreeSet<_>>() {
            let mut ball = |name: &str| want(one(&turn, cycle, pose, name), pattern, (cycle, pose), name);
            found.turned.push(Turned { k: ball("K"), l: ball("L"), i: ball(&definition.turn_ball) });
        }
    }
    if let Some((_, shaft)) = shaft {
        for cycle in shaft.keys().map(|k| k.0).collect::<BTreeSet<_>>() {
            let position = |wanted: i64| shaft.iter().filter(move |(k, _)| k.0 == cycle && k.1 == wanted);
            let positions = [1, 2].map(|pose| position(pose).flat_map(|(_, p)| p).copied().collect());
            found.shafts.push(ShaftMeasurements { positions });
        }
    }
    if let (Some((pattern, offsets)), Some(rho)) = (offsets, definition.mid_travel_mm) {
        for cycle in offsets.keys().map(|k| k.0).collect::<BTreeSet<_>>() {
            let mut ball =
                |name: &str, pose: PoseName| want(one(&offsets, cycle, pose, name), pattern, (cycle, pose), name);
            let (k, l, k_end) = (ball("K", 1.into()), ball("L", 1.into()), ball("K", 2.into()));
            found.offsets.push(OffsetMeasurements { rho2_mm: rho, rho3_mm: rho, k, l, k_end });
        }
    }
    let mut pairs = Vec::new();
    for (definition, step) in definition.scale_bar.iter().zip(bars) {
        let keys: BTreeSet<(i64, PoseName)> = step.keys().map(|k| (k.0, k.1)).collect();
        let mut ball =
            |(cycle, pose), name: &str| want(one(&step, cycle, pose, name), &definition.label, (cycle, pose), name);
        pairs.push(keys.into_iter().map(|key| [ball(key, "A"), ball(key, "B")]).collect());
    }
    problems.check()?;
    Ok(Gathered { robot: found, bars: pairs, balls })
}

/// The readings of every actuator with the commanded displacements.
fn gather_leads(
    campaign: &Campaign,
    definition: &GeometricDefinition,
    leads: Vec<PointGroup>,
    found: &mut Measurements,
    problems: &mut Problems,
) {
    for (definition, step) in definition.lead.iter().zip(leads) {
        let actuator = *definition.actuator.get_ref();
        let Some(run) = found.leads.get_mut(actuator.wrapping_sub(1)) else {
            problems.0.push(error!("actuator-unknown", actuator).at(campaign.place(&definition.actuator)));
            continue;
        };
        let measured = run.get_or_insert_with(LeadMeasurements::default);
        for ((_, pose, _), points) in step {
            let commanded =
                pose.number().and_then(|n| usize::try_from(n - 1).ok()).and_then(|i| definition.positions_mm.get(i));
            let Some(&commanded) = commanded else {
                let message = error!("lead-position-unknown", position = pose, actuator);
                problems.0.push(message.at(campaign.place(&definition.label)));
                continue;
            };
            measured.commanded_mm.extend(points.iter().map(|_| commanded));
            measured.points.extend(points);
        }
    }
}

/// The label of a point: a pattern with its parts filled in.
pub fn label(pattern: &str, target: &str, pose: PoseName, cycle: i64) -> String {
    pattern.replace("{target}", target).replace("{pose}", &pose.to_string()).replace("{cycle}", &cycle.to_string())
}

/// Measurements as labelled points, the input of [`gather`]; without rails and ball R.
pub fn labelled(definition: &GeometricDefinition, gathered: &Gathered) -> Vec<(String, Vector)> {
    let Gathered { robot: found, bars, balls } = gathered;
    let mut rows = Vec::new();
    let mut row = |pattern: &Spanned<String>, target: &str, pose: i64, cycle: i64, p: Vector| {
        rows.push((label(pattern.get_ref(), target, pose.into(), cycle), p));
    };
    for (lead, run) in definition.lead.iter().filter_map(|l| Some((l, found.leads.get(l.actuator.get_ref() - 1)?))) {
        for (i, p) in run.iter().flat_map(|run| &run.points).enumerate() {
            let positions = lead.positions_mm.len().max(1);
            row(&lead.label, "", (i % positions) as i64 + 1, (i / positions) as i64 + 1, *p);
        }
    }
    for (bar, pairs) in definition.scale_bar.iter().zip(bars) {
        for (cycle, [a, b]) in (1..).zip(pairs) {
            row(&bar.label, "A", 1, cycle, *a);
            row(&bar.label, "B", 1, cycle, *b);
        }
    }
    for (ball, readings) in definition.ball.iter().zip(balls) {
        (1..).zip(readings).for_each(|(cycle, p)| row(&ball.label, "", 1, cycle, *p));
    }
    if let Some(pattern) = &definition.arc {
        (1..).zip(&found.base.arc).for_each(|(pose, p)| row(pattern, "N", pose, 1, *p));
    }
    if let Some(pattern) = &definition.turn {
        for (pose, t) in (1..).zip(&found.turned) {
            for (target, p) in [("K", t.k), ("L", t.l), (definition.turn_ball.as_str(), t.i)] {
                row(pattern, target, pose, 1, p);
            }
        }
    }
    if let Some(pattern) = &definition.shaft {
        for (cycle, run) in (1..).zip(&found.shafts) {
            for (pose, points) in (1..).zip(&run.positions) {
                points.iter().for_each(|p| row(pattern, "shaft", pose, cycle, *p));
            }
        }
    }
    if let Some(pattern) = &definition.offsets {
        for (cycle, run) in (1..).zip(&found.offsets) {
            for (target, pose, p) in [("K", 1, run.k), ("L", 1, run.l), ("K", 2, run.k_end)] {
                row(pattern, target, pose, cycle, p);
            }
        }
    }
    rows
}

impl LabelledPoints<'_> {
    /// Rails and ball R, which define the world frame.
    fn base(&self) -> Result<BaseMeasurements> {
        let wrong = || error!("geometric-frame").at(self.campaign.world_place());
        let Some(WorldDefinition {
            plane: Some(plane),
            origin: Some(origin),
            y_axis: Some(ends),
            towards: Some(towards),
            ..
        }) = self.campaign.file.world()
        else {
            return Err(wrong().into());
        };
        let rails = self.campaign.file.features.get(plane.get_ref()).and_then(|f| f.element());
        let ([from, to], Some((_, rails))) = (&ends[..], rails) else { return Err(wrong().into()) };
        let measured = BaseMeasurements {
            rails: self.named(rails),
            towards: centroid(&self.named([towards])).unwrap_or_default(),
            arc: Vec::new(),
            r_home: self.named([from]),
            r_end: self.named([to]),
        };
        let same = from.get_ref() == origin.get_ref();
        if !same || measured.rails.is_empty() || measured.r_home.is_empty() || measured.r_end.is_empty() {
            return Err(wrong().into());
        }
        Ok(measured)
    }
}
