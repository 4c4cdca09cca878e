//! Files that carry joints and points together, joins by label, rows with uncertainties and rows that are left out.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, cmm_truth, copy_sample, ends};
use etalon::base::noise::Noise;
use etalon::documents::ParametersDocument;

const HEAD: &str = "name = \"mixed\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 6\ncoverage_factor = 2\n";
const TAIL: &str = "[frame.world]\nas_exported = true\n[identify]\ncalibration = \"1-40\"\nvalidation = \"rest\"\n";
const FORMAT: &str = "format = { delimiter = \";\", decimal = \",\", header = 1, columns = { target = \"ball\", x = \"X\", y = \"Y\", z = \"Z\"";

/// The CMM sample's robot, one row a reading: pose, ball, place, joints, and the uncertainty that noise of the row has.
fn rows() -> Vec<String> {
    let (robot, values, log) = cmm_truth();
    let mut noise = Noise::new(9, 1);
    let mut rows = Vec::new();
    for (pose, q) in (1..).zip(log.iter().take(59)) {
        for (k, ball) in ["K", "L"].into_iter().enumerate() {
            let u = if pose % 4 == 0 { 0.3 } else { 0.003 };
            let p = robot.position(&values, q, k);
            let [x, y] = [0, 1].map(|i| p[i] + noise.gaussian(u));
            rows.push(format!("P{pose};{ball};{x};{y};0;{};{};{};{u};{u};{u}", q[0], q[1], q[2]).replace('.', ","));
        }
    }
    rows
}

fn campaign(export: &str, more: &str, rows: &[String]) -> Scratch {
    let scratch = copy_sample("prexyt-cmm");
    let head = "Pose;ball;X;Y;Z;RP1;RP2;RP3;U;V;W\n";
    std::fs::write(scratch.path().join("all.csv"), format!("{head}{}\n", rows.join("\n"))).unwrap();
    let text = format!("{HEAD}[[export]]\nfile = \"all.csv\"\nunit = \"mm\"\n{export}\n{more}{TAIL}");
    std::fs::write(scratch.path().join("campaign.toml"), text).unwrap();
    scratch
}

