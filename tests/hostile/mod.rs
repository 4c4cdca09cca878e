//! Broken campaigns: every error says what, where, what was expected, and a hint; nothing panics, nothing is written.

#[cfg(unix)]
mod attacks_files;
mod attacks_on_data;
mod causes;
mod check;
mod crowds;
mod diagnoses;
mod draws;
mod environment;
mod files;
mod follow_up;
mod fuzz;
mod hints;
mod kinds;
#[cfg(unix)]
mod links;
pub(crate) mod logs;
mod qif;
mod readers;
mod recovery;
mod set_up;
mod together;
mod traps;
mod urdf;

use crate::support::said::{Says, has};
use crate::support::scratch::{copy_sample, ends, etalon};
use etalon::base::phrase;

/// Checks the campaign after one replacement; all `parts` must be said.
fn broken(file: &str, from: &str, to: &str, parts: &[&str]) {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace(file, from, to);
    ends(&scratch, "check", 2, parts);
    assert_eq!(etalon(&scratch, "run").0, Some(2));
    assert!(!scratch.path().join("out").exists(), "something was written");
}

#[test]
fn a_wrong_key_has_its_place_and_a_hint() {
    broken(
        "campaign.toml",
        "coverage_factor = 2",
        "coverage_facter = 2",
        &[
            "[unknown-key]",
            "`coverage_facter`",
            "campaign/campaign.toml:8:1",
            "8 | coverage_facter = 2",
            "did you mean `coverage_factor`?",
            "`coverage_factor` is missing",
        ],
    );
}

#[test]
fn a_missing_unit_is_not_guessed() {
    broken(
        "campaign.toml",
        "file = \"exports/poses.txt\"\nformat = \"polyworks\"\nunit = \"mm\"",
        "file = \"exports/poses.txt\"\nformat = \"polyworks\"",
        &["`unit` is missing", "never guessed"],
    );
}

#[test]
fn a_missing_file_points_at_the_campaign() {
    broken(
        "campaign.toml",
        "exports/world.txt",
        "exports/wrld.txt",
        &["[input-missing]", "`campaign/exports/wrld.txt`", "campaign.toml:12:8"],
    );
}

#[test]
fn a_label_that_no_point_bears() {
    broken(
        "campaign.toml",
        "plane = [\"rail2_a\"",
        "plane = [\"rail2_x\"",
        &["[label-unknown]", "`rail2_x`", "campaign.toml:31:10", "did you mean `rail2_"],
    );
}

#[test]
fn a_path_may_not_leave_the_folder() {
    broken("campaign.toml", "file = \"encoders.csv\"", "file = \"../encoders.csv\"", &["[path-outside]"]);
}

#[test]
fn a_decimal_comma_is_not_read_as_something_else() {
    broken("exports/world.txt", ".", ",", &["[not-a-number]", "exports/world.txt:1", "decimal"]);
}

#[test]
fn a_column_that_the_log_does_not_have() {
    broken("encoders.csv", "RP3", "RP33", &["error[column-unknown]", "`RP3`", "did you mean `RP33`?", "campaign.toml"]);
}

#[test]
fn words_in_a_log_are_reported_with_their_rows() {
    broken("encoders.csv", "\n1,1,0.000000", "\n1,1,x", &["[not-a-number]: `x`", "encoders.csv:2"]);
    broken(
        "encoders.csv",
        "\n1,1,",
        "\n1,x,",
        &["error[pose-misspelt] of=log pose=x log=log", "encoders.csv:2", "use one of: 1"],
    );
}

#[test]
fn an_unknown_parameter_in_hold_and_in_nominal() {
    broken(
        "campaign.toml",
        "[limits]",
        "hold = [\"gama\"]\n[limits]",
        &["[parameter-unknown]", "`gama`", "did you mean `gamma`?"],
    );
    broken("robot.toml", "delta2 = 1.0", "delt2 = 1.0", &["[nominal-unknown]", "`delt2`", "did you mean `delta2`?"]);
}

#[test]
fn everything_that_is_wrong_is_said_at_once() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "coverage_factor = 2", "coverage_factor = \"two\"");
    scratch.replace("campaign.toml", "unit = \"mm\"", "unit = \"millimetres\"");
    scratch.replace("campaign.toml", "[join]", "[jion]");
    let (code, said) = etalon(&scratch, "check");
    assert_eq!(code, Some(2));
    for part in ["coverage_factor", "`millimetres`", "[unknown-key]", "did you mean `join`?"] {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
    assert!(said.matches("`millimetres`").count() >= 2, "both exports are wrong:\n{said}");
}

#[test]
fn every_repeat_needs_its_row_in_the_log_and_only_one() {
    let scratch = copy_sample("prexyt-cmm");
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let row = log.lines().nth(3).unwrap().to_owned() + "\n";
    std::fs::write(scratch.path().join("encoders.csv"), log.replacen(&row, "", 1)).unwrap();
    let (code, said) = etalon(&scratch, "run");
    assert_eq!(code, Some(0), "{said}");
    assert!(said.says("warning[keys-unmatched] of=points count=1") && said.contains("(pose, cycle): [3, 1]"), "{said}");
    std::fs::write(scratch.path().join("encoders.csv"), log + &row).unwrap();
    let (code, said) = etalon(&scratch, "run");
    assert_eq!(code, Some(2));
    assert!(said.contains("error[log-key-twice]") && said.contains("pose 3, cycle 1 (lines 4, 297)"), "{said}");
}

