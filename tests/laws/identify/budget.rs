//! The uncertainty budget: each contribution is what the source does to an identification that is made again.

use crate::support::arms::{SIX_AXES, serial};
use etalon::base::noise::Noise;
use etalon::base::pose::{Vector, minus, norm};
use etalon::identify::{
    ErrorKind, Figure, FrameError, Identification, JudgedErrors, Observation, Settings, Systematic,
    UncertaintySource as Source, identify_with, refit_frames,
};
use etalon::robots::{Prexyt, Quantity, Robot};

const U_MM: f64 = 0.002;

/// A robot with a truth beside its nominal parameters, poses to calibrate and others to validate.
struct Case {
    robot: Box<dyn Robot>,
    truth: Vec<f64>,
    calibration: Vec<Vec<f64>>,
    validation: Vec<Vec<f64>>,
}

fn cases() -> [Case; 2] {
    let case = |robot: Box<dyn Robot>, poses: usize, q: &dyn Fn(&mut Noise) -> Vec<f64>| {
        let mut noise = Noise::new(5, 1);
        let off = |quantity| match quantity {
            Quantity::Length => 0.3,
            Quantity::Angle => 2e-3,
            Quantity::Ratio => 1e-3,
        };
        let truth = robot.parameters().iter().map(|p| p.nominal + noise.gaussian(off(p.quantity))).collect();
        let mut of = |n: usize| (0..n).map(|_| q(&mut noise)).collect();
        Case { truth, calibration: of(poses), validation: of(20), robot }
    };
    let between =
        |noise: &mut Noise, low: f64, high: f64| low + (high - low) * (0.5 + noise.gaussian(0.25)).clamp(0.0, 1.0);
    let slide = move |n: &mut Noise| vec![between(n, 0.0, 170.0), between(n, 50.0, 250.0), between(n, 50.0, 250.0)];
    let turn = move |n: &mut Noise| (0..6).map(|_| between(n, -1.2, 1.2)).collect();
    [case(Box::<Prexyt>::default(), 24, &slide), case(Box::new(serial(&SIX_AXES, &["one", "two"], &[])), 40, &turn)]
}

impl Case {
    /// Targets as the true robot has them, after a common error of the joints, scaled, each moved by `off`.
    fn measure(&self, poses: &[Vec<f64>], shift: &[f64], scale: f64, mut off: impl FnMut() -> f64) -> Vec<Observation> {
        let of = |(i, q): (usize, &Vec<f64>)| {
            let mut target = |k: usize| {
                let at = self.robot.position(&self.truth, q, k);
                let moved: Vector = at.map(|v| (v + off()) * (1.0 + scale));
                Some(if self.robot.dimension() == 2 { [moved[0], moved[1], 0.0] } else { moved })
            };
            Observation {
                pose: (i as i64).into(),
                cycle: 1,
                targets: (0..self.robot.targets().len()).map(&mut target).collect(),
                joints: q.iter().zip(shift).map(|(q, shift)| q + shift).collect(),
                ..Observation::default()
            }
        };
        poses.iter().enumerate().map(of).collect()
    }

    fn identify(&self, observations: &[Observation], systematic: &Systematic) -> Identification {
        identify_with(self.robot.as_ref(), observations, &settings(), &self.robot.nominal(), systematic)
            .expect("identified")
    }

    /// Mean, root mean square and largest error of validation poses.
    fn figures(&self, observations: &[Observation], values: &[f64]) -> [f64; 3] {
        let error = |o: &Observation| -> Vec<f64> {
            if let Some(platform) = self.robot.platform() {
                let [k, l] = [0, 1].map(|i| o.targets[i].map(|p| [p[0], p[1]]).expect("measured"));
                let e = platform.pose_error(values, &o.joints, [k, l]);
                return vec![e[0].hypot(e[1])];
            }
            let of = |(k, t): (usize, &Option<Vector>)| {
                norm(minus(t.expect("measured"), self.robot.position(values, &o.joints, k)))
            };
            o.targets.iter().enumerate().map(of).collect()
        };
        let all: Vec<f64> = observations.iter().flat_map(error).collect();
        let n = all.len() as f64;
        let rms = (all.iter().map(|e| e * e).sum::<f64>() / n).sqrt();
        [all.iter().sum::<f64>() / n, rms, all.iter().copied().fold(0.0, f64::max)]
    }
}

