//! Bodies that block the line of sight from an instrument to a reflector.

use etalon_base::pose::{Pose, Vector, dot, minus};

/// Shape of a body, in the base of the robot or in the frame of a joint (mm).
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Points within a distance from the line between two points.
    Capsule {
        /// Ends of the line.
        ends: [Vector; 2],
        /// Distance.
        radius: f64,
    },
    /// Round cylinder with flat ends.
    Cylinder {
        /// Centres of the ends.
        ends: [Vector; 2],
        /// Radius.
        radius: f64,
    },
    /// Rectangular box.
    Box {
        /// Frame at its centre, with axes along its edges.
        centre: Pose,
        /// Half of the lengths of its edges.
        half: Vector,
    },
}

/// A body that blocks the view.
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacle {
    /// Name.
    pub name: String,
    /// Shape.
    pub shape: Shape,
    /// Joint that moves the body, and in whose frame the shape is; `None` for the base.
    pub joint: Option<usize>,
}

impl Shape {
    /// `true` if a part of the line between two points is inside.
    ///
    /// # Examples
    ///
    /// ```
    /// use etalon_identify::plan::obstacles::Shape;
    ///
    /// // a column of radius 100 mm and height 1 m at the origin
    /// let column = Shape::Cylinder { ends: [[0.0; 3], [0.0, 0.0, 1000.0]], radius: 100.0 };
    /// assert!(column.blocks([-500.0, 0.0, 500.0], [500.0, 99.0, 500.0]));
    /// assert!(!column.blocks([-500.0, 0.0, 1000.5], [500.0, 0.0, 1000.5]), "above its top");
    /// ```
    pub fn blocks(&self, from: Vector, to: Vector) -> bool {
        let way = minus(to, from);
        match self {
            Self::Capsule { ends, radius } => distance_squared([from, to], *ends) < radius * radius,
            Self::Cylinder { ends, radius } => {
                let axis = minus(ends[1], ends[0]);
                let square = dot(axis, axis);
                let along = |p: Vector| dot(minus(p, ends[0]), axis) / square;
                let Some([start, end]) = inside([along(from)], [along(to) - along(from)], [[0.0, 1.0]]) else {
                    return false;
                };
                // offset from the axis as a function of the share of the way
                let across = |v: Vector, share: f64| [0, 1, 2].map(|i| v[i] - share * axis[i]);
                let offset = across(minus(from, ends[0]), along(from));
                let slope = across(way, along(to) - along(from));
                let nearest = if dot(slope, slope) > 0.0 { -dot(offset, slope) / dot(slope, slope) } else { start };
                let share = nearest.clamp(start, end);
                let least = [0, 1, 2].map(|i| offset[i] + share * slope[i]);
                dot(least, least) < radius * radius
            }
            Self::Box { centre, half } => {
                let back = centre.inverse();
                inside(back.apply(from), back.rotate(way), half.map(|h| [-h, h])).is_some()
            }
        }
    }

    /// `true` if a point is inside.
    pub fn contains(&self, point: Vector) -> bool {
        match self {
            Self::Box { centre, half } => {
                centre.inverse().apply(point).iter().zip(half).all(|(x, half)| x.abs() < *half)
            }
            _ => self.blocks(point, point),
        }
    }
}

/// Part of the way, as shares from 0 to 1, on which all coordinates are within their limits; `None`
/// if it is empty or a single point.
fn inside<const N: usize>(from: [f64; N], way: [f64; N], limits: [[f64; 2]; N]) -> Option<[f64; 2]> {
    let (mut start, mut end) = (0.0f64, 1.0f64);
    for ((x, d), [lower, upper]) in from.into_iter().zip(way).zip(limits) {
        if d == 0.0 {
            if x <= lower || x >= upper {
                return None;
            }
            continue;
        }
        let [first, last] = if d > 0.0 { [lower, upper] } else { [upper, lower] };
        start = start.max((first - x) / d);
        end = end.min((last - x) / d);
    }
    (start < end).then_some([start, end])
}

