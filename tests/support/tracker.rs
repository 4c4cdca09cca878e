//! Synthetic campaigns of a six-axis arm that a laser tracker measures: three reflectors on its tool, three that stay.

use super::arms::{SIX_AXES, serial};
use super::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector};
use etalon::robots::{Quantity, Robot, Role, Serial};
use etalon::simulate::Truth;
use std::fmt::Write;

/// Standard uncertainty of a coordinate, mm.
pub const U_MM: f64 = 0.010;
const TARGETS: [&str; 3] = ["SMR_1", "SMR_2", "SMR_3"];
/// Reflectors that stay: they carry the world frame.
const FIXED: [(&str, Vector); 3] =
    [("base_1", [0.0, 0.0, 0.0]), ("base_2", [1500.0, 0.0, 0.0]), ("base_3", [400.0, 1200.0, 0.0])];

/// When the reflectors that stay are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reflectors {
    /// Three times before all poses.
    Before,
    /// At every pose.
    EachPose,
}

/// The arm, of which joints 2 and 3 may bend.
pub fn robot(bends: bool) -> Serial {
    serial(&SIX_AXES, &TARGETS, if bends { &[2, 3] } else { &[] })
}

/// Half a millimetre and two milliradians off in all that is identifiable apart from base and targets.
pub fn true_value(p: &etalon::robots::Parameter, noise: &mut Noise) -> f64 {
    let absorbed = ["alpha_1", "a_1", "theta_1", "d_1", "theta_6", "d_6"];
    match (p.role, p.quantity, p.name.as_str()) {
        (Role::Base, Quantity::Length, _) => 800.0 + noise.uniform(200.0),
        (Role::Base, ..) => noise.uniform(0.5),
        (Role::Target, ..) => 60.0 + noise.uniform(40.0),
        (.., name) if absorbed.contains(&name) => p.nominal,
        (.., name) if name.starts_with("compliance") => 1e-3,
        (_, Quantity::Ratio, _) => 1.0 + noise.uniform(2e-4),
        (_, Quantity::Length, _) => p.nominal + noise.uniform(0.5),
        (_, Quantity::Angle, _) => p.nominal + noise.uniform(2e-3),
    }
}

/// The campaign's folder with campaign, robot and truth, of `poses` poses.
pub fn campaign(reflectors: Reflectors, poses: usize, bends: bool) -> Scratch {
    let robot = robot(bends);
    let mut noise = Noise::new(61, 0);
    let mut truth = "seed = 1\ncycles = 1\ndecimals = 6\n[export_T_world]\nxyz_mm = [2400.0, -700.0, -900.0]\n\
        rpy_deg = [0.4, -0.7, 141.0]\n[parameters]\n"
        .to_owned();
    for p in robot.parameters() {
        let _ = writeln!(truth, "{} = {}", p.name, p.quantity.outward(true_value(p, &mut noise)));
    }
    for (label, at) in FIXED.iter().filter(|_| reflectors == Reflectors::Before) {
        let _ = writeln!(
            truth,
            "[[point]]\nlabel = \"{label}\"\nexport = \"exports/base.csv\"\nat_mm = {at:?}\nrepeats = 3"
        );
    }
    let _ = writeln!(truth, "[[poses]]\njoints = {:?}", (0..poses).map(|_| drawn(&mut noise)).collect::<Vec<_>>());
    let bending = if bends { "bending = [2, 3]\n" } else { "" };
    let mut arm = format!("name = \"arm\"\nmodel = \"serial\"\n{bending}");
    for [alpha, a, theta, d] in SIX_AXES {
        let _ = writeln!(arm, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}");
    }
    Scratch::with(&[("campaign.toml", &stated(reflectors, false)), ("robot.toml", &arm), ("truth.toml", &truth)])
}

/// campaign.toml; `all` has the readings of the fixed reflectors that [`complete`] writes.
fn stated(reflectors: Reflectors, all: bool) -> String {
    let label = "label = \"{target}_{pose}_{cycle}\"\n";
    let mut text = format!(
        "name = \"arm\"\nrobot = \"robot.toml\"\nsynthetic = \"drawn for a test\"\n\
         [instrument]\nname = \"tracker\"\nexpanded_uncertainty_um = {}\ncoverage_factor = 2\n\
         [log]\nfile = \"encoders.csv\"\ncolumns = {{ pose = \"pose\", cycle = \"cycle\", q1_deg = \"q1\", q2_deg = \"q2\", \
         q3_deg = \"q3\", q4_deg = \"q4\", q5_deg = \"q5\", q6_deg = \"q6\" }}\n\
         [join]\nby = [\"pose\", \"cycle\"]\ntargets = {TARGETS:?}\n\
         [frame.world]\ntargets = {:?}\n{}\n[identify]\neffects = \"all\"\ncalibration = \"all\"\n",
        2000.0 * U_MM,
        FIXED.map(|f| f.0),
        if reflectors == Reflectors::EachPose { "each = \"pose\"" } else { "" },
    );
    let mut export = |file: &str, label: &str| {
        let _ = writeln!(
            text,
            "[[export]]\nfile = \"exports/{file}\"\nunit = \"mm\"\n\
             format = {{ delimiter = \",\", decimal = \".\", columns = [\"label\", \"x\", \"y\", \"z\"] }}\n{label}"
        );
    };
    export("poses.csv", label);
    if reflectors == Reflectors::Before {
        export("base.csv", "");
    } else if all {
        export("base.csv", label);
    }
    text
}

/// Joint values of a pose, in degrees.
pub fn drawn(noise: &mut Noise) -> Vec<f64> {
    (0..6).map(|_| noise.uniform(75.0)).collect()
}

/// Adds to a simulated campaign what is measured of the fixed reflectors at each pose.
pub fn complete(scratch: &Scratch, reflectors: Reflectors, truth: &Truth) {
    if reflectors == Reflectors::Before {
        return;
    }
    let poses: usize = truth.poses.iter().map(|p| p.joints.len()).sum();
    let placed = &truth.export_T_world;
    let placement = Pose::from_xyz_rpy(placed.xyz_mm, placed.rpy_deg.map(f64::to_radians));
    let mut noise = Noise::new(truth.seed, 99);
    let mut text = String::new();
    for pose in 1..=poses {
        for (name, at) in FIXED {
            let [x, y, z] = placement.apply(at).map(|v| v + noise.gaussian(U_MM));
            let _ = writeln!(text, "{name}_{pose}_1,{x},{y},{z}");
        }
    }
    std::fs::write(scratch.path().join("exports/base.csv"), text).unwrap();
    std::fs::write(scratch.path().join("campaign.toml"), stated(reflectors, true)).unwrap();
}
