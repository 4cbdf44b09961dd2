//! What each address stands for: the tables of `docs/modbus.md`.

use super::upload::Upload;
use crate::board::flash::{Codes, flash_codes};
use crate::board::{Board, stack};
use crate::engine::data::ON;
use crate::engine::memory::Memory;
use crate::operation::{Command, Operation, State};
use crate::settings::{self, Settings};
use crate::store;
use unoclp_core::isa::{COUNTER_DATA, TIMER_DATA};
use unoclp_core::{Image, Millis};
use unoclp_modbus::eeprom::program;
use unoclp_modbus::map::{PRODUCT, Span, VENDOR, coil, discrete, flag, form, holding, input};
use unoclp_modbus::{Access, Device, Exception, Table};

const MARKER: u16 = coil::MARKERS.first;
const TIMER: u16 = input::TIMERS.first;
const COUNTER: u16 = input::COUNTERS.first;
const DIAGNOSTICS: u16 = input::STATE.first;
const COMMAND: u16 = holding::COMMAND.first;
const FORCES: u16 = holding::FORCED_INPUTS.first;
const SETTINGS: u16 = holding::SETTINGS.first;

// Input and holding registers have these at the same addresses.
const _: () = assert!(TIMER == holding::TIMERS.first && COUNTER == holding::COUNTERS.first);
const _: () = assert!(TIMER_DATA == COUNTER_DATA);

/// The forces, as [`Forces`](crate::operation::Forces) has them.
const FORCED: Span = Span {
    values: 4,
    ..holding::FORCED_INPUTS
};

/// The words of the diagnostics, by their numbers from 0.
mod number {
    use super::*;

    /// All of them, which are one range.
    pub const DIAGNOSTICS: Span = Span {
        values: input::FAULTS.end() - super::DIAGNOSTICS,
        ..input::STATE
    };

    const fn of(span: Span) -> u16 {
        span.first - super::DIAGNOSTICS
    }

    pub const STATE: u16 = of(input::STATE);
    pub const FLAGS: u16 = of(input::FLAGS);
    pub const FAULT: u16 = of(input::FAULT);
    pub const CAUSE: u16 = of(input::CAUSE);
    pub const LINE: u16 = of(input::LINE);
    pub const UPTIME: u16 = of(input::UPTIME);
    pub const LAST: u16 = of(input::SCAN_TIMES);
    pub const LEAST: u16 = LAST + 1;
    pub const MOST: u16 = LAST + 2;
    pub const FREE_STACK: u16 = of(input::FREE_STACK);
    pub const PROGRAM: u16 = of(input::PROGRAM_BYTES);
    pub const SUPPLY: u16 = of(input::SUPPLY);
    pub const RESTARTS: u16 = of(input::RESTARTS);
}

/// The board as the server shows it, for one step.
pub struct Map<'a, 'm> {
    pub board: &'a Board,
    pub operation: &'a mut Operation,
    pub settings: &'a mut Settings,
    /// When the request came, ms since start.
    pub came: Millis,
    pub memory: Memory<'a>,
    pub upload: Option<&'a mut Upload<'m>>,
    /// The number of the block that ended the last upload, where its program was stored.
    pub ended: Option<u8>,
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
            number::STATE => return operation.state as u16,
            number::FLAGS => return u16::from(self.bits()) | form::bits(program::VERSION),
            number::FAULT => {
                return operation
                    .fault
                    .map_or(0, |fault| fault.cause.number().into());
            }
            number::CAUSE => return board.start as u16 + 1,
            number::LINE..number::UPTIME => line,
            number::UPTIME..number::LAST => self.came,
            number::LAST => return operation.times.last(),
            number::LEAST => return operation.times.least(),
            number::MOST => return operation.times.most(),
            number::FREE_STACK => return stack::free(),
            number::PROGRAM..number::SUPPLY => store::kept(&board.eeprom),
            number::SUPPLY => return board.analogue.reference(),
            number::RESTARTS => return board.watchdog.restarts(),
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
        let bit = |is_set, flag: u16| u8::from(is_set) << flag.trailing_zeros();
        bit(self.board.pins.stop(), flag::STOP_SWITCH)
            | bit(operation.stopped, flag::STOPPED)
            | bit(operation.forces.any(), flag::FORCED)
            | bit(operation.uploading, flag::UPLOAD)
            | bit(operation.card_failed, flag::CARD_FAILED)
    }

    /// The command of this number, if it can be followed now.
    fn command(&self, number: u16) -> Result<Command, Exception> {
        let Operation {
            state, uploading, ..
        } = *self.operation;
        let fault = state == State::Fault;
        let held = self.board.pins.stop() || fault || uploading;
        let command = Command::of(number).ok_or(Exception::IllegalDataValue)?;
        let now = match command {
            Command::Run => !held,
            Command::Stop => !fault || uploading,
            Command::SingleScan => !held && state == State::Stop,
            Command::Restart => true,
            Command::Upload => state != State::Run && !uploading,
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

/// Where a span begins, and how many addresses it has: as numbers, since a constant that is handed on as a
/// whole would take RAM.
const fn range(span: Span) -> (u16, u16) {
    (span.first, span.addresses())
}

/// Whether all addresses of a request lie in this range.
#[inline(never)]
fn within(first: u16, count: u16, start: u16, length: u16) -> bool {
    let offset = first.wrapping_sub(start);
    offset < length && count <= length - offset
}

impl Device for Map<'_, '_> {
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool {
        let within = |(start, length)| within(first, count, start, length);
        let long =
            || within(const { range(input::TIMERS) }) || within(const { range(input::COUNTERS) });
        match table {
            Table::Coils => {
                within(const { range(coil::OUTPUTS) }) || within(const { range(coil::MARKERS) })
            }
            Table::DiscreteInputs => within(const { range(discrete::INPUTS) }),
            Table::InputRegisters => {
                within(const { range(input::ANALOGUE) })
                    || within(const { range(number::DIAGNOSTICS) })
                    || long()
            }
            Table::HoldingRegisters => {
                within(const { range(holding::REGISTERS) })
                    || within(const { range(holding::COMMAND) })
                    || within(const { range(FORCED) })
                    || within(const { range(holding::SETTINGS) })
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
            let points = if address < holding::FORCED_OUTPUTS.first {
                discrete::INPUTS.values
            } else {
                coil::OUTPUTS.values
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
        }
    }

    fn words_are_set(&mut self) {
        self.settings.save(&self.board.eeprom);
    }

    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        if first != holding::UPLOAD.first {
            return None;
        }
        Some(match &mut self.upload {
            Some(upload) => upload.take(data, self.operation),
            // That end again: its answer was lost.
            None if matches!(*data, [number, 0] if self.ended == Some(number)) => Ok(()),
            None => Err(Exception::ServerDeviceFailure),
        })
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        let text = match object {
            0 => flash_codes!(Codes::plain(VENDOR)),
            1 => flash_codes!(Codes::plain(PRODUCT)),
            _ => flash_codes!(Codes::plain(env!("CARGO_PKG_VERSION"))),
        };
        text.at(index)
    }
}

/// The bit of the point at this address, 0 to 7.
fn bit(address: u16) -> u8 {
    1 << (address & 7)
}
