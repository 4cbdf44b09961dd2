//! Elements: the symbols on the wires of a rung.

use crate::pins::Pins;
use crate::power::{Net, Nets};
use unoclp_point::Address;

/// A symbol on a wire.
#[derive(Clone, Debug)]
pub struct Element {
    /// The steps that it shows: the indices of instructions in the program. None for the coil of a timer,
    /// which belongs to the timer's step.
    pub steps: Vec<usize>,
    /// What is drawn.
    pub symbol: Symbol,
    /// The point whose name stands above it.
    pub point: Option<Address>,
    /// Its pins, where it is drawn as a box that has some.
    pub(crate) pins: Option<Pins>,
    /// How it may be arranged.
    pub(crate) role: Role,
    /// The net after it.
    pub(crate) net: Net,
    /// The step after which acc tells whether it conducts.
    pub(crate) conducts: usize,
}

/// What is drawn for an element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// A contact: `┤ I1 ├`, or `┤/I1 ├` where it is normally closed.
    Contact {
        /// Whether it is normally closed.
        closed: bool,
        /// What it reads.
        text: String,
    },
    /// An element that acts on all that stands before it: `┤P├`, `┤N├`, `┤NOT├`.
    Inline(&'static str),
    /// A coil: `( Q1 )`, `(S Q1)`.
    Coil {
        /// What kind: a blank, `/`, `S`, `R` or, of a counter that is loaded with its preset, `L`.
        letter: char,
        /// What it writes.
        text: String,
    },
    /// A box: `[ TON T1 5000 ms ]`.
    Box {
        /// What it does.
        text: String,
        /// Lines below it.
        notes: Vec<String>,
    },
    /// A jump or return: `>> L1`, `<RET>`; with `/` where it takes place at 0.
    Leave {
        /// Whether at 0.
        inverted: bool,
        /// The arrow.
        text: String,
    },
}

/// How an element may be arranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// It conducts or does not, whatever stands before it.
    Condition,
    /// It makes a result of what stands before it.
    Logic,
    /// It does something, depending on what stands before it.
    Function,
    /// It looks at what stands before it, and passes it on: what follows may stand on a branch of its own.
    Output,
}

impl Element {
    pub(crate) fn new(step: usize, role: Role, symbol: Symbol, point: Option<Address>) -> Element {
        Element {
            steps: vec![step],
            symbol,
            point,
            pins: None,
            role,
            net: Nets::RAIL,
            conducts: step,
        }
    }

    pub(crate) fn coil(step: usize, letter: char, point: Address) -> Element {
        let text = point.to_string();
        Element::new(
            step,
            Role::Output,
            Symbol::Coil { letter, text },
            Some(point),
        )
    }

    pub(crate) fn boxed(step: usize, role: Role, text: String, point: Option<Address>) -> Element {
        let notes = Vec::new();
        Element::new(step, role, Symbol::Box { text, notes }, point)
    }

    /// Whether it is an output that what follows may leave on a branch.
    pub(crate) fn is_output(&self) -> bool {
        self.role == Role::Output
    }

    /// Whether it may stand at the right rail.
    pub(crate) fn ends_a_rung(&self) -> bool {
        matches!(self.role, Role::Function | Role::Output)
    }
}
