//! Sequential function charts as charts in text.
//!
//! Owns which steps each transition joins, and where its condition and the bodies of actions stand. Must not know what a
//! chart does, nor what a condition means.
//!
//! - `net`: steps, and the transitions between them; `branches`: the divergences and convergences on the way
//! - `conditions`: the condition of a transition; `wired`: one that contacts and blocks lead to; `bodies`: actions
//! - `written`: what has been written, and what is told
//!
//! What is wrong is told by the names of steps and transitions: a number of the file is nothing that a person sees.

mod bodies;
mod branches;
mod conditions;
mod net;
mod wired;
mod written;

use crate::found::{Found, span};
use crate::project::{Pou, Variable};
use crate::st::Units;
use crate::text::Text;
use bodies::Bodies;
use net::Net;
use roxmltree::Node;
use unoclp_lang::{Code, Word};
use written::Chart;

/// Writes the chart of a unit; what is wrong with it is told.
pub(crate) fn write<'a, 'x: 'a>(
    (xml, pou): (&str, &Pou<'a, 'x>),
    body: Node<'a, 'x>,
    globals: &[Variable],
    units: &Units<'_, 'a, 'x>,
    found: &mut Found,
) -> Chart {
    let mut chart = Chart::default();
    let net = Net::read(pou, body, found);
    if net.steps.is_empty() && !found.has_errors() {
        let what: Word = ("empty", "vazio").into();
        let help: Word = ("draw or write its body", "desenhe ou escreva o corpo dele").into();
        found.tell(
            Code::XmlBody,
            pou.node,
            [pou.name.clone().into(), what, help],
        );
        return chart;
    }
    let mut bodies = Bodies::new(xml, pou, &net, globals, units);
    let at = span(body);
    // What leads to conditions says which blocks are called.
    let mut transitions = Text::default();
    for transition in &net.transitions {
        net.transition(transition, &mut transitions);
        bodies.condition(transition, body, &mut transitions, found);
        transitions.piece("\nEND_TRANSITION\n", transition.at);
    }
    let caller = bodies.caller();
    for step in &net.steps {
        let word = if step.initial { "INITIAL_STEP" } else { "STEP" };
        chart.text.piece(&format!("{word} {}:", step.name), step.at);
        bodies.step(step, caller.as_deref(), &mut chart.text, found);
        chart.text.piece(" END_STEP\n", step.at);
    }
    chart.text.add(transitions);
    bodies.actions(caller.as_deref(), &mut chart, found);
    chart.text.piece("\n", at);
    chart
}
