//! Judgement: the uncertainty of the parameters, the observations that contradict them, and
//! explanations of the contradiction.

pub(crate) mod diagnosis;
mod evidence;
pub(crate) mod figures;
mod intervals;
pub(crate) mod logs;
pub(crate) mod tool;
pub(crate) mod verification;

pub(crate) use evidence::{chi_square, excitation, loads, ratio, reliability, robust, significance, stability};
pub(crate) use intervals::{beyond, bound, budget, clusters, misfit, predict, regional, relative, uncertainty};
