//! The function blocks of the norm by the board's own instructions.
//!
//! Owns which instructions a block becomes and which of its members need a place. Must not know other statements.

use super::coder::Coder;
use super::fails::may_fail;
use super::flat::{Does, Step, constant, place, read};
use super::flat::{both, each, not};
use super::logic::begins;
use super::pen::Acc;
use super::prepare::MOST_DEEP;
use super::ranges::bounds;
use super::seats::Seat;
use super::traces::Shows;
use super::uses::EDGE_MEMORY;
use crate::typed::{Base, Binary, Expr, ExprKind, Standard, Store, Unary, Value};
use unoclp_core::Target;
use unoclp_core::isa::{Opcode, Operand, Value as Taken};
use unoclp_point::Address;

impl Coder<'_, '_> {
    /// Calls a block; whether the step after it is done too.
    pub(super) fn standard(
        &mut self,
        block: Standard,
        cell: u32,
        inputs: &[(u32, Expr)],
        next: Option<&Step>,
    ) -> bool {
        let input = |this: &mut Self, part: u32| -> Expr {
            let given = inputs.iter().find(|(at, _)| *at == part);
            match given {
                Some((_, value)) => this.prepare(value.clone()),
                None => this.held(cell + part),
            }
        };
        match block {
            Standard::Sr => {
                let (set, reset) = (input(self, 0), input(self, 1));
                let held = read(cell + 2, Base::Bool, self.pen.at);
                let stays = both(Binary::And, held, not(reset));
                self.result(cell + 2, &both(Binary::Or, set, stays));
            }
            Standard::Rs => {
                let (set, reset) = (input(self, 0), input(self, 1));
                let held = read(cell + 2, Base::Bool, self.pen.at);
                let on = both(Binary::Or, set, held);
                self.result(cell + 2, &both(Binary::And, not(reset), on));
            }
            Standard::RTrig | Standard::FTrig if self.is_called_again(cell) => {
                let clock = input(self, 0);
                self.edge_again(block, cell, clock);
            }
            Standard::RTrig | Standard::FTrig => {
                let clock = input(self, 0);
                self.bit(&clock, false);
                self.pen.plain(match block {
                    Standard::RTrig => Opcode::RisingEdge,
                    _ => Opcode::FallingEdge,
                });
                self.pen.acc = Acc::Other;
                self.shows(Shows::Power { inverted: false });
                if let Some(seat) = self.seats.of.get(&(cell + 1)).copied() {
                    match self.takes(next, cell + 1, seat) {
                        true => self.pen.acc = Acc::Bit(seat),
                        false => self.drive_any(seat, cell + 1),
                    }
                }
            }
            Standard::Ton | Standard::Tof | Standard::Tp => {
                let (on, preset) = (input(self, 0), input(self, 1));
                return self.timer(block, cell, &on, &preset, next);
            }
            Standard::Ctu | Standard::CtuDint => {
                let (up, reset, preset) = (input(self, 0), input(self, 1), input(self, 2));
                let Some(&counter) = self.seats.counters.get(&cell) else {
                    return false;
                };
                self.counts(Opcode::CountUp, counter, &up, &preset, cell);
                self.shows_counter(counter, false);
                self.reset(counter, &reset, cell);
                self.reached(cell + 3, Seat::At(Address::Reached(counter)));
            }
            Standard::Ctd | Standard::CtdDint => {
                let (down, load, mut preset) = (input(self, 0), input(self, 1), input(self, 2));
                // It is loaded where LD is 1 alone, and computed always.
                if may_fail(&preset) {
                    preset = self.keep(preset);
                }
                let Some(&counter) = self.seats.counters.get(&cell) else {
                    return false;
                };
                let steady = constant(Value::Int(0), Base::Int, self.pen.at);
                let own = if is_preset(&preset) { &preset } else { &steady };
                self.counts(Opcode::CountDown, counter, &down, own, cell);
                self.shows_counter(counter, true);
                self.load_counter(counter, &load, &preset, cell);
                self.reached(cell + 3, Seat::At(Address::AtZero(counter)));
            }
            Standard::Ctud | Standard::CtudDint => {
                let (up, down) = (input(self, 0), input(self, 1));
                let (reset, load) = (input(self, 2), input(self, 3));
                let mut preset = input(self, 4);
                let Some(&counter) = self.seats.counters.get(&cell) else {
                    return false;
                };
                if self.operand(&preset).is_none() {
                    preset = self.keep(preset);
                }
                self.counts(Opcode::CountUp, counter, &up, &preset, cell);
                self.shows_counter(counter, false);
                let steady = constant(Value::Int(0), Base::Int, self.pen.at);
                let own = if is_preset(&preset) { &preset } else { &steady };
                self.counts_down_too(counter, &down, own, &preset, cell);
                self.load_counter(counter, &load, &preset, cell);
                self.reset(counter, &reset, cell);
                self.reached(cell + 5, Seat::At(Address::Reached(counter)));
                self.reached(cell + 6, Seat::At(Address::AtZero(counter)));
            }
        }
        false
    }

