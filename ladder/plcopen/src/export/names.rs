//! What the points of a document are called in a project, and how they are declared.

use crate::points::written;
use std::collections::{BTreeMap, HashSet};
use unoclp_draw::Names;
use unoclp_point::Address;

/// The variables of a project, as they are met.
pub(crate) struct Variables {
    names: Names,
    taken: HashSet<String>,
    /// Name, address and type of each, in the order of the points; those without a point after them.
    points: BTreeMap<Address, (String, Option<String>, String)>,
    others: Vec<(String, String)>,
}

impl Variables {
    pub(crate) fn new(names: Names) -> Variables {
        Variables {
            names,
            taken: HashSet::new(),
            points: BTreeMap::new(),
            others: Vec::new(),
        }
    }

    /// The name of a point, which a block of this type has as its instance.
    pub(crate) fn of(&mut self, point: Address, kind: &str) -> String {
        if let Some((name, ..)) = self.points.get(&point) {
            return name.clone();
        }
        // The name of a counter keeps its number.
        let own = match point {
            Address::Counter(_) => None,
            point => self.names.get(&point).filter(|name| is_name(name)).cloned(),
        };
        let own = own.filter(|name| !self.taken.contains(&name.to_uppercase()));
        let name = own.unwrap_or_else(|| self.free(&point.to_string()));
        self.taken.insert(name.to_uppercase());
        let declared = (name.clone(), written(point), kind.to_owned());
        self.points.insert(point, declared);
        name
    }

    /// The PWM of an output.
    pub(crate) fn pwm(&mut self, output: u8) -> String {
        format!("%QW{output}")
    }

    /// A new instance of a block that is no point.
    pub(crate) fn instance(&mut self, kind: &str) -> String {
        let name = self.free(kind);
        self.taken.insert(name.to_uppercase());
        self.others.push((name.clone(), kind.to_owned()));
        name
    }

    fn free(&self, begin: &str) -> String {
        let numbered = (1..).map(|number| format!("{begin}_{number}"));
        let mut all = std::iter::once(begin.to_owned()).chain(numbered);
        let is_free = |name: &String| !self.taken.contains(&name.to_uppercase());
        all.find(is_free).unwrap_or_default()
    }

    /// The declarations of all.
    pub(crate) fn declared(&self) -> String {
        let of = |name: &str, address: Option<&String>, kind: &str| {
            let address = address.map_or(String::new(), |a| format!(" address=\"{a}\""));
            let kind = match kind {
                "BOOL" | "DINT" | "INT" => format!("<{kind}/>"),
                block => format!("<derived name=\"{block}\"/>"),
            };
            let name = super::xml::escaped(name);
            format!(
                "            <variable name=\"{name}\"{address}>\n              <type>\n                {kind}\n              </type>\n            </variable>\n"
            )
        };
        let points = self.points.values();
        let points = points.map(|(name, address, kind)| of(name, address.as_ref(), kind));
        let others = self.others.iter().map(|(name, kind)| of(name, None, kind));
        points.chain(others).collect()
    }
}

/// Whether IEC 61131-3 takes this as a name, and no address or truth begins so.
fn is_name(name: &str) -> bool {
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    let goes_on = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let is_word = ["TRUE", "FALSE"].contains(&name.to_uppercase().as_str());
    begins && goes_on && !is_word
}
