//! Errors at held-out poses with and without a field that is chosen again from the others.

use super::choose::{Chosen, choose};
use super::rows::{Fit, Rows};
use super::{JointField, field, joint_covariance};
use etalon_base::noise::Noise;
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::{mean, median, variance};
use etalon_robots::Correction;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Number of parts into which the poses are divided.
const FOLDS: usize = 5;
/// Seed of the division.
const SEED: u64 = 45;
/// Gain over its standard uncertainty of a significant field: 99 % of a Gaussian distribution, one
/// side.
const PROVEN: f64 = 2.326;
/// Error of a pose, relative to the median, beyond which its readings are suspect.
const FAR: f64 = 8.0;
/// Minimum and maximum factor of the field's standard uncertainty.
const FACTORS: [f64; 2] = [0.25, 10.0];
/// Number of bisections between these factors.
const BISECTIONS: usize = 30;

/// Errors at held-out poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeldOut {
    /// Each pose with its root mean square position error before and after (mm).
    pub poses: Vec<(PoseName, [f64; 2])>,
    /// Root mean square position error before and after (mm).
    pub rms_mm: [f64; 2],
    /// Gain of the mean square error over its standard uncertainty.
    pub gain_over_u: f64,
    /// Share of coordinates within 1.96 predicted standard uncertainties, with the uncertainty of
    /// the field multiplied by the factor.
    pub coverage: f64,
    /// Factor of the field's standard uncertainty with which the mean square of coordinates over
    /// their predicted standard uncertainties is 1.
    pub factor: f64,
}

impl HeldOut {
    /// `true` if the gain is significant (1 %).
    pub fn is_proven(&self) -> bool {
        self.gain_over_u > PROVEN
    }

    /// Returns the pose whose error with the field is far above the errors of the others, with this
    /// error (mm): a wrong reading. A field describes errors that neighbouring poses share.
    pub fn suspect(&self) -> Option<(PoseName, f64)> {
        let median_mm = median(self.poses.iter().map(|(_, [_, after])| *after))?;
        let worst = self.poses.iter().max_by(|a, b| a.1[1].total_cmp(&b.1[1]))?;
        (worst.1[1] > FAR * median_mm).then_some((worst.0, worst.1[1]))
    }
}

/// Errors of the coordinates of a pose before and after, and the variances of prediction and
/// reading after.
struct Pose {
    name: PoseName,
    coordinates: Vec<[f64; 4]>,
    readings: f64,
}

/// Holds each fifth of the poses out; `None` if the others do not determine the parameters.
pub(super) fn hold_out(rows: &Rows) -> Option<HeldOut> {
    let mut order: Vec<usize> = (0..rows.poses.len()).collect();
    Noise::new(SEED, 0).shuffle(&mut order);
    let fold = |part: usize| -> Option<Vec<Pose>> {
        let is_out = |index: usize| order.iter().skip(part).step_by(FOLDS).any(|&i| i == index);
        let (out, kept): (Vec<usize>, Vec<usize>) = (0..rows.poses.len()).partition(|&i| is_out(i));
        let mut some: Vec<usize> = kept.iter().flat_map(|&i| rows.poses[i].1.iter().copied()).collect();
        some.sort_unstable();
        let fit = rows.fit(&some, rows.deviation_mm)?;
        let chosen = choose(rows, &fit, &some).ok();
        Some(out.iter().map(|&i| judged(rows, &fit, chosen.as_ref(), i)).collect())
    };
    let all = (0..FOLDS).into_par_iter().map(fold).collect::<Option<Vec<_>>>()?;
    let mut all: Vec<Pose> = all.into_iter().flatten().filter(|p| !p.coordinates.is_empty()).collect();
    all.sort_by_key(|a| a.name);
    Some(summary(&all))
}

fn summary(all: &[Pose]) -> HeldOut {
    let square = |p: &Pose, of: usize| p.coordinates.iter().map(|c| c[of].powi(2)).sum::<f64>() / p.readings;
    let gains: Vec<f64> = all.iter().map(|p| square(p, 0) - square(p, 1)).collect();
    let u = (variance(&gains) / gains.len() as f64).sqrt();
    let rms = |of: usize| mean(all.iter().map(|p| square(p, of))).sqrt();
    let coordinates: Vec<[f64; 4]> = all.iter().flat_map(|p| p.coordinates.iter().copied()).collect();
    let factor = factor(&coordinates);
    let ratios = ratios(&coordinates, factor);
    let within = ratios.iter().filter(|r| r.abs() <= 1.96).count();
    HeldOut {
        poses: all.iter().map(|p| (p.name, [square(p, 0).sqrt(), square(p, 1).sqrt()])).collect(),
        rms_mm: [rms(0), rms(1)],
        gain_over_u: if u > 0.0 { mean(gains.iter().copied()) / u } else { 0.0 },
        coverage: within as f64 / ratios.len().max(1) as f64,
        factor,
    }
}

