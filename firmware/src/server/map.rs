//! What each address stands for: the tables of `docs/modbus.md`.

use super::upload::Upload;
use crate::board::flash::{Codes, flash_codes};
use crate::board::{Board, stack};
use crate::engine::data::ON;
use crate::engine::memory::Memory;
use crate::operation::{Command, Operation, State};
use crate::settings::{self, Settings};
use crate::store;
use unoclp_core::isa::{ANALOGUE, COUNTER_DATA, COUNTERS, MARKERS, REGISTERS, TIMER_DATA};
use unoclp_core::{Image, Millis, Profile};
use unoclp_modbus::{Access, Device, Exception, Table};

const INPUTS: u16 = Profile::UNO.inputs as u16;
const OUTPUTS: u16 = Profile::UNO.outputs as u16;

// Coils.
const MARKER: u16 = 16;

// Input and holding registers of 32 bits: the high word first, at an even address.
const TIMER: u16 = 128;
const TIMER_COUNT: u16 = 2 * 87;
const COUNTER: u16 = 320;
const COUNTER_COUNT: u16 = 2 * COUNTERS as u16;
const REGISTER_COUNT: u16 = 2 * REGISTERS as u16;

// Input registers.
const DIAGNOSTICS: u16 = 16;
const DIAGNOSTICS_COUNT: u16 = 17;

// Holding registers.
const COMMAND: u16 = 400;
const FORCES: u16 = 402;
const FORCES_COUNT: u16 = 4;
const SETTINGS: u16 = 410;
const SETTINGS_COUNT: u16 = settings::COUNT as u16;
const WINDOW: u16 = 1000;

const _: () = assert!(TIMER_DATA == COUNTER_DATA);

/// The board as the server shows it, for one step.
pub struct Map<'a, 'm> {
    pub board: &'a Board,
    pub operation: &'a mut Operation,
    pub settings: &'a mut Settings,
    /// When the request came, ms since start.
    pub came: Millis,
    pub memory: Memory<'a>,
    pub upload: Option<&'a mut Upload<'m>>,
}

impl Map<'_, '_> {
    /// A word of the diagnostics, by its number from 0.
    #[inline(never)]
    fn diagnostic(&self, number: u16) -> u16 {
        let Map {
            board, operation, ..
        } = self;
        let line = operation.fault.and_then(|fault| fault.line).unwrap_or(0);
        let pair = match number {
            0 => return operation.state as u16,
            1 => return self.bits().into(),
            2 => {
                return operation
                    .fault
                    .map_or(0, |fault| fault.cause.number().into());
            }
            3 => return board.start as u16 + 1,
            4 | 5 => line,
            6 | 7 => self.came,
            8 => return operation.times.last(),
            9 => return operation.times.least(),
            10 => return operation.times.most(),
            11 => return stack::free(),
            12 | 13 => store::kept(&board.eeprom),
            14 => return board.analogue.reference(),
            15 => return board.watchdog.restarts(),
            _ => return board.watchdog.faults(),
        };
        if number & 1 == 0 {
            (pair >> 16) as u16
        } else {
            pair as u16
        }
    }

    /// A word of the values of 32 bits that input and holding registers have at the same addresses: what
    /// has elapsed of a timer or its preset, what a counter has counted or its preset; and of registers.
    /// 0 where the program does not have it.
    #[inline(never)]
    fn half(&self, input: bool, address: u16) -> u16 {
        let memory = &self.memory;
        let (area, at) = place(input, address);
        let bytes = match area {
            Area::Registers => memory.data.registers.as_flattened(),
            Area::Timers => &*memory.timers,
            Area::Counters => &*memory.counters,
        };
        let bytes = bytes.get(at..).unwrap_or_default();
        let long = if input && area == Area::Timers {
            elapsed(bytes, self.came)
        } else {
            u32_of(bytes)
        };
        if address & 1 == 0 {
            (long >> 16) as u16
        } else {
            long as u16
        }
    }

