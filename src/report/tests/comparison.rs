//! Comparison reports of all kinds: contents, languages, and unusual input.

use super::page::with_text;
use super::workbook::only_texts_and_numbers;
use super::{demo::Documents, demo_iso9283, demo_streams, report_texts};
use crate::*;
use etalon_compare::{Compared, compare};
use etalon_documents::{Iso9283StreamsDocument, Language};

fn compared(folder: &str, documents: Documents, streams: Iso9283StreamsDocument) -> Compared {
    Compared {
        folder: folder.to_owned(),
        campaign: documents.campaign,
        identified: Some((documents.parameters, documents.accuracy)),
        iso9283: Some(demo_iso9283::iso9283()),
        streams: Some(streams),
        inputs: [(format!("{folder}/parameters.json"), "0".repeat(64))].into(),
        readings: None,
    }
}

/// The demo twice, with a robot that changed by 0.1 of a parameter's unit.
fn demo() -> CompareDocument {
    let mut later = Documents::demo();
    later.parameters.parameters[0].value += 0.1;
    later.parameters.covariance.clear();
    let first = compared("spring", Documents::demo(), demo_streams::streams());
    compare(&[first, compared("autumn", later, demo_streams::streams())]).unwrap()
}

/// The demo with one text instead of every name.
fn named(text: &str) -> CompareDocument {
    let streams = |path: usize| {
        let mut streams = demo_streams::streams();
        streams.streams[0].name = text.to_owned();
        streams.streams[0].stream.path.as_mut().unwrap().passes = path;
        streams
    };
    let folders = [format!("{text}/1"), format!("{text}/2")];
    let all: Vec<Compared> =
        folders.iter().zip([10, 3]).map(|(folder, path)| compared(folder, with_text(text), streams(path))).collect();
    let mut document = compare(&all).unwrap();
    document.robot = Some(text.to_owned());
    document
}

fn drawn(kind: &str, document: &CompareDocument, presentation: &Presentation) -> Result<Vec<u8>> {
    Renderer::comparison(document, presentation.clone())?.file(kind)
}

fn html(document: &CompareDocument, presentation: &Presentation) -> Result<String> {
    Ok(String::from_utf8(drawn("html", document, presentation)?).unwrap())
}

fn in_language(language: Language) -> String {
    html(&demo(), &Presentation { language, ..Presentation::default() }).unwrap()
}

#[test]
fn it_speaks_one_language() {
    let english = in_language(Language::En);
    assert!(english.contains("Parameter beta") && english.contains("<html lang=\"en\">"));
    assert!(english.contains("AT, square") && english.contains("Path repeatability RT"));
    for (language, quantity) in [(Language::Fr, "Paramètre beta"), (Language::De, "Mittel x, Pose 1")] {
        let page = in_language(language);
        assert!(page.contains(quantity) && page.contains(&format!("<html lang=\"{}\">", language.code())));
        let own = |text: &String| text.len() > 5 && english.contains(&format!(">{text}<"));
        let differing = report_texts(language).filter(|(english, other)| english != other).map(|(english, _)| english);
        for text in differing.filter(own) {
            assert!(!page.contains(&format!(">{text}<")), "{language:?}: {text}");
        }
        for text in ["campaign 1", "significant change", "2 from 1", " of 2 poses", "Mean error", "the farthest"] {
            assert!(!page.contains(text), "{language:?}: {text}");
        }
    }
}

#[test]
fn what_else_differs_is_the_first_thing_it_says() {
    let mut document = demo();
    let first =
        |document: &CompareDocument| Renderer::comparison(document, Presentation::default()).unwrap().terminal();
    assert!(!first(&document).contains("Different"), "{}", first(&document));
    let later = &mut document.campaigns[1];
    (later.instrument, later.conditions.motion.load_kg) = (Some("FaroArm".to_owned()), Some(2.0));
    later.identified.pop();
    document.campaigns[0].conditions.motion.load_kg = Some(0.0);
    let (to, from, parameters, f, degrees_of_freedom, p) = (2, 1, 11, 99.0, Some(40.0), 0.0);
    document.together =
        vec![etalon_documents::CompareTogether { to, from, parameters, f, degrees_of_freedom, p, significant: true }];
    let shown = first(&document);
    let lines: Vec<&str> = shown.lines().skip(1).collect();
    assert!(lines[0].starts_with("Different instruments: Mitutoyo") && lines[0].contains("FaroArm, U = "), "{shown}");
    assert_eq!(lines[1], "Different set-ups: load: 0 kg; 2 kg.");
    assert!(lines[2].starts_with("Different models: "), "{shown}");
    assert!(shown.contains("degrees of freedom, p < 0.001)") && !shown.contains("p = 0)"), "{shown}");
}

#[test]
fn the_same_document_makes_the_same_bytes_of_every_kind() {
    let (document, presentation) = (demo(), Presentation { language: Language::De, ..Presentation::default() });
    for kind in kinds() {
        let bytes = drawn(kind, &document, &presentation).unwrap();
        assert!(bytes == drawn(kind, &document, &presentation).unwrap(), "{kind}");
    }
}

#[test]
fn hostile_names_do_no_harm_in_any_kind() {
    let long = "n".repeat(200);
    let texts = [
        "</td></script><script>alert(1)</script>&\"'{{ 7*7 }}",
        "=HYPERLINK(\"http://192.0.2.1\")",
        "#import \"x\" $a$ #panic() *b* _c_",
        "\u{202e}\u{5e8}\u{5d5}\u{5d1}\u{1b}[2J",
        "\u{4e2d}\u{1f600}\0",
        &long,
        " ",
    ];
    let presentation = Presentation::default();
    let tags = html(&named("plain"), &presentation).unwrap().matches('<').count();
    for text in texts {
        let document = named(text);
        let page = html(&document, &presentation).unwrap();
        assert_eq!(page.matches('<').count(), tags, "{text}");
        assert!(page.matches("<script").count() == 1 && !page.contains('\u{1b}'), "{text}");
        for kind in kinds() {
            let bytes = drawn(kind, &document, &presentation).unwrap();
            if kind == "xlsx" {
                only_texts_and_numbers(bytes);
            }
        }
    }
}

#[test]
fn many_campaigns_and_numbers_that_are_none_are_written() {
    let mut document = demo();
    let campaign = document.campaigns[0].clone();
    document.campaigns.extend((0..12).map(|_| campaign.clone()));
    for (i, t) in document.trends.iter_mut().enumerate() {
        let value = [f64::NAN, f64::INFINITY, 1e300, 0.0, -1e-300][i % 5];
        t.values.resize(14, etalon_documents::CompareValue { value: Some(value), ..Default::default() });
        t.changes[0].change = value;
        t.changes[0].low = Some(value);
    }
    document.together.iter_mut().for_each(|t| t.f = f64::NAN);
    for kind in kinds() {
        let bytes = drawn(kind, &document, &Presentation::default()).unwrap();
        assert!(kind != "html" || !String::from_utf8(bytes).unwrap().contains("NaN"));
    }
}
