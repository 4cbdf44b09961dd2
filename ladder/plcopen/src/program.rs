//! A project to a checked program.

use crate::allot::{Allotted, is_of_ladder};
use crate::around::{begin, number};
use crate::body;
use crate::checked::Origins;
use crate::flow::Flow;
use crate::found::Found;
use crate::imported::Imported;
use crate::network::Network;
use crate::outputs::circuits;
use crate::pins;
use crate::points::Points;
use crate::project::{Pou, Project, Variable};
use crate::rungs::Rungs;
use crate::scope::Scope;
use crate::ways::Ways;
use crate::xml::{self, all, first, text, within};
use std::collections::HashSet;
use std::sync::Arc;
use unoclp_checked::Checked;
use unoclp_core::isa::Kind;
use unoclp_core::{Board, Target};
use unoclp_draw::edit::Document;
use unoclp_lang::{Code, TextLanguage, Told};

/// Reads a project for a board.
pub fn import(text: &str, board: Board) -> Imported {
    let mut found = Found::default();
    let mut imported = Imported {
        code: None,
        program: None,
        document: None,
        variables: Vec::new(),
        traces: Vec::new(),
        charts: Vec::new(),
        origins: Vec::new(),
        diagnostics: Told::default(),
    };
    if let Some(tree) = xml::parse(text, &mut found)
        && let Some(project) = Project::read(tree.root_element(), &mut found)
    {
        match way(&project, &mut found) {
            Some(Way::Ladder) => {
                found = drawn(text, &project, board, found, &mut imported);
            }
            Some(Way::Blocks) => {
                found = blocks(text, &project, board, found, &mut imported);
            }
            Some(Way::Text(language)) => {
                body::compile(text, &project, language, board, &mut found, &mut imported);
            }
            None => {}
        }
        let program = imported.program.as_ref();
        if let (Some((program, _)), Some(first)) = (program, project.programs.first())
            && !touches_points(program)
        {
            found.tell(Code::XmlNoPoint, first.node, []);
        }
    }
    imported.diagnostics = found.finish();
    imported
}

/// What becomes of ladder diagrams: a document, or Structured Text where no document holds them.
fn drawn(
    text: &str,
    project: &Project<'_, '_>,
    board: Board,
    before: Found,
    imported: &mut Imported,
) -> Found {
    let mut found = as_ladder(text, project, board, &before, imported);
    if !found.has_errors() {
        return found;
    }
    if !found.is_only(&AS_TEXT) {
        // A text would take the rest.
        found.retain(|code| *code != Code::XmlTangle);
        return found;
    }
    let as_text = as_text(text, project, board, before, imported);
    // A mistake is told in the words of the ladder, but for what only a text has.
    let is_plain = project
        .programs
        .iter()
        .flat_map(|pou| &pou.variables)
        .chain(&project.globals)
        .all(is_of_ladder);
    let differs = |code: &Code| !BY_TEXT.contains(code);
    if as_text.has_errors() && is_plain && found.errors().any(|code| differs(&code)) {
        found.retain(differs);
        return found;
    }
    as_text
}

/// What becomes of block diagrams: a document where each says what a ladder can, otherwise Structured Text.
fn blocks(
    text: &str,
    project: &Project<'_, '_>,
    board: Board,
    before: Found,
    imported: &mut Imported,
) -> Found {
    let found = as_ladder(text, project, board, &before, imported);
    match found.has_errors() {
        true => as_text(text, project, board, before, imported),
        false => found,
    }
}

/// What is found where a document is to hold it.
fn as_ladder(
    text: &str,
    project: &Project<'_, '_>,
    board: Board,
    before: &Found,
    imported: &mut Imported,
) -> Found {
    let mut found = before.clone();
    ladder(text, project, board, &mut found, imported);
    found
}

/// What is found where it becomes Structured Text.
fn as_text(
    text: &str,
    project: &Project<'_, '_>,
    board: Board,
    mut found: Found,
    imported: &mut Imported,
) -> Found {
    body::compile(text, project, TextLanguage::St, board, &mut found, imported);
    found
}

/// What a document refuses and a text may take.
const AS_TEXT: [Code; 8] = [
    Code::XmlLoop,
    Code::XmlTangle,
    Code::XmlType,
    Code::XmlBlock,
    Code::XmlNoneLeft,
    Code::XmlUndeclared,
    Code::XmlValue,
    Code::XmlWritten,
];

/// What is no mistake in a text.
const BY_TEXT: [Code; 3] = [Code::XmlLoop, Code::XmlTangle, Code::XmlBlock];

/// Whether a program reads an input of the board or drives an output.
fn touches_points(program: &Checked) -> bool {
    let mut steps = program.program().steps();
    steps.any(|step| match step.opcode.row().kind {
        Kind::Input | Kind::Output | Kind::Analogue | Kind::Pwm | Kind::Filter => true,
        Kind::Timer => step
            .timer()
            .is_some_and(|block| matches!(block.target, Target::Output(_))),
        _ => false,
    })
}

