//! The firmware as an engine for scenarios.

use crate::sd::{Kind, SdCard};
use crate::{CYCLES_PER_MS, Edge, Error, Halt, Pin, Program, Slot, Space, Uno};
use unoclp_card::image::{Fat, Image as CardImage};
use unoclp_core::{Image, Inputs, Millis};
use unoclp_host_sim::scenario::{Engine, Outcome, Refusal};

/// The longest start-up that is waited for, ms: reading a long file takes a while.
const START_UP: u64 = 20_000;
/// The longest scan that is waited for, cycles.
const LONGEST_SCAN: u64 = 50 * CYCLES_PER_MS;
/// How long a refused program is watched with all buttons pressed, ms.
const WATCH: u64 = 20;

/// How the board's millisecond clock goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// It stands, and is set before each scan: host and board make the same scans.
    Lockstep,
    /// It goes by itself, from the timer interrupt: a scan of the scenario is all that the board
    /// does from one tick of the clock to the next.
    Running,
}

/// The firmware's ELF file on a simulated board, with a card for each program.
pub struct UnoEngine {
    program: Program,
    clock: Clock,
    scan: u32,
    tick: u32,
    millis: u32,
    uno: Option<Uno>,
    /// What the running clock will read after the tick that the board stands at.
    next: Option<Millis>,
}

/// Why the board did not do its work.
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// The simulation could not be set up.
    #[error(transparent)]
    Setup(#[from] Error),
    /// The firmware went no further.
    #[error("{0}; the serial port said {1:?}")]
    Halt(Halt, String),
    /// The firmware lacks a symbol that a simulation stops at or writes to.
    #[error("the firmware has no symbol `{0}`; is it an unoclp firmware?")]
    NoSymbol(&'static str),
    /// The card image could not be made.
    #[error("no card image: {0}")]
    Image(#[from] std::io::Error),
    /// An output moved before the first scan or at a fault (NC-7).
    #[error("output {} moved though no program ran", .0 + 1)]
    OutputMoved(u8),
    /// The serial port did not say what it must.
    #[error("the serial port said {0:?}")]
    Serial(String),
    /// A scan was asked for without a program.
    #[error("no program has been loaded")]
    NoProgram,
}

impl UnoEngine {
    /// An engine with this firmware.
    ///
    /// # Errors
    /// Where it is not an unoclp firmware.
    pub fn new(program: Program, clock: Clock) -> Result<UnoEngine, EngineError> {
        let symbol = |name, space| {
            let symbol = program.symbol(name).filter(|symbol| symbol.space == space);
            symbol
                .map(|symbol| symbol.address)
                .ok_or(EngineError::NoSymbol(name))
        };
        Ok(UnoEngine {
            scan: symbol("scan_begin", Space::Flash)?,
            tick: symbol("__vector_13", Space::Flash)?,
            millis: symbol("MILLIS", Space::Data)?,
            program,
            clock,
            uno: None,
            next: None,
        })
    }

    /// Powers a board with this slot and follows its start-up: to the first scan, or to a fault,
    /// after which all buttons are pressed for a while. No output may move.
    ///
    /// # Errors
    /// Where neither comes, or an output moves.
    pub fn start(&mut self, slot: Slot) -> Result<Result<(), Refusal>, EngineError> {
        self.next = None;
        let uno = self
            .uno
            .insert(Uno::with_program(self.program.clone(), slot)?);
        let limit = START_UP * CYCLES_PER_MS;
        let refusal = loop {
            match uno.run_until(self.scan, CYCLES_PER_MS) {
                Ok(()) => break None,
                Err(Halt::Timeout { .. }) if uno.cycles() < limit => {}
                Err(halt) => return Err(told(uno, halt)),
            }
            if let Some(refusal) = fault(&uno.serial())? {
                break Some(refusal);
            }
        };
        if refusal.is_some() {
            uno.set_inputs(0xFF);
            let run = uno.run_ms(WATCH);
            run.map_err(|halt| told(uno, halt))?;
        } else if !uno.serial().ends_with("RUN\r\n") {
            return Err(EngineError::Serial(uno.serial().into_owned()));
        }
        let moved = uno.edges().iter().find_map(|edge| match edge {
            Edge {
                pin: Pin::Output(output),
                ..
            } => Some(*output),
            _ => None,
        });
        match (moved, refusal) {
            (Some(output), _) => Err(EngineError::OutputMoved(output)),
            (None, Some(refusal)) => Ok(Err(refusal)),
            (None, None) => {
                if self.clock == Clock::Lockstep {
                    uno.stop_clock();
                }
                Ok(Ok(()))
            }
        }
    }

    /// The board, from the first start on.
    pub fn uno(&mut self) -> Option<&mut Uno> {
        self.uno.as_mut()
    }

    /// Runs until the board is at this address again.
    fn run_until(&mut self, address: u32) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        let run = uno.run_until(address, LONGEST_SCAN);
        run.map_err(|halt| told(uno, halt))
    }

    fn set_clock(&mut self, now: Millis) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        Ok(uno.write_ram(self.millis, &now.to_le_bytes())?)
    }

    fn set_inputs(&mut self, inputs: Image) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        uno.set_inputs(inputs.0 as u8);
        Ok(())
    }
}

impl Engine for UnoEngine {
    type Error = EngineError;

    fn load(&mut self, file: &[u8]) -> Result<Result<(), Refusal>, EngineError> {
        let image = CardImage::new(Fat::Fat16)
            .file("PROGRAM.TXT", file)
            .build()?;
        let card = SdCard::new(Kind::Sdhc, image)?;
        self.start(Slot::Card(card))
    }

    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, EngineError> {
        let inputs = inputs.points;
        match self.clock {
            Clock::Lockstep => {
                self.set_clock(now)?;
                self.set_inputs(inputs)?;
                self.run_until(self.scan)?;
            }
            Clock::Running => {
                let next = match self.next {
                    Some(next) => next,
                    None => {
                        self.run_until(self.tick)?;
                        self.set_clock(now.wrapping_sub(1))?;
                        now
                    }
                };
                for _ in 0..now.wrapping_sub(next) {
                    self.run_until(self.tick)?;
                }
                self.set_inputs(inputs)?;
                self.run_until(self.tick)?;
                self.next = Some(now.wrapping_add(1));
            }
        }
        let uno = self.uno.as_ref().ok_or(EngineError::NoProgram)?;
        Ok(Ok(Image(uno.outputs().into())))
    }
}

fn told(uno: &Uno, halt: Halt) -> EngineError {
    EngineError::Halt(halt, uno.serial().into_owned())
}

/// The fault that the serial port tells, once its line is complete.
fn fault(serial: &str) -> Result<Option<Refusal>, EngineError> {
    let Some((_, line)) = serial.split_once("\r\nfault ") else {
        return Ok(None);
    };
    let Some((line, _)) = line.split_once("\r\n") else {
        return Ok(None);
    };
    parse_fault(line)
        .map(Some)
        .ok_or_else(|| EngineError::Serial(serial.to_owned()))
}

/// `24, line 7: no such code`, or `51: no card answers …`
fn parse_fault(line: &str) -> Option<Refusal> {
    let (place, text) = line.split_once(": ")?;
    let (number, line) = match place.split_once(", line ") {
        Some((number, line)) => (number, Some(line.parse().ok()?)),
        None => (place, None),
    };
    let refusal = Refusal {
        number: number.parse().ok()?,
        line,
    };
    let cause = unoclp_core::Cause::ALL
        .iter()
        .find(|cause| cause.number() == refusal.number)?;
    (cause.text() == text).then_some(refusal)
}
