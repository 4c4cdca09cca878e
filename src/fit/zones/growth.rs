//! Points that one element explains: the search behind robust fits.
//!
//! The start is the element through few points that leaves the smallest median distance (least
//! median of squares: Rousseeuw 1984). From the nearest points the fit grows to all points that its
//! prediction explains. One rule judges all points and elements: the distance of a point is
//! compared with its deviation from the *other* used points, which has the variance of noise and of
//! the prediction. With the covariance H σ² of the prediction, this is σ² (1 + H) outside the used
//! points and σ² (1 − H) for the residual inside (Cook & Weisberg 1982, "Residuals and influence in
//! regression", 2.2), where σ² excludes the point itself.
//!
//! H is linear. Where few points lie far from all others, the others may predict them so poorly
//! that it does not hold: there the sum of squares with the point and without it is compared
//! (likelihood ratio), first for all remaining points together. Points are excluded only if no
//! element explains all of them.

use crate::prediction::{Offsets, equations};
use crate::{Element, Fit, FitSettings, element};
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, norm};
use statrs::distribution::{ContinuousCDF, Normal};
use statrs::function::{beta::checked_beta_reg, gamma::ln_gamma};

/// Starts that are tried.
const STARTS: u64 = 60;
/// Maximum number of points by which starts are compared.
const COMPARED: usize = 500;
/// Points of a start beyond the minimum.
const MORE: usize = 1;
/// Steps of the growth.
const STEPS: usize = 40;
/// Expected number of correct points that are excluded in a fit.
const LOST: f64 = 1e-3;
/// Share of the points with which the growth begins.
pub(crate) const BEGIN: f64 = 0.6;
/// Relative rounding error of distances.
const ROUNDING: f64 = 1e-13;
/// Variance of a prediction, in variances of noise, from which it is compared by another fit.
const LEVERAGE: f64 = 0.5;
/// Points of high leverage from each of which the growth is continued.
const BRANCHES: usize = 6;
/// Least redundancy (1 − H) of a point that others control.
const REDUNDANCY: f64 = 1e-9;
/// Maximum step of coordinates, as a share of their extent, that is the resolution of an
/// instrument.
const COARSEST: f64 = 1e-3;

/// Points with their settings for the search, which does not compensate for a probe.
pub(crate) struct Search<'a> {
    element: Element,
    points: &'a [Vector],
    settings: FitSettings<'a>,
    /// Standard deviation (mm) of rounded coordinates.
    resolution_mm: f64,
    /// Largest coordinate (mm).
    largest_mm: f64,
}

/// Fit of some points.
struct Trial {
    fit: Fit,
    used: Vec<usize>,
    /// Weighted sum of squared distances.
    squares: f64,
    degrees_of_freedom: usize,
}

impl Trial {
    fn variance(&self) -> f64 {
        self.squares / self.degrees_of_freedom.max(1) as f64
    }
}

/// Comparison of a point with the element of other points.
struct Judged {
    /// Negative logarithm of the probability of a larger distance.
    surprise: f64,
    /// Variance of the prediction in variances of noise.
    leverage: f64,
}

impl<'a> Search<'a> {
    /// Prepares a search among `points`.
    pub fn new(element: Element, points: &'a [Vector], settings: FitSettings<'a>) -> Self {
        let largest_mm = points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let flat = matches!(element, Element::Line2d | Element::Circle2d);
        let resolution_mm = resolution(points, if flat { 2 } else { 3 }) / 12f64.sqrt();
        Self { element, points, settings, resolution_mm, largest_mm }
    }

    /// Returns the fit of the points with these indices.
    fn trial(&self, used: Vec<usize>) -> Option<Trial> {
        let points: Vec<Vector> = used.iter().map(|i| self.points[*i]).collect();
        let weights: Option<Vec<f64>> = self.settings.weights.map(|w| used.iter().map(|i| w[*i]).collect());
        let settings = FitSettings { weights: weights.as_deref(), ..self.settings };
        let fit = element(self.element, &points, &settings).ok()?;
        let squares = used.iter().map(|i| self.weight(*i) * fit.offsets(self.points[*i]).length().powi(2)).sum();
        let all = equations(self.element) * used.len();
        let degrees_of_freedom = all.saturating_sub(parameters(self.element, &self.settings));
        Some(Trial { fit, used, squares, degrees_of_freedom })
    }

