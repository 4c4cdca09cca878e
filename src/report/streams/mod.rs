//! Recorded motions: characteristics of ISO 9283 in a table, the path, drift and arrivals in pictures.

pub(super) mod chart;

use super::number;
use super::points::Picture;
use super::words::Words;
use crate::document::{
    Iso9283Arrival, Iso9283Corner, Iso9283Interval, Iso9283NamedStream, Iso9283Path, Iso9283PathPoint, Iso9283Settling,
    Iso9283Standstill, Iso9283StreamsDocument, Iso9283Weaving,
};
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

pub(super) fn sections<'a>(document: &'a Iso9283StreamsDocument, words: &Words) -> Vec<Section<'a>> {
    document.streams.iter().enumerate().map(|(i, stream)| section((i, stream), words)).collect()
}

fn section<'a>((index, named): (usize, &'a Iso9283NamedStream), words: &Words) -> Section<'a> {
    let stream = &named.stream;
    let settled = |s: &Iso9283Settling| {
        [s.pose.to_string(), s.arrivals.to_string(), number::fixed(s.stabilisation_s, 3), um(s.overshoot_mm)]
    };
    let corner = |c: &Iso9283Corner| {
        let at: Vec<String> = c.position_mm.iter().map(|v| number::fixed(*v, 2)).collect();
        [at.join(", "), um(c.cr_mm), um(c.co_mm)]
    };
    let pictures = [
        path_picture((index, stream.path.as_ref()), words),
        drift((index, &stream.standstills), words),
        arrivals((index, named), words),
    ];
    Section {
        name: &named.name,
        facts: facts(named, words),
        settling: stream.settling.iter().map(settled).collect(),
        corners: stream.path.iter().flat_map(|p| &p.corners).map(corner).collect(),
        conventions: &stream.conventions,
        pictures: pictures.into_iter().flatten().collect(),
    }
}

fn um(mm: f64) -> String {
    number::fixed(1e3 * mm, 1)
}

fn with_interval(mm: f64, interval: Option<Iso9283Interval>, words: &Words) -> String {
    match interval {
        Some(i) => words.fill("{0} µm (95 %: {1} to {2})", &[&um(mm), &um(i.low_mm), &um(i.high_mm)]),
        None => format!("{} µm", um(mm)),
    }
}

fn facts(named: &Iso9283NamedStream, words: &Words) -> Vec<[String; 2]> {
    let stream = &named.stream;
    let recorded = words.fill("{0} samples in {1} s", &[&stream.samples, &number::significant(stream.duration_s, 4)]);
    let mut facts = vec![
        [words.say("file"), named.file.clone()],
        [words.say("recorded"), recorded],
        [words.say("standstills"), stream.standstills.len().to_string()],
    ];
    facts.extend(stream.path.iter().flat_map(|path| of_path(path, words)));
    facts.extend(stream.weaving.iter().flat_map(|weave| of_weave(weave, words)));
    facts
}

fn of_path(path: &Iso9283Path, words: &Words) -> Vec<[String; 2]> {
    let passes = match path.incomplete {
        0 => words.fill("{0} mm, {1} passes", &[&number::fixed(path.length_mm, 1), &path.passes]),
        left => {
            words.fill("{0} mm, {1} passes, {2} incomplete", &[&number::fixed(path.length_mm, 1), &path.passes, &left])
        }
    };
    let at = |mm: f64, interval, along: f64| {
        words.fill("{0}, at {1} mm", &[&with_interval(mm, interval, words), &number::fixed(along, 1)])
    };
    let accuracy = match path.reorientation {
        true => words.say("path accuracy AT on reorientation"),
        false => words.say("path accuracy AT"),
    };
    let mut facts = vec![[words.say("path"), passes], [accuracy, at(path.at_mm, path.at_interval, path.at_along_mm)]];
    if let (Some(rt), Some(along)) = (path.rt_mm, path.rt_along_mm) {
        facts.push([words.say("path repeatability RT"), at(rt, path.rt_interval, along)]);
    }
    if let Some(v) = &path.velocity {
        let rv = v.rv_percent.map(|rv| format!(", RV {} %", number::fixed(rv, 2))).unwrap_or_default();
        let (mean, av, fv) =
            (number::fixed(v.mean_mm_s, 2), number::fixed(v.av_percent, 2), number::fixed(v.fv_mm_s, 2));
        facts.push([words.say("path velocity"), format!("{mean} mm/s: AV {av} %{rv}, FV {fv} mm/s")]);
    }
    facts
}

