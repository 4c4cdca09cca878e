//! Coordinates of every kind become Cartesian ones.

use crate::base::pose::Vector;
use crate::import::format::Role;

/// Place of a point in mm, from coordinates in mm and rad in the order of their columns, and its standard uncertainties
/// in x, y and z from theirs: each independent of the others, to first order; what is common to x, y and z is left out.
pub(super) fn cartesian(of: &[(Role, f64)], uncertain: Option<&[f64]>) -> (Vector, Option<Vector>) {
    let get = |role: Role| of.iter().find(|(r, _)| *r == role).map(|(_, value)| *value);
    let turn = if get(Role::AzimuthClockwise).is_some() { -1.0 } else { 1.0 };
    let azimuth = turn * get(Role::Azimuth).or(get(Role::AzimuthClockwise)).unwrap_or(0.0);
    let (s, c) = azimuth.sin_cos();
    let (place, derivative): (Vector, &dyn Fn(Role) -> Vector) = match (get(Role::Radius), get(Role::Distance)) {
        (Some(radius), _) => ([radius * c, radius * s, get(Role::Z).unwrap_or(0.0)], &move |role| match role {
            Role::Radius => [c, s, 0.0],
            Role::Z => [0.0, 0.0, 1.0],
            _ => [-turn * radius * s, turn * radius * c, 0.0],
        }),
        (_, Some(distance)) => {
            // sine and cosine of the angle from the z axis, and which way it grows
            let (away, along, grows) = match (get(Role::Zenith), get(Role::Elevation)) {
                (Some(zenith), _) => (zenith.sin(), zenith.cos(), 1.0),
                (_, elevation) => (elevation.unwrap_or(0.0).cos(), elevation.unwrap_or(0.0).sin(), -1.0),
            };
            ([distance * away * c, distance * away * s, distance * along], &move |role| match role {
                Role::Distance => [away * c, away * s, along],
                Role::Zenith | Role::Elevation => {
                    [grows * distance * along * c, grows * distance * along * s, -grows * distance * away]
                }
                _ => [-turn * distance * away * s, turn * distance * away * c, 0.0],
            })
        }
        _ => ([Role::X, Role::Y, Role::Z].map(|axis| get(axis).unwrap_or(0.0)), &|role| match role {
            Role::X => [1.0, 0.0, 0.0],
            Role::Y => [0.0, 1.0, 0.0],
            _ => [0.0, 0.0, 1.0],
        }),
    };
    let spread = |u: &[f64]| {
        let share =
            |axis: usize| of.iter().zip(u).map(|((role, _), u)| (derivative(*role)[axis] * u).powi(2)).sum::<f64>();
        [0, 1, 2].map(|axis| share(axis).sqrt())
    };
    (place, uncertain.map(spread))
}

#[cfg(test)]
mod tests {
    use super::*;
    use Role::*;

    /// Three kinds of coordinates of (3, -4, 12): distance 13, radius 5.
    #[test]
    fn the_same_point_in_every_kind_of_coordinates() {
        let azimuth = (-4.0f64).atan2(3.0);
        let zenith = (12.0f64 / 13.0).acos();
        let up = std::f64::consts::FRAC_PI_2 - zenith;
        for of in [
            [(X, 3.0), (Y, -4.0), (Z, 12.0)],
            [(Radius, 5.0), (Azimuth, azimuth), (Z, 12.0)],
            [(Z, 12.0), (AzimuthClockwise, -azimuth), (Radius, 5.0)],
            [(Azimuth, azimuth), (Zenith, zenith), (Distance, 13.0)],
            [(Distance, 13.0), (AzimuthClockwise, -azimuth), (Elevation, up)],
        ] {
            let place = cartesian(&of, None).0;
            let off = place.iter().zip([3.0, -4.0, 12.0]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-14 * 13.0, "{of:?}: {place:?}");
        }
    }

    #[test]
    fn uncertainties_follow_numeric_derivatives() {
        let u = [2e-6, 3e-6, 0.004];
        for of in [
            [(Azimuth, 0.7), (Zenith, 1.2), (Distance, 3000.0)],
            [(AzimuthClockwise, 0.7), (Elevation, -0.4), (Distance, 3000.0)],
            [(AzimuthClockwise, 2.7), (Radius, 500.0), (Z, 7.0)],
            [(Z, 0.7), (X, 1.2), (Y, 3000.0)],
        ] {
            let (_, found) = cartesian(&of, Some(&u));
            let mut expected = [0.0f64; 3];
            for j in 0..3 {
                let step = |h: f64| {
                    let mut moved = of;
                    moved[j].1 += h;
                    cartesian(&moved, None).0
                };
                let h = 1e-6 * of[j].1.abs();
                let (before, after) = (step(-h), step(h));
                (0..3).for_each(|axis| expected[axis] += ((after[axis] - before[axis]) / (2.0 * h) * u[j]).powi(2));
            }
            for (found, expected) in found.unwrap().iter().zip(expected) {
                assert!((found - expected.sqrt()).abs() < 1e-7 * expected.sqrt().max(1e-4), "{of:?}");
            }
        }
    }
}
