//! What the program tells a person: completions, manual pages, next steps, progress.

use super::{etalon, text};
use crate::support::scratch::copy_sample;
use crate::support::skipped;
use std::collections::BTreeSet;
use std::process::Command;

fn commands() -> BTreeSet<String> {
    etalon::cli::command().get_subcommands().map(|command| command.get_name().to_owned()).collect()
}

#[test]
fn completions_name_every_command() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let made = etalon(folder.path(), &["completions", shell]);
        assert!(made.status.success() && made.stderr.is_empty());
        let script = text(&made.stdout);
        let missing: Vec<String> = commands().into_iter().filter(|name| !script.contains(name.as_str())).collect();
        assert!(missing.is_empty(), "{shell}: {missing:?}");
    }
    let bash = etalon(folder.path(), &["completions", "bash"]).stdout;
    std::fs::write(folder.path().join("etalon.bash"), bash).unwrap();
    let asked =
        "source etalon.bash; COMP_WORDS=(etalon iso); COMP_CWORD=1; _etalon etalon iso etalon; echo ${COMPREPLY[@]}";
    let answer = Command::new("bash").args(["-c", asked]).current_dir(folder.path()).output().unwrap();
    assert_eq!(text(&answer.stdout).split_whitespace().collect::<BTreeSet<_>>(), ["iso230", "iso9283"].into());
    assert_eq!(etalon(folder.path(), &["completions", "tcsh"]).status.code(), Some(2));
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = tempfile::tempdir().unwrap();
    let made = etalon(folder.path(), &["man", "man"]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    for name in commands().into_iter().filter(|name| name != "help") {
        let page = std::fs::read_to_string(folder.path().join(format!("man/etalon-{name}.1"))).unwrap();
        assert!(page.contains(".SH SYNOPSIS") && page.contains(".SH DESCRIPTION"), "{name}:\n{page}");
    }
    let page = std::fs::read_to_string(folder.path().join("man/etalon-iso9283-pose.1")).unwrap();
    assert!(page.contains("ap\\-limit\\-mm"), "{page}");
    assert!(folder.path().join("man/etalon.1").is_file());
}

/// The commands that a person runs one after the other each name the next one; programs that ask for JSON are told nothing.
#[test]
fn commands_name_the_next_step() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| text(&etalon(folder.path(), arguments).stderr);
    assert!(run(&["init", "of mine", "--synthetic"]).contains("next: `etalon simulate 'of mine'`"));
    assert!(run(&["init", "measured"]).contains("`etalon check measured`"));
    let check = run(&["check", "of mine"]);
    assert!(check.contains("error[input-missing]: ") && !check.contains("next: "), "{check}");
    assert!(etalon(folder.path(), &["simulate", "of mine"]).status.success());
    assert_eq!(run(&["check", "of mine"]), "next: `etalon run 'of mine'`\n");
    assert!(run(&["formats", "of mine/encoders.csv"]).contains("next: "));
    assert!(run(&["run", "of mine"]).contains("next: `etalon recommend 'of mine'`"));
    for silent in [&["check", "of mine", "--json"][..], &["run", "of mine", "--json"], &["init", "third", "--json"]] {
        assert!(!run(silent).contains("next: "), "{silent:?}");
    }
}

/// Pressed into a terminal by `script`, which stands for one.
#[test]
fn long_commands_show_their_progress_on_a_terminal_alone() {
    let sample = copy_sample("prexyt-cmm");
    let long = ["uncertainty", ".", "--draws", "10000000", "--resamples", "0"];
    let command = format!("timeout 6 {} {}", crate::support::program(), long.join(" "));
    let Ok(shown) = Command::new("script").args(["-qec", &command, "/dev/null"]).current_dir(sample.path()).output()
    else {
        return skipped("script");
    };
    let shown = text(&shown.stdout);
    assert!(shown.contains("00:00:02"), "{shown}");
    let quick = format!("{} check .", crate::support::program());
    let shown = Command::new("script").args(["-qec", &quick, "/dev/null"]).current_dir(sample.path()).output().unwrap();
    assert!(!text(&shown.stdout).contains("00:00:"), "{}", text(&shown.stdout));
    let mut piped = Command::new("timeout");
    piped.args(["3", crate::support::program()]).args(long).current_dir(sample.path());
    assert!(piped.output().unwrap().stderr.is_empty());
}

/// Colours appear on a terminal, unless `NO_COLOR` is set.
#[test]
fn no_color_is_respected() {
    let shown = |no_color: Option<&str>| {
        let command = format!("{} --help", crate::support::program());
        let mut script = Command::new("script");
        script.args(["-qec", &command, "/dev/null"]).env("TERM", "xterm-256color").env_remove("NO_COLOR");
        if let Some(value) = no_color {
            script.env("NO_COLOR", value);
        }
        script.output().ok().map(|output| text(&output.stdout))
    };
    let (Some(coloured), Some(plain)) = (shown(None), shown(Some("1"))) else { return skipped("script") };
    assert!(coloured.contains("\u{1b}[") && !plain.contains("\u{1b}["), "{plain}");
    assert!(plain.contains("Start a campaign:"), "{plain}");
}
