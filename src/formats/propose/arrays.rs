//! Proposal for a file of arrays of NumPy or MATLAB: an export of an array of three columns,
//! otherwise a log.

use super::meaning::Interpretation;
use super::several::{POSE_LINE, TARGET_LINE};
use super::table::{Column, MOST_ROWS, Table};
use super::with_remarks;
use crate::dialect::quoted;
use crate::logs::{ArrayFile, ArrayParts, LogKind};
use etalon_base::message::Message;
use etalon_base::{error, phrase};
use etalon_documents::FormatsDocument;
use std::fmt::Write as _;

/// Proposes lines for the arrays of a file.
///
/// # Errors
/// Fails if the file cannot be read, or has no array of numbers with one or two axes.
pub(super) fn propose_arrays(file: &str, contents: &ArrayFile, format: LogKind) -> Result<FormatsDocument, Message> {
    let arrays = format.arrays(contents)?;
    // joints are the parts of the array with the most parts
    let widest = arrays.iter().filter(|array| array.count > 1).max_by_key(|array| (array.parts.len(), array.count));
    let Some(widest) = widest else { return Err(error!("no-rows-of-numbers", file = "arrays")) };
    let about = format.about();
    let mut document = FormatsDocument {
        schema: "etalon/formats/1".to_owned(),
        file: file.to_owned(),
        format: Some(about.name.to_owned()),
        kind: "log".to_owned(),
        rows: widest.count,
        ..FormatsDocument::default()
    };
    document.because(phrase!("because-arrays", format = about.title));
    let shown = |array: &ArrayParts| format!("`{}` ({} x {})", array.name, array.count, array.parts.len());
    let all: Vec<String> = arrays.iter().map(shown).collect();
    document.because(phrase!("because-arrays-of-numbers", arrays = all));
    let beside = |array: &&ArrayParts| array.count == widest.count && array.parts.len() == 1;
    let is_time = |array: &&ArrayParts| {
        let name = array.name.rsplit('.').next().unwrap_or_default().to_lowercase();
        ["t", "time", "times", "timestamp", "stamp", "tout", "zeit"].contains(&name.as_str())
    };
    let time = arrays.iter().filter(beside).find(is_time);
    let times = time.map(|time| format!("time_s = {}, ", quoted(&time.name))).unwrap_or_default();
    if let Some(columns) = columns_of_poses(contents, format, widest) {
        document.kind = "export".to_owned();
        document.doubt(phrase!("doubt-array-columns", array = widest.name, count = widest.parts.len()));
        document.doubt(phrase!("doubt-quaternion-order"));
        document.ask(phrase!("ask-unit"));
        let lines = export_lines(file, widest, &times, &columns);
        document.toml = with_remarks(&document, &lines);
        return Ok(document);
    }
    if let [x, y, z] = &widest.parts[..] {
        // three columns: coordinates rather than joints
        document.kind = "export".to_owned();
        document.doubt(phrase!("doubt-array-columns", array = widest.name, count = 3));
        document.ask(phrase!("ask-unit"));
        document.ask(phrase!("ask-order-of-columns"));
        let columns = format!("x = {}, y = {}, z = {}", quoted(x), quoted(y), quoted(z));
        let lines = export_lines(file, widest, &times, &columns);
        document.toml = with_remarks(&document, &lines);
        return Ok(document);
    }
    let mut columns: Vec<String> = Vec::new();
    if let Some(time) = time {
        columns.push(format!("time_s = {}", quoted(&time.name)));
        if format.column_unit(&time.name).is_none() {
            document.ask(phrase!("ask-seconds", name = time.name));
        }
    }
    let joints: Vec<&String> = match widest.parts.len() {
        1 => {
            let others = arrays.iter().filter(beside).filter(|array| Some(&array.name) != time.map(|t| &t.name));
            others.flat_map(|array| &array.parts).collect()
        }
        _ => widest.parts.iter().collect(),
    };
    let unit = |part: &str| format.column_unit(part).unwrap_or("UNIT");
    columns.extend((1..).zip(joints).map(|(number, part)| format!("q{number}_{} = {}", unit(part), quoted(part))));
    let parts = widest.parts.len();
    if !(4..=8).contains(&parts) && parts > 1 {
        document.doubt(phrase!("doubt-array-columns", array = widest.name, count = parts));
    }
    document.ask(phrase!("ask-joints"));
    let mut lines = String::new();
    let _ = write!(
        lines,
        "[log]\nfile = {}\nformat = \"{}\"\ncolumns = {{ {} }}\n",
        quoted(file),
        about.name,
        columns.join(", ")
    );
    document.toml = with_remarks(&document, &lines);
    Ok(document)
}

