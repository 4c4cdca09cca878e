//! Rigid transforms in space: `a_T_b` is the pose of frame b in frame a; chains read from left to
//! right.

use crate::message::Message;
use crate::scalar::Scalar;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// A point (mm) or direction in space.
pub type Vector<T = f64> = [T; 3];

/// A rigid transform: rotation matrix and translation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Pose<T = f64> {
    /// Rotation matrix, row by row.
    pub rotation: [[T; 3]; 3],
    /// Translation (mm).
    pub translation_mm: Vector<T>,
}

/// Maximum difference of a rotation matrix with three digits from an orthonormal one.
const ORTHONORMAL: f64 = 4e-3;

impl<T: Scalar> Pose<T> {
    /// Identity: the pose of a frame in itself.
    pub fn identity() -> Self {
        let (o, i) = (T::from(0.0), T::from(1.0));
        Self { rotation: [[i, o, o], [o, i, o], [o, o, i]], translation_mm: [o; 3] }
    }

    /// Pose from a translation (mm) and the rotation `Rz(rz) Ry(ry) Rx(rx)` (rad).
    pub fn from_xyz_rpy(xyz_mm: Vector<T>, rpy_rad: Vector<T>) -> Self {
        let turned = Self { translation_mm: xyz_mm, ..Self::identity() };
        turned.turn_z(rpy_rad[2]).turn_y(rpy_rad[1]).turn_x(rpy_rad[0])
    }

