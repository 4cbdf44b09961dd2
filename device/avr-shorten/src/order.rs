//! The order of the functions in flash. A call that reaches no further than 4 KB takes 2 bytes in place of
//! 4, so those that call one another stand together.
//!
//! The linker takes sections in the order in which the assembly names them first. So a row of their names
//! in front is all that it takes.

use std::collections::BTreeMap;

use super::assembly::{Code, Item, Line, Unit};
use super::effects::{Flow, bytes, flow};

/// How far a short call reaches, in bytes. The linker, which knows every address, says the last word.
const REACH: i32 = 4_094;

/// A section of code, and which labels in it or in others its code leads to.
struct Section {
    directive: String,
    length: i32,
    /// Each with its offset.
    labels: Vec<(String, i32)>,
    /// Each with its offset.
    calls: Vec<(String, i32)>,
}

/// Names the sections in front of the assembly, in a better order.
pub fn arrange(unit: &mut Unit) {
    let sections = sections(unit);
    let order = best_order(&sections);
    let names = order.iter().map(|&n| sections[n].directive.clone());
    let names = names.collect();
    unit.items.insert(0, Item::Verbatim(names));
}

/// The sections that may be moved, in the order of the file.
fn sections(unit: &Unit) -> Vec<Section> {
    let mut found: Vec<Section> = Vec::new();
    let mut current = None;
    for item in &unit.items {
        match item {
            Item::Function(function) => {
                for line in &function.head {
                    enter(line, &mut found, &mut current);
                }
                for line in &function.body {
                    add(line, &mut found, current);
                }
                current = None;
            }
            Item::Verbatim(lines) => {
                for line in lines {
                    enter(line, &mut found, &mut current);
                    let text = line.split(';').next().unwrap_or_default().trim();
                    if !text.is_empty() && !text.starts_with('.') && !text.ends_with(':') {
                        add(&Line::code(text), &mut found, current);
                    }
                }
            }
        }
    }
    found
}

/// Takes notice of directives and labels that stand for themselves.
fn enter(line: &str, found: &mut Vec<Section>, current: &mut Option<usize>) {
    if line.starts_with("\t.section\t") || line.trim() == ".text" || line.trim() == ".data" {
        let movable = line.starts_with("\t.section\t.text.");
        *current = movable.then(|| {
            let known = found.iter().position(|section| section.directive == line);
            known.unwrap_or_else(|| {
                found.push(Section {
                    directive: line.to_owned(),
                    length: 0,
                    labels: Vec::new(),
                    calls: Vec::new(),
                });
                found.len() - 1
            })
        });
    }
    if let Some(name) = line.trim_end().strip_suffix(':') {
        add(&Line::Label(name.to_owned()), found, *current);
    }
}

fn add(line: &Line, found: &mut [Section], current: Option<usize>) {
    let Some(section) = current.and_then(|n| found.get_mut(n)) else {
        return;
    };
    match line {
        Line::Label(name) => section.labels.push((name.clone(), section.length)),
        Line::Code(code) | Line::Fixed(code) => {
            if is_long(code) {
                section
                    .calls
                    .push((code.operand(0).to_owned(), section.length));
            }
            // Most calls will be short.
            section.length += if is_long(code) { 2 } else { bytes(code) as i32 };
        }
        Line::Other(_) => {}
    }
}

fn is_long(code: &Code) -> bool {
    matches!(flow(code), Flow::Call(_) | Flow::Jump(_)) && bytes(code) == 4
}

/// A call from one section into another, and how much further in its section the label is than the call is in its own.
struct Call {
    from: u16,
    to: u16,
    further: i32,
}

impl Call {
    /// How far it leads, where sections start so.
    #[inline(always)]
    fn distance(&self, starts: &[i32]) -> i32 {
        let between = starts[usize::from(self.to)].wrapping_sub(starts[usize::from(self.from)]);
        between.wrapping_add(self.further)
    }

    #[inline(always)]
    fn is_long(&self, starts: &[i32]) -> bool {
        self.distance(starts).wrapping_add(REACH) as u32 > 2 * REACH as u32
    }
}

