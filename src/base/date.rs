//! Dates in ISO 8601.

use crate::error;
use crate::message::Result;

/// Day of the Gregorian calendar. Earlier days are smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Date {
    /// Year.
    pub year: i32,
    /// Month, from 1.
    pub month: u8,
    /// Day of the month, from 1.
    pub day: u8,
}

impl Date {
    /// Returns the date of these numbers, which are not checked.
    pub fn new(year: i32, month: u8, day: u8) -> Self {
        Self { year, month, day }
    }
}

/// Gregorian date `YYYY-MM-DD` at the start of a text.
pub fn date(text: &str) -> Option<Date> {
    let (date, rest) = text.split_at_checked(10)?;
    let marks = |(i, c): (usize, char)| if i == 4 || i == 7 { c == '-' } else { c.is_ascii_digit() };
    if rest.starts_with(|c: char| c.is_ascii_digit()) || !date.chars().enumerate().all(marks) {
        return None;
    }
    let date = Date::new(date[..4].parse().ok()?, date[5..7].parse().ok()?, date[8..].parse().ok()?);
    (1..=days(date.year, date.month)).contains(&date.day).then_some(date)
}

/// Number of days of a month; zero if the month does not exist.
fn days(year: i32, month: u8) -> u8 {
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    match month {
        2 => 28 + u8::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => 0,
    }
}

/// The day of the same number a number of months later; the last day of a month that is too short.
///
/// # Examples
///
/// ```
/// use etalon_base::date::{Date, months_after};
///
/// assert_eq!(months_after(Date::new(2026, 3, 2), 12), Date::new(2027, 3, 2));
/// assert_eq!(months_after(Date::new(2025, 11, 30), 3), Date::new(2026, 2, 28));
/// ```
pub fn months_after(date: Date, months: u32) -> Date {
    let Date { year, month, day } = date;
    let all = i64::from(year) * 12 + i64::from(month) - 1 + i64::from(months);
    let (year, month) = (i32::try_from(all.div_euclid(12)).unwrap_or(i32::MAX), all.rem_euclid(12) as u8 + 1);
    Date::new(year, month, day.min(days(year, month)))
}

/// A date as text: year-month-day.
pub fn date_text(date: Date) -> String {
    let Date { year, month, day } = date;
    format!("{year:04}-{month:02}-{day:02}")
}

/// Day (UTC) that the variable `SOURCE_DATE_EPOCH` gives, if it is set.
///
/// # Errors
/// Fails if the value is not the seconds since 1970, as reproducible-builds.org specifies it.
pub fn source_date_epoch() -> Result<Option<Date>> {
    let Some(value) = std::env::var_os("SOURCE_DATE_EPOCH").filter(|value| !value.is_empty()) else {
        return Ok(None);
    };
    let seconds = value.to_str().and_then(|text| text.trim().parse::<i64>().ok()).filter(|seconds| *seconds >= 0);
    match seconds.and_then(day_of_epoch) {
        Some(day) => Ok(Some(day)),
        None => Err(error!("environment-date", value = value.to_string_lossy().into_owned()).into()),
    }
}

/// Day of a time in seconds since 1970 (UTC), as `SOURCE_DATE_EPOCH` gives it;
/// `None` outside the years 1 to 9999. H. Hinnant, chrono-compatible low-level date algorithms,
/// 2021.
pub fn day_of_epoch(seconds: i64) -> Option<Date> {
    let days = seconds.div_euclid(86_400) + 719_468;
    let (era, of_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year + 400 * era + i64::from(month <= 2);
    let found = Date::new(i32::try_from(year).ok()?, u8::try_from(month).ok()?, u8::try_from(day).ok()?);
    (1..=9999).contains(&found.year).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_of_the_calendar() {
        assert_eq!(date("2024-02-29"), Some(Date::new(2024, 2, 29)));
        assert_eq!(date("2026-03-02 to 2026-03-04"), Some(Date::new(2026, 3, 2)));
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
        assert_eq!(date("2000-02-29"), Some(Date::new(2000, 2, 29)));
    }

    #[test]
    fn a_month_later_is_the_same_day_or_the_last_of_a_shorter_month() {
        for (from, months, until) in [
            ("2026-01-31", 1, "2026-02-28"),
            ("2024-01-31", 1, "2024-02-29"),
            ("2024-02-29", 12, "2025-02-28"),
            ("2024-02-29", 48, "2028-02-29"),
            ("2026-08-31", 6, "2027-02-28"),
            ("2026-12-15", 1, "2027-01-15"),
            ("2026-03-02", 0, "2026-03-02"),
        ] {
            assert_eq!(date_text(months_after(date(from).unwrap(), months)), until, "{from} + {months}");
        }
    }

    /// Outside values: `date -u -d @SECONDS`.
    #[test]
    fn days_of_seconds_since_1970() {
        for (seconds, [year, month, day]) in [
            (0, [1970, 1, 1]),
            (86_399, [1970, 1, 1]),
            (951_782_400, [2000, 2, 29]),
            (1_772_409_600, [2026, 3, 2]),
            (-1, [1969, 12, 31]),
            (4_107_542_400, [2100, 3, 1]),
        ] {
            let expected = Date::new(year, month as u8, day as u8);
            assert_eq!(day_of_epoch(seconds), Some(expected), "{seconds}");
        }
        assert_eq!((day_of_epoch(i64::MAX), day_of_epoch(i64::MIN)), (None, None));
    }
}
