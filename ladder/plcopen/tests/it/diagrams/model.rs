//! A diagram as a test makes it.

/// So many inputs, outputs and variables of type BOOL.
pub(super) const BITS: usize = 4;

/// So many variables of type DINT; an output shows whether each is greater than 5.
pub(super) const NUMBERS: usize = 3;

/// What stands in a diagram. The place of an element among the others is its number in the file.
#[derive(Clone, Debug)]
pub(super) enum Kind {
    /// `i0`, `b1`, `n2`, `7`.
    Value(String),
    /// A variable that takes what leads to it.
    Variable(String),
    /// A function, or a function block with the name of its instance.
    Block(&'static str, Option<String>),
    Connector(usize),
    Continuation(usize),
}

#[derive(Clone, Debug)]
pub(super) struct Element {
    pub kind: Kind,
    pub negated: bool,
    pub order: u32,
    /// Down, and to the right.
    pub place: (i64, i64),
    pub pins: Vec<Pin>,
    /// Its outputs, whether each is a truth, and whether it is negated.
    pub outputs: Vec<(&'static str, bool, bool)>,
}

#[derive(Clone, Debug)]
pub(super) struct Pin {
    pub name: String,
    pub is_truth: bool,
    pub negated: bool,
    pub edge: &'static str,
    /// The element and which of its outputs.
    pub from: Option<(usize, usize)>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Diagram {
    pub elements: Vec<Element>,
}

/// The inputs of a block besides EN, and whether each is a truth.
pub(super) fn inputs(block: &str) -> &'static [(&'static str, bool)] {
    match block {
        "AND" | "OR" | "XOR" => &[("IN1", true), ("IN2", true)],
        "NOT" => &[("IN", true)],
        "ADD" | "SUB" | "GT" | "EQ" => &[("IN1", false), ("IN2", false)],
        "MOVE" => &[("IN", false)],
        "SEL" => &[("G", true), ("IN0", false), ("IN1", false)],
        "TON" => &[("IN", true), ("PT", false)],
        "CTU_DINT" => &[("CU", true), ("R", true), ("PV", false)],
        "SR" => &[("S1", true), ("R", true)],
        "RS" => &[("S", true), ("R1", true)],
        _ => &[("CLK", true)],
    }
}

/// The outputs of a block besides ENO, and whether each is a truth.
pub(super) fn outputs(block: &str) -> &'static [(&'static str, bool)] {
    match block {
        "AND" | "OR" | "XOR" | "NOT" | "GT" | "EQ" => &[("OUT", true)],
        "ADD" | "SUB" | "MOVE" | "SEL" => &[("OUT", false)],
        "CTU_DINT" => &[("Q", true), ("CV", false)],
        "SR" | "RS" => &[("Q1", true)],
        _ => &[("Q", true)],
    }
}

/// The blocks that are made, and whether each has an instance.
pub(super) const BLOCKS: [(&str, bool); 15] = [
    ("AND", false),
    ("OR", false),
    ("XOR", false),
    ("NOT", false),
    ("ADD", false),
    ("SUB", false),
    ("GT", false),
    ("EQ", false),
    ("MOVE", false),
    ("SEL", false),
    ("TON", true),
    ("CTU_DINT", true),
    ("SR", true),
    ("RS", true),
    ("R_TRIG", true),
];
