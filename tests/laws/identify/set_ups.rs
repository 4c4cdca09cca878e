//! Set-ups that are wrong: each is refused or warned about, and nine of ten by the name of what is wrong. The data are synthetic, but
//! for the IRB 120 of the reference data.
//!
//! What no data show is not here: one factor for all lengths of an arm whose joints turn, an offset common to all readings.

use crate::support::arms::{SIX_AXES, serial};
use crate::support::five_bar::{self, measure};
use etalon::base::message::{Message, Severity};
use etalon::base::noise::Noise;
use etalon::base::phrase;
use etalon::base::pose::Vector;
use etalon::campaign::Campaign;
use etalon::identify::{FieldTrial, Observation, Settings, search_field};
use etalon::robots::{Effect, PlanarPose, Platform, Prexyt, Quantity, Robot, Role};
use etalon::run::walk;
use etalon::stages::calibrate::evaluation::Judgement;
use etalon::stages::calibrate::findings::Findings;
use etalon::stages::calibrate::solution::{Basis, Solution};
use etalon::stages::evaluate::sets::Sets;
use etalon::stages::observe::repeats::stale;
use rayon::prelude::*;

/// A robot, how it is measured, and what a slip looks like on it.
pub(super) struct Bench {
    pub(super) name: &'static str,
    pub(super) robot: Box<dyn Robot>,
    pub(super) observations: Vec<Observation>,
    pub(super) u_mm: f64,
}

/// Errors and warnings of an identification; errors where it ends without a result.
fn messages(robot: &dyn Robot, observations: &[Observation], u_mm: f64) -> Vec<Message> {
    let settings = Settings { standard_uncertainty_mm: Some(u_mm), ..Settings::default() };
    let found = || {
        let sets = Sets { calibration: observations.to_vec(), ..Sets::default() };
        let solution = Solution::new(robot, Basis { sets, settings, ..Basis::default() })?;
        Ok(messages_alone(robot, &solution))
    };
    found().unwrap_or_else(|problems: etalon::base::message::Problems| problems.0)
}

/// Messages of a solution that is judged without a campaign.
pub(super) fn messages_alone(robot: &dyn Robot, solution: &Solution) -> Vec<Message> {
    let plausibility = Judgement::new(robot, solution).plausibility;
    let ordered = Findings { plausibility, ..Findings::default() }.ordered(&solution.found.warnings);
    ordered.into_iter().map(|warning| warning.message).collect()
}

