//! Writing expressions out as codes.
//!
//! Owns what the board's accumulator and value hold at each moment, and where a rung begins; must not know
//! what the text meant by it.

mod numbers;

use crate::diagnostics::Span;
use crate::temps::Temps;
use crate::tree::{Bit, Expr};
use unoclp_core::Target;
use unoclp_core::isa::{DEEPEST, Opcode, Value};
use unoclp_point::Address;

/// An instruction that has been written, with what is still to be looked up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Written {
    Plain(Opcode),
    Numbered(Opcode, u8),
    Value(Opcode, Value),
    /// A table: its first register and how many it has.
    Table(Opcode, u8, u8),
    /// A code that names a timer: its index among the names, and its block where one stands above.
    OfTimer(Opcode, usize, Option<u8>),
    /// A timer block; without a target nobody has asked for its Q yet.
    Timer(Opcode, i32, Option<Target>),
    Count(Opcode, u8, i32),
    /// A label's index.
    Label(usize),
    Jump(Opcode, usize),
    /// A code of the text itself.
    Code(i32),
}

/// An instruction and what of the text it comes from.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    pub written: Written,
    pub span: Span,
}

/// What the board's accumulator holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds {
    /// 1, at the head of a rung.
    One,
    /// This bit.
    Bit(Bit),
    /// What the text's accumulator holds, or anything.
    Other,
}

/// The program as far as it is written.
#[derive(Debug)]
pub(crate) struct Rungs {
    pub steps: Vec<Step>,
    pub holds: Holds,
    /// Whether a label may stand here.
    pub head: bool,
    /// For each timer among the names, its latest block.
    pub blocks: Vec<Option<u8>>,
    /// Timer blocks so far.
    pub timers: u8,
    pub temps: Temps,
    open: u8,
    /// Where more branches would be open than the board can have.
    pub too_deep: Option<Span>,
}

impl Rungs {
    pub(crate) fn new(temps: Temps) -> Rungs {
        Rungs {
            steps: Vec::new(),
            holds: Holds::One,
            head: true,
            blocks: Vec::new(),
            timers: 0,
            temps,
            open: 0,
            too_deep: None,
        }
    }

    pub(crate) fn write(&mut self, written: Written, span: Span) {
        self.head = false;
        self.steps.push(Step { written, span });
    }

    /// A new rung, where the accumulator is not 1 for certain.
    pub(crate) fn fresh(&mut self, span: Span) {
        if self.holds != Holds::One {
            self.new_rung(span);
        }
    }

    pub(crate) fn new_rung(&mut self, span: Span) {
        self.write(Written::Plain(Opcode::NewRung), span);
        self.holds = Holds::One;
        self.head = true;
    }

    /// Brings an expression into the board's accumulator.
    pub(crate) fn logic(&mut self, expr: Expr, span: Span) {
        let expr = expr.settled();
        if !expr.has_live() {
            self.fresh(expr.place().unwrap_or(span));
        }
        self.start(&expr, span);
        if expr != Expr::Const(true) {
            self.holds = Holds::Other;
        }
    }

    /// Writes an expression where the accumulator is 1, or what [`Expr::Live`] stands for.
    fn start(&mut self, expr: &Expr, span: Span) {
        match expr {
            Expr::Live | Expr::Const(true) => {}
            Expr::Const(false) => self.changes(Written::Plain(Opcode::Not), span),
            Expr::Lit { bit, negated, span } => self.contact(*bit, *negated, *span),
            Expr::Compare { .. } => self.series(expr, span),
            Expr::Not(inner) => {
                self.start(inner, span);
                self.changes(Written::Plain(Opcode::Not), span);
            }
            Expr::And(list) => {
                let first = first_of(list, Expr::brackets);
                self.start(&list[first], span);
                for part in others(list, first) {
                    self.series(part, span);
                }
            }
            Expr::Or(list) => {
                let first = first_of(list, |_| false);
                self.start(&list[first], span);
                for part in others(list, first) {
                    self.block(Opcode::OpenBranch, part, span);
                }
            }
            Expr::Xor(list) => {
                let first = first_of(list, |part| !part.is_xor_point());
                self.start(&list[first], span);
                for part in others(list, first) {
                    match part {
                        Expr::Lit { bit, negated, span } if part.is_xor_point() => {
                            self.changes(xor(*bit, *negated), *span);
                        }
                        _ => self.block(Opcode::OpenXor, part, span),
                    }
                }
            }
        }
    }

