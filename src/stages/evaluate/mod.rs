//! Errors before and after an identification, their uncertainty, and the verdict on their limits.

pub mod accuracy;
pub mod error_table;
pub mod errors;
pub(crate) mod field;
pub(crate) mod influence;
pub mod sets;
pub mod tool;
