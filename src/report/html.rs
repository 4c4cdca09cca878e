//! Report as a single HTML page without network access, laid out by templates that a laboratory may
//! replace.

use super::TYPESET;
use super::model::Contents;
use super::words::{Words, isolated};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use etalon_base::catalogue::{Arguments, Phrase};
use etalon_base::error;
use etalon_base::message::{Message, Place, Problems, Result, one_line};
use etalon_base::template::{bound, check_nesting, fill, innermost, reason, supervised};
use etalon_documents::Presentation;
use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Kwargs, Serde};
use minijinja::{Environment, UndefinedBehavior, Value};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Built-in templates by file name, whose extension enables escaping.
pub(super) const BUILT_IN: [(&str, &str); 7] = [
    ("report.html", include_str!("html/report.html")),
    ("batch.html", include_str!("html/batch.html")),
    ("blocks.html", include_str!("html/blocks.html")),
    ("head.html", include_str!("html/head.html")),
    ("signatures.html", include_str!("html/signatures.html")),
    ("style.html", include_str!("html/style.html")),
    ("picture.css", include_str!("html/picture.css")),
];

/// Maximum number of instructions of a page with templates of a laboratory.
const INSTRUCTIONS: u64 = 200_000_000;

/// Script for interactive marks; the policy of the page allows no other script.
pub(super) const SCRIPT: &str = include_str!("html/script.js");
/// Script of the overview page of a batch.
const BATCH_SCRIPT: &str = include_str!("html/batch.js");

/// Page of a report. Control characters except line feeds and tabs are removed.
pub(super) fn html(contents: &Contents, presentation: &Presentation, words: &Words) -> Result<String> {
    page("report.html", SCRIPT, contents, presentation, words)
}

/// Overview page of all campaigns of a batch.
pub(super) fn batch(contents: &impl Serialize, presentation: &Presentation, words: &Words) -> Result<String> {
    page("batch.html", BATCH_SCRIPT, contents, presentation, words)
}

fn page(
    template: &'static str,
    script: &'static str,
    contents: &impl Serialize,
    presentation: &Presentation,
    words: &Words,
) -> Result<String> {
    let own = presentation.templates.keys().any(|name| name != TYPESET.0);
    let (contents, presentation, words) = (Value::from(Serde(contents)), presentation.clone(), *words);
    if !own {
        return filled(template, script, &contents, &presentation, &words);
    }
    supervised(template, move || filled(template, script, &contents, &presentation, &words))
}

fn filled(
    template: &str,
    script: &str,
    contents: &Value,
    presentation: &Presentation,
    words: &Words,
) -> Result<String> {
    let mut environment = environment(presentation, words)?;
    environment.add_global("script", script);
    environment.add_global("script_sha256", STANDARD.encode(Sha256::digest(script)));
    let fail = |e: minijinja::Error| Problems::from(failure(&e, presentation));
    let page = environment.get_template(template).and_then(|page| match presentation.templates.is_empty() {
        true => page.render(contents),
        false => fill(&page, contents.clone()),
    });
    let page = page.map_err(fail)?;
    let is_forbidden = |c: char| c.is_control() && !matches!(c, '\n' | '\t');
    let page = if page.contains(is_forbidden) { page.replace(is_forbidden, "\u{fffd}") } else { page };
    Ok(if page.len() > LARGE { marks_by_number(&page) } else { page })
}

/// Size (bytes) above which a page holds the text of each mark once, for its script. Without a
/// script the tables contain the numbers.
const LARGE: usize = 600_000;

/// Replaces the titles of all marks by the numbers of their texts, and appends the texts as data.
fn marks_by_number(page: &str) -> String {
    let (mut texts, mut numbers) = (Vec::new(), BTreeMap::new());
    let mut out = String::with_capacity(page.len());
    for line in page.split_inclusive('\n') {
        let mark = line
            .split_once("><title>")
            .filter(|(head, _)| ["<circle", "<path", "<rect"].iter().any(|m| head.starts_with(m)));
        let Some((head, (text, tail))) = mark.and_then(|(head, rest)| Some((head, rest.split_once("</title>")?)))
        else {
            out.push_str(line);
            continue;
        };
        let number = *numbers.entry(text).or_insert_with(|| {
            texts.push(text);
            texts.len() - 1
        });
        let end = tail.strip_prefix("</").map_or(tail, |_| "/>\n");
        out.push_str(&format!("{head} data-i=\"{number}\"{end}"));
    }
    // the texts are escaped HTML, as the content of a template is
    let data = format!("<template id=\"texts\">{}</template>\n<script>", texts.join("\n"));
    out.replacen("<script>", &data, 1)
}

/// Checks nesting and syntax of the laboratory's templates without filling them.
pub(super) fn check(presentation: &Presentation) -> Result<()> {
    let own = presentation.clone();
    supervised("report.html", move || environment(&own, &Words::default()).map(|_| ()))
}

fn environment<'a>(presentation: &'a Presentation, words: &Words) -> Result<Environment<'a>> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build();
    environment.set_syntax(syntax.map_err(|e| failure(&e, presentation))?);
    environment.add_filter("one_line", |text: String| one_line(&text));
    environment.add_filter("isolated", |text: String| isolated(&text));
    let words = *words;
    environment.add_filter("t", move |id: String, arguments: Kwargs| translated(id, &arguments, &words));
    environment.add_global("lang", presentation.language.code());
    environment.add_global("logo", presentation.logo.as_deref());
    if !presentation.templates.is_empty() {
        bound(&mut environment, INSTRUCTIONS);
    }
    for (name, text) in BUILT_IN {
        environment.add_template(name, text).map_err(|e| failure(&e, presentation))?;
    }
    let own = presentation.templates.iter().filter(|(name, _)| *name != TYPESET.0);
    own.clone().try_for_each(|(name, text)| check_nesting(name, text))?;
    let read = |(name, text): (&'a String, &'a String)| environment.add_template(name, text).err();
    let problems = Problems(own.filter_map(read).map(|e| failure(&e, presentation)).collect());
    problems.check()?;
    Ok(environment)
}

/// Text of the catalogue in a template: `"rows-in-workbook"|t(count=3)`.
fn translated(id: String, arguments: &Kwargs, words: &Words) -> std::result::Result<String, minijinja::Error> {
    let mut phrase = Phrase { id: id.into(), arguments: Arguments::new() };
    for name in arguments.args() {
        let value: Value = arguments.get(name)?;
        phrase = match value.as_usize() {
            Some(count) => phrase.with(name, &count),
            None => phrase.with(name, &value.to_string()),
        };
    }
    Ok(words.tr(&phrase))
}

/// Error of a template, with its line for a template of the laboratory.
fn failure(error: &minijinja::Error, presentation: &Presentation) -> Message {
    let error = innermost(error);
    let message = error!("template-invalid", reason = reason(error, INSTRUCTIONS));
    let Some((name, line)) = error.name().zip(error.line()) else { return message };
    match presentation.templates.get(name).and_then(|text| text.lines().nth(line.saturating_sub(1))) {
        Some(text) => message.at(Place::line(name, line, text)),
        None => message.at(Place::file(name)),
    }
}
