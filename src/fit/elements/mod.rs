//! Geometric elements, one file each.

pub(super) mod circle_and_sphere;
pub(super) mod cone;
pub(super) mod cylinder;
pub(super) mod element;
pub(super) mod line_and_plane;
pub(super) mod torus;
