//! Reference data inside the program, their hashes, and seeded faults in them.

use super::embedded::{CAMPAIGNS, FILES, SAMPLE, SHA256};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_documents::ReferenceFile;
use serde_json::{Map, Value};

/// Hashes of the embedded files, and the hashes in the program.
pub(super) fn files() -> Vec<ReferenceFile> {
    let expected = |name: &str| {
        let line = SHA256.lines().find_map(|line| line.strip_suffix(name)?.strip_suffix("  "));
        line.unwrap_or_default()
    };
    let json = FILES.iter().map(|(name, text)| (format!("{name}.json"), *text));
    let campaign = SAMPLE.iter().map(|(name, text)| (format!("prexyt-cmm/{name}"), *text));
    let certified = CAMPAIGNS.iter().flat_map(|(folder, values, files)| {
        let all = files.iter().copied().chain([("certified.json", *values)]);
        all.map(move |(name, text)| (format!("reference/{folder}/{name}"), text))
    });
    json.chain(campaign).chain(certified).map(|(name, text)| reference_file(&name, text, expected(&name))).collect()
}

/// Hash of a file of the reference data, and its hash in the program.
fn reference_file(name: &str, text: &str, expected: &str) -> ReferenceFile {
    let sha256 = etalon_base::files::sha256(text.as_bytes());
    ReferenceFile { name: name.to_owned(), pass: sha256 == expected, sha256, expected_sha256: expected.to_owned() }
}

/// Reference data by the name of their file.
#[derive(Clone, Debug)]
pub(super) struct Data(Value);

impl Data {
    /// The data that are part of the program.
    pub fn embedded() -> Result<Self> {
        let mut all = Map::new();
        for (name, text) in FILES {
            let value = serde_json::from_str(text)
                .map_err(|e| error!("selftest-data-unreadable", name, reason = e.to_string()))?;
            all.insert(name.to_owned(), value);
        }
        let truth = SAMPLE.iter().find(|(name, _)| *name == "truth.toml").map_or("", |(_, text)| *text);
        let truth = toml::from_str(truth)
            .map_err(|e| error!("selftest-data-unreadable", name = "truth", reason = e.message()))?;
        all.insert("truth".to_owned(), truth);
        let mut certified = Map::new();
        for (name, text, _) in CAMPAIGNS {
            let value = serde_json::from_str(text)
                .map_err(|e| error!("selftest-data-unreadable", name, reason = e.to_string()))?;
            certified.insert((*name).to_owned(), value);
        }
        all.insert("certified".to_owned(), Value::Object(certified));
        Ok(Self(Value::Object(all)))
    }

    /// Part of the data, by a JSON pointer (RFC 6901); null if it is missing.
    pub fn at(&self, pointer: &str) -> Self {
        Self(self.0.pointer(pointer).cloned().unwrap_or_default())
    }

    /// Items of a list.
    pub fn items(&self) -> Vec<Self> {
        self.0.as_array().map(|all| all.iter().cloned().map(Self).collect()).unwrap_or_default()
    }

    /// Entries of an object.
    pub fn entries(&self) -> Vec<(String, f64)> {
        let all = self.0.as_object().into_iter().flatten();
        all.map(|(name, value)| (name.clone(), number(value))).collect()
    }

    /// A number; NaN if it is missing.
    pub fn number(&self, pointer: &str) -> f64 {
        self.0.pointer(pointer).map_or(f64::NAN, number)
    }

    /// A list of numbers, or of lists of numbers, one behind the other.
    pub fn numbers(&self, pointer: &str) -> Vec<f64> {
        let mut all = Vec::new();
        flatten(self.0.pointer(pointer).unwrap_or(&Value::Null), &mut all);
        all
    }

    /// A list of points.
    pub fn points(&self, pointer: &str) -> Vec<Vector> {
        self.numbers(pointer).chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect()
    }

    /// A list of texts.
    pub fn texts(&self, pointer: &str) -> Vec<&str> {
        let all = self.0.pointer(pointer).and_then(Value::as_array).into_iter().flatten();
        all.filter_map(Value::as_str).collect()
    }

    /// A text; empty if it is missing.
    pub fn text(&self, pointer: &str) -> &str {
        self.0.pointer(pointer).and_then(Value::as_str).unwrap_or_default()
    }
}

