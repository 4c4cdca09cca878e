//! Conditions: orientations, distances, contacts, planes, lines, spheres and joints give the robot back, alone and together, with intervals that hold.

use crate::support::arms::{SIX_AXES, serial};
use crate::support::root;
use crate::support::scratch::{Scratch, copy_sample, etalon};
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::base::pose_name::PoseName;
use etalon::identify::{
    Condition, Contact, Coordinate, Distance, Fixture, Identification, JointValue, Kind, Known, Observation, On,
    Orientation, Settings, Status, Surface, fit_frames, identify_from,
};
use etalon::robots::{FreeBase, Robot, Role, Serial};
use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, Vector3};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::process::Command;

/// Standard uncertainties of the simulated measurements.
const U_MM: f64 = 0.05;
const U_RAD: f64 = 2e-4;
/// Sockets in the base frame, in front of the arm.
const SOCKETS: [Vector; 4] =
    [[330.0, -140.0, 210.0], [420.0, 160.0, 260.0], [300.0, 60.0, 420.0], [450.0, -30.0, 330.0]];
/// Ends of a ball bar.
const ENDS: [Vector; 3] = [[700.0, 300.0, 100.0], [600.0, -500.0, 50.0], [-650.0, 200.0, 90.0]];

/// A simulated campaign of a six-axis arm, with errors of half a millimetre and a few milliradians, and a ball.
struct Campaign {
    robot: Serial,
    truth: Vec<f64>,
    observations: Vec<Observation>,
    settings: Settings,
    noise: Noise,
    /// Errors of the measurements over their standard uncertainties: 0 or 1.
    errors: f64,
}

impl Campaign {
    fn new(mut noise: Noise, errors: f64) -> Self {
        let robot = serial(&SIX_AXES, &["ball"], &[]);
        // what a base and a single ball take up
        let absorbed = ["alpha_1", "a_1", "theta_1", "d_1", "theta_6", "d_6"];
        let of = |p: &etalon::robots::Parameter| {
            let error = match (p.role, p.name.split('_').next().unwrap()) {
                (Role::Base, _) => 0.0,
                (Role::Target, _) => 60.0 + noise.uniform(20.0),
                _ if absorbed.contains(&&p.name[..]) => 0.0,
                (_, "a" | "d") => noise.uniform(0.5),
                (_, "gain") => noise.uniform(1e-3),
                _ => noise.uniform(3e-3),
            };
            p.nominal + error
        };
        let truth = robot.parameters().iter().map(of).collect();
        let settings = Settings { standard_uncertainty_mm: Some(U_MM), ..Settings::default() };
        Self { robot, truth, observations: Vec::new(), settings, noise, errors }
    }

    /// The same with its base somewhere in the world.
    fn anywhere(mut self) -> Self {
        // a rotation vector shorter than half a turn: a longer one is the same attitude by other numbers
        for (i, range) in [2000.0, 2000.0, 2000.0, 2.0, 1.2, 2.0].into_iter().enumerate() {
            self.truth[i] = self.noise.uniform(range);
        }
        self
    }

    fn error(&mut self, standard_uncertainty: f64) -> f64 {
        self.errors * self.noise.gaussian(standard_uncertainty)
    }

    fn fixture(&mut self, fixture: Fixture, values: impl IntoIterator<Item = f64>) -> usize {
        let first = fixture.add_to(&mut self.robot);
        self.truth.truncate(first);
        self.truth.extend(values);
        first
    }

    fn joints(&mut self) -> Vec<f64> {
        [2.8, 1.0, 1.0, 2.6, 1.9, 3.0].map(|range| self.noise.uniform(range)).to_vec()
    }

    fn at(&self, joints: &[f64]) -> Vector {
        self.robot.position(&self.truth, joints, 0)
    }

