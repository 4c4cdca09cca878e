//! Command line, with one file per command.
//!
//! Data go to stdout, messages to stderr. Exit codes: 0 done; 1 done, but a limit of the campaign
//! is not met, or the result is implausible; 2 not run.

mod axes;
mod axis_table;
mod batch;
mod bound;
mod capture;
mod cell;
mod check;
mod compare;
mod compensate;
mod completions;
mod environment;
mod explain;
mod export;
mod fit;
mod fit_text;
mod fit_tracim;
mod formats;
mod groups;
mod identify;
pub mod in_memory;
mod init;
mod inputs;
mod iso230;
mod iso9283;
mod kinematics;
mod man;
mod plan;
mod progress;
mod recommend;
mod report;
mod robot;
mod run;
mod schema;
mod selftest;
mod simulate;
mod study;
mod text_format;
mod uncertainty;
mod validate;
mod validity;
mod verify;

use crate::stages::table_file;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use etalon_base::files::shell_word;
use etalon_base::message::{Message, Problems, printable, printable_lines};
use etalon_base::{error, phrase};
use etalon_documents::WrittenDocument;
use etalon_report::Renderer;
use progress::progress;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fmt::Display;
use std::io::{ErrorKind, Write};

/// Robot calibration from coordinate measurements: a campaign folder in, calibrated parameters and
/// a report out.
#[derive(Debug, Parser)]
#[command(version, about, arg_required_else_help = true, max_term_width = 100)]
#[command(after_help = "Examples:
  etalon init my-campaign               write a commented campaign to start from
  etalon check my-campaign              find everything that is wrong, without computing
  etalon run my-campaign                exports and logs in, parameters and report out
  etalon identify --robot robot.toml --observations observations.csv --json

Exit codes: 0 done; 1 done, but a limit of the campaign is not met, or the result is implausible; \
2 not run.")]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Init(init::Init),
    Check(check::Check),
    Formats(formats::Formats),
    Fit(fit::FitCommand),
    Axes(axes::AxesCommand),
    Cell(Box<cell::CellCommand>),
    Run(run::Run),
    Batch(batch::Batch),
    Identify(identify::IdentifyCommand),
    Recommend(recommend::Recommend),
    Validate(validate::Validate),
    Verify(verify::Verify),
    Uncertainty(uncertainty::Uncertainty),
    Kinematics(kinematics::KinematicsCommand),
    Robot(robot::RobotCommand),
    Compensate(Box<compensate::Compensate>),
    AxisTable(axis_table::AxisTable),
    Plan(Box<plan::PlanCommand>),
    Iso230(iso230::Iso230),
    Iso9283(Box<iso9283::Iso9283>),
    Report(report::ReportCommand),
    Compare(compare::Compare),
    Export(export::ExportCommand),
    Explain(explain::Explain),
    Simulate(simulate::Simulate),
    Study(study::StudyCommand),
    Schema(schema::Schema),
    Selftest(selftest::Selftest),
    Completions(completions::Completions),
    Man(man::Man),
}

/// Outcome of a command.
enum Verdict {
    Met,
    LimitNotMet,
    /// Errors that are in the answer on stdout.
    NotRun,
}

impl Verdict {
    fn new(met: bool) -> Self {
        if met { Self::Met } else { Self::LimitNotMet }
    }
}

/// The command line with its help, in which commands are grouped by task.
pub fn command() -> clap::Command {
    groups::grouped(Arguments::command())
}

/// Runs the program with these arguments, the first of which is its name; returns the exit code.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let mut command = command();
    let matches = command.try_get_matches_from_mut(arguments);
    let read = matches.and_then(|found| Arguments::from_arg_matches(&found).map_err(|e| e.format(&mut command)));
    match read {
        Ok(arguments) => {
            let _bar = progress::Bar::start();
            run(arguments.command)
        }
        Err(error) => refuse(&error),
    }
}

/// Runs one command; errors go to stderr.
fn run(command: Command) -> u8 {
    match environment::check().map_err(anyhow::Error::from).and_then(|()| dispatch(command)) {
        Ok(Verdict::Met) => 0,
        Ok(Verdict::LimitNotMet) => 1,
        Ok(Verdict::NotRun) => 2,
        Err(error) => {
            match error.downcast_ref::<etalon_base::message::Problems>() {
                Some(problems) => {
                    capture::add(|answer| answer.messages.extend_from_slice(&problems.0));
                    say(problems);
                }
                None => say(format_args!("error: {error:#}")),
            }
            2
        }
    }
}

fn dispatch(command: Command) -> anyhow::Result<Verdict> {
    match command {
        Command::Init(command) => command.run(),
        Command::Check(command) => command.run(),
        Command::Formats(command) => command.run(),
        Command::Fit(command) => command.run(),
        Command::Axes(command) => command.run(),
        Command::Cell(command) => command.run(),
        Command::Run(command) => command.run(),
        Command::Batch(command) => command.run(),
        Command::Identify(command) => command.run(),
        Command::Recommend(command) => command.run(),
        Command::Validate(command) => command.run(),
        Command::Verify(command) => command.run(),
        Command::Uncertainty(command) => command.run(),
        Command::Kinematics(command) => command.run(),
        Command::Robot(command) => command.run(),
        Command::Compensate(command) => command.run(),
        Command::AxisTable(command) => command.run(),
        Command::Plan(command) => command.run(),
        Command::Iso230(command) => command.run(),
        Command::Iso9283(command) => command.run(),
        Command::Report(command) => command.run(),
        Command::Compare(command) => command.run(),
        Command::Export(command) => command.run(),
        Command::Explain(command) => command.run(),
        Command::Simulate(command) => command.run(),
        Command::Study(command) => command.run(),
        Command::Schema(command) => command.run(),
        Command::Selftest(command) => command.run(),
        Command::Completions(command) => command.run(),
        Command::Man(command) => command.run(),
    }
}

