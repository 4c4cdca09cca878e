//! What a text could be: a proposal with its reasons, doubts and questions, to paste into a campaign.

use super::exports::delimited::point_rows;
use super::exports::qif::is_xml;
use super::exports::{Recognised, head, recognise};
use super::guess::{Guess, guesses, is_joint, looks_like_a_log, names, roles};
use super::input::{bytes_of, decode};
use super::logs::LogKind;
use super::workbook;
use crate::dialect::{ColumnRole, Columns, CoordinateType, Dialect, Encoding, Header, Unit, quoted};
use crate::table::QUATERNION;
use etalon_base::message::{Message, Place, Result, count, printable};
use etalon_documents::{FormatsDocument, Reading};
use std::fmt::Write;
use std::path::Path;

/// What holds no points, and by what it is recognised.
const NO_POINTS: [fn(&str) -> Option<Recognised>; 3] = [
    |text| {
        let mark = head(text).contains("digitalCalibrationCertificate") || head(text).contains("dfm.dk");
        let what = "a digital calibration certificate: results of a calibration, and no measured points";
        Recognised::by(is_xml(text) && mark, 0.9, what)
    },
    |text| Recognised::by(is_xml(text), 0.1, "an XML document of no kind that is read"),
    |text| {
        let mark = text.starts_with("// Header") && text.contains("Version;SJ-4");
        Recognised::by(mark, 1.0, "roughness parameters of a Mitutoyo SJ-410, and no coordinates")
    },
];

/// The format of a text that states what it is, none where it holds no points; and what states so.
fn known(text: &str) -> Option<(Option<&'static str>, Recognised)> {
    let none = NO_POINTS.iter().filter_map(|kind| kind(text)).max_by(|a, b| a.score.total_cmp(&b.score));
    match (recognise(text), none) {
        (Some((_, found)), Some(none)) if none.score > found.score => Some((None, none)),
        (Some((format, found)), _) => Some((Some(format), found)),
        (None, none) => none.map(|none| (None, none)),
    }
}

/// A log that is recognised as surely is proposed in its format; of another one it is asked.
const SURE: f64 = 0.5;

/// What is to be done with the columns of a proposed log.
const JOINTS: &str =
    "# write the joints as robot.toml names them, and for UNIT deg, rad, mm, m or um: the file does not state it\n";

/// Problems of a trial that are repeated as doubts.
const SHOWN: usize = 3;

/// Proposes readings of a file, the first also as lines for campaign.toml.
///
/// # Errors
/// If there is no such file, if it is empty or not a text, or if no reading gives rows of numbers.
pub fn propose_file(path: &Path) -> Result<FormatsDocument> {
    let name = path.display().to_string();
    let bytes = bytes_of(path)?;
    let refused = |what: String| Message::error(what).at(Place::file(name.as_str()));
    if bytes.is_empty() {
        return Err(refused("the file is empty".to_owned()).hint("export it again").into());
    }
    if workbook::is_workbook(&bytes) {
        return of_workbook(&name, &bytes).map_err(|m| m.at(Place::file(name.as_str())).into());
    }
    let (text, encoding) = decoded(bytes).map_err(|m| m.at(Place::file(name.as_str())))?;
    if let (None, what) = known(&text).map_or((Some(""), ""), |(format, found)| (format, found.what)) {
        return Err(refused(format!("this is {what}")).expected("measured points, or a log").into());
    }
    let mut document = propose(&name, &text);
    if document.readings.is_empty() && document.format.is_none() {
        let message = refused("no reading as delimited text gives rows with two or more numbers".to_owned());
        return Err(message.hint("export the points as text, one row each").into());
    }
    if let Some(encoding) = encoding {
        let line = format!("encoding = {:?}\n", encoding.name());
        document.toml = document.toml.replacen("format = ", &format!("{line}format = "), 1);
        document
            .doubts
            .push(format!("the file is not UTF-8; as {} its letters make sense or not: look at them", encoding.name()));
        document.toml.insert_str(0, &format!("# DOUBT: {}\n", document.doubts.last().map_or("", String::as_str)));
    }
    Ok(document)
}

