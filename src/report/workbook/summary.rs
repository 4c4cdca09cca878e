//! The first sheet (what was measured, and the verdict), limits, and messages.

use super::sheet::{Cell, Sheet};
use super::{Identified, Report, verdict};
use crate::base::message::{Message, Severity};
use crate::document::{CampaignSummary, Characteristics, LimitVerdict};
use crate::report::facts::facts;
use crate::report::iso9283;
use crate::report::words::Words;

/// What is told, what is said, and its unit.
type Line = (String, Cell, &'static str);

pub(super) fn calibration(report: &Report, identified: &Identified, words: &Words) -> Sheet {
    let verdict = verdict::verdict(report, identified, words);
    let (residuals, solver) = (&identified.parameters.residuals, &identified.parameters.solver);
    let steps = words.fill("{0}, {1} iterations;", &[&solver.method, &solver.iterations]);
    let condition = identified.parameters.observability.as_ref().map(|o| o.condition);
    let mut lines = vec![line(words.say("verdict"), verdict.sentence), line(words.say("alarm"), verdict.alarm)];
    lines.push(line(words.say("model of the robot"), identified.parameters.robot.as_str()));
    lines.extend(stated(report.campaign, report.tested, words));
    lines.extend([
        line(words.say("definition of errors"), identified.accuracy.definition.as_str()),
        line(words.say("residuals"), residuals.count),
        line(words.say("residuals, RMS"), residuals.rms),
        line(words.say("residuals, max"), residuals.max),
        line(words.say("degrees of freedom"), residuals.degrees_of_freedom),
        line(words.say("chi-square"), residuals.chi_square),
        line(words.say("uncertainties enlarged"), residuals.uncertainties_enlarged_by),
        line(words.say("condition"), condition),
        line(words.say("Solver"), format!("{steps} {}", solver.meaning)),
        line(words.say("written by"), format!("etalon {}", identified.parameters.provenance.version)),
    ]);
    sheet(lines)
}

pub(super) fn test(report: &Report, words: &Words) -> Sheet {
    let tested = report.tested;
    let mut lines = vec![line(words.say("verdict"), iso9283::verdict(tested, words).sentences.join(" "))];
    lines.extend(stated(report.campaign, tested, words));
    lines.extend([
        line(words.say("conventions"), tested.poses.as_ref().map(|d| d.conventions.join("; "))),
        line(words.say("written by"), concat!("etalon ", env!("CARGO_PKG_VERSION"))),
    ]);
    sheet(lines)
}

/// What the campaign says, its numbers as numbers.
fn stated(campaign: &CampaignSummary, tested: &Characteristics, words: &Words) -> Vec<Line> {
    let mut lines = vec![
        line(words.say("campaign"), campaign.name.as_str()),
        line(words.say("synthetic data"), campaign.synthetic.as_deref()),
    ];
    lines.extend(facts(campaign, tested, words).into_iter().map(|f| line(f.what, f.text)));
    lines.extend([
        (words.say("instrument's expanded uncertainty"), campaign.expanded_uncertainty_um.into(), "µm"),
        (words.say("coverage factor"), campaign.coverage_factor.into(), ""),
        (words.say("temperature"), campaign.temperature_c.into(), "°C"),
    ]);
    lines
}

pub(super) fn line(what: String, cell: impl Into<Cell>) -> Line {
    (what, cell.into(), "")
}

/// What is not stated is left out.
pub(super) fn sheet(lines: Vec<Line>) -> Sheet {
    let stated = lines.into_iter().filter(|(_, cell, _)| *cell != Cell::Empty);
    Sheet {
        name: "Summary",
        columns: ["what", "value", "unit"].map(|title| (title.to_owned(), String::new())).into(),
        rows: stated.map(|(what, cell, unit)| vec![what.into(), cell, unit.into()]).collect(),
    }
}

pub(super) fn limits(limits: &[&LimitVerdict]) -> Sheet {
    Sheet::of(
        "Limits",
        limits.iter().copied(),
        &[
            ("limit", "", |l| l.name.as_str().into()),
            ("allowed", "", |l| l.limit.into()),
            ("reached", "", |l| l.value.into()),
            ("unit", "", |l| l.unit.as_str().into()),
            ("verdict", "", |l| if l.met { "met" } else { "not met" }.into()),
        ],
    )
}

pub(super) fn messages(messages: &[&Message]) -> Sheet {
    Sheet::of(
        "Messages",
        messages.iter().copied(),
        &[
            ("severity", "", |m: &Message| if m.severity == Severity::Error { "error" } else { "warning" }.into()),
            ("what", "", |m| m.what.as_str().into()),
            ("file", "", |m| m.place.as_ref().map(|p| p.file.as_str()).into()),
            ("line", "", |m| m.place.as_ref().and_then(|p| p.line).into()),
            ("column", "", |m| m.place.as_ref().and_then(|p| p.column).into()),
            ("text", "", |m| m.place.as_ref().and_then(|p| p.text.as_deref()).into()),
            ("expected", "", |m| m.expected.as_deref().into()),
            ("hint", "", |m| m.hint.as_deref().into()),
        ],
    )
}
