//! Texts in cells of tables that spreadsheets open.

/// `true` if a spreadsheet takes a text for a formula (OWASP, CSV injection).
pub fn is_formula(text: &str) -> bool {
    text.starts_with(['=', '+', '-', '@', '\t', '\r'])
}

/// A text as a spreadsheet shows it: a formula behind an apostrophe.
pub fn without_formula(text: &str) -> String {
    if is_formula(text) { format!("'{text}") } else { text.to_owned() }
}

/// The text of a cell: a formula behind an apostrophe, a number as it is.
pub fn cell(text: &str) -> String {
    if text.parse::<f64>().is_ok() { text.to_owned() } else { without_formula(text) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_no_formula() {
        for (text, written) in
            [("-1.5", "-1.5"), ("+2", "+2"), ("-", "'-"), ("-1+2", "'-1+2"), ("@a", "'@a"), ("a=b", "a=b")]
        {
            assert_eq!(cell(text), written);
        }
    }
}
