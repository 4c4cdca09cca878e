//! Estimate of some parameters, conditioned on nominal values of the others.

use super::{ParameterStatus, ParametersDocument};
use std::collections::BTreeSet;

/// Variances below this share of the original variance are rounding errors and count as zero.
const DETERMINED: f64 = 1e-12;

impl ParametersDocument {
    /// Conditions the estimate on nominal values of the named parameters B, one after the other.
    ///
    /// Values of the others are p_A − C_AB C_BB⁻¹ (p_B − p_B0); their covariance is C_AA − C_AB
    /// C_BB⁻¹ C_BA (Mardia, Kent & Bibby 1979, 3.2.4). Returns `None` if the covariance does not
    /// have a parameter of B, unless all of B are at their nominal values.
    pub fn conditioned(&self, left_out: &[&str]) -> Option<Self> {
        let names: Vec<String> = self.identified().map(|p| p.name.clone()).collect();
        let place = |name: &&str| names.iter().position(|n| n == name).filter(|_| self.covariance.len() == names.len());
        let Some(places) = left_out.iter().map(place).collect::<Option<Vec<usize>>>() else {
            let is_nominal = |name: &&str| self.parameters.iter().any(|p| p.name == **name && p.value == p.nominal);
            return left_out.iter().all(is_nominal).then(|| self.holding(left_out));
        };
        let mut covariance = self.covariance.clone();
        let mut values: Vec<f64> = self.identified().map(|p| p.value).collect();
        let nominal: Vec<f64> = self.identified().map(|p| p.nominal).collect();
        for &b in &places {
            let variance = covariance[b][b];
            if variance <= DETERMINED * self.covariance[b][b] || variance.is_nan() {
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
            // 1 − (u/s)², where s is the standard uncertainty from the tolerance
            p.determined = p
                .determined
                .zip(p.standard_uncertainty)
                .map(|(share, before)| 1.0 - (1.0 - share) * if before > 0.0 { (u / before).powi(2) } else { 1.0 });
            (p.value, p.standard_uncertainty) = (values[i], Some(u));
        }
        document.covariance = kept.iter().map(|&i| kept.iter().map(|&j| covariance[i][j]).collect()).collect();
        Some(document)
    }

    /// Copy with the named parameters fixed at their nominal values, without covariance, budget and
    /// checks of the whole result.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn document() -> ParametersDocument {
        let parameter = |name: &str, value: f64, u: Option<f64>| {
            serde_json::json!({
                "name": name, "unit": "1", "nominal": 1.0, "before": 1.0, "value": value, "standard_uncertainty": u,
                "degrees_of_freedom": null, "status": if u.is_some() { "identified" } else { "fixed" }, "confounded_with": []
            })
        };
        serde_json::from_value(serde_json::json!({
            "schema": "etalon/parameters/2", "robot": "serial",
            "parameters": [parameter("a", 3.0, Some(2.0)), parameter("held", 1.0, None), parameter("b", 5.0, Some(4.0))],
            "covariance": [[4.0, 6.0], [6.0, 16.0]],
            "residuals": {
                "kind": "targets", "count": 0, "rms": 0.0, "max": 0.0, "degrees_of_freedom": 0,
                "stated_standard_uncertainty_mm": null, "common_standard_uncertainty_mm": null, "chi_square": null,
                "uncertainties_from": "instrument", "uncertainties_enlarged_by": 1.0
            },
            "observability": null,
            "solver": { "method": "lm", "iterations": 1, "termination": "step_vanished", "meaning": "" },
            "messages": [], "provenance": { "version": "0.1.0", "inputs": {}, "seed": null }
        }))
        .unwrap()
    }

    #[test]
    fn two_correlated_parameters_by_hand() {
        // 3 - 6/16 (5 - 1) = 1.5; 4 - 6²/16 = 1.75
        let conditioned = document().conditioned(&["b"]).unwrap();
        let [a, held, b] = &conditioned.parameters[..] else { panic!() };
        assert_eq!((a.value, a.standard_uncertainty), (1.5, Some(1.75f64.sqrt())));
        assert_eq!((held.value, b.value, b.standard_uncertainty, b.status), (1.0, 1.0, None, ParameterStatus::Fixed));
        assert_eq!(conditioned.covariance, [[1.75]]);
        assert_eq!(conditioned.check(), Ok(()));
    }

    #[test]
    fn what_the_covariance_does_not_contain_cannot_be_left_out() {
        assert!(document().conditioned(&["c"]).is_none());
        // a parameter at its nominal value does not change the others
        assert_eq!(document().conditioned(&["held"]).unwrap().parameters[0].value, 3.0);
        let mut without = document();
        without.covariance.clear();
        assert!(without.conditioned(&["a"]).is_none());
    }
}
