//! What the makers write in their own ways: `OUT T0 K50`, `TIM 000 #0050`, LDP, PLS. The accumulator stays what it
//! was where the norm's would become the result.

use super::counters::Inputs;
use super::timers::Preset;
use super::{ACCUMULATOR, Acc, Lower, loads};
use crate::ast::{Instr, Operand, Stmt};
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::tree::{Bit, Expr};
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// ms that a step of a maker's usual timer is.
const STEP: i32 = 100;

impl Lower<'_, '_> {
    /// `OUT T0 K50`, `OUT C1 K3`.
    pub(super) fn out_block_of(&mut self, instr: &Instr, acc: Acc, next: Option<&Stmt>) {
        let [block, preset] = &instr.operands[..] else {
            return;
        };
        let place = self.place(block);
        let base = match place {
            Place::Timer(timer) => {
                if is_fx_retentive(block) {
                    let kind = &mut self.names.timers[timer].kind;
                    kind.get_or_insert(Opcode::RetentiveOnDelay);
                }
                fx_step(block)
            }
            _ => 1,
        };
        let preset = self.preset(preset, base);
        let (Some(mut expr), Some(preset)) = (self.as_bit(acc, ACCUMULATOR, instr.span), preset)
        else {
            return;
        };
        if instr.negated {
            expr = expr.not();
        }
        let expr = self.needed_again(expr, next, instr.whole);
        self.acc = Acc::Bit(expr.clone());
        self.start_block(place, block, expr, preset, instr.whole);
    }

    /// `TIM 000 #0050`: steps of 100 ms.
    pub(super) fn omron_timer(&mut self, instr: &Instr, next: Option<&Stmt>) {
        let expr = self.take_bit("TIM", instr.span);
        let [timer, preset, ..] = &instr.operands[..] else {
            return self.missing_preset("TIM", "000 #0050", instr.span);
        };
        let (place, preset) = (self.place(timer), self.preset(preset, STEP));
        let (Some(expr), Some(preset)) = (expr, preset) else {
            return;
        };
        let expr = self.needed_again(expr, next, instr.whole);
        self.acc = Acc::Bit(expr.clone());
        self.start_block(place, timer, expr, preset, instr.whole);
    }

    /// `CNT 001 #0003`: the result before the last counts, the last one resets.
    pub(super) fn omron_counter(&mut self, instr: &Instr) {
        let reset = self.take_bit("CNT", instr.span);
        let count = self.popped();
        let [counter, preset, ..] = &instr.operands[..] else {
            return self.missing_preset("CNT", "001 #0003", instr.span);
        };
        let Some(count) = count else {
            let needs = (
                "what it counts, and then what resets it, each after an LD",
                "o que contar e depois o que o zera, cada um depois de um LD",
            );
            let name = self.spelled(counter);
            return self.found.tell(
                Code::ParameterMissing,
                instr.whole,
                [name.into(), needs.into()],
            );
        };
        let up = self.as_bit(count, ACCUMULATOR, instr.span);
        let preset = self.preset(preset, 1);
        self.acc = Acc::Empty;
        match self.place(counter) {
            Place::Counter(counter) if up.is_some() && preset.is_some() => {
                self.names.counters[counter].kind = Some(Opcode::CountUp);
                let inputs = Inputs {
                    up,
                    reset,
                    preset,
                    ..Inputs::default()
                };
                self.count(counter, inputs, instr.whole);
            }
            Place::Counter(_) | Place::Unknown => {}
            _ => self.not_callable(counter),
        }
    }

    fn missing_preset(&mut self, word: &str, example: &'static str, span: Span) {
        self.found
            .tell(Code::OperandMissing, span, [word.into(), example.into()]);
    }

    fn start_block(
        &mut self,
        place: Place,
        block: &Operand,
        expr: Expr,
        preset: Preset,
        span: Span,
    ) {
        match place {
            Place::Timer(timer) => {
                let kind = self.names.timers[timer].kind.unwrap_or(Opcode::OnDelay);
                let acc = std::mem::replace(&mut self.acc, Acc::Empty);
                self.start_timer(timer, kind, expr, preset, span);
                self.acc = settled(acc);
            }
            Place::Counter(counter) => {
                self.names.counters[counter].kind = Some(Opcode::CountUp);
                let inputs = Inputs {
                    up: Some(expr),
                    preset: Some(preset),
                    ..Inputs::default()
                };
                let acc = std::mem::replace(&mut self.acc, Acc::Empty);
                self.count(counter, inputs, span);
                self.acc = settled(acc);
            }
            Place::Unknown => {}
            _ => self.not_callable(block),
        }
    }

    /// A result that the next instruction uses too is worked out before anything changes what it reads.
    fn needed_again(&mut self, expr: Expr, next: Option<&Stmt>, span: Span) -> Expr {
        let input = matches!(
            expr,
            Expr::Lit {
                bit: Bit::At(Address::Input(_)),
                ..
            }
        );
        if next.is_none() || loads(next) || input {
            return expr;
        }
        self.freeze(span);
        self.fixed_bit(expr, span)
    }

    /// PLS, PLF, DIFU, DIFD: the operand is 1 for the scan in which the accumulator has changed.
    pub(super) fn differentiate(&mut self, instr: &Instr, opcode: Opcode, next: Option<&Stmt>) {
        let word = self.names.written(instr.span);
        let Some(expr) = self.take_bit(&word, instr.span) else {
            return;
        };
        let Some(operand) = instr.operands.first() else {
            return self.missing("ST", instr.span);
        };
        self.only(instr, 1);
        let expr = self.needed_again(expr, next, instr.whole);
        self.acc = Acc::Bit(expr.clone());
        self.edge(instr, opcode);
        let acc = std::mem::replace(&mut self.acc, Acc::Empty);
        self.store_to(acc, operand, false, instr.whole);
        self.acc = settled(Acc::Bit(expr));
    }

    /// The edge of what has been loaded.
    pub(super) fn edge_of_operand(&mut self, instr: &Instr, edge: Opcode) {
        let unused = self.unused;
        self.edge(instr, edge);
        self.unused = unused;
    }

    /// `ANDP X1`, `ORF X2`: an operation with the edge of its operand.
    pub(super) fn operate_edge(&mut self, instr: &Instr, edge: Opcode, left: Acc) {
        let span = instr.whole;
        self.freeze(span);
        let left = self.fixed(left, span);
        let Some(operand) = instr.operands.first() else {
            return;
        };
        self.acc = self.value(operand);
        self.edge(instr, edge);
        let right = std::mem::replace(&mut self.acc, Acc::Unknown);
        self.acc = self.apply(instr.op, false, right, left, span);
        self.link(span);
    }
}

/// What is left of a result after what has used it.
fn settled(acc: Acc) -> Acc {
    match acc {
        Acc::Bit(expr) if expr.is_first() => Acc::Empty,
        acc => acc,
    }
}

/// The number of a timer of Mitsubishi's.
fn fx_number(timer: &Operand) -> Option<u32> {
    let name = timer.name().unwrap_or_default();
    name.trim_start_matches(|c: char| !c.is_ascii_digit())
        .parse()
        .ok()
}

/// Whether it keeps its elapsed time until RST.
fn is_fx_retentive(timer: &Operand) -> bool {
    matches!(fx_number(timer), Some(246..=255))
}

/// ms that a step of it is.
fn fx_step(timer: &Operand) -> i32 {
    match fx_number(timer) {
        Some(200..=245) => 10,
        Some(246..=249) => 1,
        _ => STEP,
    }
}
