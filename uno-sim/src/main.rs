//! The firmware on a simulated UNO: `unoclp-uno-sim demo`, with a script pressing its buttons, and `unoclp-uno-sim serve`,
//! with its serial port on a pseudo-terminal.

use anyhow::{Context, Result, bail};
use clap::{Parser, Subcommand, ValueEnum};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;
use unoclp_card::image::{Fat, Image as CardImage};
use unoclp_core::{Image, Inputs, Millis};
use unoclp_host_sim::scenario::{
    self, Cell, Engine, Outcome, ProgramFile, Refusal, Scenario, Verdict,
};
use unoclp_source::Written;
use unoclp_uno_sim::engine::{Clock, EngineError, UnoEngine};
use unoclp_uno_sim::port::{Options, Pace, Port};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{Line, Parity, Program, Slot, Uno, firmware_elf};

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
    /// input ends
    Serve {
        /// The program, for a card of its own
        #[arg(required_unless_present = "card", conflicts_with = "card")]
        program: Option<PathBuf>,
        /// The image of the card in the slot
        #[arg(long)]
        card: Option<PathBuf>,
        /// The firmware, where it is not the one that `cargo xtask firmware` has left
        #[arg(long)]
        elf: Option<PathBuf>,
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

fn main() -> Result<ExitCode> {
    match Arguments::parse().command {
        Command::Demo {
            elf,
            card,
            scenario,
        } => demo(&elf, &card, &scenario),
        Command::Serve {
            program,
            card,
            elf,
            baud,
            parity,
            realtime,
            reset,
        } => {
            let elf = elf.map_or_else(firmware_elf, Ok)?;
            let image = match (program, card) {
                (Some(program), _) => CardImage::new(Fat::Fat16)
                    .file("PROGRAM.TXT", file("program", &program)?)
                    .build()?,
                (None, card) => file("card image", &card.context("no card")?)?,
            };
            let parity = parity.into();
            let options = Options {
                pace: match realtime {
                    true => Pace::RealTime,
                    false => Pace::Quiet,
                },
                reset_on_open: reset,
            };
            serve(&elf, image, Line { baud, parity }, options)
        }
    }
}

fn file(what: &str, path: &Path) -> Result<Vec<u8>> {
    std::fs::read(path).with_context(|| format!("the {what} {} cannot be read", path.display()))
}

/// How often the board is looked after.
const LOOK: Duration = Duration::from_millis(100);

fn serve(elf: &Path, image: Vec<u8>, line: Line, options: Options) -> Result<ExitCode> {
    let card = SdCard::new(Kind::Sdhc, image)?;
    let port = Port::open(Program::read(elf)?, Slot::Card(card), options)?;
    port.with(move |uno| uno.set_serial_line(line))?;
    let mut out = std::io::stdout();
    writeln!(out, "{}", port.path().display())?;
    out.flush()?;
    let (ends, ended) = mpsc::channel::<()>();
    std::thread::spawn(move || {
        // Whatever comes; an error is an end too.
        let mut input = std::io::stdin().lock();
        while matches!(input.read(&mut [0; 64]), Ok(1..)) {}
        drop(ends);
    });
    while port.is_running() && ended.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {}
    port.close()?;
    Ok(ExitCode::SUCCESS)
}

/// The state is written at most once a second, ms.
const LATER: u64 = 1_100;

fn demo(elf: &Path, card: &Path, scenario: &Path) -> Result<ExitCode> {
    let scenario = Scenario::load(scenario)?;
    let card = SdCard::new(Kind::Sdhc, file("card image", card)?)?;
    let engine = UnoEngine::new(Program::read(elf)?, Clock::Running)?;

    println!(
        "\n{}\n\nThe program on the card says of itself:",
        scenario.about()
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
    let written = Written::new(program.name.clone(), program.bytes.clone());
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
