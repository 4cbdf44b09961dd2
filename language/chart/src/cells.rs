//! What a chart keeps from one scan to the next, as variables of its unit.
//!
//! Owns that a step is a variable with X and T, an action one with Q, and that the chart alone changes them.

use crate::net::{Cause, Control, Net};
use crate::{Name, Qualifier};
use std::sync::Arc;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Builder, Named, Section, Traits, both};
use unoclp_tree::{
    Base, Initial, Kind, Member, Place, Root, Standard, StmtKind, Type, TypeId, Value,
};

/// T of a step, after X.
pub(crate) const TIME: u32 = 1;

/// Where a chart keeps what it keeps.
#[derive(Clone, Debug)]
pub struct Cells {
    /// Of each step.
    pub(crate) steps: Vec<Place>,
    /// The edges at which their time begins.
    pub(crate) rises: Vec<Place>,
    /// Of each action.
    pub(crate) actions: Vec<OfAction>,
    /// When the scan before began.
    pub(crate) before: Place,
    /// Whether there was one.
    pub(crate) begun: Place,
}

/// What an action keeps.
#[derive(Clone, Debug)]
pub(crate) struct OfAction {
    /// Its Q, or the variable.
    pub q: Place,
    /// That it is stored.
    pub stored: Place,
    /// The edge at which it is done once more.
    pub ends: Place,
    /// Of each cause.
    pub causes: Vec<OfCause>,
}

/// What a cause keeps, if it needs it.
#[derive(Clone, Debug)]
pub(crate) struct OfCause {
    /// That it is stored.
    pub stored: Place,
    /// Its timer, or its edge.
    pub block: Place,
}

impl Cells {
    /// Declares the variables of a chart in the unit that the builder is in; what is wrong is told.
    pub fn declare(net: &Net, builder: &mut Builder<'_, '_>) -> Cells {
        let begins = |is: bool| {
            let value = Arc::new(Initial::Value(Value::truth(is)));
            let members = Initial::Members(vec![(0, TypeId::BOOL, value)]);
            is.then(|| Arc::new(members))
        };
        let step = kind(builder, "STEP", &[("X", Base::Bool), ("T", Base::Time)]);
        let action = kind(builder, "ACTION", &[("Q", Base::Bool)]);
        let steps = net.steps.iter();
        let steps = steps.map(|node| named(builder, &node.name, step, begins(node.initial)));
        let steps = steps.collect();
        let edge = edge(builder, Standard::RTrig);
        let rises = (0..).zip(&net.steps);
        let rises = rises.map(|(number, node): (usize, _)| {
            own(builder, &format!("#rises{number}"), edge, node.name.at)
        });
        let rises = rises.collect();
        let actions = net.actions.iter();
        let actions = actions.map(|control| of_action(builder, control, action));
        Cells {
            steps,
            rises,
            actions: actions.collect(),
            before: own(builder, "#before", TypeId::of(Base::Time), Span::default()),
            begun: own(builder, "#begun", TypeId::BOOL, Span::default()),
        }
    }
}

/// A structure of the chart's own.
fn kind(builder: &mut Builder<'_, '_>, name: &str, parts: &[(&str, Base)]) -> TypeId {
    let member = |(offset, (name, base)): (u32, &(&str, Base))| Member {
        name: (*name).to_owned(),
        ty: TypeId::of(*base),
        offset,
        initial: None,
    };
    let members: Vec<Member> = (0..).zip(parts).map(member).collect();
    builder.tree.types.add(Type {
        name: Some(name.to_owned()),
        cells: members.len() as u32,
        kind: Arc::new(Kind::Struct(members)),
        initial: None,
        alias: None,
    })
}

/// A step or an action, which the text names.
fn named(
    builder: &mut Builder<'_, '_>,
    name: &Name,
    ty: TypeId,
    initial: Option<Arc<Initial>>,
) -> Place {
    let traits = Traits {
        initial,
        ..Traits::default()
    };
    let made = builder.declare(&name.text, name.at, ty, Section::Chart, traits);
    made.map_or_else(|| nowhere(name.at), |made| made.place(name.at))
}

