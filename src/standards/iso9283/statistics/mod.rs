//! Statistics of attained positions: spread, intervals, conformity with a limit.

pub mod bootstrap;
pub mod interval;
pub(crate) mod repeats;
pub mod sample;
pub mod scatter;
pub mod uncertainty_ratio;
