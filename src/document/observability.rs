//! What the poses can tell of the parameters, as documents say it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Observability of the parameters from the poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObservabilitySummary {
    /// O1 = (σ1…σm)^(1/m) / √n, m parameters and n poses (Sun & Hollerbach 2008).
    pub o1: f64,
    /// O2 = σmin / σmax (eq. 1.20).
    pub o2: f64,
    /// O3 = σmin (eq. 1.22).
    pub o3: f64,
    /// O4 = σmin² / σmax (eq. 1.23).
    pub o4: f64,
    /// O5 = 1 / Σ 1/σ (eq. 1.25).
    pub o5: f64,
    /// Condition number with columns divided by their norms.
    pub condition: f64,
    /// Number of parameters told apart.
    pub rank: usize,
    /// Which scaling the indices have.
    pub scaling: String,
    /// Singular values behind the condition number, descending: of the Jacobian at the solution, its columns divided by
    /// their norms, as the identification uses it. Their squares add up to the number of parameters.
    #[serde(default)]
    pub singular_values: Vec<SingularValueEntry>,
    /// Of the same Jacobian with all parameters that were to be identified the smallest, as many as are held because the
    /// data do not tell them, or only uselessly badly; empty in a plan.
    #[serde(default)]
    pub held_singular_values: Vec<SingularValueEntry>,
    /// A column that lies this near to the span of those before it, for a norm of 1, is cut: its parameter is held.
    #[serde(default)]
    pub rank_cut: f64,
}

/// How strongly the residuals answer to one direction of the parameters: small where it is badly observable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SingularValueEntry {
    /// The singular value, without unit.
    pub value: f64,
    /// Parameters with a share of more than 0.3 in its right singular vector, the largest first; empty where the direction
    /// is spread over many.
    pub parameters: Vec<String>,
}
