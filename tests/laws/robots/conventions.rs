//! One robot in every convention: modified and standard Denavit-Hartenberg parameters, screw axes, URDF. Identified from the same data,
//! each leaves the same errors.

use crate::support::arms::SIX_AXES;
use crate::support::root;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::noise::Noise;
use etalon::base::phrase;
use etalon::base::pose::{Pose, Vector, centroid, cross, minus, norm, unit};
use etalon::campaign::{Campaign, read_robot};
use etalon::identify::{Condition, Fixture, Kind, Observation, Orientation, Settings, identify};
use etalon::robots::{Robot, Role};
use etalon::run::pipeline;
use std::fmt::Write;

/// Distances (mm) by which `poe-moved` states other points on the screw axes; the fourth is the point that `etalon init --robot irb120` has.
const ALONG_MM: [f64; 6] = [-290.0, 50.0, -120.0, -302.0, 400.0, -72.0];

/// The six axes as robot.toml of a convention states them.
pub fn robot_toml(convention: &str, effects: &str) -> String {
    let (convention, moved) = convention.split_once('-').unwrap_or((convention, ""));
    let mut text = format!("model = \"serial\"\nconvention = \"{convention}\"\n{effects}\n");
    let mut joints = String::new();
    let mut pose = Pose::identity();
    for (i, [alpha, a, theta, d]) in SIX_AXES.into_iter().enumerate() {
        pose = pose.turn_x(alpha.to_radians()).shift(0, a).turn_z(theta.to_radians()).shift(2, d);
        let [next_alpha, next_a] = SIX_AXES.get(i + 1).map_or([0.0; 2], |next| [next[0], next[1]]);
        let _ = match convention {
            "poe" => {
                let at = pose.shift(2, if moved.is_empty() { 0.0 } else { ALONG_MM[i] });
                write!(joints, "[[joint]]\ndirection = {:?}\npoint_mm = {:?}\n", pose.axis(2), at.translation_mm)
            }
            "dh" => write!(
                joints,
                "[[joint]]\nalpha_deg = {next_alpha:?}\na_mm = {next_a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}\n"
            ),
            _ => {
                write!(joints, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}\n")
            }
        };
    }
    if convention == "poe" {
        let angles = pose.rpy_rad().map(f64::to_degrees);
        let _ = write!(text, "flange_xyz_mm = {:?}\nflange_rpy_deg = {angles:?}\n", pose.translation_mm);
    }
    text + &joints
}

/// The six axes as a URDF with joints q1 ... q6.
fn urdf() -> String {
    let mut text = "<robot name=\"arm\">\n<link name=\"l0\"/>\n".to_owned();
    let mut origin = Pose::identity();
    for (i, [alpha, a, theta, d]) in SIX_AXES.into_iter().enumerate() {
        origin = origin.turn_x(alpha.to_radians()).shift(0, a);
        let _ = writeln!(text, "<link name=\"l{}\"/>\n<joint name=\"q{}\" type=\"revolute\">", i + 1, i + 1);
        let _ = writeln!(text, "<parent link=\"l{i}\"/><child link=\"l{}\"/>\n<axis xyz=\"0 0 2\"/>", i + 1);
        let _ = writeln!(text, "{}\n</joint>", xml_origin(&origin));
        origin = Pose::identity().turn_z(theta.to_radians()).shift(2, d);
    }
    let _ = writeln!(text, "<link name=\"flange\"/>\n<joint name=\"end\" type=\"fixed\">{}", xml_origin(&origin));
    text + "<parent link=\"l6\"/><child link=\"flange\"/></joint>\n</robot>\n"
}

fn xml_origin(pose: &Pose) -> String {
    let text = |v: [f64; 3]| v.map(|v| format!("{v:?}")).join(" ");
    format!("<origin xyz=\"{}\" rpy=\"{}\"/>", text(pose.translation_mm.map(|mm| mm / 1000.0)), text(pose.rpy_rad()))
}

/// Effects, and the conventions in which they are the same: a URDF bends under its masses, the others under the directions of their links.
const CASES: [(&str, &[&str]); 2] = [
    ("bending = [2, 3]\ncoupling = [[5, 4], [6, 4], [6, 5]]", &["mdh", "dh", "poe", "poe-moved"]),
    ("coupling = [[5, 4], [6, 4], [6, 5]]", &["mdh", "urdf", "poe-moved"]),
];
pub const EFFECTS: &str = CASES[0].0;

