//! Arrays of NumPy: `.npy` (NEP 1), and `.npz`, a zip archive of `.npy` files.
//!
//! A column is given as in Python: `t` of one axis, `q[:,0]` of two. The array of an `.npy` file
//! has no name: `[:,0]`.

use super::arrays::{self, Array, ArrayFile, ArrayParts, Content, LARGEST, NewArray, Numbers, Spelling, encode};
use super::{About, LogFormat};
use crate::magic;
use crate::unpack::Budget;
use etalon_base::error;
use etalon_base::message::Message;
use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Arrays of NumPy.
pub(super) struct Numpy;

const SPELLING: Spelling = Spelling { open: '[', close: ']', first: 0 };

impl LogFormat for Numpy {
    fn about(&self) -> About {
        About {
            name: "numpy",
            title: "NumPy",
            description: "Arrays of NumPy (.npz, .npy): columns are written as in Python, q[:,0].",
        }
    }

    fn has_stable_order(&self) -> bool {
        false
    }

    fn holds(&self, bytes: &[u8]) -> bool {
        magic::arrays(bytes) == Some("numpy")
    }

    fn has_arrays(&self) -> bool {
        true
    }

    fn arrays(&self, file: &ArrayFile) -> Result<Vec<ArrayParts>, Message> {
        Ok(SPELLING.parts(&arrays(file.bytes)?))
    }

    fn table(&self, file: &ArrayFile, wanted: &[&str]) -> Option<Result<String, Message>> {
        Some(arrays(file.bytes).and_then(|arrays| arrays::table(&arrays, wanted, SPELLING)))
    }
}

/// Returns the arrays of a file. Arrays of other things than numbers are omitted.
fn arrays(bytes: &[u8]) -> Result<Vec<Array>, Message> {
    if bytes.starts_with(magic::NUMPY) {
        let array = array("", bytes)?;
        return Ok(array.into_iter().collect());
    }
    let damaged = || error!("arrays-unreadable", format = "numpy");
    let mut budget = Budget::new("arrays", bytes.len(), LARGEST);
    let mut archive = budget.open(bytes, |_| damaged())?;
    let mut all = Vec::new();
    for i in 0..archive.len() {
        let file = archive.by_index(i).map_err(|_| damaged())?;
        let name = file.name().map_err(|_| damaged())?.strip_suffix(".npy").map(str::to_owned);
        let Some(name) = name else { continue };
        all.extend(array(&name, &budget.read(file, damaged)?)?);
    }
    Ok(all)
}

/// Reads an array; `None` if it holds other things than real numbers.
fn array(name: &str, bytes: &[u8]) -> Result<Option<Array>, Message> {
    let damaged = || error!("arrays-unreadable", format = "numpy");
    let (head, data) = head(bytes).ok_or_else(damaged)?;
    let descr = header_value(head, "descr").ok_or_else(damaged)?;
    let shape = shape(header_value(head, "shape").ok_or_else(damaged)?).ok_or_else(damaged)?;
    let by_columns = header_value(head, "fortran_order").ok_or_else(damaged)?.starts_with("True");
    let Some(kind) = descr.strip_prefix(['\'', '"']).and_then(|text| text.split(['\'', '"']).next()) else {
        return Ok(None);
    };
    let count = shape.iter().try_fold(1_usize, |all, n| all.checked_mul(*n)).ok_or_else(damaged)?;
    // no column is a part of more than two axes: pictures beside the measurements stay packed
    if shape.len() > 2 {
        return Ok(Some(Array { name: name.to_owned(), shape, numbers: Numbers::Whole(Vec::new()), by_columns }));
    }
    let is_big_endian = kind.starts_with('>');
    let numbers = match kind.trim_start_matches(['<', '>', '|', '=']) {
        "f8" => real(data, is_big_endian, f64::from_le_bytes),
        "f4" => real(data, is_big_endian, |b| f64::from(f32::from_le_bytes(b))),
        "i8" | "M8[ns]" => whole(data, is_big_endian, i64::from_le_bytes),
        "i4" => whole(data, is_big_endian, |b| i64::from(i32::from_le_bytes(b))),
        "i2" => whole(data, is_big_endian, |b| i64::from(i16::from_le_bytes(b))),
        "i1" => whole(data, is_big_endian, |b| i64::from(i8::from_le_bytes(b))),
        "u8" => real(data, is_big_endian, |b| u64::from_le_bytes(b) as f64),
        "u4" => whole(data, is_big_endian, |b| i64::from(u32::from_le_bytes(b))),
        "u2" => whole(data, is_big_endian, |b| i64::from(u16::from_le_bytes(b))),
        "u1" | "b1" => whole(data, is_big_endian, |b: [u8; 1]| i64::from(b[0])),
        _ => return Ok(None),
    };
    let found = match &numbers {
        Numbers::Real(values) => values.len(),
        Numbers::Whole(values) => values.len(),
    };
    if found != count {
        return Err(damaged());
    }
    Ok(Some(Array { name: name.to_owned(), shape, numbers, by_columns }))
}

