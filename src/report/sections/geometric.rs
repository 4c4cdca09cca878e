//! Geometric calibration compared with the identification: its results, and its accuracy.

use crate::model::{Block, Columns, Figure, Section, Table, Text, fixed, numbers, significant, with_uncertainty};
use crate::number;
use crate::plots::workspace::{Workspace, XY};
use crate::words::{Words, names, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{
    BarVerdict, GeometricDocument, GeometricQuantity, LeadResult, Linearity, MeanError, PoseRow, PoseTable, Results,
};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let document = results.geometric.as_ref()?;
    let title = match &results.identified {
        Some(_) => tr!(words, "geometry-beside-identification"),
        None => tr!(words, "geometry-alone"),
    };
    let mut section = Section::new("geometric", title);
    if results.identified.is_some() {
        section.push(Block::strong(sentence(document, words)));
    }
    section.push(Block::note(Text::worded(&document.definition, words)));
    section.push(Block::Table(quantities(document, words)));
    section.push(Block::note(tr!(words, "geometric-u-note")));
    if let Some(d) = document.quantities.iter().find(|q| q.name == "d") {
        section.push(Block::note(match d.uncertainty_by_angles {
            Some(_) => tr!(words, "geometric-u-with-angles"),
            None => tr!(words, "geometric-u-without-angles"),
        }));
    }
    for table in &document.tables {
        section.push(Block::heading(&table.title));
        section.push(Block::Table(poses(table, words)));
    }
    let columns = Columns::<etalon_documents::MethodErrors>::new()
        .page(phrase!("method"), "", |m| {
            names::method(&m.name).map_or_else(|| Text::name(&m.name), |p| Text::name(&words.tr(&p)))
        })
        .sheet(phrase!("method"), "", |m| m.name.as_str())
        .both(phrase!("position-max"), "mm", |m| fixed(m.position_max_mm, 3))
        .both(phrase!("position-rms"), "mm", |m| fixed(m.position_rms_mm, 3))
        .both(phrase!("orientation-max"), "deg", |m| fixed(m.orientation_max_deg, 3));
    section.table(
        tr!(words, "all-tables"),
        "",
        Table::new(words, &document.methods, columns).on(phrase!("sheet-geometry-methods")),
    );
    section.table(tr!(words, "leads"), "", leads(document, words));
    section.push(Block::Table(linearity(document, words)));
    let columns = Columns::<etalon_documents::ScaleBarResult>::new()
        .both(phrase!("position"), "", |b| b.name.as_str())
        .both(phrase!("length"), "mm", |b| fixed(b.length_mm, 4))
        .both(phrase!("distances"), "", |b| b.count)
        .both(phrase!("mean-error"), "mm", |b| fixed(b.mean_error_mm, 4))
        .both(phrase!("standard-deviation"), "mm", |b| fixed(b.standard_deviation_mm, 4))
        .both(phrase!("largest-error"), "mm", |b| fixed(b.largest_error_mm, 4))
        .both(phrase!("permissible"), "mm", |b| fixed(b.permissible_error_mm, 4))
        .both(phrase!("permissible-over-certificate"), "", |b| significant(b.uncertainty_ratio, 2))
        .page(phrase!("verdict"), "", |b| Text::name(&bar_verdict(b.verdict, words)))
        .sheet(phrase!("verdict"), "", |b| bar_verdict(b.verdict, words));
    let bars = Table::new(words, &document.scale_bars, columns).on(phrase!("sheet-geometry-scale-bars"));
    section.table(tr!(words, "scale-bars"), "", bars);
    let columns = Columns::<etalon_documents::BallResult>::new()
        .both(phrase!("ball"), "", |b| b.name.as_str())
        .both(phrase!("readings"), "", |b| b.count)
        .both(phrase!("mean-distance-from-mean"), "mm", |b| fixed(b.mean_mm, 4))
        .both(phrase!("standard-deviation"), "mm", |b| fixed(b.standard_deviation_mm, 4))
        .both(phrase!("mean-plus-3s"), "mm", |b| fixed(b.repeatability_mm, 4));
    let balls = Table::new(words, &document.balls, columns).on(phrase!("sheet-geometry-balls"));
    section.table(tr!(words, "single-balls"), "", balls);
    section.table(tr!(words, "fits"), "", fits(document, words));
    let columns = Columns::<etalon_documents::Region>::new()
        .both(phrase!("region-of-c"), "", |r| Text::worded(&r.name, words))
        .both(phrase!("area"), "mm²", |r| fixed(r.area_mm2, 0))
        .both(phrase!("corners"), "", |r| r.corners_mm.len());
    let regions = Table::new(words, &document.workspace, columns).on(phrase!("sheet-geometry-workspace"));
    section.table(tr!(words, "workspace"), "", regions);
    section.figures(drawing(document, words));
    section.whole()
}

