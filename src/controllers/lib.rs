//! Files for controllers: one format per file, each a pure function of [`ExportInput`].
//!
//! All formats write numbers that are read back bit for bit, and reject data that must not reach a
//! machine: non-finite values, duplicate parameters, and parameters of a solver that did not
//! converge or that are implausible.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

mod arrays;
pub mod axis_tables;
mod c_header;
pub mod cell;
mod code;
pub mod commands;
mod csv;
mod dcc;
mod decimals;
mod delta;
mod field;
mod galil;
mod hexapod_hal;
mod json;
mod linuxcnc;
mod linuxcnc_component;
mod matlab;
pub mod measuring;
mod plc;
mod python;
mod qif;
mod recording;
mod reprap_five_bar;
mod statement;
mod targets;
mod template;
mod template_format;
#[cfg(test)]
mod tests;
mod universal_robots;
mod urdf;
mod xml;

pub use statement::Statement;
pub use targets::{places, targets};
pub use template_format::TemplateFormat;

pub use dcc::FILE as CERTIFICATE;
pub use field::field_code;

use etalon_base::catalogue::Phrase;
use etalon_base::files;
use etalon_base::message::{Message, Problems, Result, Severity};
use etalon_base::{error, phrase};
use etalon_documents::{
    AccuracyDocument, CampaignSummary, ControllersDocument, ParameterEntry, ParameterStatus, ParametersDocument,
    PointError, UntestedMistake, to_json,
};
use etalon_robots::{Circumstance, Effect, JointChain, Parameter, Robot, Role};
use std::collections::{BTreeMap, BTreeSet};
pub(crate) use template::comment;

/// Name, file and contents of a controller format.
#[derive(Clone, Copy)]
pub struct About<'a> {
    /// Name of the format in `controllers` and `--format`.
    pub name: &'a str,
    /// Name of the file in the output folder.
    pub file_name: &'a str,
    /// Frame in which the file describes the robot, for its header.
    pub frame: &'static str,
    /// `false` for files that programs of a laboratory read, and no controller loads.
    pub is_for_controllers: bool,
    /// `true` if the file contains the hash of the calibration in the controller
    /// ([`ExportInput::controller_hash`]).
    pub states_controller_hash: bool,
    /// `true` if the file shows the errors of the measured points ([`ExportInput::errors`]).
    pub shows_errors: bool,
    /// `true` if the file is the URDF of the robot with identified origins.
    pub edits_urdf: bool,
    /// `true` for parameters that the format holds.
    pub holds: fn(&Parameter) -> bool,
}

impl<'a> About<'a> {
    /// Parameters by name, in a file that a controller loads.
    pub fn controller(name: &'a str, file_name: &'a str) -> Self {
        Self {
            name,
            file_name,
            frame: "parameters by name, base parameters place the base in the world of the campaign",
            is_for_controllers: true,
            states_controller_hash: false,
            shows_errors: false,
            edits_urdf: false,
            holds: |_| true,
        }
    }

    /// Parameters by name, in a file that programs of a laboratory read.
    pub fn laboratory(name: &'a str, file_name: &'a str) -> Self {
        Self { is_for_controllers: false, ..Self::controller(name, file_name) }
    }

    /// Kinematics as code that computes from joint values.
    fn code(name: &'a str, file_name: &'a str) -> Self {
        let frame = "base of the robot in its robot file, to the flange. \
            Tools and the base in the world of the campaign are not in this file";
        Self { frame, holds: is_in_code, ..Self::controller(name, file_name) }
    }
}

/// One controller format.
pub trait Exporter {
    /// Name, file and contents of the format.
    fn about(&self) -> About<'_>;

    /// Bytes of the file for parameters that may be written.
    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>>;

    /// Name of the format in `controllers` and `--format`.
    fn name(&self) -> &str {
        self.about().name
    }

    /// Name of the file in the output folder.
    fn file_name(&self) -> &str {
        self.about().file_name
    }

    /// Rejection of a robot that the format does not describe.
    fn unsuited_robot(&self, _robot: &dyn Robot) -> Option<Message> {
        None
    }

