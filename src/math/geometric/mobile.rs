//! The mobile frame: centre C in the frame of balls K and L, from the circle that ball I makes there (thesis 2.6.2).

use super::plane::{Circle, Plane};
use super::uncertain::{Flat, Readings, Uncertain};
use crate::base::message::Result;
use crate::base::pose::Vector;

/// Balls K and L on the platform and I on the tapered block, measured together.
#[derive(Clone, Copy, Debug)]
pub struct Turned {
    /// Ball K.
    pub k: Vector,
    /// Ball L.
    pub l: Vector,
    /// Ball I.
    pub i: Vector,
}

/// The mobile frame on the platform.
#[derive(Clone, Debug)]
pub struct Mobile {
    /// The circle of ball I in the frame of K and L; its centre is C.
    pub circle: Circle,
    /// Mean distance of K and L in the plane.
    pub l_kl: Uncertain,
}

impl Mobile {
    /// C from the platform turned about it.
    pub fn determine(readings: &mut Readings, plane: &Plane, turned: &[Turned]) -> Result<Self> {
        let (mut points, mut flat, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        for t in turned {
            let three = [t.k, t.l, t.i].map(|p| readings.add_one(p));
            let [k, l, i] = three.each_ref().map(|p| plane.project(p));
            let [x, y, length] =
                Uncertain::of([&k[0], &k[1], &l[0], &l[1], &i[0], &i[1]], |[kx, ky, lx, ly, ix, iy]| {
                    let (ex, ey, wx, wy) = (lx - kx, ly - ky, ix - kx, iy - ky);
                    let length = crate::base::scalar::Scalar::sqrt(ex * ex + ey * ey);
                    [(wx * ex + wy * ey) / length, (wy * ex - wx * ey) / length, length]
                });
            flat.push([x, y]);
            lengths.push(length);
            points.extend(three);
        }
        let circle = Circle::through(readings, &flat, &points)?;
        Ok(Self { circle, l_kl: Uncertain::mean(&lengths) })
    }

    /// C in the plane, where K and L are there (eq. 3.16).
    pub fn centre(&self, k: &Flat, l: &Flat) -> Flat {
        let [x_c, y_c] = &self.circle.centre;
        Uncertain::of([&k[0], &k[1], &l[0], &l[1], x_c, y_c], |[kx, ky, lx, ly, x, y]| {
            let (ex, ey) = (lx - kx, ly - ky);
            let length = crate::base::scalar::Scalar::sqrt(ex * ex + ey * ey);
            [kx + (x * ex - y * ey) / length, ky + (x * ey + y * ex) / length]
        })
    }
}