    /// Rotation about the direction of a vector by its length (rad) (Rodrigues).
    pub fn from_rotation_vector(vector_rad: Vector<T>) -> Self {
        let [x, y, z] = vector_rad;
        let square = x * x + y * y + z * z;
        // sin θ / θ and (1 − cos θ) / θ²; below 1e-4 rad their series are exact to rounding
        let (sine, versine, cos) = if square.value() < 1e-8 {
            let one = T::from(1.0);
            let versine = square * (-1.0 / 24.0) + 0.5;
            (square * (-1.0 / 6.0) + 1.0, versine, one - versine * square)
        } else {
            let angle = square.sqrt();
            let (sin, cos) = angle.sin_cos();
            (sin / angle, (T::from(1.0) - cos) / square, cos)
        };
        let v = vector_rad;
        let mut rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| versine * v[i] * v[j]));
        for i in 0..3 {
            rotation[i][i] = rotation[i][i] + cos;
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            rotation[k][j] = rotation[k][j] + sine * v[i];
            rotation[j][k] = rotation[j][k] - sine * v[i];
        }
        Self { rotation, ..Self::identity() }
    }

    /// This pose, followed by a rotation about its own x axis.
    pub fn turn_x(self, angle_rad: T) -> Self {
        self.turn(0, angle_rad)
    }

    /// This pose, followed by a rotation about its own y axis.
    pub fn turn_y(self, angle_rad: T) -> Self {
        self.turn(1, angle_rad)
    }

    /// This pose, followed by a rotation about its own z axis.
    pub fn turn_z(self, angle_rad: T) -> Self {
        self.turn(2, angle_rad)
    }

    /// This pose, followed by a rotation about its own axis 0, 1 or 2.
    pub fn turn(mut self, axis: usize, angle_rad: T) -> Self {
        let (sin, cos) = angle_rad.sin_cos();
        self.turn_by(axis, sin, cos);
        self
    }

    /// Rotates the pose about its own axis 0, 1 or 2 by an angle with this sine and cosine.
    #[inline]
    pub fn turn_by(&mut self, axis: usize, sin: T, cos: T) {
        // columns known at compile time
        match axis {
            0 => self.turn_columns::<1, 2>(sin, cos),
            1 => self.turn_columns::<2, 0>(sin, cos),
            _ => self.turn_columns::<0, 1>(sin, cos),
        }
    }

    #[inline(always)]
    fn turn_columns<const I: usize, const J: usize>(&mut self, sin: T, cos: T) {
        for row in &mut self.rotation {
            let (a, b) = (row[I], row[J]);
            row[I] = a * cos + b * sin;
            row[J] = b * cos - a * sin;
        }
    }

    /// This pose, followed by a translation along its own axis 0, 1 or 2.
    pub fn shift(mut self, axis: usize, length_mm: T) -> Self {
        self.shift_by(axis, length_mm);
        self
    }

    /// Translates the pose along its own axis 0, 1 or 2.
    #[inline]
    pub fn shift_by(&mut self, axis: usize, length_mm: T) {
        for (t, row) in self.translation_mm.iter_mut().zip(&self.rotation) {
            *t = *t + row[axis] * length_mm;
        }
    }

    /// Returns the direction of axis 0, 1 or 2 of this frame.
    pub fn axis(&self, axis: usize) -> Vector<T> {
        let [x, y, z] = &self.rotation;
        [x[axis], y[axis], z[axis]]
    }

    /// Transforms a direction from this frame to the reference frame.
    pub fn rotate(&self, d: Vector<T>) -> Vector<T> {
        let [x, y, z] = &self.rotation;
        let along = |row: &[T; 3]| row[0] * d[0] + row[1] * d[1] + row[2] * d[2];
        [along(x), along(y), along(z)]
    }

    /// Transforms a point from this frame to the reference frame.
    pub fn apply(&self, p: Vector<T>) -> Vector<T> {
        let r = self.rotate(p);
        let t = self.translation_mm;
        [r[0] + t[0], r[1] + t[1], r[2] + t[2]]
    }

    /// Composition: `a_T_b` and `b_T_c` give `a_T_c`.
    ///
    /// # Examples
    ///
    /// ```
    /// use etalon_base::pose::Pose;
    /// use std::f64::consts::FRAC_PI_2;
    ///
    /// // a base at x = 100 mm, turned by 90° about z; a flange 50 mm along the x axis of the base
    /// let world_T_base = Pose::from_xyz_rpy([100.0, 0.0, 0.0], [0.0, 0.0, FRAC_PI_2]);
    /// let base_T_flange = Pose::identity().shift(0, 50.0);
    /// let world_T_flange = world_T_base.then(&base_T_flange);
    ///
    /// let [x_mm, y_mm, _] = world_T_flange.translation_mm;
    /// assert!((x_mm - 100.0).abs() < 1e-12 && (y_mm - 50.0).abs() < 1e-12);
    /// assert!((world_T_flange.inverse().angle_rad() - FRAC_PI_2).abs() < 1e-12);
    /// ```
    pub fn then(&self, other: &Self) -> Self {
        let mut rotation = [[T::from(0.0); 3]; 3];
        for (row, mine) in rotation.iter_mut().zip(&self.rotation) {
            for (j, r) in row.iter_mut().enumerate() {
                *r = mine[0] * other.rotation[0][j] + mine[1] * other.rotation[1][j] + mine[2] * other.rotation[2][j];
            }
        }
        Self { rotation, translation_mm: self.apply(other.translation_mm) }
    }

    /// Inverse: `a_T_b` gives `b_T_a`.
    pub fn inverse(&self) -> Self {
        let r = &self.rotation;
        let rotation = [0, 1, 2].map(|j| [r[0][j], r[1][j], r[2][j]]);
        let back = Self { rotation, translation_mm: [T::from(0.0); 3] };
        let t = back.rotate(self.translation_mm);
        Self { rotation, translation_mm: t.map(|v| -v) }
    }
}

impl Pose {
    /// Converts the pose to another scalar type.
    pub fn constant<T: Scalar>(&self) -> Pose<T> {
        Pose { rotation: self.rotation.map(|row| row.map(T::from)), translation_mm: self.translation_mm.map(T::from) }
    }

