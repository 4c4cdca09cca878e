//! Names of enumerated values in documents.

use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{ErrorQuantity, Figure, LimitQuantity, SourceKind, UncertaintySource};

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
    quantity.phrase()
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

/// Kind of a file.
pub(crate) fn kind(kind: SourceKind) -> Phrase {
    match kind {
        SourceKind::Campaign => phrase!("campaign"),
        SourceKind::Robot => phrase!("robot"),
        SourceKind::Export => phrase!("export"),
        SourceKind::Log => phrase!("log"),
        SourceKind::Table => phrase!("table"),
        SourceKind::Stream => phrase!("stream"),
        SourceKind::Template => phrase!("template"),
        SourceKind::Backup => phrase!("source-backup"),
    }
}

/// Source of uncertainty.
pub(crate) fn source(source: UncertaintySource) -> Phrase {
    source.phrase()
}

/// Kind of an element.
pub(crate) fn element(name: &str) -> Option<Phrase> {
    Some(match name {
        "plane" => phrase!("plane"),
        "line" => phrase!("line"),
        "circle" => phrase!("circle"),
        "cylinder" => phrase!("cylinder"),
        _ => return None,
    })
}

/// Method of the geometric identification.
pub(crate) fn method(name: &str) -> Option<Phrase> {
    Some(match name {
        "nominal" => phrase!("nominal"),
        "geometric" => phrase!("geometric"),
        "identified" => phrase!("identified"),
        _ => return None,
    })
}

/// Movement of the whole robot; any other movement is a movement of a joint.
pub(crate) fn movement(name: &str) -> Option<Phrase> {
    Some(match name {
        "base shift" => phrase!("base-shift"),
        "base rotation" => phrase!("base-rotation"),
        _ => return None,
    })
}
