//! Files of strangers: each is read rightly, or its proposal asks.

use super::propose;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::FormatsDocument;
use std::fmt::Write;

/// Three coordinates (mm) of a row.
fn xyz(row: usize) -> [f64; 3] {
    let t = row as f64;
    [1200.0 + 70.0 * (1.3 * t).sin(), -345.0 + 60.0 * (0.7 * t).cos(), 90.9 + 2.3 * t]
}

/// Rows of cells behind a head.
fn table(head: &str, rows: usize, row: impl Fn(usize) -> String) -> String {
    (0..rows).fold(head.to_owned(), |mut text, i| {
        let _ = writeln!(text, "{}", row(i));
        text
    })
}

/// Cells of a row with a point.
fn cells(values: &[f64], separator: &str) -> String {
    values.iter().map(|value| format!("{value:.4}")).collect::<Vec<String>>().join(separator)
}

/// Phrases with this id among doubts or questions.
fn said(document: &FormatsDocument, id: &str) -> Vec<Phrase> {
    let all = document.doubts.iter().chain(&document.questions);
    all.filter_map(|text| text.phrase().cloned()).filter(|phrase| phrase.id == id).collect()
}

fn holds(document: &FormatsDocument, lines: &str) {
    assert!(document.toml.contains(lines), "{lines} is not in\n{}", document.toml);
}

/// Commanded, measured and deviation of a row.
fn compared(row: usize) -> [Vec<f64>; 3] {
    let measured = xyz(row);
    let commanded: Vec<f64> = (0..3).map(|k| measured[k] + 0.4 * ((row + k) as f64).sin()).collect();
    let rounded = |v: f64| (v * 1e4).round() / 1e4;
    let difference = (0..3).map(|k| rounded(measured[k]) - rounded(commanded[k])).collect();
    [commanded, measured.to_vec(), difference]
}

#[test]
fn a_group_above_equal_headings_names_the_columns() {
    for (groups, names) in [
        ("Name,Nominal,,,Actual,,,Deviation,,", ",X,Y,Z,X,Y,Z,X,Y,Z"),
        ("Punkt;Soll;Soll;Soll;Ist;Ist;Ist;Abweichung;Abweichung;Abweichung", "Nr;X;Y;Z;X;Y;Z;X;Y;Z"),
        ("\t設計値\t\t\t測定値\t\t\t偏差\t\t", "点名\tX\tY\tZ\tX\tY\tZ\tX\tY\tZ"),
    ] {
        let separator = if groups.contains(';') {
            ";"
        } else if groups.contains('\t') {
            "\t"
        } else {
            ","
        };
        let text = table(&format!("{groups}\n{names}\n"), 16, |i| {
            format!("K{i}{separator}{}", cells(&compared(i).concat(), separator))
        });
        let document = propose("r.csv", &text);
        assert_eq!(document.toml.matches("\n[[export]]\n").count(), 1, "{}", document.toml);
        holds(&document, "columns = [\"label\", \"-\", \"-\", \"-\", \"x\", \"y\", \"z\", \"-\", \"-\", \"-\"]");
        holds(&document, "header = 2");
    }
}

#[test]
fn equal_headings_without_a_group_are_told_apart_by_their_difference_or_asked() {
    for names in ["Name,X,Y,Z,X,Y,Z,dX,dY,dZ", "Name,X,Y,Z,X,Y,Z,X,Y,Z", "Name,A X,A Y,A Z,B X,B Y,B Z,C X,C Y,C Z"] {
        let text = table(&format!("{names}\n"), 16, |i| format!("K{i},{}", cells(&compared(i).concat(), ",")));
        let document = propose("r.csv", &text);
        assert_eq!(document.toml.matches("\n[[export]]\n").count(), 1, "{}", document.toml);
        holds(&document, "\"-\", \"-\", \"-\", \"x\", \"y\", \"z\", \"-\", \"-\", \"-\"]");
        assert_eq!(said(&document, "doubt-sets-by-difference").len(), 1, "{}", document.toml);
    }
    let text = table("Name,X,Y,Z,X,Y,Z\n", 16, |i| format!("K{i},{}", cells(&compared(i)[..2].concat(), ",")));
    assert_eq!(said(&propose("r.csv", &text), "ask-sets-alike").len(), 1);
    // markers of two names are far from each other
    let apart = |i: usize| cells(&[xyz(i), xyz(i).map(|v| v + 300.0)].concat(), ",");
    let document = propose("r.csv", &table("a_x,a_y,a_z,b_x,b_y,b_z\n", 16, apart));
    assert!(said(&document, "ask-sets-alike").is_empty(), "{}", document.toml);
    holds(&document, "target = \"a\"");
    // the same names: two bodies are not one target
    let document = propose("r.csv", &table("Tx,Ty,Tz,Tx,Ty,Tz\n", 16, apart));
    assert_eq!(document.toml.matches("target = \"?\"").count(), 2, "{}", document.toml);
    assert_eq!(said(&document, "ask-sets-alike").len(), 1);
}

