//! Mutation by machine: statements and data of every sample are changed at random. No panic, no run without an end, and no result
//! that is wrong by more than three of its own standard uncertainties with exit code 0 and no warning.
//!
//! `ETALON_MUTANTS_SAMPLES` names other samples. `ETALON_MUTANTS` states how many of each kind are tried, `ETALON_MUTANTS_SEED` the seed, `ETALON_MUTANTS_ONLY` one mutant by its
//! number: `s17` of the statements, `d17` of the data. A sample whose data are not there is left out. `ETALON_MUTANTS_SECONDS` is for
//! seeds that nobody has tried: so long instead of so many, and what is wrong in silence is printed and fails nothing.

use crate::support::root;
use etalon::base::message::Problems;
use etalon::base::noise::Noise;
use etalon::campaign::Campaign;
use etalon::documents::{ErrorQuantity, PoseCharacteristic};
use etalon::report::Renderer;
use etalon::run::pipeline;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, mpsc};
use std::time::{Duration, Instant};

/// Mutants of each kind where the environment states no other number.
const COUNT: usize = 250;
const SEED: u64 = 16;
/// A run beyond this hangs: the samples take a second, on a busy machine several.
const LIMIT: Duration = Duration::from_secs(100);
/// Difference from which on a value is wrong, in standard uncertainties of the value and of the sample.
const WRONG: f64 = 3.0;
const SAMPLES: [&str; 7] =
    ["prexyt-cmm", "dextar", "prexyt-faroarm", "prexyt-geometric", "prexyt-repeatability", "pose-test", "abb-irb120"];
/// What a unit, a scale or a convention taken for another multiplies by.
const FACTORS: [f64; 10] = [
    10.0,
    0.1,
    1000.0,
    0.001,
    25.4,
    1.0 / 25.4,
    std::f64::consts::PI / 180.0,
    180.0 / std::f64::consts::PI,
    1.001,
    -1.0,
];

/// What no data can show: a part of the mutation, the results that it changes by their start, and why.
const UNSEEN: [(&str, &[&str], &str); 4] = [
    (
        "robot.toml: `d_mm",
        &["d_2"],
        "of the offsets along parallel axes only the sum is determined: the other is as stated",
    ),
    (
        "times 1.001000",
        &[""],
        "a scale of a whole column: gains and lengths take it up, and nothing shows which scale is true",
    ),
    (
        "visits.txt: column",
        &["RP of"],
        "a test of repeatability alone has no commanded positions: in a smaller scale of a column, less scatter is a better robot",
    ),
    (
        "more in column",
        &["x_o", "y_o", "phi", "base_"],
        "an offset of all points but some of the frame, which has no more of them than it needs: it is that of the base",
    ),
];

/// The files of a campaign by their names.
type Files = BTreeMap<String, String>;

struct Sample {
    name: String,
    files: Files,
    right: Outcome,
}

/// What a run gives.
#[derive(Clone, Debug)]
struct Outcome {
    /// Exit code 0, and not 1.
    met: bool,
    /// Warnings, numbers aside.
    warnings: BTreeSet<String>,
    results: BTreeMap<String, Figure>,
    /// Parameters that are held because they are not separately identifiable: their values, and those that take up what they are off.
    held: BTreeMap<String, (f64, Vec<String>)>,
}

/// A value with its standard uncertainty.
#[derive(Clone, Copy, Debug)]
struct Figure {
    value: f64,
    u: f64,
    /// degrees, which come round
    turns: bool,
}

/// A mutant, and what becomes of it.
struct Mutant {
    what: String,
    files: Files,
}

