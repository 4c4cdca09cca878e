//! Circular cylinder.

use crate::chart::Chart;
use crate::circle_and_sphere::taubin;
use crate::cloud::{Cloud, Gather, Source};
use crate::coverage::Arc;
use crate::element::{Element, FitSettings};
use crate::f64x8::{F64x8, Points};
use crate::result::{Fit, QUANTITIES, largest_component_positive};
use crate::search::{Axial, no_start, rival_warning, search};
use crate::solver::{Surface, refine};
use etalon_base::message::Result;
use etalon_base::pose::Vector;

/// Fits a cylinder to at least five non-coplanar points.
///
/// Minimises orthogonal distances to the axis (Shakarji 1998, 3.4). Starts are searched over the
/// hemisphere of axes, with a circle for each axis (after Eberly, "Fitting 3D data with a
/// cylinder", Geometric Tools 2019); the best starts are refined.
///
/// # Examples
///
/// ```
/// use etalon_fit::{FitSettings, cylinder};
///
/// // three sections of a bore of radius 5 mm about the z axis
/// let section_mm = [[5.0, 0.0], [3.0, 4.0], [-3.0, 4.0], [-5.0, 0.0], [-3.0, -4.0], [3.0, -4.0]];
/// let points_mm = [0.0, 20.0, 40.0].map(|z| section_mm.map(|[x, y]| [x, y, z])).concat();
/// let bore = cylinder(&points_mm, &FitSettings::default())?;
///
/// assert!((bore.geometry.radius_mm.expect("a cylinder has a radius") - 5.0).abs() < 1e-9);
/// let [_, _, z] = bore.geometry.direction.expect("a cylinder has an axis");
/// assert!((z - 1.0).abs() < 1e-9);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
pub fn cylinder(points: &[Vector], settings: &FitSettings) -> Result<Fit> {
    fit_cylinder(points.into(), settings)
}

pub(crate) fn fit_cylinder(points: Source, settings: &FitSettings) -> Result<Fit> {
    let held = settings.check(Element::Cylinder)?;
    let cloud = Cloud::new(Element::Cylinder, points, settings)?;
    let radius = settings.held_radius_mm().map(|r| r / cloud.scale_mm);
    let free = [true, true, false, held.is_none(), held.is_none(), radius.is_none()];
    let found = search(
        &cloud,
        held,
        free,
        |few, chart| {
            let (cost, mut start) = circle_along(few, &chart);
            start[5] = radius.unwrap_or(start[5]);
            vec![(cost, start)]
        },
        |tube: Tube, x| (x[5] > 0.0).then_some((tube, x)),
    );
    let found = found.ok_or_else(|| no_start(Element::Cylinder))?;
    let refined = refine(found.surface, &cloud, found.start, free);
    let chart = refined.surface.chart;
    let [a, b, h, _, _, radius] = refined.x;
    let foot = chart.point(a, b, h);
    let mut fit = refined.to_fit(Element::Cylinder, &cloud, foot, Arc::about(&chart, foot))?;
    fit.point_along(chart.d0, largest_component_positive(chart.d0));
    fit.geometry.radius_mm = Some(radius * cloud.scale_mm);
    fit.warnings.extend(found.rival.then(|| rival_warning(Element::Cylinder)));
    fit.finished(settings)
}

/// Circle through the points projected along the axis.
fn circle_along(points: &[Vector], chart: &Chart) -> (f64, [f64; 6]) {
    let flat: Vec<Vector> = points.iter().map(|&q| chart.flat(q)).collect();
    let (centre, radius) = taubin::<3>(&flat);
    let cost = Cloud::about(centre, &flat).gather(OffCircle { radius, squares: F64x8::default() });
    (cost, [centre[0], centre[1], 0.0, 0.0, 0.0, radius])
}

/// Sum of squared distances from a circle about the origin.
#[derive(Clone)]
struct OffCircle {
    radius: f64,
    squares: F64x8,
}

impl Gather for OffCircle {
    type Sum = f64;

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        let [x, y, _] = q;
        let off = (x * x).plus(y, y).sqrt() - self.radius;
        self.squares = self.squares.plus(w * off, off);
    }

    fn close(self) -> f64 {
        self.squares.sum()
    }

    fn join(a: f64, b: f64) -> f64 {
        a + b
    }
}

/// Cylinder. Parameters: axis (a, b, h, u, v) with h held at the foot of the centroid, and radius.
#[derive(Clone, Copy)]
pub(crate) struct Tube {
    pub(crate) chart: Chart,
}

impl Surface<6, 1> for Tube {
    const IDLE: usize = 2;

    #[inline(always)]
    fn distances(&self, x: &[f64; 6], q: Points) -> [(F64x8, [F64x8; 6]); 1] {
        let at = self.chart.cylindrical([x[0], x[1], x[2]], x[5], q);
        let d = at.d_rho;
        [(at.rho - x[5], [d[0], d[1], d[2], d[3], d[4], F64x8::all(-1.0)])]
    }

    fn recharted(&self, x: &[f64; 6]) -> (Self, [f64; 6]) {
        let (chart, mut x) = self.chart.moved(x);
        x[2] = 0.0;
        (Self { chart }, x)
    }

    fn quantities(&self, x: &[f64; 6]) -> [[f64; QUANTITIES]; 6] {
        let mut by_parameter = self.chart.quantities::<6>();
        by_parameter[5][6] = 1.0;
        // the foot of the centroid stays perpendicular to the axis
        for (row, along) in [(3, x[0]), (4, x[1])] {
            for (quantity, d) in by_parameter[row].iter_mut().zip(self.chart.d0) {
                *quantity -= along * d;
            }
        }
        by_parameter
    }
}

impl Axial<6, 1> for Tube {
    fn on(chart: Chart) -> Self {
        Self { chart }
    }

    fn chart(&self) -> &Chart {
        &self.chart
    }
}
