//! Agreement with numbers that others have published or certified.
mod certified;
mod exports;
mod exports_table;
mod iso9283;
mod iso9283_streams;
mod logs;
mod qif;
mod readers;
mod real;
