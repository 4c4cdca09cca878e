//! Attacks by files, folders, names and other processes: nothing hangs, nothing is mixed or lost, no
//! name is executed or steers a terminal.

use super::links;
use crate::support::root;
use crate::support::scratch::{Scratch, copy_sample, ends, etalon, said};
use crate::support::{Ended, program, run_for};
use etalon::base::noise::Noise;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::rc::Rc;
use std::time::{Duration, Instant};

/// A command beyond this hangs.
const LIMIT: Duration = Duration::from_secs(120);

/// The files of a folder by their names.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file());
    entries.map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), std::fs::read(path).unwrap())).collect()
}

/// Hidden files beside the output folder.
fn litter(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
    names.filter(|name| name.starts_with('.')).collect()
}

/// `etalon ARGUMENTS` in a folder, which must end in time and without a panic.
fn command(folder: &Path, arguments: &[&OsStr]) -> Ended {
    let mut command = Command::new(program());
    command.args(arguments).current_dir(folder);
    let ended = run_for(&mut command, LIMIT).unwrap_or_else(|| panic!("it hangs: {arguments:?}"));
    assert!(matches!(ended.code, Some(0..=2)) && !ended.stderr.contains("panicked"), "{arguments:?}: {ended:?}");
    ended
}

fn mkfifo(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

fn random(noise: &mut Noise, bound: usize) -> usize {
    (((noise.uniform(1.0) + 1.0) * 0.5 * bound as f64) as usize).min(bound.saturating_sub(1))
}

/// Copies of the sample with readings of their own: no result of one is of use for another.
fn different_campaigns(folder: &Path, count: usize) -> Vec<String> {
    let scratch = copy_sample("prexyt-cmm");
    let poses = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
    let make = |i: usize| {
        let name = format!("c{i}");
        let to = folder.join(&name);
        std::fs::create_dir_all(to.join("exports")).unwrap();
        for file in ["campaign.toml", "robot.toml", "encoders.csv", "exports/world.txt"] {
            std::fs::copy(scratch.path().join(file), to.join(file)).unwrap();
        }
        // another last digit
        let row = |(k, line): (usize, &str)| {
            let (start, digit) = line.split_at(line.len() - 1);
            format!("{start}{}\n", (digit.parse::<usize>().unwrap() + 7 * i + k * (i + 3)) % 10)
        };
        let rows: String = poses.lines().enumerate().map(row).collect();
        std::fs::write(to.join("exports/poses.txt"), rows).unwrap();
        name
    };
    (0..count).map(make).collect()
}

/// Issue 47, item 2: typst remembered every step of every report.
#[test]
fn a_batch_with_reports_takes_the_memory_of_a_few() {
    let peak = |count: usize| {
        let folder = tempfile::tempdir().unwrap();
        let names = different_campaigns(folder.path(), count);
        let mut command = Command::new(program());
        command.arg("batch").args(names).current_dir(folder.path()).env("RAYON_NUM_THREADS", "2");
        let ended = run_for(&mut command, Duration::from_secs(600)).unwrap();
        assert_eq!(ended.code, Some(0), "{ended:?}");
        ended.peak
    };
    let (few, many) = (peak(6), peak(24));
    println!("{:.0} MB of 6 campaigns, {:.0} MB of 24", few / 1e6, many / 1e6);
    // 28 MB a campaign before
    assert!(many - few < 18.0 * 5e6, "{few} {many}");
}

/// Issue 47, item 3: a report or a controller file of an earlier run was written into the folder of a later
/// one, with its manifest.
#[test]
fn report_and_export_beside_a_run_leave_the_folder_of_one_run() {
    let scratch = copy_sample("prexyt-cmm");
    let out = scratch.path().join("out");
    let factors = ["2", "2.5"];
    let mut whole = Vec::new();
    for (from, to) in [("2", "2.5"), ("2.5", "2")] {
        scratch.replace("campaign.toml", &format!("coverage_factor = {from}\n"), &format!("coverage_factor = {to}\n"));
        assert_eq!(etalon(&scratch, "run").0, Some(0));
        whole.push(files(&out));
    }
    whole.reverse();
    let begun = Instant::now();
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let takes = begun.elapsed().as_millis() as usize;
    let mut noise = Noise::new(47, 3);
    let mut refused = 0;
    let rounds = std::env::var("ETALON_STOPS").ok().and_then(|n| n.parse().ok()).unwrap_or(8);
    for round in 0..rounds {
        let [from, to] = [factors[round % 2], factors[1 - round % 2]];
        scratch.replace("campaign.toml", &format!("coverage_factor = {from}\n"), &format!("coverage_factor = {to}\n"));
        let start = |arguments: &[&str]| {
            let mut command = Command::new(program());
            command.args(arguments).current_dir(scratch.root()).stdout(Stdio::null()).stderr(Stdio::piped());
            command.spawn().unwrap()
        };
        let run = start(&["run", "campaign"]);
        std::thread::sleep(Duration::from_millis(random(&mut noise, takes) as u64));
        let others = [
            start(&["report", "campaign/out"]),
            start(&["export", "campaign/out/parameters.json"]),
            start(&["report", "campaign"]),
        ];
        let run = run.wait_with_output().unwrap();
        assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
        for other in others {
            let output = other.wait_with_output().unwrap();
            let said = String::from_utf8(output.stderr).unwrap();
            match output.status.code() {
                Some(0) => {}
                code => {
                    refused += 1;
                    let known = said.contains("[folder-replaced]") || said.contains("[not-an-output-folder]");
                    assert!(code == Some(2) && known, "round {round}: {said}");
                }
            }
        }
        let found = files(&out);
        let same: Vec<_> =
            found.iter().filter(|(name, bytes)| whole[1 - round % 2].get(*name) != Some(*bytes)).collect();
        let names: Vec<_> = same.iter().map(|(name, _)| *name).collect();
        assert!(names.is_empty() && found.len() == whole[0].len(), "round {round}, {refused} refused: {names:?}");
        assert_eq!(litter(&scratch.path()), Vec::<String>::new());
    }
    println!("{refused} of {} refused", 3 * rounds);
}

/// Issue 47, item 5: an input that is a pipe or a device since the last run was opened to be hashed.
#[test]
fn a_batch_ends_where_an_input_became_a_pipe_or_a_device() {
    let scratch = copy_sample("prexyt-cmm");
    assert_eq!(said(&scratch, &["batch", "campaign"]).0, Some(0));
    let input = scratch.path().join("exports/poses.txt");
    let special: [&dyn Fn(); 3] =
        [&|| mkfifo(&input), &|| symlink("/dev/zero", &input).unwrap(), &|| std::fs::create_dir(&input).unwrap()];
    for make in special {
        let _ = std::fs::remove_file(&input);
        make();
        let mut command = Command::new(program());
        command.args(["batch", "campaign"]).current_dir(scratch.root());
        let ended = run_for(&mut command, Duration::from_secs(30)).expect("it hangs");
        assert!(ended.code == Some(2) && ended.stderr.contains("exports/poses.txt"), "{ended:?}");
    }
}

/// `make TARGET` of the project in another folder, with the program that was built.
fn make(folder: &Path, arguments: &[&OsStr]) -> Ended {
    std::fs::create_dir_all(folder.join("src")).unwrap();
    for file in ["Cargo.toml", "Cargo.lock", "src/lib.rs"] {
        std::fs::write(folder.join(file), "").unwrap();
    }
    let mut command = Command::new("make");
    let program = program();
    command.args(["-s", "-o", program, &format!("ETALON={program}"), "CARGO_TARGET_DIR=target"]);
    command.arg("-f").arg(root().join("Makefile")).args(arguments);
    for inherited in ["MAKEFLAGS", "MFLAGS", "MAKELEVEL", "CAMPAIGNS"] {
        command.env_remove(inherited);
    }
    run_for(command.current_dir(folder), LIMIT).expect("make hangs")
}

/// Issue 47, item 6: names of folders were a part of rules and of commands of the shell.
#[test]
fn make_executes_no_name_and_one_bad_name_stops_no_campaign() {
    let names: [&[u8]; 14] = [
        b"plain",
        b"x&touch pwned&y",
        b"x&id>pwned&y",
        b"a;touch pwned",
        b"$(touch pwned)",
        b"`touch pwned`",
        b"$(shell touch pwned)",
        b"a=b",
        b"a#b",
        b"a:b",
        b"it's",
        b"two words",
        b"(a%b)*?[c]",
        b"n\xff",
    ];
    let folder = tempfile::tempdir().unwrap();
    let sample = copy_sample("prexyt-cmm");
    for name in names {
        let to = folder.path().join("campaigns").join(OsStr::from_bytes(name));
        std::fs::create_dir_all(to.parent().unwrap()).unwrap();
        let copied = Command::new("cp").arg("-r").arg(sample.path()).arg(&to).status().unwrap();
        assert!(copied.success());
    }
    let pwned = || {
        let found = Command::new("find").arg(folder.path()).args(["-name", "pwned"]).output().unwrap().stdout;
        String::from_utf8(found).unwrap()
    };
    let out = |name: &[u8]| folder.path().join("campaigns").join(OsStr::from_bytes(name)).join("out");
    let whole = |of: &[&[u8]]| {
        let first = files(&out(b"plain"));
        for name in of {
            assert!(out(name).is_dir(), "{}", String::from_utf8_lossy(name));
            assert!(files(&out(name)) == first, "{}", String::from_utf8_lossy(name));
        }
    };
    // names that are stated one by one hold no blanks
    let single: Vec<&[u8]> = names.into_iter().filter(|name| !name.contains(&b' ')).collect();
    let stated: Vec<Vec<u8>> = single.iter().map(|name| [b"campaigns/", *name].concat()).collect();
    let stated = [&b"CAMPAIGNS="[..], &stated.join(&b' ')].concat();
    let ended = make(folder.path(), &[OsStr::from_bytes(&stated)]);
    assert_eq!((ended.code, pwned().as_str()), (Some(0), ""), "{ended:?}");
    whole(&single);
    let ended = make(folder.path(), &[]);
    assert_eq!((ended.code, pwned().as_str()), (Some(0), ""), "{ended:?}");
    assert!(ended.stdout.contains("14 done"), "{ended:?}");
    whole(&names);
    // one that does not read
    std::fs::write(folder.path().join("campaigns/a=b/campaign.toml"), "x").unwrap();
    let ended = make(folder.path(), &[]);
    assert!(
        ended.code == Some(2) && ended.stdout.contains("13 done") && ended.stdout.contains("1 failed"),
        "{ended:?}"
    );
    // of the others some are reported
    names[8..].iter().for_each(|name| std::fs::remove_dir_all(out(name)).unwrap());
    std::fs::remove_dir_all(folder.path().join("campaigns/a=b")).unwrap();
    for target in ["report", "compare"] {
        let ended = make(folder.path(), &[target.as_ref()]);
        assert!(matches!(ended.code, Some(0 | 2)) && pwned().is_empty(), "{ended:?}");
        assert!(ended.code == Some(0) || target == "compare", "{ended:?}");
    }
    let ended = make(folder.path(), &["clean-$(touch pwned)".as_ref()]);
    assert!(pwned().is_empty(), "{ended:?}");
    let ended = make(folder.path(), &["clean-x&id>pwned&y".as_ref()]);
    assert!(ended.code == Some(0) && pwned().is_empty(), "{ended:?}");
    assert!(!out(b"x&id>pwned&y").exists() && out(b"plain").exists());
    let ended = make(folder.path(), &["clean".as_ref()]);
    assert_eq!((ended.code, pwned().as_str()), (Some(0), ""), "{ended:?}");
    assert!(names.iter().all(|name| !out(name).exists()));
}

/// Issue 47, item 9: exports refuse names that are formulas, and so do tables of observations.
#[test]
fn no_cell_that_is_written_is_a_formula() {
    let formula = "=cmd|'/C calc'!A0";
    let scratch = copy_sample("draw-wire");
    scratch.replace("observations.csv", ",ball,", &format!(",{formula},"));
    for command in ["check", "run"] {
        ends(&scratch, command, 2, &["error[name-is-formula]", "`=cmd|'/C calc'!A0`", "observations.csv:2:12"]);
    }
    let arguments = ["identify", "--robot", "campaign/robot.toml", "--observations", "campaign/observations.csv"];
    let (code, said) = said(&scratch, &arguments);
    assert!(code == Some(2) && said.contains("error[name-is-formula]"), "{said}");
    // nor does a simulation write one
    let scratch = copy_sample("column-arm");
    scratch.replace("truth.toml", "label = \"floor_1\"", &format!("label = \"{formula}\""));
    ends(&scratch, "simulate", 2, &["error[point-label-formula]"]);
    // a remark is carried along
    let scratch = copy_sample("draw-wire");
    let table = std::fs::read_to_string(scratch.path().join("observations.csv")).unwrap();
    let remarked = |(i, line): (usize, &str)| match i {
        0 => format!("{line},remark\n"),
        i => format!("{line},{}\n", [formula, "-1.5", "@a", "fine"][i % 4]),
    };
    let table: String = table.lines().enumerate().map(remarked).collect();
    std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
    assert!(matches!(etalon(&scratch, "run").0, Some(0 | 1)));
    let mut found = 0;
    for (name, bytes) in files(&scratch.path().join("out")).into_iter().filter(|(name, _)| name.ends_with(".csv")) {
        for cell in String::from_utf8(bytes).unwrap().split(['\n', ',']) {
            let text = cell.trim_matches('"');
            let formula = text.starts_with(['=', '+', '-', '@']) && text.parse::<f64>().is_err();
            assert!(!formula, "{name}: {cell}");
            found += usize::from(text.starts_with("'="));
        }
    }
    assert!(found > 10, "the remarks are there: {found}");
}

/// Issue 47, item 10: a path that is not UTF-8 was opened by the name that messages show.
#[test]
fn folders_whose_names_are_not_utf8_are_read() {
    for sample in ["prexyt-cmm", "column-arm"] {
        let scratch = copy_sample(sample);
        let parent = scratch.root().join(OsStr::from_bytes(b"p\xff"));
        let campaign = parent.join(OsStr::from_bytes(b"c\xfe"));
        std::fs::create_dir(&parent).unwrap();
        std::fs::rename(scratch.path(), &campaign).unwrap();
        for name in ["check", "run", "batch", "report"] {
            let ended = command(scratch.root(), &[name.as_ref(), campaign.as_ref()]);
            assert_eq!(ended.code, Some(0), "{ended:?}");
        }
        let ended = command(scratch.root(), &["export".as_ref(), campaign.join("out/parameters.json").as_ref()]);
        assert_eq!(ended.code, Some(0), "{ended:?}");
    }
}

/// Issue 47, item 11: letters that PDF/A forbids, or that no font has, failed the run.
#[test]
fn any_letter_in_a_name_is_typeset() {
    let names = [
        "\u{feff}x",
        "\u{1f600}",
        "a\u{feff}\u{2764}\u{fe0f}",
        "\u{1f468}\u{200d}\u{1f469}",
        "1\u{fe0f}\u{20e3}",
        "\u{fffe}",
    ];
    for name in names {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", "name = \"PreXYT, CMM (synthetic)\"", &format!("name = \"{name}\""));
        scratch.replace("campaign.toml", "Mitutoyo BRIGHT-STRATO 7106", name);
        ends(&scratch, "run", 0, &[]);
    }
    // names of poses are in pictures
    let scratch = copy_sample("pose-test");
    for file in ["exports/poses.txt", "exports/visits.txt", "poses.csv", "commanded.csv"] {
        let path = scratch.path().join(file);
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        std::fs::write(&path, text.replace("P1", "\u{feff}\u{2764}\u{fe0f}a\u{64b}")).unwrap();
    }
    let (code, said) = etalon(&scratch, "run");
    assert!(!said.contains("cannot typeset"), "{code:?} {said}");
}

