//! Functions, blocks, timers, counters and edges.

use super::super::super::ast::{Arg, Instruction, Line, NodeKind};
use super::super::Checker;
use super::walk::{Walk, accumulated};
use crate::diagnostics::{Code, Span};
use crate::list::{Acc, Accumulator, Edges, Flow, Machine, declare_edge, named};
use crate::operators::Op;
use crate::typed::build::{Argument, Section, Target};
use crate::typed::{Expr, Stmt, StmtKind, UnitKind};

impl Walk<'_, '_, '_, '_> {
    /// Whether a call by a function's name takes the accumulator as its first input: where one operand is lacking.
    pub(super) fn takes_accumulator(&self, one: &Instruction) -> bool {
        if one.given.is_some() {
            return false;
        }
        match self.own_function(one) {
            Some(unit) => {
                let takes = |draft: &crate::typed::build::Draft| {
                    let inputs = draft.params.iter();
                    inputs.filter(|one| one.section != Section::Output).count()
                };
                let inputs = self.c.builder.draft(unit).map_or(0, takes);
                one.operands.len() + 1 == inputs
            }
            None => true,
        }
    }

    /// `LIMIT(MN := 0, IN := x, MX := 10)`, a standard function without the accumulator.
    pub(super) fn formal(&mut self, one: &Instruction, name: &str) {
        self.warn_unused();
        let given = self.c.arguments(one.given.as_deref().unwrap_or_default());
        let expr = self.c.builder.function(name, given, one.span);
        self.run.load(Some(expr));
        self.run.links = 1;
        self.run.unused = Some(one.span);
    }

    /// A function of the text.
    pub(super) fn own_call(&mut self, unit: u32, one: &Instruction) {
        let mut given = Vec::new();
        if self.takes_accumulator(one) {
            let Some(expr) = self.take(&one.word.text, one.word.span) else {
                self.c.arguments(&one.operands);
                return;
            };
            given.push(accumulated(expr));
        } else {
            self.warn_unused();
        }
        given.extend(self.c.arguments(&one.operands));
        given.extend(self.c.arguments(one.given.as_deref().unwrap_or_default()));
        self.function(unit, given, one.word.span, one.span);
    }

    fn function(&mut self, unit: u32, given: Vec<Argument>, name: Span, at: Span) {
        if given.iter().any(|argument| argument.out) || self.lends(unit) {
            self.before_call(&given);
        }
        let expr = self.c.builder.call(unit, given, name, at);
        self.run.load(Some(expr));
        // What it may change is changed here, and once.
        self.settle();
        if self.needed() {
            self.run.unused = Some(at);
        }
    }

    /// Whether a function may change what is its caller's.
    fn lends(&self, unit: u32) -> bool {
        let draft = self.c.builder.draft(unit);
        draft.is_some_and(|draft| draft.params.iter().any(|p| p.section == Section::InOut))
    }

