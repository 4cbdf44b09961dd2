//! What a diagram means: as `PLCGenerator.py` of Beremiz writes it down, statement by statement.

use super::model::{BITS, Diagram, Kind, NUMBERS};
use std::collections::{HashMap, HashSet};

/// A diagram as it runs.
pub(super) struct Naive<'d> {
    diagram: &'d Diagram,
    order: Vec<usize>,
    variables: HashMap<String, i64>,
    /// What each block gave last, by its outputs.
    given: HashMap<(usize, &'d str), i64>,
    /// What function blocks and edges remember.
    memory: HashMap<(usize, String), i64>,
    /// The blocks of this scan that are computed.
    computed: HashSet<usize>,
    /// What a connector leads on in this scan.
    now: i64,
}

impl<'d> Naive<'d> {
    pub(super) fn new(diagram: &'d Diagram) -> Naive<'d> {
        let acts = |at: &usize| {
            let kind = &diagram.elements[*at].kind;
            matches!(kind, Kind::Variable(_) | Kind::Block(..))
        };
        let mut order: Vec<usize> = (0..diagram.elements.len()).filter(acts).collect();
        order.sort_by_key(|at| {
            let element = &diagram.elements[*at];
            let is_block = matches!(element.kind, Kind::Block(..));
            match element.order {
                0 => (u32::MAX, is_block, element.place, *at),
                order => (order, false, element.place, *at),
            }
        });
        Naive {
            diagram,
            order,
            variables: HashMap::new(),
            given: HashMap::new(),
            memory: HashMap::new(),
            computed: HashSet::new(),
            now: 0,
        }
    }

    /// One scan; its outputs.
    pub(super) fn scan(&mut self, inputs: u128, now: i64) -> u128 {
        for bit in 0..BITS {
            let value = inputs >> bit & 1;
            self.variables.insert(format!("i{bit}"), value as i64);
        }
        self.now = now;
        self.computed.clear();
        for at in self.order.clone() {
            match &self.diagram.elements[at].kind {
                Kind::Variable(name) => self.assign(at, name),
                _ => self.compute(at),
            }
        }
        let outputs = (0..BITS + NUMBERS).map(|bit| {
            let value = self.variables.get(&format!("q{bit}"));
            u128::from(value.is_some_and(|value| *value != 0)) << bit
        });
        outputs.sum()
    }

    fn assign(&mut self, at: usize, name: &str) {
        let element = &self.diagram.elements[at];
        let from = element.pins[0].from.unwrap();
        let value = self.source(from, false) ^ i64::from(element.negated);
        let block = &self.diagram.elements[from.0];
        let is_block = matches!(block.kind, Kind::Block(..));
        let is_enabled = block.pins.iter().any(|pin| pin.name == "EN");
        let is_eno = block.outputs[from.1].0 == "ENO";
        if is_block && is_enabled && !is_eno && self.of(from.0, "ENO") == 0 {
            return;
        }
        self.variables.insert(name.to_owned(), value);
    }

    fn of(&self, at: usize, output: &'d str) -> i64 {
        self.given.get(&(at, output)).copied().unwrap_or(0)
    }

    /// What an output brings; `waits`: without asking for it.
    fn source(&mut self, (at, output): (usize, usize), waits: bool) -> i64 {
        let element = &self.diagram.elements[at];
        match &element.kind {
            Kind::Value(written) => {
                let value = match written.strip_prefix("T#") {
                    Some(time) => time.trim_end_matches("ms").parse().unwrap(),
                    None => match written.parse() {
                        Ok(value) => value,
                        Err(_) => self.variables.get(written).copied().unwrap_or(0),
                    },
                };
                value ^ i64::from(element.negated)
            }
            Kind::Continuation(name) => {
                let mut elements = self.diagram.elements.iter();
                let is = |kind: &Kind| matches!(kind, Kind::Connector(of) if of == name);
                let connector = elements.find(|element| is(&element.kind)).unwrap();
                self.source(connector.pins[0].from.unwrap(), waits)
            }
            _ => {
                if !waits {
                    self.compute(at);
                }
                let (name, _, negated) = element.outputs[output];
                self.of(at, name) ^ i64::from(negated)
            }
        }
    }

    fn compute(&mut self, at: usize) {
        if !self.computed.insert(at) {
            return;
        }
        let element = &self.diagram.elements[at];
        let Kind::Block(name, instance) = &element.kind else {
            return;
        };
        let mut pins: HashMap<&str, i64> = HashMap::new();
        for (index, pin) in element.pins.iter().enumerate() {
            let mut value = self.source(pin.from.unwrap(), element.order > 0);
            value ^= i64::from(pin.negated);
            if !pin.edge.is_empty() {
                // The first scan is no falling edge.
                let before = self.remember(at, &format!("edge{index}"), value);
                let before = before.unwrap_or(0);
                value = match pin.edge {
                    "rising" => value & (1 - before),
                    _ => (1 - value) & before,
                };
            }
            pins.insert(&pin.name, value);
        }
        let enabled = pins.get("EN").copied();
        if let Some(enabled) = enabled {
            self.given.insert((at, "ENO"), enabled);
        }
        if enabled == Some(0) {
            if instance.is_none() && element.outputs.iter().any(|(_, truth, _)| *truth) {
                let (output, truth, _) = *element.outputs.last().unwrap();
                if truth {
                    self.given.insert((at, output), 0);
                }
            }
            return;
        }
        let of = |pin: &str| pins.get(pin).copied().unwrap_or(0);
        let (left, right) = (of("IN1"), of("IN2"));
        let wrapped = |value: i64| i64::from(value as i32);
        let results: Vec<(&'d str, i64)> = match *name {
            "AND" => vec![("OUT", left & right)],
            "OR" => vec![("OUT", left | right)],
            "XOR" => vec![("OUT", left ^ right)],
            "NOT" => vec![("OUT", 1 - of("IN"))],
            "ADD" => vec![("OUT", wrapped(left + right))],
            "SUB" => vec![("OUT", wrapped(left - right))],
            "GT" => vec![("OUT", i64::from(left > right))],
            "EQ" => vec![("OUT", i64::from(left == right))],
            "MOVE" => vec![("OUT", of("IN"))],
            "SEL" => vec![("OUT", if of("G") == 0 { of("IN0") } else { of("IN1") })],
            "SR" => vec![("Q1", of("S1") | self.of(at, "Q1") & (1 - of("R")))],
            "RS" => vec![("Q1", (of("S") | self.of(at, "Q1")) & (1 - of("R1")))],
            "R_TRIG" => {
                let before = self.remember(at, "CLK", of("CLK")).unwrap_or(0);
                vec![("Q", of("CLK") & (1 - before))]
            }
            "CTU_DINT" => {
                let before = self.remember(at, "CU", of("CU")).unwrap_or(0);
                let mut count = self.of(at, "CV");
                if of("R") != 0 {
                    count = 0;
                } else if of("CU") != 0 && before == 0 {
                    count += 1;
                }
                vec![("CV", count), ("Q", i64::from(count >= of("PV").max(0)))]
            }
            _ => {
                let now = self.now;
                let since = self.memory.get(&(at, "since".to_owned())).copied();
                let since = (of("IN") != 0).then(|| since.unwrap_or(now));
                self.memory.remove(&(at, "since".to_owned()));
                if let Some(since) = since {
                    self.remember(at, "since", since);
                }
                let is_over = since.is_some_and(|since| now - since >= of("PT"));
                vec![("Q", i64::from(is_over))]
            }
        };
        for (output, value) in results {
            self.given.insert((at, output), value);
        }
    }

    /// Keeps something; what was kept before.
    fn remember(&mut self, at: usize, what: &str, value: i64) -> Option<i64> {
        self.memory.insert((at, what.to_owned()), value)
    }
}
