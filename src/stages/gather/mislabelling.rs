//! Points with the coordinates of another point, and reference targets that drift: reported, never
//! dropped.

use etalon_base::message::{Message, Problems};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, warning};
use etalon_campaign::{Campaign, Fixed, JoinBy};
use etalon_formats::Point;
use etalon_math::statistics::median;
use indexmap::IndexMap;
use std::collections::{BTreeMap, BTreeSet};

/// Number of blocks of a recording that are compared for drift, and minimum number of rows in each.
const BLOCKS: usize = 10;
const FEWEST: usize = 3;
/// Fewest points of one name that can be a scan, and the number of points that are looked at.
const FEWEST_OF_SCAN: usize = 20;
const MOST_OF_SCAN: usize = 1000;
/// Number of names, and of points of a name, in one cell that a point is compared with.
const MOST_NAMES: usize = 64;
/// Maximum number of named pairs.
const MOST_PAIRS: usize = 50;

/// Largest distance of two readings of one point: ten times the instrument's expanded uncertainty,
/// from 0.1 to 1 mm.
fn near_mm(campaign: &Campaign) -> f64 {
    (10.0 * campaign.file.instrument.expanded_uncertainty_um / 1000.0).clamp(0.1, 1.0)
}

/// The name of a row: its target, or its label.
fn name(point: &Point) -> &str {
    point.target.as_deref().unwrap_or(&point.label)
}

/// Warnings about rows with the name of one point and the position of another: in the same pose,
/// or, for stationary points, away from all other rows of their name. Each pair of names has one
/// warning, and no warning if most rows of one name are at rows of the other: these are repeats of
/// the same points.
pub(super) fn misplaced(campaign: &Campaign, points: &[Point]) -> Vec<Message> {
    let near = near_mm(campaign);
    let mut same: BTreeMap<&str, Vec<&Point>> = BTreeMap::new();
    points.iter().for_each(|p| same.entry(name(p)).or_default().push(p));
    let mut usual = BTreeMap::new();
    let mut off = |p| {
        let own: &[&Point] = same.get(name(p)).map_or(&[], Vec::as_slice);
        let (place, spread) = *usual.entry(name(p)).or_insert_with(|| where_it_is(own));
        norm(minus(p.xyz_mm, place)) / spread
    };
    let stray = |p: &Point| strays(p, same.get(name(p)).map_or(&[], Vec::as_slice), near);
    let scans: BTreeSet<&str> = same.iter().filter(|(_, own)| is_scan(own, near)).map(|(name, _)| *name).collect();
    let placed = |p: &&Point| p.pose.is_some() || p.target.is_some() || !scans.contains(name(p));
    let mut found: BTreeMap<(&str, &str), Vec<&Point>> = BTreeMap::new();
    for (a, b) in neighbours(points.iter().filter(placed), near) {
        let wrong = match (a.pose, b.pose) {
            (Some(p), Some(q)) if (p, a.cycle) == (q, b.cycle) => {
                if off(a) >= off(b) {
                    a
                } else {
                    b
                }
            }
            (None, None) if a.target.is_none() && b.target.is_none() => match stray(a) {
                true => a,
                // each ball of a plate has a place of its own
                false if stray(b) || campaign.file.join_by() == Some(JoinBy::Label) => b,
                false => continue,
            },
            _ => continue,
        };
        let other = if std::ptr::eq(wrong, a) { b } else { a };
        found.entry((name(wrong), name(other))).or_default().push(wrong);
    }
    let warning = |((wrong, other), mut rows): ((&str, &str), Vec<&Point>)| {
        rows.sort_by_key(|p| (p.row, p.line));
        rows.dedup_by_key(|p| (p.row, p.line));
        let first = rows.first()?;
        let own = same.get(wrong).map_or(0, Vec::len);
        if first.pose.is_none() && rows.len() > 1 && 2 * rows.len() > own {
            return None;
        }
        let message = warning!("point-lies-at-another", row = first.row, point = wrong, other, rows = rows.len());
        Some(message.to_decide().at(first.place()))
    };
    let mut warnings: Vec<Message> = found.into_iter().filter_map(warning).collect();
    if warnings.len() > MOST_PAIRS {
        // targets at one place: each pair says the same
        let pairs = warnings.len();
        warnings.truncate(MOST_PAIRS);
        warnings.push(warning!("point-pairs-many", pairs, named = MOST_PAIRS).to_decide());
    }
    warnings
}