pub fn robot(convention: &str, effects: &str) -> Box<dyn Robot> {
    let urdf_toml =
        format!("model = \"urdf\"\nfile = \"arm.urdf\"\nbase_link = \"l0\"\ntool_link = \"flange\"\n{effects}\n");
    let toml = if convention == "urdf" { urdf_toml } else { robot_toml(convention, effects) };
    let scratch = Scratch::with(&[("robot.toml", &toml), ("arm.urdf", &urdf())]);
    let robot = read_robot(&scratch.path().join("robot.toml")).unwrap();
    robot.build(&["a", "b", "c"].map(str::to_owned)).unwrap()
}

/// How far each target is from where it was measured.
fn misses(robot: &dyn Robot, values: &[f64], observations: &[Observation]) -> Vec<f64> {
    let of = |o: &Observation| {
        let seen = o.targets.iter().enumerate().filter_map(|(k, seen)| Some((k, (*seen)?)));
        seen.map(|(k, seen)| norm(minus(robot.position(values, &o.joints, k), seen))).collect::<Vec<f64>>()
    };
    observations.iter().flat_map(of).collect()
}

/// A truth, identified in every convention from noisy measurements.
#[test]
fn conventions_identify_the_same_robot() {
    for (effects, conventions) in CASES {
        let all: Vec<Box<dyn Robot>> = conventions.iter().map(|convention| robot(convention, effects)).collect();
        let mut noise = Noise::new(31, 0);
        let mut truth: Vec<f64> = all[0].nominal();
        for (value, p) in truth.iter_mut().zip(all[0].parameters()) {
            *value += match p.name.as_str() {
                "base_x" | "base_y" | "base_z" => noise.uniform(2000.0),
                "base_rx" | "base_rz" => noise.uniform(3.0),
                name if name.starts_with("base") => noise.uniform(1.2),
                name if ["a_x", "a_y", "a_z", "b_", "c_"].iter().any(|target| name.starts_with(target)) => {
                    noise.uniform(100.0)
                }
                name if name.starts_with("a_") || name.starts_with("d_") => noise.uniform(0.5),
                name if name.starts_with("gain") => noise.uniform(1e-3),
                _ => noise.uniform(2e-3),
            };
        }
        let observe = |i: usize, noise: &mut Noise| {
            let joints: Vec<f64> = [2.8, 1.3, 1.2, 2.6, 1.9, 3.0].map(|range| noise.uniform(range)).to_vec();
            let seen = |k| Some(all[0].position(&truth, &joints, k).map(|v| v + noise.gaussian(0.05)));
            let targets = (0..3).map(seen).collect();
            Observation { pose: (i as i64).into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        let observations: Vec<Observation> = (0..70).map(|i| observe(i, &mut noise)).collect();
        let settings = Settings { standard_uncertainty_mm: Some(0.05), ..Settings::default() };
        let errors = |robot: &dyn Robot| {
            let found = identify(robot, &observations, &settings).unwrap();
            (misses(robot, &found.values, &observations), found.free.len())
        };
        let expected = errors(all[0].as_ref());
        // base, targets, four for each axis, what base and targets take up of them, gains, coupling, bending
        assert_eq!(expected.1, 6 + 9 + 24 - 6 + 6 + 3 + if effects == EFFECTS { 3 } else { 0 });
        for (robot, convention) in all.iter().zip(conventions).skip(1) {
            let found = errors(robot.as_ref());
            let off = found.0.iter().zip(&expected.0).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            println!("{convention}: {} parameters, errors differ by {off:.1e} mm", found.1);
            assert_eq!(found.1, expected.1, "{convention}");
            assert!(off < 1e-9, "{convention}: {off}");
        }
    }
}

/// At nominal values all are the same robot, and its Jacobian is the derivative, whatever the orientation of the base.
#[test]
fn conventions_describe_the_same_robot() {
    let all = ["mdh", "dh", "poe", "urdf"]
        .map(|convention| robot(convention, if convention == "urdf" { "" } else { EFFECTS }));
    let mut noise = Noise::new(31, 1);
    for _ in 0..20 {
        let joints: Vec<f64> = (0..6).map(|_| noise.uniform(3.0)).collect();
        let values = |robot: &dyn Robot| {
            let mut values = robot.nominal();
            values[6..9].copy_from_slice(&[10.0, -20.0, 130.0]);
            values
        };
        let at = all.each_ref().map(|robot| robot.position(&values(robot.as_ref()), &joints, 0));
        for other in &at[1..] {
            assert!((0..3).all(|i| (other[i] - at[0][i]).abs() < 1e-9), "{at:?}");
        }
    }
    for robot in &all[1..] {
        for _ in 0..5 {
            let joints: Vec<f64> = (0..6).map(|_| noise.uniform(3.0)).collect();
            let p: Vec<f64> = robot.nominal().iter().map(|v| v + noise.uniform(0.2)).collect();
            let (n, h) = (p.len(), 1e-6);
            let mut exact = vec![0.0; 9 * n];
            robot.jacobian(&p, &joints, &mut exact);
            for j in 0..n {
                let moved = |by: f64| {
                    let (mut p, mut out) = (p.clone(), [0.0; 9]);
                    p[j] += by;
                    robot.positions(&p, &joints, &mut out);
                    out
                };
                let (plus, minus) = (moved(h), moved(-h));
                for i in 0..9 {
                    let numeric = (plus[i] - minus[i]) / (2.0 * h);
                    assert!((exact[i * n + j] - numeric).abs() < 1e-5, "{} {i}", robot.parameters()[j].name);
                }
            }
        }
    }
}

/// The base may be in any orientation where its angles are a rotation vector.
#[test]
fn an_upright_base_is_not_singular_in_other_conventions() {
    for convention in ["dh", "poe", "urdf"] {
        let robot = robot(convention, "");
        for (trial, upright) in
            [[0.0, std::f64::consts::FRAC_PI_2, 0.0], [0.0, 0.0, std::f64::consts::PI]].into_iter().enumerate()
        {
            let mut noise = Noise::new(32, trial as u64);
            let mut truth = robot.nominal();
            truth[3..6].copy_from_slice(&upright);
            (6..15).for_each(|i| truth[i] = noise.uniform(100.0));
            let observe = |i: i64| {
                let joints: Vec<f64> = (0..6).map(|_| noise.uniform(2.0)).collect();
                let targets = (0..3).map(|k| Some(robot.position(&truth, &joints, k))).collect();
                Observation { pose: i.into(), cycle: 1, joints, targets, ..Observation::default() }
            };
            let observations: Vec<Observation> = (0..40).map(observe).collect();
            let settings = Settings { standard_uncertainty_mm: Some(0.01), ..Settings::default() };
            let found = identify(robot.as_ref(), &observations, &settings).unwrap();
            let off = misses(robot.as_ref(), &found.values, &observations).into_iter().fold(0.0, f64::max);
            assert!(off < 1e-8, "{convention}: {off}");
        }
    }
}

/// ABB IRB 120 with a FARO tracker (real data).
#[test]
fn conventions_leave_the_same_errors_on_a_real_arm() {
    if crate::reference_data("robots/irb120_faro_ets").is_none() {
        return;
    }
    for (effects, conventions) in CASES {
        let mut expected: Option<[f64; 6]> = None;
        for &convention in conventions {
            let scratch = copy_sample("abb-irb120");
            // tolerances differ between conventions
            scratch.replace("campaign.toml", "[identify]", "[identify]\nprior = \"none\"");
            let file = "$ETALON_REFERENCE/robots/irb120_faro_ets/irb120_model.urdf";
            let toml = match convention {
                "urdf" => {
                    (1..=6).for_each(|i| {
                        scratch.replace("campaign.toml", &format!("q{i}_deg"), &format!("joint_{i}_deg"))
                    });
                    format!(
                        "model = \"urdf\"\nfile = \"{file}\"\nbase_link = \"base_link\"\ntool_link = \"tool0\"\n{effects}\n"
                    )
                }
                _ => robot_toml(convention, effects),
            };
            std::fs::write(scratch.path().join("robot.toml"), toml).unwrap();
            let found = pipeline::evaluate(&Campaign::read(&scratch.path()).expect("campaign")).expect("evaluated");
            let set = &found.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0];
            let (before, after) = (set.before, set.after);
            let errors = [before.mean, before.rms, before.max, after.mean, after.rms, after.max];
            println!("{convention}: {errors:?}");
            let expected = expected.get_or_insert(errors);
            let off = errors.iter().zip(expected).map(|(a, b)| (a - *b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9, "{convention}: {off:e} mm");
        }
    }
}

#[test]
fn metres_of_a_urdf_joint_read_as_millimetres_are_named() {
    let scratch = copy_sample("column-arm");
    scratch.replace("campaign.toml", "lift_m = ", "lift_mm = ");
    let problems =
        pipeline::evaluate(&Campaign::read(&scratch.path()).expect("campaign")).err().expect("refused").to_string();
    assert!(problems.contains(&phrase!("slip-unit", quantity = "`lift`", slip = "m-mm").to_string()), "{problems}");
}

/// The three reflectors as one pose: position of their centre and orientation of their frame.
fn as_pose(o: &Observation) -> Option<(Pose, [Vector; 3])> {
    let [a, b, c] = [o.targets[0]?, o.targets[1]?, o.targets[2]?];
    let x = unit(minus(b, a))?;
    let z = unit(cross(x, minus(c, a)))?;
    let y = cross(z, x);
    let rotation = [0, 1, 2].map(|i| [x[i], y[i], z[i]]);
    let pose = Pose { rotation, translation_mm: centroid(&[a, b, c])? };
    Some((pose, [a, b, c].map(|p| pose.inverse().apply(p))))
}

/// Its three reflectors as one pose identify the same robot as the three points do: the same parameters within their uncertainties and the
/// same errors at poses that were left out.
#[test]
fn three_reflectors_as_one_pose() {
    if crate::reference_data("robots/irb120_faro_ets").is_none() {
        return;
    }
    let scratch = copy_sample("abb-irb120");
    let outcome = pipeline::run(&Campaign::read(&scratch.path()).unwrap()).unwrap();
    let found = outcome.solution.unwrap();
    let sample = root().join("samples/abb-irb120/robot.toml");
    let file = read_robot(&sample).unwrap();
    let by_points = file.build(&["SMR_1", "SMR_2", "SMR_3"].map(str::to_owned)).unwrap();
    let mut robot = file.build(&["probe".to_owned()]).unwrap();
    let mounting = Fixture::Mounting("probe").add_to(robot.as_mut());
    let whole: Vec<(&Observation, Pose, [Vector; 3])> =
        found.sets.calibration.iter().filter_map(|o| as_pose(o).map(|(pose, places)| (o, pose, places))).collect();
    let places = [0, 1, 2].map(|k| centroid(&whole.iter().map(|w| w.2[k]).collect::<Vec<_>>()).unwrap());
    // weights of the mean of three points, and of a turn that moves them
    let u_mm = 0.013 / 3.0;
    let levers = places.iter().map(|p| norm(*p).powi(2)).sum::<f64>();
    let u_rad = u_mm / (levers * 2.0 / 3.0).sqrt();
    let mut settings = Settings { standard_uncertainty_mm: Some(u_mm / 3f64.sqrt()), ..Settings::default() };
    let mut observations = Vec::new();
    for (o, pose, _) in &whole {
        let targets = vec![Some(pose.translation_mm)];
        observations.push(Observation { targets, covariances_mm2: Vec::new(), ..(*o).clone() });
        let kind = Kind::Orientation(Orientation {
            frame_T_body: Pose { translation_mm: [0.0; 3], ..*pose },
            station: None,
            mounting,
        });
        let (pose, cycle, joints) = (o.pose, o.cycle, o.joints.clone());
        settings.conditions.push(Condition { pose, cycle, joints, target: 0, kind, standard_uncertainty: u_rad });
    }
    let other = identify(robot.as_ref(), &observations, &settings).unwrap();
    let (mut worst, mut compared) = (0.0f64, 0);
    for &i in &found.found.free {
        let p = &by_points.parameters()[i];
        let Some(j) = robot.index(&p.name).filter(|_| p.role == Role::Robot) else { continue };
        let u = found.found.standard_uncertainty(i).unwrap().hypot(other.standard_uncertainty(j).unwrap());
        let ratio = (found.found.values[i] - other.values[j]).abs() / u;
        println!("{}: {ratio:.2} u", p.name);
        (worst, compared) = (worst.max(ratio), compared + 1);
    }
    let [probe, turn] = [robot.free_base().unwrap().target_place(0), mounting].map(|first| {
        let value = |i: usize| other.values[first + i];
        [value(0), value(1), value(2)]
    });
    let on_flange = Pose { translation_mm: probe, ..Pose::from_rotation_vector(turn) };
    let mut misses = Vec::new();
    for o in &found.sets.validation {
        let flange = robot.free_base().unwrap().flange(&other.values, &o.joints, 0).then(&on_flange);
        let seen = o.targets.iter().zip(&places).filter_map(|(seen, place)| Some((seen.as_ref()?, place)));
        misses.extend(seen.map(|(seen, place)| norm(minus(*seen, flange.apply(*place)))));
    }
    let mean = misses.iter().sum::<f64>() / misses.len() as f64;
    let by_points_mm = outcome.results.identified.unwrap().accuracy.sets[1].errors[0].after.mean;
    println!(
        "{compared} parameters within {worst:.2} u; mean of {} test errors {mean:.4}, {:.4} mm",
        misses.len(),
        by_points_mm
    );
    assert!(compared == 30 && misses.len() == 882);
    assert!(worst < 2.0, "{worst}");
    assert!((mean / by_points_mm - 1.0).abs() < 0.02, "{mean} {by_points_mm}");
}