fn bar_verdict(verdict: BarVerdict, words: &Words) -> String {
    match verdict {
        BarVerdict::Conforming => tr!(words, "conforming"),
        BarVerdict::NotConforming => tr!(words, "not-conforming"),
        BarVerdict::BarTooUncertain => tr!(words, "bar-too-uncertain"),
        BarVerdict::NoCertificate => tr!(words, "no-certificate-stated"),
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
    let alone = tr!(
        words,
        "geometry-improvement",
        nominal = mm(nominal),
        geometric = mm(geometric),
        improvement = times(nominal, geometric)
    );
    let beside = tr!(
        words,
        "identification-against-geometry",
        identified = mm(identified),
        ratio = times(geometric, identified)
    );
    format!("{alone} {beside}")
}

fn quantities(document: &GeometricDocument, words: &Words) -> Table {
    let u = |q: &GeometricQuantity| Some(q.standard_uncertainty);
    let columns = Columns::<GeometricQuantity>::new()
        .both(phrase!("name"), "", |q| q.name.as_str())
        .both(phrase!("unit"), "", |q| q.unit.as_str())
        .both(phrase!("nominal"), "", move |q| with_uncertainty(q.nominal, u(q)))
        .both(phrase!("geometric"), "", move |q| with_uncertainty(q.value, u(q)))
        .both("u (k = 1)", "", |q| significant(q.standard_uncertainty, 2))
        .both(phrase!("head-u-by-angles"), "", |q| significant(q.uncertainty_by_angles, 2))
        .both(phrase!("repeats"), "", |q| q.repeats.as_ref().map(|r| r.count))
        .both(phrase!("their-standard-deviation"), "", |q| {
            significant(q.repeats.as_ref().map(|r| r.standard_deviation), 2)
        })
        .both(phrase!("expected-from-the-points"), "", |q| significant(q.repeats.as_ref().map(|r| r.expected), 2))
        .both(phrase!("identified"), "", |q| {
            q.identified.map(|v| with_uncertainty(v, q.identified_standard_uncertainty))
        })
        .sheet(phrase!("u-of-identified"), "", |q| q.identified_standard_uncertainty)
        .page(phrase!("identified-minus-geometric"), "", move |q| {
            q.identified.map(|v| with_uncertainty(v - q.value, u(q)))
        });
    Table::new(words, &document.quantities, columns).without_empty_columns().on(phrase!("sheet-geometry-quantities"))
}

/// Mean errors of the poses in a table, by method.
fn poses(table: &PoseTable, words: &Words) -> Table {
    let command = |r: &PoseRow| {
        let [x, y] = r.command_mm;
        let [x, y, turned] = [words.fixed(x, 3), words.fixed(y, 3), words.fixed(r.command_deg, 2)];
        format!("{x}, {y} mm, {turned} deg")
    };
    let first = Columns::<PoseRow>::new()
        .sheet(phrase!("table"), "", |_| table.title.as_str())
        .both(phrase!("pose"), "", |r| r.pose)
        .page(phrase!("command"), "", move |r| numbers(command(r)))
        .sheet(phrase!("command-x"), "mm", |r| r.command_mm[0])
        .sheet(phrase!("command-y"), "mm", |r| r.command_mm[1])
        .sheet(phrase!("command-theta"), "deg", |r| r.command_deg)
        .sheet(phrase!("visits"), "", |r| r.count);
    type Method = (Phrase, fn(&PoseRow) -> &MeanError);
    let methods: [Method; 3] = [
        (phrase!("nominal"), |r| &r.nominal),
        (phrase!("geometric"), |r| &r.geometric),
        (phrase!("identified"), |r| &r.identified),
    ];
    let columns = methods.into_iter().fold(first, |columns, (name, of)| {
        columns
            .both("x", "mm", move |r| fixed(of(r).x_mm, 3))
            .both("y", "mm", move |r| fixed(of(r).y_mm, 3))
            .both("x y", "mm", move |r| fixed(of(r).position_mm, 3))
            .both("θ", "deg", move |r| fixed(of(r).orientation_deg, 3))
            .below(4, name)
    });
    let columns = columns.both(phrase!("standard-deviation"), "mm", |r| fixed(r.standard_deviation_mm, 3));
    Table::new(words, &table.rows, columns).on(phrase!("sheet-geometry-poses"))
}

fn leads(document: &GeometricDocument, words: &Words) -> Table {
    let off = |l: &LeadResult| l.linearity.iter().fold(0.0f64, |m, p| m.max(p.deviation_mm.abs()));
    let columns = Columns::<LeadResult>::new()
        .page(phrase!("actuator"), "", |l| l.actuator)
        .page(phrase!("nominal-lead"), "mm", |l| fixed(l.nominal_lead_mm, 3))
        .page(phrase!("actual-lead"), "mm", |l| {
            with_uncertainty(l.actual_lead_mm, Some(l.standard_uncertainty * l.nominal_lead_mm))
        })
        .page(phrase!("error"), "µm per mm", |l| significant(1e3 * l.error, 3))
        .page("u (k = 1)", "µm per mm", |l| significant(1e3 * l.standard_uncertainty, 2))
        .page(phrase!("largest-mean-deviation-from-linear"), "µm", move |l| significant(1e3 * off(l), 2));
    Table::new(words, &document.leads, columns)
}

/// Commanded positions of all actuators.
fn linearity(document: &GeometricDocument, words: &Words) -> Table {
    let rows: Vec<(&LeadResult, &Linearity)> =
        document.leads.iter().flat_map(|l| l.linearity.iter().map(move |p| (l, p))).collect();
    let columns = Columns::<(&LeadResult, &Linearity)>::new()
        .sheet(phrase!("actuator"), "", |(l, _)| l.actuator)
        .sheet(phrase!("nominal-lead"), "mm", |(l, _)| l.nominal_lead_mm)
        .sheet(phrase!("actual-lead"), "mm", |(l, _)| l.actual_lead_mm)
        .sheet(phrase!("relative-error"), "", |(l, _)| l.error)
        .sheet(phrase!("u-of-deviation"), "", |(l, _)| l.standard_uncertainty)
        .sheet(phrase!("head-commanded"), "mm", |(_, p)| p.commanded_mm)
        .sheet(phrase!("mean-deviation-from-linear"), "mm", |(_, p)| p.deviation_mm);
    Table::new(words, &rows, columns).on(phrase!("sheet-geometry-leads"))
}

/// Quality of each fit.
fn fits(document: &GeometricDocument, words: &Words) -> Table {
    let columns = Columns::<etalon_documents::GeometricStep>::new()
        .both(phrase!("fit"), "", |s| Text::worded(&s.name, words))
        .both(phrase!("residuals"), "", |s| s.count)
        .both(phrase!("standard-deviation"), "mm", |s| fixed(s.standard_deviation_mm, 4))
        .both(phrase!("expected"), "mm", |s| fixed(s.expected_mm, 4))
        .both(phrase!("max"), "mm", |s| fixed(s.max_mm, 4))
        .both(phrase!("norm"), "mm", |s| fixed(s.norm_mm, 4))
        .both(phrase!("arc"), "deg", |s| fixed(s.coverage_deg, 1))
        .both(phrase!("uncertainties-enlarged-by"), "", |s| significant(s.enlarged_by, 3));
    Table::new(words, &document.steps, columns).on(phrase!("sheet-geometry-fits"))
}

/// Outlines of the regions, with the last one (every orientation) in a thicker line.
fn drawing(document: &GeometricDocument, words: &Words) -> Option<Figure> {
    let regions: Vec<_> = document.workspace.iter().filter(|r| r.corners_mm.len() > 2).collect();
    let corners: Vec<_> = regions.iter().flat_map(|r| &r.corners_mm).copied().collect();
    if corners.is_empty() || !corners.iter().flatten().all(|v| v.abs() < 1e7) {
        return None;
    }
    let mut map = Workspace::new(XY, &corners, words);
    let title = tr!(words, "workspace-plane", plane = "xy");
    let names = regions
        .iter()
        .map(|r| format!("{}: {} mm²", Text::worded(&r.name, words).plain(), number::fixed(r.area_mm2, 0)));
    for region in &regions {
        let last = document.workspace.last().is_some_and(|l| l.name == region.name);
        for (a, b) in region.corners_mm.iter().zip(region.corners_mm.iter().cycle().skip(1)) {
            map.svg.line(if last { "arrow-scale" } else { "arrow-cal" }, map.at(*a), map.at(*b));
        }
    }
    let caption = tr!(words, "workspace-outlines");
    let drawn = map.figure("workspace", title, names.collect::<Vec<_>>().join("; "));
    Some(Figure { title: tr!(words, "workspace"), caption, ..drawn })
}
