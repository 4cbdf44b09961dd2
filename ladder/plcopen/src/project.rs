//! A project: its programs with their variables, in the order in which they run.

use crate::found::{Found, span};
use crate::lent::{self, Lent};
use crate::types::{begins, kind};
use crate::xml::{all, first, says, within};
use roxmltree::Node;
use std::collections::{HashMap, HashSet};
use unoclp_lang::{Code, Span};

/// What of a project is imported.
pub(crate) struct Project<'a, 'x> {
    /// The programs, as often as they are run, in their order.
    pub programs: Vec<Pou<'a, 'x>>,
    /// Functions and function blocks.
    pub others: Vec<Pou<'a, 'x>>,
    /// The variables of the configuration and of its resources.
    pub globals: Vec<Variable>,
    /// The lists of them that have a name, before which a text may write it, in capitals: `GVL.start`.
    pub lists: HashMap<String, HashSet<String>>,
    /// The types that the project makes.
    pub types: Vec<Node<'a, 'x>>,
    /// Those that a library of the editor lends it.
    pub lent: Vec<Lent>,
}

/// A program, a function or a function block.
#[derive(Clone)]
pub(crate) struct Pou<'a, 'x> {
    pub name: String,
    /// `program`, `function`, `functionBlock`.
    pub kind: String,
    pub node: Node<'a, 'x>,
    pub variables: Vec<Variable>,
    /// The language of its body, and the element of that name: `LD`.
    pub body: Option<(&'x str, Node<'a, 'x>)>,
}

/// A variable as it is declared.
#[derive(Clone, Debug)]
pub(crate) struct Variable {
    pub name: String,
    /// The element that declares it and others: `localVars`.
    pub section: String,
    pub address: Option<String>,
    /// Its type, in upper case where IEC 61131-3 has it.
    pub kind: String,
    pub initial: Option<String>,
    pub retain: bool,
    pub constant: bool,
    pub at: Span,
}

impl<'a, 'x: 'a> Project<'a, 'x> {
    /// The project of a file; what it lacks is told.
    pub(crate) fn read(root: Node<'a, 'x>, found: &mut Found) -> Option<Project<'a, 'x>> {
        if root.tag_name().name() != "project" {
            let name = root.tag_name().name().into();
            found.tell(Code::XmlNoProject, root, [name]);
            return None;
        }
        let pous: Vec<Pou<'_, '_>> = within(root, "pou").map(pou).collect();
        let mut named = HashSet::new();
        for pou in &pous {
            if !named.insert(pou.name.to_uppercase()) {
                found.tell(Code::XmlSameName, pou.node, [pou.name.clone().into()]);
            }
        }
        let (programs, others) = pous.into_iter().partition(|pou| pou.kind == "program");
        let mut project = Project {
            programs,
            others,
            globals: globals(root),
            lists: lists(root),
            types: within(root, "dataType").collect(),
            lent: lent::lent(root),
        };
        let pous = project.programs.iter_mut().chain(&mut project.others);
        let variables = pous.flat_map(|pou| &mut pou.variables);
        for variable in variables.chain(&mut project.globals) {
            if let Some(kind) = lent::stands_for(&variable.kind, &project.lent) {
                variable.kind = kind.to_owned();
            }
        }
        project.order(root, found);
        project.shared(found);
        if project.programs.is_empty() && project.others.is_empty() {
            found.tell(Code::XmlNoProgram, root, []);
            return None;
        }
        Some(project)
    }

    /// Makes globals of what programs take from outside and nobody declares.
    fn shared(&mut self, found: &mut Found) {
        let globals = self.globals.iter();
        let mut known: HashSet<String> = globals.map(|own| own.name.to_uppercase()).collect();
        let pous = self.programs.iter().chain(&self.others);
        let taken = pous.flat_map(|pou| &pou.variables);
        let mut missing = Vec::new();
        for variable in taken.filter(|variable| variable.section == "externalVars") {
            if known.insert(variable.name.to_uppercase()) {
                found.tell_at(
                    Code::XmlNoGlobal,
                    variable.at,
                    [variable.name.clone().into()],
                );
                missing.push(variable.clone());
            }
        }
        let globals = missing.into_iter().map(|variable| Variable {
            section: "globalVars".to_owned(),
            ..variable
        });
        self.globals.extend(globals);
    }

