//! Pose numbers from the order of the rows.

use etalon_base::phrase;
use serde::de;
use serde::{Deserialize, Deserializer};

/// Pose number that follows from the number of the data row: `row`, or `row + 100` with an offset.
/// Data rows count from 1; rejected rows count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FromRow {
    added: i64,
}

impl FromRow {
    /// Returns the pose number of a row.
    pub fn number(self, row: i64) -> i64 {
        row.saturating_add(self.added)
    }
}

etalon_base::schema_by_hand!(FromRow, _ => {
    let description = "Number of the data row, from 1 (refused rows count), with an optional offset.";
    schemars::json_schema!({ "description": description, "type": "string", "pattern": "^row( *\\+ *[0-9]{1,9})?$" })
});

impl<'de> Deserialize<'de> for FromRow {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let added = match text.strip_prefix("row").map(str::trim) {
            Some("") => Some(0),
            Some(more) => more.strip_prefix('+').and_then(|more| more.trim().parse::<u32>().ok()),
            None => None,
        };
        let added = added.ok_or_else(|| de::Error::custom(phrase!("row-number-unknown", stated = text)))?;
        Ok(Self { added: added.into() })
    }
}
