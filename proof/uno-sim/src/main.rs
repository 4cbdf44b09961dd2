//! The firmware on a simulated UNO: `unoclp-uno-sim demo`, with a script pressing its buttons, and `unoclp-uno-sim serve`,
//! with its serial port on a pseudo-terminal.

use annotate_snippets::Renderer;
use anyhow::{Context, Result, anyhow, bail};
use clap::{Parser, Subcommand, ValueEnum};
use signal_hook::consts::SIGPIPE;
use signal_hook::flag::register_conditional_default;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::Duration;
use unoclp_card::image::{Fat, Image as CardImage};
use unoclp_core::{Board, Image, Inputs, Millis};
use unoclp_exercise::scenario::{self, ProgramFile, Scenario, Verdict};
use unoclp_host_sim::engine::{Cell, Engine, Outcome, Refusal};
use unoclp_lang::{Lang, show};
use unoclp_program::{Refused, Written};
use unoclp_uno_sim::engine::{Clock, EngineError, UnoEngine};
use unoclp_uno_sim::port::{Options, Pace, Port};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{BootLoader, Error, Line, Parity, Program, Slot, Uno, firmware_file};

#[derive(Parser)]
#[command(version, about = "The unoclp firmware on a simulated Arduino UNO")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Boot the firmware with a card, let a scenario press the buttons, and show what happens
    Demo {
        /// The firmware, as `cargo xtask firmware` leaves it
        #[arg(long)]
        elf: PathBuf,
        /// The image of the card in the slot
        #[arg(long)]
        card: PathBuf,
        /// The scenario that presses the buttons
        #[arg(long)]
        scenario: PathBuf,
    },
    /// Run the firmware with its serial port on a pseudo-terminal, whose path is the first line of the output; until the
    /// input ends. A line `reset` of the input presses the reset button, `baud 57600` sets the rate at which the board receives
    Serve {
        /// The program, numeric code or Instruction List, for a card of its own; without it and --card the slot is empty
        #[arg(conflicts_with = "card")]
        program: Option<PathBuf>,
        /// The image of the card in the slot
        #[arg(long)]
        card: Option<PathBuf>,
        /// The file in which the EEPROM is kept, all of its bytes; made where there is none
        #[arg(long)]
        eeprom: Option<PathBuf>,
        /// The firmware, where it is not the UNO's that `cargo xtask firmware` has left; it says which board it is for
        #[arg(long)]
        elf: Option<PathBuf>,
        /// A board out of its box in place of the firmware: this boot loader, and a sketch that does nothing
        #[arg(long, value_enum, conflicts_with = "elf")]
        boot_loader: Option<BootLoaderName>,
        /// Bits a second at which the board receives
        #[arg(long, default_value_t = 115_200, value_parser = clap::value_parser!(u32).range(1..))]
        baud: u32,
        /// The parity with which the board receives
        #[arg(long, value_enum, default_value_t)]
        parity: ParityName,
        /// Hold the board back to real time always, not only while nothing is on the line
        #[arg(long)]
        realtime: bool,
        /// Reset the board each time the port is opened, as the real one is
        #[arg(long)]
        reset: bool,
    },
}

#[derive(Clone, Copy, Default, ValueEnum)]
enum ParityName {
    #[default]
    None,
    Even,
    Odd,
}

