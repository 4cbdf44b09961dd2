//! Which functions and function blocks a project has, and the standard.

use crate::network::Element;
use crate::project::Pou;
use crate::types::{Types, kind};
use crate::xml::first;
use std::collections::HashMap;
use unoclp_lang::is_brought;
use unoclp_lang::typed::Standard;

/// The units and types of a project.
pub(crate) struct Units<'p, 'a, 'x> {
    by_name: HashMap<String, &'p Pou<'a, 'x>>,
    pub types: &'p Types<'a, 'x>,
}

impl<'p, 'a, 'x: 'a> Units<'p, 'a, 'x> {
    pub(crate) fn of(others: &'p [Pou<'a, 'x>], types: &'p Types<'a, 'x>) -> Units<'p, 'a, 'x> {
        let named = others.iter().map(|pou| (pou.name.to_uppercase(), pou));
        Units {
            by_name: named.collect(),
            types,
        }
    }

    /// The function or function block of this name.
    pub(crate) fn get(&self, name: &str) -> Option<&'p Pou<'a, 'x>> {
        self.by_name.get(&name.to_uppercase()).copied()
    }

    /// Whether a function or a block of the project's own reaches beyond itself.
    pub(crate) fn reaches_beyond(&self, name: &str) -> bool {
        let variables = self.get(name).into_iter().flat_map(|pou| &pou.variables);
        let mut sections = variables.map(|variable| &*variable.section);
        sections.any(|section| matches!(section, "externalVars" | "inOutVars"))
    }

    /// Whether an element is a function block: of the standard, the project's own, or one that others bring.
    pub(crate) fn is_block(&self, element: &Element<'_, '_>) -> bool {
        if element.kind != "block" {
            return false;
        }
        let name = element.block();
        match self.get(&name) {
            Some(pou) => pou.kind == "functionBlock",
            None => standard(&name).is_some() || is_brought(&name),
        }
    }
}

/// The function block of the standard that has this name, in capitals.
pub(super) fn standard(name: &str) -> Option<Standard> {
    Standard::named(name).or_else(|| Standard::overloaded(name))
}

/// What a function of the project gives.
pub(super) fn returns(pou: &Pou<'_, '_>) -> String {
    let returns = first(pou.node, "interface").and_then(|of| first(of, "returnType"));
    returns.map_or(String::new(), kind)
}
