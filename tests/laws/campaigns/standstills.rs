//! Standstills in a log recorded while the robot moved, and joins in time that rest on them.

use crate::support::documents_of;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::message::Problems;
use etalon::base::noise::Noise;
use etalon::campaign::Campaign;
use etalon::documents::{ImportDocument, SourceKind};
use etalon::formats::standstill::{Watched, standing};
use etalon::run::pipeline::Outcome;

/// A walk of two joints that stands now and then, with scatter and odd steps of time.
fn walk(seed: u64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let mut noise = Noise::new(seed, 1);
    let (mut times, mut a, mut b) = (Vec::new(), Vec::new(), Vec::new());
    let (mut time, mut at) = (0.0, 0.0);
    for step in 0..400 {
        time += 0.01 + 0.002 * noise.gaussian(1.0).abs();
        let moves = (step / 23) % 3 == 1 || noise.gaussian(1.0) > 2.5;
        at += if moves { 0.3 + noise.gaussian(1.0) * 0.1 } else { 0.0 };
        times.push(time);
        a.push(at + 0.02 * noise.gaussian(1.0));
        b.push(-0.5 * at + 0.02 * noise.gaussian(1.0));
    }
    (times, a, b)
}

fn watched<'a>(a: &'a [f64], b: &'a [f64], within: f64) -> [Watched<'a>; 2] {
    [Watched { values: a, within }, Watched { values: b, within }]
}

/// The definition, word for word: samples of stretches that last long enough within the limits.
fn by_definition(times: &[f64], joints: &[Watched], at_least_s: f64) -> Vec<(usize, usize)> {
    let range = |v: &[f64]| v.iter().fold(f64::MIN, |m, x| m.max(*x)) - v.iter().fold(f64::MAX, |m, x| m.min(*x));
    let mut found: Vec<(usize, usize)> = Vec::new();
    for i in 0..times.len() {
        for j in i..times.len() {
            let still = joints.iter().all(|joint| range(&joint.values[i..=j]) <= joint.within);
            if times[j] - times[i] >= at_least_s && still {
                match found.last_mut() {
                    Some(before) if i <= before.1 => before.1 = before.1.max(j),
                    _ => found.push((i, j)),
                }
            }
        }
    }
    found
}

#[test]
fn intervals_are_those_of_the_definition() {
    let mut intervals = 0;
    for seed in 0..12 {
        let (times, a, b) = walk(seed);
        for (within, at_least_s) in [(0.1, 0.1), (0.12, 0.2), (0.3, 0.05), (1e-9, 0.02), (1e9, 0.1)] {
            let joints = watched(&a, &b, within);
            let found = standing(&times, &joints, at_least_s);
            assert_eq!(found, by_definition(&times, &joints, at_least_s), "seed {seed}, {within}, {at_least_s}");
            intervals += found.len();
        }
    }
    assert!(intervals > 200, "{intervals}: the walks hardly stand");
}

#[test]
fn limits_that_are_just_met_are_met() {
    let (times, values) = ([0.0, 0.5, 1.0, 1.5], [0.0, 0.25, 0.125, 9.0]);
    let found = |within, at_least_s| standing(&times, &[Watched { values: &values, within }], at_least_s);
    assert_eq!(found(0.25, 1.0), [(0, 2)]);
    assert!(found(0.25, 1.0 + 1e-12).is_empty() && found(0.25 - 1e-12, 1.0).is_empty());
    assert_eq!(found(0.125, 0.5), [(1, 2)]);
}

#[test]
fn read_backwards_in_other_units_and_with_joints_exchanged_the_intervals_are_the_same() {
    for seed in 20..30 {
        let (times, a, b) = walk(seed);
        let found = standing(&times, &watched(&a, &b, 0.12), 0.1);
        let n = times.len();
        let back = |v: &[f64]| -> Vec<f64> { v.iter().rev().copied().collect() };
        let reversed: Vec<f64> = times.iter().rev().map(|t| -t).collect();
        let mirrored = standing(&reversed, &watched(&back(&a), &back(&b), 0.12), 0.1);
        let mirrored: Vec<(usize, usize)> = mirrored.into_iter().rev().map(|(i, j)| (n - 1 - j, n - 1 - i)).collect();
        assert_eq!(found, mirrored, "seed {seed}");
        let scaled = |v: &[f64]| -> Vec<f64> { v.iter().map(|x| x * 1024.0).collect() };
        assert_eq!(found, standing(&times, &watched(&scaled(&a), &scaled(&b), 0.12 * 1024.0), 0.1), "seed {seed}");
        assert_eq!(found, standing(&times, &watched(&b, &a, 0.12), 0.1), "seed {seed}");
    }
}

