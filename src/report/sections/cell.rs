//! Frames of a robot cell: the answer with its uncertainty, the residuals, and the lines for a
//! controller.

use crate::CellLines;
use crate::model::{
    Block, Cell, Columns, Grade, Section, Step, Table, Text, Verdict, fixed, significant, term, um, with_uncertainty,
};
use crate::sections::messages;
use crate::words::{Words, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_documents::{CellAxisEntry, CellDocument, CellResidualEntry};

/// Coverage factor of given uncertainties.
const COVERAGE: f64 = 2.0;

/// A frame or a point.
struct Row {
    name: Phrase,
    xyz_mm: Vector,
    u_mm: Option<Vector>,
    /// Orientation and its uncertainty (deg); points have none.
    turned: Option<([f64; 4], Option<Vector>)>,
}

fn rows(document: &CellDocument) -> Vec<Row> {
    let frames = document.frames.iter().map(|f| Row {
        name: phrase!("cell-frame", name = f.name, reference = f.reference),
        xyz_mm: f.xyz_mm,
        u_mm: f.standard_uncertainty_mm,
        turned: Some((f.quaternion, f.standard_uncertainty_deg)),
    });
    let points = document.points.iter().map(|p| Row {
        name: phrase!("cell-point", name = p.name, reference = p.reference),
        xyz_mm: p.xyz_mm,
        u_mm: p.standard_uncertainty_mm,
        turned: None,
    });
    frames.chain(points).collect()
}

/// Expanded uncertainties of three coordinates, in a unit.
fn expanded(u: Vector, factor: f64, words: &Words) -> String {
    u.map(|u| words.significant(factor * COVERAGE * u, 2)).join(", ")
}

/// Answer with its uncertainty, and the next step.
pub(crate) fn verdict(document: &CellDocument, lines: Option<CellLines>, words: &Words) -> Verdict {
    let sentence = |row: &Row| {
        let frame = words.tr(&row.name);
        let Some(u_mm) = row.u_mm else { return tr!(words, "cell-verdict-unknown", frame) };
        let um = expanded(u_mm, 1e3, words);
        let u_deg = row.turned.and_then(|(_, u_deg)| u_deg);
        let deg = u_deg.map(|u_deg| expanded(u_deg, 1.0, words)).unwrap_or_default();
        tr!(words, "cell-verdict-known", frame, um, turned = if u_deg.is_some() { "yes" } else { "no" }, deg)
    };
    let rows = rows(document);
    let mut sentences: Vec<String> = rows.iter().map(sentence).collect();
    let scale = document.axis.as_ref().and_then(|axis| Some((axis.scale, axis.scale_standard_uncertainty?)));
    sentences.extend(scale.map(|(scale, u)| {
        let [scale, u] = [scale, COVERAGE * u].map(|v| words.decimal(format!("{v:.6}")));
        tr!(words, "cell-verdict-axis", scale, u)
    }));
    let count = document.messages.len() + lines.map_or(0, |lines| lines.messages.len());
    if count > 0 {
        sentences.push(tr!(words, "cell-verdict-warnings", count));
    }
    let known = rows.iter().all(|row| row.u_mm.is_some()) && (!rows.is_empty() || scale.is_some());
    let met = document.errors().next().is_none();
    let class = match (known, count) {
        _ if !met => Grade::Bad,
        (false, _) => Grade::Open,
        (true, 0) => Grade::Good,
        (true, _) => Grade::Conditional,
    };
    let steps = steps(document, lines, words);
    Verdict { met, class, sentences, steps, ..Verdict::default() }
}

fn steps(document: &CellDocument, lines: Option<CellLines>, words: &Words) -> Vec<Step> {
    let step =
        |what: String, reason: String| Step { what: what.into(), reason: reason.into(), command: None, file: None };
    let mut all = Vec::new();
    let checked = document.noise.iter().any(|noise| noise.standard_deviation.is_some());
    if document.errors().next().is_some() {
        // nothing is to be loaded before the errors are corrected
        return vec![step(tr!(words, "cell-step-messages"), tr!(words, "cell-step-messages-reason"))];
    }
    if !checked {
        all.push(step(tr!(words, "cell-step-measure"), tr!(words, "cell-step-measure-reason")));
    } else if !document.messages.is_empty() {
        all.push(step(tr!(words, "cell-step-messages"), tr!(words, "cell-step-messages-reason")));
    }
    all.push(match lines {
        Some(lines) => step(tr!(words, "cell-step-load", maker = lines.maker), tr!(words, "cell-step-load-reason")),
        None => step(tr!(words, "cell-step-choose"), tr!(words, "cell-step-choose-reason")),
    });
    all
}

/// Frames, lines for the controller, residuals, and warnings.
pub(crate) fn sections(document: &CellDocument, lines: Option<CellLines>, words: &Words) -> Vec<Section> {
    let of_lines: &[Message] = lines.map_or(&[], |lines| lines.messages);
    let said: Vec<&Message> = document.messages.iter().chain(of_lines).collect();
    let all = [
        Some(frames(document, words)),
        lines.map(|lines| controller(lines, words)),
        Some(residuals(document, words)),
        Some(messages::section_from_messages(&said, words)),
    ];
    all.into_iter().flatten().filter_map(Section::whole).collect()
}

fn frames(document: &CellDocument, words: &Words) -> Section {
    let mut section = Section::new("cell", tr!(words, "cell-frames"));
    let rows = rows(document);
    section.push(Block::Table(positions(&rows, words)));
    let turned: Vec<&Row> = rows.iter().filter(|row| row.turned.is_some()).collect();
    if !turned.is_empty() {
        section.push(Block::Table(orientations(turned, words)));
    }
    section.push(Block::note(tr!(words, "cell-frames-note")));
    if let Some(axis) = &document.axis {
        section.push(Block::facts(facts(axis, words)));
    }
    section.on_terminal()
}

fn positions(rows: &[Row], words: &Words) -> Table {
    let u = |row: &Row, k: usize| row.u_mm.map(|u| u[k]);
    let mut columns = Columns::<Row>::new().both(phrase!("cell-head-frame"), "", |row| term(words, row.name.clone()));
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        columns = columns.both(axis, "mm", move |row| with_uncertainty(row.xyz_mm[k], u(row, k)));
    }
    for (k, axis) in ["U(x)", "U(y)", "U(z)"].into_iter().enumerate() {
        columns = columns.both(axis, "mm", move |row| um(u(row, k).map(|u| COVERAGE * u))).in_unit("µm");
    }
    Table::new(words, rows, columns).on(phrase!("sheet-cell-frames"))
}

