//! Tables of a test of poses to ISO 9283.

use super::part::Part;
use crate::dialect::quoted;
use crate::propose::meaning::{Interpretation, Meaning, PointSet};
use crate::propose::statements::{Lines, OPEN_UNIT};
use crate::propose::table::Table;
use etalon_base::phrase;
use etalon_tables::{Delimiter, Header};
use std::collections::BTreeSet;

/// Kinds of tables of a test to ISO 9283.
pub(super) const TABLES_OF_POSES: [&str; 3] = ["poses", "commanded", "reference"];

/// Returns one section for attained and commanded poses and reference targets; it names headings
/// that differ from etalon's own.
pub(super) fn poses(parts: &mut [Part]) -> Option<Lines> {
    let of_kind = |parts: &[Part], kind: &str| parts.iter().position(|part| part.document.kind == kind);
    let tables = tables_of_poses(parts);
    if let Some([attained, commanded]) = tables {
        parts[commanded].document.kind = "commanded".to_owned();
        parts[attained].document.kind = "poses".to_owned();
        let document = &mut parts[commanded].document;
        let settled = document.facts.without_attained.take();
        document.doubts.retain(|doubt| settled.is_none() || doubt.phrase() != settled.as_ref());
        for at in BTreeSet::from([attained, commanded]) {
            parts[at].document.because(phrase!("because-test-of-poses"));
        }
    }
    let other = || of_kind(parts, "poses").zip(of_kind(parts, "commanded")).map(|(a, c)| [a, c]);
    let [attained, commanded] = tables.or_else(other)?;
    let file = |at: usize| quoted(&parts[at].document.file);
    let is_of_tables = |at: usize| tables.is_some_and(|tables| tables.contains(&at));
    let own = |at: usize| parts[at].read.as_ref().filter(|_| is_of_tables(at));
    let set = |at: usize, is_commanded: bool| {
        let (table, found) = own(at)?;
        let set = if is_commanded { found.commanded_point().or(found.points.first()) } else { found.points.first() };
        Some(table_of_poses(table, found, set?, is_commanded))
    };
    let (of_attained, of_commanded) = (set(attained, false), set(commanded, true));
    let reference = of_kind(parts, "reference").map(|at| format!("reference = {}\n", file(at))).unwrap_or_default();
    let stated = |at: usize, form: &Option<Vec<String>>| match form {
        Some(keys) => format!("{{ file = {}, {} }}", file(at), keys.join(", ")),
        None => file(at),
    };
    let [of_attained, of_commanded] = [stated(attained, &of_attained), stated(commanded, &of_commanded)];
    let text = format!("attained = {of_attained}\ncommanded = {of_commanded}\n{reference}");
    let section = Lines::section("poses").with_text(text);
    let stated_here: Vec<usize> = [attained, commanded].into_iter().filter(|at| own(*at).is_some()).collect();
    stated_here.into_iter().for_each(|at| parts[at].lines = section.clone());
    Some(section)
}

/// Tables without a log that are a test of poses: poses that were attained in several cycles, and
/// each of these poses once, or a table that has both in each row.
fn tables_of_poses(parts: &[Part]) -> Option<[usize; 2]> {
    if parts.iter().any(|part| !["export", "commanded", "reference"].contains(&&*part.document.kind)) {
        return None;
    }
    let poses = |part: &Part| -> Option<(Vec<String>, bool)> {
        let (table, found) = part.read.as_ref().filter(|(_, found)| found.points.len() < 2)?;
        let [Some(_), Some(_), _] = found.points.first().or(found.commanded_point())?.columns else { return None };
        Some((table.columns[found.first(Meaning::Pose)?].texts(), found.first(Meaning::Cycle).is_some()))
    };
    let tables: Vec<(usize, Vec<String>, bool)> = parts
        .iter()
        .enumerate()
        .filter(|(_, part)| ["export", "commanded"].contains(&&*part.document.kind))
        .map(|(at, part)| poses(part).map(|(names, cycles)| (at, names, cycles)))
        .collect::<Option<_>>()?;
    let has_both = |at: usize| {
        let found = parts[at].read.as_ref().map(|(_, found)| found);
        found.is_some_and(|found| !found.points.is_empty() && found.commanded_point().is_some())
    };
    if let [(at, names, true)] = &tables[..]
        && has_both(*at)
        && names.iter().collect::<BTreeSet<&String>>().len() < names.len()
    {
        return Some([*at, *at]);
    }
    let [(a, of_a, in_cycles), (b, of_b, again)] = &tables[..] else { return None };
    let (attained, commanded, order) = match (in_cycles, again) {
        (true, false) => (of_a, of_b, [*a, *b]),
        (false, true) => (of_b, of_a, [*b, *a]),
        _ => return None,
    };
    let once: BTreeSet<&String> = commanded.iter().collect();
    let all = attained.iter().all(|pose| once.contains(pose));
    (once.len() == commanded.len() && all && attained.len() > commanded.len()).then_some(order)
}

/// Keys of a table of poses whose headings differ from etalon's own: its form and the columns of
/// its attained or commanded point.
fn table_of_poses(table: &Table, found: &Interpretation, set: &PointSet, is_commanded: bool) -> Vec<String> {
    let form = &table.form;
    let mut keys: Vec<String> = match &form.sheet {
        Some(sheet) => vec![format!("sheet = {}", quoted(sheet))],
        None => vec![
            format!("delimiter = {:?}", form.delimiter.map_or(",", Delimiter::name)),
            format!("decimal = {:?}", form.decimal().name()),
        ],
    };
    keys.extend(form.thousands.map(|mark| format!("thousands = {:?}", mark.name())));
    if let Header::Rows(rows @ 2..) = form.header() {
        keys.push(format!("header = {rows}"));
    }
    let mut columns: Vec<String> = Vec::new();
    let mut column = |name: String, at: usize| {
        let source = table.columns[at].name.as_deref().map_or_else(|| (at + 1).to_string(), quoted);
        columns.push(format!("{name} = {source}"));
    };
    for (name, meaning) in [("pose", Meaning::Pose), ("cycle", Meaning::Cycle)] {
        let of_table = found.first(meaning).filter(|_| !is_commanded || meaning == Meaning::Pose);
        of_table.into_iter().for_each(|at| column(name.to_owned(), at));
    }
    let unit = |at: usize| table.columns[at].heading.unit.unwrap_or(OPEN_UNIT);
    for (axis, at) in ["x", "y", "z"].into_iter().zip(set.columns) {
        at.into_iter().for_each(|at| column(format!("{axis}_{}", unit(at)), at));
    }
    let angles = if is_commanded && found.commanded.beside.is_some() { Vec::new() } else { found.rotation_columns() };
    for (name, at) in ["a", "b", "c"].into_iter().zip(angles) {
        column(format!("{name}_{}", unit(at)), at);
    }
    keys.push(format!("columns = {{ {} }}", columns.join(", ")));
    keys
}
