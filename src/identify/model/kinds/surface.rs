//! Planes, lines and spheres that are fixed in the world, and the distance of a point from them.

use super::{At, Condition, Equation, Kind, Known, SHORTEST, place};
use crate::Settings;
use etalon_base::pose::{Vector, centroid, dot, minus};
use etalon_base::scalar::{Dual, Scalar};
use etalon_math::Factor;
use etalon_math::statistics::mean;
use etalon_robots::FreeBase;

/// Element that a target touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// A plane, by two slopes of its normal (rad) towards the axis 0, 1 or 2 of the world, and its
    /// intersection with this axis (mm).
    Plane {
        /// The axis.
        axis: usize,
    },
    /// A line, by two slopes against the axis 0, 1 or 2 of the world (rad), and its intersection
    /// with the plane of the other two (mm).
    Line {
        /// The axis.
        axis: usize,
    },
    /// A sphere, by its centre and radius (mm).
    Sphere,
}

/// Steps from a point to the nearest point of a surface.
const STEPS: usize = 60;

/// Derivatives: three with respect to the point, four with respect to the unknowns.
type Number = Dual<7>;

impl Surface {
    /// Number of unknowns.
    pub fn unknowns(self) -> usize {
        if matches!(self, Self::Plane { .. }) { 3 } else { 4 }
    }

    /// Number of residuals.
    pub fn rows(self) -> usize {
        if matches!(self, Self::Line { .. }) { 2 } else { 1 }
    }

    /// Distance (mm) of `p` from the element; for a line, along two of its normals.
    fn distances<T: Scalar>(self, p: [T; 3], unknowns: [T; 4]) -> [T; 2] {
        let dot = |a: [T; 3], b: [T; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let along = |a: [T; 3], b: [T; 3]| dot(a, b) / dot(a, a).sqrt();
        let [a, b, c, d] = unknowns;
        let zero = T::from(0.0);
        match self {
            Self::Plane { axis } => {
                let (mut normal, mut lever) = ([zero; 3], p);
                normal[axis] = T::from(1.0);
                normal[(axis + 1) % 3] = -a.tan();
                normal[(axis + 2) % 3] = -b.tan();
                lever[axis] = lever[axis] - c;
                [along(normal, lever), zero]
            }
            Self::Line { axis } => {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                let (mut direction, mut lever, mut across) = ([zero; 3], p, [zero; 3]);
                (direction[axis], direction[i], direction[j]) = (T::from(1.0), a.tan(), b.tan());
                (lever[i], lever[j]) = (lever[i] - c, lever[j] - d);
                (across[axis], across[i]) = (-a.tan(), T::from(1.0));
                let k = |k: usize| {
                    let (l, m) = ((k + 1) % 3, (k + 2) % 3);
                    direction[l] * across[m] - direction[m] * across[l]
                };
                [along(across, lever), along([k(0), k(1), k(2)], lever)]
            }
            Self::Sphere => {
                let lever = [p[0] - a, p[1] - b, p[2] - c];
                [dot(lever, lever).sqrt() - d, zero]
            }
        }
    }

    /// Distance (mm) of a point from the element.
    pub fn residuals(self, p: Vector, unknowns: [f64; 4]) -> [f64; 2] {
        self.distances(p, unknowns)
    }

    /// Derivatives of this distance, a row each: with respect to the point, and to the unknowns.
    pub fn gradients(self, p: Vector, unknowns: [f64; 4]) -> [[f64; 7]; 2] {
        let variable = |i: usize| Number::variable(if i < 3 { p[i] } else { unknowns[i - 3] }, i);
        self.distances([0, 1, 2].map(variable), [3, 4, 5, 6].map(variable)).map(|d| d.gradient)
    }
}

/// The target is on a surface or line, or, for a plane or sphere, its centre is `offset_mm` outside
/// (the radius of a ball). Residuals: mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct On {
    /// Touched element.
    pub surface: Surface,
    /// Parameters of the element.
    pub unknowns: [usize; 4],
    /// Distance of the target from the element, positive along the axis of a plane, and outwards
    /// for a sphere.
    pub offset_mm: f64,
}

impl On {
    fn gradients(&self, at: &At) -> [[f64; 7]; 2] {
        self.surface.gradients(at.position, self.unknowns.map(|i| at.values[i]))
    }

    /// The point of the element nearest to `p`, or at the distance `left` from it.
    pub fn nearest(&self, values: &[f64], mut p: Vector, left: Vector) -> Vector {
        for _ in 0..STEPS {
            for (normal, distance) in self.gaps(values, p, left) {
                let square = normal.iter().map(|v| v * v).sum::<f64>();
                (0..3).for_each(|i| p[i] -= distance * normal[i] / square);
            }
        }
        p
    }
}

impl Equation for On {
    fn rows(&self) -> usize {
        self.surface.rows()
    }

    fn unknowns(&self) -> Vec<usize> {
        self.unknowns[..self.surface.unknowns()].to_vec()
    }

