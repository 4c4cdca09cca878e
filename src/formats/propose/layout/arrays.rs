//! Proposal for a file of arrays of NumPy or MATLAB: an export of an array of three columns,
//! otherwise a log.

use crate::dialect::{ColumnRole, quoted};
use crate::logs::{ArrayFile, ArrayParts, LogKind};
use crate::propose::coordinates::FEWEST_OF_POINTS;
use crate::propose::headings::{Heading, Word};
use crate::propose::lines::{fitted_unit_line, joint_column, roles, unit_line};
use crate::propose::meaning::{Evidence, Interpretation, Meaning, PointSet};
use crate::propose::statements::{Line, Lines, OPEN_TIME, OPEN_UNIT, Target};
use crate::propose::table::{Column, MOST_ROWS, Table};
use crate::propose::{Correct, Proposed, columns};
use etalon_base::message::Message;
use etalon_base::{error, phrase};
use etalon_documents::FormatsDocument;

/// Proposes lines for the arrays of a file.
///
/// # Errors
/// Fails if the file cannot be read, or has no array of numbers with one or two axes.
pub(crate) fn propose_arrays(
    file: &str,
    contents: &ArrayFile,
    format: LogKind,
    correct: Option<Correct>,
) -> Result<Proposed, Message> {
    let arrays = format.arrays(contents)?;
    let Some(widest) = most_likely(&arrays, contents, format) else {
        return Err(error!("no-rows-of-numbers", file = "arrays"));
    };
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
    let (mut table, mut found) = interpreted(&arrays, widest, contents, format)?;
    other_arrays(&arrays, widest, &mut found);
    correct.into_iter().for_each(|correct| correct(&mut table, &mut found).add_to(&mut document));
    found.doubts.iter().for_each(|doubt| document.doubt(doubt.text.clone()));
    found.questions.iter().for_each(|question| document.ask(question.text.clone()));
    document.columns = columns(&table, &found);
    let lines = match found.points.first() {
        Some(points) => {
            document.kind = "export".to_owned();
            let unit = points.columns[0].and_then(|at| table.columns[at].heading.unit);
            if unit.is_none() {
                document.ask(phrase!("ask-unit"));
            }
            let sets = 0..found.points.len();
            let head = Lines::element("export").with(Line::File(file.to_owned()));
            sets.flat_map(|set| [head.clone(), array_lines(widest, &table, &found, set, unit)]).collect()
        }
        None => {
            let joints = found.joint_columns();
            if !found.by_kinematics && joints.iter().any(|at| table.columns[*at].heading.unit.is_none()) {
                document.ask(phrase!("ask-joints"));
            } else if !found.by_kinematics {
                document.ask(phrase!("ask-joints-of-format"));
            }
            log_lines(file, about.name, &table, &found)
        }
    };
    Ok(Proposed::with_remarks(document, lines))
}

/// Names of arrays of accelerations, rates and forces, in lower case.
const MOTIONS: [&str; 12] = ["a", "acc", "accel", "w", "omega", "gyro", "gyr", "f", "force", "torque", "tau", "mag"];

/// Returns the array with the most parts, whose parts are joints or coordinates. Of several arrays
/// of one size it is the first measured one whose values show what they are.
fn most_likely<'a>(arrays: &'a [ArrayParts], contents: &ArrayFile, format: LogKind) -> Option<&'a ArrayParts> {
    // an array without a name is a part of an object of a class, whose form only MATLAB knows
    let is_measured = |array: &&ArrayParts| {
        let name = array.name.rsplit('.').next().unwrap_or_default().to_lowercase();
        let is_other = MOTIONS.contains(&name.as_str()) || TIMES.contains(&name.as_str());
        array.count > 1 && array.parts.iter().all(|part| !part.is_empty()) && !is_other
    };
    let named: Vec<&ArrayParts> = arrays.iter().filter(is_measured).collect();
    let size = |array: &ArrayParts| (array.parts.len(), array.count);
    let most = named.iter().map(|array| size(array)).max()?;
    let mut alike: Vec<&ArrayParts> = named.into_iter().filter(|array| size(array) == most).collect();
    if alike.iter().any(|array| !is_commanded(array)) {
        alike.retain(|array| !is_commanded(array));
    }
    let shows = |array: &&&ArrayParts| {
        let parts: Vec<&str> = array.parts.iter().map(String::as_str).collect();
        read_columns(contents, format, &parts).is_ok_and(|table| by_values(&table, 0).is_some())
    };
    let examined = if alike.len() > 1 && most.0 > 1 { MOST_ARRAYS } else { 0 };
    alike.iter().take(examined).find(shows).or(alike.first()).copied()
}

