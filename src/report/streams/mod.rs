//! Recorded motions: characteristics of ISO 9283 in a table, the path, drift and arrivals in pictures.

pub(super) mod chart;

use super::number;
use super::points::Picture;
use super::words::Words;
use crate::document::{Iso9283Interval, Iso9283NamedStream, Iso9283Path, Iso9283Standstill, Iso9283StreamsDocument};
use chart::{Chart, Curve, Mark};
use serde::Serialize;
use std::collections::BTreeMap;

/// One recording, ready to print.
#[derive(Debug, Serialize)]
pub(super) struct Section<'a> {
    pub name: &'a str,
    pub facts: Vec<[String; 2]>,
    /// pose, arrivals, time, overshoot
    pub settling: Vec<[String; 4]>,
    /// where, CR, CO
    pub corners: Vec<[String; 3]>,
    pub conventions: &'a [String],
    pub pictures: Vec<Picture>,
}

pub(super) fn sections(document: &Iso9283StreamsDocument) -> Vec<Section<'_>> {
    document.streams.iter().enumerate().map(section).collect()
}

fn section((index, named): (usize, &Iso9283NamedStream)) -> Section<'_> {
    let stream = &named.stream;
    let settled = |s: &crate::document::Iso9283Settling| {
        [s.pose.to_string(), s.arrivals.to_string(), number::fixed(s.stabilisation_s, 3), um(s.overshoot_mm)]
    };
    let corner = |c: &crate::document::Iso9283Corner| {
        let at: Vec<String> = c.position_mm.iter().map(|v| number::fixed(*v, 2)).collect();
        [at.join(", "), um(c.cr_mm), um(c.co_mm)]
    };
    let pictures =
        [path_picture(index, stream.path.as_ref()), drift(index, &stream.standstills), arrivals(index, named)];
    Section {
        name: &named.name,
        facts: facts(named),
        settling: stream.settling.iter().map(settled).collect(),
        corners: stream.path.iter().flat_map(|p| &p.corners).map(corner).collect(),
        conventions: &stream.conventions,
        pictures: pictures.into_iter().flatten().collect(),
    }
}

fn um(mm: f64) -> String {
    number::fixed(1e3 * mm, 1)
}

fn with_interval(mm: f64, interval: Option<Iso9283Interval>) -> String {
    let told = interval.map(|i| format!(" (95 %: {} to {})", um(i.low_mm), um(i.high_mm))).unwrap_or_default();
    format!("{} µm{told}", um(mm))
}

fn facts(named: &Iso9283NamedStream) -> Vec<[String; 2]> {
    let stream = &named.stream;
    let mut facts = vec![
        ["file".to_owned(), named.file.clone()],
        [
            "recorded".to_owned(),
            format!("{} samples in {} s", stream.samples, number::significant(stream.duration_s, 4)),
        ],
        ["standstills".to_owned(), stream.standstills.len().to_string()],
    ];
    let mut say = |what: &str, text: String| facts.push([what.to_owned(), text]);
    if let Some(path) = &stream.path {
        let left = if path.incomplete > 0 { format!(", {} incomplete", path.incomplete) } else { String::new() };
        say("path", format!("{} mm, {} passes{left}", number::fixed(path.length_mm, 1), path.passes));
        let clause = if path.reorientation { "path accuracy AT on reorientation" } else { "path accuracy AT" };
        say(
            clause,
            format!("{}, at {} mm", with_interval(path.at_mm, path.at_interval), number::fixed(path.at_along_mm, 1)),
        );
        if let (Some(rt), Some(along)) = (path.rt_mm, path.rt_along_mm) {
            let told = with_interval(rt, path.rt_interval);
            say("path repeatability RT", format!("{told}, at {} mm", number::fixed(along, 1)));
        }
        if let Some(v) = &path.velocity {
            let rv = v.rv_percent.map(|rv| format!(", RV {} %", number::fixed(rv, 2))).unwrap_or_default();
            let (mean, av, fv) =
                (number::fixed(v.mean_mm_s, 2), number::fixed(v.av_percent, 2), number::fixed(v.fv_mm_s, 2));
            say("velocity", format!("{mean} mm/s: AV {av} %{rv}, FV {fv} mm/s"));
        }
    }
    facts
}

