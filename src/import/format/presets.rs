//! Dialects of known software by name.

use super::column::ColumnAt;
use super::columns::{Columns, Role};
use super::dialect::{Delimiter, Dialect};
use super::text::{AngleUnit, Header};
use std::collections::BTreeMap;

/// Names of dialects.
pub const PRESETS: [&str; 6] = ["xyz", "xyzijk", "name-xyz-csv", "tracker-semicolon", "leica-emscon", "sdss-plate"];

impl Dialect {
    /// The dialect of this name.
    pub fn preset(name: &str) -> Option<Self> {
        use Role::*;
        let of = |delimiter, columns: &[Role]| Self {
            delimiter: Some(delimiter),
            columns: columns.to_vec().into(),
            ..Self::default()
        };
        match name {
            // numpy.savetxt and most viewers of point clouds
            "xyz" => Some(of(Delimiter::Blank, &[X, Y, Z])),
            "xyzijk" => Some(of(Delimiter::Blank, &[X, Y, Z, I, J, K])),
            "name-xyz-csv" => Some(of(Delimiter::Comma, &[Label, X, Y, Z])),
            // trackers' lists of stationary points, whose further fields may be empty
            "tracker-semicolon" => Some(of(Delimiter::Semicolon, &[Label, X, Y, Z])),
            "leica-emscon" => Some(leica_emscon()),
            "sdss-plate" => Some(Self {
                widths: vec![10, 10, 10, 10, 10, 10, 8, 8, 8],
                columns: vec![X, Y].into(),
                header: Header::Words(vec!["Meas X".to_owned(), "Nom X".to_owned()]),
                ..Self::default()
            }),
            _ => None,
        }
    }
}

/// Stationary measurements through Leica's emScon interface, whose rows say their coordinate type: 0 is right-handed
/// Cartesian, 7 spherical counter-clockwise (horizontal angle, zenith angle, distance), angles in rad.
fn leica_emscon() -> Dialect {
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
