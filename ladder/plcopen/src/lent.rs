//! Types that a library of an editor lends to a project, whose file does not hold them.

use crate::found::span;
use crate::xml::within;
use roxmltree::Node;
use std::collections::HashSet;
use unoclp_lang::Span;

/// The types of what Beremiz shows on a screen (SVGHMI), and what each is. A screen reads and writes such variables from
/// outside; in the program they are plain ones.
const OF_SCREENS: [(&str, &str); 12] = [
    ("HMI_BOOL", "BOOL"),
    ("HMI_DINT", "DINT"),
    ("HMI_INT", "INT"),
    ("HMI_LINT", "LINT"),
    ("HMI_NODE", "BOOL"),
    ("HMI_REAL", "REAL"),
    ("HMI_SINT", "SINT"),
    ("HMI_STRING", "STRING"),
    ("HMI_UDINT", "UDINT"),
    ("HMI_UINT", "UINT"),
    ("HMI_ULINT", "ULINT"),
    ("HMI_USINT", "USINT"),
];

/// A type that is lent.
#[derive(Clone, Copy)]
pub(crate) struct Lent {
    pub name: &'static str,
    pub kind: &'static str,
    /// Where the project first uses it.
    pub at: Span,
}

/// The types that a project uses and does not make itself.
pub(crate) fn lent(root: Node<'_, '_>) -> Vec<Lent> {
    let named = |node: Node<'_, '_>| node.attribute("name").unwrap_or_default().to_uppercase();
    let mut known: HashSet<String> = within(root, "dataType").map(named).collect();
    let used = within(root, "derived");
    used.filter_map(|node| {
        let own = named(node);
        let (name, kind) = OF_SCREENS.into_iter().find(|(name, _)| *name == own)?;
        let at = span(node);
        known.insert(own).then_some(Lent { name, kind, at })
    })
    .collect()
}

/// Whether a type is the lent one of this name, and none that the project makes.
pub(crate) fn is_lent(derived: Node<'_, '_>, name: &str) -> bool {
    let is_it = |node: Node<'_, '_>| {
        let own = node.attribute("name");
        own.is_some_and(|own| own.eq_ignore_ascii_case(name))
    };
    is_it(derived) && !within(derived.document().root(), "dataType").any(is_it)
}

/// What a type of this name is, where it is lent.
pub(crate) fn stands_for(name: &str, lent: &[Lent]) -> Option<&'static str> {
    let own = lent.iter().find(|own| own.name.eq_ignore_ascii_case(name));
    own.map(|own| own.kind)
}
