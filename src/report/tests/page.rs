//! Whole page: required contents, unusual input, forbidden contents.

use super::demo::{Documents, point};
use super::{demo_iso9283, demo_streams, report_texts};
use crate::campaign::contents;
use crate::*;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Place;
use etalon_base::warning;
use etalon_documents::{Language, PoseSet, Refused, Statistics};

fn html(results: &Results) -> Result<String> {
    Ok(String::from_utf8(Renderer::campaign(results)?.file("html")?).unwrap())
}

/// Page alone.
fn page(documents: &Documents) -> String {
    let words = &Words::new(documents.campaign.report.language);
    super::super::html::html(&contents(&documents.results(), words), &documents.campaign.report, words).unwrap()
}

#[test]
fn the_demo_page_has_what_a_reader_needs() {
    let page = page(&Documents::demo());
    if let Some(path) = std::env::var_os("ETALON_REPORT_DEMO") {
        std::fs::write(path, &page).unwrap();
    }
    let needed = [
        "Synthetic data: ",
        "Both limits of the campaign are met.",
        "2.0895 → 0.0442 mm",
        "U = 2.7 µm per coordinate (k = 2)",
        "held: not separately identifiable",
        "measured minus predicted, magnified ",
        "is not a number (column y)",
        "1.19 × the value from the stated uncertainty alone",
    ];
    for text in needed {
        assert!(page.contains(text), "{text}");
    }
    for id in
        ["verdict", "messages", "errors", "pictures", "parameters", "budget", "fit", "frames", "import", "provenance"]
    {
        assert!(page.contains(&format!("<section id=\"{id}\"")) && page.contains(&format!("href=\"#{id}\"")), "{id}");
    }
    // two of page one, ten figures of errors, three of parameters, two of residuals, one of
    // singular values
    assert_eq!(page.matches("<svg").count(), 18);
}

/// A parameter is effective if residuals exceed the instrument's uncertainty, and if most of the
/// parameter's uncertainty is due to the model.
#[test]
fn parameters_that_take_up_what_the_model_leaves_out_are_named_beside_their_table() {
    let mut documents = Documents::demo();
    let parameters = &mut documents.parameters;
    parameters.residuals.uncertainties_from = etalon_documents::UncertaintyFrom::ResidualsByRegion;
    let of: Vec<(String, f64)> =
        parameters.identified().map(|p| (p.name.clone(), p.standard_uncertainty.unwrap())).collect();
    let share = |k: usize| if k == 1 { 0.8 } else { 0.6 };
    parameters.budget = vec![etalon_documents::BudgetSource {
        source: etalon_documents::UncertaintySource::Model,
        standard_uncertainties: of.iter().enumerate().map(|(k, (_, u))| share(k) * u).collect(),
        nominal: None,
    }];
    assert_eq!(parameters.effective(), [of[1].0.as_str()]);
    let sentences = tr!(Words::default(), "effective-parameters", names = of[1].0);
    let named = sentences.split_once(". ").unwrap().0;
    assert!(page(&documents).contains(named) && !page(&Documents::demo()).contains(named), "{named}");
}

#[test]
fn the_page_needs_no_network_and_runs_one_script_only() {
    let page = page(&Documents::demo());
    for text in ["http:", "https:", "src=", "url(", "@import", "<link", "xmlns", "javascript"] {
        assert!(!page.contains(text), "{text}");
    }
    assert_eq!(page.matches("<script").count(), 1);
    assert!(page.contains(&format!("<script>{}</script>", super::super::html::SCRIPT)));
    let policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src 'sha256-";
    assert!(page.contains(policy) && !page.contains("unsafe-inline' 'unsafe") && !page.contains("unsafe-eval"));
}

/// Offline an id leads to its explanation on the same page; the meaning is its tooltip.
#[test]
fn every_id_of_a_message_leads_to_its_explanation() {
    let mut documents = Documents::demo();
    let several = [3, 4].map(|pose| warning!("few-cycles", least = 30, count = 1, poses = pose));
    documents.parameters.messages.extend(several);
    let page = html(&documents.results()).unwrap();
    assert!(page.matches("<a href=\"#message-few-cycles\" title=\"").count() >= 1, "{page}");
    assert_eq!(page.matches("<code id=\"message-few-cycles\">").count(), 1);
    let links: Vec<&str> = page.split("<a href=\"#").skip(1).filter_map(|rest| Some(rest.split_once('"')?.0)).collect();
    for link in links {
        assert_eq!(page.matches(&format!("id=\"{link}\"")).count(), 1, "{link}");
    }
    let explained = etalon_base::catalogue::entries().into_iter().find(|entry| entry.id == "few-cycles").unwrap();
    assert!(page.contains(&explained.meaning) && page.contains(&explained.action), "{page}");
    // what does not occur is not explained
    assert!(!page.contains("message-unit-missing"));
}

