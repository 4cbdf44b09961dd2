//! One reading of all that a screen shows; commands and forces.

use crate::client::{Client, Failure, if_there};
use crate::diagnostics::Diagnostics;
use crate::map::{self, Command, Span, coil, discrete, holding, input, long};
use std::fmt;
use unoclp_core::{Image, Inputs, Millis, Snapshot};

/// Points that are forced, and to what; bit 0 is point 01.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Forces {
    /// Which.
    pub points: u32,
    /// To what.
    pub to: u32,
}

impl Forces {
    /// What the point with this index is forced to.
    pub const fn get(self, index: u8) -> Option<bool> {
        let bit = 1 << (index & 0x1F);
        if self.points & bit == 0 {
            None
        } else {
            Some(self.to & bit != 0)
        }
    }

    /// Forces the point with this index, or lets it go.
    pub const fn set(&mut self, index: u8, to: Option<bool>) {
        let bit = 1 << (index & 0x1F);
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

/// All that is forced of a board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Forced {
    /// Of the inputs.
    pub inputs: Forces,
    /// Of the outputs.
    pub outputs: Forces,
    /// So many seconds without a request end it; 0, 255: none do. None: the board's firmware has no end of forcing.
    pub ends: Option<u8>,
}

impl Forced {
    /// Reads it.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn read(client: &mut Client) -> Result<Forced, Failure> {
        let first = holding::FORCED_INPUTS;
        let end = match client.has_more_inputs() {
            true => holding::MORE_TO,
            false => holding::FORCING_ENDS,
        };
        let words = client.words(first.table, first.first, end.first + 1 - first.first);
        let words = match if_there(words.await)? {
            Some(words) => words,
            None => {
                let count = holding::FORCING_ENDS.first - first.first;
                client.words(first.table, first.first, count).await?
            }
        };
        let &[inputs, inputs_to, outputs, outputs_to, ref rest @ ..] = &words[..] else {
            return Err(Failure::Garbled);
        };
        let (ends, [more, more_to]) = match rest {
            [ends @ .., more, more_to] => (ends, [*more, *more_to]),
            ends => (ends, [0, 0]),
        };
        let forces = |points, to| Forces { points, to };
        Ok(Forced {
            inputs: forces(long(more, inputs), long(more_to, inputs_to)),
            outputs: forces(outputs.into(), outputs_to.into()),
            ends: ends.first().and_then(|&ends| ends.try_into().ok()),
        })
    }

    /// The seconds without a request that end it, if any do.
    pub fn seconds(self) -> Option<u8> {
        self.ends.filter(|ends| !matches!(ends, 0 | 255))
    }

    /// Whether anything is.
    pub const fn any(self) -> bool {
        self.inputs.points | self.outputs.points != 0
    }
}

impl fmt::Display for Forced {
    /// `I1=1 Q2=0`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = |letter: char, forces: Forces| {
            (0..32).filter_map(move |index| {
                let to = u8::from(forces.get(index)?);
                Some(format!("{letter}{}={to}", index + 1))
            })
        };
        let points: Vec<String> = side('I', self.inputs)
            .chain(side('Q', self.outputs))
            .collect();
        f.write_str(&points.join(" "))
    }
}

/// Points of a word.
const WORD: u8 = 16;

/// What can be forced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Inputs.
    Inputs,
    /// Outputs.
    Outputs,
}

