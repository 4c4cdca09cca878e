//! Chapter 4: DexTAR, a five-bar robot on a plate of balls.

use crate::campaigns::{Changes, campaign, truth as sample_truth};
use crate::page::{Compared, Comparison, Entry, Spread, Verdict, exactly};
use crate::picture::{Form, Picture, Series};
use etalon::base::pose::Vector;
use etalon::identify::plan::{Choice, Criterion, Plan, Request, candidate_pool, plan};
use etalon::identify::{Observation, Settings, sensitivity};
use etalon::robots::{FiveBar, FiveBarLimits, Robot};
use etalon::simulate::study::{Draw, Frame, Landing, Study};
use etalon::simulate::{Interpolation, Unmodelled, true_values};
use rayon::prelude::*;
use std::collections::BTreeMap;

pub const ALL: &[(&str, fn(u64) -> Vec<Entry>)] = &[
    ("Figures 4.2, 4.5 to 4.9, tables 4.1 to 4.3", simulated_calibration),
    ("Tables 4.4 and 4.5, figure 4.12", experiments),
];

/// Nominal values of eq. 4.24 and table 4.1; limits of the working modes are our own rule (sample dextar).
fn robot() -> FiveBar {
    let radians = f64::to_radians;
    let limits = FiveBarLimits {
        clearance_mm: Some(0.0),
        type1_margin_rad: radians(5.0),
        type2_margin_rad: radians(25.0),
        ..FiveBarLimits::default()
    };
    FiveBar::default().with_limits(limits)
}

/// Names of the thesis' rows in the order of the model, and the decimals that it prints.
const NAMES: [&str; 12] = ["l11", "l12", "l21", "l22", "d", "l23", "γ", "δ1", "δ2", "x_O", "y_O", "φ"];
/// Table 4.1 in the order of the model: actual, conventional approach, ours.
const TABLE_4_1: [[f64; 3]; 12] = [
    [230.010, 230.0109, 230.0101],
    [230.110, 230.1099, 230.1088],
    [229.880, 229.8812, 229.8773],
    [230.403, 230.4045, 230.4013],
    [275.102, 275.1035, 275.1006],
    [230.210, 230.2119, 230.2111],
    [1.948, 1.9481, 1.9481],
    [1.306, 1.3063, 1.3063],
    [-0.401, -0.4011, -0.4011],
    [263.391, 263.3920, 263.3908],
    [75.499, 75.4987, 75.4990],
    [0.573, 0.5730, 0.5730],
];
const ERRORS: [&str; 6] = ["max", "RMS", "max x", "RMS x", "max y", "RMS y"];
/// Table 4.2, µm: conventional approach, ours.
const TABLE_4_2: [[f64; 6]; 2] = [[7.3, 2.8, 5.0, 1.8, 7.2, 2.1], [10.1, 3.4, 6.9, 2.3, 7.4, 2.6]];
/// Table 4.3, µm, three to seven positions: simulated maximum and RMS, experimental maximum and RMS.
const TABLE_4_3: [[f64; 4]; 5] = [
    [108.5, 24.2, 282.4, 135.6],
    [60.2, 7.0, 154.7, 77.1],
    [36.5, 6.2, 80.4, 44.5],
    [18.7, 4.9, 77.4, 43.5],
    [10.1, 3.4, 77.4, 42.2],
];

/// Joint values of the drawing for every working mode that reaches a position of the plate.
fn observe(robot: &FiveBar, positions: &[(usize, [f64; 2])]) -> Vec<Observation> {
    let nominal = robot.nominal();
    let mut all = Vec::new();
    for (pose, p) in positions {
        let at = [p[0], p[1], 0.0];
        for (mode, joints) in robot.inverse_all(&nominal, at).unwrap_or_default().into_iter().enumerate() {
            let pose = (*pose as i64).into();
            all.push(Observation {
                pose,
                cycle: mode as i64 + 1,
                joints,
                targets: vec![Some(at)],
                ..Observation::default()
            });
        }
    }
    all
}

/// The holes of the plate: 24 × 24 at 25.4 mm; whether one of the two outer rings.
fn holes() -> Vec<(usize, [f64; 2], bool)> {
    let outer = |i: usize| !(2..22).contains(&i);
    let hole =
        |(i, j): (usize, usize)| (24 * i + j, [25.4 * (i as f64 - 1.0), 25.4 * (j as f64 - 9.0)], outer(i) || outer(j));
    (0..24).flat_map(|i| (0..24).map(move |j| (i, j))).map(hole).collect()
}

