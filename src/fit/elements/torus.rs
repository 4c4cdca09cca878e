//! Torus: a tube bent along a circle, complete or in part.

use crate::chart::{Chart, length};
use crate::circle_and_sphere::taubin;
use crate::cloud::{Cloud, Source};
use crate::coverage::Arc;
use crate::element::{Element, FitSettings};
use crate::f64x8::{F64x8, Points};
use crate::result::{Fit, QUANTITIES, largest_component_positive};
use crate::search::{Axial, no_start, rival_warning, search};
use crate::solver::{Surface, refine};
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_math::symmetric_eigen;

/// Fits a torus to at least seven non-coplanar points.
///
/// Minimises orthogonal distances, as tested to ISO 10360-6:2001. Starts are searched over the
/// hemisphere of axes, with a circle through the points projected along the axis and a circle
/// through their section along the tube for each axis.
pub fn torus(points: &[Vector], settings: &FitSettings) -> Result<Fit> {
    fit_torus(points.into(), settings)
}

pub(crate) fn fit_torus(points: Source, settings: &FitSettings) -> Result<Fit> {
    let held = settings.check(Element::Torus)?;
    let cloud = Cloud::new(Element::Torus, points, settings)?;
    let free = [true, true, true, held.is_none(), held.is_none(), true, true];
    let upright = |bend: Bend, x: [f64; 7]| (x[5] > 0.0 && x[6] > 0.0).then_some((bend, x));
    let found = search(&cloud, held, free, torus_along, upright);
    let found = found.ok_or_else(|| no_start(Element::Torus))?;
    let refined = refine(found.surface, &cloud, found.start, free);
    let chart = refined.surface.chart;
    let [a, b, h, _, _, radius, minor] = refined.x;
    let centre = chart.point(a, b, h);
    let mut fit = refined.to_fit(Element::Torus, &cloud, centre, Arc::about(&chart, centre))?;
    fit.point_along(chart.d0, largest_component_positive(chart.d0));
    fit.geometry.radius_mm = Some(radius * cloud.scale_mm);
    fit.geometry.minor_radius_mm = Some(minor * cloud.scale_mm);
    fit.warnings.extend(found.rival.then(|| rival_warning(Element::Torus)));
    fit.finished(settings)
}

/// Trial distances of the centre from the mean of the points along the two principal directions,
/// positive and negative, relative to the length of the piece (root mean square). They are needed
/// because a short piece of a thick tube, seen along the axis, is not an arc.
const REACHES: [f64; 10] = [0.7, -0.7, 1.2, -1.2, 2.0, -2.0, 4.0, -4.0, 8.0, -8.0];

/// Elements about an axis. The centre is the centre of a circle through the points projected along
/// the axis, or a step perpendicular to the tube; a circle through the section along the tube then
/// gives both radii.
fn torus_along(points: &[Vector], chart: Chart) -> Vec<(f64, [f64; 7])> {
    let points: Vec<[f64; 3]> = points.iter().map(|&q| chart.coordinates(q)).collect();
    let (suggested, _) = taubin::<3>(&points.iter().map(|&[x, y, _]| [x, y, 0.0]).collect::<Vec<_>>());
    let sums = points.iter().fold([0.0; 3], |s, [x, y, _]| [s[0] + x * x, s[1] + x * y, s[2] + y * y]);
    let (values, directions) = symmetric_eigen([[sums[0], sums[1]], [sums[1], sums[2]]]);
    let extent = (values[1] / points.len().max(1) as f64).sqrt();
    // a piece shorter than its thickness extends across the tube
    let stepped = directions.into_iter().flat_map(|d| REACHES.map(|reach| d.map(|x| x * reach * extent)));
    let about = |centre: [f64; 2]| {
        let section = points.iter().map(|&[x, y, t]| [length(x - centre[0], y - centre[1]), t, 0.0]);
        let section: Vec<Vector> = section.collect();
        let ([radius, height, _], minor) = taubin::<3>(&section);
        let off = |q: &Vector| (length(q[0] - radius, q[1] - height) - minor).powi(2);
        let cost: f64 = section.iter().map(off).sum();
        (cost, [centre[0], centre[1], height, 0.0, 0.0, radius, minor])
    };
    std::iter::once([suggested[0], suggested[1]]).chain(stepped).map(about).collect()
}

/// Torus. Parameters: axis (a, b, h, u, v) through the centre, radius R of the centre line and
/// radius r of the tube. The distance of a point is √((ρ − R)² + t²) − r.
#[derive(Clone, Copy)]
pub(crate) struct Bend {
    pub(crate) chart: Chart,
}

impl Surface<7, 1> for Bend {
    #[inline(always)]
    fn distances(&self, x: &[f64; 7], q: Points) -> [(F64x8, [F64x8; 7]); 1] {
        let at = self.chart.cylindrical([x[0], x[1], x[2]], 0.0, q);
        let outward = at.rho - x[5];
        let from_core = (outward * outward + at.t * at.t).sqrt();
        let inverse = from_core.inverse_or_zero();
        let (g_rho, g_t) = (outward * inverse, at.t * inverse);
        let mut d = at.d_rho;
        for (rho, t) in d.iter_mut().zip(at.d_t) {
            *rho = g_rho * *rho + g_t * t;
        }
        let [a, b, h, u, v] = d;
        [(from_core - x[6], [a, b, h, u, v, -g_rho, F64x8::all(-1.0)])]
    }

    fn recharted(&self, x: &[f64; 7]) -> (Self, [f64; 7]) {
        let (chart, x) = self.chart.moved(x);
        (Self { chart }, x)
    }

    fn quantities(&self, _x: &[f64; 7]) -> [[f64; QUANTITIES]; 7] {
        let mut by_parameter = self.chart.quantities::<7>();
        by_parameter[5][6] = 1.0;
        by_parameter[6][7] = 1.0;
        by_parameter
    }
}

impl Axial<7, 1> for Bend {
    // a dozen points on a tube are ambiguous
    const STARTS: usize = 24;

    fn on(chart: Chart) -> Self {
        Self { chart }
    }

    fn chart(&self) -> &Chart {
        &self.chart
    }
}
