//! `[[export]]`: a file of a measuring system, its format, and the pattern of its labels
//! (`{target}_{pose}_{cycle}`).

use super::dialect::{Column, Unit};
use super::exports::Format;
use super::exports::delimited::columns_not_read;
use etalon_base::error;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_tables::{ColumnSource, Encoding, FromRow};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// A file of a measuring system.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Export {
    /// Name of the file. `{pose}`, `{target}` and `{cycle}` stand for a file for each pose:
    /// `"scans/{pose}.txt"`.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Target, pose and cycle that the name of the file states.
    #[serde(skip)]
    pub from_name: LabelNames,
    /// Format of the file: a name, or a table of keys that describes text.
    pub format: Format,
    /// Character encoding, if no byte-order mark gives it.
    #[schemars(extend("default" = "utf-8"))]
    pub encoding: Option<Encoding>,
    /// Length unit of the file.
    pub unit: Unit,
    /// Pattern of the labels, with `{target}`, `{pose}` and `{cycle}`.
    #[schemars(with = "Option<String>")]
    pub label: Option<Spanned<String>>,
    /// Columns of the joints in a file with joints and points, by the joint with its unit, as in a
    /// log. Each row is joined with itself, without a `[log]`.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Column>")]
    pub joints: BTreeMap<Spanned<String>, Column>,
    /// Target of all rows, if the file does not name it.
    pub target: Option<String>,
    /// Pose number from the number of the data row: `row`, or `row + 100` with an offset for a
    /// second file of the same targets.
    pub pose: Option<FromRow>,
    /// Name of the station of the instrument, if the coordinates are not in the frame of the
    /// world. Position and orientation of the station are identified.
    #[schemars(with = "Option<String>")]
    pub station: Option<Spanned<String>>,
}

impl Export {
    /// Number of unused columns of the file, and number of all columns; `None` for formats that are
    /// not delimited text, and if computed columns or filters refer to columns.
    pub fn columns_not_read(&self, text: &str) -> Option<[usize; 2]> {
        if self.format.dialect.columns.roles().is_empty() {
            return None;
        }
        let is_joint = |i: usize, heading: Option<&str>| {
            self.joints.values().any(|column| match &column.at {
                ColumnSource::Number(number) => *number == i + 1,
                ColumnSource::Heading(name) => heading == Some(name.as_str()),
            })
        };
        columns_not_read(text, &self.format.dialect, is_joint)
    }
}

/// Target, pose and cycle of a label.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LabelNames {
    /// Target of the label.
    pub target: Option<String>,
    /// Pose of the label.
    pub pose: Option<PoseName>,
    /// Repeat of the pose.
    pub cycle: Option<i64>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Part {
    Text(String),
    Target,
    Pose,
    Cycle,
}

/// Longer labels name no pose by a text.
const LONGEST: usize = 300;

/// A pattern of labels.
#[derive(Clone, Debug)]
pub struct Pattern(Vec<Part>);

impl Pattern {
    /// Reads a pattern.
    pub fn parse(pattern: &str) -> Result<Self, Message> {
        let wrong = |fault: &str, name: &str| Err(error!("label-pattern-invalid", pattern, fault, name));
        let mut parts = Vec::new();
        let mut rest = pattern;
        while let Some((text, after)) = rest.split_once('{') {
            if !text.is_empty() {
                parts.push(Part::Text(text.to_owned()));
            }
            let Some((name, after)) = after.split_once('}') else {
                return wrong("open", "");
            };
            let part = match name {
                "target" => Part::Target,
                "pose" => Part::Pose,
                "cycle" => Part::Cycle,
                _ => return wrong("unknown", name),
            };
            if parts.contains(&part) {
                return wrong("twice", name);
            }
            parts.push(part);
            rest = after;
        }
        if !rest.is_empty() {
            parts.push(Part::Text(rest.to_owned()));
        }
        Ok(Self(parts))
    }

    /// Returns target, pose and cycle of `label`; `None` if it does not have this form.
    ///
    /// If several interpretations are possible, the first `known` one with a numeric pose counts,
    /// then the `known` one of the longest target with a named pose. A named pose is read only if
    /// it is `known`.
    pub fn read(&self, label: &str, known: impl Fn(&LabelNames) -> bool) -> Option<LabelNames> {
        let mut first = None;
        let mut by_number = None;
        each_reading(&self.0, label, Texts::default(), &mut |texts| {
            let Some(named) = texts.by_number() else { return false };
            if known(&named) {
                by_number = Some(named);
                return true;
            }
            first.get_or_insert(named);
            false
        });
        if by_number.is_some() || label.len() > LONGEST {
            return by_number.or(first);
        }
        let mut by_text = None;
        each_reading(&self.0, label, Texts { pose_is_text: true, ..Texts::default() }, &mut |texts| {
            by_text = texts.by_text().filter(|named| known(named)).or(by_text.take());
            false
        });
        by_text.or(first)
    }
}

