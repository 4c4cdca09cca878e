//! Laws that hold without outside data.

mod campaigns;
mod robots;
