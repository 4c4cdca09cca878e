//! stub
use crate::document::*;
pub trait Exporter { fn file_name(&self) -> &'static str; fn write(&self, parameters: &ParametersDocument) -> crate::message::Result<Vec<u8>>; }
pub fn by_name(_: &str) -> Option<&'static dyn Exporter>{None}
pub fn names()->Vec<&'static str>{vec![]}
