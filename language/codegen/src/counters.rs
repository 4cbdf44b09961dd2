//! Counters by the board's own instructions, and what is done to counters and timers beside their calls.
//!
//! Owns which instructions that takes. Must not know other blocks.

use super::coder::Coder;
use super::fails::may_fail;
use super::flat::each;
use super::logic::{Bit, Contact};
use super::pen::Acc;
use super::seats::Seat;
use super::traces::Shows;
use unoclp_core::isa::{Opcode, Operand, Value as Taken};
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Expr, ExprKind, Order, Standard, Store};

/// The preset of a counter: what its codes say, and what a call sets it to.
struct Preset {
    fixed: i32,
    set: Option<Expr>,
}

impl Coder<'_, '_> {
    /// A call: it counts, then it is loaded, then it is reset.
    pub(super) fn counter(&mut self, block: Standard, cell: u32, inputs: &[(u32, Expr)]) {
        let Some(&counter) = self.seats.counters.get(&cell) else {
            return;
        };
        let [up, down, reset, load] = match block {
            Standard::Ctu => [Some(0), None, Some(1), None],
            Standard::Ctd => [None, Some(0), None, Some(1)],
            _ => [Some(0), Some(1), Some(2), Some(3)],
        };
        let counts = [up, down].map(|part| part.and_then(|part| self.counted(cell, inputs, part)));
        let [mut up, mut down] = counts;
        let [mut reset, mut load] =
            [reset, load].map(|part| part.map(|part| self.input(cell, inputs, part)));
        let mut preset = self.preset_of(block, cell, inputs);
        if let Some(set) = &mut preset.set
            && (block == Standard::Ctd && may_fail(set)
                || block == Standard::Ctud && self.operand(set).is_none())
        {
            // It is used more than once, or where LD is 1 alone, and computed always.
            *set = self.keep(set.clone());
        }
        // What is asked of the counter itself is asked before it counts.
        let sets = preset.set.is_some() && block != Standard::Ctd;
        let first = if sets {
            None
        } else {
            up.as_ref().map(|_| 0).or(Some(1))
        };
        for (at, input) in [&mut up, &mut down, &mut load, &mut reset]
            .into_iter()
            .enumerate()
        {
            if Some(at) != first
                && let Some(value) = input
                && asks(value, cell..cell + block.cells())
            {
                *value = self.keep(value.clone());
            }
        }
        if block != Standard::Ctd
            && let Some(set) = &preset.set
        {
            self.pen.fresh();
            self.value(set);
            self.pen
                .numbered(Opcode::PresetCounter, counter, Some(cell));
        }
        for (on, opcode, zero) in [
            (up, Opcode::CountUp, false),
            (down, Opcode::CountDown, true),
        ] {
            let Some(on) = on else { continue };
            self.bit(&on, false);
            let preset = preset.fixed;
            let count = Operand::Count { counter, preset };
            self.pen.with(opcode, count, Some(cell));
            self.pen.acc = Acc::Bit(Seat::At(match zero {
                true => Address::AtZero(counter),
                false => Address::Reached(counter),
            }));
            let number = counter;
            self.shows(Shows::Counter { number, zero });
        }
        if let Some(load) = load.filter(|on| !is_never(on)) {
            self.bit(&load, false);
            match &preset.set {
                Some(set) if block != Standard::Counter && !is_preset(set, block) => {
                    self.value(set);
                    self.pen.numbered(Opcode::StoreCount, counter, Some(cell));
                }
                _ => self.pen.numbered(Opcode::LoadCounter, counter, Some(cell)),
            }
            self.forgets(counter);
        }
        if let Some(reset) = reset.filter(|on| !is_never(on)) {
            self.bit(&reset, false);
            self.pen.numbered(Opcode::ResetCounter, counter, Some(cell));
            self.forgets(counter);
        }
        self.outputs(block, cell, counter);
    }

    /// What a call counts; none where it gives nothing to count, since what it holds has been counted.
    fn counted(&mut self, cell: u32, inputs: &[(u32, Expr)], part: u32) -> Option<Expr> {
        let given = inputs.iter().any(|(at, _)| *at == part);
        let held = self.seats.of.contains_key(&(cell + part));
        (given || held).then(|| self.input(cell, inputs, part))
    }

    /// The preset that all calls give alike, so that the counter's codes say it.
    fn fixed_preset(&self, block: Standard, cell: u32) -> Option<i32> {
        let part = block.preset()?;
        let known = self.uses.given.get(&(cell + part)).copied().flatten()?;
        let initial = self.flat.cells.get((cell + part) as usize)?.initial.int();
        // With its sign, as the board takes it.
        let (known, initial) = (known as i32, initial as i32);
        let is_so = match block {
            // What it says before its first call is what it begins with.
            Standard::Counter => known.max(0) == initial.max(0),
            // It has not reached its preset even where that is less than 0.
            Standard::Ctu => true,
            _ => known >= 0,
        };
        (is_so && !self.sets_again(cell, part)).then_some(known.max(0))
    }

    /// Whether a call does nothing before it looks at what it counts.
    pub(super) fn begins_to_count(
        &self,
        block: Standard,
        cell: u32,
        inputs: &[(u32, Expr)],
    ) -> bool {
        let own = || cell..cell + block.cells();
        self.fixed_preset(block, cell).is_some() && !inputs.iter().any(|(_, on)| asks(on, own()))
    }

