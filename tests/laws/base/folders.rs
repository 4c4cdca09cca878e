//! Output folders: of one run or refused, whatever stops a run, and over no input. Here and not among the hostile files
//! because a run is short in the release profile.

use crate::support::root;
use crate::support::run_for;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends, etalon, said};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

pub fn run(scratch: &Scratch) {
    let (code, said) = etalon(scratch, "run");
    assert!(matches!(code, Some(0 | 1)), "{said}");
}

/// Names and bytes of the files of a folder.
pub fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap());
    let file = |path: PathBuf| (path.file_name().unwrap().to_str().unwrap().to_owned(), std::fs::read(path).unwrap());
    entries.filter(|entry| entry.path().is_file()).map(|entry| file(entry.path())).collect()
}

/// Hidden files and folders beside the output folder: what a stopped run may leave.
pub fn litter(scratch: &Scratch) -> Vec<String> {
    let entries = std::fs::read_dir(scratch.path()).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.starts_with('.')).collect()
}

/// How often a run is stopped or set beside another one: `ETALON_STOPS`.
fn stops(otherwise: u32) -> u32 {
    std::env::var("ETALON_STOPS").ok().and_then(|n| n.parse().ok()).unwrap_or(otherwise)
}

#[test]
fn an_output_folder_is_of_one_run_and_keeps_what_others_put_there() {
    let scratch = copy_sample("prexyt-cmm");
    run(&scratch);
    let out = scratch.path().join("out");
    std::fs::write(out.join("notes.txt"), "mine").unwrap();
    std::fs::create_dir(out.join("photos")).unwrap();
    std::fs::write(out.join("photos/a.png"), "picture").unwrap();
    let first = files(&out);
    assert!(first.contains_key("etalon_parameters.h") && first.contains_key("manifest.json"), "{:?}", first.keys());
    // parameters that cannot be the robot: no controller file of the earlier run stays
    scratch.replace("encoders.csv", "RP3", "RP0");
    scratch.replace("encoders.csv", "RP2", "RP3");
    scratch.replace("encoders.csv", "RP0", "RP2");
    assert_eq!(etalon(&scratch, "run").0, Some(1));
    let second = files(&out);
    assert!(
        !second.contains_key("etalon_parameters.h") && !second.contains_key("controller.csv"),
        "{:?}",
        second.keys()
    );
    assert_eq!(second["notes.txt"], b"mine");
    assert_eq!(std::fs::read(out.join("photos/a.png")).unwrap(), b"picture");
    assert_eq!(litter(&scratch), Vec::<String>::new());
}

#[test]
fn a_mixed_or_damaged_folder_is_refused_by_name() {
    let scratch = copy_sample("prexyt-cmm");
    run(&scratch);
    let out = scratch.path().join("out");
    let first = files(&out);
    std::fs::rename(&out, scratch.root().join("first")).unwrap();
    scratch.replace("campaign.toml", "coverage_factor = 2", "coverage_factor = 2.5");
    run(&scratch);
    let second = files(&out);
    let refused = |name: &str, bytes: &[u8]| {
        std::fs::write(out.join(name), bytes).unwrap();
        let all = [
            &["report", "campaign/out"][..],
            &["compare", "first", "campaign/out"],
            &["export", "campaign/out/parameters.json"],
        ];
        for arguments in all {
            if arguments[0] == "export" && name != "parameters.json" || arguments[0] == "compare" && name.ends_with("t")
            {
                continue;
            }
            let causes =
                ["[file-changed-since-run]", "[file-not-of-run]", "[document-unreadable]", "[stored-table-damaged]"];
            let (code, said) = said(&scratch, arguments);
            assert_eq!(code, Some(2), "{arguments:?} with another {name}: {said}");
            assert!(said.contains(name) && causes.iter().any(|id| said.says(id)), "{said}");
        }
        std::fs::write(out.join(name), &second[name]).unwrap();
    };
    for name in ["parameters.json", "accuracy.json", "residuals.parquet"] {
        assert_ne!(first[name], second[name], "{name}");
        refused(name, &first[name]);
    }
    let parquet = &second["residuals.parquet"];
    refused("residuals.parquet", &[&parquet[..parquet.len() / 2], b"\0\0", &parquet[parquet.len() / 2..]].concat());
    refused("campaign.json", b"{}");
    assert_eq!(said(&scratch, &["report", "campaign/out"]).0, Some(0));
    // the report is made again and belongs to the run
    assert_eq!(said(&scratch, &["report", "campaign/out", "--language", "de"]).0, Some(0));
    assert_eq!(said(&scratch, &["compare", "first", "campaign/out"]).0, Some(0));
    std::fs::remove_file(out.join("manifest.json")).unwrap();
    let (code, said) = said(&scratch, &["report", "campaign/out"]);
    assert!(code == Some(2) && said.contains("manifest.json"), "{said}");
}

