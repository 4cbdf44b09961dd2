//! A document as a ladder: what each of its symbols stands for.

use super::document::{Document, Id};
use super::emit::{Emitted, What};
use super::shown;
use crate::{Drawing, Ladder, Names, Style};
use unoclp_core::Instruction;

/// A document as a ladder. What is missing in it shows as `?`; where nothing is wrong, it is the ladder of its codes.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The ladder; it has the rungs of the document, also those without a code.
    pub ladder: Ladder,
    /// What each of its elements stands for: an element of the document, a block where that is drawn as a box, or a path
    /// on which nothing stands, shown as a contact of `?`.
    pub elements: Vec<Id>,
    /// What its rungs are known by.
    pub rungs: Vec<Id>,
}

/// What a step of the ladder shows.
struct Shown<'d> {
    of: Id,
    /// None of a path on which nothing stands.
    what: Option<What<'d>>,
    drum: Vec<u8>,
}

impl Drawn {
    /// The ladder of a document.
    pub fn of(document: &Document) -> Drawn {
        let emitted = Emitted::of(document);
        let mut ladder = Ladder::empty();
        let mut all: Vec<Shown<'_>> = Vec::with_capacity(emitted.codes.len());
        let (mut at, mut timers) = (0, 0);
        let mut holes = emitted.holes.iter().peekable();
        for &end in &emitted.ends {
            let first = all.len();
            loop {
                while let Some((_, path)) = holes.next_if(|(before, _)| *before == at) {
                    all.push(Shown::hole(*path));
                }
                if at == end {
                    break;
                }
                all.push(Shown::code(emitted.codes[at].of, emitted.codes[at].what));
                at += 1;
            }
            let steps: Vec<Instruction<'_>> = all[first..].iter().map(Shown::step).collect();
            ladder.rung(first, &steps, &mut timers);
        }
        let mut elements = Vec::with_capacity(ladder.elements.len());
        for element in &mut ladder.elements {
            let shown = &all[element.conducts];
            match shown.what {
                Some(What::Step(step)) => shown::question(step, &mut element.symbol),
                Some(What::Form(..)) => {}
                None => shown::nothing(element),
            }
            elements.push(shown.of);
        }
        Drawn {
            ladder,
            elements,
            rungs: document.rungs().map(|rung| rung.id).collect(),
        }
    }

    /// Draws it in so many columns.
    pub fn draw(&self, width: usize, names: &Names) -> Drawing<'_> {
        self.ladder.draw(&Style {
            width,
            names,
            live: &|_| None,
        })
    }
}

impl<'d> Shown<'d> {
    fn hole(of: Id) -> Shown<'d> {
        let (what, drum) = (None, Vec::new());
        Shown { of, what, drum }
    }

    fn code(of: Id, what: What<'d>) -> Shown<'d> {
        let drum = match what {
            What::Step(step) => shown::drum(step),
            What::Form(..) => Vec::new(),
        };
        let what = Some(what);
        Shown { of, what, drum }
    }

    fn step(&self) -> Instruction<'_> {
        match self.what {
            Some(What::Step(step)) => shown::instruction(step, &self.drum),
            Some(What::Form(opcode, number)) => shown::form(opcode, number),
            None => shown::HOLE,
        }
    }
}
