//! Files of a second draw of strangers: each is read rightly, asked about, or refused.

use super::{propose, propose_file};
use etalon_base::message::Message;
use etalon_documents::FormatsDocument;
use std::fmt::Write;

/// Three coordinates (mm) of a row.
fn xyz(row: usize) -> [f64; 3] {
    let t = row as f64;
    [1200.0 + 70.0 * (1.3 * t).sin(), -345.0 + 60.0 * (0.7 * t).cos(), 90.9 + 2.3 * t]
}

/// Angles (deg) of this number of joints in a row.
fn angles(count: usize, row: usize) -> Vec<f64> {
    (0..count).map(|k| (50.0 + 7.0 * k as f64) * (0.9 * row as f64 + 1.7 * k as f64).sin()).collect()
}

/// Twenty rows of cells behind a head.
fn table(head: &str, row: impl Fn(usize) -> String) -> String {
    (0..20).fold(head.to_owned(), |mut text, i| {
        let _ = writeln!(text, "{}", row(i));
        text
    })
}

fn cells(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:.4}")).collect::<Vec<String>>().join(",")
}

/// `true` if a doubt or a question has this id.
fn says(document: &FormatsDocument, id: &str) -> bool {
    let mut all = document.doubts.iter().chain(&document.questions);
    all.any(|text| text.phrase().is_some_and(|phrase| phrase.id == id))
}

fn holds(document: &FormatsDocument, lines: &str) {
    assert!(document.toml.contains(lines), "{lines} is not in\n{}", document.toml);
}

/// Error of a file that no proposal is made for.
fn refusal(text: &str) -> Message {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("f.txt");
    std::fs::write(&path, text).unwrap();
    propose_file(&path).unwrap_err().0.remove(0)
}

fn refused(text: &str, id: &str) {
    let message = refusal(text);
    assert!(message.is(id, &[]), "{message}");
}

/// The file is known as one of a kind without points.
fn without_points(text: &str, kind: &str) {
    let message = refusal(text);
    assert!(message.is("file-without-points", &[("kind", &kind)]), "{message}");
}

#[test]
fn parts_of_an_arm_are_its_joints_from_the_base_on_in_seven_languages() {
    for names in [
        "Base,Shoulder,Elbow,Wrist 1,Wrist 2,Wrist 3",
        "Basis,Schulter,Ellbogen,Handgelenk 1,Handgelenk 2,Handgelenk 3",
        "Base,Épaule,Coude,Poignet 1,Poignet 2,Poignet 3",
        "Base,Hombro,Codo,Muñeca 1,Muñeca 2,Muñeca 3",
        "Base,Spalla,Gomito,Polso 1,Polso 2,Polso 3",
        "机座,肩部,肘部,手腕1,手腕2,手腕3",
        "ベース,ショルダー,エルボー,リスト1,リスト2,リスト3",
    ] {
        let document = propose("r.csv", &table(&format!("{names}\n"), |i| cells(&angles(6, i))));
        let of: Vec<String> = (1..).zip(names.split(',')).map(|(k, name)| format!("q{k}_UNIT = \"{name}\"")).collect();
        holds(&document, &format!("columns = {{ {} }}", of.join(", ")));
        assert!(!says(&document, "doubt-columns-not-read") && !says(&document, "doubt-order-of-joints"), "{names}");
    }
    // in another order of the columns
    let names = "shoulder_pan_joint,elbow_joint,shoulder_lift_joint,wrist_1_joint,wrist_2_joint,wrist_3_joint";
    let document = propose("r.csv", &table(&format!("{names}\n"), |i| cells(&angles(6, i))));
    holds(&document, "q2_UNIT = \"shoulder_lift_joint\", q3_UNIT = \"elbow_joint\"");
    assert!(says(&document, "doubt-order-of-joints"), "{}", document.toml);
    // a base alone is no joint, and bodies of a motion are none
    let document = propose("r.csv", &table("Base,X,Y,Z\n", |i| cells(&[&[7.5 + i as f64][..], &xyz(i)].concat())));
    assert!(!document.toml.contains("joints"), "{}", document.toml);
    let body = |name: &str| ["px", "py", "pz", "qx", "qy", "qz", "qw"].map(|part| format!("{name}-{part}")).join(",");
    let row = |i: usize| {
        let half = 0.02 * i as f64;
        let turn = [0.6 * half.sin(), 0.0, 0.8 * half.sin(), half.cos()];
        cells(&[&xyz(i)[..], &turn, &xyz(i + 7), &turn].concat())
    };
    let document = propose("r.csv", &table(&format!("{},{}\n", body("Shoulder"), body("Elbow")), row));
    assert!(!document.toml.contains("q1_") && document.toml.matches("\n[[export]]").count() == 2, "{}", document.toml);
}