    fn weight(&self, i: usize) -> f64 {
        self.settings.weights.map_or(1.0, |w| w[i])
    }

    /// Variance that rounding of coordinates and of distances leaves at least, times the weight.
    fn floor(&self, fit: &Fit, weight: f64) -> f64 {
        let size = norm(fit.geometry.point_mm) + fit.geometry.radius_mm.unwrap_or_default() + self.largest_mm;
        (ROUNDING * size).max(self.resolution_mm).powi(2) * weight
    }

    /// Compares point `i` with the element of the other used points; the standard deviation of the
    /// used points is `reduced` times the value of all points.
    fn judge(&self, trial: &Trial, i: usize, reduced: f64) -> Judged {
        let (offsets, weight) = (trial.fit.offsets(self.points[i]), self.weight(i));
        let inside = trial.used.binary_search(&i).is_ok();
        let equations = equations(self.element);
        let (variance, floor) = (trial.variance(), self.floor(&trial.fit, weight));
        let shares = shares(&offsets, &trial.fit, if variance > 0.0 { weight / variance } else { 0.0 });
        let leverage = shares[0][0].max(shares[1][1]);
        let certain = Judged { surprise: 0.0, leverage };
        let Some(square) = normalised(&offsets, shares, if inside { -1.0 } else { 1.0 }).map(|s| s * weight) else {
            return certain; // no other point controls it
        };
        let (left, others) = match inside {
            true => ((trial.squares - square).max(0.0), trial.degrees_of_freedom.saturating_sub(equations)),
            false => (trial.squares, trial.degrees_of_freedom),
        };
        if others == 0 {
            return certain;
        }
        let noise = (left / others as f64 / (reduced * reduced)).max(floor);
        Judged { surprise: -ln_tail(square / noise, equations, others), leverage }
    }

    /// Surprise above which one of all points is not explained.
    fn limit(&self) -> f64 {
        (self.points.len() as f64 / LOST).ln()
    }

    /// The best start by the median distance of a sample.
    fn start(&self) -> Option<Fit> {
        let count = (self.element.minimum_points() + MORE).min(self.points.len());
        let step = self.points.len().div_ceil(COMPARED).max(1);
        let mut best: Option<(f64, Fit)> = None;
        for trial in 0..STARTS {
            let mut noise = Noise::new(self.points.len() as u64, trial);
            // draws of indices that differ
            let mut chosen: Vec<usize> = Vec::new();
            while chosen.len() < count {
                let at = (0.5 * (1.0 + noise.uniform(1.0)) * self.points.len() as f64) as usize;
                let at = at.min(self.points.len() - 1);
                if !chosen.contains(&at) {
                    chosen.push(at);
                }
            }
            let Some(Trial { fit, .. }) = self.trial(chosen) else { continue };
            let sample = self.points.iter().step_by(step).map(|p| fit.offsets(*p).length());
            let median = etalon_math::statistics::median(sample).unwrap_or(f64::INFINITY);
            if best.as_ref().is_none_or(|(least, _)| median < *least) {
                best = Some((median, fit));
            }
        }
        Some(best?.1)
    }

    /// The points nearest to the best start, with the ratio of their standard deviation to the
    /// standard deviation of all.
    fn core(&self) -> Option<(Trial, f64)> {
        let (n, fit) = (self.points.len(), self.start()?);
        let count = ((BEGIN * n as f64) as usize).max(self.element.minimum_points() + MORE).min(n);
        let distances = (0..n).map(|i| self.weight(i).sqrt() * fit.offsets(self.points[i]).length());
        let mut order: Vec<(f64, usize)> = distances.zip(0..n).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut used: Vec<usize> = order.iter().take(count).map(|(_, i)| *i).collect();
        used.sort_unstable();
        Some((self.trial(used)?, reduction(count as f64 / n as f64, equations(self.element))))
    }