impl Side {
    /// Which points are forced, of the word that has the one with this index; the register after it says to what.
    const fn span(self, index: u8) -> Span {
        match self {
            Side::Inputs if index >= WORD => holding::FORCED_MORE,
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
    /// Registers, from D 01 on; at least those that every board has.
    pub registers: u16,
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
    pub inputs: u32,
    /// The image of the outputs, bit 0 output 01.
    pub outputs: u32,
    /// What is forced of the inputs.
    pub forced_inputs: Forces,
    /// What is forced of the outputs.
    pub forced_outputs: Forces,
    /// When it ends, as [`Forced::ends`].
    pub forcing_ends: Option<u8>,
    /// The markers, bit 0 M 01.
    pub markers: Option<u64>,
    /// A 00 and those after it.
    pub analogue: Vec<u16>,
    /// D 01 and those after it.
    pub registers: Vec<i32>,
    /// T 01 and those after it.
    pub timers: Vec<Meter>,
    /// C 01 and those after it.
    pub counters: Vec<Meter>,
}

impl Reading {
    /// Reads all of it, one request after the other.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn read(client: &mut Client, scope: Scope) -> Result<Reading, Failure> {
        let near = scope.registers.max(map::NEAR_REGISTERS.into());
        // Effects before their causes.
        let mut reading = Reading {
            outputs: outputs(client).await?,
            markers: markers(client).await?,
            diagnostics: Diagnostics::read(client).await?,
            registers: registers(client, near).await?,
            timers: meters(client, input::TIMERS, holding::TIMERS, scope.timers).await?,
            counters: meters(client, input::COUNTERS, holding::COUNTERS, scope.counters).await?,
            analogue: analogue(client).await?,
            inputs: inputs(client).await?,
            ..Reading::default()
        };
        reading.take_forced(Forced::read(client).await?);
        Ok(reading)
    }

    /// Takes over what is forced.
    pub(crate) const fn take_forced(&mut self, forced: Forced) {
        self.forced_inputs = forced.inputs;
        self.forced_outputs = forced.outputs;
        self.forcing_ends = forced.ends;
    }
}

impl Reading {
    /// What a twin of the board's program takes over, the inputs of its next scan, and the board's time in ms.
    pub fn with_snapshot<T>(&self, see: impl FnOnce(&Snapshot<'_>, Inputs, Millis) -> T) -> T {
        let pair = |meter: &Meter| (meter.value.cast_unsigned(), meter.preset.cast_unsigned());
        let timers: Vec<_> = self.timers.iter().map(pair).collect();
        let counters = self.counters.iter();
        let counters: Vec<_> = counters.map(|meter| (meter.value, meter.preset)).collect();
        let board = Snapshot {
            outputs: Image(self.outputs.into()),
            markers: self.markers.unwrap_or_default().into(),
            registers: &self.registers,
            timers: &timers,
            counters: &counters,
        };
        let mut inputs = Inputs::from(Image(self.inputs.into()));
        for (input, value) in inputs.analogue.iter_mut().zip(&self.analogue) {
            *input = *value;
        }
        see(&board, inputs, self.diagnostics.uptime)
    }

    /// All that is forced.
    pub const fn forced(&self) -> Forced {
        Forced {
            inputs: self.forced_inputs,
            outputs: self.forced_outputs,
            ends: self.forcing_ends,
        }
    }
}

/// Has the board do one of the commands.
///
/// # Errors
/// [`Failure`]; what is refused with 04 can be done in another state only.
pub async fn command(client: &mut Client, command: Command) -> Result<(), Failure> {
    client.set_word(holding::COMMAND, command as u16).await
}

/// Forces the point with this index, from 0, or lets it go. What is forced ends at the board after so many seconds without
/// a request, 1 to 254, where its firmware has an end of forcing.
///
/// # Errors
/// [`Failure`].
pub async fn force(
    client: &mut Client,
    side: Side,
    index: u8,
    to: Option<bool>,
    ends: Option<u8>,
) -> Result<(), Failure> {
    if let (Some(_), Some(seconds)) = (to, ends) {
        if_there(client.set_word(holding::FORCING_ENDS, seconds.into()).await)?;
    }
    // Another client may force other points.
    let span = side.span(index);
    let mut forces = forces(client, span).await?;
    forces.set(index % WORD, to);
    let words = [forces.points as u16, forces.to as u16];
    client.set_words(span, &words).await
}

/// Lets all points go.
///
/// # Errors
/// [`Failure`].
pub async fn release(client: &mut Client) -> Result<(), Failure> {
    client.set_words(holding::FORCED_INPUTS, &[0, 0]).await?;
    if client.has_more_inputs() {
        client.set_words(holding::FORCED_MORE, &[0, 0]).await?;
    }
    client.set_words(holding::FORCED_OUTPUTS, &[0, 0]).await
}

async fn forces(client: &mut Client, span: Span) -> Result<Forces, Failure> {
    match *client.words(span.table, span.first, 2).await? {
        [points, to] => Ok(Forces {
            points: points.into(),
            to: to.into(),
        }),
        _ => Err(Failure::Garbled),
    }
}

/// The inputs, bit 0 input 01.
pub(crate) async fn inputs(client: &mut Client) -> Result<u32, Failure> {
    // Firmware of version 1 has four.
    let four = Span {
        values: 4,
        ..discrete::INPUTS
    };
    let inputs = match if_there(client.bits(client.span(discrete::INPUTS)).await)? {
        Some(inputs) => inputs,
        None => client.bits(four).await?,
    };
    Ok(pack(&inputs) as u32)
}

/// The image of the outputs, bit 0 output 01.
pub(crate) async fn outputs(client: &mut Client) -> Result<u32, Failure> {
    Ok(pack(&client.bits(client.span(coil::OUTPUTS)).await?) as u32)
}

/// The markers, bit 0 M 01; none if the board does not have them.
pub(crate) async fn markers(client: &mut Client) -> Result<Option<u64>, Failure> {
    let markers = if_there(client.bits(coil::MARKERS).await)?;
    Ok(markers.map(|markers| pack(&markers)))
}

/// The analogue inputs; none if the board does not have them.
pub(crate) async fn analogue(client: &mut Client) -> Result<Vec<u16>, Failure> {
    let span = client.span(input::ANALOGUE);
    let words = client.words(span.table, span.first, span.values).await;
    Ok(if_there(words)?.unwrap_or_default())
}

/// The first `count` registers.
pub(crate) async fn registers(client: &mut Client, count: u16) -> Result<Vec<i32>, Failure> {
    // Older firmware has only the first.
    let span = match count <= holding::FIRST_REGISTERS.values {
        true => holding::FIRST_REGISTERS,
        false => holding::REGISTERS,
    };
    longs(client, span, count).await
}

/// The first `count` values of 32 bits of a span; none if the board does not have them.
pub(crate) async fn longs(
    client: &mut Client,
    span: Span,
    count: u16,
) -> Result<Vec<i32>, Failure> {
    // As many as one request may ask for.
    const MOST: u16 = 62;
    let mut longs = Vec::new();
    for index in (0..count).step_by(MOST.into()) {
        let pairs = (count - index).min(MOST);
        let words = client.words(span.table, span.first + 2 * index, 2 * pairs);
        let words = if_there(words.await)?.unwrap_or_default();
        let pairs = words.as_chunks().0.iter();
        longs.extend(pairs.map(|&[high, low]| long(high, low).cast_signed()));
    }
    Ok(longs)
}

async fn meters(
    client: &mut Client,
    values: Span,
    presets: Span,
    count: u16,
) -> Result<Vec<Meter>, Failure> {
    let values = longs(client, values, count).await?;
    let presets = longs(client, presets, count).await?;
    let meters = values.into_iter().zip(presets);
    Ok(meters
        .map(|(value, preset)| Meter { value, preset })
        .collect())
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
    fn what_is_forced_is_told_by_its_points() {
        let mut forced = Forced::default();
        assert!(!forced.any());
        forced.inputs.set(2, Some(true));
        forced.outputs.set(0, Some(false));
        assert!(forced.any());
        assert_eq!(forced.to_string(), "I3=1 Q1=0");
        forced.outputs = forced.inputs;
        assert!(forced.any());
    }

    #[test]
    fn forcing_ends_after_seconds_or_never() {
        let ends = [None, Some(0), Some(1), Some(254), Some(255)].map(|ends| Forced {
            ends,
            ..Forced::default()
        });
        let seconds = ends.map(Forced::seconds);
        assert_eq!(seconds, [None, None, Some(1), Some(254), None]);
    }

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
