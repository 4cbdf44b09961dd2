//! A run through a body: what each line does.

use super::flow::Jump;
use super::front::{Front, Stage};
use super::labels::{Passes, needed};
use super::run::{Acc, Run};
use super::stack::{Pushes, pops};
use super::walk::Walk;
use crate::ast::{Instr, Operand, Stmt};
use crate::operators::Op;
use std::collections::HashSet;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::Code;
use unoclp_tree::Stmt as Made;

/// The label that a jump goes to.
fn goes_to(instr: &Instr) -> Option<&str> {
    let label = instr.operands.first().and_then(Operand::name);
    label.filter(|_| instr.op == Op::Jump)
}

impl<'a> Front<'a, '_> {
    /// What a unit does.
    pub(super) fn body(&mut self, unit: usize) {
        let Stage::Done(made) = std::mem::replace(&mut self.stages[unit], Stage::Begun) else {
            return;
        };
        let body = &self.units[unit].body;
        let writes = self.writes;
        let before = self.c.builder.enter(&made);
        let edges = std::mem::take(&mut self.edge_inputs[unit]).into_iter();
        let edges = edges.flat_map(|edge| self.c.builder.see_edge(edge));
        let edges: Vec<_> = edges.collect();
        let mut walk = Walk {
            unit,
            instance: self.instances[unit],
            body,
            run: Run::new(),
            block: None,
            hint: None,
            front: self,
        };
        edges.into_iter().for_each(|one| walk.push(one));
        walk.lines();
        let statements = walk.finish();
        self.c.builder.back(before);
        self.c.builder.body(made, statements);
        if !self.called[unit] {
            self.writes = writes;
        }
    }
}

impl<'a> Walk<'_, 'a, '_> {
    /// Runs the body.
    fn lines(&mut self) {
        self.prepare();
        for (at, line) in self.body.iter().enumerate() {
            self.run.at = at;
            match line {
                Stmt::Label(word) => self.label(&word.text, word.span),
                Stmt::Close(span) => self.close(*span),
                Stmt::Wrong { open } => {
                    let run = &mut self.run;
                    run.unused = None;
                    run.unreachable = false;
                    run.acc = Acc::Wrong;
                    run.lost += open;
                }
                Stmt::Instr(instr) => {
                    // What begins a part or stands after it is reached in another way.
                    let part = matches!(instr.op, Op::Part(Opcode::Else | Opcode::EndIf));
                    if std::mem::take(&mut self.run.unreachable) && !part {
                        self.tell(Code::Unreachable, instr.whole, []);
                    }
                    if self.run.pushes.contains(&at) {
                        self.push_result(instr.span);
                    }
                    self.instr(instr);
                }
            }
        }
        self.warn_unused();
        self.end_of_frames();
    }

    /// Finds the labels, and the lines that need what the one before leaves.
    fn prepare(&mut self) {
        let mut labels = Vec::new();
        let mut wanted = HashSet::new();
        let mut pushes = Pushes::default();
        for (at, line) in self.body.iter().enumerate() {
            match line {
                Stmt::Label(word) => labels.push((at, &*word.text, word.span)),
                Stmt::Instr(instr) => {
                    if instr.op == Op::Load {
                        pushes.load(at);
                    }
                    pushes.pop(pops(instr, self.front.names.dialect));
                    wanted.extend(goes_to(instr));
                }
                Stmt::Close(_) | Stmt::Wrong { .. } => {}
            }
        }
        self.run.jumps = !wanted.is_empty();
        self.run.pushes = pushes.lines;
        self.find_labels(labels, &wanted);
        let lines = self.body.iter().enumerate();
        self.run.needs = needed(lines.map(|(at, line)| self.passes(at, line)));
    }

