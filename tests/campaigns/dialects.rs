//! Whatever dialect a campaign states, `simulate` writes it and `import` reads the same points and joints back.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::message::Problems;
use etalon::base::pose::Pose;
use etalon::campaign::Campaign;
use etalon::formats::Format;
use etalon::formats::table::Table;
use etalon::simulate::{LabelledPoint, Truth, simulate};
use etalon::stages::gather::gather;
use std::collections::BTreeMap;

const CYCLES: i64 = 2;
const DIGITS: usize = 7;
const LOG: &str = "columns = { pose = \"pose\", cycle = \"run\", rho1_mm = \"A\", rho2_mm = \"B\", rho3_mm = \"C\" }";
const BY_POSE: &str = "by = [\"pose\", \"cycle\"]";

/// Name, lines of the export, mm in its unit, whether it bears fixed points, lines of the log, mm in its unit, join.
pub type Case = (&'static str, &'static str, f64, bool, &'static str, f64, &'static str);

const CASES: [Case; 11] = [
    (
        "SpatialAnalyzer",
        "format = \"spatialanalyzer\"\nunit = \"inch\"\nlabel = \"{cycle}::{target}::{pose}\"",
        25.4,
        false,
        LOG,
        1.0,
        BY_POSE,
    ),
    (
        "columns by the words of their header, thousands, a direction",
        "format = { delimiter = \";\", decimal = \",\", thousands = \".\", header = [\"East\", \"Up\"], \
         columns = { i = \"ni\", j = \"nj\", k = \"nk\", x = \"East\", y = \"North\", z = \"Up\", label = \"Name of it\" } }\n\
         unit = \"mm\"\nlabel = \"{target}_{pose}_{cycle}\"",
        1.0,
        true,
        LOG,
        1.0,
        BY_POSE,
    ),
    (
        "polyworks",
        "format = \"polyworks\"\nunit = \"mm\"\nlabel = \"{target}_{pose}_{cycle}\"",
        1.0,
        true,
        LOG,
        1.0,
        BY_POSE,
    ),
    (
        "semicolons, decimal comma, a header row",
        "format = { delimiter = \";\", decimal = \",\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\"] }\n\
         unit = \"mm\"\nlabel = \"{target}_{pose}_{cycle}\"",
        1.0,
        true,
        "delimiter = \";\"\ndecimal = \",\"\n\
         columns = { cycle = \"run no.\", pose = \"the pose\", rho3_m = \"C\", rho2_m = \"B\", rho1_m = \"A\" }",
        1000.0,
        BY_POSE,
    ),
    (
        "tabs, three header rows, comments, every role in another order",
        "format = { delimiter = \"tab\", header = 3, comment = \"#\", \
         columns = [\"z\", \"-\", \"cycle\", \"y\", \"target\", \"x\", \"pose\", \"-\"] }\nunit = \"m\"",
        1000.0,
        true,
        "delimiter = \"tab\"\nheader = false\ncolumns = { rho1_mm = 2, rho2_mm = 4, rho3_mm = 3, pose = 7, cycle = 1 }",
        1.0,
        BY_POSE,
    ),
    (
        "bars, a label that holds one, an end",
        "format = { delimiter = \"|\", decimal = \",\", end = \"END\", columns = [\"label\", \"x\", \"y\", \"z\"] }\n\
         unit = \"inch\"\nlabel = \"P{pose}| {cycle}: {target}\"",
        25.4,
        true,
        "delimiter = \"|\"\ndecimal = \",\"\ncolumns = { pose = \"pose\", cycle = 1, rho1_um = \"A\", rho2_um = \"B\", rho3_um = \"C\" }",
        0.001,
        BY_POSE,
    ),
    (
        "blanks, and rows that start like a comment",
        "format = { delimiter = \"blank\", header = 2, comment = \"K\", columns = [\"label\", \"-\", \"x\", \"y\", \"z\", \"-\"] }\n\
         unit = \"um\"\nlabel = \"{target} {pose} {cycle}\"",
        0.001,
        true,
        "delimiter = \"blank\"\ncolumns = { pose = 3, cycle = \"the run\", rho1_mm = \"A\", rho2_mm = \"B\", rho3_mm = \"C\" }",
        1.0,
        BY_POSE,
    ),
    (
        "tabs and a label that says pose and cycle alone",
        "format = { delimiter = \"tab\", header = 1, columns = [\"target\", \"label\", \"x\", \"y\", \"z\"] }\n\
         unit = \"mm\"\nlabel = \"{cycle}/{pose}\"",
        1.0,
        false,
        LOG,
        1.0,
        BY_POSE,
    ),
    (
        "by time",
        "format = { delimiter = \";\", decimal = \",\", header = 1, columns = [\"time_s\", \"target\", \"x\", \"y\", \"z\"] }\n\
         unit = \"mm\"",
        1.0,
        false,
        "columns = { time_s = \"t\", rho1_mm = \"A\", rho2_mm = \"B\", rho3_mm = \"C\" }",
        1.0,
        "by = \"time\"\nclock_offset_s = -3.25\ntolerance_s = 0.5",
    ),
    (
        "by row, one target a file",
        "format = { delimiter = \"blank\", columns = [\"x\", \"y\", \"z\"] }\nunit = \"mm\"\ntarget = \"K\"\npose = \"row\"\n\
         [[export]]\nfile = \"exports/l.txt\"\nformat = \"polyworks\"\nunit = \"mm\"\ntarget = \"L\"\npose = \"row\"",
        1.0,
        false,
        "header = false\npose = \"row\"\ncolumns = { rho1_mm = 1, rho2_mm = 2, rho3_mm = 3 }",
        1.0,
        "by = \"row\"",
    ),
    (
        "by pose: one row of the log for all cycles",
        "format = \"polyworks\"\nunit = \"mm\"\nlabel = \"{target}{pose}.{cycle}\"",
        1.0,
        false,
        "columns = { pose = \"pose\", rho1_mm = \"A\", rho2_mm = \"B\", rho3_mm = \"C\" }",
        1.0,
        "by = [\"pose\"]",
    ),
];

