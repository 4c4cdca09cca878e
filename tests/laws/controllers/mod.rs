//! Laws of compensation and of controller files.

mod compensation;
pub(super) mod drawn;
mod files;
mod readers;
