//! Rows of tables of points, read with AVX2. In rows of a label and three decimals, all separators
//! of a line are found at once, and both halves of each number are converted at once. In rows with
//! further columns, cells that are not read are passed 32 bytes at a time. Rows of any other kind,
//! and other machines, read with the scanner.

use crate::exports::{Bare, Plain, PlainRow};
use etalon_tables::lexer::{PlainColumn, Scanner};
use pulp::cast;
use pulp::x86::V3;

/// Bytes of a line that are looked at for separators, and bytes that are loaded with them.
const LINE: usize = 64;
const LOADED: usize = LINE + 16;
/// Powers of ten up to the longest half of a number; beyond it there are no decimals to scale.
const TENS: [u64; 16] = {
    let mut tens = [0; 16];
    let mut i = 0;
    while i < 9 {
        tens[i] = 10u64.pow(i as u32);
        i += 1;
    }
    tens
};

/// Label and coordinates of the line at `at`, and where the next line begins; `None` unless the
/// line has just a label, if rows have one, and three numbers of one to eight digits before and
/// behind the mark.
#[inline(always)]
pub(crate) fn row(machine: V3, bytes: &[u8], at: usize, layout: Bare) -> Option<PlainRow<'_>> {
    let line: &[u8; LOADED] = bytes.get(at..)?.first_chunk()?;
    let Bare { delimiter, labelled } = layout;
    let mut stops = stops(machine, line, delimiter);
    let mut stop = || {
        let first = stops.trailing_zeros() as usize;
        stops &= stops.wrapping_sub(1);
        first
    };
    let label = if labelled { stop() } else { 0 };
    let from = label + usize::from(labelled);
    let [x, after_x, y, after_y, z, end] = std::array::from_fn(|_| stop());
    let is = |place: usize, byte: u8| line[place & (LINE - 1)] == byte;
    let points = is(x, b'.') & is(y, b'.') & is(z, b'.');
    let separated = is(after_x, delimiter) & is(after_y, delimiter);
    let named = !labelled | (is(label, delimiter) & (label > 0) & !is(0, b'"'));
    if end >= LINE || !(points & separated & named) {
        return None;
    }
    let next = match (line[end], line[end + 1]) {
        (b'\n', _) => at + end + 1,
        (b'\r', b'\n') => at + end + 2,
        _ => return None,
    };
    let x = number(machine, line, [from, x, after_x]);
    let y = number(machine, line, [after_x + 1, y, after_y]);
    let z = number(machine, line, [after_y + 1, z, end]);
    (x.1 & y.1 & z.1).then_some((&line[..label & (LINE - 1)], [x.0, y.0, z.0], next))
}

/// Label and coordinates of the line at `at`, and where the next line begins; `None` unless the
/// line has all columns of the layout and no further ones, without quotes and letters beyond ASCII
/// in the cells that are passed.
#[inline(always)]
pub(crate) fn picked<'a>(machine: V3, bytes: &'a [u8], at: usize, layout: &Plain) -> Option<PlainRow<'a>> {
    let mut line = Scanner { bytes, at, delimiter: layout.delimiter };
    let (mut label, mut xyz) = (&b""[..], [0.0; 3]);
    for (i, (passed, column)) in layout.read.iter().enumerate() {
        if *passed > 0 {
            line.at = pass(machine, &line, *passed)?;
        }
        match column {
            PlainColumn::Coordinate(axis) => xyz[*axis] = line.number(layout.decimal)?,
            _ => label = line.label().filter(|label| i == 0 || !label.is_empty())?,
        }
    }
    let (cells, next) = rest(machine, &line)?;
    (cells <= layout.behind).then_some((label, xyz, next))
}

/// Beginnings of cells and ends of plain text in 32 bytes of a line.
struct Window {
    /// A delimiter, or the first byte of a cell behind blanks.
    cells: u32,
    /// First bit at a line end, a quote, another control character or a letter beyond ASCII.
    stop: u32,
    /// The last byte belongs to a cell, if blanks separate cells.
    within: bool,
}

impl Window {
    /// The bytes from `at`, behind a cell if `within`; `None` near the end of the bytes.
    #[inline(always)]
    fn new(machine: V3, line: &Scanner, at: usize, within: bool) -> Option<Self> {
        let (avx, avx2) = (machine.avx, machine.avx2);
        let bytes: [u8; LINE / 2] = *line.bytes.get(at..)?.first_chunk()?;
        let bytes = cast(bytes);
        let is = |byte: u8| avx2._mm256_cmpeq_epi8(bytes, avx._mm256_set1_epi8(byte as i8));
        let bits = |of| avx2._mm256_movemask_epi8(of) as u32;
        let (tabs, quotes) = (bits(is(b'\t')), bits(is(b'"')));
        let low = bits(avx2._mm256_cmpgt_epi8(avx._mm256_set1_epi8(b' ' as i8), bytes));
        let stops = low & !tabs | quotes;
        // all bits in front of the first stop
        let plain = stops.wrapping_sub(1) & !stops;
        let (cells, within) = match line.delimiter {
            Some(delimiter) => (bits(is(delimiter)), false),
            None => {
                let filled = !(tabs | bits(is(b' ')));
                (filled & !(filled << 1 | u32::from(within)), filled >> 31 == 1)
            }
        };
        Some(Self { cells: cells & plain, stop: stops & stops.wrapping_neg(), within })
    }
}

