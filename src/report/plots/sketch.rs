//! Model of the robot as a line drawing with its parameters as dimensions.

use super::layer::*;
use super::view::{ABOVE, ASLANT, Paper};
use etalon_base::sketch::{Sketch, StrokeKind};
use std::borrow::Cow;

const MOST_HIGH: f64 = 420.0;
/// Margin for letters around the lines.
const MARGIN: f64 = 46.0;
/// Distance of a dimension line from the measured part.
const ASIDE: f64 = 7.0;
/// Size of letters, and width of a letter.
const LETTER: f64 = 12.0;
const LETTER_WIDTH: f64 = 6.8;
/// Maximum length of a name in a drawing; longer names lose their middle.
const LONGEST_NAME: usize = 40;
/// Maximum plausible coordinate (mm).
const REACH: f64 = 1e7;

/// One figure for each drawing that can be drawn.
pub(crate) fn pictures(sketches: &[Sketch], words: &Words) -> Vec<Figure> {
    sketches.iter().enumerate().filter_map(|(i, sketch)| picture(sketch, i, words)).collect()
}

fn picture(sketch: &Sketch, index: usize, words: &Words) -> Option<Figure> {
    let view = if sketch.planar { ABOVE } else { ASLANT };
    let places = || sketch.strokes.iter().flat_map(|s| &s.points_mm);
    if places().next().is_none() || !places().flatten().all(|v| v.abs() < REACH) {
        return None;
    }
    let flat: Vec<Place> = places().map(|p| view.flat(*p)).collect();
    let paper = Paper::around(&flat, NARROW, MOST_HIGH, MARGIN);
    let mut svg = Svg::new(words, NARROW, paper.height);
    let drawn: Vec<Vec<Place>> =
        sketch.strokes.iter().map(|s| s.points_mm.iter().map(|p| paper.at(view.flat(*p))).collect()).collect();
    for (stroke, line) in sketch.strokes.iter().zip(&drawn) {
        let line = if stroke.kind == StrokeKind::Length { aside(line) } else { line.clone() };
        let class = match stroke.kind {
            StrokeKind::Part => "part",
            StrokeKind::Axis => "line-axis",
            StrokeKind::Length | StrokeKind::Direction => "dimension",
        };
        svg.lines(class, &line);
        let ([first, second, ..], [.., before, last]) = (&line[..], &line[..]) else { continue };
        match stroke.kind {
            StrokeKind::Part | StrokeKind::Axis => {}
            StrokeKind::Direction => svg.arrows(class, &[[*before, *last]]),
            StrokeKind::Length => svg.arrows(class, &[[*before, *last], [*second, *first]]),
        }
    }
    let parts = sketch.strokes.iter().zip(&drawn).filter(|(s, _)| s.kind == StrokeKind::Part);
    let parts = parts.flat_map(|(_, line)| line.windows(2).map(|pair| [pair[0], pair[1]])).collect();
    let mut labels = Labels { height: paper.height, taken: Vec::new(), parts };
    let lines = sketch.strokes.iter().zip(&drawn).filter(|(s, _)| !s.name.is_empty());
    // names with the least freedom first
    let (short, long): (Vec<_>, Vec<_>) = lines.partition(|(s, _)| s.kind == StrokeKind::Direction);
    for (stroke, line) in short.into_iter().chain(long) {
        let name = &*shortened(&stroke.name);
        let at = labels.place(stroke.kind, line, name);
        let class = match stroke.kind {
            StrokeKind::Length | StrokeKind::Direction => "mid over name",
            _ => "mid over",
        };
        if let Some((from, to)) = leader(stroke.kind, line, at, name) {
            svg.line("leader", from, to);
        }
        svg.text(class, at, name);
    }
    let title = tr!(words, "sketch-title");
    Some(svg.figure(&format!("sketch-{index}"), title, words.by_id(sketch.title_id.as_deref(), &sketch.title)))
}

/// Unit normal of the line between two positions; zero if they coincide.
fn across(from: Place, to: Place) -> Place {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    if length > 0.0 { (dy / length, -dx / length) } else { (0.0, 0.0) }
}

fn aside(line: &[Place]) -> Vec<Place> {
    let [first, .., last] = line else { return Vec::new() };
    let (nx, ny) = across(*first, *last);
    line.iter().map(|p| (p.0 + ASIDE * nx, p.1 + ASIDE * ny)).collect()
}

