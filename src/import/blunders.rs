//! Blunders, found by rule and listed: distances between targets of a rigid part that do not hold.

use super::points::{Point, PointColumns};
use crate::campaign::{Campaign, Rigid};
use crate::document::{Refused, Source};
use crate::message::{Message, Place};
use crate::pose::{minus, norm};
use std::collections::{BTreeMap, BTreeSet};

type Key = (Option<i64>, Option<i64>);

/// Refuses points whose distances to the others of their rigid part leave the median by more than the tolerance.
pub(super) fn refuse(campaign: &Campaign, columns: &mut PointColumns, sources: &mut [Source]) -> Vec<Message> {
    let mut messages = Vec::new();
    for rigid in &campaign.file.rigid {
        let refused = violations(rigid, &columns.points);
        for (&i, reason) in &refused {
            let point = &columns.points[i];
            let reason = match coincident(point, &columns.points, rigid.tolerance_mm) {
                Some(other) => format!("{reason}; it lies where `{other}` is"),
                None => reason.clone(),
            };
            let target = point.target.as_deref().unwrap_or("");
            let what = format!("row {}: `{target}` is refused: {reason}", point.row);
            messages.push(Message::warning(what).at(Place::line(&point.export, point.line, &point.text)));
            if let Some(source) = sources.iter_mut().find(|s| s.file == point.export) {
                source.refused.push(Refused { line: point.line, text: point.text.clone(), reason });
                source.refused.sort_by_key(|r| r.line);
            }
        }
        let mut index = 0..;
        columns.points.retain(|_| index.next().is_some_and(|i| !refused.contains_key(&i)));
    }
    messages
}

/// Indices of the points to refuse, and why.
fn violations(rigid: &Rigid, points: &[Point]) -> BTreeMap<usize, String> {
    let names: Vec<&str> = rigid.targets.iter().map(|t| t.get_ref().as_str()).collect();
    let mut poses: BTreeMap<Key, Vec<Option<usize>>> = BTreeMap::new();
    for (i, point) in points.iter().enumerate() {
        if let Some(k) = point.target.as_deref().and_then(|t| names.iter().position(|n| *n == t)) {
            poses.entry((point.pose, point.cycle)).or_insert_with(|| vec![None; names.len()])[k] = Some(i);
        }
    }
    let pairs: Vec<(usize, usize)> = (0..names.len()).flat_map(|i| (0..i).map(move |j| (j, i))).collect();
    let distance = |seen: &[Option<usize>], (a, b): (usize, usize)| {
        Some(norm(minus(points[seen[a]?].xyz_mm, points[seen[b]?].xyz_mm)))
    };
    let medians: Vec<f64> =
        pairs.iter().map(|&p| median(poses.values().filter_map(|s| distance(s, p)).collect())).collect();
    let mut refused = BTreeMap::new();
    for seen in poses.values() {
        let off: Vec<(usize, usize, f64)> = pairs
            .iter()
            .zip(&medians)
            .filter_map(|(&p, m)| distance(seen, p).map(|d| (p.0, p.1, d - m)))
            .filter(|(_, _, d)| d.abs() > rigid.tolerance_mm)
            .collect();
        if off.is_empty() {
            continue;
        }
        // the target that all wrong distances share; all of them where there is no single one
        let shared: Vec<usize> = (0..names.len()).filter(|k| off.iter().all(|(a, b, _)| a == k || b == k)).collect();
        let involved: BTreeSet<usize> = off.iter().flat_map(|&(a, b, _)| [a, b]).collect();
        let culprits = if shared.len() == 1 { shared } else { involved.into_iter().collect() };
        let largest = off.iter().fold((0, 0, 0.0f64), |w, o| if o.2.abs() > w.2.abs() { *o } else { w });
        let reason = format!(
            "its distance from other targets of the same rigid part is off by {:+.3} mm ({}-{}, tolerance {} mm)",
            largest.2, names[largest.0], names[largest.1], rigid.tolerance_mm
        );
        for k in culprits {
            if let Some(i) = seen[k] {
                refused.insert(i, reason.clone());
            }
        }
    }
    refused
}

/// Another target of the same pose within the tolerance of `point`.
fn coincident<'a>(point: &Point, points: &'a [Point], tolerance_mm: f64) -> Option<&'a str> {
    let other = |p: &&Point| p.pose == point.pose && p.cycle == point.cycle && p.target != point.target;
    let near = |p: &&Point| norm(minus(p.xyz_mm, point.xyz_mm)) <= tolerance_mm;
    points.iter().filter(other).find(near).and_then(|p| p.target.as_deref())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
