//! Function blocks that others bring with them (IEC 61131-3, Annex F): PID and its kin. Times are in seconds there.
//!
//! Owns which of them a text has variables of and declares nowhere. Must not know what a block compiles to.

use super::ast::{File, Section, SpecKind, TypeSpec};
use super::{Dialect, parser};
use unoclp_text::diagnostics::Found;
use unoclp_tree::Base;

/// All of them; what a block needs stands after it.
const BLOCKS: &str = include_str!("library.st");

/// Their names, and their texts.
fn blocks() -> impl Iterator<Item = (&'static str, &'static str)> {
    let blocks = BLOCKS.split_inclusive("END_FUNCTION_BLOCK\n");
    blocks.filter_map(|block| Some((block.split_whitespace().nth(1)?, block)))
}

/// Whether others bring a block of this name, in upper case.
pub fn is_brought(name: &str) -> bool {
    blocks().any(|(block, _)| block == name)
}

/// The type of an input or an output of such a block; both names are in upper case.
pub fn brought(block: &str, parameter: &str) -> Option<Base> {
    let (_, text) = blocks().find(|(name, _)| *name == block)?;
    let (file, _) = parser::parse(text, Dialect::Iec, &mut Found::default());
    let vars = file.units.iter().flat_map(|unit| &unit.vars);
    let mut decls = vars
        .filter(|vars| matches!(vars.section, Section::Input | Section::Output))
        .flat_map(|vars| &vars.decls);
    let decl = decls.find(|decl| decl.names.iter().any(|name| name.text == parameter))?;
    match &decl.spec.kind {
        SpecKind::Named(kind) => Base::named(&kind.text),
        _ => None,
    }
}

/// The blocks that a text lacks, as a text.
pub(super) fn missing(file: &File) -> String {
    let blocks: Vec<(&str, &str)> = blocks().collect();
    let mut named = Vec::new();
    let mut note = |name: &str| {
        let is = |(block, _): &&(&'static str, &str)| block.eq_ignore_ascii_case(name);
        named.extend(blocks.iter().find(is).map(|(block, _)| *block));
    };
    let units = file.units.iter();
    let vars = units.flat_map(|unit| &unit.vars).chain(&file.globals);
    for decl in vars.flat_map(|vars| &vars.decls) {
        of_type(&decl.spec, &mut note);
    }
    for ty in &file.types {
        of_type(&ty.spec, &mut note);
    }
    let units = file.units.iter().map(|unit| &unit.name);
    for own in units.chain(file.types.iter().map(|ty| &ty.name)) {
        named.retain(|name| !name.eq_ignore_ascii_case(&own.text));
    }
    let mut missing = String::new();
    for (name, block) in blocks {
        if named.contains(&name) {
            missing.push_str(block);
            if name == "PID" {
                named.extend(["INTEGRAL", "DERIVATIVE"]);
            }
        }
    }
    missing
}

/// Notes the names of the types that a type is made of.
fn of_type(spec: &TypeSpec, note: &mut impl FnMut(&str)) {
    match &spec.kind {
        SpecKind::Named(name) => note(&name.text),
        SpecKind::Array(_, of) => of_type(of, note),
        SpecKind::Struct(members) => {
            for member in members {
                of_type(&member.spec, note);
            }
        }
        SpecKind::Text(..) | SpecKind::Enum(_) | SpecKind::Range(..) => {}
    }
}
