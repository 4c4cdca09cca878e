//! Files of strangers become campaigns: angles beside a log, traces of KUKA, sheets of a workbook, tests of poses, reversed joints, the
//! world of a planar robot, and a motion without a common clock. All data are synthetic.

use super::init::{answer, found, is_calibrated, measured};
use super::program;
use crate::support::root;
use etalon::base::angle_order::AngleOrder;
use etalon::base::phrase;
use etalon::base::pose::Pose;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

const INSTRUMENT: [(&str, &str); 3] =
    [("name", "\"tracker\""), ("expanded_uncertainty_um", "20"), ("expanded_rotation_uncertainty_deg", "0.01")];

fn text(at: &Path, file: &str) -> String {
    std::fs::read_to_string(at.join(file)).unwrap()
}

/// Joint values (deg) with a heading, row by row.
fn log_text(rows: &[(Vec<f64>, [f64; 3], [f64; 4])], signs: [f64; 6]) -> String {
    let mut log = "A1 [deg];A2 [deg];A3 [deg];A4 [deg];A5 [deg];A6 [deg]\n".to_owned();
    for (q, ..) in rows {
        let cells: Vec<String> = q.iter().zip(signs).map(|(v, sign)| format!("{:.5}", sign * v.to_degrees())).collect();
        let _ = writeln!(log, "{}", cells.join(";"));
    }
    log
}

/// Angles (rad) of an orientation as a file has them.
type Angles<'a> = &'a dyn Fn(&Pose) -> [f64; 3];

#[test]
fn angles_of_a_second_file_are_used_in_the_order_that_the_robot_shows() {
    let order: AngleOrder = "fixed xyz".parse().unwrap();
    let forms: [(&str, Angles); 3] = [
        ("zyx", &|pose| AngleOrder::default().angles(pose)),
        ("fixed xyz", &|pose| order.angles(pose)),
        ("vector", &Pose::rotation_vector_rad),
    ];
    for (rotation, angles) in forms {
        let folder = tempfile::tempdir().unwrap();
        let at = folder.path();
        let rows = measured(at, 60);
        let mut points = "X;Y;Z;A;B;C\n".to_owned();
        for (_, p, o) in &rows {
            let turned = angles(&Pose::from_quaternion(*o)).map(f64::to_degrees);
            let cells: Vec<String> = p.iter().chain(&turned).map(|v| format!("{v:.5}")).collect();
            let _ = writeln!(points, "{}", cells.join(";"));
        }
        std::fs::write(at.join("points.csv"), points).unwrap();
        std::fs::write(at.join("log.csv"), log_text(&rows, [1.0; 6])).unwrap();
        let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv", "log.csv"]);
        assert_eq!(code, Some(0), "{said}");
        let proposed = text(at, "mine/campaign.toml");
        let columns = "\"x\", \"y\", \"z\", \"rx_deg\", \"ry_deg\", \"rz_deg\"";
        assert!(proposed.contains(&format!("rotation = \"{rotation}\"")) && proposed.contains(columns), "{proposed}");
        assert_eq!(answer(at, &INSTRUMENT).len(), 3);
        let document = found(at);
        is_calibrated(&document);
        assert!(document.parameters.iter().all(|p| p.standard_uncertainty.is_none_or(f64::is_finite)), "{rotation}");
    }
}

/// Without a robot the order of the angles and their unit stay open, and `check` asks for both.
#[test]
fn angles_whose_order_nothing_shows_are_asked() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = measured(at, 8);
    let mut points = "pose;X [mm];Y [mm];Z [mm];A;B;C\n".to_owned();
    for (i, (_, p, _)) in (1..).zip(&rows) {
        let _ = writeln!(points, "{i};{:.4};{:.4};{:.4};{}.5;20.5;{}.25", p[0], p[1], p[2], 3 * i, 2 * i);
    }
    std::fs::write(at.join("points.csv"), points).unwrap();
    let log = log_text(&rows, [1.0; 6]).lines().zip(0..).fold(String::new(), |log, (line, i)| {
        log + &(if i == 0 { format!("pose;{line}\n") } else { format!("{i};{line}\n") })
    });
    std::fs::write(at.join("log.csv"), log).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let (code, said) = program(at, &["check", "mine", "--json"]);
    assert_eq!(code, Some(2), "{said}");
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    let asked = |id: &str| document["errors"].as_array().unwrap().iter().filter(|e| e["id"] == id).count();
    let keys: Vec<&str> =
        document["errors"].as_array().unwrap().iter().filter_map(|error| error["arguments"]["key"].as_str()).collect();
    assert!(asked("angle-unit-open") == 1 && keys.contains(&"rotation"), "{said}");
}

