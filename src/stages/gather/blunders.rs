//! Blunders, found by rule and listed: wrong distances between targets of a rigid part.

use super::points::PointColumns;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::{minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, Rigid};
use etalon_documents::{Refused, Source, contradicted_places};
use etalon_formats::Point;
use etalon_identify::{OF_MEDIAN, TargetPair, chi_square_exceeds};
use etalon_math::statistics::median;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::FRAC_PI_2;

/// Points that were measured together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Together {
    /// Pose (or the row number) and cycle.
    Pose(PoseName, Option<i64>),
    /// Equal time stamp, as the bits of its seconds.
    Time(u64),
}

/// Minimum number of distances of a pair for a median that identifies the wrong one.
const FEWEST: usize = 3;

impl Together {
    fn new(point: &Point) -> Option<Self> {
        match (point.pose, point.time_s) {
            (Some(pose), _) => Some(Self::Pose(pose, point.cycle)),
            // 0.0 and -0.0 are the same time
            (None, Some(time_s)) => Some(Self::Time((time_s + 0.0).to_bits())),
            (None, None) => None,
        }
    }
}

/// Indices of the targets measured together, in the order of the rule.
type Groups = BTreeMap<Together, Vec<Option<usize>>>;

/// Errors in the rules themselves, independent of the files.
pub(super) fn check(campaign: &Campaign) -> Problems {
    let rules = campaign.file.rigid.iter().enumerate();
    Problems(rules.filter_map(|(i, rigid)| stated(campaign, rigid, i).err()).collect())
}

/// Rejects points whose distances to the other targets of their rigid part differ from the median
/// by more than the tolerance.
pub(super) fn refuse(campaign: &Campaign, columns: &mut PointColumns, sources: &mut [Source]) -> Result<Vec<Message>> {
    let mut problems = Problems::default();
    for rigid in &campaign.file.rigid {
        let groups = match group(campaign, rigid, &columns.points) {
            Ok(groups) => groups,
            Err(message) => {
                problems.0.push(message);
                continue;
            }
        };
        problems.0.extend(sampled(campaign, rigid));
        match rigid.places_mm.is_empty() {
            true => problems.0.extend(too_few(campaign, rigid, &groups)),
            false => problems.0.extend(contradicted(campaign, rigid, &columns.points, &groups)),
        }
        let refused = violations(rigid, &columns.points, &groups);
        let beside = if refused.is_empty() { BTreeMap::new() } else { together(&columns.points) };
        for (&i, reason) in &refused {
            let point = &columns.points[i];
            let reason = match coincident(point, &beside, rigid.tolerance_mm) {
                Some(other) => phrase!("rigid-point-coincides", message = reason, other),
                None => reason.clone(),
            };
            let target = point.target.as_deref().unwrap_or("");
            let message = warning!("rigid-row-refused", row = point.row, target, reason);
            problems.0.push(message.at(point.place()));
            if let Some(source) = sources.iter_mut().find(|s| s.file == *point.export) {
                source.refused.push(Refused::new(point.line as usize, &point.text, reason));
            }
        }
        // sorted once: the rows of many poses may be rejected
        sources.iter_mut().for_each(|source| source.refused.sort_by_key(|r| r.line));
        for (target, message) in wholly_refused(campaign, rigid, &columns.points, &refused) {
            columns.refused_targets.push(target);
            problems.0.push(message);
        }
        let mut index = 0..;
        columns.points.retain(|_| index.next().is_some_and(|i| !refused.contains_key(&i)));
    }
    problems.check()
}

/// Place of the rule in the campaign.
fn place(campaign: &Campaign, rigid: &Rigid) -> Place {
    rigid.targets.first().map_or_else(|| Place::file(campaign.path.as_str()), |target| campaign.place(target))
}

