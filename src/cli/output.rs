//! Output of a command: stdout and stderr of the process, or an answer to a program.

use super::{Verdict, progress};
use etalon_base::message::{Message, Problems, printable, printable_lines};
use etalon_base::phrase;
use etalon_documents::{Language, WrittenDocument};
use etalon_report::Renderer;
use std::fmt::Display;
use std::io::{ErrorKind, Write};
use std::sync::{Mutex, PoisonError};

/// Answer of a command to a program.
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

/// Destination of data and messages.
pub(super) struct Output(Option<Mutex<Answer>>);

impl Output {
    /// Data to stdout, messages to stderr.
    pub fn terminal() -> Self {
        Self(None)
    }

    /// Data and messages to an answer.
    pub fn collected() -> Self {
        Self(Some(Mutex::default()))
    }

    /// The collected answer.
    pub fn into_answer(self, code: u8) -> Answer {
        let answer = self.0.map(|answer| answer.into_inner().unwrap_or_else(PoisonError::into_inner));
        Answer { code, ..answer.unwrap_or_default() }
    }

    /// Adds to the answer; `false` if the command prints.
    fn add(&self, change: impl FnOnce(&mut Answer)) -> bool {
        self.0.as_ref().map(|answer| change(&mut answer.lock().unwrap_or_else(PoisonError::into_inner))).is_some()
    }

    /// Prints data to stdout; a reader who has closed it is not an error.
    pub fn print(&self, data: impl AsRef<[u8]>) -> anyhow::Result<()> {
        if self.add(|answer| answer.stdout.extend_from_slice(data.as_ref())) {
            return Ok(());
        }
        let write = || {
            let mut out = std::io::stdout().lock();
            out.write_all(data.as_ref()).and_then(|()| out.flush())
        };
        match progress::beside(write) {
            Err(e) if e.kind() != ErrorKind::BrokenPipe => {
                Err(anyhow::Error::new(e).context(phrase!("stdout-not-written")))
            }
            _ => Ok(()),
        }
    }

    /// Prints text to stdout; names in it cannot control the terminal.
    pub fn print_text(&self, text: &str) -> anyhow::Result<()> {
        self.print(printable_lines(text))
    }

    /// Prints to stdout; the exit code is the verdict's even if printing fails.
    pub fn print_with(&self, data: impl AsRef<[u8]>, verdict: Verdict) -> anyhow::Result<Verdict> {
        match (self.print(data), verdict) {
            (Err(error), Verdict::Met) => Err(error),
            (Err(error), verdict) => {
                self.say(format_args!("error: {error:#}"));
                Ok(verdict)
            }
            (Ok(()), verdict) => Ok(verdict),
        }
    }

    /// Prints names or figures of files that are written; the exit code is the verdict's even if
    /// printing fails.
    pub fn print_after_writing(&self, data: impl AsRef<[u8]>, verdict: Verdict) -> Verdict {
        if let Err(error) = self.print(data) {
            self.say(format_args!("error: {error:#}"));
        }
        verdict
    }

    /// Prints a report on the terminal, or the given JSON.
    pub fn answer(&self, renderer: &Renderer, json: Option<Vec<u8>>) -> anyhow::Result<Verdict> {
        self.print_with(json.unwrap_or_else(|| renderer.terminal().into_bytes()), Verdict::new(renderer.passes()))
    }

    /// Prints the names of written files, as lines or as JSON.
    pub fn print_written(&self, files: Vec<String>, json: bool) -> anyhow::Result<()> {
        let data = match json {
            true => etalon_documents::to_json(&WrittenDocument::new(files))?,
            false => lines(&files).into_bytes(),
        };
        self.print_after_writing(data, Verdict::Met);
        Ok(())
    }

    /// Prints messages to stderr: messages that need action first, with similar rows merged.
    pub fn remark(&self, messages: &[Message]) {
        self.remark_in(Language::En, messages);
    }

    /// Like [`Output::remark`], in the language of a report.
    pub fn remark_in(&self, language: Language, messages: &[Message]) {
        let mut grouped = Problems(messages.to_vec()).grouped().0;
        grouped.sort_by_key(|message| message.rank);
        grouped.iter().for_each(|message| self.say_message_in(language, message));
    }

    /// Prints a message to stderr.
    pub fn say_message(&self, message: &Message) {
        self.say_message_in(Language::En, message);
    }

    fn say_message_in(&self, language: Language, message: &Message) {
        self.add(|answer| answer.messages.push(message.clone()));
        self.say(format_args!("{}\n", message.in_language(language.code())));
    }

    /// Prints the errors that ended a command to stderr.
    pub fn say_problems(&self, problems: &Problems) {
        self.add(|answer| answer.messages.extend_from_slice(&problems.0));
        self.say(problems);
    }

    /// Prints text to stderr; names in it cannot control the terminal. A closed stderr is not an
    /// error.
    pub fn say(&self, text: impl Display) {
        let text = printable_lines(&text.to_string());
        if !self.add(|answer| answer.stderr += &format!("{text}\n")) {
            progress::beside(|| drop(writeln!(std::io::stderr().lock(), "{text}")));
        }
    }

    /// Names the next command on stderr, unless the caller asked for JSON.
    pub fn next_step(&self, json: bool, step: impl Display) {
        if !json {
            self.say(format_args!("next: {step}"));
        }
    }

    /// Prints errors of the arguments, or the requested help. Names in the arguments cannot control
    /// the terminal.
    pub fn refuse(&self, error: &clap::Error) -> u8 {
        let text = error.render().to_string();
        let is_answer = self.add(|answer| match error.use_stderr() {
            true => answer.stderr.push_str(&text),
            false => answer.stdout.extend_from_slice(text.as_bytes()),
        });
        if !is_answer {
            match printable_lines(&text) {
                shown if shown == text => drop(error.print()),
                shown => drop(write!(std::io::stderr().lock(), "{shown}")),
            }
        }
        u8::try_from(error.exit_code()).unwrap_or(2)
    }
}

/// Names of files, one a line.
pub(super) fn lines(files: &[String]) -> String {
    files.iter().map(|file| format!("{}\n", printable(file))).collect()
}
