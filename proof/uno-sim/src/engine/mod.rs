//! The firmware as an engine for scenarios, on whatever simulates the board.

mod error;
mod kept;
mod memory;
mod simulated;
mod told;

use crate::inputs::MOST_ANALOGUE;
use crate::{CYCLES_PER_MS, Halt, Program, Slot, Space, Uno};
pub use error::EngineError;
use memory::{Memory, ON};
pub use simulated::Simulated;
use told::{fault, served_fault};
use unoclp_card::image::{Fat, Image as CardImage};
use unoclp_core::{Board, Image, Inputs, Loader, Millis};
use unoclp_host_sim::engine::{Cell, Engine, Outcome, Refusal};

/// The longest start-up that is waited for, ms: reading a long file takes a while.
const START_UP: u64 = 20_000;
/// How long a board that starts runs on before it is looked at what it has said, ms.
const LOOK: u64 = 10;
/// The longest scan that is waited for, cycles.
const LONGEST_SCAN: u64 = 50 * CYCLES_PER_MS;
/// How long a refused program is watched with all buttons pressed, ms.
const WATCH: u64 = 20;

/// How long a board is left alone before its power is cut, ms: it writes retentive markers and a record of
/// numbers to its EEPROM beside its scans.
const BEFORE_CUT: u64 = 320;
/// How long a clock stands meanwhile, ms: what goes on beside the scans waits for it.
const STANDING: u64 = 4;

/// How the board's millisecond clock goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// It stands, and is set before each scan: host and board make the same scans.
    Lockstep,
    /// It goes by itself, from the timer interrupt: a scan of the scenario is all that the board
    /// does from one tick of the clock to the next.
    Running,
}

/// On simavr.
pub type UnoEngine = FirmwareEngine<Uno>;

/// The firmware's ELF file on a simulated board ([`Uno`], [`crate::avr8js::Avr8js`]), with a card for each program.
pub struct FirmwareEngine<S> {
    program: Program,
    clock: Clock,
    scan: u32,
    tick: u32,
    millis: u32,
    age: u32,
    memory: Memory,
    /// The highest register that the program has: the memory after it is another's.
    registers: u8,
    /// Which analogue inputs have been set to other than 0: to set one is to drive its pin.
    analogue: [bool; MOST_ANALOGUE],
    uno: Option<S>,
    /// What the running clock will read after the tick that the board stands at.
    next: Option<Millis>,
}

impl<S: Simulated> FirmwareEngine<S> {
    /// An engine with this firmware.
    ///
    /// # Errors
    /// Where it is not an unoclp firmware.
    pub fn new(program: Program, clock: Clock) -> Result<FirmwareEngine<S>, EngineError> {
        let symbol = |name, space| {
            let symbol = program.symbol(name).filter(|symbol| symbol.space == space);
            symbol
                .map(|symbol| symbol.address)
                .ok_or(EngineError::NoSymbol(name))
        };
        Ok(FirmwareEngine {
            scan: symbol("scan_begin", Space::Flash)?,
            tick: symbol(program.chip().tick(), Space::Flash)?,
            millis: symbol("MILLIS", Space::Data)?,
            age: symbol("AGE", Space::Data)?,
            memory: Memory::of(&program),
            registers: program.chip().board().engine.near_registers,
            analogue: Default::default(),
            program,
            clock,
            uno: None,
            next: None,
        })
    }

    /// What the board has that the firmware is for.
    pub fn board(&self) -> Board {
        self.program.chip().board()
    }

    /// The board, from the first start on.
    pub fn uno(&mut self) -> Option<&mut S> {
        self.uno.as_mut()
    }