#[test]
fn joints_are_named_by_letters_and_counts_of_encoders_are_no_joints_beside_them() {
    let row = |i: usize| cells(&[&angles(3, i)[..], &xyz(i)].concat());
    let document = propose("r.csv", &table("Theta A (deg),Theta B (deg),Theta C (deg),X (mm),Y (mm),Z (mm)\n", row));
    holds(&document, "q1_deg = \"Theta A (deg)\", q2_deg = \"Theta B (deg)\", q3_deg = \"Theta C (deg)\"");
    let names: Vec<String> =
        ["Encoder", "Theta"].iter().flat_map(|name| (1..=6).map(move |k| format!("{name} {k}"))).collect();
    let row = |i: usize| {
        let counts: Vec<f64> = angles(6, i).iter().map(|v| (500.0 * v).round()).collect();
        cells(&[counts, angles(6, i)].concat())
    };
    let document = propose("r.csv", &table(&(names.join(",") + "\n"), row));
    holds(&document, "columns = { q1_UNIT = \"Theta 1\"");
    assert!(says(&document, "doubt-two-families") && !document.toml.contains("q7_"), "{}", document.toml);
}

#[test]
fn a_target_in_german_an_rms_and_a_torque_are_what_they_are() {
    let row = |i: usize| format!("K{},{},{}", i % 2 + 1, i / 2 + 1, cells(&xyz(i)));
    let document = propose("r.csv", &table("Ziel,Pose,X [mm],Y [mm],Z [mm]\n", row));
    holds(&document, "columns = [\"target\", \"pose\", \"x\", \"y\", \"z\"]");
    let row = |i: usize| cells(&[xyz(i), xyz(i).map(|v| v + 0.3 * (5.0 * v).sin())].concat());
    let document = propose("r.csv", &table("X Ziel,Y Ziel,Z Ziel,X Ist,Y Ist,Z Ist\n", row));
    assert!(document.columns[0].taken_for.english().contains("commanded"), "{}", document.toml);
    holds(&document, "[\"-\", \"-\", \"-\", \"x\", \"y\", \"z\"]");
    for heading in ["RMS", "Image RMS", "U(95)", "std"] {
        let row = |i: usize| format!("P{i},{},0.0{}", cells(&xyz(i)), 11 + i % 5);
        let document = propose("r.csv", &table(&format!("Point,X,Y,Z,{heading}\n"), row));
        let taken = document.columns[4].taken_for.phrase().map(|phrase| phrase.id.clone());
        assert!(
            taken.as_deref() == Some("means-scatter") && says(&document, "doubt-columns-not-read"),
            "{}",
            document.toml
        );
    }
    let row = |i: usize| {
        let force: Vec<f64> = (0..6).map(|k| 3.0 * (1.1 * (i + k) as f64).sin()).collect();
        cells(&[&force[..], &xyz(i)].concat())
    };
    let document = propose("r.csv", &table("FX,FY,FZ,TX,TY,TZ,PX,PY,PZ\n", row));
    holds(&document, "[\"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"x\", \"y\", \"z\"]");
}

/// A number that heads the rows is the pose: another file may have the rows in another order. The
/// frames of a recording are no poses.
#[test]
fn a_number_of_the_rows_is_the_pose() {
    for (heading, role) in
        [("Nr", "pose"), ("No.", "pose"), ("Num", "pose"), ("Lfd. Nr.", "pose"), ("Frame", "-"), ("Sample No", "-")]
    {
        let document =
            propose("r.csv", &table(&format!("{heading},X,Y,Z\n"), |i| format!("{},{}", i + 1, cells(&xyz(i)))));
        holds(&document, &format!("columns = [\"{role}\", \"x\", \"y\", \"z\"]"));
    }
    let log = propose("r.csv", &table("Nr,J1,J2,J3\n", |i| format!("{},{}", i + 1, cells(&angles(3, i)))));
    holds(&log, "columns = { pose = \"Nr\", q1_UNIT = \"J1\"");
}

#[test]
fn a_vertical_angle_is_a_zenith_angle_or_an_elevation_with_a_doubt() {
    for (mean, role) in [(95.0, "zenith"), (5.0, "elevation")] {
        let row = |i: usize| {
            format!("{},{}", i + 1, cells(&[20.0 + i as f64, mean + (i as f64).sin(), 2.0 + 0.1 * i as f64]))
        };
        let document = propose("r.csv", &table("Pkt,Hz [deg],V [deg],D [m]\n", row));
        holds(&document, &format!("columns = [\"label\", \"azimuth\", \"{role}\", \"distance\"]"));
        assert!(says(&document, "doubt-vertical-angle") && !says(&document, "doubt-polar"), "{}", document.toml);
    }
}

