//! Texts of the report in its languages. The English text is the key; `words/` contains one table
//! per language.
//!
//! Statements of a campaign, and messages of the program, are never translated.

pub(super) mod comparison;

use etalon_base::message::{Message, Result, printable};
use etalon_documents::Language;
use std::collections::BTreeMap;
use std::fmt::Display;

/// A name in a sentence, isolated for any writing direction.
pub(crate) fn isolated(name: &str) -> String {
    let marks = |mark: char| name.matches(mark).count();
    match marks('\u{2068}') == marks('\u{2069}') {
        true => format!("\u{2068}{name}\u{2069}"),
        // marks inside a name would end its isolation
        false => format!("\u{2068}{}\u{2069}", printable(name)),
    }
}

/// Name of a limit in words, by its key in campaigns.
pub(crate) fn limit_name(key: &str, words: &Words) -> String {
    let of = |error: &str| words.say(error);
    match key {
        "position_max_mm" => words.fill("{0} max", &[&of("position")]),
        "position_mean_mm" => words.fill("{0} mean", &[&of("position")]),
        "position_rms_mm" => words.fill("{0} RMS", &[&of("position")]),
        "orientation_max_deg" => words.fill("{0} max", &[&of("orientation")]),
        "repeatability_max_mm" => words.say("repeatability RP, largest of all poses"),
        "accuracy_max_mm" => words.say("accuracy AP, largest of all poses"),
        other => other.to_owned(),
    }
}

/// Texts that come from documents instead of the program's reports.
#[cfg(test)]
const OF_DOCUMENTS: [&str; 63] = [
    "base shift",
    "base rotation",
    "before",
    "after",
    "nominal minus identified",
    "zeros",
    "zeros of the joints",
    "geometry",
    "gains",
    "coupling",
    "bending",
    "calibration",
    "validation",
    "position",
    "x",
    "y",
    "z",
    "orientation",
    "error",
    "warning",
    "geometric",
    "plane",
    "line",
    "circle",
    "cylinder",
    "export",
    "log",
    "campaign",
    "table",
    "both",
    "the platform's centre as the balls measure it",
    "the platform's centre C in the base frame",
    "the targets as measured",
    "the targets in the world",
    "instrument",
    "contact",
    "rigid parts",
    "known points",
    "nominal values",
    "repeatability",
    "model",
    "residuals",
    "world frame",
    "frames of poses",
    "scale",
    "temperature",
    "homing",
    "the stated uncertainty of each reading",
    "how well the robot finds a measured point again, as stated",
    "stated shapes of parts that carry targets",
    "stated places and lengths of fixed points",
    "nominal values of the parameters, by their tolerances",
    "what repeats of a pose scatter beyond the instrument",
    "what residuals exceed all of this by: errors of the robot that the model does not describe",
    "scatter of the residuals; no uncertainty is stated",
    "points that define the world frame, in common to all poses",
    "points of the frame that was measured again at each pose",
    "scale of the measuring system, in common to all lengths",
    "temperature, by the expansion of robot and part, in common to all lengths",
    "joint values after homing, in common to all poses",
    "mean position error, validation",
    "root mean square position error, validation",
    "largest position error, validation",
];

/// Texts of reports in one language, and sentences of documents with placeholders.
#[derive(Clone, Debug, Default)]
pub(crate) struct Words {
    language: Language,
    texts: BTreeMap<String, String>,
    sentences: BTreeMap<String, String>,
}

impl Words {
    /// Table of a language; English, the key itself, has an empty table.
    pub fn of(language: Language) -> Result<Self> {
        let (texts, sentences) = match language {
            Language::En => return Ok(Self::default()),
            Language::Fr => (include_str!("words/fr.toml"), include_str!("words/documents.fr.toml")),
            Language::De => (include_str!("words/de.toml"), include_str!("words/documents.de.toml")),
        };
        let table = |text| {
            toml::from_str(text)
                .map_err(|e| Message::error(format!("the table of words `{}` does not read: {e}", language.code())))
        };
        Ok(Self { language, texts: table(texts)?, sentences: table(sentences)? })
    }

