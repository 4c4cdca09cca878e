//! Who may know whom: the modules of `src`, read from every `crate::` and `super::` path of every file up to its tests.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A room and the rooms that its files may name; `cli` may name all.
const ROOMS: [(&str, &[&str]); 13] = [
    ("base", &[]),
    ("math", &["base"]),
    ("document", &["base", "math"]),
    ("iso9283", &["base", "math", "document"]),
    ("import", &["base", "math", "iso9283", "document"]),
    ("campaign", &["base", "math", "iso9283", "document", "import"]),
    ("stages", &["base", "math", "iso9283", "document", "import", "campaign"]),
    ("report", &["base", "document"]),
    ("export", &["base", "math", "document"]),
    ("compare", &["base", "math", "iso9283", "document"]),
    ("simulate", &["base", "math", "document", "import", "campaign", "stages"]),
    ("run", &["base", "math", "iso9283", "document", "import", "campaign", "stages", "report", "export"]),
    (
        "cli",
        &[
            "base", "math", "iso9283", "document", "import", "campaign", "stages", "report", "export", "compare",
            "simulate", "run",
        ],
    ),
];

/// A path that begins with `crate::`, and the line on which it is.
#[derive(Debug, PartialEq)]
struct Named {
    line: usize,
    path: String,
}

/// The text up to its tests, without comments; lines stay where they are.
fn code(text: &str) -> String {
    let end = text.find("#[cfg(test)]\nmod ").filter(|at| text[*at..].contains('{')).unwrap_or(text.len());
    let lines = text[..end].lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// All paths of the crate that the code of a module names, from `crate` or from `super`; those in braces are spelled out.
fn named(module: &str, code: &str) -> Vec<Named> {
    let mut all = Vec::new();
    for (at, start) in code.match_indices("crate::").chain(code.match_indices("super::")) {
        let before = &code[..at];
        // the second of `super::super::`, or the end of a longer word
        if before.ends_with("super::") || before.ends_with(|c: char| c.is_alphanumeric() || c == '_') {
            continue;
        }
        let (mut at, mut above) = (at, module);
        while code[at..].starts_with("super::") {
            above = above.rsplit_once("::").map_or("", |(above, _)| above);
            at += "super::".len();
        }
        if start == "crate::" {
            (at, above) = (at + start.len(), "");
        }
        let line = before.matches('\n').count() + 1;
        let whole = |path: String| if above.is_empty() { path } else { format!("{above}::{path}") };
        all.extend(spelled(&code[at..]).0.into_iter().map(|path| Named { line, path: whole(path) }));
    }
    all
}

/// The paths at the beginning of a text, and how much of it they take: `a::{b, c::d}` gives `a::b` and `a::c::d`.
fn spelled(text: &str) -> (Vec<String>, usize) {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let end = text.find(|c: char| !is_name(c) && c != ':').unwrap_or(text.len());
    let head = text[..end].trim_end_matches(':');
    if !text[end..].starts_with('{') || (end > 0 && !text[..end].ends_with("::")) {
        return (vec![head.to_owned()], head.len());
    }
    let (mut all, mut at) = (Vec::new(), end + 1);
    loop {
        at += text[at..].len() - text[at..].trim_start_matches([' ', '\n', ',']).len();
        if at >= text.len() || text[at..].starts_with('}') {
            return (all, at + 1);
        }
        let (paths, taken) = spelled(&text[at..]);
        let join = |path: String| if head.is_empty() { path } else { format!("{head}::{path}") };
        all.extend(paths.into_iter().map(join));
        at += taken;
        // ` as name`, `*`
        at += text[at..].find([',', '}']).unwrap_or(text.len() - at);
    }
}

/// Every file of `src` by the path of its module; files of tests alone are left out.
fn modules() -> BTreeMap<String, PathBuf> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap().flatten() {
            let path = entry.path();
            if path.is_dir() {
                walk(&path, found);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    walk(&src, &mut files);
    let module = |path: &Path| {
        let inside = path.strip_prefix(&src).unwrap().with_extension("");
        let names: Vec<String> = inside.iter().map(|n| n.to_string_lossy().into_owned()).collect();
        names.into_iter().filter(|n| n != "mod").collect::<Vec<_>>().join("::")
    };
    let tests_alone = |name: &str| {
        let (above, own) = name.rsplit_once("::").unwrap_or(("lib", name));
        let parent = files.iter().find(|f| module(f) == above).map(|f| std::fs::read_to_string(f).unwrap());
        parent.is_some_and(|text| text.contains(&format!("#[cfg(test)]\nmod {own};")))
    };
    let all = files.iter().map(|f| (module(f), f.clone()));
    all.filter(|(name, _)| !["lib", "main"].contains(&name.as_str()) && !tests_alone(name)).collect()
}

/// The file that a path leads to: the longest part of it that is a module.
fn target<'a>(modules: &'a BTreeMap<String, PathBuf>, path: &str) -> Option<&'a str> {
    let mut part = path;
    loop {
        if let Some((name, _)) = modules.get_key_value(part) {
            return Some(name);
        }
        part = part.rsplit_once("::")?.0;
    }
}

