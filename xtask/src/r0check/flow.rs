//! Follows r0 through every path of every function: which instructions may have written the value
//! that is read here?
//!
//! Functions are analysed one at a time; of a function called, only its [`Summary`] is used.
//! Summaries only ever gain a flag, so repeating until none changes comes to an end.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result};

use super::decode::{self, Flow, Instruction, Read, Write};
use super::elf::Code;
use super::{Finding, Report};

/// Where a value in r0 comes from, with the byte address of the instruction that left it there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Origin {
    /// It was there when the function was entered.
    Entry,
    /// The low byte of a product.
    Product(u32),
    /// The status register, saved by the compiler around a change of the stack or frame pointer.
    Status(u32),
    /// A call, which may use r0 as it likes.
    Call(u32),
    /// Another instruction that writes r0.
    Other(u32),
}

/// What r0 may hold.
type Origins = BTreeSet<Origin>;

/// What a call does to r0. A function that neither keeps nor replaces it does not return.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
struct Summary {
    /// It may return with r0 as it was.
    keeps: bool,
    /// It may return with something else in r0.
    replaces: bool,
    /// It may read r0 as its caller left it: so does some hand-written assembly.
    takes: bool,
}

/// Nothing is known of what a pointer points to.
const UNKNOWN: Summary = Summary {
    keeps: false,
    replaces: true,
    takes: false,
};

type Summaries = BTreeMap<u32, Summary>;

/// One function's instructions, each with what r0 may hold before it.
type Paths = BTreeMap<u32, (Instruction, Origins)>;

/// Checks all code that can be reached from `entry` or from a symbol, and what stands behind an `ijmp`:
/// in a row of handlers, each of which ends so, the next one begins there.
///
/// # Errors
/// If a path leads to something that is not code.
pub fn check(code: &Code, entry: u32) -> Result<Report> {
    let functions = code.functions().iter().copied();
    let roots = functions.chain(code.entries()).chain([entry]);
    let mut summaries: Summaries = roots.map(|root| (root, Summary::default())).collect();
    loop {
        let mut next = summaries.clone();
        for &function in summaries.keys() {
            let paths = follow(code, function, &summaries)?;
            for callee in paths.values().filter_map(|(i, _)| callee(i)) {
                next.entry(callee).or_default();
            }
            for handler in paths
                .iter()
                .filter_map(|(&at, (i, _))| behind_jump(code, at, i))
            {
                next.entry(handler).or_default();
            }
            next.insert(function, summarise(&paths, &summaries));
        }
        if next == summaries {
            break;
        }
        summaries = next;
    }

    let mut report = Report {
        functions: summaries.len(),
        ..Report::default()
    };
    let mut seen = BTreeMap::new();
    for &function in summaries.keys() {
        for (address, (instruction, origins)) in follow(code, function, &summaries)? {
            let lost = lost(&instruction, &origins, &summaries);
            if !lost.is_empty() {
                report.findings.insert(Finding {
                    address,
                    function: code.label(address).to_owned(),
                    instruction: instruction.to_string(),
                    origins: lost.into_iter().collect(),
                });
            }
            let product = instruction.write == Some(Write::Product);
            seen.insert(address, (instruction.length as usize, product));
        }
    }
    report.instructions = seen.len();
    report.products = seen.values().filter(|(_, product)| *product).count();
    report.followed = seen.values().map(|(length, _)| length).sum();
    report.code = code.bytes();
    Ok(report)
}

/// Walks every path of the function at `entry` until what r0 may hold no longer grows.
fn follow(code: &Code, entry: u32, summaries: &Summaries) -> Result<Paths> {
    let mut paths = Paths::new();
    let mut work = vec![(entry, Origins::from([Origin::Entry]))];
    while let Some((address, incoming)) = work.pop() {
        let (instruction, origins) = match paths.get_mut(&address) {
            Some((_, origins)) if incoming.is_subset(origins) => continue,
            Some((instruction, origins)) => {
                origins.extend(incoming);
                (instruction.clone(), origins.clone())
            }
            None => {
                let instruction = instruction_at(code, address)?;
                paths.insert(address, (instruction.clone(), incoming.clone()));
                (instruction, incoming)
            }
        };
        let after = after(address, &instruction, origins, summaries);
        if after.is_empty() {
            continue; // It calls a function that does not return.
        }
        let next = address + instruction.length;
        match instruction.flow {
            Flow::Next | Flow::Call(_) | Flow::CallIndirect => work.push((next, after)),
            Flow::Skip => {
                let skipped = instruction_at(code, next)?.length;
                work.push((next + skipped, after.clone()));
                work.push((next, after));
            }
            Flow::Branch(target) => {
                work.push((target, after.clone()));
                work.push((next, after));
            }
            Flow::Jump(target) => work.push((target, after)),
            Flow::JumpIndirect | Flow::Return => {}
        }
    }
    Ok(paths)
}

