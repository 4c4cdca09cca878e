//! Laws of identification, its uncertainty and diagnosis, planning.

pub(super) mod arms;
pub(super) mod axes;
pub(super) mod budget;
pub(super) mod cell;
pub(super) mod common;
pub(super) mod conditions;
pub(super) mod convergence;
pub(super) mod coverage;
pub(super) mod drawn;
pub(super) mod geometric;
pub(super) mod geometric_campaign;
pub(super) mod monte_carlo;
pub(super) mod plans;
pub(super) mod prediction;
pub(super) mod priors;
pub(super) mod probes;
pub(super) mod recommendation;
pub(super) mod regional;
pub(super) mod rigid;
pub(super) mod robust;
pub(super) mod set_ups;
pub(super) mod slips;
pub(super) mod stability;
pub(super) mod thresholds;
pub(super) mod tool;
pub(super) mod verification;
