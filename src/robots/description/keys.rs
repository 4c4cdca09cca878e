//! Description of a robot by keys. Each model declares its keys and reads their values in one
//! place, independently of the file format.

use crate::{Faults, Quantity, Robot, Tree};
use std::collections::BTreeMap;
use std::fmt::Debug;
use std::sync::Arc;

/// A key in the description of a robot.
#[derive(Clone, Debug)]
pub struct Key {
    /// Name, without unit.
    pub name: &'static str,
    /// Meaning, for a reference of all keys.
    pub meaning: &'static str,
    /// Quantity of the numbers; a ratio has no unit.
    pub quantity: Quantity,
    /// `true` if the value may be given in a second unit: metres or radians.
    pub two_units: bool,
    /// `true` if the robot cannot be built without a readable value.
    pub essential: bool,
    /// Shape of the value.
    pub shape: Shape,
    /// Treatment of a missing value.
    pub absence: Absence,
}

/// Shape of a value.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A number.
    Number,
    /// Two numbers: smallest and largest value of a range.
    Range,
    /// Three numbers.
    Triple,
    /// `true` or `false`.
    Flag,
    /// A word.
    Text,
    /// One of several words, each with its meaning; the first is the default.
    Choice(Vec<(&'static str, &'static str)>),
    /// References to joints.
    Joints,
    /// Pairs of references to joints.
    JointPairs,
    /// List of words.
    Words,
    /// Tree of links and joints.
    Tree,
    /// A table with these keys.
    Table(Vec<Key>),
    /// List of tables with these keys, and the meaning of each table.
    Tables(&'static str, Vec<Key>),
}

/// Treatment of a missing value.
#[derive(Clone, Debug)]
pub enum Absence {
    /// A missing value is an error.
    Error,
    /// A missing value is allowed.
    Nothing,
    /// Defaults to an empty list or table.
    Empty,
    /// Default value (mm, deg or 1).
    Default(Value),
}

/// A value, with lengths in mm and angles in rad.
#[derive(Clone, Debug)]
pub enum Value {
    /// Numbers of a [`Shape::Number`], [`Shape::Range`] or [`Shape::Triple`].
    Numbers(Vec<f64>),
    /// A [`Shape::Flag`].
    Flag(bool),
    /// A [`Shape::Text`].
    Text(String),
    /// A [`Shape::Choice`], by its index.
    Choice(usize),
    /// A [`Shape::Joints`].
    Joints(Vec<JointRef>),
    /// A [`Shape::JointPairs`].
    JointPairs(Vec<(JointRef, JointRef)>),
    /// A [`Shape::Words`].
    Words(Vec<String>),
    /// A [`Shape::Tree`].
    Tree(Arc<Tree>),
    /// A [`Shape::Table`].
    Table(Values),
    /// A [`Shape::Tables`].
    Tables(Vec<Values>),
    /// A value that is given in both units.
    Twice,
}

/// Values by key name.
pub type Values = BTreeMap<&'static str, Value>;

/// Reference to a joint, by number or name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JointRef {
    /// Number, from 1.
    Number(usize),
    /// Name.
    Name(String),
}

impl Key {
    /// Creates a key of a dimensionless value.
    pub(crate) fn plain(name: &'static str, meaning: &'static str) -> Self {
        let (quantity, absence) = (Quantity::Ratio, Absence::Error);
        Self { name, meaning, quantity, two_units: false, essential: false, shape: Shape::Number, absence }
    }

    /// Creates a key of a length.
    pub(crate) fn length(name: &'static str, meaning: &'static str) -> Self {
        Self { quantity: Quantity::Length, ..Self::plain(name, meaning) }
    }

    /// Creates a key of an angle.
    pub(crate) fn angle(name: &'static str, meaning: &'static str) -> Self {
        Self { quantity: Quantity::Angle, ..Self::plain(name, meaning) }
    }

    /// Marks the key as essential.
    pub(crate) fn essential(self) -> Self {
        Self { essential: true, ..self }
    }
}

impl Value {
    /// Converts the numbers of a value from mm and deg to mm and rad.
    pub fn inward(self, quantity: Quantity) -> Self {
        match self {
            Self::Numbers(numbers) => Self::Numbers(numbers.into_iter().map(|v| quantity.inward(v)).collect()),
            other => other,
        }
    }
}

/// Type that a value can be converted to.
pub(crate) trait Setting: Default {
    const SHAPE: Shape;
    fn from_value(value: &Value) -> Option<Self>;
    fn value(self) -> Value;
}

macro_rules! setting {
    ($type:ty, $shape:ident, $value:ident) => {
        impl Setting for $type {
            const SHAPE: Shape = Shape::$shape;
            fn from_value(value: &Value) -> Option<Self> {
                if let Value::$value(value) = value { value.clone().try_into().ok() } else { None }
            }
            fn value(self) -> Value {
                Value::$value(self.into())
            }
        }
    };
}
setting!([f64; 2], Range, Numbers);
setting!([f64; 3], Triple, Numbers);
setting!(bool, Flag, Flag);
setting!(String, Text, Text);
setting!(Vec<JointRef>, Joints, Joints);
setting!(Vec<(JointRef, JointRef)>, JointPairs, JointPairs);
setting!(Vec<String>, Words, Words);
setting!(Arc<Tree>, Tree, Tree);

impl Setting for f64 {
    const SHAPE: Shape = Shape::Number;
    fn from_value(value: &Value) -> Option<Self> {
        <[f64; 1]>::try_from(if let Value::Numbers(numbers) = value { &numbers[..] } else { &[] }).ok().map(|[v]| v)
    }
    fn value(self) -> Value {
        Value::Numbers(vec![self])
    }
}

