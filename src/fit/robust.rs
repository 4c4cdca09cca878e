//! Fits without outliers: trimmed least squares over the points that one element explains.
//!
//! The result is the least-squares element of these points, with its usual covariance: so few
//! correct points are lost that they do not change it.

use super::growth::{BEGIN, Search, reduction, studentised};
use super::prediction::equations;
use super::{CircleMethod, Element, Fit, FitSettings, Source, element};
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Vector, cross, dot, minus, norm};
use etalon_base::{error, warning};
use etalon_math::statistics::repeated_rows;

/// Fewest points by minimum number of points of the element among which outliers can be told.
const FEWEST: usize = 3;
/// Residuals below this share of the size of the element are rounding.
const ROUNDING: f64 = 1e-13;
/// Maximum number of points of a fit that is checked for outliers without a request.
const CHECKED: usize = 20_000;
/// Maximum share of outliers that is reported without a request.
const FEW: f64 = 0.15;
/// Change of the element, in its standard uncertainties, beyond which outliers are reported.
const SHIFTED: f64 = 3.0;

/// Fit without outliers.
#[derive(Clone, Debug)]
pub struct RobustElement {
    /// Fit of the points that are used.
    pub fit: Fit,
    /// Indices of the points that are excluded.
    pub set_aside: Vec<usize>,
}

/// Effect of outliers on a fit of all points.
#[derive(Clone, Debug, PartialEq)]
pub struct OutlyingPoints {
    /// Indices of the outliers.
    pub points: Vec<usize>,
    /// Largest change of point, direction or radius that they cause, in standard uncertainties of
    /// the fit without them.
    pub shift: f64,
}

impl RobustElement {
    /// Warning that lists the points that are excluded, if any.
    pub fn warning(&self) -> Option<Message> {
        let (count, points) = (self.set_aside.len(), listed(&self.set_aside));
        (count > 0).then(|| warning!("points-set-aside", count, points))
    }
}

/// Numbers, from 1, of points in a message.
fn listed(indices: &[usize]) -> String {
    let shown: Vec<String> = indices.iter().take(MOST_LISTED).map(|i| (i + 1).to_string()).collect();
    shown.join(", ") + if indices.len() > MOST_LISTED { ", ..." } else { "" }
}

/// Maximum number of points that a message lists.
const MOST_LISTED: usize = 20;

/// All warnings about an element and its points, whichever fit is asked for: of the least-squares
/// fit `fit`, and about outliers and repeated points among up to 20,000.
pub fn warnings(fit: &Fit, points: &Source, settings: &FitSettings) -> Vec<Message> {
    let outlying = outlying_points(fit, points, settings).map(|found| {
        let (count, points) = (found.points.len(), listed(&found.points));
        warning!("points-outlying", count, points, shift = found.shift)
    });
    let few = points.len() <= CHECKED;
    let repeated = few.then(|| repeated(&(0..points.len()).map(|i| points.at(i)).collect::<Vec<_>>())).flatten();
    fit.warnings.iter().cloned().chain(outlying).chain(repeated).collect()
}

/// Warning of points that repeat an earlier point digit for digit: copies are no measurements.
fn repeated(points: &[Vector]) -> Option<Message> {
    let found: Vec<usize> = repeated_rows(points).into_iter().map(|[i, _]| i).collect();
    (!found.is_empty()).then(|| warning!("points-repeated", count = found.len(), points = listed(&found)))
}

/// Fits an element without the points that are far from all others.
///
/// # Errors
/// Fails like [`element`], and with fewer points than three times the minimum: among so few points
/// no outlier can be found.
pub fn robust_element(kind: Element, points: &[Vector], settings: &FitSettings) -> Result<RobustElement> {
    let needed = FEWEST * kind.minimum_points();
    if points.len() < needed {
        return Err(error!("robust-few-points", element = kind, needed, points = points.len()).into());
    }
    // errors of the points themselves are taken from the plain fit
    let all = element(kind, points, settings)?;
    let search = Search::new(kind, points, searching(settings));
    let Some(used) = search.explained().filter(|used| used.len() < points.len()) else {
        return Ok(RobustElement { fit: with_repeats(all, points), set_aside: Vec::new() });
    };
    let kept: Vec<Vector> = used.iter().map(|i| points[*i]).collect();
    let weights: Option<Vec<f64>> = settings.weights.map(|w| used.iter().map(|i| w[*i]).collect());
    let fit = element(kind, &kept, &FitSettings { weights: weights.as_deref(), ..*settings })?;
    let set_aside = (0..points.len()).filter(|i| used.binary_search(i).is_err()).collect();
    Ok(RobustElement { fit: with_repeats(fit, points), set_aside })
}

