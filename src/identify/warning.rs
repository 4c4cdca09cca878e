//! Warnings of an identification.

use crate::model::rigid_part::Contradicted;
use etalon_base::message::Message;
use std::ops::Deref;

/// A warning, and its subject for who knows what a reader stated where.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// The warning.
    pub message: Message,
    /// Its subject.
    pub subject: Subject,
}

/// Subject of a warning.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// Parameters that the choice of base and targets fixes are held: others could be.
    HeldByFrames,
    /// The measurements contradict the stated shape of a part.
    Shape(Contradicted),
    /// Anything that the message says completely.
    Other,
}

impl From<Message> for Warning {
    fn from(message: Message) -> Self {
        Self { message, subject: Subject::Other }
    }
}

impl Deref for Warning {
    type Target = Message;

    fn deref(&self) -> &Message {
        &self.message
    }
}
