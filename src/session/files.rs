//! Files in the folder of a page, and files that are dropped on the page.

use etalon_base::error;
use etalon_base::files;
use etalon_base::message::Result;
use etalon_campaign::Campaign;
use etalon_view::DroppedFile;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Most files, and most bytes, that a page stores.
const MOST_FILES: usize = 200;
const MOST_MIB: u64 = 1024;

/// Files that were dropped on the page, with their sizes.
#[derive(Clone, Debug, Default)]
pub(super) struct Dropped(BTreeMap<String, u64>);

impl Dropped {
    /// Stores a file in the folder. The server has checked the name.
    ///
    /// # Errors
    /// Fails if the folder has a file of this name, or too many were dropped.
    pub fn add(&mut self, folder: &Path, name: &str, bytes: &[u8]) -> Result<()> {
        let size = bytes.len() as u64;
        let stored: u64 = self.0.values().sum();
        if self.0.len() >= MOST_FILES || stored + size > MOST_MIB << 20 {
            return Err(error!("view-folder-full", files = MOST_FILES, mib = MOST_MIB).into());
        }
        // on file systems that ignore the case, another spelling is the same file
        if folder.join(name).symlink_metadata().is_ok() {
            return Err(error!("view-file-exists", name).into());
        }
        files::write_new(folder, &[(name, bytes.to_vec())])?;
        self.0.insert(name.to_owned(), size);
        Ok(())
    }

    /// Removes a file that was dropped.
    ///
    /// # Errors
    /// Fails for every other file.
    pub fn remove(&mut self, folder: &Path, name: &str) -> Result<()> {
        if self.0.remove(name).is_none() {
            return Err(error!("view-file-not-dropped", name).into());
        }
        // a file that is gone already is removed
        drop(std::fs::remove_file(folder.join(name)));
        Ok(())
    }
}

/// Files of a folder without a campaign, from which one can be proposed.
pub(super) fn inputs(folder: &Path, dropped: &Dropped) -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()).collect();
    all.retain(|path| path.is_file() && path.file_name().is_some_and(|name| !name.to_string_lossy().starts_with('.')));
    all.sort();
    // without a listing, the known files
    if all.is_empty() {
        all = dropped.0.keys().map(|name| folder.join(name)).filter(|path| path.is_file()).collect();
    }
    all
}

/// Files of the page: files that the campaign names, with their use, and dropped files.
pub(super) fn listed(folder: &Path, campaign: Option<&Campaign>, dropped: &Dropped) -> Vec<DroppedFile> {
    let mut all: Vec<DroppedFile> = Vec::new();
    let mut add = |name: &str, role: Option<&str>| {
        let bytes = std::fs::metadata(folder.join(name)).map_or(0, |file| file.len());
        if all.iter().all(|file| file.name != name) {
            all.push(DroppedFile { name: name.to_owned(), bytes, role: role.map(str::to_owned) });
        }
    };
    if let Some(campaign) = campaign {
        let file = &campaign.file;
        add(campaign.file_name(), Some("campaign"));
        if file.states_robot() {
            add(file.robot.get_ref(), Some("robot"));
        }
        file.exports.iter().for_each(|export| add(export.file.get_ref(), Some("export")));
        file.logs.iter().for_each(|log| add(log.file.get_ref(), Some("log")));
        file.observations.iter().for_each(|table| add(table.file.get_ref(), Some("observations")));
        file.inputs().for_each(|input| add(input.get_ref(), None));
    }
    dropped.0.keys().for_each(|name| add(name, None));
    if campaign.is_none() {
        for path in inputs(folder, dropped) {
            add(&path.file_name().unwrap_or_default().to_string_lossy(), None);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_stores_a_bounded_number_of_files() {
        let folder = tempfile::tempdir().unwrap();
        let mut dropped = Dropped((0..MOST_FILES).map(|i| (i.to_string(), 0)).collect());
        let refused = dropped.add(folder.path(), "one-more.csv", b"1").unwrap_err();
        assert!(refused.0[0].is("view-folder-full", &[("files", &MOST_FILES)]), "{refused:?}");
        let mut dropped = Dropped([("large.csv".to_owned(), MOST_MIB << 20)].into());
        assert!(dropped.add(folder.path(), "one-more.csv", b"1").is_err());
        assert_eq!(folder.path().read_dir().unwrap().count(), 0);
    }
}