fn orientations<'a>(rows: Vec<&'a Row>, words: &'a Words) -> Table {
    let q = |row: &Row, k: usize| row.turned.map(|(q, _)| q[k]);
    let u = |row: &Row, k: usize| row.turned.and_then(|(_, u)| Some(COVERAGE * u?[k]));
    let mut columns = Columns::<Row>::new().both(phrase!("cell-head-frame"), "", |row| term(words, row.name.clone()));
    for (k, part) in ["qw", "qx", "qy", "qz"].into_iter().enumerate() {
        columns = columns.both(part, "", move |row| fixed(q(row, k), 7));
    }
    for (k, axis) in ["U(rx)", "U(ry)", "U(rz)"].into_iter().enumerate() {
        columns = columns.both(axis, "deg", move |row| significant(u(row, k), 2));
    }
    Table::new(words, rows, columns).on(phrase!("sheet-cell-frames"))
}

fn facts(axis: &CellAxisEntry, words: &Words) -> Vec<(String, Cell)> {
    let direction = axis.direction.map(|v| words.decimal(format!("{v:.7}"))).join("; ");
    let radius = axis.radius_mm.map(|mm| format!("{} mm", words.decimal(format!("{mm:.4}"))));
    let scale = with_uncertainty(axis.scale, axis.scale_standard_uncertainty);
    vec![
        (tr!(words, "direction"), direction.into()),
        (tr!(words, "cell-motion-by-value"), scale),
        (tr!(words, "radius"), radius.into()),
    ]
}

fn controller(lines: CellLines, words: &Words) -> Section {
    let mut section = Section::new("controller", tr!(words, "cell-controller-lines", maker = lines.maker));
    section.push(Block::note(tr!(words, "cell-controller-written", maker = lines.maker)));
    for line in lines.text.lines().filter(|line| !line.trim().is_empty()) {
        section.push(Block::text(Text::code(line)));
    }
    section
}

fn residuals(document: &CellDocument, words: &Words) -> Section {
    let mut section = Section::new("residuals", tr!(words, "cell-residuals-title"));
    for noise in &document.noise {
        let Some(deviation) = noise.standard_deviation else { continue };
        section.push(Block::text(words.tr(&phrase!(
            "cell-residuals",
            measure = noise.measure,
            deviation = words.decimal(format!("{deviation:.5}")),
            redundancy = format!("{:.0}", noise.redundancy),
            source = noise.uncertainties_from
        ))));
    }
    let measure = |r: &CellResidualEntry| match r.measure.as_str() {
        "position" => term(words, phrase!("cell-measure-position")),
        _ => term(words, phrase!("cell-measure-orientation")),
    };
    let unit = |r: &CellResidualEntry| if r.measure == "position" { "mm" } else { "deg" };
    let mut columns = Columns::<CellResidualEntry>::new().both(phrase!("line"), "", |r| r.line).both(
        phrase!("cell-head-measure"),
        "",
        measure,
    );
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        columns = columns.both(axis, "", move |r| fixed(r.residual[k], 4));
    }
    columns = columns
        .both(phrase!("cell-head-length"), "", |r| fixed(r.length, 4))
        .both(phrase!("unit"), "", unit)
        .both("p", "", |r| significant(r.probability, 2));
    section.push(Block::Table(Table::new(words, &document.residuals, columns).on(phrase!("sheet-cell-residuals"))));
    section.push(Block::note(tr!(words, "cell-residuals-note")));
    section
}
