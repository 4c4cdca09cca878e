//! The report as PDF and as workbook: what other programs find in them.

use super::{etalon, text_of};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use calamine::{Data, Reader, Xlsx};
use serde_json::Value;
use std::io::Cursor;
use std::path::Path;
use std::process::Command;

fn ran(sample: &str) -> Scratch {
    let scratch = copy_sample(sample);
    let output = etalon(scratch.root(), &["run", "campaign"]);
    assert!(output.status.success(), "{}", text_of(&output));
    scratch
}

/// What a program of the machine prints when asked about `{}`, a file, or `None` after saying that it is not there.
pub(super) fn tool(program: &str, arguments: &[&str], file: &Path) -> Option<String> {
    let file = file.to_str().unwrap();
    let arguments: Vec<&str> = arguments.iter().map(|a| if *a == "{}" { file } else { a }).collect();
    match Command::new(program).args(&arguments).output() {
        Ok(output) => {
            assert!(output.status.success(), "{program} {arguments:?}: {}", text_of(&output));
            Some(String::from_utf8_lossy(&output.stdout).into_owned())
        }
        Err(_) => {
            crate::support::skipped(program);
            None
        }
    }
}

/// Texts of a page between its tags, and those marked as English, without the explanations of messages.
fn texts(page: &str) -> (Vec<String>, Vec<String>) {
    let body = page.split_once("<body").unwrap().1.split_once("<script>").unwrap().0;
    let (mut own, mut english) = (Vec::new(), Vec::new());
    let worded: Vec<&str> = body.lines().filter(|line| !line.contains("<code id=\"message-")).collect();
    for piece in worded.join("\n").split('<').filter_map(|piece| piece.split_once('>')) {
        match piece.0 {
            "bdi lang=\"en\"" => english.push(piece.1.to_owned()),
            tag if tag == "code" || tag.starts_with("code ") || tag.starts_with("style") => {}
            _ => own.extend(piece.1.lines().map(str::to_owned)),
        }
    }
    (own, english)
}

/// Whether a text has a number with a decimal point: neither a clause nor a name nor a version.
fn has_point(text: &str) -> bool {
    let cited = ["ISO", "JCGM", "etalon", ".csv", ".txt", ".toml", "7.4, 7.5"].iter().any(|part| text.contains(part));
    let words = || text.split(|c: char| c.is_whitespace() || matches!(c, '(' | ')' | ';' | ':' | ','));
    let decimal = |word: &str| {
        let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
        word.trim_start_matches(['-', '+']).split_once('.').is_some_and(|(a, b)| digits(a) && digits(b))
    };
    // a cell of the table of clauses
    let is_clause = text.split_once('.').is_some_and(|(a, b)| ["7", "8", "9", "10"].contains(&a) && b.len() == 1);
    !cited && !is_clause && words().any(decimal)
}

/// Every sample whose data are here.
fn samples() -> Vec<&'static str> {
    let outside = crate::reference_data("robots/irb120_faro_ets").map(|_| "abb-irb120");
    let within = [
        "column-arm",
        "contacts",
        "delta",
        "dextar",
        "draw-wire",
        "hexapod",
        "linear-delta",
        "pose-test",
        "probe-poses",
        "prexyt-cmm",
        "prexyt-faroarm",
        "prexyt-geometric",
        "prexyt-repeatability",
        "rail-arm",
        "second-encoders",
        "surfaces",
        "turntable",
        "two-arms",
        "two-hands",
    ];
    within.into_iter().chain(outside).collect()
}

/// The page of a sample in a language.
fn page_of(scratch: &Scratch, language: &str) -> String {
    let output = etalon(scratch.root(), &["report", "campaign/out", "--language", language]);
    assert!(output.status.success(), "{}", text_of(&output));
    std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap()
}

