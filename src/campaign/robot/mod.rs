//! robot.toml: its text, keys and values, or a URDF in its place.

pub(super) mod robot_faults;
pub(super) mod robot_file;
pub(super) mod robot_keys;
pub(super) mod robot_text;
pub(super) mod urdf;