fn of_weave(w: &Iso9283Weaving, words: &Words) -> [[String; 2]; 3] {
    let of = |attained: f64, commanded: f64| [attained, commanded].map(|v| number::significant(v, 4));
    let ([stroke, wanted], ws) = (of(w.stroke_mm, w.commanded_stroke_mm), number::fixed(w.ws_percent, 2));
    let ([frequency, asked], wf) = (of(w.frequency_hz, w.commanded_frequency_hz), number::fixed(w.wf_percent, 2));
    [
        [words.say("weave"), words.fill("{0} passes, {1} turns", &[&w.passes, &w.turns])],
        [words.say("weaving stroke"), words.fill("{0} mm, commanded {1} mm: WS {2} %", &[&stroke, &wanted, &ws])],
        [words.say("weaving frequency"), words.fill("{0} Hz, commanded {1} Hz: WF {2} %", &[&frequency, &asked, &wf])],
    ]
}

/// How the mean path deviates, and how passes scatter, along the path.
fn path_picture((index, path): (usize, Option<&Iso9283Path>), words: &Words) -> Option<Picture> {
    let path = path?;
    let of = |value: &dyn Fn(&Iso9283PathPoint) -> Option<f64>| -> Vec<(f64, f64)> {
        path.points.iter().filter_map(|p| Some((p.along_mm, 1e3 * value(p)?))).collect()
    };
    let deviation = Curve { name: words.say("deviation of the mean path"), points: of(&|p| Some(p.deviation_mm)) };
    let scatter = Curve { name: words.say("mean radius + 3 s of the passes"), points: of(&|p| p.rt_mm) };
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
        title: words.say("Deviation along the path"),
        caption: words.say("Diamonds: AT and RT, the largest of each, with their intervals. The largest of many values that scatter lies high: RT may be above the interval of what infinitely many passes would give."),
        across: words.say("along the path in mm"),
        up: "µm".to_owned(),
        curves: vec![deviation, scatter],
        marks,
    }
    .picture(words)
}

/// How far the mean of each visit lies from that of the first visit of its pose, over time.
fn drift((index, standstills): (usize, &[Iso9283Standstill]), words: &Words) -> Option<Picture> {
    let mut by_pose: BTreeMap<i64, Vec<&Iso9283Standstill>> = BTreeMap::new();
    for s in standstills {
        if let Some(pose) = s.pose {
            by_pose.entry(pose).or_default().push(s);
        }
    }
    let curve = |(pose, visits): (i64, Vec<&Iso9283Standstill>)| {
        let first = visits.first()?.mean_mm.clone();
        let away = |s: &&Iso9283Standstill| {
            let squares: f64 = s.mean_mm.iter().zip(&first).map(|(a, b)| (a - b).powi(2)).sum();
            (s.from_s, 1e3 * squares.sqrt())
        };
        let points = visits.iter().map(away).collect();
        (visits.len() > 2).then(|| Curve { name: words.fill("pose {0}", &[&pose]), points })
    };
    let curves: Vec<Curve> = by_pose.into_iter().filter_map(curve).collect();
    Chart {
        id: format!("drift-{index}"),
        title: words.say("Visits over time"),
        caption: words.say("How far the mean of each standstill lies from that of the first at its pose: drift where it grows, repeatability where it does not."),
        across: words.say("time in s"),
        up: "µm".to_owned(),
        curves,
        marks: vec![],
    }
    .picture(words)
}

/// Distance from where the robot comes to stand, from the first entry into the limit band on.
fn arrivals((index, named): (usize, &Iso9283NamedStream), words: &Words) -> Option<Picture> {
    let curve = |a: &Iso9283Arrival| Curve {
        name: words.fill("pose {0}, visit {1}", &[&a.pose, &a.cycle]),
        points: a.time_s.iter().zip(&a.away_mm).map(|(t, d)| (*t, 1e3 * d)).collect(),
    };
    let shown = words.say(
        "Distance from the attained pose after the first entry into the limit band, the first arrivals of each pose.",
    );
    let band = named.band_mm.map(|band| words.fill("The limit band is {0} µm.", &[&um(band)])).unwrap_or_default();
    Chart {
        id: format!("arrivals-{index}"),
        title: words.say("Arrivals"),
        caption: format!("{shown} {band}").trim_end().to_owned(),
        across: words.say("time since the entry in s"),
        up: "µm".to_owned(),
        curves: named.stream.arrivals.iter().map(curve).collect(),
        marks: vec![],
    }
    .picture(words)
}