/// Issue 47, item 12: files of others in `out/` were taken for files of an earlier run by their names.
#[test]
fn an_output_folder_of_others_loses_nothing() {
    let scratch = copy_sample("prexyt-cmm");
    let out = scratch.path().join("out");
    std::fs::create_dir(&out).unwrap();
    let mine = ["calibrated.urdf", "genserkins.hal", "notes.txt"];
    mine.iter().for_each(|name| std::fs::write(out.join(name), "mine").unwrap());
    let kept = || mine.iter().all(|name| std::fs::read(out.join(name)).is_ok_and(|bytes| bytes == b"mine"));
    for _ in 0..2 {
        ends(&scratch, "run", 0, &[]);
        assert!(kept());
    }
    // one that the run would write itself
    let scratch = copy_sample("prexyt-cmm");
    let out = scratch.path().join("out");
    for name in ["report.html", "controller.json", "manifest.json"] {
        let _ = std::fs::remove_dir_all(&out);
        std::fs::create_dir(&out).unwrap();
        std::fs::write(out.join(name), "{\"mine\": 1}").unwrap();
        ends(&scratch, "run", 2, &[&format!("[foreign-file]: `campaign/out/{name}`"), "hint: move it"]);
        assert_eq!(files(&out).into_iter().collect::<Vec<_>>(), [(name.to_owned(), b"{\"mine\": 1}".to_vec())]);
        assert_eq!(litter(&scratch.path()), Vec::<String>::new());
    }
    // a manifest that a power cut cut off
    std::fs::remove_dir_all(&out).unwrap();
    ends(&scratch, "run", 0, &[]);
    let whole = files(&out);
    for cut in [0, 100] {
        std::fs::write(out.join("manifest.json"), &whole["manifest.json"][..cut]).unwrap();
        std::fs::write(out.join("calibrated.urdf"), "of the earlier run").unwrap();
        ends(&scratch, "run", 0, &[]);
        assert!(files(&out) == whole);
    }
}

