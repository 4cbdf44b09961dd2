//! CAL and what it may call; functions as operators; first values.

use super::again::Edge;
use super::timers::lit;
use super::units::is_input;
use super::{Acc, Lower};
use crate::ast::{Instr, Operand, Param, Section};
use crate::diagnostics::{Code, Span};
use crate::names::{Initial, Place};
use crate::tree::{Bit, Expr, Num, Number};
use unoclp_core::Target;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

impl Lower<'_, '_> {
    /// CAL, CALC, CALCN.
    pub(super) fn call(&mut self, instr: &Instr) {
        let Some(operand) = instr.operands.first() else {
            return self.missing("CAL", instr.span);
        };
        let mut params = instr.params.clone();
        params.extend(instr.operands.iter().skip(1).map(positional));
        let span = instr.whole;
        let mut skip = None;
        if instr.conditional {
            let Some(condition) = self.take_condition("CALC", instr.span) else {
                return;
            };
            let behind = self.new_label(span, None);
            self.freeze(span);
            self.jump_if(condition, instr.negated, behind, span);
            skip = Some(behind);
        }
        self.unused = None;
        self.call_operand(operand, &params, span);
        if let Some(behind) = skip {
            self.place_label(behind, span);
            self.acc = Acc::Empty;
        }
    }

    fn call_operand(&mut self, operand: &Operand, params: &[Param], span: Span) {
        let function = operand
            .name()
            .and_then(|name| self.functions.get(name))
            .copied();
        if let Some(unit) = function {
            let instance = self.function_instance(unit);
            return self.call_unit(unit, instance, params, span);
        }
        match self.callable(operand) {
            Place::Timer(timer) => self.call_timer(timer, params, span),
            Place::Counter(counter) => self.call_counter(counter, params, span),
            Place::Trigger(opcode, marker) => {
                let name = self.spelled(operand);
                self.call_trigger(opcode, marker, &name, params, span);
            }
            place @ Place::Latch(..) => {
                let name = self.spelled(operand);
                self.call_latch(place, &name, params, span);
            }
            Place::Instance(instance) => {
                let unit = self.names.instances[instance].unit;
                return self.call_unit(unit, instance, params, span);
            }
            Place::Unknown => {}
            _ => self.not_callable(operand),
        }
        self.acc = Acc::Empty;
    }

    /// What is called. A name that nothing declares is no marker here.
    fn callable(&mut self, operand: &Operand) -> Place {
        match operand.name() {
            Some(name) if !self.names.knows(name, self.instance()) && !name.contains('%') => {
                self.not_callable(operand);
                Place::Unknown
            }
            _ => self.place(operand),
        }
    }

    pub(super) fn not_callable(&mut self, operand: &Operand) {
        let name = self.spelled(operand);
        let help = self.names.callable_help(&name);
        self.found
            .tell(Code::NotCallable, operand.span, [name.into(), help]);
    }

    /// R_TRIG, F_TRIG: its Q is 1 for one scan.
    fn call_trigger(
        &mut self,
        opcode: Opcode,
        marker: u8,
        name: &str,
        params: &[Param],
        span: Span,
    ) {
        let block = match opcode {
            Opcode::RisingEdge => "R_TRIG",
            _ => "F_TRIG",
        };
        let has = ("it has CLK, and gives Q", "tem CLK, e dá Q");
        let mut clock = None;
        for (index, param) in params.iter().enumerate() {
            match param.name.as_ref().map(|name| name.text.as_str()) {
                Some("CLK") if !param.out => clock = Some(param),
                None if index == 0 => clock = Some(param),
                Some("Q") if param.out => {}
                _ => self.no_parameter(block, param, has),
            }
        }
        let place = Place::Trigger(opcode, marker);
        let expr = match clock {
            Some(clock) => self.param_bit(clock).map(Some),
            None => Some(self.wired(place, name, "CLK", span)),
        };
        let Some(expr) = expr else { return };
        let Some(expr) = expr else {
            let needs = ("its input, CLK", "sua entrada, CLK");
            return self
                .found
                .tell(Code::ParameterMissing, span, [block.into(), needs.into()]);
        };
        self.run_trigger(opcode, marker, expr, span);
        for param in params.iter().filter(|param| param.out) {
            let acc = lit(Bit::At(Address::Marker(marker)), span);
            self.store_to(acc, &param.value, param.negated, param.value.span);
        }
    }

