//! How a file is to be read, as a campaign states it.

mod columns;
mod dialect;
mod text;

pub use columns::{Column, ColumnAt, Columns, FromRow, Role};
pub use dialect::{Decimal, Delimiter, Dialect, Unit, coordinate_type, two_commas};
pub use text::{AngleUnit, CoordinateType, Encoding, Header, Missing, NOT_MEASURED, Thousands};
