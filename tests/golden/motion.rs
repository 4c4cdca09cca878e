//! The recorded motion of the sample campaign: synthetic, made here, as its README says.

use super::compare;
use etalon::base::noise::Noise;
use std::f64::consts::TAU;
use std::fmt::Write;

const FROM: [f64; 2] = [50.0, 50.0];
const CORNER: [f64; 2] = [250.0, 50.0];
const TO: [f64; 2] = [250.0, 150.0];
const LENGTH_MM: f64 = 300.0;
const SPEED_MM_S: f64 = 200.0;
const ACCELERATES_S: f64 = 0.15;
const RATE_HZ: f64 = 100.0;
const PASSES: usize = 10;

/// The commanded point at a length of the path.
fn commanded(u: f64) -> [f64; 2] {
    if u <= 200.0 { [FROM[0] + u, FROM[1]] } else { [CORNER[0], CORNER[1] + u - 200.0] }
}

/// What the robot does of it: corners rounded over 2 mm, a wave of 30 µm across.
fn attained(u: f64) -> [f64; 2] {
    let window = (-10..=10).map(|i| commanded((u + 0.1 * f64::from(i)).clamp(0.0, LENGTH_MM)));
    let mean = window.fold([0.0, 0.0], |s, p| [s[0] + p[0] / 21.0, s[1] + p[1] / 21.0]);
    let wave = 0.03 * (TAU * u / 150.0).sin();
    if u <= 200.0 { [mean[0], mean[1] + wave] } else { [mean[0] - wave, mean[1]] }
}

/// Length of the path that is driven after a time, with constant acceleration at both ends.
fn driven(t: f64) -> f64 {
    let whole = LENGTH_MM / SPEED_MM_S + ACCELERATES_S;
    let ramp = |t: f64| SPEED_MM_S * t * t / (2.0 * ACCELERATES_S);
    match t {
        t if t < ACCELERATES_S => ramp(t),
        t if t < whole - ACCELERATES_S => SPEED_MM_S * (t - 0.5 * ACCELERATES_S),
        t if t < whole => LENGTH_MM - ramp(whole - t),
        _ => LENGTH_MM,
    }
}

/// What swings after a stop: 0.15 mm at 9 Hz, dying away in 80 ms.
fn swing(t: f64) -> f64 {
    0.15 * (-t / 0.08).exp() * (TAU * 9.0 * t).sin()
}

/// Ten times: 0.7 s at the begin, the path, 0.7 s at its end, and back in an arc; drifting by 12 µm in all.
fn motion() -> String {
    let mut noise = Noise::new(9283, 0);
    let mut text = "time_s,x_mm,y_mm\n".to_owned();
    let mut sample = 0u32;
    for pass in 0..PASSES {
        let warm = 0.012 * (1.0 - (-(pass as f64) / 4.0).exp());
        let off = [(); 2].map(|()| noise.gaussian(0.006));
        let path_s = LENGTH_MM / SPEED_MM_S + ACCELERATES_S;
        let mut write = |p: [f64; 2], off: [f64; 2]| {
            let [x, y] = [0, 1].map(|k| p[k] + off[k] + noise.gaussian(0.0015));
            let _ = writeln!(text, "{:.2},{:.4},{y:.4}", f64::from(sample) / RATE_HZ, x + warm);
            sample += 1;
        };
        let ticks = |seconds: f64| (0..(seconds * RATE_HZ).round() as u32).map(|i| f64::from(i) / RATE_HZ);
        let swings = f64::from(u8::from(pass > 0));
        ticks(0.7).for_each(|t| write([FROM[0] + swings * swing(t), FROM[1]], [0.5 * off[0], 0.5 * off[1]]));
        ticks(path_s).for_each(|t| write(attained(driven(t)), off));
        ticks(0.7).for_each(|t| write([TO[0], TO[1] + swing(t)], [0.5 * off[1], 0.5 * off[0]]));
        ticks(1.2).for_each(|t| {
            let s = 0.5 - 0.5 * (0.5 * TAU * t / 1.2).cos();
            let bulge = 60.0 * (0.5 * TAU * s).sin();
            let straight = [0, 1].map(|k| TO[k] + s * (FROM[k] - TO[k]));
            write([straight[0] - 0.5 * bulge, straight[1] + bulge], off);
        });
    }
    text
}

#[test]
fn the_synthetic_motion_of_the_sample_is_what_its_readme_says() {
    let table = |header: &str, rows: &[[f64; 2]], numbered: bool| {
        let row = |(i, [x, y]): (usize, &[f64; 2])| {
            if numbered { format!("{},{x},{y}\n", i + 1) } else { format!("{x},{y}\n") }
        };
        format!("{header}\n{}", rows.iter().enumerate().map(row).collect::<String>())
    };
    compare("samples/prexyt-repeatability/exports/motion.csv", &motion());
    compare("samples/prexyt-repeatability/path.csv", &table("x_mm,y_mm", &[FROM, CORNER, TO], false));
    compare("samples/prexyt-repeatability/commanded.csv", &table("pose,x_mm,y_mm", &[FROM, TO], true));
}
