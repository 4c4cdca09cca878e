//! Plain English in pages, help texts and messages: short sentences, and the terms of the field.

use crate::support::pages::{pages, shown};
use etalon::base::catalogue::{Entry, entries};
use etalon::documents::{Explanation, ExplanationDocument};
use std::collections::BTreeMap;
use std::process::Command;

/// Maximum number of words of a sentence; a piece of code counts as one word, and so does a list of them.
const MAX_WORDS: usize = 25;

/// Words that have a term of the field, and this term.
const TERMS: [(&str, &str); 14] = [
    ("beside", "in addition to, next to, compared with"),
    ("by ISO", "to ISO"),
    ("foreign", "outlier, of others"),
    ("is none", "what the thing is"),
    ("largest accuracy", "upper limit of AP"),
    ("more than chance", "significant, with the level of the test"),
    ("proven", "supported by the data, shown"),
    ("protocol", "record, report, log"),
    ("set aside", "excluded"),
    ("slip", "mistake of the set-up, seeded fault"),
    ("slips", "mistakes of the set-up, seeded faults"),
    ("sound", "correct, without a fault"),
    ("those of", "the noun itself"),
    ("um", "µm"),
];

/// Terms that messages still lack; the number may only be lowered, and the goal is zero.
const OF_MESSAGES: [(&str, usize); 3] = [("beside", 0), ("those of", 0), ("um", 0)];

/// Remaining long sentences of each page; a number may only be lowered, and the goal is zero.
const REMAINING: [(&str, usize); 15] = [
    ("benches/README.md", 25),
    ("docs/decisions/0001-chart-layer.md", 1),
    ("docs/decisions/0003-own-least-squares.md", 2),
    ("docs/decisions/0006-release-profile.md", 2),
    ("docs/decisions/0007-nominal-values-as-readings.md", 2),
    ("docs/decisions/0008-catalogue.md", 1),
    ("docs/decisions/0010-python-module.md", 3),
    ("docs/decisions/0011-verdicts.md", 1),
    ("docs/decisions/0012-ratios-and-shares.md", 2),
    ("docs/decisions/0013-effective-parameters.md", 4),
    ("docs/decisions/0016-xacro.md", 2),
    ("docs/decisions/0017-scans.md", 3),
    ("docs/decisions/0019-judge.md", 7),
    ("samples/reference/README.md", 7),
    ("tests/real/README.md", 5),
];

/// Remaining long sentences of messages, a number that may only be lowered.
const LONG_MESSAGES: usize = 35;

/// Paragraphs, list items and cells of a page outside blocks, each with its line. Code in backticks is `x`, a link its text.
fn paragraphs(page: &str) -> Vec<(usize, String)> {
    let mut all: Vec<(usize, String)> = Vec::new();
    let (mut fenced, mut indented, mut open) = (false, false, false);
    let mut after_blank = true;
    for (line, number) in page.lines().zip(1..) {
        let text = line.trim_start();
        if text.starts_with("```") {
            fenced = !fenced;
            open = false;
            continue;
        }
        indented = line.starts_with("    ") && (after_blank || indented);
        after_blank = text.is_empty();
        let item = ["- ", "* "].iter().find_map(|mark| text.strip_prefix(mark));
        let numbered = text.split_once(". ").filter(|(n, _)| n.parse::<u8>().is_ok()).map(|(_, rest)| rest);
        if fenced || indented || text.is_empty() || text.starts_with('#') || text.starts_with("<!--") {
            open = false;
        } else if text.starts_with('|') {
            let cells = text.replace("\\|", " ");
            all.extend(cells.split('|').filter(|cell| !cell.trim().is_empty()).map(|cell| (number, cell.to_owned())));
            open = false;
        } else if let Some(text) = item.or(numbered) {
            all.push((number, text.to_owned()));
            open = true;
        } else if let Some((_, last)) = all.last_mut().filter(|_| open) {
            *last += &format!(" {text}");
        } else {
            all.push((number, text.to_owned()));
            open = true;
        }
    }
    all.into_iter().map(|(line, text)| (line, prose(&text))).collect()
}

/// A text without code and without addresses of links.
fn prose(text: &str) -> String {
    let code: Vec<&str> = text.split('`').step_by(2).collect();
    let mut rest = code.join("`x`").replace("](", "]\u{1}");
    while rest.contains("`x`, `x`") {
        rest = rest.replace("`x`, `x`", "`x`");
    }
    while let Some(at) = rest.find('\u{1}') {
        let end = rest[at..].find(')').map_or(rest.len(), |length| at + length + 1);
        rest.replace_range(at..end, "");
    }
    rest
}

/// Words before a full stop that ends no sentence.
const ABBREVIATIONS: [&str; 6] = ["e.g", "eq", "et al", "Fig", "i.e", "vol"];

/// Sentences of a paragraph: each ends at `.`, `!` or `?` before a blank and a capital letter, a digit, code or a quotation.
fn sentences(text: &str) -> Vec<&str> {
    let mut all = Vec::new();
    let mut start = 0;
    for (at, _) in text.match_indices(['.', '!', '?']) {
        let end = at + 1 + text[at + 1..].len() - text[at + 1..].trim_start_matches(['"', '”', ')', '*']).len();
        let next = text[end..].trim_start();
        let last = text[start..at].rsplit([' ', '(']).next().unwrap_or("");
        let begins = !ABBREVIATIONS.contains(&last)
            && next.starts_with(|c: char| c.is_uppercase() || c.is_ascii_digit() || "`\"“([*µ".contains(c));
        if begins && next.len() < text[end..].len() && end >= start {
            all.push(&text[start..end]);
            start = end;
        }
    }
    all.push(&text[start..]);
    all
}