/// Issue 47, item 13: a link in the place of a lock is not followed, and a lock that could not be written does
/// not stay.
#[test]
fn a_lock_is_a_file_of_etalon_or_none() {
    let scratch = copy_sample("prexyt-cmm");
    let (lock, victim) = (scratch.path().join(".out.lock"), scratch.root().join("victim"));
    std::fs::write(&victim, "mine").unwrap();
    let special: [&dyn Fn(); 4] = [
        &|| symlink(&victim, &lock).unwrap(),
        &|| symlink("nowhere", &lock).unwrap(),
        &|| std::fs::hard_link(&victim, &lock).unwrap(),
        &|| mkfifo(&lock),
    ];
    for make in special {
        make();
        ends(&scratch, "run", 2, &["campaign/.out.lock` is not a lock of etalon", "hint: remove it"]);
        assert_eq!(std::fs::read(&victim).unwrap(), b"mine");
        assert!(!scratch.path().join("nowhere").exists() && !scratch.path().join("out").exists());
        std::fs::remove_file(&lock).unwrap();
    }
    // the name of a new file
    symlink(&victim, scratch.root().join(".batch.html.new")).unwrap();
    assert_eq!(said(&scratch, &["batch", "campaign"]).0, Some(0));
    assert_eq!(std::fs::read(&victim).unwrap(), b"mine");
    // what a killed process left is taken over
    std::fs::write(&lock, "12345").unwrap();
    ends(&scratch, "run", 0, &[]);
    assert_eq!(litter(&scratch.path()), Vec::<String>::new());
    // a disk that is full while the lock is written
    let mut strace = Command::new("strace");
    strace.args(["-f", "-qq", "-o", "/dev/null", "-P"]).arg(&lock);
    strace.args(["-e", "trace=write", "-e", "inject=write:error=ENOSPC"]).arg(program()).args(["run", "campaign"]);
    let Ok(output) = strace.current_dir(scratch.root()).output() else {
        return println!("skipped: there is no strace");
    };
    let said = String::from_utf8(output.stderr).unwrap();
    if said.contains("strace:") {
        return println!("skipped: strace may not trace");
    }
    assert!(output.status.code() == Some(2) && said.contains("No space left"), "{said}");
    assert_eq!(litter(&scratch.path()), Vec::<String>::new());
}

