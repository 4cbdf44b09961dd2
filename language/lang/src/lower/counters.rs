//! Counters: CTU, CTD, CTUD, as an operator or by CAL.

use super::stack::more_inputs;
use super::timers::{Preset, given, lit};
use super::{ACCUMULATOR, Acc, Lower};
use crate::ast::{Instr, Operand, Param};
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::operators::Op;
use crate::rung::{Holds, Written};
use crate::tree::{Bit, Expr, Num, Number};
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// What no preset is: none is given here.
const UNSAID: i32 = -1;
/// No parameter has this place.
const NOWHERE: usize = usize::MAX;

/// The inputs of a counter.
#[derive(Default)]
pub(super) struct Inputs {
    pub up: Option<Expr>,
    pub down: Option<Expr>,
    pub reset: Option<Expr>,
    pub load: Option<Expr>,
    pub preset: Option<Preset>,
}

impl Lower<'_, '_> {
    /// `CTU C2, 20` as the S7-200 has it, count and reset on its stack; `CTU C2, %IX2, 20` as the norm's
    /// prose has it: the counter, the contact of its reset, its preset. The accumulator is the count.
    pub(super) fn count_operator(&mut self, instr: &Instr) {
        let span = instr.whole;
        let word = match instr.op {
            Op::CountUp => "CTU",
            Op::CountDown => "CTD",
            _ => "CTUD",
        };
        let acc = self.take_acc(word, instr.span);
        let top = self.as_bit(acc, ACCUMULATOR, instr.span);
        let Some(operand) = instr.operands.first() else {
            return self.missing(word, instr.span);
        };
        self.only(instr, 3);
        let Some(counter) = self.counter_place(operand) else {
            return;
        };
        let preset = instr.operands.last().filter(|_| instr.operands.len() > 1);
        let preset = match preset {
            Some(operand) => self.preset(operand, 1),
            None => self.declared_count(counter, span),
        };
        let mut inputs = Inputs {
            preset,
            ..Inputs::default()
        };
        let mut below = Vec::new();
        for _ in 0..more_inputs(instr.op, instr, self.names.dialect) {
            if let Some(acc) = self.popped() {
                below.push(self.as_bit(acc, ACCUMULATOR, instr.span));
            }
        }
        let control = match instr.operands.get(1) {
            Some(operand) if instr.operands.len() == 3 => {
                let acc = self.value(operand);
                self.as_bit(acc, ACCUMULATOR, operand.span)
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
        let down = instr.op == Op::CountDown;
        self.names.counters[counter].kind = Some(if down {
            Opcode::CountDown
        } else {
            Opcode::CountUp
        });
        self.count(counter, inputs, span);
        let number = self.names.counters[counter].number;
        let q = if down {
            Bit::At(Address::AtZero(number))
        } else {
            Bit::At(Address::Reached(number))
        };
        self.acc = match (by_norm, self.rungs.holds == Holds::Bit(q)) {
            (false, _) => Acc::Empty,
            (true, true) => Acc::Bit(Expr::Live),
            (true, false) => lit(q, span),
        };
    }

    fn counter_place(&mut self, operand: &Operand) -> Option<usize> {
        match self.place(operand) {
            Place::Counter(counter) => Some(counter),
            Place::Unknown => None,
            _ => {
                self.not_callable(operand);
                None
            }
        }
    }

    pub(super) fn declared_count(&mut self, counter: usize, span: Span) -> Option<Preset> {
        let counter = &self.names.counters[counter];
        let (name, preset) = (counter.name.clone(), counter.preset);
        self.declared(&name, preset, ["PV", "P"], span)
    }

    /// Writes a counter: it counts, then it is loaded, then it is reset, as the norm has it.
    pub(super) fn count(&mut self, counter: usize, mut inputs: Inputs, span: Span) {
        let number = self.names.counters[counter].number;
        self.writes = true;
        self.freeze(span);
        if let Some(Preset::Unsaid) = inputs.preset {
            self.note_preset(number, UNSAID);
        }
        if let Some(Preset::Constant(preset)) = inputs.preset {
            self.note_preset(number, preset);
            if self.again.presets(number) {
                let preset = Number::Leaf(Num::Const(preset), span);
                inputs.preset = Some(Preset::Number(preset));
            }
        }
        // What is asked of the counter itself is asked before it counts.
        let own = |bit: Bit| {
            bit == Bit::At(Address::Reached(number)) || bit == Bit::At(Address::AtZero(number))
        };
        let later = [&inputs.down, &inputs.load, &inputs.reset];
        let asks =
            |expr: &&Option<Expr>| expr.as_ref().is_some_and(|e| e.is_first() || e.reads(&own));
        let asked = later.iter().any(asks);
        if asked || matches!(inputs.preset, Some(Preset::Number(_))) {
            // What needs the accumulator as it stands comes first.
            for live in [true, false] {
                let first = [
                    &mut inputs.up,
                    &mut inputs.down,
                    &mut inputs.load,
                    &mut inputs.reset,
                ];
                for expr in first.into_iter().flatten().filter(|e| e.is_first() == live) {
                    if live || expr.reads(&own) {
                        *expr = self.fixed_bit(expr.clone(), span);
                    }
                }
            }
        }
        let preset = match inputs.preset {
            Some(Preset::Constant(preset)) => preset,
            Some(Preset::Number(value)) => {
                self.rungs.fresh(span);
                self.rungs.number(&value);
                self.write(Opcode::PresetCounter, number, span);
                self.names.counters[counter].preset.unwrap_or(0)
            }
            Some(Preset::Unsaid) | None => self.names.counters[counter].preset.unwrap_or(0),
        };
        for (expr, opcode, bit) in [
            (
                inputs.up,
                Opcode::CountUp,
                Bit::At(Address::Reached(number)),
            ),
            (
                inputs.down,
                Opcode::CountDown,
                Bit::At(Address::AtZero(number)),
            ),
        ] {
            if let Some(expr) = expr {
                self.rungs.logic(expr, span);
                self.rungs
                    .write(Written::Count(opcode, number, preset), span);
                self.rungs.holds = Holds::Bit(bit);
            }
        }
        for (expr, opcode) in [
            (inputs.load, Opcode::LoadCounter),
            (inputs.reset, Opcode::ResetCounter),
        ] {
            if let Some(expr) = expr {
                self.rungs.logic(expr, span);
                self.write(opcode, number, span);
            }
        }
        self.links = 0;
    }

    /// `CAL C1 (CU:=%IX1, R:=%IX2, PV:=20, Q=>%QX1)`
    pub(super) fn call_counter(&mut self, counter: usize, params: &[Param], span: Span) {
        let name = self.names.counters[counter].name.clone();
        let kind = match self.names.counters[counter].kind {
            Some(kind) => kind,
            None if self.has(counter, params, "CD") && !self.has(counter, params, "CU") => {
                Opcode::CountDown
            }
            None => Opcode::CountUp,
        };
        self.names.counters[counter].kind = Some(kind);
        let order = if kind == Opcode::CountDown {
            ["CD", "LD", "PV"]
        } else {
            ["CU", "R", "PV"]
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
        let place = Place::Counter(counter);
        for (input, wired) in [
            (&mut inputs.up, "CU"),
            (&mut inputs.down, "CD"),
            (&mut inputs.reset, "R"),
            (&mut inputs.load, "LD"),
        ] {
            if input.is_none() && !given(params, wired, NOWHERE) {
                *input = self.wired(place, &name, wired, span);
            }
        }
        let counts = given(params, "CU", 0) || given(params, "CD", 0);
        if !counts && inputs.up.is_none() && inputs.down.is_none() {
            let needs = ("what it counts, CU", "o que contar, CU");
            self.found.tell(
                Code::ParameterMissing,
                span,
                [name.clone().into(), needs.into()],
            );
        }
        if !given(params, "PV", 2) {
            inputs.preset = self.declared_count(counter, span);
        }
        if inputs.preset.is_none() {
            return;
        }
        self.count(counter, inputs, span);
        let number = self.names.counters[counter].number;
        for param in params.iter().filter(|param| param.out) {
            let acc = match param.name.as_ref().map(|name| name.text.as_str()) {
                Some("Q") if kind == Opcode::CountDown => {
                    lit(Bit::At(Address::AtZero(number)), span)
                }
                Some("Q" | "QU") => lit(Bit::At(Address::Reached(number)), span),
                Some("QD") => lit(Bit::At(Address::AtZero(number)), span),
                Some("CV") => Acc::Number(Number::Leaf(Num::At(Address::Count(number)), span)),
                _ => {
                    self.no_parameter(
                        &name,
                        param,
                        ("it gives Q, QU, QD and CV", "dá Q, QU, QD e CV"),
                    );
                    continue;
                }
            };
            self.store_to(acc, &param.value, param.negated, param.value.span);
        }
    }

    /// Whether a call gives a counter this input, or the text stores to it.
    fn has(&self, counter: usize, params: &[Param], input: &str) -> bool {
        let name = &self.names.counters[counter].name;
        given(params, input, NOWHERE) || self.names.stores(name, input)
    }
}
