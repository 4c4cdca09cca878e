//! Characteristics of pose tests, one file each, with its clause.

pub mod accuracy;
pub mod directions;
pub mod distance;
pub mod drift;
pub mod exchangeability;
pub mod repeatability;
