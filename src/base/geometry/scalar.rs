//! Number types of kinematic models: `f64`, or a dual number with exact derivatives.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Operations that models need. Implemented for `f64` and [`Dual`].
pub trait Scalar:
    Copy
    + Send
    + Sync
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Mul<f64, Output = Self>
    + Add<f64, Output = Self>
{
    /// Value without derivatives.
    fn value(self) -> f64;
    /// `true` if value and derivatives are zero, so that a motion by it can be skipped.
    fn is_zero(self) -> bool {
        false
    }
    /// Sine and cosine of an angle (rad).
    fn sin_cos(self) -> (Self, Self);
    /// Angle of the vector (`x`, `self`) (rad).
    fn atan2(self, x: Self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Angle wrapped to (−π, π] (rad).
    fn wrapped(self) -> Self {
        self + -crate::angle::Turn::RADIANS.whole(self.value())
    }
    /// Tangent of an angle (rad).
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }
}

impl Scalar for f64 {
    fn value(self) -> f64 {
        self
    }
    fn is_zero(self) -> bool {
        self == 0.0
    }
    fn sin_cos(self) -> (Self, Self) {
        f64::sin_cos(self)
    }
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
    }
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
}

/// A dual number: a value and its derivatives with respect to `N` variables (forward-mode
/// differentiation).
#[derive(Clone, Copy, Debug)]
pub struct Dual<const N: usize> {
    /// Value.
    pub value: f64,
    /// Derivatives with respect to the `N` variables.
    pub gradient: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// Variable number `index` with the given value.
    pub fn variable(value: f64, index: usize) -> Self {
        let mut gradient = [0.0; N];
        gradient[index] = 1.0;
        Self { value, gradient }
    }

    /// Chain rule for one argument: `value` with the gradient scaled by `slope`.
    #[inline(always)]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, gradient: self.gradient.map(|g| slope * g) }
    }

    /// Chain rule for two arguments: `value` with gradient `a * self' + b * other'`.
    #[inline(always)]
    fn combine(self, other: Self, value: f64, a: f64, b: f64) -> Self {
        let mut gradient = self.gradient;
        for (g, o) in gradient.iter_mut().zip(other.gradient) {
            *g = a * *g + b * o;
        }
        Self { value, gradient }
    }
}

/// Converts values to variables, each with its own derivative.
pub fn duals<const N: usize>(values: &[f64]) -> Vec<Dual<N>> {
    values.iter().enumerate().map(|(i, &v)| Dual::variable(v, i)).collect()
}

/// Converts values to constants without derivatives.
pub fn constants<const N: usize>(values: &[f64]) -> Vec<Dual<N>> {
    values.iter().map(|&v| Dual::from(v)).collect()
}

impl<const N: usize> From<f64> for Dual<N> {
    fn from(value: f64) -> Self {
        Self { value, gradient: [0.0; N] }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.combine(other, self.value + other.value, 1.0, 1.0)
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.combine(other, self.value - other.value, 1.0, -1.0)
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.combine(other, self.value * other.value, other.value, self.value)
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        self.combine(other, quotient, 1.0 / other.value, -quotient / other.value)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.chain(self.value * factor, factor)
    }
}

impl<const N: usize> Add<f64> for Dual<N> {
    type Output = Self;
    fn add(self, term: f64) -> Self {
        self.chain(self.value + term, 1.0)
    }
}

impl<const N: usize> Scalar for Dual<N> {
    fn value(self) -> f64 {
        self.value
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        self.combine(x, self.value.atan2(x.value), x.value / square, -self.value / square)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample<T: Scalar>(x: T, y: T) -> T {
        let (sin, cos) = (x * y).sin_cos();
        (sin / (cos + 2.0) - x.tan()).atan2(y) + (x * x + y * y * 3.0).sqrt() + (-x)
    }

    #[test]
    fn gradient_is_the_limit_of_difference_quotients() {
        let (x, y, h) = (0.3, 1.7, 1e-6);
        let dual = sample(Dual::<2>::variable(x, 0), Dual::<2>::variable(y, 1));
        assert!((dual.value - sample(x, y)).abs() < 1e-15);
        let by_x = (sample(x + h, y) - sample(x - h, y)) / (2.0 * h);
        let by_y = (sample(x, y + h) - sample(x, y - h)) / (2.0 * h);
        assert!((dual.gradient[0] - by_x).abs() < 1e-9, "{} {by_x}", dual.gradient[0]);
        assert!((dual.gradient[1] - by_y).abs() < 1e-9, "{} {by_y}", dual.gradient[1]);
    }
}
