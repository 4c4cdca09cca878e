//! Mechanical rules of plain English for the comments of the source code.

use crate::support::root;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Maximum width of a line that holds only a comment (columns).
const MAX_WIDTH: usize = 100;

/// Beginnings of headless clauses and of sentences whose subject is a pronoun.
const BANNED_FIRST: [&str; 12] =
    ["What", "Whether", "How", "Where", "The same", "Those", "One that", "Of", "By", "It", "That", "Which"];

/// Remaining violations of each crate; a number may only be lowered, and the goal is zero.
const REMAINING: [(&str, usize); 17] = [
    ("base", 0),
    ("campaign", 0),
    ("cli", 0),
    ("compare", 0),
    ("controllers", 0),
    ("documents", 0),
    ("etalon", 0),
    ("fit", 0),
    ("formats", 0),
    ("identify", 0),
    ("math", 0),
    ("report", 0),
    ("robots", 0),
    ("run", 0),
    ("simulate", 0),
    ("stages", 0),
    ("standards", 0),
];

/// A comment: consecutive lines with one marker, or the end of a line of code.
#[derive(Debug, Default)]
struct Comment {
    /// Number of the first line, from 1.
    line: usize,
    /// `///`, `//!` or `//`; empty for a comment after code.
    marker: &'static str,
    /// Text of each line without marker and indentation.
    text: Vec<String>,
    /// Width of each line in the file (columns).
    widths: Vec<usize>,
}

impl Comment {
    fn is_documentation(&self) -> bool {
        matches!(self.marker, "///" | "//!")
    }

    /// Returns the first paragraph in one line; a list, table or code block ends the paragraph.
    fn first_paragraph(&self) -> String {
        let ends = |line: &str| line.is_empty() || ["- ", "* ", "| ", "1. ", "```"].iter().any(|m| line.starts_with(m));
        let lines = self.text.iter().map(|line| line.trim()).take_while(|line| !ends(line));
        lines.collect::<Vec<_>>().join(" ")
    }
}

/// Returns the marker of a line that holds only a comment.
fn marker(line: &str) -> Option<&'static str> {
    let starts = |marker: &&&str| line.trim_start().starts_with(**marker);
    ["///", "//!", "//"].iter().find(starts).copied()
}

/// Returns the comment at the end of a line of code, if there is one outside a string.
fn after_code(line: &str) -> Option<&str> {
    let outside = |(at, _): &(usize, &str)| line[..*at].matches('"').count().is_multiple_of(2);
    line.match_indices(" // ").find(outside).map(|(at, _)| &line[at + " // ".len()..])
}

/// Returns all comments of a file.
fn comments(text: &str) -> Vec<Comment> {
    let mut all: Vec<Comment> = Vec::new();
    let mut previous = None;
    for (line, number) in text.lines().zip(1..) {
        let marker = marker(line);
        if let Some(marker) = marker {
            if previous != Some(marker) {
                all.push(Comment { line: number, marker, ..Default::default() });
            }
            let comment = all.last_mut().unwrap();
            comment.text.push(line.trim_start()[marker.len()..].trim().to_owned());
            comment.widths.push(line.chars().count());
        } else if let Some(text) = after_code(line) {
            all.push(Comment { line: number, text: vec![text.to_owned()], ..Default::default() });
        }
        previous = marker;
    }
    all
}

