//! Minimum zones and enclosing elements.

pub(super) mod chebyshev;
pub(super) mod enclosing;
pub(super) mod growth;
pub(super) mod minimax;
pub(super) mod minimum_zone;
pub(super) mod round_zone;
pub(super) mod search;
pub(super) mod zone;
