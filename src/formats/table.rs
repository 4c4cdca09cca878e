//! Tables with typed columns, and the names of their columns: observations, poses, loads and joints
//! between their file and their use.

use etalon_base::catalogue::Phrase;
use etalon_base::cell::cell;
use etalon_base::message::{Message, Place, Problems, Result, nearest};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use serde::Serialize;
use std::borrow::Cow;

/// Columns of the coordinates (mm).
pub const XYZ: [&str; 3] = ["x_mm", "y_mm", "z_mm"];

/// Columns of the standard uncertainties of the coordinates.
pub const UNCERTAINTIES: [&str; 3] = ["ux_mm", "uy_mm", "uz_mm"];

/// Columns of the covariance of the coordinates (mm²): upper triangle, row by row.
pub const COVARIANCES: [&str; 6] = ["cxx_mm2", "cxy_mm2", "cxz_mm2", "cyy_mm2", "cyz_mm2", "czz_mm2"];

/// Columns of the angles (deg): rotations about the axes of the given rotation order.
pub const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];

/// Columns of the angles (rad).
pub const RADIANS: [&str; 3] = ["a_rad", "b_rad", "c_rad"];

/// Columns of the orientation of a body in the world: quaternion, scalar first.
pub const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];

/// Columns of the orientation of a body in the world: rotation matrix, row by row.
pub const MATRIX: [&str; 9] = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];

/// Beginning of columns of the pose of the flange, in tables of a cell.
pub const FLANGE: &str = "flange_";

/// Column of the label of a point; in a log, of the point that the robot touches.
pub const LABEL: &str = "label";

/// Column of the time of a measurement (s).
pub const TIME: &str = "time_s";
/// Columns of text in a table of observations, in the order of writing.
pub const TEXTS: [&str; 11] =
    ["kind", "target", "socket", "other", "plane", "line_name", "sphere", "axis", "station", "joint", ANGLE_ORDER];
/// Column of the order of the three angles of an orientation.
pub const ANGLE_ORDER: &str = "orientation";
/// Column of the assembly mode, +1 or -1, for robots with several modes.
pub const ASSEMBLY: &str = "assembly";

/// Column of the names of poses.
const POSE: &str = "pose";
/// Column of the numbers of repeats.
const CYCLE: &str = "cycle";
/// Column of a direction of motion.
const DIRECTION: &str = "direction";
/// Column of the line of each row, in a table that is written.
const LINE: &str = "line";
/// Offset of the line numbers of each further file, in a table that is written.
const FILE_LINES: usize = 1_000_000_000;

/// Returns the error that a table cannot be built.
pub fn failed(error: impl std::fmt::Display) -> Problems {
    error!("table-failed", reason = error.to_string()).into()
}

/// Source of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowSource {
    /// Index of the file among the files of the table.
    pub file: usize,
    /// Line of the file, from 1.
    pub line: usize,
}

/// Values of a column; `None` for empty cells.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Numbers.
    Numbers(Vec<Option<f64>>),
    /// Whole numbers.
    Whole(Vec<Option<i64>>),
    /// Names of poses.
    Poses(Vec<Option<PoseName>>),
    /// Texts.
    Texts(Vec<Option<String>>),
}

impl Values {
    /// Number of rows.
    fn len(&self) -> usize {
        match self {
            Self::Numbers(all) => all.len(),
            Self::Whole(all) => all.len(),
            Self::Poses(all) => all.len(),
            Self::Texts(all) => all.len(),
        }
    }

    /// Number in a row; NaN for an empty cell or a text.
    pub fn number(&self, row: usize) -> f64 {
        let number = match self {
            Self::Numbers(all) => all[row],
            Self::Whole(all) => all[row].map(|whole| whole as f64),
            Self::Poses(all) => all[row].and_then(PoseName::number).map(|whole| whole as f64),
            Self::Texts(all) => all[row].as_ref().and_then(|text| text.parse().ok()),
        };
        number.unwrap_or(f64::NAN)
    }

