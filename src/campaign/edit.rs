//! Changes of campaign.toml that a program makes for its user. All other lines of the text stay as
//! they are.

use crate::{Exclude, StatedPoses};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use serde::Deserialize;
use std::ops::Range;
use toml::{Spanned, Value};

/// Changes of a campaign.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Readings to exclude.
    pub exclude: Vec<Exclude>,
    /// Parameters to keep at nominal.
    pub hold: Vec<String>,
    /// Parameters that are held by name, to identify.
    pub free: Vec<String>,
    /// Limit of the largest position error (mm).
    pub position_max_mm: Option<f64>,
    /// Selection of the calibration poses.
    pub calibration: Option<String>,
    /// Selection of the validation poses.
    pub validation: Option<String>,
}

/// Text without the line of a key, whose value is in `value`, and without a section that has no
/// other line; `None` if the line contains other keys. If the line was added to a text, the result
/// is the earlier text.
pub(crate) fn without_line(text: &str, value: Range<usize>) -> Option<String> {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let mut from = text.get(..value.start)?.matches('\n').count();
    let mut to = from + 1;
    let key = text.get(..value.start)?.rsplit('\n').next()?;
    if text.get(value)?.contains('\n') || key.contains(['{', ',']) {
        return None;
    }
    let is_blank = |line: &str| line.trim().is_empty();
    let is_head = |line: &str| line.trim_start().starts_with('[');
    let next = lines[to..].iter().find(|line| !is_blank(line));
    if from > 0 && is_head(lines[from - 1]) && next.is_none_or(|next| is_head(next)) {
        from -= 1;
        to += lines[to..].iter().take_while(|line| is_blank(line)).count();
        if next.is_none() {
            from -= lines[..from].iter().rev().take_while(|line| is_blank(line)).count();
        }
    }
    Some([&lines[..from], &lines[to..]].concat().concat())
}

/// Keys that changes concern, with their places in the text.
#[derive(Default, Deserialize)]
struct Keys {
    #[serde(default)]
    identify: IdentifyKeys,
    #[serde(default)]
    limits: LimitKeys,
}

#[derive(Default, Deserialize)]
struct IdentifyKeys {
    hold: Option<Spanned<Vec<Spanned<String>>>>,
    calibration: Option<Spanned<Value>>,
    validation: Option<Spanned<Value>>,
    #[serde(default)]
    exclude: Vec<Exclude>,
}

#[derive(Default, Deserialize)]
struct LimitKeys {
    position_max_mm: Option<Spanned<f64>>,
}

impl Changes {
    /// `true` if nothing is changed.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Returns the text of campaign.toml with these changes.
    ///
    /// # Errors
    /// Fails if the text contains a key in a form that cannot be changed, or does not hold a
    /// parameter that is to be identified.
    pub fn apply(&self, text: &str) -> Result<String> {
        let mut text = text.to_owned();
        for name in &self.free {
            text = freed(&text, name)?;
        }
        for name in &self.hold {
            text = held(&text, name)?;
        }
        if let Some(limit) = self.position_max_mm {
            text = limited(&text, limit)?;
        }
        if let Some(poses) = &self.validation {
            text = selected(&text, "validation", poses)?;
        }
        if let Some(poses) = &self.calibration {
            text = selected(&text, "calibration", poses)?;
        }
        for rule in &self.exclude {
            text = excluded(text, rule);
        }
        if self.is_in(&text) { Ok(text) } else { Err(not_editable("identify")) }
    }

    /// `true` if a campaign contains these changes.
    fn is_in(&self, text: &str) -> bool {
        let Ok(Keys { identify, limits }) = keys(text, "identify") else { return false };
        let held = identify.hold.map(Spanned::into_inner).unwrap_or_default();
        let is_held = |name: &String| held.iter().any(|held| held.get_ref() == name);
        let selects = |wanted: &Option<String>, stated: &Option<Spanned<Value>>| {
            wanted.is_none() || stated.as_ref().and_then(|stated| stated.get_ref().as_str()) == wanted.as_deref()
        };
        selects(&self.calibration, &identify.calibration)
            && selects(&self.validation, &identify.validation)
            && self.hold.iter().all(is_held)
            && !self.free.iter().any(is_held)
            && self.exclude.iter().all(|rule| identify.exclude.contains(rule))
            && self.position_max_mm.is_none_or(|limit| limits.position_max_mm.is_some_and(|l| *l.get_ref() == limit))
    }
}

