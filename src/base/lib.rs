//! Common basis of all crates: messages, files, patterns of names, poses, numbers with derivatives,
//! random numbers, dates, line drawings.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

pub mod bounds;
pub mod cell;
pub mod date;
pub mod expression;
mod geometry;
pub mod noise;
pub mod pose_name;
mod system;
mod text;

pub use geometry::{angle, angle_order, pose, scalar, sketch};
pub use system::{files, folder, fork, interruption};
pub use text::{catalogue, country, message, pattern, template, worded};
