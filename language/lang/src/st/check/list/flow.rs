//! Jumps and labels, IF, and what the accumulator is needed for behind a line.
//!
//! The tree's jumps stand in a unit's body itself. So IF becomes a statement of the tree where a unit has no labels,
//! and jumps where it has some.

use super::super::super::ast::{Instruction, Line, Name};
use super::accumulator::Changes;
use super::walk::{Acc, Walk};
use crate::diagnostics::{Code, Span};
use crate::jumps::{If, Passes, needed};
use crate::names::near::nearest;
use crate::operators::Op;
use crate::typed::build::{Section, both};
use crate::typed::{Expr, Stmt, StmtKind};
use unoclp_core::isa::Opcode;

impl Walk<'_, '_, '_, '_> {
    pub(super) fn find_labels(&mut self) {
        for (at, line) in self.lines.iter().enumerate() {
            let Line::Label(name) = line else { continue };
            let key = name.text.to_uppercase();
            if self.labels.lines.insert(key, at).is_some() {
                self.tell(Code::LabelTwice, name.span, [name.text.as_str().into()]);
            }
        }
    }

    /// Finds the lines that need what the one before leaves.
    pub(super) fn find_needs(&mut self) {
        self.needs = needed(self.lines.iter().map(|line| self.passes(line)));
    }

    fn passes(&self, line: &Line) -> Passes {
        let (goes_on, jumps) = match line {
            Line::Does(one) => self.leads(one),
            _ => (true, None),
        };
        Passes {
            reads: self.reads(line),
            fills: self.fills(line),
            goes_on,
            jumps,
        }
    }

    /// Whether the next line comes after this, and the line of the label that it may go to.
    fn leads(&self, one: &Instruction) -> (bool, Option<usize>) {
        let Some(spelling) = one.spelling else {
            return (true, None);
        };
        let label = one.label().map(|name| name.text.to_uppercase());
        let label = label.and_then(|key| self.labels.lines.get(&key).copied());
        match spelling.op {
            Op::Jump => (spelling.conditional, label),
            Op::Return => (spelling.conditional, None),
            Op::End => (false, None),
            _ => (true, None),
        }
    }

    fn has_jumps(&self) -> bool {
        !self.labels.lines.is_empty()
    }

    pub(super) fn label(&mut self, name: &Name, at: usize) {
        self.unreachable = false;
        if !self.frames.is_empty() {
            let word = name.text.as_str().into();
            self.tell(Code::InParentheses, name.span, [word]);
            self.frames.clear();
            self.lost = true;
        }
        self.kept.clear();
        if self.needs[at] {
            self.carry(at, &name.text, name.span);
        } else {
            self.warn_unused();
        }
        self.labels.place(at, &self.made);
        self.acc = match self.labels.carried.get(&at).cloned() {
            Some(target) if self.needs[at] => {
                let read = self.c.builder.read(Some(target), name.span);
                Acc::Value(read)
            }
            _ if self.needs[at] && matches!(self.acc, Acc::Wrong) => Acc::Wrong,
            _ => Acc::Empty,
        };
        self.links = 0;
    }

    /// Puts the accumulator where the code after this label looks for it.
    fn carry(&mut self, label: usize, name: &str, at: Span) {
        // It tells where there is nothing to carry.
        let Some(expr) = self.take(name, at) else {
            return;
        };
        let expr = self.c.builder.settled(expr);
        let at = expr.at;
        let target = match self.labels.carried.get(&label).cloned() {
            Some(target) => target,
            None => {
                let ty = self.plain(&expr);
                let Some(target) = self.own(ty, Section::Temp, at) else {
                    return;
                };
                self.labels.carried.insert(label, target.clone());
                target
            }
        };
        let statement = self.c.builder.assign(target.clone(), expr, at);
        statement.into_iter().for_each(|one| self.push(one));
        let held = self.c.builder.read(Some(target), at);
        self.hold(held, 0);
    }

    /// JMP, JMPC, JMPCN.
    pub(super) fn jump(&mut self, one: &Instruction, at: usize) {
        let spelling = one.spelling;
        let conditional = spelling.is_some_and(|s| s.conditional);
        if !self.frames.is_empty() {
            return self.tell(Code::InParentheses, one.span, ["JMP".into()]);
        }
        let label = one.label().map(|name| (name.text.clone(), name.span));
        let Some((name, span)) = label else {
            let words = ["JMP".into(), "JMP end".into()];
            return self.tell(Code::OperandMissing, one.span, words);
        };
        let line = self.labels.lines.get(&name.to_uppercase()).copied();
        let Some(line) = line else {
            let known = self.labels.lines.keys().map(String::as_str);
            let help = match nearest(&name.to_uppercase(), known) {
                Some(near) => both(format!("is it {near}?"), format!("seria {near}?")),
                None => both(
                    format!("write `{name}:` before the line that is meant"),
                    format!("escreva `{name}:` antes da linha desejada"),
                ),
            };
            return self.tell(Code::NoSuchLabel, span, [name.into(), help]);
        };
        if self.needs[line] {
            self.carry(line, &name, span);
        }
        let condition = match conditional {
            true => {
                if self.needs[at + 1] {
                    self.settle_costly();
                }
                let Some(condition) = self.condition(one) else {
                    return;
                };
                Some(condition)
            }
            false => None,
        };
        self.jump_to(condition, line, one.span);
        if !conditional {
            self.leave();
        }
    }

