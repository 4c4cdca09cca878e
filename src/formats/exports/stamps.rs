//! Dates and times of day in the notation of instruments.

use etalon_base::error;
use etalon_base::message::Message;
use etalon_tables::guess::split_zone;

/// Seconds since the beginning of 1970 of a date and a time of day. If both are in one cell, `date`
/// is empty. A difference from UTC (`+02:00`) is subtracted.
pub(crate) fn seconds(date: &str, time: &str) -> Result<f64, Message> {
    let wrong = || error!("time-invalid", text = format!("{date} {time}").trim());
    let plain = |text: &str| text.trim().trim_start_matches('\'').trim_end_matches('Z').trim().to_owned();
    let (date, time) = (plain(date), plain(time));
    let (date, time) = match date.is_empty() {
        false => (date, time),
        true => {
            let (date, time) = time.split_once(['T', ' ', ',', ';']).unwrap_or(("", &time));
            (date.to_owned(), time.trim().to_owned())
        }
    };
    let (time, zone) = split_zone(&time).map_or((time.as_str(), 0), |(time, zone)| (time, zone));
    let mut parts = time.split(':');
    let mut part = |most: f64| parts.next()?.replace(',', ".").parse::<f64>().ok().filter(|v| (0.0..most).contains(v));
    let (Some(hour), Some(minute)) = (part(24.0), part(60.0)) else { return Err(wrong()) };
    let second = part(61.0).unwrap_or(0.0);
    if parts.next().is_some() || hour.fract() != 0.0 || minute.fract() != 0.0 {
        return Err(wrong());
    }
    let of_day = 3600.0 * hour + 60.0 * (minute - f64::from(zone)) + second;
    if date.is_empty() {
        return Ok(of_day);
    }
    Ok(86_400.0 * days(&date).ok_or_else(wrong)? as f64 + of_day)
}

/// Days since the beginning of 1970; `None` for a text that is not a date, or if day and month
/// could be swapped.
fn days(date: &str) -> Option<i64> {
    let numbers: Vec<i64> = date.split(['.', '-', '/']).map(|part| part.trim().parse().ok()).collect::<Option<_>>()?;
    let (year, month, day) = match numbers[..] {
        [year, month, day] if year > 31 => (year, month, day),
        [day, month, year] if !date.contains('/') || day > 12 => (year, month, day),
        // with slashes the month may be first
        [month, day, year] if day > 12 || day == month => (year, month, day),
        _ => return None,
    };
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) || !(1000..=9999).contains(&year) {
        return None;
    }
    // H. F. Fliegel, T. C. Van Flandern, Communications of the ACM 11, 1968: Julian day number
    let a = (month - 14) / 12;
    let julian =
        (1461 * (year + 4800 + a)) / 4 + (367 * (month - 2 - 12 * a)) / 12 - (3 * ((year + 4900 + a) / 100)) / 4 + day
            - 32_075;
    Some(julian - 2_440_588)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stamps_of_instruments_are_seconds() {
        // `date -u -d "2022-10-11 15:06:48" +%s` gives 1665500808
        for (date, time) in [
            ("", "'11.10.2022 15:06:48.043"),
            ("", "2022-10-11T15:06:48.043Z"),
            ("", "2022-10-11 15:06:48,043"),
            ("", "2022-10-11T17:06:48.043+02:00"),
            ("2022-10-11", "08:06:48.043-07:00"),
            ("11.10.2022", "15:06:48.043"),
            ("2022/10/11", "15:06:48.043"),
        ] {
            assert!((seconds(date, time).unwrap() - 1_665_500_808.043).abs() < 1e-6, "{date} {time}");
        }
        assert_eq!(seconds("", "01:00:01.5").unwrap(), 3601.5);
        assert_eq!(seconds("01.01.1970", "0:00:00").unwrap(), 0.0);
        assert_eq!(seconds("13/02/2024", "00:00").unwrap(), seconds("02/13/2024", "00:00").unwrap());
        // February or November?
        for (date, time) in
            [("11/02/2024", "10:00:00"), ("", "noon"), ("32.01.2024", "10:00"), ("", "25:00:00"), ("a.b.c", "1:00")]
        {
            assert!(seconds(date, time).is_err(), "{date} {time}");
        }
    }
}
