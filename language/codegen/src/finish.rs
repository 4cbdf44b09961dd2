//! From instructions to the lines of a program file.
//!
//! Owns the numbers of labels and timers, what the jumps of loops cost, and what stands before the program: what is kept,
//! and first values. Must not know statements.

use super::coder::Coder;
use super::codes;
use super::flat::Turns;
use super::pen::{Line, Written};
use super::seats::Seat;
use crate::emit::{CodeLine, letters};
use crate::origin::Origin;
use std::collections::{HashMap, HashSet};
use unoclp_core::isa::{self, JUMP_BUDGET, Opcode, Operand, Value};
use unoclp_core::{Board, Instruction, Target, TimerBlock};
use unoclp_point::Address;
use unoclp_text::Dialect;
use unoclp_text::diagnostics::{Code, Found, Lines, Span};
use unoclp_tree::Tree;

impl Coder<'_, '_> {
    /// First values, in the first scan after each start; of what is kept only where nothing is kept.
    pub(super) fn first_values(&mut self, tree: &Tree) {
        let mut own: Vec<(Seat, i32, u32)> = Vec::new();
        let mut kept = Vec::new();
        let names = super::allotter::named(tree);
        let points: HashSet<u32> = tree.points.iter().map(|(cell, _)| *cell).collect();
        for (number, cell) in (0..).zip(&tree.cells) {
            let value = super::operand::bits(&cell.initial, cell.base);
            let seat = self.seats.of.get(&number).copied();
            let seat = seat.filter(|_| {
                let is_seen = points.contains(&number) || self.is_used(number);
                (value != 0 || tree.begun.contains(&number)) && is_seen
            });
            let Some(seat) = seat.filter(|seat| is_settable(*seat)) else {
                continue;
            };
            match cell.retain {
                true => kept.push((seat, value, number)),
                false => own.push((seat, value, number)),
            }
        }
        own.sort_by_key(|(seat, value, number)| {
            (
                matches!(seat, Seat::At(Address::Register(_))),
                *value,
                *number,
            )
        });
        kept.sort_by_key(|(_, value, number)| (*value, *number));
        if !kept.is_empty()
            && let Some(Seat::At(Address::Register(flag))) = self.seats.lasting(false)
        {
            self.seats.kept_registers.push(flag);
            self.declared(&kept, &names);
            self.pen.fresh();
            self.pen
                .operation(Opcode::Load, Value::Register(flag), None);
            self.pen.operation(Opcode::Equal, Value::Constant(0), None);
            self.pen.acc = super::pen::Acc::Other;
            self.set_all(&kept, &names);
            self.pen.operation(Opcode::Load, Value::Constant(1), None);
            self.pen.numbered(Opcode::Store, flag, None);
        }
        if !own.is_empty() {
            self.declared(&own, &names);
            self.pen.fresh();
            self.pen.numbered(Opcode::SystemContact, 1, None);
            self.pen.acc = super::pen::Acc::Other;
            self.set_all(&own, &names);
        }
        self.pen.holds = None;
    }

    /// Where the program ends: what jumps there leaves it, which takes no label.
    pub(super) fn leave(&mut self) {
        let lines = &mut self.pen.lines;
        let Some(Line {
            written: Written::Label(label),
            ..
        }) = lines.last()
        else {
            return;
        };
        let label = *label;
        if !self.flat.leaves.contains(&label) {
            return;
        }
        lines.pop();
        if matches!(lines.last(), Some(line) if matches!(&line.written, Written::Is(is) if is.opcode == Opcode::NewRung))
        {
            lines.pop();
        }
        for line in lines {
            if let Written::Jump(opcode, to, None) = line.written
                && to == label
            {
                let leaves = match opcode {
                    Opcode::JumpNot => Opcode::ReturnNot,
                    _ => Opcode::Return,
                };
                line.written = Written::Is(Instruction::plain(leaves));
            }
        }
    }