    /// Rejection of a robot that the format does not describe; a file that edits the description of
    /// the robot needs one.
    fn unsuited_to(&self, robot: &dyn Robot, description: Option<Description>) -> Option<Message> {
        let is_missing = self.about().edits_urdf && description.is_none();
        let missing = || other_robot(self.name(), robot, phrase!("kind-urdf"));
        is_missing.then(missing).or_else(|| self.unsuited_robot(robot))
    }

    /// Rejection of a result that the format does not describe; `None` if the robot is unknown.
    fn unsuited(&self, given: &ExportInput) -> Option<Message> {
        self.unsuited_to(given.robot?, given.description)
    }

    /// Warning about a file that is written for a robot unlike the robots of the format; `None` if
    /// the robot is like them or unknown.
    fn concern(&self, _given: &ExportInput) -> Option<Message> {
        None
    }

    /// Warnings about a file that is written, with their consequence: the robot is not one of the
    /// format's robots, or the format can contain some values only with the help of its reader.
    fn cautions(&self, given: &ExportInput) -> Vec<Message> {
        self.concern(given).into_iter().collect()
    }

    /// `true` if the format holds this parameter of the robot.
    fn holds(&self, parameter: &Parameter, _given: &ExportInput) -> bool {
        (self.about().holds)(parameter)
    }

    /// Values (mm, rad or 1) of the robot that the file describes. Effects that the format does not
    /// hold are zero; some formats tie parameters to each other.
    fn written(&self, given: &ExportInput, robot: &dyn Robot, values: &[f64]) -> Vec<f64> {
        let own =
            |(p, &value): (&Parameter, &f64)| if p.effect.is_rigid() || self.holds(p, given) { value } else { 0.0 };
        robot.parameters().iter().zip(values).map(own).collect()
    }

    /// Bytes of the file, with the estimate conditioned on the parameters that the format leaves
    /// out.
    ///
    /// # Errors
    ///
    /// Fails if parameters must not reach a controller ([`ExportInput::check`]), or if the format
    /// cannot hold them. Unless forced, fails for a file with which the robot is less accurate than
    /// with nominal parameters.
    fn write(&self, given: &ExportInput) -> Result<Vec<u8>> {
        given.check()?;
        self.write_stated(given, &given.statement(self)?)
    }

    /// Bytes of the file with this statement, for parameters that [`ExportInput::check`] accepts.
    ///
    /// # Errors
    ///
    /// Fails if the format cannot hold the parameters and, unless forced, for a file that is worse
    /// than nominal.
    fn write_stated(&self, given: &ExportInput, statement: &Statement) -> Result<Vec<u8>> {
        match statement.refusal(self.name()) {
            Some(refusal) if !given.force => Err(refusal.into()),
            _ => {
                let parameters = statement.parameters.as_ref().unwrap_or(given.parameters);
                self.bytes(&ExportInput { parameters, file: Some((statement, given.parameters)), ..*given })
            }
        }
    }
}

