//! A comparison of campaigns: what it found, the campaigns, every value and every change.

use super::import::checksums;
use super::sheet::{Cell, Sheet};
use super::summary::{self, line};
use crate::document::{CompareChange, CompareDocument, CompareFamily, CompareTrend, CompareValue, ComparedCampaign};
use crate::report::compare::{family, verdict};
use crate::report::words::Words;

pub(super) fn sheets(document: &CompareDocument, words: &Words) -> Vec<Sheet> {
    let mut sheets = vec![first(document, words), campaigns(document), changes(document), values(document)];
    sheets.extend((!document.together.is_empty()).then(|| together(document)));
    sheets.push(summary::messages(&document.messages.iter().collect::<Vec<_>>()));
    sheets.push(checksums(&document.provenance.inputs));
    sheets
}

fn first(document: &CompareDocument, words: &Words) -> Sheet {
    summary::sheet(vec![
        line(words.say("verdict"), verdict(document, words).1),
        line(words.say("model of the robot"), document.robot.as_deref()),
        line(words.say("conventions"), document.conventions.join("; ")),
        line(words.say("written by"), format!("etalon {}", document.provenance.version)),
    ])
}

fn campaigns(document: &CompareDocument) -> Sheet {
    let rows: Vec<(usize, &ComparedCampaign)> = (1..).zip(&document.campaigns).collect();
    Sheet::of(
        "Campaigns",
        &rows,
        &[
            ("number", "", |(i, _)| (*i).into()),
            ("campaign", "", |(_, c)| c.name.as_str().into()),
            ("date", "", |(_, c)| c.date.as_deref().into()),
            ("instrument", "", |(_, c)| c.instrument.as_deref().into()),
            ("expanded uncertainty", "µm", |(_, c)| c.expanded_uncertainty_um.into()),
            ("coverage factor", "", |(_, c)| c.coverage_factor.into()),
            ("synthetic data", "", |(_, c)| c.synthetic.as_deref().into()),
            ("degrees of freedom", "", |(_, c)| c.degrees_of_freedom.into()),
            ("folder", "", |(_, c)| c.folder.as_str().into()),
        ],
    )
}

/// Families have English names, as titles of columns have.
fn named(of: CompareFamily) -> Cell {
    family(of, &Words::default()).into()
}

fn changes(document: &CompareDocument) -> Sheet {
    let rows: Vec<(&CompareTrend, &CompareChange)> =
        document.trends.iter().flat_map(|t| t.changes.iter().map(move |c| (t, c))).collect();
    Sheet::of(
        "Changes",
        &rows,
        &[
            ("family", "", |(t, _)| named(t.family)),
            ("quantity", "", |(t, _)| t.name.as_str().into()),
            ("unit", "", |(t, _)| t.unit.as_str().into()),
            ("campaign", "", |(_, c)| c.to.into()),
            ("against", "", |(_, c)| c.from.into()),
            ("change", "", |(_, c)| c.change.into()),
            ("ratio", "", |(_, c)| c.ratio.into()),
            ("95 % from", "", |(_, c)| c.low.into()),
            ("95 % to", "", |(_, c)| c.high.into()),
            ("interval of", "", |(_, c)| if c.ratio.is_some() { "ratio" } else { "change" }.into()),
            ("p", "", |(_, c)| c.p.into()),
            ("p by Holm", "", |(_, c)| c.p_holm.into()),
            ("changed", "", |(_, c)| c.significant.map(|yes| if yes { "yes" } else { "no" }).into()),
        ],
    )
}

fn values(document: &CompareDocument) -> Sheet {
    let rows: Vec<(&CompareTrend, usize, &CompareValue)> =
        document.trends.iter().flat_map(|t| t.values.iter().enumerate().map(move |(i, v)| (t, i + 1, v))).collect();
    Sheet::of(
        "Values",
        &rows,
        &[
            ("family", "", |(t, ..)| named(t.family)),
            ("quantity", "", |(t, ..)| t.name.as_str().into()),
            ("unit", "", |(t, ..)| t.unit.as_str().into()),
            ("campaign", "", |(_, i, _)| (*i).into()),
            ("value", "", |(.., v)| v.value.into()),
            ("u (k = 1)", "", |(.., v)| v.standard_uncertainty.into()),
            ("95 % from", "", |(.., v)| v.low.into()),
            ("95 % to", "", |(.., v)| v.high.into()),
        ],
    )
}

fn together(document: &CompareDocument) -> Sheet {
    Sheet::of(
        "All together",
        &document.together,
        &[
            ("campaign", "", |t| t.to.into()),
            ("against", "", |t| t.from.into()),
            ("parameters", "", |t| t.parameters.into()),
            ("F", "", |t| t.f.into()),
            ("degrees of freedom", "", |t| t.degrees_of_freedom.into()),
            ("p", "", |t| t.p.into()),
            ("changed", "", |t| if t.significant { "yes" } else { "no" }.into()),
        ],
    )
}
