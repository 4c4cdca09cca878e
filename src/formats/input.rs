//! Input files: their bytes, and their text. A file without lines is rejected before it is read to
//! its end. Text is decoded strictly, in the given encoding or in the encoding of the byte-order
//! mark.

use super::exports::{Format, binary_format};
use super::logs::LogKind;
use super::workbook::Workbook;
use super::{magic, ros_bag, workbook};
use encoding_rs::DecoderResult;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place, Result as Read, nearest};
use etalon_base::{error, files, phrase};
use etalon_tables::{Decimal, Encoding};
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::path::Path;

/// Text of an input file and its bytes; if it cannot be read, the message points at the campaign.
pub fn read_text(path: &Path, encoding: Option<Encoding>, place: &Place) -> Read<(String, Vec<u8>)> {
    let bytes = read_bytes(path).map_err(|problems| problems.at(place))?;
    let text = file_text(path, &bytes, encoding, &Format::default()).map_err(|problems| problems.at(place))?;
    Ok((text, bytes))
}

/// Text of a file in a format: of a sheet of a workbook, of a topic of a recording, or of a binary
/// file with one character for each byte.
pub fn file_text(path: &Path, bytes: &[u8], encoding: Option<Encoding>, format: &Format) -> Read<String> {
    into_text(path, bytes.to_vec(), encoding, format)
}

/// Returns the text of a file like [`file_text`]. Reuses the memory of the bytes if they are
/// already text.
pub fn into_text(path: &Path, bytes: Vec<u8>, encoding: Option<Encoding>, format: &Format) -> Read<String> {
    let arrays = LogKind::from_array_file(&bytes);
    let text = match &format.dialect.form.sheet {
        _ if format.about().binary => return Ok(bytes.iter().map(|byte| char::from(*byte)).collect()),
        Some(topic) if ros_bag::is_recording(&bytes) => ros_bag::text(&bytes, topic),
        Some(array) if arrays.is_some() => {
            let kind = arrays.unwrap_or_default();
            return Ok(kind.sheet(&kind.array_file(path, &bytes)?, array)?);
        }
        Some(topic) if etalon_tables::is_topic(topic) => Err(error!("recording-missing", topic)),
        Some(sheet) => workbook::text(&bytes, sheet, format.dialect.form.decimal()),
        None if arrays.is_some() => return Err(arrays_not_text(path, &bytes).into()),
        None if ros_bag::is_recording(&bytes) => Err(topic_not_stated(&bytes)),
        None if workbook::is_workbook(&bytes) => Err(sheet_not_stated(&bytes)),
        None if bytes.contains(&0) && binary_format(&bytes).is_some() => {
            return Err(binary_not_text(path, &bytes).into());
        }
        None => decode(bytes, encoding.or(format.dialect.form.encoding)),
    };
    let text = text.map_err(|message| message.within(phrase!("in-file", file = path.display().to_string())))?;
    Ok(files::one_form(text))
}

/// Error about a file of arrays where a text is expected.
fn arrays_not_text(path: &Path, bytes: &[u8]) -> Message {
    let kind = magic::arrays(bytes).unwrap_or_default();
    error!("file-not-text", file = path.display().to_string(), kind)
}

/// Error about a binary file of points where a text is expected.
fn binary_not_text(path: &Path, bytes: &[u8]) -> Message {
    let kind = binary_format(bytes).unwrap_or_default();
    error!("file-not-text", file = path.display().to_string(), kind)
}

/// Error about a recording without a given topic.
fn topic_not_stated(bytes: &[u8]) -> Message {
    match ros_bag::topics(bytes) {
        Ok(topics) => {
            let readable = topics.iter().filter(|topic| topic.kind().is_some());
            error!("topic-not-stated").hint_names("", readable.map(|topic| topic.name.as_str()))
        }
        Err(message) => message,
    }
}

/// Name of the sheet of a workbook that has a single one; `None` for other files.
pub fn only_sheet(bytes: &[u8]) -> Option<String> {
    let mut sheets = workbook::is_workbook(bytes).then(|| Workbook::open(bytes).ok())??.sheets();
    sheets.pop().filter(|_| sheets.is_empty())
}

