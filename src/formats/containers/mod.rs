//! Containers of other formats: recordings, workbooks, XML, columns, packed files.

pub mod cdr;
pub mod mcap;
pub mod parquet;
pub(crate) mod ros_bag;
pub(super) mod sqlite;
pub(super) mod unpack;
#[cfg(target_arch = "x86_64")]
pub(super) mod wide;
pub(super) mod workbook;
pub mod xml;
