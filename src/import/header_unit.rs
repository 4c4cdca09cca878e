//! The unit of length that a header gives a column.

use crate::import::format::Unit;

/// The unit in brackets or behind the name: `X [mm]`, `y (in)`, `z_um`. A bare `_m` may mean "measured" and says nothing.
pub(super) fn header_unit(name: &str) -> Option<Unit> {
    let bracketed = name.split_once(['[', '(']).and_then(|(_, rest)| rest.split([']', ')']).next()).and_then(unit);
    let behind = || name.rsplit_once(['_', ' ']).and_then(|(_, last)| unit(last)).filter(|u| *u != Unit::Metre);
    bracketed.or_else(behind)
}

fn unit(word: &str) -> Option<Unit> {
    let word = word.trim();
    match word.to_lowercase().as_str() {
        // M may be "measured"
        "m" if word == "M" => None,
        "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" => Some(Unit::Millimetre),
        "m" | "metre" | "metres" | "meter" | "meters" => Some(Unit::Metre),
        // micro sign, Greek mu
        "um" | "\u{b5}m" | "\u{3bc}m" | "micron" | "microns" => Some(Unit::Micrometre),
        "in" | "inch" | "inches" | "\"" => Some(Unit::Inch),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_in_brackets_or_behind_the_name() {
        let of = |name: &str| header_unit(name).map(Unit::name);
        assert_eq!(
            ["X [mm]", "y (in)", "z_um", "X Inch", "x [m]", "\u{b5} [\u{b5}m]"].map(of),
            ["mm", "inch", "um", "inch", "m", "um"].map(Some)
        );
        assert_eq!(["X", "x_m", "x [rad]", "", "[", "X (M)"].map(of), [None; 6]);
    }
}
