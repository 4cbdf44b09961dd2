//! What steps do: actions with their qualifiers, and the bodies of actions.

use super::net::{Net, Step, named, reference};
use super::written::{Chart, Said, in_language, tell};
use crate::found::{Found, span};
use crate::project::{Pou, Variable};
use crate::st::list::Role;
use crate::st::{self, Units};
use crate::text::Text;
use crate::xml::{all, first, text};
use roxmltree::Node;
use std::collections::{HashMap, HashSet};
use unoclp_lang::{Code, Span};

/// What has a body of its own in the unit of a chart.
pub(super) struct Bodies<'b, 'a, 'x> {
    pub xml: &'b str,
    pub pou: &'b Pou<'a, 'x>,
    pub(super) globals: &'b [Variable],
    units: &'b Units<'b, 'a, 'x>,
    /// What names may mean, in capitals: variables, steps and actions.
    pub known: HashMap<String, Variable>,
    /// The transitions that have a name and a body, in capitals.
    pub transitions: HashMap<String, Node<'a, 'x>>,
    /// Actions that are beside a step, with the names that they get.
    inline: Vec<(String, Node<'a, 'x>)>,
    taken: HashSet<String>,
    /// The calls of blocks that lead to conditions, and the instances that are called, in capitals.
    pub calls: Vec<Said>,
    called: HashSet<String>,
    /// The edges that contacts wait for.
    edges: Vec<(String, String, Span)>,
}

