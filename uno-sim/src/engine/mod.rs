//! The firmware as an engine for scenarios.

use crate::sd::{Kind, SdCard};
use crate::{Analogue, CYCLES_PER_MS, Edge, Error, Halt, Pin, Program, Slot, Space, Uno};
use unoclp_card::image::{Fat, Image as CardImage};
use unoclp_core::isa::{ANALOGUE, NEAR_REGISTERS};
use unoclp_core::{Image, Inputs, Loader, Millis, Profile};
use unoclp_host_sim::scenario::{Cell, Engine, Outcome, Refusal};
use unoclp_modbus::Crc;
use unoclp_modbus::eeprom::program as kept;

/// The longest start-up that is waited for, ms: reading a long file takes a while.
const START_UP: u64 = 20_000;
/// The longest scan that is waited for, cycles.
const LONGEST_SCAN: u64 = 50 * CYCLES_PER_MS;
/// How long a refused program is watched with all buttons pressed, ms.
const WATCH: u64 = 20;

/// Cycles in which a board answers a short request at 115200 baud.
const ANSWER: u64 = 10 * CYCLES_PER_MS;
/// How long a board is left alone before its power is cut, ms: it writes retentive markers and a record of
/// numbers to its EEPROM beside its scans.
const BEFORE_CUT: u64 = 320;
/// How long a clock stands meanwhile, ms: what goes on beside the scans waits for it.
const STANDING: u64 = 4;

/// How long a board waits for a card that is not there, ms.
const EMPTY_SLOT: u8 = 240;
/// By how much its clock is put forward meanwhile, ms.
const FORWARD: u8 = 24;

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
    age: u32,
    memory: Memory,
    /// The highest register that the program has: the memory behind it is another's.
    registers: u8,
    /// Which analogue inputs have been set to other than 0: to set one is to drive its pin.
    analogue: [bool; ANALOGUE as usize],
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

/// Where the firmware keeps what scenarios look at and set: in `PAGE`, from there so many bytes on
/// (`firmware/src/engine/data.rs`).
#[derive(Clone, Copy)]
struct Memory {
    page: Option<u32>,
}

/// The data of the program, which ends where the page does, so that registers go on behind it.
const DATA: u32 = 512 - 227;
/// Two bytes for each reading of an analogue input, A 00 first.
const READINGS: u32 = DATA + 17;
/// A byte for each marker, M 01 first; its highest bit counts.
const MARKERS: u32 = DATA + 35;
/// Four bytes for each register, D 01 first.
const REGISTERS: u32 = DATA + 99;
/// A marker that is 1.
const ON: u8 = 0x80;

impl Memory {
    fn of(program: &Program) -> Memory {
        let page = program.symbol("PAGE");
        let page = page.filter(|symbol| symbol.space == Space::Data);
        Memory {
            page: page.map(|symbol| symbol.address),
        }
    }