#[test]
fn an_orientation_belongs_to_the_body_that_its_headings_name() {
    let turned = |i: usize| {
        let half = 0.1 * i as f64;
        format!("0,0,{:.8},{:.8}", half.sin(), half.cos())
    };
    let head = "flange_x,flange_y,flange_z,flange_qx,flange_qy,flange_qz,flange_qw,measurement_x,measurement_y,measurement_z\n";
    let row = |i: usize| format!("{},{},{}", cells(&xyz(i).map(|v| v / 1000.0), ","), turned(i), cells(&xyz(i), ","));
    let document = propose("h.csv", &table(head, 16, row));
    holds(&document, "columns = [\"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"x\", \"y\", \"z\"]");
    // each of two bodies has its own
    let head = "a_x,a_y,a_z,a_qx,a_qy,a_qz,a_qw,b_x,b_y,b_z,b_qx,b_qy,b_qz,b_qw\n";
    let row = |i: usize| {
        format!("{},{},{},{}", cells(&xyz(i), ","), turned(i), cells(&xyz(i).map(|v| v + 300.0), ","), turned(i + 3))
    };
    let document = propose("h.csv", &table(head, 16, row));
    holds(&document, "x = \"a_x\", y = \"a_y\", z = \"a_z\", qw = \"a_qw\", qx = \"a_qx\"");
    holds(&document, "x = \"b_x\", y = \"b_y\", z = \"b_z\", qw = \"b_qw\", qx = \"b_qx\"");
    // of equal headings those next to the coordinates
    let head = "Q0,Qx,Qy,Qz,Tx,Ty,Tz,Q0,Qx,Qy,Qz,Tx,Ty,Tz\n";
    let first = |i: usize| turned(i).split(',').rev().map(str::to_owned).collect::<Vec<String>>().join(",");
    let row = |i: usize| {
        format!("{},{},{},{}", first(i), cells(&xyz(i), ","), first(i + 3), cells(&xyz(i).map(|v| v + 300.0), ","))
    };
    let document = propose("h.csv", &table(head, 16, row));
    holds(&document, "x = 5, y = 6, z = 7, qw = 1, qx = 2, qy = 3, qz = 4");
    holds(&document, "x = 12, y = 13, z = 14, qw = 8, qx = 9, qy = 10, qz = 11");
    // an orientation of an unnamed body is that of the only point
    let head = "pos_x,pos_y,pos_z,rot_x,rot_y,rot_z,rot_w\n";
    let document = propose("h.csv", &table(head, 16, |i| format!("{},{}", cells(&xyz(i), ","), turned(i))));
    holds(&document, "columns = [\"x\", \"y\", \"z\", \"qx\", \"qy\", \"qz\", \"qw\"]");
}

#[test]
fn coordinates_of_the_flange_may_be_computed() {
    for (name, doubts) in [("flange", 1), ("measured_flange", 0), ("reflector", 0)] {
        let head = format!("{name}_x,{name}_y,{name}_z\n");
        let document = propose("p.csv", &table(&head, 16, |i| cells(&xyz(i), ",")));
        assert_eq!(said(&document, "doubt-controller-pose").len(), doubts, "{}", document.toml);
    }
}