fn number(name: &str, otherwise: usize) -> usize {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

/// A random index below `bound`.
fn below(noise: &mut Noise, bound: usize) -> usize {
    (((noise.uniform(1.0) + 1.0) * 0.5 * bound as f64) as usize).min(bound.saturating_sub(1))
}

fn pick<T: Clone>(noise: &mut Noise, all: &[T]) -> Option<T> {
    (!all.is_empty()).then(|| all[below(noise, all.len())].clone())
}

/// The files of a sample; `None` where its data are outside and not there.
fn files(name: &str) -> Option<Files> {
    let folder = root().join("samples").join(name);
    let campaign = std::fs::read_to_string(folder.join("campaign.toml")).unwrap();
    let reference = std::env::var("ETALON_REFERENCE").ok();
    let outside = "$ETALON_REFERENCE/";
    if campaign.contains(outside) && reference.is_none() {
        return None;
    }
    let mut files = Files::from([("campaign.toml".to_owned(), campaign.replace(outside, ""))]);
    let robot = std::fs::read_to_string(folder.join("robot.toml")).unwrap_or_default();
    let quoted = |text: &str| text.split('"').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    for part in quoted(&campaign).iter().chain(&quoted(&robot)).filter(|part| part.contains('.')) {
        let inside = part.strip_prefix(outside);
        let path = match (inside, &reference) {
            (Some(inside), Some(reference)) => Path::new(reference).join(inside),
            _ => folder.join(part),
        };
        if let Ok(text) = std::fs::read_to_string(path) {
            files.insert(inside.unwrap_or(part.as_str()).to_owned(), text);
        }
    }
    Some(files)
}

/// Runs a campaign of these files; problems where it has no result.
fn run(files: &Files) -> Result<Outcome, Problems> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let found = pipeline::evaluate(&Campaign::read(folder.path())?)?;
    let numberless = |text: &str| text.chars().filter(|c| !c.is_ascii_digit()).collect::<String>();
    let (mut results, mut held) = (BTreeMap::new(), BTreeMap::new());
    for p in found.results.identified.iter().flat_map(|found| &found.parameters.parameters) {
        if let Some(u) = p.standard_uncertainty {
            results.insert(p.name.clone(), Figure { value: p.value, u, turns: p.unit == "deg" });
        }
        if !p.confounded_with.is_empty() {
            held.insert(p.name.clone(), (p.value, p.confounded_with.clone()));
        }
    }
    for set in found.results.identified.iter().flat_map(|found| &found.accuracy.sets) {
        // of errors in the plane or in space (GUM E.4.3)
        if let Some(errors) = set.error_statistics(ErrorQuantity::Position) {
            let value = errors.after.rms;
            let u = value / (2.0 * set.poses as f64).sqrt();
            results.insert(format!("root mean square error of {}", set.name), Figure { value, u, turns: false });
        }
    }
    for pose in found.results.tested.poses.iter().flat_map(|tested| &tested.poses) {
        for c in &PoseCharacteristic::ALL {
            let (Some(value), Some(interval)) = ((c.value)(pose), (c.interval)(pose)) else { continue };
            let u = (interval.high_mm - interval.low_mm) / 4.0;
            results.insert(format!("{} of pose {}", c.symbol, pose.pose), Figure { value, u, turns: false });
        }
    }
    let warnings = found.results.messages().map(|m| numberless(&m.what)).collect();
    // the report is made from whatever was found
    let renderer = Renderer::campaign(&found.results)?;
    Ok(Outcome { met: renderer.passes(), warnings, results, held })
}

impl Sample {
    fn all() -> Vec<Self> {
        let one = |name| {
            let files = files(name)?;
            let right = run(&files).unwrap_or_else(|problems| panic!("{name}: {problems}"));
            assert!(right.met, "{name}");
            Some(Self { name: name.to_owned(), files, right })
        };
        let stated = std::env::var("ETALON_MUTANTS_SAMPLES").ok();
        stated
            .as_deref()
            .map_or(SAMPLES.to_vec(), |names| names.split(' ').collect())
            .into_iter()
            .filter_map(one)
            .collect()
    }

