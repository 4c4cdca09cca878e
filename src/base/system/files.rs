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
use unicode_normalization::{IsNormalized, UnicodeNormalization, is_nfc_quick};

/// Maximum size of an input that is read as a whole (bytes).
pub const LARGEST: u64 = 2 << 30;
/// Maximum size of a lock file, which contains the number of a process (bytes).
const LARGEST_LOCK: u64 = 20;
/// Maximum size of the text of a campaign, robot or page (bytes).
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
    let stamp = Stamp::new(&bytes);
    Ok((text(path, bytes)?, stamp))
}

/// Converts the bytes of a file to text like [`read_text`].
pub fn text(path: &Path, bytes: Vec<u8>) -> Result<String> {
    let text = String::from_utf8(bytes)
        .map_err(|e| error!("not-utf8", file = path.display().to_string(), byte = e.utf8_error().valid_up_to()))?;
    Ok(one_form(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text)))
}

/// Text in one Unicode form (NFC): a letter and its accent as two characters become one, so that
/// equal names compare equal, independent of the program that wrote them.
pub fn one_form(text: String) -> String {
    match text.is_ascii() || is_nfc_quick(text.chars()) == IsNormalized::Yes {
        true => text,
        false => text.nfc().collect(),
    }
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
    pub fn new(bytes: &[u8]) -> Self {
        Self { sha256: sha256(bytes), size: bytes.len() }
    }
}

fn cannot_write(path: &Path, reason: &impl std::fmt::Display) -> Message {
    error!("cannot-write-file", file = path.display().to_string(), reason = reason.to_string())
}

/// Rejects a path below `root` that leads through a symbolic link: the path itself, or a folder
/// between it and `root`. The links above `root`, and `root` itself, belong to the user.
pub fn refuse_links(root: &Path, path: &Path) -> Result<()> {
    let above = root.components().count();
    // the components alone: a slash at the end would follow the link
    let parts: Vec<_> = path.components().collect();
    let inside = (above + 1..=parts.len()).map(|count| parts[..count].iter().collect::<PathBuf>());
    let is_link = |path: &PathBuf| std::fs::symlink_metadata(path).is_ok_and(|found| found.is_symlink());
    match inside.filter(|path| path.file_name().is_some()).find(is_link) {
        Some(link) => {
            let (file, link) = (path.display().to_string(), link.display().to_string());
            Err(error!("output-through-link", file, link).into())
        }
        None => Ok(()),
    }
}

/// Folder whose links count as the user's: the campaign's that contains a written path, or the
/// folder of the path.
fn root(path: &Path) -> &Path {
    path.ancestors().skip(1).find(|above| above.join("campaign.toml").is_file()).unwrap_or_else(|| above(path))
}

/// Path without its last component: empty for a single name.
fn above(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// Rejects a place that a writer may not replace: one that a link leads to, a device, or a pipe.
pub(crate) fn refuse_foreign(path: &Path) -> Result<()> {
    refuse_links(root(path), path)?;
    match std::fs::symlink_metadata(path) {
        Ok(found) if !found.is_file() && !found.is_dir() => {
            Err(error!("output-not-a-file", file = path.display().to_string()).into())
        }
        _ => Ok(()),
    }
}

/// Largest file (bytes) that the system lets this process write (`ulimit -f`), if it has a limit.
/// A larger file would end the process before its locks are removed.
fn file_size_limit() -> Option<u64> {
    let limits = std::fs::read_to_string("/proc/self/limits").ok()?;
    let limit = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        words.strip_prefix(&["Max", "file", "size"])?.first()?.parse().ok()
    };
    limits.lines().find_map(limit)
}

/// File whose writer fails, instead of the process, at the largest size that the system allows.
pub struct Bounded {
    file: File,
    left: Option<u64>,
}

impl Bounded {
    /// Takes an empty file.
    pub(crate) fn new(file: File) -> Self {
        Self { file, left: file_size_limit() }
    }

    /// Waits until the contents are on the disk.
    pub(crate) fn sync_all(&self) -> std::io::Result<()> {
        self.file.sync_all()
    }
}

impl Write for Bounded {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let Some(left) = &mut self.left else { return self.file.write(bytes) };
        let count = (bytes.len() as u64).min(*left) as usize;
        if count == 0 && !bytes.is_empty() {
            return Err(std::io::ErrorKind::FileTooLarge.into());
        }
        let written = self.file.write(&bytes[..count])?;
        *left -= written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush()
    }
}

/// Gives a new file or folder the mode and the owner of the earlier one.
#[cfg(unix)]
pub(crate) fn keep_rights(earlier: &std::fs::Metadata, new: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::{MetadataExt, lchown};
    let found = std::fs::symlink_metadata(new)?;
    if (found.uid(), found.gid()) != (earlier.uid(), earlier.gid()) {
        lchown(new, Some(earlier.uid()), Some(earlier.gid()))?;
    }
    // after the owner, whose change clears bits of the mode
    if earlier.is_symlink() { Ok(()) } else { std::fs::set_permissions(new, earlier.permissions()) }
}

