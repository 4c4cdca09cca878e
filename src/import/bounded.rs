//! Bytes of a file from anywhere: text has lines, and what has none is not read to its end.

use super::binary;
use crate::base::message::Message;
use std::io::Read;

/// Longer lines are in no measurement.
pub(super) const LONGEST_LINE: usize = 1 << 20;
/// XML may be one line; so may a workbook be called, which is compressed.
const LONGEST_XML: usize = 256 << 20;
/// Read at a time.
const PIECE: usize = 1 << 20;

/// All bytes, if the text in them has lines.
///
/// # Errors
/// If reading fails, or at the first line that is too long: before more than that line is in memory.
pub(super) fn read(mut from: impl Read) -> Result<Vec<u8>, Message> {
    let mut bytes = Vec::new();
    let (mut number, mut start) = (1, 0);
    let mut longest = LONGEST_LINE;
    loop {
        let before = bytes.len();
        let piece = from.by_ref().take(PIECE as u64).read_to_end(&mut bytes);
        if piece.map_err(|e| Message::error(format!("cannot read the file: {e}")))? == 0 {
            return Ok(bytes);
        }
        if before == 0 {
            binary::refuse(&bytes)?;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// So many bytes, then `end`; counts what was taken.
    struct Endless {
        left: usize,
        taken: usize,
    }

    impl Read for &mut Endless {
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
        let said = read(&mut endless).unwrap_err().to_string();
        assert!(said.contains("line 1 is longer than 1 MiB"), "{said}");
        assert!(endless.taken <= 4 * PIECE && begun.elapsed().as_secs_f64() < 1.0, "{} bytes read", endless.taken);
    }

    #[test]
    fn lines_count_and_are_given_back_whole() {
        let text = "1 2 3\r\n".repeat(500_000);
        assert_eq!(read(text.as_bytes()).unwrap(), text.as_bytes());
        let long = text.clone() + &"x".repeat(LONGEST_LINE + 1) + "\n1 2 3\n";
        let said = read(long.as_bytes()).unwrap_err().to_string();
        assert!(said.contains("line 500001 is longer"), "{said}");
        let xml = "<a>".to_owned() + &" ".repeat(3 * LONGEST_LINE) + "</a>";
        assert_eq!(read(xml.as_bytes()).unwrap().len(), xml.len());
    }
}
