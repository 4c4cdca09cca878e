//! Variables of MATLAB: `.mat` of level 5, uncompressed (`-v6`) or compressed (`-v7`, the default
//! of `save`).
//!
//! A column is given as in MATLAB: `t` of a vector, `q(:,1)` of a matrix, `data.q(:,1)` of a
//! structure. Source: MathWorks, "MAT-File Format", chapter 1 (level 5).

use super::arrays::{self, Array, ArrayFile, ArrayParts, Content, LARGEST, NewArray, Numbers, Spelling, encode};
use super::{About, LogFormat};
use crate::magic;
use crate::unpack::Budget;
use etalon_base::error;
use etalon_base::message::Message;
use std::io::Read as _;

/// Variables of MATLAB.
pub(super) struct Matlab;

const SPELLING: Spelling = Spelling { open: '(', close: ')', first: 1 };

/// Maximum depth of structures in structures.
const DEEPEST: usize = 16;

impl LogFormat for Matlab {
    fn about(&self) -> About {
        About {
            name: "matlab",
            title: "MATLAB",
            description: "Variables of MATLAB (.mat, -v6 and -v7): columns are written as in MATLAB, q(:,1).",
        }
    }

    fn has_stable_order(&self) -> bool {
        false
    }

    fn holds(&self, bytes: &[u8]) -> bool {
        magic::arrays(bytes) == Some("matlab")
    }

    fn has_arrays(&self) -> bool {
        true
    }

    fn arrays(&self, file: &ArrayFile) -> Result<Vec<ArrayParts>, Message> {
        Ok(SPELLING.parts(&variables(file.bytes)?))
    }

    fn table(&self, file: &ArrayFile, wanted: &[&str]) -> Option<Result<String, Message>> {
        Some(variables(file.bytes).and_then(|arrays| arrays::table(&arrays, wanted, SPELLING)))
    }
}

/// Data types of elements.
mod element {
    pub const INT8: u32 = 1;
    pub const INT32: u32 = 5;
    pub const UINT32: u32 = 6;
    pub const DOUBLE: u32 = 9;
    pub const MATRIX: u32 = 14;
    pub const COMPRESSED: u32 = 15;
    pub const UTF16: u32 = 17;
}

/// Classes of matrices; classes from 6 to 15 are numbers.
const CELLS: u8 = 1;
const STRUCTURE: u8 = 2;
const CHARACTERS: u8 = 4;
const DOUBLES: u8 = 6;

fn damaged() -> Message {
    error!("arrays-unreadable", format = "matlab")
}

/// Returns the numeric variables of a file, and of its structures. Others are omitted.
fn variables(bytes: &[u8]) -> Result<Vec<Array>, Message> {
    let is_big_endian = match bytes.get(126..128) {
        Some(b"IM") => false,
        Some(b"MI") => true,
        _ => return Err(damaged()),
    };
    let mut left = Elements { bytes: &bytes[128..], is_big_endian };
    let (mut all, mut budget) = (Vec::new(), Budget::new("arrays", bytes.len(), LARGEST));
    while !left.bytes.is_empty() {
        let (kind, data) = left.next().ok_or_else(damaged)?;
        match kind {
            element::MATRIX => matrix(Elements { bytes: data, is_big_endian }, "", 0, &mut all).ok_or_else(damaged)?,
            element::COMPRESSED => {
                let unpacked = unpacked(data, is_big_endian, &mut budget)?;
                let mut inside = Elements { bytes: &unpacked, is_big_endian };
                match inside.next().ok_or_else(damaged)? {
                    (element::MATRIX, data) => {
                        matrix(Elements { bytes: data, is_big_endian }, "", 0, &mut all).ok_or_else(damaged)?;
                    }
                    _ => continue,
                }
            }
            _ => {}
        }
    }
    Ok(all)
}

