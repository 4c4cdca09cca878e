//! Loads that differ from reading to reading: compliance of joints, accepted on poses left out of the identification (synthetic).

use super::circumstances::{parameter, rms_mm};
use crate::support::scratch::{Scratch, copy_sample, ends};

const SAMPLE: &str = "payload-arm";

/// Cells of a column of the observations, changed.
fn change(scratch: &Scratch, column: &str, of: impl Fn(usize, f64) -> String) {
    let path = scratch.path().join("observations.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let k = text.lines().next().unwrap().split(',').position(|name| name == column).unwrap();
    let line = |(i, line): (usize, &str)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if i > 0 {
            cells[k] = of(i, cells[k].parse().unwrap());
        }
        cells.join(",")
    };
    std::fs::write(&path, text.lines().enumerate().map(line).collect::<Vec<_>>().join("\n") + "\n").unwrap();
}

/// The sample with effects that are stated, which needs no cross-validation.
fn stated() -> Scratch {
    let scratch = copy_sample(SAMPLE);
    scratch.replace("campaign.toml", "effects = \"proven\"", "effects = [\"zeros\", \"geometry\", \"payload\"]");
    scratch
}

fn is_identified(scratch: &Scratch) -> bool {
    let accuracy = scratch.json("accuracy.json");
    let effects = accuracy["effects"].as_array().cloned().unwrap_or_default();
    effects.iter().any(|e| e["effect"] == "payload" && e["is_identified"] == true)
}

/// Outside answers: the true compliance, and the same data without the columns of the load.
#[test]
fn loads_by_reading_are_identified_where_left_out_poses_prove_them() {
    let scratch = copy_sample(SAMPLE);
    ends(&scratch, "run", 0, &[]);
    assert!(is_identified(&scratch));
    for (name, truth) in [("compliance_2_load", 0.12), ("compliance_3_load", 0.09)] {
        let found = parameter(&scratch, name);
        let (value, u) = (found["value"].as_f64().unwrap(), found["standard_uncertainty"].as_f64().unwrap());
        assert!((value - truth).abs() < 3.0 * u && u < 0.02, "{name} {value} {u}");
    }
    let with = rms_mm(&scratch);
    // by default the effect is left out, and a run says that it would be proven
    scratch.replace("campaign.toml", "effects = \"proven\"", "effects = \"usual\"");
    let (_, said) = crate::support::scratch::etalon(&scratch, "run");
    let without = rms_mm(&scratch);
    assert!(!is_identified(&scratch) && parameter(&scratch, "compliance_2_load")["status"] == "fixed", "{said}");
    assert!(without > 1.8 * with && with < 0.06, "{without} {with}");
    let accuracy = scratch.json("accuracy.json");
    let effects = accuracy["effects"].as_array().unwrap();
    assert!(effects.iter().any(|e| e["effect"] == "payload" && e["is_identified"] == false), "{effects:?}");
}

/// Grams under `load_kg` make compliances a thousand times too small, and residuals as small as before.
#[test]
fn a_load_in_grams_is_questioned() {
    let scratch = stated();
    let (_, sound) = crate::support::scratch::etalon(&scratch, "run");
    change(&scratch, "load_kg", |_, kg| format!("{}", 1000.0 * kg));
    let (_, said) = crate::support::scratch::etalon(&scratch, "run");
    assert!(said.contains("load-questioned") && !sound.contains("load-questioned"), "{said}");
}

#[test]
fn a_stiff_robot_has_no_payload_effect() {
    let scratch = copy_sample(SAMPLE);
    for (name, value) in [("compliance_2_load", "0.12"), ("compliance_3_load", "0.09")] {
        scratch.replace("truth.toml", &format!("{name} = {value}"), &format!("{name} = 0.0"));
    }
    ends(&scratch, "simulate", 0, &[]);
    ends(&scratch, "run", 0, &[]);
    assert!(!is_identified(&scratch) && parameter(&scratch, "compliance_2_load")["status"] == "fixed");
}

/// Newtons under `load_kg` scale the compliance alone; newtons in some rows fit no compliance, and the limit is not met.
#[test]
fn newtons_for_kilograms() {
    let newton = |kg: f64| format!("{:.6}", kg * 9.806_65);
    let all = stated();
    ends(&all, "run", 0, &[]);
    let (rms, in_kg) = (rms_mm(&all), parameter(&all, "compliance_2_load")["value"].as_f64().unwrap());
    change(&all, "load_kg", |_, kg| newton(kg));
    ends(&all, "run", 0, &[]);
    let in_newton = parameter(&all, "compliance_2_load")["value"].as_f64().unwrap();
    assert!((in_newton * 9.806_65 / in_kg - 1.0).abs() < 0.1 && (rms_mm(&all) / rms - 1.0).abs() < 0.05);
    let some = stated();
    change(&some, "load_kg", |i, kg| if i % 3 == 0 { newton(kg) } else { kg.to_string() });
    let (_, said) = crate::support::scratch::etalon(&some, "run");
    assert!(rms_mm(&some) > 1.5 * rms, "{said}");
}

