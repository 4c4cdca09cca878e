//! The book: its commands run, its files are complete, its links lead somewhere, its paragraphs are short.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Pages of a folder of the book.
fn pages(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(Path::new(ROOT).join("docs").join(folder)).unwrap().flatten().map(|entry| entry.path());
    let mut pages: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.sort();
    pages
}

/// Fenced blocks of a page: what follows the fence, and the lines.
fn blocks(page: &str) -> Vec<(String, Vec<String>)> {
    let (mut all, mut open) = (Vec::new(), None::<(String, Vec<String>)>);
    for line in page.lines() {
        match (line.strip_prefix("```"), &mut open) {
            (Some(_), Some(_)) => all.extend(open.take()),
            (Some(info), None) => open = Some((info.to_owned(), Vec::new())),
            (None, Some((_, lines))) => lines.push(line.to_owned()),
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a block is not closed");
    all
}

/// Whether the lines show this text: `...` stands for any lines, and at the end of a line for its rest.
fn shows(expected: &[String], shown: &str) -> bool {
    let mut lines = shown.lines();
    expected.iter().filter(|line| *line != "...").all(|line| match line.strip_suffix("...") {
        Some(start) => lines.any(|shown| shown.starts_with(start)),
        None => lines.any(|shown| shown.trim_end() == line.trim_end()),
    })
}

/// Runs the commands of a page in a folder that has the samples.
fn run(page: &Path) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let samples = Path::new(ROOT).join("samples");
    let copied = Command::new("cp").args(["-r"]).arg(&samples).arg(folder.path()).status().unwrap();
    assert!(copied.success());
    let program = Path::new(crate::support::program()).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let mut wrong = Vec::new();
    for (info, lines) in blocks(&fs::read_to_string(page).unwrap()) {
        if let Some((_, file)) = info.split_once("file=") {
            fs::create_dir_all(folder.path().join(file).parent().unwrap()).unwrap();
            fs::write(folder.path().join(file), lines.join("\n") + "\n").unwrap();
        }
        if info != "console" {
            continue;
        }
        let starts: Vec<usize> = (0..lines.len()).filter(|&i| lines[i].starts_with("$ ")).collect();
        for (k, &start) in starts.iter().enumerate() {
            let expected = &lines[start + 1..starts.get(k + 1).copied().unwrap_or(lines.len())];
            let mut bash = Command::new("bash");
            bash.args(["-c", &format!("{{ {}\n}} 2>&1", &lines[start][2..])]).current_dir(folder.path());
            let ended = bash.env("PATH", &path).output().unwrap();
            let shown = String::from_utf8_lossy(&ended.stdout);
            if !ended.status.success() || !shows(expected, &shown) {
                wrong.push(format!("{}: {}\n{shown}", page.display(), lines[start]));
            }
        }
    }
    wrong
}

#[test]
fn the_commands_of_the_tutorial_run() {
    let wrong: Vec<String> = pages("tutorial").iter().flat_map(|page| run(page)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_commands_of_the_how_to_pages_run() {
    let wrong: Vec<String> = pages("how-to").iter().flat_map(|page| run(page)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn expected_lines_are_compared() {
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
    assert!(shows(&lines("...\nb\n..."), "a\nb\nc") && shows(&lines("alp..."), "alpha"));
    assert!(!shows(&lines("b\na"), "a\nb") && !shows(&lines("beta"), "alpha"));
}

/// Every page is in the table of contents, and every page in it exists.
#[test]
fn the_table_of_contents_has_every_page() {
    let docs = Path::new(ROOT).join("docs");
    let contents = fs::read_to_string(docs.join("SUMMARY.md")).unwrap();
    let named: Vec<&str> = contents.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    let missing: Vec<&&str> = named.iter().filter(|name| !docs.join(name).is_file()).collect();
    assert!(missing.is_empty(), "{missing:?}");
    for folder in ["", "tutorial", "how-to", "explanation"] {
        for page in pages(folder) {
            let name = page.strip_prefix(&docs).unwrap().display().to_string();
            assert!(name == "SUMMARY.md" || named.contains(&name.as_str()), "{name} is not in SUMMARY.md");
        }
    }
}

/// Links to files lead to files.
#[test]
fn links_lead_somewhere() {
    let mut wrong = Vec::new();
    let readme = PathBuf::from(ROOT).join("README.md");
    let all = ["", "tutorial", "how-to", "explanation"].into_iter().flat_map(pages).chain([readme]);
    for page in all {
        let text = fs::read_to_string(&page).unwrap();
        for target in text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next()) {
            if !target.is_empty() && !target.contains("://") && !page.parent().unwrap().join(target).exists() {
                wrong.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A paragraph of the tutorial, of a how-to page or of an explanation has at most five lines, and README at most seventy.
#[test]
fn paragraphs_are_short() {
    for page in ["tutorial", "how-to", "explanation"].into_iter().flat_map(pages) {
        // every second part between fences is a block
        let text = fs::read_to_string(&page).unwrap();
        let prose: String = text.split("```").step_by(2).collect::<Vec<_>>().join("\n\n");
        let listed = |paragraph: &&str| paragraph.starts_with(['|', '-', '#']) || paragraph.starts_with("1. ");
        for paragraph in prose.split("\n\n").map(str::trim).filter(|paragraph| !listed(paragraph)) {
            assert!(paragraph.lines().count() <= 5, "{}:\n{paragraph}", page.display());
        }
    }
    let readme = fs::read_to_string(Path::new(ROOT).join("README.md")).unwrap();
    assert!(readme.lines().count() <= 70, "README.md has {} lines", readme.lines().count());
}