#[test]
fn groups_alone_counts_above_the_data_and_labels_with_blanks_hide_no_coordinate() {
    let row = |i: usize| cells(&[&xyz(i)[..], &angles(4, i)].concat());
    let document = propose("r.csv", &table("tracker positions,,,robot joint positions\n", row));
    holds(&document, "columns = [\"x\", \"y\", \"z\", \"-\"");
    assert!(says(&document, "doubt-groups-alone") && document.toml.contains("q4_UNIT = 7"), "{}", document.toml);
    let document = propose("r.txt", &table("6, 12, pivot.txt\n", |i| cells(&xyz(i)).replace(',', ", ")));
    holds(&document, "header = 1, columns = [\"x\", \"y\", \"z\"]");
    let document = propose("r.txt", &table("", |i| format!("EU3 N{i}\t{}\tDATUM", cells(&xyz(i)).replace(',', "\t"))));
    holds(&document, "delimiter = \"tab\"");
    holds(&document, "columns = [\"label\", \"x\", \"y\", \"z\", \"-\"]");
    // a text in one row leaves the column its numbers
    let row = |i: usize| if i == 11 { "P11,1.5,2.5,lost".to_owned() } else { format!("P{i},{}", cells(&xyz(i))) };
    let document = propose("r.csv", &table("Name,X,Y,Z\n", row));
    holds(&document, "columns = [\"label\", \"x\", \"y\", \"z\"]");
    assert!(says(&document, "doubt-rows-not-read"), "{}", document.toml);
    // a version is no date
    let document = propose("r.csv", &table("version,X,Y,Z\n", |i| format!("2.5.3.50294,{}", cells(&xyz(i)))));
    assert!(!document.toml.contains("date"), "{}", document.toml);
}

#[test]
fn numbers_without_headings_and_blocks_and_poses_of_a_controller_are_asked() {
    let row = |i: usize| cells(&[&angles(6, i)[..], &xyz(i), &[0.0; 3]].concat());
    assert!(says(&propose("r.csv", &table("", row)), "ask-numbers-without-headings"));
    let block = |name: &str| table(&format!("Name,{name},,,\nX,Y,Z\n"), |i| cells(&xyz(i)));
    let document = propose("r.csv", &format!("{}{}", block("A"), block("B")));
    assert!(says(&document, "ask-blocks"), "{}", document.toml);
    let names: Vec<String> = (1..=6).map(|k| format!("measured_q{k}")).collect();
    let row = |i: usize| cells(&[&xyz(i)[..], &angles(6, i), &xyz(i + 3)].concat());
    let head = format!("cam_x,cam_y,cam_z,{},measured_x,measured_y,measured_z\n", names.join(","));
    assert!(says(&propose("r.csv", &table(&head, row)), "ask-computed-by-controller"));
}

/// Numbers that are joints or points are asked about in the lines, not only in a comment.
#[test]
fn many_numbers_without_headings_are_open_columns() {
    let row = |i: usize| cells(&[&angles(6, i)[..], &xyz(i), &[0.0; 3]].concat());
    let document = propose("r.csv", &table("", row));
    holds(&document, "format = { delimiter = \",\", decimal = \".\", columns = \"?\" }");
    assert!(!document.toml.contains("\"x\", \"y\", \"z\", \"-\", \"-\"]"), "{}", document.toml);
    // behind a name, and in front of a direction, they are a point
    let document = propose("r.csv", &table("", |i| format!("P{i},{}", cells(&[xyz(i), xyz(i + 7)].concat()))));
    holds(&document, "columns = [\"label\", \"x\", \"y\", \"z\"");
    // but not the joints of an arm and a point, or commanded, measured and deviation
    let document = propose("r.csv", &table("", |i| format!("P{i},{}", cells(&[&angles(6, i)[..], &xyz(i)].concat()))));
    holds(&document, "columns = \"?\"");
    let near = |i: usize| xyz(i).map(|v| v + 0.05);
    let row = |i: usize| format!("P{i},{}", cells(&[xyz(i), near(i), [0.05, 0.04, 0.06]].concat()));
    let document = propose("r.csv", &table("", row));
    assert!(document.toml.contains("\"x\"") && says(&document, "ask-sets-alike"), "{}", document.toml);
    let row = |i: usize| cells(&[&xyz(i)[..], &[0.5, 2.5, 0.6, 0.0, 0.8]].concat());
    holds(&propose("r.csv", &table("", row)), "columns = [\"x\", \"y\", \"z\"");
}

