//! A document as a ladder: what each of its symbols stands for.

use super::document::{Document, Id};
use super::emit::{Emitted, What};
use super::shown;
use crate::{Drawing, Ladder, Names, Style};
use unoclp_core::Instruction;

/// A document as a ladder. What is missing in it shows as `?`; where nothing is, it is the ladder of its codes.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The ladder; it has the rungs of the document, also those without a code.
    pub ladder: Ladder,
    /// What each of its elements stands for: an element of the document, or a block where that is drawn as a box.
    pub elements: Vec<Id>,
    /// What its rungs are known by.
    pub rungs: Vec<Id>,
}

impl Drawn {
    /// The ladder of a document.
    pub fn of(document: &Document) -> Drawn {
        let emitted = Emitted::of(document);
        let mut ladder = Ladder::empty();
        let (mut first, mut timers) = (0, 0);
        for codes in emitted.rungs() {
            let drums = codes.iter().map(|code| match code.what {
                What::Step(step) => shown::drum(step),
                What::Form(..) => Vec::new(),
            });
            let drums: Vec<Vec<u8>> = drums.collect();
            let steps = codes
                .iter()
                .zip(&drums)
                .map(|(code, drum)| match code.what {
                    What::Step(step) => shown::instruction(step, drum),
                    What::Form(opcode, number) => shown::form(opcode, number),
                });
            let steps: Vec<Instruction<'_>> = steps.collect();
            ladder.rung(first, &steps, &mut timers);
            first += codes.len();
        }
        let mut elements = Vec::with_capacity(ladder.elements.len());
        for element in &mut ladder.elements {
            let code = &emitted.codes[element.conducts];
            if let What::Step(step) = code.what {
                shown::question(step, &mut element.symbol);
            }
            elements.push(code.of);
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
