//! Timers: TON, TOF, TP, TONR, as an operator or by CAL.

use super::{ACCUMULATOR, Acc, Lower, NUMBER, loads};
use crate::Dialect;
use crate::ast::{Instr, Operand, Param, Stmt};
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::rung::Holds;
use crate::tree::{Bit, Expr, Num, Number};
use crate::words::operator;
use unoclp_core::isa::Opcode;

/// The preset of a timer.
pub(super) enum Preset {
    Constant(i32),
    /// From a variable, in each scan.
    Number(Number),
    /// Nothing says it here: 0, or what has been stored in it.
    Unsaid,
}

impl Lower<'_, '_> {
    /// `TON T1, 100` on the accumulator.
    pub(super) fn timer_operator(&mut self, instr: &Instr, opcode: Opcode, next: Option<&Stmt>) {
        let word = operator(opcode);
        let span = instr.whole;
        let acc = self.take_acc(word, instr.span);
        let input = self.as_bit(acc, ACCUMULATOR, instr.span);
        let Some(operand) = instr.operands.first() else {
            return self.missing(word, instr.span);
        };
        self.only(instr, 2);
        let Some(timer) = self.timer_place(operand) else {
            return;
        };
        let preset = match instr.operands.get(1) {
            Some(preset) => {
                let base = self.time_base(timer, opcode, operand);
                self.preset(preset, base)
            }
            None => self.declared_preset(timer, span),
        };
        let (Some(mut input), Some(preset)) = (input, preset) else {
            return;
        };
        // On an S7-200 the accumulator stays what it is; by the norm it becomes Q.
        let keeps = self.names.dialect == Dialect::S7200;
        if keeps && !loads(next) && next.is_some() && input.is_first() {
            self.freeze(span);
            input = self.fixed_bit(input, span);
        }
        let kept = input.clone();
        self.start_timer(timer, opcode, input, preset, span);
        self.acc = match keeps {
            true if kept.is_first() => Acc::Empty,
            true => Acc::Bit(kept),
            false => Acc::Bit(Expr::Live),
        };
    }

    fn timer_place(&mut self, operand: &Operand) -> Option<usize> {
        match self.place(operand) {
            Place::Timer(timer) => Some(timer),
            Place::Unknown => None,
            _ => {
                self.not_callable(operand);
                None
            }
        }
    }

    /// ms that one step of a preset is. On an S7-200 the timer's number says it.
    fn time_base(&mut self, timer: usize, opcode: Opcode, operand: &Operand) -> i32 {
        if self.names.dialect != Dialect::S7200 {
            return 1;
        }
        let name = self.names.timers[timer].name.clone();
        let Some(number) = name
            .strip_prefix(['T', 't'])
            .and_then(|n| n.parse::<u32>().ok())
        else {
            return 1;
        };
        let retentive = number < 32 || (64..96).contains(&number);
        if retentive && opcode != Opcode::RetentiveOnDelay {
            self.found
                .tell(Code::RetentiveNumber, operand.span, [name.into()]);
        }
        match number {
            0 | 64 | 32 | 96 => 1,
            1..=4 | 65..=68 | 33..=36 | 97..=100 => 10,
            _ => 100,
        }
    }

    /// A preset in steps of so many ms; a time, such as T#1s, is one whatever the steps.
    pub(super) fn preset(&mut self, operand: &Operand, base: i32) -> Option<Preset> {
        let acc = self.value(operand);
        let number = self.as_number(acc, "PT", operand.span)?;
        let Some(constant) = number.constant() else {
            return Some(Preset::Number(number));
        };
        match constant.checked_mul(base).filter(|&preset| preset >= 0) {
            Some(preset) => Some(Preset::Constant(preset)),
            None => {
                let text = self.spelled(operand);
                let range = ("from 0 to 2147483647 ms", "de 0 a 2147483647 ms");
                self.found
                    .tell(Code::BadValue, operand.span, [text.into(), range.into()]);
                None
            }
        }
    }

    pub(super) fn declared_preset(&mut self, timer: usize, span: Span) -> Option<Preset> {
        let timer = &self.names.timers[timer];
        let (name, preset) = (timer.name.clone(), timer.preset);
        self.declared(&name, preset, ["PT", "P"], span)
    }

    /// The preset of a declaration. Where there is none, and the text stores to none of these parts of the block, it is
    /// 0, which is told.
    pub(super) fn declared(
        &mut self,
        name: &str,
        preset: Option<i32>,
        parts: [&str; 2],
        span: Span,
    ) -> Option<Preset> {
        if let Some(preset) = preset {
            return Some(Preset::Constant(preset));
        }
        if !parts.iter().any(|part| self.names.stores(name, part)) {
            let [given, declared] = match parts {
                ["PT", _] => ["PT:=T#20s", "TON := T#20s"],
                _ => ["PV:=20", "CTU := 20"],
            };
            let words = [name.into(), given.into(), declared.into()];
            self.found.tell(Code::PresetZero, span, words);
        }
        Some(Preset::Unsaid)
    }

