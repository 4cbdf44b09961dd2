//! Every kind of part, by groups: the rows of the table, and what each does in a millisecond.

pub(crate) mod electric;
pub(crate) mod fluid;
pub(crate) mod heat;
pub(crate) mod motion;
pub(crate) mod panel;
pub(crate) mod traffic;
pub(crate) mod transport;

use crate::kind::Kind;
use crate::moment::Moment;

/// Every kind, by groups.
pub static KINDS: [&Kind; 43] = [
    &panel::button::KIND,
    &panel::switch::KIND,
    &panel::key::KIND,
    &panel::emergency::KIND,
    &panel::lamp::KIND,
    &panel::tower::KIND,
    &panel::buzzer::KIND,
    &panel::dial::KIND,
    &panel::bar::KIND,
    &panel::number::KIND,
    &electric::fuse::KIND,
    &electric::contactor::KIND,
    &electric::overload::KIND,
    &electric::motor::KIND,
    &fluid::tank::KIND,
    &fluid::valve::KIND,
    &fluid::pump::KIND,
    &fluid::stirrer::KIND,
    &fluid::float::KIND,
    &fluid::level::KIND,
    &heat::oven::KIND,
    &heat::heater::KIND,
    &heat::fan::KIND,
    &heat::thermometer::KIND,
    &motion::cylinder::KIND,
    &motion::gate::KIND,
    &motion::door::KIND,
    &motion::elevator::KIND,
    &motion::call::KIND,
    &transport::bin::KIND,
    &transport::belt::KIND,
    &transport::feeder::KIND,
    &transport::eye::KIND,
    &transport::inductive::KIND,
    &transport::height::KIND,
    &transport::pusher::KIND,
    &transport::filler::KIND,
    &transport::counter::KIND,
    &traffic::light::KIND,
    &traffic::road::KIND,
    &traffic::junction::KIND,
    &traffic::walk::KIND,
    &traffic::lane::KIND,
];

/// What each kind does in a millisecond, in the order of [`KINDS`].
static STEPS: [Step; 43] = [
    panel::button::step,
    panel::switch::step,
    panel::key::step,
    panel::emergency::step,
    panel::lamp::step,
    panel::tower::step,
    panel::buzzer::step,
    panel::dial::step,
    panel::bar::step,
    panel::number::step,
    electric::fuse::step,
    electric::contactor::step,
    electric::overload::step,
    electric::motor::step,
    fluid::tank::step,
    fluid::valve::step,
    fluid::pump::step,
    fluid::stirrer::step,
    fluid::float::step,
    fluid::level::step,
    heat::oven::step,
    heat::heater::step,
    heat::fan::step,
    heat::thermometer::step,
    motion::cylinder::step,
    motion::gate::step,
    motion::door::step,
    motion::elevator::step,
    motion::call::step,
    transport::bin::step,
    transport::belt::step,
    transport::feeder::step,
    transport::eye::step,
    transport::inductive::step,
    transport::height::step,
    transport::pusher::step,
    transport::filler::step,
    transport::counter::step,
    traffic::light::step,
    traffic::road::step,
    traffic::junction::step,
    traffic::walk::step,
    traffic::lane::step,
];

/// What a part does in a millisecond.
pub(crate) type Step = fn(&mut Moment<'_>);

/// What a part of this kind does in a millisecond.
pub(crate) fn step(kind: &Kind) -> Step {
    let own = KINDS.iter().position(|row| row.name == kind.name);
    own.and_then(|own| STEPS.get(own))
        .copied()
        .unwrap_or(|_| ())
}

/// The kind that a file names so.
pub(crate) fn named(name: &str) -> Option<&'static Kind> {
    KINDS.into_iter().find(|kind| kind.name == name)
}
