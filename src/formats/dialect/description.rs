//! Dialect of delimited text. The campaign contains it; it is never guessed without a message.

use super::columns::{ColumnRole, Columns};
use super::coordinates::{AngleUnit, CoordinateType};
use etalon_base::angle_order::AngleOrder;
use etalon_base::error;
use etalon_base::message::{Message, printable, printable_character};
use etalon_tables::{ColumnSource, Decimal, Form, Header, Missing, unit_word};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt;

/// Format of the points of a text or of a sheet, with exactly one of `delimiter`, `widths` and
/// `sheet`.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(transform = etalon_tables::schema::accept_topic)]
pub struct Dialect {
    /// Form of the text.
    #[serde(flatten)]
    pub form: Form,
    /// Role of each column: from the left, or by the names of the header.
    pub columns: Columns,
    /// Meaning of `c1`, `c2`, `c3` for each content of the column `type`, in files of several
    /// coordinate types.
    pub types: BTreeMap<String, Vec<ColumnRole>>,
    /// Unit of azimuth, zenith and elevation; required with them.
    pub angle_unit: Option<AngleUnit>,
    /// Coordinate type of `columns`, given as a confirmation if the values look like another type.
    pub coordinates: Option<CoordinateType>,
    /// Coverage factor of `u95x`, `u95y` and `u95z`, and of `u1`, `u2` and `u3` if these are
    /// expanded uncertainties.
    pub coverage_factor: Option<f64>,
    /// Order of the rotations of three angles `rx_deg`, `ry_deg`, `rz_deg`, like `orientation` of
    /// tables; with `vector`, and without this key, they are a rotation vector.
    pub rotation: Option<String>,
}

/// Word of `rotation` for a rotation vector.
pub(crate) const ROTATION_VECTOR: &str = "vector";

/// Length unit of an export.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(transform = etalon_tables::schema::accept_aliases)]
pub enum Unit {
    /// Millimetre.
    #[serde(rename = "mm")]
    Millimetre,
    /// Metre.
    #[serde(rename = "m")]
    Metre,
    /// Centimetre.
    #[serde(rename = "cm")]
    Centimetre,
    /// Micrometre.
    #[serde(rename = "um")]
    Micrometre,
    /// Inch: 25.4 mm exactly.
    #[serde(rename = "inch", alias = "in")]
    #[schemars(extend("aliases" = ["in"]))]
    Inch,
}

impl Unit {
    /// All units.
    pub const ALL: [Self; 5] = [Self::Millimetre, Self::Metre, Self::Centimetre, Self::Micrometre, Self::Inch];

    /// Length of the unit (mm).
    pub fn in_mm(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Metre => 1000.0,
            Self::Centimetre => 10.0,
            Self::Micrometre => 0.001,
            Self::Inch => 25.4,
        }
    }

    /// Returns the unit with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == name)
    }

    /// Name in campaign.toml.
    pub fn name(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Micrometre => "um",
            Self::Inch => "inch",
        }
    }

    /// Returns the unit of a heading, in brackets or behind the name: `X [mm]`, `y (in)`, `z_um`.
    ///
    /// A bare `_m` is not taken as a unit, because it may mean "measured".
    pub fn from_heading(name: &str) -> Option<Self> {
        let bracketed = name.split_once(['[', '(']).and_then(|(_, rest)| rest.split([']', ')']).next());
        let length = |word: &str| unit_word(word).and_then(Self::named);
        let behind = || name.rsplit_once(['_', ' ']).and_then(|(_, last)| length(last)).filter(|u| *u != Self::Metre);
        bracketed.and_then(length).or_else(behind)
    }
}

impl Dialect {
    /// Header before the data: none by default.
    pub fn header(&self) -> Header {
        self.form.header.clone().unwrap_or_default()
    }

    /// Returns all errors of the dialect itself, independent of the file.
    pub fn check(&self) -> Vec<Message> {
        let mut wrong = self.separation();
        wrong.extend(self.form.ambiguous_marks(self.form.delimiter));
        wrong.extend(self.roles());
        wrong.extend(self.headings());
        wrong.extend(self.orientation());
        wrong
    }

