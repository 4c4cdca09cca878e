//! Characteristics of standards: ISO 9283, one file each with its clause.
#![allow(non_snake_case)] // world_T_base: frames in names

pub mod iso9283;
