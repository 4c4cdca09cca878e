//! Parameters as arrays: NumPy's `.npz`, and MATLAB's `.mat` (level 5, uncompressed), which Octave
//! and SciPy read too.
//!
//! Both formats contain `about` (the header lines of a file), `name`, `unit`, `value` and `nominal`
//! of all parameters, `standard_uncertainty` of the parameters whose indices are in `identified`,
//! and `covariance` of the parameters in `covariance_of`. Indices start at 0 in NumPy and at 1 in
//! MATLAB.

use super::{ExportInput, Exporter};
use etalon_base::error;
use etalon_base::message::Result;
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// NumPy's `.npz`, an archive of `.npy`.
pub(super) struct Npz;

/// MATLAB's `.mat` of level 5.
pub(super) struct Mat;

/// An array with its name.
struct Array {
    name: &'static str,
    content: Content,
}

enum Content {
    Texts(Vec<String>),
    Numbers(Vec<f64>),
    /// Indices of parameters, from 0.
    Places(Vec<usize>),
    /// Symmetric matrix, row by row.
    Matrix(Vec<Vec<f64>>),
}

fn arrays(given: &ExportInput) -> Result<Vec<Array>> {
    let document = given.parameters;
    let all = &document.parameters;
    let places =
        |wanted: &dyn Fn(&str) -> bool| Content::Places((0..all.len()).filter(|&i| wanted(&all[i].name)).collect());
    let in_covariance: Vec<&str> = match document.covariance.as_slice() {
        [] => Vec::new(),
        _ => document.identified().map(|p| p.name.as_str()).collect(),
    };
    let identified: Vec<&str> =
        all.iter().filter(|p| p.standard_uncertainty.is_some()).map(|p| p.name.as_str()).collect();
    let array = |name, content| Array { name, content };
    Ok(vec![
        array("about", Content::Texts(given.header("mm, deg, 1")?)),
        array("name", Content::Texts(all.iter().map(|p| p.name.clone()).collect())),
        array("unit", Content::Texts(all.iter().map(|p| p.unit.clone()).collect())),
        array("value", Content::Numbers(all.iter().map(|p| p.value).collect())),
        array("nominal", Content::Numbers(all.iter().map(|p| p.nominal).collect())),
        array("identified", places(&|name| identified.contains(&name))),
        array("standard_uncertainty", Content::Numbers(all.iter().filter_map(|p| p.standard_uncertainty).collect())),
        array("covariance_of", places(&|name| in_covariance.contains(&name))),
        array("covariance", Content::Matrix(document.covariance.clone())),
    ])
}

fn encode<const N: usize, T: Copy>(values: &[T], bytes: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|value| bytes(*value)).collect()
}

impl Exporter for Npz {
    fn name(&self) -> &'static str {
        "numpy"
    }

    fn file_name(&self) -> &'static str {
        "etalon_parameters.npz"
    }

    fn is_for_controllers(&self) -> bool {
        false
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        // without a time, so that equal parameters give equal bytes
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(zip::DateTime::default());
        let failed = |e: &dyn std::fmt::Display| error!("cannot-encode", format = "NPZ", reason = e.to_string());
        for array in arrays(given)? {
            archive.start_file(format!("{}.npy", array.name), options).map_err(|e| failed(&e))?;
            archive.write_all(&npy(&array.content)).map_err(|e| failed(&e))?;
        }
        Ok(archive.finish().map_err(|e| failed(&e))?.into_inner())
    }
}

/// Encodes an array in NumPy's format 1.0.
fn npy(content: &Content) -> Vec<u8> {
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
        Content::Places(places) => {
            let data = encode(places, |place| (place as u64).to_le_bytes());
            ("<u8".to_owned(), format!("({},)", places.len()), data)
        }
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
    let mut out = b"\x93NUMPY\x01\x00".to_vec();
    out.extend((header.len() as u16).to_le_bytes());
    out.extend(header.as_bytes());
    out.extend(data);
    out
}

/// Data types of a MAT-file of level 5.
const INT8: u32 = 1;
const INT32: u32 = 5;
const UINT32: u32 = 6;
const DOUBLE: u32 = 9;
const MATRIX: u32 = 14;
const UTF16: u32 = 17;
/// Array classes of a MAT-file of level 5.
const CELLS: u32 = 1;
const CHARACTERS: u32 = 4;
const DOUBLES: u32 = 6;

impl Exporter for Mat {
    fn name(&self) -> &'static str {
        "mat"
    }

    fn file_name(&self) -> &'static str {
        "etalon_parameters.mat"
    }

    fn is_for_controllers(&self) -> bool {
        false
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let version = super::comment(&given.parameters.provenance.version);
        let mut out: Vec<u8> = format!("MATLAB 5.0 MAT-file, written by etalon {version}").into_bytes();
        out.resize(124, b' ');
        out.extend([0x00, 0x01, b'I', b'M']);
        for array in arrays(given)? {
            out.extend(match array.content {
                Content::Texts(texts) => {
                    let cells: Vec<u8> = texts.iter().flat_map(|text| characters(text)).collect();
                    matrix(CELLS, [texts.len(), 1], array.name, &cells)
                }
                Content::Numbers(numbers) => doubles([numbers.len(), 1], array.name, &numbers),
                Content::Places(places) => {
                    let places: Vec<f64> = places.iter().map(|place| (place + 1) as f64).collect();
                    doubles([places.len(), 1], array.name, &places)
                }
                Content::Matrix(rows) => doubles([rows.len(), rows.len()], array.name, &rows.concat()),
            });
        }
        Ok(out)
    }
}

fn characters(text: &str) -> Vec<u8> {
    let units: Vec<u16> = text.encode_utf16().collect();
    matrix(CHARACTERS, [1, units.len()], "", &element(UTF16, &encode(&units, u16::to_le_bytes)))
}

fn doubles(size: [usize; 2], name: &str, values: &[f64]) -> Vec<u8> {
    matrix(DOUBLES, size, name, &element(DOUBLE, &encode(values, f64::to_le_bytes)))
}

fn matrix(class: u32, size: [usize; 2], name: &str, data: &[u8]) -> Vec<u8> {
    let mut inside = element(UINT32, &encode(&[class, 0], u32::to_le_bytes));
    inside.extend(element(INT32, &encode(&size, |n| (n as u32).to_le_bytes())));
    inside.extend(element(INT8, name.as_bytes()));
    inside.extend(data);
    element(MATRIX, &inside)
}

/// A tag and its data, padded to a multiple of eight bytes.
fn element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut out = encode(&[kind, data.len() as u32], u32::to_le_bytes);
    out.extend(data);
    out.resize(out.len().next_multiple_of(8), 0);
    out
}