/// Slips in the columns of the load; a run ends without an error, and names them. Metres, which are as good as a centre of mass at
/// the flange, are four standard uncertainties from the data here, and are not.
#[test]
fn wrong_columns_of_the_load_are_named() {
    let sound = stated();
    let (_, said) = crate::support::scratch::etalon(&sound, "run");
    assert!(!said.contains("[load-columns-slip]"), "{said}");
    let exchanged = stated();
    exchanged.replace("observations.csv", "load_x_mm,load_y_mm,load_z_mm", "load_z_mm,load_y_mm,load_x_mm");
    ends(&exchanged, "run", 0, &["[load-columns-slip] count=1 changes=`load_x_mm` and `load_z_mm` are swapped"]);
    let turned = stated();
    change(&turned, "load_z_mm", |_, mm| (-mm).to_string());
    ends(&turned, "run", 0, &["[load-columns-slip] count=1 changes=`load_z_mm` has the opposite sign"]);
}

/// Loads in a log, with points of an export.
#[test]
fn loads_of_a_log_give_the_same_result() {
    let scratch = stated();
    ends(&scratch, "run", 0, &[]);
    let of_table = parameter(&scratch, "compliance_2_load")["value"].as_f64().unwrap();
    let text = std::fs::read_to_string(scratch.path().join("observations.csv")).unwrap();
    let column = |name: &str| text.lines().next().unwrap().split(',').position(|n| n == name).unwrap();
    let cells = |line: &str, names: &[&str]| {
        let all: Vec<&str> = line.split(',').collect();
        names.iter().map(|name| all[column(name)]).collect::<Vec<_>>().join(",")
    };
    let [points, joints] = [&["x_mm", "y_mm", "z_mm"][..], &JOINTS].map(|names| {
        let rows = text.lines().skip(1).map(|line| cells(line, names));
        rows.collect::<Vec<_>>()
    });
    let poses: Vec<&str> = text.lines().skip(1).map(|line| line.split(',').nth(column("pose")).unwrap()).collect();
    let rows = |all: &[String]| poses.iter().zip(all).map(|(p, row)| format!("{p},{row}\n")).collect::<String>();
    std::fs::write(scratch.path().join("points.csv"), format!("pose,x,y,z\n{}", rows(&points))).unwrap();
    std::fs::write(scratch.path().join("log.csv"), format!("pose,{}\n{}", JOINTS.join(","), rows(&joints))).unwrap();
    let log = JOINTS.map(|name| format!("{name} = \"{name}\"\n")).concat();
    scratch.replace(
        "campaign.toml",
        "[observations]\nfile = \"observations.csv\"\n",
        &format!(
            "[[export]]\nfile = \"points.csv\"\nformat = {{ delimiter = \",\", decimal = \".\", header = 1, columns = {{ pose = \"pose\", x = \"x\", y = \"y\", z = \"z\" }} }}\nunit = \"mm\"\ntarget = \"SMR\"\n\
             [frame.world]\nas_exported = true\n[log]\nfile = \"log.csv\"\n[log.columns]\npose = \"pose\"\n{log}\n[join]\nby = \"pose\"\ntargets = [\"SMR\"]\n"
        ),
    );
    ends(&scratch, "run", 0, &[]);
    let of_log = parameter(&scratch, "compliance_2_load")["value"].as_f64().unwrap();
    assert!((of_log / of_table - 1.0).abs() < 1e-6, "{of_log} {of_table}");
    // an empty cell of the log leaves its pose out, by name; a negative mass is refused, with its row
    let path = scratch.path().join("log.csv");
    let whole = std::fs::read_to_string(&path).unwrap();
    let with = |cells: &str| whole.replacen(",0.000000,0.000000,0.000000,0.000000\n", &format!(",{cells}\n"), 1);
    assert_ne!(with(",0,0,0"), whole);
    std::fs::write(&path, with(",0,0,0")).unwrap();
    ends(&scratch, "run", 0, &["keys-unmatched"]);
    std::fs::write(&path, with("-3,0,0,0")).unwrap();
    ends(&scratch, "run", 2, &["payload-invalid"]);
}

const JOINTS: [&str; 10] =
    ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg", "load_kg", "load_x_mm", "load_y_mm", "load_z_mm"];