    fn is_called_again(&self, cell: u32) -> bool {
        let called = self.uses.blocks.get(&cell);
        called.is_some_and(|called| called.count > 1)
    }

    /// One of the calls of an edge: it has changed since the call before, wherever that was.
    fn edge_again(&mut self, block: Standard, cell: u32, clock: Expr) {
        let at = self.pen.at;
        let own = cell..cell + block.cells();
        let now = match &clock.kind {
            ExprKind::Read(place) if !own.contains(&place.offset) || place.offset == cell => clock,
            ExprKind::Constant(_) => clock,
            _ => self.keep(clock),
        };
        let before = read(cell + EDGE_MEMORY, Base::Bool, at);
        let changed = match block {
            Standard::RTrig => both(Binary::And, now.clone(), not(before)),
            _ => both(Binary::And, not(now.clone()), before),
        };
        self.result(cell + 1, &changed);
        self.shows(Shows::Power { inverted: false });
        self.result(cell + EDGE_MEMORY, &now);
    }

    /// The input that a block looks at before anything else; its preset is a constant.
    fn begins_with<'i>(&self, block: Standard, inputs: &'i [(u32, Expr)]) -> Option<&'i Expr> {
        let given = |part: u32| inputs.iter().find(|(at, _)| *at == part);
        let preset = block.part("PT").or_else(|| block.part("PV"));
        let is_known = match preset {
            Some((part, _)) => {
                given(part).is_some_and(|(_, value)| matches!(value.kind, ExprKind::Constant(_)))
            }
            None => block.is_edge(),
        };
        given(0).filter(|_| is_known).map(|(_, value)| value)
    }

    /// Whether a step begins with a bit that nothing else reads or shows, so that it takes it from acc.
    fn takes(&self, step: Option<&Step>, cell: u32, seat: Seat) -> bool {
        let value = match step.map(|step| &step.does) {
            Some(Does::Assign(to, value, _)) if to.indices.is_empty() => value,
            Some(Does::If(value, then, otherwise)) if !then.is_empty() && otherwise.is_empty() => {
                value
            }
            Some(Does::Standard(block, cell, inputs)) => match self.begins_with(*block, inputs) {
                Some(value) if !self.is_called_again(*cell) => value,
                _ => return false,
            },
            _ => return false,
        };
        let mut is_plain = value.base == Base::Bool && self.nest(value) < MOST_DEEP;
        each(value, &mut |part| {
            is_plain &= match &part.kind {
                ExprKind::Read(place) => place.indices.is_empty() && part.base == Base::Bool,
                ExprKind::Unary(Unary::Not, _) => true,
                ExprKind::Binary(op, ..) => {
                    matches!(op, Binary::And | Binary::Or | Binary::Xor) && part.base == Base::Bool
                }
                _ => false,
            };
        });
        let reads = self.uses.get(cell).map_or(0, |of| of.reads);
        let is_own = reads == 1 && !self.named.contains_key(&cell);
        is_plain && is_own && begins(&mut self.logic(value, false), seat)
    }

    /// An input that the call does not give: what it holds.
    fn held(&self, cell: u32) -> Expr {
        let at = self.pen.at;
        let Some(of) = self.flat.cells.get(cell as usize) else {
            return constant(Value::Int(0), Base::Bool, at);
        };
        match self.seats.of.contains_key(&cell) {
            true => read(cell, of.base, at),
            false => constant(of.initial.clone(), of.base, at),
        }
    }

    /// Q1, which has no place where nothing reads it.
    fn result(&mut self, cell: u32, value: &Expr) {
        if !self.seats.of.contains_key(&cell) && may_fail(value) {
            return self.bit(value, false);
        }
        self.assign_prepared(&place(cell, value.at), value, Store::Narrow(Base::Bool));
    }

    /// acc into whatever the bit is; after it acc may be anything.
    fn drive_any(&mut self, seat: Seat, cell: u32) {
        match seat {
            Seat::At(Address::Register(_)) => {
                self.pen.changes_value(Opcode::LoadBit);
                self.pen.fresh();
                self.store(cell);
            }
            seat => self.drive(seat, cell),
        }
    }

    fn timer(
        &mut self,
        block: Standard,
        cell: u32,
        on: &Expr,
        preset: &Expr,
        next: Option<&Step>,
    ) -> bool {
        let Some(&timer) = self.seats.timers.get(&cell) else {
            return false;
        };
        let at = self.pen.at;
        let fixed = match &preset.kind {
            ExprKind::Constant(value) => value.int().max(0) as i32,
            _ => {
                self.pen.fresh();
                self.value(preset);
                self.pen.of_timer(Opcode::PresetTimer, timer, Some(cell));
                0
            }
        };
        self.bit(on, false);
        let opcode = match block {
            Standard::Ton => Opcode::OnDelay,
            Standard::Tof => Opcode::OffDelay,
            _ => Opcode::Pulse,
        };
        // A coil of Q right after it is the timer's own.
        let own = next.and_then(|next| self.coil_of(next, cell + 2));
        let target = match own {
            Some((target, _)) => target,
            None => self.idle_target(at),
        };
        self.pen.timer(opcode, timer, fixed, Some(target), cell);
        self.shows(Shows::Power { inverted: false });
        if let (Some(_), Some(next)) = (own, next) {
            let call = std::mem::replace(&mut self.pen.at, next.at);
            self.shows(Shows::Power { inverted: false });
            self.pen.at = call;
        }
        self.pen.acc = match own {
            Some((_, seat)) => Acc::Bit(seat),
            None => Acc::Bit(Seat::Timer(timer)),
        };
        let elapsed = self.seats.of.get(&(cell + 3)).copied();
        if let Some(Seat::At(Address::Register(_))) = elapsed {
            if block == Standard::Tof {
                // While Q is 1 the time runs; where it falls, it is the preset from then on.
                self.pen.of_timer(Opcode::LoadTimer, timer, None);
                self.pen.holds = None;
                self.store(cell + 3);
                self.pen.plain(Opcode::FallingEdge);
                self.pen.acc = Acc::Other;
                self.value(preset);
                if bounds(preset).0 < 0 {
                    // It was 0, and stays so.
                    let least = Operand::Value(Taken::Constant(0));
                    self.pen.with(Opcode::GreaterOrEqual, least, None);
                }
                self.store(cell + 3);
                self.pen.holds = None;
            } else {
                self.pen.fresh();
                self.pen.of_timer(Opcode::LoadTimer, timer, None);
                self.pen.holds = None;
                self.store(cell + 3);
            }
        }
        own.is_some()
    }

    /// `lamp := t.Q;` of a bit that a timer may drive.
    fn coil_of(&self, step: &Step, q: u32) -> Option<(Target, Seat)> {
        let Does::Assign(to, value, _) = &step.does else {
            return None;
        };
        let ExprKind::Read(from) = &value.kind else {
            return None;
        };
        if from.offset != q || !from.indices.is_empty() || !to.indices.is_empty() {
            return None;
        }
        match self.seats.of.get(&to.offset)? {
            seat @ Seat::At(Address::Output(n)) => Some((Target::Output(*n), *seat)),
            seat @ Seat::At(Address::Marker(n)) => Some((Target::Marker(*n), *seat)),
            _ => None,
        }
    }

    /// Counts where it rises.
    fn counts(&mut self, opcode: Opcode, counter: u8, on: &Expr, preset: &Expr, cell: u32) {
        let fixed = match &preset.kind {
            ExprKind::Constant(value) => value.int().max(0) as i32,
            _ => {
                self.pen.fresh();
                self.value(preset);
                self.pen
                    .numbered(Opcode::PresetCounter, counter, Some(cell));
                0
            }
        };
        self.bit(on, false);
        let count = Operand::Count {
            counter,
            preset: fixed,
        };
        self.pen.with(opcode, count, Some(cell));
        self.pen.acc = Acc::Other;
    }

    fn shows_counter(&mut self, number: u8, zero: bool) {
        self.shows(Shows::Counter { number, zero });
    }

    /// The second of two codes of one counter, both of which set its preset at the start.
    fn counts_down_too(&mut self, counter: u8, on: &Expr, own: &Expr, preset: &Expr, cell: u32) {
        let own = if is_preset(preset) { preset } else { own };
        self.counts(Opcode::CountDown, counter, on, own, cell);
    }

    fn reset(&mut self, counter: u8, on: &Expr, cell: u32) {
        if !is_never(on) {
            self.bit(on, false);
            self.pen.numbered(Opcode::ResetCounter, counter, Some(cell));
        }
    }

    fn load_counter(&mut self, counter: u8, on: &Expr, preset: &Expr, cell: u32) {
        if is_never(on) {
            return;
        }
        self.bit(on, false);
        if is_preset(preset) {
            self.pen.numbered(Opcode::LoadCounter, counter, Some(cell));
        } else {
            self.value(preset);
            self.pen.numbered(Opcode::StoreCount, counter, Some(cell));
        }
    }

    /// Q where it needs a place of its own.
    fn reached(&mut self, cell: u32, seat: Seat) {
        let Some(held) = self.seats.of.get(&cell).copied() else {
            return;
        };
        if held == seat {
            return;
        }
        self.pen.fresh();
        self.series(&super::logic::Bit::Contact(seat, false, cell));
        self.drive_any(held, cell);
    }
}

fn is_never(on: &Expr) -> bool {
    matches!(&on.kind, ExprKind::Constant(value) if !value.is_true())
}

/// Whether a counter's code may say it.
fn is_preset(preset: &Expr) -> bool {
    matches!(&preset.kind, ExprKind::Constant(value) if value.int() >= 0)
}
