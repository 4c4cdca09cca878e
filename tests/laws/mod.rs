//! Laws that hold without outside data.
mod robots;
