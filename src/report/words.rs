//! Texts of the report in its language, from the catalogue.
//!
//! Data of a campaign are never translated.

pub(super) mod comparison;
pub(super) mod names;

use crate::number;
use etalon_base::catalogue::{Argument, Arguments, Phrase};
use etalon_base::message::{one_line, printable};
use etalon_base::worded::Worded;
use etalon_documents::Language;

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

/// Language of a report.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Words {
    language: Language,
}

impl Words {
    /// Texts of a language.
    pub fn new(language: Language) -> Self {
        Self { language }
    }

    /// Language code (ISO 639-1).
    pub fn code(&self) -> &'static str {
        self.language.code()
    }

    /// Text of the catalogue. Numbers in texts get the decimal mark of the language.
    pub fn tr(&self, phrase: &Phrase) -> String {
        if self.language == Language::En {
            return phrase.text(self.code());
        }
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

    /// A number with a fixed number of decimals.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        self.decimal(number::fixed(value, decimals))
    }

    /// Returns a number with this many significant digits.
    pub fn significant(&self, value: f64, digits: usize) -> String {
        self.decimal(number::significant(value, digits))
    }

    /// A number with all its digits.
    pub fn unrounded(&self, value: f64) -> String {
        self.decimal(value.to_string())
    }

    /// The text of one number with the decimal mark of the language.
    pub fn decimal(&self, number: String) -> String {
        match self.language {
            Language::En => number,
            Language::Fr | Language::De => number.replacen('.', ",", 1),
        }
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

    /// Text of a document; English without a phrase.
    pub fn worded(&self, text: &Worded) -> String {
        text.phrase().map_or_else(|| text.to_string(), |phrase| self.tr(phrase))
    }

    /// Text of a document by its id in the catalogue; the text itself without an id.
    pub fn by_id(&self, id: Option<&str>, text: &str) -> String {
        let phrase = id.map(|id| Phrase { id: id.to_owned().into(), arguments: Arguments::new() });
        phrase.map_or_else(|| text.to_owned(), |phrase| self.tr(&phrase))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_decimal_mark_of_the_language_and_names_keep_their_point() {
        let german = Words::new(Language::De);
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
    fn values_are_not_read_as_texts() {
        assert_eq!(tr!(Words::default(), "pose-named", pose = "{ $pose }"), "pose { $pose }");
    }
}