    /// Text in a row; empty for an empty cell.
    fn text(&self, row: usize) -> Cow<'_, str> {
        let text = match self {
            Self::Numbers(all) => all[row].map(|number| number.to_string()),
            Self::Whole(all) => all[row].map(|whole| whole.to_string()),
            Self::Poses(all) => all[row].map(|pose| pose.to_string()),
            Self::Texts(all) => return all[row].as_deref().unwrap_or_default().into(),
        };
        text.unwrap_or_default().into()
    }

    /// Cell of a row as CSV; formulas are escaped.
    fn cell(&self, row: usize) -> Cell {
        let cell = match self {
            Self::Numbers(all) => all[row].map(Cell::Real),
            Self::Whole(all) => all[row].map(Cell::Whole),
            Self::Poses(all) => all[row].map(|pose| Cell::Text(cell(&pose.to_string()))),
            Self::Texts(all) => all[row].as_deref().map(|text| Cell::Text(cell(text))),
        };
        cell.unwrap_or(Cell::Missing(()))
    }

    /// The values of some rows; empty cells for `None`.
    fn rows(&self, rows: &[Option<usize>]) -> Self {
        fn picked<T: Clone>(all: &[Option<T>], rows: &[Option<usize>]) -> Vec<Option<T>> {
            rows.iter().map(|row| all[(*row)?].clone()).collect()
        }
        match self {
            Self::Numbers(all) => Self::Numbers(picked(all, rows)),
            Self::Whole(all) => Self::Whole(picked(all, rows)),
            Self::Poses(all) => Self::Poses(picked(all, rows)),
            Self::Texts(all) => Self::Texts(picked(all, rows)),
        }
    }

    /// These values, followed by others; numbers and texts become texts.
    fn followed_by(&self, below: &Self) -> Self {
        let cells = || [self, below].into_iter().flat_map(|values| (0..values.len()).map(move |row| (values, row)));
        match (self, below) {
            (Self::Whole(a), Self::Whole(b)) => Self::Whole([&a[..], b].concat()),
            (Self::Poses(a), Self::Poses(b)) => Self::Poses([&a[..], b].concat()),
            (Self::Numbers(_) | Self::Whole(_), Self::Numbers(_) | Self::Whole(_)) => {
                Self::Numbers(cells().map(|(values, row)| Some(values.number(row)).filter(|v| !v.is_nan())).collect())
            }
            (Self::Texts(a), Self::Texts(b)) => Self::Texts([&a[..], b].concat()),
            _ => Self::Texts(cells().map(|(values, row)| Some(values.text(row).into_owned())).collect()),
        }
    }
}

/// Named columns with a value for each row, and the sources of the rows.
#[derive(Clone, Debug, Default)]
pub struct Table {
    columns: Vec<(String, Values)>,
    /// Source of each row; empty for rows of no file.
    sources: Vec<RowSource>,
    /// Names of the files, for messages.
    files: Vec<String>,
}

impl Table {
    /// Table without columns, whose rows are lines of a file.
    pub fn from_file(file: &str, lines: impl Iterator<Item = usize>) -> Self {
        let sources = lines.map(|line| RowSource { file: 0, line }).collect();
        Self { columns: Vec::new(), sources, files: vec![file.to_owned()] }
    }

    /// Sets the values of a column; a new column is the last one.
    pub fn set(&mut self, name: impl Into<String>, values: Values) {
        let name = name.into();
        match self.columns.iter_mut().find(|(other, _)| *other == name) {
            Some((_, old)) => *old = values,
            None => self.columns.push((name, values)),
        }
    }

    /// Names the file of a table of one file, for messages.
    pub fn name_file(&mut self, name: &str) {
        self.files = vec![name.to_owned()];
    }

    /// Number of rows.
    pub fn height(&self) -> usize {
        self.columns.first().map_or(self.sources.len(), |(_, values)| values.len())
    }

