//! Equal ends of paths, within a function and across functions: one stays, the others jump to it.
//!
//! Code that runs to an unconditional end means the same wherever it stands, so nothing about it needs
//! to be known but that it is equal, instruction by instruction.

use std::collections::BTreeMap;

use super::assembly::{Code, Item, Line, Unit};
use super::body::{in_time, is_bound, is_end, is_scan};
use super::effects::bytes;

/// The end of a path: how it goes on, and the line where that stands.
struct End<'a> {
    item: usize,
    /// The lines before this one are the path.
    line: usize,
    /// Where the path goes on by falling into a label, there is no such instruction.
    falls: bool,
    /// What is before, the last first, and whether a jump may lead there in its place: none may come
    /// between two instructions that belong together.
    codes: Vec<(&'a Code, bool)>,
    scan: bool,
}

/// What is merged: `length` instructions before each of the ends, the first of which stays.
struct Merge {
    gain: usize,
    length: usize,
    /// Item and line of the ends, and whether the path falls into a label there.
    ends: Vec<(usize, usize, bool)>,
}

/// Merges equal ends until none is left whose merging saves anything.
pub fn merge(unit: &mut Unit, count: &mut usize) -> bool {
    let mut any = false;
    while let Some(best) = best(unit) {
        *count += 1;
        apply(unit, &best, &format!(".Ltail{count}"));
        any = true;
    }
    any
}

/// All ends, by how they go on.
fn ends(unit: &Unit) -> BTreeMap<String, Vec<End<'_>>> {
    let mut found: BTreeMap<String, Vec<End<'_>>> = BTreeMap::new();
    for (item, function) in unit.items.iter().enumerate() {
        let Item::Function(function) = function else {
            continue;
        };
        let body = &function.body;
        let in_time = in_time(body);
        for (line, this) in body.iter().enumerate() {
            let (key, falls) = match this {
                Line::Code(code) if is_end(body, line) => (code.to_string(), false),
                Line::Label(name) if !line.checked_sub(1).is_some_and(|n| is_end(body, n)) => {
                    (format!("rjmp\t{name}"), true)
                }
                _ => continue,
            };
            let before = (0..line).rev().map_while(|n| match body.get(n) {
                Some(Line::Code(code)) if !in_time[n] => Some((code, !is_bound(body, n))),
                _ => None,
            });
            let codes = before.collect();
            found.entry(key).or_default().push(End {
                item,
                line,
                falls,
                codes,
                scan: is_scan(function),
            });
        }
    }
    found
}

/// The merging that saves most; the first of equals.
fn best(unit: &Unit) -> Option<Merge> {
    let mut best: Option<Merge> = None;
    for (key, mut ends) in ends(unit) {
        // The first stays: best where nothing is to be replaced, or where time counts.
        ends.sort_by_key(|end| (!end.falls, !end.scan));
        let last = bytes(&Code::parse(&key));
        let mut groups = vec![ends.iter().collect::<Vec<_>>()];
        for length in 1.. {
            groups = groups
                .iter()
                .flat_map(|group| split(group, length))
                .collect();
            if groups.is_empty() {
                break;
            }
            for group in &groups {
                let free = |end: &&&End<'_>| end.codes.get(length - 1).is_some_and(|code| code.1);
                let mut free = group.iter().filter(free);
                let Some(first) = free.next() else {
                    continue;
                };
                let codes = first.codes.iter().take(length);
                let saved: usize = codes.map(|(code, _)| bytes(code)).sum();
                let mut ends = vec![(first.item, first.line, first.falls)];
                let mut gain = 0;
                for other in free.filter(|other| !other.scan) {
                    let jump = if other.item == first.item { 2 } else { 4 };
                    let last = if other.falls { 0 } else { last };
                    if saved + last > jump {
                        gain += saved + last - jump;
                        ends.push((other.item, other.line, other.falls));
                    }
                }
                if gain > best.as_ref().map_or(0, |best| best.gain) {
                    best = Some(Merge { gain, length, ends });
                }
            }
        }
    }
    best
}

/// Parts a group by the instruction that stands `length` before the end; single ends are left out.
fn split<'a, 'b>(group: &[&'b End<'a>], length: usize) -> Vec<Vec<&'b End<'a>>> {
    let mut parts: Vec<Vec<&End<'a>>> = Vec::new();
    for &end in group {
        let code = |end: &End<'a>| end.codes.get(length - 1).map(|&(code, _)| code);
        let Some(this) = code(end) else {
            continue;
        };
        match parts.iter_mut().find(|part| code(part[0]) == Some(this)) {
            Some(part) => part.push(end),
            None => parts.push(vec![end]),
        }
    }
    parts.retain(|part| part.len() > 1);
    parts
}

fn apply(unit: &mut Unit, merge: &Merge, label: &str) {
    let Some((&first, others)) = merge.ends.split_first() else {
        return;
    };
    let mut edits: Vec<_> = others.iter().map(|&end| (end, false)).collect();
    edits.push((first, true));
    // From the back, so that the lines that are left keep their numbers.
    edits.sort_by(|a, b| b.cmp(a));
    for ((item, line, falls), stays) in edits {
        let Some(Item::Function(function)) = unit.items.get_mut(item) else {
            continue;
        };
        let start = line - merge.length;
        if stays {
            function.body.insert(start, Line::Label(label.to_owned()));
        } else {
            let jump = if item == first.0 { "rjmp" } else { "jmp" };
            let jump = Line::code(&format!("{jump} {label}"));
            let end = if falls { line } else { line + 1 };
            function.body.splice(start..end, [jump]);
        }
    }
}