#[test]
fn a_running_number_with_gaps_names_the_pose_as_a_question() {
    let numbers = [1, 2, 3, 4, 5, 8, 9, 10, 11, 13, 14, 15, 16];
    for (head, separator, column) in
        [("", " ", "column 1"), ("Nr;X;Y;Z\n", ";", "`Nr`"), ("index,x,y,z\n", ",", "`index`")]
    {
        let row = |i: usize| format!("{}{separator}{}", numbers[i], cells(&xyz(i), separator));
        let document = propose("p.txt", &table(head, 13, row));
        holds(&document, "columns = [\"pose\", \"x\", \"y\", \"z\"]");
        assert!(!document.toml.contains("pose = \"row\""), "{}", document.toml);
        let asked = phrase!("ask-number-with-gaps", column, before = 5.0, after = 8.0);
        assert_eq!(said(&document, "ask-number-with-gaps"), [asked]);
        let whole =
            propose("p.txt", &table(head, 13, |i| format!("{}{separator}{}", i + 1, cells(&xyz(i), separator))));
        // a heading for a number says the same
        let (role, by_row) = if head.is_empty() { ("-", true) } else { ("pose", false) };
        assert_eq!(whole.toml.contains("pose = \"row\""), by_row, "{}", whole.toml);
        assert!(whole.toml.contains(&format!("[\"{role}\", \"x\"")), "{}", whole.toml);
    }
}

#[test]
fn a_clock_has_a_unit_by_its_size_or_step_or_is_asked_for() {
    let of = |heading: &str, times: &dyn Fn(usize) -> String| {
        let head = format!("{heading},X,Y,Z\n");
        propose("t.csv", &table(&head, 16, |i| format!("{},{}", times(i), cells(&xyz(i), ","))))
    };
    holds(&of("Timestamp", &|i| format!("{}", 1_764_342_000_000u64 + 10 * i as u64)), "[\"time_ms\", \"x\"");
    holds(&of("stamp", &|i| format!("{}", 1_764_342_000_000_000u64 + 10 * i as u64)), "[\"time_us\", \"x\"");
    holds(&of("stamp", &|i| format!("{}", 1_764_342_000_000_000_000u64 + 1000 * i as u64)), "[\"time_ns\", \"x\"");
    holds(&of("time", &|i| format!("{:.3}", 1_764_342_000.0 + 0.01 * i as f64)), "[\"time_s\", \"x\"");
    holds(&of("time", &|i| format!("{:.3}", 0.004 * i as f64)), "[\"time_s\", \"x\"");
    holds(&of("time [ms]", &|i| format!("{}", 4 * i)), "[\"time_ms\", \"x\"");
    for open in
        [of("time", &|i| format!("{}", 4 * i)), of("Timestamp", &|i| format!("{:.1}", 1000.5 + 12.5 * i as f64))]
    {
        assert_eq!(said(&open, "ask-time-unit").len(), 1, "{}", open.toml);
        holds(&open, "[\"time_UNIT\", \"x\"");
    }
}

#[test]
fn grad_is_gon_above_360_and_otherwise_a_question() {
    let of = |first: f64| {
        let row = |i: usize| format!("{i};{:.6};{:.6};{:.7}", first + 0.1 * i as f64, 95.5 - 0.1 * i as f64, 1.3);
        propose("p.csv", &table("Point;Hz [grad];Vz [grad];Dist [m]\n", 16, row))
    };
    let document = of(380.0);
    holds(&document, "angle_unit = \"gon\"");
    holds(&document, "unit = \"m\"");
    let document = of(120.0);
    assert!(
        !document.toml.contains("angle_unit =") && said(&document, "ask-angle-unit").len() == 1,
        "{}",
        document.toml
    );
}

