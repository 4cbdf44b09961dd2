//! From the syntax tree to codes: a run of the program on expressions in place of values.
//!
//! `values` tells what operands are worth; `bits`, `defer`, `stack` and `branches` have what works on the accumulator,
//! `stores` what writes, `jumps` and `carry` labels and the accumulator over them; `calls` leads to `timers`,
//! `counters`, `blocks` and `units`, the text's own functions: what is new at each call is in `fresh`, what is
//! called more than once in `again`. `keep` says when an expression is written out, `widths` what a number keeps.

mod again;
mod bits;
mod blocks;
mod branches;
mod calls;
mod carry;
mod counters;
mod defer;
mod finish;
mod fresh;
mod jumps;
mod keep;
mod latches;
mod makers;
mod parts;
mod push;
mod run;
mod said;
mod shared;
mod stack;
mod stores;
mod timers;
mod units;
mod values;
mod widths;

use crate::ast::{Instr, Stmt, Unit, UnitKind};
use crate::diagnostics::{Code, Found, Span};
use crate::names::Names;
use crate::operators::Op;
use crate::rung::{Holds, Rungs, Written};
use crate::tree::{Expr, Number};
use again::{Again, Calls};
pub(crate) use run::{Lowered, lower};
use std::collections::{HashMap, HashSet};
use unoclp_core::isa::{DEEPEST, Opcode};

/// What the accumulator of the text holds.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Acc {
    /// Nothing has been loaded.
    Empty,
    Bit(Expr),
    Number(Number),
    /// Something was wrong, and has been told.
    Unknown,
}

/// An operation that waits for its `)`, or a result that an LD has pushed.
struct Frame {
    acc: Acc,
    waiting: Waiting,
    span: Span,
    links: u32,
}

/// See [`Frame`].
#[derive(Clone, Copy)]
enum Waiting {
    /// For `)`, with N where the result is inverted.
    Deferred(Op, bool),
    /// For ALD, OLD, or a block with more than one input.
    Pushed,
}

/// A unit that is being compiled into its caller.
struct Scope {
    unit: usize,
    instance: usize,
    labels: HashMap<String, usize>,
    /// Labels that a jump of the unit leads to.
    wanted: HashSet<String>,
    /// Labels after which the accumulator is used as it comes.
    needs: HashSet<String>,
    /// Where RET leads; of the program it ends the scan.
    end: Option<usize>,
    /// The call that it is compiled for.
    call: Option<Span>,
}

/// A label of the board.
pub(crate) struct Label {
    /// What its name asks for: `L07` is label 07.
    pub number: Option<u8>,
    pub span: Span,
    /// Where the accumulator is, if it is needed after the label.
    carry: Option<carry::Carry>,
}

/// More steps than this are never written: no board holds them, and functions that call functions could
/// make them without end.
const MOST_STEPS: usize = 40_000;
/// Likewise calls, which may have nothing to write; and how deep they may go.
const MOST_CALLS: u32 = 5_000;
const MOST_SCOPES: usize = 16;
/// Operations in one expression, before a part of it is written out.
const MOST_LINKS: u32 = 40;

pub(crate) struct Lower<'a, 'f> {
    units: &'a [Unit],
    pub names: Names<'a>,
    pub rungs: Rungs,
    pub found: &'f mut Found,
    pub labels: Vec<Label>,
    acc: Acc,
    /// Operations in the accumulator's expression.
    links: u32,
    frames: Vec<Frame>,
    /// Parentheses that are open, and whose operations are lost to an error.
    lost: usize,
    /// Operations that wait in the callers, whose intermediate results are still needed.
    waiting: usize,
    scopes: Vec<Scope>,
    /// The block between BLK and END_BLK.
    block: Option<blocks::Block>,
    /// What MPS has kept, the last one on top, and where.
    kept: Vec<(Acc, Span)>,
    /// The load whose result nothing has used yet.
    unused: Option<Span>,
    /// Nothing comes here.
    unreachable: bool,
    /// N after a parenthesis, for the load that follows.
    invert_load: bool,
    called: HashSet<usize>,
    /// Calls of functions and function blocks so far.
    calls: u32,
    functions: HashMap<String, usize>,
    function_instances: HashMap<usize, usize>,
    coils: HashMap<u8, Span>,
    again: Again,
    counted: Calls,
    /// Something is stored.
    writes: bool,
    /// The parenthesis of which it has been told that something cannot stand in it.
    told_open: Option<Span>,
    /// The IFs that are open in this unit, and whether their ELSE has come.
    ifs: Vec<(Span, bool)>,
    /// How many values are pushed.
    pushed: u8,
    /// That there are too many steps has been told.
    full: bool,
}

