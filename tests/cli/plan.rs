//! `etalon plan` for every robot: which poses, how good, and what they cannot tell.

use super::{etalon, text, text_of};
use crate::support::five_bar::{SEVEN, holes, robot};
use crate::support::root;
use crate::support::said::Says;
use etalon::documents::PlanDocument;
use etalon::robots::Robot;
use std::fmt::Write;
use std::path::Path;

const FIVE_BAR: &str = "model = \"five_bar\"\n[nominal]\nl11 = 230.0\nl12 = 230.0\nl21 = 230.0\nl22 = 230.0\nd = 275.0\nl23 = 230.0\n[reach]\nclearance_mm = 0.0\ntype1_margin_deg = 5.0\ntype2_margin_deg = 25.0\n";

fn plan(folder: &Path, arguments: &[&str]) -> PlanDocument {
    let fixed = ["plan", "--robot", "robot.toml", "--candidates", "c.csv", "--json"];
    let answered = etalon(folder, &[&fixed[..], arguments].concat());
    assert!(answered.status.success(), "{}", text_of(&answered));
    serde_json::from_slice(&answered.stdout).unwrap()
}

#[test]
fn positions_of_a_five_bar_are_planned_twice_to_the_same_bytes_and_read_again() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), FIVE_BAR).unwrap();
    let mut csv = "pose,x_mm,y_mm\n".to_owned();
    for (pose, (_, _, p)) in holes().iter().filter(|(i, j, _)| [0, 23].contains(i) || [0, 23].contains(j)).enumerate() {
        let _ = writeln!(csv, "{pose},{},{}", p[0], p[1]);
    }
    std::fs::write(folder.path().join("c.csv"), csv).unwrap();
    let arguments = ["--positions", "6", "--nodes", "0", "--standard-uncertainty-um", "10", "--poses", "chosen.csv"];
    let first = plan(folder.path(), &arguments);
    assert_eq!(first, plan(folder.path(), &arguments));
    assert_eq!(first.choice.chosen.len(), 6);
    assert!(first.optimality.at_most_below_percent.unwrap() < 3.0, "{first:?}");
    assert!(
        first.optimality.value >= first.optimality.greedy.value
            && first.optimality.bound.unwrap() >= first.optimality.value
    );
    assert!((first.prediction.observability.as_ref().unwrap().o1 / first.optimality.value - 1.0).abs() < 1e-6);
    assert!(first.prediction.parameters.iter().all(|p| p.identifiable && p.standard_uncertainty.unwrap() > 0.0));
    assert!(first.prediction.workspace.unwrap().max_mm > first.prediction.workspace.unwrap().rms_mm);
    // the chosen poses are candidates again: all of them is the only choice, with the same index
    std::fs::rename(folder.path().join("chosen.csv"), folder.path().join("c.csv")).unwrap();
    let again = plan(folder.path(), &["--positions", "6"]);
    assert!(
        again.optimality.proven_optimal && (again.optimality.value / first.optimality.value - 1.0).abs() < 1e-9,
        "{again:?}"
    );
    // too few positions are refused
    let few = ["plan", "--robot", "robot.toml", "--candidates", "c.csv", "--positions", "1"];
    // beside nominal values one is enough
    assert_eq!(etalon(folder.path(), &few).status.code(), Some(0));
    let few = etalon(folder.path(), &[&few[..], &["--prior", "none"]].concat());
    assert_eq!(few.status.code(), Some(2));
    assert!(text_of(&few).contains("[too-few-poses-planned]"), "{}", text_of(&few));
    let unknown = text_of(&etalon(
        folder.path(),
        &["plan", "--robot", "robot.toml", "--candidates", "c.csv", "--positions", "6", "--start", "77777"],
    ));
    assert!(unknown.says("[start-pose-unknown] pose=77777"), "{unknown}");
}

