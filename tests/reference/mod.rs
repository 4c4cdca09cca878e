//! Agreement with numbers that others have published or certified.
mod enclosing;
mod exports;
mod exports_table;
mod iso9283;
mod iso9283_streams;
mod logs;
mod nist_geometry;
mod nist_strd;
mod qif;
mod readers;
