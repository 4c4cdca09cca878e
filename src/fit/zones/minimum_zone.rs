//! Minimum zones of line, plane and circle: the smallest distance between two parallel elements
//! that enclose all points (form to ISO 1101). For sphere, cylinder and cone see
//! [`crate::round_zone`].
//!
//! In contrast to least squares, at most four points determine the zone, and a single wrong point
//! moves it. Each result names its contact points, and shows whether it was proved to be the
//! narrowest.

use crate::chart::Chart;
use crate::chebyshev::{extremes, fence, growth, least_spread, narrowest_strip};
use crate::cloud::{Cloud, Source};
use crate::element::{Element, FitSettings};
use crate::geometry::ElementGeometry;
use crate::line_and_plane::from_first_to_last;
use crate::result::largest_component_positive;
use crate::round_zone::{cone_zone, cylinder_zone, sphere, too_flat};
use crate::zone::{FARTHEST, MinimumZone, SLACK, sides};
use etalon_base::error;
use etalon_base::message::{Message, Result, Severity};
use etalon_base::pose::{Vector, dot, minus, norm, unit};
use std::collections::VecDeque;
use std::rc::Rc;

/// Finds the minimum zone of an element; for a line or circle in the plane, z of the points is
/// ignored.
///
/// It has the warnings of the least-squares fit of the same points.
///
/// Fails for a line in space and a torus, and if the points do not determine the element uniquely.
pub fn minimum_zone(element: Element, points: &[Vector]) -> Result<MinimumZone> {
    let zone = narrowest(element, points)?;
    let settings = FitSettings::default();
    let warnings = match crate::element(element, points, &settings) {
        Ok(fit) => crate::warnings(&fit, &Source::from(points), &settings),
        // extreme points determine a zone where all points together determine no element
        Err(problems) => problems.0.into_iter().map(|m| Message { severity: Severity::Warning, ..m }).collect(),
    };
    Ok(MinimumZone { warnings, ..zone })
}

fn narrowest(element: Element, points: &[Vector]) -> Result<MinimumZone> {
    let flat = || points.iter().map(|p| [p[0], p[1]]).collect::<Vec<_>>();
    match element {
        Element::Line2d => line2d(&flat()),
        Element::Plane => plane(points),
        Element::Circle2d => circle2d(&flat()),
        Element::Circle3d => circle3d(points),
        Element::Sphere => narrower_than_a_plane(sphere(points)?, points),
        Element::Cylinder => narrower_than_a_plane(cylinder_zone(points)?, points),
        Element::Cone => narrower_than_a_plane(cone_zone(points)?, points),
        Element::Line | Element::Torus => Err(error!("zone-unsupported", element).into()),
    }
}

/// Rejects a zone as wide as the minimum zone of a plane, because the points do not determine the
/// element.
fn narrower_than_a_plane(zone: MinimumZone, points: &[Vector]) -> Result<MinimumZone> {
    let cloud = Cloud::new(zone.element, Source::Space(points.into()), &FitSettings::default())?;
    let normalised: Vec<Vector> = cloud.points().collect();
    let flat = narrow_slab(&normalised, cloud.axes[2]).width;
    if zone.form_mm >= (flat - SLACK) * cloud.scale_mm && flat > SLACK { Err(too_flat(zone.element)) } else { Ok(zone) }
}

/// Minimum zone of a circle in space from at least three non-collinear points: the minimum zone of
/// the plane, and the minimum zone of a circle for the points projected onto that plane.
///
/// Roundness is a form in a plane section (ISO 1101:2017, 17.4; ISO 12181-1). The width is
/// therefore measured in the plane, and the plane has a width of its own: its flatness.
fn circle3d(points: &[Vector]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Circle3d, Source::Space(points.into()), &FitSettings::default())?;
    let flat = plane(points)?;
    let normal = flat.geometry.direction.unwrap_or(cloud.axes[2]);
    let chart = Chart::new(normal);
    let projected: Vec<[f64; 2]> = points
        .iter()
        .map(|&p| {
            let [x, y, _] = chart.coordinates(minus(p, flat.geometry.point_mm));
            [x, y]
        })
        .collect();
    let round = circle2d(&projected)?;
    let [a, b, _] = round.geometry.point_mm;
    let from_plane = chart.point(a, b, 0.0);
    Ok(MinimumZone {
        element: Element::Circle3d,
        geometry: ElementGeometry {
            point_mm: [0, 1, 2].map(|k| flat.geometry.point_mm[k] + from_plane[k]),
            direction: Some(normal),
            ..round.geometry
        },
        verified: round.verified && flat.verified,
        iterations: round.iterations + flat.iterations,
        plane: Some(Box::new(flat)),
        ..round
    })
}

