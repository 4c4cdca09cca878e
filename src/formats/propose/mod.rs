//! Proposals for reading a file: lines for campaign.toml with reasons, doubts and questions.

mod by_robot;
mod labels;
mod layout;
mod native;
#[cfg(test)]
mod reading_tests;
mod recording;
mod several;
#[cfg(test)]
mod stranger_tests;
mod structure;

use by_robot::{against, branches, kinematics, motion, turned};
use layout::{arrays, coordinates, headings, lines, meaning, table};

pub use branches::{TargetFit, fit_targets};
pub use labels::label_form;
pub use lines::JOINTS as JOINTS_REMARK;
pub use several::{FilesProposal, has_several_tables, propose_files, world_lines};
pub use table::heading_without_unit;

use super::exports::qif::is_xml;
use super::exports::{Format, Recognised, binary_format, head, recognise};
use super::input::{decode, guessed_encoding, read_start};
use super::logs::LogKind;
use super::workbook::Workbook;
use super::{Point, ros_bag, workbook};
use crate::dialect::{ColumnRole, Unit, quoted};
use against::Remarks;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place, Result, count, printable};
use etalon_base::worded::Worded;
use etalon_base::{error, phrase};
use etalon_documents::{FormatsColumn, FormatsDocument, Reading};
use etalon_robots::Robot;
use etalon_tables::guess::{Guess, guesses, names};
use etalon_tables::{Decimal, Encoding};
use headings::Heading;
use lines::{JOINTS, Proposal};
use meaning::{Interpretation, Meaning, PointSet, Taken};
use std::path::{Path, PathBuf};
use table::{Column, Table};

/// Kind of a text without points, and the certainty of the recognition, from 0 to 1.
fn without_points(text: &str) -> Option<(&'static str, f64)> {
    let certificate = head(text).contains("digitalCalibrationCertificate") || head(text).contains("dfm.dk");
    let roughness = text.starts_with("// Header") && text.contains("Version;SJ-4");
    // records of total stations, by their first line
    let station = [("sdr33", "00NMSDR"), ("m5", "For M5|"), ("m5", "For_M5|"), ("south", "INST    NTS")];
    let begins = |mark: &str| text.lines().take(3).any(|line| line.trim_start_matches('\u{feff}').starts_with(mark));
    if let Some((kind, _)) = station.into_iter().find(|(_, mark)| begins(mark)) {
        return Some((kind, 0.9));
    }
    if text
        .lines()
        .take(400)
        .any(|line| ["movej(", "movel(", "movep("].iter().any(|mark| line.trim_start().starts_with(mark)))
    {
        return Some(("urscript", 0.9));
    }
    if structure::is_mesh(text) {
        return Some(("mesh", 0.9));
    }
    if let Some(kind) = structure::program_or_model(text) {
        return Some((kind, 0.5));
    }
    match (is_xml(text), roughness) {
        (_, true) => Some(("roughness", 1.0)),
        (true, _) if certificate => Some(("certificate", 0.9)),
        (true, _) => Some(("xml", 0.1)),
        (false, _) => None,
    }
}