/// Variances of mean, root mean square and maximum of the position errors of validation poses.
fn figure_budgets(
    case: &Case,
    calibration: &[Observation],
    validation: &[Observation],
    found: &Identification,
    systematic: &Systematic,
) -> Vec<(Figure, Vec<(Source, f64)>)> {
    let errors = JudgedErrors {
        robot: case.robot.as_ref(),
        values: &found.values,
        set_up: &found.set_up_parameters(case.robot.as_ref()),
        calibration,
        observations: validation,
        conditions: &[],
        position_mm: None,
    };
    let all = errors.figures(&settings(), systematic).unwrap();
    let positions = all.into_iter().filter(|f| f.kind == ErrorKind::Position);
    positions.map(|f| (f.figure, f.contributions)).collect()
}

fn settings() -> Settings {
    Settings { standard_uncertainty_mm: Some(U_MM), ..Settings::default() }
}

/// The standard uncertainty by one source.
fn of(contributions: &[(Source, f64)], source: Source) -> f64 {
    contributions.iter().find(|c| c.0 == source).map_or(0.0, |c| c.1.sqrt())
}

/// What the parts of the error of validation poses are that no parameter explains, so that figures are smooth functions of the rest.
fn wave(seed: u64) -> impl FnMut() -> f64 {
    let mut noise = Noise::new(9, seed);
    move || noise.gaussian(0.05)
}

#[test]
fn common_errors_contribute_what_they_change_in_an_identification_that_is_made_again() {
    for case in cases() {
        let joints = case.robot.joints();
        // small beside the differences of errors: the same pose has the largest one
        let u_joint: Vec<f64> =
            joints.iter().map(|j| if j.quantity == Quantity::Angle { 2e-7 } else { 2e-5 }).collect();
        let systematic = Systematic { scale: 1e-6, expansion: 3e-6, homing: u_joint.clone(), ..Systematic::default() };
        let none = vec![0.0; joints.len()];
        let exact = case.identify(&case.measure(&case.calibration, &none, 0.0, || 0.0), &systematic);
        let run = |shift: &[f64], scale: f64| {
            let calibration = case.measure(&case.calibration, shift, scale, || 0.0);
            let found = case.identify(&calibration, &systematic);
            // figures judge the parameters of the robot: base and targets are measured with the error
            let judged = refit_frames(case.robot.as_ref(), &calibration, &settings(), &exact.values).unwrap();
            let figures = case.figures(&case.measure(&case.validation, shift, scale, wave(1)), &judged);
            (found, figures)
        };
        let found = run(&none, 0.0).0;
        let validation = case.measure(&case.validation, &none, 0.0, wave(1));
        let calibration = case.measure(&case.calibration, &none, 0.0, || 0.0);
        let budgets = figure_budgets(&case, &calibration, &validation, &found, &systematic);
        // differences of both signs: budgets are linear, figures have terms of second order
        let scaled = [1e-6, -1e-6].map(|scale| run(&none, scale));
        let shifted: Vec<_> = (0..joints.len())
            .map(|j| {
                [1.0, -1.0].map(|sign| {
                    let mut shift = none.clone();
                    shift[j] = sign * u_joint[j];
                    run(&shift, 0.0)
                })
            })
            .collect();
        for (k, &i) in found.free.iter().enumerate() {
            let parts = found.uncertainty.budget.parameter_contributions(k);
            let total: f64 = parts.iter().map(|p| p.1).sum();
            let u = found.standard_uncertainty(i).unwrap();
            assert!((total.sqrt() / u - 1.0).abs() < 1e-9, "{}", case.robot.parameters()[i].name);
            let half = |[a, b]: &[(Identification, [f64; 3]); 2]| 0.5 * (a.0.values[i] - b.0.values[i]);
            let by_scale = half(&scaled).abs();
            let by_homing = shifted.iter().map(|s| half(s).powi(2)).sum::<f64>().sqrt();
            let near = |a: f64, b: f64, what: &str| {
                assert!((a - b).abs() < 2e-3 * b + 1e-3 * u, "{what} {}: {a} {b} {u}", case.robot.parameters()[i].name);
            };
            near(of(&parts, Source::Scale), by_scale, "scale");
            near(of(&parts, Source::Temperature), 3.0 * by_scale, "temperature");
            near(of(&parts, Source::Homing), by_homing, "homing");
        }
        for (f, (figure, parts)) in budgets.iter().enumerate() {
            let half = |[a, b]: &[(Identification, [f64; 3]); 2]| 0.5 * (a.1[f] - b.1[f]);
            let by_scale = half(&scaled).abs();
            let by_homing = shifted.iter().map(|s| half(s).powi(2)).sum::<f64>().sqrt();
            let near = |a: f64, b: f64| assert!((a - b).abs() < 0.01 * b + 2e-9, "{figure:?}: {a} {b}");
            near(of(parts, Source::Scale), by_scale);
            near(of(parts, Source::Homing), by_homing);
        }
    }
}

