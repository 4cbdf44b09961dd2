//! The paths of the power through a network, from where a wire ends to the left rail.
//!
//! Owns how wires are followed: each once, in no circle, not too deep, and no more of them than a board could hold. Must not
//! know what an element becomes there: instructions (`flow`) or words of a text (`st`).

use crate::circuit::{Circuit, together};
use crate::found::Found;
use crate::network::{DEEPEST, Network, Wire};
use std::collections::HashMap;
use unoclp_lang::{Code, Word};

/// A circuit has no more parts.
const LARGEST: usize = 2_000;

/// How far wires have been followed.
#[derive(Default)]
pub(crate) struct Walk<'a> {
    /// What the beginnings of wires have come to.
    known: HashMap<Wire<'a>, Option<Circuit>>,
    /// The elements on the way to where it is.
    pub open: Vec<usize>,
    /// How many parts of circuits have been looked at.
    pub work: usize,
}

/// Who follows wires.
pub(crate) trait Ways<'n, 'a: 'n, 'x: 'a> {
    /// The most parts of circuits that are looked at.
    const MOST_WORK: usize;

    /// How much more a part counts that a wire brings, and that is copied.
    const COPIED: usize;

    fn network(&self) -> &'n Network<'a, 'x>;
    fn found(&mut self) -> &mut Found;
    fn walk(&mut self) -> &mut Walk<'a>;

    /// How many parts a circuit has.
    fn parts(&self, circuit: &Circuit) -> usize;

    /// What a wire brings that leads back to where it came from; none where it has to be followed.
    fn back(&mut self, _: Wire<'a>) -> Option<Option<Circuit>> {
        None
    }

    /// The way to the right side of a contact; none, with a message, where something is wrong.
    fn at_contact(&mut self, at: usize) -> Option<Circuit>;

    /// That of a coil.
    fn at_coil(&mut self, at: usize) -> Option<Circuit>;

    /// That of a value which is written at an element.
    fn at_value(&mut self, at: usize) -> Option<Circuit>;

    /// What an output of a block gives.
    fn at_block(&mut self, wire: Wire<'a>) -> Option<Circuit>;

    /// What leads to an input of an element.
    fn input(&mut self, at: usize, name: &str) -> Option<Circuit> {
        let pin = self.network().elements[at].input(name);
        let Some(pin) = pin.filter(|pin| !pin.wires.is_empty()) else {
            let what = match name {
                "" => ("it", "ele").into(),
                name => Word::from(name),
            };
            self.tell(Code::XmlPin, at, [what]);
            return None;
        };
        let mut ways = Vec::with_capacity(pin.wires.len());
        for &wire in &pin.wires {
            let way = self.source(wire)?;
            self.spend(at, Self::COPIED * (1 + self.parts(&way)))?;
            ways.push(way);
        }
        let circuit = match ways.len() {
            1 => ways.remove(0),
            _ => together(ways),
        };
        if self.parts(&circuit) > LARGEST {
            self.too_large(at);
            return None;
        }
        Some(circuit)
    }

    /// The way to the beginning of a wire.
    fn source(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        if let Some(known) = self.walk().known.get(&wire) {
            return known.clone();
        }
        if let Some(given) = self.back(wire) {
            return given;
        }
        self.descend(wire.from)?;
        let circuit = self.begin(wire);
        self.ascend();
        self.walk().known.insert(wire, circuit.clone());
        circuit
    }

    /// The same, which is not known yet.
    fn begin(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        let (at, network) = (wire.from, self.network());
        match network.elements[at].kind {
            "leftPowerRail" => Some(Circuit::new()),
            "contact" => self.at_contact(at),
            "coil" => self.at_coil(at),
            "inVariable" | "inOutVariable" => self.at_value(at),
            "block" => self.at_block(wire),
            "continuation" => {
                let connector = network.continued_from(at, self.found())?;
                self.input(connector, "")
            }
            kind => {
                self.tell(Code::XmlElement, at, [kind.into()]);
                None
            }
        }
    }

    /// Whether the element that is looked at is this one.
    fn is_at(&mut self, at: usize) -> bool {
        self.walk().open.last() == Some(&at)
    }

    /// Goes on at this element, where that leads in no circle and not too deep.
    fn descend(&mut self, at: usize) -> Option<()> {
        if self.walk().open.contains(&at) {
            self.tell(Code::XmlLoop, at, []);
            return None;
        }
        if self.walk().open.len() >= DEEPEST {
            self.too_large(at);
            return None;
        }
        self.walk().open.push(at);
        Some(())
    }

    /// Comes back from there.
    fn ascend(&mut self) {
        self.walk().open.pop();
    }

    /// Counts parts that are looked at for an element; none where they are too many, which is reported.
    fn spend(&mut self, at: usize, parts: usize) -> Option<()> {
        let walk = self.walk();
        walk.work = walk.work.saturating_add(parts);
        if walk.work > Self::MOST_WORK {
            self.too_large(at);
            return None;
        }
        Some(())
    }

    /// Tells something of an element.
    fn tell<const N: usize>(&mut self, code: Code, at: usize, words: [Word; N]) {
        let network = self.network();
        network.tell(self.found(), code, at, words);
    }

    fn too_large(&mut self, at: usize) {
        let network = self.network();
        network.too_large(at, self.found());
    }
}
