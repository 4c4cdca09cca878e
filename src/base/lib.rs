//! What every room may use: messages, files, patterns of names, poses, numbers that carry derivatives, random
//! numbers, dates, line drawings.
#![allow(non_snake_case)] // world_T_base: frames in names

pub mod angle_order;
pub mod bounds;
pub mod catalogue;
pub mod cell;
pub mod country;
pub mod date;
pub mod expression;
pub mod files;
pub mod folder;
pub mod message;
pub mod noise;
pub mod pattern;
pub mod pose;
pub mod pose_name;
pub mod scalar;
pub mod sketch;