/// The first sheet that holds rows of numbers.
fn of_workbook(file: &str, bytes: &[u8]) -> std::result::Result<FormatsDocument, Message> {
    let names = workbook::sheets(bytes)?;
    for name in &names {
        let mut document = propose_in(file, &workbook::text(bytes, name)?, Some(name));
        if !document.readings.is_empty() {
            if let Some(doubt) = workbook::others(&names, name) {
                document.toml.insert_str(0, &format!("# DOUBT: {doubt}\n"));
                document.doubts.push(doubt);
            }
            return Ok(document);
        }
    }
    Err(Message::error("no sheet of the workbook holds rows with two or more numbers"))
}

/// The text, and the encoding that the campaign must state for it.
fn decoded(bytes: Vec<u8>) -> std::result::Result<(String, Option<Encoding>), Message> {
    let first = match decode(bytes.clone(), None) {
        Ok(text) => return Ok((text, None)),
        Err(message) => message,
    };
    let nul = |odd: usize| bytes.iter().skip(odd).step_by(2).filter(|b| **b == 0).count() * 8 > bytes.len() * 3;
    let stated = match (nul(1), nul(0)) {
        (true, false) => Encoding::Utf16Le,
        (false, true) => Encoding::Utf16Be,
        _ => Encoding::Windows1252,
    };
    match decode(bytes, Some(stated)) {
        Ok(text) => Ok((text, Some(stated))),
        Err(_) => Err(first),
    }
}

/// Proposes readings of a text, the first also as lines for campaign.toml. What the file cannot state is asked.
pub fn propose(file: &str, text: &str) -> FormatsDocument {
    propose_in(file, text, None)
}

/// The same of a file, or of a sheet whose cells are separated by tabs.
fn propose_in(file: &str, text: &str, sheet: Option<&str>) -> FormatsDocument {
    let mut document = FormatsDocument {
        schema: "etalon/formats/1".to_owned(),
        file: file.to_owned(),
        format: None,
        readings: Vec::new(),
        reasons: Vec::new(),
        doubts: Vec::new(),
        questions: Vec::new(),
        toml: String::new(),
    };
    if let Some((Some(format), Recognised { what, unit, .. })) = known(text).filter(|_| sheet.is_none()) {
        document.format = Some(format.to_owned());
        document.reasons.push(format!("it is {what}"));
        let lines = format!("[[export]]\nfile = {}\nformat = {format:?}\n{}", quoted(file), unit_line(unit));
        if unit.is_none() {
            document.questions.push("the unit of lengths".to_owned());
        }
        document.toml = with_remarks(&document, &lines);
        return document;
    }
    let log = LogKind::recognise(text).filter(|_| sheet.is_none());
    let guesses = guesses(text, sheet);
    document.readings = guesses.iter().map(reading).collect();
    if let Some((kind, found)) = log.filter(|(_, found)| found.score >= SURE) {
        document.format = Some(kind.about().name.to_owned());
        document.reasons.push(format!("it is {}", found.what));
        document.questions.push("which joint each column is, and its unit where it is not known".to_owned());
        let lines = match guesses.first().filter(|_| !kind.has_channels()) {
            Some(best) => log_lines(file, best, Some(kind)),
            None => format!(
                "[log]\nfile = {}\nformat = {:?}\ncolumns = {{ q1_UNIT = \"NAME\" }}\n{JOINTS}",
                quoted(file),
                kind.about().name
            ),
        };
        document.toml = with_remarks(&document, &lines);
        return document;
    }
    let Some(best) = guesses.first() else {
        document.toml = format!("# `{file}`: no reading as delimited text gives rows with two or more numbers\n");
        return document;
    };
    document.reasons = reasons(best);
    document.doubts = doubts(&guesses);
    let mixed = joints_beside_points(best);
    let lines = match looks_like_a_log(best).filter(|_| mixed.is_none()) {
        Some(why) => {
            document.reasons.push(format!("a log: {why}"));
            document.questions.push("which joint each column is, and its unit".to_owned());
            log_lines(file, best, None)
        }
        None => rows_of_points(file, text, best, mixed, &mut document),
    };
    if let Some((kind, found)) = log {
        document.questions.push(format!(
            "whether it is {} (`[log]` with `format = {:?}`)",
            found.what,
            kind.about().name
        ));
    }
    document.toml = with_remarks(&document, &lines);
    document
}

