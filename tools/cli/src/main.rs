//! The program `unoclp`.

use std::process::ExitCode;

fn main() -> ExitCode {
    unoclp_cli::run()
}
