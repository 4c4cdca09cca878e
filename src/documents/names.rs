//! Names of what documents enumerate, as texts of the catalogue.

use crate::{Effect, LimitQuantity, UncertaintySource};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;

impl Effect {
    /// Name of the effect.
    pub fn phrase(self) -> Phrase {
        match self {
            Self::Zeros => phrase!("zeros-of-the-joints"),
            Self::Geometry => phrase!("geometry"),
            Self::Gains => phrase!("gains"),
            Self::Harmonics => phrase!("harmonics-of-the-transmissions"),
            Self::Backlash => phrase!("backlash"),
            Self::Coupling => phrase!("coupling"),
            Self::Bending => phrase!("bending"),
            Self::Payload => phrase!("payload-bending"),
            Self::Torque => phrase!("torque-bending"),
            Self::Expansion => phrase!("expansion-with-temperature"),
            Self::Drift => phrase!("drift-with-temperature"),
            Self::Lateral => phrase!("lateral-bending"),
            Self::Pedestal => phrase!("pedestal-bending"),
        }
    }
}

impl LimitQuantity {
    /// Name of the limited quantity.
    pub fn phrase(self) -> Phrase {
        match self {
            Self::DistanceMaxMm => phrase!("limit-distance-max"),
            Self::SurfaceMaxMm => phrase!("limit-surface-max"),
            Self::ContactMaxMm => phrase!("limit-contact-max"),
            Self::CoordinateMaxMm => phrase!("limit-coordinate-max"),
            Self::PositionMaxMm => phrase!("limit-position-max"),
            Self::PositionMeanMm => phrase!("limit-position-mean"),
            Self::PositionRmsMm => phrase!("limit-position-rms"),
            Self::OrientationMaxDeg => phrase!("limit-orientation-max"),
            Self::RepeatabilityMaxMm => phrase!("limit-repeatability-max"),
            Self::AccuracyMaxMm => phrase!("limit-accuracy-max"),
        }
    }
}

impl UncertaintySource {
    /// Name of the source.
    pub fn phrase(self) -> Phrase {
        match self {
            Self::Instrument => phrase!("instrument"),
            Self::Contact => phrase!("contact"),
            Self::SingleCoordinates => phrase!("single-coordinates"),
            Self::Encoders => phrase!("encoders"),
            Self::RigidParts => phrase!("rigid-parts"),
            Self::KnownPoints => phrase!("known-points"),
            Self::NominalValues => phrase!("nominal-values"),
            Self::Repeatability => phrase!("repeatability"),
            Self::Model => phrase!("model"),
            Self::Residuals => phrase!("residuals"),
            Self::Frame => phrase!("world-frame"),
            Self::FrameOfPoses => phrase!("frames-of-poses"),
            Self::Scale => phrase!("scale"),
            Self::Temperature => phrase!("temperature"),
            Self::Homing => phrase!("homing"),
        }
    }
}
