//! Laws of ISO 9283.

pub(super) mod iso9283;
pub(super) mod iso9283_beyond;
pub(super) mod iso9283_corners;
pub(super) mod iso9283_layout;
pub(super) mod iso9283_path_intervals;
pub(super) mod iso9283_paths;
pub(super) mod iso9283_stream;
pub(super) mod iso9283_weaves_and_loads;
