//! The command line: `unoclp check`, `compile`, `list`, `sim`, `run` and `card` on this PC,
//! `unoclp upload`, `unoclp monitor` and `unoclp settings` on a board, `unoclp serve` for browsers.
//!
//! Exit codes: 0 all is well; 1 a program has faults or an expectation was not met; 2 the command
//! could not be carried out.

mod commands;

use annotate_snippets::Renderer;
use anstream::{eprintln, print, println};
use anyhow::{anyhow, bail};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use commands::{
    At, Changes, Doors, Form, Il, Kind, Leave, Shown, What, cannot_write, check_written, create,
    in_portuguese, langs, language, open, read, refuse, running,
};
use ratatui::crossterm::terminal;
use std::env;
use std::ffi::OsString;
use std::io::{self, BufWriter, IsTerminal, Write, stdin, stdout};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use unoclp_cli::panel::{self, App};
use unoclp_cli::{ascii, messages};
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::scenario::{LoadError, ProgramFile, Scenario, Verdict, check};
use unoclp_host_sim::wave::{RecordedEngine, Recorder};
use unoclp_ladder::NARROWEST;
use unoclp_lang::Lang;
use unoclp_source::{Written, is_text, list, point_names};

/// The unoclp PLC: check and simulate programs on this PC, upload them to a board and watch it
#[derive(Parser)]
#[command(name = "unoclp", version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// The language in which everything is told; else that of the environment
    // `asked` has read it before.
    #[arg(long, global = true, value_parser = langs())]
    lang: Option<Lang>,
}

#[derive(Subcommand)]
enum Command {
    /// Check a program: its size, or every fault with its line
    Check {
        /// The program, in numeric code, Instruction List (.il) or Structured Text (.st)
        file: PathBuf,
        #[command(flatten)]
        il: Il,
    },
    /// Compile a program in Instruction List to numeric code
    Compile {
        /// The program in Instruction List
        file: PathBuf,
        /// Where to write the numeric code; to standard output without it, and for -
        #[arg(short, long, value_name = "PROGRAM.TXT")]
        output: Option<PathBuf>,
        #[command(flatten)]
        il: Il,
    },
    /// Show a program as a ladder diagram, as Instruction List, or as numeric code with its meaning
    List {
        /// The program, in numeric code, Instruction List (.il) or Structured Text (.st)
        file: PathBuf,
        #[command(flatten)]
        il: Il,
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
        /// The program, in numeric code, Instruction List (.il) or Structured Text (.st); with a scenario, runs instead of the program that it names
        file: Option<PathBuf>,
        /// Run this scenario without a terminal: print what changes, and compare it
        #[arg(long, value_name = "S.toml")]
        scenario: Option<PathBuf>,
        /// Write the trace of all inputs, outputs and timers for a wave viewer
        #[arg(long, value_name = "OUT.vcd")]
        vcd: Option<PathBuf>,
        #[command(flatten)]
        il: Il,
    },
    /// Run a text in a typed language on this PC, and show its variables
    Run {
        #[command(flatten)]
        what: What,
    },
    /// Put a program on a memory card, or on a new image of one
    Card {
        /// The folder of a mounted card, or a new image file (.img)
        card: PathBuf,
        /// The program, in numeric code, Instruction List (.il) or Structured Text (.st)
        file: PathBuf,
        /// With STATE.TXT, in which the board then keeps inputs and outputs
        #[arg(long)]
        state: bool,
        #[command(flatten)]
        il: Il,
    },
    /// Put a program on a board, over its serial port, in place of a card
    Upload {
        /// The program, in numeric code, Instruction List (.il) or Structured Text (.st)
        file: PathBuf,
        #[command(flatten)]
        il: Il,
        #[command(flatten)]
        at: At,
        #[command(flatten)]
        leave: Leave,
    },
    /// Watch a board, force its inputs and outputs, and let it run and stop
    Monitor {
        /// The program that it runs, to show its rungs, timers and counters
        file: Option<PathBuf>,
        #[command(flatten)]
        il: Il,
        #[command(flatten)]
        at: At,
        /// Have the board let go all that is forced after so many seconds without a request
        #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u8).range(1..=254))]
        end_forcing: Option<u8>,
    },
    /// Serve the lab's page, and with --port share the board at that port
    Serve {
        #[command(flatten)]
        doors: Doors,
    },
    /// Show and set a board's address, rate, parity, direction pin and lock
    Settings {
        #[command(flatten)]
        at: At,
        #[command(flatten)]
        changes: Changes,
    },
}