/// Configurations by pose.
fn by_pose(all: &[Observation]) -> Vec<Vec<&Observation>> {
    let mut poses: BTreeMap<_, Vec<&Observation>> = BTreeMap::new();
    all.iter().for_each(|o| poses.entry(o.pose).or_default().push(o));
    poses.into_values().collect()
}

fn place(o: &Observation) -> [f64; 2] {
    o.targets[0].map_or([f64::NAN; 2], |p| [p[0], p[1]])
}

/// ± 30 µm of section 4.6, read as three standard deviations.
const NOISE_MM: f64 = 0.010;

fn settings() -> Settings {
    Settings { standard_uncertainty_mm: Some(NOISE_MM), ..Settings::default() }
}

/// The poses in the order in which the determinant grows fastest.
fn order(robot: &FiveBar, poses: &[Vec<&Observation>]) -> Vec<usize> {
    let all: Vec<Observation> = poses.iter().flatten().map(|o| (*o).clone()).collect();
    let mut first = 0;
    let members: Vec<Vec<usize>> = poses
        .iter()
        .map(|p| {
            first += p.len();
            (first - p.len()..first).collect()
        })
        .collect();
    let pool = candidate_pool(&sensitivity(robot, &all, &settings()).expect("sensitivity"), &members, Criterion::D);
    let mut order: Vec<usize> = Vec::new();
    while order.len() < poses.len() {
        let with = |i: &usize| Choice::new(&pool, [&order[..], &[*i]].concat()).value;
        let left = (0..poses.len()).filter(|i| !order.contains(i));
        order.extend(left.max_by(|a, b| with(a).total_cmp(&with(b))));
    }
    order
}

/// Maximum and RMS of position, of x and of y, µm, in the order of [`ERRORS`].
fn summary(errors: &[[f64; 2]]) -> [f64; 6] {
    let of = |f: &dyn Fn(&[f64; 2]) -> f64| {
        let (max, sum) = errors.iter().map(f).fold((0.0f64, 0.0), |(m, s), e| (m.max(e.abs()), s + e * e));
        [1e3 * max, 1e3 * (sum / errors.len() as f64).sqrt()]
    };
    let all = [of(&|e| e[0].hypot(e[1])), of(&|e| e[0]), of(&|e| e[1])];
    all.as_flattened().try_into().expect("six")
}

/// Everything that the simulated calibrations of sections 4.5 and 4.6 share.
struct Simulated {
    robot: FiveBar,
    truth: Vec<f64>,
    plate: Vec<Observation>,
    candidates: Vec<Observation>,
    conventional: Plan,
    ours: Plan,
    draws: u64,
}

impl Simulated {
    fn new(draws: u64) -> Self {
        let robot = robot();
        let model = robot.parameters();
        let truth = TABLE_4_1.iter().zip(model).map(|(row, p)| p.quantity.inward(row[0])).collect();
        let all: Vec<(usize, [f64; 2])> = holes().iter().map(|h| (h.0, h.1)).collect();
        let periphery: Vec<(usize, [f64; 2])> = holes().iter().filter(|h| h.2).map(|h| (h.0, h.1)).collect();
        let (plate, candidates) = (observe(&robot, &all), observe(&robot, &periphery));
        let request = |positions: usize, single: bool| Request {
            positions,
            criterion: Criterion::O1,
            single,
            start: Vec::new(),
            starts: Some(0),
            seed: 1,
            nodes: Some(0),
        };
        let conventional = plan(&robot, &plate, &settings(), &request(25, true), &|_, _| {}).expect("plan");
        let ours = plan(&robot, &candidates, &settings(), &request(7, false), &|_, _| {}).expect("plan");
        Self { robot, truth, plate, candidates, conventional, ours, draws }
    }

    /// The configurations that the thesis' way of choosing takes: one after the other, the best next one.
    fn chosen(&self, plan: &Plan, of: &[Observation]) -> Vec<Observation> {
        plan.greedy.iter().flat_map(|&c| plan.members[c].iter().map(|&k| of[k].clone())).collect()
    }

    fn draw(&self, chosen: &[Observation]) -> Option<Vec<Draw>> {
        let study = Study { robot: &self.robot, truth: &self.truth, settings: settings(), runs: 5, seed: 46 };
        study.draws(chosen, NOISE_MM, self.draws).ok()
    }

