//! Chains of more than one arm's joints, and transmissions: rails, two arms, parts on positioners, harmonics, backlash.

use crate::support::arms::SIX_AXES;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, etalon};
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::campaign::read_robot;
use etalon::identify::{
    Condition, Distance, Fixture, Identification, Kind, Known, Observation, Orientation, Seen, Settings, identify,
};
use etalon::robots::{Effect, Quantity, Robot, Role};
use std::fmt::Write;
use std::process::Command;

const U_MM: f64 = 0.02;
const U_RAD: f64 = 1e-4;

fn settings() -> Settings {
    Settings { standard_uncertainty_mm: Some(U_MM), ..Settings::default() }
}

/// The six axes behind the rows `before`, as robot.toml with these keys.
fn arm_toml(keys: &str, before: &str) -> String {
    let mut text = format!("model = \"serial\"\n{keys}\n{before}\n");
    for [alpha, a, theta, d] in SIX_AXES {
        let _ = writeln!(text, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}");
    }
    text
}

fn arm(keys: &str, before: &str) -> Box<dyn Robot> {
    let scratch = Scratch::with(&[("robot.toml", &arm_toml(keys, before))]);
    read_robot(&scratch.path().join("robot.toml")).unwrap().build(&["a", "b", "c"].map(str::to_owned)).unwrap()
}

/// Parameters of an arm as it could have been built, and mounted anywhere.
fn truth(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
    let of = |p: &etalon::robots::Parameter| {
        p.nominal
            + match (p.role, p.quantity) {
                (Role::Base, Quantity::Length) => noise.uniform(1000.0),
                (Role::Base, _) => noise.uniform(0.7),
                (Role::Target, _) => noise.uniform(90.0),
                (_, Quantity::Length) => noise.uniform(0.5),
                _ => noise.uniform(2e-3),
            }
    };
    robot.parameters().iter().map(of).collect()
}

fn joints(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
    let range = |q: Quantity| if q == Quantity::Length { 900.0 } else { 2.5 };
    let values: Vec<f64> = robot.joints().iter().map(|joint| noise.uniform(range(joint.quantity))).collect();
    let directions = robot.approached().iter().map(|_| noise.uniform(1.0).signum());
    values.into_iter().chain(directions.collect::<Vec<f64>>()).collect()
}

fn observe(robot: &dyn Robot, truth: &[f64], noise: &mut Noise, poses: usize, sd_mm: f64) -> Vec<Observation> {
    let one = |i: usize| {
        let joints = joints(robot, noise);
        let seen = |k| Some(robot.position(truth, &joints, k).map(|v| v + noise.gaussian(sd_mm)));
        let targets = (0..robot.targets().len()).map(seen).collect();
        Observation { pose: (i as i64).into(), cycle: 1, joints, targets, ..Observation::default() }
    };
    (0..poses).map(one).collect()
}

/// The largest distance of targets by two sets of parameters, at poses that were not used.
fn apart_mm(robot: &dyn Robot, one: &[f64], other: &[f64], noise: &mut Noise) -> f64 {
    let at = |_| {
        let q = joints(robot, noise);
        norm(minus(robot.position(one, &q, 0), robot.position(other, &q, 0)))
    };
    (0..50).map(at).fold(0.0, f64::max)
}