/// The sample in another dialect, and its truth without noise.
fn campaign(export: &str, log: &str, join: &str, with_points: bool) -> (Scratch, Campaign, Truth) {
    let scratch = copy_sample("prexyt-cmm");
    let text = format!(
        "name = \"d\"\nrobot = \"robot.toml\"\nsynthetic = \"yes\"\n[instrument]\nname = \"i\"\n\
         expanded_uncertainty_um = 2\ncoverage_factor = 2\n[[export]]\nfile = \"exports/poses.txt\"\n{export}\n\
         [log]\nfile = \"encoders.csv\"\n{log}\n[join]\n{join}\n[frame.world]\nas_exported = true\n\
         [identify]\ncalibration = \"all\"\n"
    );
    std::fs::write(scratch.path().join("campaign.toml"), text).unwrap();
    let mut truth = Truth::read(&scratch.path().join("truth.toml")).unwrap();
    (truth.noise_um, truth.decimals, truth.cycles) = (Some(0.0), DIGITS, CYCLES);
    truth.points.clear();
    if with_points {
        let (label, export) = ("ball N".to_owned(), "exports/poses.txt".to_owned());
        truth.points.push(LabelledPoint { label, export, at_mm: [1.5, -20.25, 3.0], repeats: 3 });
    }
    let campaign = Campaign::read(&scratch.path()).unwrap();
    (scratch, campaign, truth)
}

/// The export of each format with a reader of its own, as simulate writes it: what `format` states, and the text.
pub fn written_exports() -> Vec<(String, String)> {
    let stated = |case: &Case| case.1.split('"').nth(1).unwrap_or_default().to_owned();
    super::own_formats::CASES.into_iter().map(|case| (stated(&case), written_export(case).1)).collect()
}

/// The export of each stated dialect, as simulate writes it.
pub fn written_dialects() -> Vec<(Format, String)> {
    CASES.into_iter().map(written_export).collect()
}

fn written_export((name, export, _, with_points, log, _, join): Case) -> (Format, String) {
    let (scratch, campaign, mut truth) = campaign(export, log, join, with_points);
    truth.cycles = 1;
    simulate(&campaign, &truth).unwrap_or_else(|e| panic!("{name}: {e}"));
    let text = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
    (campaign.file.exports[0].format.clone(), text)
}

/// The value that is read where `value_mm` was written in a unit with so many digits.
fn written(value_mm: f64, in_mm: f64, digits: usize) -> f64 {
    format!("{:.digits$}", value_mm / in_mm).parse::<f64>().unwrap() * in_mm
}

