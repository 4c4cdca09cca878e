//! Tables of points, joints and observations (polars), and the names of their columns.

use etalon_base::cell::cell;
use etalon_base::message::{Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use polars::prelude::*;
use polars_io::parquet::write::{BatchedWriter, ParquetCompression};
use serde::Serialize;
use std::io::{Cursor, Write};

/// Columns of the coordinates (mm).
pub const XYZ: [&str; 3] = ["x_mm", "y_mm", "z_mm"];

/// Columns of the standard uncertainties of the coordinates.
pub const UNCERTAINTIES: [&str; 3] = ["ux_mm", "uy_mm", "uz_mm"];

/// Columns of the covariance of the coordinates (mm²): upper triangle, row by row.
pub const COVARIANCES: [&str; 6] = ["cxx_mm2", "cxy_mm2", "cxz_mm2", "cyy_mm2", "cyz_mm2", "czz_mm2"];

/// Columns of the angles (deg): rotations about the axes of the stated rotation order.
pub const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];

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

/// Returns the error that a table cannot be built.
pub fn failed(error: impl std::fmt::Display) -> Problems {
    error!("table-failed", reason = error.to_string()).into()
}

/// Builds a table of `height` rows.
pub fn frame(height: usize, columns: Vec<Column>) -> Result<DataFrame> {
    DataFrame::new(height, columns).map_err(failed)
}

/// Returns a column as numbers; missing values are NaN.
pub fn numbers(table: &DataFrame, name: &str) -> Result<Vec<f64>> {
    let column = column(table, name)?.cast(&DataType::Float64).map_err(failed)?;
    Ok(column.f64().map_err(failed)?.iter().map(|v| v.unwrap_or(f64::NAN)).collect())
}

/// Returns a column of whole numbers without gaps.
pub fn integers(table: &DataFrame, name: &str) -> Result<Vec<i64>> {
    let wrong = |value: String| error!("not-whole-number", value, column = name);
    let column = column(table, name)?;
    // a cast would cut 1.5 and 1e300
    let cut = |v: &f64| v.is_finite() && v.fract() != 0.0 || v.abs() > 9e15;
    if column.dtype().is_float()
        && let Some(value) = numbers(table, name)?.into_iter().find(cut)
    {
        return Err(wrong(value.to_string()).into());
    }
    let Ok(column) = column.strict_cast(&DataType::Int64) else {
        let other = texts(table, name)?.into_iter().find(|text| text.parse::<i64>().is_err());
        return Err(wrong(other.unwrap_or_default()).into());
    };
    let whole = |v: Option<i64>| v.ok_or_else(|| error!("cell-empty", column = name).into());
    column.i64().map_err(failed)?.iter().map(whole).collect()
}

/// Offset of the line numbers of each further file of a table.
pub const FILE_LINES: usize = 1_000_000_000;

/// Returns the line of a row in its file; `None` if the table does not state it.
pub fn lines(table: &DataFrame) -> Result<impl Fn(usize) -> Option<usize> + use<>> {
    let lines = if table.column("line").is_ok() { integers(table, "line")? } else { Vec::new() };
    Ok(move |row| lines.get(row).map(|line| *line as usize))
}

/// Returns the names of poses in the column `pose`, without gaps.
pub fn poses(table: &DataFrame) -> Result<Vec<PoseName>> {
    if !column(table, "pose")?.dtype().is_string() {
        return Ok(integers(table, "pose")?.into_iter().map(PoseName::from).collect());
    }
    let name = |name: String| PoseName::new(&name).map_err(Problems::from);
    texts(table, "pose")?.into_iter().map(name).collect()
}

/// Builds a column of names of poses: whole numbers, or texts if one of them is a text.
pub fn pose_column(name: &str, poses: &[Option<PoseName>]) -> Column {
    pose_column_as(name, poses, !poses.iter().flatten().any(|pose| pose.number().is_none()))
}

/// Builds a column of names of poses, as whole numbers or as texts.
pub fn pose_column_as(name: &str, poses: &[Option<PoseName>], numbers: bool) -> Column {
    match numbers {
        true => Column::new(name.into(), poses.iter().map(|pose| (*pose)?.number()).collect::<Vec<_>>()),
        false => {
            Column::new(name.into(), poses.iter().map(|pose| Some(pose.as_ref()?.to_string())).collect::<Vec<_>>())
        }
    }
}

/// Returns a column of whole numbers; `None` for missing values.
pub fn optional_integers(table: &DataFrame, name: &str) -> Result<Vec<Option<i64>>> {
    let column = column(table, name)?.cast(&DataType::Int64).map_err(failed)?;
    Ok(column.i64().map_err(failed)?.iter().collect())
}

/// Returns a column as text; missing values are empty.
pub fn texts(table: &DataFrame, name: &str) -> Result<Vec<String>> {
    let column = column(table, name)?.cast(&DataType::String).map_err(failed)?;
    Ok(column.str().map_err(failed)?.iter().map(|v| v.unwrap_or_default().to_owned()).collect())
}