/// Lines of rows of points, of joints and points, or of joints and orientations.
fn rows_of_points(
    file: &str,
    text: &str,
    best: &Guess,
    mixed: Option<Vec<&str>>,
    document: &mut FormatsDocument,
) -> String {
    let unit = stated_unit(best);
    document.doubts.extend(not_read(best));
    document.doubts.extend(tried(file, text, best, unit));
    if unit.is_none() {
        document.questions.push("the unit of lengths".to_owned());
    }
    document.questions.push("whether the columns are x, y, z in this order, or angles and distances".to_owned());
    if let Some(joints) = &mixed {
        document.reasons.push(format!("the header names joints beside the points: {}", joints.join(", ")));
        document.questions.push("which joint each column is, and its unit".to_owned());
    }
    match (&mixed, orientation(best)) {
        (Some(joints), Some(turned)) => {
            document.reasons.push(format!("the header names orientations: {}", turned.join(", ")));
            observation_lines(file, best, joints, &turned)
        }
        _ => export_lines(file, best) + &mixed.map_or_else(String::new, |joints| joint_lines(&joints)),
    }
}

fn reading(guess: &Guess) -> Reading {
    Reading {
        delimiter: guess.dialect.delimiter.map_or("", |d| d.name()).to_owned(),
        decimal: guess.dialect.decimal.name().to_owned(),
        thousands: guess.dialect.thousands.map(|t| t.name().to_owned()),
        header: guess.header,
        columns: roles(guess).into_iter().map(|role| role.name().to_owned()).collect(),
        share: guess.share(),
    }
}

/// Why the first reading is the first.
fn reasons(best: &Guess) -> Vec<String> {
    let columns = match best.dialect.delimiter {
        Some(delimiter) => format!("have {} fields separated by `{}`", best.numeric.len(), delimiter.name()),
        None => format!("have numbers, in {}", count(best.numeric.iter().filter(|n| **n).count(), "column")),
    };
    let mut reasons = vec![
        format!("{} of {} {columns}", best.read, count(best.rows, "row")),
        format!(
            "{} of {} have the decimal mark `{}`",
            best.fractions,
            count(best.numbers, "number"),
            best.dialect.decimal.name()
        ),
    ];
    if let Some(row) = &best.names {
        let names = if names(best).is_some() { "names the columns" } else { "is the last before the data" };
        reasons.push(format!("line {} {names}", row.line));
    }
    if let Some(comment) = &best.dialect.comment {
        reasons.push(format!("lines that start with `{comment}` are comments"));
    }
    if let Some(end) = &best.dialect.end {
        reasons.push(format!("the last row is the word `{end}`"));
    }
    reasons
}

