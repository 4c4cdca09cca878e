//! Tests by what they prove.
#![allow(clippy::print_stdout)] // a test says what it measured and what it skipped

mod architecture;
mod browser;
mod campaigns;
mod catalogue;
mod cli;
mod dependencies;
mod documents;
mod formats;
mod golden;
mod hostile;
mod in_memory;
mod messages;
mod plain;
mod prose;
mod reference;
mod signatures;
mod support;

pub(crate) use support::reference_data;
