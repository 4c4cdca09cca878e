//! The test of repeatability of a campaign (thesis 2.4): from labelled points to the
//! characteristics of ISO 9283.

use crate::stages::iso9283::{COVERAGE_FACTOR, settings};
use crate::stages::observe::labelled_points::{LabelledPoints, PointGroup};
use crate::stages::table_file::{CampaignTables, TableFile};
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose::Pose;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, RepeatabilityDefinition, TableDefinition};
use etalon_documents::{FramesDocument, Iso9283Document, Iso9283OutOfPlane, Iso9283Pose, Iso9283Visit, SourceKind};
use etalon_formats::Point;
use etalon_formats::table::ANGLES;
use etalon_formats::tables::recording::commanded_poses;
use etalon_standards::iso9283::pose::PoseTestSettings;
use etalon_standards::iso9283::pose::coplanarity::from_the_others;
use etalon_standards::iso9283::pose::drift::drifts;
use etalon_standards::iso9283::pose::test::{AttainedPose, CommandedPose, PoseTest, TestedPose, from_pose};
use std::collections::{BTreeMap, BTreeSet};

/// The characteristics of the campaign's labelled visits, in its world frame, and the files used in
/// addition to the exports.
pub fn evaluate(
    campaign: &Campaign,
    definition: &RepeatabilityDefinition,
    points: &[Point],
    commanded: Option<&Commanded>,
    frames: &FramesDocument,
) -> Result<Iso9283Document> {
    let [frame] = &frames.world.poses[..] else {
        return Err(error!("repeatability-frame").at(campaign.world_place()).into());
    };
    let gathered = gather(campaign, definition, points, commanded, &frame.export_T_world)?;
    let drift_set = definition.drift_set.as_ref().map(|set| *set.get_ref());
    let settings = PoseTestSettings { drift_set, ..settings(campaign) };
    let mut document = Iso9283Document::evaluate(&gathered.visits, &settings)?;
    document.agree(phrase!("convention-approach", k = COVERAGE_FACTOR, frame = frames.world.definition));
    document.frame = Some(phrase!("world-frame").into());
    if !gathered.visits.spatial {
        document.agree(phrase!("convention-planar"));
    }
    if let Some(homings) = &gathered.homings {
        // a homing is no pose of the test: no limit applies to it
        let settings = PoseTestSettings { drift_set: None, ap_limit_mm: None, rp_limit_mm: None, ..settings };
        let homing = Iso9283Document::evaluate(homings, &settings)?.poses.pop();
        document.messages.extend(homing.as_ref().and_then(too_coarse));
        document.robot.homing = homing;
    }
    document.robot.coplanarity_of_four = out_of_plane(campaign, definition, &gathered.in_order)?;
    document.recorded.visits = gathered.in_order;
    Ok(document)
}

/// Visits in the labels of a campaign.
#[derive(Clone, Debug)]
pub struct Gathered {
    /// Visits of the trajectory's poses.
    pub visits: PoseTest,
    /// Homings, as visits of pose 0.
    pub homings: Option<PoseTest>,
    /// The visits of the trajectory in the order of recording.
    pub in_order: Vec<Iso9283Visit>,
}

/// Finds the visits by their labels; everything that is missing is reported at once.
pub fn gather(
    campaign: &Campaign,
    definition: &RepeatabilityDefinition,
    points: &[Point],
    commanded: Option<&Commanded>,
    export_T_world: &Pose,
) -> Result<Gathered> {
    let steps = LabelledPoints::new(campaign, points);
    let mut problems = statements(campaign, definition);
    let trajectory = definition.trajectory.get_ref();
    let mut step = |pattern| steps.with_poses(pattern, trajectory).map_err(|more| problems.0.extend(more.0)).ok();
    let (visits, homings) = (step(&definition.label), definition.homing.as_ref().map(&mut step));
    let world_T_export = export_T_world.inverse();
    let mut warnings = Vec::new();
    let in_order = visits.map_or_else(Vec::new, |step| {
        let (visits, missing) = in_order(campaign, definition, step, &world_T_export, &mut problems);
        warnings.extend(missing);
        visits
    });
    problems.check()?;
    let homings = homings.flatten().map(|step| {
        let homed = |((cycle, _, _), points): ((i64, PoseName, String), Vec<_>)| {
            let visit = move |p| visit(0.into(), cycle, None, world_T_export.apply(p));
            points.into_iter().map(visit).collect::<Vec<_>>()
        };
        by_pose(&step.into_iter().flat_map(homed).collect::<Vec<_>>(), Vec::new())
    });
    let (mut visits, mut homings) = (by_pose(&in_order, warnings), homings);
    if let Some(commanded) = commanded {
        commanded.give_to(&mut visits)?;
        if let Some(set) = definition.drift_set.as_ref().filter(|set| *set.get_ref() > 1) {
            drifts(&visits, *set.get_ref()).map_err(|more| more.at(&campaign.place(set)))?;
        }
        homings.iter_mut().filter(|_| !commanded.spatial).for_each(flatten);
    }
    Ok(Gathered { visits, homings, in_order })
}

