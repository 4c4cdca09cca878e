//! Judgement: the uncertainty of the parameters, the observations that contradict them, and
//! explanations of the contradiction.

pub(crate) mod beyond;
pub(crate) mod bound;
pub(crate) mod budget;
pub(crate) mod chi_square;
pub(crate) mod clusters;
pub(crate) mod diagnosis;
pub(crate) mod excitation;
pub(crate) mod figures;
pub(crate) mod loads;
pub(crate) mod logs;
pub(crate) mod misfit;
pub(crate) mod predict;
pub(crate) mod ratio;
pub(crate) mod regional;
pub(crate) mod relative;
pub(crate) mod reliability;
pub(crate) mod robust;
pub(crate) mod significance;
pub(crate) mod stability;
pub(crate) mod tool;
pub(crate) mod uncertainty;
pub(crate) mod verification;
