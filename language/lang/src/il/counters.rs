//! Counters: CTU, CTD, CTUD, as an operator or by CAL.

use super::calls::is_given;
use super::edges::given;
use super::operands::{ACCUMULATOR, Is};
use super::stack::more_inputs;
use super::timers::Preset;
use super::walk::{Acc, Walk};
use crate::ast::{Instr, Operand, Param};
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::operators::Op;
use crate::typed::build::Target;
use crate::typed::{Base, Expr, Standard, TypeId};

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
    /// `CTU C2, 20` as the S7-200 has it, count and reset on its stack; `CTU C2, %IX2, 20` as the norm's prose has it: the
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
        for _ in 0..more_inputs(instr.op, instr, self.front.names.dialect) {
            match self.popped() {
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
        // The S7-200 keeps its accumulator, where the norm's becomes Q.
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
        self.count(&target, block, inputs, span);
        match by_norm {
            true => {
                let q = if block == Standard::Ctud { "QU" } else { "Q" };
                self.load_part(target, block, q, span);
            }
            false => self.acc = Acc::Empty,
        }
    }

    pub(super) fn counter_place(&mut self, operand: &Operand) -> Option<(Target, Standard)> {
        match self.meaning(operand) {
            Is::Block(target, block) if block.part("PV").is_some() => Some((target, block)),
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
        let found = &mut *self.front.builder.found;
        match self.front.names.place(operand, instance, found) {
            Place::Counter(counter) => self.front.names.counters.get(counter)?.preset,
            _ => None,
        }
    }

    pub(super) fn declared_count(&mut self, operand: &Operand, span: Span) -> Preset {
        let instance = Some(self.instance);
        let found = &mut *self.front.builder.found;
        match self.front.names.place(operand, instance, found) {
            Place::Counter(counter) => {
                let counter = &self.front.names.counters[counter];
                let (name, preset) = (counter.name.clone(), counter.preset);
                self.declared_number(&name, preset, ["PV", "P"], span)
            }
            _ => Preset::Unsaid,
        }
    }

    /// Counts, then loads, then resets, as the norm has it.
    pub(super) fn count(&mut self, target: &Target, block: Standard, inputs: Inputs, span: Span) {
        let mut all = Vec::new();
        for (name, input) in [
            ("CU", inputs.up),
            ("CD", inputs.down),
            ("R", inputs.reset),
            ("LD", inputs.load),
        ] {
            match (input, block.part(name)) {
                (Some(input), Some(_)) => all.push(given(name, input)),
                (Some(_), None) => return self.not_yet(span),
                (None, _) => {}
            }
        }
        if let Some(Preset::Given(preset)) = inputs.preset {
            let preset = self.fit(preset, TypeId::of(Base::Int), Base::Int);
            all.push(given("PV", preset));
        }
        self.run_block(target, all, span);
        self.links = 0;
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
        let order = match block {
            Standard::Ctd => ["CD", "LD", "PV"],
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
                        "it has CU, CD, R, LD and PV, and gives Q, QU, QD and CV",
                        "tem CU, CD, R, LD e PV, e dá Q, QU, QD e CV",
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
            let needs = ("what it counts, CU", "o que contar, CU");
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
        self.count(&target, block, inputs, span);
        for param in params.iter().filter(|param| param.out) {
            let output = match param.name.as_ref().map(|name| name.text.as_str()) {
                Some(output @ ("Q" | "QU" | "QD" | "CV")) => super::first::part(block, output),
                _ => {
                    let has = ("it gives Q, QU, QD and CV", "dá Q, QU, QD e CV");
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
