//! Targets, sockets and anchors that validation poses alone show are placed by their own readings. Synthetic.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends};
use etalon::base::noise::Noise;
use etalon::base::pose::{Vector, minus, norm};
use etalon::robots::{Robot, Role};
use serde_json::Value;

/// Standard uncertainty of a measured coordinate or distance, mm.
const U_MM: f64 = 0.05;
const CALIBRATION: i64 = 60;

/// An arm like that of the sample, whose table a test writes.
pub(super) struct Arm {
    pub robot: Box<dyn Robot>,
    pub values: Vec<f64>,
    noise: Noise,
}

impl Arm {
    /// With errors of some tenths of a millimetre and these targets.
    pub fn new(scratch: &Scratch, targets: &[String]) -> Self {
        let robot = etalon::campaign::read_robot(&scratch.path().join("robot.toml")).unwrap().build(targets).unwrap();
        let mut noise = Noise::new(40, 7);
        let of = |p: &etalon::robots::Parameter| match p.role {
            Role::Target => 60.0 + noise.uniform(50.0),
            Role::Robot if p.name.starts_with("theta") => p.nominal + noise.uniform(1e-3),
            Role::Robot if p.name.starts_with("a_") => p.nominal + noise.uniform(0.3),
            _ => p.nominal,
        };
        let values = robot.parameters().iter().map(of).collect();
        Self { robot, values, noise }
    }

    /// Joint values of a pose, rad.
    pub fn joints(&mut self) -> Vec<f64> {
        [2.5, 1.0, 1.0, 2.4, 1.8, 2.8].map(|range| self.noise.uniform(range)).to_vec()
    }

    pub fn at(&self, joints: &[f64], target: usize) -> Vector {
        self.robot.position(&self.values, joints, target)
    }

    pub fn measured(&mut self, at: Vector) -> Vector {
        at.map(|v| v + self.noise.gaussian(U_MM))
    }
}

pub(super) fn cells(joints: &[f64]) -> String {
    joints.iter().map(|q| format!("{:.12}", q.to_degrees())).collect::<Vec<_>>().join(",")
}

/// A campaign with this table, which calibrates on the first poses.
fn campaign(scratch: &Scratch, table: &str) {
    std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
    scratch.replace("campaign.toml", "[limits]\ndistance_max_mm = 0.4\n", "");
}

fn rms(accuracy: &Value, when: &str) -> f64 {
    accuracy["sets"][1]["errors"][0][when]["rms"].as_f64().unwrap()
}

#[test]
fn targets_of_validation_poses_are_placed_and_count_by_their_redundancy() {
    // 60 targets with two readings each, at validation poses alone
    let own = 60;
    let names: Vec<String> = (0..3).map(|k| format!("S{k}")).chain((0..own).map(|k| format!("V{k}"))).collect();
    let scratch = copy_sample("draw-wire");
    let mut arm = Arm::new(&scratch, &names);
    let mut table = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for pose in 1..=CALIBRATION + 2 * own {
        let joints = arm.joints();
        let apart = (pose > CALIBRATION).then(|| 3 + ((pose - CALIBRATION - 1) % own) as usize);
        let targets = if apart.is_some() { apart.into_iter().collect() } else { vec![0, 1, 2] };
        for target in targets {
            let at = arm.at(&joints, target);
            let [x, y, z] = arm.measured(at);
            table += &format!("{pose},{},{},{x:.6},{y:.6},{z:.6}\n", names[target], cells(&joints));
        }
    }
    campaign(&scratch, &table);
    let said = ends(&scratch, "run", 0, &["[placed-by-validation]: 60 targets ", ": `V0`, `V1`"]);
    assert!(!said.contains("[placed-by-validation-unjudged]") && !said.contains("another campaign"), "{said}");
    let accuracy = scratch.json("accuracy.json");
    // all that is left is noise: two readings place a target, and show half of their errors
    let expected = 3f64.sqrt() * U_MM;
    assert!((rms(&accuracy, "after") / expected - 1.0).abs() < 0.15, "{} {expected}", rms(&accuracy, "after"));
    let placed = accuracy["placed_apart"].as_array().unwrap();
    assert_eq!(placed.len(), own as usize);
    for p in placed {
        let r = p["redundancy"].as_f64().unwrap();
        assert!(p["readings"] == 2 && (r - 0.5).abs() < 1e-6 && p["is_assessed"] == true, "{p}");
    }
    let parameters = scratch.json("parameters.json");
    let entries = parameters["parameters"].as_array().unwrap();
    let entry = |name: &str| entries.iter().find(|p| p["name"] == name).unwrap();
    let (v, s) = (entry("V7_x"), entry("S1_x"));
    assert_eq!((&v["status"], &s["status"]), (&"placed_by_validation".into(), &"identified".into()));
    // u/√2 of two readings, beside the noise that the residuals show
    let u = v["standard_uncertainty"].as_f64().unwrap();
    assert!((u / (U_MM / 2f64.sqrt()) - 1.0).abs() < 0.2, "{u}");
    let truth = arm.values[arm.robot.index("V7_x").unwrap()];
    assert!((v["value"].as_f64().unwrap() - truth).abs() < 5.0 * u, "{v} {truth}");
    let page = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(page.has_phrase("targets-placed-by-validation") && page.has_phrase("placed-by-validation-poses"));
    // judged again with what was identified
    let judged = ["validate", "campaign", "--parameters", "campaign/out/parameters.json", "--json"];
    let output = std::process::Command::new(crate::support::program())
        .current_dir(scratch.root())
        .args(judged)
        .output()
        .unwrap();
    let again: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!((rms(&again, "after") / rms(&accuracy, "after") - 1.0).abs() < 0.05);
}

