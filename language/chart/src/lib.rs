//! Charts: sequential function charts (IEC 61131-3, 2.6), known from paper as GRAFCET (IEC 60848).
//!
//! Owns what a chart is, what is wrong with one, and which statements of the typed tree do what it does. Must not know
//! how a chart is written or drawn, nor how a board does it.
//!
//! A [`Chart`] names its steps and actions. What a condition and the body of an action are is its maker's affair. The way
//! to statements:
//!
//! ```text
//! Chart ─Net::of─► Net ─look─► warnings
//!                   └─Cells::declare─► Cells ─lower─► statements
//! ```
//!
//! - `net`: names become numbers; `look`: which situations the chart can come to
//! - `cells`: what it keeps; `order`: which transition is judged when; `evolve`: from one situation to the next
//! - `control`: which action is done when; `actions`: what that takes; `touched`: which actions have to do with each other
//! - `write`: expressions and statements
//!
//! **How a chart goes on.** All transitions are judged on the steps as they were when the scan began. Each fires whose
//! steps are all active, whose condition holds, and whose steps none has left that goes before it. All that fire leave
//! and enter their steps at once; a step that is left and entered stays active, as if nothing had happened. Then actions
//! are done. An action whose last cause has gone is done once more, before all that go on.

#![forbid(unsafe_code)]

mod actions;
mod cells;
mod control;
mod evolve;
mod look;
mod lower;
mod net;
mod order;
mod touched;
mod write;

pub use cells::Cells;
pub use lower::{Parts, lower};
pub use net::Net;

use unoclp_text::diagnostics::Span;

/// A name as it is written, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// As it is written.
    pub text: String,
    /// Its place.
    pub at: Span,
}

/// A chart. A condition and a time are of type `C`, the body of an action is of type `A`.
#[derive(Clone, Debug)]
pub struct Chart<C, A> {
    /// Its steps.
    pub steps: Vec<Step<C>>,
    /// Its transitions, from left to right.
    pub transitions: Vec<Transition<C>>,
    /// Its actions; a BOOL variable is one without standing here.
    pub actions: Vec<Action<A>>,
    /// Where it stands.
    pub at: Span,
}

/// A step.
#[derive(Clone, Debug)]
pub struct Step<C> {
    /// Its name.
    pub name: Name,
    /// Whether it is active at first.
    pub initial: bool,
    /// What it does.
    pub does: Vec<Does<C>>,
}

/// What a step does: an action with its qualifier.
#[derive(Clone, Debug)]
pub struct Does<C> {
    /// The action, or a BOOL variable.
    pub action: Name,
    /// When it is done.
    pub qualifier: Qualifier,
    /// The time, a TIME, of those that take one.
    pub time: Option<C>,
}

/// When an action is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Qualifier {
    /// While the step is active.
    N,
    /// From now on, as far as a reset.
    S,
    /// Ends what is stored, and goes before all else.
    R,
    /// While the step is active, but no longer than the time.
    L,
    /// While the step is active, after the time.
    D,
    /// Once, where the step becomes active.
    P,
    /// Once, where the step is left.
    P0,
    /// Once, where the step becomes active; the action's Q is FALSE.
    P1,
    /// Stored, and done after the time, whether the step is active or not.
    SD,
    /// Stored if the step has been active for the time.
    DS,
    /// Stored, but no longer than the time.
    SL,
}

impl Qualifier {
    /// All of them, in the order of the standard's table.
    pub const ALL: [Qualifier; 11] = {
        use Qualifier::*;
        [N, R, S, L, D, P, SD, DS, SL, P1, P0]
    };

    /// As it is written.
    pub const fn name(self) -> &'static str {
        match self {
            Qualifier::N => "N",
            Qualifier::S => "S",
            Qualifier::R => "R",
            Qualifier::L => "L",
            Qualifier::D => "D",
            Qualifier::P => "P",
            Qualifier::P0 => "P0",
            Qualifier::P1 => "P1",
            Qualifier::SD => "SD",
            Qualifier::DS => "DS",
            Qualifier::SL => "SL",
        }
    }

    /// The one that is written so, in letters of any case.
    pub fn named(name: &str) -> Option<Qualifier> {
        let all = Qualifier::ALL.into_iter();
        all.into_iter()
            .find(|qualifier| qualifier.name().eq_ignore_ascii_case(name))
    }

    /// Whether it takes a time.
    pub const fn is_timed(self) -> bool {
        use Qualifier::*;
        matches!(self, L | D | SD | DS | SL)
    }
}

/// A transition.
#[derive(Clone, Debug)]
pub struct Transition<C> {
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// Of those that share a step, the one with the lowest number goes first; one without goes after them.
    pub priority: Option<u32>,
    /// The steps that it leaves.
    pub from: Vec<Name>,
    /// The steps that it enters.
    pub to: Vec<Name>,
    /// Its condition, a BOOL.
    pub condition: C,
    /// Where it stands.
    pub at: Span,
}

/// An action.
#[derive(Clone, Debug)]
pub struct Action<A> {
    /// Its name.
    pub name: Name,
    /// What it does.
    pub body: A,
}
