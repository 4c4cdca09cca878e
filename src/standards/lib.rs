//! Characteristics of standards, one a file with its clause: ISO 9283, ISO 230-2, decision rules.
#![allow(non_snake_case)] // world_T_base: frames in names

pub mod decision;
pub mod iso230;
pub mod iso9283;