    /// The worst of what is wrong in a result of the mutation `what` that passes in silence.
    fn wrong(&self, what: &str, found: &Outcome) -> Option<String> {
        if !found.met || !found.warnings.is_subset(&self.right.warnings) {
            return None;
        }
        // no data show the nominal value of a parameter that is not separately identifiable: others take up what it is off
        let stated_otherwise = |(name, (value, _)): &(&String, &(f64, Vec<String>))| {
            self.right.held.get(*name).is_none_or(|right| right.0 != *value)
        };
        let taken_up =
            |name: &String| found.held.iter().filter(stated_otherwise).any(|(_, (_, others))| others.contains(name));
        let ratio = |name: &String, right: &Figure| {
            let found = found.results.get(name).filter(|_| !taken_up(name))?;
            let mut off = found.value - right.value;
            if right.turns {
                off -= (off / 360.0).round() * 360.0;
            }
            Some(off.abs() / found.u.max(right.u).max(1e-12))
        };
        let unseen = |name: &str| {
            let hides = |(part, names, _): &(&str, &[&str], &str)| {
                what.contains(part) && names.iter().any(|start| name.starts_with(start))
            };
            UNSEEN.iter().any(hides)
        };
        let ratios = self.right.results.iter().filter_map(|(name, right)| Some((name, right, ratio(name, right)?)));
        let (name, right, ratio) =
            ratios.filter(|(name, ..)| !unseen(name.as_str())).max_by(|a, b| a.2.total_cmp(&b.2))?;
        let found = found.results[name];
        (ratio > WRONG).then(|| format!("{name} = {:.5}, not {:.5}, {ratio:.0} u", found.value, right.value))
    }
}

/// Mutant number `k` of the statements.
fn of_statements(samples: &[Sample], k: usize) -> Mutant {
    let mut noise = Noise::new(number("ETALON_MUTANTS_SEED", SEED as usize) as u64, 2 * k as u64);
    let sample = &samples[k % samples.len()];
    loop {
        let file = if below(&mut noise, 3) == 0 { "robot.toml" } else { "campaign.toml" };
        if let Some((how, text)) = statements::mutate(&sample.files[file], &mut noise)
            && text != sample.files[file]
        {
            let mut files = sample.files.clone();
            files.insert(file.to_owned(), text);
            return Mutant { what: format!("{}/{file}: {how}", sample.name), files };
        }
    }
}

/// Mutant number `k` of exports, logs and tables.
fn of_data(samples: &[Sample], k: usize) -> Mutant {
    let mut noise = Noise::new(number("ETALON_MUTANTS_SEED", SEED as usize) as u64, 2 * k as u64 + 1);
    let sample = &samples[k % samples.len()];
    let names: Vec<String> =
        sample.files.keys().filter(|name| !name.ends_with(".toml") && !name.ends_with(".urdf")).cloned().collect();
    loop {
        let file = pick(&mut noise, &names).unwrap();
        let mut files = sample.files.clone();
        let changed = match below(&mut noise, 20) {
            // two files exchanged
            0 => pick(&mut noise, &names).map(|other| {
                files.insert(file.clone(), sample.files[&other].clone());
                files.insert(other.clone(), sample.files[&file].clone());
                format!("exchanged with {other}")
            }),
            // the file of another campaign
            1 => {
                let other = &samples[below(&mut noise, samples.len())];
                other.files.get(&file).map(|text| {
                    files.insert(file.clone(), text.clone());
                    format!("that of {}", other.name)
                })
            }
            _ => data::mutate(&sample.files[&file], &mut noise).map(|(how, text)| {
                files.insert(file.clone(), text);
                how
            }),
        };
        if let Some(how) = changed.filter(|_| files != sample.files) {
            return Mutant { what: format!("{}/{file}: {how}", sample.name), files };
        }
    }
}

/// Runs a campaign in a thread of its own, which is given up at the limit. It waits for no other that the pool of threads is busy with.
fn run_within_limit(files: &Files) -> Result<Result<Outcome, Problems>, mpsc::RecvTimeoutError> {
    let (send, receive) = mpsc::channel();
    let files = files.clone();
    std::thread::spawn(move || {
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        drop(send.send(alone.install(|| run(&files))));
    });
    receive.recv_timeout(LIMIT)
}

