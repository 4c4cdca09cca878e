//! Smooth deviations of a path: run-out and harmonics of a bearing, waves of a gear, a bent guide.
//!
//! A series of deviations along the angle is noise plus a sum of harmonics whose amplitudes have a
//! prior variance (Gaussian process on a circle; Rasmussen and Williams 2006, 2.7). Variance and
//! highest harmonics come from the restricted likelihood (Patterson and Thompson 1971), averaged
//! over a grid, so that the covariance includes that they are estimated.

use super::{Sweep, SweepFit};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use std::f64::consts::{PI, TAU};

/// Highest harmonic of a turn; shorter waves are noise.
const HIGHEST: usize = 40;
/// Harmonics above which the prior amplitudes fall.
const CORNERS: [f64; 8] = [2.0, 3.0, 4.5, 6.5, 9.5, 14.0, 20.0, 30.0];
/// Harmonic above which the harmonics of a bearing fall.
const BEARING: f64 = 3.0;
/// Power of the fall (low-pass of Butterworth).
const ORDER: i32 = 10;
/// Ratios of the variances of harmonics and noise.
const RATIOS: [f64; 11] = [0.0625, 0.25, 1.0, 4.0, 16.0, 64.0, 256.0, 1024.0, 4096.0, 16384.0, 65536.0];
/// Twice the logarithm of the ratio of likelihoods from which deviations are modelled as smooth:
/// noise alone gives it once in 300 series.
const MODELLED: f64 = 10.0;
/// Ratio from which smooth deviations are reported: noise alone gives it once in 100 000
/// series.
const REPORTED: f64 = 25.0;
/// Score (standard deviations) from which the models with harmonics are computed at all.
const SUSPECT: f64 = 3.0;
/// Minimum number of values, in addition to the trend, that can show a smooth deviation.
const FEWEST: usize = 6;
/// Deviations (mm) below which a series is exact.
const EXACT_MM: f64 = 1e-7;

/// Smooth deviations of the paths of a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smooth {
    /// Root mean square of the residuals (mm).
    pub rms_mm: f64,
    /// Noise from reading to reading (mm).
    pub noise_mm: f64,
}

/// Values along an angle, and the functions of the angle that do not count as a deviation.
pub(super) struct Series {
    /// Angles (rad), in any order.
    pub angles: Vec<f64>,
    /// Values.
    pub values: DVector<f64>,
    /// Columns of the trend.
    pub trend: DMatrix<f64>,
}

/// Trend of a series with its covariance.
#[derive(Clone, Debug)]
pub(super) struct Trend {
    /// Coefficients of the columns.
    pub coefficients: DVector<f64>,
    /// Covariance of the coefficients.
    pub covariance: DMatrix<f64>,
    /// Covariance of the coefficients for unit noise alone.
    pub cofactors: DMatrix<f64>,
    /// Standard deviation of the noise.
    pub noise: f64,
    /// Effective degrees of freedom of the variance of all values.
    pub degrees_of_freedom: f64,
    /// Twice the logarithm of the ratio of the likelihoods with and without smooth deviation.
    pub evidence: f64,
}

/// One model of a series: noise with harmonics of some variance.
struct Member {
    coefficients: DVector<f64>,
    covariance: DMatrix<f64>,
    noise: f64,
    degrees_of_freedom: f64,
    restricted: f64,
    full: f64,
}

/// Products of values, trend and harmonics of a series.
struct Products {
    count: usize,
    harmonics: DMatrix<f64>,
    cross: DMatrix<f64>,
    own: DMatrix<f64>,
}

impl Products {
    /// Products with an orthonormal basis of the trend.
    fn new(series: &Series, trend: &DMatrix<f64>) -> Self {
        let count = series.angles.len();
        let highest = HIGHEST.min((count / 2).max(4));
        let basis = DMatrix::from_fn(count, 2 * highest, |i, k| {
            let angle = (1 + k / 2) as f64 * series.angles[i];
            if k % 2 == 0 { angle.cos() } else { angle.sin() }
        });
        let p = trend.ncols();
        let mut all = DMatrix::zeros(count, p + 1);
        all.view_mut((0, 0), (count, p)).copy_from(trend);
        all.set_column(p, &series.values);
        let turned = basis.transpose();
        Self { count, harmonics: &turned * &basis, cross: turned * &all, own: all.transpose() * &all }
    }

    /// Prior variances of the harmonics in units of the noise. Half of them belong to the bearing
    /// (low harmonics), half to the harmonics up to a corner. The first harmonic, which is also a
    /// shift of the axis, has the variance of the second one.
    fn variances(&self, corner: f64, ratio: f64) -> DVector<f64> {
        let up_to = |corner: f64| {
            let of = |n: f64| 1.0 / (1.0 + (n / corner).powi(ORDER));
            let all = DVector::from_fn(self.harmonics.nrows(), |k, _| of(((1 + k / 2) as f64).max(2.0)));
            let sum = all.sum();
            all / sum
        };
        (up_to(BEARING) + up_to(corner)) * ratio
    }

