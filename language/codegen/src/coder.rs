//! What writes instructions, and the least that it writes.
//!
//! Owns stores, coils and labels. Must not know expressions, nor the numbers of labels and timers.

use super::flat::Flat;
use super::pen::{Acc, Line, Pen, Written};
use super::seats::{Seat, Seats};
use super::traces::Noted;
use super::uses::Uses;
use std::collections::{HashMap, HashSet};
use unoclp_core::Target;
use unoclp_core::isa::{Opcode, Value as Taken};
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Found, Span};

pub(super) struct Coder<'a, 'f> {
    pub flat: &'a Flat,
    pub uses: &'a Uses,
    pub seats: Seats,
    pub pen: Pen,
    pub found: &'f mut Found,
    pub labels: u32,
    /// IFs that are open.
    pub deep: u32,
    /// What timers drive that nobody else has asked for.
    pub unused: Option<Target>,
    /// Whether the step at hand is a statement of the text, whose line shows what it does.
    pub shown: bool,
    pub noted: Vec<Noted>,
    /// The cells that are shown by their names.
    pub named: HashMap<u32, (String, Span)>,
    /// Where the text has an IF of the board, if it has rungs, which begin where it loads.
    pub drawn: Option<&'a HashSet<u32>>,
}

impl Coder<'_, '_> {
    /// Whether the text has rungs, which begin where it loads.
    pub(super) fn has_rungs(&self) -> bool {
        self.drawn.is_some()
    }

    /// Whether an IF stands here that is to be drawn as one.
    pub(super) fn is_drawn(&self, at: Span) -> bool {
        self.drawn.is_some_and(|all| all.contains(&at.start))
    }

    /// Sets S 04; value becomes 0.
    pub(super) fn fail(&mut self) {
        self.pen.operation(Opcode::Divide, Taken::Constant(0), None);
    }

    /// Writes what comes from this place of the text, in a statement that stands elsewhere or goes on beyond it.
    pub(super) fn placed(&mut self, at: Span, write: impl FnOnce(&mut Self)) {
        let at = if at == Span::default() {
            self.pen.at
        } else {
            at
        };
        let around = std::mem::replace(&mut self.pen.at, at);
        write(self);
        self.pen.at = around;
    }

    /// A new label.
    pub(super) fn label(&mut self) -> u32 {
        self.labels += 1;
        self.labels - 1
    }

    /// Value into the register of this cell, where acc is 1.
    pub(super) fn store(&mut self, cell: u32) {
        match self.seats.of.get(&cell) {
            Some(&Seat::At(Address::Register(register))) => {
                self.pen.numbered(Opcode::Store, register, Some(cell));
                if self.pen.acc == Acc::One {
                    self.pen.holds = Some(Seat::At(Address::Register(register)));
                }
                if let Some(&output) = self.seats.outputs.get(&cell) {
                    self.pen.numbered(Opcode::StorePwm, output, Some(cell));
                }
            }
            Some(&Seat::At(Address::Pwm(output))) => {
                self.pen.numbered(Opcode::StorePwm, output, Some(cell))
            }
            Some(&Seat::At(Address::Count(counter))) => {
                self.pen.numbered(Opcode::StoreCount, counter, Some(cell));
            }
            Some(&Seat::At(Address::Group(group))) => {
                self.pen.numbered(Opcode::StoreMarkers, group, Some(cell));
                self.forgets_bits();
            }
            Some(&Seat::At(Address::Outputs(_))) => {
                let line = self.pen.lines.len();
                self.pen.plain(Opcode::StoreOutputs);
                self.pen.names(line, cell);
                self.forgets_bits();
            }
            _ => {}
        }
    }

    /// acc may be what one of eight bits held before.
    fn forgets_bits(&mut self) {
        if let Acc::Bit(Seat::At(Address::Marker(_) | Address::Output(_))) = self.pen.acc {
            self.pen.acc = Acc::Other;
        }
    }

