//! Function blocks that others bring with them (IEC 61131-3, Annex F): PID and its kin. Times are in seconds there.
//!
//! Owns which of them a text has variables of and declares nowhere. Must not know what a block compiles to.

use super::ast::{Decl, File, Section, SpecKind, TypeSpec};
use super::{Dialect, parser};
use std::collections::HashSet;
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
    let mut named = HashSet::new();
    let units = file.units.iter();
    let vars = units.flat_map(|unit| &unit.vars).chain(&file.globals);
    let decls = vars.flat_map(|vars| &vars.decls);
    decls.for_each(|decl| of_decl(decl, &mut named));
    let types = file.types.iter();
    types.for_each(|ty| of_type(&ty.spec, &mut named));
    for unit in &file.units {
        named.remove(&unit.name.text.to_uppercase());
    }
    for ty in &file.types {
        named.remove(&ty.name.text.to_uppercase());
    }
    let mut missing = String::new();
    for (name, block) in blocks() {
        if named.contains(name) {
            missing.push_str(block);
            if name == "PID" {
                named.extend(["INTEGRAL".to_owned(), "DERIVATIVE".to_owned()]);
            }
        }
    }
    missing
}

fn of_decl(decl: &Decl, named: &mut HashSet<String>) {
    of_type(&decl.spec, named);
}

/// Notes the names of the types that a type is made of, in capitals.
fn of_type(spec: &TypeSpec, named: &mut HashSet<String>) {
    match &spec.kind {
        SpecKind::Named(name) => drop(named.insert(name.text.to_uppercase())),
        SpecKind::Array(_, of) => of_type(of, named),
        SpecKind::Struct(members) => members.iter().for_each(|member| of_decl(member, named)),
        SpecKind::Text(..) | SpecKind::Enum(_) | SpecKind::Range(..) => {}
    }
}
