//! `unoclp-uno-sim demo`: the firmware on a simulated UNO, with a script pressing its buttons.

use anyhow::{Context, Result, bail};
use clap::{Parser, Subcommand};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use unoclp_core::{Image, Millis};
use unoclp_host_sim::scenario::{self, Engine, Refusal, Scenario, Verdict};
use unoclp_uno_sim::engine::{Clock, EngineError, UnoEngine};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{Program, Slot, Uno};

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
}

fn main() -> Result<ExitCode> {
    let Command::Demo {
        elf,
        card,
        scenario,
    } = Arguments::parse().command;
    demo(&elf, &card, &scenario)
}

/// The state is written at most once a second, ms.
const LATER: u64 = 1_100;

fn demo(elf: &Path, card: &Path, scenario: &Path) -> Result<ExitCode> {
    let scenario = Scenario::load(scenario)?;
    let image = std::fs::read(card)
        .with_context(|| format!("the card image {} cannot be read", card.display()))?;
    let card = SdCard::new(Kind::Sdhc, image)?;
    let engine = UnoEngine::new(Program::read(elf)?, Clock::Running)?;

    println!(
        "\n{}\n\nThe program on the card says of itself:",
        scenario.about()
    );
    for line in opening(&scenario.program().bytes).lines() {
        println!("  {line}");
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

/// The comment at the head of a program, up to its first code.
fn opening(program: &[u8]) -> String {
    let text = String::from_utf8_lossy(program);
    let comment = |line: &str| line.trim().strip_prefix('/').map(str::to_owned);
    let lines: Vec<String> = text.lines().map_while(comment).collect();
    lines.join("\n")
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

    fn scan(&mut self, inputs: Image, now: Millis) -> Result<Image, EngineError> {
        let outputs = self.engine.scan(inputs, now)?;
        let started = *self.started.get_or_insert(now);
        if self.last.replace((inputs, outputs)) != Some((inputs, outputs)) {
            let seconds = f64::from(now.wrapping_sub(started)) / 1000.0;
            let buttons: String = signs(inputs, "▣", "·");
            let leds: String = signs(outputs, "●", "○");
            println!("  {seconds:7.3}   {buttons}      {leds}");
        }
        Ok(outputs)
    }
}

/// A sign for each of the four points of an image.
fn signs(image: Image, on: &str, off: &str) -> String {
    let sign = |bit: u16| if image.0 >> bit & 1 == 1 { on } else { off };
    (0..4).map(sign).collect::<Vec<_>>().join("  ")
}