#[test]
fn anchors_and_sockets_of_validation_poses_are_placed() {
    let scratch = copy_sample("draw-wire");
    let mut arm = Arm::new(&scratch, &["ball".to_owned()]);
    let head =
        "kind,pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,other,socket,distance_mm,u_mm\n";
    let mut table = head.to_owned();
    for pose in 1..=CALIBRATION {
        let joints = arm.joints();
        let at = arm.at(&joints, 0);
        let [x, y, z] = arm.measured(at);
        table += &format!("point,{pose},ball,{},{x:.6},{y:.6},{z:.6},,,,{U_MM}\n", cells(&joints));
    }
    // an anchor 12 times, another twice, and a socket three times: its place is where the ball is at some joint values
    let places: [Vector; 2] = [[900.0, 400.0, 60.0], [-700.0, 500.0, 80.0]];
    for pose in CALIBRATION + 1..=CALIBRATION + 14 {
        let joints = arm.joints();
        let k = usize::from(pose > CALIBRATION + 12);
        let d = norm(minus(arm.at(&joints, 0), places[k])) + arm.noise.gaussian(U_MM);
        table += &format!("distance,{pose},ball,{},,,,anchor_{k},,{d:.6},{U_MM}\n", cells(&joints));
    }
    let joints = arm.joints();
    for pose in CALIBRATION + 15..=CALIBRATION + 17 {
        // the ball's centre scatters in the socket
        table += &format!("contact,{pose},ball,{},,,,,cup,,{U_MM}\n", cells(&joints));
    }
    campaign(&scratch, &table);
    let what = ["[placed-by-validation-unjudged]: 3 fixtures ", ": `anchor_0`, `anchor_1`, `cup`"];
    let said = ends(&scratch, "run", 0, &what);
    assert!(!said.contains("another campaign"), "{said}");
    let accuracy = scratch.json("accuracy.json");
    assert!(said.contains("not judged: `anchor_1`"), "{said}\n{}", accuracy["placed_apart"]);
    // without places the errors are hundreds of millimetres
    assert!(rms(&accuracy, "after") < 3.0 * U_MM, "{}", rms(&accuracy, "after"));
    assert_eq!(accuracy["sets"][1]["count"], 15, "two distances do not place an anchor, and are not counted");
    let parameters = scratch.json("parameters.json");
    let entries = parameters["parameters"].as_array().unwrap();
    for (axis, truth) in ["x", "y", "z"].iter().zip(places[0]) {
        let p = entries.iter().find(|p| p["name"] == format!("anchor_0_{axis}")).unwrap();
        let (value, u) = (p["value"].as_f64().unwrap(), p["standard_uncertainty"].as_f64().unwrap());
        assert!(p["status"] == "placed_by_validation" && (value - truth).abs() < 5.0 * u + 0.3, "{p} {truth}");
    }
}