#[test]
fn a_million_samples_take_no_more_than_a_pass_over_them() {
    let times: Vec<f64> = (0..1_000_000).map(|i| i as f64 * 1e-3).collect();
    let values: Vec<f64> = (0..1_000_000).map(|i| f64::from(i / 1000 % 2) + f64::from(i % 7) * 1e-3).collect();
    let start = std::time::Instant::now();
    let found = standing(&times, &[Watched { values: &values, within: 0.01 }], 0.5);
    assert_eq!(found.len(), 1000);
    assert!(start.elapsed().as_secs_f64() < 60.0, "{:?}", start.elapsed());
}

const LOG: &str = "columns = { time_s = \"t\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }\n";
const STANDSTILL: &str = "standstill = { at_least_s = 1.0, within_mm = 0.01 }\n";
const CLOCK_S: f64 = -731.625;

/// The joints of the sample's first round.
fn configurations(scratch: &Scratch) -> Vec<[f64; 3]> {
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let cells = |line: &str| -> Vec<f64> { line.split(',').map(|c| c.parse().unwrap()).collect() };
    log.lines().skip(1).take(59).map(cells).map(|c| [c[2], c[3], c[4]]).collect()
}

/// A campaign by time: rows of the log, and times (by the log's clock) and joints of what is measured.
fn campaign(scratch: &Scratch, log: &[(f64, [f64; 3])], measured: &[(f64, [f64; 3])], stated: &str, join: &str) {
    let campaign = Campaign::read(&scratch.path()).unwrap();
    let robot = campaign.build_robot().unwrap();
    let truth = etalon::simulate::Truth::read(&scratch.path().join("truth.toml")).unwrap();
    let value = |p: &etalon::robots::Parameter| p.quantity.inward(truth.parameters[&p.name]);
    let values: Vec<f64> = robot.parameters().iter().map(value).collect();
    let mut export = String::new();
    for (time, q) in measured {
        for k in 0..2 {
            let p = robot.position(&values, q, k);
            export += &format!("{};{};{};{};0\n", robot.targets()[k], time + CLOCK_S, p[0], p[1]);
        }
    }
    let rows: String = log.iter().map(|(t, q)| format!("{t},{},{},{}\n", q[0], q[1], q[2])).collect();
    std::fs::write(scratch.path().join("exports/poses.txt"), export).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), format!("t,RP1,RP2,RP3\n{rows}")).unwrap();
    let text = format!(
        "name = \"timed\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\ncoverage_factor = 2\n\
         [[export]]\nfile = \"exports/poses.txt\"\nunit = \"mm\"\n\
         format = {{ delimiter = \";\", columns = [\"target\", \"time_s\", \"x\", \"y\", \"z\"] }}\n\
         [log]\nfile = \"encoders.csv\"\n{LOG}{stated}[join]\nby = \"time\"\n{join}\n[frame.world]\nas_exported = true\n\
         [identify]\nprior = \"none\"\ncalibration = \"1-8\"\nvalidation = \"rest\"\n"
    );
    std::fs::write(scratch.path().join("campaign.toml"), text).unwrap();
}

/// Times and joints.
type Rows = Vec<(f64, [f64; 3])>;

/// The robot goes from pose to pose in 1.5 s and stands for a time that differs from pose to pose; 20 rows a second.
fn recording(poses: &[[f64; 3]], scatter_mm: f64) -> (Rows, Vec<(f64, f64)>) {
    let mut noise = Noise::new(7, 1);
    let (mut rows, mut stands, mut tick) = (Vec::new(), Vec::new(), 0u32);
    for (i, q) in poses.iter().enumerate() {
        let stand = 40 + (i * i * 7 % 31) as u32;
        stands.push((f64::from(tick) * 0.05, f64::from(tick + stand) * 0.05));
        for _ in 0..=stand {
            rows.push((f64::from(tick) * 0.05, q.map(|v| v + scatter_mm * noise.gaussian(1.0).clamp(-3.0, 3.0))));
            tick += 1;
        }
        let Some(next) = poses.get(i + 1) else { break };
        for step in 1..30 {
            let share = f64::from(step) / 30.0;
            rows.push((f64::from(tick) * 0.05, [0, 1, 2].map(|j| q[j] + share * (next[j] - q[j]) + 0.05 * share)));
            tick += 1;
        }
    }
    (rows, stands)
}

fn run(scratch: &Scratch) -> Result<Outcome, Problems> {
    documents_of(&Campaign::read(&scratch.path())?)
}

fn document(scratch: &Scratch) -> ImportDocument {
    scratch.document("import.json")
}

