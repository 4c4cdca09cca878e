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
        "ms" | "msec" | "millisecond" | "milliseconds" | "毫秒" | "ミリ秒" => "ms",
        "us" | "\u{b5}s" | "\u{3bc}s" | "usec" | "microsecond" | "microseconds" => "us",
        "ns" | "nsec" | "nanosecond" | "nanoseconds" => "ns",
        "c" | "\u{b0}c" | "degc" | "celsius" | "℃" => "C",
        "k" | "kelvin" => "K",
        _ => return None,
    })
}

/// `true` for a word that names gons in English, French and Italian surveying and degrees in
/// German.
pub fn is_grad(word: &str) -> bool {
    word.trim().trim_end_matches('.').eq_ignore_ascii_case("grad")
}

/// Returns the unit of a cell that names nothing else: `mm`, `[mm]`, `(m)`.
pub fn unit_cell(cell: &str) -> Option<&'static str> {
    let cell = cell.trim();
    let inside = |open: char, close: char| cell.strip_prefix(open).and_then(|rest| rest.strip_suffix(close));
    unit_word(inside('[', ']').or(inside('(', ')')).or(inside('<', '>')).unwrap_or(cell))
}
