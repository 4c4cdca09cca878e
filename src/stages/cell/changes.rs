//! Changes of how poses are read that may explain them.

use super::readings::WrittenPoses;
use crate::stages::orientations::{AngleOrder, Form, Written};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Pose;

const DEG: f64 = std::f64::consts::PI / 180.0;

/// Units of lengths that are taken for millimetres: factor and name.
pub(super) const UNITS: [(f64, &str); 2] = [(1000.0, "m"), (25.4, "inch")];

/// Poses after a change, with its description. `side` is `flange` or `measured`.
pub(super) fn orientation_changes(written: &WrittenPoses, side: &str) -> Vec<(Phrase, Vec<Pose>)> {
    let mut all: Vec<(Phrase, Vec<Pose>)> = Vec::new();
    let mut add = |change: Phrase, order: Option<AngleOrder>, of: &dyn Fn(&Written) -> Written| {
        all.extend(written.poses_with(order, of).map(|poses| (change, poses)));
    };
    let scaled = |factor: f64| move |o: &Written| Written { numbers: o.numbers.map(|v| v * factor), ..*o };
    let form = written.orientations.first().map_or(Form::None, |o| o.form);
    let angular = matches!(form, Form::Angles | Form::Vector);
    if angular {
        // numbers are in radians here, by the unit of their columns
        add(phrase!("cell-change-radians", side), written.order, &scaled(1.0 / DEG));
        add(phrase!("cell-change-degrees", side), written.order, &scaled(DEG));
    }
    if form == Form::Angles {
        for order in AngleOrder::all().into_iter().filter(|order| Some(*order) != written.order) {
            add(phrase!("cell-change-order", side, order = order.to_string()), Some(order), &|o| *o);
        }
        add(phrase!("cell-change-vector", side), None, &|o| Written { form: Form::Vector, ..*o });
    }
    if form == Form::Vector {
        for order in AngleOrder::all() {
            let change = phrase!("cell-change-angles", side, order = order.to_string());
            add(change, Some(order), &|o| Written { form: Form::Angles, ..*o });
        }
    }
    if form == Form::Quaternion {
        add(phrase!("cell-change-scalar-last", side), written.order, &|o| {
            let [x, y, z, w, ..] = o.numbers;
            Written { numbers: [w, x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0], ..*o }
        });
    }
    let poses = written.poses();
    let turned_back = |p: &Pose| Pose { translation_mm: p.translation_mm, ..p.inverse() };
    all.push((phrase!("cell-change-turned-back", side), poses.iter().map(turned_back).collect()));
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