/// Content of a text with a known mark.
enum Known {
    /// Points in the format of this name.
    Points(&'static str, Recognised),
    /// A document of this kind, which contains no points.
    Other(&'static str),
}

/// Recognises a text by its mark: a format of exports, or a document without points.
fn known(text: &str) -> Option<Known> {
    match (recognise(text), without_points(text)) {
        (Some((_, found)), Some((kind, score))) if score > found.score => Some(Known::Other(kind)),
        (Some((format, found)), _) => Some(Known::Points(format, found)),
        (None, other) => other.map(|(kind, _)| Known::Other(kind)),
    }
}

/// Score above which a log is proposed in its format; below it the format is a question.
const SURE: f64 = 0.5;

/// Writes the form of the labels of an export into the lines of a file that is proposed alone.
fn state_label_form(document: &mut FormatsDocument, labels: &[String]) {
    let has_both = |(form, targets): &(String, Vec<String>)| form.contains("{pose}") && targets.len() > 1;
    let Some((form, _)) = labels::label_form(labels).filter(has_both) else { return };
    let line = format!("label = {}   # all {} labels have this form\n", quoted(&form), labels.len());
    // a format of its own gives no form of its labels
    match document.format.is_some() {
        true => document.toml += &line,
        false => document.toml = document.toml.replacen(several::LABEL_LINE, &line, 1),
    }
}

/// Maximum number of columns that are explained in the comments of a proposal.
const SHOWN_COLUMNS: usize = 60;

/// Proposes interpretations of a file, and lines for campaign.toml for the first interpretation.
///
/// # Errors
/// Fails if the file is missing, empty or not text, or if no way of reading yields rows of numbers.
pub fn propose_file(path: &Path) -> Result<FormatsDocument> {
    propose_file_for(path, None)
}

/// Proposes interpretations of a file as [`propose_file`] does, and tests them against a nominal
/// robot.
///
/// # Errors
/// Fails if the file is missing, empty or not text, or if no way of reading yields rows of numbers.
pub fn propose_file_for(path: &Path, robot: Option<&dyn Robot>) -> Result<FormatsDocument> {
    let mut labels: Vec<String> = Vec::new();
    let mut document = propose_corrected(
        path,
        None,
        robot,
        Some(&mut |table, found| {
            labels = found.first(Meaning::Label).map(|at| several::texts(&table.columns[at])).unwrap_or_default();
            robot.map(|robot| against::correct(robot, table, found)).unwrap_or_default()
        }),
    )?;
    state_label_form(&mut document, &labels);
    Ok(document)
}

/// Correction of the interpretation of a table before its lines are written.
type Correct<'a> = &'a mut dyn FnMut(&mut Table, &mut Interpretation) -> Remarks;

/// Returns the correction for one use of several.
fn reborrowed<'a>(correct: &'a mut Option<Correct<'_>>) -> Option<Correct<'a>> {
    correct.as_mut().map(|correct| &mut **correct as Correct<'a>)
}

/// Proposes readings of a file, or of one sheet of a workbook.
fn propose_corrected(
    path: &Path,
    sheet: Option<&str>,
    robot: Option<&dyn Robot>,
    correct: Option<Correct>,
) -> Result<FormatsDocument> {
    let name = path.display().to_string();
    let (bytes, is_cut) = read_start(path)?;
    let here = |message: Message| message.at(Place::file(name.as_str()));
    if bytes.is_empty() {
        return Err(here(error!("file-empty")).into());
    }
    if bytes.starts_with(b"LASF") {
        return Err(here(error!("file-without-points", kind = "las")).into());
    }
    if ros_bag::is_recording(&bytes) {
        return recording::propose_recording(&name, &bytes, robot).map_err(|message| here(message).into());
    }
    if let Some(format) = LogKind::from_array_file(&bytes) {
        let file = format.array_file(path, &bytes)?;
        return arrays::propose_arrays(&name, &file, format, correct).map_err(|message| here(message).into());
    }
    if workbook::is_workbook(&bytes) {
        return propose_workbook(&name, &bytes, sheet, correct).map_err(|message| here(message).into());
    }
    let (text, encoding) = match binary_format(&bytes) {
        Some(_) => (bytes.iter().map(|byte| char::from(*byte)).collect(), None),
        None => decoded(bytes).map_err(here)?,
    };
    let other = match known(&text) {
        Some(Known::Points(..)) => None,
        Some(Known::Other(kind)) => Some(kind),
        None => match structure::structured(&text) {
            kind if structure::has_named_numbers(&text, kind == Some("yaml")) => {
                return Err(here(error!("numbers-behind-names")).into());
            }
            kind => kind,
        },
    };
    if (other == Some("yaml") || other.is_none() && structure::has_cells_of_lines(&text))
        && structure::is_of_lists(&text)
    {
        return Err(here(error!("numbers-in-brackets")).into());
    }
    if let Some(kind) = other {
        return Err(here(error!("file-without-points", kind)).into());
    }
    if structure::is_of_matrices(&text) {
        return Err(here(error!("matrices-in-blocks")).into());
    }
    let mut document = propose_in(&name, &text, None, correct);
    if document.readings.is_empty() && document.format.is_none() {
        let message = match () {
            () if structure::has_lists(&text) => error!("numbers-in-brackets"),
            () if structure::has_quoted_lists(&text) || document.rows > 0 => error!("numbers-in-cells"),
            () => error!("no-rows-of-numbers", file = "text"),
        };
        return Err(here(message).into());
    }
    if is_cut && !document.facts.is_sampled {
        document.because(phrase!("because-sampled", rows = document.rows));
        let reason = document.reasons.last().map_or("", Worded::english);
        document.toml = document.toml.replacen('\n', &format!("\n# because {reason}\n"), 1);
    }
    if let Some(encoding) = encoding {
        let line = format!("encoding = {:?}\n", encoding.name());
        let with_encoding = |text: &str| match text.starts_with("file = ") {
            true => format!("{text}{line}"),
            false => text.to_owned(),
        };
        document.toml = document.toml.split_inclusive('\n').map(with_encoding).collect();
        document.doubt(phrase!("doubt-encoding", encoding = encoding.name()));
        document.toml.insert_str(0, &format!("# DOUBT: {}\n", document.doubts.last().map_or("", Worded::english)));
    }
    Ok(document)
}

/// Names of the sheets of a workbook; none for other files.
fn sheets(path: &Path) -> Vec<String> {
    let bytes = read_start(path).map(|(bytes, _)| bytes).unwrap_or_default();
    match workbook::is_workbook(&bytes) {
        true => Workbook::open(&bytes).map(|book| book.sheets()).unwrap_or_default(),
        false => Vec::new(),
    }
}

/// Files in the folder of a file that contain its numbers, as the traces of a KUKA have.
pub fn files_beside(path: &Path) -> Vec<PathBuf> {
    let bytes = read_start(path).map(|(bytes, _)| bytes).unwrap_or_default();
    let Some(format) = LogKind::from_array_file(&bytes) else { return Vec::new() };
    let folder = path.parent().unwrap_or(Path::new(""));
    let file = format.array_file(path, &bytes).map(|file| file.beside).unwrap_or_default();
    file.into_iter().map(|(name, _)| folder.join(name)).collect()
}

/// Proposes interpretations of a sheet, or of the first sheet with rows of numbers.
fn propose_workbook(
    file: &str,
    bytes: &[u8],
    sheet: Option<&str>,
    mut correct: Option<Correct>,
) -> std::result::Result<FormatsDocument, Message> {
    let mut book = Workbook::open(bytes)?;
    let names = book.sheets();
    for name in names.iter().filter(|name| sheet.is_none_or(|sheet| sheet == *name)) {
        let mut document = propose_in(file, &book.text(name, Decimal::Point)?, Some(name), reborrowed(&mut correct));
        if !document.readings.is_empty() {
            if let Some(doubt) = workbook::others(&names, name).filter(|_| sheet.is_none()) {
                document.toml.insert_str(0, &format!("# DOUBT: {doubt}\n"));
                document.doubt(doubt);
            }
            return Ok(document);
        }
    }
    Err(error!("no-rows-of-numbers", file = "workbook"))
}

/// Returns the text, and the encoding that the campaign has to give.
fn decoded(bytes: Vec<u8>) -> std::result::Result<(String, Option<Encoding>), Message> {
    let first = match decode(bytes.clone(), None) {
        Ok(text) => return Ok((text, None)),
        Err(message) => message,
    };
    let Some(stated) = guessed_encoding(&bytes) else { return Err(first) };
    match decode(bytes, Some(stated)) {
        Ok(text) => Ok((text, Some(stated))),
        Err(_) => Err(first),
    }
}

/// Proposes interpretations of a text, and lines for campaign.toml for the first interpretation.
/// Statements that the file does not contain become questions.
pub fn propose(file: &str, text: &str) -> FormatsDocument {
    propose_in(file, text, None, None)
}

/// Returns the proposal for a text that gives its format.
fn propose_known_format(
    empty: &FormatsDocument,
    file: &str,
    text: &str,
    correct: Option<Correct>,
) -> Option<FormatsDocument> {
    let Known::Points(format, Recognised { what, unit, .. }) = known(text)? else { return None };
    let mut document = empty.clone();
    document.format = Some(format.to_owned());
    document.kind = "export".to_owned();
    document.because(phrase!("because-it-is", what));
    let caution = Format::named(format).and_then(|format| format.caution());
    caution.into_iter().for_each(|warning| document.doubt(warning.phrase()));
    let read = Format::named(format).zip(Unit::named(unit.unwrap_or("mm")));
    let (points, problems) = read.map(|(format, unit)| format.read(file, &text.into(), unit)).unwrap_or_default();
    let unread = [lines::problems_as_doubts(&problems), lines::refused_as_doubts(&points)].concat();
    unread.into_iter().for_each(|doubt| document.doubt(doubt));
    document.rows = points.len();
    let (mut table, mut found) = points_alone(&points, unit);
    if let Some(correct) = correct {
        let remarks = correct(&mut table, &mut found);
        (document.facts.joints_named, document.facts.reproduced_mm) = (remarks.joints_named, remarks.reproduced_mm);
        remarks.reasons.into_iter().for_each(|reason| document.because(reason));
        remarks.doubts.into_iter().for_each(|doubt| document.doubt(doubt));
    }
    if !points.is_empty() && points.iter().all(|point| point.refused.is_some()) {
        document.kind = "unknown".to_owned();
        document.toml = with_remarks(&document, &format!("# `{file}`: no row has the coordinates of a point\n"));
        return Some(document);
    }
    let (stated, unit) = (unit, unit.or(table.columns[0].heading.unit));
    let unit_line = if stated.is_some() { lines::unit_line(unit) } else { lines::fitted_unit_line(unit) };
    let lines = format!("[[export]]\nfile = {}\nformat = {format:?}\n{unit_line}", quoted(file));
    if unit.is_none() {
        document.ask(phrase!("ask-unit"));
    }
    let columns = Format::named(format).map(|format| format.dialect.columns.roles()).unwrap_or_default();
    let labelled = points.is_empty() || points.iter().any(|point| !point.label.is_empty());
    let lines = match columns.is_empty() && labelled || columns.contains(&ColumnRole::Label) {
        true => lines,
        false => {
            lines
                + "target = \"?\"               # which target the rows are of\n\
                   pose = \"row\"               # if the number of the row is the number of the pose\n"
        }
    };
    document.toml = with_remarks(&document, &lines);
    Some(document)
}

/// Table of points that a format of its own gives, in their unit.
fn points_alone(points: &[Point], unit: Option<&'static str>) -> (Table, Interpretation) {
    let points = &points[..points.len().min(table::MOST_ROWS)];
    let heading = Heading { unit, ..Heading::default() };
    let size = Unit::named(unit.unwrap_or("mm")).map_or(1.0, Unit::in_mm);
    let axis = |(k, name): (usize, &str)| Column {
        name: Some(name.to_owned()),
        heading: heading.clone(),
        values: points.iter().map(|point| point.xyz_mm[k] / size).collect(),
        ..Column::default()
    };
    let mut columns: Vec<Column> = ["x", "y", "z"].into_iter().enumerate().map(axis).collect();
    let mut found = Interpretation {
        points: vec![PointSet { tag: String::new(), columns: [0, 1, 2].map(Some) }],
        taken: (0..3).map(|axis| Taken { meaning: Meaning::Point(0, axis), why: None }).collect(),
        ..Interpretation::default()
    };
    if !points.is_empty() && points.iter().all(|point| !point.label.is_empty()) {
        let cells = points.iter().map(|point| (*point.label).into()).collect();
        columns.push(Column { name: Some("label".to_owned()), cells, ..Column::default() });
        found.taken.push(Taken { meaning: Meaning::Label, why: None });
    }
    let width = columns.len();
    (Table { columns, rows: points.len(), width, ..Table::default() }, found)
}

/// Proposes interpretations of a text, or of a sheet whose cells are separated by tabs.
fn propose_in(file: &str, text: &str, sheet: Option<&str>, mut correct: Option<Correct>) -> FormatsDocument {
    let mut document =
        FormatsDocument { schema: "etalon/formats/1".to_owned(), file: file.to_owned(), ..FormatsDocument::default() };
    if sheet.is_none()
        && let Some(known) = propose_known_format(&document, file, text, reborrowed(&mut correct))
    {
        return known;
    }
    let log = LogKind::recognise(text).filter(|_| sheet.is_none());
    let guesses = guesses(text, sheet);
    let mut tables: Vec<(Table, Interpretation)> = guesses
        .iter()
        .map(|guess| {
            let mut table = Table::read(text, guess);
            let mut found = Interpretation::new(&table);
            found.unit_of_head(&mut table, guess);
            if let Some(fractions) = found.clock.fractions {
                fractions.add(&mut table);
            }
            (table, found)
        })
        .collect();
    let remarks = correct.zip(tables.first_mut()).map(|(correct, (table, found))| correct(table, found));
    document.readings = guesses.iter().zip(&tables).map(|(guess, (_, found))| reading(guess, found)).collect();
    let best = guesses.first().zip(tables.first());
    if let Some((_, (table, found))) = best {
        document.columns = columns(table, found);
        document.rows = table.rows;
    }
    let proposal = best.map(|(guess, (table, found))| Proposal { file, text, best: guess, table, found });
    if let Some((kind, found)) = log.as_ref().filter(|(_, found)| found.score >= SURE) {
        document.format = Some(kind.about().name.to_owned());
        document.kind = "log".to_owned();
        document.because(phrase!("because-it-is", what = found.what));
        document.ask(phrase!("ask-joints-of-format"));
        let lines = match proposal.filter(|_| !kind.has_channels()) {
            Some(proposal) => proposal.log(Some(*kind)),
            None => format!(
                "[log]\nfile = {}\nformat = {:?}\ncolumns = {{ q1_UNIT = \"NAME\" }}\n{JOINTS}",
                quoted(file),
                kind.about().name
            ),
        };
        document.toml = with_remarks(&document, &lines);
        return document;
    }
    if best.is_some_and(|(_, (table, found))| divides_lists(table, found)) {
        document.readings.clear();
        return document;
    }
    let (Some((best, (table, found))), Some(proposal)) = (best, proposal) else {
        document.toml = format!("# `{file}`: no reading as delimited text gives rows with two or more numbers\n");
        return document;
    };
    let remarks = remarks.unwrap_or_default();
    (document.facts.joints_named, document.facts.reproduced_mm) = (remarks.joints_named, remarks.reproduced_mm);
    document.facts.is_sampled = table.sampled;
    reasons(best, table).into_iter().chain(remarks.reasons).for_each(|reason| document.because(reason));
    let is_measured = |kind: &str| found.is_beside_log && ["recording", "poses", "commanded"].contains(&kind);
    let native = native::recognise(&proposal, &found.joint_columns()).filter(|table| !is_measured(table.kind));
    // rows of fixed points have few numbers
    let rows_may_differ = native.as_ref().is_some_and(|table| table.kind == "observations");
    let of_meaning = found.doubts.iter().map(|doubt| doubt.text.clone());
    let doubts = doubts(&guesses, rows_may_differ).into_iter().chain(remarks.doubts).chain(of_meaning);
    doubts.for_each(|doubt| document.doubt(doubt));
    found.questions.iter().for_each(|question| document.ask(question.text.clone()));
    let lines = match native {
        Some(table) => {
            document.kind = table.kind.to_owned();
            document.because(phrase!("because-columns-of", what = table.what));
            table.question.into_iter().for_each(|question| document.ask(question));
            table.lines
        }
        None => proposal.lines(&mut document),
    };
    if let Some((kind, found)) = log {
        document.ask(phrase!("ask-log-of-format", what = found.what, format = kind.about().name));
    }
    document.toml = with_remarks(&document, &lines);
    document
}

/// `true` if the delimiter divides lists: in brackets, or in the cells of a table without headings.
fn divides_lists(table: &Table, found: &Interpretation) -> bool {
    let nameless = table.columns.iter().all(|column| column.name.is_none());
    let cells = || table.columns.iter().map(|column| &*column.cells);
    found.is_within_lists(table) || nameless && structure::has_lists_in_cells(cells())
}

fn reading(guess: &Guess, found: &Interpretation) -> Reading {
    Reading {
        delimiter: guess.form.delimiter.map(|d| d.name().to_owned()),
        sheet: guess.form.sheet.clone(),
        decimal: guess.form.decimal().name().to_owned(),
        thousands: guess.form.thousands.map(|t| t.name().to_owned()),
        header: guess.header,
        columns: lines::roles(found, 0).into_iter().map(|role| role.name().to_owned()).collect(),
        share: guess.share(),
    }
}

/// Returns the meaning of each column.
fn columns(table: &Table, found: &Interpretation) -> Vec<FormatsColumn> {
    let column = |(i, taken): (usize, &meaning::Taken)| FormatsColumn {
        number: i + 1,
        heading: table.columns[i].name.clone(),
        unit: table.columns[i].heading.unit.map(str::to_owned),
        taken_for: taken.meaning.words().into(),
        why: taken.why.clone().map(Worded::from).unwrap_or_default(),
        joint: taken.meaning.joint_number(),
    };
    found.taken.iter().enumerate().map(column).collect()
}

/// Returns the reasons for the first interpretation.
fn reasons(best: &Guess, table: &Table) -> Vec<Phrase> {
    let (read, rows) = (best.read, best.rows);
    let fields = match best.form.delimiter {
        Some(delimiter) => {
            phrase!("because-fields", read, rows, fields = best.numeric.len(), delimiter = delimiter.name())
        }
        None => phrase!("because-columns", read, rows, columns = best.numeric.iter().filter(|n| **n).count()),
    };
    let (fractions, numbers, mark) = (best.numbers.fractions, best.numbers.all, best.form.decimal().name());
    let mut reasons = vec![fields, phrase!("because-decimal-marks", fractions, numbers, mark)];
    if let Some(row) = &best.named.row {
        let is = if names(best).is_some() { "header" } else { "last" };
        reasons.push(phrase!("because-line", line = best.named.head.line.unwrap_or(row.line), is));
    }
    if let Some(stated) = best.stated_units.first() {
        reasons.push(phrase!("because-unit-stated", line = stated.line, how = stated.how));
    }
    if table.sampled {
        reasons.push(phrase!("because-sampled", rows = table.rows));
    }
    if table.width > table.columns.len() {
        reasons.push(phrase!("because-columns-sampled", columns = table.columns.len(), width = table.width));
    }
    if let Some(comment) = &best.form.comment {
        reasons.push(phrase!("because-comments", comment));
    }
    if let Some(end) = &best.form.end {
        reasons.push(phrase!("because-end", end));
    }
    reasons
}

/// Returns the doubts about the first interpretation.
fn doubts(guesses: &[Guess], rows_may_differ: bool) -> Vec<Phrase> {
    let [best, others @ ..] = guesses else { return Vec::new() };
    let mut doubts: Vec<Phrase> = others
        .iter()
        .map(|g| {
            let thousands = g.form.thousands.map(|t| format!(", thousands {:?}", t.name())).unwrap_or_default();
            let delimiter = g.form.delimiter.map_or(String::new(), |d| format!("delimiter {:?}, ", d.name()));
            let reading = format!("{delimiter}decimal {:?}{thousands}", g.form.decimal().name());
            phrase!("doubt-other-reading", reading, columns = g.numeric.len())
        })
        .collect();
    let mark = best.form.decimal().name();
    if best.numbers.fractions == 0 {
        doubts.push(phrase!("doubt-decimal-mark", mark));
    } else if best.numbers.threes == best.numbers.fractions && best.form.thousands.is_none() {
        doubts.push(phrase!("doubt-thousands-mark", mark));
    }
    if let Some(line) = best.named.head.line.filter(|_| best.named.head.is_of_groups) {
        doubts.push(phrase!("doubt-groups-alone", line));
    }
    if let Some(line) = best.unread.filter(|_| !rows_may_differ) {
        doubts.push(phrase!("doubt-rows-not-read", count = best.rows - best.read, line));
    }
    if let (Some(row), None) = (&best.named.row, names(best)) {
        let (words, columns) = (row.fields.len(), best.numeric.len());
        if row.fields.iter().any(|f| f.contains(char::is_alphabetic)) && words > 1 {
            doubts.push(phrase!("doubt-words-of-header", line = row.line, words, columns));
        }
    }
    doubts
}

/// Returns the lines with comments above them: reasons, doubts and questions.
fn with_remarks(document: &FormatsDocument, lines: &str) -> String {
    let mut out = String::new();
    let mut remark = |text: String| out.push_str(&format!("# {}\n", printable(&text)));
    remark(format!("proposed for `{}`", document.file));
    document.reasons.iter().for_each(|reason| remark(format!("because {reason}")));
    document.doubts.iter().for_each(|doubt| remark(format!("DOUBT: {doubt}")));
    document.questions.iter().for_each(|question| remark(format!("QUESTION: {question}")));
    for column in document.columns.iter().take(SHOWN_COLUMNS) {
        let why = if column.why.english().is_empty() { String::new() } else { format!(": {}", column.why) };
        let heading = column.heading.as_ref().map(|heading| format!(" `{heading}`")).unwrap_or_default();
        remark(format!("column {}{heading} is {}{why}", column.number, column.taken_for));
    }
    if document.columns.len() > SHOWN_COLUMNS {
        remark(format!("and {} more, which --json lists", count(document.columns.len() - SHOWN_COLUMNS, "column")));
    }
    out + lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_whose_first_row_is_shorter_than_the_others_is_proposed() {
        let text = "4711\t2.0\nP\ta\tb\t1.5\t2.5\t3.5\nQ\ta\tb\t4.5\t5.5\t6.5\n";
        assert_eq!(propose_in("f.xlsx", text, Some("S"), None).readings[0].columns.len(), 6);
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
        // joints with other names than q1, q2 may be the joints of a URDF: a table of observations
        assert!(text.contains("[observations]") && text.contains("column 6 `J1_rad` is joint 1"), "{text}");
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
    fn four_columns_of_length_one_are_a_quaternion_under_any_headings() {
        let turns = ["0.5,0.5,0.5,-0.5", "0.48,0.6,0.64,0", "0.1,0.7,0.1,0.7", "0.8,0,0.36,0.48"];
        let of = |head: &str, rows: &[&str]| {
            let rows = rows.iter().enumerate().map(|(i, row)| format!("{}.5,{}.25,3.5,{row}\n", 1 + 7 * i, 2 + i * i));
            propose("m.csv", &(format!("X,Y,Z,{head}\n") + &rows.collect::<String>()))
        };
        let asks = |document: &FormatsDocument| {
            document
                .questions
                .iter()
                .any(|question| question.phrase().is_some_and(|phrase| phrase.id == "ask-quaternion-order"))
        };
        for (head, columns) in [
            ("Q0,Qx,Qy,Qz", "\"z\", \"qw\", \"qx\", \"qy\", \"qz\"]"),
            ("e0,e1,e2,e3", "\"z\", \"qw\", \"qx\", \"qy\", \"qz\"]"),
        ] {
            let document = of(head, &turns);
            assert!(document.toml.contains(columns) && !asks(&document), "{head}: {}", document.toml);
        }
        for head in ["ori_x,ori_y,ori_z,ori_s", "q_i,q_j,q_k,q_r", "Quat x,Quat y,Quat z,Quat w"] {
            let document = of(head, &turns);
            let read = document.toml.contains("\"z\", \"qx\", \"qy\", \"qz\", \"qw\"]");
            assert!(read && document.doubts.is_empty() && !asks(&document), "{head}: {}", document.toml);
        }
        assert!(of("q3,q0,q1,q2", &turns).toml.contains("\"z\", \"qz\", \"qw\", \"qx\", \"qy\"]"));
        // nothing names the scalar: a question
        for head in ["A,B,C,D", "q1,q2,q3,q4", "e1,e2,e3,e4"] {
            let document = of(head, &turns);
            assert!(!document.toml.contains("\"qw\"") || asks(&document), "{head}: {}", document.toml);
            assert!(document.toml.contains("\"qw\"") || !document.doubts.is_empty(), "{head}: {}", document.toml);
        }
        // numbers from 1 of another length are joints
        let joints = of("q1,q2,q3,q4", &["0.5,0.5,0.5,-0.4", "0.48,0.6,0.64,0", "0.1,0.7,0.1,0.7", "0.8,0,0.36,0.48"]);
        assert!(joints.toml.contains("q4_UNIT = \"q4\"") && !joints.toml.contains("qw"), "{}", joints.toml);
        // a direction beside an empty column, and numbers of another length
        for (head, rows) in [
            ("nx,ny,nz,k", ["0.6,0.8,0,0", "0.36,0.48,0.8,0", "0,0,1,0", "0.8,0,0.6,0"]),
            ("A,B,C,D", ["0.5,0.5,0.5,-0.4", "0.48,0.6,0.64,0", "0.1,0.7,0.1,0.7", "0.8,0,0.36,0.48"]),
        ] {
            let document = of(head, &rows);
            assert!(!document.toml.contains("qw"), "{}", document.toml);
        }
    }

    #[test]
    fn columns_that_nothing_reads_are_in_doubt() {
        let unread = |text: &str| {
            let document = propose("m.csv", text);
            let mut doubts = document.doubts.iter().filter_map(|doubt| doubt.phrase().cloned());
            doubts.find(|doubt| doubt.id == "doubt-columns-not-read")
        };
        for (text, columns) in [
            ("X,Y,Z,sigma x\n1.5,2.5,3.5,0.1\n4.5,5.5,7.5,0.2\n", vec!["4 `sigma x`"]),
            ("X,Y,Z,Distance\n1.5,2.5,3.5,100.5\n4.5,5.5,7.5,101.5\n", vec!["4 `Distance`"]),
            ("X,Y,Z,Laune\n1.5,2.5,3.5,7.25\n4.5,5.5,7.5,6.25\n", vec!["4 `Laune`"]),
        ] {
            assert_eq!(unread(text), Some(phrase!("doubt-columns-not-read", columns, more = 0)), "{text}");
        }
        let whole = "X,Y,Z,ux,uy,uz,speed\n1.5,2.5,3.5,0.1,0.1,0.2,4.5\n4.5,5.5,7.5,0.2,0.1,0.2,5.5\n";
        assert_eq!(unread(whole), None);
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
            document
                .doubts
                .iter()
                .any(|d| d.english().contains("1 row cannot be read in this way; the first is line 3")),
            "{document:?}"
        );
        assert!(document.doubts.iter().any(|d| d.english().contains("no number has a decimal mark")), "{document:?}");
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
            assert!(document.reasons[0].english().contains(mark), "{document:?}");
            assert!(
                document.toml.contains(&format!("[log]\nfile = \"l.csv\"\nformat = \"{format}\"\n")),
                "{document:?}"
            );
        }
        let document = propose("l.csv", "one,ten\n0,0\n1,10\n2,20\n,0\n");
        assert_eq!(document.format, None);
        assert!(document.questions.iter().any(|question| question.english().contains("Galil")), "{document:?}");
    }

    #[test]
    fn what_a_mark_means_may_be_in_doubt() {
        let doubts = propose("p.txt", "a;1,250;2,500;3,750\nb;4,125;5,500;6,250\n").doubts;
        assert!(doubts.iter().any(|d| d.english().contains("it may be a thousands mark")), "{doubts:?}");
        let thousands = propose("p.txt", "a;1.234,50;-2.345,25;3,75\nb;4.125,00;5,50;6,25\n").toml;
        assert!(thousands.contains("decimal = \",\", thousands = \".\""), "{thousands}");
    }

    /// Points of which a few exceed a metre, in every pair of marks; the marks are proposed and x,
    /// y and z are found, with one number in groups of three as with many. A text that two pairs of
    /// marks read is in doubt.
    #[test]
    fn groups_of_three_digits_are_proposed_with_their_mark() {
        let rows = |decimal: &str, group: &str, large: usize| -> String {
            let row = |i: usize| {
                let z =
                    if i < large { format!("1{group}0{i:02}{decimal}1369") } else { format!("9{i:02}{decimal}9525") };
                format!("A_{i}_1;-{i}91{decimal}2391;140{decimal}39{i:02};{z}\r\n")
            };
            (10..40).map(row).collect()
        };
        for (decimal, group, key) in [
            (",", ".", "."),
            (".", ",", ","),
            (".", "'", "'"),
            (".", "\u{2019}", "'"),
            (",", "'", "'"),
            (",", " ", " "),
            (",", "\u{a0}", " "),
            (".", "\u{202f}", " "),
        ] {
            for large in [11, 15, 40] {
                let text = format!("\u{feff}Name;X [mm];Y [mm];Z [mm]\r\n{}", rows(decimal, group, large));
                let document = propose("p.csv", text.trim_start_matches('\u{feff}'));
                let wanted = format!("decimal = {decimal:?}, thousands = {key:?}");
                assert!(document.toml.contains(&wanted), "{decimal} {group} {large}: {}", document.toml);
                assert_eq!(document.readings[0].columns, ["label", "x", "y", "z"], "{decimal} {group} {large}");
                assert!(document.doubts.is_empty(), "{decimal} {group} {large}: {:?}", document.doubts);
            }
            let plain = propose("p.csv", &rows(decimal, "", 40));
            assert!(!plain.toml.contains("thousands"), "{}", plain.toml);
        }
        let ambiguous = propose("p.csv", "a;1,234;2,345;3,456\nb;4,567;5,678;6,789\nc;4,367;5,278;6,189\n");
        assert!(
            ambiguous.doubts.iter().any(|d| d.english().contains("it may be a thousands mark")),
            "{:?}",
            ambiguous.doubts
        );
    }
}
