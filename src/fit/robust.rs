//! Elements of points among which some are foreign: trimmed least squares.
//!
//! The start is the element through few points that leaves the smallest median distance (least
//! median of squares: Rousseeuw 1984). From the nearest three quarters of the points the fit grows
//! to all that noise explains. The result is the least-squares element of these, with its usual
//! covariance: so few sound points are lost that they do not change it.

use super::{CircleMethod, Element, Fit, FitSettings, Source, element};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, cross, dot, minus, norm};

/// Starts that are tried.
const STARTS: u64 = 60;
/// Largest number of points by which starts are compared.
const COMPARED: usize = 500;
/// Points of a start beyond the minimum.
const MORE: usize = 1;
/// Steps of the growth.
const STEPS: usize = 40;
/// Expected number of sound points that are set aside in a fit.
const LOST: f64 = 1e-3;
/// Share of the points with which the growth begins.
const BEGIN: f64 = 0.75;
/// Ratio of the standard deviation of three quarters of normal deviates, the smallest ones, to that
/// of all.
const OF_BEGIN: f64 = 0.6;
/// Fewest points by minimum number of points of the element among which foreign ones can be told.
const FEWEST: usize = 3;
/// Residuals below this share of the size of the element are rounding.
const ROUNDING: f64 = 1e-13;
/// Largest number of points of a fit that is checked for foreign points unasked.
const CHECKED: usize = 20_000;
/// Largest share of foreign points that is reported unasked.
const FEW: f64 = 0.15;
/// Change of the element, in its standard uncertainties, beyond which foreign points are reported.
const SHIFTED: f64 = 3.0;

/// Fit without foreign points.
#[derive(Clone, Debug)]
pub struct RobustElement {
    /// Fit of the points that are used.
    pub fit: Fit,
    /// Indices of the points that are set aside.
    pub set_aside: Vec<usize>,
}

/// Effect of foreign points on a fit of all points.
#[derive(Clone, Debug, PartialEq)]
pub struct ForeignPoints {
    /// Indices of the foreign points.
    pub points: Vec<usize>,
    /// Largest change of point, direction or radius that they cause, in standard uncertainties of
    /// the fit without them.
    pub shift: f64,
}

/// Distances of a point that the fit minimises: one, or two for a line or circle in space.
fn distance(fit: &Fit, point: Vector) -> f64 {
    let along = |d: Vector| dot(minus(point, fit.point_mm), d);
    match (fit.element, fit.direction) {
        (Element::Circle3d, Some(d)) => fit.residual_mm(point).hypot(along(d)),
        (Element::Line, Some(d)) => norm(cross(d, minus(point, fit.point_mm))),
        _ => fit.residual_mm(point).abs(),
    }
}

/// Number of distances of a point.
fn equations(element: Element) -> usize {
    if matches!(element, Element::Circle3d | Element::Line) { 2 } else { 1 }
}

/// Parameters of an element, without those that are held.
fn parameters(element: Element, settings: &FitSettings) -> usize {
    let all = match element {
        Element::Line2d => 2,
        Element::Plane | Element::Circle2d => 3,
        Element::Line | Element::Sphere => 4,
        Element::Cylinder => 5,
        Element::Circle3d | Element::Cone => 6,
        Element::Torus => 7,
    };
    let held = usize::from(settings.radius_mm.is_some()) + 2 * usize::from(settings.axis.is_some());
    all - held.min(all - 1)
}

/// Points with their settings for the search, which knows no probe.
struct Search<'a> {
    element: Element,
    points: &'a [Vector],
    settings: FitSettings<'a>,
}