/// Parameters to export, with their context.
///
/// # Examples
///
/// ```
/// use etalon_controllers::{ExportInput, by_name};
/// use etalon_documents::ParametersDocument;
///
/// # let json = r#"{
/// #     "schema": "etalon/parameters/2", "robot": "five_bar",
/// #     "parameters": [{
/// #         "name": "d", "unit": "mm", "nominal": 275.0, "before": 275.0, "value": 274.8051,
/// #         "standard_uncertainty": 0.001, "status": "identified", "confounded_with": []
/// #     }],
/// #     "residuals": {
/// #         "kind": "targets", "count": 9, "degrees_of_freedom": 8, "rms": 1e-3, "max": 2e-3,
/// #         "uncertainties_from": "instrument", "uncertainties_enlarged_by": 1.0
/// #     },
/// #     "solver": {
/// #         "method": "", "iterations": 3, "termination": "step_vanished", "meaning": ""
/// #     },
/// #     "covariance": [[1e-6]], "messages": [],
/// #     "provenance": { "version": "0.1.0", "inputs": {} }
/// # }"#;
/// # let problems = |problems: etalon_base::message::Problems| problems.to_string();
/// // text of a parameters.json: the distance `d` of two motors is 274.8051 mm, u = 1 µm
/// let document: ParametersDocument = serde_json::from_str(json)?;
/// let csv = by_name("csv").expect("a format");
/// let csv = csv.write(&ExportInput::parameters(&document)).map_err(problems)?;
///
/// let csv = String::from_utf8(csv)?;
/// let row = csv.lines().nth(1).expect("one parameter a row");
/// assert!(row.starts_with("d,mm,275.0,274.8051,0.001,identified,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct ExportInput<'a> {
    /// Identified parameters.
    pub parameters: &'a ParametersDocument,
    /// Administrative data of the campaign.
    pub summary: Option<&'a CampaignSummary>,
    /// Name of the robot.
    pub name: Option<&'a str>,
    /// Robot with nominal parameters, for formats of its kind.
    pub robot: Option<&'a dyn Robot>,
    /// File that describes the robot, if any.
    pub description: Option<Description<'a>>,
    /// Errors before and after the identification, for the header.
    pub accuracy: Option<&'a AccuracyDocument>,
    /// Errors of the measured points, for formats that show them.
    pub errors: Option<&'a [PointError]>,
    /// Values that the run identified again for formats that leave parameters out.
    pub controllers: Option<&'a ControllersDocument>,
    /// SHA-256 of parameters.json, if its bytes are at hand.
    pub parameters_sha256: Option<&'a str>,
    /// Hash of the calibration in the controller, for formats that state it.
    pub controller_hash: Option<&'a str>,
    /// `true` to write parameters that failed their checks; the file then says so.
    pub force: bool,
    /// Statement of the file, and all identified parameters; set by [`Exporter::write_stated`].
    pub file: Option<(&'a Statement, &'a ParametersDocument)>,
}

/// A file that describes a robot.
#[derive(Clone, Copy, Debug)]
pub struct Description<'a> {
    /// Name of the file.
    pub file: &'a str,
    /// Text of the file.
    pub text: &'a str,
}

/// Statement that data are synthetic, with the campaign's explanation.
pub(crate) fn synthetic_notice(why: &str) -> String {
    format!("SYNTHETIC DATA, not of a measured robot: {why}")
}

impl<'a> ExportInput<'a> {
    /// Exports parameters only.
    pub fn parameters(parameters: &'a ParametersDocument) -> Self {
        Self {
            parameters,
            summary: None,
            name: None,
            robot: None,
            description: None,
            accuracy: None,
            errors: None,
            controllers: None,
            parameters_sha256: None,
            controller_hash: None,
            force: false,
            file: None,
        }
    }

    /// Failed checks of the identification.
    fn failed(&self) -> Vec<Message> {
        let mut failed = Vec::new();
        if !self.parameters.solver.termination.is_success() {
            let termination = self.parameters.solver.termination.to_string();
            failed.push(error!("parameters-not-converged", termination));
        }
        failed.extend(self.parameters.messages.iter().filter(|m| m.severity == Severity::Error).cloned());
        failed
    }

    /// Warning in a file about failed checks; `None` if all passed.
    fn warning(&self) -> Option<String> {
        let worse = self.file.and_then(|(statement, _)| statement.worse_than_nominal()).map(|worse| worse.to_string());
        let failed: Vec<String> = self.failed().into_iter().map(|message| message.what).chain(worse).collect();
        (!failed.is_empty()).then(|| format!("NOT FIT FOR A CONTROLLER, written by force: {}", failed.join("; ")))
    }

    /// Statement that the parameters come from synthetic data; `None` for measured data.
    pub fn synthetic(&self) -> Option<String> {
        let of_campaign = || self.summary.and_then(|summary| summary.measurements.synthetic.as_ref());
        let why = self.parameters.synthetic.as_ref().or_else(of_campaign)?;
        Some(synthetic_notice(why))
    }

    /// Warning of formats without header lines: failed checks, otherwise a file that is not to be
    /// loaded, or not clearly better than nominal.
    fn caution(&self) -> Option<String> {
        let of_statement = || {
            let (statement, _) = self.file?;
            let near = statement.near_nominal().map(|near| near.to_string());
            let all: Vec<String> = statement.not_to_be_loaded().into_iter().chain(near).collect();
            (!all.is_empty()).then(|| all.join("; "))
        };
        self.warning().or_else(of_statement)
    }