/// How a project is compiled.
enum Way {
    /// As a document of the ladder editor.
    Ladder,
    /// The same, of block diagrams.
    Blocks,
    /// As a text.
    Text(TextLanguage),
}

/// How a project is compiled; none where one of its programs cannot be, which is reported.
fn way(project: &Project<'_, '_>, found: &mut Found) -> Option<Way> {
    let mut languages = Vec::new();
    for pou in &project.programs {
        let own = pou.body.map_or("?", |(language, _)| language);
        if all(pou.node, "body").nth(1).is_some() {
            body::refuse(pou, "", found);
        } else if !matches!(own, "LD" | "FBD" | "ST" | "IL" | "SFC") {
            body::refuse(pou, own, found);
        } else {
            languages.push((own, pou));
        }
    }
    if languages.is_empty() {
        let is_library = project.programs.is_empty();
        return is_library.then_some(Way::Text(TextLanguage::St));
    }
    if found.has_errors() {
        return None;
    }
    let are_all = |language| languages.iter().all(|(own, _)| *own == language);
    Some(match () {
        () if are_all("IL") => Way::Text(TextLanguage::Il),
        () if are_all("LD") && !languages.iter().any(|(_, pou)| has_others(pou)) => Way::Ladder,
        () if are_all("FBD") && is_ladder(project) => Way::Blocks,
        () => Way::Text(TextLanguage::St),
    })
}

/// Whether block diagrams may be a ladder: they have its blocks, run from top to bottom, and hold no number that is cut to
/// its type where it is stored.
fn is_ladder(project: &Project<'_, '_>) -> bool {
    let of_pous = project.programs.iter().flat_map(|pou| &pou.variables);
    let mut variables = of_pous.chain(&project.globals);
    let is_uncut = |variable: &Variable| match &*variable.kind.to_uppercase() {
        "INT" => variable.address.as_ref().is_some_and(|address| {
            let address = address.trim_start_matches('%');
            address.starts_with(['I', 'i'])
        }),
        "SINT" | "USINT" | "UINT" | "BYTE" | "WORD" | "TIME" => false,
        _ => is_of_ladder(variable),
    };
    let is_ordered = |pou: &Pou<'_, '_>| {
        let order = |of: roxmltree::Node<'_, '_>| {
            let order = of.attribute("executionOrderId");
            order.is_some_and(|order| order.parse::<u32>().is_ok_and(|order| order > 0))
        };
        let body = pou.body.map(|(_, body)| body);
        body.is_some_and(|body| body.children().any(order))
    };
    variables.all(is_uncut)
        && !project
            .programs
            .iter()
            .any(|pou| is_ordered(pou) || has_others(pou))
}

/// Whether a ladder has what no document has: other blocks, or ET of a TOF.
fn has_others(pou: &Pou<'_, '_>) -> bool {
    let Some((_, body)) = pou.body else {
        return false;
    };
    let mut blocks = all(body, "block");
    let is_other = |block: roxmltree::Node<'_, '_>| {
        let name = block.attribute("typeName").unwrap_or_default();
        pins::inputs(&name.to_uppercase()).is_none()
    };
    blocks.any(is_other) || reads_off_delay(body)
}

/// Whether a ladder reads ET of a TOF by a wire or by its name. It keeps PT after the delay, where the instruction of the board
/// gives 0 (NC-14).
fn reads_off_delay(body: roxmltree::Node<'_, '_>) -> bool {
    let upper = |text: Option<&str>| text.unwrap_or_default().trim().to_uppercase();
    let blocks = all(body, "block").filter(|block| upper(block.attribute("typeName")) == "TOF");
    let (ids, names): (HashSet<_>, HashSet<_>) = blocks
        .map(|block| {
            let name = upper(block.attribute("instanceName"));
            (block.attribute("localId"), format!("{name}.ET"))
        })
        .unzip();
    let by_wire = |wire: roxmltree::Node<'_, '_>| {
        let output = upper(wire.attribute("formalParameter"));
        output == "ET" && ids.contains(&wire.attribute("refLocalId"))
    };
    !ids.is_empty()
        && (within(body, "connection").any(by_wire)
            || within(body, "expression").any(|of| names.contains(&upper(of.text()))))
}