#[test]
fn rows_of_units_and_units_in_words_state_the_unit() {
    let row = |i: usize| format!("K{i},{}", cells(&xyz(i), ","));
    for head in ["Name,X,Y,Z\n,mm,mm,mm\n", "Name,X,Y,Z\n-,[mm],[mm],[mm]\n", "Name,X,Y,Z\nUnit,(mm),(mm),(mm)\n"] {
        let document = propose("p.csv", &table(head, 16, row));
        holds(&document, "header = 2, columns = [\"label\", \"x\", \"y\", \"z\"]");
        holds(&document, "unit = \"mm\"");
    }
    for head in
        ["# units: mm\nName,X,Y,Z\n", "Length Units,Millimeters\nName,X,Y,Z\n", "# all coordinates in mm\nName,X,Y,Z\n"]
    {
        holds(&propose("p.csv", &table(head, 16, row)), "unit = \"mm\"");
    }
    let two = propose("p.csv", &table("# units: mm\n# unit = m\nName,X,Y,Z\n", 16, row));
    assert!(two.toml.contains("unit = \"?\"") && said(&two, "doubt-units-differ").len() == 1, "{}", two.toml);
}

#[test]
fn rows_with_numbers_above_the_headings_do_not_hide_them() {
    let turned = |i: usize| format!("0,0,{:.6},{:.6}", (0.01 * i as f64).sin(), (0.01 * i as f64).cos());
    let motive = "Format Version,1.23,Take Name,Take 1,Capture Frame Rate,120.000000,Rotation Type,Quaternion,Length Units,Meters\n\n\
        ,Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body\n\
        ,Name,ball,ball,ball,ball,ball,ball,ball\n,ID,\"D0EC\",\"D0EC\",\"D0EC\",\"D0EC\",\"D0EC\",\"D0EC\",\"D0EC\"\n\
        ,,Rotation,Rotation,Rotation,Rotation,Position,Position,Position\nFrame,Time (Seconds),X,Y,Z,W,X,Y,Z\n";
    let row =
        |i: usize| format!("{i},{:.6},{},{}", i as f64 / 120.0, turned(i), cells(&xyz(i).map(|v| v / 1000.0), ","));
    let document = propose("take.csv", &table(motive, 16, row));
    holds(&document, "header = 6, columns = [\"-\", \"time_s\", \"qx\", \"qy\", \"qz\", \"qw\", \"x\", \"y\", \"z\"]");
    holds(&document, "unit = \"m\"");

    let two = "Format Version,1.23,Length Units,Millimeters\n,Name,A,A,A,A,A,A,A,B,B,B,B,B,B,B\n\
        ,,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Rotation,Rotation,Rotation,Rotation,Position,Position,Position\n\
        Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z,W,X,Y,Z\n";
    let row = |i: usize| {
        let apart = cells(&xyz(3 * i).map(|v| v + 500.0), ",");
        format!("{i},{:.6},{},{},{},{apart}", i as f64 / 120.0, turned(i), cells(&xyz(i), ","), turned(i + 4))
    };
    let document = propose("take.csv", &table(two, 16, row));
    holds(&document, "x = 7, y = 8, z = 9, qw = 6, qx = 3, qy = 4, qz = 5, time_s = \"Time (Seconds)\"");
    holds(&document, "x = 14, y = 15, z = 16, qw = 13, qx = 10, qy = 11, qz = 12");
    holds(&document, "target = \"b\"");
    assert!(said(&document, "doubt-columns-not-read").is_empty(), "{}", document.toml);

    // numbers above that look like the data
    let row = |i: usize| format!("K{i},{}", cells(&xyz(i), ","));
    let document = propose("p.csv", &table("Serial,12,34,56\nName,X,Y,Z\n", 16, row));
    holds(&document, "header = 2, columns = [\"label\", \"x\", \"y\", \"z\"]");

    let trc = "PathFileType\t4\t(X/Y/Z)\twalk.trc\n\
        DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames\n\
        100.00\t100.00\t16\t2\tmm\t100.00\t1\t16\nFrame#\tTime\tKnee\t\t\tHip\t\t\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n";
    let row = |i: usize| {
        format!(
            "{}\t{:.3}\t{}\t{}",
            i + 1,
            0.01 * i as f64,
            cells(&xyz(i), "\t"),
            cells(&xyz(i).map(|v| v + 90.0), "\t")
        )
    };
    let document = propose("walk.trc", &table(trc, 16, row));
    assert_eq!(document.toml.matches("\n[[export]]\n").count(), 2, "{}", document.toml);
    holds(&document, "time_s = 2");
    holds(&document, "target = \"Knee\"");
    holds(&document, "unit = \"mm\"");

    let vicon = "Trajectories\n100\n,,Subject:Knee,,,Subject:Hip,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n";
    let row = |i: usize| format!("{},0,{},{}", i + 1, cells(&xyz(i), ","), cells(&xyz(i).map(|v| v + 90.0), ","));
    let document = propose("trial.csv", &table(vicon, 16, row));
    assert_eq!(document.toml.matches("\n[[export]]\n").count(), 2, "{}", document.toml);
    holds(&document, "target = \"Subject:Knee\"");
    holds(&document, "x = 6, y = 7, z = 8");
    holds(&document, "unit = \"mm\"");
}