/// Returns pairs of neighbouring points with different names. Cells are twice as wide as `near`, so
/// that a neighbour is in the same cell or in the next cell on the nearer side of each axis.
fn neighbours<'a>(points: impl Iterator<Item = &'a Point>, near: f64) -> Vec<(&'a Point, &'a Point)> {
    let named = points.filter(|p| !name(p).is_empty() && p.xyz_mm[0].is_finite());
    // by name: repeats of one point are many
    let mut cells: BTreeMap<[i64; 3], IndexMap<&str, Vec<&Point>>> = BTreeMap::new();
    let mut pairs = Vec::new();
    for point in named {
        let place = point.xyz_mm.map(|v| v / (2.0 * near));
        let own = place.map(|v| v.floor() as i64);
        let nearer = |v: f64| if v - v.floor() < 0.5 { v.floor() - 1.0 } else { v.floor() + 1.0 };
        let next = place.map(|v| nearer(v) as i64);
        for side in 0..8 {
            let cell = [0, 1, 2].map(|k| if side >> k & 1 == 0 { own[k] } else { next[k] });
            // of a crowd in one place a few are enough
            let others = cells.get(&cell).into_iter().flatten().filter(|(other, _)| **other != name(point));
            pairs.extend(
                others
                    .take(MOST_NAMES)
                    .flat_map(|(_, points)| points.iter().take(MOST_NAMES))
                    .filter(|o| distance(o, point) <= near)
                    .take(4)
                    .map(|other| (*other, point)),
            );
        }
        cells.entry(own).or_default().entry(name(point)).or_default().push(point);
    }
    pairs
}

/// `true` if the points of a name are scattered over a surface: none of them has a place of its
/// own.
fn is_scan(own: &[&Point], near: f64) -> bool {
    if own.len() < FEWEST_OF_SCAN {
        return false;
    }
    // a part of a long scan shows how far it reaches
    let some: Vec<&Point> = own.iter().step_by(own.len().div_ceil(MOST_OF_SCAN)).copied().collect();
    where_it_is(&some).1 > 10.0 * near
}

fn distance(a: &Point, b: &Point) -> f64 {
    norm(minus(a.xyz_mm, b.xyz_mm))
}

/// `true` if its file has other rows of the point's name, and all are far from the point.
fn strays(point: &Point, same: &[&Point], near: f64) -> bool {
    let own = || same.iter().copied().filter(|p| !std::ptr::eq(*p, point) && p.export == point.export);
    own().next().is_some() && own().all(|p| distance(p, point) > 10.0 * near)
}

/// Usual position of the points of one name, and their usual distance from it.
fn where_it_is(own: &[&Point]) -> (Vector, f64) {
    let usual = middle(&own.iter().map(|p| p.xyz_mm).collect::<Vec<_>>()).unwrap_or_default();
    let spread = median(own.iter().map(|p| norm(minus(p.xyz_mm, usual))));
    (usual, spread.map_or(1e-6, |s| s.max(1e-6)))
}

/// The median of each coordinate.
fn middle(all: &[Vector]) -> Option<Vector> {
    let axis = |k: usize| median(all.iter().map(|p| p[k]));
    Some([axis(0)?, axis(1)?, axis(2)?])
}

/// Errors in the statements about fixed targets.
pub(super) fn check(campaign: &Campaign) -> Problems {
    let wrong = |(i, fixed): (usize, &Fixed)| {
        let place = || campaign.key_place(&["fixed", &i.to_string(), "drift_mm"]);
        let is_limit = fixed.drift_mm > 0.0 && fixed.drift_mm.is_finite();
        (!is_limit).then(|| error!("limit-not-positive", key = "drift_mm").at(place()))
    };
    Problems(campaign.file.fixed.iter().enumerate().filter_map(wrong).collect())
}

