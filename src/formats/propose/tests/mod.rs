//! Proposals for single files.

mod readings;
mod strangers;

use super::*;

#[test]
fn a_sheet_whose_first_row_is_shorter_than_the_others_is_proposed() {
    let text = "4711\t2.0\nP\ta\tb\t1.5\t2.5\t3.5\nQ\ta\tb\t4.5\t5.5\t6.5\n";
    assert_eq!(propose_in("f.xlsx", text, Some("S"), None).document.readings[0].columns.len(), 6);
}

#[test]
fn delimiter_and_decimal_are_proposed_and_the_unit_is_asked() {
    let text = propose("p.txt", "Name;X;Y;Z\nA;1,25;2,5;-3,75\nB;4,125;5,5;6,25\n").toml;
    let stated = "delimiter = \";\", decimal = \",\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\"]";
    assert!(text.contains(stated), "{text}");
    assert!(text.contains("unit = \"?\"") && text.contains("# because 2 of 2 rows have 4 fields"), "{text}");
    let text = propose("p.txt", "1.25 2.5 3.5\n4.5 5.5 6.5\n").toml;
    assert!(text.contains("delimiter = \"blank\", decimal = \".\", columns = [\"x\", \"y\", \"z\"]"), "{text}");
}

#[test]
fn both_halves_of_a_mixed_file_are_proposed() {
    let text = propose(
        "m.csv",
        "pose;target;x_mm;y_mm;z_mm;J1_rad;J2_rad\n1;K;1,5;2,5;3,5;0,1;0,2\n2;K;1,6;2,6;3,6;0,3;0,4\n",
    )
    .toml;
    // joints with other names than q1, q2 may be the joints of a URDF: a table of observations
    assert!(text.contains("[observations]") && text.contains("column 6 `J1_rad` is joint 1"), "{text}");
    assert!(!text.contains("[log]") && !text.contains("pose = \"row\""), "{text}");
    let text = propose("m.csv", "pose;x;y;z\n1;1,5;2,5;3,5\n2;1,6;2,6;3,6\n").toml;
    assert!(text.contains("target = \"?\"") && !text.contains("pose = \"row\""), "{text}");
    let text = propose("m.csv", "target;x;y;z\nK;1,5;2,5;3,5\nL;1,6;2,6;3,6\n").toml;
    assert!(!text.contains("target = \"?\"") && text.contains("pose = \"row\""), "{text}");
}

#[test]
fn joints_beside_orientations_are_a_table_of_observations() {
    let text = propose(
        "m.csv",
        "J1;J2;X;Y;Z;QW;QX;QY;QZ\n0,1;0,2;1,5;2,5;3,5;1,0;0,0;0,0;0,0\n0,3;0,4;1,6;2,6;3,6;0,8;0,6;0,0;0,0\n",
    )
    .toml;
    let columns = "columns = { q1_UNIT = \"J1\", q2_UNIT = \"J2\", x_UNIT = \"X\", y_UNIT = \"Y\", z_UNIT = \"Z\", qw = \"QW\", qx = \"QX\"";
    assert!(text.contains("[observations]") && text.contains(columns) && !text.contains("orientation ="), "{text}");
    let text = propose(
        "m.csv",
        "J1_rad;J2_rad;x_mm;y_mm;z_mm;Rx;Ry;Rz\n0,1;0,2;1,5;2,5;3,5;1,0;0,0;0,0\n0,3;0,4;1,6;2,6;3,6;0,8;0,6;0,0\n",
    )
    .toml;
    assert!(
        text.contains("q1_rad = \"J1_rad\"") && text.contains("x_mm = \"x_mm\"") && text.contains("a_UNIT = \"Rx\""),
        "{text}"
    );
    assert!(text.contains("orientation = \"?\"") && text.contains("decimal = \",\""), "{text}");
}