/// Errors over their standard uncertainties, with the uncertainty of the prediction multiplied by a
/// factor.
fn ratios(all: &[[f64; 4]], factor: f64) -> Vec<f64> {
    all.iter().map(|[_, after, field, white]| after / (factor.powi(2) * field + white).sqrt()).collect()
}

/// Factor with which the mean square ratio is 1, by bisection of its logarithm.
fn factor(all: &[[f64; 4]]) -> f64 {
    let [mut low, mut high] = FACTORS;
    for _ in 0..BISECTIONS {
        let middle = (low * high).sqrt();
        let large = mean(ratios(all, middle).iter().map(|r| r * r)) > 1.0;
        *if large { &mut low } else { &mut high } = middle;
    }
    (low * high).sqrt()
}

/// Errors of one pose that the fit has not seen.
fn judged(rows: &Rows, fit: &Fit, chosen: Option<&Chosen>, index: usize) -> Pose {
    let (name, own) = &rows.poses[index];
    // targets that the other poses do not show have no prediction
    let known =
        |&&row: &&usize| (0..rows.free.len()).all(|k| rows.by_parameter[(row, k)] == 0.0 || fit.columns.contains(&k));
    let own: Vec<usize> = own.iter().filter(known).copied().collect();
    let x = DMatrix::from_fn(own.len(), fit.columns.len(), |i, k| rows.by_parameter[(own[i], fit.columns[k])]);
    let change = &x * &fit.change;
    let before: Vec<f64> = own.iter().zip(change.iter()).map(|(&row, c)| rows.residuals[row] - c).collect();
    let white = fit.residuals.norm_squared() / fit.degrees;
    let (means, variances) = match chosen {
        None => {
            let of = |i: usize| [white * (x.row(i) * &fit.inverse * x.row(i).transpose())[(0, 0)], white];
            (change.as_slice().to_vec(), (0..own.len()).map(of).collect())
        }
        Some(chosen) => predicted(rows, chosen, &change, &own, &x),
    };
    let coordinate = |i: usize| [before[i], rows.residuals[own[i]] - means[i], variances[i][0], variances[i][1]];
    let readings = own.len() as f64 / rows.dimension as f64;
    Pose { name: *name, coordinates: (0..own.len()).map(coordinate).collect(), readings }
}

/// Predicted residuals and their variances with the field at rows that it has not seen.
fn predicted(
    rows: &Rows,
    chosen: &Chosen,
    change: &DVector<f64>,
    own: &[usize],
    x: &DMatrix<f64>,
) -> (Vec<f64>, Vec<[f64; 2]>) {
    let Chosen { bases, solved, fit, follow } = chosen;
    let field: JointField = field(rows, chosen);
    let covariance = joint_covariance(fit, solved, follow);
    let mut functions = DMatrix::zeros(own.len(), solved.weights.len());
    let mut first = 0;
    let mut unknown = vec![0.0; own.len()];
    for (basis, prior) in bases.iter().zip(&solved.priors) {
        let at = basis.at_observations(rows);
        functions.columns_mut(first, basis.len()).copy_from(&rows.columns(basis.joint, &at, own));
        for (i, &row) in own.iter().enumerate() {
            let shown = at.row(rows.observation[row]).norm_squared();
            let joints = rows.unscaled(rows.observation[row]);
            let outside = (1.0 - field.share(&joints)).powi(2);
            let derivative = rows.by_joint[(row, basis.joint)];
            unknown[i] += (prior * derivative).powi(2) * ((1.0 - shown).max(0.0) + outside);
        }
        first += basis.len();
    }
    let mean = &functions * &solved.weights + x * (&fit.change - follow * &solved.weights);
    let mut rows_of = DMatrix::zeros(own.len(), x.ncols() + functions.ncols());
    rows_of.columns_mut(0, x.ncols()).copy_from(x);
    rows_of.columns_mut(x.ncols(), functions.ncols()).copy_from(&functions);
    let of = |i: usize| {
        let row = rows_of.row(i);
        [(row * &covariance * row.transpose())[(0, 0)] + unknown[i], solved.white]
    };
    let share = |i: usize| field.share(&rows.unscaled(rows.observation[own[i]]));
    let faded = |i: usize| share(i) * mean[i] + (1.0 - share(i)) * change[i];
    ((0..own.len()).map(faded).collect(), (0..own.len()).map(of).collect())
}