/// `true` if the name of an array means commanded values.
fn is_commanded(array: &ArrayParts) -> bool {
    let heading = Heading::parse(&array.name);
    heading.has(Word::Commanded) && !heading.has(Word::Measured)
}

/// Asks which of several arrays with as many columns contains the measurement. Commanded values are
/// none if the used array is measured.
fn other_arrays(arrays: &[ArrayParts], used: &ArrayParts, found: &mut Interpretation) {
    let width = used.parts.len();
    let is_other = |array: &&ArrayParts| array.parts.len() == width && array.name != used.name;
    let others = arrays.iter().filter(|array| width > 1 && is_other(array));
    let others = others.filter(|array| is_commanded(used) || !is_commanded(array));
    let mut others: Vec<String> = others.map(|array| format!("`{}`", array.name)).collect();
    let more = others.len().saturating_sub(LISTED_ARRAYS);
    others.truncate(LISTED_ARRAYS);
    if !others.is_empty() {
        found.ask(phrase!("ask-other-arrays", used = used.name, others, more));
    }
}

/// Maximum number of arrays whose values are examined, and of arrays that a question lists.
const MOST_ARRAYS: usize = 64;
const LISTED_ARRAYS: usize = 6;

/// Names of arrays of times, in lower case.
const TIMES: [&str; 7] = ["t", "time", "times", "timestamp", "stamp", "tout", "zeit"];

/// Table of the widest array with its time, and its interpretation: points if it has three columns,
/// or seven of which four are a quaternion; otherwise joints.
fn interpreted(
    arrays: &[ArrayParts],
    widest: &ArrayParts,
    contents: &ArrayFile,
    format: LogKind,
) -> Result<(Table, Interpretation), Message> {
    let beside = |array: &&ArrayParts| array.count == widest.count && array.parts.len() == 1;
    let is_time = |array: &&ArrayParts| {
        let name = array.name.rsplit('.').next().unwrap_or_default().to_lowercase();
        TIMES.contains(&name.as_str())
    };
    let time = arrays.iter().filter(beside).find(is_time);
    let others = || arrays.iter().filter(beside).filter(|array| Some(&array.name) != time.map(|time| &time.name));
    let values: Vec<&str> = match widest.parts.len() {
        1 => others().flat_map(|array| &array.parts).map(String::as_str).collect(),
        _ => widest.parts.iter().map(String::as_str).collect(),
    };
    let parts: Vec<&str> = time.iter().map(|time| time.name.as_str()).chain(values.iter().copied()).collect();
    let first = parts.len() - values.len();
    let table = read_columns(contents, format, &parts)?;
    let mut found = Interpretation::unknown(&table);
    let count = values.len();
    if let Some(by_values) = by_values(&table, first) {
        for (at, taken) in (first..).zip(&by_values.taken) {
            found.taken[at] = taken.clone();
        }
        found.points = by_values.points;
        found.points.iter_mut().flat_map(|set| set.columns.iter_mut().flatten()).for_each(|at| *at += first);
        found.doubts = [found.doubts, by_values.doubts].concat();
        return Ok((table, found));
    }
    let is_of_points = widest.parts.len() == 3;
    if time.is_some() {
        found.take(0, Meaning::Time, phrase!("why-heading"));
        found.clock_unit(&table);
    }
    if is_of_points {
        for axis in 0..3 {
            found.take(first + axis, Meaning::Point(0, axis), phrase!("why-place"));
        }
        found.points.push(PointSet { tag: String::new(), columns: [0, 1, 2].map(|axis| Some(first + axis)) });
        found.doubt(phrase!("doubt-array-columns", array = widest.name, count));
        found.ask(phrase!("ask-order-of-columns"));
        return Ok((table, found));
    }
    if count >= FEWEST_OF_POINTS && count.is_multiple_of(3) {
        found.points_in_row(&(first..first + count).collect::<Vec<usize>>());
        return Ok((table, found));
    }
    for k in 0..count {
        found.take(first + k, Meaning::Joint(k), phrase!("why-as-many-as-joints"));
    }
    let is_named = values.iter().all(|part| format.column_unit(part).is_some());
    if !is_named && widest.parts.len() > 1 {
        match (4..=8).contains(&count) {
            true => found.doubt_until(Evidence::JointOrder, phrase!("doubt-joints-without-headings", count)),
            false => found.doubt(phrase!("doubt-array-columns", array = widest.name, count)),
        }
    }
    Ok((table, found))
}