    /// True position in the world minus commanded, with the pose of each.
    fn errors(&self, identified: &[f64]) -> Vec<(usize, [f64; 2])> {
        let poses = by_pose(&self.plate);
        let landing = |o: &Observation| Landing::new(&self.robot, &self.truth, identified, Frame::World, &o.joints);
        let one = |(i, o): (usize, &&Observation)| Some((i, landing(o).map(|l| [l.error_mm[0], l.error_mm[1]])?));
        poses.iter().enumerate().flat_map(|(i, p)| p.iter().map(move |o| (i, o))).filter_map(one).collect()
    }

    fn summaries(&self, drawn: &[Draw]) -> Vec<[f64; 6]> {
        let one = |d: &Draw| summary(&self.errors(&d.mean).into_iter().map(|e| e.1).collect::<Vec<_>>());
        drawn.par_iter().map(one).collect()
    }
}

fn names(columns: &[&str]) -> Vec<String> {
    columns.iter().map(|c| (*c).to_owned()).collect()
}

fn exact(printed: Option<f64>, ours: f64, digits: usize) -> Compared {
    Compared { printed, ours: exactly(ours), digits }
}

fn simulated_calibration(draws: u64) -> Vec<Entry> {
    let s = Simulated::new(draws);
    let conventional = s.draw(&s.chosen(&s.conventional, &s.plate)).expect("identified");
    let chosen = s.chosen(&s.ours, &s.candidates);
    let ours = s.draw(&chosen).expect("identified");
    let both = [conventional, ours];
    let mut entries = planned(&s);
    entries.extend(table_4_1(&s, &both));
    entries.extend(table_4_2(&s, &both));
    entries.push(table_4_3(&s, &chosen));
    entries
}

const MODES: &str = "the text has the numbers of working modes, not what limits them: links that do not cross and margins of 5° and 25° to singularities are our \
    rule, and the plate's place on the robot is that of table 4.1";