fn parameters(scratch: &Scratch) -> ParametersDocument {
    let text = std::fs::read_to_string(scratch.path().join("out/parameters.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

const JOINTS: &str = "joints = { rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }";

#[test]
fn a_file_with_joints_and_points_is_joined_by_its_rows() {
    let rows = rows();
    let apart = format!("{FORMAT}, pose = \"Pose\" }} }}");
    let log = "[log]\nfile = \"all.csv\"\ndelimiter = \";\"\ndecimal = \",\"\ncolumns = { rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }\n[join]\nby = \"row\"\n";
    let select = |scratch: &Scratch| scratch.replace("campaign.toml", "\"1-40\"", "\"P1-P40\"");
    let twice = campaign(&apart, log, &rows);
    select(&twice);
    ends(&twice, "run", 0, &[]);
    let once = campaign(&format!("{apart}\n{JOINTS}"), "", &rows);
    select(&once);
    ends(&once, "check", 0, &[]);
    ends(&once, "run", 0, &[]);
    assert_eq!(parameters(&once).parameters, parameters(&twice).parameters);
    // rows are poses where the file names none
    let unnamed = campaign(&format!("{FORMAT} }} }}\n{JOINTS}"), "", &rows);
    ends(&unnamed, "check", 0, &[]);
    for (export, more, part) in [
        (format!("{apart}\n{JOINTS}"), log, "[joints-twice]"),
        (format!("{apart}\n{JOINTS}"), "[join]\nby = [\"pose\"]\n", "[joints-joined-by-row]"),
        (format!("{apart}\n{}", JOINTS.replace("RP2", "RP9")), "", "error[column-unknown]"),
        (format!("{apart}\n{}", JOINTS.replace("rho3_mm", "rho3_m m")), "", "[log-column-unknown]"),
        (format!("{apart}\n{}", JOINTS.replace(", rho3_mm = \"RP3\"", "")), "", "[log-joint-missing]"),
    ] {
        let scratch = campaign(&export.replace("rho3_m m", "\"rho3_m m\""), more, &rows);
        select(&scratch);
        ends(&scratch, "check", 2, &[part]);
    }
}

#[test]
fn rows_of_an_export_weigh_by_their_uncertainty_and_are_left_out_by_number() {
    let rows = rows();
    let weighted = format!("{FORMAT}, u1 = \"U\", u2 = \"V\", u3 = \"W\" }} }}\n{JOINTS}");
    let poor = |row: i64| (1..=118).contains(&row) && ((row + 1) / 2) % 4 == 0;
    let names: Vec<String> = (1..=118).filter(|row| poor(*row)).map(|row| row.to_string()).collect();
    let rule = format!(
        "[[identify.exclude]]\nfile = \"all.csv\"\nrows = \"{}\"\nreason = \"beam broken\"\n",
        names.join(", ")
    );
    // without the poor rows
    let without = campaign(&format!("{FORMAT}, pose = \"Pose\" }} }}\n{JOINTS}"), "", &rows);
    let add = |scratch: &Scratch, rule: &str| {
        scratch.replace(
            "campaign.toml",
            "calibration = \"1-40\"\nvalidation = \"rest\"\n",
            &format!("calibration = \"all\"\n{rule}"),
        );
    };
    add(&without, &rule);
    ends(&without, "run", 0, &["warning[excluded-rows] count=28", "`all.csv`", "beam broken"]);
    // with them, by their weight
    let with = campaign(&weighted.replace(", u1", ", pose = \"Pose\", u1"), "", &rows);
    add(&with, "");
    ends(&with, "run", 0, &["[readings-weighted]", "0.0030 to 0.3000 mm"]);
    let table = std::fs::read_to_string(with.path().join("out/observations.csv")).unwrap();
    assert!(table.starts_with("pose,cycle,target,x_mm,y_mm,cxx_mm2,cxy_mm2,cyy_mm2,rho1_mm"), "{}", &table[..200]);
    for (a, b) in parameters(&without).parameters.iter().zip(&parameters(&with).parameters) {
        let (Some(u), Some(v)) = (a.standard_uncertainty, b.standard_uncertainty) else { continue };
        assert!((a.value - b.value).abs() < 0.1 * u && (0.99..=1.01).contains(&(v / u)), "{}: {u} {v}", a.name);
    }
    for (rule, part) in [
        (
            "[[identify.exclude]]\nfile = \"all.csv\"\nrows = \"119\"\nreason = \"r\"\n",
            "[exclusion-matches-nothing] of=rows name=119",
        ),
        ("[[identify.exclude]]\nfile = \"al.csv\"\nrows = \"1\"\nreason = \"r\"\n", "did you mean `all.csv`"),
        ("[[identify.exclude]]\nrows = \"1\"\nreason = \"r\"\n", "[exclusion-mixed]"),
        ("[[identify.exclude]]\nfile = \"all.csv\"\nrows = \"1\"\nreason = \" \"\n", "[exclusion-without-reason]"),
    ] {
        let scratch = campaign(&weighted, "", &rows);
        add(&scratch, rule);
        ends(&scratch, "check", 2, &[part]);
    }
}

#[test]
fn a_serial_arm_touches_points_by_their_label() {
    let scratch = copy_sample("prexyt-cmm");
    let joint =
        |alpha, a, theta, d| format!("{{ alpha_deg = {alpha}, a_mm = {a}, theta_deg = {theta}, d_mm = {d} }},\n");
    let arm = [
        joint(0, 0, 0, 290),
        joint(-90, 0, -90, 0),
        joint(0, 270, 0, 0),
        joint(-90, 70, 0, 302),
        joint(90, 0, 0, 0),
        joint(-90, 0, 180, 72),
    ];
    let robot = format!("model = \"serial\"\njoint = [\n{}]\n", arm.concat());
    std::fs::write(scratch.path().join("robot.toml"), robot).unwrap();
    let arm =
        etalon::campaign::read_robot(&scratch.path().join("robot.toml")).unwrap().build(&["tip".to_owned()]).unwrap();
    let mut values = arm.nominal();
    for p in arm.parameters().iter().filter(|p| ["tip_x", "tip_y", "tip_z"].contains(&p.name.as_str())) {
        values[arm.parameters().iter().position(|q| q.name == p.name).unwrap()] = 60.0;
    }
    let mut noise = Noise::new(3, 1);
    let (mut points, mut log) = (String::new(), String::from("touches;j1;j2;j3;j4;j5;j6\n"));
    for i in 0..40 {
        let q: Vec<f64> = [2.0, 0.8, 0.8, 2.0, 1.5, 2.5].map(|range| noise.uniform(range)).to_vec();
        let p = arm.position(&values, &q, 0);
        let name = format!("hole {i}");
        points += &format!("{name};{};{};{}\n", p[0], p[1], p[2]);
        let cells: Vec<String> = q.iter().map(f64::to_string).collect();
        log += &format!("{name};{}\n", cells.join(";"));
    }
    std::fs::write(scratch.path().join("points.csv"), points).unwrap();
    std::fs::write(scratch.path().join("log.csv"), log).unwrap();
    let joints: Vec<String> = (1..=6).map(|i| format!("q{i}_rad = \"j{i}\"")).collect();
    let text = format!(
        "{HEAD}[contact]\nrepeatability_um = 15\ncoverage_factor = 3\n[[export]]\nfile = \"points.csv\"\nunit = \"mm\"\n\
         format = {{ delimiter = \";\", columns = [\"label\", \"x\", \"y\", \"z\"] }}\n\
         [log]\nfile = \"log.csv\"\ndelimiter = \";\"\ncolumns = {{ label = \"touches\", {} }}\n[join]\nby = \"label\"\ntargets = [\"tip\"]\n{TAIL}",
        joints.join(", ")
    );
    let text = text.replacen("[instrument]", "synthetic = \"computed\"\n[instrument]", 1);
    std::fs::write(scratch.path().join("campaign.toml"), text.replace("\"1-40\"", "\"1-36\"")).unwrap();
    ends(&scratch, "check", 0, &[]);
    ends(&scratch, "run", 0, &[]);
    let found = parameters(&scratch);
    assert!(found.residuals.rms < 1e-6, "{}", found.residuals.rms);
    scratch.replace("log.csv", "hole 7;", "hole seven;");
    ends(&scratch, "check", 2, &["error[label-not-measured]", "`hole seven`", "log.csv:9"]);
    scratch.replace("log.csv", "hole seven;", "hole 7;");
    scratch.replace("campaign.toml", "targets = [\"tip\"]", "targets = [\"tip\", \"tap\"]");
    ends(&scratch, "check", 2, &["error[join-by-label-targets]"]);
}

#[test]
fn what_formats_proposes_of_a_mixed_file_is_accepted() {
    let rows = rows();
    let scratch = campaign("", "", &rows);
    let table = std::fs::read_to_string(scratch.path().join("all.csv")).unwrap();
    let named = table.replacen(
        "Pose;ball;X;Y;Z;RP1;RP2;RP3;U;V;W",
        "pose;target;x_mm;y_mm;z_mm;rho1_mm;rho2_mm;rho3_mm;U;V;W",
        1,
    );
    std::fs::write(scratch.path().join("all.csv"), named).unwrap();
    let output = std::process::Command::new(crate::support::program())
        .args(["formats", "all.csv"])
        .current_dir(scratch.path())
        .output()
        .unwrap();
    let proposed = String::from_utf8(output.stdout).unwrap();
    assert!(!proposed.contains("[log]") && !proposed.contains("\"?\""), "{proposed}");
    // the names of the robot's joints are what the file does not state
    let proposed = ["q1", "q2", "q3"]
        .iter()
        .zip(["rho1", "rho2", "rho3"])
        .fold(proposed, |text, (q, rho)| text.replace(&format!("{q}_mm"), &format!("{rho}_mm")));
    std::fs::write(
        scratch.path().join("campaign.toml"),
        format!("{HEAD}{proposed}{TAIL}").replace("\"1-40\"", "\"P1-P40\""),
    )
    .unwrap();
    ends(&scratch, "check", 0, &[]);
}

/// Joints and measured poses of a probe on a six-axis arm, as a program with a decimal comma writes them: what `formats` proposes of them
/// is accepted, and gives what the plain table gives.
#[test]
fn measured_poses_in_a_layout_of_their_own_are_those_of_the_plain_table() {
    let folder = tempfile::tempdir().unwrap();
    let program = |arguments: &[&str]| {
        let output =
            std::process::Command::new(crate::support::program()).args(arguments).current_dir(folder.path()).output();
        let output = output.unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    assert_eq!(program(&["init", "cobot", "--robot", "ur5e"]).0, Some(0));
    let mut noise = Noise::new(21, 0);
    let joints: Vec<String> = (1..=30)
        .map(|pose| format!("{pose},{}", [(); 6].map(|()| format!("{:.4}", 100.0 * noise.uniform(1.2))).join(",")))
        .collect();
    let table = format!("pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n{}\n", joints.join("\n"));
    std::fs::write(folder.path().join("joints.csv"), table).unwrap();
    let (_, reached, said) = program(&["kinematics", "direct", "--robot", "cobot/robot.toml", "joints.csv"]);
    let reached: Vec<&str> = reached.lines().skip(1).collect();
    assert_eq!(reached.len(), joints.len(), "{said}");
    let rows: Vec<String> =
        joints.iter().zip(reached).map(|(q, at)| format!("{q},{}", at.split_once(',').unwrap().1)).collect();
    let head = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz,target,cycle\n";
    let plain: String = rows.iter().map(|row| format!("{row},probe,1\n")).collect();
    let own: String =
        rows.iter().map(|row| row.split_once(',').unwrap().1.replace(',', ";").replace('.', ",") + "\n").collect();
    let own_head = "J1;J2;J3;J4;J5;J6;X;Y;Z;QW;QX;QY;QZ\n";
    std::fs::write(folder.path().join("cobot/plain.csv"), head.to_owned() + &plain).unwrap();
    std::fs::write(folder.path().join("cobot/own.csv"), own_head.to_owned() + &own).unwrap();

    let proposed = program(&["formats", "cobot/own.csv"]).1.replace("file = \"cobot/own.csv\"", "file = \"own.csv\"");
    let proposed = (1..=6).fold(proposed, |text, j| text.replace(&format!("q{j}_UNIT"), &format!("q{j}_deg")));
    let proposed =
        ["x", "y", "z"].iter().fold(proposed, |text, c| text.replace(&format!("{c}_UNIT"), &format!("{c}_mm")));
    let campaign = |observations: &str| {
        let text = format!(
            "name = \"c\"\nrobot = \"robot.toml\"\nsynthetic = \"computed\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n\
             expanded_rotation_uncertainty_deg = 0.01\n{observations}\n[identify]\ncalibration = \"all\"\n"
        );
        std::fs::write(folder.path().join("cobot/campaign.toml"), text).unwrap();
        let (code, _, said) = program(&["run", "cobot"]);
        let document = std::fs::read(folder.path().join("cobot/out/parameters.json")).unwrap_or_default();
        (code, said, serde_json::from_slice::<ParametersDocument>(&document).ok())
    };
    let (code, said, stated) = campaign("[observations]\nfile = \"plain.csv\"");
    assert_eq!(code, Some(0), "{said}");
    let (code, said, laid_out) = campaign(&proposed);
    assert_eq!(code, Some(0), "{said}");
    let (stated, laid_out) = (stated.unwrap(), laid_out.unwrap());
    assert!(laid_out.parameters.iter().any(|p| p.name == "probe_rx" && p.standard_uncertainty.is_some()));
    for (a, b) in stated.parameters.iter().zip(&laid_out.parameters) {
        assert_eq!((&a.name, a.value, a.standard_uncertainty), (&b.name, b.value, b.standard_uncertainty));
    }

    // slips: each by name
    let slip = |from: &str, to: &str, expected: &str| {
        let (code, said, _) = campaign(&proposed.replacen(from, to, 1));
        assert!(code == Some(2) && said.says(expected), "{code:?} {said}");
    };
    slip("\"J1\"", "\"J7\"", "error[column-unknown]");
    slip("q2_deg = \"J2\"", "q2_deg = \"J1\"", "error[column-stated-twice]");
    slip("delimiter =", "sheet = \"A\"\ndelimiter =", "error[key-of-text-table]: `delimiter`");
    slip("x_mm =", "x =", "error[observation-column-unknown]: `x`");
    slip("pose = \"row\"", "", "[column-unknown]");
    let spoilt = own.replacen(';', ";x", 9);
    std::fs::write(folder.path().join("cobot/own.csv"), own_head.to_owned() + &spoilt).unwrap();
    let (code, said, _) = campaign(&proposed);
    assert!(code == Some(2) && said.contains("own.csv:2"), "{said}");
    // a cell of a quaternion that is not a number was an orientation that nobody measured
    let (first, rest) = plain.split_once(",probe").unwrap();
    let cut = first.rsplit_once(',').unwrap().0;
    std::fs::write(folder.path().join("cobot/plain.csv"), format!("{head}{cut},none,probe{rest}")).unwrap();
    let (code, said, _) = campaign("[observations]\nfile = \"plain.csv\"");
    assert!(code == Some(2) && said.contains("plain.csv:2") && said.contains("none"), "{said}");
}

#[test]
fn uncertainties_that_are_rounded_to_zero_are_read_as_their_resolution() {
    // microns, rounded to whole ones: those below half of one are 0
    let cells: Vec<String> = rows()
        .iter()
        .enumerate()
        .map(|(i, row)| {
            let u = if i % 3 == 0 { "0,000" } else { "0,003" };
            let kept = row.rsplitn(4, ';').last().unwrap();
            format!("{kept};{u};{u};{u}")
        })
        .collect();
    let export = format!("{FORMAT}, pose = \"Pose\", u1 = \"U\", u2 = \"V\", u3 = \"W\" }} }}\n{JOINTS}");
    let scratch = campaign(&export, "", &cells);
    scratch.replace("campaign.toml", "\"1-40\"", "\"P1-P40\"");
    let said = ends(&scratch, "run", 0, &["`u1` is 0 in 40 rows", "u = 0.00029 mm", "[uncertainty-zero-rounded]"]);
    assert_eq!(said.matches("is 0 in").count(), 2, "one warning a column that was measured:\n{said}");
    // a table of observations
    let written = std::fs::read_to_string(scratch.path().join("out/observations.csv")).unwrap();
    let table: Vec<String> = written
        .lines()
        .enumerate()
        .map(|(i, line)| {
            let cells: Vec<&str> = line.split(',').collect();
            let u = match i {
                0 => "u_mm",
                i if i % 3 == 0 => "0",
                _ => "0.003",
            };
            let keep = |k: &usize| !cells_of_covariance(&written).contains(k);
            let kept: Vec<&str> = (0..cells.len()).filter(keep).map(|k| cells[k]).collect();
            format!("{},{u}", kept.join(","))
        })
        .collect();
    let identify = |text: &str| {
        std::fs::write(scratch.path().join("o.csv"), text).unwrap();
        let command = ["identify", "--robot", "campaign/robot.toml", "--observations", "campaign/o.csv"];
        crate::support::scratch::said(&scratch, &[&command[..], &["--standard-uncertainty-um", "3"]].concat())
    };
    let (code, said) = identify(&table.join("\n"));
    assert!(code == Some(0) && said.matches("is 0 in").count() == 1, "{said}");
    assert!(said.contains("u = 0.00029 mm"), "{said}");
    // where all are 0 no resolution shows
    let (code, said) = identify(&table.join("\n").replace(",0.003", ",0"));
    assert!(code == Some(0) && said.contains("[uncertainty-zero]"), "{said}");
    // what is negative is none
    let (code, said) = identify(&table.join("\n").replace(",0.003", ",-0.003"));
    assert!(code == Some(2) && said.contains("error[coordinate-uncertainty-unusable]"), "{said}");
}

/// Columns of covariances in the first line of a table.
fn cells_of_covariance(table: &str) -> Vec<usize> {
    let header = table.lines().next().unwrap().split(',');
    header.enumerate().filter(|(_, name)| name.starts_with('c') && name.ends_with("mm2")).map(|(k, _)| k).collect()
}

/// A six-axis arm whose reflector a tracker measured, all in one file with semicolons: neither [log] nor [join] is stated, and `target`
/// names the reflector.
#[test]
fn joints_and_points_of_an_arm_need_neither_log_nor_join() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let program = |arguments: &[&str]| {
        let output = std::process::Command::new(crate::support::program()).args(arguments).current_dir(at).output();
        let output = output.unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    assert_eq!(program(&["init", "c", "--robot", "ur5e"]).0, Some(0));
    let arm = etalon::campaign::read_robot(&at.join("c/robot.toml")).unwrap();
    let arm = arm.build(&["LR".to_owned(), "RR".to_owned()]).unwrap();
    let mut values = arm.nominal();
    for (p, value) in arm.parameters().iter().zip(&mut values) {
        *value += match p.name.as_str() {
            "LR_x" | "RR_y" => 80.0,
            "LR_z" | "RR_z" => 55.0,
            "base_x" => 1500.0,
            "d_4" => 0.3,
            "theta_3" => 0.002,
            _ => 0.0,
        };
    }
    let mut noise = Noise::new(17, 1);
    let row = |noise: &mut Noise| {
        let q: Vec<f64> = (0..6).map(|_| noise.uniform(1.4)).collect();
        let points = [0, 1].map(|k| arm.position(&values, &q, k).map(|x| x + noise.gaussian(0.01)));
        let cells = q.iter().map(|q| q.to_degrees()).chain(points.into_iter().flatten());
        cells.map(|v| format!("{v:.6}").replace('.', ",")).collect::<Vec<_>>().join(";") + "\n"
    };
    let head = "J1;J2;J3;J4;J5;J6;X1;Y1;Z1;X2;Y2;Z2\n";
    for name in ["a.csv", "b.csv"] {
        let text: String = (0..40).map(|_| row(&mut noise)).collect();
        std::fs::write(at.join("c").join(name), head.to_owned() + &text).unwrap();
    }
    let joints: Vec<String> = (1..=6).map(|i| format!("q{i}_deg = \"J{i}\"")).collect();
    let export = |file: &str, n: usize, target: &str, pose: &str| {
        format!(
            "[[export]]\nfile = \"{file}\"\nunit = \"mm\"\ntarget = \"{target}\"\n{pose}\n\
             format = {{ delimiter = \";\", decimal = \",\", header = 1, columns = {{ x = \"X{n}\", y = \"Y{n}\", z = \"Z{n}\" }} }}\n\
             joints = {{ {} }}\n",
            joints.join(", ")
        )
    };
    let run = |exports: &str| {
        let text = format!(
            "{HEAD}{exports}[frame.world]\nas_exported = true\n[identify]\ncalibration = \"index mod 10 < 7\"\nvalidation = \"rest\"\n"
        );
        std::fs::write(at.join("c/campaign.toml"), text).unwrap();
        program(&["run", "c"])
    };
    let found = || -> ParametersDocument { crate::support::document(&at.join("c/out/parameters.json")) };
    let rms = || found().residuals.rms;

    let (code, said) = run(&export("a.csv", 1, "LR", ""));
    assert_eq!(code, Some(0), "{said}");
    assert!(rms() < 0.02, "{}", rms());
    // two points of each row; a second file, whose rows go on
    let both = export("a.csv", 1, "LR", "") + &export("a.csv", 2, "RR", "");
    let (code, said) = run(&both);
    assert_eq!(code, Some(0), "{said}");
    assert!(rms() < 0.02 && found().parameters.iter().any(|p| p.name == "RR_x"), "{}", rms());
    let second = export("b.csv", 1, "LR", "pose = \"row + 100\"");
    let (code, said) = run(&(both.clone() + &second));
    assert_eq!(code, Some(0), "{said}");
    let poses = found().residuals.count;
    assert!(rms() < 0.02 && poses > 200, "{} {poses}", rms());

    // mistakes: the same poses twice, other joints for one file, and a file with the joints of another
    let (code, said) = run(&(both.clone() + &export("b.csv", 1, "LR", "")));
    assert!(code == Some(2) && said.says("error[target-twice] pose=1") && said.contains("row + 100"), "{said}");
    let (code, said) = run(&(export("a.csv", 1, "LR", "") + &export("a.csv", 2, "RR", "").replace("\"J2\"", "\"J3\"")));
    assert!(code == Some(2) && said.contains("[joints-differ]"), "{said}");
    let (code, said) = run(&export("a.csv", 1, "LR", "").replace("target = \"LR\"\n", ""));
    assert!(code == Some(2) && said.contains("[no-target]") && said.contains("`target`"), "{said}");
}
