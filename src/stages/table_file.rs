//! Tables of commands and campaigns: all are read here.

use super::{kinds, orientations, truncated};
use crate::stages::orientations::AngleOrder;
use etalon_base::catalogue::Phrase;
use etalon_base::files::{self, Stamp};
use etalon_base::message::{Message, Place, Problems, Result, nearest};
use etalon_base::{error, phrase};
use etalon_campaign::{Campaign, ObservationsDefinition, StreamDefinition, TableDefinition};
use etalon_documents::{Refused, Source, SourceKind};
use etalon_formats::table::{Table, XYZ};
use etalon_formats::tables::joints::stated_columns;
use etalon_formats::{Format, TableReading};
use etalon_robots::Robot;
use etalon_tables::{Form, TableLayout};
use std::path::Path;
use toml::Spanned;

/// A table with its texts: of one file, or of several whose rows follow each other.
#[derive(Clone, Debug)]
pub(crate) struct TableFile {
    /// File name given by the user.
    pub name: String,
    pub table: Table,
    /// Name and text of each file.
    texts: Vec<(String, String)>,
}

/// Maximum number of columns in a message.
const NAMED: usize = 8;

/// Problems of rows of a join, which belong to no file: about the campaign.
pub(crate) fn in_campaign(mut problems: Problems, path: &str) -> Problems {
    for place in problems.0.iter_mut().filter_map(|message| message.place.as_mut()) {
        if place.file.is_empty() {
            **place = Place::file(path);
        }
    }
    problems
}

impl TableFile {
    pub fn read(path: &Path) -> Result<Self> {
        Self::new(path, files::text(path, files::read(path)?)?, etalon_formats::observations)
    }

    /// A table in a text or in a sheet of a workbook; its only sheet, if none is given.
    pub fn observations(path: &Path, bytes: &[u8], reading: &TableReading) -> Result<Self> {
        let mut reading = reading.clone();
        let form = &mut reading.layout.form;
        form.sheet = form.sheet.take().or_else(|| etalon_formats::only_sheet(bytes));
        let text = etalon_formats::file_text(path, bytes, form.encoding, &Format::from(form.clone()))?;
        Self::new(path, text, |name, text| etalon_formats::observations_with(name, text, &reading))
    }

    /// A table that is in memory as CSV; `name` stands for its file.
    pub fn parse(name: &str, text: &str) -> Result<Self> {
        Self::new(Path::new(name), text.to_owned(), etalon_formats::observations)
    }

    /// A table in memory without text; `name` stands for its file.
    pub fn in_memory(name: &str, table: Table) -> Self {
        Self { name: name.to_owned(), table, texts: Vec::new() }
    }

    /// Reads a table of another layout.
    pub fn parse_with(name: &str, text: &str, reading: &TableReading) -> Result<Self> {
        let table = |name: &str, text: &str| etalon_formats::observations_with(name, text, reading);
        Self::new(Path::new(name), text.to_owned(), table)
    }

    /// Reads a table from the text of the file, by its name and text.
    pub fn new(path: &Path, text: String, table: impl FnOnce(&str, &str) -> Result<Table>) -> Result<Self> {
        let name = path.display().to_string();
        Ok(Self { table: table(&name, &text)?, name: name.clone(), texts: vec![(name, text)] })
    }

    /// The text of the first file.
    pub fn text(&self) -> &str {
        self.texts.first().map_or("", |(_, text)| text)
    }

    /// Removes the rows for which `left_out` is true.
    pub fn leave_out(&mut self, left_out: &[bool]) {
        if left_out.contains(&true) {
            self.table = self.table.rows(|row| !left_out[row]);
        }
    }

    /// Leaves out the rows in which nothing was measured, and lists them.
    fn leave_out_unmeasured(&mut self, robot: &dyn Robot) -> Result<Vec<Refused>> {
        let rows = kinds::unmeasured_rows(robot, &self.table)?;
        let mut left_out = vec![false; self.table.height()];
        let refused = |(row, reason): (usize, Phrase)| {
            left_out[row] = true;
            let line = self.table.line(row).unwrap_or(0);
            Refused::new(line, self.text().lines().nth(line.saturating_sub(1)).unwrap_or_default(), reason)
        };
        let refused = rows.into_iter().map(refused).collect();
        self.leave_out(&left_out);
        Ok(refused)
    }

