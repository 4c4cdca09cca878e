//! What each reading states: torques of joints, the temperature of the robot and loads as causes of its errors, accepted on poses left
//! out of the identification (synthetic).

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends, etalon};
use etalon::base::phrase;
use serde_json::Value;

const TORQUE: &str = "torque-arm";
const WARMING: &str = "warming-arm";
const COMPLIANCES: [(&str, f64); 4] = [
    ("compliance_2_torque", -0.12),
    ("compliance_3_torque", -0.15),
    ("compliance_4_torque", -0.4),
    ("compliance_5_torque", -0.5),
];
const THERMAL: [(&str, f64); 7] = [
    ("expansion", 0.0115),
    ("drift_1", 0.006),
    ("drift_2", -0.018),
    ("drift_3", 0.012),
    ("drift_4", 0.008),
    ("drift_5", -0.01),
    ("drift_6", 0.015),
];

const ELASTIC: &str = "elastic-arm";
const TILTS: [(&str, f64); 6] = [
    ("lateral_2_x", 0.08),
    ("lateral_2_y", 0.1),
    ("lateral_3_x", 0.11),
    ("lateral_3_y", 0.09),
    ("pedestal_x", 0.09),
    ("pedestal_y", 0.13),
];

pub(super) fn parameter(scratch: &Scratch, name: &str) -> Value {
    let all = scratch.json("parameters.json");
    let found = all["parameters"].as_array().unwrap().iter().find(|p| p["name"] == name).cloned();
    found.unwrap_or_else(|| panic!("{name}"))
}

fn value(scratch: &Scratch, name: &str) -> f64 {
    parameter(scratch, name)["value"].as_f64().unwrap()
}

/// RMS position error of the validation poses after calibration, mm.
pub(super) fn rms_mm(scratch: &Scratch) -> f64 {
    let accuracy = scratch.json("accuracy.json");
    accuracy["sets"].as_array().unwrap().last().unwrap()["errors"][0]["after"]["rms"].as_f64().unwrap()
}

/// `true` if an effect that is, or is not, identified is proven.
fn is_proven(scratch: &Scratch, effect: &str, is_identified: bool) -> bool {
    let accuracy = scratch.json("accuracy.json");
    let effects = accuracy["effects"].as_array().cloned().unwrap_or_default();
    effects.iter().any(|e| e["effect"] == effect && e["is_identified"] == is_identified)
}

/// A sample with effects that are stated, which needs no cross-validation.
fn stated(sample: &str, effects: &str) -> Scratch {
    let scratch = copy_sample(sample);
    let list = format!("effects = [\"zeros\", \"geometry\", {effects}]");
    scratch.replace("campaign.toml", "effects = \"proven\"", &list);
    scratch
}

/// Numbers of a column of the observations, changed.
fn change(scratch: &Scratch, column: &str, of: impl Fn(f64) -> f64) {
    let path = scratch.path().join("observations.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let k = text.lines().next().unwrap().split(',').position(|name| name == column).unwrap();
    let line = |(i, line): (usize, &str)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if i > 0 {
            cells[k] = format!("{:.6}", of(cells[k].parse().unwrap()));
        }
        cells.join(",")
    };
    std::fs::write(&path, text.lines().enumerate().map(line).collect::<Vec<_>>().join("\n") + "\n").unwrap();
}

/// Effects that are identified by default.
const USUAL: &str = "effects = \"usual\"";

/// A sample made again with another seed and these identified effects, without the effects whose true values are `gone`.
fn again(sample: &str, seed: u64, effects: &str, gone: &[(&str, f64)]) -> Scratch {
    let scratch = copy_sample(sample);
    scratch.replace("campaign.toml", "effects = \"proven\"", effects);
    let made = match sample {
        TORQUE => "seed = 451",
        WARMING => "seed = 452",
        _ => "seed = 453",
    };
    scratch.replace("truth.toml", made, &format!("seed = {seed}"));
    for (name, value) in gone {
        scratch.replace("truth.toml", &format!("{name} = {value}"), &format!("{name} = 0.0"));
    }
    ends(&scratch, "simulate", 0, &[]);
    etalon(&scratch, "run");
    scratch
}

/// Outside answers: the true values, which come back within three standard uncertainties, and what the noise leaves.
fn comes_back(sample: &str, effects: &[&str], truth: &[(&str, f64)]) {
    let scratch = copy_sample(sample);
    ends(&scratch, "run", 0, &[]);
    for effect in effects {
        assert!(is_proven(&scratch, effect, true), "{effect}");
    }
    for (name, truth) in truth {
        let found = parameter(&scratch, name);
        let (value, u) = (found["value"].as_f64().unwrap(), found["standard_uncertainty"].as_f64().unwrap());
        assert!((value - truth).abs() < 3.0 * u, "{name} {value} {u}");
    }
    // 20 µm a coordinate, and the parameters of 60 poses
    assert!(rms_mm(&scratch) < 0.055, "{}", rms_mm(&scratch));
}