    /// Returns the errors of the columns of orientations and uncertainties.
    fn orientation(&self) -> Vec<Message> {
        let roles = self.columns.roles();
        let mut wrong = Vec::new();
        let count = |form: &&&[ColumnRole]| form.iter().filter(|role| roles.contains(role)).count();
        let forms: Vec<&&[ColumnRole]> = ColumnRole::ORIENTATIONS.iter().filter(|form| count(form) > 0).collect();
        if forms.len() > 1 {
            wrong.push(error!("columns-in-two-forms", quantity = "orientation"));
        }
        for form in forms.iter().filter(|form| count(form) < form.len()) {
            let names: Vec<&str> = form.iter().map(|role| role.name()).collect();
            wrong.push(error!("column-group-incomplete", names));
        }
        if self.rotation.is_some() {
            if !roles.iter().any(|role| matches!(role, ColumnRole::RxDeg | ColumnRole::RxRad)) {
                wrong.push(error!("key-needs-columns", key = "rotation", columns = ["rx_deg", "ry_deg", "rz_deg"]));
            }
            wrong.extend(self.angle_order().err());
        }
        let expanded = roles.iter().filter(|role| role.is_expanded()).count();
        if expanded > 0 && self.coverage_factor.is_none() {
            wrong.push(error!("coverage-factor-missing"));
        }
        let of_axes = [ColumnRole::X, ColumnRole::Y, ColumnRole::Z].iter().filter(|role| roles.contains(role)).count();
        if expanded > 0 && expanded != of_axes {
            let names = ["u95x", "u95y", "u95z"];
            wrong.push(error!("uncertainty-column-count", stated = expanded, coordinates = of_axes, names));
        }
        if expanded > 0 && roles.iter().any(|role| role.is_uncertainty()) {
            wrong.push(error!("columns-in-two-forms", quantity = "uncertainty"));
        }
        if self.coverage_factor.is_some_and(|factor| !(factor > 0.0 && factor.is_finite())) {
            wrong.push(error!("key-not-positive", key = "coverage_factor"));
        }
        wrong
    }

    /// Order of the three angles; `None` for a rotation vector.
    ///
    /// # Errors
    /// Fails for an unknown order.
    pub fn angle_order(&self) -> Result<Option<AngleOrder>, Message> {
        self.rotation.as_deref().filter(|order| *order != ROTATION_VECTOR).map(str::parse).transpose()
    }

    fn separation(&self) -> Vec<Message> {
        let stated = [self.form.delimiter.is_some(), !self.form.widths.is_empty(), self.form.sheet.is_some()];
        let mut wrong = Vec::new();
        if stated.iter().filter(|s| **s).count() != 1 {
            wrong.push(error!("column-separation-unclear", stated = stated.iter().filter(|s| **s).count()));
        }
        if self.form.widths.contains(&0) {
            wrong.push(error!("column-width-zero"));
        }
        let columns = self.columns.roles().len();
        if !self.form.widths.is_empty()
            && matches!(self.columns, Columns::InOrder(_))
            && columns > self.form.widths.len()
        {
            wrong.push(error!("more-columns-than-widths", columns, widths = self.form.widths.len()));
        }
        wrong
    }

    fn roles(&self) -> Vec<Message> {
        let roles = self.columns.roles();
        let mut wrong = Vec::new();
        for (n, role) in roles.iter().enumerate().filter(|(_, r)| !matches!(r, ColumnRole::Label | ColumnRole::Skip)) {
            if roles[..n].contains(role) {
                wrong.push(error!("column-role-twice", role = role.name()));
            }
        }
        let typed = roles.iter().any(|r| r.is_typed());
        let coordinates: Vec<ColumnRole> = roles.iter().copied().filter(|r| r.is_coordinate()).collect();
        match (typed, coordinates.is_empty()) {
            (true, false) => wrong.push(error!("coordinates-of-two-kinds")),
            (true, true) => wrong.extend(self.row_types(&roles)),
            _ => wrong.extend(self.coordinate_errors("columns", &coordinates)),
        }
        if !typed && (!self.types.is_empty() || roles.contains(&ColumnRole::Type)) {
            let key = if self.types.is_empty() { "type" } else { "types" };
            wrong.push(error!("key-needs-columns", key, columns = ["c1", "c2", "c3"]));
        }
        let of = |set: [ColumnRole; 3]| set.into_iter().filter(|r| roles.contains(r)).count();
        if !matches!(of([ColumnRole::I, ColumnRole::J, ColumnRole::K]), 0 | 3) {
            wrong.push(error!("column-group-incomplete", names = ["i", "j", "k"]));
        }
        let uncertain = of([ColumnRole::U1, ColumnRole::U2, ColumnRole::U3]);
        let axes = if typed { 3 } else { coordinates.len() };
        if uncertain != 0 && uncertain != axes {
            let names = ["u1", "u2", "u3"];
            wrong.push(error!("uncertainty-column-count", stated = uncertain, coordinates = axes, names));
        }
        wrong
    }

