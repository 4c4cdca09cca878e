//! Pages of the documentation: README.md, the book, and the README of each folder.

use super::root;
use std::path::{Path, PathBuf};

/// A block of a page: fenced, or indented by four columns.
#[derive(Debug)]
pub struct Block {
    /// Number of its first line, from 1.
    pub line: usize,
    /// Text after the fence; `None` of an indented block.
    pub info: Option<String>,
    pub text: String,
}

/// Returns all pages that people write; `docs/messages.md` is generated from the catalogue.
pub fn pages() -> Vec<PathBuf> {
    let mut found = Vec::new();
    for folder in [".", "docs", "samples", "python", "benches", "tests"] {
        walk(&root().join(folder), folder == ".", &mut found);
    }
    found.sort();
    found
}

fn walk(folder: &Path, alone: bool, found: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path()) {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            if !alone && name != "out" && !name.starts_with('.') {
                walk(&path, alone, found);
            }
        } else if name.ends_with(".md")
            && !["messages.md", "SUMMARY.md", "UPSTREAM.md"].contains(&name.as_str())
            && !is_part(&path)
        {
            found.push(path);
        }
    }
}

/// `true` for a part of `benches/README.md`, which repeats its text.
fn is_part(path: &Path) -> bool {
    path.parent().is_some_and(|folder| folder.ends_with("benches")) && !path.ends_with("README.md")
}

/// Returns the path of a page as messages of the tests name it.
pub fn shown(page: &Path) -> String {
    page.strip_prefix(root()).unwrap_or(page).display().to_string()
}

/// Returns the blocks of a page.
pub fn blocks(page: &str) -> Vec<Block> {
    let (mut all, mut open) = (Vec::new(), None::<Block>);
    let mut after_blank = true;
    for (at, line) in page.lines().enumerate() {
        let fence = line.trim_start().strip_prefix("```");
        open = match (open, fence) {
            (Some(block @ Block { info: Some(_), .. }), Some(_)) => {
                all.push(block);
                None
            }
            (Some(mut block @ Block { info: Some(_), .. }), None) => {
                block.text += &format!("{line}\n");
                Some(block)
            }
            (indented, Some(info)) => {
                all.extend(indented);
                Some(Block { line: at + 2, info: Some(info.to_owned()), text: String::new() })
            }
            (indented, None) => match (line.strip_prefix("    "), indented) {
                (Some(text), Some(mut block)) => {
                    block.text += &format!("{text}\n");
                    Some(block)
                }
                (Some(text), None) if after_blank => {
                    Some(Block { line: at + 1, info: None, text: format!("{text}\n") })
                }
                (None, Some(mut block)) if line.trim().is_empty() => {
                    block.text.push('\n');
                    Some(block)
                }
                (_, ended) => {
                    all.extend(ended);
                    None
                }
            },
        };
        after_blank = line.trim().is_empty();
    }
    let fenced = open.as_ref().is_some_and(|block| block.info.is_some());
    assert!(!fenced, "a block is not closed: {open:?}");
    all.extend(open);
    all
}

#[test]
fn blocks_are_fenced_or_indented() {
    let page = "Text\n    no block\n\n    a = 1\n\n    b = 2\nText\n\n```toml,file=x\nc = 3\n```\n- list\n\n  text\n";
    let found: Vec<_> = blocks(page).into_iter().map(|b| (b.line, b.info, b.text)).collect();
    let fenced = (10, Some("toml,file=x".to_owned()), "c = 3\n".to_owned());
    assert_eq!(found, [(4, None, "a = 1\n\nb = 2\n".to_owned()), fenced]);
}
