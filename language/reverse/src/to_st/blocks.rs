//! Timers, counters and edges.
//!
//! Owns which of them are blocks of the standard, and what the others are. Must not know what else is in a rung.

use super::counters::{Counter, Edge};
use super::expr::{Expr, Place, Type, and, binary, call, compare, not, whole};
use super::machine::Machine;
use super::statement::Statement;
use super::why::Why;
use unoclp_core::isa::{Opcode, Operand};
use unoclp_core::{Instruction, Target};
use unoclp_point::Address;

impl Machine<'_, '_> {
    fn counter(&self, number: u8) -> Counter {
        self.body
            .counting
            .0
            .get(&number)
            .cloned()
            .unwrap_or_default()
    }

    fn preset(&self, number: u8) -> Expr {
        let counter = self.counter(number);
        match counter.changes_preset {
            true => Expr::at(Address::CountPreset(number)),
            false => whole(counter.preset),
        }
    }

    /// Whether the block of this counter has been called in this scan.
    fn is_called(&self, counter: &Counter) -> bool {
        let called = counter.called.as_ref();
        called.is_some_and(|(at, scopes)| *at <= self.at && self.scopes.starts_with(scopes))
    }

    /// Whether a counter has reached its preset.
    pub fn reached(&self, number: u8) -> Expr {
        let counter = self.counter(number);
        match counter.block {
            Some((Opcode::CountUp, _)) if self.is_called(&counter) => {
                Expr::at(Address::Reached(number))
            }
            _ => compare(">=", Expr::at(Address::Count(number)), self.preset(number)),
        }
    }

    pub fn is_zero(&self, number: u8) -> Expr {
        let counter = self.counter(number);
        match counter.block {
            Some((Opcode::CountDown, _)) if self.is_called(&counter) => {
                Expr::at(Address::Reached(number))
            }
            _ => compare("<=", Expr::at(Address::Count(number)), whole(0)),
        }
    }

    /// CTU, CTD.
    pub fn count(&mut self, step: Instruction<'_>) {
        let number = step.number().unwrap_or_default();
        let counter = self.counter(number);
        let up = step.opcode == Opcode::CountUp;
        match counter.block {
            Some((_, last)) => self.count_block(number, up, counter.preset, last),
            None => self.count_by_hand(number, up, &counter),
        }
    }

    /// A block of the standard, with the reset or load of the rung after it.
    fn count_block(&mut self, number: u8, up: bool, preset: i32, last: Option<usize>) {
        let is = |place| matches!(place, Place::At(Address::Count(n) | Address::Reached(n)) if n == number);
        if last.is_some() && self.acc.reads(&|place| matches!(place, Place::Value(_))) {
            let acc = self.acc.clone();
            self.acc = self.aside(acc);
        }
        let counts = std::mem::replace(&mut self.acc, Expr::Is(true));
        let scopes = self.scopes.clone();
        if let Some(counter) = self.body.counting.0.get_mut(&number) {
            counter.called = Some((self.at, scopes));
        }
        let (input, other) = if up { ("CU", "R") } else { ("CD", "LD") };
        let mut inputs = vec![(input, counts)];
        if let Some(last) = last {
            // What it counts is no longer in acc: the steps up to the reset say when that is.
            while self.at + 1 < last {
                self.at += 1;
                self.comments();
                let step = self.steps[self.at];
                match step.opcode {
                    Opcode::NewRung => self.rung(),
                    _ => drop(self.bit(step)),
                }
            }
            self.at = last;
            inputs.push((other, self.acc.clone()));
        }
        self.changes(&is);
        inputs.push(("PV", whole(preset)));
        self.put(Statement::Call(
            Place::At(Address::Count(number)),
            inputs,
            None,
        ));
        if last.is_none() {
            self.acc = Expr::at(Address::Reached(number));
        }
    }

    /// A variable that is counted at each rise.
    fn count_by_hand(&mut self, number: u8, up: bool, counter: &Counter) {
        let codes = if up { &counter.ups } else { &counter.downs };
        let rises = match codes.len() == 1 && !self.flow.in_loop(self.at) {
            true => {
                self.edge(Opcode::RisingEdge);
                self.acc.clone()
            }
            false => {
                let before = if up {
                    Place::CountUp(number)
                } else {
                    Place::CountDown(number)
                };
                self.seen_edge(before, true)
            }
        };
        let count = Place::At(Address::Count(number));
        self.acc = Expr::Is(true);
        self.changes(&|place| place == count);
        let (sign, end, most) = if up {
            ("+", "<", i32::MAX)
        } else {
            ("-", ">", i32::MIN)
        };
        // It stops at the ends of 32 bits, where only what is stored brings it.
        let goes = match counter.is_stored {
            true => and(rises, compare(end, Expr::Place(count), whole(most))),
            false => rises,
        };
        let next = binary(sign, Expr::Place(count), whole(1));
        self.when(goes, vec![Statement::Assign(count, next)]);
        self.acc = if up {
            self.reached(number)
        } else {
            self.is_zero(number)
        };
    }

