//! `etalon axis-table`: the control adds what the table holds, and the robot as it was identified is where it was programmed.

use super::{etalon, text};
use crate::campaigns::controllers::{disturbed, parameters};
use crate::support::root;
use crate::support::said::Says;
use crate::support::scratch::Scratch;
use etalon::base::pose::{minus, norm};
use etalon::campaign::read_robot;
use etalon::robots::Robot;

/// Two slides one above the other, a cross table.
const CROSS: &str = "name = \"cross\"\nmodel = \"serial\"\nconvention = \"poe\"\nflange_xyz_mm = [0.0, 0.0, 80.0]\nflange_rpy_deg = [0.0, 0.0, 0.0]\n[[joint]]\nprismatic = true\n\
                     direction = [1.0, 0.0, 0.0]\n[[joint]]\nprismatic = true\ndirection = [0.0, 1.0, 0.0]\n";

/// A robot as it was identified: parameters by name, in mm, rad and 1.
struct Identified {
    scratch: Scratch,
    robot: Box<dyn Robot>,
    values: Vec<f64>,
}

impl Identified {
    fn new(toml: &str, change: impl Fn(&str, f64) -> f64) -> Self {
        let scratch = Scratch::with(&[("robot.toml", toml)]);
        let robot = read_robot(&scratch.path().join("robot.toml")).unwrap().build(&["tool".to_owned()]).unwrap();
        let values: Vec<f64> = robot.parameters().iter().map(|p| change(&p.name, p.nominal)).collect();
        parameters(&scratch, robot.as_ref(), &values);
        Self { scratch, robot, values }
    }

    fn table(&self, more: &[&str]) -> (String, Option<i32>, String) {
        let all = [&["axis-table", "found.json", "--robot", "robot.toml"], more].concat();
        let output = etalon(&self.scratch.path(), &all);
        (text(&output.stdout), output.status.code(), text(&output.stderr))
    }

    fn written(&self, more: &[&str]) -> String {
        let (table, code, said) = self.table(more);
        assert_eq!(code, Some(0), "{more:?}: {said}");
        table
    }
}

fn sample(robot: &str) -> String {
    std::fs::read_to_string(root().join(robot)).unwrap()
}

/// The values of lines `NAME VALUE` or `NAME=VALUE` of a table, by the whole name.
fn value(table: &str, name: &str) -> f64 {
    let line = table.lines().find_map(|l| l.strip_prefix(name)?.strip_prefix([' ', '=']));
    line.unwrap_or_else(|| panic!("{name}: {table}")).trim().parse().unwrap()
}

/// The corrections of a plane in mm at its nodes: `[j][i]`, with the position of each along the first and the second master axis.
fn plane(table: &str) -> Vec<([f64; 2], f64)> {
    let of = |name: &str| value(table, &format!("kw.crosscomp2.{name}"));
    assert!(of("unit") == 1.0 && table.ends_with("\nEnd\n"), "{table}");
    let (columns, rows) = (of("last_index_master1") as usize + 1, of("last_index_master2") as usize + 1);
    let at = |start: &str, i: usize| 1e-4 * (of(start) + i as f64 * of("interval"));
    let node = |k: usize| {
        let (i, j) = (k % columns, k / columns);
        let place = [at("start_position_master1", i), at("start_position_master2", j)];
        (place, 1e-4 * of(&format!("table[{j}][{i}].correction")))
    };
    (0..columns * rows).map(node).collect()
}