/// What speaks against the first reading.
fn doubts(guesses: &[Guess]) -> Vec<String> {
    let [best, others @ ..] = guesses else { return Vec::new() };
    let mut doubts: Vec<String> = others
        .iter()
        .map(|g| {
            let thousands = g.dialect.thousands.map(|t| format!(", thousands {:?}", t.name())).unwrap_or_default();
            let delimiter = g.dialect.delimiter.map_or(String::new(), |d| format!("delimiter {:?}, ", d.name()));
            let (decimal, columns) = (g.dialect.decimal.name(), count(g.numeric.len(), "column"));
            format!("{delimiter}decimal {decimal:?}{thousands}, {columns} explains it as well: check a row by eye")
        })
        .collect();
    let mark = best.dialect.decimal.name();
    if best.fractions == 0 {
        doubts.push(format!("no number has a decimal mark: that it is `{mark}` is not proved"));
    } else if best.threes == best.fractions && best.dialect.thousands.is_none() {
        doubts.push(format!("every `{mark}` is before three digits: it may be a thousands mark"));
    }
    if let Some(line) = best.unread {
        doubts.push(format!("{} not read this way, the first is line {line}", count(best.rows - best.read, "row")));
    }
    if let (Some(row), None) = (&best.names, names(best)) {
        let (words, columns) = (row.fields.len(), best.numeric.len());
        if row.fields.iter().any(|f| f.contains(char::is_alphabetic)) && words > 1 {
            doubts.push(format!("line {} has {words} words for {columns} columns: their order is not known", row.line));
        }
    }
    doubts
}

/// The unit that the header gives the first coordinate.
fn stated_unit(best: &Guess) -> Option<Unit> {
    let names = names(best)?;
    let x = roles(best).iter().position(|role| *role == ColumnRole::X)?;
    Unit::of_heading(names.get(x)?)
}

/// Columns of numbers that nothing names and that are not read.
fn not_read(best: &Guess) -> Vec<String> {
    let skipped =
        |(i, role): (usize, &ColumnRole)| (*role == ColumnRole::Skip && best.numeric[i]).then(|| (i + 1).to_string());
    let columns: Vec<String> = match names(best) {
        Some(_) => Vec::new(),
        None => roles(best).iter().enumerate().filter_map(skipped).collect(),
    };
    let what = format!("numbers that are not read: column {}", columns.join(", "));
    (!columns.is_empty()).then_some(what).into_iter().collect()
}

/// What reading the whole file this way runs into.
fn tried(file: &str, text: &str, best: &Guess, unit: Option<Unit>) -> Vec<String> {
    let (points, problems) = point_rows(file, &text.into(), &dialect(best), unit.unwrap_or(Unit::Millimetre));
    let mut doubts: Vec<String> = problems
        .0
        .iter()
        .take(SHOWN)
        .map(|m| {
            let line = m.place.as_ref().and_then(|p| p.line).map(|line| format!("line {line}: ")).unwrap_or_default();
            format!("{line}{}", m.what)
        })
        .collect();
    if problems.0.len() > SHOWN {
        doubts.push(format!("and {} more like that", count(problems.0.len() - SHOWN, "problem")));
    }
    let origin = points.iter().find(|p| p.refused.is_none() && p.xyz_mm == [0.0; 3]);
    let refused = points.iter().find(|p| p.refused.is_some());
    doubts.extend(
        origin
            .map(|p| format!("line {} is 0 0 0: taken as \"not measured\" unless `missing` states otherwise", p.line)),
    );
    doubts.extend(refused.map(|p| format!("line {}: {}", p.line, p.refused.as_deref().unwrap_or(""))));
    doubts
}

/// The dialect as it would be stated.
fn dialect(best: &Guess) -> Dialect {
    Dialect { columns: Columns::InOrder(roles(best)), ..best.dialect.clone() }
}

fn unit_line(unit: Option<&str>) -> String {
    match unit {
        Some(unit) => format!("unit = {unit:?}                # the file states it\n"),
        None => {
            "unit = \"?\"                 # mm, m, um or inch: the file does not state it, and it is never guessed\n"
                .to_owned()
        }
    }
}

