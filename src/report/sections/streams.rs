//! Recorded motions: table of ISO 9283 characteristics, and figures of path, drift and arrivals.

use crate::model::{Block, Cell, Columns, Figure, Section, Table, Text, fixed, numbers};
use crate::number;
use crate::plots::curves::{Curve, Curves, Mark};
use crate::words::Words;
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    Characteristics, Iso9283Arrival, Iso9283Corner, Iso9283Interval, Iso9283NamedStream, Iso9283Path, Iso9283PathPoint,
    Iso9283Posing, Iso9283Settling, Iso9283Standstill, Iso9283StreamsDocument, Iso9283Weaving,
};
use std::collections::BTreeMap;

/// Section of stabilisation time and overshoot (7.4, 7.5).
pub(super) fn stabilisation(tested: &Characteristics, words: &Words) -> Option<Section> {
    let mut section = Section::new("stabilisation", words.say("Stabilisation and overshoot"));
    let note = words
        .say("From the first entry into the limit band until it is not left any more (ISO 9283:1998, 7.4 and 7.5).");
    for (i, named) in tested.streams.as_ref()?.streams.iter().enumerate() {
        section.table(&named.name, note.as_str(), settling(named, words));
        section.figures(arrivals(i, named, words));
    }
    section.on_terminal().whole()
}

/// Section of recordings and their path characteristics (8).
pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.streams.as_ref()?;
    let mut section = Section::new("streams", words.say("Recorded motion"));
    section.push(Block::Table(characteristics(document, words)));
    for (i, named) in document.streams.iter().enumerate() {
        let stream = &named.stream;
        section.push(Block::heading(&named.name));
        section.push(Block::facts(facts(named, words)));
        section.push(Block::Table(corners(named, words)));
        let figures = [path_picture(i, stream.path.as_ref(), words), drift(i, &stream.standstills, words)];
        section.figures(figures.into_iter().flatten());
        section.push(Block::note(Text::conventions(&stream.conventions, words)));
        section.push(Block::Table(standstills(named, words)));
        section.push(Block::Table(points(named, words)));
    }
    section.on_terminal().whole()
}

/// Section of the minimum posing time (9).
pub(super) fn posing(tested: &Characteristics, words: &Words) -> Option<Section> {
    let mut section = Section::new("posing", words.say("Minimum posing time"));
    let note = words.say("From leaving a pose to the end of stabilisation at the next (ISO 9283:1998, 9).");
    for named in &tested.streams.as_ref()?.streams {
        section.table(&named.name, note.as_str(), posing_times(named, words));
    }
    section.on_terminal().whole()
}

/// Section of weaving (11).
pub(super) fn weaving(tested: &Characteristics, words: &Words) -> Option<Section> {
    let mut section = Section::new("weaving", words.say("Weaving"));
    for named in &tested.streams.as_ref()?.streams {
        if let Some(weave) = &named.stream.weaving {
            section.push(Block::heading(&named.name));
            section.push(Block::facts(of_weave(weave, words).into()));
        }
    }
    section.on_terminal().whole()
}

fn micrometres(mm: f64) -> String {
    number::fixed(1e3 * mm, 1)
}

fn with_interval(mm: f64, interval: Option<Iso9283Interval>, words: &Words) -> String {
    match interval {
        Some(i) => words
            .fill("{0} µm (95 %: {1} to {2})", &[&micrometres(mm), &micrometres(i.low_mm), &micrometres(i.high_mm)]),
        None => format!("{} µm", micrometres(mm)),
    }
}

fn facts(named: &Iso9283NamedStream, words: &Words) -> Vec<(String, Cell)> {
    let stream = &named.stream;
    let recorded = words.fill("{0} samples in {1} s", &[&stream.samples, &number::significant(stream.duration_s, 4)]);
    let mut facts = vec![
        (words.say("file"), Cell::from(&named.file)),
        (words.say("recorded"), recorded.into()),
        (words.say("standstills"), stream.standstills.len().into()),
    ];
    facts.extend(stream.path.iter().flat_map(|path| of_path(path, words)));
    facts
}