    /// Follows the start-up of a board that has just got its power.
    fn follow_start(&mut self) -> Result<Result<(), Refusal>, EngineError> {
        self.next = None;
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        let limit = uno.cycles() + START_UP * CYCLES_PER_MS;
        let refusal = loop {
            match uno.run_until(self.scan, LOOK * CYCLES_PER_MS) {
                Ok(()) => break None,
                Err(Halt::Timeout { .. }) if uno.cycles() < limit => {}
                Err(halt) => return Err(told(uno, halt)),
            }
            if let Some(refusal) = fault(&said(uno))? {
                break Some(refusal);
            }
        };
        if refusal.is_some() {
            uno.set_inputs(u32::MAX);
            let run = uno.run_cycles(WATCH * CYCLES_PER_MS);
            run.map_err(|halt| told(uno, halt))?;
        } else if !uno.serial().ends_with(b"RUN\r\n") {
            return Err(EngineError::Serial(said(uno)));
        }
        match (uno.moved_output(), refusal) {
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

    /// Runs until the board is at this address again.
    fn run_until(&mut self, address: u32) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        let run = uno.run_until(address, LONGEST_SCAN);
        run.map_err(|halt| told(uno, halt))
    }

    fn set_clock(&mut self, now: Millis) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        let now = now.to_le_bytes();
        if uno.read_ram(self.millis, 4)? != now {
            uno.write_ram(self.millis, &now)?;
            // As the clock's interrupt does.
            uno.write_ram(self.age, &[1])?;
        }
        Ok(())
    }

    /// Sets what stands at the pins. The converter takes its time beside the scans, so in lockstep the
    /// readings that it will give are put where the firmware keeps them.
    fn set_inputs(&mut self, inputs: &Inputs) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        uno.set_inputs(inputs.points.0 as u32);
        if inputs.analogue == Inputs::default().analogue && !self.analogue.contains(&true) {
            return Ok(());
        }
        let readings = self.memory.readings()?;
        let most = self.program.chip().board().analogue;
        let channels = inputs.analogue.iter().zip(&mut self.analogue);
        let channels = channels.take(most.into());
        for (index, (&reading, driven)) in channels.enumerate() {
            *driven |= reading != 0;
            if *driven {
                uno.set_reading(index, reading);
            }
            let place = readings + 2 * index as u32;
            if self.clock == Clock::Lockstep {
                uno.write_ram(place, &reading.to_le_bytes())?;
            }
        }
        Ok(())
    }

    /// Runs to where the board is at this address again, or tells a fault.
    fn scan_to(&mut self, address: u32) -> Result<Option<Refusal>, EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        let Err(halt) = uno.run_until(address, LONGEST_SCAN) else {
            return Ok(None);
        };
        // A scan that ends in a fault is the last; from then on the board serves Modbus.
        match served_fault(uno).map_err(|halt| told(uno, halt))? {
            Some(refusal) => match uno.outputs() {
                0 => Ok(Some(refusal)),
                outputs => Err(EngineError::OutputMoved(outputs.trailing_zeros() as u8)),
            },
            None => Err(told(uno, halt)),
        }
    }
}

impl UnoEngine {
    /// Powers a board with this slot and follows its start-up: to the first scan, or to a fault,
    /// after which all buttons are pressed for a while. No output may move.
    ///
    /// # Errors
    /// Where neither comes, or an output moves.
    pub fn start(&mut self, slot: Slot) -> Result<Result<(), Refusal>, EngineError> {
        self.uno = Some(Uno::with_program(self.program.clone(), slot)?);
        self.follow_start()
    }
}

/// The highest register that a program has.
fn registers(file: &[u8], board: Board) -> u8 {
    let mut memory = vec![0; board.linked_bytes.into()];
    let mut loader = Loader::new(&mut memory, board);
    for &byte in file {
        // A fault is the board's to tell.
        let _ = loader.push(byte);
    }
    let program = loader.finish();
    program.map_or(board.engine.near_registers, |program| {
        program.registers() as u8
    })
}

impl<S: Simulated> Engine for FirmwareEngine<S> {
    type Error = EngineError;

    fn load(&mut self, file: &[u8]) -> Result<Result<(), Refusal>, EngineError> {
        let image = CardImage::new(Fat::Fat16)
            .file("PROGRAM.TXT", file)
            .build()?;
        self.analogue = Default::default();
        self.registers = registers(file, self.program.chip().board());
        self.uno = Some(S::powered(&self.program, image, self.uno.take())?);
        self.follow_start()
    }

