//! Files, folders and processes of the machine.

pub mod files;
pub mod folder;
pub mod fork;
pub mod interruption;
