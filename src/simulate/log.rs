//! A log with the columns that the campaign reads.

use super::{Scene, Turn};
use crate::base::message::{Message, Result};
use crate::base::noise::Noise;
use crate::base::table::{ASSEMBLY, LABEL};
use crate::campaign::JoinBy;
use crate::import;
use crate::import::format::Column;
use crate::import::format::ColumnAt;
use crate::import::format::Log;
use crate::import::format::LogFormat;
use crate::import::written as text;
use crate::stages::gather;

/// A campaign may number columns, but not without end.
const MOST_COLUMNS: usize = 1000;

/// Stream of the noise of the contact: no file has it.
const CONTACT: u64 = 1 << 33;

/// What stands in a column.
enum Content {
    Pose,
    Cycle,
    /// Its unit.
    Time(TimeUnit),
    Assembly,
    Label,
    /// Index of the joint, factor from the column's unit to mm or deg, digits after the mark.
    Joint(usize, f64, usize),
    /// Index of the joint, factor from the column's unit to mm or deg, worth of a count, count at zero.
    Counts(usize, f64, f64, f64),
}

enum TimeUnit {
    Seconds,
    Milliseconds,
    Nanoseconds,
}

/// The text of a log; an error where import would not read it.
pub(super) fn write(scene: &Scene, log: &Log) -> Result<String> {
    writable(scene, log)?;
    let places = places(log).map_err(|m| m.at(scene.campaign.place(&log.file)))?;
    let width = places.iter().map(|p| p.2 + 1).max().unwrap_or(0);
    let mut header: Vec<String> = (1..=width).map(|n| format!("column_{n}")).collect();
    let mut contents: Vec<Option<Content>> = (0..width).map(|_| None).collect();
    for (key, column, at, name) in places {
        contents[at] = Some(content(scene, key.get_ref(), column).map_err(|m| m.at(scene.campaign.place(key)))?);
        if let Some(name) = name {
            header[at].clone_from(name);
        }
    }
    let line = |fields: &[String]| text::line(fields, log.delimiter(), None);
    let mut all = if log.header { line(&header)? } else { String::new() };
    // a join by pose alone wants one row for all rounds
    let once = scene.campaign.file.join_by() == Some(JoinBy::Pose);
    let mut contact = Noise::new(scene.truth.seed, CONTACT);
    for turn in scene.turns(if once { 1 } else { scene.truth.cycles }) {
        let joints = scene.encoders(turn, &mut contact)?;
        let fields: Vec<String> = contents.iter().map(|c| field(scene, log, c.as_ref(), turn, &joints)).collect();
        all += &line(&fields)?;
    }
    gather::log_of(scene.campaign, log, &all)?;
    Ok(all)
}

/// An error about a log that rows of standing poses, ten seconds apart, are not.
fn writable(scene: &Scene, log: &Log) -> Result<()> {
    let timed = scene.campaign.file.join_by() == Some(JoinBy::Time);
    let what = if log.format == LogFormat::TwinCat {
        "a TwinCAT export"
    } else if log.standstill.is_some() {
        "a log recorded while the robot moves"
    } else if log.period_s.is_some() && timed {
        "a log whose times follow from its period, for a join by time"
    } else if log.columns.values().any(|column| column.occurrence.is_some()) {
        "a log that names columns twice"
    } else {
        return Ok(());
    };
    let message = Message::error(format!("simulate does not write {what}")).at(scene.campaign.place(&log.file));
    Err(message.hint("state another log to simulate, then the real one").into())
}

type Placed<'a> = (&'a toml::Spanned<String>, &'a Column, usize, Option<&'a String>);

