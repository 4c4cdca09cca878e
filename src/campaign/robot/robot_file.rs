//! `robot.toml`: keys of all models, and keys of the selected model, which that model reads.

use crate::toml_file::{self, Recovered, UnreadKeys};
use crate::urdf::{self, Urdf};
use crate::{paths, robot_faults, robot_keys};
use etalon_base::error;
use etalon_base::files::{self, Stamp};
use etalon_base::message::{Message, Place, Problems, Result, nearest};
use etalon_base::pose::{Pose, Vector};
use etalon_documents::RobotLinks;
use etalon_robots::{
    At, Definition, FaultKind, Faults, JointRef, Key, MODELS, Model, Parameter, Quantity, Robot, Role, Shape, Value,
    Values,
};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, de};
use serde_json::{Map, Value as Json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Contents of `robot.toml`.
#[derive(Clone, Debug)]
pub struct RobotFile {
    /// Name for the report.
    pub name: Option<String>,
    nominal: BTreeMap<String, f64>,
    tolerance: BTreeMap<String, f64>,
    /// Model with the values of its own keys; `None` if the file could not be read.
    description: Option<(&'static Model, Values)>,
    /// Name and text of the file, as the user named it.
    source: (String, String),
    /// Entries of the file that could not be read.
    unread: UnreadKeys,
    /// Additional file that describes the robot.
    beside: Option<Beside>,
}

/// A file that robot.toml names.
#[derive(Clone, Debug)]
struct Beside {
    path: PathBuf,
    text: String,
    stamp: Stamp,
}

/// Mesh of a moving part of the robot.
#[derive(Clone, Debug)]
pub struct PartMesh {
    /// `base`, or the joint that moves the part.
    pub part: String,
    /// Frame of the mesh in the frame of the part (mm).
    pub place: Pose,
    /// Factors of the mesh's coordinates, which are then in metres.
    pub scale: Vector,
    /// File as the URDF states it.
    pub file: String,
}

/// Keys of `robot.toml` common to all models.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CommonKeys {
    /// Name of the robot, for the report and for `etalon compare`.
    name: Option<String>,
    /// Kinematic model.
    #[serde(deserialize_with = "model")]
    #[schemars(schema_with = "models")]
    model: &'static Model,
    /// Nominal parameters by name (mm, deg or without unit). The geometry of the robot must be
    /// given; other parameters default to the values of the model.
    #[serde(default)]
    nominal: BTreeMap<String, f64>,
    /// Tolerances about nominal values. If an identified parameter is beyond its tolerance, the
    /// set-up is considered wrong and nothing is exported. `length_mm` (default 10), `angle_deg`
    /// (default 2) and `ratio` (default 0.05) apply to all lengths, angles, and gains and
    /// couplings. The name of a parameter applies to this parameter (mm, deg or without unit).
    #[serde(default)]
    tolerance: BTreeMap<String, f64>,
}

const COMMON: [&str; 4] = ["name", "model", "nominal", "tolerance"];

/// Keys of `tolerance` that apply to all parameters of a kind.
const KINDS: [(&str, Quantity); 3] =
    [("length_mm", Quantity::Length), ("angle_deg", Quantity::Angle), ("ratio", Quantity::Ratio)];

fn model<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<&'static Model, D::Error> {
    let name = String::deserialize(deserializer)?;
    MODELS.into_iter().find(|model| model.name == name).ok_or_else(|| {
        let names = MODELS.map(|model| format!("`{}`", model.name)).join(", ");
        de::Error::custom(format!("unknown variant `{name}`, expected one of {names}"))
    })
}

#[cfg(feature = "schemas")]
fn models(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({ "type": "string", "enum": MODELS.map(|model| model.name) })
}

etalon_base::schema_by_hand!(RobotFile, _ => {
    let settings = schemars::generate::SchemaSettings::draft2020_12().with(|s| s.inline_subschemas = true);
    let mut whole = CommonKeys::json_schema(&mut settings.into_generator());
    for model in MODELS {
        merge(whole.ensure_object(), robot_keys::schema(&model.keys()).as_object());
    }
    whole
});

/// Returns the schema of the keys of all models in one table.
fn all_keys() -> Arc<Json> {
    toml_file::schema("robot.toml", crate::SCHEMAS)
}

