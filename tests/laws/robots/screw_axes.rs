//! A model is a function of the lines of its screw axes: whichever point describes a line, and in whichever convention, an arm with any effect is
//! at the same place.

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::campaign::{RobotHead, nominal_text, parse_robot, screws_text, table_text};
use etalon::robots::{AxisLine, Circumstance, Effect, Quantity, Robot, Role, TableConvention};
use std::fmt::Write;
use std::path::Path;

/// Effects of an arm of six revolute joints.
const EFFECTS: &str = "bending = [1, 2, 3, 5]\ncoupling = [[5, 4], [6, 5]]\nharmonics = [1, 4]\nbacklash = [2, 6]\npayload = [2, 3, 5]\n\
                       torque = [2, 3]\ndrift = [1, 2, 3, 4, 5, 6]\nexpansion = true\nlateral = [2, 3, 5]\npedestal = true\n";

/// An arm: axes at joint values zero, flange, and the centres of the links (mm) with masses (kg), in the base.
struct Arm {
    axes: Vec<AxisLine>,
    flange: Pose,
    masses: Vec<(f64, Vector)>,
    gravity: Vector,
}

/// A drawn arm whose first axis is z of its base, and whose last axis is z of its flange. Neighbouring axes meet, cross, are parallel or
/// nearly parallel.
fn drawn(seed: u64) -> Arm {
    let mut noise = Noise::new(59, seed);
    let mut pose = Pose::identity();
    let mut axes = Vec::new();
    for k in 0..6 {
        if k > 0 {
            let twist = match (noise.uniform(2.0) + 2.0).floor() as i64 {
                0 => std::f64::consts::FRAC_PI_2,
                1 => -std::f64::consts::FRAC_PI_2,
                2 if (2..4).contains(&k) => noise.uniform(1e-3),
                2 => 0.9 + noise.uniform(0.5),
                _ if (2..4).contains(&k) => 0.0,
                _ => -1.3,
            };
            let length = if noise.uniform(1.0) > 0.0 || twist.abs() < 0.1 { 250.0 + noise.uniform(200.0) } else { 0.0 };
            pose =
                pose.turn_x(twist).shift(0, length).turn_y(if twist.abs() < 0.1 { noise.uniform(1e-3) } else { 0.0 });
        }
        axes.push(AxisLine { direction: pose.axis(2), point_mm: pose.translation_mm, prismatic: false });
        pose = pose.turn_z(noise.uniform(3.0)).shift(2, 150.0 + noise.uniform(150.0));
    }
    let mut vector = |size: f64| [0; 3].map(|_| noise.uniform(size));
    let masses = axes.iter().map(|a| (3.0, [0, 1, 2].map(|i| a.point_mm[i] + vector(80.0)[i]))).collect();
    let tilted = vector(0.3);
    Arm { axes, flange: pose, masses, gravity: [tilted[0], tilted[1], -1.0] }
}

/// Description of an arm in a convention, with the frames that the convention has for base and flange.
struct Described {
    robot: Box<dyn Robot>,
    base: Pose,
    flange: Pose,
}

impl Arm {
    /// The arm in a convention: `poe` with the point of each axis moved along it, `mdh`, or `dh`.
    fn described(&self, convention: &str, along_mm: &[f64]) -> Described {
        let head = RobotHead { name: "arm", comments: &[], limits: &[] };
        let moved = |(axis, by): (&AxisLine, &f64)| AxisLine {
            point_mm: [0, 1, 2].map(|i| axis.point_mm[i] + by * axis.direction[i]),
            ..*axis
        };
        let axes: Vec<AxisLine> = self.axes.iter().zip(along_mm).map(moved).collect();
        let convention =
            [TableConvention::Modified, TableConvention::Standard].into_iter().find(|of| of.key() == convention);
        let table = convention.map(|convention| convention.table(&axes, &self.flange));
        let text = match convention.zip(table.as_ref()) {
            None => screws_text(head, &axes, &self.flange),
            Some((convention, table)) => table_text(head, convention, table) + &nominal_text(&[], &table.tilts),
        };
        let [base, flange] = table.as_ref().map_or([Pose::identity(); 2], |table| [table.base, table.flange]);
        // centres of masses: in the base, or in the frame behind the joint
        let bare = parse_robot(Path::new("robot.toml"), &text).unwrap().build(&["T".to_owned()]).unwrap();
        let frames = bare.joint_chain(&bare.nominal()).unwrap().frames(&[0.0; 6]);
        let into = base.inverse();
        let centre = |(k, (_, at)): (usize, &(f64, Vector))| match table {
            None => *at,
            Some(_) => frames[k].inverse().apply(into.apply(*at)),
        };
        let mut rows = self.masses.iter().enumerate().map(centre);
        let row = |line: &str| match line.strip_suffix(" },") {
            Some(start) => format!("{start}, mass_kg = 3.0, center_mm = {:?} }},\n", rows.next().unwrap()),
            None => format!("{line}\n"),
        };
        let text: String = text.lines().map(row).collect();
        let gravity = format!("gravity = {:?}\n", into.rotate(self.gravity));
        let robot = parse_robot(Path::new("robot.toml"), &(gravity + EFFECTS + &text))
            .unwrap_or_else(|p| panic!("{p}\n{text}"));
        Described { robot: robot.build(&["T".to_owned()]).unwrap_or_else(|p| panic!("{p}\n{text}")), base, flange }
    }
}

