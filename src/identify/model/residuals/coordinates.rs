//! Residuals of measured coordinates of targets, or of the pose of a platform.

use super::columns::Columns;
use crate::Observation;
use etalon_robots::{Parametrised, Platform, Robot, State};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;

/// Observations that are evaluated by one thread.
pub(super) const CHUNK: usize = 32;

/// Measured targets of a robot; their rows come first.
pub(super) struct Coordinates<'a> {
    pub robot: &'a dyn Robot,
    pub observations: &'a [Observation],
    /// Loads at each observation; empty if bending is not modelled.
    pub loads: Arc<[Vec<f64>]>,
    /// Platform whose pose is compared; `None` if coordinates of targets are.
    pub platform: Option<&'a dyn Platform>,
    /// Number of rows of each observation.
    pub rows: Vec<usize>,
    /// Scale (mm) of the residuals.
    pub unit: f64,
}

impl<'a> Coordinates<'a> {
    /// Number of rows.
    pub fn count(&self) -> usize {
        self.rows.iter().sum()
    }

    /// Each observation of a range with its state.
    pub fn observed(&self, range: Range<usize>) -> impl Iterator<Item = (&'a Observation, State<'_>)> + Send {
        range.map(|k| {
            let o = &self.observations[k];
            (o, State { joints: &o.joints, loads: self.loads.get(k).map_or(&[][..], Vec::as_slice) })
        })
    }

    /// Cuts `out` (`width` numbers a row) into the parts of each chunk of observations.
    fn chunks<'o>(
        &self,
        mut out: &'o mut [f64],
        width: usize,
    ) -> Vec<(impl Iterator<Item = (&'a Observation, State<'_>)> + Send, &'o mut [f64])> {
        let mut parts = Vec::new();
        for (k, rows) in self.rows.chunks(CHUNK).enumerate() {
            let (part, rest) = out.split_at_mut(rows.iter().sum::<usize>() * width);
            out = rest;
            parts.push((self.observed(k * CHUNK..k * CHUNK + rows.len()), part));
        }
        parts
    }

    /// Residuals with all parameters, before whitening.
    pub fn residuals(&self, all: &[f64], r: &mut [f64]) {
        let (dimension, robot) = (self.robot.dimension(), self.robot.parametrised(all));
        self.chunks(r, 1).into_par_iter().for_each(|(observations, mut r)| {
            let mut predicted = vec![0.0; dimension * self.robot.targets().len()];
            for (o, state) in observations {
                if let Some(platform) = self.platform {
                    if let Some(pair) = both(o) {
                        let (here, rest) = r.split_at_mut(3);
                        here.copy_from_slice(&platform.pose_error(all, &o.joints, pair));
                        r = rest;
                    }
                    continue;
                }
                robot.positions(state, &mut predicted);
                for (predicted, measured) in predicted.chunks_exact(dimension).zip(&o.targets) {
                    let Some(measured) = measured else { continue };
                    let (here, rest) = r.split_at_mut(dimension);
                    for ((r, p), m) in here.iter_mut().zip(predicted).zip(measured) {
                        *r = (p - m) / self.unit;
                    }
                    r = rest;
                }
            }
        });
    }

    /// Derivatives with respect to the free parameters, before whitening.
    pub fn jacobian(&self, all: &[f64], columns: Columns, jacobian: &mut [f64]) {
        let robot = self.robot.parametrised(all);
        if self.robot.free_base().is_some() {
            return self.spatial_jacobian(robot.as_ref(), columns, jacobian);
        }
        let (n, free, dimension) = (all.len(), columns.free, self.robot.dimension());
        self.chunks(jacobian, free.len()).into_par_iter().for_each(|(observations, mut out)| {
            let mut full = vec![0.0; dimension * self.robot.targets().len() * n];
            let take = |rows: &[f64], out: &mut [f64]| {
                for (row, out) in rows.chunks_exact(n).zip(out.chunks_exact_mut(free.len())) {
                    for (&i, out) in free.iter().zip(out) {
                        *out = row[i] / self.unit;
                    }
                }
            };
            for (o, state) in observations {
                if let Some(platform) = self.platform {
                    if let Some(pair) = both(o) {
                        let (here, rest) = out.split_at_mut(3 * free.len());
                        take(&platform.pose_error_jacobian(all, &o.joints, pair), here);
                        out = rest;
                    }
                    continue;
                }
                robot.jacobian(state, &mut full);
                for (rows, measured) in full.chunks_exact(dimension * n).zip(&o.targets) {
                    if measured.is_some() {
                        let (here, rest) = out.split_at_mut(dimension * free.len());
                        take(rows, here);
                        out = rest;
                    }
                }
            }
        });
    }

    /// Derivatives of the coordinates of targets of a spatial robot.
    fn spatial_jacobian(&self, robot: &dyn Parametrised, columns: Columns, jacobian: &mut [f64]) {
        let (width, places) = (columns.width(), columns.places(self.robot.parameters().len()));
        self.chunks(jacobian, width).into_par_iter().for_each(|(observations, mut out)| {
            out.fill(0.0);
            let mut first = vec![0; self.robot.targets().len()];
            for (o, state) in observations {
                let measured: Vec<usize> = (0..o.targets.len()).filter(|&k| o.targets[k].is_some()).collect();
                measured.iter().enumerate().for_each(|(k, &target)| first[target] = 3 * k * width);
                let (here, rest) = out.split_at_mut(3 * measured.len() * width);
                robot.target_derivatives(state, &measured, &mut |target, parameter, moved| {
                    let Some(place) = places[parameter] else { return };
                    let (x, rest) = here[first[target]..].split_at_mut(width);
                    let (y, z) = rest.split_at_mut(width);
                    x[place] += moved[0] / self.unit;
                    y[place] += moved[1] / self.unit;
                    z[place] += moved[2] / self.unit;
                });
                out = rest;
            }
        });
    }

    /// For pose residuals: sensitivity of each residual to the coordinates of both targets, three
    /// rows of four per pose.
    pub fn target_sensitivities(&self, all: &[f64]) -> Option<Vec<[[f64; 4]; 3]>> {
        let platform = self.platform?;
        let sensitivity = |o: &Observation| both(o).map(|pair| platform.pose_error_by_targets(all, pair));
        Some(self.observations.iter().filter_map(sensitivity).collect())
    }
}

/// Both targets in the plane, if both were measured.
fn both(o: &Observation) -> Option<[[f64; 2]; 2]> {
    match o.targets[..] {
        [Some(k), Some(l)] => Some([[k[0], k[1]], [l[0], l[1]]]),
        _ => None,
    }
}