/// A robot off by half a millimetre and two milliradians, its base and targets anywhere.
fn truth(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
    let value = |p: &etalon::robots::Parameter, noise: &mut Noise| match (p.role, p.quantity) {
        (Role::Base, Quantity::Length) => noise.uniform(2000.0),
        (Role::Base, _) => noise.uniform(1.2),
        (Role::Target, _) => 60.0 + noise.uniform(30.0),
        (_, Quantity::Ratio) => 1.0 + noise.uniform(2e-4),
        (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
        (_, Quantity::Angle) => p.nominal + noise.uniform(2e-3),
    };
    robot.parameters().iter().map(|p| value(p, noise)).collect()
}

const SEVEN_AXES: [[f64; 4]; 7] = [
    [0.0, 0.0, 0.0, 333.0],
    [-90.0, 0.0, 0.0, 0.0],
    [90.0, 0.0, 0.0, 316.0],
    [90.0, 82.5, 0.0, 0.0],
    [-90.0, -82.5, 0.0, 384.0],
    [90.0, 0.0, 0.0, 0.0],
    [90.0, 88.0, 0.0, 0.0],
];
const TARGETS: [&str; 3] = ["SMR_1", "SMR_2", "SMR_3"];
/// An arm measured in `poses` poses in which its first target lies in a cube of `cube_mm` around `middle` (in the base).
fn arm(name: &'static str, rows: &[[f64; 4]], targets: &[&str], poses: usize, cube: Option<(Vector, f64)>) -> Bench {
    let robot = serial(rows, targets, &[]);
    let mut noise = Noise::new(16, 1);
    let truth = truth(&robot, &mut noise);
    let u_mm = 0.02;
    let mut observations = Vec::new();
    while observations.len() < poses {
        let joints: Vec<f64> = rows.iter().map(|_| noise.uniform(2.0)).collect();
        let mut in_base = truth.clone();
        in_base[..6].fill(0.0);
        let at = robot.position(&in_base, &joints, 0);
        if cube.is_some_and(|(middle, side)| (0..3).any(|i| (at[i] - middle[i]).abs() > side / 2.0)) {
            continue;
        }
        let mut seen = |k: usize| Some(robot.position(&truth, &joints, k).map(|v| v + noise.gaussian(u_mm)));
        let seen = (0..targets.len()).map(&mut seen).collect();
        observations.push(Observation {
            pose: (observations.len() as i64 + 1).into(),
            cycle: 1,
            joints,
            targets: seen,
            ..Observation::default()
        });
    }
    Bench { name, robot: Box::new(robot), observations, u_mm }
}

/// The measured IRB 120 of the reference data, where they are: every twelfth pose.
fn irb120() -> Option<Bench> {
    std::env::var_os("ETALON_REFERENCE")?;
    let scratch = crate::support::scratch::copy_sample("abb-irb120");
    let campaign = Campaign::read(&scratch.path()).expect("campaign");
    let walk::Observed { robot, joined, .. } = walk::observed(&campaign).expect("observed");
    let observations = joined.observations[0].1.positions(robot.as_ref(), &mut Vec::new()).expect("observations");
    let observations = observations.into_iter().step_by(12).collect();
    let u_mm = campaign.file.instrument.standard_uncertainty_mm();
    Some(Bench { name: "IRB 120 (measured)", robot, observations, u_mm })
}

fn prexyt() -> Bench {
    let robot = Prexyt::default();
    let truth: Vec<f64> = {
        let mut v = robot.nominal();
        for (name, off) in
            [("beta", 5e-4), ("gamma", 1.4e-3), ("s", -0.07), ("d3", 0.85), ("d", 0.2), ("x_o", 0.8), ("y_o", -0.2)]
        {
            v[robot.index(name).unwrap()] += off;
        }
        v
    };
    let (u_mm, mut noise) = (0.003, Noise::new(16, 2));
    let mut observations = Vec::new();
    for i in 0..40 {
        let pose = PlanarPose {
            x_mm: 180.0 + noise.uniform(70.0),
            y_mm: 150.0 + noise.uniform(100.0),
            theta_rad: noise.uniform(0.15),
        };
        let joints = robot.joints_at(&truth, pose);
        let mut seen = |k: usize| {
            let p = robot.position(&truth, &joints, k);
            Some([p[0] + noise.gaussian(u_mm), p[1] + noise.gaussian(u_mm), 0.0])
        };
        let targets = vec![seen(0), seen(1)];
        observations.push(Observation { pose: (i + 1).into(), cycle: 1, joints, targets, ..Observation::default() });
    }
    Bench { name: "PreXYT", robot: Box::new(robot), observations, u_mm }
}

fn dextar() -> Bench {
    let (robot, truth, u_mm) = (five_bar::robot(), five_bar::truth(), 0.01);
    let mut noise = Noise::new(16, 3);
    let positions: Vec<[f64; 2]> = five_bar::holes().iter().step_by(23).map(|h| h.2).collect();
    let observations = measure(&robot, &truth, &positions, &mut || noise.gaussian(u_mm));
    Bench { name: "five-bar", robot: Box::new(robot), observations, u_mm }
}

/// A slip, and what its messages must contain: one of these texts.
pub(super) struct Slip {
    pub(super) what: String,
    pub(super) change: Box<dyn Fn(&mut Observation)>,
    pub(super) culprits: Vec<String>,
}

impl Slip {
    fn new(what: impl Into<String>, culprits: &[&str], change: impl Fn(&mut Observation) + 'static) -> Self {
        let culprits = culprits.iter().map(|c| (*c).to_owned()).collect();
        Self { what: what.into(), change: Box::new(change), culprits }
    }

    fn of_points(what: &str, culprits: &[&str], change: impl Fn(&mut Vector) + 'static) -> Self {
        Self::new(what, culprits, move |o| o.targets.iter_mut().flatten().for_each(&change))
    }
}

/// Slips in the joints: signs, pairs, offsets and units.
pub(super) fn slips_of_joints(bench: &Bench) -> Vec<Slip> {
    let joints = bench.robot.joints();
    let n = joints.len();
    let free = bench.robot.free_base().is_some();
    let name = |i: usize| format!("`{}`", joints[i].name);
    let turns = joints[0].quantity == Quantity::Angle;
    let mut all = Vec::new();
    for i in 0..n {
        let reversed = format!("{} reversed", name(i));
        all.push(Slip::new(&reversed, &[&reversed], move |o| o.joints[i] = -o.joints[i]));
        // an offset of the first joint is that of the base, of the last one that of the targets
        for deg in [90.0f64, 180.0].into_iter().filter(|_| turns && !(free && (i == 0 || i == n - 1))) {
            let by = [format!("deg added to {}", name(i)), format!("`theta_{}`", i + 1), format!("`delta{}`", i + 1)];
            let what = format!("{deg} deg off in {}", name(i));
            all.push(Slip::new(what, &by.each_ref().map(String::as_str), move |o| o.joints[i] += deg.to_radians()));
        }
        for j in i + 1..n {
            let exchanged = format!("{} and {} swapped", name(i), name(j));
            all.push(Slip::new(&exchanged, &[&exchanged], move |o| o.joints.swap(i, j)));
        }
    }
    let units = match turns {
        true => [
            ("degrees read as radians", "in degrees instead of radians", 1f64.to_degrees()),
            ("radians read as degrees", "in radians instead of degrees", 1f64.to_radians()),
        ],
        false => [
            ("joints: metres read as millimetres", "all joints in metres", 1e-3),
            ("joints: inches read as millimetres", "all joints in inches", 1.0 / 25.4),
        ],
    };
    for (what, culprit, factor) in units {
        all.push(Slip::new(what, &[culprit], move |o| o.joints[..n].iter_mut().for_each(|q| *q *= factor)));
    }
    all
}

/// Slips in the measured points: units, coordinates, handedness.
pub(super) fn slips_of_points(bench: &Bench) -> Vec<Slip> {
    let scale =
        |what: &str, culprit: &str, factor: f64| Slip::of_points(what, &[culprit], move |p| *p = p.map(|v| v * factor));
    let mut all = vec![
        scale("points: metres read as millimetres", "points in metres", 1e-3),
        scale("points: inches read as millimetres", "points in inches", 1.0 / 25.4),
        scale("points: millimetres read as inches", "points in millimetres instead of inches", 25.4),
    ];
    if bench.robot.dimension() == 3 {
        all.push(Slip::of_points("left-handed", &["mirrored"], |p| p[2] = -p[2]));
        all.push(Slip::of_points("x and y exchanged", &["mirrored"], |p| p.swap(0, 1)));
    } else {
        let exchanged = "x and y of the measured points swapped";
        all.push(Slip::of_points("x and y exchanged", &[exchanged], |p| p.swap(0, 1)));
        let reversed = ["x of the measured points reversed", "y of the measured points reversed"];
        all.push(Slip::of_points("x reversed", &reversed, |p| p[0] = -p[0]));
    }
    all
}

/// Robots whose table is wrong, each with what its message must contain.
fn wrong_tables(rows: &[[f64; 4]], targets: &[&str]) -> Vec<(String, Box<dyn Robot>, String)> {
    let mut link = rows.to_vec();
    link[3][1] += 100.0;
    let mut offset = rows.to_vec();
    offset[2][3] += 58.8;
    // the same arm by standard parameters: twist and length of the link behind the joint
    let mut standard = rows.to_vec();
    for (i, row) in standard.iter_mut().enumerate() {
        [row[0], row[1]] = rows.get(i + 1).map_or([0.0; 2], |next| [next[0], next[1]]);
    }
    [
        ("a_4 is 100 mm too long", link, "`a_4` = "),
        ("d_3 is 58.8 mm too long", offset, "`d_3` = "),
        ("standard parameters taken as modified ones", standard, "standard Denavit-Hartenberg"),
    ]
    .map(|(what, rows, named)| (what.to_owned(), Box::new(serial(&rows, targets, &[])) as _, named.to_owned()))
    .into()
}

/// Data in which something is wrong in places, and what a warning must contain.
pub(super) fn spoilt(bench: &Bench) -> Vec<(String, Vec<Observation>, Vec<String>)> {
    let mut all = Vec::new();
    let u_mm = bench.u_mm;
    let n = bench.observations.len();
    let pose = |k: usize| format!("pose {},", bench.observations[k].pose);
    let mut add = |what: &str, named: Vec<String>, how: &dyn Fn(&mut Vec<Observation>)| {
        let mut observations = bench.observations.clone();
        how(&mut observations);
        all.push((what.to_owned(), observations, named));
    };
    let off = |o: &mut Observation, by_mm: f64| {
        let target = o.targets[0].as_mut().unwrap();
        *target = [target[0] + by_mm, target[1], target[2]];
    };
    add("one reading is ten standard uncertainties off", vec![pose(7)], &|all| off(&mut all[7], 10.0 * u_mm));
    let rows: Vec<usize> = (0..n).step_by(20).map(|k| k + 3).filter(|k| *k < n).collect();
    let wrong = rows.iter().map(|&k| pose(k)).collect::<Vec<_>>();
    let last = vec![wrong.last().unwrap().clone()];
    add("5 % of the rows are 2 mm off", last, &|all| rows.iter().for_each(|&k| off(&mut all[k], 2.0)));
    if bench.observations[0].targets.len() > 1 {
        add("one label exchanged", vec![pose(9)], &|all| all[9].targets.swap(0, 1));
    }
    let next = (12..n).find(|&k| bench.observations[k].pose != bench.observations[k - 1].pose).unwrap();
    add("a stale row", vec!["[positions-repeat]".to_owned()], &|all| {
        all[next].targets = all[next - 1].targets.clone();
    });
    let moved = vec![format!("from pose {} on", bench.observations[n / 2].pose)];
    add("the frame moves by 1 mm half way", moved, &|all| {
        for o in &mut all[n / 2..] {
            o.targets.iter_mut().flatten().for_each(|p| *p = [p[0] + 1.0, p[1], p[2]]);
        }
    });
    // a base that is mounted, not free, and drawn lengths show what is beyond their own deviations
    if bench.robot.dimension() == 2 {
        add("a scale of 1.01", vec!["[common-scale]".to_owned()], &|all| {
            all.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(|p| *p = p.map(|v| 1.01 * v));
        });
    }
    add(
        "the log is shifted by one row",
        ["previous", "next"].map(|neighbour| phrase!("slip-neighbour", neighbour).to_string()).to_vec(),
        &|all| {
            for k in (1..n).rev() {
                all[k].joints = all[k - 1].joints.clone();
            }
        },
    );
    all
}

/// A set-up that is wrong, and what its messages must contain: one of these texts, and an error where it is to be refused.
struct Case<'a> {
    name: String,
    robot: &'a dyn Robot,
    observations: Vec<Observation>,
    u_mm: f64,
    culprits: Vec<String>,
    refused: bool,
}

