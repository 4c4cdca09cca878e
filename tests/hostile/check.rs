//! What `etalon check` finds: everything at once, each with its place.

use super::{broken, ends, etalon};
use crate::support::said::Says;
use crate::support::scratch::copy_sample;

#[test]
fn unreadable_rows_hide_nothing() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("exports/poses.txt", "K_1_1 ", "K_1_1 1,5x");
    scratch.replace("encoders.csv", "\n1,1,0.000000", "\n1,1,one");
    scratch.replace("campaign.toml", "\"rail3_a\"]", "\"rail3_b\"]");
    scratch.replace("campaign.toml", "calibration = \"1-8\"", "calibration = \"1001-1008\"");
    scratch.replace("campaign.toml", "position_max_mm = 0.044", "position_max_mm = -1.0");
    scratch.replace("robot.toml", "[nominal]", "bending = [2]\n\n[nominal]\nseven = 7.0");
    let parts = [
        "[not-a-number]: `1,5x",
        "exports/poses.txt:1:7",
        "[not-a-number]: `one`",
        "encoders.csv:2:5",
        "[label-unknown]",
        "`rail3_b`",
        "error[selection-without-pose]: `calibration`",
        "error[key-not-positive]: `position_max_mm`",
        "campaign.toml:46:19",
        "[key-of-other-model] key=bending",
    ];
    ends(&scratch, "check", 2, &parts);
}

#[test]
fn what_only_a_run_used_to_find_is_found_by_check() {
    broken("campaign.toml", "\"1-8\"", "\"1-12\"", &["error[sets-overlap]", "10", "11", "12"]);
    let axis = "y_axis = [\"R_home\", \"R_end\"]";
    broken(
        "campaign.toml",
        axis,
        "y_axis = [\"R_home\"]",
        &["error[frame-axis-without-direction]", "campaign.toml:36:11"],
    );
    let rails = "plane = [\"rail2_a\", \"rail2_b\", \"rail3_a\"]";
    broken(
        "campaign.toml",
        rails,
        "plane = [\"R_home\"]",
        &["error[direction-undetermined]: feature `rails`", "campaign.toml:31:10"],
    );
    broken(
        "campaign.toml",
        "by = [\"pose\", \"cycle\"]",
        "by = \"row\"",
        &["[row-counts-differ] file=exports/poses.txt rows=590 log=log log_rows=295"],
    );
}

#[test]
fn tables_without_poses_are_found_by_check() {
    let table = |poses: &str, parts: &[&str]| {
        let scratch = copy_sample("prexyt-geometric");
        scratch.replace("campaign.toml", "poses = \"14-18\"", &format!("poses = \"{poses}\""));
        let (code, said) = etalon(&scratch, "check");
        assert_eq!(code, Some(2), "{said}");
        parts.iter().for_each(|part| assert!(said.says(part), "{part:?} is not said:\n{said}"));
    };
    let none = "error[table-selection-empty]";
    table("60-70", &[none, "poses = \"60-70\""]);
    table("x", &["poses = \"x\""]);
}

