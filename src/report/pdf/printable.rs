//! Text that the embedded fonts can show, as PDF/A requires.

use super::super::model::is_checksum;
use super::world::fonts;
use serde_json::Value;

/// Minimum length (characters) of a word that may be broken anywhere.
const LONG: usize = 28;

/// Characters that reach the typesetter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Letters {
    /// All characters of the fonts.
    Known,
    /// Characters that are set individually. Fonts join characters of other scripts, and not every
    /// ligature has the text that PDF/A requires.
    Single,
}

/// Replaces characters that cannot be shown in all texts of a JSON value, except keys.
pub(super) fn printable(value: &mut Value, letters: Letters) {
    match value {
        Value::String(text) => {
            if let Some(shown) = printable_text(text, letters) {
                *text = shown;
            }
            if text.len() > LONG {
                *text = breakable(text);
            }
        }
        Value::Array(values) => values.iter_mut().for_each(|value| printable(value, letters)),
        Value::Object(values) => values.iter_mut().for_each(|(key, value)| match (key.as_str(), value) {
            ("svg", Value::String(svg)) => {
                let drawn = without_tooltips(svg);
                *svg = styled(&printable_text(&drawn, letters).unwrap_or(drawn));
            }
            (_, value) => printable(value, letters),
        }),
        _ => {}
    }
}

/// Bytes of an SVG figure, with characters replaced that cannot be shown.
pub(super) fn printable_picture(svg: Vec<u8>, letters: Letters) -> Vec<u8> {
    let replaced = std::str::from_utf8(&svg).ok().and_then(|text| printable_text(text, letters));
    replaced.map_or(svg, String::into_bytes)
}

/// A figure without the texts that appear under a pointer: half of it, and nothing on paper.
fn without_tooltips(svg: &str) -> String {
    let mut parts = svg.split("<title>");
    let first = parts.next().into_iter();
    first.chain(parts.map(|part| part.split_once("</title>").map_or(part, |(_, rest)| rest))).collect()
}

/// An inline figure as a separate file, with the style of the page.
fn styled(svg: &str) -> String {
    const STYLE: &str = concat!(
        "<style>text { font-family: 'Libertinus Serif'; font-size: 12px }\n",
        include_str!("../html/picture.css"),
        "</style>"
    );
    match svg.split_once('>') {
        Some((open, rest)) => format!("{open} xmlns=\"http://www.w3.org/2000/svg\">{STYLE}{rest}"),
        None => String::new(),
    }
}

/// Break opportunity that the template replaces, so that the text of the PDF does not contain it.
const BREAK: char = '\u{e000}';
/// Break opportunity that the text of the PDF contains.
const ZERO_WIDTH_SPACE: char = '\u{200b}';
/// Maximum number of [`BREAK`] in a text. The typesetter refuses a paragraph with more than 500.
const MOST_BREAKS: usize = 50;

/// Adds break opportunities to long words, except for checksums, which are copied.
fn breakable(text: &str) -> String {
    let broken = |word: &str| if is_checksum(word) { word.to_owned() } else { broken(word, &SEPARATORS) };
    let text = text.split(' ').map(broken).collect::<Vec<_>>().join(" ");
    match text.matches(BREAK).count() > MOST_BREAKS {
        true => text.replace(BREAK, &ZERO_WIDTH_SPACE.to_string()),
        false => text,
    }
}

/// Characters behind which a long word may be broken, the best first.
const SEPARATORS: [&[char]; 2] = [&['/', '\\'], &['_', '-', '.', ',', ':']];

/// Adds break opportunities behind separators. Parts that fit a line stay as they are, so that a
/// reader finds a name of a file in the text of the PDF; only longer ones break anywhere.
fn broken(word: &str, separators: &[&[char]]) -> String {
    if word.chars().count() <= LONG {
        return word.to_owned();
    }
    match separators {
        [first, others @ ..] => {
            let parts = word.split_inclusive(*first).map(|part| broken(part, others));
            parts.collect::<Vec<_>>().join(&BREAK.to_string())
        }
        [] => word.chars().flat_map(|c| [c, ZERO_WIDTH_SPACE]).collect(),
    }
}