/// Number of words: parts between blanks with a letter or a digit.
fn words(sentence: &str) -> usize {
    sentence.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count()
}

/// Sentences of more than 25 words.
fn long(text: &str) -> Vec<&str> {
    sentences(text).into_iter().filter(|sentence| words(sentence) > MAX_WORDS).collect()
}

/// Words that have a term of the field.
fn terms(text: &str) -> Vec<(&'static str, &'static str)> {
    let boundary = |c: Option<char>| c.is_none_or(|c| !(c.is_alphanumeric() || c == '-' || c == '_'));
    let whole = |word: &str| {
        text.match_indices(word)
            .any(|(at, _)| boundary(text[..at].chars().next_back()) && boundary(text[at + word.len()..].chars().next()))
    };
    TERMS.into_iter().filter(|(word, _)| whole(word)).collect()
}

#[test]
fn sentences_of_pages_are_short() {
    let allowed: BTreeMap<&str, usize> = REMAINING.into_iter().collect();
    let mut wrong = Vec::new();
    for page in pages() {
        let name = shown(&page);
        let text = std::fs::read_to_string(&page).unwrap();
        let found: Vec<String> = paragraphs(&text)
            .iter()
            .flat_map(|(line, text)| {
                long(text).into_iter().map(|s| format!("{name}:{line}: {} words: {s}", words(s))).collect::<Vec<_>>()
            })
            .collect();
        let allowed = allowed.get(name.as_str()).copied().unwrap_or(0);
        if found.len() > allowed {
            wrong.extend(found.iter().cloned());
            wrong.push(format!("{name}: {} sentences of more than {MAX_WORDS} words, at most {allowed}", found.len()));
        } else if found.len() < allowed {
            println!("{name}: {} long sentences remain: lower its number in tests/plain.rs", found.len());
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn pages_use_the_terms_of_the_field() {
    let mut wrong = Vec::new();
    for page in pages() {
        for (line, text) in paragraphs(&std::fs::read_to_string(&page).unwrap()) {
            wrong.extend(terms(&text).iter().map(|(word, term)| format!("{}:{line}: `{word}`: {term}", shown(&page))));
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn messages_are_plain() {
    let explained: Vec<_> = entries().into_iter().filter(Entry::is_message).collect();
    let (mut wrong, mut sentences) = (Vec::new(), Vec::new());
    let mut left: BTreeMap<&str, usize> = OF_MESSAGES.into_iter().collect();
    for message in ExplanationDocument::new(&explained).messages {
        let Explanation { id, text, expected, hint, meaning, reason, action, example } = message;
        let texts = [Some(text), expected, hint, Some(meaning), Some(reason), Some(action), Some(example)];
        for text in texts.into_iter().flatten().map(|text| prose(&text)) {
            sentences.extend(long(&text).into_iter().map(|s| format!("{id}: {} words: {s}", words(s))));
            for (word, term) in terms(&text) {
                match left.get_mut(word) {
                    Some(left) if *left > 0 => *left -= 1,
                    _ => wrong.push(format!("{id}: `{word}`: {term}")),
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
    let count = sentences.len();
    assert!(count <= LONG_MESSAGES, "\n{}\n{count} long sentences, at most {LONG_MESSAGES}", sentences.join("\n"));
}

/// Help of all commands: the description of each command and option.
#[test]
fn help_texts_are_plain() {
    let folder = tempfile::tempdir().unwrap();
    let made =
        Command::new(crate::support::program()).args(["man", "pages"]).current_dir(folder.path()).output().unwrap();
    assert!(made.status.success());
    let mut wrong = Vec::new();
    let mut pages = 0;
    for entry in std::fs::read_dir(folder.path().join("pages")).unwrap().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        pages += 1;
        assert!(!name.contains("help"), "{name}: a page of `help`");
        let text = std::fs::read_to_string(entry.path()).unwrap().replace("\\-", "-");
        // requests of roff and names of options end a paragraph
        for text in text.split("\n.").flat_map(|part| part.split_once('\n')).map(|(_, text)| text.replace('\n', " ")) {
            // layouts in columns are no sentences
            if text.contains("\\fB") || text.contains("   ") {
                continue;
            }
            wrong.extend(long(&text).into_iter().map(|s| format!("{name}: {} words: {s}", words(s))));
            wrong.extend(terms(&text).into_iter().map(|(word, term)| format!("{name}: `{word}`: {term}")));
        }
    }
    assert!(pages > 20, "{pages} pages");
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn the_rules_find_their_violations_and_nothing_else() {
    let page = "# A heading of more words than any sentence may have is no sentence and is not counted at all by this rule here\n\n\
                Short. A value of `a b c d e f g` and a [link](../to/some-page.md#of).\n\n\
                - One item\n  of two lines.\n- Another.\n\n| a | b. C |\n| --- | --- |\n\n    code beside code\n\n```\nslip\n```\n";
    let found: Vec<String> = paragraphs(page).into_iter().map(|(_, text)| text.trim().to_owned()).collect();
    assert_eq!(found[0], "Short. A value of `x` and a [link].");
    assert_eq!(&found[1..5], ["One item of two lines.", "Another.", "a", "b. C"]);
    assert_eq!(sentences("A b (eq. 3.1). Then c. `x` is d").len(), 3);
    assert_eq!(words("a – b, 3 mm"), 4);
    let long_one = format!("{}end.", "word ".repeat(25));
    assert_eq!((long(&long_one).len(), long(&long_one[5..]).len()), (1, 0));
    let names = |text: &str| terms(text).into_iter().map(|(word, _)| word).collect::<Vec<_>>();
    assert_eq!(names("a slip beside those of the set, 5 um"), ["beside", "slip", "those of", "um"]);
    assert_eq!(names("datum, a set-aside, soundness"), Vec::<&str>::new());
}
