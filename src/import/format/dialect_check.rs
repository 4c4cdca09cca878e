//! Statements about a text that mean nothing, or that could mean two things.

use super::column::ColumnAt;
use super::columns::{Columns, Role};
use super::dialect::{Decimal, Delimiter, Dialect};
use super::text::{CoordinateType, Header, Thousands};
use crate::base::message::Message;

impl Dialect {
    /// Everything that is wrong with the dialect itself, whatever the file holds.
    pub fn check(&self) -> Vec<Message> {
        let mut wrong = self.separation();
        wrong.extend(self.marks());
        wrong.extend(self.roles());
        wrong.extend(self.header());
        wrong
    }

    fn separation(&self) -> Vec<Message> {
        let stated = [self.delimiter.is_some(), !self.widths.is_empty(), self.sheet.is_some()];
        let mut wrong = Vec::new();
        if stated.iter().filter(|s| **s).count() != 1 {
            wrong.push(
                Message::error("the format does not say what separates columns, or says it twice")
                    .expected("one of `delimiter`, `widths` and `sheet`")
                    .hint("`etalon formats FILE` proposes how to read the file"),
            );
        }
        if self.widths.contains(&0) {
            wrong.push(Message::error("a column of `widths` is 0 characters wide"));
        }
        let columns = self.columns.roles().len();
        if !self.widths.is_empty() && matches!(self.columns, Columns::InOrder(_)) && columns > self.widths.len() {
            let what = format!("`columns` names {columns} columns, and `widths` has {}", self.widths.len());
            wrong.push(Message::error(what));
        }
        wrong
    }

    fn marks(&self) -> Vec<Message> {
        let mut wrong = Vec::new();
        if self.delimiter == Some(Delimiter::Comma) && self.decimal == Decimal::Comma {
            wrong.push(two_commas());
        }
        let Some(thousands) = self.thousands else { return wrong };
        let decimal = thousands.name() == self.decimal.name();
        let delimiter = self.delimiter.is_some_and(|d| d.name() == thousands.name())
            || (thousands == Thousands::Blank && self.delimiter == Some(Delimiter::Blank));
        if decimal || delimiter {
            let other = if decimal { "decimal mark" } else { "delimiter" };
            let what =
                format!("the thousands mark `{}` is the {other} as well: no number has one meaning", thousands.name());
            wrong.push(Message::error(what).hint("export the file with other marks"));
        }
        wrong
    }

    fn roles(&self) -> Vec<Message> {
        let roles = self.columns.roles();
        let mut wrong = Vec::new();
        for (n, role) in roles.iter().enumerate().filter(|(_, r)| !matches!(r, Role::Label | Role::Skip)) {
            if roles[..n].contains(role) {
                wrong.push(Message::error(format!("`columns` names `{}` twice", role.name())));
            }
        }
        let typed = roles.iter().any(|r| r.is_typed());
        let coordinates: Vec<Role> = roles.iter().copied().filter(|r| r.is_coordinate()).collect();
        match (typed, coordinates.is_empty()) {
            (true, false) => wrong.push(
                Message::error("`columns` names coordinates, and others whose kind each row says")
                    .expected("either x, y, z and the like, or c1, c2, c3"),
            ),
            (true, true) => wrong.extend(self.row_types(&roles)),
            _ => wrong.extend(self.coordinates_of("`columns`", &coordinates)),
        }
        if !typed && (!self.types.is_empty() || roles.contains(&Role::Type)) {
            let message = Message::error("`type` and `types` mean nothing without columns c1, c2, c3");
            wrong.push(message.hint("name the columns whose meaning they say `c1`, `c2`, `c3`"));
        }
        let of = |set: [Role; 3]| set.into_iter().filter(|r| roles.contains(r)).count();
        if !matches!(of([Role::I, Role::J, Role::K]), 0 | 3) {
            wrong.push(Message::error("`columns` names a part of a direction").expected("i, j and k, or none of them"));
        }
        let uncertain = of([Role::U1, Role::U2, Role::U3]);
        let axes = if typed { 3 } else { coordinates.len() };
        if uncertain != 0 && uncertain != axes {
            let what = format!("`columns` names {uncertain} standard uncertainties of {axes} coordinates");
            wrong.push(Message::error(what).expected("one each, u1, u2, u3 in the order of the coordinates, or none"));
        }
        wrong
    }