    /// Rejects parameters that must not reach a controller.
    ///
    /// # Errors
    ///
    /// Reports non-finite numbers and duplicate parameters and, unless forced, a solver that did
    /// not converge or an error among the messages of the identification.
    pub fn check(&self) -> Result<()> {
        let document = self.parameters;
        let mut problems = Problems(if self.force { Vec::new() } else { self.failed() });
        if document.covariance.iter().flatten().any(|v| !v.is_finite()) {
            problems.0.push(error!("covariance-not-finite"));
        }
        let mut seen = BTreeSet::new();
        for p in &document.parameters {
            let numbers = [Some(p.value), Some(p.nominal), p.standard_uncertainty];
            if numbers.iter().flatten().any(|v| !v.is_finite()) {
                problems.0.push(error!("parameter-not-finite", parameter = p.name));
            }
            if !seen.insert(&p.name) {
                problems.0.push(error!("parameter-twice", parameter = p.name));
            }
        }
        problems.check().map(|_| ())
    }

    /// Name of the robot in its campaign; without a campaign its model.
    fn robot_name(&self) -> &'a str {
        let named = self.name.or_else(|| self.summary?.robot.as_deref());
        named.unwrap_or(&self.parameters.robot)
    }

    /// SHA-256 of parameters.json.
    fn sha256(&self) -> Result<String> {
        if let Some(hash) = self.parameters_sha256 {
            return Ok(hash.to_owned());
        }
        Ok(files::sha256(&to_json(self.file.map_or(self.parameters, |(_, identified)| identified))?))
    }

    /// First 128 bits of the hash as a UUID; equal parameters have equal identifiers.
    fn identifier(&self) -> Result<String> {
        let hash = self.sha256()?;
        let part = |from: usize, to: usize| hash.get(from..to).unwrap_or_default();
        Ok([part(0, 8), part(8, 12), part(12, 16), part(16, 20), part(20, 32)].join("-"))
    }

    /// Header lines of a file: version, campaign, robot, units, hash of `parameters.json`, errors,
    /// and parameters left out. No character can end a comment.
    ///
    /// # Errors
    ///
    /// Fails if the parameters cannot be written as JSON.
    pub fn header(&self, units: &str) -> Result<Vec<String>> {
        let mut lines = vec![format!("Written by etalon {}", self.parameters.provenance.version)];
        lines.extend(self.warning());
        lines.extend(self.file.and_then(|(statement, _)| statement.not_to_be_loaded()));
        lines.extend(self.synthetic());
        lines.extend(self.summary.map(|summary| format!("campaign: {}", summary.name)));
        lines.push(format!("robot: {}", self.robot_name()));
        lines.extend(self.parameters.valid_until.as_ref().map(|last| format!("valid until: {last}")));
        lines.push(format!("units: {units}"));
        lines.extend(self.references());
        lines.push(format!("sha256 of parameters.json: {}", self.sha256()?));
        lines.extend(self.file.iter().flat_map(|(statement, _)| statement.lines()));
        let untested = self.file.map_or(self.parameters, |(_, identified)| identified).untested.iter();
        lines.extend(untested.map(|mistake| {
            let UntestedMistake { change, flange_mm, flange_deg, .. } = mistake;
            format!(
                "not tested by the measurements: {} (the flange differs by up to {flange_mm:.0} mm and {flange_deg:.0} deg)",
                change.english()
            )
        }));
        Ok(lines.iter().map(|line| comment(line)).collect())
    }

    /// Lines on parameters whose values refer to a load or a temperature, one per unit, and on the
    /// reference temperature.
    fn references(&self) -> Vec<String> {
        let mut names: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for p in self.parameters.parameters.iter().filter(|p| p.value != 0.0) {
            if let Some(unit) = &p.full_unit {
                names.entry(unit).or_default().push(&p.name);
            }
        }
        let units = names.into_iter().map(|(unit, names)| format!("in {unit}: {}", names.join(", ")));
        let reference_c = self.parameters.reference_temperature_c;
        units
            .chain(reference_c.map(|value| format!("at the reference temperature {value} °C: lengths and zeros")))
            .collect()
    }

    /// Like [`Self::header`], for formats with joints and links only: lists the effects that they
    /// cannot hold.
    fn header_of_geometry(&self, units: &str) -> Result<Vec<String>> {
        let effects: Vec<Effect> = Effect::ALL.into_iter().filter(|effect| !effect.is_rigid()).collect();
        self.header_without(&effects, "not in this format", units)
    }

    /// Like [`Self::header`], for code that computes from joint values only: lists backlash, which
    /// the code cannot compute, and effects of other values of a reading than joint values.
    fn header_of_code(&self, units: &str) -> Result<Vec<String>> {
        // without known masses, the payload alone tilts joints and base
        let tilts = self.robot.is_some_and(|robot| robot.circumstances().contains(&Circumstance::PayloadMass));
        let left_out = |effect: &Effect| match effect {
            Effect::Lateral | Effect::Pedestal => tilts,
            effect => !is_effect_in_code(*effect),
        };
        let effects: Vec<Effect> = Effect::ALL.into_iter().filter(left_out).collect();
        let why = "joints are taken in the middle of their backlash and without payload and torques, at the reference temperature, not in this code";
        self.header_without(&effects, why, units)
    }

    /// Like [`Self::header`], with the robot's parameters of these effects, which are omitted.
    fn header_without(&self, effects: &[Effect], why: &str, units: &str) -> Result<Vec<String>> {
        let effect = |name: &str| self.robot.and_then(|robot| Some(robot.parameters()[robot.index(name)?].effect));
        let is_left_out = |p: &&ParameterEntry| p.value != 0.0 && effect(&p.name).is_some_and(|e| effects.contains(&e));
        let (named, parameters): (&[String], _) = match self.file {
            Some((statement, identified)) => (&statement.left_out, identified),
            None => (&[], self.parameters),
        };
        let left_out = parameters.parameters.iter().filter(is_left_out).map(|entry| entry.name.as_str());
        let left_out: Vec<&str> = left_out.filter(|name| !named.iter().any(|n| n == name)).collect();
        let mut lines = self.header(units)?;
        if !left_out.is_empty() {
            lines.push(comment(&format!("{why}: {}", left_out.join(", "))));
        }
        Ok(lines)
    }

    /// Names of the parameters in a language, by `name`.
    ///
    /// # Errors
    ///
    /// Reports parameters whose names coincide in the language.
    fn names(&self, language: &str, name: impl Fn(&ParameterEntry) -> String) -> Result<Vec<String>> {
        let (mut seen, mut problems) = (BTreeMap::new(), Problems::default());
        let names: Vec<String> = self.parameters.parameters.iter().map(name).collect();
        for (p, name) in self.parameters.parameters.iter().zip(&names) {
            if let Some(other) = seen.insert(name, &p.name) {
                problems.0.push(error!("parameter-names-collide", first = other, second = p.name, name, language));
            }
        }
        problems.check().map(|_| names)
    }

    /// Returns the identified parameter with this name.
    fn entry(&self, name: &str) -> Result<&'a ParameterEntry> {
        let entry = self.parameters.parameters.iter().find(|entry| entry.name == name);
        entry.ok_or_else(|| error!("parameter-missing", parameter = name).into())
    }

    /// Robot with its identified parameters; base and targets are nominal if they are not among
    /// them.
    fn robot(&self) -> Result<(&'a dyn Robot, Vec<f64>)> {
        let robot = self.robot.ok_or_else(|| error!("robot-missing"))?;
        let mut values = robot.nominal();
        for (value, p) in values.iter_mut().zip(robot.parameters()) {
            match self.entry(&p.name) {
                Ok(entry) => *value = p.quantity.inward(entry.value),
                Err(missing) if p.role == Role::Robot => return Err(missing),
                Err(_) => {}
            }
        }
        Ok((robot, values))
    }
}