#[test]
#[ignore = "a long law: make laws"]
fn wrong_set_ups_are_refused_by_name() {
    let cube = Some(([350.0, 0.0, 450.0], 300.0));
    let arms = [
        arm("seven axes", &SEVEN_AXES, &TARGETS[..1], 60, None),
        arm("six axes in a cube of 0.3 m", &SIX_AXES, &TARGETS, 40, cube),
    ];
    let planar = [prexyt(), dextar()];
    let measured = irb120();
    if measured.is_none() {
        crate::support::skipped("ETALON_REFERENCE");
    }
    let synthetic = || arms.iter().chain(&planar);
    let tables = [wrong_tables(&SEVEN_AXES, &TARGETS[..1]), wrong_tables(&SIX_AXES, &TARGETS)];

    let mut cases = Vec::new();
    for bench in synthetic().chain(&measured) {
        let right = messages(bench.robot.as_ref(), &bench.observations, bench.u_mm);
        assert!(!right.iter().any(is_error), "{}: {right:#?}", bench.name);
        let (robot, u_mm) = (bench.robot.as_ref(), bench.u_mm);
        for Slip { what, change, culprits } in slips_of_joints(bench).into_iter().chain(slips_of_points(bench)) {
            let mut observations = bench.observations.clone();
            observations.iter_mut().for_each(change);
            let name = format!("{}: {what}", bench.name);
            cases.push(Case { name, robot, observations, u_mm, culprits, refused: true });
        }
    }
    for (bench, wrong) in arms.iter().zip(&tables) {
        for (what, robot, culprit) in wrong {
            let (name, observations) = (format!("{}: {what}", bench.name), bench.observations.clone());
            let (robot, culprits) = (robot.as_ref(), vec![culprit.clone()]);
            cases.push(Case { name, robot, observations, u_mm: bench.u_mm, culprits, refused: true });
        }
    }
    for bench in synthetic() {
        let (robot, u_mm) = (bench.robot.as_ref(), bench.u_mm);
        for (what, observations, culprits) in spoilt(bench) {
            cases.push(Case {
                name: format!("{}: {what}", bench.name),
                robot,
                observations,
                u_mm,
                culprits,
                refused: false,
            });
        }
    }

    let tried: Vec<(bool, bool)> = cases.par_iter().map(try_case).collect();
    let named = tried.iter().filter(|(_, named)| *named).count();
    let silent: Vec<&str> =
        cases.iter().zip(&tried).filter(|(_, t)| !t.0).map(|(case, _)| case.name.as_str()).collect();
    println!("{named} of {} by name; passed in silence: {silent:#?}", cases.len());
    assert!(10 * named >= 9 * cases.len(), "{named} of {} by name", cases.len());
    assert!(silent.is_empty(), "{silent:#?}");
}