    fn jump_to(&mut self, condition: Option<Expr>, label: usize, at: Span) {
        self.labels.jumps_to(label, &self.made);
        let kind = StmtKind::Jump(condition, 0);
        self.push(Stmt { kind, at });
    }

    /// Nothing comes after this.
    pub(super) fn leave(&mut self) {
        self.warn_unused();
        self.acc = Acc::Wrong;
        self.unreachable = true;
    }

    /// The accumulator as a condition, inverted where the operator says so.
    pub(super) fn condition(&mut self, one: &Instruction) -> Option<Expr> {
        let expr = self.take(&one.word.text, one.word.span)?;
        let expr = self.c.builder.condition(expr);
        let negated = one.spelling.is_some_and(|s| s.negated);
        let expr = match negated {
            true => self.c.builder.not(expr, one.span),
            false => expr,
        };
        (!matches!(expr.kind, crate::typed::ExprKind::Wrong)).then_some(expr)
    }

    /// Statements that are done where the condition holds.
    pub(super) fn conditional(&mut self, condition: Expr, body: Vec<Stmt>, at: Span, needed: bool) {
        let place = match body.as_slice() {
            [
                Stmt {
                    kind: StmtKind::Assign(place, ..),
                    ..
                },
            ] => Some(place.clone()),
            _ => None,
        };
        match &place {
            Some(place) => self.before(&Changes::Cells(place, 1), needed),
            None => self.before(&Changes::Anything, needed),
        }
        let kind = StmtKind::If(vec![(condition, body)], Vec::new());
        self.push(Stmt { kind, at });
    }

    /// RET, RETC, RETCN, END.
    pub(super) fn ret(&mut self, one: &Instruction, at: usize) {
        let statement = Stmt {
            kind: StmtKind::Return,
            at: one.span,
        };
        if one.spelling.is_some_and(|s| s.conditional) {
            if self.needs[at + 1] {
                self.settle_costly();
            }
            if let Some(condition) = self.condition(one) {
                let kind = StmtKind::If(vec![(condition, vec![statement])], Vec::new());
                self.push(Stmt { kind, at: one.span });
            }
            return;
        }
        let last = self.lines.len() == at + 1 && self.ifs.is_empty();
        if !last {
            self.push(statement);
        }
        self.leave();
    }

    /// IF, ELSE, END_IF.
    pub(super) fn part(&mut self, one: &Instruction, opcode: Opcode) {
        if !self.frames.is_empty() {
            let word = one.word.text.as_str().into();
            return self.tell(Code::InParentheses, one.span, [word]);
        }
        self.kept.clear();
        match opcode {
            Opcode::If => self.begin_if(one),
            Opcode::Else => self.begin_else(one),
            _ => self.end_if(one),
        }
        self.acc = Acc::Empty;
        self.unreachable = false;
    }

    fn begin_if(&mut self, one: &Instruction) {
        let condition = self.condition(one);
        let mut labels = None;
        if self.has_jumps() {
            let (first, end) = self.labels.of_if(self.lines.len());
            labels = Some((first, end));
            if let Some(condition) = condition.clone() {
                let not = self.c.builder.not(condition, one.span);
                self.jump_to(Some(not), first, one.span);
            }
        } else {
            self.made.push(Vec::new());
        }
        self.ifs.push(If {
            span: one.word.span,
            condition,
            first: None,
            labels,
            other: false,
        });
    }

    fn begin_else(&mut self, one: &Instruction) {
        self.warn_unused();
        let open = self.ifs.last_mut().filter(|open| !open.other);
        let Some(open) = open else {
            return self.stray_part(one);
        };
        open.other = true;
        match open.labels {
            Some((first, end)) => {
                self.jump_to(None, end, one.span);
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
    }

    fn end_if(&mut self, one: &Instruction) {
        self.warn_unused();
        let Some(open) = self.ifs.pop() else {
            return self.stray_part(one);
        };
        match open.labels {
            Some((first, end)) => {
                let label = if open.other { end } else { first };
                self.labels.place(label, &self.made);
            }
            None => {
                let last = self.made.pop().unwrap_or_default();
                open.closed(last).into_iter().for_each(|one| self.push(one));
            }
        }
    }

    fn stray_part(&mut self, one: &Instruction) {
        let why = (
            "write IF before it, with one ELSE at most",
            "escreva IF antes, com um só ELSE no máximo",
        );
        let words = [one.word.text.as_str().into(), why.into()];
        self.tell(Code::Structure, one.word.span, words);
    }

    pub(super) fn end_of_ifs(&mut self) {
        // Of more than one the innermost is told, after which the END_IF of another may have been taken.
        if let Some(open) = self.ifs.pop() {
            let why = ("write END_IF after it", "escreva END_IF depois dele");
            self.tell(Code::Structure, open.span, ["IF".into(), why.into()]);
        }
    }
}

impl Instruction {
    /// The label that a jump names.
    fn label(&self) -> Option<&Name> {
        match self.operands.first().map(|arg| &arg.node.kind) {
            Some(super::super::super::ast::NodeKind::Path(path)) if path.parts.is_empty() => {
                Some(&path.name)
            }
            _ => None,
        }
    }
}