    /// Names of the columns.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(|(name, _)| name.as_str())
    }

    /// `true` if there is a column of this name.
    pub fn has(&self, name: &str) -> bool {
        self.values(name).is_some()
    }

    /// Values of a column, if there is one.
    pub fn values(&self, name: &str) -> Option<&Values> {
        self.columns.iter().find(|(other, _)| other == name).map(|(_, values)| values)
    }

    /// Columns in their order.
    pub fn into_columns(self) -> Vec<(String, Values)> {
        self.columns
    }

    /// Text of a cell, if it is not empty.
    pub fn text(&self, row: usize, name: &str) -> Option<&str> {
        match self.values(name)? {
            Values::Texts(all) => all[row].as_deref().filter(|text| !text.is_empty()),
            _ => None,
        }
    }

    /// Line of a row in its file, if it has one.
    pub fn line(&self, row: usize) -> Option<usize> {
        self.sources.get(row).map(|source| source.line)
    }

    /// `true` if a row is a line of the first file.
    pub fn is_in_first_file(&self, row: usize) -> bool {
        self.sources.get(row).is_some_and(|source| source.file == 0)
    }

    /// Name of the first file; empty for rows of no file.
    pub fn file(&self) -> &str {
        self.files.first().map_or("", String::as_str)
    }

    /// File and line of a row.
    pub fn place(&self, row: usize) -> Place {
        let Some(source) = self.sources.get(row) else { return Place::default() };
        Place { line: Some(source.line), ..Place::file(self.files[source.file].as_str()) }
    }

    /// First line of the first file.
    pub fn header(&self) -> Place {
        Place { line: Some(1), ..Place::file(self.file()) }
    }

    /// First line of the file of a row.
    pub fn header_above(&self, row: usize) -> Place {
        Place { line: Some(1), ..self.place(row) }
    }

    /// Returns a column as numbers; missing values are NaN.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>> {
        let values = self.column(name)?;
        Ok((0..values.len()).map(|row| values.number(row)).collect())
    }

    /// Returns a column of whole numbers; `None` for missing values.
    pub fn optional_integers(&self, name: &str) -> Result<Vec<Option<i64>>> {
        let wrong = |value: String| Problems::from(error!("not-whole-number", value, column = name));
        match self.column(name)? {
            Values::Whole(all) => Ok(all.clone()),
            Values::Numbers(all) => {
                let whole = |v: &f64| v.fract() == 0.0 && v.abs() <= 9e15;
                match all.iter().flatten().find(|v| !whole(v)) {
                    Some(other) => Err(wrong(other.to_string())),
                    None => Ok(all.iter().map(|v| Some((*v)? as i64)).collect()),
                }
            }
            other => {
                let whole = |text: Cow<str>| match &*text {
                    "" => Ok(None),
                    text => text.parse().map(Some).map_err(|_| wrong(text.to_owned())),
                };
                (0..other.len()).map(|row| whole(other.text(row))).collect()
            }
        }
    }

    /// Returns a column of whole numbers without gaps.
    pub fn integers(&self, name: &str) -> Result<Vec<i64>> {
        let whole = |v: Option<i64>| v.ok_or_else(|| error!("cell-empty", column = name).into());
        self.optional_integers(name)?.into_iter().map(whole).collect()
    }

    /// Returns the names of poses in the column `pose`; `None` for rows without a pose.
    pub fn optional_poses(&self) -> Result<Vec<Option<PoseName>>> {
        match self.column(POSE)? {
            Values::Poses(all) => Ok(all.clone()),
            Values::Texts(all) => {
                let name = |text: &Option<String>| text.as_deref().map(PoseName::new).transpose();
                Ok(all.iter().map(name).collect::<std::result::Result<_, _>>()?)
            }
            _ => Ok(self.optional_integers(POSE)?.into_iter().map(|whole| whole.map(PoseName::from)).collect()),
        }
    }

    /// Returns the names of poses in the column `pose`, without gaps.
    pub fn poses(&self) -> Result<Vec<PoseName>> {
        let poses = self.optional_poses()?;
        let are_numbers = poses.iter().flatten().all(|pose| pose.number().is_some());
        let name = |pose: &Option<PoseName>| -> Result<PoseName> {
            match pose {
                Some(pose) => Ok(*pose),
                None if are_numbers => Err(error!("cell-empty", column = POSE).into()),
                None => Ok(PoseName::new("")?),
            }
        };
        poses.iter().map(name).collect()
    }

    /// Returns a column as text; missing values are empty.
    pub fn texts(&self, name: &str) -> Result<Vec<Cow<'_, str>>> {
        let values = self.column(name)?;
        Ok((0..values.len()).map(|row| values.text(row)).collect())
    }

    /// Returns the coordinates (mm); without `z_mm`, or if the column is empty, z = 0.
    pub fn positions(&self) -> Result<Vec<Vector>> {
        let (x, y) = (self.numbers(XYZ[0])?, self.numbers(XYZ[1])?);
        let mut z = if self.has(XYZ[2]) { self.numbers(XYZ[2])? } else { vec![0.0; x.len()] };
        if z.iter().all(|z| z.is_nan()) {
            z.fill(0.0);
        }
        Ok(x.into_iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z]).collect())
    }

    /// Checks that the table has these columns.
    ///
    /// # Errors
    /// Reports each missing column, at line 1 of the file.
    pub fn require<S: AsRef<str>>(&self, names: impl IntoIterator<Item = S>) -> Result<()> {
        self.require_in(names.into_iter().map(|name| (name, None)))
    }

    /// Checks that the table has these columns like [`Self::require`]. The unit beside a name is
    /// the one that the values of the columns suggest, for hints.
    pub fn require_in<S: AsRef<str>>(&self, names: impl IntoIterator<Item = (S, Option<&'static str>)>) -> Result<()> {
        let missing = names.into_iter().filter(|(name, _)| !self.has(name.as_ref()));
        let missing = missing.map(|(name, unit)| self.missing(name.as_ref(), unit).at(self.header()));
        Problems(missing.collect()).check().map(drop)
    }

    /// Columns of a position that the table needs: x and y; and z, if x or y is missing and there
    /// is a heading of z.
    pub fn coordinate_columns(&self) -> impl Iterator<Item = &'static str> {
        let has_others = self.has(XYZ[0]) && self.has(XYZ[1]);
        let needs_z = !has_others && !self.has(XYZ[2]) && self.heading_of_coordinate(XYZ[2]).is_some();
        XYZ.into_iter().take(if needs_z { 3 } else { 2 })
    }

    /// The rows for which `is_kept` is true.
    pub fn rows(&self, is_kept: impl Fn(usize) -> bool) -> Self {
        let rows: Vec<Option<usize>> = (0..self.height()).filter(|&row| is_kept(row)).map(Some).collect();
        let columns = self.columns.iter().map(|(name, values)| (name.clone(), values.rows(&rows)));
        let sources = rows.iter().filter_map(|row| self.sources.get((*row)?).copied());
        Self { columns: columns.collect(), sources: sources.collect(), files: self.files.clone() }
    }

    /// The columns whose names begin with `prefix`, without it.
    pub fn without_prefix(&self, prefix: &str) -> Self {
        let columns = self.columns.iter();
        let columns =
            columns.filter_map(|(name, values)| Some((name.strip_prefix(prefix)?.to_owned(), values.clone())));
        Self { columns: columns.collect(), sources: self.sources.clone(), files: self.files.clone() }
    }

    /// This table, followed by the rows of another one; cells of columns that a table does not
    /// contain are empty.
    pub fn followed_by(mut self, below: Self) -> Self {
        let [above, other] = [self.height(), below.height()].map(|height| vec![None; height]);
        for (name, values) in &mut self.columns {
            let more = below.values(name).cloned().unwrap_or_else(|| values.rows(&other));
            *values = values.followed_by(&more);
        }
        for (name, values) in below.columns {
            if !self.has(&name) {
                self.set(name, values.rows(&above).followed_by(&values));
            }
        }
        let files = self.files.len();
        self.sources.extend(below.sources.into_iter().map(|source| RowSource { file: files + source.file, ..source }));
        self.files.extend(below.files);
        self
    }

    /// The table as it is written: with the lines of its rows as the column `line`.
    pub fn with_lines(mut self) -> Self {
        if !self.sources.is_empty() {
            let line = |source: RowSource| Some((source.file * FILE_LINES + source.line) as i64);
            let lines = Values::Whole(std::mem::take(&mut self.sources).into_iter().map(line).collect());
            self.columns.insert(0, (LINE.to_owned(), lines));
        }
        self
    }

    /// Returns the table as CSV; missing values are empty, formulas are escaped.
    pub fn to_csv(&self) -> Result<Vec<u8>> {
        let mut writer = ::csv::Writer::from_writer(Vec::new());
        writer.write_record(self.names().map(cell)).map_err(failed)?;
        for row in 0..self.height() {
            let cells: Vec<Cell> = self.columns.iter().map(|(_, values)| values.cell(row)).collect();
            writer.serialize(cells).map_err(failed)?;
        }
        writer.into_inner().map_err(failed)
    }

    fn column(&self, name: &str) -> Result<&Values> {
        self.values(name).ok_or_else(|| self.missing(name, None).into())
    }

    /// Headings of other programs.
    fn foreign(&self) -> impl Iterator<Item = &str> {
        self.names().filter(|name| !is_native_column(name))
    }

    /// Heading of another program whose only letter, without a unit, is the letter of a coordinate,
    /// with numbers below it: `X` for `x_mm`, `A` for `a_deg`.
    pub fn heading_of_coordinate(&self, name: &str) -> Option<&str> {
        let mut found = self.foreign().filter(|heading| names_coordinate(heading, name) && self.may_be(name, heading));
        found.next().filter(|_| found.next().is_none())
    }

    /// Heading of another program that a missing column of a joint or coordinate may have: the only
    /// one, or the one with the same number or letter.
    pub fn heading_for(&self, name: &str) -> Option<&str> {
        let foreign: Vec<&str> = self.foreign().collect();
        // of many headings the one with the same number, `J1` for `q1_deg`, or the same letter, `X`
        // for `x_mm`
        let alike: Vec<&str> = match digits(name) {
            _ if foreign.len() < 2 => foreign,
            _ if name == DIRECTION => foreign.into_iter().filter(|heading| self.may_be(name, heading)).collect(),
            number if number.is_empty() => {
                foreign.into_iter().filter(|heading| names_coordinate(heading, name)).collect()
            }
            number => foreign.into_iter().filter(|heading| digits(heading) == number).collect(),
        };
        // a column of the same quantity in another unit is not the column that is missing
        let stem = |name: &'_ str| name.rsplit_once('_').map(|(stem, _)| stem.to_owned());
        match alike[..] {
            [heading] => Some(heading).filter(|heading| {
                !heading.contains('"')
                    && stem(heading).is_none_or(|s| stem(name) != Some(s))
                    && self.may_be(name, heading)
            }),
            _ => None,
        }
    }

    /// Finite numbers of a column, also if they are texts.
    pub fn plain_numbers(&self, name: &str) -> Vec<f64> {
        let Some(values) = self.values(name) else { return Vec::new() };
        let number = |row: usize| match values {
            Values::Texts(_) => values.text(row).trim().replace(',', ".").parse().ok(),
            _ => Some(values.number(row)),
        };
        (0..values.len()).filter_map(number).filter(|v: &f64| v.is_finite()).collect()
    }

    /// Error about a column that the table does not contain, with the column that may be meant, in
    /// the unit of its heading or in the unit that its values suggest.
    fn missing(&self, name: &str, suggested: Option<&'static str>) -> Message {
        // the program adds this column
        let names: Vec<&str> = self.names().filter(|other| *other != CYCLE || name == CYCLE).collect();
        let foreign: Vec<&str> = self.foreign().collect();
        let message = error!("column-unknown", column = name);
        // a pose or a label is not the column that is missing
        let others: Vec<&str> = names.iter().copied().filter(|name| !OF_ROWS.contains(name)).collect();
        let names = if others.is_empty() { names } else { others };
        // `q6_deg` is not `q1_deg`
        let may_be_meant = |other: &&str| !is_native_column(other) || digits(other) == digits(name);
        let similar: Vec<&str> = names.into_iter().filter(may_be_meant).collect();
        let only = || match name {
            CYCLE => self.heading_of_cycles(),
            _ => foreign.first().filter(|_| foreign.len() == 1).copied(),
        };
        let heading = || nearest(name, foreign.iter().copied()).or_else(only).unwrap_or("HEADING");
        match self.heading_for(name) {
            _ if name == "target" => message.hint(phrase!("state-column-or-target", heading = heading())),
            _ if name == POSE => message.hint(phrase!("state-column-or-pose", heading = heading())),
            _ if name == CYCLE => message.hint(phrase!("state-column-or-cycle", heading = heading())),
            Some(heading) => {
                let hint = match (unit_of_heading(heading), suggested) {
                    (None, Some(unit)) => {
                        phrase!("state-column-in-unit", column = in_unit(name, unit), heading, unit)
                    }
                    (unit, _) => {
                        let column = unit.map_or(name.to_owned(), |unit| in_unit(name, unit));
                        phrase!("state-column", column, heading)
                    }
                };
                message.hint(hint)
            }
            None if !foreign.is_empty() && nearest(name, similar.iter().copied()).is_none() => {
                let names = &foreign[..foreign.len().min(SHOWN)];
                message.hint(phrase!("state-column-of", column = name, names))
            }
            None => message.hint_names(name, similar),
        }
    }

    /// The only heading of another program with counts of repeats.
    fn heading_of_cycles(&self) -> Option<&str> {
        let is_count = |name: &&str| {
            let numbers = self.plain_numbers(name);
            !numbers.is_empty()
                && numbers.len() == self.height()
                && numbers.iter().all(|v| v.fract() == 0.0 && *v >= 0.0)
        };
        let mut found = self.foreign().filter(is_count);
        found.next().filter(|_| found.next().is_none())
    }

    /// `true` if a column of another heading may be the one that is missing: numbers for a
    /// quantity, and a heading with the letter of the coordinate; a direction is +1 or -1. Whole
    /// numbers count; they are programmed, but hardly measured.
    fn may_be(&self, name: &str, heading: &str) -> bool {
        let numbers = self.plain_numbers(heading);
        if name == DIRECTION {
            return !numbers.is_empty() && numbers.iter().all(|v| v.abs() == 1.0);
        }
        let Some((stem, _)) = name.rsplit_once('_').filter(|_| is_native_column(name)) else { return true };
        let letter = stem.rsplit('_').next().filter(|last| ["x", "y", "z", "a", "b", "c"].contains(last));
        // columns beside texts are texts as well
        let is_number = match self.values(heading) {
            Some(Values::Texts(texts)) => {
                texts.iter().flatten().filter(|text| !text.trim().is_empty()).count() == numbers.len()
            }
            values => values.is_some(),
        };
        let counts = !numbers.is_empty() && numbers.iter().all(|v| v.fract() == 0.0);
        is_number
            && !(counts && stem == "measured")
            && letter.is_none_or(|letter| heading.to_lowercase().contains(letter))
    }
}

