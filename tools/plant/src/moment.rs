//! What a part sees and changes in a millisecond.

use crate::kind::Fault;
use crate::outputs::Outputs;
use crate::plant::{CONTACT_SEEN, Part, Plant};
use crate::signal::{Given, Signal, Source};
use unoclp_core::Inputs;

/// A contact that bounces does so for this time, ms.
const BOUNCE: i32 = 12;

/// The greatest reading of an analogue input.
pub(crate) const FULL: i32 = 1023;

/// A millisecond of a part.
pub(crate) struct Moment<'a> {
    pub plant: &'a Plant,
    pub part: &'a Part,
    pub values: &'a mut [i32],
    pub outputs: &'a Outputs,
    pub inputs: &'a mut Inputs,
    pub random: &'a mut u64,
}

impl Moment<'_> {
    /// A value of this part.
    pub fn get(&self, value: impl Into<usize>) -> i32 {
        self.row(value, 0)
    }

    /// Whether a flag of it is set.
    pub fn is(&self, value: impl Into<usize>) -> bool {
        self.get(value) != 0
    }

    /// A value of a row of it.
    pub fn row(&self, value: impl Into<usize>, at: usize) -> i32 {
        let cell = self.part.cells.get(value.into()).copied();
        let cell = cell.and_then(|cell| self.values.get(cell + at));
        cell.copied().unwrap_or(0)
    }

    /// Sets a value, within its range.
    pub fn set(&mut self, value: impl Into<usize>, to: i32) {
        self.set_row(value, 0, to);
    }

    /// Adds to a value, within its range.
    pub fn add(&mut self, value: impl Into<usize>, by: i32) {
        let value = value.into();
        self.set(value, self.get(value).saturating_add(by));
    }

    /// Sets a value of a row.
    pub fn set_row(&mut self, value: impl Into<usize>, at: usize, to: i32) {
        store(self.values, self.part, value.into(), at, to);
    }

    /// Sets a flag.
    pub fn put(&mut self, value: impl Into<usize>, truth: bool) {
        self.set(value, truth.into());
    }

    /// Brings a value nearer to another by no more than this.
    pub fn approach(&mut self, value: impl Into<usize>, to: i32, by: i32) {
        let value = value.into();
        let now = self.get(value);
        let next = if to > now {
            now.saturating_add(by).min(to)
        } else {
            now.saturating_sub(by).max(to)
        };
        self.set(value, next);
    }

    /// A number that it was given.
    pub fn number(&self, field: impl Into<usize>) -> i32 {
        self.part.number(field.into())
    }

    fn given(&self, field: impl Into<usize>) -> Given {
        self.part
            .given
            .get(field.into())
            .copied()
            .unwrap_or(Given::Nothing)
    }

    /// Whether a field was given at all.
    pub fn has(&self, field: impl Into<usize>) -> bool {
        self.given(field) != Given::Nothing
    }

    /// Whether what drives it is on.
    pub fn drive(&self, field: impl Into<usize>) -> bool {
        let Given::Signal(signal) = self.given(field) else {
            return false;
        };
        (self.strength(signal) > 0) != signal.not
    }

    /// How far what drives it is on, 0 to 1000.
    pub fn duty(&self, field: impl Into<usize>) -> i32 {
        let Given::Signal(signal) = self.given(field) else {
            return 0;
        };
        let strength = self.strength(signal);
        if signal.not {
            1000 - strength
        } else {
            strength
        }
    }

    fn strength(&self, signal: Signal) -> i32 {
        match signal.source {
            Source::Output(point) => 1000 * i32::from(self.outputs.points.get(point)),
            Source::Pwm(output) => {
                let duty = self.outputs.pwm.get(usize::from(output)).copied();
                (i32::from(duty.unwrap_or(0)) * 1000 + 127) / 255
            }
            Source::Value(part, value) => self.share(part, value),
            Source::Nothing => 0,
        }
    }

    /// How much of its range a value has, 0 to 1000.
    pub fn share(&self, part: usize, value: usize) -> i32 {
        let Some(own) = self.plant.parts.get(part) else {
            return 0;
        };
        let (low, high) = own.range(value);
        let (low, high) = (i64::from(low), i64::from(high));
        let share = (i64::from(self.of(part, value)) - low) * 1000 / (high - low).max(1);
        share as i32
    }

    /// The part that a field names.
    pub fn other(&self, field: impl Into<usize>) -> Option<usize> {
        match self.given(field) {
            Given::Part(part) => Some(part),
            _ => None,
        }
    }

    /// Whether a part is of this kind.
    pub fn is_kind(&self, part: usize, name: &str) -> bool {
        self.plant
            .parts
            .get(part)
            .is_some_and(|own| own.kind.name == name)
    }

    /// A value of another part.
    pub fn of(&self, part: usize, value: impl Into<usize>) -> i32 {
        self.row_of(part, value, 0)
    }

    /// A value of a row of another part.
    pub fn row_of(&self, part: usize, value: impl Into<usize>, at: usize) -> i32 {
        let own = self.plant.parts.get(part);
        let cell = own.and_then(|own| own.cells.get(value.into())).copied();
        let cell = cell.and_then(|cell| self.values.get(cell + at));
        cell.copied().unwrap_or(0)
    }

    /// Sets a value of another part, within its range.
    pub fn set_of(&mut self, part: usize, value: impl Into<usize>, to: i32) {
        self.set_row_of(part, value, 0, to);
    }

    /// Sets a value of a row of another part.
    pub fn set_row_of(&mut self, part: usize, value: impl Into<usize>, at: usize, to: i32) {
        if let Some(own) = self.plant.parts.get(part) {
            store(self.values, own, value.into(), at, to);
        }
    }

    /// Adds to a value of another part.
    pub fn add_of(&mut self, part: usize, value: impl Into<usize>, by: i32) {
        let value = value.into();
        let sum = self.of(part, value).saturating_add(by);
        self.set_of(part, value, sum);
    }

    /// A number that another part was given.
    pub fn number_of(&self, part: usize, field: impl Into<usize>) -> i32 {
        self.plant
            .parts
            .get(part)
            .map_or(0, |own| own.number(field.into()))
    }

    /// Whether it has this fault.
    pub fn fails(&self, fault: Fault) -> bool {
        let faults = self.values.get(self.part.faults).copied().unwrap_or(0);
        faults & fault.bit() != 0
    }

    /// How much longer it takes, as a factor.
    pub fn drag(&self) -> i32 {
        if self.fails(Fault::Slow) { 4 } else { 1 }
    }

    /// A number of chance from 0 to below this.
    pub fn chance(&mut self, below: i32) -> i32 {
        // xorshift64* (Vigna, 2016)
        let mut random = *self.random;
        random ^= random >> 12;
        random ^= random << 25;
        random ^= random >> 27;
        *self.random = random;
        let number = random.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33;
        (number % u64::from(below.max(1).cast_unsigned())) as i32
    }

    /// Its contact is actuated, or not: the input that it switches follows, as its faults let it.
    pub fn sense(&mut self, field: impl Into<usize>, actuated: bool) {
        let field = field.into();
        let Given::Contact(contact) = self.given(field) else {
            return;
        };
        let cell = self.part.contacts.get(field).copied().unwrap_or(usize::MAX);
        let seen = self.values.get(cell).copied().unwrap_or(0);
        // Positive while it is actuated, and for how long.
        let next = match (actuated, seen > 0) {
            (true, true) => (seen + 1).min(CONTACT_SEEN),
            (true, false) => 1,
            (false, true) => -1,
            (false, false) => (seen - 1).max(-CONTACT_SEEN),
        };
        if let Some(held) = self.values.get_mut(cell) {
            *held = next;
        }
        let mut closed = actuated != contact.normally_closed;
        if self.fails(Fault::Bouncing) && next.abs() <= BOUNCE && self.chance(2) == 0 {
            closed = !closed;
        }
        if self.fails(Fault::Open) {
            closed = false;
        }
        if self.fails(Fault::Short) {
            closed = true;
        }
        self.inputs.points.set(contact.input, closed);
    }

    /// Its analogue value is this, 0 to 1023: the input that it sets follows, as its faults let it. Gives what came.
    pub fn reading(&mut self, field: impl Into<usize>, value: i32) -> i32 {
        let value = if self.fails(Fault::Open) {
            0
        } else if self.fails(Fault::Short) {
            FULL
        } else {
            value.clamp(0, FULL)
        };
        if let Given::Analogue(input) = self.given(field)
            && let Some(place) = self.inputs.analogue.get_mut(usize::from(input))
        {
            *place = value as u16;
        }
        value
    }

    /// The value that a field names, and its range.
    pub fn named(&self, field: impl Into<usize>) -> Option<(usize, usize)> {
        match self.given(field) {
            Given::Value(part, value) => Some((part, value)),
            _ => None,
        }
    }
}

/// Stores a value of a part within its range.
fn store(values: &mut [i32], part: &Part, value: usize, at: usize, to: i32) {
    let (Some(slot), Some(first)) = (part.kind.values.get(value), part.cells.get(value)) else {
        return;
    };
    if at >= slot.count {
        return;
    }
    let (low, high) = part.range(value);
    if let Some(cell) = values.get_mut(first + at) {
        *cell = to.max(low).min(high);
    }
}