    /// Grows a fit to all points that it explains.
    fn grow(&self, mut trial: Trial, mut reduced: f64) -> Trial {
        for _ in 0..STEPS {
            let explained = |i: &usize| self.judge(&trial, *i, reduced).surprise <= self.limit();
            let near: Vec<usize> = (0..self.points.len()).filter(explained).collect();
            reduced = 1.0;
            if near == trial.used {
                break;
            }
            let Some(next) = self.trial(near) else { break };
            trial = next;
        }
        trial
    }

    /// `true` if the points that `larger` adds are explained by its sum of squares; `surprise` is
    /// the limit.
    fn agrees(&self, trial: &Trial, larger: &Trial, limit: f64) -> bool {
        let added = larger.used.len() - trial.used.len();
        let weight = larger.used.iter().fold(0.0f64, |m, i| m.max(self.weight(*i)));
        let noise = trial.variance().max(self.floor(&larger.fit, weight));
        let more = (larger.squares - trial.squares).max(0.0) / noise;
        -ln_tail(more, added * equations(self.element), trial.degrees_of_freedom) <= limit
    }

    /// `true` if one element explains all points: the sum of squares grows by no more than by the
    /// largest distances among as many points, whichever were omitted.
    fn explains_all(&self, trial: &Trial) -> bool {
        let n = self.points.len();
        let left_out = n - trial.used.len();
        let Some(all) = self.trial((0..n).collect()) else { return false };
        let choices = |n: usize| ln_gamma(n as f64 + 1.0);
        let ways = choices(n) - choices(left_out) - choices(n - left_out);
        // one of a thousand fits may fail over all numbers of points that are omitted
        let shared = (left_out - 1) as f64 * 2f64.ln();
        self.agrees(trial, &all, ways + shared - LOST.ln())
    }

    /// Continues from points of high leverage whose sum of squares agrees although their linear
    /// prediction does not; the largest result.
    fn beyond_leverage(&self, trial: &Trial) -> Option<Trial> {
        let outside = (0..self.points.len()).filter(|i| trial.used.binary_search(i).is_err());
        let mut far: Vec<(Judged, usize)> = outside.map(|i| (self.judge(trial, i, 1.0), i)).collect();
        far.retain(|(judged, _)| judged.leverage > LEVERAGE);
        far.sort_by(|a, b| a.0.surprise.total_cmp(&b.0.surprise));
        let branches = far.iter().take(BRANCHES).filter_map(|(_, i)| {
            let mut used = trial.used.clone();
            used.push(*i);
            used.sort_unstable();
            let larger = self.trial(used)?;
            self.agrees(trial, &larger, self.limit()).then(|| self.grow(larger, 1.0))
        });
        branches.max_by_key(|branch| branch.used.len()).filter(|branch| branch.used.len() > trial.used.len())
    }

    /// Points that one element explains; `None` if no element can be fitted to most of them.
    pub fn explained(&self) -> Option<Vec<usize>> {
        let (core, reduced) = self.core()?;
        let mut grown = self.grow(core, reduced);
        while grown.used.len() < self.points.len() {
            if self.explains_all(&grown) {
                return None;
            }
            let Some(larger) = self.beyond_leverage(&grown) else { break };
            grown = larger;
        }
        Some(grown.used)
    }
}

/// Parameters of an element, without held parameters.
fn parameters(element: Element, settings: &FitSettings) -> usize {
    let all = match element {
        Element::Line2d => 2,
        Element::Plane | Element::Circle2d => 3,
        Element::Line | Element::Sphere => 4,
        Element::Cylinder => 5,
        Element::Circle3d | Element::Cone => 6,
        Element::Torus => 7,
    };
    let held = usize::from(settings.radius_mm.is_some()) + 2 * usize::from(settings.axis.is_some());
    all - held.min(all - 1)
}

