//! Parameters of a format that holds only some of them: the estimate conditioned on the others at their nominal values.

use super::{ParameterStatus, ParametersDocument};
use std::collections::BTreeSet;

/// A variance below this share of its first value is zero by rounding.
const DETERMINED: f64 = 1e-12;

impl ParametersDocument {
    /// The estimate conditioned on nominal values of the identified parameters B that are named: values
    /// p_A − C_AB C_BB⁻¹ (p_B − p_B0) and covariance C_AA − C_AB C_BB⁻¹ C_BA of the others (Mardia, Kent & Bibby 1979, 3.2.4),
    /// one parameter of B after the other. `None` if the covariance does not contain them.
    pub fn conditioned(&self, left_out: &[&str]) -> Option<Self> {
        let names: Vec<String> = self.identified().map(|p| p.name.clone()).collect();
        let places: Vec<usize> =
            left_out.iter().map(|name| names.iter().position(|n| n == name)).collect::<Option<_>>()?;
        let mut covariance = self.covariance.clone();
        if covariance.len() != names.len() {
            return None;
        }
        let mut values: Vec<f64> = self.identified().map(|p| p.value).collect();
        let nominal: Vec<f64> = self.identified().map(|p| p.nominal).collect();
        for &b in &places {
            let variance = covariance[b][b];
            if !(variance > DETERMINED * self.covariance[b][b]) {
                return None;
            }
            let shares: Vec<f64> = covariance.iter().map(|row| row[b] / variance).collect();
            let (off, of_b) = (values[b] - nominal[b], covariance[b].clone());
            for (i, share) in shares.iter().enumerate() {
                values[i] -= share * off;
                covariance[i].iter_mut().zip(&of_b).for_each(|(c, b)| *c -= share * b);
            }
        }
        let kept: Vec<usize> = (0..names.len()).filter(|i| !places.contains(i)).collect();
        let mut document = self.holding(left_out);
        for &i in &kept {
            let Some(p) = document.parameters.iter_mut().find(|p| p.name == names[i]) else { continue };
            let u = covariance[i][i].max(0.0).sqrt();
            // 1 - (u/s)² with the standard uncertainty s by the tolerance
            p.determined = p
                .determined
                .zip(p.standard_uncertainty)
                .map(|(share, before)| 1.0 - (1.0 - share) * if before > 0.0 { (u / before).powi(2) } else { 1.0 });
            (p.value, p.standard_uncertainty) = (values[i], Some(u));
        }
        document.covariance = kept.iter().map(|&i| kept.iter().map(|&j| covariance[i][j]).collect()).collect();
        Some(document)
    }

    /// The same parameters with these fixed at their nominal values, and without what describes all of them together.
    pub(crate) fn holding(&self, names: &[&str]) -> Self {
        let names: BTreeSet<&str> = names.iter().copied().collect();
        let mut document = self.clone();
        for p in document.parameters.iter_mut().filter(|p| names.contains(p.name.as_str())) {
            (p.value, p.status) = (p.nominal, ParameterStatus::Fixed);
            (p.standard_uncertainty, p.degrees_of_freedom, p.determined) = (None, None, None);
        }
        document.covariance.clear();
        document.budget.clear();
        (document.reliability, document.robust, document.observability) = (None, None, None);
        document
    }
}