/// The arguments; without right ones this ends here, with what is wrong.
fn arguments() -> Arguments {
    match messages::spoken() {
        Lang::En => Arguments::parse(),
        Lang::Pt => in_portuguese(Arguments::command())
            .try_get_matches_from(help_behind(env::args_os().collect()))
            .and_then(|matches| Arguments::from_arg_matches(&matches))
            .unwrap_or_else(|error| refuse(&error)),
    }
}

/// The same arguments with `help list` as `list --help`: clap explains its command `help` in English alone.
fn help_behind(mut arguments: Vec<OsString>) -> Vec<OsString> {
    let is_value = |at: usize| at > 0 && arguments[at - 1] == "--lang";
    let is_command =
        |at: &usize| !is_value(*at) && !arguments[*at].to_string_lossy().starts_with('-');
    let command = (1..arguments.len()).find(is_command);
    if let Some(at) = command.filter(|&at| arguments[at] == "help") {
        arguments.remove(at);
        arguments.push("--help".into());
    }
    arguments
}

/// The language that the arguments ask for, by --lang: it must be known before anything is said of them.
fn asked() -> Option<Lang> {
    let arguments: Vec<String> = env::args_os()
        .map(|argument| argument.to_string_lossy().into_owned())
        .collect();
    let behind = arguments.windows(2).filter(|pair| pair[0] == "--lang");
    let names = behind.map(|pair| pair[1].as_str());
    let joined = arguments
        .iter()
        .filter_map(|argument| argument.strip_prefix("--lang="));
    names.chain(joined).find_map(language)
}

/// That of the environment.
fn environment() -> Lang {
    let value = |name: &str| env::var(name).ok().filter(|value| !value.is_empty());
    let value = ["LC_ALL", "LC_MESSAGES", "LANG"]
        .into_iter()
        .find_map(value);
    value.as_deref().and_then(language).unwrap_or_default()
}

impl Command {
    /// Whether it must not end before a board is as it is to be.
    fn changes_a_board(&self) -> bool {
        matches!(self, Command::Upload { .. } | Command::Settings { .. })
    }
}

/// Ends this quietly once nobody reads its output any more.
fn end_with_the_pipe() {
    #[cfg(unix)]
    if let Err(error) = signal_hook::flag::register_conditional_default(
        signal_hook::consts::SIGPIPE,
        std::sync::Arc::new(std::sync::atomic::AtomicBool::new(true)),
    ) {
        eprintln!("{}", messages::warning(messages::io(&error)));
    }
}

/// Whether what the command was asked about is well.
type Outcome = anyhow::Result<bool>;

fn main() -> ExitCode {
    messages::speak(asked().unwrap_or_else(environment));
    let command = arguments().command;
    if !command.changes_a_board() {
        end_with_the_pipe();
    }
    let outcome = match command {
        Command::Check { file, il } => commands::check(&file, &il),
        Command::Compile { file, output, il } => commands::compile(&file, output.as_deref(), &il),
        Command::List {
            file,
            il,
            form,
            svg,
            width,
        } => list_file(&file, &il, form, svg.as_deref(), width.into()),
        Command::Sim {
            file,
            scenario,
            vcd,
            il,
        } => match (file, scenario) {
            (file, Some(scenario)) => run_scenario(&scenario, file.as_deref(), vcd.as_deref(), &il),
            (Some(file), None) => simulate(&file, vcd.as_deref(), &il),
            (None, None) => Err(anyhow!(messages::nothing_to_simulate())),
        },
        Command::Run { what } => commands::run(what),
        Command::Card {
            card,
            file,
            state,
            il,
        } => commands::card(&card, &file, state, &il),
        Command::Upload {
            file,
            il,
            at,
            leave,
        } => commands::upload(&file, &at.place(), &leave, &il),
        Command::Monitor {
            file,
            il,
            at,
            end_forcing,
        } => commands::monitor(file.as_deref(), at.place(), end_forcing, &il),
        Command::Serve { doors } => commands::serve(doors),
        Command::Settings { at, changes } => commands::settings(&at.place(), &changes),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            let told = match error.downcast_ref::<io::Error>() {
                Some(error) => messages::io(error),
                None => error.to_string(),
            };
            eprintln!("{}", messages::error(told));
            ExitCode::from(2)
        }
    }
}

