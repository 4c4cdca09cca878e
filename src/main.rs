//! Arguments in, one command, exit code out.

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    match etalon::cli::Arguments::try_parse() {
        Ok(arguments) => etalon::cli::run(arguments),
        Err(error) => etalon::cli::refuse(&error),
    }
}
