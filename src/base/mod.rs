//! What every room may use: messages, files, tables, poses, numbers that carry derivatives, random numbers.

pub mod files;
pub mod message;
pub mod noise;
pub mod pose;
pub mod scalar;
pub mod table;