/// Fit with the warning of repeated points.
fn with_repeats(mut fit: Fit, points: &[Vector]) -> Fit {
    fit.warnings.extend(repeated(points));
    fit
}

/// Settings of the search: the centres of a probe are fitted as measured, circles in space by
/// orthogonal distances.
fn searching<'a>(settings: &FitSettings<'a>) -> FitSettings<'a> {
    FitSettings {
        radius_mm: settings.held_radius_mm(),
        probe: None,
        circle: CircleMethod::Orthogonal,
        standard_uncertainty_mm: None,
        ..*settings
    }
}

/// Outliers that shift a fit of all points beyond its uncertainty; `None` without such points, and
/// for too many points to check without a request.
pub fn outlying_points(fit: &Fit, points: &Source, settings: &FitSettings) -> Option<OutlyingPoints> {
    let n = points.len();
    if n > CHECKED || n < FEWEST * fit.element.minimum_points() {
        return None;
    }
    let all: Vec<Vector> = (0..n).map(|i| points.at(i)).collect();
    if fit.compensation.is_none() && plausible(fit, &all, settings.weights) {
        return None;
    }
    let robust = robust_element(fit.element, &all, settings).ok()?;
    let few = !robust.set_aside.is_empty() && robust.set_aside.len() as f64 <= FEW * n as f64;
    let shift = if few { shift(fit, &robust.fit)? } else { 0.0 };
    (shift > SHIFTED).then_some(OutlyingPoints { points: robust.set_aside, shift })
}

/// `true` if the distances of all points can be noise, by the spread of the nearest ones.
fn plausible(fit: &Fit, points: &[Vector], weights: Option<&[f64]>) -> bool {
    let mean = weights.map_or(1.0, |w| w.iter().sum::<f64>() / w.len().max(1) as f64);
    let weight = |i: usize| weights.map_or(1.0, |w| w[i] / mean);
    let mut distances: Vec<f64> = points.iter().enumerate().map(|(i, p)| studentised(fit, *p, weight(i))).collect();
    distances.sort_by(f64::total_cmp);
    let begin = ((BEGIN * points.len() as f64) as usize).max(1);
    let squares: f64 = distances.iter().take(begin).map(|d| d * d).sum();
    let equations = equations(fit.element);
    let reduced = reduction(begin as f64 / points.len() as f64, equations);
    let deviation = (squares / (begin * equations) as f64).sqrt() / reduced;
    let size = norm(fit.geometry.point_mm) + fit.geometry.radius_mm.unwrap_or_default();
    let most = distances.last().copied().unwrap_or_default();
    most <= (CLEAN * deviation).max(ROUNDING * size)
}

/// Maximum residual, in standard deviations, of points that are not looked at further.
const CLEAN: f64 = 3.5;

