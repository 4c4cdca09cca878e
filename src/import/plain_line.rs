//! Lines of a label and numbers, read in one pass over their bytes.

use super::number::number;
use crate::campaign::Decimal;

/// A line that is longer is not plain.
pub(super) const LONGEST: usize = 4096;
/// Powers of ten that are exact.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// A place in a line.
pub(super) struct Line<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
    /// None: blanks and tabs.
    pub delimiter: Option<u8>,
}

impl<'a> Line<'a> {
    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn skip_blanks(&mut self) {
        while self.peek().is_some_and(|b| b == b' ' || b == b'\t' && self.delimiter != Some(b'\t')) {
            self.at += 1;
        }
    }

    /// Whether the line is empty; if so it is passed.
    pub fn is_blank(&mut self) -> bool {
        let start = self.at;
        self.skip_blanks();
        let empty = matches!(self.peek(), None | Some(b'\n')) || self.bytes[self.at..].starts_with(b"\r\n");
        match empty {
            true => {
                while self.peek().is_some_and(|b| b != b'\n') {
                    self.at += 1
                }
            }
            false => self.at = start,
        }
        self.at += usize::from(empty);
        empty
    }

    /// The label, and what separates it from the next field; none if it may need more than a look.
    pub fn label(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        let start = self.at;
        let stops = |b: u8| match self.delimiter {
            Some(delimiter) => b == delimiter || b == b'\n',
            None => b == b' ' || b == b'\t' || b == b'\n',
        };
        let length = self.bytes[start..].iter().position(|b| stops(*b))?;
        let label = self.bytes[start..start + length].trim_ascii_end();
        self.at = start + length;
        // what begins with a quote, a byte-order mark or a NUL is not plain
        let plain =
            length <= LONGEST && !label.is_empty() && !label.starts_with(b"\"") && !label.starts_with(b"\xef\xbb\xbf");
        (plain && !label.contains(&0) && self.separator()).then_some(label)
    }

    fn separator(&mut self) -> bool {
        match self.delimiter {
            Some(delimiter) => {
                self.skip_blanks();
                let there = self.peek() == Some(delimiter);
                self.at += usize::from(there);
                there
            }
            None => matches!(self.peek(), Some(b' ' | b'\t')),
        }
    }

    /// A number, and what separates it from the next field, if anything does.
    pub fn number(&mut self) -> Option<f64> {
        self.skip_blanks();
        let start = self.at;
        let negative = self.peek() == Some(b'-');
        self.at += usize::from(negative);
        let (mut digits, mut mantissa, mut point) = (0u32, 0u64, None);
        while let Some(b) = self.peek() {
            match b {
                b'0'..=b'9' => {
                    mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(b - b'0'));
                    digits += 1;
                }
                b'.' if point.is_none() => point = Some(digits),
                _ => break,
            }
            self.at += 1;
        }
        let plain = matches!(self.peek(), None | Some(b' ' | b'\t' | b'\r' | b'\n')) || self.peek() == self.delimiter;
        // W. D. Clinger, How to read floating point numbers accurately, 1990: both operands are exact
        let value = if plain && (1..=19).contains(&digits) && mantissa <= 1 << 53 {
            let behind = digits - point.unwrap_or(digits);
            let value = mantissa as f64 / TENS[behind as usize];
            if negative { -value } else { value }
        } else {
            let length = self.bytes[start..]
                .iter()
                .take(LONGEST)
                .position(|b| b.is_ascii_whitespace() || Some(*b) == self.delimiter);
            self.at = length.map_or(self.bytes.len(), |length| start + length);
            number(std::str::from_utf8(&self.bytes[start..self.at]).ok()?, Decimal::Point).ok()?
        };
        // a blank between numbers is no semicolon
        let parted = self.delimiter.is_none() || self.separator() || matches!(self.peek(), None | Some(b'\r' | b'\n'));
        parted.then_some(value)
    }

    /// Whether the line ends here; if so it is passed. Without a line feed it ends at the end of the file alone.
    pub fn end(&mut self, last: bool) -> bool {
        self.skip_blanks();
        if self.peek() == Some(b'\r') {
            self.at += 1;
        }
        match self.peek() {
            Some(b'\n') => {
                self.at += 1;
                true
            }
            None => last,
            _ => false,
        }
    }
}