#[test]
fn statements_that_mean_nothing_or_contradict_are_refused() {
    let robot = |to: &str, parts: &[&str]| broken("robot.toml", "[nominal]", to, parts);
    robot(
        "[nominal]\nbetta = 1.0",
        &["[nominal] contains `betta`", "robot.toml:", "betta = 1.0", "did you mean `beta`?"],
    );
    robot("gravity = [0, 0, -1]\n[nominal]", &["[key-of-other-model] key=gravity", "robot.toml:"]);
    broken(
        "robot.toml",
        "travel_mm = [170.0, 300.0, 300.0]",
        "type1_margin_deg = 5.0",
        &["[key-of-other-model] key=type1_margin_deg", "five_bar"],
    );
    broken("robot.toml", "l_kl = 146.0", "l_kl = nan", &["[not-a-measured-value]", "`nan`", "robot.toml:"]);
    let campaign = |from: &str, to: &str, parts: &[&str]| broken("campaign.toml", from, to, parts);
    campaign(
        "coverage_factor = 2",
        "coverage_factor = 0",
        &["[key-not-positive]", "`coverage_factor`", "campaign.toml:8:19"],
    );
    campaign(
        "position_max_mm = 0.044",
        "position_max_mm = inf",
        &["[not-a-measured-value]", "`inf`", "campaign.toml:"],
    );
    campaign("towards = \"rail3_a\"", "towards = \"rail3_a\"\neach = \"pose\"", &["[key-of-other-frame]: `each`"]);
    campaign(
        "\"cycle\"]",
        "\"cycle\"]\ntargets = [\"K\", \"M\"]",
        &["error[target-not-of-robot]: `M`", "campaign.toml:29:17"],
    );
    campaign("robot = \"robot.toml\"", "robot = \"robot.toml\"\noutput = \"exports\"", &["[input-in-output-folder]"]);
    campaign("rho3_mm = \"RP3\"", "rho3_mm = \"RP3\", rho3_m = \"RP1\"", &["error[log-column-twice]: `rho3_mm`"]);
    let arm = |from: &str, to: &str, parts: &[&str]| {
        if crate::reference_data("robots/irb120_faro_ets").is_none() {
            return;
        }
        let scratch = copy_sample("abb-irb120");
        scratch.replace("robot.toml", from, to);
        let (code, said) = etalon(&scratch, "check");
        assert_eq!(code, Some(2), "{said}");
        for part in parts {
            assert!(said.says(part), "{part:?} is not said:\n{said}");
        }
    };
    arm(
        "bending = [2, 3]",
        "bending = [2, 3, 2, 9]",
        &[
            "[joint-reference-wrong] fault=twice joint=2",
            "[joint-reference-wrong] fault=unknown-number joint=9",
            "robot.toml:",
        ],
    );
}

#[test]
fn logs_that_do_not_look_as_stated() {
    let scratch = copy_sample("prexyt-cmm");
    let text = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), text.replace(',', ";")).unwrap();
    let (code, said) = etalon(&scratch, "check");
    assert!(code == Some(2) && said.contains("error[delimiter-does-not-split]"), "{said}");
    assert!(said.contains("hint: set `delimiter = \";\"` and `decimal = \".\"`"), "{said}");
    broken("encoders.csv", "\n1,1,", "\n1e300,1,", &["[not-whole-number]", "encoders.csv:2:1"]);
}

#[test]
fn a_table_of_observations_is_refused_with_file_and_line() {
    let scratch = copy_sample("prexyt-cmm");
    let head = "pose,cycle,target,x_mm,y_mm,rho1_mm,rho2_mm,rho3_mm\n";
    for (text, parts) in [
        (format!("{head}1,1,K,1,2,3,4,5\n1,1,L,1,x,3,4,5\n"), ["observations.csv:3", "[not-a-number]: `x`"]),
        (format!("{head}1.5,1,K,1,2,3,4,5\n"), ["observations.csv", "[not-whole-number]: `1.5`"]),
        (head.replace("rho2_mm", "rho2") + "1,1,K,1,2,3,4,5\n", ["observations.csv", "[column-unknown]"]),
        (format!("{head}1,1,K,1,2,3,4,5\n1,1,K,1,2,3,4,5\n"), ["observations.csv:3", "[target-repeated]"]),
    ] {
        std::fs::write(scratch.root().join("observations.csv"), text).unwrap();
        let output = std::process::Command::new(crate::support::program())
            .args(["identify", "--robot", "campaign/robot.toml", "--observations", "observations.csv"])
            .current_dir(scratch.root())
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(parts.iter().all(|part| said.says(part)), "{parts:?}:\n{said}");
    }
}

#[test]
fn conditions_that_no_test_has_are_refused() {
    let stated = |line: &str, parts: &[&str]| {
        broken("campaign.toml", "[instrument]", &format!("[conditions]\n{line}\n\n[instrument]"), parts);
    };
    stated("load_kg = -1", &["[key-negative]: `load_kg`", "load_kg = -1"]);
    stated("velocities_percent = [100, 0]", &["[key-not-positive]", "`velocities_percent`"]);
    stated("humidity_percent = 101", &["[key-above-maximum]: `humidity_percent`"]);
    stated("mass_kg = 1.0", &["[unknown-key]", "`mass_kg`"]);
    stated("load_centre_mm = [0.0, 1.0]", &["load_centre_mm"]);
}

