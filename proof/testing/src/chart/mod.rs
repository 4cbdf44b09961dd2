//! Random charts, as text and as what the standard says of them.
//!
//! `sketch` makes one, `text` writes it in Structured Text, `naive` runs it: written from the standard alone, step by step,
//! without a thought for what it costs.

mod naive;
mod sketch;
mod text;

pub use naive::Naive;
pub use sketch::sketch;

/// What a transition waits for.
#[derive(Clone, Debug)]
pub enum Condition {
    /// An input, from 0, or its opposite.
    Input(usize, bool),
    /// Whether a step is active.
    Active(usize, bool),
    /// Whether the time of a step has come to so many ms.
    Time(usize, i64),
    /// Whether a body has counted so far.
    Count(usize, i64),
    /// Both.
    And(Box<Condition>, Box<Condition>),
    /// One of them.
    Or(Box<Condition>, Box<Condition>),
    /// Always.
    True,
}

/// A transition.
#[derive(Clone, Debug)]
pub struct Transition {
    /// The lowest goes first.
    pub priority: Option<u32>,
    /// What it leaves.
    pub from: Vec<usize>,
    /// What it enters.
    pub to: Vec<usize>,
    /// Its condition.
    pub condition: Condition,
}

/// What the body of an action does.
#[derive(Clone, Copy, Debug)]
pub enum Body {
    /// Counts how often it is done.
    Counts,
    /// Shows its Q.
    Shows,
    /// Counts how often its Q rises.
    Edge,
    /// Shows that its Q has been 1 for 30 ms.
    Timer,
    /// Changes the number that all of these share: the order matters.
    Shares,
    /// Copies an input.
    Copies(usize),
}

/// What a step does with an action: its number, its qualifier, its time in ms.
pub type Does = (usize, &'static str, i64);

/// A chart. Its actions are first the variables, then the bodies.
#[derive(Clone, Debug, Default)]
pub struct Chart {
    /// Which of its steps are initial.
    pub initial: Vec<usize>,
    /// What each step does.
    pub steps: Vec<Vec<Does>>,
    /// Its transitions, from left to right.
    pub transitions: Vec<Transition>,
    /// How many of its actions are BOOL variables.
    pub variables: usize,
    /// Those that are not.
    pub bodies: Vec<Body>,
}
