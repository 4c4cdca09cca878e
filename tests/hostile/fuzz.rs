//! Random damage to sound files of every format: no reader may panic, or take long. `ETALON_FUZZ_SECONDS` says for how long
//! each reader is run (a fraction of a second without it), `ETALON_FUZZ_SEED` the seed, and `ETALON_FUZZ_ONLY` which, by a part of its
//! name; the seed of a
//! run is printed with what failed.

use super::{logs, qif, readers};
use etalon::base::noise::Noise;
use etalon::campaign::Campaign;
use etalon::formats::Format;
use etalon::formats::dialect::Unit;
use etalon::formats::{labelled_points, propose, propose_file};
use etalon::stages::gather::gather;
use std::io::{Cursor, Write};
use std::time::{Duration, Instant};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive};

/// Pieces that formats give a meaning to, and numbers that break arithmetic.
const PIECES: [&str; 40] = [
    "\0",
    "\n",
    "\r\n",
    "\t",
    ",",
    ";",
    ":",
    " ",
    "\"",
    "'",
    "$",
    "$$",
    "#03:",
    "#12:",
    "#",
    "=",
    "/",
    "END",
    "EOF",
    "Name",
    "BEGIN OBJECT 0\n",
    "END OBJECT 0\n",
    "FA(",
    ")=FEAT/",
    "UNITS/INCH\n",
    "element vertex 4294967296\n",
    "property list uchar int x\n",
    "-1",
    "1e308",
    "1e-320",
    "-0",
    "nan",
    "inf",
    "9223372036854775808",
    "18446744073709551616",
    "1.5.5",
    "±",
    "\u{feff}",
    "\u{2212}",
    "é",
];

fn duration() -> Duration {
    let seconds = std::env::var("ETALON_FUZZ_SECONDS").ok().and_then(|s| s.parse().ok());
    Duration::from_secs_f64(seconds.unwrap_or(0.2))
}

/// A random number below a bound.
fn below(noise: &mut Noise, bound: usize) -> usize {
    (((noise.uniform(1.0) + 1.0) * 0.5 * bound as f64) as usize).min(bound.saturating_sub(1))
}

/// The text with some damage; characters stand for bytes where it is binary.
fn damaged(text: &str, other: &str, noise: &mut Noise) -> String {
    let mut all: Vec<char> = text.chars().collect();
    let other: Vec<char> = other.chars().collect();
    for _ in 0..1 + below(noise, 6) {
        let at = below(noise, all.len() + 1);
        let to = (at + below(noise, 20)).min(all.len());
        match below(noise, 8) {
            0 => drop(all.drain(at..to)),
            1 => all.truncate(at.max(1)),
            2 => {
                let piece: Vec<char> = all[at..to].to_vec();
                let to = below(noise, all.len() + 1);
                all.splice(to..to, piece);
            }
            3 if at < all.len() => all[at] = char::from(below(noise, 256) as u8),
            4 => {
                let from = below(noise, other.len() + 1);
                let piece = other[from..(from + 30).min(other.len())].to_vec();
                all.splice(at..to, piece);
            }
            5 if at < all.len() && all[at].is_ascii_digit() => all[at] = '9',
            _ => {
                let piece = PIECES[below(noise, PIECES.len())];
                all.splice(at..at, piece.chars());
            }
        }
    }
    all.into_iter().collect()
}

/// Runs a reader on damaged texts; a panic names the seed.
fn run(name: &str, texts: &[&String], read: impl Fn(&str)) {
    if std::env::var("ETALON_FUZZ_ONLY").is_ok_and(|only| !name.contains(&only)) {
        return;
    }
    let (start, mut runs) = (Instant::now(), 0u64);
    let seed = std::env::var("ETALON_FUZZ_SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(2026);
    while start.elapsed() < duration() {
        let mut noise = Noise::new(seed, runs);
        let text = damaged(texts[below(&mut noise, texts.len())], texts[below(&mut noise, texts.len())], &mut noise);
        let elapsed = || {
            let before = Instant::now();
            let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| read(&text)));
            assert!(outcome.is_ok(), "{name}: trial {runs} of seed {seed} panics on {text:?}");
            before.elapsed().as_secs_f64()
        };
        // a busy machine may make one reading slow, not several
        let slow = elapsed() > 1.0 && (0..5).all(|_| elapsed() > 1.0);
        assert!(!slow, "{name}: trial {runs} of seed {seed} takes over a second for {text:?}");
        runs += 1;
    }
    println!("{name}: {runs} damaged files in {:.1} s", start.elapsed().as_secs_f64());
}