/// Appends the rows of a second table; cells of columns that a table lacks are missing.
pub fn stacked(above: &DataFrame, below: &DataFrame) -> Result<DataFrame> {
    let mut names: Vec<&str> = Vec::new();
    for name in above.get_column_names().into_iter().chain(below.get_column_names()) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let both = [above, below];
    let column = |name: &&str| -> Result<Column> {
        let parts: Vec<Option<&Column>> = both.iter().map(|table| table.column(name).ok()).collect();
        if *name == "pose" {
            let of = |table: &DataFrame| -> Result<Vec<Option<PoseName>>> {
                if table.column("pose").is_err() {
                    return Ok(vec![None; table.height()]);
                }
                let named = |text: String| if text.is_empty() { Ok(None) } else { PoseName::new(&text).map(Some) };
                Ok(texts(table, "pose")?.into_iter().map(named).collect::<std::result::Result<_, _>>()?)
            };
            return Ok(pose_column("pose", &[of(above)?, of(below)?].concat()));
        }
        let text = parts.iter().flatten().any(|column| column.dtype().is_string());
        let whole = parts.iter().flatten().all(|column| column.dtype().is_integer());
        let dtype = if text {
            DataType::String
        } else if whole {
            DataType::Int64
        } else {
            DataType::Float64
        };
        let mut all: Option<Column> = None;
        for (part, table) in parts.into_iter().zip(both) {
            let part = match part {
                Some(part) => part.cast(&dtype).map_err(failed)?,
                None => Column::full_null((*name).into(), table.height(), &dtype),
            };
            match &mut all {
                Some(all) => drop(all.append(&part).map_err(failed)?),
                None => all = Some(part),
            }
        }
        all.ok_or_else(|| failed("no column"))
    };
    let columns = names.iter().map(column).collect::<Result<Vec<Column>>>()?;
    frame(above.height() + below.height(), columns)
}

/// Returns the coordinates (mm); without `z_mm`, or if the column is empty, z = 0.
pub fn coordinates(table: &DataFrame) -> Result<Vec<Vector>> {
    let (x, y) = (numbers(table, XYZ[0])?, numbers(table, XYZ[1])?);
    let mut z = if table.column(XYZ[2]).is_ok() { numbers(table, XYZ[2])? } else { vec![0.0; x.len()] };
    if z.iter().all(|z| z.is_nan()) {
        z.fill(0.0);
    }
    Ok(x.into_iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z]).collect())
}

/// Checks that the table has these columns.
///
/// # Errors
/// Reports each missing column, at line 1 of the file.
pub fn require(table: &DataFrame, names: &[String]) -> Result<()> {
    let header = Place { line: Some(1), ..Place::default() };
    let missing = names.iter().filter_map(|name| column(table, name).err());
    Problems(missing.flat_map(|problems| problems.at(&header).0).collect()).check().map(|_| ())
}

fn column<'a>(table: &'a DataFrame, name: &str) -> Result<&'a Column> {
    table.column(name).map_err(|_| {
        // the program adds these columns
        let added = |name: &&str| ["line", "cycle"].contains(name);
        let names = table.get_column_names().into_iter().map(PlSmallStr::as_str).filter(|name| !added(name));
        let names: Vec<&str> = names.collect();
        let foreign: Vec<&str> = names.iter().copied().filter(|name| !is_native_column(name)).collect();
        let message = error!("column-unknown", column = name);
        // a pose or a label is not the column that is missing
        let others: Vec<&str> = names.iter().copied().filter(|name| !OF_ROWS.contains(name)).collect();
        let names = if others.is_empty() { names } else { others };
        // a column of the same quantity in another unit is not the column that is missing
        let stem = |name: &'_ str| name.rsplit_once('_').map(|(stem, _)| stem.to_owned());
        let heading = foreign.first().filter(|_| foreign.len() == 1).copied().unwrap_or("HEADING");
        match foreign[..] {
            _ if name == "target" => message.hint(phrase!("state-column-or-target", heading)).into(),
            _ if name == "pose" => message.hint(phrase!("state-column-or-pose", heading)).into(),
            [heading]
                if !heading.contains('"')
                    && stem(heading).is_none_or(|s| stem(name) != Some(s))
                    && may_be(table, name, heading) =>
            {
                message.hint(phrase!("state-column", column = name, heading)).into()
            }
            _ => message.hint_names(name, names).into(),
        }
    })
}

/// `true` if a column of another heading may be the one that is missing: numbers for a quantity,
/// and a heading with the letter of the coordinate.
fn may_be(table: &DataFrame, name: &str, heading: &str) -> bool {
    let Some((stem, _)) = name.rsplit_once('_').filter(|_| is_native_column(name)) else { return true };
    let letter = stem.rsplit('_').next().filter(|last| ["x", "y", "z"].contains(last));
    // columns beside texts are texts as well
    let holds_numbers = |texts: &StringChunked| {
        let mut all = texts.iter().flatten().map(|text| text.trim().replace(',', "."));
        all.all(|text| text.is_empty() || text.parse::<f64>().is_ok())
    };
    let is_number = table.column(heading).is_ok_and(|column| column.str().map_or(true, holds_numbers));
    is_number && letter.is_none_or(|letter| heading.to_lowercase().contains(letter))
}