    /// Returns the fit with noise and harmonics of these variances; noise alone without them.
    fn member(&self, variances: Option<&DVector<f64>>) -> Option<Member> {
        let p = self.own.nrows() - 1;
        let (mut own, mut determinant) = (self.own.clone(), 0.0);
        let (mut smooth, mut squares) = (0.0, self.count as f64);
        if let Some(v) = variances {
            // Woodbury's identity, with the columns scaled to unit prior variance
            let root = v.map(f64::sqrt);
            let scaled = DMatrix::from_fn(v.len(), v.len(), |i, j| self.harmonics[(i, j)] * root[i] * root[j]);
            let factor = Cholesky::new(&scaled + DMatrix::identity(v.len(), v.len()))?;
            let mut cross = self.cross.clone();
            cross.row_iter_mut().zip(root.iter()).for_each(|(mut row, r)| row *= *r);
            own -= cross.transpose() * factor.solve(&cross);
            determinant = 2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>();
            smooth = scaled.trace() / self.count as f64;
            squares += 2.0 * scaled.trace() + scaled.norm_squared();
        }
        let normal = Cholesky::new(own.view((0, 0), (p, p)).into_owned())?;
        let right = own.view((0, p), (p, 1)).into_owned();
        let coefficients = normal.solve(&right).column(0).into_owned();
        let sum = own[(p, p)] - right.column(0).dot(&coefficients);
        let degrees = (self.count - p) as f64;
        let variance = (sum / degrees).max(f64::MIN_POSITIVE);
        let of_normal: f64 = 2.0 * log_diagonal(&normal);
        let all = self.count as f64 * (1.0 + smooth);
        Some(Member {
            covariance: normal.inverse() * variance,
            coefficients,
            noise: variance.sqrt(),
            degrees_of_freedom: (all * all / squares - p as f64).max(1.0),
            restricted: -0.5 * (degrees * variance.ln() + determinant + of_normal),
            full: -0.5 * (self.count as f64 * (sum / self.count as f64).max(f64::MIN_POSITIVE).ln() + determinant),
        })
    }

    /// `true` if the harmonics have more of the residuals than noise gives: score test of the
    /// variance of the harmonics, for each corner (Rao 1948).
    fn is_suspect(&self) -> bool {
        let p = self.own.nrows() - 1;
        let m = self.harmonics.nrows();
        let trend = self.cross.view((0, 0), (m, p));
        let of_values = self.own.view((0, p), (p, 1));
        let sum = self.own[(p, p)] - of_values.norm_squared();
        let variance = sum / (self.count - p) as f64;
        let amplitudes = self.cross.view((0, p), (m, 1)) - trend * of_values;
        let expected = &self.harmonics - trend * trend.transpose();
        let score = |corner: f64| {
            let v = self.variances(corner, 1.0);
            let found: f64 = (0..m).map(|k| v[k] * amplitudes[k] * amplitudes[k]).sum::<f64>() / variance;
            let mean: f64 = (0..m).map(|k| v[k] * expected[(k, k)]).sum();
            let pairs = (0..m).flat_map(|j| (0..m).map(move |k| (j, k)));
            let square: f64 = pairs.map(|(j, k)| v[j] * v[k] * expected[(j, k)].powi(2)).sum();
            (found - mean) / (2.0 * square).sqrt()
        };
        CORNERS.into_iter().any(|corner| score(corner) > SUSPECT)
    }

    /// Models of the grid; the first has noise alone.
    fn members(&self) -> Option<Vec<Member>> {
        let mut all = vec![self.member(None)?];
        for corner in CORNERS {
            all.extend(RATIOS.iter().filter_map(|ratio| self.member(Some(&self.variances(corner, *ratio)))));
        }
        Some(all)
    }
}

fn log_diagonal(factor: &Cholesky<f64, Dyn>) -> f64 {
    factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum()
}

impl Series {
    /// `false` if there are too few values to show a smooth deviation.
    fn is_judged(&self) -> bool {
        self.angles.len() >= self.trend.ncols() + FEWEST
    }

