//! Reading whole files, and writing them so that nothing exists until it is whole.

use crate::base::message::{Message, Result};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// Opens a file for reading.
pub fn open(path: &Path) -> std::io::Result<File> {
    #[cfg(test)]
    OPENED.with_borrow_mut(|opened| opened.push(path.to_owned()));
    File::open(path)
}

#[cfg(test)]
thread_local! {
    /// Every file that was opened on this thread, in order.
    pub(crate) static OPENED: std::cell::RefCell<Vec<PathBuf>> = const { std::cell::RefCell::new(Vec::new()) };
}

/// The bytes of a file.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let read = open(path).and_then(|mut file| file.read_to_end(&mut bytes));
    read.map_err(|e| Message::error(format!("cannot read `{}`: {e}", path.display())))?;
    Ok(bytes)
}

/// The text of a file, which must be UTF-8; a byte-order mark is dropped.
pub fn read_text(path: &Path) -> Result<String> {
    text(path, read(path)?)
}

/// The text that the bytes of a file are: [`read_text`] without reading.
pub fn text(path: &Path, bytes: Vec<u8>) -> Result<String> {
    let text = String::from_utf8(bytes).map_err(|e| {
        Message::error(format!("`{}` is not UTF-8 (byte {})", path.display(), e.utf8_error().valid_up_to()))
    })?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}

/// Writes a file: into a temporary file beside it, then renamed, so that a stop at any moment loses nothing.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let fail = |e: std::io::Error| Message::error(format!("cannot write `{}`: {e}", path.display()));
    std::fs::create_dir_all(folder).map_err(fail)?;
    let mut file = tempfile::NamedTempFile::new_in(folder).map_err(fail)?;
    file.write_all(bytes).map_err(fail)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.as_file().set_permissions(std::fs::Permissions::from_mode(0o644)).map_err(fail)?;
    }
    file.persist(path).map_err(|e| fail(e.error))?;
    Ok(())
}

/// Removes a file, if it is there.
pub fn remove(path: &Path) -> Result<()> {
    match std::fs::remove_file(path) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
            Err(Message::error(format!("cannot remove `{}`: {e}", path.display())).into())
        }
        _ => Ok(()),
    }
}

/// SHA-256 as `sha256sum` prints it.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect()
}

/// The same of files, by their names as the user gave them.
pub fn sha256_of<'a>(paths: impl IntoIterator<Item = &'a PathBuf>) -> Result<BTreeMap<String, String>> {
    paths.into_iter().map(|path| Ok((path.display().to_string(), sha256(&read(path)?)))).collect()
}
