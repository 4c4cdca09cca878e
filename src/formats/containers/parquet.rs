//! Tables as Parquet (polars).

use crate::table::{Table, Values, failed};
use etalon_base::fork::threads_are_lost;
use etalon_base::message::{Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use polars::prelude::*;
use polars_async::executor::ALLOW_RAYON_THREADS;
use polars_io::parquet::write::{BatchedWriter, ParquetCompression};
use std::io::{Cursor, Write};
use std::panic::resume_unwind;
use std::thread;

/// Builds a frame of `height` rows.
pub fn frame(height: usize, columns: Vec<Column>) -> Result<DataFrame> {
    DataFrame::new(height, columns).map_err(failed)
}

/// Builds a column of names of poses, as whole numbers or as texts.
pub fn pose_column(name: &str, poses: &[Option<PoseName>], are_numbers: bool) -> Column {
    match are_numbers {
        true => Column::new(name.into(), poses.iter().map(|pose| (*pose)?.number()).collect::<Vec<_>>()),
        false => {
            Column::new(name.into(), poses.iter().map(|pose| Some(pose.as_ref()?.to_string())).collect::<Vec<_>>())
        }
    }
}

/// Builds a column; names of poses are whole numbers, or texts if one of them is a text.
fn column(name: &str, values: Values) -> Column {
    match values {
        Values::Numbers(all) => Column::new(name.into(), all),
        Values::Whole(all) => Column::new(name.into(), all),
        Values::Texts(all) => Column::new(name.into(), all),
        Values::Poses(all) => {
            let are_numbers = all.iter().flatten().all(|pose| pose.number().is_some());
            pose_column(name, &all, are_numbers)
        }
    }
}

/// Runs work of polars. Its pool of threads cannot be made again in a forked process: there the
/// work has one thread of its own.
fn on_threads<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    if !threads_are_lost() {
        return work();
    }
    let alone = || {
        ALLOW_RAYON_THREADS.set(false);
        work()
    };
    thread::scope(|scope| scope.spawn(alone).join().unwrap_or_else(|panic| resume_unwind(panic)))
}

/// Returns a writer on one thread. For small tables, waking threads and setting up zstd would take
/// longer than writing.
fn writer<W: Write>(into: W) -> ParquetWriter<W> {
    ParquetWriter::new(into).with_compression(ParquetCompression::Snappy).set_parallel(false)
}

/// Number of rows above which a table is written in row groups and in parallel.
const LARGE: usize = 100_000;

/// Returns the table as Parquet.
pub fn to_parquet(table: Table) -> Result<Vec<u8>> {
    let height = table.height();
    let columns = table.into_columns().into_iter().map(|(name, values)| column(&name, values));
    let mut table = frame(height, columns.collect())?;
    let mut bytes = Vec::new();
    if height > LARGE {
        on_threads(|| writer(&mut bytes).set_parallel(true).finish(&mut table)).map_err(failed)?;
        return Ok(bytes);
    }
    // the same bytes; cutting into row groups fills 8 MB of zeros first
    let mut groups = RowGroups::new(&mut bytes, &table)?;
    groups.add(&table)?;
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
            on_threads(|| self.0.write_batch(rows)).map_err(failed)?;
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
pub fn from_parquet(bytes: Vec<u8>, rows: usize) -> Result<Table> {
    let unreadable = |e: PolarsError| Problems::from(error!("stored-table-damaged", reason = e.to_string()));
    on_threads(|| {
        let mut reader = ParquetReader::new(Cursor::new(bytes));
        let found = reader.num_rows().map_err(unreadable)?;
        if found != rows {
            return Err(error!("stored-table-damaged", reason = phrase!("stored-row-count", found, rows)).into());
        }
        table(&reader.finish().map_err(unreadable)?)
    })
}

/// Returns the rows of a frame, whose columns are texts or numbers.
pub fn table(frame: &DataFrame) -> Result<Table> {
    let mut table = Table::default();
    for column in frame.columns() {
        let values = match column.dtype() {
            DataType::String => {
                let texts = column.str().map_err(failed)?.iter();
                Values::Texts(texts.map(|text| text.map(str::to_owned)).collect())
            }
            dtype if dtype.is_integer() => {
                let whole = column.cast(&DataType::Int64).map_err(failed)?;
                Values::Whole(whole.i64().map_err(failed)?.iter().collect())
            }
            _ => {
                let numbers = column.cast(&DataType::Float64).map_err(failed)?;
                Values::Numbers(numbers.f64().map_err(failed)?.iter().collect())
            }
        };
        table.set(column.name().as_str(), values);
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_reads_back_as_it_was_written() {
        let texts = |texts: [Option<&str>; 3]| Values::Texts(texts.map(|text| text.map(str::to_owned)).to_vec());
        let pose = |name: &str| PoseName::new(name).ok();
        let mut table = Table::default();
        // an empty text is not a missing one, and NaN is a number
        table.set("kind", texts([Some("point"), Some(""), None]));
        table.set("cycle", Values::Whole(vec![Some(1), None, Some(-3)]));
        table.set("x_mm", Values::Numbers(vec![Some(0.1), Some(f64::NAN), None]));
        let mut expected = table.clone();
        table.set("numbered", Values::Poses(vec![pose("7"), None, pose("08")]));
        table.set("named", Values::Poses(vec![pose("7"), None, pose("home")]));
        expected.set("numbered", Values::Whole(vec![Some(7), None, Some(8)]));
        expected.set("named", texts([Some("7"), None, Some("home")]));
        let bytes = to_parquet(table).unwrap();
        assert!(from_parquet(bytes.clone(), 4).unwrap_err().0[0].is("stored-table-damaged", &[]));
        let read = from_parquet(bytes, 3).unwrap();
        assert_eq!(format!("{read:?}"), format!("{expected:?}"));
    }
}