impl From<ParityName> for Parity {
    fn from(name: ParityName) -> Parity {
        match name {
            ParityName::None => Parity::None,
            ParityName::Even => Parity::Even,
            ParityName::Odd => Parity::Odd,
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
enum BootLoaderName {
    /// That of UNOs and newer Nanos
    Optiboot,
    /// The one that Nanos had before
    Old,
    /// That of Megas
    Mega,
}

impl BootLoaderName {
    fn program(self) -> Result<Program, Error> {
        match self {
            BootLoaderName::Optiboot => BootLoader::Optiboot,
            BootLoaderName::Old => BootLoader::Old,
            BootLoaderName::Mega => BootLoader::Mega,
        }
        .program()
    }
}

fn main() -> Result<ExitCode> {
    // Whoever reads no more of the output wants no more of it.
    register_conditional_default(SIGPIPE, Arc::new(AtomicBool::new(true)))?;
    match Arguments::parse().command {
        Command::Demo {
            elf,
            card,
            scenario,
        } => demo(&elf, &card, &scenario),
        Command::Serve {
            program,
            card,
            eeprom,
            elf,
            boot_loader,
            baud,
            parity,
            realtime,
            reset,
        } => {
            let chip = match boot_loader {
                Some(boot_loader) => boot_loader.program()?,
                None => Program::read(&elf.map_or_else(firmware_file, Ok)?)?,
            };
            let board = chip.chip().board();
            let image = match (program, card) {
                (Some(program), _) => Some(
                    CardImage::new(Fat::Fat16)
                        .file("PROGRAM.TXT", numeric(&program, board)?)
                        .build()?,
                ),
                (None, Some(card)) => Some(file("card image", &card)?),
                (None, None) => None,
            };
            let slot = match image {
                Some(image) => Slot::Card(SdCard::new(Kind::Sdhc, image)?),
                None => Slot::Empty,
            };
            let parity = parity.into();
            let options = Options {
                pace: match realtime {
                    true => Pace::RealTime,
                    false => Pace::Quiet,
                },
                reset_on_open: reset,
            };
            let kept = eeprom.map(Kept::open).transpose()?;
            serve(chip, slot, kept, Line { baud, parity }, options)
        }
    }
}

fn file(what: &str, path: &Path) -> Result<Vec<u8>> {
    std::fs::read(path).with_context(|| format!("the {what} {} cannot be read", path.display()))
}

/// A program as numeric code: what is written in Instruction List is compiled.
fn numeric(path: &Path, board: Board) -> Result<Vec<u8>> {
    let written = Written::new(path.display().to_string(), file("program", path)?, board);
    if !written.is_text() {
        // With its faults, if it has any: the board tells them.
        return Ok(written.bytes);
    }
    match written.check(None) {
        Ok(source) => Ok(source.code),
        Err(Refused::Text {
            name,
            text,
            diagnostics,
        }) => {
            let shown = show(&name, &text, &diagnostics, Lang::En, &Renderer::plain());
            bail!("{name} has errors\n{}", shown.trim_end())
        }
        Err(Refused::Numeric { written, .. }) => bail!("{} is no program", written.name),
        Err(Refused::NoProgram { name, .. }) => bail!("{name} is no program"),
    }
}

/// The file in which an EEPROM is kept.
struct Kept {
    path: PathBuf,
    /// What stands there.
    bytes: Option<Vec<u8>>,
}

impl Kept {
    /// That of an earlier board, or one to be made.
    fn open(path: PathBuf) -> Result<Kept> {
        let bytes = match std::fs::read(&path) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => {
                return Err(error)
                    .with_context(|| format!("the EEPROM {} cannot be read", path.display()));
            }
        };
        Ok(Kept { path, bytes })
    }

    /// The program of a board that has this EEPROM.
    fn put_into(&self, program: Program) -> Result<Program> {
        let Some(bytes) = &self.bytes else {
            return Ok(program);
        };
        let own = program.chip().eeprom_len();
        program.with_eeprom(bytes.clone()).map_err(|length| {
            let path = self.path.display();
            anyhow!(
                "{path} has {length} bytes and is no EEPROM, which has {own}; it is left as it is"
            )
        })
    }

    /// Keeps what the board has, where it differs from what stands there.
    fn keep(&mut self, port: &Port) -> Result<()> {
        let now = port.with(|uno| uno.read_eeprom(0, uno.chip().eeprom_len()))??;
        if self.bytes.as_ref() != Some(&now) {
            std::fs::write(&self.path, &now)
                .with_context(|| format!("the EEPROM {} cannot be written", self.path.display()))?;
            self.bytes = Some(now);
        }
        Ok(())
    }
}

/// How often the board is looked after.
const LOOK: Duration = Duration::from_millis(100);

/// What a line of the input asks for.
enum Wish {
    Reset,
    Baud(u32),
}

impl Wish {
    /// What else comes asks for nothing.
    fn of(line: &str) -> Option<Wish> {
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            ["reset"] => Some(Wish::Reset),
            ["baud", rate] => rate.parse().ok().filter(|&rate| rate > 0).map(Wish::Baud),
            _ => None,
        }
    }

    fn fulfil(self, port: &Port, parity: Parity) -> Result<()> {
        match self {
            Wish::Reset => port.with(Uno::reset)?,
            Wish::Baud(baud) => port.with(move |uno| uno.set_serial_line(Line { baud, parity }))?,
        }
        Ok(())
    }
}

/// The wishes of the input, until it ends; an error is an end too.
fn wishes() -> Receiver<Wish> {
    let (wishes, wished) = mpsc::channel();
    std::thread::spawn(move || {
        let lines = std::io::stdin().lines().map_while(Result::ok);
        for wish in lines.filter_map(|line| Wish::of(&line)) {
            if wishes.send(wish).is_err() {
                return;
            }
        }
    });
    wished
}

fn serve(
    mut program: Program,
    slot: Slot,
    mut kept: Option<Kept>,
    line: Line,
    options: Options,
) -> Result<ExitCode> {
    if let Some(kept) = &kept {
        program = kept.put_into(program)?;
    }
    let port = Port::open(program, slot, options)?;
    port.with(move |uno| uno.set_serial_line(line))?;
    let mut out = std::io::stdout();
    writeln!(out, "{}", port.path().display())?;
    out.flush()?;
    let wishes = wishes();
    while port.is_running() {
        match wishes.recv_timeout(LOOK) {
            Ok(wish) => wish.fulfil(&port, line.parity)?,
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => break,
        }
        if let Some(kept) = &mut kept {
            kept.keep(&port)?;
        }
    }
    if let Some(kept) = &mut kept
        && port.is_running()
    {
        kept.keep(&port)?;
    }
    port.close()?;
    Ok(ExitCode::SUCCESS)
}

/// The state is written at most once a second, ms.
const LATER: u64 = 1_100;

fn demo(elf: &Path, card: &Path, scenario: &Path) -> Result<ExitCode> {
    let scenario = Scenario::load(scenario, Board::UNO)?;
    let card = SdCard::new(Kind::Sdhc, file("card image", card)?)?;
    let engine = UnoEngine::new(Program::read(elf)?, Clock::Running)?;

    println!(
        "\n{}\n\nThe program on the card says of itself:",
        scenario.about(Lang::En)
    );
    for line in opening(scenario.program()) {
        println!("{}", format!("   {line}").trim_end());
    }
    let mut show = Show {
        engine,
        card,
        started: None,
        last: None,
    };
    let report = scenario::check(&scenario, &mut show);
    println!();
    match report.verdict {
        Verdict::Met { .. } => {
            println!("Every LED did what was expected of it, in every millisecond.");
            if let Some(state) = show.engine.uno().and_then(state) {
                println!("\nIn the card's STATE.TXT the board has noted:");
                for line in state.lines() {
                    println!("  {line}");
                }
                println!();
            }
            println!("To press the buttons yourself, without a board:");
            println!("  cargo run -- sim {}", scenario.program().name);
            Ok(ExitCode::SUCCESS)
        }
        verdict => bail!("{verdict}"),
    }
}

/// What has been written to the card, once the board has come to it.
fn state(uno: &mut Uno) -> Option<String> {
    uno.run_ms(LATER).ok()?;
    let card = uno.card()?;
    let block = card.log().writes.last()?.block;
    let bytes = card.image().chunks_exact(512).nth(block)?;
    Some(String::from_utf8_lossy(bytes).trim_end().to_owned())
}

/// The comment at the head of a program. Of one that has faults the board itself tells them.
fn opening(program: &ProgramFile) -> Vec<String> {
    let written = Written::new(program.name.clone(), program.bytes.clone(), Board::UNO);
    let source = written.check(None).ok();
    source.map_or_else(Vec::new, |source| source.map.title)
}

/// The engine, with everything that changes told as it comes.
struct Show {
    engine: UnoEngine,
    card: SdCard,
    /// Reading of the clock at the first scan.
    started: Option<Millis>,
    last: Option<(Image, Image)>,
}

impl Engine for Show {
    type Error = EngineError;

