//! What geometry alone found.

use super::paper::Block;
use crate::document::GeometricDocument;
use crate::report::geometric::section;
use crate::report::number::{fixed, significant};
use crate::report::points::Picture;
use crate::report::words::Words;

pub(super) fn blocks(document: &GeometricDocument, words: &Words) -> Vec<Block> {
    let found = section(document, words);
    let sentence = (!found.sentence.is_empty()).then_some(found.sentence);
    let mut blocks: Vec<Block> = sentence.into_iter().map(Block::strong).collect();
    blocks.push(Block::note(document.definition.clone()));
    let titles = [
        "name",
        "unit",
        "#nominal",
        "#geometric",
        "#u",
        "#repeats",
        "#their standard deviation",
        "#expected from the points",
        "#identified",
        "#identified − geometric",
    ];
    blocks.push(Block::table(words, &titles, found.quantities));
    let note = words.say("u (k = 1) holds the base frame's uncertainty, which all repeats share and their standard deviation does not show.");
    blocks.push(Block::note(note));
    for table in found.tables {
        blocks.push(Block::heading(table.title));
        let four = ["#x", "#y", "#x, y", "#θ"];
        let titles = [&["#pose", "command"][..], &four, &four, &four, &["#standard deviation, mm"]].concat();
        let method = |name: &str| words.fill("{0}: mean errors in mm and deg", &[&words.say(name)]);
        let (before, geometric, identified) = (method("before"), method("geometric"), method("identified"));
        let groups = [("", 2), (before.as_str(), 4), (&geometric, 4), (&identified, 4), ("", 1)];
        blocks.push(Block::grouped(words, &groups, &titles, table.rows));
    }
    if !document.methods.is_empty() {
        blocks.push(Block::heading(words.say("All tables")));
        let rows = document.methods.iter().map(|m| {
            let numbers = [m.position_max_mm, m.position_rms_mm, m.orientation_max_deg].map(|v| fixed(v, 3));
            [vec![words.say(&m.name)], numbers.into()].concat()
        });
        let titles = ["method", "#position max, mm", "#position RMS, mm", "#orientation max, deg"];
        blocks.push(Block::table(words, &titles, rows));
    }
    if !found.leads.is_empty() {
        blocks.push(Block::heading(words.say("Leads")));
        let titles = [
            "#actuator",
            "#nominal lead, mm",
            "#actual lead, mm",
            "#error, µm per mm",
            "#u, µm per mm",
            "#largest mean deviation from linear, µm",
        ];
        blocks.push(Block::table(words, &titles, found.leads));
    }
    blocks.extend(checks(document, words));
    blocks.extend(workspace(document, found.drawing, words));
    blocks
}

/// Scale bars, repeated balls and how well the fits did.
fn checks(document: &GeometricDocument, words: &Words) -> Vec<Block> {
    let four = |v: f64| fixed(v, 4);
    let mut blocks = Vec::new();
    if !document.scale_bars.is_empty() {
        let rows = document.scale_bars.iter().map(|b| {
            let numbers = [b.mean_error_mm, b.standard_deviation_mm].map(four);
            [vec![b.name.clone(), four(b.length_mm), b.count.to_string()], numbers.into()].concat()
        });
        let titles = ["position", "#length, mm", "#distances", "#mean error, mm", "#standard deviation, mm"];
        blocks.push(Block::heading(words.say("Scale bars")));
        blocks.push(Block::table(words, &titles, rows));
    }
    if !document.balls.is_empty() {
        let rows = document.balls.iter().map(|b| {
            let numbers = [b.mean_mm, b.standard_deviation_mm, b.repeatability_mm].map(four);
            [vec![b.name.clone(), b.count.to_string()], numbers.into()].concat()
        });
        let titles =
            ["ball", "#readings", "#mean distance from their mean, mm", "#standard deviation, mm", "#mean + 3 s, mm"];
        blocks.push(Block::heading(words.say("Single balls, measured repeatedly")));
        blocks.push(Block::table(words, &titles, rows));
    }
    let rows = document.steps.iter().map(|s| {
        let numbers = [s.standard_deviation_mm, s.expected_mm, s.max_mm, s.norm_mm].map(four);
        let arc = s.coverage_deg.map_or_else(String::new, |v| fixed(v, 1));
        [vec![s.name.clone(), s.count.to_string()], numbers.into(), vec![arc, significant(s.enlarged_by, 3)]].concat()
    });
    let titles = [
        "fit",
        "#residuals",
        "#standard deviation, mm",
        "#expected, mm",
        "#max, mm",
        "#norm, mm",
        "#arc, deg",
        "#uncertainties enlarged",
    ];
    blocks.push(Block::heading(words.say("Fits")));
    blocks.push(Block::table(words, &titles, rows));
    blocks
}

/// Regions that the platform's centre reaches, and their outlines.
fn workspace(document: &GeometricDocument, drawing: Option<String>, words: &Words) -> Vec<Block> {
    let row = |r: &crate::document::Region| [r.name.clone(), fixed(r.area_mm2, 0), r.corners_mm.len().to_string()];
    let rows: Vec<_> = document.workspace.iter().map(row).collect();
    if rows.is_empty() {
        return vec![];
    }
    let titles = ["region of C, in the base frame", "#area, mm²", "#corners"];
    let mut blocks = vec![Block::heading(words.say("Workspace")), Block::table(words, &titles, rows)];
    let drawing = drawing.map(|svg| Picture {
        title: words.say("Workspace"),
        svg,
        caption: words.say("Outlines of these regions; the heavier one is reached with every orientation."),
        ..Picture::default()
    });
    blocks.extend(Block::pictures(drawing.into_iter().collect()));
    blocks
}
