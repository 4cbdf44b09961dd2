//! The function blocks of the standard by the board's own instructions.
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
use unoclp_core::Target;
use unoclp_core::isa::{Opcode, Operand, Value as Taken};
use unoclp_point::Address;
use unoclp_tree::{Base, Binary, Expr, ExprKind, Standard, Store, Unary, Value};

impl Coder<'_, '_> {
    /// Calls a block; whether the step after it is done too.
    pub(super) fn standard(
        &mut self,
        block: Standard,
        cell: u32,
        inputs: &[(u32, Expr)],
        next: Option<&Step>,
    ) -> bool {
        if block.is_counter() {
            self.counter(block.plain(), cell, inputs);
            return false;
        }
        let input = |this: &mut Self, part: u32| this.input(cell, inputs, part);
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
            _ => {
                let (on, preset) = (input(self, 0), input(self, 1));
                return self.timer(block, cell, &on, &preset, next);
            }
        }
        false
    }

    /// What an input is, prepared; what it holds where the call does not give it.
    pub(super) fn input(&mut self, cell: u32, inputs: &[(u32, Expr)], part: u32) -> Expr {
        match inputs.iter().find(|(at, _)| *at == part) {
            Some((_, value)) => self.prepare(value.clone()),
            None => self.held(cell + part),
        }
    }

    /// Whether the calls of a block give this input different values.
    fn differs(&self, cell: u32, part: u32) -> bool {
        self.uses
            .given
            .get(&(cell + part))
            .is_some_and(Option::is_none)
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

    /// The input that a block looks at before anything else; its preset is known.
    fn begins_with<'i>(
        &self,
        block: Standard,
        cell: u32,
        inputs: &'i [(u32, Expr)],
    ) -> Option<&'i Expr> {
        let given = |part: u32| inputs.iter().find(|(at, _)| *at == part);
        let is_known = match block.preset() {
            Some(_) if block.is_counter() => self.begins_to_count(block, cell, inputs),
            Some(part) => {
                let is_constant = |(_, value): &(u32, Expr)| {
                    matches!(value.kind, ExprKind::Constant(_)) && !self.sets_again(cell, part)
                };
                given(part).is_some_and(is_constant)
            }
            None => block.is_edge(),
        };
        given(0).filter(|_| is_known).map(|(_, value)| value)
    }

    /// Whether a step begins with a bit that nothing else reads or shows, so that it takes it from acc.
    pub(super) fn takes(&self, step: Option<&Step>, cell: u32, seat: Seat) -> bool {
        let value = match step.map(|step| &step.does) {
            Some(Does::Assign(to, value, _)) if to.indices.is_empty() => value,
            Some(Does::Codes(Some(value), ..)) => value,
            Some(Does::If(value, then, otherwise)) if !then.is_empty() && otherwise.is_empty() => {
                value
            }
            Some(Does::Standard(block, cell, inputs)) => {
                match self.begins_with(*block, *cell, inputs) {
                    Some(value) if !self.is_called_again(*cell) => value,
                    _ => return false,
                }
            }
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

    /// Whether a call gives a preset that is set beside the calls too, so that each call sets it.
    pub(super) fn sets_again(&self, cell: u32, part: u32) -> bool {
        self.uses.preset.contains(&cell) && self.uses.given.contains_key(&(cell + part))
    }

    /// An input that the call does not give: what it holds.
    pub(super) fn held(&self, cell: u32) -> Expr {
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
    pub(super) fn drive_any(&mut self, seat: Seat, cell: u32) {
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
        let is_again = self.pen.has_timer(timer);
        // Another call may have left its preset there.
        let stays = is_again || !(self.is_called_again(cell) && self.differs(cell, 1));
        let fixed = match &preset.kind {
            ExprKind::Constant(value) if stays && !self.sets_again(cell, 1) => {
                value.int().max(0) as i32
            }
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
            Standard::Tonr => Opcode::RetentiveOnDelay,
            _ => Opcode::Pulse,
        };
        // A coil of Q right after it is the timer's own.
        let own = next.filter(|_| !is_again);
        let own = own.and_then(|next| self.coil_of(next, cell + 2));
        if is_again {
            self.pen.timer_again(opcode, timer, fixed, cell);
        } else {
            let target = match own {
                Some((target, _)) => target,
                None => self.idle_target(at),
            };
            self.pen.timer(opcode, timer, fixed, Some(target), cell);
        }
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
        self.pen.held = (own.zip(next)).map(|((_, seat), next)| (seat, next.at));
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
}