    /// The program is the one on the card in the slot.
    fn load(&mut self, _: &[u8]) -> Result<Result<(), Refusal>, EngineError> {
        let started = self.engine.start(Slot::Card(self.card.clone()))?;
        if let Some(uno) = self.engine.uno() {
            println!("\nThe serial port says:");
            for line in uno.serial().trim().lines() {
                println!("  {line}");
            }
        }
        println!("\n  seconds   buttons         LEDs");
        println!("            I1 I2 I3 I4     Q1 Q2 Q3 Q4");
        Ok(started)
    }

    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, EngineError> {
        let outcome = self.engine.scan(inputs, now)?;
        // At a fault all outputs are 0.
        let (inputs, outputs) = (inputs.points, outcome.unwrap_or_default());
        let started = *self.started.get_or_insert(now);
        if self.last.replace((inputs, outputs)) != Some((inputs, outputs)) {
            let seconds = f64::from(now.wrapping_sub(started)) / 1000.0;
            let buttons: String = signs(inputs, "▣", "·");
            let leds: String = signs(outputs, "●", "○");
            println!("  {seconds:7.3}   {buttons}      {leds}");
        }
        Ok(outcome)
    }

    fn restart(&mut self) -> Result<(), EngineError> {
        self.engine.restart()
    }

    fn look(&mut self, cell: Cell) -> Result<i32, EngineError> {
        self.engine.look(cell)
    }

    fn poke(&mut self, cell: Cell, value: i32) -> Result<(), EngineError> {
        self.engine.poke(cell, value)
    }

    fn pwm(&mut self, output: u8) -> Result<u8, EngineError> {
        self.engine.pwm(output)
    }
}

/// A sign for each of the four points of an image.
fn signs(image: Image, on: &str, off: &str) -> String {
    let sign = |bit: u16| if image.0 >> bit & 1 == 1 { on } else { off };
    (0..4).map(sign).collect::<Vec<_>>().join("  ")
}