#[test]
fn the_same_documents_make_the_same_bytes() {
    assert_eq!(page(&Documents::demo()), page(&Documents::demo()));
}

#[test]
fn of_many_poses_the_page_has_the_worst_and_says_what_is_left_out() {
    let mut documents = Documents::demo();
    let error = |i: i64| {
        let size = 0.001 * (1 + i % 97) as f64;
        let mut error = point(i, [10.0 * (i % 120) as f64, 10.0 * (i / 120) as f64, 0.0], [0.3; 3], [size; 3]);
        error.set = if i < 8400 { PoseSet::Calibration } else { PoseSet::Validation };
        error
    };
    documents.errors = (0..16_800).map(error).collect();
    let page = page(&documents);
    assert!(page.len() < 3_000_000, "{}", page.len());
    assert!(page.contains(&tr!(Words::default(), "rows-in-workbook", count = 16_300)));
    assert!(page.contains(&tr!(Words::default(), "outliers-then-largest-errors")));
}

/// Paper shows 200 rows: the outlier of the fit and the largest errors of both sets are among them.
#[test]
fn outliers_and_the_largest_errors_of_both_sets_are_first() {
    let mut documents = Documents::demo();
    let error = |i: i64| {
        let size = 0.001 * (1 + i) as f64;
        let mut error = point(i, [10.0 * i as f64, 0.0, 0.0], [0.9; 3], [size, 0.0, 0.0]);
        error.set = if i % 3 == 0 { PoseSet::Validation } else { PoseSet::Calibration };
        error
    };
    documents.errors = (0..300).map(error).collect();
    let pose = |pose: i64, residual_over_sigma| etalon_documents::RobustPose {
        pose: pose.into(),
        weight: 0.01,
        residual_over_sigma,
    };
    documents.parameters.robust = Some(etalon_documents::RobustSummary {
        constant: 2.385,
        sigma_mm: 0.01,
        parameters: Vec::new(),
        critical: 3.0,
        poses: vec![pose(4, 6.2), pose(5, 2.0)],
        critical_residual: 4.0,
        disagreeing: 1,
    });
    let page = page(&documents);
    let table = page.split(&tr!(Words::default(), "outliers-then-largest-errors")).nth(1).unwrap();
    let first = |i: usize| table.split("<tr>").nth(2 + i).unwrap();
    assert!(first(0).contains(">4<") && first(0).ends_with(">6.2"), "{}", first(0));
    for (row, pose, set) in [(1, 299, "calibration"), (2, 298, "calibration"), (3, 297, "validation")] {
        assert!(first(row).contains(&format!(">{pose}<")) && first(row).contains(set), "{}", first(row));
    }
    assert!(include_str!("../pdf/report.typ").contains(&format!("#let most = {}\n", crate::model::PAPER_ROWS)));
}