/// Largest difference of two fits in standard uncertainties of the second.
fn shift(all: &Fit, robust: &Fit) -> Option<f64> {
    let u = robust.standard_uncertainty()?;
    let over = |difference: f64, u: f64| if u > 0.0 { difference.abs() / u } else { 0.0 };
    let moved = minus(all.geometry.point_mm, robust.geometry.point_mm);
    // points slide along a line, axis or plane with the centroid of the points
    let moved = match (all.element, robust.geometry.direction) {
        (Element::Line | Element::Line2d | Element::Cylinder | Element::Cone, Some(d)) => {
            let along = dot(moved, d);
            [0, 1, 2].map(|i| moved[i] - along * d[i])
        }
        (Element::Plane, Some(d)) => d.map(|v| v * dot(moved, d)),
        _ => moved,
    };
    let of_point = over(norm(moved), u.point_largest_mm);
    let direction = all.geometry.direction.zip(robust.geometry.direction).map(|(a, b)| norm(cross(a, b)).asin());
    let of_direction = over(direction.unwrap_or_default(), u.direction_rad.unwrap_or_default());
    let radius = all
        .geometry
        .radius_mm
        .zip(robust.geometry.radius_mm)
        .map(|(a, b)| a - b)
        .filter(|_| all.element != Element::Cone);
    let of_radius = over(radius.unwrap_or_default(), u.radius_mm.unwrap_or_default());
    Some(of_point.max(of_direction).max(of_radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_base::pose::Pose;

    const U_MM: f64 = 0.01;

    /// Points of an element (synthetic) with noise, turned and shifted.
    fn drawn(kind: Element, n: usize, noise: &mut Noise) -> Vec<Vector> {
        let turn = [0; 3].map(|_| noise.uniform(1.5));
        let flat = matches!(kind, Element::Line2d | Element::Circle2d);
        let placed = match flat {
            true => Pose::identity(),
            false => Pose { translation_mm: [300.0, -200.0, 500.0], ..Pose::from_rotation_vector(turn) },
        };
        let mut point = |_: usize| {
            let (a, b) = (noise.uniform(3.1), noise.uniform(50.0));
            let (s, c) = a.sin_cos();
            let t = noise.uniform(1.2);
            let exact = match kind {
                Element::Line2d | Element::Line => [b, 0.0, 0.0],
                Element::Plane => [b, noise.uniform(40.0), 0.0],
                Element::Circle2d | Element::Circle3d => [40.0 * c, 40.0 * s, 0.0],
                Element::Sphere => [25.0 * c * t.cos(), 25.0 * s * t.cos(), 25.0 * t.sin()],
                Element::Cylinder => [20.0 * c, 20.0 * s, b],
                Element::Cone => [(40.0 + 0.3 * b) * c, (40.0 + 0.3 * b) * s, b],
                Element::Torus => {
                    let (u, v) = (2.5 * t).sin_cos();
                    [(50.0 + 10.0 * v) * c, (50.0 + 10.0 * v) * s, 10.0 * u]
                }
            };
            let mut p = placed.apply(exact).map(|v| v + noise.gaussian(U_MM));
            if flat {
                p[2] = 0.0;
            }
            p
        };
        (0..n).map(&mut point).collect()
    }

    #[test]
    fn outlying_points_are_set_aside_whatever_the_element() {
        for kind in Element::ALL {
            for trial in 0..2 {
                let mut noise = Noise::new(77, trial);
                let mut points = drawn(kind, 60, &mut noise);
                let clean = element(kind, &points[5..], &FitSettings::default()).unwrap();
                for (i, p) in points.iter_mut().take(5).enumerate() {
                    // off the element by 0.5 mm or more
                    let far = |p: Vector| clean.offsets(p).length() > 0.5;
                    let start = *p;
                    while !far(*p) {
                        *p = [0, 1, 2].map(|k| start[k] + noise.uniform(1.0 + 3.0 * i as f64));
                        if matches!(kind, Element::Line2d | Element::Circle2d) {
                            p[2] = 0.0;
                        }
                    }
                }
                let found = robust_element(kind, &points, &FitSettings::default()).unwrap();
                assert_eq!(found.set_aside, [0, 1, 2, 3, 4], "{kind} {trial}");
                assert!(norm(minus(found.fit.geometry.point_mm, clean.geometry.point_mm)) < 1e-9, "{kind}");
                let all = element(kind, &points, &FitSettings::default()).unwrap();
                let outlier = outlying_points(&all, &Source::from(&points), &FitSettings::default());
                assert_eq!(outlier.unwrap().points, [0, 1, 2, 3, 4], "{kind} {trial}");
            }
        }
    }

    #[test]
    fn clean_points_are_all_used() {
        let (mut lost, mut warned, mut draws) = (0, 0, 0);
        for kind in Element::ALL {
            for trial in 0..6 {
                let mut noise = Noise::new(78, trial);
                let n = FEWEST * kind.minimum_points() + (trial as usize % 40);
                let points = drawn(kind, n, &mut noise);
                let Ok(all) = element(kind, &points, &FitSettings::default()) else { continue };
                draws += 1;
                lost += robust_element(kind, &points, &FitSettings::default()).unwrap().set_aside.len();
                warned += usize::from(outlying_points(&all, &Source::from(&points), &FitSettings::default()).is_some());
            }
        }
        eprintln!("{draws} clean draws: {lost} points set aside, {warned} warnings");
        assert!(draws > 50 && warned == 0 && lost < 4);
    }

    #[test]
    fn points_that_were_copied_are_named() {
        let mut noise = Noise::new(21, 0);
        let points = drawn(Element::Sphere, 12, &mut noise);
        let named = |points: &[Vector], robust: bool| {
            let settings = FitSettings::default();
            let messages = match robust {
                true => robust_element(Element::Sphere, points, &settings).unwrap().fit.warnings,
                false => {
                    let fit = element(Element::Sphere, points, &settings).unwrap();
                    warnings(&fit, &points.into(), &settings)
                }
            };
            let found = messages.into_iter().find(|message| message.is("points-repeated", &[]));
            found.map(|message| {
                message.is(
                    "points-repeated",
                    &[("count", &12), ("points", &"13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24")],
                )
            })
        };
        let twice = [points.clone(), points.clone()].concat();
        for robust in [false, true] {
            assert_eq!((named(&points, robust), named(&twice, robust)), (None, Some(true)));
        }
    }
}