/// `true` if a text would do something to a terminal but be read.
fn steers(text: &str) -> bool {
    let turns = |c: char| matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{2028}' | '\u{2029}');
    text.chars().any(|c| c != '\n' && c.is_control() || turns(c))
}

/// Issue 47, item 16: names of folders and files reach a terminal with their controls replaced.
#[test]
fn no_name_steers_a_terminal() {
    let name = "a\u{1b}[31m\u{202e}b\rc";
    let scratch = copy_sample("prexyt-cmm");
    std::fs::rename(scratch.path(), scratch.root().join(name)).unwrap();
    let inside = |file: &str| format!("{name}/{file}");
    let (out, parameters, robot) = (inside("out"), inside("out/parameters.json"), inside("robot.toml"));
    let (fresh, table, missing) = (inside("new"), inside("exports/world.txt"), inside("none"));
    let joints = inside("encoders.csv");
    let commands: [&[&str]; 19] = [
        &["check", name],
        &["run", name],
        &["batch", name],
        &["batch", &missing],
        &["report", &out],
        &["report", &out, "--certificate"],
        &["report", &missing],
        &["export", &parameters],
        &["export", &parameters, "--format", name],
        &["compare", name, &out],
        &["init", &fresh],
        &["init", &fresh],
        &["fit", "plane", &table],
        &["formats", &table],
        &["validate", name],
        &["kinematics", "direct", &joints, "--robot", &robot],
        &["recommend", name],
        &["run", name, name],
        &["run", "none", "--skip-missing", &format!("--{name}")],
    ];
    for arguments in commands {
        let ended = command(scratch.root(), &arguments.iter().map(|a| OsStr::new(*a)).collect::<Vec<_>>());
        for text in [&ended.stdout, &ended.stderr] {
            assert!(!steers(text), "{arguments:?}: {text:?}");
        }
    }
    let skipped = Scratch::with(&[]);
    let sample = copy_sample("prexyt-cmm");
    sample.replace("campaign.toml", "\"encoders.csv\"", "\"$ETALON_NO_SUCH/encoders.csv\"");
    std::fs::rename(sample.path(), skipped.root().join(name)).unwrap();
    let ended = command(skipped.root(), &["run".as_ref(), "--skip-missing".as_ref(), name.as_ref()]);
    assert!(ended.code == Some(0) && !steers(&ended.stderr), "{ended:?}");
}

