//! A dialect as the campaign states it.

use super::column::ColumnAt;
use super::columns::{Columns, Role};
use super::dialect::{Decimal, Dialect};
use super::text::{Header, Missing};
use std::fmt;

/// Names in quotes between brackets.
fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    format!("[{}]", names.map(quoted).collect::<Vec<_>>().join(", "))
}

/// Text as TOML reads it.
fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

fn column(column: &ColumnAt) -> String {
    match column {
        ColumnAt::Name(name) => quoted(name),
        ColumnAt::Number(number) => number.to_string(),
    }
}

fn columns(columns: &Columns) -> String {
    match columns {
        Columns::InOrder(roles) => list(roles.iter().map(|r| r.name())),
        Columns::Named(named) => {
            let mut keys: Vec<(Role, Vec<String>)> = Vec::new();
            for (role, stated) in named {
                match keys.iter_mut().find(|(known, _)| known == role) {
                    Some((_, of)) => of.push(column(stated)),
                    None => keys.push((*role, vec![column(stated)])),
                }
            }
            let entry = |(role, of): (Role, Vec<String>)| match &of[..] {
                [one] => format!("{} = {one}", role.name()),
                more => format!("{} = [{}]", role.name(), more.join(", ")),
            };
            format!("{{ {} }}", keys.into_iter().map(entry).collect::<Vec<_>>().join(", "))
        }
    }
}

/// As TOML: `{ delimiter = ";", decimal = ",", columns = ["label", "x", "y", "z"] }`. What has its default is left out,
/// but for the decimal mark.
impl fmt::Display for Dialect {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut keys: Vec<(&str, String)> = Vec::new();
        if let Some(delimiter) = self.delimiter {
            keys.push(("delimiter", quoted(delimiter.name())));
        }
        if !self.widths.is_empty() {
            let widths: Vec<String> = self.widths.iter().map(usize::to_string).collect();
            keys.push(("widths", format!("[{}]", widths.join(", "))));
        }
        if let Some(sheet) = &self.sheet {
            keys.push(("sheet", quoted(sheet)));
        }
        if self.sheet.is_none() || self.decimal != Decimal::default() {
            keys.push(("decimal", quoted(self.decimal.name())));
        }
        if let Some(thousands) = self.thousands {
            keys.push(("thousands", quoted(thousands.name())));
        }
        match &self.header {
            Header::Rows(0) => {}
            Header::Rows(rows) => keys.push(("header", rows.to_string())),
            Header::Words(words) => keys.push(("header", list(words.iter().map(String::as_str)))),
        }
        if let Some(comment) = &self.comment {
            keys.push(("comment", quoted(comment)));
        }
        keys.push(("columns", columns(&self.columns)));
        if !self.types.is_empty() {
            let types =
                self.types.iter().map(|(name, of)| format!("{} = {}", quoted(name), list(of.iter().map(|r| r.name()))));
            keys.push(("types", format!("{{ {} }}", types.collect::<Vec<_>>().join(", "))));
        }
        if let Some(unit) = self.angle_unit {
            keys.push(("angle_unit", quoted(unit.name())));
        }
        if let Some(coordinates) = self.coordinates {
            keys.push(("coordinates", quoted(coordinates.name())));
        }
        if self.missing != Missing::default() {
            keys.push(("missing", list(self.missing.markers().iter().map(String::as_str))));
        }
        if let Some(end) = &self.end {
            keys.push(("end", quoted(end)));
        }
        let keys: Vec<String> = keys.into_iter().map(|(key, value)| format!("{key} = {value}")).collect();
        write!(f, "{{ {} }}", keys.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(serde::Deserialize)]
    struct Stated {
        format: Dialect,
    }

    fn read(text: &str) -> Dialect {
        toml::from_str::<Stated>(&format!("format = {text}\n")).unwrap().format
    }

    #[test]
    fn a_printed_dialect_reads_as_itself() {
        for preset in ["xyz", "xyzijk", "name-xyz-csv", "tracker-semicolon", "leica-emscon", "sdss-plate"] {
            let dialect = *crate::import::Format::named(preset).unwrap().dialect;
            assert_eq!(read(&dialect.to_string()), dialect, "{dialect}");
            assert!(dialect.check().is_empty(), "{preset}: {:?}", dialect.check());
        }
        let text = "{ sheet = 'A \"1\"', decimal = \",\", thousands = \" \", header = [\"X\", \"Y\"], comment = \"//\", \
                    columns = { label = [\"g\", 2], x = 3, y = \"Y\" }, coordinates = \"cartesian\", missing = [], end = \"END\" }";
        assert_eq!(read(text).to_string(), text);
        let text = "{ widths = [8, 10], decimal = \".\", columns = [\"azimuth\", \"elevation\", \"distance\"], angle_unit = \"gon\" }";
        assert_eq!(read(text).to_string(), text);
    }
}
