//! Values that readings give in addition to joint values: payload, torques, temperature.

use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_robots::Circumstance;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Maximum number of distinct values that are listed.
const LISTED: usize = 5;

/// Quantity that each reading gives in addition to joint values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ReadingQuantity {
    /// Mass of the payload (kg).
    PayloadMass,
    /// Coordinate of the payload's centre of mass in the flange (mm).
    PayloadCentre,
    /// Torque of a joint (N·m).
    Torque,
    /// Temperature of the robot (°C).
    Temperature,
}

impl ReadingQuantity {
    /// Unit of the values.
    pub fn unit(self) -> &'static str {
        match self {
            Self::PayloadMass => "kg",
            Self::PayloadCentre => "mm",
            Self::Torque => "N·m",
            Self::Temperature => "°C",
        }
    }

    /// Name of the quantity.
    pub fn phrase(self) -> Phrase {
        match self {
            Self::PayloadMass => phrase!("reading-payload-mass"),
            Self::PayloadCentre => phrase!("reading-payload-centre"),
            Self::Torque => phrase!("reading-torque"),
            Self::Temperature => phrase!("reading-temperature"),
        }
    }
}

impl From<Circumstance> for ReadingQuantity {
    fn from(value: Circumstance) -> Self {
        match value {
            Circumstance::PayloadMass => Self::PayloadMass,
            Circumstance::PayloadCentre(_) => Self::PayloadCentre,
            Circumstance::Torque(_) => Self::Torque,
            Circumstance::Temperature => Self::Temperature,
        }
    }
}

/// Values of one column at the poses of a set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReadingValues {
    /// Column of the readings, which names the unit: `load_kg`.
    pub column: String,
    /// Quantity of the column.
    pub quantity: ReadingQuantity,
    /// Lowest value.
    pub lowest: f64,
    /// Highest value.
    pub highest: f64,
    /// Distinct values in ascending order; absent if there are more than five.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub distinct: Vec<f64>,
}

impl ReadingValues {
    /// Range and distinct values of a column; `None` without values.
    pub fn new(column: String, quantity: ReadingQuantity, mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let (lowest, highest) = (*values.first()?, *values.last()?);
        values.dedup();
        let distinct = if values.len() > LISTED { Vec::new() } else { values };
        Some(Self { column, quantity, lowest, highest, distinct })
    }
}

/// Input of a controller file in addition to joint values: effects in the file depend on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FileInput {
    /// Column of the readings, which names the unit: `load_kg`.
    pub column: String,
    /// Quantity of the column.
    pub quantity: ReadingQuantity,
    /// Value without effect, at which the announced poses are computed: no payload, no torque,
    /// the reference temperature.
    pub neutral: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_distinct_values_are_listed_and_many_have_a_range() {
        let values = |all: &[f64]| ReadingValues::new("load_kg".into(), ReadingQuantity::PayloadMass, all.to_vec());
        let few = values(&[3.0, 0.0, 1.5, 0.0, 3.0]).unwrap();
        assert_eq!((few.lowest, few.highest, few.distinct), (0.0, 3.0, vec![0.0, 1.5, 3.0]));
        let many = values(&[20.0, 25.5, 21.0, 22.0, 23.0, 24.0]).unwrap();
        assert_eq!((many.lowest, many.highest, many.distinct), (20.0, 25.5, vec![]));
        assert_eq!(values(&[]), None);
    }
}
