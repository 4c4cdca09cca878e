//! `robot.toml`: the keys of every model, and those of its own model, which that model reads.

use super::toml_file::{self, Recovered, UnreadKeys};
use super::{paths, urdf};
use crate::base::files::{self, Stamp};
use crate::base::message::{Message, Place, Problems, Result};
use crate::math::robots::{Definition, Description, MODELS, Model, Parameter, Quantity, Robot, Role, Source, Tree};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, de};
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// `robot.toml`.
#[derive(Clone, Debug)]
pub struct RobotFile {
    /// Name for the report.
    pub name: Option<String>,
    nominal: BTreeMap<String, f64>,
    tolerance: BTreeMap<String, f64>,
    /// The model and its own keys; none where the file does not read.
    description: Option<(&'static Model, Arc<dyn Description>)>,
    /// The file as the user named it, and its text.
    source: (String, String),
    /// What of the file did not read.
    unread: UnreadKeys,
    /// The file that describes the robot.
    beside: Option<Beside>,
}

/// A file that robot.toml names.
#[derive(Clone, Debug)]
struct Beside {
    /// As the user named it.
    name: String,
    path: PathBuf,
    text: String,
    stamp: Stamp,
}

/// `robot.toml`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CommonKeys {
    /// Name of the robot, for the report and for `etalon compare`.
    name: Option<String>,
    /// The kinematic model.
    #[serde(deserialize_with = "model")]
    #[schemars(schema_with = "models")]
    model: &'static Model,
    /// Nominal parameters by name, in mm, deg or without unit. The geometry of the robot must be stated; other parameters
    /// have the values of the model.
    #[serde(default)]
    nominal: BTreeMap<String, f64>,
    /// How far from nominal a parameter may be identified, beyond which the set-up is wrong and nothing is exported: of all lengths
    /// of the robot (`length_mm`, 10 where it is not stated), all angles (`angle_deg`, 2), all gains and couplings (`ratio`, 0.05), or of one
    /// parameter by its name, in mm, deg or without unit.
    #[serde(default)]
    tolerance: BTreeMap<String, f64>,
}

const COMMON: [&str; 4] = ["name", "model", "nominal", "tolerance"];

/// Keys of `tolerance` that are those of a whole kind.
const KINDS: [(&str, Quantity); 3] =
    [("length_mm", Quantity::Length), ("angle_deg", Quantity::Angle), ("ratio", Quantity::Ratio)];

fn model<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<&'static Model, D::Error> {
    let name = String::deserialize(deserializer)?;
    MODELS.into_iter().find(|model| model.name == name).ok_or_else(|| {
        let names = MODELS.map(|model| format!("`{}`", model.name)).join(", ");
        de::Error::custom(format!("unknown variant `{name}`, expected one of {names}"))
    })
}

fn models(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "string", "enum": MODELS.map(|model| model.name) })
}

impl JsonSchema for RobotFile {
    fn schema_name() -> Cow<'static, str> {
        "RobotFile".into()
    }

    /// The keys of all models in one table.
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let mut generator = SchemaSettings::draft2020_12().with(|s| s.inline_subschemas = true).into_generator();
        let mut whole = CommonKeys::json_schema(&mut generator);
        for model in MODELS {
            let own = (model.schema)(&mut generator);
            merge(whole.ensure_object(), own.as_object());
        }
        whole
    }
}

/// Adds the properties of `other` that `whole` does not have, and those of the tables that both have.
fn merge(whole: &mut Map<String, Value>, other: Option<&Map<String, Value>>) {
    let Some(other) = other.and_then(|other| other.get("properties")).and_then(Value::as_object) else { return };
    let Some(properties) = whole.get_mut("properties").and_then(Value::as_object_mut) else { return };
    for (key, value) in other {
        match properties.get_mut(key).and_then(Value::as_object_mut) {
            Some(table) => merge(table, value.as_object()),
            None => drop(properties.insert(key.clone(), value.clone())),
        }
    }
}

/// Reads a table that is a robot.toml; keys that only other models have are left out.
fn read(root: Spanned<DeTable<'_>>) -> std::result::Result<RobotFile, toml::de::Error> {
    let span = root.span();
    let (mut common, mut own) = (DeTable::new(), DeTable::new());
    for (key, value) in root.into_inner() {
        let table = if COMMON.contains(&key.get_ref().as_ref()) { &mut common } else { &mut own };
        table.insert(key, value);
    }
    let common = CommonKeys::deserialize(toml::de::Deserializer::from(Spanned::new(span.clone(), common)))?;
    for path in foreign(common.model) {
        match path {
            [key] => drop(own.remove(*key)),
            [section, key] => {
                let Some(DeValue::Table(table)) = own.get_mut(*section).map(Spanned::get_mut) else { continue };
                table.remove(*key);
                if table.is_empty() {
                    own.remove(*section);
                }
            }
            _ => {}
        }
    }
    let description = Some((common.model, (common.model.read)(Spanned::new(span, own))?));
    Ok(RobotFile {
        name: common.name,
        nominal: common.nominal,
        tolerance: common.tolerance,
        description,
        source: Default::default(),
        unread: UnreadKeys::default(),
        beside: None,
    })
}

