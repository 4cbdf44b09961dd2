//! What writes: ST, S, R.

use super::{ACCUMULATOR, Acc, BLOCK, BOOL, Lower, NUMBER};
use crate::ast::{Instr, Operand, Stmt};
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::operators::Op;
use crate::rung::Written;
use crate::tree::{Bit, Num, Number};
use crate::typed::Base;
use unoclp_core::Target;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

impl Lower<'_, '_> {
    pub(super) fn store(&mut self, instr: &Instr, next: Option<&Stmt>) {
        let acc = self.take_acc("ST", instr.span);
        if instr.operands.is_empty() {
            return self.missing("ST", instr.span);
        }
        if instr.starts_block() {
            return self.out_block_of(instr, acc, next);
        }
        let mut acc = acc;
        for operand in &instr.operands {
            acc = self.store_to(acc, operand, instr.negated, instr.whole);
        }
        self.acc = acc;
    }

    /// Stores the accumulator, and gives what it holds then.
    pub(super) fn store_to(
        &mut self,
        acc: Acc,
        operand: &Operand,
        negated: bool,
        span: Span,
    ) -> Acc {
        let place = self.place(operand);
        self.writes |= !matches!(place, Place::Bit(Bit::At(Address::Input(_))));
        match place {
            Place::Bit(Bit::At(Address::Input(_))) => {
                let name = self.spelled(operand);
                self.found
                    .tell(Code::StoreToInput, operand.span, [name.into()]);
                acc
            }
            Place::Bit(Bit::At(Address::Output(n))) => {
                self.note_coil(n, operand);
                self.store_bit(acc, Target::Output(n), negated, operand, span)
            }
            Place::Bit(Bit::At(Address::Marker(n))) => {
                self.store_bit(acc, Target::Marker(n), negated, operand, span)
            }
            Place::Number(num)
                if !matches!(
                    num,
                    Num::Const(_)
                        | Num::At(Address::Analogue(_))
                        | Num::Elapsed(_)
                        | Num::At(Address::Inputs(_))
                ) =>
            {
                let width = self.names.width(operand, self.instance());
                self.store_number(acc, (num, width), negated, operand, span)
            }
            Place::Unknown => acc,
            _ => {
                let name = self.spelled(operand);
                self.found
                    .tell(Code::NotWritable, operand.span, [name.into()]);
                acc
            }
        }
    }

    /// An output that has been written by ST before is told, where no jump may lead past one of the two.
    fn note_coil(&mut self, output: u8, operand: &Operand) {
        if self
            .scopes
            .iter()
            .any(|scope| !scope.wanted.is_empty() || scope.end.is_some())
        {
            return;
        }
        let span = operand.span;
        if *self.coils.entry(output).or_insert(span) != span {
            let name = self.spelled(operand);
            self.found.tell(Code::WrittenTwice, span, [name.into()]);
        }
    }

    fn store_bit(
        &mut self,
        acc: Acc,
        target: Target,
        negated: bool,
        operand: &Operand,
        span: Span,
    ) -> Acc {
        if let Acc::Number(number) = &acc
            && !matches!(number.constant(), Some(0..=1))
        {
            self.wrong_type(ACCUMULATOR.to_owned(), operand.span, NUMBER, BOOL);
            return acc;
        }
        let Some(expr) = self.as_bit(acc, ACCUMULATOR, span) else {
            return Acc::Unknown;
        };
        self.bring(expr, span);
        self.rungs.coil(target, negated, operand.span);
        std::mem::replace(&mut self.acc, Acc::Unknown)
    }

