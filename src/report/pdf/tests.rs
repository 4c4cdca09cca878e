//! Input of the typesetter, and unusual input that it must handle.

use super::*;
use crate::campaign::{attachments, contents};
use crate::tests::demo::{Documents, point};
use crate::tests::page::with_text;

fn typeset_report(documents: &Documents) -> Vec<u8> {
    let (words, results) = (Words::default(), documents.results());
    pdf(&contents(&results, &words), &attachments(&results, &words).unwrap(), &documents.campaign.report, &words)
        .unwrap()
}

/// Text that `pdftotext` reads; `None` if it is not installed.
fn extract_text(pdf: &[u8]) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("report.pdf");
    std::fs::write(&file, pdf).unwrap();
    let output = std::process::Command::new("pdftotext").args(["-layout", "-q"]).arg(&file).arg("-").output().ok()?;
    assert!(output.status.success());
    Some(String::from_utf8(output.stdout).unwrap())
}

/// Writes the demo and its source to the folder named by `ETALON_REPORT_DEMO`.
#[test]
fn the_demo_is_typeset_and_its_bytes_are_the_same_twice() {
    let documents = Documents::demo();
    let pdf = typeset_report(&documents);
    assert!(pdf.starts_with(b"%PDF-1.7") && pdf == typeset_report(&documents));
    if let Some(folder) = std::env::var_os("ETALON_REPORT_DEMO") {
        let folder = std::path::PathBuf::from(folder);
        let paper =
            paper(&contents(&documents.results(), &Words::default()), &documents.campaign.report, &Words::default())
                .unwrap();
        std::fs::write(folder.join("report.pdf"), pdf).unwrap();
        std::fs::write(folder.join("report.json"), serde_json::to_vec(&paper).unwrap()).unwrap();
    }
}

/// A word may break, and its text has no mark of it: a reader finds the name of a file.
#[test]
fn long_words_are_found_in_the_text() {
    let name = "measurements_of_a_robot/in_a_long_folder_of_files.csv";
    let Some(read) = extract_text(&typeset_report(&with_text(name))) else { return };
    assert!(read.contains("measurements_of_a_robot") && !read.contains('\u{200b}'), "{read}");
}

/// A figure moves as a whole: sections of figures follow the sections of text, and annexes the
/// signatures.
#[test]
fn pages_before_figures_are_filled() {
    let documents = Documents::demo();
    let Some(text) = extract_text(&typeset_report(&documents)) else { return };
    let words = Words::default();
    let pages: Vec<&str> = text.split('\u{c}').collect();
    let page = |title: &str| {
        let is_heading = |line: &str| line.trim_start_matches(|c: char| c.is_ascii_digit() || c == ' ') == title;
        pages.iter().position(|page| page.lines().any(is_heading)).unwrap_or_else(|| panic!("{title}: {text}"))
    };
    let [budget, figures] = [tr!(words, "uncertainty-budget"), tr!(words, "pictures")].map(|title| page(&title));
    assert!(budget <= figures, "{budget} {figures}");
    let signed = page(&tr!(words, "signatures"));
    let annex = pages.iter().position(|page| page.lines().any(|line| line.trim_start().starts_with("A ")));
    assert_eq!(annex, Some(signed), "{text}");
}

#[test]
fn hostile_names_are_printed_as_they_are() {
    let hostile =
        ["<script>alert(1)</script>", "=HYPERLINK(\"x\")", "#import \"x\"", "$a$ #panic() *b* _c_ @d <e> `f` \\u{0}"];
    for text in hostile {
        let Some(read) = extract_text(&typeset_report(&with_text(text))) else { return };
        let found = read.matches(text.split(' ').next().unwrap()).count();
        assert!(found > 20, "{text}: {found} times in {read}");
    }
}

#[test]
fn long_right_to_left_and_unknown_letters_do_no_harm() {
    let texts = [
        "n".repeat(200),
        "\u{202e}\u{5e8}\u{5d5}\u{5d1}".into(),
        "\u{4e2d}\u{1f600}\u{e000}\0\u{fffe}".into(),
        " ".into(),
        String::new(),
        "\u{feff}x".into(),
        "\u{2764}\u{fe0f} \u{1f468}\u{200d}\u{1f469} 1\u{fe0f}\u{20e3} \u{1f1e9}\u{1f1ea}".into(),
        "\u{627}\u{644}\u{64b} a\u{64b} \u{eb3} \u{fffd}\u{5b0}".into(),
    ];
    for text in texts {
        typeset_report(&with_text(&text));
    }
}

#[test]
fn a_logo_with_letters_that_no_font_has_does_no_harm() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("logo.svg");
    for text in ["\u{feff}x", "\u{1f600}", "\u{e000}", "\u{627}\u{644}\u{64b} a\u{64b} \u{eb3}"] {
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 20'><text y='15' font-size='12'>{text}</text></svg>"
        );
        std::fs::write(&file, svg).unwrap();
        let mut documents = Documents::demo();
        documents.campaign.report.logo = Some(crate::branding::logo(&file).unwrap());
        typeset_report(&documents);
    }
}

#[test]
fn nothing_and_numbers_that_are_none_are_typeset() {
    let mut documents = Documents::demo();
    documents.errors.clear();
    documents.accuracy.sets.clear();
    documents.accuracy.limits.clear();
    documents.import.sources.clear();
    documents.parameters.messages.clear();
    documents.parameters.parameters.clear();
    documents.features.features.clear();
    documents.frames.world.poses.clear();
    typeset_report(&documents);
    for size in [0.0, 1e-12, 1e300, f64::NAN, f64::INFINITY] {
        let mut documents = Documents::demo();
        documents.errors = vec![point(1, [size; 3], [size; 3], [size; 3]); 3];
        documents.parameters.residuals.rms = size;
        documents.parameters.parameters[0].value = size;
        documents.campaign.instrument.expanded_uncertainty_um = Some(size);
        if let Some(read) = extract_text(&typeset_report(&documents)) {
            assert!(!read.contains("NaN") && !read.contains(" inf"), "{size}: {read}");
        }
    }
}

#[test]
fn a_date_is_read_where_there_is_one() {
    let cases = [
        ("2011-05-12", Some(Date::new(2011, 5, 12))),
        ("2011-05-12T10:00:00", Some(Date::new(2011, 5, 12))),
        ("2011-02-30", None),
        ("May 2011", None),
        ("0000-01-01", None),
        ("日本語日本語", None),
    ];
    for (text, date) in cases {
        assert_eq!(day(text), date, "{text}");
    }
}