/// A trace of KUKA by the codes of DIAdem: measured and commanded axes, interleaved in a second file.
fn trace(at: &Path, step_s: f64, axes_deg: &[Vec<f64>]) {
    let count = axes_deg.len();
    let mut head = format!(
        "DIAEXTENDED  {{@:ENGLISH\n#BEGINGLOBALHEADER\n1,WINDOWS 32Bit\n112,Low -> High\n#ENDGLOBALHEADER\n\n#BEGINCHANNELHEADER\n\
         200,Zeit\n202,s\n210,IMPLIZIT\n220,{count}\n240,0\n241,{step_s}\n#ENDCHANNELHEADER\n"
    );
    let names =
        ["AxisPos_Act", "AxisPos_CmdIpo"].into_iter().flat_map(|name| (1..=6).map(move |k| format!("{name}{k}")));
    for (place, name) in (1..).zip(names) {
        let _ = write!(
            head,
            "#BEGINCHANNELHEADER\n200,{name}\n202,deg\n210,EXPLIZIT\n211,Cal_KRCIpo.r64\n213,BLOCK\n214,REAL64\n220,{count}\n\
             221,{place}\n240,0\n241,1\n#ENDCHANNELHEADER\n"
        );
    }
    std::fs::write(at.join("Cal_KRCIpo.dat"), head).unwrap();
    let numbers: Vec<u8> =
        axes_deg.iter().flat_map(|row| [&row[..], row].concat()).flat_map(f64::to_le_bytes).collect();
    std::fs::write(at.join("Cal_KRCIpo.r64"), numbers).unwrap();
}