    /// Writes a timer block; the board's accumulator is its Q then.
    pub(super) fn start_timer(
        &mut self,
        timer: usize,
        opcode: Opcode,
        input: Expr,
        preset: Preset,
        span: Span,
    ) {
        let path = self.call_path(span);
        let entry = &mut self.names.timers[timer];
        entry.kind = Some(opcode);
        match &entry.called {
            None => entry.called = Some(path),
            Some(first) => {
                // What is called again is the timer, or the block that it stands in.
                let other = first.iter().zip(&path).find(|(one, other)| one != other);
                let place = other.map_or(span, |(_, other)| *other);
                let name = entry.name.clone();
                self.found.tell(Code::TimerTwice, place, [name.into()]);
            }
        }
        let first = self.names.timers[timer].preset.unwrap_or(0);
        self.freeze(span);
        let (input, preset) = match preset {
            Preset::Constant(preset) => (input, preset),
            Preset::Unsaid => (input, first),
            Preset::Number(number) => {
                let input = if input.is_first() {
                    self.fixed_bit(input, span)
                } else {
                    input
                };
                self.rungs.fresh(span);
                self.rungs.number(&number);
                // The block comes next, so its number is known.
                let block = self.rungs.timers.saturating_add(1);
                self.write(Opcode::PresetTimer, block, span);
                (input, first)
            }
        };
        self.rungs.logic(input, span);
        self.rungs.timer(opcode, timer, preset, span);
        self.links = 0;
    }

    /// `CAL T1 (IN:=%IX1, PT:=T#20s, Q=>%QX1)`
    pub(super) fn call_timer(&mut self, timer: usize, params: &[Param], span: Span) {
        let opcode = self.names.timers[timer].kind.unwrap_or(Opcode::OnDelay);
        let name = self.names.timers[timer].name.clone();
        let (mut input, mut preset) = (None, None);
        for (index, param) in params.iter().enumerate().filter(|(_, param)| !param.out) {
            match param
                .name
                .as_ref()
                .map_or(["IN", "PT"].get(index).copied(), |name| Some(&name.text))
            {
                Some("IN") => input = self.param_bit(param),
                Some("PT") => preset = self.preset(&param.value, 1),
                _ => self.no_parameter(
                    &name,
                    param,
                    (
                        "it has IN and PT, and gives Q and ET",
                        "tem IN e PT, e dá Q e ET",
                    ),
                ),
            }
        }
        if !given(params, "IN", 0) {
            input = self.wired(Place::Timer(timer), &name, "IN", span);
        }
        if !given(params, "IN", 0) && input.is_none() {
            let needs = ("its input, IN", "sua entrada, IN");
            self.found.tell(
                Code::ParameterMissing,
                span,
                [name.clone().into(), needs.into()],
            );
        }
        if !given(params, "PT", 1) {
            preset = self.declared_preset(timer, span);
        }
        let (Some(input), Some(preset)) = (input, preset) else {
            return;
        };
        self.start_timer(timer, opcode, input, preset, span);
        for param in params.iter().filter(|param| param.out) {
            let member = param.name.as_ref().map_or("", |name| name.text.as_str());
            let acc = match member {
                "Q" if self.rungs.holds == Holds::Bit(Bit::Timer(timer)) => Acc::Bit(Expr::Live),
                "Q" => lit(Bit::Timer(timer), span),
                "ET" => Acc::Number(Number::Leaf(Num::Elapsed(timer), span)),
                _ => {
                    self.no_parameter(&name, param, ("it gives Q and ET", "dá Q e ET"));
                    continue;
                }
            };
            self.store_to(acc, &param.value, param.negated, param.value.span);
        }
    }

    pub(super) fn no_parameter(&mut self, block: &str, param: &Param, has: super::Words) {
        let (text, span) = match &param.name {
            Some(name) => (self.names.written(name.span), name.span),
            None => (self.spelled(&param.value), param.value.span),
        };
        self.found.tell(
            Code::NoSuchParameter,
            span,
            [block.into(), text.into(), has.into()],
        );
    }

    /// A parameter that is a bit.
    pub(super) fn param_bit(&mut self, param: &Param) -> Option<Expr> {
        let acc = self.value(&param.value);
        if let Acc::Number(number) = &acc
            && !matches!(number.constant(), Some(0..=1))
        {
            let text = self.spelled(&param.value);
            self.wrong_type(text, param.value.span, NUMBER, super::BOOL);
            return None;
        }
        let expr = self.as_bit(acc, ACCUMULATOR, param.value.span)?;
        Some(if param.negated { expr.not() } else { expr })
    }
}

/// Whether a parameter is given, by its name or by its place.
pub(super) fn given(params: &[Param], wanted: &str, place: usize) -> bool {
    params
        .iter()
        .enumerate()
        .any(|(index, param)| match &param.name {
            Some(name) => !param.out && name.text == wanted,
            None => index == place,
        })
}

/// A bit in the accumulator.
pub(super) fn lit(bit: Bit, span: Span) -> Acc {
    Acc::Bit(Expr::Lit {
        bit,
        negated: false,
        span,
    })
}