/// Checks a rule: at least two targets, each once, and a positive tolerance.
fn stated(campaign: &Campaign, rigid: &Rigid, index: usize) -> std::result::Result<(), Message> {
    let names: BTreeSet<&str> = rigid.targets.iter().map(|t| t.get_ref().as_str()).collect();
    if names.len() < 2 || names.len() < rigid.targets.len() {
        return Err(error!("rigid-targets").at(place(campaign, rigid)));
    }
    let is_on = |branch: &Vec<String>| names.iter().any(|name| branch.iter().any(|target| target == name));
    if campaign.robot.branches().iter().filter(|branch| is_on(branch)).count() > 1 {
        return Err(error!("rigid-across-branches", targets = names.iter().copied().collect::<Vec<_>>())
            .at(place(campaign, rigid)));
    }
    if !(rigid.tolerance_mm > 0.0 && rigid.tolerance_mm.is_finite()) {
        let place = campaign.key_place(&["rigid", &index.to_string(), "tolerance_mm"]);
        return Err(error!("limit-not-positive", key = "tolerance_mm").at(place));
    }
    let at = |key: &str| campaign.key_place(&["rigid", &index.to_string(), key]);
    let uncertainty =
        [("expanded_uncertainty_um", rigid.expanded_uncertainty_um), ("coverage_factor", rigid.coverage_factor)];
    if rigid.places_mm.is_empty() {
        return match uncertainty.iter().find(|(_, value)| value.is_some()) {
            Some((key, _)) => Err(error!("rigid-uncertainty-without-places", key).at(at(key))),
            None => Ok(()),
        };
    }
    if let Some(other) = rigid.places_mm.keys().find(|name| !names.contains(name.as_str())) {
        let message = error!("rigid-place-unknown", target = other).at(at("places_mm"));
        return Err(message.hint_names(other, names));
    }
    if let Some(missing) = names.iter().find(|name| !rigid.places_mm.contains_key(**name)) {
        return Err(error!("rigid-place-missing", target = missing).at(at("places_mm")));
    }
    for (key, value) in uncertainty {
        if !value.is_some_and(|value| value > 0.0 && value.is_finite()) {
            return Err(error!("rigid-places-need-uncertainty", key).at(at("places_mm")));
        }
    }
    Ok(())
}

/// Returns the targets of a rigid part that were measured together.
fn group(campaign: &Campaign, rigid: &Rigid, points: &[Point]) -> std::result::Result<Groups, Message> {
    let names: Vec<&str> = rigid.targets.iter().map(|t| t.get_ref().as_str()).collect();
    let index: BTreeMap<&str, usize> = names.iter().copied().zip(0..).collect();
    let mut groups = Groups::new();
    let mut measured = BTreeSet::new();
    for (i, point) in points.iter().enumerate() {
        let Some(&k) = point.target.as_deref().and_then(|target| index.get(target)) else { continue };
        let at = || point.place();
        let key = Together::new(point).ok_or_else(|| error!("rigid-row-without-pose", target = names[k]).at(at()))?;
        let slot = &mut groups.entry(key).or_insert_with(|| vec![None; names.len()])[k];
        if let Some(first) = slot.map(|first: usize| points[first].line) {
            return Err(error!("rigid-time-twice", target = names[k], first).at(at()));
        }
        *slot = Some(i);
        measured.insert(k);
    }
    let together = groups.values().any(|seen| seen.iter().flatten().count() > 1);
    // a target that no export brings is reported by the check of names
    if !together && measured.len() == names.len() && rigid.places_mm.is_empty() {
        return Err(error!("rigid-never-together", targets = names).at(place(campaign, rigid)));
    }
    Ok(groups)
}

/// Number of targets of a part up to which all pairs are compared.
const ALL_PAIRS: usize = 64;

/// The pairs of targets that are compared: all pairs or, of many targets, the pairs of each with
/// the [`ALL_PAIRS`] others whose places in the rule are 1, 2, 4 ... and evenly spaced steps away.
fn pairs(count: usize) -> Vec<(usize, usize)> {
    if count <= ALL_PAIRS {
        return (0..count).flat_map(|i| (0..i).map(move |j| (j, i))).collect();
    }
    let near = (0..usize::BITS).map(|k| 1 << k).take_while(|step| 2 * step < count);
    let wide = (1..ALL_PAIRS / 4).map(|k| k * count / (ALL_PAIRS / 2));
    let steps: BTreeSet<usize> = near.chain(wide).filter(|step| *step > 0).collect();
    let pair = |i: usize, step: usize| {
        let other = (i + step) % count;
        (i.min(other), i.max(other))
    };
    let all: BTreeSet<_> = (0..count).flat_map(|i| steps.iter().map(move |step| pair(i, *step))).collect();
    all.into_iter().collect()
}

/// Returns a remark that a part has too many pairs of targets for all of them to be compared.
fn sampled(campaign: &Campaign, rigid: &Rigid) -> Option<Message> {
    let count = rigid.targets.len();
    let compared = pairs(count).len();
    let message = || warning!("rigid-pairs-sampled", targets = count, compared, pairs = count * (count - 1) / 2);
    (count > ALL_PAIRS).then(|| message().at(place(campaign, rigid)))
}

