//! Line drawing of a robot in its base frame, with its parameters as dimensions.

use crate::catalogue::Phrase;
use crate::pose::{Pose, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A drawing with lengths in mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sketch {
    /// Title of the drawing.
    pub title: String,
    /// Id of the title in the catalogue of texts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title_id: Option<String>,
    /// `true` if the drawing lies in the plane z = 0.
    pub planar: bool,
    /// Lines of the drawing.
    pub strokes: Vec<Stroke>,
}

/// A polyline of a drawing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stroke {
    /// Meaning of the line.
    pub kind: StrokeKind,
    /// Name of a parameter, joint or frame; empty if unnamed.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// At least two points (mm).
    pub points_mm: Vec<Vector>,
}

/// Meaning of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StrokeKind {
    /// A link, a rod, a platform.
    Part,
    /// An axis, or the reference line of an angle.
    Axis,
    /// A dimension with an arrow at either end.
    Length,
    /// An angle or direction with an arrow at its positive end.
    Direction,
}

/// Number of segments of an arc.
const ARC: usize = 8;

impl Sketch {
    /// Creates an empty drawing with a title of the catalogue.
    pub fn new(title: &'static str, planar: bool) -> Self {
        let title_id = Some(title.to_owned());
        Self { title: Phrase::new(title).to_string(), title_id, planar, strokes: Vec::new() }
    }

    /// Adds a line.
    pub fn add(&mut self, kind: StrokeKind, name: impl Into<String>, points_mm: &[Vector]) {
        self.strokes.push(Stroke { kind, name: name.into(), points_mm: points_mm.to_vec() });
    }

    /// Adds an angle (rad) from the x axis of a frame about its z axis.
    pub fn angle(&mut self, name: impl Into<String>, frame: &Pose, radius_mm: f64, angle_rad: f64) {
        let at = |i: usize| frame.turn_z(angle_rad * i as f64 / ARC as f64).apply([radius_mm, 0.0, 0.0]);
        self.add(StrokeKind::Direction, name, &(0..=ARC).map(at).collect::<Vec<_>>());
    }

    /// Adds the axes of a frame, with the name at the x axis.
    pub fn frame(&mut self, name: &str, frame: &Pose, length_mm: f64) {
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate().take(if self.planar { 2 } else { 3 }) {
            let tip = frame.shift(axis, length_mm).translation_mm;
            let name = if axis == 0 { format!("{letter} {name}") } else { letter.to_owned() };
            self.add(StrokeKind::Direction, name.trim(), &[frame.translation_mm, tip]);
        }
    }

    /// Largest extent along a coordinate axis (mm).
    pub fn extent_mm(&self) -> f64 {
        let all = || self.strokes.iter().flat_map(|s| &s.points_mm);
        let along = |i: usize| {
            let ends = all().map(|p| p[i]).fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(v), b.max(v)));
            ends.1 - ends.0
        };
        (0..3).map(along).fold(0.0, f64::max)
    }
}
