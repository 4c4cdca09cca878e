//! The report of a comparison: what changed between campaigns, and what is chance.

mod names;
#[cfg(test)]
mod tests;
mod trend;
pub(crate) mod words;

use super::points::Picture;
use super::words::{Words, isolated};
use super::{facts, number, templates, workbook};
use crate::base::message::{Result, one_line};
use crate::document::{CompareChange, CompareDocument, CompareFamily, CompareTogether, CompareTrend, Presentation};
pub(crate) use names::family;
use serde::Serialize;
use std::fmt::Display;

/// More pictures than this nobody looks at.
const PICTURES: usize = 60;

/// A report of a comparison as the bytes of its file.
pub(crate) type Writer = fn(&CompareDocument, &Presentation) -> Result<Vec<u8>>;

/// The kinds of its report by the ending of the file.
pub(crate) const WRITERS: &[(&str, Writer)] = &[
    ("html", |compare, presentation| Ok(html(compare, presentation)?.into_bytes())),
    #[cfg(feature = "pdf")]
    ("pdf", super::pdf::compare_pdf),
    ("xlsx", workbook::compare_workbook),
];

/// What every kind of the report tells.
#[derive(Serialize)]
pub(super) struct Contents {
    /// how many campaigns, and of which robot
    pub lead: String,
    /// folder, and why its data are none of a robot's
    pub synthetic: Vec<[String; 2]>,
    /// number, name, date, instrument, folder
    pub campaigns: Vec<[String; 5]>,
    /// style of the verdict
    pub class: &'static str,
    pub sentence: String,
    pub together: Vec<String>,
    pub families: Vec<Family>,
    /// quantities without a picture
    pub undrawn: usize,
}

/// Quantities of one family, ready to print.
#[derive(Serialize)]
pub(super) struct Family {
    pub name: String,
    pub id: String,
    /// name, unit, one value for each campaign
    pub values: Vec<Vec<String>>,
    /// name, pair, change, interval, p, corrected, verdict
    pub changes: Vec<[String; 7]>,
    pub pictures: Vec<Picture>,
}

/// What the template sees.
#[derive(Serialize)]
struct Page<'a> {
    compare: &'a CompareDocument,
    title: String,
    #[serde(flatten)]
    contents: Contents,
}

/// The report as one HTML page, from the document alone.
pub(super) fn html(compare: &CompareDocument, presentation: &Presentation) -> Result<String> {
    let words = &Words::of(presentation.language)?;
    let first = compare.campaigns.first().map_or_else(String::new, |c| one_line(&c.name));
    let title = words.fill("{0}: comparison of {1} campaigns", &[&first, &compare.campaigns.len()]);
    templates::render("compare.html", presentation, words, Page { compare, title, contents: contents(compare, words) })
}

pub(super) fn contents(compare: &CompareDocument, words: &Words) -> Contents {
    let (class, sentence) = verdict(compare, words);
    let label = |date: Option<&String>| date.filter(|d| d.chars().count() <= 12).cloned().unwrap_or_default();
    let labels: Vec<String> = compare.campaigns.iter().map(|c| label(c.date.as_ref())).collect();
    let mut families: Vec<(CompareFamily, Family)> = Vec::new();
    let (mut drawn, mut undrawn) = (0, 0);
    for (i, t) in compare.trends.iter().enumerate() {
        if families.last().is_none_or(|(family, _)| *family != t.family) {
            let (name, id) = (names::family(t.family, words), format!("family-{}", families.len() + 1));
            families.push((t.family, Family { name, id, values: vec![], changes: vec![], pictures: vec![] }));
        }
        let Some((_, family)) = families.last_mut() else { continue };
        let named = [names::quantity(t, words), words::unit(&t.unit)];
        family.values.push(named.into_iter().chain(t.values.iter().map(|v| words::value(v, words))).collect());
        family.changes.extend(t.changes.iter().map(|c| row(t, c, words)));
        match trend::picture(t, (i, &labels), words) {
            Some(picture) if drawn < PICTURES => {
                drawn += 1;
                family.pictures.push(picture);
            }
            Some(_) => undrawn += 1,
            None => {}
        }
    }
    let synthetic = compare.campaigns.iter().filter_map(|c| Some([c.folder.clone(), c.synthetic.clone()?]));
    Contents {
        lead: lead(compare, words),
        synthetic: synthetic.collect(),
        campaigns: campaigns(compare, words),
        class,
        sentence,
        together: compare.together.iter().map(|t| together(t, words)).collect(),
        families: families.into_iter().map(|(_, family)| family).collect(),
        undrawn,
    }
}

