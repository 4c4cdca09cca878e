//! Numbers with their measured coordinates: readings, computed values and repeats.
//!
//! A number carries its derivatives by every coordinate it depends on, so that results which share
//! points or frames are correlated as they are in truth (GUM, JCGM 100:2008, 5.2; Hall 2006,
//! "Computing uncertainty with uncertain numbers", Metrologia 43, L56).

use crate::chi_square_exceeds;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::scalar::Dual;
use etalon_math::Factor;
use etalon_math::statistics::{mean, standard_deviation};

/// A value and its derivatives by measured coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uncertain {
    /// The value.
    pub value: f64,
    /// Index of a coordinate and the derivative by it, in ascending order of the indices.
    by: Vec<(usize, f64)>,
}

impl Uncertain {
    /// A number without uncertainty.
    pub fn exact(value: f64) -> Self {
        Self { value, by: Vec::new() }
    }

    /// Returns the measured coordinate with this index.
    pub fn coordinate(value: f64, index: usize) -> Self {
        Self { value, by: vec![(index, 1.0)] }
    }

    /// Same derivatives with another value.
    pub fn at(self, value: f64) -> Self {
        Self { value, ..self }
    }

    /// `value` with the derivatives Σ slope · term'.
    pub fn linear<'a>(value: f64, terms: impl IntoIterator<Item = (f64, &'a Self)>) -> Self {
        let mut by: Vec<(usize, f64)> = Vec::new();
        for (slope, term) in terms {
            by.extend(term.by.iter().map(|&(i, d)| (i, slope * d)));
        }
        by.sort_by_key(|&(i, _)| i);
        by.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        Self { value, by }
    }

    /// `f` of numbers, with exact derivatives.
    pub fn propagate<const N: usize, const M: usize>(
        inputs: [&Self; N],
        f: impl Fn([Dual<N>; N]) -> [Dual<N>; M],
    ) -> [Self; M] {
        let mut index = 0;
        let variables = inputs.map(|input| {
            index += 1;
            Dual::variable(input.value, index - 1)
        });
        f(variables).map(|out| Self::linear(out.value, out.gradient.into_iter().zip(inputs)))
    }

    /// Mean of numbers; zero without numbers.
    pub fn mean<'a>(numbers: impl IntoIterator<Item = &'a Self>) -> Self {
        let numbers: Vec<&Self> = numbers.into_iter().collect();
        let share = 1.0 / numbers.len().max(1) as f64;
        let value = share * numbers.iter().map(|n| n.value).sum::<f64>();
        Self::linear(value, numbers.into_iter().map(|n| (share, n)))
    }

    /// Returns the covariance with another number, for these standard uncertainties of the
    /// coordinates.
    pub fn covariance(&self, other: &Self, standard_uncertainties: &[f64]) -> f64 {
        let mut theirs = other.by.iter().peekable();
        let mut sum = 0.0;
        for &(i, d) in &self.by {
            while theirs.next_if(|t| t.0 < i).is_some() {}
            if let Some(&&(_, e)) = theirs.peek().filter(|t| t.0 == i) {
                let u = standard_uncertainties.get(i).copied().unwrap_or(0.0);
                sum += d * e * u * u;
            }
        }
        sum
    }

    /// Returns the standard uncertainty, for these standard uncertainties of the coordinates.
    pub fn standard_uncertainty(&self, standard_uncertainties: &[f64]) -> f64 {
        self.covariance(self, standard_uncertainties).sqrt()
    }

    /// Coordinates on which the number depends.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> + '_ {
        self.by.iter().map(|b| b.0)
    }
}

/// A measured point.
pub type UncertainPoint = [Uncertain; 3];

/// A point in a plane.
pub type Flat = [Uncertain; 2];

/// All measured coordinates with their standard uncertainties.
#[derive(Clone, Debug)]
pub struct Readings {
    stated_mm: f64,
    standard_uncertainties_mm: Vec<f64>,
}