#[test]
fn one_working_mode_says_what_it_cannot_tell() {
    let folder = tempfile::tempdir().unwrap();
    // in one working mode alone, not every one of the seven positions is away from singularities
    let unlimited = FIVE_BAR.split("[reach]").next().unwrap();
    std::fs::write(folder.path().join("robot.toml"), unlimited).unwrap();
    let robot = robot();
    let nominal = robot.nominal();
    let mut csv = "pose,theta1_deg,theta2_deg,assembly\n".to_owned();
    for (pose, p) in SEVEN.iter().enumerate() {
        let q = robot.inverse(&nominal, robot.to_base(&nominal, *p), [1.0, 1.0]);
        let mode = robot.assembly_at(&nominal, q, robot.to_base(&nominal, *p));
        let _ = writeln!(csv, "{pose},{},{},{mode}", q[0].to_degrees(), q[1].to_degrees());
    }
    std::fs::write(folder.path().join("c.csv"), &csv).unwrap();
    let found = plan(folder.path(), &["--positions", "7", "--nodes", "0"]);
    assert!(found.messages.iter().any(|m| m.what.contains("identifiable")), "{:?}", found.messages);
    assert!(
        found.prediction.parameters.iter().filter(|p| !p.confounded_with.is_empty()).count() >= 2,
        "{:?}",
        found.prediction.parameters
    );
    // a candidate without its assembly mode is refused, with the way out
    std::fs::write(
        folder.path().join("c.csv"),
        csv.replace(",assembly", "").replace(",1\n", "\n").replace(",-1\n", "\n"),
    )
    .unwrap();
    let refused =
        etalon(folder.path(), &["plan", "--robot", "robot.toml", "--candidates", "c.csv", "--positions", "7"]);
    assert!(text(&refused.stderr).contains("error[assembly-mode-missing]"), "{}", text_of(&refused));
}

#[test]
fn what_is_out_of_reach_is_told_and_never_chosen() {
    let folder = tempfile::tempdir().unwrap();
    let rows = |robot: &str, csv: &str| {
        std::fs::write(folder.path().join("robot.toml"), robot).unwrap();
        std::fs::write(folder.path().join("c.csv"), csv).unwrap();
    };
    let sample = root().join("samples/prexyt-cmm/robot.toml");
    let prexyt = std::fs::read_to_string(sample).unwrap();
    let csv = "pose,rho1_mm,rho2_mm,rho3_mm\n1,0,300,300\n2,0,0,256\n3,0,300,44\n4,0,0,0\n5,170,300,300\n6,170,0,256\n\
               7,170,300,44\n8,170,0,0\n9,170.001,0,0\n10,0,-1,0\n";
    rows(&prexyt, csv);
    let found = plan(folder.path(), &["--positions", "8", "--nodes", "0"]);
    assert_eq!(found.choice.chosen.iter().map(|c| c.pose).collect::<Vec<_>>(), [1, 2, 3, 4, 5, 6, 7, 8]);
    let told = found.messages[0].to_string();
    for part in ["warning[candidates-left-out] count=2", "c.csv", "pose 9 (rho1 = 170.001 mm", "pose 10 (rho2 = -1 mm"]
    {
        assert!(told.says(part), "{part}: {told}");
    }
    rows(&prexyt, "pose,rho1_mm,rho2_mm,rho3_mm\n1,0,301,300\n");
    let none = etalon(folder.path(), &["plan", "--robot", "robot.toml", "--candidates", "c.csv", "--positions", "1"]);
    assert!(
        text(&none.stderr).says("error[candidates-unreachable] pose=1")
            && text(&none.stderr).contains("(rho2 = 301 mm"),
        "{}",
        text_of(&none)
    );
    // a five-bar with its distal links in line, one folded, one that does not close, and one beyond its encoder
    let limits = format!("{FIVE_BAR}theta2_deg = [-100.0, 100.0]\n");
    let joints = ["113.71,66.29,1", "100,80,1", "0,180,1", "50,130,1"];
    let csv = joints.iter().enumerate().map(|(i, row)| format!("{i},{row}\n")).collect::<String>();
    rows(&limits, &format!("pose,theta1_deg,theta2_deg,assembly\n{csv}"));
    let said = text_of(&etalon(
        folder.path(),
        &["plan", "--robot", "robot.toml", "--candidates", "c.csv", "--positions", "1"],
    ));
    for part in ["type 2", "theta2 = 180.000 deg"] {
        assert!(said.says(part), "{part}: {said}");
    }
}