/// Puts a text wherever a campaign, a file or a person can put one.
pub(crate) fn with_text(text: &str) -> Documents {
    let mut d = Documents::demo();
    let t = || text.to_owned();
    let c = &mut d.campaign;
    (c.name, c.measurements.synthetic, c.measurements.notes, c.measurements.date) =
        (t(), Some(t()), Some(t()), Some(t()));
    (c.measurements.operator, c.instrument.name) = (Some(t()), Some(t()));
    let given = &mut c.conditions;
    (given.laboratory, given.robot.description, given.robot.controller) = (Some(t()), Some(t()), Some(t()));
    (given.robot.mounting, given.measurement_point) = (Some(t()), Some(t()));
    (given.environment, given.instrument_calibration) = (Some(t()), Some(t()));
    given.deviations = Some(vec![t(), t()]);
    let message = || Message::error(t()).at(Place::line(t(), 1, t())).expected(t()).hint(t());
    d.import.messages = vec![message()];
    for s in &mut d.import.sources {
        (s.file, s.dialect, s.sha256) = (t(), t().into(), t());
        s.refused = vec![Refused { line: 1, text: t(), reason: t().into() }];
    }
    d.features.features.iter_mut().for_each(|f| (f.name, f.element) = (t(), t()));
    d.frames.world.definition = t().into();
    let p = &mut d.parameters;
    (p.robot, p.messages) = (t(), vec![message()]);
    p.parameters.iter_mut().for_each(|p| (p.name, p.unit, p.confounded_with) = (t(), t(), vec![t()]));
    (p.solver.method, p.solver.meaning) = (t().into(), t());
    if let Some(o) = &mut p.observability {
        o.scaling = t().into();
        o.singular_values.iter_mut().chain(&mut o.held_singular_values).for_each(|s| s.parameters = vec![t(), t()]);
    }
    (p.provenance.version, p.provenance.inputs) = (t(), [(t(), t())].into());
    d.accuracy.definition = t().into();
    d.accuracy.sets.iter_mut().flat_map(|s| &mut s.errors).for_each(|e| e.unit = t());
    d.accuracy.limits.iter_mut().for_each(|l| l.unit = t());
    // a single set keeps the page below the size at which titles of marks become data
    d.errors.truncate(d.errors.len() / 2);
    d.errors.iter_mut().for_each(|e| (e.set, e.target) = (PoseSet::Calibration, t()));
    d
}

#[test]
fn no_text_leaves_its_place() {
    let tags = page(&with_text("plain")).matches('<').count();
    let hostile = "</td></script><script>alert(1)</script>&\"'<!--{{ 7*7 }}";
    let page = page(&with_text(hostile));
    assert_eq!(page.matches('<').count(), tags);
    assert!(page.matches("<script").count() == 1 && !page.contains("<!--") && page.contains("{{ 7*7 }}"));
    assert!(page.matches("&lt;script&gt;alert(1)").count() > 300);
}

#[test]
fn long_and_right_to_left_names_are_isolated() {
    let long = "n".repeat(200);
    assert!(page(&with_text(&long)).contains(&format!("<h1><bdi>{long}</bdi></h1>")));
    let hebrew = "\u{202e}\u{5e8}\u{5d5}\u{5d1}\u{5d5}\u{5d8}";
    let page = page(&with_text(hebrew));
    assert!(page.contains(&format!("<h1><bdi>{hebrew}</bdi></h1>")));
    assert!(page.contains(&format!("cycle 1, \u{2068}{hebrew}\u{2069} (calibration)")));
}

#[test]
fn nothing_to_draw_is_said() {
    let mut documents = Documents::demo();
    documents.errors.clear();
    documents.accuracy.sets.clear();
    documents.accuracy.relative = None;
    documents.import.sources.clear();
    documents.import.messages.clear();
    documents.parameters.messages.clear();
    documents.parameters.parameters.clear();
    documents.parameters.observability = None;
    documents.features.features.clear();
    documents.frames.world.poses.clear();
    let page = page(&documents);
    // limits are drawn without errors
    assert_eq!(page.matches("<svg").count(), 1);
    for id in ["no-error-to-draw", "no-errors-are-given", "the-campaign-fits-no-features"] {
        assert!(page.contains(&Words::default().tr(&Phrase::new(id))), "{id}");
    }
}

#[test]
fn numbers_that_are_none_and_lone_points_do_no_harm() {
    for size in [0.0, 0.3, 1e-12, 1e300, f64::NAN, f64::INFINITY] {
        for count in [1, 2, 300] {
            let mut d = Documents::demo();
            d.errors = vec![point(1, [size; 3], [size; 3], [size; 3]); count];
            d.errors[0].before_deg = Some(size);
            d.errors[0].after_deg = Some(size);
            d.frames.world.planar = false;
            d.parameters.residuals.rms = size;
            d.parameters.residuals.uncertainties_enlarged_by = size;
            if let Some(o) = &mut d.parameters.observability {
                (o.condition, o.singular_values[0].value) = (size, size);
            }
            d.parameters.parameters[0].value = size;
            d.parameters.parameters[1].standard_uncertainty = Some(size);
            d.campaign.instrument.expanded_uncertainty_um = Some(size);
            d.features.features[0].direction = [size; 3];
            d.accuracy.sets[0].errors[0].before = Statistics { mean: size, rms: size, p95: size, max: size };
            d.accuracy.sets[1].errors[0].after = Statistics { mean: size, rms: size, p95: size, max: size };
            d.accuracy.limits[0].value = Some(size);
            let page = page(&d);
            assert!(!page.contains("NaN") && !page.contains(">inf"), "{size}");
            assert_eq!(
                page.contains("id=\"histogram-position-after-title\""),
                size.is_finite() && size < 1e7,
                "{size}"
            );
        }
    }
}

