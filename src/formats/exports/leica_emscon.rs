//! Lists of stationary points measured through Leica's emScon interface.

use super::Recognised;
use super::delimited::NamedDialect;
use crate::dialect::{AngleUnit, ColumnRole, Columns, Dialect};
use etalon_base::phrase;
use etalon_tables::{ColumnSource, Delimiter, Form, Header};
use std::collections::BTreeMap;

pub(super) const LEICA_EMSCON: NamedDialect = NamedDialect {
    name: "leica-emscon",
    recognise: |text| {
        let header = |line: &str| line.starts_with("coordsystype,") && line.contains(",val1,val2,val3,");
        let what = phrase!("is-leica-emscon");
        Recognised::by(text.lines().next().is_some_and(header), 1.0, what)
    },
    dialect,
};

/// Rows state their coordinate type: 0 is right-handed Cartesian, 7 spherical counter-clockwise
/// (horizontal angle, zenith angle, distance), angles in rad.
fn dialect() -> Dialect {
    let names = [
        (ColumnRole::Label, "point_name"),
        (ColumnRole::C1, "val1"),
        (ColumnRole::C2, "val2"),
        (ColumnRole::C3, "val3"),
        (ColumnRole::Type, "coordsystype"),
        (ColumnRole::U1, "std1"),
        (ColumnRole::U2, "std2"),
        (ColumnRole::U3, "std3"),
    ];
    Dialect {
        form: Form { header: Some(Header::Rows(1)), ..Form::delimited(Delimiter::Comma) },
        columns: Columns::Named(names.map(|(role, name)| (role, ColumnSource::Heading(name.to_owned()))).to_vec()),
        types: BTreeMap::from([
            ("0".to_owned(), vec![ColumnRole::X, ColumnRole::Y, ColumnRole::Z]),
            ("7".to_owned(), vec![ColumnRole::Azimuth, ColumnRole::Zenith, ColumnRole::Distance]),
        ]),
        angle_unit: Some(AngleUnit::Rad),
        ..Dialect::default()
    }
}