/// Splits a file into its header, a Python dictionary, and its data.
fn head(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let behind = bytes.strip_prefix(magic::NUMPY)?;
    let (version, behind) = behind.split_first_chunk::<2>()?;
    let (length, behind) = match version[0] {
        1 => behind.split_first_chunk::<2>().map(|(n, rest)| (u16::from_le_bytes(*n) as usize, rest))?,
        2 | 3 => behind.split_first_chunk::<4>().map(|(n, rest)| (u32::from_le_bytes(*n) as usize, rest))?,
        _ => return None,
    };
    let (head, data) = behind.split_at_checked(length)?;
    Some((std::str::from_utf8(head).ok()?, data))
}

/// Returns the text behind a key of the header.
fn header_value<'t>(head: &'t str, key: &str) -> Option<&'t str> {
    let (_, behind) = head.split_once(&format!("'{key}':"))?;
    Some(behind.trim_start())
}

fn shape(text: &str) -> Option<Vec<usize>> {
    let (inside, _) = text.strip_prefix('(')?.split_once(')')?;
    inside.split(',').map(str::trim).filter(|n| !n.is_empty()).map(|n| n.parse().ok()).collect()
}

/// Returns the numbers of the bytes, if their count is a multiple of the size.
fn numbers<const N: usize, T>(data: &[u8], is_big_endian: bool, of: impl Fn([u8; N]) -> T) -> Vec<T> {
    let number = |bytes: &[u8; N]| {
        let mut bytes = *bytes;
        if is_big_endian {
            bytes.reverse();
        }
        of(bytes)
    };
    data.as_chunks::<N>().0.iter().map(number).collect()
}

fn real<const N: usize>(data: &[u8], is_big_endian: bool, of: impl Fn([u8; N]) -> f64) -> Numbers {
    Numbers::Real(numbers(data, is_big_endian, of))
}

fn whole<const N: usize>(data: &[u8], is_big_endian: bool, of: impl Fn([u8; N]) -> i64) -> Numbers {
    Numbers::Whole(numbers(data, is_big_endian, of))
}

/// Returns arrays as an archive (`.npz`).
pub fn write(arrays: &[NewArray]) -> std::io::Result<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    // without a time, so that equal arrays give equal bytes
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(zip::DateTime::default());
    for array in arrays {
        archive.start_file(format!("{}.npy", array.name), options)?;
        archive.write_all(&write_array(&array.content))?;
    }
    Ok(archive.finish()?.into_inner())
}

