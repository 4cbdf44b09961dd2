//! The inputs and outputs that blocks have: a wire to another one would be lost.

use crate::found::Found;
use crate::network::Network;
use unoclp_lang::Code;

/// The inputs of a block besides EN; none of one that is not imported. `IN1` stands for IN1, IN2 …
pub(crate) fn inputs(block: &str) -> Option<&'static [&'static str]> {
    Some(match block.split('_').next().unwrap_or_default() {
        "TON" | "TOF" | "TP" => &["IN", "PT"],
        "CTU" => &["CU", "R", "PV"],
        "CTD" => &["CD", "LD", "PV"],
        "CTUD" => &["CU", "CD", "R", "LD", "PV"],
        "SR" => &["S1", "R"],
        "RS" => &["S", "R1"],
        "R" | "F" if block.ends_with("_TRIG") => &["CLK"],
        "MOVE" | "NOT" => &["IN"],
        "SHL" | "SHR" => &["IN", "N"],
        "GT" | "GE" | "EQ" | "NE" | "LE" | "LT" | "AND" | "OR" | "XOR" | "ADD" | "SUB" | "MUL"
        | "DIV" | "MOD" => &["IN1"],
        _ => return None,
    })
}

/// The outputs of a block that remembers something; none of another, whose only one has many names.
fn outputs(block: &str) -> Option<&'static [&'static str]> {
    Some(match block.split('_').next().unwrap_or_default() {
        "TON" | "TOF" | "TP" => &["Q", "ET"],
        "CTU" | "CTD" => &["Q", "CV"],
        "CTUD" => &["QU", "QD", "CV"],
        "SR" | "RS" => &["Q1"],
        "R" | "F" if block.ends_with("_TRIG") => &["Q"],
        _ => return None,
    })
}

/// Whether this is one of IN1, IN2 …
pub(crate) fn is_numbered(name: &str) -> bool {
    let number = name.strip_prefix("IN").unwrap_or_default();
    number.parse::<u8>().is_ok()
}

/// Tells of wires that lead to inputs which their block does not have, or come from such outputs.
pub(crate) fn check(network: &Network<'_, '_>, found: &mut Found) {
    let blocks = network.elements.iter().enumerate();
    for (at, block) in blocks.filter(|(_, element)| element.kind == "block") {
        let name = block.block();
        let Some(known) = inputs(&name) else { continue };
        for pin in block.inputs.iter().filter(|pin| !pin.wires.is_empty()) {
            let input = pin.name.to_uppercase();
            let has = match known {
                ["IN1"] => is_numbered(&input),
                known => known.contains(&&*input),
            };
            if !has && input != "EN" {
                let words = [name.as_str().into(), pin.name.into()];
                network.tell(found, Code::XmlInput, at, words);
            }
        }
    }
    let pins = network.elements.iter().flat_map(|element| &element.inputs);
    for wire in pins.flat_map(|pin| &pin.wires) {
        let Some(block) = network.elements.get(wire.from) else {
            continue;
        };
        let name = block.block();
        let Some(known) = outputs(&name).filter(|_| block.kind == "block") else {
            continue;
        };
        let output = wire.output.to_uppercase();
        if !known.contains(&&*output) && !matches!(&*output, "" | "ENO") {
            let words = [name.as_str().into(), wire.output.into()];
            network.tell(found, Code::XmlOutput, wire.from, words);
        }
    }
}