#[test]
fn figures_scatter_over_draws_as_their_budget_states() {
    const DRAWS: u64 = 400;
    for case in cases() {
        let none = vec![0.0; case.robot.joints().len()];
        // the parameters of the robot are what is judged: every draw has the same
        let found = case.identify(&case.measure(&case.calibration, &none, 0.0, || 0.0), &Systematic::default());
        let draw = |seed: u64| {
            let mut noise = Noise::new(77, seed);
            let calibration = case.measure(&case.calibration, &none, 0.0, || noise.gaussian(U_MM));
            let judged = refit_frames(case.robot.as_ref(), &calibration, &settings(), &found.values).unwrap();
            let mut wave = wave(2);
            let validation = case.measure(&case.validation, &none, 0.0, || wave() + noise.gaussian(U_MM));
            let figures = case.figures(&validation, &judged);
            (calibration, validation, figures)
        };
        let (calibration, validation, _) = draw(0);
        let budgets = figure_budgets(&case, &calibration, &validation, &found, &Systematic::default());
        let drawn: Vec<[f64; 3]> = (0..DRAWS).map(|seed| draw(seed).2).collect();
        for (f, (figure, parts)) in budgets.iter().enumerate() {
            let mean = drawn.iter().map(|d| d[f]).sum::<f64>() / DRAWS as f64;
            let sd = (drawn.iter().map(|d| (d[f] - mean).powi(2)).sum::<f64>() / (DRAWS - 1) as f64).sqrt();
            let stated = parts.iter().map(|p| p.1).sum::<f64>().sqrt();
            println!("{} {figure:?}: {:.3} of {stated:.2e} mm", case.robot.model(), sd / stated);
            assert!((sd / stated - 1.0).abs() < 0.12, "{figure:?}: {sd} {stated}");
        }
        assert_eq!(budgets.iter().map(|b| b.0).collect::<Vec<_>>(), [Figure::Mean, Figure::Rms, Figure::Max]);
    }
}

