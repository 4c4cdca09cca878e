//! Faults of the machine: a stop at every sync and rename, a disk that is full, a folder that cannot be written. Each test is skipped,
//! saying so, where the machine has no strace or does not mount.

use crate::base::folders::{files, litter, run};
use crate::support::scratch::{Scratch, copy_sample, etalon};
use std::collections::BTreeMap;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Calls by which a folder of results comes to be.
const CALLS: &str = "fsync,syncfs,rename,renameat2,mkdir,rmdir";

/// Runs `etalon` with these arguments, killed as it enters the `n`th of [`CALLS`]; `None` where it ends before.
fn killed(folder: &Path, arguments: &[&str], n: usize) -> Option<()> {
    let inject = format!("inject={CALLS}:signal=KILL:when={n}");
    let mut strace = Command::new("strace");
    strace.args(["-f", "-qq", "-o", "/dev/null", "-e", &format!("trace={CALLS}"), "-e", &inject]);
    // calls are counted by thread
    strace.arg(env!("CARGO_BIN_EXE_etalon")).args(arguments).current_dir(folder).env("RAYON_NUM_THREADS", "1");
    let status = strace.stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
    // strace ends as what it traces did
    (status.signal() == Some(9) || status.code() == Some(137)).then_some(())
}

fn strace_is_there() -> bool {
    let there = Command::new("strace").args(["-qq", "-o", "/dev/null", "true"]).stderr(Stdio::null()).status();
    let there = there.is_ok_and(|status| status.success());
    if !there {
        crate::support::skipped("strace");
    }
    there
}

#[test]
fn a_run_killed_at_each_sync_and_rename_leaves_the_earlier_folder_or_the_new_one() {
    if !strace_is_there() {
        return;
    }
    let scratch = copy_sample("prexyt-cmm");
    let factor = |from: &str, to: &str| {
        scratch.replace("campaign.toml", &format!("coverage_factor = {from}\n"), &format!("coverage_factor = {to}\n"));
    };
    let out = scratch.path().join("out");
    run(&scratch);
    let first = files(&out);
    factor("2", "2.5");
    run(&scratch);
    let states = [first, files(&out)];
    let mut found = [0, 0];
    for n in 1.. {
        // of the two states the next run makes the one that is not there
        let next = usize::from(n % 2 == 0);
        let [from, to] = if next == 0 { ["2.5", "2"] } else { ["2", "2.5"] };
        factor(from, to);
        if killed(scratch.root(), &["run", "campaign"], n).is_none() {
            assert!(n > 20, "only {n} calls were met");
            break;
        }
        let left = files(&out);
        let state = states.iter().position(|state| *state == left);
        let state = state.unwrap_or_else(|| panic!("a mixed folder after call {n}: {:?}", left.keys()));
        found[usize::from(state == next)] += 1;
        run(&scratch);
        assert_eq!(litter(&scratch), Vec::<String>::new(), "after call {n}");
        assert!(files(&out) == states[next], "after call {n}");
    }
    println!(
        "killed at {} calls: {} kept the earlier folder, {} had the new one",
        found[0] + found[1],
        found[0],
        found[1]
    );
    assert!(found[0] > 0 && found[1] > 0);
}

#[test]
fn a_batch_killed_at_each_rename_goes_on_to_the_same_results() {
    if !strace_is_there() {
        return;
    }
    let scratch = copy_sample("prexyt-cmm");
    let names = ["campaign", "b", "c"];
    for name in &names[1..] {
        let copy = Command::new("cp").args(["-r", "campaign", name]).current_dir(scratch.root()).status().unwrap();
        assert!(copy.success());
    }
    let arguments = [&["batch", "--documents"], &names[..]].concat();
    let results = || -> BTreeMap<String, BTreeMap<String, Vec<u8>>> {
        names.iter().map(|name| ((*name).to_owned(), files(&scratch.root().join(name).join("out")))).collect()
    };
    let batch = || {
        let output = Command::new(env!("CARGO_BIN_EXE_etalon")).args(&arguments).current_dir(scratch.root()).output();
        assert!(output.unwrap().status.success());
        std::fs::read(scratch.root().join("batch.parquet")).unwrap()
    };
    let (table, whole) = (batch(), results());
    for n in 1.. {
        names.iter().for_each(|name| std::fs::remove_dir_all(scratch.root().join(name).join("out")).unwrap());
        if killed(scratch.root(), &arguments, n).is_none() {
            assert!(n > 6, "only {n} calls were met");
            break;
        }
        for (name, left) in results() {
            assert!(left.is_empty() || left == whole[&name], "a mixed folder {name} after call {n}: {:?}", left.keys());
        }
        assert!(batch() == table && results() == whole, "after call {n}");
        assert_eq!(litter(&scratch), Vec::<String>::new(), "after call {n}");
    }
}

/// A small file system in memory, which is unmounted with the test.
struct Mounted(PathBuf);

impl Mounted {
    fn at(folder: PathBuf) -> Option<Self> {
        std::fs::create_dir_all(&folder).unwrap();
        let mut mount = Command::new("mount");
        mount.args(["-t", "tmpfs", "-o", "size=64m", "tmpfs"]).arg(&folder).stderr(Stdio::null());
        let mounted = mount.status().is_ok_and(|status| status.success());
        if !mounted {
            crate::support::skipped("mount");
        }
        mounted.then_some(Self(folder))
    }

    fn remount(&self, options: &str) {
        let options = format!("remount,{options}");
        assert!(Command::new("mount").args(["-o", &options]).arg(&self.0).status().unwrap().success(), "{options}");
    }
}

impl Drop for Mounted {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg("-l").arg(&self.0).status();
    }
}

/// A sample whose folder is a file system of its own.
fn mounted() -> Option<(Scratch, Mounted)> {
    let (sample, scratch) = (copy_sample("prexyt-cmm"), Scratch::with(&[]));
    let mounted = Mounted::at(scratch.path())?;
    let mut copy = Command::new("cp");
    copy.arg("-r").arg(format!("{}/.", sample.path().display())).arg(scratch.path());
    assert!(copy.status().unwrap().success());
    Some((scratch, mounted))
}

#[test]
fn a_full_disk_or_one_that_is_read_only_loses_nothing() {
    let Some((scratch, disk)) = mounted() else { return };
    run(&scratch);
    let out = scratch.path().join("out");
    let first = files(&out);
    scratch.replace("campaign.toml", "coverage_factor = 2\n", "coverage_factor = 2.5\n");
    let refused = |how: &str| {
        let (code, said) = etalon(&scratch, "run");
        assert!(
            code == Some(2) && said.contains("cannot write") && said.contains("[earlier-run-left]"),
            "{how}: {said}"
        );
        assert!(files(&out) == first, "{how}");
        assert_eq!(litter(&scratch), Vec::<String>::new(), "{how}");
    };
    let used: u64 = first.values().map(|bytes| bytes.len() as u64).sum();
    // room for a part of the new folder
    for part in [0.05, 0.3, 0.6, 0.9] {
        let room = (used as f64 * (1.0 + part)) as u64 / 1024 + 120;
        disk.remount(&format!("size={room}k"));
        refused(&format!("room for {part} of the new folder"));
    }
    disk.remount("size=64m,ro");
    refused("read only");
    disk.remount("rw");
    run(&scratch);
    assert!(files(&out) != first);
}
