//! Recorded motions: characteristics of each, standstills, arrivals, corners and points of the path.

use super::sheet::{Cell, Field, Sheet};
use crate::document::{
    Iso9283Corner, Iso9283NamedStream, Iso9283PathPoint, Iso9283Settling, Iso9283Standstill, Iso9283StreamsDocument,
};

/// Sheets that would be empty are left out.
pub(super) fn sheets(document: &Iso9283StreamsDocument) -> Vec<Sheet> {
    let sheets = [
        Sheet::of("Streams", &document.streams, STREAM),
        standstills(document),
        settling(document),
        corners(document),
        points(document),
    ];
    sheets.into_iter().filter(|s| !s.rows.is_empty()).collect()
}

const STREAM: &[Field<Iso9283NamedStream>] = &[
    ("stream", "", |s| s.name.as_str().into()),
    ("file", "", |s| s.file.as_str().into()),
    ("samples", "", |s| s.stream.samples.into()),
    ("duration", "s", |s| s.stream.duration_s.into()),
    ("passes", "", |s| s.stream.path.as_ref().map(|p| p.passes).into()),
    ("path", "mm", |s| s.stream.path.as_ref().map(|p| p.length_mm).into()),
    ("AT", "mm", |s| s.stream.path.as_ref().map(|p| p.at_mm).into()),
    ("AT, 95 % from", "mm", |s| s.stream.path.as_ref().and_then(|p| p.at_interval).map(|i| i.low_mm).into()),
    ("AT, 95 % to", "mm", |s| s.stream.path.as_ref().and_then(|p| p.at_interval).map(|i| i.high_mm).into()),
    ("AT at", "mm", |s| s.stream.path.as_ref().map(|p| p.at_along_mm).into()),
    ("RT", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_mm).into()),
    ("RT, 95 % from", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_interval).map(|i| i.low_mm).into()),
    ("RT, 95 % to", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_interval).map(|i| i.high_mm).into()),
    ("RT at", "mm", |s| s.stream.path.as_ref().and_then(|p| p.rt_along_mm).into()),
    ("mean velocity", "mm/s", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.mean_mm_s).into()),
    ("AV", "%", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.av_percent).into()),
    ("RV", "%", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).and_then(|v| v.rv_percent).into()),
    ("FV", "mm/s", |s| s.stream.path.as_ref().and_then(|p| p.velocity.as_ref()).map(|v| v.fv_mm_s).into()),
    ("weaving, passes", "", |s| s.stream.weaving.as_ref().map(|w| w.passes).into()),
    ("weaving, turns", "", |s| s.stream.weaving.as_ref().map(|w| w.turns).into()),
    ("commanded stroke", "mm", |s| s.stream.weaving.as_ref().map(|w| w.commanded_stroke_mm).into()),
    ("stroke", "mm", |s| s.stream.weaving.as_ref().map(|w| w.stroke_mm).into()),
    ("WS", "%", |s| s.stream.weaving.as_ref().map(|w| w.ws_percent).into()),
    ("commanded frequency", "Hz", |s| s.stream.weaving.as_ref().map(|w| w.commanded_frequency_hz).into()),
    ("frequency", "Hz", |s| s.stream.weaving.as_ref().map(|w| w.frequency_hz).into()),
    ("WF", "%", |s| s.stream.weaving.as_ref().map(|w| w.wf_percent).into()),
];

/// What each stream holds, with the name of the stream.
fn named<'a, T: 'a, I: IntoIterator<Item = &'a T>>(
    document: &'a Iso9283StreamsDocument,
    of: impl Fn(&'a Iso9283NamedStream) -> I,
) -> Vec<(&'a str, &'a T)> {
    document.streams.iter().flat_map(|s| of(s).into_iter().map(move |record| (s.name.as_str(), record))).collect()
}

fn axis(values: &[f64], i: usize) -> Cell {
    values.get(i).copied().into()
}