    /// Random joints at which all of `left` of the ball's place is zero: Newton's steps of least norm.
    fn joints_where(&mut self, left: impl Fn(Vector) -> Vec<f64>) -> Vec<f64> {
        loop {
            let mut q = self.joints();
            for _ in 0..40 {
                let now = left(self.at(&q));
                if now.iter().all(|v| v.abs() < 1e-11) && q.iter().all(|q| q.abs() < 3.2) {
                    return q;
                }
                let by = |j: usize, h: f64| {
                    let mut moved = q.clone();
                    moved[j] += h;
                    left(self.at(&moved))
                };
                let a = DMatrix::from_fn(now.len(), q.len(), |i, j| (by(j, 1e-5)[i] - by(j, -1e-5)[i]) / 2e-5);
                let Some(inverse) = (&a * a.transpose()).try_inverse() else { break };
                let step = a.transpose() * inverse * DVector::from_vec(now);
                let shorten = (0.3 / step.amax()).min(1.0);
                q.iter_mut().zip(step.iter()).for_each(|(q, s)| *q -= shorten * s);
            }
        }
    }

    fn observe(&mut self, joints: Vec<f64>, kind: Kind, standard_uncertainty: f64) {
        let pose = PoseName::from(self.settings.conditions.len() as i64 + 1);
        self.settings.conditions.push(Condition { pose, cycle: 1, joints, target: 0, kind, standard_uncertainty });
    }

    /// Positions and orientations of a body.
    fn poses(mut self, count: usize) -> Self {
        let turn = [0.4, -1.1, 2.2];
        let mounting = self.fixture(Fixture::Mounting("ball"), turn);
        for _ in 0..count {
            let joints = self.joints();
            let seen = self.at(&joints).map(|v| v + self.error(U_MM));
            let off = Vector3::from([0; 3].map(|_| self.error(U_RAD)));
            let flange = turn_of(&self.robot.flange(&self.truth, &joints, 0));
            let body = Rotation3::from_scaled_axis(off) * flange * Rotation3::from_scaled_axis(Vector3::from(turn));
            let pose = PoseName::from(self.settings.conditions.len() as i64 + 1);
            self.observations.push(Observation {
                pose,
                cycle: 1,
                joints: joints.clone(),
                targets: vec![Some(seen)],
                ..Observation::default()
            });
            self.observe(
                joints,
                Kind::Orientation(Orientation { frame_T_body: pose_of(&body), station: None, mounting }),
                U_RAD,
            );
        }
        self
    }

    /// Contacts with sockets.
    fn contacts(mut self, sockets: usize, count: usize) -> Self {
        for (k, place) in SOCKETS[..sockets].iter().enumerate() {
            let socket = self.fixture(Fixture::Point(["s1", "s2", "s3", "s4"][k]), *place);
            for _ in 0..count {
                let there = place.map(|v| v + self.error(U_MM));
                let joints = self.joints_where(|p| minus(p, there).to_vec());
                self.observe(joints, Kind::Contact(Contact { socket }), U_MM);
            }
        }
        self
    }

    /// First parameters of sockets.
    fn sockets(&self) -> Vec<usize> {
        ["s1_x", "s2_x", "s3_x", "s4_x"].iter().filter_map(|name| self.robot.index(name)).collect()
    }

    /// Distances of all sockets from each other.
    fn with_lengths(mut self) -> Self {
        let (sockets, standard_uncertainty_mm) = (self.sockets(), 0.004);
        for (k, &to) in sockets.iter().enumerate() {
            for (i, &from) in sockets[..k].iter().enumerate() {
                let distance_mm = norm(minus(SOCKETS[k], SOCKETS[i])) + self.error(standard_uncertainty_mm);
                self.settings.known.push(Known::Distance { from, to, distance_mm, standard_uncertainty_mm });
            }
        }
        self
    }

    /// Places of the sockets in a world in which the base is shifted and turned.
    fn with_places(mut self) -> Self {
        let turn = [0.3, -0.5, 1.2];
        let moved = Rotation3::from_scaled_axis(turn.into());
        for (i, v) in [1500.0, -300.0, 250.0].into_iter().chain(turn).enumerate() {
            self.truth[i] = v;
        }
        for (k, point) in self.sockets().into_iter().enumerate() {
            let true_mm = moved * Vector3::from(SOCKETS[k]) + Vector3::new(1500.0, -300.0, 250.0);
            self.truth[point..point + 3].copy_from_slice(true_mm.as_slice());
            let place_mm = [0, 1, 2].map(|i| true_mm[i] + self.error(0.004));
            self.settings.known.push(Known::Place { point, place_mm, standard_uncertainty_mm: 0.004 });
        }
        self
    }