fn of_path(path: &Iso9283Path, words: &Words) -> Vec<(String, Cell)> {
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
    let mut facts = vec![
        (words.say("path"), Cell::from(passes)),
        (accuracy, at(path.at_mm, path.at_interval, path.at_along_mm).into()),
    ];
    if let (Some(rt), Some(along)) = (path.rt_mm, path.rt_along_mm) {
        facts.push((words.say("path repeatability RT"), at(rt, path.rt_interval, along).into()));
    }
    let angles = |deg: &[f64]| numbers(deg.iter().map(|a| number::fixed(*a, 4)).collect::<Vec<_>>().join(", "));
    facts.push((words.say("AT of the angles in deg"), angles(&path.at_angles_deg)));
    facts.push((words.say("RT of the angles in deg"), angles(&path.rt_angles_deg)));
    if let Some(v) = &path.velocity {
        let rv = v.rv_percent.map(|rv| format!(", RV {} %", number::fixed(rv, 2))).unwrap_or_default();
        let (mean, av, fv) =
            (number::fixed(v.mean_mm_s, 2), number::fixed(v.av_percent, 2), number::fixed(v.fv_mm_s, 2));
        facts.push((
            words.say("path velocity"),
            words.number(&format!("{mean} mm/s: AV {av} %{rv}, FV {fv} mm/s")).into(),
        ));
    }
    facts
}

fn of_weave(w: &Iso9283Weaving, words: &Words) -> [(String, Cell); 3] {
    let of = |attained: f64, commanded: f64| [attained, commanded].map(|v| number::significant(v, 4));
    let ([stroke, wanted], ws) = (of(w.stroke_mm, w.commanded_stroke_mm), number::fixed(w.ws_percent, 2));
    let ([frequency, asked], wf) = (of(w.frequency_hz, w.commanded_frequency_hz), number::fixed(w.wf_percent, 2));
    [
        (words.say("weave"), words.fill("{0} passes, {1} turns", &[&w.passes, &w.turns]).into()),
        (
            words.say("weaving stroke"),
            words.fill("{0} mm, commanded {1} mm: WS {2} %", &[&stroke, &wanted, &ws]).into(),
        ),
        (
            words.say("weaving frequency"),
            words.fill("{0} Hz, commanded {1} Hz: WF {2} %", &[&frequency, &asked, &wf]).into(),
        ),
    ]
}

/// Deviation of the mean path and scatter of the passes along the path.
fn path_picture(index: usize, path: Option<&Iso9283Path>, words: &Words) -> Option<Figure> {
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
    Curves {
        id: format!("path-{index}"),
        title: words.say("Deviation along the path"),
        caption: words.say("Diamonds: AT and RT, the largest of each, with their intervals. The largest of many values that scatter lies high: RT may be above the interval of what infinitely many passes would give."),
        across: words.say("along the path in mm"),
        up: words.fill("{0} in {1}", &[&words.say("deviation"), &"µm"]),
        curves: vec![deviation, scatter],
        marks,
    }
    .picture(words)
}

/// Distance of each visit's mean from the first visit of its pose, over time.
fn drift(index: usize, standstills: &[Iso9283Standstill], words: &Words) -> Option<Figure> {
    let mut by_pose: BTreeMap<PoseName, Vec<&Iso9283Standstill>> = BTreeMap::new();
    for s in standstills {
        if let Some(pose) = s.pose {
            by_pose.entry(pose).or_default().push(s);
        }
    }
    let curve = |(pose, visits): (PoseName, Vec<&Iso9283Standstill>)| {
        let first = visits.first()?.mean_mm.clone();
        let away = |s: &&Iso9283Standstill| {
            let squares: f64 = s.mean_mm.iter().zip(&first).map(|(a, b)| (a - b).powi(2)).sum();
            (s.from_s, 1e3 * squares.sqrt())
        };
        let points = visits.iter().map(away).collect();
        (visits.len() > 2).then(|| Curve { name: words.fill("pose {0}", &[&pose]), points })
    };
    let curves: Vec<Curve> = by_pose.into_iter().filter_map(curve).collect();
    Curves {
        id: format!("drift-{index}"),
        title: words.say("Visits over time"),
        caption: words.say("How far the mean of each standstill lies from that of the first at its pose: drift where it grows, repeatability where it does not."),
        across: words.say("time in s"),
        up: words.fill("{0} in {1}", &[&words.say("distance"), &"µm"]),
        curves,
        marks: vec![],
    }
    .picture(words)
}

