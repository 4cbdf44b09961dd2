//! Counters: which block each is, and which rungs are its inputs.

use std::collections::HashMap;
use unoclp_core::isa::Opcode;
use unoclp_draw::edit::{Document, Element, Node, Rung, Step, visit};

/// What is done to a counter, in the order in which a block does it, and the input that asks for it.
const INPUTS: [(Opcode, &str); 4] = [
    (Opcode::CountUp, "CU"),
    (Opcode::CountDown, "CD"),
    (Opcode::LoadCounter, "LD"),
    (Opcode::ResetCounter, "R"),
];

/// Which input of a counter an instruction is.
pub(crate) fn input(step: &Step) -> Option<(usize, &'static str)> {
    let mut inputs = INPUTS.iter().enumerate();
    inputs.find_map(|(at, (opcode, name))| (*opcode == step.opcode()).then_some((at, *name)))
}

/// The counters of a document.
pub(crate) struct Counters(HashMap<u8, Uses>);

/// How a counter is used.
#[derive(Clone, Copy, Default)]
struct Uses {
    /// How often each of its inputs is there.
    inputs: [usize; 4],
    /// Whether something asks if it has reached its preset, and if it is at 0.
    reached: bool,
    zero: bool,
}

impl Counters {
    pub(crate) fn of(document: &Document) -> Counters {
        let mut counters: HashMap<u8, Uses> = HashMap::new();
        for rung in document.rungs() {
            visit(&rung.series, &mut |node| {
                let Node::Element(Element { step, .. }) = node else {
                    return;
                };
                let Some(number) = step.number() else { return };
                match (step.opcode(), input(step)) {
                    (_, Some((input, _))) => {
                        counters.entry(number).or_default().inputs[input] += 1;
                    }
                    (Opcode::CounterContact | Opcode::CounterContactNot, _) => {
                        counters.entry(number).or_default().reached = true;
                    }
                    (Opcode::ZeroContact | Opcode::ZeroContactNot, _) => {
                        counters.entry(number).or_default().zero = true;
                    }
                    _ => {}
                }
            });
        }
        Counters(counters)
    }

    /// The block of a counter; none where it is none.
    pub(crate) fn kind(&self, number: u8) -> Option<&'static str> {
        let uses = self.0.get(&number)?;
        let [up, down, load, reset] = uses.inputs;
        if up + down == 0 || uses.inputs.iter().any(|count| *count > 1) {
            return None;
        }
        Some(match () {
            () if down + load == 0 && !uses.zero => "CTU",
            () if up + reset == 0 && !uses.reached => "CTD",
            () => "CTUD",
        })
    }

    /// How many rungs from the first of these on are the inputs of one block, which nothing follows.
    pub(crate) fn together(&self, rungs: &[&Rung]) -> Option<usize> {
        let last = |rung: &Rung| match rung.series.last() {
            Some(Node::Element(element)) => Some((element.step.number()?, input(&element.step)?.0)),
            _ => None,
        };
        let (number, _) = last(rungs.first()?)?;
        let kind = self.kind(number)?;
        let mut least = 0;
        let follows = |(at, rung): &(usize, &&Rung)| {
            let plain = rung.labels.is_empty() && rung.comment.is_empty();
            match last(rung) {
                Some((counter, input)) if counter == number && input >= least => {
                    least = input + 1;
                    *at == 0 || plain
                }
                _ => false,
            }
        };
        let count = rungs.iter().enumerate().take_while(follows).count();
        let all: usize = self.0.get(&number)?.inputs.iter().sum();
        (count == all && (count > 1 || kind == "CTUD")).then_some(count)
    }

    /// Whether a counter only counts, so that its block may be in a rung.
    pub(crate) fn counts_only(&self, number: u8) -> bool {
        let uses = self.0.get(&number).copied().unwrap_or_default();
        uses.inputs.iter().sum::<usize>() == 1 && self.kind(number) != Some("CTUD")
    }
}