    fn bits(&self) -> u8 {
        let operation = &self.operation;
        u8::from(self.board.pins.stop())
            | u8::from(operation.stopped) << 1
            | u8::from(operation.forces.any()) << 2
            | u8::from(operation.uploading) << 3
            | u8::from(operation.card_failed) << 4
    }

    /// The command of this number, if it can be followed now.
    fn command(&self, number: u16) -> Result<Command, Exception> {
        let Operation {
            state, uploading, ..
        } = *self.operation;
        let fault = state == State::Fault;
        let held = self.board.pins.stop() || fault || uploading;
        let (command, now) = match number {
            1 => (Command::Run, !held),
            2 => (Command::Stop, !fault || uploading),
            3 => (Command::SingleScan, !held && state == State::Stop),
            4 => (Command::Restart, true),
            5 => (Command::Upload, state != State::Run),
            _ => return Err(Exception::IllegalDataValue),
        };
        if now {
            Ok(command)
        } else {
            Err(Exception::ServerDeviceFailure)
        }
    }

    /// Whether the program has the timer or counter whose preset is at this address.
    fn has_presets(&self, address: u16) -> bool {
        let (first, memory) = if address >= COUNTER {
            (COUNTER, &*self.memory.counters)
        } else {
            (TIMER, &*self.memory.timers)
        };
        // Both have data of the same size.
        usize::from((address - first) >> 1) * TIMER_DATA < memory.len()
    }
}

/// Where values of 32 bits stand.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Area {
    Registers,
    Timers,
    Counters,
}

/// Where the value of this address and its neighbour stands, low byte first; of a timer that is elapsed its
/// state stands there, and its time behind it.
#[inline(never)]
fn place(input: bool, address: u16) -> (Area, usize) {
    let (area, first, size, preset) = if address >= COUNTER {
        (Area::Counters, COUNTER, COUNTER_DATA, 4)
    } else if address >= TIMER {
        (Area::Timers, TIMER, TIMER_DATA, 5)
    } else {
        (Area::Registers, 0, 4, 0)
    };
    let at = usize::from((address - first) >> 1) * size;
    (area, if input { at } else { at + preset })
}

/// The first four bytes as a number.
fn u32_of(bytes: &[u8]) -> u32 {
    match bytes.first_chunk() {
        Some(bytes) => u32::from_le_bytes(*bytes),
        None => 0,
    }
}

/// What has elapsed of the timer with this data, ms: see `engine/timers.s`.
fn elapsed(data: &[u8], now: Millis) -> u32 {
    let [state, rest @ ..] = data else { return 0 };
    let mut time = u32_of(rest);
    if state & 1 != 0 {
        // One that has started since this request came has nothing behind it.
        time = (now.wrapping_sub(time) as i32).max(0) as u32;
    }
    time.min(u32_of(rest.get(4..).unwrap_or_default()))
}

/// Whether all addresses of a request lie in this range.
#[inline(never)]
fn within(first: u16, count: u16, start: u16, length: u16) -> bool {
    let offset = first.wrapping_sub(start);
    offset < length && count <= length - offset
}

impl Device for Map<'_, '_> {
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool {
        let within = |start, length| within(first, count, start, length);
        let long = || within(TIMER, TIMER_COUNT) || within(COUNTER, COUNTER_COUNT);
        match table {
            Table::Coils => within(0, OUTPUTS) || within(MARKER, MARKERS.into()),
            Table::DiscreteInputs => within(0, INPUTS),
            Table::InputRegisters => {
                within(0, ANALOGUE.into()) || within(DIAGNOSTICS, DIAGNOSTICS_COUNT) || long()
            }
            Table::HoldingRegisters => {
                within(0, REGISTER_COUNT)
                    || within(COMMAND, 1)
                    || within(FORCES, FORCES_COUNT)
                    || within(SETTINGS, SETTINGS_COUNT)
                    || long()
                        && (access == Access::Read
                            || self.has_presets(first.wrapping_add(count - 1)))
            }
        }
    }

