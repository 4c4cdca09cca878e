//! Laws that hold without outside data.

mod arms;
mod blunders;
mod campaigns;
mod dialects;
mod features;
mod fits;
mod fits_hostile;
mod geometric;
mod geometric_campaign;
mod iso9283;
mod joins;
mod robots;
mod serial;
