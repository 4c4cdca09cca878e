//! The report of a comparison: what changed between campaigns, and what is chance.

mod trend;
pub(crate) mod words;

use super::points::Picture;
use super::words::Words as Dictionary;
use super::{number, templates};
use crate::document::{CompareChange, CompareDocument, CompareFamily, CompareTrend, Presentation};
use crate::message::Result;
use serde::Serialize;
use trend::heading;

/// More pictures than this nobody looks at.
const PICTURES: usize = 60;

/// What the template sees.
#[derive(Serialize)]
struct Page<'a> {
    compare: &'a CompareDocument,
    title: String,
    class: &'static str,
    sentence: String,
    together: Vec<String>,
    families: Vec<Family>,
    undrawn: usize,
}

/// Quantities of one family, ready to print.
#[derive(Serialize)]
struct Family {
    name: &'static str,
    id: String,
    /// name, unit, one value for each campaign
    values: Vec<Vec<String>>,
    /// name, pair, change, interval, p, corrected, verdict
    changes: Vec<[String; 7]>,
    pictures: Vec<Picture>,
}

/// The report as one HTML page, from the document alone.
pub fn html(compare: &CompareDocument) -> Result<String> {
    let (class, sentence) = verdict(compare);
    let labels: Vec<String> = compare.campaigns.iter().map(|c| c.date.clone().unwrap_or_default()).collect();
    let labels: Vec<String> =
        labels.into_iter().map(|l| if l.chars().count() > 12 { String::new() } else { l }).collect();
    let mut families: Vec<Family> = Vec::new();
    let (mut drawn, mut undrawn) = (0, 0);
    for (i, t) in compare.trends.iter().enumerate() {
        if families.last().is_none_or(|f| f.name != name(t.family)) {
            let id = format!("family-{}", families.len() + 1);
            families.push(Family { name: name(t.family), id, values: vec![], changes: vec![], pictures: vec![] });
        }
        let Some(family) = families.last_mut() else { continue };
        let named = [heading(t), words::unit(&t.unit).to_owned()];
        family.values.push(named.into_iter().chain(t.values.iter().map(words::value)).collect());
        family.changes.extend(t.changes.iter().map(|c| row(t, c)));
        match trend::picture(t, (i, &labels)) {
            Some(picture) if drawn < PICTURES => {
                drawn += 1;
                family.pictures.push(picture);
            }
            Some(_) => undrawn += 1,
            None => {}
        }
    }
    let title = compare.campaigns.first().map_or_else(String::new, |c| c.name.clone());
    let together = compare.together.iter().map(together).collect();
    let page = Page { compare, title, class, sentence, together, families, undrawn };
    templates::render("compare.html", &Presentation::default(), &Dictionary::default(), page)
}

/// What the first box says: its style, and a sentence.
fn verdict(compare: &CompareDocument) -> (&'static str, String) {
    let robot = |t: &&CompareTrend| t.family != CompareFamily::SetUp;
    let of = |t: &CompareTrend| t.changes.iter().any(|c| c.significant == Some(true));
    let changed: Vec<String> = compare.trends.iter().filter(robot).filter(|t| of(t)).map(heading).collect();
    let all = compare.trends.iter().filter(robot).count();
    match (changed.is_empty(), compare.together.iter().any(|t| t.significant)) {
        (true, false) => ("good", format!("None of {all} quantities of the robot changed significantly.")),
        (true, true) => {
            ("open", "The robot's parameters changed significantly, all together; no single quantity did.".to_owned())
        }
        (false, _) => {
            let named = changed.iter().take(6).cloned().collect::<Vec<_>>().join(", ");
            let more = if changed.len() > 6 { ", ..." } else { "" };
            (
                "open",
                format!("{} of {all} quantities of the robot changed significantly: {named}{more}.", changed.len()),
            )
        }
    }
}

fn together(t: &crate::document::CompareTogether) -> String {
    let degrees = t.degrees_of_freedom.map_or_else(|| "infinity".to_owned(), |d| number::significant(d, 3));
    format!(
        "Campaign {} against {}: the {} parameters of the robot, all together, {} (F = {} with {} and {degrees} degrees of \
         freedom, p = {}).",
        t.to,
        t.from,
        t.parameters,
        if t.significant { "changed significantly" } else { "did not change significantly" },
        number::significant(t.f, 3),
        t.parameters,
        number::significant(t.p, 2)
    )
}

/// A family in words.
pub(crate) fn name(family: CompareFamily) -> &'static str {
    match family {
        CompareFamily::Robot => "Parameters of the robot",
        CompareFamily::SetUp => "Parameters of base and targets",
        CompareFamily::MeanError => "Accuracy",
        CompareFamily::PoseAccuracy => "Pose accuracy AP",
        CompareFamily::MeanPosition => "Mean positions",
        CompareFamily::PoseRepeatability => "Pose repeatability RP",
    }
}

fn row(t: &CompareTrend, c: &CompareChange) -> [String; 7] {
    let w = words::change(t, c);
    [heading(t), w.pair, w.change, w.interval, w.p, w.p_holm, w.verdict.to_owned()]
}