    /// A real power cut. Before it the board goes on for a while, with its clock standing in lockstep.
    fn restart(&mut self) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        let now = uno.read_ram(self.millis, 1)?.first().copied();
        for slice in 0..BEFORE_CUT / STANDING {
            if let (Clock::Lockstep, Some(now)) = (self.clock, now) {
                // It goes on by a millisecond, and back.
                uno.write_ram(self.millis, &[now.wrapping_add(slice as u8 & 1)])?;
                uno.write_ram(self.age, &[1])?;
            }
            let run = uno.run_cycles(STANDING * CYCLES_PER_MS);
            run.map_err(|halt| told(uno, halt))?;
        }
        uno.cut_power();
        match self.follow_start()? {
            Ok(()) => Ok(()),
            Err(refusal) => Err(EngineError::Serial(refusal.to_string())),
        }
    }

    fn look(&mut self, cell: Cell) -> Result<i32, EngineError> {
        let uno = self.uno.as_ref().ok_or(EngineError::NoProgram)?;
        match cell {
            Cell::Marker(number) => {
                let place = self.memory.marker(number)?;
                let on = uno.read_ram(place, 1)?.iter().any(|cell| cell & ON != 0);
                Ok(on.into())
            }
            Cell::Register(number) if number > self.registers => Ok(0),
            Cell::Register(number) => {
                let place = self.memory.register(number)?;
                let bytes = uno.read_ram(place, 4)?.first_chunk();
                Ok(bytes.map_or(0, |bytes| i32::from_le_bytes(*bytes)))
            }
        }
    }

    fn poke(&mut self, cell: Cell, value: i32) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        match cell {
            Cell::Marker(number) => {
                let place = self.memory.marker(number)?;
                uno.write_ram(place, &[if value == 0 { 0 } else { ON }])?;
            }
            Cell::Register(number) if number > self.registers => {}
            Cell::Register(number) => {
                let place = self.memory.register(number)?;
                uno.write_ram(place, &value.to_le_bytes())?;
            }
        }
        Ok(())
    }

    /// From the pulses that the timers make: of a count of 256, or nearly so of another.
    fn pwm(&mut self, output: u8) -> Result<u8, EngineError> {
        let uno = self.uno.as_ref().ok_or(EngineError::NoProgram)?;
        let pulses = uno.pwm(usize::from(output).wrapping_sub(1));
        Ok(pulses.map_or(0, |pulses| duty(pulses.high, pulses.period)))
    }

    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, EngineError> {
        match self.clock {
            Clock::Lockstep => {
                self.set_clock(now)?;
                self.set_inputs(inputs)?;
                if let Some(refusal) = self.scan_to(self.scan)? {
                    return Ok(Err(refusal));
                }
            }
            Clock::Running => {
                let next = match self.next {
                    Some(next) => next,
                    None => {
                        self.run_until(self.tick)?;
                        // Time 0 is when scanning began: the board would take a jump of its clock for a long scan.
                        if now > 0 {
                            self.set_clock(now.wrapping_sub(1))?;
                        }
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

fn told(uno: &impl Simulated, halt: Halt) -> EngineError {
    EngineError::Halt(halt, said(uno))
}

/// What the serial port said.
fn said(uno: &impl Simulated) -> String {
    String::from_utf8_lossy(uno.serial()).into_owned()
}

/// The value that makes these pulses: the timer of D6 counts to 256, that of D9 to 2000, of which 125 are
/// 16 of the value; a pin is high for one count more than the timer is told.
fn duty(high: u64, period: u64) -> u8 {
    let counted = |counts: u64| (high * counts / period).saturating_sub(1);
    let value = if period.is_multiple_of(2000) {
        (counted(2000) * 16).div_ceil(125)
    } else {
        counted(256)
    };
    value.min(255) as u8
}