/// Table of parts of arrays, each a column under its name.
fn read_columns(contents: &ArrayFile, format: LogKind, parts: &[&str]) -> Result<Table, Message> {
    let text = format.table(contents, parts).unwrap_or_else(|| Err(error!("no-rows-of-numbers", file = "arrays")))?;
    let column = |part: &&str| Column {
        name: Some((*part).to_owned()),
        heading: Heading { unit: format.column_unit(part), ..Heading::default() },
        ..Column::default()
    };
    let mut columns: Vec<Column> = parts.iter().map(column).collect();
    let mut lines = text.lines().skip(1);
    for line in lines.by_ref().take(MOST_ROWS) {
        for (cell, column) in line.split('\t').zip(&mut columns) {
            column.values.push(cell.trim().parse().unwrap_or(f64::NAN));
        }
    }
    let rows = columns.first().map_or(0, |column| column.values.len());
    Ok(Table { rows, width: columns.len(), columns, sampled: lines.next().is_some(), ..Table::default() })
}

/// Interpretation of the columns from the index `first` on by their values, if these show positions
/// with quaternions, matrices or directions of length 1.
fn by_values(table: &Table, first: usize) -> Option<Interpretation> {
    let unnamed = |column: &Column| Column { values: column.values.clone(), ..Column::default() };
    let columns: Vec<Column> = table.columns[first..].iter().map(unnamed).collect();
    let found = Interpretation::new(&Table { width: columns.len(), columns, rows: table.rows, ..Table::default() });
    let is_turned = found.quaternion_columns().len() == 4 || found.matrix_columns().len() == 9;
    let is_directed = (0..3).all(|k| found.first(Meaning::Direction(k)).is_some());
    (found.points.len() == 1 && (is_turned || is_directed)).then_some(found)
}

/// Lines of an export about the points `set` of an array, with its column of times.
fn array_lines(
    array: &ArrayParts,
    table: &Table,
    found: &Interpretation,
    set: usize,
    unit: Option<&'static str>,
) -> Lines {
    let roles = roles(found, set);
    let named = roles.iter().zip(&table.columns).filter(|(role, _)| **role != ColumnRole::Skip);
    let columns: Vec<String> = named
        .map(|(role, column)| {
            let is_open = *role == ColumnRole::TimeS && found.clock.question.is_some();
            let name = if is_open { OPEN_TIME } else { role.name() };
            format!("{name} = {}", quoted(column.name.as_deref().unwrap_or_default()))
        })
        .collect();
    let form = format!("{{ sheet = {}, header = 1, columns = {{ {} }} }}", quoted(&array.name), columns.join(", "));
    let mut lines = Lines::default().with(Line::Format(form));
    lines.push(Line::Text(if unit.is_some() { fitted_unit_line(unit) } else { unit_line(None) }));
    lines.push(Line::Target(Target::Open));
    if found.first(Meaning::Time).is_none() {
        lines.push(Line::PoseByRow);
    }
    lines
}

