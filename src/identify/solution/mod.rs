//! Solution: starting values, the solver, and the parameters that the observations determine.

pub(crate) mod estimation;
pub(crate) mod evidence;
pub(crate) mod fixtures;
pub(crate) mod identifiability;
pub(crate) mod locate;
pub(crate) mod observability;
pub(crate) mod placing;
pub(crate) mod scatter;
pub(crate) mod solver;
pub(crate) mod start;
#[cfg(test)]
mod tests;