/// Distance from the standstill, from the first entry into the limit band.
fn arrivals(index: usize, named: &Iso9283NamedStream, words: &Words) -> Option<Figure> {
    let curve = |a: &Iso9283Arrival| Curve {
        name: words.fill("pose {0}, visit {1}", &[&a.pose, &a.cycle]),
        points: a.time_s.iter().zip(&a.away_mm).map(|(t, d)| (*t, 1e3 * d)).collect(),
    };
    let shown = words.say(
        "Distance from the attained pose after the first entry into the limit band, the first arrivals of each pose.",
    );
    let band =
        named.band_mm.map(|band| words.fill("The limit band is {0} µm.", &[&micrometres(band)])).unwrap_or_default();
    Curves {
        id: format!("arrivals-{index}"),
        title: words.say("Arrivals"),
        caption: format!("{shown} {band}").trim_end().to_owned(),
        across: words.say("time since the entry in s"),
        up: words.fill("{0} in {1}", &[&words.say("distance"), &"µm"]),
        curves: named.stream.arrivals.iter().map(curve).collect(),
        marks: vec![],
    }
    .picture(words)
}

fn characteristics(document: &Iso9283StreamsDocument, words: &Words) -> Table {
    let columns = Columns::<Iso9283NamedStream>::new()
        .sheet("stream", "", |s| s.name.as_str())
        .sheet("file", "", |s| s.file.as_str())
        .sheet("samples", "", |s| s.stream.samples)
        .sheet("duration", "s", |s| s.stream.duration_s)
        .sheet("passes", "", |s| s.stream.path.as_ref().map(|p| p.passes))
        .sheet("path", "mm", |s| s.stream.path.as_ref().map(|p| p.length_mm))
        .sheet("AT", "mm", |s| s.stream.path.as_ref().map(|p| p.at_mm))
        .sheet("AT, 95 % from", "mm", |s| s.stream.path.as_ref().and_then(|p| p.at_interval).map(|i| i.low_mm))
        .sheet("AT, 95 % to", "mm", |s| s.stream.path.as_ref().and_then(|p| p.at_interval).map(|i| i.high_mm))
        .sheet("AT at", "mm", |s| s.stream.path.as_ref().map(|p| p.at_along_mm))
        .sheet("RT", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_mm))
        .sheet("RT, 95 % from", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_interval).map(|i| i.low_mm))
        .sheet("RT, 95 % to", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_interval).map(|i| i.high_mm))
        .sheet("RT at", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_along_mm))
        .sheet("mean velocity", "mm/s", |s| {
            s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.mean_mm_s)
        })
        .sheet("AV", "%", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.av_percent))
        .sheet("RV", "%", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).and_then(|v| v.rv_percent))
        .sheet("FV", "mm/s", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.fv_mm_s))
        .sheet("weaving, passes", "", |s| s.stream.weaving.as_ref().map(|w| w.passes))
        .sheet("weaving, turns", "", |s| s.stream.weaving.as_ref().map(|w| w.turns))
        .sheet("commanded stroke", "mm", |s| s.stream.weaving.as_ref().map(|w| w.commanded_stroke_mm))
        .sheet("stroke", "mm", |s| s.stream.weaving.as_ref().map(|w| w.stroke_mm))
        .sheet("WS", "%", |s| s.stream.weaving.as_ref().map(|w| w.ws_percent))
        .sheet("commanded frequency", "Hz", |s| s.stream.weaving.as_ref().map(|w| w.commanded_frequency_hz))
        .sheet("frequency", "Hz", |s| s.stream.weaving.as_ref().map(|w| w.frequency_hz))
        .sheet("WF", "%", |s| s.stream.weaving.as_ref().map(|w| w.wf_percent));
    Table::of(words, &document.streams, columns).on("Streams")
}

