//! Trust region of the linear model of a problem, and the best step within it.

use super::Factor;

/// Trust region of Moré 1978, "The Levenberg-Marquardt algorithm: implementation and theory", as in
/// MINPACK: a ball about the current point in parameters scaled by the columns of the Jacobian.
#[derive(Debug)]
pub struct TrustRegion {
    radius: f64,
    damping: f64,
}

/// A step within the region.
#[derive(Debug)]
pub struct BoundedStep {
    /// Step, to be subtracted from the scaled parameters.
    pub p: Vec<f64>,
    /// Length of `p`.
    pub length: f64,
    /// `true` if the region limits the step, so that it does not reach the minimum of the linear
    /// model.
    pub is_damped: bool,
    damping: f64,
    /// ‖R p‖², a part of the predicted decrease.
    moved: f64,
}

impl BoundedStep {
    /// Factor of the problem that the step solves, from the factor of the linear model.
    pub fn factor(&self, factor: &Factor) -> Factor {
        factor.damped(self.damping.sqrt())
    }
}

impl TrustRegion {
    /// Creates a region of the size of the parameters, whose scaled length is `extent`.
    pub fn new(extent: f64) -> Self {
        Self { radius: if extent > 0.0 { extent } else { 1.0 }, damping: 0.0 }
    }

    /// `true` if a step within the region is representable.
    pub fn is_open(&self) -> bool {
        self.radius.is_normal()
    }

    /// Step within the region (to a tenth) that minimises the linear model; `None` if no damping
    /// makes the factor regular.
    pub fn step(&mut self, factor: &Factor) -> Option<BoundedStep> {
        let (p, damping) = damped_step(factor, self.radius, self.damping)?;
        self.damping = damping;
        let moved = sum_of_squares(&factor.multiply(&p));
        Some(BoundedStep { length: norm(&p), p, is_damped: damping != 0.0, damping, moved })
    }

    /// Adapts the region to the cost after a step; returns the ratio of actual to predicted
    /// decrease.
    pub fn judge(&mut self, step: &BoundedStep, cost: f64, trial_cost: f64) -> f64 {
        let lowered = cost - trial_cost;
        let damped = step.damping * step.length * step.length;
        // predicted decrease: ‖r‖² − ‖r − J p‖² = ‖R p‖² + 2 λ ‖p‖² for this p (Moré, eq. 4.5)
        let ratio = if trial_cost.is_finite() { lowered / (step.moved + 2.0 * damped) } else { f64::NEG_INFINITY };
        if ratio < 0.25 {
            let shorten = if trial_cost.is_finite() && trial_cost < 100.0 * cost {
                // minimum of the parabola through both costs and the slope (as in MINPACK)
                let slope = step.moved + damped;
                (if ratio >= 0.0 { 0.5 } else { 0.5 * slope / (slope - 0.5 * lowered) }).clamp(0.1, 0.5)
            } else {
                0.1
            };
            self.radius = shorten * self.radius.min(10.0 * step.length);
            self.damping /= shorten;
        } else if self.damping == 0.0 || ratio >= 0.75 {
            self.open(step);
        }
        ratio
    }

    /// Expands the region to twice the length of a successful step.
    pub fn open(&mut self, step: &BoundedStep) {
        self.radius = 2.0 * step.length;
        self.damping *= 0.5;
    }
}

/// Scaled step of at most `radius` (to a tenth) that minimises the linear model, and its damping λ
/// (Moré 1978, algorithm 5.5); `None` if no damping makes the factor regular.
fn damped_step(factor: &Factor, radius: f64, last_damping: f64) -> Option<(Vec<f64>, f64)> {
    let direction = |f: &Factor, p: &[f64], length: f64| {
        f.forward_substitute(p.iter().map(|p| p / length).collect()).map(|w| sum_of_squares(&w))
    };
    let mut lower = 0.0;
    if let Some(p) = factor.solve() {
        let length = norm(&p);
        if length <= 1.1 * radius {
            return Some((p, 0.0));
        }
        if let Some(w) = direction(factor, &p, length) {
            lower = (length - radius) / radius / w;
        }
    }
    let mut upper = norm(&factor.multiply_transposed(&factor.qtb)) / radius;
    if upper == 0.0 {
        upper = f64::MIN_POSITIVE / radius.min(0.1);
    }
    if !upper.is_finite() {
        return None;
    }
    let mut damping = last_damping.clamp(lower.min(upper), upper);
    if damping == 0.0 {
        damping = (0.001 * upper).max((lower * upper).sqrt());
    }
    for attempt in 0..12 {
        let damped = factor.damped(damping.sqrt());
        let p = damped.solve()?;
        let length = norm(&p);
        let off = length - radius;
        if off.abs() <= 0.1 * radius || attempt == 11 {
            return Some((p, damping));
        }
        let correction = off / radius / direction(&damped, &p, length)?;
        if off > 0.0 {
            lower = f64::max(lower, damping)
        } else {
            upper = upper.min(damping)
        }
        damping = (damping + correction).max(lower);
        if damping > upper || damping <= 0.0 {
            damping = (lower * upper).sqrt().max(0.001 * upper);
        }
    }
    None
}

/// Euclidean norm.
pub fn norm(v: &[f64]) -> f64 {
    sum_of_squares(v).sqrt()
}

fn sum_of_squares(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum()
}
