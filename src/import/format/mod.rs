//! How a file is to be read, as a campaign states it.

mod column;
mod columns;
mod dialect;
mod dialect_check;
mod dialect_text;
mod export;
mod log;
mod presets;
mod reader;
mod text;

pub use column::{Column, ColumnAt};
pub use columns::{Columns, Role};
pub use dialect::{Decimal, Delimiter, Dialect, Format, Unit};
pub use dialect_check::{coordinate_type, two_commas};
pub use export::Export;
pub use log::{ChannelValues, FromRow, Log, LogFormat, Standstill};
pub use presets::PRESETS;
pub use reader::Reader;
pub use text::{AngleUnit, CoordinateType, Encoding, Header, Missing, NOT_MEASURED, Thousands};