/// Index and name of each column: numbered ones stand where they say, named ones fill the gaps in their order.
fn places(log: &Log) -> std::result::Result<Vec<Placed<'_>>, Message> {
    let number = |column: &Column| if let ColumnAt::Number(n) = column.at { Some(n - 1) } else { None };
    let taken: Vec<usize> = log.columns.values().filter_map(number).collect();
    let mut free = (0..).filter(|i| !taken.contains(i));
    let mut places: Vec<Placed> = Vec::new();
    let mut columns: Vec<_> = log.columns.iter().collect();
    if log.format == LogFormat::Galil {
        // arrays are uploaded in alphabetical order
        columns.sort_by_key(|(_, column)| if let ColumnAt::Name(name) = &column.at { name.as_str() } else { "" });
    }
    for (key, column) in columns {
        let (at, name) = match &column.at {
            ColumnAt::Number(n) => (n - 1, None),
            ColumnAt::Name(name) => (free.next().unwrap_or(0), Some(name)),
        };
        let twice = places.iter().any(|p| p.2 == at || name.is_some() && p.3 == name);
        if twice || at >= MOST_COLUMNS {
            return Err(Message::error(format!("the column of `{}` cannot be simulated", key.get_ref()))
                .expected(format!("a column of its own for each key, at most {MOST_COLUMNS} of them")));
        }
        places.push((key, column, at, name));
    }
    Ok(places)
}

/// What a key of `columns` brings.
fn content(scene: &Scene, key: &str, column: &Column) -> std::result::Result<Content, Message> {
    let unknown = || {
        Message::error(format!("a simulated log cannot bring `{key}`"))
            .expected("`pose`, `cycle`, `time_s` and the joints with their units")
    };
    match key {
        "pose" => return Ok(Content::Pose),
        "cycle" => return Ok(Content::Cycle),
        "time_s" => return Ok(Content::Time(TimeUnit::Seconds)),
        "time_ms" => return Ok(Content::Time(TimeUnit::Milliseconds)),
        "time_ns" => return Ok(Content::Time(TimeUnit::Nanoseconds)),
        LABEL => return Ok(Content::Label),
        ASSEMBLY if scene.robot.has_assembly_modes() => return Ok(Content::Assembly),
        _ => {}
    }
    let joint = scene.robot.joints().iter().position(|j| import::is_joint_column(key, j)).ok_or_else(unknown)?;
    let (_, factor) = import::log_column(key).ok_or_else(unknown)?;
    if let Some(per_count) = column.per_count {
        return Ok(Content::Counts(joint, factor, per_count, column.zero_count.unwrap_or(0.0)));
    }
    // as fine as 1e-6 mm or deg; radians, in which no round angle ends, finer than any position tells
    let digits = if key.ends_with("_rad") { 14 } else { (6.0 + factor.log10()).round().max(0.0) as usize };
    Ok(Content::Joint(joint, factor, digits))
}

fn field(scene: &Scene, log: &Log, content: Option<&Content>, turn: Turn, joints: &[f64]) -> String {
    let outward = |joint: usize| scene.robot.joints()[joint].quantity.outward(joints[joint]);
    match content {
        None => "-".to_owned(),
        Some(Content::Pose) => turn.pose.to_string(),
        Some(Content::Cycle) => turn.cycle.to_string(),
        Some(Content::Time(TimeUnit::Seconds)) => text::number(turn.time_s(), 6, log.decimal),
        Some(Content::Time(TimeUnit::Milliseconds)) => text::number(turn.time_s() * 1e3, 0, log.decimal),
        Some(Content::Time(TimeUnit::Nanoseconds)) => text::number(turn.time_s() * 1e9, 0, log.decimal),
        Some(Content::Assembly) => text::number(joints.last().copied().unwrap_or(1.0), 0, log.decimal),
        Some(Content::Label) => scene.truth.label_of(turn.pose).unwrap_or("-").to_owned(),
        Some(Content::Joint(joint, factor, digits)) => text::number(outward(*joint) / factor, *digits, log.decimal),
        Some(Content::Counts(joint, factor, per_count, zero)) => {
            text::number((outward(*joint) / factor / per_count + zero).round(), 0, log.decimal)
        }
    }
}
