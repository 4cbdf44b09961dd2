//! What works on the accumulator: loads, operations, and their deferral.

use super::again::Edge;
use super::said::{POP, name};
use super::{ACCUMULATOR, Acc, Lower, OPERAND, numbered};
use crate::ast::{Instr, Stmt, UnitKind};
use crate::diagnostics::{Code, Span};
use crate::operators::Op;
use crate::rung::{Holds, Written};
use crate::tree::{Expr, Num, Number};
use crate::words::operator;
use unoclp_core::isa::{Class, Kind, Opcode, Row, TABLE};

impl Lower<'_, '_> {
    pub(super) fn load(&mut self, instr: &Instr) {
        self.warn_unused();
        self.unused = Some(instr.whole);
        let inverted = std::mem::take(&mut self.invert_load) != instr.negated;
        if self.frames.is_empty() && self.is_alone() {
            self.rungs.temps.release();
        }
        self.links = 0;
        let Some(operand) = instr.operands.first() else {
            self.missing("LD", instr.span);
            self.acc = Acc::Unknown;
            return;
        };
        self.only(instr, 1);
        let acc = self.value(operand);
        // The board's accumulator may hold just that: Q of the timer above.
        let acc = match acc {
            Acc::Bit(Expr::Lit { bit, .. })
                if self.rungs.holds == Holds::Bit(bit) && self.frames.is_empty() =>
            {
                Acc::Bit(Expr::Live)
            }
            acc => acc,
        };
        self.acc = if inverted {
            self.inverted(acc, operand.span)
        } else {
            acc
        };
        if let Some(edge) = instr.edge {
            self.edge_of_operand(instr, edge);
        }
    }

    /// Whether nothing outside of the accumulator and the frames waits.
    fn is_alone(&self) -> bool {
        self.block.is_none() && self.kept.is_empty() && self.waiting == 0
    }

    pub(super) fn missing(&mut self, what: &str, span: Span) {
        let example: (&str, &str) = match what {
            "ST" | "S" | "R" => ("Q1 or M1", "Q1 ou M1"),
            "JMP" => ("the name of a label", "o nome de um rótulo"),
            "CAL" | "BLK" | "IN" | "TON" | "TOF" | "TP" | "TONR" => ("T1 or C1", "T1 ou C1"),
            "CU" | "CD" | "CTU" | "CTD" | "CTUD" => ("C1", "C1"),
            "CLK" => ("the name of an R_TRIG", "o nome de um R_TRIG"),
            "CODE" => ("827301", "827301"),
            _ => ("I1, Q1 or M1", "I1, Q1 ou M1"),
        };
        self.found
            .tell(Code::OperandMissing, span, [what.into(), example.into()]);
    }

    /// An instruction takes so many operands, and no more.
    pub(super) fn only(&mut self, instr: &Instr, most: usize) {
        if let Some(more) = instr.operands.get(most) {
            let text = self.spelled(more);
            self.found.tell(Code::Unexpected, more.span, [text.into()]);
        }
    }

    /// The opposite: of a number, each bit's.
    pub(super) fn inverted(&mut self, acc: Acc, span: Span) -> Acc {
        match acc {
            Acc::Bit(expr) => Acc::Bit(expr.not()),
            Acc::Number(number) => match number.constant() {
                Some(number @ 0..=1) => Acc::Bit(Expr::Const(number == 0)),
                _ => Acc::Number(Number::Binary(
                    Opcode::XorWord,
                    Box::new(number),
                    Box::new(Number::Leaf(Num::Const(-1), span)),
                    span,
                )),
            },
            other => other,
        }
    }

    pub(super) fn not(&mut self, instr: &Instr) {
        let acc = self.take_acc("NOT", instr.span);
        self.acc = self.inverted(acc, instr.span);
    }

