//! Characteristics of standards, one per file with its clause: ISO 9283, ISO 230-2, decision rules.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

pub mod decision;
pub mod iso230;
pub mod iso9283;
mod outlying;
