//! Dates in ISO 8601.

/// Year, month and day of the Gregorian date `YYYY-MM-DD` at the start of a text.
pub fn date(text: &str) -> Option<(i32, u8, u8)> {
    let (date, rest) = text.split_at_checked(10)?;
    let marks = |(i, c): (usize, char)| if i == 4 || i == 7 { c == '-' } else { c.is_ascii_digit() };
    if rest.starts_with(|c: char| c.is_ascii_digit()) || !date.chars().enumerate().all(marks) {
        return None;
    }
    let (year, month, day): (i32, u8, u8) =
        (date[..4].parse().ok()?, date[5..7].parse().ok()?, date[8..].parse().ok()?);
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let days = match month {
        2 => 28 + u8::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => 0,
    };
    (1..=days).contains(&day).then_some((year, month, day))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_of_the_calendar() {
        assert_eq!(date("2024-02-29"), Some((2024, 2, 29)));
        assert_eq!(date("2026-03-02 to 2026-03-04"), Some((2026, 3, 2)));
        for wrong in [
            "",
            "2026-02-29",
            "2100-02-29",
            "2026-13-01",
            "2026-00-10",
            "2026-04-31",
            "2026-1-31",
            "31.02.2026",
            "+026-01-01",
            "2026-01-011",
        ] {
            assert_eq!(date(wrong), None, "{wrong}");
        }
        assert_eq!(date("2000-02-29"), Some((2000, 2, 29)));
    }
}
