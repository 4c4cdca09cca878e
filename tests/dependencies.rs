//! What the program is built from, by the lists of deny.toml: licences, banned crates, sources.

use crate::support::root;
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// Whether one of the alternatives of an SPDX expression has nothing but allowed licences.
fn allowed(expression: &str, licences: &[&str]) -> bool {
    let expression = expression.replace('/', " OR ");
    let mut depth = 0i32;
    // parts between a word outside parentheses
    let mut split = |word: &str| {
        let mut parts = vec![String::new()];
        for token in expression.replace('(', " ( ").replace(')', " ) ").split_whitespace() {
            depth += i32::from(token == "(") - i32::from(token == ")");
            match token {
                _ if token == word && depth == 0 => parts.push(String::new()),
                _ => *parts.last_mut().unwrap() += &format!(" {token}"),
            }
        }
        parts.into_iter().map(|part| part.trim().to_owned()).collect::<Vec<_>>()
    };
    let (all, any) = (split("AND"), split("OR"));
    match expression.trim() {
        inner if any.len() > 1 => any.iter().any(|part| part != inner && allowed(part, licences)),
        inner if all.len() > 1 => all.iter().all(|part| part != inner && allowed(part, licences)),
        inner => match inner.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')) {
            Some(inner) => allowed(inner.trim(), licences),
            None => licences.contains(&inner),
        },
    }
}

#[test]
fn expressions_of_licences_are_read_as_spdx_defines_them() {
    let licences = ["MIT", "Apache-2.0 WITH LLVM-exception", "Zlib"];
    for ok in ["MIT", "GPL-3.0 OR MIT", "GPL-3.0/MIT", "MIT AND Zlib", "(MIT OR GPL-3.0) AND Zlib"] {
        assert!(allowed(ok, &licences), "{ok}");
    }
    for not in ["GPL-3.0", "MIT AND GPL-3.0", "(MIT AND GPL-3.0) OR Apache-2.0", "(MIT OR Zlib) AND GPL-3.0", ""] {
        assert!(!allowed(not, &licences), "{not}");
    }
}

#[test]
fn dependencies_are_those_that_deny_toml_allows() {
    let root = root();
    let deny = std::fs::read_to_string(root.join("deny.toml")).unwrap();
    let deny: toml::Table = toml::from_str(&deny).unwrap();
    let licences: Vec<&str> = deny["licenses"]["allow"].as_array().unwrap().iter().filter_map(|l| l.as_str()).collect();
    let banned = deny["bans"]["deny"].as_array().unwrap();
    // crates of other systems may not be there
    let system = format!(
        "{}-{}",
        std::env::consts::ARCH,
        if cfg!(target_os = "linux") { "unknown-linux-gnu" } else { "apple-darwin" }
    );
    let metadata = Command::new(env!("CARGO"))
        .args(["metadata", "--locked", "--offline", "--format-version", "1", "--filter-platform", &system])
        .current_dir(root)
        .output()
        .unwrap();
    let metadata: Value = serde_json::from_slice(&metadata.stdout)
        .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&metadata.stderr)));
    let packages = metadata["packages"].as_array().unwrap();
    assert!(packages.len() > 100);
    let mut wrong = Vec::new();
    for package in packages {
        let (name, version) = (package["name"].as_str().unwrap(), package["version"].as_str().unwrap());
        let licence = package["license"].as_str().unwrap_or("");
        if !allowed(licence, &licences) {
            wrong.push(format!("{name} {version}: licence {licence:?}"));
        }
        let manifest = package["manifest_path"].as_str().unwrap();
        let local = package["source"].is_null() && Path::new(manifest).starts_with(root);
        if !local && !package["source"].as_str().is_some_and(|source| source.starts_with("registry+")) {
            wrong.push(format!("{name} {version} is not from a registry"));
        }
        let ban = banned.iter().find(|ban| ban["name"].as_str() == Some(name));
        let of_this = |ban: &&toml::Value| match ban.get("version").and_then(|v| v.as_str()) {
            Some(below) => below.strip_prefix('<').is_some_and(|below| !version.starts_with(below)),
            None => true,
        };
        // a version that another crate brings is that crate's
        if ban.filter(of_this).is_some_and(|ban| ban.get("wrappers").is_none()) {
            wrong.push(format!("{name} {version} is banned"));
        }
    }
    assert!(wrong.is_empty(), "by deny.toml:\n{}", wrong.join("\n"));
}