impl<'b, 'a, 'x: 'a> Bodies<'b, 'a, 'x> {
    pub(super) fn new(
        xml: &'b str,
        pou: &'b Pou<'a, 'x>,
        net: &Net<'a, 'x>,
        globals: &'b [Variable],
        units: &'b Units<'b, 'a, 'x>,
    ) -> Bodies<'b, 'a, 'x> {
        let variables = globals.iter().chain(&pou.variables).cloned();
        let steps = net
            .steps
            .iter()
            .map(|step| part(&step.name, "STEP", Span::default()));
        let own = declared(pou.node, "actions", "action");
        let own = own.filter_map(|node| node.attribute("name"));
        let own = own.map(|name| part(name, "ACTION", Span::default()));
        let all = variables.chain(steps).chain(own);
        let known: HashMap<String, Variable> = all.map(|of| (of.name.to_uppercase(), of)).collect();
        let transitions = declared(pou.node, "transitions", "transition");
        let named = |node: Node<'a, 'x>| Some((node.attribute("name")?.to_uppercase(), node));
        let transitions: HashMap<String, Node<'a, 'x>> = transitions.filter_map(named).collect();
        Bodies {
            xml,
            pou,
            globals,
            units,
            taken: known.keys().cloned().collect(),
            known,
            transitions,
            inline: Vec::new(),
            calls: Vec::new(),
            called: HashSet::new(),
            edges: Vec::new(),
        }
    }

    /// Whether this is the first time that an instance is asked for.
    pub(super) fn calls_first(&mut self, instance: &str) -> bool {
        self.called.insert(instance.to_uppercase())
    }

    /// A name that nothing has.
    fn free(&mut self, what: &str) -> String {
        let mut name = what.to_owned();
        let mut count = 1;
        while !self.taken.insert(name.to_uppercase()) {
            count += 1;
            name = format!("{what}_{count}");
        }
        name
    }

    /// Whether a variable has risen or fallen since the scan before.
    pub(super) fn edge(&mut self, edge: &str, variable: &str, at: Span) -> String {
        let kind = if edge == "rising" { "R_TRIG" } else { "F_TRIG" };
        let name = self.free("edge");
        self.calls
            .push(vec![(format!("{name}(CLK := {variable});\n"), at)]);
        self.edges.push((name.clone(), kind.to_owned(), at));
        format!("{name}.Q")
    }

    /// The action that calls the blocks, where there are some: each initial step begins it, and nothing ends it.
    pub(super) fn caller(&mut self) -> Option<String> {
        (!self.calls.is_empty()).then(|| self.free("blocks"))
    }

    /// Writes what a step does.
    pub(super) fn step(
        &mut self,
        step: &Step<'a, 'x>,
        caller: Option<&str>,
        to: &mut Text,
        found: &mut Found,
    ) {
        if let Some(caller) = caller.filter(|_| step.initial) {
            to.piece(&format!(" {caller}(S);"), step.at);
        }
        for action in step.blocks.iter().flat_map(|block| all(*block, "action")) {
            let at = span(action);
            let name = match (reference(action), first(action, "inline")) {
                (Some(name), _) if !name.is_empty() => name.to_owned(),
                (_, Some(inline)) => self.inlined(step, inline),
                _ => {
                    let pou = &self.pou.name;
                    let (step, what) = (&step.name, ("an empty body", "um corpo vazio").into());
                    let who = (
                        format!("`{pou}`, action of `{step}`"),
                        format!("`{pou}`, ação de `{step}`"),
                    );
                    tell(found, Code::XmlAction, who, at, [what]);
                    continue;
                }
            };
            let qualifier = action.attribute("qualifier").unwrap_or_default().trim();
            let qualifier = if qualifier.is_empty() { "N" } else { qualifier };
            let time = action.attribute("duration").unwrap_or_default().trim();
            let is_timed = matches!(&*qualifier.to_uppercase(), "L" | "D" | "SD" | "DS" | "SL");
            match is_timed && !time.is_empty() {
                true => to.piece(&format!(" {name}({qualifier}, {time});"), at),
                false => to.piece(&format!(" {name}({qualifier});"), at),
            }
        }
    }

    /// A name for an action that is beside a step.
    fn inlined(&mut self, step: &Step<'a, 'x>, inline: Node<'a, 'x>) -> String {
        let written = inline.attribute("name").unwrap_or_default();
        let name = match named(written) {
            name if name.is_empty() => format!("{}_does", step.name),
            name => name,
        };
        let name = self.free(&name);
        self.inline.push((name.clone(), inline));
        name
    }

    /// Writes the actions that have bodies.
    pub(super) fn actions(&mut self, caller: Option<&str>, chart: &mut Chart, found: &mut Found) {
        if let Some(caller) = caller {
            let at = self.calls.first().and_then(|call| call.first());
            let at = at.map_or(Span::default(), |(_, at)| *at);
            chart.text.piece(&format!("ACTION {caller}:\n"), at);
            for (piece, at) in self.calls.iter().flatten() {
                chart.text.piece(piece, *at);
            }
            chart.text.piece("END_ACTION\n", at);
            chart.variables.append(&mut self.edges);
        }
        let own = declared(self.pou.node, "actions", "action");
        let own = own.filter_map(|node| {
            let name = node.attribute("name")?;
            Some((name.trim().to_owned(), first(node, "body").unwrap_or(node)))
        });
        let own: Vec<(String, Node<'a, 'x>)> = own.collect();
        for (name, body) in own.into_iter().chain(std::mem::take(&mut self.inline)) {
            let at = span(body);
            chart.text.piece(&format!("ACTION {name}:\n"), at);
            if let Some(body) = body.children().find(Node::is_element) {
                self.body(&name, body, chart, found);
            }
            chart.text.piece("\nEND_ACTION\n", at);
        }
    }

    /// The unit with all that has a name in it, and what its chart needs besides.
    pub(super) fn unit(&self, added: &[(String, String, Span)]) -> Pou<'a, 'x> {
        let added = added.iter().map(|(name, kind, at)| part(name, kind, *at));
        let mut unit = self.pou.clone();
        unit.variables.extend(self.known.values().cloned());
        unit.variables.extend(added);
        unit
    }

    fn body(&mut self, name: &str, body: Node<'a, 'x>, chart: &mut Chart, found: &mut Found) {
        let pou = &self.pou.name;
        let who = (
            format!("`{pou}`, action `{name}`"),
            format!("`{pou}`, ação `{name}`"),
        );
        let made = match body.tag_name().name() {
            "ST" => {
                chart.text.body(self.xml, body);
                // The last statement of a body needs no semicolon elsewhere.
                let written = text(body);
                let last = written.trim_end();
                if !last.is_empty() && !last.ends_with([';', ')']) {
                    chart.text.piece(";", span(body));
                }
                return;
            }
            "LD" | "FBD" => {
                let unit = self.unit(&chart.variables);
                st::write(&unit, body, self.globals, self.units, found)
            }
            "IL" => {
                let unit = self.unit(&chart.variables);
                let (code, who) = (Code::XmlAction, who.into());
                let role = (&unit, Role { code, who });
                st::list::statements(self.xml, role, body, self.globals, found)
            }
            other => {
                let what = in_language(other);
                return tell(found, Code::XmlAction, who, span(body), [what]);
            }
        };
        chart.variables.extend(made.variables);
        for (piece, at) in &made.pieces {
            chart.text.piece(piece, *at);
        }
    }
}

/// What a name of a unit means besides its variables.
fn part(name: &str, kind: &str, at: Span) -> Variable {
    Variable {
        name: name.to_owned(),
        section: "localVars".to_owned(),
        address: None,
        kind: kind.to_owned(),
        initial: None,
        retain: false,
        constant: false,
        at,
    }
}

/// The actions, or the transitions, that a unit declares.
fn declared<'a, 'x: 'a>(
    pou: Node<'a, 'x>,
    within: &'static str,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'x>> {
    first(pou, within)
        .into_iter()
        .flat_map(move |of| all(of, name))
}