/// Parameters of all effects, by name, as large as in real arms.
fn effects(robot: &dyn Robot, seed: u64) -> Vec<(String, f64)> {
    let mut noise = Noise::new(60, seed);
    let effect =
        |p: &&etalon::robots::Parameter| p.role == Role::Robot && !matches!(p.effect, Effect::Geometry | Effect::Zeros);
    let value = |p: &etalon::robots::Parameter| {
        let size = if p.effect == Effect::Expansion { 0.02 } else { 3e-3 };
        (p.name.clone(), p.nominal + noise.uniform(if p.quantity == Quantity::Length { 0.1 } else { size }))
    };
    robot.parameters().iter().filter(effect).map(value).collect()
}

/// A place of the target with these effects at joint values and everything that a reading states, in the base of the arm.
fn place(described: &Described, effects: &[(String, f64)], q: &[f64], stated: &dyn Fn(Circumstance) -> f64) -> Vector {
    let Described { robot, base, flange } = described;
    let mut values = robot.nominal();
    effects.iter().for_each(|(name, value)| values[robot.index(name).unwrap_or_else(|| panic!("{name}"))] = *value);
    let target = robot.index("T_x").unwrap();
    // the target and the load are in the flange of the arm
    let at = flange.apply([40.0, -30.0, 90.0]);
    values[target..target + 3].copy_from_slice(&at);
    let load = flange.apply([0, 1, 2].map(|k| stated(Circumstance::PayloadCentre(k))));
    let mut state = q.to_vec();
    state.extend(robot.approached().iter().map(|_| 1.0));
    state.extend(robot.circumstances().iter().map(|c| match c {
        Circumstance::PayloadCentre(k) => load[*k],
        other => stated(*other),
    }));
    base.apply(robot.position(&values, &state, 0))
}

#[test]
fn an_arm_with_all_effects_is_a_function_of_its_lines_in_every_convention() {
    for seed in 0..60 {
        let arm = drawn(seed);
        let mut noise = Noise::new(61, seed);
        let nominal = arm.described("poe", &[0.0; 6]);
        let effects = effects(nominal.robot.as_ref(), seed);
        let mut along = || -> Vec<f64> { (0..6).map(|_| noise.uniform(1500.0)).collect() };
        let all = [("poe", along()), ("poe", along()), ("dh", along()), ("mdh", along())];
        let all = all.map(|(convention, along)| (convention, arm.described(convention, &along)));
        for draw in 0..5 {
            let mut noise = Noise::new(62, 100 * seed + draw);
            let q: Vec<f64> = (0..6).map(|_| noise.uniform(2.5)).collect();
            let (torque, at) = (noise.uniform(80.0), [0; 3].map(|_| noise.uniform(60.0)));
            let stated = |value: Circumstance| match value {
                Circumstance::PayloadMass => 4.0,
                Circumstance::PayloadCentre(k) => at[k],
                Circumstance::Torque(_) => torque,
                Circumstance::Temperature => 33.0,
            };
            let expected = place(&nominal, &effects, &q, &stated);
            let rigid = place(&nominal, &[], &q, &stated);
            assert!(norm(minus(expected, rigid)) > 0.1, "no effect");
            for (convention, described) in &all {
                let off = norm(minus(place(described, &effects, &q, &stated), expected));
                assert!(off < 1e-7, "{seed}, {convention}: {off} mm, {:?}", arm.axes);
            }
        }
    }
}

