//! Command line, with one file per command.
//!
//! Data go to stdout, messages to stderr. Exit codes: 0 done; 1 done, but a limit of the campaign
//! is not met, or the result is implausible; 2 not run.

mod axes;
mod axis_table;
mod batch;
mod benchmark;
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
mod init;
mod iso230;
mod iso9283;
mod kinematics;
mod man;
mod output;
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
mod uncertainty;
mod validate;
mod verify;
mod view;

pub use output::Answer;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use etalon_base::files::shell_word;
use etalon_base::message::Problems;
use output::{Output, lines};
use progress::progress;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fmt::Display;
use std::ops::ControlFlow;

/// Robot calibration from coordinate measurements: from a campaign folder to calibrated parameters
/// and a report.
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

/// Commands with their options; each is one file.
macro_rules! commands {
    ($($name:ident($options:ty),)+) => {
        #[derive(Debug, Subcommand)]
        enum Command {
            $($name($options),)+
        }

        impl Command {
            fn run(self, out: &Output) -> anyhow::Result<Verdict> {
                match self {
                    $(Self::$name(options) => options.run(out),)+
                }
            }
        }
    };
}

commands! {
    Init(init::Init),
    Check(check::Check),
    Formats(formats::Formats),
    Fit(fit::FitCommand),
    Axes(axes::AxesCommand),
    Cell(Box<cell::CellCommand>),
    Run(run::Run),
    Batch(batch::Batch),
    Benchmark(benchmark::Benchmark),
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
    View(view::View),
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
    run(arguments, &Output::terminal())
}

/// Runs the program like [`main`], in the process of another program; nothing is printed.
///
/// Paths begin at the working folder of the process.
pub fn answer(arguments: impl IntoIterator<Item = OsString>) -> Answer {
    let out = Output::collected();
    let code = run(arguments, &out);
    out.into_answer(code)
}

/// Runs the program like [`answer`], with `--json` where the command has this option.
pub fn answer_in_json(mut words: Vec<String>) -> Answer {
    let mut command = command();
    command.build();
    let found = words.iter().skip(1).try_fold(&command, |found, word| match found.find_subcommand(word) {
        Some(inner) => ControlFlow::Continue(inner),
        None => ControlFlow::Break(found),
    });
    let (ControlFlow::Continue(found) | ControlFlow::Break(found)) = found;
    let has_json = found.get_arguments().any(|argument| argument.get_long() == Some("json"));
    if has_json && !words.iter().any(|word| word == "--json") {
        words.push("--json".to_owned());
    }
    answer(words.into_iter().map(Into::into))
}

/// Runs one command; errors go to stderr.
fn run(arguments: impl IntoIterator<Item = OsString>, out: &Output) -> u8 {
    let mut command = command();
    let matches = command.try_get_matches_from_mut(arguments);
    let read = matches.and_then(|found| Arguments::from_arg_matches(&found).map_err(|e| e.format(&mut command)));
    let command = match read {
        Ok(arguments) => arguments.command,
        Err(error) => return out.refuse(&error),
    };
    let _bar = progress::Bar::start();
    match environment::check().map_err(anyhow::Error::from).and_then(|()| command.run(out)) {
        Ok(Verdict::Met) => 0,
        Ok(Verdict::LimitNotMet) => 1,
        Ok(Verdict::NotRun) => 2,
        Err(error) => {
            match error.downcast_ref::<Problems>() {
                Some(problems) => out.say_problems(problems),
                None => out.say(format_args!("error: {error:#}")),
            }
            2
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn every_option_has_one_meaning_in_its_command() {
        Arguments::command().debug_assert();
    }
}