    /// The names in the column `target`, each once, in their order.
    pub fn targets(&self) -> Result<Vec<String>> {
        let mut targets: Vec<String> = Vec::new();
        for name in self.table.texts("target").map_err(|more| self.place(more))? {
            if targets.iter().all(|target| *target != name) {
                targets.push(name.into_owned());
            }
        }
        Ok(targets)
    }

    /// Problems of the table, each with its line.
    pub fn place(&self, problems: Problems) -> Problems {
        self.texts.iter().fold(problems, |problems, (name, text)| {
            let is_named = |m: &Message| m.place.as_ref().is_some_and(|place| place.file == *name);
            let is_meant = self.texts.len() == 1 || problems.0.iter().any(is_named);
            if is_meant { problems.in_text(name, text) } else { problems }
        })
    }

    /// This table, followed by the rows of another one.
    fn followed_by(mut self, other: Self) -> Self {
        self.table = self.table.followed_by(other.table);
        self.texts.extend(other.texts);
        self
    }
}

/// The robot of a campaign with the targets of a table.
fn robot_with(campaign: &Campaign, table: &TableFile) -> Option<Box<dyn Robot>> {
    let targets = table.targets().unwrap_or_default();
    campaign.build_robot_with(&targets).or_else(|_| campaign.build_robot()).ok()
}

/// Reads the tables that a campaign names, and lists them as its inputs.
#[derive(Debug)]
pub(crate) struct CampaignTables<'a> {
    pub campaign: &'a Campaign,
    pub sources: Vec<Source>,
}

