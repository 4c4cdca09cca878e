//! The order in which three angles turn a body.

use crate::message::Message;
use crate::pose::Pose;
use std::fmt;
use std::str::FromStr;

/// Order in which three angles turn a body, about its own (moving) axes or about the fixed axes of
/// the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AngleOrder {
    axes: [usize; 3],
    fixed: bool,
}

impl AngleOrder {
    /// All there are.
    pub fn all() -> Vec<Self> {
        let axes = (0..27).map(|k| [k / 9, k / 3 % 3, k % 3]).filter(|[a, b, c]| a != b && b != c);
        axes.flat_map(|axes| [false, true].map(|fixed| Self { axes, fixed })).collect()
    }

    /// Returns the orientation of a body after rotation by these angles (rad).
    pub fn pose(self, angles: [f64; 3]) -> Pose {
        let turn = |pose: Pose, k: usize| match self.axes[k] {
            0 => pose.turn_x(angles[k]),
            1 => pose.turn_y(angles[k]),
            _ => pose.turn_z(angles[k]),
        };
        // turns about fixed axes are those about moving ones in the other order
        let order = if self.fixed { [2, 1, 0] } else { [0, 1, 2] };
        order.into_iter().fold(Pose::identity(), turn)
    }

    /// Angles (rad) of this orientation. The second angle is in [−π/2, π/2], or in [0, π] if the
    /// first and the third rotation are about the same axis.
    pub fn angles(self, body: &Pose) -> [f64; 3] {
        let r = &body.rotation;
        let [i, j, k] = if self.fixed { [self.axes[2], self.axes[1], self.axes[0]] } else { self.axes };
        let third = 3 - i - j;
        let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        // elements of the product of the three turns
        let moving = match i == k {
            true => [
                r[j][i].atan2(-sign * r[third][i]),
                r[j][i].hypot(r[third][i]).atan2(r[i][i]),
                r[i][j].atan2(sign * r[i][third]),
            ],
            false => [
                (-sign * r[j][k]).atan2(r[k][k]),
                (sign * r[i][k]).atan2(r[i][i].hypot(r[i][j])),
                (-sign * r[i][j]).atan2(r[i][i]),
            ],
        };
        if self.fixed { [moving[2], moving[1], moving[0]] } else { moving }
    }
}

/// About z, then y, then x of the body.
impl Default for AngleOrder {
    fn default() -> Self {
        Self { axes: [2, 1, 0], fixed: false }
    }
}

impl FromStr for AngleOrder {
    type Err = Message;

    fn from_str(text: &str) -> std::result::Result<Self, Message> {
        let found = Self::all().into_iter().find(|order| order.to_string() == text);
        found.ok_or_else(|| crate::error!("angle-order-unknown", text))
    }
}

impl fmt::Display for AngleOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let axes: String = self.axes.iter().map(|&axis| ["x", "y", "z"][axis]).collect();
        write!(f, "{}{axes}", if self.fixed { "fixed " } else { "" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_are_products_of_turns() {
        let order = |text: &str| text.parse::<AngleOrder>().unwrap();
        let [x, y, z] = [0.3, -0.7, 1.9];
        let turned = Pose::identity().turn_z(z).turn_y(y).turn_x(x);
        assert_eq!(order("zyx").pose([z, y, x]), turned);
        assert_eq!(order("fixed xyz").pose([x, y, z]), turned);
        assert_eq!(order("zyz").pose([x, y, z]), Pose::identity().turn_z(x).turn_y(y).turn_z(z));
        assert_eq!(AngleOrder::all().len(), 24);
        for order in AngleOrder::all() {
            let back = order.pose(order.angles(&turned));
            assert!(back.inverse().then(&turned).angle_rad() < 1e-7, "{order}");
        }
        for wrong in ["xxz", "zy", "ZYX ", "rpy"] {
            assert!(wrong.parse::<AngleOrder>().is_err(), "{wrong}");
        }
    }
}
