//! Lists of stationary points measured through Leica's emScon interface.

use super::Recognised;
use super::delimited::Named;
use crate::dialect::{AngleUnit, ColumnAt, Columns, Delimiter, Dialect, Header, Role};
use std::collections::BTreeMap;

pub(super) const LEICA_EMSCON: Named = Named {
    name: "leica-emscon",
    recognise: |text| {
        let header = |line: &str| line.starts_with("coordsystype,") && line.contains(",val1,val2,val3,");
        let what = "a list of stationary points measured through Leica's emScon interface, by its header";
        Recognised::by(text.lines().next().is_some_and(header), 1.0, what)
    },
    dialect,
};

/// Rows state their coordinate type: 0 is right-handed Cartesian, 7 spherical counter-clockwise (horizontal angle, zenith
/// angle, distance), angles in rad.
fn dialect() -> Dialect {
    let names = [
        (Role::Label, "point_name"),
        (Role::C1, "val1"),
        (Role::C2, "val2"),
        (Role::C3, "val3"),
        (Role::Type, "coordsystype"),
        (Role::U1, "std1"),
        (Role::U2, "std2"),
        (Role::U3, "std3"),
    ];
    Dialect {
        delimiter: Some(Delimiter::Comma),
        header: Header::Rows(1),
        columns: Columns::Named(names.map(|(role, name)| (role, ColumnAt::Name(name.to_owned()))).to_vec()),
        types: BTreeMap::from([
            ("0".to_owned(), vec![Role::X, Role::Y, Role::Z]),
            ("7".to_owned(), vec![Role::Azimuth, Role::Zenith, Role::Distance]),
        ]),
        angle_unit: Some(AngleUnit::Rad),
        ..Dialect::default()
    }
}
