//! Long tables behind the signature.

use super::paper::{Block, Section};
use crate::base::message::one_line;
use crate::document::{ImportDocument, PointError, Refused};
use crate::report::tables;
use crate::report::words::Words;

/// Rows of a table that are printed: nobody reads more on paper, and the workbook has all.
const LIMIT: usize = 200;

/// Errors of each pose.
pub(super) fn poses(errors: &[PointError], words: &Words) -> Option<Section> {
    let poses = tables::poses(errors, words);
    if poses.rows.is_empty() {
        return None;
    }
    let number = |text: &str, unit: &str| format!("#{}", words.fill(text, &[&unit]));
    let title = |unit: &str| [number("max before, {0}", unit), number("max after, {0}", unit)];
    let ([before, after], [before_deg, after_deg]) = (title(poses.unit), title("deg"));
    let titles = ["#pose", "set", "#errors", &before, &after, &before_deg, &after_deg];
    let columns = if poses.orientation { 7 } else { 5 };
    let left_out = poses.left_out + poses.rows.len().saturating_sub(LIMIT);
    let rows = poses.rows.into_iter().take(LIMIT).map(|row| row.into_iter().take(columns));
    let note = words.fill("{0} more poses are left out of this table.", &[&left_out]);
    let note = (left_out > 0).then(|| Block::note(note));
    let table = Block::table(words, &titles[..columns], rows);
    Section::of("poses", words.say("Errors of each pose"), note.into_iter().chain([table]).collect())
}

/// Rows that were refused, by file.
pub(super) fn refused(import: &ImportDocument, words: &Words) -> Option<Section> {
    let mut blocks = Vec::new();
    for source in import.sources.iter().filter(|s| !s.refused.is_empty()) {
        let title = words.fill("{0} refused rows of {1}", &[&source.refused.len(), &one_line(&source.file)]);
        blocks.push(Block::heading(title));
        if source.refused.len() > LIMIT {
            blocks.push(Block::note(words.say("The first 200; import.json has all.")));
        }
        let row = |r: &Refused| [r.line.to_string(), r.reason.clone(), one_line(&r.text)];
        blocks.push(Block::table(words, &["#line", "reason", "text"], source.refused.iter().take(LIMIT).map(row)));
    }
    Section::of("refused", words.say("Refused rows"), blocks)
}
