//! Torus: a tube bent along a circle, whole or a piece of it.

use super::axis::{Axial, Chart, angles_about, length, refine_axis};
use super::ball::taubin;
use super::cloud::Cloud;
use super::element::{Element, Settings};
use super::result::{Fit, QUANTITIES, arc_coverage, largest_component_positive};
use super::search::{no_start, rival_warning, search};
use super::surface::Surface;
use crate::message::Result;
use crate::pose::Vector;
use crate::solve::{Options, symmetric_eigen};

/// Fits a torus to at least seven points that are not in one plane.
///
/// Orthogonal distance (ISO 10360-6:2001 tests it so). The start is searched over the hemisphere of axes, for each a
/// circle through the points seen along the axis, and a circle through them seen along the tube.
pub fn torus(points: &[Vector]) -> Result<Fit> {
    torus_with(points, &Settings::default())
}

/// [`torus`] with weights or a held axis.
pub fn torus_with(points: &[Vector], settings: &Settings) -> Result<Fit> {
    let held = settings.check(Element::Torus)?;
    let cloud = Cloud::new(Element::Torus, points, settings)?;
    let free = [true, true, true, held.is_none(), held.is_none(), true, true];
    let upright = |bend, x: [f64; 7]| (x[5] > 0.0 && x[6] > 0.0).then_some((bend, x));
    let found = search(&cloud, held, free, torus_along, upright, |chart| Bend { chart });
    let found = found.ok_or_else(|| no_start(Element::Torus))?;
    let (bend, refined) = refine_axis(found.surface, &cloud, found.start, free, Options::default());
    let [a, b, h, u, v, radius, minor] = refined.x;
    let (axis, _) = bend.chart.axis(u, v);
    let centre = bend.chart.point(a, b, h);
    let mut fit = refined.into_fit(Element::Torus, &bend, &cloud, centre)?;
    fit.point_along(axis, largest_component_positive(axis));
    fit.radius_mm = Some(radius * cloud.scale_mm);
    fit.minor_radius_mm = Some(minor * cloud.scale_mm);
    fit.coverage_rad = Some(arc_coverage(angles_about(&cloud.points, &bend.chart, centre)));
    fit.warnings.extend(found.rival.then(|| rival_warning(Element::Torus)));
    Ok(fit.with_warnings())
}

/// Distances of the centre from the middle of the points that are tried, to all four sides, in units of the length
/// of the piece (root mean square): seen along the axis, a short piece of a thick tube is no arc.
const REACHES: [f64; 10] = [0.7, -0.7, 1.2, -1.2, 2.0, -2.0, 4.0, -4.0, 8.0, -8.0];

/// A circle through the points seen along the axis, or a step square to the tube, gives the centre; a circle through
/// them seen along the tube then gives both radii.
fn torus_along(cloud: &Cloud, chart: Chart) -> Vec<(f64, [f64; 7])> {
    let flat = |points: Vec<Vector>| Cloud { points, roots: Vec::new(), ..*cloud };
    let points: Vec<[f64; 3]> = cloud.points.iter().map(|&q| chart.coordinates(q)).collect();
    let (suggested, _) = taubin::<3>(&flat(points.iter().map(|&[x, y, _]| [x, y, 0.0]).collect()));
    let sums = points.iter().fold([0.0; 3], |s, [x, y, _]| [s[0] + x * x, s[1] + x * y, s[2] + y * y]);
    let (values, directions) = symmetric_eigen([[sums[0], sums[1]], [sums[1], sums[2]]]);
    let extent = (values[1] / points.len().max(1) as f64).sqrt();
    // a piece shorter than it is thick lies across its own length
    let stepped = directions.into_iter().flat_map(|d| REACHES.map(|reach| d.map(|x| x * reach * extent)));
    let about = |centre: [f64; 2]| {
        let section = points.iter().map(|&[x, y, t]| [length(x - centre[0], y - centre[1]), t, 0.0]);
        let section = flat(section.collect());
        let ([radius, height, _], minor) = taubin::<3>(&section);
        let off = |q: &Vector| (length(q[0] - radius, q[1] - height) - minor).powi(2);
        let cost: f64 = section.points.iter().map(off).sum();
        (cost, [centre[0], centre[1], height, 0.0, 0.0, radius, minor])
    };
    std::iter::once([suggested[0], suggested[1]]).chain(stepped).map(about).collect()
}

/// Parameters a, b, h, u, v of the axis through the centre, the radius R and the radius r of the tube: a point has
/// the distance √((ρ - R)² + t²) - r.
pub(super) struct Bend {
    pub(super) chart: Chart,
}

impl Surface<7, 1> for Bend {
    fn distances(&self, x: &[f64; 7], q: Vector) -> [(f64, [f64; 7]); 1] {
        let at = self.chart.cylindrical([x[0], x[1], x[2], x[3], x[4]], q);
        let outward = at.rho - x[5];
        let from_core = length(outward, at.t);
        let (g_rho, g_t) = if from_core > 0.0 { (outward / from_core, at.t / from_core) } else { (0.0, 0.0) };
        let mut derivative = [0.0; 7];
        for (d, (rho, t)) in derivative.iter_mut().zip(at.d_rho.iter().zip(&at.d_t)) {
            *d = g_rho * rho + g_t * t;
        }
        derivative[5] = -g_rho;
        derivative[6] = -1.0;
        [(from_core - x[6], derivative)]
    }

    fn quantities(&self, _x: &[f64; 7]) -> [[f64; QUANTITIES]; 7] {
        let mut by_parameter = self.chart.quantities::<7>();
        by_parameter[5][6] = 1.0;
        by_parameter[6][7] = 1.0;
        by_parameter
    }
}

impl Axial<7, 1> for Bend {
    const SLIDES: bool = false;

    // a dozen points on a tube look like many things
    const STARTS: usize = 24;

    fn chart(&self) -> &Chart {
        &self.chart
    }

    fn with_chart(&self, chart: Chart) -> Self {
        Self { chart }
    }
}
