use etalon::identify::{Observation, Result, Settings, identify};
use etalon::robots::{Prexyt, Robot};

#[test]
fn a_table_in_memory_is_identified() -> Result<()> {
    let robot = Prexyt::default();
    let mut truth = robot.nominal();
    let s = robot.index("s").expect("a parameter of the PreXYT");
    truth[s] = 393.93; // mm
    let joints = [
        [0.0, 300.0, 300.0],
        [0.0, 0.0, 256.0],
        [0.0, 300.0, 44.0],
        [0.0, 0.0, 0.0],
        [170.0, 300.0, 300.0],
        [170.0, 0.0, 256.0],
        [170.0, 300.0, 44.0],
        [170.0, 0.0, 0.0],
    ];
    let observed = |(i, q): (usize, &[f64; 3])| Observation {
        pose: (i as i64).into(),
        cycle: 1,
        joints: q.to_vec(),
        targets: robot.balls(&truth, q).map(|[x, y]| Some([x, y, 0.0])).to_vec(),
        ..Observation::default()
    };
    let observations: Vec<Observation> = joints.iter().enumerate().map(observed).collect();
    let settings = Settings { standard_uncertainty_mm: Some(0.002), ..Settings::default() };
    let found = identify(&robot, &observations, &settings)?;
    assert!((found.values[s] - 393.93).abs() < 1e-9);
    Ok(())
}
