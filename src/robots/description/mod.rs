//! Descriptions of robots: definition, keys, tables, URDF, published robots, faults.

pub(super) mod definition;
pub(super) mod fault;
pub(super) mod keys;
pub(super) mod published;
pub(super) mod tables;
pub(super) mod urdf;
