//! Frames (thesis 2.6.1, 2.6.2): a plane and a circle in it through measured points; the base frame
//! from the plane of the rails, the centre of the arc of ball N and the line of ball R; the mobile
//! frame from balls turned with the platform.

use super::uncertain::{Flat, Readings, Scatter, Uncertain, UncertainPoint, shifts, values};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, cross, dot, minus, unit};
use etalon_base::scalar::Scalar;

/// A plane through points, with fixed but arbitrary axes in it.
#[derive(Clone, Debug)]
pub struct FittedPlane {
    /// Centroid of its points.
    pub point_mm: Vector,
    /// Two directions in the plane and its normal, right-handed.
    pub axes: [Vector; 3],
    /// Tilts of the normal towards the first and the second direction, in rad; their values are
    /// zero.
    tilt: [Uncertain; 2],
    /// Distances of the points from the plane.
    pub scatter: Scatter,
}

impl FittedPlane {
    /// Least-squares plane through three or more points; `up` decides the direction of the normal.
    pub fn through(readings: &mut Readings, points: &[UncertainPoint], up: impl Fn(Vector) -> bool) -> Result<Self> {
        let p = values(points);
        let fitted = etalon_fit::plane(&p, &etalon_fit::FitSettings::default())?;
        let found = fitted.geometry.direction.unwrap_or([0.0, 0.0, 1.0]);
        let normal = if up(found) { found } else { found.map(|v| -v) };
        let side = if normal[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let e2 = unit(cross(normal, side)).unwrap_or([0.0, 1.0, 0.0]);
        let e1 = cross(e2, normal);
        let offsets: Vec<Vector> = p.iter().map(|&p| minus(p, fitted.geometry.point_mm)).collect();
        let rows: Vec<[f64; 3]> = offsets.iter().map(|&w| [-1.0, dot(w, e1), dot(w, e2)]).collect();
        let moves: Vec<Uncertain> = points.iter().map(|p| Uncertain::linear(0.0, normal.into_iter().zip(p))).collect();
        let distances: Vec<f64> = offsets.iter().map(|&w| dot(w, normal)).collect();
        let [_, t1, t2] = shifts(&rows, &moves)?;
        let scatter = readings.judge(&distances, &moves, 3, points);
        Ok(Self { point_mm: fitted.geometry.point_mm, axes: [e1, e2, normal], tilt: [t1, t2], scatter })
    }

    /// A point projected into the plane, along its two directions from the centroid (mm).
    pub fn project(&self, p: &UncertainPoint) -> Flat {
        let [e1, e2, e3] = self.axes;
        let c = self.point_mm;
        Uncertain::propagate([&p[0], &p[1], &p[2], &self.tilt[0], &self.tilt[1]], |[x, y, z, t1, t2]| {
            let w = [x + (-c[0]), y + (-c[1]), z + (-c[2])];
            let along = |e: Vector| w[0] * e[0] + w[1] * e[1] + w[2] * e[2];
            let (a, b, h) = (along(e1), along(e2), along(e3));
            // turned so that its third axis is the tilted normal
            let (s1, c1) = t1.sin_cos();
            let (s2, c2) = t2.sin_cos();
            let (a, h) = (a * c1 + h * (-s1), a * s1 + h * c1);
            [a, b * c2 + h * (-s2)]
        })
    }
}

/// A circular arc and its centre.
#[derive(Clone, Debug)]
pub struct FittedArc {
    /// Centre.
    pub centre: Flat,
    /// Share of the circle that has points.
    pub coverage_deg: f64,
    /// Radial residuals (thesis 2.6.1 gives their largest and their norm).
    pub scatter: Scatter,
}

impl FittedArc {
    /// Least-squares circle through `flat`, the projections of `points`.
    pub fn through(readings: &mut Readings, flat: &[Flat], points: &[UncertainPoint]) -> Result<Self> {
        let p = values(flat);
        let fitted = etalon_fit::circle2d(&p, &etalon_fit::FitSettings::default())?;
        let [x, y, _] = fitted.geometry.point_mm;
        let radial = |p: &[f64; 2]| {
            let (dx, dy) = (p[0] - x, p[1] - y);
            let length = dx.hypot(dy);
            [dx / length, dy / length]
        };
        let rows: Vec<[f64; 3]> = p.iter().map(radial).map(|[gx, gy]| [-gx, -gy, -1.0]).collect();
        let moves: Vec<Uncertain> =
            flat.iter().zip(&p).map(|(f, p)| Uncertain::linear(0.0, radial(p).into_iter().zip(f))).collect();
        let [dx, dy, _] = shifts(&rows, &moves)?;
        let radius = fitted.geometry.radius_mm.unwrap_or_default();
        let residuals: Vec<f64> = p.iter().map(|p| (p[0] - x).hypot(p[1] - y) - radius).collect();
        let scatter = readings.judge(&residuals, &moves, 3, points);
        Ok(Self { centre: [dx.at(x), dy.at(y)], coverage_deg: fitted.coverage_deg().unwrap_or_default(), scatter })
    }
}

/// Points (mm) that define the base frame.
#[derive(Clone, Debug, Default)]
pub struct BaseMeasurements {
    /// Points on the rails of actuators 2 and 3.
    pub rails: Vec<Vector>,
    /// A point on the side of actuator 3.
    pub towards: Vector,
    /// Ball N at the free end of the shaft, while actuator 3 alone turns it.
    pub arc: Vec<Vector>,
    /// All readings of ball R with actuator 2 homed.
    pub r_home: Vec<Vector>,
    /// Ball R with actuator 2 at its end, each reading.
    pub r_end: Vec<Vector>,
}

/// The base frame of the robot.
#[derive(Clone, Debug)]
pub struct Base {
    /// Its xy plane.
    pub plane: FittedPlane,
    /// The arc of ball N; its centre is the origin O.
    pub arc: FittedArc,
    /// O in the world frame, whose origin is ball R at home, with axes parallel to the axes of the
    /// base (thesis 3.4.1).
    pub origin_in_world: Flat,
    /// Angle of the y axis in the axes of the plane.
    y_axis_rad: Uncertain,
}

/// The plane of the rails and the direction of actuator 2 in it: the base frame without its origin.
#[derive(Clone, Debug)]
pub struct Axes {
    /// Its xy plane.
    pub plane: FittedPlane,
    /// Ball R at home, in the plane.
    home: Flat,
    /// Angle of the y axis in the axes of the plane.
    y_axis_rad: Uncertain,
}

impl Axes {
    /// Frame from the rails and ball R, without the arc.
    pub fn determine(readings: &mut Readings, measured: &BaseMeasurements) -> Result<Self> {
        let rails = readings.add(&measured.rails);
        let home = mean(&readings.add(&measured.r_home));
        let end = mean(&readings.add(&measured.r_end));
        let (from, to) = (home.each_ref().map(|c| c.value), end.each_ref().map(|c| c.value));
        // x = y × z points towards actuator 3
        let up = |normal: Vector| dot(cross(minus(to, from), normal), minus(measured.towards, from)) > 0.0;
        let plane = FittedPlane::through(readings, &rails, up)?;
        let (home, end) = (plane.project(&home), plane.project(&end));
        let travelled = (end[0].value - home[0].value).hypot(end[1].value - home[1].value);
        if !(travelled > 0.0 && travelled.is_finite()) {
            return Err(error!("ball-unmoved", ball = "R", actuator = 2).into());
        }
        let [y_axis_rad] =
            Uncertain::propagate([&home[0], &home[1], &end[0], &end[1]], |[x0, y0, x1, y1]| [(y1 - y0).atan2(x1 - x0)]);
        Ok(Self { plane, home, y_axis_rad })
    }
}

impl Base {
    /// The base frame from measured points.
    pub fn determine(readings: &mut Readings, measured: &BaseMeasurements) -> Result<Self> {
        let axes = Axes::determine(readings, measured)?;
        Self::about(readings, axes, &measured.arc)
    }