    /// Dial gauges along the axes of the world, one at a pose.
    fn coordinates(mut self, count: usize) -> Self {
        for axis in (0..count).map(|i| i % 3) {
            let joints = self.joints();
            let at_mm = self.at(&joints)[axis] + self.error(U_MM);
            self.observe(joints, Kind::Coordinate(Coordinate { axis, at_mm }), U_MM);
        }
        self
    }

    fn distances(mut self, count: usize) -> Self {
        for (k, end) in ENDS.iter().enumerate() {
            let to = self.fixture(Fixture::Point(["e1", "e2", "e3"][k]), *end);
            for _ in 0..count {
                let joints = self.joints();
                let distance_mm = norm(minus(self.at(&joints), *end)) + self.error(U_MM);
                self.observe(joints, Kind::Distance(Distance { to, distance_mm }), U_MM);
            }
        }
        self
    }

    /// Touches of a table, a wall and a slope, by a ball of 25.4 mm.
    fn planes(mut self, count: usize) -> Self {
        let all =
            [("table", 2, [0.02, -0.03, 120.0]), ("wall", 0, [0.05, 0.01, 430.0]), ("slope", 1, [0.3, 0.5, 250.0])];
        for (name, axis, values) in all {
            let plane = self.fixture(Fixture::Plane(name, axis), values);
            for _ in 0..count {
                let error = self.error(U_MM);
                let joints = self.joints_where(|p| {
                    let slopes = [values[0].tan(), values[1].tan()];
                    let traces = slopes[0] * p[(axis + 1) % 3] + slopes[1] * p[(axis + 2) % 3];
                    let length = (1.0 + slopes[0].powi(2) + slopes[1].powi(2)).sqrt();
                    vec![(p[axis] - values[2] - traces) / length - 12.7 - error]
                });
                let (surface, unknowns) = (Surface::Plane { axis }, [plane, plane + 1, plane + 2, plane + 2]);
                self.observe(joints, Kind::On(On { surface, unknowns, offset_mm: 12.7 }), U_MM);
            }
        }
        self
    }

    /// A ball in three grooves.
    fn lines(mut self, count: usize) -> Self {
        let all = [
            ("groove", 1, [0.05, -0.1, 90.0, 480.0]),
            ("edge", 0, [-0.2, 0.15, 210.0, 330.0]),
            ("post", 2, [0.03, 0.02, 430.0, -120.0]),
        ];
        for (name, axis, values) in all {
            let first = self.fixture(Fixture::Line(name, axis), values);
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let (mut along, mut foot) = (Vector3::zeros(), Vector3::zeros());
            (along[axis], along[i], along[j]) = (1.0, values[0].tan(), values[1].tan());
            (foot[i], foot[j]) = (values[2], values[3]);
            // any two normals
            let one = along.cross(&Vector3::new(0.3, 0.5, 0.7)).normalize();
            let other = along.cross(&one).normalize();
            for _ in 0..count {
                let errors = [self.error(U_MM), self.error(U_MM)];
                let joints = self.joints_where(|p| {
                    let lever = Vector3::from(p) - foot;
                    vec![one.dot(&lever) - errors[0], other.dot(&lever) - errors[1]]
                });
                let (surface, unknowns) = (Surface::Line { axis }, [first, first + 1, first + 2, first + 3]);
                self.observe(joints, Kind::On(On { surface, unknowns, offset_mm: 0.0 }), U_MM);
            }
        }
        self
    }

