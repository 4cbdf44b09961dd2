//! Counters: CTU, CTD, CTUD, as an operator or by CAL.

use super::calls::is_given;
use super::edges::named;
use super::operands::Is;
use super::run::Acc;
use super::said::ACCUMULATOR;
use super::stack::pops;
use super::timers::Preset;
use super::walk::Walk;
use crate::ast::{Instr, Operand, Param};
use crate::names::Place;
use crate::operators::Op;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::Target;
use unoclp_tree::{Expr, Standard};

/// The inputs of a counter.
#[derive(Default)]
pub(super) struct Inputs {
    pub up: Option<Expr>,
    pub down: Option<Expr>,
    pub reset: Option<Expr>,
    pub load: Option<Expr>,
    pub preset: Option<Preset>,
}

impl Walk<'_, '_, '_> {
    /// `CTU C2, 20` as the S7-200 has it, count and reset on its stack; `CTU C2, %IX2, 20` as the standard's prose has it: the
    /// counter, the contact of its reset, its preset. The accumulator is the count.
    pub(super) fn count_operator(&mut self, instr: &Instr) {
        let span = instr.whole;
        let word = match instr.op {
            Op::CountUp => "CTU",
            Op::CountDown => "CTD",
            _ => "CTUD",
        };
        let expr = self.take(word, instr.span);
        let top = expr.and_then(|expr| self.as_bit(expr, ACCUMULATOR, instr.span));
        let Some(operand) = instr.operands.first() else {
            return self.missing(word, instr.span);
        };
        self.only(instr, 3);
        let Some((target, block)) = self.counter_place(operand) else {
            return;
        };
        let preset = instr.operands.last().filter(|_| instr.operands.len() > 1);
        let preset = match preset {
            Some(operand) => self.preset(operand, 1),
            None => Some(self.declared_count(operand, span)),
        };
        let mut inputs = Inputs {
            preset,
            ..Inputs::default()
        };
        let mut below = Vec::new();
        for _ in 0..pops(instr, self.front.names.dialect) {
            match self.run.popped() {
                Some(Acc::Value(expr)) => {
                    below.push(self.as_bit(expr, ACCUMULATOR, instr.span));
                }
                Some(_) => below.push(None),
                None => {}
            }
        }
        let control = match instr.operands.get(1) {
            Some(operand) if instr.operands.len() == 3 => {
                let value = self.value(operand);
                value.and_then(|value| self.as_bit(value, ACCUMULATOR, operand.span))
            }
            _ => None,
        };
        // The S7-200 keeps its accumulator, where the standard's becomes Q.
        let by_norm = below.is_empty();
        let (count, control) = match (below.len(), instr.op) {
            (0, _) => (top, control),
            (1, Op::CountUpDown) => {
                inputs.down = below.pop().flatten();
                (None, top)
            }
            (1, _) => (below.pop().flatten(), top),
            _ => {
                let up = below.pop().flatten();
                inputs.down = below.pop().flatten();
                (up, top)
            }
        };
        match instr.op {
            Op::CountDown => (inputs.down, inputs.load) = (count, control),
            _ => (inputs.up, inputs.reset) = (count, control),
        }
        let complete = inputs.up.is_some() || inputs.down.is_some();
        if !complete || inputs.preset.is_none() {
            return;
        }
        let down = instr.op == Op::CountDown;
        let kind = if down {
            Opcode::CountDown
        } else {
            Opcode::CountUp
        };
        self.note_kind(operand, kind);
        self.count(operand, &target, inputs, span);
        match by_norm {
            true => {
                let q = if down { "QD" } else { "QU" };
                self.load_part(target, block, q, span);
            }
            false => self.run.acc = Acc::Empty,
        }
    }

    pub(super) fn counter_place(&mut self, operand: &Operand) -> Option<(Target, Standard)> {
        match self.meaning(operand) {
            Is::Block(target, block) if block.is_counter() => Some((target, block)),
            Is::Wrong => None,
            _ => {
                self.not_callable(operand);
                None
            }
        }
    }

    /// The preset that a counter's declaration says.
    pub(super) fn preset_of_counter(&mut self, operand: &Operand) -> Option<i32> {
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        match self.front.names.place(operand, instance, found) {
            Place::Counter(counter) => self.front.names.counters.get(counter)?.preset,
            _ => None,
        }
    }

    pub(super) fn declared_count(&mut self, operand: &Operand, span: Span) -> Preset {
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        match self.front.names.place(operand, instance, found) {
            Place::Counter(counter) => {
                let counter = &self.front.names.counters[counter];
                let (name, preset) = (counter.name.clone(), counter.preset);
                self.declared_number(&name, preset, ["PV", "P"], span)
            }
            _ => Preset::Unsaid,
        }
    }

    fn kind_of(&mut self, operand: &Operand) -> Option<Opcode> {
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        match self.front.names.place(operand, instance, found) {
            Place::Counter(counter) => self.front.names.counters.get(counter)?.kind,
            _ => None,
        }
    }

    /// Which way a counter counts, from here on.
    pub(super) fn note_kind(&mut self, operand: &Operand, kind: Opcode) {
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        if let Place::Counter(counter) = self.front.names.place(operand, instance, found)
            && let Some(counter) = self.front.names.counters.get_mut(counter)
        {
            counter.kind = Some(kind);
        }
    }

    /// Counts, then loads, then resets, as the standard has it.
    pub(super) fn count(&mut self, operand: &Operand, target: &Target, inputs: Inputs, span: Span) {
        self.front.writes = true;
        let mut all = Vec::new();
        for (name, input) in [("CU", inputs.up), ("CD", inputs.down)] {
            all.extend(input.map(|input| named(name, input)));
        }
        let written = self.spelled(operand);
        for (names, input) in [
            (["R", "RESET"], inputs.reset),
            (["LD", "LOAD"], inputs.load),
        ] {
            // What one call gives is that call's alone; what the text stores stays.
            let stored = names
                .iter()
                .any(|name| self.front.names.stores(&written, name));
            let input = match input {
                Some(input) => Some(input),
                None if stored => None,
                None => Some(self.truth(false, span)),
            };
            all.extend(input.map(|input| named(names[0], input)));
        }
        if let Some(Preset::Given(preset)) = inputs.preset {
            all.push(named("PV", preset));
        }
        self.run_block(target, all, span);
        self.run.links = 0;
    }

    /// `CAL C1 (CU:=%IX1, R:=%IX2, PV:=20, Q=>%QX1)`
    pub(super) fn call_counter(
        &mut self,
        operand: &Operand,
        target: Target,
        block: Standard,
        params: &[Param],
        span: Span,
    ) {
        let name = self.spelled(operand);
        let has = |this: &Self, input: &str| {
            is_given(params, input, usize::MAX) || this.front.names.stores(&name, input)
        };
        let down = has(self, "CD") && !has(self, "CU");
        let kind = match self.kind_of(operand) {
            Some(kind) => kind,
            None if down => Opcode::CountDown,
            None => Opcode::CountUp,
        };
        self.note_kind(operand, kind);
        let order = match kind {
            Opcode::CountDown => ["CD", "LD", "PV"],
            _ => ["CU", "R", "PV"],
        };
        let mut inputs = Inputs::default();
        for (index, param) in params.iter().enumerate().filter(|(_, param)| !param.out) {
            let called = param.name.as_ref().map(|name| name.text.as_str());
            match called.or(order.get(index).copied()) {
                Some("CU") => inputs.up = self.param_bit(param),
                Some("CD") => inputs.down = self.param_bit(param),
                Some("R" | "RESET") => inputs.reset = self.param_bit(param),
                Some("LD" | "LOAD") => inputs.load = self.param_bit(param),
                Some("PV") => inputs.preset = self.preset(&param.value, 1),
                _ => {
                    let has = (
                        "its inputs are CU, CD, R, LD and PV, its outputs Q, QU, QD and CV",
                        "as entradas são CU, CD, R, LD e PV; as saídas, Q, QU, QD e CV",
                    );
                    self.no_parameter(&name, param, has);
                }
            }
        }
        let stores = |this: &Self, part: &[&str]| {
            part.iter().any(|part| this.front.names.stores(&name, part))
        };
        let counts = is_given(params, "CU", 0) || is_given(params, "CD", 0);
        if !counts && !stores(self, &["CU"]) && !stores(self, &["CD"]) {
            let needs = (
                "a value for CU, its count input",
                "um valor em CU, a entrada de contagem",
            );
            let words = [name.as_str().into(), needs.into()];
            self.tell(Code::ParameterMissing, span, words);
            return;
        }
        if !is_given(params, "PV", 2) {
            inputs.preset = Some(self.declared_count(operand, span));
        }
        if inputs.preset.is_none() {
            return;
        }
        self.count(operand, &target, inputs, span);
        for param in params.iter().filter(|param| param.out) {
            let output = match param.name.as_ref().map(|name| name.text.as_str()) {
                Some("Q") if kind == Opcode::CountDown => Some("QD"),
                Some(output @ ("Q" | "QU" | "QD" | "CV")) => super::first::part(block, output),
                _ => {
                    let has = (
                        "its outputs are Q, QU, QD and CV",
                        "as saídas são Q, QU, QD e CV",
                    );
                    self.no_parameter(&name, param, has);
                    continue;
                }
            };
            let output = output.and_then(|output| self.part_of(target.clone(), block, output));
            if let Some(output) = output {
                let value = self.read(output, span);
                self.store_value(value, &param.value, param.negated);
            }
        }
    }
}
