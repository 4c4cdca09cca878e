//! Coordinates of an export: their type, and the unit of angles.

use schemars::JsonSchema;
use serde::Deserialize;

/// Unit of angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AngleUnit {
    /// Degree.
    Deg,
    /// Radian.
    Rad,
    /// Gon: 400 in a full turn.
    Gon,
}

impl AngleUnit {
    /// Size of the unit (rad).
    pub fn in_rad(self) -> f64 {
        match self {
            Self::Deg => std::f64::consts::PI / 180.0,
            Self::Rad => 1.0,
            Self::Gon => std::f64::consts::PI / 200.0,
        }
    }

    /// Spelling in campaign.toml.
    pub fn name(self) -> &'static str {
        match self {
            Self::Deg => "deg",
            Self::Rad => "rad",
            Self::Gon => "gon",
        }
    }
}

/// Type of three coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CoordinateType {
    /// Cartesian: x, y, z.
    Cartesian,
    /// Cylindrical: radius, azimuth, z.
    Cylindrical,
    /// Spherical: azimuth, zenith or elevation, distance.
    Spherical,
}

impl CoordinateType {
    /// Spelling in campaign.toml.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cartesian => "cartesian",
            Self::Cylindrical => "cylindrical",
            Self::Spherical => "spherical",
        }
    }
}