    fn preset_of(&mut self, block: Standard, cell: u32, inputs: &[(u32, Expr)]) -> Preset {
        let part = block.preset().unwrap_or_default();
        let held = self.flat.cells.get((cell + part) as usize);
        let initial = held.map_or(0, |held| (held.initial.int() as i32).max(0));
        let own = block == Standard::Counter;
        if let Some(fixed) = self.fixed_preset(block, cell) {
            return Preset { fixed, set: None };
        }
        let given = inputs.iter().any(|(at, _)| *at == part);
        let held = self.seats.of.contains_key(&(cell + part));
        let set = (given || held).then(|| self.input(cell, inputs, part));
        let fixed = match &set {
            // Before its first call nothing asks for it.
            Some(_) if !own && !self.uses.preset.contains(&cell) => 0,
            _ => initial,
        };
        Preset { fixed, set }
    }

    /// What a counter says of itself, where that needs a place of its own.
    fn outputs(&mut self, block: Standard, cell: u32, counter: u8) {
        let seats = [Address::Reached(counter), Address::AtZero(counter)];
        for (part, seat) in block.reached().into_iter().zip(seats) {
            if let Some(part) = part {
                self.reached(cell + part, Seat::At(seat));
            }
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
        let (negated, at) = (false, Span::default());
        self.series(&Bit::Contact(Contact {
            seat,
            negated,
            cell,
            at,
        }));
        self.drive_any(held, cell);
    }

    /// acc may be what this counter said before.
    fn forgets(&mut self, counter: u8) {
        let own = [Address::Reached(counter), Address::AtZero(counter)].map(Seat::At);
        if matches!(self.pen.acc, Acc::Bit(seat) if own.contains(&seat)) {
            self.pen.acc = Acc::Other;
        }
    }

    /// Whether an order takes no more than instructions that look at acc.
    pub(super) fn is_plain_order(&self, order: &Order, block: Standard, cell: u32) -> bool {
        let [up, down] = block.reached();
        let outputs = [up, down].into_iter().flatten();
        let is_contact = |part: u32| {
            let seat = self.seats.of.get(&(cell + part));
            !matches!(
                seat,
                Some(Seat::At(Address::Marker(_) | Address::Register(_)))
            )
        };
        outputs.into_iter().all(is_contact) && order.value().is_none_or(|of| self.is_harmless(of))
    }

    /// Does it where acc is 1.
    pub(super) fn order(&mut self, order: &Order, block: Standard, cell: u32) {
        if block.is_timer() {
            return self.order_timer(order, cell);
        }
        let (Some(&counter), Some(part)) = (self.seats.counters.get(&cell), block.preset()) else {
            return;
        };
        match order {
            Order::Reset => self.pen.numbered(Opcode::ResetCounter, counter, Some(cell)),
            Order::Load => {
                let held = self.held(cell + part);
                // Of a CTD whose preset is computed the board does not have it.
                if matches!(held.kind, ExprKind::Read(_)) {
                    self.value(&held);
                    self.pen
                        .numbered(Opcode::PresetCounter, counter, Some(cell));
                }
                self.pen.numbered(Opcode::LoadCounter, counter, Some(cell));
            }
            Order::Number(value) => {
                self.stored_value(value);
                self.pen.numbered(Opcode::StoreCount, counter, Some(cell));
            }
            Order::Preset(value) => {
                self.stored_value(value);
                self.pen
                    .numbered(Opcode::PresetCounter, counter, Some(cell));
                self.store(cell + part);
            }
            Order::Look => {}
        }
        self.forgets(counter);
        self.outputs(block, cell, counter);
    }

    fn order_timer(&mut self, order: &Order, cell: u32) {
        let Some(&timer) = self.seats.timers.get(&cell) else {
            return;
        };
        match order {
            Order::Reset => {
                self.pen.of_timer(Opcode::ResetTimer, timer, Some(cell));
                if self.pen.acc == Acc::Bit(Seat::Timer(timer)) {
                    self.pen.acc = Acc::Other;
                }
                let elapsed = self.seats.of.get(&(cell + 3));
                if let Some(Seat::At(Address::Register(_))) = elapsed {
                    self.pen.operation(Opcode::Load, Taken::Constant(0), None);
                    self.store(cell + 3);
                    self.pen.holds = None;
                }
            }
            Order::Preset(value) => {
                self.stored_value(value);
                self.pen.of_timer(Opcode::PresetTimer, timer, Some(cell));
                self.store(cell + 1);
            }
            Order::Load | Order::Number(_) | Order::Look => {}
        }
    }

    /// Value as its own type holds it.
    fn stored_value(&mut self, value: &Expr) {
        self.value(value);
        self.narrowed(value, Store::Narrow(value.base));
    }
}

/// Whether an input reads something of the counter's own.
fn asks(value: &Expr, own: std::ops::Range<u32>) -> bool {
    let mut asks = false;
    each(value, &mut |part| {
        if let ExprKind::Read(place) = &part.kind {
            asks |= own.contains(&place.offset);
        }
    });
    asks
}

fn is_never(on: &Expr) -> bool {
    matches!(&on.kind, ExprKind::Constant(value) if !value.is_true())
}

/// Whether the board holds it as the preset of this counter.
fn is_preset(preset: &Expr, block: Standard) -> bool {
    block == Standard::Ctud
        && matches!(&preset.kind, ExprKind::Constant(value) if value.int() as i32 >= 0)
}
