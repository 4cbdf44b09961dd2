//! The elements of a ladder body, and the wires between them.

use crate::found::{Found, span};
use crate::numbered::numbers;
use crate::xml::{all, first, says, text};
use roxmltree::Node;
use std::collections::HashMap;
use unoclp_lang::{Code, Diagnostic, Word};

/// More elements than this are in no series.
pub(crate) const DEEPEST: usize = 200;

/// A ladder body.
pub(crate) struct Network<'a, 'x> {
    /// What the POU is called.
    pub pou: String,
    /// Whether it is a function block diagram.
    pub is_blocks: bool,
    pub elements: Vec<Element<'a, 'x>>,
    /// What the outputs of each element lead to.
    pub readers: Vec<Vec<Reader<'a>>>,
    /// Whether its elements run in the order of the file.
    is_in_order: bool,
    /// In which rung each element stands, from 1; none of rails, labels and comments.
    rungs: Vec<Option<usize>>,
    by_id: HashMap<&'a str, usize>,
    /// The first connector of each name.
    connectors: HashMap<&'a str, usize>,
    /// The continuations of each name.
    continued: HashMap<&'a str, Vec<usize>>,
}

/// A contact, a coil, a block, or whatever else is drawn.
pub(crate) struct Element<'a, 'x> {
    pub node: Node<'a, 'x>,
    /// The name of its XML element: `contact`.
    pub kind: &'x str,
    /// The variable of a contact or a coil, the expression of a value.
    pub written: String,
    /// When it runs, where that is said, from 1.
    pub order: Option<u32>,
    /// Where it stands: from top to bottom, from left to right.
    pub place: (i64, i64),
    /// What it has as inputs; the only one of a contact has no name.
    pub inputs: Vec<Pin<'a>>,
    /// What its outputs are called, and whether they are negated.
    pub outputs: Vec<(&'a str, bool)>,
}

/// An input.
pub(crate) struct Pin<'a> {
    pub name: &'a str,
    pub negated: bool,
    /// `rising`, `falling`; else empty.
    pub edge: &'a str,
    /// Where its wires come from.
    pub wires: Vec<Wire<'a>>,
}

/// The end of a wire: the element that it leads to.
#[derive(Clone, Copy)]
pub(crate) struct Reader<'a> {
    pub at: usize,
    /// The output that leads there.
    pub output: &'a str,
}

/// The beginning of a wire: an output of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Wire<'a> {
    /// The place of the element in the network.
    pub from: usize,
    /// The name of the output, where it has one.
    pub output: &'a str,
}

