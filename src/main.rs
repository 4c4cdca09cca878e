//! Arguments in, one command, exit code out.

use std::process::ExitCode;

fn main() -> ExitCode {
    etalon::cli::main(std::env::args_os()).into()
}