fn list_file(path: &Path, il: &Il, form: Form, svg: Option<&Path>, width: usize) -> Outcome {
    if svg.is_some() && form != Form::Ladder {
        bail!(messages::svg_is_a_ladder());
    }
    let Some(program) = open(path, il, Shown::Here)? else {
        return Ok(false);
    };
    let Some(svg) = svg else {
        let listing = list::list(&program, form.into(), width, messages::spoken());
        match form {
            Form::Ladder => print!("{}", ascii::picture(&listing)),
            // These are programs, which stay as they are.
            Form::Il | Form::Numeric => print!("{listing}"),
        }
        return Ok(true);
    };
    let drawing = list::svg(&program, width, messages::spoken());
    create(svg, Kind::Drawing, &[path])?
        .write_all(drawing.as_bytes())
        .map_err(cannot_write(svg))?;
    println!("{}", messages::drawn(svg.display()));
    Ok(true)
}

fn simulate(path: &Path, vcd: Option<&Path>, il: &Il) -> Outcome {
    let Some(program) = open(path, il, Shown::Here)? else {
        return Ok(false);
    };
    if !(stdin().is_terminal() && stdout().is_terminal()) {
        bail!(messages::sim_needs_terminal());
    }
    let names = point_names(&program);
    let mut app = App::new(program);
    if let Some(vcd) = vcd {
        app.record_to(Recorder::new(trace(vcd, &[path])?).with_names(names));
    }
    panel::run(app)?;
    Ok(true)
}

fn run_scenario(path: &Path, program: Option<&Path>, vcd: Option<&Path>, il: &Il) -> Outcome {
    let wrong = |error: LoadError| anyhow!(error.text(messages::spoken()));
    let named = Scenario::program_of(path).map_err(wrong)?;
    let program = match (program, &named) {
        (Some(program), _) => Some(program),
        // Its errors are shown as `check` shows them.
        (None, Some(named)) if is_text(named, &[]) => Some(named.as_path()),
        (None, _) => None,
    };
    let mut source = None;
    let scenario = match program {
        None => Scenario::load(path).map_err(wrong)?,
        Some(program) => {
            let ProgramFile { name, bytes } = read(program)?;
            let written = Written::new(name.clone(), bytes.clone());
            // Numeric code is run as it is: a scenario may expect a fault of it.
            let bytes = match written.is_text {
                false => bytes,
                true => match check_written(written, il, Shown::Here) {
                    Some(checked) => source.insert(checked).code.clone(),
                    None => return Ok(false),
                },
            };
            Scenario::load_for(path, ProgramFile { name, bytes }).map_err(wrong)?
        }
    };
    let report = match vcd {
        None => check(&scenario, &mut HostEngine::default()),
        Some(vcd) => {
            let inputs = [Some(path), program, named.as_deref()];
            let inputs: Vec<&Path> = inputs.into_iter().flatten().collect();
            let names = source.as_ref().map(point_names).unwrap_or_default();
            let recorder = Recorder::new(trace(vcd, &inputs)?).with_names(names);
            let mut engine = RecordedEngine::new(recorder);
            let report = check(&scenario, &mut engine);
            engine.finish().map_err(cannot_write(vcd))?;
            report
        }
    };
    println!("{}", ascii::picture(&report.text(messages::spoken())));
    if let Verdict::WrongStop {
        came: Some((_, refusal)),
        ..
    } = report.verdict
        && let Some(fault) = refusal.fault()
    {
        let program = scenario.program();
        let read = || Written::new(program.name.clone(), program.bytes.clone());
        if let Some(source) = source.or_else(|| read().check(None).ok()) {
            println!("  {}", running(&source, fault).replace('\n', "\n  "));
        }
    }
    Ok(report.passed())
}

/// Opens a file for the trace of a run; the command reads `inputs`.
fn trace(path: &Path, inputs: &[&Path]) -> anyhow::Result<Box<dyn Write>> {
    let file = create(path, Kind::Trace, inputs)?;
    Ok(Box::new(BufWriter::new(file)))
}

/// How excerpts of a program are shown.
fn renderer() -> Renderer {
    let mut renderer = Renderer::styled();
    if stdout().is_terminal()
        && let Ok((width, _)) = terminal::size()
    {
        renderer = renderer.term_width(width.into());
    }
    renderer
}