/// Unpacks the element of a compressed one, whose tag declares its size.
fn unpacked(data: &[u8], is_big_endian: bool, budget: &mut Budget) -> Result<Vec<u8>, Message> {
    let mut decoder = flate2::read::ZlibDecoder::new(data);
    let mut tag = [0; 8];
    decoder.read_exact(&mut tag).map_err(|_| damaged())?;
    let [kind, size] = [0, 4].map(|at| {
        let word = [tag[at], tag[at + 1], tag[at + 2], tag[at + 3]];
        if is_big_endian { u32::from_be_bytes(word) } else { u32::from_le_bytes(word) }
    });
    // a small element has its size in the upper half of the tag
    let declared = if kind >> 16 != 0 { 0 } else { u64::from(size) };
    budget.check(tag.len() as u64 + declared)?;
    // what follows the element belongs to nothing
    budget.read((&tag[..]).chain(decoder.take(declared)), damaged)
}

/// Elements one after the other: a tag, data, padding.
#[derive(Clone, Copy)]
struct Elements<'a> {
    bytes: &'a [u8],
    is_big_endian: bool,
}

impl<'a> Elements<'a> {
    /// Returns the type and the data of the next element.
    fn next(&mut self) -> Option<(u32, &'a [u8])> {
        let (first, behind) = self.bytes.split_first_chunk::<4>()?;
        let tag = self.whole(*first);
        // a small element has its size in the upper half of the tag, and its data behind it
        if tag >> 16 != 0 {
            let (data, rest) = behind.split_at_checked(4)?;
            self.bytes = rest;
            return Some((tag & 0xffff, data.get(..(tag >> 16) as usize)?));
        }
        let (size, behind) = behind.split_first_chunk::<4>()?;
        let size = self.whole(*size) as usize;
        let data = behind.get(..size)?;
        // elements in a matrix end at multiples of eight bytes, compressed ones do not
        let end = if tag == element::COMPRESSED { size } else { size.next_multiple_of(8) };
        self.bytes = behind.get(end.min(behind.len())..)?;
        Some((tag, data))
    }

    fn whole(&self, bytes: [u8; 4]) -> u32 {
        if self.is_big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) }
    }

    fn wholes(&self, data: &[u8]) -> Vec<u32> {
        data.as_chunks::<4>().0.iter().map(|bytes| self.whole(*bytes)).collect()
    }

    /// Returns the numbers of an element of this type.
    fn numbers(&self, kind: u32, data: &[u8]) -> Option<Numbers> {
        fn each<const N: usize, T>(data: &[u8], turn: bool, of: impl Fn([u8; N]) -> T) -> Vec<T> {
            let number = |bytes: &[u8; N]| {
                let mut bytes = *bytes;
                if turn {
                    bytes.reverse();
                }
                of(bytes)
            };
            data.as_chunks::<N>().0.iter().map(number).collect()
        }
        let turn = self.is_big_endian;
        Some(match kind {
            1 => Numbers::Whole(each(data, turn, |b: [u8; 1]| i64::from(b[0].cast_signed()))),
            2 => Numbers::Whole(each(data, turn, |b: [u8; 1]| i64::from(b[0]))),
            3 => Numbers::Whole(each(data, turn, |b| i64::from(i16::from_le_bytes(b)))),
            4 => Numbers::Whole(each(data, turn, |b| i64::from(u16::from_le_bytes(b)))),
            5 => Numbers::Whole(each(data, turn, |b| i64::from(i32::from_le_bytes(b)))),
            6 => Numbers::Whole(each(data, turn, |b| i64::from(u32::from_le_bytes(b)))),
            7 => Numbers::Real(each(data, turn, |b| f64::from(f32::from_le_bytes(b)))),
            9 => Numbers::Real(each(data, turn, f64::from_le_bytes)),
            12 => Numbers::Whole(each(data, turn, i64::from_le_bytes)),
            13 => Numbers::Real(each(data, turn, |b| u64::from_le_bytes(b) as f64)),
            _ => return None,
        })
    }
}

