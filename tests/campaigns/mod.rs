//! Laws of campaigns that hold without outside data.

mod blunders;
pub mod dialects;
mod features;
mod geometric_campaign;
mod joins;
mod own_formats;
mod repeatability;
mod rigid;
mod standstills;
mod texts;
mod tool;
mod whole;
pub mod workbooks;