/// A URDF of an arm whose joints have origins moved along their axes, with masses in their links.
fn urdf(arm: &Arm, along_mm: &[f64]) -> String {
    let mut text = "<robot name=\"arm\">\n  <link name=\"base_link\"/>\n".to_owned();
    let (mut before, mut parent) = (Pose::identity(), "base_link".to_owned());
    let origin = |pose: &Pose| {
        let [x, y, z] = pose.translation_mm.map(|mm| mm / 1000.0);
        let [roll, pitch, yaw] = pose.rpy_rad();
        format!("<origin xyz=\"{x:?} {y:?} {z:?}\" rpy=\"{roll:?} {pitch:?} {yaw:?}\"/>")
    };
    for (k, (axis, by)) in arm.axes.iter().zip(along_mm).enumerate() {
        let frame = etalon::robots::link_frames(&arm.axes[k..=k], &arm.flange)[0];
        let at = [0, 1, 2].map(|i| axis.point_mm[i] + by * axis.direction[i]);
        let frame = Pose { translation_mm: at, ..frame };
        let (mass, centre) = arm.masses[k];
        let centre = Pose { translation_mm: frame.inverse().apply(centre), ..Pose::identity() };
        let _ = writeln!(
            text,
            "  <joint name=\"q{n}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"link_{n}\"/>{}<axis xyz=\"0 0 1\"/></joint>\n  \
             <link name=\"link_{n}\"><inertial>{}<mass value=\"{mass:?}\"/></inertial></link>",
            origin(&before.inverse().then(&frame)),
            origin(&centre),
            n = k + 1,
        );
        (before, parent) = (frame, format!("link_{}", k + 1));
    }
    let flange = origin(&before.inverse().then(&arm.flange));
    text + &format!(
        "  <joint name=\"flange\" type=\"fixed\"><parent link=\"{parent}\"/><child link=\"tool\"/>{flange}</joint>\n  <link name=\"tool\"/>\n</robot>\n"
    )
}

/// The arm as a URDF with these effects by the names of its joints.
fn of_urdf(arm: &Arm, along_mm: &[f64], bending: &str) -> Described {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("arm.urdf"), urdf(arm, along_mm)).unwrap();
    let joints = |text: &str| {
        let mut named = text.to_owned();
        (1..7).for_each(|k| {
            named =
                named.replace(&format!("[{k}"), &format!("[\"q{k}\"")).replace(&format!(" {k}"), &format!(" \"q{k}\""))
        });
        named
    };
    let kept: String =
        EFFECTS.lines().filter(|line| !line.starts_with("bending")).map(|line| joints(line) + "\n").collect();
    let text = format!(
        "name = \"arm\"\nmodel = \"urdf\"\nfile = \"arm.urdf\"\nbase_link = \"base_link\"\ntool_link = \"tool\"\n\
         gravity = {:?}\n{bending}{kept}",
        arm.gravity
    );
    let path = folder.path().join("robot.toml");
    std::fs::write(&path, &text).unwrap();
    let robot = etalon::campaign::read_robot(&path).unwrap_or_else(|p| panic!("{p}\n{text}"));
    let robot = robot.build(&["T".to_owned()]).unwrap_or_else(|p| panic!("{p}\n{text}"));
    Described { robot, base: Pose::identity(), flange: Pose::identity() }
}

#[test]
fn an_arm_of_a_urdf_is_that_of_its_screw_axes_wherever_its_origins_are() {
    let q_less = |name: &str| name.replace("_q", "_");
    for seed in 0..40 {
        let arm = drawn(seed);
        let mut noise = Noise::new(63, seed);
        let mut along = || -> Vec<f64> { (0..6).map(|_| noise.uniform(1500.0)).collect() };
        let screws = arm.described("poe", &along());
        let bending = "bending = [\"q2\", \"q3\"]\n";
        let all = [of_urdf(&arm, &[0.0; 6], bending), of_urdf(&arm, &along(), bending)];
        // bending by masses is an effect of a URDF alone
        let own = effects(all[0].robot.as_ref(), seed);
        let common: Vec<(String, f64)> = own
            .iter()
            .map(|(name, value)| (q_less(name), *value))
            .filter(|(name, _)| screws.robot.index(name).is_some())
            .collect();
        let stated = |value: Circumstance| match value {
            Circumstance::PayloadMass => 4.0,
            Circumstance::PayloadCentre(k) => [30.0, -20.0, 70.0][k],
            Circumstance::Torque(_) => 45.0,
            Circumstance::Temperature => 33.0,
        };
        for draw in 0..5 {
            let mut noise = Noise::new(64, 100 * seed + draw);
            let q: Vec<f64> = (0..6).map(|_| noise.uniform(2.5)).collect();
            let [one, two] = [0, 1].map(|k| place(&all[k], &own, &q, &stated));
            assert!(norm(minus(one, two)) < 1e-7, "{seed}: {one:?} {two:?}");
            let shared: Vec<(String, f64)> =
                own.iter().filter(|(name, _)| screws.robot.index(&q_less(name)).is_some()).cloned().collect();
            assert_eq!(shared.len(), common.len());
            let off = norm(minus(place(&all[1], &shared, &q, &stated), place(&screws, &common, &q, &stated)));
            assert!(off < 1e-7, "{seed}: {off} mm from screw axes");
        }
    }
}