/// Replaces characters that cannot be shown; `None` if nothing changes. Marks of writing direction
/// are removed, so that a name cannot affect its surroundings.
fn printable_text(text: &str, letters: Letters) -> Option<String> {
    let fine = |c: char| c == '\n' || ('\u{20}'..'\u{7f}').contains(&c);
    if text.chars().all(fine) {
        return None;
    }
    let shown = |c: char| match c {
        c if fine(c) => Some(c),
        '\t' => Some(' '),
        // without text in PDF/A
        '\u{feff}' => None,
        '\u{200e}' | '\u{200f}' | '\u{061c}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => None,
        c if c.is_control() || is_private(c) || !has_glyph(c) => Some('\u{fffd}'),
        c if letters == Letters::Single && !is_single(c) => Some('\u{fffd}'),
        c => Some(c),
    };
    Some(text.chars().filter_map(shown).collect())
}

fn is_private(c: char) -> bool {
    matches!(c, '\u{e000}'..='\u{f8ff}' | '\u{f0000}'..)
}

/// `true` for Latin, Greek and Cyrillic letters, punctuation and mathematical signs.
fn is_single(c: char) -> bool {
    matches!(c, '\u{a0}'..='\u{2af}' | '\u{370}'..='\u{482}' | '\u{48a}'..='\u{52f}' | '\u{1e00}'..='\u{1fff}'
        | '\u{2010}'..='\u{2027}' | '\u{202f}'..='\u{205f}' | '\u{2070}'..='\u{20cf}' | '\u{2100}'..='\u{25ff}')
}

fn has_glyph(c: char) -> bool {
    fonts().0.iter().any(|font| font.info().coverage.contains(c.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_words_may_break_and_checksums_not() {
        let (long, checksum) = ("n".repeat(29), "0".repeat(64));
        let svg = format!("<svg><text>{long}</text>");
        let mut value = serde_json::json!([format!("a {long} b"), checksum, "n".repeat(28), { "svg": svg }]);
        printable(&mut value, Letters::Known);
        assert_eq!(value[0], format!("a {} b", "n\u{200b}".repeat(29)));
        // a reader finds the name of a file
        let name = "measurements_of_a_robot.csv";
        assert_eq!(breakable(&format!("exports/2026/{name}")), format!("exports/\u{e000}2026/\u{e000}{name}"));
        let folders = "a/".repeat(60);
        assert_eq!(breakable(&folders), "a/\u{200b}".repeat(60).trim_end_matches('\u{200b}'));
        assert_eq!((value[1].as_str(), value[2].as_str()), (Some(&*checksum), Some(&*"n".repeat(28))));
        assert!(value[3]["svg"].as_str().unwrap().ends_with(&format!("</style><text>{long}</text>")));
    }

    #[test]
    fn paper_has_no_tooltips() {
        let svg =
            "<svg><circle r=\"1\"><title>pose 1: 2 µm</title></circle>\n<path d=\"M0 0\"><title></title></path></svg>";
        assert_eq!(without_tooltips(svg), "<svg><circle r=\"1\"></circle>\n<path d=\"M0 0\"></path></svg>");
        assert_eq!(without_tooltips("<svg></svg>"), "<svg></svg>");
    }

    #[test]
    fn what_no_font_has_is_replaced_and_nothing_turns_the_direction() {
        let cases = [
            ("plain", None),
            ("µm θ ±", Some("µm θ ±")),
            ("\u{202e}\u{5e8}\u{5d5}", Some("\u{5e8}\u{5d5}")),
            ("\u{feff}x", Some("x")),
            ("\u{4e2d}\u{1f600}\u{e000}\0", Some("\u{fffd}\u{fffd}\u{fffd}\u{fffd}")),
        ];
        for (text, expected) in cases {
            assert_eq!(printable_text(text, Letters::Known).as_deref(), expected, "{text}");
        }
        assert_eq!(
            printable_text("µ Σ ≤ 5\u{302} \u{627}", Letters::Single).as_deref(),
            Some("µ Σ ≤ 5\u{fffd} \u{fffd}")
        );
        assert!(has_glyph('\u{fffd}'));
    }
}
