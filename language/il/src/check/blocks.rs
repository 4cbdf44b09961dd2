//! The Twido's blocks, `BLK %TM1 … OUT_BLK … END_BLK`, and inputs by operator: `CU C1`.

use super::counters::Inputs;
use super::edges::named;
use super::first::part;
use super::operands::Is;
use super::run::{Acc, Changes};
use super::timers::Preset;
use super::used::COUNTER_PRESET;
use super::walk::{Block, Walk};
use crate::ast::{Instr, Operand};
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Order, Stmt, StmtKind};

/// The preset of a Twido's timer that nothing says: 9999 minutes, in ms.
const TIMER_PRESET: i32 = 9999 * 60_000;

impl Walk<'_, '_, '_> {
    pub(super) fn begin_block(&mut self, instr: &Instr) {
        self.end_of_blocks();
        self.warn_unused();
        self.run.acc = Acc::Empty;
        let Some(operand) = instr.operands.first() else {
            return self.missing("BLK", instr.span);
        };
        self.only(instr, 1);
        let block = match self.meaning(operand) {
            Is::Block(target, block) if block.is_timer() || block.is_counter() => {
                Some((target, block))
            }
            Is::Wrong => None,
            _ => {
                self.not_callable(operand);
                None
            }
        };
        self.block = Some(Block {
            operand: operand.clone(),
            block,
            name: self.spelled(operand),
            span: instr.whole,
            start: None,
            down: None,
            reset: None,
            set: None,
            written: false,
        });
    }

    /// An operand without a point within a block is the block's: `LD Q`.
    pub(super) fn block_member(&mut self, name: &str, _span: Span) -> Option<Is> {
        let (target, block) = self.block.as_ref()?.block.clone()?;
        let known = name == "Q" || name == "D" && !block.is_timer();
        let output = part(block, name).filter(|_| known)?;
        self.part_of(target, block, output).map(Is::Variable)
    }

    pub(super) fn names_block_member(&self, operand: &Operand) -> bool {
        let of = self.block.as_ref().and_then(|block| block.block.as_ref());
        let name = operand.name().unwrap_or_default();
        of.is_some_and(|(_, block)| name == "Q" || name == "D" && !block.is_timer())
    }

    /// IN, CU, CD, R, S within a block: the accumulator is connected to that input.
    pub(super) fn wire(&mut self, input: &str, span: Span) {
        let Some(expr) = self.take_bit(input, span) else {
            return;
        };
        let Some(block) = &mut self.block else { return };
        let timer = block
            .block
            .as_ref()
            .is_some_and(|(_, block)| block.is_timer());
        let wrong = match input {
            "IN" => !timer,
            "CU" | "CD" | "S" => timer,
            _ => false,
        };
        if wrong {
            let has: (&str, &str) = match timer {
                true => ("its inputs are IN and R", "as entradas são IN e R"),
                false => (
                    "its inputs are CU, CD, R and S",
                    "as entradas são CU, CD, R e S",
                ),
            };
            let words = [block.name.as_str().into(), input.into(), has.into()];
            return self.tell(Code::NoSuchParameter, span, words);
        }
        let place = match input {
            "IN" | "CU" => &mut block.start,
            "CD" => &mut block.down,
            "S" => &mut block.set,
            _ => &mut block.reset,
        };
        *place = Some(expr);
        self.run.acc = Acc::Empty;
    }

    /// `IN`, `CU`, `CD`: within a block, or with the timer or counter as operand.
    pub(super) fn input_operator(&mut self, instr: &Instr, opcode: Opcode) {
        let word = match opcode {
            Opcode::CountUp => "CU",
            Opcode::CountDown => "CD",
            Opcode::RisingEdge => "CLK",
            _ => "IN",
        };
        let Some(operand) = instr.operands.first() else {
            if self.block.is_none() || word == "CLK" {
                return self.missing(word, instr.span);
            }
            return self.wire(word, instr.span);
        };
        self.only(instr, 1);
        let Some(bit) = self.take_bit(word, instr.span) else {
            return;
        };
        let span = instr.whole;
        match (self.meaning(operand), word) {
            (Is::Block(target, block), "IN") if block.is_timer() => {
                if let Some(preset) = self.declared_preset(operand, span) {
                    self.start_timer(operand, &target, Some(bit), preset, span);
                }
            }
            (Is::Block(target, block), "CU" | "CD") if block.is_counter() => {
                let preset = Some(self.declared_count(operand, span));
                let (up, down) = match word {
                    "CU" => (Some(bit), None),
                    _ => (None, Some(bit)),
                };
                let inputs = Inputs {
                    up,
                    down,
                    preset,
                    ..Inputs::default()
                };
                self.count(operand, &target, inputs, span);
            }
            (Is::Block(target, block), "CLK") if block.is_edge() => {
                self.run_block(&target, vec![named("CLK", bit)], span);
            }
            (Is::Wrong, _) => {}
            _ => self.not_callable(operand),
        }
        self.run.acc = Acc::Empty;
    }

    pub(super) fn out_block(&mut self, instr: &Instr) {
        match &self.block {
            Some(block) if !block.written => self.write_block(),
            _ => self.misplaced("OUT_BLK", instr.span),
        }
        self.run.acc = Acc::Empty;
    }

    pub(super) fn end_block(&mut self, instr: &Instr) {
        match &self.block {
            Some(block) if !block.written => self.write_block(),
            Some(_) => {}
            None => self.misplaced("END_BLK", instr.span),
        }
        self.warn_unused();
        self.block = None;
        self.run.acc = Acc::Empty;
    }

    fn misplaced(&mut self, word: &str, span: Span) {
        let why = ("it belongs after a BLK", "ele vem depois de um BLK");
        self.tell(Code::Structure, span, [word.into(), why.into()]);
    }

    /// Where a body ends or another block begins.
    pub(super) fn end_of_blocks(&mut self) {
        if let Some(block) = self.block.take() {
            let why = ("write END_BLK after it", "escreva END_BLK depois dele");
            self.tell(Code::Structure, block.span, ["BLK".into(), why.into()]);
        }
    }

    /// Before something changes: what is connected already is put aside.
    pub(super) fn before_block(&mut self, changes: &Changes) {
        let Some(mut block) = self.block.take() else {
            return;
        };
        let inputs = [
            &mut block.start,
            &mut block.down,
            &mut block.reset,
            &mut block.set,
        ];
        for input in inputs {
            if let Some(expr) = input.take() {
                *input = Some(match self.may_read(&expr, changes) {
                    true => self.aside(expr),
                    false => expr,
                });
            }
        }
        self.block = Some(block);
    }

    fn write_block(&mut self) {
        let Some(block) = &mut self.block else { return };
        block.written = true;
        self.run.unused = None;
        let (operand, span, name) = (block.operand.clone(), block.span, block.name.clone());
        let (start, down) = (block.start.take(), block.down.take());
        let (reset, set) = (block.reset.take(), block.set.take());
        self.run.acc = Acc::Empty;
        let Some((target, standard)) = block.block.clone() else {
            return;
        };
        let declared = match standard.is_timer() {
            true => self.preset_of_timer(&operand),
            false => self.preset_of_counter(&operand),
        };
        let (assumed, said, example) = match standard.is_timer() {
            true => (TIMER_PRESET, "9999 min", "TON := T#20s;"),
            false => (COUNTER_PRESET, "9999", "CTU := 20;"),
        };
        let preset = declared.unwrap_or_else(|| {
            let words = [name.as_str().into(), said.into(), example.into()];
            self.tell(Code::PresetAssumed, span, words);
            assumed
        });
        let preset = Preset::Given(self.whole(preset, span));
        if !standard.is_timer() {
            let inputs = Inputs {
                up: start,
                down,
                reset,
                load: set,
                preset: Some(preset),
            };
            return self.count(&operand, &target, inputs, span);
        }
        let Some(start) = start else {
            let needs = ("a value for its input IN", "um valor na entrada IN");
            return self.tell(Code::ParameterMissing, span, [name.into(), needs.into()]);
        };
        self.start_timer(&operand, &target, Some(start), preset, span);
        if let Some(reset) = reset {
            let order = self.order(&target, Order::Reset, span);
            let kind = StmtKind::If(vec![(reset, order.into_iter().collect())], Vec::new());
            self.push(Stmt { kind, at: span });
        }
    }
}
