//! Numbers in stated marks, read strictly: nothing around them, nothing guessed.

use crate::base::message::Message;
use crate::import::format::Decimal;
use crate::import::format::Thousands;

/// Whole numbers up to here are exact.
pub(super) const WHOLE: f64 = 9e15;

/// The smallest double written out has fewer characters; what is longer is no number, and is not looked through.
const LONGEST: usize = 1100;

/// A number in the stated decimal mark, nothing else around it.
pub(super) fn number(field: &str, decimal: Decimal) -> Result<f64, Message> {
    marked(field, decimal, None)
}

/// A number in the stated decimal and thousands marks, correctly rounded. Exponents may be `e+003`, `E001` or Fortran's
/// `D+01`, the minus may be U+2212.
pub(super) fn marked(field: &str, decimal: Decimal, thousands: Option<Thousands>) -> Result<f64, Message> {
    if field.len() > LONGEST {
        let start: String = field.chars().take(40).collect();
        let what = format!("`{start}...` is no number: it has {} characters", field.len());
        return Err(Message::error(what).expected(format!("a number with decimal mark `{}`", decimal.name())));
    }
    let plain = |b: u8| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E');
    let value = match decimal == Decimal::Point && thousands.is_none() && field.bytes().all(plain) {
        true => field.parse().ok(),
        false => unmarked(field, decimal, thousands).and_then(|text| text.parse().ok()),
    };
    value.filter(|v: &f64| v.is_finite()).ok_or_else(|| wrong(field, decimal, thousands))
}

/// The number as Rust reads it, if it has no characters but its marks, digits and an exponent.
fn unmarked(field: &str, decimal: Decimal, thousands: Option<Thousands>) -> Option<String> {
    let mark = if decimal == Decimal::Point { '.' } else { ',' };
    let (whole, rest) = field.split_at(field.find([mark, 'e', 'E', 'd', 'D']).unwrap_or(field.len()));
    let whole = match thousands {
        Some(thousands) => ungrouped(whole, thousands)?,
        None => whole.to_owned(),
    };
    let plain = |c: char| match c {
        '\u{2212}' => Some('-'),
        'd' | 'D' => Some('e'),
        c if c == mark => Some('.'),
        // words that `parse` would take for infinity or NaN are no measured values
        '0'..='9' | '+' | '-' | 'e' | 'E' => Some(c),
        _ => None,
    };
    whole.chars().chain(rest.chars()).map(plain).collect()
}

/// The whole part without its marks, which must stand between groups of three digits.
fn ungrouped(whole: &str, thousands: Thousands) -> Option<String> {
    let mut groups = whole.split(|c| thousands.is(c));
    let first = groups.next()?;
    let rest: Vec<&str> = groups.collect();
    let digits = |text: &str| text.bytes().filter(u8::is_ascii_digit).count();
    let three = |group: &&str| group.len() == 3 && digits(group) == 3;
    let grouped = rest.iter().all(three) && (rest.is_empty() || matches!(digits(first), 1..=3));
    grouped.then(|| [&[first], &rest[..]].concat().concat())
}

fn wrong(field: &str, decimal: Decimal, thousands: Option<Thousands>) -> Message {
    let message = Message::error(format!("`{field}` is no number"));
    let (other, hint) = match decimal {
        Decimal::Point => (',', "a decimal comma? then state `decimal = \",\"`"),
        Decimal::Comma => ('.', "a decimal point? then state `decimal = \".\"`"),
    };
    let grouped = |mark: Thousands| marked(field, decimal, Some(mark)).is_ok();
    let marks = [Thousands::Comma, Thousands::Point, Thousands::Apostrophe, Thousands::Blank];
    let mut hints = Vec::new();
    if thousands.is_none() {
        if field.contains(other) {
            hints.push(hint.to_owned());
        }
        // a mark that is the decimal mark is none of thousands
        let possible = marks.into_iter().filter(|m| m.name() != decimal.name() && field.contains(|c| m.is(c)));
        hints.extend(
            possible
                .filter(|m| grouped(*m))
                .map(|m| format!("groups of three digits? then state `thousands = \"{}\"`", m.name())),
        );
    }
    let with = thousands.map(|t| format!(", and `{}` between groups of three digits", t.name())).unwrap_or_default();
    let message = message.expected(format!("a number with decimal mark `{}`{with}", decimal.name()));
    if hints.is_empty() { message } else { message.hint(hints.join("; ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_strictly() {
        assert_eq!(number("1,25", Decimal::Comma).unwrap(), 1.25);
        for (field, decimal) in [
            ("1,25", Decimal::Point),
            ("1.25", Decimal::Comma),
            ("nan", Decimal::Point),
            ("inf", Decimal::Point),
            ("1 000", Decimal::Point),
            ("", Decimal::Point),
            ("1.2.3", Decimal::Point),
            ("1,2,3", Decimal::Comma),
            ("1e999", Decimal::Point),
            ("±2.000", Decimal::Point),
            ("d5", Decimal::Point),
            ("0x1p3", Decimal::Point),
        ] {
            assert!(number(field, decimal).is_err(), "{field}");
        }
    }

    #[test]
    fn endless_digits_are_no_number_and_take_no_time() {
        let begun = std::time::Instant::now();
        let said = number(&"7".repeat(50_000_000), Decimal::Point).unwrap_err().to_string();
        assert!(said.len() < 300 && said.contains("it has 50000000 characters"), "{said}");
        assert!(begun.elapsed().as_secs_f64() < 1.0);
        let smallest = format!("{}", f64::from_bits(1));
        assert_eq!(number(&smallest, Decimal::Point).unwrap().to_bits(), 1);
    }

    #[test]
    fn trap_5_exponents_and_trap_6_unicode_minus() {
        for (field, value) in [
            ("-1.5e+003", -1500.0),
            ("-4.30052E001", -43.0052),
            ("1.5D+01", 15.0),
            ("1.5d-2", 0.015),
            ("\u{2212}2.5", -2.5),
            ("0.", 0.0),
            ("-.5E0", -0.5),
        ] {
            assert_eq!(number(field, Decimal::Point).unwrap().to_bits(), f64::to_bits(value), "{field}");
        }
    }

    #[test]
    fn trap_4_thousands_only_between_groups_of_three() {
        use Thousands::*;
        let (point, comma) = (Decimal::Point, Decimal::Comma);
        for (field, decimal, mark) in [
            ("1,234.5", point, Comma),
            ("1.234,5", comma, Point),
            ("1'234.5", point, Apostrophe),
            ("1 234,5", comma, Blank),
            ("1\u{a0}234.5", point, Blank),
            ("1\u{202f}234.5", point, Blank),
            ("1234.5", point, Comma),
        ] {
            assert_eq!(marked(field, decimal, Some(mark)).unwrap(), 1234.5, "{field}");
        }
        for (field, decimal, mark) in [
            ("1,23.5", point, Comma),
            (",234.5", point, Comma),
            ("1234,567.0", point, Comma),
            ("1.234,5", comma, Comma),
            ("1,234.5,6", point, Comma),
        ] {
            assert!(marked(field, decimal, Some(mark)).is_err(), "{field}");
        }
        let said = number("3 000", point).unwrap_err().to_string();
        assert!(said.contains("thousands = \" \""), "{said}");
    }
}
