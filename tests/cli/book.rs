//! The book: its commands run, its files are complete, its links lead somewhere, its paragraphs are short.

use crate::support::pages::blocks;
use crate::support::root;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Pages of a folder of the book.
fn pages(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join("docs").join(folder)).unwrap().flatten().map(|entry| entry.path());
    let mut pages: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.sort();
    pages
}

/// Fenced blocks of a page: what follows the fence, and the lines.
fn fenced(page: &str) -> Vec<(String, Vec<String>)> {
    let lines = |text: &str| text.lines().map(str::to_owned).collect();
    blocks(page).into_iter().filter_map(|block| Some((block.info?, lines(&block.text)))).collect()
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
    for part in ["samples", "python/examples"] {
        let copy = Command::new("cp").args(["-r", "--parents", part]).arg(folder.path()).current_dir(root()).status();
        assert!(copy.unwrap().success());
    }
    let program = Path::new(crate::support::program()).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let mut wrong = Vec::new();
    for (info, lines) in fenced(&fs::read_to_string(page).unwrap()) {
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
fn the_commands_of_learn_run() {
    let wrong: Vec<String> = pages("learn").iter().flat_map(|page| run(page)).collect();
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

/// Pages in the table of contents, in order, and the shelf of each.
fn contents() -> Vec<(String, String)> {
    let summary = fs::read_to_string(root().join("docs/SUMMARY.md")).unwrap();
    let mut shelf = String::new();
    let mut all = Vec::new();
    for line in summary.lines() {
        if let Some(title) = line.strip_prefix("# ") {
            title.clone_into(&mut shelf);
        }
        let name = line.split_once("](").and_then(|(_, rest)| rest.split(')').next());
        all.extend(name.map(|name| (name.to_owned(), shelf.clone())));
    }
    all
}

/// Folders of `docs` whose pages are in the book.
const FOLDERS: [&str; 4] = ["", "learn", "how-to", "explanation"];

/// Every page is in the table of contents, and every page in it exists. The generated page of messages is the last.
#[test]
fn the_table_of_contents_has_every_page() {
    let docs = root().join("docs");
    let contents = contents();
    let named: Vec<&str> = contents.iter().map(|(name, _)| name.as_str()).collect();
    let missing: Vec<&&str> = named.iter().filter(|name| !docs.join(name).is_file()).collect();
    assert!(missing.is_empty(), "{missing:?}");
    for page in FOLDERS.into_iter().flat_map(pages) {
        let name = page.strip_prefix(&docs).unwrap().display().to_string();
        assert!(name == "SUMMARY.md" || named.contains(&name.as_str()), "{name} is not in SUMMARY.md");
    }
    assert_eq!(named.last(), Some(&"messages.md"));
    let settings: toml::Table = fs::read_to_string(docs.join("book.toml")).unwrap().parse().unwrap();
    let search = &settings["output"]["html"]["search"]["chapter"]["messages.md"]["enable"];
    assert_eq!(search.as_bool(), Some(false), "the generated page fills the search index");
    let shelves: Vec<&str> = contents.iter().map(|(_, shelf)| shelf.as_str()).collect();
    assert_eq!(shelves.iter().filter(|shelf| **shelf == "Learn").count(), 6);
}

/// The page of decisions lists the file of each decision by its number.
#[test]
fn every_decision_is_listed() {
    let list = fs::read_to_string(root().join("docs/decisions.md")).unwrap();
    for page in pages("decisions") {
        let name = page.file_name().unwrap().to_string_lossy().into_owned();
        assert!(list.contains(&format!("\n| {} | ", &name[..4])), "{name} is not in docs/decisions.md");
    }
}

/// Text of a page, with the text of each page that the book includes in it.
fn with_included(page: &Path) -> String {
    let text = fs::read_to_string(page).unwrap();
    let included = text.split("{{#include ").skip(1).filter_map(|rest| rest.split("}}").next());
    let included = included.filter(|name| name.ends_with(".md")).map(|name| page.parent().unwrap().join(name));
    let included: String = included.map(|path| fs::read_to_string(path).unwrap()).collect();
    text + &included
}

/// Names of the headings of a page in links.
fn anchors(page: &str) -> Vec<String> {
    let prose: String = page.split("```").step_by(2).collect();
    let heading = |line: &str| line.starts_with('#').then(|| line.trim_start_matches('#').trim().to_lowercase());
    let kept = |c: &char| c.is_alphanumeric() || [' ', '-', '_'].contains(c);
    let name = |heading: String| heading.chars().filter(kept).collect::<String>().replace(' ', "-");
    prose.lines().filter_map(heading).map(name).collect()
}

/// Links lead to files and headings; links of the book lead to its pages and pictures, which the built book contains.
#[test]
fn links_lead_somewhere() {
    let (mut wrong, docs) = (Vec::new(), root().join("docs"));
    let named: Vec<PathBuf> = contents().iter().map(|(name, _)| docs.join(name)).collect();
    for page in crate::support::pages::pages() {
        let text = with_included(&page);
        let prose: String = text.split("```").step_by(2).collect();
        for target in prose.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            if target.contains("://") {
                continue;
            }
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let path = if file.is_empty() { page.clone() } else { page.parent().unwrap().join(file) };
            let Ok(path) = path.canonicalize() else {
                wrong.push(format!("{}: {target} does not exist", page.display()));
                continue;
            };
            let headings = || anchors(&fs::read_to_string(&path).unwrap());
            if !anchor.is_empty()
                && path.extension().is_some_and(|e| e == "md")
                && !headings().contains(&anchor.to_owned())
            {
                wrong.push(format!("{}: {target} has no such heading", page.display()));
            }
            let is_picture = path.extension().is_some_and(|e| ["svg", "png", "toml"].iter().any(|known| e == *known));
            if named.contains(&page) && !named.contains(&path) && !(is_picture && path.starts_with(&docs)) {
                wrong.push(format!("{}: {target} is not in the book", page.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Sources that pages name by their path exist.
#[test]
fn sources_named_in_prose_exist() {
    let (mut wrong, mut read) = (Vec::new(), 0);
    for page in crate::support::pages::pages() {
        let text = fs::read_to_string(&page).unwrap();
        let prose: String = text.split("```").step_by(2).collect();
        for path in prose.split('`').skip(1).step_by(2).filter(|code| code.starts_with("src/")) {
            // capitals and braces stand for a name
            if path.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || "/_.".contains(c)) {
                read += 1;
                if !root().join(path).exists() {
                    wrong.push(format!("{}: `{path}`", page.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(read >= 20, "{read} paths");
}

/// Words of a page outside its blocks.
fn words(page: &Path) -> usize {
    let text = fs::read_to_string(page).unwrap();
    let prose: String = text.split("```").step_by(2).collect::<Vec<_>>().join("\n");
    prose
        .split(|c: char| !(c.is_alphanumeric() || "-.'’_".contains(c)))
        .filter(|word| word.contains(char::is_alphanumeric))
        .count()
}

/// Pages that are generated: they are looked up, not read.
const GENERATED: [&str; 4] = ["benchmark.md", "functions.md", "messages.md", "options.md"];

/// Pages of tasks have 80 to 400 words. Pages for users, without the generated ones, have at most 54,000 words, with their blocks and
/// without the lines of tables.
#[test]
fn pages_are_short() {
    let long: Vec<_> = pages("how-to").into_iter().filter(|page| !(80..=400).contains(&words(page))).collect();
    assert!(long.is_empty(), "{long:?}");
    let for_users = contents().into_iter().filter(|(_, shelf)| shelf != "Develop").map(|(name, _)| name);
    let written = for_users.filter(|name| !GENERATED.contains(&name.as_str()));
    let count = |text: String| text.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count();
    let whole: usize = written.map(|name| count(with_included(&root().join("docs").join(name)))).sum();
    assert!(whole <= 54_000, "{whole} words");
}

/// A paragraph of a page to learn from, of a task or of an explanation has at most five lines, and README at most seventy.
#[test]
fn paragraphs_are_short() {
    for page in ["learn", "how-to", "explanation"].into_iter().flat_map(pages) {
        // every second part between fences is a block
        let text = fs::read_to_string(&page).unwrap();
        let prose: String = text.split("```").step_by(2).collect::<Vec<_>>().join("\n\n");
        let listed = |paragraph: &&str| paragraph.starts_with(['|', '-', '#']) || paragraph.starts_with("1. ");
        for paragraph in prose.split("\n\n").map(str::trim).filter(|paragraph| !listed(paragraph)) {
            assert!(paragraph.lines().count() <= 5, "{}:\n{paragraph}", page.display());
        }
    }
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.lines().count() <= 70, "README.md has {} lines", readme.lines().count());
}

/// Figures of the book are those that the script draws from numbers of this program; `ETALON_UPDATE=1` draws them again.
#[test]
fn figures_are_current() {
    let figures = root().join("docs/figures");
    let folder = tempfile::tempdir().unwrap();
    let to = if std::env::var_os("ETALON_UPDATE").is_some() { figures.as_path() } else { folder.path() };
    let mut python = Command::new("python3");
    let ended = python.arg(figures.join("draw.py")).arg(crate::support::program()).arg(to).output();
    let Ok(ended) = ended else { return crate::support::skipped("python3") };
    assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stderr));
    let drawn: Vec<PathBuf> = fs::read_dir(to).unwrap().flatten().map(|entry| entry.path()).collect();
    let drawn: Vec<&PathBuf> = drawn.iter().filter(|path| path.extension().is_some_and(|e| e == "svg")).collect();
    assert!(drawn.len() >= 12, "{drawn:?}");
    let gallery = fs::read_to_string(root().join("docs/gallery.md")).unwrap();
    for path in drawn {
        let name = path.file_name().unwrap().to_string_lossy();
        assert_eq!(fs::read_to_string(path).unwrap(), fs::read_to_string(figures.join(&*name)).unwrap(), "{name}");
        assert!(gallery.contains(&format!("(figures/{name})")), "{name} is not in the gallery");
    }
}