/// Adds the numbers of a matrix, or of the fields of a structure of one element, to `all`.
///
/// Returns `None` if the matrix is malformed.
fn matrix(mut inside: Elements, name_of_field: &str, depth: usize, all: &mut Vec<Array>) -> Option<()> {
    // an empty matrix has no content
    if inside.bytes.is_empty() {
        return Some(());
    }
    let (_, flags) = inside.next()?;
    let flags = *inside.wholes(flags).first()?;
    let (class, is_complex) = ((flags & 0xff) as u8, flags & 0x0800 != 0);
    // an object of a class that the format does not describe has another layout
    if class == 0 || class > 15 {
        return Some(());
    }
    let (_, shape) = inside.next()?;
    let shape: Vec<usize> = inside.wholes(shape).into_iter().map(|n| n as usize).collect();
    let (_, own_name) = inside.next()?;
    let name = if depth == 0 { std::str::from_utf8(own_name).ok()? } else { name_of_field };
    let count = shape.iter().try_fold(1_usize, |all, n| all.checked_mul(*n))?;
    if class == STRUCTURE {
        return if count == 1 && depth < DEEPEST { fields(inside, name, depth, all) } else { Some(()) };
    }
    if class < DOUBLES || is_complex {
        return Some(());
    }
    // no column is a part of more than two axes
    if shape.len() > 2 {
        all.push(Array { name: name.to_owned(), shape, numbers: Numbers::Whole(Vec::new()), by_columns: true });
        return Some(());
    }
    let (kind, data) = inside.next()?;
    let numbers = inside.numbers(kind, data)?;
    let found = match &numbers {
        Numbers::Real(values) => values.len(),
        Numbers::Whole(values) => values.len(),
    };
    (found == count).then(|| all.push(Array { name: name.to_owned(), shape, numbers, by_columns: true }))
}

/// Adds the fields of a structure of one element, each under the name of the structure followed by
/// the name of the field.
fn fields(mut inside: Elements, name: &str, depth: usize, all: &mut Vec<Array>) -> Option<()> {
    let (_, length) = inside.next()?;
    let length = *inside.wholes(length).first()? as usize;
    let (_, names) = inside.next()?;
    if length == 0 {
        return None;
    }
    for field in names.chunks(length) {
        let field = std::str::from_utf8(field.split(|b| *b == 0).next()?).ok()?;
        let (kind, data) = inside.next()?;
        if kind != element::MATRIX {
            return None;
        }
        let content = Elements { bytes: data, is_big_endian: inside.is_big_endian };
        matrix(content, &format!("{name}.{field}"), depth + 1, all)?;
    }
    Some(())
}

/// Returns arrays as an uncompressed file, whose first bytes contain a text.
pub fn write(about: &str, arrays: &[NewArray]) -> Vec<u8> {
    let mut out = [magic::MATLAB, b", ", about.as_bytes()].concat();
    out.resize(124, b' ');
    out.extend([0x00, 0x01, b'I', b'M']);
    for NewArray { name, content } in arrays {
        out.extend(match content {
            Content::Texts(texts) => {
                let cells: Vec<u8> = texts.iter().flat_map(|text| write_text(text)).collect();
                write_matrix(CELLS, [texts.len(), 1], name, &cells)
            }
            Content::Numbers(numbers) => write_numbers([numbers.len(), 1], name, numbers),
            Content::Counts(counts) => {
                let numbers: Vec<f64> = counts.iter().map(|count| *count as f64).collect();
                write_numbers([numbers.len(), 1], name, &numbers)
            }
            // numbers of a column are neighbours
            Content::Matrix(rows) => {
                let columns = (0..rows.len()).flat_map(|j| rows.iter().map(move |row| row[j]));
                write_numbers([rows.len(), rows.len()], name, &columns.collect::<Vec<f64>>())
            }
        });
    }
    out
}

fn write_text(text: &str) -> Vec<u8> {
    let units: Vec<u16> = text.encode_utf16().collect();
    let data = write_element(element::UTF16, &encode(&units, u16::to_le_bytes));
    write_matrix(CHARACTERS, [1, units.len()], "", &data)
}

fn write_numbers(size: [usize; 2], name: &str, values: &[f64]) -> Vec<u8> {
    write_matrix(DOUBLES, size, name, &write_element(element::DOUBLE, &encode(values, f64::to_le_bytes)))
}

fn write_matrix(class: u8, size: [usize; 2], name: &str, data: &[u8]) -> Vec<u8> {
    let flags = write_element(element::UINT32, &encode(&[u32::from(class), 0], u32::to_le_bytes));
    let size = write_element(element::INT32, &encode(&size, |n| (n as u32).to_le_bytes()));
    let name = write_element(element::INT8, name.as_bytes());
    write_element(element::MATRIX, &[&flags, &size, &name, data].concat())
}