/// A frame that is measured again at each pose moves all targets of the pose together.
#[test]
fn figures_scatter_by_frames_that_are_measured_again_at_each_pose() {
    const DRAWS: u64 = 400;
    let [_, case] = cases();
    let none = vec![0.0; case.robot.joints().len()];
    let calibration = case.measure(&case.calibration, &none, 0.0, || 0.0);
    let found = case.identify(&calibration, &Systematic::default());
    let mut exact = wave(2);
    let mut validation = case.measure(&case.validation, &none, 0.0, &mut exact);
    // the frames of calibration poses are exact
    validation.iter_mut().enumerate().for_each(|(i, o)| o.pose = (1000 + i as i64).into());
    // small beside the differences of errors: another pose seldom has the largest one
    let (shift_mm, turn_rad) = (4e-5, 1e-7);
    let covariance = std::array::from_fn(|i| {
        std::array::from_fn(
            |j| if i == j { if i < 3 { shift_mm * shift_mm } else { turn_rad * turn_rad } } else { 0.0 },
        )
    });
    let frames = validation.iter().map(|o| FrameError { pose: Some((o.pose, o.cycle)), covariance }).collect();
    let systematic = Systematic { frames, ..Systematic::default() };
    let budgets = figure_budgets(&case, &calibration, &validation, &found, &systematic);
    let draw = |seed: u64| {
        let mut noise = Noise::new(78, seed);
        let mut moved = validation.clone();
        for o in &mut moved {
            let [t, w] = [shift_mm, turn_rad].map(|u| [0, 1, 2].map(|_| noise.gaussian(u)));
            for p in o.targets.iter_mut().flatten() {
                let turned = [w[1] * p[2] - w[2] * p[1], w[2] * p[0] - w[0] * p[2], w[0] * p[1] - w[1] * p[0]];
                *p = std::array::from_fn(|i| p[i] + t[i] + turned[i]);
            }
        }
        case.figures(&moved, &found.values)
    };
    let drawn: Vec<[f64; 3]> = (0..DRAWS).map(draw).collect();
    for (f, (figure, parts)) in budgets.iter().enumerate() {
        let mean = drawn.iter().map(|d| d[f]).sum::<f64>() / DRAWS as f64;
        let sd = (drawn.iter().map(|d| (d[f] - mean).powi(2)).sum::<f64>() / (DRAWS - 1) as f64).sqrt();
        let stated = of(parts, Source::FrameOfPoses);
        assert!((sd / stated - 1.0).abs() < 0.15, "{figure:?}: {sd} {stated}");
    }
}

/// What the instrument and the contact contribute is what identifications from draws of either alone scatter by.
#[test]
fn instrument_and_contact_are_apart() {
    use crate::support::five_bar::{SEVEN, measure, robot, truth};
    let (robot, truth) = (robot(), truth());
    let exact = measure(&robot, &truth, &SEVEN, &mut || 0.0);
    let settings =
        Settings { standard_uncertainty_mm: Some(0.003), common_uncertainty_mm: Some(0.005), ..Settings::default() };
    let start = robot.nominal();
    let found = identify_with(&robot, &exact, &settings, &start, &Systematic::default()).unwrap();
    let spread = |ball_mm: f64, contact_mm: f64| {
        let n = 300;
        let mut squares = vec![0.0; truth.len()];
        for seed in 0..n {
            let mut noise = Noise::new(3, seed);
            let mut drawn = exact.clone();
            let mut last: Option<(Vector, Vector)> = None;
            for o in &mut drawn {
                let at = o.targets[0].unwrap();
                let ball = match last {
                    Some((of, ball)) if norm(minus(of, at)) < 1e-9 => ball,
                    _ => [noise.gaussian(ball_mm), noise.gaussian(ball_mm), 0.0],
                };
                last = Some((at, ball));
                // the reading is moved by the ball's error, the joints by that of the contact
                let stands = [at[0] + noise.gaussian(contact_mm), at[1] + noise.gaussian(contact_mm)];
                let branches = etalon::robots::WORKING_MODES
                    .into_iter()
                    .find(|b| {
                        let q = robot.inverse(&truth, robot.to_base(&truth, [at[0], at[1]]), *b);
                        q.iter().zip(&o.joints).all(|(q, j)| (q - j).abs() < 1e-9)
                    })
                    .expect("the mode");
                let q = robot.inverse(&truth, robot.to_base(&truth, stands), branches);
                o.joints[..2].copy_from_slice(&q);
                o.targets[0] = Some([at[0] + ball[0], at[1] + ball[1], 0.0]);
            }
            let again = identify_with(&robot, &drawn, &settings, &start, &Systematic::default()).unwrap();
            squares.iter_mut().zip(&again.values).zip(&truth).for_each(|((s, v), t)| *s += (v - t).powi(2) / n as f64);
        }
        squares
    };
    let (ball, contact) = (spread(0.005, 0.0), spread(0.0, 0.003));
    for (k, &i) in found.free.iter().enumerate() {
        let parts = found.uncertainty.budget.parameter_contributions(k);
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 0.2, "{}: {a} {b}", robot.parameters()[i].name);
        near(of(&parts, Source::Instrument), ball[i].sqrt());
        near(of(&parts, Source::Contact), contact[i].sqrt());
    }
}