/// Returns warnings about fixed targets that drift: the medians of two tenths of their rows are
/// farther apart than given.
pub(super) fn drifting(campaign: &Campaign, points: &[Point]) -> Vec<Message> {
    let mut warnings = Vec::new();
    for fixed in &campaign.file.fixed {
        for target in &fixed.targets {
            let rows: Vec<&Point> = points.iter().filter(|p| p.target.as_deref() == Some(target.get_ref())).collect();
            if rows.len() < BLOCKS * FEWEST {
                let (count, least) = (rows.len(), BLOCKS * FEWEST);
                let message = warning!("drift-few-readings", target = target.get_ref(), count, least);
                warnings.push(message.at(campaign.place(target)));
                continue;
            }
            let blocks = rows.chunks(rows.len().div_ceil(BLOCKS));
            let middle = |block: &[&Point]| middle(&block.iter().map(|p| p.xyz_mm).collect::<Vec<_>>());
            let middles: Vec<(u32, u32, Vector)> =
                blocks.filter_map(|b| Some((b.first()?.row, b.last()?.row, middle(b)?))).collect();
            let apart = |i: usize, j: usize| norm(minus(middles[i].2, middles[j].2));
            let pairs = (0..middles.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
            let Some((i, j)) = pairs.max_by(|a, b| apart(a.0, a.1).total_cmp(&apart(b.0, b.1))) else { continue };
            if apart(i, j) > fixed.drift_mm {
                let ((a, b, _), (c, d, _)) = (middles[i], middles[j]);
                let (moved_mm, limit_mm) = (apart(i, j), fixed.drift_mm);
                let message = warning!(
                    "reference-drifts",
                    target = target.get_ref(),
                    first = format!("{a}-{b}"),
                    second = format!("{c}-{d}"),
                    moved_mm,
                    limit_mm
                );
                warnings.push(message.to_decide().at(campaign.place(target)));
            }
        }
    }
    warnings
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::catalogue::IntoArgument;
    use etalon_formats::Stated;

    fn point(row: i64, name: &str, pose: Option<i64>, xyz_mm: Vector) -> Point {
        let target = pose.map(|_| name.to_owned());
        let stated = Stated {
            target: target.as_deref().map(Into::into),
            pose: pose.map(etalon_base::pose_name::PoseName::from),
            cycle: pose,
            ..Stated::default()
        };
        let (row, label) = (row as u32, name.into());
        Point { row, line: row, label, xyz_mm, more: stated.boxed(), ..Point::default() }
    }

    fn campaign(more: &str) -> Campaign {
        let folder =
            std::path::PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap()).join("samples/prexyt-cmm");
        let copy = tempfile::tempdir().unwrap();
        std::fs::copy(folder.join("robot.toml"), copy.path().join("robot.toml")).unwrap();
        let text = std::fs::read_to_string(folder.join("campaign.toml")).unwrap();
        std::fs::write(copy.path().join("campaign.toml"), text + more).unwrap();
        Campaign::read(copy.path()).unwrap()
    }

    /// `true` if the only message is about this row, its point and the other point.
    fn is_at(found: &[Message], row: i64, point: &str, other: &str) -> bool {
        found.len() == 1 && found[0].is("point-lies-at-another", &[("row", &row), ("point", &point), ("other", &other)])
    }

    #[test]
    fn a_target_that_lies_where_another_is_in_the_same_pose_is_reported_and_which_one_it_is() {
        let mut points = Vec::new();
        for pose in 1..=9 {
            let moves = [100.0 * pose as f64, 0.0, 7.0];
            points.push(point(pose, "SMR_3", Some(pose), moves));
            let wrong = pose == 5;
            points.push(point(
                pose,
                "base_3",
                Some(pose),
                if wrong { [500.01, 0.0, 7.0] } else { [-3.0, 0.001 * pose as f64, 0.0] },
            ));
        }
        let found = misplaced(&campaign(""), &points);
        assert!(is_at(&found, 5, "base_3", "SMR_3"), "{found:?}");
        points[9].xyz_mm = [-3.0, 0.0, 0.0];
        assert!(misplaced(&campaign(""), &points).is_empty());
    }

    #[test]
    fn a_label_far_from_the_rows_of_its_name_and_at_another_point_is_reported() {
        let at = |x| [x, 1.0, 2.0];
        let points = [
            point(1, "Slave", None, at(0.0)),
            point(2, "D", None, at(500.0)),
            point(3, "Slave", None, at(500.03)),
            point(4, "D", None, at(500.02)),
            // two names of one point that never part are not a mistake
            point(5, "nominal", None, at(900.0)),
            point(6, "measured", None, at(900.05)),
        ];
        let found = misplaced(&campaign(""), &points);
        assert!(is_at(&found, 3, "Slave", "D"), "{found:?}");
    }

    #[test]
    fn places_that_are_measured_again_under_another_label_are_not_a_mistake() {
        let run = |first: i64, label, shift: f64| {
            (0..8).map(move |i| point(first + i, label, None, [40.0 * i as f64 + shift, 1.0, 2.0]))
        };
        let mut points: Vec<Point> =
            run(1, "shaft-1", 0.0).chain(run(9, "shaft-2", 0.01)).chain(run(17, "shaft-3", 0.02)).collect();
        assert!(misplaced(&campaign(""), &points).is_empty());
        points.push(point(25, "D", None, [700.0, 0.0, 0.0]));
        points.push(point(26, "shaft-2", None, [700.0, 0.0, 0.05]));
        let found = misplaced(&campaign(""), &points);
        assert!(is_at(&found, 26, "shaft-2", "D"), "{found:?}");
    }

    /// Synthetic: two scans of one surface cross each other everywhere.
    #[test]
    fn scans_of_one_surface_are_not_a_mistake() {
        let mut noise = etalon_base::noise::Noise::new(5, 1);
        let mut scan = |first: i64, label| -> Vec<Point> {
            let place = |noise: &mut etalon_base::noise::Noise| [noise.uniform(3.0), noise.uniform(3.0), 0.0];
            (0..400).map(|i| point(first + i, label, None, place(&mut noise))).collect()
        };
        let mut points = [scan(1, "scan-1"), scan(401, "scan-2")].concat();
        assert!(misplaced(&campaign(""), &points).is_empty());
        // a ball beside them is found as before
        points.extend((0..3).map(|i| point(801 + i, "D", None, [700.0, 0.0, 0.0])));
        points.extend((0..3).map(|i| point(811 + i, "E", None, [800.0, 0.0, 0.0])));
        points.push(point(821, "E", None, [700.0, 0.0, 0.05]));
        let found = misplaced(&campaign(""), &points);
        assert!(is_at(&found, 821, "E", "D"), "{found:?}");
    }

    #[test]
    fn targets_that_drift_are_reported_with_their_rows() {
        let campaign = campaign("[[fixed]]\ntargets = [\"N\"]\ndrift_mm = 0.02\n");
        let rows = |slope: f64| -> Vec<Point> {
            let place = |i: i64| [slope * i as f64, if i % 7 == 0 { 5.0 } else { 0.0 }, 0.0];
            (1..=100).map(|i| point(i, "N", Some(i), place(i))).collect()
        };
        let found = drifting(&campaign, &rows(0.001));
        assert_eq!(found.len(), 1, "{found:?}");
        let drifts: [(&str, &dyn IntoArgument); 3] = [("first", &"1-10"), ("second", &"91-100"), ("limit_mm", &0.02)];
        assert!(found[0].is("reference-drifts", &drifts), "{found:?}");
        assert!(found[0].arguments["moved_mm"] == 0.09, "{found:?}");
        assert!(drifting(&campaign, &rows(0.0001)).is_empty());
        assert!(drifting(&campaign, &rows(0.001)[..20])[0].is("drift-few-readings", &[("count", &20), ("least", &30)]));
    }
}
