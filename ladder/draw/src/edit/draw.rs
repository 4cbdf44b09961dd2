//! A document as a ladder: what each of its symbols stands for.

use super::document::{Document, Id};
use super::emit::{Code, Emitted, What};
use super::shown;
use crate::{Drawing, Ladder, Medium, Names, Style};
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

/// What a step of the ladder shows: a code, or a path on which nothing stands.
enum Shown<'e> {
    Code(&'e Code<'e>),
    Hole(Id),
}

impl Drawn {
    /// The ladder of a document.
    pub fn of(document: &Document) -> Drawn {
        Emitted::of(document).drawn()
    }

    /// Draws it in so many columns.
    pub fn draw(&self, width: usize, names: &Names) -> Drawing<'_> {
        self.ladder.draw(&Style {
            width,
            names,
            medium: Medium::PLAIN,
        })
    }
}

impl Emitted<'_> {
    /// Its ladder.
    pub fn drawn(&self) -> Drawn {
        let mut ladder = Ladder::empty();
        let mut all: Vec<Shown<'_>> = Vec::with_capacity(self.codes.len());
        let (mut at, mut timers) = (0, 0);
        let mut holes = self.holes.iter().peekable();
        for &end in &self.ends {
            let first = all.len();
            loop {
                while let Some((_, path)) = holes.next_if(|(before, _)| *before == at) {
                    all.push(Shown::Hole(*path));
                }
                if at == end {
                    break;
                }
                all.push(Shown::Code(&self.codes[at]));
                at += 1;
            }
            let steps: Vec<Instruction<'_>> = all[first..].iter().map(Shown::step).collect();
            ladder.rung(first, &steps, &mut timers);
        }
        let mut elements = Vec::with_capacity(ladder.elements.len());
        for element in &mut ladder.elements {
            elements.push(match &all[element.conducts] {
                Shown::Code(code) => {
                    if let What::Step(step) = code.what {
                        shown::question(step, &mut element.symbol);
                    }
                    code.of
                }
                Shown::Hole(path) => {
                    shown::nothing(element);
                    *path
                }
            });
        }
        Drawn {
            ladder,
            elements,
            rungs: self.document.rungs().map(|rung| rung.id).collect(),
        }
    }
}

impl Shown<'_> {
    fn step(&self) -> Instruction<'_> {
        match self {
            Shown::Code(code) => code.step(),
            Shown::Hole(_) => shown::HOLE,
        }
    }
}
