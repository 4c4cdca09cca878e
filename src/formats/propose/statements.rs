//! Lines of a proposal for campaign.toml: values until they are printed.

use crate::dialect::quoted;
use etalon_base::catalogue::Phrase;
use etalon_base::message::printable;
use etalon_base::worded::Worded;
use std::fmt;

/// Unit of a column whose unit is a question.
pub(crate) const OPEN_UNIT: &str = "UNIT";
/// Key of a column of times whose unit is a question.
pub(crate) const OPEN_TIME: &str = "time_UNIT";

/// Lines of a proposal.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lines(pub Vec<Line>);

/// A line of a proposal.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Line {
    /// An empty line.
    Blank,
    /// A comment.
    Remark(String),
    /// A question that another file may answer.
    Question(Worded),
    /// Head of a section.
    Section(Section),
    /// The file that a section reads.
    File(String),
    /// Format of an export as TOML.
    Format(String),
    /// Columns of a log or of observations: keys, and headings or numbers as TOML.
    Columns(Vec<(String, String)>),
    /// Form of the labels.
    Label(Label),
    /// Target of the rows.
    Target(Target),
    /// Poses that are the rows of the file.
    PoseByRow,
    /// Other lines as they are printed.
    Text(String),
}

/// Head of a section.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Section {
    pub name: &'static str,
    /// `true` for an element of a list.
    pub is_listed: bool,
    /// Name of the element, if it has one.
    pub title: Option<String>,
}

/// Form of the labels of an export.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Label {
    /// The form is a question.
    Open,
    /// Names of poses: each row has several targets.
    Pose,
    /// The form of all labels, or of all but the labels of stationary points.
    Known { form: String, labels: usize, stationary: usize },
}

/// Target of the rows of an export.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Target {
    /// The target is a question.
    Open,
    /// A target of its own, or another one in a frame of its own.
    InOtherFrame,
    /// A name, with the reason for it.
    Named(String, &'static str),
}

impl Line {
    /// A doubt as a comment.
    pub fn doubt(doubt: &Phrase) -> Self {
        Self::Remark(format!("DOUBT: {doubt}"))
    }
}

impl Lines {
    /// Lines of a section of its own.
    pub fn section(name: &'static str) -> Self {
        Self(vec![Line::Section(Section { name, is_listed: false, title: None })])
    }

    /// Lines of an element of a list of sections.
    pub fn element(name: &'static str) -> Self {
        Self(vec![Line::Section(Section { name, is_listed: true, title: None })])
    }

    /// The lines with another line at the end.
    pub fn with(mut self, line: Line) -> Self {
        self.push(line);
        self
    }

    /// The lines with text at the end.
    pub fn with_text(self, text: impl Into<String>) -> Self {
        self.with(Line::Text(text.into()))
    }

    /// The lines with other lines at the end.
    pub fn followed_by(mut self, lines: Lines) -> Self {
        self.0.extend(lines.0);
        self
    }

    /// Adds a line at the end.
    pub fn push(&mut self, line: Line) {
        self.0.push(line);
    }

    /// Adds a doubt above all lines.
    pub fn doubt(&mut self, doubt: &Phrase) {
        self.0.insert(0, Line::doubt(doubt));
    }

    /// Replaces each line that is equal to `line` by other lines.
    pub fn replace(&mut self, line: &Line, by: &[Line]) {
        let lines = std::mem::take(&mut self.0).into_iter();
        self.0 = lines.flat_map(|other| if other == *line { by.to_vec() } else { vec![other] }).collect();
    }

    /// Removes each line that is equal to `line`.
    pub fn remove(&mut self, line: &Line) {
        self.0.retain(|other| other != line);
    }

    /// Adds a line behind each file.
    pub fn insert_behind_files(&mut self, line: &Line) {
        let lines = std::mem::take(&mut self.0).into_iter();
        self.0 = lines
            .flat_map(|other| {
                let added = matches!(other, Line::File(_)).then(|| line.clone());
                std::iter::once(other).chain(added)
            })
            .collect();
    }

    /// The first section with this name that is no element of a list.
    pub fn section_mut(&mut self, name: &str) -> Option<&mut Section> {
        self.0.iter_mut().find_map(|line| match line {
            Line::Section(section) if section.name == name && !section.is_listed => Some(section),
            _ => None,
        })
    }

    /// Columns of all sections.
    pub fn columns_mut(&mut self) -> impl Iterator<Item = &mut Vec<(String, String)>> {
        self.0.iter_mut().filter_map(|line| if let Line::Columns(columns) = line { Some(columns) } else { None })
    }

    /// Targets of all exports.
    pub fn targets(&self) -> impl Iterator<Item = &Target> {
        self.0.iter().filter_map(|line| if let Line::Target(target) = line { Some(target) } else { None })
    }

    /// Targets of all exports.
    pub fn targets_mut(&mut self) -> impl Iterator<Item = &mut Target> {
        self.0.iter_mut().filter_map(|line| if let Line::Target(target) = line { Some(target) } else { None })
    }

    /// States the unit of times that was a question.
    pub fn state_time_unit(&mut self, unit: &str) {
        let stated = format!("time_{unit}");
        for line in &mut self.0 {
            match line {
                Line::Format(format) => *format = format.replace(OPEN_TIME, &stated),
                Line::Columns(columns) => {
                    columns.iter_mut().filter(|(key, _)| key == OPEN_TIME).for_each(|(key, _)| key.clone_from(&stated));
                }
                _ => {}
            }
        }
    }