fn planned(s: &Simulated) -> Vec<Entry> {
    let modes = |plate: &[Observation], count: usize| {
        by_pose(plate).iter().filter(|p| p.len() == count).map(|p| place(p[0])).collect::<Vec<_>>()
    };
    let marks = |name: &str, points: Vec<[f64; 2]>| Series { name: name.into(), points, form: Form::Marks };
    let map = |title: &str, series: Vec<Series>| {
        Picture { title: title.into(), across: "x, mm", up: "y, mm", equal: true, series }.svg()
    };
    let count = |n: usize| modes(&s.plate, n).len() as f64;
    let row = |name: &str, cell: Compared| (name.to_owned(), vec![cell]);
    let table = |rows: Vec<(String, Vec<Compared>)>| Comparison {
        columns: names(&["count"]),
        rows,
        judged: true,
        ..Comparison::default()
    };
    let entry = |title, how: &str, comparisons, figures, statements, expected| Entry {
        title,
        how: how.into(),
        comparisons,
        figures,
        statements,
        expected,
    };
    let grid = entry(
        "Figure 4.2, working grid positions",
        "Holes of the plate (24 × 24 at 25.4 mm) by the number of working modes that reach them.",
        vec![table(vec![
            row("positions reached", exact(Some(524.0), count(2) + count(3) + count(4), 0)),
            row("with two configurations", exact(Some(177.0), count(2), 0)),
            row("with three", exact(Some(269.0), count(3), 0)),
            row("with four", exact(Some(78.0), count(4), 0)),
            row("configurations", exact(Some(1473.0), s.plate.len() as f64, 0)),
        ])],
        vec![map("Working modes", [2, 3, 4].map(|n| marks(&format!("{n} modes"), modes(&s.plate, n))).into())],
        Vec::new(),
        Verdict::Differs(MODES),
    );
    let candidates = by_pose(&s.candidates).len() as f64;
    let candidates = entry(
        "Figure 4.5, candidate positions",
        "The two outer rings of holes, in all working modes.",
        vec![table(vec![row("candidates", exact(Some(141.0), candidates, 0))])],
        vec![map(
            "Candidates",
            vec![marks("candidates", by_pose(&s.candidates).iter().map(|p| place(p[0])).collect())],
        )],
        Vec::new(),
        Verdict::Differs(MODES),
    );
    let curve = |plan: &Plan, f: &dyn Fn(&etalon::identify::plan::Step) -> f64| {
        plan.curve.iter().map(|c| [c.configurations as f64, f(c)]).collect::<Vec<_>>()
    };
    let lines = |title: &str, up: &'static str, f: &dyn Fn(&etalon::identify::plan::Step) -> f64| {
        let line = |name: &str, plan: &Plan| Series { name: name.into(), points: curve(plan, f), form: Form::Line };
        let series = vec![line("all modes of a position", &s.ours), line("one by one", &s.conventional)];
        Picture { title: title.into(), across: "configurations", up, equal: false, series }.svg()
    };
    let at =
        |plan: &Plan, least: usize| plan.curve.iter().find(|c| c.configurations >= least).map_or(f64::NAN, |c| c.index);
    // a tenth of the first gain, as the figure cannot be read from the text
    let flat = |plan: &Plan| (at(plan, 32) / at(plan, 25) - 1.0).abs() < 0.05;
    let observability = entry(
        "Figure 4.6, observability index and condition number",
        "O1 and condition number of the scaled Jacobian while poses are added one by one as in section 4.5; the values are in the figure alone, what the text says of \
         them is judged.",
        Vec::new(),
        vec![lines("Observability index O1", "O1", &|c| c.index), lines("Condition number", "condition", &|c| c.condition)],
        vec![
            ("after about 25 configurations the index changes little (less than 5 % up to 32), all modes of a position".into(), flat(&s.ours)),
            ("the same, one by one".into(), flat(&s.conventional)),
            ("choosing one by one has the slightly better index at 25 configurations".into(), at(&s.conventional, 25) > at(&s.ours, 25)),
        ],
        Verdict::Agrees,
    );
    let positions = |chosen: &[Observation]| by_pose(chosen).iter().map(|p| place(p[0])).collect::<Vec<_>>();
    let (one_by_one, grouped) = (s.chosen(&s.conventional, &s.plate), s.chosen(&s.ours, &s.candidates));
    let chosen = entry(
        "Figure 4.7, calibration positions",
        "Chosen by the thesis' way; places are in the figure alone.",
        vec![Comparison {
            columns: names(&["all modes of a position", "one by one"]),
            rows: vec![
                (
                    "positions".into(),
                    vec![
                        exact(Some(7.0), positions(&grouped).len() as f64, 0),
                        exact(Some(20.0), positions(&one_by_one).len() as f64, 0),
                    ],
                ),
                (
                    "configurations".into(),
                    vec![exact(Some(25.0), grouped.len() as f64, 0), exact(Some(25.0), one_by_one.len() as f64, 0)],
                ),
            ],
            judged: true,
            ..Comparison::default()
        }],
        vec![map(
            "Chosen positions",
            vec![marks("all modes", positions(&grouped)), marks("one by one", positions(&one_by_one))],
        )],
        Vec::new(),
        Verdict::Differs(MODES),
    );
    vec![grid, candidates, observability, chosen]
}

const READING: &str = "Noise of ± 30 µm is read as three standard deviations of each coordinate, parameters are the mean of five identifications; positions are chosen by \
    the thesis' way among ours.";

fn table_4_1(s: &Simulated, both: &[Vec<Draw>; 2]) -> [Entry; 2] {
    let model = s.robot.parameters();
    let row = |i: usize| {
        let cell = |k: usize| Compared {
            printed: Some(TABLE_4_1[i][k + 1]),
            ours: Spread::new(both[k].iter().map(|d| model[i].quantity.outward(d.mean[i]))),
            digits: 4,
        };
        (format!("{}, {} (actual {:.3})", NAMES[i], model[i].quantity.unit(), TABLE_4_1[i][0]), vec![cell(0), cell(1)])
    };
    let error = |i: usize, k: usize| {
        let outward = |v: f64| model[i].quantity.outward(v).abs();
        let ours = Spread::new(both[k].iter().map(|d| outward(d.mean[i] - s.truth[i])));
        Compared {
            printed: Some((TABLE_4_1[i][k + 1] - TABLE_4_1[i][0]).abs()),
            ours: Spread { low: 0.0, ..ours },
            digits: 4,
        }
    };
    let series = |k: usize, name: &str| Series {
        name: name.into(),
        points: (0..12).map(|i| [i as f64, 1e3 * error(i, k).ours.median]).collect(),
        form: Form::Bars,
    };
    let picture = Picture {
        title: format!("Errors of {} (0 to 11), medians", NAMES.join(", ")),
        across: "parameter",
        up: "µm, 0.001 deg",
        equal: false,
        series: vec![series(1, "all modes of a position"), series(0, "one by one")],
    };
    let columns = names(&["conventional approach", "our approach"]);
    let parameters = Entry {
        title: "Table 4.1, identified parameters of simulated calibrations",
        how: READING.into(),
        comparisons: vec![Comparison {
            columns: columns.clone(),
            rows: (0..12).map(row).collect(),
            judged: true,
            ..Comparison::default()
        }],
        figures: Vec::new(),
        statements: Vec::new(),
        expected: Verdict::Agrees,
    };
    let errors = Entry {
        title: "Figure 4.8, errors of the identified parameters",
        how: format!("Identified minus actual of table 4.1, by size, mm and deg. {READING}"),
        comparisons: vec![Comparison {
            columns,
            rows: (0..12).map(|i| (NAMES[i].to_owned(), vec![error(i, 0), error(i, 1)])).collect(),
            judged: true,
            ..Comparison::default()
        }],
        figures: vec![picture.svg()],
        statements: Vec::new(),
        expected: Verdict::Agrees,
    };
    [parameters, errors]
}