/// Hint that gives the headings of several columns.
pub fn state_columns(headings: &[(&str, &str)]) -> Phrase {
    let pair = |(column, heading): &(&str, &str)| {
        let column = unit_of_heading(heading).map_or((*column).to_owned(), |unit| in_unit(column, unit));
        format!("{column} = \"{heading}\"")
    };
    phrase!("state-columns-together", columns = headings.iter().map(pair).collect::<Vec<_>>())
}

/// Unit in a heading, as names of columns have it: `m` of `X [m]`.
fn unit_of_heading(heading: &str) -> Option<&'static str> {
    let mut words = heading.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let last = words.next_back().filter(|_| words.next().is_some())?;
    let unit = etalon_tables::unit_word(last)?;
    ["mm", "m", "um", "inch", "deg", "rad"].into_iter().find(|known| *known == unit)
}

/// Name of a column in another unit of the same quantity; in its own unit otherwise.
fn in_unit(name: &str, unit: &str) -> String {
    let is_angle = |unit: &str| ["deg", "rad"].contains(&unit);
    match name.rsplit_once('_') {
        Some((stem, own)) if is_angle(own) == is_angle(unit) && is_native_column(name) => format!("{stem}_{unit}"),
        _ => name.to_owned(),
    }
}

/// Maximum number of headings in the hint about a missing column.
const SHOWN: usize = 12;

