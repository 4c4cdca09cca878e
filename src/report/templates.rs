//! The templates of the reports: those that are built in, and those that a laboratory puts in their place.

use super::words::{Words, isolated};
use super::{facts, number};
use crate::base::message::{Message, Place, Problems, Result, one_line};
use crate::document::Presentation;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use minijinja::syntax::SyntaxConfig;
use minijinja::value::{Rest, Serde};
use minijinja::{Environment, UndefinedBehavior, Value};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::error::Error;

/// Every template by its name; the ending turns escaping on.
pub const BUILT_IN: [(&str, &str); 19] = [
    ("report.html", include_str!("report.html")),
    ("repeatability.html", include_str!("repeatability.html")),
    ("plan.html", include_str!("plan/plan.html")),
    ("compare.html", include_str!("compare/compare.html")),
    ("style.html", include_str!("style.html")),
    ("picture.css", include_str!("picture.css")),
    ("head.html", include_str!("parts/head.html")),
    ("macros.html", include_str!("parts/macros.html")),
    ("campaign.html", include_str!("parts/campaign.html")),
    ("messages.html", include_str!("parts/messages.html")),
    ("contents.html", include_str!("parts/contents.html")),
    ("tested.html", include_str!("parts/tested.html")),
    ("iso9283.html", include_str!("parts/iso9283.html")),
    ("streams.html", include_str!("parts/streams.html")),
    ("compliance.html", include_str!("parts/compliance.html")),
    ("frames.html", include_str!("parts/frames.html")),
    ("import.html", include_str!("parts/import.html")),
    ("provenance.html", include_str!("parts/provenance.html")),
    ("signatures.html", include_str!("parts/signatures.html")),
];

/// What makes marks answer; the page's policy lets no other script run.
pub(super) const SCRIPT: &str = include_str!("script.js");

/// The template of report.pdf, in the language of typst.
pub const TYPESET: (&str, &str) = ("report.typ", include_str!("pdf/report.typ"));

/// A page from the template of this name; of control characters, which no name is known to need, line feeds and tabs stay.
pub(super) fn render<T: Serialize>(name: &str, presentation: &Presentation, words: &Words, page: T) -> Result<String> {
    let environment = environment(presentation, words)?;
    let fail = |e: minijinja::Error| Problems::from(told(&e, presentation));
    let page = environment.get_template(name).map_err(fail)?.render(Serde(page)).map_err(fail)?;
    Ok(page.chars().map(|c| if c.is_control() && !matches!(c, '\n' | '\t') { '\u{fffd}' } else { c }).collect())
}

/// Whether the laboratory's templates read, without a page to fill.
pub fn check(presentation: &Presentation) -> Result<()> {
    environment(presentation, &Words::default())?;
    #[cfg(feature = "pdf")]
    presentation.templates.get(TYPESET.0).map_or(Ok(()), |text| super::pdf::check(text))?;
    Ok(())
}

fn environment<'a>(presentation: &'a Presentation, words: &Words) -> Result<Environment<'a>> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build();
    environment.set_syntax(syntax.map_err(|e| told(&e, presentation))?);
    environment.add_filter("significant", |value: f64, digits: usize| number::significant(value, digits));
    environment.add_filter("fixed", |value: f64, decimals: usize| number::fixed(value, decimals));
    environment.add_filter("stated", facts::stated);
    environment.add_filter("one_line", |text: String| one_line(&text));
    environment.add_filter("isolated", |text: String| isolated(&text));
    let words = words.clone();
    environment.add_filter("t", move |text: String, values: Rest<Value>| {
        let values: Vec<&dyn std::fmt::Display> = values.iter().map(|v| v as &dyn std::fmt::Display).collect();
        words.fill(&text, &values)
    });
    environment.add_global("lang", presentation.language.code());
    environment.add_global("logo", presentation.logo.as_deref());
    environment.add_global("script", SCRIPT);
    environment.add_global("script_sha256", STANDARD.encode(Sha256::digest(SCRIPT)));
    for (name, text) in BUILT_IN {
        environment.add_template(name, text).map_err(|e| told(&e, presentation))?;
    }
    let own = presentation.templates.iter().filter(|(name, _)| *name != TYPESET.0);
    let read = |(name, text): (&'a String, &'a String)| environment.add_template(name, text).err();
    let problems = Problems(own.filter_map(read).map(|e| told(&e, presentation)).collect());
    problems.check()?;
    Ok(environment)
}

/// What is wrong with a template, with its line where it is the laboratory's.
fn told(error: &minijinja::Error, presentation: &Presentation) -> Message {
    // of a template within a template the innermost is wrong
    if let Some(inner) = error.source().and_then(|inner| inner.downcast_ref()) {
        return told(inner, presentation);
    }
    let what = error.detail().map_or_else(|| error.kind().to_string(), |detail| format!("{}: {detail}", error.kind()));
    let message = Message::error(format!("the report's template does not work: {what}"));
    let Some((name, line)) = error.name().zip(error.line()) else { return message };
    match presentation.templates.get(name).and_then(|text| text.lines().nth(line.saturating_sub(1))) {
        Some(text) => message.at(Place::line(name, line, text)),
        None => message.at(Place::file(name)),
    }
}
