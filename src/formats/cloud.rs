//! Fast reader of plain tables: rows of an optional label and x, y, z; cells of other columns are
//! passed, not split. The strict reader reads any other table, and reports each problem with its
//! place.

use super::exports::{Format, Plain, PlainRow};
use super::points::{Line, Point, SharedText};
use crate::dialect::Unit;
use etalon_base::message::{Problems, Result};
use etalon_base::{error, files};
use etalon_fit::PackedPoints;
use etalon_tables::lexer::{LONGEST_LINE, PlainColumn, Scanner, line_feeds};
use indexmap::IndexSet;
use polars::prelude::{Column, DataFrame, Float64Chunked, IntoColumn, UInt32Chunked};
use rayon::prelude::*;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

/// Bytes whose lines are read together; fewer in tests, for more of them.
const BLOCK: u64 = if cfg!(test) { 64 << 10 } else { 8 << 20 };

/// Maximum length of the lines above the data and of the first row (bytes).
const LONGEST_HEAD: usize = 64 << 10;

/// Mark at the beginning of a file in UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Points of a plain table.
#[derive(Clone, Debug)]
pub struct Cloud {
    /// Labels, each once, in the order of their first rows.
    pub labels: Vec<String>,
    /// One row for each point: `label` (index in the labels, 0 if rows have none), `x_mm`, `y_mm`
    /// and `z_mm`.
    pub table: DataFrame,
}

/// Rows of one block.
#[derive(Default)]
struct Part {
    /// Each once, ended by a line feed.
    labels: String,
    label: Vec<u32>,
    /// In the unit of the file.
    xyz: [Vec<f64>; 3],
    /// All rows look like two angles and a distance.
    angles: bool,
    /// Number of lines, and the line (from 0) and the bytes of each row, if wanted.
    lines: u32,
    located: Vec<[u32; 3]>,
}

/// Reads a table of plain rows on all threads; `None` if only the strict reader can read the table
/// or report its problems. Every number is rounded correctly; the result does not depend on the
/// number of threads.
///
/// # Errors
/// Fails if the file cannot be read.
pub fn cloud(path: &Path, format: &Format, unit: Unit) -> Result<Option<Cloud>> {
    let in_mm = |mut part: Part, unit: Unit| {
        if unit.in_mm() != 1.0 {
            part.xyz.iter_mut().flatten().for_each(|value| *value *= unit.in_mm());
        }
        part
    };
    read(path, format, Some(unit), in_mm)?.map(together).transpose()
}

/// Reads the points of a table of plain rows without labels, in half the memory of [`cloud`]; in
/// the unit that the file states, if `unit` is `None`.
///
/// # Errors
/// Fails if the file cannot be read.
pub fn packed_points(path: &Path, format: &Format, unit: Option<Unit>) -> Result<Option<PackedPoints>> {
    let parts = read(path, format, unit, |part, unit| PackedPoints::new(&part.xyz, unit.in_mm()))?;
    Ok(parts.map(|parts| {
        let mut all = PackedPoints::default();
        parts.into_iter().for_each(|part| all.append(part));
        all
    }))
}

/// Lines at the beginning of a text that decide how it is read; `None` if they are not a text, or
/// too long.
fn head(start: &[u8]) -> Option<&str> {
    let whole = start.len() < LONGEST_HEAD;
    let lines = if whole { start.len() } else { start[..LONGEST_HEAD].iter().rposition(|b| *b == b'\n')? + 1 };
    std::str::from_utf8(&start[..lines]).ok()
}

/// Layout of a file for the fast reader, and its unit.
fn layout(start: &[u8], format: &Format, unit: Option<Unit>) -> Option<(Plain, Unit)> {
    let text = start.strip_prefix(BYTE_ORDER_MARK).unwrap_or(start);
    let head = head(text)?;
    let unit = unit.or_else(|| format.stated_unit(head))?;
    let plain = format.plain(head, unit)?;
    let above = (plain.above.0 + start.len() - text.len(), plain.above.1);
    Some((Plain { above, ..plain }, unit))
}