/// Lines of an export of an array, with its column of times and those of its points.
fn export_lines(file: &str, array: &ArrayParts, times: &str, columns: &str) -> String {
    format!(
        "[[export]]\nfile = {}\nformat = {{ sheet = {}, header = 1, columns = {{ {times}{columns} }} }}\n\
         unit = \"?\"                 # mm, m, um or inch: the file does not state it, and it is never guessed\n{TARGET_LINE}{}",
        quoted(file),
        quoted(&array.name),
        if times.is_empty() { POSE_LINE } else { "" }
    )
}

/// Columns of positions and quaternions of an array, if its values are such: four of its seven
/// parts have the norm 1 in all rows.
fn columns_of_poses(contents: &ArrayFile, format: LogKind, array: &ArrayParts) -> Option<String> {
    let parts: Vec<&str> = array.parts.iter().map(String::as_str).collect();
    let text = format.table(contents, &parts)?.ok()?;
    let mut columns = vec![Column::default(); parts.len()];
    let rows = text.lines().skip(1).take(MOST_ROWS);
    for (cells, column) in rows.flat_map(|line| line.split('\t').zip(0..)) {
        columns.get_mut::<usize>(column)?.values.push(cells.trim().parse().unwrap_or(f64::NAN));
    }
    let table = Table { rows: columns.first()?.values.len(), width: columns.len(), columns, sampled: false };
    let found = Interpretation::new(&table);
    let quaternion = found.quaternion_columns();
    let [Some(x), Some(y), Some(z)] = found.points.first()?.columns else { return None };
    let named = ["x", "y", "z", "qw", "qx", "qy", "qz"].into_iter().zip([x, y, z].into_iter().chain(quaternion));
    let columns: Vec<String> = named.map(|(name, at)| format!("{name} = {}", quoted(parts[at]))).collect();
    (columns.len() == 7).then(|| columns.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of an array with seven parts (NEP 1).
    fn npy(values: &[f64]) -> Vec<u8> {
        let shape = format!("({}, 7)", values.len() / 7);
        let mut head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}");
        head += &" ".repeat(63 - (10 + head.len()) % 64);
        head.push('\n');
        let data: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        [crate::magic::NUMPY, b"\x01\x00", &(head.len() as u16).to_le_bytes(), head.as_bytes(), &data].concat()
    }

    #[test]
    fn an_array_of_positions_and_quaternions_is_an_export() {
        let row = |i: usize| {
            let (t, half) = (i as f64, 0.05 * i as f64);
            [0.5 + 0.1 * t.sin(), 0.2 * t.cos(), 0.9 - 0.01 * t, 0.0, half.sin(), 0.0, half.cos()]
        };
        let values: Vec<f64> = (0..20).flat_map(row).collect();
        let proposed = |values: &[f64]| {
            let bytes = npy(values);
            propose_arrays("p.npy", &bytes.as_slice().into(), LogKind::from_array_file(&bytes).unwrap()).unwrap()
        };
        let document = proposed(&values);
        assert_eq!(document.kind, "export", "{}", document.toml);
        assert!(document.toml.contains("x = ") && document.toml.contains("qw = "), "{}", document.toml);
        let joints: Vec<f64> = values.iter().map(|v| 1.3 * v).collect();
        let document = proposed(&joints);
        assert_eq!(document.kind, "log", "{}", document.toml);
    }
}
