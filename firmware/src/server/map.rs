//! What each address stands for: the tables of `docs/modbus.md`.

#[cfg(mega)]
use super::lines::Port;
use super::upload::Upload;
use crate::board::allowance::{LAST_PROGRAM, PROGRAMS_USED};
use crate::board::flash::{self, Codes, flash_codes};
use crate::board::{Board, stack, watchdog};
use crate::engine::data::ON;
use crate::engine::memory::{Memory, SLICE, Values};
use crate::operation::{Command, Operation, State};
use crate::settings::Settings;
use crate::store;
use unoclp_core::isa::{COUNTER_DATA, TIMER_DATA};
use unoclp_core::{Image, Millis};
use unoclp_modbus::eeprom::program;
use unoclp_modbus::map::{
    AREA, AREAS, MEGA, NANO, PRODUCT, Span, VENDOR, coil, flag, form, holding, input,
};
use unoclp_modbus::{Access, Addresses, Device, Exception, Table, Word};

/// What the board says that it is.
const NAME: &str = if cfg!(mega) {
    MEGA
} else if cfg!(nano) {
    NANO
} else {
    PRODUCT
};

const MARKER: u8 = coil::MARKERS.first as u8;
const MARKERS: usize = coil::MARKERS.values as usize;
const TIMER: u16 = input::TIMERS.first;
const COUNTER: u16 = input::COUNTERS.first;
const COMMAND: u16 = holding::COMMAND.first;
/// A Nano has no room for what reads it.
#[cfg(not(nano))]
const PROGRAM: Span = input::PROGRAM;
/// Words of the program that are read at once.
#[cfg(not(nano))]
const PROGRAM_SLICE: usize = 8;
const REGISTER: u16 = holding::REGISTERS.first;

// The presets go on where the registers end, and a slice begins.
const _: () =
    assert!(TIMER == holding::FIRST_REGISTERS.end() && TIMER.is_multiple_of(SLICE as u16));
// Input and holding registers have these at the same addresses.
const _: () = assert!(TIMER == holding::TIMERS.first && COUNTER == holding::COUNTERS.first);
const _: () = assert!(TIMER_DATA == COUNTER_DATA);

/// Words that are no half of a value of 32 bits, by the low bytes of their addresses: comparing bytes takes half as
/// much.
mod number {
    use super::*;

    const fn of(span: Span) -> u8 {
        // No two of them have the same.
        assert!(span.first < 0x80 || span.first & 0x80 != 0 && span.first >> 8 == COMMAND >> 8);
        span.first as u8
    }

    pub const STATE: u8 = of(input::STATE);
    pub const FLAGS: u8 = of(input::FLAGS);
    pub const FAULT: u8 = of(input::FAULT);
    pub const CAUSE: u8 = of(input::CAUSE);
    pub const LINE: u8 = of(input::LINE);
    pub const UPTIME: u8 = of(input::UPTIME);
    pub const LAST: u8 = of(input::SCAN_TIMES);
    pub const LEAST: u8 = LAST + 1;
    pub const MOST: u8 = LAST + 2;
    pub const FREE_STACK: u8 = of(input::FREE_STACK);
    pub const PROGRAM: u8 = of(input::PROGRAM_BYTES);
    pub const SUPPLY: u8 = of(input::SUPPLY);
    pub const RESTARTS: u8 = of(input::RESTARTS);
    pub const FAULTS: u8 = of(input::FAULTS);
    pub const FORCES: u8 = of(holding::FORCED_INPUTS);
    pub const FORCED_OUTPUTS: u8 = of(holding::FORCED_OUTPUTS);
    pub const OUTPUTS_TO: u8 = of(holding::OUTPUTS_TO);
    pub const SETTINGS: u8 = of(holding::SETTINGS);
}

/// The board as the server shows it, for one step.
pub struct Map<'a, 'm, 'u> {
    pub board: &'a Board,
    pub operation: &'a mut Operation,
    pub settings: &'a mut Settings,
    /// The time of this step, ms since start.
    pub now: Millis,
    pub memory: &'a mut Memory<'m>,
    pub upload: Option<&'a mut Upload<'u>>,
    /// The number of the block that ended the last upload, where its program was stored.
    pub ended: Option<u8>,
    /// Which line has forced, and which of them asks.
    #[cfg(mega)]
    pub forced: (&'a mut Port, Port),
}

