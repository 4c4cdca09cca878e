//! Page one below the verdict: limits and errors in figures, next steps, and fields to complete
//! before signing.

use super::checklist;
use crate::batch::encoded;
use crate::model::{Step, StepFile, Text, ToComplete, Verdict, sentence};
use crate::plots::bullets;
use crate::words::{Words, tr};
use etalon_documents::{Action, ActionKind, LimitVerdict, Results};

/// Verdict with the contents of page one.
pub(crate) fn complete(results: &Results, verdict: Verdict, words: &Words) -> Verdict {
    let judgement = &results.verdict;
    let steps = judgement.actions.iter().map(|a| step(a, results, words)).collect();
    let limits: Vec<&LimitVerdict> = judgement.limits.iter().collect();
    let to_complete = Some(to_complete(results, words)).filter(|t| !t.fields.is_empty());
    Verdict { steps, to_complete, ..with_figures(verdict, &limits, words) }
}

/// Verdict with its limits and headlines in figures.
pub(crate) fn with_figures(verdict: Verdict, limits: &[&LimitVerdict], words: &Words) -> Verdict {
    let before_after =
        bullets::before_after(&verdict.headlines, verdict.about.trim_end_matches([':', ' ', '\u{a0}']), words);
    let graphs = bullets::limits(limits, words).into_iter().chain(before_after).collect();
    Verdict { graphs, ..verdict }
}

/// A next step in the language of the report.
fn step(action: &Action, results: &Results, words: &Words) -> Step {
    let texts = action.message.as_ref().map(|m| m.texts(words.code()));
    let what = match (action.what.phrase(), texts.as_ref().and_then(|t| t.hint.clone())) {
        (Some(phrase), _) => words.tr(phrase),
        (None, hint) => hint.unwrap_or_else(|| action.what.to_string()),
    };
    let reason = match (action.reason.phrase(), texts) {
        (Some(phrase), _) => words.tr(phrase),
        (None, texts) => texts.map_or_else(|| action.reason.to_string(), |t| t.what),
    };
    let written = matches!(action.action, ActionKind::Load | ActionKind::Compensate);
    let file = action.file.as_ref().filter(|_| written).map(|name| {
        let controller = results.campaign.controller_files.iter().find(|written| written.file == *name);
        let sha256 = controller.and_then(|written| written.sha256.clone());
        StepFile { name: name.clone(), address: encoded(name), sha256 }
    });
    let [what, reason] = [what, reason].map(|text| Text::from(sentence(&text)));
    Step { what, reason, command: action.command.clone(), file }
}

/// Fields without which the report is a draft.
fn to_complete(results: &Results, words: &Words) -> ToComplete {
    let fields: Vec<String> = checklist::missing(results, words).into_iter().map(|m| m.field).collect();
    ToComplete { title: tr!(words, "to-complete-count", count = fields.len()), fields }
}
