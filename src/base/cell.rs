//! Texts in cells of tables that spreadsheets open.

/// `true` if a spreadsheet would treat a text as a formula (OWASP, CSV injection).
pub fn is_formula(text: &str) -> bool {
    text.starts_with(['=', '+', '-', '@', '\t', '\r'])
}

/// Escapes a formula by a leading apostrophe.
pub fn without_formula(text: &str) -> String {
    if is_formula(text) { format!("'{text}") } else { text.to_owned() }
}

/// Text of a cell: formulas are escaped by a leading apostrophe, numbers are unchanged.
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
