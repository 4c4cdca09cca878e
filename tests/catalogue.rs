//! The catalogue of messages: every call names a text of all languages with its arguments, every text is called, and every
//! message is explained.

use crate::support::root;
use etalon::base::catalogue::{FILES, LANGUAGES, entries};
use fluent_syntax::ast;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Records and names of file formats that messages quote.
const QUOTED: [&str; 6] = [
    "# === PolyWorks|Inspector project description file ===",
    "PLCopen XML",
    "POINT, PSET, MDI",
    "element vertex",
    "element vertex n",
    "property list",
];

/// Folders of `src` whose code has no sentence at all. The others write texts of one language: help of options, files for
/// controllers and other programs, proposed lines of a campaign, and names of columns in many languages.
const WITHOUT_SENTENCES: [&str; 11] =
    ["base", "campaign", "compare", "documents", "fit", "identify", "math", "report", "run", "simulate", "stages"];

/// Texts in these folders that are no sentences, or complete a sentence of the library that reads TOML.
const OF_OTHERS: [&str; 16] = [
    "Name, as at the start of its column.",
    "A joint, by number or name.",
    "is not current: run with ETALON_UPDATE=1",
    "AD AE AF AG AI",
    "The same in metres.",
    "The same in radians.",
    "a number of seconds, or",
    "a table in [ ] or tables",
    "mid over name",
    "position after, max [mm]",
    "position before, max [mm]",
    "the name of a file, or a list",
    "the name of a file, or { file",
    "the number or the name of a pose",
    "unknown variant",
    "µm per mm",
];

/// Messages that no test names, each with what it needs.
const UNTESTED: [(&str, &str); 8] = [
    ("convert-not-reproduced", "a fault of the conversion itself"),
    ("file-too-many-items", "a file of millions of elements, which needs hundreds of MB"),
    ("recording-failed", "a failure of the library that writes recordings, in memory"),
    ("results-not-synced", "a disk that fails while data are written to it"),
    ("run-while-exporting", "a run that ends within the milliseconds of an export"),
    ("selftest-data-unreadable", "a program file whose reference data are no longer JSON"),
    ("threads-failed", "a system that starts no thread"),
    ("topic-too-large", "a topic of more than 2 GiB"),
];

/// Texts in tests that share words with a message: the row of a certificate, the cell of a workbook, the unit of a key, the part of
/// a hint that names the key, and the reason inside a phrase.
const NOT_MESSAGES: [&str; 6] = [
    "date of the measurements",
    "not a number",
    "of the joint",
    "`unit` of the export",
    "out of reach",
    "25 % of the verified value",
];

/// Calls in a file.
#[derive(Debug, Default, PartialEq)]
struct Calls {
    /// Names of the macro, the id and the arguments.
    of_catalogue: Vec<(String, String, BTreeSet<String>)>,
    /// `Message::error(...)`, `Message::warning(...)`, and `.hint(...)`, `.expected(...)` without a phrase.
    free: usize,
    /// English text in arguments of the catalogue.
    arguments: Vec<String>,
    /// Strings that read as a sentence.
    sentences: Vec<String>,
}

/// `true` if a string has this many words one behind the other, apart from placeholders and names in backticks.
fn has_words(literal: &str, least: usize) -> bool {
    let mut outside = String::new();
    let mut closing = None;
    for c in literal.chars() {
        match (closing, c) {
            (Some(end), _) if c == end => closing = None,
            (Some(_), _) => {}
            (None, '{') => closing = Some('}'),
            (None, '`') => closing = Some('`'),
            (None, _) => outside.push(c),
        }
    }
    let is_word = |word: &str| {
        let word = word.trim_matches(['"', '(', ')', ',', '.', ':', ';']);
        word.len() > 1 && word.chars().all(|c| c.is_alphabetic() || c == '-' || c == '\'')
    };
    let mut run = 0;
    outside.split(' ').any(|word| {
        run = if is_word(word) { run + 1 } else { 0 };
        run >= least
    })
}