/// Derivatives by parameters and by joints, against numeric ones.
fn derivatives_hold(robot: &dyn Robot, noise: &mut Noise) {
    let (values, q) = (truth(robot, noise), joints(robot, noise));
    let (n, m, rows) = (values.len(), robot.joints().len(), 3 * robot.targets().len());
    let (mut by_values, mut by_joints) = (vec![0.0; rows * n], vec![0.0; rows * m]);
    robot.jacobian(&values, &q, &mut by_values);
    robot.joint_jacobian(&values, &q, &mut by_joints);
    let numeric = |j: usize, of_joint: bool| {
        let h = if of_joint || robot.parameters()[j].quantity != Quantity::Length { 1e-6 } else { 1e-3 };
        let at = |by: f64| {
            let (mut values, mut q, mut out) = (values.clone(), q.clone(), vec![0.0; rows]);
            if of_joint {
                q[j] += by
            } else {
                values[j] += by
            };
            robot.positions(&values, &q, &mut out);
            out
        };
        at(h).iter().zip(at(-h)).map(|(a, b)| (a - b) / (2.0 * h)).collect::<Vec<f64>>()
    };
    for j in 0..n {
        for (i, expected) in numeric(j, false).into_iter().enumerate() {
            let off = (by_values[i * n + j] - expected).abs();
            assert!(off < 1e-5, "{} {i}: {expected}, off by {off}", robot.parameters()[j].name);
        }
    }
    for j in 0..m {
        for (i, expected) in numeric(j, true).into_iter().enumerate() {
            assert!((by_joints[i * m + j] - expected).abs() < 1e-5, "joint {j} {i}: {expected}");
        }
    }
}

#[test]
fn harmonics_come_back_with_intervals_that_hold() {
    comes_back("harmonics = [1, 2, 5]\ncoupling = [[5, 4]]", Effect::Harmonics, 12, "harmonic_1_sin1");
}

#[test]
fn backlash_comes_back_with_intervals_that_hold() {
    comes_back("backlash = [1, 2, 3, 4, 5, 6]", Effect::Backlash, 6, "backlash_1");
}

/// Parameters of an effect, noise-free and in the intervals of draws.
fn comes_back(keys: &str, effect: Effect, count: usize, first: &str) {
    let robot = arm(keys, "");
    let robot = robot.as_ref();
    let mut noise = Noise::new(18, 41);
    derivatives_hold(robot, &mut noise);
    let own: Vec<usize> = (0..robot.parameters().len()).filter(|&i| robot.parameters()[i].effect == effect).collect();
    assert_eq!(own.len(), count);
    assert_eq!(robot.parameters()[own[0]].name, first);
    let truth = truth(robot, &mut noise);
    let exact = observe(robot, &truth, &mut noise, 60, 0.0);
    let found = identify(robot, &exact, &settings()).unwrap();
    for &i in &own {
        let off = (found.values[i] - truth[i]).abs();
        assert!(off < 1e-9, "{}: off by {off}", robot.parameters()[i].name);
    }
    assert!(apart_mm(robot, &found.values, &truth, &mut noise) < 1e-7);
    let (mut held, mut all, mut chi) = (0, 0, 0.0);
    let draws = std::env::var("ETALON_DRAWS").map_or(360 / count as u32, |n| n.parse().unwrap());
    for _ in 0..draws {
        let noisy = observe(robot, &truth, &mut noise, 60, U_MM);
        let found = identify(robot, &noisy, &settings()).unwrap();
        chi += found.residuals.chi_square.unwrap() / found.residuals.degrees_of_freedom as f64 / f64::from(draws);
        for &i in &own {
            let u = found.standard_uncertainty(i).unwrap();
            held += usize::from((found.values[i] - truth[i]).abs() < 1.96 * u);
            all += 1;
        }
    }
    let share = held as f64 / all as f64;
    println!("{first}: {all} intervals, {:.1} % hold the truth; chi-square {chi:.3}", 100.0 * share);
    let four_sd = 4.0 * (0.95 * 0.05 / all as f64).sqrt();
    assert!((share - 0.95).abs() < four_sd && (chi - 1.0).abs() < 0.05, "{share} {chi}");
}

#[test]
fn joints_that_slide_have_no_harmonics() {
    let turning = "[[joint]]\nalpha_deg = 0.0\na_mm = 0.0\ntheta_deg = 0.0\nd_mm = 0.0\n";
    for (keys, what) in [
        ("[1]", "[joint-reference-wrong] fault=slides joint=q1"),
        ("[2, 2]", "[joint-reference-wrong] fault=twice"),
        ("[8]", "[joint-reference-wrong] fault=unknown-number joint=8"),
    ] {
        let scratch = Scratch::with(&[(
            "robot.toml",
            &format!("model = \"serial\"\nharmonics = {keys}\n{turning}prismatic = true\n{turning}"),
        )]);
        let file = read_robot(&scratch.path().join("robot.toml")).unwrap();
        let message = file.build(&["a".to_owned()]).err().unwrap().to_string();
        assert!(message.says(what) && message.contains("robot.toml:2"), "{message}");
    }
}