#[test]
fn parameters_alone_are_refused_where_their_parts_do_not_belong_together() {
    let scratch = copy_sample("prexyt-cmm");
    run(&scratch);
    let text = std::fs::read_to_string(scratch.path().join("out/parameters.json")).unwrap();
    let alone = scratch.root().join("p.json");
    let exported = |text: &str| {
        std::fs::write(&alone, text).unwrap();
        said(&scratch, &["export", "p.json", "--to", "controller"])
    };
    assert_eq!(exported(&text).0, Some(0));
    let refused = |change: &dyn Fn(&mut serde_json::Value), part: &str| {
        let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
        change(&mut value);
        let (code, said) = exported(&value.to_string());
        assert!(code == Some(2) && said.says(part), "{part}: {code:?} {said}");
    };
    refused(&|v| v["schema"] = "etalon/parameters/9".into(), "etalon/parameters/9");
    refused(&|v| drop(v["covariance"].as_array_mut().unwrap().pop()), "covariance is not a square matrix");
    refused(&|v| drop(v["covariance"][2].as_array_mut().unwrap().pop()), "covariance is not a square matrix");
    refused(&|v| v["parameters"][0]["standard_uncertainty"] = (-0.1).into(), "is negative");
    refused(&|v| v["covariance"][0][0] = (-1e-9).into(), "is negative");
    refused(&|v| v["parameters"][1]["name"] = v["parameters"][0]["name"].clone(), "twice");
}

#[test]
fn an_input_that_changes_while_it_is_read_stops_the_run() {
    let scratch = copy_sample("prexyt-cmm");
    run(&scratch);
    let out = files(&scratch.path().join("out"));
    // a campaign that is read, and then written to before its run ends
    let campaign = etalon::campaign::Campaign::read(&scratch.path()).unwrap();
    let text = std::fs::read_to_string(scratch.path().join("robot.toml")).unwrap();
    std::fs::write(scratch.path().join("robot.toml"), text + "\n").unwrap();
    let problems = etalon::run::pipeline::run(&campaign).unwrap_err().to_string();
    assert!(problems.contains("[input-changed]: `robot.toml`"), "{problems}");
    assert_eq!(files(&scratch.path().join("out")), out);
    assert_eq!(litter(&scratch), Vec::<String>::new());
}

#[test]
fn a_folder_that_cannot_be_written_loses_nothing() {
    let scratch = copy_sample("prexyt-cmm");
    run(&scratch);
    let out = files(&scratch.path().join("out"));
    // a file in the way of the new folder
    std::fs::create_dir(scratch.path().join(".out.lock")).unwrap();
    let (code, said) = etalon(&scratch, "run");
    assert!(code == Some(2) && said.contains("cannot write") && said.contains("[earlier-run-left]"), "{said}");
    assert_eq!(files(&scratch.path().join("out")), out);
}

#[cfg(unix)]
#[test]
fn the_verdict_outlives_a_reader_who_has_closed_the_pipe() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "position_max_mm = 0.044", "position_max_mm = 0.0044");
    let code = |redirected: &str, arguments: &str| {
        let line = format!("{} {arguments} {redirected}", env!("CARGO_BIN_EXE_etalon"));
        let mut shell = Command::new("bash");
        shell.args(["-c", &line]).current_dir(scratch.root()).stderr(Stdio::null()).status().unwrap().code()
    };
    let closed = "| true; exit ${PIPESTATUS[0]}";
    assert_eq!(code(closed, "run campaign"), Some(1));
    assert_eq!(code(closed, "run campaign --json"), Some(1));
    assert_eq!(code(">&-", "run campaign"), Some(1));
    assert_eq!(code(closed, "check campaign/exports --json"), Some(2));
    if Path::new("/dev/full").exists() {
        assert_eq!(code("> /dev/full", "run campaign"), Some(1));
        scratch.replace("campaign.toml", "position_max_mm = 0.0044", "position_max_mm = 0.044");
        // the folder is complete
        assert_eq!(code("> /dev/full", "run campaign"), Some(0));
        assert_eq!(code("> /dev/full", "run campaign --json"), Some(0));
        assert_eq!(code("> /dev/full", "report campaign/out"), Some(0));
        assert_eq!(code("> /dev/full", "export campaign/out/parameters.json"), Some(0));
        assert_eq!(code("> /dev/full", "batch campaign"), Some(0));
        // an answer that is only printed is lost
        assert_eq!(code("> /dev/full", "schema campaign"), Some(2));
        let said = said(&scratch, &["report", "campaign/out"]);
        assert_eq!(said.0, Some(0), "{}", said.1);
    }
}

