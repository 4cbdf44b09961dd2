//! The command line: `unoclp check` and `unoclp sim`.
//!
//! Exit codes: 0 all is well; 1 a program has faults or an expectation was not met; 2 the command
//! could not be carried out.

use annotate_snippets::Renderer;
use anstream::{eprintln, println};
use anyhow::{Context, anyhow, bail};
use clap::{Parser, Subcommand};
use ratatui::crossterm::terminal;
use std::fs::File;
use std::io::{BufWriter, IsTerminal, Write, stdin, stdout};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use unoclp_host_sim::diagnosis::{Diagnosis, diagnose, show};
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::panel::{self, App};
use unoclp_host_sim::scenario::{ProgramFile, Scenario, check};
use unoclp_host_sim::wave::{RecordedEngine, Recorder};

/// The unoclp PLC on this PC: check programs and simulate them
#[derive(Parser)]
#[command(name = "unoclp", version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Check a program: its size, or every fault with its line
    Check {
        /// The program file, as it will stand on the card as PROGRAM.TXT
        file: PathBuf,
    },
    /// Simulate a program, by hand in this terminal or by a scenario
    Sim {
        /// The program file; with a scenario, runs instead of the program that it names
        file: Option<PathBuf>,
        /// Run this scenario without a terminal: print what changes, and compare it
        #[arg(long, value_name = "S.toml")]
        scenario: Option<PathBuf>,
        /// Write the trace of all inputs, outputs and timers for a wave viewer
        #[arg(long, value_name = "OUT.vcd")]
        vcd: Option<PathBuf>,
    },
}

/// Whether what the command was asked about is well.
type Outcome = anyhow::Result<bool>;

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::Check { file } => check_file(&file),
        Command::Sim {
            file,
            scenario,
            vcd,
        } => match (file, scenario) {
            (file, Some(scenario)) => run_scenario(&scenario, file.as_deref(), vcd.as_deref()),
            (Some(file), None) => simulate(&file, vcd.as_deref()),
            (None, None) => Err(anyhow!(
                "nothing to simulate; name a program or a --scenario"
            )),
        },
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn check_file(path: &Path) -> Outcome {
    let program = read(path)?;
    match diagnose(&program.bytes) {
        Ok(size) => println!("{}: OK: {size}", program.name),
        Err(faults) => return Ok(refuse(&program, &faults)),
    }
    Ok(true)
}

fn simulate(path: &Path, vcd: Option<&Path>) -> Outcome {
    let program = read(path)?;
    if let Err(faults) = diagnose(&program.bytes) {
        return Ok(refuse(&program, &faults));
    }
    if !(stdin().is_terminal() && stdout().is_terminal()) {
        bail!("the simulator needs a terminal; without one, run a scenario: --scenario S.toml");
    }
    let mut app = App::new(program.name, program.bytes)?;
    if let Some(vcd) = vcd {
        app.record_to(Recorder::new(create(vcd)?));
    }
    panel::run(app)?;
    Ok(true)
}

fn run_scenario(path: &Path, program: Option<&Path>, vcd: Option<&Path>) -> Outcome {
    let mut scenario = Scenario::load(path)?;
    if let Some(program) = program {
        scenario = scenario.with_program(read(program)?);
    }
    let report = match vcd {
        None => check(&scenario, &mut HostEngine::default()),
        Some(vcd) => {
            let mut engine = RecordedEngine::new(Recorder::new(create(vcd)?));
            let report = check(&scenario, &mut engine);
            engine.finish().with_context(|| cannot_write(vcd))?;
            report
        }
    };
    println!("{report}");
    Ok(report.passed())
}

/// Shows the faults; what was asked about is not well.
fn refuse(program: &ProgramFile, faults: &[Diagnosis]) -> bool {
    let mut renderer = Renderer::styled();
    if stdout().is_terminal()
        && let Ok((width, _)) = terminal::size()
    {
        renderer = renderer.term_width(width.into());
    }
    println!("{}", show(&program.name, &program.bytes, faults, &renderer));
    false
}

fn read(path: &Path) -> anyhow::Result<ProgramFile> {
    let name = path.display().to_string();
    match std::fs::read(path) {
        Ok(bytes) => Ok(ProgramFile { name, bytes }),
        Err(error) => bail!("{name} cannot be read ({error}); check its name and folder"),
    }
}

fn create(path: &Path) -> anyhow::Result<Box<dyn Write>> {
    let file = File::create(path).with_context(|| cannot_write(path))?;
    Ok(Box::new(BufWriter::new(file)))
}

fn cannot_write(path: &Path) -> String {
    format!("{} cannot be written", path.display())
}