/// An arm on a rail, and on a turntable: external joints are the first ones of its chain.
#[test]
fn an_arm_on_a_rail_or_a_turntable_comes_back() {
    for (name, prismatic) in [("rail", "prismatic = true"), ("turntable", "")] {
        let before = format!("[[joint]]\nalpha_deg = -80.0\na_mm = 10.0\ntheta_deg = 90.0\nd_mm = 0.0\n{prismatic}\n");
        let robot = arm("", &before);
        let robot = robot.as_ref();
        let mut noise = Noise::new(18, 42);
        derivatives_hold(robot, &mut noise);
        let truth = truth(robot, &mut noise);
        let exact = observe(robot, &truth, &mut noise, 70, 0.0);
        let found = identify(robot, &exact, &settings()).unwrap();
        let apart = apart_mm(robot, &found.values, &truth, &mut noise);
        println!("{name}: {} parameters, {apart:.1e} mm apart", found.free.len());
        assert!(apart < 1e-7, "{name}: {apart}");
        let gain = robot.index("gain_1").unwrap();
        assert!((found.values[gain] - truth[gain]).abs() < 1e-9, "{name}");
    }
}

/// Two arms of four axes on one torso.
fn two_arms() -> String {
    let mut text = "<robot name=\"two\">\n<link name=\"torso\"/>\n".to_owned();
    for (side, y) in [("left", 0.2), ("right", -0.2)] {
        let mut parent = "torso".to_owned();
        let axes = [[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 1, 1]];
        for (i, [x, ay, z]) in axes.into_iter().enumerate() {
            let link = format!("{side}_{i}");
            let [dx, dy] = if i == 0 { [0.1, y] } else { [0.15, 0.02] };
            let _ = writeln!(
                text,
                "<link name=\"{link}\"/>\n<joint name=\"{side}_q{i}\" type=\"revolute\"><parent link=\"{parent}\"/>\
                 <child link=\"{link}\"/><origin xyz=\"{dx} {dy} 0.25\" rpy=\"0.1 -0.2 {y}\"/><axis xyz=\"{x} {ay} {z}\"/>\
                 <limit lower=\"-3\" upper=\"3\" effort=\"1\" velocity=\"1\"/></joint>"
            );
            parent = link;
        }
        let _ = writeln!(
            text,
            "<link name=\"{side}_hand\"/>\n<joint name=\"{side}_end\" type=\"fixed\"><parent link=\"{parent}\"/>\
             <child link=\"{side}_hand\"/><origin xyz=\"0 0.03 0.1\" rpy=\"0.3 0 0\"/></joint>"
        );
    }
    text + "</robot>\n"
}

fn of_two(base: &str, tool: &str, more: &str) -> Result<Box<dyn Robot>, String> {
    let toml =
        format!("model = \"urdf\"\nfile = \"two.urdf\"\nbase_link = \"{base}\"\ntool_link = \"{tool}\"\n{more}\n");
    let scratch = Scratch::with(&[("robot.toml", &toml), ("two.urdf", &two_arms())]);
    let file = read_robot(&scratch.path().join("robot.toml")).map_err(|e| e.to_string())?;
    file.build(&["ball".to_owned()]).map_err(|e| e.to_string())
}

