//! `make thesis`: every table and result figure of the thesis for which its text gives enough, printed and ours side by side.
//!
//! `thesis [--draws N] [--out FOLDER] [--only TEXT] [--check]`: `--check` fails where an entry is not what the page expects of it.

#![allow(clippy::print_stderr)] // progress
#![allow(clippy::too_many_lines, clippy::type_complexity)] // printed values, table by table
#![allow(non_snake_case)] // export_T_world

mod campaigns;
mod chapter2;
mod chapter3;
mod chapter4;
mod page;
mod picture;

use page::{Entry, Head};
use std::path::PathBuf;
use std::time::Instant;

/// Draws of every synthetic result.
const DRAWS: u64 = 100;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let (mut draws, mut only, mut check) = (DRAWS, String::new(), false);
    let mut out = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("target/thesis");
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--draws" => draws = arguments.next().and_then(|n| n.parse().ok()).expect("--draws N"),
            "--only" => only = arguments.next().expect("--only TEXT"),
            "--out" => out = arguments.next().expect("--out FOLDER").into(),
            "--check" => check = true,
            _ => {} // `cargo bench` adds `--bench`
        }
    }
    let chapters = [chapter2::ALL, chapter3::ALL, chapter4::ALL].concat();
    let wanted: Vec<_> = chapters.into_iter().filter(|(name, _)| name.contains(&only)).collect();
    let begin = Instant::now();
    let mut entries: Vec<Entry> = Vec::new();
    for (i, (name, make)) in wanted.iter().enumerate() {
        eprintln!("[{}/{}, {:.0} s] {name}", i + 1, wanted.len(), begin.elapsed().as_secs_f64());
        entries.extend(make(draws));
    }
    let head = Head { draws, version: env!("CARGO_PKG_VERSION") };
    std::fs::create_dir_all(&out).expect("folder");
    for (name, text) in [("thesis.md", page::markdown(&entries, &head)), ("thesis.html", page::html(&entries, &head))] {
        std::fs::write(out.join(name), text).expect("page");
    }
    eprintln!("{:.0} s: {}", begin.elapsed().as_secs_f64(), out.join("thesis.html").display());
    let wrong: Vec<&str> = entries.iter().filter(|e| !e.as_expected()).map(|e| e.title).collect();
    if !wrong.is_empty() {
        eprintln!("not as expected: {}", wrong.join("; "));
        std::process::exit(i32::from(check));
    }
}
