//! The report as one HTML page that needs no network: layout by templates, which a laboratory may replace by its own.

use super::TYPESET;
use super::model::Contents;
use super::supervised::supervised;
use super::words::{Words, isolated};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use etalon_base::message::{Message, Place, Problems, Result, one_line};
use etalon_documents::Presentation;
use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Rest, Serde};
use minijinja::{Environment, UndefinedBehavior, Value};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::error::Error;

/// Every template by its name; the ending turns escaping on.
pub(super) const BUILT_IN: [(&str, &str); 7] = [
    ("report.html", include_str!("html/report.html")),
    ("batch.html", include_str!("html/batch.html")),
    ("blocks.html", include_str!("html/blocks.html")),
    ("head.html", include_str!("html/head.html")),
    ("signatures.html", include_str!("html/signatures.html")),
    ("style.html", include_str!("html/style.html")),
    ("picture.css", include_str!("html/picture.css")),
];

/// What makes marks answer; the page's policy lets no other script run.
pub(super) const SCRIPT: &str = include_str!("html/script.js");
/// The same of the page over all campaigns of a batch.
const BATCH_SCRIPT: &str = include_str!("html/batch.js");

/// The page; of control characters, which no name is known to need, line feeds and tabs stay.
pub(super) fn html(contents: &Contents, presentation: &Presentation, words: &Words) -> Result<String> {
    page("report.html", SCRIPT, contents, presentation, words)
}

/// The page over all campaigns of a batch.
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
    let (contents, presentation, words) = (Value::from(Serde(contents)), presentation.clone(), words.clone());
    supervised(template, own, move || filled(template, script, &contents, &presentation, &words))
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
    let page = environment.get_template(template).map_err(fail)?.render(contents).map_err(fail)?;
    let page: String =
        page.chars().map(|c| if c.is_control() && !matches!(c, '\n' | '\t') { '\u{fffd}' } else { c }).collect();
    Ok(if page.len() > LARGE { marks_by_number(&page) } else { page })
}

/// A page of more bytes has the text of each mark once, where its script finds it; its tables have the numbers without a script.
const LARGE: usize = 600_000;

/// The page with the number of its text in place of the title of every mark, and these texts as data.
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
    // already escaped for HTML, where a template is read as text
    let data = format!("<template id=\"texts\">{}</template>\n<script>", texts.join("\n"));
    out.replacen("<script>", &data, 1)
}

/// Whether the laboratory's templates read, without a page to fill.
pub(super) fn check(presentation: &Presentation) -> Result<()> {
    environment(presentation, &Words::default()).map(|_| ())
}

fn environment<'a>(presentation: &'a Presentation, words: &Words) -> Result<Environment<'a>> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build();
    environment.set_syntax(syntax.map_err(|e| failure(&e, presentation))?);
    environment.add_filter("one_line", |text: String| one_line(&text));
    environment.add_filter("isolated", |text: String| isolated(&text));
    let words = words.clone();
    environment.add_filter("t", move |text: String, values: Rest<Value>| {
        let values: Vec<&dyn std::fmt::Display> = values.iter().map(|v| v as &dyn std::fmt::Display).collect();
        words.fill(&text, &values)
    });
    environment.add_global("lang", presentation.language.code());
    environment.add_global("logo", presentation.logo.as_deref());
    for (name, text) in BUILT_IN {
        environment.add_template(name, text).map_err(|e| failure(&e, presentation))?;
    }
    let own = presentation.templates.iter().filter(|(name, _)| *name != TYPESET.0);
    let read = |(name, text): (&'a String, &'a String)| environment.add_template(name, text).err();
    let problems = Problems(own.filter_map(read).map(|e| failure(&e, presentation)).collect());
    problems.check()?;
    Ok(environment)
}

/// What is wrong with a template, with its line where it is the laboratory's.
fn failure(error: &minijinja::Error, presentation: &Presentation) -> Message {
    // of a template within a template the innermost is wrong
    if let Some(inner) = error.source().and_then(|inner| inner.downcast_ref()) {
        return failure(inner, presentation);
    }
    let what = error.detail().map_or_else(|| error.kind().to_string(), |detail| format!("{}: {detail}", error.kind()));
    let message = Message::error(format!("the report's template does not work: {what}"));
    let Some((name, line)) = error.name().zip(error.line()) else { return message };
    match presentation.templates.get(name).and_then(|text| text.lines().nth(line.saturating_sub(1))) {
        Some(text) => message.at(Place::line(name, line, text)),
        None => message.at(Place::file(name)),
    }
}
