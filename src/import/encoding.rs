//! Bytes become text: strictly, in the stated encoding, or in the one that a byte-order mark names.

use crate::base::message::Message;
use crate::import::format::Encoding;
use encoding_rs::{DecoderResult, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

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
