//! What changes in the course of a test: characteristics by set of cycles, and targets that should stand still.

use super::um;
use crate::document::{Iso9283Document, Iso9283Drift, Iso9283Epoch};
use crate::report::part::{Part, number};
use crate::report::streams::chart::{Chart, Curve};
use crate::report::words::Words;

pub(super) fn parts(document: &Iso9283Document, words: &Words) -> Vec<Part> {
    let mut parts = vec![sets(&document.drifts, words), reference(&document.reference, words)];
    parts.retain(Part::has_rows);
    parts
}

fn sets(drifts: &[Iso9283Drift], words: &Words) -> Part {
    let row = |d: &Iso9283Drift| {
        let settled = d.settled_after.map_or_else(|| "–".to_owned(), |n| n.to_string());
        vec![d.pose.to_string(), d.ap_mm.len().to_string(), um(Some(d.dap_mm)), um(Some(d.drp_mm)), settled]
    };
    let columns = [words.say("pose"), words.say("sets"), "dAP, µm".to_owned(), "dRP, µm".to_owned()];
    let columns = columns.into_iter().chain([words.say("settled after set")]).map(number).collect();
    let note = words.say("dAP and dRP: the last set against the first (ISO 9283:1998, 7.6).");
    let by_set = |id: &str, title: String, caption: String, values: fn(&Iso9283Drift) -> &[f64]| {
        let curve = |d: &Iso9283Drift| Curve {
            name: words.fill("pose {0}", &[&d.pose]),
            points: values(d).iter().enumerate().map(|(i, v)| (i as f64 + 1.0, 1e3 * v)).collect(),
        };
        let (across, up) = (words.say("set of cycles"), "µm".to_owned());
        let curves = drifts.iter().map(curve).collect();
        Chart { id: id.to_owned(), title, caption, across, up, curves, marks: vec![] }.picture(words)
    };
    let pictures = [
        by_set(
            "drift-ap",
            words.say("AP by set"),
            words.say("Accuracy of each pose in the course of the test."),
            |d| &d.ap_mm,
        ),
        by_set(
            "drift-rp",
            words.say("RP by set"),
            words.say("Repeatability of each pose in the course of the test."),
            |d| &d.rp_mm,
        ),
    ];
    let rows = drifts.iter().map(row).collect();
    let part = Part::table(words.say("Drift of accuracy and repeatability"), note, columns, rows);
    Part { pictures: pictures.into_iter().flatten().collect(), ..part }
}

fn reference(epochs: &[Iso9283Epoch], words: &Words) -> Part {
    let row = |e: &Iso9283Epoch| vec![e.cycle.to_string(), um(Some(e.moved_mm)), um(Some(e.rms_mm))];
    let columns = [words.say("from cycle on"), words.say("moved, µm"), words.say("left, µm")].map(number).to_vec();
    let note = words.say("How far targets that stand still have moved since they were first measured, and what is left of it where positions are carried back by them (not of the standard).");
    let curve = |name: String, value: fn(&Iso9283Epoch) -> f64| Curve {
        name,
        points: epochs.iter().map(|e| (e.cycle as f64, 1e3 * value(e))).collect(),
    };
    let chart = Chart {
        id: "reference".to_owned(),
        title: words.say("Reference targets"),
        caption: words
            .say("Largest movement of a target since the first time, and the root mean square of what is left."),
        across: words.say("cycle"),
        up: "µm".to_owned(),
        curves: vec![curve(words.say("moved"), |e| e.moved_mm), curve(words.say("left"), |e| e.rms_mm)],
        marks: vec![],
    };
    let part = Part::table(words.say("Movement of the set-up"), note, columns, epochs.iter().map(row).collect());
    let pictures = if epochs.is_empty() { None } else { chart.picture(words) };
    Part { pictures: pictures.into_iter().collect(), ..part }
}