/// A chain from one hand to the other is one arm undone and the other one done, with what both have of gains, harmonics and coupling.
#[test]
fn a_chain_between_two_hands_is_that_of_both_arms() {
    let both = of_two("left_hand", "right_hand", "harmonics = [2, \"right_q3\"]\ncoupling = [[1, 3]]").unwrap();
    let left =
        of_two("torso", "left_hand", "harmonics = [\"left_q2\"]\ncoupling = [[\"left_q3\", \"left_q1\"]]").unwrap();
    let right = of_two("torso", "right_hand", "harmonics = [\"right_q3\"]").unwrap();
    let names: Vec<&str> = both.joints().iter().map(|j| j.name.as_str()).collect();
    assert_eq!(&names[..5], ["left_q3", "left_q2", "left_q1", "left_q0", "right_q0"]);
    let mut noise = Noise::new(18, 43);
    derivatives_hold(both.as_ref(), &mut noise);
    let mut values = both.nominal();
    for (value, p) in values.iter_mut().zip(both.parameters()) {
        // small errors of an axis are before it on either way: errors of the left arm are zero here
        if ["gain", "harmonic", "coupling", "right", "ball"].iter().any(|start| p.name.starts_with(start)) {
            *value += noise.uniform(0.01);
        }
    }
    for _ in 0..20 {
        let q = joints(both.as_ref(), &mut noise);
        let of = |robot: &dyn Robot| {
            let value = |p: &etalon::robots::Parameter| both.index(&p.name).map_or(p.nominal, |i| values[i]);
            let values: Vec<f64> = robot.parameters().iter().map(value).collect();
            let joint = |j: &etalon::robots::Joint| q[names.iter().position(|n| *n == j.name).unwrap()];
            let joints: Vec<f64> = robot.joints().iter().map(joint).collect();
            robot.free_base().unwrap().flange(&values, &joints, 0)
        };
        let mut hand: Pose = of(left.as_ref());
        // the world of the chain is the left hand
        hand = hand.inverse().then(&of(right.as_ref()));
        let found = both.free_base().unwrap().flange(&values, &q, 0);
        assert!(norm(minus(found.translation_mm, hand.translation_mm)) < 1e-9, "{found:?} {hand:?}");
        assert!(found.inverse().then(&hand).angle_rad() < 1e-9);
    }
}

/// A ball on one hand, and its distances from three sockets on the other one, as ball bars have them: both arms come back, the torso
/// once, with no instrument.
#[test]
fn two_arms_that_hold_ball_bars_come_back() {
    let mut robot = of_two("left_hand", "right_hand", "").unwrap();
    let sockets: [Vector; 4] = [[60.0, 10.0, 20.0], [-40.0, 50.0, 15.0], [5.0, -70.0, 40.0], [10.0, 20.0, 90.0]];
    let mut noise = Noise::new(18, 44);
    let mut truth = truth(robot.as_ref(), &mut noise);
    truth[..6].fill(0.0);
    let firsts: Vec<usize> =
        ["A", "B", "C", "D"].into_iter().map(|name| Fixture::Point(name).add_to(robot.as_mut())).collect();
    sockets.iter().for_each(|place| truth.extend(place));
    let mut settings = settings();
    for i in 0..400 {
        let q = joints(robot.as_ref(), &mut noise);
        let distance_mm = norm(minus(robot.position(&truth, &q, 0), sockets[i % 4]));
        let kind = Kind::Distance(Distance { to: firsts[i % 4], distance_mm });
        settings.conditions.push(Condition {
            pose: (i as i64).into(),
            cycle: 1,
            joints: q,
            target: 0,
            kind,
            standard_uncertainty: U_MM,
        });
    }
    let found = identify(robot.as_ref(), &[], &settings).unwrap();
    let mut worst = 0.0f64;
    for _ in 0..100 {
        let q = joints(robot.as_ref(), &mut noise);
        for (place, &first) in sockets.iter().zip(&firsts) {
            let socket = [found.values[first], found.values[first + 1], found.values[first + 2]];
            let by = norm(minus(robot.position(&found.values, &q, 0), socket));
            worst = worst.max((by - norm(minus(robot.position(&truth, &q, 0), *place))).abs());
        }
    }
    println!("two arms: {} parameters, distances within {worst:.1e} mm", found.free.len());
    assert!(worst < 1e-6, "{worst}");
}