/// Error about a workbook without a given sheet; the hint gives the first sheet with more than one
/// row.
fn sheet_not_stated(bytes: &[u8]) -> Message {
    let mut book = match Workbook::open(bytes) {
        Ok(book) => book,
        Err(message) => return message,
    };
    let names = book.sheets();
    let has_rows = |name: &&String| book.text(name, Decimal::Point).is_ok_and(|text| text.lines().nth(1).is_some());
    let message = error!("sheet-not-stated", sheets = names);
    match names.iter().find(has_rows) {
        Some(sheet) => message.hint(phrase!("state-sheet", sheet)),
        None => message,
    }
}

/// Bytes of an input file.
pub fn read_bytes(path: &Path) -> Read<Vec<u8>> {
    let shown = path.display().to_string();
    if path.is_dir() {
        return Err(error!("input-is-folder", folder = shown, files = listed(&files_in(path))).into());
    }
    if !path.exists() {
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let hint = find_or_create(path.parent().unwrap_or(Path::new("")), &name);
        return Err(error!("input-missing", file = shown).hint(hint).into());
    }
    let file = files::open(path);
    let file = file.map_err(|e| error!("cannot-read-file", file = shown, reason = e.to_string()))?;
    Ok(bounded(file.take(files::LARGEST + 1), &shown)?)
}

/// Maximum number of bytes of a text that a proposal reads.
const LONGEST_PROPOSED: u64 = if cfg!(test) { 64 << 10 } else { 16 << 20 };

/// Bytes of a file for a proposal, and `true` if they are only a part of it: the first lines of a
/// long text, and its last line if that is not a row of numbers.
pub(crate) fn read_start(path: &Path) -> Read<(Vec<u8>, bool)> {
    if !std::fs::metadata(path).is_ok_and(|of| of.is_file() && of.len() > LONGEST_PROPOSED) {
        return read_bytes(path).map(|bytes| (bytes, false));
    }
    let shown = path.display().to_string();
    let failed = |e: io::Error| error!("cannot-read-file", file = shown, reason = e.to_string());
    let mut file = files::open(path).map_err(failed)?;
    let mut bytes = bounded(file.by_ref().take(LONGEST_PROPOSED), &shown)?;
    let end = bytes.iter().rposition(|byte| *byte == b'\n');
    // characters of two bytes, and documents, are read as a whole
    let (Some(end), false) = (end, is_document(&bytes) || bytes[..4096.min(bytes.len())].contains(&0)) else {
        return read_bytes(path).map(|bytes| (bytes, false));
    };
    bytes.truncate(end + 1);
    file.seek(SeekFrom::End(-(TAIL as i64))).map_err(failed)?;
    let mut tail = Vec::new();
    file.take(TAIL as u64).read_to_end(&mut tail).map_err(failed)?;
    let mut lines = tail.split(|byte| *byte == b'\n').rev();
    let last = lines.find(|line| !line.trim_ascii().is_empty()).unwrap_or_default();
    if !last.iter().any(u8::is_ascii_digit) {
        bytes.extend(last);
        bytes.push(b'\n');
    }
    Ok((bytes, true))
}

/// Number of bytes in which the last line of a text is looked for.
const TAIL: usize = 4096;

/// Hint for a missing file: the existing file with a similar name, or a way to create the file.
fn find_or_create(folder: &Path, wrong: &str) -> Phrase {
    let names = files_in(folder);
    let truth = folder.ancestors().map(|folder| folder.join("truth.toml")).find(|truth| truth.is_file());
    match (nearest(wrong, names.iter().map(String::as_str)), truth) {
        (Some(name), _) => phrase!("did-you-mean", name),
        (None, Some(truth)) => {
            let campaign = truth.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
            phrase!("simulate-the-file", folder = campaign.display().to_string())
        }
        (None, None) if names.is_empty() => phrase!("place-the-file"),
        (None, None) => phrase!("name-a-file", files = listed(&names)),
    }
}

/// Names of the first files, with `...` if there are more.
fn listed(names: &[String]) -> Vec<&str> {
    let first = names.iter().take(12).map(String::as_str);
    first.chain((names.len() > 12).then_some("...")).collect()
}

