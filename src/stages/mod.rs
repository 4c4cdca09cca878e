//! The stages of a run, each from documents to the next document.

pub mod candidates;
mod checks;
pub mod distance;
pub mod evaluate;
pub mod exclusions;
pub mod frames;
pub mod gather;
pub mod geometric;
pub mod given;
pub mod identification;
pub mod iso9283;
pub mod join;
pub mod joint_range;
pub mod kinds;
pub(crate) mod labelled_points;
pub mod monte_carlo;
pub mod orientations;
pub mod plausible;
pub mod positions;
pub mod qif_fit;
pub mod recommendation;
pub mod remedies;
pub mod repeats;
pub(crate) mod table_file;
pub mod tool;
pub mod validation;
pub mod verification;
