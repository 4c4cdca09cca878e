//! Input files: their bytes, of which text has lines and what has none is not read to its end; and their text, decoded
//! strictly, in the stated encoding or in the one that a byte-order mark names.

use super::exports::Format;
use super::workbook;
use crate::dialect::Encoding;
use encoding_rs::{DecoderResult, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};
use etalon_base::files;
use etalon_base::message::{Message, Place, Result as Read, nearest};
use std::io::{self, Read as _};
use std::path::Path;

/// Text of an input file and its bytes; where it cannot be read the message points at the campaign.
pub fn read_text(path: &Path, encoding: Option<Encoding>, place: &Place) -> Read<(String, Vec<u8>)> {
    let bytes = bytes_of(path).map_err(|problems| problems.at(place))?;
    let text = text_of(path, &bytes, encoding, &Format::default()).map_err(|problems| problems.at(place))?;
    Ok((text, bytes))
}

/// The text of a file in a format, which may be a sheet of a workbook, or bytes with a character for each.
pub fn text_of(path: &Path, bytes: &[u8], encoding: Option<Encoding>, format: &Format) -> Read<String> {
    let text = match &format.dialect.sheet {
        _ if format.about().binary => return Ok(bytes.iter().map(|byte| char::from(*byte)).collect()),
        Some(sheet) => workbook::text(bytes, sheet),
        None => decode(bytes.to_vec(), encoding),
    };
    Ok(text.map_err(|mut message| {
        message.what = format!("`{}`: {}", path.display(), message.what);
        message
    })?)
}

/// Bytes of an input file, or why it is none.
pub fn bytes_of(path: &Path) -> Read<Vec<u8>> {
    if path.is_dir() {
        let message = Message::error(format!("`{}` is a folder", path.display()));
        return Err(message.expected("a file").hint(format!("name a file in it; {}", listed(path))).into());
    }
    if !path.exists() {
        let message = Message::error(format!("there is no file `{}`", path.display()));
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        return Err(message.hint(beside(path.parent().unwrap_or(Path::new("")), &name)).into());
    }
    let file = files::open(path);
    let file = file.map_err(|e| Message::error(format!("cannot read `{}`: {e}", path.display())))?;
    Ok(bounded(file.take(files::LARGEST + 1)).map_err(|mut message| {
        message.what = format!("`{}`: {}", path.display(), message.what);
        message
    })?)
}

/// What to do about a file that is not there: the file that may be meant, or how one comes by it.
fn beside(folder: &Path, wrong: &str) -> String {
    let names = files_in(folder);
    let truth = folder.ancestors().map(|folder| folder.join("truth.toml")).find(|truth| truth.is_file());
    match (nearest(wrong, names.iter().map(String::as_str)), truth) {
        (Some(name), _) => format!("did you mean `{name}`, which is there?"),
        (None, Some(truth)) => {
            let campaign = truth.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
            format!("`etalon simulate {}` writes it from truth.toml", campaign.display())
        }
        (None, None) if names.is_empty() => {
            "put it there, or name another: paths begin at the campaign's folder".to_owned()
        }
        (None, None) => listed(folder),
    }
}

fn listed(folder: &Path) -> String {
    let names = files_in(folder);
    let more = if names.len() > 12 { ", ..." } else { "" };
    format!("there are: {}{more}", names[..names.len().min(12)].join(", "))
}

/// Names of the files in a folder, sorted.
fn files_in(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten().filter(|e| e.path().is_file());
    let mut names: Vec<String> = files.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Longer lines are in no measurement.
const LONGEST_LINE: usize = 1 << 20;
/// XML may be one line; so may a workbook be called, which is compressed.
const LONGEST_XML: usize = 256 << 20;
/// Read at a time.
const PIECE: usize = 1 << 20;

/// All bytes, if the text in them has lines.
///
/// # Errors
/// If reading fails, or at the first line that is too long: before more than that line is in memory.
fn bounded(mut from: impl io::Read) -> Result<Vec<u8>, Message> {
    let mut bytes = Vec::new();
    let (mut number, mut start) = (1, 0);
    let mut longest = LONGEST_LINE;
    loop {
        let before = bytes.len();
        let piece = from.by_ref().take(PIECE as u64).read_to_end(&mut bytes);
        if piece.map_err(|e| Message::error(format!("cannot read the file: {e}")))? == 0 {
            return Ok(bytes);
        }
        if bytes.len() as u64 > files::LARGEST {
            return Err(Message::error(format!("the file is larger than {} MiB", files::LARGEST >> 20)));
        }
        if before == 0 {
            refuse(&bytes)?;
            longest = if is_document(&bytes) { LONGEST_XML } else { LONGEST_LINE };
        }
        for (i, _) in bytes.iter().enumerate().skip(before).filter(|(_, b)| matches!(b, b'\n' | b'\r')) {
            if i - start > longest {
                return Err(too_long(number, longest));
            }
            number += usize::from(bytes[i] == b'\n');
            start = i + 1;
        }
        if bytes.len() - start > longest {
            return Err(too_long(number, longest));
        }
    }
}

/// XML, a zip archive, or PLY, which may be binary.
fn is_document(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    text.starts_with(b"<") || bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"ply")
}

