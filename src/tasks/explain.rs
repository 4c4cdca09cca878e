//! Explanations of messages.

use etalon_base::catalogue::{Entry, entries};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_documents::ExplanationDocument;

/// Explains the message with this id, or all messages.
///
/// # Errors
/// Fails if no message has this id.
pub fn explain(id: Option<&str>) -> Result<ExplanationDocument> {
    let messages: Vec<Entry> = entries().into_iter().filter(Entry::is_message).collect();
    let Some(id) = id else { return Ok(ExplanationDocument::new(&messages)) };
    let entry = messages.iter().find(|entry| entry.id == id).ok_or_else(|| {
        let message = error!("message-unknown", id);
        Problems::from(message.hint_names(id, messages.iter().map(|entry| entry.id)))
    })?;
    Ok(ExplanationDocument::new([entry]))
}