/// Strings in an argument, however deep; texts of the catalogue inside are read by themselves.
fn strings(tokens: TokenStream, found: &mut Vec<String>) {
    let mut macros: Vec<String> = Vec::new();
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                let is_text =
                    matches!(&macros[..], [.., name, mark] if mark == "!" && ["phrase", "tr"].contains(&&**name));
                if !is_text {
                    strings(group.stream(), found);
                }
            }
            TokenTree::Literal(literal) if literal.to_string().starts_with(['"', 'r']) => {
                found.push(literal.to_string());
            }
            other => macros.push(other.to_string()),
        }
    }
}

impl Calls {
    /// Notes English text in the arguments behind the id.
    fn note_arguments(&mut self, tokens: TokenStream) {
        let mut found = Vec::new();
        strings(behind_comma(tokens), &mut found);
        found.retain(|text| has_words(text, 2) && !QUOTED.contains(&text.trim_matches('"')));
        self.arguments.extend(found);
    }

    fn read(&mut self, tokens: TokenStream) {
        let mut all: Vec<TokenTree> = tokens.into_iter().collect();
        drop_tests(&mut all);
        for (i, token) in all.iter().enumerate() {
            let before = |n: usize| i.checked_sub(n).map(|at| all[at].to_string()).unwrap_or_default();
            if let TokenTree::Literal(literal) = token
                && has_words(&literal.to_string(), 3)
            {
                self.sentences.push(literal.to_string());
            }
            let TokenTree::Group(group) = token else { continue };
            let is_attribute = group.delimiter() == Delimiter::Bracket && ["#", "!"].contains(&&*before(1)) && {
                before(1) == "#" || before(2) == "#"
            };
            let is_assertion = before(1) == "!" && ["unreachable", "debug_assert"].contains(&&*before(2));
            if is_attribute || is_assertion {
                continue;
            }
            self.read(group.stream());
            if group.delimiter() != Delimiter::Parenthesis {
                continue;
            }
            match (before(2).as_str(), before(1).as_str()) {
                (name @ ("error" | "warning" | "phrase"), "!") => {
                    self.of_catalogue.extend(call(name, group.stream()));
                    self.note_arguments(group.stream());
                }
                (_, "meaning") => self.of_catalogue.extend(call("meaning", group.stream())),
                ("tr", "!") => {
                    self.of_catalogue.extend(call("tr", behind_comma(group.stream())));
                    self.note_arguments(behind_comma(group.stream()));
                }
                (":", "error" | "warning") if before(4) == "Message" => self.free += 1,
                (".", "hint" | "expected") if !is_phrase(group) && !group.stream().is_empty() => self.free += 1,
                _ => {}
            }
        }
    }
}

/// Removes modules and functions of tests.
pub fn drop_tests(all: &mut Vec<TokenTree>) {
    const OF_TESTS: [&str; 2] = ["[cfg(test)]", "[cfg(all(test,feature=\"schemas\"))]"];
    let is_test = |window: &[TokenTree]| {
        window[0].to_string() == "#"
            && OF_TESTS.contains(&&*window[1].to_string().replace(' ', ""))
            && ["mod", "pub"].contains(&&*window[2].to_string())
    };
    while let Some(at) = all.windows(3).position(is_test) {
        let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(g) if g.delimiter() == Delimiter::Brace);
        let end =
            all[at + 2..].iter().position(|t| is_body(t) || t.to_string() == ";").map_or(all.len(), |i| at + 3 + i);
        all.drain(at..end);
    }
}

fn is_phrase(group: &Group) -> bool {
    let text = group.stream().to_string();
    text.starts_with("phrase ! ") || text.starts_with("phrase!") || text == "hint" || text == "expected"
}

/// Tokens behind the first comma: the language of `tr!(words, "id", ...)` is not part of the text.
fn behind_comma(tokens: TokenStream) -> TokenStream {
    tokens.into_iter().skip_while(|token| token.to_string() != ",").skip(1).collect()
}

