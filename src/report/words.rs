//! Texts of the report in its language, from the catalogue.
//!
//! Statements of a campaign are never translated.

pub(super) mod comparison;
pub(super) mod names;

use etalon_base::catalogue::{Argument, Arguments, Phrase};
use etalon_base::message::{Message, Result, one_line, printable};
use etalon_documents::Language;
use std::collections::BTreeMap;

/// Text of the catalogue in the language of a report: `tr!(words, "limit-band-value", value = 3)`.
macro_rules! tr {
    ($words:expr, $($call:tt)*) => { $words.tr(&etalon_base::phrase!($($call)*)) };
}
pub(crate) use tr;

/// A name in a sentence, isolated for any writing direction.
pub(crate) fn isolated(name: &str) -> String {
    let marks = |mark: char| name.matches(mark).count();
    match marks('\u{2068}') == marks('\u{2069}') {
        true => format!("\u{2068}{name}\u{2069}"),
        // marks inside a name would end its isolation
        false => format!("\u{2068}{}\u{2069}", printable(name)),
    }
}

/// Language of a report, and the texts of documents that have no id yet.
#[derive(Clone, Debug, Default)]
pub(crate) struct Words {
    language: Language,
    sentences: BTreeMap<String, String>,
}

impl Words {
    /// Texts of a language.
    pub fn of(language: Language) -> Result<Self> {
        let sentences = match language {
            Language::En => return Ok(Self::default()),
            Language::Fr => include_str!("words/documents.fr.toml"),
            Language::De => include_str!("words/documents.de.toml"),
        };
        let sentences = toml::from_str(sentences)
            .map_err(|e| Message::error(format!("the table of words `{}` does not read: {e}", language.code())))?;
        Ok(Self { language, sentences })
    }

    /// Language code (ISO 639-1).
    pub fn code(&self) -> &'static str {
        self.language.code()
    }

    /// Text of the catalogue. Numbers in texts get the decimal mark of the language.
    pub fn tr(&self, phrase: &Phrase) -> String {
        let mut phrase = phrase.clone();
        phrase.arguments.values_mut().for_each(|value| self.mark(value));
        phrase.text(self.code())
    }

    fn mark(&self, argument: &mut Argument) {
        match argument {
            Argument::Text(text) => *text = self.value(std::mem::take(text)),
            Argument::List(all) => all.iter_mut().for_each(|one| self.mark(one)),
            _ => {}
        }
    }

    /// Sentence of a document in this language; `None` without a translation.
    pub fn of_document(&self, sentence: &str) -> Option<String> {
        self.sentences.iter().find_map(|(pattern, translation)| {
            let values = values(pattern, sentence)?;
            let and = tr!(self, "rms-and-max-values", rms = "`", max = "`");
            let said = |v: &&str| {
                v.split(", ").map(|name| self.said(name)).collect::<Vec<_>>().join(", ").replace("` and `", &and)
            };
            Some(self.filled(translation, &values.iter().map(said).collect::<Vec<_>>()))
        })
    }

    /// A name in a sentence of a document, or the last of several rows of a file with the number of
    /// further rows.
    fn said(&self, name: &str) -> String {
        let rows = |one: &str| name.strip_suffix(one).and_then(|counted| counted.split_once(" and "));
        match rows(" more rows").or_else(|| rows(" more row")) {
            Some((last, count)) => match count.parse::<usize>() {
                Ok(count) => tr!(self, "further-rows", last, count),
                Err(_) => name.to_owned(),
            },
            None => self.named(name),
        }
    }

    /// Numbers of a text with the decimal mark of the language; words with letters or several
    /// points are not numbers.
    pub fn number(&self, text: &str) -> String {
        if self.language == Language::En {
            return text.to_owned();
        }
        let is_part = |c: char| c.is_ascii_digit() || c == '.';
        let mut out = String::with_capacity(text.len());
        let mut rest = text;
        while let Some(from) = rest.find(|c: char| c.is_ascii_digit()) {
            let length = rest[from..].find(|c| !is_part(c)).unwrap_or(rest.len() - from);
            // a point at the end belongs to the sentence
            let number = rest[from..from + length].trim_end_matches('.');
            let (before, behind) = (&rest[..from], &rest[from + number.len()..]);
            let letter = |c: char| c.is_alphabetic() || c == '_';
            let named = |c: char| letter(c) || matches!(c, '.' | '/' | ':');
            let exponent =
                behind.strip_prefix('e').is_some_and(|e| e.starts_with(|c: char| c == '-' || c.is_ascii_digit()));
            let apart = !before.ends_with(named) && (exponent || !behind.starts_with(letter));
            out.push_str(before);
            match number.split_once('.').filter(|(_, decimals)| apart && !decimals.contains('.')) {
                Some((whole, decimals)) => out.extend([whole, ",", decimals]),
                None => out.push_str(number),
            }
            rest = behind;
        }
        out + rest
    }

    /// Numbers of a text that is a value, which begins with a number.
    pub fn value(&self, text: String) -> String {
        let number =
            text.trim_start_matches(['+', '-', '−', '±', '<', '>', '(', ' ']).starts_with(|c: char| c.is_ascii_digit());
        if number || text.starts_with("p ") { self.number(&text) } else { text }
    }

    /// Kind of a robot by the key of its model; any other model as it is.
    pub fn model(&self, key: &str) -> String {
        names::model(key).map_or_else(|| isolated(&one_line(key)), |phrase| self.tr(&phrase))
    }

    /// A name that documents enumerate in this language; any other name as it is.
    pub fn named(&self, name: &str) -> String {
        names::of_document(name).map_or_else(|| name.to_owned(), |phrase| self.tr(&phrase))
    }

    /// Text of a document by its text of the catalogue, if the document has it.
    pub fn worded(&self, text: &str, phrase: Option<&Phrase>) -> String {
        phrase.map_or_else(|| text.to_owned(), |phrase| self.tr(phrase))
    }

    /// Text of a document by its id in the catalogue; the text itself without an id.
    pub fn by_id(&self, id: Option<&str>, text: &str) -> String {
        let phrase = id.map(|id| Phrase { id: id.to_owned().into(), arguments: Arguments::new() });
        phrase.map_or_else(|| text.to_owned(), |phrase| self.tr(&phrase))
    }

    fn filled(&self, text: &str, values: &[String]) -> String {
        let mut pieces = text.split('{');
        let mut filled = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            let place = piece.split_once('}').and_then(|(i, rest)| Some((values.get(i.parse::<usize>().ok()?)?, rest)));
            match place {
                Some((value, rest)) => filled.extend([&self.value(value.clone()), rest]),
                None => filled.push_str(&format!("{{{piece}")),
            }
        }
        filled
    }
}