#[test]
fn every_report_speaks_one_language_and_has_no_number_that_means_nothing() {
    for sample in samples() {
        let scratch = copy_sample(sample);
        let output = etalon(scratch.root(), &["run", "campaign"]);
        assert!(output.status.code() < Some(2), "{sample}: {}", text_of(&output));
        let page = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
        for language in ["de", "fr"] {
            let (own, english) = texts(&page_of(&scratch, language));
            // how a file is read is stated in the words of campaign.toml
            let sentences: Vec<_> = english.iter().filter(|t| *t != "TOML" && !t.starts_with("{ ")).collect();
            assert!(sentences.is_empty(), "{sample}, {language}: not translated: {sentences:#?}");
            // what the campaign itself names
            let named =
                |text: &&String| !["(table 2.", "thesis table", "thesis, ETS"].iter().any(|part| text.contains(part));
            let points: Vec<_> = own.iter().filter(|t| has_point(t)).filter(named).collect();
            assert!(points.is_empty(), "{sample}, {language}: {points:#?}");
            assert!(own.iter().any(|t| t.contains("0,")));
        }
        let doubtful: Vec<_> = texts(&page).0.into_iter().filter(|t| is_doubtful(t)).collect();
        assert!(doubtful.is_empty(), "{sample}: {doubtful:#?}");
        for column in columns(&page) {
            let numbers: Vec<&String> = column.iter().filter(|c| c.parse().is_ok_and(|v: f64| v != 0.0)).collect();
            let powers = numbers.iter().filter(|c| c.contains('e')).count();
            assert!(powers == 0 || powers == numbers.len(), "{sample}: {column:?}");
        }
        let bytes = std::fs::read(scratch.path().join("out/report.xlsx")).unwrap();
        assert!(text_in(&bytes, "<c:chart>"), "{sample}: no chart");
        let colours = ["C6EFCE", "FFC7CE", "FFEB9C"].map(|colour| text_in(&bytes, colour));
        let limits = workbook(&scratch).sheet_names().iter().any(|name| name == "Limites");
        assert_eq!(colours.contains(&true), limits, "{sample}: verdicts and their colours");
    }
}

/// Whether a text has a number that means nothing: a probability of zero, zero with a sign, a value that rounds to its limit, or, in
/// a sentence, a rounding error of the computation.
fn is_doubtful(text: &str) -> bool {
    let words: Vec<&str> = text.split_whitespace().map(|w| w.trim_end_matches(['.', ',', ';', ':', ')'])).collect();
    let is = |word: &&str, wanted: fn(f64) -> bool| word.parse().is_ok_and(wanted);
    // the texts of the marks of singular values begin with their number
    let of_mark = words.first().is_some_and(|w| w.parse::<u32>().is_ok()) && text.contains(": ");
    words.windows(3).any(|w| {
        (w[0] == "p" && w[1] == "=" && is(&w[2], |v| v == 0.0)) || (w[1] == "of" && w[0] == w[2] && w[0].contains('.'))
    }) || words.iter().any(|w| w.starts_with('-') && is(w, |v| v == 0.0))
        || !of_mark && words.len() > 2 && words.iter().any(|w| is(w, |v| v != 0.0 && v.abs() < 1e-9))
}

/// The columns of the tables of a page.
fn columns(page: &str) -> Vec<Vec<String>> {
    let mut all = Vec::new();
    for table in page.split("<table").skip(1).filter_map(|rest| rest.split("</table>").next()) {
        let mut columns: Vec<Vec<String>> = Vec::new();
        for row in table.split("<tr").skip(1) {
            let cells = row.replace("<th", "<td");
            for (i, cell) in cells.split("<td").skip(1).enumerate() {
                if columns.len() <= i {
                    columns.push(Vec::new());
                }
                // the text without its tags
                let text: String = cell.split('>').skip(1).filter_map(|piece| piece.split('<').next()).collect();
                columns[i].push(text.trim().to_owned());
            }
        }
        all.extend(columns);
    }
    all
}

#[test]
fn doubtful_numbers_are_found() {
    for text in ["p = 0.", "0.0054 of 0.0054: NOT MET", "mean -6.6e-12 µm, standard deviation", "x -0.0 mm"] {
        assert!(is_doubtful(text), "{text}");
    }
    for text in ["p < 0.001", "0.0054 of 0.0055", "8: 4.3e-16 x_c, y_c", "1e-12", "rank cut of 1.0e-9"] {
        assert!(!is_doubtful(text), "{text}");
    }
}

