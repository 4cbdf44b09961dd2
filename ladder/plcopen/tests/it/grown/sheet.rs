//! A drawn body as a test reads it: elements, pins and wires, with the bytes that no act may touch.

use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// Where a wire comes from: an element, and its output.
pub(super) type Wire = (String, String);

/// Where a wire leads to: an element, and its input.
pub(super) type Pin = (String, String);

#[derive(Debug, Default)]
pub(super) struct Sheet {
    /// Elements by their numbers: what the file says of each, without its place and its wires.
    pub said: BTreeMap<String, String>,
    pub kinds: BTreeMap<String, String>,
    pub wires: BTreeMap<Pin, Vec<Wire>>,
    /// The numbers of the elements from the top to the bottom, and from the left to the right.
    pub order: Vec<String>,
    /// What stands before and behind the unit in the file.
    pub around: (String, String),
    /// Comments within the body, in XML and drawn, and what is no element.
    pub comments: Vec<String>,
}

fn own<'a, 'x>(of: Node<'a, 'x>, name: &'static str) -> impl Iterator<Item = Node<'a, 'x>> {
    of.children()
        .filter(move |node| node.has_tag_name_local(name))
}

trait Local {
    fn has_tag_name_local(&self, name: &str) -> bool;
}

impl Local for Node<'_, '_> {
    fn has_tag_name_local(&self, name: &str) -> bool {
        self.is_element() && self.tag_name().name() == name
    }
}

impl Sheet {
    /// The drawn body of a unit.
    pub(super) fn of(text: &str, unit: &str) -> Sheet {
        let tree = Document::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let mut pous = tree.descendants().filter(|of| of.has_tag_name_local("pou"));
        let pou = pous.find(|of| of.attribute("name") == Some(unit)).unwrap();
        let body = own(pou, "body").next().unwrap();
        let body = body.children().find(Node::is_element).unwrap();
        let range = pou.range();
        let mut sheet = Sheet {
            around: (text[..range.start].to_owned(), text[range.end..].to_owned()),
            ..Sheet::default()
        };
        let mut places = Vec::new();
        for node in body.children() {
            if node.is_comment() {
                sheet.comments.push(text[node.range()].to_owned());
            }
            let Some(id) = node.attribute("localId") else {
                continue;
            };
            let again = sheet.said.insert(id.to_owned(), skeleton(text, node));
            assert!(again.is_none(), "two elements {id}\n{text}");
            let kind = node.tag_name().name().to_owned();
            if kind == "comment" {
                sheet.comments.push(skeleton(text, node));
            }
            sheet.kinds.insert(id.to_owned(), kind);
            let number = |at: Node<'_, '_>, name| at.attribute(name).unwrap().parse().unwrap();
            if let Some(at) = own(node, "position").next() {
                let at: (f64, f64) = (number(at, "y"), number(at, "x"));
                places.push((at, id.to_owned()));
            }
            let plain = own(node, "connectionPointIn").map(|pin| (String::new(), pin));
            let lists = own(node, "inputVariables").flat_map(|list| own(list, "variable"));
            let named = lists.filter_map(|pin| {
                let name = pin.attribute("formalParameter").unwrap_or_default();
                Some((name.to_owned(), own(pin, "connectionPointIn").next()?))
            });
            for (name, pin) in plain.chain(named) {
                let of =
                    |wire: Node<'_, '_>, name| wire.attribute(name).unwrap_or_default().to_owned();
                let wires = own(pin, "connection");
                let wires = wires.map(|w| (of(w, "refLocalId"), of(w, "formalParameter")));
                let all = sheet.wires.entry((id.to_owned(), name)).or_default();
                all.extend(wires);
            }
        }
        places.sort_by(|a, b| a.partial_cmp(b).unwrap());
        sheet.order = places.into_iter().map(|(_, id)| id).collect();
        for wire in sheet.wires.values().flatten() {
            assert!(
                sheet.said.contains_key(&wire.0),
                "a loose wire {wire:?}\n{text}"
            );
        }
        sheet
    }
}

/// What the file says of an element, but for its place and its wires.
fn skeleton(text: &str, node: Node<'_, '_>) -> String {
    let mut said = String::new();
    let mut from = node.range().start;
    let left = node.descendants().filter(|of| {
        let is_place = of.has_tag_name_local("position") && of.parent() == Some(node);
        is_place || of.has_tag_name_local("connection")
    });
    for out in left {
        said += text[from..out.range().start].trim_end();
        from = out.range().end;
    }
    said += &text[from..node.range().end];
    let empty = "<connectionPointIn></connectionPointIn>";
    said.replace(empty, "<connectionPointIn/>")
}