/// Texts of a label that stand for target, pose and cycle.
#[derive(Clone, Copy, Default)]
struct Texts<'l> {
    target: Option<&'l str>,
    pose: Option<&'l str>,
    cycle: Option<&'l str>,
    /// `true` if the pose is a text that is not a number.
    pose_is_text: bool,
}

impl Texts<'_> {
    /// Returns the names with this pose; `None` if a number is too large.
    fn named(self, pose: Option<PoseName>) -> Option<LabelNames> {
        let cycle = self.cycle.map(str::parse).transpose().ok()?;
        Some(LabelNames { target: self.target.map(str::to_owned), pose, cycle })
    }

    fn by_number(self) -> Option<LabelNames> {
        let pose = self.pose.map(str::parse::<i64>).transpose().ok()?;
        self.named(pose.map(PoseName::from))
    }

    fn by_text(self) -> Option<LabelNames> {
        let pose = self.pose.map(PoseName::new).transpose().ok()?;
        self.named(pose).filter(|named| named.pose.is_none_or(|pose| pose.number().is_none()))
    }
}

/// Passes the interpretations of a label to `found`, in the order of the lengths of their parts,
/// until `found` returns `true`.
fn each_reading<'l>(parts: &[Part], label: &'l str, read: Texts<'l>, found: &mut dyn FnMut(Texts<'l>) -> bool) -> bool {
    let Some((first, rest)) = parts.split_first() else { return label.is_empty() && found(read) };
    let mut up_to = |end: usize, with: &dyn Fn(&'l str) -> Texts<'l>| {
        let (text, after) = label.split_at(end);
        each_reading(rest, after, with(text), found)
    };
    let digits = || label.bytes().take_while(u8::is_ascii_digit).count();
    let anywhere = || label.char_indices().skip(1).map(|(i, _)| i).chain([label.len()]).filter(|end| *end > 0);
    let with_pose = |text| Texts { pose: Some(text), ..read };
    match first {
        Part::Text(text) => label.starts_with(text.as_str()) && up_to(text.len(), &|_| read),
        Part::Pose if read.pose_is_text => anywhere().any(|end| up_to(end, &with_pose)),
        Part::Pose => digits() > 0 && up_to(digits(), &with_pose),
        Part::Cycle => digits() > 0 && up_to(digits(), &|text| Texts { cycle: Some(text), ..read }),
        Part::Target => anywhere().any(|end| up_to(end, &|text| Texts { target: Some(text), ..read })),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_split_into_names() {
        let pattern = Pattern::parse("{target}_{pose}_{cycle}").unwrap();
        let named = |t: &str, p, c| {
            Some(LabelNames { target: Some(t.to_owned()), pose: PoseName::new(p).ok(), cycle: Some(c) })
        };
        let read =
            |label: &str| pattern.read(label, |named| matches!(named.target.as_deref(), Some("K" | "K_1" | "SMR_1")));
        assert_eq!(read("K_12_3"), named("K", "12", 3));
        assert_eq!(read("SMR_1_12_3"), named("SMR_1", "12", 3));
        assert_eq!(read("M_12_3"), named("M", "12", 3));
        assert_eq!(read("K_home_3"), named("K", "home", 3));
        assert_eq!(read("SMR_1_P_home_3"), named("SMR_1", "P_home", 3));
        assert_eq!(read("K_A-3_1"), named("K", "A-3", 1));
        // a number before a text, and the longest target
        assert_eq!(read("K_1_2_3"), named("K_1", "2", 3));
        assert_eq!(read("K_1_10b_3"), named("K_1", "10b", 3));
        for other in ["K_12", "M_home_3", "_1_2", "R_home", "R_home_1", "K_=1_1", ""] {
            assert_eq!(read(other), None, "{other}");
        }
        let pattern = Pattern::parse("P{pose}-{target}").unwrap();
        let ball = LabelNames { target: Some("ball".into()), pose: Some(7.into()), cycle: None };
        assert_eq!(pattern.read("P7-ball", |_| false), Some(ball));
    }

    #[test]
    fn wrong_patterns_are_errors() {
        for (wrong, fault) in [("{target", "open"), ("{x}", "unknown"), ("{pose}{pose}", "twice")] {
            let error = Pattern::parse(wrong).unwrap_err();
            assert!(error.is("label-pattern-invalid", &[("pattern", &wrong), ("fault", &fault)]), "{error}");
        }
    }
}