    fn is_used(&self, cell: u32) -> bool {
        self.uses.get(cell).is_some() || self.uses.row_of(cell).is_some()
    }

    /// What is written next comes from the declaration of the first of these.
    fn declared(&mut self, all: &[(Seat, i32, u32)], names: &HashMap<u32, (String, Span)>) {
        if let Some((_, at)) = all.first().and_then(|(_, _, cell)| names.get(cell)) {
            self.pen.at = *at;
        }
    }

    /// Stores where acc is 1.
    fn set_all(&mut self, all: &[(Seat, i32, u32)], names: &HashMap<u32, (String, Span)>) {
        let mut held = None;
        for &(seat, value, cell) in all {
            if let Some((_, at)) = names.get(&cell) {
                self.pen.at = *at;
            }
            let bit = match seat {
                Seat::At(Address::Marker(n)) => Some((Opcode::SetMarker, n)),
                Seat::At(Address::Output(n)) => Some((Opcode::SetCoil, n)),
                _ => None,
            };
            let bit = match (bit, value) {
                (Some((Opcode::SetMarker, n)), 0) => Some((Opcode::ResetMarker, n)),
                (Some((Opcode::SetCoil, n)), 0) => Some((Opcode::ResetCoil, n)),
                (bit, _) => bit,
            };
            if let Some((opcode, number)) = bit {
                self.pen.numbered(opcode, number, Some(cell));
                continue;
            }
            if held != Some(value) {
                self.pen
                    .operation(Opcode::Load, Value::Constant(value), None);
                held = Some(value);
            }
            self.store(cell);
        }
    }
}

/// Whether a program can give it a first value.
fn is_settable(seat: Seat) -> bool {
    matches!(
        seat,
        Seat::At(
            Address::Register(_)
                | Address::Marker(_)
                | Address::Output(_)
                | Address::Pwm(_)
                | Address::Group(_)
                | Address::Outputs(_)
                | Address::Count(_)
        )
    )
}

/// What stands at its end: the lines, where each comes from, and each timer's number.
pub(super) struct Finished {
    pub lines: Vec<CodeLine>,
    pub origins: Vec<Origin>,
    pub timers: Vec<u8>,
}

impl Finished {
    /// In the program file, each instruction with a number is called as the text has it; elsewhere a point has the name
    /// that was declared for it, and what is no name has none.
    pub(super) fn named_as_written(&mut self, text: &str, dialect: Dialect) {
        for (line, origin) in self.lines.iter_mut().zip(&mut self.origins) {
            let is_name = |name: &String| !name.contains('.') && !dialect.is_address(name);
            origin.name = origin.name.take().filter(is_name);
            if !line.symbol.is_empty() || line.letters.contains(|c: char| c.is_ascii_digit()) {
                let written = text.get(origin.span.range()).unwrap_or_default();
                let first = written.lines().next().unwrap_or_default().trim();
                line.symbol = first.to_owned();
            }
        }
    }
}