/// Residuals of one fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Number of residuals.
    pub count: usize,
    /// Number of residuals minus number of fitted parameters.
    pub degrees_of_freedom: usize,
    /// Root of the sum of their squares over the degrees of freedom.
    pub standard_deviation_mm: f64,
    /// Largest absolute residual.
    pub max_mm: f64,
    /// Root of the sum of squares, as in the thesis (2.6.1).
    pub norm_mm: f64,
    /// Standard deviation expected from the given uncertainty.
    pub expected_mm: f64,
    /// Inflation factor of the uncertainties of the points, if the residuals scatter more than
    /// given; otherwise 1.
    pub inflation_factor: f64,
}

impl Readings {
    /// Creates readings of an instrument with this standard uncertainty of one coordinate (mm).
    pub fn new(stated_mm: f64) -> Self {
        Self { stated_mm, standard_uncertainties_mm: Vec::new() }
    }

    /// Adds points (mm).
    pub fn add(&mut self, points: &[Vector]) -> Vec<UncertainPoint> {
        points.iter().map(|&p| self.add_one(p)).collect()
    }

    /// Adds a point (mm).
    pub fn add_one(&mut self, p: Vector) -> UncertainPoint {
        let first = self.standard_uncertainties_mm.len();
        self.standard_uncertainties_mm.extend([self.stated_mm; 3]);
        [0, 1, 2].map(|k| Uncertain::coordinate(p[k], first + k))
    }

    /// Standard uncertainty of every coordinate, in mm.
    pub fn standard_uncertainties_mm(&self) -> &[f64] {
        &self.standard_uncertainties_mm
    }

    /// Judges residuals with the uncertainties of `moves`: if chi-square rejects the given
    /// uncertainty, the uncertainty of `points` is inflated to the scatter of the residuals.
    pub fn judge(
        &mut self,
        residuals_mm: &[f64],
        moves: &[Uncertain],
        fitted: usize,
        points: &[UncertainPoint],
    ) -> Scatter {
        let u = &self.standard_uncertainties_mm;
        let variances: Vec<f64> = moves.iter().map(|m| m.covariance(m, u)).collect();
        let squares: f64 = residuals_mm.iter().map(|r| r * r).sum();
        let chi_square: f64 = residuals_mm.iter().zip(&variances).map(|(r, v)| r * r / v).sum();
        let dof = residuals_mm.len().saturating_sub(fitted);
        let rejected = dof > 0 && chi_square_exceeds(chi_square, dof);
        let inflation_factor = if rejected { (chi_square / dof as f64).sqrt() } else { 1.0 };
        for i in points.iter().flatten().flat_map(|x| x.coordinates()) {
            if let Some(u) = self.standard_uncertainties_mm.get_mut(i) {
                *u *= inflation_factor;
            }
        }
        Scatter {
            count: residuals_mm.len(),
            degrees_of_freedom: dof,
            standard_deviation_mm: if dof > 0 { (squares / dof as f64).sqrt() } else { 0.0 },
            max_mm: residuals_mm.iter().fold(0.0, |m, r| m.max(r.abs())),
            norm_mm: squares.sqrt(),
            expected_mm: mean(variances).sqrt(),
            inflation_factor,
        }
    }
}

/// The values of points.
pub(super) fn values<const N: usize>(points: &[[Uncertain; N]]) -> Vec<[f64; N]> {
    points.iter().map(|p| p.each_ref().map(|x| x.value)).collect()
}

/// Derivative of the solution x of min Σ d² with respect to the points: −(JᵀJ)⁻¹Jᵀ δ, with `rows`
/// of J = ∂d/∂x and `moves` δ of each distance d at fixed x. First order in the points, and in
/// residuals that are small relative to the element.
pub(super) fn shifts<const N: usize>(rows: &[[f64; N]], moves: &[Uncertain]) -> Result<[Uncertain; N]> {
    let factor = Factor::new(rows.as_flattened(), &vec![0.0; rows.len()], &[1.0; N]);
    let undetermined = || error!("points-undetermined");
    let inverse = factor.inverse_normal().filter(|v| v.iter().all(|v| v.is_finite())).ok_or_else(undetermined)?;
    let gain = |k: usize, row: &[f64; N]| -> f64 {
        -row.iter().enumerate().map(|(j, r)| inverse.get(k * N + j).copied().unwrap_or(0.0) * r).sum::<f64>()
    };
    let mut index = 0;
    Ok([(); N].map(|()| {
        index += 1;
        Uncertain::linear(0.0, rows.iter().map(|row| gain(index - 1, row)).zip(moves))
    }))
}

