//! Selection of poses: `"1-8, 12, home"`, `["home", "P3", "5-9"]`, `"all"`, `"rest"`, or
//! `"index mod 10 < 7"`.

use etalon_base::error;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use serde::Deserialize;
use std::collections::BTreeSet;
use std::fmt;
use std::ops::RangeInclusive;

/// Poses in a campaign: a text with names and ranges separated by commas, or a list.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(untagged, expecting = "poses are a text like \"1-8, 12\", or a list like [\"home\", \"5-9\"]")]
pub enum StatedPoses {
    /// Text.
    Text(String),
    /// List; its names may contain a comma, or be `all`.
    List(Vec<PoseName>),
}

etalon_base::schema_by_hand!(inline StatedPoses, generator => {
    let name = generator.subschema_for::<PoseName>();
    schemars::json_schema!({ "anyOf": [{ "type": "string" }, { "type": "array", "items": name }] })
});

impl fmt::Display for StatedPoses {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::List(names) => f.write_str(&names.iter().map(PoseName::to_string).collect::<Vec<_>>().join(", ")),
        }
    }
}

/// A set of poses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Selection {
    /// Poses by name, and ranges of poses.
    Named(Vec<PoseRange>),
    /// Poses whose index modulo the first number is below the second; the index counts the
    /// remaining poses in order, from 0.
    Modulo(usize, usize),
    /// All poses.
    All,
    /// All poses that the calibration does not use.
    Rest,
}

/// A pose, or a range of poses with equal text before their numbers: `12`, `home`, `5-9`, `P1-P8`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PoseRange {
    /// Name, as written.
    pub name: PoseName,
    /// Text before the numbers, and inclusive range of the numbers.
    range: Option<(String, RangeInclusive<i64>)>,
}

impl PoseRange {
    fn new(text: &str) -> Option<Self> {
        let name = PoseName::new(text).ok()?;
        let between = |(at, _): (usize, &str)| {
            let (from, to) = (text[..at].trim(), text[at + 1..].trim());
            let ((before, from), (same, to)) = (numbered(from)?, numbered(to)?);
            (before == same).then(|| (before.to_owned(), from..=to))
        };
        let range = text.match_indices('-').find_map(between).filter(|_| name.number().is_none());
        range.as_ref().is_none_or(|(_, numbers)| !numbers.is_empty()).then_some(Self { name, range })
    }

    /// `true` if the range contains this pose.
    pub fn contains(&self, pose: PoseName) -> bool {
        let within = |(before, numbers): &(String, RangeInclusive<i64>)| match pose {
            PoseName::Number(number) => before.is_empty() && numbers.contains(&number),
            PoseName::Text(text) => numbered(text).is_some_and(|(text, n)| text == before && numbers.contains(&n)),
        };
        self.name == pose || self.range.as_ref().is_some_and(within)
    }
}

/// Splits a name that ends in a number.
fn numbered(name: &str) -> Option<(&str, i64)> {
    let before = name.trim_end_matches(|c: char| c.is_ascii_digit());
    Some((before, name[before.len()..].parse().ok()?))
}

/// The poses of an identification.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selections {
    /// Poses for identification.
    pub calibration: Selection,
    /// Poses for validation.
    pub validation: Option<Selection>,
    /// Poses of each series.
    pub series: Vec<Selection>,
}

impl Selections {
    /// `true` if the pose with this name and index is for calibration.
    pub fn calibrates(&self, pose: PoseName, index: usize) -> bool {
        self.calibration.contains(pose, index, false)
    }

    /// `true` if the pose is for validation.
    pub fn validates(&self, pose: PoseName, index: usize) -> bool {
        let calibrates = self.calibrates(pose, index);
        self.validation.as_ref().is_some_and(|validation| validation.contains(pose, index, calibrates))
    }

    /// Numbers of the series that contain the pose; `rest` is not asked where an earlier one does.
    pub fn series(&self, pose: PoseName, index: usize) -> Vec<usize> {
        let mut of: Vec<usize> = Vec::new();
        for (number, series) in self.series.iter().enumerate() {
            if series.contains(pose, index, !of.is_empty()) {
                of.push(number);
            }
        }
        of
    }