#[test]
fn no_output_is_written_over_an_input() {
    let scratch = copy_sample("prexyt-cmm");
    let kept = |name: &str, arguments: &[&str], part: &str| {
        let path = scratch.root().join(name);
        let before = std::fs::read(&path).unwrap();
        let (code, said) = said(&scratch, arguments);
        assert!(code == Some(2) && said.says(part), "{arguments:?}: {code:?} {said}");
        assert!(std::fs::read(&path).unwrap() == before, "{name} was written over");
    };
    let write = |name: &str, text: &str| std::fs::write(scratch.root().join(name), text).unwrap();
    let moved = |i: i32| if (40..60).contains(&i) { i - 40 } else { 20 * i32::from(i >= 60) };
    let rows: String = (0..100).map(|i| format!("{},{},0,0\n", f64::from(i) / 20.0, moved(i))).collect();
    write("s.csv", &format!("time_s,x_mm,y_mm,z_mm\n{rows}"));
    kept("s.csv", &["iso9283", "--stream", "s.csv", "--write-poses", "s.csv"], "error[output-is-input]");
    write("c.csv", "pose,rho1_mm,rho2_mm,rho3_mm\n1,10,20,30\n2,20,10,5\n3,40,40,20\n");
    let plan = ["plan", "--robot", "campaign/robot.toml", "--candidates", "c.csv", "--positions", "2"];
    kept("c.csv", &[&plan[..], &["--poses", "./c.csv"]].concat(), "error[output-is-input]");
    kept("campaign/robot.toml", &[&plan[..], &["--report", "campaign/robot.toml"]].concat(), "error[not-a-report]");
    std::fs::copy(scratch.path().join("robot.toml"), scratch.path().join("robot.html")).unwrap();
    let plan = plan.map(|argument| if argument.ends_with("robot.toml") { "campaign/robot.html" } else { argument });
    kept("campaign/robot.html", &[&plan[..], &["--report", "campaign/robot.html"]].concat(), "error[output-is-input]");
    write("programme.csv", "mine");
    let plan = ["iso9283", "--plan", "--write", ".", "--workspace-mm", "350,250,430,330"];
    kept("programme.csv", &plan, "error[file-exists]: `./programme.csv`");
    assert_eq!(std::fs::read(scratch.root().join("programme.csv")).unwrap(), b"mine");
    // an output folder that leads, also through a link, to an input's
    #[cfg(unix)]
    std::os::unix::fs::symlink("exports", scratch.path().join("link")).unwrap();
    for folder in ["exports", "./exports", ".", if cfg!(unix) { "link" } else { "exports" }] {
        let stated = format!("robot = \"robot.toml\"\noutput = \"{folder}\"");
        scratch.replace("campaign.toml", "robot = \"robot.toml\"", &stated);
        let refused = if folder == "link" { "[output-through-link]" } else { "[input-in-output-folder]" };
        ends(&scratch, "run", 2, &[refused]);
        scratch.replace("campaign.toml", &stated, "robot = \"robot.toml\"");
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_or_a_device_in_the_place_of_any_input_is_refused_at_once() {
    let scratch = copy_sample("prexyt-cmm");
    let pipe = |path: PathBuf| assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
    for name in ["robot.toml", "campaign.toml", "encoders.csv", "exports/world.txt"] {
        let path = scratch.path().join(name);
        let kept = std::fs::read(&path).unwrap();
        for device in [false, true] {
            std::fs::remove_file(&path).unwrap();
            match device {
                true => std::os::unix::fs::symlink("/dev/zero", &path).unwrap(),
                false => pipe(path.clone()),
            }
            let mut child = Command::new(env!("CARGO_BIN_EXE_etalon"))
                .args(["check", "campaign"])
                .current_dir(scratch.root())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            let ended = (0..100).find_map(|_| {
                std::thread::sleep(Duration::from_millis(50));
                child.try_wait().unwrap()
            });
            let _ = child.kill();
            assert_eq!(ended.and_then(|status| status.code()), Some(2), "{name}, device {device}");
        }
        std::fs::remove_file(&path).unwrap();
        std::fs::write(&path, kept).unwrap();
    }
}

#[test]
fn tables_and_scans_may_be_larger_than_what_a_person_writes() {
    let scratch = copy_sample("prexyt-cmm");
    let moved = |i: u32| f64::from(i / 1000 % 2) * 20.0;
    let rows: String =
        (0..600_000).map(|i| format!("{:.3},{:.6},0.000000,0.000000\n", f64::from(i) / 1e3, moved(i))).collect();
    assert!(rows.len() > 17 << 20);
    std::fs::write(scratch.root().join("s.csv"), format!("time_s,x_mm,y_mm,z_mm\n{rows}")).unwrap();
    std::fs::write(scratch.root().join("p.csv"), "pose,x_mm,y_mm,z_mm\n1,0,0,0\n2,20,0,0\n").unwrap();
    let (code, said_of) = said(&scratch, &["iso9283", "--stream", "s.csv", "--commanded", "p.csv"]);
    assert!(matches!(code, Some(0 | 1)), "{said_of}");
    let columns = ["--columns", "-,x,y,z", "--delimiter", "comma", "--header", "1", "--unit", "mm"];
    let (code, said_of) = said(&scratch, &[&["fit", "line", "s.csv"][..], &columns].concat());
    assert_eq!(code, Some(0), "{said_of}");
}

#[test]
fn control_characters_reach_no_terminal() {
    let scratch = copy_sample("prexyt-cmm");
    let forged = "\\u001b[31mred\\n  --> forged.toml:1\\u2069\\u202e";
    scratch.replace("campaign.toml", "towards = \"rail3_a\"", &format!("towards = \"{forged}\""));
    let said = ends(&scratch, "check", 2, &["[point-or-feature-unknown]"]);
    assert!(!said.contains('\u{1b}') && !said.contains("\n  --> forged") && !said.contains('\u{202e}'), "{said}");
    scratch.replace("campaign.toml", forged, "rail3_a");
    scratch.replace("campaign.toml", "name = \"", &format!("name = \"{forged} "));
    let output = Command::new(env!("CARGO_BIN_EXE_etalon"))
        .args(["run", "campaign"])
        .current_dir(scratch.root())
        .output()
        .unwrap();
    let shown = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    assert!(shown.contains("red") && !shown.contains('\u{1b}') && !shown.contains('\u{202e}'), "{shown}");
    let page = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(!page.contains('\u{1b}'));
}

#[test]
fn a_byte_order_mark_is_part_of_the_recorded_bytes() {
    let scratch = copy_sample("prexyt-cmm");
    let text = std::fs::read_to_string(scratch.path().join("robot.toml")).unwrap();
    let marked = format!("\u{feff}{text}");
    std::fs::write(scratch.path().join("robot.toml"), &marked).unwrap();
    run(&scratch);
    let import: serde_json::Value = scratch.document("import.json");
    let robot = import["sources"].as_array().unwrap().iter().find(|s| s["kind"] == "robot").unwrap();
    assert_eq!(robot["sha256"], etalon::base::files::sha256(marked.as_bytes()));
    assert_eq!(robot["bytes"], marked.len());
}

#[test]
fn a_template_that_does_not_end_is_stopped() {
    let scratch = copy_sample("prexyt-repeatability");
    std::fs::create_dir(scratch.path().join("own")).unwrap();
    scratch.replace("campaign.toml", "[instrument]", "[report]\ntemplates = \"own\"\n\n[instrument]");
    let template = |name: &str, text: &str| {
        std::fs::write(scratch.path().join("own").join(name), text).unwrap();
        ends(&scratch, "run", 2, &[&format!("[template-failed] fault=memory template={name}")]);
        assert!(!scratch.path().join("out").exists());
        std::fs::remove_file(scratch.path().join("own").join(name)).unwrap();
    };
    template(
        "report.html",
        "{% set ns = namespace(x=\"x\") %}{% for i in range(60) %}{% set ns.x = ns.x ~ ns.x %}{% endfor %}",
    );
    if cfg!(feature = "pdf") {
        template("report.typ", "#let grow(x) = grow(x + x)\n#{ let x = \"x\"; for i in range(60) { x = x + x } }");
    }
}

#[test]
fn a_killed_run_leaves_the_earlier_folder_or_the_new_one_and_the_next_clears_the_rest() {
    let scratch = copy_sample("prexyt-cmm");
    run(&scratch);
    let out = scratch.path().join("out");
    let states = [files(&out), {
        scratch.replace("campaign.toml", "coverage_factor = 2", "coverage_factor = 2.5");
        run(&scratch);
        files(&out)
    }];
    let begun = std::time::Instant::now();
    run(&scratch);
    let whole = begun.elapsed();
    let mut found = [0, 0];
    let rounds = stops(16);
    for i in 0..rounds {
        let (from, to) = if i % 2 == 0 { ("2.5", "2") } else { ("2", "2.5") };
        scratch.replace("campaign.toml", &format!("coverage_factor = {from}\n"), &format!("coverage_factor = {to}\n"));
        let mut child = Command::new(env!("CARGO_BIN_EXE_etalon"))
            .args(["run", "campaign"])
            .current_dir(scratch.root())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        // the second half of a run, in which it writes
        std::thread::sleep(whole.mul_f64(0.5 + 0.6 * f64::from(i) / f64::from(rounds)));
        child.kill().unwrap();
        child.wait().unwrap();
        let left = files(&out);
        let state = states.iter().position(|state| *state == left);
        let state = state.unwrap_or_else(|| panic!("a mixed folder after stop {i}: {:?}", left.keys()));
        found[usize::from(state == usize::from(to == "2.5"))] += 1;
        let (code, said) = said(&scratch, &["report", "campaign/out"]);
        assert_eq!(code, Some(0), "{said}");
        run(&scratch);
        assert_eq!(litter(&scratch), Vec::<String>::new(), "after stop {i}");
        assert_eq!(files(&out), states[usize::from(to == "2.5")], "after stop {i}");
    }
    println!("stopped {rounds} times: {} kept the earlier folder, {} had the new one", found[0], found[1]);
}

/// A day in 1971 and one in 2100: what a clock that was set shows.
const DAYS: [u64; 2] = [365 * 86_400, 47_482 * 86_400];

#[test]
fn neither_clock_nor_locale_nor_time_zone_change_a_byte() {
    let scratch = copy_sample("prexyt-cmm");
    let set_clock = |folder: &Path, seconds: u64| {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file())
        {
            let file = std::fs::OpenOptions::new().append(true).open(entry).unwrap();
            file.set_modified(std::time::UNIX_EPOCH + Duration::from_secs(seconds)).unwrap();
        }
    };
    let mut runs = Vec::new();
    for (i, locale) in ["C", "de_DE.UTF-8", "tr_TR.UTF-8"].into_iter().enumerate() {
        if let Some(seconds) = DAYS.get(i) {
            set_clock(&scratch.path(), *seconds);
            set_clock(&scratch.path().join("exports"), *seconds);
        }
        let mut command = Command::new(env!("CARGO_BIN_EXE_etalon"));
        command
            .args(["run", "campaign"])
            .current_dir(scratch.root())
            .env("TZ", ["UTC", "Pacific/Kiritimati", "Asia/Kathmandu"][i]);
        let output =
            ["LANG", "LC_ALL", "LC_NUMERIC", "LC_TIME"].iter().fold(&mut command, |c, key| c.env(key, locale)).output();
        let output = output.unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        runs.push((output.stdout, output.stderr, files(&scratch.path().join("out"))));
    }
    assert!(
        runs.windows(2).all(|pair| pair[0] == pair[1]),
        "{:?}",
        runs.iter().map(|run| run.2.keys()).collect::<Vec<_>>()
    );
    // a batch goes by what files hold, and the run is one that it need not do again
    let batch = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_etalon"));
        let output = command.args(["batch", "campaign", "--json"]).current_dir(scratch.root()).output().unwrap();
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        document["campaigns"][0]["computed"].as_bool().unwrap()
    };
    for seconds in DAYS {
        set_clock(&scratch.path(), seconds);
        set_clock(&scratch.path().join("out"), DAYS[1] - seconds);
        assert!(!batch());
    }
}

