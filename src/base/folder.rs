//! A folder of results that is written beside the earlier one and exchanged with it whole: a stop at any moment leaves the one
//! or the other.

use super::files::{Lock, beside, parent, write_synced};
use super::message::{Message, Result};
use std::fs;
use std::io;
use std::path::Path;

/// Replaces `folder` by one that holds `files` and, of the earlier one, what `keeps` says by its name. Right before the
/// exchange `ready` is asked, after which nothing fails.
pub fn replace(
    folder: &Path,
    files: &[(String, Vec<u8>)],
    keeps: impl Fn(&str) -> bool,
    ready: impl FnOnce() -> Result<()>,
) -> Result<()> {
    let fail = |e: io::Error| Message::error(format!("cannot write the folder `{}`: {e}", folder.display())).into();
    // the folder that a link leads to
    let place = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    fs::create_dir_all(parent(&place)).map_err(fail)?;
    let _lock = Lock::take(&place)?;
    let (new, old) = (beside(&place, "new"), beside(&place, "old"));
    recover(&place, &new, &old).map_err(fail)?;
    let written = fill(&place, &new, files, keeps).map_err(fail).and_then(|()| ready());
    let written = written.and_then(|()| exchange(&place, &new, &old).map_err(fail));
    // the earlier folder; or the new one, where something failed
    let _ = fs::remove_dir_all(&new);
    let _ = fs::remove_dir_all(&old);
    written
}

/// Takes away what a run left that was stopped while it wrote.
fn recover(place: &Path, new: &Path, old: &Path) -> io::Result<()> {
    if old.exists() && !place.exists() {
        fs::rename(old, place)?;
    }
    for left in [new, old].into_iter().filter(|left| left.exists()) {
        fs::remove_dir_all(left)?;
    }
    Ok(())
}

fn fill(place: &Path, new: &Path, files: &[(String, Vec<u8>)], keeps: impl Fn(&str) -> bool) -> io::Result<()> {
    fs::create_dir(new)?;
    for (name, bytes) in files {
        write_synced(&new.join(name), bytes)?;
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
    sync(new)
}

/// The same file or folder under another name; a copy, where the file system has no links.
fn carry(from: &Path, to: &Path) -> io::Result<()> {
    if !fs::symlink_metadata(from)?.is_dir() {
        return fs::hard_link(from, to).or_else(|_| fs::copy(from, to).map(drop));
    }
    fs::create_dir(to)?;
    fs::read_dir(from)?.try_for_each(|entry| entry.and_then(|e| carry(&e.path(), &to.join(e.file_name()))))
}

/// Exchanges both folders in one step; in two, where the file system does not support that or no earlier folder exists.
fn exchange(place: &Path, new: &Path, old: &Path) -> io::Result<()> {
    #[cfg(any(target_os = "linux", target_vendor = "apple"))]
    {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        if place.exists() && renameat_with(CWD, new, CWD, place, RenameFlags::EXCHANGE).is_ok() {
            // done, whatever the disk says of it
            let _ = sync(parent(place));
            return Ok(());
        }
    }
    if place.exists() {
        fs::rename(place, old)?;
    }
    fs::rename(new, place).inspect_err(|_| drop(fs::rename(old, place)))?;
    let _ = sync(parent(place));
    Ok(())
}

/// Waits until the names in a folder are on the disk.
fn sync(folder: &Path) -> io::Result<()> {
    if cfg!(unix) { fs::File::open(folder)?.sync_all() } else { Ok(()) }
}
