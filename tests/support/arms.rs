//! Serial arms by their tables: alpha (deg), a (mm), theta (deg), d (mm).

use etalon::robots::{Serial, SerialJoint};

/// An ABB IRB 120 by its drawing.
pub const SIX_AXES: [[f64; 4]; 6] = [
    [0.0, 0.0, 0.0, 290.0],
    [-90.0, 0.0, -90.0, 0.0],
    [0.0, 270.0, 0.0, 0.0],
    [-90.0, 70.0, 0.0, 302.0],
    [90.0, 0.0, 0.0, 0.0],
    [-90.0, 0.0, 180.0, 72.0],
];

/// The arm of a table, of which the joints `bending`, from 1, bend under gravity.
pub fn serial(rows: &[[f64; 4]], targets: &[&str], bending: &[usize]) -> Serial {
    let joint = |(i, &[alpha, a_mm, theta, d_mm]): (usize, &[f64; 4])| SerialJoint {
        alpha_rad: alpha.to_radians(),
        a_mm,
        theta_rad: theta.to_radians(),
        d_mm,
        prismatic: false,
        parallel: i > 0 && alpha == 0.0,
    };
    let joints: Vec<SerialJoint> = rows.iter().enumerate().map(joint).collect();
    let targets: Vec<String> = targets.iter().map(|t| (*t).to_owned()).collect();
    Serial::new(&joints, &targets, [0.0, 0.0, -1.0], bending, &[])
}
