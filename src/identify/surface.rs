//! Planes, lines and spheres that are fixed in the world, and how far a point is from them.

use etalon_base::pose::Vector;
use etalon_base::scalar::{Dual, Scalar};

/// What a target touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// A plane, by two slopes of its normal (rad) towards the axis 0, 1 or 2 of the world, and where it meets that axis (mm).
    Plane {
        /// The axis.
        axis: usize,
    },
    /// A line, by two slopes against the axis 0, 1 or 2 of the world (rad), and where it meets the plane of the other two (mm).
    Line {
        /// The axis.
        axis: usize,
    },
    /// A sphere, by its centre and radius (mm).
    Sphere,
}

/// Derivatives: three of the point, four of the unknowns.
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

    /// How far `p` is from it, mm: of a line along two normals of it.
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

    /// How far a point is from it, mm.
    pub fn residuals(self, p: Vector, unknowns: [f64; 4]) -> [f64; 2] {
        self.distances(p, unknowns)
    }

    /// Derivatives of that, a row each: by the point, and by the unknowns.
    pub fn gradients(self, p: Vector, unknowns: [f64; 4]) -> [[f64; 7]; 2] {
        let variable = |i: usize| Number::variable(if i < 3 { p[i] } else { unknowns[i - 3] }, i);
        self.distances([0, 1, 2].map(variable), [3, 4, 5, 6].map(variable)).map(|d| d.gradient)
    }
}
