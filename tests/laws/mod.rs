//! Laws that hold without outside data.

mod arms;
mod blunders;
mod campaigns;
mod dialects;
mod features;
mod fits;
mod fits_hostile;
mod joins;
mod robots;
mod serial;
mod solving;
mod zones;
