//! One reading of all that a screen shows, and what may be asked of the board meanwhile.

use super::client::{Client, Failure, Table};
use super::map::{self, Command, State, flag, holding, input, number};
use crate::BOARD;
use std::fmt;
use unoclp_core::{Cause, Crc16, Fault, Loader};
use unoclp_modbus::Exception;

/// What the board says of itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Diagnostics {
    /// What it does; none where it is not among the states of this version.
    pub state: Option<State>,
    /// Bits of [`flag`].
    pub flags: u16,
    /// The fault, or that of the last upload.
    pub trouble: Option<Trouble>,
    /// The cause of the start; [`map::cause`] puts it into words.
    pub cause: u16,
    /// ms since the start, wrapping.
    pub uptime: u32,
    /// Scan times in µs: last, least, most; 32767 for more.
    pub scan_times: [u16; 3],
    /// Bytes that the stack has never used.
    pub free_stack: u16,
    /// What it keeps.
    pub program: Kept,
    /// The supply in mV; 0 where it has not been measured.
    pub supply: u32,
    /// Restarts and faults since power-up.
    pub restarts: u16,
    /// Faults since power-up.
    pub faults: u16,
}

/// A fault as the board tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trouble {
    /// Its number.
    pub number: u16,
    /// Its line; none where there is none.
    pub line: Option<u32>,
}

impl Trouble {
    /// The fault, where this version knows its number.
    pub fn fault(self) -> Option<Fault> {
        let cause = Cause::ALL
            .iter()
            .find(|cause| u16::from(cause.number()) == self.number)?;
        Some(Fault {
            cause: *cause,
            line: self.line,
        })
    }
}

impl fmt::Display for Trouble {
    /// `fault 24, line 7: no such code`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(fault) = self.fault() {
            return fault.fmt(f);
        }
        write!(f, "fault {}", self.number)?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        f.write_str(": unknown to this version of unoclp")
    }
}

/// Which program a board keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kept {
    /// Bytes of its stored form.
    pub bytes: u16,
    /// Its check sum in the EEPROM.
    pub crc: u16,
}

impl Kept {
    /// How a board keeps this file; none where the file has a fault.
    pub fn of(file: &[u8]) -> Option<Kept> {
        let mut memory = vec![0; usize::from(BOARD.linked_bytes)];
        let mut loader = Loader::new(&mut memory, BOARD);
        file.iter().try_for_each(|&byte| loader.push(byte)).ok()?;
        let program = loader.finish().ok()?;
        let bytes = u16::try_from(program.stored_bytes()).ok()?;
        let [low, high] = bytes.to_le_bytes();
        let mut crc = Crc16::default();
        crc.extend(&[1, low, high, 0, 0]);
        crc.extend(program.stored());
        let crc = crc.value();
        Some(Kept { bytes, crc })
    }
}

impl Diagnostics {
    /// Reads them.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(client: &mut Client) -> Result<Diagnostics, Failure> {
        let count = input::FAULTS - input::STATE + 1;
        let words = client.words(Table::InputRegisters, input::STATE, count)?;
        let word = |address: u16| {
            let word = words.get(usize::from(address - input::STATE));
            word.copied().unwrap_or_default()
        };
        let long = |address| number(word(address), word(address + 1));
        Ok(Diagnostics {
            state: State::of(word(input::STATE)),
            flags: word(input::FLAGS),
            trouble: match word(input::FAULT) {
                0 => None,
                number => Some(Trouble {
                    number,
                    line: Some(long(input::LINE)).filter(|&line| line != 0),
                }),
            },
            cause: word(input::CAUSE),
            uptime: long(input::UPTIME),
            scan_times: [0, 1, 2].map(|n| word(input::SCAN_TIME + n)),
            free_stack: word(input::FREE_STACK),
            program: Kept {
                bytes: word(input::PROGRAM_BYTES),
                crc: word(input::PROGRAM_CRC),
            },
            supply: 1_126_400_u32
                .checked_div(word(input::SUPPLY).into())
                .unwrap_or_default(),
            restarts: word(input::RESTARTS),
            faults: word(input::FAULTS),
        })
    }

    /// Whether a flag is set.
    pub const fn has(&self, flag: u16) -> bool {
        self.flags & flag != 0
    }

    /// Whether A5 holds the board in STOP.
    pub const fn is_switched_off(&self) -> bool {
        self.has(flag::STOP_SWITCH)
    }
}

