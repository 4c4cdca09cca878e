//! Geometric calibration beside the identification: its results, and its accuracy.

use crate::Report;
use crate::model::{Block, Columns, Figure, Section, Table, Text, fixed, numbers, significant, with_uncertainty};
use crate::number;
use crate::plots::workspace::{Workspace, XY};
use crate::words::Words;
use etalon_documents::{
    BarVerdict, GeometricDocument, GeometricQuantity, LeadResult, Linearity, MeanError, PoseRow, PoseTable,
};

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    let document = report.geometric?;
    let title = match report.identified {
        Some(_) => words.say("Geometry alone, beside the identification"),
        None => words.say("Geometry alone"),
    };
    let mut section = Section::new("geometric", title);
    if report.identified.is_some() {
        section.push(Block::strong(sentence(document, words)));
    }
    section.push(Block::note(Text::document(&document.definition, words)));
    section.push(Block::Table(quantities(document, words)));
    section.push(Block::note(words.say("u (k = 1) holds the base frame's uncertainty, which all repeats share and their standard deviation does not show.")));
    for table in &document.tables {
        section.push(Block::heading(&table.title));
        section.push(Block::Table(poses(table, words)));
    }
    let columns = Columns::<etalon_documents::MethodErrors>::new()
        .page("method", "", |m| Text::name(&words.say(&m.name)))
        .sheet("method", "", |m| m.name.as_str())
        .both("position, max", "mm", |m| fixed(m.position_max_mm, 3))
        .both("position, RMS", "mm", |m| fixed(m.position_rms_mm, 3))
        .both("orientation, max", "deg", |m| fixed(m.orientation_max_deg, 3));
    section.table(words.say("All tables"), "", Table::of(words, &document.methods, columns).on("Geometry, methods"));
    section.table(words.say("Leads"), "", leads(document, words));
    section.push(Block::Table(linearity(document, words)));
    let columns = Columns::<etalon_documents::ScaleBarResult>::new()
        .both("position", "", |b| b.name.as_str())
        .both("length", "mm", |b| fixed(b.length_mm, 4))
        .both("distances", "", |b| b.count)
        .both("mean error", "mm", |b| fixed(b.mean_error_mm, 4))
        .both("standard deviation", "mm", |b| fixed(b.standard_deviation_mm, 4))
        .both("largest error", "mm", |b| fixed(b.largest_error_mm, 4))
        .both("permissible", "mm", |b| fixed(b.permissible_error_mm, 4))
        .both("permissible over certificate", "", |b| significant(b.uncertainty_ratio, 2))
        .page("verdict", "", |b| Text::name(&bar_verdict(b.verdict, words)))
        .sheet("verdict", "", |b| bar_verdict(b.verdict, words));
    let bars = Table::of(words, &document.scale_bars, columns).on("Geometry, scale bars");
    section.table(words.say("Scale bars"), "", bars);
    let columns = Columns::<etalon_documents::BallResult>::new()
        .both("ball", "", |b| b.name.as_str())
        .both("readings", "", |b| b.count)
        .both("mean distance from their mean", "mm", |b| fixed(b.mean_mm, 4))
        .both("standard deviation", "mm", |b| fixed(b.standard_deviation_mm, 4))
        .both("mean + 3 s", "mm", |b| fixed(b.repeatability_mm, 4));
    let balls = Table::of(words, &document.balls, columns).on("Geometry, balls");
    section.table(words.say("Single balls, measured repeatedly"), "", balls);
    section.table(words.say("Fits"), "", fits(document, words));
    let columns = Columns::<etalon_documents::Region>::new()
        .both("region of C, in the base frame", "", |r| Text::document(&r.name, words))
        .both("area", "mm²", |r| fixed(r.area_mm2, 0))
        .both("corners", "", |r| r.corners_mm.len());
    let regions = Table::of(words, &document.workspace, columns).on("Geometry, workspace");
    section.table(words.say("Workspace"), "", regions);
    section.figures(drawing(document, words));
    section.whole()
}

fn bar_verdict(verdict: BarVerdict, words: &Words) -> String {
    match verdict {
        BarVerdict::Conforming => words.say("conforming"),
        BarVerdict::NotConforming => words.say("not conforming"),
        BarVerdict::BarTooUncertain => words.say("the bar is too uncertain (4:1)"),
        BarVerdict::NoCertificate => words.say("no certificate is stated"),
    }
}