/// Sets a campaign with its results under random attacks: `ETALON_ATTACK_SECONDS` states for how
/// long, `ETALON_ATTACK_SEED` the seed, and `ETALON_ATTACK_ONLY` one attack by its number.
#[test]
fn random_attacks_do_no_harm() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let seed = number("ETALON_ATTACK_SEED").unwrap_or(47);
    let lasts = Duration::from_secs(number("ETALON_ATTACK_SECONDS").unwrap_or(10));
    let only = number("ETALON_ATTACK_ONLY");
    let sample = copy_sample("prexyt-cmm");
    assert_eq!(etalon(&sample, "run").0, Some(0));
    let whole = Rc::new(files(&sample.path().join("out")));
    let (begun, mut counts) = (Instant::now(), [0; KINDS.len()]);
    for number in only.unwrap_or(0).. {
        if begun.elapsed() > lasts || only.is_some_and(|only| only != number) {
            break;
        }
        let mut noise = Noise::new(seed, number);
        let kind = random(&mut noise, KINDS.len());
        // shown where the attack fails
        println!("ETALON_ATTACK_SEED={seed} ETALON_ATTACK_ONLY={number}: {}", KINDS[kind].0);
        let copy = tempfile::tempdir().unwrap();
        let copied = Command::new("cp").arg("-r").arg(sample.path()).arg(copy.path()).status().unwrap();
        assert!(copied.success());
        KINDS[kind].1(&mut Attack { root: copy.path().to_owned(), noise, whole: Rc::clone(&whole) });
        counts[kind] += 1;
    }
    let counts: Vec<String> = KINDS.iter().zip(counts).map(|((name, _), count)| format!("{count} {name}")).collect();
    println!("attacks: {}", counts.join(", "));
}