    fn store_number(
        &mut self,
        acc: Acc,
        (num, width): (Num, Option<Base>),
        negated: bool,
        operand: &Operand,
        span: Span,
    ) -> Acc {
        if let Acc::Bit(_) = acc {
            self.wrong_type(ACCUMULATOR.to_owned(), operand.span, BOOL, NUMBER);
            return acc;
        }
        let Some(mut number) = self.as_number(acc, ACCUMULATOR, span) else {
            return Acc::Unknown;
        };
        if let (Some(base), Some(constant), false) = (width, number.constant(), negated) {
            let name = self.spelled(operand);
            let to = (base, name.as_str());
            let constant = self.names.cut(to, constant, operand.span, self.found);
            number = Number::Leaf(Num::Const(constant), operand.span);
        }
        self.freeze(span);
        self.rungs.fresh(span);
        self.rungs.number(&number);
        let whole = number.clone();
        // What takes one code to load again is loaded again: it outlives what others do with the value.
        if !matches!(
            number,
            Number::Leaf(Num::Const(_) | Num::At(Address::Register(_)), _)
        ) {
            number = Number::Live;
        }
        if negated {
            let ones = unoclp_core::isa::Value::Constant(-1);
            self.rungs
                .write(Written::Value(Opcode::XorWord, ones), span);
        }
        let cut = self.narrow(&whole, negated, width, operand.span);
        let written = self.stored_in(num);
        self.rungs.write(written, operand.span);
        if negated && number == Number::Live {
            let ones = unoclp_core::isa::Value::Constant(-1);
            self.rungs
                .write(Written::Value(Opcode::XorWord, ones), span);
            if cut {
                self.narrow(&Number::Live, false, width, operand.span);
            }
        }
        // The register may be what the expression reads.
        match (&number, num) {
            (
                Number::Leaf(Num::At(Address::Register(read)), at),
                Num::At(Address::Register(written)),
            ) if *read == written && negated => Acc::Number(Number::Binary(
                Opcode::XorWord,
                Box::new(number.clone()),
                Box::new(Number::Leaf(Num::Const(-1), *at)),
                *at,
            )),
            _ => Acc::Number(number),
        }
    }

    /// The code that stores the board's value.
    pub(super) fn stored_in(&self, num: Num) -> Written {
        match num {
            Num::At(Address::Register(n)) => Written::Numbered(Opcode::Store, n),
            Num::At(Address::Count(n)) => Written::Numbered(Opcode::StoreCount, n),
            Num::At(Address::CountPreset(n)) => Written::Numbered(Opcode::PresetCounter, n),
            Num::At(Address::Pwm(n)) => Written::Numbered(Opcode::StorePwm, n),
            Num::At(Address::Group(n)) => Written::Numbered(Opcode::StoreMarkers, n),
            Num::TimerPreset(timer) => self.rungs.of_timer(Opcode::PresetTimer, timer),
            _ => Written::Plain(Opcode::StoreOutputs),
        }
    }

    pub(super) fn set_or_reset(&mut self, instr: &Instr) {
        let set = instr.op == Op::Set;
        let what = if set { "S" } else { "R" };
        if instr.operands.is_empty() && self.block.is_some() {
            return self.wire(what, instr.span);
        }
        let Some(expr) = self.take_bit(what, instr.span) else {
            return;
        };
        let Some(operand) = instr.operands.first() else {
            return self.missing(what, instr.span);
        };
        // On an S7-200 a count of points follows.
        let count = match instr.operands.get(1) {
            None => 1,
            Some(count) => count
                .number()
                .unwrap_or(1)
                .clamp(1, self.names.board.markers.into()) as u8,
        };
        self.only(instr, 2);
        let place = self.place(operand);
        if let Place::Bit(Bit::At(Address::Input(_))) = place {
            let name = self.spelled(operand);
            self.found
                .tell(Code::StoreToInput, operand.span, [name.into()]);
            self.acc = Acc::Bit(expr);
            return;
        }
        self.writes = true;
        self.bring(expr, instr.whole);
        let pick = |on, off| if set { on } else { off };
        match place {
            Place::Bit(Bit::At(Address::Output(n))) => {
                let last = n.saturating_add(count - 1).min(self.names.board.outputs);
                for n in n..=last {
                    self.write(pick(Opcode::SetCoil, Opcode::ResetCoil), n, operand.span);
                }
            }
            Place::Bit(Bit::At(Address::Marker(n))) => {
                let last = n.saturating_add(count - 1).min(self.names.board.markers);
                for n in n..=last {
                    self.write(
                        pick(Opcode::SetMarker, Opcode::ResetMarker),
                        n,
                        operand.span,
                    );
                }
            }
            Place::Timer(timer) if !set => {
                let written = self.rungs.of_timer(Opcode::ResetTimer, timer);
                self.rungs.write(written, operand.span);
            }
            Place::Counter(counter) => {
                let number = self.names.counters[counter].number;
                self.write(
                    pick(Opcode::LoadCounter, Opcode::ResetCounter),
                    number,
                    operand.span,
                );
            }
            Place::Number(_) => {
                let name = self.spelled(operand);
                self.wrong_type(name, operand.span, NUMBER, BOOL);
            }
            Place::Instance(_) => {
                let name = self.spelled(operand);
                self.wrong_type(name, operand.span, BLOCK, BOOL);
            }
            Place::Unknown => {}
            _ => {
                let name = self.spelled(operand);
                self.found
                    .tell(Code::NotWritable, operand.span, [name.into()]);
            }
        }
    }
}