/// Keys that other models have, and this one has not.
fn foreign(model: &Model) -> impl Iterator<Item = &'static [&'static str]> {
    let all = MODELS.into_iter().rev().flat_map(|other| other.keys.iter().copied());
    all.filter(|path| !model.keys.contains(path))
}

impl Source for RobotFile {
    /// The file where the key is not there.
    fn place(&self, path: &[&str]) -> Place {
        let (name, text) = &self.source;
        let span = toml_file::find(text, path);
        span.map_or_else(|| Place::file(name.as_str()), |span| Place::span(name.as_str(), text, span))
    }

    fn tree(&self) -> Result<Tree> {
        // a file that does not read is reported already
        let Some(Beside { name, text, .. }) = &self.beside else { return Err(Problems::default()) };
        urdf::read(name, text)
    }
}

impl RobotFile {
    /// The robot file that is left when everything that does not fit is taken away, and what that is.
    pub(super) fn recover(path: &Path, text: &str) -> (Option<Self>, Problems) {
        let name = path.display().to_string();
        // what a wrong key may be meant as: keys of the model that is stated, of any where none is
        let written = toml_file::find(text, &["model"]).and_then(|span| text.get(span)).unwrap_or_default();
        let stated = |model: &&&Model| written.trim_matches(['"', '\'']) == model.name;
        let models = MODELS.iter().find(stated).map_or(&MODELS[..], std::slice::from_ref);
        let own = models.iter().flat_map(|model| model.keys.iter().filter_map(|path| path.first().copied()));
        let mut top: Vec<&str> = COMMON.into_iter().collect();
        own.for_each(|key| {
            if !top.contains(&key) {
                top.push(key)
            }
        });
        let Recovered { value, problems, unread } = toml_file::recover_with(&name, text, &top, read);
        let mut problems = problems;
        let mut robot = value.map(|robot| Self { source: (name, text.to_owned()), unread, ..robot });
        if let Some(robot) = &mut robot {
            robot.beside = problems.keep(robot.read_description(path)).flatten();
        }
        (robot, problems)
    }

    /// Reads the file that describes the robot, where there is one, beside `robot`.
    fn read_description(&self, robot: &Path) -> Result<Option<Beside>> {
        let Some(file) = self.description.as_ref().and_then(|(_, description)| description.file()) else {
            return Ok(None);
        };
        if self.unread.affects_entry("file") {
            return Ok(None);
        }
        let folder = robot.parent().unwrap_or(Path::new(""));
        let path = paths::resolve(folder, file).map_err(Problems::from);
        let read = path.and_then(|path| Ok((files::read_statement(&path)?, path)));
        let ((text, stamp), path) = read.map_err(|problems| problems.at(&self.place(&["file"])))?;
        Ok(Some(Beside { name: path.display().to_string(), path, text, stamp }))
    }

    /// The file that describes the robot, as robot.toml names it, and its text.
    pub fn description(&self) -> Option<(&str, &str)> {
        Some((self.description_file()?.0, self.beside.as_ref()?.text.as_str()))
    }

    /// Path of the file that describes the robot, where there is one.
    pub fn description_path(&self) -> Option<PathBuf> {
        Some(self.beside.as_ref()?.path.clone())
    }

    /// The file that describes the robot, as robot.toml names it, and what identifies it.
    pub fn description_file(&self) -> Option<(&str, &Stamp)> {
        let file = self.description.as_ref().and_then(|(_, description)| description.file())?;
        Some((file, &self.beside.as_ref()?.stamp))
    }

    /// Stands for a file that does not read, of which no robot can be built; the problems are reported already.
    pub(super) fn unreadable() -> Self {
        Self {
            name: None,
            nominal: BTreeMap::new(),
            tolerance: BTreeMap::new(),
            description: None,
            source: Default::default(),
            unread: UnreadKeys::default(),
            beside: None,
        }
    }

