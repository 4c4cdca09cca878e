//! A user's own format: a template (minijinja) over the identified parameters.
//!
//! The first line of a template gives what its file contains: `{# holds: theta_* #}`. All other
//! parameters count as excluded: the file has the estimate conditioned on their nominal values, as
//! every format of this crate has.

use super::template::environment;
use super::{About, ExportInput, Exporter, status_word};
use etalon_base::files;
use etalon_base::message::{Message, Place, Problems, Result, nearest};
use etalon_base::pattern::matches_pattern;
use etalon_base::template::{bound, check_nesting, check_width, fill, innermost, reason, supervised};
use etalon_base::{error, phrase, warning};
use etalon_documents::{ParameterEntry, ParameterStatus};
use etalon_robots::{Parameter, Robot, Role};
use minijinja::value::{Enumerator, Object, Serde};
use minijinja::{Environment, Error, Value, context};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex};

/// Extension of the file name of a template.
const ENDING: &str = ".j2";
/// Maximum number of instructions of a template.
const FUEL: u64 = 10_000_000;

/// A format that a template describes.
#[derive(Clone, Debug)]
pub struct TemplateFormat {
    /// Path of the template, for messages.
    path: String,
    /// Name of the template without its ending: the file that it writes.
    file_name: String,
    text: String,
    /// Patterns of the parameters that the file contains.
    holds: Vec<String>,
}

impl TemplateFormat {
    /// Reads a template.
    ///
    /// # Errors
    ///
    /// Rejects a file name without the extension `.j2`, a template whose first line does not give
    /// the parameters that its file contains, and a template with a syntax error.
    pub fn new(path: &str, text: String) -> Result<Self> {
        let name = path.rsplit(['/', '\\']).next().unwrap_or_default();
        let at = |line: Option<usize>| Place { line, ..Place::file(path) };
        let file_name = name.strip_suffix(ENDING).filter(|stem| !stem.trim_matches('.').is_empty());
        let file_name = file_name.ok_or_else(|| error!("template-name", file = name).at(at(None)))?.to_owned();
        let first = text.trim_start_matches('\u{feff}').lines().next().unwrap_or_default().trim();
        let inside = first.strip_prefix("{#").and_then(|rest| rest.split("#}").next());
        let stated = inside.map(|text| text.trim_matches(['-', ' '])).and_then(|text| text.strip_prefix("holds:"));
        let holds: Vec<String> = stated.into_iter().flat_map(str::split_whitespace).map(str::to_owned).collect();
        if holds.is_empty() {
            return Err(error!("template-without-holds").at(at(Some(1))).into());
        }
        let format = Self { path: path.to_owned(), file_name, text, holds };
        let parsed =
            |format: Self| match format_environment().and_then(|mut e| e.add_template(&format.path, &format.text)) {
                Ok(()) => Ok(()),
                Err(wrong) => Err(Problems::from(format.failed(&wrong))),
            };
        let own = format.clone();
        check_nesting(path, &format.text).and_then(|()| supervised(path, move || parsed(own)))?;
        Ok(format)
    }

    /// Returns the file with these values.
    fn filled(&self, values: Value) -> std::result::Result<Vec<u8>, Error> {
        let mut environment = format_environment()?;
        environment.add_template(&self.path, &self.text)?;
        fill(&environment.get_template(&self.path)?, values).map(String::into_bytes)
    }

    /// Values that the template sees, and the parameters whose values it reads later.
    fn values(&self, given: &ExportInput) -> Result<(Value, Used)> {
        let (document, used) = (given.parameters, Used::default());
        let entry = |p| entry(p, &used);
        let parameters: Vec<Value> = document.parameters.iter().filter(|p| self.is_held(&p.name)).map(entry).collect();
        let by_name: BTreeMap<&str, Value> = document.parameters.iter().map(|p| (p.name.as_str(), entry(p))).collect();
        let values = context! {
            header => given.header("mm, deg, 1")?,
            parameters,
            parameter => by_name,
            campaign => given.summary.map(Serde),
            robot => context! { name => given.robot_name(), model => document.robot.as_str() },
            etalon => document.provenance.version.as_str(),
            sha256_of_parameters => given.sha256()?,
        };
        Ok((values, used))
    }

    /// The file, and the parameters whose values it contains.
    fn rendered(&self, given: &ExportInput) -> Result<(Vec<u8>, BTreeSet<String>)> {
        let (values, used) = self.values(given)?;
        let own = self.clone();
        let bytes = supervised(&self.path, move || Ok(own.filled(values).map_err(|e| own.failed(&e))?))?;
        let read = used.0.lock().map(|names| names.clone()).unwrap_or_default();
        Ok((bytes, read))
    }

    fn is_held(&self, name: &str) -> bool {
        self.holds.iter().any(|pattern| matches_pattern(pattern, name))
    }

    /// A pattern that no parameter has, with the name that it may mean.
    fn pattern_without_parameter(&self, given: &ExportInput) -> Option<Message> {
        let names = || given.parameters.parameters.iter().map(|p| p.name.as_str());
        let idle = self.holds.iter().find(|pattern| !names().any(|name| matches_pattern(pattern, name)))?;
        let message =
            error!("template-holds-unknown", pattern = idle).at(Place { line: Some(1), ..Place::file(&self.path) });
        Some(match (nearest(idle, names()), given.robot) {
            (Some(name), _) => message.hint(phrase!("did-you-mean", name)),
            (None, Some(robot)) if has_no_zeros(robot) => message.hint(phrase!("convert-to-denavit-hartenberg")),
            (None, _) => message.hint_names(idle, names()),
        })
    }