/// A number, also as decimal text with more digits than a double.
fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().unwrap_or(f64::NAN),
        other => other.as_f64().unwrap_or(f64::NAN),
    }
}

fn flatten(value: &Value, into: &mut Vec<f64>) {
    match value {
        Value::Array(all) => all.iter().for_each(|item| flatten(item, into)),
        Value::Null => {}
        other => into.push(number(other)),
    }
}

/// A seeded fault in the reference data that a comparison must notice.
#[derive(Debug)]
pub(super) enum Slip {
    /// A wrong digit: this significant digit of a number, from 1.
    Digit(&'static str, usize),
    /// Two swapped values.
    Swap(&'static str, &'static str),
    /// Another unit: all numbers below a pointer by this factor.
    Unit(&'static str, f64),
}

impl Slip {
    /// Name of the fault.
    pub fn phrase(&self) -> Phrase {
        let place = |pointer: &str| pointer.trim_start_matches('/').replace('/', ".");
        match self {
            Self::Digit(at, digit) => phrase!("selftest-wrong-digit", digit, place = place(at)),
            Self::Swap(at, other) => phrase!("selftest-swapped", first = place(at), second = place(other)),
            Self::Unit(at, factor) => phrase!("selftest-wrong-unit", factor, place = place(at)),
        }
    }

    /// The data with the fault.
    pub fn applied(&self, data: &Data) -> Data {
        let mut value = data.0.clone();
        match self {
            Self::Digit(at, digit) => {
                if let Some(number) = value.pointer_mut(at) {
                    *number = wrong_digit(number, *digit);
                }
            }
            Self::Swap(at, other) => {
                let [first, second] = [at, other].map(|at| value.pointer(at).cloned().unwrap_or_default());
                for (at, new) in [(at, second), (other, first)] {
                    if let Some(old) = value.pointer_mut(at) {
                        *old = new;
                    }
                }
            }
            Self::Unit(at, factor) => {
                if let Some(below) = value.pointer_mut(at) {
                    scale(below, *factor);
                }
            }
        }
        Data(value)
    }
}

/// A number whose significant digit `digit` is one more; nine becomes zero.
fn wrong_digit(value: &Value, digit: usize) -> Value {
    let text = match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let mantissa = text.find(['e', 'E']).unwrap_or(text.len());
    let is_digit = |(i, c): &(usize, char)| *i < mantissa && c.is_ascii_digit();
    let significant = text.char_indices().filter(is_digit).skip_while(|(_, c)| *c == '0');
    let changed = significant.skip(digit - 1).take(1).last().map(|(at, c)| {
        let next = (c as u8 - b'0' + 1) % 10;
        format!("{}{next}{}", &text[..at], &text[at + 1..])
    });
    Value::String(changed.unwrap_or(text))
}

fn scale(value: &mut Value, factor: f64) {
    match value {
        Value::Array(all) => all.iter_mut().for_each(|item| scale(item, factor)),
        Value::Object(all) => all.values_mut().for_each(|item| scale(item, factor)),
        Value::Null | Value::Bool(_) => {}
        other => *other = number(other).mul_add(factor, 0.0).into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_byte_of_the_reference_data_is_reported() {
        assert!(files().iter().all(|file| file.pass), "{:?}", files());
        let (name, text) = FILES[0];
        let expected = etalon_base::files::sha256(text.as_bytes());
        assert!(reference_file(name, text, &expected).pass);
        assert!(!reference_file(name, &text.replacen('1', "2", 1), &expected).pass);
        // a file without a given hash
        assert!(!reference_file(name, text, "").pass);
    }

    #[test]
    fn a_slip_changes_what_it_names() {
        let data = Data(serde_json::json!({ "a": ["0.01250", 2.5], "b": 3, "c": -7.1e-3 }));
        let digit = Slip::Digit("/a/0", 3).applied(&data);
        assert_eq!(digit.numbers("/a"), [0.0126, 2.5]);
        assert_eq!(Slip::Digit("/c", 2).applied(&data).number("/c"), -0.0072);
        assert_eq!(Slip::Swap("/a/1", "/b").applied(&data).numbers("/a"), [0.0125, 3.0]);
        assert_eq!(Slip::Unit("/a", 2.0).applied(&data).numbers("/a"), [0.025, 5.0]);
        assert!(data.number("/missing").is_nan());
    }
}