/// Sentence on the accuracy of the geometric method.
fn sentence(document: &GeometricDocument, words: &Words) -> String {
    let largest = |name: &str| document.methods.iter().find(|m| m.name == name).map(|m| m.position_max_mm);
    let (Some(nominal), Some(geometric), Some(identified)) =
        (largest("nominal"), largest("geometric"), largest("identified"))
    else {
        return String::new();
    };
    let mm = |v: f64| number::significant(v, 3);
    let times = |a: f64, b: f64| number::significant(a / b, 2);
    let values: [&dyn std::fmt::Display; 5] =
        [&mm(nominal), &mm(geometric), &times(nominal, geometric), &mm(identified), &times(geometric, identified)];
    let alone = words.fill(
        "The largest mean position error falls from {0} mm to {1} mm by geometry alone, {2} times less.",
        &values,
    );
    let beside = words.fill(
        "Identification of all parameters from the same campaign brings it to {3} mm: the technician's way leaves {4} times as much.",
        &values,
    );
    format!("{alone} {beside}")
}

fn quantities(document: &GeometricDocument, words: &Words) -> Table {
    let u = |q: &GeometricQuantity| Some(q.standard_uncertainty);
    let columns = Columns::<GeometricQuantity>::new()
        .both("name", "", |q| q.name.as_str())
        .both("unit", "", |q| q.unit.as_str())
        .both("nominal", "", move |q| with_uncertainty(q.nominal, u(q)))
        .both("geometric", "", move |q| with_uncertainty(q.value, u(q)))
        .both("u (k = 1)", "", |q| significant(q.standard_uncertainty, 2))
        .both("repeats", "", |q| q.repeats.as_ref().map(|r| r.count))
        .both("their standard deviation", "", |q| significant(q.repeats.as_ref().map(|r| r.standard_deviation), 2))
        .both("expected from the points", "", |q| significant(q.repeats.as_ref().map(|r| r.expected), 2))
        .both("identified", "", |q| q.identified.map(|v| with_uncertainty(v, q.identified_standard_uncertainty)))
        .sheet("u of identified", "", |q| q.identified_standard_uncertainty)
        .page("identified − geometric", "", move |q| q.identified.map(|v| with_uncertainty(v - q.value, u(q))));
    Table::of(words, &document.quantities, columns).on("Geometry, quantities")
}

