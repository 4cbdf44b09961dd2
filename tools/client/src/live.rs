//! A reading that is kept up many times a second: each round reads what moves from scan to scan and is used, and every
//! third one part of what hardly changes, in turn. So a round takes a handful of requests, whatever there is to know.

use crate::client::{Client, Failure};
use crate::diagnostics::Diagnostics;
use crate::map::{Span, holding, input};
use crate::watch::{
    Forced, Meter, Reading, Scope, analogue, inputs, longs, markers, outputs, registers,
};
use std::time::Duration;

/// What a program uses of what is read of a board: the rest need not be read often.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    /// Markers.
    pub markers: bool,
    /// Analogue inputs.
    pub analogue: bool,
    /// Registers.
    pub registers: bool,
}

impl Parts {
    /// All of it.
    pub const ALL: Parts = Parts {
        markers: true,
        analogue: true,
        registers: true,
    };
}

/// What is read in turn. What a person may just have changed comes first.
#[derive(Clone, Copy)]
enum Slow {
    Forced,
    TimerPresets,
    CounterPresets,
    /// Scan times, supply, what is kept, and the like.
    Diagnostics,
    Markers,
    Analogue,
    Registers,
}

const SLOW: [Slow; 7] = [
    Slow::Forced,
    Slow::TimerPresets,
    Slow::CounterPresets,
    Slow::Diagnostics,
    Slow::Markers,
    Slow::Analogue,
    Slow::Registers,
];

/// Time between the beginnings of two rounds on average: 27 a second, where the line is fast enough.
const PERIOD: Duration = Duration::from_millis(36);
/// Rounds without a part of what hardly changes, after one with it.
const REST: u8 = 2;
/// Time between two rounds at least: the line is for orders too.
const PAUSE: Duration = Duration::from_millis(2);

/// A reading that is kept up.
#[derive(Debug, Default)]
pub struct Live {
    reading: Reading,
    /// What it was read for; none: it is to be read as a whole.
    of: Option<(Scope, Parts)>,
    /// Whose turn it is among [`SLOW`].
    turn: usize,
    /// Rounds until it comes.
    rest: u8,
    /// When the next round begins. One that takes longer, or begins later, is made up for by the next.
    due: Duration,
}

impl Live {
    /// One round; gives what is known then. The first one, and the first after a restart of the board or for another
    /// program, reads everything.
    ///
    /// # Errors
    /// [`Failure`]; the reading is then of two moments.
    pub async fn round(
        &mut self,
        client: &mut Client,
        scope: Scope,
        parts: Parts,
    ) -> Result<&Reading, Failure> {
        let now = client.now();
        self.due = (self.due + PERIOD).clamp(now, now + PERIOD);
        if self.of == Some((scope, parts)) {
            let before = self.reading.diagnostics.uptime;
            self.renew(client, scope, parts).await?;
            if self.reading.diagnostics.uptime >= before {
                match self.rest.checked_sub(1) {
                    Some(rest) => self.rest = rest,
                    None => {
                        self.rest = REST;
                        self.renew_in_turn(client, scope, parts).await?;
                    }
                }
                return Ok(&self.reading);
            }
        }
        self.reading = Reading::read(client, scope).await?;
        self.of = Some((scope, parts));
        self.points_have_changed();
        Ok(&self.reading)
    }

    /// Leaves the line to others until the next round is due, or something is so: then true.
    ///
    /// # Errors
    /// [`Failure::Lost`].
    pub async fn pause(
        &self,
        client: &mut Client,
        is_so: impl Fn() -> bool,
    ) -> Result<bool, Failure> {
        let due = self.due.saturating_sub(client.now());
        client.pause(due.max(PAUSE), is_so).await
    }

    /// Points were forced or set: the next round reads what is forced, and soon after it the presets are.
    pub const fn points_have_changed(&mut self) {
        (self.turn, self.rest) = (0, 0);
    }

    /// Anything may have changed: the next round reads all of it.
    pub const fn all_has_changed(&mut self) {
        self.of = None;
    }

    /// Reads what moves and is used: effects before their causes, outputs first and inputs last. So whoever sees an
    /// effect sees its cause in the same reading.
    async fn renew(
        &mut self,
        client: &mut Client,
        scope: Scope,
        parts: Parts,
    ) -> Result<(), Failure> {
        let reading = &mut self.reading;
        reading.outputs = outputs(client).await?;
        if parts.markers {
            reading.markers = markers(client).await?;
        }
        if parts.registers {
            let values = registers(client, scope.registers).await?;
            put(&mut reading.registers, &values, |register| register);
        }
        for (span, count, meters) in [
            (input::TIMERS, scope.timers, &mut reading.timers),
            (input::COUNTERS, scope.counters, &mut reading.counters),
        ] {
            let values = longs(client, span, count).await?;
            put(meters, &values, |meter| &mut meter.value);
        }
        if parts.analogue {
            reading.analogue = analogue(client).await?;
        }
        // STOP and faults are causes too.
        reading.diagnostics.renew(client).await?;
        reading.inputs = inputs(client).await?;
        Ok(())
    }

    /// Reads the part whose turn it is.
    async fn renew_in_turn(
        &mut self,
        client: &mut Client,
        scope: Scope,
        parts: Parts,
    ) -> Result<(), Failure> {
        let turns = (self.turn..SLOW.len()).chain(0..self.turn);
        let mut there = turns.filter(|&turn| self.is_there(SLOW[turn], parts));
        let Some(turn) = there.next() else {
            return Ok(());
        };
        self.turn = (turn + 1) % SLOW.len();
        let reading = &mut self.reading;
        match SLOW[turn] {
            Slow::Forced => reading.take_forced(Forced::read(client).await?),
            Slow::TimerPresets => {
                presets(client, holding::TIMERS, scope.timers, &mut reading.timers).await?;
            }
            Slow::CounterPresets => {
                let counters = &mut reading.counters;
                presets(client, holding::COUNTERS, scope.counters, counters).await?;
            }
            Slow::Diagnostics => reading.diagnostics = Diagnostics::read(client).await?,
            Slow::Markers => reading.markers = markers(client).await?,
            Slow::Analogue => reading.analogue = analogue(client).await?,
            Slow::Registers => {
                let count = reading.registers.len() as u16;
                reading.registers = registers(client, count).await?;
            }
        }
        Ok(())
    }

    /// Whether the board has this part, and it is not read in each round.
    fn is_there(&self, slow: Slow, parts: Parts) -> bool {
        let reading = &self.reading;
        match slow {
            Slow::Forced | Slow::Diagnostics => true,
            Slow::TimerPresets => !reading.timers.is_empty(),
            Slow::CounterPresets => !reading.counters.is_empty(),
            Slow::Markers => !parts.markers && reading.markers.is_some(),
            Slow::Analogue => !parts.analogue && !reading.analogue.is_empty(),
            Slow::Registers => !parts.registers && !reading.registers.is_empty(),
        }
    }
}

async fn presets(
    client: &mut Client,
    span: Span,
    count: u16,
    meters: &mut [Meter],
) -> Result<(), Failure> {
    let values = longs(client, span, count).await?;
    put(meters, &values, |meter| &mut meter.preset);
    Ok(())
}

/// Puts each value into its place.
fn put<T>(places: &mut [T], values: &[i32], place: impl Fn(&mut T) -> &mut i32) {
    for (one, value) in places.iter_mut().zip(values) {
        *place(one) = *value;
    }
}