/// Beginning of the cell that follows `count` cells of a line; `None` if the line has fewer.
#[inline(always)]
fn pass(machine: V3, line: &Scanner, mut count: usize) -> Option<usize> {
    let mut at = line.at;
    // blanks before the first of them
    while line.delimiter.is_none() && matches!(line.bytes.get(at), Some(b' ' | b'\t')) {
        at += 1;
    }
    let mut within = true;
    loop {
        let mut window = Window::new(machine, line, at, within)?;
        let here = window.cells.count_ones() as usize;
        if here >= count {
            (1..count).for_each(|_| window.cells &= window.cells.wrapping_sub(1));
            return Some(at + window.cells.trailing_zeros() as usize + usize::from(line.delimiter.is_some()));
        }
        if window.stop != 0 {
            return None;
        }
        (count, at, within) = (count - here, at + LINE / 2, window.within);
    }
}

/// Number of cells up to the end of a line, and where the next line begins.
#[inline(always)]
fn rest(machine: V3, line: &Scanner) -> Option<(usize, usize)> {
    // behind a delimiter a cell begins
    let behind = line.delimiter.is_some() && line.at.checked_sub(1).map(|before| line.bytes[before]) == line.delimiter;
    let (mut cells, mut at, mut within) = (usize::from(behind), line.at, false);
    loop {
        let window = Window::new(machine, line, at, within)?;
        cells += window.cells.count_ones() as usize;
        if window.stop != 0 {
            let end = at + window.stop.trailing_zeros() as usize;
            let next = match (line.bytes.get(end)?, line.bytes.get(end + 1)) {
                (b'\n', _) => end + 1,
                (b'\r', Some(b'\n')) => end + 2,
                _ => return None,
            };
            return Some((cells, next));
        }
        (at, within) = (at + LINE / 2, window.within);
    }
}

/// One bit for each byte that may end a label or a number: delimiter, mark, blanks, control
/// characters and letters beyond ASCII.
#[inline(always)]
fn stops(machine: V3, line: &[u8; LOADED], delimiter: u8) -> u64 {
    let (avx, avx2) = (machine.avx, machine.avx2);
    let [low, mark, delimiter] = [0x21, b'.', delimiter].map(|byte| avx._mm256_set1_epi8(byte as i8));
    let half = |bytes: [u8; LINE / 2]| {
        let bytes = cast(bytes);
        let marks = avx2._mm256_or_si256(avx2._mm256_cmpeq_epi8(bytes, mark), avx2._mm256_cmpeq_epi8(bytes, delimiter));
        let stops = avx2._mm256_or_si256(marks, avx2._mm256_cmpgt_epi8(low, bytes));
        u64::from(avx2._mm256_movemask_epi8(stops) as u32)
    };
    let [first, second]: [[u8; LINE / 2]; 2] = cast(*line.first_chunk::<LINE>().unwrap_or(&[0; LINE]));
    half(first) | half(second) << 32
}

/// The number from `start` to `end` with its mark at `point`, and `true` if the number has one to
/// eight digits on both sides and no other characters but a minus.
#[inline(always)]
fn number(machine: V3, line: &[u8; LOADED], [start, point, end]: [usize; 3]) -> (f64, bool) {
    let (sse2, ssse3, sse4) = (machine.sse2, machine.ssse3, machine.sse4_1);
    let negative = line[start & (LINE - 1)] == b'-';
    let start = start + usize::from(negative);
    let (before, behind) = (point.wrapping_sub(start), end.wrapping_sub(point + 1));
    let digits = sse2._mm_set_epi64x(digits(line, point + 1, behind), digits(line, start, before));
    let others = sse2._mm_or_si128(digits, sse2._mm_add_epi8(digits, sse2._mm_set1_epi8(0x76)));
    let pairs = ssse3._mm_maddubs_epi16(digits, sse2._mm_set1_epi16(0x010a));
    let fours = sse2._mm_madd_epi16(pairs, sse2._mm_set1_epi32(0x0001_0064));
    let halves = sse2._mm_madd_epi16(sse4._mm_packus_epi32(fours, fours), sse2._mm_set1_epi32(0x0001_2710));
    let [halves, _]: [u64; 2] = cast(halves);
    let tens = TENS[behind & 15];
    let mantissa = (halves & 0xffff_ffff).wrapping_mul(tens).wrapping_add(halves >> 32);
    // both operands are exact, see `Scanner::exact`
    let value = mantissa as i64 as f64 / tens as i64 as f64;
    let in_range = |count: usize| count.wrapping_sub(1) < 8;
    let is_plain = (sse2._mm_movemask_epi8(others) == 0) & (mantissa <= 1 << 53) & in_range(before) & in_range(behind);
    // the sign is unpredictable, so this is branch-free
    (f64::from_bits(value.to_bits() | u64::from(negative) << 63), is_plain)
}

/// Up to eight digits as values of bytes, the last one in the highest byte.
#[inline(always)]
fn digits(line: &[u8; LOADED], from: usize, count: usize) -> i64 {
    let word = line[from & (LINE - 1)..].first_chunk().map_or(0, |word| u64::from_le_bytes(*word));
    ((word ^ 0x3030_3030_3030_3030) << ((count as u32).wrapping_mul(8).wrapping_neg() & 63)) as i64
}
