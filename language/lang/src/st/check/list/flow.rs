//! Jumps and RET.

use super::super::super::ast::{Instruction, Name, NodeKind};
use super::walk::Walk;
use crate::list::{Accumulator, Flow, Jump};

impl Walk<'_, '_, '_, '_> {
    pub(super) fn jump_line(&mut self, one: &Instruction) {
        let label = one.label();
        let key = label.map(|name| name.text.to_uppercase());
        let label = key.as_deref().zip(label.map(|name| name.span));
        let line = key.as_ref().and_then(|key| self.run.labels.lines.get(key));
        let carries = line.and_then(|line| self.run.needs.get(*line).copied());
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

impl Instruction {
    /// The label that a jump names.
    pub(super) fn label(&self) -> Option<&Name> {
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