#[test]
fn headings_in_a_comment_above_a_count_name_the_columns() {
    let row = |i: usize| {
        let (s, c) = (0.06 * i as f64).sin_cos();
        format!("{} 0.00{i:02} {s:.6} {c:.6} 0.00{i:02}", cells(&xyz(i), " "))
    };
    let document = propose("c.asc", &table("//X Y Z Scalar_field Nx Ny Nz\n16\n", 16, row));
    holds(&document, "columns = [\"x\", \"y\", \"z\", \"-\", \"i\", \"j\", \"k\"]");
    assert!(said(&document, "ask-quaternion-order").is_empty(), "{}", document.toml);
}

#[test]
fn colours_of_a_scan_are_no_joints() {
    for intensity in [" -1020", ""] {
        let row = |i: usize| format!("{}{intensity} {} 59 38", cells(&xyz(i), " "), 90 + i);
        let document = propose("c.pts", &table("16\n", 16, row));
        holds(&document, "columns = [\"x\", \"y\", \"z\", \"-\", \"-\"");
        assert!(document.kind == "export" && said(&document, "doubt-scanned").len() == 1, "{}", document.toml);
    }
}

#[test]
fn northing_and_easting_are_y_and_x_and_the_elevation_beside_them_is_a_height() {
    let row = |i: usize| {
        let [x, y, z] = xyz(i);
        format!("{i},{},BALL", cells(&[y, x, z], ","))
    };
    for head in ["Point,Northing,Easting,Elevation,Code\n", "Punkt,Hochwert,Rechtswert,Höhe,Code\n", "ID,N,E,Z,Code\n"]
    {
        let document = propose("s.csv", &table(head, 16, row));
        holds(&document, "columns = [\"label\", \"y\", \"x\", \"z\", \"-\"]");
    }
}

/// Headings of a tracker with a letter behind the component for each of its tools, and a tool that
/// it does not see in the first rows.
#[test]
fn a_letter_behind_the_components_names_the_tool() {
    let head = "Sample:,ms,Xa,Ya,Za,qoa,qxa,qya,qza,Xb,Yb,Zb,qob,qxb,qyb,qzb\n";
    let turned = |row: usize| {
        let half = 0.05 * row as f64;
        [half.cos(), 0.0, half.sin(), 0.0]
    };
    let text = table(head, 16, |i| {
        let [b, moved] = [xyz(i), xyz(i + 3)].map(|point| [&point[..], &turned(i)].concat());
        let a = if i < 2 { vec![0.0; 7] } else { moved };
        format!("{},{},{},{}", i + 1, 40 * i, cells(&a, ","), cells(&b, ","))
    });
    let document = propose("ndi.csv", &text);
    assert_eq!(document.toml.matches("\n[[export]]\n").count(), 2, "{}", document.toml);
    for (target, columns) in [
        ("body_a", "x = \"Xa\", y = \"Ya\", z = \"Za\", qw = \"qoa\", qx = \"qxa\""),
        ("body_b", "x = \"Xb\", y = \"Yb\", z = \"Zb\", qw = \"qob\", qx = \"qxb\""),
    ] {
        holds(&document, &format!("target = \"{target}\""));
        holds(&document, columns);
    }
    // one letter alone names nothing
    let text = table("Xa,Ya,Za\n", 16, |i| cells(&xyz(i), ","));
    assert!(!propose("a.csv", &text).toml.contains("body_a"));
}