#[test]
fn two_runs_at_once_end_with_the_files_of_one() {
    let scratch = copy_sample("prexyt-cmm");
    for i in 0..stops(6) {
        let children: Vec<_> = (0..2)
            .map(|_| {
                let mut command = Command::new(env!("CARGO_BIN_EXE_etalon"));
                command.args(["run", "campaign"]).current_dir(scratch.root()).stdout(Stdio::null()).spawn().unwrap()
            })
            .collect();
        for mut child in children {
            assert!(matches!(child.wait().unwrap().code(), Some(0 | 1)), "round {i}");
        }
        let (code, said) = said(&scratch, &["report", "campaign/out"]);
        assert_eq!(code, Some(0), "{said}");
        assert_eq!(litter(&scratch), Vec::<String>::new());
    }
}

/// Copies of a sample in one folder: `a` is whole, `b` has a limit that is not met, `c` a wrong key, `d` data that are not there.
fn four() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a", "b", "c", "d"] {
        let scratch = copy_sample("prexyt-cmm");
        match name {
            "b" => scratch.replace("campaign.toml", "position_max_mm = 0.044", "position_max_mm = 0.0044"),
            "c" => scratch.replace("campaign.toml", "coverage_factor", "coverage_facter"),
            "d" => scratch.replace("campaign.toml", "\"encoders.csv\"", "\"$ETALON_NO_SUCH/encoders.csv\""),
            _ => {}
        }
        std::fs::rename(scratch.path(), folder.path().join(name)).unwrap();
    }
    folder
}

