//! What a text does with its timers and counters: of which kind each is, and which inputs and outputs of it count.

use crate::Dialect;
use crate::ast::{Instr, Operand, Stmt, Unit};
use crate::operators::Op;
use std::collections::BTreeMap;
use unoclp_core::isa::Opcode;
use unoclp_point::{Kind, read};

/// What is done with one of them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Uses {
    /// The kind of timer that an operator says.
    pub timer: Option<Opcode>,
    pub up: bool,
    pub down: bool,
    pub reset: bool,
    pub load: bool,
}

/// All of them, by their names.
#[derive(Debug, Default)]
pub(super) struct Used {
    of: BTreeMap<String, Uses>,
}

/// The block that a name means, and the part of it: `T1.PT`, `%C2`.
pub(super) fn parts(name: &str, dialect: Dialect) -> (String, Option<&str>) {
    let block = |kind| matches!(kind, Kind::Timer | Kind::Counter);
    match read(name, dialect.maker()) {
        Some(written) if block(written.kind) && written.number.is_some() => {
            (written.name(), written.member)
        }
        _ => match name.split_once('.') {
            Some((block, member)) => (block.to_owned(), Some(member)),
            None => (name.to_owned(), None),
        },
    }
}

impl Used {
    pub(super) fn of(units: &[Unit], dialect: Dialect) -> Used {
        let mut used = Used::default();
        for unit in units {
            let mut block = None;
            for stmt in &unit.body {
                if let Stmt::Instr(instr) = stmt {
                    used.note(instr, &mut block, dialect);
                }
            }
        }
        used
    }

    /// What is done with the block of this name.
    pub(super) fn get(&self, name: &str) -> Uses {
        self.of.get(name).copied().unwrap_or_default()
    }

    /// The names, in order.
    pub(super) fn names(&self) -> Vec<String> {
        self.of.keys().cloned().collect()
    }

    fn entry(&mut self, operand: &Operand, dialect: Dialect) -> Option<&mut Uses> {
        let (block, member) = parts(operand.name()?, dialect);
        let uses = self.of.entry(block).or_default();
        uses.note_part(member.unwrap_or_default());
        Some(uses)
    }

    fn note(&mut self, instr: &Instr, block: &mut Option<String>, dialect: Dialect) {
        for operand in &instr.operands {
            self.entry(operand, dialect);
        }
        for param in &instr.params {
            self.entry(&param.value, dialect);
        }
        let Some(first) = instr.operands.first() else {
            let within = block.as_ref().and_then(|name| self.of.get_mut(name));
            if let Some(uses) = within {
                match instr.op {
                    Op::Input(Opcode::CountUp) => uses.up = true,
                    Op::Input(Opcode::CountDown) => uses.down = true,
                    Op::Set => uses.load = true,
                    Op::Reset => uses.reset = true,
                    _ => {}
                }
            }
            return;
        };
        let stacked = dialect == Dialect::S7200 && instr.operands.len() == 2;
        let controlled = stacked || instr.operands.len() == 3;
        let Some(uses) = self.entry(first, dialect) else {
            return;
        };
        match instr.op {
            Op::Timer(kind) => uses.timer = Some(kind),
            Op::OmronTimer => uses.timer = Some(Opcode::OnDelay),
            Op::CountUp => {
                uses.up = true;
                uses.reset |= controlled;
            }
            Op::CountDown => {
                uses.down = true;
                uses.load |= controlled;
            }
            Op::CountUpDown => {
                uses.up = true;
                uses.down |= stacked;
                uses.reset |= controlled;
            }
            Op::OmronCounter => (uses.up, uses.reset) = (true, true),
            Op::Store if instr.starts_block() => uses.up = true,
            Op::Input(Opcode::CountUp) => uses.up = true,
            Op::Input(Opcode::CountDown) => uses.down = true,
            Op::Set => uses.load = true,
            Op::Reset => uses.reset = true,
            Op::Call => {
                let named = instr.params.iter().filter_map(|param| param.name.as_ref());
                named.for_each(|name| uses.note_part(&name.text));
            }
            Op::Block => *block = first.name().map(|name| parts(name, dialect).0),
            _ => {}
        }
    }
}

impl Uses {
    fn note_part(&mut self, part: &str) {
        match part {
            "CU" | "QU" => self.up = true,
            "CD" | "QD" => self.down = true,
            "R" | "RESET" => self.reset = true,
            "LD" | "LOAD" => self.load = true,
            _ => {}
        }
    }
}