#[test]
fn not_measured_rows_are_refused_and_listed() {
    let scratch = copy_sample("prexyt-cmm");
    let poses = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
    let first = poses.lines().next().unwrap();
    let label = first.split(' ').next().unwrap();
    std::fs::write(scratch.path().join("exports/poses.txt"), poses.replacen(first, &format!("{label} 0 0 0"), 1))
        .unwrap();
    let (code, said) = etalon(&scratch, "run");
    assert_eq!(code, Some(0), "{said}");
    let import = std::fs::read_to_string(scratch.path().join("out/import.json")).unwrap();
    assert!(import.has_phrase("row-at-origin") && import.contains("\"line\": 1"), "{import}");
}

#[test]
fn a_limit_that_is_not_met_is_exit_code_one() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "position_max_mm = 0.044", "position_max_mm = 0.000001");
    let (code, _) = etalon(&scratch, "run");
    assert_eq!(code, Some(1));
    assert!(scratch.path().join("out/report.html").exists());
}

#[test]
fn a_result_that_cannot_be_the_robot_reaches_no_controller() {
    let scratch = copy_sample("prexyt-cmm");
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    assert!(scratch.path().join("out/controller.json").exists());
    // y runs the other way, so does x
    scratch.replace("campaign.toml", "y_axis = [\"R_home\", \"R_end\"]", "y_axis = [\"R_end\", \"R_home\"]");
    let (code, said) = etalon(&scratch, "run");
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("`delta2` = -0.9996") && has(&said, &phrase!("slip-points", change = "y")), "{said}");
    assert!(has(&said, &phrase!("no-controller-files")), "{said}");
    assert!(!scratch.path().join("out/controller.json").exists(), "the file of the run before is still there");
    let report = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(report.has_phrase("parameters-implausible"));
    let export = std::process::Command::new(crate::support::program())
        .args(["export", "campaign/out/parameters.json"])
        .current_dir(scratch.root())
        .output()
        .unwrap();
    assert_eq!(export.status.code(), Some(2));

    // the joints in another order
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "rho2_mm = \"RP2\", rho3_mm = \"RP3\"", "rho2_mm = \"RP3\", rho3_mm = \"RP2\"");
    let (code, said) = etalon(&scratch, "run");
    assert!(code == Some(1) && said.contains("error[measurements-undescribed]"), "{said}");
}

#[test]
fn broken_bytes_do_no_harm() {
    for bytes in [&b"\xff\xfe\x00"[..], b"", b"\x00\x00\x00", b"K_1_1 1 2 3\x00", b"a b c d e f g h\n"] {
        for file in ["exports/poses.txt", "encoders.csv", "campaign.toml", "robot.toml"] {
            let scratch = copy_sample("prexyt-cmm");
            std::fs::write(scratch.path().join(file), bytes).unwrap();
            let (code, said) = etalon(&scratch, "check");
            assert_eq!(code, Some(2), "{file} {bytes:?}\n{said}");
            assert!(said.starts_with("error") && !said.contains("panicked"), "{file} {bytes:?}\n{said}");
        }
    }
}

#[test]
fn selections_that_select_nothing() {
    for (from, to, part) in [
        ("calibration = \"1-8\"", "calibration = \"100-108\"", "error[selection-without-pose]: `calibration`"),
        ("validation = \"9-59\"", "validation = \"90-99\"", "error[selection-without-pose]: `validation`"),
        ("calibration = \"1-8\"", "calibration = \"eight\"", "error[selected-pose-unmeasured]: `eight`"),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", from, to);
        let (code, said) = etalon(&scratch, "run");
        assert_eq!(code, Some(2));
        assert!(said.says(part) && said.contains("campaign.toml:"), "{said}");
    }
}

#[test]
fn too_few_poses_are_said_so() {
    for poses in ["1", "1-2"] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", "calibration = \"1-8\"", &format!("calibration = \"{poses}\""));
        let (_, said) = etalon(&scratch, "run");
        let named = said.contains("[parameter-held-inseparable]") || said.contains("[parameters-inseparable]");
        let named = named || said.contains("[joints-do-not-move]");
        assert!(named && !said.contains("panicked"), "{said}");
    }
}

#[test]
fn log_rows_of_another_width_are_refused() {
    // decimal commas in a file that commas separate
    broken(
        "encoders.csv",
        ".",
        ",",
        &["error[row-field-count]", "encoders.csv:2", "5, as in the header", "decimal comma"],
    );
}

#[test]
fn a_log_name_cannot_be_a_path() {
    broken(
        "campaign.toml",
        "[log]",
        "[log]\nname = \"../../x\"",
        &["error[log-name-invalid]: `../../x`", "campaign.toml:24:8", "name = \"../../x\""],
    );
}