/// Mean and standard deviation (n − 1; zero for a single value) of values; `None` without values.
pub fn mean_and_sd(values: &[f64]) -> Option<(f64, f64)> {
    (!values.is_empty()).then(|| (mean(values.iter().copied()), standard_deviation(values)))
}

/// Repeated determinations of one quantity, with their mean as the result.
#[derive(Clone, Debug)]
pub struct Repeated {
    /// Each determination.
    pub values: Vec<Uncertain>,
    /// Their mean.
    pub mean: Uncertain,
}

/// Scatter of repeats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeats {
    /// Standard deviation of the determinations; zero for a single one.
    pub standard_deviation: f64,
    /// Scatter expected from the uncertainties of the points.
    pub expected: f64,
    /// Variance of the mean in excess of the variance of the points: zero unless chi-square rejects
    /// the points' uncertainty.
    pub excess_variance: f64,
}

impl Repeated {
    /// Creates the mean of determinations.
    pub fn new(values: Vec<Uncertain>) -> Self {
        let mean = Uncertain::mean(&values);
        Self { values, mean }
    }

    /// Scatter of the repeats compared with the uncertainties of their points. Common errors (base
    /// frame, C) cancel between repeats.
    pub fn repeats(&self, readings: &Readings) -> Repeats {
        let u = readings.standard_uncertainties_mm();
        let n = self.values.len();
        let plain: Vec<f64> = self.values.iter().map(|v| v.value).collect();
        let standard_deviation = standard_deviation(&plain);
        let own = self.values.iter().map(|v| Uncertain::linear(0.0, [(1.0, v), (-1.0, &self.mean)]));
        let expected_variance = own.map(|v| v.covariance(&v, u)).sum::<f64>() / n.saturating_sub(1).max(1) as f64;
        let dof = n.saturating_sub(1);
        let variance = standard_deviation * standard_deviation;
        let rejected = dof > 0 && chi_square_exceeds(dof as f64 * variance / expected_variance, dof);
        let excess_variance = if rejected { (variance - expected_variance).max(0.0) / n as f64 } else { 0.0 };
        Repeats { standard_deviation, expected: expected_variance.sqrt(), excess_variance }
    }

    /// Standard uncertainty of the mean: from the points, and from the excess scatter of the
    /// repeats.
    pub fn standard_uncertainty(&self, readings: &Readings) -> f64 {
        let u = readings.standard_uncertainties_mm();
        (self.mean.covariance(&self.mean, u) + self.repeats(readings).excess_variance).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shared_is_correlated() {
        let (a, b) = (Uncertain::coordinate(3.0, 0), Uncertain::coordinate(4.0, 2));
        let u = [0.1, 9.0, 0.2];
        let [product] = Uncertain::propagate([&a, &b], |[a, b]| [a * b]);
        assert!((product.standard_uncertainty(&u) - (0.4f64 * 0.4 + 0.6 * 0.6).sqrt()).abs() < 1e-15);
        let [nothing] = Uncertain::propagate([&product, &a, &b], |[p, a, b]| [p / a - b]);
        assert!(nothing.value.abs() < 1e-15 && nothing.standard_uncertainty(&u) < 1e-15);
        assert!((product.covariance(&a, &u) - 4.0 * 0.01).abs() < 1e-15);
        assert_eq!(Uncertain::mean([&a, &b]).value, 3.5);
        assert_eq!(Uncertain::exact(2.0).standard_uncertainty(&u), 0.0);
    }

    #[test]
    fn equal_rows_do_not_determine_two_quantities() {
        let moves = [0.0, 0.0, 0.0].map(Uncertain::exact);
        let refused = shifts(&[[1.0, 1.0]; 3], &moves).err().unwrap().0;
        assert!(refused.len() == 1 && refused[0].is("points-undetermined", &[]), "{refused:?}");
        assert!(shifts(&[[1.0, 1.0], [1.0, 2.0], [1.0, 3.0]], &moves).is_ok());
    }
}
