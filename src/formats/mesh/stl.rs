//! STL, text or binary.

use super::{MOST, Triangle};
use crate::exports::stl::{is_text, triangles};

/// Triangles of a file.
pub(super) fn read(bytes: &[u8]) -> Option<Vec<Triangle>> {
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(1024)]);
    if !is_text(&start) {
        let (count, all) = triangles(bytes);
        return (count <= all.len() && count <= MOST).then(|| all.take(count).collect());
    }
    let mut corners: Vec<[f32; 3]> = Vec::new();
    for line in std::str::from_utf8(bytes).ok()?.lines() {
        let mut words = line.split_ascii_whitespace();
        if words.next() == Some("vertex") {
            let mut value = || words.next()?.parse().ok();
            corners.push([value()?, value()?, value()?]);
        }
    }
    (corners.len() <= 3 * MOST).then(|| corners.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect())
}
