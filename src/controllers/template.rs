//! Text formats as templates (minijinja) in `templates/`: a number is written with the digits that read back bit for bit.

use super::c_header::{comment, identifier, literal};
use super::code::real_literal;
use etalon_base::message::{Message, Result};
use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, Error, UndefinedBehavior, Value, escape_formatter};

/// A template filled with values.
///
/// # Errors
/// A template that does not work.
pub(super) fn render(template: &str, values: Value) -> Result<String> {
    let failed = |e: Error| Message::error(format!("the template of this format does not work: {e:#}"));
    let mut environment = Environment::new();
    let mut syntax = SyntaxConfig::builder();
    let syntax = syntax.trim_blocks(true).lstrip_blocks(true).keep_trailing_newline(true).build();
    environment.set_syntax(syntax.map_err(failed)?);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_formatter(|out, state, value| match is_float(value) {
        true => Ok(write!(out, "{:?}", f64::try_from(value.clone())?)?),
        false => escape_formatter(out, state, value),
    });
    environment.add_filter("comment", |text: String| comment(&text));
    environment.add_filter("identifier", |text: String| identifier(&text));
    environment.add_filter("quoted", |text: String| quoted(&text));
    environment.add_filter("literal", literal);
    environment.add_filter("iec", real_literal);
    environment.add_filter("fixed", |value: f64, decimals: usize| format!("{value:.decimals$}"));
    environment.add_filter("radians", f64::to_radians);
    environment.add_filter("degrees", f64::to_degrees);
    environment.add_filter("numbers", |values: Vec<f64>, between: String| {
        values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(&between)
    });
    Ok(environment.render_str(template, values).map_err(failed)?)
}

fn is_float(value: &Value) -> bool {
    value.is_number() && !value.is_integer()
}

/// A string of Python: that of JSON in ASCII.
fn quoted(text: &str) -> String {
    let escaped = |c: char| if c.is_ascii() { c.to_string() } else { format!("\\U{:08x}", u32::from(c)) };
    serde_json::Value::from(text).to_string().chars().map(escaped).collect()
}