/// Commanded positions of the campaign's poses, in its world frame.
#[derive(Clone, Debug)]
pub struct Commanded {
    table: TableFile,
    poses: Vec<CommandedPose>,
    spatial: bool,
}

impl Commanded {
    pub(super) fn read(files: &mut CampaignTables, table: &TableDefinition) -> Result<Self> {
        let table = files.read(table, SourceKind::Table, phrase!("table-of-commanded-poses"))?;
        if let Some(column) = ANGLES.into_iter().find(|name| table.table.has(name)) {
            return Err(table.place(table.table.in_file(error!("commanded-angle-unmeasured", column))));
        }
        let poses = commanded_poses(&table.table).map_err(|p| table.place(p))?;
        let spatial = table.table.is_spatial()?;
        Ok(Self { table, poses, spatial })
    }

    /// Checks that every visited pose is commanded. Without commanded z, z of the visits is
    /// removed.
    fn give_to(&self, visits: &mut PoseTest) -> Result<()> {
        let known = |pose: PoseName| self.poses.iter().find(|known| known.pose == pose).map(|known| known.position_mm);
        let mut missing = Vec::new();
        for p in &mut visits.poses {
            p.commanded_mm = known(p.pose);
            if p.commanded_mm.is_none() {
                missing.push(p.pose.to_string());
            }
        }
        if !missing.is_empty() {
            return Err(self.table.table.in_file(error!("commanded-pose-missing", poses = missing)));
        }
        for CommandedPose { pose, .. } in self.poses.iter().filter(|c| visits.poses.iter().all(|p| p.pose != c.pose)) {
            visits.warnings.push(warning!("commanded-pose-unmeasured", pose));
        }
        if !self.spatial {
            flatten(visits);
        }
        Ok(())
    }
}

/// Removes z.
fn flatten(visits: &mut PoseTest) {
    visits.spatial = false;
    for visit in visits.poses.iter_mut().flat_map(|p| &mut p.attained) {
        visit.position_mm[2] = 0.0;
        visit.readings_mm.iter_mut().for_each(|p| p[2] = 0.0);
    }
}

fn visit(pose: PoseName, cycle: i64, approach: Option<String>, attained_mm: etalon_base::pose::Vector) -> Iso9283Visit {
    Iso9283Visit { pose, cycle, approach, attained_mm }
}

/// Errors in statements, independent of measurements.
fn statements(campaign: &Campaign, definition: &RepeatabilityDefinition) -> Problems {
    let trajectory = definition.trajectory.get_ref();
    let mut problems = Problems::default();
    if trajectory.is_empty() {
        problems.0.push(error!("trajectory-empty").at(campaign.place(&definition.trajectory)));
    }
    if let Some(four) = &definition.coplanar {
        let poses = four.get_ref();
        let distinct = poses.iter().collect::<BTreeSet<_>>().len() == poses.len();
        if !distinct || !poses.iter().all(|pose| trajectory.contains(pose)) {
            problems.0.push(error!("coplanar-not-four").at(campaign.place(four)));
        }
    }
    problems
}

