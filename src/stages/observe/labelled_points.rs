//! Points of a campaign that belong to one step of a procedure, found by the form of their labels.

use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pattern::matches_pattern;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_campaign::Campaign;
use etalon_formats::{LabelNames, LabelPattern, Point};
use std::collections::BTreeMap;
use toml::Spanned;

/// Points of one step: by cycle, pose and target, in the order in which they were measured.
pub(crate) type PointGroup = BTreeMap<(i64, PoseName, String), Vec<Vector>>;

/// All points of a campaign by their labels.
#[derive(Clone, Debug)]
pub(crate) struct LabelledPoints<'a> {
    pub campaign: &'a Campaign,
    points: &'a [Point],
}

impl<'a> LabelledPoints<'a> {
    /// Returns the collection of these points.
    pub fn new(campaign: &'a Campaign, points: &'a [Point]) -> Self {
        Self { campaign, points }
    }

    /// Returns points whose labels have the form of `pattern`, with numbers as poses.
    pub fn matching(&self, pattern: &Spanned<String>) -> Result<PointGroup> {
        self.with_poses(pattern, &[])
    }

    /// Returns points whose labels have the form of `pattern`; `poses` may have names that are not
    /// numbers.
    pub fn with_poses(&self, pattern: &Spanned<String>, poses: &[PoseName]) -> Result<PointGroup> {
        let place = || self.campaign.place(pattern);
        let form = LabelPattern::parse(pattern.get_ref()).map_err(|m| m.at(place()))?;
        let known = |named: &LabelNames| named.pose.is_some_and(|pose| poses.contains(&pose));
        let mut step = PointGroup::new();
        for point in self.points {
            let Some(named) = form.read(&point.label, known) else { continue };
            let key = (named.cycle.unwrap_or(1), named.pose.unwrap_or(1.into()), named.target.unwrap_or_default());
            step.entry(key).or_default().push(point.xyz_mm);
        }
        if step.is_empty() {
            return Err(error!("labels-missing", pattern = pattern.get_ref()).at(place()).into());
        }
        Ok(step)
    }

    /// Returns points whose label is, or matches, one of `names`.
    pub fn named<'n>(&self, names: impl IntoIterator<Item = &'n Spanned<String>>) -> Vec<Vector> {
        let names: Vec<&str> = names.into_iter().map(|n| n.get_ref().as_str()).collect();
        let bears = |p: &&Point| names.iter().any(|name| matches_pattern(name, &p.label));
        self.points.iter().filter(bears).map(|p| p.xyz_mm).collect()
    }
}
