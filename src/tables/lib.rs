//! Tables: the form that a file has, and its rows. Every section of a campaign and every command
//! with a table contains its form by the same keys, and reads it by the same rules.

#[cfg(not(feature = "schemas"))]
extern crate etalon_schemaless as schemars;

mod expression;
pub mod filter;
mod form;
mod reading;
#[cfg(feature = "schemas")]
pub mod schema;
mod source;
mod units;

use reading::{from_row, head, marks, text};
pub use reading::{guess, lexer, sheet};

pub use expression::Expression;
pub use form::{Form, TableLayout, is_topic};
pub use from_row::FromRow;
pub use head::{Head, StatedUnit, stated_units};
pub use marks::{Decimal, Delimiter, Thousands, two_commas};
pub use source::{Cells, ColumnSource, Constant};
pub use text::{Encoding, Header, Missing, NOT_MEASURED};
pub use units::{is_grad, is_other_unit, unit_cell, unit_word};
