//! IF, jumps, returns and loops.
//!
//! Owns the nesting of statements. Must not know what else is in them.

use super::expr::{Expr, Place, compare, not, whole};
use super::machine::{Frame, Machine};
use super::statement::Statement;
use unoclp_core::Instruction;
use unoclp_core::isa::{Kind, Opcode};

impl Machine<'_, '_> {
    pub fn begin_frame(&mut self, frame: Frame) {
        self.scopes.push(self.next_scope);
        self.next_scope += 1;
        self.frames.push((frame, Vec::new()));
    }

    /// Ends the innermost frame.
    pub fn end_frame(&mut self) {
        let Some((frame, statements)) = self.frames.pop() else {
            return;
        };
        self.scopes.pop();
        let none = !statements
            .iter()
            .any(|s| !matches!(s, Statement::Space | Statement::Comment(_)));
        match frame {
            Frame::All => self.frames.push((Frame::All, statements)),
            Frame::Then(_) | Frame::Skip(..) | Frame::Guard if none => {
                statements.into_iter().for_each(|s| self.put(s))
            }
            Frame::Then(condition) => self.put(Statement::If(condition, statements, Vec::new())),
            Frame::Else(condition, then) => self.put(Statement::If(condition, then, statements)),
            Frame::Skip(condition, _) => self.when(condition, statements),
            Frame::Guard => {
                let free = compare("=", Expr::Place(Place::Jump), whole(0));
                self.put(Statement::If(free, statements, Vec::new()));
            }
            Frame::Loop(index) => {
                let l = self.flow.loops[index];
                let until = match l.plain {
                    true => not(self.acc.clone()),
                    false => compare("<>", Expr::Place(Place::Jump), whole(l.label.into())),
                };
                self.put(Statement::Repeat(statements, until));
            }
        }
    }

    fn end_guard(&mut self) {
        if let Some((Frame::Guard, _)) = self.frames.last() {
            self.end_frame();
        }
    }

    /// Where a jump may be on its way, what follows waits until it has come to its label.
    fn guard(&mut self, at: usize) {
        self.end_guard();
        if self.flow.is_pending(at) {
            self.begin_frame(Frame::Guard);
        }
    }

    /// Value where each way that leads to a step finds it.
    fn meet(&mut self, at: usize) {
        if self.live.value[at] {
            self.keep_value();
        }
    }

    /// After a place where ways meet.
    fn met(&mut self, at: usize) {
        self.acc = Expr::Is(true);
        self.points.clear();
        (self.bits, self.numbers) = (0, 0);
        if self.live.value[at] {
            // Some way here may have it in the other view: both are the same bits.
            self.value = self.kept();
        }
    }

    pub fn part(&mut self, step: Instruction<'_>) {
        let at = self.at;
        match step.opcode {
            Opcode::If => {
                let ways = self.flow.next(at);
                if ways.into_iter().flatten().any(|way| self.live.value[way]) {
                    self.keep_value_beside_acc();
                }
                let acc = self.acc.clone();
                self.begin_frame(Frame::Then(acc));
            }
            Opcode::Else => {
                if self
                    .flow
                    .next(at)
                    .into_iter()
                    .flatten()
                    .any(|way| self.live.value[way])
                {
                    self.keep_value();
                }
                self.end_guard();
                let Some((Frame::Then(condition), then)) = self.frames.pop() else {
                    return;
                };
                self.scopes.pop();
                self.begin_frame(Frame::Else(condition, then));
            }
            _ => {
                self.meet(at + 1);
                self.end_guard();
                self.end_frame();
                self.guard(at + 1);
            }
        }
        self.met(at + 1);
    }

    pub fn leave(&mut self, step: Instruction<'_>) {
        let at = self.at;
        let inverted = step.opcode.is_inverted();
        let label = step.number().unwrap_or_default();
        // What acc is where the scan goes on here.
        let stays = Expr::Is(inverted);
        let condition = |acc: &Expr| match inverted {
            true => not(acc.clone()),
            false => acc.clone(),
        };
        if step.opcode.row().kind != Kind::Jump {
            self.when(condition(&self.acc), vec![Statement::Return]);
            self.acc = stays;
            return;
        }
        let ways = self.flow.next(at).into_iter().flatten();
        let to = self
            .steps
            .iter()
            .position(|s| s.opcode == Opcode::Label && s.number() == Some(label));
        if ways.chain(to).any(|way| self.live.value[way]) {
            self.keep_value_beside_acc();
        }
        let condition = condition(&self.acc);
        if let Some(&end) = self.flow.skips.get(&at) {
            self.begin_frame(Frame::Skip(not(condition), end));
            self.acc = stays;
        } else if self.flow.loops.iter().any(|l| l.plain && l.last == at) {
            self.acc = condition;
        } else {
            let go = Statement::Assign(Place::Jump, whole(label.into()));
            self.when(condition, vec![go]);
            self.guard(at + 1);
            self.acc = stays;
        }
    }

    pub fn label(&mut self) {
        let at = self.at;
        let target = self.flow.targets.get(&at).copied();
        let begins = self.flow.loops.iter().position(|l| l.first == at);
        let skipped_to = self.flow.skips.values().any(|to| *to == at);
        if target.is_none() && begins.is_none() && !skipped_to {
            return;
        }
        self.meet(at);
        let ends = |frame: &(Frame, _)| matches!(frame.0, Frame::Skip(_, end) if end == at);
        while self.frames.iter().any(ends) {
            self.end_frame();
        }
        let plain = begins.is_some_and(|l| self.flow.loops[l].plain);
        match plain {
            true => self.guard(at),
            false if target.is_some() || begins.is_some() => self.end_guard(),
            false => {}
        }
        if let Some(l) = begins {
            self.begin_frame(Frame::Loop(l));
        }
        if let Some(label) = target {
            let here = compare("=", Expr::Place(Place::Jump), whole(label.into()));
            let arrived = Statement::Assign(Place::Jump, whole(0));
            self.put(Statement::If(here, vec![arrived], Vec::new()));
        }
        if !plain && (target.is_some() || begins.is_some()) {
            self.guard(at + 1);
        }
        self.met(at);
    }

    /// Ends the loops whose last step this is.
    pub fn ends_loops(&mut self, at: usize) {
        let ends = self.flow.loops.iter().filter(|l| l.last == at).count();
        for _ in 0..ends {
            self.end_guard();
            self.end_frame();
        }
        if ends > 0 {
            // After a plain loop its jump has not been made.
            self.acc = match self.steps[at].opcode {
                Opcode::JumpNot => Expr::Is(true),
                Opcode::Jump => Expr::Is(false),
                _ => Expr::Is(true),
            };
            self.guard(at + 1);
        }
    }
}