/// A campaign with its results, in a folder that goes away.
struct Attack {
    root: PathBuf,
    noise: Noise,
    whole: Rc<BTreeMap<String, Vec<u8>>>,
}

type Kind = (&'static str, fn(&mut Attack));

const KINDS: [Kind; 7] = [
    ("special files", Attack::special_file),
    ("kills", Attack::kill),
    ("commands at once", Attack::at_once),
    ("closed streams", Attack::closed_stream),
    ("names of folders", Attack::folder_name),
    ("damaged bytes", Attack::damaged_bytes),
    ("links", Attack::link),
];

const COMMANDS: [&[&str]; 8] = [
    &["check", "campaign"],
    &["run", "campaign"],
    &["batch", "campaign"],
    &["batch", "campaign", "--documents"],
    &["report", "campaign"],
    &["export", "campaign/out/parameters.json"],
    &["recommend", "campaign"],
    &["validate", "campaign"],
];

impl Attack {
    fn below(&mut self, bound: usize) -> usize {
        random(&mut self.noise, bound)
    }

    fn command(&mut self) -> Vec<&'static OsStr> {
        COMMANDS[self.below(COMMANDS.len())].iter().map(OsStr::new).collect()
    }

    fn campaign(&self) -> PathBuf {
        self.root.join("campaign")
    }

    /// A file of the campaign or of its results.
    fn file(&mut self) -> PathBuf {
        let inputs = ["campaign.toml", "robot.toml", "encoders.csv", "exports/world.txt", "exports/poses.txt"];
        let names: Vec<String> =
            inputs.map(str::to_owned).into_iter().chain(self.whole.keys().map(|name| format!("out/{name}"))).collect();
        let i = self.below(names.len());
        self.campaign().join(&names[i])
    }

    /// The output folder is whole: every file is listed and has its hash.
    fn is_whole(&self) {
        let out = self.campaign().join("out");
        let found = files(&out);
        let manifest: serde_json::Value = serde_json::from_slice(&found["manifest.json"]).unwrap();
        for (name, sha256) in manifest["files"].as_object().unwrap() {
            assert_eq!(etalon::base::files::sha256(&found[name]), sha256.as_str().unwrap(), "{name}");
        }
        assert_eq!(manifest["files"].as_object().unwrap().len() + 1, found.len());
    }

    /// After the attack a run gives the same results as before it.
    fn recovers(&self) {
        let ended = command(&self.root, &["run".as_ref(), "campaign".as_ref()]);
        assert_eq!(ended.code, Some(0), "{ended:?}");
        assert!(files(&self.campaign().join("out")) == *self.whole);
        assert_eq!(litter(&self.campaign()), Vec::<String>::new());
    }

    fn special_file(&mut self) {
        let path = self.file();
        std::fs::remove_file(&path).unwrap();
        match self.below(7) {
            0 => mkfifo(&path),
            1 => symlink("/dev/zero", &path).unwrap(),
            2 => symlink("/dev/full", &path).unwrap(),
            3 => symlink("nowhere", &path).unwrap(),
            4 => symlink(&path, &path).unwrap(),
            5 => std::fs::create_dir(&path).unwrap(),
            _ => {}
        }
        let arguments = self.command();
        command(&self.root, &arguments);
    }

    fn kill(&mut self) {
        let arguments = self.command();
        let mut command = Command::new(program());
        command.args(arguments).current_dir(&self.root).stdout(Stdio::null()).stderr(Stdio::null());
        // half of them begin with a folder that is to be written again
        if self.below(2) == 0 {
            let robot = self.campaign().join("robot.toml");
            let text = std::fs::read_to_string(&robot).unwrap();
            std::fs::write(&robot, format!("{text}\n")).unwrap();
        }
        let mut child = command.spawn().unwrap();
        std::thread::sleep(Duration::from_millis(self.below(1500) as u64));
        let _ = child.kill();
        child.wait().unwrap();
        self.is_whole();
        let robot = self.campaign().join("robot.toml");
        std::fs::write(&robot, std::fs::read_to_string(&robot).unwrap().trim_end().to_owned() + "\n").unwrap();
        command_in(&self.root);
        self.is_whole();
        assert_eq!(litter(&self.campaign()), Vec::<String>::new());
    }

    fn at_once(&mut self) {
        let start = |arguments: Vec<&OsStr>| {
            let mut command = Command::new(program());
            command
                .args(arguments)
                .current_dir(&self.root)
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
        };
        let count = 2 + random(&mut self.noise, 5);
        let all: Vec<Vec<&OsStr>> = (0..count)
            .map(|_| COMMANDS[random(&mut self.noise, COMMANDS.len())].iter().map(OsStr::new).collect())
            .filter(|arguments: &Vec<&OsStr>| !arguments.contains(&OsStr::new("--documents")))
            .collect();
        for child in all.into_iter().map(start).collect::<Vec<_>>() {
            let output = child.wait_with_output().unwrap();
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(matches!(output.status.code(), Some(0..=2)) && !said.contains("panicked"), "{said}");
        }
        self.is_whole();
        self.recovers();
    }

    fn closed_stream(&mut self) {
        let closed = [">&-", "2>&-", "<&-", ">&- 2>&-", ">/dev/full", "2>/dev/full", "| true", "2>&1 | true"];
        let closed = closed[self.below(closed.len())];
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("\"$@\" {closed}"), "sh", program()]).args(self.command()).current_dir(&self.root);
        let ended = run_for(&mut shell, LIMIT).expect("it hangs");
        assert!(matches!(ended.code, Some(0..=2)) && !ended.stderr.contains("panicked"), "{closed}: {ended:?}");
    }

    fn folder_name(&mut self) {
        let pieces: [&[u8]; 14] = [
            b"a",
            b"=",
            b" ",
            b";",
            b"'",
            b"\"",
            b"$(touch pwned)",
            b"\x1b[2J",
            b"\n",
            b"\xff",
            b"%",
            b"#",
            "\u{202e}".as_bytes(),
            "\u{1f600}".as_bytes(),
        ];
        let name: Vec<u8> = (0..1 + self.below(6)).flat_map(|_| pieces[self.below(pieces.len())].to_vec()).collect();
        let to = self.root.join(OsStr::from_bytes(&name));
        std::fs::rename(self.campaign(), &to).unwrap();
        for name in ["check", "run", "batch", "report"] {
            let ended = command(&self.root, &[name.as_ref(), "--".as_ref(), to.as_ref()]);
            assert!(ended.code == Some(0) && !steers(&ended.stdout) && !steers(&ended.stderr), "{ended:?}");
        }
        assert!(files(&to.join("out")) == *self.whole && !self.root.join("pwned").exists());
    }

    /// A link in the place of a folder or of a name of the exchange leads no command elsewhere.
    fn link(&mut self) {
        let victim = links::victim(&self.root);
        let before = links::state(&victim);
        let name = ["out", ".out.new", ".out.old", ".out.lock", "exports", "files", "out/link", "report.html"];
        let name = name[self.below(name.len())];
        let path = self.campaign().join(name);
        let _ = std::fs::remove_dir_all(&path);
        let up = "../".repeat(name.split('/').count());
        let targets =
            [format!("{up}victim"), format!("{up}victim/private"), format!("{up}victim/report.html"), "nowhere".into()];
        symlink(&targets[self.below(targets.len())], &path).unwrap();
        let more: [&[&str]; 6] = [
            &["simulate", "campaign"],
            &["export", "campaign/out/parameters.json", "--to", "campaign/files"],
            &["batch", "campaign", "--to", "campaign/files"],
            &["init", "campaign/files/new"],
            &["validate", "campaign", "--report", "campaign/report.html"],
            &["report", "--write-templates", "campaign/files"],
        ];
        for _ in 0..3 {
            let choice = self.below(2 * more.len());
            let arguments = match more.get(choice) {
                Some(arguments) => arguments.iter().map(OsStr::new).collect(),
                None => self.command(),
            };
            command(&self.root, &arguments);
            assert!(links::state(&victim) == before, "{name}: {arguments:?}");
        }
    }

    fn damaged_bytes(&mut self) {
        let path = self.file();
        let mut bytes = std::fs::read(&path).unwrap();
        for _ in 0..1 + self.below(4) {
            let at = self.below(bytes.len() + 1);
            match self.below(4) {
                0 => bytes.truncate(at),
                1 if at < bytes.len() => bytes[at] = self.below(256) as u8,
                2 => drop(bytes.splice(at..at, "\u{feff}=cmd|x\u{1b}".bytes())),
                _ => drop(bytes.splice(at..at, "9".repeat(self.below(400)).bytes())),
            }
        }
        std::fs::write(&path, bytes).unwrap();
        let arguments = self.command();
        let ended = command(&self.root, &arguments);
        assert!(!steers(&ended.stderr), "{ended:?}");
    }
}

/// `etalon run campaign`, which must end well.
fn command_in(folder: &Path) {
    let ended = command(folder, &["run".as_ref(), "campaign".as_ref()]);
    assert_eq!(ended.code, Some(0), "{ended:?}");
}