    /// CAL, CALC, CALCN.
    pub(super) fn cal(&mut self, one: &Instruction) {
        let Some(Arg { node, .. }) = one.operands.first() else {
            let words = ["CAL".into(), "CAL T1 (IN := I1)".into()];
            return self.tell(Code::OperandMissing, one.word.span, words);
        };
        let mut given: Vec<&Arg> = one.operands.iter().skip(1).collect();
        given.extend(one.given.iter().flatten());
        let (path, more) = match &node.kind {
            NodeKind::Path(path) => (path, &[][..]),
            // `CAL T1 (IN := a)` is read as a call with its value.
            NodeKind::Call(path, more) => (path, more.as_slice()),
            _ => {
                let written = self.c.builder.written(node.span);
                return self.tell(Code::Unexpected, node.span, [written.into()]);
            }
        };
        given.extend(more);
        let conditional = one.spelling.is_some_and(|spelling| spelling.conditional);
        let name = &path.name;
        let function = path
            .parts
            .is_empty()
            .then(|| self.function_named(&name.text))
            .flatten();
        if let Some(unit) = function
            && !conditional
        {
            self.warn_unused();
            let given = self.all(&given);
            return self.function(unit, given, name.span, one.span);
        }
        let condition = match conditional {
            true => self.condition(&one.word.text, one.jump()),
            false => {
                self.warn_unused();
                None
            }
        };
        if let Some(unit) = function {
            let given = self.all(&given);
            self.before_call(&given);
            let statement = self
                .c
                .builder
                .call_statement(unit, given, name.span, one.span);
            if let (Some(condition), Some(statement)) = (condition, statement) {
                self.conditional(condition, vec![statement], one.span);
            }
        } else {
            let known = self.c.builder.find(&name.text).is_some();
            if !known && !self.c.builder.is_hidden(&name.text) {
                self.c.builder.callee(&name.text, name.span);
                self.run.acc = Acc::Wrong;
                return;
            }
            let Some(target) = self.c.target(path) else {
                self.run.acc = Acc::Wrong;
                return;
            };
            let given = self.all(&given);
            self.before_call(&given);
            let body = self.c.builder.block(target, given, one.span);
            match (conditional, condition) {
                (true, Some(condition)) => self.conditional(condition, body, one.span),
                (true, None) => {}
                (false, _) => body.into_iter().for_each(|one| self.push(one)),
            }
        }
        self.run.acc = Acc::Empty;
    }

    /// `T1 (IN := I1)` without CAL.
    pub(super) fn cal_named(&mut self, one: &Instruction) {
        self.warn_unused();
        let target = self.c.builder.name(&one.word.text, one.word.span);
        let given = self.c.arguments(one.given.as_deref().unwrap_or_default());
        if let Some(target) = target {
            self.call_block(target, given, one.span);
        }
        self.run.acc = Acc::Empty;
    }

    fn function_named(&self, name: &str) -> Option<u32> {
        match self.c.builder.find(name) {
            Some(crate::typed::build::Named::Unit(unit)) => {
                let kind = self.c.builder.draft(*unit)?.unit.kind;
                (kind == UnitKind::Function).then_some(*unit)
            }
            _ => None,
        }
    }

    fn all(&mut self, given: &[&Arg]) -> Vec<Argument> {
        let mut all = Vec::new();
        for arg in given {
            all.extend(self.c.arguments(std::slice::from_ref(*arg)));
        }
        all
    }

    fn call_block(&mut self, target: Target, given: Vec<Argument>, at: Span) {
        self.before_call(&given);
        let body = self.c.builder.block(target, given, at);
        body.into_iter().for_each(|one| self.push(one));
    }

    /// Statements that are done where the condition holds.
    fn conditional(&mut self, condition: Expr, body: Vec<Stmt>, at: Span) {
        let kind = StmtKind::If(vec![(condition, body)], Vec::new());
        self.push(Stmt { kind, at });
    }

    /// The instance that an operator names.
    fn instance(&mut self, one: &Instruction) -> Option<Target> {
        let arg = one.operands.first()?;
        match &arg.node.kind {
            NodeKind::Path(path) => self.c.target(path),
            _ => {
                let written = self.c.builder.written(arg.node.span);
                self.tell(
                    Code::NotCallable,
                    arg.node.span,
                    [written.into(), "CAL".into()],
                );
                None
            }
        }
    }

    /// `TON T1, T#5s` and `CTU C1, reset, 20`, on the accumulator, which becomes Q.
    pub(super) fn timer_or_counter(&mut self, one: &Instruction) {
        let op = one.spelling.map(|spelling| spelling.op);
        let expr = self.take(&one.word.text, one.word.span);
        let target = self.instance(one);
        let (Some(expr), Some(target)) = (expr, target) else {
            self.run.acc = Acc::Wrong;
            return;
        };
        let names: [&str; 3] = match op {
            Some(Op::CountUp) => ["CU", "R", "PV"],
            Some(Op::CountDown) => ["CD", "LD", "PV"],
            _ => ["IN", "PT", ""],
        };
        let timer = matches!(op, Some(Op::Timer(_)));
        let mut given = vec![named(names[0], expr)];
        for (name, arg) in names[1..].iter().zip(one.operands.iter().skip(1)) {
            let value = match timer {
                true => self.preset_value(arg),
                false => self.c.expr(&arg.node, None),
            };
            given.push(named(name, value));
        }
        self.call_for(target, given, "Q", one.span);
    }

