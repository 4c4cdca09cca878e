//! `[join]`: assignment of measurements to joint values.

use schemars::JsonSchema;
use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;
use toml::Spanned;

/// Assignment of points to joint values.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Join {
    /// Key of the join.
    #[schemars(schema_with = "join_by")]
    pub by: JoinBy,
    /// Targets that become observations; all targets of the robot if absent.
    #[schemars(with = "Option<Vec<String>>")]
    pub targets: Option<Vec<Spanned<String>>>,
    /// Time of the measurement minus time of the log, for a join by time. `standstills` determines
    /// it from the standstills of the log, `motion` from the speeds of a motion that measurement
    /// and log contain.
    pub clock_offset_s: Option<ClockOffset>,
    /// For clocks that drift apart: with the same word as `clock_offset_s`, the ratio of the clock
    /// rates is determined too (within 100 ppm).
    pub clock_rate: Option<ClockRate>,
    /// Upper limit for the difference of the times, for a join by time.
    pub tolerance_s: Option<f64>,
    /// Interpolates joint values between the previous and the next row, for a join by time.
    #[serde(default)]
    pub interpolate: bool,
}

#[cfg(feature = "schemas")]
fn join_by(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({ "anyOf": [
        { "enum": [["pose", "cycle"], ["cycle", "pose"], ["pose"]] },
        { "enum": ["pose", "row", "time", "label"] },
    ] })
}

etalon_base::schema_by_hand!(ClockOffset, _ => schemars::json_schema!({ "anyOf": [{ "type": "number" }, { "enum": ["standstills", "motion"] }] }));

/// Rate of two clocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ClockRate {
    /// Determined from the standstills of the log, if no offset alone fits.
    Standstills,
    /// Determined from the speeds of a motion, if it is significant.
    Motion,
}

/// Offset of two clocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClockOffset {
    /// Given offset.
    Stated(f64),
    /// Determined from the standstills of the log; every point was measured during one.
    Standstills,
    /// Determined from the speeds of a motion that measurement and log recorded.
    Motion,
}

impl<'de> Deserialize<'de> for ClockOffset {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Offset;
        impl Visitor<'_> for Offset {
            type Value = ClockOffset;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a number of seconds, or \"standstills\", \"motion\"")
            }
            fn visit_f64<E: de::Error>(self, value: f64) -> Result<ClockOffset, E> {
                Ok(ClockOffset::Stated(value))
            }
            fn visit_i64<E: de::Error>(self, value: i64) -> Result<ClockOffset, E> {
                Ok(ClockOffset::Stated(value as f64))
            }
            fn visit_str<E: de::Error>(self, text: &str) -> Result<ClockOffset, E> {
                match text {
                    "standstills" => Ok(ClockOffset::Standstills),
                    "motion" => Ok(ClockOffset::Motion),
                    _ => Err(E::invalid_value(de::Unexpected::Str(text), &self)),
                }
            }
        }
        deserializer.deserialize_any(Offset)
    }
}

impl Join {
    /// Offset of the clocks, if given.
    pub fn stated_offset_s(&self) -> Option<f64> {
        match self.clock_offset_s? {
            ClockOffset::Stated(offset_s) => Some(offset_s),
            ClockOffset::Standstills | ClockOffset::Motion => None,
        }
    }
}

/// Key of a join.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JoinBy {
    /// Pose and cycle.
    PoseAndCycle,
    /// Pose; the log has one row for all cycles.
    Pose,
    /// Number of the row; the numbers of rows must agree.
    Row,
    /// Nearest time.
    Time,
    /// Label of the point that the robot touches according to the log; the point is measured once
    /// and touched repeatedly.
    Label,
}

impl<'de> Deserialize<'de> for JoinBy {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Key;
        impl<'de> Visitor<'de> for Key {
            type Value = JoinBy;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("[\"pose\", \"cycle\"], [\"pose\"], \"row\", \"time\" or \"label\"")
            }
            fn visit_str<E: de::Error>(self, text: &str) -> Result<JoinBy, E> {
                match text {
                    "row" => Ok(JoinBy::Row),
                    "time" => Ok(JoinBy::Time),
                    "label" => Ok(JoinBy::Label),
                    "pose" => Ok(JoinBy::Pose),
                    _ => Err(E::invalid_value(de::Unexpected::Str(text), &self)),
                }
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<JoinBy, A::Error> {
                let mut keys: Vec<String> = Vec::new();
                while let Some(key) = seq.next_element()? {
                    keys.push(key);
                }
                keys.sort();
                match keys.iter().map(String::as_str).collect::<Vec<_>>()[..] {
                    ["cycle", "pose"] => Ok(JoinBy::PoseAndCycle),
                    ["pose"] => Ok(JoinBy::Pose),
                    _ => Err(de::Error::custom(format!("`by` names {}", keys.join(", ")))),
                }
            }
        }
        deserializer.deserialize_any(Key)
    }
}
