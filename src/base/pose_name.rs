//! Names of poses: integers or other texts.

use super::cell::is_formula;
use super::message::Message;
use crate::catalogue::{Argument, IntoArgument};
use crate::error;
use crate::phrase;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::{Mutex, PoisonError};
use unicode_normalization::UnicodeNormalization;

/// Name of a pose: an integer (`7`, `07`), or any other text, as written (`home`, `A-3`, `P7`).
///
/// Numbers sort before texts, texts in natural order: `P2` before `P10`.
///
/// # Examples
///
/// ```
/// use etalon_base::message::Message;
/// use etalon_base::pose_name::PoseName;
///
/// assert_eq!(PoseName::new("07")?, 7);
///
/// // numbers first, then texts in natural order
/// let mut poses = [PoseName::new("P10")?, PoseName::new("P2")?, PoseName::new("12")?];
/// poses.sort();
/// assert_eq!(poses.map(|pose| pose.to_string()), ["12", "P2", "P10"]);
///
/// assert!(PoseName::new("=A1+1").is_err(), "a spreadsheet would compute it");
/// # Ok::<(), Message>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PoseName {
    /// Integer.
    Number(i64),
    /// Other text; every text is stored once, until the program ends.
    Text(&'static str),
}

/// All texts of poses so far.
static TEXTS: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());

/// Maximum length of a name (characters).
const LONGEST: usize = 100;

impl PoseName {
    /// Parses a name without surrounding blanks, in the composed form of Unicode (NFC): `ü` is one
    /// letter, however a program wrote it. Names that a table or spreadsheet cannot hold are
    /// errors.
    pub fn new(name: &str) -> Result<Self, Message> {
        let name = name.trim();
        let composed: String;
        let name = if name.is_ascii() {
            name
        } else {
            composed = name.nfc().collect();
            &composed
        };
        if let Ok(number) = name.parse() {
            return Ok(Self::Number(number));
        }
        if name.is_empty() {
            return Err(error!("pose-name-empty"));
        }
        if name.len() > LONGEST {
            return Err(error!("pose-name-too-long", characters = name.chars().count(), most = LONGEST));
        }
        if name.contains(char::is_control) || is_formula(name) {
            return Err(error!("pose-name-unprintable", name = name.escape_debug().to_string()));
        }
        let mut texts = TEXTS.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(Self::Text(texts.get(name).copied().unwrap_or_else(|| {
            let stored: &'static str = Box::leak(name.into());
            texts.insert(stored);
            stored
        })))
    }

    /// Number of the pose, if it is an integer.
    pub fn number(self) -> Option<i64> {
        match self {
            Self::Number(number) => Some(number),
            Self::Text(_) => None,
        }
    }

    /// Name without case, blanks, `_`, `-`, leading zeros and invisible characters; names with
    /// equal folded form are spellings of one name.
    fn folded(self) -> String {
        let mut folded = String::new();
        for part in parts(&visible(&self.to_string()).to_lowercase()) {
            match part {
                Part::Digits(digits) => folded.push_str(if digits.is_empty() { "0" } else { digits }),
                Part::Other(c) if matches!(c, '_' | '-') || c.is_whitespace() => {}
                Part::Other(c) => folded.push(c),
            }
        }
        folded
    }
}

/// Finds the first pose that is another spelling of an earlier one (`P1` and `p 01`): message and
/// index. A number is spelled in another way only by invisible characters.
pub fn two_spellings(names: impl IntoIterator<Item = Option<PoseName>>) -> Option<(Message, usize)> {
    let mut known: BTreeSet<PoseName> = BTreeSet::new();
    let mut by_spelling: BTreeMap<Spelling, PoseName> = BTreeMap::new();
    for (i, name) in names.into_iter().enumerate() {
        let Some(name) = name.filter(|name| known.insert(*name)) else { continue };
        let spelling = match name {
            PoseName::Number(number) => Spelling::Number(number),
            PoseName::Text(text) => {
                visible(text).trim().parse().map_or_else(|_| Spelling::Text(name.folded()), Spelling::Number)
            }
        };
        if let Some(other) = by_spelling.insert(spelling, name) {
            return Some((error!("pose-name-two-spellings", first = escaped(other), second = escaped(name)), i));
        }
    }
    None
}

/// Form in which names are compared.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Spelling {
    Number(i64),
    Text(String),
}

/// `true` for a character without a picture of its own (Unicode: `Default_Ignorable_Code_Point`).
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}'
        | '\u{180b}'..='\u{180f}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}'
        | '\u{3164}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{ffa0}' | '\u{fff0}'..='\u{fff8}'
        | '\u{e0000}'..='\u{e0fff}')
}

/// Name without invisible characters.
fn visible(name: &str) -> String {
    name.chars().filter(|c| !is_invisible(*c)).collect()
}

/// Name with the codes of its invisible characters.
fn escaped(name: PoseName) -> String {
    let mut shown = String::new();
    for c in name.to_string().chars() {
        match is_invisible(c) {
            true => shown.extend(c.escape_unicode()),
            false => shown.push(c),
        }
    }
    shown
}

impl IntoArgument for PoseName {
    fn argument(&self) -> Argument {
        self.to_string().argument()
    }
}

impl Default for PoseName {
    fn default() -> Self {
        Self::Number(0)
    }
}

impl From<i64> for PoseName {
    fn from(number: i64) -> Self {
        Self::Number(number)
    }
}

impl PartialEq<i64> for PoseName {
    fn eq(&self, number: &i64) -> bool {
        *self == Self::Number(*number)
    }
}

impl fmt::Display for PoseName {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::Text(text) => f.pad(text),
        }
    }
}