impl Search<'_> {
    /// Fit of some points.
    fn of(&self, chosen: &[usize]) -> Option<Fit> {
        let points: Vec<Vector> = chosen.iter().map(|i| self.points[*i]).collect();
        let weights: Option<Vec<f64>> = self.settings.weights.map(|w| chosen.iter().map(|i| w[*i]).collect());
        let settings = FitSettings { weights: weights.as_deref(), ..self.settings };
        element(self.element, &points, &settings).ok()
    }

    /// Distances of all points over the standard deviation that their weights state.
    fn distances(&self, fit: &Fit) -> Vec<f64> {
        let weight = |i: usize| self.settings.weights.map_or(1.0, |w| w[i].sqrt());
        self.points.iter().enumerate().map(|(i, p)| distance(fit, *p) * weight(i)).collect()
    }

    /// The best start by the median distance of a sample.
    fn start(&self) -> Option<Fit> {
        let count = (self.element.minimum_points() + MORE).min(self.points.len());
        let step = self.points.len().div_ceil(COMPARED).max(1);
        let mut best: Option<(f64, Fit)> = None;
        for trial in 0..STARTS {
            let mut noise = Noise::new(self.points.len() as u64, trial);
            // draws of indices that differ
            let mut chosen: Vec<usize> = Vec::new();
            while chosen.len() < count {
                let at = (0.5 * (1.0 + noise.uniform(1.0)) * self.points.len() as f64) as usize;
                let at = at.min(self.points.len() - 1);
                if !chosen.contains(&at) {
                    chosen.push(at);
                }
            }
            let Some(fit) = self.of(&chosen) else { continue };
            let sample = self.points.iter().step_by(step).map(|p| distance(&fit, *p));
            let median = etalon_math::statistics::median(sample).unwrap_or(f64::INFINITY);
            if best.as_ref().is_none_or(|(least, _)| median < *least) {
                best = Some((median, fit));
            }
        }
        Some(best?.1)
    }

    /// Points that noise explains, from the start on.
    fn explained(&self) -> Option<Vec<usize>> {
        let n = self.points.len();
        let mut fit = self.start()?;
        let begin = ((BEGIN * n as f64) as usize).max(self.element.minimum_points() + MORE).min(n);
        let mut order: Vec<usize> = (0..n).collect();
        let distances = self.distances(&fit);
        order.sort_by(|a, b| distances[*a].total_cmp(&distances[*b]));
        let mut used = order[..begin].to_vec();
        used.sort_unstable();
        let mut reduced = OF_BEGIN;
        for _ in 0..STEPS {
            fit = self.of(&used)?;
            let distances = self.distances(&fit);
            let dof = (equations(self.element) * used.len()).saturating_sub(parameters(self.element, &self.settings));
            let squares: f64 = used.iter().map(|i| distances[*i].powi(2)).sum();
            let deviation = (squares / dof.max(1) as f64).sqrt() / reduced;
            let largest = largest(n, dof) * deviation;
            let size = norm(fit.point_mm) + fit.radius_mm.unwrap_or_default();
            let near: Vec<usize> = (0..n).filter(|i| distances[*i] <= largest.max(ROUNDING * size)).collect();
            if near == used {
                return Some(used);
            }
            (used, reduced) = (near, 1.0);
        }
        Some(used)
    }
}

/// Largest residual in standard deviations that noise leaves among `n` points, once in 1 / [`LOST`]
/// fits at most: the tail of a normal distribution is below exp(−k²/2), that of t with `dof`
/// degrees of freedom below (1 + k²/dof)^(−(dof + 1)/2).
fn largest(n: usize, dof: usize) -> f64 {
    let square = 2.0 * (n as f64 / LOST).ln();
    let dof = dof.max(1) as f64;
    (dof * ((square / (dof + 1.0)).exp() - 1.0)).sqrt()
}

/// Fits an element without the points that are far from all others.
///
/// # Errors
/// As of [`element`]; fewer points than three times the minimum, among which none is foreign.
pub fn robust_element(kind: Element, points: &[Vector], settings: &FitSettings) -> Result<RobustElement> {
    let needed = FEWEST * kind.minimum_points();
    if points.len() < needed {
        return Err(error!("robust-few-points", element = kind, needed, points = points.len()).into());
    }
    // errors of the points themselves are those of the plain fit
    let all = element(kind, points, settings)?;
    let search = Search { element: kind, points, settings: searching(settings) };
    let Some(used) = search.explained().filter(|used| used.len() < points.len()) else {
        return Ok(RobustElement { fit: all, set_aside: Vec::new() });
    };
    let kept: Vec<Vector> = used.iter().map(|i| points[*i]).collect();
    let weights: Option<Vec<f64>> = settings.weights.map(|w| used.iter().map(|i| w[*i]).collect());
    let fit = element(kind, &kept, &FitSettings { weights: weights.as_deref(), ..*settings })?;
    let set_aside = (0..points.len()).filter(|i| used.binary_search(i).is_err()).collect();
    Ok(RobustElement { fit, set_aside })
}

/// Settings of the search: the centres of a probe are fitted as measured, circles in space by
/// orthogonal distances.
fn searching<'a>(settings: &FitSettings<'a>) -> FitSettings<'a> {
    FitSettings { radius_mm: settings.held_radius_mm(), probe: None, circle: CircleMethod::Projected, ..*settings }
}

