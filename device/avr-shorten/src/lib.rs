#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

pub mod assembly;
pub mod body;
mod copies;
mod decide;
pub mod effects;
pub mod equivalence;
pub mod frame;
mod jumps;
mod liveness;
pub mod machine;
pub mod operands;
mod order;
mod parts;
mod reach;
mod saves;
mod tails;
#[cfg(test)]
mod tests;
mod values;

use assembly::{Line, Unit};

/// Shortened assembly, and what each rule has saved.
pub struct Shortened {
    /// The assembly.
    pub text: String,
    /// The bytes of the functions as the compiler made them, if all calls and jumps were short.
    pub before: usize,
    /// What each rule has saved of them. The last one may take some: it makes all branches reach.
    pub saved: Vec<(&'static str, isize)>,
}

/// Shortens assembly. The same text always gives the same.
pub fn shorten(text: &str) -> Shortened {
    let mut unit = Unit::parse(text);
    let before = bytes(&unit);
    let mut saved: Vec<(&'static str, isize)> = Vec::new();
    let mut size = before;
    let mut apply = |name, unit: &mut Unit, rule: &mut dyn FnMut(&mut Unit) -> bool| {
        let changed = rule(unit);
        let now = bytes(unit);
        let less = size as isize - now as isize;
        match saved.iter_mut().find(|(other, _)| *other == name) {
            Some((_, sum)) => *sum += less,
            None => saved.push((name, less)),
        }
        size = now;
        changed
    };

    // While every function still keeps the compiler's conventions.
    let mut count = 0;
    loop {
        let jumps = apply("jumps", &mut unit, &mut jumps::shorten);
        let decide = apply("decisions", &mut unit, &mut |unit| {
            decide::drop_known(unit, &mut count)
        });
        let copies = apply("copies", &mut unit, &mut copies::drop_superfluous);
        if !(jumps || decide || copies) {
            break;
        }
    }
    apply("entries and exits", &mut unit, &mut saves::share);
    loop {
        apply("jumps", &mut unit, &mut jumps::shorten);
        if !apply("equal ends", &mut unit, &mut |unit| {
            tails::merge(unit, &mut count)
        }) {
            break;
        }
    }
    while apply("equal parts", &mut unit, &mut |unit| {
        parts::take_out(unit, &mut count)
    }) {
        apply("equal ends", &mut unit, &mut |unit| {
            tails::merge(unit, &mut count)
        });
        apply("jumps", &mut unit, &mut jumps::shorten);
    }
    apply("reach", &mut unit, &mut reach::mend);
    order::arrange(&mut unit);
    Shortened {
        text: unit.to_string(),
        before,
        saved,
    }
}

/// The bytes of the compiler's functions.
fn bytes(unit: &Unit) -> usize {
    let codes = |function: &assembly::Function| -> usize {
        let codes = function.body.iter().filter_map(Line::instruction);
        codes.map(effects::short_bytes).sum()
    };
    unit.functions().map(codes).sum()
}