fn table_4_2(s: &Simulated, both: &[Vec<Draw>; 2]) -> [Entry; 2] {
    let summaries = [s.summaries(&both[0]), s.summaries(&both[1])];
    let cell = |k: usize, e: usize| Compared {
        printed: Some(TABLE_4_2[k][e]),
        ours: Spread::new(summaries[k].iter().map(|v| v[e])),
        digits: 1,
    };
    let columns = names(&["conventional approach", "our approach"]);
    let worst = |k: usize| -> Vec<[f64; 2]> {
        let mut largest: BTreeMap<usize, f64> = BTreeMap::new();
        for (pose, e) in s.errors(&both[k][0].mean) {
            let worst = largest.entry(pose).or_default();
            *worst = worst.max(1e3 * e[0].hypot(e[1]));
        }
        largest.into_iter().map(|(pose, e)| [pose as f64, e]).collect()
    };
    let picture = Picture {
        title: "Largest error of each position among its working modes, first draw".into(),
        across: "position",
        up: "µm",
        equal: false,
        series: vec![
            Series { name: "all modes of a position".into(), points: worst(1), form: Form::Marks },
            Series { name: "one by one".into(), points: worst(0), form: Form::Marks },
        ],
    };
    let how = format!(
        "The error is the true position in the world minus the commanded one, over all positions of the plate and all working modes, the controller computing with the \
         identified parameters; that of the world frame is in it. {READING}"
    );
    let table = Entry {
        title: "Table 4.2, errors of position after simulated calibration",
        how: how.clone(),
        comparisons: vec![Comparison {
            caption: "µm, printed | ours".into(),
            columns: columns.clone(),
            rows: (0..6).map(|e| (ERRORS[e].to_owned(), vec![cell(0, e), cell(1, e)])).collect(),
            judged: true,
        }],
        figures: Vec::new(),
        statements: Vec::new(),
        expected: Verdict::Agrees,
    };
    let figure = Entry {
        title: "Figure 4.9, position accuracy after simulated calibration",
        how: format!("{how} Of the figure the text has the largest value."),
        comparisons: vec![Comparison {
            columns,
            rows: vec![("max, µm".into(), vec![cell(0, 0), cell(1, 0)])],
            judged: true,
            ..Comparison::default()
        }],
        figures: vec![picture.svg()],
        statements: Vec::new(),
        expected: Verdict::Agrees,
    };
    [table, figure]
}

fn table_4_3(s: &Simulated, chosen: &[Observation]) -> Entry {
    let poses = by_pose(chosen);
    let order = order(&s.robot, &poses);
    let row = |count: usize| {
        let measured: Vec<Observation> = order[..count].iter().flat_map(|&p| &poses[p]).map(|o| (*o).clone()).collect();
        let summaries = s.draw(&measured).map(|drawn| s.summaries(&drawn)).unwrap_or_default();
        let cell = |e: usize| Compared {
            printed: Some(TABLE_4_3[count - 3][e]),
            ours: Spread::new(summaries.iter().map(|v| v[e])),
            digits: 1,
        };
        (format!("{count}"), vec![cell(0), cell(1)])
    };
    let rows: Vec<(String, Vec<Compared>)> = (3..=7).map(row).collect();
    let falls = rows.windows(2).all(|w| w[1].1[1].ours.median <= w[0].1[1].ours.median);
    Entry {
        title: "Table 4.3, errors by the number of calibration positions",
        how: format!(
            "The simulated columns; the experimental ones are with table 4.5. Positions are added in the order in which the determinant grows fastest. {READING}"
        ),
        comparisons: vec![Comparison {
            caption: "µm, printed | ours".into(),
            columns: names(&["max", "RMS"]),
            rows,
            judged: true,
        }],
        figures: Vec::new(),
        statements: vec![("each further position makes the RMS error smaller".into(), falls)],
        expected: Verdict::Differs(
            "it is another seven positions, added in another order: P1 to P7 are in figure 4.7 alone. Ours determine the robot better with few positions",
        ),
    }
}

