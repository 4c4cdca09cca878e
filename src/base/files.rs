//! Reads whole files, and writes files that appear only when complete.

use crate::error;
use crate::message::{Message, Problems, Result};
use crate::phrase;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Largest input that is read as a whole (bytes).
pub const LARGEST: u64 = 2 << 30;
/// Largest text of a campaign, robot or page (bytes).
const LARGEST_STATEMENT: u64 = 16 << 20;

/// Opens a regular file for reading. Pipes and devices are rejected, because they might block or
/// never end.
pub fn open(path: &Path) -> std::io::Result<File> {
    let file = open_regular(path)?;
    OPENED.with_borrow_mut(|opened| opened.iter_mut().for_each(|all| all.push(path.to_owned())));
    Ok(file)
}

/// Like [`open`], for repeated reading of an input: the file is not recorded.
fn open_regular(path: &Path) -> std::io::Result<File> {
    match std::fs::metadata(path)? {
        kind if kind.is_dir() => Err(std::io::Error::other(phrase!("is-a-folder").to_string())),
        kind if !kind.is_file() => Err(std::io::Error::other(phrase!("no-regular-file").to_string())),
        _ => File::open(path),
    }
}

thread_local! {
    /// Files opened on this thread, in order, while recording is active.
    static OPENED: std::cell::RefCell<Option<Vec<PathBuf>>> = const { std::cell::RefCell::new(None) };
}

/// Runs `work` and returns its result with the files that it opened on this thread, in order.
pub fn record_opened<T>(work: impl FnOnce() -> T) -> (T, Vec<PathBuf>) {
    OPENED.set(Some(Vec::new()));
    let result = work();
    (result, OPENED.take().unwrap_or_default())
}

fn read_at_most(path: &Path, largest: u64) -> Result<Vec<u8>> {
    let file = path.display().to_string();
    let fail = |e: std::io::Error| error!("cannot-read-file", file, reason = e.to_string());
    let mut bytes = Vec::new();
    open(path).and_then(|file| file.take(largest + 1).read_to_end(&mut bytes)).map_err(fail)?;
    if bytes.len() as u64 > largest {
        return Err(error!("file-too-large", file, most_mib = largest >> 20).into());
    }
    Ok(bytes)
}

/// Reads a file of at most 2 GiB.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    read_at_most(path, LARGEST)
}

/// Reads a UTF-8 text of at most 16 MiB that a person writes; a byte-order mark is dropped.
pub fn read_text(path: &Path) -> Result<String> {
    Ok(read_statement(path)?.0)
}

/// Like [`read_text`], with the stamp of the file.
pub fn read_statement(path: &Path) -> Result<(String, Stamp)> {
    let bytes = read_at_most(path, LARGEST_STATEMENT)?;
    let stamp = Stamp::of(&bytes);
    Ok((text(path, bytes)?, stamp))
}

/// Converts the bytes of a file to text like [`read_text`].
pub fn text(path: &Path, bytes: Vec<u8>) -> Result<String> {
    let text = String::from_utf8(bytes)
        .map_err(|e| error!("not-utf8", file = path.display().to_string(), byte = e.utf8_error().valid_up_to()))?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}

/// Identification of the contents of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stamp {
    /// SHA-256, as `sha256sum` prints it.
    pub sha256: String,
    /// Size (bytes).
    pub size: usize,
}

impl Stamp {
    /// Stamp of `bytes`.
    pub fn of(bytes: &[u8]) -> Self {
        Self { sha256: sha256(bytes), size: bytes.len() }
    }
}

fn cannot_write(path: &Path, reason: &impl std::fmt::Display) -> Message {
    error!("cannot-write-file", file = path.display().to_string(), reason = reason.to_string())
}

/// Writes a file under a temporary name, syncs and renames it, so that an interruption at any
/// moment loses nothing.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    write_by(path, |file| Ok(file.write_all(bytes)?))
}

/// Like [`write()`], with a file that `fill` writes incrementally.
pub fn write_by<T>(path: &Path, fill: impl FnOnce(&mut BufWriter<File>) -> anyhow::Result<T>) -> Result<T> {
    let fail = |e: anyhow::Error| match e.downcast::<Problems>() {
        Ok(problems) => problems,
        Err(e) => cannot_write(path, &e).into(),
    };
    std::fs::create_dir_all(parent(path)).map_err(|e| fail(e.into()))?;
    let _lock = Lock::take(path)?;
    let new = beside(path, "new");
    let write = || {
        // left by a stopped process, or a link that must not be followed
        let _ = std::fs::remove_file(&new);
        let mut file = BufWriter::new(File::create_new(&new)?);
        let made = fill(&mut file)?;
        file.into_inner()?.sync_all()?;
        std::fs::rename(&new, path)?;
        Ok(made)
    };
    write().map_err(|e| {
        let _ = std::fs::remove_file(&new);
        fail(e)
    })
}