#[test]
fn files_without_points_are_refused_for_their_reason() {
    let line = |i: usize| format!("mark index: {i}\npoint x:{:.3} y:{:.3} z:{:.3}", xyz(i)[0], xyz(i)[1], xyz(i)[2]);
    refused(&table("", line), "numbers-behind-names");
    for (text, kind) in [
        ("\u{feff}<STX>\n00NMSDR33 V04-04.02     01-Jan-08 00:00 111111\n10NMJOB3            121111\n", "sdr33"),
        ("JOB     SAMPLE\nINST    NTS-350 Ver. 2008.07.08\nUNITS   M,G\nSTN     S2,1.636,\n", "south"),
        ("# Blender\no cube\nv 1.0 2.0 3.0\nv 1.0 2.0 4.0\nv 1.0 3.0 3.0\nf 1 2 3\n", "mesh"),
    ] {
        without_points(text, kind);
    }
    // words of a level contain no point
    let level = "110002+0000000G 83..58+00000000 \n110003+0000000G 32...8+02275233 331.08+00126139 390...+00000003 \n";
    let document = propose("s.gsi", level);
    assert!(says(&document, "doubt-rows-refused"), "{}", document.toml);
}

#[test]
fn rates_and_directions_and_matrices_are_no_points_and_no_joints() {
    let rate = |i: usize, k: usize| 0.1 * (1.3 * (i + 2 * k) as f64).sin();
    let row = |i: usize| cells(&(0..6).map(|k| rate(i, k)).collect::<Vec<f64>>());
    let document = propose("r.csv", &table("Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z\n", row));
    assert!(!document.toml.contains("[[export]]"), "{}", document.toml);
    let row = |i: usize| format!("{i},{},{}", cells(&xyz(i)), cells(&[rate(i, 0), rate(i, 1), rate(i, 2)]));
    let document = propose("r.csv", &table("t [ms],x,y,z,force_vx,force_vy,force_vz\n", row));
    assert!(!document.toml.contains("zenith"), "{}", document.toml);
    // axes of a tool beside its position
    let row = |i: usize| cells(&[&[0.6, 0.0, 0.8][..], &xyz(i), &[0.0, 1.0, 0.0]].concat());
    let document = propose("r.csv", &table("toolX X,toolX Y,toolX Z,P X,P Y,P Z,toolZ X,toolZ Y,toolZ Z\n", row));
    assert_eq!(document.toml.matches("\n[[export]]").count(), 1, "{}", document.toml);
    // a counter of joints, and a matrix row by row
    let row = |i: usize| {
        let (s, c) = (0.1 * i as f64).sin_cos();
        format!("6,{},{}", cells(&xyz(i)), cells(&[c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0]))
    };
    let document = propose("r.csv", &table("joint_cnt,x,y,z,o0,o1,o2,o3,o4,o5,o6,o7,o8\n", row));
    assert!(document.toml.contains("\"r11\"") && !document.toml.contains("q1_"), "{}", document.toml);
}

/// The hand of a body is not commanded because an arm is its distance from the shoulder; a point in
/// two frames is no pair of targets.
#[test]
fn distances_of_bodies_are_no_deviations_and_two_frames_are_asked() {
    let row = |i: usize| {
        let (hand, shoulder) = (xyz(i), xyz(i + 5).map(|v| v + 400.0));
        let arm: Vec<f64> = (0..3).map(|k| shoulder[k] - hand[k]).collect();
        cells(&[&hand[..], &shoulder, &arm].concat())
    };
    let head = "hand X,hand Y,hand Z,shoulder X,shoulder Y,shoulder Z,arm X,arm Y,arm Z\n";
    let document = propose("r.csv", &table(head, row));
    assert!(!says(&document, "doubt-sets-by-difference"), "{}", document.toml);
    let row = |i: usize| {
        let [x, y, z] = xyz(i);
        cells(&[x, y, z, 10.0 + 0.001 * y, -20.0 - 0.001 * x, 0.001 * z])
    };
    let document = propose("r.csv", &table("cam_x,cam_y,cam_z,arm_x,arm_y,arm_z\n", row));
    assert!(says(&document, "ask-two-frames"), "{}", document.toml);
    let row = |i: usize| cells(&[xyz(i), xyz(3 * i + 7)].concat());
    let document = propose("r.csv", &table("cam_x,cam_y,cam_z,arm_x,arm_y,arm_z\n", row));
    assert!(!says(&document, "ask-two-frames"), "{}", document.toml);
    // a camera with an error of millimetres; the target is a question in the lines
    let turned = |i: usize| {
        let [x, y, z] = xyz(i);
        [900.0 - y + 3.0 * (7.1 * i as f64).sin(), x, 40.0 + z + 2.0 * (3.3 * i as f64).cos()]
    };
    let document =
        propose("r.csv", &table("ccs_x,ccs_y,ccs_z,ac_x,ac_y,ac_z\n", |i| cells(&[xyz(i), turned(i)].concat())));
    assert!(says(&document, "ask-two-frames"), "{}", document.toml);
    assert_eq!(document.toml.matches("target = \"?\"").count(), 2, "{}", document.toml);
    // names with numbers are targets
    let document =
        propose("r.csv", &table("k1_x,k1_y,k1_z,k2_x,k2_y,k2_z\n", |i| cells(&[xyz(i), turned(i)].concat())));
    assert!(!says(&document, "ask-two-frames"), "{}", document.toml);
    // two targets on a body that turns
    let second = |i: usize| {
        let ([x, y, z], t) = (xyz(i), 0.8 * i as f64);
        [x + 20.0 * t.sin(), y + 20.0 * t.cos(), z]
    };
    let document =
        propose("r.csv", &table("ball_x,ball_y,ball_z,nut_x,nut_y,nut_z\n", |i| cells(&[xyz(i), second(i)].concat())));
    assert!(!says(&document, "ask-two-frames") && !document.toml.contains("target = \"?\""), "{}", document.toml);
}