/// Applies `made` to the rows of each block.
fn read<T: Send>(
    path: &Path,
    format: &Format,
    unit: Option<Unit>,
    made: impl Fn(Part, Unit) -> T + Sync,
) -> Result<Option<Vec<T>>> {
    let file = path.display().to_string();
    let fail = |e: std::io::Error| Problems::from(error!("cannot-read-file", file, reason = e.to_string()));
    let size = files::open(path).and_then(|file| file.metadata()).map_err(fail)?.len();
    let mut start = Vec::new();
    let longest = (BYTE_ORDER_MARK.len() + LONGEST_HEAD) as u64;
    files::open(path).and_then(|file| file.take(longest).read_to_end(&mut start)).map_err(fail)?;
    let Some((plain, unit)) = layout(&start, format, unit) else { return Ok(None) };
    let part = |bytes: &mut Vec<u8>, k: u64| {
        read_block(path, k * BLOCK, bytes)?;
        let part = plain.part(Block { bytes, start: k * BLOCK, size, located: false });
        Ok(part.map(|part| (part.angles, made(part, unit))))
    };
    let parts: std::io::Result<Vec<Option<(bool, T)>>> =
        (0..size.div_ceil(BLOCK)).into_par_iter().map_init(Vec::new, part).collect();
    let Some(parts) = parts.map_err(fail)?.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
    if plain.may_be_angles && parts.iter().all(|(angles, _)| *angles) {
        return Ok(None);
    }
    Ok(Some(parts.into_iter().map(|(_, made)| made).collect()))
}

/// Length of a text (bytes) that is worth the fast reader.
const LONG: usize = 1 << 20;

/// Rows of a text like [`Format::read`]; a long table of plain rows is read on all threads.
pub fn rows(format: &Format, file: &str, text: &SharedText, unit: Unit) -> (Vec<Point>, Problems) {
    let long = Some(text).filter(|text| text.len() >= LONG);
    let plain = long.and_then(|text| format.plain(head(text.as_bytes())?, unit));
    match plain.and_then(|plain| points(text, &plain, unit)) {
        Some(points) if !points.is_empty() => (points, Problems::default()),
        _ => format.read(file, text, unit),
    }
}

/// Points of a text of plain rows, read on all threads; `None` if only the strict reader can read
/// the text or report its problems.
fn points(text: &SharedText, plain: &Plain, unit: Unit) -> Option<Vec<Point>> {
    let (bytes, size) = (text.as_bytes(), text.len() as u64);
    u32::try_from(size).ok()?;
    let part = |k: u64| -> Option<(u32, bool, Vec<Point>)> {
        let from = first_byte(k * BLOCK) as usize;
        let block = &bytes[from..bytes.len().min(from + BLOCK as usize + LONGEST_LINE + 1)];
        let part = plain.part(Block { bytes: block, start: k * BLOCK, size, located: true })?;
        let labels: Vec<SharedText> = part.labels.split_terminator('\n').map(SharedText::from).collect();
        let none = SharedText::default();
        let point = |(i, [line, start, end]): (usize, &[u32; 3])| Point {
            line: *line,
            text: Line::at(text, from as u32 + start, from as u32 + end),
            label: labels.get(part.label[i] as usize).unwrap_or(&none).clone(),
            xyz_mm: [0, 1, 2].map(|axis| part.xyz[axis][i] * unit.in_mm()),
            ..Point::default()
        };
        Some((part.lines, part.angles, part.located.iter().enumerate().map(point).collect()))
    };
    let mut points = Vec::with_capacity(line_feeds(bytes) + 1);
    let (mut before, mut all_angles) = (1, true);
    // a few blocks at a time, so that no row is held twice
    let (blocks, at_a_time) = (size.div_ceil(BLOCK), 2 * rayon::current_num_threads());
    for first in (0..blocks).step_by(at_a_time) {
        let some = first..blocks.min(first + at_a_time as u64);
        for (lines, angles, part) in some.into_par_iter().map(part).collect::<Option<Vec<_>>>()? {
            points.extend(part.into_iter().map(|point| Point { line: before + point.line, ..point }));
            before += lines;
            all_angles &= angles;
        }
    }
    if plain.may_be_angles && all_angles {
        return None;
    }
    Some(points)
}

