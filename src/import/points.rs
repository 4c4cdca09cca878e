//! Points of exports.

use crate::base::message::Result;
use crate::base::pose::Vector;
use crate::base::pose_name::PoseName;
use crate::base::table::pose_column;
use polars::prelude::{Column, DataFrame, NamedFrom, Series};
use std::sync::Arc;

/// A row of an export. A reader fills in what the row states; what the campaign states of the export comes after.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point {
    /// File, as the campaign names it.
    pub export: Arc<str>,
    /// Number among the data rows of its export, from 1, refused ones counted.
    pub row: i64,
    /// Line of the file, from 1.
    pub line: usize,
    /// The line itself.
    pub text: String,
    /// As the row bears it; several parts joined by `::`.
    pub label: String,
    /// Name of the target.
    pub target: Option<String>,
    /// Name of the pose.
    pub pose: Option<PoseName>,
    /// Number of the repeat.
    pub cycle: Option<i64>,
    /// Time in seconds.
    pub time_s: Option<f64>,
    /// Place; no numbers where one of them does not read.
    pub xyz_mm: Vector,
    /// Of x, y and z, where the file states it.
    pub standard_uncertainty_mm: Option<Box<Vector>>,
    /// Direction of surface or probe, of length 1, where the file states it.
    pub direction: Option<Box<Vector>>,
    /// The rule that refuses it.
    pub refused: Option<String>,
}

/// Points as a table: `export row line label target pose cycle time_s x_mm y_mm z_mm`, and what few files state.
pub fn table(points: &[Point]) -> Result<DataFrame> {
    let p = points;
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
        pose_column("pose", &p.iter().map(|p| p.pose).collect::<Vec<_>>()),
        whole("cycle", &|p| p.cycle),
        real("time_s", &|p| p.time_s),
        real("x_mm", &|p| Some(p.xyz_mm[0])),
        real("y_mm", &|p| Some(p.xyz_mm[1])),
        real("z_mm", &|p| Some(p.xyz_mm[2])),
    ];
    // few files state these
    if p.iter().any(|p| p.standard_uncertainty_mm.is_some()) {
        let of = |axis: usize| move |p: &Point| p.standard_uncertainty_mm.as_ref().map(|u| u[axis]);
        columns.extend([real("ux_mm", &of(0)), real("uy_mm", &of(1)), real("uz_mm", &of(2))]);
    }
    if p.iter().any(|p| p.direction.is_some()) {
        let of = |axis: usize| move |p: &Point| p.direction.as_ref().map(|d| d[axis]);
        columns.extend([real("i", &of(0)), real("j", &of(1)), real("k", &of(2))]);
    }
    Ok(DataFrame::new(p.len(), columns)?)
}