/// Maximum number of parts of the search region, and of evaluated points, before a proof is
/// abandoned.
const PARTS: usize = 20_000;
const LOOKS: usize = 10_000_000;

/// Minimum zone of a line in the plane from at least two distinct points, directed from the first
/// point to the last.
///
/// Two points are in contact on one side, and a third point between them on the other. Every edge
/// of the convex hull is tried.
fn line2d(points: &[[f64; 2]]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Line2d, Source::Plane(points), &FitSettings::default())?;
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
        geometry: ElementGeometry {
            point_mm: cloud.to_mm(left.map(|x| x * middle)),
            direction: Some(direction),
            ..zone.geometry
        },
        verified: found <= width + SLACK && (found <= SLACK || holds()),
        ..zone
    })
}

/// `true` if the contact points of one side enclose a contact point of the other side along the
/// line, so that no rotation narrows the zone.
fn alternate(cloud: &Cloud, direction: Vector, lower: &[usize], upper: &[usize]) -> bool {
    let range = |side: &[usize]| {
        let along = side.iter().map(|&i| dot(cloud.point(i), direction));
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), t| (l.min(t), h.max(t)))
    };
    let (lower, upper) = (range(lower), range(upper));
    lower.0.max(upper.0) <= lower.1.min(upper.1) + SLACK
}

/// Minimum zone of a plane from at least three non-collinear points.
///
/// Either three points are in contact on one side with one point between them on the other, or two
/// points on each side whose connections cross (Houle & Toussaint 1988).
///
/// Relative to a direction d, every direction is d + a e1 + b e2. The spread of the heights over
/// the plane perpendicular to it is g(a, b) / √(1 + a² + b²), where g belongs to a linear Chebyshev
/// problem. The minimum of g gives a narrower zone, until it remains at the same direction. There g
/// ≥ w + κ r at a distance r, so that no direction within 2 κ w / (w² − κ²) is narrower, and no
/// direction at all if κ ≥ w, which is the case for flat points. Otherwise the remaining directions
/// are excluded part by part: in a triangle of directions within ρ of its centre, the width is at
/// least that of the linear problem times cos ρ.
fn plane(points: &[Vector]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Plane, Source::Space(points.into()), &FitSettings::default())?;
    let normalised: Vec<Vector> = cloud.points().collect();
    let start = narrow_slab(&normalised, cloud.axes[2]);
    let (best, verified, iterations) = narrowest_slab(&normalised, start);
    let normal = largest_component_positive(best.normal);
    let heights: Vec<f64> = normalised.iter().map(|&q| dot(q, normal)).collect();
    let (zone, middle) = MinimumZone::between(Element::Plane, &heights, cloud.scale_mm);
    Ok(MinimumZone {
        geometry: ElementGeometry {
            point_mm: cloud.to_mm(normal.map(|x| x * middle)),
            direction: Some(normal),
            ..zone.geometry
        },
        verified,
        iterations,
        ..zone
    })
}

/// Direction of a locally narrowest zone of a plane.
#[derive(Clone, Copy)]
struct Slab {
    normal: Vector,
    width: f64,
    /// Smallest growth of the spread per tangent of the angle.
    growth: f64,
}

impl Slab {
    /// Cosine of the angle within which no direction is narrower.
    fn cosine_of_hold(&self) -> f64 {
        let (w, k) = (self.width, self.growth);
        if k >= w {
            return 0.0;
        }
        if k <= 0.0 {
            return 1.0;
        }
        let tangent = 2.0 * k * w / ((w - k) * (w + k));
        1.0 / tangent.hypot(1.0)
    }