/// Returns a warning about pairs that were measured too rarely for a meaningful median.
fn too_few(campaign: &Campaign, rigid: &Rigid, groups: &Groups) -> Option<Message> {
    let seen = |p: &(usize, usize)| groups.values().filter(|s| s[p.0].is_some() && s[p.1].is_some()).count();
    let (a, b) = *pairs(rigid.targets.len()).iter().find(|p| (1..FEWEST).contains(&seen(p)))?;
    let [first, second] = [a, b].map(|i| rigid.targets[i].get_ref());
    let message = warning!("rigid-few-distances", first, second, count = seen(&(a, b)), least = FEWEST);
    Some(message.at(place(campaign, rigid)))
}

/// Returns a message if the distances of targets measured together contradict `places_mm` beyond
/// the uncertainty of both.
fn contradicted(campaign: &Campaign, rigid: &Rigid, points: &[Point], groups: &Groups) -> Option<Message> {
    let part = rigid.shape()?;
    let u_at = |i: usize| campaign.file.instrument.standard_uncertainty_at_mm(points[i].xyz_mm);
    let u_mm = groups.values().flatten().flatten().map(|&i| u_at(i)).fold(0.0, f64::max);
    let deviation = |pair: TargetPair| {
        let measured = |seen: &Vec<Option<usize>>| {
            Some(norm(minus(points[seen[pair.first]?].xyz_mm, points[seen[pair.second]?].xyz_mm)))
        };
        let all: Vec<f64> = groups.values().filter_map(measured).collect();
        let middle = median(all.iter().copied())?;
        // variance of one distance, by the instrument or as measured; of a median π/2 times more
        let scatter = OF_MEDIAN * median(all.iter().map(|d| (d - middle).abs()))?;
        let of_median = (2.0 * u_mm * u_mm).max(scatter * scatter) * FRAC_PI_2 / all.len() as f64;
        let variance = of_median + 2.0 * part.standard_uncertainty_mm.powi(2);
        Some((pair, middle, (middle - pair.distance_mm(&part.places_mm)).powi(2) / variance))
    };
    let compared: BTreeSet<(usize, usize)> = pairs(rigid.targets.len()).into_iter().collect();
    let is_compared =
        |pair: &TargetPair| compared.contains(&(pair.first.min(pair.second), pair.first.max(pair.second)));
    let pairs = part.pairs().filter(is_compared).count();
    let (pair, measured_mm, square) =
        part.pairs().filter(is_compared).filter_map(deviation).max_by(|a, b| a.2.total_cmp(&b.2))?;
    // the largest of several: no more often beyond than their sum
    let message = || contradicted_places(&part.contradicted(pair, measured_mm, "measurement"));
    chi_square_exceeds(square, pairs).then(|| message().at(place(campaign, rigid)))
}

/// Indices of the points to reject, with reasons.
fn violations(rigid: &Rigid, points: &[Point], groups: &Groups) -> BTreeMap<usize, Phrase> {
    let names: Vec<&str> = rigid.targets.iter().map(|t| t.get_ref().as_str()).collect();
    let distance = |seen: &[Option<usize>], (a, b): (usize, usize)| {
        Some(norm(minus(points[seen[a]?].xyz_mm, points[seen[b]?].xyz_mm)))
    };
    // of distances enough for one to mean something
    let median_of = |pair| {
        let all: Vec<f64> = groups.values().filter_map(|seen| distance(seen, pair)).collect();
        if all.len() < FEWEST { None } else { median(all) }
    };
    let medians: Vec<((usize, usize), f64)> =
        pairs(names.len()).into_iter().filter_map(|pair| Some((pair, median_of(pair)?))).collect();
    let mut own: Vec<Vec<usize>> = vec![Vec::new(); names.len()];
    for (i, ((a, b), _)) in medians.iter().enumerate() {
        own[*a].push(i);
        own[*b].push(i);
    }
    let exchange = Exchange { medians: &medians, own: &own, tolerance_mm: rigid.tolerance_mm };
    let mut refused = BTreeMap::new();
    for seen in groups.values() {
        let off: Vec<(usize, usize, f64)> = medians
            .iter()
            .filter_map(|&(pair, median)| distance(seen, pair).map(|d| (pair.0, pair.1, d - median)))
            .filter(|(_, _, d)| d.abs() > rigid.tolerance_mm)
            .collect();
        if off.is_empty() {
            continue;
        }
        if let Some((a, b)) = exchange.found(seen, &off, &distance) {
            let reason = phrase!("rigid-targets-exchanged", first = names[a], second = names[b]);
            refused.extend([a, b].into_iter().filter_map(|k| Some((seen[k]?, reason.clone()))));
            continue;
        }
        // the target that all wrong distances share; all of them where there is no single one
        let shared: Vec<usize> = (0..names.len()).filter(|k| off.iter().all(|(a, b, _)| a == k || b == k)).collect();
        let involved: BTreeSet<usize> = off.iter().flat_map(|&(a, b, _)| [a, b]).collect();
        let culprits = if shared.len() == 1 { shared } else { involved.into_iter().collect() };
        let largest = off.iter().fold((0, 0, 0.0f64), |w, o| if o.2.abs() > w.2.abs() { *o } else { w });
        let (first, second, off_mm) = (names[largest.0], names[largest.1], largest.2.abs());
        let side = if largest.2 < 0.0 { "shorter" } else { "longer" };
        let reason = phrase!("rigid-distance-off", first, second, off_mm, side, limit_mm = rigid.tolerance_mm);
        for k in culprits {
            if let Some(i) = seen[k] {
                refused.insert(i, reason.clone());
            }
        }
    }
    refused
}

