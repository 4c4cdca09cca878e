//! Beckhoff TwinCAT 3 Scope exports: every channel has a time base of its own, in ms since the start of the export.
//!
//! Unsorted exports bring a column of times for each channel, sorted ones for each group of channels with the same times.
//! A row of the log is a time at which all wanted channels have a value; nothing is interpolated.

use super::super::split::{Row, cell_place, number};
use super::twincat_header::{Channel, Header};
use super::{Columns, Values, Wanted, other_unit};
use crate::base::message::{Message, Place, Problems, Result, Stated, count};
use crate::document::Source;
use crate::import::format::ChannelValues;
use crate::import::format::ColumnAt;
use crate::import::format::Log;

/// The samples of a channel.
#[derive(Default)]
struct Samples {
    times_ms: Vec<f64>,
    values: Vec<f64>,
    lines: Vec<i64>,
    /// No more of it in the rows that follow.
    ended: bool,
}

/// Reads the wanted channels.
pub(super) fn read(stated: Stated, log: &Log, wanted: &[Wanted], text: &str, source: &mut Source) -> Result<Columns> {
    let file = log.file.get_ref().as_str();
    let lines: Vec<&str> = text.lines().collect();
    let header = Header::read(file, &lines, log)?;
    let start = header.start_utc().map_or_else(String::new, |start| format!(", start {start}"));
    let (separator, decimal) = (header.separator, log.decimal.name());
    source.dialect = format!("{}, delimited by {separator:?}, decimal `{decimal}`{start}", log.format.name());
    let mut problems = Problems::default();
    if log.period_s.is_some() {
        let message = Message::error("the channels bring their own times").at(stated.place(&log.file));
        problems.0.push(message.hint("leave `period_s` out of this log"));
    }
    let mut chosen = Vec::new();
    for wanted in wanted {
        match channel(&header, log, wanted) {
            Ok(channel) => chosen.push((channel, wanted)),
            Err(message) => problems.0.push(message.at(stated.place(wanted.key))),
        }
    }
    if chosen.is_empty() && problems.0.is_empty() {
        let message = Message::error("`columns` of this log names no channel").at(stated.place(&log.file));
        problems.0.push(message.hint_names("", header.channels.iter().map(|c| c.name.as_str())));
    }
    problems.check()?;
    let mut problems = Problems::default();
    let channels: Vec<&Channel> = chosen.iter().map(|(channel, _)| *channel).collect();
    let samples = samples(&header, &channels, log, &lines, source, &mut problems);
    problems.check()?;
    together(file, &header, &chosen, log, &samples)
}

/// The channel that a key wants, in a unit and a scale that are clear.
fn channel<'a>(header: &'a Header, log: &Log, wanted: &Wanted) -> std::result::Result<&'a Channel, Message> {
    if wanted.name == "time_s" {
        return Err(Message::error("the channels bring their own times").hint("leave the time out of `columns`"));
    }
    let ColumnAt::Name(name) = &wanted.column.at else {
        let message = Message::error("a channel is not given by its number: what is sorted changes with the export");
        return Err(message.hint("give its name"));
    };
    let named: Vec<&Channel> = header.channels.iter().filter(|c| c.name == *name).collect();
    let channel = match (&named[..], wanted.column.occurrence) {
        ([one], None) => *one,
        (several, Some(n)) if n > 0 && n <= several.len() => several[n - 1],
        ([], _) => {
            let message = Message::error(format!("the export has no channel `{name}`"));
            return Err(message.hint_names(name, header.channels.iter().map(|c| c.name.as_str())));
        }
        (several, _) => {
            let message = Message::error(format!("{} channels are called `{name}`", several.len()));
            return Err(message.hint(format!("state which: `{{ name = \"{name}\", occurrence = 1 }}`")));
        }
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

/// Factor and offset that are still to be applied.
fn scale(channel: &Channel, values: Option<ChannelValues>) -> std::result::Result<(f64, f64), Message> {
    const NONE: (f64, f64) = (1.0, 0.0);
    match (channel.scale, channel.unit_scale, values) {
        (NONE, NONE, _) | (_, _, Some(ChannelValues::Scaled)) => Ok(NONE),
        (one, NONE, Some(ChannelValues::Raw)) | (NONE, one, Some(ChannelValues::Raw)) => Ok(one),
        (_, _, Some(ChannelValues::Raw)) => {
            let what = format!("channel `{}` has a scale and a unit with a scale", channel.name);
            let message = Message::error(format!("{what}: which comes first is not documented"));
            Err(message.hint("export it with scaled values, and state `values = \"scaled\"`"))
        }
        ((f, o), (uf, uo), None) => {
            let what = format!("channel `{}` has a scale ({f}, {o}) or a unit with one ({uf}, {uo})", channel.name);
            let message = Message::error(format!("{what}, and the file does not say whether it is applied"));
            Err(message.hint("state `values = \"raw\"` or `values = \"scaled\"`, as the export was set"))
        }
    }
}

/// The samples of each channel.
fn samples(
    header: &Header,
    channels: &[&Channel],
    log: &Log,
    lines: &[&str],
    source: &mut Source,
    problems: &mut Problems,
) -> Vec<Samples> {
    let file = log.file.get_ref().as_str();
    let mut all: Vec<Samples> = channels.iter().map(|_| Samples::default()).collect();
    for (i, line) in lines.iter().enumerate().skip(header.data) {
        if line.trim().is_empty() || line.trim() == "EOF" {
            continue;
        }
        source.rows_read += 1;
        let fields: Vec<&str> = line.split(header.separator).map(str::trim).collect();
        if fields.iter().skip(header.width).any(|f| !f.is_empty()) {
            let message = Message::error(format!("the row has {} fields", fields.len()));
            let message = message.at(Place::line(file, i + 1, *line)).expected(format!("at most {}", header.width));
            problems.0.push(message.hint("is the decimal mark a comma in a file separated by commas?"));
            continue;
        }
        for (channel, samples) in channels.iter().zip(&mut all) {
            let cell = |at: usize| fields.get(at).copied().unwrap_or("");
            let (time, value) = (cell(channel.time), cell(channel.at));
            if time.is_empty() && value.is_empty() {
                samples.ended = true;
                continue;
            }
            let mut wrong = |message: Message, at: usize| {
                let row = Row { line: i + 1, fields: fields.iter().map(|f| (*f).to_owned()).collect() };
                problems.0.push(message.at(cell_place(file, &row, line, at)));
            };
            if samples.ended {
                wrong(Message::error(format!("channel `{}` goes on after it has ended", channel.name)), channel.at);
                continue;
            }
            match (number(time, log.decimal), number(value, log.decimal)) {
                (Err(message), _) => wrong(message, channel.time),
                (_, Err(message)) => wrong(message, channel.at),
                (Ok(time), Ok(_)) if samples.times_ms.last().is_some_and(|last| *last >= time) => {
                    wrong(
                        Message::error(format!("the time of channel `{}` does not go on", channel.name)),
                        channel.time,
                    );
                }
                (Ok(time), Ok(value)) => {
                    samples.times_ms.push(time);
                    samples.values.push(value);
                    samples.lines.push(i as i64 + 1);
                }
            }
        }
    }
    all
}

/// One row for each time at which all channels have a value.
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
        let message = Message::error("there is no time at which all these channels have a value").at(place());
        return Err(message.hint("export channels of one task, with one sample time").into());
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
            let samples = count(alone, "sample");
            let what = format!("channel `{}` has {samples} at times that another channel has not", channel.name);
            columns.said.push(Message::warning(what).at(place()).hint("they are left out; nothing is interpolated"));
        }
    }
    Ok(columns)
}
