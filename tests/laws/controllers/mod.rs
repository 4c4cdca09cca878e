//! Laws of compensation and of controller files.

mod compensation;
mod drawn;
mod files;
mod readers;
