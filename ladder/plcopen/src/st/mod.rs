//! Bodies as Structured Text: function block diagrams, ladders for which no document has the elements, and lists.
//!
//! Owns in which order the elements of a body become statements. Must not know what a statement compiles to.
//!
//! - `power`: the way of the power to an element, as an expression
//! - `blocks`: calls of function blocks; `functions`: results of functions
//! - `fbd`: function block diagrams, which have an order of their own; `list`: bodies in Instruction List
//! - `jumps`: what a jump to a label below leaves out
//! - `kinds`: of which type a result is, where it is stored
//! - `sentences`: statements as they are written; `units`: what blocks a project has; `what`: what a block is; `wires`:
//!   circles, rungs that write what they read, the calls of an instance, labels
//!
//! A block is called once, before what takes its result first. Wires that lead back to a block bring what it gave in the
//! scan before. Where an instance is drawn several times, each call keeps what it gave.

mod blocks;
mod fbd;
mod functions;
mod jumps;
mod kinds;
pub(crate) mod list;
mod power;
mod sentences;
mod units;
mod what;
mod wires;

pub(crate) use units::Units;

use crate::circuit::Circuit;
use crate::found::{Found, span};
use crate::network::{Element, Network, edge};
use crate::outputs::{sinks, unknown};
use crate::project::{Pou, Variable};
use crate::ways::{Walk, Ways};
use crate::xml::says;
use crate::{pins, unused};
use roxmltree::Node;
use sentences::{Piece, Sentences, piece};
use std::collections::{HashMap, HashSet};
use unoclp_lang::{Code, Span};

/// A body as Structured Text.
#[derive(Default)]
pub(crate) struct Written {
    /// The variables that it needs besides those of its unit, and their types.
    pub variables: Vec<(String, String, Span)>,
    /// Its statements, and from where each piece comes.
    pub pieces: Vec<Piece>,
}

/// Writes the drawn body of a unit; what is wrong with it is told.
pub(crate) fn write<'a, 'x: 'a>(
    pou: &Pou<'a, 'x>,
    body: Node<'a, 'x>,
    globals: &[Variable],
    units: &Units<'_, 'a, 'x>,
    found: &mut Found,
) -> Written {
    let network = Network::read(&pou.name, body, found);
    let is_block = |element: &Element<'_, '_>| units.is_block(element);
    pins::check(&network, found);
    unused::check(&network, found, &is_block);
    for at in unknown(&network) {
        let kind = network.elements[at].kind;
        network.tell(found, Code::XmlElement, at, [kind.into()]);
    }
    let variables = globals.iter().chain(&pou.variables);
    let variables: HashMap<String, &Variable> = variables
        .map(|variable| (variable.name.to_uppercase(), variable))
        .collect();
    let own = what::own(&network, units);
    let mut body = Body {
        taken: variables.keys().cloned().collect(),
        circles: wires::circles(&network, &own),
        rewrites: wires::rewrites(&network, &own),
        own,
        network: &network,
        units,
        result: (pou.kind == "function").then(|| (pou.name.to_uppercase(), units::returns(pou))),
        variables,
        found,
        sentences: Sentences::default(),
        added: Vec::new(),
        begun: HashMap::new(),
        stored: HashSet::new(),
        instances: wires::instances(&network),
        outputs: HashMap::new(),
        labels: wires::labels(&network),
        kept: Vec::new(),
        enos: HashMap::new(),
        shares: shares(&network, units),
        jumps: HashMap::new(),
        enabled: HashMap::new(),
        names: HashMap::new(),
        kinds: HashMap::new(),
        words: HashMap::new(),
        walk: Walk::default(),
        since: 0,
    };
    body.taken.insert(pou.name.to_uppercase());
    if network.is_blocks {
        body.diagram();
        return body.written();
    }
    for sink in sinks(&network, &is_block, true).0 {
        body.pass_labels(Some(sink));
        if body.sink(sink).is_none() && !body.found.has_errors() {
            body.tell(Code::XmlTangle, sink, []);
        }
    }
    body.pass_labels(None);
    for at in (0..network.elements.len()).filter(|at| is_block(&network.elements[*at])) {
        let _ = body.block(at);
    }
    body.written()
}

/// Whether something that a diagram calls reaches beyond itself.
fn shares(network: &Network<'_, '_>, units: &Units<'_, '_, '_>) -> bool {
    let mut blocks = network.elements.iter().filter(|of| of.kind == "block");
    blocks.any(|block| units.reaches_beyond(&block.block()))
}

