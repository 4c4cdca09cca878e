//! Every number of a sentence is a number of a document of the same run, and the page, PDF, workbook, certificate and terminal print the same
//! sentences. Each of their numbers is in a table of the page and of the certificate.
//!
//! A sentence without a rule here is a failure: whoever adds a sentence says where its numbers come from.

use super::reports::tool;
use super::{etalon, text_of};
use crate::support::scratch::{Scratch, copy_sample};
use calamine::{Reader, Xlsx};
use serde_json::Value;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::io::Cursor;
use std::path::Path;

/// A number as printed: its text, its unit, and whether it is a bound (`< 0.1`).
#[derive(Clone, Debug)]
struct Printed {
    text: String,
    unit: String,
    is_bound: bool,
}

impl Printed {
    /// Whether a number of a document rounds to what is printed; lengths of documents are in mm.
    fn is(&self, expected: f64) -> bool {
        let expected = if self.unit == "µm" { 1e3 * expected } else { expected };
        let shown: f64 = self.text.parse().unwrap();
        let decimals = self.text.split_once('.').map_or(0, |(_, digits)| digits.len());
        let half = 0.5 * 10f64.powi(-(decimals as i32));
        if self.is_bound { expected < shown } else { (shown - expected).abs() <= half * (1.0 + 1e-6) }
    }
}

/// A sentence with its numbers replaced by `#`, and the numbers.
#[derive(Debug)]
struct Sentence {
    template: String,
    numbers: Vec<Printed>,
}

/// Clauses and coverage factors, which are no results.
const CITED: [&str; 10] = [
    "(ILAC-G8:09/2019, 4.2.3)",
    "(ILAC-G8:09/2019, 4.2.1)",
    "(ISO 9283, clause 6)",
    "(ISO 9283, 7.6)",
    "ISO 9283 allows 25 %",
    "(k = 1)",
    "(k = 2)",
    "25 % of AP or RP",
    "25 % of the verified value",
    "25 % of RP",
];

impl Sentence {
    fn parse(text: &str) -> Self {
        let mut text = CITED.iter().fold(text.to_owned(), |text, cited| text.replace(cited, ""));
        // names of files and commands
        while let Some((from, to)) =
            text.find('`').and_then(|from| Some((from, from + 1 + text[from + 1..].find('`')?)))
        {
            text.replace_range(from..=to, "");
        }
        let letters: Vec<char> = text.chars().collect();
        let (mut template, mut numbers, mut i) = (String::new(), Vec::<(Printed, usize)>::new(), 0);
        while i < letters.len() {
            let within_word = template.chars().next_back().is_some_and(|c| c.is_alphanumeric() || c == '_');
            if !letters[i].is_ascii_digit() || within_word {
                template.push(letters[i]);
                i += 1;
                continue;
            }
            let is_part = |k: usize| {
                let digit = |k: usize| letters.get(k).is_some_and(char::is_ascii_digit);
                digit(k) || letters.get(k) == Some(&'.') && digit(k + 1)
            };
            let end = (i..).find(|k| !is_part(*k)).unwrap();
            let mut number: String = letters[i..end].iter().collect();
            if template.ends_with('-') && !template.trim_end_matches('-').ends_with(|c: char| c.is_alphanumeric()) {
                number.insert(0, '-');
                template.pop();
            }
            let unit: String =
                letters[end..].iter().skip(1).take_while(|c| c.is_alphanumeric() || "%×σ".contains(**c)).collect();
            let unit = if ["mm", "µm", "deg", "%"].contains(&unit.as_str()) { unit } else { String::new() };
            let is_bound = template.trim_end().ends_with('<');
            template.push('#');
            numbers.push((Printed { text: number, unit, is_bound }, template.len()));
            i = end;
        }
        // the unit of a chain is behind its last number
        for k in (1..numbers.len()).rev() {
            let between = &template[numbers[k - 1].1..numbers[k].1 - 1];
            if numbers[k - 1].0.unit.is_empty() && [" → ", " ± ", " to ", " ("].contains(&between) {
                numbers[k - 1].0.unit = numbers[k].0.unit.clone();
            }
        }
        Self { template, numbers: numbers.into_iter().map(|(number, _)| number).collect() }
    }
}