/// Names of the files in a folder, sorted.
fn files_in(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten().filter(|e| e.path().is_file());
    let mut names: Vec<String> = files.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Maximum length of a line of text (bytes).
const LONGEST_LINE: usize = 1 << 20;
/// Maximum length of a line of XML, of a workbook, a recording or a PLY file (bytes).
const LONGEST_XML: usize = 256 << 20;
/// Number of bytes that are read at a time.
const PIECE: usize = 1 << 20;

/// Reads all bytes of a file with lines.
///
/// # Errors
/// Fails if the file cannot be read, or at the first line that is too long; the rest of the file is
/// then not read.
fn bounded(mut from: impl io::Read, file: &str) -> Result<Vec<u8>, Message> {
    let mut bytes = Vec::new();
    let (mut number, mut start) = (1, 0);
    let mut longest = LONGEST_LINE;
    let too_long = |line: usize, longest: usize| error!("line-too-long", file, line, most_mib = longest >> 20);
    loop {
        let before = bytes.len();
        let piece = from.by_ref().take(PIECE as u64).read_to_end(&mut bytes);
        if piece.map_err(|e| error!("cannot-read-file", file, reason = e.to_string()))? == 0 {
            return Ok(bytes);
        }
        if bytes.len() as u64 > files::LARGEST {
            return Err(error!("file-too-large", file, most_mib = files::LARGEST >> 20));
        }
        if before == 0 {
            refuse(&bytes, file)?;
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

/// XML, a zip archive, a recording, arrays, or a format whose files may be binary.
fn is_document(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    text.starts_with(b"<")
        || bytes.starts_with(b"PK\x03\x04")
        || binary_format(bytes).is_some()
        || ros_bag::is_recording(bytes)
        || magic::arrays(bytes).is_some()
}

/// First bytes of kinds of files without text, and the kind.
const KINDS: [(&[u8], &str); 16] = [
    (b"MATLAB 7.3 MAT-file", "matlab-hdf5"),
    (b"\x89HDF", "hdf5"),
    (b"\x1f\x8b", "gzip"),
    (b"\xd0\xcf\x11\xe0", "xls"),
    (b"%PDF", "pdf"),
    (b"#ROSBAG V2.0", "rosbag1"),
    (b"\x89PNG", "image"),
    (b"\xff\xd8\xff", "image"),
    (b"GIF8", "image"),
    (b"\x80\x02", "pickle"),
    (b"\x80\x03", "pickle"),
    (b"\x80\x04", "pickle"),
    (b"\x80\x05", "pickle"),
    (b"7z\xbc\xaf", "archive"),
    (b"Rar!", "archive"),
    (b"\xfd7zXZ", "archive"),
];

/// Rejects a kind of file without text.
fn refuse(bytes: &[u8], file: &str) -> Result<(), Message> {
    match KINDS.into_iter().find(|(start, _)| bytes.starts_with(start)) {
        Some((_, kind)) => Err(error!("file-not-text", file, kind)),
        None => Ok(()),
    }
}

fn coding(encoding: Encoding) -> &'static encoding_rs::Encoding {
    match encoding {
        Encoding::Utf8 => encoding_rs::UTF_8,
        Encoding::Utf16Le => encoding_rs::UTF_16LE,
        Encoding::Utf16Be => encoding_rs::UTF_16BE,
        Encoding::Windows1252 => encoding_rs::WINDOWS_1252,
        Encoding::Windows1250 => encoding_rs::WINDOWS_1250,
        Encoding::Windows1251 => encoding_rs::WINDOWS_1251,
        Encoding::ShiftJis => encoding_rs::SHIFT_JIS,
        Encoding::EucJp => encoding_rs::EUC_JP,
        Encoding::Gb18030 => encoding_rs::GB18030,
        Encoding::Big5 => encoding_rs::BIG5,
        Encoding::EucKr => encoding_rs::EUC_KR,
    }
}

/// Returns the encoding that the first bytes give, and the number of these bytes.
fn mark(bytes: &[u8]) -> Option<(Encoding, usize)> {
    let (marked, length) = encoding_rs::Encoding::for_bom(bytes)?;
    let all = [Encoding::Utf8, Encoding::Utf16Le, Encoding::Utf16Be];
    all.into_iter().find(|encoding| coding(*encoding) == marked).map(|encoding| (encoding, length))
}

/// Text of a file without its byte-order mark; lines end with a line feed, or with carriage return
/// and line feed.
///
/// # Errors
/// Fails if a byte does not belong to the encoding, if the mark names another encoding than the
/// campaign, or if the text contains a NUL.
pub fn decode(bytes: Vec<u8>, stated: Option<Encoding>) -> Result<String, Message> {
    let marked = mark(&bytes);
    let encoding = match (stated, marked) {
        (Some(stated), Some((marked, _))) if stated != marked => {
            return Err(error!("encoding-differs", of_file = marked.name(), stated = stated.name()));
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
                let message = not_in_encoding(body, at, skipped, encoding);
                with_guess(message, body, at, encoding)
            })?
        }
    };
    if let Some(at) = text.find('\0') {
        return Err(error!("nul-byte", line = line_number(text.as_bytes(), at)));
    }
    Ok(line_ends(text))
}

fn line_number(bytes: &[u8], at: usize) -> usize {
    bytes[..at].iter().filter(|b| **b == b'\n').count() + 1
}

/// Error for the byte `at` of the text after a byte-order mark of `skipped` bytes.
fn not_in_encoding(bytes: &[u8], at: usize, skipped: usize, encoding: Encoding) -> Message {
    let hex = format!("0x{:02X}", bytes.get(at).copied().unwrap_or_default());
    error!("encoding-invalid", byte = skipped + at, line = line_number(bytes, at), hex, encoding = encoding.name())
}

fn not_utf8(bytes: &[u8], at: usize) -> Message {
    with_guess(not_in_encoding(bytes, at, 0, Encoding::Utf8), bytes, at, Encoding::Utf8)
}

/// Adds the hint of the encoding that the bytes seem to have, with the text at the byte `at` in
/// this encoding.
fn with_guess(message: Message, bytes: &[u8], at: usize, refused: Encoding) -> Message {
    let Some(guessed) = guessed_encoding(bytes).filter(|guessed| *guessed != refused) else { return message };
    let wide = matches!(guessed, Encoding::Utf16Le | Encoding::Utf16Be);
    let end = bytes[at..].iter().position(|b| b.is_ascii() && !b.is_ascii_alphanumeric() && !wide);
    let sample = &bytes[at..end.map_or(bytes.len(), |end| at + end)];
    let (text, _) = coding(guessed)
        .decode_without_bom_handling(&sample[..sample.len().min(24) & !1 | usize::from(sample.len() == 1)]);
    let sample: String = text.chars().filter(|c| !c.is_control() && *c != '\u{fffd}').take(8).collect();
    message.hint(phrase!("encoding-guessed", encoding = guessed.name(), sample))
}

/// Encoding that bytes without a byte-order mark seem to have, if they are not UTF-8; `None` for
/// bytes that no encoding reads.
///
/// UTF-16 has a zero in every second byte. Of the encodings with two bytes a character, the one in
/// which nearly all of these are frequent characters: kana and the first level of JIS X 0208, or
/// the first level of GB 2312.
pub(crate) fn guessed_encoding(bytes: &[u8]) -> Option<Encoding> {
    let nul = |odd: usize| bytes.iter().skip(odd).step_by(2).filter(|b| **b == 0).count() * 8 > bytes.len() * 3;
    match (nul(1), nul(0)) {
        (true, false) => return Some(Encoding::Utf16Le),
        (false, true) => return Some(Encoding::Utf16Be),
        _ => {}
    }
    let frequent = |encoding: Encoding, is_frequent: &dyn Fn(u8, u8) -> bool| {
        let text = decoded(bytes, encoding).ok()?;
        let mut pairs = (0usize, 0usize);
        let mut rest = bytes.iter();
        while let Some(first) = rest.next() {
            let single = first.is_ascii() || encoding == Encoding::ShiftJis && (0xa1..=0xdf).contains(first);
            if single {
                continue;
            }
            let second = *rest.next()?;
            pairs = (pairs.0 + 1, pairs.1 + usize::from(is_frequent(*first, second)));
        }
        (pairs.0 > 0 && pairs.1 * 10 >= pairs.0 * 9 && !text.contains('\0')).then_some(encoding)
    };
    let japanese = |first: u8, _| matches!(first, 0x81..=0x84 | 0x88..=0x97);
    let chinese = |first: u8, second: u8| matches!(first, 0xa1..=0xa3 | 0xb0..=0xd7) && second >= 0xa1;
    frequent(Encoding::ShiftJis, &japanese)
        .or_else(|| frequent(Encoding::Gb18030, &chinese))
        .or_else(|| decoded(bytes, Encoding::Windows1252).is_ok().then_some(Encoding::Windows1252))
}

/// The text of bytes, or the first byte that does not belong to the encoding.
fn decoded(bytes: &[u8], encoding: Encoding) -> Result<String, usize> {
    let mut decoder = coding(encoding).new_decoder_without_bom_handling();
    let mut text = String::with_capacity(decoder.max_utf8_buffer_length(bytes.len()).unwrap_or(0));
    match decoder.decode_to_string_without_replacement(bytes, &mut text, true) {
        (DecoderResult::Malformed(length, behind), read) => Err(read.saturating_sub(usize::from(length + behind))),
        // five bytes of windows-1252 have no meaning; browsers read them as control characters
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

    /// Reader of this number of bytes, followed by `end`; counts the bytes taken.
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
        let error = bounded(&mut endless, "f").unwrap_err();
        assert!(error.is("line-too-long", &[("line", &1), ("most_mib", &1)]), "{error}");
        assert!(endless.taken <= 4 * PIECE && begun.elapsed().as_secs() < 60, "{} bytes read", endless.taken);
    }

    #[test]
    fn lines_are_counted_and_returned_whole() {
        let text = "1 2 3\r\n".repeat(500_000);
        assert_eq!(bounded(text.as_bytes(), "f").unwrap(), text.as_bytes());
        let long = text.clone() + &"x".repeat(LONGEST_LINE + 1) + "\n1 2 3\n";
        assert!(bounded(long.as_bytes(), "f").unwrap_err().is("line-too-long", &[("line", &500_001)]));
        let xml = "<a>".to_owned() + &" ".repeat(3 * LONGEST_LINE) + "</a>";
        assert_eq!(bounded(xml.as_bytes(), "f").unwrap().len(), xml.len());
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
        let error = |bytes: &[u8], stated| decode(bytes.to_vec(), stated).unwrap_err();
        let is_invalid = |bytes: &[u8], stated, byte: usize, line: usize, encoding: &str| {
            let error = error(bytes, stated);
            assert!(
                error.is("encoding-invalid", &[("byte", &byte), ("line", &line), ("encoding", &encoding)]),
                "{error}"
            );
            error
        };
        let utf8 = is_invalid(b"a\n\xb12.000\n", None, 2, 2, "utf-8");
        let hint = phrase!("encoding-guessed", encoding = "windows-1252", sample = "±2");
        assert!(utf8.is("encoding-invalid", &[("hex", &"0xB1"), ("hint", &hint)]), "{utf8}");
        is_invalid(b"a\n\x81", Some(Encoding::Windows1252), 2, 2, "windows-1252");
        is_invalid(&LE[2..], None, 0, 1, "utf-8");
        is_invalid(b"\xff\xfe1", None, 2, 1, "utf-16le");
        is_invalid(b"\xff\xfe\x00\xd8\x31\x00", None, 2, 1, "utf-16le");
        let stated = error(LE, Some(Encoding::Utf8));
        assert!(stated.is("encoding-differs", &[("of_file", &"utf-16le"), ("stated", &"utf-8")]), "{stated}");
        assert!(error(b"1\x002\x00", None).is("nul-byte", &[("line", &1)]));
    }

    /// As Python's codecs write it.
    const JAPANESE: &[u8] = b"\x97v\x91f\x96\xbc,\x91\xaa\x92\xe8\x92lX\n\x8b\x85_1,1272.6193\n";
    const CHINESE: &[u8] = b"\xb5\xe3\xba\xc5,\xb2\xe2\xc1\xbf\xd6\xb5X\nK1,1272.6193\n";

    #[test]
    fn east_asian_texts_are_read_and_their_encoding_is_found() {
        for (bytes, encoding, text) in [
            (JAPANESE, Encoding::ShiftJis, "要素名,測定値X\n球_1,1272.6193\n"),
            (CHINESE, Encoding::Gb18030, "点号,测量值X\nK1,1272.6193\n"),
        ] {
            assert_eq!(decode(bytes.to_vec(), Some(encoding)).unwrap(), text);
            assert_eq!(guessed_encoding(bytes), Some(encoding));
            for stated in [None, Some(Encoding::Windows1252)] {
                let refused = decode(bytes.to_vec(), stated);
                let hinted = |message: &Message| {
                    message.hint.as_ref().is_some_and(|hint| hint.to_string().contains(encoding.name()))
                };
                // windows-1252 has a letter for nearly every byte
                assert!(refused.as_ref().map_or_else(hinted, |_| stated.is_some()), "{refused:?}");
            }
        }
        for western in ["Größe;Länge;°C\n", "mesuré;±0,1\n", "Ä\n", "señal, año\n"] {
            let (bytes, _, _) = encoding_rs::WINDOWS_1252.encode(western);
            assert_eq!(guessed_encoding(&bytes), Some(Encoding::Windows1252), "{western}");
        }
    }

    #[test]
    fn a_binary_stl_file_is_no_text() {
        let mut bytes = vec![b' '; 80];
        bytes.extend(2u32.to_le_bytes());
        for triangle in 0..2 {
            let normal = [0.0f32, 0.0, 1.0];
            let corners = (0..9).map(|k| 0.5 * (triangle + k) as f32);
            normal.into_iter().chain(corners).for_each(|value| bytes.extend(value.to_le_bytes()));
            bytes.extend([0, 0]);
        }
        let text = |bytes: &[u8]| into_text(Path::new("f"), bytes.to_vec(), None, &Format::default());
        assert!(text(&bytes).unwrap_err().0[0].is("file-not-text", &[("kind", &"stl")]));
        assert!(text(" ".repeat(200).as_bytes()).is_ok());
        let named = into_text(Path::new("f"), bytes, None, &Format::named("stl").unwrap());
        assert_eq!(named.unwrap().chars().count(), 184);
    }

    #[test]
    fn the_first_lines_of_a_long_text_and_a_mark_at_its_end_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long.txt");
        let row = |i: usize| format!("{i};{i}.25;{i}.5\n");
        for (last, read_too) in [("END\n", true), ("1;2.25;3.5\n", false)] {
            let text: String = (0..10_000).map(row).collect::<String>() + last;
            std::fs::write(&path, &text).unwrap();
            let (bytes, is_cut) = read_start(&path).unwrap();
            let read = String::from_utf8(bytes).unwrap();
            assert!(is_cut && read.len() < 70_000, "{}", read.len());
            assert_eq!(read.ends_with("END\n"), read_too);
            let rows = read.lines().filter(|line| *line != "END");
            assert!(rows.enumerate().all(|(i, line)| line == row(i).trim_end()));
        }
        std::fs::write(&path, "1 2 3\n").unwrap();
        assert_eq!(read_start(&path).unwrap(), (b"1 2 3\n".to_vec(), false));
        let wide: Vec<u8> =
            (0..10_000).map(row).collect::<String>().encode_utf16().flat_map(u16::to_le_bytes).collect();
        std::fs::write(&path, &wide).unwrap();
        assert_eq!(read_start(&path).unwrap(), (wide, false));
    }

    #[test]
    fn every_line_end_ends_a_line() {
        for text in ["a\nb\nc", "a\r\nb\nc", "a\rb\rc", "a\r\nb\rc\n"] {
            let text = decode(text.as_bytes().to_vec(), None).unwrap();
            assert_eq!(text.lines().collect::<Vec<_>>(), ["a", "b", "c"]);
        }
    }
}
