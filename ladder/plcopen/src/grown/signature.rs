//! The inputs and outputs that a new block is drawn with: those of the standard, and those of a unit of the project.

use crate::alter::is_named;
use crate::xml::{all, first, within};
use roxmltree::Node;

/// What a block is drawn with.
#[derive(Clone, Debug, Default)]
pub(crate) struct Signature {
    /// Its inputs, and what each is until somebody says something else; none: it is left open.
    pub inputs: Vec<(String, Option<String>)>,
    pub outputs: Vec<String>,
    /// The input that the power, or the value before it, leads to.
    pub power: Option<String>,
    /// The output that goes on.
    pub goes_on: Option<String>,
    /// The input besides EN that the value before it leads to.
    pub takes: Option<String>,
    /// Whether its first output is a truth.
    pub gives_truth: bool,
    /// Whether it is called by an instance.
    pub is_instance: bool,
}

/// Blocks of the standard: names, inputs with their values, outputs, and whether each is called by an instance.
type Standard = (
    &'static [&'static str],
    &'static [(&'static str, &'static str)],
    &'static [&'static str],
    bool,
);

const STANDARD: [Standard; 12] = [
    (
        &["TON", "TOF", "TP"],
        &[("IN", "FALSE"), ("PT", "T#1s")],
        &["Q", "ET"],
        true,
    ),
    (
        &["CTU"],
        &[("CU", "FALSE"), ("R", "FALSE"), ("PV", "10")],
        &["Q", "CV"],
        true,
    ),
    (
        &["CTD"],
        &[("CD", "FALSE"), ("LD", "FALSE"), ("PV", "10")],
        &["Q", "CV"],
        true,
    ),
    (
        &["CTUD"],
        &[
            ("CU", "FALSE"),
            ("CD", "FALSE"),
            ("R", "FALSE"),
            ("LD", "FALSE"),
            ("PV", "10"),
        ],
        &["QU", "QD", "CV"],
        true,
    ),
    (&["SR"], &[("S1", "FALSE"), ("R", "FALSE")], &["Q1"], true),
    (&["RS"], &[("S", "FALSE"), ("R1", "FALSE")], &["Q1"], true),
    (&["R_TRIG", "F_TRIG"], &[("CLK", "FALSE")], &["Q"], true),
    (
        &["AND", "OR", "XOR"],
        &[("IN1", "FALSE"), ("IN2", "FALSE")],
        &["OUT"],
        false,
    ),
    (&["NOT"], &[("IN", "FALSE")], &["OUT"], false),
    (
        &["GT", "GE", "EQ", "NE", "LE", "LT"],
        &[("IN1", "0"), ("IN2", "0")],
        &["OUT"],
        false,
    ),
    (
        &["ADD", "SUB", "MUL", "DIV", "MOD"],
        &[("IN1", "0"), ("IN2", "0")],
        &["OUT"],
        false,
    ),
    (&["MOVE"], &[("IN", "0")], &["OUT"], false),
];

/// What a block of this type is drawn with, in a block diagram or in a ladder; none where nobody knows it.
pub(crate) fn signature(root: Node<'_, '_>, kind: &str, is_blocks: bool) -> Option<Signature> {
    let upper = kind.to_uppercase();
    let standard = STANDARD.iter().find(|(names, ..)| names.contains(&&*upper));
    let (inputs, outputs, is_instance, gives_truth) = match standard {
        Some((_, inputs, outputs, is_instance)) => {
            let inputs = inputs
                .iter()
                .map(|(name, value)| ((*name).to_owned(), Some((*value).to_owned())));
            let outputs = outputs.iter().map(|name| (*name).to_owned());
            let gives_truth = !matches!(&*upper, "ADD" | "SUB" | "MUL" | "DIV" | "MOD" | "MOVE");
            (
                inputs.collect::<Vec<_>>(),
                outputs.collect::<Vec<_>>(),
                *is_instance,
                gives_truth,
            )
        }
        None => of_unit(root, kind)?,
    };
    let is_truth = |(_, value): &&(String, Option<String>)| value.as_deref() == Some("FALSE");
    let power = inputs.iter().find(is_truth).map(|(name, _)| name.clone());
    let first = inputs.first().map(|(name, _)| name.clone());
    let mut signature = Signature {
        takes: power.clone().or(first),
        gives_truth,
        power,
        goes_on: outputs.first().cloned(),
        inputs,
        outputs,
        is_instance,
    };
    if is_blocks {
        signature.power.clone_from(&signature.takes);
    } else if signature.power.is_none() || !gives_truth {
        // Power passes by what takes or gives numbers alone.
        signature.inputs.insert(0, ("EN".to_owned(), None));
        signature.outputs.insert(0, "ENO".to_owned());
        signature.power = Some("EN".to_owned());
        let passes = !gives_truth;
        signature.goes_on = match passes {
            true => Some("ENO".to_owned()),
            false => signature.outputs.get(1).cloned(),
        };
    }
    Some(signature)
}

/// Whether a block of this type may have one more input than it has: `IN3`.
pub(super) fn takes_more(kind: &str) -> bool {
    let kind = kind.to_uppercase();
    ["AND", "OR", "XOR", "ADD", "MUL", "MAX", "MIN", "MUX"].contains(&&*kind)
        || ["GT", "GE", "EQ", "LE", "LT"].contains(&&*kind)
}

type Own = (Vec<(String, Option<String>)>, Vec<String>, bool, bool);

/// A function or a function block of the project.
fn of_unit(root: Node<'_, '_>, kind: &str) -> Option<Own> {
    let pou = within(root, "pou").find(|pou| is_named(*pou, kind))?;
    let is_instance = match pou.attribute("pouType")? {
        "functionBlock" => true,
        "function" => false,
        _ => return None,
    };
    let interface = first(pou, "interface")?;
    let variables = |section| {
        let own = all(interface, section).flat_map(|of| all(of, "variable"));
        own.filter_map(|of| Some((of.attribute("name")?.to_owned(), usual(of))))
            .collect::<Vec<_>>()
    };
    let inputs = variables("inputVars");
    let outputs = variables("outputVars");
    let first_of = |outputs: &[(String, Option<String>)]| {
        outputs
            .first()
            .is_some_and(|(_, value)| value.as_deref() == Some("FALSE"))
    };
    let mut gives_truth = first_of(&outputs);
    let mut names: Vec<String> = outputs.into_iter().map(|(name, _)| name).collect();
    if !is_instance {
        names.insert(0, "OUT".to_owned());
        gives_truth = first(interface, "returnType").is_some_and(|of| first(of, "BOOL").is_some());
    }
    Some((inputs, names, is_instance, gives_truth))
}

/// What a variable of this type is until somebody says something else.
fn usual(variable: Node<'_, '_>) -> Option<String> {
    let kind = first(variable, "type")?.children().find(Node::is_element)?;
    Some(match kind.tag_name().name() {
        "BOOL" => "FALSE".to_owned(),
        "TIME" => "T#1s".to_owned(),
        "REAL" | "LREAL" => "0.0".to_owned(),
        "derived" | "array" | "string" => return None,
        _ => "0".to_owned(),
    })
}
