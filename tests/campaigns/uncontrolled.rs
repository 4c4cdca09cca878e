//! What no reading shows is listed, and nominal geometry controls it. Synthetic.

use super::apart::{Arm, cells};
use crate::support::said::Says;
use crate::support::scratch::{copy_sample, ends, etalon};
use serde_json::Value;

/// Points of the world frame of the CMM sample: means of five readings, rounded to a tenth of a millimetre.
const NOMINAL: &str = "nominal_mm = { rail2_a = [323.3, 108.8, 95.3], rail2_b = [298.7, 488.0, 96.7], rail3_a = [722.1, 325.0, 96.9], R_home = [312.6, 148.1, 126.4] }\ntolerance_mm = 0.2\n";

#[test]
fn points_of_a_frame_without_redundancy_are_listed_and_nominal_places_control_them() {
    let scratch = copy_sample("prexyt-cmm");
    ends(&scratch, "run", 0, &[]);
    let open = &scratch.json("frames.json")["not_controlled"][0];
    assert_eq!(open["points"], serde_json::json!(["rail2_a", "rail2_b", "rail3_a", "R_home", "R_end"]));
    assert!(open["keys"][0].as_str().unwrap().contains("nominal_mm"), "{open}");
    let page = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(page.has_phrase("not-controlled-by-the-data") && page.contains("[frame.world] nominal_mm"));
    scratch.replace("campaign.toml", "towards = \"rail3_a\"\n", &format!("towards = \"rail3_a\"\n{NOMINAL}"));
    ends(&scratch, "run", 0, &[]);
    assert_eq!(scratch.json("frames.json")["not_controlled"][0]["points"], serde_json::json!(["R_end"]));
    // the ball at the origin is 20 mm off in each of its readings
    let world = scratch.path().join("exports/world.txt");
    let text = std::fs::read_to_string(&world).unwrap();
    let moved = |line: &str| match line.starts_with("R_home 312.6") || line.starts_with("R_home 312.5") {
        true => line.replacen(" 312.", " 332.", 1),
        false => line.to_owned(),
    };
    std::fs::write(&world, text.lines().map(moved).collect::<Vec<_>>().join("\n")).unwrap();
    for command in ["check", "run"] {
        ends(&scratch, command, 2, &["`R_home` is 20.0", "tolerance 0.2 mm", "campaign.toml"]);
    }
    // coordinates exchanged are a mirror image
    let exchanged = |line: &str| {
        let cells: Vec<&str> = line.split(' ').collect();
        [cells[0], cells[2], cells[1], cells[3]].join(" ")
    };
    std::fs::write(&world, text.lines().map(exchanged).collect::<Vec<_>>().join("\n")).unwrap();
    ends(&scratch, "check", 2, &["error[frame-points-mirrored]"]);
    std::fs::write(&world, text).unwrap();
    for (from, to, what) in [
        ("R_home = [312", "R_hom = [312", "error[nominal-point-unmeasured] point=R_hom"),
        ("tolerance_mm = 0.2\n", "", "[nominal-without-tolerance]"),
    ] {
        let before = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
        scratch.replace("campaign.toml", from, to);
        ends(&scratch, "check", 2, &[what]);
        std::fs::write(scratch.path().join("campaign.toml"), before).unwrap();
    }
}

#[test]
fn three_points_that_are_off_are_named_by_their_distance() {
    let scratch = copy_sample("column-arm");
    let nominal = "nominal_mm = { floor_1 = [3100, -1200, -900], floor_2 = [1622.4, 691.2, -891.6], floor_3 = [F3] }\ntolerance_mm = 0.5\n";
    let world = std::fs::read_to_string(scratch.path().join("exports/world.txt")).unwrap();
    let third = world.lines().find(|line| line.starts_with("floor_3")).unwrap();
    let third: Vec<String> =
        third.split(',').skip(1).map(|v| format!("{:.1}", 1e3 * v.parse::<f64>().unwrap())).collect();
    let nominal = nominal.replace("F3", &third.join(", "));
    scratch.replace("campaign.toml", "[frame.world]\n", &format!("[frame.world]\n{nominal}"));
    ends(&scratch, "check", 0, &[]);
    scratch.replace("campaign.toml", "floor_2 = [1622.4", "floor_2 = [1642.4");
    ends(&scratch, "check", 2, &["`floor_2`", "error[frame-points-off]"]);
}

#[test]
fn one_rounded_column_of_few_points_is_seen() {
    let scratch = copy_sample("column-arm");
    let said = ends(&scratch, "check", 0, &[]);
    assert!(!said.contains("[coordinates-rounded]"), "{said}");
    let world = scratch.path().join("exports/world.txt");
    let rounded = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        format!("{},{},{},{:.3}", cells[0], cells[1], cells[2], cells[3].parse::<f64>().unwrap())
    };
    let text = std::fs::read_to_string(&world).unwrap();
    std::fs::write(&world, text.lines().map(rounded).collect::<Vec<_>>().join("\n")).unwrap();
    ends(&scratch, "check", 0, &["[coordinates-rounded]", "(z to 0.001 m)"]);
}

#[test]
fn axes_that_are_exchanged_are_seen_where_the_base_has_a_nominal_place() {
    let nominal =
        "\n[nominal]\nbase_x = 0.0\nbase_y = 0.0\nbase_z = 0.0\nbase_rx = 0.0\nbase_ry = 0.0\nbase_rz = 0.0\n";
    for (order, what) in [([0, 1, 2], None), ([1, 2, 0], Some("[world-axes-exchanged]"))] {
        let scratch = copy_sample("draw-wire");
        let mut arm = Arm::new(&scratch, &["ball".to_owned()]);
        let mut table = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for pose in 1..=80 {
            let joints = arm.joints();
            let at = arm.at(&joints, 0);
            let at = arm.measured(at);
            table += &format!(
                "{pose},ball,{},{:.4},{:.4},{:.4}\n",
                cells(&joints),
                at[order[0]],
                at[order[1]],
                at[order[2]]
            );
        }
        std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
        let (_, said) = etalon(&scratch, "run");
        assert!(!said.contains("robot.toml states"), "without a nominal base nothing can be said: {said}");
        // the scale, then the place of the base
        let open = &scratch.json("frames.json")["not_controlled"];
        let rows: Vec<&Value> = open.as_array().unwrap().iter().map(|row| &row["what_phrase"]["id"]).collect();
        assert_eq!(rows, ["unshown-scale", "unshown-shift"], "{open}");
        assert!(open[1]["keys"][0].as_str().unwrap().contains("[nominal] base_x"), "{open}");
        let robot = std::fs::read_to_string(scratch.path().join("robot.toml")).unwrap();
        std::fs::write(scratch.path().join("robot.toml"), robot + nominal).unwrap();
        let (_, said) = etalon(&scratch, "run");
        match what {
            Some(what) => assert!(said.says(what) && said.contains("120.0 deg"), "{said}"),
            None => assert!(!said.contains("robot.toml states"), "{said}"),
        }
        // only the scale is open, as the instrument states no uncertainty of it
        let open = &scratch.json("frames.json")["not_controlled"];
        let rows: Vec<&Value> = open.as_array().unwrap().iter().map(|row| &row["what_phrase"]["id"]).collect();
        assert_eq!(rows, ["unshown-scale"], "{open}");
    }
}
