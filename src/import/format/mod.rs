//! How a file is to be read, as a campaign states it.

mod column;
mod columns;
mod dialect;
mod dialect_check;
mod dialect_text;
mod text;

pub use column::{Column, ColumnAt, FromRow};
pub use columns::{Columns, Role};
pub use dialect::{Decimal, Delimiter, Dialect, Unit};
pub use dialect_check::{coordinate_type, two_commas};
pub use text::{AngleUnit, CoordinateType, Encoding, Header, Missing, NOT_MEASURED, Thousands};
