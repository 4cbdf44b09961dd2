//! Logic as contacts and branches.
//!
//! Owns how it becomes a ladder. Must not know statements.

use super::coder::Coder;
use super::logic::{Bit, Contact, begins, is_block};
use super::pen::Acc;
use super::seats::Seat;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;
use unoclp_tree::Expr;

fn xor(seat: Seat, negated: bool) -> Option<(Opcode, u8)> {
    match seat {
        Seat::At(point) => Some((point.xor(negated)?, point.number())),
        Seat::Timer(_) | Seat::Elapsed(_) | Seat::Now => None,
    }
}

/// Whether one instruction joins it with acc.
fn is_xor_point(part: &Bit) -> bool {
    matches!(part, Bit::Contact(of) if xor(of.seat, false).is_some())
}

/// Where its first contact stands.
fn first_at(part: &Bit) -> Option<Span> {
    match part {
        Bit::Is(_) => None,
        Bit::Contact(of) => Some(of.at),
        Bit::Test(.., at) => Some(*at),
        Bit::And(parts) | Bit::Or(parts) | Bit::Xor(parts, _) => parts.iter().find_map(first_at),
    }
}

/// The cell of its first contact.
fn first_cell(part: &Bit) -> Option<u32> {
    match part {
        Bit::Contact(of) => Some(of.cell),
        Bit::And(parts) | Bit::Or(parts) | Bit::Xor(parts, _) => parts.iter().find_map(first_cell),
        Bit::Is(_) | Bit::Test(..) => None,
    }
}

impl Coder<'_, '_> {
    /// Brings a prepared expression into acc.
    pub(super) fn bit(&mut self, from: &Expr, negated: bool) {
        let bit = self.logic(from, negated);
        self.bring(bit);
    }

    /// Likewise logic.
    pub(super) fn bring(&mut self, bit: Bit) {
        if let Acc::Bit(held) = self.pen.acc {
            let mut turned = bit.clone();
            if begins(&mut turned, held) && self.goes_on(&turned, held) {
                self.go_on(&turned);
                return;
            }
        }
        let at = first_at(&bit).unwrap_or(self.pen.at);
        self.placed(at, |this| this.pen.fresh());
        self.start(&bit);
        // Nothing but a coil changes one of these.
        if let Bit::Contact(Contact {
            seat,
            negated: false,
            ..
        }) = bit
            && let Seat::At(Address::Input(_) | Address::Output(_) | Address::Marker(_)) = seat
        {
            self.pen.acc = Acc::Bit(seat);
            self.pen.held = first_at(&bit).map(|at| (seat, at));
        }
    }

    /// Whether logic that begins with the bit that acc holds goes on with it. Where the text begins a rung with that bit,
    /// it has its contact.
    pub(super) fn goes_on(&self, bit: &Bit, held: Seat) -> bool {
        if !self.has_rungs() {
            return true;
        }
        match self.pen.held.filter(|(seat, _)| *seat == held) {
            Some((_, coil)) => {
                first_at(bit).is_some_and(|at| at.start <= coil.start && coil.end <= at.end)
            }
            // What a timer or an edge has just driven, unless the text names it.
            None => first_cell(bit).is_none_or(|cell| {
                let is_point = matches!(held, Seat::At(Address::Marker(_) | Address::Output(_)));
                !is_point || !self.named.contains_key(&cell)
            }),
        }
    }

    /// What follows the contact that logic begins with, which acc is.
    fn go_on(&mut self, bit: &Bit) {
        let (Bit::And(parts) | Bit::Or(parts) | Bit::Xor(parts, _)) = bit else {
            return;
        };
        let Some((first, others)) = parts.split_first() else {
            return;
        };
        self.go_on(first);
        match bit {
            Bit::Or(_) => self.parallel(others),
            Bit::Xor(_, turned) => self.exclusively(others.iter(), *turned),
            _ => others.iter().for_each(|part| self.series(part)),
        }
    }

    fn changes(&mut self) {
        self.pen.acc = Acc::Other;
    }

    fn start(&mut self, bit: &Bit) {
        match bit {
            Bit::Is(true) => {}
            Bit::Is(false) => {
                self.pen.plain(Opcode::Not);
                self.changes();
            }
            Bit::And(parts) => {
                let first = parts.iter().position(is_block).unwrap_or(0);
                self.start(&parts[first]);
                for (at, part) in parts.iter().enumerate() {
                    if at != first {
                        self.series(part);
                    }
                }
            }
            Bit::Or(parts) => {
                self.start(&parts[0]);
                self.parallel(&parts[1..]);
            }
            Bit::Xor(parts, turned) => self.start_xor(parts, *turned),
            Bit::Contact(..) | Bit::Test(..) => self.series(bit),
        }
    }

    fn parallel(&mut self, parts: &[Bit]) {
        for part in parts {
            self.block(Opcode::OpenBranch, part);
        }
    }

    fn start_xor(&mut self, parts: &[Bit], turned: bool) {
        let first = parts.iter().position(|part| !is_xor_point(part));
        let first = first.unwrap_or(0);
        self.start(&parts[first]);
        let others = parts.iter().enumerate().filter(|(at, _)| *at != first);
        self.exclusively(others.map(|(_, part)| part), turned);
    }

    fn exclusively<'b>(&mut self, parts: impl Iterator<Item = &'b Bit>, mut turned: bool) {
        for part in parts {
            match part {
                Bit::Contact(of) if is_xor_point(part) => {
                    let negated = of.negated != std::mem::take(&mut turned);
                    if let Some((opcode, number)) = xor(of.seat, negated) {
                        self.placed(of.at, |this| {
                            this.pen.numbered(opcode, number, Some(of.cell));
                        });
                    }
                    self.changes();
                }
                _ => self.block(Opcode::OpenXor, part),
            }
        }
        if turned {
            self.pen.plain(Opcode::Not);
            self.changes();
        }
    }

    fn block(&mut self, opening: Opcode, part: &Bit) {
        let at = first_at(part).unwrap_or(self.pen.at);
        self.placed(at, |this| this.pen.plain(opening));
        self.start(part);
        self.placed(at, |this| this.pen.plain(Opcode::CloseBranch));
        self.changes();
    }

    fn contact(&mut self, of: Contact) {
        let cell = Some(of.cell);
        match of.seat {
            Seat::Timer(timer) => {
                let opcode = match of.negated {
                    true => Opcode::TimerContactNot,
                    false => Opcode::TimerContact,
                };
                self.pen.of_timer(opcode, timer, cell);
            }
            Seat::At(point) => {
                if let Some(opcode) = point.contact(of.negated) {
                    self.pen.numbered(opcode, point.number(), cell);
                }
            }
            Seat::Elapsed(_) | Seat::Now => {}
        }
    }

    pub(super) fn series(&mut self, bit: &Bit) {
        match bit {
            Bit::Is(true) => {}
            Bit::Contact(of) => {
                self.placed(of.at, |this| this.contact(*of));
                self.changes();
            }
            Bit::Test(op, a, b, at) => {
                if self.has_rungs() {
                    // Each comparison that is drawn loads what it compares.
                    self.pen.holds = None;
                }
                self.placed(*at, |this| this.compare(*op, a, b));
                self.changes();
            }
            Bit::And(parts) => parts.iter().for_each(|part| self.series(part)),
            Bit::Is(false) | Bit::Or(_) | Bit::Xor(..) => self.block(Opcode::OpenAnd, bit),
        }
    }
}