/// Square of the smallest distance between two line segments (Ericson, Real-Time Collision
/// Detection, 2005, 5.1.9).
fn distance_squared(a: [Vector; 2], b: [Vector; 2]) -> f64 {
    let (u, v, w) = (minus(a[1], a[0]), minus(b[1], b[0]), minus(a[0], b[0]));
    let (uu, vv, uv, uw, vw) = (dot(u, u), dot(v, v), dot(u, v), dot(u, w), dot(v, w));
    let share = |above: f64, below: f64| if below > 0.0 { (above / below).clamp(0.0, 1.0) } else { 0.0 };
    // nearest points of the lines, then of the segments
    let s = share(uv * vw - uw * vv, uu * vv - uv * uv);
    let t = share(uv * s + vw, vv);
    let s = share(uv * t - uw, uu);
    let t = share(uv * s + vw, vv);
    let apart = [0, 1, 2].map(|i| w[i] + s * u[i] - t * v[i]);
    dot(apart, apart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    /// `true` if one of many points of the segment is inside.
    fn by_points(from: Vector, to: Vector, is_inside: impl Fn(Vector) -> bool) -> bool {
        (0..=1500).any(|k| is_inside([0, 1, 2].map(|i| from[i] + f64::from(k) / 1500.0 * (to[i] - from[i]))))
    }

    #[test]
    fn a_cylinder_blocks_between_its_flat_ends() {
        // radius 5 about x from 0 to 10
        let cylinder = Shape::Cylinder { ends: [[0.0; 3], [10.0, 0.0, 0.0]], radius: 5.0 };
        for (from, to, expected) in [
            ([5.0, -20.0, 4.99], [5.0, 20.0, 4.99], true),
            ([5.0, -20.0, 5.01], [5.0, 20.0, 5.01], false),
            // along the axis, from outside and within
            ([-9.0, 0.0, 0.0], [19.0, 0.0, 0.0], true),
            ([2.0, 0.0, 0.0], [3.0, 0.0, 0.0], true),
            ([-9.0, 0.0, 0.0], [-0.1, 0.0, 0.0], false),
            // past the corner (10, 5): the line x + y = 15 touches it, x + y = 14.9 cuts it
            ([20.0, -5.0, 0.0], [0.0, 15.0, 0.0], false),
            ([19.9, -5.0, 0.0], [-0.1, 15.0, 0.0], true),
            // parallel to the axis outside, and beside the end plane
            ([-9.0, 6.0, 0.0], [19.0, 6.0, 0.0], false),
            ([10.5, -20.0, 0.0], [10.5, 20.0, 0.0], false),
            // ends before it
            ([5.0, -20.0, 0.0], [5.0, -5.1, 0.0], false),
        ] {
            assert_eq!(cylinder.blocks(from, to), expected, "{from:?} {to:?}");
            assert_eq!(cylinder.blocks(to, from), expected, "{to:?} {from:?}");
        }
    }

    #[test]
    fn a_capsule_has_round_ends() {
        // radius 5 about x from 0 to 10: (14.9, 0) is inside, beyond the end of the cylinder
        let capsule = Shape::Capsule { ends: [[0.0; 3], [10.0, 0.0, 0.0]], radius: 5.0 };
        for (from, to, expected) in [
            ([5.0, -20.0, 4.99], [5.0, 20.0, 4.99], true),
            ([5.0, -20.0, 5.01], [5.0, 20.0, 5.01], false),
            // at 45 degrees past the end: 5 from it is x + y = 10 + 5 √2 = 17.071
            ([20.0, -2.95, 0.0], [0.0, 17.05, 0.0], true),
            ([20.0, -2.91, 0.0], [0.0, 17.09, 0.0], false),
            ([14.9, -20.0, 0.0], [14.9, 20.0, 0.0], true),
            ([15.1, -20.0, 0.0], [15.1, 20.0, 0.0], false),
            // parallel segments, beside each other and apart
            ([-9.0, 4.9, 0.0], [19.0, 4.9, 0.0], true),
            ([-9.0, 5.1, 0.0], [19.0, 5.1, 0.0], false),
            ([-9.0, 0.0, 0.0], [-5.1, 0.0, 0.0], false),
        ] {
            assert_eq!(capsule.blocks(from, to), expected, "{from:?} {to:?}");
            assert_eq!(capsule.blocks(to, from), expected, "{to:?} {from:?}");
        }
        // a capsule without length is a ball
        let ball = Shape::Capsule { ends: [[1.0; 3]; 2], radius: 2.0 };
        assert!(ball.blocks([1.0, 1.0, 2.9], [9.0; 3]) && !ball.blocks([1.0, 1.0, 3.1], [9.0; 3]));
    }

    #[test]
    fn a_box_blocks_in_its_directions() {
        // 20 x 10 x 2 at the origin, turned by 45 degrees about z
        let centre = Pose::identity().turn_z(std::f64::consts::FRAC_PI_4);
        let block = Shape::Box { centre, half: [10.0, 5.0, 1.0] };
        let corner = 15.0 / 2f64.sqrt();
        for (from, to, expected) in [
            // the corner (10, -5) is at x = 15 / √2, y = 5 / √2
            ([corner - 0.01, -30.0, 0.0], [corner - 0.01, 30.0, 0.0], true),
            ([corner + 0.01, -30.0, 0.0], [corner + 0.01, 30.0, 0.0], false),
            ([-30.0, 0.0, 0.99], [30.0, 0.0, 0.99], true),
            ([-30.0, 0.0, 1.01], [30.0, 0.0, 1.01], false),
            // down to the top face, and through it
            ([0.0, 0.0, 9.0], [0.0, 0.0, 1.0], false),
            ([0.0, 0.0, 9.0], [0.0, 0.0, 0.9], true),
            // within
            ([1.0, 1.0, 0.0], [2.0, 2.0, 0.5], true),
        ] {
            assert_eq!(block.blocks(from, to), expected, "{from:?} {to:?}");
            assert_eq!(block.blocks(to, from), expected, "{to:?} {from:?}");
        }
        assert!(block.contains([7.0, 7.0, 0.0]) && !block.contains([7.0, -7.0, 0.0]));
    }

    #[test]
    fn shapes_block_where_a_point_of_the_line_is_inside() {
        let (mut decided, mut blocked) = (0, 0);
        for trial in 0..400 {
            let mut noise = Noise::new(5, trial);
            let mut point = || [0; 3].map(|_| noise.uniform(10.0));
            let (ends, from, to, at, turn) = ([point(), point()], point(), point(), point(), point());
            let (radius, half) = (0.2 + 0.3 * at[0].abs(), at.map(|v| 0.2 + 0.5 * v.abs()));
            let axis = minus(ends[1], ends[0]);
            let along = |p: Vector| dot(minus(p, ends[0]), axis) / dot(axis, axis);
            let off = |p: Vector, share: f64| {
                let apart = [0, 1, 2].map(|i| p[i] - ends[0][i] - share * axis[i]);
                dot(apart, apart).sqrt()
            };
            let centre = Pose { translation_mm: at, ..Pose::from_rotation_vector(turn) };
            let in_box = |p: Vector, by: f64| {
                let p = centre.inverse().apply(p);
                (0..3).all(|i| p[i].abs() < half[i] + by)
            };
            let in_cylinder = |p: Vector, by: f64| {
                let length = dot(axis, axis).sqrt();
                off(p, along(p)) < radius + by && (along(p) - 0.5).abs() * length < 0.5 * length + by
            };
            let in_capsule = |p: Vector, by: f64| off(p, along(p).clamp(0.0, 1.0)) < radius + by;
            let shapes =
                [Shape::Box { centre, half }, Shape::Cylinder { ends, radius }, Shape::Capsule { ends, radius }];
            let is_in: [&dyn Fn(Vector, f64) -> bool; 3] = [&in_box, &in_cylinder, &in_capsule];
            for (shape, is_inside) in shapes.into_iter().zip(is_in) {
                // points are up to 0.024 mm apart: a body smaller, or larger, by 0.02 mm decides
                let surely = by_points(from, to, |p| is_inside(p, -0.02));
                if surely || !by_points(from, to, |p| is_inside(p, 0.02)) {
                    decided += 1;
                    blocked += usize::from(surely);
                    assert_eq!(shape.blocks(from, to), surely, "{shape:?} {from:?} {to:?}");
                }
            }
        }
        assert!(decided > 1150 && (100..1000).contains(&blocked), "{decided} {blocked}");
    }
}
