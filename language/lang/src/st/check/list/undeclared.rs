//! Timers and counters that a text calls by the board's names and declares nowhere: `TON T1, 100`, `CAL C2 (CU := I1)`.
//!
//! Owns which block each of them is. Each is one for the whole text.

use super::super::super::ast::{Arg, Body, Instruction, Line, Name, NodeKind, Part, Path};
use super::super::Checker;
use crate::operators::Op;
use crate::typed::build::{Section, Traits};
use crate::typed::{Kind, Standard};
use std::collections::{BTreeMap, HashSet};
use unoclp_core::isa::Opcode;
use unoclp_point::{self as point, Maker, read};

/// A block that is called, and what is used of it.
struct Called<'a> {
    name: &'a Name,
    /// What its first call says that it is.
    block: Option<Standard>,
    is_timer: bool,
    up: bool,
    down: bool,
}

impl Called<'_> {
    fn uses(&mut self, part: &Name) {
        let part = part.text.to_uppercase();
        self.up |= part == "CU" || part == "QU";
        self.down |= part == "CD" || part == "QD";
    }

    fn block(&self) -> Standard {
        match (self.block, self.up, self.down) {
            (Some(block), ..) if self.is_timer => block,
            (None, ..) if self.is_timer => Standard::Ton,
            (_, true, true) => Standard::Ctud,
            (Some(block), ..) => block,
            (None, false, true) => Standard::Ctd,
            (None, ..) => Standard::Ctu,
        }
    }
}

impl Checker<'_, '_, '_> {
    /// Declares the blocks of the text that are called and not declared.
    pub(in super::super) fn declare_blocks(&mut self) {
        let file = self.file;
        let units = file.units.iter();
        let sections = units.clone().flat_map(|unit| &unit.vars);
        let declarations = sections.chain(&file.globals).flat_map(|vars| &vars.decls);
        let names = declarations.flat_map(|decl| &decl.names);
        let names = names.chain(units.clone().map(|unit| &unit.name));
        let declared: HashSet<String> = names.map(|name| name.text.to_uppercase()).collect();
        let mut called: BTreeMap<String, Called> = BTreeMap::new();
        let bodies = units.filter_map(|unit| match &unit.body {
            Body::List(lines) => Some(lines),
            Body::Statements(_) => None,
        });
        let lines = || {
            let lines = bodies.clone().flatten();
            lines.filter_map(|line| match line {
                Line::Does(one) => Some(&**one),
                _ => None,
            })
        };
        for one in lines() {
            let Some((name, block)) = call(one) else {
                continue;
            };
            let key = name.text.to_uppercase();
            let Some(is_timer) = timer_or_counter(&key).filter(|_| !declared.contains(&key)) else {
                continue;
            };
            called.entry(key).or_insert(Called {
                name,
                block,
                is_timer,
                up: false,
                down: false,
            });
        }
        for one in lines() {
            for path in paths(one) {
                let block = called.get_mut(&path.name.text.to_uppercase());
                if let (Some(block), Some(Part::Member(part))) = (block, path.parts.first()) {
                    block.uses(part);
                }
            }
            if let Some((name, _)) = call(one)
                && let Some(block) = called.get_mut(&name.text.to_uppercase())
            {
                given(one)
                    .filter_map(|arg| arg.name.as_ref())
                    .for_each(|name| block.uses(name));
            }
        }
        for block in called.values() {
            let standard = block.block();
            let types = &mut self.builder.tree.types;
            let ty = types.add_kind(Kind::Standard(standard), standard.cells());
            let Name { text, span } = block.name;
            self.builder
                .declare(text, *span, ty, Section::Global, Traits::default());
        }
    }
}

/// Whether the board's timers have this name, and not its counters; none of another name.
fn timer_or_counter(key: &str) -> Option<bool> {
    let point = read(key, Maker::Iec).filter(|written| written.member.is_none())?;
    match point.kind {
        point::Kind::Timer => Some(true),
        point::Kind::Counter => Some(false),
        _ => None,
    }
}

/// The instance that an instruction calls, and what it says that this is.
fn call(one: &Instruction) -> Option<(&Name, Option<Standard>)> {
    let block = match one.spelling?.op {
        Op::Timer(Opcode::OnDelay) => Some(Standard::Ton),
        Op::Timer(Opcode::OffDelay) => Some(Standard::Tof),
        Op::Timer(Opcode::Pulse) => Some(Standard::Tp),
        Op::CountUp => Some(Standard::Ctu),
        Op::CountDown => Some(Standard::Ctd),
        Op::Call | Op::Input(_) => None,
        _ => return None,
    };
    match &one.operands.first()?.node.kind {
        NodeKind::Path(path) | NodeKind::Call(path, _) if path.parts.is_empty() => {
            Some((&path.name, block))
        }
        _ => None,
    }
}

/// What a call gives and takes.
fn given(one: &Instruction) -> impl Iterator<Item = &Arg> {
    let within = one.operands.iter().flat_map(|arg| match &arg.node.kind {
        NodeKind::Call(_, given) => given.as_slice(),
        _ => &[],
    });
    within.chain(one.given.iter().flatten())
}

/// The variables that stand as operands.
fn paths(one: &Instruction) -> impl Iterator<Item = &Path> {
    let all = one.operands.iter().chain(given(one));
    all.filter_map(|arg| match &arg.node.kind {
        NodeKind::Path(path) => Some(path),
        _ => None,
    })
}
