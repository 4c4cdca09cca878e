//! Laws of folders and faults of the file system.

#[cfg(unix)]
pub(super) mod faults;
pub(super) mod folders;
