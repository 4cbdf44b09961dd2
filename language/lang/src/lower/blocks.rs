//! The Twido's blocks, `BLK %TM1 … OUT_BLK … END_BLK`, and inputs by operator: `CU C1`.

use super::counters::Inputs;
use super::timers::Preset;
use super::{Acc, Lower};
use crate::ast::{Instr, Operand};
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::tree::Expr;
use unoclp_core::isa::Opcode;

/// A block whose inputs are being connected.
pub(super) struct Block {
    place: Place,
    name: String,
    span: Span,
    /// IN, or CU.
    start: Option<Expr>,
    down: Option<Expr>,
    reset: Option<Expr>,
    set: Option<Expr>,
    /// It stands in the program; what follows uses its outputs.
    written: bool,
}

/// The preset of a Twido's timer that nothing says: 9999 minutes, in ms.
const TIMER_PRESET: i32 = 9999 * 60_000;
/// Likewise of a counter.
const COUNTER_PRESET: i32 = 9999;

impl Lower<'_, '_> {
    pub(super) fn begin_block(&mut self, instr: &Instr) {
        self.end_of_blocks();
        self.warn_unused();
        self.acc = Acc::Empty;
        let Some(operand) = instr.operands.first() else {
            return self.missing("BLK", instr.span);
        };
        self.only(instr, 1);
        let place = self.place(operand);
        let name = self.spelled(operand);
        if !matches!(place, Place::Timer(_) | Place::Counter(_) | Place::Unknown) {
            self.not_callable(operand);
        }
        self.block = Some(Block {
            place,
            name,
            span: instr.whole,
            start: None,
            down: None,
            reset: None,
            set: None,
            written: false,
        });
    }

    /// An operand without a point within a block is the block's: `LD Q`.
    pub(super) fn block_member(&mut self, operand: &Operand) -> Option<Place> {
        let name = operand.name()?;
        let (place, block) = self
            .block
            .as_ref()
            .map(|block| (block.place, block.name.clone()))?;
        let members: &[&str] = match place {
            Place::Timer(_) => &["Q"],
            Place::Counter(_) => &["Q", "D"],
            _ => &[],
        };
        if !members.contains(&name) {
            return None;
        }
        Some(
            self.names
                .member(place, &block, name, operand.span, self.found),
        )
    }

    /// IN, CU, CD, R, S within a block: the accumulator is connected to that input.
    pub(super) fn wire(&mut self, input: &str, span: Span) {
        let Some(mut expr) = self.take_bit(input, span) else {
            return;
        };
        // What needs the board's accumulator as it stands does not wait.
        if expr.is_first() {
            self.freeze(span);
            expr = self.fixed_bit(expr, span);
        }
        let Some(block) = &mut self.block else { return };
        let timer = matches!(block.place, Place::Timer(_));
        let wrong = match input {
            "IN" => !timer,
            "CU" | "CD" | "S" => timer,
            _ => false,
        };
        if wrong {
            let has: (&str, &str) = match timer {
                true => ("it has IN and R", "tem IN e R"),
                false => ("it has CU, CD, R and S", "tem CU, CD, R e S"),
            };
            let name = block.name.clone();
            self.found.tell(
                Code::NoSuchParameter,
                span,
                [name.into(), input.into(), has.into()],
            );
            return;
        }
        let place = match input {
            "IN" | "CU" => &mut block.start,
            "CD" => &mut block.down,
            "S" => &mut block.set,
            _ => &mut block.reset,
        };
        *place = Some(expr);
        self.acc = Acc::Empty;
    }