fn too_long(number: usize, longest: usize) -> Message {
    let what = format!("line {number} is longer than {} MiB: no measurement has such a line", longest >> 20);
    Message::error(what).hint("is the file a recording in binary form, or an archive? export it as text with lines")
}

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
fn refuse(bytes: &[u8]) -> Result<(), Message> {
    match KINDS.into_iter().find(|(start, _, _)| bytes.starts_with(start)) {
        Some((_, what, hint)) => Err(Message::error(format!("the file is {what}, and no text")).hint(hint)),
        None => Ok(()),
    }
}

fn coding(encoding: Encoding) -> &'static encoding_rs::Encoding {
    match encoding {
        Encoding::Utf8 => UTF_8,
        Encoding::Utf16Le => UTF_16LE,
        Encoding::Utf16Be => UTF_16BE,
        Encoding::Windows1252 => WINDOWS_1252,
    }
}

/// The encoding that the first bytes name, and how many they are.
fn mark(bytes: &[u8]) -> Option<(Encoding, usize)> {
    let (marked, length) = encoding_rs::Encoding::for_bom(bytes)?;
    let all = [Encoding::Utf8, Encoding::Utf16Le, Encoding::Utf16Be];
    all.into_iter().find(|encoding| coding(*encoding) == marked).map(|encoding| (encoding, length))
}

/// The text of a file, without its byte-order mark, its lines ended by line feeds (or carriage return and line feed).
///
/// # Errors
/// If a byte does not belong to the encoding, if the mark names another one than the campaign, or if the text holds a NUL.
pub fn decode(bytes: Vec<u8>, stated: Option<Encoding>) -> Result<String, Message> {
    let marked = mark(&bytes);
    let encoding = match (stated, marked) {
        (Some(stated), Some((marked, _))) if stated != marked => {
            let what = format!(
                "the file begins with the mark of {}, and the campaign states {}",
                marked.name(),
                stated.name()
            );
            return Err(Message::error(what).hint("leave `encoding` out: the mark in the file states it"));
        }
        (stated, marked) => stated.or(marked.map(|m| m.0)).unwrap_or(Encoding::Utf8),
    };
    let skipped = marked.map_or(0, |m| m.1);
    let text = match encoding {
        // without a copy
        Encoding::Utf8 if skipped == 0 => {
            String::from_utf8(bytes).map_err(|e| not_utf8(e.as_bytes(), e.utf8_error().valid_up_to()))?
        }
        _ => {
            let body = &bytes[skipped..];
            decoded(body, encoding).map_err(|at| {
                let line = line_of(body, at);
                Message::error(format!("byte {} (line {line}) is not {}", skipped + at, encoding.name()))
            })?
        }
    };
    if let Some(at) = text.find('\0') {
        let line = line_of(text.as_bytes(), at);
        let what = format!("the file contains a NUL byte (line {line}): it is damaged or not a text");
        let hint = "UTF-16 without its mark? then state `encoding = \"utf-16le\"`; else export the file again";
        return Err(Message::error(what).hint(hint));
    }
    Ok(line_ends(text))
}

fn line_of(bytes: &[u8], at: usize) -> usize {
    bytes[..at].iter().filter(|b| **b == b'\n').count() + 1
}

fn not_utf8(bytes: &[u8], at: usize) -> Message {
    let (line, byte) = (line_of(bytes, at), bytes.get(at).copied().unwrap_or_default());
    let meant = decoded(&[byte], Encoding::Windows1252);
    let meant = meant.map(|c| format!(": of windows-1252 the byte would be `{c}`")).unwrap_or_default();
    Message::error(format!("the file is not UTF-8 text (byte {at}, line {line}, 0x{byte:02X})"))
        .hint(format!("state how it was written, e.g. `encoding = \"windows-1252\"`{meant}"))
}

/// The text of bytes; or the first byte that does not belong to the encoding.
fn decoded(bytes: &[u8], encoding: Encoding) -> Result<String, usize> {
    let mut decoder = coding(encoding).new_decoder_without_bom_handling();
    let mut text = String::with_capacity(decoder.max_utf8_buffer_length(bytes.len()).unwrap_or(0));
    match decoder.decode_to_string_without_replacement(bytes, &mut text, true) {
        (DecoderResult::Malformed(length, behind), read) => Err(read.saturating_sub(usize::from(length + behind))),
        // five bytes of windows-1252 mean nothing; as browsers read them they are control characters
        _ if encoding == Encoding::Windows1252 => {
            text.chars().position(|c| ('\u{80}'..='\u{9f}').contains(&c)).map_or(Ok(text), Err)
        }
        _ => Ok(text),
    }
}