/// How the mean path deviates, and how passes scatter, along the path.
fn path_picture(index: usize, path: Option<&Iso9283Path>) -> Option<Picture> {
    let path = path?;
    let of = |value: &dyn Fn(&crate::document::Iso9283PathPoint) -> Option<f64>| -> Vec<(f64, f64)> {
        path.points.iter().filter_map(|p| Some((p.along_mm, 1e3 * value(p)?))).collect()
    };
    let deviation = Curve { name: "deviation of the mean path".to_owned(), points: of(&|p| Some(p.deviation_mm)) };
    let scatter = Curve { name: "mean radius + 3 s of the passes".to_owned(), points: of(&|p| p.rt_mm) };
    let mark = |along: f64, mm: f64, interval: Option<Iso9283Interval>, name: &str| Mark {
        at: (along, 1e3 * mm),
        interval: interval.map(|i| (1e3 * i.low_mm, 1e3 * i.high_mm)),
        name: name.to_owned(),
    };
    let mut marks = vec![mark(path.at_along_mm, path.at_mm, path.at_interval, "AT")];
    if let (Some(along), Some(rt)) = (path.rt_along_mm, path.rt_mm) {
        marks.push(mark(along, rt, path.rt_interval, "RT"));
    }
    Chart {
        id: format!("path-{index}"),
        title: "Deviation along the path".to_owned(),
        caption:
            "Diamonds: AT and RT, the largest of each, with their intervals. The largest of many values that scatter \
                  lies high: RT may be above the interval of what infinitely many passes would give."
                .to_owned(),
        across: "along the path in mm".to_owned(),
        up: "µm".to_owned(),
        curves: vec![deviation, scatter],
        marks,
    }
    .picture(&Words::default())
}

/// How far the mean of each visit lies from that of the first visit of its pose, over time.
fn drift(index: usize, standstills: &[Iso9283Standstill]) -> Option<Picture> {
    let mut by_pose: BTreeMap<i64, Vec<&Iso9283Standstill>> = BTreeMap::new();
    for s in standstills {
        by_pose.entry(s.pose?).or_default().push(s);
    }
    let curve = |(pose, visits): (i64, Vec<&Iso9283Standstill>)| {
        let first = visits.first()?.mean_mm.clone();
        let away = |s: &&Iso9283Standstill| {
            let squares: f64 = s.mean_mm.iter().zip(&first).map(|(a, b)| (a - b).powi(2)).sum();
            (s.from_s, 1e3 * squares.sqrt())
        };
        let points = visits.iter().map(away).collect();
        (visits.len() > 2).then(|| Curve { name: format!("pose {pose}"), points })
    };
    let curves: Vec<Curve> = by_pose.into_iter().filter_map(curve).collect();
    Chart {
        id: format!("drift-{index}"),
        title: "Visits over time".to_owned(),
        caption: "How far the mean of each standstill lies from that of the first at its pose: drift where it grows, \
                  repeatability where it does not."
            .to_owned(),
        across: "time in s".to_owned(),
        up: "µm".to_owned(),
        curves,
        marks: vec![],
    }
    .picture(&Words::default())
}

/// Distance from where the robot comes to stand, from the first entry into the limit band on.
fn arrivals(index: usize, named: &Iso9283NamedStream) -> Option<Picture> {
    let curve = |a: &crate::document::Iso9283Arrival| Curve {
        name: format!("pose {}, visit {}", a.pose, a.cycle),
        points: a.time_s.iter().zip(&a.away_mm).map(|(t, d)| (*t, 1e3 * d)).collect(),
    };
    let band = named.band_mm.map(|band| format!(" The limit band is {} µm.", um(band))).unwrap_or_default();
    Chart {
        id: format!("arrivals-{index}"),
        title: "Arrivals".to_owned(),
        caption: format!("Distance from the attained pose after the first entry into the limit band, the first arrivals of each pose.{band}"),
        across: "time since the entry in s".to_owned(),
        up: "µm".to_owned(),
        curves: named.stream.arrivals.iter().map(curve).collect(),
        marks: vec![],
    }
    .picture(&Words::default())
}
