//! Slips in the columns of the load: named where the data decide, and none on sound data of unusual build. Everything is drawn
//! (synthetic); `ETALON_CAMPAIGNS` states how many.

use crate::identify::drawn::number;
use crate::support::root;
use etalon::base::noise::Noise;
use etalon::base::pose::Vector;
use etalon::campaign::read_robot;
use etalon::identify::{Effects, LoadContradiction, LoadSlip, Observation, Prior, Settings, identify, load_slips};
use etalon::robots::{Effect, Quantity, Robot, Role};
use rayon::prelude::*;

const NOISE_MM: f64 = 0.02;

/// An arm under loads.
#[derive(Clone, Copy, Debug)]
struct Build {
    /// Angle under 100 N·m (deg) of both joints.
    compliance_deg: f64,
    /// Largest mass (kg) and centre of mass (mm) of the heaviest load.
    mass_kg: f64,
    at_mm: Vector,
    /// Error of joints 2 and 4 (rad) that the model leaves out.
    wave_rad: f64,
    /// Whether the uncertainty of readings is stated.
    stated: bool,
    /// Error of one reading (mm).
    blunder_mm: f64,
}

const USUAL: Build = Build {
    compliance_deg: 0.12,
    mass_kg: 5.0,
    at_mm: [20.0, -15.0, 120.0],
    wave_rad: 0.0,
    stated: true,
    blunder_mm: 0.0,
};

fn robot() -> Box<dyn Robot> {
    let path = root().join("samples/payload-arm/robot.toml");
    read_robot(&path).unwrap().build(&["SMR".to_owned()]).unwrap()
}

fn observed(robot: &dyn Robot, build: &Build, noise: &mut Noise) -> Vec<Observation> {
    let value = |p: &etalon::robots::Parameter, noise: &mut Noise| match (p.role, p.quantity) {
        (Role::Base, Quantity::Length) => noise.uniform(1500.0),
        (Role::Base, _) => noise.uniform(1.0),
        (Role::Target, _) => noise.uniform(90.0),
        _ if p.effect == Effect::Payload => build.compliance_deg.to_radians(),
        (_, Quantity::Length) => p.nominal + noise.uniform(0.3),
        (_, Quantity::Angle) => p.nominal + noise.uniform(1e-3),
        (_, Quantity::Ratio) => p.nominal,
    };
    let truth: Vec<f64> = robot.parameters().iter().map(|p| value(p, noise)).collect();
    let phase = noise.uniform(3.0);
    let observe = |pose: i64| {
        let mut joints: Vec<f64> = [2.8, 1.0, 1.0, 2.6, 1.9, 3.0].map(|half| noise.uniform(half)).to_vec();
        // a third of the poses each without load, with half of it, and with all of it
        let share = (pose % 3) as f64 / 2.0;
        joints.push(build.mass_kg * share);
        joints.extend(build.at_mm.map(|v| v * share));
        let mut bent = joints.clone();
        bent[1] += build.wave_rad * (joints[1] + phase).sin();
        bent[3] += build.wave_rad * (2.0 * joints[3] + phase).cos();
        let off = if pose == 17 { build.blunder_mm } else { 0.0 };
        let at = robot.position(&truth, &bent, 0).map(|v| v + noise.gaussian(NOISE_MM) + off);
        Observation { pose: pose.into(), cycle: 1, joints, targets: vec![Some(at)], ..Observation::default() }
    };
    (1..=60).map(observe).collect()
}

/// Answer for a drawn campaign whose centres of mass are stated after `slip`.
fn judged(build: &Build, slip: impl Fn(Vector) -> Vector, seed: u64) -> Option<LoadContradiction> {
    let (robot, mut noise) = (robot(), Noise::new(452, seed));
    let mut observations = observed(robot.as_ref(), build, &mut noise);
    for o in &mut observations {
        let at = slip([o.joints[7], o.joints[8], o.joints[9]]);
        o.joints[7..10].copy_from_slice(&at);
    }
    let settings = Settings {
        standard_uncertainty_mm: build.stated.then_some(NOISE_MM),
        prior: Prior::TOLERANCES,
        effects: Effects::These(vec![Effect::Zeros, Effect::Geometry, Effect::Payload]),
        ..Settings::default()
    };
    let found = identify(robot.as_ref(), &observations, &settings).expect("identified");
    load_slips(robot.as_ref(), &observations, &settings, &found).expect("judged")
}

fn rate(build: &Build, slip: impl Fn(Vector) -> Vector + Sync, expected: Option<LoadSlip>) -> (usize, usize) {
    let count = number("ETALON_CAMPAIGNS", 40);
    let found: Vec<_> = (0..count).into_par_iter().filter_map(|seed| judged(build, &slip, seed)).collect();
    let right = found.iter().filter(|f| expected.is_some_and(|slip| f.slips.contains(&slip))).count();
    println!("{expected:?} {build:?}: {} named, {right} right, of {count}", found.len());
    (found.len(), right)
}

#[test]
fn slips_of_loads_are_named_where_the_data_decide() {
    let count = number("ETALON_CAMPAIGNS", 40);
    for (slip, of) in [
        (LoadSlip::Exchanged([0, 2]), (|[x, y, z]| [z, y, x]) as fn(Vector) -> Vector),
        (LoadSlip::Exchanged([1, 2]), |[x, y, z]| [x, z, y]),
        (LoadSlip::Sign(2), |[x, y, z]| [x, y, -z]),
        (LoadSlip::Unit(1000.0), |at| at.map(|v| v / 1000.0)),
    ] {
        for stated in [true, false] {
            let (named, right) = rate(&Build { stated, ..USUAL }, of, Some(slip));
            assert!(named == right, "{slip:?} {named} {right}");
            // other changes hardly move the readings of this build
            let decides = matches!(slip, LoadSlip::Exchanged([0, 2]) | LoadSlip::Sign(2));
            assert!(!decides || 4 * right >= 3 * count as usize, "{slip:?} {right} of {count}");
        }
        // joints that hardly bend, and a light load: nothing decides
        let (named, right) = rate(&Build { compliance_deg: 0.005, ..USUAL }, of, Some(slip));
        assert!(named == right, "{slip:?} {named} {right}");
    }
}

#[test]
fn sound_loads_of_unusual_build_have_no_slip() {
    for build in [
        USUAL,
        Build { compliance_deg: 0.0, ..USUAL },
        Build { compliance_deg: 0.8, ..USUAL },
        Build { at_mm: [400.0, 0.0, 20.0], ..USUAL },
        Build { at_mm: [60.0, 60.0, 60.0], ..USUAL },
        Build { at_mm: [0.0, 0.0, -150.0], mass_kg: 12.0, ..USUAL },
        Build { wave_rad: 3e-4, ..USUAL },
        Build { wave_rad: 3e-4, stated: false, ..USUAL },
        Build { stated: false, ..USUAL },
        Build { blunder_mm: 1.0, ..USUAL },
        Build { blunder_mm: 1.0, stated: false, ..USUAL },
    ] {
        assert_eq!(rate(&build, |at| at, None), (0, 0), "{build:?}");
    }
    // newtons under kilograms in every row: the compliance takes them up
    assert_eq!(
        rate(&Build { mass_kg: 5.0 / 9.806_65, compliance_deg: 0.12 * 9.806_65, ..USUAL }, |at| at, None),
        (0, 0)
    );
}