    fn row_types(&self, roles: &[Role]) -> Vec<Message> {
        let mut wrong = Vec::new();
        if !roles.contains(&Role::Type) || self.types.is_empty() {
            let message = Message::error("columns c1, c2, c3 need a column `type`, and `types` that say what they are");
            wrong.push(
                message.hint("e.g. types = { 0 = [\"x\", \"y\", \"z\"], 7 = [\"azimuth\", \"zenith\", \"distance\"] }"),
            );
        }
        for (name, meant) in &self.types {
            let place = format!("type `{name}`");
            if meant.len() != 3 || roles.iter().filter(|r| r.is_typed()).count() != 3 {
                wrong.push(Message::error(format!("{place} needs three coordinates: what c1, c2 and c3 are")));
            }
            wrong.extend(self.coordinates_of(&place, meant));
        }
        wrong
    }

    /// What is wrong with coordinates that are stated together.
    fn coordinates_of(&self, place: &str, roles: &[Role]) -> Vec<Message> {
        let mut wrong = Vec::new();
        let kind = coordinate_type(roles);
        if kind.is_none() {
            let names: Vec<&str> = roles.iter().map(|r| r.name()).collect();
            let what = match names.is_empty() {
                true => format!("{place} names no coordinates"),
                false => format!("{place}: {} are no coordinates of one point", names.join(", ")),
            };
            wrong.push(Message::error(what).expected(
                "x and y, and z in space; radius, azimuth, and z; or azimuth, zenith or elevation, and distance",
            ));
        }
        if roles.iter().any(|r| r.is_angle()) && self.angle_unit.is_none() {
            let message = Message::error(format!("{place} names angles, and the format does not say their unit"));
            wrong.push(message.expected("`angle_unit`: deg, rad or gon").hint("it is never guessed"));
        }
        if let (Some(stated), Some(kind), true) = (self.coordinates, kind, self.types.is_empty())
            && stated != kind
        {
            let what = format!("`coordinates` says {}, and {place} names {} ones", stated.name(), kind.name());
            wrong.push(Message::error(what));
        }
        wrong
    }

    fn header(&self) -> Vec<Message> {
        let Columns::Named(named) = &self.columns else { return Vec::new() };
        let by_name = named.iter().any(|(_, column)| matches!(column, ColumnAt::Name(_)));
        match by_name && self.header == Header::Rows(0) {
            true => vec![
                Message::error("`columns` names columns of a header, and the format states none")
                    .hint("state `header = 1`, or words of the header's row"),
            ],
            false => Vec::new(),
        }
    }
}

/// A comma that separates columns and marks decimals.
pub fn two_commas() -> Message {
    Message::error("a comma cannot both separate columns and mark decimals: `1,25` would be one number or two")
        .hint("export the file with semicolons or tabs, or with a decimal point")
}

/// What coordinates of these kinds are, if they are those of a point.
pub fn coordinate_type(roles: &[Role]) -> Option<CoordinateType> {
    let only = |allowed: &[Role], needed: &[Role]| {
        roles.iter().all(|r| allowed.contains(r)) && needed.iter().all(|r| roles.contains(r))
    };
    let count = |set: &[Role]| roles.iter().filter(|r| set.contains(r)).count();
    let azimuth = count(&[Role::Azimuth, Role::AzimuthClockwise]) == 1;
    let (clockwise, counter) = (Role::AzimuthClockwise, Role::Azimuth);
    if only(&[Role::X, Role::Y, Role::Z], &[Role::X, Role::Y]) {
        Some(CoordinateType::Cartesian)
    } else if only(&[Role::Radius, clockwise, counter, Role::Z], &[Role::Radius]) && azimuth {
        Some(CoordinateType::Cylindrical)
    } else if only(&[Role::Distance, clockwise, counter, Role::Zenith, Role::Elevation], &[Role::Distance])
        && azimuth
        && count(&[Role::Zenith, Role::Elevation]) == 1
    {
        Some(CoordinateType::Spherical)
    } else {
        None
    }
}
