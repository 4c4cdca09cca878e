//! Errors of a model that its readings at one pose share.
//!
//! What a model lacks acts alike each time a pose is measured, and similarly on all targets of the
//! pose. A calibration gives its size. The whitened readings of a pose then have the covariance
//! I + V Vᵀ, with a column of V for each shared error. I + (1 / √(1 + v²) − 1) v vᵀ / v² whitens
//! one column; the others follow one by one.

use crate::model::residuals::Residuals;
use crate::{Observation, Settings};
use etalon_base::pose_name::PoseName;
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Standard deviations of the errors of a calibrated model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Misfit {
    /// Standard deviation of a coordinate of a target (mm).
    pub coordinate_mm: f64,
    /// Part of it that differs between targets of one pose (mm); without it, each target may err by
    /// itself, or all alike.
    pub between_targets_mm: Option<f64>,
    /// Standard deviation for each condition of the settings (mm or rad).
    pub conditions: Vec<f64>,
}

impl Misfit {
    /// Standard deviations (mm) of the error that several targets of a pose share, and of the error
    /// of each target.
    fn parts_mm(&self) -> [f64; 2] {
        let all = self.coordinate_mm;
        let of_target = |u: f64| [(all.powi(2) - u.powi(2)).max(0.0).sqrt(), u];
        self.between_targets_mm.map_or([all, all], of_target)
    }
}

/// Whitening of readings whose errors are partly shared.
pub(crate) struct Whitening(Vec<Group>);

/// Readings that share errors.
struct Group {
    rows: Vec<usize>,
    /// Unit vector of each shared error, and by which factor its share of the readings changes.
    errors: Vec<(Vec<f64>, f64)>,
}

impl Whitening {
    /// Whitening of the rows of `problem`, which has no platform.
    pub fn new(
        misfit: &Misfit,
        problem: &Residuals,
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
    ) -> Self {
        let mut groups = Vec::new();
        if misfit.coordinate_mm > 0.0 {
            groups = coordinate_groups(misfit, problem, robot, observations);
        }
        groups.extend(condition_groups(&misfit.conditions, problem.coordinate_count(), settings));
        Self(groups)
    }

    /// Whitens rows of `width` numbers.
    pub fn whiten(&self, rows: &mut [f64], width: usize) {
        self.0.iter().for_each(|group| group.whiten(rows, width));
    }
}

impl Group {
    /// Readings `rows` with these shared errors.
    fn new(rows: Vec<usize>, errors: impl IntoIterator<Item = Vec<f64>>) -> Self {
        let own: Vec<usize> = (0..rows.len()).collect();
        let mut group = Self { rows: own, errors: Vec::new() };
        for mut error in errors {
            group.whiten(&mut error, 1);
            let square: f64 = error.iter().map(|v| v * v).sum();
            if square > 0.0 {
                error.iter_mut().for_each(|v| *v /= square.sqrt());
                group.errors.push((error, 1.0 / (1.0 + square).sqrt() - 1.0));
            }
        }
        Self { rows, ..group }
    }

    fn whiten(&self, all: &mut [f64], width: usize) {
        let mut along = vec![0.0; width];
        for (error, change) in &self.errors {
            along.fill(0.0);
            for (row, v) in self.rows.iter().zip(error) {
                along.iter_mut().zip(&all[row * width..][..width]).for_each(|(sum, x)| *sum += v * x);
            }
            for (row, v) in self.rows.iter().zip(error) {
                all[row * width..][..width].iter_mut().zip(&along).for_each(|(x, along)| *x += change * v * along);
            }
        }
    }
}