#[test]
fn every_dialect_reads_back_bit_for_bit() {
    let all = CASES.into_iter().chain(super::own_formats::CASES);
    for (name, export, export_mm, with_points, log, log_mm, join) in all {
        let (_scratch, campaign, truth) = campaign(export, log, join, with_points);
        simulate(&campaign, &truth).unwrap_or_else(|e| panic!("{name}: {e}"));
        let imported = gather(&campaign).unwrap_or_else(|e| panic!("{name}: {e}"));
        let robot = campaign.build_robot().unwrap();
        let value = |p: &etalon::robots::Parameter| p.quantity.inward(truth.parameters[&p.name]);
        let values: Vec<f64> = robot.parameters().iter().map(value).collect();
        let rpy = truth.export_T_world.rpy_deg.map(f64::to_radians);
        let placed = Pose::from_xyz_rpy(truth.export_T_world.xyz_mm, rpy);

        let table = imported.logs[0].table();
        let column = |name| table.numbers(name).unwrap();
        let joints = [column("rho1_mm"), column("rho2_mm"), column("rho3_mm")];
        // 8 corners, and 17 positions with three orientations each
        let (poses, once) = (59, join == "by = [\"pose\"]");
        assert_eq!(table.height() as i64, poses * if once { 1 } else { CYCLES }, "{name}");
        let commanded = [170.0, 300.0, 44.0];
        let digits = (6.0 + log_mm.log10()).round() as usize;
        for (joint, expected) in joints.iter().zip(commanded) {
            assert_eq!(joint[6].to_bits(), written(expected, log_mm, digits).to_bits(), "{name}");
        }

        let mut seen = BTreeMap::new();
        for (i, point) in imported.points.iter().enumerate() {
            let target = point.target.as_deref().unwrap_or_default();
            // numbers of rows and times go on from one round to the next
            let number = match point.pose {
                Some(pose) => (point.cycle.unwrap() - 1) * poses + pose.number().unwrap(),
                None => ((point.time_s.unwrap_or(f64::NAN) + 3.25) / 10.0) as i64,
            };
            let fixed = *point.label == *"ball N" || target == "ball N";
            let (key, truly) = if fixed {
                (("ball N".to_owned(), i as i64), [1.5, -20.25, 3.0])
            } else {
                let row = ((number - 1) % poses) as usize;
                let q = [joints[0][row], joints[1][row], joints[2][row]];
                let mut truly = robot.position(&values, &q, usize::from(target == "L"));
                truly[2] += truth.target_height_mm;
                ((target.to_owned(), number), truly)
            };
            assert!(seen.insert(key, ()).is_none(), "{name}: row {i} is there twice");
            for (axis, (read, truly)) in point.xyz_mm.iter().zip(placed.apply(truly)).enumerate() {
                let expected = written(truly, export_mm, DIGITS);
                assert_eq!(read.to_bits(), expected.to_bits(), "{name}: row {i}, axis {axis}, {read} {expected}");
            }
        }
        let fixed = if with_points { 3 } else { 0 };
        assert_eq!(seen.len() as i64, fixed + 2 * poses * CYCLES, "{name}");
    }
}

#[test]
fn joints_in_radians_read_back_to_1e_12_deg() {
    let scratch = copy_sample("abb-irb120");
    let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let start = text.find("# three 1.5 inch").unwrap();
    let text = text[..start].replace("notes", "synthetic = \"yes\"\nnotes")
        + "[[export]]\nfile = \"e.txt\"\nformat = \"polyworks\"\nunit = \"mm\"\nlabel = \"{target}_{pose}\"\n\
           [log]\nfile = \"l.txt\"\npose = \"row\"\ncolumns = { q6_rad = \"f\", q5_rad = \"e\", q4_deg = \"d\", q3_rad = \"c\", \
           q2_rad = \"b\", q1_rad = \"a\" }\n[join]\nby = \"pose\"\ntargets = [\"T\"]\n[frame.world]\nas_exported = true\n\
           [identify]\ncalibration = \"all\"\n";
    std::fs::write(scratch.path().join("campaign.toml"), text).unwrap();
    let truth = "seed = 1\ncycles = 1\n[export_T_world]\nxyz_mm = [0, 0, 0]\nrpy_deg = [0, 0, 0]\n[parameters]\n\
                 [[poses]]\njoints = [[10, -20.123456, 30, 40.5, 150, -179.9], [1, 2, 3, 4, 5, 6]]\n";
    std::fs::write(scratch.path().join("truth.toml"), truth).unwrap();
    let campaign = Campaign::read(&scratch.path()).unwrap();
    simulate(&campaign, &Truth::read(&scratch.path().join("truth.toml")).unwrap()).unwrap();
    let imported = gather(&campaign).unwrap();
    for (name, expected) in [("q1_deg", 10.0), ("q2_deg", -20.123456), ("q4_deg", 40.5), ("q6_deg", -179.9)] {
        let read = imported.logs[0].table().numbers(name).unwrap();
        assert!((read[0] - expected).abs() < 1e-12, "{name}: {}", read[0]);
    }
}

