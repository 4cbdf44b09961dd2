//! The program `unoclp`, which knows WHEN too.

use std::process::ExitCode;

fn main() -> ExitCode {
    unoclp_lang::register(&unoclp_when::WHEN);
    unoclp_cli::run()
}