    /// The robot with these targets, where the model has none of its own.
    pub fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>> {
        // what did not read is reported already
        let readable = self.description.as_ref().filter(|(model, _)| {
            let essential = model.essential.iter().chain(&["model"]);
            essential.copied().all(|key| !self.unread.affects_entry(key))
        });
        let Some((model, description)) = readable else { return Err(Problems::default()) };
        let mut problems = self.odd_keys(model);
        let built = description.build(targets, self).and_then(|mut robot| {
            let mut values = robot.nominal();
            self.nominal(robot.as_ref(), description.states_geometry(), &mut values)?;
            robot.definition_mut().set_nominal(&values);
            self.tolerances(robot.definition_mut())?;
            Ok(robot)
        });
        built.map_err(|more| problems.0.extend(more.0)).ok().filter(|_| problems.0.is_empty()).ok_or(problems)
    }

    /// Errors about keys that only other models have.
    fn odd_keys(&self, model: &Model) -> Problems {
        let mut odd: Vec<Message> = Vec::new();
        let (name, text) = &self.source;
        let stated = toml_file::Stated::of(text);
        for path in foreign(model) {
            let (Some(span), Some(key)) = (stated.find(path), path.last()) else { continue };
            let place = Place::span(name.as_str(), text, span);
            let owner = MODELS.into_iter().find(|other| other.keys.contains(&path)).map_or("", |owner| owner.name);
            let message = Message::error(format!("`{key}` means nothing for this model")).at(place);
            odd.push(message.hint(format!("it belongs to `model = \"{owner}\"`")));
        }
        odd.dedup();
        Problems(odd)
    }

    /// Writes the nominal values of the file over those of `robot`.
    fn nominal(&self, robot: &dyn Robot, geometry_is_stated: bool, values: &mut [f64]) -> Result<()> {
        let mut problems = Problems::default();
        for (name, value) in &self.nominal {
            let Some(i) = robot.index(name) else {
                let names = robot.parameters().iter().map(|p| p.name.as_str());
                let what = format!("[nominal] names `{name}`, which is not a parameter of this robot");
                problems.0.push(Message::error(what).at(self.place(&["nominal", name])).hint_names(name, names));
                continue;
            };
            let p = &robot.parameters()[i];
            // the mirrored arm explains the measurements as well
            let is_length = p.quantity == Quantity::Length && p.role == Role::Robot && p.nominal > 0.0;
            if is_length && !geometry_is_stated && *value <= 0.0 {
                let message = Message::error(format!("the length `{name}` must be positive"));
                problems.0.push(message.at(self.place(&["nominal", name])));
            }
            values[i] = p.quantity.inward(*value);
        }
        if !geometry_is_stated && !self.unread.contains(&["nominal".to_owned()]) {
            problems.0.extend(self.unstated(robot));
        }
        problems.check().map(|_| ())
    }

    /// Writes the tolerances of the file over those of the model: those of a kind first, then those of single parameters.
    fn tolerances(&self, definition: &mut Definition) -> Result<()> {
        let mut problems = Problems::default();
        for (name, &value) in &self.tolerance {
            let place = || self.place(&["tolerance", name]);
            if !(value > 0.0 && value.is_finite()) {
                let what = format!("the tolerance `{name}` must be positive");
                problems.0.push(Message::error(what).at(place()));
            }
            let kind = KINDS.iter().find(|(key, _)| key == name).map(|(_, quantity)| *quantity);
            let of_kind = |p: &&mut Parameter| kind == Some(p.quantity) && p.role == Role::Robot;
            definition.parameters.iter_mut().filter(of_kind).for_each(|p| p.state_tolerance(value));
            if kind.is_none() && definition.parameters.iter().all(|p| p.name != *name) {
                let names = KINDS.iter().map(|k| k.0).chain(definition.parameters.iter().map(|p| p.name.as_str()));
                let what = format!("`tolerance` names `{name}`, which is not a parameter of this robot");
                problems.0.push(Message::error(what).at(place()).hint_names(name, names));
            }
        }
        for parameter in &mut definition.parameters {
            if let Some(value) = self.tolerance.get(&parameter.name) {
                parameter.state_tolerance(*value);
            }
        }
        problems.check().map(|_| ())
    }

    /// An error about geometry that the file does not state: the model's own is that of one machine, not of this one.
    fn unstated(&self, robot: &dyn Robot) -> Option<Message> {
        let own = |p: &&Parameter| p.role == Role::Robot && p.quantity != Quantity::Ratio && p.nominal != 0.0;
        let names = robot.parameters().iter().filter(own).map(|p| p.name.as_str());
        let missing = |n: &&str| !self.nominal.contains_key(*n) && !self.unread.affects(&["nominal", n]);
        let names: Vec<String> = names.filter(missing).map(|n| format!("`{n}`")).collect();
        if names.is_empty() {
            return None;
        }
        let what = format!("[nominal] does not state {}", names.join(", "));
        let message = Message::error(what).at(self.place(&["nominal"]));
        Some(message.hint("state the geometry of your machine as it is drawn, in mm: it is never guessed"))
    }
}
