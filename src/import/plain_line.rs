//! Lines of a label and numbers, read in one pass over their bytes.

use super::number::number;
use crate::import::format::Decimal;

/// A line that is longer is not plain.
pub(super) const LONGEST: usize = 4096;
/// Powers of ten that are exact.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

const WHOLE_TENS: [u64; 9] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

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
    #[inline]
    pub fn label(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        self.short_label().or_else(|| self.any_label())
    }

    /// A label of less than sixteen bytes that its separator ends at once.
    #[inline]
    fn short_label(&mut self) -> Option<&'a [u8]> {
        let rest = &self.bytes[self.at..];
        let separator = self.delimiter.unwrap_or(b' ');
        let [first, second] =
            [0, 8].map(|from| rest.get(from..)?.first_chunk().map(|word| first_stop(*word, separator)));
        let length = match first? {
            8 => 8 + second?,
            length => length,
        };
        let plain = !matches!(rest.first(), None | Some(b'"' | 0xef)) && (1..16).contains(&length);
        if !plain || rest.get(length) != Some(&separator) {
            return None;
        }
        self.at += length + usize::from(self.delimiter.is_some());
        Some(&rest[..length])
    }

    fn any_label(&mut self) -> Option<&'a [u8]> {
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

    /// Takes up digits behind those that `value` has, and says how many there were; of more than 19 the value is lost.
    #[inline(always)]
    fn digits(&mut self, mut value: u64) -> (u64, usize) {
        let start = self.at;
        loop {
            let (more, count) = eight(&self.bytes[self.at..]);
            value = value.wrapping_mul(WHOLE_TENS[count]).wrapping_add(more);
            self.at += count;
            if count < 8 {
                return (value, self.at - start);
            }
        }
    }

    /// A number, and what separates it from the next field, if anything does.
    pub fn number(&mut self) -> Option<f64> {
        self.skip_blanks();
        let start = self.at;
        let negative = self.peek() == Some(b'-');
        self.at += usize::from(negative);
        let (whole, before) = self.digits(0);
        let (mantissa, behind) = match self.peek() {
            Some(b'.') => {
                self.at += 1;
                self.digits(whole)
            }
            _ => (whole, 0),
        };
        let plain = matches!(self.peek(), None | Some(b' ' | b'\t' | b'\r' | b'\n')) || self.peek() == self.delimiter;
        // W. D. Clinger, How to read floating point numbers accurately, 1990: both operands are exact
        let value = if plain && (1..=19).contains(&(before + behind)) && mantissa <= 1 << 53 {
            let value = mantissa as f64 / TENS[behind];
            // signs come as they please: a bit is quicker than a branch
            f64::from_bits(value.to_bits() | u64::from(negative) << 63)
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

/// Line feeds in a text: counted in bytes, which take an eighth of the registers that words would.
pub(super) fn line_feeds(text: &[u8]) -> usize {
    let few = |bytes: &[u8]| bytes.iter().map(|b| u8::from(*b == b'\n')).sum::<u8>();
    text.chunks(255).map(|bytes| usize::from(few(bytes))).sum()
}

/// Bytes in front of the first separator, blank or control character.
#[inline(always)]
fn first_stop(word: [u8; 8], separator: u8) -> usize {
    let ones = u64::from_le_bytes([1; 8]);
    let high = ones << 7;
    let word = u64::from_le_bytes(word);
    let parted = word ^ (ones * u64::from(separator));
    // right up to the first; behind it borrows may mark what they like
    let stops = (word.wrapping_sub(ones * 0x21) & !word | parted.wrapping_sub(ones) & !parted) & high;
    (stops.trailing_zeros() / 8) as usize
}

/// The number that up to eight digits in front make, and how many they are: all bytes of a word at once
/// (D. Lemire, Number parsing at a gigabyte per second, Software: Practice and Experience 51, 2021).
#[inline(always)]
fn eight(bytes: &[u8]) -> (u64, usize) {
    let word = match bytes.first_chunk() {
        Some(word) => *word,
        None => std::array::from_fn(|i| bytes.get(i).copied().unwrap_or_default()),
    };
    // digits become 0 to 9; from the first that is none upwards, carries may mark what they like
    let word = u64::from_le_bytes(word) ^ 0x3030_3030_3030_3030;
    let other = (word.wrapping_add(0x7676_7676_7676_7676) | word) & 0x8080_8080_8080_8080;
    let count = other.trailing_zeros() / 8;
    if count == 0 {
        return (0, 0);
    }
    let digits = word << (64 - 8 * count);
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = pairs.wrapping_mul(100).wrapping_add(pairs >> 16) & 0x0000_ffff_0000_ffff;
    let all = fours.wrapping_mul(10_000).wrapping_add(fours >> 32) & 0xffff_ffff;
    (all, count as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_takes_the_digits_in_front_whatever_follows() {
        for digits in ["", "0", "7", "09", "123", "0045", "99999", "123456", "9876543", "98765432", "00000001"] {
            for behind in ["", ".", " 5", "/", ":", "\u{e9}", "\0", "\n12", "a1234567", "\u{10ffff}99999"] {
                let text = format!("{digits}{behind}");
                let expected = (digits.parse().unwrap_or(0), digits.len());
                assert_eq!(eight(text.as_bytes()), expected, "{text:?}");
            }
        }
        assert_eq!(eight(b"1234567890"), (12_345_678, 8));
    }
}