/// A body as it is written.
struct Body<'b, 'a, 'x> {
    network: &'b Network<'a, 'x>,
    units: &'b Units<'b, 'a, 'x>,
    /// Of a function: its name in capitals, and the type of its result.
    result: Option<(String, String)>,
    /// By their names in capitals.
    variables: HashMap<String, &'b Variable>,
    found: &'b mut Found,
    sentences: Sentences,
    /// Variables that the body needs besides.
    added: Vec<(String, String, Span)>,
    /// Names that are taken, in capitals.
    taken: HashSet<String>,
    /// What each block is.
    own: Vec<what::What>,
    /// Elements whose wires lead back to them.
    circles: Vec<bool>,
    /// Elements of rungs that write what they read.
    rewrites: Vec<bool>,
    /// Blocks that are called, or about to be; whether that went well.
    begun: HashMap<usize, bool>,
    /// Functions whose results have gone to the variables after them.
    stored: HashSet<usize>,
    /// The elements that call each instance.
    instances: HashMap<String, wires::Calls>,
    /// The variables that keep what one of several calls gave at an output.
    outputs: HashMap<(usize, String), String>,
    /// The labels that are still to come, the next at the end.
    labels: Vec<usize>,
    /// The variables that say where to jump, by the names of the labels.
    jumps: HashMap<&'a str, String>,
    /// Of a diagram: the functions whose results are in variables.
    kept: Vec<bool>,
    /// Of a diagram: what ENO of a block says.
    enos: HashMap<usize, Eno>,
    /// Whether something that a diagram calls reaches beyond itself.
    shares: bool,
    /// The ways to EN.
    enabled: HashMap<usize, Option<Circuit>>,
    /// The variables that keep the results of functions.
    names: HashMap<usize, String>,
    /// The types of results.
    kinds: HashMap<usize, String>,
    /// What the leaves of circuits say.
    words: HashMap<crate::circuit::Key, Vec<Piece>>,
    walk: Walk<'a>,
    /// Of a diagram: how many elements were open when the last block began.
    since: usize,
}

/// What ENO of a block says.
enum Eno {
    /// What a variable keeps.
    Named(String),
    /// What leads to EN.
    Said(Vec<Piece>),
}

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// All of it.
    fn written(self) -> Written {
        Written {
            pieces: self.sentences.pieces(),
            variables: self.added,
        }
    }

    /// Writes what an element does at which power ends; none, with a message, where something is wrong.
    fn sink(&mut self, at: usize) -> Option<()> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        match element.kind {
            "coil" => self.coil(at),
            "outVariable" | "inOutVariable" => self.assigned(at),
            "return" => {
                let condition = self.condition(at, says(element.node, "negated"))?;
                self.sentences.only(condition, vec![piece("RETURN", place)]);
                Some(())
            }
            "jump" => self.jump(at),
            "block" if self.own[at].is_function() => self.store(at),
            "block" if self.own[at] == what::What::Unknown => self.unknown(at),
            "block" => {
                if let (Some(order), true) = (element.order, self.begun.contains_key(&at)) {
                    self.tell(Code::XmlOrder, at, [order.to_string().into()]);
                }
                self.block(at)
            }
            // A contact after which nothing stands does nothing.
            _ => Some(()),
        }
    }

    /// Tells of a block that nobody knows.
    fn unknown<T>(&mut self, at: usize) -> Option<T> {
        let node = self.network.elements[at].node;
        let name = node.attribute("typeName").unwrap_or_default();
        self.tell(Code::XmlBlock, at, [name.into()]);
        None
    }

    /// What leads to the only input of an element.
    fn condition(&mut self, at: usize, negated: bool) -> Option<Vec<Piece>> {
        if self.network.is_blocks {
            return self.asked(at, negated);
        }
        let circuit = self.input(at, "")?;
        Some(self.said(&circuit, negated))
    }

    fn coil(&mut self, at: usize) -> Option<()> {
        let element = &self.network.elements[at];
        let place = span(element.node);
        self.declared(at)?;
        let name = element.written.clone();
        let negated = says(element.node, "negated");
        let storage = element.node.attribute("storage").unwrap_or_default();
        let circuit = self.input(at, "")?;
        let mut value = self.said(&circuit, false);
        let edge = edge(element.node);
        if !edge.is_empty() {
            value = self.after_edge(at, edge, value);
        }
        if negated {
            value = sentences::inverted(value, place);
        }
        let to = piece(&format!("{name} := "), place);
        match storage {
            "set" | "reset" => {
                let truth = if storage == "set" { "TRUE" } else { "FALSE" };
                let does = vec![to, piece(truth, place)];
                self.sentences.only(value, does);
            }
            _ => {
                let mut does = vec![to];
                does.append(&mut value);
                self.sentences.add(does);
            }
        }
        Some(())
    }

    /// A variable after an output.
    fn assigned(&mut self, at: usize) -> Option<()> {
        let network = self.network;
        let element = &network.elements[at];
        if let [wire] = element.wires("")
            && self.is_stored_by(wire.from, wire.output)
        {
            return self.store_in(wire.from, at);
        }
        let circuit = self.input(at, "")?;
        let value = self.said(&circuit, element.negated());
        let mut does = vec![piece(
            &format!("{} := ", element.written),
            span(element.node),
        )];
        does.extend(value);
        self.sentences.add(does);
        Some(())
    }

    /// A variable of this type that the body needs besides its own; its name says what it is for, and in which rung.
    fn add(&mut self, what: &str, kind: &str, at: usize) -> String {
        let rung = self.network.rung(at);
        let mut name = format!("{what}_{rung}");
        let mut count = 1;
        while self.taken.contains(&name.to_uppercase()) {
            count += 1;
            name = format!("{what}_{rung}_{count}");
        }
        self.taken.insert(name.to_uppercase());
        let place = span(self.network.elements[at].node);
        self.added.push((name.clone(), kind.to_owned(), place));
        name
    }
}