/// Usual distances of the targets of a part.
struct Exchange<'a> {
    medians: &'a [((usize, usize), f64)],
    /// Indices of the distances of each target.
    own: &'a [Vec<usize>],
    tolerance_mm: f64,
}

impl Exchange<'_> {
    /// Two targets whose exchange brings all distances of a group within the tolerance; `off` are
    /// the distances beyond it, at least one.
    fn found(
        &self,
        seen: &[Option<usize>],
        off: &[(usize, usize, f64)],
        distance: &impl Fn(&[Option<usize>], (usize, usize)) -> Option<f64>,
    ) -> Option<(usize, usize)> {
        // the exchange changes distances to other targets alone
        let fits = |&(a, b): &(usize, usize)| {
            let is_theirs = |(i, j, _): &(usize, usize, f64)| [i, j].into_iter().any(|k| *k == a || *k == b);
            if seen[a].is_none() || seen[b].is_none() || !off.iter().all(is_theirs) {
                return false;
            }
            let other = |k: usize| {
                if k == a {
                    b
                } else if k == b {
                    a
                } else {
                    k
                }
            };
            self.own[a].iter().chain(&self.own[b]).all(|&i| {
                let ((i, j), median) = self.medians[i];
                distance(seen, (other(i), other(j))).is_none_or(|d| (d - median).abs() <= self.tolerance_mm)
            })
        };
        let measured = seen.iter().flatten().count();
        // one of the two has the first wrong distance
        let &(first, second, _) = off.first()?;
        let with =
            |k: usize| (0..seen.len()).filter(move |other| *other != k).map(move |other| (k.min(other), k.max(other)));
        let candidates: BTreeSet<(usize, usize)> = with(first).chain(with(second)).collect();
        let mut found = candidates.into_iter().filter(fits);
        // several swaps, or a distance alone, name nobody
        found.next().filter(|_| measured > 2 && found.next().is_none())
    }
}

/// Targets of a rigid part whose rows are all rejected, and their errors.
fn wholly_refused(
    campaign: &Campaign,
    rigid: &Rigid,
    points: &[Point],
    refused: &BTreeMap<usize, Phrase>,
) -> Vec<(String, Message)> {
    let mut all = Vec::new();
    let mut by_target: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (i, point) in points.iter().enumerate() {
        by_target.entry(point.target.as_deref().unwrap_or_default()).or_default().push(i);
    }
    for target in &rigid.targets {
        let name = target.get_ref();
        let Some(own) = by_target.get(name.as_str()) else { continue };
        let Some(reason) = refused.get(&own[0]).filter(|_| own.iter().all(|i| refused.contains_key(i))) else {
            continue;
        };
        let point = &points[own[0]];
        let (rows, file) = (own.len(), &*point.export);
        let message = error!("rigid-target-refused", target = name, rows, file, line = point.line, reason);
        all.push((name.clone(), message.at(campaign.place(target))));
    }
    all
}

/// Most points of a pose that are compared with one of them.
const MOST_BESIDE: usize = 256;

/// Points that were measured together, by their pose or time.
fn together(points: &[Point]) -> BTreeMap<Option<Together>, Vec<&Point>> {
    let mut all: BTreeMap<_, Vec<&Point>> = BTreeMap::new();
    points.iter().for_each(|point| all.entry(Together::new(point)).or_default().push(point));
    all
}

/// Another target measured together with `point` within the tolerance of it.
fn coincident<'a>(
    point: &Point,
    together: &BTreeMap<Option<Together>, Vec<&'a Point>>,
    tolerance_mm: f64,
) -> Option<&'a str> {
    let beside = together.get(&Together::new(point))?.iter().filter(|p| p.target != point.target).take(MOST_BESIDE);
    let near = |p: &&Point| norm(minus(p.xyz_mm, point.xyz_mm)) <= tolerance_mm;
    beside.copied().find(near).and_then(|p| p.target.as_deref())
}
