//! Description of a robot: each model declares the keys of which it is built and reads their values in one place,
//! whatever file they come from.

use super::{Faults, Quantity, Robot, Tree};
use std::collections::BTreeMap;
use std::fmt::Debug;
use std::sync::Arc;

/// A value that a robot's description states.
#[derive(Clone, Debug)]
pub struct Key {
    /// Name, without unit.
    pub name: &'static str,
    /// Meaning, for a reference of all keys.
    pub meaning: &'static str,
    /// Quantity of its numbers; a ratio has no unit.
    pub quantity: Quantity,
    /// `true` if it may be stated in a second unit: metres or radians.
    pub two_units: bool,
    /// `true` if the robot is meaningless where the value is unreadable.
    pub essential: bool,
    /// Shape of the value.
    pub shape: Shape,
    /// What stands for a missing value.
    pub absence: Absence,
}

/// Shape of a value.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A number.
    Number,
    /// Two numbers: the smallest and the largest of a range.
    Range,
    /// Three numbers.
    Triple,
    /// `true` or `false`.
    Flag,
    /// A word.
    Text,
    /// One of these words, each with its meaning; the first stands for a missing value.
    Choice(Vec<(&'static str, &'static str)>),
    /// References to joints.
    Joints,
    /// Pairs of references to joints.
    JointPairs,
    /// Links and joints of a tree.
    Tree,
    /// A table with these keys.
    Table(Vec<Key>),
    /// Tables with these keys, one behind the other, with the meaning of each.
    Tables(&'static str, Vec<Key>),
}

/// What stands for a missing value.
#[derive(Clone, Debug)]
pub enum Absence {
    /// An error.
    Error,
    /// Nothing.
    Nothing,
    /// An empty list or table.
    Empty,
    /// A value, in mm, deg or 1.
    Default(Value),
}

/// A value, lengths in mm and angles in rad.
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
    /// A [`Shape::Tree`].
    Tree(Arc<Tree>),
    /// A [`Shape::Table`].
    Table(Values),
    /// A [`Shape::Tables`].
    Tables(Vec<Values>),
    /// Stated in both units.
    Twice,
}

/// Values by the names of their keys.
pub type Values = BTreeMap<&'static str, Value>;

/// A joint by its number, from 1, or its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum JointRef {
    /// From 1.
    Number(usize),
    /// As the joint is called.
    Name(String),
}

impl Key {
    /// A key of a value without unit.
    pub(super) fn plain(name: &'static str, meaning: &'static str) -> Self {
        let (quantity, absence) = (Quantity::Ratio, Absence::Error);
        Self { name, meaning, quantity, two_units: false, essential: false, shape: Shape::Number, absence }
    }

    /// A key of a length.
    pub(super) fn length(name: &'static str, meaning: &'static str) -> Self {
        Self { quantity: Quantity::Length, ..Self::plain(name, meaning) }
    }

    /// A key of an angle.
    pub(super) fn angle(name: &'static str, meaning: &'static str) -> Self {
        Self { quantity: Quantity::Angle, ..Self::plain(name, meaning) }
    }

    /// The same key, without whose value the robot is meaningless.
    pub(super) fn essential(self) -> Self {
        Self { essential: true, ..self }
    }
}

impl Value {
    /// The value with its numbers in mm and rad, from mm and deg.
    pub fn inward(self, quantity: Quantity) -> Self {
        match self {
            Self::Numbers(numbers) => Self::Numbers(numbers.into_iter().map(|v| quantity.inward(v)).collect()),
            other => other,
        }
    }
}

/// Type of a value.
pub(super) trait Setting: Default {
    const SHAPE: Shape;
    fn of(value: &Value) -> Option<Self>;
    fn value(self) -> Value;
}