/// Schema of the keys of one model, including mandatory keys, which allows keys of other models
/// with any value, as these are reported separately.
fn model_schema(model: &Model, all: &Json) -> Json {
    let mut schema = all.clone();
    if let Some(properties) = schema["properties"].as_object_mut() {
        properties.retain(|key, _| COMMON.contains(&key.as_str()));
    }
    let own = robot_keys::schema(&model.keys());
    schema.as_object_mut().into_iter().for_each(|whole| merge(whole, own.as_object()));
    if let (Some(required), Some(own)) = (schema["required"].as_array_mut(), own["required"].as_array()) {
        required.extend(own.iter().cloned());
    }
    for path in foreign(model) {
        let mut table = &mut schema;
        for key in path {
            if table["properties"].get(&key).is_none() {
                table["properties"][&key] = Json::Bool(true);
            }
            table = &mut table["properties"][&key];
            if table.is_boolean() {
                break;
            }
        }
    }
    schema
}

/// Adds properties of `other` that are missing in `whole`, also in common tables.
fn merge(whole: &mut Map<String, Json>, other: Option<&Map<String, Json>>) {
    let Some(other) = other.and_then(|other| other.get("properties")).and_then(Json::as_object) else { return };
    let Some(properties) = whole.get_mut("properties").and_then(Json::as_object_mut) else { return };
    for (key, value) in other {
        match properties.get_mut(key).and_then(Json::as_object_mut) {
            Some(table) => merge(table, value.as_object()),
            None => drop(properties.insert(key.clone(), value.clone())),
        }
    }
}