fn instruction_at(code: &Code, address: u32) -> Result<Instruction> {
    code.at(address)
        .and_then(|bytes| decode::decode(address, bytes))
        .with_context(|| {
            format!(
                "a path of the code leads to {address:#06x} ({}), where there is no instruction \
                 of an ATmega328P",
                code.label(address)
            )
        })
}

/// What r0 may hold after an instruction. Nothing at all: control does not come back.
fn after(
    address: u32,
    instruction: &Instruction,
    before: Origins,
    summaries: &Summaries,
) -> Origins {
    if let Some(summary) = called(instruction, summaries) {
        let kept = if summary.keeps {
            before
        } else {
            Origins::new()
        };
        let replaced = summary.replaces.then_some(Origin::Call(address));
        return kept.into_iter().chain(replaced).collect();
    }
    match instruction.write {
        None => before,
        Some(Write::Product) => Origins::from([Origin::Product(address)]),
        Some(Write::Status) => Origins::from([Origin::Status(address)]),
        Some(Write::Other) => Origins::from([Origin::Other(address)]),
    }
}

/// The address behind a jump to a pointer, if there is code.
fn behind_jump(code: &Code, address: u32, instruction: &Instruction) -> Option<u32> {
    let next = address + instruction.length;
    let jumps = instruction.flow == Flow::JumpIndirect;
    (jumps && !code.is_constant(next) && code.at(next).is_some()).then_some(next)
}

fn callee(instruction: &Instruction) -> Option<u32> {
    match instruction.flow {
        Flow::Call(target) => Some(target),
        _ => None,
    }
}

fn called(instruction: &Instruction, summaries: &Summaries) -> Option<Summary> {
    match instruction.flow {
        Flow::CallIndirect => Some(UNKNOWN),
        // A function found in this round: it is looked at in the next.
        Flow::Call(target) => Some(summaries.get(&target).copied().unwrap_or_default()),
        _ => None,
    }
}

/// What a call of the function with these paths does to r0.
fn summarise(paths: &Paths, summaries: &Summaries) -> Summary {
    let mut summary = Summary::default();
    for (instruction, origins) in paths.values() {
        let entry = origins.contains(&Origin::Entry);
        match instruction.flow {
            Flow::Return => {
                summary.keeps |= entry;
                summary.replaces |= origins.iter().any(|&origin| origin != Origin::Entry);
            }
            Flow::JumpIndirect => summary.replaces = true,
            _ => {}
        }
        summary.takes |= entry && takes_value(instruction, summaries);
    }
    summary
}

/// Whether the instruction, or the function that it calls, works with the value in r0.
fn takes_value(instruction: &Instruction, summaries: &Summaries) -> bool {
    instruction.read == Some(Read::Value)
        || called(instruction, summaries).is_some_and(|summary| summary.takes)
}

/// Those of the origins from which the instruction must not get what it reads: r0 was used for
/// something else before this instruction had its value.
fn lost(instruction: &Instruction, origins: &Origins, summaries: &Summaries) -> Origins {
    let wrong = |origin: &Origin| match origin {
        Origin::Status(_) => takes_value(instruction, summaries),
        Origin::Call(_) => {
            takes_value(instruction, summaries) || instruction.read == Some(Read::RestoresStatus)
        }
        Origin::Entry | Origin::Product(_) => instruction.read == Some(Read::RestoresStatus),
        Origin::Other(_) => false,
    };
    origins.iter().copied().filter(wrong).collect()
}