#[test]
fn a_trace_of_kuka_with_its_numbers_joins_timed_points_at_standstills() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let (mut axes, mut points, mut last) = (Vec::new(), "time_s,x_mm,y_mm,z_mm\n".to_owned(), vec![0.0; 6]);
    for (i, (q, p, _)) in measured(at, 40).into_iter().enumerate() {
        let next: Vec<f64> = q.iter().map(|v| v.to_degrees()).collect();
        axes.extend((1..=40).map(|k| last.iter().zip(&next).map(|(a, b)| a + (b - a) * f64::from(k) / 40.0).collect()));
        axes.extend(std::iter::repeat_n(next.clone(), 120 + (37 * i) % 50));
        let time = 512.3 + 0.012 * (axes.len() as f64 - 60.0);
        let _ = writeln!(points, "{time:.3},{:.4},{:.4},{:.4}", p[0], p[1], p[2]);
        last = next;
    }
    trace(at, 0.012, &axes);
    std::fs::write(at.join("points.csv"), points).unwrap();
    let files = ["points.csv", "Cal_KRCIpo.dat"];
    let (code, said) = program(at, &[&["init", "mine", "--robot", "ur5e", "--from"], &files[..]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert!(at.join("mine/Cal_KRCIpo.r64").is_file(), "{said}");
    let proposed = text(at, "mine/campaign.toml");
    for part in
        ["format = \"kuka_trace\"", "q6_deg = \"AxisPos_Act6\"", "clock_offset_s = \"standstills\"", "[[export]]"]
    {
        assert!(proposed.contains(part), "{part}: {proposed}");
    }
    assert!(!proposed.contains("_UNIT"), "{proposed}");
    // the format fixes the units: the instrument alone is asked for
    assert_eq!(answer(at, &INSTRUMENT).len(), 2);
    is_calibrated(&found(at));
    // the file of numbers may be named, too
    let files = ["points.csv", "Cal_KRCIpo.r64", "Cal_KRCIpo.dat"];
    let (code, said) = program(at, &[&["init", "again", "--robot", "ur5e", "--from"], &files[..]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(text(at, "again/campaign.toml").matches("[[export]]").count(), 1);
}

/// A workbook of sheets, whose cells are the fields between tabs; numbers are numbers.
fn workbook(sheets: &[(&str, String)]) -> Vec<u8> {
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let related = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let packaged = "http://schemas.openxmlformats.org/package/2006";
    let office = "application/vnd.openxmlformats-officedocument.spreadsheetml";
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let mut add = |name: &str, text: String| {
        archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
    };
    let all = |one: &dyn Fn(usize, &str) -> String| -> String {
        sheets.iter().enumerate().map(|(i, (name, _))| one(i + 1, name)).collect()
    };
    let overrides = all(&|i, _| {
        format!("<Override PartName=\"/xl/worksheets/sheet{i}.xml\" ContentType=\"{office}.worksheet+xml\"/>")
    });
    add(
        "[Content_Types].xml",
        format!(
            "<Types xmlns=\"{packaged}/content-types\"><Default Extension=\"rels\" \
             ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
             <Override PartName=\"/xl/workbook.xml\" ContentType=\"{office}.sheet.main+xml\"/>{overrides}</Types>"
        ),
    );
    let relation = |i: usize, kind: &str, target: &str| {
        format!("<Relationship Id=\"r{i}\" Type=\"{related}/{kind}\" Target=\"{target}\"/>")
    };
    let relations = |all: String| format!("<Relationships xmlns=\"{packaged}/relationships\">{all}</Relationships>");
    add("_rels/.rels", relations(relation(1, "officeDocument", "xl/workbook.xml")));
    let names = all(&|i, name| format!("<sheet name=\"{name}\" sheetId=\"{i}\" r:id=\"r{i}\"/>"));
    add(
        "xl/workbook.xml",
        format!("<workbook xmlns=\"{main}\" xmlns:r=\"{related}\"><sheets>{names}</sheets></workbook>"),
    );
    let parts = all(&|i, _| relation(i, "worksheet", &format!("worksheets/sheet{i}.xml")));
    add("xl/_rels/workbook.xml.rels", relations(parts));
    for (i, (_, text)) in (1..).zip(sheets) {
        let cell = |(at, field): (usize, &str)| {
            let place = char::from(b'A' + at as u8);
            match field.parse::<f64>() {
                Ok(number) => format!("<c r=\"{place}ROW\"><v>{number}</v></c>"),
                Err(_) => format!("<c r=\"{place}ROW\" t=\"inlineStr\"><is><t>{field}</t></is></c>"),
            }
        };
        let row = |(row, line): (usize, &str)| {
            let cells: String = line.split('\t').enumerate().map(cell).collect();
            format!("<row r=\"{row}\">{}</row>", cells.replace("ROW", &row.to_string()))
        };
        let rows: String = (1..).zip(text.lines()).map(row).collect();
        add(
            &format!("xl/worksheets/sheet{i}.xml"),
            format!("<worksheet xmlns=\"{main}\"><sheetData>{rows}</sheetData></worksheet>"),
        );
    }
    archive.finish().unwrap().into_inner()
}

#[test]
fn two_sheets_of_one_workbook_are_an_export_and_a_log() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = measured(at, 60);
    let (mut points, mut log) =
        ("Pose\tX [mm]\tY [mm]\tZ [mm]\n".to_owned(), "Pose\tJ1\tJ2\tJ3\tJ4\tJ5\tJ6\n".to_owned());
    for (i, (q, p, _)) in (1..).zip(&rows) {
        let _ = writeln!(points, "{i}\t{:.5}\t{:.5}\t{:.5}", p[0], p[1], p[2]);
        let cells: Vec<String> = q.iter().map(|v| format!("{:.6}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i}\t{}", cells.join("\t"));
    }
    let notes = "Raum\tHalle 3\nPrüfer\tMeier\n".to_owned();
    let book = workbook(&[("Notizen", notes), ("Achsen", log), ("Messung", points)]);
    std::fs::write(at.join("kalibrierung.xlsx"), book).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "kalibrierung.xlsx"]);
    assert_eq!(code, Some(0), "{said}");
    let proposed = text(at, "mine/campaign.toml");
    for part in ["sheet = \"Achsen\"", "sheet = \"Messung\"", "by = [\"pose\"]", "targets = [\"Messung\"]"] {
        assert!(proposed.contains(part), "{part}: {proposed}");
    }
    assert_eq!(answer(at, &INSTRUMENT).len(), 2);
    is_calibrated(&found(at));
    let (code, said) = program(at, &["formats", "kalibrierung.xlsx"]);
    assert!(code == Some(0) && said.contains("by = [\"pose\"]"), "{said}");
}

/// Attained and commanded poses under headings of a stranger are a test of poses, not exports of two targets.
#[test]
fn poses_in_cycles_and_the_same_poses_once_are_a_test_of_poses() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let place = |p: i32| [100.0 * f64::from(p), 50.0 * f64::from(p * p), 300.0 - 10.0 * f64::from(p)];
    let (mut attained, mut commanded) =
        ("Pose;Zyklus;X [mm];Y [mm];Z [mm]\n".to_owned(), "Pose;X [mm];Y [mm];Z [mm]\n".to_owned());
    for cycle in 1..=30 {
        for p in 1..=5 {
            let off = 0.01 * f64::from((7 * cycle + 3 * p) % 5);
            let [x, y, z] = place(p).map(|v| v + off);
            let _ = writeln!(attained, "{p};{cycle};{x:.3};{y:.3};{z:.3}");
        }
    }
    for p in 1..=5 {
        let [x, y, z] = place(p);
        let _ = writeln!(commanded, "{p};{x:.3};{y:.3};{z:.3}");
    }
    std::fs::write(at.join("ist.csv"), attained).unwrap();
    std::fs::write(at.join("soll.csv"), commanded).unwrap();
    let (code, lines) = program(at, &["formats", "soll.csv", "ist.csv"]);
    assert_eq!(code, Some(0), "{lines}");
    assert!(lines.contains("\n[poses]\n") && !lines.contains("[[export]]"), "{lines}");
    let head = "name = \"t\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 10\ncoverage_factor = 2\n";
    std::fs::write(at.join("campaign.toml"), format!("{head}{}", lines.split("next:").next().unwrap())).unwrap();
    let (code, said) = program(at, &["run", "."]);
    assert_eq!(code, Some(0), "{said}");
    let document: serde_json::Value = serde_json::from_str(&text(at, "out/iso9283.json")).unwrap();
    assert_eq!(document["poses"].as_array().map(Vec::len), Some(5), "{document}");
}