#[test]
fn a_log_recorded_while_moving_calibrates_by_the_means_of_its_standstills() {
    let scratch = copy_sample("prexyt-cmm");
    let poses = configurations(&scratch);
    let (rows, stands) = recording(&poses, 0.0);
    let measured: Rows = stands.iter().zip(&poses).map(|((a, b), q)| (0.4 * a + 0.6 * b, *q)).collect();
    campaign(&scratch, &rows, &measured, STANDSTILL, &format!("clock_offset_s = {CLOCK_S}\ntolerance_s = 0"));
    let outcome = run(&scratch).unwrap();
    assert_eq!(outcome.results.identified.as_ref().unwrap().accuracy.sets[1].poses, 51);
    assert!(
        outcome.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0].after.max < 1e-9,
        "{:?}",
        outcome.results.identified.as_ref().unwrap().accuracy.sets
    );
    let document = document(&scratch);
    let log = document.sources.iter().find(|s| s.kind == SourceKind::Log).unwrap();
    assert_eq!((log.rows_read, log.standstills.len()), (rows.len(), 59));
    for (found, (from, to)) in log.standstills.iter().zip(&stands) {
        assert!((found.from_s - from).abs() < 1e-9 && (found.to_s - to).abs() < 1e-9, "{found:?}");
        assert!(found.joints.iter().all(|j| j.range == 0.0 && j.standard_deviation == 0.0) && found.samples > 40);
    }
    assert!(document.unmatched.is_empty(), "{:?}", document.unmatched);
}

#[test]
fn the_spread_of_a_standstill_is_told_and_its_mean_counts() {
    let scratch = copy_sample("prexyt-cmm");
    let poses = configurations(&scratch);
    let (rows, stands) = recording(&poses, 0.001);
    let measured: Rows = stands.iter().zip(&poses).map(|((a, b), q)| (0.5 * (a + b), *q)).collect();
    campaign(&scratch, &rows, &measured, STANDSTILL, &format!("clock_offset_s = {CLOCK_S}\ntolerance_s = 0"));
    let outcome = run(&scratch).unwrap();
    // 0.001 mm of scatter, in the mean of 41 to 71 samples
    assert!(
        outcome.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0].after.max < 0.001,
        "{:?}",
        outcome.results.identified.as_ref().unwrap().accuracy.sets
    );
    let document = document(&scratch);
    let log = document.sources.iter().find(|s| s.kind == SourceKind::Log).unwrap();
    assert_eq!(log.standstills.len(), 59);
    let all: Vec<f64> = log.standstills.iter().flat_map(|s| &s.joints).map(|j| j.standard_deviation).collect();
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    assert!((mean / 0.001 - 1.0).abs() < 0.05, "{mean}");
    for (found, q) in log.standstills.iter().zip(&poses) {
        for (joint, truth) in found.joints.iter().zip(q) {
            assert!((joint.mean - truth).abs() < 5.0 * 0.001 / (found.samples as f64).sqrt(), "{joint:?} {truth}");
        }
    }
}

#[test]
fn the_offset_of_the_clocks_comes_from_the_standstills_and_is_said() {
    let scratch = copy_sample("prexyt-cmm");
    let poses = configurations(&scratch);
    let (rows, stands) = recording(&poses, 0.0);
    // soon after the start of a standstill, shortly before its end, or in the middle
    let early = |i: usize, (from, to): (f64, f64)| [from + 0.1, to - 0.1, 0.5 * (from + to)][i % 3];
    let measured: Rows = stands.iter().zip(&poses).enumerate().map(|(i, (stand, q))| (early(i, *stand), *q)).collect();
    campaign(&scratch, &rows, &measured, STANDSTILL, "clock_offset_s = \"standstills\"\ntolerance_s = 0");
    let outcome = run(&scratch).unwrap();
    assert!(
        outcome.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0].after.max < 1e-9,
        "{:?}",
        outcome.results.identified.as_ref().unwrap().accuracy.sets
    );
    let said = outcome.results.messages().find(|m| m.is("clock-from-standstills", &[("count", &59)])).unwrap();
    assert!(said.what.contains(&format!("offset {CLOCK_S:.3} s ± 0.100 s")), "{said}");
    // early and late alone: a whole move later they fit as well
    let ends = stands.iter().zip(&poses).enumerate().map(|(i, ((from, to), q))| ([from + 0.1, to - 0.1][i % 2], *q));
    let scratch = copy_sample("prexyt-cmm");
    campaign(
        &scratch,
        &rows,
        &ends.collect::<Vec<_>>(),
        STANDSTILL,
        "clock_offset_s = \"standstills\"\ntolerance_s = 0",
    );
    let problems = run(&scratch).unwrap_err().to_string();
    assert!(
        problems.contains("error[clock-offsets-several]")
            && problems.contains("-733.525 to -733.225 s, -731.725 to -731.525 s"),
        "{problems}"
    );
    // measured while the robot moved: no offset suits all
    let mut wrong = measured.clone();
    wrong[30].0 = stands[30].1 + 0.75;
    let scratch = copy_sample("prexyt-cmm");
    campaign(&scratch, &rows, &wrong, STANDSTILL, "clock_offset_s = \"standstills\"\ntolerance_s = 0");
    let problems = run(&scratch).unwrap_err().to_string();
    assert!(problems.contains("error[clock-offset-none]"), "{problems}");
}

