//! Task of `etalon check`.

use crate::run::walk::{Checked, checked};
use etalon_base::message::Problems;
use etalon_campaign::Campaign;
use etalon_documents::CheckDocument;
use std::path::Path;

/// Finds all errors of a campaign without computing.
pub fn check(campaign: &Path) -> CheckDocument {
    let (checked, problems) = find(campaign);
    let Checked { inputs, joints, not_controlled, .. } = checked.unwrap_or_default();
    let messages = Problems(problems.0.into_iter().chain(inputs.messages).collect()).grouped();
    let document = CheckDocument::new(campaign.display().to_string(), &messages.0, inputs.sources);
    CheckDocument { joints, not_controlled, ..document }
}

/// Contents of the campaign's files, and all errors.
pub(crate) fn find(path: &Path) -> (Option<Checked>, Problems) {
    let (campaign, mut problems) = match Campaign::recover(path) {
        Ok(found) => found,
        Err(problems) => return (None, problems),
    };
    let Some(campaign) = campaign else { return (None, problems) };
    let mut checked = checked(&campaign);
    problems.0.append(&mut checked.problems.0);
    (Some(checked), problems)
}