/// A joint that counts against the robot file is a question of `init`: either of the two may be wrong.
#[test]
fn a_reversed_joint_is_asked() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = measured(at, 60);
    let mut points = "X [mm];Y [mm];Z [mm]\n".to_owned();
    for (_, p, _) in &rows {
        let _ = writeln!(points, "{:.4};{:.4};{:.4}", p[0], p[1], p[2]);
    }
    std::fs::write(at.join("points.csv"), points).unwrap();
    std::fs::write(at.join("log.csv"), log_text(&rows, [1.0, 1.0, -1.0, 1.0, 1.0, -1.0])).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let proposed = text(at, "mine/campaign.toml");
    assert!(proposed.contains("q3_deg = { name = \"A3 [deg]\", per_count = \"?\" }"), "{proposed}");
    let (_, said) = program(at, &["check", "mine", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    let keys = document["errors"].as_array().unwrap().iter().filter(|error| error["arguments"]["key"] == "per_count");
    assert_eq!(keys.count(), 1, "{said}");
    std::fs::write(at.join("mine/campaign.toml"), proposed.replace("per_count = \"?\"", "per_count = -1")).unwrap();
    assert_eq!(answer(at, &INSTRUMENT).len(), 2);
    is_calibrated(&found(at));
}

/// The model of a planar robot has no place of its base: whether the instrument measured in its frame is asked.
#[test]
fn the_world_of_a_robot_without_a_place_of_its_base_is_asked() {
    let folder = tempfile::tempdir().unwrap();
    let sample = |file: &str| root().join("samples/prexyt-cmm").join(file).display().to_string();
    let files = ["robot.toml", "exports/poses.txt", "exports/world.txt", "encoders.csv"].map(sample);
    let [robot, poses, world, log] = files.each_ref().map(String::as_str);
    let (code, said) = program(folder.path(), &["init", "mine", "--robot", robot, "--from", poses, world, log]);
    assert_eq!(code, Some(0), "{said}");
    let proposed = text(folder.path(), "mine/campaign.toml");
    assert!(proposed.contains("as_exported = \"?\"") && proposed.contains("\"rail2_a\""), "{proposed}");
}

/// Points of a moving robot on another clock than the log: the offset is determined from the speeds of both.
#[test]
fn a_motion_without_a_common_clock_is_proposed_by_its_speeds() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    assert_eq!(program(at, &["init", "nominal", "--robot", "ur5e"]).0, Some(0));
    let arm = etalon::campaign::read_robot(&at.join("nominal/robot.toml")).unwrap().build(&["t".to_owned()]).unwrap();
    let mut values = arm.nominal();
    for (p, value) in arm.parameters().iter().zip(&mut values) {
        *value += match p.name.as_str() {
            "base_x" => 1500.0,
            "t_x" => 60.0,
            _ => 0.0,
        };
    }
    let joints = |t: f64| -> Vec<f64> {
        let rates = [0.31, 0.43, 0.57, 0.29, 0.37, 0.61];
        (0..6).map(|k| 0.9 * (rates[k] * t + 0.8 * (0.11 * t + k as f64).sin()).sin()).collect()
    };
    let (mut log, mut points) = ("t [s];A1;A2;A3;A4;A5;A6\n".to_owned(), "Time [s];X;Y;Z\n".to_owned());
    for i in 0..4000 {
        let t = 0.02 * f64::from(i);
        let cells: Vec<String> = joints(t).iter().map(|v| format!("{v:.7}")).collect();
        let _ = writeln!(log, "{t:.3};{}", cells.join(";"));
    }
    for i in 0..500 {
        let t = 5.0 + 0.1 * f64::from(i);
        let p = arm.position(&values, &joints(t), 0);
        let _ = writeln!(points, "{:.4};{:.4};{:.4};{:.4}", t + 3600.5, p[0], p[1], p[2]);
    }
    std::fs::write(at.join("log.csv"), log).unwrap();
    std::fs::write(at.join("points.csv"), points).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let proposed = text(at, "mine/campaign.toml");
    assert!(proposed.contains("clock_offset_s = \"motion\"") && proposed.contains("interpolate = true"), "{proposed}");
    // robot.toml states no place of the reflector, which is 60 mm beside the flange
    assert_eq!(answer(at, &[("unit", "\"mm\""), ("UNIT", "rad"), INSTRUMENT[0], INSTRUMENT[1]]).len(), 4);
    let document = found(at);
    let is_place = |name: &str| name.ends_with("_x") && !name.starts_with("base");
    let place = document.parameters.iter().find(|p| is_place(&p.name)).map(|p| p.value).unwrap();
    assert!((place - 60.0).abs() < 0.1, "{place}");
    assert!(document.residuals.rms < 0.05, "{}", document.residuals.rms);
}