/// Points of a tracker in the room, of a chain that begins at a hand: the frame of the points would move.
#[test]
fn a_base_that_joints_move_is_named_where_positions_are_measured() {
    let robot = of_two("left_hand", "right_hand", "").unwrap();
    let mut noise = Noise::new(18, 47);
    let mut truth = truth(robot.as_ref(), &mut noise);
    truth[..6].fill(0.0);
    let names: Vec<String> = robot.joints().iter().map(|j| j.column()).collect();
    let mut table = format!("pose,cycle,target,{},x_mm,y_mm,z_mm\n", names.join(","));
    for o in observe(robot.as_ref(), &truth, &mut noise, 60, 0.0) {
        let cells = o.joints.iter().map(|q| q.to_degrees()).chain(o.targets[0].unwrap());
        let cells: Vec<String> = cells.map(|v| format!("{v:?}")).collect();
        let _ = writeln!(table, "{},1,ball,{}", o.pose, cells.join(","));
    }
    let toml = "model = \"urdf\"\nfile = \"two.urdf\"\nbase_link = \"left_hand\"\ntool_link = \"right_hand\"\n";
    let scratch = Scratch::with(&[("robot.toml", toml), ("two.urdf", &two_arms()), ("o.csv", &table)]);
    let mut etalon = Command::new(env!("CARGO_BIN_EXE_etalon"));
    etalon.args(["identify", "--robot", "robot.toml", "--observations", "o.csv", "--standard-uncertainty-um", "20"]);
    let output = etalon.current_dir(scratch.path()).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout);
    assert!(said.says("[base-moves] joints=left_q3, left_q2, left_q1, left_q0"), "{said}");
}

#[test]
fn wrong_chains_between_hands_are_refused_by_name() {
    for (base, tool, more, what) in [
        ("left_hand", "right_hnd", "", "[urdf-link-unknown] link=right_hnd"),
        ("left_hand", "torso", "", "[urdf-no-path] from=left_hand to=torso"),
        ("left_hand", "left_hand", "", "[urdf-nothing-moves] from=left_hand to=left_hand"),
        ("left_hand", "right_hand", "bending = [1]", "[bending-on-moving-base] link=left_hand"),
    ] {
        let message = of_two(base, tool, more).err().unwrap();
        assert!(message.says(what) && message.contains("robot.toml:"), "{message}");
    }
}

/// Three stations of a tracker: the world is that of the first. Common points tie them, and what the robot shows.
struct Stations {
    robot: Box<dyn Robot>,
    truth: Vec<f64>,
    noise: Noise,
    stations: [usize; 2],
    nests: [usize; 3],
}

impl Stations {
    fn new(seed: u64) -> Self {
        let mut noise = Noise::new(18, seed);
        let mut robot = arm("", "");
        let mut truth = truth(robot.as_ref(), &mut noise);
        let stations = ["T2", "T3"].map(|name| Fixture::Station(name).add_to(robot.as_mut()));
        truth.extend([900.0, -1500.0, 300.0, 0.3, -0.2, 2.9, -2000.0, 700.0, -100.0, 0.1, 1.2, -1.0]);
        let nests = ["N1", "N2", "N3"].map(|name| Fixture::Point(name).add_to(robot.as_mut()));
        truth.extend([1500.0, 0.0, 0.0, 0.0, 1400.0, 200.0, -900.0, 300.0, 900.0]);
        Self { robot, truth, noise, stations, nests }
    }

    /// A place of the world as a station has it.
    fn from(&mut self, station: usize, place: Vector, sd_mm: f64) -> Vector {
        let at = |first: usize| [0, 1, 2].map(|i| self.truth[first + i]);
        let turn = Pose::from_rotation_vector(at(station + 3));
        let seen = Pose { translation_mm: at(station), ..turn }.inverse().apply(place);
        seen.map(|v| v + self.noise.gaussian(sd_mm))
    }