/// A six-axis arm of which joints 2 and 3 bend, while its model has no bending: what a residual field is for.
fn bent() -> Bench {
    let (bends, robot) = (serial(&SIX_AXES, &TARGETS[..1], &[2, 3]), serial(&SIX_AXES, &TARGETS[..1], &[]));
    let mut noise = Noise::new(16, 4);
    let mut truth = truth(&bends, &mut noise);
    for (value, parameter) in truth.iter_mut().zip(bends.parameters()) {
        if parameter.effect == Effect::Bending {
            *value = 1e-3;
        }
    }
    let u_mm = 0.02;
    let observation = |pose: i64| {
        let joints: Vec<f64> = SIX_AXES.iter().map(|_| noise.uniform(1.3)).collect();
        let seen = bends.position(&truth, &joints, 0).map(|v| v + noise.gaussian(u_mm));
        Observation { pose: pose.into(), cycle: 1, joints, targets: vec![Some(seen)], ..Observation::default() }
    };
    let observations = (1..=100).map(observation).collect();
    Bench { name: "six axes that bend", robot: Box::new(robot), observations, u_mm }
}

/// Messages of an identification, and the search for a field as in a run: an identification with an error searches none.
fn with_field(robot: &dyn Robot, observations: &[Observation], u_mm: f64) -> (Vec<Message>, Option<FieldTrial>) {
    let settings = Settings { standard_uncertainty_mm: Some(u_mm), ..Settings::default() };
    let sets = Sets { calibration: observations.to_vec(), ..Sets::default() };
    let solution = match Solution::new(robot, Basis { sets, settings: settings.clone(), ..Basis::default() }) {
        Ok(solution) => solution,
        Err(problems) => return (problems.0, None),
    };
    let said = messages_alone(robot, &solution);
    let trial = (!said.iter().any(is_error)).then(|| search_field(robot, observations, &settings, &solution.found));
    (said, trial)
}

