//! Laws of compensation and of controller files.

pub(super) mod compensation;
pub(super) mod files;
