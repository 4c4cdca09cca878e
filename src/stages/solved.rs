//! Parameters before and after an identification.

use etalon_identify::Identification;

/// Parameters of the nominal robot with base and targets fitted, and the identification from there.
pub struct Solved {
    /// All parameters before.
    pub before: Vec<f64>,
    /// The identification.
    pub found: Identification,
}
