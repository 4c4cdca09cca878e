//! AT and RT of recorded motions over campaigns, matched by the name of the stream.

use super::significance::{Difference, Recovered, recovered};
use super::trend::{TrendName, changed, pairs};
use etalon_base::message::{Message, one_line};
use etalon_base::warning;
use etalon_documents::*;

/// Tolerance of equal paths in length, start and end, relative to the length.
const SAME: f64 = 1e-3;
/// Number of passes for which intervals of AT and RT were tested.
const TESTED_PASSES: usize = 10;

/// AT and RT of all streams that occur in every campaign along the same path.
pub(super) fn trends(all: &[&Iso9283StreamsDocument], messages: &mut Vec<Message>) -> Vec<CompareTrend> {
    let Some(first) = all.first() else { return Vec::new() };
    let (mut accuracies, mut repeatabilities) = (Vec::new(), Vec::new());
    for stream in first.streams.iter().filter(|s| s.stream.path.is_some()) {
        let of = |d: &&Iso9283StreamsDocument| {
            d.streams.iter().find(|s| s.name == stream.name).and_then(|s| s.stream.path.clone())
        };
        let name = one_line(&stream.name);
        let paths: Vec<Iso9283Path> = all.iter().filter_map(of).collect();
        if paths.len() < all.len() {
            messages.push(warning!("stream-not-in-all", stream = name));
            continue;
        }
        if !paths.iter().all(|p| is_same(&paths[0], p)) {
            messages.push(warning!("stream-commands-differ", stream = name));
            continue;
        }
        let fewest = paths.iter().map(|p| p.passes).min().unwrap_or(0);
        if fewest < TESTED_PASSES {
            messages.push(warning!("stream-few-passes", stream = name, passes = fewest, validated = TESTED_PASSES));
        }
        accuracies.push(accuracy(&name, &paths));
        repeatabilities.extend(repeatability(&name, &paths));
    }
    accuracies.extend(repeatabilities);
    accuracies
}

/// Caveat on the reliability of a verdict, if AT or RT are judged to have changed.
pub(super) fn doubt(trends: &[CompareTrend]) -> Option<Message> {
    let of_path =
        |t: &&CompareTrend| [CompareFamily::PathAccuracy, CompareFamily::PathRepeatability].contains(&t.family);
    let changed = |t: &&CompareTrend| t.changes.iter().any(|c| c.significant == Some(true));
    let names: Vec<&str> = trends.iter().filter(of_path).filter(changed).map(|t| t.name.english()).collect();
    (!names.is_empty()).then(|| warning!("path-change-uncertain", names))
}

fn is_same(a: &Iso9283Path, b: &Iso9283Path) -> bool {
    let near = |x: f64, y: f64| (x - y).abs() <= SAME * a.length_mm.max(b.length_mm);
    let at = |p: Option<&Iso9283PathPoint>| p.map(|p| p.commanded_mm.clone()).unwrap_or_default();
    let meet = |a: Vec<f64>, b: Vec<f64>| a.len() == b.len() && a.iter().zip(&b).all(|(x, y)| near(*x, *y));
    // AT and RT are maxima over the command points, whose number must agree as well
    let ends = meet(at(a.points.first()), at(b.points.first())) && meet(at(a.points.last()), at(b.points.last()));
    near(a.length_mm, b.length_mm) && ends && a.points.len() == b.points.len()
}

/// Compares AT by the difference of values with known intervals, like AP.
fn accuracy(name: &str, all: &[Iso9283Path]) -> CompareTrend {
    let value = |p: &Iso9283Path| with_interval(p.at_mm, p.at_interval);
    let known = |p: &Iso9283Path| p.at_interval.map(|i| (p.at_mm, i.low_mm, i.high_mm));
    let change = |[from, to]: [usize; 2]| {
        let found = known(&all[from]).zip(known(&all[to])).map(|(a, b)| recovered(a, b));
        changed([from, to], &found.unwrap_or(unknown(all[to].at_mm - all[from].at_mm)), None)
    };
    let changes = pairs(all.len()).into_iter().map(change).collect();
    let values = all.iter().map(value).collect();
    TrendName::at("AT", &name).trend(CompareFamily::PathAccuracy, "mm", values, changes)
}

/// Compares RT by the ratio of the RT of infinitely many passes. RT itself, the maximum of many
/// scattered values, is biased upwards depending on the number of passes, and may lie above its
/// interval.
fn repeatability(name: &str, all: &[Iso9283Path]) -> Option<CompareTrend> {
    let values: Vec<f64> = all.iter().map(|p| p.rt_mm).collect::<Option<_>>()?;
    let value = |(rt, p): (&f64, &Iso9283Path)| with_interval(*rt, p.rt_interval);
    // middle and ends on the logarithmic scale
    let known = |p: &Iso9283Path| -> Option<Recovered> {
        let (low, high) = (p.rt_interval?.low_mm.ln(), p.rt_interval?.high_mm.ln());
        (low.is_finite() && high.is_finite()).then_some((0.5 * (low + high), low, high))
    };
    let change = |[from, to]: [usize; 2]| {
        let difference = values[to] - values[from];
        let Some((a, b)) = known(&all[from]).zip(known(&all[to])) else {
            return changed([from, to], &unknown(difference), None);
        };
        let d = recovered(a, b);
        let ratio = Difference { change: d.change.exp(), low: d.low.exp(), high: d.high.exp(), p: d.p };
        changed([from, to], &ratio, Some(difference))
    };
    let changes = pairs(all.len()).into_iter().map(change).collect();
    let values = values.iter().zip(all).map(value).collect();
    Some(TrendName::at("RT", &name).trend(CompareFamily::PathRepeatability, "mm", values, changes))
}

fn with_interval(value: f64, interval: Option<Iso9283Interval>) -> CompareValue {
    CompareValue {
        value: Some(value),
        standard_uncertainty: None,
        low: interval.map(|i| i.low_mm),
        high: interval.map(|i| i.high_mm),
    }
}

/// A change without an interval or a probability.
fn unknown(change: f64) -> Difference {
    Difference { change, low: f64::NAN, high: f64::NAN, p: f64::NAN }
}