/// Columns without a unit that a row may have, in addition to [`TEXTS`] and an orientation.
pub const OF_ROWS: [&str; 9] = ["pose", "cycle", LABEL, TIME, ASSEMBLY, "approach", "robot", "reading", "direction"];

/// `true` if a heading without its unit ends in the letter of a coordinate: `X`, `pos_x`, `Y [mm]`
/// for `x_mm` and `y_mm`.
fn names_coordinate(heading: &str, name: &str) -> bool {
    let Some((letter, _)) = name.rsplit_once('_') else { return false };
    let heading = heading.to_lowercase();
    let mut words = heading.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let is_unit = |word: &&str| ["mm", "m", "cm", "um", "inch", "in", "deg", "rad"].contains(word);
    words.rfind(|word| !is_unit(word)) == Some(letter)
}

/// Digits of a heading.
fn digits(heading: &str) -> String {
    heading.chars().filter(char::is_ascii_digit).collect()
}

/// `true` if tables of etalon have a column of this name; columns of other programs have other
/// names.
pub fn is_native_column(name: &str) -> bool {
    let unit = ["_mm", "_m", "_um", "_inch", "_deg", "_rad", "_ms", "_ns", "_mm2", "_direction"];
    [&OF_ROWS[..], &["force_n"], &TEXTS, &QUATERNION, &MATRIX].iter().any(|names| names.contains(&name))
        || unit.iter().any(|unit| name.ends_with(unit))
        // `flange_qw`
        || name.rsplit_once('_').is_some_and(|(_, part)| QUATERNION.contains(&part) || MATRIX.contains(&part))
}

