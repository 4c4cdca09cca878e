//! Beckhoff TwinCAT 3 Scope exports: each channel has its own times (ms since the start of the
//! export).
//!
//! Unsorted exports have a column of times for each channel, sorted exports for each group of
//! channels with equal times. A row of the log is a time at which all wanted channels have a value;
//! nothing is interpolated.

use super::sheet::select_occurrence;
use super::{About, ChannelValues, Columns, Log, LogFormat, LogText, Values, Wanted, inapplicable, other_unit};
use crate::exports::Recognised;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::{error, phrase, warning};
use etalon_documents::Source;
use etalon_tables::lexer::{Row, number};
use etalon_tables::sheet::field_count;
use etalon_tables::{ColumnSource, Decimal, Delimiter, two_commas};

/// Exports of Beckhoff TwinCAT 3 Scope: a time base for each channel.
pub(super) struct TwinCat;

impl LogFormat for TwinCat {
    fn about(&self) -> About {
        About {
            name: "twincat",
            title: "TwinCAT Scope",
            description: "Beckhoff TwinCAT 3 Scope CSV: a time base for each channel.",
        }
    }

    fn recognise(&self, header: &[&str], text: &str) -> Option<Recognised> {
        let start = text.lines().take(10).any(|line| line.trim_start_matches('"').starts_with("Starttime of export"));
        let what = phrase!("is-twincat");
        Recognised::by(start && header.iter().any(|field| field.starts_with("Name")), 1.0, what)
    }

    fn has_channels(&self) -> bool {
        true
    }

    fn read(&self, log: LogText, wanted: &[Wanted], source: &mut Source) -> Result<Columns> {
        read(log, wanted, source)
    }
}

/// Samples of a channel.
#[derive(Default)]
struct Samples {
    times_ms: Vec<f64>,
    values: Vec<f64>,
    lines: Vec<i64>,
    /// `true` after the last sample.
    ended: bool,
}

/// Reads the wanted channels.
fn read(LogText { log, stated, text }: LogText, wanted: &[Wanted], source: &mut Source) -> Result<Columns> {
    let file = log.file.get_ref().as_str();
    let lines: Vec<&str> = text.lines().collect();
    let header = Header::read(file, &lines, log)?;
    let delimited = phrase!(
        "log-delimited",
        delimiter = header.separator.escape_default().to_string(),
        decimal = log.form.decimal().name()
    );
    let read = phrase!("log-of-format", format = log.format.about().title, read = delimited);
    source.read_as(match header.start_utc() {
        Some(start) => phrase!("log-with-start", read, start),
        None => read,
    });
    let mut problems = Problems::default();
    if log.period_s.is_some() {
        problems.0.push(inapplicable("period_s").at(stated.place(&log.file)));
    }
    let mut chosen = Vec::new();
    for wanted in wanted {
        match channel(&header, log, wanted) {
            Ok(channel) => chosen.push((channel, wanted)),
            Err(message) => problems.0.push(message.at(stated.place(wanted.key))),
        }
    }
    if chosen.is_empty() && problems.0.is_empty() {
        let message = error!("log-columns-missing").at(stated.place(&log.file));
        problems.0.push(message.hint_names("", header.channels.iter().map(|c| c.name.as_str())));
    }
    problems.check()?;
    let channels: Vec<&Channel> = chosen.iter().map(|(channel, _)| *channel).collect();
    let samples = samples(&header, &channels, log, &lines, source)?;
    together(file, &header, &chosen, log, &samples)
}

