//! Points of exports.

use crate::table::{RowGroups, frame, pose_column_as};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use indexmap::IndexSet;
use polars::prelude::{Column, DataFrame, NamedFrom, Series};
use std::fmt::{self, Debug, Formatter};
use std::ops::Deref;
use std::sync::Arc;

/// Row of an export. The reader fills in the contents of the row; statements of the campaign
/// follow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point {
    /// File as named in the campaign.
    pub export: Arc<str>,
    /// Number of the data row in its export, from 1; rejected rows count.
    pub row: i64,
    /// Line of the file, from 1.
    pub line: usize,
    /// The line itself.
    pub text: Line,
    /// Label in the row; several parts are joined by `::`.
    pub label: Arc<str>,
    /// Name of the target.
    pub target: Option<Arc<str>>,
    /// Name of the pose.
    pub pose: Option<PoseName>,
    /// Number of the repeat.
    pub cycle: Option<i64>,
    /// Time (s).
    pub time_s: Option<f64>,
    /// Position; NaN if a coordinate cannot be read.
    pub xyz_mm: Vector,
    /// Standard uncertainties of x, y and z, if the file states them.
    pub standard_uncertainty_mm: Option<Box<Vector>>,
    /// Direction of surface or probe (unit vector), if the file states it.
    pub direction: Option<Box<Vector>>,
    /// Orientation of the measured body in the frame of the file (quaternion, scalar first), if the
    /// file states it.
    pub orientation: Option<Box<[f64; 4]>>,
    /// Temperature during the measurement (°C), if the file states it.
    pub temperature_c: Option<f64>,
    /// Rule that rejects the row.
    pub refused: Option<Box<Phrase>>,
    /// `true` if the campaign leaves the row out: by a filter, or as marked as deleted.
    pub is_left_out: bool,
}

/// Line of a text that shares the memory of the text: exports have millions of lines.
#[derive(Clone, PartialEq)]
pub struct Line {
    whole: Arc<str>,
    from: u32,
    to: u32,
}

impl Line {
    /// Returns a part of a text; another string is copied.
    pub fn of(whole: &Arc<str>, part: &str) -> Self {
        let from = (part.as_ptr() as usize).checked_sub(whole.as_ptr() as usize);
        let range = from.and_then(|from| Some((u32::try_from(from).ok()?, u32::try_from(from + part.len()).ok()?)));
        match range.filter(|&(from, to)| whole.get(from as usize..to as usize) == Some(part)) {
            Some((from, to)) => Self { whole: whole.clone(), from, to },
            None => part.to_owned().into(),
        }
    }
}

impl Deref for Line {
    type Target = str;

    fn deref(&self) -> &str {
        self.whole.get(self.from as usize..self.to as usize).unwrap_or_default()
    }
}

impl From<&Line> for String {
    fn from(line: &Line) -> Self {
        (**line).to_owned()
    }
}

impl From<String> for Line {
    fn from(text: String) -> Self {
        let to = u32::try_from(text.len()).unwrap_or(u32::MAX);
        Self { whole: text.into(), from: 0, to }
    }
}

impl Default for Line {
    fn default() -> Self {
        String::new().into()
    }
}

impl Debug for Line {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        (**self).fmt(f)
    }
}

/// Names of many rows, stored once each.
#[derive(Debug, Default)]
pub struct Names(IndexSet<Arc<str>>);

impl Names {
    /// Maximum number of stored names. Beyond it names probably differ from row to row, and storing
    /// them costs more than it saves.
    const MOST: usize = 4096;

    /// Returns the name, sharing the memory of an equal name before it.
    pub fn shared(&mut self, name: &str) -> Arc<str> {
        if let Some(known) = self.0.get(name) {
            return known.clone();
        }
        let name: Arc<str> = name.into();
        if self.0.len() < Self::MOST {
            self.0.insert(name.clone());
        }
        name
    }
}

/// Returns points as a table `export row line label target pose cycle time_s x_mm y_mm z_mm`, with
/// uncertainties and directions if a point has them.
pub fn table(points: &[Point]) -> Result<DataFrame> {
    Stated::of(points).table(points)
}

/// Number of rows that are written at a time.
const PIECE: usize = 100_000;

/// Returns the table of points as Parquet, written piece by piece: exports have millions of rows.
pub fn to_parquet(points: &[Point]) -> Result<Vec<u8>> {
    let (stated, mut bytes) = (Stated::of(points), Vec::new());
    let mut written = RowGroups::new(&mut bytes, &stated.table(&[])?)?;
    points.chunks(PIECE).try_for_each(|piece| written.add(&stated.table(piece)?))?;
    written.finish()?;
    Ok(bytes)
}

/// Optional columns of a table of points.
struct Stated {
    /// `true` if all names of poses are numbers.
    numbered_poses: bool,
    uncertainties: bool,
    directions: bool,
}

impl Stated {
    fn of(points: &[Point]) -> Self {
        Self {
            numbered_poses: points.iter().filter_map(|p| p.pose).all(|pose| pose.number().is_some()),
            uncertainties: points.iter().any(|p| p.standard_uncertainty_mm.is_some()),
            directions: points.iter().any(|p| p.direction.is_some()),
        }
    }

    fn table(&self, p: &[Point]) -> Result<DataFrame> {
        let strings = |name: &str, f: &dyn Fn(&Point) -> Option<&str>| -> Column {
            Series::new(name.into(), p.iter().map(f).collect::<Vec<_>>()).into()
        };
        let whole = |name: &str, f: &dyn Fn(&Point) -> Option<i64>| -> Column {
            Series::new(name.into(), p.iter().map(f).collect::<Vec<_>>()).into()
        };
        let real = |name: &str, f: &dyn Fn(&Point) -> Option<f64>| -> Column {
            Series::new(name.into(), p.iter().map(f).collect::<Vec<_>>()).into()
        };
        let mut columns = vec![
            strings("export", &|p| Some(&p.export)),
            whole("row", &|p| Some(p.row)),
            whole("line", &|p| Some(p.line as i64)),
            strings("label", &|p| Some(&p.label)),
            strings("target", &|p| p.target.as_deref()),
            pose_column_as("pose", &p.iter().map(|p| p.pose).collect::<Vec<_>>(), self.numbered_poses),
            whole("cycle", &|p| p.cycle),
            real("time_s", &|p| p.time_s),
            real("x_mm", &|p| Some(p.xyz_mm[0])),
            real("y_mm", &|p| Some(p.xyz_mm[1])),
            real("z_mm", &|p| Some(p.xyz_mm[2])),
        ];
        if self.uncertainties {
            let of = |axis: usize| move |p: &Point| p.standard_uncertainty_mm.as_ref().map(|u| u[axis]);
            columns.extend([real("ux_mm", &of(0)), real("uy_mm", &of(1)), real("uz_mm", &of(2))]);
        }
        if self.directions {
            let of = |axis: usize| move |p: &Point| p.direction.as_ref().map(|d| d[axis]);
            columns.extend([real("i", &of(0)), real("j", &of(1)), real("k", &of(2))]);
        }
        frame(p.len(), columns)
    }
}