    /// Calibration poses of each series, with their indices among the measured poses.
    pub fn calibration_series(&self, poses: impl IntoIterator<Item = (usize, PoseName)>) -> Vec<Vec<PoseName>> {
        let mut all = vec![Vec::new(); self.series.len()];
        for (i, pose) in poses.into_iter().filter(|(i, pose)| self.calibrates(*pose, *i)) {
            self.series(pose, i).into_iter().for_each(|number| all[number].push(pose));
        }
        all
    }
}

impl Selection {
    /// Reads a selection.
    pub fn parse(stated: &StatedPoses) -> Result<Self, Message> {
        let wrong = || error!("selection-empty", stated = stated.to_string());
        let text = match stated {
            StatedPoses::Text(text) => text,
            StatedPoses::List(names) => {
                let named = names.iter().map(|name| PoseRange::new(&name.to_string())).collect::<Option<Vec<_>>>();
                return named.filter(|named| !named.is_empty()).map(Self::Named).ok_or_else(wrong);
            }
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
        text.split(',')
            .map(|part| PoseRange::new(part.trim()))
            .collect::<Option<_>>()
            .map(Self::Named)
            .ok_or_else(wrong)
    }

    /// `true` if the selection contains the pose with this name and index; `taken` shows whether
    /// the calibration uses it.
    pub fn contains(&self, pose: PoseName, index: usize, taken: bool) -> bool {
        match self {
            Self::Named(named) => named.iter().any(|named| named.contains(pose)),
            Self::Modulo(n, k) => index % n < *k,
            Self::All => true,
            Self::Rest => !taken,
        }
    }

    /// Returns the first name that none of these poses has, and which is therefore a mistake.
    /// Numbers and their ranges may be unmeasured.
    pub fn mistaken(&self, poses: &BTreeSet<PoseName>) -> Option<PoseName> {
        let Self::Named(named) = self else { return None };
        let text = |named: &&PoseRange| match &named.range {
            Some((before, _)) => !before.is_empty(),
            None => named.name.number().is_none(),
        };
        let lone = |named: &&PoseRange| !poses.iter().any(|pose| named.contains(*pose));
        named.iter().filter(text).find(lone).map(|named| named.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn selection(text: &str) -> Result<Selection, Message> {
        Selection::parse(&StatedPoses::Text(text.to_owned()))
    }

    #[test]
    fn selections() {
        let s = selection("1-8, 12").unwrap();
        assert!(s.contains(8.into(), 0, false) && s.contains(12.into(), 0, false) && !s.contains(9.into(), 0, false));
        let s = selection("index mod 10 < 7").unwrap();
        assert!(s.contains(99.into(), 16, false) && !s.contains(99.into(), 17, false));
        assert!(!selection("rest").unwrap().contains(1.into(), 1, true));
        for wrong in ["", "8-1", "index mod 0 < 1", "1,,2", "-a"] {
            assert!(selection(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn poses_are_selected_by_name() {
        let named = |name: &str| PoseName::new(name).unwrap();
        let list: StatedPoses =
            serde_json::from_str(r#"["home", "P3", "5-9", "Q1-Q12", "A-3", 20, "a,b", "all"]"#).unwrap();
        for s in [Selection::parse(&list).unwrap(), selection("home,P3, 5-9, Q1-Q12, A-3, 20").unwrap()] {
            for name in ["home", "P3", "5", "9", "Q1", "Q10", "Q012", "A-3", "20"] {
                assert!(s.contains(named(name), 0, false), "{name}");
            }
            for name in ["Home", "3", "P5", "10", "Q13", "A", "A3", "R1"] {
                assert!(!s.contains(named(name), 0, false), "{name}");
            }
        }
        let s = Selection::parse(&list).unwrap();
        assert!(s.contains(named("a,b"), 0, false) && s.contains(named("all"), 0, false));
    }
}
