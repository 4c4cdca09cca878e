//! A campaign from its files to its output folder.

pub mod batch;
pub mod controller_formats;
pub mod documents;
mod names;
pub mod output;
pub mod pipeline;
pub mod results;
pub mod selftest;
mod statements;
pub mod summary;
pub mod validation;
pub mod walk;