/// Prints errors of the arguments, or the requested help. Names in the arguments cannot control the
/// terminal.
fn refuse(error: &clap::Error) -> u8 {
    let text = error.render().to_string();
    let shown = |answer: &mut capture::Answer| match error.use_stderr() {
        true => answer.stderr.push_str(&text),
        false => answer.stdout.extend_from_slice(text.as_bytes()),
    };
    if capture::add(shown) {
        return u8::try_from(error.exit_code()).unwrap_or(2);
    }
    match printable_lines(&text) {
        shown if shown == text => drop(error.print()),
        shown => drop(write!(std::io::stderr().lock(), "{shown}")),
    }
    u8::try_from(error.exit_code()).unwrap_or(2)
}

/// Prints data to stdout; a reader who has closed it is not an error.
fn print(data: impl AsRef<[u8]>) -> anyhow::Result<()> {
    if capture::add(|answer| answer.stdout.extend_from_slice(data.as_ref())) {
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
fn print_text(text: &str) -> anyhow::Result<()> {
    print(printable_lines(text))
}

/// Prints to stdout; the exit code is the verdict's even if printing fails.
fn print_with(data: impl AsRef<[u8]>, verdict: Verdict) -> anyhow::Result<Verdict> {
    match (print(data), verdict) {
        (Err(error), Verdict::Met) => Err(error),
        (Err(error), verdict) => {
            say(format_args!("error: {error:#}"));
            Ok(verdict)
        }
        (Ok(()), verdict) => Ok(verdict),
    }
}

/// Prints names or figures of files that are written; the exit code is the verdict's even if
/// printing fails.
fn print_after_writing(data: impl AsRef<[u8]>, verdict: Verdict) -> Verdict {
    if let Err(error) = print(data) {
        say(format_args!("error: {error:#}"));
    }
    verdict
}

/// Prints a report on the terminal, or the given JSON.
fn answer(renderer: &Renderer, json: Option<Vec<u8>>) -> anyhow::Result<Verdict> {
    print_with(json.unwrap_or_else(|| renderer.terminal().into_bytes()), Verdict::new(renderer.passes()))
}

/// Checks that the number of an option, if stated, is positive.
fn check_positive(option: &str, stated: Option<f64>) -> Result<(), Problems> {
    match stated.is_none_or(|value| value > 0.0 && value.is_finite()) {
        true => Ok(()),
        false => Err(error!("option-not-positive", option).into()),
    }
}

/// Table of poses with values by column name.
fn pose_table<'a, P: Display>(columns: &[&str], rows: impl Iterator<Item = (P, &'a BTreeMap<String, f64>)>) -> String {
    let row = |(pose, values): (P, &BTreeMap<String, f64>)| {
        let cells: Vec<String> = columns.iter().filter_map(|name| Some(values.get(*name)?.to_string())).collect();
        format!("{pose},{}\n", cells.join(","))
    };
    format!("pose,{}\n", columns.join(",")) + &rows.map(row).collect::<String>()
}

/// Prints messages to stderr: those that need action first, with similar rows merged.
fn remark(messages: &[Message]) {
    let mut grouped = Problems(messages.to_vec()).grouped().0;
    grouped.sort_by_key(|message| message.rank);
    grouped.iter().for_each(say_message);
}

/// Prints the names of written files, as lines or as JSON.
fn print_written(files: Vec<String>, json: bool) -> anyhow::Result<()> {
    let data = match json {
        true => etalon_documents::to_json(&WrittenDocument::new(files))?,
        false => lines(&files).into_bytes(),
    };
    print_after_writing(data, Verdict::Met);
    Ok(())
}

/// Names of files, one a line.
fn lines(files: &[String]) -> String {
    files.iter().map(|file| format!("{}\n", printable(file))).collect()
}

/// Prints a message to stderr.
fn say_message(message: &Message) {
    capture::add(|answer| answer.messages.push(message.clone()));
    say(format_args!("{message}\n"));
}

/// Prints text to stderr; names in it cannot control the terminal. A closed stderr is not an error.
fn say(text: impl Display) {
    let text = printable_lines(&text.to_string());
    if capture::add(|answer| answer.stderr += &format!("{text}\n")) {
        return;
    }
    progress::beside(|| drop(writeln!(std::io::stderr().lock(), "{text}")));
}

/// Names the next command on stderr, unless the caller asked for JSON.
fn next_step(json: bool, step: impl Display) {
    if !json {
        say(format_args!("next: {step}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn every_option_has_one_meaning_in_its_command() {
        Arguments::command().debug_assert();
    }
}