    /// Touches of two spheres, of which nothing is known.
    fn spheres(mut self, count: usize) -> Self {
        for (name, centre, radius) in [("dome", [420.0, 60.0, 200.0], 150.0), ("knob", [-350.0, 300.0, 250.0], 60.0)] {
            let first = self.fixture(Fixture::Point(name), centre);
            let unknowns = [first, first + 1, first + 2, self.fixture(Fixture::Radius(name), [radius])];
            for _ in 0..count {
                let out = radius + 12.7 + self.error(U_MM);
                let joints = self.joints_where(|p| vec![norm(minus(p, centre)) - out]);
                self.observe(joints, Kind::On(On { surface: Surface::Sphere, unknowns, offset_mm: 12.7 }), U_MM);
            }
        }
        self
    }

    /// A second encoder on each joint.
    fn second_encoders(mut self, count: usize) -> Self {
        for joint in (0..6).flat_map(|joint| std::iter::repeat_n(joint, count)) {
            let joints = self.joints();
            let of = |name: &str| self.truth[self.robot.index(&format!("{name}_{}", joint + 1)).unwrap()];
            let theta = of("theta") - SIX_AXES[joint][2].to_radians();
            let value = of("gain") * joints[joint] + theta + self.error(U_RAD);
            self.observe(joints, Kind::Joint(JointValue { joint, value, is_angle: true }), U_RAD);
        }
        self
    }

    fn identify(&self) -> Identification {
        let before = fit_frames(&self.robot, &self.observations, &self.settings).unwrap_or_else(|e| panic!("{e:?}"));
        identify_from(&self.robot, &self.observations, &self.settings, &before).unwrap_or_else(|e| panic!("{e:?}"))
    }

    fn names(&self, of: impl Fn(usize) -> bool) -> Vec<&str> {
        let all = self.robot.parameters().iter().enumerate();
        all.filter(|(i, _)| of(*i)).map(|(_, p)| p.name.as_str()).collect()
    }
}

/// A rotation by nalgebra, which the program does not use for it.
fn turn_of(pose: &Pose) -> Rotation3<f64> {
    Rotation3::from_matrix_unchecked(Matrix3::from_fn(|i, j| pose.rotation[i][j]))
}

fn pose_of(turn: &Rotation3<f64>) -> Pose {
    Pose { rotation: std::array::from_fn(|i| std::array::from_fn(|j| turn[(i, j)])), translation_mm: [0.0; 3] }
}

/// Half width of a 95 % interval in standard uncertainties, which have these degrees of freedom or are stated.
fn quantile(degrees: Option<f64>) -> f64 {
    degrees.map_or(1.959_964, |degrees| StudentsT::new(0.0, 1.0, degrees).unwrap().inverse_cdf(0.975))
}

/// Every kind, by name.
fn campaign(kind: &str, seed: u64, trial: u64, errors: f64) -> Campaign {
    let new = Campaign::new(Noise::new(seed, trial), errors);
    match kind {
        "pose" => new.anywhere().poses(60),
        "contact, lengths" => new.contacts(4, 20).with_lengths(),
        "contact, places" => new.contacts(4, 20).with_places(),
        "distance" => new.distances(50),
        "coordinate" => new.coordinates(120),
        // planes alone give no scale: the nominal length of a link does
        "plane" => new.planes(60).distances(8),
        "line" => new.lines(30).distances(8),
        "sphere" => new.spheres(70).distances(12),
        "joints" => new.anywhere().poses(30).second_encoders(10),
        "all" => {
            new.poses(20).contacts(3, 8).distances(10).planes(10).coordinates(9).lines(8).spheres(10).second_encoders(3)
        }
        other => panic!("{other}"),
    }
}

/// Simulated campaigns of each kind.
fn draws() -> u64 {
    std::env::var("ETALON_DRAWS").map_or(100, |n| n.parse().unwrap())
}