/// Returns an array as a file of format 1.0.
fn write_array(content: &Content) -> Vec<u8> {
    let (kind, shape, data) = match content {
        Content::Texts(texts) => {
            let longest = texts.iter().map(|text| text.chars().count()).max().unwrap_or(1).max(1);
            let padded = texts.iter().flat_map(|text| text.chars().chain(std::iter::repeat('\0')).take(longest));
            let characters: Vec<u32> = padded.map(u32::from).collect();
            (format!("<U{longest}"), format!("({},)", texts.len()), encode(&characters, u32::to_le_bytes))
        }
        Content::Numbers(numbers) => {
            ("<f8".to_owned(), format!("({},)", numbers.len()), encode(numbers, f64::to_le_bytes))
        }
        Content::Counts(counts) => ("<u8".to_owned(), format!("({},)", counts.len()), encode(counts, u64::to_le_bytes)),
        Content::Matrix(rows) => {
            let shape = format!("({0}, {0})", rows.len());
            ("<f8".to_owned(), shape, encode(&rows.concat(), f64::to_le_bytes))
        }
    };
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // data start at a multiple of 64 bytes
    let padding = 63 - (10 + header.len()) % 64;
    header.extend(std::iter::repeat_n(' ', padding));
    header.push('\n');
    let mut out = [magic::NUMPY, &[1, 0]].concat();
    out.extend((header.len() as u16).to_le_bytes());
    out.extend(header.as_bytes());
    out.extend(data);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawn_arrays_read_back_bit_for_bit() {
        arrays::tests::read_back(|drawn| arrays(&write(drawn).unwrap()).unwrap(), 0);
    }

    /// A file by NEP 1.
    fn npy(kind: &str, order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
        let mut head = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}");
        head += &" ".repeat(63 - (10 + head.len()) % 64);
        head.push('\n');
        [magic::NUMPY, b"\x01\x00", &(head.len() as u16).to_le_bytes(), head.as_bytes(), data].concat()
    }

    fn text(bytes: &[u8], wanted: &[&str]) -> Result<String, Message> {
        Numpy.table(&bytes.into(), wanted).unwrap()
    }

    #[test]
    fn arrays_of_every_type_and_order_are_read() {
        let six: Vec<u8> = (1..=6).flat_map(|i| f64::from(i).to_le_bytes()).collect();
        assert_eq!(text(&npy("<f8", "False", "(2, 3)", &six), &["[:,1]"]).unwrap(), "[:,1]\n2\n5\n");
        assert_eq!(text(&npy("<f8", "True", "(2, 3)", &six), &["[:,1]"]).unwrap(), "[:,1]\n3\n4\n");
        let big: Vec<u8> = [0.5_f32, -2.0].iter().flat_map(|v| v.to_be_bytes()).collect();
        assert_eq!(text(&npy(">f4", "False", "(2,)", &big), &[""]).unwrap(), "\n0.5\n-2\n");
        let time = 1_651_499_784_376_123_456_i64.to_le_bytes();
        assert_eq!(text(&npy("<i8", "False", "(1, 1)", &time), &["[:,0]"]).unwrap(), "[:,0]\n1651499784376123456\n");
        let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for (name, bytes) in [
            ("t.npy", npy("|u1", "False", "(2,)", &[7, 9])),
            ("q.npy", npy("<f8", "False", "(2, 3)", &six)),
            ("s.npy", npy("<U1", "False", "(2,)", &[0; 8])),
        ] {
            archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
            archive.write_all(&bytes).unwrap();
        }
        let bytes = archive.finish().unwrap().into_inner();
        assert!(Numpy.holds(&bytes) && !Numpy.holds(b"PK\x03\x04"));
        assert_eq!(text(&bytes, &["t", "q[:,2]"]).unwrap(), "t\tq[:,2]\n7\t3\n9\t6\n");
        assert!(text(&bytes, &["s"]).unwrap_err().is("array-missing", &[]));
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 0xff;
            let _ = (text(&damaged, &["t", "q[:,2]"]), text(&bytes[..at], &["t"]));
        }
    }

    #[test]
    fn damaged_arrays_are_refused() {
        let short = npy("<f8", "False", "(3,)", &[0; 16]);
        assert!(text(&short, &["[:,0]"]).unwrap_err().is("arrays-unreadable", &[]));
        assert!(text(&short[..30], &["[:,0]"]).unwrap_err().is("arrays-unreadable", &[]));
        let huge = npy("<f8", "False", "(4611686018427387904, 8)", &[0; 16]);
        assert!(text(&huge, &["[:,0]"]).unwrap_err().is("arrays-unreadable", &[]));
    }
}
