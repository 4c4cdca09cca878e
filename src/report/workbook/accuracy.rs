//! Errors before and after: by set of poses, by pose, and every one of them.

use super::sheet::{Cell, Field, Sheet};
use crate::document::{AccuracyDocument, AccuracySet, ErrorStatistics, PointError};
use crate::report::points::{after_mm, before_mm};
use crate::report::tables::by_pose;

pub(super) fn sheets(accuracy: &AccuracyDocument, errors: &[PointError]) -> [Sheet; 3] {
    [sets(accuracy), poses(errors), residuals(errors)]
}

fn sets(accuracy: &AccuracyDocument) -> Sheet {
    let rows: Vec<(&AccuracySet, &ErrorStatistics)> =
        accuracy.sets.iter().flat_map(|s| s.errors.iter().map(move |e| (s, e))).collect();
    Sheet::of(
        "Errors",
        &rows,
        &[
            ("set", "", |r| r.0.name.as_str().into()),
            ("poses", "", |r| r.0.poses.into()),
            ("errors", "", |r| r.0.count.into()),
            ("quantity", "", |r| r.1.quantity.as_str().into()),
            ("unit", "", |r| r.1.unit.as_str().into()),
            ("before, mean", "", |r| r.1.before.mean.into()),
            ("before, RMS", "", |r| r.1.before.rms.into()),
            ("before, 95 %", "", |r| r.1.before.p95.into()),
            ("before, max", "", |r| r.1.before.max.into()),
            ("after, mean", "", |r| r.1.after.mean.into()),
            ("after, RMS", "", |r| r.1.after.rms.into()),
            ("after, 95 %", "", |r| r.1.after.p95.into()),
            ("after, max", "", |r| r.1.after.max.into()),
        ],
    )
}

/// Set, pose, and its errors.
type OfPose<'a> = ((&'a str, i64), Vec<&'a PointError>);

fn poses(errors: &[PointError]) -> Sheet {
    let rows: Vec<OfPose> = by_pose(errors).into_iter().collect();
    let fields: &[Field<OfPose>] = &[
        ("set", "", |r| r.0.0.into()),
        ("pose", "", |r| r.0.1.into()),
        ("errors", "", |r| r.1.len().into()),
        ("position before, mean", "mm", |r| mean(&r.1, before_mm)),
        ("position before, max", "mm", |r| largest(&r.1, |p| Some(before_mm(p)))),
        ("position after, mean", "mm", |r| mean(&r.1, after_mm)),
        ("position after, max", "mm", |r| largest(&r.1, |p| Some(after_mm(p)))),
        ("orientation before, max", "deg", |r| largest(&r.1, |p| p.before_deg)),
        ("orientation after, max", "deg", |r| largest(&r.1, |p| p.after_deg)),
    ];
    Sheet::of("Errors by pose", &rows, fields)
}

fn mean(errors: &[&PointError], size: fn(&PointError) -> f64) -> Cell {
    (errors.iter().map(|p| size(p)).sum::<f64>() / errors.len() as f64).into()
}

fn largest(errors: &[&PointError], size: fn(&PointError) -> Option<f64>) -> Cell {
    // f64::max would let what is not a number vanish
    errors.iter().filter_map(|p| size(p)).map(f64::abs).max_by(f64::total_cmp).into()
}

fn residuals(errors: &[PointError]) -> Sheet {
    Sheet::of(
        "Residuals",
        errors,
        &[
            ("set", "", |p| p.set.as_str().into()),
            ("pose", "", |p| p.pose.into()),
            ("cycle", "", |p| p.cycle.into()),
            ("target", "", |p| p.target.as_str().into()),
            ("x", "mm", |p| p.at_mm[0].into()),
            ("y", "mm", |p| p.at_mm[1].into()),
            ("z", "mm", |p| p.at_mm[2].into()),
            ("before, x", "mm", |p| p.before_mm[0].into()),
            ("before, y", "mm", |p| p.before_mm[1].into()),
            ("before, z", "mm", |p| p.before_mm[2].into()),
            ("after, x", "mm", |p| p.after_mm[0].into()),
            ("after, y", "mm", |p| p.after_mm[1].into()),
            ("after, z", "mm", |p| p.after_mm[2].into()),
            ("before, orientation", "deg", |p| p.before_deg.into()),
            ("after, orientation", "deg", |p| p.after_deg.into()),
        ],
    )
}
