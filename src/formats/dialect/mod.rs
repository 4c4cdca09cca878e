//! Dialects: data of a campaign about the points of its exports.

mod columns;
mod coordinates;
mod description;

pub use columns::{Column, ColumnRole, Columns};
pub use coordinates::{AngleUnit, CoordinateType};
pub use description::{Dialect, Unit, coordinate_type};
pub(crate) use description::{ROTATION_VECTOR, quoted};