/// Mean errors of the poses in a table, by method.
fn poses(table: &PoseTable, words: &Words) -> Table {
    let command = |r: &PoseRow| {
        let [x, y] = r.command_mm;
        let [x, y, turned] = [number::fixed(x, 3), number::fixed(y, 3), number::fixed(r.command_deg, 2)];
        words.number(&format!("{x}, {y} mm, {turned} deg"))
    };
    let first = Columns::<PoseRow>::new()
        .sheet("table", "", |_| table.title.as_str())
        .both("pose", "", |r| r.pose)
        .page("command", "", move |r| numbers(command(r)))
        .sheet("command x", "mm", |r| r.command_mm[0])
        .sheet("command y", "mm", |r| r.command_mm[1])
        .sheet("command θ", "deg", |r| r.command_deg)
        .sheet("visits", "", |r| r.count);
    type Method = (&'static str, fn(&PoseRow) -> &MeanError);
    let methods: [Method; 3] =
        [("nominal", |r| &r.nominal), ("geometric", |r| &r.geometric), ("identified", |r| &r.identified)];
    let columns = methods.into_iter().fold(first, |columns, (name, of)| {
        columns
            .both("x", "mm", move |r| fixed(of(r).x_mm, 3))
            .both("y", "mm", move |r| fixed(of(r).y_mm, 3))
            .both("x y", "mm", move |r| fixed(of(r).position_mm, 3))
            .both("θ", "deg", move |r| fixed(of(r).orientation_deg, 3))
            .below(4, name)
    });
    let columns = columns.both("standard deviation", "mm", |r| fixed(r.standard_deviation_mm, 3));
    Table::of(words, &table.rows, columns).on("Geometry, poses")
}

fn leads(document: &GeometricDocument, words: &Words) -> Table {
    let off = |l: &LeadResult| l.linearity.iter().fold(0.0f64, |m, p| m.max(p.deviation_mm.abs()));
    let columns = Columns::<LeadResult>::new()
        .page("actuator", "", |l| l.actuator)
        .page("nominal lead", "mm", |l| fixed(l.nominal_lead_mm, 3))
        .page("actual lead", "mm", |l| {
            with_uncertainty(l.actual_lead_mm, Some(l.standard_uncertainty * l.nominal_lead_mm))
        })
        .page("error", "µm per mm", |l| significant(1e3 * l.error, 3))
        .page("u (k = 1)", "µm per mm", |l| significant(1e3 * l.standard_uncertainty, 2))
        .page("largest mean deviation from linear", "µm", move |l| significant(1e3 * off(l), 2));
    Table::of(words, &document.leads, columns)
}

/// Commanded positions of all actuators.
fn linearity(document: &GeometricDocument, words: &Words) -> Table {
    let rows: Vec<(&LeadResult, &Linearity)> =
        document.leads.iter().flat_map(|l| l.linearity.iter().map(move |p| (l, p))).collect();
    let columns = Columns::<(&LeadResult, &Linearity)>::new()
        .sheet("actuator", "", |(l, _)| l.actuator)
        .sheet("nominal lead", "mm", |(l, _)| l.nominal_lead_mm)
        .sheet("actual lead", "mm", |(l, _)| l.actual_lead_mm)
        .sheet("relative error", "", |(l, _)| l.error)
        .sheet("u of it (k = 1)", "", |(l, _)| l.standard_uncertainty)
        .sheet("commanded", "mm", |(_, p)| p.commanded_mm)
        .sheet("mean deviation from linear", "mm", |(_, p)| p.deviation_mm);
    Table::of(words, &rows, columns).on("Geometry, leads")
}

/// Quality of each fit.
fn fits(document: &GeometricDocument, words: &Words) -> Table {
    let columns = Columns::<etalon_documents::GeometricStep>::new()
        .both("fit", "", |s| Text::document(&s.name, words))
        .both("residuals", "", |s| s.count)
        .both("standard deviation", "mm", |s| fixed(s.standard_deviation_mm, 4))
        .both("expected", "mm", |s| fixed(s.expected_mm, 4))
        .both("max", "mm", |s| fixed(s.max_mm, 4))
        .both("norm", "mm", |s| fixed(s.norm_mm, 4))
        .both("arc", "deg", |s| fixed(s.coverage_deg, 1))
        .both("uncertainties enlarged by", "", |s| significant(s.enlarged_by, 3));
    Table::of(words, &document.steps, columns).on("Geometry, fits")
}

/// Outlines of the regions, with the last one (every orientation) in a thicker line.
fn drawing(document: &GeometricDocument, words: &Words) -> Option<Figure> {
    let regions: Vec<_> = document.workspace.iter().filter(|r| r.corners_mm.len() > 2).collect();
    let corners: Vec<_> = regions.iter().flat_map(|r| &r.corners_mm).copied().collect();
    if corners.is_empty() || !corners.iter().flatten().all(|v| v.abs() < 1e7) {
        return None;
    }
    let mut map = Workspace::new(XY, &corners, words);
    let title = words.fill("Workspace of the platform's centre C, {0} plane", &[&"xy"]);
    let names = regions
        .iter()
        .map(|r| format!("{}: {} mm²", Text::document(&r.name, words).plain(), number::fixed(r.area_mm2, 0)));
    for region in &regions {
        let last = document.workspace.last().is_some_and(|l| l.name == region.name);
        for (a, b) in region.corners_mm.iter().zip(region.corners_mm.iter().cycle().skip(1)) {
            map.svg.line(if last { "arrow-scale" } else { "arrow-cal" }, map.at(*a), map.at(*b));
        }
    }
    let caption = words.say("Outlines of these regions; the heavier one is reached with every orientation.");
    let drawn = map.figure("workspace", title, names.collect::<Vec<_>>().join("; "));
    Some(Figure { title: words.say("Workspace"), caption, ..drawn })
}