#[test]
fn torques_by_reading_are_identified_where_left_out_poses_prove_them() {
    comes_back(TORQUE, &["torque"], &COMPLIANCES);
}

#[test]
fn drift_and_expansion_are_identified_where_left_out_poses_prove_them() {
    comes_back(WARMING, &["expansion", "drift"], &THERMAL);
}

#[test]
fn tilts_across_axes_and_of_the_base_are_identified_where_left_out_poses_prove_them() {
    comes_back(ELASTIC, &["lateral", "pedestal"], &TILTS);
}

/// Outside answer: the least and the greatest cell of the column of the table, by set of poses. Report and controller file name
/// loads, temperatures, units and the reference temperature.
#[test]
fn values_of_readings_are_in_documents_and_report() {
    for (sample, effects, column, printed) in [
        (WARMING, "\"expansion\", \"drift\"", "temperature_c", ["deg/(10 K)", "mm/(m·K)", "model refers to 20 °C"]),
        ("payload-arm", "\"payload\"", "load_kg", ["deg/(100 N·m)", "readings: 0; 1.5; 3 kg", "with payload 0 kg"]),
    ] {
        let scratch = stated(sample, effects);
        ends(&scratch, "run", 0, &[]);
        let table = std::fs::read_to_string(scratch.path().join("observations.csv")).unwrap();
        let k = table.lines().next().unwrap().split(',').position(|name| name == column).unwrap();
        let cells = |from: usize, to: usize| -> Vec<f64> {
            let rows = table.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
            let rows = rows.filter(|row| (from..=to).contains(&row[0].parse::<usize>().unwrap()));
            rows.map(|row| row[k].parse().unwrap()).collect()
        };
        let accuracy = scratch.json("accuracy.json");
        for (set, of_table) in [(0, cells(1, 60)), (1, cells(61, 999))] {
            let readings = accuracy["sets"][set]["readings"].as_array().unwrap();
            let found = readings.iter().find(|values| values["column"] == column).unwrap();
            let [least, most] = [f64::min, f64::max].map(|of| of_table.iter().copied().reduce(of).unwrap());
            assert_eq!((found["lowest"].as_f64(), found["highest"].as_f64()), (Some(least), Some(most)), "{sample}");
        }
        let report = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
        for text in printed {
            assert!(report.contains(text), "{sample}: {text}");
        }
        let region =
            if sample == WARMING { "temperature_c 19.5 to 31.5." } else { "load_kg 0; 1.5; 3, load_x_mm 0; 10," };
        assert!(report.contains(region), "{sample}: {region}");
        let controller = scratch.json("controller.json");
        let name = if sample == WARMING { "drift_2" } else { "compliance_2_load" };
        assert_eq!(controller["parameters"][name]["full_unit"], printed[0], "{sample}");
        let reference = (sample == WARMING).then_some(20.0);
        assert_eq!(controller["reference_temperature_c"].as_f64(), reference, "{sample}");
    }
}

/// Under the same load base and first joint tilt alike: the run says which to leave out.
#[test]
fn a_pedestal_beside_the_first_joint_is_named_with_its_remedy() {
    let remedy = phrase!("pedestal-or-first-joint", joint = "1").to_string();
    for (lateral, is_named) in [("[2, 3]", false), ("[1, 2, 3]", true)] {
        let scratch = copy_sample(ELASTIC);
        scratch.replace("robot.toml", "lateral = [2, 3]", &format!("lateral = {lateral}"));
        scratch.replace("campaign.toml", "\"proven\"", "\"all\"");
        let (_, said) = etalon(&scratch, "run");
        assert_eq!(said.contains(&remedy), is_named, "{said}");
        let names = ["`lateral_1_y`", "`pedestal_x`", "`pedestal_y`"];
        let mut group = said.lines().filter(|line| line.contains("weakly-identifiable"));
        assert_eq!(group.any(|line| names.iter().all(|name| line.contains(name))), is_named, "{said}");
    }
}