/// All formats. Formats for all robots come first; these are the default formats.
const EXPORTERS: [&dyn Exporter; 26] = [
    &json::Json,
    &csv::Csv,
    &c_header::CHeader,
    &matlab::Matlab,
    &python::Python,
    &arrays::Npz,
    &arrays::Mat,
    &dcc::Dcc,
    &qif::Qif,
    &galil::Galil,
    &plc::TwinCat,
    &plc::PlcOpen,
    &plc::Scl,
    &urdf::Urdf,
    &universal_robots::UniversalRobots,
    &linuxcnc::LinuxCnc,
    &hexapod_hal::HexapodHal,
    &linuxcnc_component::LinuxCncComponent,
    &delta::DeltaHal,
    &delta::KLIPPER,
    &delta::REP_RAP,
    &reprap_five_bar::RepRapFiveBar,
    &code::C99,
    &code::PythonCode,
    &code::StructuredText,
    &recording::Recording,
];
const USUAL: usize = 3;

/// The default formats.
pub fn usual() -> impl Iterator<Item = &'static dyn Exporter> {
    EXPORTERS.into_iter().take(USUAL)
}

/// Returns the format with this name.
///
/// # Errors
/// Fails for an unknown format; languages of robot programs are referred to `etalon compensate`.
pub fn by_name(name: &str) -> std::result::Result<&'static dyn Exporter, Message> {
    EXPORTERS.into_iter().find(|exporter| exporter.name() == name).ok_or_else(|| unknown(name))
}