/// Poses in four rows each, and records of a total station, are refused by their names.
#[test]
fn files_without_rows_of_points_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let matrix = "1,0,0,512.5\n0,1,0,-20.25\n0,0,1,300.5\n0,0,0,1\n";
    let gsi = |line: &str| format!("{line}110002+00000001 21.102+10000000 22.102+15000000 31..00+00002000\n");
    let feet = gsi("").replace("31..00+", "31..07+");
    let station = gsi("110003+00000ST1 84..40+00519659 85..40+00465244 86..40-00000588\n");
    for (id, arguments, text) in [
        ("matrices-in-blocks", &["formats", "f.txt"][..], matrix.repeat(3)),
        ("stations-several", &["fit", "plane", "f.txt", "--format", "leica_gsi", "--unit", "m"], station.repeat(2)),
        (
            "numbers-behind-names",
            &["formats", "f.txt"],
            "mark index: 1\npoint x:428.031 y:-37.130 z:431.590\n".repeat(3),
        ),
        ("gsi-feet", &["fit", "plane", "f.txt", "--format", "leica_gsi", "--unit", "m"], feet.repeat(4)),
        ("numbers-in-cells", &["formats", "f.txt"], "0.01;512.5,-20.3,300.5,0,0,0,1\n".repeat(5)),
    ] {
        std::fs::write(at.join("f.txt"), text).unwrap();
        let (code, said) = program(at, arguments);
        assert!(code == Some(2) && said.contains(&format!("error[{id}]")), "{said}");
    }
}

