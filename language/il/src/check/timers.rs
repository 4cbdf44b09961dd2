//! Timers: TON, TOF, TP, as an operator or by CAL.

use super::calls::is_given;
use super::edges::named;
use super::operands::Is;
use super::run::Acc;
use super::said::{ACCUMULATOR, constant};
use super::walk::Walk;
use crate::ast::{Instr, Operand, Param};
use crate::names::Place;
use crate::words::operator;
use unoclp_core::isa::Opcode;
use unoclp_text::Dialect;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::Target;
use unoclp_tree::{Base, Expr, Root, Standard, TypeId};

/// The preset of a timer or counter.
#[derive(Clone, Debug)]
pub(super) enum Preset {
    Given(Expr),
    /// Nothing says it here: 0, or what has been stored in it.
    Unsaid,
}

impl Walk<'_, '_, '_> {
    /// `TON T1, 100` on the accumulator.
    pub(super) fn timer_operator(&mut self, instr: &Instr, opcode: Opcode) {
        let word = operator(opcode);
        let span = instr.whole;
        let expr = self.take(word, instr.span);
        let input = expr.and_then(|expr| self.as_bit(expr, ACCUMULATOR, instr.span));
        let Some(operand) = instr.operands.first() else {
            return self.missing(word, instr.span);
        };
        self.only(instr, 2);
        let Some((target, block)) = self.timer_place(operand) else {
            return;
        };
        let preset = match instr.operands.get(1) {
            Some(preset) => {
                let base = self.time_base(operand, opcode);
                self.preset(preset, base)
            }
            None => self.declared_preset(operand, span),
        };
        let (Some(input), Some(preset)) = (input, preset) else {
            return;
        };
        // On an S7-200 the accumulator stays what it is; by the standard it becomes Q.
        if self.front.names.dialect != Dialect::S7200 {
            self.start_timer(operand, &target, Some(input), preset, span);
            return self.load_part(target, block, "Q", span);
        }
        let input = match self.needed() {
            true => self.aside(input),
            false => input,
        };
        self.start_timer(operand, &target, Some(input.clone()), preset, span);
        self.run.links = 0;
        self.hold(Some(input));
    }

    /// Loads an output of a block.
    pub(super) fn load_part(&mut self, target: Target, block: Standard, part: &str, at: Span) {
        let output = self.part_of(target, block, part);
        let held = output.map(|output| self.read(output, at));
        self.run.links = 0;
        self.hold(held);
    }

    fn timer_place(&mut self, operand: &Operand) -> Option<(Target, Standard)> {
        match self.meaning(operand) {
            Is::Block(target, block) if block.is_timer() => Some((target, block)),
            Is::Wrong => None,
            _ => {
                self.not_callable(operand);
                None
            }
        }
    }

    /// The timer of an operand, as `names` has it.
    fn timer_of(&mut self, operand: &Operand) -> Option<usize> {
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        match self.front.names.place(operand, instance, found) {
            Place::Timer(timer) => Some(timer),
            _ => None,
        }
    }

    /// ms that one step of a preset is. On an S7-200 the timer's number says it.
    fn time_base(&mut self, operand: &Operand, opcode: Opcode) -> i32 {
        if self.front.names.dialect != Dialect::S7200 {
            return 1;
        }
        let Some(timer) = self.timer_of(operand) else {
            return 1;
        };
        let name = self.front.names.timers[timer].name.clone();
        let number = name.strip_prefix(['T', 't']);
        let Some(number) = number.and_then(|n| n.parse::<u32>().ok()) else {
            return 1;
        };
        let retentive = number < 32 || (64..96).contains(&number);
        if retentive && opcode != Opcode::RetentiveOnDelay {
            self.tell(Code::RetentiveNumber, operand.span, [name.into()]);
        }
        match number {
            0 | 64 | 32 | 96 => 1,
            1..=4 | 65..=68 | 33..=36 | 97..=100 => 10,
            _ => 100,
        }
    }

    /// A preset in steps of so many ms; a time, such as T#1s, is one whatever the steps.
    pub(super) fn preset(&mut self, operand: &Operand, base: i32) -> Option<Preset> {
        let expr = self.value(operand)?;
        let number = self.as_number(expr, "PT", operand.span)?;
        let Some(constant) = constant(&number) else {
            return Some(Preset::Given(number));
        };
        match constant.checked_mul(base).filter(|&preset| preset >= 0) {
            Some(preset) => {
                let preset = self.whole(preset, operand.span);
                Some(Preset::Given(preset))
            }
            None => {
                let text = self.spelled(operand);
                let range = ("from 0 to 2147483647 ms", "de 0 a 2147483647 ms");
                self.tell(Code::BadValue, operand.span, [text.into(), range.into()]);
                None
            }
        }
    }

    /// The preset that a timer's declaration says.
    pub(super) fn preset_of_timer(&mut self, operand: &Operand) -> Option<i32> {
        let timer = self.timer_of(operand)?;
        self.front.names.timers.get(timer)?.preset
    }

    pub(super) fn declared_preset(&mut self, operand: &Operand, span: Span) -> Option<Preset> {
        let Some(timer) = self.timer_of(operand) else {
            return Some(Preset::Unsaid);
        };
        let timer = &self.front.names.timers[timer];
        let (name, preset) = (timer.name.clone(), timer.preset);
        Some(self.declared_number(&name, preset, ["PT", "P"], span))
    }

    /// The preset of a declaration. Where there is none, and the text stores to none of these parts of the block, it is
    /// 0, which is told.
    pub(super) fn declared_number(
        &mut self,
        name: &str,
        preset: Option<i32>,
        parts: [&str; 2],
        span: Span,
    ) -> Preset {
        let stored = parts.iter().any(|part| self.front.names.stores(name, part));
        if preset.is_none() && !stored {
            let [given, declared] = match parts {
                ["PT", _] => ["PT:=T#20s", "TON := T#20s"],
                _ => ["PV:=20", "CTU := 20"],
            };
            let words = [name.into(), given.into(), declared.into()];
            self.tell(Code::PresetZero, span, words);
        }
        match preset {
            Some(preset) if !stored => Preset::Given(self.whole(preset, span)),
            _ => Preset::Unsaid,
        }
    }

    /// Starts a timer; it has one place in the program.
    pub(super) fn start_timer(
        &mut self,
        operand: &Operand,
        target: &Target,
        input: Option<Expr>,
        preset: Preset,
        span: Span,
    ) {
        let timer = self.timer_of(operand);
        if let Some(timer) = timer {
            let called = &mut self.front.names.timers[timer].called;
            called.get_or_insert_with(Vec::new);
        }
        let unit = (target.place.root != Root::Static).then_some(self.unit);
        let name = match timer {
            Some(timer) => self.front.names.timers[timer].name.clone(),
            None => self.spelled(operand),
        };
        let first = &mut self.front.timers[self.unit];
        first.get_or_insert_with(|| name.clone());
        if !self.front.timed.insert((unit, target.place.offset)) {
            self.tell(Code::TimerTwice, span, [name.into()]);
        }
        let mut all: Vec<_> = input.map(|input| named("IN", input)).into_iter().collect();
        if let Preset::Given(preset) = preset {
            let preset = self.fit(preset, TypeId::of(Base::Time), Base::Time);
            all.push(named("PT", preset));
        }
        self.run_block(target, all, span);
        self.run.links = 0;
    }

    /// `CAL T1 (IN:=%IX1, PT:=T#20s, Q=>%QX1)`
    pub(super) fn call_timer(
        &mut self,
        operand: &Operand,
        target: Target,
        block: Standard,
        params: &[Param],
        span: Span,
    ) {
        let timer = self.timer_of(operand);
        let name = match timer {
            Some(timer) => self.front.names.timers[timer].name.clone(),
            None => self.spelled(operand),
        };
        let (mut input, mut preset) = (None, None);
        let mut is_stored = false;
        for (index, param) in params.iter().enumerate().filter(|(_, param)| !param.out) {
            let called = param.name.as_ref().map(|name| name.text.as_str());
            match called.or(["IN", "PT"].get(index).copied()) {
                Some("IN") => input = self.param_bit(param),
                Some("PT") => preset = self.preset(&param.value, 1),
                _ => self.no_parameter(
                    &name,
                    param,
                    (
                        "its inputs are IN and PT, its outputs Q and ET",
                        "as entradas são IN e PT; as saídas, Q e ET",
                    ),
                ),
            }
        }
        if !is_given(params, "IN", 0) {
            is_stored = self.front.names.stores(&name, "IN");
            if !is_stored {
                let needs = ("a value for its input IN", "um valor na entrada IN");
                let words = [name.as_str().into(), needs.into()];
                self.tell(Code::ParameterMissing, span, words);
            }
        }
        if !is_given(params, "PT", 1) {
            preset = self.declared_preset(operand, span);
        }
        let Some(preset) = preset.filter(|_| is_stored || input.is_some()) else {
            return;
        };
        self.start_timer(operand, &target, input, preset, span);
        for param in params.iter().filter(|param| param.out) {
            let output = match param.name.as_ref().map(|name| name.text.as_str()) {
                Some(output @ ("Q" | "ET")) => output,
                _ => {
                    self.no_parameter(
                        &name,
                        param,
                        ("its outputs are Q and ET", "as saídas são Q e ET"),
                    );
                    continue;
                }
            };
            if let Some(output) = self.part_of(target.clone(), block, output) {
                let value = self.read(output, span);
                self.store_value(value, &param.value, param.negated);
            }
        }
        self.run.acc = Acc::Empty;
    }
}