impl<'a, 'x: 'a> Network<'a, 'x> {
    /// Where an element comes among the others: from top to bottom and from left to right, or in the order of the file.
    pub(crate) fn turn(&self, at: usize) -> ((i64, i64), usize) {
        match self.is_in_order {
            true => ((0, 0), at),
            false => (self.elements[at].place, at),
        }
    }

    /// The elements of a body; wires that come from nowhere are told.
    pub(crate) fn read(pou: &str, body: Node<'a, 'x>, found: &mut Found) -> Network<'a, 'x> {
        let mut network = Network {
            pou: pou.to_owned(),
            is_blocks: body.tag_name().name() == "FBD",
            elements: Vec::new(),
            readers: Vec::new(),
            is_in_order: is_in_order(body),
            rungs: Vec::new(),
            by_id: HashMap::new(),
            connectors: HashMap::new(),
            continued: HashMap::new(),
        };
        let nodes: Vec<Node<'_, '_>> = body.children().filter(Node::is_element).collect();
        // What is wrong is reported once it is known in which rung it stands.
        let mut wrong = Vec::new();
        for (index, node) in nodes.iter().enumerate() {
            let Some(local) = node.attribute("localId") else {
                continue;
            };
            if network.by_id.insert(local, index).is_some() {
                wrong.push((index, Code::XmlSameId, *node, None));
            }
        }
        for (index, node) in nodes.into_iter().enumerate() {
            let element = network.element(index, node, &mut wrong);
            network.elements.push(element);
        }
        network.link();
        network.rungs = network.numbered();
        for (index, code, node, word) in wrong {
            let mut words = vec![network.name(index).into()];
            words.extend(word);
            found.take(Diagnostic::new(code, span(node), words));
        }
        network
    }

    /// In which rung each element stands.
    fn numbered(&self) -> Vec<Option<usize>> {
        let beside = [
            "leftPowerRail",
            "rightPowerRail",
            "label",
            "comment",
            "vendorElement",
        ];
        let elements = self.elements.iter();
        let places: Vec<Option<(i64, i64)>> = elements
            .map(|element| (!beside.contains(&element.kind)).then_some(element.place))
            .collect();
        let elements = self.elements.iter().enumerate();
        let wires = elements
            .filter(|(_, element)| element.kind != "rightPowerRail")
            .flat_map(|(at, element)| {
                let wires = element.inputs.iter().flat_map(|pin| &pin.wires);
                wires.map(move |wire| (wire.from, at))
            })
            .filter(|(from, _)| self.elements[*from].kind != "leftPowerRail");
        numbers(&places, wires)
    }

    /// Notes where outputs and connectors lead.
    fn link(&mut self) {
        self.readers.resize_with(self.elements.len(), Vec::new);
        for (at, element) in self.elements.iter().enumerate() {
            for pin in &element.inputs {
                for wire in &pin.wires {
                    let output = wire.output;
                    self.readers[wire.from].push(Reader { at, output });
                }
            }
            let name = element.node.attribute("name").unwrap_or_default();
            match element.kind {
                "connector" => drop(self.connectors.entry(name).or_insert(at)),
                "continuation" => self.continued.entry(name).or_default().push(at),
                _ => {}
            }
        }
    }

    /// The connector that a continuation goes on from.
    pub(crate) fn connector(&self, continuation: usize) -> Option<usize> {
        let name = self.elements[continuation].node.attribute("name");
        self.connectors.get(name.unwrap_or_default()).copied()
    }

    /// The same; where there is none, that is told.
    pub(crate) fn continued_from(&self, continuation: usize, found: &mut Found) -> Option<usize> {
        let connector = self.connector(continuation);
        if connector.is_none() {
            let name = self.elements[continuation].node.attribute("name");
            let name = name.unwrap_or_default();
            self.tell(found, Code::XmlPin, continuation, [name.into()]);
        }
        connector
    }

    /// Tells that more elements hang together there than a rung may have.
    pub(crate) fn too_large(&self, at: usize, found: &mut Found) {
        let (en, pt) = self.name(at);
        let word = Word::from((
            format!("{en}: more elements than fit in a rung"),
            format!("{pt}: mais elementos do que cabem em um degrau"),
        ));
        found.tell_at(Code::XmlTooLarge, span(self.elements[at].node), [word]);
    }

    /// What goes on from a connector: of several with one name, from the first.
    pub(crate) fn continuations(&self, connector: usize) -> &[usize] {
        let name = self.elements[connector].node.attribute("name");
        let name = name.unwrap_or_default();
        match self.connectors.get(name) == Some(&connector) {
            true => self.continued.get(name).map_or(&[], |at| at),
            false => &[],
        }
    }

    /// The rung in which an element stands, from 1.
    pub(crate) fn rung(&self, element: usize) -> usize {
        self.rungs.get(element).copied().flatten().unwrap_or(0)
    }

    /// The first element that takes what a block gives beyond a label, a jump or a return.
    pub(crate) fn crossing(&self) -> Option<usize> {
        let parts =
            |element: &&Element<'_, '_>| matches!(element.kind, "label" | "jump" | "return");
        let heights = self.elements.iter().filter(parts).map(|e| e.place.0);
        let mut heights: Vec<i64> = heights.collect();
        heights.sort_unstable();
        let part = |at: usize| heights.partition_point(|h| *h < self.elements[at].place.0);
        (0..self.elements.len()).find(|&at| {
            let mut wires = self.elements[at].inputs.iter().flat_map(|pin| &pin.wires);
            wires.any(|wire| {
                let is_value = self.elements[wire.from].kind == "inVariable";
                !is_value && part(wire.from) != part(at)
            })
        })
    }

    /// Whether power ends at an element that drives nothing: a right rail, or a connector that nothing continues.
    pub(crate) fn is_end(&self, at: usize) -> bool {
        match self.elements[at].kind {
            "rightPowerRail" => true,
            "connector" => self.continuations(at).is_empty(),
            _ => false,
        }
    }

    /// `Main`, rung 3, contact `a`.
    pub(crate) fn name(&self, element: usize) -> (String, String) {
        let pou = &self.pou;
        let Some(drawn) = self.elements.get(element) else {
            return (format!("`{pou}`"), format!("`{pou}`"));
        };
        let (en, pt) = drawn.called();
        match self.rungs.get(element).copied().flatten() {
            Some(rung) if self.is_blocks => (
                format!("`{pou}`, network {rung}, {en}"),
                format!("`{pou}`, rede {rung}, {pt}"),
            ),
            Some(rung) => (
                format!("`{pou}`, rung {rung}, {en}"),
                format!("`{pou}`, degrau {rung}, {pt}"),
            ),
            None => (format!("`{pou}`, {en}"), format!("`{pou}`, {pt}")),
        }
    }

    /// Tells something of an element.
    pub(crate) fn tell<const N: usize>(
        &self,
        found: &mut Found,
        code: Code,
        at: usize,
        words: [Word; N],
    ) {
        let who = [Word::from(self.name(at))];
        let words: Vec<Word> = who.into_iter().chain(words).collect();
        let place = span(self.elements[at].node);
        found.take(Diagnostic::new(code, place, words));
    }

    fn element(
        &self,
        index: usize,
        node: Node<'a, 'x>,
        wrong: &mut Vec<Wrong<'a, 'x>>,
    ) -> Element<'a, 'x> {
        let number = |of: Node<'_, '_>, name| {
            let number: f64 = of
                .attribute(name)
                .and_then(|n| n.parse().ok())
                .unwrap_or(0.0);
            number as i64
        };
        let place = first(node, "position").map_or((0, 0), |at| (number(at, "y"), number(at, "x")));
        let written = first(node, "variable").or_else(|| first(node, "expression"));
        let mut written = written.map_or(String::new(), text).trim().to_owned();
        if written.len() > LONGEST {
            wrong.push((
                index,
                Code::XmlLong,
                node,
                Some(written.len().to_string().into()),
            ));
            written = written.chars().take(SHOWN).collect();
        }
        let order = node.attribute("executionOrderId");
        let mut element = Element {
            node,
            written,
            order: order.and_then(|n| n.parse().ok()).filter(|n| *n > 0),
            kind: node.tag_name().name(),
            place,
            inputs: Vec::new(),
            outputs: Vec::new(),
        };
        for of in all(node, "connectionPointIn") {
            let pin = self.pin(index, of, "", wrong);
            // A right rail has many; they are one to us.
            match element.inputs.first_mut() {
                Some(first) => first.wires.extend(pin.wires),
                None => element.inputs.push(pin),
            }
        }
        if first(node, "connectionPointOut").is_some() {
            element.outputs.push(("", false));
        }
        // CODESYS numbers the only input of these too.
        let has_one_input = matches!(&*element.block(), "MOVE" | "NOT");
        for section in ["inputVariables", "inOutVariables", "outputVariables"] {
            let variables = all(node, section).flat_map(|section| all(section, "variable"));
            for variable in variables {
                let name = variable.attribute("formalParameter").unwrap_or_default();
                let name = match has_one_input && name.eq_ignore_ascii_case("IN1") {
                    true => "IN",
                    false => name,
                };
                for of in all(variable, "connectionPointIn") {
                    let mut pin = self.pin(index, of, name, wrong);
                    pin.negated = says(variable, "negated");
                    pin.edge = edge(variable);
                    element.inputs.push(pin);
                }
                if section != "inputVariables" {
                    element.outputs.push((name, says(variable, "negated")));
                }
            }
        }
        element
    }

    fn pin(
        &self,
        index: usize,
        of: Node<'a, 'x>,
        name: &'a str,
        wrong: &mut Vec<Wrong<'a, 'x>>,
    ) -> Pin<'a> {
        let mut wires = Vec::new();
        for connection in all(of, "connection") {
            let id = connection.attribute("refLocalId").unwrap_or_default();
            let output = connection.attribute("formalParameter").unwrap_or_default();
            match self.by_id.get(id) {
                Some(&from) => wires.push(Wire { from, output }),
                None => wrong.push((index, Code::XmlWire, connection, None)),
            }
        }
        Pin {
            name,
            negated: false,
            edge: "",
            wires,
        }
    }
}

