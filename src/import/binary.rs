//! Files that are no text, known by their first bytes.

use crate::base::message::Message;

/// First bytes, what they begin, and what to do instead.
const KINDS: [(&[u8], &str, &str); 6] = [
    (
        b"MATLAB 5.0 MAT-file",
        "a MATLAB file",
        "write its table as text, with `writematrix`, and state what each column is",
    ),
    (
        b"MATLAB 7.3 MAT-file",
        "a MATLAB file",
        "write its table as text, with `writematrix`, and state what each column is",
    ),
    (b"\x89HDF", "an HDF5 file", "write its table as text"),
    (b"\x1f\x8b", "compressed with gzip", "unpack it"),
    (b"\xd0\xcf\x11\xe0", "an old Excel workbook (.xls)", "save it as .xlsx, or as text"),
    (b"%PDF", "a PDF document", "export the points as text"),
];

/// An error if the file is of a kind that holds no text.
pub(super) fn refuse(bytes: &[u8]) -> Result<(), Message> {
    match KINDS.into_iter().find(|(start, _, _)| bytes.starts_with(start)) {
        Some((_, what, hint)) => Err(Message::error(format!("the file is {what}, and no text")).hint(hint)),
        None => Ok(()),
    }
}
