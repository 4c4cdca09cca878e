//! Messages by the input that causes them: a case is a sample or an empty folder, edits, a command, and the id that the answer has.
//!
//! The commands run in this process, on all cores.

mod altered;
mod campaign;
mod command_line;
mod comparisons;
mod controller_files;
mod controllers;
mod data;
mod library;
mod logs;
mod robot;
mod set_ups;
mod simulate;
mod tests_of_robots;

use crate::support::root;
use etalon::base::catalogue::Argument;
use etalon::base::message::Message;
use etalon::cli::{Answer, answer};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};
use tempfile::TempDir;

/// Edits of files: name, text that is replaced, and its replacement. An empty text replaces the whole file, and `+` appends.
type Edits = &'static [(&'static str, &'static str, &'static str)];

/// Id of the message, with arguments that it has (`key-missing key=unit`); sample (empty: no files; `NAME+out`: with its output);
/// edits; command line, where `@` is the folder.
type Case = (&'static str, &'static str, Edits, &'static str);

const CHECK: &str = "check @";
const RUN: &str = "run @";

fn samples() -> PathBuf {
    root().join("samples")
}

/// A copy of a sample with its output, which is computed once.
fn ran(sample: &str) -> &'static Path {
    static RAN: Mutex<BTreeMap<String, &'static OnceLock<TempDir>>> = Mutex::new(BTreeMap::new());
    let cell = *RAN.lock().unwrap().entry(sample.to_owned()).or_insert_with(|| Box::leak(Box::default()));
    let folder = cell.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        copy(&samples().join(sample), folder.path());
        let path = folder.path().display().to_string();
        let answer = answer(["etalon", "run", &path].map(Into::into));
        assert!(answer.code < 2, "{sample}: {}", answer.stderr);
        folder
    });
    folder.path()
}

/// Copies a folder; the output of a sample in the checkout is left out.
fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    let is_sample = from.starts_with(samples());
    let entries = std::fs::read_dir(from).unwrap().flatten();
    for entry in entries.filter(|entry| !is_sample || entry.file_name() != "out") {
        match entry.path().is_dir() {
            true => copy(&entry.path(), &to.join(entry.file_name())),
            false => _ = std::fs::copy(entry.path(), to.join(entry.file_name())).unwrap(),
        }
    }
}

/// Answer of a command on a sample after edits.
fn answer_of(sample: &str, edits: Edits, command: &str) -> Answer {
    let folder = tempfile::tempdir().unwrap();
    match sample.strip_suffix("+out") {
        Some(sample) => copy(ran(sample), folder.path()),
        None if sample.is_empty() => {}
        None => copy(&samples().join(sample), folder.path()),
    }
    for (file, from, to) in edits {
        let path = folder.path().join(file);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let edited = match *from {
            "" => (*to).to_owned(),
            "+" => text + to,
            from => {
                assert!(text.contains(from), "{sample}/{file} does not hold {from:?}");
                text.replace(from, to)
            }
        };
        std::fs::write(path, edited).unwrap();
    }
    let shown = folder.path().display().to_string();
    let words = command.split(' ').map(|word| word.replace('@', &shown).replace('~', " ").into());
    answer(std::iter::once("etalon".into()).chain(words))
}

/// `true` if the message has the id and the arguments of a case.
fn is(message: &Message, expected: &str) -> bool {
    let mut words = expected.split(' ');
    let is_argument = |word: &str| {
        let (name, value) = word.split_once('=').unwrap();
        message.arguments.get(name).is_some_and(|argument| match argument {
            Argument::Text(text) => text == value,
            Argument::Whole(number) => number.to_string() == value,
            Argument::Phrase(phrase) => phrase.id == value,
            _ => false,
        })
    };
    words.next() == Some(&*message.id) && words.all(is_argument)
}

/// Applies a function to all of these on all cores; results are in order.
fn in_parallel<T: Sync, R: Send>(all: &[T], of: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let (next, done) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    let work = || {
        while let Some((i, item)) = Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|i| Some((i, all.get(i)?))) {
            let result = of(item);
            done.lock().unwrap().insert(i, result);
        }
    };
    std::thread::scope(|scope| {
        (0..std::thread::available_parallelism().map_or(1, usize::from)).for_each(|_| _ = scope.spawn(work));
    });
    done.into_inner().unwrap().into_values().collect()
}

/// `true` if the edits change files, and create none that the command reads.
fn changes(edits: Edits) -> bool {
    !edits.is_empty() && edits.iter().all(|(_, from, _)| !from.is_empty())
}

/// Every case has its message; the sample as it is does not have it.
fn hold(cases: &[Case]) {
    let edited = in_parallel(cases, |(_, sample, edits, command)| answer_of(sample, edits, command));
    let sound: BTreeSet<(&str, &str)> =
        cases.iter().filter(|case| !case.1.is_empty() && changes(case.2)).map(|case| (case.1, case.3)).collect();
    let sound: Vec<_> = sound.into_iter().collect();
    let answers = in_parallel(&sound, |(sample, command)| answer_of(sample, &[], command));
    let sound: BTreeMap<_, _> = sound.into_iter().zip(answers).collect();
    let mut wrong = String::new();
    for ((expected, sample, edits, command), answer) in cases.iter().zip(edited) {
        if !answer.messages.iter().any(|message| is(message, expected)) {
            let _ = writeln!(
                wrong,
                "{expected}: {sample} {edits:?} {command}: exit code {}\n{}",
                answer.code, answer.stderr
            );
        }
        let id = expected.split(' ').next().unwrap();
        let without = sound.get(&(*sample, *command)).filter(|_| changes(edits));
        if without.is_some_and(|answer| answer.messages.iter().any(|message| message.id == id)) {
            let _ = writeln!(wrong, "{id}: {command} has it on {sample} as it is");
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
#[should_panic(expected = "key-missing: ")]
fn a_case_without_its_message_fails() {
    hold(&[("key-missing", "", &[], "check @")]);
}

#[test]
#[should_panic(expected = "has it on")]
fn a_message_of_the_sample_itself_proves_nothing() {
    hold(&[("input-missing", "prexyt-cmm", &[("encoders.csv", "0", "1")], "formats @/nothing.txt")]);
}
