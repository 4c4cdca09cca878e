//! Values of the environment that no command can use: refused by name, or bounded.

use crate::support::scratch::{Scratch, copy_sample};
use crate::support::{program, run_for};
use std::process::Command;
use std::time::Duration;

/// Exit code and stderr of a command with a variable; it must end in time.
fn with(scratch: &Scratch, (name, value): (&str, &str), arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(program());
    command.args(arguments).env(name, value).current_dir(scratch.root());
    let ended = run_for(&mut command, Duration::from_secs(60)).expect("it hangs");
    (ended.code, ended.stderr)
}

#[test]
fn a_date_that_is_none_is_refused_by_every_command() {
    let scratch = copy_sample("prexyt-cmm");
    for value in ["-1", "soon", "1e9", "253402300800", "99999999999999999999"] {
        for arguments in [&["run", "campaign"][..], &["check", "campaign"], &["formats", "campaign/encoders.csv"]] {
            let (code, said) = with(&scratch, ("SOURCE_DATE_EPOCH", value), arguments);
            assert!(code == Some(2) && said.contains("[environment-date]") && said.contains(value), "{value}: {said}");
        }
        assert!(!scratch.path().join("out").exists());
    }
    for value in ["0", "1700000000", " 1700000000 ", ""] {
        let (code, said) = with(&scratch, ("SOURCE_DATE_EPOCH", value), &["run", "campaign"]);
        assert_eq!(code, Some(0), "{value}: {said}");
    }
}

#[test]
fn threads_without_number_are_bounded() {
    let scratch = copy_sample("prexyt-cmm");
    let run = |value| {
        let (code, said) = with(&scratch, ("RAYON_NUM_THREADS", value), &["run", "campaign"]);
        assert_eq!(code, Some(0), "{value}: {said}");
        std::fs::read(scratch.path().join("out/parameters.json")).unwrap()
    };
    let one = run("1");
    for value in ["0", "x", "1000000", "99999999999999999999999"] {
        assert!(run(value) == one, "{value}");
    }
    let (code, said) = with(&scratch, ("POLARS_MAX_THREADS", "1000000"), &["run", "campaign"]);
    assert!(code == Some(2) && said.contains("[environment-threads]"), "{said}");
}
