//! What several suites of tests share.
#![allow(dead_code)] // each suite uses a part

pub mod arms;
pub mod five_bar;
pub mod linearised;
pub mod scratch;
pub mod tracker;
