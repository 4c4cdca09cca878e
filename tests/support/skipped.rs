//! Tests that need a program or data that may not be there.

/// Says that a test, or a part of it, is skipped because `needed` is missing.
///
/// # Panics
/// Where `CI` is set, unless `ETALON_MISSING` names it: what CI does not test is listed in `.ci/run`.
#[allow(clippy::print_stdout, reason = "a skipped part of a test is said")]
pub fn skipped(needed: &str) {
    let known = std::env::var("ETALON_MISSING").unwrap_or_default();
    let known = known.split_whitespace().any(|name| name == needed);
    assert!(known || std::env::var_os("CI").is_none(), "`{needed}` is missing, and ETALON_MISSING does not name it");
    println!("skipped: there is no `{needed}`");
}