#[test]
fn points_measured_while_the_robot_moved_are_listed() {
    let scratch = copy_sample("prexyt-cmm");
    let poses = configurations(&scratch);
    let (rows, stands) = recording(&poses, 0.0);
    let mut measured: Rows = stands.iter().zip(&poses).map(|((a, b), q)| (0.5 * (a + b), *q)).collect();
    measured[30].0 = stands[30].1 + 0.75;
    campaign(&scratch, &rows, &measured, STANDSTILL, &format!("clock_offset_s = {CLOCK_S}\ntolerance_s = 0.1"));
    run(&scratch).unwrap();
    let listed: Vec<(String, usize)> = document(&scratch).unmatched.into_iter().map(|u| (u.file, u.line)).collect();
    // both targets of measurement 31, and the standstill that nobody measured
    let line = rows.iter().position(|(t, _)| *t == stands[30].0).unwrap() + 2;
    let export = "exports/poses.txt".to_owned();
    assert_eq!(listed, [(export.clone(), 61), (export, 62), ("encoders.csv".to_owned(), line)]);
}

#[test]
fn between_two_rows_joints_that_move_evenly_are_exact() {
    let scratch = copy_sample("prexyt-cmm");
    let poses = configurations(&scratch);
    let rows: Rows = poses.iter().enumerate().map(|(i, q)| (2.0 * i as f64, *q)).collect();
    let between = |i: usize, share: f64| {
        let (q, next) = (poses[i], poses[i + 1]);
        (2.0 * (i as f64 + share), [0, 1, 2].map(|j| q[j] + share * (next[j] - q[j])))
    };
    // seven in ten, three in ten, on a row, and two within one interval
    let mut measured: Rows =
        (0..58).map(|i| between(i, [0.7, 0.3, 0.0, 0.5][i % 4])).chain([between(57, 0.9)]).collect();
    measured.sort_by(|a, b| a.0.total_cmp(&b.0));
    let join = format!("clock_offset_s = {CLOCK_S}\ntolerance_s = 2.0\ninterpolate = true");
    campaign(&scratch, &rows, &measured, "", &join);
    let outcome = run(&scratch).unwrap();
    assert_eq!(
        outcome.results.identified.as_ref().unwrap().accuracy.sets[0].poses
            + outcome.results.identified.as_ref().unwrap().accuracy.sets[1].poses,
        59
    );
    assert!(
        outcome.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0].after.max < 1e-9,
        "{:?}",
        outcome.results.identified.as_ref().unwrap().accuracy.sets
    );
    // a tolerance below the distance to the farther row leaves points alone; on a row there is none
    let tight = copy_sample("prexyt-cmm");
    campaign(&tight, &rows, &measured, "", &join.replace("2.0", "1.2"));
    run(&tight).unwrap();
    let alone = document(&tight).unmatched.len();
    assert_eq!(alone, 2 * ((0..58).filter(|i| i % 4 < 2).count() + 1));
}

#[test]
fn statements_about_standstills_that_contradict_are_errors() {
    for (stated, join, part) in [
        ("", "clock_offset_s = \"standstills\"\ntolerance_s = 0", "[standstills-missing]"),
        (STANDSTILL, "clock_offset_s = 0\ntolerance_s = 0\ninterpolate = true", "[interpolate-with-standstills]"),
        (
            "standstill = { at_least_s = 1.0 }\n",
            "clock_offset_s = 0\ntolerance_s = 0",
            "error[standstill-limit-missing]",
        ),
        (
            "standstill = { at_least_s = 0.0, within_mm = 1.0 }\n",
            "clock_offset_s = 0\ntolerance_s = 0",
            "error[key-not-positive]: `at_least_s`",
        ),
        (
            "standstill = { at_least_s = 99.0, within_mm = 0.01 }\n",
            "clock_offset_s = 0\ntolerance_s = 0",
            "error[standstill-missing]",
        ),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        let poses = configurations(&scratch);
        let (rows, _) = recording(&poses, 0.0);
        campaign(&scratch, &rows, &[(1.0, poses[0])], stated, join);
        let said = run(&scratch).unwrap_err().to_string();
        assert!(said.contains(part), "{part}:\n{said}");
    }
}
