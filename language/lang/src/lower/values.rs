//! What operands and the accumulator are worth.

use super::{ACCUMULATOR, Acc, BLOCK, BOOL, Lower, NUMBER, OPERAND, Words};
use crate::ast::Operand;
use crate::diagnostics::{Code, Span, Word};
use crate::names::Place;
use crate::tree::{Bit, Expr, Num, Number};
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

impl Lower<'_, '_> {
    pub(super) fn instance(&self) -> Option<usize> {
        self.scopes.last().map(|scope| scope.instance)
    }

    /// What an operand means.
    pub(super) fn place(&mut self, operand: &Operand) -> Place {
        if let Some(place) = self.block_member(operand) {
            return place;
        }
        let instance = self.instance();
        // Names get markers that no intermediate result has had.
        self.names.temps = self.rungs.temps;
        let place = self.names.place(operand, instance, self.found);
        self.rungs.temps = self.names.temps;
        place
    }

    /// The operand's value.
    pub(super) fn value(&mut self, operand: &Operand) -> Acc {
        let span = operand.span;
        let bit = |bit| {
            Acc::Bit(Expr::Lit {
                bit,
                negated: false,
                span,
            })
        };
        match self.place(operand) {
            Place::Bit(place) => {
                match place {
                    Bit::At(Address::Input(n)) => self.names.inputs_read |= 1 << (n - 1),
                    Bit::Timer(timer) => self.reads_timer(timer, span),
                    _ => {}
                }
                bit(place)
            }
            Place::Always(state) => Acc::Bit(Expr::Const(state)),
            Place::Number(
                Num::At(Address::Pwm(_) | Address::CountPreset(_)) | Num::TimerPreset(_),
            ) => {
                let name = self.spelled(operand);
                let help = ("it can only be written", "só pode ser escrito");
                self.found.tell(
                    Code::NoSuchMember,
                    span,
                    ["PLC".into(), name.into(), help.into()],
                );
                Acc::Unknown
            }
            Place::Number(num) => {
                match num {
                    Num::At(Address::Inputs(_)) => self.names.inputs_read = u128::MAX,
                    Num::Elapsed(timer) => self.reads_timer(timer, span),
                    _ => {}
                }
                Acc::Number(Number::Leaf(num, span))
            }
            Place::Timer(timer) => {
                self.reads_timer(timer, span);
                bit(Bit::Timer(timer))
            }
            Place::Counter(counter) => {
                let counter = &self.names.counters[counter];
                if counter.kind == Some(Opcode::CountDown) {
                    bit(Bit::At(Address::AtZero(counter.number)))
                } else {
                    bit(Bit::At(Address::Reached(counter.number)))
                }
            }
            Place::Trigger(_, marker) | Place::Latch(_, marker) => {
                bit(Bit::At(Address::Marker(marker)))
            }
            Place::Instance(_) => {
                let name = self.spelled(operand);
                self.wrong_type(name, span, BLOCK, BOOL);
                Acc::Unknown
            }
            Place::Unknown => Acc::Unknown,
        }
    }

    pub(super) fn reads_timer(&mut self, timer: usize, span: Span) {
        self.names.timers[timer].read.get_or_insert(span);
    }

    pub(super) fn spelled(&self, operand: &Operand) -> String {
        self.names.written(operand.span)
    }

    pub(super) fn wrong_type(&mut self, what: String, span: Span, is: Words, needed: Words) {
        let what: Word = match what.as_str() {
            ACCUMULATOR => ("the accumulator", "o acumulador").into(),
            OPERAND => ("the operand", "o operando").into(),
            _ => what.into(),
        };
        let words = [what, is.into(), needed.into()];
        self.found.tell(Code::WrongType, span, words);
    }

    /// As a bit; the constants 0 and 1 are both bit and number.
    pub(super) fn as_bit(&mut self, acc: Acc, what: &str, span: Span) -> Option<Expr> {
        match acc {
            Acc::Bit(expr) => Some(expr),
            Acc::Number(number) => match number.constant() {
                Some(number @ 0..=1) => Some(Expr::Const(number == 1)),
                _ => {
                    self.wrong_type(what.to_owned(), span, NUMBER, BOOL);
                    None
                }
            },
            Acc::Empty | Acc::Unknown => None,
        }
    }

    pub(super) fn as_number(&mut self, acc: Acc, what: &str, span: Span) -> Option<Number> {
        match acc {
            Acc::Number(number) => Some(number),
            Acc::Bit(_) => {
                self.wrong_type(what.to_owned(), span, BOOL, NUMBER);
                None
            }
            Acc::Empty | Acc::Unknown => None,
        }
    }

    /// The accumulator, for an instruction that uses it.
    pub(super) fn take_acc(&mut self, what: &str, span: Span) -> Acc {
        self.unused = None;
        let acc = std::mem::replace(&mut self.acc, Acc::Unknown);
        if acc == Acc::Empty {
            self.found.tell(Code::NothingLoaded, span, [what.into()]);
            return Acc::Unknown;
        }
        acc
    }

    /// The accumulator as a bit.
    pub(super) fn take_bit(&mut self, what: &str, span: Span) -> Option<Expr> {
        let acc = self.take_acc(what, span);
        self.as_bit(acc, ACCUMULATOR, span)
    }

    /// The accumulator as a condition: a number is true where it is not 0.
    pub(super) fn take_condition(&mut self, what: &str, span: Span) -> Option<Expr> {
        let acc = self.take_acc(what, span);
        match acc {
            Acc::Number(number) if !matches!(number.constant(), Some(0..=1)) => {
                Some(Expr::Compare {
                    op: Opcode::NotEqual,
                    left: Box::new(number),
                    right: Box::new(Number::Leaf(Num::Const(0), span)),
                    span,
                })
            }
            acc => self.as_bit(acc, ACCUMULATOR, span),
        }
    }
}