#[test]
#[ignore = "a long law: make laws"]
fn intervals_of_every_kind_hold() {
    for kind in KINDS {
        let draws = draws();
        let one = |trial: u64| {
            let campaign = campaign(kind, 78, trial, 1.0);
            let found = campaign.identify();
            let chi_square = found.residuals.chi_square.unwrap() / found.residuals.degrees_of_freedom as f64;
            let holds = |&i: &usize| {
                let u = found.standard_uncertainty(i).unwrap();
                let degrees = found.degrees_of_freedom(i);
                (found.values[i] - campaign.truth[i]).abs() < quantile(degrees) * u
            };
            let held = found.free.iter().filter(|i| holds(i)).count();
            (chi_square, held as f64 / found.free.len() as f64)
        };
        let all: Vec<(f64, f64)> = (0..draws).into_par_iter().map(one).collect();
        let mean = |of: fn(&(f64, f64)) -> f64| all.iter().map(of).sum::<f64>() / draws as f64;
        let (chi_square, held) = (mean(|d| d.0), mean(|d| d.1));
        println!("{kind}: chi-square {chi_square:.3}, {:.1} % of intervals hold", 100.0 * held);
        assert!((chi_square - 1.0).abs() < 0.05, "{kind}: chi-square {chi_square}");
        assert!((held - 0.95).abs() < 0.015, "{kind}: {held}");
    }
}

const KINDS: [&str; 9] =
    ["pose", "contact, lengths", "contact, places", "distance", "plane", "coordinate", "line", "sphere", "joints"];

#[test]
fn without_noise_every_kind_gives_the_truth() {
    for kind in KINDS.into_iter().chain(["all"]) {
        let campaign = campaign(kind, 77, 0, 0.0);
        let found = campaign.identify();
        let held = campaign.names(|i| found.status[i] == Status::NotIdentifiable);
        println!("{kind}: {} identified, held {held:?}, rms {:.1e} mm", found.free.len(), found.residuals.rms);
        for &i in &found.free {
            let off = (found.values[i] - campaign.truth[i]).abs();
            assert!(off < 1e-7, "{kind}: {} is off by {off:e}", campaign.robot.parameters()[i].name);
        }
    }
}

/// Places of a plane, a line and a sphere, and its radius, that a certificate states: they hold the scale, and the base in the world.
#[test]
fn known_surfaces_hold_the_world() {
    let mut campaign = Campaign::new(Noise::new(82, 0), 0.0).planes(30).lines(10).spheres(20);
    let first = |name: &str| campaign.robot.index(name).unwrap();
    let (table, groove, dome) = (first("table_slope_x"), first("groove_slope_z"), first("dome_x"));
    let slope = |i: usize| campaign.truth[i].tan();
    let standard_uncertainty_mm = 0.004;
    let on = |surface, unknowns, place_mm| Known::On { surface, unknowns, place_mm, standard_uncertainty_mm };
    let mut known = Vec::new();
    for [a, b] in [[300.0, -200.0], [500.0, 250.0], [100.0, 400.0], [-200.0, 100.0]] {
        let z = campaign.truth[table + 2] + a * slope(table) + b * slope(table + 1);
        known.push(on(Surface::Plane { axis: 2 }, [table, table + 1, table + 2, table + 2], [a, b, z]));
        let (z, x) =
            (campaign.truth[groove + 2] + a * slope(groove), campaign.truth[groove + 3] + a * slope(groove + 1));
        known.push(on(Surface::Line { axis: 1 }, [groove, groove + 1, groove + 2, groove + 3], [x, a, z]));
        let at = Vector3::new(a, b, 100.0).normalize() * campaign.truth[dome + 3];
        let place = [0, 1, 2].map(|i| campaign.truth[dome + i] + at[i]);
        known.push(on(Surface::Sphere, [dome, dome + 1, dome + 2, dome + 3], place));
    }
    known.push(Known::Length { parameter: dome + 3, length_mm: campaign.truth[dome + 3], standard_uncertainty_mm });
    campaign.settings.known = known;
    let found = campaign.identify();
    assert!(found.free.iter().any(|&i| i < 3), "the world is that of the certificate");
    for &i in &found.free {
        let off = (found.values[i] - campaign.truth[i]).abs();
        assert!(off < 1e-7, "{} is off by {off:e}", campaign.robot.parameters()[i].name);
    }
    assert!(!found.warnings.iter().any(|m| m.what.contains("length")), "{:?}", found.warnings);
}