/// Cell of a table as CSV.
#[derive(Serialize)]
#[serde(untagged)]
enum Cell {
    Text(String),
    Whole(i64),
    Real(f64),
    Missing(()),
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(texts: &[&str]) -> Values {
        Values::Texts(texts.iter().map(|text| Some((*text).to_owned())).collect())
    }

    #[test]
    fn hostile_texts_stay_in_their_cells() {
        let long = "n".repeat(200);
        let names = [
            "<script>alert(1)</script>",
            "=HYPERLINK(\"http://x.invalid\",\"y\")",
            "a,b;c\td\"e",
            "two\nlines\r\nand a\rthird",
            "\u{202e}\u{5e8}\u{5d5}\u{5d1}\u{5d5}\u{5d8}",
            &long,
            "",
        ];
        let mut table = Table::default();
        table.set("pose", Values::Whole((0..7).map(Some).collect()));
        table.set("target", texts(&names));
        let written = table.to_csv().unwrap();
        let mut reader = ::csv::Reader::from_reader(&written[..]);
        let read: Vec<(i64, String)> = reader.deserialize().map(|row| row.unwrap()).collect();
        let shown = names.map(|text| if text.starts_with('=') { format!("'{text}") } else { text.to_owned() });
        assert_eq!(read, (0..).zip(shown).collect::<Vec<_>>());
    }