/// Value of a key that may be given in either of two units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Stated<T> {
    #[default]
    Missing,
    Once(T),
    Twice,
}

impl<T> Stated<T> {
    pub fn is_missing(&self) -> bool {
        matches!(self, Self::Missing)
    }
}

/// Reads the values of a description and records the requested keys.
#[derive(Debug, Default)]
pub(crate) struct Reader<'v> {
    values: Option<&'v Values>,
    keys: Vec<Key>,
}

impl<'v> Reader<'v> {
    /// Keys that `read` requests.
    pub fn keys<T>(read: fn(&mut Self) -> T) -> Vec<Key> {
        let mut reader = Self::default();
        read(&mut reader);
        reader.keys
    }

    /// Reads values with `read`.
    pub fn read<T>(values: &'v Values, read: fn(&mut Self) -> T) -> T {
        read(&mut Self { values: Some(values), keys: Vec::new() })
    }

    fn value(&mut self, key: Key) -> Option<&'v Value> {
        let name = key.name;
        self.keys.push(key);
        self.values?.get(name)
    }

    fn get<T: Setting>(&mut self, key: Key, absence: Absence) -> Option<T> {
        self.value(Key { shape: T::SHAPE, absence, ..key }).and_then(T::from_value)
    }

    /// Reads a mandatory value.
    pub fn required<T: Setting>(&mut self, key: Key) -> T {
        self.get(key.essential(), Absence::Error).unwrap_or_default()
    }

    /// Reads an optional value.
    pub fn optional<T: Setting>(&mut self, key: Key) -> Option<T> {
        self.get(key, Absence::Nothing)
    }

    /// Reads a value with a default (mm, deg or 1).
    pub fn or<T: Setting>(&mut self, key: Key, default: T) -> T {
        let default = default.value();
        let quantity = key.quantity;
        let stated = self.get(key, Absence::Default(default.clone()));
        stated.or_else(|| T::from_value(&default.inward(quantity))).unwrap_or_default()
    }

    /// Reads a value that may be given in either of two units.
    pub fn in_two_units<T: Setting>(&mut self, key: Key) -> Stated<T> {
        let key = Key { shape: T::SHAPE, absence: Absence::Nothing, two_units: true, ..key };
        match self.value(key) {
            Some(Value::Twice) => Stated::Twice,
            value => value.and_then(T::from_value).map_or(Stated::Missing, Stated::Once),
        }
    }

    /// Reads one of several named values; the first is the default.
    pub fn choice<T: Copy, const N: usize>(&mut self, key: Key, choices: [(&'static str, &'static str, T); N]) -> T {
        let shape = Shape::Choice(choices.iter().map(|(name, meaning, _)| (*name, *meaning)).collect());
        let chosen = self.value(Key { shape, absence: Absence::Default(Value::Choice(0)), ..key });
        let index = if let Some(Value::Choice(index)) = chosen { *index } else { 0 };
        choices.get(index).unwrap_or(&choices[0]).2
    }

    /// Reads a table.
    pub fn table<T>(&mut self, key: Key, read: fn(&mut Reader<'v>) -> T) -> T {
        let shape = Shape::Table(Reader::keys(read));
        let value = self.value(Key { shape, absence: Absence::Empty, ..key });
        let values = if let Some(Value::Table(values)) = value { Some(values) } else { None };
        read(&mut Reader { values, keys: Vec::new() })
    }

    /// Reads several tables; `each` is the meaning of one of them.
    pub fn tables<T>(&mut self, key: Key, each: &'static str, read: fn(&mut Reader<'v>) -> T) -> Vec<T> {
        let shape = Shape::Tables(each, Reader::keys(read));
        let value = self.value(Key { shape, absence: Absence::Empty, ..key.essential() });
        let all = if let Some(Value::Tables(all)) = value { &all[..] } else { &[] };
        all.iter().map(|values| read(&mut Reader { values: Some(values), keys: Vec::new() })).collect()
    }
}

/// Builds a robot from values and targets.
type Build = fn(&Values, &[String]) -> Result<Box<dyn Robot>, Faults>;

/// A kinematic model.
#[derive(Debug)]
pub struct Model {
    /// Short name: `prexyt`, `five_bar`, `serial` ...
    pub name: &'static str,
    /// `true` if the keys give the geometry, so that nominal parameters are optional.
    pub states_geometry: bool,
    /// `true` if errors are about the centre of a platform.
    pub has_platform: bool,
    keys: fn() -> Vec<Key>,
    build: Build,
}

impl Model {
    /// Creates a model whose description is `D`.
    pub(crate) const fn new<D: Description>(name: &'static str) -> Self {
        Self {
            name,
            states_geometry: D::STATES_GEOMETRY,
            has_platform: D::HAS_PLATFORM,
            keys: || Reader::keys(D::read),
            build: |values, targets| Reader::read(values, D::read).build(targets),
        }
    }

    /// Keys of the description.
    pub fn keys(&self) -> Vec<Key> {
        (self.keys)()
    }

    /// Builds a robot from values; `targets` applies if the model has no targets of its own.
    pub fn build(&self, values: &Values, targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        (self.build)(values, targets)
    }
}

/// Description of a robot of one model.
pub(crate) trait Description: Sized {
    /// `true` if the description gives the geometry, so that nominal parameters are optional.
    const STATES_GEOMETRY: bool = true;
    /// `true` if errors are about the centre of a platform.
    const HAS_PLATFORM: bool = false;

    /// Reads the description.
    fn read(keys: &mut Reader) -> Self;

    /// Builds the robot; `targets` applies if the model has no targets of its own.
    fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>, Faults>;
}