/// Sentences of a line.
fn sentences(line: &str) -> Vec<String> {
    let mut all = vec![String::new()];
    let letters: Vec<char> = line.chars().collect();
    for (i, c) in letters.iter().enumerate() {
        all.last_mut().unwrap().push(*c);
        let ends = *c == '.' && letters.get(i + 1) == Some(&' ');
        // a name of a parameter or a number may begin a sentence, an abbreviation ends none here
        if ends && letters.get(i + 2).is_none_or(|next| next.is_uppercase() || *next == '`') {
            all.push(String::new());
        }
    }
    all.into_iter().map(|s| s.trim().to_owned()).filter(|s| !s.is_empty()).collect()
}

/// Documents of a run.
struct Documents {
    folder: std::path::PathBuf,
}

impl Documents {
    fn read(&self, name: &str) -> Value {
        std::fs::read(self.folder.join(name)).ok().map_or(Value::Null, |bytes| serde_json::from_slice(&bytes).unwrap())
    }

    /// Statistics of an error in a set of poses.
    fn statistics(&self, set: &str, quantity: &str) -> Option<Value> {
        let accuracy = self.read("accuracy.json");
        let sets = accuracy["sets"].as_array()?;
        let errors = sets.iter().find(|s| s["name"] == set)?["errors"].as_array()?.clone();
        errors.into_iter().find(|e| e["quantity"] == quantity)
    }

    fn limits(&self) -> Vec<Value> {
        self.read("verdict.json")["limits"].as_array().cloned().unwrap_or_default()
    }

    fn poses(&self) -> Vec<Value> {
        self.read("iso9283.json")["poses"].as_array().cloned().unwrap_or_default()
    }

    /// Poses that do not meet the rule of a quarter.
    fn poor(&self, is_poor: bool) -> Vec<f64> {
        let over =
            |p: &&Value| ["uncertainty_over_ap", "uncertainty_over_rp"].iter().any(|key| p[*key].as_f64() > Some(0.25));
        self.poses().iter().filter(|p| over(p) == is_poor).map(|p| number(&p["pose"])).collect()
    }

