//! What a person does to a chart, and why nothing is done.

use crate::sheet::Id;
use unoclp_chart::Qualifier;

/// What a person does to a chart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Operation {
    /// A new step after a step, or after a transition.
    StepAfter(Id),
    /// A new step before a step.
    StepBefore(Id),
    /// Another way from the step, or beside the transition: a selection.
    Branch(Id),
    /// A step beside the step, active together with it: a simultaneous sequence.
    Beside(Id),
    /// A new transition from the step to the step of this name.
    Jump(Id, String),
    /// Something more that the step does.
    Act(Id),
    /// Away with it, and with what only it leads to.
    Remove(Id),
    /// The transition goes before the one on its left, or after the one on its right.
    Move(Id, Side),
    /// A step, or the action that it does, gets another name, wherever that stands.
    Rename(Id, String),
    /// The transition waits for this.
    Condition(Id, String),
    /// The transition, or the jump, leads to this step.
    Lead(Id, String),
    /// The transition has this priority, or none.
    Priority(Id, Option<u32>),
    /// The step is the one that is active at first.
    Initial(Id),
    /// The step does this then.
    Does(Id, String, Qualifier, Option<String>),
    /// The action of this name does this.
    Body(String, String),
}

/// A direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// To the left.
    Left,
    /// To the right.
    Right,
}

/// Why nothing is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Refusal {
    /// What it names is not in the chart.
    NotThere,
    /// A step has to be selected.
    SelectStep,
    /// A transition has to be selected.
    SelectTransition,
    /// A chart has one step at least.
    LastStep,
    /// That is no name.
    NoName,
    /// Something else has that name.
    NameTaken,
    /// There is nothing on that side.
    NoFurther,
    /// A condition, or a time, is missing.
    Missing,
    /// This would not be one part of a chart any longer: it holds words that end one.
    NotOnePart,
}

impl Refusal {
    /// All of them.
    pub const ALL: [Refusal; 9] = {
        use Refusal::*;
        [
            NotThere,
            SelectStep,
            SelectTransition,
            LastStep,
            NoName,
            NameTaken,
            NoFurther,
            Missing,
            NotOnePart,
        ]
    };
}