/// Values of a sentence at the placeholders `{0}`, `{1}` ... of a pattern.
fn values<'a>(pattern: &str, sentence: &'a str) -> Option<Vec<&'a str>> {
    let mut pieces = pattern.split('{');
    let mut rest = sentence.strip_prefix(pieces.next()?)?;
    let mut values = Vec::new();
    let mut pieces = pieces.map(|piece| piece.split_once('}').map_or(piece, |(_, text)| text)).peekable();
    while let Some(piece) = pieces.next() {
        let end = match pieces.peek() {
            Some(_) => rest.find(piece)?,
            None => rest.len() - rest.strip_suffix(piece).map(|_| piece.len())?,
        };
        values.push(&rest[..end]);
        rest = &rest[end + piece.len()..];
    }
    rest.is_empty().then_some(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_translation_has_the_places_of_its_text() {
        let places = |text: &str| -> std::collections::BTreeSet<String> {
            text.split('{').skip(1).map(|piece| piece.split('}').next().unwrap().to_owned()).collect()
        };
        for language in [Language::Fr, Language::De] {
            let words = Words::of(language).unwrap();
            for (text, translation) in words.sentences {
                assert_eq!(places(&text), places(&translation), "{language:?}: {text}");
                assert!(!translation.trim().is_empty() && translation.trim() == translation, "{text}");
            }
        }
    }

    #[test]
    fn values_stand_in_their_places_and_are_not_read_again() {
        let words = Words::default();
        assert_eq!(words.filled("{1} of {0}, {x} {7", &["{1}".into(), "2".into()]), "2 of {1}, {x} {7");
        assert_eq!(tr!(words, "pose-named", pose = "{ $pose }"), "pose { $pose }");
    }

    #[test]
    fn numbers_have_the_decimal_mark_of_the_language_and_names_keep_their_point() {
        let german = Words::of(Language::De).unwrap();
        for (text, shown) in [
            ("0.39 ± 0.03", "0,39 ± 0,03"),
            ("-1.5e-12 mm", "-1,5e-12 mm"),
            ("7.2.1", "7.2.1"),
            ("cal_1.5.csv, plan2.toml, v1.2", "cal_1.5.csv, plan2.toml, v1.2"),
            ("p < 0.001.", "p < 0,001."),
        ] {
            assert_eq!(german.number(text), shown);
            assert_eq!(Words::default().number(text), text);
        }
        assert_eq!(tr!(german, "plane-named", plane = "ball 1.5"), "ball 1.5-Ebene");
        assert_eq!(tr!(german, "plane-named", plane = "0.25 mm"), "0,25 mm-Ebene");
    }

    #[test]
    fn sentences_of_documents_are_found_by_their_pattern() {
        let rows = |text: &str, language| Words::of(language).unwrap().said(text);
        assert_eq!(rows("136 and 2 more rows", Language::De), "136 und 2 weiteren Zeilen");
        assert_eq!(rows("4 and 1 more row", Language::Fr), "4 et 1 autre ligne");
        assert_eq!(values("{0} of {1}: `{2}`", "1 of 3: `a`"), Some(vec!["1", "3", "a"]));
        assert_eq!(values("{0} of {1}", "1 in 3"), None);
        assert_eq!(values("plain", "plain"), Some(vec![]));
        assert_eq!(values("plain", "plain text"), None);
        let said = Words::of(Language::De).unwrap().of_document("RP of 0.25");
        assert_eq!(said, None);
    }
}