/// The parts one after the other, without copying their coordinates.
fn together(mut parts: Vec<Part>) -> Result<Cloud> {
    let texts: Vec<String> = parts.iter_mut().map(|part| std::mem::take(&mut part.labels)).collect();
    let mut known = Names::default();
    let mut of_file: Vec<Vec<u32>> = Vec::with_capacity(texts.len());
    for texts in &texts {
        of_file.push(texts.split_terminator('\n').map(|label| known.place(label.as_bytes()).0).collect());
    }
    parts.par_iter_mut().zip(&of_file).filter(|(_, of_file)| !of_file.is_empty()).for_each(|(part, of_file)| {
        part.label.iter_mut().for_each(|label| *label = of_file[*label as usize]);
    });
    let mut columns: [Option<Column>; 4] = [const { None }; 4];
    for part in parts {
        let [x, y, z] = part.xyz;
        let pieces = [
            UInt32Chunked::from_vec("label".into(), part.label).into_column(),
            Float64Chunked::from_vec("x_mm".into(), x).into_column(),
            Float64Chunked::from_vec("y_mm".into(), y).into_column(),
            Float64Chunked::from_vec("z_mm".into(), z).into_column(),
        ];
        for (all, piece) in columns.iter_mut().zip(pieces) {
            match all {
                Some(all) => {
                    all.append(&piece).map_err(crate::table::failed)?;
                }
                None => *all = Some(piece),
            }
        }
    }
    let columns: Vec<Column> = columns.into_iter().flatten().collect();
    let height = columns.first().map_or(0, Column::len);
    let labels = known.all.iter().map(|label| String::from_utf8_lossy(label).into_owned()).collect();
    Ok(Cloud { labels, table: crate::parquet::frame(height, columns)? })
}

/// First byte to read for the block from `start`: the byte before the block shows whether a line
/// begins with it.
fn first_byte(start: u64) -> u64 {
    start.saturating_sub(1)
}

/// A block of a file of points.
#[derive(Clone, Copy)]
struct Block<'a> {
    /// Bytes from [`first_byte`] on, with the rest of the last line.
    bytes: &'a [u8],
    /// Position of the block in the file.
    start: u64,
    /// Size of the file (bytes).
    size: u64,
    /// `true` if the place of each line is wanted.
    located: bool,
}

/// Reads into `bytes` the block from `start` with the rest of its last line.
fn read_block(path: &Path, start: u64, bytes: &mut Vec<u8>) -> std::io::Result<()> {
    bytes.clear();
    bytes.reserve_exact(BLOCK as usize + LONGEST_LINE + 2);
    let mut file = File::open(path)?;
    file.seek(SeekFrom::Start(first_byte(start)))?;
    file.take(BLOCK + LONGEST_LINE as u64 + 1).read_to_end(bytes)?;
    Ok(())
}

/// A block that this machine reads with vector instructions; see [`Plain::part`].
#[cfg(target_arch = "x86_64")]
struct WideBlock<'a> {
    machine: pulp::x86::V3,
    block: Block<'a>,
    layout: &'a Plain,
}

#[cfg(target_arch = "x86_64")]
impl pulp::NullaryFnOnce for WideBlock<'_> {
    type Output = Option<Part>;

    #[inline(always)]
    fn call(self) -> Option<Part> {
        let (machine, block, layout) = (self.machine, self.block, self.layout);
        match layout.bare() {
            Some(bare) => layout.part_with(
                block,
                #[inline(always)]
                |at| super::wide::row(machine, block.bytes, at, bare),
            ),
            None => layout.part_with(
                block,
                #[inline(always)]
                |at| super::wide::picked(machine, block.bytes, at, layout),
            ),
        }
    }
}

