//! Damaged and ambiguous logs of controllers: every problem with its place. All texts are synthetic.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::campaign::Campaign;
use etalon::stages::gather::{Gathered, gather};

/// A campaign whose log is this text.
pub fn with_log(text: &str, stated: &str) -> Scratch {
    let scratch = copy_sample("prexyt-cmm");
    let campaign = format!(
        "name = \"l\"\nrobot = \"robot.toml\"\nexport = []\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\n\
         coverage_factor = 2\n[log]\nfile = \"encoders.csv\"\n{stated}\n[join]\nby = \"row\"\n[frame.world]\n\
         as_exported = true\n[identify]\ncalibration = \"all\"\n"
    );
    std::fs::write(scratch.path().join("campaign.toml"), campaign).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), text).unwrap();
    scratch
}

fn read(text: &str, stated: &str) -> Result<Gathered, String> {
    let scratch = with_log(text, stated);
    let campaign = Campaign::read(&scratch.path()).map_err(|e| e.to_string())?;
    gather(&campaign).map_err(|e| e.to_string())
}

fn column(imported: &Gathered, name: &str) -> Vec<f64> {
    imported.logs[0].table().numbers(name).unwrap()
}

fn refused(text: &str, stated: &str, parts: &[&str]) {
    let said = read(text, stated).map(|_| ()).expect_err(stated);
    for part in parts {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
}

const GALIL: &str = "format = \"galil\"\ncolumns = { a_mm = { name = \"A\", per_count = 0.5 }, b_mm = { name = \"B\", per_count = 2 } }";

#[test]
fn galil_holes_fractions_and_wraps_are_told_with_their_places() {
    let good = read("A,B\n1,2\n3,4\n", GALIL).unwrap();
    assert_eq!((column(&good, "a_mm"), column(&good, "b_mm")), (vec![0.5, 1.5], vec![4.0, 8.0]));
    refused("A,B\n1,2\n,4\n5,6\n", GALIL, &["error[galil-array-hole]", "`a_mm`", "encoders.csv:3"]);
    refused("A,B\n1,2\n3.5,4\n", GALIL, &["error[not-a-count]: 3.5", "encoders.csv:3:1"]);
    refused("A,B\n2147483000,2\n-2147483000,4\n", GALIL, &["error[counter-wrapped]", "encoders.csv:3:1"]);
    refused("A,B\n,2\n,4\n", GALIL, &["error[galil-array-empty]"]);
    refused("A,B\n1,2\n", &format!("{GALIL}\nperiod_s = 0"), &["error[key-not-positive]: `period_s`"]);
}

#[test]
fn what_columns_state_and_cannot_mean_is_an_error_of_the_campaign() {
    for (stated, part) in [
        ("columns = { a_mm = { name = \"A\", number = 1 } }", "either a `name` or a `number`"),
        ("columns = { a_mm = { name = \"A\", zero_count = 1 } }", "without `per_count`"),
        ("columns = { a_mm = { name = \"A\", per_count = 0 } }", "`per_count` is not 0"),
        ("columns = { a_mm = { name = \"A\", factor = 1 } }", "[unknown-key]"),
        (
            "columns = { time_s = { name = \"A\", per_count = 1 }, a_mm = \"B\" }",
            "error[log-key-inapplicable]: `per_count`",
        ),
        ("columns = { time_s = \"A\", time_ms = \"B\" }", "error[log-column-twice]"),
        ("period_s = 1\ncolumns = { time_s = \"A\" }", "error[log-column-twice]"),
        ("format = \"galli\"\ncolumns = { a_mm = \"A\" }", "galil"),
        ("values = \"raw\"\ncolumns = { a_mm = \"A\" }", "error[log-key-inapplicable]: `values`"),
    ] {
        refused("A,B\n1,2\n3,4\n", stated, &[part, "campaign.toml"]);
    }
}

#[test]
fn times_in_ms_and_ns_are_seconds() {
    let rows = "t,n,A\n1500,1651499784376000000,2\n1512,1651499784388000000,3\n";
    let ms = read(rows, "columns = { time_ms = \"t\", a_mm = \"A\" }").unwrap();
    assert_eq!(column(&ms, "time_s"), [1.5, 1.512]);
    let ns = read("t,n,A\n1500,1651499784376000000,2\n", "columns = { time_ns = \"n\", a_mm = \"A\" }").unwrap();
    assert_eq!(column(&ns, "time_s"), [1651499784.376]);
    // a computed number has the unit of its key too
    let computed = read("s,n,A\n15,500000000,2\n", "columns = { time_ns = \"1000000000 * s + n\", a_mm = \"A\" }");
    assert!((column(&computed.unwrap(), "time_s")[0] - 15.5).abs() < 1e-9);
    refused(
        "t,n,A\n1500,1651499784.376,2\n",
        "columns = { time_ns = \"n\" }",
        &["error[not-whole-number]", "`time_ns`", "encoders.csv:2:6"],
    );
}

#[test]
fn lost_telegrams_of_rsi_are_told() {
    let text: String = [1000, 1004, 1008, 1020, 1024].iter().map(|t| format!("{t},1.5\n")).collect();
    let stated = "format = \"kuka_rsi\"\ncolumns = { time_ms = \"IPOC\", a_deg = \"A1\" }";
    let found = read(&format!("IPOC,A1\n{text}"), stated).unwrap();
    let said = &found.document.messages[0];
    assert!(said.is("rsi-cycles-missing", &[("count", &1), ("step_ms", &4)]), "{said}");
    assert_eq!(said.place.as_ref().and_then(|p| p.line), Some(5));
}

#[test]
fn a_counter_that_falls_by_more_than_numbers_hold_is_told() {
    // found by random damage: the step was negated
    let stated = "format = \"kuka_rsi\"\ncolumns = { time_ms = \"IPOC\", a_deg = \"A1\" }";
    let found = read("IPOC,A1\n1e308,1.5\n8,1.5\n", stated).unwrap();
    assert_eq!(found.logs[0].rows.len(), 2);
}

#[test]
fn rostopic_names_its_joints_in_every_row() {
    let stated = "format = \"ros\"\ncolumns = { time_ns = \"%time\", q1_rad = \"shoulder\", q2_rad = \"elbow\" }";
    let head = "%time,field.name0,field.name1,field.position0,field.position1,field.velocity0\n";
    let good =
        read(&format!("{head}1000000000,elbow,shoulder,1,2,9\n2000000000,elbow,shoulder,3,4,9\n"), stated).unwrap();
    let degrees = |v: &[f64]| v.iter().map(|v| v * (180.0 / std::f64::consts::PI)).collect::<Vec<f64>>();
    assert_eq!(column(&good, "q1_deg"), degrees(&[2.0, 4.0]));
    assert_eq!(column(&good, "q2_deg"), degrees(&[1.0, 3.0]));
    let mixed = format!("{head}1000000000,elbow,shoulder,1,2,9\n2000000000,shoulder,elbow,3,4,9\n");
    refused(&mixed, stated, &["error[ros-joints-change] number=0 found=shoulder", "encoders.csv:3"]);
    let velocity = "format = \"ros\"\ncolumns = { q1_rad = \"field.velocity0\" }";
    refused(&format!("{head}1,elbow,shoulder,1,2,9\n"), velocity, &["error[column-unit-differs]", "rad/s"]);
}

/// A TwinCAT export with one channel in degrees and one in mm, the latter at every other time.
const SCOPE: &str = "Name\tmade up\nStarttime of export\t132959733843760000\tx\n\n\nName\ta\tName\tb\nUnit\t°\tUnit\tmm (x)\n\
                     ScaleFactor\t1\tScaleFactor\t0,5\nOffset\t0\tOffset\t0\n\n0\t1.5\t0\t10\n1\t2.5\t2\t12\n2\t3.5\t \t \n3\t4.5\nEOF\n";
const CHANNELS: &str = "format = \"twincat\"\nvalues = \"raw\"\ncolumns = { a_deg = \"a\", b_mm = \"b\" }";

#[test]
fn twincat_channels_meet_at_equal_times_with_their_scale_and_unit() {
    let good = read(SCOPE, CHANNELS).unwrap();
    assert_eq!((column(&good, "time_s"), column(&good, "b_mm")), (vec![0.0, 0.002], vec![5.0, 6.0]));
    assert_eq!(column(&good, "a_deg"), [1.5, 3.5]);
    refused(
        SCOPE,
        &CHANNELS.replace("a_deg", "a_rad"),
        &["error[column-unit-differs] column=a known=deg", "write `a_deg"],
    );
    refused(
        SCOPE,
        &CHANNELS.replace("\"raw\"", "\"scaled\"").replace("b_mm", "b_deg"),
        &["error[column-unit-differs]", "`b` is in mm"],
    );
    refused(SCOPE, &CHANNELS.replace("values = \"raw\"\n", ""), &["error[twincat-scale-undecided] channel=b"]);
    refused(
        &SCOPE.replace("ScaleFactor\t0,5", "ScaleFactor\tx"),
        CHANNELS,
        &["error[channel-scale-not-number]", "`b`"],
    );
    let unit = "Offset\t0\nUnit ScaleFactor\t1\tUnit ScaleFactor\t1000\n\n";
    refused(&SCOPE.replace("Offset\t0\n\n", unit), CHANNELS, &["error[twincat-two-scales] channel=b"]);
    let between = SCOPE.replace("\t0\t10\n", "\t0.5\t10\n").replace("\t2\t12\n", "\t2.5\t12\n");
    refused(&between, CHANNELS, &["error[channels-without-common-time]"]);
}

#[test]
fn twincat_holes_and_clocks_that_stand_are_told_at_once() {
    let wrong = SCOPE.replace("1\t2.5", "0\t2.5").replace("3\t4.5\n", "3\t4,5\t5\t7\n");
    refused(
        &wrong,
        CHANNELS,
        &["error[time-not-increasing]", "encoders.csv:11:1", "`4,5`", "encoders.csv:13:3", "error[channel-resumes]"],
    );
    refused(&SCOPE.replace("3\t4.5\n", "3\t4.5\t\t\t9\n"), CHANNELS, &["error[row-field-count]", "at most 4"]);
    refused("no scope\n", CHANNELS, &["error[twincat-head-malformed]"]);
    refused("Name\tx\n", CHANNELS, &["error[twincat-head-malformed] part=names"]);
    refused(
        &SCOPE.replace("Offset\t0\tOffset\t0\n\n", "Offset\t0\tOffset\t0\n"),
        CHANNELS,
        &["error[twincat-head-malformed] part=end"],
    );
    refused(SCOPE, &CHANNELS.replace("\"b\"", "\"c\""), &["error[column-unknown]", "`c`"]);
    refused(SCOPE, &format!("delimiter = \";\"\n{CHANNELS}"), &["error[delimiter-differs] separator='\\t'"]);
    refused(SCOPE, &format!("period_s = 1\n{CHANNELS}"), &["error[log-key-inapplicable]: `period_s`"]);
    refused(SCOPE, &format!("header = false\n{CHANNELS}"), &["error[log-key-inapplicable]: `header`"]);
}

/// A sound log of each format: what the campaign states, and its text.
pub fn samples() -> Vec<(String, String)> {
    let ros = "%time,field.name0,field.position0\n1000000000,elbow,1\n2000000000,elbow,2\n";
    vec![
        (GALIL.to_owned(), "A,B\n1,2\n3,4\n,5\n".to_owned()),
        (CHANNELS.to_owned(), SCOPE.to_owned()),
        ("format = \"ros\"\ncolumns = { time_ns = \"%time\", q1_rad = \"elbow\" }".to_owned(), ros.to_owned()),
        (
            "format = \"kuka_rsi\"\ncolumns = { time_ms = \"IPOC\", a_deg = \"A1\" }".to_owned(),
            "IPOC,A1\n4,1.5\n8,1.5\n".to_owned(),
        ),
        (
            "format = \"ur_rtde\"\ncolumns = { time_s = \"timestamp\", q1_rad = \"actual_q_0\" }\n\
             standstill = { at_least_s = 0.1, within_deg = 1 }"
                .to_owned(),
            "timestamp,actual_q_0\n1.0,0.5\n1.1,0.5\n1.2,0.5\n".to_owned(),
        ),
    ]
}

#[test]
fn every_truncation_of_a_log_ends_without_a_panic() {
    for (stated, text) in samples() {
        assert!(read(&text, &stated).is_ok(), "{stated}");
        for end in (0..text.len()).filter(|&end| text.is_char_boundary(end)) {
            let _ = read(&text[..end], &stated);
        }
    }
}

/// Rows without a value are left out and listed, as in every table; columns may be computed or constant.
#[test]
fn missing_computed_and_constant_columns_of_a_log() {
    let text = "P;A;B\n1;2,5;1\n2;---;4\n1;4,5;1,5\n3;5;\n2;6;2\n";
    let stated = "delimiter = \";\"\ndecimal = \",\"\n\
                  columns = { pose = \"P\", a_mm = \"A\", b_m = \"(A - B) / 1000\", c_mm = \"2 * $3\" }\n\
                  constants = { cycle = \"visit\", d_m = 0.25 }\nmissing = [\"---\", \"\"]";
    let imported = read(text, stated).unwrap_or_else(|said| panic!("{said}"));
    assert_eq!(column(&imported, "a_mm"), [2.5, 4.5, 6.0]);
    assert_eq!(column(&imported, "b_mm"), [1.5, 3.0, 4.0]);
    assert_eq!(column(&imported, "c_mm"), [2.0, 3.0, 4.0]);
    assert_eq!(column(&imported, "d_mm"), [250.0; 3]);
    assert_eq!(column(&imported, "cycle"), [1.0, 2.0, 1.0]);
    // rows keep their numbers
    assert_eq!(column(&imported, "row"), [1.0, 3.0, 5.0]);
    let source = imported.document.sources.iter().find(|source| source.file == "encoders.csv").unwrap();
    let lines: Vec<(usize, &str)> =
        source.refused.iter().map(|refused| (refused.line, refused.reason.english())).collect();
    assert_eq!(lines, [(3, "not measured: a_mm is `---`"), (5, "not measured: b_m is empty")]);

    for (stated, part) in [
        ("columns = { a_mm = \"$9 + 1\" }", "[column-number-unknown]"),
        ("columns = { a_mm = \"A + C\" }", "[column-unknown]"),
        ("columns = { a_mm = \"A / (B - B)\" }", "[computed-not-finite]"),
        ("columns = { a_mm = \"A\" }\nconstants = { a_m = 1 }", "[log-column-twice]"),
        ("columns = { a_mm = \"A\" }\nconstants = { bb = 1 }", "[log-column-unknown]"),
        ("columns = { a_mm = \"A\" }\nconstants = { cycle = \"visit\" }", "[log-constant-invalid]"),
        ("columns = { a_mm = \"A\" }\nconstants = { b_mm = \"none\" }", "[log-constant-invalid]"),
    ] {
        refused("A,B\n1,2\n3,4\n", stated, &[part]);
    }
}