    /// The heading of another program with the number of the joint is meant; columns of etalon have
    /// other meanings.
    #[test]
    fn a_missing_joint_is_looked_for_among_foreign_headings() {
        let mut table = Table::default();
        for name in ["J1", "J2", "q6_deg", "x_mm", "target"] {
            table.set(name, Values::Numbers(vec![Some(1.0)]));
        }
        let hint = |name: &str| table.missing(name, None).hint.unwrap();
        assert_eq!(hint("q2_deg"), phrase!("state-column", column = "q2_deg", heading = "J2").to_string());
        let one_of_both = phrase!("state-column-of", column = "q3_deg", names = ["J1", "J2"]);
        assert_eq!(hint("q3_deg"), one_of_both.to_string());
    }

    /// A coordinate is looked for by its letter alone: other letters and numbers are other columns.
    #[test]
    fn a_missing_coordinate_is_looked_for_by_its_letter() {
        let mut table = Table::default();
        for name in ["J1", "Pos X [mm]", "Y", "index", "target"] {
            table.set(name, Values::Numbers(vec![Some(1.0)]));
        }
        let hint = |table: &Table, name: &str| table.missing(name, None).hint.unwrap();
        assert_eq!(hint(&table, "x_mm"), phrase!("state-column", column = "x_mm", heading = "Pos X [mm]").to_string());
        assert_eq!(hint(&table, "y_mm"), phrase!("state-column", column = "y_mm", heading = "Y").to_string());
        assert!(hint(&table, "z_mm") != phrase!("state-column", column = "z_mm", heading = "index").to_string());
        // the unit of a heading, or of the values
        table.set("Z (m)", Values::Numbers(vec![Some(0.5)]));
        assert_eq!(hint(&table, "z_mm"), phrase!("state-column", column = "z_m", heading = "Z (m)").to_string());
        let of_values = table.missing("y_mm", Some("m")).hint.unwrap();
        let expected = phrase!("state-column-in-unit", column = "y_m", heading = "Y", unit = "m");
        assert_eq!(of_values, expected.to_string());
    }