    /// Leaves out columns of times whose unit is a question; `false` if one of them stays.
    pub fn leave_open_times(&mut self, sources: &[String]) -> bool {
        let is_left = |(key, source): &(String, String)| key == OPEN_TIME && sources.contains(source);
        self.columns_mut().filter(|columns| columns.len() > 1).for_each(|columns| columns.retain(|of| !is_left(of)));
        !self.0.iter().any(|line| match line {
            Line::Format(format) => format.contains(OPEN_TIME),
            Line::Columns(columns) => columns.iter().any(|(key, _)| key == OPEN_TIME),
            _ => false,
        })
    }
}

impl FromIterator<Self> for Lines {
    fn from_iter<I: IntoIterator<Item = Self>>(all: I) -> Self {
        Self(all.into_iter().flat_map(|lines| lines.0).collect())
    }
}

impl fmt::Display for Lines {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.iter().try_for_each(|line| write!(f, "{line}"))
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Blank => writeln!(f),
            Self::Remark(text) => writeln!(f, "# {}", printable(text)),
            Self::Question(question) => writeln!(f, "# QUESTION: {}", printable(&question.to_string())),
            Self::Section(section) => write!(f, "{section}"),
            Self::File(file) => writeln!(f, "file = {}", quoted(file)),
            Self::Format(format) => writeln!(f, "format = {format}"),
            Self::Columns(columns) => {
                let entries: Vec<String> = columns.iter().map(|(key, source)| format!("{key} = {source}")).collect();
                writeln!(f, "columns = {{ {} }}", entries.join(", "))
            }
            Self::Label(label) => write!(f, "{label}"),
            Self::Target(target) => write!(f, "{target}"),
            Self::PoseByRow => {
                writeln!(f, "pose = \"row\"               # if the number of the row is the number of the pose")
            }
            Self::Text(text) => f.write_str(text),
        }
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.is_listed {
            true => writeln!(f, "[[{}]]", self.name)?,
            false => writeln!(f, "[{}]", self.name)?,
        }
        self.title.as_ref().map_or(Ok(()), |title| writeln!(f, "name = {}", quoted(title)))
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Open => writeln!(
                f,
                "label = \"{{target}}_{{pose}}_{{cycle}}\"   # how a label names target, pose and repeat, if it does"
            ),
            Self::Pose => writeln!(
                f,
                "label = \"{{pose}}\"              # each row has several targets: its label is the name of a pose"
            ),
            Self::Known { form, labels, stationary: 0 } => {
                writeln!(f, "label = {}   # all {labels} labels have this form", quoted(form))
            }
            Self::Known { form, stationary, .. } => {
                writeln!(f, "label = {}   # the form of all labels but {stationary}: stationary points", quoted(form))
            }
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Open => writeln!(f, "target = \"?\"               # which target the rows are of"),
            Self::InOtherFrame => {
                writeln!(f, "target = \"?\"               # a target of its own, or the same point in another frame")
            }
            Self::Named(name, "") => writeln!(f, "target = {}", quoted(name)),
            Self::Named(name, reason) => writeln!(f, "target = {}           # {reason}", quoted(name)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines() -> Lines {
        let entry = |key: &str, source: &str| (key.to_owned(), source.to_owned());
        Lines::section("log")
            .with(Line::File("l.csv".to_owned()))
            .with(Line::Columns(vec![entry(OPEN_TIME, "\"t\""), entry("q1_deg", "2")]))
    }

    #[test]
    fn what_another_file_shows_is_stated_when_the_lines_are_printed() {
        let mut stated = lines();
        stated.state_time_unit("ms");
        assert_eq!(stated.to_string(), "[log]\nfile = \"l.csv\"\ncolumns = { time_ms = \"t\", q1_deg = 2 }\n");
        let mut several = lines();
        several.section_mut("log").unwrap().is_listed = true;
        assert!(several.section_mut("log").is_none() && several.to_string().starts_with("[[log]]\n"), "{several}");
        let mut left = lines();
        assert!(left.leave_open_times(&["\"t\"".to_owned()]));
        assert_eq!(left.to_string(), "[log]\nfile = \"l.csv\"\ncolumns = { q1_deg = 2 }\n");
        assert!(!lines().leave_open_times(&["\"u\"".to_owned()]));
    }

    #[test]
    fn lines_are_a_table_of_toml() {
        let mut lines = Lines::element("export")
            .with(Line::Remark("a name over\ntwo lines".to_owned()))
            .with(Line::File("p \"1\".txt".to_owned()))
            .with(Line::Label(Label::Open))
            .with(Line::Target(Target::Named("K \\ 1".to_owned(), "its column")))
            .with(Line::PoseByRow);
        lines.insert_behind_files(&Line::Text("encoding = \"latin1\"\n".to_owned()));
        let table: toml::Table = lines.to_string().parse().unwrap();
        let export = &table["export"][0];
        assert_eq!(export["file"].as_str(), Some("p \"1\".txt"));
        assert_eq!(export["target"].as_str(), Some("K \\ 1"));
        assert_eq!(export["label"].as_str(), Some("{target}_{pose}_{cycle}"));
        assert_eq!(export["encoding"].as_str(), Some("latin1"));
    }
}
