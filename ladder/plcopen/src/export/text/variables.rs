//! What is declared, as XML.

use super::super::xml::escaped;
use super::types;
use std::fmt::Write as _;
use unoclp_lang::parts::{Parts, Variables};
use unoclp_lang::typed::build::Section;

/// The global variables of a text, as those of the resource.
pub(super) fn globals(text: &str, parts: &Parts) -> String {
    let mut all = String::new();
    parts
        .globals
        .iter()
        .for_each(|of| section(text, of, &mut all));
    all
}

/// A section of variables.
pub(super) fn section(text: &str, of: &Variables, to: &mut String) {
    let name = match of.section {
        Section::Input => "inputVars",
        Section::Output => "outputVars",
        Section::InOut => "inOutVars",
        Section::Temp => "tempVars",
        Section::Global => "globalVars",
        Section::External => "externalVars",
        _ => "localVars",
    };
    let constant = if of.constant {
        " constant=\"true\""
    } else {
        ""
    };
    let retain = if of.retain { " retain=\"true\"" } else { "" };
    let _ = writeln!(to, "          <{name}{constant}{retain}>");
    for declared in &of.all {
        let said = |span: unoclp_lang::Span| text.get(span.range()).unwrap_or_default();
        let kind = types::written(said(declared.of));
        let first = declared
            .initial
            .map_or(String::new(), |first| types::initial(said(first)));
        let address = declared.address.as_ref();
        let address = address.map_or(String::new(), |at| format!(" address=\"{}\"", escaped(at)));
        for name in &declared.names {
            let _ = writeln!(
                to,
                "            <variable name=\"{}\"{address}><type>{kind}</type>{first}</variable>",
                escaped(&name.text)
            );
        }
    }
    let _ = writeln!(to, "          </{name}>");
}
