//! Minimum zone of a line in the plane: the narrowest strip that holds the points.

use super::super::cloud::{Cloud, Source};
use super::super::element::{Element, Settings};
use super::super::line::from_first_to_last;
use super::hull::narrowest_strip;
use super::{MinimumZone, SLACK};
use crate::base::message::Result;
use crate::base::pose::{Vector, dot, minus, unit};

/// Minimum zone of a line in the plane, of at least two different points; it runs from the first point to the last.
///
/// Two points hold one side and a third between them the other. Every edge of the convex hull was tried.
pub fn minimum_zone_line2d(points: &[[f64; 2]]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Line2d, Source::Plane(points), &Settings::default())?;
    let flat: Vec<[f64; 2]> = cloud.points().map(|q| [q[0], q[1]]).collect();
    let strip = narrowest_strip(&flat);
    let (along, width) = match &strip {
        Some(strip) => (minus(cloud.point(strip.edge[1]), cloud.point(strip.edge[0])), strip.width),
        None => (cloud.axes[0], 0.0),
    };
    let direction = from_first_to_last(&cloud, unit(along).unwrap_or(cloud.axes[0]));
    let left = [-direction[1], direction[0], 0.0];
    let heights: Vec<f64> = cloud.points().map(|q| dot(q, left)).collect();
    let (zone, middle) = MinimumZone::between(Element::Line2d, &heights, cloud.scale_mm);
    // the scale is a power of two
    let found = zone.form_mm / cloud.scale_mm;
    let holds = || alternate(&cloud, direction, &zone.lower, &zone.upper);
    Ok(MinimumZone {
        point_mm: cloud.to_mm(left.map(|x| x * middle)),
        direction: Some(direction),
        verified: found <= width + SLACK && (found <= SLACK || holds()),
        ..zone
    })
}

/// Whether the points of one side lie on both sides, along the line, of one of the other: no turn makes it narrower.
fn alternate(cloud: &Cloud, direction: Vector, lower: &[usize], upper: &[usize]) -> bool {
    let range = |side: &[usize]| {
        let along = side.iter().map(|&i| dot(cloud.point(i), direction));
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), t| (l.min(t), h.max(t)))
    };
    let (lower, upper) = (range(lower), range(upper));
    lower.0.max(upper.0) <= lower.1.min(upper.1) + SLACK
}
