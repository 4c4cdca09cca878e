//! Agreement with numbers that others have published or certified.
mod enclosing;
mod irb120;
mod nist_geometry;
mod nist_strd;
mod prexyt;
mod qif;
