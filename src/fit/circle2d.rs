//! Circle in the plane.

use super::axis::{Chart, angles_about};
use super::ball::{Ball, taubin};
use super::cloud::Cloud;
use super::element::{Element, Settings};
use super::result::{Fit, arc_coverage};
use super::surface::{Refined, refine};
use crate::message::Result;
use crate::pose::Vector;
use crate::solve::Options;

/// Fits a circle in the plane to at least three points that are not on one line; z of its centre is zero.
///
/// Orthogonal distance from Taubin's start (Chernov 2010, "Circular and linear regression", 4 and 5).
pub fn circle2d(points: &[[f64; 2]]) -> Result<Fit> {
    circle2d_with(points, &Settings::default())
}

/// [`circle2d`] with weights or a held radius.
pub fn circle2d_with(points: &[[f64; 2]], settings: &Settings) -> Result<Fit> {
    settings.check(Element::Circle2d)?;
    let lifted: Vec<Vector> = points.iter().map(|p| [p[0], p[1], 0.0]).collect();
    let cloud = Cloud::new(Element::Circle2d, &lifted, settings)?;
    let refined = refine_circle(&cloud, settings);
    let [x, y, _, radius] = refined.x;
    let mut fit = refined.into_fit(Element::Circle2d, &Ball, &cloud, [x, y, 0.0])?;
    fit.radius_mm = Some(radius * cloud.scale_mm);
    let chart = Chart { d0: [0.0, 0.0, 1.0], e1: [1.0, 0.0, 0.0], e2: [0.0, 1.0, 0.0] };
    fit.coverage_rad = Some(arc_coverage(angles_about(&cloud.points, &chart, [x, y, 0.0])));
    Ok(fit.with_warnings())
}

/// The circle through x and y of the points of `cloud`.
pub(super) fn refine_circle(cloud: &Cloud, settings: &Settings) -> Refined<4, 1> {
    let (centre, radius) = taubin::<3>(cloud);
    let held = settings.radius_mm.map(|r| r / cloud.scale_mm);
    let start = [centre[0], centre[1], 0.0, held.unwrap_or(radius)];
    refine(&Ball, cloud, start, [true, true, false, held.is_none()], Options::default())
}