/// Groups of coordinates: the targets of each pose.
fn coordinate_groups(
    misfit: &Misfit,
    problem: &Residuals,
    robot: &dyn Robot,
    observations: &[Observation],
) -> Vec<Group> {
    let (d, [of_pose_mm, of_target_mm]) = (robot.dimension(), misfit.parts_mm());
    let mut poses: BTreeMap<PoseName, Vec<(usize, usize)>> = BTreeMap::new();
    let mut row = 0;
    for o in observations {
        for (target, _) in o.targets.iter().enumerate().filter(|(_, at)| at.is_some()) {
            poses.entry(o.pose).or_default().push((target, row));
            row += d;
        }
    }
    // an error of 1 mm along each axis, whitened like the readings
    let one = |at: usize| if at.is_multiple_of(d + 1) { 1.0 / problem.unit } else { 0.0 };
    let mut units: Vec<f64> = (0..row).flat_map(|_| 0..d).enumerate().map(|(i, k)| one((i / d) % d * d + k)).collect();
    problem.whiten(&mut units, d);
    let group = |readings: Vec<(usize, usize)>| {
        let mut targets: Vec<usize> = readings.iter().map(|(target, _)| *target).collect();
        targets.sort_unstable();
        targets.dedup();
        let rows: Vec<usize> = readings.iter().flat_map(|(_, first)| *first..first + d).collect();
        let error = |size_mm: f64, axis: usize, of: &dyn Fn(usize) -> bool| -> Vec<f64> {
            let of_reading = |(target, first): &(usize, usize)| {
                let size = if of(*target) { size_mm } else { 0.0 };
                (*first..first + d).map(|row| size * units[row * d + axis]).collect::<Vec<f64>>()
            };
            readings.iter().flat_map(of_reading).collect()
        };
        let mut errors = Vec::new();
        match targets[..] {
            [_] => errors.extend((0..d).map(|axis| error(misfit.coordinate_mm, axis, &|_| true))),
            _ => {
                let each = targets.iter().flat_map(|own| (0..d).map(move |axis| (*own, axis)));
                errors.extend(each.map(|(own, axis)| error(of_target_mm, axis, &|target| target == own)));
                errors.extend((0..d).map(|axis| error(of_pose_mm, axis, &|_| true)));
            }
        }
        Group::new(rows, errors)
    };
    poses.into_values().map(group).collect()
}

/// Groups of conditions: repeats of a pose.
fn condition_groups(sizes: &[f64], first: usize, settings: &Settings) -> Vec<Group> {
    // repeats observe a pose in the same order
    let mut numbers: BTreeMap<_, usize> = BTreeMap::new();
    let mut repeats: BTreeMap<_, Vec<(usize, usize, f64)>> = BTreeMap::new();
    let mut row = first;
    for (c, size) in settings.conditions.iter().zip(sizes) {
        let what = (c.pose, c.target, c.kind.error_kind());
        let number = numbers.entry((what, c.cycle)).or_default();
        repeats.entry((what, *number)).or_default().push((row, c.kind.rows(), size / c.standard_uncertainty));
        *number += 1;
        row += c.kind.rows();
    }
    let group = |all: Vec<(usize, usize, f64)>| {
        let rows = all.iter().flat_map(|(row, count, _)| *row..row + count).collect();
        let most = all.iter().map(|(_, count, _)| *count).max().unwrap_or(0);
        let error = |component: usize| -> Vec<f64> {
            let of = |&(_, count, size): &(usize, usize, f64)| {
                (0..count).map(move |k| if k == component { size } else { 0.0 })
            };
            all.iter().flat_map(of).collect()
        };
        Group::new(rows, (0..most).map(error))
    };
    repeats.into_values().filter(|all| all.iter().any(|one| one.2 > 0.0)).map(group).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    #[test]
    fn shared_errors_are_whitened() {
        // the covariance of five readings with one error of all and errors of two groups
        let columns = [[0.0, 0.0, 2.0, 3.0, 1.0], [1.5, 0.5, 0.0, 0.0, 0.0], [1.0, 1.0, 1.0, 2.0, 2.0]];
        let v = DMatrix::from_fn(5, 3, |i, k| columns[k][i]);
        let covariance = DMatrix::identity(5, 5) + &v * v.transpose();
        let group = Group::new((0..5).collect(), columns.map(|c| c.to_vec()));
        let mut w: Vec<f64> = DMatrix::<f64>::identity(5, 5).as_slice().to_vec();
        group.whiten(&mut w, 5);
        let w = DMatrix::from_row_slice(5, 5, &w);
        let left = &w * covariance * w.transpose() - DMatrix::<f64>::identity(5, 5);
        assert!(left.amax() < 1e-12, "{left}");
    }
}