#[test]
fn a_batch_runs_what_has_changed_and_goes_on_where_one_fails() {
    let folder = four();
    std::fs::write(folder.path().join("list.txt"), "# all of them\na\n\nb\nc\nd\n").unwrap();
    let batch = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_etalon"));
        let output = command.arg("batch").args(arguments).current_dir(folder.path()).output().unwrap();
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap_or_default();
        (output.status.code(), document, String::from_utf8(output.stderr).unwrap())
    };
    let computed = |document: &serde_json::Value| -> Vec<bool> {
        document["campaigns"].as_array().unwrap().iter().map(|c| c["computed"].as_bool().unwrap()).collect()
    };
    let (code, document, said) = batch(&["list.txt", "--documents", "--json"]);
    assert_eq!(code, Some(2), "{said}");
    let counts = ["done", "not_met", "failed", "skipped"].map(|name| document[name].as_u64().unwrap());
    assert_eq!(counts, [1, 1, 1, 1], "{document}");
    assert_eq!(computed(&document), [true, true, false, false]);
    assert!(said.contains("unknown key `coverage_facter`") && said.contains("$ETALON_NO_SUCH"), "{said}");
    let a = files(&folder.path().join("a/out"));
    assert!(a.contains_key("parameters.json") && !a.contains_key("report.html"));
    let bytes = std::fs::read(folder.path().join("batch.parquet")).unwrap();
    use polars_io::SerReader;
    let table = polars_io::parquet::read::ParquetReader::new(std::io::Cursor::new(&bytes)).finish().unwrap();
    let rows = etalon::formats::parquet::table(&table).unwrap();
    let column = |name: &str| rows.texts(name).unwrap();
    let (campaigns, kinds, items) = (column("campaign"), column("kind"), column("item"));
    let values = table.column("value").unwrap().f64().unwrap().clone();
    let parameters: serde_json::Value = serde_json::from_slice(&a["parameters.json"]).unwrap();
    for parameter in parameters["parameters"].as_array().unwrap() {
        let name = parameter["name"].as_str().unwrap();
        let row = (0..campaigns.len()).find(|&i| campaigns[i] == "a" && kinds[i] == "parameter" && items[i] == name);
        assert_eq!(values.get(row.unwrap()), parameter["value"].as_f64(), "{name}");
    }
    assert!(kinds.iter().zip(&campaigns).any(|(kind, campaign)| kind == "limit" && campaign == "b"));
    assert!(campaigns.iter().all(|c| c == "a" || c == "b"));
    // again: nothing has changed
    let (code, document, _) = batch(&["list.txt", "--documents", "--json"]);
    assert_eq!((code, computed(&document)), (Some(2), vec![false; 4]));
    assert_eq!(std::fs::read(folder.path().join("batch.parquet")).unwrap(), bytes);
    // a power cut cut off what was not synced yet
    std::fs::write(folder.path().join("a/out/residuals.parquet"), b"PAR1").unwrap();
    assert_eq!(computed(&batch(&["list.txt", "--documents", "--json"]).1), [true, false, false, false]);
    assert_eq!(files(&folder.path().join("a/out")), a);
    assert_eq!(std::fs::read(folder.path().join("batch.parquet")).unwrap(), bytes);
    let page = std::fs::read_to_string(folder.path().join("batch.html")).unwrap();
    assert!(
        page.contains("4 campaigns of 1 robots")
            && page.contains("1 pass, 0 conditional, 1 undecided, 0 fail, 1 not run, 1 skipped")
    );
    assert!(!page.contains("report.html\""), "a link to a report that is not there");
    // with reports, and after a change of one
    assert_eq!(computed(&batch(&["a", "b", "--json"]).1), [true, true]);
    let page = std::fs::read_to_string(folder.path().join("batch.html")).unwrap();
    assert!(page.contains("href=\"b&#x2f;out&#x2f;report.html\""), "{page}");
    let robot = folder.path().join("b/robot.toml");
    std::fs::write(&robot, std::fs::read_to_string(&robot).unwrap() + "\n").unwrap();
    let (code, document, _) = batch(&["a", "b", "--json"]);
    assert_eq!((code, computed(&document)), (Some(1), vec![false, true]));
    assert_eq!(batch(&["a"]).0, Some(0));
    let (code, _, said) = batch(&["a", "./a", "a"]);
    assert!(code == Some(2) && said.says("[campaign-twice] folder=a"), "{said}");
}

