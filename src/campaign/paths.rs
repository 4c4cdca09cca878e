//! Paths in a campaign: inside its folder, or below a named environment variable.

use etalon_base::error;
use etalon_base::message::Message;
use std::path::{Component, Path, PathBuf};

/// Splits `$NAME/rest` into NAME and rest.
fn variable(file: &str) -> Option<(&str, &str)> {
    file.strip_prefix('$').map(|f| f.split_once('/').unwrap_or((f, "")))
}

/// Variable at the start of a path, if it is unset.
pub(super) fn missing_variable(file: &str) -> Option<String> {
    variable(file).filter(|(name, _)| std::env::var_os(name).is_none()).map(|(name, _)| name.to_owned())
}

/// Resolves a path; an error if it leaves the folder, or if its variable is unset.
pub(super) fn resolve(folder: &Path, file: &str) -> Result<PathBuf, Message> {
    Ok(rooted(folder, file)?.1)
}

/// Resolves a path like [`resolve`] and returns it after its root: the folder, or the value of the
/// variable.
pub(super) fn rooted(folder: &Path, file: &str) -> Result<(PathBuf, PathBuf), Message> {
    let (root, rest) = match variable(file) {
        Some((name, rest)) => match std::env::var_os(name) {
            Some(root) => (PathBuf::from(root), rest),
            None => {
                return Err(error!("environment-missing", name, file = rest));
            }
        },
        None => (folder.to_owned(), file),
    };
    let inside = Path::new(rest).components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    if !inside {
        return Err(error!("path-outside", file));
    }
    let path = root.join(rest);
    Ok((root, path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_inside() {
        let folder = Path::new("c");
        assert_eq!(resolve(folder, "exports/a.txt").unwrap(), Path::new("c/exports/a.txt"));
        for outside in ["../a", "/etc/passwd", "x/../../a", "$ETALON_NO_SUCH/a", "$HOME/../a"] {
            assert!(resolve(folder, outside).is_err(), "{outside}");
        }
    }
}