fn export_lines(file: &str, best: &Guess) -> String {
    let mut out = format!(
        "[[export]]\nfile = {}\nformat = {}\n{}",
        quoted(file),
        dialect(best),
        unit_line(stated_unit(best).map(Unit::name))
    );
    let kinds = CoordinateType::Cartesian.name();
    let _ = writeln!(out, "# are the columns x, y, z in this order, and {kinds}?");
    let roles = roles(best);
    if roles.contains(&ColumnRole::Label) {
        out.push_str("label = \"{target}_{pose}_{cycle}\"   # how a label names target, pose and repeat, if it does\n");
    } else if !roles.contains(&ColumnRole::Target) {
        out.push_str("target = \"?\"               # which target the rows are of\n");
    }
    // what a column or the label states is not stated twice
    if ![ColumnRole::Label, ColumnRole::Pose, ColumnRole::TimeS].iter().any(|role| roles.contains(role)) {
        out.push_str("pose = \"row\"               # if the number of the row is the number of the pose\n");
    }
    out
}

/// The names of joints in the header of rows of points, in a text of which a campaign can read both.
fn joints_beside_points<'g>(best: &'g Guess) -> Option<Vec<&'g str>> {
    let roles = roles(best);
    let points = names(best).is_some() && roles.contains(&ColumnRole::X) && roles.contains(&ColumnRole::Y);
    let readable = best.dialect.delimiter.is_some() && best.header == 1 && best.dialect.comment.is_none();
    let joints: Vec<(&str, &ColumnRole)> =
        names(best)?.into_iter().zip(&roles).filter(|(name, _)| is_joint(name)).collect();
    // a header that names no points has their places by position
    let beside = joints.len() >= 2 && joints.iter().all(|(_, role)| **role == ColumnRole::Skip);
    (points && readable && beside).then(|| joints.into_iter().map(|(name, _)| name).collect())
}

/// The columns of measured orientations: a quaternion, or three that are angles or a rotation vector.
fn orientation<'g>(best: &'g Guess) -> Option<Vec<&'g str>> {
    let header = names(best)?;
    let plain = |name: &str| name.split(['_', '[', '(', ' ']).next().unwrap_or("").to_lowercase();
    let all = |wanted: &[&str]| -> Option<Vec<&'g str>> {
        wanted.iter().map(|name| header.iter().copied().find(|heading| plain(heading) == **name)).collect()
    };
    let forms: [&[&str]; 6] = [
        &QUATERNION,
        &["rx", "ry", "rz"],
        &["a", "b", "c"],
        &["w", "p", "r"],
        &["roll", "pitch", "yaw"],
        &["yaw", "pitch", "roll"],
    ];
    forms.into_iter().find_map(all)
}

/// Lines of a table of observations: joint values, positions and orientations row by row.
fn observation_lines(file: &str, best: &Guess, joints: &[&str], turned: &[&str]) -> String {
    let header = names(best).unwrap_or_default();
    let unit = stated_unit(best).map_or("UNIT", Unit::name);
    let role = |role: ColumnRole| roles(best).iter().position(|r| *r == role).map(|i| header[i]);
    let mut columns: Vec<String> = Vec::new();
    let mut column = |name: String, heading: &str| columns.push(format!("{name} = {}", quoted(heading)));
    if let Some(pose) = role(ColumnRole::Pose) {
        column("pose".to_owned(), pose);
    }
    for (i, joint) in joints.iter().enumerate() {
        column(format!("q{}_{}", i + 1, unit_of_name(joint).unwrap_or("UNIT")), joint);
    }
    for (name, of) in ["x", "y", "z"].into_iter().zip([ColumnRole::X, ColumnRole::Y, ColumnRole::Z]) {
        if let Some(heading) = role(of) {
            column(format!("{name}_{unit}"), heading);
        }
    }
    match turned.len() {
        4 => QUATERNION.into_iter().zip(turned).for_each(|(name, heading)| column(name.to_owned(), heading)),
        _ => ["a_UNIT", "b_UNIT", "c_UNIT"]
            .into_iter()
            .zip(turned)
            .for_each(|(name, heading)| column(name.to_owned(), heading)),
    }
    let mut out = format!(
        "[observations]\nfile = {}\ndelimiter = {:?}\ndecimal = {:?}\ncolumns = {{ {} }}\n{JOINTS}",
        quoted(file),
        best.dialect.delimiter.map_or("", |d| d.name()),
        best.dialect.decimal.name(),
        columns.join(", ")
    );
    if turned.len() == 3 {
        out.push_str(
            "orientation = \"?\"          # order of the three angles: \"zyx\", \"fixed xyz\" ..; without it the error names the orders that fit. Of a\n\
             # rotation vector name the columns rx_UNIT, ry_UNIT, rz_UNIT instead\n",
        );
    }
    if role(ColumnRole::Target).is_none() {
        out.push_str("target = \"probe\"           # the body that was measured\n");
    }
    if role(ColumnRole::Pose).is_none() {
        out.push_str("pose = \"row\"               # if the number of the row is the number of the pose\n");
    }
    out
}