/// Table 4.4 in the order of the model: five balls and seven, each mean and three standard deviations.
const TABLE_4_4: [[f64; 4]; 12] = [
    [229.7016, 0.0098, 229.7063, 0.0082],
    [229.8903, 0.0112, 229.8971, 0.0096],
    [229.8513, 0.0099, 229.8540, 0.0078],
    [229.7530, 0.0153, 229.7552, 0.0144],
    [274.7998, 0.0041, 274.8051, 0.0052],
    [230.1699, 0.0097, 230.1718, 0.0086],
    [0.0229, 0.0010, 0.0217, 0.0009],
    [-0.0630, 0.0017, -0.0625, 0.0018],
    [0.2406, 0.0037, 0.2399, 0.0017],
    [264.0150, 0.0230, 263.0115, 0.0121],
    [74.5845, 0.0029, 74.5904, 0.0058],
    [-0.3667, 0.0019, -0.3655, 0.0018],
];
/// Table 4.5, µm: before, five balls, seven balls.
const TABLE_4_5: [[f64; 6]; 3] = [
    [3288.0, 1467.0, 1848.0, 888.0, 2934.0, 1171.0],
    [80.4, 44.5, 79.7, 34.7, 63.4, 27.9],
    [77.4, 42.2, 75.6, 32.8, 56.9, 26.6],
];

/// A ball of the sample: where it is, and its configurations by the numbers of their poses.
struct Ball {
    at_mm: Vector,
    poses: Vec<(i64, Vec<f64>)>,
}

fn balls(robot: &FiveBar) -> Vec<Ball> {
    let truth = sample_truth("dextar");
    let mut number = 0;
    let mut ball = |poses: &etalon::simulate::Poses| {
        let label = poses.label.as_deref().expect("label");
        let inward = |q: &Vec<f64>| -> Vec<f64> {
            q.iter().enumerate().map(|(i, q)| robot.joints().get(i).map_or(*q, |j| j.quantity.inward(*q))).collect()
        };
        let poses = poses.joints.iter().map(|q| {
            number += 1;
            (number, inward(q))
        });
        Ball { poses: poses.collect(), at_mm: truth.points.iter().find(|p| p.label == label).expect("point").at_mm }
    };
    truth.poses.iter().map(&mut ball).collect()
}

/// Parameters, and mean errors of the validation poses (mm) by pose, of one synthetic campaign.
type Found = (Vec<f64>, BTreeMap<i64, [f64; 2]>);

/// What no parameter of the synthetic robot describes: angles that are wrong by a wave, of another period in every draw. Its amplitude is
/// chosen so that the RMS of the seven balls comes out about as printed.
fn wave(draw: u64) -> Unmodelled {
    let wave = Interpolation { amplitude: 0.009, period: 12.0 + 0.7 * draw as f64 };
    let both = ["theta1", "theta2"].map(|joint| (joint.to_owned(), wave));
    Unmodelled { interpolation: BTreeMap::from(both), ..Unmodelled::default() }
}

fn experiment(selection: &str, cycles: i64, seed: u64) -> Found {
    let calibration = format!("calibration = \"{selection}\"");
    let changes = Changes {
        campaign: vec![("calibration = \"1-24\"", &calibration)],
        cycles: Some(cycles),
        unmodelled: Some(wave(seed / 5)),
        once: Some(("exports/plate.txt", 1 + seed / 5)),
    };
    campaign("dextar", &changes, 50_000 + seed, |_, found| {
        let found = found.results.identified.as_ref().expect("identified");
        let mut means: BTreeMap<i64, [f64; 2]> = BTreeMap::new();
        for e in found.errors.iter().filter(|e| e.set == etalon::documents::PoseSet::Validation) {
            let mean = means.entry(e.pose.number().expect("number")).or_default();
            [0, 1].iter().for_each(|&k| mean[k] += e.after_mm[k] / cycles as f64);
        }
        (found.parameters.parameters.iter().map(|p| p.value).collect(), means)
    })
}