/// Carriage returns alone end lines too.
fn line_ends(text: String) -> String {
    let bytes = text.as_bytes();
    let alone = |(i, b): (usize, &u8)| *b == b'\r' && bytes.get(i + 1) != Some(&b'\n');
    match bytes.iter().enumerate().any(alone) {
        true => text.replace("\r\n", "\n").replace('\r', "\n"),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// So many bytes, then `end`; counts what was taken.
    struct Endless {
        left: usize,
        taken: usize,
    }

    impl io::Read for &mut Endless {
        fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
            let n = into.len().min(self.left);
            into[..n].fill(b'1');
            (self.left, self.taken) = (self.left - n, self.taken + n);
            Ok(n)
        }
    }

    #[test]
    fn trap_23_a_line_of_a_gigabyte_is_an_error_before_it_is_in_memory() {
        let mut endless = Endless { left: 1 << 30, taken: 0 };
        let begun = std::time::Instant::now();
        let said = bounded(&mut endless).unwrap_err().to_string();
        assert!(said.contains("line 1 is longer than 1 MiB"), "{said}");
        assert!(endless.taken <= 4 * PIECE && begun.elapsed().as_secs() < 60, "{} bytes read", endless.taken);
    }

    #[test]
    fn lines_count_and_are_given_back_whole() {
        let text = "1 2 3\r\n".repeat(500_000);
        assert_eq!(bounded(text.as_bytes()).unwrap(), text.as_bytes());
        let long = text.clone() + &"x".repeat(LONGEST_LINE + 1) + "\n1 2 3\n";
        let said = bounded(long.as_bytes()).unwrap_err().to_string();
        assert!(said.contains("line 500001 is longer"), "{said}");
        let xml = "<a>".to_owned() + &" ".repeat(3 * LONGEST_LINE) + "</a>";
        assert_eq!(bounded(xml.as_bytes()).unwrap().len(), xml.len());
    }

    /// As another program writes it: Python's codecs gave these bytes for `±°µäß€\n`.
    const TEXT: &str = "±°µäß€\n";
    const CP1252: &[u8] = b"\xb1\xb0\xb5\xe4\xdf\x80\n";
    const LE: &[u8] = b"\xff\xfe\xb1\x00\xb0\x00\xb5\x00\xe4\x00\xdf\x00\xac\x20\x0a\x00";

    #[test]
    fn trap_1_the_same_text_in_every_encoding() {
        let utf8 = TEXT.as_bytes();
        let marked = [b"\xef\xbb\xbf", utf8].concat();
        let be: Vec<u8> = LE.chunks(2).flat_map(|p| [p[1], p[0]]).collect();
        for (bytes, stated) in [
            (utf8, None),
            (&marked, None),
            (&marked, Some(Encoding::Utf8)),
            (CP1252, Some(Encoding::Windows1252)),
            (LE, None),
            (&be, None),
            (&LE[2..], Some(Encoding::Utf16Le)),
            (&be[2..], Some(Encoding::Utf16Be)),
        ] {
            assert_eq!(decode(bytes.to_vec(), stated).unwrap(), TEXT, "{stated:?}");
        }
    }

    #[test]
    fn trap_1_bytes_of_another_encoding_are_refused() {
        let said = |bytes: &[u8], stated| decode(bytes.to_vec(), stated).unwrap_err().to_string();
        let utf8 = said(b"a\n\xb12.000\n", None);
        assert!(
            utf8.contains("not UTF-8 text (byte 2, line 2, 0xB1)") && utf8.contains("the byte would be `±`"),
            "{utf8}"
        );
        assert!(said(b"a\n\x81", Some(Encoding::Windows1252)).contains("byte 2 (line 2) is not windows-1252"));
        assert!(said(LE, Some(Encoding::Utf8)).contains("begins with the mark of utf-16le"));
        assert!(said(&LE[2..], None).contains("not UTF-8"));
        assert!(said(b"1\x002\x00", None).contains("NUL byte (line 1)"));
        assert!(said(b"\xff\xfe1", None).contains("is not utf-16le"));
        assert!(said(b"\xff\xfe\x00\xd8\x31\x00", None).contains("byte 2 "));
    }

    #[test]
    fn every_line_end_ends_a_line() {
        for text in ["a\nb\nc", "a\r\nb\nc", "a\rb\rc", "a\r\nb\rc\n"] {
            let text = decode(text.as_bytes().to_vec(), None).unwrap();
            assert_eq!(text.lines().collect::<Vec<_>>(), ["a", "b", "c"]);
        }
    }
}
