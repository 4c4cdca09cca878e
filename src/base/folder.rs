//! Folder of results that is written beside the earlier one and replaces it as a whole: an
//! interruption at any moment leaves one of the two complete.

use super::files::{Lock, beside, parent, write_synced};
use super::message::{Message, Problems, Result};
use crate::error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Time at which written files reach the disk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Durability {
    /// Before the folder is replaced: a power failure leaves the earlier or the new folder.
    Now,
    /// When the system writes them, or [`flush`] is called. A power failure may leave truncated
    /// files, which the hashes in the manifest reveal, but never files of two runs.
    Later,
}

/// Exclusive right to replace a folder, until dropped.
pub struct FolderLock {
    /// Folder, as the user named it.
    named: PathBuf,
    /// Folder itself, if a link leads to it.
    place: PathBuf,
    _lock: Lock,
}

impl FolderLock {
    /// Takes the lock, waiting for another process that is replacing the folder.
    pub fn take(folder: &Path) -> Result<Self> {
        let place = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
        fs::create_dir_all(parent(&place)).map_err(|e| cannot_write(folder, &e))?;
        let lock = Lock::take(&place)?;
        let held = Self { named: folder.to_owned(), place, _lock: lock };
        let (new, old) = held.beside();
        recover(&held.place, &new, &old).map_err(|e| cannot_write(folder, &e))?;
        Ok(held)
    }

    /// Replaces the folder by one that contains `files` and the parts of the earlier folder whose
    /// names `keeps` accepts. `ready` is called immediately before the exchange, after which
    /// nothing can fail.
    pub fn replace(
        self,
        files: &[(String, Vec<u8>)],
        keeps: impl Fn(&str) -> bool,
        ready: impl FnOnce() -> Result<()>,
        durability: Durability,
    ) -> Result<()> {
        let fail = |e: io::Error| Problems::from(cannot_write(&self.named, &e));
        let (place, (new, old)) = (&self.place, self.beside());
        let written = fill(place, &new, files, keeps, durability).map_err(fail).and_then(|()| ready());
        let written = written.and_then(|()| exchange(place, &new, &old).map_err(fail));
        if written.is_ok() && durability == Durability::Now {
            // the folder is replaced, whatever the result of the sync
            let _ = sync(parent(place));
        }
        // the earlier folder or, after a failure, the new one
        let _ = fs::remove_dir_all(&new);
        let _ = fs::remove_dir_all(&old);
        written
    }

    /// Temporary names of the new and the earlier folder during the exchange.
    fn beside(&self) -> (PathBuf, PathBuf) {
        (beside(&self.place, "new"), beside(&self.place, "old"))
    }
}

fn cannot_write(folder: &Path, e: &io::Error) -> Message {
    error!("cannot-write-folder", folder = folder.display().to_string(), reason = e.to_string())
}

/// Removes the remains of an interrupted run.
fn recover(place: &Path, new: &Path, old: &Path) -> io::Result<()> {
    if old.exists() && !place.exists() {
        fs::rename(old, place)?;
    }
    for left in [new, old].into_iter().filter(|left| left.exists()) {
        fs::remove_dir_all(left)?;
    }
    Ok(())
}

fn fill(
    place: &Path,
    new: &Path,
    files: &[(String, Vec<u8>)],
    keeps: impl Fn(&str) -> bool,
    durability: Durability,
) -> io::Result<()> {
    fs::create_dir(new)?;
    for (name, bytes) in files {
        match durability {
            Durability::Now => write_synced(&new.join(name), bytes)?,
            Durability::Later => fs::write(new.join(name), bytes)?,
        }
    }
    if place.exists() {
        fs::set_permissions(new, fs::metadata(place)?.permissions())?;
        for entry in fs::read_dir(place)? {
            let entry = entry?;
            if keeps(&entry.file_name().to_string_lossy()) {
                carry(&entry.path(), &new.join(entry.file_name()))?;
            }
        }
    }
    if durability == Durability::Now { sync(new) } else { Ok(()) }
}

/// Links a file or folder under another name; copies it if the file system has no links.
fn carry(from: &Path, to: &Path) -> io::Result<()> {
    if !fs::symlink_metadata(from)?.is_dir() {
        return fs::hard_link(from, to).or_else(|_| fs::copy(from, to).map(drop));
    }
    fs::create_dir(to)?;
    fs::read_dir(from)?.try_for_each(|entry| entry.and_then(|e| carry(&e.path(), &to.join(e.file_name()))))
}

/// Exchanges two folders in one step; in two steps if the file system does not support that, or if
/// there is no earlier folder.
fn exchange(place: &Path, new: &Path, old: &Path) -> io::Result<()> {
    #[cfg(any(target_os = "linux", target_vendor = "apple"))]
    {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        if place.exists() && renameat_with(CWD, new, CWD, place, RenameFlags::EXCHANGE).is_ok() {
            return Ok(());
        }
    }
    if place.exists() {
        fs::rename(place, old)?;
    }
    fs::rename(new, place).inspect_err(|_| drop(fs::rename(old, place)))
}

/// Waits until the names in a folder are on the disk.
fn sync(folder: &Path) -> io::Result<()> {
    if cfg!(unix) { fs::File::open(folder)?.sync_all() } else { Ok(()) }
}

/// Waits until everything written into these folders is on the disk; one call per file system where
/// supported.
pub fn flush<'a>(folders: impl IntoIterator<Item = &'a Path>) -> io::Result<()> {
    #[cfg(target_os = "linux")]
    {
        use std::os::unix::fs::MetadataExt;
        let mut flushed = std::collections::BTreeSet::new();
        for folder in folders {
            let file = fs::File::open(folder)?;
            if flushed.insert(file.metadata()?.dev()) {
                rustix::fs::syncfs(&file)?;
            }
        }
        Ok(())
    }
    #[cfg(not(target_os = "linux"))]
    {
        let files = |folder: &Path| fs::read_dir(folder)?.try_for_each(|file| fs::File::open(file?.path())?.sync_all());
        folders.into_iter().try_for_each(|folder| files(folder).and_then(|()| sync(folder)))
    }
}