/// Points that are forced, and to what; bit 0 is point 01.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Forces {
    /// Which.
    pub points: u16,
    /// To what.
    pub to: u16,
}

impl Forces {
    /// What the point with this index is forced to.
    pub const fn get(self, index: u8) -> Option<bool> {
        let bit = 1 << (index & 0x0F);
        if self.points & bit == 0 {
            None
        } else {
            Some(self.to & bit != 0)
        }
    }

    /// Forces the point with this index, or lets it go.
    pub const fn set(&mut self, index: u8, to: Option<bool>) {
        let bit = 1 << (index & 0x0F);
        self.points &= !bit;
        self.to &= !bit;
        if let Some(on) = to {
            self.points |= bit;
            if on {
                self.to |= bit;
            }
        }
    }
}

/// What can be forced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Inputs.
    Inputs,
    /// Outputs.
    Outputs,
}

impl Side {
    const fn register(self) -> u16 {
        match self {
            Side::Inputs => holding::FORCED_INPUTS,
            Side::Outputs => holding::FORCED_OUTPUTS,
        }
    }
}

/// A timer or a counter: its elapsed time in ms or its value, and its preset.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Meter {
    /// Elapsed time or value.
    pub value: i32,
    /// The preset.
    pub preset: i32,
}

/// How much there is to read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scope {
    /// Timers, from T 01 on.
    pub timers: u16,
    /// Counters, from C 01 on.
    pub counters: u16,
}

/// All that the screen shows. What this board does not have is `None` or empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// What the board says of itself.
    pub diagnostics: Diagnostics,
    /// The inputs as the program sees them, bit 0 input 01.
    pub inputs: u16,
    /// The image of the outputs, bit 0 output 01.
    pub outputs: u16,
    /// What is forced of the inputs.
    pub forced_inputs: Forces,
    /// What is forced of the outputs.
    pub forced_outputs: Forces,
    /// The markers, bit 0 M 01.
    pub markers: Option<u64>,
    /// A 00 to A 04.
    pub analogue: Vec<u16>,
    /// D 01 and those behind it.
    pub registers: Vec<i32>,
    /// T 01 and those behind it.
    pub timers: Vec<Meter>,
    /// C 01 and those behind it.
    pub counters: Vec<Meter>,
}

impl Reading {
    /// Reads all of it, one request after the other.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(client: &mut Client, scope: Scope) -> Result<Reading, Failure> {
        let mut inputs = |count| client.bits(Table::DiscreteInputs, map::discrete::INPUTS, count);
        // Firmware of version 1 has four.
        let inputs = match if_there(inputs(BOARD.inputs.into()))? {
            Some(inputs) => inputs,
            None => inputs(4)?,
        };
        let outputs = client.bits(Table::Coils, map::coil::OUTPUTS, BOARD.outputs.into())?;
        let markers = if_there(client.bits(Table::Coils, map::coil::MARKERS, 64))?;
        let diagnostics = Diagnostics::read(client)?;
        let analogue = client.words(Table::InputRegisters, input::ANALOGUE, 5);
        Ok(Reading {
            diagnostics,
            inputs: pack(&inputs) as u16,
            outputs: pack(&outputs) as u16,
            forced_inputs: forces(client, Side::Inputs)?,
            forced_outputs: forces(client, Side::Outputs)?,
            markers: markers.map(|markers| pack(&markers)),
            analogue: if_there(analogue)?.unwrap_or_default(),
            registers: numbers(client, Table::HoldingRegisters, holding::REGISTERS, 32)?,
            timers: meters(client, input::TIMERS, holding::TIMERS, scope.timers)?,
            counters: meters(client, input::COUNTERS, holding::COUNTERS, scope.counters)?,
        })
    }
}

/// What may be asked of a board that is watched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// One of the commands.
    Command(Command),
    /// Force the point with this index, or let it go.
    Force(Side, u8, Option<bool>),
    /// Let all points go.
    Release,
}