impl Plain {
    /// Points of the lines that begin in the block; `None` if one of them is not plain.
    fn part(&self, block: Block) -> Option<Part> {
        #[cfg(target_arch = "x86_64")]
        if let Some(machine) = pulp::x86::V3::try_new() {
            return machine.vectorize(WideBlock { machine, block, layout: self });
        }
        self.part_with(block, |_| None)
    }

    /// A row that the scanner reads; `None` for any other line.
    #[inline]
    fn scanned<'a>(&self, bytes: &'a [u8], at: usize, last: bool) -> Option<PlainRow<'a>> {
        let mut line = Scanner { bytes, at, delimiter: self.delimiter };
        let (mut label, mut xyz) = (&b""[..], [0.0; 3]);
        for (i, (passed, column)) in self.read.iter().enumerate() {
            line.pass(*passed)?;
            match column {
                PlainColumn::Coordinate(axis) => xyz[*axis] = line.number(self.decimal)?,
                // an empty label may be the end of the line
                _ => label = line.label().filter(|label| i == 0 || !label.is_empty())?,
            }
        }
        line.pass_rest(self.behind)?;
        let end = line.at;
        // cells that are passed are a text, too
        let is_text = self.bare().is_some() || std::str::from_utf8(&bytes[at..end]).is_ok();
        (line.end(last) && is_text).then_some((label, xyz, line.at))
    }

    /// [`Self::part`] with a quicker reader of most rows.
    #[inline(always)]
    fn part_with<'a>(&self, block: Block<'a>, quick: impl Fn(usize) -> Option<PlainRow<'a>>) -> Option<Part> {
        let Block { bytes, start, size, located } = block;
        let (from, labelled) = (first_byte(start), self.is_labelled());
        let last = from + bytes.len() as u64 == size;
        let mut at = match start {
            0 => 0,
            _ => bytes.iter().position(|b| *b == b'\n').map_or(bytes.len(), |i| i + 1),
        };
        at = at.max(self.above.0.saturating_sub(from as usize)).min(bytes.len());
        let end = (start + BLOCK - from) as usize;
        let rows = line_feeds(&bytes[at..]) + 1;
        let mut part = Part { xyz: std::array::from_fn(|_| Vec::with_capacity(rows)), angles: true, ..Part::default() };
        part.lines = if start == 0 { self.above.1 } else { 0 };
        part.label.reserve_exact(rows);
        let mut known = Names::default();
        let mut before: (&[u8], u32) = (b"", u32::MAX);
        while at < end.min(bytes.len()) {
            let Some((label, xyz, next)) = quick(at).or_else(|| self.scanned(bytes, at, last)) else {
                // an empty line
                let mut line = Scanner { bytes, at, delimiter: self.delimiter };
                if !line.end(true) {
                    return None;
                }
                at = line.at;
                part.lines += 1;
                continue;
            };
            if labelled && label != before.0 || before.1 == u32::MAX {
                let (id, new) = known.place(label);
                if new && labelled {
                    let text = std::str::from_utf8(label).ok()?;
                    part.labels.push_str(text);
                    part.labels.push('\n');
                }
                before = (label, id);
            }
            part.label.push(before.1);
            part.angles &= xyz[0].abs() <= std::f64::consts::TAU && xyz[2] > 100.0;
            for (column, value) in part.xyz.iter_mut().zip(xyz) {
                column.push(value);
            }
            if located {
                let text = &bytes[at..next];
                let text = text.strip_suffix(b"\n").unwrap_or(text);
                let length = text.strip_suffix(b"\r").unwrap_or(text).len();
                part.located.push([part.lines, at as u32, (at + length) as u32]);
            }
            part.lines += 1;
            at = next;
        }
        Some(part)
    }
}

/// Names, each once.
#[derive(Default)]
struct Names<'a> {
    /// In the order of their first time.
    all: IndexSet<&'a [u8]>,
    /// Index of the last requested name. For each name, `next` has the index of its last successor:
    /// rows repeat.
    last: usize,
    next: Vec<usize>,
}