    /// R_TRIG or F_TRIG on an expression: its Q holds what has changed.
    pub(super) fn run_trigger(&mut self, opcode: Opcode, marker: u8, expr: Expr, span: Span) {
        self.rise_or_fall(Edge::Trigger(marker), opcode, expr, span);
        let Some(changed) = self.take_bit("CLK", span) else {
            return;
        };
        self.rungs.logic(changed, span);
        self.rungs.coil(Target::Marker(marker), false, span);
    }

    /// `LIMIT a, b`: a function as an operator. One operand less than it has inputs, and the accumulator is the
    /// first.
    pub(super) fn function(&mut self, instr: &Instr) {
        let name = instr.span;
        let function = instr
            .function
            .as_ref()
            .and_then(|name| self.functions.get(name));
        let Some(&unit) = function else { return };
        let inputs = self.units[unit]
            .vars
            .iter()
            .filter(|var| is_input(var))
            .count();
        let mut params = instr.params.clone();
        params.extend(instr.operands.iter().map(positional));
        let instance = self.function_instance(unit);
        let first = self.units[unit].vars.iter().find(|var| is_input(var));
        let copied = first.is_some_and(|var| var.section == Section::Input);
        if params.len() + 1 == inputs && copied {
            let acc = self.take_acc("CAL", name);
            if let Some(var) = first {
                let place = self.names.instances[instance]
                    .names
                    .get(&var.name.text)
                    .copied();
                let width = self.names.width_of(instance, &var.name.text);
                self.assign(acc, place.unwrap_or(Place::Unknown), width, name);
            }
            return self.call_inputs(unit, instance, &params, 1, name);
        }
        self.unused = None;
        self.call_unit(unit, instance, &params, instr.whole);
    }

    /// Gives variables the values that they begin with, in the first scan; those that are kept only where nothing
    /// has been kept yet. A register that is kept with them tells that.
    pub(super) fn initials(&mut self) {
        let first = |span| Expr::Lit {
            bit: Bit::At(Address::System(1)),
            negated: false,
            span,
        };
        let initials = std::mem::take(&mut self.names.initials);
        self.begin_with(initials, first);
        let Some((begun, span)) = self.names.retained.begun else {
            return;
        };
        let number = |num, span| Box::new(Number::Leaf(num, span));
        let never = |span: Span| Expr::Compare {
            op: Opcode::Equal,
            left: number(Num::At(Address::Register(begun)), span.empty()),
            right: number(Num::Const(0), span.empty()),
            span: span.empty(),
        };
        let mut initials = std::mem::take(&mut self.names.retained.initials);
        initials.push(Initial {
            place: Place::Number(Num::At(Address::Register(begun))),
            value: 1,
            span,
        });
        self.begin_with(initials, never);
    }

    /// Gives variables their values where this holds.
    fn begin_with(&mut self, initials: Vec<Initial>, when: impl Fn(Span) -> Expr) {
        for initial in initials {
            let span = initial.span;
            self.rungs.logic(when(span), span);
            match initial.place {
                Place::Bit(Bit::At(Address::Output(n))) => self.write(Opcode::SetCoil, n, span),
                Place::Bit(Bit::At(Address::Marker(n))) if initial.value == 0 => {
                    self.write(Opcode::ResetMarker, n, span);
                }
                Place::Bit(Bit::At(Address::Marker(n))) => self.write(Opcode::SetMarker, n, span),
                Place::Number(num) => {
                    let value = Number::Leaf(Num::Const(initial.value), span);
                    self.rungs.number(&value);
                    let written = self.stored_in(num);
                    self.rungs.write(written, span);
                }
                _ => {}
            }
        }
    }
}

/// A parameter without a name.
fn positional(operand: &Operand) -> Param {
    Param {
        name: None,
        out: false,
        negated: false,
        value: operand.clone(),
    }
}
