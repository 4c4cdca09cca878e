//! Writer of logs with the columns of a campaign.

use super::{JointLog, Log, LogRow, meaning};
use crate::dialect::Column;
use crate::table::{ASSEMBLY, LABEL};
use etalon_base::error;
use etalon_base::message::{Message, Result, SourceText};
use etalon_tables::ColumnSource;
use etalon_tables::lexer::{line, written};

/// Maximum number of columns.
const MOST_COLUMNS: usize = 1000;

/// Content of a column.
enum Content {
    Pose,
    Cycle,
    /// Number of its units in a second, digits behind the decimal mark.
    Time(f64, usize),
    Assembly,
    Label,
    /// Index of the joint, factor from the unit of the column to mm or deg, digits.
    Joint(usize, f64, usize),
    /// Index of the joint, factor from the unit of the column to mm or deg, value of a count,
    /// count at zero.
    Counts(usize, f64, f64, f64),
}

/// Returns the text of a log with these rows.
pub fn write(stated: SourceText, log: &Log, values: &JointLog) -> Result<String> {
    let places = places(log).map_err(|m| m.at(stated.place(&log.file)))?;
    let width = places.iter().map(|p| p.2 + 1).max().unwrap_or(0);
    let mut header: Vec<String> = (1..=width).map(|n| format!("column_{n}")).collect();
    let mut contents: Vec<Option<Content>> = (0..width).map(|_| None).collect();
    for (key, column, at, name) in places {
        contents[at] = Some(content(values, key.get_ref(), column).map_err(|m| m.at(stated.place(key)))?);
        if let Some(name) = name {
            header[at].clone_from(name);
        }
    }
    let line = |fields: &[String]| line(fields, log.read_form().delimiter(), None);
    let mut all = if log.has_header() { line(&header)? } else { String::new() };
    for row in &values.rows {
        let fields: Vec<String> = contents.iter().map(|content| field(log, content.as_ref(), row)).collect();
        all += &line(&fields)?;
    }
    Ok(all)
}

type Placed<'a> = (&'a toml::Spanned<String>, &'a Column, usize, Option<&'a String>);

/// Returns index and name of each column: numbered columns have their place, named columns fill the
/// gaps in order.
fn places(log: &Log) -> std::result::Result<Vec<Placed<'_>>, Message> {
    let number = |column: &Column| if let ColumnSource::Number(n) = column.at { Some(n - 1) } else { None };
    let taken: Vec<usize> = log.columns.values().filter_map(number).collect();
    let mut free = (0..).filter(|i| !taken.contains(i));
    let mut places: Vec<Placed> = Vec::new();
    let mut columns: Vec<_> = log.columns.iter().collect();
    if log.format.0.is_sorted() {
        columns
            .sort_by_key(|(_, column)| if let ColumnSource::Heading(name) = &column.at { name.as_str() } else { "" });
    }
    for (key, column) in columns {
        let (at, name) = match &column.at {
            ColumnSource::Number(n) => (n - 1, None),
            ColumnSource::Heading(name) => (free.next().unwrap_or(0), Some(name)),
        };
        let twice = places.iter().any(|p| p.2 == at || name.is_some() && p.3 == name);
        if twice || at >= MOST_COLUMNS {
            return Err(error!("simulated-column-clash", key = key.get_ref(), most = MOST_COLUMNS));
        }
        places.push((key, column, at, name));
    }
    Ok(places)
}

/// Returns the content of the column of a key.
fn content(values: &JointLog, key: &str, column: &Column) -> std::result::Result<Content, Message> {
    let unknown = || error!("simulated-column-unknown", key);
    match key {
        "pose" => return Ok(Content::Pose),
        "cycle" => return Ok(Content::Cycle),
        "time_s" => return Ok(Content::Time(1.0, 6)),
        "time_ms" => return Ok(Content::Time(1e3, 0)),
        "time_us" => return Ok(Content::Time(1e6, 0)),
        "time_ns" => return Ok(Content::Time(1e9, 0)),
        LABEL => return Ok(Content::Label),
        ASSEMBLY if values.has(ASSEMBLY) => return Ok(Content::Assembly),
        _ => {}
    }
    let (name, factor) = meaning(key).ok_or_else(unknown)?;
    let joint = values.joints.iter().position(|joint| *joint == name).ok_or_else(unknown)?;
    if let Some(per_count) = column.per_count {
        return Ok(Content::Counts(joint, factor, per_count, column.zero_count.unwrap_or(0.0)));
    }
    // resolution 1e-6 mm or deg; finer for radians, where round angles have no end
    let digits = if key.ends_with("_rad") { 14 } else { (6.0 + factor.log10()).round().max(0.0) as usize };
    Ok(Content::Joint(joint, factor, digits))
}

fn field(log: &Log, content: Option<&Content>, row: &LogRow) -> String {
    let number = |value: f64, digits: usize| written(value, digits, log.form.decimal());
    match content {
        None => "-".to_owned(),
        Some(Content::Pose) => row.pose.unwrap_or_default().to_string(),
        Some(Content::Cycle) => row.cycle.unwrap_or_default().to_string(),
        Some(Content::Time(in_a_second, digits)) => number(row.time_s.unwrap_or_default() * in_a_second, *digits),
        Some(Content::Assembly) => number(row.assembly.unwrap_or(1.0), 0),
        Some(Content::Label) => row.label.clone().unwrap_or_else(|| "-".to_owned()),
        Some(Content::Joint(joint, factor, digits)) => number(row.joints[*joint] / factor, *digits),
        Some(Content::Counts(joint, factor, per_count, zero)) => {
            number((row.joints[*joint] / factor / per_count + zero).round(), 0)
        }
    }
}
