//! What a program brings along for its variables: names of the text that it comes from, what it keeps, registers to spare.
//!
//! Owns those questions. Must not know how variables are declared.

use super::expr::{Place, View};
use super::machine::Body;
use std::collections::{BTreeMap, BTreeSet};
use unoclp_checked::SourceMap;
use unoclp_core::isa::{Kind, Opcode, REGISTERS};
use unoclp_core::{Instruction, Target};
use unoclp_point::Address;
use unoclp_st::is_keyword;
use unoclp_tree::build::is_function;
use unoclp_tree::{Base, Standard};

/// What KD and KC keep.
pub(super) fn kept(steps: &[Instruction<'_>], body: &Body) -> impl Iterator<Item = Place> {
    steps.iter().filter_map(|step| {
        let xx = step.number()?;
        match step.opcode {
            Opcode::KeepRegister => Some(Place::Register(xx, body.registers.view(xx))),
            Opcode::KeepCounter => Some(Place::At(Address::Count(xx))),
            _ => None,
        }
    })
}

/// The registers that nothing names, the highest first.
pub(super) fn free(steps: &[Instruction<'_>], used: &BTreeSet<Place>) -> Vec<u8> {
    let kept = |n: u8| {
        let keeps = |step: &Instruction<'_>| step.opcode == Opcode::KeepRegister;
        steps
            .iter()
            .any(|step| keeps(step) && step.number() == Some(n))
    };
    let named = |n: u8| [View::Whole, View::Real].map(|view| Place::Register(n, view));
    let is_free = |n: &u8| !kept(*n) && !named(*n).iter().any(|place| used.contains(place));
    (1..=REGISTERS).rev().filter(is_free).collect()
}

/// The names that the text of the program gives to points, where they are names in Structured Text.
pub(super) fn given(steps: &[Instruction<'_>], map: &SourceMap) -> BTreeMap<Place, String> {
    let mut names = BTreeMap::new();
    let mut timers = 0;
    for (step, at) in steps.iter().zip(&map.steps) {
        let xx = step.number().unwrap_or_default();
        let place = match step.opcode.row().kind {
            Kind::Input => Place::At(Address::Input(xx)),
            Kind::Output => Place::At(Address::Output(xx)),
            Kind::Marker => Place::At(Address::Marker(xx)),
            Kind::Analogue => Place::At(Address::Analogue(xx)),
            Kind::Pwm => Place::At(Address::Pwm(xx)),
            Kind::TimerQ => Place::At(Address::TimerQ(xx)),
            Kind::Counter | Kind::Count => Place::At(Address::Count(xx)),
            Kind::Register | Kind::Value | Kind::Real if (1..=REGISTERS).contains(&xx) => {
                Place::Register(xx, View::Whole)
            }
            Kind::Timer => {
                timers += u8::from(step.is_own_timer());
                match step.timer().map(|block| block.target) {
                    Some(Target::Timer(called)) => Place::At(Address::TimerQ(called)),
                    _ => Place::At(Address::TimerQ(timers)),
                }
            }
            _ => continue,
        };
        let Some(name) = at.name.as_ref().filter(|name| is_name(name)) else {
            continue;
        };
        names.entry(place).or_insert_with(|| name.clone());
        if let Place::Register(n, _) = place {
            names
                .entry(Place::Register(n, View::Real))
                .or_insert_with(|| name.clone());
        }
    }
    names
}

/// Whether a variable of Structured Text may be called so.
fn is_name(name: &str) -> bool {
    let upper = name.to_uppercase();
    let word = name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic());
    let known = is_keyword(&upper)
        || is_function(&upper)
        || Base::named(&upper).is_some()
        || Standard::named(&upper).is_some();
    word && begins && !name.contains("__") && !name.ends_with('_') && !known
}