/// In every face "before" is the same: nominal parameters with only base and targets fitted. What is predicted at the tool point without
/// them has another name.
#[test]
fn before_has_one_meaning_in_a_report() {
    let scratch = ran("prexyt-cmm");
    let accuracy = scratch.json("accuracy.json");
    let set = &accuracy["sets"][1];
    let before_mm = set["errors"][0]["before"]["max"].as_f64().unwrap();
    let mut book = workbook(&scratch);
    let mut numbers = |sheet: &str, title: &str| -> Vec<f64> {
        column(&mut book, sheet, title).iter().map(|c| if let Data::Float(v) = c { *v } else { f64::NAN }).collect()
    };
    // the set that decides is first
    assert_eq!(numbers("Errors", "before, max")[0], before_mm);
    let [x, y] = ["before, x [mm]", "before, y [mm]"].map(|title| numbers("Residuals", title));
    let (by_pose, poses) = (numbers("Errors by pose", "position before, max [mm]"), numbers("Errors by pose", "pose"));
    let (of_row, validation) = (numbers("Residuals", "pose"), |pose: f64| pose > 8.0);
    let sizes = (0..x.len()).filter(|i| validation(of_row[*i])).map(|i| x[i].hypot(y[i]));
    let in_poses = (0..poses.len()).filter(|i| validation(poses[*i])).map(|i| by_pose[i]);
    for largest in [sizes.fold(0.0, f64::max), in_poses.fold(0.0, f64::max)] {
        assert!((largest - before_mm).abs() < 1e-12, "{largest} {before_mm}");
    }
    let page = page_of(&scratch, "en");
    // in the figure of errors before and after
    assert!(page.contains(&format!(">{:.1} → ", 1e3 * before_mm)), "{before_mm}");
    let terminal = text_of(&etalon(scratch.root(), &["report", "campaign/out"]));
    let pdf = text_of_pdf(&scratch.path().join("out/report.pdf")).unwrap_or_default();
    for face in [&page, &terminal, &pdf] {
        let definitions = face.matches("before: nominal").count();
        assert!(definitions == 1 || !std::ptr::eq(face, &page) && definitions == 0, "{definitions}: {face}");
    }
    // the tool point: the place of the base plays no part in it
    let tool_mm = accuracy["tool"]["before"]["max"].as_f64().unwrap();
    assert!((tool_mm - before_mm).abs() > 1e-3, "another quantity");
    assert_eq!(numbers("Tool point", "nominal minus identified, max"), [tool_mm]);
    let tool = page.split_once("At the tool point").unwrap().1.split_once("</table>").unwrap().0;
    assert!(tool.has_phrase("nominal-minus-identified") && tool.contains("expected") && !tool.contains(">before<"));
    assert!(page.has_phrase("prediction-difference-title plane=xy"));
    assert!(!page.contains("Tool point: error before"));
}

#[cfg(feature = "pdf")]
mod pdf {
    use super::*;

    #[test]
    fn its_text_is_what_the_documents_say_and_its_pages_are_counted() {
        let scratch = ran("prexyt-cmm");
        let file = scratch.path().join("out/report.pdf");
        let Some(information) = tool("pdfinfo", &["{}"], &file) else { return };
        let pages = information.lines().find_map(|l| l.strip_prefix("Pages:")).unwrap().trim().to_owned();
        let words = tool("pdftotext", &["-layout", "{}", "-"], &file).unwrap();
        for page in 1..=pages.parse::<usize>().unwrap() {
            assert!(words.contains(&format!("page {page} of {pages}")), "{page} of {pages}");
        }
        let inputs = scratch.json("parameters.json");
        let checksum = inputs["provenance"]["inputs"]["encoders.csv"].as_str().unwrap();
        for part in [
            "PreXYT, CMM (synthetic)",
            "Both limits of the campaign are met.",
            "Synthetic data:",
            checksum,
            "epsilon_theta",
            "Signatures",
        ] {
            assert!(words.contains(part), "{part}: {words}");
        }
        // every parameter with its uncertainty stands in a row of its own
        for p in inputs["parameters"].as_array().unwrap() {
            let name = p["name"].as_str().unwrap();
            assert!(words.lines().any(|l| l.trim_start().starts_with(&format!("{name} "))), "{name}");
        }
    }

