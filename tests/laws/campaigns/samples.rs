//! Samples of every kind of observation: made again byte for byte, explained by what is stated, and the truth itself where there is no noise.

use crate::support::scratch::{Scratch, copy_sample, ends};
use etalon::simulate::Truth;

const SAMPLES: [&str; 12] = [
    "draw-wire",
    "elastic-arm",
    "linear-delta",
    "payload-arm",
    "probe-poses",
    "second-encoders",
    "surfaces",
    "torque-arm",
    "turntable",
    "two-arms",
    "two-hands",
    "warming-arm",
];

#[test]
fn samples_of_observations_are_made_again_and_explained() {
    for name in SAMPLES {
        let scratch = copy_sample(name);
        let read = |file: &str| std::fs::read_to_string(scratch.path().join(file)).unwrap();
        let before = read("observations.csv");
        ends(&scratch, "simulate", 0, &[]);
        assert!(read("observations.csv") == before, "{name}: another table than that of the sample");
        assert!(read("campaign.toml").lines().count() <= 40, "{name}");
        ends(&scratch, "run", 0, &[]);
        let residuals = scratch.parameters().residuals;
        let (chi_square, degrees) = (residuals.test.chi_square.unwrap(), residuals.degrees_of_freedom as f64);
        println!("{name}: chi-square {chi_square:.1} of {degrees} degrees of freedom");
        // three standard deviations of chi-square
        assert!((chi_square - degrees).abs() < 3.0 * (2.0 * degrees).sqrt(), "{name}: {chi_square} of {degrees}");
    }
}

/// Changes of a sample before its table is made without noise.
type Change = fn(&Scratch);

/// What the samples leave out: other forms of an orientation, known places and radii of fixed things.
const CHANGES: [(&str, Change); 4] = [
    ("probe-poses", |scratch| {
        let angles = "file = \"observations.csv\"\norientation = \"fixed xyz\"";
        scratch.replace("campaign.toml", "file = \"observations.csv\"", angles);
    }),
    ("probe-poses", |scratch| {
        let vector = "file = \"observations.csv\"\ntarget = \"probe\"\npose = \"row\"\n\
                      columns = { rx_rad = \"A\", ry_rad = \"B\", rz_rad = \"C\", q1_rad = \"J1\", x_um = \"X\" }";
        scratch.replace("campaign.toml", "file = \"observations.csv\"", vector);
    }),
    ("surfaces", |scratch| {
        let known = "[[known]]\nkind = \"sphere\"\ntarget = \"dome\"\nu_um = 3\n\n\
                     [[known]]\nkind = \"point\"\ntarget = \"dome\"\nu_um = 3\n\n[[poses]]";
        scratch.replace("truth.toml", "[[poses]]", known);
    }),
    ("two-arms", |scratch| {
        // two rounds, each with its own contacts
        scratch.replace("truth.toml", "cycles = 1", "cycles = 2");
    }),
];

/// Largest error of an identified parameter, in mm, deg or without unit, of a table without noise.
fn largest_error(name: &str, change: Change) -> (f64, String) {
    let scratch = copy_sample(name);
    change(&scratch);
    // without noise and nominal values the stated uncertainty leaves single parameters open
    let campaign = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let bounded = format!("uncertainty_bound = \"1000 mm, 100 deg\"\n{campaign}");
    std::fs::write(scratch.path().join("campaign.toml"), bounded).unwrap();
    let decimals = std::fs::read_to_string(scratch.path().join("truth.toml")).unwrap();
    let stated = decimals.lines().find(|line| line.starts_with("decimals")).unwrap();
    scratch.replace("campaign.toml", "[identify]", "[identify]\nprior = \"none\"");
    scratch.replace("truth.toml", stated, "decimals = 13\nnoise_um = 0");
    // friction is the noise of torques
    if let Some(friction) = decimals.lines().find(|line| line.starts_with("friction_nm")) {
        scratch.replace("truth.toml", friction, "friction_nm = 0");
    }
    ends(&scratch, "simulate", 0, &[]);
    ends(&scratch, "run", 0, &[]);
    let truth = Truth::read(&scratch.path().join("truth.toml")).unwrap().parameters;
    let found = scratch.parameters().parameters;
    let apart = found.iter().map(|p| ((p.value - truth.get(&p.name).unwrap_or(&p.nominal)).abs(), p.name.clone()));
    apart.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

#[test]
fn samples_of_observations_without_noise_give_their_truth() {
    let as_they_are = SAMPLES.map(|name| (name, (|_| {}) as Change));
    for (name, change) in as_they_are.into_iter().chain(CHANGES) {
        let (apart, parameter) = largest_error(name, change);
        println!("{name}: {apart:.1e} ({parameter})");
        assert!(apart < 1e-9, "{name}: {apart} of {parameter}");
    }
}