/// Calls in a template of a report: `"id"|t` and `"id"|t(argument=...)`.
fn calls_of_template(text: &str) -> Vec<(String, String, BTreeSet<String>)> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut all = Vec::new();
    for (end, _) in text.match_indices("\"|t").filter(|(end, call)| !text[end + call.len()..].starts_with(is_word)) {
        let start = text[..end].rfind('"').map_or(0, |quote| quote + 1);
        let values = text[end + 3..].strip_prefix('(').and_then(|rest| rest.split_once(')')).map_or("", |(all, _)| all);
        let names = values.split(',').filter_map(|value| Some(value.split_once('=')?.0.trim().to_owned()));
        all.push(("tr".to_owned(), text[start..end].to_owned(), names.collect()));
    }
    all
}

/// Id and names of the arguments of a call; `None` where the macro passes tokens on.
fn call(name: &str, tokens: TokenStream) -> Option<(String, String, BTreeSet<String>)> {
    let mut tokens = tokens.into_iter();
    let id = match tokens.next()? {
        TokenTree::Literal(literal) => literal.to_string().trim_matches('"').to_owned(),
        _ => return None,
    };
    let mut arguments = BTreeSet::new();
    let mut begins = false;
    for token in tokens {
        match &token {
            TokenTree::Punct(p) if p.as_char() == ',' => begins = true,
            TokenTree::Ident(argument) if begins => {
                arguments.insert(argument.to_string());
                begins = false;
            }
            _ => begins = false,
        }
    }
    Some((name.to_owned(), id, arguments))
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut all: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path()).collect();
    all.sort();
    for path in all {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        // the page of `etalon view` has texts of its own
        if path.is_dir() && !["tests", "page"].contains(&&*name) {
            sources(&path, found);
        } else if (name.ends_with(".rs") && name != "tests.rs") || name.ends_with(".html") {
            found.push(path);
        }
    }
}

/// Calls of each folder of `src`.
fn calls() -> BTreeMap<String, Calls> {
    let src = root().join("src");
    let mut files = Vec::new();
    sources(&src, &mut files);
    let mut all: BTreeMap<String, Calls> = BTreeMap::new();
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        let inside =
            path.strip_prefix(&src).unwrap().components().next().unwrap().as_os_str().to_string_lossy().into_owned();
        let found = all.entry(inside).or_default();
        match path.extension().is_some_and(|e| e == "html") {
            true => found.of_catalogue.extend(calls_of_template(&text)),
            false => found.read(text.parse().unwrap()),
        }
    }
    all
}

/// Arguments that a pattern names.
fn arguments<'s>(pattern: &ast::Pattern<&'s str>, found: &mut BTreeSet<&'s str>) {
    fn of_inline<'s>(expression: &ast::InlineExpression<&'s str>, found: &mut BTreeSet<&'s str>) {
        match expression {
            ast::InlineExpression::VariableReference { id } => _ = found.insert(id.name),
            ast::InlineExpression::FunctionReference { arguments, .. } => {
                arguments.positional.iter().for_each(|argument| of_inline(argument, found));
            }
            ast::InlineExpression::Placeable { expression } => of(expression, found),
            _ => {}
        }
    }
    fn of<'s>(expression: &ast::Expression<&'s str>, found: &mut BTreeSet<&'s str>) {
        match expression {
            ast::Expression::Inline(inline) => of_inline(inline, found),
            ast::Expression::Select { selector, variants } => {
                of_inline(selector, found);
                variants.iter().for_each(|variant| arguments(&variant.value, found));
            }
        }
    }
    for element in &pattern.elements {
        if let ast::PatternElement::Placeable { expression } = element {
            of(expression, found);
        }
    }
}

/// A text of the catalogue: its attributes and arguments.
#[derive(Debug, PartialEq, Eq)]
struct Shape {
    attributes: BTreeSet<String>,
    arguments: BTreeSet<String>,
}

