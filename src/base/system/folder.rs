//! Folder of results that is written next to the earlier one and replaces it as a whole: an
//! interruption at any moment leaves one of the two complete.

use crate::error;
use crate::files::{Lock, beside, keep_rights, parent, refuse_foreign, write_file};
use crate::message::{Message, Problems, Result};
use std::fs::{self, Metadata};
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
    /// Folder itself, if a link leads to a folder above it.
    place: PathBuf,
    _lock: Lock,
}

impl FolderLock {
    /// Takes the lock, waiting for another process that is replacing the folder. A folder that a
    /// link leads to, below its campaign, is rejected.
    pub fn take(folder: &Path) -> Result<Self> {
        refuse_foreign(folder)?;
        let place = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
        fs::create_dir_all(parent(&place)).map_err(|e| cannot_write(folder, &e))?;
        let lock = Lock::take(&place)?;
        let held = Self { named: folder.to_owned(), place, _lock: lock };
        let (new, old) = held.beside();
        // a link of such a name is not a remain of a run
        refuse_foreign(&new).and_then(|()| refuse_foreign(&old))?;
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
            // the folder is replaced, independent of the result of the sync
            let _ = sync(parent(place));
        }
        // the earlier folder or, after a failure, the new one
        let _ = remove(&new);
        let _ = remove(&old);
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
        remove(left)?;
    }
    Ok(())
}

/// Removes a folder, including read-only folders in it.
fn remove(folder: &Path) -> io::Result<()> {
    fs::remove_dir_all(folder).or_else(|e| {
        if e.kind() != io::ErrorKind::PermissionDenied {
            return Err(e);
        }
        unlock(folder)?;
        fs::remove_dir_all(folder)
    })
}

/// Lets the owner write into a folder and the folders in it.
fn unlock(folder: &Path) -> io::Result<()> {
    let found = fs::symlink_metadata(folder)?;
    if !found.is_dir() {
        return Ok(());
    }
    #[cfg(unix)]
    fs::set_permissions(folder, std::os::unix::fs::PermissionsExt::from_mode(0o700))?;
    fs::read_dir(folder)?.try_for_each(|entry| unlock(&entry?.path()))
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
        write_file(&new.join(name), bytes, durability == Durability::Now)?;
    }
    if place.exists() {
        let earlier = fs::symlink_metadata(place)?;
        for entry in fs::read_dir(place)? {
            let entry = entry?;
            if keeps(&entry.file_name().to_string_lossy()) {
                carry(&entry.path(), &new.join(entry.file_name()), &earlier)?;
            }
        }
        // a user who replaces another's folder keeps its mode
        keep_rights(&earlier, new).or_else(|_| fs::set_permissions(new, earlier.permissions()))?;
    }
    if durability == Durability::Now { sync(new) } else { Ok(()) }
}

/// Moves an entry of the earlier folder to the new one: a folder is created again with its mode and
/// owner, a file or symbolic link gets a second name. Symbolic links are not followed.
fn carry(from: &Path, to: &Path, earlier: &Metadata) -> io::Result<()> {
    let named = |e: io::Error| io::Error::new(e.kind(), format!("{}: {e}", from.display()));
    let found = fs::symlink_metadata(from).map_err(named)?;
    if !same_device(&found, earlier) {
        // the contents of a mounted volume would be removed with the earlier folder
        return Err(named(io::ErrorKind::CrossesDevices.into()));
    }
    if found.is_dir() {
        fs::create_dir(to).map_err(named)?;
        let entries = fs::read_dir(from).map_err(named)?;
        for entry in entries {
            let entry = entry.map_err(named)?;
            carry(&entry.path(), &to.join(entry.file_name()), earlier)?;
        }
        return keep_rights(&found, to).map_err(named);
    }
    fs::hard_link(from, to).or_else(|e| copy(from, to, &found, e)).map_err(named)
}

/// Copies a file or symbolic link that can have no second name for the reason `refused`.
fn copy(from: &Path, to: &Path, found: &Metadata, refused: io::Error) -> io::Result<()> {
    if found.is_file() {
        fs::copy(from, to)?;
    } else {
        copy_link(from, to, found, refused)?;
    }
    keep_rights(found, to)
}

#[cfg(unix)]
fn copy_link(from: &Path, to: &Path, found: &Metadata, refused: io::Error) -> io::Result<()> {
    if found.is_symlink() { std::os::unix::fs::symlink(fs::read_link(from)?, to) } else { Err(refused) }
}

#[cfg(not(unix))]
fn copy_link(_: &Path, _: &Path, _: &Metadata, refused: io::Error) -> io::Result<()> {
    Err(refused)
}

#[cfg(unix)]
fn same_device(a: &Metadata, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    a.dev() == b.dev()
}

#[cfg(not(unix))]
fn same_device(_: &Metadata, _: &Metadata) -> bool {
    true
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
