//! Operator's sheet of a plan: what to take to the robot.

use crate::model::{Block, Cell, Columns, Section, Table, Text, fixed};
use crate::number::stated;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_documents::{PlanDocument, PlannedReflector};
use std::collections::BTreeMap;

/// End of the columns with directions of approach.
const DIRECTION: &str = "_direction";

/// A box to tick, and a line to write on.
const BOX: &str = "[   ]";
const LINE: &str = "____________________";

/// One configuration to measure.
struct Row<'a> {
    number: usize,
    pose: PoseName,
    label: String,
    values: &'a BTreeMap<String, f64>,
}

/// The sheet, on pages of its own.
pub(super) fn section(plan: &PlanDocument, words: &Words) -> Section {
    let mut section = Section::new("sheet", tr!(words, "operator-sheet"));
    section.push(Block::facts(set_up(plan, words)));
    let steps = steps(plan, words);
    let columns = Columns::<Text>::new().page(phrase!("sheet-step"), "", |step| step.clone()).page(
        phrase!("sheet-done"),
        "",
        |_| BOX,
    );
    section.table(tr!(words, "operator-sheet-before"), "", Table::new(words, &steps, columns));
    let rows = rows(plan);
    let first = rows.iter().take(1).flat_map(|row| row.values.keys().map(String::as_str));
    let joints: Vec<&str> = first.filter(|column| !column.ends_with(DIRECTION)).collect();
    let is_approached = rows.iter().any(|row| row.values.keys().any(|column| column.ends_with(DIRECTION)));
    let columns = Columns::<Row>::new()
        .page(phrase!("sheet-number"), "", |row| row.number)
        .page(phrase!("pose"), "", |row| row.pose)
        .page(phrase!("sheet-label"), "", |row| row.label.as_str());
    // assembly modes are integers
    let cell = |value: &f64| fixed(*value, if value.fract() == 0.0 { 0 } else { 3 });
    let columns = joints
        .iter()
        .fold(columns, |columns, joint| columns.page(*joint, "", move |row| row.values.get(*joint).map(cell)));
    let columns = match is_approached {
        true => columns.page(phrase!("sheet-approach"), "", |row| approach(row.values, words)),
        false => columns,
    };
    let columns = columns.page(phrase!("sheet-done"), "", |_| BOX);
    section.table(
        tr!(words, "operator-sheet-poses"),
        tr!(words, "operator-sheet-note"),
        Table::new(words, &rows, columns),
    );
    section.annex()
}

fn set_up(plan: &PlanDocument, words: &Words) -> Vec<(String, Cell)> {
    let point = |at: Vector| at.map(stated).join(", ");
    let program = plan.choice.program.as_ref();
    let file = program.map(|p| tr!(words, "sheet-program-value", file = &p.file, language = &p.language));
    let wait = program.map(|p| match &p.trigger {
        Some(output) => tr!(words, "sheet-wait-trigger", seconds = stated(p.dwell_s), output),
        None => tr!(words, "sheet-wait-seconds", seconds = stated(p.dwell_s)),
    });
    let generated = plan.choice.generated.as_ref();
    let instrument = generated.and_then(|g| g.instrument_mm).map(point);
    let mut facts: Vec<(String, Cell)> = vec![
        (tr!(words, "sheet-operator-date"), Text::from(LINE).into()),
        (tr!(words, "sheet-temperature"), Text::from(LINE).into()),
        (tr!(words, "sheet-program"), file.into()),
        (tr!(words, "sheet-wait"), wait.into()),
        (tr!(words, "sheet-instrument-at"), instrument.into()),
    ];
    let reflector = |reflector: &PlannedReflector| {
        let at = point(reflector.at_mm);
        let placed = match (reflector.axis, reflector.acceptance_deg) {
            (Some(axis), Some(angle)) => {
                tr!(words, "sheet-reflector-axis", at, axis = point(axis), angle = stated(angle))
            }
            _ => at,
        };
        (tr!(words, "sheet-reflector-at", name = &reflector.name), placed.into())
    };
    facts.extend(generated.iter().flat_map(|g| &g.reflectors).map(reflector));
    facts
}

/// Steps before the first pose.
fn steps(plan: &PlanDocument, words: &Words) -> Vec<Text> {
    let has_reflectors = plan.choice.generated.as_ref().is_some_and(|g| !g.reflectors.is_empty());
    let reflectors = has_reflectors.then(|| tr!(words, "sheet-step-reflectors"));
    [Some(tr!(words, "sheet-step-instrument")), reflectors]
        .into_iter()
        .flatten()
        .chain([tr!(words, "sheet-step-zero"), tr!(words, "sheet-step-slow"), tr!(words, "sheet-step-frame")])
        .map(Text::from)
        .collect()
}

/// Configurations in the order of measurement. A label has the form `{target}_{pose}_{cycle}`, with
/// the number of the configuration as cycle.
fn rows(plan: &PlanDocument) -> Vec<Row<'_>> {
    let reflectors = plan.choice.generated.iter().flat_map(|g| &g.reflectors);
    let names: Vec<&str> = reflectors.map(|reflector| reflector.name.as_str()).collect();
    let all = plan
        .in_order()
        .into_iter()
        .flat_map(|pose| pose.configurations.iter().zip(1..).map(move |(values, cycle)| (pose.pose, cycle, values)));
    let label = |pose: PoseName, cycle: usize| {
        let labels = names.iter().map(|name| format!("{name}_{pose}_{cycle}"));
        if names.is_empty() { format!("{pose}_{cycle}") } else { labels.collect::<Vec<_>>().join(", ") }
    };
    all.zip(1..)
        .map(|((pose, cycle, values), number)| Row { number, pose, label: label(pose, cycle), values })
        .collect()
}

/// Side from which each joint with backlash arrives.
fn approach(values: &BTreeMap<String, f64>, words: &Words) -> String {
    let side = |(column, direction): (&String, &f64)| {
        let joint = column.strip_suffix(DIRECTION)?;
        Some(match *direction > 0.0 {
            true => tr!(words, "sheet-approach-below", joint),
            false => tr!(words, "sheet-approach-above", joint),
        })
    };
    values.iter().filter_map(side).collect::<Vec<_>>().join(", ")
}