    /// Trend with the covariance over all models, each with the weight of its likelihood. Noise
    /// alone has the weight of all models with harmonics of one corner.
    pub(super) fn trend(&self, exact: f64) -> Option<Trend> {
        let basis = self.trend.clone().qr();
        let back = basis.r().solve_upper_triangular(&DMatrix::identity(self.trend.ncols(), self.trend.ncols()))?;
        let products = Products::new(self, &basis.q());
        let white = products.member(None)?;
        let members = match self.is_judged() && white.noise > exact && products.is_suspect() {
            true => products.members()?,
            false => vec![white],
        };
        let most = members.iter().map(|m| m.restricted).fold(f64::NEG_INFINITY, f64::max);
        let weight =
            |(i, m): (usize, &Member)| (m.restricted - most).exp() / if i == 0 { 1.0 } else { CORNERS.len() as f64 };
        let weights: Vec<f64> = members.iter().enumerate().map(weight).collect();
        let sum: f64 = weights.iter().sum();
        let each = || members.iter().zip(weights.iter().map(|w| w / sum));
        let p = self.trend.ncols();
        let (mut coefficients, mut covariance) = (DVector::zeros(p), DMatrix::zeros(p, p));
        each().for_each(|(m, w)| coefficients += &m.coefficients * w);
        for (m, w) in each() {
            let off = &m.coefficients - &coefficients;
            covariance += (&m.covariance + &off * off.transpose()) * w;
        }
        let mean = |of: &dyn Fn(&Member) -> f64| each().map(|(m, w)| w * of(m)).sum::<f64>();
        Some(Trend {
            noise: mean(&|m| m.noise * m.noise).sqrt(),
            degrees_of_freedom: mean(&|m| m.degrees_of_freedom),
            evidence: 2.0 * (most - members[0].restricted),
            coefficients: &back * coefficients,
            covariance: &back * covariance * back.transpose(),
            cofactors: &back * back.transpose(),
        })
    }

    /// Largest logarithm of the likelihood over all models.
    pub(super) fn likelihood(&self) -> Option<f64> {
        // the noise of exact values is rounding, which no model explains
        if self.values.norm() <= EXACT_MM * (self.values.len() as f64).sqrt() {
            return None;
        }
        let members = Products::new(self, &self.trend.clone().qr().q()).members()?;
        Some(members.iter().map(|m| m.full).fold(f64::NEG_INFINITY, f64::max))
    }
}

/// Values of the trend of deviations across a path: of a shifted and tilted axis, and of the mean.
fn across(prismatic: bool, angle: f64, travel: f64) -> Vec<f64> {
    if prismatic { vec![travel, 1.0] } else { vec![angle.cos(), angle.sin(), 1.0] }
}

/// Travels and series angles of the readings of a path; the length of a prismatic joint is half a
/// turn.
fn along(sweep: &Sweep, fit: &SweepFit, rows: &[usize]) -> Vec<(f64, f64)> {
    let travels: Vec<f64> = rows.iter().map(|&i| fit.travel(&fit.frame, sweep.readings[i].position_mm)).collect();
    let [low, high] = travels.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(*v), b.max(*v)]);
    let length = (high - low).max(f64::MIN_POSITIVE);
    let angle = |t: &f64| if fit.prismatic { PI * (t - low) / length } else { t.rem_euclid(TAU) };
    travels.iter().map(|t| (*t, angle(t))).collect()
}

/// Rows of a path, in the order of the motion; all of them, or the rows that the fit uses.
pub(super) fn rows(sweep: &Sweep, fit: &SweepFit, target: usize, all: bool) -> Vec<usize> {
    (0..sweep.readings.len()).filter(|&i| sweep.readings[i].target == target && (all || fit.used[i])).collect()
}

/// Series of a component of the residuals (0 or 1) of rows of a path; `step` adds a column that is
/// one from this place on.
pub(super) fn series(sweep: &Sweep, fit: &SweepFit, rows: &[usize], component: usize, step: Option<usize>) -> Series {
    let along = along(sweep, fit, rows);
    let columns = if fit.prismatic { 2 } else { 3 } + usize::from(step.is_some());
    let mut trend = DMatrix::zeros(rows.len(), columns);
    for (i, (travel, angle)) in along.iter().enumerate() {
        let own = across(fit.prismatic, *angle, *travel);
        own.iter().enumerate().for_each(|(k, v)| trend[(i, k)] = *v);
        if step.is_some_and(|at| i >= at) {
            trend[(i, columns - 1)] = 1.0;
        }
    }
    Series {
        angles: along.iter().map(|a| a.1).collect(),
        values: DVector::from_iterator(rows.len(), rows.iter().map(|&i| fit.residuals_mm[i][component])),
        trend,
    }
}

/// Series of values of rows of a path about these columns of each row.
pub(super) fn tangential(
    sweep: &Sweep,
    fit: &SweepFit,
    rows: &[usize],
    values: &[f64],
    columns: &[Vec<f64>],
) -> Series {
    let width = columns.first().map_or(0, Vec::len);
    Series {
        angles: along(sweep, fit, rows).iter().map(|a| a.1).collect(),
        values: DVector::from_column_slice(values),
        trend: DMatrix::from_fn(rows.len(), width, |i, k| columns[i][k]),
    }
}