impl Wish {
    /// Does it.
    ///
    /// # Errors
    /// [`Failure`]; what is refused with 04 can be done in another state only.
    pub fn fulfil(self, client: &mut Client) -> Result<(), Failure> {
        match self {
            Wish::Command(command) => client.set_word(holding::COMMAND, command as u16),
            Wish::Force(side, index, to) => {
                // Another client may force other points.
                let mut forces = forces(client, side)?;
                forces.set(index, to);
                client.set_words(side.register(), &[forces.points, forces.to])
            }
            Wish::Release => {
                client.set_words(holding::FORCED_INPUTS, &[0, 0])?;
                client.set_words(holding::FORCED_OUTPUTS, &[0, 0])
            }
        }
    }
}

fn forces(client: &mut Client, side: Side) -> Result<Forces, Failure> {
    match *client.words(Table::HoldingRegisters, side.register(), 2)? {
        [points, to] => Ok(Forces { points, to }),
        _ => Err(Failure::Garbled),
    }
}

/// Values of 32 bits; none where the board has none there.
fn numbers(client: &mut Client, table: Table, first: u16, count: u16) -> Result<Vec<i32>, Failure> {
    // As many as one request may ask for.
    const MOST: u16 = 62;
    let mut numbers = Vec::new();
    for index in (0..count).step_by(MOST.into()) {
        let pairs = (count - index).min(MOST);
        let words = client.words(table, first + 2 * index, 2 * pairs);
        let words = if_there(words)?.unwrap_or_default();
        let pairs = words.as_chunks().0.iter();
        numbers.extend(pairs.map(|&[high, low]| number(high, low).cast_signed()));
    }
    Ok(numbers)
}

fn meters(
    client: &mut Client,
    values: u16,
    presets: u16,
    count: u16,
) -> Result<Vec<Meter>, Failure> {
    let values = numbers(client, Table::InputRegisters, values, count)?;
    let presets = numbers(client, Table::HoldingRegisters, presets, count)?;
    let meters = values.into_iter().zip(presets);
    Ok(meters
        .map(|(value, preset)| Meter { value, preset })
        .collect())
}

/// A board without these addresses is a board without what stands there.
fn if_there<T>(read: Result<T, Failure>) -> Result<Option<T>, Failure> {
    match read {
        Ok(read) => Ok(Some(read)),
        Err(Failure::Refused(Exception::IllegalDataAddress)) => Ok(None),
        Err(other) => Err(other),
    }
}

/// Bit 0 is the first.
fn pack(bits: &[bool]) -> u64 {
    let bits = bits.iter().rev();
    bits.fold(0, |packed, &bit| packed << 1 | u64::from(bit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_forced_and_let_go() {
        let mut forces = Forces::default();
        forces.set(2, Some(true));
        forces.set(0, Some(false));
        assert_eq!((forces.points, forces.to), (0b101, 0b100));
        assert_eq!(
            [0, 1, 2].map(|index| forces.get(index)),
            [Some(false), None, Some(true)]
        );
        forces.set(2, Some(false));
        assert_eq!((forces.points, forces.to), (0b101, 0));
        forces.set(2, None);
        assert_eq!((forces.points, forces.to), (0b001, 0));
    }

    #[test]
    fn a_board_keeps_what_its_page_says() {
        // The stored form of a contact and a coil, behind program start and a new rung.
        let kept = Kept::of(b"0\n787600\n827301\n877901\n").unwrap();
        let crc = Crc16::of(&[1, 3, 0, 0, 0, 0x01, 0x10, 0x50]).value();
        assert_eq!(kept, Kept { bytes: 3, crc });
        assert_eq!(Kept::of(b"0\n1\n"), None);
        assert_eq!(Kept::of(b""), None);
    }

    #[test]
    fn trouble_reads_as_everywhere() {
        let trouble = |number, line| Trouble { number, line }.to_string();
        assert_eq!(trouble(24, Some(7)), "fault 24, line 7: no such code");
        assert_eq!(
            trouble(99, Some(7)),
            "fault 99, line 7: unknown to this version of unoclp"
        );
        assert_eq!(
            trouble(99, None),
            "fault 99: unknown to this version of unoclp"
        );
    }
}