/// Columns without a unit that a row may have, beside [`TEXTS`] and those of an orientation.
pub const OF_ROWS: [&str; 9] = ["pose", "cycle", LABEL, TIME, ASSEMBLY, "approach", "robot", "reading", "direction"];

/// `true` if tables of etalon have a column of this name; columns of other programs have other
/// names.
fn is_native_column(name: &str) -> bool {
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

impl From<AnyValue<'_>> for Cell {
    fn from(value: AnyValue) -> Self {
        match value {
            AnyValue::Null => Self::Missing(()),
            AnyValue::Int64(number) => Self::Whole(number),
            AnyValue::Float64(number) => Self::Real(number),
            AnyValue::String(text) => Self::Text(cell(text)),
            other => Self::Text(cell(&other.to_string())),
        }
    }
}

/// Returns the table as CSV; missing values are empty, formulas are escaped.
pub fn to_csv(table: &DataFrame) -> Result<Vec<u8>> {
    let mut writer = ::csv::Writer::from_writer(Vec::new());
    writer.write_record(table.get_column_names().iter().map(|name| cell(name.as_str()))).map_err(failed)?;
    for row in 0..table.height() {
        let cells = table.columns().iter().map(|column| column.get(row).map(Cell::from).map_err(failed));
        writer.serialize(cells.collect::<Result<Vec<Cell>>>()?).map_err(failed)?;
    }
    writer.into_inner().map_err(failed)
}

/// Returns a writer on one thread. For small tables, waking threads and setting up zstd would take
/// longer than writing.
fn writer<W: Write>(into: W) -> ParquetWriter<W> {
    ParquetWriter::new(into).with_compression(ParquetCompression::Snappy).set_parallel(false)
}

/// Number of rows above which a table is written in row groups and in parallel.
const LARGE: usize = 100_000;

/// Returns the table as Parquet.
pub fn to_parquet(table: &mut DataFrame) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    if table.height() > LARGE {
        writer(&mut bytes).set_parallel(true).finish(table).map_err(failed)?;
        return Ok(bytes);
    }
    // the same bytes; cutting into row groups fills 8 MB of zeros first
    table.rechunk_mut();
    let mut groups = RowGroups::new(&mut bytes, table)?;
    groups.add(table)?;
    groups.finish()?;
    Ok(bytes)
}

/// Writer of a Parquet table piece by piece, whose memory does not grow with the table.
pub struct RowGroups<W: Write + Send>(BatchedWriter<W>);

impl<W: Write + Send> RowGroups<W> {
    /// Starts a table with the columns of `like`.
    pub fn new(into: W, like: &DataFrame) -> Result<Self> {
        writer(into).batched(like.schema()).map(Self).map_err(failed)
    }

    /// Adds the rows of a table.
    pub fn add(&mut self, rows: &DataFrame) -> Result<()> {
        if rows.height() > 0 {
            self.0.write_batch(rows).map_err(failed)?;
        }
        Ok(())
    }

    /// Ends the file.
    pub fn finish(self) -> Result<()> {
        self.0.finish().map(drop).map_err(failed)
    }
}

/// Reads a Parquet file that a stage wrote.
///
/// # Errors
/// Fails if the number of rows differs; it is checked before any row is read.
pub fn from_parquet(bytes: Vec<u8>, rows: usize) -> Result<DataFrame> {
    let unreadable = |e: PolarsError| Problems::from(error!("stored-table-damaged", reason = e.to_string()));
    let mut reader = ParquetReader::new(Cursor::new(bytes));
    let found = reader.num_rows().map_err(unreadable)?;
    if found != rows {
        return Err(error!("stored-table-damaged", reason = phrase!("stored-row-count", found, rows)).into());
    }
    reader.finish().map_err(unreadable)
}

#[cfg(test)]
mod tests {
    use super::*;
    use polars::prelude::{IntoColumn, NamedFrom, Series};

    #[test]
    fn hostile_texts_stay_in_their_cells() {
        let texts = [
            "<script>alert(1)</script>".to_owned(),
            "=HYPERLINK(\"http://x.invalid\",\"y\")".to_owned(),
            "a,b;c\td\"e".to_owned(),
            "two\nlines\r\nand a\rthird".to_owned(),
            "\u{202e}\u{5e8}\u{5d5}\u{5d1}\u{5d5}\u{5d8}".to_owned(),
            "n".repeat(200),
            String::new(),
        ];
        let numbers = Series::new("pose".into(), (0..7i64).collect::<Vec<_>>()).into_column();
        let table = DataFrame::new(7, vec![numbers, Series::new("target".into(), &texts[..]).into_column()]).unwrap();
        let written = to_csv(&table).unwrap();
        let mut reader = ::csv::Reader::from_reader(&written[..]);
        let read: Vec<(i64, String)> = reader.deserialize().map(|row| row.unwrap()).collect();
        let shown = texts.map(|text| if text.starts_with('=') { format!("'{text}") } else { text });
        assert_eq!(read, (0..).zip(shown).collect::<Vec<_>>());
    }
}