#[test]
fn coordinates_of_a_part_of_an_arm_are_no_joints() {
    for head in [
        "Frame,Elbow X,Elbow Y,Elbow Z,Right Wrist X,Right Wrist Y,Right Wrist Z\n",
        "Frame,,,Elbow,,,Right Wrist,,\n,Elbow X,Elbow Y,Elbow Z,Right Wrist X,Right Wrist Y,Right Wrist Z\n",
    ] {
        let text = table(head, 16, |i| format!("{i},{},{}", cells(&xyz(i), ","), cells(&xyz(i + 5), ",")));
        let document = propose("m.csv", &text);
        assert!(!document.toml.contains("joints ="), "{}", document.toml);
        assert_eq!(document.toml.matches("\n[[export]]\n").count(), 2, "{}", document.toml);
        holds(&document, "target = \"right_wrist\"");
    }
    // a word of joints makes them joints
    let text = table("Wrist joint X,Wrist joint Y,Wrist joint Z\n", 16, |i| cells(&xyz(i), ","));
    assert!(propose("m.csv", &text).toml.contains("[log]"));
}

#[test]
fn joints_of_two_parts_are_one_chain() {
    let head = "x1,y1,z1,torso_1_joint,torso_2_joint,arm_1_joint,arm_2_joint,arm_3_joint\n";
    let angles = |i: usize| (0..5).map(|k| (0.3 * (i + k) as f64).sin()).collect::<Vec<f64>>();
    let text = table(head, 16, |i| format!("{},{}", cells(&xyz(i), ","), cells(&angles(i), ",")));
    let document = propose("t.csv", &text);
    holds(&document, "q2_UNIT = \"torso_2_joint\", q3_UNIT = \"arm_1_joint\"");
    holds(&document, "q5_UNIT = \"arm_3_joint\"");
    assert!(said(&document, "doubt-two-families").is_empty(), "{}", document.toml);
    // the same numbers twice: commanded and measured
    let head = "actual_q_1,actual_q_2,actual_q_3,target_q_1,target_q_2\n";
    let text = table(head, 16, |i| cells(&angles(i), ","));
    assert!(!propose("t.csv", &text).toml.contains("q4_UNIT"));
}

#[test]
fn angles_with_the_number_of_the_point_are_its_orientation() {
    let head = "x1,y1,z1,phix1,phiy1,phiz1,q_1,q_2,q_3\n";
    let angles = |i: usize| (0..6).map(|k| (0.3 * (i + 2 * k) as f64).sin()).collect::<Vec<f64>>();
    let text = table(head, 16, |i| format!("{},{}", cells(&xyz(i), ","), cells(&angles(i), ",")));
    let document = propose("m.csv", &text);
    holds(&document, "a_UNIT = \"phix1\", b_UNIT = \"phiy1\", c_UNIT = \"phiz1\"");
    assert_eq!(said(&document, "ask-rotation").len(), 1, "{}", document.toml);
}

#[test]
fn many_numbers_without_headings_are_points_of_a_row_as_a_question() {
    let row = |i: usize| {
        let points: Vec<f64> = (0..12).flat_map(|k| xyz(i + 3 * k)).collect();
        format!("{},0,{}", i + 1, cells(&points, ","))
    };
    let document = propose("m.csv", &table("", 16, row));
    assert_eq!(document.toml.matches("\n[[export]]\n").count(), 12, "{}", document.toml);
    holds(&document, "columns = { x = 3, y = 4, z = 5 }");
    holds(&document, "target = \"marker_12\"");
    let asked = said(&document, "ask-points-in-row");
    assert_eq!(asked, [phrase!("ask-points-in-row", count = 12, numbers = 36)], "{}", document.toml);
    // one row alone shows nothing
    let document = propose("m.csv", &(cells(&[1.5; 435], ", ") + "\n"));
    assert!(!document.toml.contains("[[export]]"), "{}", document.toml);
    assert_eq!(said(&document, "doubt-one-row"), [phrase!("doubt-one-row", count = 435)]);
}

