//! Points from files with one coordinate a row, combined by the name of the point.

use super::Text;
use crate::Point;
use crate::dialect::Unit;
use etalon_base::phrase;
use std::collections::BTreeMap;

const AXES: [&str; 3] = ["X", "Y", "Z"];

/// Points in the order of their first rows.
#[derive(Default)]
pub(super) struct Pivot {
    points: Vec<Pivoted>,
    /// The last point of each key.
    last: BTreeMap<(String, String), usize>,
}

struct Pivoted {
    label: String,
    line: usize,
    xyz: [Option<f64>; 3],
    /// Other values of the same name.
    other: Vec<String>,
}

/// Statement of a row about a point.
pub(super) enum Said {
    /// A coordinate: index of the axis, value.
    Coordinate(usize, f64),
    /// Something else, in words.
    Other(String),
}

impl Pivot {
    /// Adds a row. A repeated coordinate begins the point of another piece.
    pub fn add(&mut self, line: usize, label: &str, kind: &str, said: Said) {
        let key = (label.to_owned(), kind.to_owned());
        let axis = if let Said::Coordinate(axis, _) = said { Some(axis) } else { None };
        let goes_on = |p: &usize| axis.is_none_or(|axis| self.points[*p].xyz[axis].is_none());
        let at = self.last.get(&key).copied().filter(goes_on).unwrap_or_else(|| {
            let label = label.to_owned();
            self.points.push(Pivoted { label, line, xyz: [None; 3], other: Vec::new() });
            self.points.len() - 1
        });
        self.last.insert(key, at);
        let point = &mut self.points[at];
        match said {
            Said::Coordinate(axis, value) => point.xyz[axis] = Some(value),
            Said::Other(what) => point.other.push(what),
        }
    }

    /// The points; a point without all coordinates is rejected.
    pub fn rows(self, text: &Text, unit: Unit) -> Vec<Point> {
        let row = |point: Pivoted| match point.xyz {
            [Some(x), Some(y), Some(z)] => text.point(point.line, &point.label, [x, y, z], unit),
            xyz => {
                let has = |there: bool| {
                    AXES.iter().zip(xyz).filter(move |(_, v)| v.is_some() == there).map(|(axis, _)| (*axis).to_owned())
                };
                let mut found: Vec<String> = has(true).chain(point.other).collect();
                found.dedup();
                let missing: Vec<String> = has(false).collect();
                let reason = phrase!("point-incomplete", found, missing);
                text.no_point(point.line, &point.label, reason)
            }
        };
        self.points.into_iter().map(row).collect()
    }
}
