//! The command line: `unoclp check`, `compile`, `list`, `sim`, `grade`, `run` and `card` on this PC,
//! `unoclp upload`, `unoclp monitor`, `unoclp settings` and `unoclp flash` on a board, `unoclp serve` for browsers,
//! `unoclp site` for the file that says what it serves, `unoclp lsp` for editors.
//!
//! Exit codes: 0 all is well; 1 a program has faults or an expectation was not met; 2 the command
//! could not be carried out.

use crate::commands::{
    self, At, Changes, Class, Doors, Firmware, Form, Leave, Machine, OfPlant, OfSite, Over, Paper,
    What, Wording, boards, in_portuguese, langs, language, naming_languages, refuse,
};
use crate::messages;
use anstream::eprintln;
use anyhow::anyhow;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::env;
use std::ffi::OsString;
use std::io;
use std::path::PathBuf;
use std::process::ExitCode;
use unoclp_core::Board;
use unoclp_draw::NARROWEST;
use unoclp_lang::Lang;

/// The unoclp PLC: check and simulate programs on this PC, upload them to a board and watch it
#[derive(Parser)]
#[command(name = "unoclp", version, arg_required_else_help = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// The language of the messages; by default, that of the system
    // `asked` has read it before.
    #[arg(long, global = true, value_parser = langs())]
    lang: Option<Lang>,
}