/// Gives a new file or folder the mode of the earlier one.
#[cfg(not(unix))]
pub(crate) fn keep_rights(earlier: &std::fs::Metadata, new: &Path) -> std::io::Result<()> {
    std::fs::set_permissions(new, earlier.permissions())
}

/// Writes a file under a temporary name, syncs and renames it, so that an interruption at any
/// moment loses nothing. The mode of a replaced file is kept; links, devices and pipes are
/// rejected.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    write_by(path, |file| Ok(file.write_all(bytes)?))
}

/// Like [`write()`], with a file that `fill` writes incrementally.
pub fn write_by<T>(path: &Path, fill: impl FnOnce(&mut BufWriter<Bounded>) -> anyhow::Result<T>) -> Result<T> {
    let fail = |e: anyhow::Error| match e.downcast::<Problems>() {
        Ok(problems) => problems,
        Err(e) => cannot_write(path, &e).into(),
    };
    refuse_foreign(path)?;
    std::fs::create_dir_all(parent(path)).map_err(|e| fail(e.into()))?;
    let _lock = Lock::take(path)?;
    let new = beside(path, "new");
    let write = || {
        // left by a stopped process, or a link that must not be followed
        let _ = std::fs::remove_file(&new);
        let mut file = BufWriter::new(Bounded::new(File::create_new(&new)?));
        let made = fill(&mut file)?;
        // a failed flush would be repeated by the writer
        file.into_inner().map_err(|e| e.into_parts().0)?.sync_all()?;
        if let Ok(earlier) = std::fs::symlink_metadata(path) {
            // of another user's file only the mode can be kept
            let kept = keep_rights(&earlier, &new);
            kept.or_else(|_| std::fs::set_permissions(&new, earlier.permissions()))?;
        }
        std::fs::rename(&new, path)?;
        Ok(made)
    };
    write().map_err(|e| {
        let _ = std::fs::remove_file(&new);
        fail(e)
    })
}

/// Paths of the files that are to be written into a folder: no link leads to the folder, and none
/// from the folder to a file.
pub fn places<N: AsRef<Path>, const COUNT: usize>(folder: &Path, names: [N; COUNT]) -> Result<[PathBuf; COUNT]> {
    let paths = names.map(|name| folder.join(name));
    refuse_linked(folder, &paths)?;
    Ok(paths)
}

fn refuse_linked(folder: &Path, paths: &[PathBuf]) -> Result<()> {
    refuse_foreign(folder)?;
    paths.iter().try_for_each(|path| refuse_links(folder, path))
}

/// Writes files into a folder, like [`places`], and returns their paths.
pub fn write_all<N: AsRef<Path>>(folder: &Path, files: &[(N, Vec<u8>)]) -> Result<Vec<String>> {
    let paths: Vec<PathBuf> = files.iter().map(|(name, _)| folder.join(name)).collect();
    // all of them before the first is written
    refuse_linked(folder, &paths)?;
    let write = |(path, (_, bytes)): (&PathBuf, &(N, Vec<u8>))| {
        write(path, bytes)?;
        Ok(path.display().to_string())
    };
    paths.iter().zip(files).map(write).collect()
}

/// Like [`write_all`], but fails if any of the files exists.
pub fn write_new<N: AsRef<Path>>(folder: &Path, files: &[(N, Vec<u8>)]) -> Result<Vec<String>> {
    if let Some(path) = files.iter().map(|(name, _)| folder.join(name)).find(|path| is_taken(path)) {
        return Err(error!("file-exists", file = path.display().to_string()).into());
    }
    write_all(folder, files)
}

/// `true` if anything has this name: a dangling link as well.
fn is_taken(path: &Path) -> bool {
    std::fs::symlink_metadata(path).is_ok()
}

/// Writes a new file, and waits until it is on the disk if it is to be there now.
pub(crate) fn write_file(path: &Path, bytes: &[u8], now: bool) -> std::io::Result<()> {
    let mut file = Bounded::new(File::create_new(path)?);
    file.write_all(bytes)?;
    if now { file.sync_all() } else { Ok(()) }
}

/// Parent folder of a path.
pub(crate) fn parent(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Temporary name `.NAME.ending` beside a path while NAME is being written.
pub(crate) fn beside(path: &Path, ending: &str) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    parent(path).join(format!(".{name}.{ending}"))
}

/// Exclusive right to write a path, until dropped. The lock of a killed process is taken over by
/// the next process.
pub(crate) struct Lock {
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
                    if file_size_limit().is_some_and(|most| most < LARGEST_LOCK) {
                        return Err(fail(std::io::ErrorKind::FileTooLarge.into()).into());
                    }
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

/// Fails if one of the files to be written is one of the input files, under any name.
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

/// A path as a word of a shell's command line.
pub fn shell_word(path: &Path) -> String {
    let text = path.display().to_string();
    let plain = |c: char| c.is_alphanumeric() || "/._-+,@".contains(c);
    match !text.is_empty() && text.chars().all(plain) {
        true => text,
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
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
pub fn sha256_by_name<'a>(paths: impl IntoIterator<Item = &'a PathBuf>) -> Result<BTreeMap<String, String>> {
    paths.into_iter().map(|path| Ok((path.display().to_string(), sha256(&read(path)?)))).collect()
}