    /// RWC, SWC.
    pub fn counter_coil(&mut self, opcode: Opcode, number: u8) {
        let count = Place::At(Address::Count(number));
        let becomes = match opcode {
            Opcode::ResetCounter => whole(0),
            _ => self.preset(number),
        };
        self.shorten_acc();
        self.changes(&|place| place == count);
        self.when(self.acc.clone(), vec![Statement::Assign(count, becomes)]);
    }

    /// EU, ED.
    pub fn edge(&mut self, opcode: Opcode) {
        let edge = match opcode {
            Opcode::RisingEdge => Edge::Rise,
            _ => Edge::Fall,
        };
        self.body.edges.push(edge);
        let number = self.body.edges.len() as u16;
        if self.flow.in_loop(self.at) {
            self.acc = self.seen_edge(Place::EdgeBefore(number), edge == Edge::Rise);
            return;
        }
        let clock = std::mem::replace(&mut self.acc, Expr::Place(Place::EdgeQ(number)));
        let inputs = vec![("CLK", clock)];
        self.put(Statement::Call(Place::EdgeQ(number), inputs, None));
    }

    /// Whether acc has risen, or fallen, since this bit was last set to it.
    fn seen_edge(&mut self, before: Place, rise: bool) -> Expr {
        if !self.acc.is_simple() {
            let acc = self.acc.clone();
            self.acc = self.aside(acc);
        }
        let acc = self.acc.clone();
        let seen = Expr::Place(before);
        let edge = match rise {
            true => and(acc.clone(), not(seen)),
            false => and(not(acc.clone()), seen),
        };
        let edge = self.aside(edge);
        self.put(Statement::Assign(before, acc));
        edge
    }

    /// A timer block.
    pub fn timer(&mut self, step: Instruction<'_>) -> Result<(), Why> {
        let Operand::Timer(block) = step.operand else {
            return Ok(());
        };
        if step.opcode == Opcode::RetentiveOnDelay {
            return Err(Why::NoWords);
        }
        if self.flow.in_loop(self.at) {
            return Err(Why::TimerInLoop);
        }
        let number = match block.target {
            Target::Timer(called) => {
                // Its preset would stay for the timer's own block, which gives another.
                let own = self.body.timers.get(usize::from(called).wrapping_sub(1));
                let is_same = own.is_some_and(|(_, own)| *own == block.preset.cast_signed());
                if !is_same || self.changes_preset(called) {
                    return Err(Why::NoWords);
                }
                called
            }
            _ => {
                let preset = block.preset.cast_signed();
                self.body.timers.push((step.opcode, preset));
                self.body.timers.len() as u8
            }
        };
        let scopes = self.scopes.clone();
        self.timer_scopes.insert(number, scopes);
        let q = Place::At(Address::TimerQ(number));
        let target = match block.target {
            Target::Timer(_) => q,
            driven => Place::At(driven.into()),
        };
        let preset = match self.changes_preset(number) {
            true => Expr::at(Address::TimerPreset(number)),
            false => Expr::Constant(block.preset.cast_signed(), Type::Time),
        };
        let on = std::mem::replace(&mut self.acc, Expr::Is(true));
        self.changes(&|place| {
            place == target || matches!(place, Place::At(Address::TimerQ(n) | Address::Elapsed(n)) if n == number)
        });
        self.acc = Expr::Place(target);
        let inputs = vec![("IN", on), ("PT", preset)];
        let driven = Some(target).filter(|_| block.is_own());
        self.put(Statement::Call(q, inputs, driven));
        Ok(())
    }

    fn changes_preset(&self, timer: u8) -> bool {
        let preset = |step: &Instruction<'_>| step.opcode == Opcode::PresetTimer;
        self.steps
            .iter()
            .any(|step| preset(step) && step.number() == Some(timer))
    }

    /// The elapsed time of a timer. In a text it is that of the call, which must have been in this scan.
    pub fn elapsed(&self, number: u8) -> Result<Expr, Why> {
        let called = self.timer_scopes.get(&number);
        if !called.is_some_and(|called| self.scopes.starts_with(called))
            || self.changes_preset(number)
        {
            return Err(Why::EarlyTime);
        }
        let elapsed = call("TIME_TO_DINT", Expr::at(Address::Elapsed(number)));
        Ok(match self.body.timers.get(usize::from(number) - 1) {
            // After its delay, that of a TOF stays.
            Some((Opcode::OffDelay, _)) => {
                let runs = Expr::at(Address::TimerQ(number));
                Expr::Call("SEL", vec![runs, whole(0), elapsed])
            }
            _ => elapsed,
        })
    }
}
