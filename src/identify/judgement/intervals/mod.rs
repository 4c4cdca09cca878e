//! Uncertainties of parameters and figures, and what they consist of.

pub(crate) mod beyond;
pub(crate) mod bound;
pub(crate) mod budget;
pub(crate) mod clusters;
pub(crate) mod misfit;
pub(crate) mod predict;
pub(crate) mod regional;
pub(crate) mod relative;
pub(crate) mod uncertainty;