/// Returns a tag and its data, padded to a multiple of eight bytes.
fn write_element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut out = encode(&[kind, data.len() as u32], u32::to_le_bytes);
    out.extend(data);
    out.resize(out.len().next_multiple_of(8), 0);
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    #[test]
    fn drawn_arrays_read_back_bit_for_bit() {
        arrays::tests::read_back(|drawn| variables(&write("drawn", drawn)).unwrap(), 1);
    }

    /// An element by the specification, little endian.
    fn element(kind: u32, data: &[u8]) -> Vec<u8> {
        let mut out = [&kind.to_le_bytes()[..], &(data.len() as u32).to_le_bytes(), data].concat();
        out.resize(out.len().next_multiple_of(8), 0);
        out
    }

    fn matrix(class: u32, rows: u32, columns: u32, name: &str, content: &[u8]) -> Vec<u8> {
        let flags = element(6, &[class.to_le_bytes(), [0; 4]].concat());
        let shape = element(5, &[rows.to_le_bytes(), columns.to_le_bytes()].concat());
        element(14, &[flags, shape, element(1, name.as_bytes()), content.to_vec()].concat())
    }

    fn doubles(values: &[f64]) -> Vec<u8> {
        element(9, &values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>())
    }

    fn file(elements: &[Vec<u8>]) -> Vec<u8> {
        let mut out = b"MATLAB 5.0 MAT-file, Platform: GLNXA64".to_vec();
        out.resize(124, b' ');
        out.extend(b"\x00\x01IM");
        out.extend(elements.concat());
        out
    }

    fn packed(element: &[u8]) -> Vec<u8> {
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        encoder.write_all(element).unwrap();
        let data = encoder.finish().unwrap();
        // without padding
        [&15_u32.to_le_bytes()[..], &(data.len() as u32).to_le_bytes(), &data].concat()
    }

    fn text(bytes: &[u8], wanted: &[&str]) -> Result<String, Message> {
        Matlab.table(&bytes.into(), wanted).unwrap()
    }

    fn sample() -> Vec<Vec<u8>> {
        // whole numbers are stored in the smallest type: t in bytes, as a small element
        let small = [&[2, 0, 2, 0][..], &[7, 9, 0, 0]].concat();
        let inside = [element(5, &4_u32.to_le_bytes()), element(1, b"q\0\0\0w\0\0\0")].concat();
        let structure = [inside, matrix(6, 2, 1, "", &doubles(&[0.25, 0.5])), element(14, &[])].concat();
        vec![
            matrix(6, 2, 1, "t", &small),
            matrix(6, 2, 3, "q", &doubles(&[1.0, 4.0, 2.0, 5.0, 3.0, 6.0])),
            matrix(4, 1, 2, "note", &element(16, b"ab")),
            matrix(2, 1, 1, "data", &structure),
        ]
    }

    #[test]
    fn variables_and_fields_are_read_packed_or_not() {
        let all = sample();
        for elements in [all.clone(), all.iter().map(|element| packed(element)).collect()] {
            let bytes = file(&elements);
            assert_eq!(text(&bytes, &["t", "q(:,2)", "data.q"]).unwrap(), "t\tq(:,2)\tdata.q\n7\t2\t0.25\n9\t5\t0.5\n");
            assert!(text(&bytes, &["note"]).unwrap_err().is("array-missing", &[("column", &"note")]));
            assert!(text(&bytes, &["q(:,4)"]).unwrap_err().is("array-part-unknown", &[("shape", &"2 x 3")]));
        }
    }

    #[test]
    fn damaged_files_are_refused_without_a_panic() {
        let bytes = file(&sample());
        assert!(text(&bytes[..200], &["t"]).unwrap_err().is("arrays-unreadable", &[]));
        let packed: Vec<Vec<u8>> = sample().iter().map(|element| packed(element)).collect();
        for bytes in [bytes, file(&packed)] {
            for at in 0..bytes.len() {
                let mut damaged = bytes.clone();
                damaged[at] ^= 0xff;
                let _ = (text(&damaged, &["t", "q(:,1)", "data.q"]), text(&bytes[..at], &["t"]));
            }
        }
    }
}