    #[test]
    fn a_laboratory_lays_it_out_in_its_own_way_and_language() {
        let scratch = copy_sample("prexyt-repeatability");
        let own = "#set page(footer: [sheet #context counter(page).display()])\n#let r = json(\"report.json\")\n\
                   = #r.title\n#r.labels.signatures: #r.sections.len()";
        std::fs::create_dir(scratch.path().join("own")).unwrap();
        std::fs::write(scratch.path().join("own/report.typ"), own).unwrap();
        std::fs::write(scratch.path().join("logo.png"), PNG).unwrap();
        let dress = "[report]\nlanguage = \"de\"\nlogo = \"logo.png\"\ntemplates = \"own\"\n\n[instrument]";
        scratch.replace("campaign.toml", "[instrument]", dress);
        let run = || etalon(scratch.root(), &["run", "campaign"]);
        assert!(run().status.success());
        let file = scratch.path().join("out/report.pdf");
        if let Some(words) = tool("pdftotext", &["{}", "-"], &file) {
            assert!(words.contains("Unterschriften: ") && words.contains("sheet 1"), "{words}");
        }
        // the documents go along with any layout
        if let Some(attached) = tool("qpdf", &["--list-attachments", "{}"], &file) {
            assert!(attached.contains("iso9283-streams.json") && attached.contains("campaign.json"), "{attached}");
        }
        // the built-in layout in German, with the logo
        std::fs::remove_file(scratch.path().join("own/report.typ")).unwrap();
        std::fs::write(scratch.path().join("own/signatures.html"), "").unwrap();
        assert!(run().status.success());
        if let Some(words) = tool("pdftotext", &["{}", "-"], &file) {
            assert!(words.contains("Seite 1 von") && words.contains("Grenzwert"), "{words}");
        }
        if let Some(images) = tool("pdfimages", &["-list", "{}"], &file) {
            assert_eq!(images.lines().count(), 3, "{images}");
        }
        // what is wrong with a layout is told with its line
        for (text, said) in [("ok\n#let x = (1", "unclosed"), ("ok\n#panic(\"no\")", "panicked")] {
            std::fs::write(scratch.path().join("own/report.typ"), text).unwrap();
            let refused = run();
            let told = text_of(&refused);
            assert_eq!(refused.status.code(), Some(2), "{told}");
            assert!(told.contains(said) && told.contains("report.typ:2:"), "{told}");
        }
    }

    /// One grey point.
    const PNG: &[u8] = b"\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00\x01\x00\x00\x00\x01\x08\x00\x00\x00\x00:~\x9bU\x00\x00\x00\x0aIDATx\x9cch\x00\x00\x00\x82\x00\x81w\xcdr\xb6\x00\x00\x00\x00IEND\xaeB`\x82";

    #[test]
    fn fonts_are_embedded_and_the_file_is_sound() {
        let scratch = ran("prexyt-repeatability");
        let file = scratch.path().join("out/report.pdf");
        if let Some(fonts) = tool("pdffonts", &["{}"], &file) {
            let rows: Vec<&str> = fonts.lines().skip(2).collect();
            assert!(!rows.is_empty() && rows.iter().all(|r| r.contains(" yes yes yes ")), "{fonts}");
        }
        if let Some(checked) = tool("qpdf", &["--check", "{}"], &file) {
            assert!(checked.contains("No syntax or stream encoding errors found"), "{checked}");
        }
    }

    #[test]
    fn it_says_that_it_is_pdf_a_3_and_carries_its_documents() {
        let scratch = ran("prexyt-cmm");
        let file = scratch.path().join("out/report.pdf");
        let Some(plain) = tool("qpdf", &["--qdf", "--object-streams=disable", "{}", "-"], &file) else {
            return;
        };
        for part in [
            "<pdfaid:part>3</pdfaid:part>",
            "<pdfaid:conformance>A</pdfaid:conformance>",
            "/OutputIntents",
            "/S /GTS_PDFA1",
            "/AFRelationship /Data",
            "/AFRelationship /Source",
            "/StructTreeRoot",
            "/Marked true",
            "D:1980",
        ] {
            assert!(plain.contains(part), "{part}");
        }
        assert!(!plain.contains("/JavaScript") && !plain.contains("/Encrypt"));
        for name in ["parameters.json", "accuracy.json", "campaign.json"] {
            let attached = tool("qpdf", &[&format!("--show-attachment={name}"), "{}"], &file).unwrap();
            assert!(attached == std::fs::read_to_string(scratch.path().join("out").join(name)).unwrap(), "{name}");
        }
    }

    #[test]
    fn the_digital_certificate_is_attached_where_it_was_exported_and_when_the_report_is_made_again() {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace(
            "campaign.toml",
            "robot = \"robot.toml\"",
            "date = \"2026-03-02\"\ncontrollers = [\"dcc\"]\nrobot = \"robot.toml\"",
        );
        assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
        let name = "calibration_certificate_draft.xml";
        let exported = std::fs::read_to_string(scratch.path().join("out").join(name)).unwrap();
        for again in [false, true] {
            if again {
                assert!(etalon(scratch.root(), &["report", "campaign/out"]).status.success());
            }
            let file = scratch.path().join("out/report.pdf");
            let Some(attached) = tool("qpdf", &[&format!("--show-attachment={name}"), "{}"], &file) else { return };
            assert_eq!(attached, exported);
            assert!(!tool("qpdf", &["--list-attachments", "{}"], &file).unwrap().is_empty());
        }
    }
}