/// Rows of the log under these headings, behind a number of the row.
fn numbered_log(rows: &[(Vec<f64>, [f64; 3], [f64; 4])], head: &str) -> String {
    let mut log = format!("Nr;{head}\n");
    for (i, (q, ..)) in (1..).zip(rows) {
        let cells: Vec<String> = q.iter().map(|v| format!("{:.5}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i};{}", cells.join(";"));
    }
    log
}

/// The number of the rows joins files in another order, and the names of a controller's joints follow the robot's own order.
#[test]
fn a_number_joins_rows_in_another_order_with_the_joints_of_a_controller() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = measured(at, 60);
    let mut points = "Nr;X [mm];Y [mm];Z [mm]\n".to_owned();
    for i in (0..60).map(|i| (7 * i) % 60).filter(|i| i % 12 != 5) {
        let p = rows[i].1;
        let _ = writeln!(points, "{};{:.4};{:.4};{:.4}", i + 1, p[0], p[1], p[2]);
    }
    std::fs::write(at.join("points.csv"), points).unwrap();
    std::fs::write(at.join("log.csv"), numbered_log(&rows, "Base;Shoulder;Elbow;Wrist 1;Wrist 2;Wrist 3")).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let proposed = text(at, "mine/campaign.toml");
    for part in ["by = [\"pose\"]", "pose = \"Nr\", q1_deg = \"Base\"", "q6_deg = \"Wrist 3\""] {
        assert!(proposed.contains(part), "{part}: {proposed}");
    }
    assert_eq!(answer(at, &INSTRUMENT).len(), 2);
    is_calibrated(&found(at));
}

/// Headings that name the joints in another order than the kinematics are repaired with a doubt.
#[test]
fn headings_of_swapped_joints_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = measured(at, 40);
    let mut points = "Nr;X [mm];Y [mm];Z [mm]\n".to_owned();
    for (i, (_, p, _)) in (1..).zip(&rows) {
        let _ = writeln!(points, "{i};{:.4};{:.4};{:.4}", p[0], p[1], p[2]);
    }
    std::fs::write(at.join("points.csv"), points).unwrap();
    let told = |head: &str| {
        std::fs::write(at.join("log.csv"), numbered_log(&rows, head)).unwrap();
        let (code, said) =
            program(at, &["formats", "points.csv", "log.csv", "--robot", "nominal/robot.toml", "--json"]);
        assert_eq!(code, Some(0), "{said}");
        said.contains("robot-contradicts-order")
    };
    assert!(!told("shoulder_pan;shoulder_lift;elbow;wrist_1;wrist_2;wrist_3"));
    assert!(told("shoulder_pan;elbow;shoulder_lift;wrist_1;wrist_2;wrist_3"));
    assert!(!told("J1;J2;J3;J4;J5;J6") && told("J1;J3;J2;J4;J5;J6"));
}