fn not_editable(key: &str) -> Problems {
    error!("view-campaign-not-editable", key).into()
}

fn keys(text: &str, key: &str) -> Result<Keys> {
    toml::from_str(text).map_err(|_| not_editable(key))
}

fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// Returns the text with one part replaced by another text.
fn replaced(text: &str, part: Range<usize>, by: &str) -> String {
    format!("{}{by}{}", text.get(..part.start).unwrap_or_default(), text.get(part.end..).unwrap_or_default())
}

/// Returns the text with a line added after the head of a section; `None` without this head.
fn with_line(text: &str, head: &str, line: &str) -> Option<String> {
    let mut at = 0;
    for stated in text.split_inclusive('\n') {
        at += stated.len();
        let rest = stated.trim_start().strip_prefix(head).map(str::trim_start);
        if rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('#')) {
            let gap = if stated.ends_with('\n') { "" } else { "\n" };
            return Some(format!("{}{gap}{line}\n{}", &text[..at], &text[at..]));
        }
    }
    None
}

/// Adds a name to `hold`.
fn held(text: &str, name: &str) -> Result<String> {
    let Some(stated) = keys(text, "hold")?.identify.hold else {
        return with_line(text, "[identify]", &format!("hold = [{}]", quoted(name)))
            .ok_or_else(|| not_editable("hold"));
    };
    let names = stated.get_ref();
    if names.iter().any(|held| held.get_ref() == name) {
        return Ok(text.to_owned());
    }
    Ok(match names.last() {
        Some(last) => replaced(text, last.span().end..last.span().end, &format!(", {}", quoted(name))),
        None => replaced(text, stated.span(), &format!("[{}]", quoted(name))),
    })
}

/// Removes a name from `hold`.
fn freed(text: &str, name: &str) -> Result<String> {
    let stated = keys(text, "hold")?.identify.hold;
    let names = stated.as_ref().map_or(&[][..], |stated| stated.get_ref());
    let Some(at) = names.iter().position(|held| held.get_ref() == name) else {
        return Err(error!("view-parameter-stays-held", name).into());
    };
    let own = names[at].span();
    let part = match (names.get(at + 1), at.checked_sub(1).and_then(|before| names.get(before))) {
        (Some(next), _) => own.start..next.span().start,
        (None, Some(before)) => before.span().end..own.end,
        (None, None) => stated.as_ref().map_or(own, Spanned::span),
    };
    Ok(replaced(text, part, if names.len() == 1 { "[]" } else { "" }))
}

/// The text with the poses of a set.
fn selected(text: &str, key: &str, poses: &str) -> Result<String> {
    let identify = keys(text, key)?.identify;
    let stated = if key == "calibration" { identify.calibration } else { identify.validation };
    match stated {
        Some(stated) => Ok(replaced(text, stated.span(), &quoted(poses))),
        None => with_line(text, "[identify]", &format!("{key} = {}", quoted(poses))).ok_or_else(|| not_editable(key)),
    }
}

/// Returns the text with this limit of the largest position error.
fn limited(text: &str, limit_mm: f64) -> Result<String> {
    if let Some(stated) = keys(text, "position_max_mm")?.limits.position_max_mm {
        return Ok(replaced(text, stated.span(), &limit_mm.to_string()));
    }
    let line = format!("position_max_mm = {limit_mm}");
    Ok(with_line(text, "[limits]", &line).unwrap_or_else(|| format!("{}\n[limits]\n{line}\n", ended(text.to_owned()))))
}

/// The text with a line feed at its end.
fn ended(mut text: String) -> String {
    if !text.is_empty() && !text.ends_with('\n') {
        text.push('\n');
    }
    text
}