    /// Residuals over their uncertainty.
    fn ratio(&self) -> f64 {
        let residuals = &self.read("parameters.json")["residuals"];
        (number(&residuals["chi_square"]) / number(&residuals["degrees_of_freedom"])).sqrt()
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Names of errors in sentences: quantity, figure, and key of the limit.
const ERRORS: [(&str, &str, &str, &str); 8] = [
    ("Largest position error", "position", "max", "position_max_mm"),
    ("Mean position error", "position", "mean", "position_mean_mm"),
    ("RMS position error", "position", "rms", "position_rms_mm"),
    ("Largest orientation error", "orientation", "max", "orientation_max_deg"),
    ("Largest distance error", "distance", "max", "distance_max_mm"),
    ("Largest distance from a surface", "surface", "max", "surface_max_mm"),
    ("Largest distance from a socket", "contact", "max", "contact_max_mm"),
    ("Largest coordinate error", "coordinate", "max", "coordinate_max_mm"),
];

/// An error before and after calibration.
fn of_error(s: &Sentence, documents: &Documents) -> Option<Vec<f64>> {
    let (_, quantity, figure, key) =
        ERRORS.iter().find(|(name, ..)| s.template.starts_with(&format!("{name} at # ")))?;
    let set = if s.template.contains(" validation poses") { "validation" } else { "calibration" };
    let e = documents.statistics(set, quantity)?;
    let limit = documents.limits().into_iter().find(|l| l["name"] == *key);
    let mut all = vec![number(&e["poses"])];
    all.extend(s.template.contains(" readings)").then(|| number(&e["count"])));
    all.extend([number(&e["before"][figure]), number(&e["after"][figure])]);
    if s.template.contains('±') {
        let of_limit = limit.as_ref().map(|l| number(&l["expanded_uncertainty"]));
        all.push(of_limit.unwrap_or_else(|| number(&e["expanded_uncertainty"])));
    }
    if let Some(limit) = limit {
        all.push(number(&limit["limit"]));
        all.extend(s.template.contains("margin #").then(|| number(&limit["margin"])));
        let risk = || 100.0 * (1.0 - number(&limit["conformity_probability"]));
        all.extend(s.template.contains("false acceptance").then(risk));
    }
    Some(all)
}

/// The largest characteristic, with its pose: of one approach, if visits come from several.
fn of_characteristic(symbol: &str, documents: &Documents) -> Option<Vec<f64>> {
    let poses = documents.poses();
    let value = |p: &Value| match &p[format!("{symbol}_approach")]["value_mm"] {
        Value::Null => number(&p[format!("{symbol}_mm")]),
        judged => number(judged),
    };
    let worst = poses.iter().max_by(|a, b| value(a).total_cmp(&value(b)))?;
    Some(vec![value(worst), number(&worst["pose"])])
}

/// What the numbers of a sentence on a test to ISO 9283 must be.
fn of_test(s: &Sentence, documents: &Documents) -> Option<Vec<f64>> {
    let starts = |text: &str| s.template.starts_with(text);
    let poses = || documents.poses();
    Some(match () {
        () if starts("Largest pose accuracy AP: #") => of_characteristic("ap", documents)?,
        () if starts("Largest pose repeatability RP: #") => of_characteristic("rp", documents)?,
        () if s.template.contains("all # poses conform") => vec![poses().len() as f64],
        () if s.template.contains("exceeds  at pose") => documents.poor(true),
        () if starts("Suitable at poses: #") => documents.poor(false),
        () if s.template.contains("AP changed by up to #") => {
            let drifts = documents.read("iso9283.json")["drifts"].as_array()?.clone();
            let open: Vec<&Value> = drifts.iter().filter(|d| d["settled_after"].is_null()).collect();
            let largest = drifts.iter().map(|d| number(&d["dap_mm"])).fold(0.0, f64::max);
            [largest].into_iter().chain(open.iter().map(|d| number(&d["pose"]))).collect()
        }
        () if starts("AP changes significantly during the test at pose") => {
            let drifts = documents.read("iso9283.json")["drifts"].as_array()?.clone();
            drifts.iter().filter(|d| d["is_significant"] == true).map(|d| number(&d["pose"])).collect()
        }
        () if starts("AP of pose # changes by #") => {
            let drifts = documents.read("iso9283.json")["drifts"].as_array()?.clone();
            let drift = drifts.iter().find(|d| s.numbers[0].is(number(&d["pose"])))?;
            let sets = drift["ap_mm"].as_array()?.len() as f64;
            vec![number(&drift["pose"]), number(&drift["dap_mm"]), sets]
        }
        () if starts("Measure with an expanded uncertainty of a position of at most #") => {
            let sizes =
                poses().iter().flat_map(|p| [p["ap_mm"].as_f64(), p["rp_mm"].as_f64()]).flatten().collect::<Vec<_>>();
            vec![0.25 * sizes.into_iter().fold(f64::INFINITY, f64::min)]
        }
        () if starts("At pose #, U = #") => {
            let all = poses();
            let p = all.iter().find(|p| s.numbers[0].is(number(&p["pose"])))?;
            let over = ["ap", "rp"].map(|c| p[format!("uncertainty_over_{c}")].as_f64().unwrap_or(0.0));
            let key = if over[0] > over[1] { "ap_mm" } else { "rp_mm" };
            let share = over[0].max(over[1]);
            let head = [number(&p["pose"]), share * number(&p[key]), 100.0 * share];
            head.into_iter().chain(documents.poor(true)).collect()
        }
        () if starts("Repeatability for a single approach at pose #") => {
            let document = documents.read("iso9283.json");
            let all = document["approaches"].as_array()?.clone();
            let of = all.iter().find(|v| s.numbers[0].is(number(&v["pose"])))?;
            let sizes: Vec<f64> = of["approaches"].as_array()?.iter().filter_map(|a| a["rp_mm"].as_f64()).collect();
            let together = poses().iter().find(|p| p["pose"] == of["pose"])?["rp_mm"].as_f64()?;
            let [low, high] = [f64::min, f64::max].map(|f| sizes.iter().copied().reduce(f).unwrap());
            vec![number(&of["pose"]), sizes.len() as f64, low, high, together]
        }
        _ => return None,
    })
}

/// What the numbers of a sentence on visits, reference targets and recordings must be.
fn of_recorded(s: &Sentence, documents: &Documents) -> Option<Vec<f64>> {
    let starts = |text: &str| s.template.starts_with(text);
    let largest = |key: &str| -> Option<[f64; 2]> {
        let all = documents.read("iso9283.json")["reference"].as_array()?.clone();
        let size = all.iter().map(|epoch| number(&epoch[key])).fold(0.0, f64::max);
        Some([all.len() as f64 - 1.0, size])
    };
    Some(match () {
        () if starts("The set-up moved by up to #") => vec![largest("moved_mm")?[1]],
        () if starts("Positions were corrected in # steps") => largest("rms_mm")?.to_vec(),
        () if starts("Pose #: no recorded pose precedes one visit") => {
            let visits = documents.read("iso9283.json")["visits"].as_array()?.clone();
            let is_first = |v: &&Value| v["approach"].is_null() && s.numbers[0].is(number(&v["pose"]));
            let first = visits.iter().find(is_first)?;
            vec![number(&first["pose"]), number(&first["cycle"])]
        }
        () if starts("The recording begins at pose #") => {
            vec![number(&documents.read("iso9283-streams.json")["streams"][0]["stream"]["standstills"][0]["pose"])]
        }
        _ => return None,
    })
}

/// Numbers of a sentence about residuals.
fn of_residuals(s: &Sentence, documents: &Documents) -> Option<Vec<f64>> {
    let residuals = &documents.read("parameters.json")["residuals"];
    let starts = |text: &str| s.template.starts_with(text);
    Some(match () {
        () if starts("Position residuals: RMS #") => {
            let rms = number(&residuals["position_rms_mm"]);
            vec![rms, rms / documents.ratio()]
        }
        () if starts("Residuals are # ×") => {
            let freedom = number(&residuals["degrees_of_freedom"]);
            let p = ChiSquared::new(freedom).unwrap().sf(number(&residuals["chi_square"]));
            vec![documents.ratio(), p, 0.001]
        }
        () if s.template.contains("residuals are # ×") => vec![documents.ratio()],
        _ => return None,
    })
}

/// What the numbers of a sentence must be, by the beginning of its template.
fn expected(s: &Sentence, documents: &Documents) -> Option<Vec<f64>> {
    let accuracy = documents.read("accuracy.json");
    let starts = |text: &str| s.template.starts_with(text);
    let found = of_error(s, documents).or_else(|| of_test(s, documents)).or_else(|| of_recorded(s, documents));
    if let Some(found) = found.or_else(|| of_residuals(s, documents)) {
        return Some(found);
    }
    Some(match () {
        () if starts("Test the loaded file at pose #") || starts("Test the file in your software") => {
            let files = documents.read("campaign.json")["controller_files"].as_array()?.clone();
            vec![files.iter().map(|file| &file["check"]["pose"]).find(|pose| !pose.is_null()).map(number)?]
        }
        () if starts("Loading moves taught positions by up to #") => {
            let files = documents.read("campaign.json")["controller_files"].as_array()?.clone();
            let check = files.iter().map(|file| &file["check"]).find(|check| !check.is_null())?;
            let at = |row: &str| (0..3).map(|i| number(&check[row]["xyz_mm"][i])).collect::<Vec<_>>();
            let squares: f64 = at("before").iter().zip(at("after")).map(|(a, b)| (a - b).powi(2)).sum();
            vec![squares.sqrt(), number(&check["pose"])]
        }
        // the name of a hash
        () if s.template.contains(" its SHA-#") => vec![256.0],
        () if starts("Within the limit of #") => {
            let limits: Vec<f64> = documents.limits().iter().map(|l| number(&l["limit"])).collect();
            vec![*limits.iter().find(|limit| s.numbers[0].is(**limit))?]
        }
        () if starts("Root-mean-square error at held-out poses: #") => {
            let effect =
                accuracy["effects"].as_array()?.iter().find(|e| s.numbers[0].is(number(&e["without_mm"])))?.clone();
            vec![number(&effect["without_mm"]), number(&effect["with_mm"])]
        }
        () if starts("Root-mean-square error (") => {
            let errors = documents.read("verdict.json")["loading"]["errors"].clone();
            let quantity = s.template.split(['(', ')']).nth(1)?.to_owned();
            let set = if s.template.contains(" validation poses") { "validation" } else { "calibration" };
            let poses = number(&documents.statistics(set, &quantity)?["poses"]);
            vec![poses, number(&errors["nominal"]["rms_mm"]), number(&errors["written"]["rms_mm"])]
        }
        () if starts("Measure pose") => {
            let robust = documents.read("parameters.json")["robust"].clone();
            let disagrees = |p: &&Value| number(&p["residual_over_sigma"]) > number(&robust["critical_residual"]);
            let all = robust["poses"].as_array()?.iter().filter(disagrees);
            let mut named: Vec<f64> = all.take(5).map(|p| number(&p["pose"])).collect();
            let more = number(&robust["disagreeing"]) - named.len() as f64;
            named.extend((more > 0.0).then_some(more));
            named
        }
        () if starts("Pose # disagrees with the others: #") => {
            let worst = documents.read("parameters.json")["robust"]["poses"][0].clone();
            // the table of errors has the error of the pose
            let shown: f64 = s.numbers[1].text.parse().ok()?;
            let error_mm = if s.numbers[1].unit == "µm" { 1e-3 * shown } else { shown };
            vec![number(&worst["pose"]), error_mm, number(&worst["residual_over_sigma"])]
        }
        () if s.template.contains("the distance from a validation pose to the nearest calibration pose") => {
            let distance = &accuracy["validation_distance"];
            vec![number(&distance["median"]), number(&distance["largest"])]
        }
        () if starts("Distinct validation positions with a joint outside") => {
            let distance = &accuracy["validation_distance"];
            vec![number(&distance["outside"]), number(&distance["poses"])]
        }
        () if starts("Expected error, RMS") => ["parameters_mm", "held_mm", "model_mm", "place_mm"]
            .iter()
            .map(|key| number(&accuracy["tool"][*key]))
            .collect(),
        () if starts("Largest expanded uncertainty of a pose") => vec![number(&accuracy["tool"]["expanded_max_mm"])],
        () if starts("At held-out poses, with parameters and field") => {
            ["without_mm", "with_mm"].map(|key| number(&accuracy["field"]["held_out"][key])).to_vec()
        }
        () if starts("The field describes # %") => {
            let held = &accuracy["field"]["held_out"];
            let [without, with] = ["without_mm", "with_mm"].map(|key| number(&held[key]));
            vec![100.0 * (1.0 - (with / without).powi(2)), number(&held["gain_over_u"])]
        }
        _ => return None,
    })
}

/// Numbers of a sentence that are not in the documents.
fn contradictions(text: &str, documents: &Documents) -> Vec<String> {
    // each part of a list of reservations has its own rule
    let parts = text.trim_start_matches("Reservations: ").split("; ").map(Sentence::parse);
    let whole = Sentence::parse(text);
    let split = text.starts_with("Reservations: ");
    let parts: Vec<Sentence> = if split { parts.collect() } else { vec![whole] };
    let wrong = |s: &Sentence| {
        if s.numbers.is_empty() {
            return None;
        }
        let Some(expected) = expected(s, documents) else { return Some(format!("no rule for `{}`", s.template)) };
        let agrees = expected.len() == s.numbers.len() && expected.iter().zip(&s.numbers).all(|(e, n)| n.is(*e));
        (!agrees).then(|| format!("{text}\n  expected {expected:?}"))
    };
    parts.iter().filter_map(wrong).collect()
}

/// Sentences of the terminal: verdict, next steps, and texts between tables.
fn spoken(terminal: &str) -> (Vec<String>, Vec<String>) {
    let numbered =
        |line: &str| line.split_once(". ").filter(|(n, _)| n.parse::<u8>().is_ok()).map(|(_, rest)| rest.to_owned());
    let lines = terminal.lines().skip(1).take_while(|line| !line.starts_with("To complete before signing"));
    let head: Vec<String> = lines.map(|line| numbered(line).unwrap_or_else(|| line.to_owned())).collect();
    let rest = terminal.lines().skip_while(|line| !line.starts_with("To complete before signing")).skip(1);
    // cells of a table are two blanks apart
    let text = |line: &&str| line.ends_with('.') && !line.trim().contains("  ");
    let split = |lines: Vec<String>| lines.iter().flat_map(|line| sentences(line)).collect::<Vec<_>>();
    (split(head), split(rest.filter(text).map(str::to_owned).collect()))
}

/// Text without blanks, tags and marks.
fn squeezed(text: &str) -> String {
    text.chars()
        .filter(|c| !c.is_whitespace() && !['\u{2068}', '\u{2069}', '\u{200b}', '\u{ad}', '`'].contains(c))
        .collect()
}

/// Text of a page.
fn page_text(page: &str) -> String {
    let body = page.split_once("<body").unwrap().1;
    untagged(body.split_once("<script").map_or(body, |(body, _)| body), "")
}

/// Text without its tags, in whose places is `mark`.
fn untagged(text: &str, mark: &str) -> String {
    let texts: Vec<&str> = text.split('<').filter_map(|piece| Some(piece.split_once('>')?.1)).collect();
    [("&#x2f;", "/"), ("&#x27;", "'"), ("&quot;", "\""), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")]
        .iter()
        .fold(texts.join(mark), |text, (escaped, plain)| text.replace(escaped, plain))
}

/// Numbers of sentences that neither a table of the page nor a heading of tables has, in the unit of the sentence or of the table (mm, µm). The one of
/// the two with fewer digits decides.
fn without_table(sentences: &[String], page: &str) -> Vec<String> {
    let within = |tag: &str| -> Vec<Printed> {
        let (begin, end) = (format!("<{tag}"), format!("</{tag}>"));
        let pieces = page.split(&begin).skip(1).filter_map(|rest| rest.split(&end).next());
        pieces.flat_map(|piece| Sentence::parse(&untagged(&format!("{begin}{piece}"), " ")).numbers).collect()
    };
    let cells = [within("table"), within("h3")].concat();
    let is_in_table = |number: &Printed| {
        let is_length = ["mm", "µm"].contains(&number.unit.as_str());
        cells
            .iter()
            .any(|cell| agree(number, cell, 1.0) || is_length && [1e3, 1e-3].iter().any(|f| agree(number, cell, *f)))
    };
    let numbers = |sentence: &String| {
        let lacking = Sentence::parse(sentence).numbers.into_iter().filter(|number| !is_in_table(number));
        lacking.map(|number| format!("no table has {} {}: {sentence}", number.text, number.unit)).collect::<Vec<_>>()
    };
    sentences.iter().flat_map(numbers).collect()
}

/// `true` if a number is `factor` times a cell, within the rounding of the one with fewer digits, which is at most a tenth of the number. A clause
/// is no number.
fn agree(number: &Printed, cell: &Printed, factor: f64) -> bool {
    let half = |text: &str| 0.5 * 10f64.powi(-(text.split_once('.').map_or(0, |(_, digits)| digits.len()) as i32));
    let (Ok(value), Ok(other)) = (number.text.parse::<f64>(), cell.text.parse::<f64>()) else { return false };
    let (exact, coarse) = (half(&number.text), factor * half(&cell.text));
    let within = if coarse < 0.1 * value.abs() { exact.max(coarse) } else { exact };
    if number.is_bound { factor * other <= value } else { (value - factor * other).abs() <= within * (1.0 + 1e-6) }
}

/// Samples with every kind of sentence: of positions, orientations, contacts, distances, surfaces and coordinates, of a field, and of tests.
const SAMPLES: [&str; 9] = [
    "contacts",
    "dextar",
    "field-arm",
    "hexapod",
    "pose-test",
    "prexyt-cmm",
    "prexyt-repeatability",
    "surfaces",
    "two-arms",
];

fn run_of(sample: &str) -> (Scratch, String) {
    let scratch = copy_sample(sample);
    let output = etalon(scratch.root(), &["run", "campaign"]);
    assert!(output.status.code() < Some(2), "{sample}: {}", text_of(&output));
    (scratch, String::from_utf8(output.stdout).unwrap())
}

#[test]
fn every_number_of_a_sentence_is_in_a_document_of_the_run() {
    let mut wrong = Vec::new();
    for sample in SAMPLES {
        let (scratch, terminal) = run_of(sample);
        let out = scratch.path().join("out");
        let documents = Documents { folder: out.clone() };
        let (head, rest) = spoken(&terminal);
        let found = head.iter().chain(&rest).flat_map(|s| contradictions(s, &documents));
        wrong.extend(found.map(|what| format!("{sample}: {what}")));
        wrong.extend(same_sentences(&head, &scratch, &out).into_iter().map(|what| format!("{sample}: {what}")));
        wrong.extend(apart(&documents).into_iter().map(|what| format!("{sample}: {what}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Sentences of the terminal's first page that page, PDF, workbook or certificate do not print.
fn same_sentences(head: &[String], scratch: &Scratch, out: &Path) -> Vec<String> {
    let output = etalon(scratch.root(), &["report", "campaign/out", "--certificate"]);
    assert!(output.status.success(), "{}", text_of(&output));
    let read = |name: &str| page_text(&std::fs::read_to_string(out.join(name)).unwrap());
    let steps = head.iter().position(|s| s == "Next steps").unwrap_or(head.len());
    let mut wrong = Vec::new();
    let mut check = |name: &str, text: &str, sentences: &[String]| {
        let text = squeezed(text);
        let lacking =
            sentences.iter().filter(|s| s.chars().any(|c| c.is_ascii_digit()) && !text.contains(&squeezed(s)));
        wrong.extend(lacking.map(|s| format!("{name} lacks: {s}")));
    };
    check("page", &read("report.html"), head);
    check("certificate", &read("certificate.html"), &head[..steps]);
    let html = |name: &str| std::fs::read_to_string(out.join(name)).unwrap();
    let unlisted = [("report.html", head), ("certificate.html", &head[..steps])].map(|(name, sentences)| {
        let lacking = without_table(sentences, &html(name));
        lacking.into_iter().map(move |what| format!("{name}: {what}"))
    });
    if let Some(text) = tool("pdftotext", &["-raw", "{}", "-"], &out.join("report.pdf")) {
        check("PDF", &text, &head[..steps]);
    }
    let bytes = std::fs::read(out.join("report.xlsx")).unwrap();
    let mut book = Xlsx::new(Cursor::new(bytes)).unwrap();
    let cells = book.worksheets().into_iter().flat_map(|(_, sheet)| {
        let texts: Vec<String> = sheet.used_cells().map(|(.., cell)| cell.to_string()).collect();
        texts
    });
    check("workbook", &cells.collect::<Vec<_>>().join("\n"), &head[..steps]);
    wrong.extend(unlisted.into_iter().flatten());
    wrong
}

/// Numbers of one quantity in several documents that differ.
fn apart(documents: &Documents) -> Vec<String> {
    let accuracy = documents.read("accuracy.json");
    let mut wrong = Vec::new();
    let mut same = |what: String, values: [Option<f64>; 2]| {
        let [a, b] = values.map(|v| v.unwrap_or(f64::NAN));
        let agree = (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
        if !agree {
            wrong.push(format!("{what}: {a} and {b}"));
        }
    };
    let last = accuracy["sets"].as_array().and_then(|sets| sets.last()).cloned().unwrap_or_default();
    for limit in documents.limits() {
        let name = limit["name"].as_str().unwrap();
        let Some((_, quantity, figure, _)) = ERRORS.iter().find(|(.., key)| *key == name) else { continue };
        let Some(e) = last["errors"].as_array().and_then(|all| all.iter().find(|e| e["quantity"] == *quantity)) else {
            continue;
        };
        same(format!("{name}, value"), [limit["value"].as_f64(), e["after"][*figure].as_f64()]);
        let u = limit["expanded_uncertainty"].as_f64();
        if *figure == "max" {
            same(format!("{name}, U"), [u, e["expanded_uncertainty"].as_f64()]);
        }
        let budget = match *quantity {
            "orientation" => accuracy["orientation_budget"]["standard_uncertainty_deg"].as_f64(),
            _ => {
                let of_figure =
                    |b: &&Value| b["figure"] == *figure && b["quantity"].as_str().unwrap_or("position") == *quantity;
                accuracy["budget"]
                    .as_array()
                    .and_then(|all| all.iter().find(of_figure)?["standard_uncertainty_mm"].as_f64())
            }
        };
        same(format!("{name}, U and budget"), [u, budget.map(|u| 2.0 * u)]);
    }
    let residuals = documents.read("parameters.json")["residuals"].clone();
    if residuals.is_object() {
        let [count, stated, determined] =
            ["count", "stated_values", "determined_parameters"].map(|key| number(&residuals[key]));
        let sum = (count + stated - determined).round();
        same("residuals".to_owned(), [Some(sum), residuals["degrees_of_freedom"].as_f64()]);
    }
    wrong
}

/// The report of `etalon uncertainty` has the errors of the run, with the same standard uncertainties, of every quantity that was measured.
#[test]
fn draws_are_reported_for_the_errors_of_the_run() {
    for sample in ["prexyt-cmm", "two-arms", "surfaces"] {
        let (scratch, _) = run_of(sample);
        let accuracy = Documents { folder: scratch.path().join("out") }.read("accuracy.json");
        let output = etalon(
            scratch.root(),
            &["uncertainty", "campaign", "--draws", "200", "--resamples", "0", "--json", "--report", "draws.html"],
        );
        assert!(output.status.success(), "{sample}: {}", text_of(&output));
        let found: Value = serde_json::from_slice(&output.stdout).unwrap();
        let page = squeezed(&page_text(&std::fs::read_to_string(scratch.root().join("draws.html")).unwrap()));
        let errors = found["errors"].as_array().unwrap();
        let last = accuracy["sets"].as_array().unwrap().last().unwrap()["errors"].as_array().unwrap().clone();
        let lengths: Vec<&Value> = last
            .iter()
            .filter(|e| e["unit"] == "mm" && !["x", "y", "z"].contains(&e["quantity"].as_str().unwrap()))
            .collect();
        assert_eq!(errors.len(), 3 * lengths.len(), "{sample}");
        for error in errors {
            let (name, quantity) = (error["name"].as_str().unwrap(), &error["quantity"]);
            let e = lengths.iter().find(|e| e["quantity"] == *quantity).unwrap();
            let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
            assert!(close(number(&error["value"]), number(&e["after"][name])), "{sample}: {error}, {e}");
            let of_figure = |b: &&Value| b["figure"] == name && b["quantity"] == *quantity;
            let budget = accuracy["budget"].as_array().unwrap().iter().find(of_figure).unwrap();
            assert!(
                close(number(&error["standard_uncertainty"]), number(&budget["standard_uncertainty_mm"])),
                "{error}"
            );
            // a reading that is measured again scatters at least as it is stated to
            let drawn = number(&error["standard_deviation"]);
            assert!(name != "max" || drawn > 0.8 * number(&error["standard_uncertainty"]), "{sample}: {error}");
            assert!(page.contains(quantity.as_str().unwrap()), "{sample}: {quantity}");
        }
        let draws = format!("{}MonteCarlodraws", found["draws"]);
        assert!(page.contains(&draws), "{sample}: {draws}");
    }
}