/// Shortens a name to its beginning and its end, which distinguishes parameters of a joint.
fn shortened(name: &str) -> Cow<'_, str> {
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= LONGEST_NAME {
        return Cow::Borrowed(name);
    }
    let (kept, last) = (LONGEST_NAME / 2, letters.len() - (LONGEST_NAME / 2 - 1));
    Cow::Owned(letters[..kept].iter().chain(&['…']).chain(&letters[last..]).collect())
}

/// Left, right, top and bottom of a name about its position.
fn frame((x, y): Place, name: &str) -> [f64; 4] {
    let half = half_width(name);
    [x - half, x + half, y - LETTER, y + 3.0]
}

fn half_width(name: &str) -> f64 {
    0.5 * LETTER_WIDTH * name.chars().count() as f64 + 2.0
}

/// Line from the joint of an axis, in the middle of its drawn part, to the name; `None` if the name
/// is at the axis.
fn leader(kind: StrokeKind, line: &[Place], at: Place, name: &str) -> Option<(Place, Place)> {
    const AT_THE_AXIS: f64 = 14.0;
    if kind != StrokeKind::Axis {
        return None;
    }
    let [left, right, top, bottom] = frame(at, name);
    let nearest = |p: Place| (p.0.clamp(left, right), p.1.clamp(top, bottom));
    let far = |p: Place| (nearest(p).0 - p.0).hypot(nearest(p).1 - p.1);
    let (first, last) = (line[0], line[line.len() - 1]);
    let joint = on_axis(first, last);
    let tip = far(last).min(far(first));
    (tip > AT_THE_AXIS && far(joint) > 2.0).then(|| (joint, nearest(joint)))
}

/// Position of the joint on an axis, which is drawn from 0.09 before to 0.13 after it.
fn on_axis(first: Place, last: Place) -> Place {
    const SHARE: f64 = 0.09 / 0.22;
    (first.0 + SHARE * (last.0 - first.0), first.1 + SHARE * (last.1 - first.1))
}

/// `true` if a line between two positions intersects a frame: the line is clipped at each pair of
/// edges.
fn meets([a, b]: [Place; 2], [left, right, top, bottom]: [f64; 4]) -> bool {
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for (start, along, low, high) in [(a.0, b.0 - a.0, left, right), (a.1, b.1 - a.1, top, bottom)] {
        if along.abs() < 1e-9 {
            if start < low || start > high {
                return false;
            }
            continue;
        }
        let (enter, leave) = ((low - start) / along, (high - start) / along);
        (from, to) = (from.max(enter.min(leave)), to.min(enter.max(leave)));
    }
    from <= to
}

/// Names that overlap neither each other nor, if there is room, the parts.
struct Labels {
    height: f64,
    taken: Vec<[f64; 4]>,
    parts: Vec<[Place; 2]>,
}

impl Labels {
    /// First position along and beside a line with room for a name.
    fn place(&mut self, kind: StrokeKind, line: &[Place], name: &str) -> Place {
        let half = half_width(name);
        let (first, last) = (line[0], line[line.len() - 1]);
        let shares: &[f64] = match kind {
            StrokeKind::Axis | StrokeKind::Direction => &[1.0, 0.85, 0.7, 0.5, 0.3, 0.0],
            _ => &[0.5, 0.38, 0.62, 0.25, 0.75, 0.12, 0.88],
        };
        let normal = across(first, last);
        let mut choices = Vec::new();
        if matches!(kind, StrokeKind::Axis | StrokeKind::Direction) {
            // beyond the tip
            let (before, (nx, ny)) = (line[line.len() - 2], across(line[line.len() - 2], last));
            let (ux, uy) = if before == last { (0.0, 0.0) } else { (-ny, nx) };
            choices.extend(
                [0.0, 8.0, 18.0]
                    .map(|more| (last.0 + ux * (6.0 + more + half), last.1 + uy * (11.0 + more) + 0.35 * LETTER)),
            );
        }
        for far in [14.0, -14.0, 24.0, -24.0, 38.0, -38.0, 54.0, -54.0, 72.0, -72.0] {
            for share in shares {
                let along = |a: f64, b: f64| a + share * (b - a);
                // names are wider than high
                let (nx, ny) = (normal.0 * (far + f64::signum(far) * half * normal.0.abs()), normal.1 * far);
                let on = match line.len() > 2 {
                    true => line[((line.len() - 1) as f64 * share).round() as usize],
                    false => (along(first.0, last.0), along(first.1, last.1)),
                };
                choices.push((on.0 + nx, on.1 + ny + 0.35 * LETTER));
            }
        }
        // around the end, or the joint of an axis, if a short line has no room beside it
        let last = if kind == StrokeKind::Axis { on_axis(first, last) } else { last };
        for far in [22.0, 34.0, 46.0, 60.0, 76.0, 94.0, 112.0, 130.0] {
            choices.extend((0..12).map(|i| {
                let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 12.0).sin_cos();
                (last.0 + (far + half) * cos, last.1 + far * sin + 0.35 * LETTER)
            }));
        }
        let free = |at: &&Place| {
            let [left, right, top, bottom] = frame(**at, name);
            let apart = |b: &[f64; 4]| right < b[0] || b[1] < left || bottom < b[2] || b[3] < top;
            left > 1.0
                && right < NARROW - 1.0
                && top > 1.0
                && bottom < self.height - 1.0
                && self.taken.iter().all(apart)
        };
        let inside = |(x, y): Place| (x.clamp(half + 1.0, NARROW - half - 1.0), y.clamp(14.0, self.height - 4.0));
        let clear = |at: &&Place| !self.parts.iter().any(|part| meets(*part, frame(**at, name)));
        let beside = choices.iter().find(|at| free(at) && clear(at)).or_else(|| choices.iter().find(free));
        let at = beside.copied().unwrap_or_else(|| inside(choices[0]));
        self.taken.push(frame(at, name));
        at
    }
}