    fn residuals(&self, at: &At, out: &mut [f64]) {
        let distances = self.surface.residuals(at.position, self.unknowns.map(|i| at.values[i]));
        out.iter_mut().zip(distances).for_each(|(out, distance)| *out = distance - self.offset_mm);
    }

    fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]) {
        let n = at.values.len();
        for (row, by) in out.chunks_exact_mut(n).zip(self.gradients(at)) {
            (0..n).for_each(|j| row[j] = (0..3).map(|i| by[i] * moved[i * n + j]).sum());
            self.unknowns.iter().zip(&by[3..]).take(self.surface.unknowns()).for_each(|(&j, by)| row[j] += by);
        }
    }

    fn in_world(&self, at: &At, residuals: Vector) -> Vector {
        let [first, second] = self.gradients(at);
        std::array::from_fn(|i| first[i] * residuals[0] + second[i] * residuals[1])
    }

    fn gaps(&self, values: &[f64], p: Vector, left: Vector) -> Vec<(Vector, f64)> {
        let unknowns = self.unknowns.map(|i| values[i]);
        let (distances, by) = (self.surface.residuals(p, unknowns), self.surface.gradients(p, unknowns));
        let gap = |k: usize| ([by[k][0], by[k][1], by[k][2]], distances[k] - self.offset_mm - left[k]);
        (0..self.surface.rows()).map(gap).collect()
    }

    fn has_length(&self) -> bool {
        matches!(self.surface, Surface::Plane { .. }) && self.offset_mm != 0.0
    }
}

/// Planes, lines and spheres through the targets that touch them, and through the known points on
/// them.
pub(crate) fn fit_surfaces(arm: &dyn FreeBase, settings: &Settings, wanted: &[usize], values: &mut [f64]) {
    type Touches = Vec<(Vector, f64)>;
    let mut touched: Vec<(Surface, [usize; 4], Touches)> = Vec::new();
    let touching = |c: &Condition| match c.kind {
        Kind::On(On { surface, unknowns, offset_mm }) => Some((surface, unknowns, place(arm, c, values), offset_mm)),
        _ => None,
    };
    let known = |k: &Known| match *k {
        Known::On { surface, unknowns, place_mm, .. } => Some((surface, unknowns, place_mm, 0.0)),
        _ => None,
    };
    let all = settings.conditions.iter().filter_map(touching).chain(settings.known.iter().filter_map(known));
    for (surface, unknowns, at, offset_mm) in all.filter(|touch| wanted.contains(&touch.1[0])) {
        match touched.iter_mut().find(|other| other.1 == unknowns) {
            Some(other) => other.2.push((at, offset_mm)),
            None => touched.push((surface, unknowns, vec![(at, offset_mm)])),
        }
    }
    let solved =
        |rows: Vec<f64>, right: Vec<f64>, n: usize| Factor::new(&rows, &right, &vec![1.0; n]).damped(SHORTEST).solve();
    for (surface, unknowns, at) in touched {
        let found = match surface {
            Surface::Plane { axis } => {
                let rows = at.iter().flat_map(|(p, _)| [p[(axis + 1) % 3], p[(axis + 2) % 3], 1.0]).collect();
                let found = solved(rows, at.iter().map(|(p, offset)| p[axis] - offset).collect(), 3);
                found.map(|f| vec![f[0].atan(), f[1].atan(), f[2]])
            }
            Surface::Line { axis } => {
                let of = |k: usize| {
                    let rows = at.iter().flat_map(|(p, _)| [p[axis], 1.0]).collect();
                    solved(rows, at.iter().map(|(p, _)| p[(axis + k) % 3]).collect(), 2)
                };
                of(1).zip(of(2)).map(|(i, j)| vec![i[0].atan(), j[0].atan(), i[1], j[1]])
            }
            // of a sphere |p|² is linear in the centre, and in |c|² − r²
            Surface::Sphere => {
                let centre = centroid(&at.iter().map(|(p, _)| *p).collect::<Vec<_>>()).unwrap_or_default();
                let off: Vec<Vector> = at.iter().map(|(p, _)| minus(*p, centre)).collect();
                let rows = off.iter().flat_map(|p| [p[0], p[1], p[2], 1.0]).collect();
                let offset = mean(at.iter().map(|(_, offset)| *offset));
                solved(rows, off.iter().map(|p| 0.5 * dot(*p, *p)).collect(), 4).map(|f| {
                    let radius = (2.0 * f[3] + f[0] * f[0] + f[1] * f[1] + f[2] * f[2]).max(0.0).sqrt();
                    vec![centre[0] + f[0], centre[1] + f[1], centre[2] + f[2], radius - offset]
                })
            }
        };
        let known = |i: usize| {
            settings.known.iter().any(|k| matches!(k, Known::Place { point, .. } if (*point..point + 3).contains(&i)))
        };
        for (&i, value) in unknowns.iter().zip(found.into_iter().flatten()).filter(|(i, _)| !known(**i)) {
            values[i] = value;
        }
    }
}
