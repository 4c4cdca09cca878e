//! Judgement of an answer: messages of severity error say that it must not be loaded.

use super::{Task, readings, unit};
use etalon_base::message::{Message, Place};
use etalon_base::pose::{Pose, Vector, norm};
use etalon_base::{error, warning};
use etalon_identify::cell::{CellPoint, CellResidual, Component, Measure, Quality, Size};

/// Maximum distance of a flange from the base (mm) that indicates another unit.
const SMALL_MM: f64 = 10.0;
/// Maximum length of a tool (mm) that indicates another unit.
const SMALL_TOOL_MM: f64 = 2.0;
/// Distance of a flange from the base (mm) from which another unit is indicated.
const LARGE_MM: f64 = 20_000.0;
/// Length of a tool (mm) from which another unit is indicated.
const LARGE_TOOL_MM: f64 = 10_000.0;
/// Coverage factor of a tool that is at the flange.
const AT_FLANGE: f64 = 3.0;
/// Maximum standard uncertainty (mm) of a tool point for a warning that the tool lies at the
/// flange.
const KNOWN_MM: f64 = 2.0;

/// Error about positions that are probably in metres, or in millimetres under metres: poses near
/// the base and a tool that is a point, or poses far away and a tool longer than any.
pub(super) fn judge_unit(poses: &[Pose], tool_mm: Vector) -> Option<Message> {
    let distance_mm = poses.iter().map(|p| norm(p.translation_mm)).fold(0.0, f64::max);
    let tool_mm = norm(tool_mm);
    if distance_mm > LARGE_MM && tool_mm > LARGE_TOOL_MM {
        return Some(error!("cell-unit-large", distance_m = distance_mm / 1000.0, tool_m = tool_mm / 1000.0));
    }
    let small = distance_mm > 0.0 && distance_mm < SMALL_MM && tool_mm < SMALL_TOOL_MM;
    small.then(|| error!("cell-unit", distance_mm))
}

/// Error about poses of an active tool.
pub(super) fn judge_active_tool(tool: &CellPoint, known: bool) -> Option<Message> {
    let u_mm = (0..3).map(|i| tool.covariance_mm2[i][i]).sum::<f64>().max(0.0).sqrt();
    let distance_mm = norm(tool.at_mm);
    let active = known && u_mm < KNOWN_MM && distance_mm < AT_FLANGE * u_mm;
    active.then(|| error!("cell-tool-active", distance_mm, u_mm))
}

impl Task<'_> {
    fn is_stated(&self, measure: Measure) -> bool {
        match measure {
            Measure::Position => self.uncertain.position_mm.is_some() || !self.uncertain.measured_mm.is_empty(),
            Measure::Orientation => self.uncertain.rotation_rad.is_some(),
        }
    }

    fn outlier(&self, outlier: &CellResidual) -> Vec<Message> {
        let (_, factor) = unit(outlier.measure);
        let size = norm(outlier.value) * factor;
        let line = readings::line(self.file, outlier.reading);
        let place = Place { line: Some(line), ..Place::default() };
        let message = match outlier.measure {
            Measure::Position => error!("cell-outlier", line, residual_mm = size),
            Measure::Orientation => error!("cell-outlier-turned", line, residual_deg = size),
        };
        self.file.place(message.at(place).into()).0
    }

    /// Messages of the residuals of an answer whose tool and motion have this size.
    pub(super) fn remarks(&self, quality: &Quality, size: Size) -> Vec<Message> {
        let outlier = quality.outlier();
        let mut messages = outlier.map(|outlier| self.outlier(outlier)).unwrap_or_default();
        // one outlier may be all that enlarges the residuals
        let refuted: Vec<&Component> = match outlier {
            Some(_) => Vec::new(),
            None => quality.refuted(&self.uncertain, size).collect(),
        };
        for component in &quality.components {
            let (_, factor) = unit(component.measure);
            let found = component.deviation * factor;
            let is_refuted = refuted.iter().any(|other| other.measure == component.measure);
            let is_larger = self.is_stated(component.measure) && !component.agrees && component.redundancy > 0.5;
            messages.extend(match (component.measure, is_refuted, is_larger) {
                (Measure::Position, true, _) => Some(error!("cell-refuted", found_mm = found)),
                (Measure::Orientation, true, _) => Some(error!("cell-refuted-turned", found_deg = found)),
                (Measure::Position, _, true) => Some(warning!("cell-noise-larger", found_um = 1000.0 * found)),
                (Measure::Orientation, _, true) => Some(warning!("cell-noise-larger-turned", found_deg = found)),
                _ => None,
            });
        }
        if !quality.has_uncertainty() {
            messages.push(warning!("cell-no-uncertainty"));
        }
        messages
    }
}
