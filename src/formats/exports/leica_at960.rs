//! Table exports of Leica AT960 and AT930: coordinates, expanded uncertainties and, with a probe of
//! six degrees of freedom, a quaternion.

use super::Recognised;
use super::delimited::NamedDialect;
use crate::dialect::{ColumnRole, Columns, Dialect};
use etalon_base::phrase;
use etalon_tables::{ColumnSource, Delimiter, Form, Header};

/// Columns by name; `Q0` is the scalar. The uncertainties have a level of confidence of 95 % (k =
/// 2).
pub(super) const LEICA_AT960: NamedDialect = NamedDialect {
    name: "leica-at960",
    recognise: |text| {
        let mark = header(text).is_some();
        let what = phrase!("is-leica-at960");
        Recognised::by(mark, 0.9, what).map(|found| Recognised { unit: Some("mm"), ..found })
    },
    dialect: || {
        let named = |role: ColumnRole, name: &str| (role, ColumnSource::Heading(name.to_owned()));
        let columns = vec![
            named(ColumnRole::X, "X  [mm]"),
            named(ColumnRole::Y, "Y  [mm]"),
            named(ColumnRole::Z, "Z  [mm]"),
            named(ColumnRole::U95x, "U(95) X  [mm]"),
            named(ColumnRole::U95y, "U(95) Y  [mm]"),
            named(ColumnRole::U95z, "U(95) Z  [mm]"),
            named(ColumnRole::Qw, "Q0"),
            named(ColumnRole::Qx, "Q1"),
            named(ColumnRole::Qy, "Q2"),
            named(ColumnRole::Qz, "Q3"),
        ];
        Dialect {
            form: Form {
                header: Some(Header::Words(vec!["U(95) X".to_owned(), "Q0".to_owned()])),
                ..Form::delimited(Delimiter::Comma)
            },
            columns: Columns::Named(columns),
            coverage_factor: Some(2.0),
            ..Dialect::default()
        }
    },
};

/// Line that names exactly these columns: a table with names or times is read by its own columns.
fn header(text: &str) -> Option<&str> {
    let names =
        ["X  [mm]", "Y  [mm]", "Z  [mm]", "U(95) X  [mm]", "U(95) Y  [mm]", "U(95) Z  [mm]", "Q0", "Q1", "Q2", "Q3"];
    let all = |line: &&str| {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        names.iter().all(|name| fields.contains(name))
            && fields.iter().all(|field| field.is_empty() || names.contains(field))
    };
    text.lines().take(40).find(all)
}