/// What `pdftotext` reads of a file; `None` where it is not installed, or there is no PDF.
pub(super) fn text_of_pdf(file: &Path) -> Option<String> {
    if cfg!(feature = "pdf") { tool("pdftotext", &["-layout", "{}", "-"], file) } else { None }
}

/// A workbook of the output folder.
pub(super) fn workbook(scratch: &Scratch) -> Xlsx<Cursor<Vec<u8>>> {
    calamine::open_workbook_from_rs(Cursor::new(std::fs::read(scratch.path().join("out/report.xlsx")).unwrap()))
        .unwrap()
}

/// The cells below the header whose title is `column`.
pub(super) fn column(book: &mut Xlsx<Cursor<Vec<u8>>>, sheet: &str, column: &str) -> Vec<Data> {
    let range = book.worksheet_range(sheet).unwrap();
    let titles: Vec<String> = range.rows().next().unwrap().iter().map(ToString::to_string).collect();
    let at = titles.iter().position(|t| t == column).unwrap_or_else(|| panic!("{sheet} has no {column}: {titles:?}"));
    range.rows().skip(1).map(|row| row[at].clone()).collect()
}

/// The same numbers, to the last bit, and the same texts.
fn same(cells: &[Data], values: &[Value]) {
    assert_eq!(cells.len(), values.len());
    for (cell, value) in cells.iter().zip(values) {
        match (cell, value) {
            (Data::Empty, Value::Null) => {}
            (Data::Float(a), Value::Number(b)) => assert_eq!(Some(*a), b.as_f64()),
            (Data::String(a), Value::String(b)) => assert_eq!(a, b),
            other => panic!("{other:?}"),
        }
    }
}

fn all(values: &Value, key: &str) -> Vec<Value> {
    values.as_array().unwrap().iter().map(|v| v.pointer(key).cloned().unwrap_or_default()).collect()
}

#[test]
fn the_workbook_holds_every_number_of_a_calibration() {
    let scratch = ran("prexyt-cmm");
    let (parameters, accuracy) = (scratch.json("parameters.json"), scratch.json("accuracy.json"));
    let mut book = workbook(&scratch);
    let list = &parameters["parameters"];
    for (title, key) in [
        ("name", "/name"),
        ("unit", "/unit"),
        ("nominal", "/nominal"),
        ("identified", "/value"),
        ("u (k = 1)", "/standard_uncertainty"),
    ] {
        same(&column(&mut book, "Parameters", title), &all(list, key));
    }
    let identified: Vec<&Value> = list.as_array().unwrap().iter().filter(|p| p["status"] == "identified").collect();
    for (i, p) in identified.iter().enumerate() {
        let name = p["name"].as_str().unwrap();
        same(&column(&mut book, "Covariance", name), &all(&parameters["covariance"], &format!("/{i}")));
        assert_eq!(column(&mut book, "Correlation", name)[i], Data::Float(1.0));
    }
    let singular = all(&parameters["observability"]["singular_values"], "/value");
    let title = "singular value (columns divided by their norms)";
    same(&column(&mut book, "Singular values", title)[..singular.len()], &singular);
    // the set that decides, the last one, is first
    let mut sets = all(&accuracy["sets"], "/errors");
    sets.rotate_right(1);
    let errors: Vec<Value> = sets.iter().flat_map(|e| all(e, "/after/rms")).collect();
    same(&column(&mut book, "Errors", "after, RMS"), &errors);
    same(&column(&mut book, "Tool point", "expected, RMS"), &[accuracy["tool"]["after"]["rms"].clone()]);
    same(&column(&mut book, "Predicted errors", "95 % [mm]"), &all(&accuracy["map"]["nodes"], "/p95_mm"));
    same(&column(&mut book, "Limits", "reached"), &all(&accuracy["limits"], "/value"));
    let inputs = &parameters["provenance"]["inputs"];
    let checksums: Vec<Value> = inputs.as_object().unwrap().values().cloned().collect();
    same(&column(&mut book, "Inputs", "SHA-256"), &checksums);
    let features = scratch.json("features.json");
    same(&column(&mut book, "Features", "point x [mm]"), &all(&features["features"], "/point_mm/0"));
    let frames = scratch.json("frames.json");
    let axis = all(&frames["world"]["poses"], "/export_T_world/rotation/1/0");
    same(&column(&mut book, "Frames", "x axis, y"), &axis);
    // every residual, and their largest by pose
    let largest = |book: &mut _, sheet: &str, title: &str| {
        let cells = column(book, sheet, title);
        cells.iter().filter_map(|c| if let Data::Float(v) = c { Some(*v) } else { None }).fold(0.0, f64::max)
    };
    let count: u64 = all(&accuracy["sets"], "/count").iter().filter_map(Value::as_u64).sum();
    assert_eq!(column(&mut book, "Residuals", "after, x [mm]").len() as u64, count);
    let max = all(&accuracy["sets"], "/errors/0/after/max").iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert!((largest(&mut book, "Errors by pose", "position after, max [mm]") - max).abs() < 1e-12);
}

