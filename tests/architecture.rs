//! The walls: which crate may depend on which (cargo's own metadata against the table of docs/architecture.md), and no circle
//! among the files of a crate.

use crate::support::root;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Crates of pure mathematics, and external crates that they must not depend on.
const PURE: [&str; 5] = ["math", "fit", "robots", "identify", "standards"];
const IMPURE: [&str; 9] =
    ["serde", "serde_json", "schemars", "toml", "polars", "polars-io", "csv", "clap", "quick-xml"];

/// Derives of schemas: with an effect in tests, without one in the program.
const SCHEMAS: [&str; 2] = ["schemars", "etalon-schemaless"];

/// Modules of the root package, from below: each may name those before it.
const PROGRAM: [&str; 6] = ["stages", "simulate", "run", "tasks", "session", "cli"];

/// Rows of the table of crates in docs/architecture.md: name, dependencies inside the workspace, external ones.
fn table() -> BTreeMap<String, [BTreeSet<String>; 2]> {
    let page = std::fs::read_to_string(root().join("docs/architecture.md")).unwrap();
    let rows = page.lines().skip_while(|line| !line.starts_with("| crate |")).skip(2);
    let names = |cell: &str| {
        cell.split(',')
            .map(|name| name.trim().trim_matches('`').to_owned())
            .filter(|n| !n.is_empty() && n != "-")
            .collect()
    };
    let rows = rows.take_while(|line| line.starts_with('|')).map(|line| {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        (cells[0].trim_matches('`').to_owned(), [names(cells[2]), names(cells[3])])
    });
    rows.collect()
}

/// Dependencies of every crate of the workspace, inside the workspace and external, without dependencies of tests.
fn dependencies() -> BTreeMap<String, [BTreeSet<String>; 2]> {
    let mut found = BTreeMap::new();
    for package in packages() {
        let mut dependencies = [BTreeSet::new(), BTreeSet::new()];
        for dependency in package["dependencies"].as_array().unwrap().iter().filter(|d| d["kind"].is_null()) {
            let name = dependency["name"].as_str().unwrap();
            if !SCHEMAS.contains(&name) {
                dependencies[usize::from(!name.starts_with("etalon-"))].insert(name.to_owned());
            }
        }
        let name = package["name"].as_str().unwrap();
        if !SCHEMAS.contains(&name) {
            found.insert(name.to_owned(), dependencies);
        }
    }
    found
}