/// Writes files into a folder and returns their paths.
pub fn write_all<N: AsRef<Path>>(folder: &Path, files: &[(N, Vec<u8>)]) -> Result<Vec<String>> {
    let write = |(name, bytes): &(N, Vec<u8>)| {
        let path = folder.join(name);
        write(&path, bytes)?;
        Ok(path.display().to_string())
    };
    files.iter().map(write).collect()
}

/// Like [`write_all`], but fails if any of the files exists.
pub fn write_new<N: AsRef<Path>>(folder: &Path, files: &[(N, Vec<u8>)]) -> Result<Vec<String>> {
    if let Some(path) = files.iter().map(|(name, _)| folder.join(name)).find(|path| path.exists()) {
        return Err(error!("file-exists", file = path.display().to_string()).into());
    }
    write_all(folder, files)
}

/// Writes a new file and waits until it is on the disk.
pub(super) fn write_synced(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

/// Parent folder of a path.
pub(super) fn parent(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Temporary name `.NAME.ending` beside a path while NAME is being written.
pub(super) fn beside(path: &Path, ending: &str) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    parent(path).join(format!(".{name}.{ending}"))
}

/// Exclusive right to write a path, until dropped. The lock of a killed process is taken over by
/// the next process.
pub(super) struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Takes the lock, waiting up to ten seconds for another process.
    pub fn take(of: &Path) -> Result<Self> {
        let path = beside(of, "lock");
        let fail = |e: std::io::Error| cannot_write(of, &e);
        for _ in 0..200 {
            // links, devices and files with a second name are not touched
            if std::fs::symlink_metadata(&path).is_ok_and(|found| !is_lock(&found)) {
                let (file, lock) = (of.display().to_string(), path.display().to_string());
                return Err(error!("lock-foreign", file, lock).into());
            }
            let file = open_lock(&path).map_err(fail)?;
            match file.try_lock() {
                // the previous holder has removed the file
                Ok(()) if !same_file(&file, &path) => {}
                Ok(()) => {
                    // dropped, and so removed, if the disk is full
                    let mut lock = Self { path, file };
                    lock.file.set_len(0).and_then(|()| write!(lock.file, "{}", std::process::id())).map_err(fail)?;
                    return Ok(lock);
                }
                Err(TryLockError::Error(e)) => return Err(fail(e).into()),
                Err(TryLockError::WouldBlock) => std::thread::sleep(Duration::from_millis(50)),
            }
        }
        let holder = std::fs::read_to_string(&path).unwrap_or_default();
        Err(error!("locked", process = holder, file = of.display().to_string()).into())
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.path);
    }
}

/// Opens or creates the file of a lock without following links.
fn open_lock(path: &Path) -> std::io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    #[cfg(unix)]
    {
        use rustix::fs::OFlags;
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags((OFlags::NOFOLLOW | OFlags::NONBLOCK).bits().cast_signed());
    }
    options.open(path)
}

/// `true` if a file of this kind may be emptied and removed as a lock.
fn is_lock(found: &std::fs::Metadata) -> bool {
    #[cfg(unix)]
    let names = std::os::unix::fs::MetadataExt::nlink(found);
    #[cfg(not(unix))]
    let names = 1;
    // a file that is being removed has no name
    found.is_file() && names <= 1
}

#[cfg(unix)]
fn same_file(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let of = |meta: std::fs::Metadata| (meta.dev(), meta.ino());
    file.metadata().map(of).ok().is_some_and(|open| std::fs::metadata(path).map(of).ok() == Some(open))
}

#[cfg(not(unix))]
fn same_file(_: &File, path: &Path) -> bool {
    path.exists()
}

/// Fails if one of the files to be written is one of the input files, under whatever name.
pub fn refuse_overwriting<'a>(
    written: impl IntoIterator<Item = &'a PathBuf>,
    read: impl IntoIterator<Item = &'a PathBuf> + Clone,
) -> Result<()> {
    for path in written {
        let Ok(place) = path.canonicalize() else { continue };
        if let Some(input) = read.clone().into_iter().find(|input| input.canonicalize().is_ok_and(|p| p == place)) {
            let (output, input) = (path.display().to_string(), input.display().to_string());
            return Err(error!("output-is-input", output, input).into());
        }
    }
    Ok(())
}

/// SHA-256, as `sha256sum` prints it.
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

/// SHA-256 of a file, which is read in pieces.
pub fn sha256_of_file(path: &Path) -> std::io::Result<String> {
    let (mut digest, mut file, mut piece) = (Sha256::new(), open_regular(path)?, vec![0; 1 << 16]);
    loop {
        match file.read(&mut piece)? {
            0 => return Ok(hexadecimal(&digest.finalize())),
            count => digest.update(&piece[..count]),
        }
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

/// SHA-256 of files, by their names as the user gave them.
pub fn sha256_of<'a>(paths: impl IntoIterator<Item = &'a PathBuf>) -> Result<BTreeMap<String, String>> {
    paths.into_iter().map(|path| Ok((path.display().to_string(), sha256(&read(path)?)))).collect()
}
