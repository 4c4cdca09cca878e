//! Laws that hold without outside data.

mod campaigns;
mod joins;
mod robots;