#[test]
fn the_figures_name_the_command_of_the_page_in_three_dimensions() {
    let page = page(&Documents::demo());
    let figures = &page[page.find("<section id=\"pictures\"").unwrap()..];
    let figures = &figures[..figures.find("</section>").unwrap()];
    // a page that nobody has written is no link
    assert!(!figures.contains("href=\"view.html\""), "{figures}");
    assert!(figures.contains("etalon view FOLDER --export view.html"));
}

#[test]
fn spatial_data_are_seen_from_above_and_from_the_side() {
    let mut documents = Documents::demo();
    documents.frames.world.planar = false;
    documents.errors[0].at_mm[2] = 100.0;
    let page = page(&documents);
    assert!(page.contains("Position error before calibration, xz plane") && page.contains("z (mm)"));
    assert_eq!(page.matches("<svg").count(), 28);
}

#[test]
fn a_test_report_has_what_the_standard_asks_for() {
    let (documents, tested) = (Documents::demo(), demo_iso9283::tested());
    let page = html(&Results { identified: None, tested, ..documents.results() }.judged()).unwrap();
    for what in ["operator", "mounting", "load centre", "warm-up", "deviations from the method", "SHA-256"] {
        assert!(page.contains(what), "{what}");
    }
    let sha256 = &documents.import.sources[0].sha256;
    assert!(page.contains(sha256) && page.contains(env!("CARGO_PKG_VERSION")));
    assert!(page.contains(&tr!(Words::default(), "poses-and-visits", poses = 2, visits = "30")));
}

/// Calibration report and test report in a language, both with recorded motions.
fn in_language(language: Language) -> [String; 2] {
    let mut documents = Documents::demo();
    documents.campaign.report.language = language;
    let tested = Characteristics { streams: Some(demo_streams::streams()), ..demo_iso9283::whole() };
    let results = Results { tested, ..documents.results() }.judged();
    [html(&results).unwrap(), html(&Results { identified: None, ..results }.judged()).unwrap()]
}

/// Texts of a section of a page, except for those marked as English.
fn texts<'a>(page: &'a str, id: &str) -> impl Iterator<Item = &'a str> {
    let section = page.split_once(&format!("<section id=\"{id}\">")).unwrap().1;
    let section = section.split_once("</section>").unwrap().0;
    let marked = |piece: &&str| !piece.starts_with("bdi lang=\"en\"");
    section.split('<').filter(marked).filter_map(|piece| Some(piece.split_once('>')?.1.trim()))
}

#[test]
fn recorded_motions_are_in_the_language_of_the_report() {
    let english = in_language(Language::En);
    let is_word = |text: &str| text.split(|c: char| !c.is_alphabetic()).any(|word| word.len() > 3);
    for language in [Language::Fr, Language::De] {
        let (known, pages) = (report_texts(language).collect::<Vec<_>>(), in_language(language));
        let mut compared = 0;
        for (english, other) in texts(&english[1], "streams").zip(texts(&pages[1], "streams")) {
            if ["square", "seam", "motion.csv"].contains(&english) || !is_word(english) {
                continue;
            }
            compared += 1;
            // texts that are equal in both languages
            let numbers: String = english.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect();
            let is_alike =
                known.iter().any(|(text, _)| text == english.trim_end_matches(" (µm)")) || numbers == "pose 0";
            assert!(other != english || is_alike, "{language:?}: {english}");
        }
        assert!(compared > 40, "{compared}");
    }
}

#[test]
fn a_page_speaks_one_language_and_marks_what_is_english() {
    let english = in_language(Language::En);
    for (language, verdict) in
        [(Language::Fr, "erreur de position maximale"), (Language::De, "größte Positionsabweichung")]
    {
        let pages = in_language(language);
        assert!(pages[0].contains(verdict) && pages[0].contains("<bdi lang=\"en\">Error: measured minus predicted."));
        for (page, english) in pages.iter().zip(&english) {
            assert!(page.contains(&format!("<html lang=\"{}\">", language.code())));
            // one additional note, on the texts of the campaign
            let tags = |page: &str| page.matches('<').count() - 2 * page.matches("<bdi lang=\"en\">").count();
            assert_eq!(tags(page), tags(english) + 2);
            let own = |text: &String| text.len() > 9 && english.contains(&format!(">{text}<"));
            let differing =
                report_texts(language).filter(|(english, other)| english != other).map(|(english, _)| english);
            for text in differing.filter(own) {
                assert!(!page.contains(&format!(">{text}<")), "{language:?}: {text}");
            }
        }
    }
    assert!(english[0].contains("<html lang=\"en\">"));
}

