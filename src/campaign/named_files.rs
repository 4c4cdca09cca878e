//! Exports of a folder into which an instrument writes a file for each pose: `scans/{pose}.txt`.

use super::{CampaignFile, paths};
use etalon_base::error;
use etalon_base::message::{Message, Result, SourceText};
use etalon_formats::{Export, LabelNames, LabelPattern};
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Parts of a file's name that stand for target, pose and cycle.
const PLACEHOLDERS: [&str; 3] = ["{target}", "{pose}", "{cycle}"];

/// `true` if a name stands for several files.
fn is_form(file: &str) -> bool {
    PLACEHOLDERS.iter().any(|part| file.contains(part))
}

/// Present files of a form, as paths from the campaign's folder, in the order of their poses.
fn present(folder: &Path, form: &str) -> Result<Vec<(String, LabelNames)>> {
    let (parent, name) = form.rsplit_once('/').unwrap_or(("", form));
    let pattern = LabelPattern::parse(name)?;
    let entries = std::fs::read_dir(paths::resolve(folder, parent)?).into_iter().flatten().flatten();
    let mut found: Vec<(String, LabelNames)> = Vec::new();
    for entry in entries.filter(|entry| entry.path().is_file()) {
        let Ok(name) = entry.file_name().into_string() else { continue };
        let named = pattern.read(&name, |_| true);
        found.extend(named.map(|named| (if parent.is_empty() { name } else { format!("{parent}/{name}") }, named)));
    }
    found.sort_by(|(a, first), (b, second)| {
        let key = |named: &LabelNames| (named.pose, named.cycle, named.target.clone());
        key(first).cmp(&key(second)).then_with(|| a.cmp(b))
    });
    Ok(found)
}

/// Paths of the present files of a form.
pub(super) fn present_paths(folder: &Path, form: &str) -> Vec<PathBuf> {
    let files = present(folder, form).unwrap_or_default();
    files.iter().filter_map(|(file, _)| paths::resolve(folder, file).ok()).collect()
}

impl CampaignFile {
    /// Replaces each export of a form by one export for each of its present files, and returns the
    /// forms. A form without a file is an error.
    pub(super) fn name_files(&mut self, folder: &Path, stated: SourceText) -> (Vec<String>, Vec<Message>) {
        let (mut forms, mut problems) = (Vec::new(), Vec::new());
        let exports = std::mem::take(&mut self.exports);
        for export in exports {
            let form = export.file.get_ref().clone();
            // a file may have braces in its own name
            let is_file = || paths::resolve(folder, &form).is_ok_and(|path| path.is_file());
            if !is_form(&form) || is_file() {
                self.exports.push(export);
                continue;
            }
            let found = present(folder, &form).unwrap_or_else(|more| {
                problems.extend(more.at(&stated.place(&export.file)).0);
                Vec::new()
            });
            if found.is_empty() && problems.is_empty() {
                problems.push(error!("export-files-missing", file = &form).at(stated.place(&export.file)));
            }
            let of_file = |(file, from_name): (String, LabelNames)| Export {
                file: Spanned::new(export.file.span(), file),
                from_name,
                ..export.clone()
            };
            self.exports.extend(found.into_iter().map(of_file));
            forms.push(form);
        }
        (forms, problems)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_by_their_form_in_the_order_of_their_poses() {
        let folder = std::env::temp_dir().join(format!("etalon-named-files-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("scans/P7.txt")).unwrap();
        for name in ["P10.txt", "P2.txt", "P2.txt.part", ".P3.txt", "notes.md"] {
            std::fs::write(folder.join("scans").join(name), "1 2 3\n").unwrap();
        }
        let named =
            |form: &str| -> Vec<String> { present(&folder, form).unwrap().into_iter().map(|(file, _)| file).collect() };
        assert_eq!(named("scans/P{pose}.txt"), ["scans/P2.txt", "scans/P10.txt"]);
        assert_eq!(present(&folder, "scans/P{pose}.txt").unwrap()[1].1.pose, Some(10.into()));
        assert!(named("elsewhere/P{pose}.txt").is_empty() && named("P{pose}.txt").is_empty());
        let outside = present(&folder, "../{pose}.txt").unwrap_err();
        assert!(outside.0[0].is("path-outside", &[]), "{outside:?}");
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