    fn row_types(&self, roles: &[ColumnRole]) -> Vec<Message> {
        let mut wrong = Vec::new();
        if !roles.contains(&ColumnRole::Type) || self.types.is_empty() {
            wrong.push(error!("row-types-missing"));
        }
        for (name, meant) in &self.types {
            let key = format!("types.{name}");
            if meant.len() != 3 || roles.iter().filter(|r| r.is_typed()).count() != 3 {
                wrong.push(error!("row-type-incomplete", key));
            }
            wrong.extend(self.coordinate_errors(&key, meant));
        }
        wrong
    }

    /// Returns the errors of the coordinates of one point.
    fn coordinate_errors(&self, key: &str, roles: &[ColumnRole]) -> Vec<Message> {
        let mut wrong = Vec::new();
        let kind = coordinate_type(roles);
        if kind.is_none() {
            let names: Vec<&str> = roles.iter().map(|r| r.name()).collect();
            wrong.push(error!("not-coordinates", key, count = names.len(), names));
        }
        if roles.iter().any(|r| r.is_angle()) && self.angle_unit.is_none() {
            wrong.push(error!("angle-unit-missing", key));
        }
        if let (Some(stated), Some(kind), true) = (self.coordinates, kind, self.types.is_empty())
            && stated != kind
        {
            wrong.push(error!("coordinate-type-differs", stated = stated.name(), key, named = kind.name()));
        }
        wrong
    }

    fn headings(&self) -> Vec<Message> {
        let Columns::Named(named) = &self.columns else { return Vec::new() };
        let heading = |column: &'_ ColumnSource| match column {
            ColumnSource::Heading(name) if !name.contains('$') => Some(name.clone()),
            _ => None,
        };
        let by_name = named.iter().find_map(|(_, column)| heading(column));
        let stated = by_name.filter(|_| self.header() == Header::Rows(0));
        stated.map(|column| error!("header-not-stated", column)).into_iter().collect()
    }
}

/// Returns the coordinate type of these columns, if they are the coordinates of a point.
pub fn coordinate_type(roles: &[ColumnRole]) -> Option<CoordinateType> {
    let only = |allowed: &[ColumnRole], needed: &[ColumnRole]| {
        roles.iter().all(|r| allowed.contains(r)) && needed.iter().all(|r| roles.contains(r))
    };
    let count = |set: &[ColumnRole]| roles.iter().filter(|r| set.contains(r)).count();
    let azimuth = count(&[ColumnRole::Azimuth, ColumnRole::AzimuthClockwise]) == 1;
    let (clockwise, counter) = (ColumnRole::AzimuthClockwise, ColumnRole::Azimuth);
    if only(&[ColumnRole::X, ColumnRole::Y, ColumnRole::Z], &[ColumnRole::X, ColumnRole::Y]) {
        Some(CoordinateType::Cartesian)
    } else if only(&[ColumnRole::Radius, clockwise, counter, ColumnRole::Z], &[ColumnRole::Radius]) && azimuth {
        Some(CoordinateType::Cylindrical)
    } else if only(
        &[ColumnRole::Distance, clockwise, counter, ColumnRole::Zenith, ColumnRole::Elevation],
        &[ColumnRole::Distance],
    ) && azimuth
        && count(&[ColumnRole::Zenith, ColumnRole::Elevation]) == 1
    {
        Some(CoordinateType::Spherical)
    } else {
        None
    }
}

/// Returns quoted names as a TOML array.
fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    format!("[{}]", names.map(quoted).collect::<Vec<_>>().join(", "))
}

/// Returns a text as a TOML string with printable characters only.
pub(crate) fn quoted(text: &str) -> String {
    if printable(text) == text {
        return toml::Value::from(text).to_string();
    }
    let shown = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if printable_character(c) != c => format!("\\u{:04X}", u32::from(c)),
        c => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(shown).collect::<String>())
}