    /// `CLK rise`, `CU count`, `IN T1`: the block is called with the accumulator as this input.
    pub(super) fn input(&mut self, one: &Instruction) {
        self.give(one, &one.word.text.to_uppercase());
    }

    /// Calls a block with the accumulator as one of its inputs.
    pub(super) fn give(&mut self, one: &Instruction, input: &str) {
        let expr = self.take(&one.word.text, one.word.span);
        let target = self.instance(one);
        let (Some(expr), Some(target)) = (expr, target) else {
            self.run.acc = Acc::Wrong;
            return;
        };
        self.call_block(target, vec![named(input, expr)], one.span);
        self.run.acc = Acc::Empty;
    }

    /// `PT T1`, `PV C1`
    pub(super) fn preset(&mut self, one: &Instruction) {
        let expr = self.peek(&one.word.text, one.word.span);
        let target = self.instance(one);
        let (Some(expr), Some(target)) = (expr, target) else {
            return;
        };
        let member = self.c.builder.member(target, &one.word.text, one.span);
        let statement = member.and_then(|to| self.c.builder.assign(to, expr, one.span));
        let needed = self.needed();
        statement.into_iter().for_each(|one| self.does(one, needed));
    }

    /// Calls an instance, and loads one of its outputs.
    fn call_for(&mut self, target: Target, given: Vec<Argument>, output: &str, at: Span) {
        self.call_block(target.clone(), given, at);
        let output = self.c.builder.member(target, output, at);
        let held = self.c.builder.read(output, at);
        self.run.load(Some(held));
    }

    /// Whether a bit has risen or fallen since this was asked last.
    pub(super) fn edge(&mut self, expr: Expr, at: Span) -> Expr {
        let expr = self.edge_of(expr, at);
        expr.unwrap_or_else(|| self.c.builder.wrong(at))
    }

    /// EU, ED
    pub(super) fn edge_of_accumulator(&mut self, one: &Instruction) {
        let Some(expr) = self.take(&one.word.text, one.word.span) else {
            return;
        };
        self.run.acc = Acc::Empty;
        let held = self.edge(expr, one.span);
        self.run.load(Some(held));
        self.run.unused = Some(one.span);
    }

    /// PLS, PLF
    pub(super) fn differentiate(&mut self, one: &Instruction) {
        if self.needed() {
            self.settle_costly();
        }
        let Some(expr) = self.peek(&one.word.text, one.word.span) else {
            return;
        };
        let changed = self.edge(expr, one.span);
        let Some(target) = self.instance(one) else {
            return;
        };
        let statement = self.c.builder.assign(target, changed, one.span);
        let needed = self.needed();
        statement.into_iter().for_each(|one| self.does(one, needed));
    }
}

impl Checker<'_, '_, '_> {
    /// The instances that edges without one of their own need, before the unit's declarations are closed.
    pub(in super::super) fn declare_edges(&mut self, lines: &[Line], kind: UnitKind) {
        if kind == UnitKind::Function {
            return;
        }
        for line in lines {
            let Line::Does(one) = line else { continue };
            let spelling = one.spelling;
            let edge = spelling.and_then(|spelling| match spelling.op {
                Op::Edge(edge) | Op::Differentiate(edge) => Some(edge),
                _ => spelling.edge,
            });
            let Some(edge) = edge else { continue };
            let more = one.operands.iter().skip(1).map(|arg| arg.node.span);
            for at in std::iter::once(one.span).chain(more) {
                if !declare_edge(&mut self.builder, edge, at) {
                    return;
                }
            }
        }
    }
}
