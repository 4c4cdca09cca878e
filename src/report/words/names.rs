//! Names of enumerated values in documents.

use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{Effect, ErrorQuantity, Figure, LimitQuantity, PoseSet, SourceKind, UncertaintySource};

/// Name of a set of poses.
pub(crate) fn set(set: PoseSet) -> Phrase {
    match set {
        PoseSet::Calibration => phrase!("calibration"),
        PoseSet::Validation => phrase!("validation"),
    }
}

/// Name of a quantity whose errors are counted.
pub(crate) fn quantity(quantity: ErrorQuantity) -> Phrase {
    match quantity {
        ErrorQuantity::Position => phrase!("position"),
        ErrorQuantity::X => phrase!("axis-x"),
        ErrorQuantity::Y => phrase!("axis-y"),
        ErrorQuantity::Z => phrase!("axis-z"),
        ErrorQuantity::Orientation => phrase!("orientation"),
        ErrorQuantity::Distance => phrase!("distance"),
        ErrorQuantity::Surface => phrase!("surface"),
        ErrorQuantity::Contact => phrase!("contact"),
        ErrorQuantity::Coordinate => phrase!("coordinate"),
    }
}

/// Kind of a robot, by the key of its model.
pub(crate) fn model(key: &str) -> Option<Phrase> {
    Some(match key {
        "serial" => phrase!("model-serial"),
        "urdf" => phrase!("model-urdf"),
        "prexyt" => phrase!("model-prexyt"),
        "five_bar" => phrase!("model-five-bar"),
        "hexapod" => phrase!("model-hexapod"),
        "delta" => phrase!("model-delta"),
        "delta_linear" => phrase!("model-delta-linear"),
        _ => return None,
    })
}

/// Name of a limited quantity.
pub(crate) fn limit(quantity: LimitQuantity) -> Phrase {
    match quantity {
        LimitQuantity::DistanceMaxMm => phrase!("limit-distance-max"),
        LimitQuantity::SurfaceMaxMm => phrase!("limit-surface-max"),
        LimitQuantity::ContactMaxMm => phrase!("limit-contact-max"),
        LimitQuantity::CoordinateMaxMm => phrase!("limit-coordinate-max"),
        LimitQuantity::PositionMaxMm => phrase!("limit-position-max"),
        LimitQuantity::PositionMeanMm => phrase!("limit-position-mean"),
        LimitQuantity::PositionRmsMm => phrase!("limit-position-rms"),
        LimitQuantity::OrientationMaxDeg => phrase!("limit-orientation-max"),
        LimitQuantity::RepeatabilityMaxMm => phrase!("limit-repeatability-max"),
        LimitQuantity::AccuracyMaxMm => phrase!("limit-accuracy-max"),
    }
}

/// Name of a figure of errors.
pub(crate) fn error(quantity: ErrorQuantity, figure: Figure) -> Phrase {
    limit(match (quantity, figure) {
        (ErrorQuantity::Position, Figure::Mean) => LimitQuantity::PositionMeanMm,
        (ErrorQuantity::Position, Figure::Rms) => LimitQuantity::PositionRmsMm,
        (ErrorQuantity::Orientation, _) => LimitQuantity::OrientationMaxDeg,
        (ErrorQuantity::Distance, _) => LimitQuantity::DistanceMaxMm,
        (ErrorQuantity::Surface, _) => LimitQuantity::SurfaceMaxMm,
        (ErrorQuantity::Contact, _) => LimitQuantity::ContactMaxMm,
        (ErrorQuantity::Coordinate, _) => LimitQuantity::CoordinateMaxMm,
        _ => LimitQuantity::PositionMaxMm,
    })
}

/// Name of an effect of the robot.
pub(crate) fn effect(effect: Effect) -> Phrase {
    match effect {
        Effect::Zeros => phrase!("zeros"),
        Effect::Geometry => phrase!("geometry"),
        Effect::Gains => phrase!("gains"),
        Effect::Harmonics => phrase!("harmonics"),
        Effect::Backlash => phrase!("backlash"),
        Effect::Coupling => phrase!("coupling"),
        Effect::Bending => phrase!("bending"),
    }
}

/// Kind of a file.
pub(crate) fn kind(kind: SourceKind) -> Phrase {
    match kind {
        SourceKind::Campaign => phrase!("campaign"),
        SourceKind::Robot => phrase!("robot"),
        SourceKind::Export => phrase!("export"),
        SourceKind::Log => phrase!("log"),
        SourceKind::Table => phrase!("table"),
        SourceKind::Stream => phrase!("stream"),
    }
}

/// Source of uncertainty.
pub(crate) fn source(source: UncertaintySource) -> Phrase {
    match source {
        UncertaintySource::Instrument => phrase!("instrument"),
        UncertaintySource::Contact => phrase!("contact"),
        UncertaintySource::RigidParts => phrase!("rigid-parts"),
        UncertaintySource::KnownPoints => phrase!("known-points"),
        UncertaintySource::NominalValues => phrase!("nominal-values"),
        UncertaintySource::Repeatability => phrase!("repeatability"),
        UncertaintySource::Model => phrase!("model"),
        UncertaintySource::Residuals => phrase!("residuals"),
        UncertaintySource::Frame => phrase!("world-frame"),
        UncertaintySource::FrameOfPoses => phrase!("frames-of-poses"),
        UncertaintySource::Scale => phrase!("scale"),
        UncertaintySource::Temperature => phrase!("temperature"),
        UncertaintySource::Homing => phrase!("homing"),
    }
}

/// Names of enumerated values in texts: elements, methods, movements, quantities of a comparison.
/// `None` for any other text.
pub(crate) fn of_document(name: &str) -> Option<Phrase> {
    Some(match name {
        "plane" => phrase!("plane"),
        "line" => phrase!("line"),
        "circle" => phrase!("circle"),
        "cylinder" => phrase!("cylinder"),
        "nominal" => phrase!("nominal"),
        "geometric" => phrase!("geometric"),
        "identified" => phrase!("identified"),
        "base shift" => phrase!("base-shift"),
        "base rotation" => phrase!("base-rotation"),
        "position" => phrase!("position"),
        "orientation" => phrase!("orientation"),
        "calibration" => phrase!("calibration"),
        "validation" => phrase!("validation"),
        "before" => phrase!("before"),
        "after" => phrase!("after"),
        "homing" => phrase!("homing"),
        "max" => phrase!("max"),
        _ => return None,
    })
}
