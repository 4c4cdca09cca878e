//! Sphere.

use super::ball::{Ball, taubin};
use super::cloud::{Cloud, Source};
use super::coverage::Cap;
use super::descend::{SAMPLE, refine};
use super::element::{Element, Settings};
use super::result::Fit;
use crate::base::message::Result;
use crate::base::pose::Vector;

/// Fits a sphere to at least four points that are not in one plane.
///
/// Orthogonal distance (Shakarji 1998, 3.3) from Taubin's start.
pub fn sphere(points: &[Vector]) -> Result<Fit> {
    sphere_with(points, &Settings::default())
}

/// [`sphere`] with weights or a held radius.
pub fn sphere_with(points: &[Vector], settings: &Settings) -> Result<Fit> {
    settings.check(Element::Sphere)?;
    let cloud = Cloud::new(Element::Sphere, Source::Space(points.into()), settings)?;
    let (start, radius) = taubin::<4>(&cloud.thinned(SAMPLE).points().collect::<Vec<_>>());
    let held = settings.held_radius_mm().map(|r| r / cloud.scale_mm);
    let start = [start[0], start[1], start[2], held.unwrap_or(radius)];
    let refined = refine(Ball, &cloud, start, [true, true, true, held.is_none()]);
    let [x, y, z, radius] = refined.x;
    // derivatives by the centre are directions, that by the radius is one, both with the other sign
    let [mean_x, mean_y, mean_z, _] = refined.products.map(|row| row[3]);
    let cap = Cap::about([x, y, z], radius, [mean_x, mean_y, mean_z]);
    let mut fit = refined.to_fit(Element::Sphere, &cloud, [x, y, z], cap)?;
    fit.radius_mm = Some(radius * cloud.scale_mm);
    Ok(fit.compensated(settings.probe)?.with_warnings())
}