    /// The base frame whose origin is the centre of an arc of ball N.
    pub fn about(readings: &mut Readings, axes: Axes, arc: &[Vector]) -> Result<Self> {
        let Axes { plane, home, y_axis_rad } = axes;
        let points = readings.add(arc);
        let flat: Vec<Flat> = points.iter().map(|p| plane.project(p)).collect();
        let arc = FittedArc::through(readings, &flat, &points)?;
        let origin_in_world = express(&arc.centre, &home, &y_axis_rad);
        Ok(Self { plane, arc, origin_in_world, y_axis_rad })
    }

    /// A point in the axes of the plane, expressed in the base frame.
    pub fn express(&self, p: &Flat) -> Flat {
        express(p, &self.arc.centre, &self.y_axis_rad)
    }

    /// A measured point, projected into the plane and expressed in the base frame.
    pub fn locate(&self, p: &UncertainPoint) -> Flat {
        self.express(&self.plane.project(p))
    }
}

/// Coordinates of `p` relative to `origin`: along the axis perpendicular to the axis at this angle,
/// and along that axis.
fn express(p: &Flat, origin: &Flat, y_axis_rad: &Uncertain) -> Flat {
    Uncertain::propagate([&p[0], &p[1], &origin[0], &origin[1], y_axis_rad], |[x, y, x0, y0, angle]| {
        let (sin, cos) = angle.sin_cos();
        let (dx, dy) = (x - x0, y - y0);
        [dx * sin - dy * cos, dx * cos + dy * sin]
    })
}

/// The mean of readings of one point.
pub(super) fn mean(points: &[UncertainPoint]) -> UncertainPoint {
    [0, 1, 2].map(|k| Uncertain::mean(points.iter().map(|p| &p[k])))
}

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
    pub circle: FittedArc,
    /// Mean distance of K and L in the plane.
    pub l_kl: Uncertain,
}

