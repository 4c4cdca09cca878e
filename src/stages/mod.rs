//! The stages of a run, each from documents to the next document.

pub mod calibrate;
pub mod candidates;
pub mod cell;
pub mod evaluate;
pub mod gather;
pub mod geometric;
pub mod iso9283;
pub mod join;
pub mod judge;
pub mod kinds;
pub mod observe;
pub mod orientations;
pub mod remedies;
pub mod sweeps;
pub(crate) mod table_file;
pub mod uncertainty;
pub mod verify;

use etalon_base::catalogue::{Argument, IntoArgument};

/// Returns the first `most` of `all`, followed by `...` if there are more.
pub(crate) fn truncated<T: IntoArgument>(all: impl IntoIterator<Item = T>, most: usize) -> Vec<Argument> {
    let mut all = all.into_iter();
    let mut shown: Vec<Argument> = all.by_ref().take(most).map(|value| value.argument()).collect();
    shown.extend(all.next().map(|_| "...".argument()));
    shown
}
