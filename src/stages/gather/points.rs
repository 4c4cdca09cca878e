//! Points of all exports, and the settings of a campaign for them.

use crate::stages::observe::resolution;
use etalon_base::cell::is_formula;
use etalon_base::message::{Message, Problems};
use etalon_base::pattern::matches_pattern;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, JoinBy};
use etalon_documents::{Refused, Source, Unmatched};
use etalon_formats::{Export, LabelNames, LabelPattern as Pattern, Names, Point, SharedText};
use indexmap::IndexMap;
use std::collections::BTreeSet;

/// A point in the frame of a further station of the instrument.
#[derive(Clone, Debug)]
pub struct Stationed {
    /// Name of the station.
    pub station: SharedText,
    /// The point.
    pub point: Point,
}

/// All points of a campaign.
#[derive(Clone, Debug, Default)]
pub(super) struct PointColumns {
    pub points: Vec<Point>,
    /// Points of further stations, in the frames of the stations.
    pub stationed: Vec<Stationed>,
    /// Warnings about exports as a whole.
    pub remarks: Vec<Message>,
    /// `true` if rows of a target are omitted because they have no pose.
    pub has_rows_without_pose: bool,
    /// Targets of rigid parts whose rows are all rejected.
    pub refused_targets: Vec<String>,
}

impl PointColumns {
    /// Adds the readable rows of the text of an export, and returns its errors.
    pub fn read(&mut self, campaign: &Campaign, export: &Export, text: &SharedText, source: &mut Source) -> Problems {
        let file = export.file.get_ref();
        let (mut rows, mut problems) = etalon_formats::rows(&export.format, file, text, export.unit);
        if rows.is_empty() && problems.0.is_empty() {
            problems.0.push(error!("export-empty", file));
        }
        problems = problems.at(&campaign.place(&export.file));
        self.remarks.extend(export.format.caution().map(|warning| warning.at(campaign.place(&export.file))));
        self.remarks.extend(super::rounding::coarse(campaign, export, &rows));
        self.remarks.extend(resolution::replace_export_zeros(campaign, export, &mut rows));
        problems.0.extend(self.add(campaign, export, rows, source).0);
        problems
    }

    /// Adds the rows of an export; rows that were not measured are added to the rejected rows of
    /// the source. Returns the errors of the other rows.
    fn add(&mut self, campaign: &Campaign, export: &Export, rows: Vec<Point>, source: &mut Source) -> Problems {
        let mut problems = Problems::default();
        let pattern = export.label.as_ref().and_then(|text| {
            let wrong = |m: Message| problems.0.push(m.at(campaign.place(text)));
            Pattern::parse(text.get_ref()).map_err(wrong).ok()
        });
        source.rows_read = rows.len();
        // targets that carry a world frame measured once need no pose
        let world = campaign.file.world().filter(|world| world.each.is_none());
        let frame_targets = world.and_then(|world| world.targets.as_deref()).unwrap_or_default();
        let targets = if pattern.is_some() { known_targets(campaign) } else { BTreeSet::new() };
        let known = |named: &LabelNames| named.target.as_ref().is_none_or(|target| targets.contains(target));
        let (file, from_name): (SharedText, _) = (export.file.get_ref().as_str().into(), &export.from_name);
        let mut shared = Names::default();
        let origin_is_missing = export.format.origin_is_missing(&rows);
        self.remarks.extend(single_origin(campaign, export, &rows).filter(|_| origin_is_missing));
        // in the memory of the rows: exports have millions
        let kept = rows.into_iter().enumerate().filter_map(|(i, row)| {
            let zero = origin_is_missing && row.xyz_mm == [0.0; 3];
            let reason = row.refused.as_deref().cloned().or_else(|| zero.then(|| phrase!("row-at-origin")));
            if let Some(reason) = reason {
                source.refused.push(Refused::new(row.line as usize, &row.text, reason));
                return None;
            }
            let named = pattern.as_ref().and_then(|p| p.read(&row.label, known)).unwrap_or_default();
            let of_file = export.target.as_deref().or(from_name.target.as_deref());
            let named_target = || named.target.as_deref().or(of_file).map(|target| shared.shared(target));
            let target = row.target.clone().or_else(named_target);
            if target.as_ref().is_some_and(|t| is_formula(t)) {
                let target = target.unwrap_or_default();
                let message = error!("target-formula", target = &*target);
                problems.0.push(message.at(row.place_in(export.file.get_ref())));
                return None;
            }
            let numbered = || export.pose.map(|from| from.number(i as i64 + 1).into());
            let pose = row.pose.or(named.pose).or(from_name.pose).or_else(numbered);
            let unreadable = row.xyz_mm.iter().any(|v| v.is_nan());
            let in_frame = |t: &SharedText| frame_targets.iter().any(|f| **f.get_ref() == **t);
            let placed = pose.is_some() || row.time_s.is_some() || unreadable;
            if target.is_some() && !placed && !target.as_ref().is_some_and(in_frame) {
                self.has_rows_without_pose = true;
                let message = error!("target-without-pose");
                problems.0.push(message.at(row.place_in(export.file.get_ref())));
                return None;
            }
            let mut row = Point { export: file.clone(), row: i as u32 + 1, ..row };
            let cycle = row.cycle.or(named.cycle).or(from_name.cycle).or(target.as_ref().map(|_| 1));
            if target.is_some() || pose.is_some() || cycle.is_some() {
                (row.target, row.pose, row.cycle) = (target, pose, cycle);
            }
            Some(row)
        });
        let kept: Vec<Point> = kept.collect();
        self.keep(export, kept);
        problems
    }

