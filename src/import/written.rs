//! Lines of delimited text as import reads them.

use crate::base::message::Message;
use crate::import::format::Decimal;
use crate::import::format::Delimiter;

/// One line; where it would read as a comment its first field is quoted.
pub(crate) fn line(fields: &[String], delimiter: Delimiter, comment: Option<&str>) -> Result<String, Message> {
    let joined = |quote_first: bool| {
        let field = |(i, field): (usize, &String)| match delimiter.byte() {
            Some(byte) => separated(field, char::from(byte), quote_first && i == 0),
            None => blank(field, quote_first && i == 0),
        };
        let separator = delimiter.byte().map_or(' ', char::from).to_string();
        fields.iter().enumerate().map(field).collect::<Vec<_>>().join(&separator) + "\n"
    };
    let is_comment = |text: &str| comment.is_some_and(|c| text.trim_start().starts_with(c));
    let text = joined(false);
    if !is_comment(&text) {
        return Ok(text);
    }
    let quoted = joined(true);
    if is_comment(&quoted) {
        let what = format!("a row would read as a comment: `{}`", text.trim_end());
        return Err(Message::error(what).hint("choose another `comment`"));
    }
    Ok(quoted)
}

/// A field between separators.
fn separated(field: &str, separator: char, quote: bool) -> String {
    if quote || field.contains([separator, '"', '\n', '\r']) || field.trim() != field {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

/// A field between blanks.
pub(crate) fn blank(field: &str, quote: bool) -> String {
    if quote || field.is_empty() || field.contains(char::is_whitespace) {
        format!("\"{field}\"")
    } else {
        field.to_owned()
    }
}

/// A number with the stated decimal mark.
pub(crate) fn number(value: f64, digits: usize, decimal: Decimal) -> String {
    let text = format!("{value:.digits$}");
    if decimal == Decimal::Comma { text.replace('.', ",") } else { text }
}
