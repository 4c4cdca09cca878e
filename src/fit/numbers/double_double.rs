//! Double-double arithmetic: a number as the unevaluated sum of two doubles (106 bits), for
//! decisions that depend on the last digit.
//!
//! Dekker 1971, "A floating-point technique for extending the available precision"; the error of a
//! product by fused multiply-add (Ogita, Rump & Oishi 2005, algorithm 3.5).

use etalon_base::pose::Vector;
use std::ops::{Add, Div, Mul, Sub};

/// hi + lo, where |lo| is at most half a unit in the last place of hi.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub(crate) struct DoubleDouble {
    pub hi: f64,
    lo: f64,
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

/// Exact sum a + b (Knuth).
fn sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let part = hi - a;
    DoubleDouble { hi, lo: (a - (hi - part)) + (b - part) }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.hi, other.hi), sum(self.lo, other.lo));
        let middle = sum(high.hi, high.lo + low.hi);
        sum(middle.hi, middle.lo + low.lo)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + Self { hi: -other.hi, lo: -other.lo }
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let error = self.hi.mul_add(other.hi, -hi);
        sum(hi, error + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - Self::from(first) * other;
        let second = rest.hi / other.hi;
        let rest = rest - Self::from(second) * other;
        sum(first, second) + Self::from(rest.hi / other.hi)
    }
}

/// Vector of double-double numbers.
pub(crate) type DoubleDoubleVector = [DoubleDouble; 3];

/// `a - b`.
pub(crate) fn minus(a: DoubleDoubleVector, b: DoubleDoubleVector) -> DoubleDoubleVector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + t b`.
pub(crate) fn plus_times(a: DoubleDoubleVector, t: DoubleDouble, b: DoubleDoubleVector) -> DoubleDoubleVector {
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}

/// Scalar product.
pub(crate) fn dot(a: DoubleDoubleVector, b: DoubleDoubleVector) -> DoubleDouble {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Exact conversion of a vector.
pub(crate) fn exact(a: Vector) -> DoubleDoubleVector {
    a.map(DoubleDouble::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_digits() {
        let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
        let left = (third * DoubleDouble::from(3.0) - DoubleDouble::from(1.0)).hi;
        assert!(left.abs() < 1e-31, "{left:e}");
        let ninth = (third * third * DoubleDouble::from(9.0) - DoubleDouble::from(1.0)).hi;
        assert!(ninth.abs() < 1e-30, "{ninth:e}");
        let small = DoubleDouble::from(1e-20);
        assert_eq!((DoubleDouble::from(1.0) + small - DoubleDouble::from(1.0)).hi, 1e-20);
        let square = (DoubleDouble::from(1.0) + small) * (DoubleDouble::from(1.0) + small);
        assert!(((square - DoubleDouble::from(1.0)).hi - 2e-20).abs() < 1e-31);
    }
}