#[test]
fn readers_of_points() {
    let mut samples: Vec<(String, String)> =
        readers::samples().into_iter().map(|(name, text)| (name.to_owned(), text)).collect();
    // and what our own writers make of a campaign, a part of it
    let written = crate::campaigns::dialects::written_exports();
    samples.extend(written.into_iter().map(|(name, text)| (name, text.chars().take(3000).collect())));
    for name in Format::names() {
        let mut own: Vec<&String> = samples.iter().filter(|(of, _)| *of == name).map(|(_, text)| text).collect();
        if own.is_empty() {
            own = samples.iter().map(|(_, text)| text).collect();
        }
        let format = Format::named(name).unwrap();
        run(name, &own, |text| drop(labelled_points("f.txt", text, &format, Unit::Millimetre)));
    }
}

#[test]
fn readers_of_logs() {
    for (stated, text) in logs::samples() {
        let scratch = logs::with_log(&text, &stated);
        let campaign = Campaign::read(&scratch.path()).unwrap();
        let path = scratch.path().join("encoders.csv");
        run(stated.lines().next().unwrap_or(""), &[&text], |text| {
            std::fs::write(&path, text).unwrap();
            drop(gather(&campaign));
        });
    }
}

#[test]
fn stated_dialects() {
    let written = crate::campaigns::dialects::written_dialects();
    let texts: Vec<&String> = written.iter().map(|(_, text)| text).collect();
    for (format, _) in &written {
        run(&format.to_string(), &texts, |text| drop(labelled_points("f.txt", text, format, Unit::Millimetre)));
    }
}

#[test]
fn proposals() {
    let own = readers::samples().into_iter().map(|(_, text)| text);
    let texts: Vec<String> =
        crate::campaigns::dialects::written_dialects().into_iter().map(|(_, text)| text).chain(own).collect();
    run("etalon formats", &texts.iter().collect::<Vec<_>>(), |text| drop(propose("f.txt", text)));
}

#[test]
fn measured_features() {
    let sound = qif::sound();
    run("QIF", &[&sound], |text| drop(etalon::formats::qif::read("f.qif", text, None)));
}

/// A workbook of these files; they are kept as they are.
fn packed(files: &[(String, String)]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    for (name, content) in files {
        zip.start_file(name, options).unwrap();
        zip.write_all(content.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

#[test]
fn workbooks() {
    let scratch = tempfile::tempdir().unwrap();
    let path = scratch.path().join("points.xlsx");
    for program in ["openpyxl", "libreoffice"] {
        let bytes = std::fs::read(crate::campaigns::workbooks::workbook(program)).unwrap();
        let mut zip = ZipArchive::new(Cursor::new(bytes)).unwrap();
        let names: Vec<String> = zip.file_names().map(|name| name.unwrap().into_owned()).collect();
        let mut unpacked = |name: &str| std::io::read_to_string(zip.by_name(name).unwrap()).unwrap();
        let files: Vec<(String, String)> = names.iter().map(|name| (name.clone(), unpacked(name))).collect();
        let proposed = |files: &[(String, String)]| {
            std::fs::write(&path, packed(files)).unwrap();
            propose_file(&path)
        };
        proposed(&files).unwrap();
        // one of its files at a time; how it looks is nowhere read
        let read = |name: &str| name.starts_with("xl/") && !name.contains("theme");
        for (damaged, (name, sound)) in files.iter().enumerate().filter(|(_, (name, _))| read(name)) {
            run(&format!("workbook of {program}, {name}"), &[sound], |text| {
                let mut files = files.clone();
                files[damaged].1 = text.to_owned();
                drop(proposed(&files));
            });
        }
    }
}
