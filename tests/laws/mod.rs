//! Laws that hold without outside data.

mod arms;
mod campaigns;
mod fits;
mod fits_hostile;
mod joins;
mod robots;
mod serial;
