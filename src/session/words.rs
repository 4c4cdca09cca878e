//! Messages and verdicts in the language of a page.

use etalon_base::message::{Message, Problems};
use etalon_base::phrase;
use etalon_documents::{Acceptance, AccuracyDocument, LimitVerdict};
use etalon_view::{ShownMessage, Verdict};

/// Messages in a language: similar messages are merged, and messages that need action come first.
pub(super) fn shown(messages: &[Message], language: &str) -> Vec<ShownMessage> {
    let mut grouped = Problems(messages.to_vec()).grouped().0;
    grouped.sort_by_key(|message| message.rank);
    grouped.iter().map(|message| ShownMessage::new(message, language)).collect()
}

/// Language of the user's environment, for a page without a campaign.
pub(super) fn language_of_user() -> &'static str {
    let stated = ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(|name| std::env::var(name).ok());
    match stated.as_deref().and_then(|stated| stated.get(..2)) {
        Some("de") => "de",
        Some("fr") => "fr",
        _ => "en",
    }
}

/// Name of a verdict.
pub(super) fn status(verdict: Option<Acceptance>) -> &'static str {
    match verdict {
        Some(Acceptance::Pass) => "pass",
        Some(Acceptance::Conditional) => "conditional",
        Some(Acceptance::Undecided) => "undecided",
        Some(Acceptance::Fail) => "fail",
        None => "none",
    }
}

/// Verdict on the limits of errors alone.
pub(super) fn limits(accuracy: &AccuracyDocument, language: &str) -> Verdict {
    let line = |verdict: &LimitVerdict| {
        let (limit, bound, unit) = (verdict.name.phrase(), verdict.limit, verdict.unit.clone());
        let value = verdict.value.unwrap_or(f64::NAN);
        let text = match verdict.expanded_uncertainty {
            Some(expanded) => phrase!("view-verdict-limit", limit, value, expanded, bound, unit),
            None => phrase!("view-verdict-limit-unknown", limit, value, bound, unit),
        };
        text.text(language)
    };
    let mut lines: Vec<String> = accuracy.limits.iter().map(line).collect();
    if lines.is_empty() {
        lines.push(phrase!("view-verdict-no-limit").text(language));
    }
    let worst = accuracy.limits.iter().map(|verdict| verdict.acceptance).max();
    Verdict { status: status(worst), lines, next: Vec::new() }
}
