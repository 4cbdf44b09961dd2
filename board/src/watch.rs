//! One reading of all that a screen shows, and what may be asked of the board meanwhile.

use crate::client::{Client, Failure, Table};
use crate::diagnostics::Diagnostics;
use crate::map::{self, Command, holding, input, number};
use unoclp_core::Profile;
use unoclp_modbus::Exception;

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
        let inputs = match if_there(inputs(Profile::UNO.inputs.into()))? {
            Some(inputs) => inputs,
            None => inputs(4)?,
        };
        let outputs = client.bits(
            Table::Coils,
            map::coil::OUTPUTS,
            Profile::UNO.outputs.into(),
        )?;
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
}