#[test]
fn a_report_that_cannot_be_dressed_is_refused() {
    let dressed = |line: &str, parts: &[&str]| {
        broken("campaign.toml", "[instrument]", &format!("[report]\n{line}\n\n[instrument]"), parts);
    };
    dressed("language = \"es\"", &["unknown value `es`", "language = \"es\""]);
    dressed("country = \"UK\"", &["unknown country code `UK`", "country = \"UK\""]);
    dressed("logo = \"logo.svg\"", &["cannot read `", "logo.svg", "logo = \"logo.svg\""]);
    dressed("logo = \"robot.toml\"", &["[logo-unusable]", "an SVG or PNG picture"]);
    dressed("logo = \"../logo.svg\"", &["[path-outside]"]);
    dressed("templates = \"exports\"", &["[no-templates]", "--write-templates"]);
    dressed("templates = \"none\"", &["[cannot-read-folder]", "templates = \"none\""]);
}

#[test]
fn values_that_mean_nothing_are_refused() {
    let log = "file = \"encoders.csv\"";
    broken("campaign.toml", log, "file = \"\"", &["[file-name-empty]", "campaign.toml:"]);
    let first = "name = \"PreXYT, CMM (synthetic)\"";
    let date = "[date-invalid]";
    for (stated, part) in [
        ("date = \"31.02.2026\"", date),
        ("date = \"2026-02-29\"", date),
        ("date = \"2026-13-01\"", date),
        ("date = \"yesterday\"", date),
        ("temperature_c = -500.0", "[temperature-implausible]"),
        ("temperature_c = 293.15", "[temperature-implausible]"),
    ] {
        broken("campaign.toml", first, &format!("{first}\n{stated}"), &[part, "campaign.toml:2:"]);
    }
    let scratch = copy_sample("prexyt-geometric");
    scratch.replace("campaign.toml", "lead_mm = 5.080", "lead_mm = 0.0");
    scratch.replace("campaign.toml", "\nlength_mm = ", "\nlength_mm = -");
    ends(&scratch, "check", 2, &["[key-not-positive]: `lead_mm`", "[key-not-positive]: `length_mm`"]);
    for good in ["2024-02-29", "2026-03-02 to 2026-03-04"] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", first, &format!("{first}\ndate = \"{good}\""));
        assert_eq!(etalon(&scratch, "check").0, Some(0), "{good}");
    }
}

#[test]
fn what_every_row_repeats_is_one_error_with_its_count() {
    let quote = |row: &str| row.replacen(',', "\"x,", 1).replacen("", "\"", 1);
    let letters = |row: &str| format!("{row}e");
    type Change<'a> = &'a dyn Fn(&str) -> String;
    let cases: [(&str, usize, Change, &str, &str); 3] = [
        ("encoders.csv", 1, &quote, "quote-unmatched", " fault=behind"),
        ("encoders.csv", 1, &letters, "not-a-number", ""),
        ("exports/poses.txt", 0, &letters, "not-a-number", ""),
    ];
    for (file, header, change, id, arguments) in cases {
        let scratch = copy_sample("prexyt-cmm");
        let text = std::fs::read_to_string(scratch.path().join(file)).unwrap();
        let mut rows: Vec<String> = text.lines().map(str::to_owned).collect();
        rows.iter_mut().skip(header).for_each(|row| *row = change(row));
        std::fs::write(scratch.path().join(file), rows.join("\n") + "\n").unwrap();
        let (second, third, more) = (header + 2, header + 3, rows.len() - header - 3);
        let (message, lines) = (format!("[{id}]"), format!(" {second}, {third} and {more} "));
        for command in ["check", "run"] {
            let said = ends(&scratch, command, 2, &[&format!("{message}{arguments}"), &lines]);
            assert_eq!(said.matches(&message).count(), 1, "{file}: {said}");
        }
        let mut command = std::process::Command::new(crate::support::program());
        let answer = command.args(["check", "campaign", "--json"]).current_dir(scratch.root()).output().unwrap().stdout;
        let answer = String::from_utf8(answer).unwrap();
        assert!(answer.contains(&lines) && answer.matches(&format!("\"{id}\"")).count() == 1, "{answer}");
    }
}
