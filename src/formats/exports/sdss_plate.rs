//! Tables of drilled holes of plates of the Sloan Digital Sky Survey, in columns of fixed width.

use super::Recognised;
use super::delimited::NamedDialect;
use crate::dialect::{ColumnRole, Dialect};
use etalon_base::phrase;
use etalon_tables::{Form, Header};

pub(super) const SDSS_PLATE: NamedDialect = NamedDialect {
    name: "sdss-plate",
    recognise: |text| {
        let mark = text.lines().take(5).any(|line| line.contains("Meas X    Meas Y     Nom X"));
        Recognised::by(mark, 0.9, phrase!("is-drilled-plate"))
    },
    dialect: || Dialect {
        form: Form {
            widths: vec![10, 10, 10, 10, 10, 10, 8, 8, 8],
            header: Some(Header::Words(vec!["Meas X".to_owned(), "Nom X".to_owned()])),
            ..Form::default()
        },
        columns: vec![ColumnRole::X, ColumnRole::Y].into(),
        ..Dialect::default()
    },
};
