//! `cargo xtask …`

use std::process::ExitCode;

use clap::Parser;
use xtask::{
    bench, card, demo, dist, firmware, flash, fuzz, lab, modules, mutants, notice, rulings, setup,
    test, vsix, wiring,
};

/// Build, demonstrate and test unoclp
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
enum Task {
    /// Show a program at work on a simulated UNO: install what is missing, build and run
    Demo,
    /// Run every test: install what is missing, check, build and test
    Test(test::TestArgs),
    /// Run the random tests with many more rounds
    Soak(test::SoakArgs),
    /// Look for inputs that break a guarantee, guided by the code that they reach
    Fuzz(fuzz::Args),
    /// Build the firmware of the UNO, the Nano and the Mega in target/firmware: unoclp.hex, unoclp-nano.hex, unoclp-mega.hex
    Firmware(firmware::Args),
    /// Measure the firmware on simulated boards, the compiler, the editor and the machines, and write their pages in docs/
    Bench(bench::Args),
    /// Write a program to a memory card image
    Card(card::Args),
    /// Write the firmware to a board
    Flash(flash::Args),
    /// Build the page with the simulated UNO, and serve it
    Lab(lab::Args),
    /// Build the distribution in target/dist: `unoclp` with the page inside, and the page itself
    Dist(dist::Args),
    /// Write NOTICE: the third-party code in the page and the programs
    Notice,
    /// Show circular dependencies between the modules of each crate
    Modules,
    /// Change the source a little, see whether a test notices the change, and write docs/mutants.md
    Mutants(mutants::Args),
    /// Write docs/rulings.md: the tests that name each ruling of the numeric code
    Rulings,
    /// Draw docs/wiring-mega.svg, the wiring of the Mega 2560, from the table of its pins
    Wiring,
    /// Build the extension for Visual Studio Code: target/unoclp.vsix
    Vsix,
    /// Install what demo, test and firmware need, or say what is missing
    Setup,
}

/// Ends this quietly once nobody reads its output any more.
fn end_with_the_pipe() {
    #[cfg(unix)]
    if let Err(error) = signal_hook::flag::register_conditional_default(
        signal_hook::consts::SIGPIPE,
        std::sync::Arc::new(std::sync::atomic::AtomicBool::new(true)),
    ) {
        eprintln!("warning: {error}");
    }
}

fn main() -> ExitCode {
    end_with_the_pipe();
    let done = match Task::parse() {
        Task::Demo => demo::run(),
        Task::Test(args) => test::run(&args),
        Task::Soak(args) => test::soak(&args),
        Task::Fuzz(args) => fuzz::run(&args),
        Task::Firmware(args) => firmware::run(&args),
        Task::Bench(args) => bench::run(&args),
        Task::Card(args) => card::run(&args),
        Task::Flash(args) => flash::run(&args),
        Task::Lab(args) => lab::run(&args),
        Task::Dist(args) => dist::run(&args),
        Task::Notice => notice::run(),
        Task::Modules => modules::run(),
        Task::Mutants(args) => mutants::run(&args),
        Task::Rulings => rulings::run(),
        Task::Wiring => wiring::run(),
        Task::Vsix => vsix::run(),
        Task::Setup => setup::run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
