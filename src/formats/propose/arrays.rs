//! Proposal for a file of arrays of NumPy or MATLAB: an export of an array of three columns,
//! otherwise a log.

use super::several::{POSE_LINE, TARGET_LINE};
use super::with_remarks;
use crate::dialect::quoted;
use crate::logs::{ArrayParts, LogKind};
use etalon_base::message::Message;
use etalon_base::{error, phrase};
use etalon_documents::FormatsDocument;
use std::fmt::Write as _;

/// Proposes lines for the arrays of a file.
///
/// # Errors
/// Fails if the file cannot be read, or has no array of numbers with one or two axes.
pub(super) fn propose_arrays(file: &str, bytes: &[u8], format: LogKind) -> Result<FormatsDocument, Message> {
    let arrays = format.arrays(bytes)?;
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
        ["t", "time", "times", "timestamp", "stamp", "tout"].contains(&name.as_str())
    };
    let time = arrays.iter().filter(beside).find(is_time);
    if let [x, y, z] = &widest.parts[..] {
        // three columns: coordinates rather than joints
        document.kind = "export".to_owned();
        document.doubt(phrase!("doubt-array-columns", array = widest.name, count = 3));
        document.ask(phrase!("ask-unit"));
        document.ask(phrase!("ask-order-of-columns"));
        let times = time.map(|time| format!("time_s = {}, ", quoted(&time.name))).unwrap_or_default();
        let lines = format!(
            "[[export]]\nfile = {}\nformat = {{ sheet = {}, header = 1, columns = {{ {times}x = {}, y = {}, z = {} }} }}\n\
             unit = \"?\"                 # mm, m, um or inch: the file does not state it, and it is never guessed\n{TARGET_LINE}{}",
            quoted(file),
            quoted(&widest.name),
            quoted(x),
            quoted(y),
            quoted(z),
            if times.is_empty() { POSE_LINE } else { "" }
        );
        document.toml = with_remarks(&document, &lines);
        return Ok(document);
    }
    let mut columns: Vec<String> = Vec::new();
    if let Some(time) = time {
        columns.push(format!("time_s = {}", quoted(&time.name)));
        document.ask(phrase!("ask-seconds", name = time.name));
    }
    let joints: Vec<&String> = match widest.parts.len() {
        1 => {
            let others = arrays.iter().filter(beside).filter(|array| Some(&array.name) != time.map(|t| &t.name));
            others.flat_map(|array| &array.parts).collect()
        }
        _ => widest.parts.iter().collect(),
    };
    columns.extend((1..).zip(joints).map(|(number, part)| format!("q{number}_UNIT = {}", quoted(part))));
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
