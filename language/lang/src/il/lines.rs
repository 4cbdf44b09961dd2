//! A run through a body: what each line does.

use super::front::Front;
use super::stack::pushes;
use super::walk::{Acc, Waiting, Walk};
use crate::ast::{Instr, Stmt};
use crate::diagnostics::Code;
use crate::jumps::Labels;
use crate::operators::Op;
use crate::typed::Stmt as Made;
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
            needs: Vec::new(),
            pushed,
            acc: Acc::Empty,
            links: 0,
            frames: Vec::new(),
            lost: 0,
            kept: Vec::new(),
            pushed_numbers: Vec::new(),
            block: None,
            inverts: false,
            unused: None,
            unreachable: false,
            at: 0,
            decided: None,
            told_open: None,
            labels: Labels::default(),
            jumps: false,
            ifs: Vec::new(),
            made: vec![Vec::new()],
            own: 0,
            front: self,
        };
        walk.find_labels();
        walk.find_needs();
        for (at, stmt) in body.iter().enumerate() {
            walk.at = at;
            match stmt {
                Stmt::Label(word) => walk.label(word, at),
                Stmt::Close(span) => walk.close(*span),
                Stmt::Wrong { open } => {
                    walk.unused = None;
                    walk.unreachable = false;
                    walk.acc = Acc::Wrong;
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
        if std::mem::take(&mut self.unreachable) && !part {
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
            Op::Recall | Op::Release => self.recall_result(instr),
            Op::Differentiate(_) => self.differentiate(instr),
            Op::Set | Op::Reset => self.set_or_reset(instr),
            Op::Not => self.not(instr),
            Op::And | Op::Or | Op::Xor | Op::Number(_) | Op::Compare(_) => self.operate(instr),
            Op::Shift(opcode) => self.shift(instr, opcode),
            Op::Unary(opcode) => self.unary(instr, opcode),
            Op::Part(opcode) => self.part(instr, opcode),
            Op::Edge(opcode) => self.edge(instr, opcode),
            Op::Jump => self.jump(instr),
            Op::Return => self.ret(instr),
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
        for frame in std::mem::take(&mut self.frames) {
            let told = self.told_open == Some(frame.span);
            if matches!(frame.waiting, Waiting::Deferred(..)) && !told {
                self.tell(Code::LeftOpen, frame.span, []);
            }
        }
        self.end_of_blocks();
        self.end_of_branches();
        self.end_of_pushed();
        self.end_of_ifs();
        self.labels.settle(&mut self.made);
        self.made.swap_remove(0)
    }
}