#[test]
fn eight_poses_of_the_prexyt_are_better_than_the_corners() {
    let folder = tempfile::tempdir().unwrap();
    let sample = root().join("samples/prexyt-cmm/robot.toml");
    std::fs::copy(sample, folder.path().join("robot.toml")).unwrap();
    // set 1 of figure 3.5 as in the sample, then a grid of actuator values with less than 35 degrees between rails
    let corners = [
        [0, 300, 300],
        [0, 0, 256],
        [0, 300, 44],
        [0, 0, 0],
        [170, 300, 300],
        [170, 0, 256],
        [170, 300, 44],
        [170, 0, 0],
    ];
    let mut all = corners.to_vec();
    for rho1 in [0, 85, 170] {
        for rho2 in (0..=300).step_by(75) {
            for rho3 in (0..=300).step_by(60).filter(|r: &i32| (r - rho2).abs() <= 256) {
                all.push([rho1, rho2, rho3]);
            }
        }
    }
    let rows = all.iter().enumerate().map(|(i, [a, b, c])| format!("{},{a},{b},{c}\n", i + 1));
    std::fs::write(
        folder.path().join("c.csv"),
        "pose,rho1_mm,rho2_mm,rho3_mm\n".to_owned() + &rows.collect::<String>(),
    )
    .unwrap();
    let found = plan(folder.path(), &["--positions", "8", "--nodes", "0", "--compare", "1,2,3,4,5,6,7,8"]);
    let compared = found.optimality.compared.as_ref().unwrap();
    println!(
        "{:?}: {:.1} % better than set 1, at most {:.2} % below the best",
        found.choice.chosen.iter().map(|p| p.pose).collect::<Vec<_>>(),
        compared.better_by_percent,
        found.optimality.at_most_below_percent.unwrap()
    );
    assert!(compared.better_by_percent >= 0.0 && found.optimality.at_most_below_percent.unwrap() < 10.0);
    assert!(found.prediction.parameters.iter().all(|p| p.identifiable));
}

#[test]
fn an_irb120_is_planned_with_its_redundant_parameters_named() {
    let folder = tempfile::tempdir().unwrap();
    let sample = root().join("samples/abb-irb120/robot.toml");
    std::fs::copy(sample, folder.path().join("robot.toml")).unwrap();
    let mut csv = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    let mut noise = etalon::base::noise::Noise::new(3, 0);
    for pose in 1..=24 {
        let q = [150.0, 80.0, 60.0, 150.0, 110.0, 180.0].map(|half| noise.uniform(half).to_string()).join(",");
        for target in ["a", "b", "c"] {
            let _ = writeln!(csv, "{pose},{target},{q}");
        }
    }
    std::fs::write(folder.path().join("c.csv"), csv).unwrap();
    let found = plan(folder.path(), &["--positions", "12", "--nodes", "0", "--starts", "1"]);
    println!(
        "{} of {} parameters, at most {:.2} % below the best",
        found.prediction.parameters.iter().filter(|p| p.identifiable).count(),
        found.prediction.parameters.len(),
        found.optimality.at_most_below_percent.unwrap()
    );
    assert!(
        found.prediction.parameters.iter().any(|p| !p.identifiable && !p.confounded_with.is_empty()),
        "{:?}",
        found.prediction.parameters
    );
    assert!(
        found.optimality.value >= found.optimality.greedy.value
            && found.optimality.at_most_below_percent.unwrap() < 20.0
    );
}

