//! A run through a body: what each line does.

use super::front::Front;
use super::walk::Walk;
use crate::ast::Instr;
use crate::list::{Accumulator, Branches, Flow, Jump, Lines, Run, Stack};
use crate::operators::Op;
use unoclp_tree::Stmt as Made;

impl<'a> Front<'a, '_> {
    /// What a unit does.
    pub(super) fn body(&mut self, unit: usize) {
        let number = self.numbers[unit];
        let body = &self.units[unit].body;
        let writes = self.writes;
        self.c.builder.enter(number);
        let mut walk = Walk {
            unit,
            instance: self.instances[unit],
            body,
            run: Run::new(),
            block: None,
            hint: None,
            front: self,
        };
        walk.run_lines();
        let made = walk.finish();
        self.c.builder.body(number, made);
        self.c.builder.leave();
        if !self.called[unit] {
            self.writes = writes;
        }
    }
}

impl<'a> Walk<'_, 'a, '_> {
    pub(super) fn instr(&mut self, instr: &'a Instr) {
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
