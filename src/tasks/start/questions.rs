//! Open questions of a proposed campaign, and their answers.

use etalon_campaign::{OpenPart, open_parts};
use std::collections::BTreeMap;

/// A value that a proposal asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Question {
    /// Section, number among the sections of this name from 1, and key: `export.1.unit`.
    pub id: String,
    pub section: String,
    /// Key; `UNIT`, `time_UNIT` and `rx_UNIT` for units of joints, times and rotations.
    pub key: String,
    /// File that the section names.
    pub file: Option<String>,
    /// Remark behind the value.
    pub remark: Option<String>,
}

/// Key of an open part.
fn key(part: OpenPart<'_>) -> &str {
    match part {
        OpenPart::Value(key) => key,
        OpenPart::JointUnit => "UNIT",
        OpenPart::TimeUnit => "time_UNIT",
        OpenPart::AngleUnit => "rx_UNIT",
    }
}

/// Walks through the lines of a campaign with their questions.
fn walk(text: &str, mut visit: impl FnMut(&str, Vec<(OpenPart, Question)>)) {
    let (mut section, mut file) = ("campaign".to_owned(), None::<String>);
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for line in text.lines() {
        let stated = line.trim_start();
        if let Some(name) = stated.strip_prefix('[').map(|rest| rest.trim_start_matches('[')) {
            section = name.split(']').next().unwrap_or_default().trim().to_owned();
            // a part of a log or an export, such as [log.columns], stays with its file
            if !section.contains('.') {
                *seen.entry(section.clone()).or_default() += 1;
                file = None;
            }
        }
        if let Some(value) = stated.strip_prefix("file = ") {
            let value = value.split(" #").next().unwrap_or(value);
            file = toml::from_str::<toml::Table>(&format!("file = {value}"))
                .ok()
                .and_then(|table| table.get("file")?.as_str().map(str::to_owned));
        }
        let outer = section.split('.').next().unwrap_or_default();
        let number = seen.get(outer).copied().unwrap_or(1);
        let question = |part: OpenPart| Question {
            id: match part {
                OpenPart::Value(key) => format!("{section}.{number}.{key}"),
                unit => format!("{outer}.{number}.{}", key(unit)),
            },
            section: section.clone(),
            key: key(part).to_owned(),
            file: file.clone(),
            remark: line.split_once(" #").map(|(_, remark)| remark.trim().to_owned()),
        };
        visit(line, open_parts(line).into_iter().map(|part| (part, question(part))).collect());
    }
}

/// Questions of a campaign, each once.
pub(crate) fn open_questions(text: &str) -> Vec<Question> {
    let mut all: Vec<Question> = Vec::new();
    walk(text, |_, questions| {
        for (_, question) in questions {
            if all.iter().all(|other| other.id != question.id) {
                all.push(question);
            }
        }
    });
    all
}

/// The campaign with these answers, by the ids of the questions. An answer that is a number or a
/// truth value is written as one.
pub(crate) fn answered(text: &str, answers: &BTreeMap<String, String>) -> String {
    let mut all = String::with_capacity(text.len());
    walk(text, |line, questions| {
        let mut line = line.to_owned();
        for (part, question) in questions {
            let answer = answers.get(&question.id).map(|answer| answer.trim()).filter(|answer| !answer.is_empty());
            line = match (answer, part) {
                (None, _) => line,
                (Some(answer), OpenPart::Value(_)) => part.answered(&line, &value(answer)),
                (Some(unit), _) => part.answered(&line, &plain(unit)),
            };
        }
        all += &line;
        all.push('\n');
    });
    all
}

/// The letters of an answer that becomes a part of a key.
fn plain(answer: &str) -> String {
    answer.chars().filter(char::is_ascii_alphanumeric).collect()
}

/// An answer as a value of TOML: a truth value, a number, a list (the columns of a file), or a
/// text.
fn value(answer: &str) -> String {
    let list = toml::from_str::<toml::Table>(&format!("list = {answer}")).ok().filter(|table| table.len() == 1);
    if let Some(list) = list.and_then(|mut table| table.remove("list")).filter(toml::Value::is_array) {
        return list.to_string();
    }
    if ["true", "false"].contains(&answer) {
        return answer.to_owned();
    }
    match answer.replace(',', ".").parse::<f64>() {
        Ok(number) if number.is_finite() => number.to_string(),
        _ => toml::Value::from(answer).to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROPOSED: &str = "name = \"a\"\n[instrument]\nname = \"?\"   # the name\nexpanded_uncertainty_um = \"?\"\n\n\
                            [[export]]\nfile = \"a b.csv\"\nunit = \"?\" # mm, m\n\n[[export]]\nfile = \"c.csv\"\n\
                            # unit = \"?\"\nunit = \"?\"\n\n[[log]]\nfile = \"log.csv\"\n[log.columns]\nq1_UNIT = \"A1\"\nq2_UNIT = \"A2\"\n";

    #[test]
    fn questions_are_named_by_their_section() {
        let all = open_questions(PROPOSED);
        let ids: Vec<&str> = all.iter().map(|question| question.id.as_str()).collect();
        let expected = [
            "instrument.1.name",
            "instrument.1.expanded_uncertainty_um",
            "export.1.unit",
            "export.2.unit",
            "log.1.UNIT",
        ];
        assert_eq!(ids, expected);
        assert_eq!(all[2].file.as_deref(), Some("a b.csv"));
        assert_eq!(all[4].file.as_deref(), Some("log.csv"));
        assert_eq!(all[0].remark.as_deref(), Some("the name"));
    }

    #[test]
    fn answers_are_values_and_never_lines() {
        let answers = [
            ("instrument.1.name", "T\"3\"\n[limits]"),
            ("instrument.1.expanded_uncertainty_um", "12,5"),
            ("export.1.unit", "[\"x\", \"y\"]"),
            ("export.2.unit", "[1]\nlimits = 3"),
            ("log.1.UNIT", "deg = 3\n"),
        ];
        let answers = answers.map(|(id, answer)| (id.to_owned(), answer.to_owned())).into();
        let text = answered(PROPOSED, &answers);
        let read: toml::Table = toml::from_str(&text).unwrap();
        assert_eq!(read["instrument"]["name"].as_str(), Some("T\"3\"\n[limits]"));
        assert_eq!(read["instrument"]["expanded_uncertainty_um"].as_float(), Some(12.5));
        assert_eq!(read["export"][0]["unit"].as_array().map(Vec::len), Some(2));
        assert_eq!(read["export"][1]["unit"].as_str(), Some("[1]\nlimits = 3"));
        assert_eq!(read["log"][0]["columns"]["q2_deg3"].as_str(), Some("A2"));
        assert!(read.get("limits").is_none());
        assert!(open_questions(&text).is_empty());
    }
}