#[test]
fn four_columns_of_length_one_are_a_quaternion_under_any_headings() {
    let turns = ["0.5,0.5,0.5,-0.5", "0.48,0.6,0.64,0", "0.1,0.7,0.1,0.7", "0.8,0,0.36,0.48"];
    let of = |head: &str, rows: &[&str]| {
        let rows = rows.iter().enumerate().map(|(i, row)| format!("{}.5,{}.25,3.5,{row}\n", 1 + 7 * i, 2 + i * i));
        propose("m.csv", &(format!("X,Y,Z,{head}\n") + &rows.collect::<String>()))
    };
    let asks = |document: &FormatsDocument| {
        document
            .questions
            .iter()
            .any(|question| question.phrase().is_some_and(|phrase| phrase.id == "ask-quaternion-order"))
    };
    for (head, columns) in [
        ("Q0,Qx,Qy,Qz", "\"z\", \"qw\", \"qx\", \"qy\", \"qz\"]"),
        ("e0,e1,e2,e3", "\"z\", \"qw\", \"qx\", \"qy\", \"qz\"]"),
    ] {
        let document = of(head, &turns);
        assert!(document.toml.contains(columns) && !asks(&document), "{head}: {}", document.toml);
    }
    for head in ["ori_x,ori_y,ori_z,ori_s", "q_i,q_j,q_k,q_r", "Quat x,Quat y,Quat z,Quat w"] {
        let document = of(head, &turns);
        let read = document.toml.contains("\"z\", \"qx\", \"qy\", \"qz\", \"qw\"]");
        assert!(read && document.doubts.is_empty() && !asks(&document), "{head}: {}", document.toml);
    }
    assert!(of("q3,q0,q1,q2", &turns).toml.contains("\"z\", \"qz\", \"qw\", \"qx\", \"qy\"]"));
    // nothing names the scalar: a question
    for head in ["A,B,C,D", "q1,q2,q3,q4", "e1,e2,e3,e4"] {
        let document = of(head, &turns);
        assert!(!document.toml.contains("\"qw\"") || asks(&document), "{head}: {}", document.toml);
        assert!(document.toml.contains("\"qw\"") || !document.doubts.is_empty(), "{head}: {}", document.toml);
    }
    // numbers from 1 of another length are joints
    let joints = of("q1,q2,q3,q4", &["0.5,0.5,0.5,-0.4", "0.48,0.6,0.64,0", "0.1,0.7,0.1,0.7", "0.8,0,0.36,0.48"]);
    assert!(joints.toml.contains("q4_UNIT = \"q4\"") && !joints.toml.contains("qw"), "{}", joints.toml);
    // a direction beside an empty column, and numbers of another length
    for (head, rows) in [
        ("nx,ny,nz,k", ["0.6,0.8,0,0", "0.36,0.48,0.8,0", "0,0,1,0", "0.8,0,0.6,0"]),
        ("A,B,C,D", ["0.5,0.5,0.5,-0.4", "0.48,0.6,0.64,0", "0.1,0.7,0.1,0.7", "0.8,0,0.36,0.48"]),
    ] {
        let document = of(head, &rows);
        assert!(!document.toml.contains("qw"), "{}", document.toml);
    }
}

#[test]
fn columns_that_nothing_reads_are_in_doubt() {
    let unread = |text: &str| {
        let document = propose("m.csv", text);
        let mut doubts = document.doubts.iter().filter_map(|doubt| doubt.phrase().cloned());
        doubts.find(|doubt| doubt.id == "doubt-columns-not-read")
    };
    for (text, columns) in [
        ("X,Y,Z,sigma x\n1.5,2.5,3.5,0.1\n4.5,5.5,7.5,0.2\n", vec!["4 `sigma x`"]),
        ("X,Y,Z,Distance\n1.5,2.5,3.5,100.5\n4.5,5.5,7.5,101.5\n", vec!["4 `Distance`"]),
        ("X,Y,Z,Laune\n1.5,2.5,3.5,7.25\n4.5,5.5,7.5,6.25\n", vec!["4 `Laune`"]),
    ] {
        assert_eq!(unread(text), Some(phrase!("doubt-columns-not-read", columns, more = 0)), "{text}");
    }
    let whole = "X,Y,Z,ux,uy,uz,speed\n1.5,2.5,3.5,0.1,0.1,0.2,4.5\n4.5,5.5,7.5,0.2,0.1,0.2,5.5\n";
    assert_eq!(unread(whole), None);
}

#[test]
fn comma_and_comma_is_never_proposed() {
    let text = propose("p.txt", "1,25\t2,50\t3,75\n").toml;
    assert!(text.contains("decimal = \",\""), "{text}");
    assert!(!propose("p.txt", "1,25,2,50,3,75\n").toml.contains("decimal = \",\""));
    assert!(propose("p.txt", "no numbers here\n").toml.contains("no reading"));
}

#[test]
fn the_share_is_one_of_rows() {
    let document = propose("p.txt", "a 1 2 3\nb 4 5 6\nc 7 8\nd 9 10 11\n");
    assert_eq!(document.readings[0].share, 0.75);
    assert!(
        document.doubts.iter().any(|d| d.english().contains("1 row cannot be read in this way; the first is line 3")),
        "{document:?}"
    );
    assert!(document.doubts.iter().any(|d| d.english().contains("no number has a decimal mark")), "{document:?}");
}