fn column(column: &ColumnSource) -> String {
    match column {
        ColumnSource::Heading(name) => quoted(name),
        ColumnSource::Number(number) => number.to_string(),
    }
}

fn columns(columns: &Columns) -> String {
    match columns {
        Columns::InOrder(roles) => list(roles.iter().map(|r| r.name())),
        Columns::Named(named) => {
            let mut keys: Vec<(ColumnRole, Vec<String>)> = Vec::new();
            for (role, stated) in named {
                match keys.iter_mut().find(|(known, _)| known == role) {
                    Some((_, of)) => of.push(column(stated)),
                    None => keys.push((*role, vec![column(stated)])),
                }
            }
            let entry = |(role, of): (ColumnRole, Vec<String>)| match &of[..] {
                [one] => format!("{} = {one}", role.name()),
                more => format!("{} = [{}]", role.name(), more.join(", ")),
            };
            format!("{{ {} }}", keys.into_iter().map(entry).collect::<Vec<_>>().join(", "))
        }
    }
}

/// Writes the dialect as TOML: `{ delimiter = ";", decimal = ",", columns = ["label", "x"] }`. Keys
/// with their default are omitted, except the decimal mark.
impl fmt::Display for Dialect {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let form = &self.form;
        let mut keys: Vec<(&str, String)> = Vec::new();
        if let Some(delimiter) = form.delimiter {
            keys.push(("delimiter", quoted(delimiter.name())));
        }
        if !self.form.widths.is_empty() {
            let widths: Vec<String> = self.form.widths.iter().map(usize::to_string).collect();
            keys.push(("widths", format!("[{}]", widths.join(", "))));
        }
        if let Some(sheet) = &form.sheet {
            keys.push((if form.is_topic() { "topic" } else { "sheet" }, quoted(sheet)));
        }
        if form.sheet.is_none() || form.decimal() != Decimal::default() {
            keys.push(("decimal", quoted(form.decimal().name())));
        }
        if let Some(thousands) = form.thousands {
            keys.push(("thousands", quoted(thousands.name())));
        }
        if let Some(encoding) = form.encoding {
            keys.push(("encoding", quoted(encoding.name())));
        }
        if let Some(factor) = self.coverage_factor {
            keys.push(("coverage_factor", factor.to_string()));
        }
        if let Some(order) = &self.rotation {
            keys.push(("rotation", quoted(order)));
        }
        match &self.header() {
            Header::Rows(0) => {}
            Header::Rows(rows) => keys.push(("header", rows.to_string())),
            Header::Words(words) => keys.push(("header", list(words.iter().map(String::as_str)))),
        }
        if let Some(comment) = &form.comment {
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
        if form.missing != Missing::default() {
            keys.push(("missing", list(form.missing.markers().iter().map(String::as_str))));
        }
        if let Some(end) = &form.end {
            keys.push(("end", quoted(end)));
        }
        for (key, stated) in [("only", &form.only), ("without", &form.without)] {
            if !stated.is_empty() {
                let cells = stated.iter().map(|(name, cells)| format!("{} = {cells}", quoted(name)));
                keys.push((key, format!("{{ {} }}", cells.collect::<Vec<_>>().join(", "))));
            }
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
            let dialect = *crate::Format::named(preset).unwrap().dialect;
            // a decimal point is printed where none is given
            let text = dialect.to_string();
            assert_eq!(read(&text).to_string(), text);
            assert!(dialect.check().is_empty(), "{preset}: {:?}", dialect.check());
        }
        let text = "{ sheet = 'A \"1\"', decimal = \",\", thousands = \" \", header = [\"X\", \"Y\"], comment = \"//\", \
                    columns = { label = [\"g\", 2], x = 3, y = \"Y\" }, coordinates = \"cartesian\", missing = [], end = \"END\" }";
        assert_eq!(read(text).to_string(), text);
        let text = "{ widths = [8, 10], decimal = \".\", columns = [\"azimuth\", \"elevation\", \"distance\"], angle_unit = \"gon\" }";
        assert_eq!(read(text).to_string(), text);
    }

