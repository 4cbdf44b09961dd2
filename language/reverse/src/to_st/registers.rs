//! What registers are: whole numbers or REAL numbers, and which of them stand in an array.
//!
//! Owns both questions. Must not know Structured Text's words.

use super::expr::View;
use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Kind, Opcode, Operand, Value};

/// What is known of each register, by its number.
pub(super) struct Registers {
    real: [bool; 100],
    /// The arrays: first and last register.
    pub tables: Vec<(u8, u8)>,
}

impl Registers {
    pub fn of(steps: &[Instruction<'_>]) -> Registers {
        let mut votes = [[0_u32; 2]; 100];
        // A copy makes its target what its source is, so numbers are followed twice.
        for _ in 0..2 {
            count(steps, &mut votes);
        }
        let mut tables: Vec<(u8, u8)> = Vec::new();
        for step in steps {
            if let Operand::Table { first, length } = step.operand {
                join(&mut tables, first, first + length - 1);
            }
        }
        tables.sort_unstable();
        let mut real = [false; 100];
        for (at, [whole, real_votes]) in votes.into_iter().enumerate() {
            real[at] = real_votes > whole;
        }
        // Those of an array are of one type.
        for &(first, last) in &tables {
            let range = usize::from(first)..=usize::from(last);
            let all = real[range.clone()].iter().any(|real| *real)
                && votes[range.clone()].iter().all(|[whole, _]| *whole == 0);
            real[range].fill(all);
        }
        Registers { real, tables }
    }

    pub fn view(&self, register: u8) -> View {
        match self.real[usize::from(register)] {
            true => View::Real,
            false => View::Whole,
        }
    }

    /// The first register of the array that this one is an element of.
    pub fn table(&self, register: u8) -> Option<u8> {
        let of = |(first, last): &&(u8, u8)| (*first..=*last).contains(&register);
        self.tables.iter().find(of).map(|(first, _)| *first)
    }
}

/// Adds a range of registers; ranges that meet in a register are one.
fn join(tables: &mut Vec<(u8, u8)>, mut first: u8, mut last: u8) {
    tables.retain(|&(from, to)| {
        let apart = to < first || last < from;
        if !apart {
            (first, last) = (first.min(from), last.max(to));
        }
        apart
    });
    tables.push((first, last));
}

/// Counts for each register how often it is taken for a whole number, and for a REAL number.
fn count(steps: &[Instruction<'_>], votes: &mut [[u32; 2]; 100]) {
    // What value holds: the register that it comes from, and what has been made of it.
    let (mut from, mut made): (Option<u8>, Option<View>) = (None, None);
    for step in steps {
        let register = match step.operand {
            Operand::Value(Value::Register(register)) => Some(usize::from(register)),
            Operand::Table { first, .. } => Some(usize::from(first)),
            _ => None,
        };
        match step.opcode {
            Opcode::Load => {
                from = register.map(|register| register as u8);
                made = from.and_then(|from| decided(votes[usize::from(from)]));
                continue;
            }
            Opcode::Store => {
                let to = usize::from(step.number().unwrap_or_default());
                if let Some(made) = made {
                    votes[to][made as usize] += 1;
                }
                continue;
            }
            Opcode::StoreTable => {
                if let (Some(register), Some(made)) = (register, made) {
                    votes[register][made as usize] += 1;
                }
                continue;
            }
            Opcode::LoadTable => {
                (from, made) = (None, register.and_then(|register| decided(votes[register])));
                continue;
            }
            _ => {}
        }
        let Some((takes, gives)) = views(*step) else {
            continue;
        };
        if let Some(from) = from.take() {
            votes[usize::from(from)][takes as usize] += 1;
        }
        if let Some(register) = register {
            votes[register][takes as usize] += 1;
        }
        if step.opcode.class() == Class::Operation {
            made = Some(gives);
        }
    }
}

fn decided([whole, real]: [u32; 2]) -> Option<View> {
    match whole.cmp(&real) {
        std::cmp::Ordering::Less => Some(View::Real),
        std::cmp::Ordering::Greater => Some(View::Whole),
        std::cmp::Ordering::Equal => None,
    }
}

/// What an operation takes value and operand for, and what it makes; none where it does neither.
fn views(step: Instruction<'_>) -> Option<(View, View)> {
    let row = step.opcode.row();
    Some(match step.opcode {
        Opcode::Push => return None,
        Opcode::RealFromSigned | Opcode::RealFromUnsigned => (View::Whole, View::Real),
        Opcode::RealRound | Opcode::RealCut | Opcode::RealComparable => (View::Real, View::Whole),
        Opcode::RealNegate | Opcode::RealAbsolute | Opcode::RealRoot => (View::Real, View::Real),
        _ if row.kind == Kind::Real => (View::Real, View::Real),
        _ if matches!(
            row.class,
            Class::Operation | Class::Comparison | Class::ValueContact
        ) =>
        {
            (View::Whole, View::Whole)
        }
        _ => return None,
    })
}