    /// AND, OR, XOR, arithmetic and comparisons, at once or deferred.
    pub(super) fn operate(&mut self, instr: &Instr, next: Option<&Stmt>) {
        if let Some(open) = instr.open {
            return self.defer(instr, open, next);
        }
        let left = self.take_acc(name(instr.op), instr.span);
        let Some(operand) = instr.operands.first() else {
            return self.missing(name(instr.op), instr.span);
        };
        let more = instr.op.takes_list() && !instr.negated;
        self.only(instr, if more { usize::MAX } else { 1 });
        if let Op::Number(opcode) | Op::Compare(opcode) = instr.op
            && operand.name() == Some(POP)
        {
            self.only(instr, 1);
            return self.pop(instr, opcode, left);
        }
        if let Some(edge) = instr.edge {
            return self.operate_edge(instr, edge, left);
        }
        let right = self.value(operand);
        let span = instr.whole;
        self.acc = self.apply(instr.op, instr.negated, left, right, span);
        self.link(span);
        for operand in instr.operands.iter().skip(1).filter(|_| more) {
            let left = std::mem::replace(&mut self.acc, Acc::Unknown);
            let right = self.value(operand);
            self.acc = self.apply(instr.op, false, left, right, operand.span);
            self.link(span);
        }
    }

    /// The result of an operation on two values.
    pub(super) fn apply(
        &mut self,
        op: Op,
        negated: bool,
        left: Acc,
        right: Acc,
        span: Span,
    ) -> Acc {
        if matches!(left, Acc::Unknown | Acc::Empty) || matches!(right, Acc::Unknown | Acc::Empty) {
            return Acc::Unknown;
        }
        let right = if negated {
            self.inverted(right, span)
        } else {
            right
        };
        let bits = matches!(left, Acc::Bit(_)) || matches!(right, Acc::Bit(_));
        let word = match op {
            Op::And => Opcode::AndWord,
            Op::Or => Opcode::OrWord,
            Op::Xor => Opcode::XorWord,
            Op::Number(opcode) | Op::Compare(opcode) => opcode,
            _ => return Acc::Unknown,
        };
        let on_bits = match op {
            Op::Number(_) => false,
            Op::Compare(opcode) => bits && matches!(opcode, Opcode::Equal | Opcode::NotEqual),
            _ => bits,
        };
        if on_bits {
            let left = self.as_bit(left, ACCUMULATOR, span);
            let right = self.as_bit(right, OPERAND, span);
            let (Some(left), Some(right)) = (left, right) else {
                return Acc::Unknown;
            };
            return Acc::Bit(match op {
                Op::And => left.and(right),
                Op::Or => left.or(right),
                Op::Compare(Opcode::Equal) => left.xor(right).not(),
                _ => left.xor(right),
            });
        }
        let left = self.as_number(left, ACCUMULATOR, span);
        let right = self.as_number(right, OPERAND, span);
        let (Some(left), Some(right)) = (left, right) else {
            return Acc::Unknown;
        };
        let (left, right) = (Box::new(left), Box::new(right));
        match op {
            Op::Compare(op) => Acc::Bit(Expr::Compare {
                op,
                left,
                right,
                span,
            }),
            _ => Acc::Number(Number::Binary(word, left, right, span)),
        }
    }

    pub(super) fn unary(&mut self, instr: &Instr, opcode: Opcode) {
        let acc = self.take_acc(operator(opcode), instr.span);
        if let Some(number) = self.as_number(acc, ACCUMULATOR, instr.span) {
            self.acc = Acc::Number(Number::Unary(opcode, Box::new(number), instr.span));
            self.link(instr.span);
        }
    }