/// Distance of a fitted point in standard deviations of its residual; zero if no other point
/// controls it.
pub(crate) fn studentised(fit: &Fit, point: Vector, weight: f64) -> f64 {
    let offsets = fit.offsets(point);
    let variance = fit.precision.variance_mm2.filter(|variance| *variance > 0.0);
    let factor = variance.map_or(0.0, |variance| weight / variance);
    normalised(&offsets, shares(&offsets, fit, factor), -1.0).map_or(0.0, |square| (square * weight).sqrt())
}

/// Covariance of the distances from the prediction, times `factor`.
fn shares(offsets: &Offsets, fit: &Fit, factor: f64) -> [[f64; 2]; 2] {
    offsets.covariance(fit).map(|row| row.map(|v| v * factor))
}

/// Sum of squares of distances over their variances 1 + `sign` H; `None` if a variance vanishes.
fn normalised(offsets: &Offsets, shares: [[f64; 2]; 2], sign: f64) -> Option<f64> {
    let [x, y] = offsets.distances;
    let (a, b, c) = (1.0 + sign * shares[0][0], sign * shares[0][1], 1.0 + sign * shares[1][1]);
    let determinant = a * c - b * b;
    (a > REDUNDANCY && c > REDUNDANCY && determinant > REDUNDANCY)
        .then(|| ((c * x - b * y) * x + (a * y - b * x) * y) / determinant)
}

/// Logarithm of the probability that the sum of `added` squares of normal deviates exceeds
/// `squares` times their variance, which is known with `degrees_of_freedom`: F, far out by
/// Chernoff's bound.
fn ln_tail(squares: f64, added: usize, degrees_of_freedom: usize) -> f64 {
    let (a, d) = (added as f64, degrees_of_freedom as f64);
    // squares beyond the range of numbers explain everything
    if added == 0 || degrees_of_freedom == 0 || squares <= 0.0 || squares.is_nan() {
        return 0.0;
    }
    let ratio = squares / d;
    let exact = checked_beta_reg(0.5 * d, 0.5 * a, 1.0 / (1.0 + ratio)).unwrap_or(1.0);
    if exact > 1e-280 {
        return exact.ln();
    }
    if !ratio.is_finite() {
        return f64::NEG_INFINITY;
    }
    let numerator = (ratio * (a + d) / (a * (1.0 + ratio))).ln();
    0.5 * (a * numerator + d * ((a + d) / (d * (1.0 + ratio))).ln())
}

/// Ratio of the standard deviation of the smallest `share` of normal deviates to the standard
/// deviation of all; of pairs by their length for two `equations`.
pub(crate) fn reduction(share: f64, equations: usize) -> f64 {
    if share >= 1.0 {
        return 1.0;
    }
    let square = if equations == 2 {
        let x = -(1.0 - share).ln();
        (1.0 - (1.0 + x) * (-x).exp()) / share
    } else {
        let normal = Normal::standard();
        let c = normal.inverse_cdf(0.5 * (1.0 + share));
        1.0 - 2.0 * c * (-0.5 * c * c).exp() / std::f64::consts::TAU.sqrt() / share
    };
    square.max(f64::EPSILON).sqrt()
}

/// Resolution (mm) of coordinates: the largest step, in decimals of a millimetre or inch, of which
/// all are multiples; zero without one below a share of their extent.
fn resolution(points: &[Vector], coordinates: usize) -> f64 {
    let all = || points.iter().flat_map(|p| &p[..coordinates]);
    let range =
        |k: usize| points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |r, p| [r[0].min(p[k]), r[1].max(p[k])]);
    let extent = (0..coordinates).map(range).fold(0.0f64, |m, [low, high]| m.max(high - low));
    let mut steps = (0..8).flat_map(|k| [25.4, 1.0].map(|unit| unit * 10f64.powi(-k)));
    let multiple = |x: f64, step: f64| {
        let count = (x / step).round();
        (x - count * step).abs() <= 4.0 * f64::EPSILON * x.abs()
    };
    let fits = |step: &f64| *step <= COARSEST * extent && all().all(|x| multiple(*x, *step));
    steps.find(fits).unwrap_or(0.0)
}