/// Returns the violations in a comment: line and rule.
fn violations(comment: &Comment) -> Vec<(usize, String)> {
    let mut wrong = Vec::new();
    let lines = comment.widths.iter().zip(comment.line..);
    let wide = lines.filter(|(width, _)| **width > MAX_WIDTH);
    wrong.extend(wide.map(|(width, line)| (line, format!("{width} columns, at most {MAX_WIDTH}"))));
    if comment.is_documentation() {
        let first = comment.first_paragraph();
        let begins = |words: &&&str| first.strip_prefix(**words).is_some_and(|rest| rest.starts_with([' ', ',', ':']));
        if let Some(words) = BANNED_FIRST.iter().find(begins) {
            wrong.push((comment.line, format!("a doc comment begins with a noun phrase or a verb, not `{words}`")));
        }
        let end = first.trim_end_matches([')', '"', '*', '`']);
        if !end.ends_with(['.', ':']) {
            wrong.push((comment.line, "the first sentence of a doc comment ends with a full stop".to_owned()));
        }
    }
    // what is in backticks is code
    let text = comment.text.join(" ");
    let prose: String = text.split('`').step_by(2).collect::<Vec<_>>().join("` `");
    if prose.contains("is none ")
        || prose.ends_with("is none")
        || ["is none.", "is none,"].iter().any(|w| prose.contains(w))
    {
        wrong.push((comment.line, "`is none`: state what the thing is".to_owned()));
    }
    if prose.split([' ', ',', '.', ';', ':', '(', ')', '/']).any(|word| word == "um") {
        wrong.push((comment.line, "`um`: the unit is µm".to_owned()));
    }
    wrong
}

/// All Rust files of `src` with the name of their crate or of their module of the program.
fn files() -> Vec<(String, PathBuf)> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap().flatten() {
            let path = entry.path();
            if path.is_dir() {
                walk(&path, found);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    let (src, mut found) = (root().join("src"), Vec::new());
    walk(&src, &mut found);
    found.sort();
    let name = |path: &Path| {
        let inside: Vec<_> =
            path.strip_prefix(&src).unwrap().iter().map(|n| n.to_string_lossy().into_owned()).collect();
        if inside.len() > 1 { inside[0].clone() } else { "etalon".to_owned() }
    };
    found.into_iter().map(|path| (name(&path), path)).collect()
}

#[test]
fn comments_keep_the_mechanical_rules_of_plain_english() {
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (name, path) in files() {
        let of_crate = found.entry(name).or_default();
        let shown = path.strip_prefix(root()).unwrap().display();
        for comment in comments(&std::fs::read_to_string(&path).unwrap()) {
            of_crate.extend(violations(&comment).into_iter().map(|(line, rule)| format!("{shown}:{line}: {rule}")));
        }
    }
    let allowed: BTreeMap<&str, usize> = REMAINING.into_iter().collect();
    let mut wrong = String::new();
    for (name, violations) in &found {
        let allowed = allowed.get(name.as_str()).copied().unwrap_or(0);
        if violations.len() > allowed {
            let _ = writeln!(wrong, "{}", violations.join("\n"));
            let _ = writeln!(wrong, "`{name}`: {} violations, at most {allowed}", violations.len());
        } else if violations.len() < allowed {
            println!("`{name}`: {} violations remain: lower its number in tests/prose.rs", violations.len());
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn each_rule_finds_its_violation_and_nothing_else() {
    let rules = |text: &str| -> Vec<String> {
        comments(text).iter().flat_map(violations).map(|(line, rule)| format!("{line}: {rule}")).collect()
    };
    let sound = "//! Lengths in µm.\n\n/// Returns the radius, which is `none` for `um`:\n/// - a point\nfn f() {} // of \
                 course\n/// Whatever was read.\nlet url = \"http // What is none\";\n";
    assert_eq!(rules(sound), Vec::<String>::new());
    assert_eq!(rules("/// Whether it holds.").len(), 1);
    assert_eq!(rules("x();\n/// The same, in mm.")[0][..2], *"2:");
    assert_eq!(
        rules("/// No full stop\n///\n/// Here is one."),
        ["1: the first sentence of a doc comment ends with a full stop"]
    );
    assert_eq!(rules("f(); // a radius that is none").len(), 1);
    assert_eq!(rules("// 5 um at most").len(), 1);
    assert_eq!(rules(&format!("// {}", "x".repeat(98))), ["1: 101 columns, at most 100"]);
    assert_eq!(rules(&format!("// {}", "x".repeat(97))), Vec::<String>::new());
}
