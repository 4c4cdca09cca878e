//! Upper limits of counts in files and options, checked before memory is allocated.

use super::catalogue::Phrase;
use super::message::Result;
use crate::{error, phrase};
use serde::{Deserialize, Deserializer, de};

/// Maximum number of poses, repeats or draws in a file.
pub const MOST: u64 = 1_000_000;

/// Reads a count of a TOML file, at most `M`.
pub fn at_most<'de, D: Deserializer<'de>, T: TryFrom<i64>, const M: u64>(
    deserializer: D,
) -> std::result::Result<T, D::Error> {
    let count = i64::deserialize(deserializer)?;
    match T::try_from(count) {
        Ok(value) if count <= M as i64 => Ok(value),
        _ => Err(de::Error::custom(format!("{count} is not a count from 0 to {M}"))),
    }
}

/// Checks the product of counts; `what` names the product.
///
/// # Errors
///
/// Reports a product above `most` with its factors.
pub fn product_at_most(of: Phrase, counts: &[(&str, u64)], most: u64) -> Result<()> {
    let product = counts.iter().fold(1u64, |product, (_, count)| product.saturating_mul(*count));
    if product <= most {
        return Ok(());
    }
    let factor = |(of, count): &(&str, u64)| phrase!("factor", count, of);
    let counts = counts.iter().map(factor).reduce(|first, second| phrase!("product", first, second));
    Err(error!("counts-too-large", of, counts, most).into())
}

/// Reads a count of an option, at most `M`.
pub fn option_at_most<const M: usize>(text: &str) -> std::result::Result<usize, String> {
    let wrong = || phrase!("expected-whole-number", most = M).to_string();
    text.trim().parse().ok().filter(|count| *count <= M).ok_or_else(wrong)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_end_at_their_bound() {
        assert_eq!((option_at_most::<9>("9"), option_at_most::<9>("10").is_err()), (Ok(9), true));
        assert!(option_at_most::<9>("18446744073709551616").is_err());
        assert!(product_at_most(phrase!("poses-and-cycles"), &[("poses", 3), ("cycles", 3)], 9).is_ok());
        for many in [4, u64::MAX] {
            let error = product_at_most(phrase!("poses-and-cycles"), &[("poses", 3), ("cycles", many)], 9).unwrap_err();
            let factor = |count: u64, of: &str| phrase!("factor", count, of);
            let counts = phrase!("product", first = factor(3, "poses"), second = factor(many, "cycles"));
            assert!(error.0[0].is("counts-too-large", &[("counts", &counts), ("most", &9)]), "{error}");
        }
    }
}