/// A file of markers that a spreadsheet has saved: its empty row has a comma for each column.
#[test]
fn a_row_of_delimiters_below_the_headings_hides_nothing() {
    let head = "PathFileType,4,(X/Y/Z),a.trc,,,,\n\
        DataRate,CameraRate,NumFrames,NumMarkers,Units,OrigDataRate,,\n\
        100,100,16,2,mm,100,,\n\
        Frame#,Time,ASIS1,,,STER1,,\n\
        ,,X1,Y1,Z1,X2,Y2,Z2\n\
        ,,,,,,,\n";
    let text = table(head, 16, |i| {
        format!("{},{:.2},{},{}", i + 1, 0.01 * i as f64, cells(&xyz(i), ","), cells(&xyz(i + 5), ","))
    });
    let document = propose("a.trc", &text);
    holds(&document, "columns = { x = 3, y = 4, z = 5, time_s = 2 }");
    holds(&document, "target = \"STER1\"");
    holds(&document, "unit = \"mm\"                # the file states it");
}

/// Three angles of a measured body are columns of the export; their order and a unit that the file
/// does not contain are questions.
#[test]
fn measured_angles_are_read_and_their_order_is_asked() {
    for (head, columns) in [
        ("X [mm];Y [mm];Z [mm];A [deg];B [deg];C [deg]", "\"x\", \"y\", \"z\", \"rx_deg\", \"ry_deg\", \"rz_deg\""),
        ("X [mm];Y [mm];Z [mm];Rx [rad];Ry [rad];Rz [rad]", "\"x\", \"y\", \"z\", \"rx_rad\", \"ry_rad\", \"rz_rad\""),
        ("X;Y;Z;roll;pitch;yaw", "\"x\", \"y\", \"z\", \"rx_UNIT\", \"ry_UNIT\", \"rz_UNIT\""),
    ] {
        let text = table(&format!("{head}\n"), 16, |i| {
            format!("{};{}", cells(&xyz(i), ";"), cells(&[0.1 * i as f64, 0.5, -0.2], ";"))
        });
        let document = propose("p.csv", &text);
        holds(&document, &format!("columns = [{columns}]"));
        holds(&document, "rotation = \"?\", ");
        assert!(!said(&document, "ask-rotation").is_empty(), "{}", document.toml);
        assert_eq!(said(&document, "doubt-columns-not-read"), [], "{}", document.toml);
    }
}

/// East, north and height in the words of several languages, in the order of the file.
#[test]
fn axes_of_surveys_are_known_in_several_languages() {
    for (head, axes) in [
        ("Punkt;Ost;Nord;Höhe", ["x", "y", "z"]),
        ("Name;Nordwert;Ostwert;Höhe ü. NN", ["y", "x", "z"]),
        ("Pkt;Rechtswert [m];Hochwert [m];Höhe [m]", ["x", "y", "z"]),
        ("Point;Abscisse;Ordonnée;Cote", ["x", "y", "z"]),
        ("Punto;Este;Norte;Cota", ["x", "y", "z"]),
        ("PointID;N [m];E [m];Hgt [m]", ["y", "x", "z"]),
        ("点号;X坐标(m);Y坐标(m);高程(m)", ["x", "y", "z"]),
        ("測点名;Ｘ座標;Ｙ座標;標高", ["x", "y", "z"]),
        ("点名;北;东;高", ["y", "x", "z"]),
    ] {
        let document = propose("s.csv", &table(&format!("{head}\n"), 16, |i| format!("K{i};{}", cells(&xyz(i), ";"))));
        let columns: Vec<String> = ["label"].iter().chain(&axes).map(|name| format!("\"{name}\"")).collect();
        holds(&document, &format!("columns = [{}]", columns.join(", ")));
    }
}

/// Lists in brackets that the delimiter divides, and matrices in blocks, are no rows of points.
#[test]
fn numbers_within_brackets_are_no_columns() {
    let rows = [
        ("Print1=[[100.5,200.25,300.5],[1,0,0,0]]", "robot"),
        ("LOCAL VAR jointtarget j1 = j:{2.5,29.5,6.25,34.5,-47.5,35.5 ,0 } {EJ 0,0,0,0,0,0}", "controller"),
        ("[1.5, 2.5, 3.5, 4.5, 5.5, 6.5]", "program"),
        ("[1.5, 2.5, 3.5, 4.5, 5.5, 6.5;", "MATLAB"),
    ];
    for (row, who) in rows {
        let document = propose("p.txt", &table("", 8, |_| row.to_owned()));
        assert!(document.readings.is_empty() && !document.toml.contains("[[export]]"), "{who}: {}", document.toml);
    }
    // a list behind the coordinates does not hide them
    let document = propose("p.txt", &table("X;Y;Z;list\n", 8, |i| format!("{};(1.5, 2.5)", cells(&xyz(i), ";"))));
    holds(&document, "\"x\", \"y\", \"z\", \"-\"");
}

