//! Laws of campaigns that hold without outside data.

mod blunders;
mod budget;
mod code;
pub mod controllers;
pub mod dialects;
mod features;
mod geometric_campaign;
mod joins;
mod meanings;
mod mixed;
mod own_formats;
mod platform_controllers;
mod pose_names;
mod prediction;
mod repeatability;
mod standstills;
mod texts;
mod whole;
pub mod workbooks;