/// The calls from one section into another.
fn calls(sections: &[Section]) -> Vec<Call> {
    let mut places: BTreeMap<&str, (u16, i32)> = BTreeMap::new();
    for (n, section) in (0..).zip(sections) {
        for (name, offset) in &section.labels {
            places.insert(name, (n, *offset));
        }
    }
    let calls = (0..).zip(sections).flat_map(|(n, section)| {
        let places = &places;
        section.calls.iter().filter_map(move |(name, offset)| {
            let &target = places.get(name.as_str())?;
            (target.0 != n).then_some(Call {
                from: n,
                to: target.0,
                further: target.1 - offset,
            })
        })
    });
    calls.collect()
}

/// How many changes are tried; a third of them leaves some ten calls more too long.
const TRIES: usize = 6_000_000;
/// How many calls more may be too long in the beginning than in the best order so far.
const WORSE: usize = 12;

/// An order in which few calls are too long, found by chance, but always the same: one or more sections in a row are
/// moved, or turned round as well; what is not much worse than the best so far is kept, and less and less of it.
/// (Moving one section at a time until nothing gets better leaves twice as many calls too long.)
fn best_order(sections: &[Section]) -> Vec<usize> {
    let mut calls = calls(sections);
    let lengths: Vec<i32> = sections.iter().map(|section| section.length).collect();
    let mut order: Vec<usize> = (0..sections.len()).collect();
    if order.len() < 2 {
        return order;
    }
    let mut chance = Chance(1);
    let mut starts = vec![0; sections.len()];
    place(&lengths, &order, &mut starts);
    let mut best = (cost(&mut calls, &starts), order.clone());
    let mut other = order.clone();
    for tries in 0..TRIES {
        let most = if chance.below(2) == 0 { 3 } else { 40 };
        let length = (1 + chance.below(most)).min(order.len() - 1);
        let from = chance.below(order.len() - length + 1);
        other.copy_from_slice(&order);
        if chance.below(3) == 0 {
            other[from..from + length].reverse();
        }
        let to = chance.below(order.len() - length + 1);
        if to < from {
            other[to..from + length].rotate_right(length);
        } else {
            other[from..to + length].rotate_left(length);
        }
        place(&lengths, &other, &mut starts);
        let (least, _) = best.0;
        if is_within(least + WORSE * (TRIES - tries) / TRIES, &calls, &starts) {
            std::mem::swap(&mut order, &mut other);
            let cost = cost(&mut calls, &starts);
            if cost < best.0 {
                best = (cost, order.clone());
            }
        }
    }
    best.1
}

/// Numbers by chance, the same each time: a linear congruential generator with Knuth's constants for MMIX.
struct Chance(u64);

impl Chance {
    /// A number below `end`, which is not 0.
    fn below(&mut self, end: usize) -> usize {
        let Chance(state) = self;
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 33) as usize % end
    }
}

/// Where each section starts in this order.
fn place(lengths: &[i32], order: &[usize], starts: &mut [i32]) {
    let mut at: i32 = 0;
    for &n in order {
        starts[n] = at;
        at = at.wrapping_add(lengths[n]);
    }
}

/// Whether no more than so many calls are too long. Most of the time goes by here: most orders are much worse, and that
/// shows soon, since the calls that have been too long come first.
fn is_within(most: usize, calls: &[Call], starts: &[i32]) -> bool {
    let mut long: u32 = 0;
    calls.chunks(16).all(|calls| {
        for call in calls {
            long = long.wrapping_add(call.is_long(starts).into());
        }
        long as usize <= most
    })
}

/// The calls that are too long, and by how much they are. They are first from then on.
fn cost(calls: &mut [Call], starts: &[i32]) -> (usize, i64) {
    let mut cost = (0, 0);
    for n in 0..calls.len() {
        if calls[n].is_long(starts) {
            cost.1 += i64::from(calls[n].distance(starts).abs() - REACH);
            calls.swap(n, cost.0);
            cost.0 += 1;
        }
    }
    cost
}