    /// A coil: the bit := acc.
    pub(super) fn drive(&mut self, seat: Seat, cell: u32) {
        match seat {
            Seat::At(Address::Output(n)) => self.pen.numbered(Opcode::Coil, n, Some(cell)),
            Seat::At(Address::Marker(n)) => self.pen.numbered(Opcode::MarkerCoil, n, Some(cell)),
            _ => return,
        }
        // acc is what the bit holds now; where it is 1 for certain, that is worth more.
        if self.pen.acc != Acc::One {
            self.pen.acc = Acc::Bit(seat);
            self.pen.held = Some((seat, self.pen.at));
        }
    }

    /// A coil of the opposite of acc, which stays what it is.
    pub(super) fn drive_opposite(&mut self, seat: Seat, cell: u32) {
        let (opcode, number) = match seat {
            Seat::At(Address::Output(n)) => (Opcode::NegatedCoil, n),
            Seat::At(Address::Marker(n)) => (Opcode::NegatedMarkerCoil, n),
            _ => return,
        };
        self.pen.numbered(opcode, number, Some(cell));
        if self.pen.acc == Acc::Bit(seat) {
            self.pen.acc = Acc::Other;
        }
    }

    /// Sets or resets a bit where acc is 1.
    pub(super) fn coil(&mut self, seat: Seat, set: bool, cell: u32) {
        let (opcode, number) = match (seat, set) {
            (Seat::At(Address::Output(n)), true) if self.pen.acc == Acc::One => (Opcode::Coil, n),
            (Seat::At(Address::Marker(n)), true) if self.pen.acc == Acc::One => {
                (Opcode::MarkerCoil, n)
            }
            (Seat::At(Address::Output(n)), true) => (Opcode::SetCoil, n),
            (Seat::At(Address::Output(n)), false) => (Opcode::ResetCoil, n),
            (Seat::At(Address::Marker(n)), true) => (Opcode::SetMarker, n),
            (Seat::At(Address::Marker(n)), false) => (Opcode::ResetMarker, n),
            _ => return,
        };
        self.pen.numbered(opcode, number, Some(cell));
        // A contact that acc was may be this one.
        if let Acc::Bit(held) = self.pen.acc
            && held == seat
        {
            self.pen.acc = Acc::Other;
        }
    }

    /// Takes back the coils of bits of the compiler's own that no instruction names beside: what follows each has taken it
    /// from acc.
    pub(super) fn spare_coils(&mut self) {
        let is_coil = |line: &Line| matches!(&line.written, Written::Is(is) if is.opcode == Opcode::MarkerCoil);
        let others = self.pen.lines.iter().filter(|line| !is_coil(line));
        let named: HashSet<u32> = others.filter_map(|line| line.cell).collect();
        let is_spare = |line: &Line| {
            let own = line.cell.filter(|cell| !named.contains(cell));
            let own = own.and_then(|cell| self.flat.cells.get(cell as usize));
            is_coil(line) && own.is_some_and(|cell| cell.scratch)
        };
        // How many lines stay as far as each, itself among them.
        let mut staying = 0;
        let stay: Vec<usize> = self
            .pen
            .lines
            .iter()
            .map(|line| {
                staying += usize::from(!is_spare(line));
                staying
            })
            .collect();
        self.pen.lines.retain(|line| !is_spare(line));
        for noted in &mut self.noted {
            let stay = stay.get(noted.line).copied().unwrap_or(staying);
            noted.line = stay.saturating_sub(1);
        }
    }

    /// What timers drive for nobody: one marker for all of them, which nothing else has and nothing reads.
    pub(super) fn idle_target(&mut self, at: Span) -> Target {
        if let Some(target) = self.unused {
            return target;
        }
        let target = match self.seats.lasting(true) {
            Some(Seat::At(Address::Marker(n))) => Target::Marker(n),
            _ => {
                let words = ("marker without retention", "memória não retentiva");
                let most = "56".to_owned();
                let name = ("this block", "este bloco");
                self.found.tell(
                    Code::BoardNoneLeft,
                    at,
                    [words.into(), most.into(), name.into()],
                );
                Target::Marker(1)
            }
        };
        self.unused = Some(target);
        target
    }
}
