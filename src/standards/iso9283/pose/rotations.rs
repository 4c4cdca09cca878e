//! Orientations as three successive rotations (not in the standard, which leaves their order to the
//! robot).

use crate::iso9283::statistics::sample::wrapped;
use etalon_base::pose::{Pose, Vector, minus, norm};
use std::f64::consts::PI;

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
        self.steps.iter().fold(Pose::identity(), |pose, (axis, angle)| pose.turn(*axis, angles_rad[*angle]))
    }

    /// Letters (0, 1, 2 for a, b, c) of the first, the middle and the last rotation.
    pub fn letters(&self) -> [usize; 3] {
        self.steps.map(|(_, angle)| angle)
    }

    /// Sine of the angle between the axes of the first and the last rotation. The inverse is the
    /// factor by which an error of the orientation is amplified in these two angles; at zero only
    /// their sum or difference is determined.
    pub fn separation(&self, orientation: &Pose) -> f64 {
        let (first, last) = (self.steps[0].0, orientation.axis(self.steps[2].0));
        last[(first + 1) % 3].hypot(last[(first + 2) % 3])
    }

    /// Angles a, b, c (rad) of an orientation: those nearest to `near_rad` of all that reach it. If
    /// the axes of the first and the last rotation coincide, the last angle is taken from
    /// `near_rad`.
    pub fn angles_rad(&self, wanted: &Pose, near_rad: Vector) -> Vector {
        let [(i, _), (j, _), (k, last)] = self.steps;
        let third = 3 - i - j;
        let hand = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        // R3ᵀ R2ᵀ of the first axis: its part across the last axis shows the last angle
        let first = wanted.inverse().axis(i);
        let [along, across] = if i == k { [hand * first[third], first[j]] } else { [first[i], -hand * first[j]] };
        let is_locked = along.hypot(across) < SAME_AXIS;
        let last_rad = if is_locked { near_rad[last] } else { across.atan2(along) };
        let with_last = |last_rad: f64| {
            let two = wanted.then(&Pose::identity().turn(k, last_rad).inverse());
            // the first rotation alone turns the middle axis
            let turned = two.axis(j);
            let first_rad = (hand * turned[third]).atan2(turned[j]);
            let turned = Pose::identity().turn(i, first_rad).inverse().rotate(two.axis(i));
            let middle_rad = (-hand * turned[third]).atan2(turned[i]);
            let mut angles = near_rad;
            for ((_, letter), value) in self.steps.iter().zip([first_rad, middle_rad, last_rad]) {
                angles[*letter] += wrapped(value - near_rad[*letter]);
            }
            angles
        };
        let [one, other] = [last_rad, last_rad + if is_locked { 0.0 } else { PI }].map(with_last);
        let away = |angles: Vector| norm(minus(angles, near_rad));
        if away(other) < away(one) { other } else { one }
    }
}

/// Sine of the angle between two axes below which they coincide.
const SAME_AXIS: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn only_orders_that_cover_every_orientation_are_read() {
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
                        let found = order.angles_rad(&order.pose(angles), start);
                        assert!((0..3).all(|n| (found[n] - angles[n]).abs() < 1e-9), "{order:?} {angles:?} {found:?}");
                    }
                    // at the singularity and near it the angles still reach the orientation
                    let locked = if i == k { 0.0 } else { FRAC_PI_2 };
                    for off in [0.0, 1e-12, 1e-6, 1e-3] {
                        let pose = order.pose([locked + off, 0.4, -2.9]);
                        let found = order.angles_rad(&pose, [locked, 1.0, 1.0]);
                        let left = order.pose(found).inverse().then(&pose).angle_rad();
                        assert!(left < 1e-8, "{order:?} {off} {left}");
                        assert!((order.separation(&pose) - f64::sin(off)).abs() < 1e-9);
                    }
                }
            }
        }
        assert_eq!(orders, 12);
    }
}