#[test]
fn four_points_without_coordinates_are_joints_and_a_wide_table_is_transposed() {
    let document = propose("r.csv", &table("P1,P2,P3,P4\n", |i| cells(&angles(4, i))));
    assert!(document.toml.contains("q4_UNIT = \"P4\"") && says(&document, "doubt-unnamed-joints"), "{}", document.toml);
    let wide = (0..9).fold(String::new(), |text, k| {
        let cells: Vec<String> = (0..600).map(|i| format!("{:.4}", (0.01 * f64::from(i * (k + 1))).sin())).collect();
        text + &cells.join(",") + "\n"
    });
    let document = propose("r.csv", &wide);
    assert!(says(&document, "doubt-transposed") && !document.toml.contains("[[export]]"), "{}", document.toml);
    for (text, kind) in [
        ("OFF\n8 6 0\n0 0 0\n1 0 0\n3 0 1 4\n", "mesh"),
        ("def P():\n  movej(p[0.1, 0.2, 0.3, 0, 0, 1])\n", "urscript"),
        ("DEF P()\nPTP {X 1.5,Y 2.5,Z 3.5,A 0,B 90,C 0}\nEND\n", "krl"),
        ("%\nG90\nG1 X1.5 Y2.5 Z3.5\nG1 X1.6 Y2.5 Z3.5\nM30\n", "gcode"),
        ("ISO-10303-21;\nDATA;\n#1=CARTESIAN_POINT('',(1.0,2.0,3.0));\n#2=CARTESIAN_POINT('',(1.5,2.0,3.0));\n", "cad"),
    ] {
        without_points(text, kind);
    }
}

/// A pose of the robot in the rows of a measurement is what `etalon cell` reads.
#[test]
fn a_pose_of_the_robot_beside_a_measured_pose_names_the_command() {
    let half = |i: usize| 0.05 * i as f64;
    let row = |i: usize| {
        let turn = [0.0, half(i).sin(), 0.0, half(i).cos()];
        cells(&[&xyz(i)[..], &turn, &xyz(i + 5), &[0.1 * i as f64, 0.2, 0.3]].concat())
    };
    let head = "flange_x,flange_y,flange_z,flange_qx,flange_qy,flange_qz,flange_qw,measurement_x,measurement_y,measurement_z,\
                measurement_rx,measurement_ry,measurement_rz\n";
    let document = propose("r.csv", &table(head, row));
    let doubt = document.doubts.iter().filter_map(|doubt| doubt.phrase()).find(|of| of.id == "doubt-pose-of-robot");
    assert!(doubt.is_some() && document.toml.contains("--solve hand-eye"), "{}", document.toml);
}

/// The point of an instrument is measured, whatever the controller calls its own pose.
#[test]
fn a_marker_is_measured_and_not_the_pose_of_the_controller() {
    let names: Vec<String> = (1..=6).map(|k| format!("measured_q{k}")).collect();
    let angle = |i: usize| [0.1 * i as f64, 0.2, 0.3];
    let row = |i: usize| cells(&[&xyz(i)[..], &angle(i), &angles(6, i), &xyz(i + 3), &angle(i + 1)].concat());
    let head = format!(
        "measured_x,measured_y,measured_z,measured_rx,measured_ry,measured_rz,{},marker_x,marker_y,marker_z,marker_rx,\
         marker_ry,marker_rz\n",
        names.join(",")
    );
    let document = propose("r.csv", &table(&head, row));
    assert!(says(&document, "doubt-computed-by-controller"), "{}", document.toml);
    holds(&document, "x_UNIT = \"marker_x\"");
    holds(&document, "a_UNIT = \"marker_rx\"");
}