    #[test]
    fn each_contradiction_of_a_dialect_has_its_message() {
        for (stated, id) in [
            (
                "delimiter = ';', columns = ['x', 'y', 'qw', 'qx', 'qy', 'qz', 'rx_deg', 'ry_deg', 'rz_deg']",
                "columns-in-two-forms",
            ),
            ("delimiter = ';', columns = ['x', 'y', 'z', 'i', 'j']", "column-group-incomplete"),
            ("delimiter = ';', columns = ['x', 'y', 'z', 'qw', 'qx', 'qy']", "column-group-incomplete"),
            ("delimiter = ';', columns = ['x', 'y'], rotation = 'zyx'", "key-needs-columns"),
            (
                "delimiter = ';', columns = ['x', 'y', 'z', 'rx_deg', 'ry_deg', 'rz_deg'], rotation = 'rpy'",
                "angle-order-unknown",
            ),
            ("delimiter = ';', columns = ['x', 'y'], types = { 1 = ['x', 'y', 'z'] }", "key-needs-columns"),
            ("delimiter = ';', columns = ['x', 'y', 'u95x', 'u95y']", "coverage-factor-missing"),
            ("delimiter = ';', columns = ['x', 'y', 'u95x'], coverage_factor = 2.0", "uncertainty-column-count"),
            ("delimiter = ';', columns = ['x', 'y', 'z', 'u1', 'u2']", "uncertainty-column-count"),
            ("delimiter = ';', columns = ['x', 'y'], coverage_factor = 0.0", "key-not-positive"),
            ("columns = ['x', 'y']", "column-separation-unclear"),
            ("delimiter = ';', sheet = 'A', columns = ['x', 'y']", "column-separation-unclear"),
            ("widths = [8, 0], columns = ['x', 'y']", "column-width-zero"),
            ("widths = [8], columns = ['x', 'y']", "more-columns-than-widths"),
            ("delimiter = ',', decimal = ',', columns = ['x', 'y']", "comma-ambiguous"),
            ("delimiter = ';', thousands = '.', columns = ['x', 'y']", "thousands-mark-ambiguous"),
            ("delimiter = ' ', thousands = ' ', columns = ['x', 'y']", "thousands-mark-ambiguous"),
            ("delimiter = ';', columns = ['x', 'y', 'y']", "column-role-twice"),
            ("delimiter = ';', columns = ['x', 'y', 'c1']", "coordinates-of-two-kinds"),
            ("delimiter = ';', columns = ['c1', 'c2', 'c3']", "row-types-missing"),
            (
                "delimiter = ';', columns = ['type', 'c1', 'c2', 'c3'], types = { 1 = ['x', 'y'] }",
                "row-type-incomplete",
            ),
            ("delimiter = ';', columns = ['x', 'z']", "not-coordinates"),
            ("delimiter = ';', columns = ['label']", "not-coordinates"),
            ("delimiter = ';', columns = ['azimuth', 'zenith', 'distance']", "angle-unit-missing"),
            ("delimiter = ';', columns = ['x', 'y'], coordinates = 'spherical'", "coordinate-type-differs"),
            ("delimiter = ';', columns = { x = 'X', y = 'Y' }", "header-not-stated"),
        ] {
            let ids: Vec<_> = read(&format!("{{ {stated} }}")).check().into_iter().map(|message| message.id).collect();
            assert_eq!(ids, [id], "{stated}");
        }
        let sound =
            "{ delimiter = ';', columns = ['x', 'y', 'z', 'i', 'j', 'k', 'u1', 'u2', 'u3', 'qw', 'qx', 'qy', 'qz'] }";
        assert_eq!(read(sound).check(), []);
        let turned =
            "{ delimiter = ';', columns = ['x', 'y', 'z', 'rx_rad', 'ry_rad', 'rz_rad'], rotation = 'vector' }";
        assert!(read(turned).check().is_empty() && read(turned).angle_order() == Ok(None));
    }

    #[test]
    fn units_of_headings_are_in_brackets_or_behind_the_name() {
        let of = |name: &str| Unit::from_heading(name).map(Unit::name);
        assert_eq!(
            ["X [mm]", "y (in)", "z_um", "X Inch", "x [m]", "x (cm)", "\u{b5} [\u{b5}m]"].map(of),
            ["mm", "inch", "um", "inch", "m", "cm", "um"].map(Some)
        );
        assert_eq!(["X", "x_m", "x [rad]", "", "[", "X (M)"].map(of), [None; 6]);
    }
}