/// Packages of the workspace, as cargo states them.
fn packages() -> Vec<serde_json::Value> {
    let metadata = Command::new(env!("CARGO"))
        .args(["metadata", "--locked", "--offline", "--no-deps", "--format-version", "1"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(metadata.status.success(), "{}", String::from_utf8_lossy(&metadata.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&metadata.stdout).unwrap();
    metadata["packages"].as_array().unwrap().clone()
}

/// The program derives no schema: only the feature `schemas`, which no other feature contains, brings `schemars`.
#[test]
fn the_program_derives_no_schema() {
    for package in packages() {
        let name = package["name"].as_str().unwrap();
        for dependency in package["dependencies"].as_array().unwrap().iter().filter(|d| d["name"] == "schemars") {
            assert_eq!(dependency["optional"], true, "{name}");
        }
        for (feature, brought) in package["features"].as_object().unwrap().iter().filter(|(name, _)| *name != "schemas")
        {
            assert!(!brought.to_string().contains("schema"), "{name}: {feature}");
        }
    }
}

#[test]
fn crates_depend_on_what_the_table_of_the_architecture_states() {
    let short = |name: String| name.strip_prefix("etalon-").unwrap_or(&name).to_owned();
    let shortened = |names: BTreeSet<String>| names.into_iter().map(short).collect::<BTreeSet<_>>();
    let found: BTreeMap<_, _> =
        dependencies().into_iter().map(|(name, both)| (short(name), both.map(shortened))).collect();
    let stated = table();
    let mut wrong = String::new();
    for name in found.keys().chain(stated.keys()).collect::<BTreeSet<_>>() {
        if found.get(name) != stated.get(name) {
            let _ =
                writeln!(wrong, "{name}: cargo {:?}\n    docs/architecture.md {:?}", found.get(name), stated.get(name));
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    for pure in PURE {
        let impure: Vec<&str> = IMPURE.into_iter().filter(|name| found[pure][1].contains(*name)).collect();
        assert!(impure.is_empty(), "`{pure}` is pure mathematics and depends on {impure:?}");
    }
}

/// The module is built with a lock of its own, which has to follow the dependencies of the crates:
/// otherwise `make python` ends before it compiles anything.
#[test]
fn the_lock_of_the_python_module_follows_the_crates() {
    let lock = std::fs::read_to_string(root().join("python/Cargo.lock")).unwrap();
    let lock: toml::Table = toml::from_str(&lock).unwrap();
    let name = |value: &toml::Value| value.as_str().unwrap().split(' ').next().unwrap().to_owned();
    let packages = lock["package"].as_array().unwrap().iter();
    let locked: BTreeMap<String, BTreeSet<String>> = packages
        .map(|package| {
            let stated = package.get("dependencies").and_then(toml::Value::as_array);
            (name(&package["name"]), stated.into_iter().flatten().map(name).collect())
        })
        .collect();
    let mut wrong = String::new();
    for (package, stated) in dependencies() {
        let has = |name: &&String| locked.get(&package).is_some_and(|names| names.contains(*name));
        let missing: Vec<&String> = stated.iter().flatten().filter(|name| !has(name)).collect();
        if !missing.is_empty() {
            let _ = writeln!(wrong, "{package}: {missing:?}");
        }
    }
    assert!(wrong.is_empty(), "run `cargo metadata --manifest-path python/Cargo.toml`: it lacks\n{wrong}");
}

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

/// The folders of the crates in `src`, and `src` itself for the program.
pub fn crates() -> Vec<PathBuf> {
    let src = root().join("src");
    let folders = std::fs::read_dir(&src).unwrap().flatten().map(|entry| entry.path());
    folders.filter(|path| path.join("Cargo.toml").exists()).chain([src.clone()]).collect()
}

/// Every file of a crate by the path of its module; files of tests alone are left out.
pub fn modules(root: &Path) -> BTreeMap<String, PathBuf> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap().flatten() {
            let path = entry.path();
            if path.is_dir() && !path.join("Cargo.toml").exists() {
                walk(&path, found);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    let mut files = Vec::new();
    walk(root, &mut files);
    let module = |path: &Path| {
        let inside = path.strip_prefix(root).unwrap().with_extension("");
        let names: Vec<String> = inside.iter().map(|n| n.to_string_lossy().into_owned()).collect();
        names.into_iter().filter(|n| n != "mod").collect::<Vec<_>>().join("::")
    };
    let tests_alone = |name: &str| {
        let (above, own) = name.rsplit_once("::").unwrap_or(("lib", name));
        let parent = files.iter().find(|f| module(f) == above).map(|f| std::fs::read_to_string(f).unwrap());
        parent.is_some_and(|text| text.contains(&format!("#[cfg(test)]\nmod {own};")))
    };
    let all = files.iter().map(|f| (module(f), f.clone()));
    let named = all.filter(|(name, _)| name != "main" && !tests_alone(name));
    named.filter(|(name, _)| !name.split("::").any(|part| part == "tests")).collect()
}

/// The file that a path leads to: the longest part of it that is a module, or a module of a group that its folder re-exports.
fn target<'a>(modules: &'a BTreeMap<String, PathBuf>, path: &str) -> Option<&'a str> {
    let mut part = path;
    loop {
        if let Some((name, _)) = modules.get_key_value(part) {
            return Some(name);
        }
        if let Some(name) = re_exported(modules, part) {
            return Some(name);
        }
        part = part.rsplit_once("::")?.0;
    }
}

/// The module `above::group::own` of a path `above::own`, if the file of `above` contains `use group::own`.
fn re_exported<'a>(modules: &'a BTreeMap<String, PathBuf>, path: &str) -> Option<&'a str> {
    let (above, own) = path.rsplit_once("::").unwrap_or(("", path));
    let text = std::fs::read_to_string(modules.get(if above.is_empty() { "lib" } else { above })?).ok()?;
    let group = |name: &str| {
        let inside = if above.is_empty() { name } else { name.strip_prefix(above)?.strip_prefix("::")? };
        let (group, last) = inside.split_once("::")?;
        (last == own).then(|| group.to_owned())
    };
    let uses = |group: String| {
        text.split(&format!("use {group}::"))
            .skip(1)
            .filter_map(|rest| rest.split(';').next())
            .any(|names| names.split(|c: char| !c.is_alphanumeric() && c != '_').any(|name| name == own))
    };
    modules.keys().find(|name| group(name).is_some_and(uses)).map(String::as_str)
}

#[test]
fn the_modules_of_the_program_name_those_below_them() {
    let place = |name: &str| PROGRAM.iter().position(|module| *module == name.split("::").next().unwrap_or(name));
    let mut wrong = String::new();
    for (module, file) in modules(&root().join("src")).iter().filter(|(name, _)| *name != "lib") {
        let own = place(module).unwrap_or_else(|| panic!("`{module}` is not in the table of the program's modules"));
        for Named { line, path } in named(module, &code(&std::fs::read_to_string(file).unwrap())) {
            if place(&path).is_some_and(|other| other > own) {
                let _ = writeln!(wrong, "{}:{line}: `{}` may not name `crate::{path}`", file.display(), PROGRAM[own]);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// Folders that contain one kind of thing, a file each.
const ONE_A_FILE: [&str; 8] =
    ["cli", "controllers", "documents", "formats/exports", "formats/logs", "report/plots", "report/sections", "tasks"];

#[test]
fn folders_are_short() {
    fn count(folder: &Path, found: &mut BTreeMap<String, usize>) {
        let entries: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        let files = entries.iter().filter(|path| path.extension().is_some_and(|extension| extension == "rs")).count();
        found.insert(folder.strip_prefix(root().join("src")).unwrap().display().to_string(), files);
        let folders = entries.iter().filter(|path| path.is_dir() && !path.ends_with("view/page"));
        folders.for_each(|path| count(path, found));
    }
    let mut found = BTreeMap::new();
    count(&root().join("src"), &mut found);
    let long: Vec<_> = found.into_iter().filter(|(_, files)| *files > 12).map(|(folder, _)| folder).collect();
    assert_eq!(long, ONE_A_FILE);
}

#[test]
fn no_files_of_a_crate_name_each_other_in_a_circle() {
    let circles: String = crates().iter().map(|root| circles(&modules(root))).collect();
    assert!(circles.is_empty(), "\n{circles}");
}

/// The arrows among modules that lie on a circle, one a line.
fn circles(modules: &BTreeMap<String, PathBuf>) -> String {
    let mut arrows: BTreeMap<&str, BTreeMap<&str, usize>> = BTreeMap::new();
    for (module, file) in modules.iter().filter(|(name, _)| *name != "lib") {
        for Named { line, path } in named(module, &code(&std::fs::read_to_string(file).unwrap())) {
            if let Some(other) = target(modules, &path).filter(|other| other != module) {
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
    circles
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

#[test]
fn modules_of_a_group_are_found_where_they_are_re_exported() {
    let modules = modules(&root().join("src/base"));
    assert_eq!(target(&modules, "message::Problems"), Some("text::message"));
    assert_eq!(target(&modules, "date::Date"), Some("date"));
    assert_eq!(target(&modules, "no_module"), None);
}

/// A function is a verb or the noun that it returns: `of`, `of_points` and `point_of` say neither. Tests are sentences.
#[test]
fn functions_are_named_by_what_they_do_or_return() {
    let mut wrong = String::new();
    for path in crates().iter().flat_map(|root| modules(root).into_values()) {
        let text = std::fs::read_to_string(&path).unwrap();
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        for (i, line) in lines.iter().enumerate().filter(|(i, _)| *i == 0 || lines[i - 1] != "#[test]") {
            let Some((_, rest)) = line.split_once("fn ").filter(|(before, _)| !before.contains(['/', '"'])) else {
                continue;
            };
            let name = rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
            if name == "of" || name.starts_with("of_") || name.ends_with("_of") {
                wrong += &format!("{}:{}: `{name}`\n", path.display(), i + 1);
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}
