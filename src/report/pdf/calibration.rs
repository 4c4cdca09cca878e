//! The report of a calibration, from its verdict to the line for signatures.

use super::paper::{Block, Labels, Paper, Section, Verdict};
use super::{annex, fit, geometric, iso9283, places, stated};
use crate::report::words::Words;
use crate::report::{Identified, Report, facts, parameters, pictures, points, tables, verdict};

/// What stands in it, in the order of reading.
pub(super) fn paper(report: &Report, identified: &Identified, words: &Words) -> Paper {
    let inputs = &identified.parameters.provenance;
    let (messages, more) = stated::messages(&report.messages(), words);
    let geometric = identified.geometric.and_then(|d| {
        Section::of("geometric", words.say("Geometry alone, beside the identification"), geometric::blocks(d, words))
    });
    let drawn = pictures(report, identified, words);
    let before = [
        stated::conditions(facts::facts(report.campaign, report.tested, words), words),
        stated::limits(report.limits(), words),
        messages,
        Section::of("errors", words.say("Errors before and after"), errors(identified, words)),
    ];
    let after = [
        Section::of("parameters", words.say("Parameters"), parameters(identified, drawn.parameters, words)),
        geometric,
        Section::of(
            "fit",
            words.say("Fit and observability"),
            fit(identified, (drawn.residuals, drawn.observability), words),
        ),
        Section::of("pictures", words.say("Pictures"), drawings(identified, drawn.errors, words)),
        places::section(report.features, &report.frames.world, words),
        stated::inputs(report.import, &inputs.inputs, words),
    ];
    Paper {
        title: report.campaign.name.clone(),
        subtitle: format!("{} {}", words.say("Calibration report of robot"), identified.parameters.robot),
        synthetic: report.campaign.synthetic.clone(),
        date: report.campaign.date.clone(),
        version: inputs.version.clone(),
        labels: Labels::of(&report.campaign.report, words),
        verdict: judged(verdict::verdict(report, identified, words), words),
        sections: before
            .into_iter()
            .flatten()
            .chain(iso9283::sections(report.tested, words))
            .chain(after.into_iter().flatten())
            .collect(),
        annexes: [annex::poses(identified.errors, words), annex::refused(report.import, words), more]
            .into_iter()
            .flatten()
            .collect(),
    }
}

fn judged(verdict: verdict::Verdict, words: &Words) -> Verdict {
    let sentences = [verdict.alarm, verdict.sentence].into_iter().filter(|s| !s.is_empty());
    Verdict {
        class: verdict.class,
        sentences: sentences.collect(),
        about: words.fill("Errors before → after calibration, {0} poses:", &[&verdict.set]),
        headlines: verdict.headlines.into_iter().map(|h| [h.what, h.before, h.after, h.unit.to_owned()]).collect(),
    }
}

fn errors(report: &Identified, words: &Words) -> Vec<Block> {
    let sets = tables::sets(report.accuracy, words);
    let mut blocks = vec![Block::note(report.accuracy.definition.clone())];
    if sets.is_empty() {
        blocks.push(Block::text(words.say("No errors are given.")));
    }
    for set in sets {
        let title = words.fill("{0}: {1} poses, {2} errors", &[&set.name, &set.poses, &set.count]);
        blocks.push(Block::heading(title));
        let row = |r: tables::Row| [vec![r.quantity, r.unit], r.before.into(), r.after.into(), vec![r.ratio]].concat();
        let four = ["#mean", "#RMS", "#95 %", "#max"];
        let titles = [&["error", "unit"][..], &four, &four, &["#RMS ratio"]].concat();
        let groups = [("", 2), ("before", 4), ("after", 4), ("", 1)];
        blocks.push(Block::grouped(words, &groups, &titles, set.rows.into_iter().map(row)));
    }
    blocks
}

fn parameters(report: &Identified, drawn: Vec<points::Picture>, words: &Words) -> Vec<Block> {
    let confounded = report.parameters.parameters.iter().any(|p| !p.confounded_with.is_empty());
    let columns = if confounded { 10 } else { 9 };
    let rows = parameters::rows(&report.parameters.parameters, words).into_iter().map(|p| {
        let confounded = p.confounded_with.join(", ");
        [p.name, p.unit, p.nominal, p.before, p.value, p.change, p.u, p.expanded, p.status, confounded]
            .into_iter()
            .take(columns)
    });
    let titles =
        ["name", "unit", "#nominal", "#before", "#identified", "#change", "#u", "#U = 2u", "status", "confounded with"];
    let note = words.say("u is the standard uncertainty (k = 1), U = 2u the expanded one; numbers are shown to the second digit of u. “Before” is with only base and targets fitted. The change is from nominal to identified.");
    let mut blocks = vec![Block::note(note), Block::table(words, &titles[..columns], rows)];
    blocks.extend(Block::pictures(drawn));
    blocks
}

fn fit(report: &Identified, (left, told): (Vec<points::Picture>, Vec<points::Picture>), words: &Words) -> Vec<Block> {
    let mut blocks = fit::blocks(report.parameters, told, words);
    blocks.extend(Block::pictures(left));
    blocks
}

fn drawings(report: &Identified, drawn: Vec<points::Picture>, words: &Words) -> Vec<Block> {
    let Some(pictures) = Block::pictures(drawn) else {
        return vec![Block::text(words.say("There is no error that could be drawn."))];
    };
    let undrawn = report.errors.len() - points::drawable(report.errors).len();
    let mut blocks = vec![Block::note(words.say("Circles are calibration poses, diamonds validation poses."))];
    if undrawn > 0 {
        let note = words.fill("{0} errors have no finite position or size and are not drawn.", &[&undrawn]);
        blocks.push(Block::note(note));
    }
    blocks.push(pictures);
    blocks
}
