//! Recorded motions: table of ISO 9283 characteristics, and figures of path, drift and arrivals.

use crate::model::{Block, Cell, Columns, Figure, Section, Table, Text, fixed, numbers, significant};
use crate::number;
use crate::plots::curves::{Curve, Curves, Mark};
use crate::words::{Words, isolated, tr};
use etalon_base::phrase;
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    Characteristics, Iso9283Arrival, Iso9283Corner, Iso9283Interval, Iso9283NamedStream, Iso9283Path, Iso9283PathPoint,
    Iso9283Posing, Iso9283Settling, Iso9283Standstill, Iso9283StreamsDocument, Iso9283Weaving,
};
use std::collections::BTreeMap;

/// Section of stabilisation time and overshoot (7.4, 7.5).
pub(super) fn stabilisation(tested: &Characteristics, words: &Words) -> Option<Section> {
    let mut section = Section::new("stabilisation", tr!(words, "stabilisation-and-overshoot"));
    let note = tr!(words, "definition-stabilisation");
    for (i, named) in tested.streams.as_ref()?.streams.iter().enumerate() {
        section.table(&named.name, note.as_str(), settling(named, words));
        section.blocks.extend(without_arrival(named, words).map(Block::text));
        section.figures(arrivals(i, named, words));
    }
    section.on_terminal().whole()
}

/// Sentence on the first standstill of a recording that begins at a pose: it has no arrival.
fn without_arrival(named: &Iso9283NamedStream, words: &Words) -> Option<String> {
    named.band_mm?;
    let first = named.stream.standstills.first().filter(|s| s.stabilisation_s.is_none())?;
    Some(tr!(words, "recording-begins-at-pose", pose = first.pose?))
}

/// Section of recordings and their path characteristics (8).
pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.streams.as_ref()?;
    let mut section = Section::new("streams", tr!(words, "recorded-motion"));
    section.push(Block::Table(characteristics(document, words)));
    for (i, named) in document.streams.iter().enumerate() {
        let stream = &named.stream;
        section.push(Block::heading(&named.name));
        section.push(Block::facts(facts(named, words)));
        section.push(Block::Table(corners(named, words)));
        section.figures(path_picture(i, stream.path.as_ref(), words));
        let figures = drift(i, &stream.standstills, words).into_iter().collect();
        let conventions = Block::note(Text::conventions(&stream.conventions, words));
        let blocks = vec![conventions, Block::Figures { figures }];
        section.push(Block::Aside { title: tr!(words, "conventions-and-drift"), blocks });
        section.push(Block::Table(standstills(named, words)));
        section.push(Block::Table(points(named, words)));
    }
    section.on_terminal().whole()
}

/// Section of the minimum posing time (9).
pub(super) fn posing(tested: &Characteristics, words: &Words) -> Option<Section> {
    let mut section = Section::new("posing", tr!(words, "minimum-posing-time"));
    let note = tr!(words, "definition-posing-time");
    for named in &tested.streams.as_ref()?.streams {
        section.table(&named.name, note.as_str(), posing_times(named, words));
    }
    section.on_terminal().whole()
}

/// Section of weaving (11).
pub(super) fn weaving(tested: &Characteristics, words: &Words) -> Option<Section> {
    let mut section = Section::new("weaving", tr!(words, "weaving"));
    for named in &tested.streams.as_ref()?.streams {
        if let Some(weave) = &named.stream.weaving {
            section.push(Block::heading(&named.name));
            section.push(Block::facts(weaving_facts(weave, words).into()));
        }
    }
    section.on_terminal().whole()
}

/// Commanded velocities of the recorded paths, with the name of each recording; `None` if no
/// recording has one.
pub(super) fn velocities(document: &Iso9283StreamsDocument, words: &Words) -> Option<String> {
    let commanded = |named: &Iso9283NamedStream| {
        let velocity = named.stream.path.as_ref()?.velocity.as_ref()?;
        let value = number::stated(velocity.commanded_mm_s);
        Some(tr!(words, "velocity-of-recording", value, name = isolated(&named.name)))
    };
    let all: Vec<String> = document.streams.iter().filter_map(commanded).collect();
    (!all.is_empty()).then(|| all.join(", "))
}

fn micrometres(mm: f64) -> String {
    number::fixed(1e3 * mm, 1)
}

fn with_interval(mm: f64, interval: Option<Iso9283Interval>, words: &Words) -> String {
    match interval {
        Some(i) => tr!(
            words,
            "value-with-interval",
            value = micrometres(mm),
            low = micrometres(i.low_mm),
            high = micrometres(i.high_mm)
        ),
        None => format!("{} µm", micrometres(mm)),
    }
}