/// A test of poses needs no robot: its tables may have the headings of a stranger, and may be one table.
#[test]
fn a_test_of_poses_is_started_without_a_robot() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let place = |p: i32| [100.0 * f64::from(p), 50.0 * f64::from(p * p), 300.0 - 10.0 * f64::from(p)];
    let cells = |[x, y, z]: [f64; 3]| format!("{x:.4};{y:.4};{z:.4}");
    let (mut attained, mut both) = (
        "Pose;Zyklus;X Ist;Y Ist;Z Ist\n".to_owned(),
        "Pose;Zyklus;X Ist;Y Ist;Z Ist;X Soll;Y Soll;Z Soll\n".to_owned(),
    );
    for (cycle, p) in (1..=30).flat_map(|cycle| (1..=5).map(move |p| (cycle, p))) {
        let off = 0.01 * f64::from((7 * cycle + 3 * p) % 5);
        let _ = writeln!(attained, "{p};{cycle};{}", cells(place(p).map(|v| v + off)));
        let _ = writeln!(both, "{p};{cycle};{};{}", cells(place(p).map(|v| v + off)), cells(place(p)));
    }
    let commanded =
        (1..=5).fold("Pose;X Soll;Y Soll;Z Soll\n".to_owned(), |all, p| all + &format!("{p};{}\n", cells(place(p))));
    for (file, text) in [("ist.csv", attained), ("soll.csv", commanded), ("beide.csv", both)] {
        std::fs::write(at.join(file), text).unwrap();
    }
    let mut found = Vec::new();
    for files in [&["ist.csv", "soll.csv"][..], &["beide.csv"]] {
        let (code, said) = program(at, &[&["init", "mine", "--from"], files].concat());
        assert_eq!(code, Some(0), "{said}");
        let path = at.join("mine/campaign.toml");
        let proposed = std::fs::read_to_string(&path).unwrap();
        assert!(proposed.contains("\n[poses]\n") && !proposed.contains("robot.toml\""), "{proposed}");
        let stated = proposed.replace("_UNIT", "_mm").replacen("name = \"?\"", "name = \"tracker\"", 1);
        std::fs::write(&path, stated.replace("expanded_uncertainty_um = \"?\"", "expanded_uncertainty_um = 10"))
            .unwrap();
        let (code, said) = program(at, &["run", "mine"]);
        assert_eq!(code, Some(0), "{said}");
        let document: serde_json::Value = serde_json::from_str(&text(at, "mine/out/iso9283.json")).unwrap();
        found.push(document["poses"].as_array().unwrap().iter().map(|pose| pose["ap_mm"].clone()).collect::<Vec<_>>());
        std::fs::remove_dir_all(at.join("mine")).unwrap();
    }
    assert!(found[0].len() == 5 && found[0] == found[1], "{found:?}");
    // other files need the robot
    std::fs::write(at.join("points.csv"), "Pose;X;Y;Z\n1;1.5;2.5;3.5\n2;2.5;3.5;5.5\n3;7.5;1.5;3.5\n").unwrap();
    let (code, said) = program(at, &["init", "mine", "--from", "points.csv"]);
    assert!(code == Some(2) && said.contains("error[from-needs-robot]"), "{said}");
}

/// Labels of a target and a pose in the words of a stranger are read in their own form.
#[test]
fn labels_with_words_for_target_and_pose_are_split_at_them() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let mut points = "Name;X [mm];Y [mm];Z [mm]\n".to_owned();
    for i in 0..24 {
        let t = f64::from(i);
        let _ = writeln!(
            points,
            "Pos{}:Ball{};{:.3};{:.3};{:.3}",
            i / 3 + 1,
            i % 3 + 1,
            900.0 + 50.0 * t.sin(),
            t * t,
            3.5 * t
        );
    }
    std::fs::write(at.join("points.csv"), points).unwrap();
    let (code, said) = program(at, &["formats", "points.csv"]);
    assert!(
        code == Some(0) && said.contains("label = \"Pos{pose}:{target}\"   # all 24 labels have this form"),
        "{said}"
    );
}

/// A sheet that repeats the points of the other sheets is left out, and points of several targets in the rows of one log are told.
#[test]
fn a_summary_sheet_is_left_out_and_stacked_targets_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let row = |i: usize| {
        let t = i as f64;
        format!("{:.3}\t{:.3}\t{:.3}\n", 500.0 + 90.0 * (1.3 * t).sin(), 70.0 * (0.7 * t).cos(), 90.5 + 2.5 * t)
    };
    let sheet = |rows: std::ops::Range<usize>| rows.fold("X\tY\tZ\n".to_owned(), |text, i| text + &row(i));
    let book = workbook(&[("one", sheet(0..5)), ("two", sheet(5..10)), ("all", sheet(0..10))]);
    std::fs::write(at.join("points.xlsx"), book).unwrap();
    let (code, said) = program(at, &["formats", "points.xlsx"]);
    let told = phrase!("doubt-summary", sheet = "all").to_string();
    assert!(code == Some(0) && said.contains(&told) && !said.contains("sheet = \"all\""), "{said}");
    assert_eq!(said.matches("\n[[export]]").count(), 2, "{said}");
    std::fs::write(at.join("points.txt"), sheet(0..36)).unwrap();
    let log = (0..12).fold("J1\tJ2\tJ3\n".to_owned(), |text, i| text + &row(i + 3));
    std::fs::write(at.join("log.txt"), log).unwrap();
    let (code, said) = program(at, &["formats", "points.txt", "log.txt"]);
    let (file, rows, count, poses) = ("points.txt", 36, 3, 12);
    let told = phrase!("rows-of-several-targets", file, rows, count, poses).to_string();
    assert!(code == Some(0) && said.contains(&told), "{said}");
}
