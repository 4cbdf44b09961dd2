//! Every kind of part, by groups: the rows of the table, and what each does in a millisecond.

pub(crate) mod electric;
pub(crate) mod fluid;
pub(crate) mod heat;
pub(crate) mod motion;
pub(crate) mod panel;
pub(crate) mod traffic;
pub(crate) mod transport;

use crate::kind::Kind;

/// Every kind, by groups.
pub static KINDS: [&Kind; 42] = [
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
    &traffic::walk::KIND,
    &traffic::lane::KIND,
];

/// The kind that a file names so.
pub(crate) fn named(name: &str) -> Option<&'static Kind> {
    KINDS.into_iter().find(|kind| kind.name == name)
}
