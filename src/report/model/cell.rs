//! Typed contents of table cells.

use super::text::{Mark, Text};
use crate::number;
use crate::words::Words;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose_name::PoseName;
use serde::{Serialize, Serializer};

/// Content of a cell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Missing,
    /// Value in the unit of the documents, and text on a page.
    Number {
        value: f64,
        shown: String,
    },
    Count(i64),
    Text(Text),
    /// A term of the report; in English where programs read it.
    Term {
        english: String,
        shown: String,
        strong: bool,
    },
    /// Several numbers in one cell.
    Numbers(String),
}

impl Cell {
    pub fn is_missing(&self) -> bool {
        *self == Self::Missing
    }

    /// Applies the decimal mark of a language.
    pub(super) fn numbers(&mut self, words: &Words) {
        if let Some(shown) = self.display_mut() {
            *shown = words.number(shown);
        }
    }

    /// Numbers as shown on a page.
    pub(super) fn display_mut(&mut self) -> Option<&mut String> {
        match self {
            Self::Number { value, shown } => {
                if shown.is_empty() {
                    *shown = number::significant(*value, 6);
                }
                Some(shown)
            }
            Self::Numbers(shown) => Some(shown),
            _ => None,
        }
    }

    pub(super) fn is_number(&self) -> bool {
        matches!(self, Self::Number { .. } | Self::Count(_) | Self::Numbers(_))
    }

    /// Text on a page.
    pub fn display(&self) -> Text {
        match self {
            Self::Missing => Text::default(),
            Self::Number { value, shown } if shown.is_empty() => number::significant(*value, 6).into(),
            Self::Number { shown, .. } | Self::Numbers(shown) | Self::Term { shown, .. } => shown.as_str().into(),
            Self::Count(value) => value.to_string().into(),
            Self::Text(text) => text.clone(),
        }
    }

    /// Text in a workbook, for cells without a number.
    pub fn plain(&self) -> String {
        self.display().plain()
    }
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Displayed {
            text: Text,
            strong: bool,
        }
        Displayed { text: self.display(), strong: matches!(self, Self::Term { strong: true, .. }) }
            .serialize(serializer)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number { value, shown: String::new() }
    }
}

impl From<i64> for Cell {
    fn from(value: i64) -> Self {
        Self::Count(value)
    }
}

impl From<PoseName> for Cell {
    fn from(pose: PoseName) -> Self {
        pose.number().map_or_else(|| Text::from(pose.to_string()).into(), Self::Count)
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        Self::Count(value as i64)
    }
}

impl From<Text> for Cell {
    fn from(text: Text) -> Self {
        if text.is_empty() { Self::Missing } else { Self::Text(text) }
    }
}

impl From<&str> for Cell {
    fn from(name: &str) -> Self {
        Text::new(name.to_owned(), Mark::Name).into()
    }
}

impl From<&String> for Cell {
    fn from(name: &String) -> Self {
        name.as_str().into()
    }
}

impl From<String> for Cell {
    fn from(name: String) -> Self {
        name.as_str().into()
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, Into::into)
    }
}

/// A number with a fixed number of decimals.
pub(crate) fn fixed(value: impl Into<Option<f64>>, decimals: usize) -> Cell {
    number_cell(value, |v| number::fixed(v, decimals))
}

/// A number with its significant digits.
pub(crate) fn significant(value: impl Into<Option<f64>>, digits: usize) -> Cell {
    number_cell(value, |v| number::significant(v, digits))
}

/// A number to the second digit of its standard uncertainty.
pub(crate) fn with_uncertainty(value: impl Into<Option<f64>>, u: Option<f64>) -> Cell {
    number_cell(value, |v| number::with_uncertainty(v, u))
}

/// A length in mm, shown in µm.
pub(crate) fn um(mm: impl Into<Option<f64>>) -> Cell {
    number_cell(mm, |mm| number::fixed(1e3 * mm, 1))
}

/// A number with its text.
pub(crate) fn number_cell(value: impl Into<Option<f64>>, text: impl Fn(f64) -> String) -> Cell {
    value.into().map_or(Cell::Missing, |value| Cell::Number { value, shown: text(value) })
}

/// Several numbers; an empty cell without numbers.
pub(crate) fn numbers(shown: impl Into<Option<String>>) -> Cell {
    shown.into().filter(|s| !s.is_empty()).map_or(Cell::Missing, Cell::Numbers)
}

/// A term, translated where people read it.
pub(crate) fn term(words: &Words, term: Phrase) -> Cell {
    Cell::Term { english: term.to_string(), shown: words.tr(&term), strong: false }
}

/// A term in bold letters.
pub(crate) fn strong_term(words: &Words, term: Phrase) -> Cell {
    Cell::Term { english: term.to_string(), shown: words.tr(&term), strong: true }
}

/// "Yes" or "no".
pub(crate) fn yes_no(words: &Words, yes: bool) -> Cell {
    term(words, if yes { phrase!("yes") } else { phrase!("no") })
}

/// "Yes" in bold letters, or "no".
pub(crate) fn strong_yes(words: &Words, yes: bool) -> Cell {
    if yes { strong_term(words, phrase!("yes")) } else { yes_no(words, false) }
}