    fn bit(&self, table: Table, address: u16) -> bool {
        let image = match table {
            Table::Coils if address >= MARKER => {
                let marker = self.memory.data.markers.get(usize::from(address - MARKER));
                return marker.is_some_and(|cell| cell & ON != 0);
            }
            Table::Coils => self.operation.outputs(),
            _ => self.operation.images.inputs(),
        };
        image.0 as u8 & bit(address) != 0
    }

    fn word(&self, table: Table, address: u16) -> u16 {
        let input = table == Table::InputRegisters;
        if input && address < DIAGNOSTICS {
            let reading = self.memory.data.analogue.get(usize::from(address));
            return reading.copied().unwrap_or_default();
        }
        if input && address < TIMER {
            return self.diagnostic(address - DIAGNOSTICS);
        }
        if address < COMMAND {
            return self.half(input, address);
        }
        let operation = &self.operation;
        match address {
            COMMAND => operation.state as u16,
            FORCES..SETTINGS => {
                let forces = operation.forces.0.get(usize::from(address - FORCES));
                forces.copied().unwrap_or(0).into()
            }
            _ => self.settings.get((address - SETTINGS) as u8),
        }
    }

    fn set_bit(&mut self, address: u16, on: bool) {
        if address >= MARKER {
            let index = usize::from(address - MARKER);
            if let Some(cell) = self.memory.data.markers.get_mut(index) {
                *cell = if on { ON } else { 0 };
            }
            return;
        }
        let images = &mut self.operation.images;
        let bit = u16::from(bit(address));
        let Image(outputs) = images.outputs();
        images.set_outputs(Image(if on { outputs | bit } else { outputs & !bit }));
    }

    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception> {
        if address == COMMAND {
            return self.command(value).map(|_| ());
        }
        let sound = if address < COMMAND {
            // A preset is not negative: its high word tells.
            address < TIMER || address & 1 != 0 || value < 0x8000
        } else if address < SETTINGS {
            let points = if address - FORCES < 2 {
                INPUTS
            } else {
                OUTPUTS
            };
            value < 1 << points
        } else if self.operation.state == State::Run {
            return Err(Exception::ServerDeviceFailure);
        } else {
            settings::allows((address - SETTINGS) as u8, value)
        };
        if sound {
            Ok(())
        } else {
            Err(Exception::IllegalDataValue)
        }
    }

    fn set_word(&mut self, address: u16, value: u16) {
        if address < COMMAND {
            let memory = &mut self.memory;
            let (area, at) = place(false, address);
            let bytes = match area {
                Area::Registers => memory.data.registers.as_flattened_mut(),
                Area::Timers => &mut *memory.timers,
                Area::Counters => &mut *memory.counters,
            };
            let at = if address & 1 == 0 { at + 2 } else { at };
            if let Some([low, high, ..]) = bytes.get_mut(at..) {
                [*low, *high] = value.to_le_bytes();
            }
        } else if address == COMMAND {
            if let Ok(command) = self.command(value) {
                self.operation.stopped = match command {
                    Command::Run => false,
                    Command::Stop => true,
                    _ => self.operation.stopped,
                };
                self.operation.command = Some(command);
            }
        } else if address < SETTINGS {
            let forces = &mut self.operation.forces.0;
            if let Some(place) = forces.get_mut(usize::from(address - FORCES)) {
                *place = value as u8;
            }
        } else {
            self.settings.set((address - SETTINGS) as u8, value);
            self.settings.save(&self.board.eeprom);
        }
    }

    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        if first != WINDOW {
            return None;
        }
        Some(match &mut self.upload {
            Some(upload) => upload.take(data),
            None => Err(Exception::ServerDeviceFailure),
        })
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let text = match object {
            0 => flash_codes!(Codes::plain("unoclp")),
            1 => flash_codes!(Codes::plain("unoclp UNO")),
            _ => flash_codes!(Codes::plain(env!("CARGO_PKG_VERSION"))),
        };
        text.at(index)
    }
}

/// The bit of the point at this address, 0 to 7.
fn bit(address: u16) -> u8 {
    1 << (address & 7)
}