pub(super) fn finish(
    coder: &Coder<'_, '_>,
    tree: &Tree,
    text: &str,
    (loops, board): (&[Turns], Board),
    found: &mut Found,
) -> Finished {
    let starts = Lines::new(text);
    let names = super::allotter::named(tree);
    let mut timers = vec![0; coder.seats.timers.len()];
    let labels = number_labels(coder, board, found);
    let mut number = 0_u8;
    for (at, line) in coder.pen.lines.iter().enumerate() {
        let behind = coder.pen.lines.get(at + 2);
        match line.written {
            Written::Timer(_, timer, ..) => {
                number = number.saturating_add(1);
                if let Some(held) = timers.get_mut(timer) {
                    *held = number;
                }
            }
            Written::Code(code) if codes::is_timer(code) && !calls_again(behind) => {
                number = number.saturating_add(1);
            }
            _ => {}
        }
    }
    cost(&coder.pen.lines, loops, found);
    let mut lines = vec![CodeLine {
        code: isa::START,
        letters: "program start".to_owned(),
        symbol: String::new(),
        source: None,
    }];
    let mut origins = vec![Origin::default()];
    let kept = kept(coder, tree, &names);
    let label = |label: &u32| labels.get(label).copied().unwrap_or(1);
    let timer = |index: usize| timers.get(index).copied().unwrap_or(1).max(1);
    for line in kept.iter().chain(&coder.pen.lines) {
        let instruction = match &line.written {
            Written::Code(code) => {
                lines.push(CodeLine {
                    code: *code,
                    letters: String::new(),
                    symbol: String::new(),
                    source: Some(starts.line(line.at.start)),
                });
                let (span, name) = (line.at, None);
                origins.push(Origin { span, name });
                continue;
            }
            Written::Is(instruction) => *instruction,
            Written::Label(number) => Instruction::numbered(Opcode::Label, label(number)),
            Written::Jump(opcode, number, _) => Instruction {
                opcode: *opcode,
                operand: Operand::Jump {
                    label: label(number),
                    line: 0,
                },
            },
            Written::Timer(opcode, _, preset, target) => Instruction {
                opcode: *opcode,
                operand: match target {
                    Some(target) => Operand::Timer(TimerBlock {
                        preset: preset.cast_unsigned(),
                        target: *target,
                    }),
                    None => Operand::None,
                },
            },
            Written::Again(opcode, index, preset) => Instruction {
                opcode: *opcode,
                operand: Operand::Timer(TimerBlock {
                    preset: preset.cast_unsigned(),
                    target: Target::Timer(timer(*index)),
                }),
            },
            Written::OfTimer(opcode, index) => Instruction::numbered(*opcode, timer(*index)),
        };
        let name = line.cell.and_then(|cell| names.get(&cell));
        let name = name.map(|(name, _)| match instruction.operand {
            // A box stands for the whole block: `pause`, not `pause.IN`.
            Operand::Timer(_) | Operand::Count { .. } => {
                let block = name.rsplit_once('.').map(|(block, _)| block);
                block.unwrap_or(name).to_owned()
            }
            _ => name.clone(),
        });
        for (at, code) in instruction.codes().enumerate() {
            let first = at == 0;
            let own = |text: String| if first { text } else { String::new() };
            lines.push(CodeLine {
                code,
                letters: own(letters(instruction)),
                symbol: own(name.clone().unwrap_or_default()),
                source: Some(starts.line(line.at.start)),
            });
            origins.push(Origin {
                span: line.at,
                name: name.clone().filter(|_| first),
            });
        }
    }
    Finished {
        lines,
        origins,
        timers,
    }
}

/// Whether a timer's block that the text says, whose last line this is, calls another again.
fn calls_again(line: Option<&Line>) -> bool {
    line.is_some_and(|line| matches!(line.written, Written::Code(code) if codes::is_call(code)))
}

/// What is kept, each where it is declared, in that order; the register that says whether anything is comes last.
fn kept(coder: &Coder<'_, '_>, tree: &Tree, names: &HashMap<u32, (String, Span)>) -> Vec<Line> {
    let seats = &coder.seats;
    let registers: HashMap<u8, u32> = seats
        .of
        .iter()
        .filter_map(|(cell, seat)| match seat {
            Seat::At(Address::Register(register)) => Some((*register, *cell)),
            _ => None,
        })
        .filter(|(_, cell)| {
            tree.cells
                .get(*cell as usize)
                .is_some_and(|held| held.retain)
        })
        .collect();
    let counters: HashMap<u8, u32> = seats
        .counters
        .iter()
        .map(|(cell, number)| (*number, *cell))
        .collect();
    let keeps = |opcode, number: u8, cell: Option<&u32>| Line {
        written: Written::Is(Instruction::numbered(opcode, number)),
        at: cell
            .and_then(|cell| names.get(cell))
            .map_or(Span::default(), |(_, at)| *at),
        cell: None,
    };
    let of_registers = seats.kept_registers.iter();
    let of_counters = seats.kept_counters.iter();
    let mut kept: Vec<Line> = of_registers
        .map(|number| keeps(Opcode::KeepRegister, *number, registers.get(number)))
        .chain(of_counters.map(|number| keeps(Opcode::KeepCounter, *number, counters.get(number))))
        .collect();
    kept.sort_by_key(|line| (line.at == Span::default(), line.at.start));
    kept
}