impl Map<'_, '_, '_> {
    /// A word of the diagnostics.
    #[inline(never)]
    fn diagnostic(&self, number: u8) -> u16 {
        let Map {
            board, operation, ..
        } = self;
        let line = operation.fault.and_then(|fault| fault.line).unwrap_or(0);
        let pair = match number {
            number::STATE => return operation.state as u16,
            number::FLAGS => return u16::from(self.bits()) | form::bits(program::FORM),
            number::FAULT => {
                return operation
                    .fault
                    .map_or(0, |fault| fault.cause.number().into());
            }
            number::CAUSE => return watchdog::started() as u16 + 1,
            number::LINE..number::UPTIME => line,
            number::UPTIME..number::LAST => self.now,
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

    /// A word that is no half of a value of 32 bits, by its number.
    #[inline(never)]
    fn word(&self, number: u8) -> u16 {
        let operation = &self.operation;
        if number < number::STATE {
            let reading = self.memory.data.analogue.get(usize::from(number));
            reading.copied().unwrap_or_default()
        } else if number <= number::FAULTS {
            self.diagnostic(number)
        } else if number < number::FORCES {
            operation.state as u16
        } else if number < number::SETTINGS {
            #[cfg(mega)]
            return operation.forces.word(number - number::FORCES);
            #[cfg(not(mega))]
            {
                let forces = operation.forces.0.get(usize::from(number - number::FORCES));
                forces.copied().unwrap_or(0).into()
            }
        } else {
            self.settings.get(number - number::SETTINGS)
        }
    }

    /// Whether it may be written.
    #[inline(never)]
    fn check_word(&self, number: u8, value: u16) -> Result<(), Exception> {
        let sound = if number < number::FORCES {
            return match self.command(value)? {
                Command::Upload if PROGRAMS_USED.get() > LAST_PROGRAM => {
                    Err(Exception::ServerDeviceBusy)
                }
                _ => Ok(()),
            };
        } else if (number::FORCED_OUTPUTS..=number::OUTPUTS_TO).contains(&number) {
            cfg!(mega) || value < 1 << (coil::OUTPUTS.values & 15)
        } else if cfg!(mega) && number < number::FORCES + 2 {
            true
        } else if number < number::SETTINGS {
            value < 1 << u8::BITS
        } else if self.operation.state == State::Run {
            return Err(Exception::ServerDeviceFailure);
        } else {
            return self.settings.check(number - number::SETTINGS, value);
        };
        if sound {
            Ok(())
        } else {
            Err(Exception::IllegalDataValue)
        }
    }

    /// Writes it.
    #[inline(never)]
    fn set_word(&mut self, number: u8, value: u16) {
        if number < number::FORCES {
            if let Ok(command) = self.command(value) {
                self.operation.stopped = match command {
                    Command::Run => false,
                    Command::Stop | Command::SingleScan => true,
                    _ => self.operation.stopped,
                };
                self.operation.command = Some(command);
            }
        } else if number < number::SETTINGS {
            #[cfg(mega)]
            {
                let (forced, by) = &mut self.forced;
                **forced = *by;
                let forces = &mut self.operation.forces;
                forces.set_word(number - number::FORCES, value);
            }
            #[cfg(not(mega))]
            let forces = &mut self.operation.forces.0;
            #[cfg(not(mega))]
            if let Some(place) = forces.get_mut(usize::from(number - number::FORCES)) {
                *place = value as u8;
            }
        } else {
            self.settings.set(number - number::SETTINGS, value);
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
            Command::SingleScan => !held,
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

/// The addresses of the board, in program memory.
#[unsafe(link_section = ".progmem.data")]
static AREAS_IN_FLASH: flash::Table<u8, { AREAS.len() }> = flash::Table::new(AREAS);

impl Device for Map<'_, '_, '_> {
    #[inline(never)]
    fn has(&self, addresses: &Addresses) -> bool {
        let Addresses {
            table,
            access,
            first,
            count,
        } = *addresses;
        #[cfg(not(nano))]
        if table == Table::InputRegisters && first >= PROGRAM.first {
            let offset = first - PROGRAM.first;
            return offset < PROGRAM.values && count <= PROGRAM.values - offset;
        }
        let mut at = 0;
        while at < AREAS.len() {
            let mut area = [0; AREA];
            // SAFETY: the static stands in that section.
            unsafe { AREAS_IN_FLASH.read(at, &mut area) };
            let [its_table, low, high, addresses] = area;
            let offset = first.wrapping_sub(u16::from_le_bytes([low, high]));
            let addresses = u16::from(addresses);
            if its_table == table as u8 && offset < addresses && count <= addresses - offset {
                let last = first.wrapping_add(count - 1);
                let presets = table == Table::HoldingRegisters && (TIMER..COMMAND).contains(&last);
                return access == Access::Read || !presets || self.has_presets(last);
            }
            at += AREA;
        }
        false
    }

    /// Outputs and markers join: first the points, then the markers.
    #[cfg(mega)]
    #[inline(never)]
    fn bits(&mut self, addresses: &Addresses, count: u8, bits: u8) -> u8 {
        let Addresses {
            table,
            access,
            first,
            ..
        } = *addresses;
        let write = access == Access::Write;
        // All that there is stands at addresses of one byte.
        let first = first as u8;
        let points = match table {
            Table::Coils => count.min(MARKER.saturating_sub(first)),
            _ => count,
        };
        let mut read = 0;
        if points > 0 {
            let operation = &mut *self.operation;
            let image = match table {
                Table::Coils => operation.outputs(),
                _ => operation.images.inputs(),
            };
            read = (image.0 >> first) as u8;
            if write {
                let mask = u32::from(u8::MAX >> (8 - points)) << first;
                let bits = u32::from(bits) << first;
                let Image(outputs) = operation.images.outputs();
                let outputs = outputs & !mask | bits & mask;
                operation.images.set_outputs(Image(outputs));
            }
        }
        let mut mask = 1u8.wrapping_shl(points.into());
        for index in points..count {
            let at = first + index - MARKER;
            let cell = &mut self.memory.data.markers[usize::from(at) % MARKERS];
            if write {
                *cell = if bits & mask != 0 { ON } else { 0 };
            } else if *cell & ON != 0 {
                read |= mask;
            }
            mask <<= 1;
        }
        read
    }

    #[cfg(not(mega))]
    #[inline(never)]
    fn bits(&mut self, addresses: &Addresses, count: u8, bits: u8) -> u8 {
        let Addresses {
            table,
            access,
            first,
            ..
        } = *addresses;
        let write = access == Access::Write;
        // All that there is stands at addresses of one byte.
        let first = first as u8;
        if table == Table::Coils && first >= MARKER {
            let (mut at, mut mask, mut read) = (first - MARKER, 1, 0);
            for _ in 0..count {
                let cell = &mut self.memory.data.markers[usize::from(at) % MARKERS];
                if write {
                    *cell = if bits & mask != 0 { ON } else { 0 };
                } else if *cell & ON != 0 {
                    read |= mask;
                }
                mask <<= 1;
                at += 1;
            }
            return read;
        }
        let operation = &mut *self.operation;
        if write {
            let (mut bits, mut mask) = (bits, u8::MAX >> (8 - count));
            for _ in 0..first & 7 {
                bits <<= 1;
                mask <<= 1;
            }
            let Image(outputs) = operation.images.outputs();
            let outputs = outputs as u8 & !mask | bits & mask;
            operation.images.set_outputs(Image(outputs.into()));
            return 0;
        }
        let image = if table == Table::Coils {
            operation.outputs()
        } else {
            operation.images.inputs()
        };
        (image.0 as u8) >> (first & 7)
    }

    #[inline(never)]
    fn words(&mut self, addresses: &Addresses, words: &mut [Word]) -> u8 {
        let Addresses {
            table,
            access,
            first,
            ..
        } = *addresses;
        let write = access == Access::Write;
        let input = table == Table::InputRegisters;
        #[cfg(not(nano))]
        if input && first >= PROGRAM.first {
            let eeprom = &self.board.eeprom;
            let mut at = program::STORED + ((first - PROGRAM.first) << 1);
            let mut count = 0;
            for word in words.iter_mut().take(PROGRAM_SLICE) {
                *word = [eeprom.read(at), eeprom.read(at + 1)];
                at += 2;
                count += 1;
            }
            return count;
        }
        if first < COMMAND && (!input || first >= TIMER) || first >= REGISTER {
            // None has more than 256 words.
            let (values, start) = if first >= REGISTER {
                (Values::Registers, REGISTER as u8)
            } else if first >= COUNTER {
                (Values::Counters, COUNTER as u8)
            } else if first >= TIMER {
                (Values::Timers, TIMER as u8)
            } else {
                (Values::Registers, 0)
            };
            let from = (first as u8).wrapping_sub(start);
            let memory = &mut self.memory;
            return memory.words(values, !input, from, words, write, self.now);
        }
        // Others take longer.
        let mut address = first;
        for word in words {
            if write {
                self.set_word(address as u8, u16::from_be_bytes(*word));
            } else {
                *word = self.word(address as u8).to_be_bytes();
            }
            address += 1;
            if address & 7 == 0 {
                break;
            }
        }
        (address - first) as u8
    }

    #[inline(never)]
    fn check_words(&self, first: u16, words: &[Word]) -> Result<(), Exception> {
        if first >= REGISTER {
            return Ok(());
        }
        if first < COMMAND {
            // A preset is not negative: its high word tells. What stands before the presets may be.
            let before = if first < TIMER {
                TIMER - first
            } else {
                first & 1
            };
            let mut at = usize::from(before);
            while let Some(&[high, _]) = words.get(at) {
                if high >= 0x80 {
                    return Err(Exception::IllegalDataValue);
                }
                at += 2;
            }
            return Ok(());
        }
        let mut number = first as u8;
        words.iter().try_for_each(|&word| {
            number = number.wrapping_add(1);
            self.check_word(number.wrapping_sub(1), u16::from_be_bytes(word))
        })
    }

    fn is_written(&mut self) {
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
            1 => flash_codes!(Codes::plain(NAME)),
            _ => flash_codes!(Codes::plain(env!("CARGO_PKG_VERSION"))),
        };
        text.at(index)
    }
}