impl<'a> Names<'a> {
    /// Index of a name, and `true` if the name is new.
    fn place(&mut self, name: &'a [u8]) -> (u32, bool) {
        let guess = self.next.get(self.last).copied().unwrap_or_default();
        let known = self.all.get_index(guess).is_some_and(|known| same(known, name));
        let (place, new) = if known { (guess, false) } else { self.all.insert_full(name) };
        if new {
            self.next.push(0);
        }
        if !known && let Some(next) = self.next.get_mut(self.last) {
            *next = place;
        }
        self.last = place;
        (place as u32, new)
    }
}

/// `true` if two names are equal; names are short, and a loop is faster than a call.
#[inline]
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a == b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dialect::{ColumnRole, Columns, Dialect};
    use crate::parquet::table;
    use etalon_tables::{Delimiter, Form};

    type Rows = Option<Vec<(String, [u64; 3])>>;

    /// Labels and the bits of the coordinates from the fast and the strict reader.
    fn both(text: &str, format: &Format, unit: Unit) -> (Rows, Rows) {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), text).unwrap();
        let bits = |xyz: [f64; 3]| xyz.map(f64::to_bits);
        let fast = cloud(file.path(), format, unit).unwrap().map(|cloud| {
            let rows = table(&cloud.table).unwrap();
            let labels = rows.integers("label").unwrap();
            let xyz = ["x_mm", "y_mm", "z_mm"].map(|name| rows.numbers(name).unwrap());
            let label = |i: usize| cloud.labels.get(labels[i] as usize).cloned().unwrap_or_default();
            (0..labels.len()).map(|i| (label(i), bits([xyz[0][i], xyz[1][i], xyz[2][i]]))).collect()
        });
        let decoded = crate::into_text(file.path(), text.into(), None, format).unwrap_or_default().into();
        let (strict, problems) = format.read("f", &decoded, unit);
        let plain = head(decoded.as_bytes()).and_then(|head| format.plain(head, unit));
        let fast_points = plain.and_then(|plain| points(&decoded, &plain, unit));
        if let Some(points) = fast_points {
            assert!(problems.0.is_empty() && points == strict, "{format}: {text:?}: {points:?}");
        }
        let strict = problems.0.is_empty().then_some(strict);
        let plain = strict.filter(|points| points.iter().all(|p| p.refused.is_none()));
        (fast, plain.map(|points| points.into_iter().map(|p| (p.label.to_string(), bits(p.xyz_mm))).collect()))
    }

    fn formats() -> Vec<Format> {
        let stated = |delimiter, roles: &[ColumnRole]| {
            let (form, columns) = (Form::delimited(delimiter), roles.to_vec().into());
            Format::from(Dialect { form, columns, ..Dialect::default() })
        };
        use ColumnRole::*;
        vec![
            Format::default(),
            stated(Delimiter::Blank, &[Label, X, Y, Z]),
            stated(Delimiter::Blank, &[X, Y, Z]),
            stated(Delimiter::Comma, &[Label, X, Y, Z]),
            stated(Delimiter::Tab, &[Label, X, Y, Z]),
            stated(Delimiter::Semicolon, &[X, Y, Z]),
            stated(Delimiter::Comma, &[Skip, X, Y, Skip, Z, Label, Skip, Skip]),
            stated(Delimiter::Blank, &[X, Skip, Y, Z, Skip]),
            stated(Delimiter::Semicolon, &[Label, Skip, Z, Y, X]),
        ]
    }

    #[test]
    fn many_blocks_give_the_same_bits_as_the_strict_reader() {
        let mut noise = etalon_base::noise::Noise::new(3, 1);
        for (format, separator, labelled) in formats()
            .iter()
            .zip([" ", "  ", "\t ", ",", "\t", ";"])
            .zip([true, true, false, true, true, false])
            .map(|((f, s), l)| (f, s, l))
        {
            let mut text = String::new();
            let mut i = 0;
            while text.len() < (9 * BLOCK) as usize + 999 {
                let mut number = |n: i32| {
                    let value = noise.gaussian(1.0) * 10f64.powi((i + n) % 9 - 3);
                    if i % 5 == 0 { format!("{value:e}") } else { format!("{value:.*}", ((i + n) % 19) as usize) }
                };
                let row = [number(0), number(1), number(2)].join(separator);
                let label = if labelled { format!("ball_{}{separator}", i % 137) } else { String::new() };
                text += &format!("{label}{row}{}", if i % 7 == 0 { "\r\n" } else { "\n" });
                i += 1;
            }
            let (fast, strict) = both(text.trim_end(), format, Unit::Inch);
            assert_eq!(fast.as_ref().map(Vec::len), Some(i as usize), "{format}");
            assert!(fast == strict, "{format}");
        }
    }

    /// Rows of which some are plain.
    const ROWS: [&str; 72] = [
        "",
        "\n",
        " ",
        "a",
        "a b",
        "1 2 3",
        "a 1 2 3",
        "a,1,2,3",
        "a;1;2;3",
        "1;2;3",
        "\"a b\" 1 2 3",
        "a\t1\t2\t3",
        "1,5 2 3",
        "a 1 2 nan",
        "a 1 2 inf",
        "a 1 2 3 4",
        "a 1 2",
        "a 1 2 3\r",
        "a 1\r2 3",
        "a 1 2 1e400",
        "-.5 +1 2.",
        "- 1 2",
        ". 1 2",
        "1e5 1E-3 0x1",
        "a 1 2 123456789012345678901234567890.5",
        "0.1 9007199254740993 -0.0",
        "a 1 2 --3",
        "\u{feff}a 1 2 3",
        "a 1 2 \u{2212}3",
        "a 1.5D+01 2 3",
        "K\u{fc} 1 2 3",
        "a\0 1 2 3",
        "a, 1 ,2 , 3",
        ",1,2,3",
        "a,,2,3",
        "a 1 2 1.2.3",
        "1 1 500",
        "a 1 2 0.30000000000000004",
        "a 1.5 -2.25 3.0",
        "a,1.5,-2.25,3.0",
        "1.5;-2.25;3.0",
        "a 1.5  2.5 3.5",
        " a 1.5 2.5 3.5",
        "a 1.5 2.5 3.5 ",
        "a 1.5 2.5 3.5 4.5",
        "a.b 1.5 2.5 3.5",
        "\"a 1.5 2.5 3.5",
        "\u{e9} 1.5 2.5 3.5",
        "a 1.5 2.5 3.5\r",
        "a 12345678.5 -0.0 3.12345678",
        "a 123456789.5 2.5 3.123456789",
        "a 99999999.99999999 2.5 3.5",
        "a -.5 2.5 3.5",
        "a 1. 2.5 3.5",
        "a 1.-5 2.5 3.5",
        "a 1.5x 2.5 3.5",
        "a 1.5:2 2.5 3.5",
        "0,1.5,2.5,x,3.5,a,,",
        "0,1.5,2.5,,3.5,a",
        ",1.5,2.5,\"q,r\",3.5,a,9,",
        "\"0,1.5,2.5,x,3.5,a,,",
        "0,1.5,2.5,\u{e9},3.5,a,9,9,",
        "0,1.5,2.5,x,3.5,a,9,9,9",
        "0,1.5,2.5,x,3.5",
        "0,1.5,2.5,x,3.5,",
        "0,1.5,2.5,a cell of more than the thirty-two bytes of a window,3.5,a,9\r",
        "1.5 x 2.5 3.5 y",
        "1.5  x\t2.5  3.5  ",
        "1.5 x 2.5 3.5 y z",
        "1.5 a_cell_of_more_than_the_thirty-two_bytes_of_a_window 2.5 3.5 y",
        "a;x;1.5;2.5;3.5",
        "a;;1.5;2.5;3.5;",
    ];

    #[test]
    fn what_is_not_plain_is_left_to_the_strict_reader_and_nothing_is_read_otherwise() {
        let mut read = 0;
        for (i, first) in ROWS.iter().enumerate() {
            // each row with a third of the others
            for second in ROWS.iter().skip(i % 3).step_by(3) {
                for format in formats() {
                    let text = format!("{first}\n{second}\n").repeat(8) + first;
                    let (fast, strict) = both(&text, &format, Unit::Millimetre);
                    if let Some(fast) = fast {
                        read += usize::from(!fast.is_empty());
                        assert_eq!(Some(fast), strict, "{format}: {text:?}");
                    }
                }
            }
        }
        assert!(read > 50, "{read}");
    }

    /// A table with a head, further columns and a decimal comma, in many blocks; a fault of the
    /// head or of one row is left to the strict reader.
    #[test]
    fn columns_that_nobody_asked_for_are_passed() {
        use etalon_tables::{ColumnSource, Decimal, Header};
        let named =
            [(ColumnRole::Label, "name"), (ColumnRole::X, "X [mm]"), (ColumnRole::Y, "Y"), (ColumnRole::Z, "Z")];
        let columns = named.map(|(role, heading)| (role, ColumnSource::Heading(heading.to_owned())));
        let form = Form {
            delimiter: Some(Delimiter::Semicolon),
            decimal: Some(Decimal::Comma),
            header: Some(Header::Rows(2)),
            ..Form::default()
        };
        let format = Format::from(Dialect { form, columns: Columns::Named(columns.to_vec()), ..Dialect::default() });
        let mut noise = etalon_base::noise::Noise::new(5, 1);
        let mut number = |n: usize| format!("{:.*}", n % 7, noise.gaussian(300.0)).replace('.', ",");
        let mut rows = String::new();
        for i in 0..9000 {
            let before: Vec<String> = (0..3).map(|n| number(i + n)).collect();
            let behind: Vec<String> = (0..11).map(|n| number(i + n)).collect();
            let xyz = [number(i), number(i + 1), number(i + 2)].join(";");
            rows += &format!("{};K{};\"a; b\";{xyz};{}\n", before.join(";"), i % 50, behind.join(";"));
        }
        let more = (0..11).map(|n| format!("b{n}")).collect::<Vec<_>>().join(";");
        let head = format!("tracker 7\na0;a1;a2;name;text;X [mm];Y;Z;{more}\n");
        let unquoted = rows.replace("\"a; b\"", "a b");
        for text in [format!("{head}{rows}"), format!("\u{feff}{head}\n{rows}"), format!("{head}{unquoted}")] {
            assert!(text.len() as u64 > 9 * BLOCK);
            let (fast, strict) = both(&text, &format, Unit::Millimetre);
            assert_eq!(fast.as_ref().map(Vec::len), Some(9000));
            assert!(fast == strict);
        }
        // the heading states another unit; a row has a cell more; a cell that is passed is no text
        assert_eq!(both(&format!("{head}{rows}"), &format, Unit::Metre), (None, None));
        assert_eq!(
            both(&format!("{head}{rows}{};9\n", rows.lines().next().unwrap()), &format, Unit::Millimetre).0,
            None
        );
        let file = tempfile::NamedTempFile::new().unwrap();
        let mut bytes = format!("{head}{rows}").into_bytes();
        std::fs::write(file.path(), &bytes).unwrap();
        assert_eq!(packed_points(file.path(), &format, None).unwrap().map(|points| points.len()), Some(9000));
        let quote = bytes.iter().rposition(|b| *b == b'"').unwrap();
        bytes[quote - 1] = 0xff;
        std::fs::write(file.path(), &bytes).unwrap();
        assert!(packed_points(file.path(), &format, None).unwrap().is_none());
    }

    #[test]
    fn a_name_has_one_place_however_many_there_are() {
        let texts: Vec<String> = (0..5000).map(|i| format!("ball_{}", i % 1700)).collect();
        let mut names = Names::default();
        for (i, text) in texts.iter().enumerate() {
            assert_eq!(names.place(text.as_bytes()), ((i % 1700) as u32, i < 1700), "{text}");
        }
        assert_eq!(names.all.len(), 1700);
    }
}
