//! A robot as lines at joint values, for pictures of it at its poses.

use etalon_base::pose::{Pose, Vector};

/// A robot as lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// Lines, from the base to the targets.
    pub lines: Vec<OutlineLine>,
}

/// A polyline of an outline.
#[derive(Clone, Debug, PartialEq)]
pub struct OutlineLine {
    /// Name of the moving part: `base`, `platform`, or the joint that moves the part.
    pub body: String,
    /// `true` for the axis of a joint, `false` for a link.
    pub is_axis: bool,
    /// At least two points (mm).
    pub points_mm: Vec<Vector>,
}

impl Outline {
    /// Adds a line of a link; a line without length or with non-finite points is omitted.
    pub fn link(&mut self, body: &str, points_mm: &[Vector]) {
        self.add(body, false, points_mm);
    }

    /// Adds a line along the axis of a joint.
    pub fn axis(&mut self, body: &str, points_mm: &[Vector]) {
        self.add(body, true, points_mm);
    }

    fn add(&mut self, body: &str, is_axis: bool, points_mm: &[Vector]) {
        let finite = points_mm.iter().flatten().all(|v| v.is_finite());
        if finite && points_mm.windows(2).any(|ends| ends[0] != ends[1]) {
            self.lines.push(OutlineLine { body: body.to_owned(), is_axis, points_mm: points_mm.to_vec() });
        }
    }

    /// Moves all lines from a frame to another.
    #[must_use]
    pub fn moved(mut self, to_T_from: &Pose) -> Self {
        let points = self.lines.iter_mut().flat_map(|line| &mut line.points_mm);
        points.for_each(|point| *point = to_T_from.apply(*point));
        self
    }

    /// Largest extent along a coordinate axis (mm).
    pub fn extent_mm(&self) -> f64 {
        let along = |i: usize| {
            let all = self.lines.iter().flat_map(|line| &line.points_mm).map(|p| p[i]);
            let ends = all.fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(v), b.max(v)));
            ends.1 - ends.0
        };
        (0..3).map(along).fold(0.0, f64::max)
    }
}
