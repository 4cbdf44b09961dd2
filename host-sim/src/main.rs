//! The command line: `unoclp check`, `unoclp list` and `unoclp sim` on this PC, `unoclp upload`, `unoclp
//! monitor` and `unoclp settings` on a board.
//!
//! Exit codes: 0 all is well; 1 a program has faults or an expectation was not met; 2 the command
//! could not be carried out.

mod commands;

use annotate_snippets::Renderer;
use anstream::{eprintln, print, println};
use anyhow::{Context, anyhow, bail};
use clap::{Parser, Subcommand};
use commands::{At, Changes};
use ratatui::crossterm::terminal;
use std::fs::File;
use std::io::{BufWriter, IsTerminal, Write, stdin, stdout};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use unoclp_host_sim::diagnosis::{Diagnosis, diagnose, show};
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::list::{self, Form};
use unoclp_host_sim::panel::{self, App};
use unoclp_host_sim::scenario::{ProgramFile, Scenario, check};
use unoclp_host_sim::wave::{RecordedEngine, Recorder};
use unoclp_ladder::NARROWEST;

/// The unoclp PLC: check and simulate programs on this PC, upload them to a board and watch it
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
    /// Show a program as a ladder diagram, or as numeric code with the meaning of each line
    List {
        /// The program file
        file: PathBuf,
        /// What to list it as
        #[arg(long = "as", value_name = "FORM", value_enum, default_value_t)]
        form: Form,
        /// Draw the ladder diagram into this file, as vector graphics
        #[arg(long, value_name = "OUT.svg")]
        svg: Option<PathBuf>,
        /// The columns that a ladder diagram may take
        #[arg(long, value_name = "N", default_value_t = 80,
            value_parser = clap::value_parser!(u16).range(NARROWEST as i64..=1000))]
        width: u16,
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
    /// Put a program on a board, over its serial port, in place of a card
    Upload {
        /// The program file
        file: PathBuf,
        #[command(flatten)]
        at: At,
        /// Leave the board in STOP
        #[arg(long)]
        stop: bool,
    },
    /// Watch a board, force its inputs and outputs, and let it run and stop
    Monitor {
        /// The program that it runs, to show its rungs, timers and counters
        file: Option<PathBuf>,
        #[command(flatten)]
        at: At,
    },
    /// Show and set a board's address, rate, parity and direction pin
    Settings {
        #[command(flatten)]
        at: At,
        #[command(flatten)]
        changes: Changes,
    },
}

/// Whether what the command was asked about is well.
type Outcome = anyhow::Result<bool>;

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::Check { file } => check_file(&file),
        Command::List {
            file,
            form,
            svg,
            width,
        } => list_file(&file, form, svg.as_deref(), width.into()),
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
        Command::Upload { file, at, stop } => commands::upload(&file, &at.line(), stop),
        Command::Monitor { file, at } => commands::monitor(file.as_deref(), at.line()),
        Command::Settings { at, changes } => commands::settings(&at.line(), &changes),
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

fn list_file(path: &Path, form: Form, svg: Option<&Path>, width: usize) -> Outcome {
    if svg.is_some() && form != Form::Ladder {
        bail!("--svg draws a ladder diagram; leave out --as, or --svg");
    }
    let program = read(path)?;
    if let Err(faults) = diagnose(&program.bytes) {
        return Ok(refuse(&program, &faults));
    }
    let Some(svg) = svg else {
        print!("{}", list::list(&program.bytes, form, width)?);
        return Ok(true);
    };
    let drawing = list::svg(&program.bytes, path, width)?;
    create(svg)?
        .write_all(drawing.as_bytes())
        .with_context(|| cannot_write(svg))?;
    println!("{}: drawn", svg.display());
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