    /// Language code (ISO 639-1).
    pub fn code(&self) -> &'static str {
        self.language.code()
    }

    /// Sentence of a document in this language; `None` without a translation.
    pub fn of_document(&self, sentence: &str) -> Option<String> {
        self.sentences.iter().find_map(|(pattern, translation)| {
            let values = values(pattern, sentence)?;
            let and = self.filled(&self.say("{0} and {1}"), &[&"`", &"`"]);
            let said = |v: &&str| {
                v.split(", ").map(|name| self.said(name)).collect::<Vec<_>>().join(", ").replace("` and `", &and)
            };
            let values: Vec<String> = values.iter().map(said).collect();
            let values: Vec<&dyn Display> = values.iter().map(|v| v as &dyn Display).collect();
            Some(self.filled(translation, &values))
        })
    }

    /// A name in a sentence of a document, or the last of several rows of a file with the number of
    /// further rows.
    fn said(&self, name: &str) -> String {
        let rows = |one: &str| name.strip_suffix(one).and_then(|counted| counted.split_once(" and "));
        match (rows(" more rows"), rows(" more row")) {
            (Some((last, count)), _) => self.fill("{0} and {1} more rows", &[&last, &count]),
            (_, Some((last, count))) => self.fill("{0} and {1} more row", &[&last, &count]),
            _ => self.say(name),
        }
    }

    /// Numbers of a text with the decimal mark of the language; words with letters or several
    /// points are not numbers.
    pub fn number(&self, text: &str) -> String {
        let Some(mark) = self.texts.get(".") else { return text.to_owned() };
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
                Some((whole, decimals)) => out.extend([whole, mark, decimals]),
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

    /// Translation of a text; texts without translation stay in English.
    pub fn say(&self, text: &str) -> String {
        self.texts.get(text).map_or_else(|| text.to_owned(), Clone::clone)
    }

    /// Texts that differ in this language.
    #[cfg(test)]
    pub fn differing(&self) -> impl Iterator<Item = &String> {
        self.texts.iter().filter(|(text, translation)| text != translation).map(|(text, _)| text)
    }

    /// `true` if there is a translation, even if it equals the text.
    #[cfg(test)]
    pub fn translates(&self, text: &str) -> bool {
        self.texts.contains_key(text)
    }

    /// Translation of a text with values for the placeholders `{0}`, `{1}` ...
    pub fn fill(&self, text: &str, values: &[&dyn Display]) -> String {
        self.filled(&self.say(text), values)
    }

    fn filled(&self, text: &str, values: &[&dyn Display]) -> String {
        let mut pieces = text.split('{');
        let mut filled = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            let place = piece.split_once('}').and_then(|(i, rest)| Some((values.get(i.parse::<usize>().ok()?)?, rest)));
            match place {
                Some((value, rest)) => filled.extend([&self.value(value.to_string()), rest]),
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
    use std::collections::BTreeSet;
    use std::path::Path;

    /// Texts for which a file of the report requests a translation.
    fn asked(text: &str, rust: bool, found: &mut BTreeSet<String>) {
        if !rust {
            for (end, _) in
                text.match_indices("\"|t").filter(|(i, _)| !text[i + 3..].starts_with(char::is_alphanumeric))
            {
                let start = text[..end].rfind('"').unwrap();
                found.insert(text[start + 1..end].to_owned());
            }
            return;
        }
        // tests of a file contain results, not requests
        let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
        for call in [
            ".say(",
            ".fill(",
            "meaning(",
            "term(words,",
            ".both(",
            ".page(",
            ".micrometres(",
            ".below(2,",
            ".below(3,",
            ".below(4,",
            ".below(5,",
        ] {
            for (i, _) in text.match_indices(call) {
                let Some(literal) = text[i + call.len()..].trim_start().strip_prefix('"') else { continue };
                let end = literal.match_indices('"').find(|(j, _)| !literal[..*j].ends_with('\\')).unwrap().0;
                found.insert(literal[..end].replace("\\\"", "\""));
            }
        }
    }

    fn all_asked(folder: &Path, found: &mut BTreeSet<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                all_asked(&path, found);
            } else if path.extension().is_some_and(|e| e == "rs" || e == "html") {
                let text = std::fs::read_to_string(&path).unwrap();
                asked(&text, path.extension().is_some_and(|e| e == "rs"), found);
            }
        }
    }

    #[test]
    fn every_text_has_its_translation_and_every_translation_its_text() {
        let mut found: BTreeSet<String> = OF_DOCUMENTS.into_iter().chain(["."]).map(str::to_owned).collect();
        for room in ["report", "math", "fit", "robots", "identify"] {
            all_asked(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(room), &mut found);
        }
        assert!(found.len() > 200, "{}", found.len());
        // symbols and units are equal in all languages
        let is_worded = |text: &&String| text.split(|c: char| !c.is_lowercase()).any(|word| word.len() > 2);
        for language in [Language::Fr, Language::De] {
            let words = Words::of(language).unwrap();
            let missing: Vec<_> =
                found.iter().filter(is_worded).filter(|text| !words.texts.contains_key(*text)).collect();
            let unused: Vec<_> = words.texts.keys().filter(|text| !found.contains(*text)).collect();
            assert!(missing.is_empty() && unused.is_empty(), "{language:?}: missing {missing:#?}, unused {unused:#?}");
        }
    }

    #[test]
    fn a_translation_has_the_places_of_its_text() {
        let places = |text: &str| -> BTreeSet<String> {
            text.split('{').skip(1).map(|piece| piece.split('}').next().unwrap().to_owned()).collect()
        };
        for language in [Language::Fr, Language::De] {
            let words = Words::of(language).unwrap();
            for (text, translation) in words.texts.into_iter().chain(words.sentences) {
                assert_eq!(places(&text), places(&translation), "{language:?}: {text}");
                assert!(!translation.trim().is_empty() && translation.trim() == translation, "{text}");
            }
        }
    }

    #[test]
    fn values_stand_in_their_places_and_are_not_read_again() {
        let words = Words::default();
        assert_eq!(words.fill("{1} of {0}, {x} {7", &[&"{1}", &2]), "2 of {1}, {x} {7");
        assert_eq!(Words::of(Language::De).unwrap().say("no such text"), "no such text");
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
        assert_eq!(german.fill("{0}: {1}", &[&"ball 1.5", &"0.25 mm"]), "ball 1.5: 0,25 mm");
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