fn facts(named: &Iso9283NamedStream, words: &Words) -> Vec<(String, Cell)> {
    let stream = &named.stream;
    let recorded =
        tr!(words, "samples-in-seconds", samples = stream.samples, seconds = number::significant(stream.duration_s, 4));
    let mut facts = vec![
        (tr!(words, "file"), Cell::from(&named.file)),
        (tr!(words, "recorded"), recorded.into()),
        (tr!(words, "standstills"), stream.standstills.len().into()),
    ];
    facts.extend(stream.path.iter().flat_map(|path| path_facts(path, words)));
    facts
}

fn path_facts(path: &Iso9283Path, words: &Words) -> Vec<(String, Cell)> {
    let passes = match path.incomplete {
        0 => tr!(words, "path-passes", length = number::fixed(path.length_mm, 1), passes = path.passes),
        left => {
            tr!(
                words,
                "path-passes-incomplete",
                length = number::fixed(path.length_mm, 1),
                passes = path.passes,
                incomplete = left
            )
        }
    };
    let at = |mm: f64, interval, along: f64| {
        tr!(words, "at-position", value = with_interval(mm, interval, words), position = number::fixed(along, 1))
    };
    let accuracy = match path.reorientation {
        true => tr!(words, "path-accuracy-at-reorientation"),
        false => tr!(words, "path-accuracy-at"),
    };
    let mut facts = vec![
        (tr!(words, "path"), Cell::from(passes)),
        (accuracy, at(path.at_mm, path.at_interval, path.at_along_mm).into()),
    ];
    if let (Some(rt), Some(along)) = (path.rt_mm, path.rt_along_mm) {
        facts.push((tr!(words, "path-repeatability-rt"), at(rt, path.rt_interval, along).into()));
    }
    let angles = |deg: &[f64]| numbers(deg.iter().map(|a| number::fixed(*a, 4)).collect::<Vec<_>>().join(", "));
    facts.push((tr!(words, "at-of-angles"), angles(&path.at_angles_deg)));
    facts.push((tr!(words, "rt-of-angles"), angles(&path.rt_angles_deg)));
    if let Some(v) = &path.velocity {
        let rv = v.rv_percent.map(|rv| format!(", RV {} %", words.fixed(rv, 2))).unwrap_or_default();
        let (mean, av, fv) = (words.fixed(v.mean_mm_s, 2), words.fixed(v.av_percent, 2), words.fixed(v.fv_mm_s, 2));
        facts.push((tr!(words, "path-velocity"), format!("{mean} mm/s: AV {av} %{rv}, FV {fv} mm/s").into()));
    }
    facts
}

fn weaving_facts(w: &Iso9283Weaving, words: &Words) -> [(String, Cell); 3] {
    let of = |attained: f64, commanded: f64| [attained, commanded].map(|v| number::significant(v, 4));
    let ([stroke, wanted], ws) = (of(w.stroke_mm, w.commanded_stroke_mm), number::fixed(w.ws_percent, 2));
    let ([frequency, asked], wf) = (of(w.frequency_hz, w.commanded_frequency_hz), number::fixed(w.wf_percent, 2));
    [
        (tr!(words, "weave"), tr!(words, "weave-passes", passes = w.passes, turns = w.turns).into()),
        (
            tr!(words, "weaving-stroke"),
            tr!(words, "weaving-stroke-measured", measured = stroke, commanded = wanted, ratio = ws).into(),
        ),
        (
            tr!(words, "weaving-frequency"),
            tr!(words, "weaving-frequency-measured", measured = frequency, commanded = asked, ratio = wf).into(),
        ),
    ]
}

/// Deviation of the mean path and scatter of the passes along the path.
fn path_picture(index: usize, path: Option<&Iso9283Path>, words: &Words) -> Option<Figure> {
    let path = path?;
    let of = |value: &dyn Fn(&Iso9283PathPoint) -> Option<f64>| -> Vec<(f64, f64)> {
        path.points.iter().filter_map(|p| Some((p.along_mm, 1e3 * value(p)?))).collect()
    };
    let deviation = Curve { name: tr!(words, "deviation-of-the-mean-path"), points: of(&|p| Some(p.deviation_mm)) };
    let scatter = Curve { name: tr!(words, "mean-radius-plus-3s"), points: of(&|p| p.rt_mm) };
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
        title: tr!(words, "deviation-along-path"),
        caption: tr!(words, "at-rt-diamonds"),
        across: tr!(words, "along-path-in-mm"),
        up: tr!(words, "quantity-in-unit", quantity = tr!(words, "deviation"), unit = "µm"),
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
        (visits.len() > 2).then(|| Curve { name: tr!(words, "pose-named", pose), points })
    };
    let curves: Vec<Curve> = by_pose.into_iter().filter_map(curve).collect();
    Curves {
        id: format!("drift-{index}"),
        title: tr!(words, "visits-over-time"),
        caption: tr!(words, "definition-standstill-distance"),
        across: tr!(words, "time-in-s"),
        up: tr!(words, "quantity-in-unit", quantity = tr!(words, "distance"), unit = "µm"),
        curves,
        marks: vec![],
    }
    .picture(words)
}