/// Returns the channel of a key, after checks of its unit and scale.
fn channel<'a>(header: &'a Header, log: &Log, wanted: &Wanted) -> std::result::Result<&'a Channel, Message> {
    if wanted.name == "time_s" {
        return Err(inapplicable(wanted.key.get_ref()));
    }
    let ColumnSource::Heading(name) = &wanted.column.at else {
        return Err(error!("column-by-number", format = log.format.about().name));
    };
    let named: Vec<&Channel> = header.channels.iter().filter(|c| c.name == *name).collect();
    let Some(channel) = select_occurrence(name, &named, wanted.column.occurrence)? else {
        let names = header.channels.iter().map(|c| c.name.as_str());
        return Err(error!("column-unknown", column = name).hint_names(name, names));
    };
    let known = match channel.unit.as_str() {
        "mm" | "m" | "um" | "deg" | "rad" => channel.unit.as_str(),
        "µm" | "μm" => "um",
        "°" => "deg",
        _ => "",
    };
    let scaled = log.values == Some(ChannelValues::Scaled) || channel.unit_scale == (1.0, 0.0);
    if let (Some(stated), false, true) = (wanted.unit(), known.is_empty(), scaled) {
        other_unit(wanted, name, stated, known).map_or(Ok(()), Err)?;
    }
    scale(channel, log.values)?;
    Ok(channel)
}

/// Returns the factor and offset that are not yet applied.
fn scale(channel: &Channel, values: Option<ChannelValues>) -> std::result::Result<(f64, f64), Message> {
    const NONE: (f64, f64) = (1.0, 0.0);
    match (channel.scale, channel.unit_scale, values) {
        (NONE, NONE, _) | (_, _, Some(ChannelValues::Scaled)) => Ok(NONE),
        (one, NONE, Some(ChannelValues::Raw)) | (NONE, one, Some(ChannelValues::Raw)) => Ok(one),
        (_, _, Some(ChannelValues::Raw)) => Err(error!("twincat-two-scales", channel = &channel.name)),
        ((f, o), (uf, uo), None) => {
            Err(error!("twincat-scale-undecided", channel = &channel.name, scale = [f, o], unit_scale = [uf, uo]))
        }
    }
}

/// Reads the samples of each channel.
fn samples(
    header: &Header,
    channels: &[&Channel],
    log: &Log,
    lines: &[&str],
    source: &mut Source,
) -> Result<Vec<Samples>> {
    let file = log.file.get_ref().as_str();
    let mut problems = Problems::default();
    let mut all: Vec<Samples> = channels.iter().map(|_| Samples::default()).collect();
    for (i, line) in lines.iter().enumerate().skip(header.data) {
        if line.trim().is_empty() || line.trim() == "EOF" {
            continue;
        }
        source.rows_read += 1;
        let row = Row::new(i + 1, line, line.split(header.separator).map(str::trim));
        if row.fields.iter().skip(header.width).any(|f| !f.is_empty()) {
            problems.0.push(field_count(file, &row, header.width, "names"));
            continue;
        }
        for (channel, samples) in channels.iter().zip(&mut all) {
            let (time, value) = (row.field(channel.time), row.field(channel.at));
            if time.is_empty() && value.is_empty() {
                samples.ended = true;
                continue;
            }
            let mut wrong = |message: Message, at: usize| {
                problems.0.push(message.at(row.cell(file, at)));
            };
            if samples.ended {
                wrong(error!("channel-resumes", channel = &channel.name), channel.at);
                continue;
            }
            match (number(time, log.form.decimal()), number(value, log.form.decimal())) {
                (Err(message), _) => wrong(message, channel.time),
                (_, Err(message)) => wrong(message, channel.at),
                (Ok(time), Ok(value)) => match samples.times_ms.last() {
                    Some(last) if *last >= time => {
                        let (later_s, earlier_s) = (time / 1000.0, last / 1000.0);
                        wrong(error!("time-not-increasing", later_s, earlier_s), channel.time);
                    }
                    _ => {
                        samples.times_ms.push(time);
                        samples.values.push(value);
                        samples.lines.push(i as i64 + 1);
                    }
                },
            }
        }
    }
    problems.check().map(|_| all)
}

