//! Proposals for reading a file: lines for campaign.toml with reasons, doubts and questions.

mod by_robot;
mod labels;
mod layout;
mod native;
mod recording;
mod several;
mod statements;
mod structure;
#[cfg(test)]
mod tests;

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
use etalon_base::message::{Message, Place, Result, count};
use etalon_base::worded::Worded;
use etalon_base::{error, phrase};
use etalon_documents::{FormatsColumn, FormatsDocument, Reading};
use etalon_robots::Robot;
use etalon_tables::guess::{Guess, guesses, names};
use etalon_tables::{Decimal, Encoding};
use headings::Heading;
use lines::{JOINTS, Proposal};
use meaning::{Interpretation, Meaning, PointSet, Taken};
use statements::{Label, Line, Lines, OPEN_UNIT, Target};
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

/// Proposal for a file: its document, whose lines are values until they are printed.
#[derive(Debug, Default)]
pub(crate) struct Proposed {
    pub document: FormatsDocument,
    pub lines: Lines,
}

impl Proposed {
    /// The document with its lines.
    pub fn printed(self) -> FormatsDocument {
        FormatsDocument { toml: self.lines.to_string(), ..self.document }
    }

    /// The document with these lines, below its reasons, doubts and questions.
    pub fn with_remarks(document: FormatsDocument, lines: Lines) -> Self {
        let lines = remarks(&document).followed_by(lines);
        Self { document, lines }
    }

    /// Adds a doubt above all lines.
    pub fn doubt(&mut self, doubt: Phrase) {
        self.lines.doubt(&doubt);
        self.document.doubt(doubt);
    }

