//! Agreement with numbers that others have published or certified.
mod irb120;
mod prexyt;
