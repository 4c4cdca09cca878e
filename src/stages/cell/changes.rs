//! Changes of how poses are read that may explain them.

use super::readings::WrittenPoses;
use crate::stages::orientations::readings;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Pose;

/// Units of lengths that are taken for millimetres: factor and name.
pub(super) const UNITS: [(f64, &str); 2] = [(1000.0, "m"), (25.4, "inch")];

/// Poses after a change of their orientations, with its description. `side` is `flange` or
/// `measured`.
pub(super) fn orientation_changes(written: &WrittenPoses, side: &str) -> Vec<(Phrase, Vec<Pose>)> {
    let poses = written.poses();
    let placed = |(what, bodies): (Phrase, Vec<Option<Pose>>)| {
        let all = poses.iter().zip(bodies).map(|(p, body)| Some(Pose { translation_mm: p.translation_mm, ..body? }));
        Some((phrase!("cell-change-orientations", side, what), all.collect::<Option<Vec<Pose>>>()?))
    };
    let mut all: Vec<_> = readings(&written.orientations, written.order).into_iter().filter_map(placed).collect();
    all.push((phrase!("cell-change-inverse", side), poses.iter().map(Pose::inverse).collect()));
    all
}

/// Poses with positions in another unit.
pub(super) fn unit_changes(written: &WrittenPoses, side: &str) -> Vec<(Phrase, Vec<Pose>)> {
    let scaled = |factor: f64| {
        let scale = |p: Pose| Pose { translation_mm: p.translation_mm.map(|v| v * factor), ..p };
        written.poses().into_iter().map(scale).collect()
    };
    UNITS.iter().map(|(factor, unit)| (phrase!("cell-change-unit", side, unit = *unit), scaled(*factor))).collect()
}

/// Poses with two coordinates of the positions swapped, or one with the other sign.
pub(super) fn axis_changes(written: &WrittenPoses, side: &str) -> Vec<(Phrase, Vec<Pose>)> {
    const NAMES: [&str; 3] = ["x", "y", "z"];
    let poses = written.poses();
    let with = |change: &dyn Fn(&mut [f64; 3])| {
        let changed = |p: &Pose| {
            let mut translation_mm = p.translation_mm;
            change(&mut translation_mm);
            Pose { translation_mm, ..*p }
        };
        poses.iter().map(changed).collect::<Vec<_>>()
    };
    let pairs = [(0, 1), (1, 2), (0, 2)].into_iter().map(|(a, b)| {
        let change = phrase!("cell-change-axes", side, first = NAMES[a], second = NAMES[b]);
        (change, with(&|p| p.swap(a, b)))
    });
    let signs = (0..3).map(|k| (phrase!("cell-change-sign", side, axis = NAMES[k]), with(&|p| p[k] = -p[k])));
    pairs.chain(signs).collect()
}