/// Errors with the nominal parameters, base included, at the encoder values that bring the true robot to each validation ball.
fn before(robot: &FiveBar, balls: &[Ball]) -> Vec<(usize, [f64; 2])> {
    let truth = true_values(robot, &sample_truth("dextar").parameters).expect("parameters");
    let mut all = Vec::new();
    for (i, ball) in balls.iter().enumerate().skip(7) {
        for (_, joints) in &ball.poses {
            let q = Robot::inverse(robot, &truth, joints, ball.at_mm).expect("reached");
            let at = robot.position(&robot.nominal(), &q, 0);
            all.push((i, [ball.at_mm[0] - at[0], ball.at_mm[1] - at[1]]));
        }
    }
    all
}

fn experiments(draws: u64) -> Vec<Entry> {
    let robot = robot();
    let balls = balls(&robot);
    let calibration: Vec<Observation> = balls[..7]
        .iter()
        .flat_map(|b| b.poses.iter().map(move |(number, q)| (b, number, q)))
        .map(|(b, number, joints)| Observation {
            pose: (*number).into(),
            cycle: 1,
            joints: joints.clone(),
            targets: vec![Some(b.at_mm)],
            ..Observation::default()
        })
        .collect();
    let of_ball = |b: &Ball| calibration.iter().filter(|o| b.poses.iter().any(|p| o.pose == p.0)).collect::<Vec<_>>();
    let order = order(&robot, &balls[..7].iter().map(of_ball).collect::<Vec<_>>());
    let selection = |count: usize| {
        let numbers = order[..count].iter().flat_map(|&b| balls[b].poses.iter().map(|p| p.0.to_string()));
        numbers.collect::<Vec<_>>().join(",")
    };
    let draws = draws.min(40);
    let repeated = |count: usize| -> Vec<Vec<Found>> {
        let five = |draw: u64| (0..5).map(|run| experiment(&selection(count), 1, 5 * draw + run)).collect();
        (0..draws).into_par_iter().map(five).collect()
    };
    let whole = |count: usize| -> Vec<Found> {
        (0..draws).into_par_iter().map(|d| experiment(&selection(count), 5, 5 * d)).collect()
    };
    let by_count: Vec<Vec<Found>> = (3..=7).map(whole).collect();
    let mut entries = vec![table_4_4(&robot, &[repeated(5), repeated(7)])];
    entries.extend(table_4_5(&robot, &balls, &by_count));
    entries
}

const SYNTHETIC: &str = "Synthetic: campaigns of the sample dextar, whose truth are the parameters identified with seven balls (table 4.4). The plate is measured once by the CMM \
    (2.7 µm, k = 2), contacts repeat within ± 15 µm (three standard deviations). Places of the balls are ours. What no parameter \
    describes is a wave of ± 0.009° in both encoders, of another period in every draw, whose amplitude is chosen so that the RMS of the seven balls comes out.";

fn table_4_4(robot: &FiveBar, runs: &[Vec<Vec<Found>>; 2]) -> Entry {
    let three_sigma = |five: &[Found], i: usize| {
        let mean = five.iter().map(|f| f.0[i]).sum::<f64>() / five.len() as f64;
        3.0 * (five.iter().map(|f| (f.0[i] - mean).powi(2)).sum::<f64>() / (five.len() - 1) as f64).sqrt()
    };
    let row = |i: usize| {
        let cell = |k: usize| Compared {
            printed: Some(TABLE_4_4[i][2 * k + 1]),
            ours: Spread::new(runs[k].iter().map(|five| three_sigma(five, i))),
            digits: 4,
        };
        (format!("{}, {}", NAMES[i], robot.parameters()[i].quantity.unit()), vec![cell(0), cell(1)])
    };
    Entry {
        title: "Table 4.4, repeated experimental calibrations",
        how: format!(
            "{SYNTHETIC} Three standard deviations over five calibrations with the same plate; the means come out by construction. The printed x_O of five balls, 264.0150, is a slip of 1 mm."
        ),
        comparisons: vec![Comparison {
            caption: "Three standard deviations, printed | ours".into(),
            columns: names(&["five balls", "seven balls"]),
            rows: (0..12).map(row).collect(),
            judged: true,
        }],
        figures: Vec::new(),
        statements: Vec::new(),
        expected: Verdict::Differs(
            "contacts that repeat within ± 15 µm make half of the printed scatter of l12, l22, l23, δ1 and δ2, and a third of that of x_O: something else changed \
             between the five calibrations",
        ),
    }
}