#[derive(Subcommand)]
enum Command {
    /// Check a program and show its size, or every fault with its line
    Check {
        /// The program: {programs}; - reads it from standard input
        file: PathBuf,
        #[command(flatten)]
        wording: Wording,
    },
    /// Compile a text to numeric code
    Compile {
        /// The text: {texts}; - reads it from standard input
        file: PathBuf,
        /// Where to write the numeric code; by default, or with -, to standard output
        #[arg(short, long, value_name = "PROGRAM.TXT")]
        output: Option<PathBuf>,
        #[command(flatten)]
        over: Over,
        #[command(flatten)]
        wording: Wording,
    },
    /// Copy a text, with free points in place of those that a board lacks
    Adapt {
        /// The text: Instruction List (.il), Structured Text (.st, .scl) or PLCopen XML (.xml); - reads it from standard input
        file: PathBuf,
        /// The new file for the copy; by default, or with -, standard output
        #[arg(short, long, value_name = "COPY")]
        output: Option<PathBuf>,
        #[command(flatten)]
        wording: Wording,
    },
    /// Show the units of a project in PLCopen XML, with their languages and variables
    Units {
        /// The project in PLCopen XML; - reads it from standard input
        file: PathBuf,
    },
    /// Show a program as a ladder diagram, block diagram or chart, as Instruction List, Structured Text or PLCopen XML, or as
    /// numeric code with its meaning
    List {
        /// The program: {programs}; - reads it from standard input
        file: PathBuf,
        #[command(flatten)]
        wording: Wording,
        /// The form of the listing
        #[arg(long = "as", value_name = "FORM", value_enum, default_value_t)]
        form: Form,
        /// Draw the diagram into this file, as vector graphics
        #[arg(long, value_name = "OUT.svg")]
        svg: Option<PathBuf>,
        /// Draw a ladder diagram on pages of this paper, for a report: OUT.svg, or OUT-1.svg and so on if there are several
        #[arg(long, value_name = "PAPER", value_enum, requires = "svg")]
        paper: Option<Paper>,
        /// The title of these pages; by default, the first comment of the program
        #[arg(long, value_name = "TEXT", requires = "paper")]
        title: Option<String>,
        #[command(flatten)]
        over: Over,
        /// The columns that a ladder diagram may take up
        #[arg(long, value_name = "N", default_value_t = 80,
            value_parser = clap::value_parser!(u16).range(NARROWEST as i64..=1000))]
        width: u16,
    },
    /// Simulate a program, by hand in this terminal or with a scenario
    Sim {
        /// The program, in any of the languages; it replaces the program that a scenario names
        file: Option<PathBuf>,
        /// Run this scenario without a terminal: print the changes, and compare them with what is expected
        #[arg(long, value_name = "S.toml")]
        scenario: Option<PathBuf>,
        /// Run only this case of the scenario, counted from 1
        #[arg(long, value_name = "N", requires = "scenario", value_parser = clap::value_parser!(u16).range(1..))]
        case: Option<u16>,
        /// Draw a timing diagram into this file: inputs, and expected and actual outputs; for a machine, pictures of it
        #[arg(long, value_name = "OUT.svg")]
        svg: Option<PathBuf>,
        /// Write a trace of all inputs, outputs and timers for a waveform viewer
        #[arg(long, value_name = "OUT.vcd")]
        vcd: Option<PathBuf>,
        #[command(flatten)]
        machine: Machine,
        #[command(flatten)]
        over: Over,
        #[command(flatten)]
        wording: Wording,
    },
    /// Check a machine that programs control, or draw it
    Plant {
        #[command(subcommand)]
        of: OfPlant,
    },
    /// Test the programs of a class with the cases of an exercise
    Grade {
        #[command(flatten)]
        class: Class,
    },
    /// Generate wrong programs from the solution of an exercise, and show which ones pass
    Mutants {
        /// The exercise: a scenario file with cases (.toml)
        exercise: PathBuf,
        #[command(flatten)]
        wording: Wording,
    },
    /// Run a program on this PC, and show its variables
    Run {
        #[command(flatten)]
        what: What,
    },
    /// Write a program to a memory card, or to a new card image
    Card {
        /// The folder of a mounted card, or a new image file (.img)
        card: PathBuf,
        /// The program: {programs}; - reads it from standard input
        file: PathBuf,
        /// Also create STATE.TXT, in which the board records inputs and outputs
        #[arg(long)]
        state: bool,
        #[command(flatten)]
        over: Over,
        #[command(flatten)]
        wording: Wording,
    },
    /// Upload a program to a board over its serial port, instead of using a card
    Upload {
        /// The program: {programs}; - reads it from standard input
        file: PathBuf,
        #[command(flatten)]
        wording: Wording,
        #[command(flatten)]
        at: At,
        #[command(flatten)]
        leave: Leave,
    },
    /// Write the firmware to a board through its boot loader, read it back and compare
    Flash {
        #[command(flatten)]
        what: Firmware,
    },
    /// Watch a board, force its inputs and outputs, and switch it to RUN or STOP
    Monitor {
        /// The program that the board runs, in any of the languages, to show its variables and rungs
        file: Option<PathBuf>,
        #[command(flatten)]
        wording: Wording,
        #[command(flatten)]
        at: At,
        /// Have the board release all forced points after this many seconds without a request
        #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u8).range(1..=254))]
        end_forcing: Option<u8>,
    },
    /// Serve the lab's page and, with --port or --site, share boards
    Serve {
        #[command(flatten)]
        doors: Doors,
    },
    /// Serve an editor through the Language Server Protocol, over standard input and output
    Lsp {
        /// The target board of the editor's programs
        #[arg(long, value_name = "BOARD", default_value = "uno", value_parser = boards())]
        board: Board,
    },
    /// Check a site file, which says which boards a gateway shares, and with whom
    Site {
        #[command(subcommand)]
        of: OfSite,
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
    let command = Arguments::command();
    match messages::spoken() {
        Lang::En => {
            let matches = naming_languages(command, Lang::En).get_matches();
            Arguments::from_arg_matches(&matches).unwrap_or_else(|error| error.exit())
        }
        Lang::Pt => naming_languages(in_portuguese(command), Lang::Pt)
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
        matches!(
            self,
            Command::Upload { .. } | Command::Settings { .. } | Command::Flash { .. }
        )
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

/// Does what the arguments of this process say.
pub fn run() -> ExitCode {
    messages::speak(asked().unwrap_or_else(environment));
    let command = arguments().command;
    if !command.changes_a_board() {
        end_with_the_pipe();
    }
    let outcome = match command {
        Command::Check { file, wording } => commands::check(&file, &wording),
        Command::Compile {
            file,
            output,
            over,
            wording,
        } => commands::compile(&file, output.as_deref(), over, &wording),
        Command::Adapt {
            file,
            output,
            wording,
        } => commands::adapt(&file, output.as_deref(), &wording),
        Command::Units { file } => commands::units(&file),
        Command::List {
            file,
            wording,
            form,
            svg,
            paper,
            title,
            over,
            width,
        } => {
            let picture = svg.as_deref().map(|file| commands::Picture {
                file,
                paper: paper.map(Paper::into),
                title: title.as_deref(),
                over,
            });
            commands::list(&file, &wording, form, picture, width.into())
        }
        Command::Sim {
            file,
            scenario,
            case,
            svg,
            vcd,
            machine,
            over,
            wording,
        } => match (file, scenario) {
            (None, None) if machine.plant().is_some() => {
                Err(anyhow!(messages::plant_without_program()))
            }
            (_, None) if svg.is_some() && machine.plant().is_none() => {
                Err(anyhow!(messages::svg_of_what()))
            }
            (Some(file), None) if machine.plant().is_some() => {
                commands::drive(&file, &machine, svg.as_deref(), over, &wording)
            }
            (file, Some(scenario)) => {
                let run = commands::Run {
                    program: file.as_deref(),
                    case: case.map(usize::from),
                    vcd: vcd.as_deref(),
                    svg: svg.as_deref(),
                    over,
                };
                commands::scenario(&scenario, run, &wording)
            }
            (Some(file), None) => commands::simulate(&file, vcd.as_deref(), over, &wording),
            (None, None) => Err(anyhow!(messages::nothing_to_simulate())),
        },
        Command::Plant { of } => commands::plant(&of),
        Command::Grade { class } => commands::grade(&class),
        Command::Mutants { exercise, wording } => commands::find_mutants(&exercise, &wording),
        Command::Run { what } => commands::run(what),
        Command::Card {
            card,
            file,
            state,
            over,
            wording,
        } => commands::card(&card, &file, state, over, &wording),
        Command::Upload {
            file,
            wording,
            at,
            leave,
        } => commands::upload(&file, &at.place(), &leave, &wording),
        Command::Flash { what } => commands::flash(&what),
        Command::Monitor {
            file,
            wording,
            at,
            end_forcing,
        } => commands::monitor(file.as_deref(), at.place(), end_forcing, &wording),
        Command::Serve { doors } => commands::serve(doors),
        Command::Lsp { board } => commands::lsp(board, asked()),
        Command::Site { of } => commands::site(&of),
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