fn room(module: &str) -> &str {
    module.split("::").next().unwrap_or(module)
}

#[test]
fn every_file_names_only_rooms_that_its_own_may_know() {
    let modules = modules();
    let rooms: BTreeSet<&str> = modules.keys().map(|name| room(name)).collect();
    assert_eq!(rooms, ROOMS.iter().map(|(name, _)| *name).collect(), "the rooms of src");
    let mut wrong = String::new();
    for (module, file) in &modules {
        let allowed = ROOMS.iter().find(|(name, _)| *name == room(module)).unwrap().1;
        for Named { line, path } in named(module, &code(&std::fs::read_to_string(file).unwrap())) {
            let other = room(&path);
            if other != room(module) && !allowed.contains(&other) {
                let _ = writeln!(wrong, "{}:{line}: `{}` may not know `crate::{path}`", file.display(), room(module));
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn no_files_name_each_other_in_a_circle() {
    let modules = modules();
    let mut arrows: BTreeMap<&str, BTreeMap<&str, usize>> = BTreeMap::new();
    for (module, file) in &modules {
        for Named { line, path } in named(module, &code(&std::fs::read_to_string(file).unwrap())) {
            if let Some(other) = target(&modules, &path).filter(|other| other != module) {
                arrows.entry(module).or_default().entry(other).or_insert(line);
            }
        }
    }
    // what nobody in the rest names is taken away until nothing or circles are left
    let mut rest: BTreeSet<&str> = modules.keys().map(String::as_str).collect();
    loop {
        let out = |m: &&str| arrows.get(*m).is_some_and(|to| to.keys().any(|t| rest.contains(t)));
        let into = |m: &&str| arrows.iter().any(|(from, to)| rest.contains(from) && to.contains_key(*m));
        let kept: BTreeSet<&str> = rest.iter().copied().filter(|m| out(m) && into(m)).collect();
        if kept.len() == rest.len() {
            break;
        }
        rest = kept;
    }
    let mut circles = String::new();
    for from in &rest {
        for (to, line) in arrows[from].iter().filter(|(to, _)| rest.contains(*to)) {
            let _ = writeln!(circles, "{}:{line}: names `crate::{to}`", modules[*from].display());
        }
    }
    assert!(circles.is_empty(), "\n{circles}");
}

#[test]
fn paths_are_found_in_braces_and_not_in_comments() {
    let text = "use crate::a::{self, b::{C, D}, e};\n// crate::f\nfn g() { crate::h::i() }\nuse crate::{j, k::L};\n\
                use super::m::N;\nuse super::super::{o, p::Q};\n";
    let paths: Vec<(usize, String)> = named("x::y::z", &code(text)).into_iter().map(|n| (n.line, n.path)).collect();
    let mut expected =
        vec![(1, "a::self"), (1, "a::b::C"), (1, "a::b::D"), (1, "a::e"), (3, "h::i"), (4, "j"), (4, "k::L")];
    expected.extend([(5, "x::y::m::N"), (6, "x::o"), (6, "x::p::Q")]);
    assert_eq!(paths, expected.into_iter().map(|(line, path)| (line, path.to_owned())).collect::<Vec<_>>());
}