#[test]
fn a_laboratory_puts_its_template_and_logo_in_place() {
    let mut documents = Documents::demo();
    let report = &mut documents.campaign.report;
    report.logo = Some("data:image/png;base64,iVBORw==".to_owned());
    report.templates.insert("signatures.html".to_owned(), "<p>Seal of {{ title }}</p>".to_owned());
    let dressed = page(&documents);
    assert!(dressed.contains("<p>Seal of PreXYT, CMM, spring check</p>") && !dressed.contains("Approved by"));
    assert_eq!(dressed.matches("<img class=\"logo\" src=\"data:image&#x2f;png;base64,iVBORw==\"").count(), 1);
    let mut broken = |text: &str| {
        documents.campaign.report.templates.insert("signatures.html".to_owned(), text.to_owned());
        html(&documents.results()).unwrap_err().to_string()
    };
    let unknown = broken("<p>\n{{ no_such_key }}</p>");
    assert!(unknown.contains("signatures.html:2") && unknown.contains("{{ no_such_key }}"), "{unknown}");
    let unclosed = broken("{% if true %}");
    assert!(unclosed.contains("signatures.html:1"), "{unclosed}");
}

/// Red, green and blue of `#rgb` or `#rrggbb`.
fn colour(text: &str) -> [f64; 3] {
    let digits: Vec<u32> = text.trim_start_matches('#').chars().filter_map(|c| c.to_digit(16)).collect();
    match digits[..] {
        [r, g, b] => [r, g, b].map(|c| f64::from(17 * c)),
        [a, b, c, d, e, f] => [[a, b], [c, d], [e, f]].map(|[high, low]| f64::from(16 * high + low)),
        _ => panic!("{text} is no colour"),
    }
}

/// Contrast of two colours (WCAG 2.2): 21 for black on white.
fn contrast(one: &str, other: &str) -> f64 {
    let [one, other] = [one, other].map(|text| super::luminance(&colour(text)) + 0.05);
    one.max(other) / one.min(other)
}

/// Text on every background of the page, and in figures, on light and dark pages: at least 4.5
/// (WCAG 2.2, 1.4.3, level AA).
#[test]
fn text_has_enough_contrast_on_every_background() {
    assert!((contrast("#000", "#fff") - 21.0).abs() < 1e-9);
    let (style, picture) = (include_str!("../html/style.html"), include_str!("../html/picture.css"));
    let (light, dark) = style.split_once("prefers-color-scheme: dark").unwrap();
    let variable = |text: &str, name: &str| {
        let value = text.split(&format!("--{name}: ")).nth(1).unwrap().split(';').next().unwrap();
        value.trim().to_owned()
    };
    let fill = |text: &str, selector: &str| {
        text.split(&format!("{selector} {{ fill: ")).nth(1).unwrap().split([';', ' ', '}']).next().unwrap().to_owned()
    };
    let mut poor = Vec::new();
    for (theme, page, figure) in [("light", light, picture), ("dark", dark, dark)] {
        let background = |name: &str| (name.to_owned(), variable(page, name));
        let mut pairs = Vec::new();
        for name in ["page", "tint", "good", "bad", "warn", "made"] {
            pairs.extend(["ink", "link"].map(|text| (text.to_owned(), variable(page, text), background(name))));
        }
        pairs.extend(["page", "tint"].map(|name| ("soft".to_owned(), variable(page, "soft"), background(name))));
        for text in ["svg text", "svg .name"] {
            pairs.push((text.to_owned(), fill(figure, text), background("page")));
        }
        for (text, colour, (name, behind)) in pairs {
            let ratio = contrast(&colour, &behind);
            if ratio < 4.5 {
                poor.push(format!("{theme}: {text} on {name}: {ratio:.2}"));
            }
        }
    }
    // the mark of a draft, on the screen
    assert!(contrast("#fff", "#a3201d") > 4.5 && style.contains("color: #fff !important; background: #a3201d"));
    assert!(poor.is_empty(), "{poor:#?}");
}
