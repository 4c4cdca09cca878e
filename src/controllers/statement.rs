//! Description of a controller file: parameters that the format omits, values that the file
//! contains instead, position errors with these values, and header lines.

use super::{ExportInput, Exporter};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{AnsweredBy, Message, Result};
use etalon_base::{error, phrase, warning};
use etalon_documents::{ControllerErrors, ParameterStatus, ParametersDocument, PoseSet};
use etalon_robots::Role;

/// Maximum relative difference of a value that counts as rounding.
const ROUNDING: f64 = 1e-12;

/// Statement of a controller file.
#[derive(Clone, Debug, Default)]
pub struct Statement {
    /// Identified parameters that the format does not hold.
    pub left_out: Vec<String>,
    /// Position errors that decide whether the file is written; `None` if they were not measured.
    pub errors: Option<ControllerErrors>,
    /// Parameters that the file contains instead of the identified ones.
    pub parameters: Option<ParametersDocument>,
    /// Reason for loading no file of the run, if it loads none.
    withheld: Option<Phrase>,
    /// Frame in which the file describes the robot.
    frame: &'static str,
    /// `true` if `parameters` were identified again, `false` if they were conditioned by the
    /// covariance.
    again: bool,
}

/// Line of a file that is written although the run loads no file.
pub(crate) fn not_to_be_loaded(reason: &Phrase) -> String {
    format!("NOT TO BE LOADED: {reason}")
}

impl Statement {
    /// Adds the reason for loading no file of the run.
    pub fn withheld(self, withheld: Option<Phrase>) -> Self {
        Self { withheld, ..self }
    }

    /// Reason for not writing the file: the robot is less accurate with it than with nominal
    /// parameters.
    pub fn refusal(&self, format: &str) -> Option<Message> {
        let message = error!("file-worse-than-nominal", format, reason = self.worse_than_nominal()?);
        Some(message.answered_by(AnsweredBy::NextStep))
    }

    /// Both errors, if the error of the file is larger than with nominal parameters.
    pub(crate) fn worse_than_nominal(&self) -> Option<Phrase> {
        let errors = self.errors.as_ref().filter(|e| self.parameters.is_some() && e.is_worse_than_nominal())?;
        Some(phrase!(
            "error-above-nominal",
            set = errors.set.to_string(),
            left_out = self.left_out,
            left_out_count = self.left_out.len(),
            written_mm = errors.written.rms_mm,
            nominal_mm = errors.nominal.rms_mm,
            decimals = decimals(errors),
        ))
    }

    /// Warning about files that are written although they hardly improve the robot, or not at all
    /// poses; `None` for a file that is clearly better than nominal or rejected.
    pub fn warning(&self, formats: &[&str]) -> Option<Message> {
        let reason = self.near_nominal().filter(|_| self.worse_than_nominal().is_none())?;
        Some(warning!("file-near-nominal", formats, formats_count = formats.len(), reason))
    }

    /// Both errors, if the root mean square is not clearly smaller than with nominal parameters, or
    /// the maximum is larger.
    pub(crate) fn near_nominal(&self) -> Option<Phrase> {
        let errors = self.errors.as_ref()?;
        let ControllerErrors { written, nominal, .. } = errors;
        let case = match (errors.is_rms_hardly_smaller(), errors.is_maximum_larger()) {
            (false, false) => return None,
            (true, false) => "rms",
            (false, true) => "maximum",
            (true, true) => "both",
        };
        Some(phrase!(
            "error-near-nominal",
            case,
            set = errors.set.to_string(),
            written_mm = written.rms_mm,
            written_max_mm = written.max_mm,
            nominal_mm = nominal.rms_mm,
            nominal_max_mm = nominal.max_mm,
            decimals = decimals(errors),
        ))
    }

    /// Header line of a file that is written although the run loads no file.
    pub(crate) fn not_to_be_loaded(&self) -> Option<String> {
        self.withheld.as_ref().map(not_to_be_loaded)
    }