const ROBOT: &str = r#"model = "serial"
joint = [
    { alpha_deg = 0, a_mm = 0, theta_deg = 0, d_mm = 290 },
    { alpha_deg = -90, a_mm = 0, theta_deg = -90, d_mm = 0 },
    { alpha_deg = 0, a_mm = 270, theta_deg = 0, d_mm = 0 },
    { alpha_deg = -90, a_mm = 70, theta_deg = 0, d_mm = 302 },
    { alpha_deg = 90, a_mm = 0, theta_deg = 0, d_mm = 0 },
    { alpha_deg = -90, a_mm = 0, theta_deg = 180, d_mm = 72 },
]
"#;

const HEADER: &str = "kind,pose,cycle,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz,distance_mm,other,socket,\
                      plane,axis,offset_mm,u_mm,urot_deg";
/// Columns of further kinds.
const MORE: &str = "line_name,sphere,joint,value_deg";

impl Campaign {
    /// Name of what a parameter is of.
    fn fixture_name(&self, first: usize) -> &str {
        let name = &self.robot.parameters()[first].name;
        name.rsplit_once("_slope").or(name.rsplit_once('_')).unwrap().0
    }

    /// The cells that a condition has of its own.
    fn cells(&self, c: &Condition) -> Vec<(&'static str, String)> {
        let fixture = |first: usize| self.fixture_name(first);
        match c.kind {
            Kind::Orientation(Orientation { frame_T_body, .. }) => {
                let at = self.observations.iter().find(|o| o.pose == c.pose).unwrap().targets[0].unwrap();
                let q = frame_T_body.quaternion();
                let place = ["x_mm", "y_mm", "z_mm"].into_iter().zip(at.map(|v| v.to_string()));
                let turn = ["qw", "qx", "qy", "qz"].into_iter().zip(q.map(|v| v.to_string()));
                let u = ("urot_deg", c.standard_uncertainty.to_degrees().to_string());
                [("kind", "pose".to_owned()), u].into_iter().chain(place).chain(turn).collect()
            }
            Kind::Coordinate(Coordinate { axis, at_mm }) => vec![(["x_mm", "y_mm", "z_mm"][axis], at_mm.to_string())],
            Kind::Distance(Distance { to, distance_mm }) => vec![
                ("kind", "distance".to_owned()),
                ("other", fixture(to).to_owned()),
                ("distance_mm", distance_mm.to_string()),
            ],
            Kind::Contact(Contact { socket }) => {
                vec![("kind", "contact".to_owned()), ("socket", fixture(socket).to_owned())]
            }
            Kind::Seen(_) | Kind::Between(_) => panic!("{c:?}"),
            Kind::On(On { surface, unknowns, offset_mm }) => {
                let (kind, axis) = match surface {
                    Surface::Plane { axis } => ("plane", ["x", "y", "z"][axis]),
                    Surface::Line { axis } => ("line", ["x", "y", "z"][axis]),
                    Surface::Sphere => ("sphere", ""),
                };
                vec![
                    ("kind", kind.to_owned()),
                    (if kind == "line" { "line_name" } else { kind }, fixture(unknowns[0]).to_owned()),
                    ("axis", axis.to_owned()),
                    ("offset_mm", if kind == "line" { String::new() } else { offset_mm.to_string() }),
                ]
            }
            Kind::Joint(JointValue { joint, value, .. }) => vec![
                ("kind", "joints".to_owned()),
                ("joint", format!("q{}", joint + 1)),
                ("value_deg", value.to_degrees().to_string()),
                ("urot_deg", c.standard_uncertainty.to_degrees().to_string()),
            ],
        }
    }