/// Lines of a log of arrays.
fn log_lines(file: &str, format: &str, table: &Table, found: &Interpretation) -> Lines {
    let name = |at: usize| table.columns[at].name.as_deref();
    let time = found.first(Meaning::Time).and_then(name).map(|time| {
        let unit = if found.clock.question.is_some() { OPEN_UNIT } else { found.clock.unit.unwrap_or("s") };
        (format!("time_{unit}"), quoted(time))
    });
    let joint = |(k, at): (usize, usize)| {
        let key = found.joint_names.get(k).cloned().unwrap_or_else(|| format!("q{}", k + 1));
        let unit = table.columns[at].heading.unit.unwrap_or(OPEN_UNIT);
        (format!("{key}_{unit}"), joint_column(found.reversed.contains(&at), name(at), at + 1))
    };
    let joints = found.joint_columns().into_iter().enumerate().map(joint);
    Lines::section("log")
        .with(Line::File(file.to_owned()))
        .with(Line::Format(format!("{format:?}")))
        .with(Line::Columns(time.into_iter().chain(joints).collect()))
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

    /// Position and quaternion of a row.
    fn pose(row: usize) -> [f64; 7] {
        let (t, half) = (row as f64, 0.05 * row as f64);
        [0.5 + 0.1 * t.sin(), 0.2 * t.cos(), 0.9 - 0.01 * t, 0.0, half.sin(), 0.0, half.cos()]
    }

    /// The first of several arrays of one size whose values show a measured pose is proposed, as a
    /// question; times and rates alone are no joints.
    #[test]
    fn the_array_that_shows_a_pose_is_proposed_and_asked_about() {
        use crate::logs::arrays::{Content, NewArray};
        use std::io::{Cursor, Write};
        let poses: Vec<f64> = (0..20).flat_map(pose).collect();
        let joints: Vec<f64> = poses.iter().map(|v| 1.3 * v).collect();
        let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for (name, values) in [("arm", &joints), ("hand_cmd", &poses), ("hand", &poses), ("foot", &poses)] {
            archive.start_file(format!("{name}.npy"), zip::write::SimpleFileOptions::default()).unwrap();
            archive.write_all(&npy(values)).unwrap();
        }
        let proposed = |bytes: &[u8]| {
            propose_arrays("p.npz", &bytes.into(), LogKind::from_array_file(bytes).unwrap(), None)
                .map(Proposed::printed)
        };
        let document = proposed(&archive.finish().unwrap().into_inner()).unwrap();
        assert!(document.toml.contains("sheet = \"hand\""), "{}", document.toml);
        let asked = phrase!("ask-other-arrays", used = "hand", others = vec!["`arm`", "`foot`"], more = 0);
        assert!(document.questions.iter().any(|question| question.phrase() == Some(&asked)), "{}", document.toml);
        let list = |name| NewArray { name, content: Content::Numbers(vec![0.1, 0.2, 0.4]) };
        let rates = crate::logs::numpy::write(&[list("t"), list("gyro"), list("acc")]).unwrap();
        assert!(proposed(&rates).unwrap_err().is("no-rows-of-numbers", &[("file", &"arrays")]));
    }

    #[test]
    fn an_array_of_positions_and_quaternions_is_an_export() {
        let values: Vec<f64> = (0..20).flat_map(pose).collect();
        let proposed = |values: &[f64]| {
            let bytes = npy(values);
            propose_arrays("p.npy", &bytes.as_slice().into(), LogKind::from_array_file(&bytes).unwrap(), None)
                .unwrap()
                .printed()
        };
        let document = proposed(&values);
        assert_eq!(document.kind, "export", "{}", document.toml);
        assert!(document.toml.contains("x = ") && document.toml.contains("qw = "), "{}", document.toml);
        let joints: Vec<f64> = values.iter().map(|v| 1.3 * v).collect();
        let document = proposed(&joints);
        assert_eq!(document.kind, "log", "{}", document.toml);
    }
}