/// A robot that states one of both tilts: which of them yields shows only where its stiffness differs by direction.
#[test]
fn a_tilt_that_may_be_that_of_base_or_first_joint_is_named() {
    let keys = [("lateral = [2, 3]", "pedestal = true"), ("lateral = [1, 2, 3]", "pedestal = false")];
    for (own, (lateral, pedestal)) in [("pedestal", keys[0]), ("lateral", keys[1])] {
        // of the robot that yields alike in all directions, and of one that does not; about x of joint 1 it carries little
        let unequal = if own == "pedestal" { 0.05 } else { 0.6 };
        for (x, y, is_named) in [(0.1, 0.1, true), (unequal, 0.15, false)] {
            let scratch = copy_sample(ELASTIC);
            let names = if own == "pedestal" { ["pedestal_x", "pedestal_y"] } else { ["lateral_1_x", "lateral_1_y"] };
            for (name, value) in [("pedestal_x = 0.09", x), ("pedestal_y = 0.13", y)] {
                let of_own = format!("{} = {value}", names[usize::from(name.starts_with("pedestal_y"))]);
                scratch.replace("truth.toml", name, &of_own);
            }
            scratch.replace("robot.toml", "lateral = [2, 3]", lateral);
            scratch.replace("robot.toml", "pedestal = true", pedestal);
            scratch.replace("campaign.toml", "\"proven\"", "\"all\"");
            ends(&scratch, "simulate", 0, &[]);
            let (_, said) = etalon(&scratch, "run");
            let expected = format!("[tilt-of-base-or-joint] stated={own} joint=q1");
            assert_eq!(said.says(&expected), is_named, "{own} {x} {y}: {said}");
        }
    }
}

#[test]
fn tilts_are_proven_where_the_robot_yields_and_nowhere_else() {
    // each beside the other, which is identified
    for (effect, beside) in [("lateral", "pedestal"), ("pedestal", "lateral")] {
        let effects = format!("effects = [\"zeros\", \"geometry\", \"payload\", \"{beside}\"]");
        for seed in 1..=3 {
            assert!(is_proven(&again(ELASTIC, seed, &effects, &[]), effect, false), "{effect}, seed {seed}");
            let stiff = again(ELASTIC, seed, &effects, &TILTS);
            assert!(!is_proven(&stiff, effect, false), "{effect}, seed {seed}");
        }
    }
}

#[test]
fn torques_are_proven_where_joints_bend_and_nowhere_else() {
    for seed in 1..=4 {
        assert!(is_proven(&again(TORQUE, seed, USUAL, &[]), "torque", false), "seed {seed}");
        assert!(!is_proven(&again(TORQUE, seed, USUAL, &COMPLIANCES), "torque", false), "seed {seed}");
    }
}

#[test]
fn temperatures_are_proven_where_the_robot_moves_with_them_and_nowhere_else() {
    for seed in 1..=4 {
        let warm = again(WARMING, seed, USUAL, &[]);
        assert!(is_proven(&warm, "drift", false), "seed {seed}");
        let constant = again(WARMING, seed, USUAL, &THERMAL);
        assert!(!is_proven(&constant, "drift", false) && !is_proven(&constant, "expansion", false), "seed {seed}");
    }
}

/// The data decide the product of torque and compliance alone: signs and units of all torques change the compliances, not the errors.
#[test]
fn signs_and_units_of_all_torques_change_the_compliances_alone() {
    let scratch = stated(TORQUE, "\"torque\"");
    ends(&scratch, "run", 0, &[]);
    let (rms, compliance) = (rms_mm(&scratch), value(&scratch, "compliance_2_torque"));
    for factor in [-1.0, 1000.0] {
        let other = stated(TORQUE, "\"torque\"");
        (1..=6).for_each(|j| change(&other, &format!("tau{j}_nm"), |v| factor * v));
        etalon(&other, "run");
        let found = value(&other, "compliance_2_torque") * factor;
        assert!((found / compliance - 1.0).abs() < 0.1, "{factor}: {found} {compliance}");
        assert!((rms_mm(&other) / rms - 1.0).abs() < 0.1, "{factor}");
    }
    // one joint alone yields the other way
    change(&scratch, "tau3_nm", |v| -v);
    ends(&scratch, "run", 0, &["torque-signs-differ"]);
    assert!((rms_mm(&scratch) / rms - 1.0).abs() < 0.01);
}

#[test]
fn exchanged_columns_of_torques_are_named() {
    let scratch = stated(TORQUE, "\"torque\"");
    scratch.replace("observations.csv", "tau2_nm,tau3_nm", "tau3_nm,tau2_nm");
    let (_, said) = etalon(&scratch, "run");
    assert!(said.contains("torques-exchanged") && said.contains("tau2_nm") && said.contains("tau3_nm"), "{said}");
}