#[test]
fn a_batch_of_many_campaigns_ends_on_the_stack_and_in_the_memory_of_a_few() {
    let folder = tempfile::tempdir().unwrap();
    let scratch = copy_sample("prexyt-cmm");
    let names: Vec<String> = (0..100).map(|i| format!("c{i}")).collect();
    for name in &names {
        let campaign = folder.path().join(name);
        std::fs::create_dir_all(campaign.join("exports")).unwrap();
        for file in ["campaign.toml", "robot.toml", "encoders.csv", "exports/world.txt", "exports/poses.txt"] {
            std::fs::copy(scratch.path().join(file), campaign.join(file)).unwrap();
        }
    }
    std::fs::write(folder.path().join("list.txt"), names.join("\n")).unwrap();
    for threads in ["1", "2"] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_etalon"));
        command.args(["batch", "list.txt", "--documents", "--json"]).env("RAYON_NUM_THREADS", threads);
        let output = command.current_dir(folder.path()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{said}"));
        assert_eq!((output.status.code(), &document["done"]), (Some(0), &100.into()), "{said}");
        let first = files(&folder.path().join("c0/out"));
        for name in &names {
            assert_eq!(files(&folder.path().join(name).join("out")), first, "{name}");
            std::fs::remove_dir_all(folder.path().join(name).join("out")).unwrap();
        }
    }
}

