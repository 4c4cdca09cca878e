//! Circle in the plane.

use super::axis::Chart;
use super::ball::{Disc, taubin};
use super::cloud::{Cloud, Source};
use super::coverage::Arc;
use super::descend::{Refined, SAMPLE, refine};
use super::element::{Element, Settings};
use super::result::Fit;
use crate::base::message::Result;
use crate::base::pose::Vector;

/// Fits a circle in the plane to at least three points that are not on one line; z of its centre is zero.
///
/// Orthogonal distance from Taubin's start (Chernov 2010, "Circular and linear regression", 4 and 5).
pub fn circle2d(points: &[[f64; 2]]) -> Result<Fit> {
    circle2d_with(points, &Settings::default())
}

/// [`circle2d`] with weights or a held radius.
pub fn circle2d_with(points: &[[f64; 2]], settings: &Settings) -> Result<Fit> {
    settings.check(Element::Circle2d)?;
    let cloud = Cloud::new(Element::Circle2d, Source::Plane(points), settings)?;
    let chart = Chart { d0: [0.0, 0.0, 1.0], e1: [1.0, 0.0, 0.0], e2: [0.0, 1.0, 0.0] };
    let refined = refine_circle(&cloud, chart, settings);
    let [x, y, radius] = refined.x;
    let mut fit = refined.to_fit(Element::Circle2d, &cloud, [x, y, 0.0], Arc::about(&chart, [x, y, 0.0]))?;
    fit.radius_mm = Some(radius * cloud.scale_mm);
    Ok(fit.compensated(settings.probe)?.with_warnings())
}

/// The circle through the points of `cloud` seen along the axis of `chart`.
pub(super) fn refine_circle(cloud: &Cloud, chart: Chart, settings: &Settings) -> Refined<Disc, 3> {
    let few: Vec<Vector> = cloud.thinned(SAMPLE).points().map(|q| chart.flat(q)).collect();
    let (centre, radius) = taubin::<3>(&few);
    let held = settings.held_radius_mm().map(|r| r / cloud.scale_mm);
    let start = [centre[0], centre[1], held.unwrap_or(radius)];
    refine(Disc { chart }, cloud, start, [true, true, held.is_none()])
}