    /// The campaign as a table of observations; what is not stated is empty.
    fn table(&self) -> String {
        let fixture = |first: usize| self.fixture_name(first);
        let more = |c: &Condition| match c.kind {
            Kind::On(On { surface, .. }) => !matches!(surface, Surface::Plane { .. }),
            Kind::Joint(_) => true,
            _ => false,
        };
        let header = match self.settings.conditions.iter().any(more) {
            true => format!("{HEADER},{MORE}"),
            false => HEADER.to_owned(),
        };
        let mut rows = vec![header.clone()];
        let mut row = |cells: &[(&str, String)]| {
            let cell = |column: &str| cells.iter().find(|c| c.0 == column).map_or("", |c| c.1.as_str());
            rows.push(header.split(',').map(cell).collect::<Vec<_>>().join(","));
        };
        for c in &self.settings.conditions {
            let mut cells = vec![
                ("pose", c.pose.to_string()),
                ("cycle", c.cycle.to_string()),
                ("target", "ball".to_owned()),
                ("u_mm", if c.kind.is_angle() { "0.05".to_owned() } else { c.standard_uncertainty.to_string() }),
            ];
            let columns = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];
            cells.extend(columns.into_iter().zip(&c.joints).map(|(name, q)| (name, q.to_degrees().to_string())));
            cells.extend(self.cells(c));
            row(&cells);
        }
        for known in &self.settings.known {
            match *known {
                Known::Place { point, place_mm, standard_uncertainty_mm } => {
                    let place = ["x_mm", "y_mm", "z_mm"].into_iter().zip(place_mm.map(|v| v.to_string()));
                    let mut cells = vec![
                        ("kind", "point".to_owned()),
                        ("target", fixture(point).to_owned()),
                        ("u_mm", standard_uncertainty_mm.to_string()),
                    ];
                    cells.extend(place);
                    row(&cells);
                }
                Known::Distance { from, to, distance_mm, standard_uncertainty_mm } => row(&[
                    ("kind", "distance".to_owned()),
                    ("target", fixture(from).to_owned()),
                    ("other", fixture(to).to_owned()),
                    ("distance_mm", distance_mm.to_string()),
                    ("u_mm", standard_uncertainty_mm.to_string()),
                ]),
                Known::On { .. } | Known::Seen { .. } | Known::Length { .. } => panic!("{known:?}"),
            }
        }
        rows.join("\n") + "\n"
    }
}

/// What `etalon identify` makes of a table.
fn identified(table: &str, more: &[&str]) -> std::process::Output {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), ROBOT).unwrap();
    std::fs::write(folder.path().join("observations.csv"), table).unwrap();
    let command = ["identify", "--robot", "robot.toml", "--observations", "observations.csv"];
    Command::new(env!("CARGO_BIN_EXE_etalon")).current_dir(folder.path()).args(command).args(more).output().unwrap()
}