/// Returns one row for each time at which all channels have a value.
fn together(
    file: &str,
    header: &Header,
    chosen: &[(&Channel, &Wanted)],
    log: &Log,
    samples: &[Samples],
) -> Result<Columns> {
    let Some(first) = samples.iter().min_by_key(|s| s.times_ms.len()) else { return Ok(Columns::default()) };
    let at = |s: &Samples, time: f64| s.times_ms.binary_search_by(|t| t.total_cmp(&time)).ok();
    let shared: Vec<f64> =
        first.times_ms.iter().copied().filter(|&t| samples.iter().all(|s| at(s, t).is_some())).collect();
    let place = || Place { line: Some(header.names), ..Place::file(file) };
    if shared.is_empty() {
        return Err(error!("channels-without-common-time").at(place()).into());
    }
    let mut columns = Columns {
        rows: (1..=shared.len() as i64).collect(),
        lines: shared.iter().filter_map(|&t| at(first, t).map(|i| first.lines[i])).collect(),
        columns: vec![("time_s".to_owned(), Values::Real(shared.iter().map(|t| t / 1000.0).collect()))],
        said: Vec::new(),
    };
    for ((channel, wanted), samples) in chosen.iter().zip(samples) {
        let (factor, offset) = scale(channel, log.values)?;
        let value = |t: &f64| at(samples, *t).map(|i| wanted.value(samples.values[i] * factor + offset));
        columns.columns.push((wanted.name.clone(), Values::Real(shared.iter().filter_map(value).collect())));
        let alone = samples.times_ms.len() - shared.len();
        if alone > 0 {
            columns.said.push(warning!("channel-samples-unused", channel = &channel.name, count = alone).at(place()));
        }
    }
    Ok(columns)
}

/// Seconds from 1601-01-01, the origin of FILETIME, to 1970-01-01.
const FILETIME_TO_UNIX_S: i64 = 11_644_473_600;

/// Head of an export.
struct Header {
    /// Separator of fields.
    separator: char,
    /// Start of the export, FILETIME: 100 ns since 1601-01-01 UTC.
    start: Option<i64>,
    /// Columns of values.
    channels: Vec<Channel>,
    /// Number of fields of a full row.
    width: usize,
    /// Index of the first line with data.
    data: usize,
    /// Line that names the channels, from 1.
    names: usize,
}

/// Column of values.
struct Channel {
    name: String,
    /// Index of its column.
    at: usize,
    /// Index of the column of its times.
    time: usize,
    unit: String,
    /// Factor and offset of the channel: value = raw * factor + offset.
    scale: (f64, f64),
    /// Factor and offset of the unit: value = raw * factor + offset.
    unit_scale: (f64, f64),
}