/// A standing robot has no torque on its first axis, nor on the last under a load on its axis: that is no fault of the data.
#[test]
fn torques_that_do_not_vary_are_held_by_name() {
    let scratch = stated(TORQUE, "\"torque\"");
    scratch.replace("truth.toml", "friction_nm = 0.05", "friction_nm = 0.0");
    ends(&scratch, "simulate", 0, &[]);
    ends(&scratch, "run", 0, &["torque-constant"]);
    for name in ["compliance_1_torque", "compliance_6_torque"] {
        assert_eq!(parameter(&scratch, name)["status"], "fixed", "{name}");
    }
    let rms = rms_mm(&scratch);
    // a constant torque is a part of the zero
    change(&scratch, "tau1_nm", |_| 12.5);
    ends(&scratch, "run", 0, &["torque-constant"]);
    assert!((rms_mm(&scratch) / rms - 1.0).abs() < 1e-6);
}

#[test]
fn temperatures_in_other_units_are_questioned_and_constant_ones_held() {
    let scratch = stated(WARMING, "\"drift\", \"expansion\"");
    ends(&scratch, "run", 0, &[]);
    let drift = value(&scratch, "drift_2");
    for (factor, offset) in [(1.8, 32.0), (1.0, 273.15)] {
        let other = stated(WARMING, "\"drift\", \"expansion\"");
        change(&other, "temperature_c", |t| factor * t + offset);
        let (_, said) = etalon(&other, "run");
        assert!(said.contains("temperature-questioned"), "{said}");
        // the values are used as they are
        assert!((value(&other, "drift_2") * factor / drift - 1.0).abs() < 0.15);
    }
    change(&scratch, "temperature_c", |_| 20.0);
    let (_, said) = etalon(&scratch, "run");
    assert!(said.contains("temperature-constant"), "{said}");
    assert_eq!(parameter(&scratch, "drift_2")["status"], "fixed");
}

/// The simulated log states what the table of the sample states, so that both give the same parameters.
#[test]
fn a_simulated_log_states_load_torques_and_temperature() {
    let effects = [
        ("payload-arm", &["load_kg", "load_x_mm", "load_y_mm", "load_z_mm"][..], "compliance_2_load"),
        (TORQUE, &["tau1_nm", "tau2_nm", "tau3_nm", "tau4_nm", "tau5_nm", "tau6_nm"], "compliance_3_torque"),
        (WARMING, &["temperature_c"], "drift_2"),
    ];
    for (sample, columns, parameter_name) in effects {
        let scratch = copy_sample(sample);
        let table = std::fs::read_to_string(scratch.path().join("observations.csv")).unwrap();
        let joints = (1..=6).map(|k| format!("q{k}_deg"));
        let read: Vec<String> = joints.chain(columns.iter().map(|c| (*c).to_owned())).collect();
        let stated: String = read.iter().map(|column| format!(", {column} = \"{column}\"")).collect();
        let files = format!(
            "[[export]]\nfile = \"points.csv\"\nunit = \"mm\"\nlabel = \"{{target}}_{{pose}}\"\n\
             format = {{ delimiter = \",\", decimal = \".\", columns = [\"label\", \"x\", \"y\", \"z\"] }}\n\
             [frame.world]\nas_exported = true\n[join]\nby = [\"pose\"]\ntargets = [\"SMR\"]\n\
             [log]\nfile = \"log.csv\"\ncolumns = {{ pose = \"pose\", cycle = \"cycle\"{stated} }}\n"
        );
        scratch.replace("campaign.toml", "[observations]\nfile = \"observations.csv\"\n", &files);
        scratch.replace("truth.toml", "[[observe]]\nkind = \"point\"\ntarget = \"SMR\"\n", "");
        ends(&scratch, "simulate", 0, &[]);
        // the values of the table of the sample, in the order of the poses
        let values = |text: &str| -> Vec<Vec<String>> {
            let mut rows = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
            let head = rows.next().unwrap();
            let at: Vec<usize> = read.iter().map(|c| head.iter().position(|h| h == c).unwrap()).collect();
            rows.map(|row| at.iter().map(|&i| row[i].clone()).collect()).collect()
        };
        let log = std::fs::read_to_string(scratch.path().join("log.csv")).unwrap();
        assert!(values(&log) == values(&table), "{sample}: {}", log.lines().take(3).collect::<String>());
        ends(&scratch, "run", 0, &[]);
        let truth =
            etalon::simulate::Truth::read(&scratch.path().join("truth.toml")).unwrap().parameters[parameter_name];
        let found = parameter(&scratch, parameter_name);
        let (value, u) = (found["value"].as_f64().unwrap(), found["standard_uncertainty"].as_f64().unwrap());
        assert!((value - truth).abs() < 3.0 * u, "{sample}: {parameter_name} {value} {u}");
    }
}
