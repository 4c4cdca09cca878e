//! Wavefront OBJ: vertices and faces.

use super::{MOST, Triangle};

/// Triangles of a file; a face of more corners is cut into a fan.
pub(super) fn read(text: &str) -> Option<Vec<Triangle>> {
    let (mut points, mut triangles): (Vec<[f32; 3]>, Vec<Triangle>) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") => {
                let mut value = || words.next()?.parse().ok();
                points.push([value()?, value()?, value()?]);
            }
            Some("f") => {
                let corners = words.map(|word| corner(word, &points)).collect::<Option<Vec<_>>>()?;
                let (first, others) = corners.split_first()?;
                triangles.extend(others.windows(2).map(|pair| [*first, pair[0], pair[1]]));
            }
            _ => {}
        }
        if triangles.len() > MOST {
            return None;
        }
    }
    Some(triangles)
}

/// Point of a corner `point/texture/normal`: the number counts from 1, or back from the last point.
fn corner(word: &str, points: &[[f32; 3]]) -> Option<[f32; 3]> {
    let number: i64 = word.split('/').next()?.parse().ok()?;
    let from = if number < 0 { i64::try_from(points.len()).ok()? } else { -1 };
    points.get(usize::try_from(from + number).ok()?).copied()
}