    /// Angle of the rotation (rad), accurate near zero.
    pub fn angle_rad(&self) -> f64 {
        let r = &self.rotation;
        let sin = norm([r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]]);
        sin.atan2(r[0][0] + r[1][1] + r[2][2] - 1.0)
    }

    /// Rotation as a unit quaternion (w, x, y, z) with w ≥ 0 (Shepperd 1978).
    pub fn quaternion(&self) -> [f64; 4] {
        let r = &self.rotation;
        let trace = r[0][0] + r[1][1] + r[2][2];
        let squares = [trace, r[0][0], r[1][1], r[2][2]];
        let largest = (0..4).fold(0, |best, i| if squares[i] > squares[best] { i } else { best });
        let off = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
        let mut q = [0.0; 4];
        if largest == 0 {
            q = [1.0 + trace, off[0], off[1], off[2]];
        } else {
            let i = largest - 1;
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            q[0] = off[i];
            q[1 + i] = 1.0 + r[i][i] - r[j][j] - r[k][k];
            q[1 + j] = r[j][i] + r[i][j];
            q[1 + k] = r[k][i] + r[i][k];
        }
        let length = q.iter().map(|v| v * v).sum::<f64>().sqrt().copysign(q[0]);
        q.map(|v| v / length)
    }

    /// The rotation of a matrix, row by row.
    ///
    /// # Errors
    /// Fails if the matrix is not orthonormal to three digits, or mirrors.
    pub fn from_rotation(rows: [f64; 9]) -> Result<Self, Message> {
        let rotation: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| rows[3 * i + j]));
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let off = |i: usize, j: usize| (dot(rotation[i], rotation[j]) - unit(i, j)).abs();
        let worst = (0..9).map(|k| off(k / 3, k % 3)).fold(0.0, f64::max);
        if rows.iter().any(|v| !v.is_finite()) || worst >= ORTHONORMAL {
            return Err(crate::error!("rotation-not-orthonormal", off = format!("{worst:.4}")));
        }
        if dot(cross(rotation[0], rotation[1]), rotation[2]) < 0.0 {
            return Err(crate::error!("rotation-mirrors"));
        }
        // rounded elements are made a rotation again
        Ok(Self::from_quaternion(Self { rotation, ..Self::identity() }.quaternion()))
    }

    /// The rotation by a quaternion (w, x, y, z) of any length but zero.
    pub fn from_quaternion(quaternion: [f64; 4]) -> Self {
        let length = quaternion.iter().map(|v| v * v).sum::<f64>().sqrt();
        let [w, x, y, z] = quaternion.map(|v| v / length);
        let rotation = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        Self { rotation, translation_mm: [0.0; 3] }
    }

    /// Rotation vector: direction of the axis, length of the angle (rad, at most π).
    pub fn rotation_vector_rad(&self) -> Vector {
        let [w, x, y, z] = self.quaternion();
        let sine = norm([x, y, z]);
        let factor = if sine > 0.0 { 2.0 * sine.atan2(w) / sine } else { 2.0 };
        [x, y, z].map(|v| factor * v)
    }

    /// Roll, pitch and yaw (rad) of `Rz(yaw) Ry(pitch) Rx(roll)`. At a pitch of a right angle only
    /// the sum or difference of roll and yaw is determined: yaw is then arbitrary, and the other
    /// angles match it.
    pub fn rpy_rad(&self) -> Vector {
        let r = &self.rotation;
        let yaw = r[1][0].atan2(r[0][0]);
        let (sin, cos) = yaw.sin_cos();
        let pitch = (-r[2][0]).atan2(cos * r[0][0] + sin * r[1][0]);
        let roll = (sin * r[0][2] - cos * r[1][2]).atan2(cos * r[1][1] - sin * r[0][1]);
        [roll, pitch, yaw]
    }
}

/// Shortest rotation vector of the rotation (rad).
pub fn shortest(vector_rad: Vector) -> Vector {
    let length = norm(vector_rad);
    let turns = (length / TAU).round();
    if length > PI { vector_rad.map(|v| v * (1.0 - turns * TAU / length)) } else { vector_rad }
}

/// Axes of rotation per unit of each component of a rotation vector: columns of the left Jacobian
/// of the rotation group (Solà et al., "A micro Lie theory", 2018, eq. 145). They are independent
/// below a full turn.
pub fn turning_axes(vector_rad: Vector) -> [Vector; 3] {
    let angle = norm(vector_rad);
    let (first, second) = if angle < 1e-4 {
        (0.5 - angle * angle / 24.0, 1.0 / 6.0 - angle * angle / 120.0)
    } else {
        ((1.0 - angle.cos()) / (angle * angle), (angle - angle.sin()) / angle.powi(3))
    };
    [0, 1, 2].map(|k| {
        let mut column = [0.0; 3];
        column[k] = 1.0;
        let once = cross(vector_rad, column);
        let twice = cross(vector_rad, once);
        [0, 1, 2].map(|i| column[i] + first * once[i] + second * twice[i])
    })
}

/// Difference `a - b`.
pub fn minus<T: Scalar>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Dot product.
pub fn dot<T: Scalar>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Cross product.
pub fn cross<T: Scalar>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Length of a vector.
pub fn norm(a: Vector) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

/// `a` scaled to unit length; `None` if the length is zero or non-finite.
pub fn unit(a: Vector) -> Option<Vector> {
    let length = norm(a);
    (length > 0.0 && length.is_finite()).then(|| a.map(|v| v / length))
}