/// A text between the numbers divides them, a time of 1970 stands in front, and rows with several
/// targets have labels of poses.
#[test]
fn numbers_without_headings_are_no_joints_if_a_text_divides_them() {
    let row = |i: usize| format!("{},{},{},revolute,0", 1 + i / 8, cells(&xyz(i), ","), 36 * i);
    let document = propose("l.csv", &table("", 16, row));
    assert!(!document.toml.contains("[log]"), "{}", document.toml);
    holds(&document, "columns = [\"-\", \"x\", \"y\", \"z\", \"-\", \"-\", \"-\"]");
    let row = |i: usize| {
        let q = cells(&[0.5, 0.5, 0.5, 0.5], ", ");
        format!("{:.2}, {}, {q}", 1491754390.48 + 0.01 * (i / 2) as f64, cells(&xyz(i), ", "))
    };
    let document = propose("v.csv", &table("", 40, row));
    holds(&document, "columns = [\"time_s\", \"x\", \"y\", \"z\", \"qx\", \"qy\", \"qz\", \"qw\"]");
    let row = |i: usize| format!("{i}.jpg,{},{}", cells(&xyz(i)[..2], ","), cells(&xyz(i + 9)[..2], ","));
    let document = propose("m.csv", &table("image,silver_x,silver_y,white_x,white_y\n", 16, row));
    for target in ["silver", "white"] {
        holds(&document, &format!("target = \"{target}\""));
    }
    assert_eq!(document.toml.matches("label = \"{pose}\"").count(), 2, "{}", document.toml);
}

/// Numbers without headings that nearly agree with the first three may be the measured ones.
#[test]
fn copies_of_a_point_without_headings_are_asked() {
    let row = |i: usize| {
        let near = xyz(i).map(|v| v + 0.1 * (3.0 * i as f64).sin());
        format!("M{i} {} 1.5 -20.5 {} {} 1.5 -20.5 {}", cells(&xyz(i), " "), 3 * i, cells(&near, " "), 3 * i)
    };
    let document = propose("l.txt", &table("", 16, row));
    let asked = phrase!("ask-sets-alike", first = vec![2, 3, 4], second = vec![8, 9, 10]);
    assert_eq!(said(&document, "ask-sets-alike"), [asked], "{}", document.toml);
}

/// Centimetres are a unit as others are.
#[test]
fn centimetres_are_a_unit() {
    let document = propose("c.csv", &table("x (cm),y (cm),z (cm)\n", 16, |i| cells(&xyz(i), ",")));
    holds(&document, "unit = \"cm\"                # the file states it");
}

/// Records of total stations are named.
#[test]
fn records_of_total_stations_are_named() {
    for (text, kind) in [
        ("00NMSDR33  V04-04.34    30-11-15 09:47 111121\n10NMtemp            121111\n", "sdr33"),
        ("For M5|Adr 00001|TI  KN STAT                    |\nFor M5|Adr 00002|PI1           A\n", "m5"),
    ] {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), text).unwrap();
        let refused = super::propose_file(file.path()).unwrap_err();
        assert!(refused.0[0].is("file-without-points", &[("kind", &kind)]), "{refused}");
    }
}

/// Poses in four rows each are refused: each row would be a point.
#[test]
fn matrices_in_blocks_are_refused() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let matrix = |i: usize| format!("1,0,0,{}\n0,1,0,{}\n0,0,1,{}\n0,0,0,1", xyz(i)[0], xyz(i)[1], xyz(i)[2]);
    std::fs::write(file.path(), table("", 6, matrix)).unwrap();
    let refused = super::propose_file(file.path()).unwrap_err();
    assert!(refused.0[0].is("matrices-in-blocks", &[]), "{refused}");
}
