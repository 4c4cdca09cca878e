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

/// Year, month and day of a time in seconds since 1970 (UTC), as `SOURCE_DATE_EPOCH` states it;
/// `None` outside the years 1 to 9999. H. Hinnant, chrono-compatible low-level date algorithms,
/// 2021.
pub fn day_of_epoch(seconds: i64) -> Option<(i32, u8, u8)> {
    let days = seconds.div_euclid(86_400) + 719_468;
    let (era, of_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year + 400 * era + i64::from(month <= 2);
    let found = (i32::try_from(year).ok()?, u8::try_from(month).ok()?, u8::try_from(day).ok()?);
    (1..=9999).contains(&found.0).then_some(found)
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

    /// Outside values: `date -u -d @SECONDS`.
    #[test]
    fn days_of_seconds_since_1970() {
        for (seconds, day) in [
            (0, (1970, 1, 1)),
            (86_399, (1970, 1, 1)),
            (951_782_400, (2000, 2, 29)),
            (1_772_409_600, (2026, 3, 2)),
            (-1, (1969, 12, 31)),
            (4_107_542_400, (2100, 3, 1)),
        ] {
            assert_eq!(day_of_epoch(seconds), Some(day), "{seconds}");
        }
        assert_eq!((day_of_epoch(i64::MAX), day_of_epoch(i64::MIN)), (None, None));
    }
}
