//! Eight points side by side, as arrays that the compiler keeps in vector registers.
//!
//! Every lane performs the operations of a single double in the same order, so results do not
//! depend on the width of the machine's registers.

use etalon_base::pose::Vector;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Number of points computed side by side.
pub(crate) const LANES: usize = 8;

/// Range of the series about one.
const NEAR: f64 = 1.0 / 512.0;

/// One number for each of eight points.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct F64x8(pub [f64; LANES]);

/// Eight points, coordinate by coordinate.
pub(crate) type Points = [F64x8; 3];

impl F64x8 {
    /// Equal numbers in all lanes.
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

    /// self + a b with a single rounding, whether or not the machine has a fused instruction.
    #[inline(always)]
    pub fn plus(mut self, a: Self, b: Self) -> Self {
        for ((sum, a), b) in self.0.iter_mut().zip(a.0).zip(b.0) {
            *sum = a.mul_add(b, *sum);
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

    /// 1 / x, and zero for zero. A point on the axis has no direction, and zero keeps a step
    /// finite.
    #[inline(always)]
    pub fn inverse_or_zero(self) -> Self {
        // dividing first allows a selection instead of a branch
        self.zip(Self::all(1.0) / self, |x, inverse| if x > 0.0 { inverse } else { 0.0 })
    }

    /// Square roots and their inverses (zero for zero). If all values are within 1/512 of `near`²,
    /// uses the binomial series without divisions or square roots. Its error is 2e-18 of the root,
    /// and 7e-15 of the inverse, which is used for directions only.
    #[inline(always)]
    pub fn roots(self, near: f64) -> (Self, Self) {
        // with half as many bits, the square of `near` is exact, and so are differences from it
        let near = f64::from(near as f32);
        let w = (self - near * near) * (1.0 / (near * near));
        let mut far = false;
        for w in w.0 {
            far |= w.abs().partial_cmp(&NEAR) != Some(Ordering::Less);
        }
        if far {
            let root = self.sqrt();
            return (root, root.inverse_or_zero());
        }
        let series = |coefficients: [f64; 5]| {
            let [last, rest @ ..] = coefficients;
            rest.into_iter().fold(Self::all(last), |sum, c| Self::all(c).plus(sum, w))
        };
        let root = series([7.0 / 256.0, -5.0 / 128.0, 1.0 / 16.0, -1.0 / 8.0, 1.0 / 2.0]);
        let inverse = series([35.0 / 128.0, -5.0 / 16.0, 3.0 / 8.0, -1.0 / 2.0, 1.0]);
        (Self::all(near).plus(w * near, root), inverse * (1.0 / near))
    }

    /// Lane-wise minimum.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.zip(other, |x, y| if y < x { y } else { x })
    }

    /// Lane-wise maximum.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.zip(other, |x, y| if y > x { y } else { x })
    }

    /// One for positive lanes, otherwise zero.
    #[inline(always)]
    pub fn presence(self) -> Self {
        self.zip(self, |x, _| if x > 0.0 { 1.0 } else { 0.0 })
    }

    /// Absolute values.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.zip(self, |x, _| x.abs())
    }

    /// Magnitudes with the signs of `other`.
    #[inline(always)]
    pub fn with_signs(self, other: Self) -> Self {
        self.zip(other, f64::copysign)
    }

    /// Sum over the lanes, pairwise.
    pub fn sum(self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.0;
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    }

    /// Smallest lane.
    pub fn least(self) -> f64 {
        self.0.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Largest lane.
    pub fn most(self) -> f64 {
        self.0.into_iter().fold(f64::NEG_INFINITY, f64::max)
    }
}

impl Add for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl Sub for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl Mul for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |x, y| x * y)
    }
}

impl Mul<f64> for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self * Self::all(other)
    }
}

impl Add<f64> for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        self + Self::all(other)
    }
}

impl Sub<f64> for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        self - Self::all(other)
    }
}

impl Div for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |x, y| x / y)
    }
}

impl Neg for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::default() - self
    }
}

/// Dot products of eight vectors with one vector.
#[inline(always)]
pub(crate) fn along(q: Points, d: Vector) -> F64x8 {
    (q[0] * d[0]).plus(q[1], F64x8::all(d[1])).plus(q[2], F64x8::all(d[2]))
}

/// Squared lengths of eight vectors.
#[inline(always)]
pub(crate) fn square(q: Points) -> F64x8 {
    (q[0] * q[0]).plus(q[1], q[1]).plus(q[2], q[2])
}

/// `q - p`.
#[inline(always)]
pub(crate) fn less(q: Points, p: Vector) -> Points {
    [q[0] - p[0], q[1] - p[1], q[2] - p[2]]
}