/// Foreign points that shift a fit of all points beyond its uncertainty; `None` where there are
/// none, or too many points to look at unasked.
pub fn foreign_points(fit: &Fit, points: &Source, settings: &FitSettings) -> Option<ForeignPoints> {
    let n = points.len();
    if n > CHECKED || n < FEWEST * fit.element.minimum_points() {
        return None;
    }
    let all: Vec<Vector> = (0..n).map(|i| points.at(i)).collect();
    if fit.compensation.is_none() && plausible(fit, &all) {
        return None;
    }
    let robust = robust_element(fit.element, &all, settings).ok()?;
    let few = !robust.set_aside.is_empty() && robust.set_aside.len() as f64 <= FEW * n as f64;
    let shift = if few { shift(fit, &robust.fit)? } else { 0.0 };
    (shift > SHIFTED).then_some(ForeignPoints { points: robust.set_aside, shift })
}

/// `true` if the distances of all points are those of noise by the spread of the nearest three
/// quarters.
fn plausible(fit: &Fit, points: &[Vector]) -> bool {
    let mut distances: Vec<f64> = points.iter().map(|p| distance(fit, *p)).collect();
    distances.sort_by(f64::total_cmp);
    let begin = ((BEGIN * points.len() as f64) as usize).max(1);
    let squares: f64 = distances.iter().take(begin).map(|d| d * d).sum();
    let deviation = (squares / (begin * equations(fit.element)) as f64).sqrt() / OF_BEGIN;
    let size = norm(fit.point_mm) + fit.radius_mm.unwrap_or_default();
    let most = distances.last().copied().unwrap_or_default();
    most <= (CLEAN * deviation).max(ROUNDING * size)
}

/// Largest residual, in standard deviations, of points that are not looked at further.
const CLEAN: f64 = 3.5;

/// Largest difference of two fits in standard uncertainties of the second.
fn shift(all: &Fit, robust: &Fit) -> Option<f64> {
    let u = robust.standard_uncertainty()?;
    let over = |difference: f64, u: f64| if u > 0.0 { difference.abs() / u } else { 0.0 };
    let moved = minus(all.point_mm, robust.point_mm);
    // points slide along a line, axis or plane with the centroid of the points
    let moved = match (all.element, robust.direction) {
        (Element::Line | Element::Line2d | Element::Cylinder | Element::Cone, Some(d)) => {
            let along = dot(moved, d);
            [0, 1, 2].map(|i| moved[i] - along * d[i])
        }
        (Element::Plane, Some(d)) => d.map(|v| v * dot(moved, d)),
        _ => moved,
    };
    let of_point = over(norm(moved), u.point_largest_mm);
    let direction = all.direction.zip(robust.direction).map(|(a, b)| norm(cross(a, b)).asin());
    let of_direction = over(direction.unwrap_or_default(), u.direction_rad.unwrap_or_default());
    let radius = all.radius_mm.zip(robust.radius_mm).map(|(a, b)| a - b).filter(|_| all.element != Element::Cone);
    let of_radius = over(radius.unwrap_or_default(), u.radius_mm.unwrap_or_default());
    Some(of_point.max(of_direction).max(of_radius))
}

#[cfg(test)]
mod tests {
    use super::*;
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
    fn foreign_points_are_set_aside_whatever_the_element() {
        for kind in Element::ALL {
            for trial in 0..2 {
                let mut noise = Noise::new(77, trial);
                let mut points = drawn(kind, 60, &mut noise);
                let clean = element(kind, &points[5..], &FitSettings::default()).unwrap();
                for (i, p) in points.iter_mut().take(5).enumerate() {
                    // off the element by 0.5 mm or more
                    let far = |p: Vector| distance(&clean, p) > 0.5;
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
                assert!(norm(minus(found.fit.point_mm, clean.point_mm)) < 1e-9, "{kind}");
                let all = element(kind, &points, &FitSettings::default()).unwrap();
                let foreign = foreign_points(&all, &Source::from(&points), &FitSettings::default());
                assert_eq!(foreign.unwrap().points, [0, 1, 2, 3, 4], "{kind} {trial}");
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
                warned += usize::from(foreign_points(&all, &Source::from(&points), &FitSettings::default()).is_some());
            }
        }
        eprintln!("{draws} clean draws: {lost} points set aside, {warned} warnings");
        assert!(draws > 50 && warned == 0 && lost < 4);
    }
}