    fn holds(&self, direction: Vector) -> bool {
        dot(self.normal, direction).abs() >= self.cosine_of_hold()
    }
}

fn seen_from(points: &[Vector], chart: &Chart) -> Vec<[f64; 3]> {
    points.iter().map(|&q| chart.coordinates(q)).collect()
}

/// Solves successive linear problems until the direction is stationary.
fn narrow_slab(points: &[Vector], from: Vector) -> Slab {
    let mut chart = Chart::new(from);
    for _ in 0..100 {
        let Some(level) = least_spread(&seen_from(points, &chart), f64::INFINITY) else { break };
        let [a, b] = level.slope;
        chart = Chart::new(chart.point(a, b, 1.0));
        if a.hypot(b) < 1e-15 {
            break;
        }
    }
    let rows = seen_from(points, &chart);
    let heights: Vec<f64> = rows.iter().map(|row| row[2]).collect();
    let (low, high, lower, upper) = sides(&heights);
    let flat = |side: &[usize]| side.iter().map(|&i| [rows[i][0], rows[i][1]]).collect::<Vec<_>>();
    Slab { normal: chart.d0, width: high - low, growth: growth(&flat(&upper), &flat(&lower)) }
}

/// Narrowest zone, whether it was proved, and number of directions examined.
fn narrowest_slab(points: &[Vector], start: Slab) -> (Slab, bool, usize) {
    let mut best = start;
    if best.width <= SLACK || best.growth >= best.width {
        return (best, true, 1);
    }
    let mut places = vec![best];
    let pole = [0.0, 0.0, 1.0];
    let around = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    let all = Rc::new(points.to_vec());
    // opposite directions give the same plane: half of the octahedron suffices
    let octants = (0..4).map(|k| ([pole, around[k], around[(k + 1) % 4]], Rc::clone(&all)));
    let mut queue: VecDeque<([Vector; 3], Rc<Vec<Vector>>)> = octants.collect();
    let (mut looked_at, mut looks) = (1, 0);
    while let Some((corners, points_here)) = queue.pop_front() {
        if places.iter().any(|place| corners.iter().all(|&c| place.holds(c))) {
            continue;
        }
        if looked_at == PARTS || looks > LOOKS {
            return (best, false, looked_at);
        }
        looked_at += 1;
        looks += points_here.len();
        let [p, q, r] = corners;
        let Some(middle) = unit(sum(sum(p, q), r)) else { continue };
        let cosine = corners.iter().fold(1.0f64, |m, &c| m.min(dot(c, middle)));
        let tangent = (1.0 / (cosine * cosine) - 1.0).max(0.0).sqrt();
        let chart = Chart::new(middle);
        let mut rows = seen_from(&points_here, &chart);
        let within = Rc::new(extreme_within(&points_here, &rows, tangent));
        rows.extend(fence(&rows, tangent));
        let enough = (best.width - SLACK) / cosine;
        if let Some(level) = least_spread(&rows, enough) {
            if level.spread >= enough {
                continue;
            }
            let [a, b] = level.slope;
            let width_there = level.spread / a.hypot(b).hypot(1.0);
            if a.hypot(b) <= 2.0 * tangent && width_there <= best.width + SLACK {
                let found = narrow_slab(points, chart.point(a, b, 1.0));
                if found.width < best.width {
                    best = found;
                }
                if !places.iter().any(|place| dot(place.normal, found.normal).abs() > 1.0 - 1e-12) {
                    places.push(found);
                }
            }
        }
        let half = |a: Vector, b: Vector| unit(sum(a, b)).unwrap_or(a);
        let (pq, qr, rp) = (half(p, q), half(q, r), half(r, p));
        queue.extend([[p, pq, rp], [pq, q, qr], [rp, qr, r], [pq, qr, rp]].map(|part| (part, Rc::clone(&within))));
    }
    (best, true, looked_at)
}

/// Points that can be extreme in a direction whose angle to the direction of `rows` has at most
/// this tangent: their depth below the highest point is at most their distance from it times the
/// tangent.
fn extreme_within(points: &[Vector], rows: &[[f64; 3]], tangent: f64) -> Vec<Vector> {
    let (low, high) = extremes(rows, [0.0; 2]);
    let may_reach = |i: usize, end: usize| {
        (rows[i][2] - rows[end][2]).abs() <= tangent * norm(minus(points[i], points[end])) + SLACK
    };
    (0..points.len()).filter(|&i| may_reach(i, low) || may_reach(i, high)).map(|i| points[i]).collect()
}

fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Minimum zone of a circle in the plane from at least three non-collinear points.
///
/// Two points are in contact with the outer circle and two with the inner, alternating around it
/// (Rivlin 1979). Fails if a line is as narrow, because the centre is then at infinity.
///
/// R² − r² = max(|p|² − 2 c·p) − min(|p|² − 2 c·p) is a linear Chebyshev problem in the centre c.
/// From its minimum it grows by at least κ per unit length, and R + r by at most 2. If κ ≥ 2 (R −
/// r), the ring of smallest area is therefore the narrowest, which applies to all round parts.
/// Otherwise the plane is searched square by square. A distant ring approaches a strip, so that the
/// narrowest strip bounds the search.
fn circle2d(points: &[[f64; 2]]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Circle2d, Source::Plane(points), &FitSettings::default())?;
    let flat: Vec<[f64; 2]> = cloud.points().map(|q| [q[0], q[1]]).collect();
    let Some((best, verified, iterations)) = narrowest_ring(&flat) else {
        return Err(error!("zone-straight").into());
    };
    let distances = distances(&flat, best.center);
    let (zone, middle) = MinimumZone::between(Element::Circle2d, &distances, cloud.scale_mm);
    Ok(MinimumZone {
        geometry: ElementGeometry {
            point_mm: cloud.to_mm([best.center[0], best.center[1], 0.0]).map(|x| x + 0.0),
            radius_mm: Some(middle * cloud.scale_mm),
            ..zone.geometry
        },
        verified,
        iterations,
        ..zone
    })
}

/// Centre of a locally narrowest ring.
#[derive(Clone, Copy)]
struct Ring {
    center: [f64; 2],
    width: f64,
    /// Distance within which no centre is narrower.
    hold: f64,
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn distances(points: &[[f64; 2]], center: [f64; 2]) -> Vec<f64> {
    points.iter().map(|&p| distance(p, center)).collect()
}

/// Rows of the linear problem about `center`: the distance of a point is at least d − u·δ, with
/// equality to first order.
fn rows_about(points: &[[f64; 2]], center: [f64; 2]) -> Vec<[f64; 3]> {
    let row = |p: &[f64; 2]| {
        let d = distance(*p, center);
        let back = |k: usize| if d > 0.0 { (center[k] - p[k]) / d } else { 0.0 };
        [back(0), back(1), d]
    };
    points.iter().map(row).collect()
}

fn ring_width(rows: &[[f64; 3]]) -> (f64, f64) {
    let (low, high) = rows.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(r[2]), h.max(r[2])));
    (high - low, low)
}

/// Solves successive linear problems, with steps halved until the ring is narrower, until the
/// centre is stationary.
fn narrow_ring(points: &[[f64; 2]], from: [f64; 2]) -> Ring {
    let mut center = from;
    let mut rows = rows_about(points, center);
    for _ in 0..100 {
        let (width, _) = ring_width(&rows);
        let Some(level) = least_spread(&rows, f64::INFINITY) else { break };
        let halved = (0..40).map(|k| level.slope.map(|s| s * 0.5f64.powi(k)));
        let mut tried = halved.map(|step| {
            let center = [center[0] + step[0], center[1] + step[1]];
            (center, rows_about(points, center))
        });
        let Some(next) = tried.find(|(c, rows)| c[0].hypot(c[1]) < FARTHEST && ring_width(rows).0 < width) else {
            break;
        };
        (center, rows) = next;
    }
    let (low, high, lower, upper) = sides(&rows.iter().map(|row| row[2]).collect::<Vec<_>>());
    let flat = |side: &[usize]| side.iter().map(|&i| [rows[i][0], rows[i][1]]).collect::<Vec<_>>();
    // at a displacement e the second-order term of a distance is at most e²/2 (r − e)
    let k = growth(&flat(&upper), &flat(&lower)).max(0.0);
    Ring { center, width: high - low, hold: 2.0 * k * low / (1.0 + 2.0 * k) }
}