impl Ord for PoseName {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => a.cmp(b),
            (Self::Number(_), Self::Text(_)) => Ordering::Less,
            (Self::Text(_), Self::Number(_)) => Ordering::Greater,
            (Self::Text(a), Self::Text(b)) => parts(a).cmp(parts(b)).then_with(|| a.cmp(b)),
        }
    }
}

impl PartialOrd for PoseName {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Unit of natural order: runs of digits compare as numbers, everything else character by
/// character.
#[derive(PartialEq, Eq)]
enum Part<'a> {
    /// Digits without leading zeros.
    Digits(&'a str),
    Other(char),
}

impl Ord for Part<'_> {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Digits(a), Self::Digits(b)) => a.len().cmp(&b.len()).then_with(|| a.cmp(b)),
            (Self::Digits(_), Self::Other(_)) => Ordering::Less,
            (Self::Other(_), Self::Digits(_)) => Ordering::Greater,
            (Self::Other(a), Self::Other(b)) => a.cmp(b),
        }
    }
}

impl PartialOrd for Part<'_> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

fn parts(mut rest: &str) -> impl Iterator<Item = Part<'_>> {
    std::iter::from_fn(move || {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        if digits > 0 {
            let (run, after) = rest.split_at(digits);
            rest = after;
            return Some(Part::Digits(run.trim_start_matches('0')));
        }
        let mut all = rest.chars();
        let first = all.next()?;
        rest = all.as_str();
        Some(Part::Other(first))
    })
}

impl Serialize for PoseName {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(number) => serializer.serialize_i64(*number),
            Self::Text(text) => serializer.serialize_str(text),
        }
    }
}

impl<'de> Deserialize<'de> for PoseName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumberOrText;
        impl Visitor<'_> for NumberOrText {
            type Value = PoseName;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("the number or the name of a pose")
            }
            fn visit_i64<E: de::Error>(self, number: i64) -> Result<PoseName, E> {
                Ok(PoseName::Number(number))
            }
            fn visit_u64<E: de::Error>(self, number: u64) -> Result<PoseName, E> {
                number.try_into().map(PoseName::Number).map_err(|_| E::custom(phrase!("pose-number-too-large")))
            }
            fn visit_str<E: de::Error>(self, name: &str) -> Result<PoseName, E> {
                PoseName::new(name).map_err(|message| E::custom(message.what))
            }
        }
        deserializer.deserialize_any(NumberOrText)
    }
}

crate::schema_by_hand!(inline PoseName, _ => schemars::json_schema!({ "anyOf": [{ "type": "integer" }, { "type": "string" }] }));

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> PoseName {
        PoseName::new(name).unwrap()
    }

    #[test]
    fn a_pose_has_a_number_or_a_name() {
        for (name, number) in [("7", 7), ("07", 7), (" 12 ", 12), ("-3", -3)] {
            assert_eq!(named(name), number, "{name}");
        }
        for name in ["home", "P_home", "A-3", "10b", "P7", "pose 012", "3E1", "Prüf"] {
            assert_eq!(named(name).to_string(), name);
            assert_eq!(named(name), named(name));
        }
        for wrong in ["", " ", "=1+1", "@a", "-a", "a\nb", &"n".repeat(101)] {
            assert!(PoseName::new(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn numbers_come_first_and_names_in_natural_order() {
        let sorted = ["-1", "2", "10", "10b", "A-3", "P", "P2", "P02", "P2a", "P10", "home"];
        let mut names: Vec<PoseName> = sorted.iter().rev().map(|name| named(name)).collect();
        names.sort();
        assert_eq!(names.iter().map(ToString::to_string).collect::<Vec<_>>(), {
            let mut expected = sorted;
            // equal numbers are ordered by their texts
            expected.swap(6, 7);
            expected
        });
    }

    #[test]
    fn two_spellings_of_one_name_are_found() {
        let found = |names: &[&str]| two_spellings(names.iter().map(|name| PoseName::new(name).ok()));
        for pair in [["P1", "p1"], ["P01", "P1"], ["P_1", "P-1"], ["home", "Home"], ["pose 2", "pose2"]] {
            let (message, at) = found(&["7", pair[0], "A1", "B1", pair[1]]).unwrap();
            let names: [(&str, &dyn IntoArgument); 2] = [("first", &pair[0]), ("second", &pair[1])];
            assert!(message.is("pose-name-two-spellings", &names) && at == 4, "{message:?}");
        }
        assert!(found(&["7", "07", "P7", "P70", "A1", "B1", "10", "10b", "P1", "1-1", "11", "1_"]).is_none());
        // a character that nobody sees is shown by its code
        for (first, second, code) in [
            ("P1", "P1\u{200b}", "P1\\u{200b}"),
            ("P1", "\u{feff}P1", "\\u{feff}P1"),
            ("7", "7\u{200b}", "7\\u{200b}"),
            ("home", "ho\u{ad}me", "ho\\u{ad}me"),
        ] {
            let (message, at) = found(&["A1", first, second]).unwrap();
            let names: [(&str, &dyn IntoArgument); 2] = [("first", &first), ("second", &code)];
            assert!(message.is("pose-name-two-spellings", &names) && at == 2, "{message:?}");
        }
    }

    #[test]
    fn the_forms_of_a_letter_are_one_name() {
        for (composed, decomposed) in [("Pr\u{fc}f", "Pru\u{308}f"), ("\u{c5}1", "A\u{30a}1"), ("\u{c5}1", "\u{212b}1")]
        {
            assert_eq!(named(composed), named(decomposed));
            assert_eq!(named(decomposed).to_string(), composed);
        }
    }
}
