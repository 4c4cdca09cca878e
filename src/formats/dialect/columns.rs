//! Statements about columns: the role of each column of an export, and the column of each joint of
//! a log.

use etalon_base::phrase;
use etalon_tables::ColumnSource;
use schemars::JsonSchema;
use serde::de::{self, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// Role of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(transform = etalon_tables::schema::accept_aliases)]
pub enum ColumnRole {
    /// Label of the point; several columns are joined by `::`.
    Label,
    /// Name of the target.
    Target,
    /// Name of the pose.
    Pose,
    /// Number of the repeat.
    Cycle,
    /// Coordinate.
    X,
    /// Coordinate.
    Y,
    /// Coordinate.
    Z,
    /// Distance from the z axis.
    Radius,
    /// Angle about the z axis from x, counter-clockwise seen from +z.
    Azimuth,
    /// Angle about the z axis from x, clockwise seen from +z.
    AzimuthClockwise,
    /// Angle from the z axis.
    Zenith,
    /// Angle from the xy plane.
    Elevation,
    /// Distance from the origin.
    Distance,
    /// First coordinate of the type that the column `type` of the row contains.
    C1,
    /// Second coordinate of that type.
    C2,
    /// Third coordinate of that type.
    C3,
    /// Coordinate type of the row: a key of `types`.
    Type,
    /// Standard uncertainty of the first coordinate from the left, in its unit.
    U1,
    /// Standard uncertainty of the second coordinate.
    U2,
    /// Standard uncertainty of the third coordinate.
    U3,
    /// Direction of the surface or probe: x.
    I,
    /// Direction of the surface or probe: y.
    J,
    /// Direction of the surface or probe: z.
    K,
    /// Expanded uncertainty of x in the unit of the file, with `coverage_factor` of the format.
    U95x,
    /// Expanded uncertainty of y.
    U95y,
    /// Expanded uncertainty of z.
    U95z,
    /// Quaternion of the measured body in the frame of the file: scalar.
    Qw,
    /// Quaternion: x.
    Qx,
    /// Quaternion: y.
    Qy,
    /// Quaternion: z.
    Qz,
    /// Rotation vector of the body (deg), or first of three angles in the order of `rotation`.
    RxDeg,
    /// Second number of the rotation (deg).
    RyDeg,
    /// Third number of the rotation (deg).
    RzDeg,
    /// Rotation vector of the body (rad), or first of three angles in the order of `rotation`.
    RxRad,
    /// Second number of the rotation (rad).
    RyRad,
    /// Third number of the rotation (rad).
    RzRad,
    /// Rotation matrix of the body: row 1, column 1.
    R11,
    /// Rotation matrix: row 1, column 2.
    R12,
    /// Rotation matrix: row 1, column 3.
    R13,
    /// Rotation matrix: row 2, column 1.
    R21,
    /// Rotation matrix: row 2, column 2.
    R22,
    /// Rotation matrix: row 2, column 3.
    R23,
    /// Rotation matrix: row 3, column 1.
    R31,
    /// Rotation matrix: row 3, column 2.
    R32,
    /// Rotation matrix: row 3, column 3.
    R33,
    /// Temperature during the measurement (°C).
    TemperatureC,
    /// Mark of deleted rows: rows with `1`, `true`, `yes` or `x` are omitted.
    Deleted,
    /// Date and time of day, such as `11.10.2022 15:06:48.043` or `2022-10-11T15:06:48`.
    Timestamp,
    /// Date, if the time of day is in another column.
    Date,
    /// Time in nanoseconds.
    TimeNs,
    /// Time in microseconds.
    TimeUs,
    /// Time in milliseconds.
    TimeMs,
    /// Time in seconds.
    TimeS,
    /// Column that is not read.
    #[serde(rename = "-", alias = "skip")]
    #[schemars(extend("aliases" = ["skip"]))]
    Skip,
}

impl ColumnRole {
    /// Name in campaign.toml.
    pub fn name(self) -> &'static str {
        match self {
            Self::Label => "label",
            Self::Target => "target",
            Self::Pose => "pose",
            Self::Cycle => "cycle",
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::Radius => "radius",
            Self::Azimuth => "azimuth",
            Self::AzimuthClockwise => "azimuth_clockwise",
            Self::Zenith => "zenith",
            Self::Elevation => "elevation",
            Self::Distance => "distance",
            Self::C1 => "c1",
            Self::C2 => "c2",
            Self::C3 => "c3",
            Self::Type => "type",
            Self::U1 => "u1",
            Self::U2 => "u2",
            Self::U3 => "u3",
            Self::I => "i",
            Self::J => "j",
            Self::K => "k",
            Self::U95x => "u95x",
            Self::U95y => "u95y",
            Self::U95z => "u95z",
            Self::Qw => "qw",
            Self::Qx => "qx",
            Self::Qy => "qy",
            Self::Qz => "qz",
            Self::RxDeg => "rx_deg",
            Self::RyDeg => "ry_deg",
            Self::RzDeg => "rz_deg",
            Self::RxRad => "rx_rad",
            Self::RyRad => "ry_rad",
            Self::RzRad => "rz_rad",
            Self::R11 => "r11",
            Self::R12 => "r12",
            Self::R13 => "r13",
            Self::R21 => "r21",
            Self::R22 => "r22",
            Self::R23 => "r23",
            Self::R31 => "r31",
            Self::R32 => "r32",
            Self::R33 => "r33",
            Self::TemperatureC => "temperature_c",
            Self::Deleted => "deleted",
            Self::Timestamp => "timestamp",
            Self::Date => "date",
            Self::TimeNs => "time_ns",
            Self::TimeUs => "time_us",
            Self::TimeMs => "time_ms",
            Self::TimeS => "time_s",
            Self::Skip => "-",
        }
    }

    /// `true` for a coordinate of a fixed kind.
    pub fn is_coordinate(self) -> bool {
        matches!(self, Self::X | Self::Y | Self::Z | Self::Radius | Self::Distance) || self.is_angle()
    }

    /// `true` for a coordinate that is an angle.
    pub fn is_angle(self) -> bool {
        matches!(self, Self::Azimuth | Self::AzimuthClockwise | Self::Zenith | Self::Elevation)
    }

    /// Columns of each form of an orientation.
    pub const ORIENTATIONS: [&'static [Self]; 4] = [
        &[Self::Qw, Self::Qx, Self::Qy, Self::Qz],
        &[Self::RxDeg, Self::RyDeg, Self::RzDeg],
        &[Self::RxRad, Self::RyRad, Self::RzRad],
        &[Self::R11, Self::R12, Self::R13, Self::R21, Self::R22, Self::R23, Self::R31, Self::R32, Self::R33],
    ];

    /// `true` for a number of an orientation.
    pub fn is_orientation(self) -> bool {
        Self::ORIENTATIONS.iter().any(|form| form.contains(&self))
    }

    /// `true` for an expanded uncertainty.
    pub fn is_expanded(self) -> bool {
        matches!(self, Self::U95x | Self::U95y | Self::U95z)
    }

    /// `true` for a coordinate whose kind each row contains.
    pub fn is_typed(self) -> bool {
        matches!(self, Self::C1 | Self::C2 | Self::C3)
    }

    /// `true` for a standard uncertainty.
    pub fn is_uncertainty(self) -> bool {
        matches!(self, Self::U1 | Self::U2 | Self::U3)
    }
}