fn standstills(document: &Iso9283StreamsDocument) -> Sheet {
    let rows: Vec<(&str, &Iso9283Standstill)> = named(document, |s| &s.stream.standstills);
    Sheet::of(
        "Standstills",
        &rows,
        &[
            ("stream", "", |(name, _)| (*name).into()),
            ("pose", "", |(_, s)| s.pose.into()),
            ("cycle", "", |(_, s)| s.cycle.into()),
            ("from", "s", |(_, s)| s.from_s.into()),
            ("to", "s", |(_, s)| s.to_s.into()),
            ("samples", "", |(_, s)| s.samples.into()),
            ("mean x", "mm", |(_, s)| axis(&s.mean_mm, 0)),
            ("mean y", "mm", |(_, s)| axis(&s.mean_mm, 1)),
            ("mean z", "mm", |(_, s)| axis(&s.mean_mm, 2)),
            ("mean a", "deg", |(_, s)| axis(&s.mean_deg, 0)),
            ("mean b", "deg", |(_, s)| axis(&s.mean_deg, 1)),
            ("mean c", "deg", |(_, s)| axis(&s.mean_deg, 2)),
            ("noise", "mm", |(_, s)| s.noise_mm.into()),
            ("stabilisation time", "s", |(_, s)| s.stabilisation_s.into()),
            ("overshoot", "mm", |(_, s)| s.overshoot_mm.into()),
            ("posing time", "s", |(_, s)| s.posing_s.into()),
        ],
    )
}

fn settling(document: &Iso9283StreamsDocument) -> Sheet {
    let rows: Vec<(&str, &Iso9283Settling)> = named(document, |s| &s.stream.settling);
    Sheet::of(
        "Stabilisation",
        &rows,
        &[
            ("stream", "", |(name, _)| (*name).into()),
            ("pose", "", |(_, s)| s.pose.into()),
            ("arrivals", "", |(_, s)| s.arrivals.into()),
            ("stabilisation time", "s", |(_, s)| s.stabilisation_s.into()),
            ("overshoot", "mm", |(_, s)| s.overshoot_mm.into()),
        ],
    )
}

fn corners(document: &Iso9283StreamsDocument) -> Sheet {
    let rows: Vec<(&str, &Iso9283Corner)> = named(document, |s| s.stream.path.iter().flat_map(|p| &p.corners));
    Sheet::of(
        "Corners",
        &rows,
        &[
            ("stream", "", |(name, _)| (*name).into()),
            ("x", "mm", |(_, c)| axis(&c.position_mm, 0)),
            ("y", "mm", |(_, c)| axis(&c.position_mm, 1)),
            ("z", "mm", |(_, c)| axis(&c.position_mm, 2)),
            ("round-off CR", "mm", |(_, c)| c.cr_mm.into()),
            ("overshoot CO", "mm", |(_, c)| c.co_mm.into()),
            ("stabilisation path length", "mm", |(_, c)| c.stabilisation_mm.into()),
        ],
    )
}

fn points(document: &Iso9283StreamsDocument) -> Sheet {
    let rows: Vec<(&str, &Iso9283PathPoint)> = named(document, |s| s.stream.path.iter().flat_map(|p| &p.points));
    Sheet::of(
        "Path",
        &rows,
        &[
            ("stream", "", |(name, _)| (*name).into()),
            ("along", "mm", |(_, p)| p.along_mm.into()),
            ("commanded x", "mm", |(_, p)| axis(&p.commanded_mm, 0)),
            ("commanded y", "mm", |(_, p)| axis(&p.commanded_mm, 1)),
            ("commanded z", "mm", |(_, p)| axis(&p.commanded_mm, 2)),
            ("mean x", "mm", |(_, p)| axis(&p.mean_mm, 0)),
            ("mean y", "mm", |(_, p)| axis(&p.mean_mm, 1)),
            ("mean z", "mm", |(_, p)| axis(&p.mean_mm, 2)),
            ("deviation", "mm", |(_, p)| p.deviation_mm.into()),
            ("mean radius + 3 s", "mm", |(_, p)| p.rt_mm.into()),
        ],
    )
}
