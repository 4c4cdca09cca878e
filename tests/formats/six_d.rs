//! Exports of six degrees of freedom beside a log: the same poses in every form and join give what a table of observations gives.

use etalon::base::angle_order::AngleOrder;
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use etalon::documents::ParametersDocument;
use std::fmt::Write;
use std::path::Path;

fn program(at: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output =
        std::process::Command::new(crate::support::program()).args(arguments).current_dir(at).output().unwrap();
    (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// A pose: joint values (deg), position (mm), quaternion.
type Row = (Vec<f64>, [f64; 3], [f64; 4]);

/// Poses of a UR5e as its nominal kinematics give them, with noise of a tracker on the positions.
fn rows(at: &Path) -> Vec<Row> {
    assert_eq!(program(at, &["init", "c", "--robot", "ur5e"]).0, Some(0));
    let mut noise = Noise::new(5, 0);
    let joints: Vec<Vec<f64>> = (0..30).map(|_| (0..6).map(|_| 100.0 * noise.uniform(1.2)).collect()).collect();
    let mut table = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    for (i, q) in (1..).zip(&joints) {
        let cells: Vec<String> = q.iter().map(f64::to_string).collect();
        let _ = writeln!(table, "{i},{}", cells.join(","));
    }
    std::fs::write(at.join("joints.csv"), table).unwrap();
    let (_, reached, said) = program(at, &["kinematics", "direct", "--robot", "c/robot.toml", "joints.csv"]);
    let reached: Vec<Vec<f64>> = reached
        .lines()
        .skip(1)
        .map(|line| line.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(reached.len(), 30, "{said}");
    let place =
        |p: &[f64], noise: &mut Noise| [p[0], p[1], p[2]].map(|v| ((v + noise.gaussian(0.02)) * 1e6).round() / 1e6);
    joints.into_iter().zip(&reached).map(|(q, p)| (q, place(p, &mut noise), [p[3], p[4], p[5], p[6]])).collect()
}

fn line(cells: impl IntoIterator<Item = f64>) -> String {
    cells.into_iter().map(|v| v.to_string()).collect::<Vec<_>>().join(",")
}

fn run(at: &Path, body: &str) -> (Option<i32>, String, Option<ParametersDocument>) {
    let _ = std::fs::remove_dir_all(at.join("c/out"));
    let text = format!(
        "name = \"c\"\nrobot = \"robot.toml\"\nsynthetic = \"computed\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 20\n\
         coverage_factor = 2\nexpanded_rotation_uncertainty_deg = 0.01\n{body}\n[identify]\ncalibration = \"all\"\n"
    );
    std::fs::write(at.join("c/campaign.toml"), text).unwrap();
    let (code, _, said) = program(at, &["run", "c"]);
    let document = std::fs::read(at.join("c/out/parameters.json")).unwrap_or_default();
    (code, said, serde_json::from_slice(&document).ok())
}

const LOG: &str =
    "q1_deg = \"q1\", q2_deg = \"q2\", q3_deg = \"q3\", q4_deg = \"q4\", q5_deg = \"q5\", q6_deg = \"q6\"";
const FRAME: &str = "[frame.world]\nas_exported = true\n";

/// The same poses as a table of observations and in every form of an export, and the log.
fn write_files(at: &Path, rows: &[Row]) {
    let mut plain = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz\n".to_owned();
    let mut log = "pose,label,t,q1,q2,q3,q4,q5,q6\n".to_owned();
    let mut labels = "name,x,y,z,qw,qx,qy,qz\n".to_owned();
    let mut quaternions =
        "X  [mm],Y  [mm],Z  [mm],U(95) X  [mm],U(95) Y  [mm],U(95) Z  [mm],Q0 ,Q1 ,Q2 ,Q3\n".to_owned();
    let mut matrices = "n,x,y,z,r11,r12,r13,r21,r22,r23,r31,r32,r33,bad\n".to_owned();
    let mut angles = "time;x;y;z;rx;ry;rz\n".to_owned();
    let mut vectors = "pose,x,y,z,rx,ry,rz\n".to_owned();
    let order: AngleOrder = "zyx".parse().unwrap();
    for (i, (q, p, o)) in (1..).zip(rows) {
        let pose = Pose::from_quaternion(*o);
        let _ = writeln!(plain, "{i},probe,{},{},{}", line(q.clone()), line(*p), line(*o));
        let _ = writeln!(log, "{i},M{i},{},{}", 1000 + 10 * i, line(q.clone()));
        let _ = writeln!(labels, "M{i},{},{}", line(*p), line(*o));
        let _ = writeln!(quaternions, "{},0.02,0.02,0.02,{}", line(*p), line(*o));
        let _ = writeln!(matrices, "{i},{},{},0", line(*p), line(pose.rotation.into_iter().flatten()));
        let rad = order.angles(&pose);
        let stamp = format!("'11.10.2022 15:{:02}:{:02}.250", i / 6, 10 * (i % 6));
        let _ = writeln!(
            angles,
            "{stamp};{};{}",
            line(*p).replace(',', ";"),
            line(rad.map(f64::to_degrees)).replace(',', ";")
        );
        let _ = writeln!(vectors, "{i},{},{}", line(p.map(|v| v / 1000.0)), line(pose.rotation_vector_rad()));
    }
    // a row that the operator has deleted
    matrices += "9,1,2,3,1,0,0,0,1,0,0,0,1,1\n";
    for (name, text) in [
        ("plain.csv", &plain),
        ("log.csv", &log),
        ("labels.csv", &labels),
        ("at960.csv", &quaternions),
        ("matrices.csv", &matrices),
        ("angles.csv", &angles),
        ("vectors.csv", &vectors),
    ] {
        std::fs::write(at.join("c").join(name), text).unwrap();
    }
}

/// Parameters equal to a thousandth of their uncertainties.
fn are_alike(found: &ParametersDocument, right: &ParametersDocument, body: &str) {
    assert_eq!(found.parameters.len(), right.parameters.len(), "{body}");
    for (a, b) in found.parameters.iter().zip(&right.parameters) {
        let u = b.standard_uncertainty.unwrap_or(1e-6).max(1e-9);
        let is_alike = a.name == b.name && (a.value - b.value).abs() < 1e-3 * u;
        assert!(is_alike, "{body}\n{}: {} {}", a.name, a.value, b.value);
    }
}

#[test]
fn poses_of_a_tracker_meet_a_log_in_every_form() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = rows(at);
    write_files(at, &rows);
    let (code, said, right) = run(at, "[observations]\nfile = \"plain.csv\"");
    assert_eq!(code, Some(0), "{said}");
    let right = right.unwrap();
    let export = |file: &str, unit: &str, format: &str, more: &str, log: &str, join: &str| {
        format!(
            "[[export]]\nfile = \"{file}\"\nunit = \"{unit}\"\nformat = {format}\ntarget = \"probe\"\n{more}\n[log]\nfile = \"log.csv\"\n\
             columns = {{ {log}{LOG} }}\n[join]\n{join}\n{FRAME}"
        )
    };
    let row = "pose = \"row\"";
    let matrix = "{ delimiter = \",\", header = 1, columns = [\"pose\", \"x\", \"y\", \"z\", \"r11\", \"r12\", \"r13\", \"r21\", \"r22\", \
                  \"r23\", \"r31\", \"r32\", \"r33\", \"deleted\"] }";
    let angle = "{ delimiter = \";\", header = 1, columns = [\"timestamp\", \"x\", \"y\", \"z\", \"rx_deg\", \"ry_deg\", \"rz_deg\"], rotation = \"zyx\" }";
    let vector = "{ delimiter = \",\", header = 1, columns = [\"pose\", \"x\", \"y\", \"z\", \"rx_rad\", \"ry_rad\", \"rz_rad\"] }";
    let label =
        "{ delimiter = \",\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\", \"qw\", \"qx\", \"qy\", \"qz\"] }";
    let by_label =
        export("labels.csv", "mm", label, "", "label = \"label\", ", "by = \"label\"\ntargets = [\"probe\"]").replacen(
            "target = \"probe\"\n",
            "",
            1,
        );
    // seconds from 1970 to the first log time: the stamps count from 15:00:10.25, the log from 1010 s
    let offset = 1_665_500_400.0 + 10.25 - 1010.0;
    let time = format!("by = \"time\"\nclock_offset_s = {offset}\ntolerance_s = 0.01");
    let pose = "by = [\"pose\"]";
    for body in [
        export("at960.csv", "mm", "\"leica-at960\"", row, "", "by = \"row\""),
        export("matrices.csv", "mm", matrix, "", "pose = \"pose\", ", pose),
        export("vectors.csv", "m", vector, "", "pose = \"pose\", ", pose),
        export("angles.csv", "mm", angle, row, "time_s = \"t\", ", &time),
        by_label.clone(),
    ] {
        let (code, said, found) = run(at, &body);
        assert_eq!(code, Some(0), "{body}\n{said}");
        are_alike(&found.unwrap(), &right, &body);
    }
    // slips: a transposed matrix, scalar last, angles in another order, a wrong clock
    let transposed = matrix
        .replace("r12", "r_")
        .replace("r21", "r12")
        .replace("r_", "r21")
        .replace("r13", "r_")
        .replace("r31", "r13")
        .replace("r_", "r31")
        .replace("r23", "r_")
        .replace("r32", "r23")
        .replace("r_", "r32");
    let last = "{ delimiter = \",\", header = 1, columns = [\"x\", \"y\", \"z\", \"-\", \"-\", \"-\", \"qx\", \"qy\", \"qz\", \"qw\"] }";
    for body in [
        export("matrices.csv", "mm", &transposed, "", "pose = \"pose\", ", pose),
        export("at960.csv", "mm", last, row, "", "by = \"row\""),
        export("angles.csv", "mm", &angle.replace("zyx", "xyz"), row, "time_s = \"t\", ", &time),
        export(
            "angles.csv",
            "mm",
            angle,
            row,
            "time_s = \"t\", ",
            &time.replace("clock_offset_s = 1", "clock_offset_s = 2"),
        ),
    ] {
        let (code, said, _) = run(at, &body);
        assert!(matches!(code, Some(1 | 2)), "{body}\n{code:?} {said}");
    }
    // a label that the log names again is a place: its orientation is not that of the body
    let log = std::fs::read_to_string(at.join("c/log.csv")).unwrap();
    std::fs::write(at.join("c/log.csv"), log.replace(",M2,", ",M1,")).unwrap();
    let (_, said, _) = run(at, &by_label);
    assert!(said.contains("warning[label-orientations-unused]"), "{said}");
    std::fs::write(at.join("c/log.csv"), log).unwrap();
    refused_statements(at, &|format| export("at960.csv", "mm", format, row, "", "by = \"row\""));
}

/// Statements that cannot be read.
fn refused_statements(at: &Path, campaign: &dyn Fn(&str) -> String) {
    // a quaternion that is none, a part of an orientation, uncertainties without their factor
    for (format, part) in [
        (
            "{ delimiter = \",\", header = 1, columns = [\"x\", \"y\", \"z\", \"qw\", \"qx\", \"qy\", \"qz\", \"-\", \"-\", \"-\"] }",
            "[quaternion-length]",
        ),
        (
            "{ delimiter = \",\", header = 1, columns = [\"x\", \"y\", \"z\", \"-\", \"-\", \"-\", \"qw\", \"qx\", \"qy\", \"-\"] }",
            "error[column-group-incomplete]",
        ),
        (
            "{ delimiter = \",\", header = 1, columns = [\"x\", \"y\", \"z\", \"u95x\", \"u95y\", \"u95z\", \"-\", \"-\", \"-\", \"-\"] }",
            "error[coverage-factor-missing]",
        ),
    ] {
        let (code, said, _) = run(at, &campaign(format));
        assert!(code == Some(2) && said.contains(part), "{format}: {said}");
    }
}

/// Every second pose from another station: the same robot, and the pose of the station.
#[test]
fn poses_of_a_table_may_be_of_another_station() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = rows(at);
    let station = Pose { translation_mm: [700.0, -1200.0, 250.0], ..Pose::from_rotation_vector([0.2, -0.1, 1.9]) };
    let mut table =
        "station,pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz\n".to_owned();
    for (i, (q, p, o)) in (1..).zip(&rows) {
        let world = Pose { translation_mm: *p, ..Pose::from_quaternion(*o) };
        let (name, seen) = if i % 2 == 0 { ("T2", station.inverse().then(&world)) } else { ("T1", world) };
        let _ = writeln!(
            table,
            "{name},{i},probe,{},{},{}",
            line(q.clone()),
            line(seen.translation_mm),
            line(seen.quaternion())
        );
    }
    std::fs::write(at.join("c/stations.csv"), &table).unwrap();
    let (code, said, found) = run(at, "[observations]\nfile = \"stations.csv\"");
    assert_eq!(code, Some(0), "{said}");
    let found = found.unwrap();
    let value = |name: &str| found.parameters.iter().find(|p| p.name == name).unwrap().value;
    for (name, right) in [("T2_x", 700.0), ("T2_y", -1200.0), ("T2_z", 250.0)] {
        assert!((value(name) - right).abs() < 0.2, "{name}: {}", value(name));
    }
    // a slip of the second station alone: its scalar last
    let slip: String = table
        .lines()
        .map(|row| {
            let mut cells: Vec<&str> = row.split(',').collect();
            if cells[0] == "T2" {
                cells[12..].rotate_left(1);
            }
            cells.join(",") + "\n"
        })
        .collect();
    std::fs::write(at.join("c/stations.csv"), slip).unwrap();
    let (code, said, _) = run(at, "[observations]\nfile = \"stations.csv\"");
    assert!(code != Some(0), "{said}");
}

#[test]
fn temperatures_of_rows_are_a_condition_and_contradict_statements() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = rows(at);
    write_files(at, &rows);
    let mut text = "x,y,z,t\n".to_owned();
    for (i, (_, p, _)) in rows.iter().enumerate() {
        let _ = writeln!(text, "{},{}", line(*p), 19.5 + 0.1 * i as f64);
    }
    std::fs::write(at.join("c/warm.csv"), text).unwrap();
    let body = |more: &str| {
        format!(
            "{more}\n[[export]]\nfile = \"warm.csv\"\nunit = \"mm\"\ntarget = \"probe\"\npose = \"row\"\n\
             format = {{ delimiter = \",\", header = 1, columns = [\"x\", \"y\", \"z\", \"temperature_c\"] }}\n\
             [log]\nfile = \"log.csv\"\ncolumns = {{ pose = \"pose\", {LOG} }}\n[join]\nby = [\"pose\"]\n{FRAME}"
        )
    };
    let expansion = |expanded: f64| {
        format!(
            "[expansion]\nexpanded_temperature_uncertainty_c = {expanded}\ncoverage_factor = 2\nrobot_per_c = 23e-6\n"
        )
    };
    let (code, said, _) = run(at, &body(""));
    assert!(code == Some(0) && !said.contains("[temperature"), "{said}");
    let campaign = std::fs::read_to_string(at.join("c/out/campaign.json")).unwrap();
    let campaign: serde_json::Value = serde_json::from_str(&campaign).unwrap();
    assert_eq!(campaign["temperature_range_c"], serde_json::json!([19.5, 22.4]));
    let (_, said, _) = run(at, &body(&expansion(1.0)));
    assert!(said.contains("warning[temperature-varies]"), "{said}");
    let (_, said, _) = run(at, &body(&expansion(2.0)));
    assert!(!said.contains("[temperature"), "{said}");
    // degrees Fahrenheit
    let text = std::fs::read_to_string(at.join("c/campaign.toml")).unwrap();
    std::fs::write(at.join("c/campaign.toml"), text.replacen("name = ", "temperature_c = 68.0\nname = ", 1)).unwrap();
    let (_, _, said) = program(at, &["check", "c"]);
    assert!(said.contains("warning[temperature-elsewhere]"), "{said}");
}
