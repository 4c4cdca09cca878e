//! map later
#![forbid(unsafe_code)]
pub mod document;
pub mod files;
pub mod identify;
pub mod message;
pub mod noise;
pub mod pose;
pub mod robots;
pub mod scalar;
pub mod solve;
pub mod table;