/// Peak of the resident memory of a run of a folder, bytes.
fn peak_of_run(folder: &Path) -> f64 {
    let mut command = Command::new(env!("CARGO_BIN_EXE_etalon"));
    let ended = run_for(command.args(["run", "campaign"]).current_dir(folder), Duration::from_secs(600)).unwrap();
    assert_eq!(ended.code, Some(0));
    ended.peak
}

/// The world plane of a campaign as a scan: what each further row takes is a small multiple of the row.
#[test]
fn a_large_export_takes_a_small_multiple_of_its_size() {
    let scratch = copy_sample("prexyt-cmm");
    let plain = std::fs::read_to_string(scratch.path().join("exports/world.txt")).unwrap();
    let of_scan = |rows: usize| {
        let mut noise = etalon::base::noise::Noise::new(17, rows as u64);
        let corners: Vec<(&str, Vec<f64>)> = ["rail2_a", "rail2_b", "rail3_a"]
            .into_iter()
            .map(|name| {
                let line = plain.lines().find(|line| line.starts_with(name)).unwrap();
                (name, line.split(' ').skip(1).map(|v| v.parse().unwrap()).collect())
            })
            .collect();
        let mut text = plain.clone();
        for i in 0..rows {
            let (name, at) = &corners[i % 3];
            let [x, y, z] = std::array::from_fn(|k| at[k] + noise.gaussian(0.00135));
            text.push_str(&format!("{name} {x:.5} {y:.5} {z:.5}\n"));
        }
        std::fs::write(scratch.path().join("exports/world.txt"), &text).unwrap();
        (text.len() as f64, peak_of_run(scratch.root()))
    };
    let ((few, before), (many, after)) = (of_scan(50_000), of_scan(550_000));
    let times = (after - before) / (many - few);
    println!("{times:.1} bytes of memory a byte of the export");
    assert!(times < 9.0, "{times:.1}");
}

