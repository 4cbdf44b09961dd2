//! Random diagrams.

use super::model::{BITS, BLOCKS, Diagram, Element, Kind, NUMBERS, Pin, inputs, outputs};
use unoclp_testing::Random;

/// A diagram of a few blocks, wired at random, in circles too; `forward`: in none, and nothing says when it runs.
pub(super) fn random_diagram(random: &mut Random, forward: bool) -> Diagram {
    let mut diagram = Diagram::default();
    let count = 2 + random.below(if forward { 3 } else { 7 });
    for index in 0..count {
        let (name, has_instance) = match forward {
            true => {
                random.pick(&BLOCKS.map(|block| if block.0 == "SEL" { BLOCKS[0] } else { block }))
            }
            false => random.pick(&BLOCKS),
        };
        diagram.block(name, has_instance.then(|| format!("f{index}")), random);
    }
    let connectors = random.below(3);
    for name in 0..connectors {
        let mut connector = plain(Kind::Connector(name), random);
        connector.pins.push(pin("", true));
        diagram.elements.push(connector);
        for _ in 0..=random.below(2) {
            let mut continuation = plain(Kind::Continuation(name), random);
            continuation.outputs.push(("", true, false));
            diagram.elements.push(continuation);
        }
    }
    for bit in 0..BITS {
        diagram.variable(format!("q{bit}"), true, random);
    }
    for bit in 0..random.below(BITS) {
        diagram.variable(format!("b{bit}"), true, random);
    }
    for number in 0..NUMBERS {
        diagram.variable(format!("n{number}"), false, random);
    }
    for number in 0..NUMBERS {
        diagram.shown(number, random);
    }
    if forward {
        for element in &mut diagram.elements {
            element.order = 0;
            element.pins.retain(|pin| pin.name != "EN");
            element.outputs.retain(|output| output.0 != "ENO");
        }
    }
    diagram.wire(random, forward);
    diagram
}

fn plain(kind: Kind, random: &mut Random) -> Element {
    Element {
        kind,
        negated: false,
        order: 0,
        place: (random.below(40) as i64, random.below(1_000) as i64),
        pins: Vec::new(),
        outputs: Vec::new(),
    }
}

fn pin(name: &str, is_truth: bool) -> Pin {
    Pin {
        name: name.to_owned(),
        is_truth,
        negated: false,
        edge: "",
        from: None,
    }
}

impl Diagram {
    fn block(&mut self, name: &'static str, instance: Option<String>, random: &mut Random) {
        let mut block = plain(Kind::Block(name, instance), random);
        if random.percent(25) {
            block.order = 1 + random.below(6) as u32;
        }
        if name != "TON" && random.percent(25) {
            block.pins.push(pin("EN", true));
            block.outputs.push(("ENO", true, false));
        }
        for (input, is_truth) in inputs(name) {
            let mut input = pin(input, *is_truth);
            if *is_truth && random.percent(15) {
                input.negated = true;
            }
            if *is_truth && input.name != "G" && random.percent(8) {
                input.edge = random.pick(&["rising", "falling"]);
            }
            block.pins.push(input);
        }
        for (output, is_truth) in outputs(name) {
            let negated = *is_truth && random.percent(15);
            block.outputs.push((output, *is_truth, negated));
        }
        self.elements.push(block);
    }

    fn variable(&mut self, name: String, is_truth: bool, random: &mut Random) {
        let mut variable = plain(Kind::Variable(name), random);
        variable.negated = is_truth && random.percent(15);
        if random.percent(15) {
            variable.order = 1 + random.below(6) as u32;
        }
        variable.pins.push(pin("", is_truth));
        self.elements.push(variable);
    }

    /// An output that shows a number: `q4 := n0 > 5`, at the bottom.
    fn shown(&mut self, number: usize, random: &mut Random) {
        let first = self.elements.len();
        for value in [format!("n{number}"), "5".to_owned()] {
            let mut value = plain(Kind::Value(value), random);
            value.outputs.push(("", false, false));
            self.elements.push(value);
        }
        let mut block = plain(Kind::Block("GT", None), random);
        block.pins = vec![pin("IN1", false), pin("IN2", false)];
        block.pins[0].from = Some((first, 0));
        block.pins[1].from = Some((first + 1, 0));
        block.outputs.push(("OUT", true, false));
        self.elements.push(block);
        let mut variable = plain(Kind::Variable(format!("q{}", BITS + number)), random);
        variable.place = (100 + number as i64, 0);
        variable.pins.push(pin("", true));
        variable.pins[0].from = Some((first + 2, 0));
        self.elements.push(variable);
    }

    /// Leads something to each input: often a value, else an output of any block.
    fn wire(&mut self, random: &mut Random, forward: bool) {
        for at in 0..self.elements.len() {
            for of in 0..self.elements[at].pins.len() {
                let pin = &self.elements[at].pins[of];
                if pin.from.is_some() {
                    continue;
                }
                let (is_truth, is_time) = (pin.is_truth, pin.name == "PT");
                let is_connector = matches!(self.elements[at].kind, Kind::Connector(_));
                let last = if forward { at } else { self.elements.len() };
                let chosen = self.source(last, (is_truth, is_connector), random);
                let from = match chosen.filter(|_| !is_time && random.percent(65)) {
                    Some(from) => from,
                    None => (self.value(is_truth, is_time, random), 0),
                };
                self.elements[at].pins[of].from = Some(from);
            }
        }
    }

    /// An output of this type, of the first so many elements; none that a connector may not lead on.
    fn source(
        &self,
        last: usize,
        (is_truth, of_block): (bool, bool),
        random: &mut Random,
    ) -> Option<(usize, usize)> {
        let mut sources = Vec::new();
        for (at, element) in self.elements.iter().enumerate().take(last) {
            let fits = match element.kind {
                Kind::Block(..) => true,
                Kind::Continuation(_) => !of_block,
                _ => false,
            };
            for (index, (_, truth, _)) in element.outputs.iter().enumerate() {
                if fits && *truth == is_truth {
                    sources.push((at, index));
                }
            }
        }
        (!sources.is_empty()).then(|| random.pick(&sources))
    }

    fn value(&mut self, is_truth: bool, is_time: bool, random: &mut Random) -> usize {
        let written = match (is_truth, is_time) {
            (_, true) => format!("T#{}ms", 10 + 10 * random.below(6)),
            (true, _) if random.percent(75) => format!("i{}", random.below(BITS)),
            (true, _) => format!("b{}", random.below(BITS)),
            (false, _) if random.percent(50) => random.below(9).to_string(),
            (false, _) => format!("n{}", random.below(NUMBERS)),
        };
        let mut value = plain(Kind::Value(written), random);
        value.negated = is_truth && random.percent(15);
        value.outputs.push(("", is_truth, false));
        self.elements.push(value);
        self.elements.len() - 1
    }
}