/// Roles of the columns of a text.
#[derive(Clone, Debug, PartialEq)]
pub enum Columns {
    /// Roles from the left; a row with more columns is rejected.
    InOrder(Vec<ColumnRole>),
    /// Columns by heading or number; other columns are not read.
    Named(Vec<(ColumnRole, ColumnSource)>),
}

impl Default for Columns {
    fn default() -> Self {
        Self::InOrder(Vec::new())
    }
}

impl From<Vec<ColumnRole>> for Columns {
    fn from(roles: Vec<ColumnRole>) -> Self {
        Self::InOrder(roles)
    }
}

impl Columns {
    /// Returns all given roles, from the left or in the order of their statement.
    pub fn roles(&self) -> Vec<ColumnRole> {
        match self {
            Self::InOrder(roles) => roles.clone(),
            Self::Named(named) => named.iter().map(|(role, _)| *role).collect(),
        }
    }

    /// `true` if a column has this role.
    pub fn contains(&self, role: ColumnRole) -> bool {
        self.roles().contains(&role)
    }
}

etalon_base::schema_by_hand!(Columns, generator => {
    let role = generator.subschema_for::<ColumnRole>();
    let column = schemars::json_schema!({ "anyOf": [{ "type": "string" }, { "type": "integer", "minimum": 1 }] });
    schemars::json_schema!({ "anyOf": [
        { "type": "array", "items": role },
        {
            "type": "object",
            "propertyNames": role,
            "additionalProperties": { "anyOf": [column, { "type": "array", "items": column }] },
        },
    ] })
});