/// Distance from the standstill, from the first entry into the limit band.
fn arrivals(index: usize, named: &Iso9283NamedStream, words: &Words) -> Option<Figure> {
    let curve = |a: &Iso9283Arrival| Curve {
        name: tr!(words, "pose-and-visit", pose = a.pose, visit = a.cycle),
        points: a.time_s.iter().zip(&a.away_mm).map(|(t, d)| (*t, 1e3 * d)).collect(),
    };
    let shown = tr!(words, "distance-after-entry");
    let band = named.band_mm.map(|band| tr!(words, "limit-band-value", value = micrometres(band))).unwrap_or_default();
    Curves {
        id: format!("arrivals-{index}"),
        title: tr!(words, "arrivals-title"),
        caption: format!("{shown} {band}").trim_end().to_owned(),
        across: tr!(words, "time-since-entry"),
        up: tr!(words, "quantity-in-unit", quantity = tr!(words, "distance"), unit = "µm"),
        curves: named.stream.arrivals.iter().map(curve).collect(),
        marks: vec![],
    }
    .picture(words)
}

fn characteristics(document: &Iso9283StreamsDocument, words: &Words) -> Table {
    let columns = Columns::<Iso9283NamedStream>::new()
        .sheet(phrase!("stream"), "", |s| s.name.as_str())
        .sheet(phrase!("file"), "", |s| s.file.as_str())
        .sheet(phrase!("head-samples"), "", |s| s.stream.samples)
        .sheet(phrase!("head-duration"), "s", |s| s.stream.duration_s)
        .sheet(phrase!("head-passes"), "", |s| s.stream.path.as_ref().map(|p| p.passes))
        .sheet(phrase!("path"), "mm", |s| s.stream.path.as_ref().map(|p| p.length_mm))
        .sheet("AT", "mm", |s| s.stream.path.as_ref().map(|p| p.at_mm))
        .sheet(phrase!("at-interval-from"), "mm", |s| {
            s.stream.path.as_ref().and_then(|p| p.at_interval).map(|i| i.low_mm)
        })
        .sheet(phrase!("at-interval-to"), "mm", |s| {
            s.stream.path.as_ref().and_then(|p| p.at_interval).map(|i| i.high_mm)
        })
        .sheet(phrase!("at-location"), "mm", |s| s.stream.path.as_ref().map(|p| p.at_along_mm))
        .sheet("RT", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_mm))
        .sheet(phrase!("rt-interval-from"), "mm", |s| {
            s.stream.path.as_ref().and_then(|p| p.rt_interval).map(|i| i.low_mm)
        })
        .sheet(phrase!("rt-interval-to"), "mm", |s| {
            s.stream.path.as_ref().and_then(|p| p.rt_interval).map(|i| i.high_mm)
        })
        .sheet(phrase!("rt-location"), "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_along_mm))
        .sheet(phrase!("commanded-velocity"), "mm/s", |s| {
            s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.commanded_mm_s)
        })
        .sheet(phrase!("mean-velocity"), "mm/s", |s| {
            s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.mean_mm_s)
        })
        .sheet("AV", "%", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.av_percent))
        .sheet("RV", "%", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).and_then(|v| v.rv_percent))
        .sheet("FV", "mm/s", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.fv_mm_s))
        .sheet(phrase!("weaving-passes"), "", |s| s.stream.weaving.as_ref().map(|w| w.passes))
        .sheet(phrase!("weaving-turns"), "", |s| s.stream.weaving.as_ref().map(|w| w.turns))
        .sheet(phrase!("commanded-stroke"), "mm", |s| s.stream.weaving.as_ref().map(|w| w.commanded_stroke_mm))
        .sheet(phrase!("head-stroke"), "mm", |s| s.stream.weaving.as_ref().map(|w| w.stroke_mm))
        .sheet("WS", "%", |s| s.stream.weaving.as_ref().map(|w| w.ws_percent))
        .sheet(phrase!("commanded-frequency"), "Hz", |s| s.stream.weaving.as_ref().map(|w| w.commanded_frequency_hz))
        .sheet(phrase!("head-frequency"), "Hz", |s| s.stream.weaving.as_ref().map(|w| w.frequency_hz))
        .sheet("WF", "%", |s| s.stream.weaving.as_ref().map(|w| w.wf_percent));
    Table::new(words, &document.streams, columns).on(phrase!("sheet-streams"))
}