/// Whether the elements of a body run in the order of the file, which is that in which they were drawn: so OpenPLC Editor
/// and Beremiz have it since 2024; before, they ran from top to bottom. Neither knows jumps and labels, which have places.
fn is_in_order(body: Node<'_, '_>) -> bool {
    let project = body.document().root_element();
    let header = first(project, "contentHeader");
    let saved = header.and_then(|header| header.attribute("modificationDateTime"));
    let parts = |node: Node<'_, '_>| matches!(node.tag_name().name(), "jump" | "label" | "return");
    saved.is_some_and(|saved| saved >= IN_ORDER) && !body.children().any(parts)
}

/// Projects that were saved since then run in the order of the file.
const IN_ORDER: &str = "2024";

/// What is wrong with an element: at which place in the file, and a word for it.
type Wrong<'a, 'x> = (usize, Code, Node<'a, 'x>, Option<Word>);

impl<'a> Element<'a, '_> {
    /// Whether it is a coil or a variable to which nothing leads, as editors let one lie about.
    pub(crate) fn is_loose(&self) -> bool {
        matches!(self.kind, "coil" | "outVariable") && self.wires("").is_empty()
    }

    /// What it is called in a message: by its instance, its type, its variable.
    fn called(&self) -> (String, String) {
        let attribute = |name| self.node.attribute(name).unwrap_or_default();
        let block = match attribute("instanceName") {
            "" => format!("`{}`", attribute("typeName")),
            instance => format!("`{instance}` ({})", attribute("typeName")),
        };
        let (en, pt, name) = match self.kind {
            "block" => return (format!("block {block}"), format!("bloco {block}")),
            "contact" => ("contact", "contato", &*self.written),
            "coil" => ("coil", "bobina", &*self.written),
            "inVariable" => ("value", "valor", &*self.written),
            "outVariable" | "inOutVariable" => ("variable", "variável", &*self.written),
            "jump" => ("jump to", "desvio para", attribute("label")),
            "label" => ("label", "rótulo", attribute("label")),
            "connector" | "continuation" => ("connector", "conector", attribute("name")),
            "return" => return ("return".to_owned(), "retorno".to_owned()),
            "leftPowerRail" | "rightPowerRail" => return ("rail".to_owned(), "barra".to_owned()),
            kind => return (format!("element {kind}"), format!("elemento {kind}")),
        };
        match name {
            "" => (en.to_owned(), pt.to_owned()),
            name => (format!("{en} `{name}`"), format!("{pt} `{name}`")),
        }
    }

    /// The input with this name.
    pub(crate) fn input(&self, name: &str) -> Option<&Pin<'a>> {
        let mut inputs = self.inputs.iter();
        inputs.find(|pin| pin.name.eq_ignore_ascii_case(name))
    }

    /// The wires to the input with this name.
    pub(crate) fn wires(&self, name: &str) -> &[Wire<'a>] {
        self.input(name).map_or(&[], |pin| &pin.wires)
    }

    /// The type of a block, in upper case.
    pub(crate) fn block(&self) -> String {
        let name = self.node.attribute("typeName").unwrap_or_default();
        name.to_uppercase()
    }

    /// Whether what it gives is inverted.
    pub(crate) fn negated(&self) -> bool {
        says(self.node, "negated")
    }

    /// Whether this output of a block is negated.
    pub(crate) fn is_negated(&self, output: &str) -> bool {
        let mut outputs = self.outputs.iter();
        outputs.any(|(name, negated)| *negated && name.eq_ignore_ascii_case(output))
    }

    /// Whether it is a block that remembers something which can be read elsewhere.
    pub(crate) fn remembers(&self) -> bool {
        let block = self.block();
        let base = block.split('_').next().unwrap_or_default();
        self.kind == "block"
            && matches!(
                base,
                "TON" | "TOF" | "TP" | "CTU" | "CTD" | "CTUD" | "SR" | "RS"
            )
    }
}

/// The most bytes of a variable or an expression.
const LONGEST: usize = 1_000;

/// So many characters of a longer one are shown.
const SHOWN: usize = 40;

/// `rising`, `falling`; else empty.
pub(crate) fn edge<'a>(of: Node<'a, '_>) -> &'a str {
    let edge = of.attribute("edge");
    edge.filter(|edge| matches!(*edge, "rising" | "falling"))
        .unwrap_or_default()
}