impl<'a> Lower<'a, '_> {
    /// The body of a unit, in place, for this call.
    fn unit_body(&mut self, unit: usize, instance: usize, end: Option<usize>, call: Option<Span>) {
        let units = self.units;
        let body = &units[unit].body;
        let scope = self.scope(unit, instance, end);
        self.scopes.push(Scope { call, ..scope });
        let frames = std::mem::take(&mut self.frames);
        let lost = std::mem::take(&mut self.lost);
        let block = self.block.take();
        let kept = std::mem::take(&mut self.kept);
        let ifs = std::mem::take(&mut self.ifs);
        let waits = frames.len() + kept.len() + usize::from(block.is_some());
        self.waiting += waits;
        self.acc = Acc::Empty;
        self.unused = None;
        self.unreachable = false;
        let pushed = stack::pushes(body, self.names.dialect);
        for (index, stmt) in body.iter().enumerate() {
            let next = body.get(index + 1);
            match stmt {
                Stmt::Label(word) => self.label(word),
                Stmt::Close(span) => self.close(*span),
                Stmt::Wrong { open, .. } => {
                    self.unused = None;
                    self.unreachable = false;
                    self.acc = Acc::Unknown;
                    self.lost += open;
                }
                Stmt::Instr(instr) => {
                    self.reachable(instr);
                    if pushed.contains(&index) {
                        self.push_result(instr.span);
                    }
                    self.instr(instr, next);
                }
            }
            // Names and intermediate results take from the same markers.
            self.none_left(stmt);
        }
        self.end_of_body();
        self.end_of_ifs();
        self.ifs = ifs;
        self.frames = frames;
        self.lost = lost;
        self.block = block;
        self.kept = kept;
        self.waiting -= waits;
        self.scopes.pop();
        self.unreachable = false;
    }

    fn none_left(&mut self, stmt: &Stmt) {
        let span = match stmt {
            Stmt::Label(word) => word.span,
            Stmt::Close(span) | Stmt::Wrong { span, .. } => *span,
            Stmt::Instr(instr) => instr.span,
        };
        let words = self.rungs.temps.none_left.take();
        if let Some(words) = words {
            self.found.tell(Code::NoneLeft, span, [words.into()]);
        }
        if let Some(span) = self.rungs.too_deep.take() {
            self.found.tell(Code::TooDeep, span, []);
        }
    }

    fn end_of_body(&mut self) {
        self.warn_unused();
        for frame in std::mem::take(&mut self.frames) {
            let told = self.told_open == Some(frame.span);
            if matches!(frame.waiting, Waiting::Deferred(..)) && !told {
                self.found.tell(Code::LeftOpen, frame.span, []);
            }
        }
        self.end_of_blocks();
        self.end_of_branches();
        self.acc = Acc::Empty;
    }

    fn reachable(&mut self, instr: &Instr) {
        // What begins a part or stands after it is reached in another way.
        let part = matches!(instr.op, Op::Part(Opcode::Else | Opcode::EndIf));
        if std::mem::take(&mut self.unreachable) && !part {
            self.found.tell(Code::Unreachable, instr.whole, []);
        }
    }

    fn instr(&mut self, instr: &'a Instr, next: Option<&Stmt>) {
        if self.rungs.steps.len() > MOST_STEPS {
            if !std::mem::replace(&mut self.full, true) {
                let most = [self.names.board.stored_bytes, self.names.board.linked_bytes];
                let [stored, linked] = most.map(|bytes| bytes.to_string().into());
                let words = [
                    stored,
                    linked,
                    ("; many bytes are lacking", "; faltam muitos bytes").into(),
                ];
                self.found.tell(Code::DoesNotFit, instr.whole, words);
            }
            return;
        }
        match instr.op {
            Op::Load => self.load(instr),
            Op::Store => self.store(instr, next),
            Op::OmronTimer => self.omron_timer(instr, next),
            Op::OmronCounter => self.omron_counter(instr),
            Op::Keep => self.keep_result(instr.whole),
            Op::Recall | Op::Release => self.recall_result(instr),
            Op::Differentiate(opcode) => self.differentiate(instr, opcode, next),
            Op::Set | Op::Reset => self.set_or_reset(instr),
            Op::Not => self.not(instr),
            Op::And | Op::Or | Op::Xor | Op::Number(_) | Op::Compare(_) => {
                self.operate(instr, next)
            }
            Op::Shift(opcode) => self.shift(instr, opcode),
            Op::Unary(opcode) => self.unary(instr, opcode),
            Op::Push => self.push(instr),
            Op::Table(opcode) => self.table(instr, opcode),
            Op::Part(opcode) => self.part(instr, opcode),
            Op::Edge(opcode) => self.edge(instr, opcode),
            Op::Jump => self.jump(instr),
            Op::Return => self.ret(instr),
            Op::End => self.end(instr, next),
            Op::Call => self.call(instr),
            Op::Function => self.function(instr),
            Op::Timer(opcode) => self.timer_operator(instr, opcode, next),
            Op::CountUp | Op::CountDown | Op::CountUpDown => self.count_operator(instr),
            Op::AndBlock | Op::OrBlock => self.pop_result(instr),
            Op::Block => self.begin_block(instr),
            Op::OutBlock => self.out_block(instr),
            Op::EndBlock => self.end_block(instr),
            // The parser has made a store of it.
            Op::Preset => {}
            Op::Input(opcode) => self.input_operator(instr, opcode),
            Op::Code => self.code(instr),
        }
    }

    fn warn_unused(&mut self) {
        if let Some(span) = self.unused.take() {
            self.found.tell(Code::ResultUnused, span, []);
        }
    }

    fn kind_of(&self, unit: usize) -> UnitKind {
        self.units[unit].kind
    }
}

/// Words in two languages.
type Words = (&'static str, &'static str);
const BOOL: Words = ("true or false (BOOL)", "verdadeiro ou falso (BOOL)");
const NUMBER: Words = ("a number", "um número");
const BLOCK: Words = ("a block", "um bloco");
/// What stands for the accumulator in messages.
const ACCUMULATOR: &str = "(acc)";
/// What stands for an operand.
const OPERAND: &str = "(operand)";
/// The deepest nesting of deferred operations.
const MOST_FRAMES: usize = DEEPEST as usize;

/// Whether a load comes next, so that the accumulator is needed no more.
fn loads(next: Option<&Stmt>) -> bool {
    matches!(next, Some(Stmt::Instr(instr)) if instr.op == Op::Load)
}

/// For the rungs: nothing is known of the accumulator.
fn forget(rungs: &mut Rungs) {
    rungs.holds = Holds::Other;
}

/// A numbered instruction.
fn numbered(opcode: Opcode, number: u8) -> Written {
    Written::Numbered(opcode, number)
}
