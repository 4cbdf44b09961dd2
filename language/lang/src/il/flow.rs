//! Labels and jumps, RET, IF.
//!
//! The tree's jumps stand in a unit's body itself. So IF becomes a statement of the tree where a body has no labels, and
//! jumps where it has some.

use super::accumulator::Changes;
use super::said::{ACCUMULATOR, BOOL, NUMBER};
use super::walk::{Acc, Waiting, Walk};
use crate::ast::{Instr, Operand, Stmt, Word};
use crate::diagnostics::{Code, Span};
use crate::jumps::If;
use crate::names::near::nearest;
use crate::operators::Op;
use crate::typed::{Base, Compare, Expr, Stmt as Made, StmtKind};
use std::collections::HashSet;
use unoclp_core::isa::Opcode;

impl Walk<'_, '_, '_> {
    /// The labels that a jump leads to; the others change nothing.
    pub(super) fn find_labels(&mut self) {
        let mut wanted = HashSet::new();
        for stmt in self.body {
            if let Stmt::Instr(instr) = stmt
                && instr.op == Op::Jump
                && let Some(name) = instr.operands.first().and_then(|operand| operand.name())
            {
                wanted.insert(name);
            }
        }
        self.jumps = !wanted.is_empty();
        let mut seen = HashSet::new();
        for (at, stmt) in self.body.iter().enumerate() {
            let Stmt::Label(word) = stmt else { continue };
            if !seen.insert(&word.text) {
                let name = self.front.names.written(word.span);
                self.tell(Code::LabelTwice, word.span, [name.into()]);
            } else if wanted.contains(word.text.as_str()) {
                self.labels.lines.insert(word.text.clone(), at);
            }
        }
    }

    pub(super) fn label(&mut self, word: &Word, at: usize) {
        if self.labels.lines.get(&word.text) != Some(&at) {
            return;
        }
        let name = self.front.names.written(word.span);
        self.not_deferred(&name, word.span);
        self.kept.clear();
        let falls_in = !std::mem::replace(&mut self.unreachable, false);
        let needed = self.needs.get(at).copied().unwrap_or_default();
        match needed {
            true if falls_in => self.carry_to(at, &name, word.span),
            true => {}
            false => self.warn_unused(),
        }
        self.labels.place(at, &self.made);
        self.acc = Acc::Empty;
        if needed {
            self.carried(at, word.span);
        }
        self.links = 0;
    }

    /// Leaves the accumulator where the way from the label on takes it from.
    fn carry_to(&mut self, label: usize, name: &str, span: Span) {
        let Some(mut expr) = self.take(name, span) else {
            return;
        };
        let to = self.labels.carried.get(&label).cloned();
        let base = to
            .as_ref()
            .and_then(|to| self.front.builder.tree.types.base(to.ty));
        if base == Some(Base::Bool)
            && let Some(number @ 0..=1) = super::said::constant(&expr)
        {
            // The constants 0 and 1 are both bit and number.
            expr = self.truth(number == 1, span);
        }
        match (base, expr.base == Base::Bool) {
            (Some(Base::Bool), false) => {
                return self.wrong_type(ACCUMULATOR.into(), span, NUMBER, BOOL);
            }
            (Some(Base::Dint), true) => {
                return self.wrong_type(ACCUMULATOR.into(), span, BOOL, NUMBER);
            }
            _ => {}
        }
        let target = match to {
            Some(target) => target,
            None => {
                let Some(target) = self.own(expr.base, span) else {
                    return;
                };
                self.labels.carried.insert(label, target.clone());
                target
            }
        };
        let statement = self.assigned(&target, expr, span);
        statement.into_iter().for_each(|one| self.push(one));
        let held = self.read(target, span);
        self.hold(Some(held));
        self.links = 0;
    }

    /// The accumulator after a label that needs it. Where no way above leads there, it is taken for a bit.
    fn carried(&mut self, label: usize, span: Span) {
        let target = match self.labels.carried.get(&label).cloned() {
            Some(target) => Some(target),
            None => {
                let made = self.own(Base::Bool, span);
                if let Some(target) = &made {
                    self.labels.carried.insert(label, target.clone());
                }
                made
            }
        };
        let held = target.map(|target| self.read(target, span));
        self.hold(held);
    }

    pub(super) fn jump(&mut self, instr: &Instr) {
        self.not_deferred("JMP", instr.span);
        let Some(operand) = instr.operands.first() else {
            return self.missing("JMP", instr.span);
        };
        self.only(instr, 1);
        let name = operand.name().unwrap_or_default();
        let line = self.labels.lines.get(name).copied();
        if line.is_none() {
            self.no_label(operand);
        }
        if let Some(line) = line
            && self.needs.get(line).copied().unwrap_or_default()
        {
            self.carry_to(line, "JMP", instr.span);
        }
        if instr.conditional {
            let condition = self.condition("JMPC", instr);
            if let (Some(condition), Some(line)) = (condition, line) {
                self.jump_to(Some(condition), line, instr.whole);
            }
            return;
        }
        self.unused = None;
        if let Some(line) = line {
            self.jump_to(None, line, instr.whole);
        }
        self.acc = Acc::Empty;
        self.unreachable = true;
    }

    fn no_label(&mut self, operand: &Operand) {
        let name = self.spelled(operand);
        let labels = self.body.iter().filter_map(|stmt| match stmt {
            Stmt::Label(word) => self.front.names.text.get(word.span.range()),
            _ => None,
        });
        let help = match nearest(&name, labels) {
            Some(near) => (format!("is it `{near}`?"), format!("seria `{near}`?")),
            None => (
                format!("write `{name}:` before the instruction to go on with"),
                format!("escreva `{name}:` antes da instrução em que o programa deve continuar"),
            ),
        };
        let words = [name.into(), help.into()];
        self.tell(Code::NoSuchLabel, operand.span, words);
    }

    fn jump_to(&mut self, condition: Option<Expr>, label: usize, at: Span) {
        self.labels.jumps_to(label, &self.made);
        let kind = StmtKind::Jump(condition, 0);
        self.push(Made { kind, at });
    }

    /// The accumulator as a condition, where a number is true if it is not 0; inverted by N.
    pub(super) fn condition(&mut self, what: &str, instr: &Instr) -> Option<Expr> {
        self.undecided();
        if self.needed() {
            self.settle_costly();
        }
        let acc = self.acc.clone();
        let expr = self.take(what, instr.span)?;
        let condition = self.tested(expr, instr.span)?;
        self.acc = acc;
        Some(match instr.negated {
            true => self.front.builder.not(condition, instr.span),
            false => condition,
        })
    }

    pub(super) fn tested(&mut self, expr: Expr, span: Span) -> Option<Expr> {
        if expr.base == Base::Bool || matches!(super::said::constant(&expr), Some(0..=1)) {
            return self.as_bit(expr, ACCUMULATOR, span);
        }
        let none = self.whole(0, span);
        let builder = &mut self.front.builder;
        Some(builder.compare(Compare::NotEqual, expr, none, span))
    }

    pub(super) fn ret(&mut self, instr: &Instr) {
        self.not_deferred("RET", instr.span);
        self.only(instr, 0);
        let at_whole = instr.whole;
        let statement = Made {
            kind: StmtKind::Return,
            at: at_whole,
        };
        if instr.conditional {
            if let Some(condition) = self.condition("RETC", instr) {
                let kind = StmtKind::If(vec![(condition, vec![statement])], Vec::new());
                self.push(Made { kind, at: at_whole });
            }
            return;
        }
        self.unused = None;
        self.push(statement);
        self.acc = Acc::Empty;
        self.unreachable = true;
    }

    /// END, which needs no code where nothing follows.
    pub(super) fn end(&mut self, instr: &Instr) {
        self.warn_unused();
        self.not_deferred("END", instr.span);
        match self.next() {
            Some(_) => self.ret(instr),
            None => self.only(instr, 0),
        }
    }

    /// Jumps and labels do not stand between parentheses; what LD has pushed is lost there.
    pub(super) fn not_deferred(&mut self, what: &str, span: Span) {
        let deferred = |waiting: &Waiting| matches!(waiting, Waiting::Deferred(..));
        let mut frames = self.frames.iter();
        let open = frames.find(|frame| deferred(&frame.waiting));
        // Told once for each parenthesis.
        if let Some(open) = open.map(|frame| frame.span)
            && self.told_open.replace(open) != Some(open)
        {
            self.tell(Code::InParentheses, span, [what.into()]);
        }
    }

    /// IF, ELSE, END_IF.
    pub(super) fn part(&mut self, instr: &Instr, opcode: Opcode) {
        let word = self.front.names.written(instr.span);
        self.not_deferred(&word, instr.span);
        self.kept.clear();
        match opcode {
            Opcode::If => self.begin_if(instr),
            Opcode::Else => self.begin_else(instr),
            _ => self.end_if(instr),
        }
    }

    fn begin_if(&mut self, instr: &Instr) {
        let Some(expr) = self.take("IF", instr.span) else {
            return;
        };
        let Some(condition) = self.tested(expr, instr.span) else {
            return;
        };
        self.before(&Changes::Anything, false);
        let mut labels = None;
        if self.labels.lines.is_empty() {
            self.made.push(Vec::new());
        } else {
            let (first, end) = self.labels.of_if(self.body.len());
            labels = Some((first, end));
            let not = self.front.builder.not(condition.clone(), instr.span);
            self.jump_to(Some(not), first, instr.span);
        }
        self.ifs.push(If {
            span: instr.span,
            condition: Some(condition),
            first: None,
            labels,
            other: false,
        });
        self.acc = Acc::Empty;
    }

    fn begin_else(&mut self, instr: &Instr) {
        self.warn_unused();
        let open = self.ifs.last_mut().filter(|open| !open.other);
        let Some(open) = open else {
            return self.stray_part(instr);
        };
        open.other = true;
        let labels = open.labels;
        match labels {
            Some((first, end)) => {
                self.jump_to(None, end, instr.span);
                self.labels.place(first, &self.made);
            }
            None => {
                let first = self.made.pop();
                if let Some(open) = self.ifs.last_mut() {
                    open.first = first;
                }
                self.made.push(Vec::new());
            }
        }
        self.acc = Acc::Empty;
    }

    fn end_if(&mut self, instr: &Instr) {
        self.warn_unused();
        let Some(open) = self.ifs.pop() else {
            return self.stray_part(instr);
        };
        self.acc = Acc::Empty;
        if let Some((first, end)) = open.labels {
            let label = if open.other { end } else { first };
            return self.labels.place(label, &self.made);
        }
        let last = self.made.pop().unwrap_or_default();
        open.closed(last).into_iter().for_each(|one| self.push(one));
    }

    fn stray_part(&mut self, instr: &Instr) {
        let word = self.front.names.written(instr.span);
        let why = (
            "write IF before it, with one ELSE at most",
            "escreva IF antes, com um só ELSE no máximo",
        );
        self.tell(Code::Structure, instr.span, [word.into(), why.into()]);
    }

    /// Tells which IFs have no END_IF.
    pub(super) fn end_of_ifs(&mut self) {
        for open in std::mem::take(&mut self.ifs) {
            let word = self.front.names.written(open.span);
            let why = ("write END_IF after it", "escreva END_IF depois dele");
            self.tell(Code::Structure, open.span, [word.into(), why.into()]);
        }
    }
}
