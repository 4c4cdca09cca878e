//! Laws of geometric elements and zones.

pub(super) mod enclosing;
pub(super) mod features;
pub(super) mod fits;
pub(super) mod fits_covariances;
pub(super) mod fits_hostile;
pub(super) mod nist_geometry;
pub(super) mod robust;
pub(super) mod zones;
pub(super) mod zones_in_space;
