//! CAL and what it may call.

use super::edges::named;
use super::operands::Is;
use super::run::{Acc, Changes};
use super::said::{ACCUMULATOR, BOOL, NUMBER, Words, constant};
use super::walk::Walk;
use crate::ast::{Instr, Operand, Param};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Argument, Target};
use unoclp_tree::{Base, Expr, Standard, Stmt, StmtKind};

impl<'a> Walk<'_, 'a, '_> {
    /// CAL, CALC, CALCN.
    pub(super) fn call(&mut self, instr: &'a Instr) {
        let Some(operand) = instr.operands.first() else {
            return self.missing("CAL", instr.span);
        };
        let mut params = instr.params.clone();
        params.extend(instr.operands.iter().skip(1).map(positional));
        let span = instr.whole;
        if !instr.conditional {
            self.run.unused = None;
            return self.call_operand(operand, &params, span);
        }
        let Some(expr) = self.take("CALC", instr.span) else {
            return;
        };
        let Some(mut condition) = self.tested(expr, instr.span) else {
            return;
        };
        if instr.negated {
            condition = self.front.c.builder.not(condition, instr.span);
        }
        // What waits is put aside on both ways.
        self.before(&Changes::Anything, false);
        self.run.made.push(Vec::new());
        self.call_operand(operand, &params, span);
        let body = self.run.made.pop().unwrap_or_default();
        let kind = StmtKind::If(vec![(condition, body)], Vec::new());
        self.push(Stmt { kind, at: span });
        self.run.acc = Acc::Empty;
    }

    fn call_operand(&mut self, operand: &Operand, params: &[Param], span: Span) {
        let function = operand.name();
        let function = function.and_then(|name| self.front.functions.get(name));
        if let Some(&unit) = function {
            return self.call_function(unit, params, None, operand.span, span);
        }
        match self.callable(operand) {
            Is::Block(target, block) if block.is_timer() => {
                self.call_timer(operand, target, block, params, span);
            }
            Is::Block(target, block) if block.is_edge() => {
                self.call_trigger(operand, target, block, params, span);
            }
            Is::Block(target, block @ (Standard::Sr | Standard::Rs)) => {
                self.call_latch(operand, target, block, params, span);
            }
            Is::Block(target, block) => self.call_counter(operand, target, block, params, span),
            Is::Instance(target) => self.call_instance(target, params, span),
            Is::Wrong => {}
            _ => self.not_callable(operand),
        }
        self.run.acc = Acc::Empty;
    }

    /// What is called. A name that nothing declares is no marker here.
    pub(super) fn callable(&mut self, operand: &Operand) -> Is {
        let instance = Some(self.instance);
        match operand.name() {
            Some(name)
                if !self.front.names.knows(name, instance)
                    && self.front.c.builder.find(name).is_none()
                    && !name.contains('%') =>
            {
                self.not_callable(operand);
                Is::Wrong
            }
            _ => self.meaning(operand),
        }
    }

    pub(super) fn not_callable(&mut self, operand: &Operand) {
        let name = self.spelled(operand);
        let help = self.front.names.callable_help(&name);
        self.tell(Code::NotCallable, operand.span, [name.into(), help]);
    }

    /// R_TRIG, F_TRIG: its Q is 1 for one scan.
    fn call_trigger(
        &mut self,
        operand: &Operand,
        target: Target,
        block: Standard,
        params: &[Param],
        span: Span,
    ) {
        let has = (
            "its input is CLK, its output Q",
            "a entrada é CLK; a saída, Q",
        );
        let mut clock = None;
        for (index, param) in params.iter().enumerate() {
            match param.name.as_ref().map(|name| name.text.as_str()) {
                Some("CLK") if !param.out => clock = Some(param),
                None if index == 0 => clock = Some(param),
                Some("Q") if param.out => {}
                _ => self.no_parameter(block.name(), param, has),
            }
        }
        let name = self.spelled(operand);
        let clock = match clock {
            Some(clock) => match self.param_bit(clock) {
                Some(bit) => vec![named("CLK", bit)],
                None => return,
            },
            None if self.front.names.stores(&name, "CLK") => Vec::new(),
            None => {
                let needs = ("a value for its input CLK", "um valor na entrada CLK");
                let words = [block.name().into(), needs.into()];
                return self.tell(Code::ParameterMissing, span, words);
            }
        };
        self.run_block(&target, clock, span);
        for param in params.iter().filter(|param| param.out) {
            if let Some(q) = self.part_of(target.clone(), block, "Q") {
                let q = self.read(q, span);
                self.store_value(q, &param.value, param.negated);
            }
        }
    }

    /// Calls a block of the standard with these inputs.
    pub(super) fn run_block(&mut self, target: &Target, given: Vec<Argument>, span: Span) {
        let body = self.front.c.builder.block(target.clone(), given, span);
        let cells = self.front.c.builder.tree.types.get(target.ty).cells;
        self.before(&Changes::Cells(&target.place, cells), false);
        body.into_iter().for_each(|one| self.push(one));
    }

    pub(super) fn no_parameter(&mut self, block: &str, param: &Param, has: Words) {
        let (text, span) = match &param.name {
            Some(name) => (self.front.names.written(name.span), name.span),
            None => (self.spelled(&param.value), param.value.span),
        };
        let words = [block.into(), text.into(), has.into()];
        self.tell(Code::NoSuchParameter, span, words);
    }

    /// A parameter that is a bit.
    pub(super) fn param_bit(&mut self, param: &Param) -> Option<Expr> {
        let expr = self.value(&param.value)?;
        let at = param.value.span;
        if expr.base != Base::Bool && !matches!(constant(&expr), Some(0..=1)) {
            let text = self.spelled(&param.value).into();
            self.wrong_type(text, at, NUMBER, BOOL);
            return None;
        }
        let bit = self.as_bit(expr, ACCUMULATOR, at)?;
        Some(match param.negated {
            true => self.front.c.builder.not(bit, at),
            false => bit,
        })
    }
}

/// A parameter without a name.
pub(super) fn positional(operand: &Operand) -> Param {
    Param {
        name: None,
        out: false,
        negated: false,
        value: operand.clone(),
    }
}

/// Whether a parameter is given, by its name or by its place.
pub(super) fn is_given(params: &[Param], wanted: &str, place: usize) -> bool {
    params
        .iter()
        .enumerate()
        .any(|(index, param)| match &param.name {
            Some(name) => !param.out && name.text == wanted,
            None => index == place,
        })
}
