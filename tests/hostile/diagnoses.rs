//! Diagnoses are true: a slip is named that explains the data, and no other; what no slip explains names no culprit. The data are synthetic.

use super::etalon;
use crate::support::arms::{SIX_AXES, serial};
use crate::support::said::{Says, has};
use crate::support::scratch::Scratch;
use etalon::base::catalogue::Phrase;
use etalon::base::noise::Noise;
use etalon::base::phrase;
use etalon::base::pose::{Pose, Vector};
use etalon::robots::{Kinematics, Quantity, Robot, Role};
use std::fmt::Write;

/// Words of a message that names a cause.
const NAMES_A_CAUSE: &str = "check that first";
/// Standard uncertainty of a coordinate, mm.
const U_MM: f64 = 0.02;
/// Standard uncertainty of an orientation, rad.
const U_RAD: f64 = 1e-4;
const CALIBRATION: usize = 25;
const POSES: usize = 35;

/// A pose as a table states it.
#[derive(Clone)]
struct Row {
    pose: usize,
    target: usize,
    /// Joint values, rad.
    q: Vec<f64>,
    at: Vector,
    body: Pose,
}

/// Measurements of a six-axis arm at some poses, `targets` of them each, with joints about `middle` by up to `reach` (rad).
fn measured(targets: usize, middle: [f64; 6], reach: [f64; 6]) -> Vec<Row> {
    let names = ["A", "B", "C"];
    let robot = serial(&SIX_AXES, &names[..targets], &[]);
    let mut noise = Noise::new(43, targets as u64);
    let mut value = |(i, p): (usize, &etalon::robots::Parameter)| match (p.role, p.quantity) {
        (Role::Base, Quantity::Angle) => 0.3 + noise.uniform(0.5),
        (Role::Base, _) => 900.0 + noise.uniform(500.0),
        (Role::Target, _) => 40.0 + noise.uniform(30.0) + 10.0 * (i % 3) as f64,
        (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
        (_, Quantity::Angle) => p.nominal + noise.uniform(2e-3),
        (_, Quantity::Ratio) => p.nominal,
    };
    let truth: Vec<f64> = robot.parameters().iter().enumerate().map(&mut value).collect();
    let base = robot.base_in_world(&truth).unwrap();
    let mut all = Vec::new();
    for pose in 1..=POSES {
        let q: Vec<f64> = (0..6).map(|i| middle[i] + noise.uniform(reach[i])).collect();
        let mount = Pose::from_rotation_vector([0.4, -0.2, 0.7]);
        let off = Pose::from_rotation_vector([0; 3].map(|_| noise.gaussian(U_RAD)));
        let body = off.then(&base.then(&robot.tool_pose(&truth, &q).unwrap()).then(&mount));
        for target in 0..targets {
            let at = robot.position(&truth, &q, target).map(|v| v + noise.gaussian(U_MM));
            all.push(Row { pose, target, q: q.clone(), at, body });
        }
    }
    all
}

/// Joints that all move.
fn wide(targets: usize) -> Vec<Row> {
    measured(targets, [0.0; 6], [1.5; 6])
}

/// A campaign of these rows; `body` writes the columns of an orientation.
fn campaign(rows: &[Row], columns: &str, more: &str, body: impl Fn(&Pose) -> Vec<f64>) -> Scratch {
    let mut table = format!("pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm{columns}\n");
    for row in rows {
        let numbers: Vec<String> =
            row.q.iter().map(|q| q.to_degrees()).chain(row.at).chain(body(&row.body)).map(|v| v.to_string()).collect();
        let _ = writeln!(table, "{},{},{}", row.pose, ["A", "B", "C"][row.target], numbers.join(","));
    }
    let mut robot = "model = \"serial\"\n".to_owned();
    for [alpha, a, theta, d] in SIX_AXES {
        let _ = writeln!(robot, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}");
    }
    let rotation = if columns.is_empty() { "" } else { "expanded_rotation_uncertainty_deg = 0.0115\n" };
    let campaign = format!(
        "name = \"arm\"\nrobot = \"robot.toml\"\ncontrollers = [\"json\"]\nsynthetic = \"drawn for a test\"\n\
         [instrument]\nname = \"tracker\"\nexpanded_uncertainty_um = 40\ncoverage_factor = 2\n{rotation}\
         [observations]\nfile = \"observations.csv\"\n{more}\
         [identify]\ncalibration = \"1-{CALIBRATION}\"\nvalidation = \"rest\"\n"
    );
    Scratch::with(&[("campaign.toml", &campaign), ("robot.toml", &robot), ("observations.csv", &table)])
}

fn positions(rows: &[Row]) -> Scratch {
    campaign(rows, "", "", |_| Vec::new())
}

/// What is said of a campaign by a check and a run; neither names a cause.
fn no_cause(scratch: &Scratch) -> [(Option<i32>, String); 2] {
    ["check", "run"].map(|command| {
        let (code, said) = etalon(scratch, command);
        assert!(!said.contains(NAMES_A_CAUSE) && !said.has_phrase("undescribed-other-poses"), "{command}: {said}");
        (code, said)
    })
}

/// The campaign is refused by this cause.
fn named(scratch: &Scratch, cause: &Phrase) {
    named_by(scratch, cause, &["check"]);
}

fn named_by(scratch: &Scratch, cause: &Phrase, commands: &[&str]) {
    for command in commands {
        let (code, said) = etalon(scratch, command);
        assert!(code != Some(0) && has(&said, cause) && said.contains(NAMES_A_CAUSE), "{command}, {cause}: {said}");
    }
}

#[test]
fn sound_data_have_no_diagnosis() {
    for targets in [1, 3] {
        let [check, run] = no_cause(&positions(&wide(targets)));
        assert!(check.0 == Some(0) && run.0 == Some(0), "{} {}", check.1, run.1);
    }
}

/// Joints 3 to 6 hardly move, and two joints move by little: `check` says which parameters that leaves to their tolerances.
#[test]
fn joints_that_do_not_move_are_stated_and_no_slip_is() {
    let still = measured(1, [0.2, 0.3, -0.4, 0.5, 0.6, 0.7], [0.2, 0.2, 0.0, 0.0, 0.0, 0.0]);
    let scratch = positions(&still);
    let [check, run] = no_cause(&scratch);
    assert!(check.0 == Some(0) && run.0 == Some(0), "{} {}", check.1, run.1);
    let one = measured(3, [0.2, 0.3, -0.4, 0.5, 0.6, 0.7], [1.5, 1.5, 1.5, 1.5, 0.0, 1.5]);
    let [check, run] = no_cause(&positions(&one));
    assert!(check.0 == Some(0) && run.0 == Some(0), "{} {}", check.1, run.1);
    assert!(check.1.contains("[joint-does-not-move]: `q5` "), "{}", check.1);
}

/// Points that no robot explains, at joints that hardly move: everything would shrink with the unit of the points.
#[test]
fn what_no_slip_explains_has_no_culprit() {
    let mut rows = measured(3, [0.2, 0.3, -0.4, 0.5, 0.6, 0.7], [0.003; 6]);
    let mut noise = Noise::new(43, 9);
    rows.iter_mut().for_each(|row| row.at = row.at.map(|v| v + noise.gaussian(30.0)));
    let [_, run] = no_cause(&positions(&rows));
    assert!(run.0 != Some(0), "{}", run.1);
    let mut rows = wide(3);
    rows.iter_mut().for_each(|row| row.at = row.at.map(|v| v + noise.gaussian(60.0)));
    let [_, run] = no_cause(&positions(&rows));
    assert!(run.0 != Some(0), "{}", run.1);
}

/// A marker that bears the coordinates of another in three validation poses is no log of another campaign.
#[test]
fn a_duplicated_marker_is_named_by_its_poses() {
    let mut rows = wide(3);
    for pose in [27, 30, 34] {
        let other = rows.iter().find(|row| row.pose == pose && row.target == 1).unwrap().at;
        rows.iter_mut().find(|row| row.pose == pose && row.target == 0).unwrap().at =
            [other[0] + 120.0, other[1] - 80.0, other[2]];
    }
    let [_, (code, said)] = no_cause(&positions(&rows));
    assert!(code == Some(1) && said.contains("(A, pose 27, cycle 1)") && said.contains("pose 34"), "{said}");
}

#[test]
fn slips_in_joints_are_named() {
    let changed = |how: &dyn Fn(&mut Vec<f64>)| {
        let mut rows = wide(3);
        rows.iter_mut().for_each(|row| how(&mut row.q));
        positions(&rows)
    };
    named_by(&changed(&|q| q[5] = -q[5]), &phrase!("slip-reversed", joint = "`q6`"), &["check", "run"]);
    named(&changed(&|q| q.swap(3, 5)), &phrase!("slip-exchanged", first = "`q4`", second = "`q6`"));
    named(&changed(&|q| q[2] += std::f64::consts::FRAC_PI_2), &phrase!("slip-offset", degrees = "-90", joint = "`q3`"));
    // each pose has the joints of the one before
    let mut rows = wide(3);
    for k in (3..rows.len()).rev() {
        rows[k].q = rows[k - 3].q.clone();
    }
    named(&positions(&rows), &phrase!("slip-neighbour", neighbour = "next"));
}

const QUATERNION: &str = ",qw,qx,qy,qz";

#[test]
fn orientations_as_stated_have_no_diagnosis() {
    let rows = wide(1);
    for (columns, more, of) in forms() {
        let scratch = campaign(&rows, columns, more, of);
        for command in ["check", "run"] {
            let (code, said) = etalon(&scratch, command);
            assert!(code == Some(0) && !said.contains(NAMES_A_CAUSE), "{columns}, {command}: {said}");
        }
    }
}

type Form = (&'static str, &'static str, fn(&Pose) -> Vec<f64>);

/// Angles (deg) about z, y and x of the body.
fn zyx(body: &Pose) -> Vec<f64> {
    let r = &body.rotation;
    let angles = [r[1][0].atan2(r[0][0]), (-r[2][0]).atan2(r[0][0].hypot(r[1][0])), r[2][1].atan2(r[2][2])];
    angles.map(f64::to_degrees).to_vec()
}

/// Forms of an orientation: columns, the keys that state them, and the numbers.
fn forms() -> [Form; 3] {
    [
        (QUATERNION, "", |body| body.quaternion().to_vec()),
        (",rx_deg,ry_deg,rz_deg", "", |body| body.rotation_vector_rad().map(f64::to_degrees).to_vec()),
        (",a_deg,b_deg,c_deg", "orientation = \"zyx\"\n", zyx),
    ]
}

#[test]
fn slips_in_orientations_are_named() {
    let rows = wide(1);
    let [quaternion, vector, angles] = forms();
    let with = |(columns, more, of): Form, change: fn(Vec<f64>) -> Vec<f64>| {
        campaign(&rows, columns, more, move |body| change(of(body)))
    };
    named_by(
        &with(quaternion, |q| vec![q[1], q[2], q[3], q[0]]),
        &phrase!("orientation-slip", slip = "scalar-last", name = ""),
        &["check", "run"],
    );
    named(
        &with(quaternion, |q| vec![q[0], -q[1], -q[2], -q[3]]),
        &phrase!("orientation-slip", slip = "inverse", name = ""),
    );
    named(
        &with(quaternion, |q| vec![q[0], -q[1], -q[2], q[3]]),
        &phrase!("orientation-slip", slip = "left-handed", name = "z"),
    );
    named(
        &with(vector, |v| v.iter().map(|v| v.to_radians()).collect()),
        &phrase!("orientation-slip", slip = "radians", name = ""),
    );
    named(&with(vector, |v| v.iter().map(|v| -v).collect()), &phrase!("orientation-slip", slip = "inverse", name = ""));
    named(&with(angles, |v| v.iter().map(|v| -v).collect()), &phrase!("orientation-slip", slip = "negated", name = ""));
    named(
        &with((angles.0, "orientation = \"xyz\"\n", angles.2), |v| v),
        &phrase!("orientation-slip", slip = "order", name = "zyx"),
    );
    let mut reversed = rows.clone();
    reversed.iter_mut().for_each(|row| row.q[5] = -row.q[5]);
    named(&campaign(&reversed, quaternion.0, quaternion.1, quaternion.2), &phrase!("slip-reversed", joint = "`q6`"));
}