fn lead(compare: &CompareDocument, words: &Words) -> String {
    let count = compare.campaigns.len();
    match &compare.robot {
        Some(robot) => {
            words.fill("{0} campaigns of robot {1}, in the order named", &[&count, &isolated(&one_line(robot))])
        }
        None => words.fill("{0} campaigns, in the order named", &[&count]),
    }
}

fn campaigns(compare: &CompareDocument, words: &Words) -> Vec<[String; 5]> {
    let row = |(i, c): (usize, &crate::document::ComparedCampaign)| {
        let k = c.coverage_factor.map(|k| format!(" (k = {})", facts::stated(k))).unwrap_or_default();
        let u = c.expanded_uncertainty_um.map(|u| format!("U = {} µm{k}", facts::stated(u)));
        let instrument: Vec<String> = c.instrument.as_deref().map(one_line).into_iter().chain(u).collect();
        let date = c.date.as_deref().map_or_else(|| words.say("not stated"), one_line);
        [(i + 1).to_string(), one_line(&c.name), date, instrument.join(", "), one_line(&c.folder)]
    };
    compare.campaigns.iter().enumerate().map(row).collect()
}

/// What the first box says: its style, and a sentence.
pub(super) fn verdict(compare: &CompareDocument, words: &Words) -> (&'static str, String) {
    const NAMED: usize = 6;
    // a frame that was found again elsewhere moves mean positions: they are no quantity of the robot alone
    let robot = |t: &&CompareTrend| !matches!(t.family, CompareFamily::SetUp | CompareFamily::MeanPosition);
    let of = |t: &CompareTrend| t.changes.iter().any(|c| c.significant == Some(true));
    let name = |t: &CompareTrend| isolated(&names::quantity(t, words));
    let changed: Vec<String> = compare.trends.iter().filter(robot).filter(|t| of(t)).map(name).collect();
    let judged = |t: &&CompareTrend| t.changes.iter().any(|c| c.significant.is_some());
    let all = compare.trends.iter().filter(robot).filter(judged).count();
    let (class, found) = match (changed.is_empty(), compare.together.iter().any(|t| t.significant)) {
        (true, false) => ("good", words.fill("None of {0} quantities of the robot changed significantly.", &[&all])),
        (true, true) => {
            ("open", words.say("The robot's parameters changed significantly, all together; no single quantity did."))
        }
        (false, _) => {
            let named = changed.iter().take(NAMED).cloned().collect::<Vec<_>>().join(", ");
            let more = if changed.len() > NAMED { ", ..." } else { "" };
            let told = format!("{named}{more}");
            let values: [&dyn Display; 3] = [&changed.len(), &all, &told];
            ("open", words.fill("{0} of {1} quantities of the robot changed significantly: {2}.", &values))
        }
    };
    let unjudged = compare.trends.iter().filter(robot).filter(|t| !judged(t)).count();
    let told = words.fill("{0} could not be judged: no uncertainty is known.", &[&unjudged]);
    let moved = compare.trends.iter().any(|t| t.family == CompareFamily::MeanPosition && of(t));
    let elsewhere = words.say("Mean positions changed: the robot, or how its frame was found.");
    let more: Vec<String> =
        [(unjudged > 0, told), (moved, elsewhere)].into_iter().filter(|m| m.0).map(|m| m.1).collect();
    let class = if more.is_empty() { class } else { "open" };
    (class, std::iter::once(found).chain(more).collect::<Vec<_>>().join(" "))
}

fn together(t: &CompareTogether, words: &Words) -> String {
    let degrees = t.degrees_of_freedom.map_or_else(|| "∞".to_owned(), |d| number::significant(d, 3));
    let (f, p) = (number::significant(t.f, 3), number::significant(t.p, 2));
    let values: [&dyn Display; 6] = [&t.to, &t.from, &t.parameters, &f, &degrees, &p];
    match t.significant {
        true => words.fill("Campaign {0} against {1}: the {2} parameters of the robot, all together, changed significantly (F = {3} with {2} and {4} degrees of freedom, p = {5}).", &values),
        false => words.fill("Campaign {0} against {1}: the {2} parameters of the robot, all together, did not change significantly (F = {3} with {2} and {4} degrees of freedom, p = {5}).", &values),
    }
}

fn row(t: &CompareTrend, c: &CompareChange, words: &Words) -> [String; 7] {
    let w = words::change(t, c, words);
    [names::quantity(t, words), w.pair, w.change, w.interval, w.p, w.p_holm, w.verdict]
}