/// Deviations of all paths.
pub(super) struct Deviations {
    /// Trends of the two components of each path.
    trends: Vec<[Trend; 2]>,
    /// Noise of a coordinate, of all series together (mm).
    noise_mm: f64,
}

impl Deviations {
    /// Trends of the residuals of the readings that a fit uses; `None` if a path has too few.
    pub(super) fn new(sweep: &Sweep, fit: &SweepFit) -> Option<Self> {
        let of_path = |target: usize| {
            let rows = rows(sweep, fit, target, false);
            let one = |k: usize| series(sweep, fit, &rows, k, None).trend(EXACT_MM);
            Some([one(0)?, one(1)?])
        };
        let trends = fit.paths.iter().map(|p| of_path(p.target)).collect::<Option<Vec<_>>>()?;
        let all = || trends.iter().zip(&fit.paths).flat_map(|(t, p)| t.iter().map(move |t| (t, p.readings as f64)));
        let count: f64 = all().map(|(_, n)| n).sum();
        let noise_mm = (all().map(|(t, n)| n * t.noise * t.noise).sum::<f64>() / count).sqrt();
        Some(Self { trends, noise_mm })
    }

    fn all(&self) -> impl Iterator<Item = &Trend> {
        self.trends.iter().flatten()
    }

    /// `true` if deviations of a path are modelled as smooth.
    pub(super) fn are_smooth(&self) -> bool {
        self.all().any(|t| t.evidence > MODELLED)
    }

    /// Smooth deviations that are reported.
    pub(super) fn reported(&self, fit: &SweepFit) -> Option<Smooth> {
        let smooth = self.all().any(|t| t.evidence > REPORTED);
        let used = fit.residuals_mm.iter().zip(&fit.used).filter(|(_, used)| **used);
        let rms_mm = etalon_math::statistics::rms(used.flat_map(|(residual, _)| *residual));
        smooth.then_some(Smooth { rms_mm, noise_mm: self.noise_mm })
    }

    /// Effective degrees of freedom: the fewest of a series with smooth deviation.
    pub(super) fn degrees_of_freedom(&self) -> f64 {
        let smooth = self.all().filter(|t| t.evidence > MODELLED);
        smooth.map(|t| t.degrees_of_freedom).fold(f64::INFINITY, f64::min)
    }

    /// Changes of the parameters of a fit that the trends give, and their covariance; `noise_mm` is
    /// the least noise of a coordinate.
    fn adjustment(&self, fit: &SweepFit, noise_mm: f64) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let n = fit.cofactors.nrows();
        let (mut normal, mut right) = (DMatrix::zeros(n, n), DVector::zeros(n));
        for (path, trends) in self.trends.iter().enumerate() {
            for (k, trend) in trends.iter().enumerate() {
                let rows = fit.trend_rows(path, k);
                let more = (noise_mm * noise_mm - trend.noise * trend.noise).max(0.0);
                let covariance = &trend.covariance + &trend.cofactors * more;
                let factor = Cholesky::new(covariance)?;
                normal += rows.transpose() * factor.solve(&rows);
                right += rows.transpose() * factor.solve(&trend.coefficients);
            }
        }
        let covariance = super::sweep::invert_scaled(&normal)?;
        Some((&covariance * right, covariance))
    }
}

/// Fit of a sweep with smooth deviations.
pub(super) struct SmoothFit {
    pub fit: SweepFit,
    /// Covariance of the parameters of [`SweepFit::cofactors`].
    pub covariance: DMatrix<f64>,
    pub deviations: Deviations,
}

/// Most adjustments of the axis by the trends: a change of the weights moves it by less and less.
const ADJUSTMENTS: usize = 4;
/// Share of a standard uncertainty at which the adjustment ends.
const CONVERGED: f64 = 1e-3;

/// Generalised least squares of a sweep whose deviations are smooth; `None` if they are noise.
///
/// `stated_mm` is the given noise of a coordinate, which is its least.
pub(super) fn smooth_fit(sweep: &Sweep, fit: &SweepFit, stated_mm: Option<f64>) -> Option<SmoothFit> {
    let mut fit = fit.clone();
    let mut deviations = Deviations::new(sweep, &fit).filter(Deviations::are_smooth)?;
    let mut covariance = None;
    for _ in 0..ADJUSTMENTS {
        let noise_mm = deviations.noise_mm.max(stated_mm.unwrap_or_default());
        let (change, found) = deviations.adjustment(&fit, noise_mm)?;
        let off = (0..change.len()).map(|k| change[k].abs() / found[(k, k)].sqrt()).fold(0.0, f64::max);
        covariance = Some(found);
        if off < CONVERGED {
            break;
        }
        fit = fit.adjusted(&sweep.readings, change.as_slice());
        deviations = Deviations::new(sweep, &fit)?;
    }
    Some(SmoothFit { fit, covariance: covariance?, deviations })
}
