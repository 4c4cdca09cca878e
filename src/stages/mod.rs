//! The stages of a run, each from documents to the next document.

pub mod apart;
pub(crate) mod bounds;
pub mod candidates;
pub mod cell;
mod checks;
pub(crate) mod circumstances;
mod commanded;
pub mod controlled;
pub mod controller_files;
mod conventions;
mod cross_validation;
pub mod distance;
pub mod evaluate;
mod excitation;
pub mod exclusions;
mod field;
mod first_tilt;
pub mod frames;
pub mod gather;
pub mod geometric;
pub mod given;
pub mod identification;
mod influence;
pub mod iso9283;
pub mod join;
pub mod joint_range;
pub mod kinds;
pub(crate) mod labelled_points;
pub mod monte_carlo;
pub mod orientations;
pub mod plausible;
pub mod positions;
pub mod predicted;
pub mod qif_fit;
pub mod recommendation;
pub mod remedies;
pub mod repeats;
mod resolution;
pub mod solved;
pub mod sweeps;
pub(crate) mod table_file;
pub mod tool;
mod undescribed;
pub mod validation;
pub mod verification;

use etalon_base::catalogue::{Argument, IntoArgument};

/// Returns the first `most` of `all`, followed by `...` if there are more.
fn shown<T: IntoArgument>(all: impl IntoIterator<Item = T>, most: usize) -> Vec<Argument> {
    let mut all = all.into_iter();
    let mut shown: Vec<Argument> = all.by_ref().take(most).map(|value| value.argument()).collect();
    shown.extend(all.next().map(|_| "...".argument()));
    shown
}
