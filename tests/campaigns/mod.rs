//! Laws of campaigns that hold without outside data.

mod apart;
mod blunders;
mod branches;
mod budget;
mod circumstances;
mod code;
pub mod controllers;
pub mod dialects;
mod effects;
mod field;
mod gauge;
mod joins;
mod meanings;
mod mixed;
mod own_formats;
mod payload;
mod platform_controllers;
mod pose_names;
mod readings;
mod repeatability;
mod robot_geometry;
mod texts;
mod uncontrolled;
mod whole;
pub mod workbooks;
