//! `[[export]]`: a file of a measuring system, how it is to be read, and what its labels name: `{target}_{pose}_{cycle}`.

use super::format::{Encoding, FromRow, Unit};
use super::formats::Format;
use crate::base::message::Message;
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

/// A file of a measuring system.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Export {
    /// Name of the file.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Format of the file: a name, or a table of text key by key.
    pub format: Format,
    /// Encoding of its characters, where no byte-order mark states it.
    #[schemars(extend("default" = "utf-8"))]
    pub encoding: Option<Encoding>,
    /// Length unit of the file.
    pub unit: Unit,
    /// Pattern of the labels, with `{target}`, `{pose}` and `{cycle}`.
    #[schemars(with = "Option<String>")]
    pub label: Option<Spanned<String>>,
    /// Target of all rows, where the file does not name it.
    pub target: Option<String>,
    /// `row`: the number of the data row is the number of the pose; `row + 100`: so many more, for a second file of the same targets.
    pub pose: Option<FromRow>,
}

/// What a label names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Named {
    pub target: Option<String>,
    pub pose: Option<i64>,
    pub cycle: Option<i64>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Part {
    Text(String),
    Target,
    Pose,
    Cycle,
}

/// A pattern of labels.
#[derive(Clone, Debug)]
pub(crate) struct Pattern(Vec<Part>);

impl Pattern {
    /// Reads a pattern.
    pub fn parse(pattern: &str) -> Result<Self, Message> {
        let wrong = |what: String| {
            Err(Message::error(what).expected("text with {target}, {pose} and {cycle}, each at most once"))
        };
        let mut parts = Vec::new();
        let mut rest = pattern;
        while let Some((text, after)) = rest.split_once('{') {
            if !text.is_empty() {
                parts.push(Part::Text(text.to_owned()));
            }
            let Some((name, after)) = after.split_once('}') else {
                return wrong(format!("`{pattern}` has a `{{` without `}}`"));
            };
            let part = match name {
                "target" => Part::Target,
                "pose" => Part::Pose,
                "cycle" => Part::Cycle,
                _ => return wrong(format!("`{{{name}}}` means nothing in a label")),
            };
            if parts.contains(&part) {
                return wrong(format!("`{pattern}` names `{{{name}}}` twice"));
            }
            parts.push(part);
            rest = after;
        }
        if !rest.is_empty() {
            parts.push(Part::Text(rest.to_owned()));
        }
        Ok(Self(parts))
    }

    /// What `label` names; `None` if it does not have this form.
    pub fn read(&self, label: &str) -> Option<Named> {
        matched(&self.0, label)
    }
}

fn matched(parts: &[Part], label: &str) -> Option<Named> {
    let Some((first, rest)) = parts.split_first() else { return label.is_empty().then(Named::default) };
    let digits = label.bytes().take_while(u8::is_ascii_digit).count();
    let whole = |set: fn(&mut Named, i64)| {
        let mut named = matched(rest, &label[digits..])?;
        set(&mut named, label[..digits].parse().ok()?);
        Some(named)
    };
    match first {
        Part::Text(text) => matched(rest, label.strip_prefix(text.as_str())?),
        Part::Pose => whole(|n, v| n.pose = Some(v)),
        Part::Cycle => whole(|n, v| n.cycle = Some(v)),
        Part::Target => label.char_indices().skip(1).map(|(i, _)| i).chain([label.len()]).find_map(|end| {
            let mut named = matched(rest, label.get(end..)?)?;
            named.target = (end > 0).then(|| label[..end].to_owned());
            named.target.is_some().then_some(named)
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_taken_apart() {
        let pattern = Pattern::parse("{target}_{pose}_{cycle}").unwrap();
        let named = |t: &str, p, c| Some(Named { target: Some(t.to_owned()), pose: Some(p), cycle: Some(c) });
        assert_eq!(pattern.read("K_12_3"), named("K", 12, 3));
        assert_eq!(pattern.read("SMR_1_12_3"), named("SMR_1", 12, 3));
        for other in ["K_12", "K_a_3", "_1_2", "R_home", ""] {
            assert_eq!(pattern.read(other), None, "{other}");
        }
        let pattern = Pattern::parse("P{pose}-{target}").unwrap();
        assert_eq!(pattern.read("P7-ball"), Some(Named { target: Some("ball".into()), pose: Some(7), cycle: None }));
    }

    #[test]
    fn wrong_patterns_are_errors() {
        for wrong in ["{target", "{x}", "{pose}{pose}"] {
            assert!(Pattern::parse(wrong).is_err(), "{wrong}");
        }
    }
}
