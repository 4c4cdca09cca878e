//! Bounds that parameters stay within.

use crate::base::message::{Message, Result};

/// A lower and an upper bound for every parameter; infinite where there is none, equal where it is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    pub(super) lower: Vec<f64>,
    pub(super) upper: Vec<f64>,
}

/// Where a parameter lies, seen from its bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Between its bounds, or on one that it would leave inwards: it is as the residuals want it.
    Free,
    /// On its lower bound, and the cost would fall below it; or held.
    Lower,
    /// On its upper bound, and the cost would fall above it.
    Upper,
}

impl Bounds {
    /// Bounds, one a parameter; an error where they are not in order, not numbers, or not as many.
    pub fn new(lower: Vec<f64>, upper: Vec<f64>) -> Result<Self> {
        if lower.len() != upper.len() {
            let what = format!("{} lower and {} upper bounds are given", lower.len(), upper.len());
            return Err(Message::error(what).expected("one of each for every parameter").into());
        }
        // an infinite bound on the wrong side leaves no number between
        let wrong = |(l, u): (&f64, &f64)| l.is_nan() || u.is_nan() || l > u || l == u && l.is_infinite();
        if let Some(i) = lower.iter().zip(&upper).position(wrong) {
            let what = format!("the bounds of parameter {} are {} and {}", i + 1, lower[i], upper[i]);
            let message = Message::error(what).expected("a lower bound that is not above the upper one");
            return Err(message.hint("exchange them, or use infinity where there is no bound").into());
        }
        Ok(Self { lower, upper })
    }

    /// Bounds of `count` parameters: those missing are free.
    pub(super) fn widened(&self, count: usize) -> Self {
        let fill = |bounds: &[f64], none: f64| -> Vec<f64> {
            bounds.iter().copied().chain(std::iter::repeat(none)).take(count).collect()
        };
        Self { lower: fill(&self.lower, f64::NEG_INFINITY), upper: fill(&self.upper, f64::INFINITY) }
    }

    /// `x` moved to the nearest place between the bounds.
    pub(super) fn project(&self, x: &[f64]) -> Vec<f64> {
        x.iter().zip(self.lower.iter().zip(&self.upper)).map(|(x, (l, u))| x.max(*l).min(*u)).collect()
    }

    pub(super) fn holds(&self, x: &[f64]) -> bool {
        x.iter().zip(self.lower.iter().zip(&self.upper)).all(|(x, (l, u))| l <= x && x <= u)
    }

    /// The side of every parameter at `x`, where the cost has this gradient.
    pub(super) fn sides(&self, x: &[f64], gradient: &[f64]) -> Vec<Side> {
        (0..x.len()).map(|i| Side::outward(gradient[i], self.lower[i], self.upper[i], x[i])).collect()
    }
}

impl Side {
    pub(super) fn opposite(self) -> Self {
        match self {
            Self::Free => Self::Free,
            Self::Lower => Self::Upper,
            Self::Upper => Self::Lower,
        }
    }

    /// The side of an element at `x` whose cost has this slope: a bound counts where the cost falls beyond it.
    pub(super) fn outward(slope: f64, lower: f64, upper: f64, x: f64) -> Self {
        if x <= lower && (slope >= 0.0 || lower == upper) {
            Self::Lower
        } else if x >= upper && slope <= 0.0 {
            Self::Upper
        } else {
            Self::Free
        }
    }
}
