//! Laws that hold without outside data.

mod arms;
mod blunders;
mod campaigns;
mod common;
mod dialects;
mod features;
mod fits;
mod fits_covariances;
mod fits_hostile;
pub mod five_bar;
mod geometric;
mod geometric_campaign;
mod iso9283;
mod iso9283_beyond;
mod iso9283_layout;
mod iso9283_paths;
mod iso9283_stream;
mod joins;
mod plans;
mod probes;
mod repeatability;
mod robots;
mod serial;
mod solving;
mod standstills;
mod thresholds;
mod zones;