    pub(super) fn shift(&mut self, instr: &Instr, opcode: Opcode) {
        let acc = self.take_acc(name(instr.op), instr.span);
        let number = self.as_number(acc, ACCUMULATOR, instr.span);
        let Some(operand) = instr.operands.first() else {
            return self.missing(name(instr.op), instr.span);
        };
        self.only(instr, 1);
        let bits = operand.number().and_then(|n| u8::try_from(n).ok());
        match (number, bits.filter(|&bits| bits <= 31)) {
            (Some(number), Some(bits)) => {
                let shifted = Number::Shift(opcode, Box::new(number), bits, instr.whole);
                self.acc = Acc::Number(shifted);
                self.link(instr.span);
            }
            (_, None) => {
                let text = self.spelled(operand);
                let range = ("a number from 0 to 31", "um número de 0 a 31");
                self.found
                    .tell(Code::BadValue, operand.span, [text.into(), range.into()]);
            }
            _ => {}
        }
    }

    /// EU, ED: the accumulator's own rise or fall.
    pub(super) fn edge(&mut self, instr: &Instr, opcode: Opcode) {
        let Some(expr) = self.take_bit(operator(opcode), instr.span) else {
            return;
        };
        let Some(scope) = self.scopes.last() else {
            return;
        };
        if self.kind_of(scope.unit) == UnitKind::Function {
            let name = self.names.written(instr.span);
            self.found.tell(Code::Stateless, instr.span, [name.into()]);
        }
        let edge = Edge::Operator(scope.instance, instr.span.start);
        self.rise_or_fall(edge, opcode, expr, instr.span);
    }

    /// Codes as they are: one instruction with its operand lines.
    pub(super) fn code(&mut self, instr: &Instr) {
        let span = instr.whole;
        self.unused = None;
        self.writes = true;
        match std::mem::replace(&mut self.acc, Acc::Empty) {
            Acc::Bit(expr) => self.bring(expr, span),
            _ => self.freeze(span),
        }
        if instr.operands.is_empty() {
            return self.missing("CODE", span);
        }
        for (index, operand) in instr.operands.iter().enumerate() {
            let Some(code) = operand.number() else {
                let text = self.spelled(operand);
                let range = ("a numeric code", "um código numérico");
                self.found
                    .tell(Code::BadValue, operand.span, [text.into(), range.into()]);
                continue;
            };
            self.rungs.write(Written::Code(code), operand.span);
            if index == 0 {
                self.code_effect(code);
            }
        }
    }

    /// What a code of the text does to what the compiler knows.
    fn code_effect(&mut self, code: i32) {
        self.rungs.holds = Holds::Other;
        self.acc = Acc::Bit(Expr::Live);
        let is_timer = |row: &Row| row.class == Class::Timer && row.code == code;
        if TABLE.iter().any(is_timer) {
            self.rungs.timers = self.rungs.timers.saturating_add(1);
        }
        self.names.inputs_read |= inputs_read(code);
        let label = code - Opcode::Label.row().code;
        let begins = [Opcode::NewRung, Opcode::If, Opcode::Else, Opcode::EndIf];
        let begins = begins.map(|opcode| opcode.row().code).contains(&code);
        if begins || (1..=32).contains(&label) {
            self.rungs.holds = Holds::One;
            self.rungs.head = true;
            self.acc = Acc::Bit(Expr::Const(true));
        }
    }

    /// Writes an instruction with a number, and leaves the accumulator as it is.
    pub(super) fn write(&mut self, opcode: Opcode, number: u8, span: Span) {
        self.rungs.write(numbered(opcode, number), span);
    }
}

/// The inputs that a code of the text reads: bit 0 is input 01.
fn inputs_read(code: i32) -> u128 {
    let reads = |row: &&Row| {
        let number = code.unsigned_abs().wrapping_sub(row.code.unsigned_abs());
        row.kind == Kind::Input && row.code.signum() == code.signum() && number < 100
    };
    let Some(row) = TABLE.iter().find(reads) else {
        return 0;
    };
    let number = code.unsigned_abs() - row.code.unsigned_abs();
    let bit = number.checked_sub(1).and_then(|bit| 1u128.checked_shl(bit));
    bit.unwrap_or(0)
}