/// An edge.
fn edge(builder: &mut Builder<'_, '_>, edge: Standard) -> TypeId {
    builder
        .tree
        .types
        .add_kind(Kind::Standard(edge), edge.cells())
}

/// Of what is wrong, which has been told.
fn nowhere(at: Span) -> Place {
    Place {
        root: Root::Static,
        offset: 0,
        indices: Vec::new(),
        at,
    }
}

/// A variable that the text cannot name.
fn own(builder: &mut Builder<'_, '_>, name: &str, ty: TypeId, at: Span) -> Place {
    let traits = Traits {
        unseen: true,
        ..Traits::default()
    };
    let made = builder.declare(name, at, ty, Section::Var, traits);
    made.map_or_else(|| nowhere(at), |made| made.place(at))
}

/// A bit that need not last, which the text cannot name.
pub(crate) fn passing(builder: &mut Builder<'_, '_>, name: &str, at: Span) -> Place {
    let traits = Traits {
        unseen: true,
        ..Traits::default()
    };
    let made = builder.declare(name, at, TypeId::BOOL, Section::Temp, traits);
    made.map_or_else(|| nowhere(at), |made| made.place(at))
}

fn of_action(builder: &mut Builder<'_, '_>, control: &Control, ty: TypeId) -> OfAction {
    let (name, at) = (&control.name.text, control.name.at);
    let q = match control.body {
        Some(_) => named(builder, &control.name, ty, None),
        None => variable(builder, &control.name).unwrap_or_else(|| nowhere(at)),
    };
    let edge = edge(builder, Standard::FTrig);
    let causes = control.does.iter().enumerate();
    OfAction {
        q,
        stored: own(builder, &format!("#{name}.S"), TypeId::BOOL, at),
        ends: own(builder, &format!("#{name}.A"), edge, at),
        causes: causes
            .map(|(number, cause)| of_cause(builder, name, number, *cause))
            .collect(),
    }
}

fn of_cause(builder: &mut Builder<'_, '_>, name: &str, number: usize, cause: Cause) -> OfCause {
    use Qualifier::*;
    let block = match cause.qualifier {
        L | D | SD | DS | SL => Some(Standard::Ton),
        P | P1 => Some(Standard::RTrig),
        P0 => Some(Standard::FTrig),
        N | S | R => None,
    };
    let at = cause.at;
    let block = match block {
        Some(block) => {
            let ty = Kind::Standard(block);
            let ty = builder.tree.types.add_kind(ty, block.cells());
            own(builder, &format!("#{name}.{number}"), ty, at)
        }
        None => nowhere(at),
    };
    let stored = match cause.qualifier {
        SD | DS | SL => own(builder, &format!("#{name}.{number}.S"), TypeId::BOOL, at),
        _ => nowhere(at),
    };
    OfCause { stored, block }
}

/// A BOOL variable that is an action.
fn variable(builder: &mut Builder<'_, '_>, name: &Name) -> Option<Place> {
    let is_bool = match builder.find(&name.text) {
        Some(Named::Variable(variable)) => builder.tree.types.base(variable.ty) == Some(Base::Bool),
        Some(_) => false,
        None => name.text.starts_with('%'),
    };
    if builder.is_hidden(&name.text) {
        return None;
    }
    if !is_bool {
        let help = both(
            format!(
                "write ACTION {0}: … END_ACTION, or declare it: VAR {0} : BOOL; END_VAR",
                name.text
            ),
            format!(
                "escreva ACTION {0}: … END_ACTION ou declare-a: VAR {0} : BOOL; END_VAR",
                name.text
            ),
        );
        let help = match builder.find(&name.text) {
            Some(_) => help,
            None => builder.near(&name.text, help),
        };
        builder.tell(Code::StNoAction, name.at, [name.text.as_str().into(), help]);
        return None;
    }
    let target = builder.name(&name.text, name.at)?;
    let value = builder.literal(Base::Bool, Value::truth(true), name.at);
    match builder.assign(target, value, name.at)?.kind {
        StmtKind::Assign(place, ..) => Some(place),
        _ => None,
    }
}
