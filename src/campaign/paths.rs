//! Paths in a campaign: inside its folder, or below a named environment variable.

use etalon_base::error;
use etalon_base::files::one_form;
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
    let path = other_form(&path).unwrap_or(path);
    Ok((root, path))
}

/// Existing file whose name is the same in another Unicode form, for a name that no file has.
fn other_form(path: &Path) -> Option<PathBuf> {
    let name = path.file_name()?.to_str().filter(|name| !name.is_ascii())?;
    if path.exists() {
        return None;
    }
    let in_one_form = |name: &str| one_form(name.to_owned());
    let files = std::fs::read_dir(path.parent()?).ok()?.flatten();
    let same =
        |file: &std::fs::DirEntry| file.file_name().to_str().is_some_and(|n| in_one_form(n) == in_one_form(name));
    files.into_iter().find(same).map(|file| file.path())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_found_by_its_name_in_another_unicode_form() {
        let folder = std::env::temp_dir().join(format!("etalon-paths-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let [composed, decomposed] = ["Pr\u{fc}f.csv", "Pru\u{308}f.csv"];
        std::fs::write(folder.join(decomposed), "1 2 3\n").unwrap();
        assert!(resolve(&folder, composed).unwrap().exists());
        std::fs::write(folder.join(composed), "4 5 6\n").unwrap();
        let found = resolve(&folder, composed).unwrap();
        assert_eq!(std::fs::read_to_string(found).unwrap(), "4 5 6\n");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn paths_stay_inside() {
        let folder = Path::new("c");
        assert_eq!(resolve(folder, "exports/a.txt").unwrap(), Path::new("c/exports/a.txt"));
        for outside in ["../a", "/etc/passwd", "x/../../a", "$ETALON_NO_SUCH/a", "$HOME/../a"] {
            assert!(resolve(folder, outside).is_err(), "{outside}");
        }
    }
}