    fn passes(&self, at: usize, line: &Stmt) -> Passes {
        let all = Passes {
            reads: false,
            fills: false,
            goes_on: true,
            jumps: None,
        };
        let instr = match line {
            Stmt::Label(_) => return all,
            Stmt::Close(_) => return Passes { reads: true, ..all },
            Stmt::Wrong { .. } => return Passes { fills: true, ..all },
            Stmt::Instr(instr) => instr,
        };
        let leads = matches!(instr.op, Op::Jump | Op::Return | Op::End);
        Passes {
            reads: match instr.op {
                Op::Jump | Op::Return | Op::Call => instr.conditional,
                Op::Load => self.run.pushes.contains(&at),
                Op::Recall | Op::Release | Op::End => false,
                Op::Part(opcode) => opcode == Opcode::If,
                Op::Block | Op::OutBlock | Op::EndBlock => false,
                Op::Function => self.takes_accumulator(instr),
                _ => true,
            },
            fills: !leads,
            goes_on: !leads || instr.conditional,
            jumps: goes_to(instr).and_then(|label| self.run.labels.lines.get(label).copied()),
        }
    }

    fn instr(&mut self, instr: &'a Instr) {
        match instr.op {
            Op::Load => self.load(instr),
            Op::Store => self.store(instr),
            Op::OmronTimer => self.omron_timer(instr),
            Op::OmronCounter => self.omron_counter(instr),
            Op::Keep => self.keep_result(instr.whole),
            Op::Recall | Op::Release => self.recall_result(instr.op, instr.span, instr.whole),
            Op::Differentiate(_) => self.differentiate(instr),
            Op::Set | Op::Reset => self.set_or_reset(instr),
            Op::Not => self.not(instr),
            Op::And | Op::Or | Op::Xor | Op::Number(_) | Op::Compare(_) => self.operate(instr),
            Op::Shift(opcode) => self.shift(instr, opcode),
            Op::Unary(opcode) => self.unary(instr, opcode),
            Op::Part(opcode) => self.part(instr.span, opcode),
            Op::Edge(opcode) => self.edge(instr, opcode),
            Op::Jump => self.jump_line(instr),
            Op::Return => self.ret_line(instr),
            Op::End => self.end(instr),
            Op::Call => self.call(instr),
            Op::Function => self.function(instr),
            Op::Timer(opcode) => self.timer_operator(instr, opcode),
            Op::CountUp | Op::CountDown | Op::CountUpDown => self.count_operator(instr),
            Op::AndBlock | Op::OrBlock => self.pop_result(instr.op, instr.span),
            Op::Block => self.begin_block(instr),
            Op::OutBlock => self.out_block(instr),
            Op::EndBlock => self.end_block(instr),
            // The parser has made a store of it.
            Op::Preset => {}
            Op::Input(opcode) => self.input_operator(instr, opcode),
            Op::Push => self.push_line(instr),
            Op::Table(opcode) => self.table_line(instr, opcode),
            Op::Code => self.code(instr),
        }
    }

    fn finish(mut self) -> Vec<Made> {
        self.end_of_blocks();
        self.end_of_branches();
        self.end_of_pushed();
        self.end_of_ifs();
        self.statements()
    }

    fn jump_of(instr: &Instr) -> Jump {
        Jump {
            conditional: instr.conditional,
            negated: instr.negated,
            span: instr.span,
            whole: instr.whole,
        }
    }

    fn jump_line(&mut self, instr: &Instr) {
        self.only(instr, 1);
        let label = instr.operands.first();
        let label = label.map(|label| (label.name().unwrap_or_default(), label.span));
        self.jump(Self::jump_of(instr), label);
    }

    fn ret_line(&mut self, instr: &Instr) {
        self.only(instr, 0);
        self.ret(Self::jump_of(instr));
    }

    /// END, which needs no code where nothing follows.
    fn end(&mut self, instr: &Instr) {
        self.warn_unused();
        self.not_deferred("END", instr.span);
        match self.next() {
            Some(_) => self.ret_line(instr),
            None => self.only(instr, 0),
        }
    }
}