/// The unit that the name of a column ends in.
fn unit_of_name(name: &str) -> Option<&'static str> {
    ["deg", "rad", "mm", "m"].into_iter().find(|unit| name.trim().to_lowercase().ends_with(&format!("_{unit}")))
}

fn joint_lines(joints: &[&str]) -> String {
    let column =
        |(i, name): (usize, &&str)| format!("q{}_{} = {}", i + 1, unit_of_name(name).unwrap_or("UNIT"), quoted(name));
    let columns: Vec<String> = joints.iter().enumerate().map(column).collect();
    format!("joints = {{ {} }}\n{JOINTS}", columns.join(", "))
}

/// Lines of a log, in a format of which more is known or none.
fn log_lines(file: &str, best: &Guess, kind: Option<LogKind>) -> String {
    let names = names(best);
    let decimal = best.dialect.decimal.name();
    let delimiter = best.dialect.delimiter.map_or("", |d| d.name());
    let format = kind.map(|kind| format!("format = {:?}\n", kind.about().name)).unwrap_or_default();
    let mut out = format!(
        "[log]\nfile = {}\n{format}delimiter = {delimiter:?}\ndecimal = {decimal:?}\nheader = {}\n",
        quoted(file),
        names.is_some()
    );
    let unit_of = |name: &str| kind.and_then(|kind| kind.unit_of(name));
    let mut number = 0;
    let mut joint = |unit: Option<&str>| {
        number += 1;
        format!("q{number}_{}", unit.unwrap_or("UNIT"))
    };
    let mut clock = None;
    let columns: Vec<String> = match &names {
        Some(names) => names
            .iter()
            .filter_map(|name| match name.trim().to_lowercase().as_str() {
                key @ ("pose" | "cycle" | "time_s") => Some(format!("{key} = {}", quoted(name))),
                "run" | "repeat" => Some(format!("cycle = {}", quoted(name))),
                _ if is_joint(name) => {
                    Some(format!("{} = {}", joint(unit_of(name).or(unit_of_name(name))), quoted(name)))
                }
                _ => {
                    let unit = unit_of(name).filter(|unit| ["s", "ms", "ns"].contains(unit) && clock.is_none())?;
                    clock = Some(unit);
                    Some(format!("time_{unit} = {}", quoted(name)))
                }
            })
            .collect(),
        None => (1..=best.numeric.len()).map(|column| format!("{} = {column}", joint(None))).collect(),
    };
    let _ = writeln!(out, "columns = {{ {} }}", columns.join(", "));
    out.push_str(JOINTS);
    if best.header > 1 && best.dialect.header != Header::Rows(1) {
        out.push_str("# a log has one row of names at most: take the other rows before the data out of the file\n");
    }
    out
}