/// `true` if a parameter is a zero, a length or an angle.
fn is_geometry(parameter: &Parameter) -> bool {
    matches!(parameter.effect, Effect::Zeros | Effect::Geometry)
}

/// `true` if code that computes from joint values only holds the parameter.
fn is_in_code(parameter: &Parameter) -> bool {
    is_effect_in_code(parameter.effect)
}

/// `true` for effects that code can compute from joint values only.
fn is_effect_in_code(effect: Effect) -> bool {
    effect != Effect::Backlash && !effect.follows_readings()
}

/// File names of all formats.
pub fn file_names() -> impl Iterator<Item = &'static str> {
    EXPORTERS.iter().map(|exporter| exporter.file_name())
}

fn unknown(name: &str) -> Message {
    let message = error!("controller-format-unknown", name);
    let makers = ["abb", "kuka", "fanuc"];
    if commands::language(name).is_some() || makers.contains(&name.to_lowercase().as_str()) {
        return message.hint(phrase!("compensate-programs"));
    }
    message.hint_names(name, names())
}

/// Names of all formats.
pub fn names() -> impl Iterator<Item = &'static str> {
    EXPORTERS.iter().map(|exporter| exporter.name())
}

/// Names of the formats that a controller of this robot may load.
pub fn names_for_controllers(robot: &dyn Robot) -> impl Iterator<Item = &'static str> {
    let suits = move |exporter: &&&dyn Exporter| {
        exporter.about().is_for_controllers && exporter.unsuited_robot(robot).is_none()
    };
    EXPORTERS.iter().filter(suits).map(|exporter| exporter.name())
}

/// Names of the formats that state the hash of a calibration in the controller.
pub fn with_controller_hash() -> Vec<&'static str> {
    EXPORTERS
        .iter()
        .filter(|exporter| exporter.about().states_controller_hash)
        .map(|exporter| exporter.name())
        .collect()
}

/// Rejection of a robot of another kind than the format describes.
fn other_robot(format: &str, robot: &dyn Robot, kind: Phrase) -> Message {
    error!("format-for-other-robots", format, model = robot.model(), kind)
}

/// The six joints that turn of an arm.
///
/// # Errors
///
/// Rejects a robot of another kind.
fn six_axes(format: &str, robot: &dyn Robot, values: &[f64]) -> std::result::Result<JointChain, Message> {
    let chain = robot.joint_chain(values).filter(|c| c.joints.len() == 6 && c.joints.iter().all(|j| !j.prismatic));
    chain.ok_or_else(|| match robot.branches() {
        [] => other_robot(format, robot, phrase!("kind-six-axis-arm")),
        links => error!("several-branches", links),
    })
}

/// Value of a parameter of a robot by name.
fn value(robot: &dyn Robot, values: &[f64], name: &str) -> Result<f64> {
    let index = robot.index(name).ok_or_else(|| error!("robot-parameter-missing", parameter = name))?;
    Ok(values[index])
}

/// Status in the spelling of the documents.
fn status_word(parameter: &ParameterEntry) -> &'static str {
    match parameter.status {
        ParameterStatus::Identified => "identified",
        ParameterStatus::Fixed => "fixed",
        ParameterStatus::NotIdentifiable => "not_identifiable",
        ParameterStatus::PlacedByValidation => "placed_by_validation",
    }
}