/// Velocities, forces and places on a screen are no points, by their words and by their units.
#[test]
fn quantities_with_other_units_are_no_coordinates() {
    let rate = |i: usize, k: usize| 0.1 * (1.3 * (i + 2 * k) as f64).sin();
    let row = |i: usize| cells(&[rate(i, 0), rate(i, 1), rate(i, 2)]);
    for head in [
        "X [rad/s],Y [rad/s],Z [rad/s]",
        "X [g],Y [g],Z [g]",
        "x (m/s),y (m/s),z (m/s)",
        "x m/s^2,y m/s^2,z m/s^2",
        "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]",
        "gravity_x,gravity_y,gravity_z",
        "jerk_x,jerk_y,jerk_z",
        "twist.linear.x,twist.linear.y,twist.linear.z",
        "Beschl_X,Beschl_Y,Beschl_Z",
        "scale_x,scale_y,scale_z",
        "ft_x,ft_y,ft_z",
        "wX,wY,wZ",
        "imu_ax,imu_ay,imu_az",
        "x,y,z\nm/s,m/s,m/s",
    ] {
        let document = propose("r.csv", &table(&format!("{head}\n"), row));
        assert!(!document.toml.contains("[[export]]"), "{head}: {}", document.toml);
    }
    let document = propose("r.csv", &table("J1 [Nm],J2 [Nm],J3 [Nm]\n", row));
    assert!(!document.toml.contains("[log]"), "{}", document.toml);
    let row = |i: usize| cells(&[rate(i, 0), rate(i, 1), rate(i, 2), rate(i, 3), rate(i, 4), rate(i, 5)]);
    let document = propose("r.csv", &table("linear_x,linear_y,linear_z,angular_x,angular_y,angular_z\n", row));
    assert!(!document.toml.contains("[[export]]"), "{}", document.toml);
    // lengths keep their unit
    let document =
        propose("r.csv", &table("X [mm],Y [mm],Z [mm],v [mm/s]\n", |i| cells(&[&xyz(i)[..], &[1.5]].concat())));
    holds(&document, "[\"x\", \"y\", \"z\", \"-\"]");
}

/// Coordinates of a CMM whose headings join the state and the axis, a clock with its zone, and a
/// matrix behind numbers that are no point.
#[test]
fn words_of_a_machine_and_clocks_with_zones_are_known() {
    let row = |i: usize| format!("Point{i:03},1,0.01{},{}", i % 7, cells(&xyz(i)));
    let document = propose("r.csv", &table("Element Name,Number,Deviation,MX Coord.,MY Coord.,MZ Coord.\n", row));
    holds(&document, "columns = [\"label\", \"-\", \"-\", \"x\", \"y\", \"z\"]");
    let row = |i: usize| format!("2025-07-03 14:00:{:02}+02:00,{}", 2 * i, cells(&xyz(i)));
    holds(&propose("r.csv", &table("Timestamp,X,Y,Z\n", row)), "columns = [\"timestamp\", \"x\", \"y\", \"z\"]");
    let row = |i: usize| {
        let (s, c) = (0.1 * i as f64).sin_cos();
        let turn = [c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0];
        format!("{},{}", 1_576_134_868_955_u64 + 14 * i as u64, cells(&[&angles(9, i)[..], &turn].concat()))
    };
    assert!(!propose("r.csv", &table("", row)).toml.contains("\"x\""));
}

/// `R` in front of a name is the right of two bodies.
#[test]
fn the_right_of_two_bodies_is_no_rotation() {
    let far = |i: usize| xyz(3 * i + 7).map(|v| v + 31.0 * (3.0 * v).sin());
    for (head, names) in [
        ("R_Hand_x,R_Hand_y,R_Hand_z,L_Hand_x,L_Hand_y,L_Hand_z\n", ["r_hand", "l_hand"]),
        ("R.x,R.y,R.z,L.x,L.y,L.z\n", ["right", "left"]),
    ] {
        let document = propose("r.csv", &table(head, |i| cells(&[xyz(i), far(i)].concat())));
        for name in names {
            holds(&document, &format!("target = \"{name}\""));
        }
    }
    // `qz` twice is a mistake for `qw`
    let row = |i: usize| {
        let half = 0.05 * i as f64;
        cells(&[&xyz(i)[..], &[0.6 * half.sin(), 0.8 * half.sin(), 0.0, half.cos()]].concat())
    };
    let head = "R_Hand-px,R_Hand-py,R_Hand-pz,R_Hand-qx,R_Hand-qy,R_Hand-qz,R_Hand-qz\n";
    let document = propose("r.csv", &table(head, row));
    holds(&document, "[\"x\", \"y\", \"z\", \"qx\", \"qy\", \"qz\", \"qw\"]");
    assert!(says(&document, "ask-quaternion-order"), "{}", document.toml);
}

