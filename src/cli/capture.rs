//! Answers of commands that a program runs in its own process.

use etalon_base::message::Message;
use std::cell::RefCell;
use std::ffi::OsString;

/// Answer of a command.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// Exit code.
    pub code: u8,
    /// Data.
    pub stdout: Vec<u8>,
    /// Messages and remarks as a terminal shows them.
    pub stderr: String,
    /// Messages with ids and arguments.
    pub messages: Vec<Message>,
}

thread_local! {
    static ANSWER: RefCell<Option<Answer>> = const { RefCell::new(None) };
}

/// Runs a command line, the first word of which is the program's name; nothing is printed.
///
/// Paths begin at the working folder of the process.
pub fn answer(arguments: impl IntoIterator<Item = OsString>) -> Answer {
    ANSWER.with_borrow_mut(|answer| *answer = Some(Answer::default()));
    let code = super::main(arguments);
    let answer = ANSWER.with_borrow_mut(Option::take).unwrap_or_default();
    Answer { code, ..answer }
}

/// Adds to the answer; `false` if the command prints.
pub(super) fn add(change: impl FnOnce(&mut Answer)) -> bool {
    ANSWER.with_borrow_mut(|answer| answer.as_mut().map(change).is_some())
}

/// `true` if the command of these words, the first of which is the program's name, has the option
/// `--json`.
pub fn has_json(words: &[String]) -> bool {
    let mut command = super::command();
    command.build();
    let mut found = &command;
    for word in words.iter().skip(1) {
        match found.find_subcommand(word) {
            Some(inner) => found = inner,
            None => break,
        }
    }
    found.get_arguments().any(|argument| argument.get_long() == Some("json"))
}
