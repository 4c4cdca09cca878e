//! Logo and templates of the report.

use crate::base::message::Problems;
use crate::campaign::Campaign;
use crate::report::templates;
use crate::run::summary::presentation;

/// What of `[report]` a run would stumble over at its end.
pub(super) fn check(campaign: &Campaign, problems: &mut Problems) {
    let read = presentation(campaign).and_then(|dressed| templates::check(&dressed));
    if let Err(more) = read {
        problems.0.extend(more.0);
    }
}