fn table_4_5(robot: &FiveBar, balls: &[Ball], by_count: &[Vec<Found>]) -> [Entry; 3] {
    let before = before(robot, balls);
    let before_all: Vec<[f64; 2]> = before.iter().map(|e| e.1).collect();
    let after = |count: usize| -> Vec<[f64; 6]> {
        by_count[count - 3].iter().map(|f| summary(&f.1.values().copied().collect::<Vec<_>>())).collect()
    };
    let (five, seven) = (after(5), after(7));
    let spread = |all: &[[f64; 6]], e: usize| Spread::new(all.iter().map(|s| s[e]));
    let nominal = summary(&before_all);
    let row = |e: usize| {
        let cells = [exactly(nominal[e]), spread(&five, e), spread(&seven, e)];
        (
            ERRORS[e].to_owned(),
            cells
                .into_iter()
                .enumerate()
                .map(|(k, ours)| Compared { printed: Some(TABLE_4_5[k][e]), ours, digits: if k == 0 { 0 } else { 1 } })
                .collect(),
        )
    };
    let by_number = |count: usize| {
        let all = after(count);
        let cell = |e: usize| Compared { printed: Some(TABLE_4_3[count - 3][e + 2]), ours: spread(&all, e), digits: 1 };
        (count.to_string(), vec![cell(0), cell(1)])
    };
    let number = |b: &Ball| b.poses.iter().map(|p| p.0).collect::<Vec<_>>();
    let largest = |errors: &dyn Fn(usize, &Ball) -> Vec<f64>| -> Vec<[f64; 2]> {
        balls
            .iter()
            .enumerate()
            .skip(7)
            .map(|(i, b)| [i as f64 + 1.0, errors(i, b).into_iter().fold(0.0, f64::max)])
            .collect()
    };
    let found = |count: usize| {
        let one = &by_count[count - 3][0].1;
        largest(&|_, b| number(b).iter().filter_map(|n| one.get(n)).map(|e| 1e3 * e[0].hypot(e[1])).collect())
    };
    let nominal_largest =
        largest(&|i, _| before.iter().filter(|e| e.0 == i).map(|e| 1e3 * e.1[0].hypot(e.1[1])).collect());
    let picture = |title: &str, series: Vec<Series>| {
        Picture { title: title.into(), across: "ball", up: "µm", equal: false, series }.svg()
    };
    let bars = |name: &str, points: Vec<[f64; 2]>| Series { name: name.into(), points, form: Form::Bars };
    let why = "what the robot has beside its twelve parameters is unknown, and so are the places of its balls: the errors before calibration depend on these";
    let error = "The error is the ball's place in the world minus the one that the parameters predict from the encoders, mean of five contacts; before, base and all parameters are nominal.";
    let entry = |title, comparisons, figures| Entry {
        title,
        how: format!("{SYNTHETIC} {error}"),
        comparisons,
        figures,
        statements: Vec::new(),
        expected: Verdict::Differs(why),
    };
    let counted = Comparison {
        caption: "µm, printed | ours, by the number of balls".into(),
        columns: names(&["max", "RMS"]),
        rows: (3..=7).map(by_number).collect(),
        judged: true,
    };
    let table = Comparison {
        caption: "µm, printed | ours".into(),
        columns: names(&["before", "five balls", "seven balls"]),
        rows: (0..6).map(row).collect(),
        judged: true,
    };
    let worst = Comparison {
        caption: "µm, printed | ours".into(),
        columns: names(&["before", "five balls", "seven balls"]),
        rows: vec![row(0)],
        judged: true,
    };
    [
        entry("Table 4.3 (experimental), errors by the number of balls", vec![counted], Vec::new()),
        entry("Table 4.5, errors before and after calibration", vec![table], Vec::new()),
        entry(
            "Figure 4.12, largest error of each validation position",
            vec![worst],
            vec![
                picture("Before calibration", vec![bars("before", nominal_largest)]),
                picture(
                    "After calibration, one draw",
                    vec![bars("seven balls", found(7)), bars("five balls", found(5))],
                ),
            ],
        ),
    ]
}