    /// `IN`, `CU`, `CD`: within a block, or with the timer or counter as operand.
    pub(super) fn input_operator(&mut self, instr: &Instr, opcode: Opcode) {
        let word = if opcode == Opcode::CountUp {
            "CU"
        } else if opcode == Opcode::CountDown {
            "CD"
        } else if opcode == Opcode::RisingEdge {
            "CLK"
        } else {
            "IN"
        };
        let Some(operand) = instr.operands.first() else {
            if self.block.is_none() || word == "CLK" {
                return self.missing(word, instr.span);
            }
            return self.wire(word, instr.span);
        };
        self.only(instr, 1);
        let Some(expr) = self.take_bit(word, instr.span) else {
            return;
        };
        let span = instr.whole;
        match (self.place(operand), opcode) {
            (Place::Timer(timer), Opcode::OnDelay) => {
                let kind = self.names.timers[timer].kind.unwrap_or(Opcode::OnDelay);
                if let Some(preset) = self.declared_preset(timer, span) {
                    self.start_timer(timer, kind, expr, preset, span);
                }
            }
            (Place::Counter(counter), Opcode::CountUp | Opcode::CountDown) => {
                let preset = self.declared_count(counter, span);
                let up = opcode == Opcode::CountUp;
                let (up, down) = if up {
                    (Some(expr), None)
                } else {
                    (None, Some(expr))
                };
                if preset.is_some() {
                    let inputs = Inputs {
                        up,
                        down,
                        preset,
                        ..Inputs::default()
                    };
                    self.count(counter, inputs, span);
                }
            }
            (Place::Trigger(edge, marker), Opcode::RisingEdge) => {
                self.run_trigger(edge, marker, expr, span);
            }
            (Place::Unknown, _) => {}
            _ => self.not_callable(operand),
        }
        self.acc = Acc::Empty;
    }

    pub(super) fn out_block(&mut self, instr: &Instr) {
        match &self.block {
            Some(block) if !block.written => self.write_block(),
            _ => self.misplaced("OUT_BLK", instr.span),
        }
        self.acc = Acc::Empty;
    }

    pub(super) fn end_block(&mut self, instr: &Instr) {
        match &self.block {
            Some(block) if !block.written => self.write_block(),
            Some(_) => {}
            None => self.misplaced("END_BLK", instr.span),
        }
        self.warn_unused();
        self.block = None;
        self.acc = Acc::Empty;
    }

    fn misplaced(&mut self, word: &str, span: Span) {
        let why = ("it belongs after a BLK", "ele vem depois de um BLK");
        self.found
            .tell(Code::Structure, span, [word.into(), why.into()]);
    }

    /// Where a body ends or another block begins.
    pub(super) fn end_of_blocks(&mut self) {
        if let Some(block) = self.block.take() {
            let why = ("write END_BLK after it", "escreva END_BLK depois dele");
            self.found
                .tell(Code::Structure, block.span, ["BLK".into(), why.into()]);
        }
    }

    /// Before anything changes: what is connected already is worked out.
    pub(super) fn freeze_block(&mut self, span: Span) {
        let Some(mut block) = self.block.take() else {
            return;
        };
        let inputs = [
            &mut block.start,
            &mut block.down,
            &mut block.reset,
            &mut block.set,
        ];
        for input in inputs.into_iter().flatten() {
            *input = self.fixed_bit(input.clone(), span);
        }
        self.block = Some(block);
    }

    fn write_block(&mut self) {
        let Some(block) = &mut self.block else { return };
        block.written = true;
        self.unused = None;
        let (place, span, name) = (block.place, block.span, block.name.clone());
        let (start, down) = (block.start.take(), block.down.take());
        let (reset, set) = (block.reset.take(), block.set.take());
        match place {
            Place::Timer(timer) => {
                let kind = self.names.timers[timer].kind.unwrap_or(Opcode::OnDelay);
                let preset = self.names.timers[timer].preset.unwrap_or_else(|| {
                    let example = "TON := T#20s;";
                    let words = [name.as_str().into(), "9999 min".into(), example.into()];
                    self.found.tell(Code::PresetAssumed, span, words);
                    TIMER_PRESET
                });
                let Some(start) = start else {
                    let needs = ("its input, IN", "sua entrada, IN");
                    self.found
                        .tell(Code::ParameterMissing, span, [name.into(), needs.into()]);
                    return;
                };
                self.start_timer(timer, kind, start, Preset::Constant(preset), span);
                if let Some(reset) = reset {
                    self.rungs.logic(reset, span);
                    let written = self.rungs.of_timer(Opcode::ResetTimer, timer);
                    self.rungs.write(written, span);
                }
            }
            Place::Counter(counter) => {
                let preset = self.names.counters[counter].preset.unwrap_or_else(|| {
                    let words = [name.as_str().into(), "9999".into(), "CTU := 20;".into()];
                    self.found.tell(Code::PresetAssumed, span, words);
                    COUNTER_PRESET
                });
                let inputs = Inputs {
                    up: start,
                    down,
                    reset,
                    load: set,
                    preset: Some(Preset::Constant(preset)),
                };
                self.count(counter, inputs, span);
            }
            _ => {}
        }
        self.acc = Acc::Empty;
    }
}