/// Adds a rule of exclusion.
fn excluded(text: String, rule: &Exclude) -> String {
    let mut text = ended(text) + "\n[[identify.exclude]]\n";
    match &rule.poses {
        Some(StatedPoses::Text(stated)) => text += &format!("poses = {}\n", quoted(stated)),
        Some(StatedPoses::List(names)) => {
            let names: Vec<String> = names.iter().map(|name| quoted(&name.to_string())).collect();
            text += &format!("poses = [{}]\n", names.join(", "));
        }
        None => {}
    }
    text += &rule.cycle.map(|cycle| format!("cycle = {cycle}\n")).unwrap_or_default();
    text += &rule.target.as_ref().map(|target| format!("target = {}\n", quoted(target))).unwrap_or_default();
    text + &format!("reason = {}\n", quoted(&rule.reason))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CampaignFile;

    const CAMPAIGN: &str = "name = \"a\"\nrobot = \"robot.toml\"\n\n[instrument]\nname = \"b\"\nexpanded_uncertainty_um = 3\n\
                            coverage_factor = 2\n\n[identify] # the arm\ncalibration = \"all\"\nhold = [\n  \"a1\", # kept\n  \"a2\",\n]\n";

    fn rule() -> Exclude {
        let poses = Some(StatedPoses::List(vec![3.into(), 7.into()]));
        Exclude {
            poses,
            target: Some("SMR \"1\"".to_owned()),
            reason: "the \\ nest\nslipped".to_owned(),
            ..Exclude::default()
        }
    }

    #[test]
    fn changes_are_read_back_and_all_other_lines_stay() {
        let changes = Changes {
            exclude: vec![rule()],
            hold: vec!["a3".to_owned()],
            free: vec!["a1".to_owned()],
            position_max_mm: Some(0.25),
            calibration: Some("1-8".to_owned()),
            validation: Some("rest".to_owned()),
        };
        let text = changes.apply(CAMPAIGN).unwrap();
        let file: CampaignFile = toml::from_str(&text).unwrap();
        let identify = file.identify.unwrap();
        assert_eq!(identify.hold.iter().map(|name| name.get_ref().as_str()).collect::<Vec<_>>(), ["a2", "a3"]);
        assert_eq!(*identify.exclude[0].get_ref(), rule());
        assert_eq!(file.limits.position_max_mm, Some(0.25));
        let validation = identify.validation.map(|poses| poses.get_ref().to_string());
        assert_eq!(
            (identify.calibration.get_ref().to_string(), validation.as_deref()),
            ("1-8".to_owned(), Some("rest"))
        );
        let changed = ["a1", "a2", "calibration"];
        let stays = CAMPAIGN.lines().filter(|line| !changed.iter().any(|part| line.contains(part)));
        stays.for_each(|line| assert!(text.contains(line), "{line}\n{text}"));
        // a second change of the same keys
        let again = Changes { position_max_mm: Some(0.5), free: vec!["a2".to_owned()], ..Changes::default() };
        let text =
            Changes { free: vec!["a3".to_owned()], ..Changes::default() }.apply(&again.apply(&text).unwrap()).unwrap();
        assert!(text.contains("hold = []") && text.contains("position_max_mm = 0.5"), "{text}");
    }

    #[test]
    fn a_text_without_an_added_line_is_as_before() {
        const LINE: &str = "controller_backup = \"a.cfg\" # saved\n";
        let without = |text: &str| {
            let place = text.find("\"a.cfg\"").unwrap();
            without_line(text, place..place + 7)
        };
        for (before, after) in [
            (
                "name = \"a\"\n\n[conditions]\nplace = \"b\"\n",
                format!("name = \"a\"\n\n[conditions]\n{LINE}place = \"b\"\n"),
            ),
            ("name = \"a\"\n\n[limits]\n", format!("name = \"a\"\n\n[conditions]\n{LINE}\n[limits]\n")),
            ("name = \"a\"\n", format!("name = \"a\"\n\n[conditions]\n{LINE}")),
        ] {
            assert_eq!(without(&after).as_deref(), Some(before));
        }
        let inline = format!("conditions = {{ place = \"b\", {} }}\n", LINE.trim_end_matches(" # saved\n"));
        assert_eq!(without(&inline), None);
    }

    #[test]
    fn keys_in_other_forms_are_refused() {
        let inline = "name = \"a\"\nrobot = \"r\"\nidentify = { calibration = \"all\" }\n";
        let changes = Changes { hold: vec!["a1".to_owned()], ..Changes::default() };
        assert!(changes.apply(inline).unwrap_err().0[0].is("view-campaign-not-editable", &[("key", &"hold")]));
        let changes = Changes { exclude: vec![rule()], ..Changes::default() };
        assert!(changes.apply(inline).unwrap_err().0[0].is("view-campaign-not-editable", &[("key", &"identify")]));
        let changes = Changes { free: vec!["b".to_owned()], ..Changes::default() };
        assert!(changes.apply(CAMPAIGN).unwrap_err().0[0].is("view-parameter-stays-held", &[("name", &"b")]));
    }
}
