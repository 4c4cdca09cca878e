//! A campaign from its files to its output folder.

pub mod check;
mod names;
pub mod output;
pub mod pipeline;
mod statements;
mod summary;
