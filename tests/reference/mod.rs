//! Agreement with numbers that others have published or certified.
mod prexyt;
