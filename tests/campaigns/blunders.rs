//! The rule about rigid parts works however rows are grouped, and says so where they cannot be.

use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::base::message::Problems;
use etalon::base::phrase;
use etalon::campaign::Campaign;
use etalon::stages::gather::{Gathered, gather};

const RIGID: &str = "[[rigid]]\ntargets = [\"K\", \"L\"]\ntolerance_mm = 0.1\n";
const THREE: &str = "[[rigid]]\ntargets = [\"K\", \"L\", \"M\"]\ntolerance_mm = 0.1\n";

/// Imports exports with these texts; the first export is `a.txt`, the second `b.txt` ...
fn imported(exports: &[(&str, String)], rigid: &str) -> Result<Gathered, Problems> {
    let scratch = copy_sample("prexyt-cmm");
    let mut text = "name = \"b\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\n\
                    coverage_factor = 2\n[log]\nfile = \"encoders.csv\"\ncolumns = { pose = \"pose\", rho1_mm = \"RP1\" }\n\
                    [join]\nby = \"pose\"\n[frame.world]\nas_exported = true\n[identify]\ncalibration = \"all\"\n"
        .to_owned();
    for ((stated, rows), name) in exports.iter().zip(["a.txt", "b.txt", "c.txt"]) {
        std::fs::write(scratch.path().join(name), rows).unwrap();
        text += &format!("[[export]]\nfile = \"{name}\"\nunit = \"mm\"\n{stated}\n");
    }
    std::fs::write(scratch.path().join("campaign.toml"), text + rigid).unwrap();
    gather(&Campaign::read(&scratch.path())?)
}

/// Where target `k` is at a pose: a rigid triangle that moves, but for M at pose 4.
fn place(k: usize, pose: usize) -> String {
    let [x, y] = [[0.0, 0.0], [30.0, 40.0], [0.0, 90.0]][k];
    let off = if k == 2 && pose == 4 { 1.5 } else { 0.0 };
    format!("{} {} 7.5", x + 10.0 * pose as f64 + off, y - 3.0 * pose as f64 + off)
}

fn rows(poses: usize, row: impl Fn(usize, usize) -> Option<String>) -> String {
    let all = (1..=poses).flat_map(|pose| (0..3).map(move |k| (k, pose)));
    all.filter_map(|(k, pose)| row(k, pose)).map(|row| row + "\n").collect()
}

const NAMES: [&str; 3] = ["K", "L", "M"];

/// Name, what each export states and its text, file and line that must be refused.
type Case<'a> = (&'a str, Vec<(&'a str, String)>, (&'a str, usize));

#[test]
fn the_blunder_is_found_by_label_by_column_by_row_and_by_time() {
    let label = rows(6, |k, pose| Some(format!("{}_{pose}_1 {}", NAMES[k], place(k, pose))));
    let column = rows(6, |k, pose| Some(format!("{pose} {} {}", NAMES[k], place(k, pose))));
    let time = rows(6, |k, pose| Some(format!("{}.25 {} {}", 100 * pose, NAMES[k], place(k, pose))));
    let one = |target: usize| rows(6, |k, pose| (k == target).then(|| place(k, pose)));
    let by_row = |name: &str| format!("format = \"polyworks\"\ntarget = \"{name}\"\npose = \"row\"");
    let by_row = NAMES.map(by_row);
    let blank = |role: &str| {
        format!("format = {{ delimiter = \"blank\", columns = [\"{role}\", \"target\", \"x\", \"y\", \"z\"] }}")
    };
    let (by_pose, by_time) = (blank("pose"), blank("time_s"));
    let cases: [Case; 4] = [
        ("label", vec![("format = \"polyworks\"\nlabel = \"{target}_{pose}_{cycle}\"", label)], ("a.txt", 12)),
        ("column", vec![(by_pose.as_str(), column)], ("a.txt", 12)),
        ("time", vec![(by_time.as_str(), time)], ("a.txt", 12)),
        ("row", by_row.iter().enumerate().map(|(k, stated)| (stated.as_str(), one(k))).collect(), ("c.txt", 4)),
    ];
    for (name, exports, expected) in cases {
        let document = imported(&exports, THREE).unwrap_or_else(|e| panic!("{name}: {e}")).document;
        let refused = document.sources.iter().flat_map(|s| s.refused.iter().map(|r| (s.file.as_str(), r.line)));
        assert_eq!(refused.collect::<Vec<_>>(), [expected], "{name}");
        // hypot(1.5, 91.5) - 90
        let reason = &document.sources.iter().find_map(|s| s.refused.first()).unwrap().reason;
        assert!(
            reason.english().has_phrase("rigid-distance-off first=K second=M off_mm=1.512 side=longer limit_mm=0.1"),
            "{reason}"
        );
    }
}

