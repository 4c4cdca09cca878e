//! The base frame: plane of the rails, centre of the arc of ball N, line of ball R (thesis 2.6.1).

use super::plane::{Circle, Plane};
use super::uncertain::{Flat, Point, Readings, Uncertain};
use crate::base::message::{Message, Result};
use crate::base::pose::{Vector, cross, dot, minus};
use crate::base::scalar::Scalar;

/// What is measured for the base frame, in mm.
#[derive(Clone, Debug, Default)]
pub struct BaseMeasurements {
    /// Points on the rails of actuators 2 and 3.
    pub rails: Vec<Vector>,
    /// A point on the side of actuator 3.
    pub towards: Vector,
    /// Ball N at the free end of the shaft, while actuator 3 alone turns it.
    pub arc: Vec<Vector>,
    /// Ball R with actuator 2 homed, each reading.
    pub r_home: Vec<Vector>,
    /// Ball R with actuator 2 at its end, each reading.
    pub r_end: Vec<Vector>,
}

/// The base frame of the robot.
#[derive(Clone, Debug)]
pub struct Base {
    /// Its xy plane.
    pub plane: Plane,
    /// The arc of ball N; its centre is the origin O.
    pub arc: Circle,
    /// O in the world frame: from ball R at home, axes parallel to the base's (thesis 3.4.1).
    pub origin_in_world: Flat,
    /// Angle of the y axis in the axes of the plane.
    y_axis_rad: Uncertain,
}

impl Base {
    /// The base frame from what was measured.
    pub fn determine(readings: &mut Readings, measured: &BaseMeasurements) -> Result<Self> {
        let rails = readings.add(&measured.rails);
        let home = mean(&readings.add(&measured.r_home));
        let end = mean(&readings.add(&measured.r_end));
        let (from, to) = (home.each_ref().map(|c| c.value), end.each_ref().map(|c| c.value));
        // x = y × z points towards actuator 3
        let up = |normal: Vector| dot(cross(minus(to, from), normal), minus(measured.towards, from)) > 0.0;
        let plane = Plane::through(readings, &rails, up)?;
        let points = readings.add(&measured.arc);
        let flat: Vec<Flat> = points.iter().map(|p| plane.project(p)).collect();
        let arc = Circle::through(readings, &flat, &points)?;
        let (home, end) = (plane.project(&home), plane.project(&end));
        let travelled = (end[0].value - home[0].value).hypot(end[1].value - home[1].value);
        if !(travelled > 0.0 && travelled.is_finite()) {
            return Err(Message::error("ball R is at the same place at home and at the end of actuator 2")
                .hint("measure it again after moving actuator 2 to its end")
                .into());
        }
        let [y_axis_rad] =
            Uncertain::of([&home[0], &home[1], &end[0], &end[1]], |[x0, y0, x1, y1]| [(y1 - y0).atan2(x1 - x0)]);
        let origin_in_world = express(&arc.centre, &home, &y_axis_rad);
        Ok(Self { plane, arc, origin_in_world, y_axis_rad })
    }

    /// A point in the axes of the plane, expressed in the base frame.
    pub fn express(&self, p: &Flat) -> Flat {
        express(p, &self.arc.centre, &self.y_axis_rad)
    }

    /// A measured point, projected into the plane and expressed in the base frame.
    pub fn locate(&self, p: &Point) -> Flat {
        self.express(&self.plane.project(p))
    }
}

/// `p` from `origin`, along the axis square to the one at this angle and along that one.
fn express(p: &Flat, origin: &Flat, y_axis_rad: &Uncertain) -> Flat {
    Uncertain::of([&p[0], &p[1], &origin[0], &origin[1], y_axis_rad], |[x, y, x0, y0, angle]| {
        let (sin, cos) = angle.sin_cos();
        let (dx, dy) = (x - x0, y - y0);
        [dx * sin - dy * cos, dx * cos + dy * sin]
    })
}

/// The mean of readings of one point.
pub(super) fn mean(points: &[Point]) -> Point {
    [0, 1, 2].map(|k| Uncertain::mean(points.iter().map(|p| &p[k])))
}