macro_rules! setting {
    ($type:ty, $shape:ident, $value:ident) => {
        impl Setting for $type {
            const SHAPE: Shape = Shape::$shape;
            fn of(value: &Value) -> Option<Self> {
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
setting!(Arc<Tree>, Tree, Tree);

impl Setting for f64 {
    const SHAPE: Shape = Shape::Number;
    fn of(value: &Value) -> Option<Self> {
        <[f64; 1]>::try_from(if let Value::Numbers(numbers) = value { &numbers[..] } else { &[] }).ok().map(|[v]| v)
    }
    fn value(self) -> Value {
        Value::Numbers(vec![self])
    }
}

/// Value of a key that may be stated in two units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Stated<T> {
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

/// Reads the values of a description and notes the keys that it is asked for.
#[derive(Debug, Default)]
pub(super) struct Reader<'v> {
    values: Option<&'v Values>,
    keys: Vec<Key>,
}

impl<'v> Reader<'v> {
    /// The keys that `read` asks for.
    pub fn keys<T>(read: fn(&mut Self) -> T) -> Vec<Key> {
        let mut reader = Self::default();
        read(&mut reader);
        reader.keys
    }

    /// The values that `read` asks for.
    pub fn read<T>(values: &'v Values, read: fn(&mut Self) -> T) -> T {
        read(&mut Self { values: Some(values), keys: Vec::new() })
    }

    fn value(&mut self, key: Key) -> Option<&'v Value> {
        let name = key.name;
        self.keys.push(key);
        self.values?.get(name)
    }

    fn get<T: Setting>(&mut self, key: Key, absence: Absence) -> Option<T> {
        self.value(Key { shape: T::SHAPE, absence, ..key }).and_then(T::of)
    }

    /// A value that must be stated.
    pub fn required<T: Setting>(&mut self, key: Key) -> T {
        self.get(key.essential(), Absence::Error).unwrap_or_default()
    }

    /// A value that may be missing.
    pub fn optional<T: Setting>(&mut self, key: Key) -> Option<T> {
        self.get(key, Absence::Nothing)
    }

    /// A value, or this default in mm, deg or 1.
    pub fn or<T: Setting>(&mut self, key: Key, default: T) -> T {
        let default = default.value();
        let quantity = key.quantity;
        let stated = self.get(key, Absence::Default(default.clone()));
        stated.or_else(|| T::of(&default.inward(quantity))).unwrap_or_default()
    }

    /// A value in one of two units.
    pub fn in_two_units<T: Setting>(&mut self, key: Key) -> Stated<T> {
        let key = Key { shape: T::SHAPE, absence: Absence::Nothing, two_units: true, ..key };
        match self.value(key) {
            Some(Value::Twice) => Stated::Twice,
            value => value.and_then(T::of).map_or(Stated::Missing, Stated::Once),
        }
    }

    /// One of several values, each with its name and meaning; the first where none is stated.
    pub fn choice<T: Copy, const N: usize>(&mut self, key: Key, choices: [(&'static str, &'static str, T); N]) -> T {
        let shape = Shape::Choice(choices.iter().map(|(name, meaning, _)| (*name, *meaning)).collect());
        let chosen = self.value(Key { shape, absence: Absence::Default(Value::Choice(0)), ..key });
        let index = if let Some(Value::Choice(index)) = chosen { *index } else { 0 };
        choices.get(index).unwrap_or(&choices[0]).2
    }

    /// Values of a table.
    pub fn table<T>(&mut self, key: Key, read: fn(&mut Reader<'v>) -> T) -> T {
        let shape = Shape::Table(Reader::keys(read));
        let value = self.value(Key { shape, absence: Absence::Empty, ..key });
        let values = if let Some(Value::Table(values)) = value { Some(values) } else { None };
        read(&mut Reader { values, keys: Vec::new() })
    }

    /// Values of several tables; `each` is the meaning of one of them.
    pub fn tables<T>(&mut self, key: Key, each: &'static str, read: fn(&mut Reader<'v>) -> T) -> Vec<T> {
        let shape = Shape::Tables(each, Reader::keys(read));
        let value = self.value(Key { shape, absence: Absence::Empty, ..key.essential() });
        let all = if let Some(Value::Tables(all)) = value { &all[..] } else { &[] };
        all.iter().map(|values| read(&mut Reader { values: Some(values), keys: Vec::new() })).collect()
    }
}

/// Builds the robot that values describe, with these targets.
type Build = fn(&Values, &[String]) -> Result<Box<dyn Robot>, Faults>;

/// A kinematic model.
#[derive(Debug)]
pub struct Model {
    /// Short name: `prexyt`, `five_bar`, `serial` ...
    pub name: &'static str,
    /// `true` if its keys state the geometry, so that the nominal parameters need not.
    pub states_geometry: bool,
    keys: fn() -> Vec<Key>,
    build: Build,
}

impl Model {
    /// A model that is described by `D`.
    pub(super) const fn new<D: Description>(name: &'static str) -> Self {
        Self {
            name,
            states_geometry: D::STATES_GEOMETRY,
            keys: || Reader::keys(D::read),
            build: |values, targets| Reader::read(values, D::read).build(targets),
        }
    }

    /// The keys of its description.
    pub fn keys(&self) -> Vec<Key> {
        (self.keys)()
    }

    /// The robot that these values describe, with these targets where the model has none of its own.
    pub fn build(&self, values: &Values, targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        (self.build)(values, targets)
    }
}

/// Description of a robot of one model.
pub(super) trait Description: Sized {
    /// `true` if it states the geometry, so that the nominal parameters need not.
    const STATES_GEOMETRY: bool = true;

    /// Reads it.
    fn read(keys: &mut Reader) -> Self;

    /// The robot, with these targets where the model has none of its own.
    fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>, Faults>;
}