/// The number of each label of the program.
fn number_labels(coder: &Coder<'_, '_>, board: Board, found: &mut Found) -> HashMap<u32, u8> {
    let mut numbers = HashMap::new();
    // Labels that the text writes as codes keep their numbers.
    let written = coder
        .pen
        .lines
        .iter()
        .filter_map(|line| match line.written {
            Written::Code(code) => unoclp_tree::codes::label(code),
            _ => None,
        });
    let used: HashSet<u8> = written.collect();
    let mut free = (1..=board.labels).filter(|number| !used.contains(number));
    let lines = coder.pen.lines.iter();
    let of_the_tree = lines.filter_map(|line| match line.written {
        Written::Label(label) => Some((label, line.at)),
        _ => None,
    });
    for (label, at) in of_the_tree {
        let Some(number) = free.next() else {
            let most = board.labels.to_string();
            found.tell(Code::BoardLabels, at, [most.into()]);
            break;
        };
        numbers.insert(label, number);
    }
    numbers
}

/// What the jumps back of each loop cost in a scan (NC-19).
fn cost(lines: &[Line], loops: &[Turns], found: &mut Found) {
    let sizes: Vec<u128> = lines.iter().map(|line| size(line).into()).collect();
    let mut labels: HashMap<u32, usize> = HashMap::new();
    let mut costs = vec![0_u128; loops.len()];
    for (at, line) in lines.iter().enumerate() {
        match line.written {
            Written::Label(label) => {
                labels.insert(label, at);
            }
            Written::Jump(_, label, Some(number)) => {
                if let (Some(&from), Some(cost)) = (labels.get(&label), costs.get_mut(number)) {
                    // One of its jumps is made in each turn, the dearest at worst.
                    *cost = (*cost).max(sizes[from..=at].iter().sum());
                }
            }
            _ => {}
        }
    }
    let budget = u128::from(JUMP_BUDGET);
    let mut all = 0;
    for (turns, cost) in loops.iter().zip(&costs) {
        let mut jumps = turns.jumps;
        let mut outer = turns.outer;
        while let Some(around) = outer.and_then(|number| loops.get(number)) {
            // Each turn around it begins it again; there is one turn more than jumps at most.
            jumps = jumps
                .zip(around.jumps)
                .map(|(a, b)| a.saturating_mul(b.saturating_add(1)));
            outer = around.outer;
        }
        let most = (budget / (*cost).max(1)).to_string();
        match jumps {
            None => found.tell(Code::BoardLoopOpen, turns.at, [most.into()]),
            Some(jumps) => {
                let whole = jumps.saturating_mul(*cost);
                all += whole;
                if all > budget {
                    let words = [
                        all.to_string().into(),
                        budget.to_string().into(),
                        most.into(),
                    ];
                    found.tell(Code::BoardLoop, turns.at, words);
                    return;
                }
            }
        }
    }
}

/// Stored bytes, each constant counted as 4.
fn size(line: &Line) -> u32 {
    match &line.written {
        Written::Label(_) | Written::OfTimer(..) | Written::Code(_) => 2,
        Written::Jump(..) => 2 + 2,
        Written::Timer(..) | Written::Again(..) => 6,
        Written::Is(Instruction { opcode, operand }) => match operand {
            Operand::Value(Value::Constant(_)) | Operand::Count { .. } => 6,
            Operand::Table { .. } => 3,
            Operand::Move { .. } => 4,
            Operand::None => 1,
            Operand::Number(number)
                if isa::holds_point(*opcode as u8) && *number <= isa::POINTS =>
            {
                1
            }
            _ => 2,
        },
    }
}
