//! The five-bar of the thesis, section 4.2: its true parameters, its plate and what is measured on it.

use etalon::identify::{Observation, Settings};
use etalon::robots::{FiveBar, FiveBarLimits, Robot};

/// "Actual" column of table 4.1, in the order of eq. 4.24.
pub fn truth() -> Vec<f64> {
    let deg = f64::to_radians;
    vec![
        230.010,
        230.110,
        229.880,
        230.403,
        275.102,
        230.210,
        deg(1.948),
        deg(1.306),
        deg(-0.401),
        263.391,
        75.499,
        deg(0.573),
    ]
}

/// The nominal robot with limits: a proximal link does not cross the other arm's distal link, 5 degrees away from
/// singularities of type 1, 25 from type 2.
pub fn robot() -> FiveBar {
    FiveBar::default().with_limits(FiveBarLimits {
        clearance_mm: Some(0.0),
        type1_margin_rad: 5f64.to_radians(),
        type2_margin_rad: 25f64.to_radians(),
        ..FiveBarLimits::default()
    })
}

/// The holes of the plate in the world: 24 × 24 at 25.4 mm, P2 the origin (section 4.2, 4.3.1).
pub fn holes() -> Vec<(usize, usize, [f64; 2])> {
    let place = |i: usize, first: f64| first + 25.4 * i as f64;
    (0..24).flat_map(|i| (0..24).map(move |j| (i, j, [place(i, -25.4), place(j, -228.6)]))).collect()
}

/// What a measurement of the true robot at `positions` says, in all working modes that reach them by the drawing.
pub fn measure(
    robot: &FiveBar,
    truth: &[f64],
    positions: &[[f64; 2]],
    noise: &mut dyn FnMut() -> f64,
) -> Vec<Observation> {
    let nominal = robot.nominal();
    let mut all = Vec::new();
    for (k, p) in positions.iter().enumerate() {
        let e = robot.to_base(truth, *p);
        for (cycle, mode) in robot.reached(&nominal, robot.to_base(&nominal, *p)).into_iter().enumerate() {
            let q = robot.inverse(truth, e, mode.branches);
            if q.iter().any(|q| !q.is_finite()) {
                continue; // the true robot is a little too short
            }
            let joints = vec![q[0], q[1], robot.assembly_at(truth, q, e)];
            let measured = [p[0] + noise(), p[1] + noise(), 0.0];
            all.push(Observation {
                pose: (k as i64).into(),
                cycle: cycle as i64 + 1,
                joints,
                targets: vec![Some(measured)],
                ..Observation::default()
            });
        }
    }
    all
}

pub fn settings(u_mm: f64) -> Settings {
    Settings { standard_uncertainty_mm: Some(u_mm), ..Settings::default() }
}

/// Seven positions around the plate.
pub const SEVEN: [[f64; 2]; 7] =
    [[-25.4, 50.8], [50.8, 304.8], [177.8, 355.6], [381.0, 355.6], [533.4, 101.6], [406.4, -228.6], [101.6, -203.2]];
