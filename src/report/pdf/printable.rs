//! Text as the embedded fonts can show it: PDF/A forbids what they cannot.

use super::world::fonts;
use serde_json::Value;

/// Every text of a JSON value, keys left alone.
pub(super) fn printable(value: &mut Value) {
    match value {
        Value::String(text) => {
            if let Some(shown) = shown(text) {
                *text = shown;
            }
        }
        Value::Array(values) => values.iter_mut().for_each(printable),
        Value::Object(values) => values.values_mut().for_each(printable),
        _ => {}
    }
}

/// The text with what cannot be shown replaced, where there is any. Marks that turn the direction of what follows are
/// dropped: a name must not change how its surroundings read.
fn shown(text: &str) -> Option<String> {
    let fine = |c: char| c == '\n' || ('\u{20}'..'\u{7f}').contains(&c);
    if text.chars().all(fine) {
        return None;
    }
    let shown = |c: char| match c {
        c if fine(c) => Some(c),
        '\t' => Some(' '),
        '\u{200e}' | '\u{200f}' | '\u{061c}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => None,
        c if c.is_control() || is_private(c) || !has_glyph(c) => Some('\u{fffd}'),
        c => Some(c),
    };
    Some(text.chars().filter_map(shown).collect())
}

fn is_private(c: char) -> bool {
    matches!(c, '\u{e000}'..='\u{f8ff}' | '\u{f0000}'..)
}

fn has_glyph(c: char) -> bool {
    fonts().0.iter().any(|font| font.info().coverage.contains(c.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_font_has_is_replaced_and_nothing_turns_the_direction() {
        let cases = [
            ("plain", None),
            ("µm θ ±", Some("µm θ ±")),
            ("\u{202e}\u{5e8}\u{5d5}", Some("\u{5e8}\u{5d5}")),
            ("\u{4e2d}\u{1f600}\u{e000}\0", Some("\u{fffd}\u{fffd}\u{fffd}\u{fffd}")),
        ];
        for (text, expected) in cases {
            assert_eq!(shown(text).as_deref(), expected, "{text}");
        }
        assert!(has_glyph('\u{fffd}'));
    }
}
