//! Texts of paragraphs and cells, in runs with marks.

use crate::words::{Words, tr};
use etalon_base::catalogue::Entry;
use etalon_base::message::one_line;
use etalon_base::worded::Worded;
use serde::Serialize;

/// Text of a paragraph or cell: pieces in the report's language, names, and English texts.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Text(Vec<Run>);

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Run {
    text: String,
    mark: Mark,
    /// Tooltip of an id: meaning of the message.
    #[serde(skip_serializing_if = "Option::is_none")]
    tip: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Mark {
    /// Worded by the report.
    Own,
    Name,
    English,
    Code,
    /// A key or a name between backticks in a text.
    #[serde(rename = "code")]
    Key,
    /// Id of a message, which links to its explanation.
    Id,
    /// Id of a message at its explanation.
    Explained,
}

impl Text {
    /// A text; parts between backticks in a sentence are keys or names.
    pub(super) fn new(text: String, mark: Mark) -> Self {
        let is_sentence = matches!(mark, Mark::Own | Mark::English);
        if !is_sentence || !text.contains('`') || !text.matches('`').count().is_multiple_of(2) {
            return Self(vec![Run { text, mark, tip: None }]);
        }
        let run = |(i, piece): (usize, &str)| Run {
            text: piece.to_owned(),
            mark: if i.is_multiple_of(2) { mark } else { Mark::Key },
            tip: None,
        };
        Self(text.split('`').enumerate().map(run).filter(|run| !run.text.is_empty()).collect())
    }

    /// A name, isolated from its surroundings.
    pub fn name(text: &str) -> Self {
        Self::new(one_line(text), Mark::Name)
    }

    /// A text of a document, in English in every language.
    pub fn english(text: &str) -> Self {
        Self::new(text.to_owned(), Mark::English)
    }

    /// A text of a document in the language of the report; English without a catalogue entry.
    pub fn worded(text: &Worded, words: &Words) -> Self {
        text.phrase().map_or_else(|| Self::english(text.english()), |phrase| words.tr(phrase).into())
    }

    /// A line of a file, or a checksum.
    pub fn code(text: &str) -> Self {
        Self::new(one_line(text), Mark::Code)
    }

    /// Explanation of a message, in English in every language.
    pub(super) fn explanation(entry: &Entry, words: &Words) -> Self {
        let of = |text: &str| Self::from(" ").and(Self::english(text));
        let label = |label: String| Self::from(" ").and(label);
        let id = Self::new(entry.id.to_owned(), Mark::Explained);
        id.and(": ")
            .and(Self::english(&entry.meaning))
            .and(of(&entry.reason))
            .and(label(tr!(words, "action-label")).and(of(&entry.action)))
            .and(label(tr!(words, "example-label")).and(of(&entry.example)))
    }

    /// Joins sentences without full stops to one sentence.
    pub fn conventions(all: &[Worded], words: &Words) -> Self {
        let joined = all.iter().map(|text| Self::worded(text, words)).reduce(|a, b| a.and("; ").and(b));
        joined.map_or_else(Self::default, |text| text.and("."))
    }

    /// Adds the meaning of a message as a tooltip to its id, and a link if there is an explanation.
    pub(super) fn explain(&mut self, entry: &Entry, linked: bool) {
        for run in self.0.iter_mut().filter(|run| run.mark == Mark::Code && run.text == entry.id) {
            run.tip = Some(entry.meaning.replace('`', ""));
            run.mark = if linked { Mark::Id } else { Mark::Code };
        }
    }

    /// `true` if the text contains no letter.
    pub(super) fn is_empty(&self) -> bool {
        self.0.iter().all(|run| run.text.is_empty())
    }

    /// Appends more text.
    pub fn and(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    pub fn plain(&self) -> String {
        let shown = |run: &Run| match run.mark {
            Mark::Key => format!("`{}`", run.text),
            _ => run.text.clone(),
        };
        self.0.iter().map(shown).collect()
    }
}

impl From<String> for Text {
    fn from(text: String) -> Self {
        Self::new(text, Mark::Own)
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_between_backticks_is_code_on_a_page_and_stays_as_it_is_in_plain_text() {
        let text = Text::english("log `read_back` has 2 rows of `a`");
        let json = serde_json::to_value(&text).unwrap();
        let marks: Vec<_> = json.as_array().unwrap().iter().map(|run| run["mark"].as_str().unwrap()).collect();
        assert_eq!(marks, ["english", "code", "english", "code"]);
        assert!(!json.to_string().contains('`'), "{json}");
        assert_eq!(text.plain(), "log `read_back` has 2 rows of `a`");
        for odd in ["a ` b", "plain", ""] {
            assert_eq!(Text::from(odd).plain(), odd);
        }
        // a name is kept as it is
        assert_eq!(serde_json::to_value(Text::name("`x`")).unwrap()[0]["text"], "`x`");
    }
}