    /// The first station sees `poses` poses, the second as many others, the third the points alone and one target.
    fn observed(&mut self, poses: usize, sd_mm: f64) -> (Vec<Observation>, Settings) {
        let mut noise = Noise::new(self.noise.uniform(1e6).to_bits(), 1);
        let observations = observe(self.robot.as_ref(), &self.truth, &mut noise, poses, sd_mm);
        let mut settings = settings();
        for (i, o) in observe(self.robot.as_ref(), &self.truth, &mut noise, poses, 0.0).into_iter().enumerate() {
            let station = self.stations[usize::from(i % 4 == 3)];
            for (target, place) in o.targets.iter().enumerate() {
                let kind = Kind::Seen(Seen { station, at_mm: self.from(station, place.unwrap(), sd_mm) });
                settings.conditions.push(Condition {
                    pose: (1000 + i as i64).into(),
                    cycle: 1,
                    joints: o.joints.clone(),
                    target,
                    kind,
                    standard_uncertainty: U_MM,
                });
            }
        }
        for point in self.nests {
            let place = [0, 1, 2].map(|i| self.truth[point + i]);
            let place_mm = place.map(|v| v + self.noise.gaussian(sd_mm));
            settings.known.push(Known::Place { point, place_mm, standard_uncertainty_mm: U_MM });
            for station in self.stations {
                let at_mm = self.from(station, place, sd_mm);
                settings.known.push(Known::Seen { station, point, at_mm, standard_uncertainty_mm: U_MM });
            }
        }
        (observations, settings)
    }
}

/// Intervals (95 %) of the parameters `own` hold the truth in 95 % of the draws, and chi-square is that of the noise.
fn intervals_hold(what: &str, truth: &[f64], own: &[usize], mut draw: impl FnMut() -> Identification) {
    let (mut held, mut all, mut chi) = (0, 0, 0.0);
    let draws = 30;
    for _ in 0..draws {
        let found = draw();
        chi += found.residuals.chi_square.unwrap() / found.residuals.degrees_of_freedom as f64 / f64::from(draws);
        for &i in own {
            let u = found.standard_uncertainty(i).unwrap();
            held += usize::from((found.values[i] - truth[i]).abs() < 1.96 * u);
            all += 1;
        }
    }
    let share = held as f64 / all as f64;
    println!("{what}: {all} intervals, {:.1} % hold the truth; chi-square {chi:.3}", 100.0 * share);
    assert!((share - 0.95).abs() < 0.046 && (chi - 1.0).abs() < 0.05, "{share} {chi}");
}

#[test]
fn stations_tied_by_common_points_come_back_with_intervals_that_hold() {
    let mut site = Stations::new(45);
    let (observations, settings) = site.observed(40, 0.0);
    let found = identify(site.robot.as_ref(), &observations, &settings).unwrap();
    let own: Vec<usize> = site.stations.into_iter().flat_map(|first| first..first + 6).collect();
    for &i in &own {
        let off = (found.values[i] - site.truth[i]).abs();
        assert!(off < 1e-7, "{}: off by {off}", site.robot.parameters()[i].name);
    }
    assert!(apart_mm(site.robot.as_ref(), &found.values, &site.truth, &mut site.noise) < 1e-7);
    let truth = site.truth.clone();
    intervals_hold("stations", &truth, &own, || {
        let (observations, settings) = site.observed(40, U_MM);
        identify(site.robot.as_ref(), &observations, &settings).unwrap()
    });
}

/// Poses of a probe from two stations: position and orientation tie the second to the world of the first.
struct ProbeStations {
    robot: Box<dyn Robot>,
    truth: Vec<f64>,
    noise: Noise,
    station: usize,
    mounting: usize,
}

impl ProbeStations {
    fn new(seed: u64) -> Self {
        let scratch = Scratch::with(&[("robot.toml", &arm_toml("", ""))]);
        let robot = read_robot(&scratch.path().join("robot.toml")).unwrap();
        let mut robot = robot.build(&["probe".to_owned()]).unwrap();
        let mut noise = Noise::new(19, seed);
        let mut truth = truth(robot.as_ref(), &mut noise);
        let station = Fixture::Station("T2").add_to(robot.as_mut());
        truth.extend([900.0, -1500.0, 300.0, 0.3, -0.2, 2.9]);
        let mounting = Fixture::Mounting("probe").add_to(robot.as_mut());
        truth.extend([0.4, -1.1, 2.2]);
        Self { robot, truth, noise, station, mounting }
    }

