//! Damaged, ambiguous and hostile exports of formats with a reader of their own: an error with its place and a hint, all of
//! them in one go, never a panic, never more memory or time than the file is worth. All texts are synthetic.

use crate::support::said::Says;
use etalon::base::pose::Vector;
use etalon::formats::Format;
use etalon::formats::dialect::Unit;
use etalon::formats::labelled_points;
use std::time::Instant;

fn read(name: &str, text: &str, unit: Unit) -> Result<Vec<(String, Vector)>, String> {
    let format = Format::named(name).unwrap_or_else(|| panic!("{name}"));
    labelled_points("f.txt", text, &format, unit).map_err(|e| e.to_string())
}

fn mm(name: &str, text: &str) -> Vec<(String, Vector)> {
    read(name, text, Unit::Millimetre).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn refused(name: &str, text: &str, parts: &[&str]) {
    let said = read(name, text, Unit::Millimetre).expect_err(name);
    for part in parts {
        assert!(said.says(part), "{name}: {part:?} is not said:\n{said}");
    }
    assert!(said.len() < 20_000, "{} bytes of message", said.len());
}

fn p(label: &str, xyz: Vector) -> (String, Vector) {
    (label.to_owned(), xyz)
}

const REPORT: &str = "Part: bracket\nDate: 2026-01-01\nName,Control,Nom,Meas,Tol,Dev,Test,Out Tol\n\
                      A,X,1.000,1.002,±2.000,0.002,Pass,\nA,Y,2.000,1.998,±2.000,-0.002,Pass,\n\
                      A,Diameter,5.000,5.001,+0.5/-0.2,0.001,Pass,\nA,Z,3.000,3.500,±0.100,0.500,Fail,0.400\n\
                      B,Surface Point X,4.0,4.5,±1.0,0.5,Pass,\nB,Surface Point Y,5.0,5.5,±1.0,0.5,Pass,\n\
                      B,Surface Point Z,6.0,6.5,±1.0,0.5,Pass,\n";

#[test]
fn a_report_with_a_row_for_each_control_becomes_points_by_name() {
    assert_eq!(mm("polyworks_report", REPORT), [p("A", [1.002, 1.998, 3.5]), p("B", [4.5, 5.5, 6.5])]);
    let semicolons: String = REPORT.replace(',', ";").replace('.', ",");
    assert_eq!(mm("polyworks_report, decimal comma", &semicolons), mm("polyworks_report", REPORT));
    // a second X of the same name is the next piece
    let pieces = format!("{REPORT}A,X,1,1.1,±1,0,Pass,\nA,Y,2,2.2,±1,0,Pass,\nA,Z,3,3.3,±1,0,Pass,\n");
    assert_eq!(mm("polyworks_report", &pieces)[2], p("A", [1.1, 2.2, 3.3]));
}

#[test]
fn trap_1_a_tolerance_in_another_encoding_is_told() {
    let wrong = REPORT.replacen("±2.000", "Â±2.000", 1);
    refused("polyworks_report", &wrong, &["[record-invalid]", "`Â±2.000`", "f.txt:4:17", "a wrong encoding"]);
}

#[test]
fn all_that_is_wrong_in_a_report_is_told_at_once() {
    let wrong = REPORT.replace("1.002", "1,002").replace("3.500", "3.5x0").replace("6.5", "6.5.1");
    let said = read("polyworks_report", &wrong, Unit::Millimetre).unwrap_err();
    for part in ["f.txt:4", "f.txt:7:", "f.txt:10:", "[not-a-number]: `3.5x0`", "[not-a-number]: `6.5.1`"] {
        assert!(said.says(part), "{part}:\n{said}");
    }
    refused("polyworks_report", "no report\n", &["[format-differs]", "`polyworks_report`", "`Control`"]);
}

const CHR: &str = "planid\tpartnb\tid\tidsymbol\tactual\tnominal\tfeatureid\tunit\tgroup1\tgroup2\t\n\
                   P\t1\tA_X\txValue\t1.5\t0\tA\tmm\n\
                   P\t1\tA_Y\tyValue\t2.5\t0\tA\tmm\tg\n\
                   P\t1\tA_Z\tzValue\t-3.5\t0\tA\tmm\tg\th\n\
                   P\t1\tA_D\tdiameter\t9.0\t0\tA\tmm\n\
                   P\t2\tA_X\txValue\t1.6\t0\tA\tmm\nP\t2\tA_Y\tyValue\t2.6\t0\tA\tmm\nP\t2\tA_Z\tzValue\t-3.6\t0\tA\tmm\nEND\n";

#[test]
fn trap_10_rows_of_calypso_are_ragged_and_end_in_a_word() {
    let expected = [p("A", [1.5, 2.5, -3.5]), p("A", [1.6, 2.6, -3.6])];
    assert_eq!(mm("calypso", CHR), expected);
    assert_eq!(mm("calypso", &CHR.replace('\n', "\r\n")), expected);
    assert_eq!(mm("calypso, decimal comma", &CHR.replace('.', ",")), expected);
    // the columns in another order, one more among them
    let turned: String = CHR
        .lines()
        .map(|line| {
            let mut fields: Vec<&str> = line.split('\t').collect();
            if fields.len() > 1 {
                fields.resize(11, "");
                fields.reverse();
                fields.insert(3, if line.starts_with("planid") { "mine" } else { "7" });
            }
            fields.join("\t") + "\n"
        })
        .collect();
    assert_eq!(mm("calypso", &turned), expected);
    refused(
        "calypso",
        &CHR.replace("\tmm\tg\n", "\tmm\tg\th\ti\tj\n"),
        &["[row-field-count]", "12 fields", "expected: 11", "f.txt:3"],
    );
    refused("calypso", &format!("{CHR}P\t3\n"), &["[rows-after-end]", "`END`", "f.txt:10"]);
    refused(
        "calypso",
        &CHR.replace("1.5", "1,5").replace("2.6", "zwei"),
        &["[not-a-number]: `1,5`", "f.txt:2:16", "\"calypso, decimal comma\"", "[not-a-number]: `zwei`", "f.txt:7:16"],
    );
    refused("calypso", &CHR.replace("-3.5\t0\tA\tmm", "-3.5\t0\tA\tdeg"), &["[unit-unknown]: `deg`", "f.txt:4:"]);
}

#[test]
fn the_head_of_a_calypso_run_names_its_unit_and_temperature_and_holds_no_points() {
    let names = "planid\tpartnb\tdate\tlengthunit\ttemperatureworkpiece\n";
    let parts = ["[no-measured-points]", "`mm`", "21.4 °C", "`_chr`"];
    refused("calypso", &format!("{names}P\t1\t2026-01-01\tmm\t21.4\nEND\n"), &parts);
    refused("calypso", "a\tb\n1\t2\n", &["[format-differs]", "`calypso`", "f.txt:1"]);
    let features = "planid\tfeatureid\tx\ty\tz\nP\tA\t1\t2\t3\nP\tB\t\t\t\nEND\n";
    assert_eq!(mm("calypso", features)[0], p("A", [1.0, 2.0, 3.0]));
}

/// Three characteristics by their names and a diameter; pieces as K fields and as rows without keys.
const AQDEF: &str = "K0100 4\nK1001 Plate\nK2004/0 0\nK2142/0 mm\nK2002/1 Ball 1.X\nK2002/2 Ball 1.Y\nK2001/3 Ball 1_z\nK2002/4 Ball 1.D\n\
                     K0001/1 1.5\nK0001/2 2.5\nK0001/3 -3.5\nK0001/4 25.4\nK0004/0 15.02.2024/07:46:31\n\
                     1.6\u{14}0\u{14}15.02.2024/07:46:32\u{f}2.6\u{14}0\u{f}-3.6\u{f}25.4\n";

/// A positional tolerance in space and its three coordinates, as elements of a group.
const AQDEF_GROUP: &str = "K0100 4\nK1002 Teil\nK2002/1 K1_7_1\nK2004/1 0\nK2008/1 10\nK2002/2 X-Achse\nK2002/3 Y-Achse\n\
                           K2002/4 Z-Achse\nK5111/1 1\nK5112/2 1\nK5103/1 2\nK5102/2 2\nK5102/2 3\nK5102/2 4\nK0001/1 0\nK0002/1 256\n\
                           K0001/2 10,023\nK0001/3 15,986\nK0001/4 20,006\n";

#[test]
fn coordinates_of_a_q_das_file_are_points_by_name_or_group_and_piece() {
    let expected = [p("Ball 1", [1.5, 2.5, -3.5]), p("Ball 1", [1.6, 2.6, -3.6])];
    assert_eq!(mm("aqdef", AQDEF), expected);
    assert_eq!(mm("aqdef", &AQDEF.replace('\n', "\r\n")), expected);
    let (head, values) = AQDEF.split_at(AQDEF.find("K0001").unwrap());
    assert_eq!(mm("aqdef, decimal comma", &(head.to_owned() + &values.replace('.', ","))), expected);
    let group = [p("K1_7_1", [10.023, 15.986, 20.006])];
    assert_eq!(mm("aqdef, decimal comma", AQDEF_GROUP), group);
    let simple: String =
        AQDEF_GROUP.lines().filter(|line| !line.starts_with("K5")).map(|line| format!("{line}\n")).collect();
    let simple = simple.replace("K2008/1 10\n", "K2008/1 10\nK2030/1 1\nK2031/2 1\nK2031/3 1\nK2031/4 1\n");
    assert_eq!(mm("aqdef, decimal comma", &simple), group);
    // characteristics have nodes of their own below that of the group
    let nodes = "K5103/2 3\nK5103/2 4\nK5103/2 5\nK5112/3 2\nK5112/4 3\nK5112/5 4\nK5102/3 2\nK5102/4 3\nK5102/5 4\n";
    let own = AQDEF_GROUP.replace("K5102/2 2\nK5102/2 3\nK5102/2 4\n", nodes);
    assert_eq!(mm("aqdef, decimal comma", &own), group);
}

#[test]
fn values_of_a_q_das_file_that_do_not_count_are_no_points() {
    // deleted, or a row without it: the piece has no point, and the next one is not moved up
    let second = &[p("Ball 1", [1.6, 2.6, -3.6])];
    assert_eq!(mm("aqdef", &AQDEF.replace("K0001/2 2.5\n", "K0001/2 2.5\nK0002/2 256\n")), second);
    assert_eq!(mm("aqdef", &AQDEF.replace("2.6\u{14}0", "2.6\u{14}255")), &[p("Ball 1", [1.5, 2.5, -3.5])]);
    assert_eq!(mm("aqdef", &AQDEF.replace("2.6\u{14}0", "")), &[p("Ball 1", [1.5, 2.5, -3.5])]);
    // a diameter, a number of errors, a name that is an axis alone
    assert_eq!(mm("aqdef", &AQDEF.replace("K2142/0 mm", "K2142/0 mm\nK2004/2 1")), &[]);
    assert_eq!(mm("aqdef", &AQDEF.replace("Ball 1_z", "Z")), &[]);
}

#[test]
fn what_is_wrong_in_a_q_das_file_is_refused_with_its_line() {
    refused("aqdef", &AQDEF.replace("K2142/0 mm", "K2142/0 inch"), &["[unit-differs]", "inch (K2142)", "f.txt:4"]);
    refused("aqdef", &AQDEF.replace("K2142/0 mm", "K2142/2 deg"), &["[unit-unknown]: `deg`", "f.txt:4"]);
    refused("aqdef", &AQDEF.replace("1.5", "1,5"), &["[not-a-number]: `1,5`", "f.txt:9", "\"aqdef, decimal comma\""]);
    refused("aqdef", &AQDEF.replace("K0100 4", "K0100 3"), &["[characteristic-beyond-count]", "f.txt:8", "f.txt:14"]);
    refused("aqdef", &AQDEF.replace("K0100 4\n", ""), &["[format-differs]", "`K0100`", ".dfd", ".dfx"]);
    refused("aqdef", &format!("{AQDEF}K0100 4\n"), &["[several-data-sets]", "`K0100`", "f.txt:15"]);
    refused("aqdef", &AQDEF[..AQDEF.find("K0001").unwrap()], &["[no-measured-points]", "`K0001`"]);
    refused("aqdef", &AQDEF.replace("K1001 Plate", "Plate"), &["[record-invalid]: `Plate`", "f.txt:2"]);
    refused("aqdef", &AQDEF.replace("K2002/4 Ball 1.D\n", ""), &["[record-too-early]", "`K0001/4`", "`K2002/4`"]);
    refused(
        "aqdef",
        &AQDEF.replace("K0001/2 2.5\n", ""),
        &["[value-of-piece-missing] number=1 name=Ball 1.Y", "piece 2", "f.txt:13"],
    );
    let by_characteristic = "K0100 3\nK1001 P\nK2001/1 A.X\nK0001/1 1\nK0001/1 2\nK2001/2 A.Y\nK0001/2 3\nK0001/2 4\n\
                             K2001/3 A.Z\nK0001/3 5\nK0001/3 6\n";
    assert_eq!(mm("aqdef", by_characteristic), [p("A", [1.0, 3.0, 5.0]), p("A", [2.0, 4.0, 6.0])]);
    refused(
        "aqdef",
        &by_characteristic.replace("K0001/2 3\n", ""),
        &["[coordinate-counts-differ] name=A.Y found=1", "has 2", "f.txt:6"],
    );
    refused(
        "aqdef",
        &AQDEF.replace("K0001/1 1.5\n", "K0002/1 0\n"),
        &["[record-too-early]", "`K0002/1`", "`K0001/1`", "f.txt:9"],
    );
}

const DMIS: &str = "$$ comment $\nFILNAM/'a, b = c/d'\nunits/mm, angdec\nF(N) = FEAT/POINT, CART, 9, 9, 9, 0, 0, 1\n\
                    FA(A 1) = FEAT/POINT, CART, 1.5, 2.5, $\n  3.5, 0, 0, 1\nTA(T)=TOL/POS,0.1,INTOL\n\
                    FA(S)=FEAT/SPHERE,OUTER,CART,1,2,3,25.4\nENDFIL\n";

#[test]
fn dmis_records_go_on_after_a_dollar_and_hold_nominals_that_are_not_measured() {
    assert_eq!(mm("dmis", DMIS), [p("A 1", [1.5, 2.5, 3.5]), p("S", [1.0, 2.0, 3.0])]);
    refused("dmis", &DMIS.replace("mm, ang", "inch, ang"), &["[unit-differs]", "inch (UNITS)", "f.txt:3:7"]);
    refused("dmis", &DMIS.replace("TA(T)", "UNITS/INCH\nTA(T)"), &["[unit-differs]", "inch (UNITS)", "f.txt:7:7"]);
    refused("dmis", &DMIS.replace("CART, 1.5", "POL, 1.5"), &["[coordinates-not-cartesian]", "`POL`", "f.txt:5:23"]);
    refused(
        "dmis",
        &DMIS.replace("3.5, 0", "3.5x, 0").replace("25.4", "d"),
        &["f.txt:6:3", "`3.5x`", "`d`", "f.txt:8:"],
    );
    refused("dmis", &DMIS.replace("2.5, $", "2.5,"), &["[number-empty]", "f.txt:5:38"]);
    refused("dmis", &DMIS.replace("0, 0, 1\nTA", "0, 0, 7\nTA"), &["[direction-not-unit]", "(0, 0, 7)"]);
}

#[test]
fn trap_8_pcdmis_is_in_inch_unless_metric_stands_in_its_place() {
    let rows = "10.0,20.0,5.0,0,0,1\n1,2,3\n1,2,3,4\n1,2,3,4,5,6,7,8,9\n";
    let expected =
        vec![p("", [10.0, 20.0, 5.0]), p("", [1.0, 2.0, 3.0]), p("", [1.0, 2.0, 3.0]), p("", [1.0, 2.0, 3.0])];
    assert_eq!(mm("pcdmis_xyz", &format!("XYZIJK    METRIC\n{rows}")), expected);
    assert_eq!(read("pcdmis_xyz", "XYZIJK\n1,2,3\n", Unit::Inch).unwrap(), [p("", [25.4, 2.0 * 25.4, 3.0 * 25.4])]);
    refused("pcdmis_xyz", &format!("XYZIJK\n{rows}"), &["[unit-differs]", "inch (no `METRIC`"]);
    refused("pcdmis_xyz", &format!("XYZIJK METRIC\n{rows}"), &["[metric-misplaced]", "f.txt:1"]);
    refused(
        "pcdmis_xyz",
        "XYZIJK    METRIC\nPT_001\t10.2\t3\n1,x,3\n",
        &["[row-field-count]", "1 field", "f.txt:3:3", "[not-a-number]: `x`"],
    );
    refused("pcdmis_xyz", "1,2,3\n", &["[format-differs]", "`pcdmis_xyz`", "f.txt:1"]);
}

#[test]
fn records_of_a_gws_scan_stand_anywhere_on_a_line() {
    let scan =
        "#00:GEOPAK-WIN Scanning #02:slot #04:ZX(Y)#06:MM#03: 1 2 3#12: 4 5 6 0 0 1\n#03:\n 7 8\n 9 #02:end #03: 1 1 1";
    let expected =
        [p("slot", [2.0, 3.0, 1.0]), p("slot", [5.0, 6.0, 4.0]), p("slot", [8.0, 9.0, 7.0]), p("end", [1.0; 3])];
    assert_eq!(mm("geopak_gws", scan), expected);
    // without heads it is XY(Z) in mm
    assert_eq!(mm("geopak_gws", "#03: 1 2 3"), [p("", [1.0, 2.0, 3.0])]);
    let inch = read("geopak_gws", "#03: 1 2 3", Unit::Inch).unwrap_err();
    assert!(inch.contains("[unit-differs]") && inch.contains("mm (no `#06`"), "{inch}");
    let wrong = scan.replace("ZX(Y)", "RZ(P)").replace("4 5 6", "4 5x 6").replace("1 1 1", "1 1") + "#99: x";
    refused(
        "geopak_gws",
        &wrong,
        &[
            "[coordinates-not-cartesian]",
            "f.txt:1:34",
            "`5x`",
            "`#03:` has 2 numbers",
            "f.txt:4:12",
            "[record-invalid]: `#99:`",
        ],
    );
}

#[test]
fn inspec_rows_without_a_feature_or_a_value_are_told() {
    let good = "\"A b+: Location X\",1\n\"A b+: Location Y\",2\n\"A b+: Location Z\",3\n\"A b+: 3D MCS Points\",1,2,3\n\
                \"C: Diameter\",9\n\"C: 3D MCS Points\"\n4,5,6\n7,8,9\n";
    let all = [
        p("A b+: Location", [1.0, 2.0, 3.0]),
        p("A b+", [1.0, 2.0, 3.0]),
        p("C", [4.0, 5.0, 6.0]),
        p("C", [7.0, 8.0, 9.0]),
    ];
    assert_eq!(mm("inspec", good), all);
    let wrong = format!("1,2,3\n{}", good.replace("7,8,9", "7,8\n7,x,9").replace("\"C: Diameter\"", "\"C\""));
    refused(
        "inspec",
        &wrong,
        &["[record-too-early]: `1,2,3`", "f.txt:1", "f.txt:9", "2 fields", "f.txt:10:3", "[record-invalid]: `C`"],
    );
    refused(
        "inspec",
        &good.replace("\"C: 3D MCS", "\"C: 2D PCS"),
        &["[coordinate-system-differs]", "`C`", "`2D PCS`", "`3D MCS`"],
    );
}

const VDA: &str = "ABC = HEADER / 1                                                        00000001\n\
                   any = / text, 00                                                        00000002\n\
                   P1 = POINT / 1.5, 2., -3.0D+00 $$ a comment\n\
                   S = PSET / 2, 1, 2, 3,\n 4, 5,\n 6\n\
                   M = MDI / 1, 1, 2, 3, 0, 0, 1\nABC = END\n";

#[test]
fn vda_points_are_read_without_the_numbers_of_their_lines() {
    let expected =
        [p("P1", [1.5, 2.0, -3.0]), p("S", [1.0, 2.0, 3.0]), p("S", [4.0, 5.0, 6.0]), p("M", [1.0, 2.0, 3.0])];
    assert_eq!(mm("vda_fs", VDA), expected);
    refused(
        "vda_fs",
        &VDA.replace("PSET / 2", "PSET / 4000000000000000000"),
        &["[stated-count-differs] name=S found=6", "12000000000000000000", "f.txt:4:12"],
    );
    refused("vda_fs", VDA.trim_end().trim_end_matches("ABC = END"), &["[file-cut-off]", "`NAME = END`"]);
    refused(
        "vda_fs",
        &VDA.replace("4, 5,", "4, 5x,").replace("2., -3", "-3"),
        &["`5x`", "f.txt:5:5", "[number-count-differs] name=P1 found=2"],
    );
    let long = format!("P2 = POINT / 1.0, 2.0, {:<49}{}\nABC = END\n", "", 12345678);
    refused("vda_fs", &long, &["[line-number-differs]", "`12345678`", "`00000001`", "f.txt:1"]);
}

/// Four vertices as text, with a face behind them.
const PLY: &str = "ply\nformat ascii 1.0\ncomment made up\nelement vertex 4\nproperty float x\nproperty double y\nproperty uchar red\n\
                   property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
                   0 0.5 255 1\n1 1.5 0 1\n2 2.5 1 -1\n3 3.5 2 0.25\n3 0 1 2\n";

/// The same in binary; one character for each byte.
fn binary(big: bool, list_first: bool) -> String {
    let (vertex, face) =
        PLY.split_once("element vertex").map_or(("", ""), |(_, rest)| rest.split_once("element face").unwrap());
    let (vertex, face) =
        (format!("element vertex{vertex}"), format!("element face{}", face.split("end_header").next().unwrap()));
    let elements = if list_first { face + &vertex } else { vertex + &face };
    let encoding = if big { "big" } else { "little" };
    let mut bytes = format!("ply\nformat binary_{encoding}_endian 1.0\n{elements}end_header\n").into_bytes();
    let f32 = |v: f32| if big { v.to_be_bytes() } else { v.to_le_bytes() };
    let f64 = |v: f64| if big { v.to_be_bytes() } else { v.to_le_bytes() };
    let mut vertices = Vec::new();
    for (i, (red, z)) in [(255u8, 1.0f32), (0, 1.0), (1, -1.0), (2, 0.25)].into_iter().enumerate() {
        vertices.extend(f32(i as f32));
        vertices.extend(f64(i as f64 + 0.5));
        vertices.push(red);
        vertices.extend(f32(z));
    }
    let int = |v: i32| if big { v.to_be_bytes() } else { v.to_le_bytes() };
    let face: Vec<u8> = std::iter::once(3).chain([0, 1, 2].into_iter().flat_map(int)).collect();
    bytes.extend(if list_first { [face, vertices] } else { [vertices, face] }.concat());
    bytes.into_iter().map(char::from).collect()
}

#[test]
fn ply_is_the_same_as_text_and_in_both_orders_of_bytes() {
    let expected = [[0.0, 0.5, 1.0], [1.0, 1.5, 1.0], [2.0, 2.5, -1.0], [3.0, 3.5, 0.25]].map(|xyz| p("", xyz));
    assert_eq!(mm("ply", PLY), expected);
    for (big, list_first) in [(false, false), (true, false), (false, true), (true, true)] {
        assert_eq!(mm("ply", &binary(big, list_first)), expected, "{big} {list_first}");
    }
}

#[test]
fn a_vertex_of_a_binary_file_that_is_not_a_number_is_refused() {
    let bytes = binary(false, false);
    let (head, vertices) = bytes.split_once("end_header\n").unwrap();
    let not_a_number: String = f32::NAN.to_le_bytes().map(char::from).iter().collect();
    let wrong = format!("{head}end_header\n{not_a_number}{}", vertices.chars().skip(4).collect::<String>());
    refused("ply", &wrong, &["[vertex-not-finite]"]);
}

#[test]
fn counts_that_no_file_can_hold_are_refused_at_once() {
    let start = Instant::now();
    let huge = |text: &str| text.replace("vertex 4\n", "vertex 4000000000\n");
    refused("ply", &huge(PLY), &["[file-cut-off]", "`vertex` 6 of 4000000000", "f.txt:4"]);
    let ended = huge(PLY).replace("3 0 1 2\n", "");
    refused("ply", &ended, &["[file-cut-off]", "`vertex` 5 of 4000000000", "f.txt:4"]);
    refused("ply", &huge(&binary(false, false)), &["[file-cut-off]", "of 4000000000"]);
    refused("ply", &binary(false, true).replace("face 1", "face 18446744073709551615"), &["[file-cut-off]", "`face`"]);
    refused(
        "ply",
        &PLY.replace("vertex 4", "vertex 99999999999999999999"),
        &["[record-invalid]: `99999999999999999999`"],
    );
    refused("vda_fs", "A = HEADER / 4000000000000\n", &["[file-cut-off]"]);
    assert!(start.elapsed().as_secs_f64() < 60.0, "{:?}", start.elapsed());
}

const DIMENSION: &str = "DIM LOC1= LOCATION OF SPHERE SPH1  UNITS=MM\nAX NOMINAL +TOL -TOL MEAS DEV OUTTOL\n\
    X 1.5 0.2 0.2 1.4 -0.1 0.0\nY 2.5 0.2 0.2 2.4 -0.1 0.0\nZ 3.5 0.2 0.2 3.4 -0.1 0.0\n";
const SCAN: &str = "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n10 20 30 1\n1 2 3 0.5\n4 5 6 0.5\n";

const MESH: &str = "solid m\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1.5 0 0\n   vertex 0 2.5 0\n  endloop\n endfacet\n\
    endsolid m\n";
const CLOUD: &str = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1.5 2.5 3.5\nnan nan nan\n";
const PROGRAM: &str = "/PROG A\n/POS\nP[1]{\n   GP1:\n\tUF : 0, UT : 1,\n\tX = 1.5 mm,\tY = 2.5 mm,\tZ = 3.5 mm,\n\tW = 0.0 deg,\tP = 0.0 deg,\
    \tR = 0.0 deg\n};\n/END\n";
const MODULE: &str =
    "MODULE A\nCONST robtarget p1:=[[1.5,2.5,3.5],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\nENDMODULE\n";

/// A triangle of binary STL; one character for each byte.
fn mesh() -> String {
    let mut bytes = vec![b' '; 80];
    bytes.extend(1u32.to_le_bytes());
    [0.0f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 0.0, 2.5, 0.0].iter().for_each(|v| bytes.extend(v.to_le_bytes()));
    bytes.extend([0, 0]);
    bytes.into_iter().map(char::from).collect()
}

/// One frame of one marker of C3D; one character for each byte.
fn motion() -> String {
    let mut bytes = vec![0u8; 1024];
    for (at, byte) in [(0, 2), (1, 0x50), (2, 1), (6, 1), (8, 1), (16, 3), (514, 1), (515, 84)] {
        bytes[at] = byte;
    }
    bytes[12..16].copy_from_slice(&(-1.0f32).to_le_bytes());
    bytes[20..24].copy_from_slice(&100.0f32.to_le_bytes());
    let labels = b"\x06\x01LABELS\x0b\x00\xff\x02\x04\x01ball\x00\x00\x00";
    bytes[516..525].copy_from_slice(b"\x05\xffPOINT\x03\x00");
    bytes[526..526 + labels.len()].copy_from_slice(labels);
    [1.5f32, 2.5, 3.5, 0.0].iter().for_each(|v| bytes.extend(v.to_le_bytes()));
    bytes.into_iter().map(char::from).collect()
}

/// A sound file of each format.
pub fn samples() -> Vec<(&'static str, String)> {
    let project = "# === PolyWorks|Inspector project description file ===\nBEGIN OBJECT 0\nCLASS\t=\tPrimitive\nTYPE\t=\tPoint\n\
                   NAME\t=\tUNICODE( 00410042 )\nBEGIN X\nA = 1\nEND X\nPOINT\t=\t1.5\t2.5\t3.5\nEND OBJECT 0\n";
    let gws = "#00:GEOPAK-WIN Scanning\n#02:slot\n#04:ZX(Y)\n#06:MM\n#03: 1 2 3\n#12: 4 5 6 0 0 1\n";
    let inspec = "\"C: Center X\",9\n\"C: 3D MCS Points\"\n4,5,6\n7,8,9\n\"P: 3D MCS Points\",1,2,3\n";
    let angles = DMIS.replace("0, 0, 1\nTA", "90, 90, 0\nTA");
    let all = [
        ("polyworks_report", REPORT.to_owned()),
        ("polyworks_project", project.to_owned()),
        ("calypso", CHR.to_owned()),
        ("aqdef", AQDEF.to_owned()),
        ("dmis", DMIS.to_owned()),
        ("geopak_dmis", angles),
        ("pcdmis_xyz", "XYZIJK    METRIC\n10.0,20.0,5.0,0,0,1\n1,2,3\n".to_owned()),
        ("pcdmis_report", DIMENSION.to_owned()),
        ("ptx", SCAN.to_owned()),
        ("geopak_gws", gws.to_owned()),
        ("inspec", inspec.to_owned()),
        ("vda_fs", VDA.to_owned()),
        ("ply", PLY.to_owned()),
        ("ply", binary(false, true)),
        ("ply", binary(true, false)),
        ("stl", MESH.to_owned()),
        ("stl", mesh()),
        ("pcd", CLOUD.to_owned()),
        ("c3d", motion()),
        ("fanuc_ls", PROGRAM.to_owned()),
        ("abb_rapid", MODULE.to_owned()),
    ];
    all.into_iter().collect()
}

#[test]
fn every_sample_is_sound_and_every_reader_has_one() {
    let samples = samples();
    for (name, text) in &samples {
        assert!(!mm(name, text).is_empty(), "{name}");
    }
    // tables and QIF have files of tests of their own
    let elsewhere =
        ["polyworks", "qif", "e57", "spatialanalyzer", "xyz", "xyzijk", "name-xyz-csv", "tracker-semicolon"];
    let mut names = Format::names().filter(|name| {
        !elsewhere.contains(name) && !["leica-at960", "leica-emscon", "leica_gsi", "sdss-plate"].contains(name)
    });
    assert!(names.all(|name| samples.iter().any(|(sample, _)| *sample == name)));
}

#[test]
fn every_truncation_and_nul_byte_ends_without_a_panic_and_changes_no_label() {
    for (name, text) in samples() {
        let whole: Vec<String> = mm(name, &text).into_iter().map(|(label, _)| label).collect();
        for end in (0..text.len()).filter(|&end| text.is_char_boundary(end)) {
            if let Ok(points) = read(name, &text[..end], Unit::Millimetre) {
                assert!(points.len() <= whole.len() + 1, "{name}: {end}");
            }
        }
        for at in (0..text.len()).filter(|&at| text.is_char_boundary(at)) {
            let _ = read(name, &format!("{}\0{}", &text[..at], &text[at..]), Unit::Millimetre);
        }
    }
}

#[test]
fn deep_nesting_and_endless_lines_take_no_long_time() {
    let head = "# === PolyWorks|Inspector project description file ===\n";
    refused(
        "polyworks_project",
        &format!("{head}{}", "BEGIN OBJECT 1\n".repeat(100_000)),
        &["[nested-too-deep]", "33 levels", "f.txt:34"],
    );
    refused(
        "polyworks_project",
        &format!("{head}END OBJECT 1\n"),
        &["[record-too-early]: `END OBJECT 1`", "`BEGIN OBJECT 1`"],
    );
    refused("polyworks_project", &format!("{head}BEGIN OBJECT 1\n"), &["[file-cut-off]", "`END OBJECT 1`"]);
    let long = "7".repeat(1_000_000);
    for (name, text) in samples() {
        let start = Instant::now();
        let _ = read(name, &format!("{text}{long}"), Unit::Millimetre);
        let _ = read(name, &format!("{long}{text}"), Unit::Millimetre);
        let _ = read(name, &text.replace('\n', " "), Unit::Millimetre);
        assert!(start.elapsed().as_secs_f64() < 60.0, "{name}: {:?}", start.elapsed());
    }
}
