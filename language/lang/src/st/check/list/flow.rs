//! Which lines read the accumulator, and where they lead.

use super::super::super::ast::{Instruction, Line, Name, NodeKind};
use super::walk::Walk;
use crate::list::{Accumulator, Flow, Jump, Passes};
use crate::operators::Op;
use std::collections::HashSet;
use unoclp_core::isa::Opcode;

impl Walk<'_, '_, '_, '_> {
    pub(super) fn labels_of_body(&mut self) {
        let lines = self.lines.iter();
        let jumps = lines.filter_map(|line| match line {
            Line::Does(one) if one.op() == Some(Op::Jump) => one.label(),
            _ => None,
        });
        let wanted: Vec<String> = jumps.map(|name| name.text.to_uppercase()).collect();
        let wanted: HashSet<&str> = wanted.iter().map(String::as_str).collect();
        let labels = self.lines.iter().enumerate();
        let labels = labels.filter_map(|(at, line)| match line {
            Line::Label(name) => Some((at, name.text.to_uppercase(), name.span)),
            _ => None,
        });
        self.find_labels(labels, &wanted);
    }

    /// What each line does with the accumulator, and where it leads.
    pub(super) fn passes(&self) -> impl ExactSizeIterator<Item = Passes> {
        self.lines.iter().map(|line| {
            let (goes_on, jumps) = match line {
                Line::Does(one) => self.leads(one),
                _ => (true, None),
            };
            Passes {
                reads: self.reads(line),
                fills: fills(line),
                goes_on,
                jumps,
            }
        })
    }

    /// Whether a line begins with what the accumulator holds.
    fn reads(&self, line: &Line) -> bool {
        let one = match line {
            Line::Does(one) => one,
            Line::Close(_) => return true,
            Line::Label(_) | Line::Wrong => return false,
        };
        let Some(spelling) = one.spelling else {
            return self.takes_accumulator(one);
        };
        match spelling.op {
            Op::Load | Op::Recall | Op::Release => false,
            Op::Jump | Op::Return | Op::Call => spelling.conditional,
            Op::End => false,
            Op::Part(opcode) => opcode == Opcode::If,
            _ if self.own_function(one).is_some() => self.takes_accumulator(one),
            _ => one.given.is_none(),
        }
    }

    /// Whether the next line comes after this, and the line of the label that it may go to.
    fn leads(&self, one: &Instruction) -> (bool, Option<usize>) {
        let Some(spelling) = one.spelling else {
            return (true, None);
        };
        let label = one.label().map(|name| name.text.to_uppercase());
        let label = label.and_then(|key| self.run.labels.lines.get(&key).copied());
        match spelling.op {
            Op::Jump => (spelling.conditional, label),
            Op::Return => (spelling.conditional, None),
            Op::End => (false, None),
            _ => (true, None),
        }
    }

    pub(super) fn jump_line(&mut self, one: &Instruction) {
        let label = one.label();
        let key = label.map(|name| name.text.to_uppercase());
        let label = key.as_deref().zip(label.map(|name| name.span));
        let (_, line) = self.leads(one);
        let carries = line.and_then(|line| self.run.needs.get(line).copied());
        if !one.jump().conditional && carries != Some(true) {
            self.warn_unused();
        }
        self.jump(one.jump(), label);
    }

    /// RET and END, which need no code where nothing follows.
    pub(super) fn ret_line(&mut self, one: &Instruction) {
        let jump = one.jump();
        let last = self.lines.len() == self.run.at + 1 && self.run.ifs.is_empty();
        if !jump.conditional {
            self.warn_unused();
        }
        match last && !jump.conditional {
            true => self.leave(),
            false => self.ret(jump),
        }
    }
}

/// Whether a line that does not read the accumulator fills or forgets it.
fn fills(line: &Line) -> bool {
    match line {
        Line::Does(one) => !matches!(one.op(), Some(Op::Jump | Op::Return | Op::End)),
        Line::Close(_) | Line::Label(_) => false,
        Line::Wrong => true,
    }
}

impl Instruction {
    fn op(&self) -> Option<Op> {
        self.spelling.map(|spelling| spelling.op)
    }

    /// The label that a jump names.
    fn label(&self) -> Option<&Name> {
        match self.operands.first().map(|arg| &arg.node.kind) {
            Some(NodeKind::Path(path)) if path.parts.is_empty() => Some(&path.name),
            _ => None,
        }
    }

    /// Where and when it goes on or calls.
    pub(super) fn jump(&self) -> Jump {
        Jump {
            conditional: self.spelling.is_some_and(|spelling| spelling.conditional),
            negated: self.spelling.is_some_and(|spelling| spelling.negated),
            span: self.word.span,
            whole: self.span,
        }
    }
}