    /// Repeats are counts, directions are signs, and measured values are no counts.
    #[test]
    fn a_heading_is_proposed_if_its_values_suit_the_column() {
        let mut table = Table::default();
        table.set("run", texts(&["1", "2", "1"]));
        table.set("sign", texts(&["1", "-1", "+1"]));
        let hint = |table: &Table, name: &str| table.missing(name, None).hint.unwrap();
        let expected = phrase!("state-column", column = "direction", heading = "sign").to_string();
        assert_eq!(hint(&table, "direction"), expected);
        assert_eq!(hint(&table, "cycle"), phrase!("state-column-or-cycle", heading = "run").to_string());
        let none = phrase!("state-column-of", column = "measured_mm", names = ["run"]).to_string();
        let mut counts = Table::default();
        counts.set("run", texts(&["1", "2", "1"]));
        assert_eq!(hint(&counts, "measured_mm"), none);
        table.set("Pose", texts(&["1", "2", "1"]));
        assert_eq!(hint(&table, "pose"), phrase!("state-column-or-pose", heading = "Pose").to_string());
    }

    #[test]
    fn rows_of_several_files_keep_their_files_and_lines() {
        let part = |file: &str, column: &str, values: Values| {
            let mut table = Table::from_file(file, [3, 5].into_iter());
            table.set("cycle", Values::Whole(vec![Some(1), None]));
            table.set(column, values);
            table
        };
        let first = part("a.csv", "x_mm", Values::Numbers(vec![Some(1.5), None]));
        let all = first.followed_by(part("b.csv", "target", texts(&["A", "B"])));
        let places: Vec<_> = (0..4).map(|row| (all.place(row).file, all.line(row))).collect();
        let expected = [("a.csv", 3), ("a.csv", 5), ("b.csv", 3), ("b.csv", 5)];
        assert_eq!(places, expected.map(|(file, line)| (file.to_owned(), Some(line))));
        assert_eq!(all.header_above(3), Place { line: Some(1), ..Place::file("b.csv") });
        assert_eq!(all.values("target"), Some(&Values::Texts(vec![None, None, Some("A".into()), Some("B".into())])));
        // rows that are omitted take their places along
        let kept = all.rows(|row| row != 1);
        assert_eq!((kept.height(), kept.place(1).file.as_str(), kept.line(1)), (3, "b.csv", Some(3)));
        let written = String::from_utf8(all.with_lines().to_csv().unwrap()).unwrap();
        assert_eq!(written, "line,cycle,x_mm,target\n3,1,1.5,\n5,,,\n1000000003,1,,A\n1000000005,,,B\n");
    }

    #[test]
    fn whole_numbers_are_read_from_any_column_and_fractions_are_errors() {
        let mut table = Table::default();
        for (values, read) in [
            (Values::Numbers(vec![Some(2.0), Some(-3.0)]), Ok(vec![2, -3])),
            (texts(&["2", "-3"]), Ok(vec![2, -3])),
            (Values::Numbers(vec![Some(2.5)]), Err("not-whole-number")),
            (Values::Numbers(vec![Some(f64::INFINITY)]), Err("not-whole-number")),
            (texts(&["two"]), Err("not-whole-number")),
            (Values::Whole(vec![Some(2), None]), Err("cell-empty")),
        ] {
            table.set("cycle", values);
            assert_eq!(table.integers("cycle").map_err(|e| e.0[0].id.to_string()), read.map_err(str::to_owned));
        }
    }
}
