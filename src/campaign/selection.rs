//! Which poses: `"1-8, 12"`, `"all"`, `"rest"`, or `"index mod 10 < 7"`.

use crate::base::message::Message;

/// A set of poses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Selection {
    /// Numbers of poses: ranges with both ends in.
    Ranges(Vec<(i64, i64)>),
    /// Poses whose index, counted from 0 over the poses that remain in their order, modulo the first number is
    /// below the second.
    Modulo(usize, usize),
    /// All poses.
    All,
    /// All poses that the calibration does not take.
    Rest,
}

/// The poses of an identification.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selections {
    /// Poses to identify on.
    pub calibration: Selection,
    /// Poses to test on.
    pub validation: Option<Selection>,
}

impl Selections {
    /// Whether the pose with this number and index is for calibration.
    pub fn calibrates(&self, pose: i64, index: usize) -> bool {
        self.calibration.contains(pose, index, false)
    }

    /// Whether the pose is for validation.
    pub fn validates(&self, pose: i64, index: usize) -> bool {
        let calibrates = self.calibrates(pose, index);
        self.validation.as_ref().is_some_and(|validation| validation.contains(pose, index, calibrates))
    }
}

impl Selection {
    /// Reads a selection.
    pub fn parse(text: &str) -> Result<Self, Message> {
        let wrong = || {
            Message::error(format!("`{text}` names no poses"))
                .expected("numbers and ranges like \"1-8, 12\", \"all\", \"rest\" or \"index mod 10 < 7\"")
        };
        let words: Vec<&str> = text.split_whitespace().collect();
        match words[..] {
            ["all"] => return Ok(Self::All),
            ["rest"] => return Ok(Self::Rest),
            ["index", "mod", n, "<", k] => {
                let (n, k) = (n.parse().map_err(|_| wrong())?, k.parse().map_err(|_| wrong())?);
                return if n > 0 { Ok(Self::Modulo(n, k)) } else { Err(wrong()) };
            }
            _ => {}
        }
        let range = |part: &str| {
            let part = part.trim();
            let (from, to) = part.split_once('-').unwrap_or((part, part));
            Some((from.trim().parse().ok()?, to.trim().parse().ok()?))
        };
        let ranges: Option<Vec<(i64, i64)>> = text.split(',').map(range).collect();
        ranges.filter(|r| r.iter().all(|(from, to)| from <= to)).map(Self::Ranges).ok_or_else(wrong)
    }

    /// Whether the pose with this number and index is in; `taken`: the calibration has it.
    pub fn contains(&self, pose: i64, index: usize, taken: bool) -> bool {
        match self {
            Self::Ranges(ranges) => ranges.iter().any(|&(from, to)| (from..=to).contains(&pose)),
            Self::Modulo(n, k) => index % n < *k,
            Self::All => true,
            Self::Rest => !taken,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn selections() {
        let s = Selection::parse("1-8, 12").unwrap();
        assert!(s.contains(8, 0, false) && s.contains(12, 0, false) && !s.contains(9, 0, false));
        let s = Selection::parse("index mod 10 < 7").unwrap();
        assert!(s.contains(99, 16, false) && !s.contains(99, 17, false));
        assert!(!Selection::parse("rest").unwrap().contains(1, 1, true));
        for wrong in ["", "a", "8-1", "1-", "index mod 0 < 1", "1 2"] {
            assert!(Selection::parse(wrong).is_err(), "{wrong}");
        }
    }
}