    /// Error of the template, with its line.
    fn failed(&self, e: &Error) -> Message {
        let e = innermost(e);
        let reason = reason(e, FUEL);
        let line = e.line();
        let text = line.and_then(|line| self.text.lines().nth(line.checked_sub(1)?));
        let place = match (line, text) {
            (Some(line), Some(text)) => Place::line(self.path.as_str(), line, text),
            _ => Place::file(&self.path),
        };
        error!("controller-template-failed", reason).at(place)
    }
}

/// `true` for an arm without parameters that are zeros of its joints, except for a flange that
/// turns about the last axis: screw axes contain no zeros.
fn has_no_zeros(robot: &dyn Robot) -> bool {
    let (Some(arm), Some(_)) = (robot.kinematics(), robot.free_base()) else { return false };
    let (nominal, joints) = (robot.nominal(), vec![0.0; robot.joints().len()]);
    let of_robot = robot.parameters().iter().enumerate().filter(|(_, p)| p.role == Role::Robot);
    let zeroed: BTreeSet<usize> = of_robot.filter_map(|(i, _)| arm.zeroed_joint(&nominal, &joints, i)).collect();
    zeroed.len() < 2
}

impl Exporter for TemplateFormat {
    fn about(&self) -> About<'_> {
        About::controller(&self.file_name, &self.file_name)
    }

    fn unsuited(&self, given: &ExportInput) -> Option<Message> {
        if given.robot.is_none() && given.parameters.parameters.iter().any(|p| !self.is_held(&p.name)) {
            return Some(error!("robot-missing"));
        }
        self.pattern_without_parameter(given)
    }

    fn holds(&self, parameter: &Parameter, _given: &ExportInput) -> bool {
        parameter.role != Role::Robot || self.is_held(&parameter.name)
    }

    fn written(&self, given: &ExportInput, robot: &dyn Robot, values: &[f64]) -> Vec<f64> {
        let own =
            |(p, (&value, nominal)): (&Parameter, (&f64, f64))| if self.holds(p, given) { value } else { nominal };
        robot.parameters().iter().zip(values.iter().zip(robot.nominal())).map(own).collect()
    }

    fn cautions(&self, given: &ExportInput) -> Vec<Message> {
        // a template that fails is an error of its file
        let Ok((_, read)) = self.rendered(given) else { return Vec::new() };
        let is_changed = |p: &ParameterEntry| p.status == ParameterStatus::Identified && p.value != p.nominal;
        let is_unread = |p: &&ParameterEntry| {
            p.role == etalon_documents::Role::Robot && self.is_held(&p.name) && is_changed(p) && !read.contains(&p.name)
        };
        let unread = given.parameters.parameters.iter().filter(is_unread);
        let names: Vec<String> = unread.map(|p| format!("`{}`", p.name)).collect();
        let place = Place { line: Some(1), ..Place::file(&self.path) };
        if names.is_empty() {
            return Vec::new();
        }
        vec![warning!("template-parameters-unread", count = names.len(), names).to_decide().at(place)]
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        Ok(self.rendered(given)?.0)
    }
}

/// Names of the parameters whose values a template has read.
#[derive(Clone, Debug, Default)]
struct Used(Arc<Mutex<BTreeSet<String>>>);

/// Keys of a parameter in a template.
const KEYS: &[&str] = &["name", "unit", "value", "nominal", "change", "u", "status"];

/// A parameter as a template sees it.
#[derive(Debug)]
struct Entry {
    name: String,
    values: Value,
    used: Used,
}

impl Object for Entry {
    fn get_value(self: &Arc<Self>, key: &Value) -> Option<Value> {
        if matches!(key.as_str(), Some("value" | "change"))
            && let Ok(mut names) = self.used.0.lock()
        {
            names.insert(self.name.clone());
        }
        self.values.get_item(key).ok().filter(|value| !value.is_undefined())
    }

    fn enumerate(self: &Arc<Self>) -> Enumerator {
        Enumerator::Str(KEYS)
    }
}

/// A parameter as a template sees it.
fn entry(p: &ParameterEntry, used: &Used) -> Value {
    let values = context! {
        name => p.name.as_str(), unit => p.unit.as_str(), value => p.value, nominal => p.nominal,
        change => p.value - p.nominal, u => p.standard_uncertainty, status => status_word(p),
    };
    Value::from_object(Entry { name: p.name.clone(), values, used: used.clone() })
}

/// Syntax and filters of templates, with filters for notations of controllers: units, fixed widths,
/// checksums.
fn format_environment<'a>() -> std::result::Result<Environment<'a>, Error> {
    let mut environment = environment()?;
    bound(&mut environment, FUEL);
    environment.add_filter("metres", |mm: f64| mm / 1e3);
    environment.add_filter("micrometres", |mm: f64| mm * 1e3);
    environment.add_filter("inches", |mm: f64| mm / 25.4);
    environment.add_filter("scientific", |value: f64, decimals: usize| {
        check_width(decimals).map(|()| format!("{value:.decimals$e}"))
    });
    environment
        .add_filter("right", |text: String, width: usize| check_width(width).map(|()| format!("{text:>width$}")));
    environment.add_filter("left", |text: String, width: usize| check_width(width).map(|()| format!("{text:<width$}")));
    environment.add_filter("crlf", |text: String| text.replace('\n', "\r\n"));
    environment.add_filter("sha256", |text: String| files::sha256(text.as_bytes()));
    environment.add_filter("crc32", |text: String| format!("{:08x}", crc32fast::hash(text.as_bytes())));
    environment.add_filter("xor8", |text: String| format!("{:02X}", text.bytes().fold(0, |sum, byte| sum ^ byte)));
    Ok(environment)
}