#[test]
fn a_plane_with_its_table_is_where_it_is_programmed() {
    let cross = Identified::new(CROSS, |name, nominal| match name {
        "gain_1" => 1.0004,
        "gain_2" => 0.9997,
        // squareness and yaw
        _ if name.starts_with("q1_r") || name.starts_with("q2_r") => nominal + 4e-4,
        _ => nominal,
    });
    let axes =
        ["--axis", "q1_mm=0:300:50", "--axis", "q2_mm=-100:100:50", "--to", "beckhoff-plane", "--numbers", "4,7"];
    for (sign, adds) in [("add", 1.0), ("subtract", -1.0)] {
        let written = |corrected| cross.written(&[&axes[..], &["--sign", sign, "--corrected", corrected]].concat());
        let (first, second) = (written("q1_mm"), written("q2_mm"));
        assert!(first.contains("as stated; the maker does not publish the sign"), "{first}");
        for (table, number) in [(&first, 4.0), (&second, 7.0)] {
            assert_eq!(value(table, "kopf.achs_nr"), number);
            assert_eq!([1, 2].map(|m| value(table, &format!("kw.crosscomp2.master{m}_ax_nr"))), [4.0, 7.0]);
        }
        assert_eq!((plane(&first).len(), plane(&first)[1].0, plane(&first)[7].0), (35, [50.0, -100.0], [0.0, -50.0]));
        let mut uncompensated = 0.0f64;
        for ((programmed, x), (_, y)) in plane(&first).into_iter().zip(plane(&second)) {
            let at = |values: &[f64], q: [f64; 2]| cross.robot.position(values, &q, 0);
            let wanted = at(&cross.robot.nominal(), programmed);
            let off = |q| {
                let [x, y, _] = minus(at(&cross.values, q), wanted);
                x.hypot(y)
            };
            let moved = [programmed[0] + adds * x, programmed[1] + adds * y];
            uncompensated = uncompensated.max(off(programmed));
            // two values that are rounded to 0.1 um
            assert!(off(moved) < 0.8e-4, "{programmed:?}: {}", off(moved));
        }
        assert!(uncompensated > 0.1, "{uncompensated}");
    }
}