#[test]
fn simulate_does_not_write_over_measured_files() {
    let scratch = copy_sample("prexyt-cmm");
    let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let measured: String = text.lines().filter(|l| !l.starts_with("synthetic")).map(|l| format!("{l}\n")).collect();
    std::fs::write(scratch.path().join("campaign.toml"), measured).unwrap();
    let (code, said) = etalon(&scratch, "simulate");
    assert!(code == Some(2) && said.contains("[campaign-not-synthetic]"), "{said}");
}

#[test]
fn a_target_measured_twice_points_at_both_rows() {
    let scratch = copy_sample("prexyt-cmm");
    let path = scratch.path().join("exports/poses.txt");
    let poses = std::fs::read_to_string(&path).unwrap();
    let first = poses.lines().next().unwrap().to_owned();
    std::fs::write(&path, poses + &first + "\n").unwrap();
    let (code, said) = etalon(&scratch, "check");
    assert_eq!(code, Some(2));
    for part in ["error[target-twice] target=K pose=1 cycle=1", "exports/poses.txt:591", "exports/poses.txt:1;"] {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
}

#[test]
fn a_pose_that_lacks_a_ball_is_said_so() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("exports/poses.txt", "L_3_2 ", "spoiled_3_2_x ");
    let (code, said) = etalon(&scratch, "run");
    assert_eq!(code, Some(0), "{said}");
    assert!(said.says("warning[targets-missing] poses=3"), "{said}");
}

#[test]
fn nothing_left_to_identify_is_an_error_and_not_a_panic() {
    for (file, from, to) in [
        ("campaign.toml", "validation = \"9-59\"", "validation = \"9-59\"\nhold = [\"*\"]"),
        ("robot.toml", "\ns = 394.0", "\ns = 0.0"),
        ("campaign.toml", "expanded_uncertainty_um = 2.7", "expanded_uncertainty_um = 1e-300"),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace(file, from, to);
        let (code, said) = etalon(&scratch, "run");
        assert!(code == Some(2) && said.starts_with("error") && !said.contains("panicked"), "{code:?} {said}");
    }
}

#[test]
fn a_frame_that_its_points_cannot_carry_is_refused() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "towards = \"rail3_a\"", "towards = \"R_end\"");
    let (code, said) = etalon(&scratch, "run");
    assert!(code == Some(2) && said.contains("error[world-side-undetermined]"), "{code:?} {said}");
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "[\"rail2_a\", \"rail2_b\", \"rail3_a\"]", "[\"rail2_a\"]");
    let (code, said) = etalon(&scratch, "run");
    assert!(code == Some(2) && said.contains("error[direction-undetermined]: feature `rails`"), "{said}");
}

#[test]
fn an_empty_campaign_misses_every_key_at_once() {
    let scratch = copy_sample("prexyt-cmm");
    std::fs::write(scratch.path().join("campaign.toml"), "temperature = 20\n").unwrap();
    let (code, said) = etalon(&scratch, "check");
    assert_eq!(code, Some(2));
    for key in ["robot", "instrument", "export", "log", "join", "identify"] {
        assert!(said.says(&format!("[key-missing] key={key}")), "{key}:\n{said}");
    }
    assert!(said.contains("[unknown-key]") && said.has_phrase("did-you-mean name=temperature_c"), "{said}");
}

#[test]
fn a_world_frame_from_three_targets_measured_once() {
    let scratch = copy_sample("prexyt-cmm");
    let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let (head, rest) = text.split_once("[frame.world]").unwrap();
    let (_, tail) = rest.split_once("[identify]").unwrap();
    let frame = "[frame.world]\ntargets = [\"rail2_a\", \"rail3_a\", \"rail2_b\"]\n\n[identify]";
    std::fs::write(scratch.path().join("campaign.toml"), format!("{head}{frame}{tail}")).unwrap();
    // a table has its axes along its rails, this frame has not
    let (code, said) = etalon(&scratch, "check");
    assert_eq!(code, Some(2), "{said}");
    assert!(said.has_phrase("slip-world-frame") && said.contains("[nominal-robot-far]"), "{said}");
    assert_eq!(etalon(&scratch, "run").0, Some(1));
    let frames = std::fs::read_to_string(scratch.path().join("out/frames.json")).unwrap();
    assert!(frames.has_phrase("frame-from-targets targets=rail2_a, rail3_a, rail2_b"), "{frames}");
}

#[test]
fn a_wrong_key_does_not_hide_a_wrong_label_or_file() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "[identify]", "[identify]\ncolour = 1\nhold = [\"gama\"]");
    scratch.replace("campaign.toml", "\"rail2_a\",", "\"rail2_x\",");
    scratch.replace("robot.toml", "model = \"prexyt\"", "model = \"prexyt\"\nsize = 3");
    let (code, said) = etalon(&scratch, "check");
    assert_eq!(code, Some(2));
    for part in ["[unknown-key]", "`colour`", "`size`", "`rail2_x`", "[parameter-unknown]", "`gama`"] {
        assert!(said.says(part), "{part}:\n{said}");
    }
}