    /// Header lines.
    pub(crate) fn lines(&self) -> Vec<String> {
        let names = self.left_out.join(", ");
        let errors = self.errors.as_ref().map(|errors| {
            let [nominal, identified, written] = millimetres(errors);
            let none = if errors.set == PoseSet::Validation { "" } else { ", no validation poses" };
            format!(
                "{} poses: nominal {nominal} mm, identified {identified} mm, this file {written} mm (rms{none})",
                errors.set
            )
        });
        let without = match (&self.parameters, self.again) {
            (None, _) => None,
            (_, true) if names.is_empty() => None,
            (_, true) => Some(format!("identified again without: {names}")),
            (_, false) => {
                Some(format!("conditioned on nominal values of: {names}, the error of this file was not measured"))
            }
        };
        let near = self.near_nominal().filter(|_| self.worse_than_nominal().is_none());
        let frame = (!self.frame.is_empty()).then(|| format!("frame: {}", self.frame));
        frame.into_iter().chain(errors).chain(without).chain(near.map(|near| near.to_string())).collect()
    }
}

/// Root mean squares with nominal, identified and written values, with three digits of the
/// smallest.
fn millimetres(errors: &ControllerErrors) -> [String; 3] {
    let decimals = decimals(errors);
    [errors.nominal, errors.identified, errors.written].map(|e| format!("{:.decimals$}", e.rms_mm))
}

fn decimals(errors: &ControllerErrors) -> usize {
    let all = [errors.nominal, errors.identified, errors.written].map(|e| e.rms_mm);
    let least = all.into_iter().filter(|v| *v > 0.0).fold(f64::INFINITY, f64::min);
    (2.0 - least.log10().floor()).clamp(3.0, 6.0) as usize
}

impl ExportInput<'_> {
    /// Identified parameters that a format does not hold; empty if the robot is unknown.
    pub fn left_out<E: Exporter + ?Sized>(&self, exporter: &E) -> Vec<String> {
        let identified = |name: &String| self.entry(name).is_ok_and(|e| e.status == ParameterStatus::Identified);
        self.not_held(exporter).filter(identified).collect()
    }

    /// Parameters of the robot itself that a format does not hold, identified or not.
    pub fn not_held<'e, E: Exporter + ?Sized>(&'e self, exporter: &'e E) -> impl Iterator<Item = String> + 'e {
        let robot = self.robot.iter().flat_map(|robot| robot.parameters()).filter(|p| p.role == Role::Robot);
        robot.filter(|p| !exporter.holds(p, self)).map(|p| p.name.clone())
    }

    /// Statement of a format's file.
    ///
    /// # Errors
    ///
    /// Fails for a robot that the format does not describe, and if parameters that the covariance
    /// does not contain were not identified again.
    pub fn statement<E: Exporter + ?Sized>(&self, exporter: &E) -> Result<Statement> {
        if let Some(unsuited) = exporter.unsuited(self) {
            return Err(unsuited.into());
        }
        let (left_out, frame) = (self.left_out(exporter), exporter.about().frame);
        if let Some((parameters, errors)) = self.identified_again(exporter, &left_out) {
            let parameters = Some(parameters);
            return Ok(Statement { left_out, errors, parameters, frame, again: true, withheld: None });
        }
        let names: Vec<&str> = left_out.iter().map(String::as_str).collect();
        if names.is_empty() {
            let set = self.accuracy.and_then(|accuracy| accuracy.sets.last()).filter(|_| self.is_whole(exporter));
            let errors = set.and_then(|set| ControllerErrors::new(set, None));
            return Ok(Statement { errors, frame, ..Statement::default() });
        }
        let conditioned = self
            .parameters
            .conditioned(&names)
            .ok_or_else(|| error!("covariance-missing", format = exporter.name(), parameters = left_out))?;
        let parameters = Some(conditioned);
        Ok(Statement { left_out, parameters, frame, ..Statement::default() })
    }

    /// Parameters that the run identified again without `left_out`, as the format writes them, and
    /// position errors with these parameters.
    fn identified_again<E: Exporter + ?Sized>(
        &self,
        exporter: &E,
        left_out: &[String],
    ) -> Option<(ParametersDocument, Option<ControllerErrors>)> {
        self.controllers?.files.iter().filter(|files| files.left_out == left_out).find_map(|files| {
            let parameters = files.applied_to(self.parameters);
            let applied = ExportInput { parameters: &parameters, ..*self };
            let is_whole = applied.is_whole(exporter);
            is_whole.then(|| (parameters, files.deciding().cloned()))
        })
    }

    /// `true` if the format writes the values of these parameters unchanged.
    fn is_whole<E: Exporter + ?Sized>(&self, exporter: &E) -> bool {
        let Ok((robot, values)) = self.robot() else { return true };
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= ROUNDING * a.abs().max(1.0);
        exporter.written(self, robot, &values).iter().zip(&values).all(same)
    }
}
