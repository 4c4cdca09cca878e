//! Rotary axes of machine tools: direction in the frame of the machine, and tilt that kinematics
//! with exact axes leave out.

use super::CellData;
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, Vector, dot, minus, norm, unit};
use etalon_base::{error, warning};
use etalon_documents::CellDocument;

/// Maximum angle (deg) between a rotary axis and the axis of the machine about which it turns.
const LARGEST_DEG: f64 = 5.0;
/// Minimum tilt (deg) with a warning: 9 µm at 100 mm.
const SMALLEST_DEG: f64 = 0.005;
/// Tilt in standard uncertainties beyond which it is significant.
const SIGNIFICANT: f64 = 3.0;
/// Distance from the axis (mm) at which the effect of a tilt is given.
const LEVER_MM: f64 = 100.0;
/// Names of the axes of a machine.
const NAMES: [&str; 3] = ["x", "y", "z"];

fn scaled(v: Vector, factor: f64) -> Vector {
    v.map(|v| v * factor)
}

fn plus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + b[k])
}

/// Rotary axis in the frame of the measured points.
#[derive(Clone, Debug)]
pub(super) struct MachineAxis {
    /// Unit direction of positive rotation.
    pub direction: Vector,
    /// Foot of the first target (mm).
    pub foot_mm: Vector,
    /// First target at value zero, from its foot (mm).
    pub arm_mm: Vector,
    /// Standard uncertainty of the direction (deg), if it is known.
    u_deg: Option<f64>,
}

impl MachineAxis {
    /// Rotary axis of an answer.
    pub fn new(document: &CellDocument) -> Option<Self> {
        let axis = document.axis.as_ref().filter(|axis| !axis.prismatic)?;
        let frame = document.frames.iter().find(|f| f.name == "axis")?;
        let pose = Pose { translation_mm: frame.xyz_mm, ..Pose::from_quaternion(frame.quaternion) };
        Some(Self {
            direction: pose.axis(2),
            foot_mm: frame.xyz_mm,
            arm_mm: scaled(pose.axis(0), axis.radius_mm.unwrap_or(0.0)),
            u_deg: frame.standard_uncertainty_deg.map(norm),
        })
    }

    /// Axis of the machine (0, 1 or 2) that is nearest to the direction.
    pub fn nearest(&self) -> usize {
        (0..3).max_by(|&a, &b| self.direction[a].abs().total_cmp(&self.direction[b].abs())).unwrap_or(2)
    }

    /// `true` if the axis turns about the positive axis `k` of the machine.
    pub fn is_positive(&self, k: usize) -> bool {
        self.direction[k] > 0.0
    }

    /// Angle (deg) to the axis `k` of the machine.
    fn tilt_deg(&self, k: usize) -> f64 {
        let mut across = self.direction;
        across[k] = 0.0;
        norm(across).atan2(self.direction[k].abs()).to_degrees()
    }

    /// Point of the axis whose coordinate `k` is `at_mm`.
    pub fn point_at(&self, k: usize, at_mm: f64) -> Vector {
        let along = (at_mm - self.foot_mm[k]) / self.direction[k];
        plus(self.foot_mm, scaled(self.direction, along))
    }

    /// Rejects an axis that is not along the axis `k` of the machine.
    ///
    /// # Errors
    /// Reports the angle.
    pub fn check(&self, k: usize, maker: &str) -> Result<()> {
        let angle_deg = self.tilt_deg(k);
        if angle_deg <= LARGEST_DEG {
            return Ok(());
        }
        Err(error!("cell-axis-direction", maker, axis = NAMES[k], angle_deg).into())
    }

    /// Warning of a tilt that the kinematics leave out.
    pub fn tilt_warning(&self, k: usize, maker: &str) -> Option<Message> {
        let angle_deg = self.tilt_deg(k);
        let is_significant = self.u_deg.is_some_and(|u| angle_deg > SIGNIFICANT * u);
        let left_um = 1000.0 * LEVER_MM * angle_deg.to_radians();
        (is_significant && angle_deg > SMALLEST_DEG)
            .then(|| warning!("cell-axis-tilted", maker, axis = NAMES[k], angle_deg, left_um))
    }

    /// Line of the header with the tilt.
    pub fn tilt_line(&self, name: &str, k: usize) -> String {
        let u = self.u_deg.map_or("unknown".to_owned(), |u| format!("{u:.5} deg"));
        let (tilt, machine) = (self.tilt_deg(k), NAMES[k]);
        format!("axis {name}: tilt against {machine} of the machine {tilt:.5} deg (u {u}), which is left out")
    }
}

/// Table on a tilting table: the tilting axis along `tilting` (x or y), the axis of the table along
/// z at zero of the tilting axis.
pub(super) struct TwoAxes<'a> {
    pub tilting: &'a MachineAxis,
    pub table: &'a MachineAxis,
    /// `true` if both turn about the positive axes of the machine.
    pub positive: bool,
}

impl<'a> TwoAxes<'a> {
    /// The two axes of an answer.
    ///
    /// # Errors
    /// Rejects a missing axis, other directions, and axes that turn in opposite senses.
    pub fn new(data: &'a CellData, tilting: usize, maker: &str) -> Result<Self> {
        let [first, second] = &data.axes[..] else {
            return Err(error!("cell-second-axis-missing", maker, axis = NAMES[tilting]).into());
        };
        let (table, tilting_axis) = if first.nearest() == 2 { (first, second) } else { (second, first) };
        table.check(2, maker)?;
        tilting_axis.check(tilting, maker)?;
        let positive = [tilting_axis.is_positive(tilting), table.is_positive(2)];
        if positive[0] != positive[1] {
            return Err(error!("cell-axis-sense", maker, axis = NAMES[tilting], sense = "opposite").into());
        }
        Ok(Self { tilting: tilting_axis, table, positive: positive[0] })
    }

    /// Point of the table's axis at the height of its first target, and point of the tilting axis
    /// beside it.
    pub fn points(&self, tilting: usize) -> [Vector; 2] {
        let of_table = self.table.foot_mm;
        [of_table, self.tilting.point_at(tilting, of_table[tilting])]
    }
}

/// Distance (mm) of the first target below the axis, and beside the spindle (z of the machine), for
/// a tilting axis across the spindle.
pub(super) fn below_and_beside(axis: &MachineAxis) -> [f64; 2] {
    const SPINDLE: Vector = [0.0, 0.0, 1.0];
    let across = minus(SPINDLE, scaled(axis.direction, dot(SPINDLE, axis.direction)));
    let up = unit(across).unwrap_or(SPINDLE);
    let below = -dot(axis.arm_mm, up);
    [below, norm(plus(axis.arm_mm, scaled(up, below)))]
}