    /// Every second pose is seen from the second station; `errors` scales the noise.
    fn observed(&mut self, poses: usize, errors: f64) -> (Vec<Observation>, Settings) {
        let (mut observations, mut settings) = (Vec::new(), settings());
        let three = |truth: &[f64], first: usize| [0, 1, 2].map(|i| truth[first + i]);
        let turned = Pose::from_rotation_vector(three(&self.truth, self.station + 3));
        let station = Pose { translation_mm: three(&self.truth, self.station), ..turned }.inverse();
        let mounted = Pose::from_rotation_vector(three(&self.truth, self.mounting));
        for i in 0..poses {
            let joints = joints(self.robot.as_ref(), &mut self.noise);
            let mut off = |u: f64| [0; 3].map(|_| errors * self.noise.gaussian(u));
            let (moved, turn) = (off(U_MM), Pose::from_rotation_vector(off(U_RAD)));
            let at = minus(self.robot.position(&self.truth, &joints, 0), moved);
            let flange = self.robot.free_base().unwrap().flange(&self.truth, &joints, 0);
            let body = turn.then(&flange.then(&mounted));
            let (station, frame) = if i % 2 == 1 { (Some(self.station), station) } else { (None, Pose::identity()) };
            let in_frame = Pose { translation_mm: [0.0; 3], ..frame.then(&body) };
            let pose = (i as i64).into();
            let mut add = |kind, standard_uncertainty| {
                let joints = joints.clone();
                settings.conditions.push(Condition { pose, cycle: 1, joints, target: 0, kind, standard_uncertainty });
            };
            match station {
                Some(station) => add(Kind::Seen(Seen { station, at_mm: frame.apply(at) }), U_MM),
                None => {
                    let (joints, targets) = (joints.clone(), vec![Some(at)]);
                    observations.push(Observation { pose, cycle: 1, joints, targets, ..Observation::default() });
                }
            }
            add(Kind::Orientation(Orientation { frame_T_body: in_frame, station, mounting: self.mounting }), U_RAD);
        }
        (observations, settings)
    }
}

#[test]
fn poses_from_two_stations_come_back_with_intervals_that_hold() {
    let mut site = ProbeStations::new(47);
    // the mounting takes what errors of the last link are held: it is the truth's only up to these
    let own: Vec<usize> = (site.station..site.station + 6).collect();
    let (observations, settings) = site.observed(40, 0.0);
    let found = identify(site.robot.as_ref(), &observations, &settings).unwrap();
    for &i in &own {
        let off = (found.values[i] - site.truth[i]).abs();
        assert!(off < 1e-7, "{}: off by {off}", site.robot.parameters()[i].name);
    }
    let truth = site.truth.clone();
    intervals_hold("poses of stations", &truth, &own, || {
        let (observations, settings) = site.observed(40, 1.0);
        identify(site.robot.as_ref(), &observations, &settings).unwrap()
    });
}