/// The lines under comments with the reasons, what speaks against them, and what is asked.
fn with_remarks(document: &FormatsDocument, lines: &str) -> String {
    let mut out = String::new();
    let mut remark = |text: String| out.push_str(&format!("# {}\n", printable(&text)));
    remark(format!("proposed for `{}`", document.file));
    document.reasons.iter().for_each(|reason| remark(format!("because {reason}")));
    document.doubts.iter().for_each(|doubt| remark(format!("DOUBT: {doubt}")));
    document.questions.iter().for_each(|question| remark(format!("QUESTION: {question}")));
    out + lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_whose_first_row_is_shorter_than_the_others_is_proposed() {
        let text = "4711\t2.0\nP\ta\tb\t1.5\t2.5\t3.5\nQ\ta\tb\t4.5\t5.5\t6.5\n";
        assert_eq!(propose_in("f.xlsx", text, Some("S")).readings[0].columns.len(), 6);
    }

    #[test]
    fn delimiter_and_decimal_are_proposed_and_the_unit_is_asked() {
        let text = propose("p.txt", "Name;X;Y;Z\nA;1,25;2,5;-3,75\nB;4,125;5,5;6,25\n").toml;
        let stated = "delimiter = \";\", decimal = \",\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\"]";
        assert!(text.contains(stated), "{text}");
        assert!(text.contains("unit = \"?\"") && text.contains("# because 2 of 2 rows have 4 fields"), "{text}");
        let text = propose("p.txt", "1.25 2.5 3.5\n4.5 5.5 6.5\n").toml;
        assert!(text.contains("delimiter = \"blank\", decimal = \".\", columns = [\"x\", \"y\", \"z\"]"), "{text}");
    }

    #[test]
    fn both_halves_of_a_mixed_file_are_proposed() {
        let text = propose(
            "m.csv",
            "pose;target;x_mm;y_mm;z_mm;J1_rad;J2_rad\n1;K;1,5;2,5;3,5;0,1;0,2\n2;K;1,6;2,6;3,6;0,3;0,4\n",
        )
        .toml;
        assert!(text.contains("columns = [\"pose\", \"target\", \"x\", \"y\", \"z\", \"-\", \"-\"]"), "{text}");
        assert!(text.contains("joints = { q1_rad = \"J1_rad\", q2_rad = \"J2_rad\" }"), "{text}");
        assert!(!text.contains("[log]") && !text.contains("pose = \"row\""), "{text}");
        let text = propose("m.csv", "pose;x;y;z\n1;1,5;2,5;3,5\n2;1,6;2,6;3,6\n").toml;
        assert!(text.contains("target = \"?\"") && !text.contains("pose = \"row\""), "{text}");
        let text = propose("m.csv", "target;x;y;z\nK;1,5;2,5;3,5\nL;1,6;2,6;3,6\n").toml;
        assert!(!text.contains("target = \"?\"") && text.contains("pose = \"row\""), "{text}");
    }

    #[test]
    fn joints_beside_orientations_are_a_table_of_observations() {
        let text = propose(
            "m.csv",
            "J1;J2;X;Y;Z;QW;QX;QY;QZ\n0,1;0,2;1,5;2,5;3,5;1,0;0,0;0,0;0,0\n0,3;0,4;1,6;2,6;3,6;0,8;0,6;0,0;0,0\n",
        )
        .toml;
        let columns = "columns = { q1_UNIT = \"J1\", q2_UNIT = \"J2\", x_UNIT = \"X\", y_UNIT = \"Y\", z_UNIT = \"Z\", qw = \"QW\", qx = \"QX\"";
        assert!(text.contains("[observations]") && text.contains(columns) && !text.contains("orientation ="), "{text}");
        let text = propose(
            "m.csv",
            "J1_rad;J2_rad;x_mm;y_mm;z_mm;Rx;Ry;Rz\n0,1;0,2;1,5;2,5;3,5;1,0;0,0;0,0\n0,3;0,4;1,6;2,6;3,6;0,8;0,6;0,0\n",
        )
        .toml;
        assert!(
            text.contains("q1_rad = \"J1_rad\"")
                && text.contains("x_mm = \"x_mm\"")
                && text.contains("a_UNIT = \"Rx\""),
            "{text}"
        );
        assert!(text.contains("orientation = \"?\"") && text.contains("decimal = \",\""), "{text}");
    }

    #[test]
    fn comma_and_comma_is_never_proposed() {
        let text = propose("p.txt", "1,25\t2,50\t3,75\n").toml;
        assert!(text.contains("decimal = \",\""), "{text}");
        assert!(!propose("p.txt", "1,25,2,50,3,75\n").toml.contains("decimal = \",\""));
        assert!(propose("p.txt", "no numbers here\n").toml.contains("no reading"));
    }

    #[test]
    fn the_share_is_one_of_rows() {
        let document = propose("p.txt", "a 1 2 3\nb 4 5 6\nc 7 8\nd 9 10 11\n");
        assert_eq!(document.readings[0].share, 0.75);
        assert!(
            document.doubts.iter().any(|d| d.contains("1 row not read this way, the first is line 3")),
            "{document:?}"
        );
        assert!(document.doubts.iter().any(|d| d.contains("no number has a decimal mark")), "{document:?}");
    }

    #[test]
    fn a_log_is_not_an_export() {
        for (text, columns) in [
            (
                "pose,run,RP1,RP2,RP3\n1,1,0.5,3.25,4.5\n",
                "columns = { pose = \"pose\", cycle = \"run\", q1_UNIT = \"RP1\", q2_UNIT",
            ),
            ("1.5 2.5 3.5 4.5 5.5 6.5\n", "columns = { q1_UNIT = 1, q2_UNIT = 2"),
            (
                "timestamp,actual_q_0,actual_q_1\n0.1,0.2,0.3\n",
                "columns = { time_s = \"timestamp\", q1_rad = \"actual_q_0\", q2_rad = \"actual_q_1\" }",
            ),
        ] {
            let toml = propose("l.csv", text).toml;
            assert!(toml.contains("[log]") && !toml.contains("[[export]]") && toml.contains(columns), "{toml}");
        }
        assert!(
            propose("p.xyz", "1.5 2.5 3.5 0.0 0.6 0.8\n").toml.contains("\"x\", \"y\", \"z\", \"i\", \"j\", \"k\"")
        );
    }

    #[test]
    fn a_log_format_is_recognised_with_its_reason_and_asked_where_the_mark_is_weak() {
        for (text, format, mark) in [
            ("timestamp,actual_q_0\n0.1,0.2\n", "ur_rtde", "RTDE's names of joint positions"),
            ("Timestamp,A1,IPOC\n2024-09-24,1.5,12\n", "kuka_rsi", "`IPOC`"),
            ("%time,field.header.seq,field.position0\n1,2,0.5\n", "ros", "`rostopic echo -p`"),
            ("Name\tscope\nStarttime of export\t132959733843760000\n\nName\tq\n", "twincat", "start of the export"),
        ] {
            let document = propose("l.csv", text);
            assert_eq!(document.format.as_deref(), Some(format), "{document:?}");
            assert!(document.reasons[0].contains(mark), "{document:?}");
            assert!(
                document.toml.contains(&format!("[log]\nfile = \"l.csv\"\nformat = \"{format}\"\n")),
                "{document:?}"
            );
        }
        let document = propose("l.csv", "one,ten\n0,0\n1,10\n2,20\n,0\n");
        assert_eq!(document.format, None);
        assert!(document.questions.iter().any(|question| question.contains("Galil")), "{document:?}");
    }

    #[test]
    fn what_a_mark_means_may_be_in_doubt() {
        let doubts = propose("p.txt", "a;1,250;2,500;3,750\nb;4,125;5,500;6,250\n").doubts;
        assert!(doubts.iter().any(|d| d.contains("it may be a thousands mark")), "{doubts:?}");
        let thousands = propose("p.txt", "a;1.234,50;-2.345,25;3,75\nb;4.125,00;5,50;6,25\n").toml;
        assert!(thousands.contains("decimal = \",\", thousands = \".\""), "{thousands}");
    }
}
