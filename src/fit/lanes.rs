//! Eight points side by side: arrays of eight that the compiler keeps in vector registers.
//!
//! Every lane does what one double would do, in the same order, so results do not depend on the width of the machine's
//! registers.

use crate::pose::Vector;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Points computed side by side.
pub(super) const LANES: usize = 8;

/// One number of each of eight points.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Lanes(pub [f64; LANES]);

/// Eight points, coordinate by coordinate.
pub(super) type Points = [Lanes; 3];

impl Lanes {
    /// The same number in every lane.
    #[inline(always)]
    pub fn all(x: f64) -> Self {
        Self([x; LANES])
    }

    #[inline(always)]
    fn zip(mut self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        for (x, y) in self.0.iter_mut().zip(other.0) {
            *x = f(*x, y);
        }
        self
    }

    /// Square roots.
    #[inline(always)]
    pub fn sqrt(mut self) -> Self {
        for x in &mut self.0 {
            *x = x.sqrt();
        }
        self
    }

    /// 1 / x, and zero for zero: on its own axis a point has no direction, and zero keeps a step finite.
    #[inline(always)]
    pub fn inverse_or_zero(self) -> Self {
        // divided first, so that there is a choice and no branch
        self.zip(Self::all(1.0) / self, |x, inverse| if x > 0.0 { inverse } else { 0.0 })
    }

    /// The smaller of each.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.zip(other, |x, y| if y < x { y } else { x })
    }

    /// The larger of each.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.zip(other, |x, y| if y > x { y } else { x })
    }

    /// One where positive, else zero.
    #[inline(always)]
    pub fn presence(self) -> Self {
        self.zip(self, |x, _| if x > 0.0 { 1.0 } else { 0.0 })
    }

    /// Without signs.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.zip(self, |x, _| x.abs())
    }

    /// The same sizes with the signs of others.
    #[inline(always)]
    pub fn with_sign_of(self, other: Self) -> Self {
        self.zip(other, f64::copysign)
    }

    /// Sum over the lanes, by pairs.
    pub fn sum(self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.0;
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    }

    /// Smallest of the lanes.
    pub fn least(self) -> f64 {
        self.0.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Largest of the lanes.
    pub fn most(self) -> f64 {
        self.0.into_iter().fold(f64::NEG_INFINITY, f64::max)
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |x, y| x * y)
    }
}

impl Mul<f64> for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self * Self::all(other)
    }
}

impl Sub<f64> for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        self - Self::all(other)
    }
}

impl Div for Lanes {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |x, y| x / y)
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::default() - self
    }
}

/// Scalar product of eight vectors with one.
#[inline(always)]
pub(super) fn along(q: Points, d: Vector) -> Lanes {
    q[0] * d[0] + q[1] * d[1] + q[2] * d[2]
}

/// Squared length of eight vectors.
#[inline(always)]
pub(super) fn square(q: Points) -> Lanes {
    q[0] * q[0] + q[1] * q[1] + q[2] * q[2]
}

/// `q - p`.
#[inline(always)]
pub(super) fn less(q: Points, p: Vector) -> Points {
    [q[0] - p[0], q[1] - p[1], q[2] - p[2]]
}
