//! Points of exports.

use crate::dialect::Unit;
use crate::parquet::{RowGroups, frame, pose_column};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Place, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use indexmap::IndexSet;
use polars::prelude::{Column, DataFrame, NamedFrom, Series};
use std::borrow::Borrow;
use std::fmt::{self, Debug, Display, Formatter};
use std::ops::{Deref, DerefMut};
use std::sync::{Arc, LazyLock};

/// Row of an export. The reader fills in the contents of the row; data of the campaign follow.
/// Exports have millions of rows, and most contain only a label and a position: other data of a row
/// are in [`Stated`], to which a point dereferences.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point {
    /// File as named in the campaign.
    pub export: SharedText,
    /// Number of the data row in its export, from 1; rejected rows count.
    pub row: u32,
    /// Line of the file, from 1.
    pub line: u32,
    /// The line itself.
    pub text: Line,
    /// Label in the row; several parts are joined by `::`.
    pub label: SharedText,
    /// Position; NaN if a coordinate cannot be read.
    pub xyz_mm: Vector,
    /// Further data of the row, if any.
    pub more: Option<Box<Stated>>,
}

/// Further values of a row of an export, in addition to label and position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stated {
    /// Name of the target.
    pub target: Option<SharedText>,
    /// Name of the pose.
    pub pose: Option<PoseName>,
    /// Number of the repeat.
    pub cycle: Option<i64>,
    /// Time (s).
    pub time_s: Option<f64>,
    /// Standard uncertainties of x, y and z, if the file contains them.
    pub standard_uncertainty_mm: Option<Vector>,
    /// Direction of surface or probe (unit vector), if the file contains it.
    pub direction: Option<Vector>,
    /// Orientation of the measured body in the frame of the file (quaternion, scalar first), if
    /// the file contains it.
    pub orientation: Option<[f64; 4]>,
    /// Temperature during the measurement (°C), if the file contains it.
    pub temperature_c: Option<f64>,
    /// Rule that rejects the row.
    pub refused: Option<Box<Phrase>>,
    /// `true` if the campaign leaves the row out: by a filter, or as marked as deleted.
    pub is_left_out: bool,
}

impl Stated {
    const NOTHING: Self = Self {
        target: None,
        pose: None,
        cycle: None,
        time_s: None,
        standard_uncertainty_mm: None,
        direction: None,
        orientation: None,
        temperature_c: None,
        refused: None,
        is_left_out: false,
    };

    /// The statements in the memory that they need: none if there are none.
    pub fn boxed(self) -> Option<Box<Self>> {
        (self != Self::NOTHING).then(|| Box::new(self))
    }
}

impl Point {
    /// Point of a line (from 1) with a label; `xyz` is in `unit`.
    pub(crate) fn from_line(line: usize, text: Line, label: SharedText, xyz: Vector, unit: Unit) -> Self {
        Self { line: line as u32, text, label, xyz_mm: xyz.map(|v| v * unit.in_mm()), ..Self::default() }
    }

    /// The line in the export.
    pub fn place(&self) -> Place {
        self.place_in(&*self.export)
    }

    /// Returns the line in a file of this name.
    pub fn place_in(&self, file: impl Into<String>) -> Place {
        let line = self.line as usize;
        match self.text.is_empty() {
            true => Place { line: Some(line), ..Place::file(file) },
            false => Place::line(file, line, &*self.text),
        }
    }
}

/// `true` if the frame of the rows is built on measured points: one row is the origin, and another
/// row lies on an axis, with exact zeros across it.
///
/// Axes along which no row differs, as across a plane, do not count.
pub fn has_frame_on_points(rows: &[Point]) -> bool {
    let measured = || rows.iter().filter(|row| row.refused.is_none() && row.xyz_mm.iter().all(|v| v.is_finite()));
    if measured().filter(|row| row.xyz_mm == [0.0; 3]).take(2).count() != 1 {
        return false;
    }
    let varies = [0, 1, 2].map(|axis| measured().any(|row| row.xyz_mm[axis] != 0.0));
    let varying = varies.iter().filter(|varies| **varies).count();
    varying > 1 && measured().any(|row| row.xyz_mm.iter().filter(|v| **v != 0.0).count() == 1)
}

impl Deref for Point {
    type Target = Stated;

    fn deref(&self) -> &Stated {
        static NOTHING: Stated = Stated::NOTHING;
        self.more.as_deref().unwrap_or(&NOTHING)
    }
}

impl DerefMut for Point {
    fn deref_mut(&mut self) -> &mut Stated {
        self.more.get_or_insert_default()
    }
}