/// The same by a table with a column `station`: the program finds what the library finds, and refuses what it cannot weigh.
#[test]
fn a_table_with_stations_identifies_and_slips_are_named() {
    let mut site = Stations::new(46);
    let (observations, settings) = site.observed(30, U_MM);
    let found = identify(site.robot.as_ref(), &observations, &settings).unwrap();
    let cells = |values: &[f64]| values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(",");
    let degrees = |q: &[f64]| cells(&q.iter().map(|q| q.to_degrees()).collect::<Vec<_>>());
    let mut table =
        "kind,station,pose,cycle,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    let name = |station: usize| if station == site.stations[0] { "T2" } else { "T3" };
    for o in &observations {
        for (k, at) in o.targets.iter().enumerate() {
            let target = &site.robot.targets()[k];
            let _ = writeln!(table, "point,T1,{},1,{target},{},{}", o.pose, degrees(&o.joints), cells(&at.unwrap()));
        }
    }
    for c in &settings.conditions {
        let Kind::Seen(Seen { station, at_mm }) = c.kind else { panic!() };
        let (target, station) = (&site.robot.targets()[c.target], name(station));
        let _ = writeln!(table, "point,{station},{},1,{target},{},{}", c.pose, degrees(&c.joints), cells(&at_mm));
    }
    for known in &settings.known {
        let (station, point, at) = match *known {
            Known::Place { point, place_mm, .. } => ("T1", point, place_mm),
            Known::Seen { station, point, at_mm, .. } => (name(station), point, at_mm),
            _ => panic!(),
        };
        let point = &site.robot.parameters()[point].name[..2];
        let _ = writeln!(table, "point,{station},,,{point},,,,,,,{}", cells(&at));
    }
    let run = |table: &str| {
        let scratch = Scratch::with(&[("robot.toml", &arm_toml("", "")), ("observations.csv", table)]);
        let command = ["identify", "--robot", "robot.toml", "--observations", "observations.csv"];
        let mut etalon = Command::new(env!("CARGO_BIN_EXE_etalon"));
        etalon.args(command).args(["--standard-uncertainty-um", "20", "--effects", "all", "--prior", "none", "--json"]);
        etalon.current_dir(scratch.path());
        etalon.output().unwrap()
    };
    let output = run(&table);
    let text = String::from_utf8_lossy(&output.stdout);
    let document: serde_json::Value = serde_json::from_str(&text).unwrap_or_else(|e| panic!("{e} {output:?}"));
    for name in ["T2_x", "T2_rz", "T3_ry", "T3_z", "N2_y", "a_3", "base_rx"] {
        let i = site.robot.index(name).unwrap();
        let p = document["parameters"].as_array().unwrap().iter().find(|p| p["name"] == name).unwrap();
        let quantity = site.robot.parameters()[i].quantity;
        let off = p["value"].as_f64().unwrap() - quantity.outward(found.values[i]);
        assert!(off.abs() < 1e-6 * quantity.outward(found.standard_uncertainty(i).unwrap()), "{name}: {off}");
    }
    for (from, to, what) in [
        ("point,T2", "plane,T2", "[station-row-unsupported] fault=kind kind=plane station=T2"),
        ("point,T2", "point,a", "[fixed-point-on-robot] name=a"),
    ] {
        let output = run(&table.replacen(from, to, 1));
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && message.says(what), "{to}: {message}");
    }
}

#[test]
fn directions_of_approach_with_the_other_sign_are_warned_of() {
    let scratch = copy_sample("rail-arm");
    let (code, said) = etalon(&scratch, "run");
    assert!(code == Some(0) && !said.contains("warning[backlash-negative]"), "{said}");
    // the directions as the log's order gives them, and the other sign
    let log = scratch.path().join("encoders.csv");
    let text = std::fs::read_to_string(&log).unwrap();
    let joints = |line: &str| -> Vec<f64> { line.split(',').skip(3).take(3).map(|q| q.parse().unwrap()).collect() };
    let mut before: Option<Vec<f64>> = None;
    let mut exchanged = String::new();
    for line in text.lines() {
        if line.starts_with("cycle") {
            let _ = writeln!(exchanged, "{line},D2,D3,D4");
            continue;
        }
        let q = joints(line);
        let came = |k: usize| before.as_ref().is_none_or(|before| q[k] < before[k]);
        let signs = [0, 1, 2].map(|k| if came(k) { "1" } else { "-1" });
        let _ = writeln!(exchanged, "{line},{}", signs.join(","));
        before = Some(q);
    }
    std::fs::write(&log, exchanged).unwrap();
    scratch.replace(
        "campaign.toml",
        "time_s = \"time_s\"\n",
        "q2_direction = \"D2\"\nq3_direction = \"D3\"\nq4_direction = \"D4\"\n",
    );
    let (_, said) = etalon(&scratch, "run");
    assert!(said.contains("warning[backlash-negative]") && said.has_phrase("backlash-negative.hint"), "{said}");
}
