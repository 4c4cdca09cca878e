//! Tables that a campaign names: a file, or files with the form of their text.

use etalon_base::phrase;
use etalon_tables::TableLayout;
use schemars::JsonSchema;
use serde::de::{self, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;
use toml::Spanned;

/// A data table. The keys below describe how its file is written.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields, transform = etalon_tables::schema::accept_topic)]
pub struct TableKeys {
    /// File of the table, or several files whose rows follow each other.
    pub file: TableFiles,
    /// Form and columns.
    #[serde(flatten)]
    pub layout: TableLayout,
}

/// Files of a table.
#[derive(Clone, Debug)]
pub struct TableFiles(Vec<Spanned<String>>);

etalon_base::schema_by_hand!(TableFiles, _ => {
    let list = schemars::json_schema!({ "type": "array", "items": { "type": "string" }, "minItems": 1 });
    schemars::json_schema!({ "anyOf": [{ "type": "string" }, list] })
});

impl<'de> Deserialize<'de> for TableFiles {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        enum OneOrMore {
            One(String),
            More(Vec<Spanned<String>>),
        }
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = OneOrMore;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("the name of a file, or a list of them")
            }
            fn visit_str<E: de::Error>(self, file: &str) -> Result<OneOrMore, E> {
                Ok(OneOrMore::One(file.to_owned()))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<OneOrMore, A::Error> {
                Ok(OneOrMore::More(Vec::deserialize(de::value::SeqAccessDeserializer::new(seq))?))
            }
        }
        impl<'de> Deserialize<'de> for OneOrMore {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(Any)
            }
        }
        let stated = Spanned::<OneOrMore>::deserialize(deserializer)?;
        let span = stated.span();
        match stated.into_inner() {
            OneOrMore::One(file) => Ok(Self(vec![Spanned::new(span, file)])),
            OneOrMore::More(files) if files.is_empty() => Err(de::Error::custom(phrase!("no-file-listed"))),
            OneOrMore::More(files) => Ok(Self(files)),
        }
    }
}

/// A table: the name of its file, or a table of [`TableKeys`].
#[derive(Clone, Debug)]
pub enum TableDefinition {
    /// A file in the form that its section gives, or that etalon writes.
    File(Spanned<String>),
    /// A form of its own.
    Keys(Box<TableKeys>),
}

impl TableDefinition {
    /// Files, whose rows follow each other; at least one.
    pub fn files(&self) -> &[Spanned<String>] {
        match self {
            Self::File(file) => std::slice::from_ref(file),
            Self::Keys(keys) => &keys.file.0,
        }
    }

    /// The first file, at which messages about the table are placed.
    pub fn first(&self) -> &Spanned<String> {
        &self.files()[0]
    }

    /// `true` if every file has a name.
    pub fn is_named(&self) -> bool {
        self.files().iter().all(|file| !file.get_ref().is_empty())
    }

    /// Keys of the form; `None` if the file alone is given.
    pub fn keys(&self) -> Option<&TableKeys> {
        match self {
            Self::File(_) => None,
            Self::Keys(keys) => Some(keys),
        }
    }
}

etalon_base::schema_by_hand!(TableDefinition, generator => schemars::json_schema!({ "anyOf": [{ "type": "string" }, generator.subschema_for::<TableKeys>()] }));

impl<'de> Deserialize<'de> for TableDefinition {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        enum TextOrKeys {
            Text(String),
            Keys(Box<TableKeys>),
        }
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = TextOrKeys;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("the name of a file, or { file = .., delimiter = .., columns = {..} }")
            }
            fn visit_str<E: de::Error>(self, file: &str) -> Result<TextOrKeys, E> {
                Ok(TextOrKeys::Text(file.to_owned()))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<TextOrKeys, A::Error> {
                let keys = TableKeys::deserialize(de::value::MapAccessDeserializer::new(map))?;
                Ok(TextOrKeys::Keys(Box::new(keys)))
            }
        }
        impl<'de> Deserialize<'de> for TextOrKeys {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(Any)
            }
        }
        let stated = Spanned::<TextOrKeys>::deserialize(deserializer)?;
        let span = stated.span();
        Ok(match stated.into_inner() {
            TextOrKeys::Text(file) => Self::File(Spanned::new(span, file)),
            TextOrKeys::Keys(keys) => Self::Keys(keys),
        })
    }
}