#[cfg(test)]
mod tests {
    use super::super::svg::numbers;
    use super::*;

    #[test]
    fn names_of_a_drawing_do_not_overlap_and_are_inside() {
        let mut sketch = Sketch::new("sketch-arm", true);
        (0..12).for_each(|i| sketch.add(StrokeKind::Length, format!("length_{i}"), &[[0.0; 3], [100.0, 60.0, 0.0]]));
        let svg = &pictures(&[sketch], &Words::default())[0].svg;
        let texts: Vec<_> = numbers(svg, "text", "x").into_iter().zip(numbers(svg, "text", "y")).collect();
        assert_eq!(texts.len(), 12);
        for (i, a) in texts.iter().enumerate() {
            assert!(a.0 > 20.0 && a.0 < NARROW - 20.0);
            assert!(texts[..i].iter().all(|b| (a.0 - b.0).abs() > 40.0 || (a.1 - b.1).abs() > 10.0), "{texts:?}");
        }
    }

    #[test]
    fn names_of_axes_that_coincide_lie_beside_the_arm_and_each_is_joined_to_its_joint() {
        let mut sketch = Sketch::new("sketch-arm", true);
        sketch.add(StrokeKind::Part, "", &[[0.0; 3], [300.0, 200.0, 0.0]]);
        for i in 0..6 {
            let share = 0.03 * f64::from(i);
            let at = |s: f64| [300.0 * s, 200.0 * s, 0.0];
            sketch.add(StrokeKind::Axis, format!("wrist_{i}"), &[at(share), at(share + 0.22)]);
        }
        let svg = &pictures(&[sketch], &Words::default())[0].svg;
        let number = |l: &str, key: &str| numbers(l, &l[1..5], key)[0];
        let ends = |l: &str| [(number(l, "x1"), number(l, "y1")), (number(l, "x2"), number(l, "y2"))];
        let part = ends(svg.lines().find(|l| l.contains("class=\"part\"")).unwrap());
        let texts: Vec<&str> = svg.lines().filter(|l| l.starts_with("<text")).collect();
        assert_eq!(texts.len(), 6);
        for text in &texts {
            let at = (number(text, "x"), number(text, "y"));
            assert!(!meets(part, frame(at, "wrist_0")), "{text}");
        }
        let leaders: Vec<_> = svg.lines().filter(|l| l.contains("leader")).map(ends).collect();
        assert!(!leaders.is_empty() && svg.matches("<text").count() == 6, "{svg}");
        for [joint, _] in leaders {
            assert!(meets(part, [joint.0 - 0.2, joint.0 + 0.2, joint.1 - 0.2, joint.1 + 0.2]), "{joint:?}");
        }
    }

    #[test]
    fn what_is_not_a_place_is_not_drawn() {
        let mut sketch = Sketch::new("sketch-arm", false);
        sketch.add(StrokeKind::Part, "", &[[f64::NAN; 3], [0.0; 3]]);
        assert!(pictures(&[sketch, Sketch::new("sketch-arm", true)], &Words::default()).is_empty());
    }
}
