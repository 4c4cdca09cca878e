//! Refusals of the server: a status and a message of the catalogue.

use crate::answer::Answer;
use crate::contract::ShownMessage;
use crate::request::Unreadable;
use crate::shared::Shared;
use etalon_base::error;
use etalon_base::message::Message;

/// A message of the server as an answer.
pub(crate) fn refusal(shared: &Shared, status: u16, message: Message) -> Answer {
    Answer::messages(status, &[ShownMessage::new(&message, shared.desk.language())])
}

/// A message of the server as a text, for a person who opens an address.
pub(crate) fn refusal_to_read(shared: &Shared, status: u16, message: &Message) -> Answer {
    let ShownMessage { id, text, hint, .. } = ShownMessage::new(message, shared.desk.language());
    let hint = hint.map(|hint| format!("\n→ {hint}")).unwrap_or_default();
    Answer::new(status, "text/plain; charset=utf-8", format!("{text} [{id}]{hint}\n").into_bytes())
}

pub(crate) fn unreadable_answer(shared: &Shared, unreadable: Unreadable) -> Answer {
    let (status, message) = match unreadable {
        Unreadable::Silent | Unreadable::Malformed => (400, error!("view-request-malformed")),
        Unreadable::Slow => (408, error!("view-request-slow")),
        Unreadable::WithoutLength => (411, error!("view-request-without-length")),
        Unreadable::TooLarge => {
            let mib = shared.limits.file_bytes >> 20;
            (413, error!("view-request-too-large", mib))
        }
        Unreadable::HeadTooLarge => (431, error!("view-request-malformed")),
    };
    refusal(shared, status, message)
}