#[test]
fn the_workbook_holds_every_characteristic_of_a_test() {
    let scratch = ran("prexyt-repeatability");
    let found = scratch.json("iso9283.json");
    let mut book = workbook(&scratch);
    let mut poses = found["poses"].as_array().unwrap().clone();
    poses.push(found["homing"].clone());
    for (title, key) in
        [("RP [mm]", "/rp_mm"), ("RP along z [mm]", "/rp_along_z_mm"), ("U over RP", "/uncertainty_over_rp")]
    {
        same(&column(&mut book, "ISO 9283 poses", title), &all(&Value::Array(poses.clone()), key));
    }
    same(&column(&mut book, "ISO 9283 variation", "vAP [mm]"), &all(&found["approaches"], "/vap_mm"));
    same(&column(&mut book, "ISO 9283 visits", "z [mm]"), &all(&found["visits"], "/attained_mm/2"));
    same(&column(&mut book, "ISO 9283 visits", "approached"), &all(&found["visits"], "/approach"));
    let recorded = scratch.json("iso9283-streams.json");
    same(&column(&mut book, "Streams", "duration [s]"), &all(&recorded["streams"], "/stream/duration_s"));
    let stood = all(&recorded["streams"], "/stream/standstills");
    let noise: Vec<Value> = stood.iter().flat_map(|s| all(s, "/noise_mm")).collect();
    same(&column(&mut book, "Standstills", "noise [mm]"), &noise);
    let sheets = book.sheet_names();
    assert!(sheets.iter().any(|s| s == "Summary") && !sheets.iter().any(|s| s == "Parameters"), "{sheets:?}");
}

#[test]
fn names_are_texts_in_the_workbook_and_never_formulas() {
    let scratch = copy_sample("prexyt-cmm");
    let name = r#"=HYPERLINK("http://192.0.2.1","x")"#;
    scratch.replace("campaign.toml", "\"PreXYT, CMM (synthetic)\"", &format!("'{name}'"));
    assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
    let mut book = workbook(&scratch);
    let told = column(&mut book, "Summary", "value");
    assert!(told.contains(&Data::String(name.to_owned())), "{told:?}");
    for sheet in book.sheet_names() {
        assert!(book.worksheet_formula(&sheet).unwrap().is_empty(), "{sheet}");
    }
    let bytes = std::fs::read(scratch.path().join("out/report.xlsx")).unwrap();
    assert!(!text_in(&bytes, "Target=\"http"));
}

/// Whether any part of a ZIP file holds `text`.
fn text_in(bytes: &[u8], text: &str) -> bool {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
    (0..archive.len()).any(|i| {
        let mut part = String::new();
        std::io::Read::read_to_string(&mut archive.by_index(i).unwrap(), &mut part).unwrap();
        part.contains(text)
    })
}

/// Names are no numbers: in a German report only numbers get a decimal comma.
#[test]
fn a_target_that_is_named_like_a_number_keeps_its_point() {
    let own = copy_sample("probe-poses");
    own.replace("observations.csv", ",probe,", ",77.31,");
    own.replace("campaign.toml", "[limits]", "[report]\nlanguage = \"de\"\n\n[limits]");
    crate::support::scratch::ends(&own, "run", 0, &[]);
    let page = std::fs::read_to_string(own.path().join("out/report.html")).unwrap();
    assert!(page.contains(">77.31<") && !page.contains("77,31"), "{}", page.matches("77,31").count());
}