/// What `simulate` says of an export that cannot say what is meant; nothing may be written.
fn refused(export: &str, join: &str, change: fn(&mut Truth)) -> Problems {
    let (scratch, campaign, mut truth) = campaign(export, LOG, join, false);
    change(&mut truth);
    let before = std::fs::read(scratch.path().join("exports/poses.txt")).unwrap();
    let problems = simulate(&campaign, &truth).expect_err(export);
    assert!(before == std::fs::read(scratch.path().join("exports/poses.txt")).unwrap(), "something was written");
    problems
}

/// Lines of the export, change of the truth, what must be said.
type Refusal = (String, fn(&mut Truth), &'static str);

#[test]
fn what_a_dialect_cannot_say_is_refused_and_not_written_otherwise() {
    let polyworks = |label: &str| format!("format = \"polyworks\"\nunit = \"mm\"\nlabel = \"{label}\"");
    let cases: [Refusal; 5] = [
        (polyworks("{target}_{pose}"), |_| {}, "error[simulated-row-misread]"),
        (polyworks("{target}{pose}{cycle}"), |_| {}, "error[simulated-row"),
        (polyworks("{pose}_{cycle}"), |_| {}, "error[simulated-row"),
        (polyworks("{target}_{pose}_{cycle}"), |t| t.decimals = 100_000, "error[truth-decimals]"),
        (polyworks("{target}\\\" {pose}"), |t| t.cycles = 1, "[row-field-count] fields=5"),
    ];
    for (export, change, part) in cases {
        let said = refused(&export, BY_POSE, change).to_string();
        assert!(said.says(part), "{export}: {said}");
    }
    let comment = "format = { delimiter = \";\", comment = \"\", columns = [\"label\", \"x\", \"y\", \"z\"] }\nunit = \"mm\"\n\
                   label = \"{target}_{pose}_{cycle}\"";
    assert!(refused(comment, BY_POSE, |_| {}).to_string().contains("[row-is-comment]"));
}

/// A campaign with this log, simulated; its points are of no matter.
fn logged(log: &str) -> etalon::stages::gather::Gathered {
    let polyworks = "format = \"polyworks\"\nunit = \"mm\"\nlabel = \"{target}_{pose}_{cycle}\"";
    let (_scratch, campaign, truth) = campaign(polyworks, log, BY_POSE, false);
    simulate(&campaign, &truth).unwrap_or_else(|e| panic!("{log}: {e}"));
    gather(&campaign).unwrap_or_else(|e| panic!("{log}: {e}"))
}

#[test]
fn logs_of_controllers_read_back_what_simulate_wrote() {
    let plain = &logged(LOG).logs[0].table();
    let joints = |table: &Table| ["rho1_mm", "rho2_mm", "rho3_mm"].map(|name| table.numbers(name).unwrap());
    let common = "pose = \"pose\", cycle = \"run\"";
    for (format, columns) in [
        ("ur_rtde", "time_s = \"timestamp\", rho1_mm = \"A\", rho2_mm = \"B\", rho3_mm = \"C\""),
        ("kuka_rsi", "time_ms = \"IPOC\", rho3_mm = \"A\", rho2_mm = \"B\", rho1_mm = \"C\""),
        ("ros", "time_ns = \"%time\", rho1_m = \"c\", rho2_m = \"b\", rho3_m = \"a\""),
    ] {
        let table = &logged(&format!("format = \"{format}\"\ncolumns = {{ {common}, {columns} }}")).logs[0].table();
        for (read, meant) in joints(table).iter().zip(joints(plain)) {
            assert!(read.iter().zip(&meant).all(|(r, m)| (r - m).abs() < 1e-9), "{format}");
        }
        let times = table.numbers("time_s").unwrap();
        assert!(times.iter().zip(1..).all(|(t, n)| *t == 10.0 * f64::from(n)), "{format}");
    }
    // a count is the nearest to the value, whatever order the arrays stand in
    let counts = "format = \"galil\"\ncolumns = { pose = \"pose\", cycle = \"run\", rho1_mm = { name = \"z\", per_count = 0.0005 }, \
                  rho2_mm = { name = \"a\", per_count = -0.001, zero_count = 1000 }, rho3_mm = { name = \"m\", per_count = 0.01 } }";
    let table = &logged(counts).logs[0].table();
    for ((read, meant), per_count) in joints(table).iter().zip(joints(plain)).zip([0.0005f64, 0.001, 0.01]) {
        assert!(read.iter().zip(&meant).all(|(r, m)| (r - m).abs() <= 0.5 * per_count + 1e-9), "{per_count}");
        assert!(read.iter().all(|r| ((r / per_count).round() - r / per_count).abs() < 1e-6), "{per_count}");
    }
}
