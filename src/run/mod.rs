//! A campaign from its files to its output folder.

pub mod check;
pub mod output;
pub mod pipeline;
pub mod summary;