    /// The address of this place in the page.
    fn at(self, place: u32) -> Result<u32, EngineError> {
        self.page
            .map(|page| page + place)
            .ok_or(EngineError::NoSymbol("PAGE"))
    }
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
            age: symbol("AGE", Space::Data)?,
            memory: Memory::of(&program),
            registers: NEAR_REGISTERS,
            analogue: Default::default(),
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
        self.uno = Some(Uno::with_program(self.program.clone(), slot)?);
        self.follow_start()
    }

    /// Powers a board that has kept this program, with no card in its slot, and follows its start-up. That takes much
    /// less time than to read a card and to keep what is on it. All else in its EEPROM is as the chip comes.
    ///
    /// # Errors
    /// Where it comes neither to the first scan nor to a fault, or an output moves.
    pub fn start_kept(
        &mut self,
        program: &unoclp_core::Program<'_>,
    ) -> Result<Result<(), Refusal>, EngineError> {
        self.analogue = Default::default();
        self.registers = program.registers() as u8;
        let stored = program.stored();
        let head = kept::head(stored.len() as u16);
        let [high, low] = kept::sum(stored).to_be_bytes();
        let all = [&[kept::VALID][..], &head, &[low, high], stored].concat();
        let mut uno = Uno::with_program(self.program.clone(), Slot::Empty)?;
        uno.write_eeprom(kept::MARK, &all)?;
        // It waits for a card by its clock, which no program sees yet.
        for _ in 0..EMPTY_SLOT / FORWARD {
            uno.run_ms(1).map_err(|halt| told(&uno, halt))?;
            let now = uno.read_ram(self.millis, 1)?.first().copied();
            let now = now.unwrap_or_default().saturating_add(FORWARD);
            uno.write_ram(self.millis, &[now])?;
        }
        self.uno = Some(uno);
        self.follow_start()
    }

    /// Follows the start-up of a board that has just got its power.
    fn follow_start(&mut self) -> Result<Result<(), Refusal>, EngineError> {
        self.next = None;
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        let limit = uno.cycles() + START_UP * CYCLES_PER_MS;
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
        uno.set_inputs(inputs.points.0 as u8);
        if inputs.analogue == Inputs::default().analogue && !self.analogue.contains(&true) {
            return Ok(());
        }
        let readings = self.memory.at(READINGS)?;
        for (index, &reading) in inputs.analogue.iter().enumerate() {
            let driven = &mut self.analogue[index];
            *driven |= reading != 0;
            if *driven {
                uno.set_analogue(index, Analogue::Reading(reading));
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

/// The highest register that a program has.
fn registers(file: &[u8]) -> u8 {
    let mut memory = [0; Profile::UNO.linked_bytes as usize];
    let mut loader = Loader::new(&mut memory, Profile::UNO);
    for &byte in file {
        // A fault is the board's to tell.
        let _ = loader.push(byte);
    }
    let program = loader.finish();
    program.map_or(NEAR_REGISTERS, |program| program.registers() as u8)
}

impl Engine for UnoEngine {
    type Error = EngineError;

    fn load(&mut self, file: &[u8]) -> Result<Result<(), Refusal>, EngineError> {
        let image = CardImage::new(Fat::Fat16)
            .file("PROGRAM.TXT", file)
            .build()?;
        let card = SdCard::new(Kind::Sdhc, image)?;
        self.analogue = Default::default();
        self.registers = registers(file);
        self.start(Slot::Card(card))
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
            let run = uno.run_ms(STANDING);
            run.map_err(|halt| told(uno, halt))?;
        }
        uno.power_up();
        uno.take_serial();
        uno.take_edges();
        match self.follow_start()? {
            Ok(()) => Ok(()),
            Err(refusal) => Err(EngineError::Serial(refusal.to_string())),
        }
    }

    fn look(&mut self, cell: Cell) -> Result<i32, EngineError> {
        let uno = self.uno.as_ref().ok_or(EngineError::NoProgram)?;
        match cell {
            Cell::Marker(number) => {
                let place = self.memory.at(MARKERS + u32::from(number) - 1)?;
                let on = uno.read_ram(place, 1)?.iter().any(|cell| cell & ON != 0);
                Ok(on.into())
            }
            Cell::Register(number) if number > self.registers => Ok(0),
            Cell::Register(number) => {
                let place = self.memory.at(REGISTERS + 4 * (u32::from(number) - 1))?;
                let bytes = uno.read_ram(place, 4)?.first_chunk();
                Ok(bytes.map_or(0, |bytes| i32::from_le_bytes(*bytes)))
            }
        }
    }

    fn poke(&mut self, cell: Cell, value: i32) -> Result<(), EngineError> {
        let uno = self.uno.as_mut().ok_or(EngineError::NoProgram)?;
        match cell {
            Cell::Marker(number) => {
                let place = self.memory.at(MARKERS + u32::from(number) - 1)?;
                uno.write_ram(place, &[if value == 0 { 0 } else { ON }])?;
            }
            Cell::Register(number) if number > self.registers => {}
            Cell::Register(number) => {
                let place = self.memory.at(REGISTERS + 4 * (u32::from(number) - 1))?;
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

/// The fault that a board in FAULT tells over Modbus (`docs/modbus.md`); none where it does not answer, or
/// is in another state.
fn served_fault(uno: &mut Uno) -> Result<Option<Refusal>, Halt> {
    // Of server 1: input registers 16 to 21.
    let request = [1, 4, 0, 16, 0, 6];
    uno.take_serial();
    uno.send_serial(&[&request[..], &Crc::of(&request).to_bytes()].concat());
    uno.run_cycles(ANSWER)?;
    let reply = uno.take_serial();
    let [1, 4, 12, words @ .., _, _] = &reply[..] else {
        return Ok(None);
    };
    let word = |index: usize| u16::from_be_bytes([words[2 * index], words[2 * index + 1]]);
    let in_fault = words.len() == 12 && word(0) == 3;
    let line = || u32::from(word(4)) << 16 | u32::from(word(5));
    Ok(in_fault.then(|| Refusal {
        number: word(2) as u8,
        line: Some(line()).filter(|&line| line != 0),
    }))
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
