//! Keys of robot.toml that belong to a model: spelling with units, schema, and TOML form.

use etalon_robots::{Absence, JointRef, Key, Quantity, Shape, Value, Values};
use serde::de::{self, DeserializeSeed, EnumAccess, Error as _, MapAccess, SeqAccess, VariantAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value as Json, json};
use std::fmt;
use toml::Spanned;
use toml::de::DeTable;

/// Spellings of a key: its name with each of its units.
pub(crate) fn spellings(key: &Key) -> Vec<String> {
    let units: &[&str] = match key.quantity {
        Quantity::Length => &["mm", "m"],
        Quantity::Angle => &["deg", "rad"],
        Quantity::Ratio => return vec![key.name.to_owned()],
    };
    let count = if key.two_units { 2 } else { 1 };
    units.iter().take(count).map(|unit| format!("{}_{unit}", key.name)).collect()
}

/// Paths of all keys; keys of a table are preceded by its name.
pub(crate) fn paths(keys: &[Key]) -> Vec<Vec<String>> {
    let of = |key: &Key| match &key.shape {
        Shape::Table(keys) => keys.iter().flat_map(spellings).map(|inner| vec![key.name.to_owned(), inner]).collect(),
        _ => spellings(key).into_iter().map(|key| vec![key]).collect::<Vec<_>>(),
    };
    keys.iter().flat_map(of).collect()
}

/// Essential keys, and keys of tables that end up at the top if the header of their table is
/// missing.
pub(crate) fn essential(keys: &[Key]) -> Vec<String> {
    let of = |key: &Key| {
        let mut all = if key.essential { spellings(key) } else { Vec::new() };
        all.extend(essential(table_keys(key)));
        all
    };
    keys.iter().flat_map(of).collect()
}

/// Returns the key with this name, at the top or in a table.
pub(crate) fn named<'k>(keys: &'k [Key], name: &str) -> Option<&'k Key> {
    keys.iter().find_map(|key| if key.name == name { Some(key) } else { named(table_keys(key), name) })
}

/// Keys of a table, or of a list of tables.
fn table_keys(key: &Key) -> &[Key] {
    if let Shape::Table(keys) | Shape::Tables(_, keys) = &key.shape { keys } else { &[] }
}

/// A joint, by number or name.
#[derive(Deserialize)]
#[serde(untagged, expecting = "expected the number of a joint, from 1, or its name")]
enum StatedJoint {
    /// Number, from 1.
    Number(usize),
    /// Name, as at the start of its column.
    Name(String),
}

impl From<StatedJoint> for JointRef {
    fn from(joint: StatedJoint) -> Self {
        match joint {
            StatedJoint::Number(number) => Self::Number(number),
            StatedJoint::Name(name) => Self::Name(name),
        }
    }
}

/// Returns the JSON Schema of a table with these keys.
pub(crate) fn schema(keys: &[Key]) -> Json {
    let mut properties = Map::new();
    for key in keys {
        for (i, spelling) in spellings(key).into_iter().enumerate() {
            let meaning = match (i, key.quantity) {
                (0, _) => key.meaning,
                (_, Quantity::Angle) => "The same in radians.",
                _ => "The same in metres.",
            };
            let mut schema = key_schema(key);
            schema["description"] = meaning.into();
            if let Absence::Default(value) = &key.absence {
                schema["default"] = default_json(value, &key.shape);
            }
            properties.insert(spelling, schema);
        }
    }
    let required = keys.iter().filter(|key| matches!(key.absence, Absence::Error)).flat_map(spellings);
    let required: Vec<String> = required.collect();
    let mut table = json!({ "type": "object", "properties": properties, "additionalProperties": false });
    if !required.is_empty() {
        table["required"] = required.into();
    }
    table
}

fn key_schema(key: &Key) -> Json {
    let number = || json!({ "type": "number", "format": "double" });
    let list = |items: Json| json!({ "type": "array", "items": items });
    let exactly =
        |count: usize, items: Json| json!({ "type": "array", "items": items, "minItems": count, "maxItems": count });
    let joint = || {
        let number = json!({ "description": "Number, from 1.", "type": "integer", "format": "uint", "minimum": 0 });
        let name = json!({ "description": "Name, as at the start of its column.", "type": "string" });
        json!({ "description": "A joint, by number or name.", "anyOf": [number, name] })
    };
    let mut schema = match &key.shape {
        Shape::Number => number(),
        Shape::Range => exactly(2, number()),
        Shape::Triple => exactly(3, number()),
        Shape::Flag => json!({ "type": "boolean" }),
        Shape::Text | Shape::Tree => json!({ "type": "string" }),
        Shape::Words => list(json!({ "type": "string" })),
        Shape::Joints => list(joint()),
        Shape::JointPairs => {
            list(json!({ "type": "array", "prefixItems": [joint(), joint()], "minItems": 2, "maxItems": 2 }))
        }
        Shape::Choice(choices) => {
            let one =
                |(name, meaning): &(&str, &str)| json!({ "description": meaning, "type": "string", "const": name });
            return json!({ "oneOf": choices.iter().map(one).collect::<Vec<_>>() });
        }
        Shape::Table(own) => return self::schema(own),
        Shape::Tables(meaning, own) => {
            let mut each = self::schema(own);
            each["description"] = (*meaning).into();
            return list(each);
        }
    };
    if let Absence::Nothing = key.absence {
        schema["type"] = json!([schema["type"], "null"]);
    }
    schema
}

