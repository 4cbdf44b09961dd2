//! Labels, jumps and returns.

use super::carry::needs;
use super::{Acc, Label, Lower, Scope, Waiting, forget};
use crate::ast::{Instr, Stmt, Word};
use crate::diagnostics::{Code, Span};
use crate::operators::Op;
use crate::rung::{Holds, Written};
use crate::tree::Expr;
use std::collections::{HashMap, HashSet};
use unoclp_core::isa::Opcode;

impl Lower<'_> {
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
                self.found
                    .tell(Code::LabelTwice, word.span, [word.text.as_str().into()]);
            } else if wanted.contains(&word.text) {
                let index = self.new_label(word.span, asked_number(&word.text));
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
        self.not_deferred(&word.text, word.span);
        let falls_in = !std::mem::replace(&mut self.unreachable, false);
        if !self.is_needed(&word.text) {
            self.warn_unused();
            return self.place_label(index, word.span);
        }
        if falls_in {
            self.carry_to(index, &word.text, word.span);
        }
        self.place_label(index, word.span);
        self.acc = self.carried(index, word.span);
    }

    /// Whether the accumulator is needed behind this label.
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
        let name = self.spelled(operand);
        let index = self
            .scopes
            .last()
            .and_then(|scope| scope.labels.get(&name))
            .copied();
        if index.is_none() {
            let name = name.as_str();
            self.found
                .tell(Code::NoSuchLabel, operand.span, [name.into()]);
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

    /// Jumps and labels do not stand between parentheses; what LD has pushed is lost there.
    fn not_deferred(&mut self, what: &str, span: Span) {
        let deferred = |waiting: &Waiting| matches!(waiting, Waiting::Deferred(..));
        if self.frames.iter().any(|frame| deferred(&frame.waiting)) {
            self.found.tell(Code::InParentheses, span, [what.into()]);
        }
    }
}

/// The number that a label's name asks for: `L07`.
fn asked_number(name: &str) -> Option<u8> {
    let number = name.strip_prefix('L')?.parse().ok()?;
    (1..=unoclp_core::isa::LABELS)
        .contains(&number)
        .then_some(number)
}
