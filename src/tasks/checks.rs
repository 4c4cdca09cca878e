//! Checks of options that several commands have.

use crate::stages::orientations::AngleOrder;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::{error, phrase};
use etalon_campaign::PLAUSIBLE_EXPANDED_UM;

/// Checks that the number of an option, if given, is positive.
pub(crate) fn check_positive(option: &str, stated: Option<f64>) -> Result<()> {
    match stated.is_none_or(|value| value > 0.0 && value.is_finite()) {
        true => Ok(()),
        false => Err(error!("option-not-positive", option).into()),
    }
}

/// Rejects values that cannot be the standard uncertainty of a coordinate in micrometres.
pub(super) fn check_uncertainty(option: &str, stated_um: Option<f64>) -> Result<()> {
    match stated_um.is_none_or(|u| PLAUSIBLE_EXPANDED_UM.contains(&(2.0 * u))) {
        true => Ok(()),
        false => Err(error!("uncertainty-implausible", option).into()),
    }
}

/// Rejects values that cannot be the expanded uncertainty of a coordinate in micrometres.
pub(super) fn check_expanded(option: &str, stated_um: Option<f64>) -> Result<()> {
    match stated_um.is_none_or(|u| PLAUSIBLE_EXPANDED_UM.contains(&u)) {
        true => Ok(()),
        false => Err(error!("uncertainty-implausible", option).hint(phrase!("state-expanded-um")).into()),
    }
}

/// Error about an option without another, on which it depends.
pub(super) fn needs(option: &str, other: &str) -> Problems {
    error!("option-of-call-refused", reason = format!("`{option}` needs `{other}`")).into()
}

/// Order of the angles of an option.
pub(super) fn angle_order(option: &str, stated: Option<&str>) -> Result<Option<AngleOrder>> {
    let order = stated.map(str::parse).transpose();
    order.map_err(|message: Message| Problems::from(message.at(Place::file(option))))
}