    /// Adds the points of an export after the points of earlier exports, or to a further station.
    fn keep(&mut self, export: &Export, mut kept: Vec<Point>) {
        if let Some(station) = &export.station {
            let station: SharedText = station.get_ref().as_str().into();
            self.stationed.extend(kept.into_iter().map(|point| Stationed { station: station.clone(), point }));
            return;
        }
        // the larger part stays where it is
        match self.points.len() < kept.len() {
            true => {
                kept.splice(0..0, std::mem::take(&mut self.points));
                self.points = kept;
            }
            false => self.points.append(&mut kept),
        }
    }

    /// Errors about points with the same target, pose and cycle as a previous one.
    pub fn measured_twice(&self, campaign: &Campaign) -> Vec<Message> {
        let mut first = IndexMap::new();
        let mut errors = Vec::new();
        let stationed = self.stationed.iter().map(|of| (Some(&of.station), &of.point));
        for (station, point) in self.points.iter().map(|point| (None, point)).chain(stationed) {
            let (Some(target), Some(pose)) = (&point.target, point.pose) else { continue };
            let before = *first.entry((station, target, pose, point.cycle)).or_insert(point);
            if !std::ptr::eq(before, point) {
                let numbered = |e: &Export| e.pose.is_some() && *e.file.get_ref() == *point.export;
                let several = point.export != before.export && campaign.file.exports.iter().any(numbered);
                let message = error!(
                    "target-twice",
                    target = &**target,
                    pose,
                    cycle = point.cycle.unwrap_or(1),
                    file = &*before.export,
                    line = before.line,
                    numbered = if several { "by-row" } else { "by-label" }
                );
                errors.push(message.at(point.place()));
            }
        }
        errors
    }

    /// Warnings about labels that name no target and are not used by a feature or frame, with these
    /// points.
    pub fn unused_labels(&self, campaign: &Campaign) -> (Vec<Message>, Vec<Unmatched>) {
        if !campaign.unread.is_empty() {
            return (Vec::new(), Vec::new());
        }
        let used = used_labels(campaign);
        let geometric = campaign.file.geometric.iter().flat_map(|g| g.patterns());
        let visits = campaign.file.repeatability.iter().flat_map(|r| r.patterns());
        let forms: Vec<Pattern> = geometric.chain(visits).filter_map(|p| Pattern::parse(p.get_ref()).ok()).collect();
        // a join by label reports which points are not touched
        let joined = campaign.file.join_by() == Some(JoinBy::Label);
        let is_used = |p: &Point| joined || used.iter().any(|u| matches_pattern(u, &p.label));
        let has_form = |p: &Point| forms.iter().any(|f| f.read(&p.label, |_| false).is_some());
        let idle = |p: &&Point| p.target.is_none() && !is_used(p) && !has_form(p);
        let idle: Vec<&Point> = self.points.iter().filter(idle).collect();
        let Some(first) = idle.first() else { return (Vec::new(), Vec::new()) };
        // points of an export without targets and poses do not move with the robot
        let of_first = campaign.file.exports.iter().find(|export| *export.file.get_ref() == *first.export);
        let moves =
            of_first.is_none_or(|export| export.label.is_some() || export.target.is_some() || export.pose.is_some());
        let points = if moves { "moving" } else { "stationary" };
        let message = warning!("labels-unused", count = idle.len(), label = &*first.label, points);
        let unused = |p: &&Point| Unmatched {
            file: p.export.to_string(),
            line: p.line as usize,
            key: p.label.to_string(),
            reason: phrase!("label-names-nothing").into(),
        };
        (vec![message.at(first.place())], idle.iter().take(MOST_LISTED).map(unused).collect())
    }
}

/// Maximum number of unused readings that are listed; a scan has millions.
const MOST_LISTED: usize = 10_000;

/// Returns a warning if the origin is a row of an export once: a lost target, or a measured point
/// that is the origin of the frame.
fn single_origin(campaign: &Campaign, export: &Export, rows: &[Point]) -> Option<Message> {
    let mut at_origin = rows.iter().filter(|row| row.refused.is_none() && row.xyz_mm == [0.0; 3]);
    let (Some(row), None) = (at_origin.next(), at_origin.next()) else { return None };
    let file = export.file.get_ref();
    Some(warning!("origin-not-measured", file, line = row.line).at(campaign.place(&export.file)))
}

/// Targets of the robot and of the world frame: labels with these targets may name a pose by a
/// text.
fn known_targets(campaign: &Campaign) -> BTreeSet<String> {
    let of_robot = campaign.build_robot().map_or_else(|_| Vec::new(), |robot| robot.targets().to_vec());
    let of_frame = campaign.file.world().and_then(|world| world.targets.as_deref()).unwrap_or_default();
    of_robot.into_iter().chain(of_frame.iter().map(|target| target.get_ref().clone())).collect()
}

/// Labels that features and the world frame use.
pub(crate) fn used_labels(campaign: &Campaign) -> Vec<&str> {
    let features = campaign.file.features.values().filter_map(|f| f.element()).flat_map(|(_, labels)| labels);
    let framed =
        campaign.file.world().into_iter().flat_map(|world| world.names().chain(world.targets.iter().flatten()));
    features.chain(framed).map(|l| l.get_ref().as_str()).collect()
}
