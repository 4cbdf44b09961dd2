//! What is drawn anew: what it says until somebody says something else.

use super::sheet::Sheet;
use super::signature::{Signature, signature};
use crate::alter::is_named;
use crate::xml::{all, first, within};
use roxmltree::Node;

/// What is to be drawn.
pub(super) struct New {
    /// The name of its XML element.
    pub kind: &'static str,
    /// The variable of a contact or a coil, an expression, the type of a block.
    pub written: String,
    /// Of a block.
    pub signature: Signature,
    /// The instance that it is called with, and its type.
    pub instance: Option<(String, String)>,
}

impl New {
    pub(super) fn of(
        sheet: &Sheet<'_, '_, '_>,
        root: Node<'_, '_>,
        unit: &str,
        what: &str,
    ) -> Option<New> {
        let pou = within(root, "pou").find(|pou| is_named(*pou, unit))?;
        let plain = |kind, written| {
            let (signature, instance) = (Signature::default(), None);
            Some(New {
                kind,
                written,
                signature,
                instance,
            })
        };
        match (what, sheet.is_blocks) {
            ("contact", false) => plain("contact", usual(pou, true)),
            ("coil", false) => plain("coil", usual(pou, false)),
            ("value", true) => plain("inVariable", usual(pou, true)),
            ("variable", true) => plain("outVariable", usual(pou, false)),
            ("contact" | "coil" | "value" | "variable", _) => None,
            _ => {
                let signature = signature(root, what, sheet.is_blocks)?;
                let instance = signature.is_instance.then(|| {
                    let names: Vec<String> = within(pou, "variable")
                        .filter_map(|of| Some(of.attribute("name")?.to_uppercase()))
                        .collect();
                    let numbered = (1..).map(|number| format!("{what}_{number}"));
                    let mut free = numbered.filter(|name| !names.contains(&name.to_uppercase()));
                    (free.next().unwrap_or_default(), what.to_owned())
                });
                Some(New {
                    kind: "block",
                    written: what.to_owned(),
                    signature,
                    instance,
                })
            }
        }
    }

    /// The output that power goes on from.
    pub(super) fn output(&self) -> Option<&str> {
        self.signature.goes_on.as_deref()
    }

    pub(super) fn rows(&self) -> usize {
        let Signature {
            inputs, outputs, ..
        } = &self.signature;
        inputs.len().max(outputs.len())
    }
}

/// The variable that a new contact reads or a new coil writes, until somebody says another.
pub(super) fn usual(pou: Node<'_, '_>, is_read: bool) -> String {
    let sections = match is_read {
        true => ["inputVars", "localVars", "outputVars"],
        false => ["outputVars", "localVars", "inOutVars"],
    };
    let interface = first(pou, "interface");
    let variables = sections.iter().flat_map(|name| {
        let own = interface.into_iter().flat_map(|of| all(of, name));
        own.flat_map(|section| all(section, "variable"))
    });
    let fits = |variable: &Node<'_, '_>| {
        let is_bool = first(*variable, "type").is_some_and(|kind| first(kind, "BOOL").is_some());
        let address = variable
            .attribute("address")
            .unwrap_or_default()
            .to_uppercase();
        is_bool && (is_read || !address.starts_with("%I"))
    };
    let mut fitting = variables.filter(fits);
    let name = fitting.next().and_then(|of| of.attribute("name"));
    name.unwrap_or("FALSE").to_owned()
}
