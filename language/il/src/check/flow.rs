//! Labels and jumps, RET, IF.
//!
//! The tree's jumps stand in a unit's body itself. So IF becomes a statement of the tree where a body has no labels, and
//! jumps where it has some.

use super::labels::If;
use super::run::{Acc, Changes, Waiting};
use super::walk::Walk;
use std::collections::HashSet;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::{Code, Span, Word};
use unoclp_text::near::nearest;
use unoclp_tree::{Expr, Stmt, StmtKind, TypeId};

/// A line that jumps or leaves.
#[derive(Clone, Copy)]
pub(super) struct Jump {
    /// Where the accumulator is 1, or with N where it is 0.
    pub conditional: bool,
    pub negated: bool,
    /// The operator, and the whole line.
    pub span: Span,
    pub whole: Span,
}

impl Walk<'_, '_, '_> {
    /// The labels that a jump leads to, of all by the names that jumps have for them; the others change nothing.
    pub(super) fn find_labels(&mut self, all: Vec<(usize, &str, Span)>, wanted: &HashSet<&str>) {
        let mut seen = HashSet::new();
        for (at, key, span) in all {
            let labels = &mut self.run.labels;
            labels.all.push(span);
            let first = !seen.contains(key);
            if first && wanted.contains(key) {
                labels.lines.insert(key.to_owned(), at);
            }
            if !seen.insert(key) {
                let name = self.built().written(span);
                self.tell(Code::LabelTwice, span, [name.into()]);
            }
        }
    }

    /// The label of the line that is run.
    pub(super) fn label(&mut self, key: &str, span: Span) {
        let at = self.run.at;
        if self.run.labels.lines.get(key) != Some(&at) {
            return;
        }
        let name = self.built().written(span);
        self.not_deferred(&name, span);
        let run = &mut self.run;
        run.kept.clear();
        let falls_in = !std::mem::replace(&mut run.unreachable, false);
        let needed = run.needs.get(at).copied().unwrap_or_default();
        match needed {
            true if falls_in => self.carry_to(at, &name, span),
            true => {}
            false => self.warn_unused(),
        }
        let run = &mut self.run;
        run.labels.place(at, &run.made);
        run.acc = Acc::Empty;
        if needed {
            self.carried(at, falls_in, span);
        }
        self.run.links = 0;
    }

    /// Leaves the accumulator where the way from the label on takes it from.
    fn carry_to(&mut self, label: usize, name: &str, span: Span) {
        let Some(expr) = self.take(name, span) else {
            return;
        };
        let to = self.run.labels.carried.get(&label).cloned();
        let Some(expr) = self.carries(expr, to.as_ref(), span) else {
            return;
        };
        let target = match to {
            Some(target) => target,
            None => {
                let ty = self.plain(&expr);
                let Some(target) = self.own(ty, span) else {
                    return;
                };
                let carried = &mut self.run.labels.carried;
                carried.insert(label, target.clone());
                target
            }
        };
        let statement = self.assigned(&target, expr, span);
        statement.into_iter().for_each(|one| self.push(one));
        let held = self.builder().read(Some(target), span);
        self.run.load(Some(held));
    }

    /// The accumulator after a label that needs it. Where no way above leads there, it is taken for a bit.
    fn carried(&mut self, label: usize, falls_in: bool, span: Span) {
        let target = match self.run.labels.carried.get(&label).cloned() {
            Some(target) => Some(target),
            // Why nothing was left has been told.
            None if falls_in => None,
            None => {
                let made = self.own(TypeId::BOOL, span);
                if let Some(target) = &made {
                    let carried = &mut self.run.labels.carried;
                    carried.insert(label, target.clone());
                }
                made
            }
        };
        let held = target.map(|target| self.builder().read(Some(target), span));
        self.hold(held);
    }

    /// JMP to a label, by the name that labels have, and where this stands.
    pub(super) fn jump(&mut self, jump: Jump, label: Option<(&str, Span)>) {
        self.not_deferred("JMP", jump.span);
        let Some((key, name)) = label else {
            let example = ("the name of a label", "o nome de um rótulo");
            let words = ["JMP".into(), example.into()];
            return self.tell(Code::OperandMissing, jump.span, words);
        };
        let line = self.run.labels.lines.get(key).copied();
        if line.is_none() {
            self.no_label(name);
        }
        if let Some(line) = line
            && self.run.needs.get(line).copied().unwrap_or_default()
        {
            self.carry_to(line, "JMP", jump.span);
        }
        if jump.conditional {
            let condition = self.condition("JMPC", jump);
            if let (Some(condition), Some(line)) = (condition, line) {
                self.jump_to(Some(condition), line, jump.whole);
            }
            return;
        }
        self.run.unused = None;
        if let Some(line) = line {
            self.jump_to(None, line, jump.whole);
        }
        self.leave();
    }

    fn no_label(&mut self, span: Span) {
        let name = self.built().written(span);
        let labels = self.run.labels.all.iter();
        let labels: Vec<String> = labels.map(|span| self.built().written(*span)).collect();
        let help = match nearest(&name, labels.iter().map(String::as_str)) {
            Some(near) => Word::Near(near.to_owned()),
            None => Word::Both(
                format!("write `{name}:` before the instruction to continue with"),
                format!("escreva `{name}:` antes da instrução em que o programa deve continuar"),
            ),
        };
        self.tell(Code::NoSuchLabel, span, [name.into(), help]);
    }

    fn jump_to(&mut self, condition: Option<Expr>, label: usize, at: Span) {
        let run = &mut self.run;
        run.labels.jumps_to(label, &run.made);
        let kind = StmtKind::Jump(condition, 0);
        self.push(Stmt { kind, at });
    }

    /// Nothing comes after this.
    pub(super) fn leave(&mut self) {
        let run = &mut self.run;
        run.acc = Acc::Empty;
        run.unreachable = true;
    }

    /// The accumulator as a condition, inverted by N.
    pub(super) fn condition(&mut self, what: &str, of: Jump) -> Option<Expr> {
        self.undecided();
        if self.needed() {
            self.settle_costly();
        }
        let expr = self.peek(what, of.span)?;
        let condition = self.tested(expr, of.span)?;
        Some(match of.negated {
            true => self.builder().not(condition, of.span),
            false => condition,
        })
    }

    pub(super) fn ret(&mut self, jump: Jump) {
        self.not_deferred("RET", jump.span);
        let at = jump.whole;
        let statement = Stmt {
            kind: StmtKind::Return,
            at,
        };
        if jump.conditional {
            if let Some(condition) = self.condition("RETC", jump) {
                let kind = StmtKind::If(vec![(condition, vec![statement])], Vec::new());
                self.push(Stmt { kind, at });
            }
            return;
        }
        self.run.unused = None;
        self.push(statement);
        self.leave();
    }

    /// Jumps and labels do not stand between parentheses; what LD has pushed is lost there.
    pub(super) fn not_deferred(&mut self, what: &str, span: Span) {
        let mut frames = self.run.frames.iter();
        let open = frames.find(|frame| !matches!(frame.waiting, Waiting::Pushed));
        // Told once for each parenthesis.
        if let Some(open) = open.map(|frame| frame.span)
            && self.run.told_open.replace(open) != Some(open)
        {
            self.tell(Code::InParentheses, span, [what.into()]);
        }
    }

    /// IF, ELSE, END_IF.
    pub(super) fn part(&mut self, span: Span, opcode: Opcode) {
        let word = self.built().written(span);
        self.not_deferred(&word, span);
        self.run.kept.clear();
        match opcode {
            Opcode::If => self.begin_if(span),
            Opcode::Else => self.begin_else(span),
            _ => self.end_if(span),
        }
        self.run.acc = Acc::Empty;
    }

    fn begin_if(&mut self, span: Span) {
        let expr = self.take("IF", span);
        let condition = expr.and_then(|expr| self.tested(expr, span));
        self.before(&Changes::Anything, false);
        let lines = self.run.needs.len();
        let mut labels = None;
        if self.run.labels.lines.is_empty() {
            self.run.made.push(Vec::new());
        } else {
            let (first, end) = self.run.labels.of_if(lines);
            labels = Some((first, end));
            if let Some(condition) = condition.clone() {
                let not = self.builder().not(condition, span);
                self.jump_to(Some(not), first, span);
            }
        }
        self.run.ifs.push(If {
            span,
            condition,
            first: None,
            labels,
            other: false,
        });
    }

    fn begin_else(&mut self, span: Span) {
        self.warn_unused();
        let open = self.run.ifs.last_mut().filter(|open| !open.other);
        let Some(open) = open else {
            return self.stray_part(span);
        };
        open.other = true;
        if let Some((first, end)) = open.labels {
            self.jump_to(None, end, span);
            let run = &mut self.run;
            return run.labels.place(first, &run.made);
        }
        let run = &mut self.run;
        let first = run.made.pop();
        if let Some(open) = run.ifs.last_mut() {
            open.first = first;
        }
        run.made.push(Vec::new());
    }

    fn end_if(&mut self, span: Span) {
        self.warn_unused();
        let run = &mut self.run;
        let Some(open) = run.ifs.pop() else {
            return self.stray_part(span);
        };
        if let Some((first, end)) = open.labels {
            let label = if open.other { end } else { first };
            return run.labels.place(label, &run.made);
        }
        let last = run.made.pop().unwrap_or_default();
        open.closed(last).into_iter().for_each(|one| self.push(one));
    }

    fn stray_part(&mut self, span: Span) {
        let why = (
            "write IF before it, with one ELSE at most",
            "escreva IF antes, com um só ELSE no máximo",
        );
        let word = self.built().written(span);
        self.tell(Code::Structure, span, [word.into(), why.into()]);
    }

    /// Tells which IFs have no END_IF.
    pub(super) fn end_of_ifs(&mut self) {
        for open in std::mem::take(&mut self.run.ifs) {
            let word = self.built().written(open.span);
            let why = ("write END_IF after it", "escreva END_IF depois dele");
            self.tell(Code::Structure, open.span, [word.into(), why.into()]);
        }
    }

    /// The statements of a body that has been run.
    pub(super) fn statements(mut self) -> Vec<Stmt> {
        let run = &mut self.run;
        run.labels.settle(&mut run.made);
        run.made.swap_remove(0)
    }
}