#[test]
fn the_makefile_needs_no_more_than_gnu_make_3_81() {
    let text = std::fs::read_to_string(root().join("Makefile")).unwrap();
    // of the release notes of 3.82 to 4.4; `.SHELLFLAGS` is ignored before 3.82
    let newer = [
        ".ONESHELL",
        "undefine ",
        "private ",
        "!=",
        "::=",
        "&:",
        "$(file ",
        "$(guile ",
        "$(let ",
        "$(intcmp ",
        ".EXTRA_PREREQS",
        ".WAIT",
        "load ",
        "--output-sync",
        ".SHELLSTATUS",
        ".NOTINTERMEDIATE",
    ];
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let found = newer.iter().find(|feature| line.contains(**feature));
        assert!(found.is_none() && !(line.starts_with("define ") && line.contains('=')), "{found:?} in `{line}`");
        // a recipe of several commands ends where one of them fails, without `-e`
        assert!(!line.contains("; done") || line.contains("|| exit") || line.contains("exit $$bad"), "{line}");
    }
}

#[cfg(unix)]
#[test]
fn make_runs_what_has_changed_and_lists_how_each_ended() {
    let folder = four();
    let program = env!("CARGO_BIN_EXE_etalon");
    let make = |arguments: &[&str]| {
        let mut command = Command::new("make");
        command.args(["-s", "-o", program, &format!("ETALON={program}"), "CARGO_TARGET_DIR=target"]).args(arguments);
        command.arg("-f").arg(root().join("Makefile")).arg("CAMPAIGNS=a b c d");
        for inherited in ["MAKEFLAGS", "MFLAGS", "MAKELEVEL"] {
            command.env_remove(inherited);
        }
        let output = command.current_dir(folder.path()).output().unwrap();
        let said = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        (output.status.success(), said)
    };
    for (file, text) in [("Cargo.toml", ""), ("Cargo.lock", ""), ("src/lib.rs", "")] {
        std::fs::create_dir_all(folder.path().join("src")).unwrap();
        std::fs::write(folder.path().join(file), text).unwrap();
    }
    let listed = |said: &str| -> Vec<String> {
        let ended = |name: &str| {
            let line = said.lines().find(|line| line.split_whitespace().next() == Some(name)).unwrap_or("none");
            line.split_whitespace().skip(1).collect::<Vec<_>>().join(" ")
        };
        ["a", "b", "c", "d"].map(ended).to_vec()
    };
    let (met, said) = make(&["-j2"]);
    assert_eq!((met, listed(&said)), (false, ["done", "not met", "failed", "skipped"].map(str::to_owned).to_vec()));
    let (_, said) = make(&[".SHELLFLAGS=-c"]); // all that GNU make 3.81 passes
    let unchanged = ["done, unchanged", "not met, unchanged", "failed", "skipped"];
    assert_eq!(listed(&said), unchanged, "{said}");
    assert_eq!(listed(&make(&["-k", "-j2"]).1), unchanged);
    let (met, said) = make(&["clean-a"]);
    assert!(met && !folder.path().join("a/out").exists() && folder.path().join("b/out").exists(), "{said}");
    assert_eq!(listed(&make(&[]).1)[..2], ["done", "not met, unchanged"]);
    // of an earlier program
    let earlier = std::fs::metadata(program).unwrap().modified().unwrap() - Duration::from_secs(1);
    let manifest = std::fs::OpenOptions::new().append(true).open(folder.path().join("b/out/manifest.json")).unwrap();
    manifest.set_modified(earlier).unwrap();
    assert_eq!(listed(&make(&[]).1)[..2], ["done, unchanged", "not met"]);
    assert_eq!(listed(&make(&[]).1), unchanged);
}
