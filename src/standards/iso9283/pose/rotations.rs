//! Orientations as three successive rotations (not in the standard, which leaves their order to the
//! robot).

use etalon_base::pose::{Pose, Vector, cross, dot, norm};

/// Order of three rotations, multiplied from left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RotationOrder {
    /// Axis (0, 1, 2 for x, y, z) and angle (0, 1, 2 for a, b, c) of each rotation.
    steps: [(usize, usize); 3],
}

impl RotationOrder {
    /// Parses a text like `Rz(c) Ry(b) Rx(a)`; `None` for other texts, and for orders that do not
    /// reach every orientation.
    pub fn parse(text: &str) -> Option<Self> {
        let step = |word: &str| {
            let inner = word.strip_prefix('R')?.strip_suffix(')')?;
            let (axis, angle) = inner.split_once('(')?;
            Some((["x", "y", "z"].iter().position(|a| *a == axis)?, ["a", "b", "c"].iter().position(|a| *a == angle)?))
        };
        let steps: [(usize, usize); 3] =
            text.split_whitespace().map(step).collect::<Option<Vec<_>>>()?.try_into().ok()?;
        let turns = steps[0].0 != steps[1].0 && steps[1].0 != steps[2].0;
        let each_once = (0..3).all(|angle| steps.iter().any(|s| s.1 == angle));
        (turns && each_once).then_some(Self { steps })
    }

    /// Orientation with angles a, b, c (rad).
    pub fn pose(&self, angles_rad: Vector) -> Pose {
        self.steps.iter().fold(Pose::identity(), |pose, (axis, angle)| match axis {
            0 => pose.turn_x(angles_rad[*angle]),
            1 => pose.turn_y(angles_rad[*angle]),
            _ => pose.turn_z(angles_rad[*angle]),
        })
    }

    /// Angles a, b, c of an orientation by Newton's method from `start_rad`; `None` in gimbal lock,
    /// where two angles cannot be separated.
    pub fn angles_rad(&self, wanted: &Pose, start_rad: Vector) -> Option<Vector> {
        let mut angles = start_rad;
        for _ in 0..50 {
            let rest = rotation_vector(&self.pose(angles).inverse().then(wanted));
            if norm(rest) < 1e-14 {
                break;
            }
            // axes in the frame of the rotated body
            let mut after = Pose::identity();
            let mut axes = [[0.0; 3]; 3];
            for (axis, angle) in self.steps.iter().rev() {
                let mut e = [0.0; 3];
                e[*axis] = 1.0;
                axes[*angle] = after.inverse().rotate(e);
                let turned = match axis {
                    0 => Pose::identity().turn_x(angles[*angle]),
                    1 => Pose::identity().turn_y(angles[*angle]),
                    _ => Pose::identity().turn_z(angles[*angle]),
                };
                after = turned.then(&after);
            }
            let [u, v, w] = axes;
            let volume = dot(u, cross(v, w));
            if volume.abs() < 1e-9 {
                return None;
            }
            let steps = [dot(rest, cross(v, w)), dot(rest, cross(w, u)), dot(rest, cross(u, v))];
            angles = [0, 1, 2].map(|k| angles[k] + steps[k] / volume);
        }
        let left = norm(rotation_vector(&self.pose(angles).inverse().then(wanted)));
        (left < 1e-9).then_some(angles)
    }
}

/// Axis times angle of a rotation of less than half a turn.
fn rotation_vector(pose: &Pose) -> Vector {
    let r = &pose.rotation;
    let twice_sine = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
    let sine = 0.5 * norm(twice_sine);
    let cosine = 0.5 * (r[0][0] + r[1][1] + r[2][2] - 1.0);
    let factor = if sine > 0.0 { 0.5 * sine.atan2(cosine) / sine } else { 0.5 };
    twice_sine.map(|v| factor * v)
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    #[test]
    fn only_orders_that_reach_every_orientation_are_read() {
        assert!(RotationOrder::parse("Rz(c) Ry(b) Rx(a)").is_some());
        assert!(RotationOrder::parse(" Rz(a)  Ry(b) Rz(c)").is_some());
        for wrong in
            ["", "Rz(c)", "Rz(c) Rz(b) Rx(a)", "Rz(c) Ry(b) Rx(b)", "Rz(c) Ry(b) Rw(a)", "ZYX", "Rz(c)Ry(b)Rx(a)"]
        {
            assert!(RotationOrder::parse(wrong).is_none(), "{wrong}");
        }
    }

    /// Recovers the angles of a pose from a start several degrees away, for every order.
    #[test]
    fn angles_come_back_in_every_order() {
        let mut noise = Noise::new(3, 0);
        let mut orders = 0;
        for i in "xyz".chars() {
            for j in "xyz".chars() {
                for k in "xyz".chars() {
                    let Some(order) = RotationOrder::parse(&format!("R{i}(c) R{j}(a) R{k}(b)")) else { continue };
                    orders += 1;
                    for _ in 0..50 {
                        // the middle angle stays away from the singularity
                        let middle = if i == k { 1.2 } else { 0.0 };
                        let angles = [middle + noise.uniform(0.9), noise.uniform(3.0), noise.uniform(3.0)];
                        let start = angles.map(|a| a + noise.uniform(0.1));
                        let found = order.angles_rad(&order.pose(angles), start).unwrap();
                        assert!((0..3).all(|n| (found[n] - angles[n]).abs() < 1e-9), "{order:?} {angles:?} {found:?}");
                    }
                }
            }
        }
        assert_eq!(orders, 12);
        let locked = RotationOrder::parse("Rz(c) Ry(b) Rx(a)").unwrap();
        let quarter = [0.1, std::f64::consts::FRAC_PI_2, 0.2];
        assert!(locked.angles_rad(&locked.pose([0.3, 1.5, 0.2]), quarter).is_none());
    }
}