impl Mobile {
    /// C from the platform that rotates about it.
    pub fn determine(readings: &mut Readings, plane: &FittedPlane, turned: &[Turned]) -> Result<Self> {
        let (mut points, mut flat, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        for t in turned {
            let three = [t.k, t.l, t.i].map(|p| readings.add_one(p));
            let [k, l, i] = three.each_ref().map(|p| plane.project(p));
            let [x, y, length] =
                Uncertain::propagate([&k[0], &k[1], &l[0], &l[1], &i[0], &i[1]], |[kx, ky, lx, ly, ix, iy]| {
                    let (ex, ey, wx, wy) = (lx - kx, ly - ky, ix - kx, iy - ky);
                    let length = Scalar::sqrt(ex * ex + ey * ey);
                    [(wx * ex + wy * ey) / length, (wy * ex - wx * ey) / length, length]
                });
            flat.push([x, y]);
            lengths.push(length);
            points.extend(three);
        }
        let circle = FittedArc::through(readings, &flat, &points)?;
        Ok(Self { circle, l_kl: Uncertain::mean(&lengths) })
    }

    /// Returns C in the plane, for these positions of K and L (eq. 3.16).
    pub fn centre(&self, k: &Flat, l: &Flat) -> Flat {
        let [x_c, y_c] = &self.circle.centre;
        Uncertain::propagate([&k[0], &k[1], &l[0], &l[1], x_c, y_c], |[kx, ky, lx, ly, x, y]| {
            let (ex, ey) = (lx - kx, ly - ky);
            let length = Scalar::sqrt(ex * ex + ey * ey);
            [kx + (x * ex - y * ey) / length, ky + (x * ey + y * ex) / length]
        })
    }
}