/// A code in all rows is no label; the number behind it names the rows.
#[test]
fn one_text_in_all_rows_is_asked_about() {
    let document = propose("r.csv", &table("", |i| format!("SS,{},{},2P", i + 1, cells(&xyz(i)))));
    holds(&document, "columns = [\"target\", \"pose\", \"x\", \"y\", \"z\", \"-\"]");
    assert!(says(&document, "ask-text-in-all-rows"), "{}", document.toml);
    // the words of the lines between blocks are no labels
    let block = |name: usize| {
        let head = format!("Name,M{name} (XY),,\nMax,0.0{name},,\n,X,Y,Z\n");
        (0..4).fold(head, |text, i| text + &format!("Merkmal,{}\n", cells(&xyz(4 * name + i))))
    };
    let document = propose("r.csv", &(1..8).map(block).collect::<String>());
    assert!(!document.toml.contains("\"label\""), "{}", document.toml);
}

/// Joints and matrices of several arms under the same headings: the first is proposed and asked.
#[test]
fn headings_of_several_arms_are_asked_about() {
    let row = |i: usize| {
        let (s, c) = (0.1 * i as f64).sin_cos();
        let turn = [c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0];
        format!(
            "{},{}",
            cells(&[&xyz(i)[..], &turn, &turn].concat()),
            cells(&[angles(3, i), angles(4, i + 2)].concat())
        )
    };
    let turn: Vec<String> = (0..9).map(|k| format!("o{k}")).collect();
    let head = format!("x,y,z,{0},{0},J1,J2,J3,J1,J2,J3,J4\n", turn.join(","));
    let document = propose("r.csv", &table(&head, row));
    assert!(says(&document, "ask-joints-again") && !document.toml.contains("q4_"), "{}", document.toml);
    assert!(!document.toml.contains("qw") && document.toml.contains("q3_UNIT = 24"), "{}", document.toml);
}

/// Seconds and nanoseconds in two columns are one time.
#[test]
fn seconds_and_their_fractions_are_one_time() {
    for (seconds, fractions) in
        [("sec", "nanosec"), ("secs", "nsecs"), ("header.stamp.sec", "header.stamp.nanosec"), ("stamp_s", "stamp_ns")]
    {
        let row = |i: usize| format!("{},{},{}", 1_723_186_330 + i / 10, i % 10 * 100_000_000, cells(&xyz(i)));
        let document = propose("r.csv", &table(&format!("{seconds},{fractions},x,y,z\n"), row));
        holds(&document, &format!("time_s = \"{seconds} + {fractions} / 1000000000\""));
        assert!(!says(&document, "doubt-columns-not-read"), "{}", document.toml);
        let row = |i: usize| format!("{},{},{}", 1_723_186_330 + i / 10, i % 10 * 100_000_000, cells(&angles(3, i)));
        let document = propose("r.csv", &table(&format!("{seconds},{fractions},J1,J2,J3\n"), row));
        holds(&document, &format!("columns = {{ time_s = \"{seconds} + {fractions} / 1000000000\", q1_UNIT"));
    }
    let document = propose("r.csv", &table("msec,x,y,z\n", |i| format!("{},{}", 10 * i, cells(&xyz(i)))));
    holds(&document, "columns = [\"time_ms\", \"x\", \"y\", \"z\"]");
}