impl<'de> Deserialize<'de> for Columns {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ListOrTable;
        impl<'de> Visitor<'de> for ListOrTable {
            type Value = Columns;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str(
                    "the meaning of each column, [\"label\", \"x\", ..], or { label = \"name in the header\", x = .. }",
                )
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Columns, A::Error> {
                Ok(Columns::InOrder(Vec::deserialize(de::value::SeqAccessDeserializer::new(seq))?))
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Columns, A::Error> {
                let mut named = Vec::new();
                while let Some(role) = map.next_key::<ColumnRole>()? {
                    let OneOrMore(columns) = map.next_value()?;
                    named.extend(columns.into_iter().map(|column| (role, column)));
                }
                // a table of TOML has no order
                named.sort_by_key(|(role, _): &(ColumnRole, ColumnSource)| *role as usize);
                Ok(Columns::Named(named))
            }
        }
        deserializer.deserialize_any(ListOrTable)
    }
}

/// One column, or several columns that form one label.
struct OneOrMore(Vec<ColumnSource>);

impl<'de> Deserialize<'de> for OneOrMore {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = OneOrMore;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("the name of a column, or its number from 1, or a list of them")
            }
            fn visit_str<E: de::Error>(self, name: &str) -> Result<OneOrMore, E> {
                Ok(OneOrMore(vec![ColumnSource::Heading(name.to_owned())]))
            }
            fn visit_i64<E: de::Error>(self, number: i64) -> Result<OneOrMore, E> {
                let column = Column::deserialize(de::value::I64Deserializer::new(number))?;
                Ok(OneOrMore(vec![column.at]))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<OneOrMore, A::Error> {
                let columns: Vec<Column> = Vec::deserialize(de::value::SeqAccessDeserializer::new(seq))?;
                Ok(OneOrMore(columns.into_iter().map(|column| column.at).collect()))
            }
        }
        deserializer.deserialize_any(Any)
    }
}

/// Column of a log: a heading, a number from 1, or a table with more keys.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Heading or number.
    pub at: ColumnSource,
    /// Number among several columns with this heading, from 1.
    pub occurrence: Option<usize>,
    /// Joint value of one encoder count, in the unit of the key.
    pub per_count: Option<f64>,
    /// Encoder count at which the joint is at zero.
    pub zero_count: Option<f64>,
}

impl From<ColumnSource> for Column {
    fn from(at: ColumnSource) -> Self {
        Self { at, occurrence: None, per_count: None, zero_count: None }
    }
}

/// Column of a log: exactly one of `name` and `number`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "ColumnTable")]
struct Stated {
    /// Name of the column in the header.
    name: Option<String>,
    /// Number of the column, from 1.
    number: Option<usize>,
    /// Number among several columns of this name, from 1.
    occurrence: Option<usize>,
    /// Joint value of one encoder count, in the unit of the joint.
    per_count: Option<f64>,
    /// Encoder count at which the joint is at zero.
    zero_count: Option<f64>,
}

etalon_base::schema_by_hand!(Column, generator => {
    let table = generator.subschema_for::<Stated>();
    schemars::json_schema!({ "anyOf": [{ "type": "string" }, { "type": "integer", "minimum": 1 }, table] })
});

impl<'de> Deserialize<'de> for Column {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NameOrNumber;
        impl<'de> Visitor<'de> for NameOrNumber {
            type Value = Column;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("the name of a column, or its number from 1, or { name = .., occurrence = .. }")
            }
            fn visit_str<E: de::Error>(self, name: &str) -> Result<Column, E> {
                Ok(ColumnSource::Heading(name.to_owned()).into())
            }
            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Column, E> {
                let wrong = || E::invalid_value(de::Unexpected::Signed(number), &self);
                let at = usize::try_from(number).ok().filter(|n| *n > 0).map(ColumnSource::Number);
                at.map(Column::from).ok_or_else(wrong)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Column, A::Error> {
                let stated = Stated::deserialize(de::value::MapAccessDeserializer::new(map))?;
                let Stated { name, number, occurrence, per_count, zero_count } = stated;
                let at = match (name, number) {
                    (Some(name), None) => ColumnSource::Heading(name),
                    (None, Some(number)) if number > 0 && occurrence.is_none() => ColumnSource::Number(number),
                    _ => return Err(de::Error::custom(phrase!("column-without-place"))),
                };
                if occurrence == Some(0) || per_count.is_some_and(|c| c == 0.0 || !c.is_finite()) {
                    return Err(de::Error::custom(phrase!("column-wrong-occurrence")));
                }
                if zero_count.is_some() && per_count.is_none() {
                    return Err(de::Error::custom(phrase!("zero-count-alone")));
                }
                Ok(Column { at, occurrence, per_count, zero_count })
            }
        }
        deserializer.deserialize_any(NameOrNumber)
    }
}
