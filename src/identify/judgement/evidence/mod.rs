//! Evidence of the observations about the model: significance, outliers, excitation, stability.

pub(crate) mod chi_square;
pub(crate) mod excitation;
pub(crate) mod loads;
pub(crate) mod ratio;
pub(crate) mod reliability;
pub(crate) mod robust;
pub(crate) mod significance;
pub(crate) mod stability;