/// Lists in cells are refused for their reason; a line break within quotation marks ends no row.
#[test]
fn lists_in_cells_are_refused_and_cells_of_several_lines_are_read() {
    let turn = |i: usize| cells(&[(0.1 * i as f64).cos(), (0.1 * i as f64).sin(), 0.25, 0.5]);
    let line = |i: usize| format!("{:.2}\t{}\t{}", 0.01 * i as f64, turn(i), turn(i + 3));
    refused(&table("time\ttorso\tpelvis\n", line), "numbers-in-cells");
    let pose = |i: usize| format!("{:.2};{}", 0.01 * i as f64, cells(&xyz(i)));
    refused(&table("t;pose\n", pose), "numbers-in-cells");
    let pose = |i: usize| format!("{:.2},{}", 0.01 * i as f64, cells(&xyz(i)).replace(',', " "));
    refused(&table("t,pose\n", pose), "numbers-in-cells");
    let pose = |i: usize| format!("{:.2},\"{}\"", 0.01 * i as f64, cells(&xyz(i)));
    refused(&table("t,pose\n", pose), "numbers-in-cells");
    let matrix =
        |i: usize| format!("{i},\"[[ 0.6 -0.8  0.0  {i}.5 ]\n [ 0.8  0.6  0.0  2.5 ]\n [ 0.0  0.0  1.0  7.5 ]]\",up");
    refused(&table("frame,pose,note\n", matrix), "numbers-in-brackets");
    let head = "\"Name\",\"X\n[mm]\",\"Y\r\n[mm]\",\"Z\n[mm]\"\n";
    let document = propose("r.csv", &table(head, |i| format!("P{i},{}", cells(&xyz(i)))));
    holds(&document, "header = 1, columns = [\"label\", \"x\", \"y\", \"z\"]");
    holds(&document, "unit = \"mm\"");
    let document = propose("r.csv", &table("Name,Note,X,Y,Z\n", |i| format!("P{i},\"a\nb {i}\",{}", cells(&xyz(i)))));
    holds(&document, "columns = [\"label\", \"-\", \"x\", \"y\", \"z\"]");
    assert!(document.rows == 20 && document.doubts.is_empty(), "{}", document.toml);
    // a label of two numbers is no list
    let document = propose("r.csv", &table("", |i| format!("1 {i},{}", cells(&xyz(i)))));
    holds(&document, "columns = [\"label\", \"x\", \"y\", \"z\"]");
}

/// Rows and columns that are exchanged are told by their names, and by few rows of many numbers.
#[test]
fn exchanged_rows_and_columns_are_told() {
    let row = |name: &str, k: usize| format!("{name},{}", cells(&(0..40).map(|i| xyz(i)[k]).collect::<Vec<f64>>()));
    let document =
        propose("r.csv", &["x", "y", "z"].iter().enumerate().map(|(k, name)| row(name, k) + "\n").collect::<String>());
    assert!(says(&document, "doubt-transposed") && !document.toml.contains("[[export]]"), "{}", document.toml);
}

/// Names behind blanks stand between tabs, although a few rows were typed with blanks.
#[test]
fn tabs_divide_rows_although_a_few_have_none() {
    let row = |i: usize| match i {
        7 => format!("EU3 N{i}  {}", cells(&xyz(i)).replace(',', " ")),
        _ => format!(
            "EU3 N{i}\t{}\t{}",
            cells(&xyz(i)).replace(',', "\t"),
            if i.is_multiple_of(9) { "DATUM" } else { "" }
        ),
    };
    let text = (0..200).fold(String::new(), |text, i| text + &row(i) + "\n");
    holds(&propose("r.txt", &text), "delimiter = \"tab\"");
}

/// Bones of a motion capture have their own names, and not those of the bones that carry them.
#[test]
fn bones_are_named_by_themselves() {
    for names in [["Sk:Hip", "Sk:LThigh", "Sk:RThigh"], ["763:763", "763:Ab", "763:Neck"]] {
        let of_each =
            |cells: [&str; 3]| cells.iter().map(|cell| [*cell; 7].join(",")).collect::<Vec<String>>().join(",");
        let parts = "Rotation,Rotation,Rotation,Rotation,Position,Position,Position";
        let head = format!(
            "Format Version,1.25,Take Name,t,Length Units,Millimeters\n\n,Type,{}\n,Name,{}\n,ID,{}\n,Parent,{}\n\
             ,,{}\nFrame,Time (Seconds),{}\n",
            of_each(["Bone"; 3]),
            of_each(names),
            of_each(["371E:90A0", "371E:90A1", "371E:90A2"]),
            of_each(["Root", names[0], names[0]]),
            [parts; 3].join(","),
            ["X,Y,Z,W,X,Y,Z"; 3].join(",")
        );
        let pose = |i: usize| {
            let half = 0.05 * i as f64;
            cells(&[&[half.sin(), 0.0, 0.0, half.cos()][..], &xyz(i).map(|v| v + 50.0 * half)].concat())
        };
        let row = |i: usize| format!("{i},{:.3},{},{},{}", 0.01 * i as f64, pose(i), pose(i + 5), pose(2 * i + 9));
        let document = propose("r.csv", &table(&head, row));
        for name in names {
            let target = name.to_lowercase().replace(':', "_");
            holds(&document, &format!("target = \"{target}\""));
        }
    }
}

/// The time that is left until something is no time of the samples.
#[test]
fn a_time_that_is_left_is_no_time() {
    for (name, is_time) in [("TimeToTarget", false), ("time remaining", false), ("time", true)] {
        let row = |i: usize| format!("{},{}", 300 - i, cells(&xyz(i)));
        let document = propose("r.csv", &table(&format!("{name},x_mm,y_mm,z_mm\n"), row));
        assert_eq!(document.toml.contains("time_"), is_time, "{name}: {}", document.toml);
    }
}
