//! The compiler's functions of a unit in one row of instructions.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::decode::{Op, decode};
use super::oracle::Constants;
use crate::assembly::{Code, Line, Unit};
use crate::effects::is_timed;

/// Code that can be run.
pub struct Program {
    pub(super) steps: Vec<Step>,
    /// Where each function begins.
    functions: BTreeMap<String, usize>,
    /// Where each label stands that has one meaning in the whole unit.
    labels: BTreeMap<String, usize>,
}

/// A step of a [`Program`].
pub(super) struct Step {
    /// `None` after the last instruction of a function.
    pub op: Option<Op>,
    /// Where its label is, if it names one of the code.
    pub target: Option<usize>,
    /// Whether it stands in an `asm!` block.
    pub by_hand: bool,
    /// Whether it stands in one of the pass's own routines, which may look at saved registers.
    pub routine: bool,
    /// Whether it writes what must follow another such write within four cycles.
    pub timed: bool,
}

/// An instruction that the machine does not know.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// The function that it stands in.
    pub function: String,
    /// The instruction.
    pub code: Code,
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "in {}: unknown instruction `{}`",
            self.function, self.code
        )
    }
}

impl std::error::Error for Unknown {}

impl Program {
    /// Makes code that can be run of a unit's functions.
    ///
    /// # Errors
    /// If there is an instruction among them that the machine does not know.
    pub fn new(unit: &Unit) -> Result<Self, Unknown> {
        let mut program = Program {
            steps: Vec::new(),
            functions: BTreeMap::new(),
            labels: BTreeMap::new(),
        };
        let mut twice = BTreeSet::new();
        for function in unit.functions() {
            let begin = program.steps.len();
            program.functions.insert(function.name.clone(), begin);
            let mut own = BTreeMap::new();
            for line in &function.body {
                match line {
                    Line::Label(name) => {
                        own.insert(name.as_str(), program.steps.len());
                    }
                    Line::Code(code) | Line::Fixed(code) => {
                        let op = decode(code).ok_or_else(|| Unknown {
                            function: function.name.clone(),
                            code: code.clone(),
                        })?;
                        program.steps.push(Step {
                            op: Some(op),
                            target: None,
                            by_hand: matches!(line, Line::Fixed(_)),
                            routine: function.name.starts_with("__"),
                            timed: is_timed(code),
                        });
                    }
                    Line::Other(_) => {}
                }
            }
            program.steps.push(Step {
                op: None,
                target: None,
                by_hand: false,
                routine: false,
                timed: false,
            });
            for step in program.steps.iter_mut().skip(begin) {
                step.target = step.label().and_then(|label| own.get(label).copied());
            }
            for (label, at) in own {
                if program.labels.insert(label.to_owned(), at).is_some() {
                    twice.insert(label.to_owned());
                }
            }
        }
        // A label that two functions have is no way from one to the other.
        program.labels.retain(|label, _| !twice.contains(label));
        for n in 0..program.steps.len() {
            let Some(step) = program.steps.get(n) else {
                continue;
            };
            let elsewhere = |label: &str| {
                let function = program.functions.get(label);
                function.or_else(|| program.labels.get(label)).copied()
            };
            let target = step.target.or_else(|| step.label().and_then(elsewhere));
            if let Some(step) = program.steps.get_mut(n) {
                step.target = target;
            }
        }
        Ok(program)
    }

    /// How many steps there are.
    pub(crate) fn steps(&self) -> usize {
        self.steps.len()
    }

    /// Where a function begins.
    pub(crate) fn begin(&self, function: &str) -> Option<usize> {
        self.functions.get(function).copied()
    }

    /// The constants in the code of a function: values that a branch of it may ask for.
    pub(crate) fn constants(&self, function: &str) -> Constants {
        use super::decode::Value::{Constant, Register};
        let begin = self.begin(function).unwrap_or(self.steps.len());
        let steps = self.steps.iter().skip(begin);
        let mut found = Constants::default();
        // What each register was set to last; good enough for `ldi high; cpi low; cpc high`.
        let mut held = [0; 32];
        let mut low = 0;
        for op in steps.map_while(|step| step.op.as_ref()) {
            match *op {
                Op::Move {
                    to,
                    from: Constant(n),
                } => {
                    held[usize::from(to)] = n;
                    found.bytes.push(n);
                }
                Op::Subtract {
                    value: Constant(n), ..
                } => {
                    low = n;
                    found.bytes.push(n);
                }
                Op::Subtract {
                    value: Register(r),
                    carry: true,
                    ..
                } => found.words.push([low, held[usize::from(r)]]),
                Op::Logic {
                    value: Constant(n), ..
                } => found.bytes.push(n),
                _ => {}
            }
        }
        found.bytes.sort_unstable();
        found.bytes.dedup();
        found.words.sort_unstable();
        found.words.dedup();
        found
    }

    /// How many instructions a function has.
    pub(crate) fn length(&self, function: &str) -> usize {
        let begin = self.begin(function).unwrap_or(self.steps.len());
        let steps = self.steps.iter().skip(begin);
        steps.take_while(|step| step.op.is_some()).count()
    }
}

impl Step {
    /// The label that it names.
    pub fn label(&self) -> Option<&str> {
        match self.op.as_ref()? {
            Op::Jump(label) | Op::Call(label) | Op::Branch { target: label, .. } => Some(label),
            _ => None,
        }
    }
}