/// A text that many rows share; a reference to it is as small as a pointer.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SharedText(Arc<Box<str>>);

impl Deref for SharedText {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}

impl Borrow<str> for SharedText {
    fn borrow(&self) -> &str {
        self
    }
}

impl From<&str> for SharedText {
    fn from(text: &str) -> Self {
        Self(Arc::new(text.into()))
    }
}

impl From<String> for SharedText {
    fn from(text: String) -> Self {
        Self(Arc::new(text.into_boxed_str()))
    }
}

impl Default for SharedText {
    fn default() -> Self {
        static EMPTY: LazyLock<SharedText> = LazyLock::new(|| "".into());
        EMPTY.clone()
    }
}

impl Display for SharedText {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(self)
    }
}

impl Debug for SharedText {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        Debug::fmt(&**self, f)
    }
}

/// Line of a text that shares the memory of the text: exports have millions of lines.
#[derive(Clone, Default, PartialEq)]
pub struct Line {
    whole: SharedText,
    from: u32,
    to: u32,
}

impl Line {
    /// Bytes of a text.
    pub(super) fn at(whole: &SharedText, from: u32, to: u32) -> Self {
        Self { whole: whole.clone(), from, to }
    }

    /// Returns a part of a text; another string is copied.
    pub fn from_part(whole: &SharedText, part: &str) -> Self {
        let from = (part.as_ptr() as usize).checked_sub(whole.as_ptr() as usize);
        let range = from.and_then(|from| Some((u32::try_from(from).ok()?, u32::try_from(from + part.len()).ok()?)));
        let is_part = |text: &str| std::ptr::eq(text, part);
        match range.filter(|&(from, to)| whole.get(from as usize..to as usize).is_some_and(is_part)) {
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

impl Debug for Line {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        Debug::fmt(&**self, f)
    }
}

/// Names of many rows, stored once each.
#[derive(Debug, Default)]
pub struct Names {
    known: IndexSet<SharedText>,
    /// Name of the row before: rows of a scan have the same label.
    last: SharedText,
}

impl Names {
    /// Maximum number of stored names. Beyond it names probably differ from row to row, and
    /// storing them costs more than it saves.
    const MOST: usize = 4096;

    /// Returns the name, sharing the memory of an equal name before it.
    pub fn shared(&mut self, name: &str) -> SharedText {
        if *self.last != *name {
            self.last = match self.known.get(name) {
                Some(known) => known.clone(),
                None => self.added(name),
            };
        }
        self.last.clone()
    }

    fn added(&mut self, name: &str) -> SharedText {
        let name: SharedText = name.into();
        if self.known.len() < Self::MOST {
            self.known.insert(name.clone());
        }
        name
    }
}

/// Number of rows that are written at a time.
const PIECE: usize = 100_000;
/// Number of rows whose memory is released together: blocks of this size (36 MB) go back to the
/// system at once.
const RELEASED: usize = 5 * PIECE;

/// Returns points as the Parquet table `export row line label target pose cycle time_s x_mm y_mm
/// z_mm`, with uncertainties and directions if a point has them. It is written piece by piece, and
/// the memory of each piece is released: exports have millions of rows.
pub fn to_parquet(mut points: Vec<Point>) -> Result<Vec<u8>> {
    let (stated, mut bytes) = (OptionalColumns::new(&points), Vec::new());
    let mut pieces = Vec::new();
    while points.len() > RELEASED {
        pieces.push(points.split_off((points.len() - 1) / RELEASED * RELEASED));
        points.shrink_to_fit();
    }
    pieces.push(points);
    let mut written = RowGroups::new(&mut bytes, &stated.table(&[])?)?;
    while let Some(piece) = pieces.pop() {
        piece.chunks(PIECE).try_for_each(|rows| written.add(&stated.table(rows)?))?;
    }
    written.finish()?;
    Ok(bytes)
}

/// Optional columns of a table of points.
struct OptionalColumns {
    /// `true` if all names of poses are numbers.
    numbered_poses: bool,
    uncertainties: bool,
    directions: bool,
}

impl OptionalColumns {
    fn new(points: &[Point]) -> Self {
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
            whole("row", &|p| Some(i64::from(p.row))),
            whole("line", &|p| Some(i64::from(p.line))),
            strings("label", &|p| Some(&p.label)),
            strings("target", &|p| p.target.as_deref()),
            pose_column("pose", &p.iter().map(|p| p.pose).collect::<Vec<_>>(), self.numbered_poses),
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