/// Texts of a language by id; complaints about the syntax go to `wrong`.
fn texts(language: usize, wrong: &mut String) -> BTreeMap<String, Shape> {
    let mut all = BTreeMap::new();
    for (file, texts) in FILES {
        let name = format!("{}/{file}.ftl", LANGUAGES[language]);
        let resource = fluent_syntax::parser::parse(texts[language]).unwrap_or_else(|(resource, errors)| {
            errors.iter().for_each(|e| _ = writeln!(wrong, "{name}: {e}"));
            resource
        });
        for entry in &resource.body {
            let ast::Entry::Message(message) = entry else { continue };
            let mut found = BTreeSet::new();
            message.value.iter().for_each(|value| arguments(value, &mut found));
            message.attributes.iter().for_each(|attribute| arguments(&attribute.value, &mut found));
            let attributes = message.attributes.iter().map(|a| a.id.name.to_owned()).collect();
            let shape = Shape { attributes, arguments: found.into_iter().map(str::to_owned).collect() };
            if all.insert(message.id.name.to_owned(), shape).is_some() {
                let _ = writeln!(wrong, "{name}: `{}` is there twice", message.id.name);
            }
        }
    }
    all
}

#[test]
fn every_call_has_its_text_in_all_languages_and_every_text_its_call() {
    let mut wrong = String::new();
    let languages = [0, 1, 2].map(|language| texts(language, &mut wrong));
    let [english, others @ ..] = &languages;
    for (language, other) in LANGUAGES[1..].iter().zip(others) {
        for id in english.keys().chain(other.keys()).collect::<BTreeSet<_>>() {
            if english.get(id) != other.get(id) {
                let _ = writeln!(wrong, "`{id}`: {language} {:?}, en {:?}", other.get(id), english.get(id));
            }
        }
    }
    let mut called = BTreeSet::new();
    for (folder, calls) in calls() {
        for (_, id, mut arguments) in calls.of_catalogue {
            match english.get(&id) {
                None => _ = writeln!(wrong, "src/{folder}: `{id}` is not in the catalogue"),
                Some(shape) => {
                    // the text around a message has the message itself
                    arguments.extend(shape.arguments.get("message").cloned());
                    if shape.arguments != arguments {
                        let _ =
                            writeln!(wrong, "src/{folder}: `{id}` has {arguments:?}, its text {:?}", shape.arguments);
                    }
                }
            }
            called.insert(id);
        }
    }
    english.keys().filter(|id| !called.contains(*id)).for_each(|id| _ = writeln!(wrong, "`{id}` is never used"));
    assert!(called.len() > 40, "{}", called.len());
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn every_message_is_explained() {
    let called = calls();
    let messages =
        called.values().flat_map(|calls| &calls.of_catalogue).filter(|(name, ..)| name == "error" || name == "warning");
    let messages: BTreeSet<&str> = messages.map(|(_, id, _)| id.as_str()).collect();
    let mut wrong = String::new();
    for entry in entries() {
        let parts = [&entry.meaning, &entry.reason, &entry.action, &entry.example];
        let explained = parts.iter().filter(|part| !part.is_empty()).count();
        if explained != if messages.contains(entry.id) { 4 } else { 0 } {
            let _ = writeln!(wrong, "`{}` has {explained} parts of an explanation", entry.id);
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn no_message_is_outside_the_catalogue() {
    let free = calls().into_iter().filter(|(_, calls)| calls.free > 0);
    let free: Vec<String> = free.map(|(folder, calls)| format!("src/{folder}: {}", calls.free)).collect();
    assert!(free.is_empty(), "write these texts into the catalogue: {free:?}");
}

#[test]
fn arguments_of_texts_are_no_english() {
    let found = calls().into_iter().filter(|(_, calls)| !calls.arguments.is_empty());
    let found: Vec<String> = found.map(|(folder, calls)| format!("src/{folder}: {:?}", calls.arguments)).collect();
    assert!(found.is_empty(), "make each a phrase of the catalogue:\n{}", found.join("\n"));
}

#[test]
fn code_has_no_sentences_that_a_person_reads() {
    let all = calls();
    let sentences = WITHOUT_SENTENCES.iter().flat_map(|folder| all[*folder].sentences.iter().map(move |s| (folder, s)));
    let ours = sentences.filter(|(_, sentence)| !OF_OTHERS.iter().any(|text| sentence.contains(text)));
    let found: Vec<String> = ours.map(|(folder, sentence)| format!("src/{folder}: {sentence}")).collect();
    assert!(found.is_empty(), "make each a phrase of the catalogue:\n{}", found.join("\n"));
}

#[test]
fn english_is_found_in_arguments_and_in_code() {
    let source = r##"
        /// A sentence of a comment is no text.
        #[schemars(description = "A sentence of a schema is no text.")]
        fn f() {
            error!("a", x = "not measured", y = "keyword", z = format!("row {n} is bad"), w = phrase!("b", v = "two words"));
            tr!(words, "c", x = "in `a b` {c} words", y = "{a} {b}");
            document.reason = format!("line {line} names the columns").into();
            unreachable!("the last round returns");
        }
    "##;
    let mut calls = Calls::default();
    calls.read(source.parse().unwrap());
    calls.arguments.sort();
    assert_eq!(calls.arguments, ["\"not measured\"", "\"row {n} is bad\"", "\"two words\""]);
    assert_eq!(calls.sentences, ["\"line {line} names the columns\""]);
    assert!(has_words("\"row {n} is bad\"", 2) && !has_words("\"row {n} of\"", 2));
}

/// Text of all tests, tests of single files included.
fn tests(folder: &Path, is_test: bool, found: &mut String) {
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        let is_test = is_test || name == "tests" || name == "tests.rs";
        if path.is_dir() {
            tests(&path, is_test, found);
        } else if name.ends_with(".rs") && name != "catalogue.rs" {
            let text = std::fs::read_to_string(&path).unwrap();
            let start = if is_test { Some(0) } else { text.find("#[cfg(test)]\nmod tests") };
            found.push_str(start.map_or("", |start| &text[start..]));
        }
    }
}

/// `true` if a test names the id: in quotes alone or with arguments, or in the brackets of a terminal.
fn is_named(tests: &str, id: &str) -> bool {
    tests.match_indices(id).any(|(at, _)| {
        let (before, after) = (&tests[..at], &tests[at + id.len()..]);
        before.ends_with(['"', '[']) && after.starts_with(['"', ']', ' '])
    })
}

#[test]
fn every_message_is_named_by_a_test_or_states_why_not() {
    let (root, mut text) = (root(), String::new());
    tests(&root.join("src"), false, &mut text);
    tests(&root.join("tests"), true, &mut text);
    let called = calls();
    let messages =
        called.values().flat_map(|calls| &calls.of_catalogue).filter(|(name, ..)| name == "error" || name == "warning");
    let messages: BTreeSet<&str> = messages.map(|(_, id, _)| id.as_str()).collect();
    let unnamed: Vec<&str> = messages.into_iter().filter(|id| !is_named(&text, id)).collect();
    assert_eq!(unnamed, UNTESTED.map(|(id, _)| id), "test new messages (tests/messages)");
}

/// Words of a message without its arguments, which are replaced by line feeds.
fn words(pattern: &ast::Pattern<&str>, found: &mut String) {
    for element in &pattern.elements {
        match element {
            ast::PatternElement::TextElement { value } => found.push_str(value),
            ast::PatternElement::Placeable { expression: ast::Expression::Inline(_) } => found.push('\n'),
            ast::PatternElement::Placeable { expression: ast::Expression::Select { variants, .. } } => {
                variants.iter().for_each(|variant| {
                    found.push('\n');
                    words(&variant.value, found);
                });
            }
        }
    }
}

/// Texts in quotes of a file, without comments.
fn literals(tokens: TokenStream, found: &mut Vec<String>) {
    let is_comment = |group: &Group| {
        let first = group.stream().into_iter().next();
        group.delimiter() == Delimiter::Bracket && first.is_some_and(|token| token.to_string() == "doc")
    };
    for token in tokens {
        match token {
            TokenTree::Group(group) if is_comment(&group) => {}
            TokenTree::Group(group) => literals(group.stream(), found),
            TokenTree::Literal(literal) if literal.to_string().ends_with('"') => found.push(literal.to_string()),
            _ => {}
        }
    }
}

/// `true` if the text repeats words of a message: three in a row outside names and numbers.
fn is_prose(text: &str, messages: &str) -> bool {
    let outside =
        text.split('`').step_by(2).flat_map(|part| part.split(|c: char| c.is_ascii_digit() || "{}[]\"\\".contains(c)));
    outside.map(str::trim).any(|part| part.split_whitespace().count() > 2 && messages.contains(part))
}

#[test]
fn tests_name_messages_by_their_ids() {
    let called = calls();
    let ids: BTreeSet<&str> = called
        .values()
        .flat_map(|calls| &calls.of_catalogue)
        .filter(|(name, ..)| name == "error" || name == "warning")
        .map(|(_, id, _)| id.as_str())
        .collect();
    let mut messages = String::new();
    for (_, texts) in FILES {
        for entry in &fluent_syntax::parser::parse(texts[0]).unwrap().body {
            let ast::Entry::Message(message) = entry else { continue };
            message
                .value
                .iter()
                .filter(|_| ids.contains(message.id.name))
                .for_each(|value| words(value, &mut messages));
            messages.push('\n');
        }
    }
    let (root, mut text) = (root(), String::new());
    tests(&root.join("src"), false, &mut text);
    tests(&root.join("tests"), true, &mut text);
    let mut all = Vec::new();
    literals(text.parse().unwrap(), &mut all);
    assert!(all.len() > 10_000, "{}", all.len());
    // what a failing test prints has places for values
    all.retain(|text| !text.contains('{') && !NOT_MESSAGES.contains(&text.trim_matches('"')));
    let prose: Vec<&String> = all.iter().filter(|text| is_prose(text, &messages)).collect();
    assert!(prose.is_empty(), "assert ids and arguments (tests/support/said.rs): {prose:#?}");
}

#[test]
fn words_of_messages_are_found_between_names_and_numbers() {
    let messages = "no point has the label \n\nthe file \n does not exist";
    let prose = ["no point has the label `x`", "error[a-b]: the file `x` does not exist", "[a-b]", "did you mean `x`?"];
    assert_eq!(prose.map(|text| is_prose(text, messages)), [true, true, false, false]);
}

#[test]
fn an_id_is_named_in_quotes_or_brackets() {
    let tests = r#"error!("one") said("error[two]: x") ("three key=unit", "") "of four" four-five"#;
    let named = ["one", "two", "three", "four", "five", "x"].map(|id| is_named(tests, id));
    assert_eq!(named, [true, true, true, false, false, false]);
}

#[test]
fn calls_are_found_wherever_they_are() {
    let source = r#"
        fn f() { vec![error!("a", x, y = g(1, z))]; tr!(self.words, "d", n = tr!(words, "e")); Message::error("free").hint(phrase!("b")).expected("free"); }
        #[cfg(test)]
        mod tests { fn g() { warning!("c"); } }
    "#;
    let mut calls = Calls::default();
    calls.read(source.parse().unwrap());
    let ids: Vec<(&str, usize)> = calls.of_catalogue.iter().map(|(_, id, all)| (id.as_str(), all.len())).collect();
    assert_eq!((ids, calls.free), (vec![("a", 2), ("e", 0), ("d", 1), ("b", 0)], 2));
    let template = r#"{{ "a"|t }} {{ "plain"|title }} {{ "b-c"|t(n=x|length, m=1) }}"#;
    let ids: Vec<(String, usize)> =
        calls_of_template(template).into_iter().map(|(_, id, all)| (id, all.len())).collect();
    assert_eq!(ids, [("a".to_owned(), 0), ("b-c".to_owned(), 2)]);
}
