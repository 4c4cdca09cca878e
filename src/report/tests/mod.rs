//! Requirements on all kinds of reports: required contents, unusual input, forbidden contents.

#[cfg(test)]
mod comparison;
pub(super) mod demo;
pub(super) mod demo_iso9283;
mod demo_streams;
pub(super) mod page;
mod terminal;
mod workbook;