/// The visits of every cycle along the trajectory. If a cycle passes a pose several times, all
/// visits must exist: otherwise it is unknown which one is missing. A warning names the poses and
/// cycles without a visit.
fn in_order(
    campaign: &Campaign,
    definition: &RepeatabilityDefinition,
    mut step: PointGroup,
    world_T_export: &Pose,
    problems: &mut Problems,
) -> (Vec<Iso9283Visit>, Option<Message>) {
    let trajectory = definition.trajectory.get_ref();
    let place = || campaign.place(&definition.label);
    let cycles: BTreeSet<i64> = step.keys().map(|key| key.0).collect();
    let first = cycles.first().copied();
    let mut measured: BTreeMap<(PoseName, i64), std::vec::IntoIter<_>> = BTreeMap::new();
    for ((cycle, pose, target), points) in std::mem::take(&mut step) {
        if !trajectory.contains(&pose) {
            problems.0.push(error!("pose-not-in-trajectory", pose, cycle).at(place()));
        } else if measured.insert((pose, cycle), points.into_iter()).is_some() {
            problems.0.push(error!("pose-of-several-targets", pose, cycle, target).at(place()));
        }
    }
    let counts = trajectory.iter().fold(BTreeMap::new(), |mut counts: BTreeMap<PoseName, usize>, pose| {
        *counts.entry(*pose).or_default() += 1;
        counts
    });
    let mut missing = Vec::new();
    for (&cycle, (&pose, &count)) in cycles.iter().flat_map(|cycle| counts.iter().map(move |count| (cycle, count))) {
        match measured.get(&(pose, cycle)).map_or(0, ExactSizeIterator::len) {
            0 => missing.push(phrase!("pose-of-cycle", pose, cycle)),
            found if found != count => {
                problems.0.push(error!("visit-count-differs", pose, cycle, found, count).at(place()));
            }
            _ => {}
        }
    }
    problems.0.truncate(20);
    let shown = &missing[..missing.len().min(10)];
    let warning = || warning!("visits-missing", count = missing.len(), poses = shown).at(place());
    let warning = (!missing.is_empty()).then(warning);
    let mut all = Vec::new();
    for &cycle in &cycles {
        for (i, pose) in trajectory.iter().enumerate() {
            let before = trajectory[(i + trajectory.len() - 1) % trajectory.len()];
            // where the robot came from at first is not given
            let approach = (i > 0 || Some(cycle) != first).then(|| from_pose(before));
            if let Some(p) = measured.get_mut(&(*pose, cycle)).and_then(Iterator::next) {
                all.push(visit(*pose, cycle, approach, world_T_export.apply(p)));
            }
        }
    }
    (all, warning)
}

fn by_pose(in_order: &[Iso9283Visit], warnings: Vec<Message>) -> PoseTest {
    let mut poses: BTreeMap<PoseName, Vec<AttainedPose>> = BTreeMap::new();
    for v in in_order {
        poses.entry(v.pose).or_default().push(AttainedPose {
            cycle: v.cycle,
            position_mm: v.attained_mm,
            angles_rad: Vec::new(),
            approach: v.approach.clone(),
            robot: String::new(),
            readings_mm: vec![v.attained_mm],
            readings_rad: vec![Vec::new()],
        });
    }
    let of_pose = |(pose, attained)| TestedPose { pose, commanded_mm: None, commanded_rad: Vec::new(), attained };
    PoseTest {
        poses: poses.into_iter().map(of_pose).collect(),
        spatial: true,
        angles: Vec::new(),
        rotation_order: None,
        warnings,
    }
}

fn out_of_plane(
    campaign: &Campaign,
    definition: &RepeatabilityDefinition,
    visits: &[Iso9283Visit],
) -> Result<Vec<Iso9283OutOfPlane>> {
    let Some(four) = &definition.coplanar else { return Ok(Vec::new()) };
    let poses = *four.get_ref();
    let of_pose = |pose: PoseName| visits.iter().filter(|v| v.pose == pose).map(|v| v.attained_mm).collect::<Vec<_>>();
    let distances_mm = from_the_others(&poses.map(of_pose)).map_err(|more| more.at(&campaign.place(four)))?;
    Ok(poses.into_iter().zip(distances_mm).map(|(pose, distance_mm)| Iso9283OutOfPlane { pose, distance_mm }).collect())
}

fn too_coarse(homing: &Iso9283Pose) -> Option<Message> {
    let rp_mm = homing.rp_mm.filter(|_| homing.quarter_rule_met == Some(false))?;
    Some(warning!("homing-instrument-too-coarse", rp_mm))
}
