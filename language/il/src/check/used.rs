//! What a text does with its timers and counters: of which kind each is, and which preset its calls give.

use crate::ast::{Instr, Operand, Stmt, Unit};
use crate::operators::Op;
use std::borrow::Cow;
use std::collections::BTreeMap;
use unoclp_core::isa::Opcode;
use unoclp_point::{Kind, read};
use unoclp_text::Dialect;

/// The preset of a Twido's counter that nothing says.
pub(super) const COUNTER_PRESET: i32 = 9999;

/// What is done with one of them.
#[derive(Clone, Debug, Default)]
pub(super) struct Uses {
    /// The kind of timer that an operator says.
    pub timer: Option<Opcode>,
    /// What its calls give as its preset, of a counter; none of what is no constant.
    presets: Vec<Option<i32>>,
}

/// All of them, by their names.
#[derive(Debug, Default)]
pub(super) struct Used {
    of: BTreeMap<String, Uses>,
}

/// The block that a name means, and the part of it: `T1.PT`, `%C2`.
pub(super) fn parts(name: &str, dialect: Dialect) -> (Cow<'_, str>, Option<&str>) {
    let block = |kind| matches!(kind, Kind::Timer | Kind::Counter);
    match read(name, dialect.maker()) {
        Some(written) if block(written.kind) && written.number.is_some() => {
            (written.name().into(), written.member)
        }
        _ => match name.split_once('.') {
            Some((block, member)) => (block.into(), Some(member)),
            None => (name.into(), None),
        },
    }
}

impl Used {
    pub(super) fn of(units: &[Unit], dialect: Dialect) -> Used {
        let mut used = Used::default();
        for unit in units {
            for stmt in &unit.body {
                if let Stmt::Instr(instr) = stmt {
                    used.note(instr, dialect);
                }
            }
        }
        used
    }

    /// What is done with the block of this name.
    pub(super) fn get(&self, name: &str) -> Uses {
        self.of.get(name).cloned().unwrap_or_default()
    }

    /// The names, in order.
    pub(super) fn names(&self) -> Vec<String> {
        self.of.keys().cloned().collect()
    }

    fn entry(&mut self, operand: &Operand, dialect: Dialect) -> Option<&mut Uses> {
        let (block, _) = parts(operand.name()?, dialect);
        if !self.of.contains_key(&*block) {
            self.of.insert(block.to_string(), Uses::default());
        }
        self.of.get_mut(&*block)
    }

    fn note(&mut self, instr: &Instr, dialect: Dialect) {
        for operand in &instr.operands {
            self.entry(operand, dialect);
        }
        for param in &instr.params {
            self.entry(&param.value, dialect);
        }
        let Some((first, others)) = instr.operands.split_first() else {
            return;
        };
        let Some(uses) = self.entry(first, dialect) else {
            return;
        };
        let number = |operand: Option<&Operand>| operand.and_then(Operand::number);
        match instr.op {
            Op::Timer(kind) => uses.timer = Some(kind),
            Op::OmronTimer => uses.timer = Some(Opcode::OnDelay),
            Op::Store if instr.starts_block() => {
                uses.presets.push(number(others.first()));
                if is_fx_retentive(first) {
                    uses.timer = Some(Opcode::RetentiveOnDelay);
                }
            }
            Op::CountUp | Op::CountDown | Op::CountUpDown if !others.is_empty() => {
                uses.presets.push(number(others.last()));
            }
            Op::OmronCounter => uses.presets.push(number(others.first())),
            Op::Block => uses.presets.push(Some(COUNTER_PRESET)),
            Op::Call => {
                let given = instr.params.iter().enumerate().find(|(index, param)| {
                    let named = param.name.as_ref().map(|name| name.text.as_str());
                    named == Some("PV") || named.is_none() && *index == 2
                });
                let given = given.map(|(_, param)| &param.value).or(others.get(2));
                if given.is_some() {
                    uses.presets.push(number(given));
                }
            }
            _ => {}
        }
    }
}

impl Uses {
    /// The preset that all calls give alike.
    pub(super) fn preset(&self) -> Option<i32> {
        let first = *self.presets.first()?;
        first.filter(|_| self.presets.iter().all(|one| *one == first))
    }
}

/// Whether it keeps its elapsed time until RST, as Mitsubishi's do from T246 on.
fn is_fx_retentive(timer: &Operand) -> bool {
    let name = timer.name().unwrap_or_default();
    let number = name.trim_start_matches(|c: char| !c.is_ascii_digit());
    name.contains('T') && matches!(number.parse::<u32>(), Ok(246..=255))
}