fn ladder(
    text: &str,
    project: &Project<'_, '_>,
    board: Board,
    found: &mut Found,
    imported: &mut Imported,
) {
    let of_pous = project.programs.iter().map(|pou| &pou.variables);
    of_pous
        .chain([&project.globals])
        .for_each(|of| named_twice(of, found));
    let mut points = Points::of(text, board);
    let of_pous = project.programs.iter().flat_map(|pou| &pou.variables);
    let addresses = of_pous
        .chain(&project.globals)
        .filter_map(|v| v.address.as_deref());
    addresses.for_each(|address| points.take(address));
    let mut networks: Vec<Network<'_, '_>> = Vec::new();
    let mut size = 0;
    for pou in &project.programs {
        let Some((_, body)) = pou.body else { continue };
        size += body.children().count();
        if size > MOST_ELEMENTS {
            let en = format!("more than {MOST_ELEMENTS} elements");
            let pt = format!("mais de {MOST_ELEMENTS} elementos");
            found.tell(Code::XmlTooLarge, pou.node, [(en, pt).into()]);
            return;
        }
        let network = Network::read(&pou.name, body, found);
        if let Some(at) = network.is_blocks.then(|| network.crossing()).flatten() {
            // A jump would leave out a block that something behind its label asks for.
            network.tell(found, Code::XmlTangle, at, []);
        }
        networks.push(network);
    }
    for element in networks.iter().flat_map(|network| &network.elements) {
        points.take(&element.written);
    }
    let mut all = Allotted::new(points, &project.globals);
    let elements = networks.iter().flat_map(|network| &network.elements);
    let instances = elements.filter_map(|element| element.node.attribute("instanceName"));
    all.called.extend(instances.map(str::to_uppercase));
    let mut rungs = Rungs::default();
    let mut work = 0;
    for (index, (pou, network)) in project.programs.iter().zip(&networks).enumerate() {
        let mut scope = Scope::new(&pou.variables);
        let mut flow = Flow::new(index, network, &mut scope, &mut all, found);
        flow.walk.work = work;
        labels(&mut flow);
        let mut elements = network.elements.iter();
        if let Some(leaves) = elements.position(|element| element.kind == "return")
            && index + 1 < networks.len()
        {
            flow.end = flow.all.points.label();
            if flow.end.is_none() {
                no_label(&mut flow, leaves, "RETURN");
            }
        }
        let circuits = circuits(&mut flow);
        work = flow.walk.work;
        let title = (networks.len() > 1).then(|| pou.name.clone());
        rungs.add(&flow, &circuits, title);
        rungs.labels.extend(flow.end);
    }
    rungs.finish();
    begin(&all, &mut rungs);
    let names = number(&mut rungs, &mut all, found);
    if found.has_errors() {
        return;
    }
    let title = project.programs.first().map_or(Vec::new(), documentation);
    let Rungs { rungs, origins, .. } = rungs;
    let document = Document::of_rungs(rungs, title, names);
    let units: Vec<Arc<str>> = networks.iter().map(|n| Arc::from(&*n.pou)).collect();
    let origins = Origins {
        text,
        origins,
        units,
    };
    if let Some((code, program)) = origins.check(&document, board, found) {
        imported.code = Some(code);
        imported.program = Some(program);
        imported.document = Some(document);
    }
}

/// Tells of variables of one table that have one name, whatever the case of its letters.
fn named_twice(variables: &[Variable], found: &mut Found) {
    let mut named = HashSet::new();
    let names = variables.iter().filter(|own| !own.name.is_empty());
    for own in names.filter(|own| !named.insert(own.name.to_uppercase())) {
        found.tell_at(Code::StNameTwice, own.at, [(*own.name).into()]);
    }
}

/// The programs of a project have no more elements, spaces between them among them; a board holds far fewer.
const MOST_ELEMENTS: usize = 50_000;

/// Gives the labels of a program their numbers, first those whose names say one.
fn labels(flow: &mut Flow<'_, '_, '_>) {
    let elements = flow.network.elements.iter().enumerate();
    let labels = elements.filter(|(_, element)| element.kind == "label");
    let named = labels.map(|(at, e)| (at, e.node.attribute("label").unwrap_or_default()));
    let named: Vec<(usize, &str)> = named.collect();
    for (_, name) in &named {
        if !flow.labels.contains_key(*name)
            && let Some(own) = flow.all.points.own_label(name)
        {
            flow.labels.insert((*name).to_owned(), own);
        }
    }
    for (at, name) in named {
        if flow.labels.contains_key(name) {
            continue;
        }
        match flow.all.points.label() {
            Some(free) => drop(flow.labels.insert(name.to_owned(), free)),
            None => no_label(flow, at, name),
        }
    }
}

fn no_label(flow: &mut Flow<'_, '_, '_>, at: usize, name: &str) {
    let what = ("label", "rótulo").into();
    let words = [
        what,
        name.into(),
        flow.all.points.board.labels.to_string().into(),
    ];
    flow.tell(Code::XmlNoneLeft, at, words);
}

fn documentation(pou: &Pou<'_, '_>) -> Vec<String> {
    let written = first(pou.node, "documentation").map_or(String::new(), text);
    let lines = written.trim().lines();
    lines.map(|line| line.trim_end().to_owned()).collect()
}