#[test]
fn a_table_of_every_kind_identifies_as_its_conditions_do() {
    for kind in KINDS {
        let campaign = campaign(kind, 79, 0, 1.0);
        let found = campaign.identify();
        let stated = ["--standard-uncertainty-um", "50", "--effects", "all", "--prior", "none", "--json"];
        let output = identified(&campaign.table(), &stated);
        let document: serde_json::Value =
            serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{kind}: {e} {output:?}"));
        let parameters = document["parameters"].as_array().unwrap();
        for &i in &found.free {
            let p = &campaign.robot.parameters()[i];
            let entry = parameters
                .iter()
                .find(|entry| entry["name"] == p.name.as_str())
                .unwrap_or_else(|| panic!("{kind}: {}", p.name));
            let u = p.quantity.outward(found.standard_uncertainty(i).unwrap());
            let off = entry["value"].as_f64().unwrap() - p.quantity.outward(found.values[i]);
            assert!(off.abs() < 1e-6 * u, "{kind}: {} is off by {off:e}, u {u:e}", p.name);
            let ratio = entry["standard_uncertainty"].as_f64().unwrap() / u;
            assert!((ratio - 1.0).abs() < 1e-6, "{kind}: {}", p.name);
        }
        println!("{kind}: {:?} {}", output.status.code(), document["messages"]);
        assert_eq!(output.status.code(), Some(0), "{kind}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

/// A copy of the sample of contacts, with other text in its table.
fn sample(change: impl Fn(String) -> String) -> Scratch {
    let scratch = copy_sample("contacts");
    let table = root().join("samples/contacts/observations.csv");
    let table = change(std::fs::read_to_string(table).unwrap());
    std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
    scratch
}

/// No export, no log, no instrument but the sockets: at fresh contacts what is left is the noise of a contact.
#[test]
fn the_sample_of_contacts_is_what_its_readme_states() {
    let table = campaign("contact, lengths", 80, 0, 1.0).table();
    let file = root().join("samples/contacts/observations.csv");
    if std::env::var_os("ETALON_UPDATE").is_some() {
        std::fs::write(&file, &table).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), table, "ETALON_UPDATE=1 writes it again");
    let scratch = sample(|table| table);
    assert_eq!(etalon(&scratch, "check").0, Some(0));
    let (code, said) = etalon(&scratch, "run");
    assert_eq!(code, Some(0), "{said}");
    let accuracy = std::fs::read(scratch.path().join("out/accuracy.json")).unwrap();
    let accuracy: serde_json::Value = serde_json::from_slice(&accuracy).unwrap();
    let validation = accuracy["sets"].as_array().unwrap().iter().find(|s| s["name"] == "validation").unwrap();
    let contact = validation["errors"].as_array().unwrap().iter().find(|e| e["quantity"] == "contact").unwrap();
    let (before, after) = (contact["before"]["mean"].as_f64().unwrap(), contact["after"]["mean"].as_f64().unwrap());
    println!("before {before} mm, after {after} mm");
    // the mean length of three normal errors is 1.6 of their standard deviation
    assert!(before > 1.0 && after < 2.0 * 1.6 * U_MM, "{contact}");
}

#[test]
fn slips_in_contacts_do_not_pass() {
    let column = |name: &str| HEADER.split(',').position(|column| column == name).unwrap();
    let cells = |table: String, how: &dyn Fn(&mut Vec<String>)| -> String {
        let rows = table.lines().enumerate().map(|(i, line)| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if i > 0 {
                how(&mut cells);
            }
            cells.join(",") + "\n"
        });
        rows.collect()
    };
    let scaled = |cell: &mut String, factor: f64| {
        if let Ok(value) = cell.parse::<f64>() {
            *cell = (factor * value).to_string();
        }
    };
    let (q2, q5, d) = (column("q2_deg"), column("q5_deg"), column("distance_mm"));
    type Slip<'a> = (&'a str, &'a dyn Fn(&mut Vec<String>));
    let slips: [Slip; 4] = [
        ("a joint reversed", &|row| scaled(&mut row[q5], -1.0)),
        ("joints in rad", &|row| (q2 - 1..q2 + 5).for_each(|k| scaled(&mut row[k], 1.0 / 57.295_779_5))),
        ("columns exchanged", &|row| row.swap(q2, q5)),
        ("distances in inch", &|row| scaled(&mut row[d], 1.0 / 25.4)),
    ];
    for (what, how) in slips {
        let scratch = sample(|table| cells(table, how));
        let (code, said) = etalon(&scratch, "run");
        println!("{what}: {code:?} {}", said.lines().next().unwrap_or_default());
        assert!(matches!(code, Some(1 | 2)), "{what}: {code:?}\n{said}");
        assert!(!scratch.path().join("out/etalon_parameters.h").exists(), "{what}");
    }
}

#[test]
fn slips_in_orientations_do_not_pass() {
    let first = HEADER.split(',').position(|column| column == "qw").unwrap();
    let table = campaign("pose", 81, 0, 1.0).table();
    type Slip<'a> = (&'a str, &'a str, &'a dyn Fn(&mut Vec<String>));
    let slips: [Slip; 2] = [
        ("the scalar last", "the scalar of the quaternions last", &|row| row[first..first + 4].rotate_left(1)),
        ("world in body", "the inverse rotations", &|row| {
            for cell in &mut row[first + 1..first + 4] {
                *cell = (-cell.parse::<f64>().unwrap()).to_string();
            }
        }),
    ];
    for (what, cause, how) in slips {
        let rows = table.lines().enumerate().map(|(i, line)| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if i > 0 {
                how(&mut cells);
            }
            cells.join(",") + "\n"
        });
        let output = identified(&rows.collect::<String>(), &["--standard-uncertainty-um", "50"]);
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(1 | 2)), "{what}: {:?}\n{error}", output.status);
        let named = error.contains("error[orientations-off]") && error.contains(cause);
        assert!(named, "{what}: {error}");
    }
}
