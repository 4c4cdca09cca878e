//! Texts of documents.

use crate::catalogue::{Argument, IntoArgument, Phrase};
use std::fmt;

/// Text of a document: English words and, if the catalogue contains the text, the
/// [`Phrase`] that translates it.
///
/// # Examples
///
/// ```
/// use etalon_base::{phrase, worded::Worded};
///
/// let approaches = Worded::from(phrase!("approaches", count = 2));
/// assert_eq!(approaches.english(), "2 approaches");
/// assert_eq!(approaches.text("de"), "2 Anfahrrichtungen");
/// assert_eq!(Worded::from("ball 1").text("de"), "ball 1");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Worded {
    english: String,
    phrase: Option<Phrase>,
}

impl Worded {
    /// Text as a document stores it: the English words of the version that wrote the document, and
    /// the phrase if the document has one.
    pub fn stored(english: String, phrase: Option<Phrase>) -> Self {
        Self { english, phrase }
    }

    /// English words.
    pub fn english(&self) -> &str {
        &self.english
    }

    /// Text of the catalogue; `None` if the catalogue does not contain the text.
    pub fn phrase(&self) -> Option<&Phrase> {
        self.phrase.as_ref()
    }

    /// Words in a language (ISO 639-1); the English words without a phrase.
    pub fn text(&self, language: &str) -> String {
        self.phrase.as_ref().map_or_else(|| self.english.clone(), |phrase| phrase.text(language))
    }
}

impl From<Phrase> for Worded {
    fn from(phrase: Phrase) -> Self {
        Self { english: phrase.to_string(), phrase: Some(phrase) }
    }
}

impl From<String> for Worded {
    fn from(english: String) -> Self {
        Self { english, phrase: None }
    }
}

impl From<&str> for Worded {
    fn from(english: &str) -> Self {
        english.to_owned().into()
    }
}

impl fmt::Display for Worded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.english)
    }
}

impl IntoArgument for Worded {
    fn argument(&self) -> Argument {
        self.phrase.as_ref().map_or_else(|| self.english.argument(), Phrase::argument)
    }
}