/// A controller that computes the joints of a PreXYT from x and y with nominal geometry, and adds the table to x and y.
#[test]
fn a_plane_of_positions_is_that_of_the_nominal_inverse() {
    let toml = sample("samples/prexyt-cmm/robot.toml");
    let table = Identified::new(&toml, |_, nominal| nominal);
    let values = disturbed(table.robot.as_ref(), &[]);
    let named = |name: &str, _: f64| values[table.robot.index(name).unwrap()];
    let real = Identified::new(&toml, named);
    let axes = ["--axis", "x=150:250:25", "--axis", "y=100:200:25", "--to", "csv"];
    let rows = |corrected: &str| -> Vec<Vec<f64>> {
        let csv = real.written(&[&axes[..], &["--corrected", corrected]].concat());
        assert!(csv.starts_with("x_mm,y_mm,deviation\n"), "{csv}");
        csv.lines().skip(1).map(|l| l.split(',').map(|v| v.parse().unwrap()).collect()).collect()
    };
    let (dx, dy) = (rows("x"), rows("y"));
    let commands = dx.iter().zip(&dy).map(|(x, y)| format!("1,{:?},{:?},1,0,0,0\n", x[0] - x[2], x[1] - y[2]));
    let commands = commands.collect::<String>();
    std::fs::write(real.scratch.path().join("poses.csv"), format!("pose,x_mm,y_mm,qw,qx,qy,qz\n{commands}")).unwrap();
    let kinematics = |arguments: &[&str]| {
        let output = etalon(&real.scratch.path(), &[&["kinematics"], arguments, &["--robot", "robot.toml"]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    std::fs::write(real.scratch.path().join("joints.csv"), kinematics(&["inverse", "poses.csv", "--nearest"])).unwrap();
    let attained = kinematics(&["direct", "joints.csv", "--parameters", "found.json"]);
    for (line, row) in attained.lines().skip(1).zip(&dx) {
        let at: Vec<f64> = line.split(',').skip(1).take(2).map(|v| v.parse().unwrap()).collect();
        let off = norm([at[0] - row[0], at[1] - row[1], 0.0]);
        assert!(off < 1e-9 && row[2].abs() > 1e-3, "{off}: {line}");
    }
}

/// By hand: an actuator of the lead g travels g times what is commanded, a joint of the gain g and the zero z that and z.
#[test]
fn a_joint_with_its_table_moves_by_what_is_programmed() {
    let prexyt = sample("samples/prexyt-cmm/robot.toml");
    let leads = Identified::new(&prexyt, |name, nominal| if name == "delta2" { 1.0005 } else { nominal });
    let rows = |table: &str| -> Vec<Vec<f64>> {
        table.lines().map(|l| l.split(' ').map(|v| v.parse().unwrap()).collect()).collect()
    };
    for (i, row) in rows(&leads.written(&["--axis", "rho2_mm=0:300:100", "--to", "linuxcnc"])).iter().enumerate() {
        let programmed = 100.0 * i as f64;
        // the motor goes to nominal + (nominal - actual)
        let motor = row[0] + row[0] - row[1];
        assert!(row[0] == programmed && row[1] == row[2] && (1.0005 * motor - programmed).abs() < 1e-9, "{row:?}");
    }
    // deg, with the zero of the joint, and without it
    let arm = sample("docs/keys/robot-serial.toml");
    let change = |name: &str, nominal: f64| match name {
        "gain_2" => 1.002,
        "theta_2" => nominal + 1e-3,
        _ => nominal,
    };
    let arm = Identified::new(&arm, change);
    for (more, zero) in [(&[][..], 1e-3f64.to_degrees()), (&["--zero-at", "0"], 0.0)] {
        let range = ["--axis", "q2_deg=-90:90:45", "--to", "linuxcnc"];
        for row in rows(&arm.written(&[&range[..], more].concat())) {
            let motor = row[0] + row[0] - row[1];
            assert!((1.002 * motor + zero - row[0]).abs() < 1e-5, "{more:?} {row:?}");
        }
    }
    // what a control does with one table, it does with the others: 0.0001 deg, and the opposite sign
    let range = ["--axis", "q2_deg=-90:90:45", "--numbers", "2"];
    let linuxcnc = rows(&arm.written(&[&range[..], &["--to", "linuxcnc"]].concat()));
    let beckhoff = arm.written(&[&range[..], &["--to", "beckhoff"]].concat());
    let sinumerik = arm.written(&[&range[..], &["--to", "sinumerik"]].concat());
    let cec = arm.written(&[&range[..], &["--to", "sinumerik-cec", "--sign", "add", "--table", "3"]].concat());
    assert!(cec.contains("$AN_CEC_INPUT_AXIS[3]=(AX2)\n$AN_CEC_OUTPUT_AXIS[3]=(AX2)\n"), "{cec}");
    assert_eq!(["STEP", "MIN", "MAX"].map(|n| value(&cec, &format!("$AN_CEC_{n}[3]"))), [45.0, -90.0, 90.0]);
    for (i, row) in linuxcnc.iter().enumerate() {
        let deviation = row[1] - row[0];
        assert!((1e-4 * value(&beckhoff, &format!("kw.ssfk.table[{i}].pos")) - deviation).abs() < 0.51e-4);
        assert!((value(&sinumerik, &format!("$AA_ENC_COMP[0,{i},AX2]")) - deviation).abs() < 1e-6);
        assert!((value(&cec, &format!("$AN_CEC[3,{i}]")) + deviation).abs() < 1e-6);
    }
}

/// Backlash in both columns of LinuxCNC and Beckhoff: the axis that obeys its table is where it is programmed from either side, as
/// the model of the robot with directions of approach says.
#[test]
fn backlash_is_in_the_columns_of_both_directions() {
    let of =
        |toml: &str, effects: &str| toml.replacen("model = \"serial\"", &format!("model = \"serial\"\n{effects}"), 1);
    let rows = |table: &str| -> Vec<Vec<f64>> {
        table.lines().map(|l| l.split(' ').map(|v| v.parse().unwrap()).collect()).collect()
    };
    let lost = |name: &str, nominal: f64| match name {
        "backlash_2" | "backlash_q2" => 0.04,
        "q2_rz" => nominal + 1e-3,
        _ => nominal,
    };
    let cross = Identified::new(&of(CROSS, "backlash = [2]"), lost);
    let names: Vec<&str> = cross.robot.parameters().iter().map(|p| p.name.as_str()).collect();
    assert!(names.iter().any(|n| n.starts_with("backlash")), "{names:?}");
    let range = ["--axis", "q2_mm=0:200:100"];
    let table = cross.written(&[&range[..], &["--to", "linuxcnc"]].concat());
    let beckhoff = cross.written(&[&range[..], &["--to", "beckhoff"]].concat());
    for (i, row) in rows(&table).iter().enumerate() {
        assert!((row[1] - row[0] + 0.02).abs() < 1e-9 && (row[2] - row[0] - 0.02).abs() < 1e-9, "{table}");
        for (direction, column) in [(1.0, 1), (-1.0, 2)] {
            // the motor goes to nominal + (nominal - actual)
            let motor = row[0] + row[0] - row[column];
            let reached = cross.robot.position(&cross.values, &[0.0, motor, direction], 0);
            let wanted = cross.robot.position(&cross.values, &[0.0, row[0], 0.0], 0);
            assert!(norm(minus(reached, wanted)) < 1e-9, "{row:?}");
        }
        let of_beckhoff = |name: &str| 1e-4 * value(&beckhoff, &format!("kw.ssfk.table[{i}].{name}"));
        assert!((of_beckhoff("pos") + 0.02).abs() < 1e-9 && (of_beckhoff("neg") - 0.02).abs() < 1e-9, "{beckhoff}");
    }
    // an axis without backlash, of the same table
    let table = cross.written(&["--axis", "q1_mm=0:200:100", "--to", "linuxcnc"]);
    assert!(rows(&table).iter().all(|row| row[1] == row[2]), "{table}");
    // one value for both directions: the middle, and what it lacks
    let (table, code, said) = cross.table(&[&range[..], &["--to", "sinumerik"]].concat());
    assert!(code == Some(0) && said.says("warning[backlash-not-in-table] axis=q2_mm"), "{said}");
    assert!(value(&table, "$AA_ENC_COMP[0,1,AX1]").abs() < 1e-6, "{table}");
    // the table of errors makes the same table again
    std::fs::write(cross.scratch.path().join("errors.csv"), cross.written(&range)).unwrap();
    let again = etalon(&cross.scratch.path(), &["axis-table", "errors.csv", "--axis", "q2_mm", "--to", "linuxcnc"]);
    assert_eq!(text(&again.stdout), cross.written(&[&range[..], &["--to", "linuxcnc"]].concat()));
    // one column alone is no table of both directions
    std::fs::write(cross.scratch.path().join("half.csv"), "q2_mm,forward\n0,0.1\n50,0.1\n").unwrap();
    let half = etalon(&cross.scratch.path(), &["axis-table", "half.csv", "--axis", "q2_mm", "--to", "linuxcnc"]);
    assert!(half.status.code() == Some(2) && text(&half.stderr).contains("backward"), "{}", text(&half.stderr));
}

/// Squareness: the second slide leads the table along the first.
#[test]
fn one_axis_corrects_another() {
    let square = |name: &str, nominal: f64| if name == "q2_rz" { nominal + 1e-3 } else { nominal };
    let cross = Identified::new(CROSS, square);
    let along = ["--axis", "q2_mm=0:200:100", "--corrected", "q1_mm"];
    let cec = cross.written(&[&along[..], &["--to", "sinumerik-cec", "--sign", "subtract"]].concat());
    assert!(cec.contains("$AN_CEC_INPUT_AXIS[0]=(AX1)\n$AN_CEC_OUTPUT_AXIS[0]=(AX2)\n"), "{cec}");
    for i in 0..3 {
        let q2 = 100.0 * f64::from(i);
        let drift = cross.robot.position(&cross.values, &[0.0, q2], 0)[0];
        assert!(
            (value(&cec, &format!("$AN_CEC[0,{i}]")) - drift).abs() < 1e-6 && (i == 0 || drift.abs() > 0.09),
            "{cec}"
        );
    }
}

#[test]
fn leads_and_measured_errors_become_tables() {
    let geometric = serde_json::json!({
        "schema": "etalon/geometric/1", "definition": "", "quantities": [], "covariance": [], "steps": [],
        "leads": [{
            "actuator": 3, "nominal_lead_mm": 5.08, "actual_lead_mm": 5.081, "error": 2e-4, "standard_uncertainty": 1e-6,
            "linearity": [
                { "commanded_mm": 0.0, "deviation_mm": 0.001 }, { "commanded_mm": 100.0, "deviation_mm": -0.003 },
                { "commanded_mm": 300.0, "deviation_mm": 0.002 }
            ]
        }],
        "scale_bars": [], "balls": [], "tables": [], "methods": [], "workspace": [], "messages": []
    });
    let errors = "x_mm,y_mm,deviation\n0,0,0.001\n50,0,0.0023\n0,50,-0.004\n50,50,0.0105\n";
    let scratch = Scratch::with(&[
        ("geometric.json", &geometric.to_string()),
        ("errors.csv", errors),
        ("um.csv", "x_mm,deviation\n0,1.5\n50,5\n"),
    ]);
    let run = |arguments: &[&str]| {
        let output = etalon(&scratch.path(), &[&["axis-table"], arguments].concat());
        (text(&output.stdout), output.status.code(), text(&output.stderr))
    };
    let (table, code, said) = run(&["geometric.json", "--axis", "rho3_mm=0:200:50", "--to", "sinumerik"]);
    assert_eq!(code, Some(0), "{said}");
    // lead, and half way between what was measured
    for (i, deviation) in [0.001, 0.01 - 0.001, 0.02 - 0.003, 0.03 - 0.00175, 0.04 - 0.0005].into_iter().enumerate() {
        assert!((value(&table, &format!("$AA_ENC_COMP[0,{i},AX1]")) - deviation).abs() < 1e-6, "{table}");
    }
    for (arguments, why) in [
        (&["geometric.json", "--axis", "rho1_mm=0:100:50"][..], "error[lead-not-measured] axis=rho1_mm"),
        (
            &["geometric.json", "--axis", "rho3_mm=0:400:50"],
            "rho3_mm = 350: the lead was not measured at this position",
        ),
        (&["geometric.json", "--axis", "rho3_mm"], "error[axis-without-positions]"),
        (&["errors.csv", "--axis", "x"], "error[not-a-grid]"),
        (&["um.csv", "--axis", "x"], "changes by 3.5 from 0 to 50"),
        (&["errors.csv", "--axis", "x", "--axis", "z"], "z_mm"),
    ] {
        let (out, code, said) = run(arguments);
        assert!(code == Some(2) && out.is_empty() && said.says(why), "{arguments:?}: {said}");
    }
    let (table, code, said) = run(&[
        "errors.csv",
        "--axis",
        "x",
        "--axis",
        "y",
        "--corrected",
        "y",
        "--to",
        "beckhoff-plane",
        "--sign",
        "add",
    ]);
    assert_eq!(code, Some(0), "{said}");
    let measured = [([0.0, 0.0], 0.001), ([50.0, 0.0], 0.0023), ([0.0, 50.0], -0.004), ([50.0, 50.0], 0.0105)];
    for ((at, error), (place, correction)) in measured.into_iter().zip(plane(&table)) {
        assert!(at == place && (error + correction).abs() < 1e-9, "{table}");
    }
}

#[test]
fn tables_that_would_mislead_a_control_are_refused() {
    let cross = Identified::new(CROSS, |_, nominal| nominal);
    for (arguments, why) in [
        (
            &["--axis", "q1_mm=0:100:50", "--axis", "q2_mm=0:100:50", "--to", "beckhoff-plane"][..],
            "[table-options-refused] fault=sign-missing",
        ),
        (&["--axis", "q1_mm=0:100:50", "--to", "sinumerik-cec"], "[table-options-refused] fault=sign-missing"),
        (
            &["--axis", "q1_mm=0:100:50", "--to", "sinumerik", "--sign", "add"],
            "[table-options-refused] fault=sign-known",
        ),
        (
            &["--axis", "q1_mm=0:100:50", "--axis", "q2_mm=0:100:25", "--to", "beckhoff-plane", "--sign", "add"],
            "error[plane-steps-differ]",
        ),
        (&["--axis", "q1_mm=0:100:30"], "not a whole number of steps"),
        (&["--axis", "q1_mm=0:100:50", "--axis", "q1_mm=0:100:50"], "[table-options-refused] fault=axes"),
        (
            &["--axis", "q1_mm=0:100:50", "--corrected", "q2_mm", "--to", "linuxcnc"],
            "[table-options-refused] fault=own-axis",
        ),
        (&["--axis", "q1_mm=0:100:50", "--corrected", "x"], "error[axes-mixed]"),
        (&["--axis", "q1_deg=0:100:50"], "joints q1_mm, q2_mm"),
        (&["--axis", "q1_mm=0:100:50", "--at", "q3_mm=1"], "error[axis-unknown] axis=q3_mm"),
        (&["--axis", "q1_mm=0:300:1", "--to", "linuxcnc"], "error[axis-table-too-long]"),
    ] {
        let (out, code, said) = cross.table(arguments);
        assert!(code == Some(2) && out.is_empty() && said.says(why), "{arguments:?}: {said}");
    }
    let found = std::fs::read_to_string(cross.scratch.path().join("found.json")).unwrap();
    // the robot was drawn again since
    let stale = found.replace("\"name\":\"gain_2\",\"nominal\":1.0", "\"name\":\"gain_2\",\"nominal\":0.5");
    assert_ne!(stale, found);
    std::fs::write(cross.scratch.path().join("found.json"), &stale).unwrap();
    let (out, code, said) = cross.table(&["--axis", "q1_mm=0:100:50"]);
    assert!(
        code == Some(2) && out.is_empty() && said.says("error[nominal-value-changed] parameter=gain_2 stated=1"),
        "{said}"
    );
    std::fs::write(cross.scratch.path().join("found.json"), &found).unwrap();
    cross.scratch.replace("found.json", "step_vanished", "lost_patience");
    let (out, code, said) = cross.table(&["--axis", "q1_mm=0:100:50"]);
    assert!(code == Some(2) && out.is_empty() && said.contains("error[parameters-not-converged]"), "{said}");
}
