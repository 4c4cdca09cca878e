//! Rows of a label and three decimal numbers, read with AVX2: all separators of a line at once,
//! then both halves of each number at once. Rows of any other kind, and other machines, read with
//! the scanner.

use super::exports::{Plain, PlainRow};
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
pub(super) fn row(machine: V3, bytes: &[u8], at: usize, layout: Plain) -> Option<PlainRow<'_>> {
    let line: &[u8; LOADED] = bytes.get(at..)?.first_chunk()?;
    let delimiter = layout.delimiter.unwrap_or(b' ');
    let mut stops = stops(machine, line, delimiter);
    let mut stop = || {
        let first = stops.trailing_zeros() as usize;
        stops &= stops.wrapping_sub(1);
        first
    };
    let label = if layout.labelled { stop() } else { 0 };
    let from = label + usize::from(layout.labelled);
    let [x, after_x, y, after_y, z, end] = std::array::from_fn(|_| stop());
    let is = |place: usize, byte: u8| line[place & (LINE - 1)] == byte;
    let points = is(x, b'.') & is(y, b'.') & is(z, b'.');
    let separated = is(after_x, delimiter) & is(after_y, delimiter);
    let labelled = !layout.labelled | (is(label, delimiter) & (label > 0) & !is(0, b'"'));
    if end >= LINE || !(points & separated & labelled) {
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
