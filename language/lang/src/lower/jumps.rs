//! Labels, jumps and returns.

use super::carry::needs;
use super::{Acc, Label, Lower, Scope, Waiting, forget};
use crate::ast::{Instr, Operand, Stmt, Word};
use crate::diagnostics::{Code, Span};
use crate::names::near::nearest;
use crate::operators::Op;
use crate::rung::{Holds, Written};
use crate::tree::Expr;
use std::collections::{HashMap, HashSet};
use unoclp_core::Board;
use unoclp_core::isa::Opcode;

impl Lower<'_, '_> {
    /// The labels of a unit, and those that its jumps lead to.
    pub(super) fn scope(&mut self, unit: usize, instance: usize, end: Option<usize>) -> Scope {
        let body = &self.units[unit].body;
        let mut wanted = HashSet::new();
        for stmt in body {
            if let Stmt::Instr(instr) = stmt
                && instr.op == Op::Jump
                && let Some(name) = instr.operands.first().and_then(|operand| operand.name())
            {
                wanted.insert(name.to_owned());
            }
        }
        let mut labels = HashMap::new();
        let mut seen = HashSet::new();
        for stmt in body {
            let Stmt::Label(word) = stmt else { continue };
            if !seen.insert(&word.text) {
                let name = self.names.written(word.span);
                self.found.tell(Code::LabelTwice, word.span, [name.into()]);
            } else if wanted.contains(&word.text) {
                let index = self.new_label(word.span, asked_number(&word.text, self.names.board));
                labels.insert(word.text.clone(), index);
            }
        }
        Scope {
            unit,
            instance,
            labels,
            needs: needs(body),
            wanted,
            end,
            call: None,
        }
    }

    pub(super) fn new_label(&mut self, span: Span, number: Option<u8>) -> usize {
        self.labels.push(Label {
            number,
            span,
            carry: None,
        });
        self.labels.len() - 1
    }

    /// A label of the text. Where no jump leads to it, it changes nothing.
    pub(super) fn label(&mut self, word: &Word) {
        let index = self
            .scopes
            .last()
            .and_then(|scope| scope.labels.get(&word.text))
            .copied();
        let Some(index) = index else { return };
        let name = self.names.written(word.span);
        self.not_deferred(&name, word.span);
        self.kept.clear();
        let falls_in = !std::mem::replace(&mut self.unreachable, false);
        if !self.is_needed(&word.text) {
            self.warn_unused();
            return self.place_label(index, word.span);
        }
        if falls_in {
            self.carry_to(index, &name, word.span);
        }
        self.place_label(index, word.span);
        self.acc = self.carried(index, word.span);
    }

    /// Whether the accumulator is needed after this label.
    fn is_needed(&self, label: &str) -> bool {
        self.scopes
            .last()
            .is_some_and(|scope| scope.needs.contains(label))
    }

    /// A label at the head of a rung.
    pub(super) fn place_label(&mut self, index: usize, span: Span) {
        if !self.rungs.head {
            self.rungs.new_rung(span);
        }
        self.rungs.write(Written::Label(index), span);
        self.rungs.head = true;
        self.rungs.holds = Holds::One;
        self.acc = Acc::Empty;
    }

    pub(super) fn jump(&mut self, instr: &Instr) {
        self.not_deferred("JMP", instr.span);
        let Some(operand) = instr.operands.first() else {
            return self.missing("JMP", instr.span);
        };
        self.only(instr, 1);
        let name = operand.name().unwrap_or_default().to_owned();
        let index = self
            .scopes
            .last()
            .and_then(|scope| scope.labels.get(&name))
            .copied();
        if index.is_none() {
            self.no_label(operand);
        }
        if let Some(index) = index
            && self.is_needed(&name)
        {
            self.carry_to(index, "JMP", instr.span);
        }
        if instr.conditional {
            let Some(expr) = self.take_condition("JMPC", instr.span) else {
                return;
            };
            if let Some(index) = index {
                self.jump_if(expr, !instr.negated, index, instr.whole);
            }
            return;
        }
        self.unused = None;
        if let Some(index) = index {
            self.jump_always(index, instr.whole);
        }
        self.acc = Acc::Empty;
        self.unreachable = true;
    }

    fn no_label(&mut self, operand: &Operand) {
        let name = self.spelled(operand);
        let unit = self.scopes.last().map_or(0, |scope| scope.unit);
        let labels = self.units[unit].body.iter().filter_map(|stmt| match stmt {
            Stmt::Label(word) => self.names.text.get(word.span.range()),
            _ => None,
        });
        let help = match nearest(&name, labels) {
            Some(near) => (format!("is it `{near}`?"), format!("seria `{near}`?")),
            None => (
                format!("write `{name}:` before the instruction to go on with"),
                format!("escreva `{name}:` antes da instrução em que o programa deve continuar"),
            ),
        };
        self.found
            .tell(Code::NoSuchLabel, operand.span, [name.into(), help.into()]);
    }

    /// Goes on at a label where the expression is so.
    pub(super) fn jump_if(&mut self, expr: Expr, so: bool, label: usize, span: Span) {
        self.bring(expr, span);
        let opcode = if so { Opcode::Jump } else { Opcode::JumpNot };
        self.rungs.write(Written::Jump(opcode, label), span);
        self.rungs.head = false;
    }

    pub(super) fn jump_always(&mut self, label: usize, span: Span) {
        self.rungs.fresh(span);
        self.rungs.write(Written::Jump(Opcode::Jump, label), span);
        forget(&mut self.rungs);
    }

    pub(super) fn ret(&mut self, instr: &Instr) {
        self.not_deferred("RET", instr.span);
        self.only(instr, 0);
        let end = self.scopes.last().and_then(|scope| scope.end);
        let span = instr.whole;
        if instr.conditional {
            let Some(expr) = self.take_condition("RETC", instr.span) else {
                return;
            };
            match end {
                Some(end) => self.jump_if(expr, !instr.negated, end, span),
                None => {
                    self.bring(expr, span);
                    let opcode = if instr.negated {
                        Opcode::ReturnNot
                    } else {
                        Opcode::Return
                    };
                    self.rungs.write(Written::Plain(opcode), span);
                }
            }
            return;
        }
        self.unused = None;
        match end {
            Some(end) => self.jump_always(end, span),
            None => {
                self.rungs.fresh(span);
                self.rungs.write(Written::Plain(Opcode::Return), span);
                forget(&mut self.rungs);
            }
        }
        self.acc = Acc::Empty;
        self.unreachable = true;
    }

    /// END, which needs no code where nothing follows.
    pub(super) fn end(&mut self, instr: &Instr, next: Option<&Stmt>) {
        self.warn_unused();
        self.not_deferred("END", instr.span);
        match next {
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
        if let Some(frame) = open
            && self.told_open.replace(frame.span) != Some(frame.span)
        {
            self.found.tell(Code::InParentheses, span, [what.into()]);
        }
    }
}

/// The number that a label's name asks for: `L07`.
fn asked_number(name: &str, board: Board) -> Option<u8> {
    let number = name.strip_prefix('L')?.parse().ok()?;
    (1..=board.labels).contains(&number).then_some(number)
}