    /// Writes the form of the labels of an export into the lines of a file that is proposed alone.
    fn state_label_form(&mut self, labels: &[String]) {
        let has_both = |(form, targets): &(String, Vec<String>)| form.contains("{pose}") && targets.len() > 1;
        let Some((form, _)) = labels::label_form(labels).filter(has_both) else { return };
        let line = Line::Label(Label::Known { form, labels: labels.len(), stationary: 0 });
        // a format of its own gives no form of its labels
        match self.document.format.is_some() {
            true => self.lines.push(line),
            false => self.lines.replace(&Line::Label(Label::Open), &[line]),
        }
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
    let mut proposed = propose_corrected(
        path,
        None,
        robot,
        Some(&mut |table, found| {
            labels = found.first(Meaning::Label).map(|at| table.columns[at].texts()).unwrap_or_default();
            robot.map(|robot| against::correct(robot, table, found)).unwrap_or_default()
        }),
    )?;
    proposed.state_label_form(&labels);
    Ok(proposed.printed())
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
) -> Result<Proposed> {
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
    let mut proposed = propose_in(&name, &text, None, correct);
    let document = &mut proposed.document;
    if document.readings.is_empty() && document.format.is_none() {
        let message = match () {
            () if structure::has_lists(&text) => error!("numbers-in-brackets"),
            () if structure::has_quoted_lists(&text) || document.rows > 0 => error!("numbers-in-cells"),
            () => error!("no-rows-of-numbers", file = "text"),
        };
        return Err(here(message).into());
    }
    if is_cut && !document.facts.is_sampled {
        let reason = phrase!("because-sampled", rows = document.rows);
        let below_first = proposed.lines.0.len().min(1);
        proposed.lines.0.insert(below_first, Line::Remark(format!("because {reason}")));
        document.because(reason);
    }
    if let Some(encoding) = encoding {
        proposed.lines.insert_behind_files(&Line::Text(format!("encoding = {:?}\n", encoding.name())));
        proposed.doubt(phrase!("doubt-encoding", encoding = encoding.name()));
    }
    Ok(proposed)
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
) -> std::result::Result<Proposed, Message> {
    let mut book = Workbook::open(bytes)?;
    let names = book.sheets();
    for name in names.iter().filter(|name| sheet.is_none_or(|sheet| sheet == *name)) {
        let mut proposed = propose_in(file, &book.text(name, Decimal::Point)?, Some(name), reborrowed(&mut correct));
        if !proposed.document.readings.is_empty() {
            let doubt = workbook::others(&names, name).filter(|_| sheet.is_none());
            doubt.into_iter().for_each(|doubt| proposed.doubt(doubt));
            return Ok(proposed);
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
    propose_in(file, text, None, None).printed()
}

/// Returns the proposal for a text that gives its format.
fn propose_known_format(empty: &FormatsDocument, file: &str, text: &str, correct: Option<Correct>) -> Option<Proposed> {
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
    correct.into_iter().for_each(|correct| correct(&mut table, &mut found).add_to(&mut document));
    if !points.is_empty() && points.iter().all(|point| point.refused.is_some()) {
        document.kind = "unknown".to_owned();
        let lines = Lines::default().with_text(format!("# `{file}`: no row has the coordinates of a point\n"));
        return Some(Proposed::with_remarks(document, lines));
    }
    let (stated, unit) = (unit, unit.or(table.columns[0].heading.unit));
    let unit_line = if stated.is_some() { lines::unit_line(unit) } else { lines::fitted_unit_line(unit) };
    let mut lines = Lines::element("export").with(Line::File(file.to_owned()));
    lines.push(Line::Format(format!("{format:?}")));
    lines.push(Line::Text(unit_line));
    if unit.is_none() {
        document.ask(phrase!("ask-unit"));
    }
    let columns = Format::named(format).map(|format| format.dialect.columns.roles()).unwrap_or_default();
    let labelled = points.is_empty() || points.iter().any(|point| !point.label.is_empty());
    if !(columns.is_empty() && labelled || columns.contains(&ColumnRole::Label)) {
        lines = lines.with(Line::Target(Target::Open)).with(Line::PoseByRow);
    }
    Some(Proposed::with_remarks(document, lines))
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
fn propose_in(file: &str, text: &str, sheet: Option<&str>, mut correct: Option<Correct>) -> Proposed {
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
            None => Lines::section("log")
                .with(Line::File(file.to_owned()))
                .with(Line::Format(format!("{:?}", kind.about().name)))
                .with(Line::Columns(vec![(format!("q1_{OPEN_UNIT}"), quoted("NAME"))]))
                .with_text(JOINTS),
        };
        return Proposed::with_remarks(document, lines);
    }
    if best.is_some_and(|(_, (table, found))| divides_lists(table, found)) {
        document.readings.clear();
        return Proposed { document, lines: Lines::default() };
    }
    let (Some((best, (table, found))), Some(proposal)) = (best, proposal) else {
        let text = format!("# `{file}`: no reading as delimited text gives rows with two or more numbers\n");
        return Proposed { document, lines: Lines::default().with_text(text) };
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
    Proposed::with_remarks(document, lines)
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

/// Returns reasons, doubts, questions and the meaning of the columns as comments.
fn remarks(document: &FormatsDocument) -> Lines {
    let mut out = Lines::default();
    let remark = Line::Remark;
    out.push(remark(format!("proposed for `{}`", document.file)));
    document.reasons.iter().for_each(|reason| out.push(remark(format!("because {reason}"))));
    document.doubts.iter().for_each(|doubt| out.push(remark(format!("DOUBT: {doubt}"))));
    document.questions.iter().for_each(|question| out.push(Line::Question(question.clone())));
    for column in document.columns.iter().take(SHOWN_COLUMNS) {
        let why = if column.why.english().is_empty() { String::new() } else { format!(": {}", column.why) };
        let heading = column.heading.as_ref().map(|heading| format!(" `{heading}`")).unwrap_or_default();
        out.push(remark(format!("column {}{heading} is {}{why}", column.number, column.taken_for)));
    }
    if document.columns.len() > SHOWN_COLUMNS {
        let more = count(document.columns.len() - SHOWN_COLUMNS, "column");
        out.push(remark(format!("and {more} more, which --json lists")));
    }
    out
}