/// JSON form of a default value.
fn default_json(value: &Value, shape: &Shape) -> Json {
    match (value, shape) {
        (Value::Numbers(numbers), Shape::Number) => numbers.first().copied().into(),
        (Value::Numbers(numbers), _) => numbers.clone().into(),
        (Value::Flag(flag), _) => (*flag).into(),
        (Value::Choice(index), Shape::Choice(choices)) => choices.get(*index).map(|(name, _)| *name).into(),
        _ => json!([]),
    }
}

/// Reads a table with these keys.
pub(crate) fn read(keys: &[Key], table: Spanned<DeTable<'_>>) -> Result<Values, toml::de::Error> {
    TableOf(keys).deserialize(toml::de::Deserializer::from(table))
}

/// Names in serde's notation.
fn alternatives(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match &quoted[..] {
        [one] => one.clone(),
        [one, other] => format!("{one} or {other}"),
        all => format!("one of {}", all.join(", ")),
    }
}

/// Table with these keys.
#[derive(Clone, Copy)]
struct TableOf<'k>(&'k [Key]);

impl<'de> DeserializeSeed<'de> for TableOf<'_> {
    type Value = Values;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Values, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for TableOf<'_> {
    type Value = Values;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a table")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Values, A::Error> {
        let mut values = Values::new();
        while let Some((key, unit)) = map.next_key_seed(KeyOf(self.0))? {
            let value = map.next_value_seed(ValueOf(key, unit))?;
            let stated = values.insert(key.name, value).is_some();
            if stated {
                values.insert(key.name, Value::Twice);
            }
        }
        let mut missing =
            self.0.iter().filter(|key| matches!(key.absence, Absence::Error) && !values.contains_key(key.name));
        match missing.next().map(|key| spellings(key).concat()) {
            Some(spelling) => Err(A::Error::custom(format!("missing field `{spelling}`"))),
            None => Ok(values),
        }
    }
}

/// Key among these, with the index of its unit.
struct KeyOf<'k>(&'k [Key]);

impl<'de, 'k> DeserializeSeed<'de> for KeyOf<'k> {
    type Value = (&'k Key, usize);

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<'k> Visitor<'_> for KeyOf<'k> {
    type Value = (&'k Key, usize);

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a key")
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<Self::Value, E> {
        let find = |key: &'k Key| Some((key, spellings(key).iter().position(|spelling| spelling == name)?));
        self.0.iter().find_map(find).ok_or_else(|| {
            let known: Vec<String> = self.0.iter().flat_map(spellings).collect();
            E::custom(format!("unknown field `{name}`, expected {}", alternatives(&known)))
        })
    }
}

/// Value of a key in one of its units.
struct ValueOf<'k>(&'k Key, usize);

impl ValueOf<'_> {
    fn numbers(&self, stated: &[f64]) -> Value {
        let inward = |&v: &f64| match (self.0.quantity, self.1) {
            (quantity, 0) => quantity.inward(v),
            (Quantity::Length, _) => 1000.0 * v,
            _ => v,
        };
        Value::Numbers(stated.iter().map(inward).collect())
    }
}

impl<'de> DeserializeSeed<'de> for ValueOf<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, d: D) -> Result<Value, D::Error> {
        let pair = |(joint, by): (StatedJoint, StatedJoint)| (joint.into(), by.into());
        Ok(match &self.0.shape {
            Shape::Number => self.numbers(&[f64::deserialize(d)?]),
            Shape::Range => self.numbers(&<[f64; 2]>::deserialize(d)?),
            Shape::Triple => self.numbers(&<[f64; 3]>::deserialize(d)?),
            Shape::Flag => Value::Flag(bool::deserialize(d)?),
            Shape::Text | Shape::Tree => Value::Text(String::deserialize(d)?),
            Shape::Choice(choices) => Value::Choice(d.deserialize_enum("", &[], ChoiceOf(choices))?),
            Shape::Words => Value::Words(Vec::deserialize(d)?),
            Shape::Joints => Value::Joints(Vec::<StatedJoint>::deserialize(d)?.into_iter().map(Into::into).collect()),
            Shape::JointPairs => {
                Value::JointPairs(Vec::<(StatedJoint, StatedJoint)>::deserialize(d)?.into_iter().map(pair).collect())
            }
            Shape::Table(own) => Value::Table(TableOf(own).deserialize(d)?),
            Shape::Tables(_, own) => Value::Tables(d.deserialize_seq(TablesOf(own))?),
        })
    }
}

/// Word among these, by its index.
#[derive(Clone, Copy)]
struct ChoiceOf<'k>(&'k [(&'static str, &'static str)]);

impl<'de> DeserializeSeed<'de> for ChoiceOf<'_> {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<usize, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<'de> Visitor<'de> for ChoiceOf<'_> {
    type Value = usize;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a word")
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<usize, A::Error> {
        let (index, variant) = data.variant_seed(self)?;
        variant.unit_variant().map(|()| index)
    }

    fn visit_str<E: de::Error>(self, word: &str) -> Result<usize, E> {
        self.0.iter().position(|(name, _)| *name == word).ok_or_else(|| {
            let known: Vec<String> = self.0.iter().map(|(name, _)| (*name).to_owned()).collect();
            E::custom(format!("unknown variant `{word}`, expected {}", alternatives(&known)))
        })
    }
}

/// List of tables with these keys.
struct TablesOf<'k>(&'k [Key]);

impl<'de> Visitor<'de> for TablesOf<'_> {
    type Value = Vec<Values>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a sequence")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut tables: A) -> Result<Vec<Values>, A::Error> {
        let mut all = Vec::new();
        while let Some(values) = tables.next_element_seed(TableOf(self.0))? {
            all.push(values);
        }
        Ok(all)
    }
}
