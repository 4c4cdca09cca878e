//! Words for units in heads of files, in the languages of measuring software.

/// Returns the unit that a word names, spelled as in the keys of a campaign.
///
/// A lone `M` is no unit: it may mean "measured".
pub fn unit_word(word: &str) -> Option<&'static str> {
    let word = word.trim();
    if word == "M" {
        return None;
    }
    Some(match word.to_lowercase().trim_end_matches('.') {
        "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" | "millimètre" | "millimètres"
        | "millimetri" | "milimetros" | "milímetros" | "毫米" | "ミリ" | "ミリメートル" => "mm",
        "m" | "metre" | "metres" | "meter" | "meters" | "mètre" | "mètres" | "metri" | "metros" | "米" | "メートル" => {
            "m"
        }
        "cm" | "centimetre" | "centimetres" | "centimeter" | "centimeters" | "zentimeter" | "centimètre"
        | "centimètres" | "centimetri" | "centimetros" | "centímetros" | "厘米" | "センチ" => "cm",
        // micro sign, Greek mu
        "um" | "\u{b5}m" | "\u{3bc}m" | "micron" | "microns" | "微米" | "ミクロン" => "um",
        "in" | "inch" | "inches" | "\"" | "zoll" | "pouce" | "pouces" | "pulgada" | "pulgadas" | "英寸" | "インチ" => {
            "inch"
        }
        "deg" | "\u{b0}" | "degree" | "degrees" | "grad" | "degre" | "degres" | "degré" | "degrés" | "gradi"
        | "grados" | "度" => "deg",
        "rad" | "radian" | "radians" | "radianti" | "radianes" | "radiant" | "弧度" | "ラジアン" => "rad",
        "gon" | "gons" | "grads" | "grade" | "grades" => "gon",
        "s" | "sec" | "secs" | "second" | "seconds" | "sek" | "sekunden" | "secondes" | "secondi" | "segundos"
        | "秒" => "s",
        "ms" | "msec" | "msecs" | "millisecond" | "milliseconds" | "毫秒" | "ミリ秒" => "ms",
        "us" | "\u{b5}s" | "\u{3bc}s" | "usec" | "usecs" | "microsecond" | "microseconds" => "us",
        "ns" | "nsec" | "nsecs" | "nanosec" | "nanosecs" | "nanosecond" | "nanoseconds" => "ns",
        "c" | "\u{b0}c" | "degc" | "celsius" | "℃" => "C",
        "k" | "kelvin" => "K",
        _ => return None,
    })
}

/// `true` for a unit of another quantity than lengths, angles, times and temperatures: velocities,
/// accelerations, forces, shares, and places on a screen.
pub fn is_other_unit(word: &str) -> bool {
    let word = word.trim();
    if ["g", "Nm", "N.m", "N\u{b7}m", "N*m", "N m", "kN", "Nmm"].contains(&word) {
        return true;
    }
    let word = word.to_lowercase();
    const WORDS: [&str; 15] = [
        "dps", "rpm", "ma", "mv", "\u{b5}t", "\u{3bc}t", "gauss", "px", "pixel", "pixels", "%", "pa", "hpa", "bar",
        "mbar",
    ];
    // a length or an angle per second
    let per_second = word.split_once('/').is_some_and(|(of, per)| {
        unit_word(of).is_some() && ["s", "sec", "s^2", "s2", "s\u{b2}", "s/s", "min", "h"].contains(&per.trim())
    }) || word.split_once([' ', '*', '\u{b7}']).is_some_and(|(of, per)| {
        unit_word(of).is_some() && ["s^-", "s-", "s\u{207b}"].iter().any(|power| per.starts_with(power))
    });
    WORDS.contains(&word.as_str()) || per_second
}

/// `true` for a word that names gons in English, French and Italian surveying and degrees in
/// German.
pub fn is_grad(word: &str) -> bool {
    word.trim().trim_end_matches('.').eq_ignore_ascii_case("grad")
}

/// Returns the unit of a cell that names nothing else: `mm`, `[mm]`, `(m)`.
pub fn unit_cell(cell: &str) -> Option<&'static str> {
    unit_word(without_brackets(cell))
}

/// Returns the text of a cell without the brackets around it.
pub(crate) fn without_brackets(cell: &str) -> &str {
    let cell = cell.trim();
    let inside = |open: char, close: char| cell.strip_prefix(open).and_then(|rest| rest.strip_suffix(close));
    inside('[', ']').or(inside('(', ')')).or(inside('<', '>')).unwrap_or(cell)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_other_quantities_are_no_lengths_and_no_angles() {
        for unit in [
            "m/s",
            "mm/s",
            "rad/s",
            "\u{b0}/s",
            "deg/s^2",
            "m/s\u{b2}",
            "m/s/s",
            "rad s^-1",
            "m*s-2",
            "g",
            "Nm",
            "dps",
            "px",
            "%",
            "mm/min",
        ] {
            assert!(is_other_unit(unit), "{unit}");
        }
        // letters of names, counts of an encoder, and a nanometre
        for unit in ["mm", "m", "deg", "s", "A", "V", "N", "nm", "counts", "Hz", "1/s", "x/s", ""] {
            assert!(!is_other_unit(unit), "{unit}");
        }
    }
}
