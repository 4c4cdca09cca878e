//! Text formats as templates (minijinja) in `templates/`, with their notation of names and numbers:
//! digits that read back bit for bit.

use super::decimals::fixed;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::template::check_width;
use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, Error, UndefinedBehavior, Value, escape_formatter};

/// Fills a template with values.
///
/// # Errors
///
/// Fails if the template is invalid.
pub(super) fn render(template: &str, values: Value) -> Result<String> {
    let failed = |e: Error| error!("cannot-encode", format = "text", reason = format!("{e:#}"));
    Ok(environment().and_then(|environment| environment.render_str(template, values)).map_err(failed)?)
}

/// Syntax and filters of all templates.
pub(super) fn environment<'a>() -> std::result::Result<Environment<'a>, Error> {
    let mut environment = Environment::new();
    let mut syntax = SyntaxConfig::builder();
    let syntax = syntax.trim_blocks(true).lstrip_blocks(true).keep_trailing_newline(true).build();
    environment.set_syntax(syntax?);
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
    environment
        .add_filter("fixed", |value: f64, decimals: usize| check_width(decimals).map(|()| fixed(value, decimals)));
    environment.add_filter("radians", f64::to_radians);
    environment.add_filter("degrees", f64::to_degrees);
    environment.add_filter("numbers", |values: Vec<f64>, between: String| {
        values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(&between)
    });
    Ok(environment)
}

fn is_float(value: &Value) -> bool {
    value.is_number() && !value.is_integer()
}

/// String literal of Python: a JSON string in ASCII.
fn quoted(text: &str) -> String {
    let escaped = |c: char| if c.is_ascii() { c.to_string() } else { format!("\\U{:08x}", u32::from(c)) };
    serde_json::Value::from(text).to_string().chars().map(escaped).collect()
}

/// Shortest literal that reads back bit for bit; in parentheses if a sign could join an expression.
pub(super) fn literal(value: f64) -> String {
    if value.is_sign_negative() { format!("({value:?})") } else { format!("{value:?}") }
}

/// Converts a name to capitals, digits and underscores.
pub(super) fn identifier(name: &str) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    if name.is_empty() { "_".to_owned() } else { name.chars().map(safe).collect() }
}

/// Text that can neither end a comment, nor join lines, nor spell a trigraph. Signs of units are
/// written out, so that no number loses its unit.
pub(crate) fn comment(text: &str) -> String {
    let safe = |c: char| match c {
        _ if c.is_ascii_alphanumeric() || " .,-_:()=+".contains(c) => c.to_string(),
        'µ' | 'μ' => "u".to_owned(),
        '°' => "deg".to_owned(),
        '%' => "percent".to_owned(),
        '±' => "+-".to_owned(),
        '×' => "x".to_owned(),
        '·' => " ".to_owned(),
        '–' | '−' => "-".to_owned(),
        '\u{a0}' | '\u{202f}' => " ".to_owned(),
        ';' => ",".to_owned(),
        // marks of names
        '`' => String::new(),
        _ => "_".to_owned(),
    };
    text.replace("/(", " per (").chars().map(safe).collect()
}

/// Real literal of IEC 61131-3, with a point and digits on both sides of it.
pub(super) fn real_literal(value: f64) -> String {
    let text = format!("{value:?}");
    match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0E{exponent}"),
        Some((digits, exponent)) => format!("{digits}E{exponent}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comment_keeps_units_and_cannot_end() {
        assert_eq!(comment("noise 2.7 µm at k = 2; `pose` 1"), "noise 2.7 um at k = 2, pose 1");
        assert_eq!(comment("deg/(100 N·m)"), "deg per (100 N m)");
        assert_eq!(comment("45 % at 20 °C ± 2"), "45 percent at 20 degC +- 2");
        assert_eq!(comment("*/ //\\ *) ?? \n\"'"), "__ ___ _) __ ___");
    }
}
