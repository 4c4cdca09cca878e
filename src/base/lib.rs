//! Common basis of all crates: messages, files, patterns of names, poses, numbers with derivatives,
//! random numbers, dates, line drawings.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

pub mod angle;
pub mod angle_order;
pub mod bounds;
pub mod catalogue;
pub mod cell;
pub mod country;
pub mod date;
pub mod expression;
pub mod files;
pub mod folder;
pub mod fork;
pub mod interruption;
pub mod message;
pub mod noise;
pub mod pattern;
pub mod pose;
pub mod pose_name;
pub mod scalar;
pub mod sketch;
pub mod template;
pub mod worded;
