//! First bytes of files of arrays.

use std::io::Cursor;

/// First bytes of an array of NumPy (`.npy`).
pub(crate) const NUMPY: &[u8] = b"\x93NUMPY";
/// First bytes of variables of MATLAB, level 5.
pub(crate) const MATLAB: &[u8] = b"MATLAB 5.0 MAT-file";

/// Line before each channel of a data set of DIAdem.
const CHANNEL: &[u8] = b"#BEGINCHANNELHEADER";
/// Number of bytes in which the first channel begins.
const GLOBAL_HEADER: usize = 16 << 10;

/// Returns the name of the log format of a file of arrays: `numpy`, `matlab` or `kuka_trace`.
pub(crate) fn arrays(bytes: &[u8]) -> Option<&'static str> {
    match () {
        () if bytes.starts_with(NUMPY) || is_npz(bytes) => Some("numpy"),
        () if bytes.starts_with(MATLAB) => Some("matlab"),
        () if bytes[..bytes.len().min(GLOBAL_HEADER)].windows(CHANNEL.len()).any(|at| at == CHANNEL) => {
            Some("kuka_trace")
        }
        () => None,
    }
}

/// `true` for an archive with arrays of NumPy.
fn is_npz(bytes: &[u8]) -> bool {
    let archive = bytes.starts_with(b"PK\x03\x04").then(|| zip::ZipArchive::new(Cursor::new(bytes)));
    archive
        .and_then(Result::ok)
        .is_some_and(|archive| archive.file_names().any(|name| name.is_ok_and(|name| name.ends_with(".npy"))))
}