/// Narrowest ring, whether it was proved, and number of centres examined; `None` if a strip is as
/// narrow, or if the arc is too flat.
fn narrowest_ring(points: &[[f64; 2]]) -> Option<(Ring, bool, usize)> {
    let squared: Vec<[f64; 3]> = points.iter().map(|p| [-2.0 * p[0], -2.0 * p[1], p[0] * p[0] + p[1] * p[1]]).collect();
    let level = least_spread(&squared, f64::INFINITY)?;
    if level.slope[0].hypot(level.slope[1]) >= FARTHEST {
        return None;
    }
    let best = narrow_ring(points, level.slope);
    let (_, _, lower, upper) = sides(&distances(points, best.center));
    let flat = |side: &[usize]| side.iter().map(|&i| [squared[i][0], squared[i][1]]).collect::<Vec<_>>();
    if best.width <= SLACK || growth(&flat(&upper), &flat(&lower)) >= 2.0 * best.width {
        return Some((best, true, 1));
    }
    search_rings(points, best)
}

fn search_rings(points: &[[f64; 2]], mut best: Ring) -> Option<(Ring, bool, usize)> {
    let strip = narrowest_strip(points)?.width;
    let size = distances(points, [0.0; 2]).into_iter().fold(0.0, f64::max);
    // at a distance t from the origin a ring is at most this much narrower than the strip across
    let bend = |t: f64| if t > size { size * size / (2.0 * (t - size)) } else { f64::INFINITY };
    let margin = (strip - best.width).max(1e-3 * size);
    let mut places = vec![best];
    let all = Rc::new(points.to_vec());
    let mut queue = VecDeque::from([([0.0; 2], size + size * size / (2.0 * margin), all)]);
    let (mut looked_at, mut looks) = (1, 0);
    let mut verified = true;
    while let Some((middle, half, points_here)) = queue.pop_front() {
        let radius = half * 2f64.sqrt();
        let inside = |place: &Ring| distance(place.center, middle) + radius <= place.hold;
        let goal = best.width.min(strip) - SLACK;
        let nearest = distance(middle, [0.0; 2]) - radius;
        if places.iter().any(inside) || strip - bend(nearest) >= goal {
            continue;
        }
        if looked_at == PARTS || looks > LOOKS {
            verified = false;
            break;
        }
        looked_at += 1;
        looks += points_here.len();
        let mut rows = rows_about(&points_here, middle);
        let (width, inner) = ring_width(&rows);
        // unit vectors to two points of the cloud differ by the angle it subtends, which limits the
        // change of the width per unit length
        let change = radius * if nearest > size { 2.0 * size / nearest } else { 2.0 };
        if width - change >= goal {
            continue;
        }
        // only these points can be extreme for a centre in the square
        let reach = |row: &[f64; 3]| row[2] <= inner + change + SLACK || row[2] >= inner + width - change - SLACK;
        let within: Vec<[f64; 2]> = points_here.iter().zip(&rows).filter(|(_, r)| reach(r)).map(|(p, _)| *p).collect();
        let within = Rc::new(within);
        rows.extend(fence(&rows, radius));
        let bent = if inner > radius { radius * radius / (2.0 * (inner - radius)) } else { f64::INFINITY };
        let enough = goal + bent;
        if let Some(level) = least_spread(&rows, enough) {
            if level.spread >= enough {
                continue;
            }
            let there = [middle[0] + level.slope[0], middle[1] + level.slope[1]];
            let near = distance(there, middle) <= 2.0 * radius;
            if near && ring_width(&rows_about(&points_here, there)).0 <= best.width + SLACK {
                let found = narrow_ring(points, there);
                if found.width < best.width {
                    best = found;
                }
                if !places.iter().any(|place| distance(place.center, found.center) < 1e-9) {
                    places.push(found);
                }
            }
        }
        let quarter = 0.5 * half;
        for (i, j) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            queue.push_back(([middle[0] + i * quarter, middle[1] + j * quarter], quarter, Rc::clone(&within)));
        }
    }
    (best.width < strip - SLACK).then_some((best, verified, looked_at))
}