    /// Writes an expression in series with what the accumulator holds.
    fn series(&mut self, expr: &Expr, span: Span) {
        match expr {
            Expr::Const(true) => {}
            Expr::Lit { bit, negated, span } => self.contact(*bit, *negated, *span),
            Expr::Compare {
                op,
                left,
                right,
                span,
            } => self.compare(*op, left, right, *span),
            Expr::And(list) => list.iter().for_each(|part| self.series(part, span)),
            _ => self.block(Opcode::OpenAnd, expr, span),
        }
    }

    fn block(&mut self, opening: Opcode, expr: &Expr, span: Span) {
        let span = expr.place().unwrap_or(span);
        self.changes(Written::Plain(opening), span);
        self.open += 1;
        if self.open > DEEPEST {
            self.too_deep.get_or_insert(span);
        }
        self.start(expr, span);
        self.open -= 1;
        self.changes(Written::Plain(Opcode::CloseBranch), span);
    }

    /// An instruction after which the accumulator is no longer 1 for certain.
    pub(crate) fn changes(&mut self, written: Written, span: Span) {
        self.write(written, span);
        self.holds = Holds::Other;
    }

    fn contact(&mut self, bit: Bit, negated: bool, span: Span) {
        let written = match bit {
            Bit::Timer(timer) => {
                let pick = [Opcode::TimerContact, Opcode::TimerContactNot];
                self.of_timer(pick[usize::from(negated)], timer)
            }
            Bit::At(point) => of_point(point.contact(negated), point),
        };
        self.changes(written, span);
    }

    pub(crate) fn of_timer(&self, opcode: Opcode, timer: usize) -> Written {
        Written::OfTimer(opcode, timer, self.blocks.get(timer).copied().flatten())
    }

    /// A coil. One that follows a timer whose Q nobody else takes becomes the timer's own.
    pub(crate) fn coil(&mut self, target: Target, negated: bool, span: Span) {
        if let Some(Step {
            written: Written::Timer(_, _, free @ None),
            ..
        }) = self.steps.last_mut()
            && !negated
        {
            *free = Some(target);
            return;
        }
        let pick = |plain, inverted| if negated { inverted } else { plain };
        self.write(
            match target {
                Target::Output(n) => Written::Numbered(pick(Opcode::Coil, Opcode::NegatedCoil), n),
                Target::Marker(n) => {
                    Written::Numbered(pick(Opcode::MarkerCoil, Opcode::NegatedMarkerCoil), n)
                }
            },
            span,
        );
    }

    /// A timer block, whose IN is the accumulator.
    pub(crate) fn timer(&mut self, opcode: Opcode, timer: usize, preset: i32, span: Span) {
        self.timers = self.timers.saturating_add(1);
        if self.blocks.len() <= timer {
            self.blocks.resize(timer + 1, None);
        }
        self.blocks[timer] = Some(self.timers);
        self.write(Written::Timer(opcode, preset, None), span);
        self.holds = Holds::Bit(Bit::Timer(timer));
    }
}

/// The part to write first: the one that must be, else the first that pays.
fn first_of(list: &[Expr], pays: impl Fn(&Expr) -> bool) -> usize {
    let must = list.iter().position(Expr::is_first);
    must.or_else(|| list.iter().position(pays)).unwrap_or(0)
}

fn others(list: &[Expr], first: usize) -> impl Iterator<Item = &Expr> {
    list.iter()
        .enumerate()
        .filter(move |(index, _)| *index != first)
        .map(|(_, part)| part)
}

fn xor(bit: Bit, negated: bool) -> Written {
    match bit {
        Bit::At(point) => of_point(point.xor(negated), point),
        Bit::Timer(_) => Written::Plain(Opcode::Not),
    }
}

/// The instruction that names this point. The names let nobody read a bit that has none.
fn of_point(opcode: Option<Opcode>, point: Address) -> Written {
    match opcode {
        Some(opcode) => Written::Numbered(opcode, point.number()),
        None => Written::Plain(Opcode::Not),
    }
}
