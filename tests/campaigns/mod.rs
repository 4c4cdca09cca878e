//! Laws of campaigns that hold without outside data.

mod blunders;
mod campaigns;
pub mod dialects;
mod features;
mod geometric_campaign;
mod joins;
mod own_formats;
mod repeatability;
mod standstills;
mod texts;
pub mod workbooks;