/// Tries mutants on all cores, and prints a line for each that fails.
fn try_all(letter: char, make: fn(&[Sample], usize) -> Mutant) {
    let samples = Sample::all();
    let count = number("ETALON_MUTANTS", COUNT);
    let only = std::env::var("ETALON_MUTANTS_ONLY").ok().and_then(|only| only.strip_prefix(letter)?.parse().ok());
    let (next, failures) = (AtomicUsize::new(only.unwrap_or(0)), Mutex::new(Vec::new()));
    let counts: Mutex<BTreeMap<&str, usize>> = Mutex::default();
    let seconds = std::env::var("ETALON_MUTANTS_SECONDS").ok().and_then(|seconds| seconds.parse().ok());
    let (begun, budget) = (Instant::now(), seconds.map(Duration::from_secs));
    let end = only.map_or(if budget.is_some() { usize::MAX } else { count }, |only| only + 1);
    let work = || {
        loop {
            let k = next.fetch_add(1, Ordering::Relaxed);
            if k >= end || budget.is_some_and(|budget| begun.elapsed() > budget) {
                return;
            }
            let Mutant { what, files } = make(&samples, k);
            let sample = &samples[k % samples.len()];
            let (kind, failure) = match run_within_limit(&files) {
                Ok(Err(_)) => ("refused", None),
                Ok(Ok(found)) if !found.met => ("exit code 1", None),
                Ok(Ok(found)) if !found.warnings.is_subset(&sample.right.warnings) => ("warned", None),
                Ok(Ok(found)) => match sample.wrong(&what, &found) {
                    Some(wrong) => ("wrong in silence", Some(wrong)),
                    None => ("no wrong result", None),
                },
                Err(mpsc::RecvTimeoutError::Timeout) => ("hangs", Some(format!("no end within {LIMIT:?}"))),
                Err(mpsc::RecvTimeoutError::Disconnected) => ("panics", Some("panics".to_owned())),
            };
            *counts.lock().unwrap().entry(kind).or_default() += 1;
            if let Some(failure) = failure {
                println!("{letter}{k} {what}: {failure}");
                if budget.is_none() || kind != "wrong in silence" {
                    failures.lock().unwrap().push(format!("{letter}{k} {what}: {failure}"));
                }
            }
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    let mut failures = failures.into_inner().unwrap();
    failures.sort();
    let list = failures.iter().fold(String::new(), |mut all, line| {
        writeln!(all, "{line}").unwrap();
        all
    });
    let counts = counts.into_inner().unwrap();
    let (tried, seed) = (counts.values().sum::<usize>(), number("ETALON_MUTANTS_SEED", SEED as usize));
    println!("{tried} mutants, seed {seed}: {counts:?}\n{list}");
    assert!(failures.is_empty(), "{} failed", failures.len());
}

#[test]
#[ignore = "a long law: make laws"]
fn no_mutant_of_statements_passes_with_a_wrong_result() {
    try_all('s', of_statements);
}

#[test]
#[ignore = "a long law: make laws"]
fn no_mutant_of_data_passes_with_a_wrong_result() {
    try_all('d', of_data);
}

/// The text with another at a place.
fn with(text: &str, place: std::ops::Range<usize>, other: &str) -> String {
    format!("{}{other}{}", &text[..place.start], &text[place.end..])
}

/// Places of numbers in a text.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let bytes = text.as_bytes();
    let (mut all, mut i) = (Vec::new(), 0);
    while i < bytes.len() {
        let start = i;
        let word = |b: u8| b.is_ascii_alphanumeric() || b == b'_';
        if matches!(bytes[i], b'-' | b'+') {
            i += 1;
        }
        let digits = i;
        while i < bytes.len() && (bytes[i].is_ascii_digit() || bytes[i] == b'.') {
            i += 1;
        }
        let apart = (start == 0 || !word(bytes[start - 1])) && bytes.get(i).is_none_or(|b| !word(*b));
        if i > digits && bytes[digits].is_ascii_digit() && apart && text[start..i].parse::<f64>().is_ok() {
            all.push(start..i);
        } else if i == digits {
            i = start + 1;
        }
    }
    all
}

/// A number changed as one is in the hands of people; how, and the new text.
fn other_number(text: &str, noise: &mut Noise) -> (String, String) {
    let digits: Vec<usize> = text.bytes().enumerate().filter(|(_, b)| b.is_ascii_digit()).map(|(i, _)| i).collect();
    match below(noise, 3) {
        0 => {
            let at = digits[below(noise, digits.len())];
            let digit = below(noise, 10).to_string();
            let other = with(text, at..at + 1, &digit);
            (format!("{text} -> {other}"), other)
        }
        _ => {
            let factor = FACTORS[below(noise, FACTORS.len())];
            let decimals = text.split_once('.').map_or(0, |(_, after)| after.len());
            let value = text.parse::<f64>().unwrap() * factor;
            let other = if value.fract() == 0.0 && decimals == 0 { format!("{value}") } else { format!("{value:.6}") };
            (format!("{text} -> {other}"), other)
        }
    }
}

/// Mutants of campaign.toml and robot.toml.
mod statements {
    use super::{below, numbers, other_number, pick, with};
    use etalon::base::noise::Noise;

    /// Words of one kind, each taken for another.
    const WORDS: [&[&str]; 10] = [
        &["\"mm\"", "\"m\"", "\"in\"", "\"um\""],
        &["_mm", "_m", "_um", "_deg", "_rad"],
        &["x_axis", "y_axis"],
        &["\"targets\"", "\"pose\""],
        &["\"label\"", "\"row\"", "\"pose\"", "[\"pose\", \"cycle\"]"],
        &["\"polyworks\"", "\"spatialanalyzer\""],
        &["_mm", "_deg"],
        &["max", "mean", "rms"],
        &["\"prexyt\"", "\"five_bar\"", "\"serial\""],
        &["\".\"", "\",\""],
    ];

    /// Lines that state something, by their index, without what only names the campaign.
    fn lines(text: &str) -> Vec<usize> {
        let prose = ["#", "name", "synthetic", "date", "deviations", "robot =", "controller", "environment", "title"];
        let states = |line: &str| !line.trim().is_empty() && !prose.iter().any(|p| line.trim_start().starts_with(p));
        text.lines().enumerate().filter(|(_, line)| states(line)).map(|(i, _)| i).collect()
    }

    fn joined(lines: &[String]) -> String {
        lines.iter().map(|line| format!("{line}\n")).collect()
    }

    /// A line dropped, doubled, renamed, or with the value of another.
    fn of_keys(kind: usize, text: &str, all: &mut Vec<String>, i: usize, noise: &mut Noise) -> Option<String> {
        let line = all[i].split('#').next()?.to_owned();
        Some(match kind {
            0 => {
                all.remove(i);
                format!("without `{line}`")
            }
            1 => {
                all.insert(i, line.clone());
                format!("twice `{line}`")
            }
            2 => {
                let (key, value) = line.split_once(" = ")?;
                let letters: Vec<char> = key.chars().collect();
                let at = below(noise, letters.len().max(2) - 1);
                let mut other = letters.clone();
                match below(noise, 2) {
                    0 => drop(other.remove(at)),
                    _ if at + 1 < other.len() => other.swap(at, at + 1),
                    _ => return None,
                }
                let other: String = other.into_iter().collect();
                all[i] = format!("{other} = {value}");
                format!("`{key}` renamed `{other}`")
            }
            // the keys of two lines exchanged
            _ => {
                let j = pick(noise, &lines(text))?;
                let (here, there) = (line.split_once(" = ")?, all[j].split_once(" = ")?);
                let (a, b) = (format!("{} = {}", there.0, here.1), format!("{} = {}", here.0, there.1));
                let how = format!("the values of `{}` and `{}` exchanged", here.0, there.0);
                (all[i], all[j]) = (a, b);
                how
            }
        })
    }

    /// A changed text and how it differs; `None` where the change does not apply.
    pub fn mutate(text: &str, noise: &mut Noise) -> Option<(String, String)> {
        let mut all: Vec<String> = text.lines().map(str::to_owned).collect();
        let i = pick(noise, &lines(text))?;
        let (line, comment) = match all[i].split_once('#') {
            Some((line, comment)) => (line.to_owned(), format!("#{comment}")),
            None => (all[i].clone(), String::new()),
        };
        let how = match below(noise, 16) {
            kind @ 0..4 => of_keys(kind, text, &mut all, i, noise)?,
            4 | 5 => {
                let words = WORDS[below(noise, WORDS.len())];
                let from = pick(noise, words)?;
                let to = pick(noise, words)?;
                let at = line.find(from)?;
                all[i] = with(&line, at..at + from.len(), to) + &comment;
                format!("`{line}` -> `{}`", all[i])
            }
            // two texts of the file exchanged
            6 | 7 => {
                let texts = |line: &str| line.split('"').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
                let j = pick(noise, &lines(text))?;
                let (a, b) = (pick(noise, &texts(&line))?, pick(noise, &texts(&all[j]))?);
                let (qa, qb) = (format!("\"{a}\""), format!("\"{b}\""));
                if i == j {
                    all[i] = line.replacen(&qa, "\"\0\"", 1).replacen(&qb, &qa, 1).replacen("\"\0\"", &qb, 1);
                } else {
                    all[j] = all[j].replacen(&qb, &qa, 1);
                    all[i] = all[i].replacen(&qa, &qb, 1);
                }
                format!("`{a}` and `{b}` exchanged in `{line}`")
            }
            // two numbers exchanged
            8 | 9 => {
                let j = pick(noise, &lines(text))?;
                let (p, q) = (pick(noise, &numbers(&line))?, pick(noise, &numbers(&all[j]))?);
                if i == j {
                    return None;
                }
                let (a, b) = (line[p.clone()].to_owned(), all[j][q.clone()].to_owned());
                let how = format!("{a} of `{line}` and {b} of `{}` exchanged", all[j]);
                all[j] = with(&all[j], q, &a);
                all[i] = with(&line, p, &b) + &comment;
                how
            }
            10 => {
                let p = pick(noise, &numbers(&line))?;
                all[i] = with(&line, p.clone(), &line[p].replace('.', ",")) + &comment;
                format!("`{line}` -> `{}`", all[i])
            }
            _ => {
                let p = pick(noise, &numbers(&line))?;
                let (_, other) = other_number(&line[p.clone()], noise);
                all[i] = with(&line, p, &other) + &comment;
                format!("`{line}` -> `{}`", all[i])
            }
        };
        Some((how, joined(&all)))
    }
}

/// Mutants of exports, logs and tables.
mod data {
    use super::{FACTORS, below, other_number, pick};
    use etalon::base::noise::Noise;

    /// A table of a text: what separates its cells, and the rows that hold numbers.
    struct Table {
        separator: &'static str,
        rows: Vec<Vec<String>>,
        /// Indices of the rows of data.
        data: Vec<usize>,
    }

    impl Table {
        fn of(text: &str) -> Self {
            let separator = if text.contains(',') { "," } else { " " };
            let rows: Vec<Vec<String>> = text
                .lines()
                .map(|line| {
                    let cells = line.split(separator).map(str::to_owned);
                    if separator == " " { cells.filter(|c| !c.trim().is_empty()).collect() } else { cells.collect() }
                })
                .collect();
            let is_data = |row: &&Vec<String>| row.iter().filter(|cell| is_number(cell)).count() > 1;
            let data = rows.iter().enumerate().filter(|(_, row)| is_data(row)).map(|(i, _)| i).collect();
            Self { separator, rows, data }
        }

        /// Columns that hold a number in every row of data; `measured` those with decimals.
        fn columns(&self, measured: bool) -> Vec<usize> {
            let width = self.data.iter().map(|&i| self.rows[i].len()).min().unwrap_or(0);
            let fits = |&k: &usize| {
                let mut cells = self.data.iter().map(|&i| &self.rows[i][k]);
                let decimals = self.data.iter().any(|&i| self.rows[i][k].contains('.'));
                cells.all(|cell| is_number(cell)) && (decimals || !measured)
            };
            (0..width).filter(fits).collect()
        }

        fn text(&self) -> String {
            self.rows.iter().map(|row| row.join(self.separator) + "\n").collect()
        }

        /// A row by its number in the file.
        fn shown(&self, i: usize) -> String {
            format!("row {} `{}`", i + 1, self.rows[i].join(self.separator))
        }
    }

    fn is_number(cell: &str) -> bool {
        cell.trim().parse::<f64>().is_ok()
    }

    fn scaled(cell: &str, factor: f64) -> String {
        cell.trim().parse::<f64>().map_or_else(|_| cell.to_owned(), |value| format!("{:.6}", value * factor))
    }

    /// A changed text and how it differs; `None` where the change does not apply.
    pub fn mutate(text: &str, noise: &mut Noise) -> Option<(String, String)> {
        let mut table = Table::of(text);
        let how = if below(noise, 2) == 0 { of_rows(&mut table, noise)? } else { of_columns(&mut table, noise)? };
        Some((how, table.text()))
    }

    fn of_rows(table: &mut Table, noise: &mut Noise) -> Option<String> {
        let i = pick(noise, &table.data)?;
        let j = pick(noise, &table.data).filter(|j| *j != i)?;
        let measured = table.columns(true);
        let shown = table.shown(i);
        Some(match below(noise, 9) {
            0 => {
                table.rows.remove(i);
                format!("without {shown}")
            }
            1 => {
                let row = table.rows[i].clone();
                table.rows.insert(i, row);
                format!("twice {shown}")
            }
            2 => {
                let row = table.rows[i].clone();
                table.rows[j] = row;
                format!("row {} is {shown}", j + 1)
            }
            // a stale row: the values of the row before
            3 => {
                let before = *table.data.iter().rev().find(|k| **k < i)?;
                for &k in &measured {
                    table.rows[i][k] = table.rows[before][k].clone();
                }
                format!("{shown} with the values of the row before")
            }
            // the labels of two rows exchanged
            4 => {
                let (here, there) = (table.rows[i].clone(), table.rows[j].clone());
                for &k in &measured {
                    (table.rows[i][k], table.rows[j][k]) = (there[k].clone(), here[k].clone());
                }
                format!("the values of {shown} and row {} exchanged", j + 1)
            }
            5 => {
                table.rows.swap(i, j);
                format!("{shown} and row {} exchanged", j + 1)
            }
            6 => {
                let (k, l) = (pick(noise, &measured)?, pick(noise, &measured)?);
                let (a, b) = (table.rows[i][k].clone(), table.rows[j][l].clone());
                (table.rows[i][k], table.rows[j][l]) = (b.clone(), a.clone());
                format!("{a} in {shown} and {b} in row {} exchanged", j + 1)
            }
            7 => {
                table.rows.truncate(i);
                format!("cut before {shown}")
            }
            _ => {
                let k = below(noise, table.rows[i].len());
                if !is_number(&table.rows[i][k]) {
                    return None;
                }
                let (how, other) = other_number(table.rows[i][k].trim(), noise);
                table.rows[i][k] = other;
                format!("{how} in {shown}")
            }
        })
    }

    fn of_columns(table: &mut Table, noise: &mut Noise) -> Option<String> {
        let measured = table.columns(true);
        let (k, l) = (pick(noise, &table.columns(false))?, pick(noise, &table.columns(false))?);
        let m = pick(noise, &measured)?;
        let data = table.data.clone();
        let first = pick(noise, &data)?;
        let factor = FACTORS[below(noise, FACTORS.len())];
        Some(match below(noise, 7) {
            0 if k != l => {
                data.iter().for_each(|&i| table.rows[i].swap(k, l));
                format!("columns {} and {} exchanged", k + 1, l + 1)
            }
            1 => {
                table.rows.iter_mut().filter(|row| row.len() > k).for_each(|row| drop(row.remove(k)));
                format!("without column {}", k + 1)
            }
            2 => {
                data.iter().for_each(|&i| table.rows[i][m] = scaled(&table.rows[i][m], factor));
                format!("column {} times {factor:.6}", m + 1)
            }
            3 => {
                for &i in &data {
                    measured.iter().for_each(|&m| table.rows[i][m] = scaled(&table.rows[i][m], factor));
                }
                format!("columns {measured:?} times {factor:.6}")
            }
            4 => {
                for row in &mut table.rows {
                    row.iter_mut().for_each(|cell| *cell = cell.replace('.', ","));
                }
                "decimal comma".to_owned()
            }
            // moved half way
            5 => {
                let by = [0.01, 0.1, 1.0, 10.0][below(noise, 4)];
                for &i in data.iter().filter(|i| **i >= first) {
                    let value: f64 = table.rows[i][m].trim().parse().ok()?;
                    table.rows[i][m] = format!("{:.6}", value + by);
                }
                format!("{by} more in column {} from row {} on", m + 1, first + 1)
            }
            // shifted by a row
            6 => {
                for pair in data.windows(2).rev() {
                    table.rows[pair[1]][m] = table.rows[pair[0]][m].clone();
                }
                format!("column {} shifted by a row", m + 1)
            }
            _ => return None,
        })
    }
}
