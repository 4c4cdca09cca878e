//! Option of the bound of uncertainties, one for all commands.

use etalon_base::message::{Place, Result};
use etalon_identify::UncertaintyBound;

/// Bound of the uncertainty of an answer that may be loaded.
#[derive(Clone, Debug, Default, clap::Args, serde::Deserialize)]
#[serde(default)]
pub struct BoundOption {
    /// Largest expanded uncertainty (k = 2) of an answer that may be loaded: a length, an angle, or
    /// both ("0.5 mm, 0.1 deg"). By default ten times the uncertainty of a coordinate, at least 2 %
    /// and at most 5 % of the measured extent; for angles this share in radians, at least 0.5 %.
    #[arg(long, value_name = "BOUND")]
    uncertainty_bound: Option<String>,
}

impl BoundOption {
    /// The given bound.
    ///
    /// # Errors
    /// Fails if the text is not a bound.
    pub(crate) fn stated(&self) -> Result<UncertaintyBound> {
        let stated = self.uncertainty_bound.as_deref().map(str::parse).transpose();
        Ok(stated
            .map_err(|problems: etalon_base::message::Problems| problems.at(&Place::file("--uncertainty-bound")))?
            .unwrap_or_default())
    }
}