#[test]
#[ignore = "a long law: make laws"]
fn a_residual_field_hides_no_wrong_set_up() {
    let bench = bent();
    let robot = bench.robot.as_ref();
    let (said, trial) = with_field(robot, &bench.observations, bench.u_mm);
    let trial = trial.expect("no error");
    assert!(trial.field.is_some(), "{said:#?}");
    // a wrong reading shows by what the model leaves of the others
    let left_mm = trial.held_out.expect("held-out poses").rms_mm[0] / 3f64.sqrt();
    let mut cases = spoilt(&Bench { u_mm: left_mm, ..bent() });
    for Slip { what, change, culprits } in slips_of_joints(&bench).into_iter().chain(slips_of_points(&bench)) {
        let mut observations = bench.observations.clone();
        observations.iter_mut().for_each(change);
        cases.push((what, observations, culprits));
    }
    let count = cases.len();
    let hidden = cases.into_par_iter().filter_map(|(what, observations, culprits)| {
        let (mut said, trial) = with_field(robot, &observations, bench.u_mm);
        let field = trial.and_then(|trial| trial.field);
        said.extend(stale(robot, &observations));
        let text: String = said.iter().map(|m| format!("{m}\n")).collect();
        let named = culprits.iter().any(|culprit| text.contains(culprit.as_str()));
        println!(
            "{what}: {}, {}",
            if named { "named" } else { "not named" },
            if field.is_some() { "field" } else { "no field" }
        );
        // an accepted field beside a slip that nothing names
        (field.is_some() && !named).then(|| format!("{what}\n{text}"))
    });
    let hidden: Vec<String> = hidden.collect();
    assert!(hidden.is_empty(), "{} of {count}: {hidden:#?}", hidden.len());
}

/// Whether a wrong set-up is refused, or warned about where that is enough, and whether by name.
fn try_case(case: &Case) -> (bool, bool) {
    let mut said = messages(case.robot, &case.observations, case.u_mm);
    said.extend(stale(case.robot, &case.observations));
    let text: String = said.iter().map(|m| format!("{m}\n")).collect();
    let named = case.culprits.iter().any(|culprit| text.contains(culprit.as_str()));
    if !named {
        println!("{}: not named as {:?}\n{text}", case.name, case.culprits);
    }
    (if case.refused { said.iter().any(is_error) } else { !said.is_empty() }, named)
}

fn is_error(message: &Message) -> bool {
    message.severity == Severity::Error
}
