//! The test of poses of the sample campaign: synthetic, made here, as its README says.

use super::compare;
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use etalon::standards::iso9283::pose::rotations::RotationOrder;
use std::fmt::Write;

type Vector = [f64; 3];

/// P1 to P5 on the diagonal plane of a cube of 250 mm.
const COMMANDED_MM: [Vector; 5] =
    [[400.0, 0.0, 350.0], [500.0, 100.0, 450.0], [300.0, 100.0, 450.0], [300.0, -100.0, 250.0], [500.0, -100.0, 250.0]];
const COMMANDED_DEG: Vector = [5.0, -20.0, 30.0];
/// How far each pose is off, and how it scatters, in x, y and z.
const OFF_MM: [Vector; 5] =
    [[0.11, -0.06, 0.09], [0.17, 0.03, 0.14], [0.06, -0.13, 0.12], [0.21, -0.10, 0.05], [0.24, 0.08, 0.17]];
const SCATTER_MM: [Vector; 5] =
    [[0.008, 0.009, 0.006], [0.012, 0.010, 0.008], [0.010, 0.012, 0.009], [0.009, 0.009, 0.012], [0.016, 0.014, 0.011]];
const OFF_DEG: Vector = [0.012, -0.020, 0.031];
const SCATTER_DEG: f64 = 0.004;
const READING_MM: f64 = 0.003;
const READING_DEG: f64 = 0.001;
const CYCLES: i64 = 30;
const NESTS_MM: [Vector; 4] =
    [[900.0, 0.0, -600.0], [0.0, 900.0, -600.0], [-700.0, -400.0, -600.0], [300.0, -800.0, -300.0]];

/// How the tracker stands in a cycle: it sinks and turns a little after cycles 10 and 20.
fn moved(cycle: i64) -> Pose {
    let share = f64::from(u8::from(cycle > 10)) + 0.6 * f64::from(u8::from(cycle > 20));
    Pose::from_xyz_rpy([0.021, -0.013, 0.017].map(|v| v * share), [2e-5, -1e-5, 3e-5].map(|v| v * share))
}

/// The robot gets warm: up to 60 µm, mostly upwards.
fn warm_mm(cycle: i64) -> Vector {
    let share = 1.0 - (-(cycle as f64 - 1.0) / 8.0).exp();
    [0.018 * share, 0.0, 0.057 * share]
}

fn poses() -> String {
    let mut noise = Noise::new(9283, 1);
    let order = RotationOrder::parse("Rz(c) Ry(b) Rx(a)").unwrap();
    let mut text = "pose,cycle,reading,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n".to_owned();
    for cycle in 1..=CYCLES {
        for (p, commanded) in COMMANDED_MM.iter().enumerate() {
            let warm = warm_mm(cycle);
            let at = [0, 1, 2].map(|k| commanded[k] + OFF_MM[p][k] + warm[k] + noise.gaussian(SCATTER_MM[p][k]));
            let turned = [0, 1, 2].map(|k| COMMANDED_DEG[k] + OFF_DEG[k] + noise.gaussian(SCATTER_DEG));
            let stands = Pose { translation_mm: at, ..order.pose(turned.map(f64::to_radians)) };
            let seen = moved(cycle).then(&stands);
            let angles = order.angles_rad(&seen, turned.map(f64::to_radians)).map(f64::to_degrees);
            for reading in 1..=2 {
                let [x, y, z] = seen.translation_mm.map(|v| v + noise.gaussian(READING_MM));
                let [a, b, c] = angles.map(|v| v + noise.gaussian(READING_DEG));
                let _ = writeln!(text, "{},{cycle},{reading},{x:.4},{y:.4},{z:.4},{a:.4},{b:.4},{c:.4}", p + 1);
            }
        }
    }
    text
}

fn commanded() -> String {
    let [a, b, c] = COMMANDED_DEG;
    let row = |(i, [x, y, z]): (usize, &Vector)| format!("{},{x},{y},{z},{a},{b},{c}\n", i + 1);
    "pose,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n".to_owned() + &COMMANDED_MM.iter().enumerate().map(row).collect::<String>()
}

fn reference() -> String {
    let mut noise = Noise::new(9283, 2);
    let mut text = "cycle,target,x_mm,y_mm,z_mm\n".to_owned();
    for cycle in [1, 11, 21] {
        for (i, nest) in NESTS_MM.iter().enumerate() {
            let [x, y, z] = moved(cycle).apply(*nest).map(|v| v + noise.gaussian(0.002));
            let _ = writeln!(text, "{cycle},N{},{x:.4},{y:.4},{z:.4}", i + 1);
        }
    }
    text
}

/// Three times in each direction, in steps of 10 % up to 30 N: 1.8, 2.3 and 3.1 µm/N, and 2 µm of noise.
fn loads() -> String {
    let mut noise = Noise::new(9283, 3);
    let mut text = "direction,cycle,force_n,x_mm,y_mm,z_mm\n".to_owned();
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        for (sign, way) in [("+", 1.0), ("-", -1.0)] {
            for cycle in 1..=3 {
                for force in (0..=10).map(|i| 3 * i) {
                    let mut at = COMMANDED_MM[0];
                    at[axis] += way * [0.0018, 0.0023, 0.0031][axis] * f64::from(force);
                    let [x, y, z] = at.map(|v| v + noise.gaussian(0.002));
                    let _ = writeln!(text, "{sign}{name},{cycle},{force},{x:.4},{y:.4},{z:.4}");
                }
            }
        }
    }
    text
}

#[test]
fn the_synthetic_test_of_poses_of_the_sample_is_what_its_readme_says() {
    compare("samples/pose-test/poses.csv", &poses());
    compare("samples/pose-test/commanded.csv", &commanded());
    compare("samples/pose-test/reference.csv", &reference());
    compare("samples/pose-test/loads.csv", &loads());
}