fn standstills(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283Standstill>::new()
        .sheet(phrase!("stream"), "", |_| named.name.as_str())
        .both(phrase!("pose"), "", |s| s.pose)
        .both(phrase!("cycle"), "", |s| s.cycle)
        .both(phrase!("from"), "s", |s| fixed(s.from_s, 3))
        .both(phrase!("to"), "s", |s| fixed(s.to_s, 3))
        .sheet(phrase!("head-samples"), "", |s| s.samples)
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-mean", axis)), "mm", |s| &s.mean_mm)
        .sheet_xyz(["a", "b", "c"].map(|axis| phrase!("axis-mean", axis)), "deg", |s| &s.mean_deg)
        .micrometres(phrase!("noise"), |s| s.noise_mm)
        .both(phrase!("stabilisation-time"), "s", |s| fixed(s.stabilisation_s, 3))
        .micrometres(phrase!("overshoot"), |s| s.overshoot_mm)
        .both(phrase!("posing-time"), "s", |s| fixed(s.posing_s, 3));
    Table::new(words, &named.stream.standstills, columns).on(phrase!("sheet-standstills")).not_on_page()
}

fn settling(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283Settling>::new()
        .sheet(phrase!("stream"), "", |_| named.name.as_str())
        .both(phrase!("pose"), "", |s| s.pose)
        .both(phrase!("arrivals"), "", |s| s.arrivals)
        .both(phrase!("stabilisation-time"), "s", |s| fixed(s.stabilisation_s, 3))
        .both("U (95 %)", "s", |s| significant(s.stabilisation_expanded_uncertainty_s, 2))
        .micrometres(phrase!("overshoot"), |s| s.overshoot_mm)
        .micrometres("U (95 %)", |s| s.overshoot_expanded_uncertainty_mm);
    Table::new(words, &named.stream.settling, columns).on(phrase!("sheet-stabilisation"))
}

fn posing_times(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283Posing>::new()
        .sheet(phrase!("stream"), "", |_| named.name.as_str())
        .both(phrase!("from-pose"), "", |p| p.from)
        .both(phrase!("to-pose"), "", |p| p.to)
        .both(phrase!("moves"), "", |p| p.moves)
        .both(phrase!("straight-distance"), "mm", |p| fixed(p.distance_mm, 3))
        .both(phrase!("path-length"), "mm", |p| fixed(p.path_mm, 1))
        .both(phrase!("posing-time"), "s", |p| fixed(p.posing_s, 3))
        .both("U (95 %)", "s", |p| significant(p.posing_expanded_uncertainty_s, 2));
    Table::new(words, &named.stream.posing, columns).on(phrase!("sheet-posing"))
}

fn corners(named: &Iso9283NamedStream, words: &Words) -> Table {
    let at = move |c: &Iso9283Corner| c.position_mm.iter().map(|v| words.fixed(*v, 2)).collect::<Vec<_>>().join(", ");
    let columns = Columns::<Iso9283Corner>::new()
        .sheet(phrase!("stream"), "", |_| named.name.as_str())
        .page(phrase!("corner"), "mm", at)
        .sheet_xyz(["x", "y", "z"], "mm", |c| &c.position_mm)
        .micrometres(phrase!("round-off-cr"), |c| c.cr_mm)
        .micrometres(phrase!("overshoot-co"), |c| c.co_mm);
    let of_all = || named.stream.path.iter().flat_map(|p| &p.corners);
    let length = |c: &Iso9283Corner| fixed(c.stabilisation_mm, 3);
    let columns = match of_all().any(|c| c.stabilisation_mm.is_some()) {
        true => columns.both(phrase!("stabilisation-path-length"), "mm", length),
        false => columns.sheet(phrase!("stabilisation-path-length"), "mm", length),
    };
    Table::new(words, of_all(), columns).on(phrase!("sheet-corners"))
}

fn points(named: &Iso9283NamedStream, words: &Words) -> Table {
    let columns = Columns::<Iso9283PathPoint>::new()
        .sheet(phrase!("stream"), "", |_| named.name.as_str())
        .sheet(phrase!("head-along"), "mm", |p| p.along_mm)
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-commanded", axis)), "mm", |p| &p.commanded_mm)
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-mean", axis)), "mm", |p| &p.mean_mm)
        .sheet(phrase!("deviation"), "mm", |p| p.deviation_mm)
        .sheet(phrase!("mean-radius-three-s"), "mm", |p| p.rt_mm);
    Table::new(words, named.stream.path.iter().flat_map(|p| &p.points), columns).on(phrase!("sheet-path"))
}