impl Header {
    /// Reads the head; an ambiguous file is rejected.
    fn read(file: &str, lines: &[&str], log: &Log) -> Result<Self> {
        let shown = |i: usize| Place::line(file, i + 1, lines.get(i).copied().unwrap_or(""));
        let separator = separator(lines, log).map_err(|m| m.at(shown(0)))?;
        let split = |i: usize| lines.get(i).map_or(Vec::new(), |line| line.split(separator).map(str::trim).collect());
        let names = (1..lines.len().min(100)).find(|&i| split(i).first() == Some(&"Name"));
        let Some(first) = names else {
            return Err(error!("twincat-head-malformed", part = "names").at(shown(0)).into());
        };
        let end = (first..lines.len().min(first + 100)).find(|&i| lines[i].trim().is_empty());
        let Some(end) = end else {
            return Err(error!("twincat-head-malformed", part = "end").at(shown(first)).into());
        };
        let head: Vec<Vec<&str>> = (first..end).map(split).collect();
        let width = head[0].len();
        // empty comments end their row early
        let fits = |row: &Vec<&str>| row.len() == width || row.len() < width && row[0] == "SymbolComment";
        let ragged = head.iter().enumerate().filter(|(_, row)| !fits(row)).map(|(i, row)| {
            error!("twincat-head-ragged", row = row[0], fields = row.len(), width).at(shown(first + i))
        });
        Problems(ragged.collect()).check()?;
        let field = |key: &str, at: usize| {
            head.iter().find(|row| row[0] == key).map_or("", |row| row.get(at).copied().unwrap_or(""))
        };
        let mut channels = Vec::new();
        let mut time = None;
        let mut problems = Problems::default();
        for (at, name) in head[0].iter().enumerate() {
            if *name == "Name" {
                time = Some(at);
                continue;
            }
            let mut number = |key: &str, absent: f64| match field(key, at) {
                "" => absent,
                // the head has the decimal mark of the operating system, the data may have another
                text => text.replace(',', ".").parse().unwrap_or_else(|_| {
                    let message = error!("channel-scale-not-number", key, channel = name, value = text);
                    problems.0.push(message.at(shown(first)));
                    absent
                }),
            };
            let scale = (number("ScaleFactor", 1.0), number("Offset", 0.0));
            let unit_scale = (number("Unit ScaleFactor", 1.0), number("Unit Offset", 0.0));
            let unit = field("Unit", at).split(" (").next().unwrap_or("").trim().to_owned();
            // the first field is `Name`
            let time = time.unwrap_or(0);
            channels.push(Channel { name: (*name).to_owned(), at, time, unit, scale, unit_scale });
        }
        problems.check()?;
        let start = (0..first).find(|&i| split(i).first() == Some(&"Starttime of export"));
        let start = start.and_then(|i| split(i).get(1).and_then(|text| text.parse().ok()));
        Ok(Self { separator, start, channels, width, data: end + 1, names: first + 1 })
    }

    /// Returns the start of the export in UTC, to the millisecond.
    fn start_utc(&self) -> Option<String> {
        let ms = self.start?.div_euclid(10_000) - FILETIME_TO_UNIX_S * 1000;
        let (days, in_day) = (ms.div_euclid(86_400_000), ms.rem_euclid(86_400_000));
        let (year, month, day) = civil(days);
        let (hour, minute) = (in_day / 3_600_000, in_day / 60_000 % 60);
        let (second, ms) = (in_day / 1000 % 60, in_day % 1000);
        Some(format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{ms:03}Z"))
    }
}

/// Returns the separator behind the first word of the first line; an ambiguous one is rejected.
fn separator(lines: &[&str], log: &Log) -> std::result::Result<char, Message> {
    let after = lines.first().and_then(|line| line.strip_prefix("Name")).and_then(|rest| rest.chars().next());
    let Some(separator) = after.filter(|c| ['\t', ' ', ':', ';', ','].contains(c)) else {
        return Err(error!("twincat-head-malformed", part = "first-line"));
    };
    if separator == ' ' {
        return Err(error!("twincat-separated-by-blanks"));
    }
    if separator == ',' && log.form.decimal() == Decimal::Comma {
        return Err(two_commas());
    }
    let stated = log.form.delimiter.and_then(Delimiter::byte).map(char::from);
    if log.form.delimiter.is_some() && stated != Some(separator) {
        return Err(error!("delimiter-differs", separator = format!("{separator:?}")));
    }
    Ok(separator)
}

/// Returns year, month and day of a number of days since 1970-01-01 (Gregorian calendar).
///
/// H. Hinnant, "chrono-Compatible Low-Level Date Algorithms", civil_from_days.
fn civil(days: i64) -> (i64, i64, i64) {
    let z = days + 719_468;
    let (era, day_of_era) = (z.div_euclid(146_097), z.rem_euclid(146_097));
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    (year_of_era + era * 400 + i64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_become_dates() {
        for (days, date) in [
            (0, (1970, 1, 1)),
            (-1, (1969, 12, 31)),
            (11_016, (2000, 2, 29)),
            (11_017, (2000, 3, 1)),
            (19_114, (2022, 5, 2)),
        ] {
            assert_eq!(civil(days), date);
        }
    }
}