#[test]
fn a_log_is_not_an_export() {
    for (text, columns) in [
        (
            "pose,run,RP1,RP2,RP3\n1,1,0.5,3.25,4.5\n",
            "columns = { pose = \"pose\", cycle = \"run\", q1_UNIT = \"RP1\", q2_UNIT",
        ),
        ("1.5 2.5 3.5 4.5 5.5 6.5\n", "columns = { q1_UNIT = 1, q2_UNIT = 2"),
        (
            "timestamp,actual_q_0,actual_q_1\n0.1,0.2,0.3\n",
            "columns = { time_s = \"timestamp\", q1_rad = \"actual_q_0\", q2_rad = \"actual_q_1\" }",
        ),
    ] {
        let toml = propose("l.csv", text).toml;
        assert!(toml.contains("[log]") && !toml.contains("[[export]]") && toml.contains(columns), "{toml}");
    }
    assert!(propose("p.xyz", "1.5 2.5 3.5 0.0 0.6 0.8\n").toml.contains("\"x\", \"y\", \"z\", \"i\", \"j\", \"k\""));
}

#[test]
fn a_log_format_is_recognised_with_its_reason_and_asked_where_the_mark_is_weak() {
    for (text, format, mark) in [
        ("timestamp,actual_q_0\n0.1,0.2\n", "ur_rtde", "RTDE's names of joint positions"),
        ("Timestamp,A1,IPOC\n2024-09-24,1.5,12\n", "kuka_rsi", "`IPOC`"),
        ("%time,field.header.seq,field.position0\n1,2,0.5\n", "ros", "`rostopic echo -p`"),
        ("Name\tscope\nStarttime of export\t132959733843760000\n\nName\tq\n", "twincat", "start of the export"),
    ] {
        let document = propose("l.csv", text);
        assert_eq!(document.format.as_deref(), Some(format), "{document:?}");
        assert!(document.reasons[0].english().contains(mark), "{document:?}");
        assert!(document.toml.contains(&format!("[log]\nfile = \"l.csv\"\nformat = \"{format}\"\n")), "{document:?}");
    }
    let document = propose("l.csv", "one,ten\n0,0\n1,10\n2,20\n,0\n");
    assert_eq!(document.format, None);
    assert!(document.questions.iter().any(|question| question.english().contains("Galil")), "{document:?}");
}

#[test]
fn what_a_mark_means_may_be_in_doubt() {
    let doubts = propose("p.txt", "a;1,250;2,500;3,750\nb;4,125;5,500;6,250\n").doubts;
    assert!(doubts.iter().any(|d| d.english().contains("it may be a thousands mark")), "{doubts:?}");
    let thousands = propose("p.txt", "a;1.234,50;-2.345,25;3,75\nb;4.125,00;5,50;6,25\n").toml;
    assert!(thousands.contains("decimal = \",\", thousands = \".\""), "{thousands}");
}

/// Points of which a few exceed a metre, in every pair of marks; the marks are proposed and x,
/// y and z are found, with one number in groups of three as with many. A text that two pairs of
/// marks read is in doubt.
#[test]
fn groups_of_three_digits_are_proposed_with_their_mark() {
    let rows = |decimal: &str, group: &str, large: usize| -> String {
        let row = |i: usize| {
            let z = if i < large { format!("1{group}0{i:02}{decimal}1369") } else { format!("9{i:02}{decimal}9525") };
            format!("A_{i}_1;-{i}91{decimal}2391;140{decimal}39{i:02};{z}\r\n")
        };
        (10..40).map(row).collect()
    };
    for (decimal, group, key) in [
        (",", ".", "."),
        (".", ",", ","),
        (".", "'", "'"),
        (".", "\u{2019}", "'"),
        (",", "'", "'"),
        (",", " ", " "),
        (",", "\u{a0}", " "),
        (".", "\u{202f}", " "),
    ] {
        for large in [11, 15, 40] {
            let text = format!("\u{feff}Name;X [mm];Y [mm];Z [mm]\r\n{}", rows(decimal, group, large));
            let document = propose("p.csv", text.trim_start_matches('\u{feff}'));
            let wanted = format!("decimal = {decimal:?}, thousands = {key:?}");
            assert!(document.toml.contains(&wanted), "{decimal} {group} {large}: {}", document.toml);
            assert_eq!(document.readings[0].columns, ["label", "x", "y", "z"], "{decimal} {group} {large}");
            assert!(document.doubts.is_empty(), "{decimal} {group} {large}: {:?}", document.doubts);
        }
        let plain = propose("p.csv", &rows(decimal, "", 40));
        assert!(!plain.toml.contains("thousands"), "{}", plain.toml);
    }
    let ambiguous = propose("p.csv", "a;1,234;2,345;3,456\nb;4,567;5,678;6,789\nc;4,367;5,278;6,189\n");
    assert!(
        ambiguous.doubts.iter().any(|d| d.english().contains("it may be a thousands mark")),
        "{:?}",
        ambiguous.doubts
    );
}