#[test]
fn rows_that_cannot_be_grouped_are_an_error_with_its_place() {
    // one file with both targets: the number of the row tells no pose that they share
    let both = rows(4, |k, pose| (k < 2).then(|| format!("{} {}", NAMES[k], place(k, pose))));
    let stated = "format = { delimiter = \"blank\", columns = [\"target\", \"x\", \"y\", \"z\"] }\npose = \"row\"";
    let said = imported(&[(stated, both)], RIGID).unwrap_err().to_string();
    for part in ["[rigid-never-together]", "K, L ", "campaign.toml:", "targets = [\"K\", \"L\"]", "hint: "] {
        assert!(said.contains(part), "{part}: {said}");
    }
    // the same time for two rows of one target
    let time = rows(4, |k, pose| (k < 2).then(|| format!("{} {} {}", pose / 4, NAMES[k], place(k, pose))));
    let stated = "format = { delimiter = \"blank\", columns = [\"time_s\", \"target\", \"x\", \"y\", \"z\"] }";
    let said = imported(&[(stated, time)], RIGID).unwrap_err().to_string();
    assert!(said.contains("error[rigid-time-twice]") && said.contains("a.txt:3"), "{said}");
}

#[test]
fn a_frame_target_without_pose_or_time_cannot_be_grouped() {
    let text = rows(1, |k, pose| Some(format!("{} {}", NAMES[k], place(k, pose))));
    let stated = "format = { delimiter = \"blank\", columns = [\"target\", \"x\", \"y\", \"z\"] }";
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace(
        "campaign.toml",
        "plane = \"rails\"\norigin = \"R_home\"\ny_axis = [\"R_home\", \"R_end\"]\ntowards = \"rail3_a\"",
        "targets = [\"K\", \"L\", \"M\"]",
    );
    scratch.replace(
        "campaign.toml",
        "format = \"polyworks\"\nunit = \"mm\"\n\n# balls",
        &format!("unit = \"mm\"\n{stated}\n{THREE}\n# balls"),
    );
    std::fs::write(scratch.path().join("exports/world.txt"), text).unwrap();
    let campaign = Campaign::read(&scratch.path()).unwrap();
    // the balls K and L of the sample have poses: the rule trips over the first row that has none
    let said = gather(&campaign).unwrap_err().to_string();
    assert!(said.contains("error[rigid-row-without-pose]") && said.contains("exports/world.txt:1"), "{said}");
}

#[test]
fn a_tolerance_or_targets_that_mean_nothing_are_refused() {
    let label = rows(6, |k, pose| Some(format!("{}_{pose}_1 {}", NAMES[k], place(k, pose))));
    let exports = [("format = \"polyworks\"\nlabel = \"{target}_{pose}_{cycle}\"", label)];
    for (from, to, part) in [
        ("0.1", "nan", "[not-a-measured-value]"),
        ("0.1", "inf", "[not-a-measured-value]"),
        ("0.1", "-0.1", "error[limit-not-positive]: `tolerance_mm`"),
        ("\"L\"", "\"K\"", "error[rigid-targets]"),
        ("\"K\", \"L\"", "", "error[rigid-targets]"),
    ] {
        let said = imported(&exports, &RIGID.replace(from, to)).unwrap_err().to_string();
        assert!(said.contains(part) && said.contains("campaign.toml"), "{to}: {said}");
    }
}

#[test]
fn too_few_poses_for_a_median_are_said() {
    let label = rows(2, |k, pose| Some(format!("{}_{pose}_1 {}", NAMES[k], place(k, pose))));
    let found = imported(&[("format = \"polyworks\"\nlabel = \"{target}_{pose}_{cycle}\"", label)], RIGID).unwrap();
    let said = found.document.messages.iter().any(|m| m.is("rigid-few-distances", &[("count", &2), ("least", &3)]));
    assert!(said, "{:?}", found.document.messages);
}

/// Rows of three targets with a label each; K and L have each other's name at `poses`.
fn exchanged(poses: &[usize]) -> String {
    let name = |k: usize, pose| NAMES[if k < 2 && poses.contains(&pose) { 1 - k } else { k }];
    rows(8, |k, pose| Some(format!("{}_{pose}_1 {}", name(k, pose), place(k, pose))))
}

const LABELLED: &str = "format = \"polyworks\"\nlabel = \"{target}_{pose}_{cycle}\"";

#[test]
fn exchanged_targets_are_named_and_not_the_third_one() {
    let document = imported(&[(LABELLED, exchanged(&[2, 6]))], THREE).unwrap().document;
    let refused: Vec<(usize, &str)> =
        document.sources.iter().flat_map(|s| &s.refused).map(|r| (r.line, r.reason.english())).collect();
    let reason = phrase!("rigid-targets-exchanged", first = "K", second = "L").to_string();
    // M at pose 4 is off alone
    assert_eq!(refused.iter().map(|r| r.0).collect::<Vec<_>>(), [4, 5, 12, 16, 17]);
    assert!(refused.iter().all(|r| (r.1 == reason) == (r.0 != 12)), "{refused:?}");
}

#[test]
fn a_target_whose_rows_are_all_refused_is_in_the_exports() {
    // half of the poses: the median is that of neither
    let problems = imported(&[(LABELLED, exchanged(&[1, 2, 3, 5]))], THREE).unwrap_err();
    let is_m = |m: &etalon::base::message::Message| {
        m.is("rigid-target-refused", &[("target", &"M"), ("rows", &8), ("file", &"a.txt"), ("line", &3)])
    };
    assert_eq!(problems.0.iter().filter(|m| m.id == "rigid-target-refused").count(), 1, "{problems}");
    assert!(problems.0.iter().any(is_m), "{problems}");
}
