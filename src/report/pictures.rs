//! Every picture of the report of a calibration, by the section that it stands in.

use super::points::{self, Picture};
use super::words::Words;
use super::{Identified, Report, arrows, by_pose, correlation, histogram, intervals, map, residuals, singular};
use crate::document::PointError;

/// Pictures by section.
pub(super) struct Pictures {
    /// of the errors before and after; empty where none can be drawn
    pub errors: Vec<Picture>,
    /// of the identified parameters
    pub parameters: Vec<Picture>,
    /// of what is left after calibration
    pub residuals: Vec<Picture>,
    /// of what the data tell
    pub observability: Vec<Picture>,
}

pub(super) fn pictures(report: &Report, identified: &Identified, words: &Words) -> Pictures {
    let drawable = points::drawable(identified.errors);
    let flat = |p: &&PointError| p.at_mm[2] == 0.0 && p.before_mm[2] == 0.0 && p.after_mm[2] == 0.0;
    let planar = report.frames.world.planar || drawable.iter().all(flat);
    let mut errors = Vec::new();
    if !drawable.is_empty() {
        errors.extend(map::maps(&drawable, planar, words));
        errors.extend(arrows::arrows(&drawable, planar, words));
        errors.extend(histogram::histogram(&drawable, words));
        errors.extend(by_pose::pictures(&drawable, words));
    }
    let mut parameters = intervals::pictures(&identified.parameters.parameters, words);
    parameters.extend(correlation::picture(identified.parameters, words));
    Pictures {
        errors,
        parameters,
        residuals: residuals::pictures(&drawable, planar, words),
        observability: identified.parameters.observability.iter().filter_map(|o| singular::picture(o, words)).collect(),
    }
}