#[test]
fn a_plan_writes_its_report_its_targets_and_a_simulated_calibration() {
    let folder = tempfile::tempdir().unwrap();
    let sample = root().join("samples/dextar");
    for file in ["robot.toml", "candidates.csv", "actual.toml", "plate.csv"] {
        std::fs::copy(sample.join(file), folder.path().join(if file == "candidates.csv" { "c.csv" } else { file }))
            .unwrap();
    }
    let wanted = ["--truth", "actual.toml", "--workspace", "plate.csv", "--report", "plan.html", "--targets", "t.json"];
    // every kind of report
    let wanted = [&wanted[..], &["--report", "plan.xlsx", "--report", "plan.pdf"]].concat();
    let fixed = ["--prior", "none", "--positions", "7", "--nodes", "0", "--standard-uncertainty-um", "10"];
    let found = plan(folder.path(), &[&fixed[..], &wanted].concat());
    let knee = found.optimality.greedy.knee_configurations.unwrap();
    assert!((22..=28).contains(&knee), "the thesis has its knee at about 25 configurations, here it is {knee}");
    assert_eq!(found.places.iter().filter(|p| p.chosen).count(), 7);

    // tables 4.1 to 4.3
    let study = found.study.as_ref().unwrap();
    for step in &study.steps {
        println!("{} positions: rms {:.2} um, max {:.2} um", step.positions, 1e3 * step.rms_mm, 1e3 * step.max_mm);
    }
    assert!(study.steps.windows(2).all(|w| w[1].rms_mm < w[0].rms_mm && w[1].positions == w[0].positions + 1));
    let last = study.steps.last().unwrap();
    assert!(
        last.positions == 7 && last.rms_mm < 0.0036 && last.max_mm < 0.0105 && last.rms_before_mm > 5.0,
        "{last:?}"
    );
    assert!(study.parameters.iter().all(|p| (p.identified - p.actual).abs() < 0.02), "{:?}", study.parameters);

    let page = std::fs::read_to_string(folder.path().join("plan.html")).unwrap();
    let names = ["id=\"curve-title\"", "id=\"chosen-title\"", "id=\"off-mm-title\"", "id=\"map-after-xy-title\""];
    for name in names {
        assert!(page.contains(name), "{name}");
    }
    assert!(page.contains(&format!("knee: {knee}")) && !page.contains("NaN"));
    for (file, start) in [("plan.xlsx", &b"PK"[..]), ("plan.pdf", b"%PDF")] {
        assert!(std::fs::read(folder.path().join(file)).unwrap().starts_with(start), "{file}");
    }

    // every configuration is a target, with the numbers of the plan
    let json: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(folder.path().join("t.json")).unwrap()).unwrap();
    let targets = json["targets"].as_array().unwrap();
    let planned: Vec<_> =
        found.choice.chosen.iter().flat_map(|p| p.configurations.iter().map(move |c| (p.pose, c))).collect();
    assert_eq!(targets.len(), planned.len());
    for (target, (pose, joints)) in targets.iter().zip(planned) {
        assert_eq!(target["pose"].as_i64(), pose.number());
        assert!(joints.iter().all(|(column, value)| target["joints"][column].as_f64() == Some(*value)));
    }
    plan(folder.path(), &["--positions", "7", "--nodes", "0", "--targets", "t.h"]);
    let header = std::fs::read_to_string(folder.path().join("t.h")).unwrap();
    assert!(header.contains(&format!("#define ETALON_FIVE_BAR_TARGETS {}\n", targets.len())), "{header}");
    let source = folder.path().join("t.c");
    std::fs::write(
        &source,
        "#include \"t.h\"\nint main(void) { return etalon_five_bar_target_theta1_deg[0] > 1e9; }\n",
    )
    .unwrap();
    match std::process::Command::new("cc").args(["-std=c99", "-fsyntax-only"]).arg(&source).status() {
        Ok(status) => assert!(status.success()),
        Err(_) => println!("there is no C compiler: the header is not compiled"),
    }
    let wrong = etalon(
        folder.path(),
        &[
            "plan",
            "--robot",
            "robot.toml",
            "--candidates",
            "c.csv",
            "--positions",
            "7",
            "--nodes",
            "0",
            "--targets",
            "t.txt",
        ],
    );
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text_of(&wrong).contains("[targets-format-unknown]"), "{}", text_of(&wrong));
}