impl CampaignTables<'_> {
    /// A table in the form that the campaign contains, of one file or of several; `holds` describes
    /// it in the list of inputs.
    pub fn read(&mut self, table: &TableDefinition, kind: SourceKind, holds: Phrase) -> Result<TableFile> {
        self.read_in(table, &TableReading::any(TableLayout::default()), kind, holds)
    }

    /// A table with keys of its own, or in the form of its section where it gives none.
    pub fn read_in(
        &mut self,
        table: &TableDefinition,
        section: &TableReading,
        kind: SourceKind,
        holds: Phrase,
    ) -> Result<TableFile> {
        if let Some(key) = table.keys().and_then(|keys| keys.layout.form.meaningless_beside_sheet()) {
            return Err(error!("key-of-text-table", key).at(self.campaign.place(table.first())).into());
        }
        let own = table.keys().map(|keys| TableReading::any(keys.layout.or(&section.layout)));
        let reading = own.as_ref().unwrap_or(section);
        let mut problems = Problems::default();
        let mut all: Option<TableFile> = None;
        for file in table.files() {
            let read =
                self.listed(file, kind, holds.clone(), |path, bytes| TableFile::observations(path, &bytes, reading));
            let Some(read) = problems.keep(read) else { continue };
            all = Some(match all {
                Some(before) => before.followed_by(read),
                None => read,
            });
        }
        problems.check()?;
        all.ok_or_else(|| error!("data-rows-missing").at(self.campaign.place(table.first())).into())
    }

    /// The tables of observations, one after the other.
    pub fn all_observations(&mut self, stated: &[ObservationsDefinition]) -> Result<Option<TableFile>> {
        let first = self.sources.len();
        let mut tables = stated.iter().map(|definition| self.observations(definition)).collect::<Result<Vec<_>>>()?;
        for (table, definition) in tables.iter().zip(stated) {
            self.whole(table, &tables).map_err(|more| more.at(&self.campaign.place(&definition.file)))?;
        }
        for (table, source) in tables.iter_mut().zip(&mut self.sources[first..]) {
            let Some(robot) = robot_with(self.campaign, table) else { continue };
            source.refused = table.leave_out_unmeasured(robot.as_ref())?;
        }
        Ok(tables.into_iter().reduce(TableFile::followed_by))
    }

    /// Checks that a table has the columns of joints, loads, torques and temperature that other
    /// tables have, and no similar heading instead of a missing coordinate.
    fn whole(&self, table: &TableFile, tables: &[TableFile]) -> Result<()> {
        let Some(robot) = robot_with(self.campaign, table) else { return Ok(()) };
        let others = || tables.iter().flat_map(|other| other.table.names());
        let joints = robot.joints().iter().filter(|joint| table.table.names().all(|name| joint.factor(name).is_none()));
        let joint = joints.filter_map(|joint| others().find(|name| joint.factor(name).is_some())).next();
        let has = |name: &str| table.table.has(name);
        let unread = self.not_read(table);
        let meant = |name: &&str| nearest(name, unread.iter().map(String::as_str)).is_some();
        let axis = XYZ[..robot.dimension()].iter().copied().filter(|name| !has(name)).find(meant);
        let stated = || stated_columns(robot.as_ref()).into_iter();
        let stated = stated().find(|name| !has(name) && others().any(|other| other == *name));
        let by_pose = joint.map(str::to_owned).or(stated).filter(|_| has("pose"));
        let Some(column) = by_pose.or(axis.map(str::to_owned)) else { return Ok(()) };
        let message = error!("column-unknown", column);
        let place = Place { line: Some(1), ..Place::file(&table.name) };
        Err(message.hint_names(&column, unread.iter().map(String::as_str)).at(place).into())
    }

    /// A table of observations.
    fn observations(&mut self, stated: &ObservationsDefinition) -> Result<TableFile> {
        if let Some(key) = stated.layout.form.meaningless_beside_sheet() {
            let place = self.campaign.key_place(&["observations", key]);
            return Err(error!("key-of-text-table", key).at(place).into());
        }
        let holds = phrase!("table-of-observations");
        let mut table = self.listed(&stated.file, SourceKind::Table, holds.clone(), |path, bytes| {
            TableFile::observations(path, &bytes, &stated.reading())
        })?;
        if let Some(order) = &stated.orientation {
            let of_campaign = |m: Message| m.at(self.campaign.place(order));
            order.get_ref().parse::<AngleOrder>().map_err(of_campaign)?;
            orientations::state_order(&mut table.table, order.get_ref());
        }
        table.table.name_file(stated.file.get_ref());
        let unread = self.not_read(&table);
        if let Some(source) = self.sources.last_mut().filter(|_| !unread.is_empty()) {
            let columns = truncated(unread.iter().map(|name| format!("`{name}`")), NAMED);
            source.read_as(phrase!("read-except-columns", read = holds, columns));
        }
        Ok(table)
    }

    /// Columns of a table of observations that are not read; none if the robot cannot be built.
    fn not_read(&self, table: &TableFile) -> Vec<String> {
        let robot = robot_with(self.campaign, table);
        robot.map_or_else(Vec::new, |robot| kinds::unread_columns(robot.as_ref(), &table.table))
    }

    /// A recorded motion: an export in its format, or a table of etalon.
    pub fn recording(&mut self, stream: &StreamDefinition) -> Result<TableFile> {
        self.listed(&stream.file, SourceKind::Stream, phrase!("recorded-motion-file"), |path, bytes| {
            match (&stream.format, stream.unit) {
                (Some(format), Some(unit)) => {
                    let text = etalon_formats::file_text(path, &bytes, stream.encoding, format)?;
                    TableFile::new(path, text, |file, text| etalon_formats::recorded_points(file, text, format, unit))
                }
                _ => {
                    let form = Form { encoding: stream.encoding, ..Form::default() };
                    let reading = TableReading::any(TableLayout { form, ..TableLayout::default() });
                    TableFile::observations(path, &bytes, &reading)
                }
            }
        })
    }

    fn listed(
        &mut self,
        file: &Spanned<String>,
        kind: SourceKind,
        holds: Phrase,
        read: impl FnOnce(&Path, Vec<u8>) -> Result<TableFile>,
    ) -> Result<TableFile> {
        let here = self.campaign.place(file);
        let path = self.campaign.resolve(file)?;
        let bytes = files::read(&path).map_err(|more| more.at(&here))?;
        let stamp = Stamp::new(&bytes);
        let table = read(&path, bytes).map_err(|more| more.at(&here))?;
        self.sources.push(Source {
            file: file.get_ref().clone(),
            sha256: stamp.sha256,
            sha256_without_backup: None,
            bytes: stamp.size,
            kind,
            dialect: holds.into(),
            rows_read: table.table.height(),
            refused: Vec::new(),
            standstills: Vec::new(),
        });
        Ok(table)
    }
}