/// Mean of points; `None` without points.
pub fn centroid(points: &[Vector]) -> Option<Vector> {
    let n = points.len() as f64;
    let sum = points.iter().fold([0.0; 3], |s, p| [s[0] + p[0], s[1] + p[1], s[2] + p[2]]);
    (n > 0.0).then(|| sum.map(|v| v / n))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_undoes_and_chains_compose() {
        let a = Pose::from_xyz_rpy([1.0, -2.0, 3.0], [0.1, -0.7, 2.5]);
        let b = Pose::from_xyz_rpy([-4.0, 0.5, 9.0], [-1.1, 0.2, 0.3]);
        let p = [0.3, 0.2, 0.1];
        let back = a.inverse().apply(a.apply(p));
        let chained = minus(a.then(&b).apply(p), a.apply(b.apply(p)));
        assert!(norm(minus(back, p)) < 1e-14 && norm(chained) < 1e-14);
        let rpy = a.rpy_rad();
        assert!(norm(minus(rpy, [0.1, -0.7, 2.5])) < 1e-14);
        assert!((Pose::<f64>::identity().turn_x(1e-9).angle_rad() - 1e-9).abs() < 1e-20);
    }

    /// At a right angle of pitch, where roll and yaw have one effect, the angles still give the
    /// rotation back.
    #[test]
    fn roll_pitch_yaw_give_the_rotation_back_at_every_pitch() {
        use std::f64::consts::FRAC_PI_2;
        for pitch in [0.0, 1.2, FRAC_PI_2 - 1e-9, FRAC_PI_2, -FRAC_PI_2, -FRAC_PI_2 + 1e-12, 3.0] {
            for [roll, yaw] in [[0.0, 0.0], [0.4, 0.0], [-2.1, 0.7], [3.0, -2.9]] {
                // products of elementary rotations have rounding errors where the pitch is exact
                let pose = Pose::identity().turn_z(yaw).turn_y(pitch).turn_x(roll);
                let back = Pose::from_xyz_rpy([0.0; 3], pose.rpy_rad());
                assert!(pose.inverse().then(&back).angle_rad() < 1e-14, "{roll} {pitch} {yaw}");
            }
        }
    }

    #[test]
    fn rotation_vectors_and_quaternions_give_the_rotation_back() {
        use std::f64::consts::PI;
        let axis = |v: Vector| unit(v).unwrap();
        for direction in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], axis([1.0, 2.0, -3.0]), axis([-0.1, 0.0, 5.0])] {
            for angle in [0.0, 1e-9, 9e-5, 1.1e-4, 0.7, PI - 1e-9, PI] {
                let vector = direction.map(|v| v * angle);
                let pose = Pose::from_rotation_vector(vector);
                let back = Pose::from_rotation_vector(pose.rotation_vector_rad());
                let again = Pose::from_quaternion(pose.quaternion().map(|v| 2.0 * v));
                assert!(pose.inverse().then(&back).angle_rad() < 1e-14, "{direction:?} {angle}");
                assert!(pose.inverse().then(&again).angle_rad() < 1e-14, "{direction:?} {angle}");
                // about z this is the elementary rotation
                let turned = Pose::<f64>::identity().turn_z(angle);
                let same = Pose::from_rotation_vector([0.0, 0.0, angle]);
                assert!(turned.inverse().then(&same).angle_rad() < 1e-15);
                // d(R p) = axis × R p
                let (p, h) = ([0.3, -0.2, 0.9], 1e-6);
                for (k, turning) in turning_axes(vector).into_iter().enumerate() {
                    let at = |h: f64| {
                        let mut moved = vector;
                        moved[k] += h;
                        Pose::from_rotation_vector(moved).apply(p)
                    };
                    let numeric = minus(at(h), at(-h)).map(|v| v / (2.0 * h));
                    let off = norm(minus(cross(turning, pose.apply(p)), numeric));
                    assert!(off < 1e-9, "{direction:?} {angle} {k}: {off}");
                }
            }
        }
    }

    #[test]
    fn a_quarter_turn_about_z_brings_x_to_y() {
        let turned = Pose::<f64>::identity().turn_z(std::f64::consts::FRAC_PI_2).apply([1.0, 0.0, 0.0]);
        assert!(norm(minus(turned, [0.0, 1.0, 0.0])) < 1e-15);
    }
}