/// Reads a table as robot.toml; keys that only other models have are ignored.
fn read(root: Spanned<DeTable<'_>>) -> std::result::Result<RobotFile, toml::de::Error> {
    let span = root.span();
    let (mut common, mut own) = (DeTable::new(), DeTable::new());
    for (key, value) in root.into_inner() {
        let table = if COMMON.contains(&key.get_ref().as_ref()) { &mut common } else { &mut own };
        table.insert(key, value);
    }
    let common = CommonKeys::deserialize(toml::de::Deserializer::from(Spanned::new(span.clone(), common)))?;
    for path in foreign(common.model) {
        match &path[..] {
            [key] => drop(own.remove(key.as_str())),
            [section, key] => {
                let Some(DeValue::Table(table)) = own.get_mut(section.as_str()).map(Spanned::get_mut) else { continue };
                table.remove(key.as_str());
                if table.is_empty() {
                    own.remove(section.as_str());
                }
            }
            _ => {}
        }
    }
    let description = Some((common.model, robot_keys::read(&common.model.keys(), Spanned::new(span, own))?));
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

/// Keys of other models that this model does not have.
fn foreign(model: &Model) -> impl Iterator<Item = Vec<String>> {
    let own = robot_keys::paths(&model.keys());
    let all = MODELS.into_iter().rev().flat_map(|other| robot_keys::paths(&other.keys()));
    all.filter(move |path| !own.contains(path))
}

/// Errors of a robot that cannot be built.
#[derive(Clone, Debug, Default)]
pub struct Unbuilt {
    /// All errors.
    pub problems: Problems,
    /// Indices of the errors that a robot in space has no target.
    pub without_target: Vec<usize>,
}

impl From<Problems> for Unbuilt {
    fn from(problems: Problems) -> Self {
        Self { problems, without_target: Vec::new() }
    }
}

impl RobotFile {
    /// Place of a key, given by the keys that lead to it; the file if the key is missing.
    fn place(&self, path: &[&str]) -> Place {
        let (name, text) = &self.source;
        let span = toml_file::find(text, path);
        span.map_or_else(|| Place::file(name.as_str()), |span| Place::span(name.as_str(), text, span))
    }

    /// Messages for faults of the description, with their places in this file or in the file with
    /// links and joints.
    fn worded(&self, faults: &Faults, keys: &[Key], urdf: Option<&Urdf>) -> Problems {
        let file = self.description_name().unwrap_or_default();
        let message = |fault: &etalon_robots::Fault| {
            let table = if let At::Item(key, i) = fault.at { vec![key.to_owned(), i.to_string()] } else { Vec::new() };
            let path_of = |own: &str| [&table[..], &[own.to_owned()]].concat();
            let find =
                |path: &[String]| toml_file::find(&self.source.1, &path.iter().map(String::as_str).collect::<Vec<_>>());
            // as spelled in the file, if given
            let spellings = |name: &str| {
                let mut all =
                    robot_keys::named(keys, name).map_or_else(|| vec![name.to_owned()], robot_keys::spellings);
                all.sort_by_key(|spelling| find(&path_of(spelling)).is_none());
                all
            };
            let message = robot_faults::message(&fault.kind, &spellings, file);
            match &fault.at {
                At::Nowhere => message,
                At::Key(key) => message.at(self.place(&[&spellings(key)[0]])),
                At::Item(key, i) => message.at(self.place(&[key, &i.to_string()])),
                at => message.at(urdf.and_then(|urdf| urdf.place(at)).unwrap_or_else(|| Place::file(file))),
            }
        };
        Problems(faults.0.iter().map(message).collect())
    }

    /// Reads a robot file without the entries that do not fit, and returns the problems.
    pub(crate) fn recover(path: &Path, text: &str) -> (Option<Self>, Problems) {
        let (mut robot, mut problems) = Self::alone(path, text);
        if let Some(robot) = &mut robot {
            robot.beside = problems.keep(robot.read_description(path)).flatten();
        }
        (robot, problems)
    }

    /// Reads a robot file whose URDF is this text.
    pub(crate) fn from_urdf(urdf: &str, [base_link, tool_link]: [&str; 2]) -> Result<Self> {
        let [base, tool] = [base_link, tool_link].map(toml::Value::from);
        let text = format!("model = \"urdf\"\nfile = \"robot.urdf\"\nbase_link = {base}\ntool_link = {tool}\n");
        Self::with_description(Path::new("robot.toml"), &text, urdf)
    }

    /// Reads a robot file whose description is this text instead of a file.
    pub(crate) fn with_description(path: &Path, text: &str, description: &str) -> Result<Self> {
        let (robot, problems) = Self::alone(path, text);
        let robot = robot.filter(|_| problems.0.is_empty()).ok_or(problems)?;
        let name = robot.description_name().unwrap_or_default().into();
        let beside = Beside { path: name, text: description.to_owned(), stamp: Stamp::new(description.as_bytes()) };
        Ok(Self { beside: Some(beside), ..robot })
    }

    /// Reads a robot file without the file that describes the robot.
    fn alone(path: &Path, text: &str) -> (Option<Self>, Problems) {
        let name = path.display().to_string();
        // without a given model, keys of any model
        let written = toml_file::find(text, &["model"]).and_then(|span| text.get(span)).unwrap_or_default();
        let stated = MODELS.iter().find(|model| written.trim_matches(['"', '\'']) == model.name);
        let schema = match stated {
            Some(model) => {
                let all = all_keys();
                toml_file::kept_schema(model.name, || model_schema(model, &all))
            }
            None => all_keys(),
        };
        let Recovered { value, problems, unread } = toml_file::recover_with(&name, text, &schema, read);
        (value.map(|robot| Self { source: (name, text.to_owned()), unread, ..robot }), problems)
    }

    /// Reads the file that describes the robot, relative to `robot`, if there is one.
    fn read_description(&self, robot: &Path) -> Result<Option<Beside>> {
        let Some(file) = self.description_name() else { return Ok(None) };
        if self.unread.affects_entry("file") {
            return Ok(None);
        }
        let folder = robot.parent().unwrap_or(Path::new(""));
        let path = paths::resolve(folder, file).map_err(Problems::from);
        let read = path.and_then(|path| Ok((files::read_statement(&path)?, path)));
        let ((text, stamp), path) = read.map_err(|problems| problems.at(&self.place(&["file"])))?;
        Ok(Some(Beside { path, text, stamp }))
    }

    /// Key and name of the file that describes the robot.
    fn tree_key(&self) -> Option<(&'static str, &str)> {
        let (model, values) = self.description.as_ref()?;
        let key = model.keys().into_iter().find(|key| matches!(key.shape, Shape::Tree))?;
        if let Value::Text(file) = values.get(key.name)? { Some((key.name, file)) } else { None }
    }

    /// Name of the file that describes the robot, as in robot.toml.
    fn description_name(&self) -> Option<&str> {
        Some(self.tree_key()?.1)
    }

    /// Name, as in robot.toml, and text of the file that describes the robot.
    pub fn description(&self) -> Option<(&str, &str)> {
        Some((self.description_file()?.0, self.beside.as_ref()?.text.as_str()))
    }

    /// Returns the text of this file with another name of the file that describes the robot.
    pub fn text_beside(&self, name: &str) -> String {
        let mut text = self.source.1.clone();
        if let Some(span) = self.tree_key().and_then(|(key, _)| toml_file::find(&text, &[key])) {
            text.replace_range(span, &toml::Value::from(name).to_string());
        }
        text
    }

    /// Meshes of the links of the robot's URDF on the moving parts of these names; none for other
    /// robots, and for a base that moves.
    pub fn meshes(&self, robot: &dyn Robot, parts: &[&str]) -> Vec<PartMesh> {
        let values = self.description.as_ref().map(|(_, values)| values);
        let stated = values.and_then(|values| values.get("base_link"));
        let (Some(Value::Text(base_link)), Some(beside)) = (stated, &self.beside) else { return Vec::new() };
        let file = beside.path.display().to_string();
        let Ok(urdf) = urdf::read(&file, &beside.text) else { return Vec::new() };
        if !robot.joints_of_base().is_empty() {
            return Vec::new();
        }
        let on_part = |mesh: urdf::LinkMesh| {
            let (part, link) = urdf.tree.carrying_part(&mesh.link, base_link, parts)?;
            let part = part.unwrap_or("base").to_owned();
            Some(PartMesh { part, place: link.then(&mesh.place), scale: mesh.scale, file: mesh.file })
        };
        urdf::meshes(&file, &beside.text).into_iter().filter_map(on_part).collect()
    }

    /// Path of the file that describes the robot, if there is one.
    pub fn description_path(&self) -> Option<&PathBuf> {
        self.beside.as_ref().map(|beside| &beside.path)
    }

    /// Name, as in robot.toml, and stamp of the file that describes the robot.
    pub fn description_file(&self) -> Option<(&str, &Stamp)> {
        Some((self.description_name()?, &self.beside.as_ref()?.stamp))
    }

    /// Placeholder for an unreadable file, from which no robot can be built; its problems are
    /// already reported.
    pub(crate) fn unreadable() -> Self {
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

    /// Links at base and ends of the kinematic chain; `None` for a robot without a URDF.
    pub fn links(&self, robot: &dyn Robot) -> Option<RobotLinks> {
        let (_, values) = self.description.as_ref()?;
        let text = |values: &Values, key: &str| match values.get(key) {
            Some(Value::Text(link)) => Some(link.clone()),
            _ => None,
        };
        let tool = text(values, "tool_link").into_iter();
        let ends = tool.chain(robot.branches().iter().cloned()).collect();
        Some(RobotLinks { base: text(values, "base_link")?, ends, base_moves: !robot.joints_of_base().is_empty() })
    }

    /// Targets on each branch of the robot; empty for a robot of one chain.
    pub fn branches(&self) -> Vec<Vec<String>> {
        let stated = self.description.as_ref().and_then(|(_, values)| values.get("branch"));
        let branches = if let Some(Value::Tables(branches)) = stated { &branches[..] } else { &[] };
        let targets = |branch: &Values| match branch.get("targets") {
            Some(Value::Words(words)) => words.clone(),
            _ => Vec::new(),
        };
        branches.iter().map(targets).collect()
    }

    /// Targets on the branches of the robot; otherwise those whose positions the file contains, or
    /// `name`: for commands that need any target.
    pub fn targets_or(&self, name: &str) -> Vec<String> {
        let mut targets = self.branches().concat();
        if targets.is_empty() {
            targets = self.placed_targets();
        }
        if targets.is_empty() { vec![name.to_owned()] } else { targets }
    }

    /// Targets whose positions `[nominal]` or `[tolerance]` gives, such as `SMR` by `SMR_x`. A name
    /// similar to a parameter's is misspelt, and belongs to no target.
    fn placed_targets(&self) -> Vec<String> {
        let Some((robot, suffixes)) = self.target_suffixes() else { return Vec::new() };
        let others: Vec<&str> = robot.parameters().iter().map(|p| p.name.as_str()).collect();
        let stem = |name: &str, suffix: &String| name.strip_suffix(suffix.as_str()).map(str::to_owned);
        let mut targets: Vec<String> = Vec::new();
        for name in self.nominal.keys().chain(self.tolerance.keys()).filter(|name| !others.contains(&name.as_str())) {
            let Some((target, suffix)) = suffixes.iter().find_map(|s| Some((stem(name, s)?, s))) else { continue };
            let alike: Vec<String> = others.iter().filter_map(|other| stem(other, suffix)).collect();
            let is_misspelt = nearest(&target, alike.iter().map(String::as_str)).is_some();
            if !target.is_empty() && !is_misspelt && !targets.contains(&target) {
                targets.push(target);
            }
        }
        targets
    }

    /// The robot of the description with one target, and the ends of the names of the target's
    /// parameters after its name.
    fn target_suffixes(&self) -> Option<(Box<dyn Robot>, Vec<String>)> {
        const TARGET: &str = "etalon";
        let (model, values) = self.description.as_ref()?;
        let robot = self.built(model, values.clone(), &[TARGET.to_owned()]).ok()?;
        let of_target = robot.parameters().iter().filter(|p| p.role == Role::Target);
        let suffixes = of_target.filter_map(|p| p.name.strip_prefix(TARGET).map(str::to_owned)).collect();
        Some((robot, suffixes))
    }

    /// Returns the text of this file with the positions (mm) of targets among the nominal values;
    /// `None` if a position has another number of coordinates than the robot's targets.
    pub fn text_with_targets(&self, positions: &BTreeMap<String, Vec<f64>>) -> Option<String> {
        let (_, suffixes) = self.target_suffixes()?;
        let mut file: toml::Table = self.source.1.parse().ok()?;
        let nominal = file.entry("nominal").or_insert_with(|| toml::Value::Table(toml::Table::new()));
        let nominal = nominal.as_table_mut()?;
        for (target, position) in positions {
            if position.len() != suffixes.len() || suffixes.is_empty() {
                return None;
            }
            let named = suffixes.iter().zip(position);
            nominal.extend(named.map(|(suffix, value)| (format!("{target}{suffix}"), toml::Value::Float(*value))));
        }
        toml::to_string(&file).ok()
    }

    /// Builds the robot; `targets` applies if the model has no targets of its own.
    pub fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>> {
        self.try_build(targets).map_err(|unbuilt| unbuilt.problems)
    }

    /// Builds the robot like [`Self::build`]; the error shows whether targets are missing.
    pub(crate) fn try_build(&self, targets: &[String]) -> std::result::Result<Box<dyn Robot>, Unbuilt> {
        // unreadable entries are already reported
        let readable = self.description.as_ref().filter(|(model, _)| {
            let essential = robot_keys::essential(&model.keys());
            !self.unread.affects_entry("model") && essential.iter().all(|key| !self.unread.affects_entry(key))
        });
        let Some((model, values)) = readable else { return Err(Unbuilt::default()) };
        let mut problems = self.odd_keys(model);
        let mut without_target = Vec::new();
        let built = self.built(model, values.clone(), targets).and_then(|mut robot| {
            let mut values = robot.nominal();
            self.nominal(robot.as_ref(), model.states_geometry, &mut values)?;
            robot.definition_mut().set_nominal(&values);
            robot.settle();
            self.tolerances(robot.definition_mut())?;
            Ok(robot)
        });
        let robot = built.map_err(|more: Unbuilt| {
            without_target.extend(more.without_target.into_iter().map(|i| problems.0.len() + i));
            problems.0.extend(more.problems.0);
        });
        robot.ok().filter(|_| problems.0.is_empty()).ok_or(Unbuilt { problems, without_target })
    }

    /// Builds the robot with an effect of these joints, by number from 1, and these targets; `None`
    /// if the file contains the effect, or if the model has no such key.
    pub fn build_with(&self, key: &'static str, joints: &[usize], targets: &[String]) -> Option<Box<dyn Robot>> {
        let (model, values) = self.description.as_ref()?;
        if values.contains_key(key) || !model.keys().iter().any(|known| known.name == key) {
            return None;
        }
        let mut file = self.clone();
        let joints = joints.iter().map(|joint| JointRef::Number(*joint)).collect();
        file.description.as_mut()?.1.insert(key, Value::Joints(joints));
        file.build(targets).ok()
    }

    /// Builds the robot with these targets and with one of two effects: the tilt of its base, or
    /// the tilt of its first joint across the axis; `None` if the model has no such keys.
    pub fn build_first_tilt(&self, first: &str, of_base: bool, targets: &[String]) -> Option<Box<dyn Robot>> {
        const KEYS: [&str; 2] = ["lateral", "pedestal"];
        let (model, _) = self.description.as_ref()?;
        if !KEYS.iter().all(|key| model.keys().iter().any(|known| known.name == *key)) {
            return None;
        }
        let mut file = self.clone();
        let values = &mut file.description.as_mut()?.1;
        let mut joints = match values.remove(KEYS[0]) {
            Some(Value::Joints(joints)) => joints,
            _ => Vec::new(),
        };
        joints.retain(|joint| *joint != JointRef::Number(1) && *joint != JointRef::Name(first.to_owned()));
        if !of_base {
            joints.insert(0, JointRef::Number(1));
        }
        if !joints.is_empty() {
            values.insert(KEYS[0], Value::Joints(joints));
        }
        values.insert(KEYS[1], Value::Flag(of_base));
        file.build(targets).ok()
    }

    /// Robot by its description alone.
    fn built(
        &self,
        model: &Model,
        mut values: Values,
        targets: &[String],
    ) -> std::result::Result<Box<dyn Robot>, Unbuilt> {
        let mut urdf = None;
        if let Some((key, _)) = self.tree_key() {
            // an unreadable file is already reported
            let Some(Beside { path, text, .. }) = &self.beside else { return Err(Unbuilt::default()) };
            let file = urdf.insert(urdf::read(&path.display().to_string(), text)?);
            values.insert(key, Value::Tree(file.tree.clone()));
        }
        model.build(&values, targets).map_err(|faults| {
            let kinds = faults.0.iter().map(|fault| &fault.kind).enumerate();
            let without_target = kinds.filter(|(_, kind)| **kind == FaultKind::NoTarget).map(|(i, _)| i).collect();
            Unbuilt { problems: self.worded(&faults, &model.keys(), urdf.as_ref()), without_target }
        })
    }

    /// Errors for keys that only other models have.
    fn odd_keys(&self, model: &Model) -> Problems {
        let mut odd: Vec<Message> = Vec::new();
        let (name, text) = &self.source;
        let stated = toml_file::Stated::parse(text);
        for path in foreign(model) {
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            let (Some(span), Some(key)) = (stated.find(&path), path.last()) else { continue };
            let place = Place::span(name.as_str(), text, span);
            let owner =
                MODELS.into_iter().find(|other| robot_keys::paths(&other.keys()).iter().any(|own| *own == path));
            let model = owner.map_or("", |owner| owner.name);
            odd.push(error!("key-of-other-model", key, model).at(place));
        }
        odd.dedup();
        Problems(odd)
    }

    /// `true` if the file contains the nominal value of a parameter.
    pub fn states_nominal(&self, parameter: &str) -> bool {
        self.nominal.contains_key(parameter)
    }

    /// Overwrites nominal values of `robot` with the values of the file.
    fn nominal(&self, robot: &dyn Robot, geometry_is_stated: bool, values: &mut [f64]) -> Result<()> {
        let mut problems = Problems::default();
        for (name, value) in &self.nominal {
            let Some(i) = robot.index(name) else {
                let names = robot.parameters().iter().map(|p| p.name.as_str());
                let message = error!("nominal-unknown", parameter = name).at(self.place(&["nominal", name]));
                problems.0.push(message.hint_names(name, names));
                continue;
            };
            let p = &robot.parameters()[i];
            // the mirrored arm fits the measurements equally well
            let is_length = p.quantity == Quantity::Length && p.role == Role::Robot && p.nominal > 0.0;
            if is_length && !geometry_is_stated && *value <= 0.0 {
                let message = error!("nominal-length-not-positive", parameter = name);
                problems.0.push(message.at(self.place(&["nominal", name])));
            }
            values[i] = p.quantity.inward(*value);
        }
        if !geometry_is_stated && !self.unread.contains(&["nominal".to_owned()]) {
            problems.0.extend(self.unstated(robot));
        }
        problems.check().map(|_| ())
    }

    /// Overwrites tolerances of the model with tolerances of the file: first of a kind, then of
    /// single parameters.
    fn tolerances(&self, definition: &mut Definition) -> Result<()> {
        let mut problems = Problems::default();
        for (name, &value) in &self.tolerance {
            let place = || self.place(&["tolerance", name]);
            if !(value > 0.0 && value.is_finite()) {
                problems.0.push(error!("tolerance-not-positive", parameter = name).at(place()));
            }
            let kind = KINDS.iter().find(|(key, _)| key == name).map(|(_, quantity)| *quantity);
            let of_kind = |p: &&mut Parameter| kind == Some(p.quantity) && p.role == Role::Robot;
            definition.parameters.iter_mut().filter(of_kind).for_each(|p| p.state_tolerance(value));
            if kind.is_none() && definition.parameters.iter().all(|p| p.name != *name) {
                let names = KINDS.iter().map(|k| k.0).chain(definition.parameters.iter().map(|p| p.name.as_str()));
                let message = error!("tolerance-unknown", parameter = name).at(place());
                problems.0.push(message.hint_names(name, names));
            }
        }
        for parameter in &mut definition.parameters {
            if let Some(value) = self.tolerance.get(&parameter.name) {
                parameter.state_tolerance(*value);
            }
        }
        problems.check().map(|_| ())
    }

    /// Error for geometry that the file does not contain, because the model's default belongs to
    /// another machine.
    fn unstated(&self, robot: &dyn Robot) -> Option<Message> {
        let own = |p: &&Parameter| p.role == Role::Robot && p.quantity != Quantity::Ratio && p.nominal != 0.0;
        let names = robot.parameters().iter().filter(own).map(|p| p.name.as_str());
        let missing = |n: &&str| !self.nominal.contains_key(*n) && !self.unread.affects(&["nominal", n]);
        let names: Vec<String> = names.filter(missing).map(|n| format!("`{n}`")).collect();
        if names.is_empty() {
            return None;
        }
        Some(error!("nominal-missing", parameters = names).at(self.place(&["nominal"])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors of a robot with one target, each with its line.
    fn errors(text: &str) -> Vec<String> {
        let (robot, mut problems) = RobotFile::recover(Path::new("robot.toml"), text);
        if let Some(robot) = robot {
            let built = robot.build(&["ball".to_owned()]);
            problems.0.extend(built.err().unwrap_or_default().0);
        }
        let line = |m: &Message| m.place.as_ref().and_then(|p| p.line);
        let named = |m: &Message| {
            let key = ["key", "keys", "text", "fault"].into_iter().find_map(|name| m.arguments.get(name));
            format!("{} {}", m.id, key.map_or_else(String::new, |key| format!("{key:?}")))
        };
        let placed = |m: &Message| line(m).map_or_else(|| named(m), |line| format!("{line}: {}", named(m)));
        problems.0.iter().map(placed).collect()
    }

    const DH: &str = "[[joint]]\nalpha_deg = 0\na_mm = 0\ntheta_deg = 0\nd_mm = 300\n";

    #[test]
    fn models_read_their_keys_in_either_unit() {
        let other = DH.replace("a_mm = 0", "a_m = 0.27").replace("theta_deg = 0", "theta_rad = 0.5");
        let (robot, problems) =
            RobotFile::recover(Path::new("robot.toml"), &format!("model = \"serial\"\n{DH}{other}"));
        assert!(problems.0.is_empty(), "{problems:?}");
        let robot = robot.unwrap().build(&["ball".to_owned()]).unwrap();
        let nominal = |name: &str| robot.parameters()[robot.index(name).unwrap()].nominal;
        assert_eq!([nominal("a_2"), nominal("theta_2"), nominal("d_1")], [270.0, 0.5, 300.0]);
    }

    #[test]
    fn targets_are_those_whose_positions_the_file_states() {
        let read = |more: &str| {
            let text = format!("model = \"serial\"\n{DH}{more}");
            RobotFile::recover(Path::new("robot.toml"), &text).0.unwrap()
        };
        assert_eq!(read("").targets_or("tool"), ["tool"]);
        let stated = read("[nominal]\nSMR_x = 80\nball_z = 2\nbase_x = 1\n[tolerance]\nSMR_y = 1\n");
        assert_eq!(stated.targets_or("tool"), ["SMR", "ball"]);
        let robot = stated.build(&stated.targets_or("tool")).unwrap();
        assert_eq!(robot.parameters()[robot.index("SMR_x").unwrap()].nominal, 80.0);
        // a misspelt parameter is not taken for a target
        for slip in ["bas_x = 80", "thta_1 = 2", "_x = 1"] {
            let file = read(&format!("[nominal]\n{slip}\n"));
            assert_eq!(file.targets_or("tool"), ["tool"], "{slip}");
            let problems = file.build(&file.targets_or("tool")).err().unwrap();
            assert!(problems.0[0].is("nominal-unknown", &[]), "{slip}");
        }
        // positions in addition to the positions of the file
        let positions = BTreeMap::from([("SMR".to_owned(), vec![1.5, -2.0, 1e-3])]);
        let text = stated.text_with_targets(&positions).unwrap();
        let other = RobotFile::recover(Path::new("robot.toml"), &text).0.unwrap();
        let robot = other.build(&other.targets_or("tool")).unwrap();
        let nominal = |name: &str| robot.parameters()[robot.index(name).unwrap()].nominal;
        assert_eq!(["SMR_x", "SMR_y", "SMR_z", "ball_z", "d_1"].map(nominal), [1.5, -2.0, 1e-3, 2.0, 300.0]);
        assert!(stated.text_with_targets(&BTreeMap::from([("SMR".to_owned(), vec![1.5])])).is_none());
    }

    #[test]
    fn defaults_are_those_of_the_model() {
        let text =
            "model = \"delta\"\nbase_radius_mm = 200\nplatform_radius_mm = 50\nrod_mm = 400\nupper_arm_mm = 150\n";
        let (robot, _) = RobotFile::recover(Path::new("robot.toml"), text);
        let stated = RobotFile::recover(Path::new("robot.toml"), &format!("{text}azimuth_deg = [0, 120, 240]\n")).0;
        let place = |robot: Option<RobotFile>| {
            let robot = robot.unwrap().build(&["ball".to_owned()]).unwrap();
            robot.position(&robot.nominal(), &[0.1, 0.2, 0.3], 0)
        };
        assert_eq!(place(robot), place(stated));
    }

    #[test]
    fn faults_are_worded_with_the_keys_and_places_of_the_file() {
        let serial = |more: &str| errors(&format!("model = \"serial\"\n{more}"));
        for (found, expected) in [
            (serial(""), &["no-joints"][..]),
            (serial("convention = \"PoE\"\n"), &["2: unknown-variant Text(\"PoE\")", "no-joints"]),
            (
                serial(&format!("bending = [1, 3, 1]\ncoupling = [[1, 1]]\ngravity = [0, 0, 0]\n{DH}")),
                &[
                    "2: joint-reference-wrong Text(\"unknown-number\")",
                    "2: joint-reference-wrong Text(\"twice\")",
                    "3: joint-reference-wrong Text(\"itself\")",
                    "4: gravity-without-direction",
                ],
            ),
            (
                serial(&DH.replace("a_mm = 0", "alpha_rad = 0\npoint_m = [0, 0, 0]")),
                &[
                    "2: keys-state-the-same List([Text(\"`alpha_deg`\"), Text(\"`alpha_rad`\")])",
                    "2: joint-key-missing Text(\"a_mm\")",
                    "2: not-denavit-hartenberg Text(\"point_m\")",
                ],
            ),
            (serial(&DH.replace("alpha_deg = 0", "alpha_rad = -90")), &["2: joint-angle-unit Text(\"alpha_rad\")"]),
            (
                serial(&DH.replace("theta_deg = 0", "theta_deg = -3.14159")),
                &["2: joint-angle-unit Text(\"theta_deg\")"],
            ),
            (serial(&DH.replace("alpha_deg", "alpha")), &["3: unknown-key List([Text(\"`alpha`\")])"]),
            (
                serial(&format!("convention = \"poe\"\n{DH}")),
                &[
                    "3: not-screw-axis",
                    "3: joint-key-missing Text(\"direction\")",
                    "3: joint-key-missing Text(\"point_mm\")",
                    "2: flange-missing Text(\"flange_xyz_mm\")",
                ],
            ),
            (serial(&format!("flange_xyz_mm = [0, 0, 0]\n{DH}")), &["2: flange-of-table Text(\"flange_xyz_mm\")"]),
            (
                serial(&format!("leg = 1\nrod_mm = 3\n{DH}lenght = 3\n")),
                &[
                    "9: unknown-key List([Text(\"`lenght`\")])",
                    "3: key-of-other-model Text(\"rod_mm\")",
                    "2: key-of-other-model Text(\"leg\")",
                ],
            ),
            (
                errors("model = \"delta\"\nbase_radius_mm = 200\nplatform_radius_mm = 50\nrod_mm = 0\n"),
                &["key-missing Text(\"upper_arm_mm\")"],
            ),
            (
                errors("model = \"delta_linear\"\nbase_radius_mm = 2\nplatform_radius_mm = 5\nrod_mm = 0\n"),
                &["4: key-not-positive Text(\"rod_mm\")"],
            ),
            (errors("model = \"hexapod\"\nhome_xyz_mm = [0, 0, 1]\n"), &["leg-count"]),
            (
                errors("model = \"five_bar\"\n[reach]\ntheta1_deg = 3\n"),
                &["3: value-of-other-kind Text(\"theta1_deg\")"],
            ),
        ] {
            let text = found.join("\n");
            assert!(found.len() >= expected.len(), "{text}");
            assert!(found.iter().zip(expected).all(|(found, expected)| found.starts_with(expected)), "{text}");
        }
    }
}
