//! Arguments in, one command, exit code out.

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = etalon::cli::Arguments::parse();
    etalon::cli::run(arguments)
}
