//! Roles and effects of parameters, as documents spell them.

use etalon_robots as robots;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a parameter describes: decides what is fitted "before" the calibration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Pose of the base in the world.
    Base,
    /// Places of the targets on the moving part.
    Target,
    /// What targets touch or are measured from: points and planes that are fixed in the world.
    Fixture,
    /// Geometry, joint offsets, gains and compliance of the robot itself.
    #[default]
    Robot,
}

impl From<robots::Role> for Role {
    fn from(role: robots::Role) -> Self {
        match role {
            robots::Role::Base => Self::Base,
            robots::Role::Target => Self::Target,
            robots::Role::Fixture => Self::Fixture,
            robots::Role::Robot => Self::Robot,
        }
    }
}

/// What a parameter of the robot itself describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Effect {
    /// Zeros of the joints.
    Zeros,
    /// Lengths and angles of the parts.
    Geometry,
    /// Gains: leads, ratios of the transmissions.
    Gains,
    /// Harmonics of the transmissions.
    Harmonics,
    /// Backlash of the joints.
    Backlash,
    /// Coupling of one joint to another.
    Coupling,
    /// Bending of joints and links under loads.
    Bending,
}

impl From<robots::Effect> for Effect {
    fn from(effect: robots::Effect) -> Self {
        match effect {
            robots::Effect::Zeros => Self::Zeros,
            robots::Effect::Geometry => Self::Geometry,
            robots::Effect::Gains => Self::Gains,
            robots::Effect::Harmonics => Self::Harmonics,
            robots::Effect::Backlash => Self::Backlash,
            robots::Effect::Coupling => Self::Coupling,
            robots::Effect::Bending => Self::Bending,
        }
    }
}
