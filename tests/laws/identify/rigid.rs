//! The stated shape of a part that carries targets constrains them, with its uncertainty, and is named where measurements contradict it.

use crate::support::arms::{SIX_AXES, serial};
use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::base::message::Severity;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::campaign::Campaign;
use etalon::identify::{Identification, Observation, RigidPart, Settings, fit_frames, identify_from};
use etalon::robots::{Robot, Role, Serial};
use etalon::run::pipeline;

const TARGETS: [&str; 3] = ["t1", "t2", "t3"];
const PLATE_MM: [Vector; 3] = [[60.0, 10.0, 30.0], [-50.0, 70.0, 25.0], [-40.0, -80.0, 45.0]];
const POSES: usize = 60;
/// Standard uncertainties of a measured coordinate, and of one of the plate.
const U_MM: f64 = 0.01;
const PLATE_U_MM: f64 = 0.002;

struct Bench {
    robot: Serial,
    truth: Vec<f64>,
    observations: Vec<Observation>,
    part: RigidPart,
}

impl Bench {
    /// Poses that show one target each, the third only once, of an arm that bends by `bending_rad` more than its model.
    fn new(seed: u64, bending_rad: f64) -> Self {
        let mut noise = Noise::new(19, seed);
        let robot = serial(&SIX_AXES, &TARGETS, &[]);
        let bent = serial(&SIX_AXES, &TARGETS, &[2, 3]);
        let mut values = bent.nominal();
        for (value, p) in values.iter_mut().zip(bent.parameters()) {
            match (p.role, p.name.as_str()) {
                (Role::Robot, name) if name.starts_with("compliance") => *value = bending_rad,
                // what base and targets take up is nominal
                (Role::Robot, name) if name.starts_with("gain") || name.ends_with("_1") => {}
                (Role::Robot, "theta_6" | "d_6") => {}
                (Role::Robot, name) if name.starts_with(['a', 'd']) && !name.starts_with("alpha") => {
                    *value += noise.gaussian(0.3)
                }
                (Role::Robot, _) => *value += noise.gaussian(1e-3),
                _ => {}
            }
        }
        values[..6].copy_from_slice(&[1500.0, -300.0, 200.0, 0.2, -0.1, 2.0]);
        values[6..15].copy_from_slice(PLATE_MM.as_flattened());
        let observe = |i: usize| {
            let joints: Vec<f64> = (0..6).map(|_| noise.uniform(1.2)).collect();
            let k = if i == 7 { 2 } else { i % 2 };
            let mut targets = vec![None; 3];
            targets[k] = Some(bent.position(&values, &joints, k).map(|v| v + noise.gaussian(U_MM)));
            Observation { pose: (i as i64 + 1).into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        let observations = (0..POSES).map(observe).collect();
        // as a certificate states it, in a frame of the plate's own
        let turn = Pose::identity().turn_z(0.7).turn_x(-1.1);
        let places_mm = PLATE_MM.map(|p| turn.apply(p).map(|v| v + 500.0 + noise.gaussian(PLATE_U_MM))).to_vec();
        let targets = TARGETS.map(str::to_owned).to_vec();
        let part =
            RigidPart { targets, places_mm, standard_uncertainty_mm: PLATE_U_MM, tolerance_mm: 0.5, weight: 1.0 };
        let truth = values[..robot.parameters().len()].to_vec();
        Self { robot, truth, observations, part }
    }

    fn identify(&self, rigid: Vec<RigidPart>) -> Identification {
        let settings = Settings {
            standard_uncertainty_mm: Some(U_MM),
            hold: vec!["gain_*".to_owned()],
            rigid,
            ..Settings::default()
        };
        let before = fit_frames(&self.robot, &self.observations, &settings).unwrap();
        identify_from(&self.robot, &self.observations, &settings, &before).unwrap()
    }

    /// How far distances on the plate are from the true ones, the largest of three, mm.
    fn shape_error_mm(&self, values: &[f64]) -> f64 {
        let place = |values: &[f64], k: usize| -> Vector { values[6 + 3 * k..][..3].try_into().unwrap() };
        let distance = |values: &[f64], (a, b): (usize, usize)| norm(minus(place(values, a), place(values, b)));
        let off = |pair| (distance(values, pair) - distance(&self.truth, pair)).abs();
        [(0, 1), (1, 2), (0, 2)].map(off).into_iter().fold(0.0, f64::max)
    }
}

fn contradictions(found: &Identification) -> Vec<(Severity, String)> {
    let all = found.warnings.iter().filter(|w| w.id == "rigid-part-contradicted");
    all.map(|w| (w.severity, w.what.clone())).collect()
}

#[test]
fn a_target_seen_once_has_the_place_of_its_plate() {
    let (mut squares, mut count, mut free_mm, mut plate_mm) = (0.0, 0.0, 0.0, 0.0);
    for seed in 0..15 {
        let bench = Bench::new(seed, 0.0);
        let (alone, with) = (bench.identify(vec![]), bench.identify(vec![bench.part.clone()]));
        free_mm += bench.shape_error_mm(&alone.values) / 15.0;
        plate_mm += bench.shape_error_mm(&with.values) / 15.0;
        assert_eq!(
            with.residuals.degrees_of_freedom,
            alone.residuals.degrees_of_freedom + 3,
            "a triangle is three numbers"
        );
        assert_eq!(contradictions(&with), [], "seed {seed}");
        let third = (12..15).filter_map(|i| Some((i, with.standard_uncertainty(i)?)));
        for (i, u) in third.filter(|(i, _)| alone.standard_uncertainty(*i).is_some()) {
            assert!(u < alone.standard_uncertainty(i).unwrap());
        }
        for &i in with.free.iter().filter(|_| with.uncertainty.inflation_factor == 1.0) {
            squares += ((with.values[i] - bench.truth[i]) / with.standard_uncertainty(i).unwrap()).powi(2);
            count += 1.0;
        }
    }
    let spread = f64::sqrt(squares / count);
    println!(
        "distances off by {free_mm:.4} mm without, {plate_mm:.4} mm with the plate; spread over uncertainty {spread:.3}"
    );
    assert!(plate_mm < 0.5 * free_mm && plate_mm < 3.0 * PLATE_U_MM, "{free_mm} {plate_mm}");
    assert!((spread - 1.0).abs() < 0.1, "{spread}");
}

#[test]
fn errors_of_the_robot_do_not_bend_the_plate() {
    let bench = Bench::new(1, 2e-3);
    let (alone, with) = (bench.identify(vec![]), bench.identify(vec![bench.part.clone()]));
    assert!(
        with.uncertainty.inflation_factor > 3.0 && with.weight > 3.0,
        "{} {}",
        with.uncertainty.inflation_factor,
        with.weight
    );
    let (free_mm, plate_mm) = (bench.shape_error_mm(&alone.values), bench.shape_error_mm(&with.values));
    println!("distances off by {free_mm:.4} mm without, {plate_mm:.4} mm with the plate");
    assert!(free_mm > 0.05 && plate_mm < 4.0 * PLATE_U_MM, "{free_mm} {plate_mm}");
}

#[test]
fn a_shape_that_the_identification_contradicts_is_named() {
    let named = |off_mm: f64| {
        let mut bench = Bench::new(2, 0.0);
        bench.part.places_mm[1][0] += off_mm;
        contradictions(&bench.identify(vec![bench.part.clone()]))
    };
    assert_eq!(named(0.0), []);
    for (off_mm, severity) in [(0.2, Severity::Warning), (2.0, Severity::Error)] {
        let found = named(off_mm);
        assert!(
            matches!(&found[..], [(s, what)] if *s == severity && what.contains("`t1` to `t2`")),
            "{off_mm}: {found:?}"
        );
    }
}

/// The balls of the sample PreXYT are 146.021 mm apart.
fn plate(distance_mm: f64, more: &str) -> String {
    format!(
        "[[rigid]]\ntargets = [\"K\", \"L\"]\ntolerance_mm = 0.1\nplaces_mm = {{ K = [0, 0, 0], L = [{distance_mm:?}, 0, 0] }}\n\
         {more}\n\n[log]"
    )
}

#[test]
fn balls_of_a_plate_are_as_far_apart_as_it_states() {
    let u = "expanded_uncertainty_um = 1\ncoverage_factor = 2";
    let run = |rigid: &str| {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", "[log]", rigid);
        pipeline::run(&Campaign::read(&scratch.path()).unwrap()).map(|outcome| {
            let messages =
                outcome.results.messages().map(|m| m.what.clone()).filter(|m| m.contains("[[rigid]]")).collect();
            let found = outcome.results.identified.unwrap().parameters.parameters;
            let l_kl = found.into_iter().find(|p| p.name == "l_kl").unwrap();
            (l_kl.standard_uncertainty.unwrap(), l_kl.value, messages)
        })
    };
    let (u_alone, _, _): (f64, f64, Vec<String>) = run("[log]").unwrap();
    let (u_with, value, messages) = run(&plate(146.021, u)).unwrap();
    assert_eq!(messages, Vec::<String>::new());
    assert!(u_with < u_alone && u_with < 0.71e-3 && (value - 146.021).abs() < 2e-3, "{u_alone} {u_with} {value}");
    // one measured distance of eight poses and 51, five times: a hundredth of a millimetre is beyond both
    let (_, _, messages) = run(&plate(146.031, u)).unwrap();
    assert!(messages.iter().any(|m| m.contains("is 146.02") && m.contains("146.0310 mm stated")), "{messages:?}");
    let problems = run(&plate(5.749, u)).unwrap_err().to_string();
    assert!(problems.contains("[rigid-part-contradicted]") && problems.contains("5.7490"), "{problems}");
}

#[test]
fn a_shape_is_stated_whole() {
    for (rigid, expected) in [
        (plate(146.0, ""), "`places_mm` needs `expanded_uncertainty_um`"),
        (plate(146.0, "expanded_uncertainty_um = 2"), "`places_mm` needs `coverage_factor`"),
        (
            plate(146.0, "expanded_uncertainty_um = -2\ncoverage_factor = 2"),
            "`places_mm` needs `expanded_uncertainty_um`",
        ),
        (plate(146.0, "").replace(", L = ", ", M = "), "`places_mm` contains `M`"),
        (plate(146.0, "").replace("K = [0, 0, 0], ", ""), "[rigid-place-missing] target=K"),
        (
            "[[rigid]]\ntargets = [\"K\", \"L\"]\ntolerance_mm = 0.1\ncoverage_factor = 2\n[log]".to_owned(),
            "error[rigid-uncertainty-without-places]",
        ),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", "[log]", &rigid);
        let problems = pipeline::run(&Campaign::read(&scratch.path()).unwrap()).unwrap_err().to_string();
        assert!(problems.says(expected), "{rigid}: {problems}");
    }
}