    /// Puts the programs in the order in which tasks run them.
    fn order(&mut self, root: Node<'a, 'x>, found: &mut Found) {
        let instances = within(root, "pouInstance");
        let mut by_name = HashMap::new();
        for (at, pou) in self.programs.iter().enumerate() {
            by_name.entry(pou.name.to_uppercase()).or_insert(at);
        }
        let mut run = Vec::new();
        let mut is_named = false;
        for instance in instances {
            // The form before 2.0 says `type`. In CODESYS a program has one instance, and both have one name.
            let names = ["typeName", "type", "name"].into_iter();
            let mut names = names.filter_map(|name| instance.attribute(name));
            let Some(name) = names.find(|name| !name.is_empty()) else {
                continue;
            };
            is_named = true;
            match by_name.get(&name.to_uppercase()) {
                // No task runs a program more often than there is room on any board.
                Some(_) if run.len() == MOST_RUN => {
                    let en = format!("tasks run more than {MOST_RUN} programs");
                    let pt = format!("tarefas executam mais de {MOST_RUN} programas");
                    found.tell(Code::XmlTooLarge, instance, [(en, pt).into()]);
                    break;
                }
                Some(&at) => run.push(at),
                None => {
                    let who = ("a task", "uma tarefa").into();
                    found.tell(Code::XmlUndeclared, instance, [who, name.into()]);
                }
            }
        }
        if !is_named {
            return;
        }
        let named: HashSet<usize> = run.iter().copied().collect();
        for (at, pou) in self.programs.iter().enumerate() {
            if !named.contains(&at) {
                found.tell(Code::XmlNotRun, pou.node, [pou.name.clone().into()]);
            }
        }
        self.programs = run
            .into_iter()
            .filter_map(|at| self.programs.get(at).cloned())
            .collect();
    }
}

/// More programs than this are not run.
const MOST_RUN: usize = 100;

fn pou<'a, 'x: 'a>(node: Node<'a, 'x>) -> Pou<'a, 'x> {
    let named = |attribute| node.attribute(attribute).unwrap_or_default().to_owned();
    let sections = first(node, "interface").into_iter();
    let sections = sections.flat_map(|interface| interface.children());
    let body = first(node, "body");
    let body = body.and_then(|body| body.children().find(Node::is_element));
    Pou {
        name: named("name"),
        kind: named("pouType"),
        node,
        variables: sections.flat_map(variables).collect(),
        body: body.map(|body| (language(body), body)),
    }
}

/// The language of a body, in upper case, as the form has it.
fn language<'x>(body: Node<'_, 'x>) -> &'x str {
    let own = body.tag_name().name();
    let mut known = ["LD", "FBD", "SFC", "ST", "IL"].into_iter();
    known
        .find(|known| known.eq_ignore_ascii_case(own))
        .unwrap_or(own)
}

fn globals(root: Node<'_, '_>) -> Vec<Variable> {
    within(root, "globalVars").flat_map(variables).collect()
}

pub(crate) fn lists(root: Node<'_, '_>) -> HashMap<String, HashSet<String>> {
    let sections = within(root, "globalVars");
    let named = sections.filter_map(|section| Some((section.attribute("name")?, section)));
    let upper = |section| {
        let own = variables(section).into_iter();
        own.map(|variable| variable.name.to_uppercase()).collect()
    };
    named
        .map(|(name, section)| (name.to_uppercase(), upper(section)))
        .collect()
}

/// The variables that a section declares.
fn variables(section: Node<'_, '_>) -> Vec<Variable> {
    declared(section)
        .map(|declared| declared.variable)
        .collect()
}

/// A variable, and the element that declares it.
pub(crate) struct Declared<'a, 'x> {
    pub node: Node<'a, 'x>,
    pub variable: Variable,
}

/// The same, with their elements.
pub(crate) fn declared<'a, 'x: 'a>(
    section: Node<'a, 'x>,
) -> impl Iterator<Item = Declared<'a, 'x>> {
    all(section, "variable").map(move |node| Declared {
        node,
        variable: Variable {
            name: node.attribute("name").unwrap_or_default().to_owned(),
            section: section.tag_name().name().to_owned(),
            address: node.attribute("address").map(str::to_owned),
            kind: first(node, "type").map_or(String::new(), kind),
            initial: begins(node),
            retain: says(section, "retain"),
            constant: says(section, "constant"),
            at: span(node),
        },
    })
}
