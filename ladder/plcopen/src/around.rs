//! What is around the rungs of a project: its first scan, and the numbers of its timers.

use crate::allot::Allotted;
use crate::circuit::{Leaf, Part};
use crate::found::Found;
use crate::rungs::Rungs;
use crate::symbol::Symbol;
use std::collections::HashMap;
use unoclp_core::isa::{Class, Kind, Opcode};
use unoclp_draw::Names;
use unoclp_draw::edit::{Draft, Id, Node, Series, Step};
use unoclp_lang::{Code, Span};
use unoclp_point::Address;

/// What is kept, and the first scan, which gives variables their first values.
pub(crate) fn begin(all: &Allotted, rungs: &mut Rungs) {
    let mut parts: Vec<Part> = Vec::new();
    for (symbol, _, keeps, _) in &all.begun {
        if let (Symbol::At(point), true) = (symbol, keeps) {
            parts.push(
                Step::new(Opcode::KeepRegister)
                    .with_number(point.number())
                    .into(),
            );
        }
    }
    let mut is_first = true;
    for (symbol, first, ..) in &all.begun {
        let Some(first) = first else { continue };
        if std::mem::take(&mut is_first) {
            parts.push(Step::new(Opcode::SystemContact).with_number(1).into());
        }
        match symbol {
            Symbol::At(point) if point.is_bit() => {
                let set = Draft::coil(Some(*point), unoclp_draw::edit::Coil::Set);
                parts.extend(set.ok().map(|draft| Part::from(draft.step)));
            }
            Symbol::At(point @ (Address::Register(_) | Address::Pwm(_))) => {
                let load = Step::new(Opcode::Load).with_number(0);
                parts.push(load.with_lines([Some(*first)]).into());
                let store = match point {
                    Address::Pwm(_) => Opcode::StorePwm,
                    _ => Opcode::Store,
                };
                parts.push(Step::new(store).with_number(point.number()).into());
            }
            _ => {}
        }
    }
    if let Some((.., at)) = all.begun.first() {
        let leaf = Leaf {
            parts,
            ..Leaf::plain((usize::MAX, 0), Step::new(Opcode::NewRung))
        };
        rungs.first(&leaf, *at);
    }
}

/// Numbers the timers by their order in the program, and gives those that drive nothing a marker.
pub(crate) fn number(rungs: &mut Rungs, all: &mut Allotted, found: &mut Found) -> Names {
    let mut numbers: HashMap<u8, u8> = HashMap::new();
    let mut unused = None;
    for rung in &mut rungs.rungs {
        each(&mut rung.series, &mut |id, _, step| {
            if step.class() != Class::Timer {
                return;
            }
            if let Some(&timer) = rungs.timers.get(&id) {
                let next = numbers.len() as u8 + 1;
                numbers.insert(timer, next);
            }
            if let [preset, None] = *step.lines() {
                let marker = *unused.get_or_insert_with(|| all.points.marker(false));
                let target = marker.map(|m| unoclp_core::isa::MARKER_OPERAND + i32::from(m));
                if target.is_none() {
                    let who = ("the program", "o programa").into();
                    let words = [who, ("marker", "memória").into(), "Q".into(), "64".into()];
                    found.tell_at(Code::XmlNoneLeft, Span::default(), words);
                }
                *step = step.clone().with_lines([preset, target]);
            }
        });
    }
    // A timer that nothing calls has a number that no program has.
    let number = |timer: u8| {
        numbers
            .get(&timer)
            .copied()
            .unwrap_or(unoclp_core::isa::POPPED)
    };
    for rung in &mut rungs.rungs {
        each(&mut rung.series, &mut |_, load, step| {
            for step in load.iter_mut().chain([step]) {
                if step.opcode().row().kind == Kind::TimerQ {
                    let timer = step.number().unwrap_or(0);
                    *step = step.clone().with_number(number(timer));
                }
            }
        });
    }
    let names = all.names.iter().map(|(point, name)| match point {
        Address::Timer(timer) => (Address::Timer(number(*timer)), name.clone()),
        point => (*point, name.clone()),
    });
    names.collect()
}

/// Calls back for each element, in the order of the codes.
fn each(series: &mut Series, to: &mut impl FnMut(Id, &mut Option<Step>, &mut Step)) {
    for node in series {
        match node {
            Node::Element(element) => to(element.id, &mut element.load, &mut element.step),
            Node::Store(_) => {}
            Node::Parallel(parallel) => {
                for path in &mut parallel.paths {
                    each(&mut path.series, to);
                }
            }
            Node::Block(block) => each(&mut block.path.series, to),
        }
    }
}
