//! Tables that a campaign names: a file, or files with the form of their text.

use etalon_base::phrase;
use etalon_formats::TableLayout;
use etalon_formats::dialect::{
    Cells, ColumnSource, Constant, Decimal, Delimiter, Encoding, FromRow, Header, Missing, Thousands,
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use toml::Spanned;

/// Layout of a table by the keys of its form, which all definitions of tables have; `$others` are
/// the other members.
macro_rules! form {
    ($keys:expr, $others:expr) => {
        etalon_formats::TableLayout {
            delimiter: $keys.delimiter.unwrap_or(etalon_formats::dialect::Delimiter::Comma),
            decimal: $keys.decimal.unwrap_or_default(),
            thousands: $keys.thousands,
            header: $keys.header.clone(),
            comment: $keys.comment.clone(),
            missing: $keys.missing.clone(),
            columns: $keys.columns.clone(),
            ..$others
        }
    };
}
pub(super) use form;

/// A table with the form of its text; all tables state it by these keys.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = etalon_formats::dialect::accept_topic)]
pub struct TableKeys {
    /// File of the table, or several files whose rows follow each other.
    pub file: TableFiles,
    /// Delimiter of the columns.
    #[schemars(extend("default" = ","))]
    pub delimiter: Option<Delimiter>,
    /// Decimal mark.
    #[schemars(extend("default" = "."))]
    pub decimal: Option<Decimal>,
    /// Character encoding, if no byte-order mark states it.
    #[schemars(extend("default" = "utf-8"))]
    pub encoding: Option<Encoding>,
    /// Sheet of a workbook that contains the table, or as `topic` the topic of a recording (MCAP);
    /// delimiter, decimal mark and encoding do not apply.
    #[serde(alias = "topic")]
    pub sheet: Option<String>,
    /// Mark between groups of three digits.
    pub thousands: Option<Thousands>,
    /// Rows before the data; the last one names the columns: a number, `false` for none, or words
    /// of the row.
    #[serde(default = "one_row")]
    #[schemars(extend("default" = 1))]
    pub header: Header,
    /// Beginning of lines that are skipped.
    pub comment: Option<String>,
    /// Cells that mean "not measured", beside empty ones.
    #[serde(default)]
    pub missing: Missing,
    /// Source of each column that has another name in the file: a heading, a number from 1, or an
    /// expression (`x_t - x_dif`).
    #[serde(default)]
    pub columns: BTreeMap<String, ColumnSource>,
    /// Columns with the same value in all rows, e.g. `cycle = 1`.
    #[serde(default)]
    pub constants: BTreeMap<String, Constant>,
    /// Rows that are read: those with one of these cells in each of these columns.
    #[serde(default)]
    pub only: BTreeMap<String, Cells>,
    /// Rows that are left out: those with one of these cells in one of these columns.
    #[serde(default)]
    pub without: BTreeMap<String, Cells>,
    /// `row`: the number of the data row is the number of the pose, for a table without such a
    /// column; `row + 100` adds an offset.
    pub pose: Option<FromRow>,
}

/// Default of `header`.
pub(super) fn one_row() -> Header {
    Header::Rows(1)
}

/// Files of a table.
#[derive(Clone, Debug)]
pub struct TableFiles(Vec<Spanned<String>>);

impl JsonSchema for TableFiles {
    fn schema_name() -> Cow<'static, str> {
        "TableFiles".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let list = json_schema!({ "type": "array", "items": { "type": "string" }, "minItems": 1 });
        json_schema!({ "anyOf": [{ "type": "string" }, list] })
    }
}

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
    /// A file in the form that its section states, or that etalon writes.
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

    /// Keys of the form; `None` if the file alone is stated.
    pub fn keys(&self) -> Option<&TableKeys> {
        match self {
            Self::File(_) => None,
            Self::Keys(keys) => Some(keys),
        }
    }
}

impl TableKeys {
    /// Layout of the table, whose columns may have any name.
    pub fn layout(&self) -> TableLayout {
        TableLayout {
            constants: self.constants.clone(),
            only: self.only.clone(),
            without: self.without.clone(),
            pose: self.pose,
            ..form!(self, TableLayout::with_any_columns())
        }
    }

    /// Key beside `sheet` that does not apply to a workbook.
    pub fn meaningless_beside_sheet(&self) -> Option<&'static str> {
        meaningless_beside_sheet(self.sheet.as_deref(), (self.delimiter, self.decimal, self.encoding))
    }
}

/// Key of a text that is stated beside `sheet`.
pub(super) fn meaningless_beside_sheet(
    sheet: Option<&str>,
    (delimiter, decimal, encoding): (Option<Delimiter>, Option<Decimal>, Option<Encoding>),
) -> Option<&'static str> {
    let text = [("delimiter", delimiter.is_some()), ("decimal", decimal.is_some()), ("encoding", encoding.is_some())];
    text.into_iter().find(|(_, stated)| sheet.is_some() && *stated).map(|(key, _)| key)
}

impl JsonSchema for TableDefinition {
    fn schema_name() -> Cow<'static, str> {
        "TableDefinition".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "type": "string" }, generator.subschema_for::<TableKeys>()] })
    }
}

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