fn standstills(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283Standstill>::new()
        .sheet("stream", "", |_| named.name.as_str())
        .both("pose", "", |s| s.pose)
        .both("cycle", "", |s| s.cycle)
        .both("from", "s", |s| fixed(s.from_s, 3))
        .both("to", "s", |s| fixed(s.to_s, 3))
        .sheet("samples", "", |s| s.samples)
        .sheet_xyz(["mean x", "mean y", "mean z"], "mm", |s| &s.mean_mm)
        .sheet_xyz(["mean a", "mean b", "mean c"], "deg", |s| &s.mean_deg)
        .micrometres("noise", |s| s.noise_mm)
        .both("stabilisation time", "s", |s| fixed(s.stabilisation_s, 3))
        .micrometres("overshoot", |s| s.overshoot_mm)
        .both("posing time", "s", |s| fixed(s.posing_s, 3));
    Table::of(words, &named.stream.standstills, columns).on("Standstills").not_on_page()
}

fn settling(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283Settling>::new()
        .sheet("stream", "", |_| named.name.as_str())
        .both("pose", "", |s| s.pose)
        .both("arrivals", "", |s| s.arrivals)
        .both("stabilisation time", "s", |s| fixed(s.stabilisation_s, 3))
        .micrometres("overshoot", |s| s.overshoot_mm);
    Table::of(words, &named.stream.settling, columns).on("Stabilisation")
}

fn posing_times(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283Posing>::new()
        .sheet("stream", "", |_| named.name.as_str())
        .both("from pose", "", |p| p.from)
        .both("to pose", "", |p| p.to)
        .both("moves", "", |p| p.moves)
        .both("distance", "mm", |p| fixed(p.distance_mm, 3))
        .both("posing time", "s", |p| fixed(p.posing_s, 3));
    Table::of(words, &named.stream.posing, columns).on("Posing")
}

fn corners(named: &Iso9283NamedStream, words: &Words) -> Table {
    let at = |c: &Iso9283Corner| c.position_mm.iter().map(|v| number::fixed(*v, 2)).collect::<Vec<_>>().join(", ");
    let at = move |c: &Iso9283Corner| words.number(&at(c));
    let columns = Columns::<Iso9283Corner>::new()
        .sheet("stream", "", |_| named.name.as_str())
        .page("corner", "mm", at)
        .sheet_xyz(["x", "y", "z"], "mm", |c| &c.position_mm)
        .micrometres("round-off CR", |c| c.cr_mm)
        .micrometres("overshoot CO", |c| c.co_mm);
    let of_all = || named.stream.path.iter().flat_map(|p| &p.corners);
    let length = |c: &Iso9283Corner| fixed(c.stabilisation_mm, 3);
    let columns = match of_all().any(|c| c.stabilisation_mm.is_some()) {
        true => columns.both("stabilisation path length", "mm", length),
        false => columns.sheet("stabilisation path length", "mm", length),
    };
    Table::of(words, of_all(), columns).on("Corners")
}

fn points(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283PathPoint>::new()
        .sheet("stream", "", |_| named.name.as_str())
        .sheet("along", "mm", |p| p.along_mm)
        .sheet_xyz(["commanded x", "commanded y", "commanded z"], "mm", |p| &p.commanded_mm)
        .sheet_xyz(["mean x", "mean y", "mean z"], "mm", |p| &p.mean_mm)
        .sheet("deviation", "mm", |p| p.deviation_mm)
        .sheet("mean radius + 3 s", "mm", |p| p.rt_mm);
    Table::of(words, named.stream.path.iter().flat_map(|p| &p.points), columns).on("Path")
}
