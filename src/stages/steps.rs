//! Points of a campaign that belong to one step of a procedure, found by the form of their labels.

use crate::base::message::{Message, Result};
use crate::base::pattern::matches_pattern;
use crate::base::pose::Vector;
use crate::base::table;
use crate::campaign::Campaign;
use crate::import::LabelPattern;
use polars::prelude::DataFrame;
use std::collections::BTreeMap;
use toml::Spanned;

/// Points of one step: by cycle, pose and target, in the order in which they were measured.
pub(crate) type Step = BTreeMap<(i64, i64, String), Vec<Vector>>;

/// All points of a campaign by their labels.
#[derive(Clone, Debug)]
pub(crate) struct Steps<'a> {
    pub campaign: &'a Campaign,
    labels: Vec<String>,
    xyz: Vec<Vector>,
}

impl<'a> Steps<'a> {
    /// Of a table of points.
    pub fn new(campaign: &'a Campaign, points: &DataFrame) -> Result<Self> {
        Ok(Self { campaign, labels: table::texts(points, "label")?, xyz: table::coordinates(points)? })
    }

    /// Points whose labels have the form of `pattern`.
    pub fn of(&self, pattern: &Spanned<String>) -> Result<Step> {
        let place = || self.campaign.place(pattern);
        let form = LabelPattern::parse(pattern.get_ref()).map_err(|m| m.at(place()))?;
        let mut step = Step::new();
        for (label, p) in self.labels.iter().zip(&self.xyz) {
            let Some(named) = form.read(label) else { continue };
            let key = (named.cycle.unwrap_or(1), named.pose.unwrap_or(1), named.target.unwrap_or_default());
            step.entry(key).or_default().push(*p);
        }
        if step.is_empty() {
            let what = format!("no point bears a label of the form `{}`", pattern.get_ref());
            return Err(Message::error(what).at(place()).hint("correct the pattern, or add the export").into());
        }
        Ok(step)
    }

    /// Points whose label is, or matches, one of `names`.
    pub fn named<'n>(&self, names: impl IntoIterator<Item = &'n Spanned<String>>) -> Vec<Vector> {
        let names: Vec<&str> = names.into_iter().map(|n| n.get_ref().as_str()).collect();
        let bears = |label: &String| names.iter().any(|name| matches_pattern(name, label));
        self.labels.iter().zip(&self.xyz).filter(|(label, _)| bears(label)).map(|(_, p)| *p).collect()
    }
}
