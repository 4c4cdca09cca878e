//! Angles of revolute joints and of orientations, which are equal modulo a turn.
//!
//! A controller may wrap the angle of a joint, so that 179.999 deg and −179.999 deg are neighbours.
//! A joint that winds is recorded over more than a turn, and keeps its turns. Lengths never wrap.

use std::f64::consts::TAU;

/// Full turn in the unit of the angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn(f64);

/// Share of a turn beyond which a step between neighbours of a recording is a wrap: no joint turns
/// so far from one row to the next.
const WRAP: f64 = 0.75;
/// Share of a turn by which rounding may enlarge the range of wrapped angles.
const ROUNDING: f64 = 1e-3;

impl Turn {
    /// Turn of angles in degrees.
    pub const DEGREES: Self = Self(360.0);
    /// Turn of angles in radians.
    pub const RADIANS: Self = Self(TAU);

    /// Angle of the nearest whole number of turns.
    pub fn whole(self, angle: f64) -> f64 {
        (angle / self.0).round() * self.0
    }

    /// Difference of two angles the shorter way, at most half a turn to either side.
    ///
    /// ```
    /// use etalon_base::angle::Turn;
    /// assert!((Turn::DEGREES.difference(-179.999, 179.999) - 0.002).abs() < 1e-9);
    /// assert!((Turn::DEGREES.difference(10.0, 370.5) + 0.5).abs() < 1e-9);
    /// ```
    pub fn difference(self, to: f64, from: f64) -> f64 {
        let difference = to - from;
        difference - self.whole(difference)
    }

    /// Angle that is nearest to a reference and equal modulo a turn.
    pub fn near(self, angle: f64, reference: f64) -> f64 {
        angle - self.whole(angle - reference)
    }

    /// Angles of one place without jumps: each is within half a turn of the first.
    pub fn about_first(self, angles: &[f64]) -> Vec<f64> {
        let first = angles.first().copied().unwrap_or_default();
        angles.iter().map(|angle| first + self.difference(*angle, first)).collect()
    }

    /// Angles along a motion without jumps: each is within half a turn of the previous one.
    pub fn followed(self, angles: &[f64]) -> Vec<f64> {
        let mut all: Vec<f64> = Vec::with_capacity(angles.len());
        for &angle in angles {
            let before = all.last().copied().unwrap_or(angle);
            all.push(before + self.difference(angle, before));
        }
        all
    }

    /// `true` if the angles of a joint cover more than a turn: the joint winds, and its recording
    /// keeps the turns.
    pub fn winds(self, angles: &[f64]) -> bool {
        let finite = || angles.iter().copied().filter(|angle| angle.is_finite());
        let [low, high] = finite().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
        high - low > (1.0 + ROUNDING) * self.0
    }

    /// Recorded angles of a joint, in their order, without the jumps of a controller that wraps
    /// them. Angles that cover more than a turn are not wrapped, and stay as they are.
    ///
    /// ```
    /// use etalon_base::angle::Turn;
    /// assert_eq!(Turn::DEGREES.unwound(&[179.0, -180.0, -178.0, 179.5]), [179.0, 180.0, 182.0,
    /// 179.5]); assert_eq!(Turn::DEGREES.unwound(&[-300.0, 0.0, 300.0]), [-300.0, 0.0, 300.0]);
    /// ```
    pub fn unwound(self, angles: &[f64]) -> Vec<f64> {
        if self.winds(angles) {
            return angles.to_vec();
        }
        let (mut before, mut turns) = (None, 0.0);
        let unwind = |&angle: &f64| {
            if !angle.is_finite() {
                return angle;
            }
            let step = before.map_or(0.0, |before| angle - before);
            before = Some(angle);
            if step.abs() > WRAP * self.0 {
                turns -= self.whole(step);
            }
            angle + turns
        };
        angles.iter().map(unwind).collect()
    }

    /// Arc that angles cover: the turn minus the largest gap between neighbours.
    ///
    /// ```
    /// use etalon_base::angle::Turn;
    /// assert!((Turn::DEGREES.arc(&[179.0, -178.0, 180.0]) - 3.0).abs() < 1e-9);
    /// ```
    pub fn arc(self, angles: &[f64]) -> f64 {
        let mut sorted: Vec<f64> = angles.iter().map(|angle| angle.rem_euclid(self.0)).collect();
        sorted.sort_by(f64::total_cmp);
        let Some((first, last)) = sorted.first().zip(sorted.last()) else { return 0.0 };
        let gap = sorted.windows(2).map(|pair| pair[1] - pair[0]).fold(first + self.0 - last, f64::max);
        (self.0 - gap).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Wrapping an angle and unwinding it again gives the angle up to whole turns, wherever the
    /// motion passes the half turn.
    #[test]
    fn a_wrapped_motion_is_unwound() {
        for start in -40..40 {
            let motion: Vec<f64> = (0..60).map(|i| 9.0 * f64::from(start) + 5.0 * f64::from(i)).collect();
            let wrapped: Vec<f64> = motion.iter().map(|angle| Turn::DEGREES.near(*angle, 0.0)).collect();
            let unwound = Turn::DEGREES.unwound(&wrapped);
            let off = unwound[0] - motion[0];
            assert!((off - Turn::DEGREES.whole(off)).abs() < 1e-9);
            assert!(unwound.iter().zip(&motion).all(|(a, b)| (a - b - off).abs() < 1e-9), "{start}");
        }
    }

    #[test]
    fn a_joint_that_winds_keeps_its_turns() {
        let motion: Vec<f64> = (0..80).map(|i| 10.0 * f64::from(i) - 400.0).collect();
        assert_eq!(Turn::DEGREES.unwound(&motion), motion);
        // a large move within a turn is no wrap
        assert_eq!(Turn::DEGREES.unwound(&[-100.0, 110.0, -100.0]), [-100.0, 110.0, -100.0]);
        let [a, b] = [f64::NAN, 3.0];
        assert!(Turn::RADIANS.unwound(&[a, b])[0].is_nan());
    }

    #[test]
    fn the_mean_of_angles_at_the_half_turn_is_there() {
        let angles = Turn::DEGREES.about_first(&[179.998, -179.998, 180.0, -180.0]);
        assert!((angles.iter().sum::<f64>() / 4.0 - 180.0).abs() < 1e-9, "{angles:?}");
        assert!((Turn::DEGREES.arc(&angles) - 0.004).abs() < 1e-9);
    }
}
