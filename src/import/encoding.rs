//! Bytes become text: strictly, in the stated encoding, or in the one that a byte-order mark names.

use crate::base::message::Message;
use crate::import::format::Encoding;

/// Windows-1252 from 0x80 to 0x9F; a blank where it means nothing.
const WINDOWS: &str = "€ ‚ƒ„…†‡ˆ‰Š‹Œ Ž  ‘’“”•–—˜™š›œ žŸ";

/// The encoding that the first bytes name, and how many they are.
fn mark(bytes: &[u8]) -> Option<(Encoding, usize)> {
    match bytes {
        [0xef, 0xbb, 0xbf, ..] => Some((Encoding::Utf8, 3)),
        [0xff, 0xfe, ..] => Some((Encoding::Utf16Le, 2)),
        [0xfe, 0xff, ..] => Some((Encoding::Utf16Be, 2)),
        _ => None,
    }
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
            return Err(Message::error(what).hint("leave `encoding` out: the file says it"));
        }
        (stated, marked) => stated.or(marked.map(|m| m.0)).unwrap_or(Encoding::Utf8),
    };
    let skipped = marked.map_or(0, |m| m.1);
    let body = &bytes[skipped..];
    let wrong = |at: usize| {
        let line = body[..at].iter().filter(|b| **b == b'\n').count() + 1;
        Message::error(format!("byte {} (line {line}) is no {}", skipped + at, encoding.name()))
    };
    let text = match encoding {
        Encoding::Utf8 if skipped == 0 => String::from_utf8(bytes).map_err(|e| {
            let at = e.utf8_error().valid_up_to();
            let line = e.as_bytes()[..at].iter().filter(|b| **b == b'\n').count() + 1;
            let byte = e.as_bytes().get(at).copied().unwrap_or_default();
            let meant = windows(byte).map(|c| format!(": of windows-1252 the byte would be `{c}`")).unwrap_or_default();
            Message::error(format!("the file is not UTF-8 text (byte {at}, line {line}, 0x{byte:02X})"))
                .hint(format!("state how it was written, e.g. `encoding = \"windows-1252\"`{meant}"))
        })?,
        Encoding::Utf8 => std::str::from_utf8(body).map(str::to_owned).map_err(|e| wrong(e.valid_up_to()))?,
        Encoding::Windows1252 => {
            let read = |(at, byte): (usize, &u8)| windows(*byte).ok_or_else(|| wrong(at));
            body.iter().enumerate().map(read).collect::<Result<_, _>>()?
        }
        Encoding::Utf16Le => utf16(body, u16::from_le_bytes).map_err(wrong)?,
        Encoding::Utf16Be => utf16(body, u16::from_be_bytes).map_err(wrong)?,
    };
    if let Some(at) = text.find('\0') {
        let line = text[..at].matches('\n').count() + 1;
        let message = Message::error(format!("the file holds a NUL byte (line {line}): it is damaged or no text"));
        return Err(
            message.hint("UTF-16 without its mark? then state `encoding = \"utf-16le\"`; else export the file again")
        );
    }
    Ok(line_ends(text))
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

fn windows(byte: u8) -> Option<char> {
    match byte {
        0x80..=0x9f => WINDOWS.chars().nth(usize::from(byte - 0x80)).filter(|c| *c != ' '),
        _ => Some(char::from(byte)),
    }
}

/// Text of pairs of bytes; where it fails the byte at which.
fn utf16(body: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, usize> {
    let (pairs, rest) = body.as_chunks::<2>();
    if !rest.is_empty() {
        return Err(body.len() - 1);
    }
    let mut text = String::with_capacity(pairs.len());
    let mut at = 0;
    for read in char::decode_utf16(pairs.iter().map(|pair| unit(*pair))) {
        let c = read.map_err(|_| at)?;
        at += 2 * c.len_utf16();
        text.push(c);
    }
    Ok(text)
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
        assert!(said(b"a\n\x81", Some(Encoding::Windows1252)).contains("byte 2 (line 2) is no windows-1252"));
        assert!(said(LE, Some(Encoding::Utf8)).contains("begins with the mark of utf-16le"));
        assert!(said(&LE[2..], None).contains("not UTF-8"));
        assert!(said(b"1\x002\x00", None).contains("NUL byte (line 1)"));
        assert!(said(b"\xff\xfe1", None).contains("is no utf-16le"));
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
