//! The order of the functions in flash. A call that reaches no further than 4 KB takes 2 bytes in place of
//! 4, so those that call one another stand together.
//!
//! The linker takes sections in the order in which the assembly names them first. So a row of their names
//! in front is all that it takes.

use std::collections::BTreeMap;

use super::assembly::{Code, Item, Line, Unit};
use super::effects::{Flow, bytes, flow};

/// How far a short call reaches, in bytes. The linker, which knows every address, says the last word.
const REACH: i64 = 4_094;

/// A section of code, and which labels in it or in others its code leads to.
struct Section {
    directive: String,
    length: i64,
    /// Each with its offset.
    labels: Vec<(String, i64)>,
    /// Each with its offset.
    calls: Vec<(String, i64)>,
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
            section.length += if is_long(code) { 2 } else { bytes(code) as i64 };
        }
        Line::Other(_) => {}
    }
}

fn is_long(code: &Code) -> bool {
    matches!(flow(code), Flow::Call(_) | Flow::Jump(_)) && bytes(code) == 4
}

/// A call from one section into another: where it is in the one, where it leads in the other.
type Call = ((usize, i64), (usize, i64));

/// Moves each section to where it is best, until none gets better.
fn best_order(sections: &[Section]) -> Vec<usize> {
    let mut places: BTreeMap<&str, (usize, i64)> = BTreeMap::new();
    for (n, section) in sections.iter().enumerate() {
        for (name, offset) in &section.labels {
            places.insert(name, (n, *offset));
        }
    }
    let calls = sections.iter().enumerate().flat_map(|(n, section)| {
        let places = &places;
        section.calls.iter().filter_map(move |(name, offset)| {
            let &target = places.get(name.as_str())?;
            (target.0 != n).then_some(((n, *offset), target))
        })
    });
    let calls: Vec<Call> = calls.collect();
    let mut order: Vec<usize> = (0..sections.len()).collect();
    let mut best = cost(sections, &calls, &order);
    loop {
        let before = best;
        for section in 0..sections.len() {
            let rest: Vec<usize> = order.iter().copied().filter(|&n| n != section).collect();
            for place in 0..=rest.len() {
                let mut other = rest.clone();
                other.insert(place, section);
                let cost = cost(sections, &calls, &other);
                if cost < best {
                    best = cost;
                    order = other;
                }
            }
        }
        if best == before {
            return order;
        }
    }
}

/// The calls that are too long, and by how much they are.
fn cost(sections: &[Section], calls: &[Call], order: &[usize]) -> (usize, i64) {
    let mut starts = vec![0; sections.len()];
    let mut at = 0;
    for &n in order {
        starts[n] = at;
        at += sections[n].length;
    }
    let mut cost = (0, 0);
    for &((from, offset), (to, target)) in calls {
        let distance = (starts[to] + target - starts[from] - offset).abs();
        if distance > REACH {
            cost.0 += 1;
            cost.1 += distance - REACH;
        }
    }
    cost
}
