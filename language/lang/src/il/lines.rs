//! A run through a body: what each line does.

use super::front::Front;
use super::stack::pushes;
use super::walk::Walk;
use crate::ast::{Instr, Stmt};
use crate::diagnostics::Code;
use crate::list::{Acc, Accumulator, Branches, Flow, Jump, Machine, Run, Waiting, needed};
use crate::operators::Op;
use crate::typed::Stmt as Made;
use std::collections::HashSet;
use unoclp_core::isa::Opcode;

impl<'a> Front<'a, '_> {
    /// What a unit does.
    pub(super) fn body(&mut self, unit: usize) {
        let number = self.numbers[unit];
        let body = &self.units[unit].body;
        let writes = self.writes;
        self.builder.enter(number);
        let pushed = pushes(body, self.names.dialect);
        let mut walk = Walk {
            unit,
            instance: self.instances[unit],
            body,
            run: Run::new(),
            pushed,
            lost: 0,
            block: None,
            inverts: false,
            jumps: false,
            front: self,
        };
        walk.labels_of_body();
        walk.run.needs = needed(walk.passes());
        for (at, stmt) in body.iter().enumerate() {
            walk.run.at = at;
            match stmt {
                Stmt::Label(word) => walk.label(&word.text, word.span),
                Stmt::Close(span) => walk.close(*span),
                Stmt::Wrong { open } => {
                    walk.run.unused = None;
                    walk.run.unreachable = false;
                    walk.run.acc = Acc::Wrong;
                    walk.lost += open;
                }
                Stmt::Instr(instr) => {
                    walk.reachable(instr);
                    if walk.pushed.contains(&at) {
                        walk.push_result(instr.span);
                    }
                    walk.instr(instr);
                }
            }
        }
        let made = walk.finish();
        self.builder.body(number, made);
        self.builder.leave();
        if !self.called[unit] {
            self.writes = writes;
        }
    }
}

impl<'a> Walk<'_, 'a, '_> {
    fn reachable(&mut self, instr: &Instr) {
        // What begins a part or stands after it is reached in another way.
        let part = matches!(instr.op, Op::Part(Opcode::Else | Opcode::EndIf));
        if std::mem::take(&mut self.run.unreachable) && !part {
            self.tell(Code::Unreachable, instr.whole, []);
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
            Op::AndBlock | Op::OrBlock => self.pop_result(instr),
            Op::Block => self.begin_block(instr),
            Op::OutBlock => self.out_block(instr),
            Op::EndBlock => self.end_block(instr),
            // The parser has made a store of it.
            Op::Preset => {}
            Op::Input(opcode) => self.input_operator(instr, opcode),
            Op::Push => self.push_number(instr),
            Op::Table(opcode) => self.table(instr, opcode),
            Op::Code => self.code(instr),
        }
    }

    fn finish(mut self) -> Vec<Made> {
        self.warn_unused();
        for frame in std::mem::take(&mut self.run.frames) {
            let told = self.run.told_open == Some(frame.span);
            if matches!(frame.waiting, Waiting::Deferred(..)) && !told {
                self.tell(Code::LeftOpen, frame.span, []);
            }
        }
        self.end_of_blocks();
        self.end_of_branches();
        self.end_of_pushed();
        self.end_of_ifs();
        self.statements()
    }

    /// The labels, and those that a jump leads to.
    fn labels_of_body(&mut self) {
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
        let labels = self.body.iter().enumerate();
        let labels = labels.filter_map(|(at, stmt)| match stmt {
            Stmt::Label(word) => Some((at, word.text.clone(), word.span)),
            _ => None,
        });
        self.find_labels(labels, &wanted);
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
