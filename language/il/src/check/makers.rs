//! What the makers write in their own ways: `OUT T0 K50`, `TIM 000 #0050`, PLS. The accumulator stays what it was where
//! the standard's would become the result.

use super::counters::Inputs;
use super::operands::Is;
use super::run::{Acc, Changes};
use super::said::ACCUMULATOR;
use super::timers::Preset;
use super::walk::Walk;
use crate::ast::{Instr, Operand};
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Expr, ExprKind};

/// ms that a step of a maker's usual timer is.
const STEP: i32 = 100;

impl Walk<'_, '_, '_> {
    /// `OUT T0 K50`, `OUT C1 K3`.
    pub(super) fn out_block_of(&mut self, instr: &Instr, expr: Expr) {
        let [block, preset] = &instr.operands[..] else {
            return;
        };
        let base = match self.meaning(block) {
            Is::Block(_, standard) if standard.is_timer() => fx_step(block),
            _ => 1,
        };
        let preset = self.preset(preset, base);
        let bit = self.as_bit(expr, ACCUMULATOR, instr.span);
        let (Some(mut bit), Some(preset)) = (bit, preset) else {
            return;
        };
        if instr.negated {
            bit = self.front.c.builder.not(bit, instr.whole);
        }
        self.start_block(block, bit, preset, instr.whole);
    }

    /// `TIM 000 #0050`: steps of 100 ms.
    pub(super) fn omron_timer(&mut self, instr: &Instr) {
        let bit = self.take_bit("TIM", instr.span);
        let [timer, preset, ..] = &instr.operands[..] else {
            return self.missing_preset("TIM", "000 #0050", instr.span);
        };
        let preset = self.preset(preset, STEP);
        let (Some(bit), Some(preset)) = (bit, preset) else {
            return;
        };
        self.start_block(timer, bit, preset, instr.whole);
    }

    /// `CNT 001 #0003`: the result before the last counts, the last one resets.
    pub(super) fn omron_counter(&mut self, instr: &Instr) {
        let reset = self.take_bit("CNT", instr.span);
        let count = self.run.popped();
        let [counter, preset, ..] = &instr.operands[..] else {
            return self.missing_preset("CNT", "001 #0003", instr.span);
        };
        let Some(count) = count else {
            let needs = (
                "a count input and then a reset input, each loaded with LD",
                "uma entrada de contagem e depois uma de reset, cada uma carregada com LD",
            );
            let name = self.spelled(counter);
            let words = [name.into(), needs.into()];
            return self.tell(Code::ParameterMissing, instr.whole, words);
        };
        let up = match count {
            Acc::Value(count) => self.as_bit(count, ACCUMULATOR, instr.span),
            _ => None,
        };
        let preset = self.preset(preset, 1);
        self.run.acc = Acc::Empty;
        let Some((target, _)) = self.counter_place(counter) else {
            return;
        };
        if up.is_none() || preset.is_none() {
            return;
        }
        let inputs = Inputs {
            up,
            reset,
            preset,
            ..Inputs::default()
        };
        self.note_kind(counter, Opcode::CountUp);
        self.count(counter, &target, inputs, instr.whole);
    }

    fn missing_preset(&mut self, word: &str, example: &'static str, span: Span) {
        self.tell(Code::OperandMissing, span, [word.into(), example.into()]);
    }

    /// Starts a timer or counts; the accumulator stays.
    fn start_block(&mut self, block: &Operand, bit: Expr, preset: Preset, span: Span) {
        let bit = self.kept_for_later(bit);
        match self.meaning(block) {
            Is::Block(target, standard) if standard.is_timer() => {
                self.start_timer(block, &target, Some(bit.clone()), preset, span);
            }
            Is::Block(target, standard) if standard.is_counter() => {
                let inputs = Inputs {
                    up: Some(bit.clone()),
                    preset: Some(preset),
                    ..Inputs::default()
                };
                self.note_kind(block, Opcode::CountUp);
                self.count(block, &target, inputs, span);
            }
            Is::Wrong => {}
            _ => self.not_callable(block),
        }
        self.run.links = 0;
        self.hold(Some(bit));
    }

    /// A result that the next instruction uses too, as it is now.
    fn kept_for_later(&mut self, bit: Expr) -> Expr {
        let simple = matches!(bit.kind, ExprKind::Read(_));
        let stays = simple && !self.may_read(&bit, &Changes::Anything);
        match self.needed() && !stays {
            true => self.aside(bit),
            false => bit,
        }
    }

    /// PLS, PLF, DIFU, DIFD: the operand is 1 for the scan in which the accumulator has changed.
    pub(super) fn differentiate(&mut self, instr: &Instr) {
        let word = self.front.names.written(instr.span);
        let Some(mut bit) = self.take_bit(&word, instr.span) else {
            return;
        };
        let Some(operand) = instr.operands.first() else {
            return self.missing("ST", instr.span);
        };
        self.only(instr, 1);
        bit = self.kept_for_later(bit);
        if let Some(changed) = self.edge_of(bit.clone(), instr.span) {
            self.store_value(changed, operand, false);
        }
        self.run.links = 0;
        self.hold(Some(bit));
    }
}

/// ms that a step of a timer of Mitsubishi's is, by its number.
fn fx_step(timer: &Operand) -> i32 {
    let name = timer.name().unwrap_or_default();
    let number = name.trim_start_matches(|c: char| !c.is_ascii_digit());
    match number.parse::<u32>() {
        Ok(200..=245) => 10,
        Ok(246..=249) => 1,
        _ => STEP,
    }
}
