//! Numbers that know which measured coordinates they come from.
//!
//! A number carries its derivatives by every coordinate it depends on, so that results which share points or frames
//! are correlated as they are in truth (GUM, JCGM 100:2008, 5.2; Hall 2006, "Computing uncertainty with uncertain
//! numbers", Metrologia 43, L56).

use crate::base::scalar::Dual;

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

    /// The coordinate with this index itself.
    pub fn coordinate(value: f64, index: usize) -> Self {
        Self { value, by: vec![(index, 1.0)] }
    }

    /// The same derivatives with another value.
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

    /// `f` of numbers, its derivatives exact.
    pub fn of<const N: usize, const M: usize>(
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

    /// Mean of numbers; zero without any.
    pub fn mean<'a>(numbers: impl IntoIterator<Item = &'a Self>) -> Self {
        let numbers: Vec<&Self> = numbers.into_iter().collect();
        let share = 1.0 / numbers.len().max(1) as f64;
        let value = share * numbers.iter().map(|n| n.value).sum::<f64>();
        Self::linear(value, numbers.into_iter().map(|n| (share, n)))
    }

    /// Covariance with another number, given the standard uncertainty of every coordinate.
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

    /// Standard uncertainty, given that of every coordinate.
    pub fn standard_uncertainty(&self, standard_uncertainties: &[f64]) -> f64 {
        self.covariance(self, standard_uncertainties).sqrt()
    }

    /// The coordinates that it depends on.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> + '_ {
        self.by.iter().map(|b| b.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shared_is_correlated() {
        let (a, b) = (Uncertain::coordinate(3.0, 0), Uncertain::coordinate(4.0, 2));
        let u = [0.1, 9.0, 0.2];
        let [product] = Uncertain::of([&a, &b], |[a, b]| [a * b]);
        assert!((product.standard_uncertainty(&u) - (0.4f64 * 0.4 + 0.6 * 0.6).sqrt()).abs() < 1e-15);
        let [nothing] = Uncertain::of([&product, &a, &b], |[p, a, b]| [p / a - b]);
        assert!(nothing.value.abs() < 1e-15 && nothing.standard_uncertainty(&u) < 1e-15);
        assert!((product.covariance(&a, &u) - 4.0 * 0.01).abs() < 1e-15);
        assert_eq!(Uncertain::mean([&a, &b]).value, 3.5);
        assert_eq!(Uncertain::exact(2.0).standard_uncertainty(&u), 0.0);
    }
}
